/* Nonlinear splines: from points to the polygon's angles, and from tangents to a chain. */
#include <batten/bent.h>

#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/bent/two_angle.h"
#include "shape/points/chord_polygon.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_chain_nonlinear_options batten_chain_nonlinear_defaults(void)
{
    return (batten_chain_nonlinear_options){.size = sizeof(batten_chain_nonlinear_options),
                                            .family = BATTEN_FAMILY_EULER_SPIRAL,
                                            .max_steps = 50};
}

/* ---- the families ---- */

static const bat_span_family *const families[] = {
    [BATTEN_FAMILY_LOCAL_CUBIC] = &bat_family_local_cubic,
    [BATTEN_FAMILY_LOCAL_TENSION] = &bat_family_local_tension,
    [BATTEN_FAMILY_GEOMETRIC] = &bat_family_geometric,
    [BATTEN_FAMILY_EULER_SPIRAL] = &bat_family_euler_spiral,
    [BATTEN_FAMILY_ARCS] = &bat_family_arcs,
    [BATTEN_FAMILY_ELASTICA] = &bat_family_elastica,
    [BATTEN_FAMILY_HOBBY] = &bat_family_hobby,
};

static const bat_span_family *family_of(batten_span_family family)
{
    const size_t i = (size_t)family;
    return i < sizeof families / sizeof families[0] ? families[i] : NULL;
}

/* ---- what is asked ---- */

static batten_status check_end(const char *name, batten_nonlinear_end kind, double value)
{
    if ((int)kind < 0 || kind > BATTEN_NONLINEAR_CURVATURE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown end condition %d", (int)kind);
    if (kind >= BATTEN_NONLINEAR_TANGENT && !isfinite(value))
        return bat_fail(BATTEN_NOT_FINITE, "the value at the %s is %g", name, value);
    return BATTEN_OK;
}

static batten_status check_tensions(const batten_chain_nonlinear_options *options, int spans)
{
    for (int j = 0; options->tensions && j < spans; j++) {
        if (!isfinite(options->tensions[j]))
            return bat_fail(BATTEN_NOT_FINITE, "tension %d is %g", j + 1, options->tensions[j]);
        if (options->tensions[j] < 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "tension %d is %g, below 0", j + 1,
                            options->tensions[j]);
    }
    return BATTEN_OK;
}

static batten_status check_nonlinear_data(int count, const double *points,
                                          const batten_chain_nonlinear_options *options)
{
    if (!family_of(options->family))
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown span family %d", (int)options->family);
    if (options->max_steps < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d step%s; at least 1 is needed",
                        options->max_steps, bat_plural(options->max_steps));
    batten_status status = bat_points_check(2, count, points, options->closed ? 3 : 2);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("start", options->start, options->start_value);
    if (status == BATTEN_OK && !options->closed)
        status = check_end("end", options->end, options->end_value);
    if (status == BATTEN_OK)
        status = check_tensions(options, options->closed ? count : count - 1);
    if (status == BATTEN_OK && count == 2 && options->start == BATTEN_NONLINEAR_CIRCULAR &&
        options->end == BATTEN_NONLINEAR_CIRCULAR)
        status =
            bat_fail(BATTEN_SINGULAR_SYSTEM,
                     "two points with circular ends determine no circle: give a tangent or "
                     "a curvature at one end");
    return status;
}

/* ---- the polygon ---- */

/* The angles on which all else is built; lengths of the task are in units of the longest chord.
 */
typedef struct {
    bat_chord_polygon chords;
    bat_two_angle task; /* borrows lengths and turns of the chords */
    double *angles;
} polygon;

static void polygon_free(polygon *p)
{
    bat_chord_polygon_end(&p->chords);
    bat_release(p->task.tension);
    bat_release(p->angles);
}

static batten_status polygon_make(int count, const double *points,
                                  const batten_chain_nonlinear_options *options, polygon *p)
{
    bat_two_angle *task = &p->task;
    batten_status status = bat_chord_polygon_make(count, points, options->closed, &p->chords);
    const int spans = p->chords.spans;
    for (int i = !options->closed; i < count - !options->closed && status == BATTEN_OK; i++)
        status = bat_chord_polygon_check_turn(&p->chords, i);
    if (status != BATTEN_OK)
        return status;
    *task = (bat_two_angle){.family = family_of(options->family),
                            .closed = options->closed,
                            .count = count,
                            .spans = spans,
                            .length = p->chords.length,
                            .turn = p->chords.turn};
    task->tension = bat_array((size_t)spans, sizeof *task->tension);
    p->angles = bat_array((size_t)count, sizeof *p->angles);
    if (!task->tension || !p->angles)
        return BATTEN_OUT_OF_MEMORY;
    if (options->tensions)
        memcpy(task->tension, options->tensions, (size_t)spans * sizeof *task->tension);
    return BATTEN_OK;
}

/* The value at an end, as the task wants it; `from`: the direction of the end chord. */
static double end_value(batten_nonlinear_end kind, double value, double from, double unit)
{
    if (kind == BATTEN_NONLINEAR_TANGENT)
        return remainder(value - from, 2 * BAT_PI);
    return value * unit;
}

static void set_ends(const batten_chain_nonlinear_options *options, polygon *p)
{
    bat_two_angle *task = &p->task;
    const double *first = p->chords.vector, *last = first + 2 * (size_t)task->spans - 2;
    task->start = options->start;
    task->end = options->end;
    task->start_value = end_value(options->start, options->start_value,
                                  bat_atan2(first[1], first[0]), p->chords.unit);
    task->end_value = end_value(options->end, options->end_value, bat_atan2(last[1], last[0]),
                                p->chords.unit);
}

/* ---- the chain ---- */

/* The spans of the chain between points j and j + 1; the last one ends exactly there. */
static batten_status make_spans(const polygon *p, int count, const double *points, int j,
                                batten_span *out, int *made)
{
    double alpha, beta;
    bat_two_angle_span(&p->task, p->angles, j, &alpha, &beta);
    const double *chord = p->chords.vector + 2 * (size_t)j, *from = points + 2 * (size_t)j;
    const double *to = points + 2 * (size_t)((j + 1) % count);
    const double l = bat_norm(2, chord);
    memset(out, 0, BAT_FAMILY_SPANS * sizeof *out);
    const batten_status status =
        p->task.family->spans(alpha, beta, l, p->task.tension[j], out, made);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < *made; k++)
        bat_chord_put(chord, from, &out[k]);
    if (out[*made - 1].kind == BATTEN_SPAN_TENSION)
        memcpy(out[*made - 1].end, to, 2 * sizeof *to);
    return BATTEN_OK;
}

