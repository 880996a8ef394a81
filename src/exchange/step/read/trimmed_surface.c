/* RECTANGULAR_TRIMMED_SURFACE: the part of a surface between parameters of the file, exactly.
 */
#include "exchange/step/read/geometry.h"
#include "numeric/vector.h"
#include <batten/skin.h>
#include <batten/standard.h>

#include <string.h>

/* One direction of the part: from `from` to `to`, with the parameter when `forward`. */
typedef struct {
    double from, to;
    bool forward;
} range;

static double low(const range *r)
{
    return r->forward ? r->from : r->to;
}

static double high(const range *r)
{
    return r->forward ? r->to : r->from;
}

/* Angles in radians, the higher up to a turn above the lower. */
static range as_angles(range r, double unit)
{
    const double around = 2 * BAT_PI, a = low(&r) * unit, b = high(&r) * unit;
    double turn = b - a - around * floor((b - a) / around);
    if (!(turn > 1e-9 && turn < around - 1e-9)) /* the same place: all around */
        turn = around;
    return r.forward ? (range){a, a + turn, true} : (range){a + turn, a, false};
}

static range scaled(range r, double unit)
{
    return (range){r.from * unit, r.to * unit, r.forward};
}

/* Where the sense contradicts the order, the order counts. */
static range in_order(range r)
{
    return low(&r) <= high(&r) ? r : (range){r.from, r.to, !r.forward};
}

/* With u and v from low to high: give it the domain and turn what runs against the parameter.
 */
static batten_status finish_trim(batten_surface *made, const range *u, const range *v,
                                 batten_surface **out)
{
    const range *const ranges[2] = {u, v};
    batten_surface *now = batten_surface_ref(made), *next = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 4; k++) {
        const range *r = ranges[k / 2];
        const batten_direction direction = k / 2 ? BATTEN_V : BATTEN_U;
        if (k % 2 == 0)
            status = batten_surface_set_domain(now, direction, low(r), high(r), &next);
        else if (!r->forward)
            status = batten_surface_reverse(now, direction, &next);
        else
            continue;
        if (status == BATTEN_OK) {
            batten_surface_unref(now);
            now = next;
        }
    }
    if (status == BATTEN_OK)
        *out = now;
    else
        batten_surface_unref(now);
    return status;
}

/* ---- planes and surfaces about an axis ---- */

static batten_status plane(const batten_frame *frame, const range *u, const range *v,
                           batten_surface **out)
{
    const batten_vec3 y = bat_vec3_cross(frame->z, frame->x);
    batten_vec3 p[4];
    for (int i = 0; i < 4; i++)
        p[i] = bat_vec3_along(bat_vec3_along(frame->origin, i & 1 ? high(u) : low(u), frame->x),
                              i & 2 ? high(v) : low(v), y);
    return batten_surface_bilinear(p[0], p[1], p[2], p[3], out);
}

/* The line or arc that is turned, in the half plane of u = 0, from v.a to v.b. */
static batten_status profile(const bat_elementary *e, const range *v, batten_curve **out)
{
    const batten_frame *f = &e->frame;
    bat_conic conic = {.kind = BAT_LINE, .frame = *f};
    if (e->kind == BAT_CYLINDER || e->kind == BAT_CONE) {
        const double slope = e->kind == BAT_CONE ? bat_tan(e->b) : 0;
        conic.frame.origin = bat_vec3_along(f->origin, e->a, f->x);
        conic.frame.x = bat_vec3_along(f->z, slope, f->x);
        conic.frame.z = bat_vec3_cross(f->z, f->x);
    } else {
        const bool is_torus = e->kind == BAT_TORUS;
        conic.kind = BAT_ELLIPSE;
        conic.a = conic.b = is_torus ? e->b : e->a;
        if (is_torus)
            conic.frame.origin = bat_vec3_along(f->origin, e->a, f->x);
        conic.frame.z = bat_vec3_cross(f->x, f->z); /* its second axis is z of the surface */
    }
    return bat_conic_between(&conic, low(v), high(v), out);
}

/* The profile in its place at the angle u.a, and turned to u.b. */
static batten_status turned(const batten_curve *curve, const batten_frame *axis, const range *u,
                            batten_surface **out)
{
    const batten_affine start = batten_affine_rotation(axis->origin, axis->z, low(u));
    const double angle = bat_min(high(u) - low(u), 2 * BAT_PI);
    batten_curve *moved = NULL;
    batten_status status = batten_curve_transform(curve, &start, &moved);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(moved, axis->origin, axis->z, angle, out);
    batten_curve_unref(moved);
    return status;
}

