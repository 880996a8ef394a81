/*
 * Plane sections of surfaces by marching squares.
 *
 * The height g = normal . S - offset is taken at the nodes of a grid of isoparametric lines.
 * Where it changes sign along an edge of the grid the crossing is found there by bisection to
 * rounding; each cell joins the crossings of its edges; chains of them are the section. A node
 * on the plane itself counts as above it, so that every crossing has exactly one edge and no
 * curve ends there.
 */
#include "base/plural.h"
#include "inspect/section_chains.h"
#include "numeric/vector.h"
#include <batten/nearest.h>

#include <float.h>
#include <string.h>

static size_t node(const bat_section_march *m, int i, int j)
{
    return (size_t)i * (size_t)(m->nv + 1) + (size_t)j;
}

/* ---- heights ---- */

static double height_of(const bat_section_march *m, const double *point)
{
    return m->normal.x * point[0] + m->normal.y * point[1] + m->normal.z * point[2] - m->offset;
}

static batten_status measure_nodes(bat_section_march *m)
{
    double *row = bat_array3((size_t)m->nv + 1, 3, sizeof *row);
    batten_status status = row ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i <= m->nu; i++) {
        status = batten_surface_evaluate_grid(
            m->surface, (batten_uv_grid){1, (size_t)m->nv + 1, m->u + i, m->v}, 0, NULL, row);
        for (int j = 0; status == BATTEN_OK && j <= m->nv; j++) {
            const double height = height_of(m, row + 3 * j);
            m->heights[node(m, i, j)] = fabs(height) <= m->roundoff ? 0 : height;
        }
    }
    bat_release(row);
    for (int j = 0; status == BATTEN_OK && m->closed[BATTEN_U] && j <= m->nv; j++)
        m->heights[node(m, m->nu, j)] = m->heights[node(m, 0, j)];
    for (int i = 0; status == BATTEN_OK && m->closed[BATTEN_V] && i <= m->nu; i++)
        m->heights[node(m, i, m->nv)] = m->heights[node(m, i, 0)];
    return status;
}

/* Nodes on the plane go above it; those on the rim of the surface to the other side than their
 * inner neighbour, so that a rim that lies in the plane is part of the section. */
static void decide_zeros(bat_section_march *m)
{
    const double tiny = DBL_MIN;
    for (int i = 0; i <= m->nu; i++)
        for (int j = 0; j <= m->nv; j++) {
            double *height = &m->heights[node(m, i, j)];
            const bool rim_u = !m->closed[BATTEN_U] && (i == 0 || i == m->nu);
            const bool rim_v = !m->closed[BATTEN_V] && (j == 0 || j == m->nv);
            if (*height != 0)
                continue;
            const int in_i = rim_u ? (i == 0 ? 1 : i - 1) : i;
            const int in_j = rim_v ? (j == 0 ? 1 : j - 1) : j;
            const double inner = m->heights[node(m, in_i, in_j)];
            *height = (rim_u || rim_v) && inner > tiny ? -tiny : tiny;
        }
}

/* ---- crossings ---- */

/* Bisect [a, b] along one line until the ends are neighbours; the end nearer to the plane. */
static batten_status refine(const bat_section_march *m, double *u, double *v, double *varying,
                            double b, double height_b, double *point)
{
    double a = *varying;
    batten_status status = BATTEN_OK;
    double best = HUGE_VAL, found = a, here[3];
    for (int k = 0; k < 128 && status == BATTEN_OK; k++) {
        const double middle = a + (b - a) / 2;
        *varying = k == 0 ? a : k == 1 ? b : middle;
        status = batten_surface_evaluate(m->surface, *u, *v, 0, here);
        const double height = height_of(m, here);
        if (status == BATTEN_OK && fabs(height) < best) {
            best = fabs(height);
            found = *varying;
            memcpy(point, here, sizeof here);
        }
        if (best <= m->roundoff / 8 || (k >= 2 && (middle == a || middle == b)))
            break;
        if (k >= 2 && (height > 0) == (height_b > 0))
            b = middle;
        else if (k >= 2)
            a = middle;
    }
    *varying = found;
    return status;
}

