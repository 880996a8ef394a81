/* Expressions read from a text, by Dijkstra's shunting yard. */
#include "base/list.h"
#include "shape/equation/program.h"

#include <batten/text.h>
#include <string.h>

/* What waits beside operations: parentheses. */
enum { OPEN = BAT_DO_FUNCTION + 1, CALL };

typedef struct {
    int operation; /* bat_equation_operation, OPEN or CALL */
    int which;
    int commas; /* of a call */
} pending;

typedef struct {
    const char *text, *at;
    const batten_equation_names *names;
    batten_equation *made;
    pending waits[BAT_EQUATION_DEPTH];
    int wait_count, value_count;
    bool has_equal;
} reader;

static const struct {
    const char *name;
    bat_equation_operation operation;
    int which, arguments;
} functions[] = {
    {"sin", BAT_DO_FUNCTION, BAT_IJET_SIN, 1},
    {"cos", BAT_DO_FUNCTION, BAT_IJET_COS, 1},
    {"tan", BAT_DO_FUNCTION, BAT_IJET_TAN, 1},
    {"asin", BAT_DO_FUNCTION, BAT_IJET_ASIN, 1},
    {"acos", BAT_DO_FUNCTION, BAT_IJET_ACOS, 1},
    {"atan", BAT_DO_FUNCTION, BAT_IJET_ATAN, 1},
    {"sinh", BAT_DO_FUNCTION, BAT_IJET_SINH, 1},
    {"cosh", BAT_DO_FUNCTION, BAT_IJET_COSH, 1},
    {"tanh", BAT_DO_FUNCTION, BAT_IJET_TANH, 1},
    {"exp", BAT_DO_FUNCTION, BAT_IJET_EXP, 1},
    {"ln", BAT_DO_FUNCTION, BAT_IJET_LN, 1},
    {"log10", BAT_DO_FUNCTION, BAT_IJET_LOG10, 1},
    {"sqrt", BAT_DO_FUNCTION, BAT_IJET_SQRT, 1},
    {"abs", BAT_DO_FUNCTION, BAT_IJET_ABS, 1},
    {"min", BAT_DO_LEAST, 0, 2},
    {"max", BAT_DO_GREATEST, 0, 2},
};
enum { FUNCTION_COUNT = sizeof functions / sizeof functions[0] };

/* ---- characters ---- */

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static void skip_blanks(reader *r)
{
    r->at += strspn(r->at, " \t\r\n");
}

static size_t name_length(const char *at)
{
    size_t length = 0;
    while (is_letter(at[length]) || (length && is_digit(at[length])))
        length++;
    return length;
}

static bool is_name(const char *name, const char *at, size_t length)
{
    return strlen(name) == length && memcmp(name, at, length) == 0;
}

/* ---- steps ---- */

static batten_status too_deep(void)
{
    return bat_fail(BATTEN_TOO_LARGE, "the expression nests deeper than the limit, %d",
                    BAT_EQUATION_DEPTH);
}

static batten_status add_step(reader *r, bat_equation_step step)
{
    batten_equation *made = r->made;
    if (made->count == BAT_EQUATION_LENGTH)
        return bat_fail(BATTEN_TOO_LARGE, "the expression has more than %d operations",
                        BAT_EQUATION_LENGTH);
    return BAT_LIST_ADD(made->steps, made->count, made->room, step);
}

static batten_status add_value(reader *r, bat_equation_step step)
{
    if (r->value_count == BAT_EQUATION_DEPTH)
        return too_deep();
    r->value_count++;
    return add_step(r, step);
}

/* Carry out the last that waits. Constants are joined at once, as doubles. */
static batten_status carry_out(reader *r)
{
    const pending last = r->waits[--r->wait_count];
    batten_equation *made = r->made;
    bat_equation_step *top = made->count ? &made->steps[made->count - 1] : NULL;
    const bool is_single = last.operation == BAT_DO_NEGATE || last.operation == BAT_DO_FUNCTION;
    if (last.operation == BAT_DO_NEGATE && top->operation == BAT_DO_CONSTANT) {
        top->constant = -top->constant;
        return BATTEN_OK;
    }
    if (!is_single)
        r->value_count--;
    /* 1 / 3 as an exponent is a number. */
    if (last.operation == BAT_DO_DIVIDE && top->operation == BAT_DO_CONSTANT &&
        top[-1].operation == BAT_DO_CONSTANT && top->constant != 0) {
        top[-1].constant /= top->constant;
        made->count--;
        return BATTEN_OK;
    }
    return add_step(r,
                    (bat_equation_step){(bat_equation_operation)last.operation, last.which, 0});
}

