/* Builds the table of instances and finds them by number and keyword. */
#include "exchange/step/text/table.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

/* ---- lines ---- */

#define BLOCK 1024

/* The ends of lines in [at, end). */
static uint32_t count_lines(const bat_input *input, size_t at, size_t end)
{
    const char *data = input->data;
    uint32_t here = 0;
    for (const char *c = data + at; (c = memchr(c, '\n', (size_t)(data + end - c))); c++)
        here++;
    if (here == 0 && memchr(data + at, '\r', end - at)) /* the lines of an old Macintosh */
        for (size_t i = at; i < end; i++)
            here += data[i] == '\r' && (i + 1 == input->size || data[i + 1] != '\n');
    return here;
}

batten_status bat_step_table_lines(bat_step_file *file)
{
    const bat_input *input = file->input;
    uint32_t count = 0;
    batten_status status = BATTEN_OK;
    for (size_t at = 0; status == BATTEN_OK && at < input->size; at += BLOCK) {
        const size_t end = at + BLOCK < input->size ? at + BLOCK : input->size;
        status = bat_list_add(file->input, &file->lines, &count);
        count += count_lines(input, at, end);
    }
    return status;
}

int bat_step_line(const bat_step_file *file, size_t at)
{
    const bat_input *input = file->input;
    const size_t block = at / BLOCK;
    if (block >= file->lines.count)
        return 0;
    size_t line = ((const uint32_t *)file->lines.items)[block] + (size_t)1;
    const size_t begin = block * BLOCK;
    const bool is_old = !memchr(input->data + begin, '\n',
                                begin + BLOCK < input->size ? BLOCK : input->size - begin);
    for (size_t i = begin; i < at; i++)
        line += input->data[i] == (is_old ? '\r' : '\n');
    return line < INT_MAX ? (int)line : INT_MAX;
}

/* ---- order ---- */

static bool is_rising(const bat_step_instance *instances, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (instances[i].id <= instances[i - 1].id)
            return false;
    return true;
}

/* Merge from[low .. middle) and from[middle .. high); of equal ids the left comes first. */
static void merge(const bat_step_instance *from, size_t low, size_t middle, size_t high,
                  bat_step_instance *to)
{
    size_t i = low, j = middle;
    for (size_t k = low; k < high; k++)
        to[k] = i < middle && (j == high || from[i].id <= from[j].id) ? from[i++] : from[j++];
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Sorted by id, those with the same id in the order of the file. */
static batten_status sort(bat_step_file *file)
{
    const size_t count = file->instances.count;
    bat_step_instance *from = file->instances.items, *to = NULL;
    batten_status status = bat_input_array(file->input, count, sizeof *to, &to);
    if (status != BATTEN_OK)
        return status;
    for (size_t width = 1; width < count; width *= 2) {
        for (size_t low = 0; low < count; low += 2 * width)
            merge(from, low, least(low + width, count), least(low + 2 * width, count), to);
        bat_step_instance *swapped = from;
        from = to;
        to = swapped;
    }
    file->instances.items = from;
    file->instances.capacity = count;
    bat_input_release(file->input, count, sizeof *to, to);
    return BATTEN_OK;
}

static void drop_doubles(bat_step_file *file)
{
    bat_input *input = file->input;
    bat_step_instance *instances = file->instances.items;
    size_t kept = 1;
    for (size_t i = 1; i < file->instances.count; i++) {
        if (instances[i].id != instances[kept - 1].id) {
            instances[kept++] = instances[i];
            continue;
        }
        char entity[32];
        snprintf(entity, sizeof entity, "#%llu", (unsigned long long)instances[i].id);
        batten_notes_add(input->notes, input->file, bat_step_line(file, instances[i].at),
                         entity, "the number is given again; line %d is used, this is left out",
                         bat_step_line(file, instances[kept - 1].at));
        input->left_out++;
    }
    file->instances.count = kept;
}

/* A table from ids to instances where it would be no larger than the instances are. */
static batten_status make_index(bat_step_file *file)
{
    const bat_step_instance *instances = file->instances.items;
    const size_t count = file->instances.count;
    const uint64_t range = instances[count - 1].id - instances[0].id;
    file->first_id = instances[0].id;
    if (range == count - 1)
        file->index_count = count;
    if (range < count || range > 4 * (uint64_t)count)
        return BATTEN_OK;
    batten_status status =
        bat_input_array(file->input, range + 1, sizeof *file->index, &file->index);
    if (status != BATTEN_OK)
        return status;
    file->index_count = range + 1;
    for (size_t i = 0; i < count; i++)
        file->index[instances[i].id - file->first_id] = (uint32_t)i + 1;
    return BATTEN_OK;
}

batten_status bat_step_table_finish(bat_step_file *file)
{
    batten_status status = BATTEN_OK;
    if (file->instances.count == 0)
        return BATTEN_OK;
    if (!is_rising(file->instances.items, file->instances.count)) {
        status = sort(file);
        if (status == BATTEN_OK)
            drop_doubles(file);
    }
    return status == BATTEN_OK ? make_index(file) : status;
}

/* ---- finding ---- */

const bat_step_instance *bat_step_find(const bat_step_file *file, uint64_t id)
{
    const bat_step_instance *instances = file->instances.items;
    size_t low = 0, high = file->instances.count;
    if (file->index_count > 0) {
        const uint64_t k = id - file->first_id; /* wraps below the first */
        if (k >= file->index_count)
            return NULL;
        if (!file->index)
            return &instances[k];
        return file->index[k] ? &instances[file->index[k] - 1] : NULL;
    }
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (instances[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < file->instances.count && instances[low].id == id ? &instances[low] : NULL;
}

const bat_step_record *bat_step_first(const bat_step_file *file,
                                      const bat_step_instance *instance)
{
    return (const bat_step_record *)file->records.items + instance->first_record;
}

const bat_step_record *bat_step_as(const bat_step_file *file, const bat_step_instance *instance,
                                   const char *keyword)
{
    const bat_step_record *records = bat_step_first(file, instance);
    for (uint32_t i = 0; i < instance->record_count; i++)
        if (bat_step_is_keyword(&records[i], keyword))
            return &records[i];
    return NULL;
}

static bool is_spline(const bat_step_record *record)
{
    const char *const word = "B_SPLINE";
    const size_t length = strlen(word);
    for (size_t i = 0; i + length <= record->keyword_length; i++)
        if (bat_step_same_word(record->keyword + i, word, length))
            return true;
    return false;
}

static bool is_before(const bat_step_record *a, const bat_step_record *b)
{
    const int order =
        memcmp(a->keyword, b->keyword, least(a->keyword_length, b->keyword_length));
    return order < 0 || (order == 0 && a->keyword_length < b->keyword_length);
}

const char *bat_step_keyword(const bat_step_file *file, const bat_step_instance *instance,
                             char buffer[BAT_STEP_KEYWORD_SIZE])
{
    const bat_step_record *records = bat_step_first(file, instance), *best = &records[0];
    for (uint32_t i = 1; i < instance->record_count; i++)
        if (is_spline(&records[i]) && (!is_spline(best) || is_before(best, &records[i])))
            best = &records[i];
    return bat_step_upper_keyword(best, buffer);
}
