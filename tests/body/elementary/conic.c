#include "body/elementary/elementary.h"
#include "numeric/vector.h"
#include "support/test.h"

static const double PI = BAT_PI;

/* A frame that is square to the world nowhere. */
static batten_frame tilted(void)
{
    return (batten_frame){{3, -2, 5}, {2. / 3, -1. / 3, 2. / 3}, {1. / 3, -2. / 3, -2. / 3}};
}

static bat_conic conic_of(bat_conic_kind kind, double a, double b)
{
    return (bat_conic){kind, tilted(), a, b};
}

/* The coordinates of a point in the tilted frame. */
static void seen(const double p[3], double at[3])
{
    const batten_frame f = tilted();
    const batten_vec3 way = bat_vec3_subtract(bat_vec3_of(3, p), f.origin);
    at[0] = bat_vec3_dot(way, f.x);
    at[1] = bat_vec3_dot(way, bat_vec3_cross(f.z, f.x));
    at[2] = bat_vec3_dot(way, f.z);
}

/* How far a point misses the equation of the conic, as a share of its size. */
static double off(const bat_conic *conic, const double p[3])
{
    double q[3];
    seen(p, q);
    const double a = conic->a, b = conic->b, x = q[0], y = q[1];
    const double lies = fabs(q[2]) / (fabs(x) + fabs(y) + a);
    switch (conic->kind) {
    case BAT_LINE:
        return fabs(y) + fabs(q[2]);
    case BAT_ELLIPSE:
        return lies + fabs(x * x / (a * a) + y * y / (b * b) - 1);
    case BAT_PARABOLA: /* y^2 = 4 a x */
        return lies + fabs(y * y - 4 * a * x) / (y * y + 4 * a * a);
    case BAT_HYPERBOLA:
        return lies + fabs(x * x / (a * a) - y * y / (b * b) - 1) / (x * x / (a * a));
    }
    return INFINITY;
}

static void ends_of(const batten_curve *curve, double p[3], double q[3])
{
    const batten_interval d = batten_curve_domain(curve);
    CHECK_OK(batten_curve_evaluate(curve, d.a, 0, p));
    CHECK_OK(batten_curve_evaluate(curve, d.b, 0, q));
}

TEST(parts_of_conics_satisfy_their_equations)
{
    static const struct {
        bat_conic_kind kind;
        double a, b, t0, t1;
    } cases[] = {
        {BAT_LINE, 0, 0, -4, 9},
        {BAT_ELLIPSE, 2, 2, -1, 0.3},
        {BAT_ELLIPSE, 5, 0.5, 2, 7.5},
        {BAT_ELLIPSE, 1, 3, 0, 2 * BAT_PI},
        {BAT_ELLIPSE, 1, 3, -3, 2 * BAT_PI - 3},
        {BAT_PARABOLA, 0.7, 0, -2, 3},
        {BAT_HYPERBOLA, 2, 1, -1, 0.5},
        {BAT_HYPERBOLA, 0.3, 4, -2.5, 6},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_conic conic = conic_of(cases[i].kind, cases[i].a, cases[i].b);
        batten_curve *curve = NULL;
        double p[3], q[3], at[3];
        CHECK_OK(bat_conic_between(&conic, cases[i].t0, cases[i].t1, &curve));
        const batten_interval d = batten_curve_domain(curve);
        CHECK_BITS(d.a, cases[i].t0);
        CHECK_BITS(d.b, cases[i].t1);
        for (int k = 0; k <= 100; k++) {
            CHECK_OK(batten_curve_evaluate(curve, d.a + (d.b - d.a) * k / 100, 0, at));
            CHECK_NEAR(off(&conic, at), 0, 1e-13);
        }
        ends_of(curve, p, q);
        bat_conic_point(&conic, d.a, at);
        CHECK_NEAR(bat_distance(3, p, at), 0, 1e-13 * (1 + bat_norm(3, at)));
        bat_conic_point(&conic, d.b, at);
        CHECK_NEAR(bat_distance(3, q, at), 0, 1e-13 * (1 + bat_norm(3, at)));
        batten_curve_unref(curve);
    }
}

