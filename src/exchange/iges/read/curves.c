/* Reads curves: B-splines, lines, arcs, points, copious data and power splines. */
#include "exchange/iges/read/curves.h"
#include "base/plural.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>
#include <string.h>

/* ---- helpers of 126 and 128 ---- */

batten_status bat_iges_check_shape(const bat_iges_item *item, int upper, int degree)
{
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "its degree is %d, not in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (upper < degree)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "its degree is %d, and the upper index of its points %d", degree,
                        upper);
    if ((size_t)upper >= item->reading->input->limits.points)
        return bat_fail(BATTEN_BAD_FORMAT, "%d points; the limit is %zu", upper,
                        item->reading->input->limits.points);
    return BATTEN_OK;
}

bool bat_iges_weights_matter(const bat_iges_item *item, bool polynomial, size_t count,
                             const double *weights)
{
    bool equal = true;
    for (size_t i = 1; i < count; i++)
        equal &= weights[i] == weights[0];
    if (polynomial && equal && weights[0] > 0)
        return false;
    if (polynomial)
        bat_iges_note(item->reading, item->entry,
                      "it is declared polynomial, but its weights differ; they are kept");
    return true;
}

/* Ends within a rounding of the domain's are those; an interval that is empty or leaves the
 * domain counts as not given. */
batten_interval bat_iges_interval(const bat_iges_item *item, size_t at, batten_interval domain)
{
    double ends[2];
    const double slack = 1e-9 * (domain.b - domain.a);
    if (at + 1 >= bat_iges_count_of(item->parameters))
        return domain;
    if (bat_iges_reals(item->parameters, at, 2, ends) != BATTEN_OK) {
        bat_iges_note(item->reading, item->entry, "%.200s; its whole domain is taken",
                      batten_message());
        return domain;
    }
    batten_interval range = {ends[0], ends[1]};
    if (fabs(range.a - domain.a) <= slack)
        range.a = domain.a;
    if (fabs(range.b - domain.b) <= slack)
        range.b = domain.b;
    if (range.a >= domain.a && range.a < range.b && range.b <= domain.b)
        return range;
    bat_iges_note(item->reading, item->entry,
                  "its interval %g..%g is not in its domain %g..%g, which is taken", range.a,
                  range.b, domain.a, domain.b);
    return domain;
}

double bat_iges_size_of_box(batten_box box)
{
    const double x = box.high.x - box.low.x, y = box.high.y - box.low.y,
                 z = box.high.z - box.low.z;
    return sqrt(x * x + y * y + z * z);
}

double bat_iges_size_of_curve(const batten_curve *curve)
{
    return bat_iges_size_of_box(batten_curve_box(curve));
}

/* ---- 126: B-spline curve ---- */

static batten_status restrict_curve(batten_interval range, batten_curve **curve)
{
    const batten_interval domain = batten_curve_domain(*curve);
    batten_curve *part = NULL;
    if (range.a == domain.a && range.b == domain.b)
        return BATTEN_OK;
    return bat_curve_replace(batten_curve_subrange(*curve, range.a, range.b, &part), curve,
                             &part);
}

/* K, M, four properties, knots, weights, points, the interval, and a normal. */
batten_status bat_iges_read_nurbs_curve(bat_iges_item *item)
{
    int head[6] = {0};
    const double *numbers = NULL;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < 6; k++)
        status = bat_iges_integer(item->parameters, k + 1, &head[k]);
    if (status == BATTEN_OK)
        status = bat_iges_check_shape(item, head[0], head[1]);
    if (status != BATTEN_OK)
        return status;
    const int degree = head[1];
    const size_t count = (size_t)head[0] + 1, knots = count + (size_t)degree + 1,
                 end = 7 + knots + 4 * count;
    status = bat_iges_need(item, end);
    if (status == BATTEN_OK)
        status = bat_iges_reals_in_place(item->parameters, 7, knots + 4 * count, &numbers);
    if (status == BATTEN_OK) {
        const double *weights = numbers + knots;
        const bool rational = bat_iges_weights_matter(item, head[4] != 0, count, weights);
        status = batten_curve_create((batten_points){3, (int)count, weights + count}, degree,
                                     rational ? weights : NULL, numbers, &item->curve);
    }
    if (status == BATTEN_OK)
        status = restrict_curve(bat_iges_interval(item, end, batten_curve_domain(item->curve)),
                                &item->curve);
    item->own = end + 5;
    return status;
}

/* ---- 110: line; 100: arc ---- */

/* From its start to its end, over 0..1. */
batten_status bat_iges_read_line(bat_iges_item *item)
{
    double points[6];
    batten_status status = bat_iges_reals_or_0(item, 1, 6, points);
    if (status == BATTEN_OK)
        status = batten_curve_line(3, points, points + 3, &item->curve);
    item->own = 7;
    return status;
}

/* ZT, then centre, start and end: counter-clockwise in the plane z = ZT. */
batten_status bat_iges_read_arc(bat_iges_item *item)
{
    double v[7];
    batten_status status = bat_iges_reals_or_0(item, 1, 7, v);
    if (status != BATTEN_OK)
        return status;
    item->own = 8;
    const double sx = v[3] - v[1], sy = v[4] - v[2], ex = v[5] - v[1], ey = v[6] - v[2];
    const double radius = bat_hypot(sx, sy), other = bat_hypot(ex, ey);
    double start = bat_atan2(sy, sx);
    double angle = bat_atan2(ey, ex) - start;
    if (!(radius > 0 && isfinite(radius)))
        return bat_fail(BATTEN_COINCIDENT, "an arc of radius %g", radius);
    if (fabs(radius - other) > bat_iges_tolerance(item->reading, radius))
        bat_iges_note(item->reading, item->entry,
                      "an arc whose ends are %g and %g from its centre; the first is taken",
                      radius, other);
    /* Ends that are the same mean the whole circle. */
    if (v[3] == v[5] && v[4] == v[6])
        angle = 2 * BAT_PI;
    else if (angle <= 0)
        angle += 2 * BAT_PI;
    angle = bat_min(angle, 2 * BAT_PI);
    if (start < 0)
        start += 2 * BAT_PI;
    const batten_frame frame = {{v[1], v[2], v[0]}, {1, 0, 0}, {0, 0, 1}};
    batten_curve *arc = NULL;
    status = batten_curve_arc_in(&frame, radius, start, angle, &arc);
    /* Its parameter is the angle, at least at both ends. */
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(arc, start, start + angle, &item->curve);
    batten_curve_unref(arc);
    return status;
}

