#include "design/text/value.h"

#include <batten/model.h>
#include <batten/text.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How deep parentheses, signs and functions may nest. */
#define MOST_PENDING 64

/* ---- characters, the same in every locale ---- */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool begins_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static size_t name_length(const char *text)
{
    size_t length = 0;
    if (begins_name(*text))
        while (begins_name(text[length]) || is_digit(text[length]))
            length++;
    return length;
}

static const char *skip_blanks(const char *at)
{
    while (is_blank(*at))
        at++;
    return at;
}

/* ---- literals: numbers with units ---- */

typedef struct {
    const char *at;
    const bat_names *names;
    bool vanished;
    bool in_expression; /* '-' is an operator */
} reader;

static batten_status read_number(reader *r, double *value)
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
static batten_status read_fraction(reader *r, double *value)
{
    const char *at = skip_blanks(r->at);
    const char *digit = at;
    while (is_digit(*digit))
        digit++;
    if (at == r->at || digit == at || *digit != '/' || !is_digit(digit[1]))
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
    at = skip_blanks(at);
    if (*at == '\'' || *at == '"') {
        strcpy(name, *at == '\'' ? "ft" : "in");
        return at + 1;
    }
    const size_t length = name_length(at);
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
static batten_status read_inches(reader *r, double *value)
{
    const char *at = skip_blanks(r->at);
    if (*at == '-' && at == r->at && !r->in_expression) /* 5'-6" */
        at++;
    if (!is_digit(*at) && *at != '.')
        return BATTEN_OK;
    reader ahead = {at, r->names, false, r->in_expression};
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

static batten_status read_literal(reader *r, bat_quantity *out)
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
                            "'%s' is no unit; known are m mm cm km um in ft mil mi deg rad",
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

static batten_status not_same(const char *what, const bat_quantity *a, const bat_quantity *b)
{
    char first[48], second[48];
    return bat_fail(BATTEN_BAD_FORMAT, "%s needs two of a kind, not %s and %s", what,
                    bat_dimension_name(a->length, a->angle, first),
                    bat_dimension_name(b->length, b->angle, second));
}

static bool same_dimension(const bat_quantity *a, const bat_quantity *b)
{
    return a->length == b->length && a->angle == b->angle;
}

/* ---- operators and functions ---- */

typedef enum {
    ADD,
    SUBTRACT,
    MULTIPLY,
    DIVIDE,
    POWER,
    NEGATE,
    OPEN,
    CALL_OPEN,
    COMMA,
    SIN,
    COS,
    TAN,
    SQRT,
    ABS,
    MIN,
    MAX
} operation;

/* Values and operations that wait: Dijkstra's shunting yard. */
typedef struct {
    reader read;
    bat_quantity values[MOST_PENDING];
    operation pending[MOST_PENDING];
    int commas[MOST_PENDING]; /* of the call that waits at the same place */
    int value_count, pending_count;
} yard;

static const struct {
    const char *name;
    operation operation;
    int arguments; /* 0: two or more */
} functions[] = {{"sin", SIN, 1}, {"cos", COS, 1}, {"tan", TAN, 1}, {"sqrt", SQRT, 1},
                 {"abs", ABS, 1}, {"min", MIN, 0}, {"max", MAX, 0}};

static int function_of(const char *name, size_t length)
{
    for (int i = 0; i < (int)(sizeof functions / sizeof functions[0]); i++)
        if (strlen(functions[i].name) == length && memcmp(functions[i].name, name, length) == 0)
            return i;
    return -1;
}

static int precedence(operation op)
{
    switch (op) {
    case ADD:
    case SUBTRACT:
        return 1;
    case MULTIPLY:
    case DIVIDE:
        return 2;
    case NEGATE:
        return 3;
    case POWER:
        return 4;
    default:
        return 0;
    }
}

static batten_status raise_to(const bat_quantity *a, const bat_quantity *b, bat_quantity *out)
{
    const double k = b->value;
    if (b->length || b->angle)
        return bat_fail(BATTEN_BAD_FORMAT, "an exponent must be a number without a unit");
    if ((a->length || a->angle) && (k != floor(k) || fabs(k) > 9))
        return bat_fail(BATTEN_BAD_FORMAT,
                        "a length or angle can be raised to whole numbers up to 9, not to %g",
                        k);
    const int whole = a->length || a->angle ? (int)k : 0;
    *out = (bat_quantity){pow(a->value, k), a->length * whole, a->angle * whole};
    return BATTEN_OK;
}

static batten_status combine(operation op, const bat_quantity *a, const bat_quantity *b,
                             bat_quantity *out)
{
    switch (op) {
    case ADD:
    case SUBTRACT:
        if (!same_dimension(a, b))
            return not_same(op == ADD ? "'+'" : "'-'", a, b);
        *out = (bat_quantity){op == ADD ? a->value + b->value : a->value - b->value, a->length,
                              a->angle};
        return BATTEN_OK;
    case MULTIPLY:
        *out = (bat_quantity){a->value * b->value, a->length + b->length, a->angle + b->angle};
        return BATTEN_OK;
    case DIVIDE:
        if (b->value == 0)
            return bat_fail(BATTEN_BAD_FORMAT, "%g is divided by 0", a->value);
        *out = (bat_quantity){a->value / b->value, a->length - b->length, a->angle - b->angle};
        return BATTEN_OK;
    default:
        return raise_to(a, b, out);
    }
}

static batten_status apply_function(int which, bat_quantity *x)
{
    const char *name = functions[which].name;
    const operation op = functions[which].operation;
    char text[48];
    if ((op == SIN || op == COS || op == TAN) && (x->angle != 1 || x->length != 0))
        return bat_fail(BATTEN_BAD_FORMAT, "%s needs an angle (30 deg, 0.5 rad), not %s", name,
                        bat_dimension_name(x->length, x->angle, text));
    if (op == SQRT && (x->length % 2 || x->angle % 2))
        return bat_fail(BATTEN_BAD_FORMAT, "sqrt of %s has no unit",
                        bat_dimension_name(x->length, x->angle, text));
    if (op == SQRT && x->value < 0)
        return bat_fail(BATTEN_BAD_FORMAT, "sqrt of %g is not a number", x->value);
    switch (op) {
    case SIN:
        *x = (bat_quantity){sin(x->value), 0, 0};
        break;
    case COS:
        *x = (bat_quantity){cos(x->value), 0, 0};
        break;
    case TAN:
        *x = (bat_quantity){tan(x->value), 0, 0};
        break;
    case SQRT:
        *x = (bat_quantity){sqrt(x->value), x->length / 2, x->angle / 2};
        break;
    default:
        x->value = fabs(x->value);
    }
    return BATTEN_OK;
}

static batten_status check_finite(const bat_quantity *made)
{
    if (isfinite(made->value))
        return BATTEN_OK;
    return bat_fail(BATTEN_OVERFLOW, "the expression becomes too large or is no number");
}

/* Carry out the last operation that waits; its values are there. */
static batten_status carry_out(yard *y)
{
    const operation op = y->pending[--y->pending_count];
    bat_quantity *top = &y->values[y->value_count - 1];
    if (op == NEGATE) {
        top->value = -top->value;
        return BATTEN_OK;
    }
    bat_quantity made = {0, 0, 0};
    batten_status status = combine(op, top - 1, top, &made);
    if (status == BATTEN_OK)
        status = check_finite(&made);
    top[-1] = made;
    y->value_count--;
    return status;
}

static batten_status carry_out_above(yard *y, int floor)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && y->pending_count > 0 &&
           precedence(y->pending[y->pending_count - 1]) >= floor)
        status = carry_out(y);
    return status;
}

