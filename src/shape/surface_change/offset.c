/* The offset of a surface: exact where it can be, else a formula, as such or near it. */
#include "shape/surface_change/offset.h"
#include "base/plural.h"
#include "numeric/rounding.h"

#include "numeric/vector.h"
#include "shape/formula/formula.h"
#include "spline/spline.h"

typedef struct {
    batten_surface *surface; /* NURBS, clamped */
    double distance;
} offset;

batten_surface_offset_options batten_surface_offset_defaults(void)
{
    return (batten_surface_offset_options){.size = sizeof(batten_surface_offset_options),
                                           .tolerance =
                                               1e-4, /* with metres, a tenth of a millimetre */
                                           .most_points = BAT_APPROXIMATE_MOST};
}

/* ---- the kind "offset" ---- */

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const offset *o = data;
    return bat_offset_point(o->surface, o->distance, at, order, out);
}

static void free_offset(void *data)
{
    offset *o = data;
    batten_surface_unref(o->surface);
    bat_release(o);
}

static const bat_formula formula = {"offset", evaluate, NULL, free_offset};

/* The normal has one derivative less than the surface. Across full knots, where it was found
 * not to jump, nothing more is known. */
static int normal_smoothness(const bat_axis *axis)
{
    return bat_max_int(0, bat_knots_smoothness(axis->degree, axis->count, axis->knots, 3) - 1);
}

static batten_status make_formula(const batten_surface *surface, double distance,
                                  batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    bat_formula_axis axes[2];
    for (int k = 0; k < 2; k++)
        axes[k] = (bat_formula_axis){.count = nurbs->axes[k].span_count + 1,
                                     .spans = nurbs->axes[k].breaks,
                                     .smoothness = normal_smoothness(&nurbs->axes[k])};
    offset *o = bat_array(1, sizeof *o);
    if (!o)
        return BATTEN_OUT_OF_MEMORY;
    *o = (offset){batten_surface_ref(surface), distance};
    const batten_status status = bat_formula_create(&formula, o, 3, &axes[0], &axes[1],
                                                    nurbs->largest + fabs(distance), out);
    if (status != BATTEN_OK)
        free_offset(o);
    return status;
}

/* ---- what is refused ---- */

/* Across one knot line: the angle of the two normals at places along it. */
static batten_status check_crease(const batten_surface *surface, batten_direction across,
                                  double at)
{
    const bat_axis *along = &bat_surface_nurbs(surface)->axes[bat_other(across)];
    const batten_side sides[2] = {BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT};
    for (int i = 0; i < 4 * along->span_count; i++) {
        const double *b = along->breaks + i / 4;
        const double t = b[0] + (0.125 + 0.25 * (i % 4)) * (b[1] - b[0]);
        batten_vec3 n[2];
        for (int k = 0; k < 2; k++) {
            const bat_surface_place place =
                across == BATTEN_U ? (bat_surface_place){at, t, {sides[k], BATTEN_FROM_RIGHT}}
                                   : (bat_surface_place){t, at, {BATTEN_FROM_RIGHT, sides[k]}};
            double zero[3], one[3];
            batten_status status = bat_offset_point(surface, 0, &place, 0, zero);
            /* As far away as the surface is large, so that no digits are lost. */
            const double far = bat_surface_nurbs(surface)->largest;
            if (status == BATTEN_OK)
                status = bat_offset_point(surface, far, &place, 0, one);
            if (status != BATTEN_OK)
                return status;
            n[k] = bat_vec3_scale(bat_vec3_subtract(bat_vec3_of(3, one), bat_vec3_of(3, zero)),
                                  1 / far);
        }
        /* A crease of a millionth of a radian is below what modellers keep. */
        const double jump = bat_vec3_norm(bat_vec3_subtract(n[0], n[1]));
        if (jump > 1e-6)
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "the surface has a crease of %.3g degree%s at %c = %.9g, where its "
                "offset would fall apart: split it there",
                2 * bat_asin(bat_min(1, jump / 2)) * 180 / BAT_PI,
                bat_plural_real(2 * bat_asin(bat_min(1, jump / 2)) * 180 / BAT_PI, 3),
                across == BATTEN_U ? 'u' : 'v', at);
    }
    return BATTEN_OK;
}

