/* Which way loops run, told by their areas on planes and in parameters. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", flat[] = "00010500", root[] = "00000000";

/* A row of points as a closed polyline, 106 form 12. */
static int add_row(iges_text *file, const char *status, int count, const double (*points)[2],
                   bool clockwise)
{
    char text[300];
    snprintf(text, sizeof text, "106,1,%d,0.", count + 1);
    for (int i = 0; i <= count; i++) {
        const double *p = points[(clockwise ? count - i : i) % count];
        snprintf(text + strlen(text), 50, ",%.17g,%.17g", p[0], p[1]);
    }
    return iges_add(file, 106, 12, 0, 0, status, strcat(text, ";"));
}

/* 60 x 9, and so are its parameters. */
#define WIDE                                                                                   \
    "128,1,1,1,1,0,0,1,0,0,0.,0.,60.,60.,0.,0.,9.,9.,1.,1.,1.,1.,0.,0.,0.,60.,0.,0.,0.,9.,0.," \
    "60.,9.,0.,0.,60.,0.,9.;"

/* A triangle far from the origin, begun at each corner, on a plane or in (u, v): the area of its
 * corners says which way it runs wherever it lies. */
TEST(a_loop_is_turned_when_its_area_is_negative_wherever_it_lies)
{
    static const double corners[5][2] = {{50, 3}, {53, 4}, {51, 7}, {50, 3}, {53, 4}};
    for (int k = 0; k < 12; k++) {
        const bool clockwise = k & 1, in_plane = k >> 1 & 1;
        iges_text file = iges_begin();
        char text[80];
        const int surface = in_plane
                                ? iges_add(&file, 128, 0, 0, 0, part, WIDE)
                                : iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,1.,0.,0;");
        const int space = add_row(&file, part, 3, corners + k / 4, clockwise);
        const int plane = in_plane ? add_row(&file, flat, 3, corners + k / 4, clockwise) : 0;
        snprintf(text, sizeof text, "142,0,%d,%d,%d,2;", surface, plane, space);
        const int boundary = iges_add(&file, 142, 0, 0, 0, part, text);
        snprintf(text, sizeof text, "144,%d,1,0,%d;", surface, boundary);
        iges_add(&file, 144, 0, 0, 0, root, text);
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                        clockwise ? "1 loop of faces runs the wrong way around; turned" : "");
        CHECK_INT(batten_model_count(model), 1);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->uses[0].reversed, clockwise);
        CHECK_INT(iges_check_plane_curves(model), in_plane);
        iges_check_area(model, 5.5);
        batten_model_unref(model);
    }
}

/* Three holes in the border of the surface: each runs clockwise, and one that does not is turned
 * with its sides in the other order. */
TEST(holes_run_clockwise_and_each_that_does_not_is_turned)
{
    for (int k = 0; k < 8; k++) {
        iges_text file = iges_begin();
        char text[80];
        int holes[3], wrong = 0;
        const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        for (int i = 0; i < 3; i++) {
            const bool clockwise = !(k >> i & 1);
            holes[i] =
                iges_add_boundary(&file, surface, 0.25 + i, 1 + i, true, true, clockwise);
            wrong += !clockwise;
        }
        snprintf(text, sizeof text, "144,%d,0,3,0,%d,%d,%d;", surface, holes[0], holes[1],
                 holes[2]);
        iges_add(&file, 144, 0, 0, 0, root, text);
        char words[60] = "";
        if (wrong)
            snprintf(words, sizeof words, "%d loop%s of faces run%s the wrong way around",
                     wrong, wrong > 1 ? "s" : "", wrong > 1 ? "" : "s");
        batten_model *model = iges_body(&file, words);
        CHECK_INT(iges_check_plane_curves(model), 16); /* with the border */
        iges_check_area(model, 16 - 3 * 0.75 * 0.75);
        batten_model_unref(model);
    }
}

/* Sides of a triangle in any direction, the first as well: each is turned until it begins where
 * the one before ends. */
TEST(sides_are_turned_to_run_head_to_tail)
{
    static const double corners[4][2] = {{1, 1}, {3, 1.5}, {2, 3}, {1, 1}};
    for (int k = 0; k < 8; k++) {
        iges_text file = iges_begin();
        char text[80];
        int ids[3];
        iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,1.,0.,0,0.,0.,0.,0.;");
        for (int i = 0; i < 3; i++) {
            const double *a = corners[i + (k >> i & 1)], *b = corners[i + !(k >> i & 1)];
            snprintf(text, sizeof text, "110,%g,%g,0.,%g,%g,0.;", a[0], a[1], b[0], b[1]);
            ids[i] = iges_add(&file, 110, 0, 0, 0, part, text);
        }
        snprintf(text, sizeof text, "102,3,%d,%d,%d;", ids[0], ids[1], ids[2]);
        const int loop = iges_add(&file, 102, 0, 0, 0, part, text);
        snprintf(text, sizeof text, "142,0,1,0,%d,2;", loop);
        const int boundary = iges_add(&file, 142, 0, 0, 0, part, text);
        snprintf(text, sizeof text, "144,1,1,0,%d;", boundary);
        iges_add(&file, 144, 0, 0, 0, root, text);
        batten_model *model = iges_body(&file, "");
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        for (int i = 0; i < 3; i++)
            CHECK_INT(p->uses[i].reversed, k >> i & 1);
        CHECK_INT(p->vertex_count, 3);
        iges_check_area(model, 1.75);
        batten_model_unref(model);
    }
}
