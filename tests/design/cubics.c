#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* The bytes of the first output of a design, as the test's. */
static const char *output_of(const char *text)
{
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    char *copy = test_array(size + 1, 1);
    memcpy(copy, data, size);
    batten_release(data);
    batten_design_free(design);
    return copy;
}

TEST(a_report_of_cubics_says_what_each_span_is)
{
    static const char design[] =
        "batten: 1\nfeatures:\n"
        "  ducks: {points: [[0, 0], [3, 0.4], [3.3, 1], [3.4, 2], [2.2, 3], [2, 3.02], [0.3, "
        "2]]}\n"
        "  c: {interpolate: ducks, parameters: uniform, ends: natural}\n"
        "outputs:\n  a.txt: {classify: c}\n";
    const char *text = output_of(design);
    CHECK_CONTAINS(text, "c: 6 spans");
    CHECK_CONTAINS(text, "span 5: a loop");
    CHECK_CONTAINS(text, "crosses itself at ");
    CHECK_CONTAINS(text, "(regular)");
}

TEST(a_report_of_cubics_in_json_has_all_keys)
{
    static const char design[] = "batten: 1\nfeatures:\n"
                                 "  l: {line: [[0, 0], [1, 0]]}\n"
                                 "outputs:\n  a.json: {classify: l}\n";
    const char *text = output_of(design);
    CHECK_CONTAINS(text, "\"segment\": \"line\"");
    CHECK_CONTAINS(text, "\"invariant\": null");
    CHECK_CONTAINS(text, "\"inflections\": []");
}
