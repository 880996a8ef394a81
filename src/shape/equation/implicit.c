/* The whole of an implicit curve in a box. */
#include "shape/equation/branches.h"
#include "shape/equation/pieces.h"

#include "base/list.h"
#include "numeric/rounding.h"

/* The share of the tolerance by which the box grows: less than half of it, and no round number, so that curves of
 * round numbers do not touch the box. */
#define GROWTH 0.38196601125

/* How many boxes may be examined, unless the job says. */
#define MOST_BOXES 150000

/* ---- singular clusters ---- */

/* Take the cells of clusters that are wider than the tolerance out of the undecided, for further division. */
static batten_status take_wide(bat_cells *cells, const bat_clusters *clusters, double tolerance,
                               bat_cell_list *out)
{
    batten_status status = BATTEN_OK;
    size_t kept = 0;
    for (size_t i = 0; i < cells->undecided.count && status == BATTEN_OK; i++) {
        const bat_cell cell = cells->undecided.items[i];
        if (clusters->items[clusters->of[i]].extent <= tolerance)
            cells->undecided.items[kept++] = cell;
        else
            status = BAT_LIST_ADD(out->items, out->count, out->room, cell);
    }
    cells->undecided.count = kept;
    return status;
}

static double rounding_of(const bat_cells *cells)
{
    double size = 0;
    for (int k = 0; k < cells->system->dimension; k++)
        size = bat_max(size, bat_interval_size(cells->whole.at[k]));
    return 64 * DBL_EPSILON * size;
}

/* Divide the box, then clusters again while they are wider than the tolerance. */
static batten_status divide_box(bat_cells *cells, double tolerance, bat_clusters *clusters)
{
    bat_cell_list list = {NULL, 0, 0};
    double least = tolerance / 4;
    batten_status status = BAT_LIST_ADD(list.items, list.count, list.room, cells->whole);
    while (status == BATTEN_OK && list.count > 0) {
        status = bat_cells_divide(cells, &list, least);
        bat_clusters_release(clusters);
        least /= 4;
        if (status != BATTEN_OK || cells->examined > cells->most)
            break;
        status = bat_clusters_gather(cells, clusters);
        if (status == BATTEN_OK && least > rounding_of(cells))
            status = take_wide(cells, clusters, tolerance, &list);
    }
    bat_release(list.items);
    return status;
}

/* ---- the result ---- */

static batten_box box_of(const bat_system *s, const bat_cell *cell)
{
    double low[BAT_SPACE] = {0, 0, 0}, high[BAT_SPACE] = {0, 0, 0};
    for (int k = 0; k < s->dimension; k++) {
        low[k] = cell->at[k].lo;
        high[k] = cell->at[k].hi;
    }
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/* List what is in clusters wider than the tolerance, or in none. */
static batten_status list_undecided(const bat_cells *cells, const bat_clusters *clusters,
                                    double tolerance, batten_equation_curves *out)
{
    int room = 0;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < cells->undecided.count && status == BATTEN_OK; i++) {
        const bat_cell *cell = &cells->undecided.items[i];
        if (clusters->of && clusters->items[clusters->of[i]].extent <= tolerance)
            continue;
        status = BAT_LIST_ADD(out->undecided, out->undecided_count, room,
                              box_of(cells->system, cell));
    }
    for (int i = 0; i < clusters->count && status == BATTEN_OK; i++)
        if (clusters->items[i].extent <= tolerance)
            out->error = bat_max(out->error, clusters->items[i].extent);
    return status;
}

/* Neighbouring lines that stand for a corner are one. */
static batten_status add_corners(const bat_segments *branch, batten_equation_curves *out)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < branch->count && status == BATTEN_OK; i++) {
        const bat_segment *s = &branch->items[i];
        if (s->has_corner && !(i > 0 && s[-1].has_corner))
            status = bat_equation_add_point(
                out, (batten_equation_point){
                         BATTEN_EQUATION_CORNER, {s->to[0], s->to[1], s->to[2]}, 0, 2});
    }
    return status;
}

static batten_status add_branches(bat_system *system, bat_branches *branches, double tolerance,
                                  batten_equation_curves *out)
{
    bat_segments segments = {NULL, 0, 0};
    batten_status status = bat_branches_next(branches, &segments);
    while (status == BATTEN_OK && segments.count > 0) {
        batten_curve *curve = NULL;
        if (out->undecided_count > 0 && bat_segments_extent(system, &segments) <= tolerance) {
            /* A crumb among undecided boxes. */
            status = bat_branches_next(branches, &segments);
            continue;
        }
        status = bat_segments_fit(system, tolerance, &segments, &out->error);
        if (status == BATTEN_OK)
            status = add_corners(&segments, out);
        if (status == BATTEN_OK)
            status = bat_segments_curve(system->dimension, &segments, &curve);
        if (status == BATTEN_OK)
            status = bat_equation_add_curve(out, curve);
        if (status != BATTEN_OK)
            batten_curve_unref(curve);
        else
            status = bat_branches_next(branches, &segments);
    }
    bat_release(segments.items);
    return status;
}

