/* Writes points, placements, curves and surfaces as instances. */
#include "base/real.h"
#include "exchange/step/step.h"

#include <string.h>

/* A whole instance at once: that is less than 120 columns, and most of a file. */
int bat_step_point(bat_step *step, int dimension, const double *point)
{
    static const char keyword[] = "=CARTESIAN_POINT('',(";
    char line[BAT_INTEGER_SIZE + sizeof keyword + 3 * BAT_REAL_SIZE + 8] = "#";
    size_t length = 1 + (size_t)bat_integer_write(++step->count, line + 1);
    memcpy(line + length, keyword, sizeof keyword - 1);
    length += sizeof keyword - 1;
    for (int k = 0; k < dimension; k++) {
        length += (size_t)bat_real_write(point[k], line + length);
        line[length++] = k + 1 < dimension ? ',' : ')';
    }
    batten_text_bytes(step->text, line, length);
    bat_step_close(step);
    return step->count;
}

int bat_step_points(bat_step *step, int dimension, const double *points, size_t count)
{
    const int first = step->count + 1;
    for (size_t i = 0; i < count; i++)
        bat_step_point(step, dimension, &points[(size_t)dimension * i]);
    return first;
}

static int put_direction(bat_step *step, const double direction[3])
{
    const int id = bat_step_open(step, "DIRECTION");
    bat_step_token(step, "'',(");
    for (int i = 0; i < 3; i++)
        bat_step_real(step, direction[i], i < 2 ? "," : ")");
    bat_step_close(step);
    return id;
}

int bat_step_placement(bat_step *step, const double origin[3], const double z[3],
                       const double x[3])
{
    const int at = bat_step_point(step, 3, origin);
    const int along = put_direction(step, z), across = put_direction(step, x);
    return bat_step_add(step, "AXIS2_PLACEMENT_3D", "'',#%d,#%d,#%d", at, along, across);
}

/* The end of the run of equal knots that begins at i. */
static int end_of_run(const double *knots, int count, int i)
{
    int end = i + 1;
    while (end < count && knots[end] == knots[i])
        end++;
    return end;
}

static void put_multiplicities(bat_step *step, const double *knots, int count)
{
    bat_step_token(step, "(");
    for (int i = 0, end; i < count; i = end) {
        end = end_of_run(knots, count, i);
        bat_step_integer(step, end - i, end < count ? "," : "),");
    }
}

static void put_distinct(bat_step *step, const double *knots, int count)
{
    bat_step_token(step, "(");
    for (int i = 0, end; i < count; i = end) {
        end = end_of_run(knots, count, i);
        bat_step_real(step, knots[i], end < count ? "," : "),");
    }
}

/* ---- curves ---- */

static void put_curve(bat_step *step, const batten_curve *curve, const bat_step_row *row)
{
    const int count = batten_curve_point_count(curve);
    bat_step_integer(step, batten_curve_degree(curve), ",(");
    for (int i = 0; i < count; i++)
        bat_step_id(step, row->first + i * row->step, i + 1 < count ? "," : ")");
    bat_step_token(step, ",.UNSPECIFIED.,.F.,.F.");
}

static void put_curve_knots(bat_step *step, const batten_curve *curve)
{
    const double *knots = batten_curve_knots(curve);
    const int count = batten_curve_knot_count(curve);
    put_multiplicities(step, knots, count);
    put_distinct(step, knots, count);
    bat_step_token(step, ".UNSPECIFIED.");
}

/* The parts of a complex instance stand in the order of the alphabet. */
static int rational_curve(bat_step *step, const char *name, const batten_curve *curve,
                          const bat_step_row *row)
{
    const double *weights = batten_curve_weights(curve);
    const int count = batten_curve_point_count(curve), id = bat_step_open(step, "");
    bat_step_token(step, "BOUNDED_CURVE() B_SPLINE_CURVE(");
    put_curve(step, curve, row);
    bat_step_token(step, ") B_SPLINE_CURVE_WITH_KNOTS(");
    put_curve_knots(step, curve);
    bat_step_token(step, ") CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE((");
    for (int i = 0; i < count; i++)
        bat_step_real(step, weights[i], i + 1 < count ? "," : "))");
    bat_step_token(step, " REPRESENTATION_ITEM(");
    bat_step_string(step, name, ")");
    bat_step_close(step);
    return id;
}

