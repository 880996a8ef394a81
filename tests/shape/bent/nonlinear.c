#include <batten/bent.h>

#include "support/faults.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

/* What a family can. */
typedef struct {
    batten_span_family family;
    bool round; /* points of a circle give the circle */
    bool mock;  /* curvature is continuous only as long as angles are small */
} kind;

static const kind kinds[] = {
    {BATTEN_FAMILY_LOCAL_CUBIC, false, false}, {BATTEN_FAMILY_LOCAL_TENSION, false, false},
    {BATTEN_FAMILY_GEOMETRIC, true, false},    {BATTEN_FAMILY_EULER_SPIRAL, true, false},
    {BATTEN_FAMILY_ARCS, true, false},         {BATTEN_FAMILY_ELASTICA, false, false},
    {BATTEN_FAMILY_HOBBY, false, true},
};

static batten_chain *through(batten_span_family family, int count, const double *points,
                             bool closed, double *angles)
{
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = family;
    options.closed = closed;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, count, points}, &options, angles, NULL,
                                    NULL, &chain));
    return chain;
}

/* The integral of curvature^2 by arc length, by Simpson's rule on each span. */
static double energy_of(const batten_chain *chain)
{
    enum { STEPS = 400 };
    const double *breaks = batten_chain_breaks(chain);
    double sum = 0;
    for (int j = 0; j < batten_chain_span_count(chain); j++)
        for (int i = 0; i <= STEPS; i++) {
            const double h = (breaks[j + 1] - breaks[j]) / STEPS;
            double at[6];
            CHECK_OK(batten_chain_evaluate_side(
                chain, breaks[j] + i * h, i ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 2, at));
            const double speed = hypot(at[2], at[3]);
            const double k = (at[2] * at[5] - at[3] * at[4]) / (speed * speed * speed);
            sum += (i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2) * h / 3 * k * k * speed;
        }
    return sum;
}

static void wave(int count, double *points)
{
    for (int i = 0; i < count; i++) {
        const double t = (double)i + 0.2 * sin(3.0 * i);
        points[2 * i] = t;
        points[2 * i + 1] = 0.5 * sin(0.9 * t) + 0.02 * t * t;
    }
}

/* ---- published numbers ---- */

static const double arch[] = {0, 0, 1, 0.6, 2, 0.1};

TEST(the_euler_spiral_through_three_points_has_the_angles_of_the_notes)
{
    const double expected[] = {0.7950925, 0.0271845, -0.7073638};
    double angles[3];
    batten_chain *chain = through(BATTEN_FAMILY_EULER_SPIRAL, 3, arch, false, angles);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(angles[i], expected[i], 6e-8);
    CHECK_NEAR(energy_of(chain), 1.2848596, 6e-8);
    batten_chain_unref(chain);
}

TEST(the_mechanical_spline_through_three_points_has_the_energy_and_angles_of_the_notes)
{
    const double expected[] = {0.8000326, 0.0262808, -0.7108030};
    double angles[3];
    batten_chain *chain = through(BATTEN_FAMILY_ELASTICA, 3, arch, false, angles);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(angles[i], expected[i], 6e-8);
    CHECK_NEAR(energy_of(chain), 1.28447309, 6e-9);
    batten_chain_unref(chain);
}

TEST(the_geometric_spline_through_three_points_has_the_energy_and_angles_of_the_notes)
{
    const double expected[] = {0.7944714, 0.0270038, -0.7066551};
    double angles[3];
    batten_chain *chain = through(BATTEN_FAMILY_GEOMETRIC, 3, arch, false, angles);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(angles[i], expected[i], 6e-8);
    CHECK_NEAR(energy_of(chain), 1.2848377, 6e-8);
    batten_chain_unref(chain);
}

TEST(no_other_spline_through_the_points_bends_less_than_the_mechanical_one)
{
    double points[2 * 9], angles[9];
    wave(9, points);
    batten_chain *least = through(BATTEN_FAMILY_ELASTICA, 9, points, false, angles);
    for (int n = 0; n < COUNT(kinds); n++) {
        batten_chain *chain = through(kinds[n].family, 9, points, false, angles);
        CHECK(energy_of(chain) >= energy_of(least) * (1 - 1e-9));
        batten_chain_unref(chain);
    }
    batten_chain_unref(least);
}

