#include <batten/grid.h>
#include <batten/interpolate.h>

#include "shape/grid/fit_frame.h"
#include "support/faults.h"
#include "support/test.h"

enum { NU = 13, NV = 11 };

static double u_at(int i)
{
    return i + 0.3 * sin(i);
}

static double v_at(int j)
{
    return 2 * j + 0.5 * cos(2 * j);
}

static double wave(double u, double v)
{
    return sin(u / 2) * cos(v / 5) + 0.1 * u;
}

/* The parameters of the lines, and values of dimension 1. */
static double us[NU], vs[NV], data[NU * NV];

static batten_surface_fit_grid_options begin(void)
{
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = us;
    options.given_v = vs;
    for (int i = 0; i < NU; i++)
        us[i] = u_at(i);
    for (int j = 0; j < NV; j++)
        vs[j] = v_at(j);
    return options;
}

static void fill(double (*f)(double, double))
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++)
            data[i * NV + j] = f(us[i], vs[j]);
}

static double value(const batten_surface *s, double u, double v)
{
    double out;
    CHECK_OK(batten_surface_evaluate(s, u, v, 0, &out));
    return out;
}

TEST(as_many_control_points_as_data_interpolate)
{
    batten_surface_fit_grid_options options = begin();
    fill(wave);
    options.points_u = NU;
    options.points_v = NV;
    for (int hold = 0; hold < 2; hold++) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.hold_rims = hold;
        CHECK_EACH_ALLOCATION(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options,
                                                      NULL, (batten_uv_out){NULL, NULL},
                                                      &report, &s));
        CHECK(report.error < 1e-12);
        batten_surface_unref(s);
    }
}

static double bicubic(double u, double v)
{
    return (u * u * u / 100 - u + 2) * (v * v * v / 1000 + v * v / 50 - 3);
}

TEST(bicubics_are_reproduced_with_few_control_points)
{
    batten_surface_fit_grid_options options = begin();
    fill(bicubic);
    options.points_u = 5;
    options.points_v = 6;
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    double u[NU], v[NV];
    CHECK_EACH_ALLOCATION(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options,
                                                  NULL, (batten_uv_out){u, v}, &report, &s));
    CHECK(report.error < 1e-12 * 150 && report.points_u == 5 && report.points_v == 6);
    CHECK(u[3] == us[3] && v[4] == vs[4]);
    CHECK_NEAR(value(s, 3.3, 7.7), bicubic(3.3, 7.7), 1e-11);
    batten_surface_unref(s);
}

/* How the weighted squares change with control point (i, j): 0 at the least. */
static double gradient(const batten_surface *s, const double *wu, const double *wv, int i,
                       int j)
{
    batten_surface *moved = NULL;
    const int nv = batten_surface_point_count(s, BATTEN_V);
    const double up = batten_surface_points(s)[i * nv + j] + 1;
    double sum = 0;
    CHECK_OK(batten_surface_with_point(s, i, j, &up, &moved));
    for (int a = 0; a < NU; a++)
        for (int b = 0; b < NV; b++) {
            const double here = value(s, us[a], vs[b]);
            sum +=
                wu[a] * wv[b] * (here - data[a * NV + b]) * (value(moved, us[a], vs[b]) - here);
        }
    batten_surface_unref(moved);
    return sum;
}

TEST(residuals_are_square_to_the_basis)
{
    batten_surface_fit_grid_options options = begin();
    double wu[NU], wv[NV];
    fill(wave);
    for (int i = 0; i < NU; i++)
        wu[i] = 1 + i % 3;
    for (int j = 0; j < NV; j++)
        wv[j] = 0.5 + j % 2;
    options.points_u = 6;
    options.points_v = 5;
    options.hold_rims = false;
    options.weights_u = wu;
    options.weights_v = wv;
    batten_surface *s = NULL;
    CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                     (batten_uv_out){NULL, NULL}, NULL, &s));
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 5; j++)
            CHECK_NEAR(gradient(s, wu, wv, i, j), 0, 1e-12);
    batten_surface_unref(s);
}

