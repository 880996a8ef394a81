/* The feature 'thin-points': fewer points, none of the others farther than a bound. */
#include "design/shared/rows.h"
#include "design/shared/through.h"
#include <batten/approximate.h>
#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"thin-points", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "points, tables of offsets, or polylines"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "how far a removed point may lie from the chord that takes its place"},
    {"closed", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "of points: the last is followed by the first, which is not repeated"},
    BAT_EACH,
};

/* The points of [of][3] that stay; release them. */
static batten_status thin(bat_run *run, const char *name, int of, const double *all,
                          bool closed, double **points, int *count)
{
    batten_points_thin_report report;
    int *kept = bat_array((size_t)of, sizeof *kept);
    double *made = bat_array3((size_t)of, 3, sizeof *made);
    batten_status status = kept && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_points_thin((batten_points){3, of, all}, bat_number(run, "within"),
                                    closed, &report, kept, count);
    for (int i = 0; status == BATTEN_OK && i < 3 * *count; i++)
        made[i] = all[3 * kept[i / 3] + i % 3];
    bat_release(kept);
    if (status != BATTEN_OK) {
        bat_release(made);
        return status == BATTEN_OUT_OF_MEMORY
                   ? status
                   : bat_fail(status, "%s: %s", name, batten_message());
    }
    bat_remark(run, "'%s': %d of %d points stay", name, *count, of);
    bat_report_error(run, report.error, report.rms);
    *points = made;
    return BATTEN_OK;
}

static batten_status thin_row(bat_run *run, const batten_object *from, const bat_row *row)
{
    double *points = NULL;
    int count = 0;
    batten_status status =
        thin(run, row->name, row->count, row->points, bat_yes(run, "closed"), &points, &count);
    const batten_object made = {.name = row->name,
                                .layer = from->layer,
                                .kind = BATTEN_OBJECT_POINTS,
                                .point_count = count,
                                .points = points};
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    bat_release(points);
    return status;
}

static batten_status thin_rows(bat_run *run, const batten_object *object)
{
    enum { LINE = 1 };
    bat_rows rows = {0, NULL};
    batten_status status = bat_rows_of(object, bat_word(run, "each") == LINE, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++)
        if (rows.rows[i].count > 0)
            status = thin_row(run, object, &rows.rows[i]);
    bat_rows_release(&rows);
    return status;
}

static batten_status thin_polyline(bat_run *run, const batten_object *object)
{
    batten_curve *space = NULL, *made = NULL;
    double *points = NULL;
    int count = 0;
    if (batten_curve_degree(object->curve) != 1 || batten_curve_is_rational(object->curve))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "'%s' is not a polyline; simplify curves with 'remove-knots'",
                        object->name);
    batten_status status = batten_curve_to_dimension(object->curve, 3, &space);
    if (status == BATTEN_OK)
        status = thin(run, object->name, batten_curve_point_count(space),
                      batten_curve_points(space), false, &points, &count);
    if (status == BATTEN_OK)
        status = batten_curve_polyline((batten_points){3, count, points}, &made);
    bat_release(points);
    batten_curve_unref(space);
    return bat_put_curve_like(run, status, made, object, false);
}

static batten_status thin_object(bat_run *run, const batten_object *object)
{
    return object->curve ? thin_polyline(run, object) : thin_rows(run, object);
}

static batten_status run_thin_points(bat_run *run)
{
    return bat_for_objects(run, "thin-points", BAT_POINTS | BAT_OFFSETS | BAT_CURVES,
                           thin_object);
}

const bat_feature bat_feature_thin_points = {
    .shown =
        {"thin-points", "Fewer points, none of the others farther than a bound",
         "For digitised outlines, scans and long polylines: of the points on a straight or nearly\n"
         "straight run only the ends stay. Each point that is removed lies within 'within' of the\n"
         "chord between its neighbours that stay. This bounds the points, not the chords: where a\n"
         "row runs to and fro, a chord may cut a corner by more. Ends and corners stay, for a row\n"
         "is split where it is farthest from its chord. How many stay is noted. Of a table each\n"
         "station, or line, becomes a row of points. For curved shapes 'fit-within' needs fewer\n"
         "control points still; curves that are not polylines are refused; simplify them with\n"
         "'remove-knots'.",
         "features:\n"
         "  scan: {points: [[0, 0], [1 m, 1 mm], [2 m, 0], [3 m, 1 mm], [3 m, 1 m]]}\n"
         "  edge: {thin-points: scan, within: 2 mm}\n",
         "[Ramer72], [DP73]", "batten_points_thin", BAT_PARAMETERS(parameters), false,
         .also = "Douglas-Peucker, Ramer, decimate, simplify polyline, data reduction"},
    .run = run_thin_points};
