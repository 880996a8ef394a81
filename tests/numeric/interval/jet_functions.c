/* Elementary functions of jets: where they have values and slopes. */
#include "numeric/interval/jet.h"
#include "support/test.h"

TEST(functions_end_with_their_domains_and_have_no_slope_there)
{
    const double quarter = 1.5707963267948966;
    const struct {
        bat_ijet_function f;
        bat_interval range;
        bat_definition state;
        bat_interval value; /* infinite: not known */
    } rows[] = {
        {BAT_IJET_ASIN, {-1.5, 0.5}, BAT_PARTLY, {-quarter, asin(0.5)}},
        {BAT_IJET_ASIN, {0.5, 1.5}, BAT_PARTLY, {asin(0.5), quarter}},
        {BAT_IJET_ASIN, {-1, 1}, BAT_DEFINED, {-quarter, quarter}},
        {BAT_IJET_ASIN, {0.5, 1}, BAT_DEFINED, {asin(0.5), quarter}},
        {BAT_IJET_ASIN, {1.25, 1.5}, BAT_UNDEFINED, BAT_EVERYTHING},
        {BAT_IJET_ACOS, {-1.5, 0.5}, BAT_PARTLY, {acos(0.5), 2 * quarter}},
        {BAT_IJET_ACOS, {-3, -2}, BAT_UNDEFINED, BAT_EVERYTHING},
        {BAT_IJET_LN, {0, 2}, BAT_PARTLY, {-HUGE_VAL, log(2)}},
        {BAT_IJET_LN, {-2, 0}, BAT_UNDEFINED, BAT_EVERYTHING},
        {BAT_IJET_LOG10, {-2, -1}, BAT_UNDEFINED, BAT_EVERYTHING},
        {BAT_IJET_SQRT, {0, 4}, BAT_DEFINED, {0, 2}},
        {BAT_IJET_SQRT, {-1, 4}, BAT_PARTLY, {0, 2}},
        {BAT_IJET_SQRT, {-2, -1}, BAT_UNDEFINED, BAT_EVERYTHING},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_jet_space s;
        bat_interval_jet a;
        bat_jet_space_begin(&s, 1, 3);
        bat_ijet_variable(&s, 0, rows[i].range, &a);
        bat_ijet_apply(&s, rows[i].f, &a);
        CHECK_INT(s.state, rows[i].state);
        for (int k = 1; k < s.count; k++)
            CHECK(!bat_interval_is_finite(a.c[k]));
        CHECK(a.c[0].lo <= rows[i].value.lo && rows[i].value.hi <= a.c[0].hi);
        if (isfinite(rows[i].value.lo))
            CHECK_NEAR(a.c[0].lo, rows[i].value.lo, 1e-14);
        if (isfinite(rows[i].value.hi))
            CHECK_NEAR(a.c[0].hi, rows[i].value.hi, 1e-14);
    }
}

TEST(powers_below_zero_need_a_base_above_it)
{
    static const struct {
        bat_interval base;
        double exponent;
        bat_definition state;
    } rows[] = {{{0, 1}, -0.5, BAT_PARTLY},  {{-1, 0}, -0.5, BAT_UNDEFINED},
                {{-1, 1}, 0.5, BAT_PARTLY},  {{-1, 0}, 0.5, BAT_PARTLY},
                {{1, 2}, -0.5, BAT_DEFINED}, {{-1, 1}, 3, BAT_DEFINED},
                {{-1, 1}, -3, BAT_PARTLY},   {{-2, -1}, -3, BAT_DEFINED}};
    for (int i = 0; i < COUNT(rows); i++) {
        bat_jet_space s;
        bat_interval_jet base, exponent, made;
        bat_jet_space_begin(&s, 1, 2);
        bat_ijet_variable(&s, 0, rows[i].base, &base);
        bat_ijet_constant(&s, bat_interval_at(rows[i].exponent), &exponent);
        bat_ijet_power(&s, &base, &exponent, &made);
        CHECK_INT(s.state, rows[i].state);
        if (rows[i].exponent == 0.5) { /* the value is known also where the slope is not */
            CHECK(made.c[0].lo == 0 && made.c[0].hi >= sqrt(rows[i].base.hi));
            CHECK_NEAR(made.c[0].hi, sqrt(rows[i].base.hi), 1e-14);
        }
    }
}
