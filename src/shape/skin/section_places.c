/* Where the sections of a skin stand along its spine. */
#include "numeric/vector.h"
#include "shape/skin/sections.h"
#include "spline/curve/curve.h"
#include <batten/curvature.h>

#include <string.h>

/* Places of each span at which arc length is tabulated, for the even spacing of sections. */
enum { STEPS_PER_SPAN = 64 };

/* Arc lengths at 64 places of each span, by Simpson's rule; parameters by the cubic that has
 * the speeds there. */
typedef struct {
    int count;
    double *u, *length, *speed;
} ruler;

static batten_status measure_spine(const batten_curve *spine, const double *knots, ruler *r)
{
    const int d = batten_curve_dimension(spine);
    for (int i = 0; i < r->count; i++) {
        const int span = i / STEPS_PER_SPAN;
        const double s = (double)(i % STEPS_PER_SPAN) / STEPS_PER_SPAN;
        double values[6];
        r->u[i] = s == 0 ? knots[span] : (1 - s) * knots[span] + s * knots[span + 1];
        batten_status status = batten_curve_evaluate(spine, r->u[i], 1, values);
        r->speed[i] = bat_norm(d, values + d);
        if (status == BATTEN_OK && i > 0) {
            const double h = r->u[i] - r->u[i - 1];
            const double before = r->speed[i - 1];
            status = batten_curve_evaluate(spine, r->u[i - 1] + h / 2, 1, values);
            r->length[i] =
                r->length[i - 1] + h / 6 * (before + 4 * bat_norm(d, values + d) + r->speed[i]);
        }
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* u between two places where the length is the share x of the piece: the cubic with du / ds = 1
 * / speed. */
static double distance_between(const ruler *r, int i, double x)
{
    const double piece = r->length[i + 1] - r->length[i];
    const double u0 = r->u[i], u1 = r->u[i + 1], y = 1 - x;
    if (!(r->speed[i] > 0 && r->speed[i + 1] > 0))
        return y * u0 + x * u1;
    const double m0 = piece / r->speed[i], m1 = piece / r->speed[i + 1];
    return (1 + 2 * x) * y * y * u0 + (1 + 2 * y) * x * x * u1 + x * y * (y * m0 - x * m1);
}

static void find_even(const ruler *r, int count, double *at)
{
    const double total = r->length[r->count - 1];
    for (int k = 0, i = 0; k < count; k++) {
        const double s = total * k / (count - 1);
        while (i + 2 < r->count && r->length[i + 1] < s)
            i++;
        const double piece = r->length[i + 1] - r->length[i];
        at[k] = distance_between(r, i, piece > 0 ? bat_min(1, (s - r->length[i]) / piece) : 0);
    }
    at[count - 1] = r->u[r->count - 1];
}

static batten_status even_places(const batten_curve *spine, int count, double *at)
{
    const int knot_count = batten_curve_spans(spine, NULL);
    ruler r = {.count = (knot_count - 1) * STEPS_PER_SPAN + 1};
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    r.u = bat_array((size_t)r.count, sizeof *r.u);
    r.length = bat_array((size_t)r.count, sizeof *r.length);
    r.speed = bat_array((size_t)r.count, sizeof *r.speed);
    batten_status status =
        knots && r.u && r.length && r.speed ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(spine, knots);
        status = measure_spine(spine, knots, &r);
    }
    if (status == BATTEN_OK)
        find_even(&r, count, at);
    bat_release(r.speed);
    bat_release(r.length);
    bat_release(r.u);
    bat_release(knots);
    return status;
}

static batten_affine map_of(const batten_frame *frame, double twist, double scale)
{
    const batten_vec3 y = bat_vec3_cross(frame->z, frame->x);
    const double c = bat_cos(twist), s = bat_sin(twist);
    const batten_vec3 a = bat_vec3_along(bat_vec3_scale(frame->x, c), s, y);
    const batten_vec3 b = bat_vec3_along(bat_vec3_scale(y, c), -s, frame->x);
    const batten_vec3 o = frame->origin, z = frame->z;
    return (batten_affine){{{scale * a.x, scale * b.x, scale * z.x},
                            {scale * a.y, scale * b.y, scale * z.y},
                            {scale * a.z, scale * b.z, scale * z.z}},
                           {o.x, o.y, o.z}};
}

static batten_status check_laws(int count, const batten_surface_skin_options *o)
{
    for (int k = 0; k < count; k++) {
        if (o->twist && !isfinite(o->twist[k]))
            return bat_fail(BATTEN_NOT_FINITE, "the twist of section %d is %g", k + 1,
                            o->twist[k]);
        if (o->scale && !isfinite(o->scale[k]))
            return bat_fail(BATTEN_NOT_FINITE, "the scale of section %d is %g", k + 1,
                            o->scale[k]);
        if (o->scale && o->scale[k] <= 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "the scale of section %d is %g, not above 0",
                            k + 1, o->scale[k]);
    }
    return BATTEN_OK;
}

batten_status bat_skin_places(int count, const batten_surface_skin_options *o,
                              batten_affine *maps)
{
    batten_status status = check_laws(count, o);
    if (status != BATTEN_OK)
        return status;
    double *at = bat_array((size_t)count, sizeof *at);
    batten_frame *frames = bat_array((size_t)count, sizeof *frames);
    status = at && frames ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && o->spine_at)
        memcpy(at, o->spine_at, (size_t)count * sizeof *at);
    else if (status == BATTEN_OK)
        status = even_places(o->spine, count, at);
    if (status == BATTEN_OK)
        status = batten_curve_frames(o->spine, count, at, o->frames, frames);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        maps[k] = map_of(&frames[k], o->twist ? o->twist[k] : 0, o->scale ? o->scale[k] : 1);
    bat_release(frames);
    bat_release(at);
    return status;
}