static batten_status make_chain(const polygon *p, int count, const double *points,
                                batten_span *spans, double *breaks, double *parameters,
                                batten_chain **out)
{
    int total = 0;
    for (int j = 0; j < p->task.spans; j++) {
        int made = 0;
        const batten_status status = make_spans(p, count, points, j, spans + total, &made);
        if (status != BATTEN_OK)
            return status;
        parameters[j] = breaks[total];
        for (int k = 0; k < made; k++, total++)
            breaks[total + 1] = breaks[total] + spans[total].length;
    }
    if (!p->task.closed)
        parameters[count - 1] = breaks[total];
    /* Families are solved to about 1e-13 of the chord. */
    const double tolerance = 1e-11 * p->chords.unit + 16 * DBL_EPSILON * p->chords.size;
    return batten_chain_create(&(batten_chain_parts){2, total, spans, breaks, p->task.closed},
                               tolerance, out);
}

static batten_status emit(const polygon *p, int count, const double *points, double *parameters,
                          batten_chain **out)
{
    const size_t most = (size_t)p->task.spans * BAT_FAMILY_SPANS;
    batten_span *spans = bat_array(most, sizeof *spans);
    double *breaks = bat_array(most + 1, sizeof *breaks);
    double *at = bat_array((size_t)count, sizeof *at);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (spans && breaks && at)
        status = make_chain(p, count, points, spans, breaks, at, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, at, (size_t)count * sizeof *at);
    bat_release(spans);
    bat_release(breaks);
    bat_release(at);
    return status;
}

/* ---- inflections ---- */

/* Does span j bend to both sides where the points ask for one? Inside, the polygon turns to the
 * same side at both of its points; at an end the tangents stand to both sides of the chord. */
static bool bends_twice(const polygon *p, int j)
{
    const bat_two_angle *task = &p->task;
    const double a = task->turn[j], b = task->turn[(j + 1) % task->count];
    const double l = task->length[j];
    const bool end = !task->closed && (j == 0 || j == task->spans - 1);
    double alpha, beta;
    bat_end_curvatures e;
    bat_two_angle_span(task, p->angles, j, &alpha, &beta);
    /* Less than a billionth of the angles is rounding: so at ends of curvature 0. */
    const double least = 1e-9 * bat_max(fabs(alpha), fabs(beta)) / l;
    return (end ? alpha * beta < 0 : a * b > 0) &&
           task->family->curvatures(alpha, beta, l, task->tension[j], &e) == BATTEN_OK &&
           bat_min(e.k0, e.k1) < -least && bat_max(e.k0, e.k1) > least;
}

