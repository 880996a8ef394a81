/* The output 'compare': curves through the same points, side by side. */
#include "design/shared/rows.h"
#include "design/shared/through.h"
#include "design/text/document.h"

#include <batten/measure.h>
#include <batten/text.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"compare", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "features that make curves; each has a panel"},
    {"comb", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "show the curvature of the curves"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "above the picture"},
    {"width", BATTEN_VALUE_COUNT, false, false, "1600", NULL, "pixels, or points of 1/72 inch"},
    {"height", BATTEN_VALUE_COUNT, false, false, "0", NULL, "0: follows the shape"},
};

/* What the curves of one feature add up to. */
typedef struct {
    const batten_feature_result *feature;
    int curves, inflections, extrema, corners, jumps;
    bool in_space; /* inflections and extrema have no meaning for one of them */
    double length, energy, energy_error, variation, variation_error, sharpest;
    char lines[3][160];
    const char *shown[3];
} column;

/* ---- measuring ---- */

static void add_compare(const batten_fairness *fairness, double length, bool in_space,
                        column *c)
{
    c->curves++;
    c->inflections += fairness->inflections;
    c->extrema += fairness->curvature_extrema;
    c->corners += fairness->corners;
    c->jumps += fairness->curvature_jumps;
    c->in_space = c->in_space || in_space;
    c->length += length;
    c->energy += fairness->energy;
    c->energy_error += fairness->energy_error;
    c->variation += fairness->variation;
    c->variation_error += fairness->variation_error;
    c->sharpest = c->sharpest > fairness->max_curvature ? c->sharpest : fairness->max_curvature;
}

/* A plane curve that is not a NURBS curve is measured in its own form. */
static batten_status add_chain(const batten_object *object, column *c)
{
    batten_fairness fairness;
    double length = 0;
    const batten_chain *chain = object->chain;
    batten_status status = batten_chain_fairness(
        chain, (batten_points){batten_chain_dimension(chain), 0, NULL}, NULL, &fairness);
    if (status == BATTEN_OK)
        status = batten_chain_length(chain, NULL, &length);
    if (status == BATTEN_OK)
        add_compare(&fairness, length, false, c);
    return status;
}

/* A curve in the plane that it lies in; as it is where there is none. */
static batten_status lay_in_plane(const batten_curve *curve, batten_curve **out, bool *in_space)
{
    const int n = batten_curve_point_count(curve);
    const bool flat = batten_curve_dimension(curve) < 3;
    const int axis = flat ? 2 : bat_flat_axis(n, batten_curve_points(curve));
    batten_affine oblique;
    if (axis < 0 && bat_plane_find(n, batten_curve_points(curve), &oblique))
        return bat_plane_curve(&oblique, curve, out);
    *in_space = axis < 0;
    return bat_curve_in_plane(curve, axis, out);
}

static batten_status add_curve(const bat_run *run, const batten_object *object, column *c)
{
    batten_curve *plane = NULL;
    batten_fairness_options options = batten_fairness_defaults();
    batten_fairness fairness;
    double length = 0;
    batten_frame frame;
    options.error = bat_chain_error(run, object);
    if (object->chain && (batten_chain_dimension(object->chain) < 3 ||
                          batten_chain_frame(object->chain, &frame)))
        return add_chain(object, c);
    bool in_space = false;
    batten_status status = lay_in_plane(object->curve, &plane, &in_space);
    if (status == BATTEN_OK)
        status = batten_curve_fairness(plane,
                                       (batten_points){batten_curve_dimension(plane), 0, NULL},
                                       &options, &fairness);
    if (status == BATTEN_OK)
        status =
            /* For a table of four digits; the bound grows with the number of spans. */
            batten_curve_length(plane, 1e-9 * batten_curve_point_count(plane), NULL, &length);
    if (status == BATTEN_OK)
        add_compare(&fairness, length, in_space, c);
    batten_curve_unref(plane);
    return status;
}

/* A count, or a dash where it has no meaning. */
static void count_text(const column *c, int count, char *text, size_t size)
{
    if (c->in_space)
        snprintf(text, size, "-");
    else
        snprintf(text, size, "%d", count);
}

/* What is printed with five digits is known to them. */
#define KNOWN 5e-6

