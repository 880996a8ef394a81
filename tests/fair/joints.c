/* What a joint of two pieces adds to the verdict: corners, jumps of curvature and of its rate; and the bounds asked for. */
#include "fair/fairness.h"
#include "support/test.h"

#include <math.h>

/* A piece beside the joint: its direction, curvature and rate in a plane, run at this speed and acceleration. */
typedef struct {
    double angle, curvature, rate, speed, acceleration;
} piece;

/* Point and three derivatives, [4][d], in the plane of x and y. */
static void rows_of(const piece *p, int d, double *rows)
{
    const double t[3] = {cos(p->angle), sin(p->angle), 0}, n[3] = {-t[1], t[0], 0};
    const double s = p->speed, a = p->acceleration, k = p->curvature;
    for (int c = 0; c < d; c++) {
        rows[c] = 7 + c;
        rows[d + c] = s * t[c];
        rows[2 * d + c] = a * t[c] + s * s * k * n[c];
        rows[3 * d + c] =
            -s * s * s * k * k * t[c] + (s * s * s * p->rate + 3 * s * a * k) * n[c];
    }
}

static const struct {
    piece before, after;
    int corners, curvature_jumps;
    double turn, jump, jumps;
} joints[] = {
    {{0.2, 0.5, 0.1, 1, 0}, {0.2, 0.5, 0.1, 1, 0}, 0, 0, 0, 0, 0},
    {{0.2, 0.5, 0.1, 1, 0}, {0.2, 0.5, 0.1, 3, -2}, 0, 0, 0, 0, 0}, /* at another speed */
    {{0.2, 0.5, 0.1, 2, 1}, {0.2, 0.8, 0.1, 3, -2}, 0, 1, 0, 0.375, 0},
    {{0.2, -0.8, 0, 2, 1}, {0.2, 0.5, 0, 1, 0}, 0, 1, 0, 1.625, 0},
    {{0.2, 0.5, 0.2, 2, 1}, {0.2, 0.5, -0.4, 1, 3}, 0, 0, 0, 0, 0.36},
    {{0.2, 0.5, 0, 1, 0},
     {0.5, 0.8, 0, 1, 0},
     1,
     0,
     0.3,
     0,
     0}, /* of a corner only the turn counts */
    {{0.2, 0, 0, 1, 0}, {-2.3, 0, 0, 4, 0}, 1, 0, 2.5, 0, 0},
    {{0, 0, 0, 0, 1}, {2, 5, 0, 1, 0}, 0, 0, 0, 0, 0}, /* where a piece halts others judge */
};

TEST(a_joint_adds_its_corner_or_its_jump_in_the_plane_and_in_space)
{
    const bat_joint_scale scale = {1e-6, 1e-6, 1, 0, 0};
    for (int i = 0; i < COUNT(joints); i++)
        for (int d = 2; d <= 3; d++) {
            double before[12], after[12];
            batten_fairness found = {.jumps = 10};
            rows_of(&joints[i].before, d, before);
            rows_of(&joints[i].after, d, after);
            bat_add_joint(d, before, after, &scale, &found);
            CHECK_INT(found.corners, joints[i].corners);
            CHECK_INT(found.curvature_jumps, joints[i].curvature_jumps);
            CHECK_NEAR(found.largest_turn, joints[i].turn, 1e-14);
            CHECK_NEAR(found.largest_jump, joints[i].jump, 1e-14);
            if (joints[i].before.speed > 0 && joints[i].corners == 0)
                CHECK_NEAR(found.jumps, 10 + joints[i].jumps, 1e-13);
        }
}

TEST(joints_of_functions_are_judged_by_slopes_and_second_derivatives)
{
    static const double before[] = {7, 2, 3, 1};
    static const struct {
        double after[4];
        int corners, curvature_jumps;
        double turn, jump, jumps;
    } rows[] = {{{7, 2, 3, 1}, 0, 0, 0, 0, 0},
                {{7, 2, 5, 1}, 0, 1, 0, 0.4, 0},
                {{7, 2, 3, 4}, 0, 0, 0, 0, 9},
                {{7, 2.5, 5, 1}, 1, 0, 0.5, 0, 0},
                {{7, -2, 3, 1}, 1, 0, 4, 0, 0}};
    const bat_joint_scale scale = {1e-6, 1e-6, 1, 0, 0};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_fairness found = {0};
        bat_add_joint(1, before, rows[i].after, &scale, &found);
        CHECK_INT(found.corners, rows[i].corners);
        CHECK_INT(found.curvature_jumps, rows[i].curvature_jumps);
        CHECK_NEAR(found.largest_turn, rows[i].turn, 1e-14);
        CHECK_NEAR(found.largest_jump, rows[i].jump, 1e-14);
        CHECK_NEAR(found.jumps, rows[i].jumps, 1e-14);
    }
}

