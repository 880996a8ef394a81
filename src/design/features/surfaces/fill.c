/* The feature 'fill': surfaces in a hole, several around its middle or one trimmed. */
#include "design/features/surfaces/fill.h"
#include "base/plural.h"

#include <batten/fill.h>
#include <batten/text.h>
#include <stdio.h>
#include <string.h>

#define DEGREES (180 / BAT_PI)

static const batten_parameter parameters[] = {
    {"fill", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the sides, in any order"},
    {"along", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "surfaces around the hole: the fill continues smoothly those that have a side as an edge"},
    {"slopes", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "curves of vectors across the first sides, into the hole, running as these do"},
    {"continuity", BATTEN_VALUE_WORD, false, false, "G1", "G0 G1 G2",
     "what the fill takes over from them: the edge, the tangent planes, the curvature"},
    {"form", BATTEN_VALUE_WORD, false, false, NULL, "split kato charrot-gregory sheet",
     "exact surfaces; splines near a formula; one trimmed surface; as the text above says"},
    {"through", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "points and curves within the sides, for the form sheet to go through"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "of corners, sides from edges, splines from formulas; the design's tolerance by default"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "0.002 deg", NULL,
     "how far tangent planes may be left, at corners with other twists and by the spline along edges"},
    {"curvature", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "how far curvatures across any edge, inner ones too, may differ; more is refused"},
    {"folds", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "also return a fill that folds over, which is otherwise refused"},
};

/* The ribbons of one fill; the sides are those of the surfaces where these lie beside them. */
typedef struct {
    int count;
    batten_ribbon ribbons[BATTEN_SHEET_SIDES];
    batten_curve *curves[BATTEN_SHEET_SIDES][3];
    double within;
} sides;

static void free_sides(sides *all)
{
    for (int i = 0; i < all->count; i++)
        for (int k = 0; k < 3; k++)
            batten_curve_unref(all->curves[i][k]);
}

/* Take the sides' ribbons from the surfaces; say which surface none of them touches. */
static batten_status find_ribbons(const bat_run *run, sides *all, const bat_objects *surfaces)
{
    batten_status status = BATTEN_OK;
    const batten_surface **at =
        bat_array((size_t)surfaces->count, sizeof(const batten_surface *));
    bool *touched = bat_array((size_t)surfaces->count, sizeof *touched);
    if (!at || !touched)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < surfaces->count; i++)
        at[i] = surfaces->at[i]->surface;
    for (int i = 0; status == BATTEN_OK && i < all->count; i++) {
        int found = -1;
        batten_curve **curves = all->curves[i];
        status = batten_ribbon_beside(all->ribbons[i].curve,
                                      (batten_surface_row){surfaces->count, at}, 2, all->within,
                                      &found, curves);
        if (status == BATTEN_OK && found >= 0) {
            touched[found] = true;
            all->ribbons[i] = (batten_ribbon){curves[0], curves[1], curves[2]};
        }
    }
    for (int i = 0; status == BATTEN_OK && i < surfaces->count; i++)
        if (!touched[i])
            bat_note(run, "surface '%s' has none of the sides as its edge, within %g",
                     surfaces->at[i]->name, all->within);
    bat_release(touched);
    bat_release(at);
    return status;
}

/* The slopes of the first sides, as they are given. */
static batten_status take_slopes(const bat_run *run, sides *all)
{
    bat_objects slopes;
    batten_status status = bat_gather(run, "slopes", BAT_CURVES, &slopes);
    if (status != BATTEN_OK)
        return status;
    if (slopes.count > all->count)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there are %d 'slopes' for %d sides",
                          slopes.count, all->count);
    for (int i = 0; status == BATTEN_OK && i < slopes.count; i++) {
        status = batten_curve_to_dimension(slopes.at[i]->curve, 3, &all->curves[i][1]);
        all->ribbons[i].slope = all->curves[i][1];
    }
    bat_objects_release(&slopes);
    return status;
}

