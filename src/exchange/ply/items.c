/* Reads the numbers of one item of a PLY element, as text or as bytes. */
#include "exchange/ply/ply.h"
#include "exchange/reading/bytes.h"

size_t bat_ply_least(bat_ply_form form, const bat_ply_property *properties, size_t count)
{
    size_t least = 0;
    for (size_t k = 0; k < count; k++)
        least += form == BAT_PLY_TEXT    ? 2
                 : properties[k].is_list ? (size_t)properties[k].count_type.bytes
                                         : (size_t)properties[k].type.bytes;
    return least;
}

/* ---- bytes ---- */

static double decode(const char *at, bat_ply_type type, bool big)
{
    if (type.is_real)
        return type.bytes == 8 ? bat_bytes_double(at, big) : bat_bytes_float(at, big);
    const uint64_t bits = bat_bytes_get(at, type.bytes, big);
    if (type.is_signed && bits >> (8 * type.bytes - 1))
        return (double)bits - ldexp(1, 8 * type.bytes);
    return (double)bits;
}

static bool next_bytes(bat_ply_items *items, bat_ply_type type, double *value)
{
    if (items->input->size - items->at < (size_t)type.bytes)
        return false;
    *value = decode(items->input->data + items->at, type, items->form == BAT_PLY_BIG);
    items->at += (size_t)type.bytes;
    return true;
}

/* ---- text: a line for each item ---- */

static bool next_item_line(bat_ply_items *items)
{
    bat_span line, word;
    while (bat_next_line(items->input, &items->at, &line)) {
        items->words = bat_scan_begin(line.bytes, line.length);
        items->line++;
        bat_scan look = items->words;
        if (bat_next_in_line(&look, &word))
            return true;
    }
    return false;
}

static bool next_word(bat_ply_items *items, double *value)
{
    bat_span word;
    if (!bat_next_in_line(&items->words, &word))
        return false;
    if (!bat_word_real(items->input, items->line, word, value))
        *value = NAN;
    return true;
}

/* ---- items ---- */

static bool next_value(bat_ply_items *items, bat_ply_type type, double *value)
{
    return items->form == BAT_PLY_TEXT ? next_word(items, value)
                                       : next_bytes(items, type, value);
}

static int64_t index_of(double value)
{
    /* Whole numbers up to 2^53, about 9e15, are exact as doubles. */
    return value >= 0 && value <= 1e15 && value == floor(value) ? (int64_t)value : -1;
}

/* The items of a list whose length is known; kept when `list` is given. */
static batten_status read_list(bat_ply_items *items, const bat_ply_property *property,
                               double length, bat_list *list, bool *more)
{
    const int64_t count = index_of(length);
    const size_t left = items->input->size - items->at;
    *more = count >= 0 && (items->form == BAT_PLY_TEXT ||
                           (uint64_t)count <= left / (size_t)property->type.bytes);
    batten_status status = BATTEN_OK;
    for (int64_t k = 0; status == BATTEN_OK && *more && k < count; k++) {
        double value = 0;
        *more = next_value(items, property->type, &value);
        const int64_t index = index_of(value);
        if (*more && list)
            status = bat_list_add(items->input, list, &index);
    }
    return status;
}

batten_status bat_ply_item(bat_ply_items *items, const bat_ply_property *properties,
                           size_t count, size_t wanted, double *values, bat_list *list,
                           bat_ply_result *result)
{
    const bool is_text = items->form == BAT_PLY_TEXT;
    batten_status status = BATTEN_OK;
    bool more = !is_text || next_item_line(items);
    *result = BAT_PLY_LOST;
    if (!more)
        return BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && more && k < count; k++) {
        const bat_ply_property *property = &properties[k];
        more = next_value(items, property->is_list ? property->count_type : property->type,
                          &values[k]);
        if (more && property->is_list)
            status = read_list(items, property, values[k], k == wanted ? list : NULL, &more);
    }
    *result = more ? BAT_PLY_READ : is_text ? BAT_PLY_ODD : BAT_PLY_LOST;
    return status;
}
