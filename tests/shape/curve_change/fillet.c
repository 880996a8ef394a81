#include "support/faults.h"
#include "support/test.h"
#include <batten/blend.h>
#include <batten/continuity.h>
#include <batten/measure.h>
#include <batten/standard.h>

#define PI 3.14159265358979323846

static double length_of(const batten_curve *curve)
{
    double length = 0;
    CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
    return length;
}

/* Radius and tangents of an arc between two curves, by what is true of any. */
static void check_arc(const batten_curve *a, const batten_curve *b, double radius,
                      const batten_curves_fillet_report *report, const batten_curve *arc)
{
    const batten_interval domain = batten_curve_domain(arc);
    const int d = batten_curve_dimension(a);
    const double c[3] = {report->center.x, report->center.y, report->center.z};
    for (int i = 0; i <= 20; i++) {
        double p[3], square = 0;
        CHECK_OK(batten_curve_evaluate(arc, domain.a + (domain.b - domain.a) * i / 20, 0, p));
        for (int k = 0; k < d; k++)
            square += (p[k] - c[k]) * (p[k] - c[k]);
        CHECK_NEAR(sqrt(square), radius, 1e-13 * (1 + radius));
    }
    const batten_curve *curves[2] = {a, b};
    for (int k = 0; k < 2; k++) {
        double p[6], q[6], along = 0, size[2] = {0, 0};
        CHECK_OK(batten_curve_evaluate(curves[k], report->u[k], 1, p));
        CHECK_OK(batten_curve_evaluate(arc, k ? domain.b : domain.a, 1, q));
        for (int i = 0; i < d; i++) {
            CHECK_NEAR(p[i], q[i], 1e-11);
            along += p[d + i] * q[d + i];
            size[0] += p[d + i] * p[d + i];
            size[1] += q[d + i] * q[d + i];
        }
        CHECK_NEAR(along / sqrt(size[0] * size[1]), 1, 1e-12);
    }
}

