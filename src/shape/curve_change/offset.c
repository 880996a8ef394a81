/* The offset of a curve in its plane, and of one in space across a normal. */
#include "shape/curve_change/offset.h"
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>

batten_curve_offset_options batten_curve_offset_defaults(void)
{
    return (batten_curve_offset_options){.size = sizeof(batten_curve_offset_options),
                                         .tolerance =
                                             1e-4, /* with metres, a tenth of a millimetre */
                                         .corners = BATTEN_OFFSET_ROUND,
                                         .mitre_limit = 4,
                                         .loops = BATTEN_LOOPS_REMOVE,
                                         .normal = {0, 0, 1},
                                         .most_pieces = 100000};
}

/* All runs in one curve. */
static batten_status keep_all(const bat_offset *o, batten_curves *out)
{
    batten_curves made = {0, bat_array(1, sizeof *made.at)};
    batten_curve **runs = bat_array((size_t)o->count, sizeof *runs);
    batten_status status = made.at && runs ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < o->count; i++)
        runs[i] = o->runs[i].curve;
    if (status == BATTEN_OK && o->count)
        status = bat_curves_chain(
            o->count, runs, 4 * o->options.tolerance + BAT_MEANT_SAME * o->size, &made.at[0]);
    made.count = status == BATTEN_OK && o->count;
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_release(made.at);
    bat_release(runs);
    return status;
}

static batten_status check_offset(const batten_curve *curve, double distance,
                                  const batten_curve_offset_options *o)
{
    if (curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "a function has no offset; make its graph first");
    if (!isfinite(distance))
        return bat_fail(BATTEN_NOT_FINITE, "the distance is %g", distance);
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    if (!(o->mitre_limit >= 1 && isfinite(o->mitre_limit)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the limit of mitres is %g, below 1",
                        o->mitre_limit);
    if (o->most_pieces < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "at most %d pieces are asked for", o->most_pieces);
    const batten_status status = bat_curve_check_size(curve);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 n = o->normal;
    if (!(isfinite(n.x) && isfinite(n.y) && isfinite(n.z)) || !(bat_vec3_norm(n) > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the normal of the offset is (%g, %g, %g)", n.x,
                        n.y, n.z);
    return BATTEN_OK;
}

/* In the plane, or in space with z along the normal. */
static batten_status offset_upright(const batten_curve *curve, double distance,
                                    const batten_curve_offset_options *options,
                                    batten_curve_offset_report *report, batten_curves *out)
{
    batten_curve *full = NULL, *plan = NULL;
    batten_status status = batten_curve_to_bezier(curve, &full);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(full, 2, &plan);
    bat_offset o = {.full = full, .plan = plan, .distance = distance, .options = *options};
    if (status == BATTEN_OK) {
        o.options.tolerance /= 4; /* so that small loops are seen */
        o.size = bat_curve_size(plan);
        o.closed = batten_curve_is_closed(full, 16 * DBL_EPSILON * o.size);
        status = bat_offset_runs(&o);
    }
    if (status == BATTEN_OK)
        status =
            options->loops == BATTEN_LOOPS_KEEP ? keep_all(&o, out) : bat_offset_trim(&o, out);
    if (status == BATTEN_OK)
        *report = o.report;
    bat_offset_runs_release(&o);
    batten_curve_unref(plan);
    batten_curve_unref(full);
    return status;
}

/* Turn every curve by a map. */
static batten_status map_curves(const batten_affine *map, batten_curves *curves)
{
    for (int i = 0; i < curves->count; i++) {
        batten_curve *mapped = NULL;
        const batten_status status = batten_curve_transform(curves->at[i], map, &mapped);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(curves->at[i]);
        curves->at[i] = mapped;
    }
    return BATTEN_OK;
}

/* The turn that brings z to the unit vector n, and back: the transposed matrix. */
static batten_affine turn_upright(batten_vec3 n, bool back)
{
    const batten_vec3 other =
        fabs(n.x) <= fabs(n.y) ? (batten_vec3){1, 0, 0} : (batten_vec3){0, 1, 0};
    batten_vec3 y = bat_vec3_cross(n, other);
    y = bat_vec3_scale(y, 1 / bat_vec3_norm(y));
    const batten_vec3 x = bat_vec3_cross(y, n);
    const double m[3][3] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {n.x, n.y, n.z}};
    batten_affine map = batten_affine_identity();
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            map.m[i][j] = back ? m[j][i] : m[i][j];
    return map;
}

static batten_status offset_in_space(const batten_curve *curve, double distance,
                                     const batten_curve_offset_options *options,
                                     batten_curve_offset_report *report, batten_curves *out)
{
    const batten_vec3 n = bat_vec3_scale(options->normal, 1 / bat_vec3_norm(options->normal));
    if (n.x == 0 && n.y == 0 && n.z > 0)
        return offset_upright(curve, distance, options, report, out);
    const batten_affine there = turn_upright(n, false), back = turn_upright(n, true);
    batten_curve *turned = NULL;
    batten_curves made = {0, NULL};
    batten_status status = batten_curve_transform(curve, &there, &turned);
    if (status == BATTEN_OK)
        status = offset_upright(turned, distance, options, report, &made);
    if (status == BATTEN_OK)
        status = map_curves(&back, &made);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_curves_release(&made);
    batten_curve_unref(turned);
    return status;
}

batten_status batten_curve_offset(const batten_curve *curve, double distance,
                                  const batten_curve_offset_options *options,
                                  batten_curve_offset_report *report, batten_curves *out)
{
    batten_curve_offset_options o = batten_curve_offset_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_offset_options, options, &o);
    if (status != BATTEN_OK)
        return status;
    batten_curve_offset_report done = {0};
    status = check_offset(curve, distance, &o);
    if (status == BATTEN_OK)
        status = curve->dimension == 3 ? offset_in_space(curve, distance, &o, &done, out)
                                       : offset_upright(curve, distance, &o, &done, out);
    if (status == BATTEN_OK && report)
        *report = done;
    return status;
}