/* A turn of 0.1 and a jump of 0.3 of 0.8, on both sides of each bound. */
TEST(a_corner_is_beyond_the_angle_and_a_jump_beyond_its_share_and_their_noise)
{
    static const struct {
        bat_joint_scale scale;
        double turn, curvature;
        int corners, curvature_jumps;
    } rows[] = {
        {{0.099, 1, 1, 0, 0}, 0.1, 0.5, 1, 0},     {{0.101, 1, 1, 0, 0}, 0.1, 0.5, 0, 0},
        {{0.05, 1, 1, 0.0495, 0}, 0.1, 0.5, 1, 0}, {{0.05, 1, 1, 0.0505, 0}, 0.1, 0.5, 0, 0},
        {{1, 0.374, 0, 0, 0}, 0, 0.8, 0, 1},       {{1, 0.376, 0, 0, 0}, 0, 0.8, 0, 0},
        {{1, 0.25, 0, 0, 0.099}, 0, 0.8, 0, 1},    {{1, 0.25, 0, 0, 0.101}, 0, 0.8, 0, 0},
        {{1, 0.25, 1e9, 0, 0}, 0, 0.8, 0, 0}, /* beside a far larger curvature */
    };
    for (int i = 0; i < COUNT(rows); i++) {
        const piece first = {0, 0.5, 0, 1, 0};
        const piece second = {rows[i].turn, rows[i].curvature, 0, 1, 0};
        double before[8], after[8];
        batten_fairness found = {0};
        rows_of(&first, 2, before);
        rows_of(&second, 2, after);
        bat_add_joint(2, before, after, &rows[i].scale, &found);
        CHECK_INT(found.corners, rows[i].corners);
        CHECK_INT(found.curvature_jumps, rows[i].curvature_jumps);
    }
}

TEST(the_verdict_follows_from_the_counts)
{
    for (int bad = 0; bad < 5; bad++) {
        batten_fairness f = {
            .energy = 2, .energy_error = 1, .variation = 3, .variation_error = 1};
        f.excess_inflections = bad == 1;
        f.corners = bad == 2;
        f.curvature_jumps = bad == 3;
        f.unbounded = bad == 4;
        bat_conclude_fairness(&f);
        CHECK_INT(f.fair, bad == 0);
        CHECK_INT(isinf(f.energy), bad == 2);
        CHECK_NEAR(f.energy_error, bad == 2 ? 0 : 1, 0);
        CHECK_INT(isinf(f.variation), bad > 1);
        CHECK_NEAR(f.variation_error, bad > 1 ? 0 : 1, 0);
    }
}

static const struct {
    double angle, curvature, within, error;
    const char *message; /* NULL: allowed */
} bounds[] = {
    {1e-9, 1e-9, 0, 0, NULL},
    {3.1, 1e9, 1e9, 1e9, NULL},
    {0, 1, 0, 0, "the angle of a corner is 0 radians, not between 0 and pi"},
    {3.2, 1, 0, 0, "the angle of a corner is 3.2 radians"},
    {NAN, 1, 0, 0, "the angle of a corner is nan radians"},
    {1, 0, 0, 0, "the bound on curvature jumps is 0, not above 0"},
    {1, INFINITY, 0, 0, "the bound on curvature jumps is inf"},
    {1, 1, -1, 0, "points within -1: the bound is below 0"},
    {1, 1, INFINITY, 0, "points within inf"},
    {1, 1, 0, -1, "a curve known within -1: the error is below 0"},
    {1, 1, 0, NAN, "a curve known within nan"},
};

TEST(bounds_of_the_verdict_that_mean_nothing_are_refused)
{
    for (int i = 0; i < COUNT(bounds); i++) {
        batten_fairness_options options = batten_fairness_defaults(), chosen;
        options.angle = bounds[i].angle;
        options.curvature = bounds[i].curvature;
        options.within = bounds[i].within;
        options.error = bounds[i].error;
        CHECK_STATUS(bat_fairness_take_options(&options, &chosen),
                     bounds[i].message ? BATTEN_BAD_ARGUMENT : BATTEN_OK);
        if (bounds[i].message)
            CHECK_MESSAGE(bounds[i].message);
        else
            CHECK_NEAR(chosen.angle, bounds[i].angle, 0);
    }
}
