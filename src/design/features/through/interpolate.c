/* The feature 'interpolate': the cubic spline, or one of another degree, through points. */
#include "base/plural.h"
#include "design/shared/place.h"
#include "design/shared/through.h"

#include <batten/measure.h>
#include <batten/standard.h>
#include <float.h>
#include <stdio.h>
#include <string.h>

typedef enum { EACH_STATION, EACH_LINE, EACH_ROW } each;
typedef enum { KNOTS_AUTO, KNOTS_AT_DATA, KNOTS_AVERAGED } knots;

static const batten_parameter parameters[] = {
    {"interpolate", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"each", BATTEN_VALUE_WORD, false, false, "station", "station line row",
     "of a table: one curve through each of these"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the points"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "of the curves"},
    {"knots", BATTEN_VALUE_WORD, false, false, "auto", "auto data averaged",
     "where the knots are: at the data for cubics, else averaged"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds at both ends"},
    {"start", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS, "what holds at the start"},
    {"start-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative, direction or curvature at the start"},
    {"end", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS, "what holds at the end"},
    {"end-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative, direction or curvature at the end"},
    {"periodic", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the curve closes smoothly; the first point is not repeated, but that of a function is"},
    BAT_AS,
};

static batten_curve_interpolate_options options_of(const bat_run *run)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    const int where = bat_word(run, "knots");
    options.degree = bat_count(run, "degree");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.knots_at_data = where == KNOTS_AUTO ? options.degree == 3 : where == KNOTS_AT_DATA;
    options.start = bat_end(run, "start", "start-vector");
    options.end = bat_end(run, "end", "end-vector");
    options.closed = bat_yes(run, "periodic");
    return options;
}

/* A section of one point, as where the stem ends, is a curve that stays there. */
static batten_status fit_point(bat_run *run, const bat_row *row, const batten_object *from)
{
    batten_curve *curve = NULL;
    double parameter = 0;
    const batten_status status = batten_curve_line(3, row->points, row->points, &curve);
    const batten_object like = {.name = row->name,
                                .layer = from->layer,
                                .point_count = 1,
                                .points = row->points,
                                .parameters = &parameter};
    return bat_put_curve_like(run, status, curve, &like, true);
}

/* How far curves reach beyond their points, and which does so most for its size. */
typedef struct {
    const char *name;
    double reach, part; /* as a length, and of the size of the points */
    int count;          /* of curves that go far */
} excursion;

/* How far a box reaches beyond the points, and the size of the points. */
static double reach_beyond(const bat_row *row, batten_box box, double *size)
{
    const double low[] = {box.low.x, box.low.y, box.low.z},
                 high[] = {box.high.x, box.high.y, box.high.z};
    double reach = 0;
    *size = 0;
    for (int k = 0; k < 3; k++) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int i = 0; i < row->count; i++) {
            least = fmin(least, row->points[3 * i + k]);
            most = fmax(most, row->points[3 * i + k]);
        }
        *size = fmax(*size, most - least);
        reach = fmax(reach, fmax(least - low[k], high[k] - most));
    }
    return reach;
}

/* A table of offsets ends at keel, deck and side: a smooth curve goes a little beyond its
 * points where it turns, and a tenth at corners. The control points, which enclose the curve,
 * are asked first: the curve itself costs several times its construction. */
static batten_status look_beyond(const bat_row *row, const batten_curve *curve, excursion *e)
{
    static const double far = 0.03;
    batten_box box = batten_curve_box(curve);
    double size = 0;
    if (reach_beyond(row, box, &size) <= far * size)
        return BATTEN_OK;
    const batten_status status = batten_curve_bounds(curve, &box);
    if (status != BATTEN_OK)
        return status;
    const double reach = reach_beyond(row, box, &size);
    e->count += reach > far * size;
    if (reach > far * size && reach > e->part * size)
        *e = (excursion){row->name, reach, reach / size, e->count};
    return BATTEN_OK;
}

