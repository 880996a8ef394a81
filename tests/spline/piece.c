#include "spline/spline.h"

#include "support/test.h"

TEST(binomials_are_pascals)
{
    for (int p = 1; p <= BATTEN_MAX_DEGREE; p++)
        for (int i = 1; i < p; i++)
            CHECK_BITS(bat_binomials[p][i],
                       bat_binomials[p - 1][i - 1] + bat_binomials[p - 1][i]);
}

TEST(bernstein_polynomials_sum_to_one_and_give_x_squared_its_bernstein_form)
{
    double b[BATTEN_MAX_DEGREE + 1];
    for (int n = 1; n <= BATTEN_MAX_DEGREE; n++)
        for (double x = 0; x <= 1; x += 0.125) {
            double sum = 0, square = 0;
            bat_bernstein(n, x, 1 - x, b);
            for (int i = 0; i <= n; i++) {
                CHECK(b[i] >= 0);
                sum += b[i];
                square += b[i] * i * i / n / n;
            }
            CHECK_NEAR(sum, 1, 4 * n * 0x1p-53);
            CHECK_NEAR(square, x * x + x * (1 - x) / n, 1e-14); /* B_n(x^2) [S] */
        }
    bat_bernstein(5, 1, 0, b);
    CHECK(b[5] == 1 && b[4] == 0 && b[0] == 0);
}

TEST(unisurf_functions_are_sums_of_bernstein_polynomials)
{
    /* f_i = (-t)^i / (i - 1)! d^(i-1)/dt^(i-1) [((1 - t)^n - 1) / t]; n = 3: f_1 = 3t - 3t^2 +
     * t^3, f_2 = 3t^2 - 2t^3, f_3 = t^3. */
    double b[4];
    for (double t = 0; t <= 1; t += 0.125) {
        bat_bernstein(3, t, 1 - t, b);
        CHECK_NEAR(b[1] + b[2] + b[3], 3 * t - 3 * t * t + t * t * t, 1e-15);
        CHECK_NEAR(b[2] + b[3], 3 * t * t - 2 * t * t * t, 1e-15);
        CHECK_NEAR(b[3], t * t * t, 1e-15);
    }
}

TEST(rows_and_their_derivatives_agree_either_way)
{
    const double knots[] = {0, 0, 1, 1.5, 3, 4, 4, 6};
    double bezier[4] = {1, 3, -2, 5}, rows[4] = {1, 3, -2, 5};
    bat_piece_from_rows(3, knots, 3, 1, bezier);
    bat_piece_derive(3, 1.5, 1, bezier);
    bat_rows_derive(3, knots, 3, 1, rows);
    bat_piece_from_rows(2, knots, 3, 1, rows);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(rows[i], bezier[i], 1e-14);
}

/* Uneven knots, one of them double, and the spans whose rows are taken. */
static const double uneven[] = {-3, -2, -0.5, 0, 1, 1.5, 3, 4, 4, 6, 7};
enum { WIDTH = 3 };

/* Control rows of t^p, t and 1: their blossoms at the knots. */
static void blossom_rows(int p, int span, double *rows)
{
    for (int j = 0; j <= p; j++) {
        double product = 1, sum = 0;
        for (int k = 1; k <= p; k++) {
            product *= uneven[span - p + j + k];
            sum += uneven[span - p + j + k];
        }
        rows[WIDTH * j] = product;
        rows[WIDTH * j + 1] = sum / p;
        rows[WIDTH * j + 2] = 1;
    }
}

static double power(double x, int n)
{
    return n > 0 ? x * power(x, n - 1) : 1;
}

