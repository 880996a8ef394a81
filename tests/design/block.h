/* A design with a drilled block, read from a STEP file, a ball and a tank. */
#ifndef TESTS_DESIGN_BLOCK_H
#define TESTS_DESIGN_BLOCK_H
#include "support/drilled_box.h"
#include "support/test.h"

#include <batten/design.h>
#include <batten/exchange.h>
#include <stdio.h>
#include <string.h>

static inline void write_block(void)
{
    batten_body *body = NULL;
    batten_model *model = NULL;
    CHECK_OK(drilled_box(&body));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "block",
                                                      .layer = "parts",
                                                      .group = "all",
                                                      .kind = BATTEN_OBJECT_BODY,
                                                      .body = body}));
    CHECK_OK(batten_write_file(model, test_scratch("block.step"), NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(body);
}

static inline batten_status open_with_block(const char *features, batten_notes *notes,
                                            batten_design **out)
{
    char text[1000];
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("solids.yaml");
    write_block();
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n  block: {read: block.step}\n  ball: {sphere: 2}\n"
             "  tank: {cylinder: 1, height: 3}\n%s",
             features);
    return batten_design_parse(text, strlen(text), &options, notes, out);
}

#endif