static batten_status find_sides(const bat_run *run, const bat_objects *curves, sides *all)
{
    bat_objects surfaces;
    if (curves->count > BATTEN_SHEET_SIDES)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a hole of %d sides cannot be filled: 2 to %d",
                        curves->count, BATTEN_SHEET_SIDES);
    all->count = curves->count;
    for (int i = 0; i < curves->count; i++)
        all->ribbons[i].curve = curves->at[i]->curve;
    if (bat_has(run, "slopes"))
        return bat_has(run, "along") || bat_word(run, "continuity") != 1
                   ? bat_fail(
                         BATTEN_BAD_ARGUMENT,
                         "'slopes' give the tangent planes along the sides: with continuity "
                         "G1, and without 'along'")
                   : take_slopes(run, all);
    if (!bat_has(run, "along") || bat_word(run, "continuity") == 0)
        return BATTEN_OK;
    batten_status status = bat_gather(run, "along", BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    status = find_ribbons(run, all, &surfaces);
    bat_objects_release(&surfaces);
    return status;
}

/* ---- what was reached ---- */

static bat_worst_edges worst_of(const batten_surface_fill_report *reached)
{
    const bat_worst_edges none = {NULL, NULL, NULL};
    return bat_find_worst_edges(reached->count, reached->inner,
                                bat_find_worst_edges(reached->count, reached->outer, none));
}

static void report_edges(const bat_run *run, const bat_objects *curves,
                         const bat_edge_bounds *most, const batten_surface_fill_report *reached)
{
    const bat_worst_edges worst = worst_of(reached);
    bat_remark_worst_edges(run, curves, most->unit, &worst);
    for (int i = 0; i < reached->count; i++)
        bat_remark_excess(run, curves, most, &reached->outer[i]);
    for (int i = 0; i < reached->count; i++)
        bat_remark_excess(run, curves, most, &reached->inner[i]);
}

/* More than the bound that was stated is refused, on edges around the fill and within it. */
static batten_status check_curvature(const bat_run *run, const bat_objects *curves,
                                     const batten_surface_fill_report *reached)
{
    char name[160];
    if (!bat_has(run, "curvature"))
        return BATTEN_OK;
    const batten_fill_edge *edge = worst_of(reached).curvature;
    if (!edge || edge->curvature <= bat_number(run, "curvature"))
        return BATTEN_OK;
    bat_name_edge(curves, edge, name);
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "%s curvatures across differ by %.3g at (%g, %g, %g), and %g is allowed: the "
        "surfaces around ask for more than the fill can follow; allow more, or divide "
        "the hole",
        name, edge->curvature, edge->curvature_at[0], edge->curvature_at[1],
        edge->curvature_at[2], bat_number(run, "curvature"));
}

static const char *curve_name(const bat_objects *curves,
                              const batten_surface_fill_report *reached, int side)
{
    return curves->at[reached->outer[side % reached->count].curve]->name;
}

static void report(const bat_run *run, const bat_objects *curves,
                   const batten_surface_fill_options *options,
                   const batten_surface_fill_report *reached)
{
    const char *unit = batten_unit_name(bat_unit_metres(run));
    /* An angle of exactly the bound is met but for rounding; without curvature taken over
     * nothing bounds it. */
    const bat_edge_bounds most = {unit ? unit : "unit", options->tolerance,
                                  options->angle * 1.001 + 1e-9,
                                  options->curvature ? reached->most_curvature : HUGE_VAL};
    report_edges(run, curves, &most, reached);
    /* Less than a ten-thousandth of a radian is not seen. */
    if (reached->corner_angle > 1e-4)
        bat_note(run,
                 "in the corner between '%.100s' and '%.100s' the surfaces around have planes "
                 "that differ by %.3g degree%s",
                 curve_name(curves, reached, reached->corner + reached->count - 1),
                 curve_name(curves, reached, reached->corner), reached->corner_angle * DEGREES,
                 bat_plural_real(reached->corner_angle * DEGREES, 3));
    if (reached->twisted > 0)
        bat_remark(run, "at %d corner%s the surfaces around twist against each other",
                   reached->twisted, bat_plural(reached->twisted));
    if (reached->flat_corners > 0)
        bat_remark(run,
                   "at %d corner%s the sides continue smoothly: the fill has no normal there",
                   reached->flat_corners, bat_plural(reached->flat_corners));
    if (reached->folded)
        bat_note(run, "the fill folds over near (%g, %g, %g)", reached->fold_at[0],
                 reached->fold_at[1], reached->fold_at[2]);
}

