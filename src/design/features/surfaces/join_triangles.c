/* The feature 'join-triangles': two Bezier triangles with one tangent plane along their
 * edge. */
#include "base/plural.h"
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"join-triangles", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "Bezier triangles; two of them share an edge"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far the edges' control points may be apart; the tolerance of the design by default"},
};

/* All triangles of the input in one set. */
static batten_status gather(const bat_run *run, batten_triangles **out)
{
    bat_objects objects;
    batten_triangles *all = NULL;
    batten_status status = bat_gather(run, "join-triangles", BAT_TRIANGLES, &objects);
    if (status != BATTEN_OK)
        return status;
    all = batten_triangles_ref(objects.at[0]->triangles);
    for (int i = 1; i < objects.count && status == BATTEN_OK; i++) {
        batten_triangles *more = NULL;
        status = batten_triangles_together(all, objects.at[i]->triangles, &more);
        if (status == BATTEN_OK) {
            batten_triangles_unref(all);
            all = more;
        }
    }
    bat_objects_release(&objects);
    if (status == BATTEN_OK)
        *out = all;
    else
        batten_triangles_unref(all);
    return status;
}

/* The one edge that two triangles share. */
static batten_status find_edge(const batten_triangles *all, double within,
                               batten_triangle_join *out)
{
    batten_triangle_joins joins = {0, NULL};
    batten_status status = batten_triangles_joins(all, within, &joins);
    if (status != BATTEN_OK)
        return status;
    if (joins.count == 1)
        *out = joins.at[0];
    else
        status = bat_fail(BATTEN_NOT_COMPATIBLE,
                          "%d edges are shared; one edge between two triangles is made smooth",
                          joins.count);
    batten_triangle_joins_release(&joins);
    return status;
}

static batten_status run_join_triangles(bat_run *run)
{
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_triangles *all = NULL, *joined = NULL;
    batten_triangle_join edge = {{0}, {0}, false, 0, 0, 0, 0};
    double moved = 0;
    batten_status status = gather(run, &all);
    if (status == BATTEN_OK)
        status = find_edge(all, within, &edge);
    if (status == BATTEN_OK)
        status = batten_triangles_join_tangents(
            all, (batten_triangle_edge){edge.triangle[0], edge.edge[0]},
            (batten_triangle_edge){edge.triangle[1], edge.edge[1]}, within, &moved, &joined);
    if (status == BATTEN_OK)
        bat_remark(
            run,
            "normals turned by %.3g degree%s at most; control points of triangle %d moved "
            "by up to %g",
            edge.angle * 180 / BAT_PI, bat_plural_real(edge.angle * 180 / BAT_PI, 3),
            edge.triangle[1] + 1, moved);
    batten_triangles_unref(all);
    return bat_put_triangles(run, status, joined);
}

const bat_feature bat_feature_join_triangles = {
    .shown =
        {"join-triangles", "Two Bezier triangles with one tangent plane along their edge",
         "The first of them stays as it is. In the second the points next to the shared edge move,\n"
         "so that its derivative across the edge becomes a blend of that of the first and of that\n"
         "along the edge; where both already share a tangent plane at the corners, these tangents\n"
         "stay. The result is one degree higher.",
         "features:\n"
         "  low: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
         "  high: {points: [[2, 2, -1], [2, 1, 0], [1, 2, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
         "  a: {bezier-triangle: low}\n"
         "  b: {bezier-triangle: high}\n"
         "  both: {join-triangles: [a, b]}\n",
         "[Farin02]", "batten_triangles_join_tangents", BAT_PARAMETERS(parameters), false,
         .also = "G1 join of triangles, smooth edge",
         .formula =
             "    D2 = α(t) D1 + β(t) C′ along the edge C: the derivative across it in the second from that in the first",
         .promise = "One tangent plane along the edge."},
    .run = run_join_triangles};
