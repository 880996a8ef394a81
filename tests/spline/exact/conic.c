#include <batten/standard.h>

#include "support/test.h"

static const double PI = 3.14159265358979323846;

static void check_circle(const batten_curve *curve, double radius, double x, double y)
{
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= 1000; i++) {
        double out[9];
        CHECK_OK(batten_curve_evaluate(curve, domain.a + i / 1000.0 * (domain.b - domain.a), 2,
                                       out));
        CHECK_NEAR(hypot(out[0] - x, out[1] - y) / radius, 1, 4 * DBL_EPSILON);
        const double speed = hypot(out[2], out[3]);
        if (speed > radius / 100) /* else the differences of nearly equal points tell little */
            CHECK_NEAR((out[2] * out[5] - out[3] * out[4]) / (speed * speed * speed) * radius,
                       1, 1e-11);
    }
}

TEST(an_arc_stays_on_its_circle)
{
    const double degrees[] = {1e-6, 1, 45, 89.999, 90, 90.001, 179, 180, 181, 270, 359, 360};
    for (int i = 0; i < COUNT(degrees); i++) {
        batten_curve *arc = NULL;
        const double angle = degrees[i] * PI / 180;
        CHECK_OK(batten_curve_arc(100, angle, &arc));
        check_circle(arc, 100, 0, 0);
        double end[2];
        CHECK_OK(batten_curve_evaluate(arc, 1, 0, end));
        CHECK_NEAR(end[0], 100 * cos(angle), 1e-13);
        CHECK_NEAR(end[1], 100 * sin(angle), 1e-13);
        CHECK_INT(batten_curve_point_count(arc), 2 * (int)ceil(angle / (PI / 2)) + 1);
        batten_curve_unref(arc);
    }
}

TEST(three_forms_of_a_circle_are_circles)
{
    const int points[] = {9, 7, 7};
    for (int form = 0; form < 3; form++) {
        batten_curve *circle = NULL;
        CHECK_OK(batten_curve_circle(3, (batten_circle_form)form, &circle));
        CHECK_INT(batten_curve_point_count(circle), points[form]);
        CHECK(batten_curve_is_closed(circle, 0));
        check_circle(circle, 3, 0, 0);
        batten_curve_unref(circle);
    }
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_circle(3, (batten_circle_form)7, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_circle(0, BATTEN_CIRCLE_SQUARE_9, &none), BATTEN_BAD_ARGUMENT);
}

