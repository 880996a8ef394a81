/* Makes a path of lines and arcs of the curves of an object. */
#include "exchange/shapes/path.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"
#include <batten/arcs.h>

#include <float.h>

/* Into how many parts an arc is cut, so that none is more than a half circle. */
static int parts_of(const batten_span *span)
{
    const double turns = fabs(span->curvature[0]) * span->length / BAT_PI;
    return (int)bat_max(1, ceil(turns * (1 - 1e-12)));
}

static batten_status check_turns(const batten_chain *chain, int *vertices)
{
    double sum = 0;
    for (int i = 0; i < batten_chain_span_count(chain); i++) {
        const batten_span *span = batten_chain_span(chain, i);
        const double turns = fabs(span->curvature[0]) * span->length / BAT_PI;
        /* Capped, so that the sum stays small enough for an int. */
        sum += turns < 1e6 ? parts_of(span) : 1e6;
    }
    if (sum >= 1e7)
        return bat_fail(BATTEN_TOO_LARGE, "a path of %.0f vertices", sum);
    *vertices = (int)sum;
    return BATTEN_OK;
}

/* The vertices of one span, without the last point. */
static void add_span(const batten_span *span, bat_path *path)
{
    const int parts = parts_of(span);
    const double k = span->curvature[0], step = span->length / parts;
    for (int i = 0; i < parts; i++) {
        double at[2];
        bat_arc_at(span, i * step, at);
        path->vertices[path->count++] = (bat_vertex){at[0], at[1], bat_tan(k * step / 4)};
    }
}

/* An arc that is beside its chord by the rounding of coordinates has no radius to speak of. */
static void straighten(bat_path *path)
{
    for (int i = 0; i + 1 < path->count + path->closed; i++) {
        bat_vertex *a = &path->vertices[i];
        const bat_vertex *b = &path->vertices[(i + 1) % path->count];
        const double largest =
            bat_max(bat_max(fabs(a->x), fabs(a->y)), bat_max(fabs(b->x), fabs(b->y)));
        if (bat_path_sagitta(a, b->x, b->y) <= 4 * DBL_EPSILON * largest)
            a->bulge = 0;
    }
}

static batten_status path_of_chain(const batten_chain *chain, bat_path *out)
{
    int count = 0;
    bat_path path = {.closed = batten_chain_is_closed(chain), .frame = batten_frame_world()};
    batten_status status = check_turns(chain, &count);
    if (status != BATTEN_OK)
        return status;
    path.vertices = bat_array((size_t)count + 1, sizeof *path.vertices);
    if (!path.vertices)
        return BATTEN_OUT_OF_MEMORY;
    batten_chain_frame(chain, &path.frame);
    for (int i = 0; i < batten_chain_span_count(chain); i++)
        add_span(batten_chain_span(chain, i), &path);
    /* The end of an open chain, in the plane: seen from a chain that was not placed. */
    const batten_span *last = batten_chain_span(chain, batten_chain_span_count(chain) - 1);
    double end[2];
    bat_arc_at(last, last->length, end);
    if (!path.closed)
        path.vertices[path.count++] = (bat_vertex){end[0], end[1], 0};
    straighten(&path);
    *out = path;
    return BATTEN_OK;
}

/* The height z that all points share; false when they do not. */
static bool level(const batten_curve *curve, double *z)
{
    const int d = batten_curve_dimension(curve);
    const double *P = batten_curve_points(curve);
    *z = d == 3 ? P[2] : 0;
    for (int i = 0; d == 3 && i < batten_curve_point_count(curve); i++)
        if (P[3 * i + 2] != *z)
            return false;
    return d >= 2;
}

static batten_status path_of_polyline(const batten_curve *curve, double z, bat_path *out)
{
    const int d = batten_curve_dimension(curve), n = batten_curve_point_count(curve);
    const double *P = batten_curve_points(curve);
    bat_path path = {.frame = batten_frame_world()};
    path.frame.origin.z = z;
    path.vertices = bat_array((size_t)n, sizeof *path.vertices);
    if (!path.vertices)
        return BATTEN_OUT_OF_MEMORY;
    path.closed = n > 3 && bat_distance(2, P, P + (size_t)(n - 1) * (size_t)d) == 0;
    path.count = path.closed ? n - 1 : n;
    for (int i = 0; i < path.count; i++)
        path.vertices[i] = (bat_vertex){P[i * d], P[i * d + 1], 0};
    *out = path;
    return BATTEN_OK;
}

batten_status bat_path_of(const batten_object *object, bool *is_path, bat_path *out)
{
    double z = 0;
    *is_path = true;
    if (object->chain && batten_chain_is_arcs(object->chain))
        return path_of_chain(object->chain, out);
    if (object->curve && batten_curve_degree(object->curve) == 1 &&
        batten_curve_is_clamped(object->curve) && level(object->curve, &z))
        return path_of_polyline(object->curve, z, out);
    batten_chain *exact = NULL;
    batten_status status = BATTEN_OK;
    if (object->curve && !object->chain)
        status = batten_arcs_from_curve_exact(object->curve, &exact);
    *is_path = exact != NULL;
    if (status == BATTEN_OK && exact)
        status = path_of_chain(exact, out);
    batten_chain_unref(exact);
    return status;
}

void bat_path_release(bat_path *path)
{
    bat_release(path->vertices);
    *path = (bat_path){0};
}

double bat_path_sagitta(const bat_vertex *from, double x, double y)
{
    return fabs(from->bulge) * (bat_hypot(x - from->x, y - from->y) / 2);
}

void bat_path_centre(const bat_vertex *from, double x, double y, double *cx, double *cy,
                     double *radius)
{
    const double b = from->bulge, dx = x - from->x, dy = y - from->y;
    /* From the middle of the chord to the left by (1 - b^2) / (4 b) chords. */
    const double left = (1 - b * b) / (4 * b);
    *cx = from->x + dx / 2 - left * dy;
    *cy = from->y + dy / 2 + left * dx;
    *radius = bat_hypot(dx, dy) * (1 + b * b) / (4 * fabs(b));
}