TEST(points_of_a_circle_do_not_give_a_circle_of_the_mechanical_spline)
{
    const double at[] = {0, 0.9, 2.4, 3.1, 4.6};
    double points[10], angles[5], worst = 0;
    for (int i = 0; i < 5; i++) {
        points[2 * i] = cos(at[i]);
        points[2 * i + 1] = sin(at[i]);
    }
    batten_chain *chain = through(BATTEN_FAMILY_ELASTICA, 5, points, true, angles);
    for (int i = 0; i <= 100; i++) {
        double p[2];
        CHECK_OK(batten_chain_evaluate(chain, batten_chain_domain(chain).b * i / 100, 0, p));
        worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
    }
    CHECK(worst > 1e-3 && worst < 0.2);
    CHECK(energy_of(chain) < 2 * pi);
    batten_chain_unref(chain);
}

TEST(g9_points_without_a_mechanical_spline_name_the_span_and_what_to_use)
{
    const double points[] = {0, 0, 1, 0, 0.2, 0.3, 1.2, 0.3, 0.3, 0.6};
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = BATTEN_FAMILY_ELASTICA;
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 5, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("span ");
    CHECK_MESSAGE("an Euler spiral");
    CHECK(!chain);
}

/* ---- what holds for every family ---- */

TEST(nonlinear_splines_pass_the_points_and_curvature_is_continuous)
{
    double points[2 * 12];
    wave(12, points);
    for (int n = 0; n < COUNT(kinds); n++) {
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        options.family = kinds[n].family;
        double angles[12], at[12];
        batten_chain_nonlinear_report report;
        batten_chain *chain = NULL;
        CHECK_OK(batten_chain_nonlinear((batten_points){2, 12, points}, &options, angles, at,
                                        &report, &chain));
        CHECK(report.error <= 1e-12 * report.curvature);
        CHECK(report.steps <= (kinds[n].family == BATTEN_FAMILY_LOCAL_TENSION ? 20 : 6));
        for (int i = 0; i < 12; i++) {
            double left[6], right[6];
            CHECK_OK(batten_chain_evaluate_side(chain, at[i], BATTEN_FROM_LEFT, 2, left));
            CHECK_OK(batten_chain_evaluate_side(chain, at[i], BATTEN_FROM_RIGHT, 2, right));
            for (int c = 0; c < 2; c++) {
                CHECK_NEAR(left[c], points[2 * i + c], 1e-12);
                CHECK_NEAR(right[c], points[2 * i + c], 1e-12);
            }
            const double l = hypot(left[2], left[3]), r = hypot(right[2], right[3]);
            CHECK_NEAR(right[2] / r, cos(angles[i]), 1e-11);
            CHECK_NEAR(left[3] / l, sin(angles[i]), 1e-11);
            CHECK_NEAR((left[2] * left[5] - left[3] * left[4]) / (l * l * l),
                       (right[2] * right[5] - right[3] * right[4]) / (r * r * r),
                       kinds[n].mock ? 0.1 : 1e-10);
        }
        batten_chain_unref(chain);
    }
}

/* The angles after the points were reversed, turned, mirrored, scaled. */
TEST(g10_nonlinear_splines_follow_every_change_that_keeps_shapes)
{
    enum { N = 9 };
    double points[2 * N], changed[2 * N], angles[N], other[N];
    wave(N, points);
    for (int n = 0; n < COUNT(kinds); n++) {
        batten_chain_unref(through(kinds[n].family, N, points, false, angles));
        for (int i = 0; i < N; i++) {
            changed[2 * i] = points[2 * (N - 1 - i)];
            changed[2 * i + 1] = points[2 * (N - 1 - i) + 1];
        }
        batten_chain_unref(through(kinds[n].family, N, changed, false, other));
        for (int i = 0; i < N; i++)
            CHECK_NEAR(remainder(other[i] - angles[N - 1 - i] - pi, 2 * pi), 0, 1e-11);
        for (int i = 0; i < N; i++) {
            const double x = points[2 * i], y = points[2 * i + 1];
            changed[2 * i] = 1e3 * (cos(2.0) * x - sin(2.0) * y) + 50;
            changed[2 * i + 1] = 1e3 * (sin(2.0) * x + cos(2.0) * y) - 70;
        }
        batten_chain_unref(through(kinds[n].family, N, changed, false, other));
        for (int i = 0; i < N; i++)
            CHECK_NEAR(remainder(other[i] - angles[i] - 2, 2 * pi), 0, 1e-11);
        for (int i = 0; i < N; i++) {
            changed[2 * i] = 1e-4 * points[2 * i];
            changed[2 * i + 1] = -1e-4 * points[2 * i + 1];
        }
        batten_chain_unref(through(kinds[n].family, N, changed, false, other));
        for (int i = 0; i < N; i++)
            CHECK_NEAR(other[i], -angles[i], 1e-11);
    }
}

