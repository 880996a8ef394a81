#include "shape/boundary/coons_formula.h"

#include <batten/grid.h>
#include <batten/interpolate.h>

#include "support/faults.h"

enum { N = 5, M = 4 };

static const double u[N] = {0, 0.3, 1, 1.2, 2}, v[M] = {-1, -0.4, 0.1, 1};

typedef struct {
    batten_curve *along_u[M], *along_v[N];
} net;

static void height(test_random *random, double *points)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            double *point = points + 3 * (i * M + j);
            point[0] = u[i] + test_random_in(random, -0.05, 0.05);
            point[1] = v[j] + test_random_in(random, -0.05, 0.05);
            point[2] = test_random_in(random, -0.3, 0.3);
        }
}

static batten_curve *through(int count, const double *t, const double *points, int step)
{
    double row[3 * N];
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    batten_curve *curve = NULL;
    for (int i = 0; i < count; i++)
        memcpy(row + 3 * i, points + 3 * i * step, 3 * sizeof *row);
    CHECK_OK(batten_curve_interpolate((batten_points){3, count, row}, &options, NULL, &curve));
    return curve;
}

static void make_net(const double *points, net *out)
{
    for (int j = 0; j < M; j++)
        out->along_u[j] = through(N, u, points + 3 * j, M);
    for (int i = 0; i < N; i++)
        out->along_v[i] = through(M, v, points + 3 * i * M, 1);
}

static void release(net *given)
{
    for (int j = 0; j < M; j++)
        batten_curve_unref(given->along_u[j]);
    for (int i = 0; i < N; i++)
        batten_curve_unref(given->along_v[i]);
}

static batten_status patches(const net *given,
                             const batten_surface_coons_network_options *options, double *gap,
                             batten_surface **out)
{
    return batten_surface_coons_network(
        &(batten_curve_net){N, M, u, v, (const batten_curve *const *)given->along_u,
                            (const batten_curve *const *)given->along_v},
        options, gap, out);
}

/* The largest jump of derivatives of this order over the inner lines of the net. */
static double jump(const batten_surface *surface, int order)
{
    double worst = 0, left[18], right[18];
    const int first = BATTEN_SURFACE_DERIVATIVE(order, 0) * 3, last = first + 3 * (order + 1);
    for (int turn = 0; turn < 2; turn++)
        for (int line = 1; line + 1 < (turn ? M : N); line++)
            for (int s = 0; s <= 30; s++) {
                const double x = turn ? u[0] + (u[N - 1] - u[0]) * s / 30 : u[line];
                const double y = turn ? v[line] : v[0] + (v[M - 1] - v[0]) * s / 30;
                CHECK_OK(batten_surface_evaluate_side(
                    surface, x, y,
                    (batten_sides){turn ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT,
                                   turn ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT},
                    2, left));
                CHECK_OK(batten_surface_evaluate(surface, x, y, 2, right));
                for (int i = first; i < last; i++)
                    worst = fmax(worst, fabs(left[i] - right[i]));
            }
    return worst;
}

TEST(a_network_passes_its_curves_and_is_as_smooth_as_its_blends)
{
    test_random random = test_random_begin("network");
    double points[3 * N * M];
    net given;
    height(&random, points);
    make_net(points, &given);
    const int degrees[] = {3, 3, 5, 3}, times[] = {1, 2, 3, 1};
    for (int f = BATTEN_BLENDING_LINEAR; f <= BATTEN_BLENDING_COONS; f++) {
        batten_surface_coons_network_options options = batten_surface_coons_network_defaults();
        options.blending = (batten_blending)f;
        batten_surface *surface = NULL;
        double gap = 1, a[3], b[3];
        CHECK_OK(patches(&given, &options, &gap, &surface));
        CHECK(gap < 1e-14);
        for (int s = 0; s <= 50; s++) {
            const double x = u[0] + (u[N - 1] - u[0]) * s / 50;
            const double y = v[0] + (v[M - 1] - v[0]) * s / 50;
            for (int j = 0; j < M; j++) {
                CHECK_OK(batten_surface_evaluate(surface, x, v[j], 0, a));
                CHECK_OK(batten_curve_evaluate(given.along_u[j], x, 0, b));
                CHECK_NEAR(hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]), 0, 1e-13);
            }
            for (int i = 0; i < N; i++) {
                CHECK_OK(batten_surface_evaluate(surface, u[i], y, 0, a));
                CHECK_OK(batten_curve_evaluate(given.along_v[i], y, 0, b));
                CHECK_NEAR(hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]), 0, 1e-13);
            }
        }
        CHECK_INT(batten_surface_degree(surface, BATTEN_U), degrees[f]);
        const double *U = batten_surface_knots(surface, BATTEN_U);
        int stands = 0;
        for (int i = 0; i < batten_surface_knot_count(surface, BATTEN_U); i++)
            stands += fabs(U[i] - u[1]) < 1e-14;
        if (f != BATTEN_BLENDING_LINEAR)
            CHECK_INT(stands, times[f]);
        if (f >= BATTEN_BLENDING_CUBIC)
            CHECK_NEAR(jump(surface, 1), 0, 1e-12);
        if (f >= BATTEN_BLENDING_QUINTIC)
            CHECK_NEAR(jump(surface, 2), 0, 1e-11);
        else
            CHECK(jump(surface, 2) > 0.1);
        batten_surface_unref(surface);
    }
    release(&given);
}

