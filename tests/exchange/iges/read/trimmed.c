/* Trimmed surfaces: loops, both families of curves, orders and directions. */
#include "exchange/iges/read/loops.h"

#include "exchange/iges/faces.h"

static const char part[] = "00010000", flat[] = "00010500", root[] = "00000000";

TEST(a_trimmed_surface_keeps_both_families_of_curves_and_a_hole)
{
    /* Space and plane; plane only, lifted; space only, without parameters. */
    for (int k = 0; k < 3; k++) {
        iges_text file = iges_begin();
        char text[80];
        const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        const int outer = iges_add_boundary(&file, surface, 0, 4, k < 2, k != 1, false);
        const int hole = iges_add_boundary(&file, surface, 1, 3, k < 2, k != 1, true);
        snprintf(text, sizeof text, "144,%d,1,1,%d,%d;", surface, outer, hole);
        iges_add(&file, 144, 0, 0, 3, root, text);
        batten_model *model = iges_body(&file, "");
        const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
        CHECK_INT(p->face_count, 1);
        CHECK_INT(p->loop_count, 2);
        CHECK_INT(p->edge_count, 8);
        CHECK_INT(p->vertex_count, 8);
        CHECK((p->uses[0].parameters != NULL) == (k < 2));
        CHECK(!p->is_solid);
        CHECK(batten_model_object(model, 0)->has_colour);
        iges_check_area(model, 12);
        batten_model_unref(model);
    }
}

/* The resolution, and the tolerance that a face of size 4 sqrt(2) gets. */
static const struct {
    const char *stated;
    double least, most;
} resolutions[] = {
    {"0.9", 5e-6, 6e-6},  {"1E99", 5e-6, 6e-6}, {"0.", 5e-6, 1.3e-5},
    {"1E-4", 1e-4, 1e-4}, {"1E-6", 1e-6, 1e-6}, {"1E-300", 4e-9, 1e-8},
};

TEST(a_resolution_that_makes_no_sense_at_the_size_is_not_believed)
{
    for (int k = 0; k < COUNT(resolutions); k++) {
        iges_text file = iges_begin();
        char text[80], global[300];
        const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        const int outer = iges_add_boundary(&file, surface, 0, 4, true, true, false);
        const int hole = iges_add_boundary(&file, surface, 1, 3, true, true, true);
        snprintf(text, sizeof text, "144,%d,1,1,%d,%d;", surface, outer, hole);
        iges_add(&file, 144, 0, 0, 3, root, text);
        snprintf(
            global, sizeof global,
            "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,6,1HM,1,0.,13H260101.000000,%s,,"
            ",,11,0,;",
            resolutions[k].stated);
        batten_model *model = read_noting(iges_end(&file, global), BATTEN_FORMAT_AUTO, "");
        const double tolerance =
            batten_body_view(batten_model_object(model, 0)->body)->tolerance;
        CHECK(tolerance >= resolutions[k].least * (1 - 1e-12));
        CHECK(tolerance <= resolutions[k].most * (1 + 1e-12));
        iges_check_area(model, 12);
        batten_model_unref(model);
    }
}

TEST(without_an_outer_boundary_the_border_of_the_surface_is_it)
{
    iges_text file = iges_begin();
    char text[80];
    const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    const int hole = iges_add_boundary(&file, surface, 1, 3, true, true, true);
    snprintf(text, sizeof text, "144,%d,0,1,0,%d;", surface, hole);
    iges_add(&file, 144, 0, 0, 0, root, text);
    batten_model *model = iges_body(&file, "");
    iges_check_area(model, 12);
    batten_model_unref(model);
    iges_text whole = iges_begin();
    iges_add(&whole, 128, 0, 0, 0, part, IGES_SQUARE);
    iges_add(&whole, 144, 0, 0, 0, root, "144,1,0,0,;");
    model = iges_body(&whole, "");
    CHECK_INT(batten_body_view(batten_model_object(model, 0)->body)->loop_count, 0);
    iges_check_area(model, 16);
    batten_model_unref(model);
}

