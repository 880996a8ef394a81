#include <batten/arcs.h>
#include <batten/curvature.h>
#include <batten/measure.h>

#include "support/test.h"

/* Signed curvature at u from one side. */
static double curvature_at(const batten_curve *curve, double u, batten_side side)
{
    batten_curve_local local = {.curvature = 0};
    CHECK_OK(batten_curve_local_at(curve, u, side, &local));
    return local.curvature;
}

/* Points of the conic (a cos, b sin), or of the hyperbola (a cosh, b sinh), with directions and
 * curvatures. */
static void conic(bool hyperbola, double a, double b, int count, double from, double to,
                  double *points, double *tangents, double *curvatures)
{
    for (int i = 0; i < count; i++) {
        const double t = from + (to - from) * i / (count - 1);
        const double c = hyperbola ? cosh(t) : cos(t), s = hyperbola ? sinh(t) : sin(t);
        points[2 * i] = a * c;
        points[2 * i + 1] = b * s;
        tangents[2 * i] = hyperbola ? a * s : -a * s;
        tangents[2 * i + 1] = b * c;
        curvatures[i] =
            (hyperbola ? -1 : 1) * a * b / pow(hypot(tangents[2 * i], tangents[2 * i + 1]), 3);
    }
}

/* How far the curve is from x^2 / a^2 +- y^2 / b^2 = 1, in the values of the form. */
static double off_conic(const batten_curve *curve, bool hyperbola, double a, double b)
{
    const batten_interval domain = batten_curve_domain(curve);
    double most = 0;
    for (int i = 0; i <= 1000; i++) {
        double at[2];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 1000, 0, at));
        const double x = at[0] / a, y = at[1] / b;
        most = fmax(most, fabs(x * x + (hyperbola ? -y * y : y * y) - 1));
    }
    return most;
}

TEST(data_of_one_conic_give_that_conic)
{
    static const struct {
        bool hyperbola;
        double a, b, from, to;
    } rows[] = {
        {false, 3, 3, 0.2, 1.9}, {false, 2, 1, 0.4, 3}, {true, 1, 0.6, -0.9, 1.2},
        {false, 1, 5, -1, 0.9},  {true, 2, 3, 0.2, 1},
    };
    double points[8], tangents[8], curvatures[4];
    for (int i = 0; i < COUNT(rows); i++)
        for (int count = 2; count <= 4; count++) {
            conic(rows[i].hyperbola, rows[i].a, rows[i].b, count, rows[i].from, rows[i].to,
                  points, tangents, curvatures);
            batten_curve_conics_options options = batten_curve_conics_defaults();
            options.tangents = tangents;
            options.curvatures = curvatures;
            batten_curve *curve = NULL;
            batten_curve_conics_report report;
            CHECK_OK(batten_curve_conics((batten_points){2, count, points}, &options, NULL,
                                         &report, &curve));
            CHECK(off_conic(curve, rows[i].hyperbola, rows[i].a, rows[i].b) < 1e-12);
            CHECK(report.jump < 1e-11);
            CHECK_INT(report.fallen_back + report.arcs + report.inflections, 0);
            batten_curve_unref(curve);
        }
}

/* Section 9: of a circle of arc angle 2 f both pieces are circular when both shares are
 * tan(f / 2) / tan f, and only then. */
TEST(a_circle_has_its_shares)
{
    const double f = 0.7, points[] = {cos(f), -sin(f), cos(f), sin(f)};
    const double tangents[] = {sin(f), cos(f), -sin(f), cos(f)}, curvatures[] = {1, 1};
    batten_curve_conics_options options = batten_curve_conics_defaults();
    options.tangents = tangents;
    options.curvatures = curvatures;
    for (int k = 0; k < 2; k++) {
        options.start_share = options.end_share = tan(f / 2) / tan(f) + 0.05 * k;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_conics((batten_points){2, 2, points}, &options, NULL, NULL, &curve));
        const double off = off_conic(curve, false, 1, 1);
        CHECK(k == 0 ? off < 1e-14 : off > 1e-5);
        /* Round or not, curvature is given at the ends and continuous in the middle. */
        CHECK_NEAR(curvature_at(curve, 0, BATTEN_FROM_RIGHT), 1, 1e-13);
        double middle[3];
        CHECK_INT(batten_curve_spans(curve, middle), 3);
        CHECK_NEAR(curvature_at(curve, middle[1], BATTEN_FROM_LEFT),
                   curvature_at(curve, middle[1], BATTEN_FROM_RIGHT), 1e-12);
        batten_curve_unref(curve);
    }
}

