/* The map of space by a lattice of control points: its making, and what it refuses. */
#include "shape/deform/lattice.h"
#include "base/plural.h"
#include "numeric/box.h"
#include "numeric/vector.h"
#include "spline/spline.h"

#include <float.h>
#include <string.h>

enum { MOST_POINTS = 1000000, MOST_PARTS = 4096 };

/* A lattice point meant to stay at home comes there by a few roundings of its coordinates. */
static const double at_home = 64 * DBL_EPSILON;
/* What lies on a side of the box, but for the rounding of a chain of operations, does not leave it. */
static const double on_side = 1e-9;

batten_deformation_options batten_deformation_defaults(void)
{
    return (batten_deformation_options){.size = sizeof(batten_deformation_options),
                                        .most_parts = MOST_PARTS};
}

/* ---- the lattice at rest ---- */

static void split_box(batten_box box, double low[3], double high[3])
{
    memcpy(low, (const double[]){box.low.x, box.low.y, box.low.z}, 3 * sizeof *low);
    memcpy(high, (const double[]){box.high.x, box.high.y, box.high.z}, 3 * sizeof *high);
}

static batten_status check_lattice(const batten_lattice *l)
{
    double low[3], high[3], points = 1;
    split_box(l->box, low, high);
    for (int k = 0; k < 3; k++) {
        const double extent = high[k] - low[k];
        if (!isfinite(low[k]) || !isfinite(high[k]) || !isfinite(extent))
            return bat_fail(BATTEN_NOT_FINITE, "the box runs from %g to %g in %c", low[k],
                            high[k], 'x' + k);
        /* Coordinates in the box have six digits left at least. */
        if (!(extent > 1e-9 * bat_max(fabs(low[k]), fabs(high[k]))))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the box runs from %g to %g in %c; it needs some extent there",
                            low[k], high[k], 'x' + k);
        if (l->counts[k] < 2)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the lattice has %d point%s in %c, at least 2 are needed",
                            l->counts[k], bat_plural(l->counts[k]), 'x' + k);
        if (l->degrees[k] < 1 || l->degrees[k] >= l->counts[k] ||
            l->degrees[k] > BAT_LATTICE_MOST_DEGREE)
            return bat_fail(BATTEN_BAD_DEGREE,
                            "degree %d for %d lattice points in %c; 1 to %d is possible",
                            l->degrees[k], l->counts[k], 'x' + k,
                            bat_min_int(l->counts[k] - 1, BAT_LATTICE_MOST_DEGREE));
        points *= l->counts[k];
    }
    if (points > MOST_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%g lattice points, more than %d", points,
                        MOST_POINTS);
    return BATTEN_OK;
}

/* Knot i of evenly spaced clamped ones over [0, 1]. */
static double even_knot(int degree, int count, int i)
{
    const int spans = count - degree;
    return (double)bat_min_int(bat_max_int(i - degree, 0), spans) / spans;
}

static double greville_abscissa(int degree, int count, int i)
{
    double knots[BAT_LATTICE_MOST_DEGREE + 1];
    for (int k = 1; k <= degree; k++)
        knots[k] = even_knot(degree, count, i + k);
    return bat_greville(degree, knots, 0);
}

batten_status batten_lattice_home(const batten_lattice *lattice, double *points)
{
    assert(lattice && points);
    double low[3], high[3];
    const batten_status status = check_lattice(lattice);
    if (status != BATTEN_OK)
        return status;
    split_box(lattice->box, low, high);
    const int *n = lattice->counts;
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++)
            for (int k = 0; k < n[2]; k++) {
                const int index[3] = {i, j, k};
                double *p = points + 3 * bat_lattice_index(lattice, i, j, k);
                for (int c = 0; c < 3; c++) {
                    const double s = greville_abscissa(lattice->degrees[c], n[c], index[c]);
                    p[c] = (1 - s) * low[c] + s * high[c];
                }
            }
    return BATTEN_OK;
}

/* ---- the map ---- */

static batten_status make_axes(batten_deformation *d)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 3 && status == BATTEN_OK; k++) {
        const int p = d->lattice.degrees[k], n = d->lattice.counts[k];
        status = bat_axis_make(p, n, false, &d->axes[k]);
        for (int i = 0; status == BATTEN_OK && i <= n + p; i++)
            d->axes[k].knots[i] = even_knot(p, n, i);
        if (status == BATTEN_OK)
            status = bat_axis_finish(&d->axes[k]);
    }
    return status;
}

/* How far every lattice point is from home. */
static batten_status find_moves(batten_deformation *d, const double *points)
{
    const int *n = d->lattice.counts;
    const size_t count = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    d->moves = bat_array(count, 3 * sizeof *d->moves);
    if (!d->moves)
        return BATTEN_OUT_OF_MEMORY;
    const size_t bad = bat_first_not_finite(points, 3 * count);
    if (bad < 3 * count)
        return bat_fail(BATTEN_NOT_FINITE, "lattice point %d has a coordinate %g",
                        (int)(bad / 3) + 1, points[bad]);
    const batten_status status = batten_lattice_home(&d->lattice, d->moves);
    for (size_t i = 0; i < count && status == BATTEN_OK; i++) {
        double *move = d->moves + 3 * i;
        for (int c = 0; c < 3; c++) {
            const double size = bat_max(fabs(points[3 * i + (size_t)c]), fabs(move[c]));
            const double by = points[3 * i + (size_t)c] - move[c];
            d->size = bat_max(d->size, size);
            move[c] = fabs(by) <= at_home * bat_max(size, d->extent[c]) ? 0 : by;
        }
        d->report.moved = bat_max(d->report.moved, bat_norm(3, move));
    }
    return status;
}

