#include <batten/invariants.h>
#include <batten/local.h>
#include <stdlib.h>

#include "support/test.h"

enum { MOST = 24 };

/* ---- the definition: sum of Lagrange polynomials times B-splines ---- */

typedef struct {
    int count; /* parameters t[0 .. count - 1] with values p */
    const double *t, *p;
} sequence;

static double lagrange(const sequence *s, int first, int m, double u)
{
    double sum = 0;
    for (int a = first; a <= first + m; a++) {
        double w = 1;
        for (int b = first; b <= first + m; b++)
            if (b != a)
                w *= (u - s->t[b]) / (s->t[a] - s->t[b]);
        sum += w * s->p[a];
    }
    return sum;
}

static double b_spline(const sequence *s, int j, int k, double u)
{
    if (k == 1)
        return s->t[j] <= u && u < s->t[j + 1];
    const double a = (u - s->t[j]) / (s->t[j + k - 1] - s->t[j]);
    const double b = (s->t[j + k] - u) / (s->t[j + k] - s->t[j + 1]);
    return a * b_spline(s, j, k - 1, u) + b * b_spline(s, j + 1, k - 1, u);
}

static double definition(const sequence *s, int k, int m, double u)
{
    const int c = m - k + 2, before = (int)floor(c / 2.0);
    double sum = 0;
    for (int j = 0; j + k < s->count; j++) {
        const int first = j + 1 - before;
        if (first < 0 || first + m >= s->count || u < s->t[j] || u >= s->t[j + k])
            continue;
        sum += b_spline(s, j, k, u) * lagrange(s, first, m, u);
    }
    return sum;
}

static double value(const batten_curve *curve, double u)
{
    double out[3];
    CHECK_OK(batten_curve_evaluate(curve, u, 0, out));
    return out[0];
}

static void random_row(test_random *random, int count, double *t, double *p)
{
    t[0] = test_random_in(random, -2, 2);
    for (int i = 0; i < count; i++) {
        if (i > 0)
            t[i] = t[i - 1] + test_random_in(random, 0.3, 1);
        p[i] = test_random_in(random, -1, 1);
    }
}

static batten_curve *curve_of(int k, int m, int count, const double *t, const double *p)
{
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    options.blend = k - 1;
    options.local = m;
    options.given = t;
    CHECK_OK(
        batten_curve_catmull_rom((batten_points){1, count, p}, &options, NULL, NULL, &curve));
    return curve;
}

/* Orders k and degrees m: (polygon), Overhauser, the classical cubic, ..., approximating ones.
 */
static const int members[][2] = {{2, 0}, {2, 1}, {2, 2}, {2, 4}, {3, 1}, {3, 2}, {3, 3},
                                 {3, 5}, {4, 2}, {4, 3}, {4, 4}, {5, 3}, {4, 0}, {4, 1}};

TEST(curves_of_the_class_are_those_of_the_definition)
{
    test_random random = test_random_begin("definition");
    for (int c = 0; c < test_cases(20); c++)
        for (int q = 0; q < COUNT(members); q++) {
            const int k = members[q][0], m = members[q][1], count = 20;
            double t[MOST], p[MOST];
            random_row(&random, count, t, p);
            batten_curve *curve = curve_of(k, m, count, t, p);
            CHECK_INT(batten_curve_degree(curve), m + k - 1);
            const sequence s = {count, t, p};
            for (int i = 0; i < 60; i++) { /* where no point beyond the ends counts */
                const double u = test_random_in(&random, t[7], t[12]);
                CHECK_NEAR(value(curve, u), definition(&s, k, m, u), 2e-11);
            }
            batten_curve_unref(curve);
        }
}