/* The crossing on the edge from node (i, j) to (i + di, j + dj), if there is one. */
static batten_status cross_edge(bat_section_march *m, int i, int j, int di, int dj, int *edge)
{
    const double a = m->heights[node(m, i, j)], b = m->heights[node(m, i + di, j + dj)];
    *edge = -1;
    if ((a > 0) == (b > 0))
        return BATTEN_OK;
    bat_section_crossing *made = &m->crossings[m->count];
    double u = m->u[i], v = m->v[j], point[3] = {0};
    batten_status status =
        refine(m, &u, &v, di ? &u : &v, di ? m->u[i + 1] : m->v[j + 1], b, point);
    if (status != BATTEN_OK)
        return status;
    *made = (bat_section_crossing){u, v, {point[0], point[1], point[2]}, {-1, -1}};
    *edge = m->count++;
    return BATTEN_OK;
}

static batten_status cross_edges(bat_section_march *m)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i <= m->nu; i++)
        for (int j = 0; status == BATTEN_OK && j <= m->nv; j++) {
            int *along_u = &m->edge_u[node(m, i, j)], *along_v = &m->edge_v[node(m, i, j)];
            *along_u = *along_v = -1;
            if (i < m->nu && m->closed[BATTEN_V] && j == m->nv)
                *along_u = m->edge_u[node(m, i, 0)];
            else if (i < m->nu)
                status = cross_edge(m, i, j, 1, 0, along_u);
            if (j < m->nv && m->closed[BATTEN_U] && i == m->nu)
                *along_v = m->edge_v[node(m, 0, j)];
            else if (status == BATTEN_OK && j < m->nv)
                status = cross_edge(m, i, j, 0, 1, along_v);
        }
    return status;
}

/* No more crossings than edges whose ends have different signs. */
static int count_crossings(const bat_section_march *m)
{
    int count = 0;
    for (int i = 0; i <= m->nu; i++)
        for (int j = 0; j <= m->nv; j++) {
            const bool above = m->heights[node(m, i, j)] > 0;
            count += i < m->nu && above != (m->heights[node(m, i + 1, j)] > 0);
            count += j < m->nv && above != (m->heights[node(m, i, j + 1)] > 0);
        }
    return count;
}

/* ---- links ---- */

static void join(bat_section_march *m, int a, int b)
{
    if (a == b) /* a cell that is as wide as a closed surface */
        return;
    bat_section_crossing *first = &m->crossings[a], *second = &m->crossings[b];
    first->link[first->link[0] >= 0] = b;
    second->link[second->link[0] >= 0] = a;
}

/* Four crossings: two curves that do not meet. The height in the middle says which corners
 * belong together: those of its sign are joined across the cell, the other two are cut off. */
static batten_status join_saddle(bat_section_march *m, int i, int j, const int edges[4])
{
    double point[3];
    const double u = (m->u[i] + m->u[i + 1]) / 2, v = (m->v[j] + m->v[j + 1]) / 2;
    batten_status status = batten_surface_evaluate(m->surface, u, v, 0, point);
    if (status != BATTEN_OK)
        return status;
    const bool first_above = m->heights[node(m, i, j)] > 0;
    const bool cut_first = (height_of(m, point) >= 0) != first_above;
    /* Around the cell: low v, high u, high v, low u; the first corner is between the last and
     * the first. */
    join(m, edges[0], edges[cut_first ? 3 : 1]);
    join(m, edges[2], edges[cut_first ? 1 : 3]);
    return BATTEN_OK;
}

static batten_status join_cell(bat_section_march *m, int i, int j)
{
    const int edges[4] = {m->edge_u[node(m, i, j)], m->edge_v[node(m, i + 1, j)],
                          m->edge_u[node(m, i, j + 1)], m->edge_v[node(m, i, j)]};
    int found[4], count = 0;
    for (int k = 0; k < 4; k++)
        if (edges[k] >= 0)
            found[count++] = edges[k];
    if (count == 4)
        return join_saddle(m, i, j, edges);
    if (count == 2)
        join(m, found[0], found[1]);
    return BATTEN_OK;
}

static batten_status join_cells(bat_section_march *m)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < m->nu; i++)
        for (int j = 0; status == BATTEN_OK && j < m->nv; j++)
            status = join_cell(m, i, j);
    return status;
}

/* ---- the section ---- */

