/* A curve that arcs are to follow: its corners, samples of it, and how far arcs are from it. */
#include "shape/arcs/path.h"
#include "numeric/vector.h"
#include <batten/curvature.h>

#include <stdlib.h>
#include <string.h>

/* ---- directions ---- */

/* Where derivatives vanish the direction is the limit. */
batten_status bat_arcs_direction(const bat_arcs_path *p, double u, batten_side side,
                                 double row[4])
{
    batten_status status = batten_curve_evaluate_side(p->curve, u, side, 1, row);
    /* Below a millionth of the average a derivative may be rounding; then it is looked at. */
    if (status != BATTEN_OK || bat_norm(2, row + 2) > 1e-6 * p->speed) {
        if (status == BATTEN_OK)
            bat_direction(2, row + 2, row + 2);
        return status;
    }
    batten_curve_local local = {.tangent = {0, 0, 0}};
    status = batten_curve_local_at(p->curve, u, side, &local);
    row[2] = local.tangent.x;
    row[3] = local.tangent.y;
    if (status == BATTEN_SINGULAR_HERE && bat_largest(2, row + 2) > 0)
        return BATTEN_OK;
    return status;
}

/* ---- where the curve is cut and looked at ---- */

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int unique(int count, double *values)
{
    int kept = 0;
    qsort(values, (size_t)count, sizeof *values, by_value);
    for (int i = 0; i < count; i++)
        if (kept == 0 || values[i] > values[kept - 1])
            values[kept++] = values[i];
    return kept;
}

/* Knots, inflections, extremes of curvature. */
static batten_status find_stations(bat_arcs_path *p)
{
    batten_parameters bends = {0, NULL}, extremes = {0, NULL};
    batten_status status = batten_curve_inflections(p->curve, &bends);
    if (status == BATTEN_OK)
        status = batten_curve_curvature_extrema(p->curve, &extremes);
    const int knots = batten_curve_spans(p->curve, NULL);
    if (status == BATTEN_OK) {
        /* Between any two of these there may be a place where the speed is least. */
        p->stations =
            bat_array(2 * ((size_t)knots + (size_t)bends.count + (size_t)extremes.count),
                      sizeof *p->stations);
        status = p->stations ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        batten_curve_spans(p->curve, p->stations);
        for (int i = 0; i < bends.count; i++)
            p->stations[knots + i] = bends.at[i];
        for (int i = 0; i < extremes.count; i++)
            p->stations[knots + bends.count + i] = extremes.at[i];
        p->station_count = unique(knots + bends.count + extremes.count, p->stations);
    }
    bat_release(bends.at);
    bat_release(extremes.at);
    return status;
}

/* Half the rate of the squared speed. */
static batten_status speeding(const bat_arcs_path *p, double u, double *rate, double *speed)
{
    double row[6];
    const batten_status status = batten_curve_evaluate(p->curve, u, 2, row);
    *rate = bat_dot(2, row + 2, row + 4);
    *speed = bat_norm(2, row + 2);
    return status;
}

/* The place in [a, b] where the speed is least, by halving; NaN when it is rising or falling
 * throughout, or when the curve does not come to rest there. */
static batten_status find_rest(const bat_arcs_path *p, double a, double b, double *at)
{
    double rate = 0, speed = 0;
    *at = NAN;
    batten_status status = speeding(p, a + 1e-6 * (b - a), &rate, &speed);
    if (status != BATTEN_OK || rate >= 0)
        return status;
    status = speeding(p, b - 1e-6 * (b - a), &rate, &speed);
    if (status != BATTEN_OK || rate <= 0)
        return status;
    for (int i = 0; i < 60 && status == BATTEN_OK; i++) {
        const double middle = a + (b - a) / 2;
        status = speeding(p, middle, &rate, &speed);
        *(rate < 0 ? &a : &b) = middle;
    }
    /* Near a cusp speed grows as the distance in u: rounding leaves about the root of eps. */
    if (speed <= 1e-7 * p->speed)
        *at = a + (b - a) / 2;
    return status;
}

