/* Triangles side by side: control points that make the joint smooth. */
#include "numeric/vector.h"
#include "spline/triangles/triangles.h"

#include <float.h>
#include <string.h>

static double twice_area(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

void bat_triangle_barycentric(const double *vertices, const int corners[3], const double p[2],
                              double b[3])
{
    const double *v[3];
    for (int e = 0; e < 3; e++)
        v[e] = vertices + 2 * corners[e];
    const double whole = twice_area(v[0], v[1], v[2]);
    for (int e = 0; e < 3; e++)
        b[e] = twice_area(p, v[(e + 1) % 3], v[(e + 2) % 3]) / whole;
    for (int e = 0; e < 3; e++)
        if (p[0] == v[e][0] && p[1] == v[e][1])
            for (int c = 0; c < 3; c++)
                b[c] = c == e;
}

/* A set with the same control points, to be changed and finished. */
static batten_status copy_of(const batten_triangles *triangles, batten_triangles **out)
{
    const bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    const batten_status status = bat_triangles_make(&shape, out);
    if (status != BATTEN_OK)
        return status;
    const size_t total = (size_t)triangles->count * triangles->net_count;
    memcpy((*out)->points, triangles->points,
           total * (size_t)triangles->dimension * sizeof(double));
    bat_triangles_copy_domain(triangles, *out);
    return BATTEN_OK;
}

/* Put a control point elsewhere and note how far it went. */
static void move_point(batten_triangles *made, int triangle, int at, const double *to,
                       double *longest)
{
    const size_t d = (size_t)made->dimension;
    double *point = made->points + ((size_t)triangle * made->net_count + (size_t)at) * d;
    *longest = bat_max(*longest, bat_distance((int)d, point, to));
    memcpy(point, to, d * sizeof *to);
}

/* ---- equal derivatives in the plane of the domain ---- */

/* The edge of triangle t that it shares with another; -1 when there is none. */
static int shared_edge(const batten_triangles *triangles, int t, int other)
{
    int edge = -1, shared = 0;
    for (int e = 0; e < 3; e++) {
        bool there = false;
        for (int c = 0; c < 3; c++)
            there |= triangles->corners[3 * t + e] == triangles->corners[3 * other + c];
        shared += there;
        if (!there)
            edge = e;
    }
    return shared == 2 ? edge : -1;
}

static batten_status check_smooth_join(const batten_triangles *triangles, int keep, int change,
                                       int order)
{
    if (triangles->weights || !triangles->vertex_count)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "derivatives are made equal for polynomial triangles over a domain");
    if (order < 0 || order > triangles->degree)
        return bat_fail(BATTEN_BAD_ARGUMENT, "order %d is not in 0..%d", order,
                        triangles->degree);
    if (keep == change || shared_edge(triangles, change, keep) < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "triangles %d and %d share no edge", keep + 1,
                        change + 1);
    return BATTEN_OK;
}

batten_status batten_triangles_join_smoothly(const batten_triangles *triangles, int keep,
                                             int change, int order, double *moved,
                                             batten_triangles **out)
{
    assert(triangles && out && keep >= 0 && keep < triangles->count && change >= 0 &&
           change < triangles->count);
    batten_status status = check_smooth_join(triangles, keep, change, order);
    if (status != BATTEN_OK)
        return status;
    const int n = triangles->degree, edge = shared_edge(triangles, change, keep);
    const size_t d = (size_t)triangles->dimension, size = triangles->net_count * d;
    double corners[3][3], longest = 0;
    for (int e = 0; e < 3; e++)
        bat_triangle_barycentric(triangles->vertices, triangles->corners + 3 * keep,
                                 triangles->vertices + 2 * triangles->corners[3 * change + e],
                                 corners[e]);

    double *work = bat_array(4 * size, sizeof *work);
    batten_triangles *made = NULL;
    status = work ? copy_of(triangles, &made) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_triangle_sub(n, d, bat_triangle_net(triangles, keep), corners, work + size, work);
        for (int r = 0; r <= order; r++)
            for (int s = 0; s <= n - r; s++) {
                const int at = bat_triangle_at(n, edge, r, s);
                move_point(made, change, at, work + (size_t)at * d, &longest);
            }
        status = bat_triangles_finish(made, out);
    }
    bat_release(work);
    if (status == BATTEN_OK && moved)
        *moved = longest;
    return status;
}

/* ---- equal tangent planes ---- */

/* Two edges seen along the first: the changed triangle's may run the other way. */
typedef struct {
    int kept, edge_kept, changed, edge_changed;
    bool same_way;
} seam;

/* Point s of row r of the changed triangle, s counted along the edge of the kept one. */
static int changed_at(const seam *joint, int degree, int r, int s)
{
    return bat_triangle_at(degree, joint->edge_changed, r,
                           joint->same_way ? s : degree - r - s);
}

static const double *point_of(const batten_triangles *triangles, int triangle, int at)
{
    return triangles->points + ((size_t)triangle * triangles->net_count + (size_t)at) *
                                   (size_t)triangles->dimension;
}

/* How far the control points of both edges are apart, at most. */
static double edge_gap(const batten_triangles *triangles, const seam *joint)
{
    const int n = triangles->degree;
    double gap = 0;
    for (int s = 0; s <= n; s++)
        gap = bat_max(
            gap, bat_distance(triangles->dimension,
                              point_of(triangles, joint->kept,
                                       bat_triangle_at(n, joint->edge_kept, 0, s)),
                              point_of(triangles, joint->changed, changed_at(joint, n, 0, s))));
    return gap;
}

