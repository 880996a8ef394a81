#include <batten/grid.h>

#include "support/faults.h"
#include "support/test.h"

enum { N = 5, M = 4 };

static const double even[] = {0, 0.5, 1, 1.5, 2}, uneven[] = {0, 0.3, 1, 1.2, 2};
static const double across[] = {-1, -0.4, 0.1, 1};

typedef double (*scalar)(double u, double v, int k, int l);

/* The derivative of u^a v^b. */
static double power(double u, double v, int a, int b, int k, int l)
{
    double factor = 1;
    for (int i = 0; i < k; i++)
        factor *= a - i;
    for (int i = 0; i < l; i++)
        factor *= b - i;
    return factor == 0 ? 0 : factor * pow(u, a - k) * pow(v, b - l);
}

static double product(double u, double v, int k, int l)
{
    return power(u, v, 1, 1, k, l);
}

static double difference_of_squares(double u, double v, int k, int l)
{
    return power(u, v, 2, 0, k, l) - power(u, v, 0, 2, k, l);
}

static double translational(double u, double v, int k, int l)
{
    return power(u, v, 3, 0, k, l) + power(u, v, 0, 4, k, l);
}

static double biquadratic(double u, double v, int k, int l)
{
    return power(u, v, 2, 2, k, l) - 0.5 * power(u, v, 1, 2, k, l) + power(u, v, 2, 0, k, l);
}

/* a(u) + b(v) + u c(v) + v d(u) */
static double coons_like(double u, double v, int k, int l)
{
    return power(u, v, 4, 0, k, l) + power(u, v, 1, 3, k, l) - power(u, v, 3, 1, k, l);
}

static double bicubic(double u, double v, int k, int l)
{
    return power(u, v, 3, 3, k, l) + power(u, v, 3, 2, k, l) - 2 * power(u, v, 1, 3, k, l);
}

/* The largest error of the twists of a graph, from row `rim` of the net on. */
static double error_of(batten_twists method, scalar f, const double *u, int rim)
{
    double points[N * M], su[N * M], sv[N * M], twists[N * M], worst = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            points[i * M + j] = f(u[i], across[j], 0, 0);
            su[i * M + j] = f(u[i], across[j], 1, 0);
            sv[i * M + j] = f(u[i], across[j], 0, 1);
        }
    CHECK_EACH_ALLOCATION(batten_net_twists(
        method, &(batten_net){1, N, M, u, across, points, su, sv}, NULL, NULL, twists));
    for (int i = rim; i < N - rim; i++)
        for (int j = rim; j < M - rim; j++)
            worst = fmax(worst, fabs(twists[i * M + j] - f(u[i], across[j], 1, 1)));
    return worst;
}

TEST(each_method_is_exact_where_it_should_be)
{
    const struct {
        batten_twists method;
        scalar f;
        const double *u;
        int rim;
    } cases[] = {
        {BATTEN_TWISTS_ZERO, translational, uneven, 0},
        {BATTEN_TWISTS_BILINEAR, product, uneven, 0},
        {BATTEN_TWISTS_BILINEAR, translational, uneven, 0},
        {BATTEN_TWISTS_BESSEL, biquadratic, uneven, 0},
        {BATTEN_TWISTS_BESSEL, product, even, 0},
        {BATTEN_TWISTS_ADINI, coons_like, uneven, 0},
        {BATTEN_TWISTS_ADINI, translational, uneven, 0},
        {BATTEN_TWISTS_ENERGY, product, uneven, 0},
    };
    for (int c = 0; c < COUNT(cases); c++)
        CHECK_NEAR(error_of(cases[c].method, cases[c].f, cases[c].u, cases[c].rim), 0, 1e-11);
    CHECK(error_of(BATTEN_TWISTS_ZERO, product, even, 0) == 1);
    CHECK(error_of(BATTEN_TWISTS_ADINI, bicubic, uneven, 1) > 0.01);
}

/* On even spacing Adini's error has the factor of both differences: u^2 c(v) + v^2 d(u) too. */
static double even_only(double u, double v, int k, int l)
{
    return power(u, v, 2, 3, k, l);
}