TEST(a_parabola_runs_as_its_parameter)
{
    const bat_conic conic = conic_of(BAT_PARABOLA, 0.7, 0);
    batten_curve *curve = NULL;
    CHECK_OK(bat_conic_between(&conic, -2, 3, &curve));
    for (int k = 0; k <= 20; k++) {
        double at[3], due[3];
        CHECK_OK(batten_curve_evaluate(curve, -2 + 0.25 * k, 0, at));
        bat_conic_point(&conic, -2 + 0.25 * k, due);
        CHECK_NEAR(bat_distance(3, at, due), 0, 1e-14 * 20);
    }
    batten_curve_unref(curve);
}

/* For a point off the conic the foot is no farther than any other place. */
TEST(parameters_are_those_of_the_feet)
{
    static const bat_conic_kind kinds[] = {BAT_LINE, BAT_ELLIPSE, BAT_PARABOLA, BAT_HYPERBOLA};
    test_random random = test_random_begin("feet");
    for (int i = 0; i < test_cases(200); i++) {
        const bat_conic conic = conic_of(kinds[i % 4], test_random_in(&random, 0.2, 3),
                                         test_random_in(&random, 0.2, 3));
        double point[3], foot[3], other[3];
        const double t = test_random_in(&random, -3, 3);
        bat_conic_point(&conic, t, point);
        CHECK_NEAR(bat_conic_parameter(&conic, point), t, 1e-12);
        for (int k = 0; k < 3; k++)
            point[k] += test_random_in(&random, -0.5, 0.5);
        bat_conic_point(&conic, bat_conic_parameter(&conic, point), foot);
        for (int k = -60; k <= 60; k++) {
            bat_conic_point(&conic, 0.0523 * k, other);
            CHECK(bat_distance(3, point, foot) <= bat_distance(3, point, other) + 1e-12);
        }
    }
}

/* On the axis both sides are alike: up to the centre of curvature at the vertex, b^2 / a or 2 a from it, the vertex
 * is the foot, beyond it one of two. */
TEST(points_on_the_axis_of_a_conic_have_the_nearest_foot)
{
    for (int kind = BAT_ELLIPSE; kind <= BAT_HYPERBOLA; kind++)
        for (int i = -20; i <= 40; i++) {
            const bat_conic conic = {
                (bat_conic_kind)kind, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, 2, 1};
            const double point[3] = {0.25 * i, 0, 0};
            double foot[3], other[3], least = HUGE_VAL;
            bat_conic_point(&conic, bat_conic_parameter(&conic, point), foot);
            for (int k = -400; k <= 400; k++) {
                bat_conic_point(&conic, 0.008 * k, other);
                least = fmin(least, bat_distance(3, point, other));
            }
            CHECK(bat_distance(3, point, foot) <= least + 1e-12);
        }
}

TEST(N2_parameters_are_found_at_any_size)
{
    static const double sizes[] = {1e-80, 1, 1e80};
    for (int i = 0; i < COUNT(sizes); i++)
        for (int kind = BAT_ELLIPSE; kind <= BAT_HYPERBOLA; kind++) {
            bat_conic conic = conic_of((bat_conic_kind)kind, 2 * sizes[i], sizes[i]);
            conic.frame.origin = (batten_vec3){0, 0, 0};
            double point[3];
            bat_conic_point(&conic, 0.75, point);
            CHECK_NEAR(bat_conic_parameter(&conic, point), 0.75, 1e-14);
            bat_conic_point(&conic, -0.75, point);
            CHECK_NEAR(bat_conic_parameter(&conic, point), -0.75, 1e-14);
        }
}

TEST(the_vertices_of_an_ellipse_are_at_whole_quarters)
{
    bat_conic conic = {BAT_ELLIPSE, batten_frame_world(), 3, 2};
    static const double points[4][3] = {{3, 0, 0}, {0, 2, 0}, {-3, 0, 0}, {0, -2, 0}};
    static const double quarters[4] = {0, 0.5, 1, -0.5};
    for (int i = 0; i < 4; i++)
        CHECK_BITS(bat_conic_parameter(&conic, points[i]), quarters[i] * PI);
}