/* Derivatives continue k - 2 times, from m = k on k - 1 times, and no more. */
TEST(knots_stand_as_often_as_the_continuity_asks_for)
{
    static const int continuity[] = {0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 2, 2};
    test_random random = test_random_begin("continuity");
    for (int q = 0; q < COUNT(members); q++) {
        const int k = members[q][0], m = members[q][1], r = continuity[q];
        double t[MOST], p[MOST], left[9], right[9];
        random_row(&random, 20, t, p);
        batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
        batten_curve_catmull_rom_report report;
        batten_curve *curve = NULL;
        options.blend = k - 1, options.local = m, options.given = t;
        CHECK_OK(batten_curve_catmull_rom((batten_points){1, 20, p}, &options, NULL, &report,
                                          &curve));
        CHECK_INT(report.continuity, r);
        CHECK(report.through == (m >= k - 2));
        CHECK_OK(batten_curve_evaluate_side(curve, t[9], BATTEN_FROM_LEFT, r + 1, left));
        CHECK_OK(batten_curve_evaluate_side(curve, t[9], BATTEN_FROM_RIGHT, r + 1, right));
        CHECK(fabs(left[r + 1] - right[r + 1]) > 1e-3);
        if (report.through)
            CHECK(report.error < 1e-13);
        else
            CHECK(report.error > 1e-3);
        batten_curve_unref(curve);
    }
}

/* On any knots, not on equal ones alone: both have the derivatives of the polynomials of degree
 * k through neighbours. */
TEST(blends_of_order_k_and_degree_k_are_also_those_of_the_next_order)
{
    test_random random = test_random_begin("same");
    for (int c = 0; c < test_cases(50); c++)
        for (int k = 2; k <= 4; k++) {
            double t[MOST], p[MOST];
            random_row(&random, 16, t, p);
            /* Where ends do not count. */
            batten_curve *a = curve_of(k, k, 16, t, p), *b = curve_of(k + 1, k - 1, 16, t, p);
            for (int i = 0; i < 50; i++) {
                const double u = test_random_in(&random, t[4], t[11]);
                CHECK_NEAR(value(a, u), value(b, u), 1e-12);
            }
            batten_curve_unref(a);
            batten_curve_unref(b);
        }
}

TEST(equal_steps_give_the_matrix_of_catmull_and_rom)
{
    static const double points[][2] = {{0, 1}, {2, 3}, {3, -1}, {5, 0}, {6, 4}};
    static const double matrix[4][4] = {
        {-0.5, 1.5, -1.5, 0.5}, {1, -2.5, 2, -0.5}, {-0.5, 0, 0.5, 0}, {0, 1, 0, 0}};
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    options.alpha = 0;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_catmull_rom((batten_points){2, 5, points[0]}, &options, NULL, NULL,
                                      &curve));
    CHECK_INT(batten_curve_point_count(curve), 10);
    for (int i = 1; i < 3; i++)
        for (int j = 0; j <= 8; j++) {
            const double t = j / 8.0, powers[4] = {t * t * t, t * t, t, 1};
            double at[2];
            CHECK_OK(batten_curve_evaluate(curve, i + t, 0, at));
            for (int c = 0; c < 2; c++) {
                double sum = 0;
                for (int a = 0; a < 4; a++)
                    for (int b = 0; b < 4; b++)
                        sum += powers[a] * matrix[a][b] * points[i - 1 + b][c];
                CHECK_NEAR(at[c], sum, 1e-14 * 8);
            }
        }
    batten_curve_unref(curve);
}

TEST(polynomials_of_the_larger_degree_are_reproduced_up_to_the_ends)
{
    test_random random = test_random_begin("reproduction");
    for (int q = 0; q < COUNT(members); q++) {
        const int k = members[q][0], m = members[q][1], degree = m > k - 1 ? m : k - 1;
        if (m < k - 2)
            continue;
        double t[MOST], p[MOST], zeros[5];
        random_row(&random, 12, t, p);
        for (int r = 0; r < degree; r++)
            zeros[r] = test_random_in(&random, t[0], t[11]);
        for (int i = 0; i < 12; i++) {
            p[i] = 1;
            for (int r = 0; r < degree; r++)
                p[i] *= (t[i] - zeros[r]) / 2;
        }
        batten_curve *curve = curve_of(k, m, 12, t, p);
        for (int i = 0; i <= 100; i++) {
            const double u = t[0] + (t[11] - t[0]) * i / 100;
            double exact = 1, size = 1;
            for (int r = 0; r < degree; r++) {
                exact *= (u - zeros[r]) / 2;
                size *= (t[11] - t[0]) / 2;
            }
            CHECK_NEAR(value(curve, u), exact, 1e-13 * size);
        }
        batten_curve_unref(curve);
    }
}

