/*
 * The wet area of a cross section, as the change of the wet volume behind it: of the field
 * F = h m / m.m, with m the upward direction of the water in the section and h the height above it,
 * the divergence is 1 and nothing flows through the water or through the section. So the volume is
 * the flux of F out of the wet surfaces, and a section moves only the ends of their rows.
 */
#include "base/work.h"
#include "hydrostatics/hull.h"
#include "hydrostatics/kinks.h"
#include "hydrostatics/wet.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"

#include <float.h>

/* A section stands so much nearer to the middle of the hull than is asked, in parts of its size: edges of
 * patches often stand at stations, and neither patch or both would have the section. */
static const double ASIDE = 1e-12;
/* Nearer to a turn, as an angle and as a parameter, roots are rounding: what is smooth in the angle is taken
 * from here. */
static const double NEAREST = 1e-5, NEAREST_ROW = 1e-14;
/* What roots allow beside turns. */
static const double LEAST_PRECISION = 1e-10, MOST_PRECISION = 0.1;
/* Evaluations for each band between kinks; rows that are asked where they leave the water; halvings that leave
 * no digit of such a place. */
enum { MOST_ROWS = 20000, ASKED = 8, HALVINGS = 50 };
/* Errors of all bands together, in those that are allowed for one. */
static const double MOST_ALLOWED = 100;

/* A patch that the section crosses. */
typedef struct {
    const bat_patch *patch;
    const bat_water *water, *section;
    batten_direction constant; /* along the rows */
    double sign;               /* of S_constant x S_row outwards */
    batten_interval band;      /* of rows */
} crossing;

/* What a point of the section adds for each unit of the parameter across the rows. */
static double flux_at(const crossing *c, const bat_row_point *p)
{
    const double *n = c->water->n;
    const double h = bat_dot(3, n, p->at) - c->water->d, moved = fabs(p->derivative[1][0]);
    double normal[3];
    if (h >= 0 || moved == 0)
        return 0;
    bat_cross(p->derivative[0], p->derivative[1], normal);
    return c->sign * h * (n[1] * normal[1] + n[2] * normal[2]) /
           ((n[1] * n[1] + n[2] * n[2]) * moved);
}

/* Where the section meets a row. The places of a section turn around at the ends of bands as square roots do, and
 * its flux has no bound there: rows are numbered by the angle theta of band.a + length sin^2 theta. */
typedef struct {
    int count;
    bat_row_point at[BATTEN_MAX_DEGREE];
} meetings;

static batten_status meet_row(const crossing *c, double theta, meetings *m)
{
    const double sine = bat_sin(theta);
    bat_row row;
    double heights[BATTEN_MAX_DEGREE + 1], roots[BATTEN_MAX_DEGREE];
    bat_patch_row(c->patch, c->constant, c->band.a + (c->band.b - c->band.a) * sine * sine,
                  &row);
    bat_row_heights(&row, c->section->n, c->section->d, heights);
    const batten_status status = bat_row_roots(row.degree, heights, roots, &m->count);
    for (int i = 0; i < m->count; i++)
        bat_row_at(&row, roots[i], &m->at[i]);
    return status;
}

static batten_status row_flux(void *context, double theta, double *value)
{
    const crossing *c = context;
    const double length = c->band.b - c->band.a;
    const double nearest = bat_max(NEAREST, bat_min(BAT_PI / 4, sqrt(NEAREST_ROW / length)));
    meetings m = {0};
    theta = bat_max(nearest, bat_min(BAT_PI / 2 - nearest, theta));
    const batten_status status = meet_row(c, theta, &m);
    *value = 0;
    for (int i = 0; i < m.count; i++)
        *value += flux_at(c, &m.at[i]);
    *value *= length * bat_sin(2 * theta);
    return status;
}

/* Which meetings of a row are under water, as bits. */
static batten_status wet_of(const crossing *c, double theta, uint32_t *wet)
{
    meetings m = {0};
    const batten_status status = meet_row(c, theta, &m);
    *wet = 0;
    for (int i = 0; i < m.count; i++)
        if (bat_dot(3, c->water->n, m.at[i].at) < c->water->d)
            *wet |= (uint32_t)1 << i;
    return status;
}

/* A row between two that differ in what is wet of them, where it changes. */
static batten_status find_change(const crossing *c, double low, double high, uint32_t at_low,
                                 double *place)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < HALVINGS && status == BATTEN_OK; i++) {
        uint32_t wet = 0;
        const double middle = 0.5 * (low + high);
        status = wet_of(c, middle, &wet);
        *(wet == at_low ? &low : &high) = middle;
    }
    *place = high;
    return status;
}

/* The band in pieces: the flux has kinks where the section leaves the water. */
static batten_status add_band(crossing *c, double allowed, double *area, double *error)
{
    const double step = BAT_PI / 2 / ASKED;
    uint32_t before = 0, wet = 0;
    double from = 0;
    batten_status status = wet_of(c, 0.5 * step, &before);
    for (int i = 1; i <= ASKED && status == BATTEN_OK; i++, before = wet) {
        double to = BAT_PI / 2, part = 0, off = 0;
        if (i < ASKED)
            status = wet_of(c, (i + 0.5) * step, &wet);
        if (i < ASKED && wet == before)
            continue;
        if (status == BATTEN_OK && i < ASKED)
            status = find_change(c, (i - 0.5) * step, (i + 0.5) * step, before, &to);
        if (status == BATTEN_OK)
            status = bat_integrate(row_flux, c, from, to, allowed, MOST_ROWS, &part, &off);
        if (status == BATTEN_TOLERANCE_NOT_MET) /* judged with the others */
            status = BATTEN_OK;
        *area += part;
        *error += off;
        from = to;
    }
    return status;
}