TEST(a_part_of_an_ellipse_goes_the_way_it_is_told)
{
    const bat_conic conic = conic_of(BAT_ELLIPSE, 4, 4);
    static const double pairs[][2] = {{0.5, 2}, {2, 0.5}, {3, -3}, {-3, 3}, {-1, 1}};
    for (int i = 0; i < COUNT(pairs); i++)
        for (int forward = 0; forward < 2; forward++) {
            double p[3], q[3], start[3], end[3], middle[3], due[3];
            batten_curve *curve = NULL;
            bat_conic_point(&conic, pairs[i][0], p);
            bat_conic_point(&conic, pairs[i][1], q);
            CHECK_OK(bat_conic_part(&conic, p, q, forward, 1e-9, &curve));
            ends_of(curve, start, end);
            CHECK_NEAR(bat_distance(3, start, p), 0, 1e-13);
            CHECK_NEAR(bat_distance(3, end, q), 0, 1e-13);
            double sweep = pairs[i][1] - pairs[i][0];
            if (forward && sweep < 0)
                sweep += 2 * PI;
            if (!forward && sweep > 0)
                sweep -= 2 * PI;
            const batten_interval d = batten_curve_domain(curve);
            CHECK_NEAR(d.b - d.a, fabs(sweep), 1e-12);
            CHECK_OK(batten_curve_evaluate(curve, (d.a + d.b) / 2, 0, middle));
            bat_conic_point(&conic, pairs[i][0] + sweep / 2, due);
            CHECK_NEAR(bat_distance(3, middle, due), 0, 1e-12); /* a circle is symmetric */
            batten_curve_unref(curve);
        }
}

TEST(an_ellipse_from_a_point_to_itself_is_whole)
{
    const bat_conic conic = conic_of(BAT_ELLIPSE, 4, 1);
    double p[3], q[3], start[3], end[3];
    bat_conic_point(&conic, 2.5, p);
    memcpy(q, p, sizeof q);
    q[0] += 1e-4;
    for (int forward = 0; forward < 2; forward++) {
        batten_curve *curve = NULL;
        CHECK_OK(bat_conic_part(&conic, p, q, forward, 1e-3, &curve));
        ends_of(curve, start, end);
        CHECK_BITS(bat_distance(3, start, end), 0);
        CHECK_NEAR(bat_distance(3, start, p), 0, 1e-13);
        batten_curve_unref(curve);
    }
}

TEST(open_conics_run_from_the_first_point_to_the_second)
{
    static const bat_conic_kind kinds[] = {BAT_LINE, BAT_PARABOLA, BAT_HYPERBOLA};
    for (int i = 0; i < 6; i++) {
        const bat_conic conic = conic_of(kinds[i % 3], 2, 1);
        double p[3], q[3], start[3], end[3];
        batten_curve *curve = NULL;
        bat_conic_point(&conic, i < 3 ? -1 : 2, p);
        bat_conic_point(&conic, 0.5, q);
        CHECK_OK(bat_conic_part(&conic, p, q, i < 3, 1e-9, &curve));
        ends_of(curve, start, end);
        CHECK_NEAR(bat_distance(3, start, p), 0, 1e-13);
        CHECK_NEAR(bat_distance(3, end, q), 0, 1e-13);
        batten_curve_unref(curve);
        CHECK_STATUS(bat_conic_part(&conic, p, p, true, 1e-9, &curve), BATTEN_COINCIDENT);
    }
}

TEST(N1_bad_conics_are_refused_with_their_numbers)
{
    bat_conic conic = conic_of(BAT_ELLIPSE, 0, 1);
    batten_curve *curve = NULL;
    CHECK_STATUS(bat_conic_between(&conic, 0, 1, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("0 and 1");
    conic.a = NAN;
    CHECK_STATUS(bat_conic_between(&conic, 0, 1, &curve), BATTEN_NOT_FINITE);
    conic.a = 1;
    CHECK_STATUS(bat_conic_between(&conic, 0, 7, &curve), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_conic_between(&conic, 1, 1, &curve), BATTEN_COINCIDENT);
    CHECK_STATUS(bat_conic_between(&conic, 0, NAN, &curve), BATTEN_NOT_FINITE);
    conic.kind = BAT_HYPERBOLA;
    CHECK_STATUS(bat_conic_between(&conic, -1e9, 1e9, &curve), BATTEN_OVERFLOW);
}
