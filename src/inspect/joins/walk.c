/* The largest gap, angle and jumps of curvature and rate along an edge, each with its place. */
#include "inspect/joins/walk.h"

#include "numeric/vector.h"

/* Places of every span, and of all at least; steps towards a greatest value between them. */
enum { IN_SPAN = 8, AT_LEAST = 32, STEPS = 5 };
/* What is so much less than its bound is not followed. */
static const double worth_following = 1e-3;

enum { GAP, ANGLE, CURVATURE, RATE, CURVATURE_DIFFERENCE, RATE_DIFFERENCE, MEASURES };

bat_straight bat_straight_within(double gap, double size)
{
    return (bat_straight){gap / (size * size), gap / (size * size * size)};
}

/* The angle by which a way out of one shape turns on its way into the other. */
static double turn_between(batten_vec3 into_one, batten_vec3 into_other)
{
    const batten_vec3 out_of = bat_vec3_scale(into_one, -1);
    return bat_atan2(bat_vec3_norm(bat_vec3_cross(out_of, into_other)),
                     bat_vec3_dot(out_of, into_other));
}

static double part_of_larger(double difference, batten_vec3 a, batten_vec3 b, double straight)
{
    return difference / bat_max(bat_max(bat_vec3_norm(a), bat_vec3_norm(b)), straight);
}

void bat_meeting_compare(const bat_across *one, const bat_across *other,
                         const bat_straight *straight, bat_meeting *out)
{
    out->angle = turn_between(one->into, other->into);
    out->curvature_difference =
        bat_vec3_norm(bat_vec3_subtract(one->curvature, other->curvature));
    out->curvature = part_of_larger(out->curvature_difference, one->curvature, other->curvature,
                                    straight->curvature);
    /* On the way out of one the rate is that of the way in, reversed. */
    out->rate_difference = bat_vec3_norm(bat_vec3_add(one->rate, other->rate));
    out->rate = part_of_larger(out->rate_difference, one->rate, other->rate, straight->rate);
}

static double measure_of(const bat_meeting *m, int which)
{
    const double all[MEASURES] = {
        m->gap, m->angle, m->curvature, m->rate, m->curvature_difference, m->rate_difference};
    return all[which];
}

/* Where the largest of a measure was, and how far its neighbours are. */
typedef struct {
    batten_join_worst worst;
    int span;
    double t, step;
} largest;

typedef struct {
    const bat_edge_walk *walk;
    double gap; /* the bound */
    largest of[MEASURES];
} walker;

/* Keep what is larger than all before; NaN never is, and is replaced by any number. */
static void keep_largest(walker *w, const bat_meeting *m, int span, double t, double step)
{
    for (int k = 0; k < MEASURES; k++) {
        const double value = measure_of(m, k), before = w->of[k].worst.value;
        if (value > before || (isnan(before) && !isnan(value)))
            w->of[k] = (largest){{value, m->point}, span, t, step};
    }
}

static batten_status visit(walker *w, int span, double t, double step, bat_meeting *out)
{
    *out = (bat_meeting){NAN, NAN, NAN, NAN, NAN, NAN, {0, 0, 0}};
    const batten_status status = w->walk->meet(w->walk->context, span, t, out);
    if (status == BATTEN_OK)
        keep_largest(w, out, span, t, step);
    return status;
}

/* The place between low and high where the parabola through three values is greatest; never so near to the middle
 * that nothing is learned. */
static double top_of_parabola(const double t[3], const double value[3])
{
    const double left = t[1] - t[0], right = t[2] - t[1];
    const double a = left * left * (value[1] - value[2]),
                 b = right * right * (value[1] - value[0]);
    const double below = left * (value[1] - value[2]) + right * (value[1] - value[0]);
    const double move = below > 0 ? -0.5 * (a - b) / below : 0;
    const double least = 1e-3 * (t[2] - t[0]); /* of what brackets it */
    if (fabs(move) < least)
        return t[1] + (left > right ? -least : least);
    return bat_max(t[0] + 0.1 * left, bat_min(t[1] + move, t[2] - 0.1 * right));
}

