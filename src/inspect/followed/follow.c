/* Steps along a line on a surface: doubled, so that their error is known, and cut where the line ends. */
#include "inspect/followed/follow.h"

#include "base/list.h"
#include "numeric/vector.h"

enum { MOST_STATIONS = 100000, ROOT_STEPS = 60 };
/* Steps are so long that they err by this part of the tolerance for each size of the surface; one alone, as over a knot
 * where curvature or the speed of parameters jumps, may err by a hundredth of that however short it is. */
static const double share_of_steps = 0.02, share_of_one = 0.01;
/* A step is at most some nine times as long as the one before. */
static const double least_excess = 1e-4;
/* A line that ends because it turns too fast is near an umbilic where curvatures differ by less than this part. */
static const double near_umbilic = 1e-2;
/* A line that is back at its start has its direction to this. */
static const double same_direction = 1e-3;

batten_vec3 bat_station_between(const bat_station *a, const bat_station *b, double share)
{
    const double h = b->length - a->length, t = share, r = 1 - share;
    batten_vec3 p = bat_vec3_scale(a->point, r * r * (1 + 2 * t));
    p = bat_vec3_along(p, t * t * (1 + 2 * r), b->point);
    p = bat_vec3_along(p, h * t * r * r, a->tangent);
    return bat_vec3_along(p, -h * t * t * r, b->tangent);
}

static double gap_of(batten_vec3 a, batten_vec3 b)
{
    return bat_vec3_norm(bat_vec3_subtract(a, b));
}

/* Put point and tangent of a place into a station; tangents of geodesics stay unit vectors in the tangent plane. */
static batten_status stand(const bat_slope_field *field, batten_vec3 onward, bat_station *s,
                           bat_slope *slope)
{
    const batten_status status = bat_slope_at(field, s->place, onward, slope);
    if (status != BATTEN_OK || slope->obstacle != BATTEN_LINE_AT_LENGTH)
        return status;
    s->point = slope->point;
    const double speed = bat_vec3_norm(slope->tangent);
    s->tangent = bat_vec3_scale(slope->tangent, 1 / speed);
    if (field->kind == BATTEN_LINE_GEODESIC) {
        s->place[2] = s->tangent.x;
        s->place[3] = s->tangent.y;
        s->place[4] = s->tangent.z;
    }
    return BATTEN_OK;
}

/* One step of the fourth order; *obstacle as of a slope. */
static batten_status step_once(const bat_slope_field *field, const bat_station *from, double h,
                               bat_station *to, bat_slope *last)
{
    static const double share[4] = {0, 0.5, 0.5, 1},
                        weight[4] = {1 / 6., 1 / 3., 1 / 3., 1 / 6.};
    double rates[BAT_SLOPE_SIZE] = {0}, sum[BAT_SLOPE_SIZE] = {0};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 4; i++) {
        double place[BAT_SLOPE_SIZE];
        for (int k = 0; k < BAT_SLOPE_SIZE; k++)
            place[k] = from->place[k] + h * share[i] * rates[k];
        status = bat_slope_at(field, place, from->tangent, last);
        if (status != BATTEN_OK || last->obstacle != BATTEN_LINE_AT_LENGTH)
            return status;
        for (int k = 0; k < BAT_SLOPE_SIZE; k++) {
            rates[k] = last->rates[k];
            sum[k] += weight[i] * rates[k];
        }
    }
    for (int k = 0; k < BAT_SLOPE_SIZE; k++)
        to->place[k] = from->place[k] + h * sum[k];
    to->length = from->length + h;
    return stand(field, from->tangent, to, last);
}

/* What a doubled step gives: its end, its error, and how far the cubic over it is off. */
typedef struct {
    bat_station end;
    double error, chord;
    bat_slope last;
} stride;

static batten_status step_twice(const bat_follower *f, const bat_station *from, double h,
                                stride *out)
{
    bat_station middle, whole;
    bat_slope *last = &out->last;
    batten_status status = step_once(&f->field, from, h, &whole, last);
    if (status == BATTEN_OK && last->obstacle == BATTEN_LINE_AT_LENGTH)
        status = step_once(&f->field, from, h / 2, &middle, last);
    if (status == BATTEN_OK && last->obstacle == BATTEN_LINE_AT_LENGTH)
        status = step_once(&f->field, &middle, h / 2, &out->end, last);
    if (status != BATTEN_OK || last->obstacle != BATTEN_LINE_AT_LENGTH)
        return status;
    out->error = gap_of(whole.point, out->end.point) / 15;
    for (int k = 0; k < BAT_SLOPE_SIZE; k++)
        out->end.place[k] += (out->end.place[k] - whole.place[k]) / 15;
    status = stand(&f->field, from->tangent, &out->end, last);
    out->end.length = from->length + h;
    out->chord = gap_of(bat_station_between(from, &out->end, 0.5), middle.point);
    return status;
}

static batten_status keep_station(bat_way *way, const bat_station *s)
{
    if (way->count == MOST_STATIONS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "the line has more than %d points after a length of %g", MOST_STATIONS,
                        s->length);
    way->length = s->length;
    return BAT_LIST_ADD(way->at, way->count, way->room, *s);
}

/* The end of a step that leaves the domain: where it meets the rim. The part beyond it is never far, so that what
 * is taken from the rim for it counts for nothing. */
static batten_status step_to_rim(const bat_follower *f, const bat_station *from, double h,
                                 stride *out)
{
    double low = 0, high = h;
    batten_status status = BATTEN_OK;
    *out = (stride){.end = *from};
    out->last.obstacle = BATTEN_LINE_AT_LENGTH;
    for (int i = 0; i < ROOT_STEPS && status == BATTEN_OK && low < high; i++) {
        stride at = {.chord = 0};
        const double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            break;
        status = step_twice(f, from, middle, &at);
        const bool is_out = at.last.obstacle != BATTEN_LINE_AT_LENGTH ||
                            bat_slope_beyond(&f->field, at.end.place) > 0;
        *(is_out ? &high : &low) = middle;
        if (!is_out)
            *out = at;
    }
    return status;
}

