/* The border of a face as corners in (u, v), and its triangles. */
#include "mesh/faces/rim.h"
#include "base/list.h"
#include "inspect/nearest/foot.h"

#include <stdlib.h>
#include <string.h>

static batten_status add_corner(bat_rim *rim, const bat_rim_corner *corner)
{
    if (BAT_LIST_GROW(rim->corners, rim->count, rim->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    rim->corners[rim->count] = *corner;
    rim->corners[rim->count].next = rim->count + 1;
    rim->count++;
    return BATTEN_OK;
}

/* By the step of Gauss and Newton to the foot of the point; steps of a twentieth of the domain
 * or more, as near poles, are not taken. */
static batten_status spread_corner(const bat_sheet *sheet, const double *point, double uv[2])
{
    double d[9], at[2] = {uv[0], uv[1]}, step[2];
    bat_foot_place here;
    bat_sheet_wrap(sheet, at);
    const batten_status status = batten_surface_evaluate(sheet->surface, at[0], at[1], 1, d);
    if (status != BATTEN_OK)
        return status;
    bat_foot_slopes(3, d, 1, point, &here);
    if (!bat_foot_solve(here.normal, here.gradient, (const bool[2]){true, true}, step))
        return BATTEN_OK;
    for (int k = 0; k < 2; k++)
        if (!(fabs(step[k]) < (sheet->domain[k].b - sheet->domain[k].a) / 20))
            return BATTEN_OK;
    uv[0] += step[0];
    uv[1] += step[1];
    return BATTEN_OK;
}

static batten_status add_samples(bat_rim *rim, const bat_meshing *m, int face,
                                 const batten_body_use *use)
{
    const bat_polyline *line = &m->edges[use->edge];
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i + 1 < line->count; i++) {
        const int at = use->reversed ? line->count - 1 - i : i;
        bat_rim_corner corner = {.vertex = line->vertex[at],
                                 .edge = use->edge,
                                 .segment = use->reversed ? at - 1 : at};
        status = batten_curve_evaluate(use->parameters, line->t[at], 0, corner.uv);
        if (status == BATTEN_OK && m->spread[face])
            status = spread_corner(&m->sheets[face], m->points[corner.vertex], corner.uv);
        if (status == BATTEN_OK)
            status = add_corner(rim, &corner);
    }
    return status;
}

/* ---- poles ---- */

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The seeds on the straight line of a pole, along direction d, in the order of the line. */
static batten_status seeds_between(const bat_lattice *l, int d, const double ends[2][2],
                                   double **found, int *count)
{
    const bat_lattice_axis *along = &l->axis[d], *across = &l->axis[1 - d];
    const double line = bat_lattice_to_plane(across, ends[0][1 - d]);
    const double from = bat_lattice_to_plane(along, ends[0][d]);
    const double to = bat_lattice_to_plane(along, ends[1][d]);
    /* In the plane cells are of size 1 or powers of two of it: this is their rounding. */
    const double close = 1e-9;
    *count = 0;
    *found = bat_array((size_t)l->seed_count, sizeof **found);
    if (!*found)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < l->seed_count; i++) {
        const double x = d ? l->seeds[i].y : l->seeds[i].x;
        const double y = d ? l->seeds[i].x : l->seeds[i].y;
        if (fabs(y - line) <= close && x > bat_min(from, to) + close &&
            x < bat_max(from, to) - close)
            (*found)[(*count)++] = to > from ? x : -x;
    }
    qsort(*found, (size_t)*count, sizeof **found, compare_numbers);
    int kept = 0;
    for (int i = 0; i < *count; i++)
        if (kept == 0 || (*found)[i] > (*found)[kept - 1])
            (*found)[kept++] = (*found)[i];
    *count = kept;
    for (int i = 0; i < kept; i++)
        (*found)[i] = bat_lattice_from_plane(along, fabs((*found)[i]));
    return BATTEN_OK;
}

static batten_status add_pole(bat_rim *rim, const bat_meshing *m, const batten_body_use *use,
                              const bat_lattice *lattice)
{
    const batten_interval domain = batten_curve_domain(use->parameters);
    double ends[2][2];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = batten_curve_evaluate(
            use->parameters, (k == 1) != use->reversed ? domain.b : domain.a, 0, ends[k]);
    const int d = fabs(ends[1][0] - ends[0][0]) >= fabs(ends[1][1] - ends[0][1]) ? 0 : 1;
    bat_rim_corner corner = {.vertex = m->same[m->parts->edges[use->edge].vertices[0]],
                             .edge = -1,
                             .segment = -1,
                             .pole = d + 1};
    rim->has_poles = true;
    memcpy(corner.uv, ends[0], sizeof corner.uv);
    if (status == BATTEN_OK)
        status = add_corner(rim, &corner);
    double *found = NULL;
    int count = 0;
    if (status == BATTEN_OK && lattice)
        status = seeds_between(lattice, d, (const double(*)[2])ends, &found, &count);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const double part = (found[i] - ends[0][d]) / (ends[1][d] - ends[0][d]);
        corner.uv[d] = found[i];
        corner.uv[1 - d] = ends[0][1 - d] + part * (ends[1][1 - d] - ends[0][1 - d]);
        status = add_corner(rim, &corner);
    }
    bat_release(found);
    return status;
}

