/* Rails by their shares and by planes, against closed forms. */
#include "shape/sweep/rail_heights.h"

#include "support/test.h"

/* (u^3, 5, u^2) over [1, 2] as its blossom says, and (-u, 7, u^2 - 1) over the same: heights from 1 to 4 and
 * from 0 to 3. */
static bat_between between(bool by_planes)
{
    static const double knots[] = {1, 1, 1, 1, 2, 2, 2, 2};
    static const double points[2][4][3] = {
        {{1, 5, 1}, {2, 5, 5. / 3}, {4, 5, 8. / 3}, {8, 5, 4}},
        {{-1, 7, 0}, {-4. / 3, 7, 2. / 3}, {-5. / 3, 7, 5. / 3}, {-2, 7, 3}}};
    bat_between m = {.across = {0, 0, 1}, .by_planes = by_planes, .heights = {1, 3}};
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_curve_create((batten_points){3, 4, points[k][0]}, 3, NULL, knots,
                                     &m.rails[k]));
    return m;
}

static void forget(bat_between *m)
{
    for (int k = 0; k < 2; k++)
        batten_curve_unref(m->rails[k]);
}

static const double shares[] = {0, 0.3, 0.7, 1};

TEST(rails_by_shares_have_the_derivatives_of_their_domains)
{
    bat_between m = between(false);
    for (int i = 0; i < COUNT(shares); i++) {
        const double v = shares[i], u = 1 + v;
        const double x[5] = {u * u * u, 3 * u * u, 6 * u, 6, 0}, z[5] = {u * u, 2 * u, 2, 0, 0};
        double out[15], height;
        CHECK_OK(bat_rail_look(&m, 0, v, BATTEN_FROM_RIGHT, out));
        for (int k = 0; k < 5; k++) {
            CHECK_NEAR(out[3 * k], x[k], 1e-12);
            CHECK_NEAR(out[3 * k + 1], k ? 0 : 5, 1e-12);
            CHECK_NEAR(out[3 * k + 2], z[k], 1e-12);
        }
        CHECK_OK(bat_rail_height(&m, 1, u, &height));
        CHECK_NEAR(height, u * u - 1, 1e-14);
    }
    forget(&m);
}

/* The heights go from 1 to 3: h = 1 + 2 v, where u = h^(1/2) on the first rail and (h + 1)^(1/2) on the second. */
TEST(rails_by_planes_stand_at_one_height_with_four_derivatives)
{
    bat_between m = between(true);
    for (int i = 0; i < COUNT(shares); i++) {
        const double v = shares[i], h = 1 + 2 * v;
        /* Of h^(3/2), and of -(h + 1)^(1/2), by v. */
        double x = pow(h, 1.5), y = -sqrt(h + 1), out[2][15];
        for (int rail = 0; rail < 2; rail++)
            CHECK_OK(bat_rail_look(&m, rail, v, BATTEN_FROM_RIGHT, out[rail]));
        for (int k = 0; k < 5; k++) {
            CHECK_NEAR(out[0][3 * k], x, 1e-10);
            CHECK_NEAR(out[1][3 * k], y, 1e-10);
            for (int rail = 0; rail < 2; rail++) {
                CHECK_NEAR(out[rail][3 * k + 1], k ? 0 : 5 + 2 * rail, 1e-10);
                CHECK_NEAR(out[rail][3 * k + 2], k == 0 ? h : k == 1 ? 2 : 0, 1e-10);
            }
            x *= 2 * (1.5 - k) / h;
            y *= 2 * (0.5 - k) / (h + 1);
        }
    }
    forget(&m);
}

TEST(beyond_the_ends_of_a_rail_its_end_is_taken)
{
    bat_between m = between(true);
    double out[15];
    m.heights[0] = -5;
    m.heights[1] = 9;
    CHECK_OK(bat_rail_look(&m, 0, 0, BATTEN_FROM_RIGHT, out));
    CHECK_NEAR(out[0], 1, 0);
    CHECK_OK(bat_rail_look(&m, 0, 1, BATTEN_FROM_LEFT, out));
    CHECK_NEAR(out[0], 8, 0);
    forget(&m);
}

/* Seen from below it falls; seen along y it is level. */
TEST(a_rail_that_does_not_rise_is_named)
{
    bat_between m = between(true);
    double out[15];
    m.across = (batten_vec3){0, 1, 0};
    CHECK_STATUS(bat_rail_look(&m, 1, 0.5, BATTEN_FROM_RIGHT, out), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("rail 2 does not rise at 1 of its parameters");
    m.across = (batten_vec3){0, 0, -1};
    CHECK_STATUS(bat_rail_look(&m, 0, 0.5, BATTEN_FROM_RIGHT, out), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("rail 1 does not rise at ");
    forget(&m);
}
