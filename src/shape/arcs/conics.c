/* Conics through points of the plane with tangents and curvatures. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "shape/local/hermite_data.h"
#include "spline/chain/chain.h"
#include "spline/data_check.h"
#include <batten/arcs.h>

#include <string.h>

enum { SPAN_PIECES = 8 };

/* Legs and weights beyond these do not make a conic that anybody means. */
static const double longest_leg = 20, most_weight = 50;

/* A conic arc: its ends, where the tangents meet, and the weight there. */
typedef struct {
    double a[2], b[2], c[2], w;
} conic_piece;

/* Two points with directions of length 1, angles from the chord, and curvatures. */
typedef struct {
    const double *start, *end, *t0, *t1;
    double l, alpha, beta, k0, k1;
} conic_span;

typedef struct {
    int count;
    const double *points;
    const batten_curve_conics_options *options;
    double *units;      /* [count][2] */
    double *curvatures; /* [count] */
    int piece_count;
    conic_piece *pieces;
    int *first; /* [spans + 1] pieces */
    batten_curve_conics_report report;
} conic_fit;

batten_curve_conics_options batten_curve_conics_defaults(void)
{
    return (batten_curve_conics_options){.size = sizeof(batten_curve_conics_options)};
}

static double cross(const double *u, const double *v)
{
    return u[0] * v[1] - u[1] * v[0];
}

static void along(const double *a, double l, const double *unit, double *out)
{
    out[0] = a[0] + l * unit[0];
    out[1] = a[1] + l * unit[1];
}

static void between(const double *a, const double *b, double share, double *out)
{
    out[0] = a[0] + share * (b[0] - a[0]);
    out[1] = a[1] + share * (b[1] - a[1]);
}

/* ---- one conic ---- */

/* The curvature that a weight of 1 would give at the start, or the end. */
static double curvature_of_parabola(const conic_piece *p, bool at_end)
{
    const double u[2] = {p->b[0] - p->a[0], p->b[1] - p->a[1]};
    const double v[2] = {p->c[0] - p->b[0], p->c[1] - p->b[1]};
    const double leg = bat_norm(2, at_end ? v : u);
    return cross(u, v) / leg / leg / leg / 2;
}

static double curvature_of(const conic_piece *p, bool at_end)
{
    const double k = curvature_of_parabola(p, at_end) / p->w / p->w;
    return isfinite(k) ? k : 0; /* a line has legs but no area; its curvature is 0 */
}

/* The weight with which a conic has a curvature; 0 when none has. */
static double weight_for(const conic_piece *p, bool at_end, double k)
{
    const double w = sqrt(curvature_of_parabola(p, at_end) / k);
    return w >= 1 / most_weight && w <= most_weight ? w : 0;
}

/* That of a circle where the legs are equal; below 1 always. */
static double usual_weight(const conic_piece *p)
{
    return bat_distance(2, p->a, p->c) /
           (bat_distance(2, p->a, p->b) + bat_distance(2, p->b, p->c));
}

static void add_conic(conic_fit *t, const conic_piece *p)
{
    t->pieces[t->piece_count++] = *p;
}

static void fall_back(conic_fit *t, int i)
{
    if (t->report.fallen_back++ == 0)
        t->report.first_fallen_back = i;
}

/* ---- a C ---- */

/* Where the tangents meet, as legs; false when that is too far. */
static bool find_legs(const conic_span *s, double *start, double *end)
{
    const double turn = fabs(s->alpha) + fabs(s->beta);
    *start = s->l * sin(fabs(s->beta)) / sin(turn);
    *end = s->l * sin(fabs(s->alpha)) / sin(turn);
    return s->alpha * s->beta < 0 && turn < BAT_PI &&
           bat_max(*start, *end) <= longest_leg * s->l &&
           bat_min(*start, *end) * longest_leg >= bat_max(*start, *end);
}

