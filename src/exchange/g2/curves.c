/* Curves of .g2 files: splines, and lines and conics with their ranges. */
#include "exchange/g2/g2.h"
#include "numeric/vector.h"

#include <batten/standard.h>
#include <string.h>

batten_status bat_g2_divide_weights(bat_words *words, int dimension, size_t count,
                                    double *points, double **weights)
{
    double *w = NULL;
    batten_status status = bat_input_array(words->input, count, sizeof *w, &w);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        const double *from = &points[i * (size_t)(dimension + 1)];
        w[i] = from[dimension];
        if (!(w[i] > 0))
            status = bat_input_fail(words->input, BATTEN_BAD_WEIGHT, words->line,
                                    "weight %zu is %g", i + 1, w[i]);
        for (int k = 0; status == BATTEN_OK && k < dimension; k++)
            points[i * (size_t)dimension + (size_t)k] = from[k] / w[i];
    }
    if (status == BATTEN_OK)
        *weights = w;
    else
        bat_release(w);
    return status;
}

batten_status bat_g2_read_axis(bat_words *words, batten_axis *axis, double **knots)
{
    int order = 0;
    batten_status status = bat_words_integer(
        words, "the number of points", 1, bat_g2_most_points(words->input), &axis->point_count);
    if (status == BATTEN_OK)
        status = bat_words_integer(words, "the order", 2, BATTEN_MAX_DEGREE + 1, &order);
    axis->degree = order - 1;
    if (status == BATTEN_OK)
        status =
            bat_words_reals(words, "knots", (size_t)axis->point_count + (size_t)order, knots);
    axis->knots = *knots;
    return status;
}

static batten_status read_spline(bat_words *words, batten_curve **out)
{
    int dimension = 0, rational = 0;
    double *knots = NULL, *points = NULL, *weights = NULL;
    batten_axis axis = {0};
    batten_status status = bat_words_integer(words, "the dimension", 1, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_words_integer(words, "the sign of a rational curve", 0, 1, &rational);
    if (status == BATTEN_OK)
        status = bat_g2_read_axis(words, &axis, &knots);
    if (status == BATTEN_OK)
        status =
            bat_words_reals(words, "coordinates",
                            (size_t)axis.point_count * (size_t)(dimension + rational), &points);
    if (status == BATTEN_OK && rational)
        status =
            bat_g2_divide_weights(words, dimension, (size_t)axis.point_count, points, &weights);
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){dimension, axis.point_count, points},
                                     axis.degree, weights, knots, out);
    bat_release(knots);
    bat_release(points);
    bat_release(weights);
    return status;
}

batten_status bat_g2_read_range(bat_words *words, bool alone, batten_interval standard,
                                batten_interval *range, bool *is_backwards)
{
    *range = standard;
    *is_backwards = false;
    if (alone && bat_g2_is_at_end(words))
        return BATTEN_OK;
    batten_status status = bat_words_real(words, "the start of a range", &range->a);
    if (status == BATTEN_OK)
        status = bat_words_real(words, "the end of a range", &range->b);
    if (status == BATTEN_OK && range->b < range->a) {
        batten_notes_add(words->input->notes, words->input->file, words->line, "",
                         "a range runs backwards, from %g to %g", range->a, range->b);
        *range = (batten_interval){range->b, range->a};
        *is_backwards = true;
    }
    if (status == BATTEN_OK && !(range->b > range->a))
        status = bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                                "the range %g..%g is empty", range->a, range->b);
    return status;
}

/* The mark of newer files that the direction is turned; older ones have none. */
static batten_status read_turned(bat_words *words, bool alone, bool *turned)
{
    int value = 0;
    *turned = false;
    if (alone && bat_g2_is_at_end(words))
        return BATTEN_OK;
    batten_status status = bat_words_integer(words, "the mark of a turned curve", 0, 1, &value);
    *turned = value == 1;
    return status;
}

batten_status bat_g2_read_vector(bat_words *words, const char *what, int count,
                                 batten_vec3 *out)
{
    double v[3] = {0, 0, 0};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = bat_words_real(words, what, &v[k]);
    *out = (batten_vec3){v[0], v[1], v[2]};
    return status;
}