TEST(adinis_twists_are_better_on_even_nets)
{
    static const double v[] = {-1, 0, 1, 2};
    double points[N * M], su[N * M], sv[N * M], twists[N * M];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            points[i * M + j] = even_only(even[i], v[j], 0, 0);
            su[i * M + j] = even_only(even[i], v[j], 1, 0);
            sv[i * M + j] = even_only(even[i], v[j], 0, 1);
        }
    CHECK_EACH_ALLOCATION(batten_net_twists(BATTEN_TWISTS_ADINI,
                                            &(batten_net){1, N, M, even, v, points, su, sv},
                                            NULL, NULL, twists));
    for (int i = 1; i + 1 < N; i++)
        for (int j = 1; j + 1 < M; j++)
            CHECK_NEAR(twists[i * M + j], even_only(even[i], v[j], 1, 1), 1e-12);
}

/* On square cells: at the rim of others the energy of a saddle can be lowered by twists. */
TEST(twists_of_least_energy_leave_a_saddle_of_square_cells)
{
    static const double v[] = {-0.5, 0, 0.5, 1};
    double points[N * M], su[N * M], sv[N * M], twists[N * M];
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            points[i * M + j] = difference_of_squares(even[i], v[j], 0, 0);
            su[i * M + j] = difference_of_squares(even[i], v[j], 1, 0);
            sv[i * M + j] = difference_of_squares(even[i], v[j], 0, 1);
        }
    CHECK_OK(batten_net_twists(BATTEN_TWISTS_ENERGY,
                               &(batten_net){1, N, M, even, v, points, su, sv}, NULL, NULL,
                               twists));
    for (int n = 0; n < N * M; n++)
        CHECK_NEAR(twists[n], 0, 1e-13);
}

/* The spline method returns the twists of a bicubic spline but for those of its corners, which
 * nothing in the net tells; a function of its class has Adini's corners. */
TEST(spline_twists_are_those_of_the_spline)
{
    CHECK_NEAR(error_of(BATTEN_TWISTS_SPLINE, product, uneven, 0), 0, 1e-13);
    CHECK_NEAR(error_of(BATTEN_TWISTS_SPLINE, translational, uneven, 0), 0, 1e-11);
}

/* Energy: no other twists do better, by the integral itself, of one cell of the unit square. */
TEST(energy_twists_solve_the_equations_of_one_cell)
{
    const double at[] = {0, 1}, points[] = {0, 0.3, -0.2, 1}, su[] = {0.1, 0, 0.4, -1};
    const double sv[] = {1, 0.5, -0.3, 0.2};
    double twists[4], other[4];
    CHECK_OK(batten_net_twists(BATTEN_TWISTS_ENERGY,
                               &(batten_net){1, 2, 2, at, at, points, su, sv}, NULL, NULL,
                               twists));
    double least = INFINITY, nearby = INFINITY;
    for (int c = -1; c < 8; c++) {
        double values[2][2][4], sum = 0;
        for (int i = 0; i < 4; i++) {
            other[i] = twists[i] + (c >= 0 && c / 2 == i ? (c % 2 ? 1e-3 : -1e-3) : 0);
            const double node[] = {points[i], su[i], sv[i], other[i]};
            memcpy(values[i / 2][i % 2], node, sizeof node);
        }
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_from_hermite(
            (batten_uv){at, at}, (batten_grid){1, 2, 2, &values[0][0][0]}, &surface));
        /* Simpson's rule is far from exact, but Gauss with 4 points is, up to degree 7. */
        static const double x[] = {0.06943184420297371, 0.3300094782075719, 0.6699905217924281,
                                   0.9305681557970263};
        static const double w[] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                   0.1739274225687269};
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                double out[6];
                CHECK_OK(batten_surface_evaluate(surface, x[i], x[j], 2, out));
                sum += w[i] * w[j] * (out[3] * out[3] + 2 * out[4] * out[4] + out[5] * out[5]);
            }
        if (c < 0)
            least = sum;
        else
            nearby = fmin(nearby, sum);
        batten_surface_unref(surface);
    }
    CHECK(nearby > least);
    CHECK(nearby - least < 1e-6);
}

