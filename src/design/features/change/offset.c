/* The feature 'offset': curves and surfaces at a distance from others. */
#include "design/feature.h"

#include <batten/offset.h>
#include <stdio.h>

typedef enum { LEFT, RIGHT } side;
typedef enum { REFUSE, KEEP } turned;

static const batten_parameter parameters[] = {
    {"offset", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"by", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the distance; negative: to the other side"},
    {"side", BATTEN_VALUE_WORD, false, false, "left", "left right both",
     "seen along the curve with the normal up; of a surface left is to its normal"},
    {"corners", BATTEN_VALUE_WORD, false, false, "round", "round mitre square",
     "how the outside of a corner is filled"},
    {"mitre-limit", BATTEN_VALUE_NUMBER, false, false, "4", NULL,
     "longer mitres, as multiples of the distance, become square"},
    {"loops", BATTEN_VALUE_WORD, false, false, "remove", "remove keep",
     "what lies closer to the curve than the distance"},
    {"normal", BATTEN_VALUE_POINT, false, false, "z", NULL, "across the plane of the offset"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the true offset; a tenth of the tolerance of the design by default"},
    {"turned", BATTEN_VALUE_WORD, false, false, "refuse", "refuse keep",
     "surfaces: what turns over, the distance being more than a radius of curvature"},
};

static batten_curve_offset_options options_of(const bat_run *run)
{
    batten_curve_offset_options options = batten_curve_offset_defaults();
    options.tolerance =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run) / 10;
    options.corners = (batten_offset_corner)bat_word(run, "corners");
    options.mitre_limit = bat_number(run, "mitre-limit");
    options.loops = (batten_loops)bat_word(run, "loops");
    options.normal = bat_point(run, "normal");
    return options;
}

static batten_status offset_surface(bat_run *run, const batten_object *object, double distance)
{
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_surface *made = NULL;
    options.tolerance = options_of(run).tolerance;
    options.keep = bat_word(run, "turned") == KEEP;
    const batten_status status =
        batten_surface_offset(object->surface, distance, &options, &report, &made);
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    bat_remark(run, "%s: curvatures from %.4g to %.4g; the offset is %s", object->name,
               report.least, report.most, report.exact ? "exact" : "within the tolerance");
    if (report.factor <= 0)
        bat_note(run, "%s: the offset turns over, most at (%.4g, %.4g)", object->name,
                 report.at[0], report.at[1]);
    bat_report_error(run, report.error, report.error);
    return bat_put_surface_like(run, status, made, object);
}

static batten_status offset_object(bat_run *run, const batten_object *object, double distance)
{
    if (object->kind == BATTEN_OBJECT_SURFACE)
        return offset_surface(run, object, distance);
    const batten_curve_offset_options options = options_of(run);
    batten_curve_offset_report report;
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
    status = bat_put_curves_like(run, object, &made);
    batten_curves_release(&made);
    return status;
}

static batten_status offset_sides(bat_run *run, const batten_object *object)
{
    const double by = bat_number(run, "by");
    const int where = bat_word(run, "side");
    batten_status status = BATTEN_OK;
    if (where != RIGHT)
        status = offset_object(run, object, by);
    if (status == BATTEN_OK && where != LEFT)
        status = offset_object(run, object, -by);
    return status;
}

static batten_status run_offset(bat_run *run)
{
    return bat_for_objects(run, "offset", BAT_CURVES | BAT_SURFACES, offset_sides);
}

const bat_feature bat_feature_offset = {
    .shown =
        {"offset", "Curves and surfaces at a distance from others",
         "Each point moves by the distance at right angles to the curve, in the plane across\n"
         "'normal'. Lines and arcs give lines and arcs, which DXF and G-code keep as such; other\n"
         "curves are followed 'within' a tolerance by pieces of degree 5, with cusps where the\n"
         "radius of the curve equals the distance. What then lies closer to the curve than the\n"
         "distance is removed, so a narrow curve may fall into several or nothing; 'loops: keep'\n"
         "leaves all in one piece. Several curves are offset each on its own. Surfaces move by the\n"
         "distance along their normals. Spheres, cylinders, cones, tori and whatever else allows\n"
         "it are offset exactly, with the same knots; others are approximated 'within' a\n"
         "tolerance. An offset beyond a radius of curvature turns over; it is refused, and the\n"
         "message says where, unless 'turned: keep' is given. A surface with a crease must be\n"
         "split there first.",
         "features:\n"
         "  corners: {points: [[0, 0], [4 m, 0], [4 m, 3 m], [0, 3 m]]}\n"
         "  floor: {interpolate: corners, periodic: yes}\n"
         "  walls: {offset: floor, by: 0.3 m, side: both}\n",
         "[TH84], [PM02]", "batten_curve_offset, batten_surface_offset",
         BAT_PARAMETERS(parameters), false,
         .also = "parallel curve, tool radius, thicken, shell distance, equidistant",
         .formula = "    C_d(t) = C(t) + d N(t);  S_d(u, v) = S(u, v) + d n(u, v)",
         .promise =
             "The true offset is met within the tolerance; arcs, lines and quadrics are exact."},
    .run = run_offset,
    .displacing = "offset"};
