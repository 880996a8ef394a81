/* Where the tokens of a format begin and end, so that damage replaces them whole. */
#include "mutate.h"

#include <string.h>

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}

/* Where the number that begins at `at` ends; `at` when there is none. */
static size_t past_number(const fuzz_text *text, size_t at)
{
    const char *c = text->bytes;
    size_t i = at, digits = 0;
    if (i < text->size && (c[i] == '-' || c[i] == '+'))
        i++;
    for (; i < text->size && (is_digit(c[i]) || c[i] == '.'); i++)
        digits += is_digit(c[i]);
    if (digits == 0)
        return at;
    size_t k = i + 1;
    if (i >= text->size || !strchr("eEdD", c[i]))
        return i;
    if (k < text->size && (c[k] == '-' || c[k] == '+'))
        k++;
    if (k >= text->size || !is_digit(c[k]))
        return i;
    while (k < text->size && is_digit(c[k]))
        k++;
    return k;
}

static size_t past_word(const fuzz_grammar *grammar, const fuzz_text *text, size_t at)
{
    const char *c = text->bytes;
    size_t i = at;
    if (i < text->size && c[i] == '.')
        i++;
    const size_t first = i;
    while (i < text->size && (is_letter(c[i]) || (i > first && !grammar->is_glued &&
                                                  (is_digit(c[i]) || c[i] == '-'))))
        i++;
    if (i == first)
        return at;
    return first > at && i < text->size && c[i] == '.' ? i + 1 : i;
}

static size_t past_quoted(const fuzz_text *text, size_t at, char quote)
{
    size_t i = at + 1;
    while (i < text->size && text->bytes[i] != quote && text->bytes[i] != '\n')
        i++;
    return i < text->size ? i + 1 : i;
}

static fuzz_token token_at(const fuzz_grammar *grammar, const fuzz_text *text, size_t at)
{
    const char c = text->bytes[at];
    size_t end = at;
    if (grammar->quote && c == grammar->quote)
        return (fuzz_token){at, past_quoted(text, at, c), FUZZ_STRING};
    if (grammar->reference && c == grammar->reference &&
        (end = past_number(text, at + 1)) > at + 1)
        return (fuzz_token){at, end, FUZZ_REFERENCE};
    if ((end = past_number(text, at)) > at)
        return (fuzz_token){at, end, FUZZ_NUMBER};
    if ((end = past_word(grammar, text, at)) > at)
        return (fuzz_token){at, end, FUZZ_WORD};
    return (fuzz_token){at, at + 1, FUZZ_MARK};
}

static size_t end_of_text(const fuzz_grammar *grammar, const fuzz_text *text)
{
    const size_t length = grammar->header_end ? strlen(grammar->header_end) : 0;
    for (size_t i = 0; length && i + length <= text->size; i++)
        if (memcmp(text->bytes + i, grammar->header_end, length) == 0)
            return i + length;
    return text->size;
}

void fuzz_tokens_of(const fuzz_grammar *grammar, const fuzz_text *text, fuzz_tokens *out)
{
    out->count = out->item_count = 0;
    out->text_end = end_of_text(grammar, text);
    const fuzz_text head = {text->bytes, out->text_end, out->text_end};
    out->items[0] = 0;
    for (size_t at = 0; at < head.size && out->count < FUZZ_TOKENS;) {
        const char c = head.bytes[at];
        if (c == grammar->end && out->item_count + 1 < FUZZ_TOKENS)
            out->items[++out->item_count] = at + 1;
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            at++;
            continue;
        }
        const fuzz_token token = token_at(grammar, &head, at);
        out->tokens[out->count++] = token;
        at = token.end;
    }
}
