/*
 * Mehlum's arcs: the elastica through points as a chain of arcs whose curvature goes in steps.
 *
 * Between two points of the elastica the arcs have equal lengths h. When the directions at
 * their ends are those of the elastica, each arc is on average k' h^2 / 12 ahead of its
 * direction, and the chain drifts off by the second power of h. So inside a span the directions
 * are taken that much back; at its ends they are those of the elastica, where spans join. What
 * is then missing at the end of the span, of the third power, is put right by two unknowns: a
 * scale of all lengths, and a bend that turns the first half one way and the second the other.
 */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "spline/chain/chain.h"
#include "spline/data_check.h"
#include <batten/bent.h>

enum { MOST_ARCS = 10000 };

/* One span: the elastica, where it ends, and its arcs. */
typedef struct {
    const batten_span *elastica;
    const double *start, *end; /* points */
    int count;
    double *turns; /* [count] */
    double scale,
        bend; /* of lengths; by how much the last arc turns more, the first one less */
    double deviation, at;
} mehlum;

typedef struct {
    int count, spans, arcs;
    const double *points;
    const batten_chain_mehlum_options *options;
    const batten_chain *elastica;
    double *turns;
    int capacity;
    batten_span *made;
    int *first; /* [spans + 1] arcs */
    batten_chain_mehlum_report report;
} mehlum_fit;

batten_chain_mehlum_options batten_chain_mehlum_defaults(void)
{
    return (batten_chain_mehlum_options){.size = sizeof(batten_chain_mehlum_options),
                                         .arcs = 4};
}

/* ---- one span ---- */

static void find_turns(mehlum *m)
{
    const batten_span *e = m->elastica;
    const double h = e->length / m->count;
    double before = 0;
    for (int i = 1; i <= m->count; i++) {
        bat_elastica at;
        bat_elastica_at(e->curvature[0], e->curvature[1], i * h, &at);
        const double back = i < m->count ? at.slope * h * h / 12 : 0;
        m->turns[i - 1] = at.turn - back - before;
        before = at.turn - back;
    }
    m->scale = 1;
    m->bend = 0;
}

/* How much of the bend an arc takes: from -1 to 1, 0 in all. */
static double share_of(const mehlum *m, int i)
{
    return (2.0 * i - (m->count - 1)) / (m->count - 1);
}

/* sin x / x and its derivative. */
static double sine_quotient(double x, double *rate)
{
    if (fabs(x) < 1e-4) {
        *rate = -x / 3;
        return 1 - x * x / 6;
    }
    const double q = bat_sin(x) / x;
    *rate = (bat_cos(x) - q) / x;
    return q;
}

/* The end of the arcs, from their start, and how the bend moves it. */
static void find_end(const mehlum *m, double end[2], double by_bend[2])
{
    const double h = m->scale * m->elastica->length / m->count;
    double angle = m->elastica->angle, turned = 0; /* by the bend, for each unit of it */
    end[0] = end[1] = by_bend[0] = by_bend[1] = 0;
    for (int i = 0; i < m->count; i++) {
        const double share = share_of(m, i), half = (m->turns[i] + m->bend * share) / 2;
        double rate = 0;
        const double chord = h * sine_quotient(half, &rate);
        const double c = bat_cos(angle + half), s = bat_sin(angle + half),
                     sweep = turned + share / 2;
        end[0] += chord * c;
        end[1] += chord * s;
        by_bend[0] += h * rate * share / 2 * c - chord * s * sweep;
        by_bend[1] += h * rate * share / 2 * s + chord * c * sweep;
        angle += 2 * half;
        turned += share;
    }
}

/* Newton's rule for the scale and the bend; false when it does not settle. */
static bool fit(mehlum *m, double rounding)
{
    enum { STEPS = 20 };
    const double goal[2] = {m->end[0] - m->start[0], m->end[1] - m->start[1]};
    for (int i = 0; i < STEPS; i++) {
        double end[2], b[2];
        find_end(m, end, b);
        const double by[2] = {goal[0] - end[0], goal[1] - end[1]};
        if (bat_norm(2, by) <= rounding)
            return true;
        /* The scale moves the end along itself. */
        const double a[2] = {end[0] / m->scale, end[1] / m->scale};
        const double det = a[0] * b[1] - a[1] * b[0];
        m->scale += (by[0] * b[1] - by[1] * b[0]) / det;
        m->bend += (a[0] * by[1] - a[1] * by[0]) / det;
        if (!(m->scale > 0.5 && m->scale < 2 && fabs(m->bend) < BAT_PI))
            return false;
    }
    return false;
}

