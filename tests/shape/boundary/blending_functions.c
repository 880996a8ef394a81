#include <batten/coons.h>

#include "support/faults.h"
#include "support/test.h"

static const batten_blending families[] = {BATTEN_BLENDING_LINEAR, BATTEN_BLENDING_CUBIC,
                                           BATTEN_BLENDING_QUINTIC, BATTEN_BLENDING_COONS};
static const int orders[] = {1, 2, 3, 3}, smooth[] = {0, 1, 2, 2};

static double value(const batten_curve *function, double t)
{
    double out;
    CHECK_OK(batten_curve_evaluate(function, t, 0, &out));
    return out;
}

static void release(batten_curve **functions, int count)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(functions[i]);
}

TEST(every_family_keeps_the_axioms_and_is_linear_precise)
{
    for (int f = 0; f < 4; f++) {
        batten_curve *functions[6] = {NULL};
        const int order = orders[f];
        CHECK_EACH_ALLOCATION(batten_blending_functions(families[f], order, functions));
        CHECK_OK(
            batten_blending_check(order, (const batten_curve *const *)functions, smooth[f]));
        for (int i = 0; i <= 30; i++) {
            const double t = i / 30.0;
            CHECK_NEAR(value(functions[0], t) + value(functions[1], t), 1, 1e-15);
            if (order > 1)
                CHECK_NEAR(value(functions[1], t) + value(functions[2], t) +
                               value(functions[3], t),
                           t, 1e-15);
        }
        release(functions, 2 * order);
    }
}

/* Values and matrices of his paper: F0 at the thirds, the greatest G0; S^3 .. 1 of a segment.
 */
TEST(coons_splines_have_the_values_of_his_figures)
{
    batten_curve *functions[6] = {NULL};
    CHECK_EACH_ALLOCATION(batten_blending_functions(BATTEN_BLENDING_COONS, 3, functions));
    CHECK_NEAR(value(functions[0], 1 / 3.0), 5 / 6.0, 1e-15);
    CHECK_NEAR(value(functions[0], 0.5), 0.5, 1e-15);
    CHECK_NEAR(value(functions[0], 2 / 3.0), 1 / 6.0, 1e-15);
    CHECK_NEAR(value(functions[2], 1 / 3.0), 2 / 9.0, 1e-15);
    static const double f0[3][4] = {{-1, 0, 0, 6}, {2, -3, -3, 5}, {-1, 3, -3, 1}};
    static const double g0[3][4] = {{-2, 0, 6, 0}, {3, -6, 0, 4}, {-1, 3, -3, 1}};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i <= 8; i++) {
            const double s = i / 8.0, t = (k + s) / 3;
            const double f = ((f0[k][0] * s + f0[k][1]) * s + f0[k][2]) * s + f0[k][3];
            const double g = ((g0[k][0] * s + g0[k][1]) * s + g0[k][2]) * s + g0[k][3];
            CHECK_NEAR(value(functions[0], t), f / 6, 1e-15);
            CHECK_NEAR(value(functions[2], t), g / 18, 1e-15);
        }
    release(functions, 6);
}

TEST(what_a_family_lacks_is_unsupported)
{
    batten_curve *functions[6];
    CHECK_STATUS(batten_blending_functions(BATTEN_BLENDING_LINEAR, 2, functions),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("no G");
    CHECK_STATUS(batten_blending_functions(BATTEN_BLENDING_CUBIC, 3, functions),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("no H");
    CHECK_STATUS(batten_blending_functions(BATTEN_BLENDING_COONS, 4, functions),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_blending_functions(BATTEN_BLENDING_GIVEN, 1, functions),
                 BATTEN_BAD_ARGUMENT);
}

TEST(a_function_that_breaks_an_axiom_is_named)
{
    batten_curve *functions[4] = {NULL}, *bent = NULL;
    const double point = 0.25;
    CHECK_OK(batten_blending_functions(BATTEN_BLENDING_CUBIC, 2, functions));
    const batten_curve *given[4];
    for (int i = 0; i < 4; i++)
        given[i] = functions[i];
    CHECK_STATUS(batten_blending_check(2, given, 2), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("F0: the second derivative at 0 is -6, not 0");
    CHECK_OK(batten_curve_with_point(functions[3], 2, &point, &bent));
    given[3] = bent;
    CHECK_STATUS(batten_blending_check(2, given, 1), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("G1: the slope at 1 is -0.75, not 1");
    CHECK_EACH_ALLOCATION(batten_blending_check(2, given, 0));
    batten_curve *longer = NULL;
    CHECK_OK(batten_curve_set_domain(functions[1], 0, 2, &longer));
    given[1] = longer;
    CHECK_STATUS(batten_blending_check(2, given, 0), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("F1 is given over [0, 2]");
    CHECK_STATUS(batten_blending_check(2, given, 3), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(longer);
    batten_curve_unref(bent);
    release(functions, 4);
}

static const struct {
    int family, order;
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_BLENDING_COONS, 0, BATTEN_BAD_ARGUMENT, "the order is 0, not 1 to 3"},
    {BATTEN_BLENDING_COONS, 4, BATTEN_BAD_ARGUMENT, "the order is 4, not 1 to 3"},
    {-1, 1, BATTEN_BAD_ARGUMENT, "there is no family -1 of blending functions"},
    {BATTEN_BLENDING_COONS + 1, 1, BATTEN_BAD_ARGUMENT,
     "there is no family 4 of blending functions"},
    {BATTEN_BLENDING_LINEAR, 2, BATTEN_UNSUPPORTED,
     "linear blending functions have no G: order 1 at most"},
    {BATTEN_BLENDING_CUBIC, 3, BATTEN_UNSUPPORTED,
     "cubic blending functions have no H: order 2 at most"},
};

TEST(orders_and_families_of_blending_functions_are_checked_with_their_numbers)
{
    batten_curve *functions[6] = {NULL};
    for (int i = 0; i < COUNT(refused); i++) {
        CHECK_STATUS(batten_blending_functions((batten_blending)refused[i].family,
                                               refused[i].order, functions),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
        CHECK(!functions[0]);
    }
    CHECK_OK(batten_blending_functions(BATTEN_BLENDING_CUBIC, 2, functions));
    const batten_curve *const *made = (const batten_curve *const *)functions;
    CHECK_STATUS(batten_blending_check(0, made, 1), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the order is 0, not 1 to 3");
    CHECK_STATUS(batten_blending_check(4, made, 1), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the order is 4, not 1 to 3");
    CHECK_STATUS(batten_blending_check(2, made, 3), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("3 derivatives cannot be looked at, only 0 to 2");
    CHECK_STATUS(batten_blending_check(2, made, -1), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("-1 derivatives cannot be looked at, only 0 to 2");
    release(functions, 4);
}
