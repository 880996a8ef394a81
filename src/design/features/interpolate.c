#include "design/place.h"
#include "design/rows.h"

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
     "the curve closes smoothly; the first point is not repeated"},
};

static batten_interpolate_options options_of(const bat_run *run)
{
    batten_interpolate_options options = batten_interpolate_defaults();
    const int where = bat_word(run, "knots");
    options.degree = bat_count(run, "degree");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.knots_at_data = where == KNOTS_AUTO ? options.degree == 3 : where == KNOTS_AT_DATA;
    options.start = bat_end(run, "start", "start-vector");
    options.end = bat_end(run, "end", "end-vector");
    options.periodic = bat_yes(run, "periodic");
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

static batten_status fit_row(bat_run *run, const bat_row *row, const batten_object *from)
{
    batten_curve *curve = NULL;
    double *parameters_of = bat_array((size_t)row->count, sizeof *parameters_of);
    if (!parameters_of)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curve_interpolate(
        3, row->count, row->points, &run->result->fit, parameters_of, &curve);
    const batten_object like = {.name = row->name,
                                .layer = from->layer,
                                .point_count = row->count,
                                .points = row->points,
                                .parameters = parameters_of};
    const batten_status put = bat_put_curve_like(run, status, curve, &like, true);
    bat_release(parameters_of);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return put;
    return bat_fail(status, "%s: %s", row->name, batten_message());
}

static batten_status fit_object(bat_run *run, const batten_object *object)
{
    bat_rows rows = {0, NULL};
    const bool lines = bat_word(run, "each") == EACH_LINE;
    batten_status status = bat_rows_of(object, lines, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++) {
        if (rows.rows[i].count >= 2)
            status = fit_row(run, &rows.rows[i], object);
        else if (rows.rows[i].count == 1 && !lines && object->kind == BATTEN_OBJECT_OFFSETS)
            status = fit_point(run, &rows.rows[i], object);
        else
            bat_note(run, "'%s' has %d points and is left out; a curve needs 2",
                     rows.rows[i].name, rows.rows[i].count);
    }
    bat_rows_release(&rows);
    return status;
}

static batten_status run(bat_run *run)
{
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
         "Through each station or line of a table of offsets, or through each row of "
         "points. Cubics\n"
         "have their knots at the data and need a condition at both ends: 'ends', or "
         "'start' and\n"
         "'end'; 'clamped', 'second' and 'curvature' take their vector from "
         "'start-vector' and\n"
         "'end-vector', 'direction' only its direction. Stations with a single point "
         "become\n"
         "curves that stay there, in which a skin can end. The curves keep their points for "
         "'fair'\n"
         "and 'check'.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  sheer: {interpolate: ducks, parameters: chord, ends: natural}\n",
         "[PT97]", "batten_curve_interpolate", BAT_PARAMETERS(parameters), false},
    .run = run};
