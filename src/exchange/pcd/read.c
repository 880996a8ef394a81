/* The points of a .pcd file, as text, as bytes, or compressed. */
#include "base/plural.h"
#include "exchange/pcd/header.h"
#include "exchange/reading/bytes.h"
#include "exchange/reading/scan.h"

#include <limits.h>

batten_status bat_pcd_recognise(const bat_input *input, bool *is_such)
{
    const size_t at = bat_past_white(input);
    *is_such = bat_begins(input, at, "# .PCD") || bat_begins(input, at, "VERSION .7") ||
               bat_begins(input, at, "VERSION 0.7");
    return BATTEN_OK;
}

/* ---- points ---- */

/* A point that the sensor did not see is NaN: that is usual. */
static batten_status take_point(bat_pcd_reading *r, const double point[3])
{
    if (bat_first_not_finite(point, 3) == 3)
        return bat_list_add(r->input, &r->read, point);
    r->nowhere++;
    return BATTEN_OK;
}

static batten_status note_end(bat_pcd_reading *r, size_t count)
{
    if (count < r->points) {
        r->input->is_cut = true;
        batten_notes_add(r->input->notes, r->input->file, 0, "",
                         "%zu of %zu points are in the file", count, r->points);
    }
    return BATTEN_OK;
}

/* The numbers of a line; false when one of the coordinates is missing or none. */
static bool read_row(const bat_pcd_reading *r, bat_span line, double point[3])
{
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    int found = 0;
    for (int k = 0; k < r->field_count; k++)
        for (int i = 0; i < r->fields[k].count; i++) {
            bat_span word;
            if (!bat_next_in_line(&words, &word))
                return found == 3;
            for (int a = 0; a < 3; a++)
                if (r->axis[a] == k) {
                    found++;
                    if (bat_word_is_like(word, "nan") || bat_word_is_like(word, "-nan"))
                        point[a] = (double)NAN;
                    else if (!bat_word_real(r->input, r->line, word, &point[a]))
                        return false;
                }
        }
    return found == 3;
}

static void leave_out(const bat_pcd_reading *r, size_t index)
{
    r->input->left_out++;
    batten_notes_add(r->input->notes, r->input->file, r->line, "",
                     "point %zu is left out: a coordinate is missing or not a number", index);
}

static batten_status read_ascii(bat_pcd_reading *r)
{
    bat_span line, word;
    size_t count = 0;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && count < r->points && bat_next_line(r->input, &r->at, &line)) {
        double point[3];
        bat_scan words = bat_scan_begin(line.bytes, line.length);
        r->line++;
        if (!bat_next_in_line(&words, &word))
            continue;
        count++;
        if (read_row(r, line, point))
            status = take_point(r, point);
        else {
            leave_out(r, count);
        }
        if (status == BATTEN_OK && count % 10000 == 0)
            status = bat_input_step(r->input, r->at);
    }
    if (status == BATTEN_OK && count == r->points)
        bat_input_behind(r->input, r->at);
    return status == BATTEN_OK ? note_end(r, count) : status;
}

static double decode(const bat_pcd_field *f, const char *at)
{
    if (f->type == 'F')
        return f->size == 8 ? bat_bytes_double(at, false) : bat_bytes_float(at, false);
    const uint64_t bits = bat_bytes_get(at, f->size, false);
    const bool is_negative = f->type == 'I' && bits >> (8 * (unsigned)f->size - 1);
    /* The magnitude first: a double near 2^64 cannot tell -1 from 0. */
    const uint64_t magnitude = (~bits + 1) & UINT64_MAX >> (64 - 8 * (unsigned)f->size);
    return is_negative ? -(double)magnitude : (double)bits;
}

static size_t bytes_of(const bat_pcd_field *f)
{
    return (size_t)f->size * (size_t)f->count;
}

static size_t bytes_of_point(const bat_pcd_reading *r)
{
    size_t bytes = 0;
    for (int k = 0; k < r->field_count; k++)
        bytes += bytes_of(&r->fields[k]);
    return bytes;
}