static batten_status too_deep(void)
{
    return bat_fail(BATTEN_TOO_LARGE, "the expression nests deeper than the limit, %d",
                    MOST_PENDING);
}

static batten_status push_pending(yard *y, operation op)
{
    if (y->pending_count == MOST_PENDING)
        return too_deep();
    y->commas[y->pending_count] = 0;
    y->pending[y->pending_count++] = op;
    return BATTEN_OK;
}

static batten_status push_value(yard *y, bat_quantity value)
{
    if (y->value_count == MOST_PENDING)
        return too_deep();
    y->values[y->value_count++] = value;
    return BATTEN_OK;
}

/* min and max of `count` values; the others have one. */
static batten_status call(yard *y, operation op, int count)
{
    int which = 0;
    while (functions[which].operation != op)
        which++;
    if (functions[which].arguments ? count != 1 : count < 2)
        return bat_fail(BATTEN_BAD_FORMAT, "%s takes %s, not %d", functions[which].name,
                        functions[which].arguments ? "one value" : "two values or more", count);
    bat_quantity *values = &y->values[y->value_count - count];
    batten_status status = BATTEN_OK;
    for (int i = 1; i < count && status == BATTEN_OK; i++) {
        if (!same_dimension(&values[0], &values[i]))
            status = not_same(functions[which].name, &values[0], &values[i]);
        else if (op == MIN ? values[i].value < values[0].value
                           : values[i].value > values[0].value)
            values[0] = values[i];
    }
    y->value_count -= count - 1;
    if (status == BATTEN_OK && count == 1)
        status = apply_function(which, &values[0]);
    return status == BATTEN_OK ? check_finite(&values[0]) : status;
}

