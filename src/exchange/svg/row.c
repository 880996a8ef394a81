/* Rows of Bezier pieces: lines, quadratics and arcs are raised to cubics, which is exact. */
#include "exchange/svg/path_data.h"

#include <batten/standard.h>

void bat_svg_row_begin(bat_svg_row *row, bat_input *input)
{
    *row = (bat_svg_row){.input = input, .points = {.size = 3 * sizeof(double)}};
}

void bat_svg_row_end(bat_svg_row *row)
{
    bat_release(row->points.items);
    row->points = (bat_list){.size = 3 * sizeof(double)};
}

static batten_status put_point(bat_svg_row *row, double x, double y, double weight)
{
    const double point[3] = {x, y, weight};
    row->x = x;
    row->y = y;
    return bat_list_add(row->input, &row->points, point);
}

batten_status bat_svg_move(bat_svg_row *row, double x, double y)
{
    row->points.count = 0;
    row->has_curves = row->has_weights = false;
    return put_point(row, x, y, 1);
}

/* Weighted control points of a piece of degree 2 with end weights 1, raised to degree 3. */
batten_status bat_svg_quadratic(bat_svg_row *row, const double middle[2], double weight,
                                const double end[2])
{
    const double w = (1 + 2 * weight) / 3, x = row->x, y = row->y;
    const double mx = 2 * weight * middle[0], my = 2 * weight * middle[1];
    batten_status status = put_point(row, (x + mx) / (3 * w), (y + my) / (3 * w), w);
    if (status == BATTEN_OK)
        status = put_point(row, (mx + end[0]) / (3 * w), (my + end[1]) / (3 * w), w);
    if (status == BATTEN_OK)
        status = put_point(row, end[0], end[1], 1);
    row->has_curves = true;
    row->has_weights |= weight != 1;
    return status;
}

batten_status bat_svg_cubic(bat_svg_row *row, const double one[2], const double two[2],
                            const double end[2])
{
    batten_status status = put_point(row, one[0], one[1], 1);
    if (status == BATTEN_OK)
        status = put_point(row, two[0], two[1], 1);
    if (status == BATTEN_OK)
        status = put_point(row, end[0], end[1], 1);
    row->has_curves = true;
    return status;
}

/* A line of no length is no piece. */
batten_status bat_svg_line(bat_svg_row *row, double x, double y)
{
    const double from[2] = {row->x, row->y};
    if (x == from[0] && y == from[1])
        return BATTEN_OK;
    batten_status status =
        put_point(row, from[0] + (x - from[0]) / 3, from[1] + (y - from[1]) / 3, 1);
    if (status == BATTEN_OK)
        status =
            put_point(row, from[0] + 2 * (x - from[0]) / 3, from[1] + 2 * (y - from[1]) / 3, 1);
    return status == BATTEN_OK ? put_point(row, x, y, 1) : status;
}

/* ---- arcs ---- */

/* An ellipse by its centre: a point at the angle t is the centre + R (rx cos t, ry sin t). */
typedef struct {
    double cx, cy, rx, ry, cosine, sine;
} ellipse;

static void at(const ellipse *e, double t, double far, double point[2])
{
    const double x = far * e->rx * bat_cos(t), y = far * e->ry * bat_sin(t);
    point[0] = e->cx + e->cosine * x - e->sine * y;
    point[1] = e->cy + e->sine * x + e->cosine * y;
}

/* From the angle `start` on by `angle`, in pieces of a quarter at most, to the point (x, y). */
static batten_status put_arc(bat_svg_row *row, const ellipse *e, double start, double angle,
                             double x, double y)
{
    const int pieces = 1 + (int)(fabs(angle) / (BAT_PI / 2) - 1e-9);
    const double step = angle / pieces;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < pieces; i++) {
        double middle[2], end[2] = {x, y};
        at(e, start + (i + 0.5) * step, 1 / bat_cos(step / 2), middle);
        if (i + 1 < pieces)
            at(e, start + (i + 1) * step, 1, end);
        status = bat_svg_quadratic(row, middle, bat_cos(step / 2), end);
    }
    return status;
}

static double turn_of_sweep(double turn, bool sweep)
{
    if (sweep && turn <= 0)
        return turn + 2 * BAT_PI;
    if (!sweep && turn >= 0)
        return turn - 2 * BAT_PI;
    return turn;
}

