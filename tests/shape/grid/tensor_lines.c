/* The least grids, and methods whose lines do not go together. */
#include <batten/grid.h>
#include <batten/standard.h>

#include "support/test.h"

enum { NU = 5, NV = 4 };

static const double stations_u[NU] = {0, 0.1, 0.4, 0.8, 1}, stations_v[NV] = {0, 0.3, 0.5, 1};

/* Two points each way, three where it closes. */
TEST(the_least_grids_have_parameters_and_smaller_ones_are_refused)
{
    static const double points[9] = {0, 1, 3, 2, 4, 9, 5, 7, 6};
    static const struct {
        int count_u, count_v;
        bool closed_u, closed_v;
        const char *says; /* NULL: nothing */
    } rows[] = {{2, 2, false, false, NULL},
                {3, 2, true, false, NULL},
                {2, 3, false, true, NULL},
                {3, 3, true, true, NULL},
                {1, 2, false, false, "the grid has 1 x 2 points, and needs 2 x 2"},
                {2, 1, false, false, "the grid has 2 x 1 points, and needs 2 x 2"},
                {2, 3, true, false, "the grid has 2 x 3 points, and needs 3 x 2"},
                {3, 2, false, true, "the grid has 3 x 2 points, and needs 2 x 3"}};
    for (int i = 0; i < COUNT(rows); i++) {
        double u[5] = {-7, -7, -7, -7, -7}, v[5] = {-7, -7, -7, -7, -7};
        const batten_grid grid = {1, rows[i].count_u, rows[i].count_v, points};
        CHECK_STATUS(batten_grid_parametrize(grid, BATTEN_UNIFORM, rows[i].closed_u,
                                             rows[i].closed_v, NULL, (batten_uv_out){u, v}),
                     rows[i].says ? BATTEN_TOO_FEW_POINTS : BATTEN_OK);
        if (rows[i].says)
            CHECK_MESSAGE(rows[i].says);
        const int nu = rows[i].says ? 0 : rows[i].count_u + rows[i].closed_u,
                  nv = rows[i].says ? 0 : rows[i].count_v + rows[i].closed_v;
        for (int k = 0; k < 5; k++) {
            if (k < nu)
                CHECK_NEAR(u[k], (double)k / (nu - 1), 1e-15);
            else
                CHECK_BITS(u[k], -7);
            if (k < nv)
                CHECK_NEAR(v[k], (double)k / (nv - 1), 1e-15);
            else
                CHECK_BITS(v[k], -7);
        }
    }
}

/* What a method may not do with its second line, or with any. */
typedef enum { RATIONAL, HIGHER, WIDER, LONGER, MISDEEDS } misdeed;

typedef struct {
    misdeed what;
    int lines;
} misdoer;

static batten_status misdo(void *user, int dimension, int count, const double *points,
                           const double *parameters, batten_curve **out)
{
    misdoer *m = user;
    double wide[3 * NU], weights[NU];
    batten_curve *line = NULL;
    (void)parameters;
    const bool bad = m->lines++ == 1 || m->what == RATIONAL;
    if (bad && m->what == RATIONAL) {
        for (int i = 0; i < count; i++)
            weights[i] = 1 + i;
        double knots[NU + 2];
        for (int i = 0; i < count + 2; i++)
            knots[i] = i == 0 ? 0 : i > count ? count - 1 : i - 1;
        return batten_curve_create((batten_points){dimension, count, points}, 1, weights, knots,
                                   out);
    }
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            wide[2 * i + k] = i + k;
    const batten_points all =
        bad && m->what == WIDER
            ? (batten_points){2, count, wide}
            : (batten_points){dimension, count - (bad && m->what == LONGER), points};
    const batten_status status =
        batten_curve_polyline(all, bad && m->what == HIGHER ? &line : out);
    if (status != BATTEN_OK || !line)
        return status;
    const batten_status raised = batten_curve_elevate(line, 1, out);
    batten_curve_unref(line);
    return raised;
}

static batten_status misdone(misdeed what, const double *points, batten_surface **out)
{
    misdoer m = {what, 0};
    const batten_line_method method = {misdo, &m, false};
    return batten_surface_tensor(
        (batten_grid){1, NU, NV, points}, (batten_uv){stations_u, stations_v},
        (const batten_line_method *const[2]){&method, &method}, NULL, NULL, out);
}

TEST(methods_whose_lines_differ_in_kind_are_refused)
{
    double points[NU * NV];
    for (int i = 0; i < NU * NV; i++)
        points[i] = i;
    for (int k = 0; k < MISDEEDS; k++) {
        batten_surface *surface = NULL;
        CHECK_STATUS(misdone((misdeed)k, points, &surface),
                     k == RATIONAL ? BATTEN_UNSUPPORTED : BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE(k == RATIONAL
                          ? "along u, line 1: the method gives rational curves"
                          : "along u, line 2: the curve has other knots than that of the "
                            "first line");
        CHECK(!surface);
    }
}