static batten_status fill_deformation(batten_deformation *d, const double *points,
                                      const batten_deformation_options *options)
{
    double high[3];
    split_box(d->lattice.box, d->low, high);
    for (int k = 0; k < 3; k++) {
        d->extent[k] = high[k] - d->low[k];
        d->size = bat_max(d->size, bat_max(fabs(d->low[k]), fabs(high[k])));
    }
    d->join = options->join;
    batten_status status = make_axes(d);
    if (status == BATTEN_OK)
        status = find_moves(d, points);
    if (status == BATTEN_OK && !isfinite(d->report.moved))
        status = bat_fail(BATTEN_OVERFLOW, "a lattice point moves by more than a number holds");
    return status == BATTEN_OK ? bat_deformation_find_folds(d, options->most_parts) : status;
}

batten_status batten_deformation_create(const batten_lattice *lattice, const double *points,
                                        const batten_deformation_options *options,
                                        batten_deformation_report *report,
                                        batten_deformation **out)
{
    assert(lattice && points && out);
    batten_deformation_options chosen = batten_deformation_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_deformation_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_lattice(lattice);
    if (status == BATTEN_OK && (unsigned)chosen.join >= BATTEN_BOX_JOIN_COUNT)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there is no join %d of what is outside",
                          (int)chosen.join);
    if (status == BATTEN_OK && chosen.most_parts < 1)
        status =
            bat_fail(BATTEN_BAD_ARGUMENT, "at most %d parts are asked for", chosen.most_parts);
    if (status != BATTEN_OK)
        return status;
    batten_deformation *d = bat_array(1, sizeof *d);
    if (!d)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&d->references);
    d->lattice = *lattice;
    status = fill_deformation(d, points, &chosen);
    if (status != BATTEN_OK) {
        batten_deformation_unref(d);
        return status;
    }
    if (report)
        *report = d->report;
    *out = d;
    return BATTEN_OK;
}

batten_deformation *batten_deformation_ref(const batten_deformation *deformation)
{
    batten_deformation *shared = (batten_deformation *)(uintptr_t)deformation;
    bat_references_add(&shared->references);
    return shared;
}

void batten_deformation_unref(batten_deformation *deformation)
{
    if (!deformation || !bat_references_drop(&deformation->references))
        return;
    for (int k = 0; k < 3; k++)
        bat_axis_free(&deformation->axes[k]);
    bat_release(deformation->moves);
    bat_release(deformation);
}

/* ---- what is refused ---- */

static batten_status check_folds(const batten_deformation_report *r)
{
    if (r->folding != BATTEN_FOLDS)
        return BATTEN_OK;
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "the deformation folds: near (%.4g, %.4g, %.4g) of its box volumes are "
                    "multiplied by %.3g; move the lattice points less far past each other",
                    r->at[0], r->at[1], r->at[2], r->least);
}

/* Do the lattice points of one layer stay? */
static bool layer_stays(const batten_deformation *d, int axis, int layer)
{
    const int *n = d->lattice.counts;
    int index[3];
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    index[axis] = layer;
    for (index[a] = 0; index[a] < n[a]; index[a]++)
        for (index[b] = 0; index[b] < n[b]; index[b]++) {
            const double *move =
                d->moves + 3 * bat_lattice_index(&d->lattice, index[0], index[1], index[2]);
            if (move[0] != 0 || move[1] != 0 || move[2] != 0)
                return false;
        }
    return true;
}

/* Through the side of an axis something leaves the box. */
static batten_status check_layers(const batten_deformation *d, int axis, bool last,
                                  const char *what)
{
    const int n = d->lattice.counts[axis];
    for (int k = 0; k < (int)d->join && k < n; k++) {
        const int layer = last ? n - 1 - k : k;
        if (!layer_stays(d, axis, layer))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "%s leaves the box where %c is %s, and layer %d of the lattice "
                            "there is moved: %d layer%s must stay, or make the box larger",
                            what, 'x' + axis, last ? "largest" : "least", layer + 1,
                            (int)d->join, bat_plural((int)d->join));
    }
    return BATTEN_OK;
}

batten_status bat_deformation_check(const batten_deformation *d, batten_box shape,
                                    const char *what)
{
    double low[3], high[3];
    split_box(shape, low, high);
    batten_status status = check_folds(&d->report);
    for (int k = 0; k < 3 && status == BATTEN_OK; k++) {
        const double near = on_side * bat_max(d->extent[k], fabs(d->low[k]));
        const double ends[2] = {d->low[k] - low[k], high[k] - (d->low[k] + d->extent[k])};
        for (int e = 0; e < 2 && status == BATTEN_OK; e++) {
            if (!(ends[e] > near))
                continue;
            if (d->join == BATTEN_BOX_JOIN_NONE)
                return bat_fail(BATTEN_OUT_OF_DOMAIN,
                                "%s reaches %.4g out of the box where %c is %s: make the box "
                                "larger, or ask for continuity there",
                                what, ends[e], 'x' + k, e ? "largest" : "least");
            status = check_layers(d, k, e == 1, what);
        }
    }
    return status;
}
