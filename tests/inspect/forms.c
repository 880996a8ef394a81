#include "inspect/forms.h"
#include "support/test.h"

static double binomial(int n, int k)
{
    double value = 1;
    for (int i = 0; i < k; i++)
        value = value * (n - i) / (i + 1);
    return value;
}

static double value(bat_form form, double t)
{
    double sum = 0;
    for (int k = 0; k <= form.degree; k++)
        sum += form.c[k] * pow(t, k) * pow(1 - t, form.degree - k);
    return sum;
}

static bat_form random_form(test_random *random, int degree, double *c)
{
    for (int k = 0; k <= degree; k++)
        c[k] = binomial(degree, k) * test_random_in(random, -1, 1);
    return (bat_form){degree, c, 0};
}

TEST(sums_products_and_derivatives_have_the_values_of_what_they_are)
{
    test_random random = test_random_begin("forms");
    bat_forms forms = {0};
    CHECK_OK(bat_forms_begin(16, 24, &forms));
    for (int n = test_cases(100); n > 0; n--) {
        double ca[16], cb[16];
        const bat_form a = random_form(&random, test_random_int(&random, 0, 9), ca);
        const bat_form b = random_form(&random, test_random_int(&random, 0, 9), cb);
        forms.used = 0;
        const bat_form product = bat_form_product(&forms, a, b);
        const bat_form sum = bat_form_sum(&forms, a, -3, b);
        const bat_form derivative = bat_form_derivative(&forms, a);
        const double t = test_random_unit(&random), h = 1e-5;
        CHECK_NEAR(value(product, t), value(a, t) * value(b, t), 1e-13);
        CHECK_NEAR(value(sum, t), value(a, t) - 3 * value(b, t), 1e-13);
        CHECK_NEAR(value(derivative, t), (value(a, t + h) - value(a, t - h)) / (2 * h), 1e-6);
    }
    bat_forms_end(&forms);
}

/* Bernstein coefficients, scaled, of the product of (t - root[i]). */
static bat_form from_roots(bat_forms *forms, int count, const double *roots)
{
    static double one = 1;
    bat_form form = {0, &one, 0};
    for (int i = 0; i < count; i++) {
        double c[2] = {-roots[i], 1 - roots[i]};
        form = bat_form_product(forms, form, (bat_form){1, c, 0});
    }
    return form;
}

TEST(a_walk_notes_the_simple_and_triple_roots_and_passes_the_double_ones)
{
    static const struct {
        int count, expected;
        double roots[6], found[4];
    } cases[] = {{1, 1, {0.3}, {0.3}},
                 {2, 2, {0.3, 0.30001}, {0.3, 0.30001}},
                 {2, 0, {0.3, 0.3}, {0}},
                 {3, 1, {0.5, 0.5, 0.5}, {0.5}},
                 {1, 1, {0.5}, {0.5}},
                 {3, 2, {0.25, 0.5, 1.5}, {0.25, 0.5}},
                 {4, 2, {0, 0.5, 0.75, 1}, {0.5, 0.75}},
                 {2, 0, {-0.1, 1.1}, {0}},
                 {4, 4, {0.125, 0.25, 0.5, 0.75}, {0.125, 0.25, 0.5, 0.75}}};
    for (int c = 0; c < COUNT(cases); c++) {
        bat_forms forms = {0};
        bat_walk walk = {0};
        CHECK_OK(bat_forms_begin(8, 6, &forms));
        const bat_form form = from_roots(&forms, cases[c].count, cases[c].roots);
        CHECK_OK(bat_walk_piece(&walk, form, 10, 12));
        CHECK_INT(walk.count, cases[c].expected);
        for (int k = 0; k < walk.count; k++)
            CHECK_NEAR(walk.at[k], 10 + 2 * cases[c].found[k],
                       cases[c].count == 3 ? 1e-4 : 1e-10);
        bat_walk_end(&walk);
        bat_forms_end(&forms);
    }
}

TEST(a_change_of_sign_between_pieces_is_noted_once_even_across_a_piece_of_zeros)
{
    double up[2] = {1, 2}, zero[2] = {0, 0}, down[2] = {-1, -3};
    bat_walk walk = {0};
    CHECK_OK(bat_walk_piece(&walk, (bat_form){1, up, 0}, 0, 1));
    CHECK_OK(bat_walk_piece(&walk, (bat_form){1, zero, 0}, 1, 2));
    CHECK_OK(bat_walk_piece(&walk, (bat_form){1, down, 0}, 2, 3));
    CHECK_INT(walk.count, 1);
    CHECK_NEAR(walk.at[0], 2, 0);
    CHECK_OK(bat_walk_close(&walk, 0));
    CHECK_INT(walk.count, 2);
    CHECK_NEAR(walk.at[0], 0, 0);
    bat_walk_end(&walk);
    CHECK_OK(bat_walk_close(&walk, 0)); /* nothing seen, nothing to close */
    CHECK_INT(walk.count, 0);
}

TEST(roundoff_where_a_form_touches_0_at_its_end_hides_no_root)
{
    /* 2 t^3 - 3 t^2 (1 - t) changes sign at 3/5; what stands before it is roundoff. */
    const double noise[4][2] = {{0, 0}, {1e-17, -2e-17}, {-1e-17, 2e-17}, {1e-17, 1e-17}};
    for (int i = 0; i < 4; i++)
        for (int back = 0; back < 2; back++) {
            double c[4] = {noise[i][0], noise[i][1], -3, 2};
            if (back) {
                const double reversed[4] = {2, -3, noise[i][1], noise[i][0]};
                memcpy(c, reversed, sizeof c);
            }
            bat_walk walk = {0};
            CHECK_OK(bat_walk_piece(&walk, (bat_form){3, c, 1e-16}, 0, 1));
            CHECK_INT(walk.count, 1);
            CHECK_NEAR(walk.at[0], back ? 0.4 : 0.6, 1e-15);
            bat_walk_end(&walk);
        }
}
