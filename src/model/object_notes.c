/* Notes about the parts of an object, gathered as notes about the object. */
#include "model/object_notes.h"

#include <batten/text.h>
#include <stdio.h>
#include <string.h>

enum { KINDS = 16, NAME = 160 }; /* more kinds than that are seldom; those are not counted */

typedef struct {
    const batten_note *worst;
    double number; /* its last */
    int count;
} kind_of_notes;

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Behind the number that stands at `text`: "1e-05", "0.25", "12"; or `text`. */
static const char *past_number(const char *text, double *value)
{
    size_t used = 0;
    if (!is_digit(*text) || batten_number_read(text, strlen(text), value, &used) != BATTEN_OK)
        return text;
    return text + used;
}

static double last_number(const char *text)
{
    double last = 0;
    while (*text) {
        const char *end = past_number(text, &last);
        text = end > text ? end : text + 1;
    }
    return last;
}

static bool is_alike(const batten_note *a, const batten_note *b)
{
    const char *one = a->text, *other = b->text;
    double number;
    if (a->is_remark != b->is_remark)
        return false;
    while (*one && *other) {
        const char *past = past_number(one, &number), *beside = past_number(other, &number);
        if ((past == one) != (beside == other) || (past == one && *one != *other))
            return false;
        one = past == one ? one + 1 : past;
        other = beside == other ? other + 1 : beside;
    }
    return *one == *other;
}

/* Does a length end the sentence? Whole numbers may be counts. */
static bool ends_with_length(const char *text)
{
    const size_t length = strlen(text);
    size_t begin = length;
    while (begin > 0 && text[begin - 1] != ' ')
        begin--;
    return length > begin && is_digit(text[begin]) && is_digit(text[length - 1]) &&
           strpbrk(text + begin, ".e");
}

static void pass(const kind_of_notes *kind, const char *object, double unit_metres,
                 batten_notes *to)
{
    const batten_note *note = kind->worst;
    const char *unit =
        unit_metres > 0 && ends_with_length(note->text) ? batten_unit_name(unit_metres) : NULL;
    char entity[NAME], more[48] = "";
    snprintf(entity, sizeof entity, "%.70s%s%.70s", object,
             *object && *note->entity ? ": " : "", note->entity);
    if (kind->count > 1)
        snprintf(more, sizeof more, "; and %d more like it", kind->count - 1);
    (note->is_remark ? batten_notes_remark
                     : batten_notes_add)(to, note->file, note->line, entity, "%s%s%s%s",
                                         note->text, unit ? " " : "", unit ? unit : "", more);
}

void bat_object_notes(const batten_notes *from, const char *object, double unit_metres,
                      batten_notes *to)
{
    kind_of_notes kinds[KINDS];
    int count = 0;
    for (int i = 0; i < batten_notes_count(from); i++) {
        const batten_note *note = batten_notes_at(from, i);
        const kind_of_notes one = {note, last_number(note->text), 1};
        int k = 0;
        while (k < count && !is_alike(kinds[k].worst, note))
            k++;
        if (k == KINDS) {
            pass(&one, object, unit_metres, to);
        } else if (k == count) {
            kinds[count++] = one;
        } else {
            kinds[k].count++;
            if (one.number > kinds[k].number) {
                kinds[k].worst = note;
                kinds[k].number = one.number;
            }
        }
    }
    for (int k = 0; k < count; k++)
        pass(&kinds[k], object, unit_metres, to);
}
