/* Quantities as a design writes them: a number with a unit, or after '=' an expression over the
 * parameters, evaluated by Dijkstra's shunting yard without recursion. */
#include "design/text/literal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How deep parentheses, signs and functions may nest. */
#define MOST_PENDING 64

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
    bat_reader read;
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

bool bat_expression_has_word(const char *name, size_t length)
{
    return function_of(name, length) >= 0 || (length == 2 && memcmp(name, "pi", 2) == 0);
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
    *out = (bat_quantity){bat_pow(a->value, k), a->length * whole, a->angle * whole};
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
        *x = (bat_quantity){bat_sin(x->value), 0, 0};
        break;
    case COS:
        *x = (bat_quantity){bat_cos(x->value), 0, 0};
        break;
    case TAN:
        *x = (bat_quantity){bat_tan(x->value), 0, 0};
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
    return bat_fail(BATTEN_OVERFLOW, "the value of the expression is too large or undefined");
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
                        "a ',' is allowed only in min( ) and max( ); the decimal mark is '.'");
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
    const size_t length = bat_name_length(name);
    const int function = function_of(name, length);
    y->read.at += length;
    if (function >= 0) {
        y->read.at = bat_skip_blanks(y->read.at);
        if (*y->read.at != '(')
            return bat_fail(BATTEN_BAD_FORMAT, "'(' is expected after %s",
                            functions[function].name);
        y->read.at++;
        const batten_status status = push_pending(y, functions[function].operation);
        return status == BATTEN_OK ? push_pending(y, CALL_OPEN) : status;
    }
    *wants_value = false;
    if (bat_expression_has_word(name, length)) /* no function, so pi */
        return push_value(y, (bat_quantity){BAT_PI, 0, 0});
    const bat_names *names = y->read.names;
    const bat_quantity *found = names->find ? names->find(names->user, name, length) : NULL;
    return found ? push_value(y, *found) : unknown_name(names, name, length);
}

/* Where a value must come: a number, a name, a sign or '('. */
static batten_status take_operand(yard *y, bool *wants_value)
{
    const char c = *y->read.at;
    if (bat_begins_name(c))
        return take_name(y, wants_value);
    if (c == '(' || c == '-') {
        y->read.at++;
        return push_pending(y, c == '(' ? OPEN : NEGATE);
    }
    bat_quantity value;
    if (c == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "the expression ends where a value is expected");
    const batten_status status = bat_literal_read(&y->read, &value);
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
    for (y->read.at = bat_skip_blanks(y->read.at);
         status == BATTEN_OK && (*y->read.at || wants_value);
         y->read.at = bat_skip_blanks(y->read.at))
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

batten_status bat_quantity_read(const char *text, const bat_names *names, bool *vanished,
                                bat_quantity *out)
{
    yard y = {.read = {bat_skip_blanks(text), names, false, false}};
    batten_status status;
    if (*y.read.at == '=') {
        y.read.at++;
        y.read.in_expression = true;
        status = evaluate(&y, out);
    } else {
        status = bat_signed_read(&y.read, out);
    }
    if (status == BATTEN_OK && vanished)
        *vanished = y.read.vanished;
    return status;
}

bool bat_expression_next_name(const char *text, size_t *position, const char **name,
                              size_t *length)
{
    bool after_number = false;
    for (const char *at = text + *position; *at;) {
        const size_t letters = bat_name_length(at);
        const bool is_name = letters && !after_number && !bat_expression_has_word(at, letters);
        if (is_name) {
            *name = at;
            *length = letters;
            *position = (size_t)(at - text) + letters;
            return true;
        }
        if (letters)
            after_number = false;
        else if (bat_is_digit(*at) || *at == '.')
            after_number = true;
        else if (!bat_is_white(*at))
            after_number = false;
        at += letters ? letters : 1;
    }
    return false;
}
