/*
 * A parameter curve by following the feet of an edge on the surface: at nodes the foot and its
 * velocity, between them a cubic in Hermite form. A piece that misses is halved.
 */
#include "base/plural.h"
#include "body/trace/parameters.h"
#include "numeric/vector.h"

#include <string.h>

/* Derivatives before and after differ where the edge has a corner. */
typedef struct {
    double t, uv[2], before[2], after[2];
    bool good; /* the piece that begins here */
} node;

enum { MOST_NODES = 4096 };

typedef struct {
    bat_chart *chart;
    const batten_curve *curve;
    node *nodes, *other;
    int count, room;
} path;

static batten_status point_on(const path *p, double t, double q[3])
{
    return batten_curve_evaluate(p->curve, t, 0, q);
}

/* Moved by whole periods to where it is nearest to the guess. */
static void nearest_branch(const bat_chart *chart, const double guess[2], double uv[2])
{
    for (int k = 0; k < 2; k++)
        if (chart->closed[k])
            uv[k] += chart->period[k] * nearbyint((guess[k] - uv[k]) / chart->period[k]);
}

/* The foot at t from a place near it; on the branch of the covering plane that is nearest. */
static batten_status foot_at(path *p, double t, const double guess[2], double uv[2])
{
    double q[3], distance = 0;
    batten_status status = point_on(p, t, q);
    if (status == BATTEN_OK)
        status = bat_chart_find(p->chart, q, guess, uv, &distance);
    if (status != BATTEN_OK)
        return status;
    if (distance > p->chart->tolerance)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "the edge is %g off the surface at its parameter %.15g, more than %g",
                        distance, t, p->chart->tolerance);
    if (guess)
        nearest_branch(p->chart, guess, uv);
    return BATTEN_OK;
}

/* @param s  the surface and its derivatives at t */
static batten_status velocity_from(const path *p, double t, batten_side side, const double *s,
                                   double velocity[2])
{
    double c[6];
    const batten_status status = batten_curve_evaluate_side(p->curve, t, side, 1, c);
    if (status == BATTEN_OK)
        bat_chart_velocity(s, c + 3, velocity);
    return status;
}

static batten_status set_velocity(const path *p, node *n)
{
    double s[9];
    batten_status status = bat_chart_evaluate(p->chart, n->uv, 1, s);
    if (status == BATTEN_OK)
        status = velocity_from(p, n->t, BATTEN_FROM_LEFT, s, n->before);
    if (status == BATTEN_OK)
        status = velocity_from(p, n->t, BATTEN_FROM_RIGHT, s, n->after);
    return status;
}

/*
 * The foot at t, near a pole. From the pole itself it goes downhill along the meridian of the
 * guess only, and not at all when that is a quarter around or more from the foot: then the pole
 * is left along others.
 */
static batten_status foot_near_pole(path *p, int pole, double t, const double guess[2],
                                    double uv[2])
{
    enum { MERIDIANS = 8 };
    const bat_chart *chart = p->chart;
    const int fixed = pole % 2 ? 0 : 1, along = 1 - fixed;
    double q[3], least = HUGE_VAL;
    const double at_pole =
        pole == 1 || pole == 2 ? chart->domain[fixed].b : chart->domain[fixed].a;
    batten_status status = foot_at(p, t, guess, uv);
    if (status != BATTEN_OK || uv[fixed] != at_pole)
        return status;
    status = point_on(p, t, q);
    for (int i = 0; status == BATTEN_OK && i < MERIDIANS; i++) {
        double from[2], distance = 0;
        from[fixed] = at_pole;
        from[along] = chart->domain[along].a + chart->period[along] * (i + 0.5) / MERIDIANS;
        status = bat_chart_foot(chart, q, from, &distance);
        if (status == BATTEN_OK && distance < least) {
            least = distance;
            memcpy(uv, from, sizeof from);
        }
    }
    if (status == BATTEN_OK && guess)
        nearest_branch(chart, guess, uv);
    return status;
}

/* At a pole one coordinate has no extent; it is continued from two places nearby at t + h and
 * t + 2 h. */
static batten_status set_pole(path *p, int pole, double h, const double guess[2], node *n)
{
    double near[2], far[2];
    const int fixed = pole % 2 ? 0 : 1;
    batten_status status = foot_near_pole(p, pole, n->t + 2 * h, guess, far);
    if (status == BATTEN_OK)
        status = foot_at(p, n->t + h, far, near);
    if (status != BATTEN_OK)
        return status;
    const batten_interval domain = p->chart->domain[fixed];
    n->uv[fixed] = pole == 1 || pole == 2 ? domain.b : domain.a;
    n->uv[1 - fixed] = 2 * near[1 - fixed] - far[1 - fixed];
    status = set_velocity(p, n);
    n->before[1 - fixed] = n->after[1 - fixed] = (far[1 - fixed] - near[1 - fixed]) / h;
    return status;
}

