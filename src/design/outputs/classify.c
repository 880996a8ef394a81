/* The output 'classify': a report: inflections, cusps, crossings of every polynomial span
 * of curves. */
#include "base/plural.h"
#include "design/feature.h"
#include <batten/invariants.h>
#include <batten/text.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"classify", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "polynomial curves"},
    {"within", BATTEN_VALUE_NUMBER, false, false, "1e-9", NULL,
     "relative: this close to a boundary a cubic is on it, and any span in a line or plane"},
};

/* ---- what is on a span, whatever its degree ---- */

typedef struct {
    int count;
    const batten_special *at;
} specials;

/* Those of a cubic, [3] at most. */
static specials specials_of_cubic(const batten_cubic *c, batten_special *at)
{
    const bool has_loop = isfinite(c->crossing[0]);
    int count = 0;
    for (int k = 0; k < c->inflection_count; k++)
        at[count++] =
            (batten_special){.kind = BATTEN_SPECIAL_INFLECTION,
                             .inside = c->inflections[k] > c->from && c->inflections[k] < c->to,
                             .multiplicity = 1,
                             .t = c->inflections[k],
                             .s = NAN};
    if (isfinite(c->cusp))
        at[count++] = (batten_special){.kind = BATTEN_SPECIAL_CUSP,
                                       .inside = c->segment == BATTEN_CUBIC_CUSP,
                                       .multiplicity = 1,
                                       .t = c->cusp,
                                       .s = NAN};
    if (has_loop)
        at[count++] = (batten_special){.kind = BATTEN_SPECIAL_CROSSING,
                                       .inside = c->segment == BATTEN_CUBIC_LOOP,
                                       .multiplicity = 1,
                                       .t = c->crossing[0],
                                       .s = c->crossing[1]};
    return (specials){count, at};
}

/* ---- text ---- */

static void text_number(batten_text *out, const char *name, double value)
{
    batten_text_add(out, "%s", name);
    /* Six digits are enough for people; the C locale is that of the text. */
    batten_text_add(out, "%.6g", value);
}

static void text_place(batten_text *out, const batten_cubic *c)
{
    batten_cubic_place place;
    if (!c->has_tangents || batten_cubic_look_up(c->lambda, c->mu, &place) != BATTEN_OK)
        return;
    text_number(out, ", lambda ", c->lambda);
    text_number(out, ", mu ", c->mu);
    batten_text_add(out, " (%s)", batten_cubic_region_name(place.region));
}

/* Those on the span itself. */
static void text_specials(batten_text *out, specials on)
{
    for (int k = 0; k < on.count; k++) {
        const batten_special *s = &on.at[k];
        if (!s->inside)
            continue;
        if (s->kind == BATTEN_SPECIAL_CROSSING) {
            text_number(out, "; crosses itself at ", s->t);
            text_number(out, " and ", s->s);
        } else {
            batten_text_add(out, "; %s", batten_special_name(s->kind, false));
            text_number(out, " at ", s->t);
        }
        if (s->multiplicity > 1)
            batten_text_add(out, " (%d-fold)", s->multiplicity);
    }
    batten_text_add(out, "\n");
}

static void text_cubic(batten_text *out, int index, const batten_cubic *c)
{
    batten_text_add(out, "  span %d: %s", index + 1, batten_cubic_class_text(c->segment));
    text_number(out, ", margin ", c->margin);
    text_place(out, c);
    batten_special at[3];
    text_specials(out, specials_of_cubic(c, at));
}

static void text_cubics(batten_text *out, const char *name, int count,
                        const batten_cubic *spans)
{
    int seen[BATTEN_CUBIC_CLASS_COUNT] = {0};
    batten_text_add(out, "%s: %d span%s", name, count, bat_plural(count));
    for (int i = 0; i < count; i++)
        seen[spans[i].segment]++;
    for (int k = 0; k < BATTEN_CUBIC_CLASS_COUNT; k++)
        if (seen[k])
            batten_text_add(out, ", %d %s", seen[k],
                            batten_cubic_class_name((batten_cubic_class)k));
    batten_text_add(out, "\n");
    for (int i = 0; i < count; i++)
        text_cubic(out, i, &spans[i]);
}

