/* Canonical forms of whole curves, span by span, and the words for quintics. */
#include <batten/invariants.h>

#include "support/test.h"

/* Two quartic spans that meet at a knot of multiplicity 4: their Bezier points are the points of the curve. */
TEST(each_span_of_a_curve_has_the_form_of_its_bezier_points)
{
    static const double knots[14] = {0, 0, 0, 0, 0, 2, 2, 2, 2, 3, 3, 3, 3, 3};
    static const double points[18] = {0, 0, 1, 3,   2, -1, 4, 0, 5,
                                      1, 6, 2, 5.5, 4, 3,  5, 2, 2.5};
    batten_curve *curve = NULL;
    batten_canonicals forms = {0, NULL};
    CHECK_OK(batten_curve_create((batten_points){2, 9, points}, 4, NULL, knots, &curve));
    CHECK_OK(batten_curve_canonical_forms(curve, 1e-10, &forms));
    CHECK_INT(forms.count, 2);
    for (int i = 0; i < forms.count; i++) {
        batten_canonical due;
        CHECK_OK(batten_canonical_form(2, 4, points + 8 * i, 1e-10, &due));
        const batten_canonical *found = &forms.at[i];
        CHECK(found->dimension == 2 && found->count == due.count && due.count > 0);
        CHECK(found->has_shift == due.has_shift && found->base == due.base);
        CHECK_NEAR(found->shift, due.shift, 1e-12);
        CHECK_NEAR(found->radius, due.radius, 1e-12);
        for (int k = 0; k < due.count; k++)
            CHECK_NEAR(found->at[k].value, due.at[k].value, 1e-9 * fabs(due.at[k].value));
    }
    batten_canonicals_release(&forms);
    CHECK(forms.count == 0 && !forms.at);
    batten_curve_unref(curve);
}

TEST(rational_curves_have_no_canonical_form)
{
    static const double points[6] = {0, 0, 1, 2, 3, 0}, weights[3] = {1, 2, 1},
                        knots[6] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL;
    batten_canonicals forms = {7, NULL};
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, weights, knots, &curve));
    CHECK_STATUS(batten_curve_canonical_forms(curve, 1e-10, &forms), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("polynomial curves have a canonical form, rational ones have not");
    CHECK_INT(forms.count, 7);
    batten_curve_unref(curve);
}

TEST(every_case_of_quintics_has_a_name_and_a_sentence_of_its_own)
{
    for (int i = 0; i < BATTEN_QUINTIC_COUNT; i++)
        for (int j = 0; j <= BATTEN_QUINTIC_COUNT; j++) {
            const batten_quintic_case a = (batten_quintic_case)i, b = (batten_quintic_case)j;
            CHECK_INT(strcmp(batten_quintic_name(a), batten_quintic_name(b)) == 0, i == j);
            CHECK_INT(strcmp(batten_quintic_text(a), batten_quintic_text(b)) == 0, i == j);
        }
    CHECK_TEXT(batten_quintic_name((batten_quintic_case)BATTEN_QUINTIC_COUNT), "unknown");
    CHECK_TEXT(batten_quintic_text((batten_quintic_case)BATTEN_QUINTIC_COUNT), "unknown");
    CHECK_TEXT(batten_quintic_text((batten_quintic_case)-1), "unknown");
}
