#include "numeric/givens.h"
#include "numeric/dense.h"

#include "support/test.h"

enum { MOST = 40, ROWS = 120, WIDTH = 5 };

/* Random rows of a band or a ring, beginning at every unknown, and the same as a full matrix.
 */
typedef struct {
    int count, width, rows;
    bool ring;
    int first[ROWS];
    double values[ROWS][WIDTH], right[ROWS], full[ROWS * MOST], x[MOST], expected[ROWS];
} problem;

static problem *make_problem(test_random *random, int count, int width, bool ring)
{
    problem *p = test_array(1, sizeof *p);
    p->count = count, p->width = width, p->ring = ring, p->rows = 3 * count;
    for (int i = 0; i < p->rows; i++) {
        p->first[i] = ring ? i / 3 : i / 3 < count - width ? i / 3 : count - width;
        p->right[i] = test_random_in(random, -1, 1);
        p->expected[i] = p->right[i];
        for (int k = 0; k < width; k++) {
            p->values[i][k] = test_random_in(random, -1, 1);
            p->full[i * count + (p->first[i] + k) % count] += p->values[i][k];
        }
    }
    return p;
}

/* Each row at its place. */
static void add_rows(const problem *p, bat_givens *qr)
{
    for (int place = 0; place < p->count; place++)
        for (int i = 0; i < p->rows; i++)
            if (bat_givens_place(qr, p->first[i]) == place)
                bat_givens_add(qr, p->first[i], p->width, p->values[i], 1, &p->right[i]);
}

static void factor(const problem *p, bat_givens *qr)
{
    CHECK_OK(bat_givens_begin(p->count, p->width, p->ring, 1, qr));
    add_rows(p, qr);
    int unknown;
    CHECK_OK(bat_givens_check(qr, &unknown));
}

TEST(bands_and_rings_are_solved_as_full_matrices_are)
{
    test_random random = test_random_begin("givens");
    for (int c = 0; c < test_cases(200); c++) {
        const int width = test_random_int(&random, 1, WIDTH),
                  count = test_random_int(&random, width, MOST);
        problem *p = make_problem(&random, count, width, c % 2);
        bat_givens qr;
        factor(p, &qr);
        bat_givens_solve(&qr, p->x);
        CHECK_OK(bat_dense_least_squares(p->rows, count, p->full, 1, p->expected));
        for (int i = 0; i < count; i++)
            CHECK_NEAR(p->x[i], p->expected[i], 1e-9 * (1 + fabs(p->x[i])));
        bat_givens_end(&qr);
    }
}

/* The order costs time only: rows that come too late slide through all that are there. */
TEST(rows_may_come_in_any_order)
{
    test_random random = test_random_begin("any order");
    for (int c = 0; c < test_cases(100); c++) {
        const int width = test_random_int(&random, 1, WIDTH),
                  count = test_random_int(&random, width, MOST);
        problem *p = make_problem(&random, count, width, c % 2);
        bat_givens qr;
        double x[MOST];
        factor(p, &qr);
        bat_givens_solve(&qr, p->x);
        bat_givens_clear(&qr);
        for (int i = p->rows - 1; i >= 0; i--) {
            const int row = p->rows % 7 ? i * 7 % p->rows : i; /* each once */
            bat_givens_add(&qr, p->first[row], p->width, p->values[row], 1, &p->right[row]);
        }
        bat_givens_solve(&qr, x);
        for (int i = 0; i < count; i++)
            CHECK_NEAR(x[i], p->x[i], 1e-9 * (1 + fabs(x[i])));
        bat_givens_end(&qr);
    }
}

/* Several columns of numbers go through R and its transpose as each of them alone. */
TEST(many_right_sides_are_solved_as_one_is)
{
    enum { COLUMNS = 3 };
    test_random random = test_random_begin("columns");
    for (int c = 0; c < test_cases(40); c++) {
        const int width = test_random_int(&random, 1, WIDTH),
                  count = test_random_int(&random, width, MOST);
        problem *p = make_problem(&random, count, width, c % 2);
        bat_givens qr;
        double many[2][MOST * COLUMNS], one[2][MOST];
        factor(p, &qr);
        for (int i = 0; i < count * COLUMNS; i++)
            many[0][i] = many[1][i] = test_random_in(&random, -1, 1);
        for (int k = 0; k < COLUMNS; k++) {
            double alone[2][MOST];
            for (int i = 0; i < count; i++)
                alone[0][i] = alone[1][i] = many[0][i * COLUMNS + k];
            bat_givens_solve_lower(&qr, 1, alone[0]);
            bat_givens_solve_upper(&qr, 1, alone[1]);
            if (k == COLUMNS - 1)
                memcpy(one, alone, sizeof one);
        }
        bat_givens_solve_lower(&qr, COLUMNS, many[0]);
        bat_givens_solve_upper(&qr, COLUMNS, many[1]);
        for (int i = 0; i < count; i++) {
            CHECK_BITS(many[0][i * COLUMNS + COLUMNS - 1], one[0][i]);
            CHECK_BITS(many[1][i * COLUMNS + COLUMNS - 1], one[1][i]);
        }
        bat_givens_end(&qr);
    }
}