TEST(loops_in_the_wrong_order_or_direction_are_put_right_with_a_note)
{
    for (int k = 0; k < 2; k++) {
        iges_text file = iges_begin();
        char text[80];
        const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        const int outer = iges_add_boundary(&file, surface, 0, 4, true, true, k == 0);
        const int hole = iges_add_boundary(&file, surface, 1, 3, true, true, true);
        snprintf(text, sizeof text, "144,%d,1,1,%d,%d;", surface, k ? hole : outer,
                 k ? outer : hole);
        iges_add(&file, 144, 0, 0, 0, root, text);
        batten_model *model = iges_body(&file, k ? "an inner loop comes before the outer one"
                                                 : "1 loop of faces runs the wrong way");
        iges_check_area(model, 12);
        batten_model_unref(model);
    }
}

TEST(a_trimmed_unbounded_plane_reaches_over_its_loops)
{
    iges_text file = iges_begin();
    char text[80];
    const int surface = iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,2.,0.,0,0.,0.,0.,1.;");
    const int outer = iges_add_boundary(&file, surface, -10, 30, false, true, true);
    snprintf(text, sizeof text, "144,%d,1,0,%d;", surface, outer);
    iges_add(&file, 144, 0, 0, 0, root, text);
    batten_model *model = iges_body(&file, "1 loop of faces runs the wrong way");
    iges_check_area(model, 1600);
    batten_model_unref(model);
    iges_text bounded = iges_begin();
    const int around = iges_add_square(&bounded, 1, 2, part, false);
    snprintf(text, sizeof text, "108,0.,0.,1.,0.,%d,0.,0.,0.,1.;", around);
    iges_add(&bounded, 108, 1, 0, 0, root, text);
    model = iges_body(&bounded, "");
    iges_check_area(model, 1);
    batten_model_unref(model);
}

/* Uniform closed cubics, whose control points lie farther out than they: areas by Green's
 * theorem. */
TEST(a_plane_within_one_closed_spline_has_its_area)
{
    static const struct {
        double points[10], area;
    } cases[] = {{{1.1, 0, 0.5, 1.5, -3.6, 2.6, -2.8, -2.1, 0.5, -1.5}, 11.302291666666667},
                 {{1.6, 0, 1.2, 3.6, -3.3, 2.4, -0.9, -0.6, 0.4, -1.1}, 10.382638888888889}};
    for (int k = 0; k < COUNT(cases); k++) {
        iges_text file = iges_begin();
        char text[300] = "126,7,3,1,1,1,1,0.,1.,2.,3.,4.,5.,6.,7.,8.,9.,10.,11.,1.,1.,1.,1.,1.,"
                         "1.,1.,1.,";
        for (int i = 0; i < 8; i++)
            sprintf(text + strlen(text), "%g,%g,0.,", cases[k].points[2 * i % 10],
                    cases[k].points[2 * i % 10 + 1]);
        strcat(text, "3.,8.,0.,0.,1.;");
        iges_add(&file, 126, 0, 0, 0, part, text);
        iges_add(&file, 108, 0, 0, 0, part, "108,0.,0.,1.,0.,0,0.,0.,0.,0.;");
        iges_add(&file, 142, 0, 0, 0, part, "142,0,3,0,1,2;");
        iges_add(&file, 144, 0, 0, 0, root, "144,3,1,0,5;");
        batten_model *model = iges_body(&file, "");
        iges_check_area(model, cases[k].area);
        batten_model_unref(model);
    }
}

/* Two half circles around it, the one on from the other and both begun there. */
TEST(a_trimmed_cone_with_one_loop_around_it_reaches_to_its_apex)
{
    static const char *const second[] = {"100,0.,0.,0.,-2.,0.,2.,0.;",
                                         "100,0.,0.,0.,2.,0.,-2.,0.;"};
    for (int k = 0; k < 2; k++) {
        iges_text file = iges_begin();
        iges_add(&file, 116, 0, 0, 0, part, "116,0.,0.,0.;");
        iges_add(&file, 123, 0, 0, 0, part, "123,0.,0.,-1.;");
        iges_add(&file, 194, 0, 0, 0, part, "194,1,3,2.,45.;");
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,0.,0.,2.,0.,-2.,0.;");
        iges_add(&file, 100, 0, k ? 15 : 0, 0, part, second[k]);
        iges_add(&file, 141, 0, 0, 0, part, "141,0,0,5,2,7,1,0,9,1,0;");
        iges_add(&file, 143, 0, 0, 0, root, "143,0,5,1,11;");
        iges_add(&file, 124, 0, 0, 0, part, "124,1.,0.,0.,0.,0.,-1.,0.,0.,0.,0.,-1.,0.;");
        batten_model *model = iges_body(&file, "");
        iges_check_area(model, 4 * sqrt(2) * 3.14159265358979323846);
        batten_model_unref(model);
    }
}

