/* Lengths in feet, inches and eighths of an inch, as boat builders write them. */
#include "exchange/csv/separated.h"

#include <limits.h>
#include <string.h>

/* An integer of one or more digits from *text on, at most `most`; -1 where there is no such integer. */
static int read_digits(const char **text, int most)
{
    const char *begin = *text;
    int value = 0;
    for (; **text >= '0' && **text <= '9' && value <= most && value < INT_MAX / 10 - 1;
         (*text)++)
        value = 10 * value + (**text - '0');
    return *text > begin && value <= most ? value : -1;
}

bool bat_read_feet(const char *text, bool is_name, double *inches)
{
    enum { MOST_FEET = 1000000, INCHES = 11, EIGHTHS = 8 };
    const bool negative = *text == '-';
    text += negative;
    const int feet = read_digits(&text, MOST_FEET);
    if (feet < 0 || *text++ != '-')
        return false;
    const int whole = read_digits(&text, is_name ? MOST_FEET : INCHES);
    if (whole < 0 || *text++ != '-')
        return false;
    const int eighths = read_digits(&text, EIGHTHS);
    if (eighths < 0 || *text != '\0')
        return false;
    const double value = 12.0 * feet + whole + eighths / 8.0;
    *inches = negative ? -value : value;
    return true;
}

batten_status bat_field_length(const bat_separated *table, int field, bool *has_feet,
                               double *value)
{
    const char *text = table->fields[field].text;
    if (bat_field_is_absent(table, field)) {
        *value = (double)NAN;
        return BATTEN_OK;
    }
    if (bat_read_feet(text, false, value)) {
        *has_feet = true;
        if (text[strlen(text) - 1] == '8')
            batten_notes_add(table->input->notes, table->input->file, table->line, "",
                             "column %d: '%.40s' has eight eighths, one inch more",
                             table->fields[field].column, text);
        return BATTEN_OK;
    }
    const char *dash = strchr(text + 1, '-');
    if (dash && dash[-1] >= '0' && dash[-1] <= '9')
        return bat_field_fail(table, field,
                              "'%.40s' is not feet-inches-eighths with inches below 12 and "
                              "eighths below 8",
                              text);
    return bat_field_number(table, field, value);
}