static batten_status say_undecided(bat_cells *cells, const batten_equation_curves *out,
                                   int loose)
{
    const bat_cell *cell = cells->undecided.count ? cells->undecided.items : &cells->whole;
    bat_enclosure e;
    const batten_vec3 at = box_of(cells->system, cell).low;
    bat_system_over(cells->system, cell, &e);
    const bool has_value = bat_interval_is_finite(e.slope[0][0]) &&
                           bat_interval_is_finite(e.slope[cells->system->equations - 1][0]);
    return bat_fail(
        BATTEN_INCOMPLETE,
        "%d boxes are undecided after %d were examined, the first at (%.6g, %.6g, %.6g), where %s; "
        "%d branches end there",
        out->undecided_count, out->boxes, at.x, at.y, at.z,
        has_value ? "the derivatives vanish along a line (a square?) or branches touch"
                  : "there is a pole, a corner or no value",
        loose);
}

static batten_status trace_box(bat_cells *cells, double tolerance, batten_equation_curves *out)
{
    bat_clusters clusters = {NULL, 0, NULL};
    bat_branches branches = {0};
    batten_status status = divide_box(cells, tolerance, &clusters);
    if (status == BATTEN_OK)
        status = list_undecided(cells, &clusters, tolerance, out);
    if (status == BATTEN_OK)
        status = bat_branches_link(&branches, cells, &clusters, tolerance, out);
    if (status == BATTEN_OK)
        status = add_branches(cells->system, &branches, tolerance, out);
    out->boxes = (int)cells->examined;
    if (status == BATTEN_OK && (out->undecided_count > 0 || branches.loose > 0)) {
        status = say_undecided(cells, out, branches.loose);
    }
    bat_branches_release(&branches);
    bat_clusters_release(&clusters);
    return status;
}

/* ---- the call ---- */

static batten_status check_implicit(int count, const batten_equation *const *equations,
                                    const double low[3], const double high[3], double tolerance)
{
    if (count < 1 || count > BAT_EQUATIONS)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d equations; a curve has one in the plane and two in space", count);
    for (int i = 0; i < count; i++)
        if (equations[i]->variable_count != count + 1)
            return bat_fail(BATTEN_BAD_ARGUMENT, "equation %d has %d variables, expected %d",
                            i + 1, equations[i]->variable_count, count + 1);
    double size = 0;
    for (int k = 0; k <= count; k++) {
        if (!isfinite(low[k]) || !isfinite(high[k]))
            return bat_fail(BATTEN_NOT_FINITE, "the box is not finite");
        if (!(low[k] < high[k]))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the box is empty along %c: %g to %g",
                            "xyz"[k], low[k], high[k]);
        size = bat_max(size, bat_max(fabs(low[k]), fabs(high[k])));
    }
    if (!(tolerance > 0) || !isfinite(tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance must be above 0, not %g",
                        tolerance);
    if (tolerance < BAT_ROUNDING * size)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "a tolerance of %g is below %g of the coordinates of the box, %g",
                        tolerance, BAT_ROUNDING, size);
    return BATTEN_OK;
}

batten_status batten_curves_implicit(int equation_count,
                                     const batten_equation *const *equations,
                                     const batten_box *box, double tolerance,
                                     const batten_job *job, batten_equation_curves *out)
{
    const double low[3] = {box->low.x, box->low.y, box->low.z};
    const double high[3] = {box->high.x, box->high.y, box->high.z};
    batten_status status = check_implicit(equation_count, equations, low, high, tolerance);
    if (status != BATTEN_OK)
        return status;
    bat_system system;
    batten_equation_curves made = {0};
    bat_system_begin(&system, equation_count, equations);
    bat_cells cells = {.system = &system, .most = MOST_BOXES, .work = {.job = job}};
    for (int k = 0; k < system.dimension; k++)
        cells.whole.at[k] =
            (bat_interval){low[k] - GROWTH * tolerance, high[k] + GROWTH * tolerance};
    status = trace_box(&cells, tolerance, &made);
    if (status == BATTEN_OK || status == BATTEN_INCOMPLETE)
        *out = made;
    else
        batten_equation_curves_release(&made);
    bat_cells_release(&cells);
    return status;
}
