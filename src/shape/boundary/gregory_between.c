/* Gregory patches between cubic curves. */
#include "numeric/vector.h"
#include <batten/fill.h>
#include <stdio.h>
#include <string.h>

/* ---- the field across an edge ---- */

typedef struct {
    batten_vec3 along, across, g; /* at one end; g of length one, across the edge */
    double k, h;                  /* across = k g + h along */
} field_end;

static batten_status look_at_end(batten_vec3 along, const double *across, const double *normal,
                                 int number, field_end *out)
{
    const double speed = bat_vec3_norm(along);
    if (!(speed > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the edge has no direction at its %s",
                        number == 0 ? "start" : "end");
    out->along = along;
    out->across = bat_vec3_of(3, across);
    const batten_vec3 n = normal ? bat_vec3_of(3, normal) : bat_vec3_cross(out->across, along);
    const batten_vec3 g = bat_vec3_cross(along, n);
    const double size = bat_vec3_norm(g), a = bat_vec3_norm(out->across);
    if (!isfinite(size) || !isfinite(a * speed * speed))
        return bat_fail(BATTEN_OVERFLOW,
                        "the edge is too large: products of its derivatives are beyond all "
                        "numbers at its %s",
                        number == 0 ? "start" : "end");
    /* Sines: unit normals come from cross products of derivatives, of ten digits at best. */
    if (!(size > 1e-10 * speed * bat_vec3_norm(n)) ||
        !(bat_vec3_norm(bat_vec3_cross(out->across, along)) > 1e-10 * speed * a))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the derivative across runs along the edge at its %s",
                        number == 0 ? "start" : "end");
    out->g = bat_vec3_scale(g, 1 / size);
    out->k = bat_vec3_dot(out->across, out->g);
    out->h = bat_vec3_dot(out->across, along) / (speed * speed);
    return BATTEN_OK;
}

static void put_point(batten_vec3 a, double *out)
{
    out[0] = a.x;
    out[1] = a.y;
    out[2] = a.z;
}

/* The linear factors k and h times the quadratic g and C', in Bezier form. */
static void fill_field(const field_end *start, const field_end *end, batten_vec3 g1,
                       batten_vec3 c1, double *field)
{
    batten_vec3 a = bat_vec3_scale(g1, 2 * start->k / 3);
    a = bat_vec3_along(a, end->k / 3, start->g);
    a = bat_vec3_along(a, 2 * start->h / 3, c1);
    a = bat_vec3_along(a, end->h / 3, start->along);
    batten_vec3 b = bat_vec3_scale(end->g, start->k / 3);
    b = bat_vec3_along(b, 2 * end->k / 3, g1);
    b = bat_vec3_along(b, start->h / 3, end->along);
    b = bat_vec3_along(b, 2 * end->h / 3, c1);
    put_point(start->across, field);
    put_point(a, field + 3);
    put_point(b, field + 6);
    put_point(end->across, field + 9);
}

batten_status batten_gregory_field(const double *edge, const double *across,
                                   const double *normals, double *field)
{
    batten_vec3 c[3];
    field_end ends[2];
    if (bat_first_not_finite(edge, 12) < 12 || bat_first_not_finite(across, 6) < 6)
        return bat_fail(BATTEN_NOT_FINITE, "a number of the edge or across it is not finite");
    for (int i = 0; i < 3; i++)
        c[i] = bat_vec3_scale(
            bat_vec3_subtract(bat_vec3_of(3, edge + 3 * i + 3), bat_vec3_of(3, edge + 3 * i)),
            3);
    batten_status status = look_at_end(c[0], across, normals, 0, &ends[0]);
    if (status == BATTEN_OK)
        status = look_at_end(c[2], across + 3, normals ? normals + 3 : NULL, 1, &ends[1]);
    if (status != BATTEN_OK)
        return status;
    if (ends[0].k * ends[1].k < 0)
        return bat_fail(
            BATTEN_NOT_COMPATIBLE,
            "the derivatives across lie on different sides of the edge at its ends");
    const batten_vec3 sum = bat_vec3_add(ends[0].g, ends[1].g);
    /* Of unit vectors; nearer to opposite, the direction between them has ten digits at most. */
    if (!(bat_vec3_norm(sum) > 1e-6))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the planes at the ends of the edge are turned by half a turn: divide "
                        "the edge");
    fill_field(&ends[0], &ends[1], bat_vec3_scale(sum, 0.5), c[1], field);
    return BATTEN_OK;
}

/* ---- between curves ---- */

/* The sides in order and direction of the loop, corners closed. */
typedef struct {
    int count;
    int given[4];
    double P[4][4][3];
} cubics;

static batten_status take_cubic(const batten_curve *curve, int number, bool reversed,
                                double P[4][3])
{
    if (batten_curve_dimension(curve) != 3 || batten_curve_is_rational(curve) ||
        batten_curve_degree(curve) > 3 || batten_curve_spans(curve, NULL) != 2)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "curve %d has dimension %d, degree %d and %d spans%s: sides of a "
                        "Gregory patch are single cubics in space",
                        number + 1, batten_curve_dimension(curve), batten_curve_degree(curve),
                        batten_curve_spans(curve, NULL) - 1,
                        batten_curve_is_rational(curve) ? ", and is rational" : "");
    batten_curve *raised = NULL, *bezier = NULL;
    batten_status status = batten_curve_elevate(curve, 3 - batten_curve_degree(curve), &raised);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(raised, &bezier);
    for (int i = 0; status == BATTEN_OK && i < 4; i++)
        memcpy(P[i], batten_curve_points(bezier) + 3 * (reversed ? 3 - i : i), sizeof P[i]);
    batten_curve_unref(bezier);
    batten_curve_unref(raised);
    return status;
}

