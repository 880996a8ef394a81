/* Writes records of 80 columns and the entries of the directory. */
#include "base/real.h"
#include "exchange/iges/write/writing.h"

#include <string.h>

enum { RECORD = 80, DATA_COLUMNS = 64, GLOBAL_COLUMNS = 72 };

/* Put a number at the right of a field of blanks. */
static void put_field(char *field, int width, int64_t value)
{
    char digits[BAT_INTEGER_SIZE];
    const int length = bat_integer_write(value, digits);
    assert(length <= width);
    memset(field, ' ', (size_t)(width - length));
    memcpy(field + width - length, digits, (size_t)length);
}

/* What follows the free columns: the id of the entity, the letter, the number of the record. */
enum { ID = 0, LETTER = 8, NUMBER_END = 16, TAIL = 17 };

void bat_iges_section_begin(bat_iges_section *section, char letter, batten_text *text)
{
    *section = (bat_iges_section){.text = text,
                                  .columns = letter == 'P' ? DATA_COLUMNS : GLOBAL_COLUMNS};
    memset(section->tail, ' ', sizeof section->tail);
    section->tail[LETTER] = letter;
    section->tail[NUMBER_END - 1] = '0';
    section->tail[NUMBER_END] = '\n';
}

/* Count on in the digits themselves. */
static void count_record(bat_iges_section *section)
{
    char *digit = &section->tail[NUMBER_END - 1];
    section->count++;
    while (*digit == '9')
        *digit-- = '0';
    *digit = *digit == ' ' ? '1' : (char)(*digit + 1);
}

/* End a record of which `used` columns are filled; what is behind them in the line is kept. */
static void end_record(bat_iges_section *section, size_t used)
{
    char record[RECORD + 1];
    const size_t columns = section->columns, tail = sizeof record - columns;
    count_record(section);
    memcpy(record, section->line, columns);
    memset(record + used, ' ', columns - used);
    memcpy(record + columns, section->tail + TAIL - tail, tail);
    batten_text_bytes(section->text, record, sizeof record);
    section->used -= used;
    memmove(section->line, section->line + used, section->used);
}

void bat_iges_section_flush(bat_iges_section *section)
{
    if (section->used)
        end_record(section, section->used);
}

/* A token has been put into the line: it goes to the next record when it runs over the end. */
static void end_token(bat_iges_section *section, size_t length, char after)
{
    const size_t begin = section->used;
    section->line[begin + length] = after;
    section->used += length + 1;
    if (section->used > section->columns)
        end_record(section, begin);
}

void bat_iges_put_integer(bat_iges_section *section, int64_t value, char after)
{
    const int length = bat_integer_write(value, section->line + section->used);
    end_token(section, (size_t)length, after);
}

void bat_iges_put_real(bat_iges_section *section, double value, char after)
{
    const int length = bat_real_write(value, section->line + section->used);
    end_token(section, (size_t)length, after);
}

static void put_character(bat_iges_section *section, char c)
{
    if (section->used == section->columns)
        end_record(section, section->used);
    section->line[section->used++] = c;
}

void bat_iges_put_string(bat_iges_section *section, const char *text, char after)
{
    const size_t length = strlen(text);
    if (length > 0)
        bat_iges_put_integer(section, (int64_t)length, 'H');
    for (size_t i = 0; i < length; i++)
        put_character(section,
                      text[i] == '\n' || text[i] == '\r' || text[i] == '\t' ? ' ' : text[i]);
    put_character(section, after);
}

/* ---- entities ---- */

int bat_iges_begin_entity(bat_iges_writing *w, int type)
{
    const int id = w->directory_count + 1;
    put_field(w->data.tail + ID, 8, id);
    w->first = w->data.count + 1;
    bat_iges_put_integer(&w->data, type, ',');
    return id;
}

void bat_iges_put_properties(bat_iges_writing *w, int name)
{
    bat_iges_put_integer(&w->data, 0, ',');
    bat_iges_put_integer(&w->data, name ? 1 : 0, name ? ',' : ';');
    if (name)
        bat_iges_put_integer(&w->data, name, ';');
}

void bat_iges_end_entity(bat_iges_writing *w, const bat_iges_look *look)
{
    char entry[2 * RECORD + 2];
    bat_iges_section_flush(&w->data);
    const int first[] = {look->type, w->first, 0, 0, look->level, 0, look->matrix, 0};
    const int second[] = {look->type, 0, look->colour, w->data.count - w->first + 1,
                          look->form};
    memset(entry, ' ', sizeof entry);
    for (int k = 0; k < 8; k++)
        put_field(entry + 8 * k, 8, first[k]);
    const char status[8] = {'0', look->is_hidden ? '1' : '0', '0', look->is_part ? '1' : '0',
                            '0', (char)('0' + look->use),     '0', '0'};
    memcpy(entry + 64, status, sizeof status);
    entry[72] = 'D';
    put_field(entry + 73, 7, ++w->directory_count);
    entry[RECORD] = '\n';
    char *next = entry + RECORD + 1;
    for (int k = 0; k < 5; k++)
        put_field(next + 8 * k, 8, second[k]);
    next[71] = '0';
    next[72] = 'D';
    put_field(next + 73, 7, ++w->directory_count);
    next[RECORD] = '\n';
    batten_text_bytes(&w->directory, entry, sizeof entry);
}
