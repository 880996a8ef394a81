/* Reads path data, transforms, colours and numbers. */
#include "exchange/svg/path_data.h"
#include "base/plural.h"
#include "exchange/reading/scan.h"

#include <batten/text.h>
#include <string.h>

size_t bat_svg_past_separators(bat_span text, size_t at)
{
    while (at < text.length && (bat_is_white(text.bytes[at]) || text.bytes[at] == ','))
        at++;
    return at;
}

/* How long the exponent at the beginning is; 0 when there is none. */
static size_t exponent_length(const char *text, size_t left)
{
    size_t k = 1;
    if (left < 2 || (text[0] != 'e' && text[0] != 'E'))
        return 0;
    k += text[1] == '+' || text[1] == '-';
    if (k >= left || text[k] < '0' || text[k] > '9')
        return 0;
    while (k < left && text[k] >= '0' && text[k] <= '9')
        k++;
    return k;
}

/* How long the number at the beginning is: numbers may stand side by side, "1.5.5-2". */
static size_t number_length(const char *text, size_t left)
{
    size_t i = 0, digits = 0;
    i += i < left && (text[i] == '+' || text[i] == '-');
    for (; i < left && text[i] >= '0' && text[i] <= '9'; i++)
        digits++;
    if (i < left && text[i] == '.')
        for (i++; i < left && text[i] >= '0' && text[i] <= '9'; i++)
            digits++;
    if (digits == 0)
        return 0;
    return i + exponent_length(text + i, left - i);
}

bool bat_svg_number(bat_span text, size_t *at, double *value)
{
    const size_t begin = bat_svg_past_separators(text, *at);
    const size_t length = number_length(text.bytes + begin, text.length - begin);
    if (length == 0 || batten_number_read(text.bytes + begin, length, value, NULL) != BATTEN_OK)
        return false;
    *at = begin + length;
    return true;
}

bool bat_svg_real(const bat_input *input, int line, bat_span text, size_t *at, double *value)
{
    const size_t begin = bat_svg_past_separators(text, *at);
    if (!bat_svg_number(text, at, value))
        return false;
    bat_input_vanished(input, line, "", (bat_span){text.bytes + begin, *at - begin}, *value);
    return true;
}

/* ---- transforms ---- */

static bat_svg_map turned(double angle)
{
    const double c = cos(angle * BAT_PI / 180), s = sin(angle * BAT_PI / 180);
    return (bat_svg_map){c, s, -s, c, 0, 0};
}

static bool skew_of(bat_span name, int count, const double v[6], bat_svg_map *map)
{
    if (name.length == 5 && memcmp(name.bytes, "skewX", 5) == 0)
        map->c = tan(v[0] * BAT_PI / 180);
    else if (name.length == 5 && memcmp(name.bytes, "skewY", 5) == 0)
        map->b = tan(v[0] * BAT_PI / 180);
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

/* ---- paths ---- */

typedef struct {
    bat_span data;
    size_t at;
    bat_svg_row *row;
    bat_svg_take *take;
    void *context;
    double start[2];      /* of the part at work */
    double reflect[2];    /* the control point whose mirror S and T begin with */
    char command, before; /* the one before, in capitals */
} parsing;

/* Flags of arcs may stand without anything between: "a1 1 0 0110 10". */
static bool read_flag(parsing *p, double *value)
{
    p->at = bat_svg_past_separators(p->data, p->at);
    if (p->at >= p->data.length || (p->data.bytes[p->at] != '0' && p->data.bytes[p->at] != '1'))
        return false;
    *value = p->data.bytes[p->at++] - '0';
    return true;
}

static int arguments_of(char command)
{
    static const char commands[] = "MLHVCSQTAZ";
    static const int counts[] = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};
    const char *found = strchr(commands, command);
    return found ? counts[found - commands] : -1;
}

static bool read_arguments(parsing *p, char command, double v[7])
{
    const int count = arguments_of(command);
    for (int k = 0; k < count; k++) {
        const bool is_flag = command == 'A' && (k == 3 || k == 4);
        if (!(is_flag ? read_flag(p, &v[k])
                      : bat_svg_real(p->row->input, p->row->line, p->data, &p->at, &v[k])))
            return false;
    }
    return true;
}

/* Small letters count from where the row stands. */
static void make_absolute(char command, const bat_svg_row *row, double v[7])
{
    if (command == 'H') {
        v[0] += row->x;
    } else if (command == 'V') {
        v[0] += row->y;
    } else {
        for (int k = command == 'A' ? 5 : 0; k + 1 < arguments_of(command); k += 2) {
            v[k] += row->x;
            v[k + 1] += row->y;
        }
    }
}

