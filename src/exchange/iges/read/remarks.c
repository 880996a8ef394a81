/* What is reported of the entities of an IGES file. */
#include "exchange/iges/read/reading.h"

#include <stdio.h>

bool bat_iges_is_fault_of_data(batten_status status)
{
    return status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY &&
           status != BATTEN_CANCELLED && status != BATTEN_INCOMPLETE &&
           status != BATTEN_TOO_LARGE;
}

enum { WHAT = BAT_IGES_TYPE_NAME + 16, SENTENCE = 400 };

static void name_entry(const bat_iges_reading *reading, const bat_iges_entry *entry,
                       char what[WHAT])
{
    char name[BAT_IGES_TYPE_NAME];
    bat_iges_name_of_type(reading, entry->type, name);
    snprintf(what, WHAT, "#%d %s", entry->id, name);
}

batten_status bat_iges_fault_in(batten_status status, int id)
{
    char said[140];
    if (!bat_iges_is_fault_of_data(status))
        return status;
    snprintf(said, sizeof said, "%.139s", batten_message());
    return bat_fail(status, "D%d: %s", id, said);
}

void bat_iges_count_odd(bat_iges_odd *odd, const bat_iges_entry *entry, int value)
{
    if (odd->count++)
        return;
    odd->first = entry;
    odd->value = value;
}

batten_status bat_iges_forgive(batten_status status, bat_iges_odd *odd,
                               const bat_iges_entry *entry, int value)
{
    if (!bat_iges_is_fault_of_data(status))
        return status;
    if (odd->count == 0)
        snprintf(odd->why, sizeof odd->why, "%.159s", batten_message());
    bat_iges_count_odd(odd, entry, value);
    return BATTEN_OK;
}

void bat_iges_note(const bat_iges_reading *reading, const bat_iges_entry *entry,
                   const char *format, ...)
{
    char what[WHAT], sentence[SENTENCE];
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    name_entry(reading, entry, what);
    batten_notes_add(reading->input->notes, reading->input->file, entry->line, what, "%s",
                     sentence);
}

void bat_iges_remark(const bat_iges_reading *reading, const bat_iges_entry *entry,
                     const char *format, ...)
{
    char what[WHAT], sentence[SENTENCE];
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    name_entry(reading, entry, what);
    batten_notes_remark(reading->input->notes, reading->input->file, entry->line, what, "%s",
                        sentence);
}
