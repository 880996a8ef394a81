#include "numeric/interval/jet.h"

#include "support/generate.h"
#include "support/test.h"

#include <stdlib.h>

/* Identities, by which every function's series is checked against the others'. */

static bat_interval_jet variable(const bat_jet_space *s, double x)
{
    bat_interval_jet made;
    bat_ijet_variable(s, 0, bat_interval_at(x), &made);
    return made;
}

static bat_interval_jet constant(const bat_jet_space *s, double x)
{
    bat_interval_jet made;
    bat_ijet_constant(s, bat_interval_at(x), &made);
    return made;
}

/* Is it x, or `value` alone, to rounding? */
static void check_identity(const bat_jet_space *s, const bat_interval_jet *a, double value,
                           double slope)
{
    for (int k = 0; k < s->count; k++) {
        const double expected = k == 0 ? value : k == 1 ? slope : 0;
        CHECK(a->c[k].lo <= expected && expected <= a->c[k].hi);
        CHECK(bat_interval_width(a->c[k]) < 1e-6);
    }
}

static bat_interval_jet applied(bat_jet_space *s, bat_ijet_function f, bat_interval_jet a)
{
    bat_ijet_apply(s, f, &a);
    return a;
}

TEST(inverse_functions_give_the_variable_back_with_all_derivatives)
{
    static const struct {
        bat_ijet_function outer, inner;
    } rows[] = {{BAT_IJET_SIN, BAT_IJET_ASIN},
                {BAT_IJET_COS, BAT_IJET_ACOS},
                {BAT_IJET_TAN, BAT_IJET_ATAN},
                {BAT_IJET_EXP, BAT_IJET_LN},
                {BAT_IJET_LN, BAT_IJET_EXP}};
    bat_jet_space s;
    bat_jet_space_begin(&s, 1, 6);
    for (int i = 0; i < COUNT(rows); i++)
        for (double x = 0.1; x < 0.8; x += 0.15) {
            const bat_interval_jet made =
                applied(&s, rows[i].outer, applied(&s, rows[i].inner, variable(&s, x)));
            check_identity(&s, &made, x, 1);
            CHECK_INT(s.state, BAT_DEFINED);
        }
}

/* f^2 + sign g^2 = 1 */
TEST(squares_of_sines_and_cosines_sum_to_one)
{
    static const struct {
        bat_ijet_function f, g;
        int sign;
    } rows[] = {{BAT_IJET_SIN, BAT_IJET_COS, 1}, {BAT_IJET_COSH, BAT_IJET_SINH, -1}};
    bat_jet_space s;
    bat_jet_space_begin(&s, 1, 6);
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_interval_jet two = constant(&s, 2), x = variable(&s, 0.7);
        bat_interval_jet f = applied(&s, rows[i].f, x), g = applied(&s, rows[i].g, x), sum;
        bat_ijet_power(&s, &f, &two, &f);
        bat_ijet_power(&s, &g, &two, &g);
        if (rows[i].sign > 0)
            bat_ijet_add(&s, &f, &g, &sum);
        else
            bat_ijet_subtract(&s, &f, &g, &sum);
        check_identity(&s, &sum, 1, 0);
    }
}

TEST(powers_multiply_as_their_exponents_add)
{
    static const double exponents[][2] = {{0.5, 0.5}, {3, -2}, {1.7, -0.7}, {-1, 2}};
    bat_jet_space s;
    bat_jet_space_begin(&s, 1, 6);
    for (int i = 0; i < COUNT(exponents); i++) {
        const bat_interval_jet p = constant(&s, exponents[i][0]),
                               q = constant(&s, exponents[i][1]);
        const bat_interval_jet x = variable(&s, 1.3);
        bat_interval_jet a, b, product;
        bat_ijet_power(&s, &x, &p, &a);
        bat_ijet_power(&s, &x, &q, &b);
        bat_ijet_multiply(&s, &a, &b, &product);
        check_identity(&s, &product, 1.3, 1);
    }
}