/* The corner behind a pole is on it too. */
static void mark_ends_of_poles(bat_rim *rim)
{
    for (int i = 0; i < rim->count; i++) {
        bat_rim_corner *next = &rim->corners[rim->corners[i].next];
        if (rim->corners[i].edge < 0 && next->pole == 0)
            next->pole = rim->corners[i].pole;
    }
}

/* Corners of loops that touch at a vertex are at one place. */
static void join_touching(bat_rim *rim, const bat_meshing *m, int face)
{
    enum { MOST = 500 };
    int list[MOST], count = 0;
    for (int i = 0; i < rim->count; i++) {
        bat_rim_corner *c = &rim->corners[i];
        if (c->vertex >= m->parts->vertex_count || !m->touched[c->vertex] || count == MOST)
            continue;
        for (int k = 0; k < count; k++) {
            const bat_rim_corner *known = &rim->corners[list[k]];
            bool close = known->vertex == c->vertex;
            /* As in touches.c. */
            for (int d = 0; d < 2; d++) {
                const batten_interval domain = m->sheets[face].domain[d];
                close = close && fabs(known->uv[d] - c->uv[d]) <= 1e-6 * (domain.b - domain.a);
            }
            if (close)
                memcpy(c->uv, known->uv, sizeof c->uv);
        }
        list[count++] = i;
    }
}

batten_status bat_rim_begin(bat_rim *rim, const bat_meshing *m, int face,
                            const bat_lattice *lattice)
{
    const batten_body_face *f = &m->parts->faces[face];
    batten_status status = BATTEN_OK;
    *rim = (bat_rim){0};
    for (int i = f->first; status == BATTEN_OK && i < f->first + f->count; i++) {
        const batten_body_loop *loop = &m->parts->loops[i];
        const int first = rim->count;
        for (int k = 0; status == BATTEN_OK && k < loop->count; k++) {
            const batten_body_use *use = &m->parts->uses[loop->first + k];
            status = m->parts->edges[use->edge].curve ? add_samples(rim, m, face, use)
                                                      : add_pole(rim, m, use, lattice);
        }
        if (status == BATTEN_OK && rim->count > first)
            rim->corners[rim->count - 1].next = first;
    }
    if (status == BATTEN_OK) {
        mark_ends_of_poles(rim);
        join_touching(rim, m, face);
        rim->at = bat_array((size_t)rim->count, sizeof *rim->at);
        rim->vertex_of = bat_array((size_t)rim->count, sizeof *rim->vertex_of);
        if (!rim->at || !rim->vertex_of)
            status = BATTEN_OUT_OF_MEMORY;
    }
    if (status != BATTEN_OK)
        bat_rim_end(rim);
    return status;
}

void bat_rim_end(bat_rim *rim)
{
    bat_release(rim->corners);
    bat_release(rim->at);
    bat_release(rim->vertex_of);
    *rim = (bat_rim){0};
}

void bat_rim_box(const bat_rim *rim, batten_interval box[2])
{
    for (int k = 0; k < 2; k++) {
        box[k] = (batten_interval){0, 0};
        for (int i = 0; i < rim->count; i++) {
            const double u = rim->corners[i].uv[k];
            box[k].a = i ? bat_min(box[k].a, u) : u;
            box[k].b = i ? bat_max(box[k].b, u) : u;
        }
    }
}

/* ---- triangles ---- */

static batten_status refine(const bat_rim *rim, int corner, bat_pairs *splits)
{
    const bat_rim_corner *c = &rim->corners[corner];
    int index;
    return c->edge < 0 ? BATTEN_OK : bat_pairs_add(splits, c->edge, c->segment, &index);
}

/* What must be finer: the sides at some vertices, and those between some pairs. In all one pass
 * over the border, however many there are. */
typedef struct {
    bool *at; /* [vertex_count] */
    bat_pairs between;
} in_the_way;

static batten_status way_begin(in_the_way *way, int vertex_count)
{
    way->at = bat_array((size_t)vertex_count, sizeof *way->at);
    if (!way->at)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = bat_pairs_begin(&way->between, 16);
    if (status != BATTEN_OK)
        bat_release(way->at);
    return status;
}

