/* The output 'check': a report: what was done to the data, and how fair the result is. */
#include "design/outputs/fairness.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"check", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is checked"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far points may lie from the shape made of them, and edges from faces; meshes must "
     "close"},
};

/* Bodies and meshes have said themselves what is wrong. */
static void note_distance(const bat_run *run, const bat_check *check)
{
    bool is_far = false;
    for (int i = 0; i < check->object_count; i++)
        for (int k = 0; k < check->objects[i].distance_count; k++)
            is_far |= !check->objects[i].distances[k].is_faired &&
                      check->objects[i].distances[k].max > check->within;
    if (is_far)
        bat_note(run, "a point given lies farther than %g from the shape", check->within);
}

static bool is_json(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot && strcmp(dot, ".json") == 0;
}

static batten_status run_check(bat_run *run)
{
    bat_check check;
    batten_text text = BATTEN_TEXT;
    const double within = bat_has(run, "within") ? bat_number(run, "within") : HUGE_VAL;
    batten_status status = bat_check_all(run, "check", within, &check);
    if (status == BATTEN_OK) {
        run->unmet = !check.ok;
        if (!check.ok && check.bounded_count == 0)
            bat_note(run,
                     "the bound %g could not be checked: there is no surface with points, and "
                     "no curve with points that were not made fair",
                     within);
        else if (!check.ok)
            note_distance(run, &check);
        if (is_json(run->name))
            bat_report_json(&check, &text);
        else
            bat_report_text(&check, &text);
        status = batten_text_take(&text, &run->data, &run->size);
    }
    bat_check_release(&check);
    return status;
}

const bat_feature bat_feature_check = {
    .shown =
        {"check", "A report: what was done to the data, and how fair the result is",
         "For each feature that the result is made from: what was moved and how far, inflections\n"
         "in excess and energy before and after, and how far a skin moved its sections. For each\n"
         "surface: the distance of the points given, and of those after fairing, from the nearest\n"
         "of all surfaces that are checked; the fairness of its stations and waterlines, and how\n"
         "far its edges are from the centre plane. Where ends of curves or whole edges of surfaces\n"
         "meet within the tolerance of the design: the gap g0, the angle g1 by which the direction\n"
         "turns, in radians, the difference g2 of the curvatures as a part of the larger one, and\n"
         "for curves the difference g3 of the rates of curvature. For bodies: edges of one face,\n"
         "of two and of more, faces turned against each other, gaps between edges, vertices and\n"
         "faces, loops that cross, shells that are open or inside out. For meshes: edges of one\n"
         "triangle, of more than two, triangles turned against each other. With 'within' the gaps,\n"
         "and the distances of edges from their faces, must not be larger, and none of the other\n"
         "defects may occur except the free edges of sheets; so meshes must be closed. As JSON,\n"
         "with all digits, when the file ends in .json.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 31 cm], [3 m, 29 cm], [4 m, 0]]}\n"
         "  sheer: {interpolate: ducks}\n"
         "outputs:\n"
         "  report.txt: {check: sheer}\n"
         "  report.json: {check: sheer, within: 1 cm}\n",
         "[SL]", "batten_curve_fairness", BAT_PARAMETERS(parameters), true},
    .run = run_check,
    .takes_file = is_json};
