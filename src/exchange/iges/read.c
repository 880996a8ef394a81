#include "exchange/iges/entities.h"
#include "exchange/iges/iges.h"

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
    {1, "in", 0.0254}, {2, "mm", 0.001},     {4, "ft", 0.3048},     {5, "mi", 1609.344},
    {6, "m", 1},       {7, "km", 1000},      {8, "mil", 0.0000254}, {9, "um", 1e-6},
    {10, "cm", 0.01},  {11, "uin", 2.54e-8}, {1, "inch", 0.0254},
};
#define UNITS (sizeof units / sizeof units[0])

double bat_iges_unit_of_flag(int flag)
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
enum { SCALE = 10, UNIT_FLAG = 11, UNIT_NAME = 12 };

static batten_status read_unit(bat_iges_reading *reading)
{
    const bat_iges_file *file = &reading->file;
    bat_input *input = reading->input;
    const bat_iges_token *tokens = file->tokens.items;
    const bool named = file->tokens.count > UNIT_NAME && tokens[UNIT_NAME].is_string;
    const double by_name = named ? unit_of_name(tokens[UNIT_NAME].text) : 0;
    const bool said = file->tokens.count > UNIT_FLAG && tokens[UNIT_FLAG].text.length > 0;
    int flag = 0;
    if (bat_iges_integer(file, UNIT_FLAG, &flag) != BATTEN_OK)
        return bat_input_fail(input, BATTEN_BAD_FORMAT, 0, "global section, unit: %.200s",
                              batten_message());
    double unit = said && flag != 3 ? bat_iges_unit_of_flag(flag) : by_name;
    if (unit == 0) {
        unit = 0.0254;
        batten_notes_add(input->notes, input->file, 0, "",
                         "the file does not say its unit; taken as inch");
    } else if (by_name > 0 && by_name != unit) {
        batten_notes_add(input->notes, input->file, 0, "",
                         "the unit has the flag %d and the name '%.*s'; the flag counts", flag,
                         (int)tokens[UNIT_NAME].text.length, tokens[UNIT_NAME].text.bytes);
    }
    reading->unit_metres = unit;
    return BATTEN_OK;
}

static void note_scale(const bat_iges_reading *reading)
{
    double scale = 1;
    const bat_iges_token *tokens = reading->file.tokens.items;
    const bool said = reading->file.tokens.count > SCALE && tokens[SCALE].text.length > 0;
    if (said && bat_iges_real(&reading->file, SCALE, &scale) == BATTEN_OK && scale != 1)
        batten_notes_add(reading->input->notes, reading->input->file, 0, "",
                         "the model is drawn at scale %g; its own numbers are kept", scale);
}

/* ---- the whole ---- */

static void note_counts(const bat_iges_reading *reading)
{
    const bat_iges_count *counts = reading->left_out.items;
    batten_notes *notes = reading->input->notes;
    const char *file = reading->input->file;
    for (size_t k = 0; k < reading->left_out.count; k++)
        batten_notes_add(
            notes, file, 0, bat_iges_type_name(counts[k].type),
            "%d of type %d form %d are hidden or not of a kind that is read; left out",
            counts[k].count, counts[k].type, counts[k].form);
    if (reading->dependent_count)
        batten_notes_add(notes, file, 0, "",
                         "%d entities are parts of others and not read on their own",
                         reading->dependent_count);
}

static batten_status read_entries(bat_iges_reading *reading)
{
    bat_input *input = reading->input;
    batten_status status = BATTEN_OK;
    const size_t count = reading->file.entries.count;
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        if (k % 64 == 0)
            status = bat_input_step(input, k * input->size / count);
        if (status == BATTEN_OK)
            status = bat_iges_read_entry(reading, k);
    }
    if (status != BATTEN_OK)
        return status;
    note_counts(reading);
    if (batten_model_count(reading->model) > 0 ||
        input->left_out + reading->dependent_count == 0)
        return BATTEN_OK;
    const bat_iges_count *first = reading->left_out.items;
    return bat_input_fail(
        input, BATTEN_UNSUPPORTED, 0, "none of its %d entities could be read%s%s",
        input->left_out + reading->dependent_count, first ? "; there are: " : "",
        first ? bat_iges_type_name(first->type) : "");
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
    note_scale(reading);
    if (!reading->file.has_start)
        batten_notes_add(input->notes, input->file, 0, "", "the start section is missing");
    input->is_cut = !reading->file.has_end;
    status = batten_model_create(reading->unit_metres, &reading->model);
    return status == BATTEN_OK ? read_entries(reading) : status;
}

batten_status bat_read_iges(bat_input *input, batten_model **out)
{
    bat_iges_reading reading = {.input = input, .left_out = {.size = sizeof(bat_iges_count)}};
    bool is_iges = false;
    batten_status status = bat_iges_recognise(input, &is_iges);
    if (status == BATTEN_OK && !is_iges)
        status = bat_input_fail(input, BATTEN_BAD_FORMAT, 1,
                                "no IGES file: column 73 of its first record has no S or G");
    if (status == BATTEN_OK)
        status = read_all(&reading);
    if (status == BATTEN_OK)
        *out = batten_model_ref(reading.model);
    batten_model_unref(reading.model);
    bat_release(reading.left_out.items);
    bat_iges_end(&reading.file);
    return status;
}