/* The node at t; `length` is that of the span beside it, negative at the end of the curve. */
static batten_status make_node(path *p, double t, double length, const double *guess, node *n)
{
    double q[3];
    *n = (node){.t = t};
    batten_status status = point_on(p, t, q);
    if (status != BATTEN_OK)
        return status;
    const int pole = bat_chart_pole(p->chart, q);
    if (pole >= 0)
        /* So near to the pole that the path is straight, and so far that feet keep twelve
         * digits. */
        return set_pole(p, pole, 1e-4 * length, guess, n);
    status = foot_at(p, t, guess, n->uv);
    return status == BATTEN_OK ? set_velocity(p, n) : status;
}

static batten_status begin_path(path *p, const double *guess)
{
    const int spans = batten_curve_spans(p->curve, NULL) - 1;
    const int each = bat_max_int(1, bat_min_int(4, 8 / spans));
    if (spans * each + 1 > MOST_NODES)
        return bat_fail(BATTEN_TOO_LARGE, "an edge has %d span%s, more than %d", spans,
                        bat_plural(spans), MOST_NODES);
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    p->room = 2 * (spans * each + 1);
    p->nodes = bat_array((size_t)p->room, sizeof *p->nodes);
    p->other = bat_array((size_t)p->room, sizeof *p->other);
    batten_status status = breaks && p->nodes && p->other ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(p->curve, breaks);
    for (int i = 0; status == BATTEN_OK && i <= spans * each; i++) {
        const int span = bat_min_int(i / each, spans - 1), part = i - span * each;
        const double a = breaks[span], b = breaks[span + 1];
        const double t = part == each ? b : a + (b - a) * part / each;
        double next[2];
        for (int k = 0; i && k < 2; k++) {
            const node *n = &p->nodes[i - 1];
            const double step = (t - n->t) * n->after[k];
            /* A tangent leads a short way only. */
            const double most = p->chart->period[k] / 8;
            next[k] = n->uv[k] + bat_max(-most, bat_min(most, step));
        }
        status =
            make_node(p, t, i == spans * each ? a - b : b - a, i ? next : guess, &p->nodes[i]);
        p->count = i + 1;
    }
    bat_release(breaks);
    return status;
}

/* ---- pieces ---- */

static void between(const node *a, const node *b, double s, double uv[2])
{
    const double h = b->t - a->t;
    for (int k = 0; k < 2; k++) {
        const double p0 = a->uv[k], p3 = b->uv[k];
        const double p1 = p0 + h * a->after[k] / 3, p2 = p3 - h * b->before[k] / 3;
        const double r = 1 - s;
        uv[k] = r * r * r * p0 + 3 * r * r * s * p1 + 3 * r * s * s * p2 + s * s * s * p3;
    }
}

/* How far the piece misses at its quarters, and how far the edge itself is off at the ends. */
static batten_status piece_miss(const path *p, const node *a, const node *b, double *miss,
                                double *off)
{
    batten_status status = BATTEN_OK;
    *miss = *off = 0;
    for (int i = 0; status == BATTEN_OK && i < 5; i++) {
        double uv[2], q[3], s[3];
        between(a, b, i / 4.0, uv);
        status = point_on(p, i < 4 ? a->t + (b->t - a->t) * i / 4 : b->t, q);
        if (status == BATTEN_OK)
            status = bat_chart_evaluate(p->chart, uv, 0, s);
        if (status == BATTEN_OK && i % 4)
            *miss = bat_max(*miss, bat_distance(3, q, s));
        else if (status == BATTEN_OK)
            *off = bat_max(*off, bat_distance(3, q, s));
    }
    return status;
}

/* Room for twice the nodes. */
static batten_status widen(path *p)
{
    if (2 * p->count <= p->room)
        return BATTEN_OK;
    p->room = 2 * p->count;
    node *nodes = bat_resize(p->nodes, (size_t)p->room, sizeof *nodes);
    if (!nodes)
        return BATTEN_OUT_OF_MEMORY;
    p->nodes = nodes;
    node *other = bat_resize(p->other, (size_t)p->room, sizeof *other);
    if (!other)
        return BATTEN_OUT_OF_MEMORY;
    p->other = other;
    return BATTEN_OK;
}

