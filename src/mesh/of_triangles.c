/*
 * Bezier triangles as meshes: all divided alike, so that neighbours meet. The points of an edge
 * are computed from its control points alone, in one direction for both sides: then they agree
 * to the bit, and welding makes them one.
 */
#include "base/plural.h"
#include "base/work.h"
#include "mesh/options.h"
#include "numeric/box.h"
#include "numeric/vector.h"

#include <batten/mesh.h>
#include <batten/triangles.h>
#include <float.h>
#include <string.h>

typedef struct {
    const batten_triangles *triangles;
    double chord, angle, longest, roundoff; /* longest 0: of any length */
    double side;                            /* the longest that was made */
    int count;                              /* of triangles */
    int parts;                              /* of each edge */
    size_t nodes;                           /* of one triangle: (parts + 1)(parts + 2) / 2 */
    double *points, *normals;               /* [count][nodes][3] */
    bat_work work;
} dividing;

/* ---- points ---- */

/* The control point number s of the edge opposite corner e, counted from corner e + 1. */
static int edge_point(int degree, int e, int s)
{
    return e == 0   ? BATTEN_TRIANGLE_POINT(degree - s, s)
           : e == 1 ? BATTEN_TRIANGLE_POINT(0, degree - s)
                    : BATTEN_TRIANGLE_POINT(s, 0);
}

static int compare(const double *a, const double *b)
{
    for (int k = 0; k < 3; k++)
        if (a[k] != b[k])
            return a[k] < b[k] ? -1 : 1;
    return 0;
}

/* de Casteljau on the homogeneous points of an edge, from its lower end. */
static void point_of_edge(const dividing *d, int triangle, int e, int number, double *out)
{
    const int degree = batten_triangles_degree(d->triangles);
    const size_t first = (size_t)triangle * BATTEN_TRIANGLE_POINTS((size_t)degree);
    const double *points = batten_triangles_points(d->triangles) + 3 * first;
    const double *weights = batten_triangles_weights(d->triangles);
    double h[BATTEN_MAX_DEGREE + 1][4];
    const bool turned = compare(points + 3 * edge_point(degree, e, 0),
                                points + 3 * edge_point(degree, e, degree)) > 0;
    const double t = (double)(turned ? d->parts - number : number) / d->parts;
    for (int s = 0; s <= degree; s++) {
        const int from = edge_point(degree, e, turned ? degree - s : s);
        h[s][3] = weights ? weights[first + (size_t)from] : 1;
        for (int k = 0; k < 3; k++)
            h[s][k] = h[s][3] * points[3 * from + k];
    }
    for (int level = degree; level > 0; level--)
        for (int s = 0; s < level; s++)
            for (int k = 0; k < 4; k++)
                h[s][k] = (1 - t) * h[s][k] + t * h[s + 1][k];
    for (int k = 0; k < 3; k++)
        out[k] = h[0][k] / h[0][3];
}

/* Node (j, k) of a triangle has the coordinates (parts - j - k, j, k) / parts. */
static batten_status fill_node(dividing *d, int triangle, int j, int k, double *point,
                               double *normal)
{
    const int i = d->parts - j - k;
    const double n = d->parts, at[3] = {i / n, j / n, k / n};
    const int degree = batten_triangles_degree(d->triangles);
    batten_vec3 found = {0, 0, 0};
    batten_status status = batten_triangles_evaluate(d->triangles, triangle, at, 0, point);
    if (status != BATTEN_OK)
        return status;
    const int corner = i == d->parts ? 0 : j == d->parts ? 1 : k == d->parts ? 2 : -1;
    if (corner >= 0)
        memcpy(point,
               batten_triangles_points(d->triangles) +
                   3 * ((size_t)triangle * BATTEN_TRIANGLE_POINTS((size_t)degree) +
                        (size_t)edge_point(degree, (corner + 2) % 3, 0)),
               3 * sizeof *point);
    else if (i == 0)
        point_of_edge(d, triangle, 0, k, point);
    else if (j == 0)
        point_of_edge(d, triangle, 1, i, point);
    else if (k == 0)
        point_of_edge(d, triangle, 2, j, point);
    status = batten_triangles_normal(d->triangles, triangle, at, NULL, &found);
    normal[0] = found.x;
    normal[1] = found.y;
    normal[2] = found.z;
    return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
}

static batten_status fill_triangle(dividing *d, int t)
{
    batten_status status = BATTEN_OK;
    size_t node = d->nodes * (size_t)t;
    for (int row = 0; status == BATTEN_OK && row <= d->parts; row++)
        for (int k = 0; status == BATTEN_OK && k <= row; k++, node++)
            status = fill_node(d, t, row - k, k, &d->points[3 * node], &d->normals[3 * node]);
    return status;
}

