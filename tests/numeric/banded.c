#include "numeric/banded.h"

#include "support/test.h"

/* A random band matrix, its diagonal dominant, and the product with known solutions. */
typedef struct {
    int n, lower, upper, width;
    double *a, *x, *b;
} problem;

static int column(const problem *p, int i, int k)
{
    return i + k - p->lower;
}

static void multiply(problem *p, bool cyclic)
{
    const int w = p->lower + p->upper + 1;
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < w; k++) {
            int j = column(p, i, k);
            if (cyclic)
                j = (j + 100 * p->n) % p->n;
            for (int c = 0; c < p->width && j >= 0 && j < p->n; c++)
                p->b[i * p->width + c] += p->a[i * w + k] * p->x[j * p->width + c];
        }
}

static problem make_problem(test_random *random, int n, int lower, int upper, int width)
{
    const int w = lower + upper + 1;
    problem p = {n,
                 lower,
                 upper,
                 width,
                 test_array((size_t)(n * w), 8),
                 test_array((size_t)(n * width), 8),
                 test_array((size_t)(n * width), 8)};
    for (int i = 0; i < n; i++) {
        const double scale = ldexp(1, test_random_int(random, -30, 30));
        for (int k = 0; k < w; k++)
            p.a[i * w + k] = scale * test_random_in(random, -1, 1);
        p.a[i * w + lower] = scale * (w + 0.5);
    }
    for (int i = 0; i < n * width; i++)
        p.x[i] = test_random_in(random, -1, 1);
    return p;
}

/* Dominance makes the condition at most 4 w / 3, and each row sums w terms. */
static void check_solution(const problem *p)
{
    const int w = p->lower + p->upper + 1;
    for (int i = 0; i < p->n * p->width; i++)
        CHECK_NEAR(p->b[i], p->x[i], 2 * (w + 1) * (w + 1) * DBL_EPSILON);
}

static const struct {
    int lower, upper;
} bands[] = {{0, 0}, {1, 1}, {2, 2}, {0, 2}, {2, 1}, {1, 2}, {3, 0}, {1, 3}, {4, 2}, {25, 25}};
static const int widths[] = {1, 2, 3, 4};

TEST(a_band_matrix_times_its_solution_is_the_right_side)
{
    test_random random = test_random_begin("band");
    for (int t = 0; t < COUNT(bands); t++)
        for (int n = 1; n <= 60; n += n < 8 ? 1 : 13) {
            problem p = make_problem(&random, n, bands[t].lower, bands[t].upper, widths[n % 4]);
            multiply(&p, false);
            CHECK_OK(bat_banded_factor(n, p.lower, p.upper, p.a));
            bat_banded_solve(n, p.lower, p.upper, p.a, (size_t)p.width, p.b);
            check_solution(&p);
        }
}

TEST(a_cyclic_matrix_times_its_solution_is_the_right_side_even_where_the_band_meets_itself)
{
    test_random random = test_random_begin("cyclic");
    for (int t = 0; t < COUNT(bands); t++)
        for (int n = 1; n <= 60; n += n < 8 ? 1 : 13) {
            problem p = make_problem(&random, n, bands[t].lower, bands[t].upper, widths[n % 4]);
            multiply(&p, true);
            bat_cyclic *factor = NULL;
            CHECK_OK(bat_cyclic_factor(n, p.lower, p.upper, p.a, &factor));
            CHECK_OK(bat_cyclic_solve(factor, (size_t)p.width, p.b));
            check_solution(&p);
            bat_cyclic_free(factor);
        }
}

/* M Mt of a lower band matrix with unit diagonal, so L D Lt is known to be definite. */
TEST(a_symmetric_matrix_times_its_solution_is_the_right_side)
{
    test_random random = test_random_begin("symmetric");
    for (int lower = 0; lower <= 6; lower++)
        for (int n = 1; n <= 40; n += n < 8 ? 1 : 11) {
            problem p = make_problem(&random, n, lower, lower, widths[n % 4]);
            const int w = 2 * lower + 1;
            double *half = test_array((size_t)(n * (lower + 1)), 8);
            for (int i = 0; i < n; i++)
                for (int k = 0; k <= lower; k++) {
                    double value = k == lower ? w + 0.5 : test_random_in(&random, -1, 1);
                    half[i * (lower + 1) + k] = p.a[i * w + k] = value;
                    if (i + k - lower >= 0)
                        p.a[(i + k - lower) * w + 2 * lower - k] = value;
                }
            multiply(&p, false);
            CHECK_OK(bat_symmetric_factor(n, lower, half));
            bat_symmetric_solve(n, lower, half, (size_t)p.width, p.b);
            check_solution(&p);
        }
}

TEST(a_singular_band_matrix_is_refused_naming_the_row)
{
    /* Row 2 is row 1 with its columns: [2 1 0; 1 1 1/2; 0 1 1], whose determinant is 0. */
    double a[9] = {0, 2, 1, 1, 1, 0.5, 1, 1, 0};
    CHECK_STATUS(bat_banded_factor(3, 1, 1, a), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("row 3 of 3");
    double tiny[9] = {0, 1, 1, 0.5, 1e-30, 1, 0.5, 1, 0};
    tiny[3] = 0;
    CHECK_STATUS(bat_banded_factor(3, 1, 1, tiny), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("row 2 of 3");
    double zero[2] = {0, 0};
    CHECK_STATUS(bat_banded_factor(2, 0, 0, zero), BATTEN_SINGULAR_SYSTEM);
    for (int lower = 0; lower <= 2; lower++) {
        double infinite[10] = {0};
        infinite[lower] = INFINITY;
        CHECK_STATUS(bat_banded_factor(2, lower, lower, infinite), BATTEN_SINGULAR_SYSTEM);
    }
}

TEST(a_small_matrix_is_not_a_singular_one)
{
    double a[9] = {0, 2e-200, 1e-200, 1e-300, 2e-300, 1e-300, 1, 2, 0};
    CHECK_OK(bat_banded_factor(3, 1, 1, a));
}

TEST(a_singular_cyclic_matrix_is_refused)
{
    /* The second difference around a ring: constants are in its kernel. */
    double a[30];
    for (int i = 0; i < 10; i++)
        a[3 * i] = a[3 * i + 2] = -1, a[3 * i + 1] = 2;
    for (int n = 1; n <= 10; n++) {
        bat_cyclic *factor = NULL;
        CHECK_STATUS(bat_cyclic_factor(n, 1, 1, a, &factor), BATTEN_SINGULAR_SYSTEM);
        CHECK(factor == NULL);
    }
    a[1] = a[4] = 0;
    a[2] = a[3] = 0;
    bat_cyclic *factor = NULL;
    CHECK_STATUS(bat_cyclic_factor(10, 1, 1, a, &factor), BATTEN_SINGULAR_SYSTEM);
}

TEST(a_matrix_that_is_not_definite_is_refused)
{
    double semidefinite[4] = {0, 1, 1, 1};
    CHECK_STATUS(bat_symmetric_factor(2, 1, semidefinite), BATTEN_SINGULAR_SYSTEM);
    double negative[4] = {0, 1, 2, 1};
    CHECK_STATUS(bat_symmetric_factor(2, 1, negative), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("row 2 of 2");
    double infinite[1] = {INFINITY};
    CHECK_STATUS(bat_symmetric_factor(1, 0, infinite), BATTEN_SINGULAR_SYSTEM);
}