/* The tables of the notes: points, weights and knots of the three forms, radius 1. */
TEST(three_forms_of_a_circle_have_their_tables)
{
    const double s = sqrt(0.5), r = sqrt(3), h = 0.5, third = 1.0 / 3;
    const struct {
        int count;
        double points[9][2], weights[9], knots[12];
    } tables[] = {
        {9,
         {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
         {1, s, 1, s, 1, s, 1, s, 1},
         {0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1}},
        {7,
         {{r / 2, .5}, {0, 2}, {-r / 2, .5}, {-r, -1}, {0, -1}, {r, -1}, {r / 2, .5}},
         {1, h, 1, h, 1, h, 1},
         {0, 0, 0, third, third, 2 * third, 2 * third, 1, 1, 1}},
        {7,
         {{1, 0}, {1, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {1, -1}, {1, 0}},
         {1, h, h, 1, h, h, 1},
         {0, 0, 0, .25, .5, .5, .75, 1, 1, 1}},
    };
    const batten_circle_form forms[] = {BATTEN_CIRCLE_SQUARE_9, BATTEN_CIRCLE_TRIANGLE_7,
                                        BATTEN_CIRCLE_SQUARE_7};
    for (int i = 0; i < COUNT(forms); i++) {
        batten_curve *circle = NULL;
        CHECK_OK(batten_curve_circle(1, forms[i], &circle));
        CHECK_INT(batten_curve_point_count(circle), tables[i].count);
        for (int k = 0; k < tables[i].count; k++) {
            CHECK_NEAR(batten_curve_points(circle)[2 * k], tables[i].points[k][0], 5e-16);
            CHECK_NEAR(batten_curve_points(circle)[2 * k + 1], tables[i].points[k][1], 5e-16);
            CHECK_NEAR(batten_curve_weights(circle)[k], tables[i].weights[k], 2e-16);
        }
        const batten_interval domain = batten_curve_domain(circle);
        for (int k = 0; k < tables[i].count + 3; k++)
            CHECK_NEAR((batten_curve_knots(circle)[k] - domain.a) / (domain.b - domain.a),
                       tables[i].knots[k], 2e-16);
        batten_curve_unref(circle);
    }
}

TEST(an_arc_of_quarters_ends_exactly_on_an_axis)
{
    static const double ends[4][2] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    for (int k = 0; k < 4; k++) {
        batten_curve *arc = NULL;
        CHECK_OK(batten_curve_arc(3, (k + 1) * (acos(-1) / 2), &arc));
        const double *end = batten_curve_points(arc) + 2 * (batten_curve_point_count(arc) - 1);
        CHECK(end[0] == 3 * ends[k][0] && end[1] == 3 * ends[k][1]);
        batten_curve_unref(arc);
    }
}

TEST(arcs_refuse_what_is_no_arc)
{
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_arc(1, 0, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc(1, 6.2831854, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc(1, NAN, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_arc(-1, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc(INFINITY, 1, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_ellipse(1, 0, 0, 1, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_ellipse(1, 1, NAN, 1, &none), BATTEN_NOT_FINITE);
}

TEST(an_arc_in_a_frame_lies_in_its_plane)
{
    const batten_frame frame = {{1, 2, 3}, {0, 2, 0}, {1, 5, 1}};
    batten_curve *arc = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 2, 0.5, 4, &arc));
    for (int i = 0; i <= 100; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(arc, i / 100.0, 0, p));
        const double x = p[0] - 1, y = p[1] - 2, z = p[2] - 3;
        CHECK_NEAR(sqrt(x * x + y * y + z * z), 2, 4e-15);
        CHECK_NEAR(x + 5 * y + z, 0, 2e-14);
    }
    double start[3];
    CHECK_OK(batten_curve_evaluate(arc, 0, 0, start));
    /* The first axis is (0, 1, 0) made square: (-5, 2, -5) / sqrt 54. */
    const double along =
        (-5 * (start[0] - 1) + 2 * (start[1] - 2) - 5 * (start[2] - 3)) / sqrt(54);
    CHECK_NEAR(along, 2 * cos(0.5), 4e-15);
    batten_curve_unref(arc);
    const batten_frame flat = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                       none = {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}};
    const batten_frame bad = {{0, 0, 0}, {1, 0, 0}, {2, NAN, 0}},
                       no_z = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    CHECK_STATUS(batten_curve_arc_in(&flat, 1, 0, 1, &arc), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_in(&none, 1, 0, 1, &arc), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_in(&no_z, 1, 0, 1, &arc), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_in(&bad, 1, 0, 1, &arc), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_arc_in(&frame, 1, NAN, 1, &arc), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_arc_in(&frame, 1, 0, 7, &arc), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_arc_in(&frame, 0, 0, 1, &arc), BATTEN_BAD_ARGUMENT);
}

TEST(an_arc_goes_through_its_three_points)
{
    for (int i = 1; i < 40; i++)
        for (int d = 2; d <= 3; d++) {
            const double angle = i * 0.3, t = fmod(angle, 6) + 0.2, s = t * 0.37;
            const double a[] = {5 + 2, 1, 0}, b[] = {5 + 2 * cos(s), 1 + 2 * sin(s), 0};
            const double c[] = {5 + 2 * cos(t), 1 + 2 * sin(t), 0};
            batten_curve *arc = NULL;
            CHECK_OK(batten_curve_arc_through(d, a, b, c, &arc));
            double p[3];
            CHECK_OK(batten_curve_evaluate(arc, 0, 0, p));
            CHECK_BITS(p[0], a[0]);
            CHECK_BITS(p[1], a[1]);
            CHECK_OK(batten_curve_evaluate(arc, 1, 0, p));
            CHECK_BITS(p[0], c[0]);
            CHECK_BITS(p[1], c[1]);
            double least = 1, length = 0, last[3] = {a[0], a[1], 0};
            for (int k = 0; k <= 2000; k++) {
                CHECK_OK(batten_curve_evaluate(arc, k / 2000.0, 0, p));
                CHECK_NEAR(hypot(p[0] - 5, p[1] - 1), 2, 1e-13);
                least = fmin(least, hypot(p[0] - b[0], p[1] - b[1]));
                length += hypot(p[0] - last[0], p[1] - last[1]);
                last[0] = p[0], last[1] = p[1];
            }
            CHECK(least < 0.01);
            CHECK_NEAR(length, 2 * t, 1e-4);
            batten_curve_unref(arc);
        }
}

TEST(G2_three_points_on_a_line_have_no_circle)
{
    const double a[] = {0, 0}, b[] = {1, 1}, c[] = {3, 3}, far[] = {INFINITY, 0};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_arc_through(2, a, b, c, &none), BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_curve_arc_through(2, a, b, a, &none), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_arc_through(2, a, b, far, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_arc_through(1, a, b, c, &none), BATTEN_BAD_ARGUMENT);
}

TEST(an_ellipse_satisfies_its_equation)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_ellipse(5, 0.5, 1, 5, &curve));
    for (int i = 0; i <= 100; i++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, i / 100.0, 0, p));
        CHECK_NEAR(p[0] * p[0] / 25 + p[1] * p[1] * 4, 1, 1e-15 * 4);
    }
    batten_curve_unref(curve);
}