static batten_status primitive(const bat_step_reading *reading,
                               const bat_step_instance *instance, const bat_elementary *e,
                               range u, range v, batten_surface **out)
{
    const double length = reading->scale.length, angle = reading->scale.angle;
    const bool has_angle = e->kind == BAT_SPHERE || e->kind == BAT_TORUS;
    batten_curve *curve = NULL;
    batten_surface *made = NULL;
    batten_status status = BATTEN_OK;
    if (e->kind == BAT_PLANE) {
        u = in_order(scaled(u, length));
        v = in_order(scaled(v, length));
        status = plane(&e->frame, &u, &v, &made);
    } else {
        u = as_angles(u, angle);
        v = e->kind == BAT_TORUS ? as_angles(v, angle)
                                 : in_order(scaled(v, has_angle ? angle : length));
        status = profile(e, &v, &curve);
        if (status == BATTEN_OK)
            status = turned(curve, &e->frame, &u, &made);
    }
    if (status == BATTEN_OK)
        status = finish_trim(made, &u, &v, out);
    batten_curve_unref(curve);
    batten_surface_unref(made);
    return bat_step_blame(reading->file, instance, status);
}

/* ---- what is swept ---- */

static batten_status revolution(const bat_step_reading *reading, const bat_step_sweep *sweep,
                                range u, range v, batten_surface **out)
{
    batten_curve *curve = NULL;
    batten_surface *made = NULL;
    u = as_angles(u, reading->scale.angle);
    batten_status status =
        bat_step_curve_between(reading, sweep->curve, v.from, v.to, v.forward, &curve);
    if (status == BATTEN_OK)
        status = turned(curve, &sweep->frame, &u, &made);
    if (status == BATTEN_OK) { /* the curve has been turned already */
        const batten_interval domain = batten_surface_domain(made, BATTEN_V);
        const range along = {domain.a, domain.b, true};
        status = finish_trim(made, &u, &along, out);
    }
    batten_curve_unref(curve);
    batten_surface_unref(made);
    return status;
}

static batten_status extrusion(const bat_step_reading *reading, const bat_step_sweep *sweep,
                               range u, range v, batten_surface **out)
{
    const batten_vec3 z = sweep->frame.z;
    batten_curve *curve = NULL, *base = NULL;
    batten_surface *made = NULL;
    v = in_order(v);
    const double from = low(&v), length = high(&v) - from;
    const batten_affine start = batten_affine_translation(from * z.x, from * z.y, from * z.z);
    batten_status status =
        bat_step_curve_between(reading, sweep->curve, u.from, u.to, u.forward, &curve);
    if (status == BATTEN_OK)
        status = batten_curve_transform(curve, &start, &base);
    if (status == BATTEN_OK)
        status = batten_surface_extruded(base, bat_vec3_scale(z, length), &made);
    if (status == BATTEN_OK) {
        const batten_interval domain = batten_surface_domain(made, BATTEN_U);
        const range along = {domain.a, domain.b, true};
        status = finish_trim(made, &along, &v, out);
    }
    batten_curve_unref(curve);
    batten_curve_unref(base);
    batten_surface_unref(made);
    return status;
}

/* ---- B-splines, and offsets ---- */

static batten_status part_of_surface(const batten_surface *whole, range u, range v,
                                     batten_surface **out)
{
    const range ranges[2] = {in_order(u), in_order(v)};
    batten_surface *now = batten_surface_ref(whole), *next = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const batten_interval domain = batten_surface_domain(now, direction);
        const double slack = BAT_WRITTEN * (domain.b - domain.a), a = low(&ranges[k]),
                     b = high(&ranges[k]);
        if (!(a >= domain.a - slack && b <= domain.b + slack))
            status = bat_fail(BATTEN_OUT_OF_DOMAIN,
                              "the part from %g to %g is not in the domain from %g to %g", a, b,
                              domain.a, domain.b);
        else if (!(a <= domain.a && b >= domain.b)) {
            status = batten_surface_subrange(now, direction, bat_max(a, domain.a),
                                             bat_min(b, domain.b), &next);
            if (status == BATTEN_OK) {
                batten_surface_unref(now);
                now = next;
            }
        }
    }
    if (status == BATTEN_OK) { /* its domain is right already, but for rounding */
        const batten_interval du = batten_surface_domain(now, BATTEN_U),
                              dv = batten_surface_domain(now, BATTEN_V);
        const range over[2] = {
            ranges[0].forward ? (range){du.a, du.b, true} : (range){du.b, du.a, false},
            ranges[1].forward ? (range){dv.a, dv.b, true} : (range){dv.b, dv.a, false}};
        status = finish_trim(now, &over[0], &over[1], out);
    }
    batten_surface_unref(now);
    return status;
}

