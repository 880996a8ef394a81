/* The parameters of one entity: their places in the text, and their values. */
#include "exchange/iges/text/parameters.h"

#include <batten/text.h>
#include <limits.h>
#include <string.h>

void bat_iges_parameters_begin(bat_iges_parameters *parameters)
{
    *parameters = (bat_iges_parameters){.text = {.size = 1},
                                        .tokens = {.size = sizeof(bat_iges_token)},
                                        .values = {.size = sizeof(double)}};
}

void bat_iges_parameters_end(bat_iges_parameters *parameters)
{
    bat_release(parameters->text.items);
    bat_release(parameters->tokens.items);
    bat_release(parameters->values.items);
    bat_iges_parameters_begin(parameters);
}

void bat_iges_parameters_clear(bat_iges_parameters *parameters)
{
    parameters->text.count = parameters->tokens.count = parameters->values.count = 0;
    parameters->odd = parameters->in_place = parameters->vanished = 0;
}

/* ---- values ---- */

size_t bat_iges_count_of(const bat_iges_parameters *parameters)
{
    return parameters->tokens.count;
}

static const bat_iges_token *token_at(const bat_iges_parameters *parameters, size_t index)
{
    static const bat_iges_token none = {.kind = BAT_IGES_EMPTY};
    const bat_iges_token *tokens = parameters->tokens.items;
    return index < parameters->tokens.count ? &tokens[index] : &none;
}

static bat_span text_of(const bat_iges_parameters *parameters, const bat_iges_token *token)
{
    const size_t begin = token->begin;
    if (token->length == 0)
        return (bat_span){"", 0};
    if (begin < parameters->in_place)
        return (bat_span){parameters->records + begin / BAT_IGES_BLOCK * parameters->stride +
                              begin % BAT_IGES_BLOCK,
                          token->length};
    return (bat_span){(const char *)parameters->text.items + (begin - parameters->in_place),
                      token->length};
}

bat_span bat_iges_text(const bat_iges_parameters *parameters, size_t index, bool *is_string)
{
    const bat_iges_token *token = token_at(parameters, index);
    *is_string = token->kind == BAT_IGES_STRING;
    return text_of(parameters, token);
}

/* Say why a parameter is no number. */
static batten_status refuse(const bat_iges_parameters *parameters, size_t index)
{
    const bat_iges_token *token = token_at(parameters, index);
    const bat_span text = text_of(parameters, token);
    char copy[BAT_IGES_LONGEST_NUMBER];
    if (token->kind == BAT_IGES_STRING || text.length > BAT_IGES_LONGEST_NUMBER)
        return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu is not a number but %s", index,
                        token->kind == BAT_IGES_STRING ? "a string" : "a long text");
    for (size_t i = 0; i < text.length; i++)
        copy[i] = text.bytes[i] == 'D' || text.bytes[i] == 'd' ? 'E' : text.bytes[i];
    double value;
    const bool is_large =
        batten_number_read(copy, text.length, &value, NULL) == BATTEN_OVERFLOW;
    return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu, '%.*s', %s", index,
                    (int)(text.length < 40 ? text.length : 40), text.bytes,
                    is_large ? "is too large for a number" : "is not a number");
}

static bool is_odd(const bat_iges_token *token)
{
    return token->kind == BAT_IGES_STRING || token->kind == BAT_IGES_OTHER;
}

batten_status bat_iges_real(const bat_iges_parameters *parameters, size_t index, double *value)
{
    if (is_odd(token_at(parameters, index)))
        return refuse(parameters, index);
    *value = index < parameters->values.count
                 ? ((const double *)parameters->values.items)[index]
                 : 0;
    return BATTEN_OK;
}

batten_status bat_iges_reals_in_place(const bat_iges_parameters *parameters, size_t first,
                                      size_t count, const double **values)
{
    assert(first + count <= parameters->values.count);
    for (size_t i = first; parameters->odd > 0 && i < first + count; i++)
        if (is_odd(token_at(parameters, i)))
            return refuse(parameters, i);
    *values = (const double *)parameters->values.items + first;
    return BATTEN_OK;
}

batten_status bat_iges_reals(const bat_iges_parameters *parameters, size_t first, size_t count,
                             double *values)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_iges_real(parameters, first + i, &values[i]);
    return status;
}

batten_status bat_iges_integer(const bat_iges_parameters *parameters, size_t index, int *value)
{
    double number = 0;
    batten_status status = bat_iges_real(parameters, index, &number);
    if (status != BATTEN_OK)
        return status;
    const bat_span text = text_of(parameters, token_at(parameters, index));
    for (size_t i = 0; i < text.length; i++)
        if (!strchr("+-0123456789", text.bytes[i]))
            return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu, '%.*s', is not a whole number",
                            index, (int)(text.length < 40 ? text.length : 40), text.bytes);
    if (!(number >= -INT_MAX && number <= INT_MAX))
        return bat_fail(BATTEN_BAD_FORMAT,
                        "parameter %zu is %g, too large for a count or pointer", index, number);
    *value = (int)number;
    return BATTEN_OK;
}