/* "2 inflections, 1 crossing", or nothing. */
static void text_counts(batten_text *out, const char *before, const int *counts)
{
    bool any = false;
    for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++) {
        if (counts[k] == 0)
            continue;
        batten_text_add(out, "%s%d %s", any ? ", " : before, counts[k],
                        batten_special_name((batten_special_kind)k, counts[k] != 1));
        any = true;
    }
}

/* Below 1e-10 of the span an entry of the canonical form is rounding; below 1e-9 a sign. */
static const double rounding = 1e-10, undecided = 1e-9;

static void text_census(batten_text *out, int index, const batten_census *c,
                        const batten_canonical *form)
{
    batten_quintic quintic;
    static const char *const dimensions[] = {"a point", "a line", "plane", "in space"};
    batten_text_add(out, "  span %d: degree %d, %s", index + 1, c->degree,
                    dimensions[c->flat_dimension]);
    text_counts(out, ", ", c->segment);
    text_number(out, ", margin ", c->margin);
    text_counts(out, "; on the whole curve ", c->whole);
    if (form && batten_quintic_classify(form, undecided, &quintic) == BATTEN_OK)
        batten_text_add(out, "; a quintic with two finite double points: %s",
                        batten_quintic_text(quintic.which));
    if (c->is_repeated)
        batten_text_add(out, "; every point is passed more than once");
    else if (!c->is_complete)
        batten_text_add(out, "; crossings were searched for and are perhaps not all, isolated "
                             "points were not counted");
    text_specials(out, (specials){c->count, c->specials});
}

static void text_censuses(batten_text *out, const char *name, int count,
                          const batten_census *spans, const batten_canonical *forms)
{
    int sums[BATTEN_SPECIAL_COUNT] = {0};
    batten_text_add(out, "%s: %d span%s", name, count, bat_plural(count));
    for (int i = 0; i < count; i++)
        for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++)
            sums[k] += spans[i].segment[k];
    text_counts(out, ", ", sums);
    batten_text_add(out, "\n");
    for (int i = 0; i < count; i++)
        text_census(out, i, &spans[i], forms ? &forms[i] : NULL);
}

/* ---- JSON ---- */

static void json_number(batten_text *out, const char *key, double value)
{
    batten_text_add(out, ", \"%s\": ", key);
    if (isfinite(value))
        batten_text_number(out, value);
    else
        batten_text_add(out, "null");
}

static void json_list(batten_text *out, const char *key, int count, const double *values)
{
    batten_text_add(out, ", \"%s\": [", key);
    for (int k = 0; k < count; k++) {
        batten_text_add(out, k ? ", " : "");
        batten_text_number(out, values[k]);
    }
    batten_text_add(out, "]");
}

static void json_special(batten_text *out, const batten_special *s)
{
    batten_text_add(out, "{\"kind\": \"%s\", \"inside\": %s, \"multiplicity\": %d",
                    batten_special_name(s->kind, false), s->inside ? "true" : "false",
                    s->multiplicity);
    json_number(out, "t", s->t);
    json_number(out, "s", s->s);
    batten_text_add(out, "}");
}

static void json_specials(batten_text *out, specials on)
{
    batten_text_add(out, ", \"specials\": [");
    for (int k = 0; k < on.count; k++) {
        batten_text_add(out, k ? ", " : "");
        json_special(out, &on.at[k]);
    }
    batten_text_add(out, "]");
}

static void json_counts(batten_text *out, const char *key, const int *counts)
{
    batten_text_add(out, ", \"%s\": {", key);
    for (int k = 0; k < BATTEN_SPECIAL_COUNT; k++)
        batten_text_add(out, "%s\"%s\": %d", k ? ", " : "",
                        batten_special_name((batten_special_kind)k, true), counts[k]);
    batten_text_add(out, "}");
}

