/* Grids with more than points: derivatives of several orders, weights, gaps. */
#include <batten/grid.h>
#include <batten/interpolate.h>

#include "support/test.h"

enum { NU = 8, NV = 7 };
static const double us[NU] = {0, 0.3, 0.8, 1.1, 1.5, 1.9, 2.4, 3};
static const double vs[NV] = {-1, -0.6, 0, 0.2, 0.5, 1.3, 1.6};

static batten_surface_interpolate_options given(void)
{
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = us;
    options.given_v = vs;
    return options;
}

/* The k-th derivative of x^5 / 20 - x^3 + x + 1. */
static double quintic(double x, int k)
{
    const double d[] = {pow(x, 5) / 20 - pow(x, 3) + x + 1, pow(x, 4) / 4 - 3 * x * x + 1,
                        pow(x, 3) - 6 * x};
    return d[k];
}

static double product(double u, double v, int k, int l)
{
    return quintic(u, k) * (quintic(v, l) + (l == 0 ? 2 : 0));
}

typedef struct {
    double points[NU * NV], du[4 * NV], dv[4 * NU], twists[16];
} rim_data;

static void fill(rim_data *r)
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++)
            r->points[i * NV + j] = product(us[i], vs[j], 0, 0);
    for (int order = 1; order <= 2; order++)
        for (int end = 0; end < 2; end++) {
            const int at = 2 * (order - 1) + end;
            for (int j = 0; j < NV; j++)
                r->du[at * NV + j] = product(us[end ? NU - 1 : 0], vs[j], order, 0);
            for (int i = 0; i < NU; i++)
                r->dv[at * NU + i] = product(us[i], vs[end ? NV - 1 : 0], 0, order);
            for (int other = 0; other < 4; other++)
                r->twists[at * 4 + other] = product(
                    us[end ? NU - 1 : 0], vs[other % 2 ? NV - 1 : 0], order, other / 2 + 1);
        }
}

static double value(const batten_surface *s, double u, double v)
{
    double out;
    CHECK_OK(batten_surface_evaluate(s, u, v, 0, &out));
    return out;
}

static void check_product(const batten_surface *s)
{
    for (int i = 0; i <= 10; i++)
        for (int j = 0; j <= 10; j++)
            CHECK_NEAR(value(s, 0.3 * i, -1 + 0.26 * j), product(0.3 * i, -1 + 0.26 * j, 0, 0),
                       1e-10);
}

TEST(biquintics_are_reproduced_with_two_derivatives_at_the_rims)
{
    rim_data r;
    fill(&r);
    for (int at_data = 0; at_data < 2; at_data++) {
        batten_surface_interpolate_options options = given();
        batten_surface *s = NULL;
        options.degree_u = options.degree_v = 5;
        options.knots_at_data = at_data;
        options.orders_u = options.orders_v = 2;
        options.du = r.du;
        options.dv = r.dv;
        options.twists = r.twists;
        CHECK_OK(batten_surface_interpolate((batten_grid){1, NU, NV, r.points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s));
        CHECK_INT(batten_surface_point_count(s, BATTEN_U), NU + 4);
        CHECK_INT(batten_surface_point_count(s, BATTEN_V), NV + 4);
        check_product(s);
        batten_surface_unref(s);
    }
}

TEST(N1_every_number_of_the_derivatives_must_be_finite)
{
    static const char *const names[] = {"du", "dv", "twists"};
    static const int counts[] = {4 * NV, 4 * NU, 16};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < counts[k]; i += i + 3 < counts[k] ? 3 : 1) {
            rim_data r;
            char words[60];
            fill(&r);
            (k == 0 ? r.du : k == 1 ? r.dv : r.twists)[i] = i % 2 ? NAN : HUGE_VAL;
            batten_surface_interpolate_options options = given();
            batten_surface *s = NULL;
            options.degree_u = options.degree_v = 5;
            options.orders_u = options.orders_v = 2;
            options.du = r.du;
            options.dv = r.dv;
            options.twists = r.twists;
            CHECK_STATUS(batten_surface_interpolate((batten_grid){1, NU, NV, r.points},
                                                    &options, NULL, (batten_uv_out){NULL, NULL},
                                                    NULL, &s),
                         BATTEN_NOT_FINITE);
            snprintf(words, sizeof words, "number %d of `%s` is ", i + 1, names[k]);
            CHECK_MESSAGE(words);
            CHECK(!s);
        }
}

