#include "shape/formula/formula.h"

#include "numeric/jet.h"
#include "support/test.h"

/* z = scale sin(3 u) / (1 + v) over [0, 1] x [0, 2]; with `data` its scale. */
static batten_status wave(const void *data, const bat_surface_place *at, int order, double *out)
{
    const double u = at->u, v = at->v;
    const double s = sin(3 * u), c = cos(3 * u), scale = *(const double *)data;
    const bat_jet ju = bat_jet_u(u), jv = bat_jet_v(v);
    const bat_jet sine = bat_jet_compose((const double[4]){s, 3 * c, -9 * s, -27 * c}, ju);
    const bat_jet z =
        bat_jet_scale(scale, bat_jet_divide(sine, bat_jet_add(bat_jet_constant(1), jv)));
    const bat_jet xyz[3] = {ju, jv, z};
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = xyz[k].d[i];
    return BATTEN_OK;
}

static int freed;

static void count_free(void *data)
{
    (void)data;
    freed++;
}

static const bat_formula wave_formula = {"wave", wave, NULL, count_free};
static double one = 1;

static batten_surface *make_wave(void)
{
    batten_surface *surface = NULL;
    const double u[3] = {0, 0.4, 1}, v[2] = {0, 2};
    const bat_formula_axis axes[2] = {{3, u, 2}, {2, v, 2}};
    CHECK_OK(bat_formula_create(&wave_formula, &one, 3, &axes[0], &axes[1], 2, &surface));
    return surface;
}