TEST(a_conic_satisfies_its_equation_in_barycentric_coordinates)
{
    const double a[] = {0, 0}, b[] = {1, 0}, c[] = {0, 1}, weights[] = {0.3, 1, 2.5};
    for (int i = 0; i < COUNT(weights); i++) {
        batten_curve *curve = NULL, *again = NULL;
        double p[2];
        CHECK_OK(batten_curve_conic(2, a, b, c, weights[i], &curve));
        for (int k = 0; k <= 50; k++) {
            CHECK_OK(batten_curve_evaluate(curve, k / 50.0, 0, p));
            const double beta0 = 1 - p[0] - p[1], w = weights[i];
            CHECK_NEAR(p[0] * p[0], 4 * w * w * beta0 * p[1], 1e-14); /* [V] */
        }
        CHECK_OK(batten_curve_evaluate(curve, 0.3, 0, p));
        CHECK_OK(batten_curve_conic_through(
            (batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]}, (batten_vec2){c[0], c[1]},
            (batten_vec2){p[0], p[1]}, &again));
        CHECK_NEAR(batten_curve_weights(again)[1], weights[i], 1e-14);
        batten_curve_unref(again);
        batten_curve_unref(curve);
    }
    /* With any weights w1^2 / (w0 w2) stands for w^2. */
    const double points[] = {0, 0, 1, 0, 0, 1}, general[] = {2, 3, 0.5},
                 knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *other = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, general, knots, &other));
    for (int k = 0; k <= 50; k++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(other, k / 50.0, 0, p));
        CHECK_NEAR(p[0] * p[0], 4 * 9 * (1 - p[0] - p[1]) * p[1], 1e-14);
    }
    batten_curve_unref(other);
    const double out[] = {2, 2}, far[] = {NAN, 0};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_conic_through(
                     (batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]},
                     (batten_vec2){c[0], c[1]}, (batten_vec2){out[0], out[1]}, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_conic_through(
                     (batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]},
                     (batten_vec2){b[0], b[1]}, (batten_vec2){out[0], out[1]}, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_curve_conic_through(
                     (batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]},
                     (batten_vec2){far[0], far[1]}, (batten_vec2){out[0], out[1]}, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_conic(2, a, b, c, 0, &none), BATTEN_BAD_WEIGHT);
    CHECK_STATUS(batten_curve_conic(4, a, b, c, 1, &none), BATTEN_BAD_ARGUMENT);
}

