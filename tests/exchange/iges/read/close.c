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

/* A square with a loop of the lines from each corner to the next, which is all of its boundary. */
static iges_text square_with(int count, const double (*corners)[2])
{
    iges_text file = iges_begin();
    char text[100], loop[100];
    const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    int length = snprintf(loop, sizeof loop, "102,%d", count - 1);
    for (int i = 0; i + 1 < count; i++) {
        snprintf(text, sizeof text, "110,%g,%g,0.,%g,%g,0.;", corners[i][0], corners[i][1],
                 corners[i + 1][0], corners[i + 1][1]);
        length += snprintf(loop + length, sizeof loop - (size_t)length, ",%d",
                           iges_add(&file, 110, 0, 0, 0, part, text));
    }
    strcat(loop, ";");
    const int lines = iges_add(&file, 102, 0, 0, 0, part, loop);
    snprintf(text, sizeof text, "142,0,%d,0,%d,2;", surface, lines);
    const int boundary = iges_add(&file, 142, 0, 0, 0, part, text);
    snprintf(text, sizeof text, "144,%d,1,0,%d;", surface, boundary);
    iges_add(&file, 144, 0, 0, 0, root, text);
    return file;
}

TEST(a_loop_is_closed_along_each_border_in_both_directions)
{
    for (int k = 0; k < 8; k++) {
        double corners[4][2];
        for (int i = 0; i < 4; i++)
            turn_by_quarters(bay[k & 1 ? 3 - i : i], k >> 1, corners[i]);
        iges_text file = square_with(4, (const double(*)[2])corners);
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

/* The same bay in the middle of the square. */
TEST(a_loop_that_lacks_its_part_inside_is_left_out)
{
    static const double inner[4][2] = {{3, 1}, {2, 1}, {2, 3}, {3, 3}};
    iges_text file = square_with(4, inner);
    iges_check_left_out(&file, "a loop ends 2 from where it begins; left out");
}

/* A loop that goes from one border to another has no border that both its ends are on. */
TEST(a_loop_from_one_border_to_another_is_left_out)
{
    static const double slant[2][2] = {{1, 0}, {0, 1}};
    iges_text file = square_with(2, slant);
    iges_check_left_out(&file, "a loop ends 1.41421 from where it begins; left out");
}

/* A loop that starts in one corner and ends in the next lies on one border with both; at the same
 * gap in the middle of the surface it is open. */
TEST(a_loop_is_closed_from_corner_to_corner)
{
    static const double corner[3][2] = {{4, 0}, {2, 2}, {0, 0}};
    iges_text file = square_with(3, corner);
    batten_model *model = iges_body(&file, "a loop ends 4 from where it begins; closed along");
    iges_check_area(model, 4);
    batten_model_unref(model);
}