/* One cell of a network is the patch with the same twists; seen at the corners here. */
TEST(a_network_has_the_twists_it_is_given)
{
    test_random random = test_random_begin("given");
    double points[3 * N * M], twists[3 * N * M];
    net given;
    height(&random, points);
    make_net(points, &given);
    for (int i = 0; i < 3 * N * M; i++)
        twists[i] = test_random_in(&random, -1, 1);
    batten_surface_coons_network_options options = batten_surface_coons_network_defaults();
    options.given = twists;
    batten_surface *surface = NULL;
    CHECK_OK(patches(&given, &options, NULL, &surface));
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            double out[18];
            CHECK_OK(batten_surface_evaluate(surface, u[i], v[j], 2, out));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(out[3 * BATTEN_SURFACE_DERIVATIVE(1, 1) + x],
                           twists[3 * (i * M + j) + x], 1e-12);
        }
    batten_surface_unref(surface);
    twists[7] = NAN;
    CHECK_STATUS(patches(&given, &options, NULL, &surface), BATTEN_NOT_FINITE);
    release(&given);
}

TEST(G7_curves_of_a_network_that_miss_each_other_are_named)
{
    test_random random = test_random_begin("miss");
    double points[3 * N * M], gap = 0;
    net given;
    height(&random, points);
    make_net(points, &given);
    points[3 * (2 * M + 1) + 2] += 0.125;
    batten_curve *moved = through(M, v, points + 3 * 2 * M, 1);
    batten_curve_unref(given.along_v[2]);
    given.along_v[2] = moved;
    batten_surface *surface = NULL;
    CHECK_STATUS(patches(&given, NULL, &gap, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curve 2 along u, at 1, and curve 3 along v, at -0.4, miss each other by "
                  "0.125");
    batten_surface_coons_network_options options = batten_surface_coons_network_defaults();
    options.tolerance = 0.2;
    CHECK_OK(patches(&given, &options, &gap, &surface));
    CHECK_NEAR(gap, 0.125, 1e-12);
    batten_surface_unref(surface);
    batten_curve *longer = NULL, *rational = NULL;
    CHECK_OK(batten_curve_set_domain(given.along_u[0], 0, 3, &longer));
    batten_curve_unref(given.along_u[0]);
    given.along_u[0] = longer;
    CHECK_STATUS(patches(&given, &options, NULL, &surface), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curve 1 along u runs over [0, 3], the net over [0, 2]");
    CHECK_OK(batten_curve_to_rational(given.along_u[0], &rational));
    batten_curve_unref(given.along_u[0]);
    given.along_u[0] = rational;
    CHECK_STATUS(patches(&given, &options, NULL, &surface), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("curve 1 along u is rational");
    release(&given);
}

TEST(a_grid_of_points_makes_a_network_with_every_kind_of_twist)
{
    test_random random = test_random_begin("grid");
    double points[3 * N * M], at_u[N], at_v[M];
    height(&random, points);
    for (int method = BATTEN_TWISTS_ZERO; method <= BATTEN_TWISTS_SELESNICK; method++) {
        batten_surface_coons_network_options options = batten_surface_coons_network_defaults();
        batten_surface *surface = NULL;
        options.twists = (batten_twists)method;
        CHECK_EACH_ALLOCATION(batten_surface_coons_grid(
            (batten_grid){3, N, M, points}, &options, (batten_uv_out){at_u, at_v}, &surface));
        for (int i = 0; i < N; i++)
            for (int j = 0; j < M; j++) {
                double out[3];
                CHECK_OK(batten_surface_evaluate(surface, at_u[i], at_v[j], 0, out));
                for (int x = 0; x < 3; x++)
                    CHECK_NEAR(out[x], points[3 * (i * M + j) + x], 1e-13);
            }
        batten_surface_unref(surface);
    }
    batten_surface *surface = NULL;
    points[10] = INFINITY;
    CHECK_STATUS(batten_surface_coons_grid((batten_grid){3, N, M, points}, NULL,
                                           (batten_uv_out){NULL, NULL}, &surface),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point (1, 4)");
    CHECK_STATUS(batten_surface_coons_grid((batten_grid){3, 1, M, points}, NULL,
                                           (batten_uv_out){NULL, NULL}, &surface),
                 BATTEN_TOO_FEW_POINTS);
}

/* ---- nine corners ---- */

/* Position, u- and w-tangents and twists of nine corners, four faces of nine by nine points. */
static void nine(double tangent, double twist, double values[9][4][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double node[4][3] = {
                {1 - i, j - 1, 0}, {-tangent, 0, 0}, {0, tangent, 0}, {0, 0, 0}};
            memcpy(values[3 * i + j], node, sizeof node);
        }
    values[4][3][2] = twist;
}

TEST(the_nine_corners_without_tangents_are_a_flat_square_with_normals)
{
    static const double at[] = {0, 1, 2};
    static const double steps[] = {0,         .04296875, .15625,    .31640625, .5,
                                   .68359375, .84375,    .95703125, 1};
    double values[9][4][3];
    nine(0, 0, values);
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_from_hermite((batten_uv){at, at},
                                         (batten_grid){3, 3, 3, &values[0][0][0]}, &surface));
    for (int i = 0; i <= 16; i++)
        for (int j = 0; j <= 16; j++) {
            double out[3];
            batten_vec3 normal;
            CHECK_OK(batten_surface_evaluate(surface, i / 8.0, j / 8.0, 0, out));
            CHECK_NEAR(out[0], 1 - (i < 8 ? steps[i] : 1 + steps[i - 8]), 1e-15);
            CHECK_NEAR(out[1], (j < 8 ? steps[j] : 1 + steps[j - 8]) - 1, 1e-15);
            CHECK(out[2] == 0);
            CHECK_OK(batten_surface_normal(surface, i / 8.0, j / 8.0, NULL, &normal));
            CHECK_NEAR(fabs(normal.z), 1, 1e-12);
        }
    batten_surface_unref(surface);
}

TEST(a_twist_at_the_middle_corner_lifts_the_faces_and_leaves_the_edges)
{
    static const double at[] = {0, 1, 2};
    double values[9][4][3];
    nine(1, 4, values);
    batten_surface *surface = NULL, *face = NULL;
    CHECK_OK(batten_surface_from_hermite((batten_uv){at, at},
                                         (batten_grid){3, 3, 3, &values[0][0][0]}, &surface));
    for (int s = 0; s <= 32; s++)
        for (int k = 0; k < 3; k++) {
            double out[3];
            CHECK_OK(batten_surface_evaluate(surface, s / 16.0, k, 0, out));
            CHECK(out[2] == 0);
            CHECK_NEAR(out[0], 1 - s / 16.0, 1e-15);
            CHECK_OK(batten_surface_evaluate(surface, k, s / 16.0, 0, out));
            CHECK(out[2] == 0);
        }
    double out[18];
    CHECK_OK(batten_surface_evaluate(surface, 0.5, 0.5, 0, out));
    CHECK_NEAR(out[2], 4 / 64.0, 1e-15);
    /* The face of corners 1, 2, 4, 5 by itself. */
    double corners[2][2][4][3];
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            memcpy(corners[i][j], values[3 * i + j], sizeof corners[i][j]);
    for (int f = BATTEN_BLENDING_CUBIC; f <= BATTEN_BLENDING_COONS; f++) {
        CHECK_OK(
            batten_surface_corner_patch(3, &corners[0][0][0][0], (batten_blending)f, &face));
        CHECK_OK(batten_surface_evaluate(face, 1, 1, 2, out));
        CHECK_NEAR(out[0], 0, 1e-15);
        CHECK_NEAR(out[3], -1, 1e-14);
        CHECK_NEAR(out[3 * 4 + 2], 4, 1e-13);
        if (f == BATTEN_BLENDING_CUBIC)
            for (int i = 0; i <= 8; i++) {
                double other[3];
                CHECK_OK(batten_surface_evaluate(surface, i / 8.0, 1 - i / 8.0, 0, out));
                CHECK_OK(batten_surface_evaluate(face, i / 8.0, 1 - i / 8.0, 0, other));
                CHECK_NEAR(other[2], out[2], 1e-15);
            }
        batten_surface_unref(face);
        face = NULL;
    }
    corners[0][0][0][0] = NAN;
    CHECK_STATUS(
        batten_surface_corner_patch(3, &corners[0][0][0][0], BATTEN_BLENDING_CUBIC, &face),
        BATTEN_NOT_FINITE);
    CHECK_STATUS(
        batten_surface_corner_patch(3, &corners[0][0][0][0], BATTEN_BLENDING_LINEAR, &face),
        BATTEN_NOT_FINITE);
    batten_surface_unref(surface);
}

TEST(S5_a_network_that_would_be_too_large_is_refused_before_the_work)
{
    enum { MANY = 3000 };
    const double points[] = {0, 0, 0, 1, 0, 0}, knots[] = {0, 0, MANY - 1, MANY - 1};
    double *at = test_array(MANY, sizeof *at);
    const batten_curve **curves = test_array(MANY, sizeof *curves);
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    for (int i = 0; i < MANY; i++) {
        at[i] = i;
        curves[i] = curve;
    }
    CHECK_STATUS(
        batten_surface_coons_network(&(batten_curve_net){MANY, MANY, at, at, curves, curves},
                                     NULL, NULL, &surface),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("3000 x 3000");
    batten_curve_unref(curve);
}
