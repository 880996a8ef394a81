/* How large a picture is, in bytes: what it shows beside another one makes it larger. */
#ifndef TESTS_DESIGN_PICTURE_SIZE_H
#define TESTS_DESIGN_PICTURE_SIZE_H
#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* Of an output like "picture: ring, isolines: 2", after lines of features. */
static inline size_t picture_size(const char *features, const char *output)
{
    char text[1500];
    batten_design *design = NULL;
    char *data = NULL;
    size_t size = 0;
    snprintf(text, sizeof text, "batten: 1\nunits: m\nfeatures:\n%soutputs:\n  a.svg: {%s}\n",
             features, output);
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_output(design, 0, NULL, NULL, &data, &size));
    batten_release(data);
    batten_design_free(design);
    return size;
}

#endif
