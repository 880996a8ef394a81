/* Cuts text into rows and fields, and reads a field as a number. */
#include "exchange/csv/separated.h"
#include "base/plural.h"

#include <batten/text.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* What is first outside quotes of these separates the fields. */
static const char candidates[] = ";,\t";

static void mark_separators(bat_span row, bool *found)
{
    bool quoted = false, starts = true;
    for (size_t i = 0; i < row.length; i++) {
        const char c = row.bytes[i];
        /* A quote opens only where a field begins. */
        quoted = c == '"' && (quoted || starts) ? !quoted : quoted;
        const char *candidate = c && !quoted ? strchr(candidates, c) : NULL;
        if (candidate)
            found[candidate - candidates] = true;
        starts = candidate || bat_is_blank(c);
    }
}

/* The first that occurs outside quotes of ';' ',' tab; else blanks. */
static char find_separator(bat_span row)
{
    bool found[sizeof candidates] = {false};
    mark_separators(row, found);
    for (size_t k = 0; candidates[k]; k++)
        if (found[k])
            return candidates[k];
    return ' ';
}

void bat_separated_begin(bat_separated *table, bat_input *input)
{
    *table = (bat_separated){.input = input, .list = {.size = sizeof(bat_field)}};
}

void bat_separated_end(bat_separated *table)
{
    bat_release(table->text);
    bat_release(table->list.items);
}

static size_t skip_blanks(bat_span line, size_t i)
{
    while (i < line.length && bat_is_blank(line.bytes[i]))
        i++;
    return i;
}

static bool is_comment(bat_span line)
{
    size_t i = skip_blanks(line, 0);
    if (i < line.length && line.bytes[i] == '"')
        i = skip_blanks(line, i + 1);
    return i < line.length && line.bytes[i] == '#';
}

/* The next line that is a row. */
static bool next_row(bat_separated *table)
{
    bool gap = false;
    while (bat_next_line(table->input, &table->at, &table->raw)) {
        table->line += table->line < INT_MAX;
        const bool blank = skip_blanks(table->raw, 0) == table->raw.length;
        const bool comment = !blank && is_comment(table->raw);
        if (!blank && !comment) {
            table->after_gap = gap;
            return true;
        }
        gap |= blank;
        table->comments += comment && table->comments < INT_MAX;
    }
    return false;
}

/* ---- fields ---- */

/* Where the text of a row is cut: read at `at`, written at `end`. */
typedef struct {
    size_t at, end;
} cursor;

static bool separates(const bat_separated *table, char c)
{
    return table->separator == ' ' ? bat_is_blank(c) : c == table->separator;
}

static batten_status quoted_field(bat_separated *table, cursor *cut)
{
    const bat_span row = table->raw;
    const int opened = (int)cut->at + 1;
    for (cut->at++; cut->at < row.length; cut->at++) {
        const bool quote = row.bytes[cut->at] == '"';
        const bool doubled = quote && cut->at + 1 < row.length && row.bytes[cut->at + 1] == '"';
        if (quote && !doubled)
            break;
        cut->at += doubled;
        table->text[cut->end++] = row.bytes[cut->at];
    }
    if (cut->at == row.length)
        return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line,
                              "the quote in column %d is not closed on its line", opened);
    cut->at++;
    if (table->separator != ' ')
        while (cut->at < row.length && bat_is_blank(row.bytes[cut->at]) &&
               !separates(table, row.bytes[cut->at]))
            cut->at++;
    if (cut->at < row.length && !separates(table, row.bytes[cut->at]))
        return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line,
                              "column %d: text after a closing quote", (int)cut->at + 1);
    return BATTEN_OK;
}

static void plain_field(bat_separated *table, cursor *cut)
{
    const bat_span row = table->raw;
    const size_t begin = cut->end;
    while (cut->at < row.length && !separates(table, row.bytes[cut->at]))
        table->text[cut->end++] = row.bytes[cut->at++];
    while (cut->end > begin && bat_is_blank(table->text[cut->end - 1]))
        cut->end--;
}

/* Blanks before a field, which may be separators of the other kind. */
static void skip_margin(const bat_separated *table, cursor *cut)
{
    const bat_span row = table->raw;
    while (cut->at < row.length && bat_is_blank(row.bytes[cut->at]) &&
           (table->separator == ' ' || !separates(table, row.bytes[cut->at])))
        cut->at++;
}

static batten_status cut_row(bat_separated *table)
{
    const bat_span row = table->raw;
    cursor cut = {0, 0};
    batten_status status = BATTEN_OK;
    bool more = true;
    table->list.count = 0;
    for (skip_margin(table, &cut); status == BATTEN_OK && more;) {
        const bat_field field = {table->text + cut.end, (int)cut.at + 1};
        if (cut.at < row.length && row.bytes[cut.at] == '"' && !table->no_quotes)
            status = quoted_field(table, &cut);
        else
            plain_field(table, &cut);
        table->text[cut.end++] = '\0';
        if (status == BATTEN_OK)
            status = bat_list_add(table->input, &table->list, &field);
        more = cut.at < row.length;
        cut.at += more;
        skip_margin(table, &cut);
        more &= table->separator != ' ' || cut.at < row.length;
    }
    table->fields = table->list.items;
    table->count = (int)table->list.count;
    return status;
}