TEST(a_held_rim_depends_on_its_own_data_alone_and_meets_the_corners)
{
    batten_surface_fit_grid_options options = begin();
    batten_surface *first = NULL, *second = NULL;
    fill(wave);
    CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                     (batten_uv_out){NULL, NULL}, NULL, &first));
    CHECK(value(first, us[0], vs[0]) == data[0]);
    CHECK(value(first, us[NU - 1], vs[0]) == data[(NU - 1) * NV]);
    for (int i = 0; i < NU - 1; i++)
        for (int j = 0; j < NV; j++)
            data[i * NV + j] += i + j % 3;
    CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                     (batten_uv_out){NULL, NULL}, NULL, &second));
    for (int k = 0; k <= 20; k++) {
        const double v = vs[0] + (vs[NV - 1] - vs[0]) * k / 20;
        CHECK_NEAR(value(first, us[NU - 1], v), value(second, us[NU - 1], v), 1e-13);
    }
    batten_surface_unref(first);
    batten_surface_unref(second);
}

TEST(a_knot_more_never_makes_squares_more)
{
    batten_surface_fit_grid_options options = begin();
    double last = HUGE_VAL;
    fill(wave);
    options.hold_rims = false;
    /* Doubled spans hold the knots of single ones when data are even. */
    for (int i = 0; i < NU; i++)
        us[i] = i;
    for (int n = 4; n <= NU; n += n - 3) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.points_u = n;
        options.points_v = NV;
        CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(report.rms <= last);
        last = report.rms;
        batten_surface_unref(s);
    }
}

static double ridge(double u, double v)
{
    return cos(u / 2) + 0.01 * v;
}

TEST(few_control_points_keep_within_a_tolerance)
{
    const double tolerances[] = {0.3, 0.01, 1e-9};
    int last = 0;
    for (int c = 0; c < 3; c++) {
        batten_surface_fit_grid_options options = begin();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        fill(wave);
        options.tolerance = tolerances[c];
        CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(report.error <= tolerances[c] && report.points_u * report.points_v > last);
        last = report.points_u * report.points_v;
        batten_surface_unref(s);
        fill(ridge); /* a line across needs no more */
        if (c == 1) {
            CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                             (batten_uv_out){NULL, NULL}, &report, &s));
            CHECK_INT(report.points_v, 4);
            batten_surface_unref(s);
        }
    }
    batten_surface_fit_grid_options options = begin();
    batten_surface *s = NULL;
    options.tolerance = NAN;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    CHECK(s == NULL);
}

/* ---- smoothing ---- */

static double noise(int i, int j)
{
    return sin(100.0 * i * i + 17.0 * j + 3.0 * i * j) / 20;
}

TEST(without_penalty_smoothing_is_least_squares)
{
    batten_surface_fit_grid_options options = begin();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    const double one[NU] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    fill(wave);
    options.points_u = 7;
    options.points_v = 6;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    CHECK_EACH_ALLOCATION(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options,
                                                     NULL, (batten_uv_out){NULL, NULL}, &report,
                                                     &s));
    CHECK_NEAR(report.freedom, 42, 1e-9);
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 6; j++)
            CHECK_NEAR(gradient(s, one, one, i, j), 0, 1e-11);
    batten_surface_unref(s);
    options.points_u = options.points_v = 0;
    CHECK_EACH_ALLOCATION(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options,
                                                     NULL, (batten_uv_out){NULL, NULL}, &report,
                                                     &s));
    CHECK(report.error < 1e-11 && report.points_u == NU && report.points_v == NV);
    batten_surface_unref(s);
}

static double tilted(double u, double v)
{
    return 2 + 3 * u - v + u * v / 7;
}

/* Least squares by 1, u .. u^m times 1, v .. v^m: what an infinite penalty leaves. */
static void check_polynomial(const batten_surface *s, int order)
{
    for (int k = 0; k < 2; k++)
        for (int a = 0; a < 5; a++) {
            double out[BATTEN_SURFACE_DERIVATIVES(3)];
            CHECK_OK(batten_surface_evaluate(s, us[2 * a], vs[a], order, out));
            CHECK_NEAR(out[BATTEN_SURFACE_DERIVATIVE(k ? order : 0, k ? 0 : order)], 0, 1e-9);
        }
}

