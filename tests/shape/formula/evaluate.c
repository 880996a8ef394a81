/* Values of surfaces that are formulas: sides, batches, grids and normals. */
#include "shape/formula/evaluate.h"
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include "support/test.h"

static void keep(void *data)
{
    (void)data;
}

/* (u, v, from which side each is approached: 1 u + 2 v, a bit is set from the left) */
static batten_status sides(const void *data, const bat_surface_place *at, int order,
                           double *out)
{
    (void)data;
    memset(out, 0, 3 * (size_t)BATTEN_SURFACE_DERIVATIVES(order) * sizeof *out);
    out[0] = at->u;
    out[1] = at->v;
    out[2] = (at->sides.u == BATTEN_FROM_LEFT) + 2 * (at->sides.v == BATTEN_FROM_LEFT);
    return BATTEN_OK;
}

/* (u, v, u^2 v^3), with all derivatives. */
static batten_status power(const void *data, const bat_surface_place *at, int order,
                           double *out)
{
    (void)data;
    const bat_jet a = bat_jet_u(at->u), b = bat_jet_v(at->v);
    const bat_jet ab = bat_jet_multiply(a, b);
    const bat_jet xyz[3] = {a, b, bat_jet_multiply(bat_jet_multiply(ab, ab), b)};
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = xyz[k].d[i];
    return BATTEN_OK;
}

/* Finite points whose derivatives overflow. */
static batten_status steep(const void *data, const bat_surface_place *at, int order,
                           double *out)
{
    const batten_status status = power(data, at, order, out);
    if (order > 0)
        out[5] = INFINITY;
    return status;
}

static const double breaks_u[] = {0, 1, 3, 4}, breaks_v[] = {-1, 2, 3};

static batten_surface *
surface_of(batten_status (*evaluate)(const void *, const bat_surface_place *, int, double *))
{
    static const bat_formula_axis u = {4, breaks_u, 1}, v = {3, breaks_v, 2};
    const bat_formula formula = {"test", evaluate, NULL, keep};
    batten_surface *surface = NULL;
    CHECK_OK(bat_formula_create(&formula, NULL, 3, &u, &v, 100, &surface));
    return surface;
}

static int side_at(const batten_surface *surface, double u, double v, batten_side side_u,
                   batten_side side_v)
{
    const bat_surface_place place = {u, v, {side_u, side_v}};
    double p[3];
    CHECK_OK(bat_formula_evaluate(surface, &place, 0, p));
    return (int)p[2];
}

TEST(at_the_ends_of_the_domain_a_formula_is_asked_from_within)
{
    batten_surface *surface = surface_of(sides);
    for (int su = 0; su < 2; su++)
        for (int sv = 0; sv < 2; sv++) {
            const batten_side a = su ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
            const batten_side b = sv ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
            CHECK_INT(side_at(surface, 1, 2, a, b), su + 2 * sv);
            CHECK_INT(side_at(surface, 0, -1, a, b), 0);
            CHECK_INT(side_at(surface, 4, 3, a, b), 3);
            CHECK_INT(side_at(surface, 0, 2, a, b), 2 * sv);
            CHECK_INT(side_at(surface, 1, 3, a, b), su + 2);
        }
    batten_surface_unref(surface);
}

TEST(a_turned_formula_is_asked_from_the_other_side)
{
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1});
    batten_surface *surface = surface_of(sides), *turned = NULL;
    CHECK_OK(batten_surface_transform_sides(surface, &mirror, &turned));
    /* Breaks 0, 1, 3, 4 from the other end are 0, 1, 3, 4; the mirror negates the third. */
    CHECK_INT(side_at(turned, 1, 0, BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT), 0);
    CHECK_INT(side_at(turned, 1, 0, BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT), -1);
    for (int i = 0; i <= 16; i++) {
        const bat_surface_place place = bat_surface_place_at(i / 4.0, 0);
        double p[3];
        CHECK_OK(bat_formula_evaluate(turned, &place, 0, p));
        CHECK_NEAR(p[0], 4 - i / 4.0, 0);
    }
    batten_surface_unref(turned);
    batten_surface_unref(surface);
}

