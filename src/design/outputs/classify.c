#include "design/feature.h"
#include <batten/cubic.h>
#include <batten/text.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"classify", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "curves of degree 3 at most"},
    {"within", BATTEN_VALUE_NUMBER, false, false, "1e-9", NULL,
     "relative tolerance: so near to a boundary a span counts as lying on it"},
};

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

static void text_parameters(batten_text *out, const batten_cubic *c)
{
    for (int k = 0; k < c->inflection_count; k++)
        if (c->inflections[k] > c->from && c->inflections[k] < c->to)
            text_number(out, "; inflection at ", c->inflections[k]);
    if (c->segment == BATTEN_CUBIC_CUSP)
        text_number(out, "; cusp at ", c->cusp);
    if (c->segment == BATTEN_CUBIC_LOOP) {
        text_number(out, "; crosses itself at ", c->crossing[0]);
        text_number(out, " and ", c->crossing[1]);
    }
}

static void text_span(batten_text *out, int index, const batten_cubic *c)
{
    batten_text_add(out, "  span %d: %s", index + 1, batten_cubic_class_text(c->segment));
    text_number(out, ", margin ", c->margin);
    text_place(out, c);
    text_parameters(out, c);
    batten_text_add(out, "\n");
}

static void text_curve(batten_text *out, const char *name, int count, const batten_cubic *spans)
{
    int seen[BATTEN_CUBIC_CLASS_COUNT] = {0};
    batten_text_add(out, "%s: %d span%s", name, count, count == 1 ? "" : "s");
    for (int i = 0; i < count; i++)
        seen[spans[i].segment]++;
    for (int k = 0; k < BATTEN_CUBIC_CLASS_COUNT; k++)
        if (seen[k])
            batten_text_add(out, ", %d %s", seen[k],
                            batten_cubic_class_name((batten_cubic_class)k));
    batten_text_add(out, "\n");
    for (int i = 0; i < count; i++)
        text_span(out, i, &spans[i]);
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

static void json_span(batten_text *out, const batten_cubic *c)
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
    batten_text_add(out, "}");
}

static void json_curve(batten_text *out, const char *name, int count, const batten_cubic *spans)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, name);
    batten_text_add(out, ", \"spans\": [");
    for (int i = 0; i < count; i++) {
        batten_text_add(out, "%s\n      ", i ? "," : "");
        json_span(out, &spans[i]);
    }
    batten_text_add(out, "]}");
}

/* ---- the report ---- */

static batten_status add_curve(const bat_run *run, const batten_object *object, bool json,
                               batten_text *out)
{
    batten_cubic *spans = NULL;
    int count = 0;
    const batten_status status =
        batten_curve_classify(object->curve, bat_number(run, "within"), &count, &spans);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    if (status != BATTEN_OK)
        return bat_fail(status, "%s: %s", object->name, batten_message());
    (json ? json_curve : text_curve)(out, object->name, count, spans);
    batten_release(spans);
    return BATTEN_OK;
}

static batten_status run(bat_run *run)
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
    .shown = {"classify",
              "A report: inflections, cusps and loops of every span of cubic curves",
              "For each span of each curve: what it contains, with its parameters; the margin, "
              "by how\n"
              "large a part the numbers that decide would have to change before the answer "
              "does; and\n"
              "its place (lambda, mu) among all cubics with the same ends and end tangents, "
              "with the\n"
              "name of the region ('cubic-plane' draws it). Spans in space that lie in no "
              "plane are\n"
              "called so. As JSON, with all digits and the affine invariants p, q, r and I, "
              "when the\n"
              "file ends in .json. Rational curves and degrees above 3 are refused; 'reduce' "
              "may help.",
              "features:\n"
              "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
              "  sheer: {interpolate: ducks}\n"
              "outputs:\n"
              "  spans.txt: {classify: sheer}\n"
              "  spans.json: {classify: sheer, within: 1e-6}\n",
              "[SL] [Wang81] [SD89]", "batten_curve_classify", BAT_PARAMETERS(parameters),
              true},
    .run = run};
