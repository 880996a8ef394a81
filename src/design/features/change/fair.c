/* The feature 'fair': points moved within a bound until their curves are fair. */
#include "design/features/change/fair.h"
#include "base/plural.h"

#include <string.h>

/* So many points that look like blunders are named one by one. */
#define MOST_SUSPECTS 10

/* Of fewer points there is nothing to fair: their curve stays as it is. */
#define FEWEST_POINTS 4

static const batten_parameter parameters[] = {
    {"fair", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, points, or curves that have points"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "no point moves farther than this"},
    {"families", BATTEN_VALUE_WORD, false, false, "both", "stations lines both",
     "of a table: what is made fair"},
    {"method", BATTEN_VALUE_WORD, false, false, "springback",
     "springback circle-rate kjellander least-change farin-sapidis eck-hadenfeld",
     "by what points are moved; by the last two the control points of a curve"},
    {"order", BATTEN_VALUE_WORD, false, false, "sweeps", "worst-first sweeps alternate",
     "of springback: which duck is released next"},
    {"corner-angle", BATTEN_VALUE_ANGLE, false, false, "25 deg", NULL,
     "of a table: a station that turns by this much more than beside it has a corner, which stays"},
    {"hold-ends", BATTEN_VALUE_YES_NO, false, false, "yes", NULL, "the end points stay"},
    {"stop-when-fair", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "stop as soon as no inflection is in excess"},
};

static batten_fair_options options_of(const bat_run *run)
{
    batten_fair_options options = batten_fair_defaults(bat_number(run, "within"));
    options.method = (batten_fair_method)bat_word(run, "method");
    options.order = (batten_fair_order)bat_word(run, "order");
    options.corner_angle = bat_number(run, "corner-angle");
    options.hold_ends = bat_yes(run, "hold-ends");
    options.stop_when_fair = bat_yes(run, "stop-when-fair");
    return options;
}

static bool moves_control_points(const bat_run *run)
{
    return bat_word(run, "method") >= BAT_METHODS_OF_POINTS;
}

/* ---- one curve ---- */

static batten_status fair_points(const bat_run *run, const batten_object *object,
                                 double *faired, batten_fair_report *report)
{
    const int count = object->point_count, axis = bat_flat_axis(count, object->points);
    const int dimension = axis < 0 ? 3 : 2;
    const batten_fair_options options = options_of(run);
    double *given = bat_points_in_plane(axis, count, object->points);
    double *moved = bat_array3((size_t)count, (size_t)dimension, sizeof *moved);
    batten_status status = given && moved ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_fair_points((batten_points){dimension, count, given},
                                    object->parameters, &options, run->job, report, moved);
    if (status == BATTEN_OK) {
        memcpy(faired, object->points, 3 * (size_t)count * sizeof *faired);
        bat_points_from_plane(axis, count, moved, faired);
    }
    if (status == BATTEN_OK && axis >= 0) {
        bat_fair_lift_moves(axis, object->points[axis], report->moves, report->move_count);
        bat_fair_lift_moves(axis, object->points[axis], report->suspects,
                            report->suspect_count);
    }
    bat_release(moved);
    bat_release(given);
    return status;
}

/* The curve through the new points at the old parameters. */
static batten_status fit_again(const bat_run *run, const batten_object *object,
                               const double *points, batten_curve **out)
{
    batten_curve_interpolate_options options = run->result->fit;
    const int count = object->point_count;
    const bool periodic = batten_curve_is_periodic(object->curve);
    double *given = NULL;
    options.degree = batten_curve_degree(object->curve);
    options.knots_at_data &= options.degree % 2 == 1; /* of even degrees they are averaged */
    options.closed = periodic;
    if (object->parameters) {
        given = bat_array((size_t)count + 1, sizeof *given);
        if (!given)
            return BATTEN_OUT_OF_MEMORY;
        memcpy(given, object->parameters, (size_t)count * sizeof *given);
        given[count] = batten_curve_domain(object->curve).b;
        options.parameters = BATTEN_GIVEN;
        options.given = given;
    }
    const batten_status status =
        batten_curve_interpolate((batten_points){3, count, points}, &options, NULL, out);
    bat_release(given);
    return status;
}

/* The batten has natural ends; a curve keeps those it had, which may turn where the batten does not. */
static batten_status note_ends(const bat_run *run, const batten_object *object,
                               const batten_curve *made, const batten_fair_report *report)
{
    const int count = object->point_count, axis = bat_flat_axis(count, object->points);
    if (axis < 0 || report->after.excess_inflections > 0)
        return BATTEN_OK;
    batten_fairness_options options = batten_fairness_defaults();
    batten_fairness found = {0};
    batten_curve *plane = NULL;
    double *given = bat_points_in_plane(axis, count, object->points);
    batten_status status = given ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    options.within = bat_number(run, "within");
    if (status == BATTEN_OK)
        status = bat_curve_in_plane(made, axis, &plane);
    if (status == BATTEN_OK)
        status =
            batten_curve_fairness(plane, (batten_points){2, count, given}, &options, &found);
    if (status == BATTEN_OK && found.excess_inflections > 0)
        bat_note(
            run,
            "'%s': the batten through the moved points is fair, but the curve, with the ends "
            "it had, has %d inflection%s in excess; 'ends: natural' where it is "
            "interpolated makes it the batten",
            object->name, found.excess_inflections, bat_plural(found.excess_inflections));
    batten_curve_unref(plane);
    bat_release(given);
    return status;
}

static batten_status fair_curve(bat_run *run, const batten_object *object, int set)
{
    batten_fair_report report = {0};
    batten_curve *curve = NULL;
    const int count = object->point_count;
    if (count < FEWEST_POINTS)
        return bat_add(run, object);
    batten_object made = *object;
    double *faired = bat_array3((size_t)count, 3, sizeof *faired);
    batten_status status =
        faired ? fair_points(run, object, faired, &report) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_fair_add_report(&run->result->fairing, &report, set, count);
    if (status == BATTEN_OK)
        status = fit_again(run, object, faired, &curve);
    if (status == BATTEN_OK)
        status = note_ends(run, object, curve, &report);
    made.points = faired;
    status = bat_put_curve_like(run, status, curve, &made, true);
    batten_fair_report_release(&report);
    bat_release(faired);
    return status;
}

/* Points alone: those of the curve through them, which is made first. */
static batten_status fair_row(bat_run *run, const batten_object *object, int set)
{
    const int count = object->point_count;
    batten_object through = *object;
    batten_curve *curve = NULL;
    if (count < 2)
        return bat_add(run, object);
    double *parameters_of = bat_array((size_t)count, sizeof *parameters_of);
    batten_status status = parameters_of ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_interpolate((batten_points){3, count, object->points},
                                          &run->result->fit, parameters_of, &curve);
    through.kind = BATTEN_OBJECT_CURVE;
    through.curve = curve;
    through.parameters = parameters_of;
    if (status == BATTEN_OK)
        status = fair_curve(run, &through, set);
    else if (status != BATTEN_OUT_OF_MEMORY)
        status = bat_fail(status, "%s: %s", object->name, batten_message());
    bat_release(parameters_of);
    batten_curve_unref(curve);
    return status;
}

/* ---- the whole input ---- */

/* The options with which an input was interpolated, or the standard ones. */
static void inherit_fit(bat_run *run)
{
    const bat_result *from = &run->results[bat_argument_of(run, "fair")->items[0].count];
    run->result->fit = from->has_fit ? from->fit : batten_curve_interpolate_defaults();
    run->result->has_fit = true;
}

static batten_status refuse_object(const batten_object *object, bool control_points)
{
    if (control_points)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'%s' is not a curve, and this method moves control points of curves; "
                        "'interpolate' makes a curve of points",
                        object->name);
    return bat_fail(
        BATTEN_BAD_ARGUMENT,
        "'%s' is a %s without the points it was made from, and fairing moves points: "
        "make those fair, or points of it that 'divide' takes, or take 'method: "
        "farin-sapidis' or 'eck-hadenfeld', which move control points",
        object->name, object->kind == BATTEN_OBJECT_CURVE ? "curve" : "shape");
}