TEST(a_formula_answers_what_any_surface_is_asked)
{
    freed = 0;
    batten_surface *surface = make_wave(), *mapped = NULL;
    double at[3 * 10], grid[2 * 3 * 3], normals[2 * 3 * 3], spans[3];
    CHECK_TEXT(batten_surface_kind(surface), "wave");
    CHECK_INT(batten_surface_spans(surface, BATTEN_U, spans), 3);
    CHECK_NEAR(spans[1], 0.4, 0);
    CHECK_NEAR(batten_surface_domain(surface, BATTEN_V).b, 2, 0);
    CHECK(!batten_surface_is_closed(surface, BATTEN_U, 0.1));
    CHECK(batten_surface_is_closed(surface, BATTEN_U, 1.2));
    CHECK_OK(batten_surface_evaluate(surface, 0.3, 0.5, 3, at));
    CHECK_NEAR(at[3 * 9 + 2], -6 * sin(0.9) / pow(1.5, 4), 1e-14);
    CHECK_STATUS(batten_surface_evaluate(surface, 0.3, 0.5, 4, at), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("up to 3");
    CHECK_STATUS(batten_surface_evaluate(surface, 1.3, 0.5, 0, at), BATTEN_OUT_OF_DOMAIN);

    const double u[2] = {0, 1}, v[3] = {0, 1, 2}, uv[4] = {0.2, 0.1, 0.2, 2.1};
    CHECK_OK(
        batten_surface_evaluate_grid(surface, (batten_uv_grid){2, 3, u, v}, 0, NULL, grid));
    CHECK_NEAR(grid[3 * 4 + 2], sin(3) / 2, 1e-15);
    CHECK_STATUS(batten_surface_evaluate_many(surface, 2, uv, 0, NULL, grid),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("v[1] = 2.1");
    CHECK_OK(
        batten_surface_normal_grid(surface, (batten_uv_grid){2, 3, u, v}, NULL, grid, normals));
    CHECK_NEAR(normals[2], 1 / sqrt(10), 1e-14); /* zu = 3, zv = 0 at (0, 0) */

    const batten_affine map = batten_affine_rotation(
        (batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, 1.5707963267948966);
    CHECK_OK(batten_surface_transform(surface, &map, &mapped));
    batten_surface_unref(surface);
    CHECK_INT(freed, 0);
    CHECK_OK(batten_surface_evaluate(mapped, 0.3, 0.5, 1, at));
    CHECK_NEAR(at[0], -0.5, 1e-15);
    CHECK_NEAR(at[1], 0.3, 1e-15);
    CHECK_NEAR(at[4], 1, 1e-15);
    batten_surface_unref(mapped);
    CHECK_INT(freed, 1);
}

static double farthest(const batten_surface *a, const batten_surface *b, double width,
                       double height)
{
    double worst = 0;
    for (int i = 0; i <= 101; i++)
        for (int j = 0; j <= 101; j++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(a, width * i / 101, height * j / 101, 0, p));
            CHECK_OK(batten_surface_evaluate(b, width * i / 101, height * j / 101, 0, q));
            worst = fmax(worst,
                         fmax(fabs(p[0] - q[0]), fmax(fabs(p[1] - q[1]), fabs(p[2] - q[2]))));
        }
    return worst;
}

TEST(the_spline_near_a_formula_keeps_its_tolerance)
{
    batten_surface *surface = make_wave();
    int last = 0;
    for (double tolerance = 1e-3; tolerance > 1e-13; tolerance *= 1e-3) {
        batten_surface *nurbs = NULL;
        double error = -1;
        CHECK_OK(batten_surface_to_nurbs(surface, tolerance, &error, &nurbs));
        CHECK(error >= 0 && error <= tolerance);
        CHECK(farthest(surface, nurbs, 1, 2) <= error + 1e-15);
        const int count = batten_surface_point_count(nurbs, BATTEN_U) *
                          batten_surface_point_count(nurbs, BATTEN_V);
        CHECK(count >= last && count < 30000);
        last = count;
        batten_surface_unref(nurbs);
    }
    batten_surface *nurbs = NULL;
    CHECK_STATUS(batten_surface_to_nurbs(surface, 1e-18, NULL, &nurbs),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_STATUS(batten_surface_to_nurbs(surface, -1, NULL, &nurbs), BATTEN_BAD_ARGUMENT);
    batten_surface_unref(surface);
}

TEST(an_isocurve_of_a_formula_lies_on_it)
{
    batten_surface *surface = make_wave();
    for (int k = 0; k < 2; k++) {
        batten_curve *curve = NULL;
        CHECK_OK(batten_surface_isocurve(surface, k ? BATTEN_V : BATTEN_U, 0.7, &curve));
        for (int i = 0; i <= 20; i++) {
            const double t = (k ? 1 : 2) * i / 20.0;
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(curve, t, 0, p));
            CHECK_OK(batten_surface_evaluate(surface, k ? t : 0.7, k ? 0.7 : t, 0, q));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(p[x], q[x], 4e-9);
        }
        batten_curve_unref(curve);
    }
    batten_surface_unref(surface);
}

TEST(the_box_of_a_formula_holds_it_closely)
{
    batten_surface *surface = make_wave();
    const batten_box box = batten_surface_box(surface);
    CHECK(box.high.z >= 1 && box.high.z < 1.01); /* sin(3 u) = 1 inside */
    CHECK(box.low.z <= 0 && box.low.z > -0.01);
    batten_surface_unref(surface);
}

/* (u (1 - v), u v, u^2): a pole at u = 0, as of a surface over a triangle. */
static batten_status pole(const void *data, const bat_surface_place *at, int order, double *out)
{
    (void)data;
    const double u = at->u, v = at->v;
    const bat_jet ju = bat_jet_u(u), jv = bat_jet_v(v), uv = bat_jet_multiply(ju, jv);
    const bat_jet xyz[3] = {bat_jet_subtract(ju, uv), uv, bat_jet_multiply(ju, ju)};
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = xyz[k].d[i];
    return BATTEN_OK;
}

TEST(a_formula_with_a_pole_has_its_normal_there)
{
    static const bat_formula formula = {"pole", pole, NULL, count_free};
    const double unit[2] = {0, 1};
    const bat_formula_axis axis = {2, unit, 2};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, &one, 3, &axis, &axis, 1, &surface));
    batten_vec3 normal;
    bool is_limit = false;
    CHECK_OK(batten_surface_normal(surface, 0, 0.5, &is_limit, &normal));
    CHECK(is_limit);
    CHECK_NEAR(normal.z, 1, 1e-12);
    batten_surface_unref(surface);
}

