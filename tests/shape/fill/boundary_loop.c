/* The sides of a hole, brought into the loop's order, box and parameters. */
#include "shape/fill/fill.h"

#include "shape/fill/loops.h"
#include "support/faults.h"

static const double box_sides[2][2][3] = {
    {{1, 1, 1}, {5, 1.02, 1}}, /* ends 0.02 beside the next one */
    {{5, 3, 2}, {5, 1, 1}},    /* runs against the loop */
};
static const double bent_side[4][3] = {{5, 3, 2}, {4, 3, 2}, {2, 3, 1.5}, {1, 1, 1}};
static const double bent_knots[6] = {0, 0, 0.25, 0.75, 1, 1};

/* A box of 4 x 2 x 1 about (3, 2, 1.5), whose third side has two corners; slopes of length 3 on
 * the first two, and a second derivative on the second. */
static void add_box(hole *h, batten_curve **bend)
{
    static const double up[2][3] = {{0, 0, 3}, {0, 0, 3}}, in[2][3] = {{-3, 0, 0}, {-3, 0, 0}};
    static const double second[2][3] = {{0, 0, 5}, {0, 0, 5}}, ends[2] = {0, 1};
    memset(h, 0, sizeof *h);
    hole_add(h, 1, box_sides[0][0], 1, up[0]);
    hole_add(h, 1, box_sides[1][0], 1, in[0]);
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){1, 1, ends}, second[0], NULL, bend));
    h->ribbons[1].curvature = *bend;
    CHECK_OK(batten_curve_create((batten_points){3, 4, bent_side[0]}, 1, NULL, bent_knots,
                                 &h->curves[2]));
    h->ribbons[h->count++] = (batten_ribbon){h->curves[2], NULL, NULL};
}

static void check_ends(const bat_fill_side *side, const double a[3], const double b[3])
{
    static const double centre[3] = {3, 2, 1.5};
    double start[3], end[3];
    CHECK_NEAR(batten_curve_domain(side->curve).a, 0, 0);
    CHECK_NEAR(batten_curve_domain(side->curve).b, 2, 0);
    CHECK_OK(batten_curve_evaluate(side->curve, 0, 0, start));
    CHECK_OK(batten_curve_evaluate(side->curve, 2, 0, end));
    for (int c = 0; c < 3; c++) {
        CHECK_NEAR(start[c], (a[c] - centre[c]) / 2, 1e-15);
        CHECK_NEAR(end[c], (b[c] - centre[c]) / 2, 1e-15);
    }
}

TEST(sides_run_round_the_loop_over_0_to_2_in_a_box_of_size_1_and_are_divided_at_corners)
{
    static const double middle[3] = {5, 1.01, 1}; /* where the first two ends meet */
    static const int given[5] = {0, 1, 2, 2, 2};
    const double *ends[6] = {bent_side[3], middle,       bent_side[0],
                             bent_side[1], bent_side[2], bent_side[3]};
    hole h;
    batten_curve *bend = NULL;
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    add_box(&h, &bend);
    CHECK_OK(bat_fill_loop_make(3, h.ribbons, 0.03, &report, &loop));
    CHECK_INT(loop.count, 5);
    CHECK_NEAR(loop.size, 2, 0);
    CHECK_NEAR(report.loop_gap, 0.02, 1e-15);
    CHECK_NEAR(report.approximation, 0, 0);
    for (int i = 0; i < 5; i++) {
        CHECK_INT(loop.sides[i].given, given[i]);
        CHECK((loop.sides[i].slope != NULL) == (i < 2) &&
              (loop.sides[i].bend != NULL) == (i == 1));
        check_ends(&loop.sides[i], ends[i], ends[i + 1]);
    }
    /* A slope gets the length of the side's derivative: 4 or sqrt 5 over 2 and over the domain. A
     * second derivative grows by the square of that, and lost half to the box. */
    double value[3];
    CHECK_OK(batten_curve_evaluate(loop.sides[0].slope, 0.7, 0, value));
    CHECK_NEAR(value[2], hypot(4, 0.02) / 4, 1e-14);
    CHECK_NEAR(value[0], 0, 0);
    CHECK_OK(batten_curve_evaluate(loop.sides[1].slope, 1.3, 0, value));
    CHECK_NEAR(value[0], -sqrt(5) / 4, 1e-14);
    CHECK_OK(batten_curve_evaluate(loop.sides[1].bend, 1.3, 0, value));
    CHECK_NEAR(value[2], 2.5 * 5 / 16 / (1.5 * 1.5), 1e-14);
    bat_fill_loop_free(&loop);
    CHECK_INT(loop.count, 0);
    batten_curve_unref(bend);
    hole_free(&h);
}

TEST(of_two_sides_the_first_is_halved_in_its_parameter)
{
    static const double arch[3][3] = {{0, 0, 0}, {1, 2, 0}, {4, 0, 0}},
                        slope[2][3] = {{0, 0, 1}, {0, 0, 1}};
    static const double base[2][3] = {{4, 0, 0}, {0, 0, 0}};
    static const int given[3] = {0, 0, 1};
    hole h = {0};
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    hole_add(&h, 2, arch[0], 1, slope[0]);
    hole_add(&h, 1, base[0], 0, NULL);
    CHECK_OK(bat_fill_loop_make(2, h.ribbons, 0, &report, &loop));
    CHECK_INT(loop.count, 3);
    for (int i = 0; i < 3; i++) {
        CHECK_INT(loop.sides[i].given, given[i]);
        CHECK((loop.sides[i].slope != NULL) == (i < 2));
    }
    for (int k = 0; k <= 8; k++) {
        const double u = k / 4.0;
        double whole[3], half[3];
        CHECK_OK(batten_curve_evaluate(h.curves[0], u / 4, 0, whole));
        CHECK_OK(batten_curve_evaluate(loop.sides[0].curve, u, 0, half));
        CHECK_NEAR(half[0], (whole[0] - 2) / loop.size, 1e-15);
        CHECK_OK(batten_curve_evaluate(h.curves[0], 0.5 + u / 4, 0, whole));
        CHECK_OK(batten_curve_evaluate(loop.sides[1].curve, u, 0, half));
        CHECK_NEAR(half[0], (whole[0] - 2) / loop.size, 1e-15);
    }
    bat_fill_loop_free(&loop);
    hole_free(&h);
}

