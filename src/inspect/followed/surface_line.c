/* Lines of curvature, asymptotic lines and geodesics: both ways from a point, with a measured error. */
#include "inspect/followed/follow.h"

#include "numeric/box.h"
#include "numeric/vector.h"

#include <float.h>

/* A line without a length goes so many sizes of its surface; each integration errs by a part of the one before; so
 * often; and then by this part of the tolerance of cubics. */
enum { USUAL_SIZES = 10, TIMES_FINER = 32, INTEGRATIONS = 4 };
static const double part_of_cubics = 0.5;
/* Opposite rims that are nearer, over the size of the surface, are one: the line goes on there. */
static const double closed_within = 1e-9;
/* Points of a surface, and so the error of a step, are rounded to this part of its coordinates. */
static const double rounded_to = 64 * DBL_EPSILON;

/* Both ways of one integration. */
typedef struct {
    int count; /* 1 or 2 */
    bat_way ways[2];
} both_ways;

static void release_ways(both_ways *l)
{
    for (int k = 0; k < l->count; k++)
        bat_release(l->ways[k].at);
    l->count = 0;
}

static batten_status follow_ways(bat_follower *f, const bat_station *start, both_ways *out)
{
    bat_station from = *start;
    *out = (both_ways){.count = 1};
    batten_status status = bat_follow(f, &from, &out->ways[0]);
    if (status != BATTEN_OK || f->field.kind == BATTEN_LINE_GEODESIC ||
        out->ways[0].end == BATTEN_LINE_CLOSED)
        return status;
    from.tangent = bat_vec3_scale(from.tangent, -1);
    out->count = 2;
    return bat_follow(f, &from, &out->ways[1]);
}

/* How far one way is from another that is finer, at equal lengths, and where both end: at an umbilic, a parabolic
 * line or a pole only as far as both go. */
static double way_error(const bat_way *way, const bat_way *finer)
{
    double error = 0;
    for (int i = 0, k = 0; i < way->count; i++) {
        const bat_station *s = &way->at[i];
        while (k + 2 < finer->count && finer->at[k + 1].length < s->length)
            k++;
        if (k + 1 >= finer->count || s->length > finer->at[k + 1].length)
            break;
        const bat_station *a = &finer->at[k], *b = a + 1;
        const batten_vec3 p =
            bat_station_between(a, b, (s->length - a->length) / (b->length - a->length));
        error = bat_max(error, bat_vec3_norm(bat_vec3_subtract(p, s->point)));
    }
    const bool ends_sharply = finer->end == BATTEN_LINE_AT_RIM ||
                              finer->end == BATTEN_LINE_AT_LENGTH ||
                              finer->end == BATTEN_LINE_CLOSED;
    return ends_sharply ? bat_max(error, fabs(way->length - finer->length)) : error;
}

static double line_error(const both_ways *l, const both_ways *finer)
{
    double error = 0;
    for (int k = 0; k < l->count && k < finer->count; k++)
        error = bat_max(error, way_error(&l->ways[k], &finer->ways[k]) + finer->ways[k].chord);
    return error;
}

/* Do both end for the same reasons? If not, the coarser one says nothing of the error. */
static bool is_other(const both_ways *l, const both_ways *finer)
{
    bool other = l->count != finer->count;
    for (int k = 0; k < l->count && !other; k++)
        other = l->ways[k].end != finer->ways[k].end;
    return other;
}

/* Integrate, each time finer, until two integrations agree; the finer one is the result. */
static batten_status follow_finely(bat_follower *f, const bat_station *start, double tolerance,
                                   both_ways *out, double *error)
{
    both_ways before = {0}, now = {0};
    batten_status status = BATTEN_OK;
    double finest = tolerance * part_of_cubics;
    *error = HUGE_VAL;
    for (int i = 0; i < INTEGRATIONS && status == BATTEN_OK && !(*error <= tolerance); i++) {
        release_ways(&before);
        before = now;
        f->tolerance = finest;
        finest /= TIMES_FINER;
        status = follow_ways(f, start, &now);
        if (status == BATTEN_OK && !is_other(&before, &now))
            *error = line_error(&before, &now);
    }
    release_ways(&before);
    if (status == BATTEN_OK && !isfinite(*error))
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "%d integrations of the line, each finer, end each otherwise; the "
                          "tolerance is %g",
                          INTEGRATIONS, tolerance);
    else if (status == BATTEN_OK && !(*error <= tolerance))
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "two integrations of the line are %g apart, the tolerance is %g",
                          *error, tolerance);
    if (status == BATTEN_OK)
        *out = now;
    else
        release_ways(&now);
    return status;
}

/* ---- the result ---- */

static void put_vector(double *to, batten_vec3 p)
{
    to[0] = p.x;
    to[1] = p.y;
    to[2] = p.z;
}

/* Station i of both ways as one line, the second way reversed before the first. */
static bat_station station_of(const both_ways *l, int i)
{
    const int back = l->count == 2 ? l->ways[1].count - 1 : 0;
    if (i >= back)
        return l->ways[0].at[i - back];
    bat_station s = l->ways[1].at[back - i];
    s.tangent = bat_vec3_scale(s.tangent, -1);
    s.length = -s.length;
    return s;
}

