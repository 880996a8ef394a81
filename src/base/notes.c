/*
 * A bounded list of remarks on a file, each with the line and the entity it concerns. Beyond
 * the limit notes are only counted.
 */
#include "base/base.h"
#include <batten/base.h>

#include <limits.h>
#include <string.h>

struct batten_notes {
    int limit, count, capacity, dropped;
    batten_note *notes; /* the strings of each are one block, which begins with the file */
};

batten_status batten_notes_create(int limit, batten_notes **out)
{
    if (limit < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a list of %d notes cannot be", limit);
    batten_notes *notes = bat_array(1, sizeof *notes);
    if (!notes)
        return BATTEN_OUT_OF_MEMORY;
    notes->limit = limit;
    *out = notes;
    return BATTEN_OK;
}

void batten_notes_free(batten_notes *notes)
{
    if (!notes)
        return;
    for (int i = 0; i < notes->count; i++) {
        char *block;
        memcpy(&block, &notes->notes[i].file, sizeof block);
        bat_release(block);
    }
    bat_release(notes->notes);
    bat_release(notes);
}

/* Room for one more. */
static bool make_room(batten_notes *notes)
{
    if (notes->count < notes->capacity)
        return true;
    const int capacity = bat_min_int(
        notes->limit, notes->capacity > INT_MAX / 2 ? INT_MAX : 2 * notes->capacity + 8);
    batten_note *grown = bat_resize(notes->notes, (size_t)capacity, sizeof *grown);
    if (!grown)
        return false;
    notes->notes = grown;
    notes->capacity = capacity;
    return true;
}

/* A copy of `text` at `*place`, which moves on. */
static const char *copy_text(char **place, const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = memcpy(*place, text, size);
    *place += size;
    return copy;
}

static bool store_note(batten_notes *notes, const char *file, int line, const char *entity,
                       const char *text, bool is_remark)
{
    if (notes->count >= notes->limit || !make_room(notes))
        return false;
    char *place = bat_array(strlen(file) + strlen(entity) + strlen(text) + 3, 1);
    if (!place)
        return false;
    batten_note *note = &notes->notes[notes->count++];
    note->file = copy_text(&place, file);
    note->line = line;
    note->entity = copy_text(&place, entity);
    note->text = copy_text(&place, text);
    note->is_remark = is_remark;
    return true;
}

static void add_note(batten_notes *notes, const char *file, int line, const char *entity,
                     bool is_remark, const char *format, va_list arguments)
    __attribute__((format(printf, 6, 0)));

static void add_note(batten_notes *notes, const char *file, int line, const char *entity,
                     bool is_remark, const char *format, va_list arguments)
{
    char text[1024];
    if (!notes)
        return;
    bat_format(text, sizeof text, format, arguments);
    if (!store_note(notes, file ? file : "", line, entity ? entity : "", text, is_remark) &&
        notes->dropped < INT_MAX)
        notes->dropped++;
}

void batten_notes_add(batten_notes *notes, const char *file, int line, const char *entity,
                      const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    add_note(notes, file, line, entity, false, format, arguments);
    va_end(arguments);
}

void batten_notes_remark(batten_notes *notes, const char *file, int line, const char *entity,
                         const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    add_note(notes, file, line, entity, true, format, arguments);
    va_end(arguments);
}

int batten_notes_count(const batten_notes *notes)
{
    return notes->count;
}

int batten_notes_dropped(const batten_notes *notes)
{
    return notes->dropped;
}

const batten_note *batten_notes_at(const batten_notes *notes, int index)
{
    assert(index >= 0 && index < notes->count);
    return &notes->notes[index];
}