/* A zigzag from (0, 0, 0) to (count, 0, 0) with count - 1 corners, and a line back. */
static batten_status make_zigzag_loop(int count, bat_fill_loop *loop)
{
    const double back[2][3] = {{count, 0, 0}, {0, 0, 0}};
    double points[9][3], knots[11];
    hole h = {0};
    batten_surface_fill_report report = {0};
    for (int i = 0; i <= count; i++) {
        const double p[3] = {i, i == count ? 0 : i % 2, 0};
        memcpy(points[i], p, sizeof p);
        knots[i + 1] = i;
    }
    knots[0] = 0;
    knots[count + 2] = count;
    CHECK_OK(batten_curve_create((batten_points){3, count + 1, points[0]}, 1, NULL, knots,
                                 &h.curves[0]));
    h.ribbons[h.count++].curve = h.curves[0];
    hole_add(&h, 1, back[0], 0, NULL);
    const batten_status status = bat_fill_loop_make(2, h.ribbons, 0, &report, loop);
    hole_free(&h);
    return status;
}

TEST(G7_corners_make_at_most_eight_sides)
{
    bat_fill_loop loop = {0};
    CHECK_OK(make_zigzag_loop(BATTEN_FILL_SIDES - 1, &loop));
    CHECK_INT(loop.count, BATTEN_FILL_SIDES);
    bat_fill_loop_free(&loop);
    CHECK_STATUS(make_zigzag_loop(BATTEN_FILL_SIDES, &loop), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the hole has more than 8 sides once those with corners are divided");
    CHECK_INT(loop.count, 0);
}

TEST(G1_sides_in_a_plane_and_slopes_of_length_zero_are_refused_by_number)
{
    static const double none[2][3] = {{0}}, flat[2][2] = {{0, 0}, {1, 0}}, ends[2] = {0, 1};
    hole h;
    batten_curve *bend = NULL, *curve = NULL;
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    add_box(&h, &bend);
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){1, 1, ends}, none[0], NULL, &curve));
    h.ribbons[1].slope = curve;
    CHECK_STATUS(bat_fill_loop_make(3, h.ribbons, 0.03, &report, &loop), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the slope of the ribbon of curve 2 is zero");
    batten_curve_unref(curve);
    curve = NULL;
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){1, 1, ends}, flat[0], NULL, &curve));
    h.ribbons[1].slope = h.slopes[1];
    h.ribbons[1].curvature = curve;
    CHECK_STATUS(bat_fill_loop_make(3, h.ribbons, 0.03, &report, &loop), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("curve 2 has dimension 2: sides of a hole lie in space");
    batten_curve_unref(curve);
    batten_curve_unref(bend);
    hole_free(&h);
}

static batten_status make_once(const hole *h)
{
    bat_fill_loop loop = {0};
    batten_surface_fill_report report = {0};
    const batten_status status = bat_fill_loop_make(h->count, h->ribbons, 0.03, &report, &loop);
    bat_fill_loop_free(&loop);
    return status;
}

TEST(a_loop_reports_every_lack_of_memory)
{
    static const double weights[2] = {1, 2}, ends[2] = {0, 1};
    hole h;
    batten_curve *bend = NULL, *rational = NULL;
    add_box(&h, &bend);
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){1, 1, ends}, box_sides[0][0], weights,
                                      &rational));
    h.ribbons[0].curve = rational;
    CHECK_EACH_ALLOCATION(make_once(&h));
    batten_curve_unref(rational);
    batten_curve_unref(bend);
    hole_free(&h);
}

/* On either side of a millionth of the derivative. */
TEST(a_side_is_divided_where_its_derivative_jumps_by_more_than_rounding)
{
    static const double sides[2][2][3] = {{{1, 1, 1}, {5, 1, 1}}, {{5, 1, 1}, {5, 3, 2}}},
                        knots[5] = {0, 0, 1, 2, 2};
    for (int more = 0; more < 2; more++) {
        const double off = (more ? 1.05e-6 : 0.95e-6) * sqrt(5.25) / 2;
        const double points[3][3] = {{5, 3, 2}, {3, 2, 1.5 + off}, {1, 1, 1}};
        hole h = {0};
        bat_fill_loop loop = {0};
        batten_surface_fill_report report = {0};
        for (int i = 0; i < 2; i++)
            hole_add(&h, 1, sides[i][0], 1, NULL);
        CHECK_OK(batten_curve_create((batten_points){3, 3, points[0]}, 1, NULL, knots,
                                     &h.curves[2]));
        h.ribbons[h.count++] = (batten_ribbon){h.curves[2], NULL, NULL};
        CHECK_OK(bat_fill_loop_make(3, h.ribbons, 0.03, &report, &loop));
        CHECK_INT(loop.count, 3 + more);
        bat_fill_loop_free(&loop);
        hole_free(&h);
    }
}