batten_status bat_g2_make_frame(const bat_words *words, batten_frame *frame)
{
    const double length = bat_vec3_norm(frame->z);
    const batten_vec3 z = bat_vec3_scale(frame->z, 1 / length);
    const batten_vec3 x = bat_vec3_along(frame->x, -bat_vec3_dot(frame->x, z), z);
    const double across = bat_vec3_norm(x);
    if (!(length > 0 && across > BAT_WRITTEN * bat_vec3_norm(frame->x)))
        return bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                              "the axes of the object are 0 or parallel");
    frame->z = z;
    frame->x = bat_vec3_scale(x, 1 / across);
    return BATTEN_OK;
}

static batten_status finish_curve(batten_status status, bool turned, int dimension,
                                  batten_curve *space, batten_curve **out)
{
    batten_curve *way = NULL;
    if (status == BATTEN_OK && turned)
        status = batten_curve_reverse(space, &way);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(way ? way : space, dimension, out);
    batten_curve_unref(way);
    batten_curve_unref(space);
    return status;
}

static batten_status read_line(bat_words *words, bool alone, batten_curve **out)
{
    int dimension = 0, bounded = 0;
    batten_vec3 point = {0, 0, 0}, way = {0, 0, 0};
    batten_interval range = {0, 1};
    bool turned = false, backwards = false;
    batten_curve *line = NULL;
    batten_status status = bat_words_integer(words, "the dimension", 2, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the point of a line", dimension, &point);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the direction of a line", dimension, &way);
    if (status == BATTEN_OK && !(alone && bat_g2_is_at_end(words)))
        status = bat_words_integer(words, "the mark of a bounded line", 0, 1, &bounded);
    if (status == BATTEN_OK && !bounded)
        return bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                              "the line has no ends");
    if (status == BATTEN_OK)
        status = bat_g2_read_range(words, false, range, &range, &backwards);
    if (status == BATTEN_OK)
        status = read_turned(words, alone, &turned);
    if (status == BATTEN_OK) {
        const batten_vec3 a = bat_vec3_along(point, range.a, way);
        const batten_vec3 b = bat_vec3_along(point, range.b, way);
        status =
            batten_curve_line(3, (double[]){a.x, a.y, a.z}, (double[]){b.x, b.y, b.z}, &line);
    }
    return finish_curve(status, turned != backwards, dimension, line, out);
}

/* Circles have one radius, ellipses two. In the plane there is no normal. */
static batten_status read_ellipse(bat_words *words, bool alone, bool is_circle,
                                  batten_curve **out)
{
    int dimension = 0;
    double a = 0, b = 0;
    batten_frame frame = batten_frame_world();
    batten_interval range;
    bool turned = false, backwards = false;
    batten_curve *space = NULL;
    batten_status status = bat_words_integer(words, "the dimension", 2, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_words_real(words, "a radius", &a);
    b = a;
    if (status == BATTEN_OK && !is_circle)
        status = bat_words_real(words, "a radius", &b);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the centre", dimension, &frame.origin);
    if (status == BATTEN_OK && dimension == 3)
        status = bat_g2_read_vector(words, "the normal", 3, &frame.z);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the direction of the x-axis", dimension, &frame.x);
    if (status == BATTEN_OK)
        status = bat_g2_read_range(words, alone, (batten_interval){0, 2 * BAT_PI}, &range,
                                   &backwards);
    if (status == BATTEN_OK)
        status = read_turned(words, alone, &turned);
    if (status == BATTEN_OK)
        status = bat_g2_make_frame(words, &frame);
    if (status == BATTEN_OK) {
        const bat_conic conic = {BAT_ELLIPSE, frame, a, b};
        status =
            bat_conic_between(&conic, range.a, bat_min(range.b, range.a + 2 * BAT_PI), &space);
    }
    return finish_curve(status, turned != backwards, dimension, space, out);
}

batten_status bat_g2_read_curve(bat_words *words, int class, bool alone, batten_curve **out)
{
    switch (class) {
    case BAT_G2_CURVE:
        return read_spline(words, out);
    case BAT_G2_LINE:
        return read_line(words, alone, out);
    case BAT_G2_CIRCLE:
    case BAT_G2_ELLIPSE:
        return read_ellipse(words, alone, class == BAT_G2_CIRCLE, out);
    default:
        return bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                              "curves of class %d are not read", class);
    }
}
