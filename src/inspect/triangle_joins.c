/* How Bezier triangles meet along their edges: gaps, slopes, tangent planes. */
#include "inspect/forms.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"
#include "spline/triangles/triangles.h"

#include <stdlib.h>
#include <string.h>

enum { PLACES = 33, FORMS = 100 };

/* ---- who meets whom ---- */

/* A unit vector (but for 2e-6 less) along which the points of grids do not coincide. */
static const double sweep[3] = {0.754877, 0.56984, 0.324718};

typedef struct {
    double x; /* along the sweep */
    int corner;
} corner_place;

static int compare_places(const void *a, const void *b)
{
    const corner_place *first = a, *second = b;
    if (first->x != second->x)
        return first->x < second->x ? -1 : 1;
    return (first->corner > second->corner) - (first->corner < second->corner);
}

static const double *corner_point(const batten_triangles *triangles, int corner)
{
    static const int indices[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    const int n = triangles->degree;
    const int *which = indices[corner % 3];
    const size_t at = (size_t)(corner / 3) * triangles->net_count +
                      (size_t)BATTEN_TRIANGLE_POINT(n * which[0], n * which[1]);
    return triangles->points + at * (size_t)triangles->dimension;
}

/* Corners that lie together get one number: vertices [3 count]. */
static batten_status number_corners(const batten_triangles *triangles, double tolerance,
                                    int *vertices)
{
    const int count = 3 * triangles->count, d = triangles->dimension;
    corner_place *places = bat_array((size_t)count, sizeof *places);
    if (!places)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        places[i] = (corner_place){bat_dot(d, sweep, corner_point(triangles, i)), i};
    qsort(places, (size_t)count, sizeof *places, compare_places);
    for (int i = 0; i < count; i++) {
        const int corner = places[i].corner;
        vertices[corner] = corner;
        for (int j = i - 1; j >= 0 && places[i].x - places[j].x <= tolerance; j--)
            if (bat_distance(d, corner_point(triangles, corner),
                             corner_point(triangles, places[j].corner)) <= tolerance) {
                vertices[corner] = vertices[places[j].corner];
                break;
            }
    }
    bat_release(places);
    return BATTEN_OK;
}

static int compare_joins(const void *a, const void *b)
{
    const batten_triangle_join *first = a, *second = b;
    for (int k = 0; k < 2; k++) {
        if (first->triangle[k] != second->triangle[k])
            return first->triangle[k] < second->triangle[k] ? -1 : 1;
        if (first->edge[k] != second->edge[k])
            return first->edge[k] - second->edge[k];
    }
    return 0;
}

/* Pairs among edges that are sorted by their vertices; joins [3 count] are filled with who
 * meets. */
static int pair_edges(int edge_count, const bat_triangle_edge *edges, const int *corners,
                      batten_triangle_join *joins)
{
    int found = 0, first = 0;
    for (int i = 1; i < edge_count; i++) {
        if (edges[i].low != edges[first].low || edges[i].high != edges[first].high) {
            first = i;
            continue;
        }
        if (edges[i].low == edges[i].high)
            continue; /* collapsed */
        batten_triangle_join *join = &joins[found++];
        const bat_triangle_edge pair[2] = {edges[first], edges[i]};
        for (int k = 0; k < 2; k++) {
            join->triangle[k] = pair[k].triangle;
            join->edge[k] = pair[k].edge;
        }
        join->same_way = corners[3 * pair[0].triangle + (pair[0].edge + 1) % 3] ==
                         corners[3 * pair[1].triangle + (pair[1].edge + 1) % 3];
    }
    qsort(joins, (size_t)found, sizeof *joins, compare_joins);
    return found;
}

/* ---- how they meet ---- */

/* Where the control point s of row r of triangle k stands, s counted along the first edge. */
static int place_of(const batten_triangles *triangles, const batten_triangle_join *join, int k,
                    int r, int s)
{
    const int n = triangles->degree;
    const bool turned = k == 1 && !join->same_way;
    return bat_triangle_at(n, join->edge[k], r, turned ? n - r - s : s);
}

static const double *point_of(const batten_triangles *triangles,
                              const batten_triangle_join *join, int k, int r, int s)
{
    const size_t at = (size_t)join->triangle[k] * triangles->net_count +
                      (size_t)place_of(triangles, join, k, r, s);
    return triangles->points + at * (size_t)triangles->dimension;
}

static double gap_of(const batten_triangles *triangles, const batten_triangle_join *join)
{
    double gap = 0;
    for (int s = 0; s <= triangles->degree; s++)
        gap =
            bat_max(gap, bat_distance(triangles->dimension, point_of(triangles, join, 0, 0, s),
                                      point_of(triangles, join, 1, 0, s)));
    return gap;
}

static double slope_of(const batten_triangles *triangles, const batten_triangle_join *join)
{
    if (!triangles->vertex_count || triangles->weights)
        return -1;
    const int d = triangles->dimension, e = join->edge[0];
    const int apex = triangles->corners[3 * join->triangle[1] + join->edge[1]];
    double b[3], worst = 0;
    bat_triangle_barycentric(triangles->vertices, triangles->corners + 3 * join->triangle[0],
                             triangles->vertices + 2 * apex, b);
    for (int s = 0; s < triangles->degree; s++) {
        const double *inner = point_of(triangles, join, 0, 1, s);
        const double *here = point_of(triangles, join, 0, 0, s);
        const double *next = point_of(triangles, join, 0, 0, s + 1);
        double wanted[3];
        for (int c = 0; c < d; c++)
            wanted[c] = b[e] * inner[c] + b[(e + 1) % 3] * here[c] + b[(e + 2) % 3] * next[c];
        worst = bat_max(worst, bat_distance(d, wanted, point_of(triangles, join, 1, 1, s)));
    }
    return worst;
}

/* What is measured along an edge. */
typedef struct {
    double angle;
    double along, across[2]; /* the largest lengths of derivatives */
} measured;

static batten_status measure_place(const batten_triangles *triangles,
                                   const batten_triangle_join *join, double t, measured *so_far)
{
    batten_vec3 normals[2];
    for (int k = 0; k < 2; k++) {
        const int e = join->edge[k];
        const double from_start = k == 1 && !join->same_way ? 1 - t : t;
        double at[3], values[9], to[3][3] = {{0}}, E[3], D[3];
        at[e] = 0;
        at[(e + 1) % 3] = 1 - from_start;
        at[(e + 2) % 3] = from_start;
        batten_status status =
            batten_triangles_evaluate(triangles, join->triangle[k], at, 1, values);
        if (status != BATTEN_OK)
            return status;
        memcpy(to[1], values + 3, 2 * sizeof to[1]); /* from corner 0 to corners 0, 1, 2 */
        for (int c = 0; c < 3; c++) {
            E[c] = to[(e + 2) % 3][c] - to[(e + 1) % 3][c];
            D[c] = to[e][c] - to[(e + 1) % 3][c];
        }
        so_far->along = bat_max(so_far->along, bat_norm(3, E));
        so_far->across[k] = bat_max(so_far->across[k], bat_norm(3, D));
        status = batten_triangles_normal(triangles, join->triangle[k], at, NULL, &normals[k]);
        if (status != BATTEN_OK)
            return status;
    }
    if (join->same_way)
        normals[1] = bat_vec3_scale(normals[1], -1);
    so_far->angle =
        bat_max(so_far->angle, bat_atan2(bat_vec3_norm(bat_vec3_cross(normals[0], normals[1])),
                                         bat_vec3_dot(normals[0], normals[1])));
    return BATTEN_OK;
}

static batten_status measure_joins(const batten_triangles *triangles,
                                   const batten_triangle_join *join, measured *out)
{
    *out = (measured){.angle = -1};
    for (int i = 0; i < PLACES; i++) {
        const batten_status status = measure_place(triangles, join, i / (PLACES - 1.0), out);
        /* A place without a normal says nothing. */
        if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
            return status;
    }
    return BATTEN_OK;
}

/* ---- the determinant ---- */

/* Where homogeneous rows of the net lead from the edge: a vector along it (row 0 only) or from
 * row 0 to row 1, or the points themselves. */
typedef enum { POINTS, ALONG, ACROSS } edge_vector;

/* Its coordinate c, 3 for the weight, as a form along the edge. */
static bat_form vector_form(const batten_triangles *triangles, const batten_triangle_join *join,
                            int k, edge_vector what, int c, bat_forms *forms)
{
    const int n = triangles->degree, degree = what == POINTS ? n : n - 1;
    const double *net = bat_triangle_net(triangles, join->triangle[k]);
    const double *origin = point_of(triangles, join, 0, 0, 0);
    bat_form form = {degree, forms->memory + forms->used, 0};
    forms->used += (size_t)degree + 1;
    for (int s = 0; s <= degree; s++) {
        double values[2];
        for (int end = 0; end < 2; end++) {
            const int r = end == 1 && what == ACROSS, next = end == 1 && what == ALONG;
            const double *row =
                net + (size_t)place_of(triangles, join, k, r, bat_min_int(s + next, n)) *
                          triangles->width;
            const double w = triangles->weights ? row[3] : 1;
            values[end] = c == 3 ? w : row[c] - w * origin[c];
        }
        form.c[s] =
            bat_binomials[degree][s] * (what == POINTS ? values[0] : values[1] - values[0]);
    }
    return form;
}

/* The largest Bernstein coefficient of the determinant of P, E, D0, D1 in homogeneous
 * coordinates, by Laplace's rule along pairs of coordinates. It is that of E, D0, D1 in space
 * times the fourth power of the weight. */
static double determinant(const batten_triangles *triangles, const batten_triangle_join *join,
                          bat_forms *forms)
{
    static const int pairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    static const double signs[6] = {1, -1, 1, 1, -1, 1};
    bat_form vectors[4][4];
    forms->used = 0;
    for (int c = 0; c < 4; c++) {
        vectors[0][c] = vector_form(triangles, join, 0, POINTS, c, forms);
        vectors[1][c] = vector_form(triangles, join, 0, ALONG, c, forms);
        vectors[2][c] = vector_form(triangles, join, 0, ACROSS, c, forms);
        vectors[3][c] = vector_form(triangles, join, 1, ACROSS, c, forms);
    }
    bat_form sum = {0};
    for (int i = 0; i < 6; i++) {
        bat_form minors[2];
        for (int k = 0; k < 2; k++) {
            const int *pair = pairs[k == 0 ? i : 5 - i];
            bat_form *a = vectors[2 * k], *b = vectors[2 * k + 1];
            minors[k] = bat_form_sum(forms, bat_form_product(forms, a[pair[0]], b[pair[1]]), -1,
                                     bat_form_product(forms, a[pair[1]], b[pair[0]]));
        }
        const bat_form term = bat_form_product(forms, minors[0], minors[1]);
        sum = i == 0 ? term : bat_form_sum(forms, sum, signs[i], term);
    }
    double largest = 0, choose = 1;
    for (int s = 0; s <= sum.degree; s++) {
        largest = bat_max(largest, fabs(sum.c[s]) / choose);
        choose = choose * (sum.degree - s) / (s + 1);
    }
    return largest;
}

static batten_status describe(const batten_triangles *triangles, bat_forms *forms,
                              batten_triangle_join *join)
{
    join->gap = gap_of(triangles, join);
    join->slope = slope_of(triangles, join);
    join->coplanarity = join->angle = -1;
    if (triangles->dimension < 3)
        return BATTEN_OK;
    measured lengths;
    const batten_status status = measure_joins(triangles, join, &lengths);
    if (status != BATTEN_OK)
        return status;
    const double n = triangles->degree;
    const double unit = lengths.along * lengths.across[0] * lengths.across[1] / (n * n * n);
    join->angle = lengths.angle;
    join->coplanarity = unit > 0 ? determinant(triangles, join, forms) / unit : 0;
    return BATTEN_OK;
}

void batten_triangle_joins_release(batten_triangle_joins *joins)
{
    bat_release(joins->at);
    *joins = (batten_triangle_joins){0, NULL};
}

batten_status batten_triangles_joins(const batten_triangles *triangles, double tolerance,
                                     batten_triangle_joins *out)
{
    assert(triangles && out);
    if (!(tolerance > 0) || !isfinite(tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be positive",
                        tolerance);
    const size_t edge_count = 3 * (size_t)triangles->count;
    bat_triangle_edge *edges = NULL;
    bat_forms forms = {0};
    int *numbers = bat_array(edge_count, sizeof *numbers);
    batten_triangle_join *made = bat_array(edge_count, sizeof *made);
    batten_status status = numbers && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && triangles->vertex_count)
        memcpy(numbers, triangles->corners, edge_count * sizeof *numbers);
    else if (status == BATTEN_OK)
        status = number_corners(triangles, tolerance, numbers);
    if (status == BATTEN_OK)
        status = bat_triangle_edges(triangles->count, numbers, &edges);
    if (status == BATTEN_OK)
        status = bat_forms_begin(FORMS, 4 * triangles->degree, &forms);
    const int found =
        status == BATTEN_OK ? pair_edges((int)edge_count, edges, numbers, made) : 0;
    for (int i = 0; i < found && status == BATTEN_OK; i++)
        status = describe(triangles, &forms, &made[i]);
    bat_forms_end(&forms);
    bat_release(edges);
    bat_release(numbers);
    if (status != BATTEN_OK) {
        bat_release(made);
        return status;
    }
    *out = (batten_triangle_joins){found, made};
    return BATTEN_OK;
}
