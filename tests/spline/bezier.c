#include "spline/spline.h"

#include "support/test.h"

static batten_status uniform(bat_spline *out)
{
    const batten_status status = bat_spline_make(3, 5, 1, out);
    for (int i = 0; status == BATTEN_OK && i < 9; i++)
        out->knots[i] = i - 3;
    const double values[] = {1, -2, 4, 3, 7};
    if (status == BATTEN_OK)
        memcpy(out->values, values, sizeof values);
    return status;
}

TEST(segments_of_uniform_cubics_become_bezier_as_in_the_notes)
{
    /* b = (1/6) [1 4 1 0; 0 4 2 0; 0 2 4 0; 0 1 4 1] V */
    const double matrix[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
    bat_spline spline = {0}, bezier = {0};
    CHECK_OK(uniform(&spline));
    CHECK_OK(bat_spline_to_bezier(&spline, &bezier));
    CHECK_INT(bezier.count, 7);
    for (int piece = 0; piece < 2; piece++)
        for (int j = 0; j < 4; j++) {
            double expected = 0;
            for (int k = 0; k < 4; k++)
                expected += matrix[j][k] * spline.values[piece + k] / 6;
            CHECK_NEAR(bezier.values[3 * piece + j], expected, 4e-15);
        }
    bat_spline_free(&bezier);
    bat_spline_free(&spline);
}

TEST(parts_are_clamped_and_share_the_row_at_the_cut)
{
    bat_spline spline = {0}, low = {0}, high = {0}, part = {0};
    CHECK_OK(uniform(&spline));
    CHECK_OK(bat_spline_split(&spline, 0.5, &low, &high));
    CHECK_INT(low.count, 4);
    CHECK_INT(high.count, 5);
    CHECK_BITS(low.values[3], high.values[0]);
    for (int i = 0; i < 4; i++)
        CHECK(low.knots[i] == 0 && low.knots[4 + i] == 0.5 && high.knots[i] == 0.5);
    CHECK_OK(bat_spline_subrange(&spline, 0.25, 1.5, &part));
    CHECK_INT(part.count, 5);
    CHECK(part.knots[3] == 0.25 && part.knots[4] == 1 && part.knots[5] == 1.5);
    bat_spline_free(&part);
    bat_spline_free(&high);
    bat_spline_free(&low);
    bat_spline_free(&spline);
}