/* Halve every piece that is not good yet; *more: some were. */
static batten_status refine(path *p, bool *more)
{
    batten_status status = widen(p);
    int count = 0;
    const double range = p->nodes[p->count - 1].t - p->nodes[0].t;
    *more = false;
    for (int i = 0; status == BATTEN_OK && i < p->count - 1; i++) {
        node *a = &p->nodes[i], *b = &p->nodes[i + 1], half;
        double miss = 0, off = 0, guess[2];
        if (!a->good) {
            status = piece_miss(p, a, b, &miss, &off);
            /* A piece of some thousand roundings of the range is not halved any more. */
            a->good = status == BATTEN_OK &&
                      (miss <= off + 0.1 * p->chart->tolerance || b->t - a->t < 1e-12 * range);
        }
        p->other[count++] = *a;
        if (status != BATTEN_OK || a->good)
            continue;
        if (count + p->count - i >= MOST_NODES)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "a parameter curve misses its edge by %g, more than %g, with %d "
                            "piece%s",
                            miss, p->chart->tolerance, count, bat_plural(count));
        between(a, b, 0.5, guess);
        status = make_node(p, a->t + (b->t - a->t) / 2, b->t - a->t, guess, &half);
        p->other[count++] = half;
        *more = true;
    }
    p->other[count++] = p->nodes[p->count - 1];
    p->count = count;
    node *swap = p->nodes;
    p->nodes = p->other;
    p->other = swap;
    return status;
}

static bool is_smooth(const node *n)
{
    return n->before[0] == n->after[0] && n->before[1] == n->after[1];
}

/* The pieces as a cubic spline: knots twice, three times at corners. */
static batten_status to_curve(const path *p, batten_curve **out)
{
    const int last = p->count - 1;
    double *points = bat_array3((size_t)p->count, 3 * 2, sizeof *points);
    double *knots = bat_array((size_t)p->count * 3 + 5, sizeof *knots);
    batten_status status = points && knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int n = 0, m = 0;
    for (int i = 0; status == BATTEN_OK && i <= last; i++) {
        const node *here = &p->nodes[i];
        const int times = i == 0 || i == last ? 4 : is_smooth(here) ? 2 : 3;
        for (int k = 0; k < times; k++)
            knots[m++] = here->t;
        for (int k = 0; k < 2; k++) {
            double *point = points + 2 * n + k;
            if (i > 0)
                *point = here->uv[k] - (here->t - here[-1].t) * here->before[k] / 3, point += 2;
            if (times > 2)
                *point = here->uv[k], point += 2;
            if (i < last)
                *point = here->uv[k] + (here[1].t - here->t) * here->after[k] / 3;
        }
        n += (i > 0) + (times > 2) + (i < last);
    }
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){2, n, points}, 3, NULL, knots, out);
    bat_release(points);
    bat_release(knots);
    return status;
}

/* Control points beyond a border of the surface are brought back to it. */
static batten_status finish_path(const path *p, batten_curve **out, double *miss)
{
    batten_curve *made = NULL, *inside = NULL;
    double low[2], high[2];
    for (int k = 0; k < 2; k++) {
        low[k] = p->chart->closed[k] ? -HUGE_VAL : p->chart->domain[k].a;
        high[k] = p->chart->closed[k] ? HUGE_VAL : p->chart->domain[k].b;
    }
    batten_status status = to_curve(p, &made);
    if (status == BATTEN_OK)
        status = bat_parameters_adjust(made, low, high, NULL, NULL, &inside);
    if (status == BATTEN_OK)
        status = bat_parameters_miss(p->chart, p->curve, inside, HUGE_VAL, miss);
    if (status == BATTEN_OK && *miss > p->chart->tolerance)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the edge can be followed on the surface to %g only, not %g", *miss,
                          p->chart->tolerance);
    batten_curve_unref(made);
    if (status == BATTEN_OK)
        *out = inside;
    else
        batten_curve_unref(inside);
    return status;
}

batten_status bat_parameters_follow(bat_chart *chart, const batten_curve *curve,
                                    const double *guess, batten_curve **out, double *miss)
{
    path p = {.chart = chart, .curve = curve};
    bool more = true;
    batten_status status = begin_path(&p, guess);
    while (status == BATTEN_OK && more)
        status = refine(&p, &more);
    if (status == BATTEN_OK)
        status = finish_path(&p, out, miss);
    bat_release(p.nodes);
    bat_release(p.other);
    return status;
}