static void note_excursion(const bat_run *run, const excursion *e)
{
    if (e->count > 0)
        bat_note(
            run,
            "%d of the curves %s more than 3 %% of their size beyond their points, '%s' by "
            "%.3g, %.0f %%; where the table has corners, 'cornered-spline' keeps them",
            e->count, bat_one_or_many(e->count, "goes", "go"), e->name, e->reach,
            100 * e->part);
}

static batten_status fit_row(bat_run *run, const bat_row *row, const batten_object *from,
                             excursion *e)
{
    batten_curve *curve = NULL;
    double *parameters_of = bat_array((size_t)row->count, sizeof *parameters_of);
    if (!parameters_of)
        return BATTEN_OUT_OF_MEMORY;
    bat_note_spacing(run, row->name, row->count, row->points);
    const batten_status status = batten_curve_interpolate(
        (batten_points){3, row->count, row->points}, &run->result->fit, parameters_of, &curve);
    /* Points that are no table may go where they like. */
    const bool is_table = from->kind == BATTEN_OBJECT_OFFSET_TABLE;
    const batten_status looked =
        status == BATTEN_OK && is_table ? look_beyond(row, curve, e) : BATTEN_OK;
    const batten_object like = {.name = row->name,
                                .layer = from->layer,
                                .point_count = row->count,
                                .points = row->points,
                                .parameters = parameters_of};
    const batten_status put = bat_put_curve_like(run, status, curve, &like, true);
    bat_release(parameters_of);
    if (looked != BATTEN_OK)
        return looked;
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return put;
    return bat_fail(status, "%s: %s", row->name, batten_message());
}

static batten_status fit_object(bat_run *run, const batten_object *object)
{
    excursion e = {.count = 0};
    bat_rows rows = {0, NULL};
    const bool lines = bat_word(run, "each") == EACH_LINE;
    batten_status status = bat_rows_of(object, lines, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++) {
        if (rows.rows[i].count >= 2)
            status = fit_row(run, &rows.rows[i], object, &e);
        else if (rows.rows[i].count == 1 && !lines &&
                 object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            status = fit_point(run, &rows.rows[i], object);
        else
            bat_note(run, "'%s' has %d point%s and is left out; a curve needs 2",
                     rows.rows[i].name, rows.rows[i].count, bat_plural(rows.rows[i].count));
    }
    if (status == BATTEN_OK)
        note_excursion(run, &e);
    bat_rows_release(&rows);
    return status;
}

/* ---- functions ---- */

/* The first point at which the curve bends to the other side than its points, or -1. */
static batten_status find_bend(const bat_data *data, int sign, const batten_curve *curve,
                               int *at)
{
    const double *x = data->abscissae;
    double *second = bat_array((size_t)data->count, sizeof *second);
    double bend = 0, size = 0, step = HUGE_VAL;
    batten_status status = second ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < data->count && status == BATTEN_OK; i++) {
        double out[3];
        status = batten_curve_evaluate(curve, x[i], 2, out);
        if (status != BATTEN_OK)
            break;
        second[i] = sign * out[2];
        bend = fmax(bend, fabs(out[2]));
        size = fmax(size, fabs(data->points[i]));
        step = i > 0 ? fmin(step, x[i] - x[i - 1]) : step;
    }
    *at = -1;
    /* Second derivatives are differences of differences of the values. */
    const double zero = 64 * DBL_EPSILON * (bend + size / step / step);
    for (int i = 0; i < data->count && status == BATTEN_OK && *at < 0; i++)
        if (second[i] < -zero)
            *at = i;
    bat_release(second);
    return status;
}

