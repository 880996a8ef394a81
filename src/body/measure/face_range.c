/* Which part of its surface a face takes up, in the parameters, and no less. */
#include "body/measure/box.h"
#include "body/trace/chart.h"
#include "numeric/vector.h"

#include <batten/curvature.h>
#include <string.h>

/* ---- loops in the parameters ---- */

/* What one loop says. It is followed through the plane that covers the surface. */
typedef struct {
    batten_interval over[2];
    int turns[2];
    double area; /* twice; positive when it runs counter-clockwise */
    bool meets_pole;
} loop_range;

typedef struct {
    const batten_body_parts *parts;
    bat_chart chart;
    double off; /* an edge so far off the surface says nothing */
    loop_range *loops;
    int count;
    /* The loop at work: how many samples, the first, and the last two of its edge. */
    int samples, of_edge;
    double first[2], last[2], before[2];
} finder;

static void widen_range(const finder *f, batten_interval over[2], const double uv[2])
{
    for (int k = 0; k < 2; k++) {
        double swell = 0; /* beyond the samples, by a parabola through three, twice over */
        if (f->of_edge >= 2)
            swell = fabs(f->before[k] - 2 * f->last[k] + uv[k]) / 4;
        over[k].a = bat_min(over[k].a, bat_min(uv[k], f->last[k] - swell));
        over[k].b = bat_max(over[k].b, bat_max(uv[k], f->last[k] + swell));
    }
}

static void add_sample(finder *f, loop_range *loop, const double uv[2])
{
    const double *o = f->first;
    widen_range(f, loop->over, uv);
    loop->area += (f->last[0] - o[0]) * (uv[1] - o[1]) - (f->last[1] - o[1]) * (uv[0] - o[0]);
    memcpy(f->before, f->last, sizeof f->before);
    memcpy(f->last, uv, sizeof f->last);
    f->samples++;
    f->of_edge++;
}

static void begin_at(finder *f, loop_range *loop, const double uv[2])
{
    for (int k = 0; k < 2; k++)
        loop->over[k] = (batten_interval){uv[k], uv[k]};
    memcpy(f->first, uv, sizeof f->first);
    memcpy(f->last, uv, sizeof f->last);
    f->samples = f->of_edge = 1;
}

/* The foot of a point next to the one before. */
static batten_status find_foot(finder *f, loop_range *loop, const double point[3], double uv[2])
{
    double off = 0;
    batten_status status =
        bat_chart_find(&f->chart, point, f->samples ? f->last : NULL, uv, &off);
    if (status == BATTEN_OK && off > f->off)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "an edge is %g off its surface", off);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        if (f->samples && f->chart.closed[k])
            uv[k] += f->chart.period[k] * nearbyint((f->last[k] - uv[k]) / f->chart.period[k]);
    if (status == BATTEN_OK && bat_chart_pole(&f->chart, point) >= 0)
        loop->meets_pole = true;
    return status;
}

/* Feet of some points of each span. */
static batten_status follow_edge(finder *f, loop_range *loop, const batten_body_use *use)
{
    enum { LEAST = 8, EACH = 4, MOST = 200 };
    const batten_curve *curve = f->parts->edges[use->edge].curve;
    batten_status status = BATTEN_OK;
    f->of_edge = 0;
    if (!curve) {
        loop->meets_pole = true;
        return BATTEN_OK;
    }
    const batten_interval on = batten_curve_domain(curve);
    const int steps =
        bat_min_int(MOST, bat_max_int(LEAST, EACH * (batten_curve_spans(curve, NULL) - 1)));
    for (int i = 0; status == BATTEN_OK && i <= steps; i++) {
        const int at = use->reversed ? steps - i : i;
        double point[3], uv[2];
        status = batten_curve_evaluate(
            curve, at < steps ? on.a + (on.b - on.a) * at / steps : on.b, 0, point);
        if (status == BATTEN_OK)
            status = find_foot(f, loop, point, uv);
        if (status == BATTEN_OK && f->samples == 0)
            begin_at(f, loop, uv);
        else if (status == BATTEN_OK)
            add_sample(f, loop, uv);
    }
    return status;
}

