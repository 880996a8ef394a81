/* Where a face needs points: cells of (u, v) in a plane in which they are about square. */
#include "mesh/faces/lattice.h"

#include <string.h>

/* ---- places in the plane ---- */

/* The index of the break before the value; the last but one at most. */
static int interval_of(const double *breaks, int count, double value)
{
    int low = 0, high = count - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (breaks[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static double between(const double *from, const double *to, int i, double value)
{
    const double part = (value - from[i]) / (from[i + 1] - from[i]);
    return part == 1 ? to[i + 1] : to[i] + part * (to[i + 1] - to[i]);
}

int bat_lattice_break(const bat_lattice_axis *axis, double x)
{
    const int i = interval_of(axis->x, axis->count, x);
    return axis->x[i] >= x ? i : axis->x[i + 1] >= x ? i + 1 : axis->count;
}

double bat_lattice_to_plane(const bat_lattice_axis *axis, double u)
{
    return between(axis->u, axis->x, interval_of(axis->u, axis->count, u), u);
}

double bat_lattice_from_plane(const bat_lattice_axis *axis, double x)
{
    return between(axis->x, axis->u, interval_of(axis->x, axis->count, x), x);
}

/* ---- creases ---- */

/* Can a line between spans be a crease at all? Knots below full multiplicity are smooth. */
static bool may_crease(const bat_sheet *sheet, int d, double at)
{
    const batten_direction direction = (batten_direction)d;
    if (strcmp(batten_surface_kind(sheet->surface), "nurbs") != 0)
        return true;
    const double *knots = batten_surface_knots(sheet->surface, direction);
    const int count = batten_surface_knot_count(sheet->surface, direction);
    int i = interval_of(knots, count, at), times = 0;
    for (; i >= 0 && knots[i] == at; i--)
        times++;
    return times >= batten_surface_degree(sheet->surface, direction);
}

/* The creases within the domain, at the front of `lines`. */
static batten_status find_creases(const bat_sheet *sheet, int d, double *lines, int *count)
{
    const int spans = batten_surface_spans(sheet->surface, (batten_direction)d, lines);
    batten_status status = BATTEN_OK;
    *count = 0;
    for (int i = 1; status == BATTEN_OK && i + 1 < spans; i++) {
        bool found = false;
        if (may_crease(sheet, d, lines[i]))
            status = bat_sheet_is_crease(sheet, d, lines[i], &found);
        if (found)
            lines[(*count)++] = lines[i];
    }
    return status;
}

/* Breaks: the ends of the box, and creases and seams within, a whole period more or less. */
static batten_status find_breaks(const bat_sheet *sheet, int d, batten_interval box,
                                 bat_lattice_axis *axis)
{
    const batten_interval domain = sheet->domain[d];
    /* A line so near to an end of the box is that end but for rounding. */
    const double period = domain.b - domain.a, close = 1e-9 * (box.b - box.a);
    int found = 0;
    const int spans = batten_surface_spans(sheet->surface, (batten_direction)d, NULL);
    double *lines = bat_array((size_t)spans, sizeof *lines);
    axis->u = bat_array(3 * (size_t)spans + 8, sizeof *axis->u);
    batten_status status = lines && axis->u ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_creases(sheet, d, lines, &found);
    if (status == BATTEN_OK) {
        axis->u[axis->count++] = box.a;
        for (int turn = -1; turn <= 1; turn++) {
            if (turn != 0 && !sheet->closed[d])
                continue;
            for (int i = -1; i < found; i++) {
                const double at = (i < 0 ? domain.a : lines[i]) + turn * period;
                if (at > axis->u[axis->count - 1] + close && at < box.b - close)
                    axis->u[axis->count++] = at;
            }
        }
        axis->u[axis->count++] = box.b;
        axis->x = bat_array((size_t)axis->count, sizeof *axis->x);
        axis->cells = bat_array((size_t)axis->count, sizeof *axis->cells);
        status = axis->x && axis->cells ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(lines);
    return status;
}

/* ---- how many cells, and how large in the plane ---- */

enum { MOST_SAMPLES = 48 };

/* Where a direction is sampled. */
typedef struct {
    int count;
    double at[MOST_SAMPLES], weight[MOST_SAMPLES]; /* the weights add up to the whole length */
    int interval[MOST_SAMPLES];
} samples;

static void choose_samples(const bat_lattice_axis *axis, samples *s)
{
    static const double places[5] = {0.06, 0.28, 0.5, 0.72, 0.94};
    const int intervals = axis->count - 1;
    const int each = intervals <= 9 ? 5 : 1;
    const int taken = bat_min_int(intervals, each == 1 ? MOST_SAMPLES : intervals);
    s->count = 0;
    double sum = 0;
    for (int k = 0; k < taken; k++) {
        const int i = (int)((double)k * intervals / taken);
        const double length = axis->u[i + 1] - axis->u[i];
        for (int j = 0; j < each; j++) {
            s->interval[s->count] = i;
            s->at[s->count] = axis->u[i] + places[each == 1 ? 2 : j] * length;
            s->weight[s->count++] = length / each;
        }
        sum += length;
    }
    for (int k = 0; k < s->count; k++)
        s->weight[k] *= (axis->u[intervals] - axis->u[0]) / sum;
}

/* The steps allowed, not beyond the intervals given. */
static void allowed_steps(const bat_meshing *m, const bat_lattice_bounds *b,
                          const double interval[2], double step[2])
{
    const double bend[2] = {b->bend[0], b->bend[2]};
    double rise[2], angle[2];
    for (int d = 0; d < 2; d++) {
        rise[d] = bend[d] * interval[d] * interval[d];
        angle[d] = b->turn[d] * interval[d];
    }
    for (int d = 0; d < 2; d++) { /* bending both ways shares the bound */
        const double share = rise[1 - d] > 0.05 * rise[d] ? 4 : 8;
        const double part = angle[1 - d] > 0.05 * angle[d] ? 0.7 : 1;
        step[d] = interval[d];
        if (bend[d] * interval[d] * interval[d] > share * m->fine)
            step[d] = sqrt(share * m->fine / bend[d]);
        if (b->turn[d] * step[d] > part * m->angle)
            step[d] = part * m->angle / b->turn[d];
        if (b->length[d] * step[d] > 0.7 * m->longest)
            step[d] = 0.7 * m->longest / b->length[d];
    }
    for (int d = 0; d < 2; d++) { /* triangles that are thin must not tilt */
        const double rises = bat_lattice_tilt(m) * b->length[1 - d] * step[1 - d];
        if (bend[d] * step[d] * step[d] > 8 * rises && rises > 0)
            step[d] = sqrt(8 * rises / bend[d]);
    }
}

typedef struct {
    double *need[2];   /* [intervals] cells */
    double *mean[2];   /* [intervals] of the cells that samples need, their sum */
    double *length[2]; /* [intervals] of the lines, the mean over samples */
    double *weight[2]; /* [intervals] of samples so far */
} needs;

static batten_status measure_needs(bat_lattice *l, const bat_meshing *m, const samples s[2],
                                   needs *n)
{
    double d[18], uv[2], step[2], interval[2];
    for (int i = 0; i < s[0].count; i++)
        for (int j = 0; j < s[1].count; j++) {
            const int at[2] = {i, j};
            int cell[2];
            for (int k = 0; k < 2; k++) {
                const bat_lattice_axis *axis = &l->axis[k];
                uv[k] = s[k].at[at[k]];
                cell[k] = s[k].interval[at[k]];
                interval[k] = axis->u[cell[k] + 1] - axis->u[cell[k]];
            }
            bat_sheet_wrap(l->sheet, uv);
            const batten_status status =
                batten_surface_evaluate(l->sheet->surface, uv[0], uv[1], 2, d);
            if (status != BATTEN_OK)
                return status;
            bat_lattice_bounds bounds;
            bat_lattice_bound(d, &bounds);
            allowed_steps(m, &bounds, interval, step);
            l->predicted += 2 * (s[0].weight[i] / step[0]) * (s[1].weight[j] / step[1]);
            for (int k = 0; k < 2; k++) {
                const double w = s[1 - k].weight[at[1 - k]];
                n->need[k][cell[k]] = bat_max(n->need[k][cell[k]], interval[k] / step[k]);
                n->mean[k][cell[k]] += w * interval[k] / step[k];
                n->length[k][cell[k]] += w * bounds.length[k] * interval[k];
                n->weight[k][cell[k]] += w;
            }
        }
    return BATTEN_OK;
}

/* Root cells, so that halving them comes near to the cells needed. */
static int root_cells(double need)
{
    const double whole = ceil(need - 1e-9);
    if (whole <= 8)
        return bat_max_int(1, (int)whole);
    const int halvings = ilogb(need) - 2; /* need / 2^halvings is in [4, 8) */
    return (int)ceil(ldexp(need, -halvings) - 1e-9);
}

static bool any_needed(const bat_lattice *l, const needs *n)
{
    for (int k = 0; k < 2; k++)
        for (int i = 0; i + 1 < l->axis[k].count; i++)
            if (n->need[k][i] > 1)
                return true;
    return false;
}

/* In the plane the cells that are needed are about square, however long they are: so triangles
 * between them are as long as the surface allows. Where none are needed the lengths are the
 * true ones. Widths are powers of two: then the lines of all cells are at places where circles
 * through corners of cells are decided without much ado. */
static void lay_out(const bat_lattice *l, int k, const needs *n, bool bends, double least)
{
    const bat_lattice_axis *axis = &l->axis[k];
    const double period = l->sheet->domain[k].b - l->sheet->domain[k].a;
    const bool all_around =
        l->sheet->closed[k] && axis->u[axis->count - 1] - axis->u[0] > 0.99 * period;
    for (int i = 0; i + 1 < axis->count; i++) {
        const double length = n->weight[k][i] > 0 ? n->length[k][i] / n->weight[k][i] : 0;
        axis->cells[i] = root_cells(n->need[k][i]);
        if (all_around && axis->count < 4)
            axis->cells[i] = bat_max_int(axis->cells[i], 4 - (axis->count - 1));
        const double mean = n->weight[k][i] > 0 ? n->mean[k][i] / n->weight[k][i] : 1;
        const double width = (bends ? mean : bat_max(length, least)) / axis->cells[i];
        axis->x[i + 1] = axis->x[i] + axis->cells[i] * ldexp(1, ilogb(width * 1.4142));
    }
}

/* Both directions together below 1. */
static void scale_plane(bat_lattice *l)
{
    const double x = l->axis[0].x[l->axis[0].count - 1], y = l->axis[1].x[l->axis[1].count - 1];
    const int exponent = -ilogb(bat_max(x, y)) - 1;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < l->axis[k].count; i++)
            l->axis[k].x[i] = ldexp(l->axis[k].x[i], exponent);
}

static batten_status choose_cells(bat_lattice *l, const bat_meshing *m, needs *n, samples *s)
{
    batten_status status = BATTEN_OK;
    double total = 0;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const size_t intervals = (size_t)l->axis[k].count;
        choose_samples(&l->axis[k], &s[k]);
        n->need[k] = bat_array(intervals, sizeof(double));
        n->length[k] = bat_array(intervals, sizeof(double));
        n->mean[k] = bat_array(intervals, sizeof(double));
        n->weight[k] = bat_array(intervals, sizeof(double));
        if (!n->need[k] || !n->mean[k] || !n->length[k] || !n->weight[k])
            status = BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        status = measure_needs(l, m, s, n);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        for (int i = 0; i + 1 < l->axis[k].count; i++)
            total += n->weight[k][i] > 0 ? n->length[k][i] / n->weight[k][i] : 0;
    if (status == BATTEN_OK && !(isfinite(total) && total > 0))
        status = bat_fail(BATTEN_SINGULAR_HERE, "the surface has no size: %g", total);
    /* A direction without extent gets a millionth of the other, so that the plane has an area.
     */
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        lay_out(l, k, n, any_needed(l, n), 1e-6 * total);
    if (status == BATTEN_OK)
        scale_plane(l);
    return status;
}

batten_status bat_lattice_begin(bat_lattice *l, const bat_meshing *m, const bat_sheet *sheet,
                                const batten_interval box[2])
{
    needs n = {0};
    *l = (bat_lattice){.sheet = sheet};
    samples *s = bat_array(2, sizeof *s);
    batten_status status = s ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = find_breaks(sheet, k, box[k], &l->axis[k]);
    if (status == BATTEN_OK)
        status = choose_cells(l, m, &n, s);
    for (int k = 0; k < 2; k++) {
        bat_release(n.need[k]);
        bat_release(n.length[k]);
        bat_release(n.mean[k]);
        bat_release(n.weight[k]);
    }
    bat_release(s);
    if (status != BATTEN_OK)
        bat_lattice_end(l);
    return status;
}

void bat_lattice_end(bat_lattice *l)
{
    for (int k = 0; k < 2; k++) {
        bat_release(l->axis[k].u);
        bat_release(l->axis[k].x);
        bat_release(l->axis[k].cells);
    }
    bat_release(l->seeds);
    *l = (bat_lattice){0};
}
