/*
 * Both curves are cut into chords with a bound on their sag. Pairs of boxes that are near
 * enough are halved down to pairs of chords; from these Newton's method finds the local minimum
 * of the distance, which must not leave the neighbourhood of the two chords.
 */
#include "inspect/nearest/meetings.h"
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

/* ---- two chords ---- */

static double clamp(double x)
{
    return bat_max(0, bat_min(1, x));
}

/* The distance of the segments a0 a1 and b0 b1, and where on each, 0 .. 1. */
static double chord_distance(const double *a, const double *b, double *s, double *t)
{
    double u[3], v[3], w[3];
    for (int c = 0; c < 3; c++) {
        u[c] = a[3 + c] - a[c];
        v[c] = b[3 + c] - b[c];
        w[c] = a[c] - b[c];
    }
    const double uu = bat_dot(3, u, u), uv = bat_dot(3, u, v), vv = bat_dot(3, v, v);
    const double uw = bat_dot(3, u, w), vw = bat_dot(3, v, w), across = uu * vv - uv * uv;
    *s = across > DBL_EPSILON * uu * vv ? clamp((uv * vw - vv * uw) / across) : 0.5;
    *t = vv > 0 ? clamp((uv * *s + vw) / vv) : 0.5;
    if (uu > 0) /* once more the nearest on a: right when t was cut */
        *s = clamp((uv * *t - uw) / uu);
    for (int c = 0; c < 3; c++)
        w[c] += *s * u[c] - *t * v[c];
    return bat_norm(3, w);
}

/* ---- the local minimum of the distance ---- */

typedef struct {
    const batten_curve *curve[2];
    double low[2], high[2]; /* the search stays in here */
} hunt;

/* Points and two derivatives of both curves. */
static batten_status evaluate_both(const hunt *h, const double at[2], double rows[2][9],
                                   double off[3])
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = batten_curve_evaluate(h->curve[k], at[k], 2, rows[k]);
    for (int c = 0; c < 3 && status == BATTEN_OK; c++)
        off[c] = rows[0][c] - rows[1][c];
    return status;
}

/* Half the square of the distance of two points, one on each curve. */
static batten_status look_at_both(const void *context, const double at[2], bat_foot_place *out)
{
    double rows[2][9], off[3];
    const batten_status status = evaluate_both(context, at, rows, off);
    if (status != BATTEN_OK)
        return status;
    const double *P = rows[0], *Q = rows[1];
    *out = (bat_foot_place){
        .at = {at[0], at[1]},
        .value = bat_dot(3, off, off) / 2,
        .gradient = {bat_dot(3, P + 3, off), -bat_dot(3, Q + 3, off)},
        .normal = {bat_dot(3, P + 3, P + 3), -bat_dot(3, P + 3, Q + 3),
                   bat_dot(3, Q + 3, Q + 3)},
    };
    out->second[0] = out->normal[0] + bat_dot(3, P + 6, off);
    out->second[1] = out->normal[1];
    out->second[2] = out->normal[2] - bat_dot(3, Q + 6, off);
    return BATTEN_OK;
}

/* Newton's step, that of Gauss and Newton where the distance is not convex. Curves that run
 * along each other have no single foot, so the matrices are kept from being singular. */
static void find_step(const bat_foot_place *here, const bool free[2], double step[2])
{
    const double *g = here->gradient, pq = here->normal[1];
    double a = here->second[0], b = here->second[2];
    /* Half of the digits of the determinant must be left for Newton; without them a billionth
     * more of the diagonal keeps the other matrix regular and moves its step as little. */
    if (!(a > 0 && b > 0 && a * b - pq * pq > 1e-8 * a * b)) {
        a = here->normal[0] * (1 + 1e-9);
        b = here->normal[2] * (1 + 1e-9);
    }
    const double across = a * b - pq * pq;
    if (!free[0] || !free[1] || !(across > 0)) {
        step[0] = free[0] && a > 0 ? -g[0] / a : 0;
        step[1] = free[1] && b > 0 && !free[0] ? -g[1] / b : 0;
        if (free[1] && free[0] && b > 0)
            step[1] = -g[1] / b / 2;
        return;
    }
    step[0] = (-b * g[0] + pq * g[1]) / across;
    step[1] = (pq * g[0] - a * g[1]) / across;
}

/* The local minimum downhill from `at`, as a meeting. */
static batten_status descend(const hunt *h, const double at[2], bat_meeting *best)
{
    const bat_foot_descent descent = {.look = look_at_both,
                                      .step = find_step,
                                      .context = h,
                                      .low = {h->low[0], h->low[1]},
                                      .high = {h->high[0], h->high[1]},
                                      .longest = {HUGE_VAL, HUGE_VAL},
                                      .steps = 40,
                                      .halvings = 12};
    bat_foot_place foot = {.at = {at[0], at[1]}};
    double rows[2][9], off[3];
    batten_status status = bat_foot_descend(&descent, &foot);
    if (status == BATTEN_OK)
        status = evaluate_both(h, foot.at, rows, off);
    if (status != BATTEN_OK)
        return status;
    *best = (bat_meeting){.at = {foot.at[0], foot.at[1]}, .distance = bat_norm(3, off)};
    for (int k = 0; k < 2; k++)
        memcpy(best->point[k], rows[k], sizeof best->point[k]);
    return BATTEN_OK;
}

/* ---- pairs of boxes ---- */

typedef struct {
    const bat_trace *trace[2];
    double tolerance;
    bool nearest; /* only the nearest place is wanted */
    long looked;
    bat_meetings *out;
} search;

static double box_distance(const double *a, const double *b)
{
    double away[3];
    for (int c = 0; c < 3; c++)
        away[c] = bat_max(0, bat_max(a[c] - b[3 + c], b[c] - a[3 + c]));
    return bat_norm(3, away);
}