static void add_single(conic_fit *t, const conic_span *s, double leg)
{
    conic_piece p = {.w = 1};
    memcpy(p.a, s->start, sizeof p.a);
    along(s->start, leg, s->t0, p.b);
    memcpy(p.c, s->end, sizeof p.c);
    p.w = t->options->kind == BATTEN_CONICS_SINGLE && t->options->weight > 0
              ? t->options->weight
              : usual_weight(&p);
    add_conic(t, &p);
}

/* Both conics of a pair with their joint at `nu` from A to B; weights of 1. */
static void make_pair(const conic_span *s, double a, double b, double nu, conic_piece out[2])
{
    out[0] = out[1] = (conic_piece){.w = 1};
    memcpy(out[0].a, s->start, sizeof out[0].a);
    along(s->start, a, s->t0, out[0].b);
    along(s->end, -b, s->t1, out[1].b);
    between(out[0].b, out[1].b, nu, out[0].c);
    memcpy(out[1].a, out[0].c, sizeof out[1].a);
    memcpy(out[1].c, s->end, sizeof out[1].c);
}

/* The pair with both curvatures; false when there is none. A single conic with these tangents
 * has the curvature k0 with one weight, k1 with another. When they are the same, the conic
 * meets its own subdivision in the middle at w / (1 + w) of both legs. */
static bool find_pair(const conic_fit *t, const conic_span *s, double leg0, double leg1,
                      conic_piece out[2])
{
    conic_piece whole = {.w = 1};
    memcpy(whole.a, s->start, sizeof whole.a);
    along(s->start, leg0, s->t0, whole.b);
    memcpy(whole.c, s->end, sizeof whole.c);
    const double w0 = weight_for(&whole, false, s->k0), w1 = weight_for(&whole, true, s->k1);
    if (w0 == 0 || w1 == 0)
        return false;
    const batten_curve_conics_options *o = t->options;
    const double lambda = o->start_share > 0 ? o->start_share : w0 / (1 + w0);
    const double mu = o->end_share > 0 ? o->end_share : w1 / (1 + w1);
    const double a = lambda * leg0, b = mu * leg1;
    /* Powers of lengths by the chord, so that none is too large. */
    const double x = cbrt(fabs(s->k0) * s->l) * a, y = cbrt(fabs(s->k1) * s->l) * b;
    make_pair(s, a, b, x / (x + y), out);
    out[0].w = weight_for(&out[0], false, s->k0);
    out[1].w = weight_for(&out[1], true, s->k1);
    return out[0].w > 0 && out[1].w > 0;
}

static void add_c(conic_fit *t, int i, const conic_span *s, double leg0, double leg1)
{
    const batten_curve_conics_options *o = t->options;
    conic_piece pair[2];
    if (o->kind == BATTEN_CONICS_SINGLE) {
        add_single(t, s, leg0);
        return;
    }
    if (o->kind == BATTEN_CONICS_PARABOLAS) {
        make_pair(s, leg0 * (o->start_share > 0 ? o->start_share : 0.5),
                  leg1 * (o->end_share > 0 ? o->end_share : 0.5), 0.5, pair);
    } else if (!find_pair(t, s, leg0, leg1, pair)) {
        fall_back(t, i);
        add_single(t, s, leg0);
        return;
    }
    add_conic(t, &pair[0]);
    add_conic(t, &pair[1]);
}

/* ---- an S ---- */

/* The joint on the chord and the direction there are those of the cubic function over the chord
 * with the same angles: it crosses at alpha / (alpha + beta), at the angle -alpha beta / (alpha
 * + beta). So each half is a C, and has a curvature at its point, but not at the joint. */
