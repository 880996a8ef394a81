/* What fits of primitives share, and lines. */
#include "shape/near/primitives.h"
#include "numeric/eigen.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* ---- clouds ---- */

batten_status bat_cloud_make(int dimension, int count, const double *points, bat_cloud *out)
{
    bat_cloud c = {.dimension = dimension, .count = count};
    const size_t n = (size_t)count, d = (size_t)dimension;
    c.points = bat_array3(n, d, sizeof *c.points);
    if (!c.points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t k = 0; k < d; k++) {
        double mean = 0; /* of differences to the first, so that points far away lose nothing */
        for (size_t i = 0; i < n; i++)
            mean += (points[i * d + k] / 2 - points[k] / 2) / count;
        c.mean[k] = points[k] + 2 * mean;
    }
    for (size_t i = 0; i < n * d; i++) {
        c.points[i] = points[i] - c.mean[i % d];
        c.size = bat_max(c.size, fabs(c.points[i]));
    }
    if (!(c.size > 0) || !isfinite(c.size)) {
        bat_release(c.points);
        return c.size > 0 ? bat_fail(BATTEN_OVERFLOW, "the points are too far apart")
                          : bat_fail(BATTEN_COINCIDENT, "all %d points coincide", count);
    }
    for (size_t i = 0; i < n * d; i++)
        c.points[i] /= c.size;
    *out = c;
    return BATTEN_OK;
}

void bat_cloud_free(bat_cloud *cloud)
{
    bat_release(cloud->points);
    cloud->points = NULL;
}

void bat_cloud_spread(const bat_cloud *c, double values[3], double vectors[9])
{
    const int d = c->dimension;
    double products[9] = {0};
    for (int i = 0; i < c->count; i++) {
        const double *q = c->points + (size_t)i * (size_t)d;
        for (int a = 0; a < d; a++)
            for (int b = 0; b < d; b++)
                products[a * d + b] += q[a] * q[b] / c->count;
    }
    bat_eigen_symmetric(d, products, values, vectors);
}

void bat_primitive_measure(int count, const double *distances, double scale,
                           batten_primitive_report *report)
{
    double sum = 0;
    report->error = -1;
    for (int i = 0; i < count; i++) {
        const double distance = fabs(distances[i]);
        sum += distance * distance;
        if (distance > report->error) {
            report->error = distance;
            report->worst = i;
        }
    }
    report->error *= scale;
    report->rms = scale * sqrt(sum / count);
}

void bat_angle_range(int count, const double *angles, double *start, double *angle)
{
    double at = angles[0], low = at, high = at;
    for (int i = 1; i < count; i++) {
        double step = angles[i] - angles[i - 1];
        step -= 2 * BAT_PI * round(step / (2 * BAT_PI));
        at += step;
        low = bat_min(low, at);
        high = bat_max(high, at);
    }
    /* Data that go around leave a gap no larger than the steps between them. */
    const double steps = (high - low) / bat_max_int(count - 1, 1);
    const bool around = high - low + 2 * steps >= 2 * BAT_PI;
    *start = around ? angles[0] : low;
    *angle = around ? 2 * BAT_PI : high - low;
}

/* ---- lines ---- */

/* Signed as the data run: from the first to the last. */
static void orient(const bat_cloud *c, double *direction)
{
    const int d = c->dimension;
    const double *last = c->points + (size_t)(c->count - 1) * (size_t)d;
    const double along = bat_dot(d, last, direction) - bat_dot(d, c->points, direction);
    for (int k = 0; k < d && along < 0; k++)
        direction[k] = -direction[k];
}

static double foot(const bat_cloud *c, int i, const double *direction, double *distance)
{
    const int d = c->dimension;
    const double *q = c->points + (size_t)i * (size_t)d, s = bat_dot(d, q, direction);
    double off[3];
    for (int k = 0; k < d; k++)
        off[k] = q[k] - s * direction[k];
    *distance = bat_norm(d, off);
    return s;
}

static batten_status fit_line(const bat_cloud *c, batten_fitted_line *line,
                              batten_primitive_report *report)
{
    const int d = c->dimension;
    double values[3], vectors[9];
    double *distances = bat_array((size_t)c->count, sizeof *distances);
    if (!distances)
        return BATTEN_OUT_OF_MEMORY;
    bat_cloud_spread(c, values, vectors);
    batten_fitted_line made = {.from = HUGE_VAL, .to = -HUGE_VAL};
    memcpy(made.direction, vectors + (d - 1) * d, (size_t)d * sizeof(double));
    orient(c, made.direction);
    for (int i = 0; i < c->count; i++) {
        const double s = c->size * foot(c, i, made.direction, distances + i);
        made.from = bat_min(made.from, s);
        made.to = bat_max(made.to, s);
    }
    batten_primitive_report reached = {0};
    bat_primitive_measure(c->count, distances, c->size, &reached);
    bat_release(distances);
    /* Each product was rounded once, and the sum again. */
    if (!(values[d - 1] - values[d - 2] > 8 * DBL_EPSILON * values[d - 1]))
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "the points spread alike in two directions: no line is nearest");
    memcpy(made.point, c->mean, sizeof made.point);
    *line = made;
    if (report)
        *report = reached;
    return BATTEN_OK;
}

batten_status batten_line_fit(batten_points points, batten_primitive_report *report,
                              batten_fitted_line *line)
{
    if (points.dimension < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 2 or 3",
                        points.dimension);
    bat_cloud cloud;
    batten_status status = bat_points_check(points.dimension, points.count, points.at, 2);
    if (status == BATTEN_OK)
        status = bat_cloud_make(points.dimension, points.count, points.at, &cloud);
    if (status != BATTEN_OK)
        return status;
    status = fit_line(&cloud, line, report);
    bat_cloud_free(&cloud);
    return status;
}