/* Towards the greatest value of one measure beside its largest sample, within its span. */
static batten_status follow(walker *w, int which)
{
    const int span = w->of[which].span;
    const double low = w->walk->breaks[span], high = w->walk->breaks[span + 1];
    const double at = w->of[which].t, step = w->of[which].step;
    double t[3] = {at - step, at, at + step}, value[3];
    bat_meeting m;
    batten_status status = BATTEN_OK;
    if (!(t[0] >= low && t[2] <= high))
        return BATTEN_OK;
    for (int i = 0; i < 3 && status == BATTEN_OK; i++) {
        status = visit(w, span, t[i], step, &m);
        value[i] = measure_of(&m, which);
    }
    for (int i = 0; i < STEPS && status == BATTEN_OK && value[1] >= value[0] &&
                    value[1] >= value[2] && value[0] + value[2] < 2 * value[1];
         i++) {
        const double next = top_of_parabola(t, value);
        status = visit(w, span, next, step, &m);
        const double found = measure_of(&m, which);
        const bool is_left = next < t[1], is_higher = found >= value[1];
        const int end = is_left == is_higher ? 2 : 0; /* the end that falls away */
        if (is_higher) {
            t[end] = t[1];
            value[end] = value[1];
        }
        t[is_higher ? 1 : end] = next;
        value[is_higher ? 1 : end] = found;
    }
    return status;
}

static int order_of(const batten_join *join, const batten_curve_continuity_options *bounds)
{
    if (!(join->gap.value <= bounds->gap))
        return -1;
    if (!(join->angle.value <= bounds->angle))
        return 0;
    if (!(join->curvature.value <= bounds->curvature))
        return 1;
    return join->rate.value <= bounds->curvature ? 3 : 2;
}

static batten_status visit_all(walker *w)
{
    const int spans = w->walk->spans;
    const int steps = bat_max_int(IN_SPAN, spans > 0 ? AT_LEAST / spans : 0);
    batten_status status = BATTEN_OK;
    for (int i = 0;
         i < spans * (steps + 1) && status == BATTEN_OK && !(w->of[GAP].worst.value > w->gap);
         i++) {
        const int k = i / (steps + 1);
        const double share = (double)(i % (steps + 1)) / steps;
        const double low = w->walk->breaks[k], high = w->walk->breaks[k + 1];
        bat_meeting m;
        status = visit(w, k, (1 - share) * low + share * high, (high - low) / steps, &m);
    }
    return status;
}

batten_status bat_follow_edge(const bat_edge_walk *walk,
                              const batten_curve_continuity_options *bounds, batten_join *out)
{
    const double bound[4] = {bounds->gap, bounds->angle, bounds->curvature, bounds->curvature};
    walker w = {.walk = walk, .gap = bounds->gap};
    for (int k = 0; k < MEASURES; k++)
        w.of[k].worst = (batten_join_worst){NAN, {0, 0, 0}};
    batten_status status = visit_all(&w);
    for (int k = 0; k < MEASURES && status == BATTEN_OK && !(w.of[GAP].worst.value > w.gap);
         k++) {
        const int judge = k < 4 ? k : k - 2; /* differences by their parts */
        if (w.of[judge].worst.value > worth_following * bound[judge])
            status = follow(&w, k);
    }
    out->gap = w.of[GAP].worst;
    out->angle = w.of[ANGLE].worst;
    out->curvature = w.of[CURVATURE].worst;
    out->rate = w.of[RATE].worst;
    out->curvature_difference = w.of[CURVATURE_DIFFERENCE].worst.value;
    out->rate_difference = w.of[RATE_DIFFERENCE].worst.value;
    out->geometric = order_of(out, bounds);
    return status;
}