TEST(the_fillet_of_two_lines_is_where_it_must_be)
{
    /* Along x to (4, 0), then by 60 degrees to the left: legs r tan 30. */
    const double p[] = {0, 0, 4, 0, 4, 0, 4 + 5 * cos(PI / 3), 5 * sin(PI / 3)};
    batten_curve *a = NULL, *b = NULL, *arc = NULL;
    CHECK_OK(batten_curve_line(2, p, p + 2, &a));
    CHECK_OK(batten_curve_line(2, p + 4, p + 6, &b));
    batten_curves_fillet_report report;
    CHECK_EACH_ALLOCATION(batten_curves_fillet(a, b, 1.5, 1e-9, &report, &arc));
    const double leg = 1.5 * tan(PI / 6);
    CHECK(report.complete);
    CHECK_INT(report.found, 1);
    CHECK_NEAR(report.u[0], (4 - leg) / 4, 1e-15);
    CHECK_NEAR(report.u[1], leg / 5, 1e-15);
    CHECK_NEAR(report.angle, PI / 3, 1e-14);
    CHECK_NEAR(report.center.x, 4 - leg, 1e-14);
    CHECK_NEAR(report.center.y, 1.5, 1e-14);
    CHECK_NEAR(length_of(arc), 1.5 * PI / 3, 1e-12);
    check_arc(a, b, 1.5, &report, arc);
    batten_curve_unref(arc);
    CHECK_STATUS(batten_curves_fillet(a, b, 7, 1e-9, NULL, &arc), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("the radius 7 needs 4.04145 of either straight line; there are 4 and 5");
    CHECK_EACH_ALLOCATION(batten_curves_fillet(a, b, 4 / tan(PI / 6), 1e-9, &report, &arc));
    CHECK_NEAR(report.u[0], 0, 1e-14);
    batten_curve_unref(arc);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(lines_that_cross_or_do_not_meet_are_rounded_where_they_would)
{
    const double p[] = {-1, 0, 3, 0, 1, -2, 1, 5, 4, 1, 4, 3};
    batten_curve *a = NULL, *b = NULL, *c = NULL, *arc = NULL;
    CHECK_OK(batten_curve_line(2, p, p + 2, &a));
    CHECK_OK(batten_curve_line(2, p + 4, p + 6, &b));
    CHECK_OK(batten_curve_line(2, p + 8, p + 10, &c));
    batten_curves_fillet_report report;
    CHECK_OK(batten_curves_fillet(a, b, 0.5, 1e-9, &report, &arc));
    CHECK_NEAR(report.center.x, 0.5, 1e-14);
    CHECK_NEAR(report.center.y, 0.5, 1e-14);
    check_arc(a, b, 0.5, &report, arc);
    batten_curve_unref(arc);
    /* The corner is at (4, 0): an arc of 1.5 ends at (2.5, 0), one of 0.5 nowhere. */
    CHECK_OK(batten_curves_fillet(a, c, 1.5, 1e-9, &report, &arc));
    check_arc(a, c, 1.5, &report, arc);
    batten_curve_unref(arc);
    CHECK_STATUS(batten_curves_fillet(a, c, 0.5, 1e-9, NULL, &arc), BATTEN_NOT_FOUND);
    CHECK_STATUS(batten_curves_fillet(b, c, 0.5, 1e-9, NULL, &arc), BATTEN_NOT_COMPATIBLE);
    batten_curve_unref(c);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(a_line_and_a_circle_are_rounded_as_the_triangle_says)
{
    /* Along y = 0 into the unit circle about (0, 0), run counter-clockwise from (1, 0) to its
     * top: the centre is at (x, -+ r) with x^2 + r^2 = (1 +- r)^2. Coming from the left inside
     * the circle, turning left: the circle of radius r inside, (1 - r)^2 = x^2 + r^2. */
    const double p[] = {-0.9, 0, 2, 0};
    batten_curve *a = NULL, *b = NULL, *arc = NULL;
    CHECK_OK(batten_curve_line(2, p, p + 2, &a));
    CHECK_OK(batten_curve_arc(1, PI / 2, &b));
    batten_curves_fillet_report report;
    const double r = 0.2;
    CHECK_OK(batten_curves_fillet(a, b, r, 1e-9, &report, &arc));
    CHECK_NEAR(report.center.x, sqrt((1 - r) * (1 - r) - r * r), 1e-13);
    CHECK_NEAR(report.center.y, r, 1e-13);
    CHECK(!report.complete);
    check_arc(a, b, r, &report, arc);
    batten_curve_unref(arc);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(fillets_of_random_curves_touch_both_in_plane_and_space)
{
    test_random random = test_random_begin("fillet");
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    for (int n = test_cases(24); n > 0; n--) {
        double p[2][10];
        batten_curve *c[2] = {NULL, NULL}, *arc = NULL;
        const batten_affine turn = batten_affine_rotation(
            (batten_vec3){1, 2, 3},
            (batten_vec3){test_random_in(&random, -1, 1), 1, test_random_in(&random, -1, 1)},
            test_random_in(&random, 0, 3));
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < 5; i++) {
                p[k][2 * i] = (k ? 4 : i) + test_random_in(&random, -0.2, 0.2);
                p[k][2 * i + 1] = (k ? i - 0.5 : 0) + test_random_in(&random, -0.2, 0.2);
            }
            batten_curve *flat = NULL, *space = NULL;
            CHECK_OK(batten_curve_create((batten_points){2, 5, p[k]}, 3, NULL, knots, &flat));
            if (n % 2) {
                c[k] = flat;
                continue;
            }
            CHECK_OK(batten_curve_to_dimension(flat, 3, &space));
            CHECK_OK(batten_curve_transform(space, &turn, &c[k]));
            batten_curve_unref(space);
            batten_curve_unref(flat);
        }
        batten_curves_fillet_report report;
        CHECK_OK(batten_curves_fillet(c[0], c[1], 0.5, 1e-9, &report, &arc));
        CHECK(report.gap < 1e-12);
        check_arc(c[0], c[1], 0.5, &report, arc);
        batten_curve_unref(arc);
        CHECK_STATUS(batten_curves_fillet(c[0], c[1], 50, 1e-9, NULL, &arc), BATTEN_NOT_FOUND);
        batten_curve_unref(c[1]);
        batten_curve_unref(c[0]);
    }
}

TEST(a_square_with_round_corners_has_its_length)
{
    const double p[] = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0};
    batten_curve *square = NULL, *made = NULL, *mid = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){2, 5, p}, &square));
    const double r = 0.75;
    batten_corners_report report;
    CHECK_EACH_ALLOCATION(batten_curve_fillet(square, 1, &r, 1e-9, &report, &made));
    CHECK_INT(report.corners, 4);
    CHECK_INT(report.cut, 4);
    CHECK(report.complete);
    CHECK(batten_curve_is_closed(made, 1e-12));
    CHECK_NEAR(length_of(made), 16 - 8 * r + 2 * PI * r, 1e-11);
    batten_continuities joins;
    CHECK_OK(batten_curve_continuity(made, NULL, &joins));
    for (int i = 0; i < joins.count; i++)
        CHECK(joins.at[i].geometric >= 1);
    batten_release(joins.at);
    batten_curve_unref(made);
    /* All straight parts used up: a circle. */
    const double two = 2;
    CHECK_EACH_ALLOCATION(batten_curve_fillet(square, 1, &two, 1e-9, &report, &made));
    CHECK_NEAR(length_of(made), 4 * PI, 1e-11);
    batten_curve_unref(made);
    const double more = 2.1;
    CHECK_STATUS(batten_curve_fillet(square, 1, &more, 1e-9, NULL, &made), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("corners 4 and 1 want the same part");
    const double much = 5;
    CHECK_STATUS(batten_curve_fillet(square, 1, &much, 1e-9, NULL, &made), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("corner 1 at (4, 0, 0): the radius 5 needs 5");
    /* One radius for each corner, 0 for none; the seam is the last. */
    const double each[] = {0.5, 0, 1, 0.25};
    CHECK_OK(batten_curve_fillet(square, 4, each, 1e-9, &report, &made));
    CHECK_INT(report.cut, 3);
    CHECK_NEAR(length_of(made), 16 - (2 - PI / 2) * 1.75, 1e-11);
    batten_curve_unref(made);
    CHECK_STATUS(batten_curve_fillet(square, 3, each, 1e-9, NULL, &made), BATTEN_BAD_ARGUMENT);
    /* A seam in the middle of a side is none. */
    const double q[] = {2, 0, 4, 0, 4, 4, 0, 4, 0, 0, 2, 0};
    CHECK_OK(batten_curve_polyline((batten_points){2, 6, q}, &mid));
    CHECK_OK(batten_curve_fillet(mid, 4, each, 1e-9, &report, &made));
    CHECK_INT(report.corners, 4);
    CHECK_NEAR(length_of(made), 16 - (2 - PI / 2) * 1.75, 1e-11);
    double start[2];
    CHECK_OK(batten_curve_evaluate(made, batten_curve_domain(made).a, 0, start));
    CHECK_NEAR(start[0], 4, 1e-12); /* behind its first corner */
    CHECK_NEAR(start[1], 0.5, 1e-12);
    batten_curve_unref(made);
    batten_curve_unref(mid);
    batten_curve_unref(square);
}

TEST(a_path_in_space_is_rounded_and_cut_corner_by_corner)
{
    const double p[] = {0, 0, 0, 2, 0, 0, 2, 3, 0, 2, 3, 4}, r = 0.5;
    batten_curve *path = NULL, *made = NULL;
    batten_corners_report report;
    CHECK_OK(batten_curve_polyline((batten_points){3, 4, p}, &path));
    CHECK_OK(batten_curve_fillet(path, 1, &r, 1e-9, &report, &made));
    CHECK_INT(report.corners, 2);
    CHECK_NEAR(length_of(made), 9 - 2 * (2 - PI / 2) * r, 1e-11);
    batten_curve_unref(made);
    CHECK_EACH_ALLOCATION(
        batten_curve_chamfer(path, (double[2]){0.3, 0.4}, 1e-9, &report, &made));
    CHECK_INT(report.cut, 2);
    CHECK_NEAR(length_of(made), 9 - 2 * (0.7 - 0.5), 1e-11);
    CHECK_INT(batten_curve_degree(made), 1);
    CHECK_INT(batten_curve_point_count(made), 6);
    batten_curve_unref(made);
    CHECK_STATUS(batten_curve_chamfer(path, (double[2]){1.6, 1.6}, 1e-9, NULL, &made),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("corners 1 and 2 want the same part");
    CHECK_STATUS(batten_curve_chamfer(path, (double[2]){2.5, 0.1}, 1e-9, NULL, &made),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("corner 1 at (2, 0, 0)");
    batten_curve_unref(path);
}

TEST(a_curve_without_corners_stays_itself)
{
    batten_curve *circle = NULL, *made = NULL;
    batten_corners_report report;
    const double r = 1;
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_fillet(circle, 1, &r, 1e-9, &report, &made));
    CHECK(made == circle);
    CHECK_INT(report.corners, 0);
    batten_curve_unref(made);
    batten_curve_unref(circle);
}

TEST(a_chamfer_of_two_curves_goes_by_arc_length)
{
    const double p[] = {-1, 0, 0, 0};
    batten_curve *arc = NULL, *line = NULL, *cut = NULL, *far = NULL;
    CHECK_OK(batten_curve_arc(2, 1, &arc)); /* begins at (2, 0) upwards */
    const batten_affine map = batten_affine_translation(-2, 0, 0);
    CHECK_OK(batten_curve_transform(arc, &map, &far));
    CHECK_OK(batten_curve_line(2, p, p + 2, &line));
    double u[2];
    CHECK_EACH_ALLOCATION(
        batten_curves_chamfer(line, far, (double[2]){0.5, 1}, 1e-12, u, &cut));
    const double *q = batten_curve_points(cut);
    CHECK_NEAR(q[0], -0.5, 1e-12);
    CHECK_NEAR(q[2], 2 * cos(0.5) - 2, 1e-11);
    CHECK_NEAR(q[3], 2 * sin(0.5), 1e-11);
    CHECK_NEAR(u[0], 0.5, 1e-12);
    batten_curve_unref(cut);
    CHECK_STATUS(batten_curves_chamfer(line, arc, (double[2]){0.5, 1}, 1e-12, u, &cut),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curves_chamfer(line, far, (double[2]){1.5, 1}, 1e-12, u, &cut),
                 BATTEN_NOT_FOUND);
    batten_curve_unref(line);
    batten_curve_unref(far);
    batten_curve_unref(arc);
}

TEST(N1_N6_radii_and_curves_that_make_no_fillet_are_refused)
{
    const double p[] = {0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 1, 2}, r = 1;
    batten_curve *a = NULL, *b = NULL, *flat = NULL, *function = NULL, *out = NULL;
    CHECK_OK(batten_curve_line(3, p, p + 3, &a));
    CHECK_OK(batten_curve_line(3, p + 6, p + 9, &b)); /* skew */
    CHECK_OK(batten_curve_line(2, p + 3, p + 8, &flat));
    CHECK_OK(batten_curve_line(1, p + 2, p + 3, &function));
    CHECK_STATUS(batten_curves_fillet(a, b, 0.1, 1e-9, NULL, &out), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curves_fillet(a, a, 0.1, 1e-9, NULL, &out), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curves_fillet(a, flat, 0.1, 1e-9, NULL, &out), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_curves_fillet(function, function, 1, 1, NULL, &out),
                 BATTEN_UNSUPPORTED);
    static const double bad[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < COUNT(bad); i++) {
        CHECK_STATUS(batten_curves_fillet(a, b, bad[i], 1e-9, NULL, &out), BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curves_fillet(a, b, 1, bad[i], NULL, &out), BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curve_chamfer(a, (double[2]){1, bad[i]}, 1, NULL, &out),
                     BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curve_fillet(a, 1, &r, bad[i], NULL, &out), BATTEN_BAD_ARGUMENT);
    }
    const double radii[3][2] = {{1, -2}, {NAN, 1}, {1, INFINITY}};
    batten_curve *bent = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){2, 4, (double[]){0, 0, 9, 0, 9, 9, 0, 9}},
                                   &bent));
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(batten_curve_fillet(bent, 2, radii[i], 1e-9, NULL, &out),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(i == 1 ? "radius 1 is nan"
                      : i    ? "radius 2 is inf"
                             : "radius 2 is -2, below 0");
    }
    CHECK(!out);
    batten_curve_unref(bent);
    batten_curve_unref(function);
    batten_curve_unref(flat);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

