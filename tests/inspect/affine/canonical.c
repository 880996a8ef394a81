#include <batten/invariants.h>

#include "inspect/shapes.h"
#include "support/test.h"

enum { MOST = 3 * (BATTEN_MAX_DEGREE + 1) };

/* x[j] t^j, [m][degree + 1], as Bezier points over [a, b]. */
static void from_powers(int m, int degree, const double *x, double a, double b, double *points)
{
    for (int k = 0; k < m; k++) {
        double c[BATTEN_MAX_DEGREE + 1], power = 1, binomial = 1;
        memcpy(c, x + k * (degree + 1), ((size_t)degree + 1) * sizeof *c);
        for (int r = 0; r < degree; r++)
            for (int i = degree - 1; i >= r; i--)
                c[i] += a * c[i + 1];
        for (int i = 0; i <= degree; i++, power *= b - a) {
            c[i] *= power / binomial;
            binomial = binomial * (degree - i) / (i + 1);
        }
        for (int r = 1; r <= degree; r++)
            for (int i = degree; i >= r; i--)
                c[i] += c[i - 1];
        for (int i = 0; i <= degree; i++)
            points[m * i + k] = c[i];
    }
}

/* Random rows with the pivots wanted, then mixed by a matrix. */
static void random_curve(test_random *random, int m, int degree, const int *pivots, double *x)
{
    double rows[MOST];
    for (int k = 0; k < m; k++)
        for (int j = 0; j <= degree; j++) {
            double value = test_random_in(random, -1, 1);
            for (int l = 0; pivots && l < m; l++)
                value = j == pivots[l] ? l == k : value;
            rows[k * (degree + 1) + j] = pivots && j > pivots[k] ? 0 : value;
        }
    for (int k = 0; k < m; k++)
        for (int j = 0; j <= degree; j++) {
            double sum = 0;
            for (int l = 0; l < m; l++)
                sum += ((k == l ? 2 : 0) + 0.3 * ((k * 5 + l * 3) % 4)) *
                       rows[l * (degree + 1) + j];
            x[k * (degree + 1) + j] = sum;
        }
}

static void random_matrix(test_random *random, int m, double *a)
{
    for (int i = 0; i < m * m; i++)
        a[i] = test_random_in(random, -1, 1) + (i % (m + 1) == 0 ? 2 : 0);
    for (int i = 0; i < m; i++)
        a[i] *= test_random_bits(random) % 2 ? -1 : 1;
}

static void map_points(int m, int count, const double *a, double *points)
{
    for (int i = 0; i < count; i++) {
        double image[3] = {0};
        for (int k = 0; k < m; k++)
            for (int l = 0; l < m; l++)
                image[k] += a[k * m + l] * points[m * i + l];
        for (int k = 0; k < m; k++)
            points[m * i + k] = image[k] + 3 * k - 2;
    }
}

/* ---- counts ---- */

TEST(spec_4_there_are_as_many_invariants_as_the_pivots_leave)
{
    test_random random = test_random_begin("counts");
    for (int n = 3; n <= 9; n++)
        for (int h = 0; h <= n - 2; h++) {
            const int pivots[2] = {n - h - 1, n};
            double x[MOST], points[MOST];
            batten_canonical c;
            random_curve(&random, 2, n, pivots, x);
            from_powers(2, n, x, -1, 1, points);
            CHECK_OK(batten_canonical_form(2, n, points, 1e-10, &c));
            CHECK(c.dimension == 2 && c.has_shift);
            CHECK_INT(c.pivots[0], n - h - 1);
            CHECK_INT(c.pivots[1], n);
            CHECK_INT(c.count, 2 * n - h - 5);
        }
    for (int n = 4; n <= 9; n++) {
        double x[MOST], points[MOST];
        batten_canonical c;
        random_curve(&random, 3, n, NULL, x);
        from_powers(3, n, x, -1, 1, points);
        CHECK_OK(batten_canonical_form(3, n, points, 1e-10, &c));
        CHECK_INT(c.count, 3 * (n - 3) - 1);
    }
}

