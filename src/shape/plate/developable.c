/* Developable surfaces between two edges: options, checks, and the condition of one ruling. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"
#include <batten/skin.h>

enum { LOOKS = 65 };

batten_surface_developable_options batten_surface_developable_defaults(void)
{
    return (batten_surface_developable_options){
        .size = sizeof(batten_surface_developable_options),
        .tolerance = 1e-4, /* with metres, a tenth of a millimetre */
        .warp = BAT_PI / 360};
}

batten_status batten_ruling_condition(const batten_curve *first, double s,
                                      const batten_curve *second, double t, double *condition,
                                      double *warp)
{
    const batten_curve *curves[2] = {first, second};
    const double at[2] = {s, t};
    batten_vec3 P[2], D[2];
    for (int e = 0; e < 2; e++) {
        const int d = batten_curve_dimension(curves[e]);
        double values[2 * 3];
        const batten_status status = batten_curve_evaluate(curves[e], at[e], 1, values);
        if (status != BATTEN_OK)
            return status;
        P[e] = bat_vec3_of(d, values);
        D[e] = bat_vec3_of(d, values + d);
    }
    const batten_vec3 d = bat_vec3_subtract(P[1], P[0]);
    *condition = bat_vec3_dot(bat_vec3_cross(D[0], D[1]), d);
    bat_edge_place places[2];
    for (int e = 0; e < 2; e++) {
        const double speed = bat_vec3_norm(D[e]);
        places[e] = (bat_edge_place){P[e], bat_vec3_scale(D[e], speed > 0 ? 1 / speed : 0), 0};
    }
    double sine, cosine;
    const bool planes = bat_warp_of(&places[0], &places[1], 0, &sine, &cosine);
    *warp = planes ? bat_atan2(fabs(sine), cosine) : (double)NAN;
    return BATTEN_OK;
}

/* ---- what is given ---- */

static batten_status check_options(const batten_surface_developable_options *o)
{
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    if (!(o->warp > 0 && o->warp < BAT_PI / 2))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the warp is %g; it must be above 0 and below a right angle", o->warp);
    return BATTEN_OK;
}

static double extent(const batten_curve *curve)
{
    const batten_box box = batten_curve_box(curve);
    return bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
}

static batten_status ends_of(const batten_curve *curve, batten_vec3 ends[2])
{
    const batten_interval domain = batten_curve_domain(curve);
    double a[3], b[3];
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(curve, domain.b, 0, b);
    ends[0] = bat_vec3_of(3, a);
    ends[1] = bat_vec3_of(3, b);
    return status;
}

/* Chords that point opposite ways, with ends that are nearer when one edge is turned. */
static batten_status check_directions(const batten_curve *first, const batten_curve *second)
{
    batten_vec3 a[2], b[2];
    batten_status status = ends_of(first, a);
    if (status == BATTEN_OK)
        status = ends_of(second, b);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 p = bat_vec3_subtract(a[1], a[0]), q = bat_vec3_subtract(b[1], b[0]);
    const double straight = bat_vec3_norm(bat_vec3_subtract(b[0], a[0])) +
                            bat_vec3_norm(bat_vec3_subtract(b[1], a[1]));
    const double crossed = bat_vec3_norm(bat_vec3_subtract(b[1], a[0])) +
                           bat_vec3_norm(bat_vec3_subtract(b[0], a[1]));
    if (bat_vec3_dot(p, q) < 0 && crossed < straight)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the edges run against each other: their ends are %g apart in all, %g "
                        "when one is reversed",
                        straight, crossed);
    return BATTEN_OK;
}

/* ---- the two ways ---- */