TEST(an_infinite_penalty_leaves_the_polynomial)
{
    for (int c = 0; c < 4; c++) {
        batten_surface_fit_grid_options options = begin();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        fill(tilted);
        for (int i = 0; i < NU; i++)
            for (int j = 0; j < NV; j++)
                data[i * NV + j] += noise(i, j);
        options.order = 2 + c / 2;
        options.penalty = c % 2 ? BATTEN_GRID_DIFFERENCES : BATTEN_GRID_ENERGY;
        options.points_u = options.points_v = 8;
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        options.amount = HUGE_VAL;
        CHECK_OK(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK_NEAR(report.freedom, options.order * options.order, 1e-9);
        check_polynomial(s, options.order);
        CHECK(report.rms < 0.06 && report.rms > 0.01);
        batten_surface_unref(s);
    }
}

TEST(the_rms_that_is_asked_for_is_met)
{
    batten_surface_fit_grid_options options = begin();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    fill(wave);
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++)
            data[i * NV + j] += noise(i, j);
    options.by = BATTEN_SMOOTH_BY_RMS;
    options.amount = 0.03;
    CHECK_OK(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &s));
    CHECK_NEAR(report.rms, 0.03, 1e-8);
    CHECK(report.error >= report.most && report.most >= report.rms);
    batten_surface_unref(s);
}

TEST(validation_finds_the_surface_below_the_noise)
{
    enum { N = 40 };
    double *z = test_array(N * N, sizeof *z), at[N], truth = 0, before = 0;
    test_random random = test_random_begin("grid noise");
    for (int i = 0; i < N; i++)
        at[i] = i * 0.25;
    for (int i = 0; i < N * N; i++)
        z[i] = wave(at[i / N], at[i % N]) + test_random_in(&random, -0.2, 0.2);
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = options.given_v = at;
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    CHECK_OK(batten_surface_smooth_grid((batten_grid){1, N, N, z}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &s));
    for (int i = 0; i < N * N; i++) {
        const double w = wave(at[i / N], at[i % N]);
        truth += pow(value(s, at[i / N], at[i % N]) - w, 2);
        before += pow(z[i] - w, 2);
    }
    /* Of independent noise the share freedom / N^2 is left. */
    CHECK(truth < 1.5 * before * report.freedom / (N * N));
    CHECK_NEAR(report.rms, 0.2 / sqrt(3), 0.01);
    CHECK(report.freedom > 4 && report.freedom < 80);
    batten_surface_unref(s);
}

