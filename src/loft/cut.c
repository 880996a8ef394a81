/* Tracing the cuts of a lofting. */
#include "loft/cut.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <float.h>

enum { P = BAT_LOFT_DEGREE, ACROSS = 161 };

/* ---- points over a grid ---- */

/* The functions at t: the first that counts, and the four values. */
static int basis_at(int count, const double *knots, double t, double values[BAT_LOFT_SUPPORT])
{
    const int span = bat_knots_span(P, count, knots, t, BATTEN_FROM_RIGHT);
    bat_basis(P, knots, span, t, 0, values);
    return span - P;
}

/* A point of line i from the functions across it. */
static void evaluate_row(const bat_loft_grid *grid, int i, int first,
                         const double values[BAT_LOFT_SUPPORT], double out[3])
{
    const double *row = grid->rows + 3 * ((size_t)i * (size_t)grid->row_count + (size_t)first);
    for (int c = 0; c < 3; c++)
        out[c] = values[0] * row[c] + values[1] * row[3 + c] + values[2] * row[6 + c] +
                 values[3] * row[9 + c];
}

static void grid_point(const bat_loft_grid *grid, int i, double across, double out[3])
{
    const bat_loft_patch *patch = grid->patch;
    double values[BAT_LOFT_SUPPORT];
    const int first = basis_at(grid->row_count, grid->along_v ? patch->u_knots : patch->v_knots,
                               across, values);
    evaluate_row(grid, i, first, values, out);
}

/* The control points of the curve across, at each place along. */
static void make_rows(bat_loft_grid *grid)
{
    const bat_loft_patch *patch = grid->patch;
    const int count = grid->along_v ? patch->nv : patch->nu;
    const size_t step = grid->along_v ? 3 : 3 * (size_t)patch->nv,
                 other = 3 * (size_t)patch->nv + 3 - step;
    for (int i = 0; i < grid->along_count; i++) {
        double values[BAT_LOFT_SUPPORT];
        const int first = basis_at(count, grid->along_v ? patch->v_knots : patch->u_knots,
                                   grid->along[i], values);
        double *row = grid->rows + 3 * (size_t)i * (size_t)grid->row_count;
        for (int j = 0; j < 3 * grid->row_count; j++) {
            const double *point =
                patch->points + (size_t)first * step + (size_t)(j / 3) * other + j % 3;
            row[j] = values[0] * point[0] + values[1] * point[step] +
                     values[2] * point[2 * step] + values[3] * point[3 * step];
        }
    }
}

/* Points at even places across. */
static void make_points(bat_loft_grid *grid)
{
    const bat_loft_patch *patch = grid->patch;
    for (int k = 0; k < ACROSS; k++) {
        double values[BAT_LOFT_SUPPORT];
        grid->across[k] = (double)k / (ACROSS - 1);
        const int first =
            basis_at(grid->row_count, grid->along_v ? patch->u_knots : patch->v_knots,
                     grid->across[k], values);
        for (int i = 0; i < grid->along_count; i++)
            evaluate_row(grid, i, first, values,
                         grid->points + 3 * ((size_t)i * ACROSS + (size_t)k));
    }
}

static void grid_free(bat_loft_grid *grid)
{
    bat_release(grid->along);
    bat_release(grid->across);
    bat_release(grid->points);
    bat_release(grid->rows);
    *grid = (bat_loft_grid){0};
}

static batten_status grid_make(const bat_loft_patch *patch, bool along_v, int along_count,
                               const double *along, bat_loft_grid *out)
{
    bat_loft_grid grid = {.patch = patch,
                          .along_v = along_v,
                          .along_count = along_count,
                          .across_count = ACROSS,
                          .row_count = along_v ? patch->nu : patch->nv};
    grid.along = bat_array((size_t)along_count, sizeof *grid.along);
    grid.across = bat_array(ACROSS, sizeof *grid.across);
    grid.points = bat_array3((size_t)along_count, ACROSS, 3 * sizeof *grid.points);
    grid.rows = bat_array3((size_t)along_count, (size_t)grid.row_count, 3 * sizeof *grid.rows);
    if (!grid.along || !grid.across || !grid.points || !grid.rows) {
        grid_free(&grid);
        return BATTEN_OUT_OF_MEMORY;
    }
    memcpy(grid.along, along, (size_t)along_count * sizeof *along);
    make_rows(&grid);
    make_points(&grid);
    *out = grid;
    return BATTEN_OK;
}

/* ---- cuts ---- */

static double beyond(const bat_loft_cut *cut, const double *point)
{
    return bat_dot(3, cut->m, point) - cut->at;
}

/* Where line i of the grid meets the plane between two places on either side of it, `low` with the
 * distance `below`: false position, an end that stays counting half (the Illinois rule). */
static double meet_between(const bat_loft_grid *grid, const bat_loft_cut *cut, int i,
                           const double ends[2], const double distances[2])
{
    enum { STEPS = 60 }; /* some 7 do */
    double low = ends[0], high = ends[1], below = distances[0], above = distances[1];
    double at = -1, before = 2; /* outside of both */
    for (int step = 0; step < STEPS && fabs(at - before) > DBL_EPSILON; step++) {
        double point[3];
        before = at;
        at = bat_min(bat_max(low + (high - low) * (below / (below - above)), low), high);
        grid_point(grid, i, at, point);
        const double here = beyond(cut, point);
        if (here == 0)
            break;
        if ((here > 0) == (below > 0)) {
            above /= low == before ? 2 : 1;
            low = at;
            below = here;
        } else {
            below /= high == before ? 2 : 1;
            high = at;
            above = here;
        }
    }
    return at;
}

/* Where line i of the grid first crosses the plane; false when it does not. */
static bool find_crossing(const bat_loft_grid *grid, const bat_loft_cut *cut, int i,
                          double *across)
{
    const double *points = grid->points + 3 * (size_t)i * (size_t)grid->across_count;
    double distances[2] = {0, beyond(cut, points)};
    for (int k = 0; k + 1 < grid->across_count; k++) {
        distances[0] = distances[1];
        distances[1] = beyond(cut, points + 3 * k + 3);
        if (distances[0] * distances[1] > 0)
            continue;
        *across = distances[0] == 0 ? grid->across[k]
                                    : meet_between(grid, cut, i, grid->across + k, distances);
        return true;
    }
    return false;
}

/* Coordinates in the plane, along two axes at right angles to m: one lies in the plane of y and z. */
static void lay_down(const double m[3], const double *point, double out[2])
{
    const double across = bat_hypot(m[1], m[2]);
    if (across == 0) {
        out[0] = point[1];
        out[1] = point[2];
        return;
    }
    const double a[3] = {0, m[2] / across, -m[1] / across};
    const double b[3] = {across, -m[0] * m[1] / across, -m[0] * m[2] / across};
    out[0] = bat_dot(3, b, point);
    out[1] = bat_dot(3, a, point);
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

/* The longest run of lines that cross the plane. Where they do stands meanwhile in `plane`, which a
 * trace fills no faster than these are taken from it. */
static void find_section(const bat_loft_grid *grid, const bat_loft_cut *cut, bat_cut_trace *out)
{
    int first = 0, count = 0, run = 0;
    for (int i = 0; i < grid->along_count; i++) {
        run = find_crossing(grid, cut, i, out->plane + 2 * i) ? run + 1 : 0;
        if (run > count) {
            count = run;
            first = i + 1 - run;
        }
    }
    out->count = 0;
    for (int i = first; i < first + count; i++)
        add_place(grid, cut, i, out->plane[2 * i], out);
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
