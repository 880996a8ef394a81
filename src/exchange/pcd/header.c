/* The header of a .pcd file. */
#include "exchange/pcd/header.h"
#include "base/plural.h"
#include "exchange/reading/scan.h"
#include <limits.h>
#include <string.h>

/* ---- the header ---- */

static batten_status bad_line(const bat_pcd_reading *r, const char *what)
{
    return bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->line, "bad header: %s", what);
}

static batten_status read_fields(bat_pcd_reading *r, bat_scan *words)
{
    bat_span word;
    r->field_count = 0;
    while (bat_next_in_line(words, &word)) {
        if (r->field_count == BAT_PCD_FIELDS)
            return bat_input_fail(r->input, BATTEN_TOO_LARGE, r->line,
                                  "a point has more than %d fields", BAT_PCD_FIELDS);
        r->fields[r->field_count++] = (bat_pcd_field){word, 4, 1, 'F'};
    }
    return BATTEN_OK;
}

/* SIZE, TYPE and COUNT: one word for each field. */
static batten_status read_of_fields(bat_pcd_reading *r, bat_scan *words, char what)
{
    bat_span word;
    for (int k = 0; k < r->field_count; k++) {
        bat_pcd_field *f = &r->fields[k];
        int64_t number = 0;
        if (!bat_next_in_line(words, &word))
            return bad_line(r, "there are fewer words than fields");
        if (what == 'T') {
            f->type = word.bytes[0];
            if (word.length != 1 || !strchr("IUF", f->type))
                return bad_line(r, "a type must be I, U or F");
        } else if (!bat_word_integer(word, 1, what == 'S' ? 8 : 65536, &number))
            return bad_line(r, "a size or count is not a whole number that is allowed");
        else if (what == 'S')
            f->size = (int)number;
        else
            f->count = (int)number;
    }
    return BATTEN_OK;
}

static batten_status read_count(bat_pcd_reading *r, bat_scan *words, size_t *count)
{
    bat_span word;
    int64_t number = 0;
    if (!bat_next_in_line(words, &word) || !bat_word_integer(word, 0, INT_MAX, &number))
        return bad_line(r, "a count is not a whole number");
    *count = (size_t)number;
    return BATTEN_OK;
}

static batten_status read_form(bat_pcd_reading *r, bat_scan *words)
{
    static const char *const names[] = {"ascii", "binary", "binary_compressed"};
    bat_span word = {"", 0};
    bat_next_in_line(words, &word);
    for (int k = 0; k < 3; k++)
        if (bat_word_is(word, names[k]))
            r->data = (bat_pcd_form)(BAT_PCD_ASCII + k);
    return r->data == BAT_PCD_NO_DATA
               ? bad_line(r, "data must be ascii, binary or binary_compressed")
               : BATTEN_OK;
}

static bool is_usual_viewpoint(bat_scan *words)
{
    static const double usual[7] = {0, 0, 0, 1, 0, 0, 0};
    bat_span word;
    for (int k = 0; k < 7; k++) {
        double number = usual[k];
        if (!bat_next_in_line(words, &word) || !bat_word_number(word, &number) ||
            number != usual[k])
            return false;
    }
    return true;
}

/* Where the sensor stood: points are not moved by it. */
static void note_viewpoint(const bat_pcd_reading *r, bat_scan *words)
{
    if (!is_usual_viewpoint(words))
        batten_notes_remark(r->input->notes, r->input->file, r->line, "",
                            "the sensor has a position of its own; the points are not moved");
}

static batten_status read_line(bat_pcd_reading *r, bat_span line)
{
    bat_scan words = bat_scan_begin(line.bytes, line.length);
    bat_span word;
    if (!bat_next_in_line(&words, &word) || word.bytes[0] == '#' ||
        bat_word_is(word, "VERSION"))
        return BATTEN_OK;
    if (bat_word_is(word, "FIELDS") || bat_word_is(word, "COLUMNS"))
        return read_fields(r, &words);
    if (bat_word_is(word, "SIZE") || bat_word_is(word, "TYPE") || bat_word_is(word, "COUNT"))
        return read_of_fields(r, &words, word.bytes[0]);
    if (bat_word_is(word, "WIDTH"))
        return read_count(r, &words, &r->width);
    if (bat_word_is(word, "HEIGHT"))
        return read_count(r, &words, &r->height);
    if (bat_word_is(word, "POINTS")) {
        r->has_points = true;
        return read_count(r, &words, &r->points);
    }
    if (bat_word_is(word, "DATA"))
        return read_form(r, &words);
    if (!bat_word_is(word, "VIEWPOINT"))
        return bad_line(r, "unknown header line");
    note_viewpoint(r, &words);
    return BATTEN_OK;
}

static batten_status find_axis(bat_pcd_reading *r, int a, const char *name)
{
    r->axis[a] = -1;
    for (int k = 0; k < r->field_count; k++)
        if (bat_word_is(r->fields[k].name, name) && r->fields[k].count == 1)
            r->axis[a] = k;
    if (r->axis[a] < 0)
        return bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->line,
                              "there is no field %s with one value for each point", name);
    return BATTEN_OK;
}

static batten_status check_field(const bat_pcd_reading *r, const bat_pcd_field *f)
{
    const bool is_real = f->type == 'F' && (f->size == 4 || f->size == 8);
    const bool is_whole =
        f->type != 'F' && (f->size == 1 || f->size == 2 || f->size == 4 || f->size == 8);
    if (r->data != BAT_PCD_ASCII && !is_real && !is_whole)
        return bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->line,
                              "a number of type %c cannot have %d byte%s", f->type, f->size,
                              bat_plural(f->size));
    return BATTEN_OK;
}

static batten_status find_axes(bat_pcd_reading *r)
{
    static const char *const names[] = {"x", "y", "z"};
    int others = 0;
    for (int a = 0; a < 3; a++) {
        const batten_status status = find_axis(r, a, names[a]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int k = 0; k < r->field_count; k++) {
        const bat_pcd_field *f = &r->fields[k];
        const batten_status status = check_field(r, f);
        if (status != BATTEN_OK)
            return status;
        others +=
            k != r->axis[0] && k != r->axis[1] && k != r->axis[2] && !bat_word_is(f->name, "_");
    }
    if (others && r->points)
        batten_notes_add(
            r->input->notes, r->input->file, 0, "",
            "of points only coordinates are kept; left out of %zu point%s: %d further "
            "field%s",
            r->points, bat_plural(r->points), others, bat_plural(others));
    return BATTEN_OK;
}

batten_status bat_pcd_read_header(bat_pcd_reading *r)
{
    bat_span line;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && r->data == BAT_PCD_NO_DATA) {
        r->line++;
        if (!bat_next_line(r->input, &r->at, &line))
            return bat_input_fail(r->input, BATTEN_BAD_FORMAT, r->line,
                                  "the file ends within the header");
        status = bat_input_limit(r->input, r->line, line.length, r->input->limits.line_bytes,
                                 "bytes in the line");
        if (status == BATTEN_OK)
            status = read_line(r, line);
    }
    if (!r->has_points)
        r->points = r->height ? r->width * r->height : r->width;
    if (status == BATTEN_OK)
        status =
            bat_input_limit(r->input, r->line, r->points, r->input->limits.points, "points");
    return status == BATTEN_OK ? find_axes(r) : status;
}
