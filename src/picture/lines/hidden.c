/* Which parts of lines are hidden by facets in front of them, cell by cell. */
#include "picture/lines/hidden.h"
#include "base/list.h"

#include <stdlib.h>
#include <string.h>

/* ---- the grid ---- */

enum { MOST_CELLS = 1 << 21 };

static int clamp_cell(double at, int count)
{
    return at <= 0 ? 0 : at >= count - 1 ? count - 1 : (int)at;
}

typedef struct {
    int left, right, bottom, top;
} cells;

static cells cells_of(const bat_facets *f, const double low[2], const double high[2])
{
    return (cells){clamp_cell((low[0] - f->low[0]) / f->cell, f->columns),
                   clamp_cell((high[0] - f->low[0]) / f->cell, f->columns),
                   clamp_cell((low[1] - f->low[1]) / f->cell, f->rows),
                   clamp_cell((high[1] - f->low[1]) / f->cell, f->rows)};
}

static void box_of(const bat_facets *f, const bat_facet *facet, double low[2], double high[2])
{
    for (int k = 0; k < 2; k++) {
        const double a = f->points[3 * facet->corner[0] + k];
        const double b = f->points[3 * facet->corner[1] + k];
        const double c = f->points[3 * facet->corner[2] + k];
        low[k] = bat_min(a, bat_min(b, c));
        high[k] = bat_max(a, bat_max(b, c));
    }
}

/* About two cells for each facet, square, and no smaller than half a point. */
static void lay_grid(bat_facets *f)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < f->point_count; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = bat_min(low[k], f->points[3 * i + (size_t)k]);
            high[k] = bat_max(high[k], f->points[3 * i + (size_t)k]);
        }
    const double wide = bat_max(high[0] - low[0], 1), tall = bat_max(high[1] - low[1], 1);
    const double wanted = bat_min(2 * (double)f->count + 1, MOST_CELLS);
    f->cell = bat_max(sqrt(wide * tall / wanted), 0.5);
    f->columns = (int)(wide / f->cell) + 1;
    f->rows = (int)(tall / f->cell) + 1;
    memcpy(f->low, low, sizeof f->low);
}

/* Count (`inside` NULL) or enter every facet in the cells of its box. */
static void enter(bat_facets *f, bool fill)
{
    for (size_t i = 0; i < f->count; i++) {
        double low[2], high[2];
        box_of(f, &f->facets[i], low, high);
        const cells c = cells_of(f, low, high);
        for (int y = c.bottom; y <= c.top; y++)
            for (int x = c.left; x <= c.right; x++) {
                size_t *place =
                    &f->first[(size_t)y * (size_t)f->columns + (size_t)x + (fill ? 0 : 1)];
                if (fill)
                    f->inside[*place] = (int)i;
                ++*place;
            }
    }
}

batten_status bat_facets_sort(bat_facets *f)
{
    if (f->count == 0)
        return BATTEN_OK;
    lay_grid(f);
    const size_t count = (size_t)f->columns * (size_t)f->rows;
    f->first = bat_array(count + 2, sizeof *f->first);
    if (!f->first)
        return BATTEN_OUT_OF_MEMORY;
    enter(f, false);
    for (size_t i = 0; i < count; i++)
        f->first[i + 1] += f->first[i];
    f->inside = bat_array(f->first[count], sizeof *f->inside);
    if (!f->inside)
        return BATTEN_OUT_OF_MEMORY;
    /* Filling moves each beginning to its end; shift them back. */
    enter(f, true);
    memmove(f->first + 1, f->first, count * sizeof *f->first);
    f->first[0] = 0;
    return BATTEN_OK;
}

void bat_facets_free(bat_facets *f)
{
    bat_release(f->facets);
    bat_release(f->points);
    bat_release(f->first);
    bat_release(f->inside);
    *f = (bat_facets){0};
}

/* ---- one segment ---- */

typedef struct {
    double from, to; /* along the polyline, in segments */
} interval;

typedef struct {
    size_t count, capacity;
    interval *all;
} intervals;

static batten_status add_interval(intervals *list, double from, double to)
{
    return BAT_LIST_ADD(list->all, list->count, list->capacity, (interval){from, to});
}

