/*
 * Integrals over the wet parts of patches by Gauss's theorem. Rows of a patch are cut where they
 * cross the water, so each piece is smooth; across the rows the cut is halved where it is not.
 */
#include "hydrostatics/wet.h"
#include "base/work.h"
#include "hydrostatics/kinks.h"
#include "numeric/bernstein.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

/* The largest integrand is the cube of a position by a normal: of degree 4 p - 1 for patches of degree p. */
enum { MOST_NODES = BAT_MAX_GAUSS, MOST_DEPTH = 44, MOST_PARTS = 16 };

/* Beyond so many halvings of a patch the errors are what they are. */
enum { MOST_HALVINGS = 2000 };
/* Heights that are 0 but for rounding, as a part of the size. */
static const double IN_WATER = 1e-14;
/* Errors of all bands together, in those that are allowed for one. */
static const double MOST_ALLOWED = 100;
/* No sum is better than this, as a share of the area. */
static const double ROUNDING = 100 * DBL_EPSILON;

typedef struct {
    const bat_patch *patch;
    const bat_water *water;
    batten_direction constant; /* along the rows */
    double sign;               /* of S_constant x S_row outwards */
    int count;                 /* of nodes */
    double nodes[MOST_NODES], weights[MOST_NODES];
} region;

/* A band of rows; each wet piece of a row is integrated in `parts` equal parts. */
typedef struct {
    double from, to;
    int parts, depth;
    double sums[BAT_SUMS];
} band;

/* ---- one point ---- */

static void normal_of(const bat_row_point *p, double sign, double out[3])
{
    bat_cross(p->derivative[0], p->derivative[1], out);
    for (int c = 0; c < 3; c++)
        out[c] *= sign;
}

static void add_point(const region *r, const bat_row_point *p, double weight,
                      double sums[BAT_SUMS])
{
    const bat_water *w = r->water;
    double normal[3];
    normal_of(p, r->sign, normal);
    const double up = weight * bat_dot(3, w->n, normal), h = bat_dot(3, w->n, p->at) - w->d;
    const double along = bat_dot(3, w->along, p->at), across = bat_dot(3, w->across, p->at);
    sums[BAT_VOLUME] += h * up;
    for (int c = 0; c < 3; c++)
        sums[BAT_MOMENT + c] += (p->at[c] - w->n[c] * h / 2) * h * up;
    sums[BAT_PLANE] -= up;
    sums[BAT_PLANE_ALONG] -= along * up;
    sums[BAT_PLANE_ACROSS] -= across * up;
    sums[BAT_PLANE_SQUARES] -= along * along * up;
    sums[BAT_PLANE_SQUARES + 1] -= along * across * up;
    sums[BAT_PLANE_SQUARES + 2] -= across * across * up;
    sums[BAT_OPENING] += weight * bat_dot(3, w->along, normal);
    sums[BAT_OPENING + 1] += weight * bat_dot(3, w->across, normal);
    if (r->patch->lid != BAT_JOINT)
        sums[r->patch->lid == BAT_SKIN ? BAT_WETTED : BAT_WET_LIDS] +=
            weight * sqrt(bat_dot(3, normal, normal));
}

/* ---- one row ---- */

/* Where a row crosses the water, with both ends: 0 = at[0] <= ... <= at[*count] = 1. */
static batten_status cut_row(const bat_row *row, const double *heights, double *at, int *count)
{
    at[0] = 0;
    const batten_status status = bat_row_roots(row->degree, heights, at + 1, count);
    at[++*count] = 1;
    return status;
}

static void add_piece(const region *r, const bat_row *row, const double ends[2], double weight,
                      int parts, double sums[BAT_SUMS])
{
    const double half = 0.5 * (ends[1] - ends[0]) / parts;
    for (int part = 0; part < parts; part++)
        for (int i = 0; i < r->count; i++) {
            bat_row_point p;
            bat_row_at(row, ends[0] + half * (2 * part + 1 + r->nodes[i]), &p);
            add_point(r, &p, weight * half * r->weights[i], sums);
        }
}