static void check_five(const double *points, double (*equation)(double, double),
                       double tolerance)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_conic_five((batten_points){2, 5, points}, &curve));
    double least[5] = {1e9, 1e9, 1e9, 1e9, 1e9};
    for (int k = 0; k <= 1000; k++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, k / 1000.0, 0, p));
        CHECK_NEAR(equation(p[0], p[1]), 0, tolerance);
        for (int i = 0; i < 5; i++)
            least[i] = fmin(least[i], hypot(p[0] - points[2 * i], p[1] - points[2 * i + 1]));
    }
    for (int i = 0; i < 5; i++)
        CHECK(least[i] < 0.05);
    batten_curve_unref(curve);
}

static double on_ellipse(double x, double y)
{
    return x * x / 9 + y * y - 1;
}

static double on_parabola(double x, double y)
{
    return x * x - y;
}

static double on_hyperbola(double x, double y)
{
    return x * y - 1;
}

TEST(five_points_give_their_conic)
{
    const double starts[] = {0, 1, 2.5}, sweeps[] = {1, 3.1415926535897931, 4, 5.5};
    for (int i = 0; i < COUNT(starts); i++)
        for (int j = 0; j < COUNT(sweeps); j++) {
            double points[10];
            for (int k = 0; k < 5; k++) {
                points[2 * k] = 3 * cos(starts[i] + sweeps[j] * k / 4);
                points[2 * k + 1] = sin(starts[i] + sweeps[j] * k / 4);
            }
            check_five(points, on_ellipse, 1e-11);
        }
    double parabola[10], hyperbola[10];
    for (int k = 0; k < 5; k++) {
        parabola[2 * k] = k - 1.5;
        parabola[2 * k + 1] = (k - 1.5) * (k - 1.5);
        hyperbola[2 * k] = 0.5 + 0.5 * k;
        hyperbola[2 * k + 1] = 1 / (0.5 + 0.5 * k);
    }
    check_five(parabola, on_parabola, 1e-11);
    check_five(hyperbola, on_hyperbola, 1e-11);
}

TEST(five_points_that_are_no_arc_are_refused)
{
    const double line[] = {0, 0, 1, 0, 2, 0, 3, 0, 4, 1},
                 twice[] = {0, 0, 1, 0, 2, 1, 1, 0, 4, 1};
    const double bad[] = {0, 0, 1, 0, 2, NAN, 1, 0, 4, 1};
    const double branches[] = {1, 1, 2, 0.5, -1, -1, -2, -0.5, -0.5, -2},
                 mixed[] = {1, 0, -1, 0, 0, 1, 0.6, 0.8, 0, -1};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, line}, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, twice}, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 4 coincide");
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, bad}, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, branches}, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, mixed}, &none),
                 BATTEN_SINGULAR_SYSTEM);
}