/* Keep of [t[0], t[1]] where a + s (b - a) >= 0. */
static bool clip(double a, double b, double t[2])
{
    if (a < 0 && b < 0)
        return false;
    if (a < 0)
        t[0] = bat_max(t[0], a / (a - b));
    else if (b < 0)
        t[1] = bat_min(t[1], a / (a - b));
    return t[0] < t[1];
}

/* Twice the signed area of a, b, and the point (x, y). */
static double side(const double *a, const double *b, const double *p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* Where the segment from p to q lies inside the triangle and behind it. */
static bool covered(const bat_facets *f, const bat_facet *facet, const double *p,
                    const double *q, double t[2])
{
    const double *c[3];
    for (int k = 0; k < 3; k++)
        c[k] = f->points + 3 * (size_t)facet->corner[k];
    const double area = side(c[0], c[1], c[2]);
    /* Edge on, a facet hides nothing. */
    if (!(fabs(area) > 1e-9))
        return false;
    double nearer_p = -p[2], nearer_q = -q[2];
    t[0] = 0, t[1] = 1;
    for (int k = 0; k < 3; k++) {
        const double *a = c[(k + 1) % 3], *b = c[(k + 2) % 3];
        const double at_p = side(a, b, p) / area, at_q = side(a, b, q) / area;
        /* Closed by a little, so that no gap is left between neighbours. */
        if (!clip(at_p + 1e-9, at_q + 1e-9, t))
            return false;
        nearer_p += at_p * c[k][2];
        nearer_q += at_q * c[k][2];
    }
    return clip(nearer_p - (double)facet->slack, nearer_q - (double)facet->slack, t);
}

/* All that hides the part of segment `index` between the parameters a and b. */
static batten_status cover_part(const bat_facets *f, const double *from, const double *to,
                                size_t index, double a, double b, intervals *list)
{
    double p[3], q[3], low[2], high[2];
    for (int k = 0; k < 3; k++) {
        p[k] = from[k] + a * (to[k] - from[k]);
        q[k] = from[k] + b * (to[k] - from[k]);
    }
    for (int k = 0; k < 2; k++) {
        low[k] = bat_min(p[k], q[k]);
        high[k] = bat_max(p[k], q[k]);
    }
    const cells c = cells_of(f, low, high);
    for (int y = c.bottom; y <= c.top; y++)
        for (int x = c.left; x <= c.right; x++) {
            const size_t cell = (size_t)y * (size_t)f->columns + (size_t)x;
            for (size_t i = f->first[cell]; i < f->first[cell + 1]; i++) {
                double t[2];
                if (!covered(f, &f->facets[f->inside[i]], p, q, t))
                    continue;
                const double start = (double)index + a + t[0] * (b - a);
                const double end = (double)index + a + t[1] * (b - a);
                const batten_status status = add_interval(list, start, end);
                if (status != BATTEN_OK)
                    return status;
            }
        }
    return BATTEN_OK;
}

static int by_start(const void *a, const void *b)
{
    const interval *s = a, *t = b;
    return (s->from > t->from) - (s->from < t->from);
}

/* Of touching intervals, one; gaps below a millionth of a segment are roundings. */
static void unite(intervals *list)
{
    if (list->count == 0)
        return;
    qsort(list->all, list->count, sizeof *list->all, by_start);
    size_t last = 0;
    for (size_t i = 1; i < list->count; i++) {
        /* A millionth of a segment, see above. */
        if (list->all[i].from <= list->all[last].to + 1e-6)
            list->all[last].to = bat_max(list->all[last].to, list->all[i].to);
        else
            list->all[++last] = list->all[i];
    }
    list->count = last + 1;
}

/* Segments are cut into parts no longer than a cell, so that each asks few cells. */
static batten_status cover(const bat_facets *f, size_t count, const double *points,
                           intervals *list)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; f->count > 0 && i + 1 < count && status == BATTEN_OK; i++) {
        const double *p = points + 3 * i, *q = p + 3;
        const double length = bat_hypot(q[0] - p[0], q[1] - p[1]);
        const int parts = (int)bat_min(ceil(length / f->cell), 65536) + (length <= 0);
        for (int k = 0; k < parts && status == BATTEN_OK; k++)
            status = cover_part(f, p, q, i, (double)k / parts, (double)(k + 1) / parts, list);
    }
    unite(list);
    return status;
}