TEST(g2_points_of_a_line_give_the_line)
{
    const double points[] = {1, 1, 2, 3, 2.5, 4, 6, 11}, pair[] = {0, 0, 3, -1};
    for (int n = 0; n < COUNT(kinds); n++) {
        double angles[4];
        batten_chain *chain = through(kinds[n].family, 4, points, false, angles);
        for (int i = 0; i < 4; i++)
            CHECK_NEAR(angles[i], atan2(2, 1), 4e-16);
        const batten_interval domain = batten_chain_domain(chain);
        for (int i = 0; i <= 20; i++) {
            double at[2];
            CHECK_OK(
                batten_chain_evaluate(chain, domain.a + (domain.b - domain.a) * i / 20, 0, at));
            CHECK_NEAR(at[1], 2 * at[0] - 1, 1e-14);
        }
        batten_chain_unref(chain);
        chain = through(kinds[n].family, 2, pair, false, angles);
        CHECK_NEAR(angles[0], atan2(-1, 3), 2e-16);
        CHECK_NEAR(angles[1], atan2(-1, 3), 2e-16);
        batten_chain_unref(chain);
    }
}

TEST(g2_points_of_a_circle_give_the_circle)
{
    const double at[] = {0, 0.3, 0.9, 1.1, 1.9, 2.4, 3.6, 5};
    enum { N = COUNT(at) };
    double points[2 * N], angles[N];
    for (int i = 0; i < N; i++) {
        points[2 * i] = 5 + 2 * cos(at[i]);
        points[2 * i + 1] = 2 * sin(at[i]);
    }
    for (int n = 0; n < COUNT(kinds); n++) {
        if (!kinds[n].round)
            continue;
        batten_chain *chain = through(kinds[n].family, N, points, true, angles);
        const batten_interval domain = batten_chain_domain(chain);
        CHECK(batten_chain_is_closed(chain));
        if (kinds[n].family != BATTEN_FAMILY_GEOMETRIC) /* goes by abscissae */
            CHECK_NEAR(domain.b - domain.a, 4 * pi, 1e-12);
        for (int i = 0; i < N; i++)
            CHECK_NEAR(angles[i], at[i] + pi / 2, 1e-12);
        for (int i = 0; i <= 50; i++) {
            double p[2];
            CHECK_OK(
                batten_chain_evaluate(chain, domain.a + (domain.b - domain.a) * i / 50, 0, p));
            CHECK_NEAR(hypot(p[0] - 5, p[1]), 2, 1e-12);
        }
        batten_chain_unref(chain);
    }
}

TEST(an_euler_spiral_through_one_more_of_its_points_is_the_same)
{
    enum { N = 8 };
    double points[2 * N], more[2 * N + 2], angles[N], others[N + 1], at[N];
    wave(N, points);
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_nonlinear((batten_points){2, N, points}, NULL, angles, at, NULL, &chain));
    for (int j = 0; j + 1 < N; j++) {
        double between[4];
        CHECK_OK(batten_chain_evaluate(chain, 0.6 * at[j] + 0.4 * at[j + 1], 1, between));
        memcpy(more, points, sizeof(double) * 2 * (size_t)(j + 1));
        memcpy(more + 2 * j + 2, between, sizeof(double) * 2);
        memcpy(more + 2 * j + 4, points + 2 * j + 2, sizeof(double) * 2 * (size_t)(N - j - 1));
        batten_chain_unref(through(BATTEN_FAMILY_EULER_SPIRAL, N + 1, more, false, others));
        for (int i = 0; i <= N; i++)
            CHECK_NEAR(others[i],
                       i <= j       ? angles[i]
                       : i == j + 1 ? atan2(between[3], between[2])
                                    : angles[i - 1],
                       1e-11);
    }
    batten_chain_unref(chain);
}

/* ---- local cubics, with and without tension ---- */

/* `count` points at equal steps on the upper half of the unit circle, with circular ends. */
static batten_chain *half_circle(batten_span_family family, int count, double *angles)
{
    double points[2 * 33];
    for (int i = 0; i < count; i++) {
        points[2 * i] = cos(pi * i / (count - 1));
        points[2 * i + 1] = sin(pi * i / (count - 1));
    }
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = family;
    options.start = options.end = BATTEN_NONLINEAR_CIRCULAR;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, count, points}, &options, angles, NULL,
                                    NULL, &chain));
    return chain;
}