/* How far the fill is from the curves that were given: the sides that it was made of from
 * these, and it from the sides. */
static double missed(const batten_surface_fill_report *reached)
{
    double gap = 0;
    for (int i = 0; i < reached->count; i++)
        gap = bat_max(gap, reached->outer[i].gap);
    return reached->approximation + gap;
}

static batten_status put_all(bat_run *run, int count, batten_surface **surfaces)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count; i++) {
        char name[300];
        snprintf(name, sizeof name, "%.256s.%d", run->name, i + 1);
        const batten_object like = {.name = name, .layer = ""};
        status = bat_put_surface_like(run, status, surfaces[i], &like);
    }
    return status;
}

static batten_status fill_by_surfaces(bat_run *run, const bat_objects *curves, const sides *all)
{
    batten_surface_fill_options options = batten_surface_fill_defaults();
    batten_surface *surfaces[BATTEN_FILL_SIDES] = {NULL};
    batten_surface_fill_report *reached = bat_array(1, sizeof *reached);
    if (!reached)
        return BATTEN_OUT_OF_MEMORY;
    options.tolerance = all->within;
    options.angle = bat_number(run, "angle");
    options.curvature = bat_word(run, "continuity") == 2;
    options.form =
        bat_has(run, "form") ? (batten_fill_form)bat_word(run, "form") : BATTEN_FILL_SPLIT;
    options.may_fold = bat_yes(run, "folds");
    options.as_splines = true;
    batten_status status =
        batten_surface_fill(all->count, all->ribbons, &options, reached, surfaces);
    if (status == BATTEN_OK) {
        report(run, curves, &options, reached);
        status = check_curvature(run, curves, reached);
        for (int i = 0; status != BATTEN_OK && i < reached->count; i++)
            batten_surface_unref(surfaces[i]);
    }
    if (status == BATTEN_OK) {
        bat_report_error(run, missed(reached), missed(reached));
        status = put_all(run, reached->count, surfaces);
    }
    bat_release(reached);
    return status;
}

/* ---- which form ---- */

/* The word after those of batten_fill_form. */
static const int sheet_form = BATTEN_FILL_CHARROT_GREGORY + 1;

static batten_status one_sheet(bat_run *run, const bat_objects *curves, const sides *all)
{
    const bat_hole hole = {all->count, all->ribbons, all->within};
    return bat_fill_by_sheet(run, curves, &hole);
}

/* May another form do better than what failed so? */
static bool may_do_better(batten_status status)
{
    return status == BATTEN_NOT_COMPATIBLE || status == BATTEN_TOLERANCE_NOT_MET;
}

/* Split, or a sheet where that cannot be; with curvature the other way around. */
static batten_status fill_either_way(bat_run *run, const bat_objects *curves, const sides *all)
{
    const bool sheet_first = bat_word(run, "continuity") == 2;
    char first[300], second[300];
    const batten_status status = (sheet_first ? one_sheet : fill_by_surfaces)(run, curves, all);
    if (!may_do_better(status))
        return status;
    snprintf(first, sizeof first, "%s", batten_message());
    const batten_status other = (sheet_first ? fill_by_surfaces : one_sheet)(run, curves, all);
    if (other == BATTEN_OK) {
        bat_remark(run,
                   sheet_first ? "surfaces around a middle, not one trimmed surface: %s"
                               : "one trimmed surface, not several around a middle: %s",
                   first);
        return BATTEN_OK;
    }
    snprintf(second, sizeof second, "%s", batten_message());
    if (!may_do_better(other) || strcmp(first, second) == 0)
        return other;
    return bat_fail(status, "%s; as one trimmed surface: %s", sheet_first ? second : first,
                    sheet_first ? first : second);
}

