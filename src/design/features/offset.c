#include "design/feature.h"

#include <batten/curve_offset.h>
#include <stdio.h>

typedef enum { LEFT, RIGHT } side;

static const batten_parameter parameters[] = {
    {"offset", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"by", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the distance; negative: to the other side"},
    {"side", BATTEN_VALUE_WORD, false, false, "left", "left right both",
     "to which side, seen along the curve with the normal up"},
    {"corners", BATTEN_VALUE_WORD, false, false, "round", "round mitre square",
     "what goes around the outside of a corner"},
    {"mitre-limit", BATTEN_VALUE_NUMBER, false, false, "4", NULL,
     "longer mitres, as multiples of the distance, become square"},
    {"loops", BATTEN_VALUE_WORD, false, false, "remove", "remove keep",
     "what comes nearer to the curve than the distance"},
    {"normal", BATTEN_VALUE_POINT, false, false, "z", NULL, "across the plane of the offset"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the true offset; a tenth of the tolerance of the design by default"},
};

static batten_offset_options options_of(const bat_run *run)
{
    batten_offset_options options = batten_offset_defaults();
    options.tolerance =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run) / 10;
    options.corners = (batten_offset_corner)bat_word(run, "corners");
    options.mitre_limit = bat_number(run, "mitre-limit");
    options.loops = (batten_loops)bat_word(run, "loops");
    options.normal = bat_point(run, "normal");
    return options;
}

static batten_status put_all(bat_run *run, const batten_object *object,
                             const batten_curves *made)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < made->count && status == BATTEN_OK; i++) {
        batten_object like = *object;
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", object->name, i + 1);
        if (made->count > 1)
            like.name = name;
        status = bat_put_curve_like(run, status, batten_curve_ref(made->at[i]), &like, false);
    }
    return status;
}

static batten_status offset_object(bat_run *run, const batten_object *object, double distance)
{
    const batten_offset_options options = options_of(run);
    batten_offset_report report;
    batten_curves made = {0, NULL};
    const int flat = batten_curve_dimension(object->curve) == 1;
    batten_status status =
        flat ? bat_fail(BATTEN_UNSUPPORTED, "'%s' is a function", object->name)
             : batten_curve_offset(object->curve, distance, &options, &report, &made);
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    bat_report_error(run, report.error, report.error);
    if (made.count == 0)
        bat_note(run, "'%s' has nothing as far inside as %g", object->name, fabs(distance));
    status = put_all(run, object, &made);
    batten_curves_release(&made);
    return status;
}

static batten_status run(bat_run *run)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "offset", BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    const double by = bat_number(run, "by");
    const int where = bat_word(run, "side");
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++) {
        if (where != RIGHT)
            status = offset_object(run, objects.at[i], by);
        if (status == BATTEN_OK && where != LEFT)
            status = offset_object(run, objects.at[i], -by);
    }
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_offset = {
    .shown =
        {"offset", "Curves at a distance from curves",
         "Each point goes by the distance across the curve, in the plane across 'normal'. "
         "Lines and\n"
         "arcs give lines and arcs, which DXF and G-code then have as such; other curves are "
         "followed\n"
         "'within' a tolerance by pieces of degree 5, with cusps where the radius of the curve "
         "equals the\n"
         "distance. What then comes nearer to the curve than the distance is removed, so a "
         "narrow curve\n"
         "may fall into several or nothing; 'loops: keep' leaves all in one piece. Where "
         "several curves\n"
         "are offset each minds itself only.",
         "features:\n"
         "  corners: {points: [[0, 0], [4 m, 0], [4 m, 3 m], [0, 3 m]]}\n"
         "  floor: {interpolate: corners, periodic: yes}\n"
         "  walls: {offset: floor, by: 0.3 m, side: both}\n",
         "[TH84]", "batten_curve_offset", BAT_PARAMETERS(parameters), false},
    .run = run};