TEST(a_bounded_surface_takes_the_sense_of_each_curve)
{
    iges_text file = iges_begin();
    char text[200];
    int n = 0;
    const int surface = iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    static const char *const lines[] = {"110,0.,0.,0.,4.,0.,0.;", "110,4.,4.,0.,4.,0.,0.;",
                                        "110,4.,4.,0.,0.,4.,0.;", "110,0.,0.,0.,0.,4.,0.;"};
    n = snprintf(text, sizeof text, "141,1,0,%d,4", surface);
    for (int i = 0; i < 4; i++) {
        const int space = iges_add(&file, 110, 0, 0, 0, part, lines[i]);
        const int plane = iges_add(&file, 110, 0, 0, 0, flat, lines[i]);
        n +=
            snprintf(text + n, sizeof text - (size_t)n, ",%d,%d,1,%d", space, 1 + i % 2, plane);
    }
    strcat(text, ";");
    const int boundary = iges_add(&file, 141, 0, 0, 0, part, text);
    snprintf(text, sizeof text, "143,1,%d,1,%d;", surface, boundary);
    iges_add(&file, 143, 0, 0, 0, root, text);
    batten_model *model = iges_body(&file, "");
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(p->edge_count, 4);
    CHECK(!p->uses[0].reversed && p->uses[1].reversed && p->uses[3].reversed);
    CHECK(p->uses[3].parameters != NULL);
    iges_check_area(model, 16);
    batten_model_unref(model);
}

TEST(the_seam_of_a_cylinder_is_one_edge)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,0.,0.,1.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,1.,0.,2.;");
    iges_add(&file, 120, 0, 0, 0, part, "120,1,3,0.,6.283185307179586;");
    iges_add(&file, 100, 0, 0, 0, part, "100,0.,0.,0.,1.,0.,1.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,1.,0.,2.;");
    iges_add(&file, 100, 0, 17, 0, part, "100,-2.,0.,0.,1.,0.,1.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,2.,1.,0.,0.;");
    iges_add(&file, 102, 0, 0, 0, part, "102,4,7,9,11,13;");
    iges_add(&file, 124, 0, 0, 0, part, "124,1.,0.,0.,0.,0.,-1.,0.,0.,0.,0.,-1.,0.;");
    iges_add(&file, 142, 0, 0, 0, part, "142,1,5,0,15,2;");
    iges_add(&file, 144, 0, 0, 0, root, "144,5,1,0,19;");
    batten_model *model = iges_body(&file, "");
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(p->edge_count, 3);
    CHECK_INT(p->vertex_count, 2);
    CHECK_INT(p->use_count, 4);
    iges_check_area(model, 2 * 2 * 3.14159265358979323846);
    batten_model_unref(model);
}

TEST(Q6_boundaries_that_say_nothing_or_do_not_meet_leave_the_face_out)
{
    static const struct {
        const char *boundary, *words;
    } cases[] = {
        {"142,1,1,0,0,2;", "its boundary D5 has no curve"},
        {"142,1,1,0,99,2;", "it refers to entity D99, which is missing"},
        {"142,1,1,0,5,2;", "as a curve, which is a 142"},
        {"142,1,1,0,3,2;", "a loop ends 5.19615 from where it begins"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, 110, 0, 0, 0, part, IGES_LINE);
        iges_add(&file, 142, 0, 0, 0, part, cases[i].boundary);
        iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,5;");
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        iges_check_partly(&file, cases[i].words);
    }
    iges_text none = iges_begin();
    iges_add(&none, 128, 0, 0, 0, part, IGES_SQUARE);
    iges_add(&none, 143, 0, 0, 0, root, "143,0,1,0;");
    iges_check_left_out(&none, "it has 0 boundaries");
    iges_text plane = iges_begin();
    iges_add(&plane, 108, 0, 0, 0, root, "108,0.,0.,1.,0.,0,0.,0.,0.,1.;");
    iges_check_left_out(&plane, "a plane without bounds");
}