/* Did the search end at a limit that is no end of the curve? Then the minimum is elsewhere. */
static bool ran_out(const hunt *h, const bat_meeting *p)
{
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = batten_curve_domain(h->curve[k]);
        if ((p->at[k] <= h->low[k] && h->low[k] > domain.a) ||
            (p->at[k] >= h->high[k] && h->high[k] < domain.b))
            return true;
    }
    return false;
}

static void keep_meeting(search *s, const bat_meeting *m)
{
    bat_meetings *all = s->out;
    if (m->distance < all->nearest.distance)
        all->nearest = *m;
    if (m->distance > s->tolerance)
        return;
    int i = 0;
    for (; i < all->count; i++)
        if (bat_distance(3, all->found[i].point[0], m->point[0]) <= 2 * s->tolerance &&
            bat_distance(3, all->found[i].point[1], m->point[1]) <= 2 * s->tolerance) {
            /* Ends of closed curves are one place with two parameters: keep both apart. */
            if (fabs(all->found[i].at[0] - m->at[0]) > 0.5 ||
                fabs(all->found[i].at[1] - m->at[1]) > 0.5)
                continue;
            if (m->distance < all->found[i].distance)
                all->found[i] = *m;
            return;
        }
    if (all->count == BAT_MEETINGS) {
        all->more = true;
        return;
    }
    for (i = all->count++; i > 0 && all->found[i - 1].at[0] > m->at[0]; i--)
        all->found[i] = all->found[i - 1];
    all->found[i] = *m;
}

static batten_status try_chords(search *s, int a, int b)
{
    const int k[2] = {a, b};
    double at[2];
    hunt h;
    const double distance = chord_distance(s->trace[0]->points + 3 * a,
                                           s->trace[1]->points + 3 * b, &at[0], &at[1]);
    const double sag = s->trace[0]->sag[a] + s->trace[1]->sag[b];
    if (distance - sag > (s->nearest ? s->out->nearest.distance : s->tolerance))
        return BATTEN_OK;
    for (int c = 0; c < 2; c++) {
        const bat_trace *t = s->trace[c];
        h.curve[c] = t->curve;
        h.low[c] = t->at[bat_max_int(0, k[c] - 1)];
        h.high[c] = t->at[bat_min_int(t->count, k[c] + 2)];
        at[c] = (1 - at[c]) * t->at[k[c]] + at[c] * t->at[k[c] + 1];
    }
    bat_meeting best;
    const batten_status status = descend(&h, at, &best);
    if (status == BATTEN_OK && (s->nearest || !ran_out(&h, &best)))
        keep_meeting(s, &best);
    return status;
}

/* Is a pair of nodes worth looking at? */
static bool is_near(const search *s, int a, int b)
{
    const double distance =
        box_distance(s->trace[0]->boxes + 6 * a, s->trace[1]->boxes + 6 * b);
    /* A pair that is no nearer than rounding tells is not worth a descent. */
    return distance <= (s->nearest ? s->out->nearest.distance * (1 - 1e-6) : s->tolerance);
}

/* Put both halves of the larger node upon the stack, the nearer one last. */
static int push_halves(const search *s, int a, int b, int (*stack)[2], int waiting)
{
    const bool leaf_a = a >= s->trace[0]->width, leaf_b = b >= s->trace[1]->width;
    const double *A = s->trace[0]->boxes + 6 * a, *B = s->trace[1]->boxes + 6 * b;
    const bool cut_a =
        leaf_b || (!leaf_a && bat_distance(3, A, A + 3) >= bat_distance(3, B, B + 3));
    int pairs[2][2];
    double away[2];
    for (int k = 0; k < 2; k++) {
        pairs[k][0] = cut_a ? 2 * a + k : a;
        pairs[k][1] = cut_a ? b : 2 * b + k;
        away[k] = box_distance(s->trace[0]->boxes + 6 * pairs[k][0],
                               s->trace[1]->boxes + 6 * pairs[k][1]);
    }
    const int first = away[0] < away[1] ? 1 : 0;
    for (int i = 0; i < 2; i++)
        memcpy(stack[waiting++], pairs[i == 0 ? first : 1 - first], sizeof pairs[0]);
    return waiting;
}

static batten_status descend_pairs(search *s)
{
    enum { DEEP = 128, MOST = 1000000 };
    int stack[DEEP][2] = {{1, 1}}, waiting = 1;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && waiting > 0 && !s->out->more) {
        const int a = stack[--waiting][0], b = stack[waiting][1];
        if (!is_near(s, a, b))
            continue;
        if (++s->looked > MOST)
            return bat_fail(BATTEN_INCOMPLETE,
                            "two curves run so near to each other that %d pairs of their parts "
                            "do not tell where they meet",
                            (int)MOST);
        if (a >= s->trace[0]->width && b >= s->trace[1]->width)
            status = try_chords(s, a - s->trace[0]->width, b - s->trace[1]->width);
        else
            waiting = push_halves(s, a, b, stack, waiting);
    }
    return status;
}

batten_status bat_meetings_find(const bat_trace *a, const bat_trace *b, double tolerance,
                                bat_work *work, bat_meetings *out)
{
    bat_meetings found = {.nearest = {.distance = HUGE_VAL}};
    search s = {.trace = {a, b}, .tolerance = tolerance, .out = &found};
    batten_status status = descend_pairs(&s);
    if (status == BATTEN_OK && found.count == 0) {
        s.nearest = true;
        status = descend_pairs(&s);
    }
    if (status == BATTEN_OK)
        status = bat_work_step(work, (uint64_t)s.looked, 0.1, "crossings");
    if (status == BATTEN_OK)
        *out = found;
    return status;
}