TEST(a_point_moves_as_many_spans_as_order_and_degree_make)
{
    test_random random = test_random_begin("locality");
    for (int q = 0; q < COUNT(members); q++) {
        const int k = members[q][0], m = members[q][1];
        double t[MOST], p[MOST];
        int moved = 0;
        random_row(&random, 20, t, p);
        batten_curve *before = curve_of(k, m, 20, t, p);
        p[10] += 1;
        batten_curve *after = curve_of(k, m, 20, t, p);
        for (int i = 0; i < 19; i++) {
            double off = 0;
            for (int j = 1; j < 8; j++) {
                const double u = t[i] + (t[i + 1] - t[i]) * j / 8;
                off = fmax(off, fabs(value(before, u) - value(after, u)));
            }
            moved += off > 1e-9;
        }
        CHECK(moved <= m + k && moved >= 2);
        batten_curve_unref(before);
        batten_curve_unref(after);
    }
}

TEST(order_two_is_the_polygon_and_degree_zero_the_b_spline_of_the_points)
{
    test_random random = test_random_begin("special members");
    double t[MOST], p[MOST];
    random_row(&random, 12, t, p);
    batten_curve *polygon = curve_of(2, 0, 12, t, p), *spline = curve_of(4, 0, 12, t, p);
    CHECK_INT(batten_curve_point_count(polygon), 12);
    for (int i = 0; i < 12; i++)
        CHECK_BITS(batten_curve_points(polygon)[i], p[i]);
    CHECK_INT(batten_curve_point_count(spline), 14);
    for (int i = 3; i < 11; i++) /* clamping changes the others */
        CHECK_NEAR(batten_curve_points(spline)[i], p[i - 1], 1e-14);
    batten_curve_unref(polygon);
    batten_curve_unref(spline);
}

/* ---- ends ---- */

TEST(phantoms_are_points_given_beyond_the_ends)
{
    test_random random = test_random_begin("phantoms");
    for (int c = 0; c < test_cases(50); c++)
        for (int kind = 0; kind <= BATTEN_PHANTOM_REPEAT; kind++) {
            enum { N = 8, G = 3 };
            double t[N + 2 * G], p[N + 2 * G];
            random_row(&random, N, t + G, p + G);
            for (int g = 1; g <= G; g++) {
                const int a = G, b = G + N - 1; /* the ends */
                t[a - g] = 2 * t[a] - t[a + g];
                t[b + g] = 2 * t[b] - t[b - g];
                const sequence row = {N + 2 * G, t, p};
                const bool reflect = kind == BATTEN_PHANTOM_REFLECT;
                p[a - g] = reflect ? 2 * p[a] - p[a + g] : p[a];
                p[b + g] = reflect ? 2 * p[b] - p[b - g] : p[b];
                if (kind == BATTEN_PHANTOM_EXTRAPOLATE) {
                    p[a - g] = lagrange(&row, a, 3, t[a - g]);
                    p[b + g] = lagrange(&row, b - 3, 3, t[b + g]);
                }
            }
            batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
            options.blend = 3, options.local = 3, options.given = t + G;
            options.phantoms = (batten_phantoms)kind;
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_catmull_rom((batten_points){1, N, p + G}, &options, NULL,
                                              NULL, &curve));
            const sequence row = {N + 2 * G, t, p};
            for (int i = 0; i < 60; i++) {
                const double u = test_random_in(&random, t[G], t[G + N - 1]);
                CHECK_NEAR(value(curve, u), definition(&row, 4, 3, u), 1e-10);
            }
            batten_curve_unref(curve);
        }
}