/* What lies in the water's surface is wet from below: a flat bottom is, a flat deck is not. */
static bool is_wet(const region *r, const bat_row *row, const double *heights, double t)
{
    const double height = bat_bernstein_value(row->degree, heights, t);
    bat_row_point p;
    double normal[3];
    if (fabs(height) > IN_WATER)
        return height < 0;
    if (r->patch->lid == BAT_JOINT) /* its like on the other side takes away what it adds */
        return false;
    bat_row_at(row, t, &p);
    normal_of(&p, r->sign, normal);
    return bat_dot(3, r->water->n, normal) < 0;
}

static batten_status add_row(const region *r, double t, double weight, band *b)
{
    bat_row row;
    double at[BATTEN_MAX_DEGREE + 2], heights[BATTEN_MAX_DEGREE + 1];
    int count = 0;
    bat_patch_row(r->patch, r->constant, t, &row);
    bat_row_heights(&row, r->water->n, r->water->d, heights);
    const batten_status status = cut_row(&row, heights, at, &count);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < count; k++)
        if (at[k + 1] > at[k] && is_wet(r, &row, heights, 0.5 * (at[k] + at[k + 1])))
            add_piece(r, &row, at + k, weight, b->parts, b->sums);
    return BATTEN_OK;
}

static batten_status sum_band(const region *r, band *b)
{
    batten_status status = BATTEN_OK;
    const double half = 0.5 * (b->to - b->from), middle = 0.5 * (b->to + b->from);
    memset(b->sums, 0, sizeof b->sums);
    for (int i = 0; i < r->count && status == BATTEN_OK; i++)
        status = add_row(r, middle + half * r->nodes[i], half * r->weights[i], b);
    return status;
}

/* ---- one patch ---- */

/* Rows run in the direction in which the height changes more, so that most cross the water once. */
static batten_direction steep_direction(const bat_patch *patch, const double n[3])
{
    double change[2] = {0, 0};
    const int rows = patch->degree[0] + 1, columns = patch->degree[1] + 1;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const double *p = patch->points + 4 * (i * columns + j);
            const double *last[2] = {i > 0 ? p - (ptrdiff_t)4 * columns : p, j > 0 ? p - 4 : p};
            for (int k = 0; k < 2; k++)
                change[k] +=
                    fabs(bat_dot(3, n, p) / p[3] - bat_dot(3, n, last[k]) / last[k][3]);
        }
    return change[1] / rows >= change[0] / columns ? BATTEN_V : BATTEN_U;
}

static region region_of(const bat_patch *patch, const bat_water *water)
{
    region r = {.patch = patch, .water = water};
    const batten_direction along = steep_direction(patch, water->n);
    r.constant = (batten_direction)!along;
    r.sign = along == BATTEN_V ? patch->sign : -patch->sign;
    r.count = bat_min_int(MOST_NODES, 2 * bat_max_int(patch->degree[0], patch->degree[1]));
    bat_gauss(r.count, r.nodes, r.weights);
    return r;
}

/* Is some of a patch below the water? By its control points. */
static bool may_be_wet(const bat_patch *patch, const bat_water *water)
{
    const int count = (patch->degree[0] + 1) * (patch->degree[1] + 1);
    for (int i = 0; i < count; i++)
        if (bat_dot(3, water->n, patch->points + 4 * i) <= water->d * patch->points[4 * i + 3])
            return true;
    return false;
}

/* The largest difference of sums that matters, as a share of what each may be off. */
static double worst_share(const double *a, const double *b, const double *c,
                          const double allowed[BAT_SUMS])
{
    double worst = 0;
    for (int k = 0; k < BAT_SUMS; k++)
        worst = bat_max(worst, fabs(a[k] - b[k] - (c ? c[k] : 0)) / allowed[k]);
    return worst;
}

/* With the error of the rows and that of the band across them. */
static void keep_sums(bat_wet *out, const double *coarse, const double *of_rows,
                      const band halves[2])
{
    for (int k = 0; k < BAT_SUMS; k++) {
        const double sum = halves[0].sums[k] + halves[1].sums[k];
        out->sums[k] += sum;
        out->errors[k] += fabs(sum - coarse[k]) + of_rows[k];
    }
}

