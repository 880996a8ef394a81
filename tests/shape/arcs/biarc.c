#include <batten/arcs.h>

#include "support/test.h"

static const double pi = 3.14159265358979323846;

static const batten_biarc_joint joints[] = {
    BATTEN_JOINT_AUTOMATIC,   BATTEN_JOINT_EQUAL_CHORD,     BATTEN_JOINT_EQUAL_LEGS,
    BATTEN_JOINT_LEAST_RATIO, BATTEN_JOINT_LEAST_CURVATURE, BATTEN_JOINT_GIVEN};

/* The biarc on the chord (0, 0) .. (l, 0) with these angles. */
static batten_status make(double alpha, double beta, double l, batten_biarc_joint joint,
                          double place, batten_biarc *out)
{
    const double start[2] = {0, 0}, end[2] = {l, 0};
    const double T0[2] = {cos(alpha), sin(alpha)}, T1[2] = {cos(beta), sin(beta)};
    return batten_biarc_between((batten_ray){start, T0}, (batten_ray){end, T1}, joint, place,
                                out);
}

static double curvature(const batten_biarc *biarc, int i)
{
    return biarc->arcs[biarc->count == 1 ? 0 : i].curvature[0];
}

/* The arcs join smoothly, and end where and as they should. */
static void check_joins(const batten_biarc *biarc, const double *end, const double *direction,
                        double tolerance)
{
    batten_chain *chain = NULL;
    double at[4], next[4];
    CHECK_OK(batten_chain_create(
        &(batten_chain_parts){2, biarc->count, biarc->arcs, NULL, false}, tolerance, &chain));
    const batten_interval domain = batten_chain_domain(chain);
    CHECK_OK(batten_chain_evaluate(chain, domain.b, 1, at));
    CHECK_NEAR(at[0], end[0], tolerance);
    CHECK_NEAR(at[1], end[1], tolerance);
    const double norm = hypot(direction[0], direction[1]);
    CHECK_NEAR(at[2], direction[0] / norm, 1e-13);
    CHECK_NEAR(at[3], direction[1] / norm, 1e-13);
    if (biarc->count == 2) {
        const double u = batten_chain_breaks(chain)[1];
        CHECK_OK(batten_chain_evaluate_side(chain, u, BATTEN_FROM_LEFT, 1, at));
        CHECK_OK(batten_chain_evaluate_side(chain, u, BATTEN_FROM_RIGHT, 1, next));
        CHECK_NEAR(at[0], biarc->joint[0], tolerance);
        CHECK_NEAR(at[1], biarc->joint[1], tolerance);
        CHECK_NEAR(at[2], next[2], 1e-13);
        CHECK_NEAR(at[3], next[3], 1e-13);
    }
    batten_chain_unref(chain);
}

TEST(biarcs_of_every_joint_meet_their_ends_with_one_tangent)
{
    test_random random = test_random_begin("biarcs");
    for (int i = 0; i < test_cases(300); i++) {
        const double angle = test_random_in(&random, -3, 3),
                     l = test_random_in(&random, 0.1, 9);
        const double a = test_random_in(&random, -2.9, 2.9),
                     b = test_random_in(&random, -2.9, 2.9);
        const double start[2] = {test_random_in(&random, -9, 9),
                                 test_random_in(&random, -9, 9)};
        const double end[2] = {start[0] + l * cos(angle), start[1] + l * sin(angle)};
        const double T0[2] = {3 * cos(angle + a), 3 * sin(angle + a)};
        const double T1[2] = {0.1 * cos(angle + b), 0.1 * sin(angle + b)};
        for (int k = 0; k < COUNT(joints); k++) {
            batten_biarc biarc;
            CHECK_OK(batten_biarc_between((batten_ray){start, T0}, (batten_ray){end, T1},
                                          joints[k], test_random_in(&random, 0.05, 0.95),
                                          &biarc));
            check_joins(&biarc, end, T1, 1e-8);
            CHECK_NEAR(biarc.turn[0] + (biarc.count == 2 ? biarc.turn[1] : 0), b - a, 1e-12);
        }
    }
}

