/* The JSON Schema of design files, made from the table of features: what is wrong of one parameter
 * is wrong in the table of its feature's file. */
#include "design/feature.h"

#include <batten/text.h>
#include <string.h>

/* ---- one value ---- */

static void add_words(batten_text *out, const char *words)
{
    batten_text_add(out, "{\"enum\": [");
    for (const char *at = words; *at;) {
        const size_t length = strcspn(at, " ");
        batten_text_add(out, "%s\"%.*s\"", at == words ? "" : ", ", (int)length, at);
        at += length + (at[length] == ' ');
    }
    batten_text_add(out, "]}");
}

static void add_value(batten_text *out, const batten_parameter *p)
{
    static const char *const kinds[] = {"feature", "length", "angle", "number", "count",
                                        "",        "text",   "file",  "yes-no", "point",
                                        "range",   "points", "move"};
    if (p->kind == BATTEN_VALUE_WORD)
        add_words(out, p->words);
    else
        batten_text_add(out, "{\"$ref\": \"#/$defs/%s\"}", kinds[p->kind]);
}

static void add_parameter(batten_text *out, const batten_parameter *p)
{
    batten_text_add(out, "          ");
    batten_text_json(out, p->name);
    batten_text_add(out, ": {\"description\": ");
    batten_text_json(out, p->summary);
    if (p->standard) {
        batten_text_add(out, ", \"default\": ");
        batten_text_json(out, p->standard);
    }
    batten_text_add(out, p->is_list ? ", \"anyOf\": [" : ", \"allOf\": [");
    add_value(out, p);
    if (p->is_list) {
        batten_text_add(out, ", {\"type\": \"array\", \"minItems\": 1, \"items\": ");
        add_value(out, p);
        batten_text_add(out, "}");
    }
    batten_text_add(out, "]}");
}

/* ---- one operation ---- */

static void add_feature(batten_text *out, const batten_feature *f)
{
    batten_text_add(out, "      {\n        \"type\": \"object\", \"title\": ");
    batten_text_json(out, f->name);
    batten_text_add(out, ", \"description\": ");
    batten_text_json(out, f->summary);
    batten_text_add(out, ",\n        \"additionalProperties\": false, \"required\": [");
    for (int i = 0, count = 0; i < f->parameter_count; i++)
        if (f->parameters[i].required) {
            batten_text_add(out, "%s", count++ ? ", " : "");
            batten_text_json(out, f->parameters[i].name);
        }
    batten_text_add(out, "],\n        \"properties\": {\n");
    for (int i = 0; i < f->parameter_count; i++) {
        add_parameter(out, &f->parameters[i]);
        batten_text_add(out, i + 1 < f->parameter_count ? ",\n" : "\n");
    }
    batten_text_add(out, "        }\n      }");
}

static void add_features(batten_text *out, const char *name, bool is_output)
{
    batten_text_add(out, "    \"%s\": {\"anyOf\": [\n", name);
    for (int i = 0, count = 0; i < batten_feature_count(); i++)
        if (batten_feature_at(i)->is_output == is_output) {
            batten_text_add(out, "%s", count++ ? ",\n" : "");
            add_feature(out, batten_feature_at(i));
        }
    if (is_output)
        batten_text_add(
            out, ",\n"
                 "      {\"$ref\": \"#/$defs/feature\"},\n"
                 "      {\"type\": \"array\", \"items\": {\"$ref\": \"#/$defs/feature\"}}");
    batten_text_add(out, "\n    ]}");
}

/* ---- the whole ---- */

/* A number may be written as such, or as a text with a unit or an expression. */
static const char head[] =
    "{\n"
    "  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n"
    "  \"title\": \"Batten design\",\n"
    "  \"type\": \"object\", \"additionalProperties\": false, \"required\": [\"batten\"],\n"
    "  \"properties\": {\n"
    "    \"batten\": {\"const\": 1, \"description\": \"version of the format\"},\n"
    "    \"units\": {\"type\": \"string\", \"default\": \"m\", \"description\": \"the unit of lengths without one\"},\n"
    "    \"tolerance\": {\"$ref\": \"#/$defs/length\", \"description\": \"what is the same point\"},\n"
    "    \"title\": {\"type\": [\"string\", \"number\"]},\n"
    "    \"most-objects\": {\"type\": \"integer\", \"minimum\": 1, \"description\": \"how many objects the features may make\"},\n"
    "    \"parameters\": {\"type\": [\"object\", \"null\"], \"additionalProperties\": {\"$ref\": \"#/$defs/length\"}},\n"
    "    \"features\": {\"type\": [\"object\", \"null\"], \"additionalProperties\": {\"$ref\": \"#/$defs/operation\"}},\n"
    "    \"outputs\": {\"type\": [\"object\", \"null\"], \"additionalProperties\": {\"$ref\": \"#/$defs/output\"}}\n"
    "  },\n"
    "  \"$defs\": {\n"
    "    \"length\": {\"type\": [\"number\", \"string\"]},\n"
    "    \"angle\": {\"type\": [\"number\", \"string\"]},\n"
    "    \"number\": {\"type\": [\"number\", \"string\"]},\n"
    "    \"count\": {\"anyOf\": [{\"type\": \"integer\", \"minimum\": 0}, {\"type\": \"string\", \"pattern\": \"^=\"}]},\n"
    "    \"feature\": {\"type\": [\"string\", \"number\"]},\n"
    "    \"text\": {\"type\": [\"string\", \"number\", \"boolean\"]},\n"
    "    \"file\": {\"type\": \"string\"},\n"
    "    \"yes-no\": {\"enum\": [\"yes\", \"no\", true, false]},\n"
    "    \"point\": {\"anyOf\": [{\"enum\": [\"origin\", \"x\", \"y\", \"z\", \"-x\", \"-y\", \"-z\"]}, {\"type\": \"array\", \"minItems\": 2, "
    "\"maxItems\": 3, \"items\": {\"$ref\": \"#/$defs/length\"}}]},\n"
    "    \"range\": {\"type\": \"array\", \"minItems\": 2, \"maxItems\": 2, \"items\": {\"$ref\": \"#/$defs/length\"}},\n"
    "    \"move\": {\"type\": \"array\", \"minItems\": 6, \"maxItems\": 6, \"items\": {\"$ref\": \"#/$defs/length\"}},\n"
    "    \"points\": {\"anyOf\": [{\"$ref\": \"#/$defs/point\"}, {\"$ref\": \"#/$defs/feature\"}]},\n";

batten_status batten_design_schema(char **json)
{
    batten_text out = BATTEN_TEXT;
    size_t length;
    batten_text_add(&out, "%s", head);
    add_features(&out, "operation", false);
    batten_text_add(&out, ",\n");
    add_features(&out, "output", true);
    batten_text_add(&out, "\n  }\n}\n");
    return batten_text_take(&out, json, &length);
}
