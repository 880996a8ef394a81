/* Loops as edges: parts that are points, ends that miss each other. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", flat[] = "00010500", root[] = "00000000";

/* The loop that is a point is counted among those of the face: the outer one, or the second hole. */
TEST(a_loop_that_is_a_point_is_named_by_its_number)
{
    for (int k = 1; k <= 3; k++) {
        iges_text file = iges_begin();
        char text[80], words[60];
        int loops[3];
        const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        for (int i = 0; i < 3; i++) {
            if (i + 1 != k) {
                loops[i] =
                    iges_add_boundary(&file, surface, i, i ? i + 0.5 : 4, false, true, i > 0);
                continue;
            }
            const int point =
                iges_add(&file, 110, 0, 0, 0, part, "110,1.,1.,0.,1.,1.0000001,0.;");
            snprintf(text, sizeof text, "142,0,%d,0,%d,2;", surface, point);
            loops[i] = iges_add(&file, 142, 0, 0, 0, part, text);
        }
        snprintf(text, sizeof text, "144,%d,1,2,%d,%d,%d;", surface, loops[0], loops[1],
                 loops[2]);
        iges_add(&file, 144, 0, 0, 0, root, text);
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        snprintf(words, sizeof words, "loop %d is a point; left out", k);
        iges_check_partly(&file, words);
    }
}

/* A square of which a side ends before the next begins: by a rounding, by what is put together
 * halfway and said, and by too much. The tolerance is 1e-6, a thousandth of its size 5.7e-3. */
static const struct {
    double gap;
    const char *note;
} gaps[] = {
    {5e-7, ""},
    {0.001,
     "edges of faces that start away from the end of the one before, by 0.001 at most: 1; put "
     "together halfway"},
    {0.005, "by 0.005 at most: 1; put together halfway"},
};

static iges_text with_gap(double gap)
{
    static const double corners[5][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}};
    iges_text file = iges_begin();
    char text[100];
    iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    for (int i = 0; i < 4; i++) {
        snprintf(text, sizeof text, "110,%.17g,%g,0.,%g,%g,0.;", corners[i][0] - (i == 2) * gap,
                 corners[i][1], corners[i + 1][0], corners[i + 1][1]);
        iges_add(&file, 110, 0, 0, 0, part, text);
    }
    iges_add(&file, 102, 0, 0, 0, part, "102,4,3,5,7,9;");
    iges_add(&file, 142, 0, 0, 0, part, "142,0,1,0,11,2;");
    iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,13;");
    return file;
}

TEST(ends_that_miss_each_other_are_put_together_halfway_or_refused)
{
    for (int i = 0; i < COUNT(gaps); i++) {
        iges_text file = with_gap(gaps[i].gap);
        batten_model *model = iges_body(&file, gaps[i].note);
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->vertex_count, 4);
        CHECK_NEAR(p->vertices[6], 4 - gaps[i].gap / 2, 1e-15);
        CHECK_BITS(p->vertices[7], 4.0);
        batten_model_unref(model);
    }
    iges_text file = with_gap(0.01);
    iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
    iges_check_partly(&file, "part 3 of a loop begins 0.01 from the end of the one before");
}

/* Curves in (u, v) stand in their own plane: a matrix of theirs moves nothing. */
TEST(curves_in_the_plane_are_not_moved)
{
    for (int k = 0; k < 2; k++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,3.,2.,3.,2.;");
        iges_add(&file, 100, 0, k ? 0 : 11, 0, flat, "100,0.,2.,2.,3.,2.,3.,2.;");
        iges_add(&file, 102, 0, k ? 11 : 0, 0, flat, "102,1,5;");
        iges_add(&file, 142, 0, 0, 0, part, "142,0,1,7,3,2;");
        iges_add(&file, 124, 0, 0, 0, part, "124,0.,-1.,0.,1.,1.,0.,0.,7.,0.,0.,1.,0.;");
        iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,9;");
        batten_model *model = iges_body(&file, "");
        CHECK_INT(iges_check_plane_curves(model), 1);
        iges_check_area(model, acos(-1));
        batten_model_unref(model);
    }
}