/* Nothing where the form could not be found. */
static void json_canonical(batten_text *out, const batten_canonical *c)
{
    batten_quintic quintic;
    if (!c)
        return;
    batten_text_add(out, ", \"pivots\": [");
    for (int k = 0; k < c->dimension; k++)
        batten_text_add(out, "%s%d", k ? ", " : "", c->pivots[k]);
    batten_text_add(out, "]");
    json_number(out, "shift", c->has_shift ? c->shift : (double)NAN);
    json_number(out, "radius", c->radius);
    batten_text_add(out, ", \"invariants\": [");
    for (int i = 0; i < c->count; i++) {
        const batten_invariant *e = &c->at[i];
        batten_text_add(out, "%s{\"row\": %d, \"power\": %d, \"weight\": %d", i ? ", " : "",
                        e->row + 1, e->power, e->weight);
        json_number(out, "value", e->value);
        json_number(out, "absolute", e->absolute);
        batten_text_add(out, "}");
    }
    batten_text_add(out, "]");
    if (batten_quintic_classify(c, undecided, &quintic) == BATTEN_OK)
        batten_text_add(out, ", \"quintic\": \"%s\"", batten_quintic_name(quintic.which));
}

static void json_census(batten_text *out, const batten_census *c, const batten_canonical *form)
{
    batten_text_add(out, "{\"degree\": %d, \"dimension\": %d", c->degree, c->flat_dimension);
    batten_text_add(out, ", \"complete\": %s, \"repeated\": %s",
                    c->is_complete ? "true" : "false", c->is_repeated ? "true" : "false");
    json_number(out, "margin", c->margin);
    json_number(out, "flatness", c->flatness);
    json_counts(out, "segment_counts", c->segment);
    json_counts(out, "whole_counts", c->whole);
    if (c->is_complete)
        batten_text_add(out, ", \"complex\": %d, \"infinite\": %d", c->complex_count,
                        c->infinite_count);
    json_specials(out, (specials){c->count, c->specials});
    json_canonical(out, form);
    batten_text_add(out, "}");
}

static void json_cubic(batten_text *out, const batten_cubic *c, const batten_canonical *form)
{
    batten_cubic_place place;
    const bool has_loop = isfinite(c->crossing[0]);
    batten_text_add(out, "{\"segment\": \"%s\", \"whole\": \"%s\"",
                    batten_cubic_class_name(c->segment), batten_cubic_class_name(c->whole));
    json_number(out, "margin", c->margin);
    json_number(out, "whole_margin", c->whole_margin);
    json_number(out, "flatness", c->flatness);
    json_number(out, "p", c->p);
    json_number(out, "q", c->q);
    json_number(out, "r", c->r);
    json_number(out, "invariant", c->invariant);
    json_list(out, "inflections", c->inflection_count, c->inflections);
    json_list(out, "crossing", has_loop ? 2 : 0, c->crossing);
    json_number(out, "cusp", c->cusp);
    json_number(out, "lambda", c->lambda);
    json_number(out, "mu", c->mu);
    if (c->has_tangents && batten_cubic_look_up(c->lambda, c->mu, &place) == BATTEN_OK)
        batten_text_add(out, ", \"region\": \"%s\"", batten_cubic_region_name(place.region));
    batten_special at[3];
    json_specials(out, specials_of_cubic(c, at));
    json_canonical(out, form);
    batten_text_add(out, "}");
}

/* ---- the report ---- */

static void json_begin(batten_text *out, const char *name)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, name);
    batten_text_add(out, ", \"spans\": [");
}

static batten_status add_cubics(const batten_object *object, double within,
                                const batten_canonical *forms, bool json, batten_text *out)
{
    batten_cubics spans = {0, NULL};
    const batten_status status = batten_curve_classify(object->curve, within, &spans);
    if (status != BATTEN_OK)
        return status;
    if (!json)
        text_cubics(out, object->name, spans.count, spans.at);
    for (int i = 0; i < spans.count && json; i++) {
        batten_text_add(out, "%s\n      ", i ? "," : "");
        json_cubic(out, &spans.at[i], forms ? &forms[i] : NULL);
    }
    batten_cubics_release(&spans);
    return BATTEN_OK;
}

