/* A design and one of its features, evaluated. */
#ifndef TESTS_DESIGN_EVALUATE_H
#define TESTS_DESIGN_EVALUATE_H
#include "support/test.h"

#include <batten/design.h>
#include <string.h>

static inline batten_status evaluate_design(const char *text, const char *feature,
                                            batten_notes *notes, batten_design **out)
{
    batten_design *design = NULL;
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true; /* files that the test has written */
    batten_status status = batten_design_parse(text, strlen(text), &options, notes, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, feature, NULL, notes);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

#endif
