/* No input is dropped in silence: to every list of inputs in the examples of the manual an object is added that
 * was not asked for, and it is used, refused or remarked upon. */
#include "design/expect.h"
#include "design/outcome.h"

#include <string.h>

static const char *const extras[] = {
    "{points: [[0.31, 0.22, 0.13], [0.7, 0.1, 0.4], [0.2, 0.9, 0.3]]}",
    "{sphere: 37 cm, at: [0.2, 0.1, 9]}",
    "{box: [0.3, 0.2, 0.1], at: [0.1, 0.2, 9]}",
    "{read: offsets.csv}",
    "{line: [[0.1, 0.2, 9], [0.7, 0.3, 9.5]]}",
};

enum { MOST = 8000 };

/* What an example only prepares may be dear: a side of a prism will do for the hull that floats. */
static const char dear[] =
    "  table: {read: offsets.csv}\n  hull: {loft: table, within: 3 mm}\n",
                  cheap[] =
                      "  hull: {bilinear: [[-3, 0, 0], [3, 0, 0], [3, 1, 1], [-3, 1, 1]]}\n";

static void copy_example(const batten_feature *feature, char example[MOST])
{
    const char *at =
        strcmp(feature->name, "hydrostatics") == 0 ? strstr(feature->example, dear) : NULL;
    if (at)
        snprintf(example, MOST, "%.*s%s%s", (int)(at - feature->example), feature->example,
                 cheap, at + strlen(dear));
    else
        snprintf(example, MOST, "%s", feature->example);
}

/* The example with "odd" added to the list of this parameter; false when the example has none. */
static bool with_extra(const char *example, const char *parameter, const char *extra,
                       char text[MOST])
{
    char key[80];
    snprintf(key, sizeof key, "{%s: ", parameter);
    const char *at = strstr(example, key);
    if (!at) {
        snprintf(key, sizeof key, ", %s: ", parameter);
        at = strstr(example, key);
    }
    const char *features = strstr(example, "features:\n");
    if (!at || !features)
        return false;
    at += strlen(key);
    const bool is_list = *at == '[';
    const char *end = at + strcspn(at, is_list ? "]" : ",}\n");
    const char *body = features + strlen("features:\n");
    snprintf(text, MOST, "batten: 1\n%.*s  odd: %s\n%.*s%s%.*s, odd]%s", (int)(body - example),
             example, extra, (int)(at - body), body, is_list ? "" : "[", (int)(end - at), at,
             is_list ? end + 1 : end);
    return true;
}

/* How many kinds of objects are dropped. */
static int try_parameter(const batten_feature *feature, const char *parameter)
{
    char example[MOST], plain[MOST + 20], text[MOST];
    int dropped = 0;
    copy_example(feature, example);
    if (!with_extra(example, parameter, extras[0], text))
        return 0;
    snprintf(plain, sizeof plain, "batten: 1\n%s", example);
    outcome without = outcome_of(plain);
    for (int k = 0; k < COUNT(extras); k++) {
        with_extra(example, parameter, extras[k], text);
        outcome with = outcome_of(text);
        if (strcmp(without.made, with.made) == 0 && strcmp(without.said, with.said) == 0) {
            printf("%s: '%s' drops %s in silence\n%s\n", feature->name, parameter, extras[k],
                   text);
            dropped++;
        }
        outcome_release(&with);
    }
    outcome_release(&without);
    return dropped;
}

TEST(G0_an_input_is_used_refused_or_remarked_upon)
{
    const int cases = test_cases(1000); /* few when allocations fail */
    int dropped = 0;
    outcome_write_inputs();
    for (int i = 0; i < batten_feature_count() && i < cases; i++) {
        const batten_feature *feature = batten_feature_at(i);
        for (int k = 0; k < feature->parameter_count; k++)
            if (feature->parameters[k].kind == BATTEN_VALUE_MODEL &&
                feature->parameters[k].is_list)
                dropped += try_parameter(feature, feature->parameters[k].name);
    }
    CHECK_INT(dropped, 0);
}

/* ---- what is not wanted ---- */

static const char inputs[] = "  s: {line: [[0, 0], [4, 0]]}\n"
                             "  t: {line: [[0, 1], [4, 1]]}\n"
                             "  nose: {points: [[0, 0]]}\n"
                             "  ducks: {points: [[0, 0], [1, 2], [3, 1], [4, 0]]}\n"
                             "  made: {interpolate: ducks}\n"
                             "  ball: {sphere: 1}\n"
                             "  round: {mesh: ball, chord: 0.5}\n"
                             "  net: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 1]]}\n"
                             "  sail: {bezier-triangle: net}\n"
                             "  two: {collect: [s, t]}\n"
                             "  three: {collect: [s, t, ducks]}\n"
                             "  four: {collect: [ducks, s, ball, t]}\n";

static const expect_row of_kinds[] = {
    {"{coons: [s, nose]}", BATTEN_BAD_ARGUMENT, "'coons' takes curves, and 'nose' is a point"},
    {"{coons: [s, ducks]}", BATTEN_BAD_ARGUMENT, "'coons' takes curves, and 'ducks' is points"},
    {"{coons: [s, ball]}", BATTEN_BAD_ARGUMENT,
     "'coons' takes curves, and 'ball' is a surface"},
    {"{coons: [s, round]}", BATTEN_BAD_ARGUMENT, "'coons' takes curves, and 'round' is a mesh"},
    {"{coons: [s, sail]}", BATTEN_BAD_ARGUMENT,
     "'coons' takes curves, and 'sail' is triangles"},
    {"{coons: ducks}", BATTEN_BAD_ARGUMENT,
     "curves are needed, and 'ducks' has none; 'interpolate' ('batten fit') makes curves through "
     "its points"},
    {"{coons: [ball, ducks]}", BATTEN_BAD_ARGUMENT,
     "curves are needed, and 'ball' has none; 'interpolate' ('batten fit')"},
    {"{interpolate: s}", BATTEN_BAD_ARGUMENT,
     "points or tables of offsets are needed, and 's' has none"},
    /* Of a curve through points these are taken. */
    {"{interpolate: made, degree: 1}", BATTEN_OK, "degree 1;count 4;passes;silent"},
    {"{divide: three, count: 2}", BATTEN_OK,
     "objects 2;notes 'divide' takes curves: 1 of the 3 objects of 'three' is not used ('ducks' is "
     "points)"},
    {"{divide: four, count: 2}", BATTEN_OK,
     "objects 2;notes 2 of the 4 objects of 'four' are not used ('ducks' is points)"},
    {"{divide: two, count: 2}", BATTEN_OK, "objects 2;silent"},
};

TEST(objects_of_other_kinds_are_named_with_what_is_wanted)
{
    EXPECT(inputs, of_kinds);
}