static batten_status add_censuses(const batten_object *object, double within,
                                  const batten_canonical *forms, bool json, batten_text *out)
{
    batten_censuses spans = {0, NULL};
    const batten_status status = batten_curve_census(object->curve, within, &spans);
    if (status != BATTEN_OK)
        return status;
    if (!json)
        text_censuses(out, object->name, spans.count, spans.at, forms);
    for (int i = 0; i < spans.count && json; i++) {
        batten_text_add(out, "%s\n      ", i ? "," : "");
        json_census(out, &spans.at[i], forms ? &forms[i] : NULL);
    }
    batten_censuses_release(&spans);
    return BATTEN_OK;
}

static batten_status add_curve(const bat_run *run, const batten_object *object, bool json,
                               batten_text *out)
{
    const double within = bat_number(run, "within");
    batten_canonicals forms = {0, NULL};
    /* They are an addition: what they refuse, rational curves apart, is classified all the
     * same.
     */
    batten_status status = batten_curve_canonical_forms(object->curve, rounding, &forms);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    if (json)
        json_begin(out, object->name);
    status = batten_curve_degree(object->curve) <= 3
                 ? add_cubics(object, within, forms.at, json, out)
                 : add_censuses(object, within, forms.at, json, out);
    if (json)
        batten_text_add(out, "]}");
    batten_canonicals_release(&forms);
    return status == BATTEN_OK ? status
                               : bat_fail(status, "%s: %s", object->name, batten_message());
}

static batten_status run_classify(bat_run *run)
{
    bat_objects objects;
    batten_text text = BATTEN_TEXT;
    const char *dot = strrchr(run->name, '.');
    const bool json = dot && strcmp(dot, ".json") == 0;
    batten_status status = bat_gather(run, "classify", BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    batten_text_add(&text, json ? "{\n  \"curves\": [\n" : "");
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++) {
        batten_text_add(&text, json && i ? ",\n" : "");
        status = add_curve(run, objects.at[i], json, &text);
    }
    batten_text_add(&text, json ? "\n  ]\n}\n" : "");
    if (status == BATTEN_OK)
        status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    bat_objects_release(&objects);
    return status;
}

const bat_feature bat_feature_classify = {
    .shown =
        {"classify",
         "A report: inflections, cusps, crossings of every polynomial span of curves",
         "For each span of each curve: what it contains, with its parameters, and the margin: by\n"
         "what share the deciding numbers would have to change before the answer does. Signs are\n"
         "decided exactly. As JSON, with all digits, when the file ends in .json. Cubics are\n"
         "called by their class and have a place (lambda, mu) among all cubics with the same ends\n"
         "and end tangents, with the name of the region ('cubic-plane' draws it); JSON adds the\n"
         "affine invariants p, q, r and I. For higher degrees everything is counted that no affine\n"
         "map changes, on the span and on the whole curve of which it is a part: also isolated\n"
         "points, which belong to the equation of the curve though it does not pass there. Up to\n"
         "degree 10 or so the list is proved to be complete; beyond that crossings are searched\n"
         "for and the report says so. Spans in space that lie in no plane are reported as such.\n"
         "JSON has the canonical form of each span under affine maps and changes of parameter,\n"
         "with its invariants, and of quintics with two finite double points their case. Rational\n"
         "curves are refused.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  sheer: {interpolate: ducks}\n"
         "outputs:\n"
         "  spans.txt: {classify: sheer}\n"
         "  spans.json: {classify: sheer, within: 1e-6}\n",
         "[SL section I.3] [SL section III.2] [SL section VIII.1] [SL section VIII.2] [SL section VIII.3] [Wang81] [SD89] [SWP08]",
         "batten_curve_census", BAT_PARAMETERS(parameters), true,
         .also =
             "affine invariants, inflections, cusps, double points, loop, cubic classification"},
    .run = run_classify};