static batten_status follow_loop(finder *f, int index, loop_range *loop)
{
    const batten_body_loop *of = &f->parts->loops[index];
    batten_status status = BATTEN_OK;
    *loop = (loop_range){.area = 0};
    f->samples = 0;
    for (int i = 0; status == BATTEN_OK && i < of->count; i++)
        status = follow_edge(f, loop, &f->parts->uses[of->first + i]);
    for (int k = 0; status == BATTEN_OK && f->samples && k < 2; k++)
        /* No loop goes around a million times; what is damaged may, and must fit an int. */
        if (f->chart.closed[k])
            loop->turns[k] = (int)bat_max(
                -1e6, bat_min(1e6, nearbyint((f->last[k] - f->first[k]) / f->chart.period[k])));
    return status;
}

/* ---- what they say together ---- */

/* All of the surface along k. */
static void take_all(finder *f, int k, batten_interval over[2])
{
    over[k] = f->chart.domain[k];
}

static int largest_loop(const finder *f)
{
    int outer = 0;
    for (int i = 1; i < f->count; i++)
        if (fabs(f->loops[i].area) > fabs(f->loops[outer].area))
            outer = i;
    return outer;
}

/* The whole periods that bring a loop next to the main one. */
static double shift_beside(const bat_chart *chart, int k, batten_interval own,
                           batten_interval main)
{
    const double apart = (main.a + main.b - own.a - own.b) / 2;
    return chart->closed[k] ? chart->period[k] * nearbyint(apart / chart->period[k]) : 0;
}

/* By the largest loop, and the others moved beside it by whole periods. */
static void take_loops(const finder *f, int k, batten_interval over[2])
{
    const int outer = largest_loop(f);
    over[k] = f->loops[outer].over[k];
    for (int i = 0; i < f->count; i++) {
        const batten_interval own = f->loops[i].over[k];
        const double by = shift_beside(&f->chart, k, own, f->loops[outer].over[k]);
        over[k].a = bat_min(over[k].a, own.a + by);
        over[k].b = bat_max(over[k].b, own.b + by);
    }
}

/* One loop more goes around along k than comes back: the face lies on its left as far as the
 * surface goes, and on the side of a pole when the other is none. */
static void go_on(const finder *f, int k, int turns, batten_interval over[2])
{
    const bool *pole = f->chart.pole;
    const bool low = pole[k ? 3 : 0], high = pole[k ? 1 : 2];
    const batten_interval domain = f->chart.domain[1 - k];
    bool is_high = (turns > 0) == (k == 0);
    if (low != high)
        is_high = high;
    if (is_high)
        over[1 - k].b = bat_max(over[1 - k].b, domain.b);
    else
        over[1 - k].a = bat_min(over[1 - k].a, domain.a);
}

static void combine(finder *f, bool reversed, batten_interval over[2])
{
    int around[2] = {0, 0}, turns[2] = {0, 0};
    bool meets_pole = false, any = false;
    for (int k = 0; k < 2; k++)
        take_loops(f, k, over);
    for (int i = 0; i < f->count; i++) {
        meets_pole |= f->loops[i].meets_pole;
        any |= reversed ? f->loops[i].area < 0 : f->loops[i].area > 0;
        for (int k = 0; k < 2; k++) {
            around[k] += f->loops[i].turns[k] != 0;
            turns[k] += f->loops[i].turns[k];
        }
    }
    const bool *pole = f->chart.pole;
    for (int k = 0; k < 2; k++) {
        const bool has_pole = pole[k ? 1 : 0] || pole[k ? 3 : 2];
        if (around[k] % 2 && !f->chart.closed[1 - k])
            go_on(f, k, reversed ? -turns[k] : turns[k], over);
        if (around[k] || (meets_pole && has_pole))
            take_all(f, k, over);
        if (around[k] && f->chart.closed[1 - k])
            take_all(f, 1 - k, over);
    }
    /* Holes in a surface without an end. */
    if (!around[0] && !around[1] && !any && f->chart.complete)
        for (int k = 0; k < 2; k++)
            take_all(f, k, over);
}