TEST(five_points_of_a_conic_out_of_order_are_refused_whatever_the_order)
{
    /* of an ellipse, which any of them may start, and of a parabola; forwards or backwards */
    const double angles[5] = {0.1, 0.9, 2.2, 3.9, 5.2};
    int order[5] = {0, 1, 2, 3, 4}, accepted[2] = {0, 0};
    for (int n = 0; n < 120; n++) {
        for (int kind = 0; kind < 2; kind++) {
            double points[10];
            for (int i = 0; i < 5; i++) {
                const double t = angles[order[i]];
                points[2 * i] = kind ? t - 2 : 3 * cos(t);
                points[2 * i + 1] = kind ? (t - 2) * (t - 2) : sin(t);
            }
            int rising = 0, falling = 0;
            for (int i = 0; i < 4; i++) {
                rising +=
                    kind ? order[i] + 1 == order[i + 1] : (order[i] + 1) % 5 == order[i + 1];
                falling +=
                    kind ? order[i + 1] + 1 == order[i] : (order[i + 1] + 1) % 5 == order[i];
            }
            const bool in_order = rising == 4 || falling == 4;
            batten_curve *curve = NULL;
            const batten_status status =
                batten_curve_conic_five((batten_points){2, 5, points}, &curve);
            if (!test_memory_failed(status, in_order ? BATTEN_OK : BATTEN_SINGULAR_SYSTEM))
                CHECK_INT(status, in_order ? BATTEN_OK : BATTEN_SINGULAR_SYSTEM);
            accepted[kind] += status == BATTEN_OK;
            batten_curve_unref(curve);
        }
        /* the next order: rotations within rotations */
        for (int k = 5, r = n + 1; k > 1; r /= k, k--) {
            const int first = order[0];
            memmove(order, order + 1, (size_t)(k - 1) * sizeof *order);
            order[k - 1] = first;
            if (r % k != 0)
                break;
        }
    }
    CHECK(test_cases(120) < 120 || (accepted[0] == 10 && accepted[1] == 2));
}

TEST(lines_and_polylines_have_the_points_they_were_given)
{
    const double a[] = {1, 2, 3}, b[] = {4, 6, 3}, points[] = {0, 0, 3, 4, 3, 5};
    batten_curve *line = NULL, *polyline = NULL;
    double p[3];
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_curve_evaluate(line, 0.5, 0, p));
    CHECK(p[0] == 2.5 && p[1] == 4 && p[2] == 3);
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, points}, &polyline));
    CHECK_BITS(batten_curve_domain(polyline).b, 6);
    CHECK_OK(batten_curve_evaluate(polyline, 5, 0, p));
    CHECK(p[0] == 3 && p[1] == 4);
    batten_curve_unref(polyline);
    batten_curve_unref(line);
}