static batten_status lay_line(const bat_follower *f, const both_ways *l,
                              batten_surface_line *out)
{
    const bool closed = l->ways[0].end == BATTEN_LINE_CLOSED;
    const int count = l->ways[0].count + (l->count == 2 ? l->ways[1].count - 1 : 0);
    double *points = bat_array3((size_t)count, 3, sizeof *points);
    double *uv = bat_array3((size_t)count, 2, sizeof *uv);
    double *arms = bat_array3((size_t)count, 6, sizeof *arms);
    out->line = (batten_polyline){count, closed, points, uv};
    out->arms = arms;
    if (!points || !uv || !arms)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        const bat_station s = station_of(l, i);
        const double before = i > 0    ? s.length - station_of(l, i - 1).length
                              : closed ? l->ways[0].length - l->ways[0].at[count - 1].length
                                       : 0;
        const double behind = i + 1 < count ? station_of(l, i + 1).length - s.length
                              : closed      ? l->ways[0].length - s.length
                                            : 0;
        put_vector(points + 3 * i, s.point);
        bat_slope_wrap(&f->field, s.place, uv + 2 * i);
        put_vector(arms + 6 * i, bat_vec3_along(s.point, -before / 3, s.tangent));
        put_vector(arms + 6 * i + 3, bat_vec3_along(s.point, behind / 3, s.tangent));
    }
    out->length = l->ways[0].length + (l->count == 2 ? l->ways[1].length : 0);
    out->ends[1] = l->ways[0].end;
    out->ends[0] = l->count == 2 ? l->ways[1].end
                   : closed      ? BATTEN_LINE_CLOSED
                                 : BATTEN_LINE_AT_LENGTH;
    return BATTEN_OK;
}

void batten_surface_line_release(batten_surface_line *line)
{
    bat_release(line->line.points);
    bat_release(line->line.parameters);
    bat_release(line->arms);
    *line = (batten_surface_line){.length = 0};
}

/* ---- the start ---- */

static batten_status check_start(const batten_surface *surface, const batten_line_start *start,
                                 double tolerance)
{
    const batten_vec3 d = start->direction;
    const int kind = (int)start->kind;
    if (kind < BATTEN_LINE_CURVATURE1 || kind > BATTEN_LINE_GEODESIC)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no kind %d of lines; they are %d to %d",
                        kind, BATTEN_LINE_CURVATURE1, BATTEN_LINE_GEODESIC);
    if (batten_surface_dimension(surface) != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the surface is not in space");
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be above 0",
                        tolerance);
    if (!isfinite(d.x + d.y + d.z + start->u + start->v))
        return bat_fail(BATTEN_NOT_FINITE, "the start of the line is not finite");
    if (!(start->length >= 0 && isfinite(start->length)))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the length of the line is %g; it must not be below 0", start->length);
    return BATTEN_OK;
}

static batten_status refuse_start(const batten_line_start *start, batten_line_end why)
{
    static const char *const names[] = {"line of curvature", "line of curvature",
                                        "asymptotic line", "asymptotic line", "geodesic"};
    return bat_fail(
        BATTEN_SINGULAR_HERE, "no %s starts at u = %g, v = %g: %s", names[start->kind],
        start->u, start->v,
        why == BATTEN_LINE_AT_UMBILIC     ? "both principal curvatures are equal there"
        : why == BATTEN_LINE_AT_PARABOLIC ? "the Gaussian curvature is not below 0 there"
        : start->kind == BATTEN_LINE_GEODESIC
            ? "the surface has no tangent plane there, or the direction is square to it"
            : "the surface has no tangent plane there");
}

static batten_status take_start(bat_slope_field *field, const batten_line_start *start,
                                bat_station *out)
{
    bat_slope slope;
    double point[3];
    *out = (bat_station){.place = {start->u, start->v, 0, 0, 0}};
    batten_status status =
        batten_surface_evaluate(field->surface, start->u, start->v, 0, point);
    if (status != BATTEN_OK)
        return status;
    if (field->kind == BATTEN_LINE_GEODESIC &&
        !bat_slope_begin(field, out->place, start->direction))
        return refuse_start(start, BATTEN_LINE_AT_SINGULAR);
    status = bat_slope_at(field, out->place, start->direction, &slope);
    if (status == BATTEN_OK && slope.obstacle != BATTEN_LINE_AT_LENGTH)
        status = refuse_start(start, slope.obstacle);
    out->point = slope.point;
    out->tangent = slope.tangent;
    return status;
}

/* What rounding of coordinates and of parameters does to a point. */
static double rounding_of(const bat_follower *f, batten_box box)
{
    double most = bat_max(bat_largest(3, &box.low.x), bat_largest(3, &box.high.x));
    for (int k = 0; k < 2; k++) {
        const batten_interval d = f->field.domain[k];
        most = bat_max(most, f->size * bat_max(fabs(d.a), fabs(d.b)) / (d.b - d.a));
    }
    return rounded_to * most;
}

batten_status batten_surface_line_from(const batten_surface *surface,
                                       const batten_line_start *start, double tolerance,
                                       const batten_job *job, batten_surface_line *out)
{
    assert(surface && start && out);
    bat_station from;
    batten_surface_line made = {.length = 0};
    both_ways found = {0};
    batten_status status = check_start(surface, start, tolerance);
    if (status != BATTEN_OK)
        return status;
    bat_follower f = {.field = {.surface = surface, .kind = start->kind},
                      .size = bat_box_diagonal(batten_surface_box(surface)),
                      .work = {.job = job}};
    f.most = start->length > 0 ? start->length : USUAL_SIZES * f.size;
    for (int k = 0; k < 2; k++) {
        f.field.domain[k] = batten_surface_domain(surface, k ? BATTEN_V : BATTEN_U);
        f.field.closed[k] =
            batten_surface_is_closed(surface, k ? BATTEN_V : BATTEN_U, closed_within * f.size);
    }
    f.rounding = rounding_of(&f, batten_surface_box(surface));
    status = take_start(&f.field, start, &from);
    if (status == BATTEN_OK)
        status = follow_finely(&f, &from, tolerance, &found, &made.error);
    if (status == BATTEN_OK)
        status = lay_line(&f, &found, &made);
    release_ways(&found);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_line_release(&made);
    return status;
}