/* Sums of the rows with other parts, and how far they are from those of the band. */
static batten_status compare_parts(const region *r, const band *b, int parts, band *other,
                                   double of_rows[BAT_SUMS])
{
    *other = *b;
    other->parts = parts;
    const batten_status status = sum_band(r, other);
    for (int k = 0; k < BAT_SUMS; k++)
        of_rows[k] = fabs(other->sums[k] - b->sums[k]);
    return status;
}

/* Finer parts while they tell something new; where there are none, what fewer would change. */
static batten_status find_parts(const region *r, const double allowed[BAT_SUMS], band *b,
                                double of_rows[BAT_SUMS])
{
    band other;
    if (2 * b->parts > MOST_PARTS)
        return compare_parts(r, b, b->parts / 2, &other, of_rows);
    for (; 2 * b->parts <= MOST_PARTS; *b = other) {
        const batten_status status = compare_parts(r, b, 2 * b->parts, &other, of_rows);
        if (status != BATTEN_OK || worst_share(other.sums, b->sums, NULL, allowed) <= 1)
            return status;
    }
    return BATTEN_OK;
}

static batten_status halve_band(const region *r, const band *b, band halves[2])
{
    batten_status status = BATTEN_OK;
    halves[0] = halves[1] = *b;
    halves[0].to = halves[1].from = 0.5 * (b->from + b->to);
    for (int i = 0; i < 2 && status == BATTEN_OK; i++) {
        halves[i].depth = b->depth + 1;
        status = sum_band(r, &halves[i]);
    }
    return status;
}

/* `waiting` has room for MOST_DEPTH + 2: of each depth one half waits. Bands whose halves tell
 * nothing new are kept. */
static batten_status integrate_band(const region *r, const double allowed[BAT_SUMS], band whole,
                                    band *waiting, bat_wet *out)
{
    int count = 1, halvings = 0;
    waiting[0] = whole;
    batten_status status = sum_band(r, &waiting[0]);
    while (count > 0 && status == BATTEN_OK) {
        double of_rows[BAT_SUMS];
        band b = waiting[--count], halves[2];
        status = find_parts(r, allowed, &b, of_rows);
        if (status == BATTEN_OK)
            status = halve_band(r, &b, halves);
        if (status != BATTEN_OK)
            break;
        const bool settled = worst_share(b.sums, halves[0].sums, halves[1].sums, allowed) <= 1;
        if (settled || halves[0].depth >= MOST_DEPTH || ++halvings > MOST_HALVINGS) {
            out->limited |= !settled;
            keep_sums(out, b.sums, of_rows, halves);
        } else {
            waiting[count++] = halves[1];
            waiting[count++] = halves[0];
        }
    }
    return status;
}

/* Band by band between kinks, which no rule would see that none of its nodes meets. */
static batten_status integrate_patch(const region *r, const double allowed[BAT_SUMS],
                                     band *waiting, bat_wet *out)
{
    double kinks[BAT_MOST_KINKS];
    int count = 0;
    batten_status status = bat_find_kinks(r->patch, r->constant, r->water, kinks, &count);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++)
        if (kinks[i + 1] > kinks[i])
            status = integrate_band(r, allowed,
                                    (band){.from = kinks[i], .to = kinks[i + 1], .parts = 1},
                                    waiting, out);
    return status;
}

static batten_status add_sizes(const region *r, double sizes[BAT_SUMS])
{
    double kinks[BAT_MOST_KINKS];
    int count = 0;
    batten_status status = bat_find_kinks(r->patch, r->constant, r->water, kinks, &count);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        band b = {.from = kinks[i], .to = kinks[i + 1], .parts = 1};
        status = sum_band(r, &b);
        for (int k = 0; k < BAT_SUMS; k++)
            sizes[k] += b.sums[k];
    }
    return status;
}

/* ---- all patches ---- */