TEST(breaks_that_do_not_rise_are_refused)
{
    const double bad[3] = {0, 0.5, 0.5}, good[2] = {0, 1};
    const bat_formula_axis u = {3, bad, 1}, v = {2, good, 1}, few = {1, good, 1};
    batten_surface *surface = NULL;
    CHECK_STATUS(bat_formula_create(&wave_formula, &one, 3, &u, &v, 1, &surface),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(bat_formula_create(&wave_formula, &one, 3, &v, &few, 1, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("1 breaks in v");
}

/* At 1 - u, with the signs that this gives to derivatives; and the break at 0.4 is one at 0.6.
 */
TEST(a_mirrored_formula_keeps_its_outside_outside)
{
    batten_surface *surface = make_wave(), *image = NULL, *again = NULL, *nurbs = NULL;
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 1, 0});
    double spans[3], error = 0;
    CHECK_OK(batten_surface_transform_sides(surface, &mirror, &image));
    CHECK_INT(batten_surface_spans(image, BATTEN_U, spans), 3);
    CHECK_NEAR(spans[1], 0.6, 1e-15);
    for (int i = 0; i <= 20; i++) {
        const double u = i / 20.0, v = 0.7;
        double a[3 * 10], b[3 * 10];
        batten_vec3 n, m;
        CHECK_OK(batten_surface_evaluate(surface, u, v, 3, a));
        CHECK_OK(batten_surface_evaluate(image, 1 - u, v, 3, b));
        for (int k = 0; k <= 3; k++)
            for (int l = 0; k + l <= 3; l++)
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(b[3 * BATTEN_SURFACE_DERIVATIVE(k, l) + c],
                               (c == 1 ? -1 : 1) * (k % 2 ? -1 : 1) *
                                   a[3 * BATTEN_SURFACE_DERIVATIVE(k, l) + c],
                               1e-12);
        CHECK_OK(batten_surface_normal(surface, u, v, NULL, &n));
        CHECK_OK(batten_surface_normal(image, 1 - u, v, NULL, &m));
        CHECK_NEAR(m.x, n.x, 1e-12);
        CHECK_NEAR(m.y, -n.y, 1e-12);
        CHECK_NEAR(m.z, n.z, 1e-12);
    }
    CHECK_OK(batten_surface_to_nurbs(image, 1e-6, &error, &nurbs));
    CHECK(farthest(image, nurbs, 1, 2) <= 1e-6);
    CHECK_OK(batten_surface_transform_sides(image, &mirror, &again));
    CHECK(farthest(again, surface, 1, 2) <= 1e-14);
    batten_surface_unref(nurbs);
    batten_surface_unref(again);
    batten_surface_unref(image);
    batten_surface_unref(surface);
}

/* ---- an equal spline of its own ---- */

static double asked; /* the tolerance that the kind was asked for last */

/* (u, 2 v, u v) exactly, which says that it is half of the tolerance away. */
static batten_status saddle_to_nurbs(const void *data, double tolerance, batten_surface **out,
                                     double *error)
{
    (void)data;
    const double points[] = {0, 0, 0, 0, 2, 0, 1, 0, 0, 1, 2, 1}, knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    asked = tolerance;
    if (tolerance < 1e-12) /* a kind that can do no better */
        return BATTEN_TOLERANCE_NOT_MET;
    if (error)
        *error = tolerance / 2;
    return batten_surface_create(3, &axis, &axis, points, NULL, out);
}

static batten_status saddle(const void *data, const bat_surface_place *at, int order,
                            double *out)
{
    (void)data;
    const double u = at->u, v = at->v;
    memset(out, 0, 3 * (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof *out);
    out[0] = u;
    out[1] = 2 * v;
    out[2] = u * v;
    return BATTEN_OK;
}

TEST(an_equal_spline_moves_along_and_its_error_grows_with_the_map)
{
    static const bat_formula formula = {"saddle", saddle, saddle_to_nurbs, count_free};
    const double unit[2] = {0, 1};
    const bat_formula_axis axis = {2, unit, 2};
    batten_surface *surface = NULL, *own = NULL;
    double error = -1;
    CHECK_OK(bat_formula_create(&formula, &one, 3, &axis, &axis, 2, &surface));
    CHECK_OK(batten_surface_to_nurbs(surface, 1e-3, &error, &own));
    CHECK_NEAR(asked, 1e-3, 0);
    CHECK_NEAR(error, 0.5e-3, 0);
    CHECK_INT(batten_surface_point_count(own, BATTEN_U), 2);
    batten_surface_unref(own);
    const batten_affine maps[3] = {
        {{{5, 0, 0}, {0, 0.5, 0}, {0, 0, 2}}, {1, 2, 3}},
        {{{0, 0, -5}, {3, 0, 0}, {0, 1, 0}}, {0, 0, 0}}, /* it mirrors */
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {4, 5, 6}}};
    for (int i = 0; i < 3; i++) {
        batten_surface *moved = NULL, *nurbs = NULL;
        CHECK_OK(i < 2 ? batten_surface_transform_sides(surface, &maps[i], &moved)
                       : batten_surface_transform(surface, &maps[i], &moved));
        CHECK_OK(batten_surface_to_nurbs(moved, 1e-3, &error, &nurbs));
        CHECK(farthest(moved, nurbs, 1, 1) <= 1e-14 * 10);
        /* No vector grows by more than the root of the sum of the squares, 5.4 and 5.9. */
        double squares = 0;
        for (int k = 0; k < 9; k++)
            squares += (&maps[i].m[0][0])[k] * (&maps[i].m[0][0])[k];
        CHECK_NEAR(asked, squares > 0 ? 1e-3 / sqrt(squares) : 1e-3, 1e-17);
        CHECK_NEAR(error, asked / 2 * sqrt(squares), 1e-17);
        batten_surface_unref(nurbs);
        nurbs = NULL;
        CHECK_OK(batten_surface_to_nurbs(moved, 1e-3, NULL, &nurbs));
        batten_surface_unref(nurbs);
        nurbs = NULL;
        error = 7;
        CHECK_STATUS(batten_surface_to_nurbs(moved, 1e-14, &error, &nurbs),
                     BATTEN_TOLERANCE_NOT_MET);
        CHECK(!nurbs && error == 7);
        batten_surface_unref(moved);
    }
    batten_surface_unref(surface);
}

TEST(breaks_that_rounding_would_join_are_negated_when_a_surface_is_mirrored)
{
    const double u[3] = {0, 1e-300, 1}, v[2] = {0, 2};
    const bat_formula_axis axes[2] = {{3, u, 2}, {2, v, 2}};
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 1, 0});
    batten_surface *surface = NULL, *image = NULL;
    double spans[3], p[3];
    CHECK_OK(bat_formula_create(&wave_formula, &one, 3, &axes[0], &axes[1], 2, &surface));
    CHECK_OK(batten_surface_transform_sides(surface, &mirror, &image));
    CHECK_INT(batten_surface_spans(image, BATTEN_U, spans), 3);
    CHECK(spans[0] == -1 && spans[1] == -1e-300 && spans[2] == 0);
    CHECK_OK(batten_surface_evaluate(image, -1e-300, 1, 0, p));
    CHECK(p[0] == 1e-300);
    CHECK_OK(batten_surface_evaluate(image, -0.25, 1, 0, p));
    CHECK(p[0] == 0.25 && p[1] == -1);
    batten_surface_unref(image);
    batten_surface_unref(surface);
}