static batten_status hand_over_row(parsing *p)
{
    return p->row->points.count > 1 ? p->take(p->context, p->row) : BATTEN_OK;
}

/* Where S and T begin: the mirror of the last control point, when there was one of the kind. */
static void mirror(const parsing *p, const char *kinds, double point[2])
{
    const bool after = strchr(kinds, p->before) != NULL;
    point[0] = after ? 2 * p->row->x - p->reflect[0] : p->row->x;
    point[1] = after ? 2 * p->row->y - p->reflect[1] : p->row->y;
}

static batten_status put_cubic(parsing *p, char command, const double v[7])
{
    double one[2] = {v[0], v[1]};
    if (command == 'S')
        mirror(p, "CS", one);
    const double *rest = command == 'C' ? v + 2 : v;
    p->reflect[0] = rest[0];
    p->reflect[1] = rest[1];
    return bat_svg_cubic(p->row, one, rest, rest + 2);
}

static batten_status put_curve(parsing *p, char command, const double v[7])
{
    double one[2] = {v[0], v[1]};
    if (command == 'C' || command == 'S')
        return put_cubic(p, command, v);
    if (command == 'T')
        mirror(p, "QT", one);
    p->reflect[0] = one[0];
    p->reflect[1] = one[1];
    return bat_svg_quadratic(p->row, one, 1, command == 'Q' ? v + 2 : v);
}

static batten_status begin_row(parsing *p, double x, double y)
{
    const batten_status status = hand_over_row(p);
    p->start[0] = x;
    p->start[1] = y;
    return status == BATTEN_OK ? bat_svg_move(p->row, x, y) : status;
}

static batten_status run_command(parsing *p, char command, const double v[7])
{
    bat_svg_row *row = p->row;
    batten_status status = BATTEN_OK;
    switch (command) {
    case 'M':
        return begin_row(p, v[0], v[1]);
    case 'L':
        return bat_svg_line(row, v[0], v[1]);
    case 'H':
        return bat_svg_line(row, v[0], row->y);
    case 'V':
        return bat_svg_line(row, row->x, v[0]);
    case 'A':
        return bat_svg_arc(row, v[0], v[1], v[2], v[3] != 0, v[4] != 0, v[5], v[6]);
    case 'Z':
        status = bat_svg_line(row, p->start[0], p->start[1]);
        return status == BATTEN_OK ? begin_row(p, p->start[0], p->start[1]) : status;
    default:
        return put_curve(p, command, v);
    }
}

/* The command that stands here, where something does, or the one before again when numbers go
 * on: M then becomes L.
 */
static bool next_command(parsing *p)
{
    p->at = bat_svg_past_separators(p->data, p->at);
    const char c = p->data.bytes[p->at];
    if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
        p->command = c;
        p->at++;
        return true;
    }
    if (p->command == 'M' || p->command == 'm')
        p->command = p->command == 'M' ? 'L' : 'l';
    return p->command && p->command != 'Z' && p->command != 'z';
}

/* The rows before the fault stay. */
static batten_status end_broken(parsing *p, size_t at)
{
    const batten_status status = hand_over_row(p);
    return status == BATTEN_OK
               ? bat_fail(BATTEN_BAD_FORMAT, "the path is broken at its character %zu", at + 1)
               : status;
}

batten_status bat_svg_path(bat_span data, bat_svg_row *row, bat_svg_take *take, void *context)
{
    parsing p = {.data = data, .row = row, .take = take, .context = context};
    batten_status status = BATTEN_OK;
    row->points.count = 0;
    while (status == BATTEN_OK && bat_svg_past_separators(data, p.at) < data.length) {
        double v[7] = {0};
        const size_t at = p.at;
        const bool known = next_command(&p);
        const bool small = p.command >= 'a';
        const char command = small ? (char)(p.command - 'a' + 'A') : p.command;
        if (!known || arguments_of(command) < 0 || !read_arguments(&p, command, v) ||
            (row->points.count == 0 && command != 'M'))
            return end_broken(&p, at);
        if (small && row->points.count > 0)
            make_absolute(command, row, v);
        status = run_command(&p, command, v);
        p.before = command;
    }
    if (status != BATTEN_OK && status != BATTEN_BAD_FORMAT)
        return status;
    const batten_status handed =
        hand_over_row(&p); /* what stands before an arc that failed too */
    return handed == BATTEN_OK ? status : handed;
}