TEST(grids_that_close_are_fitted_and_smoothed)
{
    enum { N = 24 };
    double *p = test_array(N * N * 3, sizeof *p);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double a = i * acos(-1) / 12, b = j * acos(-1) / 12, r = 3 + cos(b);
            p[(i * N + j) * 3] = r * cos(a);
            p[(i * N + j) * 3 + 1] = r * sin(a);
            p[(i * N + j) * 3 + 2] = sin(b);
        }
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.closed_u = options.closed_v = true;
    options.points_u = options.points_v = 12;
    for (int c = 0; c < 2; c++) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        options.amount = 1e-9;
        CHECK_OK((c ? batten_surface_smooth_grid
                    : batten_surface_fit_grid)((batten_grid){3, N, N, p}, &options, NULL,
                                               (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(batten_surface_is_periodic(s, BATTEN_U) &&
              batten_surface_is_periodic(s, BATTEN_V));
        CHECK(report.error < 0.01);
        batten_surface_unref(s);
    }
}

TEST(G5_a_rim_that_is_one_point_stays_one)
{
    enum { U = 9, V = 12 };
    double p[U * V * 3];
    for (int i = 0; i < U; i++) /* the pole at the first row */
        for (int j = 0; j < V; j++) {
            const double a = 0.15 * i, b = 0.5 * j;
            const double q[] = {sin(a) * cos(b) + 1 / 3., sin(a) * sin(b) + 1 / 7., cos(a)};
            memcpy(p + (i * V + j) * 3, i == 0 ? (double[]){1 / 3., 1 / 7., 1} : q, sizeof q);
        }
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    CHECK_OK(batten_surface_fit_grid((batten_grid){3, U, V, p}, NULL, NULL,
                                     (batten_uv_out){NULL, NULL}, &report, &s));
    for (int j = 0; j < report.points_v; j++)
        for (int k = 0; k < 3; k++)
            CHECK(batten_surface_points(s)[3 * j + k] == p[k]);
    batten_surface_unref(s);
}

TEST(dierckx_grid_is_smoothed_below_its_noise)
{
    FILE *file = fopen(test_data("grids/dierckx_regrid11.txt"), "r");
    char line[256];
    double z[121], at[11], left = 0, before = 0;
    CHECK(file && fgets(line, sizeof line, file));
    for (int i = 0; i < 121; i++)
        CHECK(fscanf(file, "%lf", &z[i]) == 1);
    fclose(file);
    for (int i = 0; i < 11; i++)
        at[i] = -1.5 + 0.3 * i;
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = options.given_v = at;
    batten_surface *s = NULL;
    CHECK_OK(batten_surface_smooth_grid((batten_grid){1, 11, 11, z}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &s));
    /* The data are exp(-x^2 - y^2) and noise. */
    for (int i = 0; i < 121; i++) {
        const double x = at[i / 11], y = at[i % 11], f = exp(-x * x - y * y);
        left += pow(value(s, x, y) - f, 2);
        before += pow(z[i] - f, 2);
    }
    CHECK(left < before / 3);
    batten_surface_unref(s);
}

/* ---- bad input ---- */

TEST(N1_bad_grids_and_options_are_refused)
{
    batten_surface_fit_grid_options options = begin();
    batten_surface *s = NULL;
    fill(wave);
    options.points_u = NU + 1;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("14 control points along u, and the grid has 13 lines");
    options.points_u = 3;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("3 control points along u, and degree 3 needs 4");
    options = batten_surface_fit_grid_defaults();
    options.closed_v = true;
    options.points_v = 3; /* of one period, of degree 3 */
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("3 control points along v, and degree 3 needs 4");
    options = begin();
    options.degree_v = 0;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_DEGREE);
    CHECK_MESSAGE("along v is 0");
    options = begin();
    data[17] = NAN;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_NOT_FINITE);
    fill(wave);
    us[4] = us[3];
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_NOT_INCREASING);
    options = begin();
    options.order = 5;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    options = begin();
    options.points_u = 401;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_TOO_LARGE);
    options = begin();
    options.by = BATTEN_SMOOTH_BY_RMS;
    options.amount = -1;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    options = begin();
    double weights[NU] = {1, 1, -1};
    options.weights_u = weights;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_WEIGHT);
    CHECK(s == NULL);
}

