#include <batten/grid.h>
#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

enum { NU = 5, NV = 4 };

/* A hilly grid over uneven stations. */
static const double stations_u[NU] = {0, 0.1, 0.4, 0.8, 1}, stations_v[NV] = {0, 0.3, 0.5, 1};

static void hills(double points[NU * NV * 3])
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = points + (i * NV + j) * 3;
            p[0] = 4 * stations_u[i];
            p[1] = 3 * stations_v[j] + 0.1 * sin(3.0 * i);
            p[2] = cos(2.0 * i) * sin(1.5 * j) + 0.2 * i;
        }
}

static double apart(const batten_surface *a, const batten_surface *b, int order)
{
    double worst = 0;
    for (int i = 0; i <= 30; i++)
        for (int j = 0; j <= 30; j++) {
            double p[30], q[30];
            CHECK_OK(batten_surface_evaluate(a, i / 30.0, j / 30.0, order, p));
            CHECK_OK(batten_surface_evaluate(b, i / 30.0, j / 30.0, order, q));
            for (int k = 0; k < 3 * BATTEN_SURFACE_DERIVATIVES(order); k++)
                worst = fmax(worst, fabs(p[k] - q[k]));
        }
    return worst;
}

static batten_surface *natural_bicubic(const double *points)
{
    batten_surface *surface = NULL;
    batten_surface_interpolate_options o = batten_surface_interpolate_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given_u = stations_u;
    o.given_v = stations_v;
    o.knots_at_data = true;
    o.ends = BATTEN_END_NATURAL;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, NU, NV, points}, &o, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &surface));
    return surface;
}

static batten_surface *nu_surface(const double *points, double nu)
{
    batten_surface *surface = NULL;
    batten_surface_nu_options o = batten_surface_nu_defaults();
    o.u = stations_u;
    o.v = stations_v;
    o.nu_u = o.nu_v = nu;
    CHECK_EACH_ALLOCATION(
        batten_surface_nu((batten_grid){3, NU, NV, points}, &o, NULL, &surface));
    return surface;
}

static batten_surface *tension_surface(const double *points, double tension)
{
    batten_surface *surface = NULL;
    batten_surface_tension_options o = batten_surface_tension_defaults();
    o.u = stations_u;
    o.v = stations_v;
    o.tension_u = o.tension_v = tension;
    CHECK_EACH_ALLOCATION(
        batten_surface_tension((batten_grid){3, NU, NV, points}, &o, &surface));
    return surface;
}

TEST(without_tension_and_nu_all_are_the_natural_bicubic_spline)
{
    double points[NU * NV * 3];
    hills(points);
    batten_surface *spline = natural_bicubic(points), *nu = nu_surface(points, 0),
                   *tension = tension_surface(points, 0);
    CHECK(apart(spline, nu, 1) < 1e-11);
    CHECK(apart(spline, tension, 1) < 1e-11);
    batten_surface_unref(spline);
    batten_surface_unref(nu);
    batten_surface_unref(tension);
}

/* How far a cubic goes that halts at both ends, but begins or ends without bending at the first
 * or last. */
static double halting(bool first, bool last, double x)
{
    return first  ? x * (3 - x * x) / 2
           : last ? 1 - (1 - x) * (3 - (1 - x) * (1 - x)) / 2
                  : x * x * (3 - 2 * x);
}

/* The bilinear patch of the cell that holds (u, v); `slow`: the parameter halts at grid lines.
 */
static void bilinear(const double *points, bool slow, double u, double v, double out[3])
{
    int i = 0, j = 0;
    while (i + 2 < NU && u >= stations_u[i + 1])
        i++;
    while (j + 2 < NV && v >= stations_v[j + 1])
        j++;
    double x = (u - stations_u[i]) / (stations_u[i + 1] - stations_u[i]),
           y = (v - stations_v[j]) / (stations_v[j + 1] - stations_v[j]);
    if (slow) {
        x = halting(i == 0, i + 2 == NU, x);
        y = halting(j == 0, j + 2 == NV, y);
    }
    const double *p = points + (i * NV + j) * 3, *q = p + 3 * NV;
    for (int k = 0; k < 3; k++)
        out[k] =
            (1 - x) * ((1 - y) * p[k] + y * p[3 + k]) + x * ((1 - y) * q[k] + y * q[3 + k]);
}

