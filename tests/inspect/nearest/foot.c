/* Steps to the foot of the perpendicular, and the descent that takes them. */
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"
#include "support/test.h"

#include <batten/standard.h>
#include <float.h>
#include <string.h>

static const bool BOTH[2] = {true, true};

/* C = (u, 0), at u = 3 with its derivatives. */
TEST(on_a_straight_line_one_step_leads_to_the_foot)
{
    const double at[] = {3, 0, 1, 0, 0, 0}, q[] = {-4.5, 7};
    CHECK_NEAR(3 + bat_foot_curve_step(2, at, q), -4.5, 0);
    const double still[] = {3, 0, 0, 0, 0, 0};
    CHECK_NEAR(bat_foot_curve_step(2, still, q), 0, 0);
}

/* C = (u, u^2): the foot of (0, y) is 0 when y <= 1/2. Newton's matrix at 0 is 1 - 2 y. */
TEST(on_a_parabola_newton_is_left_where_its_matrix_is_less_than_half)
{
    const double at[] = {0.1, 0.01, 1, 0.2, 0, 2};
    static const double heights[] = {-1, 0, 0.2, 0.3, 0.5, 2};
    for (int i = 0; i < COUNT(heights); i++) {
        const double q[] = {0, heights[i]};
        const double off = 0.01 - heights[i], slope = 1 + 0.04, bend = slope + 2 * off;
        const double by = bend > slope / 2 ? bend : slope;
        CHECK_NEAR(bat_foot_curve_step(2, at, q), -(0.1 + 0.2 * off) / by, 4 * DBL_EPSILON);
    }
}

TEST(a_step_solves_its_equations_whatever_the_size_of_the_tangents)
{
    static const double sizes[] = {1, 1e80, 1e-80, 1e-150};
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(sizes); k++) {
            const double a = sizes[i], b = sizes[k];
            const double h[3] = {5 * a * a, 2 * a * b, 3 * b * b}, g[2] = {7 * a, -1 * b};
            double step[2];
            CHECK(bat_foot_solve(h, g, BOTH, step));
            /* 5 x + 2 y = -7, 2 x + 3 y = 1 */
            CHECK_NEAR(step[0] * a, -23.0 / 11, 1e-14);
            CHECK_NEAR(step[1] * b, 19.0 / 11, 1e-14);
        }
}

TEST(a_matrix_that_is_not_positive_gives_no_step)
{
    static const double matrices[][3] = {{1, 1, 1},   {1, 2, 1}, {-1, 0, 1}, {1, 0, -1},
                                         {-1, 0, -1}, {0, 0, 1}, {1, 0, 0}};
    const double g[2] = {1, 1};
    double step[2];
    for (int i = 0; i < COUNT(matrices); i++)
        CHECK(!bat_foot_solve(matrices[i], g, BOTH, step));
}

TEST(a_direction_that_is_not_free_has_no_step)
{
    const double h[3] = {2, 1, 4}, g[2] = {6, 12};
    double step[2];
    CHECK(bat_foot_solve(h, g, (const bool[2]){true, false}, step));
    CHECK_NEAR(step[0], -3, 0);
    CHECK_NEAR(step[1], 0, 0);
    CHECK(bat_foot_solve(h, g, (const bool[2]){false, true}, step));
    CHECK_NEAR(step[0], 0, 0);
    CHECK_NEAR(step[1], -3, 0);
    CHECK(!bat_foot_solve(h, g, (const bool[2]){false, false}, step));
}

/* S = (u, v, (u^2 + v^2) / 2) at (u, 0), and a point on the axis: Newton's matrix is
 * diag(1 + u^2 + r, 1 + r) with r = u^2 / 2 - z, that of Gauss and Newton diag(1 + u^2, 1). */
