/* Sorts the 80-column records into sections, and reads the directory. */
#include "exchange/iges/text/data.h"

#include <limits.h>
#include <string.h>

/* ---- records ---- */

/* A record of the directory as it came. */
typedef struct {
    bat_span text;
    int number, line;
    bool is_damaged;
} directory_record;

static batten_status add_directory(bat_iges_file *file, bat_span record, int line,
                                   bool is_damaged)
{
    const directory_record made = {record, is_damaged ? -1 : bat_iges_sequence_number(record),
                                   line, is_damaged};
    return bat_list_add(file->input, &file->directory, &made);
}

/* The letter of a section, or 0. */
static char section_of(bat_span record)
{
    const char letter = record.length > LETTER ? record.bytes[LETTER] : '\0';
    const bool known =
        letter == 'P' || letter == 'D' || letter == 'S' || letter == 'G' || letter == 'T';
    return known ? letter : '\0';
}

/* `section` is that of the record before: where a record without a letter is taken to belong.
 */
static batten_status add_record(bat_iges_file *file, bat_span record, bool is_plain, int line,
                                char *section)
{
    const char letter = section_of(record);
    const bool tab = !is_plain && memchr(record.bytes, '\t',
                                         record.length < LETTER ? record.length : LETTER);
    const bool damaged = !letter || tab;
    if (damaged)
        batten_notes_add(file->input->notes, file->input->file, line, "",
                         "the record is damaged: %s",
                         tab ? "it has a tab" : "column 73 has no letter of a section");
    if (letter && letter != *section && strchr("SGDPT", letter) < strchr("SGDPT", *section))
        batten_notes_add(file->input->notes, file->input->file, line, "",
                         "section %c comes after section %c", letter, *section);
    if (letter)
        *section = letter;
    file->has_start |= letter == 'S';
    file->has_end |= letter == 'T';
    if (*section == 'G' && !damaged)
        return bat_iges_append(file->input, &file->global.text, record, GLOBAL_COLUMNS);
    if (*section == 'D')
        return add_directory(file, record, line, damaged);
    if (*section == 'P')
        return bat_iges_add_data(file, record, line, damaged);
    return BATTEN_OK;
}

static bool is_blank_record(bat_span record)
{
    for (size_t i = 0; i < record.length; i++)
        if (!bat_is_blank(record.bytes[i]))
            return false;
    return true;
}

enum { STEP = 1024 }; /* lines between questions whether to go on */

static batten_status read_records(bat_iges_file *file)
{
    bat_input *input = file->input;
    bat_span record;
    char section = 'S';
    int line = 0;
    batten_status status = BATTEN_OK;
    for (size_t at = 0; status == BATTEN_OK;) {
        if (section == 'P' && line < INT_MAX - STEP) {
            const size_t count =
                bat_iges_add_to_run(file, at, line, (size_t)(STEP - 1 - line % STEP));
            if (count > 0)
                at += count * ((bat_iges_run *)file->runs.items)[file->runs.count - 1].stride;
            line += (int)count;
        }
        const size_t plain = bat_iges_plain_record(input, at);
        if (plain > 0) {
            record = (bat_span){input->data + at, RECORD};
            at += plain;
        } else if (!bat_next_line(input, &at, &record)) {
            break;
        }
        line += line < INT_MAX;
        if (line % STEP == 0)
            status = bat_input_step(input, at);
        if (status == BATTEN_OK && plain > 0 && section == 'P' && record.bytes[LETTER] == 'P') {
            status = bat_iges_add_data(file, record, line, false);
        } else if (status == BATTEN_OK && !is_blank_record(record)) {
            if (section == 'T') {
                batten_notes_add(input->notes, input->file, line, "",
                                 "text follows the last record; not read");
                break;
            }
            status = add_record(file, record, plain > 0, line, &section);
        }
    }
    return status;
}

/* ---- the directory ---- */

#define FIELD 8

/* The integer of a field of 8 columns; blanks are 0. False, and the value as it was, when there is none. */
static bool read_field(bat_span record, int field, int *value)
{
    const size_t begin = (size_t)(FIELD * field), end = begin + FIELD;
    int digits = 0, sign = 1, number = 0;
    bool done = false;
    for (size_t i = begin; i < end; i++) {
        const char c = i < record.length ? record.bytes[i] : ' ';
        if (c >= '0' && c <= '9' && !done) {
            number = 10 * number + (c - '0');
            digits++;
        } else if ((c == '-' || c == '+') && digits == 0 && sign == 1) {
            sign = c == '-' ? -1 : 1;
        } else if (c != ' ') {
            return false;
        } else {
            done = digits > 0;
        }
    }
    *value = sign * number;
    return true;
}