TEST(N2_sizes_far_from_one_change_nothing_of_a_grid)
{
    const double sizes[] = {1e80, 1e-80};
    for (int c = 0; c < 2; c++) {
        batten_surface_fit_grid_options options = begin();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        fill(bicubic);
        for (int k = 0; k < NU * NV; k++)
            data[k] *= sizes[c];
        options.points_u = options.points_v = 6;
        CHECK_OK(batten_surface_fit_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(report.error < 1e-12 * 150 * sizes[c]);
        batten_surface_unref(s);
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        CHECK_OK(batten_surface_smooth_grid((batten_grid){1, NU, NV, data}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK(report.error < 1e-10 * 150 * sizes[c]);
        batten_surface_unref(s);
    }
}

TEST(N2_distances_whose_squares_are_no_numbers_are_refused)
{
    double points[16 * 3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 16; i++) {
        points[3 * i] = i / 4;
        points[3 * i + 1] = i % 4;
        points[3 * i + 2] = (i * 7 % 5 - 2) * 1e200;
    }
    batten_surface_fit_grid_options o = batten_surface_fit_grid_defaults();
    o.points_u = o.points_v = 2;
    o.degree_u = o.degree_v = 1;
    const batten_status status = batten_surface_fit_grid(
        (batten_grid){3, 4, 4, points}, &o, NULL, (batten_uv_out){NULL, NULL}, NULL, &surface);
    CHECK(status != BATTEN_OK && !surface);
}

TEST(distances_of_no_weight_are_not_measured)
{
    const double weights[6] = {1, 0, 2, 0.5, 1, 0};
    double distances[6] = {3, 90, 4, 0, 12, 80}, none[6] = {0}, again[4] = {0, 2, 2, 1};
    batten_surface_fit_report report = {.error = -1, .worst = -1};
    CHECK_OK(bat_surface_fit_measure(6, distances, weights, &report));
    CHECK_BITS(report.error, 12);
    CHECK_INT(report.worst, 4);
    CHECK_BITS(report.rms, 6.5);
    CHECK_BITS(report.most, 12);
    CHECK_OK(bat_surface_fit_measure(6, distances, none, &report));
    CHECK(report.error == 0 && report.worst == 0 && report.rms == 0 && report.most == 0);
    CHECK_OK(bat_surface_fit_measure(4, again, NULL, &report));
    CHECK_INT(report.worst, 1);
    CHECK_BITS(report.rms, 1.5);
}

/* 95 of 100 are no larger than `most`. */
TEST(of_a_hundred_distances_the_ninety_fifth_is_reported)
{
    double distances[100];
    batten_surface_fit_report report;
    for (int i = 0; i < 100; i++)
        distances[i] = (37 * i) % 100 + 1;
    CHECK_OK(bat_surface_fit_measure(100, distances, NULL, &report));
    CHECK_BITS(report.most, 95);
    CHECK_BITS(report.error, 100);
    CHECK_INT(report.worst, 27);
}

TEST(a_grid_of_one_line_is_refused)
{
    const double z[5] = {0, 1, 2, 4, 5};
    batten_surface *s = NULL;
    for (int k = 0; k < 2; k++) {
        const batten_grid grid = {1, k ? 5 : 1, k ? 1 : 5, z};
        CHECK_STATUS(
            batten_surface_fit_grid(grid, NULL, NULL, (batten_uv_out){NULL, NULL}, NULL, &s),
            BATTEN_TOO_FEW_POINTS);
        CHECK_MESSAGE(k ? "the grid has 5 x 1 points, and needs 2 x 2"
                        : "the grid has 1 x 5 points, and needs 2 x 2");
    }
}

/* Two lines one way have no room for more: all that is added goes the other way. */
TEST(points_are_added_where_there_is_room)
{
    double z[2 * 24];
    for (int v_long = 0; v_long < 2; v_long++) {
        batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
        batten_surface_fit_report report;
        batten_surface *s = NULL;
        for (int i = 0; i < 24; i++)
            for (int j = 0; j < 2; j++)
                z[v_long ? j * 24 + i : i * 2 + j] = sin(i / 3.) + j;
        options.parameters = BATTEN_UNIFORM;
        options.tolerance = 0.01;
        CHECK_OK(batten_surface_fit_grid((batten_grid){1, v_long ? 2 : 24, v_long ? 24 : 2, z},
                                         &options, NULL, (batten_uv_out){NULL, NULL}, &report,
                                         &s));
        CHECK(report.error <= 0.01 && report.rounds > 1);
        CHECK_INT(v_long ? report.points_u : report.points_v, 2);
        CHECK((v_long ? report.points_v : report.points_u) > 4);
        batten_surface_unref(s);
    }
}

TEST(a_tolerance_below_rounding_is_not_met_with_a_control_point_for_each_line)
{
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    batten_surface *s = NULL;
    double z[36];
    for (int i = 0; i < 36; i++)
        z[i] = sin(5.0 * i * i);
    options.parameters = BATTEN_UNIFORM;
    options.tolerance = 1e-100;
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, 6, 6, z}, &options, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("more than 1e-100, with 6 x 6 control points");
    CHECK(!s);
}

TEST(smoothing_refuses_weights_whose_products_are_all_zero)
{
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    batten_surface *s = NULL;
    double z[36], tiny[6];
    for (int i = 0; i < 36; i++)
        z[i] = i % 7;
    for (int i = 0; i < 6; i++)
        tiny[i] = 1e-200;
    options.weights_u = options.weights_v = tiny;
    CHECK_STATUS(batten_surface_smooth_grid((batten_grid){1, 6, 6, z}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("all data have the weight 0");
}