/* The rank of rows [count][width] within a relative tolerance. */
static int rank_of(int count, int width, double *a)
{
    int rank = 0;
    for (; rank < count; rank++) {
        int best = rank;
        double most = 0;
        for (int i = rank; i < count; i++) {
            double size = 0;
            for (int j = 0; j < width; j++)
                size += a[i * width + j] * a[i * width + j];
            if (size > most) {
                most = size;
                best = i;
            }
        }
        if (most < 1e-16)
            return rank;
        for (int j = 0; j < width; j++) {
            const double swapped = a[best * width + j];
            a[best * width + j] = a[rank * width + j];
            a[rank * width + j] = swapped / sqrt(most);
        }
        for (int i = rank + 1; i < count; i++) {
            double along = 0;
            for (int j = 0; j < width; j++)
                along += a[i * width + j] * a[rank * width + j];
            for (int j = 0; j < width; j++)
                a[i * width + j] -= along * a[rank * width + j];
        }
    }
    return rank;
}

TEST(spec_4_the_orbit_has_the_dimension_that_the_count_says)
{
    /* Curves (x, y) of degree n with p_rn = 0 for h values of r form a set of 2 (n + 1) - h
     * dimensions. The group of affine maps and t -> c t + f moves each along 8, which is the
     * rank of the tangents below; the rest, 2 n - h - 6, are absolute invariants. */
    test_random random = test_random_begin("orbit");
    for (int n = 4; n <= 6; n++)
        for (int h = 0; h <= n - 3; h++) {
            const int pivots[2] = {n - h - 1, n}, width = 2 * (n + 1);
            double x[MOST], tangents[8 * MOST] = {0};
            random_curve(&random, 2, n, pivots, x);
            for (int j = 0; j <= n; j++) {
                const double at[2] = {x[j], x[n + 1 + j]};
                for (int k = 0; k < 2; k++)
                    for (int l = 0; l < 2; l++)
                        tangents[(2 * k + l) * width + k * (n + 1) + j] = at[l];
                for (int k = 0; k < 2; k++) {
                    tangents[(4 + k) * width + k * (n + 1)] = 1;
                    tangents[6 * width + k * (n + 1) + j] = j * at[k]; /* t x' */
                    if (j > 0)
                        tangents[7 * width + k * (n + 1) + j - 1] = j * at[k]; /* x' */
                }
            }
            double points[MOST];
            batten_canonical c;
            from_powers(2, n, x, -1, 1, points);
            CHECK_OK(batten_canonical_form(2, n, points, 1e-10, &c));
            CHECK_INT(rank_of(8, width, tangents), 8);
            CHECK_INT(c.count - 1, 2 * (n + 1) - h - 8);
        }
}

/* ---- laws ---- */

TEST(spec_7_invariants_follow_their_weights)
{
    test_random random = test_random_begin("law");
    static const int shapes[][2] = {{2, 3}, {2, 4}, {2, 5}, {2, 6},
                                    {2, 7}, {3, 4}, {3, 5}, {3, 6}};
    for (int cases = test_cases(40); cases > 0; cases--)
        for (int i = 0; i < COUNT(shapes); i++) {
            const int m = shapes[i][0], n = shapes[i][1];
            const double c = test_random_in(&random, 0.5, 2) * (cases % 2 ? 1 : -1);
            const double f = test_random_in(&random, -0.5, 0.5);
            double x[MOST], old_points[MOST], new_points[MOST], a[9];
            batten_canonical old, new;
            random_curve(&random, m, n, NULL, x);
            from_powers(m, n, x, 0, 1, old_points);
            from_powers(m, n, x, f, c + f, new_points);
            random_matrix(&random, m, a);
            map_points(m, n + 1, a, new_points);
            CHECK_OK(batten_canonical_form(m, n, old_points, 1e-12, &old));
            CHECK_OK(batten_canonical_form(m, n, new_points, 1e-12, &new));
            CHECK_INT(new.count, old.count);
            if (old.margin < 0.02 || new.margin < 0.02 || fabs(old.shift) > 3)
                continue;
            CHECK_NEAR(old.shift, c * new.shift + f, 1e-8);
            CHECK_NEAR(old.radius / (fabs(c) * new.radius), 1, 1e-8);
            for (int k = 0; k < old.count; k++) {
                const batten_invariant *e = &old.at[k], *g = &new.at[k];
                CHECK_NEAR(e->value, pow(c, e->weight) * g->value,
                           1e-7 * pow(old.radius, e->weight));
                CHECK_NEAR(fabs(e->scaled), fabs(g->scaled), 1e-7);
                if (fabs(old.at[old.base].scaled) > 0.1)
                    CHECK_NEAR(e->absolute, g->absolute, 1e-8 * (1 + fabs(e->absolute)));
            }
        }
}