TEST(a_closed_curve_is_that_of_the_points_again_and_again)
{
    static const double ring[][2] = {{2, 0}, {1.4, 1.5}, {0, 2.1}, {-1.4, 1.4}, {-1, -1}};
    for (int q = 0; q < COUNT(members); q++) {
        enum { N = 5, TURNS = 5 };
        double rows[N * TURNS][2], t[N + 1], again[N * TURNS], out[2], expected[2];
        batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
        batten_curve *closed = NULL, *open = NULL;
        options.blend = members[q][0] - 1, options.local = members[q][1];
        options.closed = true;
        CHECK_OK(batten_curve_catmull_rom((batten_points){2, N, ring[0]}, &options, t, NULL,
                                          &closed));
        CHECK(batten_curve_is_periodic(closed));
        for (int i = 0; i < N * TURNS; i++) {
            memcpy(rows[i], ring[i % N], sizeof rows[i]);
            again[i] = t[i % N] + i / N * t[N];
        }
        options.closed = false, options.given = again;
        CHECK_OK(batten_curve_catmull_rom((batten_points){2, N * TURNS, rows[0]}, &options,
                                          NULL, NULL, &open));
        for (int i = 0; i <= 100; i++) {
            const double u = t[N] * i / 100;
            CHECK_OK(batten_curve_evaluate(closed, u, 0, out));
            CHECK_OK(batten_curve_evaluate(open, u + 2 * t[N], 0, expected));
            for (int c = 0; c < 2; c++)
                CHECK_NEAR(out[c], expected[c], 1e-11);
        }
        batten_curve_unref(closed);
        batten_curve_unref(open);
    }
}

TEST(a_closed_curve_keeps_the_parameters_it_is_given)
{
    static const double ring[][2] = {{2, 0}, {1.4, 1.5}, {0, 2.1}, {-1.4, 1.4}};
    const double t[] = {0.1, 1.3, 2.7, 3.1, 4.9};
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    double back[5];
    options.given = t;
    options.closed = true;
    CHECK_OK(
        batten_curve_catmull_rom((batten_points){2, 4, ring[0]}, &options, back, NULL, &curve));
    for (int i = 0; i < 5; i++)
        CHECK_BITS(back[i], t[i]);
    CHECK_BITS(batten_curve_domain(curve).a, t[0]);
    CHECK_BITS(batten_curve_domain(curve).b, t[4]);
    batten_curve_unref(curve);
}

/* ---- properties ---- */

static int loops(double alpha, int count, const double *points)
{
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL, *bezier = NULL;
    int found = 0;
    options.alpha = alpha;
    CHECK_OK(batten_curve_catmull_rom((batten_points){2, count, points}, &options, NULL, NULL,
                                      &curve));
    CHECK_OK(batten_curve_to_bezier(curve, &bezier));
    for (int i = 0; i + 1 < count; i++) {
        batten_cubic cubic;
        CHECK_OK(batten_cubic_classify(2, batten_curve_points(bezier) + 6 * i, 0, &cubic));
        found += cubic.segment == BATTEN_CUBIC_LOOP || cubic.segment == BATTEN_CUBIC_CUSP;
    }
    batten_curve_unref(curve);
    batten_curve_unref(bezier);
    return found;
}

/* Yuksel, Schaefer and Keyser; equal steps have many. */
TEST(centripetal_cubics_have_no_cusps_and_do_not_cross_themselves)
{
    test_random random = test_random_begin("centripetal");
    int uniform = 0;
    const int cases = test_cases(500);
    for (int c = 0; c < cases; c++) {
        double points[10][2];
        for (int i = 0; i < 10; i++) {
            const double step = test_random_int(&random, 0, 3) == 0 ? 0.02 : 1;
            for (int k = 0; k < 2; k++)
                points[i][k] =
                    (i > 0 ? points[i - 1][k] : 0) + step * test_random_in(&random, -1, 1);
        }
        CHECK_INT(loops(0.5, 10, points[0]), 0);
        uniform += loops(0, 10, points[0]);
    }
    if (cases >= 500)
        CHECK(uniform > 100);
}

