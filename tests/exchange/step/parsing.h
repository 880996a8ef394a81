/* What tests of the STEP reader share: texts as tables of instances. */
#ifndef TESTS_EXCHANGE_STEP_PARSING_H
#define TESTS_EXCHANGE_STEP_PARSING_H
#include "exchange/reading.h"
#include "exchange/step/text/instances.h"

#define STEP_HEAD                                                           \
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"               \
    "FILE_NAME('part','2026-11-21T00:00:00',(''),(''),'pre','CAD 7','');\n" \
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
#define STEP_TAIL "ENDSEC;\nEND-ISO-10303-21;\n"

typedef struct {
    bat_input input;
    bat_step_file file;
    batten_notes *notes;
} step_text_file;

/* Begin anew with the bytes; what was read before is given back. */
static inline batten_status step_begin_bytes(step_text_file *t, const char *data, size_t size)
{
    batten_read_options options = batten_read_defaults();
    options.file_name = "t";
    bat_step_end(&t->file);
    batten_notes_free(t->notes);
    t->notes = NULL;
    batten_status status = batten_notes_create(20, &t->notes);
    if (status == BATTEN_OK)
        status = bat_input_begin(data, size, &options, NULL, t->notes, &t->input);
    if (status == BATTEN_OK)
        status = bat_input_as_text(&t->input);
    return status == BATTEN_OK ? bat_step_begin(&t->input, &t->file) : status;
}

static inline batten_status step_begin(step_text_file *t, const char *text)
{
    return step_begin_bytes(t, text, strlen(text));
}

static inline void step_end(step_text_file *t)
{
    bat_step_end(&t->file);
    batten_notes_free(t->notes);
    t->notes = NULL;
}

/* The text with the usual head and tail. */
static inline const char *step_whole(const char *data)
{
    const size_t size = strlen(STEP_HEAD) + strlen(data) + strlen(STEP_TAIL) + 1;
    char *text = test_array(size, 1);
    snprintf(text, size, "%s%s%s", STEP_HEAD, data, STEP_TAIL);
    return text;
}

/* With these words among its notes; "" for none at all. */
static inline void step_check_note(const step_text_file *t, const char *words)
{
    if (batten_notes_dropped(t->notes) > 0)
        return; /* memory failed */
    if (words[0])
        CHECK(has_note(t->notes, words));
    else
        CHECK_INT(batten_notes_count(t->notes), 0);
}

static inline const bat_step_instance *step_find(const step_text_file *t, uint64_t id)
{
    const bat_step_instance *found = bat_step_find(&t->file, id);
    CHECK(found != NULL);
    return found;
}

#endif
