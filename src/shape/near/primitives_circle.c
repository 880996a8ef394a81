/* Circles near points: Taubin's, Pratt's or Kasa's, and the geometric one from there. */
#include "numeric/gauss_newton.h"
#include "numeric/vector.h"
#include "shape/near/primitives.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

typedef struct {
    double x, y, radius;
} circle;

/* ---- algebraic fits ---- */

/* Mean products of coordinates and z = x^2 + y^2. */
typedef struct {
    double xx, xy, yy, xz, yz, zz;
} moments;

static moments find_moments(int count, const double *points)
{
    moments m = {0};
    for (int i = 0; i < count; i++) {
        const double x = points[2 * i], y = points[2 * i + 1], z = x * x + y * y;
        m.xx += x * x / count;
        m.xy += x * y / count;
        m.yy += y * y / count;
        m.xz += x * z / count;
        m.yz += y * z / count;
        m.zz += z * z / count;
    }
    return m;
}

/* The least positive root of the characteristic polynomial c [5], from 0 by Newton: it falls
 * and is convex before. */
static double first_root(const double c[5])
{
    double x = 0;
    for (int i = 0; i < 100; i++) {
        const double value = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
        const double slope = c[1] + x * (2 * c[2] + x * (3 * c[3] + x * 4 * c[4]));
        const double next = slope != 0 ? x - value / slope : x;
        if (!isfinite(next) || next <= x || next - x <= DBL_EPSILON * next)
            break;
        x = next;
    }
    return x;
}

/* The circles that minimise A z + B x + C y + D under the method's condition on A, B, C. */
static bool algebraic(int count, const double *points, batten_circle_method method, circle *out)
{
    const moments m = find_moments(count, points);
    const double z = m.xx + m.yy, det = m.xx * m.yy - m.xy * m.xy, var = m.zz - z * z;
    const double c0 =
        m.xz * (m.xz * m.yy - m.yz * m.xy) + m.yz * (m.yz * m.xx - m.xz * m.xy) - var * det;
    const double c1 = var * z + 4 * det * z - m.xz * m.xz - m.yz * m.yz;
    const double taubin[5] = {c0, c1, -3 * z * z - m.zz, 4 * z, 0};
    const double pratt[5] = {c0, c1, 4 * det - 3 * z * z - m.zz, 0, 4};
    const bool is_pratt = method == BATTEN_CIRCLE_PRATT;
    const double x = method == BATTEN_CIRCLE_KASA ? 0 : first_root(is_pratt ? pratt : taubin);
    const double by = 2 * (x * x - x * z + det);
    out->x = (m.xz * (m.yy - x) - m.yz * m.xy) / by;
    out->y = (m.yz * (m.xx - x) - m.xz * m.xy) / by;
    out->radius = sqrt(out->x * out->x + out->y * out->y + z + (is_pratt ? 2 * x : 0));
    return by != 0 && isfinite(out->radius);
}

/* ---- the geometric fit ---- */

typedef struct {
    int count;
    const double *points;
} circle_fit;

static bool residuals(void *context, const double *x, double *r, double *derivatives)
{
    const circle_fit *t = context;
    for (int i = 0; i < t->count; i++) {
        const double u = t->points[2 * i] - x[0], v = t->points[2 * i + 1] - x[1],
                     distance = bat_hypot(u, v);
        r[i] = distance - x[2];
        if (!derivatives)
            continue;
        derivatives[3 * i] = distance > 0 ? -u / distance : 0;
        derivatives[3 * i + 1] = distance > 0 ? -v / distance : 0;
        derivatives[3 * i + 2] = -1;
    }
    return x[2] > 0 && isfinite(x[2]);
}

/* Does a line serve as well as rounding lets anything be known? */
static bool is_straight(const bat_cloud *c)
{
    double values[3], vectors[9], largest = 0;
    bat_cloud_spread(c, values, vectors);
    const double *normal = vectors;
    for (int i = 0; i < c->count; i++)
        largest = bat_max(largest, fabs(bat_dot(2, c->points + 2 * (size_t)i, normal)));
    return largest <= 16 * DBL_EPSILON;
}

/* A circle so large is a line for all data: its bow is lost in their rounding. */
#define MOST_RADIUS (1 / (16 * DBL_EPSILON))

static batten_status fit_plane(const bat_cloud *c, batten_circle_method method, circle *out,
                               int *rounds)
{
    if (is_straight(c) || !algebraic(c->count, c->points, method, out))
        return bat_fail(BATTEN_SINGULAR_SYSTEM, "the %d points lie on a line", c->count);
    if (method == BATTEN_CIRCLE_GEOMETRIC) {
        double x[3] = {out->x, out->y, out->radius};
        circle_fit t = {c->count, c->points};
        const batten_status status =
            bat_gauss_newton(c->count, 3, residuals, &t, 200, x, rounds);
        if (status != BATTEN_OK)
            return status;
        *out = (circle){x[0], x[1], x[2]};
    }
    return out->radius < MOST_RADIUS ? BATTEN_OK
                                     : bat_fail(BATTEN_SINGULAR_SYSTEM,
                                                "the nearest circle has the radius %g: a line",
                                                out->radius * c->size);
}

