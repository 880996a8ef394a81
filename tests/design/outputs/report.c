#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>

static const char features[] =
    "batten: 1\nunits: mm\ntitle: A sheer\nfeatures:\n"
    "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 32 cm], [3 m, 29 cm], [4 m, 28 cm], [5 m, "
    "10 cm]]}\n"
    "  sheer: {interpolate: ducks, ends: natural}\n  faired: {fair: sheer, within: 2 cm}\n";

static batten_status report(const char *output, char **out)
{
    char text[900];
    snprintf(text, sizeof text, "%soutputs:\n  %s\n", features, output);
    batten_design *design = NULL;
    size_t size;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, out, &size);
    batten_design_free(design);
    return status;
}

TEST(a_text_says_what_was_done_in_design_units)
{
    char *text = NULL;
    CHECK_OK(report("r.txt: {check: faired}", &text));
    CHECK(strncmp(text, "A sheer\n", 8) == 0);
    CHECK_CONTAINS(text, "  ducks (points)\n  sheer (interpolate)\n  faired (fair)\n");
    CHECK_CONTAINS(text, " mm (curve 1, point ");
    CHECK_CONTAINS(text, "in excess: ");
    CHECK_CONTAINS(text, "Verdict: ");
    CHECK(strstr(text, "nan") == NULL && strstr(text, "inf ") == NULL);
    batten_release(text);
}

TEST(no_point_moves_farther_than_allowed_says_the_JSON)
{
    char *json = NULL;
    CHECK_OK(report("r.json: faired", &json));
    const char *moved = strstr(json, "\"moved\": {\"max\": ");
    CHECK(moved != NULL);
    const double max = atof(moved + 17);
    CHECK(max > 0 && max <= 20 * (1 + 1e-12));
    CHECK_CONTAINS(json, "\"unit\": \"mm\", \"within\": null");
    CHECK_CONTAINS(json, "\"operation\": \"fair\"");
    CHECK_CONTAINS(json, "\"fairness\": {\"fair\": ");
    batten_release(json);
}

TEST(braces_and_brackets_of_the_JSON_match)
{
    char *json = NULL;
    CHECK_OK(report("r.json: [faired, ducks]", &json));
    int depth = 0;
    bool quoted = false;
    for (const char *c = json; *c; c++) {
        quoted ^= *c == '"' && c[-1] != '\\';
        depth += !quoted && (*c == '{' || *c == '[');
        depth -= !quoted && (*c == '}' || *c == ']');
        CHECK(depth > 0 || c[1] == 0 || c[1] == '\n');
    }
    CHECK_INT(depth, 0);
    batten_release(json);
}