static void way_end(in_the_way *way)
{
    bat_release(way->at);
    bat_pairs_end(&way->between);
}

static batten_status refine_way(const bat_rim *rim, const in_the_way *way, bat_pairs *splits)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < rim->count; i++) {
        const int a = rim->vertex_of[i], b = rim->vertex_of[rim->corners[i].next];
        if (way->at[a] || way->at[b] ||
            bat_pairs_find(&way->between, bat_min_int(a, b), bat_max_int(a, b)) >= 0)
            status = refine(rim, i, splits);
    }
    return status;
}

batten_status bat_rim_refine_all(const bat_rim *rim, bat_pairs *splits)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < rim->count; i++)
        status = refine(rim, i, splits);
    return status;
}

/* Places in the plane: multiples of 2^-200, for which all decisions are exact. */
static void place_corners(bat_rim *rim, const bat_lattice *l)
{
    for (int i = 0; i < rim->count; i++)
        for (int k = 0; k < 2; k++) {
            const double x = bat_lattice_to_plane(&l->axis[k], rim->corners[i].uv[k]);
            rim->at[i][k] = rint(x * 0x1p200) * 0x1p-200;
        }
}

/* Corners at one place in (u, v) must be one vertex of the mesh. */
static batten_status check_places(const bat_rim *rim, const bat_sides *sides, in_the_way *way,
                                  bool *is_simple)
{
    int *vertex = bat_array((size_t)sides->vertex_count, sizeof *vertex);
    if (!vertex)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < rim->count; i++) /* 0: none so far */
        vertex[rim->vertex_of[i]] = rim->corners[i].vertex + 1;
    for (int i = 0; i < rim->count; i++)
        if (vertex[rim->vertex_of[i]] != rim->corners[i].vertex + 1) {
            *is_simple = false;
            way->at[rim->vertex_of[i]] = true;
        }
    bat_release(vertex);
    return BATTEN_OK;
}

static batten_status keep_sides(const bat_rim *rim, bat_sides *sides, in_the_way *way,
                                bat_pairs *splits, bool *is_simple)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < rim->count; i++) {
        const int a = rim->vertex_of[i], b = rim->vertex_of[rim->corners[i].next];
        bat_side_result result;
        int other[2] = {-1, -1}, index;
        if (a == b)
            continue;
        status = bat_sides_keep(sides, a, b, &result, other);
        if (status != BATTEN_OK || result == BAT_SIDE_KEPT)
            continue;
        *is_simple = false;
        status = refine(rim, i, splits);
        if (result == BAT_SIDE_TOUCHES)
            way->at[other[0]] = true;
        else if (status == BATTEN_OK)
            status = bat_pairs_add(&way->between, bat_min_int(other[0], other[1]),
                                   bat_max_int(other[0], other[1]), &index);
    }
    return status;
}

static batten_status keep_all(const bat_rim *rim, bat_sides *sides, bat_pairs *splits,
                              bool *is_simple)
{
    in_the_way way;
    batten_status status = way_begin(&way, sides->vertex_count);
    if (status != BATTEN_OK)
        return status;
    status = check_places(rim, sides, &way, is_simple);
    if (status == BATTEN_OK)
        status = keep_sides(rim, sides, &way, splits, is_simple);
    if (status == BATTEN_OK && !*is_simple)
        status = refine_way(rim, &way, splits);
    way_end(&way);
    return status;
}

batten_status bat_rim_triangles(bat_rim *rim, const bat_lattice *lattice, bat_sides *sides,
                                bat_pairs *splits, bool *is_simple)
{
    place_corners(rim, lattice);
    *is_simple = true;
    batten_status status =
        bat_sides_begin(sides, rim->count, (const double(*)[2])rim->at, rim->vertex_of);
    if (status == BATTEN_TOO_FEW_POINTS || status == BATTEN_COINCIDENT) {
        *is_simple = false;
        return bat_rim_refine_all(rim, splits);
    }
    if (status != BATTEN_OK)
        return status;
    status = keep_all(rim, sides, splits, is_simple);
    if (status == BATTEN_OK && *is_simple)
        status = bat_sides_settle(sides);
    if (status != BATTEN_OK || !*is_simple)
        bat_sides_end(sides);
    return status;
}

batten_status bat_rim_refine(const bat_rim *rim, const bat_pairs *between, bat_pairs *splits)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && between->count && i < rim->count; i++) {
        const int a = rim->vertex_of[i], b = rim->vertex_of[rim->corners[i].next];
        if (bat_pairs_find(between, bat_min_int(a, b), bat_max_int(a, b)) >= 0)
            status = refine(rim, i, splits);
    }
    return status;
}
