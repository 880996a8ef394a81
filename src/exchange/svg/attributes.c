/* Reads transforms and colours, as attributes give them. */
#include "exchange/svg/attributes.h"
#include "base/plural.h"
#include "exchange/reading/scan.h"
#include "exchange/svg/path_data.h"

#include <string.h>

static bat_svg_map turned(double angle)
{
    const double c = bat_cos(angle * BAT_PI / 180), s = bat_sin(angle * BAT_PI / 180);
    return (bat_svg_map){c, s, -s, c, 0, 0};
}

static bool skew_of(bat_span name, int count, const double v[6], bat_svg_map *map)
{
    if (name.length == 5 && memcmp(name.bytes, "skewX", 5) == 0)
        map->c = bat_tan(v[0] * BAT_PI / 180);
    else if (name.length == 5 && memcmp(name.bytes, "skewY", 5) == 0)
        map->b = bat_tan(v[0] * BAT_PI / 180);
    else
        return false;
    return count == 1;
}

/* One step of a transform with its numbers; false when they are too few. */
static bool step_of(bat_span name, int count, const double v[6], bat_svg_map *map)
{
    const bat_svg_map one = {1, 0, 0, 1, 0, 0};
    *map = one;
    if (name.length == 6 && memcmp(name.bytes, "matrix", 6) == 0) {
        *map = (bat_svg_map){v[0], v[1], v[2], v[3], v[4], v[5]};
        return count == 6;
    }
    if (name.length == 9 && memcmp(name.bytes, "translate", 9) == 0) {
        map->e = v[0];
        map->f = v[1];
        return count == 1 || count == 2;
    }
    if (name.length == 5 && memcmp(name.bytes, "scale", 5) == 0) {
        map->a = v[0];
        map->d = count == 2 ? v[1] : v[0];
        return count == 1 || count == 2;
    }
    if (name.length == 6 && memcmp(name.bytes, "rotate", 6) == 0) {
        const bat_svg_map there = {1, 0, 0, 1, -v[1], -v[2]}, back = {1, 0, 0, 1, v[1], v[2]};
        *map = bat_svg_compose(bat_svg_compose(there, turned(v[0])), back);
        return count == 1 || count == 3;
    }
    return skew_of(name, count, v, map);
}

/* In styles numbers have the units that are those of numbers alone. */
static size_t past_plain_unit(bat_span text, size_t at)
{
    static const char *const units[] = {"px", "deg"};
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
        const size_t length = strlen(units[k]);
        if (text.length - at >= length && memcmp(text.bytes + at, units[k], length) == 0)
            return at + length;
    }
    return at;
}

/* The numbers between the brackets; at most 6. */
static int read_numbers(const bat_input *input, int line, bat_span text, size_t *at,
                        double v[6])
{
    int count = 0;
    while (count < 6 && bat_svg_real(input, line, text, at, &v[count])) {
        *at = past_plain_unit(text, *at);
        count++;
    }
    *at = bat_svg_past_separators(text, *at);
    return count;
}

/* Up to the bracket that opens, which is passed. */
static bat_span read_name(bat_span text, size_t *at)
{
    const size_t begin = *at;
    while (*at < text.length && text.bytes[*at] != '(' && !bat_is_white(text.bytes[*at]))
        ++*at;
    const bat_span name = {text.bytes + begin, *at - begin};
    while (*at < text.length && bat_is_white(text.bytes[*at]))
        ++*at;
    *at += *at < text.length;
    return name;
}

static batten_status read_step(const bat_input *input, int line, bat_span text, size_t *at,
                               bat_svg_map *step)
{
    double v[6] = {0};
    const bat_span name = read_name(text, at);
    const int count = read_numbers(input, line, text, at, v);
    if (*at >= text.length || text.bytes[*at] != ')' || !step_of(name, count, v, step))
        return bat_fail(BATTEN_BAD_FORMAT, "the transform has '%.*s' with %d number%s",
                        (int)(name.length < 20 ? name.length : 20), name.bytes, count,
                        bat_plural(count));
    *at = bat_svg_past_separators(text, *at + 1);
    return BATTEN_OK;
}

batten_status bat_svg_transform(const bat_input *input, int line, bat_span text,
                                bat_svg_map *map)
{
    bat_svg_map whole = {1, 0, 0, 1, 0, 0}, step;
    size_t at = bat_svg_past_separators(text, 0);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && at < text.length) {
        status = read_step(input, line, text, &at, &step);
        if (status == BATTEN_OK)
            whole = bat_svg_compose(step, whole); /* the last one acts first */
    }
    if (status == BATTEN_OK)
        *map = whole;
    return status;
}

/* ---- colours ---- */

static bool hex_colour(bat_span text, double rgb[3])
{
    const size_t each = text.length == 7 ? 2 : 1;
    if (text.length != 4 && text.length != 7)
        return false;
    for (size_t k = 0; k < 3; k++) {
        const int high = bat_hex_digit(text.bytes[1 + k * each]);
        const int low = bat_hex_digit(text.bytes[k * each + each]);
        if (high < 0 || low < 0)
            return false;
        rgb[k] = (16 * high + low) / 255.0;
    }
    return true;
}

static const struct {
    const char *name;
    double rgb[3];
} named_colours[] = {{"black", {0, 0, 0}},
                     {"white", {1, 1, 1}},
                     {"red", {1, 0, 0}},
                     {"lime", {0, 1, 0}},
                     {"blue", {0, 0, 1}},
                     {"yellow", {1, 1, 0}},
                     {"cyan", {0, 1, 1}},
                     {"magenta", {1, 0, 1}},
                     {"green", {0, 128 / 255.0, 0}},
                     {"grey", {128 / 255.0, 128 / 255.0, 128 / 255.0}}};

static bool named_colour(bat_span text, double rgb[3])
{
    for (size_t k = 0; k < sizeof named_colours / sizeof named_colours[0]; k++)
        if (bat_word_is(text, named_colours[k].name)) {
            memcpy(rgb, named_colours[k].rgb, sizeof named_colours[k].rgb);
            return true;
        }
    return false;
}

/* A number up to 255, or a percentage, as a part of 1. */
static bool read_share(bat_span text, size_t *at, double *share)
{
    double value = 0;
    if (!bat_svg_number(text, at, &value))
        return false;
    const bool percent = *at < text.length && text.bytes[*at] == '%';
    *at += percent;
    *share = bat_max(0, bat_min(1, value / (percent ? 100 : 255)));
    return true;
}

static bool mixed_colour(bat_span text, double rgb[3])
{
    size_t at = 4;
    if (text.length < 5 || memcmp(text.bytes, "rgb(", 4) != 0)
        return false;
    for (int k = 0; k < 3; k++)
        if (!read_share(text, &at, &rgb[k]))
            return false;
    return true;
}

static bat_span trimmed(bat_span text)
{
    while (text.length > 0 && bat_is_white(text.bytes[0])) {
        text.bytes++;
        text.length--;
    }
    while (text.length > 0 && bat_is_white(text.bytes[text.length - 1]))
        text.length--;
    return text;
}

bool bat_svg_colour(bat_span text, double rgb[3])
{
    text = trimmed(text);
    if (text.length > 0 && text.bytes[0] == '#')
        return hex_colour(text, rgb);
    return named_colour(text, rgb) || mixed_colour(text, rgb);
}
