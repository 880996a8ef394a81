#include "exchange/step/step.h"

int bat_step_point(bat_step *step, const double *point)
{
    const int id = bat_step_open(step, "CARTESIAN_POINT");
    bat_step_token(step, "'',(");
    for (int k = 0; k < 3; k++)
        bat_step_real(step, point[k], k < 2 ? "," : ")");
    bat_step_close(step);
    return id;
}

int bat_step_points(bat_step *step, const double *points, size_t count)
{
    const int first = step->count + 1;
    for (size_t i = 0; i < count; i++)
        bat_step_point(step, &points[3 * i]);
    return first;
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

static void put_curve(bat_step *step, const bat_step_row *row)
{
    bat_step_integer(step, row->degree, ",(");
    for (int i = 0; i < row->count; i++)
        bat_step_id(step, row->first_id + i * (int)row->stride, i + 1 < row->count ? "," : ")");
    bat_step_token(step, ",.UNSPECIFIED.,.F.,.F.");
}

static void put_curve_knots(bat_step *step, const bat_step_row *row)
{
    const int count = row->count + row->degree + 1;
    put_multiplicities(step, row->knots, count);
    put_distinct(step, row->knots, count);
    bat_step_token(step, ".UNSPECIFIED.");
}

/* The parts of a complex instance stand in the order of the alphabet. */
static int rational_curve(bat_step *step, const char *name, const bat_step_row *row)
{
    const int id = bat_step_open(step, "");
    bat_step_token(step, "BOUNDED_CURVE() B_SPLINE_CURVE(");
    put_curve(step, row);
    bat_step_token(step, ") B_SPLINE_CURVE_WITH_KNOTS(");
    put_curve_knots(step, row);
    bat_step_token(step, ") CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE((");
    for (int i = 0; i < row->count; i++)
        bat_step_real(step, row->weights[(size_t)i * row->stride],
                      i + 1 < row->count ? "," : "))");
    bat_step_token(step, " REPRESENTATION_ITEM(");
    bat_step_string(step, name, ")");
    bat_step_close(step);
    return id;
}

int bat_step_curve(bat_step *step, const char *name, const bat_step_row *row)
{
    if (row->weights)
        return rational_curve(step, name, row);
    const int id = bat_step_open(step, "B_SPLINE_CURVE_WITH_KNOTS");
    bat_step_string(step, name, ",");
    put_curve(step, row);
    bat_step_token(step, ",");
    put_curve_knots(step, row);
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