static batten_status fill_division(dividing *d)
{
    batten_status status = BATTEN_OK;
    for (int t = 0; status == BATTEN_OK && t < d->count; t++) {
        status = fill_triangle(d, t);
        if (status == BATTEN_OK)
            status =
                bat_work_step(&d->work, d->nodes, (double)t / d->count, "points of triangles");
    }
    return status;
}

/* ---- how many parts ---- */

/* The largest second difference of control points bounds how far a patch is from its parts:
 * each is off by n (n - 1) / 6 of it at most, over the square of the number of parts. */
static double second_difference(const batten_triangles *triangles)
{
    const int degree = batten_triangles_degree(triangles);
    const size_t each = BATTEN_TRIANGLE_POINTS((size_t)degree);
    const double *all = batten_triangles_points(triangles);
    static const int steps[3][2] = {{1, 0}, {0, 1}, {-1, 1}};
    double largest = 0;
    for (int t = 0; t < batten_triangles_count(triangles); t++) {
        const double *p = all + 3 * each * (size_t)t;
        for (int j = 0; j <= degree; j++)
            for (int k = 0; j + k <= degree; k++)
                for (int s = 0; s < 3; s++) {
                    const int j2 = j + 2 * steps[s][0], k2 = k + 2 * steps[s][1];
                    if (j2 < 0 || k2 < 0 || j2 + k2 > degree)
                        continue;
                    const double *a = p + 3 * BATTEN_TRIANGLE_POINT(j, k);
                    const double *b =
                        p + 3 * BATTEN_TRIANGLE_POINT(j + steps[s][0], k + steps[s][1]);
                    const double *c = p + 3 * BATTEN_TRIANGLE_POINT(j2, k2);
                    double square = 0;
                    for (int i = 0; i < 3; i++)
                        square = bat_hypot(square, a[i] - 2 * b[i] + c[i]);
                    largest = bat_max(largest, square);
                }
    }
    return largest;
}

/* One triangle of a division: where its nodes are, and its middle in parts from corner 0. */
typedef struct {
    size_t nodes[3];
    double j, k;
} part;

/* Number `number` of a row, which has 2 row + 1: upright ones between turned ones. */
static part part_of(const dividing *d, int t, int row, int number)
{
    const int k = number / 2;
    const size_t first = d->nodes * (size_t)t;
    const size_t a = first + (size_t)BATTEN_TRIANGLE_POINT(row - k, k);
    const size_t b = first + (size_t)BATTEN_TRIANGLE_POINT(row - k + 1, k);
    return number % 2 == 0 ? (part){{a, b, b + 1}, row - k + 1.0 / 3, k + 1.0 / 3}
                           : (part){{a, b + 1, a + 1}, row - k - 1.0 / 3, k + 2.0 / 3};
}

static batten_status measure_part(dividing *d, int t, part m, batten_mesh_report *report)
{
    const double n = d->parts, at[3] = {1 - m.j / n - m.k / n, m.j / n, m.k / n};
    double p[3], middle[3] = {0};
    const batten_status status = batten_triangles_evaluate(d->triangles, t, at, 0, p);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < 3; i++) {
        const size_t a = 3 * m.nodes[i], b = 3 * m.nodes[(i + 1) % 3];
        for (size_t c = 0; c < 3; c++)
            middle[c] += d->points[a + c] / 3;
        d->side = bat_max(d->side, bat_distance(3, d->points + a, d->points + b));
        report->angle = bat_max(report->angle, bat_angle(d->normals + a, d->normals + b));
    }
    const double off = bat_distance(3, p, middle);
    report->chord = bat_max(report->chord, off);
    report->beyond += off > d->chord;
    return BATTEN_OK;
}

/* The largest distance of the patches from the parts, at the middles of these, the largest
 * angle between normals and the longest side. */
static batten_status measure_division(dividing *d, batten_mesh_report *report)
{
    batten_status status = BATTEN_OK;
    *report = (batten_mesh_report){.asked = d->chord};
    d->side = 0;
    for (int t = 0; t < d->count; t++)
        for (int row = 0; row < d->parts; row++)
            for (int k = 0; k <= 2 * row && status == BATTEN_OK; k++)
                status = measure_part(d, t, part_of(d, t, row, k), report);
    return status;
}

static batten_status set_parts(dividing *d, double parts, int most)
{
    if (!(parts * parts * d->count <= most))
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f triangles are needed for a chord of %g and an angle of %g; %d "
                        "are allowed",
                        parts * parts * d->count, d->chord, d->angle, most);
    d->parts = (int)parts;
    d->nodes = BATTEN_TRIANGLE_POINTS((size_t)d->parts);
    return BATTEN_OK;
}

