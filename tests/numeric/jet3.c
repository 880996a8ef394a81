#include "numeric/jet3.h"

#include "support/test.h"

/* (t, t^2, t^3) and its derivatives at t. */
static bat_jet3 twisted(double t)
{
    const double values[12] = {t, t * t, t * t * t, 1, 2 * t, 3 * t * t, 0, 2, 6 * t, 0, 0, 6};
    return bat_jet3_of_v(3, values);
}

TEST(derivatives_of_vectors_are_those_of_their_products)
{
    const double h = 1e-5;
    bat_jet3 at[3], unit[3], cross[3];
    for (int k = 0; k < 3; k++) {
        at[k] = twisted(0.7 + (k - 1) * h);
        unit[k] = bat_jet3_unit(at[k]);
        cross[k] = bat_jet3_cross(at[k], bat_jet3_constant((batten_vec3){1, -2, 0.5}));
    }
    for (int order = 0; order < 3; order++) {
        const bat_jet3 *const rows[2] = {unit, cross};
        for (int r = 0; r < 2; r++) {
            const batten_vec3 low = bat_jet3_in_v(&rows[r][0], order),
                              high = bat_jet3_in_v(&rows[r][2], order),
                              slope = bat_jet3_in_v(&rows[r][1], order + 1);
            CHECK_NEAR(slope.x, (high.x - low.x) / (2 * h), 1e-7);
            CHECK_NEAR(slope.y, (high.y - low.y) / (2 * h), 1e-7);
            CHECK_NEAR(slope.z, (high.z - low.z) / (2 * h), 1e-7);
        }
    }
    const bat_jet one = bat_jet3_dot(unit[1], unit[1]);
    CHECK_NEAR(bat_jet_in_v(&one, 0), 1, 1e-15);
    for (int order = 1; order < 4; order++)
        CHECK_NEAR(bat_jet_in_v(&one, order), 0, 1e-13);
}
