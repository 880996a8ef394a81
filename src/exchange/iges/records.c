#include "exchange/iges/records.h"

#include <batten/number.h>
#include <limits.h>
#include <string.h>

#define DATA_COLUMNS 64
#define GLOBAL_COLUMNS 72
#define LETTER 72 /* where the letter of the section stands */

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
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < columns; i++) {
        const char c = i < record.length ? record.bytes[i] : ' ';
        status = bat_list_add(input, list, &c);
    }
    return status;
}

static batten_status add_data(bat_iges_file *file, bat_span record, int line, bool is_damaged)
{
    const bat_iges_data data = {.number = is_damaged ? -1 : sequence_number(record),
                                .line = line,
                                .is_damaged = is_damaged};
    batten_status status = bat_list_add(file->input, &file->data, &data);
    return status == BATTEN_OK ? append(file->input, &file->text, record, DATA_COLUMNS)
                               : status;
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
    return letter && strchr("SGDPT", letter) ? letter : '\0';
}

/* `section` is that of the record before: where a record without a letter is taken to belong.
 */
static batten_status add_record(bat_iges_file *file, bat_span record, int line, char *section)
{
    const char letter = section_of(record);
    const bool tab =
        memchr(record.bytes, '\t', record.length < LETTER ? record.length : LETTER);
    const bool damaged = !letter || tab;
    if (damaged)
        batten_notes_add(file->input->notes, file->input->file, line, "",
                         "the record is damaged: %s",
                         tab ? "it has a tab" : "column 73 has no letter of a section");
    if (letter && strchr("SGDPT", letter) < strchr("SGDPT", *section))
        batten_notes_add(file->input->notes, file->input->file, line, "",
                         "section %c comes after section %c", letter, *section);
    if (letter)
        *section = letter;
    file->has_start |= letter == 'S';
    file->has_end |= letter == 'T';
    if (*section == 'G' && !damaged)
        return append(file->input, &file->global, record, GLOBAL_COLUMNS);
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

static batten_status read_records(bat_iges_file *file)
{
    bat_input *input = file->input;
    bat_span record;
    char section = 'S';
    int line = 0;
    batten_status status = BATTEN_OK;
    for (size_t at = 0; status == BATTEN_OK && bat_next_line(input, &at, &record);) {
        line += line < INT_MAX;
        if (line % 1024 == 0)
            status = bat_input_step(input, at);
        if (status == BATTEN_OK && !is_blank_record(record)) {
            if (section == 'T') {
                batten_notes_add(input->notes, input->file, line, "",
                                 "text follows the last record; not read");
                break;
            }
            status = add_record(file, record, line, &section);
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
    bool good = read_field(first, 0, &entry.type) && read_field(first, 1, &entry.data) &&
                read_field(first, 4, &entry.level) && read_field(first, 6, &entry.transform) &&
                read_field(second, 0, &again) && read_field(second, 2, &entry.colour) &&
                read_field(second, 4, &entry.form);
    if (good && !read_field(second, 8, &entry.subscript))
        entry.subscript = 0;
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
                            .delimiter = ',',
                            .terminator = ';',
                            .global = {.size = 1},
                            .directory = {.size = sizeof(directory_record)},
                            .entries = {.size = sizeof(bat_iges_entry)},
                            .data = {.size = sizeof(bat_iges_data)},
                            .text = {.size = 1},
                            .tokens = {.size = sizeof(bat_iges_token)}};
    batten_status status = read_records(file);
    if (status == BATTEN_OK) {
        number_data(file);
        status = read_directory(file);
    }
    return status;
}

void bat_iges_end(bat_iges_file *file)
{
    bat_release(file->global.items);
    bat_release(file->directory.items);
    bat_release(file->entries.items);
    bat_release(file->data.items);
    bat_release(file->text.items);
    bat_release(file->tokens.items);
}

/* ---- tokens ---- */

/* "nH" at the beginning of the text: the length of the string, and where it begins; else -1. */
static long hollerith(bat_span text, size_t *begin)
{
    long length = 0;
    size_t i = 0;
    while (i < text.length && text.bytes[i] >= '0' && text.bytes[i] <= '9' && length < INT_MAX)
        length = 10 * length + (text.bytes[i++] - '0');
    *begin = i + 1;
    return i > 0 && i < text.length && text.bytes[i] == 'H' ? length : -1;
}

static size_t past_blanks(bat_span text, size_t at)
{
    while (at < text.length && text.bytes[at] == ' ')
        at++;
    return at;
}

/* Read one token from *at on, up to the delimiter or terminator, which is left at *at. */
static batten_status read_token(const bat_iges_file *file, bat_span text, size_t *at,
                                bat_iges_token *token)
{
    size_t begin = past_blanks(text, *at), skip = 0, end;
    const bat_span rest = {text.bytes + begin, text.length - begin};
    const long length = hollerith(rest, &skip);
    token->is_string = length >= 0;
    if (token->is_string) {
        begin += skip;
        if ((size_t)length > text.length - begin)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "a string of %ld characters runs past the section", length);
        if ((size_t)length > file->input->limits.string_bytes)
            return bat_fail(BATTEN_BAD_FORMAT, "a string of %ld characters; the limit is %zu",
                            length, file->input->limits.string_bytes);
        end = begin + (size_t)length;
        *at = past_blanks(text, end);
    } else {
        for (end = begin; end < text.length; end++)
            if (text.bytes[end] == file->delimiter || text.bytes[end] == file->terminator)
                break;
        *at = end;
        while (end > begin && text.bytes[end - 1] == ' ')
            end--;
    }
    token->text = (bat_span){text.bytes + begin, end - begin};
    if (*at == text.length)
        return bat_fail(BATTEN_BAD_FORMAT, "the parameters have no end");
    if (text.bytes[*at] != file->delimiter && text.bytes[*at] != file->terminator)
        return bat_fail(BATTEN_BAD_FORMAT, "a string of %ld characters is followed by '%c'",
                        length, text.bytes[*at]);
    return BATTEN_OK;
}

/* All tokens of a text up to its terminator; *used says how far that is. */
static batten_status tokenise(bat_iges_file *file, bat_span text, size_t *used)
{
    batten_status status = BATTEN_OK;
    bool more = true;
    size_t at = 0;
    file->tokens.count = 0;
    while (status == BATTEN_OK && more) {
        bat_iges_token token;
        status = read_token(file, text, &at, &token);
        if (status == BATTEN_OK) {
            more = text.bytes[at] == file->delimiter;
            at++;
            status = bat_list_add(file->input, &file->tokens, &token);
        }
    }
    *used = at;
    return status;
}

static bool may_delimit(char c)
{
    return c > ' ' && c < 127 && !strchr("0123456789+-.DEH", c);
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
    file->delimiter = found[0];
    file->terminator = found[1];
    return BATTEN_OK;
}

batten_status bat_iges_global(bat_iges_file *file)
{
    bat_span text = {file->global.items, file->global.count};
    size_t at = 0, used = 0;
    if (text.length == 0)
        return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0, "there is no global section");
    batten_status status = read_delimiters(file, text, &at);
    if (status != BATTEN_OK)
        return status;
    text = (bat_span){text.bytes + at, text.length - at};
    status = tokenise(file, text, &used);
    if (status != BATTEN_BAD_FORMAT)
        return status;
    return bat_input_fail(file->input, status, 0, "global section: %.200s", batten_message());
}