static batten_status fair_object(bat_run *run, const batten_object *object, int set)
{
    const bool control_points = moves_control_points(run);
    const bool curve = object->kind == BATTEN_OBJECT_CURVE;
    if (curve && control_points)
        return bat_fair_control_points(run, object, set);
    if (object->kind == BATTEN_OBJECT_POINTS && !control_points)
        return fair_row(run, object, set);
    if (curve && object->point_count > 0)
        return fair_curve(run, object, set);
    return refuse_object(object, control_points);
}

static int moved_points_of(const bat_run *run, const batten_object *object)
{
    return moves_control_points(run) && object->kind == BATTEN_OBJECT_CURVE
               ? batten_curve_point_count(object->curve)
               : object->point_count;
}

static batten_status fair_curves(bat_run *run, const bat_objects *curves)
{
    batten_fair_report *report = &run->result->fairing;
    batten_status status = BATTEN_OK;
    int point_count = 0;
    report->before.fair = report->after.fair = true;
    for (int i = 0; i < curves->count && status == BATTEN_OK; i++) {
        status = fair_object(run, curves->at[i], i);
        point_count += moved_points_of(run, curves->at[i]);
    }
    report->rms_move = point_count ? sqrt(report->rms_move / point_count) : 0;
    return status;
}

static batten_status fair_table(bat_run *run, const batten_object *object)
{
    const batten_fair_options options = options_of(run);
    const batten_fair_families families = (batten_fair_families)(bat_word(run, "families") + 1);
    batten_object made = *object;
    batten_offset_table *faired = NULL;
    batten_status status = batten_fair_offset_table(object->offset_table, families, &options,
                                                    run->job, &run->result->fairing, &faired);
    made.offset_table = faired;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    batten_offset_table_unref(faired);
    return status;
}

/* ---- what has no effect ---- */

static void note_idle(const bat_run *run, const char *parameter, bool is_used, const char *why)
{
    if (bat_argument_of(run, parameter)->given && !is_used)
        bat_note(run, "'%s' has no effect: %s", parameter, why);
}