TEST(derivatives_over_an_interval_hold_those_at_its_points)
{
    test_random random = test_random_begin("boxes");
    bat_jet_space s;
    bat_jet_space_begin(&s, 2, 2);
    for (int i = 0; i < 2000; i++) {
        const double x = test_random_in(&random, -1, 1), y = test_random_in(&random, 0.1, 1);
        bat_interval_jet at[2][2], made[2];
        for (int wide = 0; wide < 2; wide++) {
            bat_ijet_variable(&s, 0, (bat_interval){x - 0.1 * wide, x + 0.2 * wide},
                              &at[wide][0]);
            bat_ijet_variable(&s, 1, (bat_interval){y - 0.05 * wide, y + 0.1 * wide},
                              &at[wide][1]);
            bat_interval_jet f = applied(&s, BAT_IJET_SIN, at[wide][0]), g;
            bat_ijet_divide(&s, &f, &at[wide][1], &g);
            bat_ijet_power(&s, &at[wide][1], &at[wide][0], &f);
            bat_ijet_multiply(&s, &f, &g, &made[wide]);
        }
        for (int k = 0; k < s.count; k++)
            CHECK(made[1].c[k].lo <= made[0].c[k].lo && made[0].c[k].hi <= made[1].c[k].hi);
    }
}

TEST(a_corner_has_bounded_slopes_and_no_further_derivative)
{
    bat_jet_space s;
    bat_interval_jet a;
    bat_jet_space_begin(&s, 1, 6);
    bat_ijet_variable(&s, 0, (bat_interval){-1, 2}, &a);
    bat_ijet_apply(&s, BAT_IJET_ABS, &a);
    CHECK(a.c[0].lo == 0 && a.c[0].hi == 2 && a.c[1].lo == -1 && a.c[1].hi == 1);
    CHECK(!bat_interval_is_finite(a.c[2]));
    for (int side = -1; side <= 1; side += 2) {
        s.side = side;
        a = applied(&s, BAT_IJET_ABS, variable(&s, 0));
        CHECK(a.c[0].hi == 0 && a.c[1].lo == side && a.c[1].hi == side);
    }
}

TEST(sides_are_those_of_one_variable)
{
    for (int side = -1; side <= 1; side++) {
        bat_jet_space s;
        bat_interval_jet a;
        bat_jet_space_begin(&s, 2, 2);
        s.side = side;
        bat_ijet_variable(&s, 0, bat_interval_at(0), &a);
        CHECK_INT(bat_ijet_side(&s, &a), 0);
        bat_jet_space_begin(&s, 1, 2);
        s.side = side;
        bat_ijet_variable(&s, 0, bat_interval_at(0), &a);
        CHECK_INT(bat_ijet_side(&s, &a), side);
        bat_ijet_multiply(&s, &a, &a, &a); /* above 0 on either side */
        CHECK_INT(bat_ijet_side(&s, &a), abs(side));
    }
}

TEST(what_has_no_value_is_said)
{
    bat_jet_space s;
    bat_interval_jet a, one;
    bat_jet_space_begin(&s, 1, 2);
    bat_ijet_variable(&s, 0, (bat_interval){-1, 2}, &a);
    bat_ijet_apply(&s, BAT_IJET_SQRT, &a);
    CHECK_INT(s.state, BAT_PARTLY);
    CHECK(a.c[0].lo == 0 && a.c[0].hi < 1.5);
    s.state = BAT_DEFINED;
    bat_ijet_variable(&s, 0, (bat_interval){-2, -1}, &a);
    bat_ijet_apply(&s, BAT_IJET_LN, &a);
    CHECK_INT(s.state, BAT_UNDEFINED);
    s.state = BAT_DEFINED;
    one = constant(&s, 1);
    bat_ijet_variable(&s, 0, (bat_interval){-1, 1}, &a);
    bat_ijet_divide(&s, &one, &a, &a);
    CHECK_INT(s.state, BAT_PARTLY);
    CHECK(!bat_interval_is_finite(a.c[0]));
}

static double absolute(double x)
{
    return fabs(x);
}

/* In the order of bat_ijet_function; each is smooth within `range`. */
static const struct {
    double (*value)(double);
    bat_interval range;
} functions[] = {{sin, {-9, 9}},    {cos, {-9, 9}},     {tan, {-1.4, 1.4}}, {asin, {-1, 1}},
                 {acos, {-1, 1}},   {atan, {-5, 5}},    {sinh, {-4, 4}},    {cosh, {-4, 4}},
                 {tanh, {-4, 4}},   {exp, {-5, 5}},     {log, {0.01, 9}},   {log10, {0.01, 9}},
                 {sqrt, {0.01, 9}}, {absolute, {-3, 3}}};