static int precedence(int operation)
{
    switch (operation) {
    case BAT_DO_ADD:
    case BAT_DO_SUBTRACT:
        return 1;
    case BAT_DO_MULTIPLY:
    case BAT_DO_DIVIDE:
        return 2;
    case BAT_DO_NEGATE:
        return 3;
    case BAT_DO_POWER:
        return 4;
    default:
        return 0;
    }
}

static batten_status carry_out_above(reader *r, int floor)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && r->wait_count > 0 &&
           precedence(r->waits[r->wait_count - 1].operation) >= floor)
        status = carry_out(r);
    return status;
}

static batten_status push(reader *r, int operation, int which)
{
    if (r->wait_count == BAT_EQUATION_DEPTH)
        return too_deep();
    r->waits[r->wait_count++] = (pending){operation, which, 0};
    return BATTEN_OK;
}

/* ---- where a value is expected ---- */

static batten_status take_function(reader *r, int which, size_t length)
{
    r->at += length;
    skip_blanks(r);
    if (*r->at != '(')
        return bat_fail(BATTEN_BAD_FORMAT, "'(' is expected after %s", functions[which].name);
    r->at++;
    return push(r, CALL, which);
}

static batten_status unknown_name(const reader *r, size_t length)
{
    batten_text known = BATTEN_TEXT;
    for (int i = 0; i < r->names->variable_count; i++)
        batten_text_add(&known, "%s%s", i ? ", " : "", r->names->variables[i]);
    for (int i = 0; i < r->names->constant_count && i < 8; i++)
        batten_text_add(&known, ", %s", r->names->constants[i].name);
    const bool is_log = is_name("log", r->at, length);
    const batten_status status = bat_fail(
        BATTEN_BAD_FORMAT, "nothing is named '%.*s'%s; the variable%s: %s",
        length > 60 ? 60 : (int)length, r->at, is_log ? ": write ln (natural) or log10" : "",
        r->names->variable_count + r->names->constant_count > 1 ? "s and numbers are" : " is",
        known.failed || !known.bytes ? "" : known.bytes);
    batten_text_free(&known);
    return status;
}

static batten_status take_name(reader *r, bool *wants_value)
{
    const size_t length = name_length(r->at);
    const batten_equation_names *names = r->names;
    for (int i = 0; i < FUNCTION_COUNT; i++)
        if (is_name(functions[i].name, r->at, length))
            return take_function(r, i, length);
    bat_equation_step step = {BAT_DO_CONSTANT, -1, BAT_PI};
    for (int i = 0; i < names->constant_count && step.which < 0; i++)
        if (is_name(names->constants[i].name, r->at, length))
            step = (bat_equation_step){BAT_DO_CONSTANT, 0, names->constants[i].value};
    for (int i = 0; i < names->variable_count; i++)
        if (is_name(names->variables[i], r->at, length))
            step = (bat_equation_step){BAT_DO_VARIABLE, i, 0};
    if (step.which < 0 && !is_name("pi", r->at, length))
        return unknown_name(r, length);
    if (!isfinite(step.constant))
        return bat_fail(BATTEN_NOT_FINITE, "%.*s is not finite", (int)length, r->at);
    r->at += length;
    *wants_value = false;
    return add_value(r, step);
}

static batten_status take_number(reader *r, bool *wants_value)
{
    double value = 0;
    size_t used = 0;
    const batten_status status = batten_number_read(r->at, strlen(r->at), &value, &used);
    if (status != BATTEN_OK)
        return status == BATTEN_OVERFLOW
                   ? status
                   : bat_fail(BATTEN_BAD_FORMAT, "a number or a name is expected at \"%.40s\"",
                              r->at);
    r->at += used;
    *wants_value = false;
    return add_value(r, (bat_equation_step){BAT_DO_CONSTANT, 0, value});
}