TEST(batches_and_grids_of_a_formula_are_its_single_values)
{
    enum { U = 11, V = 17, ROW = 3 * 10 }; /* more points than one piece of work */
    batten_surface *surface = surface_of(power);
    double u[U], v[V], uv[U * V * 2], *many = test_array(U * V, ROW * sizeof *many);
    double *grid = test_array(U * V, ROW * sizeof *grid);
    double *points = test_array(U * V, 3 * sizeof *points);
    double *normals = test_array(U * V, 3 * sizeof *normals);
    double *alone = test_array(U * V, 3 * sizeof *alone);
    for (int i = 0; i < U; i++)
        u[i] = 4.0 * i / (U - 1);
    for (int j = 0; j < V; j++)
        v[j] = -1 + 4.0 * j / (V - 1);
    for (int i = 0; i < U * V; i++) {
        uv[2 * i] = u[i / V];
        uv[2 * i + 1] = v[i % V];
    }
    const batten_uv_grid places = {U, V, u, v};
    CHECK_OK(batten_surface_evaluate_many(surface, U * V, uv, 3, NULL, many));
    CHECK_OK(batten_surface_evaluate_grid(surface, places, 3, NULL, grid));
    CHECK_OK(batten_surface_normal_grid(surface, places, NULL, points, normals));
    CHECK_OK(batten_surface_normal_grid(surface, places, NULL, NULL, alone));
    for (int i = 0; i < U * V; i++) {
        const double a = uv[2 * i], b = uv[2 * i + 1];
        const double *row = many + i * ROW;
        CHECK(!memcmp(row, grid + i * ROW, ROW * sizeof *row));
        CHECK(!memcmp(row, points + 3 * i, 3 * sizeof *row));
        CHECK(!memcmp(normals + 3 * i, alone + 3 * i, 3 * sizeof *row));
        CHECK_NEAR(row[2], a * a * b * b * b, 1e-12);
        CHECK_NEAR(row[3 * BATTEN_SURFACE_DERIVATIVE(1, 0) + 2], 2 * a * b * b * b, 1e-12);
        CHECK_NEAR(row[3 * BATTEN_SURFACE_DERIVATIVE(0, 1) + 2], 3 * a * a * b * b, 1e-12);
        CHECK_NEAR(row[3 * BATTEN_SURFACE_DERIVATIVE(1, 2) + 2], 12 * a * b, 1e-12);
        const double zu = 2 * a * b * b * b, zv = 3 * a * a * b * b;
        const double size = sqrt(1 + zu * zu + zv * zv);
        CHECK_NEAR(normals[3 * i], -zu / size, 1e-13);
        CHECK_NEAR(normals[3 * i + 1], -zv / size, 1e-13);
        CHECK_NEAR(normals[3 * i + 2], 1 / size, 1e-13);
    }
    CHECK_OK(batten_surface_normal_grid(surface, places, NULL, alone, NULL));
    CHECK(!memcmp(points, alone, U * V * 3 * sizeof *alone));
    batten_surface_unref(surface);
}

TEST(parameters_outside_are_named_with_their_index_before_anything_is_written)
{
    batten_surface *surface = surface_of(power);
    double out[3 * 4] = {7, 7, 7}, normals[3 * 4] = {7};
    const double uv[] = {1, 1, 4.5, 1, 1, 1, 1, -2}, good[] = {1, 2}, bad[] = {0, 9};
    CHECK_STATUS(batten_surface_evaluate_many(surface, 2, uv, 0, NULL, out),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("u[1] = 4.5 is not in the domain [0, 4]");
    CHECK_STATUS(batten_surface_evaluate_many(surface, 2, uv + 4, 0, NULL, out),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("v[1] = -2 is not in the domain [-1, 3]");
    CHECK_STATUS(
        batten_surface_evaluate_grid(surface, (batten_uv_grid){2, 2, good, bad}, 0, NULL, out),
        BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("v[1] = 9");
    CHECK_STATUS(batten_surface_normal_grid(surface, (batten_uv_grid){2, 2, bad, good}, NULL,
                                            out, normals),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("u[1] = 9");
    CHECK(out[0] == 7 && normals[0] == 7);
    CHECK_STATUS(batten_surface_evaluate(surface, 1, 3.1, 0, out), BATTEN_OUT_OF_DOMAIN);
    batten_surface_unref(surface);
}

TEST(derivatives_that_overflow_or_do_not_exist_are_refused)
{
    batten_surface *surface = surface_of(steep);
    double out[3 * 15] = {7};
    CHECK_STATUS(batten_surface_evaluate(surface, 1, 1, 1, out), BATTEN_OVERFLOW);
    CHECK_MESSAGE("(1, 1)");
    CHECK_STATUS(batten_surface_evaluate(surface, 1, 1, 4, out), BATTEN_BAD_ARGUMENT);
    CHECK(out[0] == 7);
    const double uv[] = {1, 1, 2, 2};
    CHECK_STATUS(batten_surface_evaluate_many(surface, 2, uv, 2, NULL, out), BATTEN_OVERFLOW);
    CHECK_OK(batten_surface_evaluate(surface, 1, 1, 0, out));
    batten_surface_unref(surface);
}

TEST(roundoff_is_that_of_the_span_on_the_side_that_is_asked)
{
    batten_surface *surface = surface_of(power);
    bat_surface_local at;
    bat_formula_local(surface,
                      &(bat_surface_place){1, 2, {BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT}}, &at);
    CHECK_NEAR(at.span[0], 1, 0);
    CHECK_NEAR(at.span[1], 1, 0);
    bat_formula_local(surface,
                      &(bat_surface_place){1, 2, {BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT}}, &at);
    CHECK_NEAR(at.span[0], 2, 0);
    CHECK_NEAR(at.span[1], 3, 0);
    CHECK_NEAR(at.largest, 100, 0);
    CHECK_INT(at.degree[0], BAT_FORMULA_LIKE_DEGREE);
    CHECK_INT(at.degree[1], BAT_FORMULA_LIKE_DEGREE);
    /* Coordinates up to 100 become up to 300 by a map that makes nothing longer than by
     * sqrt(14), and are moved by 50. */
    const batten_affine map = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {0, -50, 0}};
    batten_surface *moved = NULL;
    CHECK_OK(batten_surface_transform(surface, &map, &moved));
    bat_formula_local(moved, &(bat_surface_place){1, 2, {BATTEN_FROM_LEFT, BATTEN_FROM_LEFT}},
                      &at);
    CHECK_NEAR(at.largest, 100 * sqrt(14) + 50, 1e-10);
    batten_surface_unref(moved);
    CHECK_INT(bat_formula_smoothness(surface, BATTEN_U), 1);
    CHECK_INT(bat_formula_smoothness(surface, BATTEN_V), 2);
    batten_surface_unref(surface);
}