/* ---- 106: copious data; 116: point ---- */

batten_status bat_iges_read_point(bat_iges_item *item)
{
    item->own = 5; /* a symbol to show it by comes last */
    item->point_count = 1;
    const batten_status status =
        bat_input_array(item->reading->input, 3, sizeof *item->points, &item->points);
    return status == BATTEN_OK ? bat_iges_reals_or_0(item, 1, 3, item->points) : status;
}

/* Points in a row as a curve of degree 1, with the numbers of the points as knots. */
static batten_status make_polyline(bat_iges_item *item, int count, const double *points)
{
    double *knots = NULL;
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "a row of %d point%s is not a curve", count,
                        bat_plural(count));
    batten_status status =
        bat_input_array(item->reading->input, (size_t)count + 2, sizeof *knots, &knots);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i <= count + 1; i++)
        knots[i] = bat_max_int(0, bat_min_int(i - 1, count - 1));
    status =
        batten_curve_create((batten_points){3, count, points}, 1, NULL, knots, &item->curve);
    bat_release(knots);
    return status;
}

/* IP says what stands for a point: 1 x, y at a common z; 2 x, y, z; 3 also a vector. A closed
 * row, form 63, ends where it begins. */
batten_status bat_iges_read_copious(bat_iges_item *item)
{
    int kind = 0, count = 0;
    double common = 0, *points = NULL;
    const int form = item->entry->form;
    if (form > 3 && form != 63 && (form < 11 || form > 13))
        return bat_fail(BATTEN_UNSUPPORTED, "its form %d is not read", form);
    batten_status status = bat_iges_integer(item->parameters, 1, &kind);
    if (status == BATTEN_OK && (kind < 1 || kind > 3))
        status = bat_fail(BATTEN_BAD_FORMAT, "its points are of kind %d, not 1, 2 or 3", kind);
    if (status != BATTEN_OK)
        return status;
    const size_t first = kind == 1 ? 4 : 3, width = kind == 1 ? 2 : kind == 2 ? 3 : 6;
    status = bat_iges_read_count(item, 2, first, width, &count);
    if (status == BATTEN_OK && count < 1)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d point%s", count, bat_plural(count));
    if (status == BATTEN_OK && kind == 1)
        status = bat_iges_real(item->parameters, 3, &common);
    if (status == BATTEN_OK)
        status = bat_input_array(item->reading->input, (size_t)count + 1, 3 * sizeof *points,
                                 &points);
    for (size_t i = 0; status == BATTEN_OK && i < (size_t)count; i++) {
        points[3 * i + 2] = common;
        status = bat_iges_reals(item->parameters, first + width * i, kind == 1 ? 2 : 3,
                                &points[3 * i]);
    }
    item->own = first + width * (size_t)count;
    if (status == BATTEN_OK && form > 3) {
        if (form == 63 && memcmp(points, points + 3 * (count - 1), 3 * sizeof *points) != 0)
            memcpy(points + 3 * count++, points, 3 * sizeof *points);
        status = make_polyline(item, count, points);
    } else if (status == BATTEN_OK) {
        item->points = points;
        item->point_count = count;
        return BATTEN_OK;
    }
    bat_release(points);
    return status;
}

/* ---- 112: parametric spline curve ---- */

/* CTYPE, H, NDIM, N, breaks, then for each segment and each coordinate A, B, C, D. */
batten_status bat_iges_read_spline_curve(bat_iges_item *item)
{
    int dimension = 0, count = 0;
    double *breaks = NULL, *read = NULL, *turned = NULL;
    batten_status status = bat_iges_integer(item->parameters, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 4, 6, 13, &count);
    if (status == BATTEN_OK && count < 1)
        status =
            bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d segment%s", count, bat_plural(count));
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)count;
    status = bat_iges_real_array(item, 5, n + 1, &breaks);
    if (status == BATTEN_OK)
        status = bat_iges_real_array(item, 6 + n, 12 * n, &read);
    if (status == BATTEN_OK)
        status = bat_input_array(item->reading->input, 12 * n, sizeof *turned, &turned);
    double size = 0;
    for (size_t i = 0; status == BATTEN_OK && i < 12 * n; i++) {
        const size_t coordinate = i / 4 % 3, power = i % 4;
        /* In the plane all points have the first z. */
        if (dimension == 2 && coordinate == 2 && power > 0)
            read[i] = 0;
        turned[12 * (i / 12) + 3 * power + coordinate] = read[i];
        if (power == 0)
            size = bat_max(size, fabs(read[i] - read[4 * coordinate]));
    }
    if (status == BATTEN_OK)
        status = batten_curve_from_power(3, (batten_pieces){3, count, breaks}, turned,
                                         bat_iges_tolerance(item->reading, size), &item->curve);
    item->own = 6 + n + 12 * n + 12;
    bat_release(turned);
    bat_release(read);
    bat_release(breaks);
    return status;
}
