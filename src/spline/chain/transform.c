/* Maps of chains that keep their shapes: every span becomes one of its own kind. */
#include "spline/chain/transform.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

/* ---- maps that keep shapes ---- */

/* What a similarity of the plane or of space does: one scale, and whether it mirrors. */
typedef struct {
    double scale;
    bool mirrors;
} similarity;

static batten_status find_similarity(const batten_affine *map, int d, similarity *out)
{
    batten_vec3 c[3];
    const double s = bat_norm(
        d, (const double[3]){map->m[0][0], d > 1 ? map->m[1][0] : 0, d > 2 ? map->m[2][0] : 0});
    bool keeps = s > 0 && isfinite(s);
    for (int k = 0; k < 3 && keeps; k++)
        /* In units of the scale, and in the first d coordinates alone. */
        c[k] = k < d ? (batten_vec3){map->m[0][k] / s, d > 1 ? map->m[1][k] / s : 0,
                                     d > 2 ? map->m[2][k] / s : 0}
                     : (batten_vec3){k == 0, k == 1, k == 2};
    /* A rotation composed of others is square within some roundings. */
    for (int k = 0; k < 3 && keeps; k++)
        keeps = fabs(bat_vec3_norm(c[k]) - 1) <= 16 * DBL_EPSILON &&
                fabs(bat_vec3_dot(c[k], c[(k + 1) % 3])) <= 16 * DBL_EPSILON;
    if (!keeps)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the map changes shapes, which a chain cannot");
    *out = (similarity){s, bat_vec3_dot(bat_vec3_cross(c[0], c[1]), c[2]) < 0};
    return BATTEN_OK;
}

/* The first d coordinates; the others stay 0. */
static void map_vector(const batten_affine *map, int d, double *v, bool is_point)
{
    double to[3] = {0, 0, 0};
    for (int i = 0; i < d; i++)
        to[i] = bat_dot(d, map->m[i], v) + (is_point ? map->t[i] : 0);
    memcpy(v, to, sizeof to);
}

/* A direction of the plane, radians, after the map. */
static double map_angle(const batten_affine *map, double angle)
{
    double v[3] = {bat_cos(angle), bat_sin(angle), 0};
    map_vector(map, 2, v, false);
    return bat_atan2(v[1], v[0]);
}

/* Lengths grow by the scale, curvatures shrink by it; in a mirror they change their sign. */
static void map_span(const batten_affine *map, int d, similarity by, batten_span *span)
{
    double factor = (by.mirrors ? -1 : 1) / by.scale;
    map_vector(map, d, span->start, true);
    if (!bat_span_type_of(span->kind)->plane) {
        map_vector(map, d, span->end, true);
        map_vector(map, d, span->bend[0], false);
        map_vector(map, d, span->bend[1], false);
        return;
    }
    span->angle = map_angle(map, span->angle);
    if (span->kind == BATTEN_SPAN_GEOMETRIC)
        span->chord = map_angle(map, span->chord);
    span->length *= by.scale;
    for (int k = 0; k < 4; k++, factor /= by.scale)
        span->curvature[k] *= factor;
}

/* The map of the plane of a placed chain: by the scale alone; its frame does the rest. */
static batten_status map_frame(const batten_affine *map, similarity by, batten_chain *chain)
{
    batten_frame moved = chain->frame;
    double o[3] = {moved.origin.x, moved.origin.y, moved.origin.z};
    double x[3] = {moved.x.x, moved.x.y, moved.x.z},
           y[3] = {chain->y.x, chain->y.y, chain->y.z};
    map_vector(map, 3, o, true);
    map_vector(map, 3, x, false);
    map_vector(map, 3, y, false);
    moved.origin = (batten_vec3){o[0], o[1], o[2]};
    moved.x = (batten_vec3){x[0], x[1], x[2]};
    /* Seen from its own side a mirrored plane is as before: z goes by x and y. */
    moved.z = bat_vec3_cross(moved.x, (batten_vec3){y[0], y[1], y[2]});
    const batten_affine scaling = batten_affine_scaling(by.scale, by.scale, by.scale);
    for (int i = 0; i < chain->count; i++)
        map_span(&scaling, 2, (similarity){by.scale, false}, &chain->spans[i]);
    return bat_frame_square(&moved, &chain->frame, &chain->y);
}

static batten_status map_spans(const batten_affine *map, batten_chain *chain)
{
    const int d = chain->placed ? 3 : chain->dimension;
    similarity by = {1, false};
    if (chain->dimension == 2 && !chain->placed && (map->m[2][0] != 0 || map->m[2][1] != 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the map takes the chain out of its plane");
    batten_status status = find_similarity(map, d, &by);
    if (status != BATTEN_OK)
        return status;
    if (chain->placed)
        status = map_frame(map, by, chain);
    for (int i = 0; i < chain->count && !chain->placed; i++)
        map_span(map, d, by, &chain->spans[i]);
    return status;
}

batten_status batten_chain_transform(const batten_chain *chain, const batten_affine *map,
                                     batten_chain **out)
{
    assert(chain && map && out);
    batten_chain *mapped = NULL;
    batten_status status = bat_chain_copy(chain, &mapped);
    if (status == BATTEN_OK)
        status = map_spans(map, mapped);
    for (int i = 0; status == BATTEN_OK && i < mapped->count; i++)
        status = bat_chain_check_span(mapped->dimension, &mapped->spans[i], i);
    if (status == BATTEN_OK)
        *out = mapped;
    else
        batten_chain_unref(mapped);
    return status;
}
