/* Outputs and the words that they must have: see expect.h. */
#include "design/expect.h"
#include "support/json.h"

#include <stdlib.h>

static batten_status make_output(const char *before, const char *output, char **data,
                                 size_t *size)
{
    char text[6000];
    batten_design *design = NULL;
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("outputs.yaml");
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\ntolerance: 0.001\nfeatures:\n%soutputs:\n  %s\n", before,
             output);
    batten_status status = batten_design_parse(text, strlen(text), &options, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_output(design, 0, NULL, NULL, data, size);
    batten_design_free(design);
    return status;
}

static bool has_words(const char *text, const char *words)
{
    while (*words) {
        char word[400];
        const size_t length = strcspn(words, "|");
        const bool absent = *words == '!';
        snprintf(word, sizeof word, "%.*s", (int)(length - absent), words + absent);
        if ((strstr(text, word) == NULL) != absent) {
            fprintf(stderr, "    %s: %s\n", absent ? "there should not be" : "there should be",
                    word);
            return false;
        }
        words += length + (words[length] == '|');
    }
    return true;
}

static bool is_good(const expect_row *row, batten_status status, const char *data, size_t size)
{
    if (status != row->status)
        return false;
    if (status != BATTEN_OK)
        return has_words(batten_message(), row->facts);
    char *text = test_array(size + 1, 1);
    memcpy(text, data, size);
    if (strstr(row->feature, ".json:"))
        CHECK_TEXT(json_blank(json_behind(text)), "");
    return has_words(text, row->facts);
}

void expect_outputs(const char *before, const expect_row *rows, int count)
{
    int wrong = 0;
    for (int i = 0; i < count; i++) {
        char *data = NULL;
        size_t size = 0;
        batten_status status = make_output(before, rows[i].feature, &data, &size);
        if (test_memory_failed(status, rows[i].status))
            status = make_output(before, rows[i].feature, &data, &size);
        if (!is_good(&rows[i], status, data, size)) {
            wrong++;
            fprintf(stderr, "%s\n    %s %s\n%.*s\n", rows[i].feature,
                    batten_status_name(status), status == BATTEN_OK ? "" : batten_message(),
                    (int)(size < 1500 ? size : 1500), data ? data : "");
        }
        batten_release(data);
    }
    CHECK_INT(wrong, 0);
}