static batten_status add_rests(bat_arcs_path *p)
{
    const int n = p->station_count;
    int count = n;
    for (int i = 0; i + 1 < n; i++) {
        double at = NAN;
        const batten_status status = find_rest(p, p->stations[i], p->stations[i + 1], &at);
        if (status != BATTEN_OK)
            return status;
        if (!isnan(at))
            p->stations[count++] = at;
    }
    p->station_count = unique(count, p->stations);
    return BATTEN_OK;
}

static batten_status is_corner(const bat_arcs_path *p, double before, double after,
                               double allowed, bool *corner)
{
    double in[4], out[4];
    batten_status status = bat_arcs_direction(p, before, BATTEN_FROM_LEFT, in);
    if (status == BATTEN_OK)
        status = bat_arcs_direction(p, after, BATTEN_FROM_RIGHT, out);
    if (status == BATTEN_OK)
        *corner = fabs(bat_turn(in + 2, out + 2)) > allowed;
    return status;
}

static batten_status find_corners(bat_arcs_path *p, double allowed)
{
    const int n = p->station_count;
    p->corners = bat_array((size_t)n, sizeof *p->corners);
    if (!p->corners)
        return BATTEN_OUT_OF_MEMORY;
    p->corners[p->corner_count++] = p->domain.a;
    for (int i = 1; i + 1 < n; i++) {
        bool corner = false;
        const batten_status status =
            is_corner(p, p->stations[i], p->stations[i], allowed, &corner);
        if (status != BATTEN_OK)
            return status;
        if (corner)
            p->corners[p->corner_count++] = p->stations[i];
    }
    p->corners[p->corner_count++] = p->domain.b;
    bool corner = false;
    p->closed = batten_curve_is_closed(p->curve, 16 * DBL_EPSILON * p->scale);
    const batten_status status = is_corner(p, p->domain.b, p->domain.a, allowed, &corner);
    p->smooth_seam = p->closed && !corner && p->corner_count == 2;
    return status;
}

static batten_status measure_size(bat_arcs_path *p)
{
    const batten_box box = batten_curve_box(p->curve);
    const double size =
        bat_norm(2, (const double[]){box.high.x - box.low.x, box.high.y - box.low.y});
    p->scale = bat_max(bat_max(fabs(box.low.x), fabs(box.high.x)),
                       bat_max(fabs(box.low.y), fabs(box.high.y)));
    p->speed = size / (p->domain.b - p->domain.a);
    if (size <= 16 * DBL_EPSILON * p->scale)
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve is a point");
    return isfinite(size) ? BATTEN_OK
                          : bat_fail(BATTEN_OVERFLOW, "the curve is too large for a number");
}

batten_status bat_arcs_path_make(const batten_curve *curve, double corner, bat_arcs_path *p)
{
    *p = (bat_arcs_path){.curve = curve, .domain = batten_curve_domain(curve)};
    batten_status status = measure_size(p);
    if (status == BATTEN_OK)
        status = find_stations(p);
    if (status == BATTEN_OK)
        status = add_rests(p);
    if (status == BATTEN_OK)
        status = find_corners(p, corner);
    return status;
}

void bat_arcs_path_end(bat_arcs_path *p)
{
    bat_release(p->stations);
    bat_release(p->corners);
}

/* ---- samples ---- */

