#include "inspect/shapes.h"
#include <batten/contours.h>

TEST(the_equation_of_a_parabola_and_of_a_circle_are_the_known_ones)
{
    /* y = x^2: f is (y - x^2) by its largest gradient, that of x = +-1: sqrt(5). */
    const double parabola[6] = {-1, 1, 0, -1, 1, 1};
    batten_curve *curve = NULL, *circle = NULL;
    batten_implicit *f = NULL;
    batten_implicit_from_curve_report report;
    double gradient[2];
    CHECK_OK(shape_bezier(2, 2, parabola, &curve));
    CHECK_OK(batten_implicit_from_curve(curve, &report, &f));
    CHECK_INT(report.degree, 2);
    CHECK(report.error <= 1e-15);
    CHECK_NEAR(report.least_gradient, 1 / sqrt(5), 1e-14);
    const double sign = batten_implicit_value(f, 0, 1, NULL) > 0 ? 1 : -1;
    for (int i = 0; i < 50; i++) {
        const double x = -3 + 0.13 * i, y = 2 - 0.07 * i;
        CHECK_NEAR(sign * batten_implicit_value(f, x, y, gradient), (y - x * x) / sqrt(5),
                   1e-13);
        CHECK_NEAR(sign * gradient[0], -2 * x / sqrt(5), 1e-13);
        CHECK_NEAR(sign * gradient[1], 1 / sqrt(5), 1e-13);
    }
    batten_implicit_free(f);
    batten_curve_unref(curve);
    /* A quarter of the circle of radius 2 about (10, -4): (r^2 - 4) / 4. */
    const double w[3] = {1, sqrt(0.5), 1}, breaks[2] = {0, 1};
    const double quarter[6] = {12, -4, 12, -2, 10, -2};
    CHECK_OK(batten_curve_from_bezier(2, (batten_pieces){2, 1, breaks}, quarter, w, &circle));
    CHECK_OK(batten_implicit_from_curve(circle, &report, &f));
    CHECK_NEAR(report.least_gradient, 1, 1e-13);
    const double side = batten_implicit_value(f, 10, -4, NULL) < 0 ? 1 : -1;
    for (int i = 0; i < 50; i++) {
        const double x = 7 + 0.13 * i, y = -7 + 0.17 * i;
        const double square = (x - 10) * (x - 10) + (y + 4) * (y + 4);
        CHECK_NEAR(side * batten_implicit_value(f, x, y, NULL), (square - 4) / 4, 1e-12);
    }
    batten_implicit_free(f);
    batten_curve_unref(circle);
}

TEST(curves_of_every_degree_satisfy_their_equation_and_give_their_parameters_back)
{
    test_random random = test_random_begin("implicit");
    for (int n = test_cases(24); n > 0; n--) {
        const int degree = 1 + n % BATTEN_IMPLICIT_DEGREE;
        double points[2 * 9], weights[9], knots[18];
        batten_curve *curve = NULL;
        batten_implicit *f = NULL;
        batten_implicit_from_curve_report report;
        for (int i = 0; i <= degree; i++) {
            points[2 * i] = 5 + i + test_random_in(&random, -0.3, 0.3);
            points[2 * i + 1] = test_random_in(&random, -1, 1);
            weights[i] = test_random_in(&random, 0.5, 2);
            knots[i] = -1;
            knots[degree + 1 + i] = 2;
        }
        CHECK_OK(batten_curve_create((batten_points){2, degree + 1, points}, degree,
                                     n % 3 ? NULL : weights, knots, &curve));
        CHECK_OK(batten_implicit_from_curve(curve, &report, &f));
        CHECK_INT(report.degree, degree);
        CHECK(report.error <= 1e-10);
        for (int k = 0; k <= 20; k++) {
            const double u = -1 + 3 * (k / 20.0);
            double p[2], found, gradient[2], h = 1e-5;
            CHECK_OK(batten_curve_evaluate(curve, u, 0, p));
            CHECK(fabs(batten_implicit_value(f, p[0], p[1], gradient)) <= 1e-10);
            CHECK_OK(batten_implicit_invert(f, p[0], p[1], &found));
            CHECK_NEAR(found, u, 1e-7);
            /* the gradient is that of the values */
            CHECK_NEAR(gradient[0],
                       (batten_implicit_value(f, p[0] + h, p[1], NULL) -
                        batten_implicit_value(f, p[0] - h, p[1], NULL)) /
                           (2 * h),
                       1e-6);
        }
        batten_implicit_free(f);
        batten_curve_unref(curve);
    }
}

