#include "exchange/recognise.h"
#include "exchange/csv/csv.h"
#include "exchange/iges/iges.h"

#include <string.h>

/* Beginnings of files that are known and not read. */
static const struct {
    const char *bytes;
    size_t length;
    const char *name;
} signatures[] = {
    {"PK\x03\x04", 4, "a ZIP archive"},
    {"\x1f\x8b", 2, "compressed with gzip"},
    {"BZh", 3, "compressed with bzip2"},
    {"\xfd"
     "7zXZ",
     5, "compressed with xz"},
    {"7z\xbc\xaf", 4, "a 7-Zip archive"},
    {"%PDF", 4, "a PDF document"},
    {"\x89PNG", 4, "a PNG picture"},
    {"\xff\xd8\xff", 3, "a JPEG picture"},
    {"GIF8", 4, "a GIF picture"},
    {"\xd0\xcf\x11\xe0", 4, "an office document"},
    {"3D Geometry File Format", 23, "a 3DM model"},
    {"glTF", 4, "a glTF model"},
    {"ply\n", 4, "a PLY mesh"},
    {"ply\r", 4, "a PLY mesh"},
    {"solid ", 6, "an STL mesh"},
    {"AC10", 4, "a DWG drawing"},
    {"AutoCAD Binary DXF", 18, "a binary DXF drawing"},
    {"  0\nSECTION", 11, "a DXF drawing"},
    {"  0\r\nSECTION", 12, "a DXF drawing"},
    {"DBRep_DrawableShape", 19, "an OCCT B-rep"},
    {"<?xml", 5, "an XML document"},
    {"<svg", 4, "an SVG drawing"},
    {"batten:", 7, "a design of Batten, to be built rather than read"},
    {"{", 1, "a JSON document"},
};

/* Do the bytes from `at` on begin so? */
static bool begins(const bat_input *input, size_t at, const char *bytes, size_t length)
{
    return input->size - at >= length && memcmp(input->data + at, bytes, length) == 0;
}

/* Where white space at the beginning ends. */
static size_t past_white(const bat_input *input)
{
    size_t at = 0;
    while (at < input->size && (bat_is_blank(input->data[at]) || input->data[at] == '\n' ||
                                input->data[at] == '\r'))
        at++;
    return at;
}

static batten_status refuse_signatures(const bat_input *input)
{
    const size_t at = past_white(input);
    static const char step[] = "ISO-10303-21;";
    for (size_t k = 0; k < sizeof signatures / sizeof signatures[0]; k++)
        if (begins(input, 0, signatures[k].bytes, signatures[k].length) ||
            begins(input, at, signatures[k].bytes, signatures[k].length))
            return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "this is %s, which is not read",
                                  signatures[k].name);
    if (begins(input, at, step, sizeof step - 1))
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                              "STEP files can be written but not yet read");
    return BATTEN_OK;
}

static bool is_number_row(const bat_separated *table, int *count)
{
    *count = bat_row_length(table);
    for (int k = 0; k < *count; k++)
        if (!bat_field_is_number(table, k))
            return false;
    return *count > 0;
}

/* The first two numbers of a row. */
static batten_status two_numbers(const bat_separated *table, double out[3])
{
    batten_status status = bat_field_number(table, 0, &out[0]);
    return status == BATTEN_OK ? bat_field_number(table, 1, &out[1]) : status;
}

/* Rows of numbers: points, unless the first row is Lednicer's counts. */
static batten_status recognise_numbers(bat_separated *table, int columns, batten_format *format)
{
    double first[3] = {0, 0, 0}, second[3] = {0, 0, 0};
    bool more = false;
    int count = 0;
    *format = BATTEN_FORMAT_POINTS;
    if (columns != 2)
        return BATTEN_OK;
    batten_status status = two_numbers(table, first);
    if (status == BATTEN_OK)
        status = bat_separated_next(table, &more);
    if (status == BATTEN_OK && more && is_number_row(table, &count) && count == 2) {
        status = two_numbers(table, second);
        if (status == BATTEN_OK && bat_are_aerofoil_counts(first, second))
            *format = BATTEN_FORMAT_AEROFOIL;
    }
    return status;
}

static batten_status recognise_rows(bat_separated *table, batten_format *format)
{
    bool more = false;
    int count = 0;
    batten_status status = bat_separated_next(table, &more);
    if (status != BATTEN_OK || !more)
        return status;
    if (is_number_row(table, &count))
        return recognise_numbers(table, count, format);
    if (bat_is_points_header(table)) {
        *format = BATTEN_FORMAT_POINTS;
        return BATTEN_OK;
    }
    if (bat_offsets_dialect_of(table) != BAT_OFFSETS_NONE) {
        *format = BATTEN_FORMAT_OFFSETS;
        return BATTEN_OK;
    }
    table->separator = 0;
    status = bat_separated_next(table, &more);
    if (status == BATTEN_OK && more && bat_row_length(table) == 2 &&
        bat_field_is_number(table, 0))
        *format = BATTEN_FORMAT_AEROFOIL;
    return status;
}

static batten_status recognise_text(bat_input *input, batten_format *format)
{
    bat_separated table;
    batten_notes *notes = input->notes;
    batten_format found = BATTEN_FORMAT_AUTO;
    input->notes = NULL; /* the reader itself will say it again */
    bat_separated_begin(&table, input);
    batten_status status = recognise_rows(&table, &found);
    bat_separated_end(&table);
    input->notes = notes;
    if (status == BATTEN_OK && found == BATTEN_FORMAT_AUTO)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "%s",
                              input->size ? "the format of the file is not recognised"
                                          : "the file is empty");
    if (status == BATTEN_OK)
        *format = found;
    return status;
}

batten_status bat_recognise(bat_input *input, batten_format *format)
{
    batten_status status = refuse_signatures(input);
    if (status != BATTEN_OK)
        return status;
    bool is_iges = false;
    status = bat_iges_recognise(input, &is_iges);
    if (status != BATTEN_OK || is_iges) {
        *format = BATTEN_FORMAT_IGES;
        return status;
    }
    status = bat_input_as_text(input);
    return status == BATTEN_OK ? recognise_text(input, format) : status;
}
