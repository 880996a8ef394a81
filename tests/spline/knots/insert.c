#include "spline/spline.h"

#include "support/generate.h"

/* Marsden: the rows prod (tau - U[i + j]) make (tau - u)^p; on any refined knots they are of
 * the same form. */
static void fill_marsden(bat_spline *spline, double tau)
{
    for (int i = 0; i < spline->count; i++) {
        spline->values[i] = 1;
        for (int j = 1; j <= spline->degree; j++)
            spline->values[i] *= tau - spline->knots[i + j];
    }
}

static batten_status make_random(test_random *random, bat_spline *out)
{
    const test_wish wish = {.tame = true};
    const int p = test_random_int(random, 1, 6), n = test_point_count(random, &wish, p);
    const batten_status status = bat_spline_make(p, n, 1, out);
    if (status == BATTEN_OK) {
        test_knots(random, &wish, p, n, out->knots);
        fill_marsden(out, -1);
    }
    return status;
}

static void check_marsden(const bat_spline *spline)
{
    bat_spline expected = {0};
    CHECK_OK(bat_spline_make(spline->degree, spline->count, 1, &expected));
    memcpy(expected.knots, spline->knots,
           (size_t)(spline->count + spline->degree + 1) * sizeof(double));
    fill_marsden(&expected, -1);
    for (int i = 0; i < spline->count; i++)
        CHECK_NEAR(spline->values[i] / expected.values[i], 1, 1e-12);
    bat_spline_free(&expected);
}

TEST(inserted_rows_satisfy_marsden)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        bat_spline spline = {0}, made = {0};
        CHECK_OK(make_random(&random, &spline));
        const double a = spline.knots[spline.degree], b = spline.knots[spline.count];
        double knots[5];
        for (int k = 0; k < 5; k++)
            knots[k] = (k ? knots[k - 1] : a) + (b - a) / 7;
        CHECK_OK(bat_spline_insert(&spline, 5, knots, &made));
        check_marsden(&made);
        bat_spline_free(&made);
        bat_spline_free(&spline);
    }
}

TEST(elevated_rows_satisfy_marsden_for_the_lower_degree)
{
    /* The mean over i of the products without knot i is the elevated form of (tau - u)^p. */
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(300); i++) {
        bat_spline spline = {0}, made = {0};
        CHECK_OK(make_random(&random, &spline));
        CHECK_OK(bat_spline_elevate(&spline, 1, &made));
        for (int k = 0; k < made.count; k++) {
            double mean = 0;
            for (int skip = 1; skip <= made.degree; skip++) {
                double product = 1;
                for (int j = 1; j <= made.degree; j++)
                    product *= j == skip ? 1 : -1 - made.knots[k + j];
                mean += product / made.degree;
            }
            CHECK_NEAR(made.values[k] / mean, 1, 1e-12);
        }
        bat_spline_free(&made);
        bat_spline_free(&spline);
    }
}

TEST(rows_out_of_reach_keep_their_bits)
{
    bat_spline spline = {0}, made = {0};
    const double u[] = {4.5};
    CHECK_OK(bat_spline_make(2, 9, 1, &spline));
    for (int i = 0; i < 12; i++)
        spline.knots[i] = i - 2;
    for (int i = 0; i < 9; i++)
        spline.values[i] = 0.1 * i * i;
    CHECK_OK(bat_spline_insert(&spline, 1, u, &made));
    for (int i = 0; i < 9; i++)
        if (i < 5 || i > 5)
            CHECK_BITS(made.values[i < 5 ? i : i + 1], spline.values[i]);
    bat_spline_free(&made);
    bat_spline_free(&spline);
}

/* Knots 0 0 0 1 2 2 2 of degree 2, and others that are to join them. */
static const struct {
    int added;
    double knots[3];
    bool periodic;
    batten_status status;
    const char *words;
} insertions[] = {
    {3, {0.5, 1, 1.5}, false, BATTEN_OK, ""},
    {3,
     {0.5, 1.5, 1.25},
     false,
     BATTEN_NOT_INCREASING,
     "knot 3 to insert is 1.25, below knot 2, which is 1.5"},
    {2,
     {1.5, 0.5},
     false,
     BATTEN_NOT_INCREASING,
     "knot 2 to insert is 0.5, below knot 1, which is 1.5"},
    {2,
     {0.5, 2.5},
     false,
     BATTEN_OUT_OF_DOMAIN,
     "knot 2 to insert is 2.5, not in the domain [0, 2]"},
    {1,
     {-0.5},
     false,
     BATTEN_OUT_OF_DOMAIN,
     "knot 1 to insert is -0.5, not in the domain [0, 2]"},
    {3, {0.5, 0.75, NAN}, false, BATTEN_NOT_FINITE, "knot 3 to insert is nan"},
};

TEST(knots_to_insert_are_refused_by_their_number)
{
    static const double knots[7] = {0, 0, 0, 1, 2, 2, 2};
    for (int i = 0; i < COUNT(insertions); i++) {
        CHECK_STATUS(bat_knots_check_insertion(2, 4, knots, insertions[i].periodic,
                                               insertions[i].added, insertions[i].knots),
                     insertions[i].status);
        if (insertions[i].status != BATTEN_OK)
            CHECK_MESSAGE(insertions[i].words);
    }
}