/* Section 9: the join is G2, with the curvature (k0^(1/3) a + k3^(1/3) b)^3 / |A - B|^3. */
TEST(a_pair_has_the_curvatures_that_were_asked_for)
{
    const double points[] = {0, 0, 4, 0}, tangents[] = {1, 1.5, 1, -0.8};
    const double curvatures[] = {-0.7, -0.25};
    batten_curve_conics_options options = batten_curve_conics_defaults();
    options.tangents = tangents;
    options.curvatures = curvatures;
    for (int k = 0; k < 3; k++) {
        options.start_share = k * 0.3;
        options.end_share = k * 0.4;
        batten_curve *curve = NULL;
        double u[3];
        CHECK_OK(
            batten_curve_conics((batten_points){2, 2, points}, &options, NULL, NULL, &curve));
        CHECK_INT(batten_curve_spans(curve, u), 3);
        CHECK_NEAR(curvature_at(curve, u[0], BATTEN_FROM_RIGHT), -0.7, 1e-13);
        CHECK_NEAR(curvature_at(curve, u[2], BATTEN_FROM_LEFT), -0.25, 1e-13);
        const double *P = batten_curve_points(curve);
        const double a = hypot(P[2], P[3]), b = hypot(4 - P[6], P[7]);
        const double l = hypot(P[6] - P[2], P[7] - P[3]);
        const double wanted = -pow((cbrt(0.7) * a + cbrt(0.25) * b) / l, 3);
        CHECK_NEAR(curvature_at(curve, u[1], BATTEN_FROM_LEFT), wanted, 1e-12);
        CHECK_NEAR(curvature_at(curve, u[1], BATTEN_FROM_RIGHT), wanted, 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(parabolas_are_the_quadratic_spline_with_a_knot_in_the_middle)
{
    /* The tangents meet in (1, 2). */
    const double points[] = {0, 0, 3, 1}, tangents[] = {1, 2, 2, -1};
    const double control[] = {0, 0, 0.5, 1, 2, 1.5, 3, 1}, knots[] = {0, 0, 0, 0.5, 1, 1, 1};
    batten_curve_conics_options options = batten_curve_conics_defaults();
    options.kind = BATTEN_CONICS_PARABOLAS;
    options.tangents = tangents;
    batten_curve *curve = NULL, *spline = NULL;
    double u[3];
    CHECK_OK(batten_curve_conics((batten_points){2, 2, points}, &options, NULL, NULL, &curve));
    CHECK_OK(batten_curve_create((batten_points){2, 4, control}, 2, NULL, knots, &spline));
    CHECK_INT(batten_curve_spans(curve, u), 3);
    for (int i = 0; i <= 20; i++) {
        const double t = i / 20.0;
        double at[2], on[2];
        const double v =
            t < 0.5 ? u[0] + 2 * t * (u[1] - u[0]) : u[1] + (2 * t - 1) * (u[2] - u[1]);
        CHECK_OK(batten_curve_evaluate(curve, v, 0, at));
        CHECK_OK(batten_curve_evaluate(spline, t, 0, on));
        CHECK_NEAR(at[0], on[0], 1e-14);
        CHECK_NEAR(at[1], on[1], 1e-14);
    }
    batten_curve_unref(curve);
    batten_curve_unref(spline);
}

/* A logarithmic spiral, which no conic is, with directions and curvatures. */
TEST(smooth_curves_are_met_with_orders_five_and_four)
{
    static const double orders[] = {5, 4};
    for (int kind = 0; kind < 2; kind++) {
        double errors[3];
        for (int r = 0; r < 3; r++) {
            const int n = (4 << r) + 1;
            double points[34], tangents[34], curvatures[17], most = 0;
            for (int i = 0; i < n; i++) {
                const double t = 2.0 * i / (n - 1), e = exp(0.4 * t);
                points[2 * i] = e * cos(t);
                points[2 * i + 1] = e * sin(t);
                tangents[2 * i] = 0.4 * cos(t) - sin(t);
                tangents[2 * i + 1] = 0.4 * sin(t) + cos(t);
                curvatures[i] = 1 / e / sqrt(1.16);
            }
            batten_curve_conics_options options = batten_curve_conics_defaults();
            options.kind = kind == 0 ? BATTEN_CONICS_PAIRS : BATTEN_CONICS_SINGLE;
            options.tangents = tangents;
            options.curvatures = curvatures;
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_conics((batten_points){2, n, points}, &options, NULL, NULL,
                                         &curve));
            for (int i = 0; i <= 4000; i++) {
                double at[2];
                const double end = batten_curve_domain(curve).b;
                CHECK_OK(batten_curve_evaluate(curve, end * i / 4000, 0, at));
                const double t = atan2(at[1], at[0]);
                most = fmax(most, fabs(hypot(at[0], at[1]) - exp(0.4 * t)));
            }
            errors[r] = most;
            batten_curve_unref(curve);
        }
        for (int r = 0; r < 2; r++)
            CHECK_NEAR(log2(errors[r] / errors[r + 1]), orders[kind], 0.4);
    }
}

/* An S: the joint lies on the chord, the tangent is continuous there, and curvature changes its
 * sign in a jump. */
TEST(a_span_that_bends_to_both_sides_is_cut_on_its_chord)
{
    const double points[] = {0, 0, 2, 0}, tangents[] = {1, 0.6, 1, 0.3};
    const double curvatures[] = {-1, 0.8};
    for (int kind = 0; kind < 3; kind++) {
        batten_curve_conics_options options = batten_curve_conics_defaults();
        options.kind = (batten_conics_kind)kind;
        options.tangents = tangents;
        options.curvatures = curvatures;
        batten_curve_conics_report report;
        batten_curve *curve = NULL;
        double u[3], before[4], after[4];
        CHECK_OK(batten_curve_conics((batten_points){2, 2, points}, &options, NULL, &report,
                                     &curve));
        CHECK_INT(report.inflections, 1);
        CHECK_INT(batten_curve_spans(curve, u), 3);
        CHECK_OK(batten_curve_evaluate_side(curve, u[1], BATTEN_FROM_LEFT, 1, before));
        CHECK_OK(batten_curve_evaluate_side(curve, u[1], BATTEN_FROM_RIGHT, 1, after));
        CHECK_NEAR(before[1], 0, 1e-15);
        CHECK_NEAR(before[2] * after[3] - before[3] * after[2], 0, 1e-14);
        CHECK(curvature_at(curve, u[1], BATTEN_FROM_LEFT) < 0);
        CHECK(curvature_at(curve, u[1], BATTEN_FROM_RIGHT) > 0);
        if (kind == BATTEN_CONICS_PAIRS) {
            CHECK_NEAR(curvature_at(curve, u[0], BATTEN_FROM_RIGHT), -1, 1e-13);
            CHECK_NEAR(curvature_at(curve, u[2], BATTEN_FROM_LEFT), 0.8, 1e-13);
        }
        batten_curve_unref(curve);
    }
}

TEST(g2_points_of_a_circle_give_the_circle_and_of_a_line_the_line)
{
    double ring[14], line[10];
    static const double at[] = {0, 0.9, 1.5, 2.7, 3.9, 4.2, 5.5};
    for (int i = 0; i < 7; i++) {
        ring[2 * i] = 3 * cos(at[i]);
        ring[2 * i + 1] = 3 * sin(at[i]);
    }
    for (int i = 0; i < 5; i++) {
        line[2 * i] = 0.1 * i * i;
        line[2 * i + 1] = 1 + 0.3 * i * i;
    }
    for (int kind = 0; kind < 3; kind++) {
        batten_curve_conics_options options = batten_curve_conics_defaults();
        batten_curve *curve = NULL;
        batten_curve_conics_report report;
        double parameters[8];
        options.kind = (batten_conics_kind)kind;
        options.closed = true;
        CHECK_OK(batten_curve_conics((batten_points){2, 7, ring}, &options, parameters, &report,
                                     &curve));
        if (kind != BATTEN_CONICS_PARABOLAS)
            CHECK(off_conic(curve, false, 3, 3) < 1e-13 && report.jump < 1e-13);
        for (int i = 0; i < 7; i++) {
            double point[2];
            CHECK_OK(batten_curve_evaluate(curve, parameters[i], 0, point));
            CHECK_NEAR(point[0], ring[2 * i], 1e-14);
            CHECK_NEAR(point[1], ring[2 * i + 1], 1e-14);
        }
        CHECK(batten_curve_is_closed(curve, 1e-14));
        batten_curve_unref(curve);
        options.closed = false;
        for (int count = 2; count <= 5; count += 3) {
            double length = 0;
            CHECK_OK(batten_curve_conics((batten_points){2, count, line}, &options, NULL,
                                         &report, &curve));
            CHECK_OK(batten_curve_length(curve, 1e-12, NULL, &length));
            CHECK_NEAR(length, hypot(line[2 * count - 2], line[2 * count - 1] - 1), 1e-12);
            CHECK_NEAR(report.jump, 0, 1e-12);
            batten_curve_unref(curve);
        }
    }
}

TEST(tangents_that_do_not_meet_get_arcs)
{
    /* Both arcs of the first turn by more than 120 degrees; the second begins along its chord.
     */
    const double points[] = {0, 0, 2, 0};
    static const double tangents[][4] = {{-1, 0.3, -1, -0.3}, {1, 0, 1, 1}, {0, 1, 0, -1}};
    for (int i = 0; i < COUNT(tangents); i++) {
        batten_curve_conics_options options = batten_curve_conics_defaults();
        batten_curve_conics_report report;
        batten_curve *curve = NULL;
        options.tangents = tangents[i];
        options.kind = BATTEN_CONICS_SINGLE;
        CHECK_OK(batten_curve_conics((batten_points){2, 2, points}, &options, NULL, &report,
                                     &curve));
        CHECK_INT(report.arcs, 1);
        CHECK_INT(report.first_arcs, 0);
        double at[4];
        for (int k = 0; k < 2; k++) {
            CHECK_OK(batten_curve_evaluate(curve, k * batten_curve_domain(curve).b, 1, at));
            CHECK_NEAR(at[0], 2 * k, 0);
            const double *T = tangents[i] + 2 * k;
            CHECK_NEAR(at[2] * T[1] - at[3] * T[0], 0, 1e-13 * hypot(at[2], at[3]));
            CHECK(at[2] * T[0] + at[3] * T[1] > 0);
        }
        CHECK(curvature_at(curve, 0, BATTEN_FROM_RIGHT) != 0);
        batten_curve_unref(curve);
    }
}

TEST(curvatures_against_the_tangents_are_left_out_and_named)
{
    const double points[] = {0, 0, 1, 0.6, 2, 0.7, 3, 0.2};
    const double curvatures[] = {-1, 0.5, -1, -1};
    batten_curve_conics_options options = batten_curve_conics_defaults();
    batten_curve_conics_report report;
    batten_curve *curve = NULL;
    options.curvatures = curvatures;
    CHECK_OK(
        batten_curve_conics((batten_points){2, 4, points}, &options, NULL, &report, &curve));
    CHECK_INT(report.fallen_back, 2);
    CHECK_INT(report.first_fallen_back, 0);
    CHECK(report.jump > 0.1);
    batten_curve_unref(curve);
}

/* Turned, mirrored and scaled data give the curve turned, mirrored and scaled; data in the
 * other order the reversed curve. */
TEST(g10_conics_follow_their_points)
{
    const double points[] = {0, 0, 1, 0.6, 2, 0.2, 3, 0.3, 3.4, 1};
    double turned[10], back[10];
    for (int i = 0; i < 5; i++) {
        turned[2 * i] = 7 * points[2 * i + 1];
        turned[2 * i + 1] = 7 * points[2 * i];
        back[2 * i] = points[8 - 2 * i];
        back[2 * i + 1] = points[9 - 2 * i];
    }
    for (int kind = 0; kind < 3; kind++) {
        batten_curve_conics_options options = batten_curve_conics_defaults();
        batten_curve *curve = NULL, *mirrored = NULL, *reversed = NULL;
        options.kind = (batten_conics_kind)kind;
        CHECK_OK(
            batten_curve_conics((batten_points){2, 5, points}, &options, NULL, NULL, &curve));
        CHECK_OK(batten_curve_conics((batten_points){2, 5, turned}, &options, NULL, NULL,
                                     &mirrored));
        CHECK_OK(
            batten_curve_conics((batten_points){2, 5, back}, &options, NULL, NULL, &reversed));
        const double end = batten_curve_domain(curve).b;
        CHECK_NEAR(batten_curve_domain(reversed).b, end, 1e-13);
        for (int i = 0; i <= 40; i++) {
            double at[2], other[2], from[2];
            CHECK_OK(batten_curve_evaluate(curve, end * i / 40, 0, at));
            const double far = batten_curve_domain(mirrored).b;
            CHECK_OK(batten_curve_evaluate(mirrored, far * i / 40, 0, other));
            CHECK_OK(batten_curve_evaluate(
                reversed, batten_curve_domain(reversed).b * (40 - i) / 40, 0, from));
            CHECK_NEAR(other[0], 7 * at[1], 1e-12);
            CHECK_NEAR(other[1], 7 * at[0], 1e-12);
            CHECK_NEAR(from[0], at[0], 1e-12);
            CHECK_NEAR(from[1], at[1], 1e-12);
        }
        batten_curve_unref(curve);
        batten_curve_unref(mirrored);
        batten_curve_unref(reversed);
    }
}

TEST(n1_g1_bad_data_of_conics_are_refused)
{
    double points[] = {0, 0, 1, 1, 2, 0};
    double tangents[] = {1, 1, 1, 0, 1, -1}, curvatures[] = {1, 1, NAN};
    batten_curve *curve = NULL;
    batten_curve_conics_options options = batten_curve_conics_defaults();
    CHECK_STATUS(batten_curve_conics((batten_points){2, 1, points}, NULL, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    options.closed = true;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 2, points}, &options, NULL, NULL, &curve),
        BATTEN_TOO_FEW_POINTS);
    options.closed = false;
    options.curvatures = curvatures;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 3, points}, &options, NULL, NULL, &curve),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 3");
    options.curvatures = NULL;
    options.tangents = tangents;
    tangents[2] = tangents[3] = 0;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 3, points}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tangent at point 2");
    tangents[2] = INFINITY;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 3, points}, &options, NULL, NULL, &curve),
        BATTEN_NOT_FINITE);
    options.tangents = NULL;
    options.start_share = 1;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 3, points}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.start_share = 0;
    options.weight = -1;
    CHECK_STATUS(
        batten_curve_conics((batten_points){2, 3, points}, &options, NULL, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    points[2] = points[3] = 0;
    CHECK_STATUS(batten_curve_conics((batten_points){2, 3, points}, NULL, NULL, NULL, &curve),
                 BATTEN_COINCIDENT);
    points[3] = NAN;
    CHECK_STATUS(batten_curve_conics((batten_points){2, 3, points}, NULL, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    CHECK(!curve);
}

TEST(n2_conics_of_any_size_are_the_same)
{
    static const double sizes[] = {1, 1e-9, 1e9, 1e-100, 1e100};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double z = sizes[i],
                     points[] = {0, 0, z, 0.6 * z, 2 * z, 0.2 * z, 3 * z, 0.3 * z};
        batten_curve *curve = NULL;
        batten_curve_conics_report report;
        CHECK_OK(
            batten_curve_conics((batten_points){2, 4, points}, NULL, NULL, &report, &curve));
        CHECK_INT(report.inflections, 1);
        CHECK_INT(report.arcs + report.fallen_back, 0);
        CHECK_NEAR(report.jump * z, 0, 1e-13);
        batten_curve_unref(curve);
    }
}
