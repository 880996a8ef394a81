/* The feature 'fill': surfaces in a hole of 2 to 8 sides. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/fill.h>
#include <batten/text.h>
#include <stdio.h>

#define DEGREES (180 / BAT_PI)

static const batten_parameter parameters[] = {
    {"fill", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the sides, in any order"},
    {"along", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "surfaces around the hole: the fill continues smoothly those that have a side as an edge"},
    {"continuity", BATTEN_VALUE_WORD, false, false, "G1", "G0 G1 G2",
     "what the fill takes over from them: the edge, the tangent planes, the curvature"},
    {"form", BATTEN_VALUE_WORD, false, false, "split", "split kato charrot-gregory",
     "exact surfaces; or splines near a formula over a polygon"},
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
    batten_ribbon ribbons[BATTEN_FILL_SIDES];
    batten_curve *curves[BATTEN_FILL_SIDES][3];
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

static batten_status find_sides(const bat_run *run, const bat_objects *curves, sides *all)
{
    bat_objects surfaces;
    if (curves->count > BATTEN_FILL_SIDES)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a hole of %d sides cannot be filled: 2 to %d",
                        curves->count, BATTEN_FILL_SIDES);
    all->count = curves->count;
    for (int i = 0; i < curves->count; i++)
        all->ribbons[i].curve = curves->at[i]->curve;
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

/* An edge by the names that the design knows. */
static void name_edge(const bat_objects *curves, const batten_fill_edge *edge, char name[160])
{
    if (edge->curve >= 0)
        snprintf(name, 160, "along '%.100s'", curves->at[edge->curve]->name);
    else
        snprintf(name, 160, "between surfaces %d and %d", edge->first + 1, edge->second + 1);
}

typedef struct {
    const char *unit;
    double gap, angle, curvature; /* what an edge may have */
} bounds;

/* The edge with the largest gap, angle, curvature; NULL where none has one. */
typedef struct {
    const batten_fill_edge *gap, *angle, *curvature;
} worst_edges;

static void keep_worst(const batten_fill_edge *edge, worst_edges *worst)
{
    if (!worst->gap || edge->gap > worst->gap->gap)
        worst->gap = edge;
    if (edge->has_slope && (!worst->angle || edge->angle > worst->angle->angle))
        worst->angle = edge;
    if (edge->has_curvature &&
        (!worst->curvature || edge->curvature > worst->curvature->curvature))
        worst->curvature = edge;
}

/* One line: the worst gap, angle and curvature, each where it is. */
static void remark_worst(const bat_run *run, const bat_objects *curves, const char *unit,
                         const worst_edges *worst)
{
    char gap[160], text[3][360] = {"", "", ""};
    name_edge(curves, worst->gap, gap);
    if (worst->angle) {
        const double *at = worst->angle->angle_at;
        char name[160];
        name_edge(curves, worst->angle, name);
        snprintf(text[0], sizeof text[0],
                 "; tangent planes differ by up to %.2g degree%s (%s, at %g, %g, %g)",
                 worst->angle->angle * DEGREES,
                 bat_plural_real(worst->angle->angle * DEGREES, 2), name, at[0], at[1], at[2]);
    }
    if (worst->curvature) {
        const double *at = worst->curvature->curvature_at;
        char name[160];
        name_edge(curves, worst->curvature, name);
        snprintf(text[1], sizeof text[1],
                 "; curvatures across by up to %.3g per %s (%s, at %g, %g, %g)",
                 worst->curvature->curvature, unit, name, at[0], at[1], at[2]);
    }
    bat_remark(run, "gaps of up to %.2g %s (%s)%s%s", worst->gap->gap, unit, gap, text[0],
               text[1]);
}

/* An edge that has more than it may. */
static void remark_excess(const bat_run *run, const bat_objects *curves, const bounds *most,
                          const batten_fill_edge *edge)
{
    char name[160];
    name_edge(curves, edge, name);
    if (edge->gap > most->gap)
        bat_remark(run, "%s: a gap of %.3g %s at (%g, %g, %g), more than %g", name, edge->gap,
                   most->unit, edge->gap_at[0], edge->gap_at[1], edge->gap_at[2], most->gap);
    if (edge->has_slope && edge->angle > most->angle)
        bat_remark(run, "%s: tangent planes differ by %.3g degree%s at (%g, %g, %g)", name,
                   edge->angle * DEGREES, bat_plural_real(edge->angle * DEGREES, 3),
                   edge->angle_at[0], edge->angle_at[1], edge->angle_at[2]);
    if (edge->has_curvature && edge->curvature > most->curvature)
        bat_remark(run, "%s: curvatures across differ by %.3g per %s at (%g, %g, %g)", name,
                   edge->curvature, most->unit, edge->curvature_at[0], edge->curvature_at[1],
                   edge->curvature_at[2]);
}

