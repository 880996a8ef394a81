/* Conics through points of the plane with tangents and curvatures. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"
#include "shape/arcs/conic_spans.h"
#include "shape/local/hermite_data.h"
#include "spline/data_check.h"
#include <batten/arcs.h>

#include <string.h>

enum { SPAN_PIECES = 8 };

batten_curve_conics_options batten_curve_conics_defaults(void)
{
    return (batten_curve_conics_options){.size = sizeof(batten_curve_conics_options)};
}

/* ---- the spans ---- */

static bat_conic_span span_at(const bat_conic_fit *t, int i)
{
    const int j = (i + 1) % t->count;
    bat_conic_span s = {.start = t->points + 2 * i,
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

static batten_status make_span(bat_conic_fit *t, int i)
{
    const bat_conic_span s = span_at(t, i);
    const double a = fabs(s.alpha), b = fabs(s.beta);
    double leg0 = 0, leg1 = 0;
    /* Directions are known to a few roundings of the coordinates. */
    const double size = bat_max(bat_largest(2, s.start), bat_largest(2, s.end));
    if (bat_max(a, b) <= 16 * DBL_EPSILON * (1 + size / s.l))
        bat_conic_add_line(t, &s);
    else if (bat_conic_find_legs(&s, &leg0, &leg1))
        bat_conic_add_c(t, i, &s, leg0, leg1);
    else if (s.alpha * s.beta > 0 && bat_max(a, b) < BAT_PI / 2 &&
             bat_min(a, b) * bat_conic_longest_leg >= bat_max(a, b))
        bat_conic_add_s(t, i, &s);
    else
        return bat_conic_add_biarc(t, i, &s);
    return BATTEN_OK;
}

/* Of the curvature, from a span to the next. */
static double jump_after(const bat_conic_fit *t, int span)
{
    const int next = t->first[span + 1];
    const double before = bat_conic_curvature(&t->pieces[next - 1], true);
    return fabs(bat_conic_curvature(&t->pieces[next % t->piece_count], false) - before);
}

static void measure_conics(bat_conic_fit *t, int spans)
{
    batten_curve_conics_report *r = &t->report;
    r->least_weight = HUGE_VAL;
    for (int i = 0; i < t->piece_count; i++) {
        r->least_weight = bat_min(r->least_weight, t->pieces[i].w);
        r->largest_weight = bat_max(r->largest_weight, t->pieces[i].w);
    }
    for (int i = 0; i + !t->options->closed < spans; i++)
        r->jump = bat_max(r->jump, jump_after(t, i));
}

/* ---- the curve ---- */

/* About the length of a piece, by its polygon. */
static double step_of(const bat_conic_piece *p)
{
    return (bat_distance(2, p->a, p->b) + bat_distance(2, p->b, p->c) +
            bat_distance(2, p->a, p->c)) /
           2;
}

static batten_status make_curve(const bat_conic_fit *t, double *steps, batten_curve **out)
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

static batten_status emit(const bat_conic_fit *t, int spans, double *parameters,
                          batten_curve **out)
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
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i + 1,
                            (i + 1) % count + 1);
    const double shares[] = {o->start_share, o->end_share};
    for (int k = 0; k < 2; k++)
        if (!(shares[k] >= 0 && shares[k] < 1))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the share of a leg is %g; it must be in [0, 1)", shares[k]);
    if (!(o->weight >= 0 && o->weight <= bat_conic_most_weight))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the weight is %g; it must be in [0, %g]",
                        o->weight, bat_conic_most_weight);
    return BATTEN_OK;
}

static batten_status find_tangents(bat_conic_fit *t)
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
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at point %d has no length",
                            i + 1);
        bat_direction(2, u, u);
    }
    return status;
}

static batten_status find_curvatures(bat_conic_fit *t)
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
               ? bat_fail(BATTEN_NOT_FINITE, "the curvature at point %zu is not finite",
                          bad + 1)
               : BATTEN_OK;
}

static batten_status allocate(bat_conic_fit *t, int spans)
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
    bat_conic_fit t = {.count = points.count, .points = points.at, .options = &chosen};
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
