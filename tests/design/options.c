/* Options of designs: every size in them is checked. */
#include "support/options.h"

#include <batten/design.h>

static void default_design(void *options)
{
    const batten_design_options defaults = batten_design_defaults();
    memcpy(options, &defaults, sizeof defaults);
}

static batten_status call_parse(const void *stage, const void *options)
{
    const char *text = stage;
    batten_design *design = NULL;
    const batten_status status =
        batten_design_parse(text, strlen(text), options, NULL, &design);
    batten_design_free(design);
    return status;
}

static const options_taker takers[] = {{"batten_design_parse", "batten_design_options",
                                        sizeof(batten_design_options), default_design,
                                        call_parse}};

TEST(a_size_that_nobody_set_or_that_is_longer_than_ours_is_refused)
{
    check_wrong_sizes(COUNT(takers), takers, "batten: 1\n");
}

TEST(a_shorter_struct_gives_what_the_defaults_give)
{
    check_shorter_options(COUNT(takers), takers, "batten: 1\nfeatures: {a: {points: []}}\n");
}

TEST(the_size_of_limits_inside_the_options_is_checked_too)
{
    batten_limits limits = batten_limits_defaults();
    batten_design_options options = batten_design_defaults();
    batten_design *design = NULL;
    limits.size = 3;
    options.limits = &limits;
    CHECK_STATUS(batten_design_parse("batten: 1", 9, &options, NULL, &design),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the size in a batten_limits is 3;");
    CHECK(design == NULL);
}
