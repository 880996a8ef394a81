/* Reads bytes as a design: an edit that is refused changes nothing, an accepted one parses
 * again. */
#include "promise.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

/* Refuse to read files: whatever a design names, it does not reach beyond its text. */
static batten_design_options options_of(const batten_limits *limits)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = "/nonexistent/fuzz.yaml";
    options.limits = limits;
    return options;
}

static void must(bool kept)
{
    if (!kept)
        abort();
}

/* What was parsed keeps its bytes; an edit that is refused changes none; one that is accepted
 * can be parsed again. */
static void edit(batten_design *design, const char *before, size_t length,
                 const batten_design_options *options)
{
    static const char *const paths[] = {"units", "parameters.a", "features.a.within"};
    static const char *const values[] = {"mm", "3 m", "a: 'b\"\n#c"};
    size_t now;
    for (int i = 0; i < 3; i++) {
        const batten_status status = batten_design_set(design, paths[i], values[i], NULL);
        const char *text = batten_design_text(design, &now);
        if (status != BATTEN_OK) {
            must(i > 0 || (now == length && memcmp(text, before, length) == 0));
            continue;
        }
        batten_design *again = NULL;
        must(batten_design_parse(text, now, options, NULL, &again) == BATTEN_OK);
        batten_design_free(again);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    batten_limits limits = batten_limits_defaults();
    limits.memory_bytes = (size_t)64 << 20;
    const batten_design_options options = options_of(&limits);
    batten_design *design = NULL;
    const batten_status status =
        batten_design_parse((const char *)data, size, &options, NULL, &design);
    must(status == BATTEN_OK ? design != NULL : design == NULL && *batten_message());
    if (status != BATTEN_OK)
        return 0;
    size_t length;
    const char *text = batten_design_text(design, &length);
    must(length == size && memcmp(text, data, size) == 0);
    edit(design, (const char *)data, size, &options);
    batten_design_free(design);
    return 0;
}
