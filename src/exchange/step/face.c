#include "exchange/step/step.h"

/*
 * The border of a patch, counter-clockwise in (u, v): along v = v0, u = u1, v = v1 and u = u0.
 * A border that is one point is left out. Of a closed surface two opposite borders are one
 * edge, used in both senses.
 */
enum { SOUTH, EAST, NORTH, WEST, SIDES };

typedef struct {
    double tolerance;
    bat_step_row rows[SIDES]; /* each in the direction of rising u or v */
    bool is_collapsed[SIDES];
    int edges[SIDES];    /* ids of the EDGE_CURVEs; 0 when collapsed */
    int vertices[SIDES]; /* ids at (u0, v0), (u1, v0), (u1, v1), (u0, v1) */
} border;

static const double *row_point(const bat_step_row *row, int i)
{
    return &row->points[3 * (size_t)i * row->stride];
}

static bool coincide(const double *a, const double *b, double tolerance)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]) <= tolerance;
}

static bool is_one_point(const bat_step_row *row, double tolerance)
{
    for (int i = 1; i < row->count; i++)
        if (!coincide(row_point(row, i), row_point(row, 0), tolerance))
            return false;
    return true;
}

/* Are two opposite borders the same curve? */
static bool are_same(const bat_step_row *a, const bat_step_row *b, double tolerance)
{
    for (int i = 0; i < a->count; i++) {
        const size_t k = (size_t)i * a->stride;
        if (!coincide(row_point(a, i), row_point(b, i), tolerance) ||
            (a->weights && fabs(a->weights[k] - b->weights[k]) > 1e-12 * a->weights[k]))
            return false;
    }
    return true;
}

/* The row of control points along one border. */
static bat_step_row take_row(const batten_surface *surface, int side, int first_id)
{
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    const bool along_u = side == SOUTH || side == NORTH;
    const batten_direction direction = along_u ? BATTEN_U : BATTEN_V;
    const int start = side == NORTH ? count_v - 1 : side == EAST ? (count_u - 1) * count_v : 0;
    const double *weights = batten_surface_weights(surface);
    return (bat_step_row){.degree = batten_surface_degree(surface, direction),
                          .count = along_u ? count_u : count_v,
                          .knots = batten_surface_knots(surface, direction),
                          .points = batten_surface_points(surface) + 3 * (size_t)start,
                          .weights = weights ? weights + start : NULL,
                          .stride = along_u ? (size_t)count_v : 1,
                          .first_id = first_id + start};
}

/* Corners that coincide share one vertex. */
static void put_vertices(bat_step *step, border *b)
{
    const double *corners[SIDES] = {row_point(&b->rows[SOUTH], 0), row_point(&b->rows[EAST], 0),
                                    row_point(&b->rows[NORTH], b->rows[NORTH].count - 1),
                                    row_point(&b->rows[WEST], b->rows[WEST].count - 1)};
    for (int k = 0; k < SIDES; k++) {
        for (int i = 0; i < k && !b->vertices[k]; i++)
            if (coincide(corners[k], corners[i], b->tolerance))
                b->vertices[k] = b->vertices[i];
        if (b->vertices[k])
            continue;
        const int point = bat_step_point(step, corners[k]);
        b->vertices[k] = bat_step_add(step, "VERTEX_POINT", "'',#%d", point);
    }
}

static void put_edges(bat_step *step, border *b)
{
    /* Where each border begins and ends, in the direction of its row. */
    static const int ends[SIDES][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};
    for (int side = 0; side < SIDES; side++) {
        const int opposite = (side + 2) % SIDES;
        if (b->is_collapsed[side])
            continue;
        if (opposite < side && b->edges[opposite] &&
            are_same(&b->rows[opposite], &b->rows[side], b->tolerance)) {
            b->edges[side] = b->edges[opposite];
            continue;
        }
        const int curve = bat_step_curve(step, "", &b->rows[side]);
        b->edges[side] =
            bat_step_add(step, "EDGE_CURVE", "'',#%d,#%d,#%d,.T.", b->vertices[ends[side][0]],
                         b->vertices[ends[side][1]], curve);
    }
}

static int put_loop(bat_step *step, const border *b)
{
    int uses[SIDES], count = 0;
    for (int side = 0; side < SIDES; side++)
        if (b->edges[side])
            uses[count++] = bat_step_add(step, "ORIENTED_EDGE", "'',*,*,#%d,%s", b->edges[side],
                                         side < NORTH ? ".T." : ".F.");
    if (count == 0)
        return 0;
    const int id = bat_step_open(step, "EDGE_LOOP");
    bat_step_token(step, "'',(");
    for (int k = 0; k < count; k++)
        bat_step_id(step, uses[k], k + 1 < count ? "," : ")");
    bat_step_close(step);
    return id;
}

int bat_step_face(bat_step *step, const char *name, const batten_surface *surface)
{
    border b = {.tolerance = step->tolerance};
    const size_t count = (size_t)batten_surface_point_count(surface, BATTEN_U) *
                         (size_t)batten_surface_point_count(surface, BATTEN_V);
    const int first_id = bat_step_points(step, batten_surface_points(surface), count);
    for (int side = 0; side < SIDES; side++) {
        b.rows[side] = take_row(surface, side, first_id);
        b.is_collapsed[side] = is_one_point(&b.rows[side], b.tolerance);
    }
    const int shape = bat_step_surface(step, name, surface, first_id);
    put_vertices(step, &b);
    put_edges(step, &b);
    const int loop = put_loop(step, &b);
    if (!loop)
        return 0;
    const int bound = bat_step_add(step, "FACE_OUTER_BOUND", "'',#%d,.T.", loop);
    const int id = bat_step_open(step, "ADVANCED_FACE");
    bat_step_string(step, name, ",(");
    bat_step_id(step, bound, "),");
    bat_step_id(step, shape, ",.T.");
    bat_step_close(step);
    return id;
}
