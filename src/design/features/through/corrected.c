/* The feature 'corrected': cubic curves without inflections in excess, cusps and loops. */
#include "base/plural.h"
#include "design/shared/rows.h"
#include <batten/local.h>

typedef enum { TANGENT, CURVATURE } joins;

static const batten_parameter parameters[] = {
    {"corrected", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "curves of degree 3 at most"},
    {"within", BATTEN_VALUE_NUMBER, false, false, "0.95", NULL,
     "the share of the longest allowed tangent that a corrected one gets, 0 to 1"},
    {"joins", BATTEN_VALUE_WORD, false, false, "tangent", "tangent curvature",
     "what holds at the joins of corrected spans; curvature: in a plane"},
};

/* A plane curve back in the plane of two axes that it came from. */
static batten_status lift(const batten_curve *flat, int axis, double at, batten_curve **out)
{
    const int x = axis == 0, y = axis == 2 ? 1 : 2;
    batten_affine map = {{{0}}, {0}};
    batten_curve *space = NULL;
    map.m[x][0] = map.m[y][1] = map.m[axis][2] = 1;
    map.t[axis] = at;
    batten_status status = batten_curve_to_dimension(flat, 3, &space);
    if (status == BATTEN_OK)
        status = batten_curve_transform(space, &map, out);
    batten_curve_unref(space);
    return status;
}

static batten_status correct_in_plane(const batten_curve *curve,
                                      const batten_curve_correct_tangents_options *options,
                                      batten_curve_correct_tangents_report *report,
                                      batten_curve **out)
{
    const double *points = batten_curve_points(curve);
    const int axis = bat_flat_axis(batten_curve_point_count(curve), points);
    batten_curve *flat = NULL, *made = NULL;
    if (axis < 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "'joins: curvature' needs a curve in a plane x, y "
                        "or z = constant");
    batten_status status = bat_curve_in_plane(curve, axis, &flat);
    if (status == BATTEN_OK)
        status = batten_curve_correct_tangents(flat, options, NULL, report, &made);
    if (status == BATTEN_OK)
        status = lift(made, axis, points[axis], out);
    batten_curve_unref(made);
    batten_curve_unref(flat);
    return status;
}

static batten_status correct(const bat_run *run, const batten_curve *curve, batten_curve **out)
{
    batten_curve_correct_tangents_options options = batten_curve_correct_tangents_defaults();
    batten_curve_correct_tangents_report report;
    options.within = bat_number(run, "within");
    options.joins = (batten_correct_joins)bat_word(run, "joins");
    const batten_status status =
        options.joins == BATTEN_CORRECT_CURVATURE
            ? correct_in_plane(curve, &options, &report, out)
            : batten_curve_correct_tangents(curve, &options, NULL, &report, out);
    if (status != BATTEN_OK)
        return status;
    if (report.corrected > 0)
        bat_remark(run, "%d of %d span%s corrected", report.corrected, report.span_count,
                   bat_plural(report.span_count));
    if (report.incurable > 0)
        bat_note(run,
                 "%d span%s %s too far to be corrected, the first of them span %d; more "
                 "points are needed there",
                 report.incurable, bat_plural(report.incurable),
                 bat_one_or_many(report.incurable, "turns", "turn"),
                 report.first_incurable + 1);
    if (options.joins == BATTEN_CORRECT_CURVATURE && report.broken > 0)
        bat_note(run,
                 "curvatures could not be made equal at %d join%s; mostly because the "
                 "directions there bend the spans to opposite sides",
                 report.broken, bat_plural(report.broken));
    return BATTEN_OK;
}

static batten_status run_corrected(bat_run *run)
{
    const bat_change change = {.curve = correct, .keeps_data = true};
    return bat_change_all(run, &change);
}

const bat_feature bat_feature_corrected = {
    .shown =
        {"corrected", "Cubic curves without inflections in excess, cusps and loops",
         "A cubic span whose end tangents are too long for its chord has two inflections, a cusp\n"
         "or a loop that nobody asked for. Here such tangents are shortened, to the share 'within'\n"
         "of what is allowed; points, directions and the other spans stay. The joins keep their\n"
         "tangents but lose equal speed, and mostly equal curvature; with 'joins: curvature' the\n"
         "lengths of these spans and of their neighbours are chosen together such that curvatures\n"
         "agree at as many joins as possible: not where the two sides bend in opposite directions.\n"
         "Spans that turn by half a circle or more cannot be cured by lengths; a note counts them.\n"
         "Better parameters ('chord', 'centripetal') often make the correction unnecessary.",
         "features:\n"
         "  ducks: {points: [[0, 0], [3 m, 0.4 m], [3.3 m, 1 m], [3.4 m, 2 m], [2.2 m, 3 m]]}\n"
         "  loopy: {interpolate: ducks, parameters: uniform}\n"
         "  simple: {corrected: loopy}\n",
         "[SL section III.5] [SL section III.6] [dBHS87]", "batten_curve_correct_tangents",
         BAT_PARAMETERS(parameters), false,
         .also = "remove loops, remove cusps, excess inflections"},
    .run = run_corrected};