TEST(curves_of_the_class_go_along_with_similarities)
{
    static const double points[][2] = {{0, 0}, {1, 2}, {1.5, 2.1}, {4, 1}, {5, 1.2}};
    double moved[5][2];
    for (int i = 0; i < 5; i++) {
        moved[i][0] = 3 * points[i][0] - 4 * points[i][1] + 7;
        moved[i][1] = 4 * points[i][0] + 3 * points[i][1] - 2;
    }
    const double alphas[] = {0, 0.3, 0.5, 1};
    for (int a = 0; a < COUNT(alphas); a++) {
        batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
        batten_curve *one = NULL, *other = NULL;
        double end[2];
        options.alpha = alphas[a];
        CHECK_OK(batten_curve_catmull_rom((batten_points){2, 5, points[0]}, &options, NULL,
                                          NULL, &one));
        CHECK_OK(batten_curve_catmull_rom((batten_points){2, 5, moved[0]}, &options, NULL, NULL,
                                          &other));
        end[0] = batten_curve_domain(one).b, end[1] = batten_curve_domain(other).b;
        CHECK_NEAR(end[1], end[0] * pow(5, alphas[a]), 1e-13 * end[1]);
        for (int i = 0; i <= 50; i++) {
            double x[2], y[2];
            CHECK_OK(batten_curve_evaluate(one, end[0] * i / 50, 0, x));
            CHECK_OK(batten_curve_evaluate(other, end[1] * i / 50, 0, y));
            CHECK_NEAR(y[0], 3 * x[0] - 4 * x[1] + 7, 1e-12);
            CHECK_NEAR(y[1], 4 * x[0] + 3 * x[1] - 2, 1e-12);
        }
        batten_curve_unref(one);
        batten_curve_unref(other);
    }
}

TEST(g10_reversed_points_give_the_reversed_curve)
{
    test_random random = test_random_begin("reversed");
    for (int q = 0; q < COUNT(members); q++) {
        if ((members[q][0] - members[q][1]) % 2)
            continue; /* one point more on one side */
        double points[9][3], reversed[9][3];
        for (int i = 0; i < 9; i++)
            for (int c = 0; c < 3; c++)
                points[i][c] = reversed[8 - i][c] = test_random_in(&random, -1, 1);
        batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
        batten_curve *there = NULL, *back = NULL;
        options.blend = members[q][0] - 1, options.local = members[q][1];
        CHECK_OK(batten_curve_catmull_rom((batten_points){3, 9, points[0]}, &options, NULL,
                                          NULL, &there));
        CHECK_OK(batten_curve_catmull_rom((batten_points){3, 9, reversed[0]}, &options, NULL,
                                          NULL, &back));
        const double end = batten_curve_domain(there).b;
        for (int i = 0; i <= 100; i++) {
            double x[3], y[3];
            CHECK_OK(batten_curve_evaluate(there, end * i / 100, 0, x));
            CHECK_OK(batten_curve_evaluate(back, batten_curve_domain(back).b * (100 - i) / 100,
                                           0, y));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(x[c], y[c], 1e-10);
        }
        batten_curve_unref(there);
        batten_curve_unref(back);
    }
}

/* ---- few points, bad ones ---- */

TEST(g2_two_points_give_the_line_and_points_in_line_too)
{
    static const double points[][2] = {{1, 1}, {3, 2}, {4, 2.5}};
    for (int q = 0; q < COUNT(members); q++)
        for (int count = 2; count <= 3; count++) {
            batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
            batten_curve *curve = NULL;
            options.blend = members[q][0] - 1, options.local = members[q][1];
            CHECK_OK(batten_curve_catmull_rom((batten_points){2, count, points[0]}, &options,
                                              NULL, NULL, &curve));
            for (int i = 0; i <= 20; i++) {
                double at[2];
                CHECK_OK(
                    batten_curve_evaluate(curve, batten_curve_domain(curve).b * i / 20, 0, at));
                CHECK_NEAR(at[1], 1 + (at[0] - 1) / 2, 1e-14 * 8);
            }
            batten_curve_unref(curve);
        }
}

TEST(g1_coincident_neighbours_are_refused_but_for_equal_steps)
{
    static const double points[][2] = {{0, 0}, {1, 1}, {1, 1}, {2, 0}};
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_catmull_rom((batten_points){2, 4, points[0]}, NULL, NULL, NULL, &curve),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    CHECK(curve == NULL);
    options.alpha = 0;
    CHECK_OK(batten_curve_catmull_rom((batten_points){2, 4, points[0]}, &options, NULL, NULL,
                                      &curve));
    batten_curve_unref(curve);
}