static batten_status check_creases(const batten_surface *surface)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++) {
        const bat_axis *axis = &bat_surface_nurbs(surface)->axes[k];
        for (int s = 1; s < axis->span_count && status == BATTEN_OK; s++)
            if (bat_knots_multiplicity(axis->degree, axis->count, axis->knots,
                                       axis->breaks[s]) >= axis->degree)
                status = check_crease(surface, (batten_direction)k, axis->breaks[s]);
    }
    return status;
}

static batten_status check_surface(const batten_surface *surface, double distance,
                                   const batten_surface_offset_options *options)
{
    if (!isfinite(distance) || !isfinite(options->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "an offset by %g within %g", distance,
                        options->tolerance);
    if (options->tolerance < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", options->tolerance);
    if (options->most_points < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "at most %d points are asked for",
                        options->most_points);
    if (surface->kind != &bat_nurbs_kind)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the surface is of the kind '%s': make it a NURBS surface first",
                        batten_surface_kind(surface));
    if (surface->dimension != 3)
        return bat_fail(BATTEN_UNSUPPORTED, "a surface in %d dimension%s has no normal",
                        surface->dimension, bat_plural(surface->dimension));
    return BATTEN_OK;
}

static batten_status check_turned(double distance, const batten_surface_offset_report *r)
{
    /* 1 minus the product of distance and curvature, of a curvature known to nine digits. */
    if (r->factor > BAT_MEANT_SAME)
        return BATTEN_OK;
    const double kappa = (1 - r->factor) / distance;
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "an offset by %g turns over: at (%.6g, %.6g) the radius of curvature is "
                    "only %g; so in u from %.6g to %.6g, v from %.6g to %.6g",
                    distance, r->at[0], r->at[1], fabs(1 / kappa),
                    bat_min(r->turned[0].a, r->at[0]), bat_max(r->turned[0].b, r->at[0]),
                    bat_min(r->turned[1].a, r->at[1]), bat_max(r->turned[1].b, r->at[1]));
}

/* ---- making it ---- */

static batten_status clamp_surface(const batten_surface *surface, batten_surface **out)
{
    batten_surface *half = NULL;
    batten_status status = batten_surface_clamp(surface, BATTEN_U, &half);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(half, BATTEN_V, out);
    batten_surface_unref(half);
    return status;
}

static batten_status make_offset(const batten_surface *surface, double distance,
                                 const batten_surface_offset_options *options,
                                 batten_surface_offset_report *report, batten_surface **out)
{
    batten_surface *truth = NULL;
    batten_status status = check_creases(surface);
    if (status == BATTEN_OK)
        status = bat_offset_curvatures(surface, distance, report);
    if (status == BATTEN_OK && !options->keep)
        status = check_turned(distance, report);
    if (status == BATTEN_OK)
        status = bat_offset_exact(surface, distance, out);
    if (status != BATTEN_OK)
        return status;
    report->exact = *out != NULL;
    if (report->exact)
        return BATTEN_OK;
    status = make_formula(surface, distance, &truth);
    if (status == BATTEN_OK && options->tolerance > 0)
        status = bat_surface_approximate(truth, options->tolerance, options->most_points, out,
                                         &report->error);
    else if (status == BATTEN_OK)
        *out = batten_surface_ref(truth);
    batten_surface_unref(truth);
    return status;
}

batten_status batten_surface_offset(const batten_surface *surface, double distance,
                                    const batten_surface_offset_options *options,
                                    batten_surface_offset_report *report, batten_surface **out)
{
    assert(surface && out);
    batten_surface_offset_options chosen = batten_surface_offset_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_offset_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    batten_surface_offset_report found = {.error = 0};
    batten_surface *clamped = NULL, *made = NULL;
    status = check_surface(surface, distance, options);
    if (status == BATTEN_OK)
        status = clamp_surface(surface, &clamped);
    if (status == BATTEN_OK)
        status = make_offset(clamped, distance, options, &found, &made);
    /* What turns inside out is reported with its places. */
    if (report && (status == BATTEN_OK || status == BATTEN_SINGULAR_HERE))
        *report = found;
    if (status == BATTEN_OK)
        *out = made;
    batten_surface_unref(clamped);
    return status;
}