static void put_arcs(const mehlum *m, batten_span *out)
{
    const double h = m->scale * m->elastica->length / m->count;
    double angle = m->elastica->angle, from[2] = {m->start[0], m->start[1]};
    for (int i = 0; i < m->count; i++) {
        const double turn = m->turns[i] + m->bend * share_of(m, i);
        out[i] = (batten_span){.kind = BATTEN_SPAN_ARC,
                               .length = h,
                               .start = {from[0], from[1]},
                               .angle = angle,
                               .curvature = {turn / h}};
        bat_arc_at(&out[i], h, from);
        angle += turn;
    }
}

/* How far a point is from the elastica, whose place next to it is near s. */
static double distance(const batten_span *e, const double point[2], double s)
{
    const double c = bat_cos(e->angle), d = bat_sin(e->angle);
    const double p[2] = {point[0] - e->start[0], point[1] - e->start[1]};
    const double q[2] = {c * p[0] + d * p[1], c * p[1] - d * p[0]};
    bat_elastica at;
    for (int i = 0; i < 4; i++) {
        bat_elastica_at(e->curvature[0], e->curvature[1], bat_max(0, bat_min(s, e->length)),
                        &at);
        s += (q[0] - at.point[0]) * at.tangent[0] + (q[1] - at.point[1]) * at.tangent[1];
    }
    return bat_distance(2, q, at.point);
}

static void measure_chain(mehlum *m, const batten_span *arcs)
{
    enum { LOOKS = 8 };
    const double h = m->elastica->length / m->count;
    m->deviation = 0;
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < LOOKS; k++) {
            double point[2];
            const double share = (k + 0.5) / LOOKS;
            bat_arc_at(&arcs[i], share * arcs[i].length, point);
            const double off = distance(m->elastica, point, (i + share) * h);
            if (off > m->deviation) {
                m->deviation = off;
                m->at = (i + share) / m->count;
            }
        }
}

/* ---- all spans ---- */

static batten_status reserve(mehlum_fit *t, int arcs)
{
    if (t->arcs + arcs <= t->capacity)
        return BATTEN_OK;
    const int capacity = t->arcs + bat_max_int(2 * arcs, t->capacity);
    batten_span *made = bat_resize(t->made, (size_t)capacity, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    t->made = made;
    double *turns = bat_resize(t->turns, (size_t)capacity, sizeof *turns);
    if (!turns)
        return BATTEN_OUT_OF_MEMORY;
    t->turns = turns;
    t->capacity = capacity;
    return BATTEN_OK;
}

static batten_status make_span(mehlum_fit *t, mehlum *m, int index)
{
    const batten_status status = reserve(t, m->count);
    if (status != BATTEN_OK)
        return status;
    m->turns = t->turns;
    const double size = bat_max(bat_largest(2, m->start), bat_largest(2, m->end));
    find_turns(m);
    if (!fit(m, 16 * DBL_EPSILON * (size + m->elastica->length)))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d arc%s cannot follow the elastica after point %d: take more",
                        m->count, bat_plural(m->count), index + 1);
    put_arcs(m, t->made + t->arcs);
    measure_chain(m, t->made + t->arcs);
    return BATTEN_OK;
}

/* As many arcs as are asked for, or as the tolerance takes. Where rounding keeps the deviation
 * from falling, single arcs would be added for ever: after some rounds, more and more. */
static batten_status find_span(mehlum_fit *t, mehlum *m, int index)
{
    const double tolerance = t->options->tolerance;
    m->count = t->options->arcs;
    batten_status status = make_span(t, m, index);
    for (int round = 0; tolerance > 0 && (status == BATTEN_TOLERANCE_NOT_MET ||
                                          (status == BATTEN_OK && m->deviation > tolerance));
         round++) {
        const double factor = status == BATTEN_OK ? bat_cbrt(m->deviation / tolerance) : 2;
        const double more = bat_max(m->count + ldexp(1, bat_max_int(0, round - 4)),
                                    ceil(0.98 * factor * m->count));
        if (more > MOST_ARCS)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "more than %d arcs are needed after point %d for a tolerance of %g",
                            MOST_ARCS, index + 1, tolerance);
        m->count = (int)more;
        status = make_span(t, m, index);
    }
    return status;
}

