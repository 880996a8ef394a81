/* Goes through the text of a DXF file group by group. */
#include "exchange/dxf/pairs.h"

#include <batten/text.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>

void bat_dxf_pairs_begin(bat_dxf_pairs *pairs, bat_input *input, size_t at, int line)
{
    *pairs = (bat_dxf_pairs){
        .input = input, .at = at, .line = line, .groups = {.size = sizeof(bat_dxf_group)}};
}

void bat_dxf_pairs_end(bat_dxf_pairs *pairs)
{
    bat_release(pairs->groups.items);
    pairs->groups = (bat_list){.size = sizeof(bat_dxf_group)};
}

static bat_span trim(bat_span text)
{
    while (text.length > 0 && bat_is_blank(text.bytes[0])) {
        text.bytes++;
        text.length--;
    }
    while (text.length > 0 && bat_is_blank(text.bytes[text.length - 1]))
        text.length--;
    return text;
}

static bool next_line(bat_dxf_pairs *pairs, bat_span *text)
{
    if (!bat_next_line(pairs->input, &pairs->at, text))
        return false;
    pairs->line += pairs->line < INT_MAX;
    return true;
}

/* A code is a whole number from -5 to 1071. */
static bool read_code(bat_span text, int *code)
{
    double value = 0;
    text = trim(text);
    if (text.length == 0 || text.length > 5 ||
        batten_number_read(text.bytes, text.length, &value, NULL) != BATTEN_OK)
        return false;
    if (!(value >= -5 && value <= 1071))
        return false;
    *code = (int)value;
    return value == *code;
}

/* Only blank lines from here on. */
static bool is_blank_from(const bat_input *input, size_t at)
{
    while (at < input->size && (bat_is_blank(input->data[at]) || input->data[at] == '\n' ||
                                input->data[at] == '\r'))
        at++;
    return at == input->size;
}

/* *more is false at the end; a code without a value ends the text too. */
static batten_status next_group(bat_dxf_pairs *pairs, bat_dxf_group *group, bool *more)
{
    bat_span text;
    *more = next_line(pairs, &text);
    if (*more && trim(text).length == 0 && is_blank_from(pairs->input, pairs->at))
        *more = false;
    if (!*more)
        return BATTEN_OK;
    if (!read_code(text, &group->code)) {
        char shown[BAT_SHOWN_SIZE];
        return bat_input_fail(pairs->input, BATTEN_BAD_FORMAT, pairs->line,
                              "'%.40s' is not the code of a group",
                              bat_shown(text.bytes, text.length, shown));
    }
    *more = next_line(pairs, &group->value);
    group->value = trim(group->value);
    group->line = pairs->line;
    return BATTEN_OK;
}

batten_status bat_dxf_next(bat_dxf_pairs *pairs, bool *more)
{
    batten_status status = BATTEN_OK;
    bat_dxf_group group = pairs->next;
    size_t at = 0;
    int line = 0;
    *more = true;
    /* The text may begin with comments, code 999. */
    while (status == BATTEN_OK && *more && !pairs->has_next) {
        status = next_group(pairs, &group, more);
        pairs->has_next = *more && group.code == 0;
    }
    pairs->groups.count = 0;
    if (status != BATTEN_OK || !*more)
        return status;
    bool inside = true;
    pairs->has_next = false;
    status = bat_list_add(pairs->input, &pairs->groups, &group);
    while (status == BATTEN_OK) {
        at = pairs->at;
        line = pairs->line;
        status = next_group(pairs, &group, &inside);
        if (status != BATTEN_OK || !inside)
            break;
        if (group.code == 0) {
            pairs->next = group;
            pairs->next_at = at;
            pairs->next_line = line;
            pairs->has_next = true;
            break;
        }
        if (group.code != 999)
            status = bat_list_add(pairs->input, &pairs->groups, &group);
    }
    return status;
}

/* ---- the entity at work ---- */

const char *bat_dxf_kind(const bat_dxf_pairs *pairs, char name[32])
{
    bat_dxf_get_text(pairs, 0, 32, name);
    return name;
}

bool bat_dxf_is(const bat_dxf_pairs *pairs, const char *kind)
{
    const bat_dxf_group *groups = pairs->groups.items;
    return groups[0].value.length == strlen(kind) &&
           memcmp(groups[0].value.bytes, kind, groups[0].value.length) == 0;
}

const bat_dxf_group *bat_dxf_find(const bat_dxf_pairs *pairs, int code)
{
    const bat_dxf_group *groups = pairs->groups.items;
    for (size_t i = 0; i < pairs->groups.count; i++)
        if (groups[i].code == code)
            return &groups[i];
    return NULL;
}