static batten_status check_section(const batten_surface *surface, batten_vec3 normal,
                                   double offset, int cells_u, int cells_v)
{
    if (batten_surface_dimension(surface) != 3)
        return bat_fail(
            BATTEN_NOT_COMPATIBLE, "a surface in %d dimension%s has no plane section",
            batten_surface_dimension(surface), bat_plural(batten_surface_dimension(surface)));
    if (!isfinite(normal.x) || !isfinite(normal.y) || !isfinite(normal.z) || !isfinite(offset))
        return bat_fail(BATTEN_NOT_FINITE, "the plane (%g, %g, %g) . x = %g is not finite",
                        normal.x, normal.y, normal.z, offset);
    if (bat_vec3_norm(normal) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the normal of the plane is zero");
    if (cells_u < 1 || cells_v < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a grid of %d x %d cells", cells_u, cells_v);
    /* A gigabyte of corner values. */
    if ((double)cells_u * cells_v > 1e8)
        return bat_fail(BATTEN_TOO_LARGE, "a grid of %d x %d cells, above 100,000,000", cells_u,
                        cells_v);
    return BATTEN_OK;
}

static double *lines_of(const batten_surface *surface, batten_direction direction, int cells)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    double *lines = bat_array((size_t)cells + 1, sizeof *lines);
    for (int i = 0; lines && i <= cells; i++)
        lines[i] =
            i == cells ? domain.b : domain.a + (domain.b - domain.a) * (i / (double)cells);
    return lines;
}

/* The plane with a unit normal; what rounding leaves of a height on it. */
static void set_plane(bat_section_march *m, batten_vec3 normal, double offset)
{
    const batten_box box = batten_surface_box(m->surface);
    const double corners[6] = {box.low.x,  box.low.y,  box.low.z,
                               box.high.x, box.high.y, box.high.z};
    const double size = bat_vec3_norm(normal);
    m->normal = bat_vec3_scale(normal, 1 / size);
    m->offset = offset / size;
    m->roundoff = 16 * DBL_EPSILON * (bat_largest(6, corners) + fabs(m->offset));
    for (int k = 0; k < 2; k++)
        m->closed[k] = batten_surface_is_closed(m->surface, (batten_direction)k, m->roundoff);
}

static batten_status begin_march(bat_section_march *m)
{
    const size_t nodes_u = (size_t)m->nu + 1, nodes_v = (size_t)m->nv + 1;
    m->u = lines_of(m->surface, BATTEN_U, m->nu);
    m->v = lines_of(m->surface, BATTEN_V, m->nv);
    m->heights = bat_array3(nodes_u, nodes_v, sizeof *m->heights);
    m->edge_u = bat_array3(nodes_u, nodes_v, sizeof *m->edge_u);
    m->edge_v = bat_array3(nodes_u, nodes_v, sizeof *m->edge_v);
    const bool all = m->u && m->v && m->heights && m->edge_u && m->edge_v;
    batten_status status = all ? measure_nodes(m) : BATTEN_OUT_OF_MEMORY;
    if (status != BATTEN_OK)
        return status;
    decide_zeros(m);
    m->crossings = bat_array((size_t)count_crossings(m), sizeof *m->crossings);
    return m->crossings ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void end_march(bat_section_march *m)
{
    bat_release(m->u);
    bat_release(m->v);
    bat_release(m->heights);
    bat_release(m->edge_u);
    bat_release(m->edge_v);
    bat_release(m->crossings);
}

batten_status batten_surface_section(const batten_surface *surface, batten_vec3 normal,
                                     double offset, int cells_u, int cells_v,
                                     batten_polylines *out)
{
    batten_status status = check_section(surface, normal, offset, cells_u, cells_v);
    if (status != BATTEN_OK)
        return status;
    bat_section_march m = {.surface = surface, .nu = cells_u, .nv = cells_v};
    batten_polylines lines = {0};
    set_plane(&m, normal, offset);
    status = begin_march(&m);
    if (status == BATTEN_OK)
        status = cross_edges(&m);
    if (status == BATTEN_OK)
        status = join_cells(&m);
    if (status == BATTEN_OK)
        status = bat_section_chains(&m, &lines);
    end_march(&m);
    if (status == BATTEN_OK)
        *out = lines;
    else
        batten_polylines_release(&lines);
    return status;
}

void batten_polylines_release(batten_polylines *lines)
{
    for (int i = 0; i < lines->count; i++) {
        bat_release(lines->lines[i].points);
        bat_release(lines->lines[i].parameters);
    }
    bat_release(lines->lines);
    *lines = (batten_polylines){0};
}