static void count_in(mehlum_fit *t, const mehlum *m, int index)
{
    batten_chain_mehlum_report *r = &t->report;
    for (int i = bat_max_int(1, t->arcs); i < t->arcs + m->count; i++)
        r->jump = bat_max(r->jump, fabs(t->made[i].curvature[0] - t->made[i - 1].curvature[0]));
    if (m->deviation > r->error) {
        r->error = m->deviation;
        r->at = index + m->at;
    }
    t->arcs += m->count;
}

static batten_status make_all(mehlum_fit *t)
{
    for (int i = 0; i < t->spans; i++) {
        mehlum m = {.elastica = batten_chain_span(t->elastica, i),
                    .start = t->points + 2 * i,
                    .end = t->points + 2 * ((i + 1) % t->count)};
        const batten_status status = find_span(t, &m, i);
        if (status != BATTEN_OK)
            return status;
        count_in(t, &m, i);
        t->first[i + 1] = t->arcs;
    }
    t->report.arcs = t->arcs;
    return BATTEN_OK;
}

static batten_status check_mehlum_options(const batten_chain_mehlum_options *o)
{
    if (o->arcs < 2 || o->arcs > MOST_ARCS)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d arcs for each span; there must be 2 to %d: one arc has no freedom",
                        o->arcs, (int)MOST_ARCS);
    if (!(o->tolerance >= 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be 0 or more",
                        o->tolerance);
    return BATTEN_OK;
}

static batten_status make_chain(const mehlum_fit *t, double *parameters, batten_chain **out)
{
    double *breaks = bat_array((size_t)t->arcs + 1, sizeof *breaks), longest = 0;
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    breaks[0] = 0;
    for (int i = 0; i < t->arcs; i++) {
        breaks[i + 1] = breaks[i] + t->made[i].length;
        longest = bat_max(longest, t->made[i].length);
    }
    const double size = bat_largest(2 * t->count, t->points) + t->arcs * longest;
    const batten_status status = batten_chain_create(
        &(batten_chain_parts){2, t->arcs, t->made, breaks, t->options->closed},
        64 * DBL_EPSILON * size, out);
    for (int i = 0; i < t->count && parameters && status == BATTEN_OK; i++)
        parameters[i] = breaks[t->first[i]];
    bat_release(breaks);
    return status;
}

static batten_status make_mehlum_chain(mehlum_fit *t, double *parameters, batten_chain **out)
{
    t->first = bat_array((size_t)t->spans + 1, sizeof *t->first);
    if (!t->first)
        return BATTEN_OUT_OF_MEMORY;
    t->first[0] = 0;
    const batten_status status = make_all(t);
    return status == BATTEN_OK ? make_chain(t, parameters, out) : status;
}

batten_status batten_chain_mehlum(batten_points points,
                                  const batten_chain_mehlum_options *options, double *angles,
                                  double *parameters, batten_chain_mehlum_report *report,
                                  batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_chain_mehlum_options chosen = batten_chain_mehlum_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_mehlum_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    mehlum_fit t = {.count = points.count, .points = points.at, .options = &chosen};
    const batten_chain_mehlum_options *o = t.options;
    batten_chain_nonlinear_options elastica = batten_chain_nonlinear_defaults();
    batten_chain *beam = NULL;
    elastica.family = BATTEN_FAMILY_ELASTICA;
    elastica.start = o->start;
    elastica.end = o->end;
    elastica.start_value = o->start_value;
    elastica.end_value = o->end_value;
    elastica.closed = o->closed;
    status = check_mehlum_options(o);
    if (status == BATTEN_OK)
        status = batten_chain_nonlinear((batten_points){2, points.count, points.at}, &elastica,
                                        angles, NULL, NULL, &beam);
    if (status == BATTEN_OK) {
        t.elastica = beam;
        t.spans = batten_chain_span_count(beam);
        status = make_mehlum_chain(&t, parameters, out);
    }
    if (status == BATTEN_OK && report)
        *report = t.report;
    batten_chain_unref(beam);
    bat_release(t.turns);
    bat_release(t.made);
    bat_release(t.first);
    return status;
}