/* Half axes too small to reach the ends grow until they do. */
static void grow_to_ends(ellipse *e, double px, double py)
{
    const double reach = bat_hypot(px / e->rx, py / e->ry);
    if (reach > 1) {
        e->rx *= reach;
        e->ry *= reach;
    }
}

/* From the ends to the centre: the way of the standard, SVG 1.1, F.6.5. */
batten_status bat_svg_arc(bat_svg_row *row, double rx, double ry, double angle, bool large,
                          bool sweep, double x, double y)
{
    ellipse e = {.rx = fabs(rx), .ry = fabs(ry)};
    if (x == row->x && y == row->y)
        return BATTEN_OK;
    if (!(e.rx > 0 && e.ry > 0))
        return bat_svg_line(row, x, y);
    e.cosine = bat_cos(angle * BAT_PI / 180);
    e.sine = bat_sin(angle * BAT_PI / 180);
    const double dx = (row->x - x) / 2, dy = (row->y - y) / 2;
    const double px = e.cosine * dx + e.sine * dy, py = -e.sine * dx + e.cosine * dy;
    grow_to_ends(&e, px, py);
    const double ux = px / e.rx, uy = py / e.ry, u = bat_hypot(ux, uy);
    const double side = (large == sweep ? -1 : 1) * sqrt(bat_max(0, 1 - u * u)) / u;
    const double qx = side * e.rx * uy, qy = -side * e.ry * ux;
    e.cx = e.cosine * qx - e.sine * qy + (row->x + x) / 2;
    e.cy = e.sine * qx + e.cosine * qy + (row->y + y) / 2;
    const double start = bat_atan2((py - qy) / e.ry, (px - qx) / e.rx);
    double turn = bat_atan2((-py - qy) / e.ry, (-px - qx) / e.rx) - start;
    if (!isfinite(turn))
        return bat_fail(BATTEN_BAD_FORMAT,
                        "its arc with the half axes %g and %g to (%g, %g) cannot be computed: "
                        "their sizes lie too far apart",
                        rx, ry, x, y);
    turn = turn_of_sweep(turn, sweep);
    return put_arc(row, &e, start, turn, x, y);
}

/* ---- */

bat_svg_map bat_svg_compose(bat_svg_map first, bat_svg_map then)
{
    return (bat_svg_map){
        .a = then.a * first.a + then.c * first.b,
        .b = then.b * first.a + then.d * first.b,
        .c = then.a * first.c + then.c * first.d,
        .d = then.b * first.c + then.d * first.d,
        .e = then.a * first.e + then.c * first.f + then.e,
        .f = then.b * first.e + then.d * first.f + then.f,
    };
}

/* The weights stand apart. */
static void map_points(const bat_svg_row *row, const bat_svg_map *map, int count,
                       double *points, double *weights)
{
    const double(*from)[3] = row->points.items;
    const int step = row->has_curves ? 1 : 3;
    for (int i = 0; i < count; i++) {
        const double *p = from[step * i];
        points[2 * i] = map->a * p[0] + map->c * p[1] + map->e;
        points[2 * i + 1] = map->b * p[0] + map->d * p[1] + map->f;
        weights[i] = p[2];
    }
}

batten_status bat_svg_curve(const bat_svg_row *row, const bat_svg_map *map, batten_curve **out)
{
    const int pieces = (int)((row->points.count - 1) / 3);
    const int count = row->has_curves ? 3 * pieces + 1 : pieces + 1;
    if (pieces == 0)
        return BATTEN_OK;
    double *points = bat_array3((size_t)count, 2, sizeof *points);
    double *weights = bat_array((size_t)count, sizeof *weights);
    double *breaks = bat_array((size_t)pieces + 1, sizeof *breaks);
    batten_status status = points && weights && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        map_points(row, map, count, points, weights);
    for (int i = 0; status == BATTEN_OK && i <= pieces; i++)
        breaks[i] = i;
    if (status == BATTEN_OK && row->has_curves)
        status = batten_curve_from_bezier(2, (batten_pieces){3, pieces, breaks}, points,
                                          row->has_weights ? weights : NULL, out);
    else if (status == BATTEN_OK)
        status = batten_curve_polyline((batten_points){2, count, points}, out);
    bat_release(points);
    bat_release(weights);
    bat_release(breaks);
    return status;
}