static batten_status choose_parts(dividing *d, const batten_mesh_options *o)
{
    const batten_box box = batten_triangles_box(d->triangles);
    const double size = bat_box_diagonal(box);
    const int degree = batten_triangles_degree(d->triangles);
    const batten_status status = bat_mesh_check_options(o);
    if (status != BATTEN_OK)
        return status;
    d->chord = o->chord > 0 ? o->chord : 1e-3 * size;
    d->angle = o->angle;
    d->longest = o->longest;
    d->roundoff = 8 * DBL_EPSILON * size;
    if (!(d->chord > d->roundoff))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a chord of %g is in the roundoff of size %g",
                        d->chord, size);
    const double bend = degree * (degree - 1) / 6.0 * second_difference(d->triangles);
    double parts = bat_max(ceil(sqrt(bend / d->chord)), 1);
    if (o->longest > 0)
        parts = bat_max(parts, ceil(size / o->longest));
    return set_parts(d, parts, o->most);
}

/* How many times as many parts are needed, by what was measured. */
static double excess_of(const dividing *d, const batten_mesh_report *report)
{
    const double by_side = d->longest > 0 ? (d->side - d->roundoff) / d->longest : 0;
    return bat_max(by_side, bat_max(sqrt(report->chord / d->chord), report->angle / d->angle));
}

/* Points for the parts chosen; more parts when samples say that they are needed. */
static batten_status divide(dividing *d, int most, batten_mesh_report *report)
{
    enum { ROUNDS = 6 };
    batten_status status = BATTEN_OK;
    for (int round = 0; status == BATTEN_OK; round++) {
        bat_release(d->points);
        bat_release(d->normals);
        d->points = bat_array3((size_t)d->count * d->nodes, 3, sizeof(double));
        d->normals = bat_array3((size_t)d->count * d->nodes, 3, sizeof(double));
        status = d->points && d->normals ? fill_division(d) : BATTEN_OUT_OF_MEMORY;
        if (status == BATTEN_OK)
            status = measure_division(d, report);
        const double excess = excess_of(d, report);
        if (status != BATTEN_OK || excess <= 1 || round == ROUNDS)
            break; /* a crease stays one: the report says it */
        status = set_parts(d, ceil(d->parts * bat_min(1.1 * excess, 4)), most);
    }
    return status;
}

/* ---- the mesh ---- */

static void add_triangle(const dividing *d, const size_t nodes[3], int *corners,
                         double *normals)
{
    for (int k = 0; k < 3; k++) {
        corners[k] = (int)nodes[k];
        memcpy(normals + 3 * k, d->normals + 3 * nodes[k], 3 * sizeof *normals);
    }
}

static batten_status make_mesh(const dividing *d, batten_mesh **out)
{
    const size_t all = (size_t)d->count * (size_t)d->parts * (size_t)d->parts;
    int *corners = bat_array3(all, 3, sizeof *corners);
    double *normals = bat_array3(all, 9, sizeof *normals);
    batten_mesh *soup = NULL;
    batten_status status = corners && normals ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    size_t made = 0;
    for (int t = 0; status == BATTEN_OK && t < d->count; t++)
        for (int row = 0; row < d->parts; row++)
            for (int k = 0; k <= 2 * row; k++, made++)
                add_triangle(d, part_of(d, t, row, k).nodes, corners + 3 * made,
                             normals + 9 * made);
    if (status == BATTEN_OK) {
        const batten_mesh_parts parts = {.vertex_count = (int)(d->nodes * (size_t)d->count),
                                         .points = d->points,
                                         .triangle_count = (int)made,
                                         .corners = corners,
                                         .normals = normals};
        status = batten_mesh_create(&parts, &soup);
    }
    bat_release(corners);
    bat_release(normals);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(soup, out);
    batten_mesh_unref(soup);
    return status;
}

batten_status batten_mesh_from_triangles(const batten_triangles *triangles,
                                         const batten_mesh_options *options,
                                         const batten_job *job, batten_mesh_report *report,
                                         batten_mesh **out)
{
    batten_mesh_options chosen = batten_mesh_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_mesh_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    dividing d = {.triangles = triangles,
                  .count = batten_triangles_count(triangles),
                  .work = {.job = job}};
    assert(triangles && out);
    batten_mesh_report reached;
    if (batten_triangles_dimension(triangles) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the triangles have %d dimension%s, not 3",
                        batten_triangles_dimension(triangles),
                        bat_plural(batten_triangles_dimension(triangles)));
    status = choose_parts(&d, &chosen);
    if (status != BATTEN_OK)
        return status;
    status = divide(&d, chosen.most, &reached);
    if (status == BATTEN_OK)
        status = make_mesh(&d, out);
    if (status == BATTEN_OK && report)
        *report = reached;
    bat_release(d.points);
    bat_release(d.normals);
    return status;
}