/* Equal parameters joined; also a cone about an edge that is a point. */
static batten_status keep_matching(const batten_curve *const edges[2], batten_developable *out)
{
    batten_status status = batten_surface_ruled(edges[0], edges[1], &out->surface);
    out->rulings = bat_array(LOOKS, sizeof *out->rulings);
    if (status == BATTEN_OK && !out->rulings)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < LOOKS && status == BATTEN_OK; i++) {
        batten_ruling *ruling = &out->rulings[out->count++];
        double at[2], condition, warp = 0;
        ruling->u = (double)i / (LOOKS - 1);
        for (int e = 0; e < 2; e++) {
            const batten_interval domain = batten_curve_domain(edges[e]);
            at[e] = i == LOOKS - 1 ? domain.b : domain.a + ruling->u * (domain.b - domain.a);
        }
        ruling->s = at[0];
        ruling->t = at[1];
        status = batten_ruling_condition(edges[0], at[0], edges[1], at[1], &condition, &warp);
        ruling->warp = isnan(warp) ? 0 : warp;
    }
    return status;
}

static batten_status find_rulings(const batten_curve *const edges[2],
                                  const batten_surface_developable_options *options,
                                  batten_developable *out)
{
    bat_plate *plate = bat_array(1, sizeof *plate);
    if (!plate)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_plate_edge_make(edges[0], "first", &plate->edge[0]);
    if (status == BATTEN_OK)
        status = bat_plate_edge_make(edges[1], "second", &plate->edge[1]);
    plate->size = bat_max(extent(edges[0]), extent(edges[1]));
    if (status == BATTEN_OK)
        status = bat_plate_find_path(plate);
    if (status == BATTEN_OK)
        status = bat_plate_surface(plate, options, out);
    bat_release(plate->pairs);
    bat_release(plate);
    return status;
}

/* The creases where cones meet the rest are rulings with warp too. */
static void add_creases(const batten_surface_developable_options *options,
                        batten_developable *out)
{
    for (int i = 0; i < out->count; i++)
        if (out->rulings[i].warp > out->warp) {
            out->warp = out->rulings[i].warp;
            out->warp_at = out->rulings[i].u;
        }
    out->is_developable = out->warp <= options->warp && !out->has_regression;
}

static batten_status check_regression(const batten_surface_developable_options *options,
                                      const batten_developable *made)
{
    if (options->keep_regression || options->keep_matching)
        return BATTEN_OK;
    if (made->has_regression)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the rulings meet between the edges, at %g of the ruling at u = %g: "
                        "the edge of regression lies inside the plate",
                        made->regression_share, made->regression_at);
    if (made->warp > BAT_PI / 2)
        return bat_fail(
            BATTEN_NOT_COMPATIBLE,
            "at best the plate folds back at the ruling at u = %g: the edges cross, "
            "touch or run apart",
            made->warp_at);
    return BATTEN_OK;
}

static batten_status make_developable(const batten_curve *const edges[2],
                                      const batten_surface_developable_options *options,
                                      batten_developable *out)
{
    const double a = extent(edges[0]), b = extent(edges[1]);
    const bool point = bat_min(a, b) <= BAT_ROUNDING * bat_max(a, b);
    if (!(bat_max(a, b) > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "both edges are points");
    batten_status status = point ? BATTEN_OK : check_directions(edges[0], edges[1]);
    if (status == BATTEN_OK)
        status = options->keep_matching || point ? keep_matching(edges, out)
                                                 : find_rulings(edges, options, out);
    if (status == BATTEN_OK)
        status = bat_plate_measure(options, out);
    if (status == BATTEN_OK && !point)
        add_creases(options, out);
    if (status == BATTEN_OK)
        status = check_regression(options, out);
    return status;
}

batten_status batten_surface_developable(const batten_curve *first, const batten_curve *second,
                                         const batten_surface_developable_options *options,
                                         batten_developable *out)
{
    assert(first && second && out);
    batten_surface_developable_options chosen = batten_surface_developable_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_surface_developable_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_developable_options *o = &chosen;
    batten_developable made = {0};
    batten_curve *a = NULL, *b = NULL;
    status = check_options(o);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(first, 3, &a);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(second, 3, &b);
    if (status == BATTEN_OK)
        status = make_developable((const batten_curve *const[2]){a, b}, o, &made);
    batten_curve_unref(a);
    batten_curve_unref(b);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_developable_release(&made);
    return status;
}

void batten_developable_release(batten_developable *developable)
{
    batten_surface_unref(developable->surface);
    bat_release(developable->rulings);
    *developable = (batten_developable){0};
}