static batten_status close_parenthesis(yard *y)
{
    batten_status status = carry_out_above(y, 1);
    if (status != BATTEN_OK)
        return status;
    if (y->pending_count == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "a ')' has no '('");
    const int commas = y->commas[--y->pending_count];
    if (y->pending[y->pending_count] == OPEN)
        return BATTEN_OK;
    return call(y, y->pending[--y->pending_count], commas + 1);
}

static batten_status take_comma(yard *y)
{
    const batten_status status = carry_out_above(y, 1);
    if (status != BATTEN_OK)
        return status;
    if (y->pending_count == 0 || y->pending[y->pending_count - 1] != CALL_OPEN)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "a ',' stands outside of min( ) and max( ); the decimal mark is '.'");
    y->commas[y->pending_count - 1]++;
    return BATTEN_OK;
}

/* ---- an expression, token by token ---- */

static batten_status unknown_name(const bat_names *names, const char *name, size_t length)
{
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)bat_min_int((int)length, 60), name);
    const char *near = names->nearest ? names->nearest(names->user, word) : NULL;
    return bat_fail(BATTEN_BAD_FORMAT, "no parameter is named '%s'%s%s%s", word,
                    near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

static batten_status take_name(yard *y, bool *wants_value)
{
    const char *name = y->read.at;
    const size_t length = name_length(name);
    const int function = function_of(name, length);
    y->read.at += length;
    if (function >= 0) {
        y->read.at = skip_blanks(y->read.at);
        if (*y->read.at != '(')
            return bat_fail(BATTEN_BAD_FORMAT, "'(' is expected after %s",
                            functions[function].name);
        y->read.at++;
        const batten_status status = push_pending(y, functions[function].operation);
        return status == BATTEN_OK ? push_pending(y, CALL_OPEN) : status;
    }
    *wants_value = false;
    if (length == 2 && memcmp(name, "pi", 2) == 0)
        return push_value(y, (bat_quantity){BAT_PI, 0, 0});
    const bat_names *names = y->read.names;
    const bat_quantity *found = names->find ? names->find(names->user, name, length) : NULL;
    return found ? push_value(y, *found) : unknown_name(names, name, length);
}

/* Where a value must come: a number, a name, a sign or '('. */
static batten_status take_operand(yard *y, bool *wants_value)
{
    const char c = *y->read.at;
    if (begins_name(c))
        return take_name(y, wants_value);
    if (c == '(' || c == '-') {
        y->read.at++;
        return push_pending(y, c == '(' ? OPEN : NEGATE);
    }
    bat_quantity value;
    if (c == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "the expression ends where a value is expected");
    const batten_status status = read_literal(&y->read, &value);
    *wants_value = false;
    return status == BATTEN_OK ? push_value(y, value) : status;
}

/* After a value: an operator, ',' or ')'. */
static batten_status take_operator(yard *y, bool *wants_value)
{
    static const char signs[] = "+-*/^";
    const char c = *y->read.at;
    const char *sign = strchr(signs, c);
    if (c != ')' && c != ',' && !sign)
        return bat_fail(BATTEN_BAD_FORMAT, "an operator is expected at \"%.40s\"", y->read.at);
    y->read.at++;
    *wants_value = c != ')';
    if (c == ')')
        return close_parenthesis(y);
    if (c == ',')
        return take_comma(y);
    const operation op = (operation)(sign - signs);
    /* a^b^c is a^(b^c); the others work from the left. */
    const batten_status status = carry_out_above(y, precedence(op) + (op == POWER));
    return status == BATTEN_OK ? push_pending(y, op) : status;
}

static batten_status evaluate(yard *y, bat_quantity *out)
{
    bool wants_value = true;
    batten_status status = BATTEN_OK;
    for (y->read.at = skip_blanks(y->read.at);
         status == BATTEN_OK && (*y->read.at || wants_value);
         y->read.at = skip_blanks(y->read.at))
        status = wants_value ? take_operand(y, &wants_value) : take_operator(y, &wants_value);
    if (status == BATTEN_OK)
        status = carry_out_above(y, 1);
    if (status == BATTEN_OK && y->pending_count > 0)
        status = bat_fail(BATTEN_BAD_FORMAT,
                          "a '(' is not closed; put an expression with commas in quotes");
    if (status == BATTEN_OK)
        *out = y->values[0];
    return status;
}

static batten_status read_signed(reader *r, bat_quantity *out)
{
    const char *begin = r->at;
    const bool minus = *r->at == '-';
    if (*r->at == '-' || *r->at == '+')
        r->at++;
    bat_quantity made;
    const batten_status status = read_literal(r, &made);
    if (status != BATTEN_OK)
        return status;
    if (*skip_blanks(r->at))
        return bat_fail(BATTEN_BAD_FORMAT, "\"%.60s\" is no number: \"%.40s\" is left over",
                        begin, skip_blanks(r->at));
    if (minus)
        made.value = -made.value;
    *out = made;
    return BATTEN_OK;
}

batten_status bat_quantity_read(const char *text, const bat_names *names, bool *vanished,
                                bat_quantity *out)
{
    yard y = {.read = {skip_blanks(text), names, false, false}};
    batten_status status;
    if (*y.read.at == '=') {
        y.read.at++;
        y.read.in_expression = true;
        status = evaluate(&y, out);
    } else {
        status = read_signed(&y.read, out);
    }
    if (status == BATTEN_OK && vanished)
        *vanished = y.read.vanished;
    return status;
}

batten_status bat_count_read(const char *text, int *out)
{
    int value = 0;
    if (!*text)
        return bat_fail(BATTEN_BAD_FORMAT, "a whole number is expected, not nothing");
    for (const char *c = text; *c; c++) {
        if (!is_digit(*c))
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

bool bat_expression_next_name(const char *text, size_t *position, const char **name,
                              size_t *length)
{
    bool after_number = false;
    for (const char *at = text + *position; *at;) {
        const size_t letters = name_length(at);
        const bool is_name = letters && !after_number && function_of(at, letters) < 0 &&
                             !(letters == 2 && memcmp(at, "pi", 2) == 0);
        if (is_name) {
            *name = at;
            *length = letters;
            *position = (size_t)(at - text) + letters;
            return true;
        }
        if (letters)
            after_number = false;
        else if (is_digit(*at) || *at == '.')
            after_number = true;
        else if (!is_blank(*at))
            after_number = false;
        at += letters ? letters : 1;
    }
    return false;
}

/* ---- near names ---- */

#define LONGEST_NAME 48

int bat_edit_distance(const char *a, const char *b, int limit)
{
    const int m = (int)strlen(a), n = (int)strlen(b);
    if (m > LONGEST_NAME || n > LONGEST_NAME || abs(m - n) >= limit)
        return limit;
    int rows[3][LONGEST_NAME + 1];
    for (int j = 0; j <= n; j++)
        rows[0][j] = j;
    for (int i = 1; i <= m; i++) {
        int *row = rows[i % 3];
        const int *above = rows[(i + 2) % 3], *before = rows[(i + 1) % 3];
        row[0] = i;
        for (int j = 1; j <= n; j++) {
            row[j] = bat_min_int(above[j], row[j - 1]) + 1;
            row[j] = bat_min_int(row[j], above[j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = bat_min_int(row[j], before[j - 2] + 1);
        }
    }
    return bat_min_int(rows[m % 3][n], limit);
}

bool bat_is_nearer(const char *word, const char *a, int *best)
{
    /* A third of the letters may be wrong, and never all of them. */
    const int letters = (int)strlen(word);
    const int allowed = bat_min_int(letters - 1, bat_max_int(1, letters / 3));
    const int distance = bat_edit_distance(word, a, bat_min_int(*best, allowed + 1));
    if (distance > allowed || distance >= *best)
        return false;
    *best = distance;
    return true;
}
