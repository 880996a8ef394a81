/* A method as it is written on the command line: the name of a feature, with settings after colons. */
#include "commands/method.h"

#include "values.h"

#include <batten/design.h>
#include <batten/text.h>
#include <string.h>

static bool keep_method(const batten_text *name, const batten_text *values, method *out)
{
    const bool fits = !name->failed && !values->failed && name->length < METHOD_SIZE &&
                      values->length < METHOD_SIZE;
    if (fits) {
        memcpy(out->name, name->bytes, name->length + 1);
        if (values->bytes)
            memcpy(out->settings, values->bytes, values->length + 1);
    }
    return fits;
}

/* End the setting here; what comes after it, or NULL. */
static char *cut_setting(char *at)
{
    char *end = at + value_span(at, ":");
    if (!*end)
        return NULL;
    *end = '\0';
    return end + 1;
}

static bool read_method(const char *word, size_t length, method *out)
{
    char copy[METHOD_SIZE];
    *out = (method){0};
    if (length == 0 || length >= sizeof copy)
        return false;
    memcpy(copy, word, length);
    copy[length] = '\0';
    char *settings = strchr(copy, ':');
    if (settings)
        *settings++ = '\0';
    memcpy(out->operation, copy, strlen(copy) + 1);
    batten_text name = BATTEN_TEXT, values = BATTEN_TEXT;
    batten_text_add(&name, "%s", copy);
    for (char *at = settings; at; at = settings) {
        settings = cut_setting(at);
        const char *equals = strchr(at, '=');
        batten_text_add(&name, " %s", at);
        batten_text_add(&values, ", %.*s: %s", (int)strcspn(at, "="), at,
                        equals ? equals + 1 : "yes");
    }
    const bool fits = keep_method(&name, &values, out);
    batten_text_free(&name);
    batten_text_free(&values);
    return fits;
}

size_t method_length(const char *word)
{
    return strcspn(word, ":");
}

bool method_choose(const char *asker, const char *word, size_t length, method *out)
{
    if (!read_method(word, length, out)) {
        complain("batten %s: unknown method '%.*s'", asker, length < 60 ? (int)length : 60,
                 word);
        return false;
    }
    if (batten_feature_find(out->operation))
        return true;
    const char *near = batten_feature_nearest(out->operation);
    complain("batten %s: there is no method '%s'%s%s%s; see 'batten help features'", asker,
             out->operation, near ? "; did you mean '" : "", near ? near : "", near ? "'" : "");
    return false;
}
