#include "numeric/jet.h"

#include "support/test.h"

/* f = (1 + u^2 v) / (2 - v) and its derivatives by hand at (0.5, 0.25). */
TEST(a_quotient_has_the_derivatives_worked_out_by_hand)
{
    const double u = 0.5, v = 0.25, w = 2 - v;
    const bat_jet ju = bat_jet_u(u), jv = bat_jet_v(v);
    const bat_jet top =
        bat_jet_add(bat_jet_constant(1), bat_jet_multiply(bat_jet_multiply(ju, ju), jv));
    const bat_jet f = bat_jet_divide(top, bat_jet_subtract(bat_jet_constant(2), jv));
    /* 1 / (2 - v) and v / (2 - v) = 2 / (2 - v) - 1, so f = (1 + 2 u^2) / w - u^2. */
    const double a = 1 + 2 * u * u;
    const double expected[BAT_JET_SIZE] = {
        a / w - u * u,       4 * u / w - 2 * u,      a / (w * w), 4 / w - 2,
        4 * u / (w * w),     2 * a / (w * w * w),    0,           4 / (w * w),
        8 * u / (w * w * w), 6 * a / (w * w * w * w)};
    for (int i = 0; i < BAT_JET_SIZE; i++)
        CHECK_NEAR(f.d[i], expected[i], 4 * DBL_EPSILON * (1 + fabs(expected[i])));
}

/* exp(u + u v): all derivatives of the outer function are equal. */
TEST(a_function_of_a_jet_obeys_the_chain_rule)
{
    const double u = 0.3, v = 1.1, e = exp(u + u * v);
    const bat_jet inner =
        bat_jet_add(bat_jet_u(u), bat_jet_multiply(bat_jet_u(u), bat_jet_v(v)));
    const bat_jet f = bat_jet_compose((const double[4]){e, e, e, e}, inner);
    const double a = 1 + v; /* fu = a f, fv = u f */
    const double expected[BAT_JET_SIZE] = {e,
                                           a * e,
                                           u * e,
                                           a * a * e,
                                           (1 + a * u) * e,
                                           u * u * e,
                                           a * a * a * e,
                                           (2 * a + a * a * u) * e,
                                           (2 * u + a * u * u) * e,
                                           u * u * u * e};
    for (int i = 0; i < BAT_JET_SIZE; i++)
        CHECK_NEAR(f.d[i], expected[i], 8 * DBL_EPSILON * (1 + fabs(expected[i])));
}

TEST(the_square_of_a_square_root_is_the_jet_itself)
{
    const bat_jet u = bat_jet_u(0.7), v = bat_jet_v(0.2);
    const bat_jet a =
        bat_jet_add(bat_jet_scale(3, u), bat_jet_multiply(u, bat_jet_multiply(v, v)));
    const bat_jet root = bat_jet_square_root(a), back = bat_jet_multiply(root, root);
    for (int i = 0; i < BAT_JET_SIZE; i++)
        CHECK_NEAR(back.d[i], a.d[i], 1e-14);
}