int bat_step_curve(bat_step *step, const char *name, const batten_curve *curve,
                   const bat_step_row *row)
{
    bat_step_row own = {0, 1};
    if (!row) {
        own.first =
            bat_step_points(step, batten_curve_dimension(curve), batten_curve_points(curve),
                            (size_t)batten_curve_point_count(curve));
        row = &own;
    }
    if (batten_curve_is_rational(curve))
        return rational_curve(step, name, curve, row);
    const int id = bat_step_open(step, "B_SPLINE_CURVE_WITH_KNOTS");
    bat_step_string(step, name, ",");
    put_curve(step, curve, row);
    bat_step_token(step, ",");
    put_curve_knots(step, curve);
    bat_step_close(step);
    return id;
}

/* ---- surfaces ---- */

/* What follows item (i, j) in a list of rows. */
static const char *after_item(const batten_surface *surface, int i, int j)
{
    if (j + 1 < batten_surface_point_count(surface, BATTEN_V))
        return ",";
    return i + 1 < batten_surface_point_count(surface, BATTEN_U) ? "),(" : "))";
}

static void put_surface(bat_step *step, const batten_surface *surface, int first_id)
{
    const int count_u = batten_surface_point_count(surface, BATTEN_U);
    const int count_v = batten_surface_point_count(surface, BATTEN_V);
    bat_step_integer(step, batten_surface_degree(surface, BATTEN_U), ",");
    bat_step_integer(step, batten_surface_degree(surface, BATTEN_V), ",((");
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++)
            bat_step_id(step, first_id + i * count_v + j, after_item(surface, i, j));
    bat_step_token(step, ",.UNSPECIFIED.,.F.,.F.,.F.");
}

static void put_surface_knots(bat_step *step, const batten_surface *surface)
{
    const double *u = batten_surface_knots(surface, BATTEN_U);
    const double *v = batten_surface_knots(surface, BATTEN_V);
    const int count_u = batten_surface_knot_count(surface, BATTEN_U);
    const int count_v = batten_surface_knot_count(surface, BATTEN_V);
    put_multiplicities(step, u, count_u);
    put_multiplicities(step, v, count_v);
    put_distinct(step, u, count_u);
    put_distinct(step, v, count_v);
    bat_step_token(step, ".UNSPECIFIED.");
}

static void put_weights(bat_step *step, const batten_surface *surface)
{
    const double *weights = batten_surface_weights(surface);
    bat_step_token(step, "((");
    for (int i = 0; i < batten_surface_point_count(surface, BATTEN_U); i++)
        for (int j = 0; j < batten_surface_point_count(surface, BATTEN_V); j++)
            bat_step_real(step, *weights++, after_item(surface, i, j));
}

static int rational_surface(bat_step *step, const char *name, const batten_surface *surface,
                            int first_id)
{
    const int id = bat_step_open(step, "");
    bat_step_token(step, "BOUNDED_SURFACE() B_SPLINE_SURFACE(");
    put_surface(step, surface, first_id);
    bat_step_token(step, ") B_SPLINE_SURFACE_WITH_KNOTS(");
    put_surface_knots(step, surface);
    bat_step_token(step, ") GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_SURFACE(");
    put_weights(step, surface);
    bat_step_token(step, ") REPRESENTATION_ITEM(");
    bat_step_string(step, name, ") SURFACE()");
    bat_step_close(step);
    return id;
}

int bat_step_surface(bat_step *step, const char *name, const batten_surface *surface,
                     int first_id)
{
    if (batten_surface_is_rational(surface))
        return rational_surface(step, name, surface, first_id);
    const int id = bat_step_open(step, "B_SPLINE_SURFACE_WITH_KNOTS");
    bat_step_string(step, name, ",");
    put_surface(step, surface, first_id);
    bat_step_token(step, ",");
    put_surface_knots(step, surface);
    bat_step_close(step);
    return id;
}
