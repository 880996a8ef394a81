/* Ellipses near points. */
#include "numeric/dense.h"
#include "numeric/eigen.h"
#include "numeric/gauss_newton.h"
#include "numeric/polynomial.h"
#include "numeric/vector.h"
#include "shape/near/primitives.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* Half axes a, b along `turn` and across. */
typedef struct {
    double x, y, a, b, turn;
} ellipse;

/* ---- the direct fit ----
 *
 * Conics p.(x^2, x y, y^2) + q.(x, y, 1) with 4 p0 p2 - p1^2 = 1: q follows from p, and p is an
 * eigenvector of a 3 x 3 matrix. */

static void add_products(const double *u, const double *v, double *sum)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            sum[3 * i + j] += u[i] * v[j];
}

/* The matrix of the eigenvectors p, and q = follow p. */
static batten_status find_matrix(const bat_cloud *c, double m[9], double follow[9])
{
    double s1[9] = {0}, s2[9] = {0}, s3[9] = {0};
    int pivots[3];
    for (int i = 0; i < c->count; i++) {
        const double x = c->points[2 * i], y = c->points[2 * i + 1];
        const double squares[3] = {x * x, x * y, y * y}, line[3] = {x, y, 1};
        add_products(squares, squares, s1);
        add_products(squares, line, s2);
        add_products(line, line, s3);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            follow[3 * i + j] = -s2[3 * j + i];
    const batten_status status = bat_dense_factor(3, s3, pivots);
    if (status != BATTEN_OK)
        return status;
    bat_dense_solve(3, s3, pivots, 3, follow);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s1[3 * i + j] += bat_dot(3, (double[3]){s2[3 * i], s2[3 * i + 1], s2[3 * i + 2]},
                                     (double[3]){follow[j], follow[3 + j], follow[6 + j]});
    for (int j = 0; j < 3; j++) {
        m[j] = s1[6 + j] / 2;
        m[3 + j] = -s1[3 + j];
        m[6 + j] = s1[j] / 2;
    }
    return BATTEN_OK;
}

/* The eigenvector of a root: the largest product of two rows of m - root. */
static void eigenvector(const double m[9], double root, double p[3])
{
    double rows[9], best = -1;
    memcpy(rows, m, sizeof rows);
    for (int i = 0; i < 3; i++)
        rows[4 * i] -= root;
    for (int i = 0; i < 3; i++) {
        const double *u = rows + 3 * i, *v = rows + 3 * ((i + 1) % 3);
        double cross[3];
        bat_cross(u, v, cross);
        const double size = bat_norm(3, cross);
        if (size > best) {
            best = size;
            memcpy(p, cross, sizeof cross);
        }
    }
    for (int i = 0; i < 3 && best > 0; i++)
        p[i] /= best;
}

static bool ellipse_of(const double p[3], const double q[3], ellipse *out)
{
    const double det = 4 * p[0] * p[2] - p[1] * p[1];
    if (!(det > 0))
        return false;
    out->x = (p[1] * q[1] - 2 * p[2] * q[0]) / det;
    out->y = (p[1] * q[0] - 2 * p[0] * q[1]) / det;
    const double rest = q[2] + (q[0] * out->x + q[1] * out->y) / 2;
    double form[4] = {p[0], p[1] / 2, p[1] / 2, p[2]}, values[2], vectors[4];
    bat_eigen_symmetric(2, form, values, vectors);
    const bool negative = values[1] < 0; /* then the second is the flatter direction */
    const double *axis = vectors + (negative ? 2 : 0);
    out->a = sqrt(-rest / values[negative]);
    out->b = sqrt(-rest / values[!negative]);
    out->turn = bat_atan2(axis[1], axis[0]);
    return isfinite(out->a) && out->b > 0;
}

static batten_status fit_directly(const bat_cloud *c, ellipse *out)
{
    double m[9], follow[9], roots[3];
    const batten_status status = find_matrix(c, m, follow);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return bat_fail(status, "the %d points lie on a line", c->count);
    if (status != BATTEN_OK)
        return status;
    const double minors =
        m[0] * m[4] - m[1] * m[3] + m[0] * m[8] - m[2] * m[6] + m[4] * m[8] - m[5] * m[7];
    const double det = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                       m[2] * (m[3] * m[7] - m[4] * m[6]);
    const double characteristic[4] = {-det, minors, -(m[0] + m[4] + m[8]), 1};
    const int count = bat_polynomial_roots(3, characteristic, -INFINITY, INFINITY, roots);
    for (int i = 0; i < count; i++) {
        double p[3] = {0}, q[3];
        eigenvector(m, roots[i], p);
        for (int k = 0; k < 3; k++)
            q[k] = bat_dot(3, follow + 3 * k, p);
        if (ellipse_of(p, q, out))
            return BATTEN_OK;
    }
    return bat_fail(BATTEN_SINGULAR_SYSTEM, "the %d points determine no ellipse", c->count);
}

/* ---- feet ---- */

/* The foot x of q on the ellipse with half axes e[0] >= e[1] > 0, all in the first quadrant:
 * x = e^2 q / (e^2 + t) for the one t > -e[1]^2 that puts it there. Newton from the left, where
 * the condition falls and is convex. */
static void foot_in_quadrant(const double e[2], const double q[2], double x[2])
{
    if (q[1] == 0) {
        const double across = e[0] * e[0] - e[1] * e[1];
        const bool inside = e[0] * q[0] < across;
        const double c = inside ? e[0] * q[0] / across : 1;
        x[0] = e[0] * c;
        x[1] = inside ? e[1] * sqrt((1 - c) * (1 + c)) : 0;
        return;
    }
    const double z0 = q[0] / e[0], z1 = q[1] / e[1], r = (e[0] / e[1]) * (e[0] / e[1]);
    double s = z1 - 1;
    for (int i = 0; i < 100; i++) {
        const double u = r * z0 / (s + r), v = z1 / (s + 1);
        const double value = u * u + v * v - 1,
                     slope = -2 * (u * u / (s + r) + v * v / (s + 1));
        const double next = s - value / slope;
        if (!(next > s))
            break;
        s = next;
    }
    x[0] = r * q[0] / (s + r);
    x[1] = q[1] / (s + 1);
}

/* The foot of q, in axes of the ellipse; any quadrant, any order of the axes. */
static void foot(double a, double b, const double q[2], double x[2])
{
    const bool swap = a < b;
    const double e[2] = {swap ? b : a, swap ? a : b};
    const double in[2] = {fabs(q[swap]), fabs(q[!swap])};
    double at[2];
    foot_in_quadrant(e, in, at);
    x[0] = copysign(at[swap], q[0]);
    x[1] = copysign(at[!swap], q[1]);
}

typedef struct {
    int count;
    const double *points;
} ellipse_fit;

static bool residuals(void *context, const double *x, double *r, double *derivatives)
{
    const ellipse_fit *t = context;
    const double a = x[2], b = x[3], c = bat_cos(x[4]), s = bat_sin(x[4]);
    if (!(a > 0 && b > 0 && isfinite(a) && isfinite(b)))
        return false;
    for (int i = 0; i < t->count; i++) {
        const double u = t->points[2 * i] - x[0], v = t->points[2 * i + 1] - x[1];
        const double q[2] = {c * u + s * v, c * v - s * u};
        double at[2];
        foot(a, b, q, at);
        double normal[2] = {at[0] / (a * a), at[1] / (b * b)};
        const double size = bat_hypot(normal[0], normal[1]);
        normal[0] /= size;
        normal[1] /= size;
        r[i] = normal[0] * (q[0] - at[0]) + normal[1] * (q[1] - at[1]);
        if (!derivatives)
            continue;
        double *d = derivatives + 5 * (size_t)i;
        d[0] = -(c * normal[0] - s * normal[1]);
        d[1] = -(s * normal[0] + c * normal[1]);
        d[2] = -normal[0] * at[0] / a;
        d[3] = -normal[1] * at[1] / b;
        d[4] = normal[0] * at[1] - normal[1] * at[0];
    }
    return true;
}

/* ---- the whole ---- */

/* Beyond, the far end has no influence on the data. */
#define MOST_AXIS 1e8
/* A needle so much longer than the data, and than it is wide, is what Newton makes of a
 * parabola or a hyperbola before it gives up: near the data the three cannot be told apart. */
#define NEEDLE 64

static bool is_open(const ellipse *e)
{
    return !(e->a < MOST_AXIS) || (e->a > NEEDLE && e->a > NEEDLE * e->b);
}

static batten_status refine(const bat_cloud *c, ellipse *e, double *distances, int *rounds)
{
    double x[5] = {e->x, e->y, e->a, e->b, e->turn};
    ellipse_fit t = {c->count, c->points};
    const batten_status status = bat_gauss_newton(c->count, 5, residuals, &t, 200, x, rounds);
    if (status != BATTEN_OK)
        return status;
    residuals(&t, x, distances, NULL);
    *e = (ellipse){x[0], x[1], x[2], x[3], x[4]};
    if (e->a < e->b)
        *e = (ellipse){x[0], x[1], x[3], x[2], x[4] + bat_acos(0)};
    return is_open(e) ? bat_fail(BATTEN_SINGULAR_SYSTEM,
                                 "the nearest ellipse has the half axes %g and %g: the points "
                                 "bend as a parabola or a hyperbola does",
                                 e->a * c->size, e->b * c->size)
                      : BATTEN_OK;
}

/* Directed as the data run, from the first to the last. */
static void report_ellipse(const bat_cloud *c, const ellipse *e, double *angles,
                           batten_fitted_ellipse *out)
{
    const double cosine = bat_cos(e->turn), sine = bat_sin(e->turn), pi = 2 * bat_acos(0);
    double turned = 0;
    for (int i = 0; i < c->count; i++) {
        const double u = c->points[2 * i] - e->x, v = c->points[2 * i + 1] - e->y;
        angles[i] = bat_atan2((cosine * v - sine * u) / e->b, (cosine * u + sine * v) / e->a);
        const double step = i > 0 ? angles[i] - angles[i - 1] : 0;
        turned += step - 2 * pi * round(step / (2 * pi));
    }
    out->center[0] = c->mean[0] + c->size * e->x;
    out->center[1] = c->mean[1] + c->size * e->y;
    out->axis[0] = cosine;
    out->axis[1] = sine;
    out->a = c->size * e->a;
    out->b = c->size * e->b;
    bat_angle_range(c->count, angles, &out->start, &out->angle);
    if (turned >= 0)
        return;
    out->start = out->angle < 2 * pi ? out->start + out->angle : out->start;
    out->angle = -out->angle;
}

static batten_status fit(const bat_cloud *c, batten_fitted_ellipse *out,
                         batten_primitive_report *report)
{
    ellipse e = {0};
    double *distances = bat_array((size_t)c->count, sizeof *distances);
    batten_status status = distances ? fit_directly(c, &e) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = refine(c, &e, distances, &report->rounds);
    if (status == BATTEN_OK) {
        bat_primitive_measure(c->count, distances, c->size, report);
        report_ellipse(c, &e, distances, out);
    }
    bat_release(distances);
    return status;
}

batten_status batten_ellipse_fit(batten_points points, batten_primitive_report *report,
                                 batten_fitted_ellipse *out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    bat_cloud cloud;
    batten_fitted_ellipse made;
    batten_primitive_report reached = {0};
    batten_status status = bat_points_check(2, points.count, points.at, 5);
    if (status == BATTEN_OK)
        status = bat_cloud_make(2, points.count, points.at, &cloud);
    if (status != BATTEN_OK)
        return status;
    status = fit(&cloud, &made, &reached);
    bat_cloud_free(&cloud);
    if (status != BATTEN_OK)
        return status;
    *out = made;
    if (report)
        *report = reached;
    return BATTEN_OK;
}