static void add_s(conic_fit *t, int i, const conic_span *s)
{
    const double share = s->alpha / (s->alpha + s->beta), gamma = -share * s->beta;
    const double chord[2] = {(s->end[0] - s->start[0]) / s->l,
                             (s->end[1] - s->start[1]) / s->l};
    const double c = cos(gamma), d = sin(gamma);
    const double T[2] = {c * chord[0] - d * chord[1], c * chord[1] + d * chord[0]};
    double joint[2], leg = 0, other = 0;
    between(s->start, s->end, share, joint);
    const conic_span first = {s->start, joint, s->t0, T, share * s->l, s->alpha, gamma, 0, 0};
    const conic_span second = {joint, s->end,  T, s->t1, (1 - share) * s->l,
                               gamma, s->beta, 0, 0};
    bool kept = true;
    t->report.inflections++;
    find_legs(&first, &leg, &other);
    add_single(t, &first, leg);
    find_legs(&second, &leg, &other);
    add_single(t, &second, leg);
    if (t->options->kind != BATTEN_CONICS_PAIRS)
        return;
    for (int k = 0; k < 2; k++) {
        conic_piece *p = &t->pieces[t->piece_count - 2 + k];
        const double w = weight_for(p, k == 1, k == 0 ? s->k0 : s->k1);
        p->w = w > 0 ? w : p->w;
        kept = kept && w > 0;
    }
    if (!kept)
        fall_back(t, i);
}

/* ---- lines and arcs ---- */

static void add_line(conic_fit *t, const conic_span *s)
{
    conic_piece p = {.w = 1};
    memcpy(p.a, s->start, sizeof p.a);
    between(s->start, s->end, 0.5, p.b);
    memcpy(p.c, s->end, sizeof p.c);
    add_conic(t, &p);
}

/* An arc in parts of no more than a third of a turn. */
static void add_arc(conic_fit *t, const batten_span *arc, const double end[2])
{
    const double turn = arc->curvature[0] * arc->length;
    const int parts = bat_max_int(1, (int)ceil(fabs(turn) / (2 * BAT_PI / 3)));
    const double step = arc->length / parts, half = turn / parts / 2;
    const double leg = half == 0 ? step / 2 : step / 2 * (tan(half) / half);
    for (int i = 0; i < parts; i++) {
        const double angle = arc->angle + 2 * half * i;
        conic_piece p = {.w = cos(half)};
        bat_arc_at(arc, i * step, p.a);
        along(p.a, leg, (const double[]){cos(angle), sin(angle)}, p.b);
        bat_arc_at(arc, (i + 1) * step, p.c);
        if (i + 1 == parts)
            memcpy(p.c, end, sizeof p.c);
        add_conic(t, &p);
    }
}

static batten_status add_biarc(conic_fit *t, int i, const conic_span *s)
{
    batten_biarc biarc;
    const batten_status status =
        batten_biarc_between((batten_ray){s->start, s->t0}, (batten_ray){s->end, s->t1},
                             BATTEN_JOINT_AUTOMATIC, 0.5, &biarc);
    if (status != BATTEN_OK)
        return status;
    if (t->report.arcs++ == 0)
        t->report.first_arcs = i;
    for (int k = 0; k < biarc.count; k++)
        add_arc(t, &biarc.arcs[k], k + 1 == biarc.count ? s->end : biarc.joint);
    return BATTEN_OK;
}

/* ---- the spans ---- */

static conic_span span_at(const conic_fit *t, int i)
{
    const int j = (i + 1) % t->count;
    conic_span s = {.start = t->points + 2 * i,
                    .end = t->points + 2 * j,
                    .t0 = t->units + 2 * i,
                    .t1 = t->units + 2 * j,
                    .k0 = t->curvatures[i],
                    .k1 = t->curvatures[j]};
    const double chord[2] = {s.end[0] - s.start[0], s.end[1] - s.start[1]};
    s.l = bat_norm(2, chord);
    s.alpha = bat_turn(chord, s.t0);
    s.beta = bat_turn(chord, s.t1);
    return s;
}

