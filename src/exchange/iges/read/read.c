/* Reads an IGES file: its units and sender, then its entities. */
#include "base/plural.h"
#include "exchange/iges/iges.h"
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/bodies.h"
#include "exchange/iges/read/levels.h"
#include "exchange/iges/read/objects.h"
#include "exchange/iges/read/references.h"

#include <stdio.h>
#include <string.h>

/* ---- recognition ---- */

/* The letter in column 73 of the first record that is not blank; 0 when there is none. */
static char first_letter(const bat_input *input)
{
    bat_span record;
    const bool mark = input->size >= 3 && memcmp(input->data, "\xef\xbb\xbf", 3) == 0;
    size_t at = mark ? 3 : 0;
    while (bat_next_line(input, &at, &record)) {
        size_t i = 0;
        while (i < record.length && bat_is_blank(record.bytes[i]))
            i++;
        if (i == record.length)
            continue;
        bool numbered = record.length > 73;
        for (i = 73; i < record.length && i < 80; i++)
            numbered &= strchr(" 0123456789", record.bytes[i]) && record.bytes[i];
        return numbered ? record.bytes[72] : '\0';
    }
    return '\0';
}

batten_status bat_iges_recognise(const bat_input *input, bool *is_iges)
{
    const char letter = first_letter(input);
    if (letter == 'C')
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 1,
                              "this is IGES in the compressed form, which is not read");
    if (letter == 'B')
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 1,
                              "this is IGES in the binary form, which is not read");
    *is_iges = letter == 'S' || letter == 'G';
    return BATTEN_OK;
}

/* ---- units ---- */

static const struct {
    int flag;
    const char *name;
    double metres;
} units[] = {
    /* metres in one, by the flag of global parameter 14; 1 is the inch twice */
    {1, "in", 0.0254}, {2, "mm", 0.001},     {4, "ft", 0.3048},     {5, "mi", 1609.344},
    {6, "m", 1},       {7, "km", 1000},      {8, "mil", 0.0000254}, {9, "um", 1e-6},
    {10, "cm", 0.01},  {11, "uin", 2.54e-8}, {1, "inch", 0.0254},
};
#define UNITS (sizeof units / sizeof units[0])

/* 0 when the flag is unknown. */
static double unit_of_flag(int flag)
{
    for (size_t k = 0; k < UNITS; k++)
        if (units[k].flag == flag)
            return units[k].metres;
    return 0;
}

int bat_iges_flag_of_unit(double metres)
{
    for (size_t k = 0; k < UNITS; k++)
        if (units[k].metres == metres)
            return units[k].flag;
    return 3;
}

/* The unit that a name says, 0 when it is unknown. */
static double unit_of_name(bat_span name)
{
    char word[16] = "";
    if (name.length >= sizeof word)
        return 0;
    for (size_t i = 0; i < name.length; i++)
        word[i] = name.bytes[i] >= 'A' && name.bytes[i] <= 'Z'
                      ? (char)(name.bytes[i] - 'A' + 'a')
                      : name.bytes[i];
    for (size_t k = 0; k < UNITS; k++)
        if (strcmp(word, units[k].name) == 0)
            return units[k].metres;
    return batten_unit_metres(word);
}

/* Places of the global parameters, the two delimiters not counted. */
enum {
    SENDER = 0,
    SYSTEM = 2,
    VERSION = 3,
    SCALE = 10,
    UNIT_FLAG = 11,
    UNIT_NAME = 12,
    RESOLUTION = 16,
    EXTENT = 17,
    STANDARD = 20
};

/* The flag and the name are shown where there are any. */
static void note_no_unit(const bat_input *input, bool said, int flag, bat_span name)
{
    char word[BAT_SHOWN_SIZE] = "", number[32] = "";
    if (said)
        snprintf(number, sizeof number, "the flag %d", flag);
    if (name.length > 0)
        bat_shown(name.bytes, name.length < 80 ? name.length : 80, word);
    if (said || name.length > 0)
        batten_notes_add(input->notes, input->file, 0, "",
                         "its unit has %s%s%s%s%s, which IGES does not have; inches are "
                         "assumed",
                         number, said && word[0] ? " and " : "", word[0] ? "the name '" : "",
                         word, word[0] ? "'" : "");
    else
        batten_notes_add(input->notes, input->file, 0, "",
                         "the file gives no unit; inches are assumed");
}

static batten_status read_unit(bat_iges_reading *reading)
{
    const bat_iges_parameters *global = &reading->file.global;
    bat_input *input = reading->input;
    bool named = false, is_string = false;
    const bat_span name = bat_iges_text(global, UNIT_NAME, &named);
    const double by_name = named ? unit_of_name(name) : 0;
    const bool said = bat_iges_text(global, UNIT_FLAG, &is_string).length > 0;
    int flag = 0;
    if (bat_iges_integer(global, UNIT_FLAG, &flag) != BATTEN_OK)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "global section, unit: %.200s",
                              batten_message());
    double unit = said && flag != 3 ? unit_of_flag(flag) : by_name;
    if (unit == 0) {
        unit = 0.0254;
        note_no_unit(input, said, flag, name);
    } else if (by_name > 0 && by_name != unit) {
        batten_notes_add(input->notes, input->file, 0, "",
                         "the unit has the flag %d and the name '%.*s'; the flag is used", flag,
                         (int)name.length, name.bytes);
    }
    reading->unit_metres = unit;
    return BATTEN_OK;
}

static void note_scale(const bat_iges_reading *reading)
{
    double scale = 1;
    bool is_string = false;
    const bat_iges_parameters *global = &reading->file.global;
    const bool said = bat_iges_text(global, SCALE, &is_string).length > 0;
    if (said && bat_iges_real(global, SCALE, &scale) == BATTEN_OK && scale != 1)
        batten_notes_add(reading->input->notes, reading->input->file, 0, "",
                         "the model is drawn at scale %g; its own numbers are kept", scale);
}

