#include "exchange/iges/records.h"

#include <limits.h>
#include <string.h>

#define DATA_COLUMNS 64
#define GLOBAL_COLUMNS 72
#define RECORD 80
#define LETTER 72 /* where the letter of the section stands */

/* ---- many characters at once ---- */

/* Compilers make one instruction of a comparison of all. */
typedef unsigned char characters __attribute__((vector_size(16)));

static inline bool any_of(characters marks)
{
    uint64_t halves[2];
    memcpy(halves, &marks, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

/* ---- records ---- */

/* A number in blanks or after zeros; -1 when there is none. */
static int sequence_number(bat_span record)
{
    int number = 0;
    bool any = false;
    for (size_t i = LETTER + 1; i < record.length && i < 80; i++) {
        const char c = record.bytes[i];
        if (c >= '0' && c <= '9') {
            number = 10 * number + (c - '0');
            any = true;
        } else if (c != ' ' || any) {
            return -1;
        }
    }
    return any ? number : -1;
}

/* Append the first `columns` characters of a record, blanks where it ends before. */
static batten_status append(bat_input *input, bat_list *list, bat_span record, size_t columns)
{
    static const char blanks[GLOBAL_COLUMNS + 1] =
        "                                                                        ";
    const size_t filled = record.length < columns ? record.length : columns;
    batten_status status = bat_list_append(input, list, record.bytes, filled);
    if (status == BATTEN_OK && filled < columns)
        status = bat_list_append(input, list, blanks, columns - filled);
    return status;
}

/* The sequence number of a record of the P section: nearly always the next one, and as long. */
static int next_number(bat_iges_file *file, bat_span record)
{
    const size_t width = sizeof file->next;
    size_t i = width;
    while (i > 0 && file->next[i - 1] == '9')
        file->next[--i] = '0';
    if (i > 0)
        file->next[i - 1] = (char)(file->next[i - 1] == ' ' ? '1' : file->next[i - 1] + 1);
    file->number++;
    if (record.length < LETTER + 1 + width ||
        memcmp(file->next, record.bytes + LETTER + 1, width) != 0) {
        memset(file->next, '9', width); /* matches nothing until one is read */
        file->number = sequence_number(record);
        if (record.length >= LETTER + 1 + width && file->number > 0)
            memcpy(file->next, record.bytes + LETTER + 1, width);
    }
    return file->number;
}

static batten_status add_data(bat_iges_file *file, bat_span record, int line, bool is_damaged)
{
    const bool is_short = record.length < DATA_COLUMNS;
    bat_list *list = &file->data;
    batten_status status = BATTEN_OK;
    if (list->count == list->capacity)
        status = bat_list_reserve(file->input, list, 1);
    if (status != BATTEN_OK)
        return status;
    ((bat_iges_data *)list->items)[list->count++] =
        (bat_iges_data){.at = (size_t)(record.bytes - file->input->data),
                        .number = is_damaged ? -1 : next_number(file, record),
                        .line = line,
                        .columns = (unsigned char)(is_short ? record.length : DATA_COLUMNS),
                        .is_damaged = is_damaged};
    return BATTEN_OK;
}

/* A record of the directory as it came. */
typedef struct {
    bat_span text;
    int number, line;
    bool is_damaged;
} directory_record;

static batten_status add_directory(bat_iges_file *file, bat_span record, int line,
                                   bool is_damaged)
{
    const directory_record made = {record, is_damaged ? -1 : sequence_number(record), line,
                                   is_damaged};
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
        return append(file->input, &file->global.text, record, GLOBAL_COLUMNS);
    if (*section == 'D')
        return add_directory(file, record, line, damaged);
    if (*section == 'P')
        return add_data(file, record, line, damaged);
    return BATTEN_OK;
}

static bool is_blank_record(bat_span record)
{
    for (size_t i = 0; i < record.length; i++)
        if (!bat_is_blank(record.bytes[i]))
            return false;
    return true;
}

/* Does a record of 80 columns and a line feed stand there, without control characters? Nearly
 * all do, and this is the fastest way to see it. */
static bool is_plain_record(const bat_input *input, size_t at)
{
    characters below = {0};
    if (input->size - at <= RECORD || input->data[at + RECORD] != '\n')
        return false;
    for (size_t i = 0; i < RECORD; i += sizeof below) {
        characters some;
        memcpy(&some, input->data + at + i, sizeof some);
        below |= (characters)(some < ' ');
    }
    return !any_of(below);
}

static batten_status read_records(bat_iges_file *file)
{
    bat_input *input = file->input;
    bat_span record;
    char section = 'S';
    int line = 0;
    batten_status status = BATTEN_OK;
    for (size_t at = 0; status == BATTEN_OK && at < input->size;) {
        const bool is_plain = is_plain_record(input, at);
        if (is_plain) {
            record = (bat_span){input->data + at, RECORD};
            at += RECORD + 1;
        } else if (!bat_next_line(input, &at, &record)) {
            break;
        }
        line += line < INT_MAX;
        if (line % 1024 == 0)
            status = bat_input_step(input, at);
        if (status == BATTEN_OK && is_plain && section == 'P' && record.bytes[LETTER] == 'P') {
            status = add_data(file, record, line, false); /* nearly always */
        } else if (status == BATTEN_OK && !is_blank_record(record)) {
            if (section == 'T') {
                batten_notes_add(input->notes, input->file, line, "",
                                 "text follows the last record; not read");
                break;
            }
            status = add_record(file, record, is_plain, line, &section);
        }
    }
    return status;
}

/* Where the sequence numbers do not rise, the places of the records count. */
static void number_data(bat_iges_file *file)
{
    bat_iges_data *data = file->data.items;
    const size_t count = file->data.count;
    size_t bad = count;
    int last = 0;
    for (size_t i = 0; i < count && bad == count; i++) {
        if (data[i].is_damaged)
            data[i].number = last; /* not found before that record, which stands first */
        else if (data[i].number <= last)
            bad = i;
        last = data[i].number;
    }
    if (bad == count)
        return;
    batten_notes_add(
        file->input->notes, file->input->file, data[bad].line, "",
        "the sequence numbers of the P section are wrong; the records are counted");
    for (size_t i = 0; i < count; i++)
        data[i].number = (int)i + 1;
}

/* ---- the directory ---- */

#define FIELD 8

/* The integer of a field of 8 columns; blanks are 0. */
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
    return read_field(record, field, &value) ? value : 0;
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
                            .data = {.size = sizeof(bat_iges_data)}};
    bat_iges_parameters_begin(&file->global);
    batten_status status = read_records(file);
    if (status == BATTEN_OK) {
        number_data(file);
        status = read_directory(file);
    }
    return status;
}