TEST(local_cubics_through_a_circle_have_its_tangents_and_a_known_curvature)
{
    for (int n = 4; n <= 32; n *= 2) {
        double angles[33], at[6];
        batten_chain *chain = half_circle(BATTEN_FAMILY_LOCAL_CUBIC, n + 1, angles);
        for (int i = 0; i <= n; i++)
            CHECK_NEAR(angles[i], pi / 2 + pi * i / n, 4e-15);
        CHECK_OK(batten_chain_evaluate(chain, batten_chain_domain(chain).a, 2, at));
        const double k = (at[2] * at[5] - at[3] * at[4]) / pow(hypot(at[2], at[3]), 3);
        CHECK_NEAR(k, cos(pi / (2 * n)) * cos(pi / (2 * n)), 1e-13);
        if (n == 8)
            CHECK_NEAR(k, 0.9619398, 5e-8);
        if (n == 32)
            CHECK_NEAR(k, 0.9975924, 5e-8);
        batten_chain_unref(chain);
    }
}

TEST(the_local_cubic_of_small_deflections_is_the_natural_cubic_spline)
{
    /* Slopes of the natural cubic spline through y at 0, 1, 2, 3. */
    const double y[] = {0, 1, 0.4, 0}, slopes[] = {1.44, 0.12, -0.72, -0.24};
    CHECK_NEAR(2 * slopes[0] + slopes[1], 3 * (y[1] - y[0]), 1e-15);
    CHECK_NEAR(slopes[0] + 4 * slopes[1] + slopes[2], 3 * (y[2] - y[0]), 1e-15);
    CHECK_NEAR(slopes[1] + 4 * slopes[2] + slopes[3], 3 * (y[3] - y[1]), 1e-15);
    CHECK_NEAR(slopes[2] + 2 * slopes[3], 3 * (y[3] - y[2]), 1e-15);
    double before = 0;
    for (double h = 1e-2; h > 1e-4; h /= 10) {
        double points[8], angles[4], worst = 0;
        for (int i = 0; i < 4; i++) {
            points[2 * i] = i;
            points[2 * i + 1] = h * y[i];
        }
        batten_chain_unref(through(BATTEN_FAMILY_LOCAL_CUBIC, 4, points, false, angles));
        for (int i = 0; i < 4; i++)
            worst = fmax(worst, fabs(tan(angles[i]) / h - slopes[i]));
        CHECK(worst < 20 * h * h);
        before = worst;
    }
    CHECK(before < 1e-5);
}

TEST(local_splines_without_tension_are_local_cubics)
{
    enum { N = 7 };
    const double none[N] = {0};
    double points[2 * N], cubic[N], tension[N];
    wave(N, points);
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = BATTEN_FAMILY_LOCAL_TENSION;
    options.tensions = none;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, N, points}, &options, tension, NULL,
                                    NULL, &chain));
    batten_chain_unref(chain);
    batten_chain_unref(through(BATTEN_FAMILY_LOCAL_CUBIC, N, points, false, cubic));
    for (int i = 0; i < N; i++)
        CHECK_BITS(tension[i], cubic[i]);
}

TEST(tensions_that_cannot_be_are_named_from_1)
{
    enum { N = 5 };
    static const struct {
        double tensions[N - 1];
        batten_status status;
        const char *words;
    } rows[] = {{{0, 1, NAN, -1}, BATTEN_NOT_FINITE, "tension 3 is nan"},
                {{-0.5, 1, 1, 1}, BATTEN_BAD_ARGUMENT, "tension 1 is -0.5, below 0"},
                {{0, 1, 2, -3}, BATTEN_BAD_ARGUMENT, "tension 4 is -3, below 0"}};
    double points[2 * N];
    wave(N, points);
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = BATTEN_FAMILY_LOCAL_TENSION;
    batten_chain *chain = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        options.tensions = rows[i].tensions;
        CHECK_STATUS(batten_chain_nonlinear((batten_points){2, N, points}, &options, NULL, NULL,
                                            NULL, &chain),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
    CHECK(!chain);
}

TEST(local_splines_in_much_tension_are_the_polygon)
{
    enum { N = 6 };
    double points[2 * N], tensions[N], length = 0;
    wave(N, points);
    for (int i = 0; i < N; i++) {
        tensions[i] = 1e4;
        if (i > 0)
            length +=
                hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
    }
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = BATTEN_FAMILY_LOCAL_TENSION;
    options.tensions = tensions;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, N, points}, &options, NULL, NULL, NULL,
                                    &chain));
    const double *breaks = batten_chain_breaks(chain);
    for (int j = 0; j + 1 < N; j++)
        for (int i = 0; i <= 10; i++) {
            double at[2];
            CHECK_OK(batten_chain_evaluate(
                chain, breaks[j] + (breaks[j + 1] - breaks[j]) * i / 10, 0, at));
            for (int c = 0; c < 2; c++)
                CHECK_NEAR(at[c],
                           points[2 * j + c] +
                               (points[2 * j + 2 + c] - points[2 * j + c]) * i / 10,
                           1e-4);
        }
    CHECK_NEAR(breaks[N - 1] - breaks[0], length, 1e-12);
    batten_chain_unref(chain);
}