/* curves-nonlinear.md 7: the closed forms of the equal-chord joint. */
TEST(equal_chord_joints_have_the_closed_form)
{
    test_random random = test_random_begin("equal chord");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, -2.5, 2.5),
                     b = test_random_in(&random, -2.5, 2.5);
        const double l = 3;
        batten_biarc biarc;
        CHECK_OK(make(a, b, l, BATTEN_JOINT_EQUAL_CHORD, 0, &biarc));
        CHECK_NEAR(curvature(&biarc, 0), -4 / l * sin((3 * a + b) / 4) * cos((a - b) / 4),
                   1e-12);
        CHECK_NEAR(curvature(&biarc, 1), 4 / l * sin((a + 3 * b) / 4) * cos((a - b) / 4),
                   1e-12);
        CHECK_NEAR(hypot(biarc.joint[0], biarc.joint[1]),
                   hypot(biarc.joint[0] - l, biarc.joint[1]), 1e-12 * hypot(1, biarc.joint[1]));
        if (biarc.count == 2)
            CHECK_NEAR(sin(biarc.arcs[1].angle + (a + b) / 2), 0, 1e-12);
        /* No other joint has a smaller jump. */
        const double c = cos((a - b) / 4);
        const double jump = 8 / l * c * c * fabs(sin((a + b) / 2));
        CHECK_NEAR(fabs(curvature(&biarc, 1) - curvature(&biarc, 0)), jump, 1e-12);
        for (int k = 1; k < 20; k++) {
            CHECK_OK(make(a, b, l, BATTEN_JOINT_GIVEN, k / 20.0, &biarc));
            CHECK(fabs(curvature(&biarc, 1) - curvature(&biarc, 0)) >=
                  jump * (1 - 1e-12) - 1e-12);
        }
    }
}

/* All joints lie on a circle through both ends with the tangent (alpha - beta) / 2 there. */
TEST(joints_lie_on_the_joint_circle)
{
    test_random random = test_random_begin("joint circle");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, -2.5, 2.5),
                     b = test_random_in(&random, -2.5, 2.5);
        const double D = (a - b) / 2;
        const double centre[2] = {0.5, -0.5 / tan(D)};
        for (int k = 1; k < 10; k++) {
            batten_biarc biarc;
            CHECK_OK(make(a, b, 1, BATTEN_JOINT_GIVEN, k / 10.0, &biarc));
            const double r = hypot(centre[0], centre[1]);
            CHECK_NEAR(hypot(biarc.joint[0] - centre[0], biarc.joint[1] - centre[1]) / r, 1,
                       1e-12);
            const double start[2] = {0, 0}, end[2] = {1, 0};
            double place = 0;
            CHECK_OK(batten_biarc_place((batten_vec2){start[0], start[1]},
                                        (batten_vec2){end[0], end[1]},
                                        (batten_vec2){biarc.joint[0], biarc.joint[1]}, &place));
            CHECK_NEAR(place, k / 10.0, 1e-9);
        }
    }
}

/* V.V - 2 d1 V.T0 - 2 d2 V.T1 + 2 d1 d2 (T0.T1 - 1) = 0, and the joint by the legs. */
TEST(legs_satisfy_their_equation)
{
    test_random random = test_random_begin("legs");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, -2.9, 2.9),
                     b = test_random_in(&random, -2.9, 2.9);
        for (int k = 0; k < COUNT(joints); k++) {
            batten_biarc m;
            CHECK_OK(make(a, b, 1, joints[k], 0.3, &m));
            const double d1 = m.legs[0], d2 = m.legs[1];
            const double size = 1 + fabs(d1) + fabs(d2) + fabs(d1 * d2);
            CHECK_NEAR(
                (1 - 2 * d1 * cos(a) - 2 * d2 * cos(b) + 2 * d1 * d2 * (cos(a - b) - 1)) / size,
                0, 1e-11);
            const double x = (d2 * d1 * cos(a) + d1 * (1 - d2 * cos(b))) / (d1 + d2);
            if (fabs(d1 + d2) > 1e-3 && size < 1e4)
                CHECK_NEAR(m.joint[0], x, 1e-9);
            if (fabs(a) < 1.5 && fabs(b) < 1.5 && joints[k] == BATTEN_JOINT_EQUAL_LEGS) {
                CHECK_NEAR(d1 / d2, 1, 1e-9);
                const double c = 1 - cos(a - b), s = cos(a) + cos(b);
                if (c > 1e-3)
                    CHECK_NEAR(d1, (-s + sqrt(s * s + 2 * c)) / (2 * c), 1e-10 / c);
            }
        }
    }
}