void bat_iges_end(bat_iges_file *file)
{
    bat_iges_parameters_end(&file->global);
    bat_release(file->directory.items);
    bat_release(file->entries.items);
    bat_release(file->data.items);
}

/* ---- the global section ---- */

static bool may_delimit(char c)
{
    return c > ' ' && c < 127 && !strchr("0123456789+-.DEHde", c);
}

static size_t past_blanks(bat_span text, size_t at)
{
    while (at < text.length && text.bytes[at] == ' ')
        at++;
    return at;
}

/* The first two global parameters, "1Hc" or nothing each, say the delimiters. */
static batten_status read_delimiters(bat_iges_file *file, bat_span text, size_t *at)
{
    char found[2] = {',', ';'};
    for (int k = 0; k < 2; k++) {
        *at = past_blanks(text, *at);
        if (text.length - *at >= 4 && memcmp(text.bytes + *at, "1H", 2) == 0) {
            found[k] = text.bytes[*at + 2];
            *at = past_blanks(text, *at + 3);
        }
        if (*at >= text.length || text.bytes[*at] != found[0])
            return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0,
                                  "the global section does not begin with its delimiters");
        (*at)++;
    }
    if (!may_delimit(found[0]) || !may_delimit(found[1]) || found[0] == found[1])
        return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0,
                              "the global section names '%c' and '%c' as delimiters", found[0],
                              found[1]);
    file->delimiters = (bat_iges_delimiters){found[0], found[1]};
    return BATTEN_OK;
}

batten_status bat_iges_global(bat_iges_file *file)
{
    const bat_span text = {file->global.text.items, file->global.text.count};
    size_t at = 0;
    bool done = false;
    if (text.length == 0)
        return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0, "there is no global section");
    batten_status status = read_delimiters(file, text, &at);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_tokenise(file->input, file->delimiters, &file->global, &at, &done);
    if (status == BATTEN_OK && !done)
        status = bat_fail(BATTEN_BAD_FORMAT, "the parameters have no end");
    if (status != BATTEN_BAD_FORMAT)
        return status;
    return bat_input_fail(file->input, status, 0, "global section: %.200s", batten_message());
}