/* The same for a field that others can do without: 0 when it is no integer. */
static int read_loosely(bat_span record, int field)
{
    int value = 0;
    read_field(record, field, &value);
    return value;
}

/* Two digits of the status, from column `at` of its field on; blanks are zeros. */
static int status_digits(bat_span record, size_t at)
{
    int value = 0;
    for (size_t i = 64 + at; i < 64 + at + 2; i++) {
        const char c = i < record.length ? record.bytes[i] : ' ';
        value = 10 * value + (c >= '0' && c <= '9' ? c - '0' : 0);
    }
    return value;
}

static bat_iges_entry read_entry(bat_span first, bat_span second, int line)
{
    bat_iges_entry entry = {.line = line};
    int again = 0;
    const bool good = read_field(first, 0, &entry.type) && read_field(first, 1, &entry.data) &&
                      read_field(first, 6, &entry.transform) && read_field(second, 0, &again) &&
                      read_field(second, 4, &entry.form);
    entry.level = read_loosely(first, 4);
    entry.colour = read_loosely(second, 2);
    entry.subscript = read_loosely(second, 8);
    entry.is_broken = !good || again != entry.type;
    entry.hidden = status_digits(first, 0);
    entry.subordinate = status_digits(first, 2);
    entry.use = status_digits(first, 4);
    size_t length = 0;
    for (size_t i = 0; i < FIELD && 56 + i < second.length; i++)
        if (second.bytes[56 + i] != ' ' || length > 0)
            entry.label[length++] = second.bytes[56 + i];
    while (length > 0 && entry.label[length - 1] == ' ')
        entry.label[--length] = '\0';
    return entry;
}

/* Do the records come in pairs with rising numbers, the first of each pair odd? */
static bool is_well_numbered(const directory_record *records, size_t count)
{
    int last = -1;
    for (size_t i = 0; i + 1 < count; i += 2) {
        const int number = records[i].number;
        if (number % 2 != 1 || number <= last || records[i + 1].number != number + 1)
            return false;
        last = number;
    }
    return true;
}

/* Records stand in pairs. Where their numbers are no good, their places count. */
static batten_status read_directory(bat_iges_file *file)
{
    const directory_record *records = file->directory.items;
    const size_t count = file->directory.count;
    bat_input *input = file->input;
    batten_status status =
        bat_input_limit(input, 0, count / 2, input->limits.entities, "entities");
    const bool numbered = is_well_numbered(records, count);
    for (size_t i = 0; status == BATTEN_OK && i < count; i += 2) {
        const bool whole = i + 1 < count;
        const bat_span none = {"", 0};
        bat_iges_entry entry =
            read_entry(records[i].text, whole ? records[i + 1].text : none, records[i].line);
        entry.is_broken |= !whole || records[i].is_damaged || records[i + 1].is_damaged;
        entry.id = numbered && whole ? records[i].number : (int)i + 1;
        status = bat_list_add(input, &file->entries, &entry);
    }
    if (!numbered)
        batten_notes_add(
            input->notes, input->file, 0, "",
            "the sequence numbers of the D section are wrong; the records are counted");
    return status;
}

batten_status bat_iges_begin(bat_input *input, bat_iges_file *file)
{
    *file = (bat_iges_file){.input = input,
                            .delimiters = {',', ';'},
                            .directory = {.size = sizeof(directory_record)},
                            .entries = {.size = sizeof(bat_iges_entry)},
                            .runs = {.size = sizeof(bat_iges_run)}};
    bat_iges_parameters_begin(&file->global);
    batten_status status = read_records(file);
    if (status == BATTEN_OK) {
        bat_iges_number_data(file);
        status = read_directory(file);
    }
    return status;
}

void bat_iges_end(bat_iges_file *file)
{
    bat_iges_parameters_end(&file->global);
    bat_release(file->directory.items);
    bat_release(file->entries.items);
    bat_release(file->runs.items);
}
