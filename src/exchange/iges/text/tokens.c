/* Parameters told apart. */
#include "base/digits.h"
#include "exchange/iges/text/parameters.h"

#include <limits.h>
#include <string.h>

static inline bool ends(bat_iges_delimiters delimiters, char c)
{
    return c == delimiters.delimiter || c == delimiters.terminator;
}

/* "nH" at the beginning: the length of the string, and where it begins; else -1. */
static long hollerith(bat_span text, size_t at, size_t *begin)
{
    long length = 0;
    size_t i = at;
    while (i < text.length && text.bytes[i] >= '0' && text.bytes[i] <= '9' && length < INT_MAX)
        length = 10 * length + (text.bytes[i++] - '0');
    *begin = i + 1;
    return i > at && i < text.length && text.bytes[i] == 'H' ? length : -1;
}

/* A string from `at` on, of `length` characters from `begin` on. */
static batten_status read_string(const bat_input *input, bat_iges_delimiters delimiters,
                                 bat_span text, size_t begin, size_t length, size_t *end,
                                 bat_iges_token *token)
{
    if (length > input->limits.string_bytes)
        return bat_fail(BATTEN_BAD_FORMAT, "a string of %zu characters; the limit is %zu",
                        length, input->limits.string_bytes);
    *end =
        length > text.length - begin ? text.length : bat_iges_past_blanks(text, begin + length);
    *token = (bat_iges_token){
        .begin = (uint32_t)begin, .length = (uint32_t)length, .kind = BAT_IGES_STRING};
    if (*end < text.length && !ends(delimiters, text.bytes[*end]))
        return bat_fail(BATTEN_BAD_FORMAT, "a string of %zu characters is followed by '%c'",
                        length, text.bytes[*end]);
    return BATTEN_OK;
}

/* A number, also with a D, or another text; it begins with neither a blank nor a delimiter. */
static bat_iges_token written_token(bat_span text, size_t begin, size_t end, double *value)
{
    char copy[BAT_IGES_LONGEST_NUMBER];
    bat_iges_token token = {.begin = (uint32_t)begin, .kind = BAT_IGES_OTHER};
    while (text.bytes[end - 1] == ' ')
        end--;
    token.length = (uint32_t)(end - begin);
    if (token.length > sizeof copy)
        return token;
    for (size_t i = begin; i < end; i++)
        copy[i - begin] = text.bytes[i] == 'D' || text.bytes[i] == 'd' ? 'E' : text.bytes[i];
    if (batten_number_read(copy, end - begin, value, NULL) == BATTEN_OK)
        token.kind = BAT_IGES_NUMBER;
    return token;
}

/* The token at `begin`; *end is where its delimiter is, or the end of the text. */
static batten_status read_token(const bat_input *input, bat_iges_delimiters delimiters,
                                bat_span text, size_t begin, size_t *end, bat_iges_token *token,
                                double *value)
{
    size_t skip = 0;
    const long length = hollerith(text, begin, &skip);
    if (length >= 0)
        return read_string(input, delimiters, text, skip, (size_t)length, end, token);
    for (*end = begin; *end < text.length; ++*end)
        if (ends(delimiters, text.bytes[*end]))
            break;
    if (*end < text.length)
        *token = written_token(text, begin, *end, value);
    return BATTEN_OK;
}

/* The columns of a record are one block, of which 64 bits say what is no digit. Behind it stand as many
 * characters as bat_number_of_digits may look at. */
enum { BLOCK = BAT_IGES_BLOCK, BEHIND = 16 };

/* Numbers that stand in a block whole, delimiters included, from *begin on up to the first
 * other token: of those bits each has one for its sign, if any, one for its point and one for
 * its delimiter. Finding them does not wait for the numbers before. There is room for them. */
static inline bool read_block(bat_iges_delimiters delimiters, bat_iges_parameters *parameters,
                              const char *text, size_t block, size_t *begin)
{
    size_t from = *begin, count = parameters->tokens.count;
    uint64_t marks = bat_no_digits(text) >> from << from, bits;
    bool done = false;
    bat_iges_token *tokens = parameters->tokens.items;
    double *values = parameters->values.items;
    while (marks && !done) {
        const uint64_t is_negative = text[from] == '-';
        uint64_t rest = marks & (marks - is_negative); /* without the lowest, the sign */
        if (!rest)
            break;
        const size_t digits = from + is_negative, point = (size_t)__builtin_ctzll(rest);
        size_t end = point, places = 0;
        rest &= rest - 1;
        if (text[point] == '.') {
            if (!rest)
                break;
            end = (size_t)__builtin_ctzll(rest);
            places = end - point - 1;
            rest &= rest - 1;
        }
        const bool is_last = text[end] == delimiters.terminator;
        if ((!is_last && text[end] != delimiters.delimiter) ||
            !bat_number_of_digits(text + digits, (int)(point - digits), (int)places, &bits))
            break;
        bits |= is_negative << 63;
        memcpy(&values[count], &bits, sizeof bits);
        tokens[count++] =
            (bat_iges_token){(uint32_t)(block + from), (uint32_t)(end - from), BAT_IGES_NUMBER};
        from = end + 1;
        marks = rest;
        done = is_last;
    }
    parameters->tokens.count = parameters->values.count = count;
    *begin = from;
    return done;
}

/* Room for so many tokens more. */
static batten_status make_room(bat_input *input, bat_iges_parameters *parameters, size_t count)
{
    batten_status status = bat_list_reserve(input, &parameters->tokens, count);
    if (status == BATTEN_OK)
        status = bat_list_reserve(input, &parameters->values, count);
    return status;
}