/* The ratio of the larger curvature to the smaller. */
static double larger_by(const batten_biarc *biarc)
{
    const double r = fabs(curvature(biarc, 1) / curvature(biarc, 0));
    return fmax(r, 1 / r);
}

TEST(the_least_ratio_of_a_c_is_at_the_incentre)
{
    test_random random = test_random_begin("incentre");
    for (int i = 0; i < 100; i++) {
        const double a = test_random_in(&random, 0.05, 1.5),
                     b = -test_random_in(&random, 0.05, 1.5);
        batten_biarc best, other;
        CHECK_OK(make(a, b, 1, BATTEN_JOINT_LEAST_RATIO, 0, &best));
        if (best.count == 1)
            continue;
        CHECK_NEAR(sin(best.arcs[1].angle), 0, 1e-12);
        /* Equally far from the chord and both tangents. */
        const double *J = best.joint;
        CHECK_NEAR(sin(a) * J[0] - cos(a) * J[1], J[1], 1e-12);
        CHECK(curvature(&best, 0) < 0 && curvature(&best, 1) < 0);
        const double least = larger_by(&best);
        for (int k = 1; k < 40; k++) {
            CHECK_OK(make(a, b, 1, BATTEN_JOINT_GIVEN, k / 40.0, &other));
            if (curvature(&other, 0) < 0 && curvature(&other, 1) < 0)
                CHECK(larger_by(&other) >= least * (1 - 1e-9));
        }
    }
}

TEST(the_least_curvature_is_one_radius)
{
    test_random random = test_random_begin("least curvature");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, -1.5, 1.5),
                     b = test_random_in(&random, -1.5, 1.5);
        batten_biarc best, other;
        CHECK_OK(make(a, b, 1, BATTEN_JOINT_LEAST_CURVATURE, 0, &best));
        const double k0 = curvature(&best, 0), k1 = curvature(&best, 1);
        const double most = fmax(fabs(k0), fabs(k1));
        if (a * b > 0)
            CHECK_NEAR(k0 + k1, 0, 1e-9 * most);
        else
            CHECK_NEAR(fmin(fabs(k0), fabs(k1)), 0, 1e-4);
        for (int k = 1; k < 40; k++) {
            CHECK_OK(make(a, b, 1, BATTEN_JOINT_GIVEN, k / 40.0, &other));
            if (curvature(&other, 0) * curvature(&other, 1) * (a * b) > 0)
                continue; /* turns another way than its ends ask for */
            CHECK(fmax(fabs(curvature(&other, 0)), fabs(curvature(&other, 1))) >=
                  most * (1 - 1e-9));
        }
    }
}

TEST(a_c_turns_one_way_at_the_automatic_joint)
{
    test_random random = test_random_begin("automatic");
    for (int i = 0; i < 200; i++) {
        const double a = test_random_in(&random, 0.05, 1.5),
                     b = -test_random_in(&random, 0.05, 1.5);
        batten_biarc biarc;
        CHECK_OK(make(a, b, 1, BATTEN_JOINT_AUTOMATIC, 0, &biarc));
        CHECK(curvature(&biarc, 0) < 0 && curvature(&biarc, 1) < 0);
        CHECK_OK(make(a, b, 1, BATTEN_JOINT_EQUAL_CHORD, 0, &biarc));
        const bool one_way = curvature(&biarc, 0) * curvature(&biarc, 1) > 0;
        CHECK(one_way == (fabs(a / b) > 1.0 / 3 && fabs(a / b) < 3));
    }
}

