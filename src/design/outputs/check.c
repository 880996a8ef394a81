/* The output 'check': a report: what was done to the data, and how fair the result is. */
#include "design/outputs/fairness.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"check", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is checked"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far points may lie from the shape made of them, and edges from faces; meshes must "
     "close"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, NULL, NULL,
     "corners and creases turn by more (of curves 1e-6 rad, of edges of surfaces 0.1 deg)"},
    {"curvature", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "jumps of curvature are a larger part of the larger (of curves 1e-6, of edges 0.05)"},
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

/* The bounds of the verdict: stated, or the defaults that the parameters tell. */
static batten_status read_bounds(const bat_run *run, bat_fair_bounds *curves,
                                 bat_fair_bounds *edges)
{
    const batten_fairness_options standard = batten_fairness_defaults();
    *curves = (bat_fair_bounds){standard.angle, standard.curvature};
    *edges = (bat_fair_bounds){BAT_EDGE_ANGLE, BAT_EDGE_CURVATURE};
    if (bat_has(run, "angle"))
        curves->angle = edges->angle = bat_number(run, "angle");
    if (bat_has(run, "curvature"))
        curves->curvature = edges->curvature = bat_number(run, "curvature");
    if (!(curves->angle > 0 && curves->angle < BAT_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'angle' is %g deg; it must be between 0 and 180",
                        curves->angle * 180 / BAT_PI);
    if (!(curves->curvature > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'curvature' is %g; it must be above 0",
                        curves->curvature);
    return bat_check_within(run);
}

static batten_status run_check(bat_run *run)
{
    bat_check check = {.run = run};
    batten_text text = BATTEN_TEXT;
    bat_fair_bounds curves, edges;
    batten_status status = read_bounds(run, &curves, &edges);
    if (status != BATTEN_OK)
        return status;
    const double within = bat_has(run, "within") ? bat_number(run, "within") : HUGE_VAL;
    status = bat_check_all(run, "check", within, &curves, &edges, &check);
    if (status == BATTEN_OK) {
        run->unmet = !check.ok;
        if (check.bounded_count == 0 && isfinite(within))
            bat_note(
                run,
                "the bound %g was not needed: there is no surface with points, and no curve "
                "with points that were not made fair",
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
         "of all surfaces that are checked, for each feature whose points lie on it (not control\n"
         "points, paths of sweeps, points of what was moved or offset since); the fairness of its\n"
         "sections where the data have rows, which may have the inflections that the points given\n"
         "require within the bound of fairing; of hulls, whose data are a table of offsets, how\n"
         "far edges are from the centre plane. Where ends of curves or whole edges of surfaces\n"
         "meet within the tolerance of the design: the gap g0, the angle g1 by which the direction\n"
         "turns, in radians, the difference g2 of the curvatures as a part of the larger one, the\n"
         "difference g3 of the rates of curvature, the order G0 to G3, and of several edges of\n"
         "surfaces, or of faces of a body, the worst of each with its place; of surfaces\n"
         "curvatures are those across the edge, within 0.1 degree and 5 percent. For bodies: edges\n"
         "of one face, of two and of more, faces turned against each other, gaps between edges,\n"
         "vertices and faces, loops that cross, shells that are open or inside out. For meshes:\n"
         "edges of one triangle, of more than two, triangles turned against each other. With\n"
         "'within' the gaps, and the distances of edges from their faces, must not be larger, and\n"
         "none of the other defects may occur except the free edges of sheets; so meshes must be\n"
         "closed. The verdict says for what it is made: a curve, a family of curves, a hull or a\n"
         "free surface. Not fair are corners and cusps of curves, creases where edges of surfaces\n"
         "meet (both beyond 'angle'), jumps of curvature (beyond 'curvature'), inflections in\n"
         "excess, and surfaces that fold over. Where the ends of two curves meet, and of no third,\n"
         "they are one line: its corners and jumps there count. Points on what 'part', 'split',\n"
         "'trim' and 'select' leave away are left out, and counted. As JSON, with all digits and\n"
         "numbers from 1, when the file ends in .json.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 31 cm], [3 m, 29 cm], [4 m, 0]]}\n"
         "  sheer: {interpolate: ducks}\n"
         "outputs:\n"
         "  report.txt: {check: sheer}\n"
         "  report.json: {check: sheer, within: 1 cm}\n",
         "[SL section VII.1] [SL section VII.3]", "batten_curve_fairness",
         BAT_PARAMETERS(parameters), true,
         .also =
             "verdict, fairness, report, continuity check, deviation, G0 G1 G2, curvature, inflections, quality"},
    .run = run_check,
    .takes_file = is_json};
