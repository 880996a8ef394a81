/* Reads splines, by their poles or by points through which they go. */
#include "exchange/dxf/splines.h"
#include "base/plural.h"
#include "numeric/vector.h"

#include <batten/interpolate.h>

static batten_status read_column(const bat_dxf_pairs *pairs, int code, size_t count,
                                 double *made)
{
    double *column = NULL;
    batten_status status = bat_dxf_get_reals(pairs, code, count, &column);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        made[3 * i] = column[i];
    bat_release(column);
    return status;
}

/* Rows of x y z from three lists; a missing z is 0. The caller releases them in any case. */
static batten_status read_points(const bat_dxf_pairs *pairs, int code, size_t count,
                                 double **points)
{
    const int columns = bat_dxf_count(pairs, code + 20) == 0 ? 2 : 3;
    batten_status status = bat_input_array(pairs->input, count, 3 * sizeof **points, points);
    for (int k = 0; status == BATTEN_OK && k < columns; k++)
        status = read_column(pairs, code + 10 * k, count, *points + k);
    return status;
}

static const batten_vec3 zero = {0, 0, 0};

/* The direction that is given for an end; (0, 0, 0) says nothing. */
static batten_status read_end(const bat_dxf_pairs *pairs, int code, batten_end *end,
                              bool *is_given)
{
    batten_vec3 d;
    const batten_status status = bat_dxf_get_point(pairs, code, zero, &d);
    *is_given = status == BATTEN_OK && (d.x != 0 || d.y != 0 || d.z != 0);
    if (*is_given)
        *end = (batten_end){BATTEN_END_DIRECTION, {d.x, d.y, d.z}};
    return status;
}

/* The directions that the file gives at the ends. */
typedef struct {
    bool has_start, has_end, are_kept;
} end_directions;

/*
 * Directions at the ends have the length 1 over chord lengths as parameters: the file gives unit
 * vectors, and only their direction is sure.
 */
static batten_status read_directions(const bat_dxf_pairs *pairs,
                                     batten_curve_interpolate_options *options,
                                     end_directions *ends)
{
    batten_status status = read_end(pairs, 12, &options->start, &ends->has_start);
    if (status == BATTEN_OK)
        status = read_end(pairs, 13, &options->end, &ends->has_end);
    ends->are_kept = options->degree == 3 && (ends->has_start || ends->has_end);
    if (ends->are_kept)
        options->parameters = BATTEN_CHORD;
    else
        options->start = options->end = batten_curve_interpolate_defaults().start;
    return status;
}

static void note_interpolation(const bat_dxf_pairs *pairs, size_t count,
                               const end_directions *ends)
{
    const bool has_none = !ends->has_start && !ends->has_end;
    batten_notes_add(pairs->input->notes, pairs->input->file, pairs->line, "SPLINE",
                     "it has only %zu point%s%s; a curve was put through them%s", count,
                     bat_plural(count),
                     has_none                           ? ""
                     : ends->has_start && ends->has_end ? " and the directions at its ends"
                                                        : " and the direction at one end",
                     ends->are_kept || has_none ? "" : ", without these, as it is not cubic");
}

/* A spline that has only the points through which it goes. */
static batten_status interpolate(const bat_dxf_pairs *pairs, int degree, batten_curve **out)
{
    const size_t count = bat_dxf_count(pairs, 11);
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    end_directions ends = {false, false, false};
    double *points = NULL;
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "it has %zu point%s to go through", count,
                        bat_plural(count));
    batten_status status = read_points(pairs, 11, count, &points);
    options.degree = degree;
    options.knots_at_data = degree == 3;
    if (status == BATTEN_OK)
        status = read_directions(pairs, &options, &ends);
    if (status == BATTEN_OK)
        status = batten_curve_interpolate((batten_points){3, (int)count, points}, &options,
                                          NULL, out);
    if (status == BATTEN_OK)
        note_interpolation(pairs, count, &ends);
    bat_release(points);
    return status;
}

static batten_status read_degree(const bat_dxf_pairs *pairs, int *degree)
{
    const batten_status status = bat_dxf_get_integer(pairs, 71, 3, degree);
    if (status == BATTEN_OK && (*degree < 1 || *degree > BATTEN_MAX_DEGREE))
        return bat_fail(BATTEN_BAD_DEGREE, "its degree is %d, not in 1..%d", *degree,
                        BATTEN_MAX_DEGREE);
    return status;
}

static batten_status read_poles(const bat_dxf_pairs *pairs, int degree, size_t count,
                                batten_curve **out)
{
    double *knots = NULL, *weights = NULL, *points = NULL;
    batten_status status = bat_input_limit(pairs->input, pairs->line, count,
                                           pairs->input->limits.points, "points");
    if (status == BATTEN_OK)
        status = bat_dxf_get_reals(pairs, 40, count + (size_t)degree + 1, &knots);
    if (status == BATTEN_OK && bat_dxf_count(pairs, 41))
        status = bat_dxf_get_reals(pairs, 41, count, &weights);
    if (status == BATTEN_OK)
        status = read_points(pairs, 10, count, &points);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){3, (int)count, points}, degree, weights,
                                     knots, out);
    bat_release(knots);
    bat_release(weights);
    bat_release(points);
    return status;
}

batten_status bat_dxf_read_spline(const bat_dxf_pairs *pairs, batten_curve **out)
{
    const size_t count = bat_dxf_count(pairs, 10);
    int degree = 3;
    const batten_status status = read_degree(pairs, &degree);
    if (status != BATTEN_OK)
        return status;
    if (count == 0)
        return interpolate(pairs, degree, out);
    return read_poles(pairs, degree, count, out);
}