/* From (0, 0) to (1, 0), and upwards from (x, y): what a fillet of this radius is refused for. */
static const struct {
    double x, y, radius;
    batten_status status;
    const char *words;
} corners[] = {
    {5, 1, 1, BATTEN_NOT_FOUND, "the straight lines end too far before they meet; extend them"},
    {2, 3, 1, BATTEN_NOT_FOUND, "the straight lines end too far before they meet; extend them"},
    {2, 1.01, 1, BATTEN_NOT_FOUND, "the straight lines end too far before they meet"},
    {2.01, 1, 1, BATTEN_NOT_FOUND, "the straight lines end too far before they meet"},
    {2, 1, 1, BATTEN_OK, ""},
    {1.5, 0.5, 0.75, BATTEN_OK, ""},
    {1, 0, 1.5, BATTEN_NOT_FOUND,
     "the radius 1.5 needs 1.5 of either straight line; there are 1 and 4"},
    {9, -8, 9, BATTEN_NOT_FOUND,
     "the radius 9 needs 9 of either straight line; there are 9 and 0"},
    {1, -3.5, 0.75, BATTEN_NOT_FOUND,
     "the radius 0.75 needs 0.75 of either straight line; there are 1 and 0.5"},
};

TEST(straight_lines_that_leave_no_room_for_a_fillet_are_refused_with_their_lengths)
{
    const double from[2] = {0, 0}, to[2] = {1, 0};
    batten_curve *first = NULL;
    CHECK_OK(batten_curve_line(2, from, to, &first));
    for (int i = 0; i < COUNT(corners); i++) {
        const double low[2] = {corners[i].x, corners[i].y}, high[2] = {low[0], low[1] + 4};
        batten_curves_fillet_report report = {.found = 77};
        batten_curve *second = NULL, *arc = NULL;
        CHECK_OK(batten_curve_line(2, low, high, &second));
        CHECK_STATUS(
            batten_curves_fillet(first, second, corners[i].radius, 1e-9, &report, &arc),
            corners[i].status);
        if (corners[i].status == BATTEN_OK) {
            CHECK_NEAR(report.center.x, low[0] - corners[i].radius, 1e-12);
            CHECK_NEAR(report.center.y, corners[i].radius, 1e-12);
            CHECK_NEAR(report.angle, acos(0.0), 1e-12);
            CHECK_NEAR(report.u[0], low[0] - corners[i].radius, 1e-12);
            CHECK_NEAR(report.u[1], (corners[i].radius - low[1]) / 4, 1e-12);
            CHECK(report.found == 1 && report.complete);
        } else {
            CHECK_MESSAGE(corners[i].words);
            CHECK(report.found == 77 && !arc);
        }
        batten_curve_unref(arc);
        batten_curve_unref(second);
    }
    batten_curve_unref(first);
}