TEST(tension_that_is_chosen_leaves_no_excess_inflection)
{
    /* All turns are to the left; a cubic wiggles where the steep part begins. */
    const double points[] = {0, 0, 1, 0.001, 2, 0.004, 3, 0.3, 4, 1.5, 4.5, 3};
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    batten_chain_nonlinear_report report;
    batten_chain *chain = NULL;
    options.family = BATTEN_FAMILY_LOCAL_CUBIC;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, 6, points}, &options, NULL, NULL,
                                    &report, &chain));
    batten_chain_unref(chain);
    CHECK(report.inflections_added > 0);
    options.family = BATTEN_FAMILY_LOCAL_TENSION;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, 6, points}, &options, NULL, NULL,
                                    &report, &chain));
    CHECK_INT(report.inflections_added, 0);
    for (int i = 0; i <= 500; i++) {
        double at[6];
        CHECK_OK(batten_chain_evaluate(chain, batten_chain_domain(chain).b * i / 500, 2, at));
        CHECK(at[2] * at[5] - at[3] * at[4] >= -1e-9);
    }
    batten_chain_unref(chain);
}

/* ---- Hobby ---- */

TEST(hobbys_curve_through_a_square_is_nearly_a_circle)
{
    const double square[] = {1, 0, 0, 1, -1, 0, 0, -1};
    double angles[4];
    batten_chain *chain = through(BATTEN_FAMILY_HOBBY, 4, square, true, angles);
    batten_curve *curve = NULL;
    CHECK_OK(batten_chain_to_curve(chain, 1e-3, NULL, &curve));
    CHECK_INT(batten_curve_degree(curve), 3);
    /* The control point of the best known cubic arc: 4/3 tan(pi / 8). */
    const double *P = batten_curve_points(curve);
    CHECK_NEAR(P[2], 1, 1e-14);
    CHECK_NEAR(P[3], 4.0 / 3 * tan(pi / 8), 1e-14);
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(angles[i], pi / 2 * (i + 1), 1e-14);
    batten_curve_unref(curve);
    batten_chain_unref(chain);
}

TEST(hobbys_angles_solve_the_equations_of_mock_curvature)
{
    enum { N = 10 };
    double points[2 * N], angles[N];
    wave(N, points);
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = BATTEN_FAMILY_HOBBY;
    batten_chain_nonlinear_report report;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_nonlinear((batten_points){2, N, points}, &options, angles, NULL,
                                    &report, &chain));
    batten_chain_unref(chain);
    CHECK_INT(report.steps, 1);
    double phi[N], l[N];
    for (int j = 0; j + 1 < N; j++) {
        const double x = points[2 * j + 2] - points[2 * j],
                     y = points[2 * j + 3] - points[2 * j + 1];
        phi[j] = atan2(y, x);
        l[j] = hypot(x, y);
    }
    for (int i = 1; i + 1 < N; i++)
        CHECK_NEAR((2 * (angles[i - 1] - phi[i - 1]) + 4 * (angles[i] - phi[i - 1])) / l[i - 1],
                   -(4 * (angles[i] - phi[i]) + 2 * (angles[i + 1] - phi[i])) / l[i], 1e-12);
}

/* ---- ends ---- */

