/* Splines after Spiro: from points to the equations, and from their solution to a chain. */
#include "shape/bent/spiro.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/bent/spiral.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

enum { N = BAT_SPIRO_UNKNOWNS };

batten_chain_spiro_options batten_chain_spiro_defaults(void)
{
    return (batten_chain_spiro_options){.size = sizeof(batten_chain_spiro_options),
                                        .max_steps = 200};
}

/* ---- what is asked ---- */

static batten_status check_end(const char *name, const batten_spiro_end *end)
{
    if ((end->has_tangent && !isfinite(end->tangent)) ||
        (end->has_curvature && !isfinite(end->curvature)))
        return bat_fail(BATTEN_NOT_FINITE, "what is given at the %s is not finite", name);
    return BATTEN_OK;
}

static batten_status check_spiro_data(int count, const double *points,
                                      const batten_chain_spiro_options *options)
{
    if (options->max_steps < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d step%s; at least 1 is needed",
                        options->max_steps, bat_plural(options->max_steps));
    batten_status status = bat_points_check(2, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("start", &options->start);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("end", &options->end);
    for (int i = 0; options->kinds && i < count && status == BATTEN_OK; i++)
        if ((int)options->kinds[i] < 0 || options->kinds[i] > BATTEN_SPIRO_RIGHT)
            status = bat_fail(BATTEN_BAD_ARGUMENT, "point %d is of the unknown kind %d", i + 1,
                              (int)options->kinds[i]);
    return status;
}

/* ---- the task ---- */

typedef struct {
    bat_chord_polygon chords;
    batten_spiro_kind *kinds;   /* [count] */
    bool *straight;             /* [spans] */
    double *leaving, *arriving; /* [count] angles to begin with, from the chords after and
                                   before; NAN: not known yet */
    double *c;                  /* [spans][4] */
    bat_spiro_task task;
} spline;

static void spline_free(spline *s)
{
    bat_chord_polygon_end(&s->chords);
    bat_release(s->kinds);
    bat_release(s->straight);
    bat_release(s->leaving);
    bat_release(s->arriving);
    bat_release(s->c);
}

static batten_status spline_make(int count, const double *points,
                                 const batten_chain_spiro_options *options, spline *s)
{
    const batten_status status =
        bat_chord_polygon_make(count, points, options->closed, &s->chords);
    if (status != BATTEN_OK)
        return status;
    s->kinds = bat_array((size_t)count, sizeof *s->kinds);
    s->straight = bat_array((size_t)s->chords.spans, sizeof *s->straight);
    s->leaving = bat_array((size_t)count, sizeof *s->leaving);
    s->arriving = bat_array((size_t)count, sizeof *s->arriving);
    s->c = bat_array3((size_t)s->chords.spans, N, sizeof *s->c);
    if (!s->kinds || !s->straight || !s->leaving || !s->arriving || !s->c)
        return BATTEN_OUT_OF_MEMORY;
    if (options->kinds)
        memcpy(s->kinds, options->kinds, (size_t)count * sizeof *s->kinds);
    s->task = (bat_spiro_task){&s->chords, s->kinds, s->straight, {{0}}};
    return BATTEN_OK;
}

/* What is given at an end, as the task wants it. */
static batten_spiro_end relative(const spline *s, const batten_spiro_end *given, int span)
{
    const double *q = s->chords.vector + 2 * (size_t)span;
    batten_spiro_end end = *given;
    end.tangent = remainder(given->tangent - bat_atan2(q[1], q[0]), 2 * BAT_PI);
    end.curvature *= s->chords.unit;
    return end;
}

/* Does the curve end freely at point i, on the side of the span that leaves it (or else of the
 * span that arrives)? */
static bool is_free(const spline *s, int i, bool leaving)
{
    const bat_chord_polygon *p = &s->chords;
    if (!p->closed && (i == 0 || i == p->count - 1)) {
        const batten_spiro_end *end = &s->task.ends[i > 0];
        return !end->has_tangent && !end->has_curvature;
    }
    return s->kinds[i] == BATTEN_SPIRO_CORNER ||
           s->kinds[i] == (leaving ? BATTEN_SPIRO_RIGHT : BATTEN_SPIRO_LEFT);
}

static batten_status prepare(const batten_chain_spiro_options *options, spline *s)
{
    const bat_chord_polygon *p = &s->chords;
    if (!p->closed) {
        s->task.ends[0] = relative(s, &options->start, 0);
        s->task.ends[1] = relative(s, &options->end, p->spans - 1);
    }
    for (int j = 0; j < p->spans; j++)
        s->straight[j] = is_free(s, j, true) && is_free(s, (j + 1) % p->count, false);
    for (int i = !p->closed; i < p->count - !p->closed; i++) {
        const batten_status status =
            s->kinds[i] == BATTEN_SPIRO_CORNER ? BATTEN_OK : bat_chord_polygon_check_turn(p, i);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* ---- where the search begins: Euler spirals between the tangents of circles ---- */

static void start_at_points(spline *s)
{
    const bat_chord_polygon *p = &s->chords;
    for (int i = 0; i < p->count; i++) {
        const bool end = !p->closed && (i == 0 || i == p->count - 1);
        const int before = (i + p->spans - 1) % p->spans;
        s->leaving[i] = s->arriving[i] = NAN;
        if (end && s->task.ends[i > 0].has_tangent)
            s->leaving[i] = s->arriving[i] = s->task.ends[i > 0].tangent;
        if (end ||
            (s->kinds[i] != BATTEN_SPIRO_SMOOTH && s->kinds[i] != BATTEN_SPIRO_CURVATURE))
            continue;
        s->leaving[i] = bat_circle_angle(p->length[before], p->length[i], p->turn[i]);
        s->arriving[i] = s->leaving[i] + p->turn[i];
    }
}

/* An end without a tangent begins as that of a circle, or of a line where the other end of its
 * span waits too; who follows one way takes over. */
static void start_at_ends(spline *s)
{
    const bat_chord_polygon *p = &s->chords;
    for (int j = 0; j < p->spans; j++) {
        const int next = (j + 1) % p->count;
        double *from = &s->leaving[j], *to = &s->arriving[next];
        const bool follows = s->kinds[j] == BATTEN_SPIRO_LEFT && (p->closed || j > 0);
        const bool leads =
            s->kinds[next] == BATTEN_SPIRO_RIGHT && (p->closed || next < p->count - 1);
        if (isnan(*from) && !follows)
            *from = isnan(*to) ? 0 : -*to;
        if (isnan(*to) && !leads)
            *to = isnan(*from) ? 0 : -*from;
    }
    for (int i = 0; i < p->count; i++) {
        if (isnan(s->leaving[i]))
            s->leaving[i] = s->arriving[i] - p->turn[i];
        if (isnan(s->arriving[i]))
            s->arriving[i] = s->leaving[i] + p->turn[i];
    }
}

static void find_start_angles(spline *s)
{
    const bat_chord_polygon *p = &s->chords;
    start_at_points(s);
    start_at_ends(s);
    for (int j = 0; j < p->spans; j++) {
        const double alpha = s->leaving[j], beta = s->arriving[(j + 1) % p->count];
        double *c = s->c + (size_t)j * N;
        bat_clothoid spiral;
        if (s->straight[j])
            continue;
        /* Where there is no spiral a circle that turns as much will do. */
        const bool found = bat_clothoid_solve(alpha, beta, &spiral) == BATTEN_OK;
        c[1] = found ? spiral.A : 0;
        c[0] = beta - alpha - c[1];
    }
}

/* ---- the chain ---- */

static void make_span(const spline *s, int j, const double *point, batten_span *span,
                      batten_chain_spiro_report *report)
{
    const bat_chord_polygon *p = &s->chords;
    static const double line[N] = {0};
    const double *c = s->straight[j] ? line : s->c + (size_t)j * N;
    const double *q = p->vector + 2 * (size_t)j;
    const double chord = bat_norm(2, q);
    double bending, variation;
    bat_spiro_span at;
    bat_spiro_span_at(c, chord, &at);
    bat_spiro_span_energies(c, &at, chord, &bending, &variation);
    report->bending += bending;
    report->variation += variation;
    report->straight += s->straight[j];
    const double l = chord / at.chord;
    *span = (batten_span){.kind = s->straight[j] ? BATTEN_SPAN_ARC : BATTEN_SPAN_SPIRAL,
                          .length = l,
                          .angle = at.value[0][0]};
    for (int k = 0; k < 3; k++)
        span->curvature[k] = at.value[0][k + 1];
    span->curvature[3] = 24 * c[3] / l / l / l / l;
    bat_chord_put(q, point, span);
}

static batten_status emit(const spline *s, const double *points, double *parameters,
                          batten_chain_spiro_report *report, batten_chain **out)
{
    const bat_chord_polygon *p = &s->chords;
    batten_span *spans = bat_array((size_t)p->spans, sizeof *spans);
    double *breaks = bat_array((size_t)p->spans + 1, sizeof *breaks);
    batten_status status = spans && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < p->spans && status == BATTEN_OK; j++) {
        make_span(s, j, points + 2 * (size_t)j, &spans[j], report);
        breaks[j + 1] = breaks[j] + spans[j].length;
    }
    /* The angles are solved to about 1e-12. */
    const double tolerance = 1e-11 * p->unit + 16 * DBL_EPSILON * p->size;
    if (status == BATTEN_OK)
        status = batten_chain_create(
            &(batten_chain_parts){2, p->spans, spans, breaks, p->closed}, tolerance, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, breaks, (size_t)p->count * sizeof *breaks);
    bat_release(spans);
    bat_release(breaks);
    return status;
}

/* ---- the whole ---- */

static batten_status make_spiro(int count, const double *points,
                                const batten_chain_spiro_options *options, double *parameters,
                                spline *s, batten_chain_spiro_report *report,
                                batten_chain **out)
{
    batten_status status = spline_make(count, points, options, s);
    if (status == BATTEN_OK)
        status = prepare(options, s);
    if (status == BATTEN_OK) {
        find_start_angles(s);
        status = bat_spiro_solve(&s->task, options->max_steps, s->c, report);
    }
    if (status == BATTEN_OK)
        status = emit(s, points, parameters, report, out);
    return status;
}

batten_status batten_chain_spiro(batten_points points,
                                 const batten_chain_spiro_options *options, double *parameters,
                                 batten_chain_spiro_report *report, batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_chain_spiro_options chosen = batten_chain_spiro_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_spiro_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    batten_chain_spiro_report reached = {0};
    spline s = {.kinds = NULL};
    status = check_spiro_data(points.count, points.at, options);
    if (status == BATTEN_OK)
        status = make_spiro(points.count, points.at, options, parameters, &s, &reached, out);
    if (status == BATTEN_OK && report) {
        reached.curvature /= s.chords.unit;
        reached.turn = bat_chord_polygon_sharpest(&s.chords, &reached.turn_at);
        *report = reached;
    }
    spline_free(&s);
    return status;
}