TEST(raised_degrees_are_lowered_and_parameters_beyond_the_piece_are_found)
{
    const double cubic[8] = {0, 0, 1, 2, 2, -1, 3, 1};
    batten_curve *curve = NULL, *raised = NULL, *part = NULL;
    batten_implicit *f = NULL;
    batten_implicit_from_curve_report report;
    double p[2], u;
    CHECK_OK(shape_bezier(2, 3, cubic, &curve));
    CHECK_OK(batten_curve_elevate(curve, 3, &raised));
    CHECK_OK(batten_implicit_from_curve(raised, &report, &f));
    CHECK_INT(report.degree, 3);
    batten_implicit_free(f);
    CHECK_OK(batten_curve_subrange(curve, 0.25, 0.5, &part));
    CHECK_OK(batten_implicit_from_curve(part, &report, &f));
    for (int k = 0; k <= 10; k++) {
        CHECK_OK(batten_curve_evaluate(curve, k / 10.0, 0, p));
        CHECK_OK(batten_implicit_invert(f, p[0], p[1], &u));
        CHECK_NEAR(u, k / 10.0, 1e-7);
    }
    CHECK_STATUS(batten_implicit_invert(f, 1, 5, &u), BATTEN_SINGULAR_HERE);
    batten_implicit_free(f);
    batten_curve_unref(part);
    batten_curve_unref(raised);
    batten_curve_unref(curve);
}

TEST(a_looping_cubic_is_traced_with_its_crossing)
{
    /* x = t^2, y = t^3 - t / 4: y^2 = x (x - 1/4)^2, which crosses itself in (1/4, 0). */
    double b[8];
    for (int i = 0; i < 4; i++) { /* blossom values at t in {-1, 1} */
        const double u[3] = {i > 2 ? 1 : -1, i > 1 ? 1 : -1, i > 0 ? 1 : -1};
        b[2 * i] = (u[0] * u[1] + u[0] * u[2] + u[1] * u[2]) / 3;
        b[2 * i + 1] = u[0] * u[1] * u[2] - (u[0] + u[1] + u[2]) / 12;
    }
    batten_curve *curve = NULL;
    batten_implicit *f = NULL;
    batten_implicit_from_curve_report report;
    batten_trace trace = {{0, NULL}, 0, NULL};
    double u;
    CHECK_OK(shape_bezier(2, 3, b, &curve));
    CHECK_OK(batten_implicit_from_curve(curve, &report, &f));
    const batten_box window = {{-0.5, -1, 0}, {1.2, 1.1, 0}};
    CHECK_OK(batten_implicit_trace(f, window, 61, 1e-5, &trace));
    CHECK_INT(trace.singular_count, 1);
    CHECK_NEAR(trace.singular[0].x, 0.25, 1e-9);
    CHECK_NEAR(trace.singular[0].y, 0, 1e-9);
    CHECK_INT(trace.singular[0].kind, BATTEN_SINGULAR_CROSSING);
    CHECK(trace.lines.count >= 1);
    int count = 0;
    for (int i = 0; i < trace.lines.count; i++)
        for (int k = 0; k < trace.lines.lines[i].count; k++, count++) {
            const double *p = trace.lines.lines[i].points + 3 * k;
            const double e = p[1] * p[1] - p[0] * (p[0] - 0.25) * (p[0] - 0.25);
            const double gx = (p[0] - 0.25) * (3 * p[0] - 0.25), gy = 2 * p[1];
            CHECK(fabs(e) <= 1e-7 * hypot(gx, gy) + 1e-9);
            CHECK(p[2] == 0);
        }
    CHECK(count > 100);
    CHECK_STATUS(batten_implicit_invert(f, 0.25, 0, &u), BATTEN_SINGULAR_HERE);
    batten_trace_release(&trace);
    batten_implicit_free(f);
    batten_curve_unref(curve);
}

