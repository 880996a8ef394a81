/* Tracing the cuts of a lofting. */
#include "loft/cut.h"
#include "numeric/vector.h"
#include "spline/spline.h"

enum { P = BAT_LOFT_DEGREE, ACROSS = 161, HALVINGS = 52 };

/* ---- points over a grid ---- */

static void point_at(const bat_loft_patch *patch, double u, double v, double out[3])
{
    double a[BAT_LOFT_SUPPORT], b[BAT_LOFT_SUPPORT];
    const int p = BAT_LOFT_DEGREE;
    const int k = bat_knots_span(p, patch->nu, patch->u_knots, u, BATTEN_FROM_RIGHT);
    const int l = bat_knots_span(p, patch->nv, patch->v_knots, v, BATTEN_FROM_RIGHT);
    bat_basis(p, patch->u_knots, k, u, 0, a);
    bat_basis(p, patch->v_knots, l, v, 0, b);
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= p; j++) {
            const double *point = patch->points + 3 * ((size_t)(k - p + i) * (size_t)patch->nv +
                                                       (size_t)(l - p + j));
            for (int c = 0; c < 3; c++)
                out[c] += a[i] * b[j] * point[c];
        }
}

static void grid_point(const bat_loft_grid *grid, int i, double across, double out[3])
{
    const double along = grid->along[i];
    point_at(grid->patch, grid->along_v ? across : along, grid->along_v ? along : across, out);
}

static void grid_free(bat_loft_grid *grid)
{
    bat_release(grid->along);
    bat_release(grid->across);
    bat_release(grid->points);
    *grid = (bat_loft_grid){0};
}