static batten_status fill_hole(bat_run *run, const bat_objects *curves, const sides *all)
{
    const bool form_given = bat_has(run, "form"), inside = bat_has(run, "through");
    if (form_given && bat_word(run, "form") == sheet_form)
        return one_sheet(run, curves, all);
    if (form_given && inside)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'through' needs the form 'sheet': the others go through their sides alone");
    if (form_given)
        return fill_by_surfaces(run, curves, all);
    if (inside || curves->count > BATTEN_FILL_SIDES)
        return one_sheet(run, curves, all);
    return fill_either_way(run, curves, all);
}

static batten_status run_fill(bat_run *run)
{
    bat_objects curves;
    sides *all = bat_array(1, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    all->within = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = bat_gather(run, "fill", BAT_CURVES, &curves);
    if (status == BATTEN_OK) {
        status = find_sides(run, &curves, all);
        if (status == BATTEN_OK)
            status = fill_hole(run, &curves, all);
        free_sides(all);
        bat_objects_release(&curves);
    }
    bat_release(all);
    return status;
}

const bat_feature bat_feature_fill = {
    .shown =
        {"fill", "Surfaces in a hole of 2 to 64 sides",
         "Form 'split': as many surfaces as sides, 2 to 8, named feature.1 ..., that meet in the\n"
         "middle of the hole. They have the same tangent plane where they meet, and that of the\n"
         "surfaces 'along' the sides, or that of 'slopes'; what is left free bends as little as\n"
         "possible. Sides with corners are divided there. A note says where gaps, angles and\n"
         "differences of curvature are largest. A fill that folds over is refused; so is one with G2\n"
         "when the curvatures around it contradict each other so much that curvature would jump\n"
         "between its own surfaces by more than the largest curvature around it (or 'curvature').\n"
         "Form 'sheet': one surface over the mean plane of the hole, trimmed by the sides, a body with\n"
         "one face. The outline may be re-entrant, of up to 64 sides, and the sheet goes 'through'\n"
         "points and curves inside. Its curvature is continuous inside, four derivatives are; sides,\n"
         "planes and curvatures around it are met within 'within', 'angle' and 'curvature' (by default\n"
         "a hundredth of the largest), or it is refused with the figure. Sides and planes steeper than\n"
         "84 degrees to the mean plane are refused.\n"
         "Without 'form' it is split, and a sheet where that folds or has a re-entrant corner, goes\n"
         "'through' something or has more than 8 sides; with G2 a sheet, and split where that cannot\n"
         "be. A remark says which and why.",
         "features:\n"
         "  a: {polyline: [[0, 0, 0], [2 m, 0, 0.2 m]]}\n"
         "  b: {polyline: [[2 m, 0, 0.2 m], [1 m, 1.8 m, 0]]}\n"
         "  c: {polyline: [[1 m, 1.8 m, 0], [0, 0, 0]]}\n"
         "  patch: {fill: [a, b, c]}\n",
         "[Utah74 paper 11] [CK83]", "batten_surface_fill", BAT_PARAMETERS(parameters), false,
         .also =
             "N-sided patch, hole filling, n-sided, patch, cap, Kato, Charrot Gregory, surface fill",
         .formula =
             "    ∫∫ |third derivatives|² + the squared jumps of second derivatives between the surfaces → minimum over what the sides and the planes along them leave free; of a sheet ∫∫ |second derivatives|² + |third derivatives|²/100 of its height over the mean plane",
         .promise =
             "Tangent planes are the same where the surfaces meet each other and their neighbours; what is left is noted. A sheet cannot fold, and its curvature is continuous inside."},
    .run = run_fill,
    .beside = "along slopes"};