TEST(a_cleared_system_is_a_new_one)
{
    test_random random = test_random_begin("cleared");
    for (int c = 0; c < test_cases(40); c++) {
        const int width = test_random_int(&random, 1, WIDTH),
                  count = test_random_int(&random, width, MOST);
        problem *first = make_problem(&random, count, width, c % 2);
        problem *second = make_problem(&random, count, width, c % 2);
        bat_givens qr, fresh;
        double x[MOST], expected[MOST];
        factor(first, &qr);
        bat_givens_clear(&qr);
        add_rows(second, &qr);
        factor(second, &fresh);
        bat_givens_solve(&qr, x);
        bat_givens_solve(&fresh, expected);
        for (int i = 0; i < count; i++) {
            CHECK_BITS(x[i], expected[i]);
            CHECK_BITS(qr.sizes[i], fresh.sizes[i]);
        }
        bat_givens_end(&qr);
        bat_givens_end(&fresh);
    }
}

/* v^T (R^T R)^-1 v = |R^-T v|^2, and R^-1 undoes R. */
TEST(the_band_of_the_inverse_is_that_of_the_inverse)
{
    test_random random = test_random_begin("inverse band");
    for (int c = 0; c < test_cases(100); c++) {
        const int width = test_random_int(&random, 1, WIDTH),
                  count = test_random_int(&random, width, MOST);
        problem *p = make_problem(&random, count, width, c % 2);
        bat_givens qr;
        bat_inverse_band inverse;
        factor(p, &qr);
        CHECK_OK(bat_inverse_band_make(&qr, &inverse));
        for (int i = 0; i < p->rows; i++) {
            double v[MOST] = {0}, square = 0;
            for (int k = 0; k < width; k++)
                v[(p->first[i] + k) % count] += p->values[i][k];
            bat_givens_solve_lower(&qr, 1, v);
            for (int k = 0; k < count; k++)
                square += v[k] * v[k];
            CHECK_NEAR(bat_inverse_band_form(&inverse, p->first[i], width, p->values[i]),
                       square, 1e-8 * (1 + square));
        }
        bat_inverse_band_free(&inverse);
        bat_givens_end(&qr);
    }
}

TEST(G9_an_unknown_that_no_row_touches_is_named)
{
    bat_givens qr;
    int unknown = -1;
    const double one[2] = {1, 1}, right = 1;
    CHECK_OK(bat_givens_begin(5, 2, false, 1, &qr));
    bat_givens_add(&qr, 0, 1, one, 1, &right);
    bat_givens_add(&qr, 0, 2, one, 1, &right);
    bat_givens_add(&qr, 3, 2, one, 1, &right);
    bat_givens_add(&qr, 3, 1, one, 1, &right);
    CHECK_STATUS(bat_givens_check(&qr, &unknown), BATTEN_SINGULAR_SYSTEM);
    CHECK_INT(unknown, 2);
    bat_givens_end(&qr);
}

TEST(G9_messages_name_the_unknown_and_what_is_left_of_it)
{
    bat_givens qr;
    int unknown = -1;
    const double right = 0;
    /* One unknown of a band one wide: 4 roundings of its size are too little. */
    CHECK_OK(bat_givens_begin(2, 1, false, 1, &qr));
    bat_givens_add(&qr, 0, 1, (const double[]){1}, 1, &right);
    CHECK_STATUS(bat_givens_check(&qr, &unknown), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("unknown 2 of 2 is not determined: 0 of its 0 is left");
    CHECK_INT(unknown, 1);
    bat_givens_clear(&qr);
    bat_givens_add(&qr, 0, 1, (const double[]){0x1p600}, 1, &right);
    CHECK_STATUS(bat_givens_check(&qr, &unknown), BATTEN_OVERFLOW);
    CHECK_MESSAGE("the equations of unknown 1 leave the numbers");
    CHECK_INT(unknown, 0);
    bat_givens_end(&qr);
    /* Rows (1, 0) and (1, d): d is left of the second column, whose size it is; and (1, 1),
     * (1, 1 + d): d / sqrt(2) is left of sqrt(2), where 8 roundings are the least. */
    static const struct {
        double first, second;
        batten_status status;
    } rows[] = {{0, 1e-300 * 1e160, BATTEN_OK},
                {1, 1 + 30 * DBL_EPSILON, BATTEN_OK},
                {1, 1 + 9 * DBL_EPSILON, BATTEN_SINGULAR_SYSTEM}};
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_OK(bat_givens_begin(2, 2, false, 1, &qr));
        bat_givens_add(&qr, 0, 2, (const double[]){1, rows[i].first}, 1, &right);
        bat_givens_add(&qr, 0, 2, (const double[]){1, rows[i].second}, 1, &right);
        CHECK_STATUS(bat_givens_check(&qr, &unknown), rows[i].status);
        CHECK_INT(unknown, 1);
        bat_givens_end(&qr);
    }
}

TEST(rows_of_any_size_are_turned_without_overflow)
{
    const double sizes[] = {1e-300, 1e-160, 1, 1e160, 1e300};
    for (int s = 0; s < COUNT(sizes); s++) {
        bat_givens qr;
        double x[2];
        const double a[2] = {1, 2}, b[2] = {3, -1}, c[2] = {5, 2};
        CHECK_OK(bat_givens_begin(2, 2, false, 1, &qr));
        bat_givens_add(&qr, 0, 2, a, sizes[s], a);
        bat_givens_add(&qr, 0, 2, b, sizes[s], b);
        bat_givens_add(&qr, 0, 2, c, sizes[s], c);
        bat_givens_solve(&qr, x);
        CHECK_NEAR(x[0], 1, 1e-14);
        CHECK_NEAR(x[1], 0, 1e-14);
        bat_givens_end(&qr);
    }
}