static void note_idle_options(const bat_run *run, bool table)
{
    const int method = bat_word(run, "method"), order = bat_word(run, "order");
    const bool springback = method == BATTEN_FAIR_SPRINGBACK;
    const bool stops =
        springback ? !table && order == BATTEN_FAIR_WORST_FIRST
                   : method == BATTEN_FAIR_CIRCLE_RATE || method == BATTEN_FAIR_KJELLANDER;
    note_idle(run, "order", springback && !table,
              "only springback of curves releases ducks in an order");
    note_idle(run, "hold-ends", method != BATTEN_FAIR_CIRCLE_RATE,
              "by circle rates the first and the last two points always stay");
    note_idle(run, "families", table, "it is of a table of offsets");
    note_idle(run, "corner-angle", table, "it is of a table of offsets");
    if (bat_yes(run, "stop-when-fair"))
        note_idle(run, "stop-when-fair", stops,
                  "only methods that move the worst point first, 'order: worst-first', "
                  "'circle-rate' and 'kjellander', stop between moves");
}

static void show_report(bat_run *run)
{
    batten_feature_result *shown = &run->result->shown;
    const batten_fair_report *report = &run->result->fairing;
    shown->has_moves = true;
    shown->move_max = report->max_move;
    shown->moved_count = report->moved_count;
    for (int i = 0; i < report->suspect_count && i < MOST_SUSPECTS; i++) {
        const batten_fair_move *s = &report->suspects[i];
        bat_note(
            run,
            "point %d of curve %d, (%g, %g, %g), looks like a blunder; (%g, %g, %g) would fit",
            s->index + 1, s->set + 1, s->from[0], s->from[1], s->from[2], s->to[0], s->to[1],
            s->to[2]);
    }
    if (report->suspect_count > MOST_SUSPECTS)
        bat_note(run, "%d more point%s %s like blunders", report->suspect_count - MOST_SUSPECTS,
                 bat_plural(report->suspect_count - MOST_SUSPECTS),
                 bat_one_or_many(report->suspect_count - MOST_SUSPECTS, "looks", "look"));
}

static batten_status run_fair(bat_run *run)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "fair", BAT_ALL, &objects);
    if (status != BATTEN_OK)
        return status;
    inherit_fit(run);
    run->result->fairing_bound = moves_control_points(run) ? 0 : bat_number(run, "within");
    if (objects.at[0]->kind != BATTEN_OBJECT_OFFSET_TABLE)
        status = fair_curves(run, &objects);
    else if (objects.count == 1)
        status = fair_table(run, objects.at[0]);
    else
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "one table of offsets is made fair at a time, not %d", objects.count);
    if (status == BATTEN_OK) {
        show_report(run);
        note_idle_options(run, objects.at[0]->kind == BATTEN_OBJECT_OFFSET_TABLE);
    }
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_fair = {
    .shown =
        {"fair", "Points moved within a bound until their curves are fair",
         "By 'springback' each duck in turn is released and the batten settles between the others;\n"
         "by 'circle-rate' the curvature of the circle through each three points of a plane is made\n"
         "linear, by 'kjellander' a point goes to the cubic with its neighbours' tangents, both at\n"
         "the worst point first. 'least-change' moves points of a plane as little as removes the\n"
         "inflections in excess; a curve without any stays as it is. No point moves farther than\n"
         "'within' from where it was given. Curves are interpolated anew through the moved points,\n"
         "with the parameters and ends they had; points alone get a curve as 'interpolate' makes\n"
         "it; a table of offsets stays a table, by springback. Curves of IGES and STEP files have\n"
         "no points: 'farin-sapidis' moves control points of cubics, at the knot where the third\n"
         "derivative jumps most, and 'eck-hadenfeld' those by which the integral of its square falls\n"
         "most; then no point of the curve is farther than 'within' from where it was. Points that\n"
         "look like blunders are reported, not repaired.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 31 cm], [3 m, 29 cm], [4 m, 0]]}\n"
         "  sheer: {interpolate: ducks, ends: natural}\n"
         "  faired: {fair: sheer, within: 1 cm}\n",
         "[SL section VII.2] [SL section VII.3] [NW06] [Kje83] [FS90] [EH95]",
         "batten_fair_points", BAT_PARAMETERS(parameters), false,
         .also =
             "fairing, smoothing of points, springback, ducks, remove bumps, lines fairing, Kjellander, huitan, circle rate, yuanlu, Farin Sapidis, Eck Hadenfeld, knot removal and reinsertion",
         .formula =
             "    ∫ |z″|² dt → minimum over points |z_i − y_i| ≤ within,  z the natural cubic spline through them;\n"
             "    Kjellander: P_j → the cubic with P, P′ of P_j−1 and P_j+1;  circle rate: k_j → (h_j k_j−1 + h_j−1 k_j+1) / (h_j−1 + h_j);\n"
             "    least change: Σ |z_i − y_i|² / within² → minimum over z″ of the signs that points require",
         .promise =
             "No point moves farther than the bound; by sweeps the energy is the least within the bounds."},
    .run = run_fair};
