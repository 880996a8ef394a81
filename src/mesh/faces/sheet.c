/* Surfaces as meshes see them: normals, creases, and how large a cell may be. */
#include "mesh/faces/lattice.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- surfaces ---- */

/* A span below this share of the domain divides what rounding leaves of differences. */
static const double shortest_span = 1e-9;

static batten_interval steady_part(const batten_surface *surface, batten_direction direction,
                                   batten_interval domain)
{
    batten_interval part = domain;
    const double close = shortest_span * (domain.b - domain.a);
    if (strcmp(batten_surface_kind(surface), "nurbs") != 0)
        return part;
    const double *knots = batten_surface_knots(surface, direction);
    const int count = batten_surface_knot_count(surface, direction);
    for (int i = 0; i < count; i++) {
        if (knots[i] > domain.a && knots[i] <= domain.a + close)
            part.a = domain.a + 2 * close;
        if (knots[i] < domain.b && knots[i] >= domain.b - close)
            part.b = domain.b - 2 * close;
    }
    return part;
}

void bat_sheet_begin(bat_sheet *sheet, const batten_surface *surface, double tolerance)
{
    sheet->surface = surface;
    for (int d = 0; d < 2; d++) {
        const batten_direction direction = (batten_direction)d;
        sheet->domain[d] = batten_surface_domain(surface, direction);
        sheet->steady[d] = steady_part(surface, direction, sheet->domain[d]);
        sheet->closed[d] = batten_surface_is_closed(surface, direction, tolerance);
    }
}

batten_status bat_sheet_steady(const bat_sheet *sheet, const double uv[2],
                               const batten_side side[2], double *d)
{
    double at[2], steady[9];
    for (int k = 0; k < 2; k++)
        at[k] = bat_min(bat_max(uv[k], sheet->steady[k].a), sheet->steady[k].b);
    if (at[0] == uv[0] && at[1] == uv[1])
        return BATTEN_OK;
    const batten_status status = batten_surface_evaluate_side(
        sheet->surface, at[0], at[1], (batten_sides){side[0], side[1]}, 1, steady);
    if (status == BATTEN_OK)
        memcpy(d + 3, steady + 3, 6 * sizeof *d);
    return status;
}

void bat_sheet_wrap(const bat_sheet *sheet, double uv[2])
{
    for (int d = 0; d < 2; d++) {
        const double a = sheet->domain[d].a, b = sheet->domain[d].b;
        if (sheet->closed[d] && (uv[d] < a || uv[d] > b))
            uv[d] -= floor((uv[d] - a) / (b - a)) * (b - a);
        uv[d] = bat_min(bat_max(uv[d], a), b);
    }
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double norm(const double *a)
{
    return bat_hypot(bat_hypot(a[0], a[1]), a[2]);
}

/* A sine below which the directions of Su and Sv, or one of their lengths, are lost. */
static const double least_sine = 1e-9;

bool bat_sheet_normal(const double *d, double normal[3])
{
    double su[3], sv[3];
    const double lu = norm(d + 3), lv = norm(d + 6);
    if (!(lu > least_sine * lv) || !(lv > least_sine * lu))
        return false;
    for (int k = 0; k < 3; k++) {
        su[k] = d[3 + k] / lu;
        sv[k] = d[6 + k] / lv;
    }
    bat_cross(su, sv, normal);
    const double length = norm(normal);
    for (int k = 0; k < 3; k++)
        normal[k] /= length > 0 ? length : 1;
    return length > least_sine;
}

/* [FMM86] bound by all of the second derivatives; what lies in the tangent plane moves points
 * along the surface and not off it. */
void bat_lattice_bound(const double *d, bat_lattice_bounds *out)
{
    const double *su = d + 3, *sv = d + 6;
    double n[3], part[3], other[3], big[3];
    const bool regular = bat_sheet_normal(d, n);
    out->length[0] = norm(su);
    out->length[1] = norm(sv);
    for (int k = 0; k < 3; k++)
        out->bend[k] = regular ? fabs(dot(n, d + 9 + 3 * k)) : norm(d + 9 + 3 * k);
    bat_cross(su, sv, big);
    const double size = norm(big);
    for (int k = 0; k < 2; k++) { /* N_u = Suu x Sv + Su x Suv, N_v = Suv x Sv + Su x Svv */
        bat_cross(d + 9 + 3 * k, sv, part);
        bat_cross(su, d + 12 + 3 * k, other);
        for (int i = 0; i < 3; i++)
            part[i] += other[i];
        const double along = regular ? dot(part, n) : 0;
        for (int i = 0; i < 3; i++)
            part[i] -= along * n[i];
        out->turn[k] = regular && size > 0 ? norm(part) / size : 0;
    }
}

/* An angle between the normals on both sides of a line below which it counts as smooth. */
static const double crease = 0.01;

batten_status bat_sheet_is_crease(const bat_sheet *sheet, int d, double at, bool *found)
{
    enum { SAMPLES = 7 };
    double sides[2][9], n[2][3];
    const batten_interval along = sheet->domain[1 - d];
    *found = false;
    for (int i = 0; i < SAMPLES && !*found; i++) {
        const double other = along.a + (i + 0.43) / SAMPLES * (along.b - along.a);
        bool regular = true;
        for (int k = 0; k < 2; k++) {
            const batten_side side = k ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
            const batten_status status = batten_surface_evaluate_side(
                sheet->surface, d ? other : at, d ? at : other,
                (batten_sides){d ? BATTEN_FROM_RIGHT : side, d ? side : BATTEN_FROM_RIGHT}, 1,
                sides[k]);
            if (status != BATTEN_OK)
                return status;
            regular = bat_sheet_normal(sides[k], n[k]) && regular;
        }
        double away[3];
        bat_cross(n[0], n[1], away);
        *found = regular && (dot(n[0], n[1]) < 0 || norm(away) > crease);
    }
    return BATTEN_OK;
}