static batten_status grid_make(const bat_loft_patch *patch, bool along_v, int along_count,
                               const double *along, bat_loft_grid *out)
{
    bat_loft_grid grid = {
        .patch = patch, .along_v = along_v, .along_count = along_count, .across_count = ACROSS};
    grid.along = bat_array((size_t)along_count, sizeof *grid.along);
    grid.across = bat_array(ACROSS, sizeof *grid.across);
    grid.points = bat_array3((size_t)along_count, ACROSS, 3 * sizeof *grid.points);
    if (!grid.along || !grid.across || !grid.points) {
        grid_free(&grid);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(grid.along, along, (size_t)along_count * sizeof *along);
    for (int k = 0; k < ACROSS; k++)
        grid.across[k] = (double)k / (ACROSS - 1);
    for (int i = 0; i < along_count; i++)
        for (int k = 0; k < ACROSS; k++)
            grid_point(&grid, i, grid.across[k],
                       grid.points + 3 * ((size_t)i * ACROSS + (size_t)k));
    *out = grid;
    return BATTEN_OK;
}

/* ---- cuts ---- */

static double beyond(const bat_loft_cut *cut, const double *point)
{
    return bat_dot(3, cut->m, point) - cut->at;
}

/* Where line i of the grid first crosses the plane; false when it does not. */
static bool find_crossing(const bat_loft_grid *grid, const bat_loft_cut *cut, int i,
                          double *across)
{
    const double *points = grid->points + 3 * (size_t)i * (size_t)grid->across_count;
    for (int k = 0; k + 1 < grid->across_count; k++) {
        double low = grid->across[k], high = grid->across[k + 1], point[3];
        const double first = beyond(cut, points + 3 * k),
                     last = beyond(cut, points + 3 * k + 3);
        if (first * last > 0)
            continue;
        for (int step = 0; step < HALVINGS; step++) {
            const double middle = (low + high) / 2;
            grid_point(grid, i, middle, point);
            if (beyond(cut, point) * first <= 0)
                high = middle;
            else
                low = middle;
        }
        *across = first == 0 ? grid->across[k] : (low + high) / 2;
        return true;
    }
    return false;
}

/* Coordinates in the plane, along two axes at right angles to m. */
static void lay_down(const double m[3], const double *point, double out[2])
{
    if (m[0] != 0) {
        out[0] = point[1];
        out[1] = point[2];
        return;
    }
    out[0] = point[0];
    out[1] = point[1] * m[2] - point[2] * m[1];
}

static void add_place(const bat_loft_grid *grid, const bat_loft_cut *cut, int i, double across,
                      bat_cut_trace *out)
{
    double point[3];
    const int k = out->count++;
    grid_point(grid, i, across, point);
    out->u[k] = grid->along_v ? across : grid->along[i];
    out->v[k] = grid->along_v ? grid->along[i] : across;
    lay_down(cut->m, point, out->plane + 2 * k);
}

static void find_section(const bat_loft_grid *grid, const bat_loft_cut *cut, bat_cut_trace *out)
{
    int first = 0, count = 0, run = 0;
    double across;
    for (int i = 0; i < grid->along_count; i++) {
        run = find_crossing(grid, cut, i, &across) ? run + 1 : 0;
        if (run > count) {
            count = run;
            first = i + 1 - run;
        }
    }
    out->count = 0;
    for (int i = first; i < first + count; i++)
        if (find_crossing(grid, cut, i, &across))
            add_place(grid, cut, i, across, out);
}

static void find_edge(const bat_loft_grid *grid, const bat_loft_cut *cut, bat_cut_trace *out)
{
    out->count = 0;
    for (int i = 0; i < grid->along_count; i++)
        add_place(grid, cut, i, cut->kind == BAT_CUT_SHEER ? 1 : 0, out);
}

void bat_cut_find(bat_cut_tracer *tracer, const bat_loft_cut *cut)
{
    if (bat_cut_is_edge(cut))
        find_edge(&tracer->along_u, cut, &tracer->trace);
    else
        find_section(cut->kind == BAT_CUT_STATION ? &tracer->along_v : &tracer->along_u, cut,
                     &tracer->trace);
}

/* ---- tracers ---- */

static int sample_spans(int count, const double *knots, int each, double *out)
{
    int found = 0;
    for (int span = P; span < count; span++)
        for (int k = 0; k < each && knots[span + 1] > knots[span]; k++)
            out[found++] = knots[span] + (knots[span + 1] - knots[span]) * k / each;
    out[found++] = 1;
    return found;
}

static int sample_evenly(int count, double *out)
{
    for (int k = 0; k < count; k++)
        out[k] = (double)k / (count - 1);
    return count;
}

void bat_cut_tracer_free(bat_cut_tracer *tracer)
{
    grid_free(&tracer->along_u);
    grid_free(&tracer->along_v);
    bat_release(tracer->trace.u);
    bat_release(tracer->trace.v);
    bat_release(tracer->trace.plane);
    *tracer = (bat_cut_tracer){0};
}

static batten_status make_grids(const bat_loft_patch *patch, int each, int even,
                                double *samples, bat_cut_tracer *t)
{
    int count = each ? sample_spans(patch->nu, patch->u_knots, each, samples)
                     : sample_evenly(even, samples);
    const batten_status status = grid_make(patch, false, count, samples, &t->along_u);
    if (status != BATTEN_OK)
        return status;
    if (each)
        count = sample_spans(patch->nv, patch->v_knots, each, samples);
    return grid_make(patch, true, count, samples, &t->along_v);
}

batten_status bat_cut_tracer_make(const bat_loft_patch *patch, int each, int even,
                                  bat_cut_tracer *out)
{
    bat_cut_tracer t = {0};
    const int most = bat_max_int(even, each * bat_max_int(patch->nu, patch->nv) + 1);
    double *samples = bat_array((size_t)most, sizeof *samples);
    t.trace.u = bat_array((size_t)most, sizeof *t.trace.u);
    t.trace.v = bat_array((size_t)most, sizeof *t.trace.v);
    t.trace.plane = bat_array((size_t)most, 2 * sizeof *t.trace.plane);
    batten_status status = samples && t.trace.u && t.trace.v && t.trace.plane
                               ? make_grids(patch, each, even, samples, &t)
                               : BATTEN_OUT_OF_MEMORY;
    bat_release(samples);
    if (status == BATTEN_OK)
        *out = t;
    else
        bat_cut_tracer_free(&t);
    return status;
}