/* The place of the data record of that number, or the count when there is none. */
static size_t find_data(const bat_iges_file *file, int number)
{
    const bat_iges_data *data = file->data.items;
    size_t low = 0, high = file->data.count;
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

/* A small file may do what it likes. */
#define SHARED_FREELY ((size_t)1 << 20)

batten_status bat_iges_tokens(bat_iges_file *file, const bat_iges_entry *entry)
{
    const size_t place = find_data(file, entry->data), begin = DATA_COLUMNS * place;
    if (place == file->data.count)
        return bat_fail(BATTEN_BAD_FORMAT, "its parameters should be in record %d, of %zu",
                        entry->data, file->data.count);
    const bat_span text = {(const char *)file->text.items + begin, file->text.count - begin};
    size_t used = 0;
    batten_status status = tokenise(file, text, &used);
    /* Entries may share their parameters, but this keeps the work linear in the file. */
    file->tokenised += used;
    if (status == BATTEN_OK && file->tokenised > SHARED_FREELY + 8 * file->text.count)
        status = bat_input_fail(file->input, BATTEN_TOO_LARGE, 0,
                                "the entries share their parameters more than 8 times over");
    if (status == BATTEN_OK)
        status = check_data(file, place, place + (used - 1) / DATA_COLUMNS);
    return status;
}

/* ---- numbers ---- */

/* Longer than any number that says something: a double has at most 767 significant digits. */
#define LONGEST_NUMBER 1100

batten_status bat_iges_real(const bat_iges_file *file, size_t index, double *value)
{
    const bat_iges_token *tokens = file->tokens.items;
    const bat_iges_token none = {{"", 0}, false};
    const bat_iges_token *token = index < file->tokens.count ? &tokens[index] : &none;
    const bat_span text = token->text;
    char copy[LONGEST_NUMBER];
    double number = 0;
    if (text.length == 0 && !token->is_string) {
        *value = 0;
        return BATTEN_OK;
    }
    if (token->is_string || text.length > sizeof copy)
        return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu is no number but %s", index,
                        token->is_string ? "a string" : "a long text");
    memcpy(copy, text.bytes, text.length);
    for (size_t i = 0; i < text.length; i++)
        if (copy[i] == 'D' || copy[i] == 'd')
            copy[i] = 'E';
    const batten_status status = batten_number_read(copy, text.length, &number, NULL);
    if (status != BATTEN_OK)
        return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu, '%.*s', %s", index,
                        (int)(text.length < 40 ? text.length : 40), text.bytes,
                        status == BATTEN_OVERFLOW ? "is too large for a number"
                                                  : "is not a number");
    *value = number;
    return BATTEN_OK;
}

batten_status bat_iges_integer(const bat_iges_file *file, size_t index, int *value)
{
    double number = 0;
    batten_status status = bat_iges_real(file, index, &number);
    if (status != BATTEN_OK)
        return status;
    const bat_iges_token *tokens = file->tokens.items;
    const bat_span text = index < file->tokens.count ? tokens[index].text : (bat_span){"", 0};
    for (size_t i = 0; i < text.length; i++)
        if (!strchr("+-0123456789", text.bytes[i]))
            return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu, '%.*s', is not a whole number",
                            index, (int)(text.length < 40 ? text.length : 40), text.bytes);
    if (!(number >= -INT_MAX && number <= INT_MAX))
        return bat_fail(BATTEN_BAD_FORMAT,
                        "parameter %zu is %g, too large for a count or pointer", index, number);
    *value = (int)number;
    return BATTEN_OK;
}