TEST(G1_a_polyline_names_the_points_that_coincide)
{
    const double points[] = {0, 0, 3, 4, 3, 4}, wide[] = {-1e308, 1e308};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_polyline((batten_points){2, 3, points}, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    CHECK_STATUS(batten_curve_polyline((batten_points){2, 1, points}, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_polyline((batten_points){4, 3, points}, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_polyline((batten_points){1, 2, wide}, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_line(0, points, points, &none), BATTEN_BAD_ARGUMENT);
}

TEST(G3_a_line_of_no_length_is_a_value)
{
    const double a[] = {1, 2};
    batten_curve *line = NULL;
    double p[2];
    CHECK_OK(batten_curve_line(2, a, a, &line));
    CHECK_OK(batten_curve_evaluate(line, 0.3, 0, p));
    CHECK(p[0] == 1 && p[1] == 2);
    batten_curve_unref(line);
}

TEST(G2_every_pair_of_coinciding_points_and_every_size_is_refused)
{
    const double a[] = {0, 0}, b[] = {1, 1}, tip[] = {1e300, 0, 0, 0, 1e300, 0};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_arc_through(2, a, a, b, &none), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_arc_through(2, a, b, b, &none), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_arc_through(4, a, b, a, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_line(4, tip, tip, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_polyline((batten_points){0, 2, tip}, &none), BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
}

TEST(a_conic_goes_through_no_point_beyond_any_side_of_its_triangle)
{
    const double a[] = {0, 0}, b[] = {1, 0}, c[] = {0, 1};
    const double beyond[][2] = {{0.6, 0.6}, {-0.1, 0.5}, {0.5, -0.1},
                                {0.5, 0.5}, {0, 0.5},    {0.5, 0}};
    batten_curve *none = NULL;
    for (int i = 0; i < COUNT(beyond); i++) {
        CHECK_STATUS(
            batten_curve_conic_through((batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]},
                                       (batten_vec2){c[0], c[1]},
                                       (batten_vec2){beyond[i][0], beyond[i][1]}, &none),
            BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("not inside the triangle");
    }
    const double huge[] = {1e200, 0}, high[] = {0, 1e200}, in[] = {1, 1};
    CHECK_STATUS(batten_curve_conic_through(
                     (batten_vec2){a[0], a[1]}, (batten_vec2){huge[0], huge[1]},
                     (batten_vec2){high[0], high[1]}, (batten_vec2){in[0], in[1]}, &none),
                 BATTEN_NOT_FINITE);
    const double five[] = {1e200, 0, 0, 1e200, -1e200, 0, 0, -1e200, 0.8e200, -0.6e200};
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, five}, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK(none == NULL);
}

/* Five points of the circle of radius 5 with one number changed, and what is said. */
static const struct {
    int place;
    double value[2];
    batten_status status;
    const char *words;
} spoilt[] = {
    {0, {NAN, 0}, BATTEN_NOT_FINITE, "coordinate 1 of point 1 is nan"},
    {2, {4, INFINITY}, BATTEN_NOT_FINITE, "coordinate 2 of point 3 is inf"},
    {4, {-INFINITY, 0}, BATTEN_NOT_FINITE, "coordinate 1 of point 5 is -inf"},
    {1, {5, 0}, BATTEN_COINCIDENT, "points 1 and 2 coincide at (5, 0)"},
    {4, {0, 5}, BATTEN_COINCIDENT, "points 4 and 5 coincide at (0, 5)"},
    {3, {5, 0}, BATTEN_COINCIDENT, "points 1 and 4 coincide at (5, 0)"},
    {4, {5, 0.25}, BATTEN_SINGULAR_SYSTEM, "the five points do not follow each other"},
};

TEST(G2_of_five_points_the_bad_ones_are_named)
{
    batten_curve *none = NULL;
    for (int i = 0; i < COUNT(spoilt); i++) {
        double points[10] = {5, 0, 4, 3, 3, 4, 0, 5, -3, 4};
        memcpy(points + 2 * spoilt[i].place, spoilt[i].value, sizeof spoilt[i].value);
        CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, points}, &none),
                     spoilt[i].status);
        CHECK_MESSAGE(spoilt[i].words);
    }
    const double line[10] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4};
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 5, line}, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("too many of the five points lie on a line");
    CHECK(!none);
}

/* Arcs, their angles and sizes refused by name. */
static const struct {
    double a, b, start, angle;
    const char *words;
} shapes[] = {
    {0, 0, 0, 1, "the radius is 0; it must be positive"},
    {-2, -2, 0, 1, "the radius is -2; it must be positive"},
    {-1, 2, 0, 1, "the first half axis is -1; it must be positive"},
    {1, 0, 0, 1, "the second half axis is 0; it must be positive"},
    {INFINITY, 1, 0, 1, "the first half axis is inf"},
    {1, 2, NAN, 1, "the start angle is nan"},
    {1, 2, 0, INFINITY, "the angle is inf"},
    {1, 2, 0, 0, "the angle is 0; it must be in (0, 2 pi]"},
    {1, 2, 0, -1, "the angle is -1; it must be in (0, 2 pi]"},
    {1, 2, 0, 6.5, "the angle is 6.5; it must be in (0, 2 pi]"},
};

TEST(N1_what_makes_no_ellipse_is_named)
{
    batten_curve *none = NULL;
    for (int i = 0; i < COUNT(shapes); i++) {
        CHECK(batten_curve_ellipse(shapes[i].a, shapes[i].b, shapes[i].start, shapes[i].angle,
                                   &none) != BATTEN_OK);
        CHECK_MESSAGE(shapes[i].words);
    }
    CHECK(!none);
}
