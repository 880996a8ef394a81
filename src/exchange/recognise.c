/* Finds the format of bytes by their content, and names known ones that are not read. */
#include "exchange/recognise.h"
#include "exchange/csv/csv.h"
#include "exchange/formats.h"
#include "exchange/reading/scan.h"

/* Beginnings of files that are known and not read. */
static const struct {
    const char *bytes;
    const char *name;
} signatures[] = {
    {"PK\x03\x04", "a ZIP archive"},
    {"\x1f\x8b", "compressed with gzip"},
    {"BZh", "compressed with bzip2"},
    {"\xfd"
     "7zXZ",
     "compressed with xz"},
    {"7z\xbc\xaf", "a 7-Zip archive"},
    {"%PDF", "a PDF document"},
    {"\x89PNG", "a PNG picture"},
    {"\xff\xd8\xff", "a JPEG picture"},
    {"GIF8", "a GIF picture"},
    {"\xd0\xcf\x11\xe0", "an office document"},
    {"3D Geometry File Format", "a 3DM model"},
    {"glTF", "a glTF model"},
    {"AC10", "a DWG drawing"},
    {"AutoCAD Binary DXF", "a binary DXF drawing"},
    {"DBRep_DrawableShape", "an OCCT B-rep"},
    {"CASCADE Topology", "an OCCT B-rep"},
    {"Open CASCADE Topology", "a binary OCCT B-rep"},
    {"<?xml", "an XML document"},
    {"batten:", "a design of Batten, to be built rather than read"},
    {"{", "a JSON document"},
};

/* Files with a beginning that is known to be of something else. */
static batten_status refuse_signatures(const bat_input *input)
{
    const size_t at = bat_past_white(input);
    for (size_t k = 0; k < sizeof signatures / sizeof signatures[0]; k++)
        if (bat_begins(input, 0, signatures[k].bytes) ||
            bat_begins(input, at, signatures[k].bytes))
            return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "this is %s, which is not read",
                                  signatures[k].name);
    /* The length of the text, in four bytes, and the text. */
    if (bat_begins(input, 4, "FREE!ship"))
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0,
                              "this is a binary FREE!ship model (.fbm), which is not read; the "
                              "text form, .ftm, is");
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
    if (bat_field_is_number(table, 0) &&
        (bat_row_length(table) == 1 || bat_row_length(table) == 3)) {
        bool are_frames = false;
        status = bat_are_frames(table->input, &are_frames);
        if (status != BATTEN_OK || are_frames) {
            *format = BATTEN_FORMAT_OFFSET_TABLE;
            return status;
        }
    }
    if (is_number_row(table, &count))
        return recognise_numbers(table, count, format);
    if (bat_is_offsets_header(table)) {
        *format = BATTEN_FORMAT_OFFSET_TABLE;
        return BATTEN_OK;
    }
    if (bat_is_points_header(table)) {
        *format = BATTEN_FORMAT_POINTS;
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

/* By the formats that know their own files. */
static batten_status ask_formats(bat_input *input, bool *is_such, batten_format *format)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && !*is_such && bat_format_at(k); k++) {
        const bat_format_row *row = bat_format_at(k);
        if (row->recognise)
            status = row->recognise(input, is_such);
        if (status == BATTEN_OK && *is_such)
            *format = row->format;
    }
    return status;
}

batten_status bat_recognise(bat_input *input, batten_format *format)
{
    bool is_such = false;
    batten_status status = ask_formats(input, &is_such, format);
    if (status == BATTEN_OK && !is_such)
        status = refuse_signatures(input);
    if (status != BATTEN_OK || is_such)
        return status;
    status = bat_input_as_text(input);
    return status == BATTEN_OK ? recognise_text(input, format) : status;
}