/* ---- patches ---- */

/* By its control points; patches above the water have nothing to add. */
static bool is_crossed(const bat_patch *patch, const bat_water *water, const bat_water *section)
{
    const int count = (patch->degree[0] + 1) * (patch->degree[1] + 1);
    bool before = false, behind = false, wet = false;
    for (int i = 0; i < count; i++) {
        const double *p = patch->points + 4 * i;
        const double place = bat_dot(3, section->n, p) - section->d * p[3];
        before |= place > 0;
        behind |= place < 0;
        wet |= bat_dot(3, water->n, p) < water->d * p[3];
    }
    return before && behind && wet;
}

/* Rows that cross the section, as far as it can be seen: places near it count most, and poles, which have no
 * area, do not. */
static batten_direction crossing_direction(const bat_patch *patch, const bat_water *section)
{
    enum { SAMPLES = 5 };
    const double near = 0.01; /* of the hull */
    double steep[2] = {0, 0};
    for (int i = 0; i < SAMPLES; i++) {
        bat_row row;
        bat_patch_row(patch, BATTEN_U, (i + 0.5) / SAMPLES, &row);
        for (int j = 0; j < SAMPLES; j++) {
            bat_row_point p;
            bat_row_at(&row, (j + 0.5) / SAMPLES, &p);
            const double away = fabs(bat_dot(3, section->n, p.at) - section->d) + near;
            double normal[3];
            bat_cross(p.derivative[0], p.derivative[1], normal);
            const double weight = bat_norm(3, normal) / (away * away);
            for (int k = 0; k < 2; k++)
                steep[k] += weight * fabs(bat_dot(3, section->n, p.derivative[k]));
        }
    }
    return steep[1] >= steep[0] ? BATTEN_V : BATTEN_U;
}

static crossing crossing_of(const bat_patch *patch, const bat_water *water,
                            const bat_water *section)
{
    const batten_direction along = crossing_direction(patch, section);
    return (crossing){.patch = patch,
                      .water = water,
                      .section = section,
                      .constant = (batten_direction)!along,
                      .sign = along == BATTEN_V ? patch->sign : -patch->sign};
}

static batten_status add_patch(crossing *c, double allowed, double *area, double *error)
{
    double kinks[BAT_MOST_KINKS];
    int count = 0;
    batten_status status = bat_find_kinks(c->patch, c->constant, c->section, kinks, &count);
    if (status == BATTEN_OK)
        status = bat_sharpen_kinks(c->patch, c->constant, c->section, kinks, &count);
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        c->band = (batten_interval){kinks[i], kinks[i + 1]};
        if (c->band.b > c->band.a)
            status = add_band(c, allowed, area, error);
    }
    return status;
}

static batten_status add_patches(const batten_hull *hull, const bat_water *water,
                                 const bat_water *section, double allowed,
                                 const batten_job *job, double *area)
{
    double error = 0;
    bat_work work = {job, 0};
    for (int i = 0; i < hull->patch_count; i++) {
        if (!is_crossed(&hull->patches[i], water, section))
            continue;
        crossing c = crossing_of(&hull->patches[i], water, section);
        batten_status status = add_patch(&c, allowed, area, &error);
        if (status == BATTEN_OK)
            status = bat_work_step(&work, ASKED, (double)(i + 1) / hull->patch_count,
                                   "areas of sections");
        if (status != BATTEN_OK)
            return status;
    }
    if (error <= MOST_ALLOWED * allowed)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "the area of a section is found within %.3g of its rectangle; %.3g is asked",
        error / allowed, MOST_ALLOWED);
}

batten_status batten_hull_section_area(const batten_hull *hull,
                                       const batten_flotation *flotation, double x,
                                       double precision, const batten_job *job, double *area)
{
    const batten_box box = batten_hull_box(hull);
    const double place = (x - hull->centre[0]) / hull->size;
    const bat_water section = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, place > 0 ? place - ASIDE : place + ASIDE};
    const double rectangle = (box.high.y - box.low.y) * (box.high.z - box.low.z);
    bat_water water;
    double found = 0;
    if (!isfinite(x))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the place of a section is not finite");
    if (!(precision >= LEAST_PRECISION && precision <= MOST_PRECISION))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the precision of a section is %g; it must be %g to %g", precision,
                        LEAST_PRECISION, MOST_PRECISION);
    batten_status status = bat_water_of(hull, flotation, &water);
    if (status == BATTEN_OK)
        status = add_patches(hull, &water, &section,
                             precision * rectangle / (hull->size * hull->size) + DBL_MIN, job,
                             &found);
    if (status == BATTEN_OK)
        *area = found * hull->size * hull->size;
    return status;
}