TEST(derivatives_that_do_not_go_together_are_refused)
{
    static const struct {
        int orders_u, orders_v;
        bool du, dv, twists, closed_u, closed_v;
        const char *says;
    } rows[] = {
        {-1, 1, true, true, true, false, false, "-1 orders along u, 1 along v: 0 to 25"},
        {1, 26, true, true, true, false, false, "1 orders along u, 26 along v"},
        {26, 1, true, true, true, false, false, "26 orders along u, 1 along v: 0 to 25"},
        {1, -1, true, true, true, false, false, "1 orders along u, -1 along v: 0 to 25"},
        {1, 1, true, false, true, false, false, "but not both `du` and `dv`"},
        {1, 1, false, true, true, false, false, "but not both `du` and `dv`"},
        {2, 1, true, true, false, false, false, "2 and 1 orders: then `twists` must be given"},
        {1, 2, true, true, false, false, false, "1 and 2 orders: then `twists` must be given"},
        {1, 1, true, false, false, true, false, "`du` is given, but a periodic surface"},
        {1, 1, false, true, false, false, true, "`dv` is given, but a periodic surface"},
        {1, 1, false, false, true, false, true, "`twists` is given, but a periodic surface"},
    };
    rim_data r;
    fill(&r);
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        batten_surface *s = NULL;
        options.orders_u = rows[i].orders_u;
        options.orders_v = rows[i].orders_v;
        options.du = rows[i].du ? r.du : NULL;
        options.dv = rows[i].dv ? r.dv : NULL;
        options.twists = rows[i].twists ? r.twists : NULL;
        options.closed_u = rows[i].closed_u;
        options.closed_v = rows[i].closed_v;
        CHECK_STATUS(batten_surface_interpolate((batten_grid){1, NU, NV, r.points}, &options,
                                                NULL, (batten_uv_out){NULL, NULL}, NULL, &s),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].says);
        CHECK(!s);
    }
}

TEST(averaged_knots_take_derivatives_of_any_subset)
{
    rim_data r;
    fill(&r);
    for (int c = 0; c < 3; c++) {
        batten_surface_interpolate_options options = given();
        batten_surface *s = NULL;
        options.degree_u = 4;
        options.degree_v = 2;
        options.du = c != 1 ? r.du : NULL;
        options.dv = c != 0 ? r.dv : NULL;
        CHECK_OK(batten_surface_interpolate((batten_grid){1, NU, NV, r.points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s));
        double out[BATTEN_SURFACE_DERIVATIVES(1)];
        CHECK_OK(batten_surface_evaluate(s, us[NU - 1], vs[3], 1, out));
        if (options.du)
            CHECK_NEAR(out[BATTEN_SURFACE_DERIVATIVE(1, 0)], r.du[NV + 3], 1e-10);
        CHECK_OK(batten_surface_evaluate(s, us[2], vs[0], 1, out));
        if (options.dv)
            CHECK_NEAR(out[BATTEN_SURFACE_DERIVATIVE(0, 1)], r.dv[2], 1e-10);
        batten_surface_unref(s);
    }
}

/* ---- weights ---- */

/* Homogeneous coordinates of a biquadratic rational surface. */
static void rational(double u, double v, double *xw)
{
    xw[3] = 1 + 0.2 * u * (3 - u) + 0.3 * v * v;
    xw[0] = u * xw[3];
    xw[1] = 1 - u * u / 9 + v;
    xw[2] = u * v + 0.5 * v * v - 1;
}

TEST(rational_surfaces_are_reproduced_from_points_and_weights)
{
    double points[NU * NV * 3], weights[NU * NV];
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double xw[4];
            rational(us[i], vs[j], xw);
            weights[i * NV + j] = xw[3];
            for (int k = 0; k < 3; k++)
                points[(i * NV + j) * 3 + k] = xw[k] / xw[3];
        }
    batten_surface_interpolate_options options = given();
    batten_surface *s = NULL;
    options.degree_u = 3; /* u w is cubic */
    options.degree_v = 2;
    options.weights = weights;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &s));
    CHECK(batten_surface_is_rational(s));
    for (int k = 0; k <= 20; k++) {
        double p[3], xw[4];
        const double u = 0.15 * k, v = -1 + 0.13 * k;
        CHECK_OK(batten_surface_evaluate(s, u, v, 0, p));
        rational(u, v, xw);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(p[c], xw[c] / xw[3], 1e-12);
    }
    batten_surface_unref(s);
}

TEST(K8_weights_that_swing_too_much_are_refused_by_name)
{
    double points[NU * NV * 3] = {0}, weights[NU * NV];
    for (int i = 0; i < NU * NV; i++) {
        points[3 * i] = us[i / NV];
        points[3 * i + 1] = vs[i % NV];
        weights[i] = i % 2 ? 1 : 1e-3;
    }
    batten_surface_interpolate_options options = given();
    batten_surface *s = NULL;
    options.weights = weights;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_WEIGHT);
    CHECK_MESSAGE("the weight of control point (");
    weights[9] = 0;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_WEIGHT);
    CHECK_MESSAGE("the weight of point 10 is 0");
    weights[9] = 1;
    options.du = points;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_BAD_ARGUMENT);
    CHECK(s == NULL);
}

/* ---- gaps ---- */