/* ---- the parameters of an entry ---- */

/* The place of the data record of that number, or the count when there is none. */
static size_t find_data(const bat_iges_file *file, int number)
{
    const bat_iges_data *data = file->data.items;
    size_t low = 0, high = file->data.count;
    if (number > 0 && (size_t)number <= high && data[number - 1].number == number)
        high = (size_t)number; /* nearly always */
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (data[middle].number < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low < file->data.count && data[low].number == number ? low : file->data.count;
}

/* The records first .. last must follow each other without a gap. */
static batten_status check_data(const bat_iges_file *file, size_t first, size_t last)
{
    const bat_iges_data *data = file->data.items;
    for (size_t i = first; i <= last; i++) {
        if (data[i].is_damaged)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "record %zu of the P section, line %d, is damaged", i + 1,
                            data[i].line);
        if (i > first && data[i].number != data[i - 1].number + 1)
            return bat_fail(BATTEN_BAD_FORMAT, "record %d of the P section is missing",
                            data[i - 1].number + 1);
    }
    return BATTEN_OK;
}

/* Append the first 64 characters of a record; is `sought` among them? */
static batten_status append_columns(bat_input *input, bat_list *text, const char *from,
                                    char sought, bool *found)
{
    batten_status status = BATTEN_OK;
    if (text->capacity - text->count < DATA_COLUMNS)
        status = bat_list_reserve(input, text, DATA_COLUMNS);
    if (status != BATTEN_OK)
        return status;
    char *to = (char *)text->items + text->count;
    characters same = {0};
    for (size_t i = 0; i < DATA_COLUMNS; i += sizeof same) {
        characters some;
        memcpy(&some, from + i, sizeof some);
        memcpy(to + i, &some, sizeof some);
        same |= (characters)(some == (unsigned char)sought);
    }
    text->count += DATA_COLUMNS;
    *found = any_of(same);
    return BATTEN_OK;
}

/* Append records from *next on, up to one in which the terminator stands: there they may end.
 */
static batten_status gather(const bat_iges_file *file, size_t *next, bat_list *text)
{
    const bat_iges_data *data = file->data.items;
    batten_status status = BATTEN_OK;
    for (bool found = false; status == BATTEN_OK && !found && *next < file->data.count;) {
        const bat_iges_data *record = &data[(*next)++];
        const bat_span columns = {file->input->data + record->at, record->columns};
        if (columns.length == DATA_COLUMNS) {
            status = append_columns(file->input, text, columns.bytes,
                                    file->delimiters.terminator, &found);
            continue;
        }
        found = memchr(columns.bytes, file->delimiters.terminator, columns.length) != NULL;
        status = append(file->input, text, columns, DATA_COLUMNS);
    }
    return status;
}

/* A small file may do what it likes. */
#define SHARED_FREELY ((size_t)1 << 20)

batten_status bat_iges_read_parameters(bat_iges_file *file, const bat_iges_entry *entry,
                                       bat_iges_parameters *parameters)
{
    const size_t place = find_data(file, entry->data);
    size_t next = place, at = 0;
    bool done = false;
    batten_status status = BATTEN_OK;
    bat_iges_parameters_clear(parameters);
    if (place == file->data.count)
        return bat_fail(BATTEN_BAD_FORMAT, "its parameters should be in record %d, of %zu",
                        entry->data, file->data.count);
    while (status == BATTEN_OK && !done && next < file->data.count) {
        status = gather(file, &next, &parameters->text);
        if (status == BATTEN_OK)
            status = bat_iges_tokenise(file->input, file->delimiters, parameters, &at, &done);
    }
    if (status == BATTEN_OK && !done)
        status = bat_fail(BATTEN_BAD_FORMAT, "the parameters have no end");
    /* Entries may share their parameters, but this keeps the work linear in the file. */
    file->tokenised += parameters->text.count;
    if (status == BATTEN_OK &&
        file->tokenised > SHARED_FREELY + 16 * DATA_COLUMNS * file->data.count)
        status = bat_input_fail(file->input, BATTEN_TOO_LARGE, 0,
                                "the entries share their parameters more than 16 times over");
    if (status == BATTEN_OK)
        status = check_data(file, place, place + (at - 1) / DATA_COLUMNS);
    return status;
}