static int count_added(const polygon *p)
{
    int added = 0;
    for (int j = 0; j < p->task.spans; j++)
        added += bends_twice(p, j);
    return added;
}

/* More tension where a span bends twice; false where none does, or none can take more. */
static bool tighten(polygon *p)
{
    bool changed = false;
    for (int j = 0; j < p->task.spans; j++) {
        double alpha, beta;
        double *z = &p->task.tension[j];
        if (*z == BAT_MOST_TENSION || !bends_twice(p, j))
            continue;
        bat_two_angle_span(&p->task, p->angles, j, &alpha, &beta);
        /* Tangents turn as tension grows, so somewhat more than they need now. */
        const double more = bat_max(1, 1.5 * *z);
        *z = bat_min(BAT_MOST_TENSION, alpha * beta < 0
                                           ? bat_max(more, bat_local_tension_for(alpha, beta))
                                           : more);
        changed = true;
    }
    return changed;
}

/* Rounds of more tension, each from the tangents of the one before. Where the spans cannot be
 * joined in so much tension, the last round that could be stands. */
static batten_status choose_tension(polygon *p, int max_steps, double *kept,
                                    batten_chain_nonlinear_report *report)
{
    enum { ROUNDS = 100 };
    const size_t bytes = (size_t)p->task.spans * sizeof *kept;
    for (int round = 0; round < ROUNDS; round++) {
        batten_chain_nonlinear_report next = {0};
        memcpy(kept, p->task.tension, bytes);
        if (!tighten(p))
            break;
        const batten_status status = bat_two_angle_solve(&p->task, max_steps, p->angles, &next);
        if (status != BATTEN_OK) {
            memcpy(p->task.tension, kept, bytes);
            return status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
        }
        next.steps += report->steps;
        *report = next;
    }
    return BATTEN_OK;
}

static batten_status solve(polygon *p, const batten_chain_nonlinear_options *options,
                           batten_chain_nonlinear_report *report)
{
    batten_status status = bat_two_angle_solve(&p->task, options->max_steps, p->angles, report);
    if (status != BATTEN_OK || options->tensions ||
        options->family != BATTEN_FAMILY_LOCAL_TENSION)
        return status;
    double *kept = bat_array((size_t)p->task.spans, sizeof *kept);
    if (!kept)
        return BATTEN_OUT_OF_MEMORY;
    status = choose_tension(p, options->max_steps, kept, report);
    bat_release(kept);
    return status;
}

/* ---- the whole ---- */

static batten_status make_nonlinear_spline(int count, const double *points,
                                           const batten_chain_nonlinear_options *options,
                                           double *parameters, polygon *p,
                                           batten_chain_nonlinear_report *report,
                                           batten_chain **out)
{
    batten_status status = polygon_make(count, points, options, p);
    if (status == BATTEN_OK) {
        set_ends(options, p);
        status = bat_two_angle_start(&p->task, p->angles);
    }
    if (status == BATTEN_OK)
        status = solve(p, options, report);
    if (status == BATTEN_OK)
        status = emit(p, count, points, parameters, out);
    return status;
}

batten_status batten_chain_nonlinear(batten_points points,
                                     const batten_chain_nonlinear_options *options,
                                     double *angles, double *parameters,
                                     batten_chain_nonlinear_report *report, batten_chain **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && out);
    batten_chain_nonlinear_options chosen = batten_chain_nonlinear_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_nonlinear_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    batten_chain_nonlinear_report reached = {0};
    polygon p = {0};
    status = check_nonlinear_data(points.count, points.at, options);
    if (status == BATTEN_OK)
        status = make_nonlinear_spline(points.count, points.at, options, parameters, &p,
                                       &reached, out);
    if (status == BATTEN_OK && angles)
        bat_chord_polygon_directions(&p.chords, p.angles, angles);
    if (status == BATTEN_OK && report) {
        reached.error /= p.chords.unit;
        reached.curvature /= p.chords.unit;
        reached.inflections_added = count_added(&p);
        reached.turn = bat_chord_polygon_sharpest(&p.chords, &reached.turn_at);
        *report = reached;
    }
    polygon_free(&p);
    return status;
}
