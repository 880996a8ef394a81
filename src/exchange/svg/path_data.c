/* Reads path data and numbers. */
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

static size_t count_digits(const char *text, size_t left)
{
    size_t count = 0;
    while (count < left && text[count] >= '0' && text[count] <= '9')
        count++;
    return count;
}

/* The length of the exponent at the start of a text; 0 without an exponent. */
static size_t exponent_length(const char *text, size_t left)
{
    size_t k = 1;
    if (left < 2 || (text[0] != 'e' && text[0] != 'E'))
        return 0;
    k += text[1] == '+' || text[1] == '-';
    const size_t digits = count_digits(text + k, left - k);
    return digits ? k + digits : 0;
}

/* How long the number at the beginning is: numbers may stand side by side, "1.5.5-2". */
static size_t number_length(const char *text, size_t left)
{
    size_t i = left > 0 && (text[0] == '+' || text[0] == '-');
    size_t digits = count_digits(text + i, left - i);
    i += digits;
    if (i < left && text[i] == '.') {
        const size_t behind = count_digits(text + i + 1, left - i - 1);
        i += 1 + behind;
        digits += behind;
    }
    return digits ? i + exponent_length(text + i, left - i) : 0;
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
    if (command == 'H')
        v[0] += row->x;
    else if (command == 'V')
        v[0] += row->y;
    else
        for (int k = command == 'A' ? 5 : 0; k + 1 < arguments_of(command); k += 2) {
            v[k] += row->x;
            v[k + 1] += row->y;
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