/* Is the start on the cubic to the newest station? Then the line closes; a last point that would stand on the start
 * goes. */
static bool closes(const bat_follower *f, bat_way *way)
{
    const bat_station *start = way->at, *b = &way->at[way->count - 1], *a = b - 1;
    const double h = b->length - a->length;
    if (way->count < 4 || a->length < 2 * h)
        return false;
    const batten_vec3 chord = bat_vec3_subtract(b->point, a->point);
    double share = bat_vec3_dot(bat_vec3_subtract(start->point, a->point), chord) /
                   bat_vec3_dot(chord, chord);
    if (!(share > -0.5 && share <= 1))
        return false;
    for (int i = 0; i < 4; i++) /* Newton's steps along the line, which has speed 1 */
        share += bat_vec3_dot(bat_vec3_subtract(start->point, bat_station_between(a, b, share)),
                              start->tangent) /
                 h;
    if (!(share > 0 && share <= 1) ||
        gap_of(start->point, bat_station_between(a, b, share)) > f->tolerance)
        return false;
    const batten_vec3 turned = bat_vec3_subtract(
        bat_vec3_add(bat_vec3_scale(a->tangent, 1 - share), bat_vec3_scale(b->tangent, share)),
        start->tangent);
    if (bat_vec3_norm(turned) > same_direction + h * h / (f->size * f->size))
        return false;
    way->length = a->length + share * h;
    way->count -= share < 0.02 ? 2 : 1;
    return true;
}

/* Of a step that fails however short it is. */
static batten_line_end why_stuck(const bat_follower *f, const stride *s)
{
    if (s->last.obstacle != BATTEN_LINE_AT_LENGTH)
        return s->last.obstacle;
    return f->field.kind <= BATTEN_LINE_CURVATURE2 && s->last.spread < near_umbilic
               ? BATTEN_LINE_AT_UMBILIC
               : BATTEN_LINE_AT_SINGULAR;
}

/* How far a step may err. */
static double bound_of(const bat_follower *f, double length)
{
    return share_of_steps * f->tolerance * bat_max(share_of_one, bat_min(1, length / f->size));
}

/* Where no step is short enough: the way ends there, unless it is for rounding alone. */
static batten_status stop_at(const bat_follower *f, const bat_station *from, const stride *s,
                             bat_way *way)
{
    if (s->last.obstacle == BATTEN_LINE_AT_LENGTH && bat_max(s->error, s->chord) <= f->rounding)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "after a length of %g steps of the line err by %g however short they "
                        "are, which is rounding; the tolerance leaves them %g: ask for a "
                        "larger one",
                        from->length, bat_max(s->error, s->chord), bound_of(f, 0));
    way->end = why_stuck(f, s);
    return BATTEN_OK;
}

/* A step that is short enough, at most *h long; *h becomes the length to try next. False when there is none. */
static batten_status find_step(const bat_follower *f, const bat_station *from, double *h,
                               double left, stride *out, bool *is_found)
{
    const double least = bat_max(1e-3 * f->tolerance, 1e-12 * f->size);
    *is_found = false;
    do {
        const double length = bat_min(*h, left);
        const batten_status status = step_twice(f, from, length, out);
        if (status != BATTEN_OK)
            return status;
        const double excess =
            out->last.obstacle != BATTEN_LINE_AT_LENGTH
                ? HUGE_VAL
                : bat_max(out->error / bound_of(f, length), 4 * out->chord / f->tolerance);
        if (excess <= 1) {
            *h = bat_max(least, length * 0.9 * bat_pow(bat_max(excess, least_excess), -0.25));
            *is_found = true;
            return BATTEN_OK;
        }
        *h = length * (isfinite(excess) ? bat_max(0.2, 0.9 * bat_pow(excess, -0.25)) : 0.5);
    } while (*h > least);
    return BATTEN_OK;
}

/* One station more, or the end of the way. */
static batten_status go_on(bat_follower *f, bat_way *way, double *h, bool *is_over)
{
    const bat_station from = way->at[way->count - 1];
    stride s;
    bool is_found;
    batten_status status = find_step(f, &from, h, f->most - from.length, &s, &is_found);
    *is_over = true;
    if (status != BATTEN_OK)
        return status;
    if (!is_found)
        return stop_at(f, &from, &s, way);
    const bool leaves = bat_slope_beyond(&f->field, s.end.place) > 0;
    if (leaves) {
        way->end = BATTEN_LINE_AT_RIM;
        status = step_to_rim(f, &from, s.end.length - from.length, &s);
        if (status != BATTEN_OK || !(s.end.length > from.length))
            return status;
    }
    way->chord = bat_max(way->chord, s.chord);
    status = keep_station(way, &s.end);
    if (status != BATTEN_OK || leaves)
        return status;
    if (closes(f, way))
        way->end = BATTEN_LINE_CLOSED;
    else
        *is_over = !(s.end.length < f->most);
    return bat_work_step(&f->work, 1, bat_min(1, s.end.length / f->most), "following a line");
}

batten_status bat_follow(bat_follower *follower, const bat_station *start, bat_way *way)
{
    bool is_over = false;
    double h = follower->size / 64;
    *way = (bat_way){.end = BATTEN_LINE_AT_LENGTH};
    batten_status status = keep_station(way, start);
    while (status == BATTEN_OK && !is_over)
        status = go_on(follower, way, &h, &is_over);
    return status;
}