TEST(a_formula_that_is_refused_leaves_its_data_to_the_caller)
{
    freed = 0;
    double *breaks = test_array(4001, sizeof *breaks);
    for (int i = 0; i < 4001; i++)
        breaks[i] = i;
    const double unit[] = {0, 1};
    const bat_formula_axis many = {4001, breaks, 1}, axis = {2, unit, 1};
    batten_surface *surface = NULL;
    CHECK_STATUS(bat_formula_create(&wave_formula, &one, 3, &axis, &many, 1, &surface),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("4001 breaks in v");
    double endless = INFINITY; /* no box */
    CHECK_STATUS(bat_formula_create(&wave_formula, &endless, 3, &axis, &axis, 1, &surface),
                 BATTEN_OVERFLOW);
    CHECK(freed == 0 && !surface);
    batten_surface *wave_surface = make_wave(), *moved = NULL;
    batten_affine map = batten_affine_identity();
    map.t[2] = NAN;
    CHECK_STATUS(batten_surface_transform(wave_surface, &map, &moved), BATTEN_NOT_FINITE);
    map = batten_affine_identity();
    map.m[0][0] = INFINITY;
    CHECK_STATUS(batten_surface_transform(wave_surface, &map, &moved), BATTEN_NOT_FINITE);
    CHECK(!moved);
    batten_surface_unref(wave_surface);
    CHECK_INT(freed, 1);
}

/* (cos 2 pi u, sin 2 pi u, v), once around. */
static batten_status tube(const void *data, const bat_surface_place *at, int order, double *out)
{
    (void)data;
    const double u = at->u, v = at->v;
    memset(out, 0, 3 * (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof *out);
    out[0] = cos(6.283185307179586 * u);
    out[1] = sin(6.283185307179586 * u);
    out[2] = v;
    return BATTEN_OK;
}

TEST(a_tube_is_closed_around_and_open_along)
{
    static const bat_formula formula = {"tube", tube, NULL, count_free};
    const double u[] = {0, 0.25, 1}, v[] = {0, 2, 3, 7};
    const bat_formula_axis axes[2] = {{3, u, 2}, {4, v, 2}};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, &one, 3, &axes[0], &axes[1], 7, &surface));
    CHECK(batten_surface_is_closed(surface, BATTEN_U, 1e-12));
    CHECK(!batten_surface_is_closed(surface, BATTEN_V, 6.9));
    CHECK(batten_surface_is_closed(surface, BATTEN_V, 7.1));
    CHECK(!batten_surface_is_periodic(surface, BATTEN_U));
    batten_surface_unref(surface);
}
