/* Fillets: arcs at the stations of a rolling ball, and the spline through them, in homogeneous
 * coordinates. */
#include "shape/surface_change/fillet.h"
#include "base/plural.h"
#include "numeric/rounding.h"

#include "spline/curve/curve.h"
#include "spline/surface/surface.h"
#include <batten/curvature.h>
#include <batten/interpolate.h>

#include <string.h>

/* What is interpolated along the spine. */
enum { FIRST, SECOND, SHOULDER, WEIGHT, SPINE, ON_FIRST, ON_SECOND, PARTS };
enum { LEAST_STATIONS = 7, MOST_STATIONS = 5000 };

static const int dimensions[PARTS] = {3, 3, 3, 1, 3, 2, 2};

typedef struct {
    bat_rolling rolling;
    double tolerance;
    bat_spine spine;
    double *s; /* [count] parameters of the stations */
    batten_curve *curves[PARTS];
    batten_surface_fillet *out;
} filleting;

void batten_surface_fillet_release(batten_surface_fillet *fillet)
{
    if (!fillet)
        return;
    batten_surface_unref(fillet->surface);
    batten_curve_unref(fillet->spine);
    for (int k = 0; k < 2; k++) {
        batten_curve_unref(fillet->contacts[k]);
        batten_curve_unref(fillet->on[k]);
    }
    *fillet = (batten_surface_fillet){0};
}

/* The rows of a station: the arc's shoulder is the weight times its middle control point. */
static void rows_of(const filleting *t, const bat_ball *b, double rows[PARTS][3])
{
    const double r = fabs(t->rolling.radii[0]);
    const batten_vec3 a = bat_vec3_scale(bat_vec3_subtract(b->contact[0], b->centre), 1 / r);
    const batten_vec3 c = bat_vec3_scale(bat_vec3_subtract(b->contact[1], b->centre), 1 / r);
    const batten_vec3 sum = bat_vec3_add(a, c);
    const double norm = bat_vec3_norm(sum), w = norm / 2;
    const batten_vec3 shoulder = bat_vec3_along(bat_vec3_scale(b->centre, w), r / norm, sum);
    const batten_vec3 points[] = {
        b->contact[0],         b->contact[1],        shoulder, {w, 0, 0}, b->centre,
        {b->x[0], b->x[1], 0}, {b->x[2], b->x[3], 0}};
    for (int k = 0; k < PARTS; k++)
        memcpy(rows[k], (const double[3]){points[k].x, points[k].y, points[k].z},
               3 * sizeof(double));
}

/* The middle of an arc from its rows. */
static batten_vec3 arc_middle(double rows[PARTS][3])
{
    const batten_vec3 ends =
        bat_vec3_add(bat_vec3_of(3, rows[FIRST]), bat_vec3_of(3, rows[SECOND]));
    return bat_vec3_scale(bat_vec3_along(ends, 2, bat_vec3_of(3, rows[SHOULDER])),
                          1 / (2 + 2 * rows[WEIGHT][0]));
}

/* ---- the spline ---- */

static void release_curves(filleting *t)
{
    for (int k = 0; k < PARTS; k++) {
        batten_curve_unref(t->curves[k]);
        t->curves[k] = NULL;
    }
}

static batten_status interpolate(filleting *t)
{
    const int n = t->spine.count;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    double *points = bat_array((size_t)n, 3 * sizeof *points);
    bat_release(t->s);
    t->s = bat_array((size_t)n, sizeof *t->s);
    batten_status status = points && t->s ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 1; status == BATTEN_OK && i < n; i++)
        t->s[i] = t->s[i - 1] + bat_vec3_norm(bat_vec3_subtract(t->spine.balls[i].centre,
                                                                t->spine.balls[i - 1].centre));
    options.parameters = BATTEN_GIVEN;
    options.given = t->s;
    release_curves(t);
    for (int k = 0; k < PARTS && status == BATTEN_OK; k++) {
        for (int i = 0; i < n; i++) {
            double rows[PARTS][3];
            rows_of(t, &t->spine.balls[i], rows);
            memcpy(points + i * dimensions[k], rows[k], (size_t)dimensions[k] * sizeof *points);
        }
        status = batten_curve_interpolate((batten_points){dimensions[k], n, points}, &options,
                                          NULL, &t->curves[k]);
    }
    bat_release(points);
    return status;
}

