#include <batten/arcs.h>
#include <batten/curvature.h>
#include <batten/measure.h>

#include "support/test.h"

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Speed may jump inside an arc that was halved, direction may not. */
static void check_smooth(const batten_curve *curve)
{
    double knots[64], left[6], right[6];
    const int n = batten_curve_spans(curve, NULL);
    CHECK(n <= COUNT(knots));
    batten_curve_spans(curve, knots);
    for (int i = 1; i + 1 < n; i++) {
        CHECK_OK(batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_LEFT, 1, left));
        CHECK_OK(batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_RIGHT, 1, right));
        const double a = sqrt(dot(left + 3, left + 3)), b = sqrt(dot(right + 3, right + 3));
        CHECK_NEAR(dot(left + 3, right + 3) / (a * b), 1, 1e-13);
    }
}

TEST(biarcs_in_space_are_arcs_of_two_circles)
{
    test_random random = test_random_begin("space biarcs");
    for (int i = 0; i < test_cases(100); i++) {
        double start[3], end[3], T0[3], T1[3], at[6];
        for (int k = 0; k < 3; k++) {
            start[k] = test_random_in(&random, -1, 1);
            end[k] = start[k] + test_random_in(&random, 0.2, 2);
            T0[k] = test_random_in(&random, -1, 1);
            T1[k] = test_random_in(&random, -1, 1);
        }
        batten_curve *curve = NULL;
        const double ratio = test_random_in(&random, 0.3, 3);
        CHECK_OK(batten_curve_biarc(3, (batten_ray){start, T0}, (batten_ray){end, T1}, ratio,
                                    &curve));
        check_smooth(curve);
        const batten_interval domain = batten_curve_domain(curve);
        CHECK_OK(batten_curve_evaluate(curve, domain.a, 1, at));
        CHECK_NEAR(dot(at + 3, T0) / sqrt(dot(T0, T0) * dot(at + 3, at + 3)), 1, 1e-12);
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 1, at));
        CHECK_NEAR(dot(at + 3, T1) / sqrt(dot(T1, T1) * dot(at + 3, at + 3)), 1, 1e-12);
        /* Arcs have one curvature and no torsion; the parameter at the end is the length. */
        double knots[8], length = 0;
        const int n = batten_curve_spans(curve, knots);
        for (int s = 0; s + 1 < n; s++) {
            batten_curve_local a, b;
            CHECK_OK(batten_curve_local_at(curve, 0.8 * knots[s] + 0.2 * knots[s + 1],
                                           BATTEN_FROM_RIGHT, &a));
            CHECK_OK(batten_curve_local_at(curve, 0.3 * knots[s] + 0.7 * knots[s + 1],
                                           BATTEN_FROM_RIGHT, &b));
            CHECK_NEAR(b.curvature / a.curvature, 1, 1e-8);
            CHECK_NEAR(a.torsion / a.curvature, 0, 1e-5);
        }
        CHECK_OK(batten_curve_length(curve, 1e-10, NULL, &length));
        CHECK_NEAR(length, domain.b - domain.a, 1e-8 * length);
        batten_curve_unref(curve);
    }
}

TEST(biarcs_by_legs_are_those_by_joints)
{
    const double start[2] = {1, 1}, end[2] = {4, 2}, T0[2] = {1, 1}, T1[2] = {1, -0.2};
    batten_biarc plane;
    batten_curve *curve = NULL;
    double at[2];
    CHECK_OK(batten_biarc_between((batten_ray){start, T0}, (batten_ray){end, T1},
                                  BATTEN_JOINT_EQUAL_LEGS, 0, &plane));
    CHECK_OK(batten_curve_biarc(2, (batten_ray){start, T0}, (batten_ray){end, T1}, 1, &curve));
    CHECK_OK(batten_curve_evaluate(curve, plane.arcs[0].length, 0, at));
    CHECK_NEAR(at[0], plane.joint[0], 1e-13);
    CHECK_NEAR(at[1], plane.joint[1], 1e-13);
    batten_curve_unref(curve);
}

TEST(g9_biarcs_in_space_without_legs_are_refused)
{
    const double start[3] = {0, 0, 0}, end[3] = {1, 0, 0}, across[3] = {0, 0, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_biarc(3, (batten_ray){start, across}, (batten_ray){end, across},
                                    1, &curve),
                 BATTEN_SINGULAR_HERE);
    CHECK_STATUS(batten_curve_biarc(3, (batten_ray){start, across}, (batten_ray){start, across},
                                    1, &curve),
                 BATTEN_COINCIDENT);
    CHECK_STATUS(batten_curve_biarc(3, (batten_ray){start, across}, (batten_ray){end, across},
                                    0, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_biarc(1, (batten_ray){start, across}, (batten_ray){end, across},
                                    1, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK(!curve);
}

TEST(biarcs_through_points_of_a_tilted_circle_are_the_circle)
{
    static const double angles[] = {0, 0.4, 1.5, 1.7, 2.9, 4.4};
    double points[6 * 3], parameters[6], at[3];
    for (int i = 0; i < 6; i++) {
        points[3 * i] = 2 * cos(angles[i]);
        points[3 * i + 1] = 2 * 0.6 * sin(angles[i]);
        points[3 * i + 2] = 2 * 0.8 * sin(angles[i]);
    }
    for (int closed = 0; closed < 2; closed++) {
        batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
        options.closed = closed;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_biarcs((batten_points){3, 6, points}, &options, parameters, &curve));
        check_smooth(curve);
        const batten_interval domain = batten_curve_domain(curve);
        CHECK_NEAR(domain.b - domain.a, closed ? 4 * acos(-1) : 2 * 4.4, 1e-12);
        for (int i = 0; i <= 50; i++) {
            CHECK_OK(
                batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 50, 0, at));
            CHECK_NEAR(sqrt(dot(at, at)), 2, 1e-13);
            CHECK_NEAR(at[1] * 0.8, at[2] * 0.6, 1e-13);
        }
        for (int i = 0; i < 6; i++) {
            CHECK_NEAR(parameters[i], 2 * angles[i], 1e-12);
            CHECK_OK(batten_curve_evaluate(curve, parameters[i], 0, at));
            CHECK_NEAR(at[0], points[3 * i], 1e-13);
        }
        batten_curve_unref(curve);
    }
}

/* Directions that point back along the second chord of a row, and across the last chord of a ring. */
TEST(biarcs_that_cannot_be_are_named_by_their_points)
{
    static const double points[12] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 4, 1};
    static const double back[12] = {1, 0, 0, -1, 0, 0, -1, 0, 0, 0, 1, 0};
    static const double ring[12] = {4, -1, 0, 1, 0, 0, 0, 1, 0, 4, -1, 0};
    static const struct {
        bool closed;
        const double *directions;
        const char *words;
    } rows[] = {{false, back, "between points 2 and 3: "},
                {true, ring, "between points 4 and 1: "}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_chain_biarcs_options options = batten_chain_biarcs_defaults();
        options.closed = rows[i].closed;
        options.directions = rows[i].directions;
        batten_curve *curve = NULL;
        CHECK_STATUS(batten_curve_biarcs((batten_points){3, 4, points}, &options, NULL, &curve),
                     BATTEN_SINGULAR_HERE);
        CHECK_MESSAGE(rows[i].words);
        CHECK(!curve);
    }
}
