/* The feature 'contours': lines of equal height, curvature or light on surfaces. */
#include "design/features/take/contour_curves.h"
#include "design/shared/field.h"

/* At most this many critical levels are reported of one surface, and this many levels chosen. */
enum { MOST_TOLD = 8, MOST_LEVELS = 1000 };

static const batten_parameter parameters[] = {
    {"contours", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "surfaces, triangles"},
    {"of", BATTEN_VALUE_WORD, false, false, "height", BAT_FIELD_WORDS,
     "what is equal along them"},
    {"levels", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "its values, increasing: lengths for heights and light lines, else numbers"},
    BAT_FIELD_PARAMETERS,
    {"eye", BATTEN_VALUE_POINT, false, false, "x", NULL,
     "the direction to the eye that sees reflection lines or a zebra"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how close the curves are to the contours; the tolerance of the design by default"},
    {"as", BATTEN_VALUE_WORD, false, false, "curves", "curves polylines",
     "smooth curves with few control points, or chords"},
};

/* ---- levels ---- */

static batten_status copy_levels(const bat_argument *given, bat_contours_wanted *w)
{
    w->level_count = given->count;
    w->levels = bat_array((size_t)given->count, sizeof *w->levels);
    for (int i = 0; w->levels && i < given->count; i++)
        w->levels[i] = given->items[i].number[0];
    return w->levels ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* But for rounding: curvatures keep nine digits. */
static bool is_constant(double least, double greatest)
{
    return !(greatest - least > 1e-9 * bat_max(fabs(least), fabs(greatest)));
}

/* Multiples of the spacing from the least value to the greatest; without one of the smallest
 * of 1, 2, 5, 10 ... that gives twelve at most. */
static batten_status choose_levels(double least, double greatest, double spacing,
                                   bat_contours_wanted *w)
{
    double step = spacing;
    if (is_constant(least, greatest))
        return bat_fail(BATTEN_NOT_FOUND, "the field is %g everywhere: it has no levels",
                        least);
    if (!(step > 0)) {
        const double wide = (greatest - least) / 12,
                     power = bat_pow(10, floor(bat_log10(wide)));
        step = wide <= power       ? power
               : wide <= 2 * power ? 2 * power
               : wide <= 5 * power ? 5 * power
                                   : 10 * power;
    }
    const double first = ceil(least / step), last = floor(greatest / step);
    if (!isfinite(step) || last < first)
        return bat_fail(BATTEN_NOT_FOUND,
                        "the field runs from %g to %g: no level %g apart lies between", least,
                        greatest, step);
    if (!(last - first < MOST_LEVELS))
        return bat_fail(BATTEN_TOO_LARGE, "levels %g apart from %g to %g: more than %d", step,
                        least, greatest, MOST_LEVELS);
    w->level_count = (int)(last - first) + 1;
    w->levels = bat_array((size_t)w->level_count, sizeof *w->levels);
    for (int i = 0; w->levels && i < w->level_count; i++)
        w->levels[i] = (first + i) * step;
    return w->levels ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status widen_range(const bat_run *run, const batten_object *surface,
                                 const bat_contours_wanted *w, double *least, double *greatest)
{
    batten_contours none = {0};
    const batten_status status = bat_contours_find(run, surface, w, w->within, false, &none);
    if (status != BATTEN_OK)
        return status;
    *least = bat_min(*least, none.least);
    *greatest = bat_max(*greatest, none.greatest);
    batten_contours_release(&none);
    return BATTEN_OK;
}

/* Common to all surfaces, so that their contours match. */
static batten_status find_levels(const bat_run *run, const bat_objects *surfaces,
                                 bat_contours_wanted *w)
{
    const bat_argument *given = bat_argument_of(run, "levels");
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    if (given->count > 0)
        return copy_levels(given, w);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < surfaces->count && status == BATTEN_OK; i++)
        status = widen_range(run, surfaces->at[i], w, &least, &greatest);
    return status == BATTEN_OK ? choose_levels(least, greatest, bat_number(run, "spacing"), w)
                               : status;
}

/* No curve was made: why, by the values that the field has. */
static batten_status refuse_levels(const bat_run *run, const bat_objects *surfaces,
                                   bat_contours_wanted *w)
{
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < surfaces->count && status == BATTEN_OK; i++)
        status = widen_range(run, surfaces->at[i], w, &least, &greatest);
    if (status != BATTEN_OK)
        return status;
    if (is_constant(least, greatest))
        return bat_fail(BATTEN_NOT_FOUND,
                        "the field is %g everywhere: no lines lie at its levels, for where it "
                        "has one it has it on the whole surface",
                        least);
    return bat_fail(BATTEN_NOT_FOUND,
                    "no level from %g to %g is met by the field, which runs from %g to %g",
                    w->levels[0], w->levels[w->level_count - 1], least, greatest);
}

/* ---- curves ---- */

static batten_status put_contour(bat_run *run, const batten_object *object,
                                 bat_contours_wanted *w, const batten_contour *contour,
                                 double rise)
{
    batten_curve *curve = NULL;
    char name[240];
    batten_object like = *object;
    batten_text_print(name, sizeof name, "%.180s at %.6g", object->name,
                      w->levels[contour->level]);
    like.name = name;
    const batten_status status = bat_contour_curve(w, contour, rise, &curve);
    return bat_put_curve_like(run, status, curve, &like, false);
}

static void tell_criticals(const bat_run *run, const batten_object *object,
                           const batten_contours *found)
{
    static const char *const names[] = {"least", "saddle", "greatest"};
    for (int i = 0; i < found->critical_count && i < MOST_TOLD; i++) {
        const batten_critical *c = &found->critical[i];
        bat_remark(run, "'%s': critical level %.6g, %s, at (%.4g, %.4g, %.4g)", object->name,
                   c->value, names[c->kind], c->point.x, c->point.y, c->point.z);
    }
    if (found->critical_count > MOST_TOLD)
        bat_remark(run, "'%s': %d critical levels in all", object->name, found->critical_count);
}

static batten_status put_contours(bat_run *run, const batten_object *object,
                                  bat_contours_wanted *w)
{
    batten_contours found = {0};
    batten_status status = bat_contours_find_fine(run, object, w, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        status = put_contour(run, object, w, &found.lines[i], found.error);
    if (status == BATTEN_OK)
        tell_criticals(run, object, &found);
    batten_contours_release(&found);
    return status;
}

static bool is_of_light_line(const bat_contours_wanted *w)
{
    return w->field.kind == BATTEN_FIELD_HIGHLIGHT || w->field.kind == BATTEN_FIELD_REFLECTION;
}

static batten_status run_contours(bat_run *run)
{
    bat_objects surfaces;
    batten_status status = bat_gather(run, "contours", BAT_SURFACES | BAT_TRIANGLES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    bat_contours_wanted w = {
        .field =
            bat_field_of(run, (batten_field_kind)bat_word(run, "of"), bat_point(run, "eye")),
        .within = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run),
        .smooth = bat_word(run, "as") == 0};
    status = find_levels(run, &surfaces, &w);
    for (int i = 0; i < surfaces.count && status == BATTEN_OK; i++) {
        const int before = batten_model_count(run->model);
        status = put_contours(run, surfaces.at[i], &w);
        if (status == BATTEN_OK && batten_model_count(run->model) == before)
            bat_remark(run, "'%s' meets none of the levels", surfaces.at[i]->name);
    }
    if (status == BATTEN_OK && batten_model_count(run->model) == 0)
        status = refuse_levels(run, &surfaces, &w);
    if (status == BATTEN_OK && w.open > 0 && is_of_light_line(&w))
        bat_remark(run,
                   "%d line%s; one that does not end on a rim ends where the normal or the "
                   "reflected ray is within 5.7 degrees of the line of light",
                   w.open, w.open == 1 ? " is open" : "s are open");
    if (status == BATTEN_OK && w.error > w.within)
        bat_note(run,
                 "the contours are off by up to %g, more than %g: somewhere the field jumps or "
                 "has no value",
                 w.error, w.within);
    if (status == BATTEN_OK)
        bat_report_error(run, w.error, w.error);
    bat_release(w.levels);
    bat_objects_release(&surfaces);
    return status;
}

const bat_feature bat_feature_contours = {
    .shown =
        {"contours", "Lines of equal height, curvature or light on surfaces",
         "They lie on the true surface, are closed or end on its rim, and run straight through\n"
         "saddles. Silhouettes, parting lines and isophotes are contours of 'isophote' and\n"
         "'draft', that of 'isophote' at 0 with the direction of the eye, or of 'silhouette' at 0 as\n"
         "seen from a point, 'through'; 'zebra' lines are the edges of stripes that tubes along\n"
         "'direction' show in a mirror; 'absolute' is |kappa1| + |kappa2|. 'highlight' and\n"
         "'reflection' lines belong to a line of light 'through' a point\n"
         "along 'direction'. These have no value, and lines end, where the normal or the reflected\n"
         "ray is within 5.7 degrees of that direction: a tube of light is of finite length.\n"
         "Stationary points of the field, where lines appear, vanish or cross, are noted.",
         "features:\n"
         "  ring: {torus: 3 m, minor: 1 m}\n"
         "  waterlines: {contours: ring, levels: [0, 0.5 m]}\n"
         "  shade: {contours: ring, of: isophote, direction: [1, 1, 2], spacing: 0.25}\n",
         "[BeiChen94]", "batten_surface_contours", BAT_PARAMETERS(parameters), false,
         .also =
             "isophotes, zebra, reflection lines, highlight lines, silhouette, level curves, curvature lines, draft, parting line, waterlines"},
    .run = run_contours,
    .displacing = "contours"};
