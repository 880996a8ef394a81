/* The parameter section as runs of records, and the parameters of one entry. */
#include "exchange/iges/text/data.h"
#include "base/digits.h"

#include <limits.h>
#include <string.h>

/* ---- records ---- */

int bat_iges_sequence_number(bat_span record)
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

batten_status bat_iges_append(bat_input *input, bat_list *list, bat_span record, size_t columns)
{
    static const char blanks[GLOBAL_COLUMNS + 1] =
        "                                                                        ";
    const size_t filled = record.length < columns ? record.length : columns;
    batten_status status = bat_list_append(input, list, record.bytes, filled);
    if (status == BATTEN_OK && filled < columns)
        status = bat_list_append(input, list, blanks, columns - filled);
    return status;
}

/* "P" and a number in seven columns, as text, counted on; 0, which no text is, stays so. */
static inline uint64_t next_tail(uint64_t tail)
{
    int shift = 56;
    for (; shift > 0 && (tail >> shift & 0xff) == '9'; shift -= 8)
        tail -= (uint64_t)9 << shift;
    if (tail == 0 || shift == 0)
        return tail;
    return tail + ((uint64_t)((tail >> shift & 0xff) == ' ' ? '1' - ' ' : 1) << shift);
}

/* The sequence number of a record of the P section: nearly always the next one. */
static int next_number(bat_iges_file *file, bat_span record)
{
    const bool is_whole = record.length >= RECORD;
    file->tail = next_tail(file->tail);
    file->number++;
    if (!is_whole || file->tail != bat_eight_characters(record.bytes + LETTER)) {
        file->number = bat_iges_sequence_number(record);
        file->tail =
            is_whole && file->number > 0 ? bat_eight_characters(record.bytes + LETTER) : 0;
    }
    return file->number;
}

/* NULL before the first. */
static bat_iges_run *last_run(const bat_iges_file *file)
{
    bat_iges_run *runs = file->runs.items;
    return file->runs.count > 0 ? &runs[file->runs.count - 1] : NULL;
}

/* Does a record go on with the run before it? */
static bool continues(const bat_iges_run *run, const bat_iges_run *record)
{
    return run && run->columns == DATA_COLUMNS && record->columns == DATA_COLUMNS &&
           !run->is_damaged && !record->is_damaged &&
           record->number == run->number + (int)run->count &&
           record->line == run->line + (int)run->count &&
           (run->count == 1 || record->at == run->at + run->count * run->stride);
}

batten_status bat_iges_add_data(bat_iges_file *file, bat_span record, int line, bool is_damaged)
{
    const bat_iges_run made = {
        .at = (size_t)(record.bytes - file->input->data),
        .place = file->data_count++,
        .count = 1,
        .number = is_damaged ? -1 : next_number(file, record),
        .line = line,
        .columns = (unsigned char)(record.length < DATA_COLUMNS ? record.length : DATA_COLUMNS),
        .is_damaged = is_damaged};
    bat_iges_run *last = last_run(file);
    if (!continues(last, &made))
        return bat_list_add(file->input, &file->runs, &made);
    last->stride = (made.at - last->at) / last->count++;
    return BATTEN_OK;
}

size_t bat_iges_add_to_run(bat_iges_file *file, size_t at, int line, size_t most)
{
    bat_iges_run *run = last_run(file);
    const bat_input *input = file->input;
    size_t count = 0;
    if (!run || run->count < 2 || run->is_damaged || at != run->at + run->count * run->stride ||
        line != run->line + (int)run->count - 1 ||
        file->number != run->number + (int)run->count - 1)
        return 0;
    for (; count < most && bat_iges_plain_record(input, at) == run->stride; count++) {
        const uint64_t tail = next_tail(file->tail);
        if (tail != bat_eight_characters(input->data + at + LETTER))
            break;
        file->tail = tail;
        at += run->stride;
    }
    run->count += count;
    file->data_count += count;
    file->number += (int)count;
    return count;
}

void bat_iges_number_data(bat_iges_file *file)
{
    bat_iges_run *runs = file->runs.items;
    const size_t count = file->runs.count;
    size_t bad = count;
    int last = 0;
    for (size_t i = 0; i < count && bad == count; i++) {
        if (runs[i].is_damaged)
            runs[i].number = last; /* not found before that record, which stands first */
        else if (runs[i].number <= last)
            bad = i;
        last = runs[i].number + (int)runs[i].count - 1;
    }
    if (bad == count)
        return;
    batten_notes_add(
        file->input->notes, file->input->file, runs[bad].line, "",
        "the sequence numbers of the P section are wrong; the records are counted");
    for (size_t i = 0; i < count; i++)
        runs[i].number = (int)runs[i].place + 1;
}