TEST(every_function_over_an_interval_holds_what_it_is_at_its_points)
{
    test_random random = test_random_begin("functions");
    bat_jet_space s;
    bat_jet_space_begin(&s, 1, 6);
    for (int f = 0; f < COUNT(functions); f++)
        for (int i = 0; i < 300; i++) {
            const bat_interval range = functions[f].range;
            const double a = test_random_in(&random, range.lo, range.hi),
                         b = fmin(a + test_random_in(&random, 0, 0.3), range.hi),
                         x = fmin(test_random_in(&random, a, b), b);
            bat_interval_jet wide, at = applied(&s, (bat_ijet_function)f, variable(&s, x));
            bat_ijet_variable(&s, 0, (bat_interval){a, b}, &wide);
            bat_ijet_apply(&s, (bat_ijet_function)f, &wide);
            CHECK_INT(s.state, BAT_DEFINED);
            const double value = functions[f].value(x);
            CHECK_NEAR(at.c[0].lo, value, 1e-12 * (1 + fabs(value)));
            CHECK_NEAR(at.c[0].hi, value, 1e-12 * (1 + fabs(value)));
            for (int k = 0; k < s.count; k++)
                CHECK(wide.c[k].lo <= at.c[k].lo && at.c[k].hi <= wide.c[k].hi);
            CHECK(bat_interval_width(wide.c[0]) < 200 * (b - a) + 1e-9);
        }
}

TEST(a_power_with_a_varying_exponent_has_the_derivatives_of_both)
{
    /* x^y: slopes y x^(y - 1) and x^y ln x, twist x^(y - 1) (1 + y ln x) */
    const double x = 1.7, y = 2.3, value = pow(x, y), l = log(x);
    const double expected[6] = {value,
                                y * value / x,
                                value * l,
                                y * (y - 1) * value / (x * x) / 2,
                                value / x * (1 + y * l),
                                value * l * l / 2};
    bat_jet_space s;
    bat_interval_jet base, exponent, made;
    bat_jet_space_begin(&s, 2, 2);
    bat_ijet_variable(&s, 0, bat_interval_at(x), &base);
    bat_ijet_variable(&s, 1, bat_interval_at(y), &exponent);
    bat_ijet_power(&s, &base, &exponent, &made);
    for (int k = 0; k < s.count; k++) {
        const int u = s.exponents[k][0], v = s.exponents[k][1];
        const int row = u + v == 0 ? 0 : u + v == 1 ? 1 + v : 3 + v;
        CHECK_NEAR(made.c[k].lo, expected[row], 1e-12);
        CHECK_NEAR(made.c[k].hi, expected[row], 1e-12);
    }
}

/* The lesser of x and 1 - x, which meet at 1/2, around and on either side of it. */
TEST(the_lesser_of_two_is_one_of_them_where_they_do_not_meet)
{
    static const struct {
        bat_interval at;
        int side;
        double slope; /* 0: between both */
    } rows[] = {{{0, 0.25}, 0, 1},    {{0, 0.5}, 0, 1},     {{0.75, 1}, 0, -1},
                {{0.5, 0.75}, 0, -1}, {{0.25, 0.75}, 0, 0}, {{0.5, 0.5}, 1, -1},
                {{0.5, 0.5}, -1, 1},  {{0.25, 0.25}, 1, 1}, {{0.75, 0.75}, -1, -1}};
    for (int i = 0; i < COUNT(rows); i++)
        for (int swapped = 0; swapped < 2; swapped++) {
            bat_jet_space s;
            bat_interval_jet x, y, made;
            bat_jet_space_begin(&s, 1, 3);
            s.side = rows[i].side;
            bat_ijet_variable(&s, 0, rows[i].at, &x);
            bat_ijet_constant(&s, bat_interval_at(1), &y);
            bat_ijet_subtract(&s, &y, &x, &y);
            bat_ijet_least(&s, swapped ? &y : &x, swapped ? &x : &y, &made);
            const double least = fmin(rows[i].at.lo, 1 - rows[i].at.hi),
                         most = fmin(rows[i].at.hi, 1 - rows[i].at.lo);
            CHECK_NEAR(made.c[0].lo, least, 1e-15);
            CHECK(made.c[0].hi >= fmin(most, 0.5) && made.c[0].hi <= most + 1e-15);
            if (rows[i].slope != 0) {
                CHECK(made.c[1].lo == rows[i].slope && made.c[1].hi == rows[i].slope);
                CHECK(made.c[2].lo == 0 && made.c[2].hi == 0);
            } else {
                CHECK(made.c[1].lo == -1 && made.c[1].hi == 1);
                CHECK(!bat_interval_is_finite(made.c[2]));
            }
            CHECK_INT(s.state, BAT_DEFINED);
        }
}

