/* The sides of loops: in space and on the surface, together or alone. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", flat[] = "00010500", root[] = "00000000";

/* The (u, v) of a square that is not as far across as it is wide, z = u v / 4. */
#define TWISTED                                                                                \
    "128,1,1,1,1,0,0,1,0,0,0.,0.,2.,2.,0.,0.,4.,4.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,0.,4.,0.,4.," \
    "4.,0.,0.,2.,0.,4.;"

/* A triangle whose curves in (u, v) run with those in space or against them, which nothing says. */
TEST(curves_in_the_plane_run_as_those_in_space_whatever_the_file_has)
{
    static const double corners[4][2] = {{1, 1}, {3, 1}, {1, 3}, {1, 1}};
    for (int k = 0; k < 8; k++) {
        iges_text file = iges_begin();
        char text[200] = "141,1,0,1,3";
        iges_add(&file, 128, 0, 0, 0, part, TWISTED);
        for (int i = 0; i < 3; i++) {
            const double *a = corners[i], *b = corners[i + 1];
            const double *c = corners[i + (k >> i & 1)], *d = corners[i + !(k >> i & 1)];
            char line[100];
            snprintf(line, sizeof line, "110,%g,%g,0.,%g,%g,0.;", a[0], a[1], b[0], b[1]);
            const int space = iges_add(&file, 110, 0, 0, 0, part, line);
            snprintf(line, sizeof line, "110,%g,%g,0.,%g,%g,0.;", c[0] / 2, c[1], d[0] / 2,
                     d[1]);
            const int plane = iges_add(&file, 110, 0, 0, 0, flat, line);
            snprintf(text + strlen(text), 40, ",%d,1,1,%d", space, plane);
        }
        const int boundary = iges_add(&file, 141, 0, 0, 0, part, strcat(text, ";"));
        snprintf(text, sizeof text, "143,1,1,1,%d;", boundary);
        iges_add(&file, 143, 0, 0, 0, root, text);
        batten_model *model = iges_body(&file, "");
        CHECK_INT(iges_check_plane_curves(model), 3);
        iges_check_area(model, 2);
        batten_model_unref(model);
    }
}

/* A circle against the clock or with it, and the sense that 141 gives: both together say which way
 * it runs. */
TEST(the_sense_of_a_closed_curve_counts)
{
    for (int k = 0; k < 4; k++) {
        const bool clockwise = k & 1, against = k >> 1;
        iges_text file = iges_begin();
        iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,1.,0.,0,0.,0.,0.,0.;");
        iges_add(&file, 100, 0, clockwise ? 9 : 0, 0, part, "100,0.,2.,0.,3.,0.,3.,0.;");
        iges_add(&file, 141, 0, 0, 0, part,
                 against ? "141,0,0,1,1,3,2,0;" : "141,0,0,1,1,3,1,0;");
        iges_add(&file, 143, 0, 0, 0, root, "143,0,1,1,5;");
        iges_add(&file, 124, 0, 0, 0, part, "124,1.,0.,0.,0.,0.,-1.,0.,0.,0.,0.,-1.,0.;");
        batten_model *model =
            iges_body(&file, clockwise != against ? "1 loop of faces runs the wrong way" : "");
        iges_check_area(model, acos(-1));
        batten_model_unref(model);
    }
}

/* An edge that has several curves in (u, v), or none, is found again when it is needed. */
TEST(one_curve_in_the_plane_is_kept_and_several_for_one_edge_are_not)
{
    static const char *const counts[] = {"141,1,0,1,1,3,1,0;", "141,1,0,1,1,3,1,1,5;",
                                         "141,1,0,1,1,3,1,2,7,9;"};
    for (int k = 0; k < 3; k++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,3.,2.,3.,2.;"); /* 3 */
        iges_add(&file, 100, 0, 0, 0, flat, "100,0.,2.,2.,3.,2.,3.,2.;"); /* 5 */
        iges_add(&file, 100, 0, 0, 0, flat, "100,0.,2.,2.,3.,2.,1.,2.;"); /* 7 */
        iges_add(&file, 100, 0, 0, 0, flat, "100,0.,2.,2.,1.,2.,3.,2.;"); /* 9 */
        iges_add(&file, 141, 0, 0, 0, part, counts[k]);
        iges_add(&file, 143, 0, 0, 0, root, "143,1,1,1,11;");
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->use_count, 1);
        CHECK_INT(iges_check_plane_curves(model), k == 1);
        iges_check_area(model, acos(-1));
        batten_model_unref(model);
    }
}

TEST(a_curve_in_the_plane_alone_needs_a_surface_whose_parameters_are_known)
{
    static const struct {
        const char *surface;
        int type;
    } cases[] = {{"122,3,0.,0.,1.;", 122}, {"120,5,3,0.,1.;", 120}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, cases[i].type, 0, 0, 0, part, cases[i].surface);
        iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,1.,0.,1.;");
        iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,0.,0.,1.;");
        iges_add(&file, 100, 0, 0, 0, flat, "100,0.,.5,.5,.75,.5,.75,.5;");
        iges_add(&file, 142, 0, 0, 0, part, "142,0,1,7,0,1;");
        iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,9;");
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        iges_check_partly(&file, "an edge has a curve in (u, v) alone, on a surface whose "
                                 "parameters differ between programs");
    }
}