/* Room for the fields of a row with their zeros: no more than its characters and one. */
static batten_status make_room(bat_separated *table)
{
    if (table->text && table->raw.length + 1 < table->capacity)
        return BATTEN_OK;
    const size_t capacity = 2 * table->raw.length + 64;
    char *text = NULL;
    batten_status status = bat_input_array(table->input, capacity, 1, &text);
    if (status != BATTEN_OK)
        return status;
    bat_release(table->text);
    table->text = text;
    table->capacity = capacity;
    return BATTEN_OK;
}

/* A row that ends with the data may have been longer. */
static void note_open_end(const bat_separated *table)
{
    const bat_input *input = table->input;
    if (table->raw.bytes + table->raw.length == input->data + input->size)
        batten_notes_add(input->notes, input->file, table->line, "",
                         "the last line has no end; is the file whole?");
}

batten_status bat_separated_next(bat_separated *table, bool *more)
{
    const int before = table->line;
    const bool found = next_row(table);
    batten_status status = BATTEN_OK;
    if (before / 1024 != table->line / 1024)
        status = bat_input_step(table->input, table->at);
    if (status == BATTEN_OK && found)
        status = bat_input_limit(table->input, table->line, table->raw.length,
                                 table->input->limits.line_bytes, "bytes in one line");
    if (status == BATTEN_OK && found)
        status = make_room(table);
    if (status == BATTEN_OK && found) {
        if (!table->separator)
            table->separator = find_separator(table->raw);
        if (table->separator == '\t' && table->tabs_are_blanks)
            table->separator = ' ';
        status = cut_row(table);
    }
    if (status == BATTEN_OK && found)
        note_open_end(table);
    if (status == BATTEN_OK)
        *more = found;
    return status;
}

/* ---- what a field says ---- */

batten_status bat_field_fail(const bat_separated *table, int field, const char *format, ...)
{
    char sentence[640];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line, "column %d: %s",
                          table->fields[field].column, sentence);
}

/* One comma, with digits on both sides and nothing else but a sign and points. */
static bool has_decimal_comma(const char *text)
{
    const char *comma = strchr(text, ',');
    if (!comma || comma == text || !comma[1])
        return false;
    return strspn(text, "+-0123456789.,eE") == strlen(text);
}

batten_status bat_field_number(const bat_separated *table, int field, double *value)
{
    const char *text = table->fields[field].text;
    double number = 0;
    batten_status status = batten_number_read(text, strlen(text), &number, NULL);
    if (status == BATTEN_OVERFLOW)
        return bat_field_fail(table, field, "'%.40s' is too large for a number", text);
    if (status != BATTEN_OK && has_decimal_comma(text))
        return bat_field_fail(table, field,
                              "'%.40s' has a comma; a decimal mark must be a point", text);
    if (status != BATTEN_OK)
        return bat_field_fail(table, field, "'%.40s' is not a number", text);
    bat_input_vanished(table->input, table->line, "", (bat_span){text, strlen(text)}, number);
    *value = number;
    return BATTEN_OK;
}

bool bat_field_is_absent(const bat_separated *table, int field)
{
    const char *text = table->fields[field].text;
    return text[0] == '\0' || (strchr("-xX", text[0]) && text[1] == '\0');
}

bool bat_field_is_number(const bat_separated *table, int field)
{
    const char *text = table->fields[field].text;
    double number;
    const batten_status status = batten_number_read(text, strlen(text), &number, NULL);
    return status == BATTEN_OK || status == BATTEN_OVERFLOW;
}

int bat_row_length(const bat_separated *table)
{
    int count = table->count;
    while (count > 0 && table->fields[count - 1].text[0] == '\0')
        count--;
    return count;
}

batten_status bat_row_check(const bat_separated *table, int count)
{
    if (table->count < count || bat_row_length(table) > count)
        return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line,
                              "%d column%s where the first row has %d", table->count,
                              bat_plural(table->count), count);
    return BATTEN_OK;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool bat_same_word(const char *a, const char *b)
{
    while (*a && lower(*a) == lower(*b)) {
        a++;
        b++;
    }
    return *a == *b;
}

void bat_put_quoted(batten_text *text, const char *field)
{
    batten_text_bytes(text, "\"", 1);
    for (; *field; field++) {
        const char c = *field == '\n' || *field == '\r' ? ' ' : *field;
        batten_text_bytes(text, c == '"' ? "\"\"" : &c, c == '"' ? 2 : 1);
    }
    batten_text_bytes(text, "\"", 1);
}