size_t bat_dxf_count(const bat_dxf_pairs *pairs, int code)
{
    const bat_dxf_group *groups = pairs->groups.items;
    size_t count = 0;
    for (size_t i = 0; i < pairs->groups.count; i++)
        count += groups[i].code == code;
    return count;
}

batten_status bat_dxf_number(const bat_dxf_pairs *pairs, const bat_dxf_group *group,
                             double *value)
{
    const batten_status status =
        batten_number_read(group->value.bytes, group->value.length, value, NULL);
    char shown[BAT_SHOWN_SIZE];
    if (status == BATTEN_OK) {
        bat_input_vanished(pairs->input, group->line, "", group->value, *value);
        return BATTEN_OK;
    }
    return bat_fail(BATTEN_BAD_FORMAT, "line %d: group %d is '%.40s', %s", group->line,
                    group->code, bat_shown(group->value.bytes, group->value.length, shown),
                    status == BATTEN_OVERFLOW ? "which is too large for a number"
                                              : "not a number");
}

batten_status bat_dxf_get_real(const bat_dxf_pairs *pairs, int code, double standard,
                               double *value)
{
    const bat_dxf_group *group = bat_dxf_find(pairs, code);
    *value = standard;
    return group ? bat_dxf_number(pairs, group, value) : BATTEN_OK;
}

batten_status bat_dxf_get_integer(const bat_dxf_pairs *pairs, int code, int standard,
                                  int *value)
{
    const bat_dxf_group *group = bat_dxf_find(pairs, code);
    int64_t number = standard;
    char shown[BAT_SHOWN_SIZE];
    if (group && batten_integer_read(group->value.bytes, group->value.length, INT_MIN, INT_MAX,
                                     &number, NULL) != BATTEN_OK)
        return bat_fail(BATTEN_BAD_FORMAT, "line %d: group %d is '%.40s', not a whole number",
                        group->line, code,
                        bat_shown(group->value.bytes, group->value.length, shown));
    *value = (int)number;
    return BATTEN_OK;
}

batten_status bat_dxf_get_point(const bat_dxf_pairs *pairs, int code, batten_vec3 standard,
                                batten_vec3 *value)
{
    batten_status status = bat_dxf_get_real(pairs, code, standard.x, &value->x);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, code + 10, standard.y, &value->y);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, code + 20, standard.z, &value->z);
    return status;
}

batten_status bat_dxf_get_reals(const bat_dxf_pairs *pairs, int code, size_t count,
                                double **values)
{
    const bat_dxf_group *groups = pairs->groups.items;
    double *made = NULL;
    size_t at = 0;
    if (bat_dxf_count(pairs, code) != count)
        return bat_fail(BATTEN_BAD_FORMAT, "group %d appears %zu times, expected %zu", code,
                        bat_dxf_count(pairs, code), count);
    batten_status status = bat_input_array(pairs->input, count, sizeof *made, &made);
    for (size_t i = 0; status == BATTEN_OK && i < pairs->groups.count; i++)
        if (groups[i].code == code)
            status = bat_dxf_number(pairs, &groups[i], &made[at++]);
    if (status == BATTEN_OK)
        *values = made;
    else
        bat_release(made);
    return status;
}

/* ---- texts ---- */

/* The character of \U+XXXX at the beginning of a text as UTF-8; 0 when none stands there. */
static size_t decode(const char *text, size_t left, char out[4])
{
    uint32_t c = 0;
    if (left < 7 || memcmp(text, "\\U+", 3) != 0)
        return 0;
    for (int i = 3; i < 7; i++) {
        const int digit = bat_hex_digit(text[i]);
        if (digit < 0)
            return 0;
        c = 16 * c + (uint32_t)digit;
    }
    return bat_utf8_write(c, out);
}

void bat_dxf_get_text(const bat_dxf_pairs *pairs, int code, size_t size, char *buffer)
{
    const bat_dxf_group *group = bat_dxf_find(pairs, code);
    size_t used = 0;
    for (size_t i = 0; group && i < group->value.length;) {
        char made[4] = {group->value.bytes[i]};
        size_t length = decode(group->value.bytes + i, group->value.length - i, made);
        i += length ? 7 : 1;
        length = length ? length : 1;
        if (used + length >= size)
            break;
        memcpy(buffer + used, made, length);
        used += length;
    }
    buffer[used] = '\0';
}
