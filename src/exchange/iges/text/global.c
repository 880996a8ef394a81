/* The global section: delimiters, names, the unit. A name whose count of characters is wrong does not cost the model. */
#include "exchange/iges/text/records.h"

#include <batten/text.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static bool may_delimit(char c)
{
    return c > ' ' && c < 127 && !strchr("0123456789+-.DEHde", c);
}

/* The first two global parameters, "1Hc" or nothing each, say the delimiters. */
static batten_status read_delimiters(bat_iges_file *file, bat_span text, size_t *at)
{
    char found[2] = {',', ';'};
    for (int k = 0; k < 2; k++) {
        *at = bat_iges_past_blanks(text, *at);
        if (text.length - *at >= 4 && memcmp(text.bytes + *at, "1H", 2) == 0) {
            found[k] = text.bytes[*at + 2];
            *at = bat_iges_past_blanks(text, *at + 3);
        }
        if (*at >= text.length || text.bytes[*at] != found[0])
            return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0,
                                  "the global section does not begin with its delimiters");
        (*at)++;
    }
    if (!may_delimit(found[0]) || !may_delimit(found[1]) || found[0] == found[1]) {
        char first[BAT_SHOWN_SIZE], second[BAT_SHOWN_SIZE];
        return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0,
                              "the global section names '%s' and '%s' as delimiters",
                              bat_shown(&found[0], 1, first), bat_shown(&found[1], 1, second));
    }
    file->delimiters = (bat_iges_delimiters){found[0], found[1]};
    return BATTEN_OK;
}

/* ---- strings with wrong counts ---- */

typedef struct {
    const bat_iges_file *file;
    bat_span text;
    bat_list *made; /* the text with right counts */
} mending;

static bool is_delimiter(const mending *m, char c)
{
    return c == m->file->delimiters.delimiter || c == m->file->delimiters.terminator;
}

/* Does a parameter begin behind the delimiter at `at`, or the section end with it? */
static bool is_true_end(const mending *m, size_t at)
{
    const size_t next = bat_iges_past_blanks(m->text, at + 1);
    if (m->text.bytes[at] == m->file->delimiters.terminator)
        return next == m->text.length;
    if (m->text.bytes[at] != m->file->delimiters.delimiter || next == m->text.length)
        return false;
    return is_delimiter(m, m->text.bytes[next]) ||
           (m->text.bytes[next] && strchr("0123456789+-.", m->text.bytes[next]));
}

/* "nH" at `at`: where its characters begin, and how many it announces; else 0. */
static size_t string_at(const mending *m, size_t at, size_t *announced)
{
    const size_t begin = at;
    *announced = 0;
    for (; at < m->text.length && m->text.bytes[at] >= '0' && m->text.bytes[at] <= '9'; at++)
        if (*announced < SIZE_MAX / 100) /* more is too many, however many */
            *announced = 10 * *announced + (size_t)(m->text.bytes[at] - '0');
    return at > begin && at < m->text.length && m->text.bytes[at] == 'H' ? at + 1 : 0;
}

/* Where the string that begins at `begin` ends: as announced, or before the next delimiter that a parameter follows. */
static size_t end_of_string(const mending *m, size_t begin, size_t announced)
{
    size_t end = m->text.length;
    if (announced <= m->text.length - begin) {
        const size_t behind = bat_iges_past_blanks(m->text, begin + announced);
        if (behind < m->text.length && is_delimiter(m, m->text.bytes[behind]))
            return begin + announced;
    }
    for (end = begin; end < m->text.length && !is_true_end(m, end); end++)
        continue;
    while (m->text.bytes[end - 1] == ' ') /* there is an H in front of it */
        end--;
    batten_notes_add(
        m->file->input->notes, m->file->input->file, 0, "",
        "global section: a string announces %zu characters and has %zu ('%.*s'); it is "
        "read as it stands",
        announced, end - begin, (int)bat_min_int(60, (int)(end - begin)),
        m->text.bytes + begin);
    return end;
}

static batten_status put_string(const mending *m, size_t begin, size_t end)
{
    char count[32];
    const int length = snprintf(count, sizeof count, "%zuH", end - begin);
    batten_status status = bat_list_append(m->file->input, m->made, count, (size_t)length);
    if (status == BATTEN_OK)
        status = bat_list_append(m->file->input, m->made, m->text.bytes + begin, end - begin);
    return status;
}

/* Copy the parameters from `at` on, each string with the count of what it has. */
static batten_status mend_strings(const mending *m, size_t at)
{
    batten_status status = bat_list_append(m->file->input, m->made, m->text.bytes, at);
    while (status == BATTEN_OK && at < m->text.length) {
        size_t announced = 0;
        at = bat_iges_past_blanks(m->text, at);
        const size_t begin = at < m->text.length ? string_at(m, at, &announced) : 0;
        if (begin) {
            at = end_of_string(m, begin, announced);
            status = put_string(m, begin, at);
        }
        size_t end = at;
        while (end < m->text.length && !is_delimiter(m, m->text.bytes[end]))
            end++;
        end += end < m->text.length;
        if (status == BATTEN_OK)
            status = bat_list_append(m->file->input, m->made, m->text.bytes + at, end - at);
        at = end;
    }
    return status;
}

static batten_status read_tokens(bat_iges_file *file, size_t at)
{
    bool done = false;
    batten_status status =
        bat_iges_tokenise(file->input, file->delimiters, &file->global, &at, &done);
    if (status == BATTEN_OK && !done)
        status = bat_fail(BATTEN_BAD_FORMAT, "the parameters have no end");
    return status;
}

/* Read the section anew with right counts; as it was where they are not what is wrong. */
static batten_status read_mended(bat_iges_file *file, size_t at)
{
    bat_list made = {.size = 1};
    const mending m = {file, {file->global.text.items, file->global.text.count}, &made};
    batten_status status = mend_strings(&m, at);
    if (status != BATTEN_OK) {
        bat_release(made.items);
        return status;
    }
    bat_iges_parameters_clear(&file->global);
    bat_release(file->global.text.items);
    file->global.text = made;
    return read_tokens(file, at);
}

batten_status bat_iges_global(bat_iges_file *file)
{
    const bat_span text = {file->global.text.items, file->global.text.count};
    size_t at = 0;
    if (text.length == 0)
        return bat_input_fail(file->input, BATTEN_BAD_FORMAT, 0, "there is no global section");
    batten_status status = read_delimiters(file, text, &at);
    if (status != BATTEN_OK)
        return status;
    status = read_tokens(file, at);
    if (status == BATTEN_BAD_FORMAT)
        status = read_mended(file, at);
    if (status != BATTEN_BAD_FORMAT)
        return status;
    return bat_input_fail(file->input, status, 0, "global section: %.200s", batten_message());
}