static batten_status make_span(conic_fit *t, int i)
{
    const conic_span s = span_at(t, i);
    const double a = fabs(s.alpha), b = fabs(s.beta);
    double leg0 = 0, leg1 = 0;
    /* Directions are known to a few roundings of the coordinates. */
    const double size = bat_max(bat_largest(2, s.start), bat_largest(2, s.end));
    if (bat_max(a, b) <= 16 * DBL_EPSILON * (1 + size / s.l))
        add_line(t, &s);
    else if (find_legs(&s, &leg0, &leg1))
        add_c(t, i, &s, leg0, leg1);
    else if (s.alpha * s.beta > 0 && bat_max(a, b) < BAT_PI / 2 &&
             bat_min(a, b) * longest_leg >= bat_max(a, b))
        add_s(t, i, &s);
    else
        return add_biarc(t, i, &s);
    return BATTEN_OK;
}

static void measure_conics(conic_fit *t, int spans)
{
    batten_curve_conics_report *r = &t->report;
    r->least_weight = HUGE_VAL;
    for (int i = 0; i < t->piece_count; i++) {
        r->least_weight = bat_min(r->least_weight, t->pieces[i].w);
        r->largest_weight = bat_max(r->largest_weight, t->pieces[i].w);
    }
    for (int i = 0; i < spans; i++) {
        const int last = t->first[i + 1] - 1, next = t->first[i + 1] % t->piece_count;
        const double before = curvature_of(&t->pieces[last], true);
        const double after = curvature_of(&t->pieces[next], false);
        if (i + 1 < spans || t->options->closed)
            r->jump = bat_max(r->jump, fabs(after - before));
    }
}

/* ---- the curve ---- */

/* About the length of a piece, by its polygon. */
static double step_of(const conic_piece *p)
{
    return (bat_distance(2, p->a, p->b) + bat_distance(2, p->b, p->c) +
            bat_distance(2, p->a, p->c)) /
           2;
}

static batten_status make_curve(const conic_fit *t, double *steps, batten_curve **out)
{
    const int m = t->piece_count;
    const size_t n = 2 * (size_t)m + 1;
    double *points = bat_array(2 * n, sizeof *points);
    double *weights = bat_array(n, sizeof *weights);
    double *knots = bat_array(n + 3, sizeof *knots);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (points && weights && knots) {
        knots[0] = knots[1] = knots[2] = 0;
        for (int i = 0; i < m; i++) {
            memcpy(points + 4 * i, t->pieces[i].a, 2 * sizeof *points);
            memcpy(points + 4 * i + 2, t->pieces[i].b, 2 * sizeof *points);
            weights[2 * i] = 1;
            weights[2 * i + 1] = t->pieces[i].w;
            knots[2 * i + 3] = knots[2 * i + 4] = steps[i + 1];
        }
        memcpy(points + 4 * m, t->pieces[m - 1].c, 2 * sizeof *points);
        weights[2 * m] = 1;
        knots[2 * m + 3] = steps[m];
        status =
            batten_curve_create((batten_points){2, 2 * m + 1, points}, 2, weights, knots, out);
    }
    bat_release(points);
    bat_release(weights);
    bat_release(knots);
    return status;
}

static batten_status emit(const conic_fit *t, int spans, double *parameters, batten_curve **out)
{
    double *steps = bat_array((size_t)t->piece_count + 1, sizeof *steps);
    if (!steps)
        return BATTEN_OUT_OF_MEMORY;
    steps[0] = 0;
    for (int i = 0; i < t->piece_count; i++)
        steps[i + 1] = steps[i] + step_of(&t->pieces[i]);
    const batten_status status = make_curve(t, steps, out);
    for (int i = 0; status == BATTEN_OK && parameters && i <= spans; i++)
        parameters[i] = steps[t->first[i]];
    bat_release(steps);
    return status;
}

/* ---- the data ---- */

static batten_status check_conic_data(int count, const double *points,
                                      const batten_curve_conics_options *o)
{
    batten_status status = bat_points_check(2, count, points, o->closed ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < (o->closed ? count : count - 1); i++)
        if (bat_distance(2, points + 2 * i, points + 2 * ((i + 1) % count)) == 0)
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i, (i + 1) % count);
    const double shares[] = {o->start_share, o->end_share};
    for (int k = 0; k < 2; k++)
        if (!(shares[k] >= 0 && shares[k] < 1))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the share of a leg is %g; it must be in [0, 1)", shares[k]);
    if (!(o->weight >= 0 && o->weight <= most_weight))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the weight is %g; it must be in [0, %g]",
                        o->weight, most_weight);
    return BATTEN_OK;
}

