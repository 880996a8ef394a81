/* The contours of a shape as curves: polylines, curves fitted to chords, or joined cubics. */
#include "design/features/take/contour_curves.h"

#include <batten/approximate.h>
#include <batten/standard.h>
#include <string.h>

/* Chords, or cubics. */
batten_status bat_contours_find(const bat_run *run, const batten_object *object,
                                const bat_contours_wanted *w, double tolerance, bool cubics,
                                batten_contours *out)
{
    if (object->kind == BATTEN_OBJECT_TRIANGLES)
        return (cubics ? batten_triangles_smooth_contours : batten_triangles_contours)(
            object->triangles, &w->field, (batten_levels){w->level_count, w->levels}, tolerance,
            run->job, out);
    return (cubics ? batten_surface_smooth_contours : batten_surface_contours)(
        object->surface, &w->field, (batten_levels){w->level_count, w->levels}, tolerance,
        run->job, out);
}

static batten_status make_polyline(const batten_polyline *line, batten_curve **out)
{
    const int count = line->count + line->closed;
    double *points = bat_array3((size_t)count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 3 * count; i++)
        points[i] = line->points[i % (3 * line->count)];
    const batten_status status = batten_curve_polyline((batten_points){3, count, points}, out);
    bat_release(points);
    return status;
}

/* A smooth curve through the dense points, when that keeps within the tolerance between them
 * too; else the polyline. `rise` is how far its chords are from the contour. */
static batten_status make_curve(const bat_contours_wanted *w, const batten_polyline *line,
                                double rise, double *error, batten_curve **out)
{
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report;
    options.tolerance = 0.5 * w->within;
    options.corner = 20 * BAT_PI / 180;
    options.closed = line->closed;
    options.method = BATTEN_WITHIN_BEZIER;
    if (w->smooth && line->count >= 4) {
        const batten_status status = batten_curve_within(
            (batten_points){3, line->count, line->points}, &options, NULL, &report, out);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK) {
            *error = bat_max(report.error, report.apart) + rise;
            if (*error <= w->within)
                return BATTEN_OK;
            batten_curve_unref(*out);
        }
    }
    *error = rise;
    return make_polyline(line, out);
}

static double distance(const double *a, const double *b)
{
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The lengths of the spans, so that derivatives agree where tangents do. */
static void pace(int count, const double *points, double *breaks)
{
    double speed = 0;
    for (int i = 0; i < count; i++) {
        const double *p = points + 9 * i;
        const double own = distance(p, p + 9);
        const double paced = 3 * distance(p, p + 3) / (speed > 0 ? speed : 1);
        const double length = speed > 0 && paced > own / 64 && paced < 64 * own ? paced : own;
        breaks[i + 1] = breaks[i] + length;
        speed = 3 * distance(p + 6, p + 9) / length;
    }
}

batten_status bat_armed_curve(const batten_polyline *line, const double *arms,
                              batten_curve **out)
{
    const int count = line->closed ? line->count : line->count - 1;
    double *points = bat_array3((size_t)count + 1, 9, sizeof *points);
    double *breaks = bat_array((size_t)count + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i <= count; i++) {
        const int k = i % line->count;
        double *to = points + 9 * i;
        memcpy(to, line->points + 3 * k, 3 * sizeof *to);
        memcpy(to + 3, arms + 6 * k + 3, 3 * sizeof *to);
        memcpy(to + 6, arms + 6 * ((k + 1) % line->count), 3 * sizeof *to);
    }
    if (status == BATTEN_OK) {
        pace(count, points, breaks);
        status =
            batten_curve_from_bezier(3, (batten_pieces){3, count, breaks}, points, NULL, out);
    }
    bat_release(breaks);
    bat_release(points);
    return status;
}

static double size_of(const batten_object *object)
{
    const batten_box box = object->kind == BATTEN_OBJECT_TRIANGLES
                               ? batten_triangles_box(object->triangles)
                               : batten_surface_box(object->surface);
    const double low[3] = {box.low.x, box.low.y, box.low.z},
                 high[3] = {box.high.x, box.high.y, box.high.z};
    return distance(low, high);
}

/* Smooth curves are fitted to chords; where these would be too many, cubics stand between
 * points with the tangents of the contour. */
batten_status bat_contours_find_fine(const bat_run *run, const batten_object *object,
                                     const bat_contours_wanted *w, batten_contours *out)
{
    const bool cubics = w->smooth && w->within < 1e-6 * size_of(object);
    const double within = w->smooth && !cubics ? 0.25 * w->within : w->within;
    return bat_contours_find(run, object, w, within, cubics, out);
}

batten_status bat_contour_curve(bat_contours_wanted *w, const batten_contour *contour,
                                double rise, batten_curve **out)
{
    double error = rise;
    const batten_status status = contour->arms
                                     ? bat_armed_curve(&contour->line, contour->arms, out)
                                     : make_curve(w, &contour->line, rise, &error, out);
    w->open += !contour->line.closed;
    w->error = bat_max(w->error, error);
    return status;
}