/* ---- runs ---- */

static void point_at(const double *points, size_t count, double at, double xy[2])
{
    const size_t i = at >= (double)(count - 1) ? count - 2 : (size_t)at;
    const double t = at - (double)i, *p = points + 3 * i;
    for (int k = 0; k < 2; k++)
        xy[k] = p[k] + t * (p[3 + k] - p[k]);
}

static batten_status add_run(bat_runs *runs, bool hidden, size_t count, const double *points,
                             double from, double to)
{
    const batten_status status = BAT_LIST_GROW(runs->runs, runs->count, runs->capacity, 1);
    if (status != BATTEN_OK)
        return status;
    const size_t first = (size_t)from + 1, last = (size_t)ceil(to); /* points between */
    bat_run run = {.hidden = hidden};
    run.xy = bat_array3(last > first ? last - first + 2 : 2, 2, sizeof *run.xy);
    if (!run.xy)
        return BATTEN_OUT_OF_MEMORY;
    point_at(points, count, from, run.xy);
    run.count = 1;
    for (size_t i = first; i < last; i++, run.count++)
        memcpy(run.xy + 2 * run.count, points + 3 * i, 2 * sizeof *run.xy);
    point_at(points, count, to, run.xy + 2 * run.count++);
    runs->runs[runs->count++] = run;
    return BATTEN_OK;
}

/* The length on the sheet from one place of the polyline to another. */
static double length_between(const double *points, size_t count, double from, double to)
{
    double a[2], b[2], length = 0;
    point_at(points, count, from, a);
    for (size_t i = (size_t)from + 1; (double)i < to; i++) {
        length += bat_hypot(points[3 * i] - a[0], points[3 * i + 1] - a[1]);
        memcpy(a, points + 3 * i, sizeof a);
    }
    point_at(points, count, to, b);
    return length + bat_hypot(b[0] - a[0], b[1] - a[1]);
}

/* Gaps between hidden parts that are too short to be seen close; then too short hidden parts
 * go. A short visible end beyond a hidden part goes too: there a line emerges that does not. */
static void tidy(const double *points, size_t count, double least, intervals *list)
{
    const double end = (double)(count - 1);
    size_t kept = 0;
    for (size_t i = 0; i < list->count; i++) {
        interval next = list->all[i];
        const double before = kept ? list->all[kept - 1].to : 0;
        const bool joins = length_between(points, count, before, next.from) < least;
        if (joins && kept)
            list->all[kept - 1].to = next.to;
        else
            list->all[kept++] = next;
    }
    list->count = kept;
    kept = 0;
    for (size_t i = 0; i < list->count; i++) {
        interval next = list->all[i];
        if (length_between(points, count, next.from, next.to) < least)
            continue;
        if (length_between(points, count, 0, next.from) < least)
            next.from = 0;
        if (length_between(points, count, next.to, end) < least)
            next.to = end;
        list->all[kept++] = next;
    }
    list->count = kept;
}

batten_status bat_runs_cut(const bat_facets *facets, size_t count, const double *points,
                           const double *probes, double least, bat_runs *out)
{
    intervals hidden = {0};
    if (count < 2)
        return BATTEN_OK;
    batten_status status = cover(facets, count, probes, &hidden);
    const double end = (double)(count - 1);
    double at = 0;
    if (status == BATTEN_OK)
        tidy(points, count, least, &hidden);
    for (size_t i = 0; i < hidden.count && status == BATTEN_OK; i++) {
        const interval h = hidden.all[i];
        if (h.from > at)
            status = add_run(out, false, count, points, at, h.from);
        if (status == BATTEN_OK)
            status = add_run(out, true, count, points, h.from, bat_min(h.to, end));
        at = h.to;
    }
    if (status == BATTEN_OK && at < end)
        status = add_run(out, false, count, points, at, end);
    if (status != BATTEN_OK)
        bat_runs_free(out);
    bat_release(hidden.all);
    return status;
}

void bat_runs_free(bat_runs *runs)
{
    for (size_t i = 0; i < runs->count; i++)
        bat_release(runs->runs[i].xy);
    bat_release(runs->runs);
    *runs = (bat_runs){0};
}