static batten_status note_convexity(bat_run *run, const bat_data *data,
                                    const batten_curve_interpolate_options *options,
                                    const batten_curve *curve)
{
    const double *x = data->abscissae, *y = data->points;
    batten_convexity found;
    batten_status status =
        batten_spline_convexity(data->count, x, y, &options->start, &options->end, &found);
    const bool known = status != BATTEN_BAD_ARGUMENT; /* of these ends */
    if (!known)
        status = batten_spline_convexity(data->count, x, y, NULL, NULL, &found);
    int at = -1;
    if (status == BATTEN_OK && found.points != 0)
        status = find_bend(data, found.points, curve, &at);
    if (status != BATTEN_OK || at < 0)
        return status;
    char because[64] = "";
    if (known && found.at >= 0)
        snprintf(because, sizeof because, " because point %d stands out", found.at + 1);
    bat_note(run,
             "'%s': its points are %s, but the curve bends back at point %d%s; 'tension' with "
             "'rule: convex' does not",
             data->name, found.points > 0 ? "convex" : "concave", at + 1, because);
    return BATTEN_OK;
}

/* A periodic function ends as high as it begins. */
static batten_status check_period(const bat_data *data)
{
    const double first = data->points[0], last = data->points[data->count - 1];
    if (fabs(last - first) <= 8 * DBL_EPSILON * fmax(fabs(first), fabs(last)))
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "a periodic function ends with the value it begins with; these are %g and "
                    "%g",
                    last, first);
}

static batten_status make_function(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_interpolate_options options = options_of(run);
    options.parameters = BATTEN_GIVEN;
    options.given = data->abscissae;
    memcpy(made->parameters, data->abscissae, (size_t)data->count * sizeof *made->parameters);
    batten_status status = options.closed ? check_period(data) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = batten_curve_interpolate(
            (batten_points){1, data->count - options.closed, data->points}, &options, NULL,
            &made->curve);
    if (status == BATTEN_OK && options.knots_at_data && options.degree == 3 && !options.closed)
        status = note_convexity(run, data, &options, made->curve);
    return status;
}

/* ---- the whole ---- */

static batten_status run_interpolate(bat_run *run)
{
    enum { FUNCTION = 1 };
    static const bat_method function = {2, BAT_AS_FUNCTION, make_function};
    if (bat_word(run, "as") == FUNCTION)
        return bat_through(run, &function);
    bat_objects objects;
    batten_status status = bat_gather(run, "interpolate", BAT_POINTS | BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    run->result->fit = options_of(run);
    run->result->has_fit = true;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = fit_object(run, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_interpolate = {
    .shown =
        {"interpolate", "The cubic spline, or one of another degree, through points",
         "Through each station or line of a table of offsets, or through each row of points.\n"
         "Cubics have their knots at the data and need a condition at both ends: 'ends', or\n"
         "'start' and 'end'; 'clamped', 'second' and 'curvature' take their vector from\n"
         "'start-vector' and 'end-vector', 'direction' only its direction. Stations with a single\n"
         "point become curves that stay at that point, in which a skin can end. A note says where\n"
         "the curves of a table swing far beyond their points, as at corners. The curves keep\n"
         "their points for 'fair' and 'check'. 'as: function' gives a spline function of the first\n"
         "coordinate, whose end vectors are slopes or second derivatives (the first number\n"
         "counts); a note says where it bends back though its points do not.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  sheer: {interpolate: ducks, parameters: chord, ends: natural}\n",
         "[SL section II.1] [SL section III.6] [SL section I.5] [SL section VII.4] [PT97 section 9.2]",
         "batten_curve_interpolate", BAT_PARAMETERS(parameters), false,
         .also =
             "cubic spline, parametric spline, cumulative chord length, centripetal parametrisation, Foley-Nielson, Ferguson curve, not-a-knot, natural spline, periodic spline, inversion of a B-spline, through points",
         .formula =
             "    S(t_i) = P_i,  t_{i+1} − t_i = |P_{i+1} − P_i|^e  (e = 1 cumulative chord, 1/2 centripetal, 0 uniform)\n"
             "    degree 3, h_i = t_{i+1} − t_i, M_i = S″(t_i), d_i = (P_{i+1} − P_i)/h_i:\n"
             "    h_{i−1} M_{i−1} + 2 (h_{i−1} + h_i) M_i + h_i M_{i+1} = 6 (d_i − d_{i−1})",
         .promise =
             "Of all curves with S(t_i) = P_i the cubic with natural ends has the least ∫ |S″|² dt; its second derivative is continuous."},
    .run = run_interpolate};
