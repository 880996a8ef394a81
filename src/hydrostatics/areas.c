/* Areas of plane sections below the water. */
#include "base/sort.h"
#include "hydrostatics/wet.h"
#include "numeric/quadrature.h"

#include <string.h>

/* A section is taken so far inside of the place asked for, as a part of the size: the end of a
 * hull is then within it, and joints of patches, often at stations, are not counted twice. */
static const double INSIDE = 1e-10;
enum { MOST_EVALUATIONS = 4000, MOST_BREAKS = 2 * BATTEN_MAX_DEGREE + 2 };

typedef struct {
    const bat_patch *patch;
    const bat_water *water;
    batten_direction constant;
    double x;
} cut;

static const double ALONG_SHIP[3] = {1, 0, 0};

/* Rows that run along the ship meet the section once, as a rule. */
static batten_direction direction_along_ship(const bat_patch *patch)
{
    const int rows = patch->degree[0], columns = patch->degree[1];
    const double *first = patch->points, *u_end = first + 4 * rows * (columns + 1),
                 *v_end = first + 4 * columns;
    const double *last = u_end + 4 * columns;
    const double u = fabs(u_end[0] / u_end[3] - first[0] / first[3]) +
                     fabs(last[0] / last[3] - v_end[0] / v_end[3]);
    const double v = fabs(v_end[0] / v_end[3] - first[0] / first[3]) +
                     fabs(last[0] / last[3] - u_end[0] / u_end[3]);
    return u > v ? BATTEN_U : BATTEN_V;
}

static batten_status row_roots(const bat_row *row, double x, double *roots, int *count)
{
    double heights[BATTEN_MAX_DEGREE + 1];
    bat_row_heights(row, ALONG_SHIP, x, heights);
    return bat_row_roots(row->degree, heights, roots, count);
}

/* What one point of the section adds by Gauss's theorem in its plane, for a field that vanishes
 * at the water: h n / n.n times the normal there. */
static double flux_at(const cut *c, const bat_row_point *p)
{
    const double *n = c->water->n, *a = p->derivative[0], *b = p->derivative[1];
    const double h = n[0] * p->at[0] + n[1] * p->at[1] + n[2] * p->at[2] - c->water->d;
    if (h > 0 || b[0] == 0)
        return 0;
    const double sign = c->constant == BATTEN_U ? c->patch->sign : -c->patch->sign;
    const double y = sign * (a[2] * b[0] - a[0] * b[2]), z = sign * (a[0] * b[1] - a[1] * b[0]);
    return h * (n[1] * y + n[2] * z) / (n[1] * n[1] + n[2] * n[2]) / fabs(b[0]);
}

static batten_status flux_of_row(void *context, double t, double *value)
{
    const cut *c = context;
    bat_row row;
    double roots[BATTEN_MAX_DEGREE];
    int count = 0;
    bat_patch_row(c->patch, c->constant, t, &row);
    const batten_status status = row_roots(&row, c->x, roots, &count);
    *value = 0;
    for (int i = 0; i < count; i++) {
        bat_row_point p;
        bat_row_at(&row, roots[i], &p);
        *value += flux_at(c, &p);
    }
    return status;
}

/* Where the section enters and leaves the patch at the ends of its rows. */
static batten_status find_breaks(const cut *c, double breaks[MOST_BREAKS], int *count)
{
    batten_status status = BATTEN_OK;
    *count = 0;
    breaks[(*count)++] = 0;
    for (int end = 0; end < 2 && status == BATTEN_OK; end++) {
        bat_row row;
        int found = 0;
        bat_patch_row(c->patch, (batten_direction)!c->constant, end, &row);
        status = row_roots(&row, c->x, breaks + *count, &found);
        *count += found;
    }
    breaks[(*count)++] = 1;
    bat_sort_doubles((size_t)*count, breaks);
    return status;
}

static bool may_reach(const bat_patch *patch, double x)
{
    const int count = (patch->degree[0] + 1) * (patch->degree[1] + 1);
    bool below = false, above = false;
    for (int i = 0; i < count; i++) {
        const double at = patch->points[4 * i] - x * patch->points[4 * i + 3];
        below |= at <= 0;
        above |= at >= 0;
    }
    return below && above;
}

static batten_status add_patch_area(cut *c, double tolerance, double *area)
{
    double breaks[MOST_BREAKS];
    int count = 0;
    batten_status status = find_breaks(c, breaks, &count);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        double value = 0, error;
        if (!(breaks[i + 1] > breaks[i]))
            continue;
        status = bat_integrate(flux_of_row, c, breaks[i], breaks[i + 1], tolerance,
                               MOST_EVALUATIONS, &value, &error);
        *area += value;
    }
    return status;
}

static batten_status section_area(const batten_hull *hull, const bat_water *water, double x,
                                  double tolerance, double *area)
{
    batten_status status = BATTEN_OK;
    const double place = (x - hull->centre[0]) / hull->size;
    const double inside = place + (place > 0 ? -INSIDE : INSIDE);
    *area = 0;
    for (int i = 0; i < hull->patch_count && status == BATTEN_OK; i++) {
        const bat_patch *patch = &hull->patches[i];
        cut c = {patch, water, (batten_direction)!direction_along_ship(patch), inside};
        if (may_reach(patch, inside))
            status = add_patch_area(&c, tolerance, area);
    }
    return status;
}

static batten_status section_areas(const batten_hull *hull, const bat_water *water, int count,
                                   const double *x, double precision, double *areas)
{
    const double l = hull->size;
    const double largest =
        (hull->box.high.y - hull->box.low.y) / l * ((hull->box.high.z - hull->box.low.z) / l);
    for (int i = 0; i < count; i++) {
        if (!isfinite(x[i]))
            return bat_fail(BATTEN_BAD_ARGUMENT, "place %d of the sections is not finite",
                            i + 1);
        const batten_status status =
            section_area(hull, water, x[i], precision * largest, &areas[i]);
        if (status != BATTEN_OK)
            return status;
        areas[i] *= l * l;
    }
    return BATTEN_OK;
}

batten_status batten_hull_section_areas(const batten_hull *hull,
                                        const batten_flotation *flotation, int count,
                                        const double *x, double precision, double *areas)
{
    bat_water water;
    batten_status status = bat_check_precision(precision);
    if (status == BATTEN_OK)
        status = bat_water_of(hull, flotation, &water);
    if (status != BATTEN_OK || count < 1)
        return status;
    double *found = bat_array((size_t)count, sizeof *found);
    if (!found)
        return BATTEN_OUT_OF_MEMORY;
    status = section_areas(hull, &water, count, x, precision, found);
    if (status == BATTEN_OK)
        memcpy(areas, found, (size_t)count * sizeof *found);
    bat_release(found);
    return status;
}