TEST(a_cubic_has_its_invariant_and_its_shift)
{
    /* x = t^2 / 2, y = t^3 / 6 + I t / 2, seen from t = 0.7 */
    const double i = -0.37, x[8] = {0, 0, 0.5, 0, 0, i / 2, 0, 1 / 6.0};
    double points[8];
    batten_canonical c;
    from_powers(2, 3, x, -0.7, 0.3, points);
    CHECK_OK(batten_canonical_form(2, 3, points, 1e-12, &c));
    CHECK_INT(c.count, 1);
    CHECK(c.at[0].row == 1 && c.at[0].power == 1 && c.at[0].weight == 2);
    CHECK_NEAR(c.at[0].value, i / 2, 1e-14);
    CHECK_NEAR(c.shift, 0.7, 1e-14);
    CHECK_NEAR(c.radius, sqrt(-i / 2), 1e-14);
    CHECK_NEAR(c.at[0].scaled, -1, 1e-14);
    CHECK_NEAR(c.at[0].absolute, 1, 1e-14);
}

TEST(curves_in_less_than_their_space_are_taken_there)
{
    double x[12] = {0, 1, 0, 2, 1, 2, 0, 4, 0, 0, 1, 0}, points[12];
    batten_canonical c;
    from_powers(3, 3, x, 0, 1, points);
    CHECK_OK(batten_canonical_form(3, 3, points, 1e-10, &c));
    CHECK(c.dimension == 2 && c.pivots[0] == 2 && c.pivots[1] == 3);
    CHECK(c.neglected < 1e-15);
    CHECK_OK(batten_canonical_form(2, 1, (const double[]){1, 1, 3, 4}, 1e-10, &c));
    CHECK(c.dimension == 1 && c.pivots[0] == 1 && !c.has_shift && c.count == 0);
    CHECK_OK(batten_canonical_form(2, 2, (const double[]){1, 1, 1, 1, 1, 1}, 1e-10, &c));
    CHECK(c.dimension == 0 && c.count == 0 && c.base == -1);
    CHECK_OK(batten_canonical_form(2, 2, (const double[]){0, 0, 1, 1, 2, 0}, 1e-10, &c));
    CHECK(c.dimension == 2 && !c.has_shift && c.count == 0 && c.radius == 0);
}

TEST(a_curve_that_is_passed_twice_has_no_invariant_of_odd_weight)
{
    const double x[14] = {0, 0, 1, 0, 0.3, 0, 0, 0, 0, 0.2, 0, 0.5, 0, 1};
    double points[14];
    batten_canonical c;
    from_powers(2, 6, x, -0.4, 0.6, points);
    CHECK_OK(batten_canonical_form(2, 6, points, 1e-10, &c));
    for (int k = 0; k < c.count; k++)
        CHECK(c.at[k].weight % 2 == 0 || c.at[k].value == 0);
    CHECK(c.base >= 0 && c.at[c.base].weight == 2);
}

/* ---- quintics ---- */

TEST(spec_5_quintics_of_the_class_are_told_by_signs)
{
    static const struct {
        double a, b, g;
        batten_quintic_case which;
    } rows[] = {
        {1, 1, -1, BATTEN_QUINTIC_NODE_AND_ISOLATED},
        {1, -5, -2, BATTEN_QUINTIC_NODE_AND_ISOLATED},
        {1, 2, 0, BATTEN_QUINTIC_CUSP_AND_ISOLATED},
        {1, -2, 0, BATTEN_QUINTIC_CUSP_AND_NODE},
        {1, 0, 0, BATTEN_QUINTIC_HIGHER_CUSP},
        {0, 0, 0, BATTEN_QUINTIC_HIGHER_CUSP},
        {1, -3, 1, BATTEN_QUINTIC_TWO_NODES},
        {1, -2, 1, BATTEN_QUINTIC_TACNODE},
        {1, 0, 1, BATTEN_QUINTIC_NO_REAL},
        {1, 3, 1, BATTEN_QUINTIC_TWO_ISOLATED},
        {1, 2, 1, BATTEN_QUINTIC_DOUBLE_ISOLATED},
    };
    test_random random = test_random_begin("quintics");
    for (int i = 0; i < COUNT(rows); i++) {
        const double x[12] = {0, 0, 1, 0, 0, 0, 0, rows[i].g, 0, rows[i].b, rows[i].a, 1};
        double points[12], m[4];
        batten_canonical c;
        batten_quintic q;
        random_matrix(&random, 2, m);
        from_powers(2, 5, x, -1.25, 0.75, points); /* t = 2 v - 1.25 */
        map_points(2, 6, m, points);
        CHECK_OK(batten_canonical_form(2, 5, points, 1e-10, &c));
        CHECK_OK(batten_quintic_classify(&c, 1e-8, &q));
        CHECK_TEXT(batten_quintic_name(q.which), batten_quintic_name(rows[i].which));
        CHECK_NEAR(q.shift, 0.625, 1e-12);
        CHECK_NEAR(2 * q.a, rows[i].a, 1e-10);
        CHECK_NEAR(4 * q.b, rows[i].b, 1e-10);
        CHECK_NEAR(16 * q.g, rows[i].g, 1e-10);
    }
}