TEST(sides_that_meet_are_not_turned_for_a_rounding_error)
{
    /* A triangle of two sides, of which the far ends are nearer than those that meet. */
    iges_text file = iges_begin();
    iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,1.,0.,3.,3.,0.;");
    iges_add(&file, 106, 11, 0, 0, part, "106,1,3,0.,3.,3.000000000001,1.,3.,1.,1.;");
    iges_add(&file, 102, 0, 0, 0, part, "102,2,3,5;");
    iges_add(&file, 110, 0, 0, 0, flat, "110,1.,1.,0.,3.,3.,0.;");
    iges_add(&file, 106, 11, 0, 0, flat, "106,1,3,0.,3.,3.000000000001,1.,3.,1.,1.;");
    iges_add(&file, 102, 0, 0, 0, flat, "102,2,9,11;");
    iges_add(&file, 142, 0, 0, 0, part, "142,0,1,13,7,3;");
    iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,15;");
    batten_model *model = iges_body(&file, "");
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK(!p->uses[0].reversed && !p->uses[1].reversed);
    batten_model_unref(model);
}

TEST(N2_a_face_too_large_to_be_measured_is_left_out)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,1.,0.,2.,1.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,2.,1.,0.,2.,2.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,2.,2.,1.E300,1.,2.,0.;");
    iges_add(&file, 110, 0, 0, 0, part, "110,1.,2.,0.,1.,1.,0.;");
    iges_add(&file, 102, 0, 0, 0, part, "102,4,1,3,5,7;");
    iges_add(&file, 108, 1, 0, 0, root, "108,0.,0.,1.,0.,9,0.,0.,0.,1.;");
    iges_check_left_out(&file, "reach too far to be measured");
}

/* A circle 4e9 away is but a point beside the size of the loop, and yet it is not where the
 * loop is. */
TEST(a_part_of_a_loop_is_not_dropped_for_its_size_when_it_is_elsewhere)
{
    iges_text file = iges_begin();
    char text[80];
    const int axis = iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,0.,0.,1.;");
    const int side = iges_add(&file, 110, 0, 0, 0, part, "110,1.,0.,0.,1.,0.,2.;");
    snprintf(text, sizeof text, "120,%d,%d,0.,6.283185307179586;", axis, side);
    const int cylinder = iges_add(&file, 120, 0, 0, 0, part, text);
    const int bottom = iges_add(&file, 100, 0, 0, 0, part, "100,0.,0.,0.,1.,0.,1.,0.;");
    const int top = iges_add(&file, 100, 0, 0, 0, part, "100,4294967298.,0.,0.,1.,0.,1.,0.;");
    snprintf(text, sizeof text, "102,4,%d,%d,%d,%d;", bottom, side, top, side);
    const int loop = iges_add(&file, 102, 0, 0, 0, part, text);
    snprintf(text, sizeof text, "142,1,%d,0,%d,2;", cylinder, loop);
    const int boundary = iges_add(&file, 142, 0, 0, 0, part, text);
    snprintf(text, sizeof text, "144,%d,1,0,%d;", cylinder, boundary);
    iges_add(&file, 144, 0, 0, 0, root, text);
    iges_check_left_out(&file, "part 3 of a loop begins 4.29497e+09 from the end of the one");
}

/* A loop that runs along one line there, back, and there again: two of the three are a seam. */
TEST(a_seam_is_an_edge_of_two_sides_not_of_three)
{
    static const char *const lines[] = {"110,1.,1.,0.,3.,1.,0.;", "110,3.,1.,0.,3.,3.,0.;",
                                        "110,3.,3.,0.,1.,3.,0.;", "110,1.,3.,0.,3.,3.,0.;",
                                        "110,3.,3.,0.,1.,3.,0.;", "110,1.,3.,0.,1.,1.,0.;"};
    iges_text file = iges_begin();
    iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
    for (int i = 0; i < 6; i++)
        iges_add(&file, 110, 0, 0, 0, part, lines[i]);
    iges_add(&file, 102, 0, 0, 0, part, "102,6,3,5,7,9,11,13;");
    iges_add(&file, 142, 0, 0, 0, part, "142,0,1,0,15,2;");
    iges_add(&file, 144, 0, 0, 0, root, "144,1,1,0,17;");
    batten_model *model = iges_body(&file, "");
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(p->use_count, 6);
    CHECK_INT(p->edge_count, 5);
    batten_model_unref(model);
}