TEST(newton_is_taken_as_far_as_it_is_trusted)
{
    const double u = 0.5;
    const double s[] = {u, 0, u * u / 2, 1, 0, u, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    static const double heights[] = {-1, 0.5, 0.9, 2};
    static const double trusts[] = {0, 0.25, 0.9};
    for (int i = 0; i < COUNT(heights); i++)
        for (int k = 0; k < COUNT(trusts); k++) {
            const double q[] = {0, 0, heights[i]}, r = u * u / 2 - heights[i];
            const double newton[] = {1 + u * u + r, 1 + r}, gauss[] = {1 + u * u, 1};
            const double t = trusts[k];
            const bool trusted = newton[0] > t * gauss[0] && newton[1] > t * gauss[1] &&
                                 newton[0] * newton[1] > t * t * gauss[0] * gauss[1];
            bat_foot_place here;
            double step[2];
            bat_foot_slopes(3, s, 2, q, &here);
            CHECK_NEAR(here.value, (u * u + r * r) / 2, 1e-15);
            CHECK_NEAR(here.gradient[0], u + u * r, 1e-15);
            CHECK_NEAR(here.gradient[1], 0, 0);
            bat_foot_step(&here, BOTH, t, step);
            CHECK_NEAR(step[0], -(u + u * r) / (trusted ? newton[0] : gauss[0]), 1e-14);
            CHECK_NEAR(step[1], 0, 0);
        }
}

TEST(where_tangents_span_no_plane_each_direction_steps_by_itself)
{
    const double s[] = {0, 0, 0, 1, 0, 0, 2, 0, 0}, q[] = {4, 0, 0};
    bat_foot_place here;
    double step[2];
    bat_foot_slopes(3, s, 1, q, &here);
    bat_foot_step(&here, BOTH, 0, step);
    CHECK_NEAR(step[0], 4, 0);
    CHECK_NEAR(step[1], 2, 0);
}

/* z = x y over [-1, 1]^2, moved so that the parameters are not the coordinates. */
static batten_surface *saddle(void)
{
    static const double points[][3] = {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}};
    static const double knots[] = {2, 2, 5, 5};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0], NULL, &surface));
    return surface;
}

/* From a start a tenth of the surface away, of a point nearer than that. */
TEST(the_way_down_ends_at_a_perpendicular_or_at_a_border)
{
    test_random random = test_random_begin("feet on a saddle");
    batten_surface *surface = saddle();
    const bat_foot_area all = {surface, {2, 2}, {5, 5}};
    for (int i = test_cases(200); i > 0; i--) {
        const double x = test_random_in(&random, -1, 1), y = test_random_in(&random, -1, 1);
        double q[3] = {x, y, x * y}, s[9], off[3], start[2] = {3.5 + 1.5 * x, 3.5 + 1.5 * y};
        for (int k = 0; k < 3; k++)
            q[k] += test_random_in(&random, -0.1, 0.1);
        for (int k = 0; k < 2; k++)
            start[k] = bat_min(5, bat_max(2, start[k] + test_random_in(&random, -0.3, 0.3)));
        for (int order = 1; order <= 2; order++) {
            bat_foot_place foot = {.at = {start[0], start[1]}};
            CHECK_OK(bat_foot_on_surface(&all, order, 50, q, &foot));
            CHECK_OK(batten_surface_evaluate(surface, foot.at[0], foot.at[1], 1, s));
            for (int c = 0; c < 3; c++)
                off[c] = s[c] - q[c];
            CHECK_NEAR(sqrt(2 * foot.value), bat_norm(3, off), 1e-14);
            for (int k = 0; k < 2; k++) {
                const double slope = bat_dot(3, off, s + 3 + 3 * k);
                CHECK(foot.at[k] >= 2 && foot.at[k] <= 5);
                CHECK(slope > -1e-6 || foot.at[k] == 5);
                CHECK(slope < 1e-6 || foot.at[k] == 2);
            }
        }
    }
    batten_surface_unref(surface);
}

TEST(an_area_keeps_the_foot_inside)
{
    batten_surface *surface = saddle();
    const bat_foot_area part = {surface, {2, 3}, {3, 4}};
    const double q[] = {1, 0, 0}; /* its foot is at u = 5 - something, beyond */
    bat_foot_place foot = {.at = {2.5, 3.25}};
    CHECK_OK(bat_foot_on_surface(&part, 2, 50, q, &foot));
    CHECK_NEAR(foot.at[0], 3, 0);
    CHECK(foot.at[1] > 3 && foot.at[1] < 4);
    CHECK(fabs(foot.gradient[1]) < 1e-12);
    CHECK(foot.gradient[0] < 0);
    batten_surface_unref(surface);
}

/* ---- the descent itself ---- */

typedef struct {
    int looks;
    double farthest[2];
} counted;

