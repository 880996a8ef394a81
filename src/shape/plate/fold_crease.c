/* The crease of a fold and what is known along it: lengths, frames, angles of the sheets. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/fold_parts.h"
#include <batten/curvature.h>
#include <batten/interpolate.h>
#include <batten/measure.h>

#include <string.h>

enum { STEPS = 16 };

/* ---- values along the crease ---- */

/* The function through `count` values at equal steps over [0, length]. */
batten_status bat_fold_function(int count, const double *values, double length,
                                batten_curve **out)
{
    if (count == 1) {
        const double both[2] = {values[0], values[0]}, knots[4] = {0, 0, length, length};
        return batten_curve_create((batten_points){1, 2, both}, 1, NULL, knots, out);
    }
    double *s = bat_array((size_t)count, sizeof *s);
    if (!s)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        s[i] = i == count - 1 ? length : length * i / (count - 1);
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    const batten_status status =
        batten_curve_interpolate((batten_points){1, count, values}, &options, NULL, out);
    bat_release(s);
    return status;
}

/* Value and derivative; a place a few ulps beyond the end counts as the end. */
batten_status bat_fold_value_at(const batten_curve *function, double s, double out[2])
{
    const batten_interval domain = batten_curve_domain(function);
    return batten_curve_evaluate(function, bat_min(bat_max(s, domain.a), domain.b), 1, out);
}

static batten_status check_angle(double a, double s)
{
    if (!(fabs(a) < BAT_PI / 2 && a != 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the angle is %g degrees at the length %g of the crease; it must be "
                        "between 0 and 90, and not 0",
                        a * 180 / BAT_PI, s);
    return BATTEN_OK;
}

static batten_status straight(double s)
{
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "the crease is straight at the length %g: no rulings are defined there", s);
}

/* The angle where the flat curvature is given, and its rate by that of both curvatures. */
static batten_status angle_of_curvature(const bat_fold_task *t, const double flat[2],
                                        double k_rate, bat_fold_place *p)
{
    if (!(fabs(flat[0]) < p->k))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "at the length %g the flat crease has the curvature %g, which must be "
                        "below that in space, %g",
                        p->s, flat[0], p->k);
    const double sign = t->options->other_side ? -1 : 1, c = flat[0] / p->k;
    p->a = sign * bat_acos(c);
    p->a_rate = -sign * (flat[1] - c * k_rate) / p->k / sqrt(1 - c * c);
    return BATTEN_OK;
}

/* ---- the crease in space ---- */

batten_status bat_fold_find_place(const bat_fold_task *t, double s, double u, bat_fold_place *p)
{
    batten_curve_local local;
    const batten_interval domain = batten_curve_domain(t->space);
    batten_status status = batten_curve_local_at(
        t->space, u, u == domain.b ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &local);
    if (status != BATTEN_OK)
        return status;
    double law[2];
    status = bat_fold_value_at(t->law, s, law);
    if (status != BATTEN_OK)
        return status;
    *p = (bat_fold_place){.s = s,
                          .u = u,
                          .X = local.point,
                          .T = local.tangent,
                          .N = local.normal,
                          .B = local.binormal,
                          .k = local.curvature,
                          .tau = local.torsion};
    if (!(p->k > 0))
        return straight(s);
    if (t->options->given == BATTEN_FOLD_CURVATURE)
        return angle_of_curvature(t, law, local.curvature_rate, p);
    p->a = law[0];
    p->a_rate = law[1];
    return check_angle(p->a, s);
}

batten_status bat_fold_find_places(bat_fold_task *t)
{
    const int n = t->count;
    double *s = bat_array((size_t)n, sizeof *s), *u = bat_array((size_t)n, sizeof *u);
    batten_status status = s && u ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++)
        s[i] = i == n - 1 ? t->made.length : t->made.length * i / (n - 1);
    if (status == BATTEN_OK)
        status = batten_curve_at_length(t->space, n, s, BAT_EXACT * t->made.length, u);
    for (int i = 0; i < n && status == BATTEN_OK; i++)
        status = bat_fold_find_place(t, s[i], u[i], &t->at[i]);
    bat_release(s);
    bat_release(u);
    return status;
}

/* ---- from the flat crease to space: Frenet's equations ---- */

typedef struct {
    double v[12]; /* X, T, N, B */
} moving_frame;

/* The derivative by arc length of the frame at a place where k and tau are known. */
static moving_frame turned_frame(const moving_frame *f, double k, double tau)
{
    moving_frame d;
    for (int c = 0; c < 3; c++) {
        d.v[c] = f->v[3 + c];
        d.v[3 + c] = k * f->v[6 + c];
        d.v[6 + c] = -k * f->v[3 + c] + tau * f->v[9 + c];
        d.v[9 + c] = -tau * f->v[6 + c];
    }
    return d;
}

/* Signed curvature in the flat sheet, angle and torsion at the length s. */
static batten_status flat_curvatures(const bat_fold_task *t, double s, double *k, double *tau)
{
    double u, law[2], torsion[2] = {0, 0};
    batten_curve_local local;
    batten_status status =
        batten_curve_at_length(t->crease, 1, &s, BAT_EXACT * t->made.length, &u);
    if (status == BATTEN_OK)
        status = batten_curve_local_at(t->crease, u, BATTEN_FROM_RIGHT, &local);
    if (status == BATTEN_OK)
        status = bat_fold_value_at(t->law, s, law);
    if (status == BATTEN_OK && t->torsion)
        status = bat_fold_value_at(t->torsion, s, torsion);
    if (status == BATTEN_OK)
        status = check_angle(law[0], s);
    if (status == BATTEN_OK && !(fabs(local.curvature) > 0))
        status = straight(s);
    if (status != BATTEN_OK)
        return status;
    *k = fabs(local.curvature) / bat_cos(law[0]);
    *tau = torsion[0];
    return BATTEN_OK;
}