TEST(biarcs_that_are_less_than_that)
{
    batten_biarc biarc;
    for (int k = 0; k < COUNT(joints); k++) {
        /* One arc. */
        CHECK_OK(make(0.7, -0.7, 2, joints[k], 0.3, &biarc));
        CHECK_INT(biarc.count, 1);
        CHECK_NEAR(biarc.arcs[0].curvature[0], -sin(0.7), 1e-15);
        CHECK_NEAR(biarc.arcs[0].length, 0.7 * 2 / sin(0.7), 1e-14);
        CHECK_NEAR(hypot(biarc.joint[0] - 1, biarc.joint[1] + 1 / tan(0.7)), 1 / sin(0.7),
                   1e-14);
        /* A line. */
        CHECK_OK(make(0, 0, 2, joints[k], 0.3, &biarc));
        CHECK_INT(biarc.count, 1);
        CHECK(biarc.arcs[0].curvature[0] == 0 && biarc.arcs[0].length == 2 && !biarc.is_long);
        /* Two half circles. */
        if (joints[k] == BATTEN_JOINT_GIVEN)
            continue;
        CHECK_OK(make(pi / 2, pi / 2, 2, joints[k], 0.5, &biarc));
        CHECK_INT(biarc.count, 2);
        CHECK_NEAR(biarc.turn[0], -pi, 1e-15);
        CHECK_NEAR(biarc.turn[1], pi, 1e-15);
        CHECK_NEAR(biarc.arcs[0].curvature[0], -2, 1e-14);
        CHECK(isinf(biarc.legs[0]) && isinf(biarc.legs[1]));
    }
    CHECK_OK(make(2.5, 2.4, 1, BATTEN_JOINT_EQUAL_CHORD, 0, &biarc));
    CHECK(biarc.is_long && biarc.legs[0] < 0);
    CHECK_OK(make(2.5, -2.5, 1, BATTEN_JOINT_EQUAL_CHORD, 0, &biarc));
    CHECK(biarc.is_long && biarc.count == 1);
}

