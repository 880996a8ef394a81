/* Numbers with units as a design writes them: "3.2 m", "90 deg", "5 ft 6 1/2 in", "5'-6\"". */
#include "design/text/literal.h"

#include <batten/model.h>
#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

/* ---- literals: numbers with units ---- */

static batten_status read_number(bat_reader *r, double *value)
{
    const char *at = r->at;
    size_t used = 0;
    if (*at == '+' || *at == '-')
        return bat_fail(BATTEN_BAD_FORMAT, "a number is expected at \"%.40s\"", at);
    const batten_status status = batten_number_read(at, strlen(at), value, &used);
    if (status == BATTEN_OVERFLOW)
        return bat_fail(status, "the number \"%.40s\" is too large", at);
    if (status != BATTEN_OK)
        return bat_fail(BATTEN_BAD_FORMAT, "a number is expected at \"%.40s\"", at);
    if (*value == 0)
        for (size_t i = 0; i < used && at[i] != 'e' && at[i] != 'E'; i++)
            if (at[i] >= '1' && at[i] <= '9')
                r->vanished = true;
    r->at += used;
    return BATTEN_OK;
}

/* "6 1/2": a whole number, a blank and a fraction. */
static batten_status read_fraction(bat_reader *r, double *value)
{
    const char *at = bat_skip_blanks(r->at);
    const char *digit = at;
    while (bat_is_digit(*digit))
        digit++;
    if (at == r->at || digit == at || *digit != '/' || !bat_is_digit(digit[1]))
        return BATTEN_OK;
    double above, below;
    batten_status status = batten_number_read(at, (size_t)(digit - at), &above, NULL);
    r->at = digit + 1;
    if (status == BATTEN_OK)
        status = read_number(r, &below);
    if (status == BATTEN_OK && below == 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "the fraction \"%.40s\" divides by 0", at);
    if (status == BATTEN_OK)
        *value += above / below;
    return status;
}

/* The unit after a number: its name in `name` [16], and where it ends. */
static const char *unit_after(const char *at, char *name)
{
    at = bat_skip_blanks(at);
    if (*at == '\'' || *at == '"') {
        strcpy(name, *at == '\'' ? "ft" : "in");
        return at + 1;
    }
    const size_t length = bat_name_length(at);
    if (length == 0 || length > 15)
        return NULL;
    memcpy(name, at, length);
    name[length] = 0;
    return at + length;
}

static const char *const angle_words[] = {"deg", "degree", "degrees",
                                          "rad", "radian", "radians"};

static double angle_unit(const char *name)
{
    for (size_t i = 0; i < sizeof angle_words / sizeof angle_words[0]; i++)
        if (strcmp(name, angle_words[i]) == 0)
            return i < 3 ? BAT_PI / 180 : 1;
    return 0;
}

/* `value` units of `metres` in design units, with one rounding where the ratio is whole. */
static double in_design_units(double value, double metres, double design)
{
    return metres >= design ? value * (metres / design) : value / (design / metres);
}

/* After feet: inches, as in 5 ft 6 1/2 in. */
static batten_status read_inches(bat_reader *r, double *value)
{
    const char *at = bat_skip_blanks(r->at);
    if (*at == '-' && at == r->at && !r->in_expression) /* 5'-6" */
        at++;
    if (!bat_is_digit(*at) && *at != '.')
        return BATTEN_OK;
    bat_reader ahead = {at, r->names, false, r->in_expression};
    double inches;
    batten_status status = read_number(&ahead, &inches);
    if (status == BATTEN_OK)
        status = read_fraction(&ahead, &inches);
    if (status != BATTEN_OK)
        return status;
    char unit[16];
    const char *after = unit_after(ahead.at, unit);
    if (!after || batten_unit_metres(unit) != batten_unit_metres("in"))
        return BATTEN_OK;
    *value += in_design_units(inches, batten_unit_metres("in"), r->names->unit_metres);
    r->at = after;
    r->vanished |= ahead.vanished;
    return BATTEN_OK;
}

batten_status bat_literal_read(bat_reader *r, bat_quantity *out)
{
    const char *begin = r->at;
    double value;
    batten_status status = read_number(r, &value);
    if (status == BATTEN_OK)
        status = read_fraction(r, &value);
    if (status != BATTEN_OK)
        return status;
    char unit[16];
    const char *after = unit_after(r->at, unit);
    bat_quantity made = {value, 0, 0};
    if (after) {
        const double metres = batten_unit_metres(unit);
        const double radians = angle_unit(unit);
        if (metres <= 0 && radians <= 0)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "unknown unit '%s'; known are m mm cm km um in ft mil mi deg rad",
                            unit);
        r->at = after;
        made.length = metres > 0;
        made.angle = metres <= 0;
        made.value = metres > 0 ? in_design_units(value, metres, r->names->unit_metres)
                                : value * radians;
        if (metres > 0 && metres == batten_unit_metres("ft"))
            status = read_inches(r, &made.value);
    }
    if (status == BATTEN_OK && !isfinite(made.value))
        status = bat_fail(BATTEN_OVERFLOW, "the number \"%.40s\" is too large", begin);
    if (status == BATTEN_OK)
        *out = made;
    return status;
}

/* ---- dimensions ---- */

const char *bat_dimension_name(int length, int angle, char *text)
{
    if (angle == 0 && length >= 0 && length <= 3)
        return (const char *const[]){"a number", "a length", "an area", "a volume"}[length];
    if (angle == 1 && length == 0)
        return "an angle";
    snprintf(text, 48, "length^%d angle^%d", length, angle);
    return text;
}

batten_status bat_signed_read(bat_reader *r, bat_quantity *out)
{
    const char *begin = r->at;
    const bool minus = *r->at == '-';
    if (*r->at == '-' || *r->at == '+')
        r->at++;
    bat_quantity made;
    const batten_status status = bat_literal_read(r, &made);
    if (status != BATTEN_OK)
        return status;
    if (*bat_skip_blanks(r->at))
        return bat_fail(BATTEN_BAD_FORMAT, "\"%.60s\" is not a number: \"%.40s\" is left over",
                        begin, bat_skip_blanks(r->at));
    if (minus)
        made.value = -made.value;
    *out = made;
    return BATTEN_OK;
}

batten_status bat_count_read(const char *text, int *out)
{
    int value = 0;
    if (!*text)
        return bat_fail(BATTEN_BAD_FORMAT, "a whole number is expected, not nothing");
    for (const char *c = text; *c; c++) {
        if (!bat_is_digit(*c))
            return bat_fail(BATTEN_BAD_FORMAT, "a whole number is expected, not \"%.40s\"",
                            text);
        if (value > (INT_MAX - (*c - '0')) / 10)
            return bat_fail(BATTEN_OVERFLOW, "the count %.40s is above the largest, %d", text,
                            INT_MAX);
        value = 10 * value + (*c - '0');
    }
    *out = value;
    return BATTEN_OK;
}
