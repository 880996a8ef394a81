/* Directions on a surface, from its forms in an orthonormal frame of the tangent plane. */
#include "inspect/followed/slope.h"

#include "numeric/vector.h"

/* Principal curvatures that differ by a smaller part of the larger one have no directions. */
static const double umbilic = 1e-6;
/* Derivatives parallel to a few thousand roundings span no plane. */
static const double parallel = 1e-12;

/* The frame first, second in the tangent plane; Su = (a, 0) and Sv = (b, c) in it. */
typedef struct {
    batten_vec3 first, second, normal;
    double a, b, c;
    batten_vec3 point, uu, uv, vv;
} frame;

static batten_status lay_frame(const bat_slope_field *field, const double place[2], frame *out,
                               bool *is_regular)
{
    double uv[2], s[BATTEN_SURFACE_DERIVATIVES(2)][3];
    bat_slope_wrap(field, place, uv);
    const batten_status status = batten_surface_evaluate(field->surface, uv[0], uv[1], 2, s[0]);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 su = bat_vec3_of(3, s[1]), sv = bat_vec3_of(3, s[2]);
    const batten_vec3 n = bat_vec3_cross(su, sv);
    const double area = bat_vec3_norm(n), length = bat_vec3_norm(su);
    *is_regular = area > parallel * length * bat_vec3_norm(sv);
    if (!*is_regular)
        return BATTEN_OK;
    out->point = bat_vec3_of(3, s[0]);
    out->uu = bat_vec3_of(3, s[3]);
    out->uv = bat_vec3_of(3, s[4]);
    out->vv = bat_vec3_of(3, s[5]);
    out->normal = bat_vec3_scale(n, 1 / area);
    out->first = bat_vec3_scale(su, 1 / length);
    out->second = bat_vec3_cross(out->normal, out->first);
    out->a = length;
    out->b = bat_vec3_dot(sv, out->first);
    out->c = bat_vec3_dot(sv, out->second);
    return BATTEN_OK;
}

/* The step in u and v of a vector (x, y) of the frame. */
static void in_parameters(const frame *f, double x, double y, double out[2])
{
    out[1] = y / f->c;
    out[0] = (x - out[1] * f->b) / f->a;
}

void bat_slope_wrap(const bat_slope_field *field, const double place[2], double uv[2])
{
    for (int k = 0; k < 2; k++) {
        const batten_interval d = field->domain[k];
        uv[k] = place[k];
        if (field->closed[k])
            uv[k] -= floor((uv[k] - d.a) / (d.b - d.a)) * (d.b - d.a);
        uv[k] = bat_min(bat_max(uv[k], d.a), d.b);
    }
}

double bat_slope_beyond(const bat_slope_field *field, const double place[2])
{
    double beyond = -1;
    for (int k = 0; k < 2; k++) {
        const batten_interval d = field->domain[k];
        if (!field->closed[k])
            beyond = bat_max(beyond, bat_max(d.a - place[k], place[k] - d.b) / (d.b - d.a));
    }
    return beyond;
}

/* The curvatures of the frame, and the angle of the first principal direction from its first axis. */
static double principal_angle(const frame *f, double kappa[2])
{
    double one[2], two[2];
    in_parameters(f, 1, 0, one);
    in_parameters(f, 0, 1, two);
    const double L = bat_vec3_dot(f->uu, f->normal), M = bat_vec3_dot(f->uv, f->normal),
                 P = bat_vec3_dot(f->vv, f->normal);
    const double h11 = L * one[0] * one[0];
    const double h12 = one[0] * (L * two[0] + M * two[1]);
    const double h22 = L * two[0] * two[0] + 2 * M * two[0] * two[1] + P * two[1] * two[1];
    const double mean = (h11 + h22) / 2, apart = (h11 - h22) / 2, root = bat_hypot(apart, h12);
    kappa[0] = mean + root;
    kappa[1] = mean - root;
    return 0.5 * bat_atan2(h12, apart);
}