TEST(selesnicks_twists_are_exact_with_the_true_curvature)
{
    /* (u, v, u v + u^2 / 4): a dense net, so that parabolas give E_v and G_u exactly. */
    double points[3 * N * M], su[3 * N * M], sv[3 * N * M], suu[3 * N * M], svv[3 * N * M];
    double gaussian[N * M], twists[3 * N * M];
    int clamped = -1;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            const double u = uneven[i], v = across[j], zu = v + u / 2, zv = u;
            const double w = 1 + zu * zu + zv * zv;
            const int n = i * M + j;
            const double node[5][3] = {
                {u, v, u * v + u * u / 4}, {1, 0, zu}, {0, 1, zv}, {0, 0, 0.5}, {0, 0, 0}};
            double *const arrays[5] = {points, su, sv, suu, svv};
            for (int k = 0; k < 5; k++)
                memcpy(arrays[k] + 3 * n, node[k], sizeof node[k]);
            gaussian[n] = -1 / (w * w);
        }
    const batten_twist_shape shape = {suu, svv, gaussian};
    CHECK_OK(batten_net_twists(BATTEN_TWISTS_SELESNICK,
                               &(batten_net){3, N, M, uneven, across, points, su, sv}, &shape,
                               &clamped, twists));
    CHECK_INT(clamped, 0);
    for (int n = 0; n < N * M; n++) {
        CHECK_NEAR(twists[3 * n], 0, 1e-14);
        CHECK_NEAR(twists[3 * n + 1], 0, 1e-14);
        CHECK_NEAR(twists[3 * n + 2], 1, 1e-14);
    }
    for (int n = 0; n < N * M; n++)
        gaussian[n] = 5;
    CHECK_OK(batten_net_twists(BATTEN_TWISTS_SELESNICK,
                               &(batten_net){3, N, M, uneven, across, points, su, sv}, &shape,
                               &clamped, twists));
    CHECK_INT(clamped, N * M);
    CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_SELESNICK,
                                   &(batten_net){3, N, M, uneven, across, points, su, sv}, NULL,
                                   NULL, twists),
                 BATTEN_BAD_ARGUMENT);
}

TEST(every_method_is_the_same_with_u_and_v_exchanged)
{
    test_random random = test_random_begin("exchange");
    double values[3][N * M], turned[3][N * M], twists[N * M], back[N * M];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < N; i++)
            for (int j = 0; j < M; j++) {
                values[k][i * M + j] = test_random_in(&random, -1, 1);
                turned[k == 0 ? 0 : 3 - k][j * N + i] = values[k][i * M + j];
            }
    for (int method = BATTEN_TWISTS_ZERO; method <= BATTEN_TWISTS_ENERGY; method++) {
        CHECK_OK(batten_net_twists(
            (batten_twists)method,
            &(batten_net){1, N, M, uneven, across, values[0], values[1], values[2]}, NULL, NULL,
            twists));
        CHECK_OK(batten_net_twists(
            (batten_twists)method,
            &(batten_net){1, M, N, across, uneven, turned[0], turned[1], turned[2]}, NULL, NULL,
            back));
        for (int i = 0; i < N; i++)
            for (int j = 0; j < M; j++)
                CHECK_NEAR(back[j * N + i], twists[i * M + j], 1e-12);
    }
}

TEST(nets_that_cannot_be_are_refused)
{
    double values[N * M] = {0}, twists[N * M], wrong[N] = {0, 1, 1, 2, 3};
    CHECK_STATUS(
        batten_net_twists(BATTEN_TWISTS_ADINI,
                          &(batten_net){1, N, M, wrong, across, values, values, values}, NULL,
                          NULL, twists),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3 in u is 1, after 1");
    CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                   &(batten_net){1, 1, M, even, across, values, values, values},
                                   NULL, NULL, twists),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_net_twists((batten_twists)9,
                                   &(batten_net){1, N, M, even, across, values, values, values},
                                   NULL, NULL, twists),
                 BATTEN_BAD_ARGUMENT);
    for (int k = 0; k < 2; k++) {
        const double last[] = {NAN, HUGE_VAL};
        double u[N], v[M];
        memcpy(u, even, sizeof u);
        memcpy(v, across, sizeof v);
        *(k == 0 ? &u[N - 1] : &v[M - 1]) = last[k];
        CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                       &(batten_net){1, N, M, u, v, values, values, values},
                                       NULL, NULL, twists),
                     BATTEN_NOT_FINITE);
        CHECK_MESSAGE(k == 0 ? "parameter 5 in u is " : "in v is inf");
    }
    values[6] = NAN;
    CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                   &(batten_net){1, N, M, even, across, values, values, values},
                                   NULL, NULL, twists),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the point at (2, 3)");
}