static inline size_t past_blanks_of_block(const char *text, size_t at)
{
    for (; at < BLOCK; at += 8) {
        const uint64_t others = bat_eight_characters(text + at) ^ ' ' * BAT_BYTES;
        if (others) {
            at += (size_t)(__builtin_ctzll(others) >> 3);
            break;
        }
    }
    return at < BLOCK ? at : BLOCK;
}

/* Another number, or nothing, directly before a delimiter in the block; false for all others.
 */
static bool read_one(bat_iges_delimiters delimiters, bat_iges_parameters *parameters,
                     const char *text, size_t block, size_t *begin, bool *done)
{
    const char *from = text + *begin;
    const bool is_empty = ends(delimiters, *from);
    double value = 0;
    size_t used = 0;
    if (!is_empty && batten_number_read(from, BLOCK - *begin, &value, &used) != BATTEN_OK)
        return false;
    const size_t end = *begin + used;
    if (end == BLOCK || !ends(delimiters, text[end]))
        return false;
    if (bat_has_vanished((bat_span){from, used}, value))
        parameters->vanished = parameters->tokens.count;
    ((double *)parameters->values.items)[parameters->values.count++] = value;
    ((bat_iges_token *)parameters->tokens.items)[parameters->tokens.count++] =
        (bat_iges_token){(uint32_t)(block + *begin), (uint32_t)used,
                         is_empty ? BAT_IGES_EMPTY : BAT_IGES_NUMBER};
    *done = text[end] == delimiters.terminator;
    *begin = end + 1;
    return true;
}

/* The tokens of a block, up to the terminator or to one that is not read there; was there none such? */
static bool read_record(bat_iges_delimiters delimiters, bat_iges_parameters *parameters,
                        const char *text, size_t block, size_t *begin, bool *done)
{
    *begin = past_blanks_of_block(text, 0);
    while (*begin < BLOCK && !*done) {
        const size_t before = *begin;
        *done = read_block(delimiters, parameters, text, block, begin);
        if (*begin == before && !read_one(delimiters, parameters, text, block, begin, done))
            return false;
        *begin = past_blanks_of_block(text, *begin);
    }
    return true;
}

batten_status bat_iges_tokenise_in_place(bat_input *input, bat_iges_delimiters delimiters,
                                         bat_iges_parameters *parameters, const char *records,
                                         size_t stride, size_t count, size_t *at, bool *done)
{
    char text[BLOCK + BEHIND] = {0};
    parameters->records = records;
    parameters->stride = stride;
    *done = false;
    for (size_t k = 0; k < count && k < UINT32_MAX / BLOCK && !*done; k++) {
        size_t begin = 0;
        const batten_status status = make_room(input, parameters, BLOCK); /* a delimiter each */
        if (status != BATTEN_OK)
            return status;
        memcpy(text, records + k * stride, BLOCK);
        const bool is_whole =
            read_record(delimiters, parameters, text, BLOCK * k, &begin, done);
        *at = BLOCK * k + begin;
        if (!is_whole)
            return BATTEN_OK;
        parameters->in_place = BLOCK * (k + 1);
    }
    return BATTEN_OK;
}

/* The token at `begin`, of any kind. */
static batten_status read_any_token(bat_input *input, bat_iges_delimiters delimiters,
                                    bat_iges_parameters *parameters, size_t begin, size_t *end)
{
    const bat_span text = {parameters->text.items, parameters->text.count};
    bat_iges_token *token =
        (bat_iges_token *)parameters->tokens.items + parameters->tokens.count;
    double *value = (double *)parameters->values.items + parameters->values.count;
    batten_status status = BATTEN_OK;
    *end = begin;
    *token = (bat_iges_token){.kind = BAT_IGES_EMPTY};
    *value = 0;
    if (!ends(delimiters, text.bytes[begin]))
        status = read_token(input, delimiters, text, begin, end, token, value);
    if (status != BATTEN_OK || *end == text.length)
        return status;
    parameters->odd += token->kind == BAT_IGES_STRING || token->kind == BAT_IGES_OTHER;
    if (token->kind == BAT_IGES_NUMBER &&
        bat_has_vanished((bat_span){text.bytes + token->begin, token->length}, *value))
        parameters->vanished = parameters->tokens.count;
    token->begin += (uint32_t)parameters->in_place;
    parameters->tokens.count++;
    parameters->values.count++;
    return BATTEN_OK;
}

/* The same in the text, which is counted from its own beginning. */
static batten_status tokenise_text(bat_input *input, bat_iges_delimiters delimiters,
                                   bat_iges_parameters *parameters, size_t *at, bool *done)
{
    const bat_span text = {parameters->text.items, parameters->text.count};
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && !*done) {
        size_t end = 0;
        *at = bat_iges_past_blanks(text, *at);
        if (*at == text.length)
            return BATTEN_OK;
        status = make_room(input, parameters, 1);
        if (status == BATTEN_OK)
            status = read_any_token(input, delimiters, parameters, *at, &end);
        if (status != BATTEN_OK || end == text.length)
            return status;
        *done = text.bytes[end] == delimiters.terminator;
        *at = end + 1;
    }
    return status;
}

batten_status bat_iges_tokenise(bat_input *input, bat_iges_delimiters delimiters,
                                bat_iges_parameters *parameters, size_t *at, bool *done)
{
    size_t within = *at - parameters->in_place;
    if (parameters->text.count > UINT32_MAX - parameters->in_place)
        return bat_fail(BATTEN_BAD_FORMAT, "its parameters have more than %u characters",
                        UINT32_MAX);
    *done = false;
    const batten_status status = tokenise_text(input, delimiters, parameters, &within, done);
    *at = parameters->in_place + within;
    return status;
}