TEST(random_quintics_of_the_class_have_the_census_of_their_case)
{
    test_random random = test_random_begin("case");
    for (int n = test_cases(300); n > 0; n--) {
        /* whole numbers, so that the census sees the class exactly */
        const double b = test_random_int(&random, -6, 6), g = test_random_int(&random, -6, 6);
        const double x[12] = {0, 0, 10, 0, 0, 0, 0, 10 * g, 0, 10 * b, 10, 10};
        double points[12];
        batten_canonical c;
        batten_quintic q;
        batten_census census;
        from_powers(2, 5, x, -1, 1, points);
        CHECK_OK(batten_canonical_form(2, 5, points, 1e-10, &c));
        CHECK_OK(batten_quintic_classify(&c, 1e-9, &q));
        CHECK_OK(batten_census_take(2, 5, points, 0, &census));
        static const int expected[BATTEN_QUINTIC_COUNT][3] = {/* nodes, isolated, cusps */
                                                              {1, 1, 0}, {0, 1, 1}, {1, 0, 1},
                                                              {0, 0, 1}, {2, 0, 0}, {1, 0, 0},
                                                              {0, 0, 0}, {0, 2, 0}, {0, 1, 0}};
        CHECK_INT(census.whole[BATTEN_SPECIAL_CROSSING], expected[q.which][0]);
        CHECK_INT(census.whole[BATTEN_SPECIAL_ISOLATED], expected[q.which][1]);
        CHECK_INT(census.whole[BATTEN_SPECIAL_CUSP], expected[q.which][2]);
        batten_census_release(&census);
    }
}

TEST(other_curves_are_no_quintics_of_the_class)
{
    const double points[12] = {0, 0, 1, 2, 2, -1, 3, 3, 4, 0, 5, 2};
    batten_canonical c;
    batten_quintic q;
    CHECK_OK(batten_canonical_form(2, 5, points, 1e-10, &c));
    CHECK_STATUS(batten_quintic_classify(&c, 1e-9, &q), BATTEN_NOT_COMPATIBLE);
}

/* ---- bad input ---- */

TEST(n1_canonical_forms_need_finite_points)
{
    batten_canonical c;
    CHECK_STATUS(
        batten_canonical_form(2, 2, (const double[]){0, 0, 1, INFINITY, 2, 0}, 1e-10, &c),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
}

TEST(n2_canonical_forms_do_not_depend_on_size)
{
    const double points[10] = {0, 0, 1, 2, 5, -1, 3, 3, 4, 0}, sizes[] = {1, 1e-300, 3e307};
    double value[3][8];
    for (int i = 0; i < COUNT(sizes); i++) {
        double scaled[10];
        batten_canonical c;
        for (int k = 0; k < 10; k++)
            scaled[k] = points[k] * sizes[i];
        CHECK_OK(batten_canonical_form(2, 4, scaled, 1e-10, &c));
        CHECK_INT(c.count, 3);
        for (int k = 0; k < c.count; k++) {
            value[i][k] = c.at[k].value;
            CHECK_NEAR(value[i][k], value[0][k], 1e-12 * (1 + fabs(value[0][k])));
        }
    }
}

TEST(n6_canonical_forms_refuse_arguments_outside_their_range)
{
    const double points[4] = {0, 0, 1, 1};
    batten_canonical c;
    CHECK_STATUS(batten_canonical_form(4, 1, points, 1e-10, &c), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_canonical_form(2, 0, points, 1e-10, &c), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_canonical_form(2, 1, points, 0, &c), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_canonical_form(2, 1, points, NAN, &c), BATTEN_BAD_ARGUMENT);
}
