/* A profile that crosses its axis, as the circle of a ball does: the part of it that is meant.
 */
#include "body/elementary/parts.h"
#include "spline/curve/curve.h"
#include <batten/nearest.h>

#include <string.h>

/* Parts of a profile between its crossings of the axis. */
typedef struct {
    const batten_curve *curve;
    batten_interval domain;
    int count;        /* of crossings inside the domain */
    const double *at; /* [count] */
    bool closed;      /* then the last part goes on as the first */
} cut_profile;

/* Distance from the axis and height of a place. */
static void see(const bat_stand *stand, const double point[3], double at[2])
{
    at[0] =
        bat_hypot(bat_stand_coordinate(stand, point, 0), bat_stand_coordinate(stand, point, 1));
    at[1] = bat_stand_coordinate(stand, point, 2);
}

/* The ends of stretch `index` of the domain, 0 .. count. */
static batten_interval stretch(const cut_profile *profile, int index)
{
    return (batten_interval){index == 0 ? profile->domain.a : profile->at[index - 1],
                             index == profile->count ? profile->domain.b : profile->at[index]};
}

/* The sum of the distances of the points from a stretch, by samples, in the half plane. */
static batten_status add_distances(const bat_stand *stand, const cut_profile *profile,
                                   int index, double *least)
{
    enum { PLACES = 64 };
    const batten_interval of = stretch(profile, index);
    double before[2] = {0, 0}, here[2];
    for (int i = 0; i <= PLACES; i++, memcpy(before, here, sizeof before)) {
        double point[3];
        const double t = i == PLACES ? of.b : of.a + (of.b - of.a) * i / PLACES;
        const batten_status status = batten_curve_evaluate(profile->curve, t, 0, point);
        if (status != BATTEN_OK)
            return status;
        see(stand, point, here);
        for (int k = 0; i > 0 && k < stand->count; k++) {
            double seen[2];
            see(stand, stand->points + 3 * (size_t)k, seen);
            least[k] = bat_min(least[k], bat_segment_distance(2, before, here, seen));
        }
    }
    return BATTEN_OK;
}

/* The part that the points are nearest to, the first of several. Part 0 of a closed profile is
 * the last stretch and the first one. */
static batten_status choose(const bat_stand *stand, const cut_profile *profile, int *best)
{
    const int parts = profile->count + !profile->closed;
    double *least = bat_array((size_t)stand->count + 1, sizeof *least), lowest = HUGE_VAL;
    batten_status status = least ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    *best = 0;
    for (int i = 0; i < parts && status == BATTEN_OK; i++) {
        double sum = 0;
        for (int k = 0; k < stand->count; k++)
            least[k] = HUGE_VAL;
        status = add_distances(stand, profile, i, least);
        if (status == BATTEN_OK && profile->closed && i == 0)
            status = add_distances(stand, profile, profile->count, least);
        for (int k = 0; k < stand->count; k++)
            sum += least[k];
        if (sum < lowest) {
            lowest = sum;
            *best = i;
        }
    }
    bat_release(least);
    return status;
}

static batten_status take_part(const cut_profile *profile, int index, batten_curve **out)
{
    const batten_interval of = stretch(profile, index), last = stretch(profile, profile->count);
    batten_curve *first = NULL, *second = NULL;
    if (!profile->closed || index > 0)
        return batten_curve_subrange(profile->curve, of.a, of.b, out);
    const double size = bat_vec3_norm(bat_vec3_subtract(batten_curve_box(profile->curve).high,
                                                        batten_curve_box(profile->curve).low));
    batten_status status = batten_curve_subrange(profile->curve, last.a, last.b, &first);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(profile->curve, of.a, of.b, &second);
    if (status == BATTEN_OK)
        /* Both are parts of one closed curve: they meet to rounding, which 1e-6 leaves ample
         * room. */
        status = batten_curve_join(first, second, 1e-6 * size, out);
    batten_curve_unref(first);
    batten_curve_unref(second);
    return status;
}

/* Put the ends that are cuts, found to rounding, on the axis. */
static batten_status put_on_axis(const bat_stand *stand, double near, batten_curve **curve)
{
    for (int end = 0; end < 2; end++) {
        const int index = end ? batten_curve_point_count(*curve) - 1 : 0;
        const double *at = batten_curve_points(*curve) + 3 * (size_t)index;
        double seen[2];
        see(stand, at, seen);
        if (seen[0] > near)
            continue;
        const batten_vec3 foot = bat_vec3_along(stand->frame.origin, seen[1], stand->frame.z);
        batten_curve *moved = NULL;
        const batten_status status = batten_curve_with_point(
            *curve, index, (const double[3]){foot.x, foot.y, foot.z}, &moved);
        if (status != BATTEN_OK)
            return status;
        bat_curve_take(curve, moved);
    }
    return BATTEN_OK;
}

/* Where the profile crosses the plane through the axis square to its farthest point. */
static batten_status find_cuts(const bat_stand *stand, const batten_curve *curve,
                               batten_parameters *out)
{
    const double *P = batten_curve_points(curve);
    double farthest = 0;
    batten_vec3 outward = stand->frame.x;
    for (int i = 0; i < batten_curve_point_count(curve); i++) {
        const double x = bat_stand_coordinate(stand, P + 3 * (size_t)i, 0),
                     y = bat_stand_coordinate(stand, P + 3 * (size_t)i, 1), r = bat_hypot(x, y);
        if (r <= farthest)
            continue;
        farthest = r;
        outward = bat_vec3_along(bat_vec3_scale(stand->frame.x, x / r), y / r, stand->y);
    }
    return batten_curve_plane_crossings(curve, outward,
                                        bat_vec3_dot(outward, stand->frame.origin), out);
}

batten_status bat_stand_cut(const bat_stand *stand, batten_curve **out)
{
    const batten_curve *curve = stand->of->curve;
    const batten_box box = batten_curve_box(curve);
    /* What closes does so to rounding, some 1e-16 of the size for each operation. */
    const double near = 1e-9 * bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    batten_parameters found = {0, NULL};
    cut_profile profile = {.curve = curve,
                           .domain = batten_curve_domain(curve),
                           .closed = batten_curve_is_closed(curve, near)};
    batten_curve *made = NULL;
    int best = 0;
    batten_status status = find_cuts(stand, curve, &found);
    /* A crossing at an end of the profile is found to some thousand roundings of its domain. */
    const double little = 1e-12 * (profile.domain.b - profile.domain.a);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        if (found.at[i] > profile.domain.a + little && found.at[i] < profile.domain.b - little)
            found.at[profile.count++] = found.at[i];
    profile.at = found.at;
    if (status == BATTEN_OK && profile.count == 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the profile crosses its axis in no place");
    if (status == BATTEN_OK && profile.closed) { /* a seam on the axis is a cut itself */
        double start[3], seen[2] = {1, 0};
        status = batten_curve_evaluate(curve, profile.domain.a, 0, start);
        if (status == BATTEN_OK)
            see(stand, start, seen);
        profile.closed = seen[0] > near;
    }
    if (status == BATTEN_OK)
        status = choose(stand, &profile, &best);
    if (status == BATTEN_OK)
        status = take_part(&profile, best, &made);
    if (status == BATTEN_OK)
        status = put_on_axis(stand, near, &made);
    bat_release(found.at);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curve_unref(made);
    return status;
}