TEST(k9_s1_degrees_and_counts_beyond_the_limits_are_refused)
{
    static const struct {
        int blend, local, count;
        double alpha;
        batten_status status;
        const char *says;
    } rows[] = {
        {0, 1, 4, 0.5, BATTEN_BAD_DEGREE, "blending degree is 0"},
        {2, -1, 4, 0.5, BATTEN_BAD_DEGREE, "local degree is -1"},
        {20, 6, 4, 0.5, BATTEN_BAD_DEGREE, "the limit, 25"},
        {2147483647, 1, 4, 0.5, BATTEN_BAD_DEGREE, "the limit, 25"},
        {2, 1, 1, 0.5, BATTEN_TOO_FEW_POINTS, "there is 1 point"},
        {2, 1, -1, 0.5, BATTEN_TOO_FEW_POINTS, "there are -1 points"},
        {2, 1, 2147483647, 0.5, BATTEN_TOO_LARGE, "the limit is"},
        {2, 1, 4, 1.5, BATTEN_BAD_ARGUMENT, "alpha is 1.5"},
        {2, 1, 4, NAN, BATTEN_BAD_ARGUMENT, "alpha is"},
    };
    static const double points[][2] = {{0, 0}, {1, 1}, {2, 0}, {3, 1}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
        batten_curve *curve = NULL;
        options.blend = rows[i].blend, options.local = rows[i].local;
        options.alpha = rows[i].alpha;
        CHECK_STATUS(batten_curve_catmull_rom((batten_points){2, rows[i].count, points[0]},
                                              &options, NULL, NULL, &curve),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].says);
    }
    batten_curve_catmull_rom_options largest = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    largest.blend = 20, largest.local = 5;
    CHECK_OK(batten_curve_catmull_rom((batten_points){2, 4, points[0]}, &largest, NULL, NULL,
                                      &curve));
    CHECK_INT(batten_curve_degree(curve), 25);
    batten_curve_unref(curve);
}

TEST(n1_n2_bad_numbers_are_refused_and_large_ones_do_no_harm)
{
    double points[][2] = {{0, 0}, {1, NAN}, {2, 0}, {3, 1}}, t[] = {0, 1, 1, 2};
    batten_curve_catmull_rom_options options = batten_curve_catmull_rom_defaults();
    batten_curve *curve = NULL;
    CHECK_STATUS(
        batten_curve_catmull_rom((batten_points){2, 4, points[0]}, NULL, NULL, NULL, &curve),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
    points[1][1] = 1;
    options.given = t;
    CHECK_STATUS(batten_curve_catmull_rom((batten_points){2, 4, points[0]}, &options, NULL,
                                          NULL, &curve),
                 BATTEN_NOT_INCREASING);
    options.given = NULL, options.phantoms = (batten_phantoms)3;
    CHECK_STATUS(batten_curve_catmull_rom((batten_points){2, 4, points[0]}, &options, NULL,
                                          NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    const double scales[] = {1e-150, 1e-9, 1e9, 1e150};
    for (int s = 0; s < COUNT(scales); s++) {
        double scaled[4][2];
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < 2; c++)
                scaled[i][c] = scales[s] * points[i][c];
        CHECK_OK(batten_curve_catmull_rom((batten_points){2, 4, scaled[0]}, NULL, NULL, NULL,
                                          &curve));
        batten_curve_unref(curve);
    }
    const double far[] = {-1.7e308, 1.7e308, -1.7e308};
    options = batten_curve_catmull_rom_defaults();
    options.alpha = 0;
    curve = NULL;
    CHECK_STATUS(
        batten_curve_catmull_rom((batten_points){1, 3, far}, &options, NULL, NULL, &curve),
        BATTEN_OVERFLOW);
    CHECK(curve == NULL);
}

/* Control points lie outside the span they come from, but never by many times its length; and
 * points that are near to each other are subtracted before anything else. */
TEST(uneven_steps_lose_no_accuracy)
{
    const double t[] = {0, 1,        2,   3,  4,  4 + 1e-6, 5,  5.001,
                        9, 9 + 1e-9, 9.5, 30, 31, 32,       34, 35};
    for (int q = 0; q < COUNT(members); q++) {
        const int k = members[q][0], m = members[q][1];
        if (m < k - 2)
            continue;
        batten_curve *curve = curve_of(k, m, 16, t, t);
        for (int i = 0; i <= 350; i++)
            CHECK_NEAR(value(curve, i / 10.0), i / 10.0, 1e-14 * 35);
        batten_curve_unref(curve);
    }
}
