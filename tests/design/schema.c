#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>

/* ---- a reader of JSON that only judges, with a stack of its own ---- */

static const char *skip(const char *c)
{
    while (*c == ' ' || *c == '\n')
        c++;
    return c;
}

static const char *skip_string(const char *c)
{
    CHECK(*c == '"');
    for (c++; *c != '"'; c++) {
        CHECK((unsigned char)*c >= 0x20);
        if (*c == '\\')
            CHECK(strchr("\"\\/bfnrtu", *++c) && *c);
    }
    return c + 1;
}

static const char *skip_scalar(const char *c)
{
    static const char *const words[] = {"true", "false", "null"};
    if (*c == '"')
        return skip_string(c);
    for (int i = 0; i < COUNT(words); i++)
        if (strncmp(c, words[i], strlen(words[i])) == 0)
            return c + strlen(words[i]);
    const size_t digits = strspn(c, "-0123456789.e+");
    CHECK(digits > 0);
    return c + digits;
}

/* The text is one JSON value; the number of strings in it. */
static int judge(const char *c)
{
    char stack[64];
    int depth = 0, strings = 0;
    bool wants_value = true;
    for (c = skip(c); depth > 0 || wants_value; c = skip(c)) {
        if (wants_value && depth && stack[depth - 1] == '{' && *c != '}') {
            c = skip(skip_string(c));
            strings++;
            CHECK(*c == ':');
            c = skip(c + 1);
        }
        if (wants_value && (*c == '{' || *c == '[')) {
            CHECK(depth < 64);
            stack[depth++] = *c++;
            c = skip(c);
            wants_value = *c != '}' && *c != ']';
        } else if (wants_value) {
            strings += *c == '"';
            c = skip_scalar(c);
            wants_value = false;
        } else if (*c == ',') {
            wants_value = true;
            c++;
        } else {
            CHECK(*c == (stack[--depth] == '{' ? '}' : ']'));
            c++;
        }
    }
    CHECK(*c == 0);
    return strings;
}

TEST(the_schema_is_JSON_and_names_every_parameter)
{
    char *schema = NULL;
    CHECK_OK(batten_design_schema(&schema));
    CHECK(judge(schema) > 100);
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        for (int k = 0; k < f->parameter_count; k++) {
            char quoted[80];
            snprintf(quoted, sizeof quoted, "\"%s\": {\"description\"", f->parameters[k].name);
            CHECK_CONTAINS(schema, quoted);
        }
    }
    batten_release(schema);
}

/* Operations stand under "operation" and outputs under "output", each once. */
TEST(the_schema_has_operations_and_outputs_in_their_places)
{
    char *schema = NULL;
    CHECK_OK(batten_design_schema(&schema));
    const char *operations = strstr(schema, "    \"operation\": {\"anyOf\": ["),
               *outputs = strstr(schema, "    \"output\": {\"anyOf\": [");
    CHECK(operations && outputs && operations < outputs);
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        char required[120];
        snprintf(required, sizeof required, "\"required\": [\"%s\"", f->name);
        const char *at = strstr(operations, required);
        CHECK(at != NULL);
        CHECK_INT(at > outputs, f->is_output);
    }
    batten_release(schema);
}