/* Into the domain; in two parts where it goes over the seam. */
static void put_range(const finder *f, int k, batten_interval over, bat_face_range *out)
{
    const batten_interval domain = f->chart.domain[k];
    const double period = f->chart.period[k], least = 1e-9 * period;
    over.a -= over.b - over.a < least ? least : 0;
    over.b += over.b - over.a < 2 * least ? least : 0;
    out->count[k] = 1;
    if (!f->chart.closed[k]) {
        over = (batten_interval){bat_max(domain.a, bat_min(over.a, domain.b - least)),
                                 bat_min(domain.b, bat_max(over.b, domain.a + least))};
    } else if (over.b - over.a >= period - least) {
        over = domain;
    } else {
        const double by = period * floor((over.a - domain.a) / period);
        over = (batten_interval){over.a - by, over.b - by};
        if (over.b > domain.b + least) {
            out->at[k][1] = (batten_interval){domain.a, over.b - period};
            out->count[k] = 2;
        }
        over = (batten_interval){bat_min(over.a, domain.b - least), bat_min(over.b, domain.b)};
    }
    out->at[k][0] = over;
}

/* ---- curves in the parameters ---- */

static void take_points(const batten_curve *curve, batten_interval over[2])
{
    const double *points = batten_curve_points(curve);
    for (int j = 0; j < 2 * batten_curve_point_count(curve); j++) {
        over[j % 2].a = bat_min(over[j % 2].a, points[j]);
        over[j % 2].b = bat_max(over[j % 2].b, points[j]);
    }
}

/* Of a traced body: their control points hold them in, and they stay in the domain. */
static void take_curves(const finder *f, const batten_body_face *face, batten_interval over[2])
{
    const batten_body_parts *p = f->parts;
    const batten_body_loop *first = &p->loops[face->first],
                           *last = &p->loops[face->first + face->count - 1];
    for (int k = 0; k < 2; k++)
        over[k] = (batten_interval){f->chart.domain[k].b, f->chart.domain[k].a};
    for (int i = first->first; i < last->first + last->count; i++)
        take_points(p->uses[i].parameters, over);
}

/* ---- all of it ---- */

static batten_status find_loops(finder *f, const batten_body_face *face)
{
    f->count = face->count;
    f->loops = bat_array((size_t)face->count, sizeof *f->loops);
    batten_status status = f->loops ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < face->count; i++)
        status = follow_loop(f, face->first + i, &f->loops[i]);
    return status;
}

batten_status bat_face_range_find(const batten_body_parts *parts, int face, double size,
                                  bat_face_range *out)
{
    const batten_body_face *of = &parts->faces[face];
    /* A range within a ten-thousandth of the body serves a box that is widened by a hundredth.
     */
    const double tolerance = bat_max(parts->tolerance, 1e-4 * size);
    finder f = {.parts = parts, .off = 1e-2 * size};
    batten_interval over[2];
    batten_status status = bat_chart_begin(of->surface, tolerance, &f.chart);
    if (status == BATTEN_OK && parts->is_traced)
        take_curves(&f, of, over);
    else if (status == BATTEN_OK)
        status = find_loops(&f, of);
    if (status == BATTEN_OK && !parts->is_traced)
        combine(&f, of->reversed, over);
    if (status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY && f.chart.surface) {
        for (int k = 0; k < 2; k++)
            take_all(&f, k, over);
        status = BATTEN_OK;
    }
    if (status == BATTEN_OK) {
        *out = (bat_face_range){.surface = batten_surface_ref(f.chart.surface)};
        for (int k = 0; k < 2; k++)
            put_range(&f, k, over[k], out);
    }
    bat_release(f.loops);
    bat_chart_end(&f.chart);
    return status;
}
