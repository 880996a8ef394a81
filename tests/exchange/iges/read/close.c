/* Loops that lack their part along a border: each border, in both directions. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";

/* Three sides of a bay of 1 x 2 that opens on the border v = 0, u = 4, v = 4 or u = 0, that is the
 * first turned by quarters about (2, 2). */
static const double bay[4][2] = {{1, 0}, {1, 1}, {3, 1}, {3, 0}};

static void turn_by_quarters(const double p[2], int quarters, double q[2])
{
    q[0] = p[0];
    q[1] = p[1];
    for (int k = 0; k < quarters; k++) {
        const double x = q[0];
        q[0] = 4 - q[1];
        q[1] = x;
    }
}

TEST(a_loop_is_closed_along_each_border_in_both_directions)
{
    for (int k = 0; k < 8; k++) {
        iges_text file = iges_begin();
        char text[100];
        int ids[3];
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        for (int i = 0; i < 3; i++) {
            double a[2], b[2];
            turn_by_quarters(bay[k & 1 ? 3 - i : i], k >> 1, a);
            turn_by_quarters(bay[k & 1 ? 2 - i : i + 1], k >> 1, b);
            snprintf(text, sizeof text, "110,%g,%g,0.,%g,%g,0.;", a[0], a[1], b[0], b[1]);
            ids[i] = iges_add(&file, 110, 0, 0, 0, part, text);
        }
        snprintf(text, sizeof text, "102,3,%d,%d,%d;", ids[0], ids[1], ids[2]);
        iges_add(&file, 102, 0, 0, 0, part, text);
        iges_add(&file, 142, 0, 0, 0, part, "142,0,1,0,9,2;");
        iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,11;");
        batten_model *model =
            iges_body(&file, "a loop ends 2 from where it begins; closed along "
                             "the border of its surface");
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->edge_count, 4);
        CHECK_INT(p->vertex_count, 4);
        iges_check_area(model, 2);
        batten_model_unref(model);
    }
}

/* A loop that goes from one border to another has no border that both its ends are on. */
TEST(a_loop_from_one_border_to_another_is_left_out)
{
    iges_text file = iges_begin();
    iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,0.,1.,0.;");
    iges_add(&file, 142, 0, 0, 0, part, "142,0,1,0,3,2;");
    iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,5;");
    iges_check_left_out(&file, "a loop ends 1.41421 from where it begins; left out");
}

/* A loop that starts in one corner and ends in the next lies on one border with both; at the same
 * gap in the middle of the surface it is open. */
TEST(a_loop_is_closed_from_corner_to_corner)
{
    iges_text file = iges_begin();
    iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    iges_add(&file, 110, 0, 0, 0, part, "110,4.,0.,0.,2.,2.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,2.,2.,0.,0.,0.,0.;");
    iges_add(&file, 102, 0, 0, 0, part, "102,2,3,5;");
    iges_add(&file, 142, 0, 0, 0, part, "142,0,1,0,7,2;");
    iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,9;");
    batten_model *model = iges_body(&file, "a loop ends 4 from where it begins; closed along");
    iges_check_area(model, 4);
    batten_model_unref(model);
}