/* ---- plane and space ---- */

/* The plane of a cloud in space, and the cloud in its coordinates. */
static batten_status flatten(const bat_cloud *c, double axes[9], bat_cloud *flat)
{
    double values[3];
    *flat = (bat_cloud){.dimension = 2, .count = c->count, .size = c->size};
    flat->points = bat_array3((size_t)c->count, 2, sizeof *flat->points);
    if (!flat->points)
        return BATTEN_OUT_OF_MEMORY;
    if (c->dimension == 2) {
        const double world[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0};
        memcpy(axes, world, sizeof world);
    } else {
        bat_cloud_spread(c, values, axes);
    }
    for (int i = 0; i < c->count; i++)
        for (int k = 0; k < 2; k++)
            flat->points[2 * i + k] = bat_dot(
                c->dimension, c->points + (size_t)i * (size_t)c->dimension, axes + 3 * (k + 1));
    return BATTEN_OK;
}

static batten_vec3 vec3(const double *a)
{
    return (batten_vec3){a[0], a[1], a[2]};
}

/* The frame in which the data run counter-clockwise, its x-axis towards the first; -1 when they
 * ran clockwise. */
static double find_circle_frame(const bat_cloud *c, const bat_cloud *flat, const double axes[9],
                                const circle *in, const double *angles,
                                batten_fitted_circle *out)
{
    double turned = 0;
    for (int i = 1; i < flat->count; i++) {
        const double step = angles[i] - angles[i - 1];
        turned += step - (2 * BAT_PI) * round(step / (2 * BAT_PI));
    }
    const double sign = turned < 0 ? -1 : 1;
    const batten_vec3 u = vec3(axes + 3), v = vec3(axes + 6), w = bat_vec3_cross(u, v);
    const batten_vec3 at =
        bat_vec3_add(bat_vec3_scale(u, in->x * c->size), bat_vec3_scale(v, in->y * c->size));
    out->frame.origin = bat_vec3_add(vec3(c->mean), at);
    out->frame.x = bat_vec3_add(bat_vec3_scale(u, bat_cos(angles[0])),
                                bat_vec3_scale(v, bat_sin(angles[0])));
    out->frame.z = bat_vec3_scale(w, sign);
    out->radius = in->radius * c->size;
    return sign;
}

static batten_status report_circle(const bat_cloud *c, const bat_cloud *flat,
                                   const double axes[9], const circle *in,
                                   batten_fitted_circle *out, batten_primitive_report *report)
{
    const size_t n = (size_t)c->count;
    double *angles = bat_array(n, sizeof *angles), *distances = bat_array(n, sizeof *distances);
    const batten_status status = angles && distances ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (size_t i = 0; i < n; i++) {
            const double x = flat->points[2 * i] - in->x, y = flat->points[2 * i + 1] - in->y;
            const double height = c->dimension == 3 ? bat_dot(3, c->points + 3 * i, axes) : 0;
            angles[i] = bat_atan2(y, x);
            distances[i] = bat_hypot(bat_hypot(x, y) - in->radius, height);
        }
        const double sign = find_circle_frame(c, flat, axes, in, angles, out),
                     first = angles[0];
        for (size_t i = 0; i < n; i++)
            angles[i] = sign * (angles[i] - first);
        bat_angle_range(c->count, angles, &out->start, &out->angle);
        bat_primitive_measure(c->count, distances, c->size, report);
    }
    bat_release(distances);
    bat_release(angles);
    return status;
}

static batten_status fit(const bat_cloud *c, batten_circle_method method,
                         batten_fitted_circle *out, batten_primitive_report *report)
{
    bat_cloud flat;
    double axes[9];
    circle found = {0};
    batten_status status = flatten(c, axes, &flat);
    if (status == BATTEN_OK)
        status = fit_plane(&flat, method, &found, &report->rounds);
    if (status == BATTEN_OK)
        status = report_circle(c, &flat, axes, &found, out, report);
    bat_cloud_free(&flat);
    return status;
}

batten_status batten_circle_fit(batten_points points, batten_circle_method method,
                                batten_primitive_report *report, batten_fitted_circle *out)
{
    if (points.dimension < 2 || (int)method < 0 || method > BATTEN_CIRCLE_KASA)
        return bat_fail(BATTEN_BAD_ARGUMENT, "no circle in dimension %d by method %d",
                        points.dimension, (int)method);
    bat_cloud cloud;
    batten_fitted_circle made = {0};
    batten_primitive_report reached = {0};
    batten_status status = bat_points_check(points.dimension, points.count, points.at, 3);
    if (status == BATTEN_OK)
        status = bat_cloud_make(points.dimension, points.count, points.at, &cloud);
    if (status != BATTEN_OK)
        return status;
    status = fit(&cloud, method, &made, &reached);
    bat_cloud_free(&cloud);
    if (status != BATTEN_OK)
        return status;
    *out = made;
    if (report)
        *report = reached;
    return BATTEN_OK;
}