/* One step of Runge and Kutta, order 4, from s to s + h. */
static batten_status runge_kutta(const bat_fold_task *t, double s, double h, moving_frame *f)
{
    static const double where[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    moving_frame sum = {{0}}, slope = {{0}};
    for (int i = 0; i < 4; i++) {
        moving_frame at = *f;
        double k = 0, tau = 0;
        for (int c = 0; c < 12 && i > 0; c++)
            at.v[c] += where[i] * h * slope.v[c];
        const batten_status status =
            flat_curvatures(t, bat_min(s + where[i] * h, t->made.length), &k, &tau);
        if (status != BATTEN_OK)
            return status;
        slope = turned_frame(&at, k, tau);
        for (int c = 0; c < 12; c++)
            sum.v[c] += weight[i] * slope.v[c];
    }
    for (int c = 0; c < 12; c++)
        f->v[c] += h / 6 * sum.v[c];
    return BATTEN_OK;
}

/* The frame stays square though steps are rounded. */
static void square(moving_frame *f)
{
    const double size = bat_norm(3, f->v + 3), along = bat_dot(3, f->v + 3, f->v + 6);
    for (int c = 0; c < 3; c++)
        f->v[6 + c] -= along / (size * size) * f->v[3 + c];
    const double other = bat_norm(3, f->v + 6);
    for (int c = 0; c < 3; c++) {
        f->v[3 + c] /= size;
        f->v[6 + c] /= other;
    }
    const batten_vec3 b = bat_vec3_cross(bat_vec3_of(3, f->v + 3), bat_vec3_of(3, f->v + 6));
    f->v[9] = b.x;
    f->v[10] = b.y;
    f->v[11] = b.z;
}

/* How the space curve begins: as the flat one, seen so that it turns to the left. */
static batten_status begin_frame(const bat_fold_task *t, moving_frame *f)
{
    batten_curve_local at;
    const batten_status status = batten_curve_local_at(
        t->crease, batten_curve_domain(t->crease).a, BATTEN_FROM_RIGHT, &at);
    if (status != BATTEN_OK)
        return status;
    const double left = at.curvature < 0 ? -1 : 1;
    *f = (moving_frame){{at.point.x, at.point.y, at.point.z, at.tangent.x, at.tangent.y,
                         at.tangent.z, left * at.normal.x, left * at.normal.y,
                         left * at.normal.z}};
    square(f);
    return BATTEN_OK;
}

/* Point, tangent and curvature vector at `count` equal steps of length: values [count][9]. */
static batten_status integrate_frames(const bat_fold_task *t, int count, double *s,
                                      double *values)
{
    const double h = t->made.length / (count - 1);
    moving_frame f;
    batten_status status = begin_frame(t, &f);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        double k = 0, tau = 0;
        s[i] = i * h;
        status = flat_curvatures(t, bat_min(s[i], t->made.length), &k, &tau);
        memcpy(values + 9 * i, f.v, 6 * sizeof *values);
        for (int c = 0; c < 3; c++)
            values[9 * i + 6 + c] = k * f.v[6 + c];
        for (int j = 0; j < STEPS && i + 1 < count && status == BATTEN_OK; j++)
            status = runge_kutta(t, s[i] + j * h / STEPS, h / STEPS, &f);
        square(&f);
    }
    return status;
}

/* The crease that the flat one becomes, as a quintic that goes by arc length. */
static batten_status raise_crease(bat_fold_task *t)
{
    enum { COUNT = 257 };
    double *s = bat_array(COUNT, sizeof *s), *values = bat_array(COUNT, 9 * sizeof *values);
    batten_status status = s && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = integrate_frames(t, COUNT, s, values);
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(3, COUNT, 3, s, values, &t->space);
    bat_release(s);
    bat_release(values);
    return status;
}

/* ---- both ways ---- */

/* The crease in space, its length, and the laws along it. */
batten_status bat_fold_prepare(bat_fold_task *t)
{
    const batten_fold_create_options *o = t->options;
    const bool is_flat = o->given == BATTEN_FOLD_FLAT;
    /* First roughly, for the size; then as exactly as rounding allows. */
    double size = 0;
    batten_status status = batten_curve_length(t->crease, 1e-6, NULL, &size);
    if (status == BATTEN_OK && !(size > 0))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the crease has no length");
    if (status == BATTEN_OK)
        status = batten_curve_length(t->crease, BAT_EXACT * size, NULL, &t->made.length);
    if (status == BATTEN_OK)
        status = bat_fold_function(o->count, o->values, t->made.length, &t->law);
    if (status == BATTEN_OK && o->torsion_count > 0)
        status = bat_fold_function(o->torsion_count, o->torsions, t->made.length, &t->torsion);
    if (status == BATTEN_OK && is_flat)
        return raise_crease(t);
    if (status == BATTEN_OK)
        t->space = batten_curve_ref(t->crease);
    return status;
}