/* Stations halfway between those there are, in planes across the chords. */
static batten_status double_stations(filleting *t)
{
    const int n = t->spine.count;
    if (2 * n - 1 > MOST_STATIONS)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "with %d station%s the fillet is still %g from the truth", n,
                        bat_plural(n), t->out->error);
    bat_ball *made = bat_array((size_t)(2 * n - 1), sizeof *made);
    batten_status status = made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++) {
        const bat_ball *a = &t->spine.balls[i];
        made[2 * i] = *a;
        if (i + 1 == n)
            break;
        const batten_vec3 chord = bat_vec3_subtract(a[1].centre, a->centre);
        const batten_vec3 point = bat_vec3_along(a->centre, 0.5, chord);
        const batten_vec3 normal = bat_vec3_scale(chord, 1 / bat_vec3_norm(chord));
        double x[4];
        bool found = false;
        for (int k = 0; k < 4; k++)
            x[k] = a->x[k] + (a[1].x[k] - a->x[k]) / 2;
        status = bat_ball_in_plane(&t->rolling, x, &point, &normal, &made[2 * i + 1], &found);
        if (status == BATTEN_OK && !found)
            status = bat_fail(BATTEN_NOT_FOUND, "the ball is lost near (%g, %g), (%g, %g)",
                              x[0], x[1], x[2], x[3]);
    }
    if (status != BATTEN_OK) {
        bat_release(made);
        return status;
    }
    bat_release(t->spine.balls);
    t->spine = (bat_spine){2 * n - 1, made};
    return BATTEN_OK;
}

/* How far the spline is from the fillet halfway between two stations. */
static batten_status error_at(filleting *t, double s)
{
    double rows[PARTS][3] = {{0}}, truth[PARTS][3], spine[6];
    batten_status status = BATTEN_OK;
    for (int k = 0; k < PARTS && status == BATTEN_OK; k++)
        status = batten_curve_evaluate(t->curves[k], s, 0, rows[k]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(t->curves[SPINE], s, 1, spine);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 point = bat_vec3_of(3, spine);
    const batten_vec3 normal =
        bat_vec3_scale(bat_vec3_of(3, spine + 3), 1 / bat_norm(3, spine + 3));
    const double x[4] = {rows[ON_FIRST][0], rows[ON_FIRST][1], rows[ON_SECOND][0],
                         rows[ON_SECOND][1]};
    double inside[4];
    bat_ball ball;
    bool found = false;
    for (int j = 0; j < 4; j++) {
        const batten_interval d =
            batten_surface_domain(t->rolling.surfaces[j / 2], (batten_direction)(j % 2));
        inside[j] = bat_max(d.a, bat_min(d.b, x[j]));
    }
    status = bat_ball_in_plane(&t->rolling, inside, &point, &normal, &ball, &found);
    if (status != BATTEN_OK || !found)
        return status == BATTEN_OK ? bat_fail(BATTEN_NOT_FOUND, "the ball is lost at %g", s)
                                   : status;
    rows_of(t, &ball, truth);
    double far = bat_max(bat_distance(3, rows[FIRST], truth[FIRST]),
                         bat_distance(3, rows[SECOND], truth[SECOND]));
    far = bat_max(far, bat_vec3_norm(bat_vec3_subtract(arc_middle(rows), arc_middle(truth))));
    t->out->error = bat_max(t->out->error, far);
    return BATTEN_OK;
}

static batten_status fit_arcs(filleting *t)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && t->spine.count < LEAST_STATIONS)
        status = double_stations(t);
    while (status == BATTEN_OK) {
        status = interpolate(t);
        t->out->error = 0;
        for (int i = 1; i < t->spine.count && status == BATTEN_OK; i++)
            status = error_at(t, t->s[i - 1] + (t->s[i] - t->s[i - 1]) / 2);
        if (status == BATTEN_OK && t->out->error <= t->tolerance)
            break;
        if (status == BATTEN_OK)
            status = double_stations(t);
    }
    return status;
}

/* ---- the surface ---- */

static batten_status make_surface(const filleting *t, batten_surface **out)
{
    const batten_curve *first = t->curves[FIRST];
    const int n = first->count;
    const bat_nurbs_shape shape = {
        .dimension = 3, .degree = {first->degree, 2}, .count = {n, 3}, .rational = true};
    bat_nurbs *made = NULL;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    memcpy(made->axes[0].knots, first->knots, (size_t)(n + first->degree + 1) * sizeof(double));
    for (int i = 0; i < 6; i++)
        made->axes[1].knots[i] = i > 2;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            const double w = t->curves[WEIGHT]->points[i];
            made->points[9 * i + c] = first->points[3 * i + c];
            made->points[9 * i + 3 + c] = t->curves[SHOULDER]->points[3 * i + c] / w;
            made->points[9 * i + 6 + c] = t->curves[SECOND]->points[3 * i + c];
            made->weights[3 * i + c] = c == 1 ? w : 1;
        }
    return bat_nurbs_finish(made, out);
}

