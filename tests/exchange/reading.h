/* What the tests of readers share. */
#ifndef TESTS_EXCHANGE_READING_H
#define TESTS_EXCHANGE_READING_H
#include <batten/exchange.h>
#include <batten/text.h>

#include "support/test.h"

static inline batten_status read_bytes(const char *data, size_t size, batten_format format,
                                       batten_notes *notes, batten_model **out)
{
    batten_read_options options = batten_read_defaults();
    options.format = format;
    options.file_name = "t";
    return batten_read_memory(data, size, &options, NULL, notes, out);
}

static inline batten_status read_text(const char *text, batten_format format,
                                      batten_notes *notes, batten_model **out)
{
    return read_bytes(text, strlen(text), format, notes, out);
}

/* Reading it as the format must fail so, with these words, and make no model. */
static inline void check_refused(const char *text, batten_format format, batten_status status,
                                 const char *words)
{
    batten_model *model = NULL;
    CHECK_STATUS(read_text(text, format, NULL, &model), status);
    CHECK(model == NULL);
    CHECK_MESSAGE(words);
}

/* What comes back of the model; its second writing gives the same bytes. */
static inline batten_model *there_and_back(const batten_model *model,
                                           const batten_write_options *options,
                                           batten_notes *notes)
{
    batten_model *back = NULL;
    char *first = NULL, *second = NULL;
    size_t first_size = 0, second_size = 0;
    CHECK_OK(batten_write_memory(model, options, notes, &first, &first_size));
    CHECK_OK(read_bytes(first, first_size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_OK(batten_write_memory(back, options, NULL, &second, &second_size));
    CHECK_INT((long long)second_size, (long long)first_size);
    CHECK(memcmp(first, second, first_size) == 0);
    batten_release(first);
    batten_release(second);
    return back;
}

/* Is there a note with these words? */
static inline bool has_note(const batten_notes *notes, const char *words)
{
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (strstr(batten_notes_at(notes, i)->text, words))
            return true;
    return false;
}

/* How many notes there are that are no remarks. */
static inline int count_warnings(const batten_notes *notes)
{
    int count = 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        count += !batten_notes_at(notes, i)->is_remark;
    return count;
}

/* Read to that end, with a note that has these words; "" for none but remarks. Under memory
 * faults a note may be lost, so that only the reading itself is checked then. */
static inline batten_model *read_so(const char *text, batten_format format, batten_status due,
                                    const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    batten_status status = read_text(text, format, notes, &model);
    if (test_memory_failed(status, due)) { /* what it noted is of no account */
        batten_notes_free(notes);
        notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        status = read_text(text, format, notes, &model);
    }
    CHECK_STATUS(status, due);
    const int count = count_warnings(notes), lost = batten_notes_dropped(notes);
    if (lost == 0 && words[0])
        CHECK(has_note(notes, words));
    if (lost == 0 && !words[0])
        CHECK_INT(count, 0);
    batten_notes_free(notes);
    return model;
}

static inline batten_model *read_noting(const char *text, batten_format format,
                                        const char *words)
{
    return read_so(text, format, BATTEN_OK, words);
}

static inline batten_status write_bytes(const batten_model *model, batten_format format,
                                        char **data, size_t *size)
{
    batten_write_options options = batten_write_defaults();
    options.format = format;
    return batten_write_memory(model, &options, NULL, data, size);
}

/* The whole of a file, for tests that cut and change it; given back when the test ends. */
static inline char *load_bytes(const char *path, size_t *size)
{
    char *data = NULL;
    CHECK_OK(batten_load_file(path, (size_t)1 << 30, &data, size));
    char *copy = test_array(*size + 1, 1);
    memcpy(copy, data, *size);
    batten_release(data);
    return copy;
}

#endif