/* The part of a surface that is made as a whole, when its parameters are the file's. */
static batten_status of_spline(const bat_step_reading *reading,
                               const bat_step_instance *instance,
                               const bat_step_instance *basis, const range *u, const range *v,
                               batten_surface **out)
{
    const bat_step_file *file = reading->file;
    const bat_step_record *offset = bat_step_as(file, basis, "OFFSET_SURFACE");
    const bat_step_instance *below = basis;
    bat_elementary elementary;
    bat_step_basis of = {NULL, NULL, false};
    batten_surface *whole = NULL;
    bool is_primitive = false;
    batten_status status = BATTEN_OK;
    if (offset)
        status = bat_step_get_reference(file, offset, 1, &below);
    if (status == BATTEN_OK)
        status = bat_step_primitive_in(reading, below, &elementary, &is_primitive);
    if (status == BATTEN_OK && is_primitive) { /* its offset is another */
        status = bat_step_elementary_in(reading, basis, &elementary, &of, &is_primitive);
        bat_step_basis_end(&of);
        return status == BATTEN_OK ? primitive(reading, instance, &elementary, *u, *v, out)
                                   : status;
    }
    if (status == BATTEN_OK && !bat_step_is_spline_surface(file, below))
        status = bat_step_fail(file, instance, BATTEN_UNSUPPORTED,
                               "a part of such a surface between parameters is not read");
    if (status == BATTEN_OK)
        status = bat_step_surface_in(reading, basis, &whole);
    if (status == BATTEN_OK)
        status = bat_step_blame(file, instance, part_of_surface(whole, *u, *v, out));
    batten_surface_unref(whole);
    return status;
}

/* RECTANGULAR_TRIMMED_SURFACE(name, basis, u1, u2, v1, v2, usense, vsense) */
batten_status bat_step_trimmed_surface(const bat_step_reading *reading,
                                       const bat_step_instance *instance,
                                       const bat_step_record *record, batten_surface **out)
{
    const bat_step_file *file = reading->file;
    const bat_step_instance *basis = NULL;
    double at[4] = {0, 0, 0, 0};
    bool sense[2] = {true, true}, is_it = false;
    bat_elementary elementary;
    bat_step_sweep sweep;
    batten_status status = bat_step_check_arguments(file, record, 8);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 1, &basis);
    for (int k = 0; status == BATTEN_OK && k < 4; k++)
        status = bat_step_get_real(file, record, 2 + k, &at[k]);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_step_get_logical(file, record, 6 + k, &sense[k]);
    for (int k = 0; status == BATTEN_OK && k < 4; k++)
        /* So that differences and squares of the parameters do not overflow. */
        if (!(fabs(at[k]) < 1e100) || at[k / 2 * 2] == at[k / 2 * 2 + 1])
            status =
                bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "its %c runs from %g to %g",
                              k < 2 ? 'u' : 'v', at[k / 2 * 2], at[k / 2 * 2 + 1]);
    const range u = {at[0], at[1], sense[0]}, v = {at[2], at[3], sense[1]};
    if (status == BATTEN_OK)
        status = bat_step_primitive_in(reading, basis, &elementary, &is_it);
    if (status == BATTEN_OK && is_it)
        return primitive(reading, instance, &elementary, u, v, out);
    if (status == BATTEN_OK)
        status = bat_step_sweep_in(reading, basis, &sweep, &is_it);
    if (status == BATTEN_OK && is_it)
        return bat_step_blame(file, instance,
                              sweep.turned ? revolution(reading, &sweep, u, v, out)
                                           : extrusion(reading, &sweep, u, v, out));
    return status == BATTEN_OK ? of_spline(reading, instance, basis, &u, &v, out) : status;
}