/* A number that may be left away or be nonsense. */
static double positive(const bat_iges_parameters *global, size_t index)
{
    double value = 0;
    return bat_iges_real(global, index, &value) == BATTEN_OK && value > 0 ? value : 0;
}

/* A string of the global section, as it may be shown. */
static const char *shown(const bat_iges_parameters *global, size_t index, char *buffer)
{
    bool is_string = false;
    bat_span text = bat_iges_text(global, index, &is_string);
    if (!is_string || text.length == 0)
        return "?";
    if (text.length > 80)
        text.length = 80;
    return bat_shown(text.bytes, text.length, buffer);
}

static const char *standard_of(int number)
{
    static const char *const names[] = {"?",
                                        "1.0",
                                        "ANSI Y14.26M-1981",
                                        "2.0",
                                        "3.0",
                                        "ASME/ANSI Y14.26M-1987",
                                        "4.0",
                                        "ASME Y14.26M-1989",
                                        "5.0",
                                        "5.1",
                                        "5.2",
                                        "5.3"};
    return names[number >= 1 && number <= 11 ? number : 0];
}

/* Who wrote the file, in which version and unit. */
static void remark_sender(const bat_iges_reading *reading)
{
    const bat_iges_parameters *global = &reading->file.global;
    char sender[BAT_SHOWN_SIZE], system[BAT_SHOWN_SIZE], version[BAT_SHOWN_SIZE];
    int standard = 0;
    if (bat_iges_integer(global, STANDARD, &standard) != BATTEN_OK)
        standard = 0;
    batten_notes_remark(reading->input->notes, reading->input->file, 0, "",
                        "IGES %s by '%s', %s, %s; the unit is %g m, the resolution %g",
                        standard_of(standard), shown(global, SENDER, sender),
                        shown(global, SYSTEM, system), shown(global, VERSION, version),
                        reading->unit_metres, reading->resolution);
}

/* ---- the whole ---- */

static batten_status read_entities(bat_iges_reading *reading)
{
    bat_input *input = reading->input;
    const size_t count = reading->file.entries.count;
    batten_status status =
        bat_input_array(input, count, sizeof(bat_iges_shape), &reading->shapes);
    if (status == BATTEN_OK)
        status = bat_iges_mark_parts(reading);
    if (status == BATTEN_OK)
        status = bat_iges_read_groups(reading);
    if (status == BATTEN_OK)
        status = bat_iges_read_levels(reading);
    if (status == BATTEN_OK)
        status = bat_iges_add_roots(reading);
    if (status != BATTEN_OK)
        return status;
    bat_iges_note_oddities(reading);
    bat_census_note(input, &reading->census);
    if (batten_model_count(reading->model) > 0 || input->left_out == 0)
        return BATTEN_OK;
    return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "its %d entit%s could not be read",
                          input->left_out, bat_one_or_many(input->left_out, "y", "ies"));
}

static batten_status read_all(bat_iges_reading *reading)
{
    bat_input *input = reading->input;
    batten_status status = bat_iges_begin(input, &reading->file);
    if (status == BATTEN_OK)
        status = bat_iges_global(&reading->file);
    if (status == BATTEN_OK)
        status = read_unit(reading);
    if (status != BATTEN_OK)
        return status;
    reading->resolution = positive(&reading->file.global, RESOLUTION);
    reading->extent = positive(&reading->file.global, EXTENT);
    remark_sender(reading);
    note_scale(reading);
    if (!reading->file.has_start)
        batten_notes_add(input->notes, input->file, 0, "", "the start section is missing");
    input->is_cut = !reading->file.has_end;
    status = batten_model_create(reading->unit_metres, &reading->model);
    if (status == BATTEN_OK)
        status = bat_iges_call(input, &reading->file.global, SENDER, reading->model);
    return status == BATTEN_OK ? read_entities(reading) : status;
}

static void end_reading(bat_iges_reading *reading)
{
    bat_iges_parameters **frames = reading->frames.items;
    for (size_t k = 0; k < reading->frames.count; k++) {
        bat_iges_parameters_end(frames[k]);
        bat_release(frames[k]);
    }
    bat_release(reading->frames.items);
    for (size_t k = 0; reading->shapes && k < reading->file.entries.count; k++) {
        batten_curve_unref(reading->shapes[k].curve);
        batten_surface_unref(reading->shapes[k].surface);
        batten_model_unref(reading->shapes[k].definition);
    }
    bat_release(reading->shapes);

    bat_iges_end_tables(reading);
    bat_iges_end_groups(reading);
    bat_iges_end_levels(reading);
    bat_census_end(&reading->census);
    bat_iges_end(&reading->file);
    batten_model_unref(reading->model);
}

batten_status bat_read_iges(bat_input *input, batten_model **out)
{
    bat_iges_reading reading = {
        .input = input, .types = bat_iges_all_types(), .frames = {.size = sizeof(void *)}};
    bool is_iges = false;
    bat_iges_start_groups(&reading);
    bat_iges_start_levels(&reading);
    bat_iges_start_tables(&reading);

    bat_census_begin(&reading.census);
    batten_status status = bat_iges_recognise(input, &is_iges);
    if (status == BATTEN_OK && !is_iges)
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 1,
                                "not an IGES file: column 73 of its first record has no S or "
                                "G");
    if (status == BATTEN_OK)
        status = read_all(&reading);
    if (status == BATTEN_OK)
        *out = batten_model_ref(reading.model);
    end_reading(&reading);
    return status;
}
