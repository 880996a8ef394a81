/*
 * The chords of a plane polygon and the angles between them, the frame in which nonlinear
 * splines are computed, and the map back to the plane of the data.
 */
#include "shape/points/chord_polygon.h"
#include "numeric/vector.h"

#include <float.h>

static batten_status find_vectors(const double *points, bat_chord_polygon *out)
{
    out->size = bat_largest(2 * out->count, points);
    for (int j = 0; j < out->spans; j++) {
        const int next = (j + 1) % out->count;
        const double *a = points + 2 * (size_t)j, *b = points + 2 * (size_t)next;
        double *q = out->vector + 2 * (size_t)j;
        q[0] = b[0] - a[0];
        q[1] = b[1] - a[1];
        out->length[j] = bat_norm(2, q);
        if (out->length[j] == 0)
            return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", j + 1, next + 1);
        if (!isfinite(out->length[j]))
            return bat_fail(BATTEN_OVERFLOW, "points %d and %d are too far apart", j + 1,
                            next + 1);
        out->unit = bat_max(out->unit, out->length[j]);
    }
    return BATTEN_OK;
}

static int chord_before(const bat_chord_polygon *c, int i)
{
    return (i + c->spans - 1) % c->spans;
}

static void find_turns(bat_chord_polygon *out)
{
    for (int i = !out->closed; i < out->count - !out->closed; i++) {
        const int j = chord_before(out, i);
        const double *q = out->vector + 2 * (size_t)j, *r = out->vector + 2 * (size_t)i;
        const double l = out->length[j], m = out->length[i];
        const double u[2] = {q[0] / l, q[1] / l}, v[2] = {r[0] / m, r[1] / m};
        out->turn[i] = bat_atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
    }
    for (int j = 0; j < out->spans; j++)
        out->length[j] /= out->unit;
}

batten_status bat_chord_polygon_make(int count, const double *points, bool closed,
                                     bat_chord_polygon *out)
{
    const int spans = closed ? count : count - 1;
    *out = (bat_chord_polygon){.count = count, .spans = spans, .closed = closed};
    out->vector = bat_array(2 * (size_t)spans, sizeof *out->vector);
    out->length = bat_array((size_t)spans, sizeof *out->length);
    out->turn = bat_array((size_t)count, sizeof *out->turn);
    if (!out->vector || !out->length || !out->turn)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = find_vectors(points, out);
    if (status == BATTEN_OK)
        find_turns(out);
    return status;
}

void bat_chord_polygon_end(bat_chord_polygon *chords)
{
    bat_release(chords->vector);
    bat_release(chords->length);
    bat_release(chords->turn);
}

batten_status bat_chord_polygon_check_turn(const bat_chord_polygon *c, int i)
{
    const double shorter = c->unit * bat_min(c->length[chord_before(c, i)],
                                             c->length[bat_min_int(i, c->spans - 1)]);
    /* The coordinates and the directions made of them are right to a rounding or two. */
    const double rounding = 4 * DBL_EPSILON * (1 + c->size / shorter);
    if (BAT_PI - fabs(c->turn[i]) > rounding)
        return BATTEN_OK;
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "the polygon turns back on itself at point %d: to which side the curve "
                    "goes is not determined",
                    i + 1);
}

double bat_chord_polygon_sharpest(const bat_chord_polygon *chords, int *at)
{
    double most = 0;
    *at = 0;
    for (int i = 0; i < chords->count; i++)
        if (fabs(chords->turn[i]) > most) {
            most = fabs(chords->turn[i]);
            *at = i;
        }
    return most;
}

void bat_chord_polygon_directions(const bat_chord_polygon *c, const double *angles, double *out)
{
    double before = 0, turned = 0;
    for (int i = 0; i < c->count; i++) {
        const double *q = c->vector + 2 * (size_t)bat_min_int(i, c->spans - 1);
        const double phi = bat_atan2(q[1], q[0]);
        /* The chord as the polygon has turned into it. */
        const double unwrapped = i == 0 ? phi : before + turned;
        const double near = phi + 2 * BAT_PI * round((unwrapped - phi) / (2 * BAT_PI));
        out[i] = near + angles[i];
        before = near;
        turned = c->turn[(i + 1) % c->count];
    }
}

double bat_circle_angle(double before, double after, double turn)
{
    return bat_atan2(-bat_sin(turn) * after, bat_cos(turn) * after + before);
}

/* By the angle with this cosine and sine. */
static void turn_vectors(double c, double s, batten_span *span)
{
    double *const vectors[] = {span->start, span->end, span->bend[0], span->bend[1]};
    for (int k = 0; k < 4; k++) {
        double *v = vectors[k];
        const double x = v[0], y = v[1];
        v[0] = c * x - s * y;
        v[1] = s * x + c * y;
    }
}

/* What a span of its kind has not is 0. */
static void clear_unused(batten_span *span)
{
    if (span->kind != BATTEN_SPAN_TENSION)
        span->end[0] = span->end[1] = 0;
    else
        span->angle = span->chord = 0;
    if (span->kind != BATTEN_SPAN_GEOMETRIC)
        span->chord = 0;
}

void bat_chord_put(const double *vector, const double *point, batten_span *span)
{
    const double l = bat_norm(2, vector);
    const double c = vector[0] / l, s = vector[1] / l, turn = bat_atan2(vector[1], vector[0]);
    turn_vectors(c, s, span);
    for (int k = 0; k < 2; k++) {
        span->start[k] += point[k];
        span->end[k] += point[k];
    }
    span->angle += turn;
    span->chord += turn;
    clear_unused(span);
}