/* At place s = 0 .. n - 1: D across the kept triangle, E along the edge. */
static void frame_at(const batten_triangles *triangles, const seam *joint, int s, double D[3],
                     double E[3])
{
    const int n = triangles->degree, e = joint->edge_kept;
    const double *here = point_of(triangles, joint->kept, bat_triangle_at(n, e, 0, s));
    const double *next = point_of(triangles, joint->kept, bat_triangle_at(n, e, 0, s + 1));
    const double *inner = point_of(triangles, joint->kept, bat_triangle_at(n, e, 1, s));
    for (int c = 0; c < 3; c++) {
        D[c] = inner[c] - here[c];
        E[c] = next[c] - here[c];
    }
}

/* k and h at one end, s = 0 or n - 1, so that k D + h E is as near as can be to the tangent of
 * the changed triangle. */
static batten_status solve_end(const batten_triangles *triangles, const seam *joint, int s,
                               double kh[2])
{
    const int n = triangles->degree;
    const double *here =
        point_of(triangles, joint->kept, bat_triangle_at(n, joint->edge_kept, 0, s));
    const double *inner = point_of(triangles, joint->changed, changed_at(joint, n, 1, s));
    double D[3], E[3], X[3];
    frame_at(triangles, joint, s, D, E);
    for (int c = 0; c < 3; c++)
        X[c] = inner[c] - here[c];
    const double dd = bat_dot(3, D, D), de = bat_dot(3, D, E), ee = bat_dot(3, E, E);
    const double det = dd * ee - de * de;
    if (!(det > 64 * DBL_EPSILON * dd * ee))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "triangle %d has no tangent plane at one end of edge %d",
                        joint->kept + 1, joint->edge_kept + 1);
    const double dx = bat_dot(3, D, X), ex = bat_dot(3, E, X);
    kh[0] = (ee * dx - de * ex) / det;
    kh[1] = (dd * ex - de * dx) / det;
    if (kh[0] < 0)
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "triangle %d folds back over triangle %d at one end of the edge",
                    joint->changed + 1, joint->kept + 1);
}

/* The rows 0 and 1 of the changed triangle of `made`, which is elevated by one. */
static void fill_seam(const batten_triangles *triangles, const seam *joint,
                      const double start[2], const double end[2], batten_triangles *made,
                      double *longest)
{
    const int n = triangles->degree, N = n + 1;
    for (int s = 0; s <= N; s++) {
        const double *edge =
            point_of(made, joint->kept, bat_triangle_at(N, joint->edge_kept, 0, s));
        double to[3], D[3] = {0}, E[3] = {0}, before_D[3] = {0}, before_E[3] = {0};
        if (s < n)
            frame_at(triangles, joint, s, D, E);
        if (s > 0 && s <= n)
            frame_at(triangles, joint, s - 1, before_D, before_E);
        for (int c = 0; c < 3; c++)
            to[c] = edge[c] + ((n - s) * (start[0] * D[c] + start[1] * E[c]) +
                               s * (end[0] * before_D[c] + end[1] * before_E[c])) /
                                  N;
        move_point(made, joint->changed, changed_at(joint, N, 0, s), edge, longest);
        if (s <= n)
            move_point(made, joint->changed, changed_at(joint, N, 1, s), to, longest);
    }
}

batten_status batten_triangles_join_tangents(const batten_triangles *triangles,
                                             batten_triangle_edge kept,
                                             batten_triangle_edge changed, double tolerance,
                                             double *moved, batten_triangles **out)
{
    assert(triangles && out && kept.triangle >= 0 && kept.triangle < triangles->count &&
           changed.triangle >= 0 && changed.triangle < triangles->count && kept.edge >= 0 &&
           kept.edge < 3 && changed.edge >= 0 && changed.edge < 3);
    if (triangles->weights || triangles->dimension < 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "tangent planes are made equal for polynomial triangles in space");
    seam joint = {kept.triangle, kept.edge, changed.triangle, changed.edge, false};
    double gap = edge_gap(triangles, &joint);
    if (!(gap <= tolerance)) {
        joint.same_way = true;
        gap = bat_min(gap, edge_gap(triangles, &joint));
    }
    if (kept.triangle == changed.triangle || !(gap <= tolerance))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "edge %d of triangle %d and edge %d of triangle %d are %g apart",
                        kept.edge + 1, kept.triangle + 1, changed.edge + 1,
                        changed.triangle + 1, gap);
    double start[2], end[2], longest = 0;
    batten_triangles *elevated = NULL, *made = NULL;
    batten_status status = solve_end(triangles, &joint, 0, start);
    if (status == BATTEN_OK)
        status = solve_end(triangles, &joint, triangles->degree - 1, end);
    if (status == BATTEN_OK)
        status = batten_triangles_elevate(triangles, 1, &elevated);
    if (status == BATTEN_OK)
        status = copy_of(elevated, &made);
    if (status == BATTEN_OK) {
        fill_seam(triangles, &joint, start, end, made, &longest);
        status = bat_triangles_finish(made, out);
    }
    batten_triangles_unref(elevated);
    if (status == BATTEN_OK && moved)
        *moved = longest;
    return status;
}