/* Points row by row, or field by field as compressed ones are. */
static batten_status take_bytes(bat_pcd_reading *r, const char *data, size_t count,
                                bool by_field)
{
    size_t offset[3], stride[3];
    batten_status status = BATTEN_OK;
    for (int a = 0; a < 3; a++) {
        offset[a] = 0;
        for (int k = 0; k < r->axis[a]; k++)
            offset[a] += bytes_of(&r->fields[k]) * (by_field ? count : 1);
        stride[a] = by_field ? bytes_of(&r->fields[r->axis[a]]) : bytes_of_point(r);
    }
    for (size_t i = 0; status == BATTEN_OK && i < count; i++) {
        double point[3];
        for (int a = 0; a < 3; a++)
            point[a] = decode(&r->fields[r->axis[a]], data + offset[a] + i * stride[a]);
        status = take_point(r, point);
        if (status == BATTEN_OK && i % 10000 == 9999)
            status = bat_input_step(r->input, r->at);
    }
    return status;
}

static batten_status read_binary(bat_pcd_reading *r)
{
    const size_t room = (r->input->size - r->at) / bytes_of_point(r);
    const size_t count = r->points < room ? r->points : room;
    batten_status status = take_bytes(r, r->input->data + r->at, count, false);
    if (status == BATTEN_OK && count == r->points)
        bat_input_behind(r->input, r->at + count * bytes_of_point(r));
    return status == BATTEN_OK ? note_end(r, count) : status;
}

static batten_status read_compressed(bat_pcd_reading *r)
{
    bat_input *input = r->input;
    const size_t left = input->size - r->at;
    const char *at = input->data + r->at;
    const size_t packed = left >= 8 ? bat_bytes_u32(at) : 0;
    const size_t whole = left >= 8 ? bat_bytes_u32(at + 4) : 0;
    if (left < 8 || packed > left - 8)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0,
                              "%zu bytes of compressed points are promised, %zu are left",
                              packed, left >= 8 ? left - 8 : 0);
    /* Three bytes give at most 264. */
    if (whole % bytes_of_point(r) || whole / bytes_of_point(r) != r->points ||
        whole / 88 > packed)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0,
                              "%zu compressed bytes cannot be the %zu points: %zu bytes are "
                              "promised",
                              packed, r->points, whole);
    batten_status status = bat_input_array(input, whole, 1, &r->unpacked);
    if (status == BATTEN_OK)
        status = bat_lzf(at + 8, packed, r->unpacked, whole);
    if (status == BATTEN_OK)
        bat_input_behind(input, r->at + 8 + packed);
    return status == BATTEN_OK ? take_bytes(r, r->unpacked, r->points, true) : status;
}

static batten_status read_points(bat_pcd_reading *r)
{
    if (r->data == BAT_PCD_COMPRESSED)
        return read_compressed(r);
    if (r->data == BAT_PCD_BINARY)
        return read_binary(r);
    bat_input body = *r->input;
    const batten_status status = bat_input_as_text(&body);
    return status == BATTEN_OK ? read_ascii(r) : status;
}

static batten_status make_model(const bat_pcd_reading *r, batten_model **out)
{
    batten_model *model = NULL;
    if (r->nowhere)
        batten_notes_remark(r->input->notes, r->input->file, 0, "",
                            "%zu point%s %s no position (NaN); not kept", r->nowhere,
                            bat_plural(r->nowhere), bat_one_or_many(r->nowhere, "has", "have"));
    if (r->read.count == 0 && r->points > 0)
        return bat_input_fail(r->input, BATTEN_BAD_FORMAT, 0, "no point could be read");
    batten_status status = batten_model_create(0, &model);
    if (status == BATTEN_OK && r->read.count)
        status = batten_model_add(model, &(batten_object){.name = "points",
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = (int)r->read.count,
                                                          .points = r->read.items});
    return bat_input_hand_over(status, model, out);
}

batten_status bat_read_pcd(bat_input *input, batten_model **out)
{
    bat_pcd_reading *r = NULL;
    batten_status status = bat_input_array(input, 1, sizeof *r, &r);
    if (status != BATTEN_OK)
        return status;
    r->input = input;
    r->read.size = 3 * sizeof(double);
    status = bat_input_past_mark(input);
    if (status == BATTEN_OK)
        status = bat_pcd_read_header(r);
    if (status == BATTEN_OK)
        status = read_points(r);
    if (status == BATTEN_OK)
        status = make_model(r, out);
    bat_release(r->unpacked);
    bat_release(r->read.items);
    bat_release(r);
    return status;
}