/* x^2 + y^2 as the value, with a gradient that is wrong by a factor. */
static batten_status look_at_bowl(const void *context, const double at[2], bat_foot_place *out)
{
    counted *count = *(counted *const *)context;
    count->looks++;
    *out = (bat_foot_place){.at = {at[0], at[1]}, .value = at[0] * at[0] + at[1] * at[1]};
    for (int k = 0; k < 2; k++) {
        out->gradient[k] = at[k];
        count->farthest[k] = bat_max(count->farthest[k], fabs(at[k]));
    }
    return BATTEN_OK;
}

/* Four times too far, on the other side. */
static void leap(const bat_foot_place *here, const bool free[2], double step[2])
{
    for (int k = 0; k < 2; k++)
        step[k] = free[k] ? -4 * here->gradient[k] : 0;
}

static bat_foot_descent bowl(counted *const *count)
{
    return (bat_foot_descent){.look = look_at_bowl,
                              .step = leap,
                              .context = count,
                              .low = {-HUGE_VAL, -HUGE_VAL},
                              .high = {HUGE_VAL, HUGE_VAL},
                              .longest = {HUGE_VAL, HUGE_VAL},
                              .steps = 1,
                              .halvings = 12};
}

TEST(a_step_that_leads_no_nearer_is_halved_until_one_does)
{
    counted count = {0}, *counting = &count;
    bat_foot_descent d = bowl(&counting);
    bat_foot_place foot = {.at = {1, -2}};
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_INT(count.looks, 4); /* the start, -3, -1, 0 of it */
    CHECK_NEAR(foot.at[0], 0, 0);
    CHECK_NEAR(foot.at[1], 0, 0);
    foot = (bat_foot_place){.at = {1, -2}};
    d.halvings = 2;
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.at[0], 1, 0);
    CHECK_NEAR(foot.at[1], -2, 0);
}

TEST(steps_are_cut_to_the_longest_and_left_when_both_are_below_the_least)
{
    counted count = {0}, *counting = &count;
    bat_foot_descent d = bowl(&counting);
    bat_foot_place foot = {.at = {1, -2}};
    d.longest[0] = d.longest[1] = 0.25;
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.at[0], 0.75, 0);
    CHECK_NEAR(foot.at[1], -1.75, 0);
    d.steps = 100;
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.value, 0, 1e-3);
    d.least[0] = 5;
    d.least[1] = 9;
    foot = (bat_foot_place){.at = {1, -2}};
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.at[0], 1, 0);
    d.least[1] = 7; /* the step is (-4, 8) */
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK(foot.at[0] < 1);
}

TEST(at_a_limit_only_steps_inwards_are_free)
{
    counted count = {0}, *counting = &count;
    bat_foot_descent d = bowl(&counting);
    bat_foot_place foot = {.at = {1, -2}};
    d.low[0] = 1;
    d.high[1] = -2;
    d.steps = 10;
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.at[0], 1, 0);
    CHECK_NEAR(foot.at[1], -2, 0);
    CHECK_INT(count.looks, 1);
    d.low[0] = -1;
    d.high[0] = 1;
    CHECK_OK(bat_foot_descend(&d, &foot));
    CHECK_NEAR(foot.at[0], 0, 0);
    CHECK_NEAR(count.farthest[0], 1, 0);
}

/* Second derivatives beside those without the shape, both with a mixed part: by each of the three conditions. */
TEST(newton_needs_its_share_of_both_diagonals_and_of_the_determinant)
{
    static const struct {
        double second[3], normal[3];
        bool is_trusted; /* with a trust of 1/2 */
    } cases[] = {
        {{2, 1, 2}, {4, 1, 3}, false},   {{2.5, 1, 2}, {4, 1, 3}, true},
        {{2.5, 1, 1}, {4, 1, 3}, false}, {{2.5, 1.5, 2}, {4, 1, 3}, false},
        {{3, 0, 2.5}, {4, 3, 4}, true},  {{3, 2.3, 2.5}, {4, 3, 4}, true},
        {{3, 2, 2.1}, {4, 1, 4}, false},
    };
    const double g[2] = {1, 3};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_foot_place here = {.gradient = {g[0], g[1]}};
        double step[2], due[2];
        memcpy(here.second, cases[i].second, sizeof here.second);
        memcpy(here.normal, cases[i].normal, sizeof here.normal);
        bat_foot_step(&here, BOTH, 0.5, step);
        CHECK(bat_foot_solve(cases[i].is_trusted ? here.second : here.normal, g, BOTH, due));
        CHECK_BITS(step[0], due[0]);
        CHECK_BITS(step[1], due[1]);
    }
}