/* The angle of the direction of the kind; where there is none, out->obstacle says why. */
static double direction_angle(const bat_slope_field *field, const frame *f, bat_slope *out)
{
    double kappa[2];
    const double first = principal_angle(f, kappa);
    const double largest = bat_max(fabs(kappa[0]), fabs(kappa[1]));
    out->spread = largest > 0 ? (kappa[0] - kappa[1]) / largest : 0;
    if (field->kind == BATTEN_LINE_CURVATURE1 || field->kind == BATTEN_LINE_CURVATURE2) {
        if (!(out->spread > umbilic))
            out->obstacle = BATTEN_LINE_AT_UMBILIC;
        return field->kind == BATTEN_LINE_CURVATURE1 ? first : first + BAT_PI / 2;
    }
    if (!(kappa[0] > umbilic * largest && kappa[1] < -umbilic * largest)) {
        out->obstacle = BATTEN_LINE_AT_PARABOLIC;
        return 0;
    }
    const double away = bat_atan2(sqrt(kappa[0]), sqrt(-kappa[1]));
    return field->kind == BATTEN_LINE_ASYMPTOTIC1 ? first + away : first - away;
}

/* The tangent of a geodesic turns in the direction of the normal alone, by the normal curvature. */
static void turn_geodesic(const frame *f, const double place[BAT_SLOPE_SIZE], bat_slope *out)
{
    const batten_vec3 given = bat_vec3_of(3, place + 2);
    const double x = bat_vec3_dot(given, f->first), y = bat_vec3_dot(given, f->second);
    double *r = out->rates;
    in_parameters(f, x, y, r);
    const batten_vec3 bend = bat_vec3_along(
        bat_vec3_along(bat_vec3_scale(f->uu, r[0] * r[0]), 2 * r[0] * r[1], f->uv), r[1] * r[1],
        f->vv);
    const double curvature = bat_vec3_dot(bend, f->normal);
    out->tangent = bat_vec3_along(bat_vec3_scale(f->first, x), y, f->second);
    r[2] = curvature * f->normal.x;
    r[3] = curvature * f->normal.y;
    r[4] = curvature * f->normal.z;
}

batten_status bat_slope_at(const bat_slope_field *field, const double place[BAT_SLOPE_SIZE],
                           batten_vec3 onward, bat_slope *out)
{
    frame f;
    bool is_regular = false;
    *out = (bat_slope){.spread = 1, .obstacle = BATTEN_LINE_AT_LENGTH};
    const batten_status status = lay_frame(field, place, &f, &is_regular);
    if (status != BATTEN_OK)
        return status;
    if (!is_regular) {
        out->obstacle = BATTEN_LINE_AT_SINGULAR;
        return BATTEN_OK;
    }
    out->point = f.point;
    if (field->kind == BATTEN_LINE_GEODESIC) {
        turn_geodesic(&f, place, out);
        return BATTEN_OK;
    }
    const double angle = direction_angle(field, &f, out);
    double x = bat_cos(angle), y = bat_sin(angle);
    out->tangent = bat_vec3_along(bat_vec3_scale(f.first, x), y, f.second);
    if (bat_vec3_dot(out->tangent, onward) < 0) {
        out->tangent = bat_vec3_scale(out->tangent, -1);
        x = -x;
        y = -y;
    }
    in_parameters(&f, x, y, out->rates);
    return BATTEN_OK;
}

bool bat_slope_begin(const bat_slope_field *field, double place[BAT_SLOPE_SIZE],
                     batten_vec3 direction)
{
    frame f;
    bool is_regular = false;
    if (lay_frame(field, place, &f, &is_regular) != BATTEN_OK || !is_regular)
        return false;
    const double x = bat_vec3_dot(direction, f.first), y = bat_vec3_dot(direction, f.second);
    const double length = bat_hypot(x, y);
    if (!(length > parallel * bat_vec3_norm(direction)))
        return false;
    const batten_vec3 tangent =
        bat_vec3_along(bat_vec3_scale(f.first, x / length), y / length, f.second);
    place[2] = tangent.x;
    place[3] = tangent.y;
    place[4] = tangent.z;
    return true;
}
