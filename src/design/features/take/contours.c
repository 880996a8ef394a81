/* The feature 'contours': lines of equal height, curvature or light on surfaces. */
#include "design/shared/field.h"

#include <batten/approximate.h>
#include <batten/standard.h>
#include <stdio.h>
#include <string.h>

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
     "the direction to the eye that sees reflection lines"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how close the curves are to the contours; the tolerance of the design by default"},
    {"as", BATTEN_VALUE_WORD, false, false, "curves", "curves polylines",
     "smooth curves with few control points, or chords"},
};

typedef struct {
    batten_surface_field field;
    int level_count;
    double *levels;
    double within;
    bool smooth;
    double error;
    int open; /* contours that do not close */
} wanted;

/* Chords, or cubics. */
static batten_status find(const bat_run *run, const batten_object *object, const wanted *w,
                          double tolerance, bool cubics, batten_contours *out)
{
    if (object->kind == BATTEN_OBJECT_TRIANGLES)
        return (cubics ? batten_triangles_smooth_contours : batten_triangles_contours)(
            object->triangles, &w->field, (batten_levels){w->level_count, w->levels}, tolerance,
            run->job, out);
    return (cubics ? batten_surface_smooth_contours : batten_surface_contours)(
        object->surface, &w->field, (batten_levels){w->level_count, w->levels}, tolerance,
        run->job, out);
}

/* ---- levels ---- */

static batten_status copy_levels(const bat_argument *given, wanted *w)
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
static batten_status choose_levels(double least, double greatest, double spacing, wanted *w)
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
                                 const wanted *w, double *least, double *greatest)
{
    batten_contours none = {0};
    const batten_status status = find(run, surface, w, w->within, false, &none);
    if (status != BATTEN_OK)
        return status;
    *least = bat_min(*least, none.least);
    *greatest = bat_max(*greatest, none.greatest);
    batten_contours_release(&none);
    return BATTEN_OK;
}

/* Common to all surfaces, so that their contours match. */
static batten_status find_levels(const bat_run *run, const bat_objects *surfaces, wanted *w)
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
static batten_status refuse_levels(const bat_run *run, const bat_objects *surfaces, wanted *w)
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

static batten_status make_polyline(const batten_polyline *line, batten_curve **out)
{
    const int count = line->count + line->closed;
    double *points = bat_array3((size_t)count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 3 * count; i++)
        points[i] = line->points[i % (3 * line->count)];
    const batten_status status = batten_curve_polyline((batten_points){3, count, points}, out);
    bat_release(points);
    return status;
}

/* A smooth curve through the dense points, when that keeps within the tolerance between them
 * too; else the polyline. `rise` is how far its chords are from the contour. */
static batten_status make_curve(const wanted *w, const batten_polyline *line, double rise,
                                double *error, batten_curve **out)
{
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report;
    options.tolerance = 0.5 * w->within;
    options.corner = 20 * BAT_PI / 180;
    options.closed = line->closed;
    options.method = BATTEN_WITHIN_BEZIER;
    if (w->smooth && line->count >= 4) {
        const batten_status status = batten_curve_within(
            (batten_points){3, line->count, line->points}, &options, NULL, &report, out);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK) {
            *error = bat_max(report.error, report.apart) + rise;
            if (*error <= w->within)
                return BATTEN_OK;
            batten_curve_unref(*out);
        }
    }
    *error = rise;
    return make_polyline(line, out);
}

static double distance(const double *a, const double *b)
{
    return bat_hypot(bat_hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The lengths of the spans, so that derivatives agree where tangents do. */
static void pace(int count, const double *points, double *breaks)
{
    double speed = 0;
    for (int i = 0; i < count; i++) {
        const double *p = points + 9 * i;
        const double own = distance(p, p + 9);
        const double paced = 3 * distance(p, p + 3) / (speed > 0 ? speed : 1);
        const double length = speed > 0 && paced > own / 64 && paced < 64 * own ? paced : own;
        breaks[i + 1] = breaks[i] + length;
        speed = 3 * distance(p + 6, p + 9) / length;
    }
}

static batten_status join_cubics(const batten_contour *contour, batten_curve **out)
{
    const batten_polyline *line = &contour->line;
    const int count = line->closed ? line->count : line->count - 1;
    double *points = bat_array3((size_t)count + 1, 9, sizeof *points);
    double *breaks = bat_array((size_t)count + 1, sizeof *breaks);
    batten_status status = points && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i <= count; i++) {
        const int k = i % line->count;
        double *to = points + 9 * i;
        memcpy(to, line->points + 3 * k, 3 * sizeof *to);
        memcpy(to + 3, contour->arms + 6 * k + 3, 3 * sizeof *to);
        memcpy(to + 6, contour->arms + 6 * ((k + 1) % line->count), 3 * sizeof *to);
    }
    if (status == BATTEN_OK) {
        pace(count, points, breaks);
        status =
            batten_curve_from_bezier(3, (batten_pieces){3, count, breaks}, points, NULL, out);
    }
    bat_release(breaks);
    bat_release(points);
    return status;
}

static batten_status put_contour(bat_run *run, const batten_object *object, wanted *w,
                                 const batten_contour *contour, double rise)
{
    batten_curve *curve = NULL;
    double error = rise;
    char name[240];
    batten_object like = *object;
    batten_text_print(name, sizeof name, "%.180s at %.6g", object->name,
                      w->levels[contour->level]);
    like.name = name;
    const batten_status status = contour->arms
                                     ? join_cubics(contour, &curve)
                                     : make_curve(w, &contour->line, rise, &error, &curve);
    w->error = bat_max(w->error, error);
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

static double size_of(const batten_object *object)
{
    const batten_box box = object->kind == BATTEN_OBJECT_TRIANGLES
                               ? batten_triangles_box(object->triangles)
                               : batten_surface_box(object->surface);
    const double low[3] = {box.low.x, box.low.y, box.low.z},
                 high[3] = {box.high.x, box.high.y, box.high.z};
    return distance(low, high);
}

/* Smooth curves are fitted to chords; where these would be too many, cubics stand between
 * points with the tangents of the contour. */
static batten_status put_contours(bat_run *run, const batten_object *object, wanted *w)
{
    batten_contours found = {0};
    const bool cubics = w->smooth && w->within < 1e-6 * size_of(object);
    const double within = w->smooth && !cubics ? 0.25 * w->within : w->within;
    batten_status status = find(run, object, w, within, cubics, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        w->open += !found.lines[i].line.closed;
        status = put_contour(run, object, w, &found.lines[i], found.error);
    }
    if (status == BATTEN_OK)
        tell_criticals(run, object, &found);
    batten_contours_release(&found);
    return status;
}

static bool is_of_light_line(const wanted *w)
{
    return w->field.kind == BATTEN_FIELD_HIGHLIGHT || w->field.kind == BATTEN_FIELD_REFLECTION;
}

static batten_status run_contours(bat_run *run)
{
    bat_objects surfaces;
    batten_status status = bat_gather(run, "contours", BAT_SURFACES | BAT_TRIANGLES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    wanted w = {
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
         "'draft'; 'highlight' and 'reflection' lines belong to a line of light 'through' a point\n"
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
    .run = run_contours};