/* The first station after u. */
static int station_after(const bat_arcs_path *p, double u)
{
    int low = 0, high = p->station_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (p->stations[middle] > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Both ends, the stations between, and `inner` places or more between these: `total` in all at
 * least. */
batten_status bat_arcs_take(const bat_arcs_path *p, batten_interval over, int inner, int total,
                            bat_samples *samples)
{
    const double a = over.a, b = over.b;
    const int first = station_after(p, a);
    int last = first;
    while (last < p->station_count && p->stations[last] < b)
        last++;
    const int parts = last - first + 1;
    const int each = bat_max_int(inner, total / parts) + 1;
    const int count = parts * each + 1;
    batten_status status = bat_samples_reserve(samples, count);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < parts; i++) {
        const double low = i == 0 ? a : p->stations[first + i - 1];
        const double high = i + 1 == parts ? b : p->stations[first + i];
        for (int k = 0; k < each; k++)
            samples->u[i * each + k] = low + (high - low) * ((double)k / each);
    }
    samples->u[count - 1] = b;
    samples->count = count;
    status = batten_curve_evaluate_many(p->curve, (size_t)count, samples->u, 1, NULL,
                                        samples->rows[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(p->curve, b, BATTEN_FROM_LEFT, 1,
                                            samples->rows[count - 1]);
    return status;
}

/* By how much the curve turns along its samples, all small turns added. */
double bat_arcs_turn(const bat_samples *samples)
{
    double turn = 0;
    const double *before = NULL;
    for (int i = 0; i < samples->count; i++) {
        const double *d = samples->rows[i] + 2;
        if (d[0] == 0 && d[1] == 0)
            continue;
        if (before)
            turn += bat_turn(before, d);
        before = d;
    }
    return turn;
}

/* ---- deviations ---- */

typedef struct {
    double u, slope; /* the place and how the distance changes there */
} sloped;

/* The extreme between two samples where the slope changes its sign: by false position, the end
 * that stays counting half. */
static batten_status refine(const bat_arcs_path *p, const bat_arcs_probe *probe, sloped a,
                            sloped b, bat_beside *beside)
{
    double row[4];
    for (int i = 0; i < 12; i++) {
        const double u = a.u + (b.u - a.u) * (a.slope / (a.slope - b.slope));
        if (!(u > a.u && u < b.u))
            break;
        const batten_status status = batten_curve_evaluate(p->curve, u, 1, row);
        if (status != BATTEN_OK)
            return status;
        const sloped middle = {u, bat_arcs_slope(probe, row)};
        bat_beside_widen(beside, u, bat_arcs_beside(probe, row));
        if (middle.slope == 0 || b.u - a.u < 1e-9 * (fabs(a.u) + fabs(b.u)))
            break;
        if ((middle.slope > 0) == (a.slope > 0)) {
            a = middle;
            b.slope /= 2;
        } else {
            b = middle;
            a.slope /= 2;
        }
    }
    return BATTEN_OK;
}

/* The extremes among the samples and at all roots of the slope between them. */
batten_status bat_arcs_measure(const bat_arcs_path *p, const batten_biarc *biarc,
                               const bat_samples *samples, bat_beside *beside)
{
    bat_arcs_probe probe;
    bat_arcs_probe_make(biarc, &probe);
    *beside = bat_arcs_beside_samples(&probe, samples);
    sloped before = {samples->u[0], bat_arcs_slope(&probe, samples->rows[0])};
    for (int i = 1; i < samples->count; i++) {
        const sloped here = {samples->u[i], bat_arcs_slope(&probe, samples->rows[i])};
        if ((here.slope > 0 && before.slope < 0) || (here.slope < 0 && before.slope > 0)) {
            const batten_status status = refine(p, &probe, before, here, beside);
            if (status != BATTEN_OK)
                return status;
        }
        before = here;
    }
    return BATTEN_OK;
}

int bat_arcs_ranges(const bat_arcs_path *p, const bat_arcs_part *part,
                    batten_interval ranges[2])
{
    const double a = p->domain.a, b = p->domain.b;
    const double from = part->from >= b ? part->from - (b - a) : part->from;
    const double to = part->from >= b ? part->to - (b - a) : part->to;
    ranges[0] = (batten_interval){from, bat_min(to, b)};
    ranges[1] = (batten_interval){a, a + (to - b)};
    return ranges[1].b > a ? 2 : 1;
}