/* What each sum may be off in one patch: by the sizes of the sums of its kind. */
static batten_status find_allowed(const batten_hull *hull, const bat_water *water,
                                  double precision, double allowed[BAT_SUMS])
{
    double sizes[BAT_SUMS] = {0};
    for (int i = 0; i < hull->patch_count; i++) {
        if (!may_be_wet(&hull->patches[i], water))
            continue;
        const region r = region_of(&hull->patches[i], water);
        const batten_status status = add_sizes(&r, sizes);
        if (status != BATTEN_OK)
            return status;
    }
    const double area = fabs(sizes[BAT_WETTED]) + fabs(sizes[BAT_WET_LIDS]);
    for (int k = 0; k < BAT_SUMS; k++) {
        const double size = k < BAT_PLANE     ? fabs(sizes[BAT_VOLUME])
                            : k < BAT_OPENING ? fabs(sizes[BAT_PLANE])
                                              : area;
        allowed[k] = bat_max(precision * size, ROUNDING * area) + DBL_MIN;
    }
    return BATTEN_OK;
}

static batten_status add_patches(const batten_hull *hull, const bat_water *water,
                                 const double allowed[BAT_SUMS], band *waiting,
                                 const batten_job *job, bat_wet *out)
{
    bat_work work = {job, 0};
    for (int i = 0; i < hull->patch_count; i++) {
        if (!may_be_wet(&hull->patches[i], water))
            continue;
        const region r = region_of(&hull->patches[i], water);
        batten_status status = integrate_patch(&r, allowed, waiting, out);
        if (status == BATTEN_OK)
            status = bat_work_step(&work, (uint64_t)(r.count * r.count),
                                   (double)(i + 1) / hull->patch_count, "hydrostatics");
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* Narrow bands that met the limits matter only where their errors add up to something. */
static batten_status check_errors(const bat_wet *wet, const double allowed[BAT_SUMS])
{
    for (int k = 0; k < BAT_SUMS && wet->limited; k++)
        if (wet->errors[k] > MOST_ALLOWED * allowed[k])
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "hydrostatics are not found within the precision after %d halvings "
                            "of a patch",
                            MOST_HALVINGS);
    return BATTEN_OK;
}

batten_status bat_hull_wet(const batten_hull *hull, const bat_water *water, double precision,
                           const batten_job *job, bat_wet *out)
{
    double allowed[BAT_SUMS];
    band *waiting = bat_array(MOST_DEPTH + 2, sizeof *waiting);
    if (!waiting)
        return BATTEN_OUT_OF_MEMORY;
    *out = (bat_wet){{0}, {0}, false};
    batten_status status = find_allowed(hull, water, precision, allowed);
    if (status == BATTEN_OK)
        status = add_patches(hull, water, allowed, waiting, job, out);
    bat_release(waiting);
    return status == BATTEN_OK ? check_errors(out, allowed) : status;
}

/* ---- whole patches ---- */

void bat_patch_flux(const bat_patch *patch, double flux[3], double normal[3])
{
    const bat_water none = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2};
    const region r = region_of(patch, &none);
    for (int i = 0; i < r.count; i++)
        for (int j = 0; j < r.count; j++) {
            const double weight = r.weights[i] * r.weights[j] / 4;
            bat_row row;
            bat_row_point p;
            double n[3];
            bat_patch_row(patch, r.constant, 0.5 + 0.5 * r.nodes[i], &row);
            bat_row_at(&row, 0.5 + 0.5 * r.nodes[j], &p);
            normal_of(&p, r.sign, n);
            for (int c = 0; c < 3; c++) {
                flux[c] += weight * p.at[c] * n[c];
                normal[c] += weight * n[c];
            }
        }
}

batten_status bat_patch_area(const bat_patch *patch, double *area)
{
    const bat_water none = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2};
    const region r = region_of(patch, &none);
    band b = {.from = 0, .to = 1, .parts = MOST_PARTS};
    const batten_status status = sum_band(&r, &b);
    *area = b.sums[BAT_WETTED] + b.sums[BAT_WET_LIDS];
    return status;
}