/* ---- fields ---- */

typedef struct {
    int kind;
} field;

static double value(const void *context, double x, double y, double *g)
{
    switch (((const field *)context)->kind) {
    case 0: /* two circles about the origin, of radii 1 and sqrt(5) */
        g[0] = 2 * x * (2 * (x * x + y * y) - 6);
        g[1] = 2 * y * (2 * (x * x + y * y) - 6);
        return (x * x + y * y - 1) * (x * x + y * y - 5);
    case 1: /* a cusp */
        g[0] = -3 * x * x;
        g[1] = 2 * y;
        return y * y - x * x * x;
    case 2: /* a point alone, and a branch */
        g[0] = -3 * x * x + 2 * x;
        g[1] = 2 * y;
        return y * y - x * x * x + x * x;
    default: /* two lines that cross */
        g[0] = y;
        g[1] = x;
        return x * y;
    }
}

TEST(circles_are_traced_as_loops_within_the_tolerance)
{
    const field circles = {0};
    const batten_box window = {{-3, -2.9, 0}, {3.1, 3, 0}};
    batten_trace trace = {{0, NULL}, 0, NULL};
    CHECK_OK(batten_trace_field(value, &circles, window, 40, 1e-4, &trace));
    CHECK_INT(trace.lines.count, 2);
    CHECK_INT(trace.singular_count, 0);
    for (int i = 0; i < 2; i++) {
        const batten_polyline *l = &trace.lines.lines[i];
        double length = 0, radius = hypot(l->points[0], l->points[1]);
        CHECK(l->closed);
        CHECK_NEAR(radius * radius < 3 ? radius : radius / sqrt(5), 1, 1e-9);
        for (int k = 0; k + 1 < l->count; k++) {
            const double *a = l->points + 3 * k, *b = a + 3;
            CHECK_NEAR(hypot(b[0], b[1]), radius, 1e-6);
            CHECK(hypot((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) >= radius - 1e-4);
            length += hypot(b[0] - a[0], b[1] - a[1]);
        }
        CHECK_NEAR(length, 2 * PI * radius, 2e-3);
        CHECK_NEAR(l->points[0], l->points[3 * (l->count - 1)], 1e-9);
    }
    batten_trace_release(&trace);
}

TEST(singular_points_are_flagged_with_their_kind)
{
    static const struct {
        int kind, found;
    } rows[] = {{1, BATTEN_SINGULAR_CUSP},
                {2, BATTEN_SINGULAR_ISOLATED},
                {3, BATTEN_SINGULAR_CROSSING}};
    for (int i = 0; i < COUNT(rows); i++) {
        const field f = {rows[i].kind};
        const batten_box window = {{-1.03, -1.1, 0}, {2, 1.21, 0}};
        batten_trace trace = {{0, NULL}, 0, NULL};
        CHECK_OK(batten_trace_field(value, &f, window, 50, 1e-3, &trace));
        CHECK_INT(trace.singular_count, 1);
        CHECK_NEAR(trace.singular[0].x, 0, rows[i].found == BATTEN_SINGULAR_CUSP ? 1e-3 : 1e-9);
        CHECK_NEAR(trace.singular[0].y, 0, 1e-9);
        CHECK_INT(trace.singular[0].kind, rows[i].found);
        CHECK(trace.lines.count >= 1);
        batten_trace_release(&trace);
    }
}

/* Nearly two lines beside each other, 1e-7 apart: corrected points may jump between them. */
static double beside(const void *context, double x, double y, double *g)
{
    const double h = *(const double *)context, a = y - 0.3 * x, b = a - h * cos(40 * x);
    g[0] = -0.3 * b + a * (-0.3 + 40 * h * sin(40 * x));
    g[1] = a + b;
    return a * b;
}

TEST(branches_closer_than_the_grid_end_the_work)
{
    const double apart[] = {1e-1, 1e-3, 1e-5, 1e-7, 0};
    for (int i = 0; i < COUNT(apart); i++) {
        const batten_box window = {{-1, -1, 0}, {1, 1.1, 0}};
        batten_trace trace = {{0, NULL}, 0, NULL};
        CHECK_OK(batten_trace_field(beside, &apart[i], window, 30, 1e-6, &trace));
        for (int k = 0; k < trace.lines.count; k++)
            for (int j = 0; j < trace.lines.lines[k].count; j++) {
                double g[2];
                const double *p = trace.lines.lines[k].points + 3 * j;
                CHECK(fabs(beside(&apart[i], p[0], p[1], g)) <= 1e-6);
            }
        batten_trace_release(&trace);
    }
}

static double broken(const void *context, double x, double y, double *g)
{
    (void)context;
    g[0] = g[1] = 1;
    return x > 0.5 ? NAN : x + y;
}

TEST(N6_equations_that_cannot_be_are_refused)
{
    const double twice[10] = {1, 1, 0, -1, -1 / 3.0, 1, 0, -1, 1, 1}; /* s^2, s^4 */
    const double high[20] = {0, 0, 1, 1, 2, -1, 3, 1, 4, -1, 5, 2, 6, -3, 7, 1, 8, 0, 9, 1};
    const double zeros[4] = {1, 1, 1, 1};
    batten_curve *curve = NULL, *space = NULL, *point = NULL, *long_one = NULL, *spans = NULL;
    batten_implicit *f = NULL;
    batten_trace trace = {{7, NULL}, 0, NULL};
    CHECK_OK(shape_bezier(2, 4, twice, &curve));
    CHECK_STATUS(batten_implicit_from_curve(curve, NULL, &f), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("run over more than once");
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_STATUS(batten_implicit_from_curve(space, NULL, &f), BATTEN_NOT_COMPATIBLE);
    CHECK_OK(shape_bezier(2, 1, zeros, &point));
    CHECK_STATUS(batten_implicit_from_curve(point, NULL, &f), BATTEN_COINCIDENT);
    CHECK_OK(shape_bezier(2, 9, high, &long_one));
    CHECK_STATUS(batten_implicit_from_curve(long_one, NULL, &f), BATTEN_UNSUPPORTED);
    CHECK_OK(batten_curve_insert_knot(curve, 0.5, 1, &spans));
    CHECK_STATUS(batten_implicit_from_curve(spans, NULL, &f), BATTEN_NOT_COMPATIBLE);
    CHECK(f == NULL);
    const field circles = {0};
    const batten_box good = {{0, 0, 0}, {1, 1, 0}}, flat = {{0, 0, 0}, {1, 0, 0}};
    const batten_box nothing = {{0, NAN, 0}, {1, 1, 0}};
    CHECK_STATUS(batten_trace_field(value, &circles, flat, 10, 1, &trace), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_trace_field(value, &circles, nothing, 10, 1, &trace),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_trace_field(value, &circles, good, 1, 1, &trace), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_trace_field(value, &circles, good, 9, 0, &trace), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_trace_field(broken, NULL, good, 10, 1, &trace), BATTEN_NOT_FINITE);
    CHECK_INT(trace.lines.count, 7);
    batten_curve_unref(spans);
    batten_curve_unref(long_one);
    batten_curve_unref(point);
    batten_curve_unref(space);
    batten_curve_unref(curve);
}