TEST(with_very_much_of_either_they_are_bilinear_patches)
{
    double points[NU * NV * 3];
    hills(points);
    batten_surface *surfaces[2] = {nu_surface(points, 1e7), tension_surface(points, 1e7)};
    for (int s = 0; s < 2; s++) {
        for (int i = 0; i <= 20; i++)
            for (int j = 0; j <= 20; j++) {
                double at[3], expected[3];
                CHECK_OK(batten_surface_evaluate(surfaces[s], i / 20.0, j / 20.0, 0, at));
                bilinear(points, s == 0, i / 20.0, j / 20.0, expected);
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(at[k], expected[k], 1e-5);
            }
        batten_surface_unref(surfaces[s]);
    }
}

TEST(a_tension_surface_passes_its_points_and_is_c2)
{
    double points[NU * NV * 3], left[18], right[18];
    hills(points);
    batten_surface *surface = tension_surface(points, 6);
    CHECK_TEXT(batten_surface_kind(surface), "tension");
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            CHECK_OK(batten_surface_evaluate(surface, stations_u[i], stations_v[j], 0, left));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(left[k], points[(i * NV + j) * 3 + k], 1e-14);
        }
    for (int j = 0; j <= 12; j++) {
        CHECK_OK(batten_surface_evaluate_side(
            surface, stations_u[2], j / 12.0,
            (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT}, 2, left));
        CHECK_OK(batten_surface_evaluate_side(
            surface, stations_u[2], j / 12.0,
            (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, 2, right));
        for (int k = 0; k < 18; k++)
            CHECK_NEAR(left[k], right[k], 1e-9);
    }
    batten_surface_unref(surface);
}

/* In its strip the equation S_uuuu = sigma^2 S_uu holds: seen by differences of third
 * derivatives. */
TEST(a_tension_surface_obeys_the_equation_of_its_strips)
{
    double points[NU * NV * 3], at[30], before[30], after[30];
    hills(points);
    batten_surface *surface = tension_surface(points, 4);
    const double sigma = 4 / 0.25, h = 1e-5, u = 0.63, v = 0.71; /* 4 strips over 1 */
    CHECK_OK(batten_surface_evaluate(surface, u, v, 2, at));
    CHECK_OK(batten_surface_evaluate(surface, u - h, v, 3, before));
    CHECK_OK(batten_surface_evaluate(surface, u + h, v, 3, after));
    for (int k = 0; k < 3; k++) {
        const double fourth = (after[18 + k] - before[18 + k]) / (2 * h);
        CHECK_NEAR(fourth, sigma * sigma * at[9 + k], 1e-4 * (1 + fabs(fourth)));
    }
    batten_surface_unref(surface);
}

TEST(a_surface_in_tension_comes_out_as_nurbs_within_a_tolerance)
{
    double points[NU * NV * 3], error = 0;
    hills(points);
    batten_surface *surface = tension_surface(points, 6), *nurbs = NULL;
    CHECK_OK(batten_surface_to_nurbs(surface, 1e-6, &error, &nurbs));
    CHECK(error > 0 && error <= 1e-6);
    CHECK(apart(surface, nurbs, 0) <= error);
    batten_surface_unref(surface);
    batten_surface_unref(nurbs);
}

static void swap_grid(const double *from, double *to)
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++)
            memcpy(to + (j * NU + i) * 3, from + (i * NV + j) * 3, 3 * sizeof *to);
}

TEST(the_other_direction_first_gives_the_same_surface)
{
    double points[NU * NV * 3], turned[NU * NV * 3];
    hills(points);
    swap_grid(points, turned);
    batten_surface_nu_options o = batten_surface_nu_defaults();
    const double nus[NU] = {0, 3, 20, 0, 0};
    batten_surface *one = NULL, *other = NULL, *back = NULL;
    o.u = stations_u;
    o.v = stations_v;
    o.nus_u = nus;
    CHECK_EACH_ALLOCATION(batten_surface_nu((batten_grid){3, NU, NV, points}, &o, NULL, &one));
    o.u = stations_v;
    o.v = stations_u;
    o.nus_u = NULL;
    o.nus_v = nus;
    CHECK_OK(batten_surface_nu((batten_grid){3, NV, NU, turned}, &o, NULL, &other));
    CHECK_OK(batten_surface_swap(other, &back));
    CHECK(apart(one, back, 1) < 1e-12);
    batten_surface_unref(one);
    batten_surface_unref(other);
    batten_surface_unref(back);
}

/* The cubic of Catmull and Rom on the inner cell of 4 x 4 points with equal steps:
 * (u^3 u^2 u 1) M G M' (v^3 v^2 v 1)'. */
