#include "support/test.h"

#include <batten/design.h>
#include <string.h>

static batten_status parse_design(const char *text, batten_design **out)
{
    return batten_design_parse(text, strlen(text), NULL, NULL, out);
}

TEST(a_design_without_units_is_in_metres)
{
    static const struct {
        const char *text;
        double metres;
    } rows[] = {{"batten: 1\n", 1},
                {"batten: 1\nunits: mm\n", 0.001},
                {"batten: 1\nunits: in\n", 0.0254}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        batten_design *design = NULL;
        CHECK_OK(parse_design(rows[i].text, &design));
        CHECK_BITS(batten_design_unit_metres(design), rows[i].metres);
        batten_design_free(design);
    }
}

TEST(a_tolerance_is_a_length_above_0)
{
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"batten: 1\ntolerance: 0\n", "the tolerance must be above 0, not 0"},
        {"batten: 1\ntolerance: -1 mm\n", "the tolerance must be above 0, not -1 mm"},
        {"batten: 1\ntolerance: 2 deg\n", "the tolerance must be a length, not an angle"},
        {"batten: 1\nparameters: {a: 2 mm}\ntolerance: =a*a\n",
         "the tolerance must be a length, not an area"},
        {"batten: 1\ntolerance: =1/(2 mm)\n", "the tolerance must be a length"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        batten_design *design = NULL;
        CHECK_STATUS(parse_design(rows[i].text, &design), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
    }
    batten_design *design = NULL;
    CHECK_OK(parse_design("batten: 1\nparameters: {a: 2 mm}\ntolerance: =a/2\n", &design));
    batten_design_free(design);
}

TEST(the_version_of_the_format_is_1)
{
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"units: m\n", "'batten: 1', the version of the format, is missing"},
        {"batten: 0\n", "the format has no version 0; the first is 1"},
        {"batten: 2\n", "the format has version 2; this Batten knows up to 1"},
        {"batten: one\n", "the version of the format"},
        {"batten: 1\nunit: m\n", "a design has no section 'unit'; did you mean 'units'?"}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        batten_design *design = NULL;
        CHECK_STATUS(parse_design(rows[i].text, &design), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
    }
}