static batten_status find_tangents(conic_fit *t)
{
    const batten_curve_conics_options *o = t->options;
    const size_t n = (size_t)t->count;
    batten_status status = BATTEN_OK;
    if (!o->tangents) {
        batten_tangents_options rule = batten_tangents_defaults();
        rule.closed = o->closed;
        double *parameters = bat_array(n + 1, sizeof *parameters);
        status = parameters ? batten_tangents((batten_points){2, t->count, t->points}, &rule,
                                              parameters, NULL, t->units, NULL)
                            : BATTEN_OUT_OF_MEMORY;
        bat_release(parameters);
    } else {
        memcpy(t->units, o->tangents, 2 * n * sizeof *t->units);
        status = bat_local_check_rows(2, t->count, t->units, "tangent");
    }
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        double *u = t->units + 2 * i;
        if (bat_largest(2, u) == 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at point %d has no length", i);
        bat_direction(2, u, u);
    }
    return status;
}

static batten_status find_curvatures(conic_fit *t)
{
    const batten_curve_conics_options *o = t->options;
    if (o->kind != BATTEN_CONICS_PAIRS)
        memset(t->curvatures, 0, (size_t)t->count * sizeof *t->curvatures);
    else if (!o->curvatures)
        return batten_circle_curvatures((batten_points){2, t->count, t->points}, o->closed,
                                        t->curvatures);
    else
        memcpy(t->curvatures, o->curvatures, (size_t)t->count * sizeof *t->curvatures);
    const size_t bad = bat_first_not_finite(t->curvatures, (size_t)t->count);
    return bad < (size_t)t->count
               ? bat_fail(BATTEN_NOT_FINITE, "the curvature at point %zu is not finite", bad)
               : BATTEN_OK;
}

static batten_status allocate(conic_fit *t, int spans)
{
    const size_t n = (size_t)t->count;
    t->units = bat_array(2 * n, sizeof *t->units);
    t->curvatures = bat_array(n, sizeof *t->curvatures);
    t->pieces = bat_array3((size_t)spans, SPAN_PIECES, sizeof *t->pieces);
    t->first = bat_array((size_t)spans + 1, sizeof *t->first);
    return t->units && t->curvatures && t->pieces && t->first ? BATTEN_OK
                                                              : BATTEN_OUT_OF_MEMORY;
}

batten_status batten_curve_conics(batten_points points,
                                  const batten_curve_conics_options *options,
                                  double *parameters, batten_curve_conics_report *report,
                                  batten_curve **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_curve_conics_options chosen = batten_curve_conics_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_conics_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    conic_fit t = {.count = points.count, .points = points.at, .options = &chosen};
    t.report.first_arcs = t.report.first_fallen_back = -1;
    status = check_conic_data(points.count, points.at, t.options);
    const int spans = t.options->closed ? points.count : points.count - 1;
    if (status == BATTEN_OK)
        status = allocate(&t, spans);
    if (status == BATTEN_OK)
        status = find_tangents(&t);
    if (status == BATTEN_OK)
        status = find_curvatures(&t);
    for (int i = 0; i < spans && status == BATTEN_OK; i++) {
        t.first[i] = t.piece_count;
        status = make_span(&t, i);
        t.first[i + 1] = t.piece_count;
    }
    if (status == BATTEN_OK)
        status = emit(&t, spans, parameters, out);
    if (status == BATTEN_OK && report) {
        measure_conics(&t, spans);
        *report = t.report;
    }
    bat_release(t.units);
    bat_release(t.curvatures);
    bat_release(t.pieces);
    bat_release(t.first);
    return status;
}
