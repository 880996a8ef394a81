/* All that a reader says of a text, line by line. */
#ifndef TESTS_EXCHANGE_LISTED_H
#define TESTS_EXCHANGE_LISTED_H
#include "exchange/reading.h"

/* Read the bytes to this status; every note, in order, is "line: text" or, of an entity, "line:
 * entity: text", with an end of line after each; remarks begin with "~". A failure without a model adds
 * its message. @return the model, which may be NULL */
static inline batten_model *read_listed(const char *data, size_t size, batten_format format,
                                        batten_status due, const char *listing)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(50, &notes));
    batten_status status = read_bytes(data, size, format, notes, &model);
    if (test_memory_failed(status, due))
        status = read_bytes(data, size, format, NULL, &model);
    else if (!batten_notes_dropped(notes)) {
        char *list = test_array(20000, 1), *at = list;
        for (int i = 0; i < batten_notes_count(notes); i++) {
            const batten_note *n = batten_notes_at(notes, i);
            at += sprintf(at, "%s%d: %s%s%s\n", n->is_remark ? "~" : "", n->line, n->entity,
                          n->entity[0] ? ": " : "", n->text);
            CHECK_TEXT(n->file, "t");
        }
        if (!model)
            sprintf(at, "%s\n", batten_message());
        if (test_cases(1000) >= 1000)
            CHECK_TEXT(list, listing);
    }
    CHECK_STATUS(status, due);
    batten_notes_free(notes);
    return model;
}

static inline void check_listed(const char *text, batten_format format, batten_status due,
                                const char *listing)
{
    batten_model_unref(read_listed(text, strlen(text), format, due, listing));
}

#endif