/* A ball must be less curved than no hollow it rolls in; and angles. */
static batten_status check_balls(filleting *t)
{
    const double r = fabs(t->rolling.radii[0]);
    t->out->least = HUGE_VAL;
    for (int i = 0; i < t->spine.count; i++) {
        const bat_ball *b = &t->spine.balls[i];
        const double chord = bat_vec3_norm(bat_vec3_subtract(b->contact[0], b->contact[1]));
        const double angle = 2 * bat_asin(bat_min(1, chord / (2 * r)));
        t->out->least = bat_min(t->out->least, angle);
        t->out->most = bat_max(t->out->most, angle);
        for (int k = 0; k < 2; k++) {
            batten_surface_local local;
            const double *x = b->x + 2 * k, signed_r = t->rolling.radii[k];
            const batten_status status =
                batten_surface_local_at(t->rolling.surfaces[k], x[0], x[1], &local);
            if (status == BATTEN_SINGULAR_HERE)
                continue; /* a pole */
            if (status != BATTEN_OK)
                return status;
            const double bend = bat_max(signed_r * local.kappa1, signed_r * local.kappa2);
            if (bend > 1 + BAT_MEANT_SAME)
                return bat_fail(BATTEN_SINGULAR_HERE,
                                "the ball of radius %g does not fit on surface %d at (%.6g, "
                                "%.6g), where it is hollow with the radius %g",
                                r, k + 1, x[0], x[1], r / bend);
        }
    }
    return BATTEN_OK;
}

static batten_status fillet(filleting *t, const double *start)
{
    batten_status status = bat_spine_find(&t->rolling, start, &t->spine, t->out->ends);
    if (status == BATTEN_OK)
        status = check_balls(t);
    if (status == BATTEN_OK)
        status = fit_arcs(t);
    if (status == BATTEN_OK)
        status = make_surface(t, &t->out->surface);
    if (status != BATTEN_OK)
        return status;
    t->out->stations = t->spine.count;
    t->out->spine = batten_curve_ref(t->curves[SPINE]);
    for (int k = 0; k < 2; k++) {
        t->out->contacts[k] = batten_curve_ref(t->curves[FIRST + k]);
        t->out->on[k] = batten_curve_ref(t->curves[ON_FIRST + k]);
    }
    return BATTEN_OK;
}

/* ---- the call ---- */

static batten_status check_fillet(const filleting *t, const double *start)
{
    const double *r = t->rolling.radii;
    if (!isfinite(r[0]) || !isfinite(r[1]) || !isfinite(t->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "radii %g and %g, within %g", r[0], r[1],
                        t->tolerance);
    if (r[0] == 0 || fabs(r[0]) != fabs(r[1]) || t->tolerance <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "radii %g and %g, within %g: one radius and a tolerance above 0 are "
                        "needed",
                        r[0], r[1], t->tolerance);
    for (int k = 0; k < 2; k++) {
        const batten_surface *surface = t->rolling.surfaces[k];
        if (surface->kind != &bat_nurbs_kind || surface->dimension != 3)
            return bat_fail(BATTEN_UNSUPPORTED, "surface %d is not a NURBS surface in space",
                            k + 1);
        for (int j = 0; start && j < 2; j++) {
            const batten_interval d = batten_surface_domain(surface, (batten_direction)j);
            if (!(start[2 * k + j] >= d.a && start[2 * k + j] <= d.b))
                return bat_fail(BATTEN_OUT_OF_DOMAIN, "the start %g on surface %d is outside",
                                start[2 * k + j], k + 1);
        }
    }
    return BATTEN_OK;
}

batten_status batten_surfaces_fillet(const batten_surface *const surfaces[2],
                                     const double radii[2], const double *start,
                                     double tolerance, batten_surface_fillet *out)
{
    assert(surfaces && surfaces[0] && surfaces[1] && radii && out);
    batten_surface_fillet made = {0};
    filleting t = {.rolling = {surfaces, radii, 0}, .tolerance = tolerance, .out = &made};
    batten_status status = check_fillet(&t, start);
    if (status != BATTEN_OK)
        return status;
    t.rolling.size = bat_max(bat_surface_nurbs(surfaces[0])->largest,
                             bat_surface_nurbs(surfaces[1])->largest);
    t.rolling.size = bat_max(t.rolling.size, fabs(radii[0]));
    status = fillet(&t, start);
    release_curves(&t);
    bat_release(t.s);
    bat_release(t.spine.balls);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_fillet_release(&made);
    return status;
}