TEST(a_plane_with_gaps_stays_plane)
{
    double points[NU * NV * 3];
    bool gaps[NU * NV] = {false};
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = points + (i * NV + j) * 3;
            p[0] = us[i];
            p[1] = vs[j];
            p[2] = 2 * us[i] - vs[j] + 1;
            if ((i > 2 && i < 6 && j > 1) || (i == 0 && j == 0)) {
                gaps[i * NV + j] = true;
                p[0] = p[1] = p[2] = NAN;
            }
        }
    for (int c = 0; c < 2; c++) {
        batten_surface_interpolate_options options =
            c ? given() : batten_surface_interpolate_defaults();
        batten_surface *s = NULL;
        batten_surface_interpolate_report report;
        options.gaps = gaps;
        CHECK_OK(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, &report, &s));
        CHECK_INT(report.filled, 16);
        for (int i = 0; i <= 20; i++) {
            const batten_interval u = batten_surface_domain(s, BATTEN_U),
                                  v = batten_surface_domain(s, BATTEN_V);
            double p[3];
            CHECK_OK(batten_surface_evaluate(s, u.a + (u.b - u.a) * i / 20,
                                             v.a + (v.b - v.a) * (20 - i) / 20, 0, p));
            CHECK_NEAR(p[2], 2 * p[0] - p[1] + 1, 1e-11);
        }
        batten_surface_unref(s);
    }
}

static double wave(double u, double v)
{
    return sin(u) * cos(v);
}

TEST(points_that_are_there_are_met_and_gaps_come_near)
{
    double points[NU * NV];
    bool gaps[NU * NV] = {false};
    for (int i = 0; i < NU * NV; i++)
        points[i] = wave(us[i / NV], vs[i % NV]);
    gaps[3 * NV + 3] = true;
    points[3 * NV + 3] = 1e300;
    batten_surface_interpolate_options options = given();
    batten_surface *s = NULL;
    options.gaps = gaps;
    CHECK_OK(batten_surface_interpolate((batten_grid){1, NU, NV, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &s));
    for (int i = 0; i < NU * NV; i++)
        CHECK_NEAR(value(s, us[i / NV], vs[i % NV]), wave(us[i / NV], vs[i % NV]),
                   gaps[i] ? 0.02 : 1e-13);
    batten_surface_unref(s);
}

TEST(a_torus_with_gaps_closes_smoothly)
{
    enum { N = 16 };
    double points[N * N * 3];
    bool gaps[N * N] = {false};
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            const double a = i * acos(-1) / 8, b = j * acos(-1) / 8, r = 3 + cos(b);
            const double p[] = {r * cos(a), r * sin(a), sin(b)};
            memcpy(points + (i * N + j) * 3, p, sizeof p);
            gaps[i * N + j] = (i == 0 && j < 2) || (i == N - 1 && j == 0);
        }
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    batten_surface *s = NULL;
    options.closed_u = options.closed_v = true;
    options.gaps = gaps;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, N, N, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &s));
    double left[18], right[18], worst = 0;
    CHECK_OK(batten_surface_evaluate(s, 0, 0.3, 2, left));
    CHECK_OK(batten_surface_evaluate(s, 1, 0.3, 2, right));
    for (int k = 0; k < 18; k++)
        CHECK_NEAR(left[k], right[k], 1e-9);
    for (int k = 0; k < 50; k++) { /* how far from the torus */
        double p[3];
        CHECK_OK(batten_surface_evaluate(s, 0.98, 0.02 * k, 0, p));
        worst = fmax(worst, fabs(hypot(hypot(p[0], p[1]) - 3, p[2]) - 1));
    }
    CHECK(worst < 0.1);
    batten_surface_unref(s);
}

TEST(G9_gaps_that_nothing_determines_are_refused)
{
    double points[NU * NV * 3] = {0};
    bool gaps[NU * NV];
    batten_surface *s = NULL;
    batten_surface_interpolate_options options = given();
    for (int i = 0; i < NU * NV; i++)
        gaps[i] = i > 1;
    points[4] = 1;
    options.gaps = gaps;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("do not determine the 54 gaps");
    CHECK(s == NULL);
}

TEST(orders_up_to_the_highest_degree_may_stand_without_vectors)
{
    rim_data r;
    fill(&r);
    for (int k = 0; k < 2; k++) {
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        batten_surface *s = NULL;
        *(k ? &options.orders_v : &options.orders_u) = BATTEN_MAX_DEGREE;
        CHECK_OK(batten_surface_interpolate((batten_grid){1, NU, NV, r.points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &s));
        batten_surface_unref(s);
    }
}

TEST(weights_of_grids_are_above_zero_and_finite)
{
    static const double bad[] = {0, -1, INFINITY, NAN};
    static const char *const says[] = {"is 0; it must be above 0", "is -1; it must be above 0",
                                       "is inf; it must be above 0", "it must be above 0"};
    rim_data r;
    double weights[NU * NV];
    fill(&r);
    for (int i = 0; i < COUNT(bad); i++) {
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        batten_surface *s = NULL;
        for (int k = 0; k < NU * NV; k++)
            weights[k] = 1;
        weights[4] = bad[i];
        options.weights = weights;
        CHECK_STATUS(batten_surface_interpolate((batten_grid){1, NU, NV, r.points}, &options,
                                                NULL, (batten_uv_out){NULL, NULL}, NULL, &s),
                     BATTEN_BAD_WEIGHT);
        CHECK_MESSAGE("the weight of point 5 ");
        CHECK_MESSAGE(says[i]);
        CHECK(!s);
    }
}