TEST(catmull_rom_is_the_matrix_form_on_an_inner_cell)
{
    static const double M[4][4] = {
        {-0.5, 1.5, -1.5, 0.5}, {1, -2.5, 2, -0.5}, {-0.5, 0, 0.5, 0}, {0, 1, 0, 0}};
    static const double steps[4] = {0, 1, 2, 3};
    double G[16], off = 1;
    for (int i = 0; i < 16; i++)
        G[i] = sin(1.7 * i) + 0.1 * i;
    batten_curve_catmull_rom_options o = batten_curve_catmull_rom_defaults();
    batten_surface *surface = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_catmull_rom(
        (batten_grid){1, 4, 4, G}, (batten_uv){steps, steps},
        (const batten_curve_catmull_rom_options *const[2]){&o, &o}, NULL, &off, &surface));
    CHECK(off < 1e-14);
    for (int a = 0; a <= 4; a++)
        for (int b = 0; b <= 4; b++) {
            const double x = a / 4.0, y = b / 4.0;
            const double U[4] = {x * x * x, x * x, x, 1}, V[4] = {y * y * y, y * y, y, 1};
            double expected = 0, at;
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 4; j++)
                    for (int k = 0; k < 4; k++)
                        for (int l = 0; l < 4; l++)
                            expected += U[i] * M[i][k] * G[k * 4 + l] * M[j][l] * V[j];
            CHECK_OK(batten_surface_evaluate(surface, 1 + x, 1 + y, 0, &at));
            CHECK_NEAR(at, expected, 1e-13);
        }
    batten_surface_unref(surface);
}