/* ---- the parameters of an entry ---- */

/* A record of the P section: the run and its place there. */
typedef struct {
    size_t run, within;
} position;

/* The first record of that number; the end of the runs when there is none. */
static position find_data(const bat_iges_file *file, int number)
{
    const bat_iges_run *runs = file->runs.items;
    const position none = {file->runs.count, 0};
    size_t low = 0, high = file->runs.count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (runs[middle].number + (int)runs[middle].count <= number)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == file->runs.count || number < runs[low].number)
        return none;
    return (position){low, (size_t)(number - runs[low].number)};
}

/* `count` records must follow each other without a gap. */
static batten_status check_data(const bat_iges_file *file, position from, size_t count)
{
    const bat_iges_run *runs = file->runs.items;
    size_t seen = 0;
    for (size_t i = from.run; seen < count; i++) {
        if (runs[i].is_damaged)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "record %zu of the P section, line %d, is damaged",
                            runs[i].place + 1, runs[i].line);
        const int expected = runs[i - (seen > 0)].number + (int)runs[i - (seen > 0)].count;
        if (seen > 0 && runs[i].number != expected)
            return bat_fail(BATTEN_BAD_FORMAT, "record %d of the P section is missing",
                            expected);
        seen += runs[i].count - (seen > 0 ? 0 : from.within);
    }
    return BATTEN_OK;
}

/* Append records from *next on, up to one in which the terminator stands: there they may end. */
static batten_status gather(const bat_iges_file *file, position *next, bat_list *text)
{
    const bat_iges_run *runs = file->runs.items;
    batten_status status = BATTEN_OK;
    for (bool found = false; status == BATTEN_OK && !found && next->run < file->runs.count;) {
        const bat_iges_run *run = &runs[next->run];
        const bat_span columns = {file->input->data + run->at + next->within * run->stride,
                                  run->columns};
        found = memchr(columns.bytes, file->delimiters.terminator, columns.length) != NULL;
        status = bat_iges_append(file->input, text, columns, DATA_COLUMNS);
        if (++next->within == run->count)
            *next = (position){next->run + 1, 0};
    }
    return status;
}

/* Read what is numbers where it stands; *next is behind it. */
static batten_status read_in_place(const bat_iges_file *file, position *next,
                                   bat_iges_parameters *parameters, size_t *at, bool *done)
{
    const bat_iges_run *run = (const bat_iges_run *)file->runs.items + next->run;
    const size_t first = run->at + next->within * run->stride;
    if (run->columns < DATA_COLUMNS)
        return BATTEN_OK;
    const batten_status status = bat_iges_tokenise_in_place(
        file->input, file->delimiters, parameters, file->input->data + first, run->stride,
        run->count - next->within, at, done);
    next->within += parameters->in_place / DATA_COLUMNS;
    if (next->within == run->count)
        *next = (position){next->run + 1, 0};
    return status;
}

/* A small file may do what it likes. */
#define SHARED_FREELY ((size_t)1 << 20)

batten_status bat_iges_read_parameters(bat_iges_file *file, const bat_iges_entry *entry,
                                       bat_iges_parameters *parameters)
{
    const position begin = find_data(file, entry->data);
    position next = begin;
    size_t at = 0;
    bool done = false;
    batten_status status = BATTEN_OK;
    bat_iges_parameters_clear(parameters);
    if (begin.run == file->runs.count)
        return bat_fail(BATTEN_BAD_FORMAT, "its parameters should be in record %d, of %zu",
                        entry->data, file->data_count);
    status = read_in_place(file, &next, parameters, &at, &done);
    while (status == BATTEN_OK && !done && next.run < file->runs.count) {
        status = gather(file, &next, &parameters->text);
        if (status == BATTEN_OK)
            status = bat_iges_tokenise(file->input, file->delimiters, parameters, &at, &done);
    }
    if (status == BATTEN_OK && !done)
        status = bat_fail(BATTEN_BAD_FORMAT, "the parameters have no end");
    /* Entries may share their parameters, but this keeps the work linear in the file. */
    file->tokenised += parameters->in_place + parameters->text.count;
    if (status == BATTEN_OK &&
        file->tokenised > SHARED_FREELY + 16 * DATA_COLUMNS * file->data_count)
        status = bat_input_fail(file->input, BATTEN_TOO_LARGE, 0,
                                "the entries share their parameters more than 16 times over");
    if (status == BATTEN_OK)
        status = check_data(file, begin, (at - 1) / DATA_COLUMNS + 1);
    return status;
}