static batten_status take_cubics(int count, const batten_curve *const *curves,
                                 const batten_loop_place *places, cubics *out)
{
    batten_status status = BATTEN_OK;
    out->count = count;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        out->given[i] = places[i].curve;
        status =
            take_cubic(curves[places[i].curve], places[i].curve, places[i].reversed, out->P[i]);
    }
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        for (int c = 0; c < 3; c++) {
            double *end = &out->P[i][3][c], *start = &out->P[(i + 1) % count][0][c];
            *end = *start = *end / 2 + *start / 2;
        }
    return status;
}

/* The field of side i, given the derivatives across at its ends. */
static batten_status field_of(const cubics *all, int i, const double across[2][3],
                              double field[4][3])
{
    const batten_status status = batten_gregory_field(all->P[i][0], across[0], NULL, field[0]);
    if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_OK)
        return status;
    char why[300];
    snprintf(why, sizeof why, "%s", batten_message());
    return bat_fail(status, "side %d, curve %d: %s", i + 1, all->given[i] + 1, why);
}

/* Point k of side i seen in the net of the square, sides being v = 0, u = 1, v = 1 and u = 0 as
 * the loop runs. */
static void place_in_square(int side, int k, int *i, int *j)
{
    *i = side == 0 ? k : side == 1 ? 3 : side == 2 ? 3 - k : 0;
    *j = side == 0 ? 0 : side == 1 ? k : side == 2 ? 3 : 3 - k;
}

static batten_status between_four(const cubics *all, batten_surface **out)
{
    double points[4][4][3] = {{{0}}}, inner[2][2][2][3];
    for (int side = 0; side < 4; side++) {
        const int before = (side + 3) % 4, next = (side + 1) % 4;
        double across[2][3], field[4][3];
        for (int c = 0; c < 3; c++) { /* into the patch, along the sides beside */
            across[0][c] = 3 * (all->P[before][2][c] - all->P[side][0][c]);
            across[1][c] = 3 * (all->P[next][1][c] - all->P[side][3][c]);
        }
        const batten_status status = field_of(all, side, (const double(*)[3])across, field);
        if (status != BATTEN_OK)
            return status;
        for (int k = 0; k < 3; k++) {
            int i, j;
            place_in_square(side, k, &i, &j);
            memcpy(points[i][j], all->P[side][k], sizeof points[i][j]);
        }
        for (int k = 1; k < 3; k++) {
            int i, j;
            place_in_square(side, k, &i, &j);
            const int a = side == 1 ? 1 : side == 3 ? 0 : i - 1;
            const int b = side == 0 ? 0 : side == 2 ? 1 : j - 1;
            for (int c = 0; c < 3; c++)
                inner[a][b][side % 2][c] = all->P[side][k][c] + field[k][c] / 3;
        }
    }
    return batten_surface_gregory(points[0][0], inner[0][0][0], out);
}

static batten_status between_three(const cubics *all, batten_surface **out)
{
    double edges[3][5][3], inner[3][2][3];
    for (int e = 0; e < 3; e++)
        for (int k = 0; k < 5; k++)
            for (int c = 0; c < 3; c++)
                edges[e][k][c] = ((k > 0 ? k * all->P[e][k - 1][c] : 0) +
                                  (k < 4 ? (4 - k) * all->P[e][k][c] : 0)) /
                                 4;
    for (int e = 0; e < 3; e++) {
        const int before = (e + 2) % 3, next = (e + 1) % 3;
        double across[2][3], field[4][3];
        /* The transversal goes from the middle of the edge to the corner across: its derivative
         * is 4 (r_i - (E_i + E_i+1) / 2), r_i being the next row of points. */
        for (int c = 0; c < 3; c++) {
            across[0][c] = 4 * (edges[before][3][c] - (edges[e][0][c] + edges[e][1][c]) / 2);
            across[1][c] = 4 * (edges[next][1][c] - (edges[e][3][c] + edges[e][4][c]) / 2);
        }
        const batten_status status = field_of(all, e, (const double(*)[3])across, field);
        if (status != BATTEN_OK)
            return status;
        for (int k = 1; k < 3; k++) /* beside corner e, and beside the next */
            for (int c = 0; c < 3; c++)
                inner[k == 1 ? e : next][k - 1][c] =
                    (edges[e][k][c] + edges[e][k + 1][c]) / 2 + field[k][c] / 4;
    }
    return batten_surface_gregory_triangle(edges[0][0], inner[0][0], out);
}

batten_status batten_surface_gregory_between(int count, const batten_curve *const *curves,
                                             double tolerance, batten_loop_place *places,
                                             batten_surface **out)
{
    batten_loop_place found[4];
    cubics all = {0};
    if (count != 3 && count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a Gregory patch has 3 or 4 sides, not %d; fills have up to 8", count);
    batten_status status = batten_curves_loop(count, curves, tolerance, found);
    if (status == BATTEN_OK)
        status = take_cubics(count, curves, found, &all);
    if (status == BATTEN_OK)
        status = count == 3 ? between_three(&all, out) : between_four(&all, out);
    if (status == BATTEN_OK && places)
        memcpy(places, found, (size_t)count * sizeof *places);
    return status;
}
