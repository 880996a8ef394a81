/* Damage to files of 80 columns: an IGES file is taken apart into entities and put together
 * again. */
#include "mutate.h"

#include <stdlib.h>
#include <string.h>

#define RECORD 80
#define FIELDS 18 /* of a directory entry, without the two sequence numbers */

/* The record from `at` on, without its end of line; false when it is not one. */
static bool record_at(const fuzz_text *text, size_t at, size_t *next)
{
    size_t end = at;
    while (end < text->size && text->bytes[end] != '\n')
        end++;
    *next = end < text->size ? end + 1 : end;
    return end - at >= 73 && memchr("SGDPT", text->bytes[at + 72], 5);
}

static bool put(fuzz_text *text, const char *bytes, size_t count)
{
    return fuzz_replace(text, text->size, text->size, bytes, count);
}

static size_t without_blanks(const char *bytes, size_t count)
{
    while (count > 0 && bytes[count - 1] == ' ')
        count--;
    return count;
}

/* The parameters of the entity whose directory entry has this number. */
static bool put_parameters(const fuzz_text *records, int entry, fuzz_text *lines)
{
    size_t next;
    for (size_t at = 0; at < records->size; at = next) {
        char pointer[9] = "";
        if (!record_at(records, at, &next))
            return false;
        const char *record = records->bytes + at;
        memcpy(pointer, record + 64, 8);
        if (record[72] == 'P' && atoi(pointer) == entry &&
            !put(lines, record, without_blanks(record, 64)))
            return false;
    }
    return true;
}

/* Nine fields of the first or the second record of a directory entry. */
static bool put_fields(const char *record, fuzz_text *lines)
{
    for (int k = 0; k < 9; k++) {
        const char *field = record + 8 * k;
        size_t blank = 0;
        while (blank < 8 && field[blank] == ' ')
            blank++;
        if (!put(lines, field + blank, without_blanks(field + blank, 8 - blank)) ||
            !put(lines, "|", 1))
            return false;
    }
    return true;
}

bool fuzz_unfold(const fuzz_text *records, fuzz_text *lines)
{
    size_t next;
    int entries = 0;
    bool in_global = false, done = true;
    for (size_t at = 0; at < records->size && done; at = next) {
        if (!record_at(records, at, &next))
            return false;
        const char *record = records->bytes + at;
        const char section = record[72];
        if (in_global && section != 'G')
            done = put(lines, "\n", 1);
        if (section == 'S')
            done = put(lines, "S", 1) && put(lines, record, without_blanks(record, 72)) &&
                   put(lines, "\n", 1);
        else if (section == 'G')
            done = (in_global || put(lines, "G", 1)) && put(lines, record, 72);
        else if (section == 'D')
            done = (entries % 2 || put(lines, "D", 1)) && put_fields(record, lines);
        if (section == 'D' && entries++ % 2 == 1)
            done = done && put_parameters(records, entries - 1, lines) && put(lines, "\n", 1);
        in_global = section == 'G';
    }
    return done;
}

typedef struct {
    const fuzz_text *lines;
    fuzz_text *records;
    int counts[4]; /* records written of S, G, D, P */
} folding;

/* Flush right in a field of so many columns. */
static void put_number(char *field, size_t width, int number)
{
    for (size_t i = width; i-- > 0 && (number > 0 || i + 1 == width); number /= 10)
        field[i] = (char)('0' + number % 10);
}

static bool put_record(folding *f, int section, const char *bytes, size_t count, int pointer)
{
    char record[RECORD + 1];
    memset(record, ' ', RECORD);
    memcpy(record, bytes, count);
    if (section == 3)
        put_number(record + 64, 8, pointer);
    record[72] = "SGDP"[section];
    put_number(record + 73, 7, ++f->counts[section]);
    record[RECORD] = '\n';
    return put(f->records, record, RECORD + 1);
}

static bool put_long(folding *f, int section, const char *bytes, size_t count, int pointer)
{
    const size_t width = section == 3 ? 64 : 72;
    bool done = true;
    for (size_t at = 0; done && (at < count || at == 0); at += width)
        done = put_record(f, section, bytes + at, count - at < width ? count - at : width,
                          pointer);
    return done;
}

/* Its fields, with where the parameters begin and how many records they take. */
static bool put_entry(folding *f, const char *line, size_t length, int first, int records)
{
    char both[2 * 9 * 8];
    memset(both, ' ', sizeof both);
    size_t at = 0;
    for (size_t k = 0; k < FIELDS; k++) {
        const char *end = memchr(line + at, '|', length - at);
        const size_t count = end ? (size_t)(end - line) - at : 0, shown = count < 8 ? count : 8;
        char *field = both + 8 * k;
        if (k == 1 || k == 12)
            put_number(field, 8, k == 1 ? first : records);
        else if (shown)
            memcpy(field + 8 - shown, line + at, shown);
        if (end)
            at = (size_t)(end - line) + 1;
    }
    return put_record(f, 2, both, 72, 0) && put_record(f, 2, both + 72, 72, 0);
}

/* Where the parameters begin in a line of an entity. */
static size_t parameters_at(const char *line, size_t length)
{
    size_t at = 0;
    for (int k = 0; k < FIELDS; k++) {
        const char *end = memchr(line + at, '|', length - at);
        if (!end)
            return length;
        at = (size_t)(end - line) + 1;
    }
    return at;
}

static bool put_section(folding *f, int section)
{
    const fuzz_text *lines = f->lines;
    bool done = true;
    int entry = 1, first = 1;
    for (size_t at = 0, end; at < lines->size && done; at = end + 1) {
        const char *stop = memchr(lines->bytes + at, '\n', lines->size - at);
        end = stop ? (size_t)(stop - lines->bytes) : lines->size;
        const char *line = lines->bytes + at + 1;
        if (end == at || lines->bytes[at] != "SGDD"[section])
            continue;
        const size_t length = end - at - 1, from = parameters_at(line, length);
        const int records = length > from ? (int)((length - from + 63) / 64) : 1;
        if (section < 2)
            done = put_long(f, section, line, length, 0);
        else if (section == 2)
            done = put_entry(f, line, length, first, records);
        else
            done = put_long(f, 3, line + from, length - from, entry);
        entry += 2;
        first += records;
    }
    return done;
}

bool fuzz_fold(const fuzz_text *lines, fuzz_text *records)
{
    folding f = {.lines = lines, .records = records};
    char last[RECORD + 1];
    memset(last, ' ', RECORD);
    for (int section = 0; section < 4; section++) {
        if (!put_section(&f, section))
            return false;
        last[8 * section] = "SGDP"[section];
        put_number(last + 8 * section + 1, 7, f.counts[section]);
    }
    last[72] = 'T';
    put_number(last + 73, 7, 1);
    last[RECORD] = '\n';
    return put(records, last, RECORD + 1);
}