/* "energy 5.5 1/m   variation 3 1/m^3", or why they are infinite. */
static void describe_bending(column *c, const char *unit)
{
    char energy[64], variation[64];
    if (c->corners > 0)
        snprintf(energy, sizeof energy, "infinite (corners: %d)", c->corners);
    else if (c->energy_error > KNOWN * c->energy)
        snprintf(energy, sizeof energy, "not known (infinite, or nearly so)");
    else
        batten_text_print(energy, sizeof energy, "%.5g 1/%s", c->energy, unit);
    if (c->jumps > 0)
        snprintf(variation, sizeof variation, "infinite (jumps of curvature: %d)", c->jumps);
    else if (c->corners > 0)
        snprintf(variation, sizeof variation, "infinite");
    else if (c->variation_error > KNOWN * c->variation)
        snprintf(variation, sizeof variation, "not known (infinite, or nearly so)");
    else
        batten_text_print(variation, sizeof variation, "%.4g 1/%s\xC2\xB3", c->variation, unit);
    snprintf(c->lines[0], sizeof c->lines[0], "energy %s   variation %s", energy, variation);
}

static void describe(column *c, const char *unit)
{
    char inflections[16], extrema[16], sharpest[48];
    count_text(c, c->inflections, inflections, sizeof inflections);
    count_text(c, c->extrema, extrema, sizeof extrema);
    describe_bending(c, unit);
    if (isinf(c->sharpest))
        snprintf(sharpest, sizeof sharpest, "without bound");
    else
        batten_text_print(sharpest, sizeof sharpest, "%.3g 1/%s", c->sharpest, unit);
    snprintf(c->lines[1], sizeof c->lines[1],
             "inflections %s   extrema of curvature %s   max \xCE\xBA %s", inflections, extrema,
             sharpest);
    batten_text_print(c->lines[2], sizeof c->lines[2], "length %.6g %s", c->length, unit);
    for (int k = 0; k < 3; k++)
        c->shown[k] = c->lines[k];
}

static batten_status measure_compare(const bat_run *run, column *columns)
{
    const bat_argument *inputs = bat_argument_of(run, "compare");
    const char *unit = batten_unit_name(bat_unit_metres(run));
    batten_status status = BATTEN_OK;
    for (int i = 0; i < inputs->count && status == BATTEN_OK; i++) {
        const bat_result *result = &run->results[inputs->items[i].count];
        columns[i].feature = &result->shown;
        for (int k = 0; k < batten_model_count(result->value) && status == BATTEN_OK; k++)
            if (batten_model_object(result->value, k)->kind == BATTEN_OBJECT_CURVE)
                status = add_curve(run, batten_model_object(result->value, k), &columns[i]);
        if (status == BATTEN_OK && columns[i].curves == 0)
            status = bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has no curves to compare",
                              inputs->items[i].text);
        describe(&columns[i], unit ? unit : "unit");
    }
    return status;
}

/* ---- as a table, as JSON, as a picture ---- */

static const char *name_of(const column *c)
{
    return c->feature->name;
}

static const char *kind_of(const column *c)
{
    return c->feature->operation;
}

static int widest(int count, const column *columns, const char *(*text_of)(const column *c))
{
    size_t widest = 18;
    for (int i = 0; i < count; i++)
        if (strlen(text_of(&columns[i])) > widest)
            widest = strlen(text_of(&columns[i]));
    return (int)widest;
}

static void put_table(const bat_run *run, int count, const column *columns, batten_text *text)
{
    const char *unit = batten_unit_name(bat_unit_metres(run));
    bool infinite = false;
    const int names = widest(count, columns, name_of), kinds = widest(count, columns, kind_of);
    batten_text_add(text, "%-*s %-*s %12s %12s %11s %8s %10s %12s %9s\n", names, "feature",
                    kinds, "operation", "energy", "variation", "inflections", "extrema",
                    "max curv", "length", "ms");
    for (int i = 0; i < count; i++) {
        const column *c = &columns[i];
        char inflections[16], extrema[16];
        count_text(c, c->inflections, inflections, sizeof inflections);
        count_text(c, c->extrema, extrema, sizeof extrema);
        infinite |= c->corners + c->jumps > 0 || isinf(c->sharpest);
        batten_text_add(text, "%-*s %-*s %12.6g %12.6g %11s %8s %10.4g %12.8g %9.3f\n", names,
                        name_of(c), kinds, kind_of(c), c->energy, c->variation, inflections,
                        extrema, c->sharpest, c->length, 1e3 * c->feature->seconds);
    }
    batten_text_add(
        text, "\nenergy: integral of curvature^2; variation: of (d curvature / ds)^2; in %s\n",
        unit ? unit : "the unit of the design");
    if (infinite)
        batten_text_add(
            text,
            "inf: of a curve with corners both are infinite, of one whose curvature jumps the variation;\n"
            "curvature is where a curve stands still and its curvature has no bound\n");
}

