#include "spline/spline.h"

#include "support/splines.h"

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

TEST(parts_and_pieces_are_the_same_function)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        const int p = test_random_int(&random, 1, 5);
        bat_spline s = {0}, low = {0}, high = {0}, part = {0}, bezier = {0};
        CHECK_OK(random_spline(&random, p, 2, &s));
        const double a = s.knots[p], b = s.knots[s.count];
        /* Cut at a knot as often as between two. */
        const double inner = s.knots[p + (s.count - p) / 2];
        const double u = c % 2 && inner > a && inner < b
                             ? inner
                             : a + test_random_in(&random, 0.3, 0.7) * (b - a);
        const double from = a + 0.3 * (u - a), to = u + 0.6 * (b - u);
        CHECK_OK(bat_spline_split(&s, u, &low, &high));
        CHECK_OK(bat_spline_subrange(&s, from, to, &part));
        CHECK_OK(bat_spline_to_bezier(&s, &bezier));
        const bat_spline *const parts[4] = {&low, &high, &part, &bezier};
        for (int k = 0; k < 4; k++) {
            const bat_spline *q = parts[k];
            const double ends[2] = {q->knots[p], q->knots[q->count]};
            CHECK_OK(bat_knots_check(p, q->count, q->knots, "knot"));
            CHECK_BITS(q->knots[0], ends[0]);
            CHECK_BITS(q->knots[q->count + p], ends[1]);
            CHECK_BITS(ends[0], k == 1 ? u : k == 2 ? from : a);
            CHECK_BITS(ends[1], k == 0 ? u : k == 2 ? to : b);
            for (int i = 1; i < 12; i++) {
                const double t = ends[0] + (ends[1] - ends[0]) * i / 12;
                for (size_t x = 0; x < 2; x++)
                    CHECK_NEAR(spline_by_definition(q, x, t, BATTEN_FROM_RIGHT, 0),
                               spline_by_definition(&s, x, t, BATTEN_FROM_RIGHT, 0), 1e-11);
            }
        }
        CHECK_INT((bezier.count - 1) % p, 0);
        for (int i = p + 1; i < bezier.count; i++)
            CHECK((i - p - 1) % p == 0 || bezier.knots[i] == bezier.knots[i - 1]);
        bat_spline_free(&s);
        for (int k = 0; k < 4; k++)
            bat_spline_free((bat_spline *[4]){&low, &high, &part, &bezier}[k]);
    }
}