static void report_edges(const bat_run *run, const bat_objects *curves, const bounds *most,
                         const batten_surface_fill_report *reached)
{
    worst_edges worst = {NULL, NULL, NULL};
    for (int i = 0; i < 2 * reached->count; i++)
        keep_worst(i % 2 ? &reached->inner[i / 2] : &reached->outer[i / 2], &worst);
    remark_worst(run, curves, most->unit, &worst);
    for (int i = 0; i < reached->count; i++)
        remark_excess(run, curves, most, &reached->outer[i]);
    for (int i = 0; i < reached->count; i++)
        remark_excess(run, curves, most, &reached->inner[i]);
}

/* More than the bound that was stated is refused, on edges around the fill and within it. */
static batten_status check_curvature(const bat_run *run, const bat_objects *curves,
                                     const batten_surface_fill_report *reached)
{
    worst_edges worst = {NULL, NULL, NULL};
    char name[160];
    if (!bat_has(run, "curvature"))
        return BATTEN_OK;
    for (int i = 0; i < 2 * reached->count; i++)
        keep_worst(i % 2 ? &reached->inner[i / 2] : &reached->outer[i / 2], &worst);
    const batten_fill_edge *edge = worst.curvature;
    if (!edge || edge->curvature <= bat_number(run, "curvature"))
        return BATTEN_OK;
    name_edge(curves, edge, name);
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
    const bounds most = {unit ? unit : "unit", options->tolerance,
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

static batten_status fill(bat_run *run, const bat_objects *curves, const sides *all)
{
    batten_surface_fill_options options = batten_surface_fill_defaults();
    batten_surface *surfaces[BATTEN_FILL_SIDES] = {NULL};
    batten_surface_fill_report *reached = bat_array(1, sizeof *reached);
    if (!reached)
        return BATTEN_OUT_OF_MEMORY;
    options.tolerance = all->within;
    options.angle = bat_number(run, "angle");
    options.curvature = bat_word(run, "continuity") == 2;
    options.form = (batten_fill_form)bat_word(run, "form");
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

static batten_status run_fill(bat_run *run)
{
    bat_objects curves;
    sides all = {.within =
                     bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run)};
    batten_status status = bat_gather(run, "fill", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    status = find_sides(run, &curves, &all);
    if (status == BATTEN_OK)
        status = fill(run, &curves, &all);
    free_sides(&all);
    bat_objects_release(&curves);
    return status;
}

const bat_feature bat_feature_fill = {
    .shown =
        {"fill", "Surfaces in a hole of 2 to 8 sides",
         "As many surfaces as sides, named feature.1, feature.2 ..., that meet in the middle of the\n"
         "hole. They have the same tangent plane where they meet, and that of the surfaces 'along'\n"
         "the sides; what is left free bends as little as possible. Sides with corners are divided\n"
         "there. A note says where gaps, angles and differences of curvature are largest. A fill\n"
         "that folds over is refused; so is one with G2 when the curvatures around it contradict\n"
         "each other so much that curvature would jump between its own surfaces by more than the\n"
         "largest curvature around it, or than 'curvature' says.",
         "features:\n"
         "  a: {polyline: [[0, 0, 0], [2 m, 0, 0.2 m]]}\n"
         "  b: {polyline: [[2 m, 0, 0.2 m], [1 m, 1.8 m, 0]]}\n"
         "  c: {polyline: [[1 m, 1.8 m, 0], [0, 0, 0]]}\n"
         "  patch: {fill: [a, b, c]}\n",
         "[Utah74 paper 11] [CK83]", "batten_surface_fill", BAT_PARAMETERS(parameters), false,
         .also =
             "N-sided patch, hole filling, n-sided, patch, cap, Kato, Charrot Gregory, surface fill",
         .formula =
             "    ∫∫ |third derivatives|² + the squared jumps of second derivatives between the surfaces → minimum over what the sides and the planes along them leave free",
         .promise =
             "Tangent planes are the same where the surfaces meet each other and their neighbours; what is left is noted."},
    .run = run_fill};