static batten_status take_value(reader *r, bool *wants_value)
{
    const char c = *r->at;
    if (c == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "the expression ends where a value is expected");
    if (is_letter(c))
        return take_name(r, wants_value);
    if (is_digit(c) || c == '.')
        return take_number(r, wants_value);
    if (c != '(' && c != '-' && c != '+')
        return bat_fail(BATTEN_BAD_FORMAT, "a number or a name is expected at \"%.40s\"",
                        r->at);
    r->at++;
    return c == '+' ? BATTEN_OK : push(r, c == '(' ? OPEN : BAT_DO_NEGATE, 0);
}

/* ---- after a value ---- */

static batten_status close_parenthesis(reader *r)
{
    batten_status status = carry_out_above(r, 1);
    if (status != BATTEN_OK)
        return status;
    if (r->wait_count == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "a ')' has no '('");
    const pending last = r->waits[--r->wait_count];
    if (last.operation == OPEN)
        return BATTEN_OK;
    const int which = last.which;
    if (last.commas + 1 != functions[which].arguments)
        return bat_fail(BATTEN_BAD_FORMAT, "%s takes %d value%s, not %d", functions[which].name,
                        functions[which].arguments, functions[which].arguments > 1 ? "s" : "",
                        last.commas + 1);
    status = push(r, (int)functions[which].operation, functions[which].which);
    return status == BATTEN_OK ? carry_out(r) : status;
}

static batten_status take_comma(reader *r)
{
    const batten_status status = carry_out_above(r, 1);
    if (status != BATTEN_OK)
        return status;
    if (r->wait_count == 0 || r->waits[r->wait_count - 1].operation != CALL)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "a ',' is allowed only in min( ) and max( ); the decimal mark is '.'");
    r->waits[r->wait_count - 1].commas++;
    return BATTEN_OK;
}

/* F = G is F - (G): the minus waits below a parenthesis that the end of the text closes. */
static batten_status take_equal(reader *r)
{
    batten_status status = carry_out_above(r, 1);
    if (status == BATTEN_OK && (r->wait_count > 0 || r->has_equal))
        status = bat_fail(BATTEN_BAD_FORMAT, r->has_equal ? "there is more than one '='"
                                                          : "a '(' is not closed before '='");
    r->has_equal = true;
    if (status == BATTEN_OK)
        status = push(r, BAT_DO_SUBTRACT, 0);
    return status == BATTEN_OK ? push(r, OPEN, 0) : status;
}

static batten_status take_operator(reader *r, bool *wants_value)
{
    static const char signs[] = "+-*/^";
    const char c = *r->at;
    const char *sign = strchr(signs, c);
    if (c != ')' && c != ',' && c != '=' && !sign)
        return bat_fail(BATTEN_BAD_FORMAT, "an operator (+ - * / ^) is expected at \"%.40s\"",
                        r->at);
    r->at++;
    *wants_value = c != ')';
    if (c == ')')
        return close_parenthesis(r);
    if (c == ',')
        return take_comma(r);
    if (c == '=')
        return take_equal(r);
    const int operation = BAT_DO_ADD + (int)(sign - signs);
    const batten_status status =
        carry_out_above(r, precedence(operation) + (operation == BAT_DO_POWER));
    return status == BATTEN_OK ? push(r, operation, 0) : status;
}

static batten_status read_all(reader *r)
{
    bool wants_value = true;
    batten_status status = BATTEN_OK;
    for (skip_blanks(r); status == BATTEN_OK && (*r->at || wants_value); skip_blanks(r))
        status = wants_value ? take_value(r, &wants_value) : take_operator(r, &wants_value);
    if (status == BATTEN_OK && r->has_equal)
        status = close_parenthesis(r);
    if (status == BATTEN_OK)
        status = carry_out_above(r, 1);
    if (status == BATTEN_OK && r->wait_count > 0)
        status = bat_fail(BATTEN_BAD_FORMAT,
                          "a '(' is not closed; put an expression with commas in quotes");
    return status;
}

batten_status batten_equation_read(const char *text, const batten_equation_names *names,
                                   batten_equation **out)
{
    if (names->variable_count < 1 || names->variable_count > BAT_JET_VARIABLES)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d variables; an expression has 1 to %d",
                        names->variable_count, BAT_JET_VARIABLES);
    batten_equation *made = bat_array(1, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    *made = (batten_equation){.variable_count = names->variable_count};
    reader r = {.text = text, .at = text, .names = names, .made = made};
    const batten_status status = read_all(&r);
    if (status != BATTEN_OK)
        batten_equation_free(made);
    else
        *out = made;
    return status;
}
