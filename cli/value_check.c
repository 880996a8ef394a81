/* Numbers and words that options give to an operation, judged before any work. */
#include "value_check.h"
#include "unit.h"

#include <batten/text.h>
#include <math.h>
#include <string.h>

/* The least that a parameter of the command's own operation may be. */
typedef struct {
    const char *name;
    double least;
    bool above; /* above it alone */
} lower_bound;

static const lower_bound bounds[] = {
    {"angle", 0, true},       {"curvature", 0, true}, {"degree", 1, false},
    {"comb-scale", 0, false}, {"distance", 0, false}, {"isolines", 1, false},
    {"spacing", 0, false},    {"stripes", 0, true},   {"width", 64, false},
    {"height", 64, false},
};

static const lower_bound *bound_of(const char *name)
{
    for (size_t i = 0; i < sizeof bounds / sizeof bounds[0]; i++)
        if (strcmp(bounds[i].name, name) == 0)
            return &bounds[i];
    return NULL;
}

static const char *wanted(batten_value_kind kind)
{
    return kind == BATTEN_VALUE_ANGLE    ? "an angle with its unit, as 30deg or 0.5rad"
           : kind == BATTEN_VALUE_LENGTH ? "a length, as 0.1 or 0.1mm"
           : kind == BATTEN_VALUE_COUNT  ? "a whole number"
                                         : "a number";
}

/* Is what follows a number a unit that goes with the kind? */
static bool is_unit(batten_value_kind kind, const char *unit, double value)
{
    if (kind == BATTEN_VALUE_ANGLE)
        return strcmp(unit, "deg") == 0 || strcmp(unit, "rad") == 0 || (!*unit && value == 0);
    return !*unit || (kind == BATTEN_VALUE_LENGTH && batten_unit_metres(unit) > 0);
}

static bool read_value(const batten_parameter *p, const char *text, double *value)
{
    size_t used = 0;
    if (p->kind == BATTEN_VALUE_COUNT && text[strspn(text, "-0123456789")])
        return false;
    if (batten_number_read(text, strlen(text), value, &used) != BATTEN_OK)
        return false;
    return is_unit(p->kind, text + used + strspn(text + used, " "), *value);
}

/* One number; formulas and lists are those of a design. */
static bool check_number(const char *asked, const batten_parameter *p, const lower_bound *bound,
                         const char *text)
{
    double value = 0;
    if (*text == '=' || *text == '[' || (p->is_list && strchr(text, ',')))
        return true;
    if (!read_value(p, text, &value)) {
        complain("batten %s: --%s wants %s, not '%s'", asked, p->name, wanted(p->kind), text);
        return false;
    }
    /* Whole numbers count something. */
    const lower_bound none = {p->name, p->kind == BATTEN_VALUE_COUNT ? 0 : -HUGE_VAL, false};
    const lower_bound *least = bound ? bound : &none;
    if (value > least->least || (value == least->least && !least->above))
        return true;
    complain("batten %s: --%s is %s; it must be %s %g", asked, p->name, text,
             least->above ? "above" : "at least", least->least);
    return false;
}

static const batten_parameter *parameter_named(const batten_feature *feature, const char *name)
{
    for (int k = 1; k < feature->parameter_count; k++)
        if (strcmp(feature->parameters[k].name, name) == 0)
            return &feature->parameters[k];
    return NULL;
}

bool value_check_all(const command *c, const batten_feature *feature, const arguments *given)
{
    bool good = true;
    for (int i = 0; feature && i < given->given_count; i++) {
        const char *name = given->options[given->given[i].option].name;
        const batten_parameter *p = parameter_named(feature, name);
        /* Those of the command itself are its own affair. */
        if (!p || command_has_option(c, name))
            continue;
        const bool is_own = strcmp(feature->name, c->feature) == 0;
        const bool is_number = p->kind == BATTEN_VALUE_LENGTH ||
                               p->kind == BATTEN_VALUE_ANGLE ||
                               p->kind == BATTEN_VALUE_NUMBER || p->kind == BATTEN_VALUE_COUNT;
        if (is_number)
            good &=
                check_number(c->name, p, is_own ? bound_of(name) : NULL, given->given[i].value);
    }
    return good;
}