static void put_number(batten_text *text, const char *key, double value)
{
    batten_text_add(text, ", \"%s\": ", key);
    if (isfinite(value))
        batten_text_number(text, value);
    else
        batten_text_add(text, "null");
}

static void put_json(int count, const column *columns, batten_text *text)
{
    batten_text_add(text, "{\"curves\": [");
    for (int i = 0; i < count; i++) {
        const column *c = &columns[i];
        batten_text_add(text, "%s\n  {\"name\": ", i ? "," : "");
        batten_text_json(text, c->feature->name);
        batten_text_add(text, ", \"operation\": ");
        batten_text_json(text, c->feature->operation);
        put_number(text, "energy", c->energy);
        put_number(text, "variation", c->variation);
        batten_text_add(text, ", \"corners\": %d, \"curvature_jumps\": %d", c->corners,
                        c->jumps);
        if (!c->in_space)
            batten_text_add(text, ", \"inflections\": %d, \"curvature_extrema\": %d",
                            c->inflections, c->extrema);
        put_number(text, "max_curvature", c->sharpest);
        put_number(text, "length", c->length);
        put_number(text, "seconds", c->feature->seconds);
        batten_text_add(text, "}");
    }
    batten_text_add(text, "\n]}\n");
}

static batten_status draw_compare(bat_run *run, batten_picture_format format, int count,
                                  const column *columns)
{
    batten_draw_options options = batten_draw_defaults();
    batten_panel *panels = batten_array((size_t)count, sizeof *panels);
    if (!panels)
        return BATTEN_OUT_OF_MEMORY;
    options.format = format;
    options.width = bat_count(run, "width");
    options.height = bat_count(run, "height");
    options.comb = bat_yes(run, "comb");
    options.data_points = true;
    if (bat_has(run, "title"))
        options.title = bat_text(run, "title");
    for (int i = 0; i < count; i++)
        panels[i] = (batten_panel){columns[i].feature->name, columns[i].feature->value, 3,
                                   columns[i].shown};
    const batten_status status =
        batten_draw_panels(count, panels, &options, &run->data, &run->size);
    batten_release(panels);
    return status;
}

static batten_status write(bat_run *run, int count, const column *columns)
{
    batten_picture_format format;
    batten_text text = BATTEN_TEXT;
    const char *dot = strrchr(run->name, '.');
    if (batten_picture_format_from_name(run->name, &format))
        return draw_compare(run, format, count, columns);
    if (dot && strcmp(dot, ".json") == 0)
        put_json(count, columns, &text);
    else
        put_table(run, count, columns, &text);
    const batten_status status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    return status;
}

static batten_status run_compare(bat_run *run)
{
    const int count = bat_argument_of(run, "compare")->count;
    column *columns = batten_array((size_t)count, sizeof *columns);
    if (!columns)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = measure_compare(run, columns);
    if (status == BATTEN_OK)
        status = write(run, count, columns);
    batten_release(columns);
    return status;
}

const bat_feature bat_feature_compare = {
    .shown =
        {"compare", "Curves through the same points, side by side",
         "A picture (.png, .svg, .pdf) with a panel for each feature, all at one scale and with\n"
         "one scale of their combs; or the same numbers as a table (any other ending) or as JSON\n"
         "(.json): bending energy, the variation of curvature, inflections and extrema of\n"
         "curvature, the largest curvature, the length, and how long it took to make the curves.\n"
         "'batten compare POINTS -o PICTURE' does it for a file of points and the methods you\n"
         "name.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 31 cm], [3 m, 29 cm], [4 m, 0]]}\n"
         "  chord: {interpolate: ducks, parameters: chord}\n"
         "  natural: {interpolate: ducks, ends: natural}\n"
         "outputs:\n"
         "  curves.svg: {compare: [chord, natural]}\n"
         "  curves.txt: {compare: [chord, natural]}\n",
         "[SL chapter VI]", "batten_draw_panels", BAT_PARAMETERS(parameters), true,
         .also = "comparison of methods, curvature comb, bending energy table"},
    .run = run_compare};