TEST(exact_values_stay_exact)
{
    static const struct {
        bat_ijet_function f;
        double at, value;
    } rows[] = {{BAT_IJET_SIN, 0, 0}, {BAT_IJET_ABS, -2, 2}};
    bat_jet_space s;
    bat_jet_space_begin(&s, 1, 3);
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_interval_jet made = applied(&s, rows[i].f, variable(&s, rows[i].at));
        CHECK(made.c[0].lo == rows[i].value && made.c[0].hi == rows[i].value);
    }
    /* a constant has no slope, whatever is done with it */
    bat_interval_jet a = constant(&s, 0.3), b = constant(&s, 0.7), c;
    bat_ijet_divide(&s, &a, &b, &c);
    bat_ijet_power(&s, &c, &b, &c);
    for (int k = 1; k < s.count; k++)
        CHECK(c.c[k].lo == 0 && c.c[k].hi == 0);
}

TEST(quotients_of_jets_have_the_derivatives_of_the_geometric_series)
{
    /* 1 / (1 - t) at t = 0: every coefficient is 1; at a box they hold those of its points */
    bat_jet_space s;
    bat_interval_jet one, divisor, made;
    bat_jet_space_begin(&s, 1, 6);
    one = constant(&s, 1);
    for (int wide = 0; wide < 2; wide++) {
        bat_ijet_variable(&s, 0, (bat_interval){-0.25 * wide, 0.25 * wide}, &divisor);
        bat_ijet_subtract(&s, &one, &divisor, &divisor);
        bat_ijet_divide(&s, &one, &divisor, &made);
        for (int k = 0; k < s.count; k++) {
            const double low = pow(1 + 0.25 * wide, -k - 1),
                         high = pow(1 - 0.25 * wide, -k - 1);
            CHECK(made.c[k].lo <= low && high <= made.c[k].hi);
            CHECK_NEAR(made.c[k].lo, low, 1e-13);
            CHECK_NEAR(made.c[k].hi, high, 1e-13);
        }
    }
    bat_ijet_divide(&s, &one, &(bat_interval_jet){.c = {{0, 0}}}, &made);
    CHECK_INT(s.state, BAT_UNDEFINED);
}

/* How many coefficients, and the orders of each: by total, the first variable first. */
static const struct {
    int variables, order, count;
    signed char exponents[BAT_JET_COEFFICIENTS][BAT_JET_VARIABLES];
} spaces[] = {
    {1, 0, 1, {{0, 0, 0}}},
    {1, 6, 7, {{0}, {1}, {2}, {3}, {4}, {5}, {6}}},
    {2, 1, 3, {{0}, {1, 0}, {0, 1}}},
    {2, 2, 6, {{0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}},
    {3, 0, 1, {{0}}},
    {3, 1, 4, {{0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
};

TEST(the_coefficients_of_a_space_are_all_orders_up_to_the_total)
{
    for (int r = 0; r < COUNT(spaces); r++) {
        bat_jet_space s;
        bat_jet_space_begin(&s, spaces[r].variables, spaces[r].order);
        CHECK_INT(s.count, spaces[r].count);
        CHECK(s.state == BAT_DEFINED && s.side == 0 && s.order == spaces[r].order);
        for (int a = 0; a < s.count; a++)
            for (int b = 0; b < s.count; b++) {
                int total = 0, at = s.product[a][b];
                for (int v = 0; v < BAT_JET_VARIABLES; v++) {
                    const int sum = s.exponents[a][v] + s.exponents[b][v];
                    CHECK_INT(s.exponents[a][v], spaces[r].exponents[a][v]);
                    total += sum;
                    CHECK(at < 0 || s.exponents[at][v] == sum);
                }
                CHECK_INT(at >= 0, total <= s.order);
            }
    }
}

TEST(what_is_forgotten_is_everything_from_an_order_on)
{
    for (int r = 0; r < COUNT(spaces); r++)
        for (int first = 0; first <= 7; first++) {
            bat_jet_space s;
            bat_interval_jet a;
            bat_jet_space_begin(&s, spaces[r].variables, spaces[r].order);
            for (int i = 0; i < s.count; i++)
                a.c[i] = bat_interval_at(i + 1);
            bat_ijet_forget(&s, first, &a);
            for (int i = 0; i < s.count; i++) {
                const signed char *e = spaces[r].exponents[i];
                const bool kept = e[0] + e[1] + e[2] < first;
                CHECK(a.c[i].lo == (kept ? i + 1 : -INFINITY));
                CHECK(a.c[i].hi == (kept ? i + 1 : INFINITY));
            }
        }
}