TEST(nets_have_one_to_three_coordinates_and_two_lines_at_least)
{
    static const int dimensions[] = {0, 4, -1};
    double values[4 * N * M] = {0}, twists[4 * N * M];
    for (int i = 0; i < COUNT(dimensions); i++) {
        char words[100];
        twists[0] = -7;
        CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                       &(batten_net){dimensions[i], N, M, even, across, values,
                                                     values, values},
                                       NULL, NULL, twists),
                     BATTEN_BAD_ARGUMENT);
        snprintf(words, sizeof words, "the dimension is %d; it must be 1, 2 or 3",
                 dimensions[i]);
        CHECK_MESSAGE(words);
        CHECK_BITS(twists[0], -7);
    }
    CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                   &(batten_net){1, 1, M, even, across, values, values, values},
                                   NULL, NULL, twists),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("the net has 1 line in u, fewer than 2");
    CHECK_STATUS(batten_net_twists(BATTEN_TWISTS_ADINI,
                                   &(batten_net){1, N, 1, even, across, values, values, values},
                                   NULL, NULL, twists),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("the net has 1 line in v, fewer than 2");
}

/* z = 3 x y over two lines each way: every corner has the twist 3. */
TEST(a_net_of_four_points_has_the_twist_of_its_saddle)
{
    static const batten_twists methods[] = {BATTEN_TWISTS_ADINI, BATTEN_TWISTS_ENERGY};
    static const double x[] = {1, 3}, y[] = {0, 2};
    double z[4], zx[4], zy[4], twists[4];
    for (int i = 0; i < 4; i++) {
        z[i] = 3 * x[i / 2] * y[i % 2];
        zx[i] = 3 * y[i % 2];
        zy[i] = 3 * x[i / 2];
    }
    for (int k = 0; k < COUNT(methods); k++) {
        CHECK_OK(batten_net_twists(methods[k], &(batten_net){1, 2, 2, x, y, z, zx, zy}, NULL,
                                   NULL, twists));
        for (int i = 0; i < 4; i++)
            CHECK_NEAR(twists[i], 3, 1e-12);
    }
}

/* S = (u + c u v, v, 0) at two lines each way: rates of Su . Su and Sv . Sv are those of chords, and there is no bend;
 * a curvature that the plane does not have is cut, and counted; where Sv is along Su Adini's twist stays. */
TEST(selesnicks_twist_of_a_plane_net_of_four_points_has_the_rates_of_its_chords)
{
    static const double x[] = {1, 3}, y[] = {0, 2}, c = 0.5;
    double p[12], su[12], sv[12], none[12] = {0}, gaussian[4], twists[12], adini[12];
    for (int curved = 0; curved < 3; curved++) {
        int clamped = -1;
        for (int i = 0; i < 4; i++) {
            const double u = x[i / 2], v = y[i % 2];
            const double all[3][3] = {{u + c * u * v, v, 0}, {1 + c * v, 0, 0}, {c * u, 1, 0}};
            memcpy(p + 3 * i, all[0], sizeof all[0]);
            memcpy(su + 3 * i, all[1], sizeof all[1]);
            memcpy(sv + 3 * i, all[2], sizeof all[2]);
            gaussian[i] = curved == 1 && i == 2 ? 1 : 0;
        }
        if (curved == 2) {
            memcpy(sv + 3, su + 3, 3 * sizeof *sv);
            sv[3] *= -2;
        }
        const batten_net net = {3, 2, 2, x, y, p, su, sv};
        const batten_twist_shape shape = {none, none, gaussian};
        CHECK_OK(batten_net_twists(BATTEN_TWISTS_SELESNICK, &net, &shape, &clamped, twists));
        CHECK_INT(clamped, curved == 1);
        CHECK_OK(batten_net_twists(BATTEN_TWISTS_ADINI, &net, NULL, NULL, adini));
        for (int i = 0; i < 4; i++) {
            const double *t = twists + 3 * i, *a = su + 3 * i, *b = sv + 3 * i;
            if (curved == 2 && i == 1) {
                for (int k = 0; k < 3; k++)
                    CHECK_BITS(t[k], adini[3 * i + k]);
                continue;
            }
            if (curved == 2) /* chords end in the changed one */
                continue;
            CHECK_NEAR(t[0] * a[0] + t[1] * a[1], ((1 + 2 * c) * (1 + 2 * c) - 1) / 2 / 2,
                       1e-13);
            CHECK_NEAR(t[0] * b[0] + t[1] * b[1], c * c * (9 - 1) / 2 / 2, 1e-13);
            CHECK_BITS(t[2] + 0.0, 0);
        }
    }
}