TEST(ends_of_nonlinear_splines_have_the_given_tangent_or_curvature)
{
    double points[2 * 6];
    wave(6, points);
    for (int n = 0; n < COUNT(kinds); n++) {
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        options.family = kinds[n].family;
        options.start = BATTEN_NONLINEAR_TANGENT;
        options.start_value = 0.7 + 4 * pi;
        options.end = BATTEN_NONLINEAR_CURVATURE;
        options.end_value = -0.15;
        batten_chain *chain = NULL;
        double a[6], b[6];
        CHECK_OK(batten_chain_nonlinear((batten_points){2, 6, points}, &options, NULL, NULL,
                                        NULL, &chain));
        const batten_interval domain = batten_chain_domain(chain);
        CHECK_OK(batten_chain_evaluate(chain, domain.a, 2, a));
        CHECK_OK(batten_chain_evaluate(chain, domain.b, 2, b));
        CHECK_NEAR(atan2(a[3], a[2]), 0.7, 1e-14);
        CHECK_NEAR((b[2] * b[5] - b[3] * b[4]) / pow(hypot(b[2], b[3]), 3), -0.15,
                   kinds[n].mock ? 0.02 : 1e-12);
        batten_chain_unref(chain);
    }
}

/* ---- what cannot be ---- */

TEST(g1_coincident_points_are_named_by_nonlinear_splines)
{
    const double points[] = {0, 0, 1, 1, 1, 1, 2, 0}, ring[] = {0, 0, 1, 0, 1, 1, 0, 0};
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_chain_nonlinear((batten_points){2, 4, points}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    options.closed = true;
    CHECK_STATUS(
        batten_chain_nonlinear((batten_points){2, 4, ring}, &options, NULL, NULL, NULL, &chain),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 4 and 1 coincide");
}

TEST(points_that_turn_back_are_named_by_nonlinear_splines)
{
    const double back[] = {0, 0, 2, 1, 1, 0.5, 4, 4};
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_chain_nonlinear((batten_points){2, 4, back}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("turns back on itself at point 2");
}

TEST(n1_bad_input_of_nonlinear_splines_is_refused)
{
    const double points[] = {0, 0, 1, 1, 2, 0}, bad[] = {0, 0, 1, NAN, 2, 0};
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    batten_chain *chain = NULL;
    CHECK_STATUS(
        batten_chain_nonlinear((batten_points){2, 1, points}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(
        batten_chain_nonlinear((batten_points){2, 3, bad}, NULL, NULL, NULL, NULL, &chain),
        BATTEN_NOT_FINITE);
    options.closed = true;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 2, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_TOO_FEW_POINTS);
    options.closed = false;
    options.family = (batten_span_family)99;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 3, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    options = batten_chain_nonlinear_defaults();
    options.start = (batten_nonlinear_end)7;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 3, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    options.start = BATTEN_NONLINEAR_TANGENT;
    options.start_value = INFINITY;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 3, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_NOT_FINITE);
    options = batten_chain_nonlinear_defaults();
    options.max_steps = 0;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 3, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    options.max_steps = 1;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 3, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_INCOMPLETE);
    CHECK_MESSAGE("after 1 step curvature still jumps");
}

TEST(g9_two_points_with_circular_ends_determine_no_circle)
{
    const double points[] = {0, 0, 1, 1};
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.start = options.end = BATTEN_NONLINEAR_CIRCULAR;
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_nonlinear((batten_points){2, 2, points}, &options, NULL, NULL,
                                        NULL, &chain),
                 BATTEN_SINGULAR_SYSTEM);
}

TEST(n2_nonlinear_splines_have_any_size)
{
    const double sizes[] = {1e-100, 1e-9, 1e9, 1e100};
    double points[2 * 5], angles[5], first[5];
    wave(5, points);
    for (int n = 0; n < COUNT(kinds); n++) {
        batten_chain_unref(through(kinds[n].family, 5, points, false, first));
        for (int k = 0; k < COUNT(sizes); k++) {
            double scaled[2 * 5];
            for (int i = 0; i < 10; i++)
                scaled[i] = points[i] * sizes[k];
            batten_chain_unref(through(kinds[n].family, 5, scaled, false, angles));
            for (int i = 0; i < 5; i++)
                CHECK_NEAR(angles[i], first[i], 1e-12);
        }
    }
}

TEST(nonlinear_splines_report_every_lack_of_memory)
{
    enum { N = 5 };
    double points[2 * N], angles[N], parameters[N];
    wave(N, points);
    static const double ring[] = {0, 0, 2, -0.5, 3, 1, 1.5, 2.2, -0.5, 1.3};
    for (int k = 0; k < COUNT(kinds); k++) {
        batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
        options.family = kinds[k].family;
        options.closed = kinds[k].round;
        batten_chain *chain = NULL;
        CHECK_EACH_ALLOCATION(
            batten_chain_nonlinear((batten_points){2, N, options.closed ? ring : points},
                                   &options, angles, parameters, NULL, &chain));
        batten_chain_unref(chain);
    }
}