/* A ring of 12 x 8 points: closed both ways, and smooth over the seam. */
TEST(closed_grids_close_smoothly)
{
    double points[12 * 8 * 3];
    for (int i = 0; i < 12; i++)
        for (int j = 0; j < 8; j++) {
            const double a = 6.283185307179586 * i / 12, b = 6.283185307179586 * j / 8;
            double *p = points + (i * 8 + j) * 3;
            p[0] = (3 + cos(b)) * cos(a);
            p[1] = (3 + cos(b)) * sin(a);
            p[2] = sin(b);
        }
    batten_surface_nu_options nu = batten_surface_nu_defaults();
    batten_surface_tension_options tension = batten_surface_tension_defaults();
    batten_curve_catmull_rom_options local = batten_curve_catmull_rom_defaults();
    batten_surface *surfaces[3] = {NULL};
    nu.closed_u = nu.closed_v = tension.closed_u = tension.closed_v = local.closed = true;
    CHECK_OK(batten_surface_nu((batten_grid){3, 12, 8, points}, &nu, NULL, &surfaces[0]));
    CHECK_EACH_ALLOCATION(
        batten_surface_tension((batten_grid){3, 12, 8, points}, &tension, &surfaces[1]));
    CHECK_EACH_ALLOCATION(batten_surface_catmull_rom(
        (batten_grid){3, 12, 8, points}, (batten_uv){NULL, NULL},
        (const batten_curve_catmull_rom_options *const[2]){&local, &local}, NULL, NULL,
        &surfaces[2]));
    for (int s = 0; s < 3; s++) {
        for (int k = 0; k < 2; k++) {
            double first[9], last[9];
            const batten_interval d = batten_surface_domain(surfaces[s], (batten_direction)k);
            CHECK(batten_surface_is_closed(surfaces[s], (batten_direction)k, 1e-12));
            CHECK_OK(batten_surface_evaluate_side(
                surfaces[s], k ? 0.2 : d.a, k ? d.a : 0.2,
                (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, 1, first));
            CHECK_OK(batten_surface_evaluate_side(
                surfaces[s], k ? 0.2 : d.b, k ? d.b : 0.2,
                (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_LEFT}, 1, last));
            for (int x = 0; x < 9; x++)
                CHECK_NEAR(first[x], last[x], 1e-11);
        }
        double at[3];
        CHECK_OK(batten_surface_evaluate(surfaces[s], 0.54, 0.31, 0, at));
        const double ring = hypot(hypot(at[0], at[1]) - 3, at[2]);
        CHECK_NEAR(ring, 1, 0.02);
        batten_surface_unref(surfaces[s]);
    }
}

static batten_status own_knots(void *user, int dimension, int count, const double *points,
                               const double *parameters, batten_curve **out)
{
    (void)user;
    (void)parameters;
    return batten_curve_interpolate((batten_points){dimension, count, points}, NULL, NULL, out);
}

TEST(a_method_that_is_not_linear_is_refused)
{
    double points[NU * NV * 3];
    hills(points);
    const batten_line_method method = {own_knots, NULL, false};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_tensor((batten_grid){3, NU, NV, points},
                                       (batten_uv){stations_u, stations_v},
                                       (const batten_line_method *const[2]){&method, &method},
                                       NULL, NULL, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("along u, line 2");
    CHECK_MESSAGE("other knots");
}

TEST(bad_grids_are_refused_by_name) /* G5 G6 K7 */
{
    double points[NU * NV * 3];
    batten_surface *surface = NULL;
    hills(points);
    points[20] = NAN;
    CHECK_STATUS(batten_surface_nu((batten_grid){3, NU, NV, points}, NULL, NULL, &surface),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 3 of point 7 is nan");
    hills(points);
    memcpy(points + 3 * NV, points, 3 * NV * sizeof *points);
    CHECK_STATUS(batten_surface_tension((batten_grid){3, NU, NV, points}, NULL, &surface),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("u grid lines");
    CHECK_STATUS(batten_surface_nu((batten_grid){3, 1, NV, points}, NULL, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    hills(points);
    const double falling[NU] = {0, 0.2, 0.1, 0.8, 1};
    CHECK_STATUS(batten_surface_catmull_rom(
                     (batten_grid){3, NU, NV, points}, (batten_uv){falling, stations_v},
                     (const batten_curve_catmull_rom_options *const[2]){NULL, NULL}, NULL, NULL,
                     &surface),
                 BATTEN_NOT_INCREASING);
    batten_surface_tension_options o = batten_surface_tension_defaults();
    o.tension_v = -1;
    CHECK_STATUS(batten_surface_tension((batten_grid){3, NU, NV, points}, &o, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("along v, line 1: the tension of span 1 is -1");
}

/* A line of the grid that is a single point: a pole of the surface. */
TEST(a_pole_stays_a_pole)
{
    double points[NU * NV * 3], at[3];
    hills(points);
    for (int j = 1; j < NV; j++)
        memcpy(points + 3 * j, points, 3 * sizeof *points);
    batten_surface *surfaces[3] = {NULL};
    CHECK_OK(batten_surface_nu((batten_grid){3, NU, NV, points}, NULL, NULL, &surfaces[0]));
    CHECK_OK(batten_surface_tension((batten_grid){3, NU, NV, points}, NULL, &surfaces[1]));
    CHECK_OK(batten_surface_catmull_rom(
        (batten_grid){3, NU, NV, points}, (batten_uv){NULL, NULL},
        (const batten_curve_catmull_rom_options *const[2]){NULL, NULL}, NULL, NULL,
        &surfaces[2]));
    for (int s = 0; s < 3; s++) {
        for (int j = 0; j <= 10; j++) {
            CHECK_OK(batten_surface_evaluate(surfaces[s], 0, j / 10.0, 0, at));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(at[k], points[k], 1e-14);
        }
        batten_surface_unref(surfaces[s]);
    }
}

/* S M V M' T' / 36 on the one cell of 4 x 4 free points. */
TEST(a_free_uniform_surface_is_coons_matrix_form)
{
    static const double M[4][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 0, 3, 0}, {1, 4, 1, 0}};
    double V[16], at;
    batten_surface *surface = NULL;
    for (int i = 0; i < 16; i++)
        V[i] = cos(2.3 * i);
    CHECK_EACH_ALLOCATION(batten_surface_uniform(
        (batten_grid){1, 4, 4, V}, 3, 3, BATTEN_POLYGON_FREE, BATTEN_POLYGON_FREE, &surface));
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    for (int a = 0; a <= 4; a++)
        for (int b = 0; b <= 4; b++) {
            const double x = a / 4.0, y = b / 4.0;
            const double S[4] = {x * x * x, x * x, x, 1}, T[4] = {y * y * y, y * y, y, 1};
            double expected = 0;
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 4; j++)
                    for (int k = 0; k < 4; k++)
                        for (int l = 0; l < 4; l++)
                            expected += S[i] * M[i][k] * V[k * 4 + l] * M[j][l] * T[j] / 36;
            CHECK_OK(batten_surface_evaluate(surface, u.a + x * (u.b - u.a),
                                             v.a + y * (v.b - v.a), 0, &at));
            CHECK_NEAR(at, expected, 1e-14);
        }
    batten_surface_unref(surface);
    CHECK_STATUS(batten_surface_uniform((batten_grid){1, 4, 3, V}, 3, 3, BATTEN_POLYGON_CLAMPED,
                                        BATTEN_POLYGON_CLAMPED, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("along v, line 1");
}

TEST(parameters_of_a_grid_do_not_depend_on_what_stood_there)
{
    const double points[18] = {0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 1, 2, 0};
    double u[2] = {7, 7}, v[3] = {7, 7, 7}, spread[2] = {9, 9};
    CHECK_EACH_ALLOCATION(batten_grid_parametrize((batten_grid){3, 2, 3, points}, BATTEN_CHORD,
                                                  false, false, spread, (batten_uv_out){u, v}));
    CHECK_NEAR(u[0], 0, 0);
    CHECK_NEAR(u[1], 1, 0);
    CHECK_NEAR(v[1], 0.5, 1e-15);
    CHECK_NEAR(v[2], 1, 0);
    CHECK_NEAR(spread[0], 0, 0);
    v[0] = 5;
    double pinched[18];
    memcpy(pinched, points, sizeof pinched);
    memcpy(pinched + 3, pinched, 3 * sizeof *pinched);
    memcpy(pinched + 12, pinched + 9, 3 * sizeof *pinched);
    CHECK_STATUS(batten_grid_parametrize((batten_grid){3, 2, 3, pinched}, BATTEN_CHORD, false,
                                         false, NULL, (batten_uv_out){u, v}),
                 BATTEN_COINCIDENT);
    CHECK_NEAR(v[0], 5, 0);
}

/* A product f(u) g(v) has the product of the two curves: each direction keeps its own degree and ends. */
TEST(uniform_surfaces_have_their_own_degree_and_ends_in_each_direction)
{
    static const double f[6] = {1, 3, -2, 0.5, 4, 2}, g[5] = {2, -1, 1.5, 3, -4};
    double net[30];
    batten_surface *surface = NULL;
    batten_curve *curves[2] = {NULL, NULL};
    for (int i = 0; i < 30; i++)
        net[i] = f[i / 5] * g[i % 5];
    CHECK_OK(batten_surface_uniform((batten_grid){1, 6, 5, net}, 2, 3, BATTEN_POLYGON_CLAMPED,
                                    BATTEN_POLYGON_FREE, &surface));
    CHECK_OK(batten_curve_uniform((batten_points){1, 6, f}, 2, NULL, BATTEN_POLYGON_CLAMPED,
                                  &curves[0]));
    CHECK_OK(batten_curve_uniform((batten_points){1, 5, g}, 3, NULL, BATTEN_POLYGON_FREE,
                                  &curves[1]));
    const batten_interval u = batten_curve_domain(curves[0]),
                          v = batten_curve_domain(curves[1]);
    for (int n = 0; n < 49; n++) {
        const double x = u.a + (u.b - u.a) * (n / 7) / 6, y = v.a + (v.b - v.a) * (n % 7) / 6;
        double at[3];
        CHECK_OK(batten_curve_evaluate(curves[0], x, 0, &at[0]));
        CHECK_OK(batten_curve_evaluate(curves[1], y, 0, &at[1]));
        CHECK_OK(batten_surface_evaluate(surface, x, y, 0, &at[2]));
        CHECK_NEAR(at[2], at[0] * at[1], 1e-13);
    }
    batten_surface_unref(surface);
    batten_curve_unref(curves[0]);
    batten_curve_unref(curves[1]);
}

TEST(a_tension_surface_passes_the_points_of_its_rims)
{
    double points[NU * NV * 3], at[3];
    hills(points);
    for (int i = 0; i < NU * NV * 3; i++)
        points[i] += 1 + i % 3;
    batten_surface *surface = tension_surface(points, 2);
    for (int n = 0; n < NU * NV; n++) {
        CHECK_OK(
            batten_surface_evaluate(surface, stations_u[n / NV], stations_v[n % NV], 0, at));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(at[k], points[3 * n + k], 1e-13);
    }
    batten_surface_unref(surface);
}

TEST(grids_of_more_than_ten_million_points_are_refused)
{
    const double none[4] = {0};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_nu((batten_grid){1, 2, 5000001, none}, NULL, NULL, &surface),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("the grid has 10000002 points; the limit is 10000000");
    CHECK_STATUS(batten_surface_fit_grid((batten_grid){1, 2, 5000001, none}, NULL, NULL,
                                         (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("the grid has 10000002 points; the limit is 10000000");
}

/* 64 lines of 2 points along u: 128 steps, asked for once. */
TEST(every_64_lines_of_a_grid_a_step_is_taken_for_each_of_their_points)
{
    double points[2 * 64];
    batten_job job = BATTEN_JOB;
    for (int i = 0; i < 2 * 64; i++)
        points[i] = cos(i);
    for (int less = 0; less < 2; less++) {
        const batten_status due = less ? BATTEN_INCOMPLETE : BATTEN_OK;
        batten_surface *surface = NULL;
        job.work_limit = 128 - (unsigned)less;
        const batten_status status =
            batten_surface_nu((batten_grid){1, 2, 64, points}, NULL, &job, &surface);
        if (!test_memory_failed(status, due))
            CHECK_STATUS(status, due);
        batten_surface_unref(surface);
    }
}