/* Points of a clothoid with curvature c s, by quadrature of its tangent from 0. */
static void clothoid(double c, double s, double *point)
{
    const int n = 400;
    point[0] = point[1] = 0;
    for (int i = 0; i < n; i++) {
        static const double nodes[] = {-0.7745966692414834, 0, 0.7745966692414834};
        static const double weights[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
        for (int g = 0; g < 3; g++) {
            const double t = s * (i + 0.5 + nodes[g] / 2) / n;
            point[0] += weights[g] / 2 * s / n * cos(c * t * t / 2);
            point[1] += weights[g] / 2 * s / n * sin(c * t * t / 2);
        }
    }
}

/* The largest distance of a clothoid between s0 and s0 + h from the biarc there. */
static double clothoid_error(double s0, double h)
{
    double start[2], end[2], largest = 0;
    clothoid(1, s0, start);
    clothoid(1, s0 + h, end);
    const double T0[2] = {cos(s0 * s0 / 2), sin(s0 * s0 / 2)};
    const double T1[2] = {cos((s0 + h) * (s0 + h) / 2), sin((s0 + h) * (s0 + h) / 2)};
    batten_biarc m;
    CHECK_OK(batten_biarc_between((batten_ray){start, T0}, (batten_ray){end, T1},
                                  BATTEN_JOINT_EQUAL_CHORD, 0, &m));
    for (int i = 0; i <= 100; i++) {
        double p[2], off = HUGE_VAL;
        clothoid(1, s0 + h * i / 100, p);
        for (int k = 0; k < 2; k++) {
            const batten_span *arc = &m.arcs[k];
            const double r = 1 / arc->curvature[0];
            const double c[2] = {arc->start[0] - r * sin(arc->angle),
                                 arc->start[1] + r * cos(arc->angle)};
            off = fmin(off, fabs(hypot(p[0] - c[0], p[1] - c[1]) - fabs(r)));
        }
        largest = fmax(largest, off);
    }
    return largest;
}

/* curves-nonlinear.md 7: order 3, |dk/ds| l^3 / 324.15. */
TEST(biarcs_of_a_clothoid_have_order_three_and_the_constant_324)
{
    const double coarse = clothoid_error(0.6, 0.2), fine = clothoid_error(0.65, 0.1);
    CHECK_NEAR(log2(coarse / fine), 3, 0.05);
    CHECK_NEAR(0.1 * 0.1 * 0.1 / fine, 324.15, 1);
}

TEST(g10_reversed_biarcs_are_the_same)
{
    const double a[2] = {1, 2}, b[2] = {4, 3}, T0[2] = {1, 1}, T1[2] = {2, -1};
    const double R0[2] = {-1, -1}, R1[2] = {-2, 1};
    for (int k = 0; k < COUNT(joints); k++) {
        batten_biarc there, back;
        CHECK_OK(batten_biarc_between((batten_ray){a, T0}, (batten_ray){b, T1}, joints[k], 0.3,
                                      &there));
        CHECK_OK(batten_biarc_between((batten_ray){b, R1}, (batten_ray){a, R0}, joints[k], 0.7,
                                      &back));
        CHECK_NEAR(there.joint[0], back.joint[0], 1e-14);
        CHECK_NEAR(there.joint[1], back.joint[1], 1e-14);
        CHECK_NEAR(there.arcs[0].curvature[0], -back.arcs[1].curvature[0], 1e-13);
        CHECK_NEAR(there.arcs[1].length, back.arcs[0].length, 1e-13);
    }
}

TEST(g1_biarcs_between_coincident_points_are_refused)
{
    const double a[2] = {1, 2}, T[2] = {1, 0}, zero[2] = {0, 0}, nan[2] = {NAN, 0};
    const double far[2] = {1e308, -1e308}, near[2] = {-1e308, 1e308}, b[2] = {2, 2};
    batten_biarc out;
    CHECK_STATUS(batten_biarc_between((batten_ray){a, T}, (batten_ray){a, T},
                                      BATTEN_JOINT_AUTOMATIC, 0, &out),
                 BATTEN_COINCIDENT);
    CHECK_STATUS(batten_biarc_between((batten_ray){a, zero}, (batten_ray){b, T},
                                      BATTEN_JOINT_AUTOMATIC, 0, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("direction at the start");
    CHECK_STATUS(batten_biarc_between((batten_ray){a, T}, (batten_ray){b, nan},
                                      BATTEN_JOINT_AUTOMATIC, 0, &out),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_biarc_between((batten_ray){near, T}, (batten_ray){far, T},
                                      BATTEN_JOINT_AUTOMATIC, 0, &out),
                 BATTEN_OVERFLOW);
    CHECK_STATUS(batten_biarc_between((batten_ray){a, T}, (batten_ray){b, T},
                                      BATTEN_JOINT_GIVEN, 1, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(make(pi, pi, 1, BATTEN_JOINT_AUTOMATIC, 0, &out), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("full circle");
    double place = 0;
    const double behind[2] = {0, 2};
    CHECK_STATUS(batten_biarc_place((batten_vec2){a[0], a[1]}, (batten_vec2){b[0], b[1]},
                                    (batten_vec2){behind[0], behind[1]}, &place),
                 BATTEN_NOT_FOUND);
}

TEST(n2_biarcs_of_any_size_have_the_same_shape)
{
    batten_biarc unit;
    CHECK_OK(make(0.4, -0.9, 1, BATTEN_JOINT_AUTOMATIC, 0, &unit));
    static const double sizes[] = {1e-300, 1e-9, 1e9, 1e300};
    for (int i = 0; i < COUNT(sizes); i++) {
        batten_biarc m;
        CHECK_OK(make(0.4, -0.9, sizes[i], BATTEN_JOINT_AUTOMATIC, 0, &m));
        CHECK_NEAR(m.arcs[0].length / sizes[i], unit.arcs[0].length, 1e-14);
        CHECK_NEAR(m.arcs[1].curvature[0] * sizes[i], unit.arcs[1].curvature[0], 1e-13);
    }
}