TEST(the_bezier_rows_of_a_span_are_blossoms_at_its_ends)
{
    for (int p = 1; p <= 4; p++)
        for (int span = p; span <= 9 - p; span++) {
            const double a = uneven[span], b = uneven[span + 1];
            double rows[5 * WIDTH];
            if (a == b)
                continue;
            blossom_rows(p, span, rows);
            bat_piece_from_rows(p, uneven, span, WIDTH, rows);
            for (int j = 0; j <= p; j++) {
                CHECK_NEAR(rows[WIDTH * j], power(a, p - j) * power(b, j), 1e-11);
                CHECK_NEAR(rows[WIDTH * j + 1], a + (b - a) * j / p, 1e-14);
                CHECK_NEAR(rows[WIDTH * j + 2], 1, 1e-15);
            }
            bat_piece_derive(p, b - a, WIDTH, rows);
            for (int j = 0; j < p; j++) {
                CHECK_NEAR(rows[WIDTH * j], p * power(a, p - 1 - j) * power(b, j), 1e-10);
                CHECK_NEAR(rows[WIDTH * j + 1], 1, 1e-13);
                CHECK_NEAR(rows[WIDTH * j + 2], 0, 1e-13);
            }
        }
}

TEST(the_rows_of_a_derivative_are_blossoms_at_the_inner_knots)
{
    for (int p = 1; p <= 4; p++)
        for (int span = p; span <= 9 - p; span++) {
            double rows[5 * WIDTH];
            if (uneven[span] == uneven[span + 1])
                continue;
            blossom_rows(p, span, rows);
            bat_rows_derive(p, uneven, span, WIDTH, rows);
            for (int j = 0; j < p; j++) {
                double product = p;
                for (int k = 1; k < p; k++)
                    product *= uneven[span - p + 1 + j + k];
                CHECK_NEAR(rows[WIDTH * j], product, 1e-11);
                CHECK_NEAR(rows[WIDTH * j + 1], 1, 1e-14);
                CHECK_NEAR(rows[WIDTH * j + 2], 0, 1e-15);
            }
        }
}

TEST(rows_are_combined_column_by_column)
{
    static const double basis[3] = {2, 3, 5};
    static const double rows[9] = {1, 10, -1, 2, 20, -3, 7, 70, 4};
    double out[3];
    bat_combine(2, basis, 3, rows, out);
    CHECK(out[0] == 43 && out[1] == 430 && out[2] == 9);
    bat_combine(0, basis, 2, rows, out);
    CHECK(out[0] == 2 && out[1] == 20 && out[2] == 9);
}

TEST(K6_a_span_much_narrower_than_its_neighbours_is_tight)
{
    const double knots[] = {0, 1, 1 + 1e-9, 2, 3};
    CHECK(bat_span_is_tight(1, (const double[]){0, 1, 2, 3}, 1) == false);
    CHECK(bat_span_is_tight(2, knots, 1));
    CHECK(!bat_span_is_tight(2, knots, 2));
}

/* Knots around the span [0, 1]; for degree p one is tight when p knots in a row with it, p apart, are
 * more than 64 p wide. */
static const struct {
    int degree;
    double knots[6]; /* the span is knots[2] .. knots[3] */
    bool tight;
} spans[] = {
    {1, {-1000, -900, 0, 1, 900, 1000}, false}, {2, {-1000, -127, 0, 1, 128, 1000}, false},
    {2, {-1000, -128, 0, 1, 2, 1000}, true},    {2, {-1000, -1, 0, 1, 129, 1000}, true},
    {3, {-191, -1, 0, 1, 2, 192}, false},       {3, {-191.5, -1, 0, 1, 2, 3}, true},
    {3, {-1, -1, 0, 1, 2, 192.5}, true},        {3, {-2, -100, 0, 1, 93, 94}, true},
    {3, {-2, -100, 0, 1, 92, 94}, false},
};

TEST(K6_a_span_is_tight_from_64_degrees_of_its_width_on)
{
    for (size_t i = 0; i < sizeof spans / sizeof *spans; i++)
        CHECK_INT(bat_span_is_tight(spans[i].degree, spans[i].knots, 2), spans[i].tight);
}
