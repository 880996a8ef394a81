/* Random damage to a file: bytes, tokens and lines are changed, moved, and taken from other
 * files. */
#include "mutate.h"

#include <stdlib.h>
#include <string.h>

fuzz_random fuzz_random_begin(uint64_t seed)
{
    /* Neighbouring seeds begin far apart, and none at 0. */
    uint64_t z = seed + 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (fuzz_random){z ? z : 1};
}

size_t fuzz_random_below(fuzz_random *random, size_t count)
{
    uint64_t x = random->state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    random->state = x;
    return count ? (size_t)((x * 0x2545f4914f6cdd1du) >> 11) % count : 0;
}

bool fuzz_replace(fuzz_text *text, size_t from, size_t to, const char *bytes, size_t count)
{
    const size_t size = text->size - (to - from) + count;
    if (size > text->capacity)
        return false;
    memmove(text->bytes + from + count, text->bytes + to, text->size - to);
    if (count)
        memcpy(text->bytes + from, bytes, count);
    text->size = size;
    return true;
}

/* Everything that damage works with. */
typedef struct {
    const fuzz_grammar *grammar;
    fuzz_random *random;
    fuzz_text text;
    fuzz_tokens *tokens;
    const char *other;
    size_t other_size;
} damage;

static size_t below(damage *d, size_t count)
{
    return fuzz_random_below(d->random, count);
}

/* Put a copy of from .. to of the text itself at `at` .. `past`. */
static bool copy_over(damage *d, size_t at, size_t past, size_t from, size_t to)
{
    char *copy = malloc(to - from + 1);
    if (!copy)
        return false;
    memcpy(copy, d->text.bytes + from, to - from);
    const bool done = fuzz_replace(&d->text, at, past, copy, to - from);
    free(copy);
    return done;
}

/* Exchange two stretches, the first before the second. */
static bool exchange(damage *d, size_t a, size_t a_end, size_t b, size_t b_end)
{
    if (b < a_end)
        return false;
    char *joined = malloc(b_end - a + 1);
    if (!joined)
        return false;
    const char *bytes = d->text.bytes;
    size_t n = 0;
    memcpy(joined, bytes + b, b_end - b);
    n += b_end - b;
    memcpy(joined + n, bytes + a_end, b - a_end);
    n += b - a_end;
    memcpy(joined + n, bytes + a, a_end - a);
    const bool done = fuzz_replace(&d->text, a, b_end, joined, b_end - a);
    free(joined);
    return done;
}

/* ---- tokens ---- */

static const fuzz_token *any_token(damage *d)
{
    return d->tokens->count ? &d->tokens->tokens[below(d, d->tokens->count)] : NULL;
}

/* From a random place on the first of a kind; NULL when there is none. */
static const fuzz_token *token_of(damage *d, fuzz_kind kind)
{
    const size_t n = d->tokens->count, from = below(d, n);
    for (size_t i = 0; i < n; i++)
        if (d->tokens->tokens[(from + i) % n].kind == kind)
            return &d->tokens->tokens[(from + i) % n];
    return NULL;
}

static bool put_word(damage *d, const fuzz_token *token, const char *word)
{
    return token && fuzz_replace(&d->text, token->begin, token->end, word, strlen(word));
}

static bool bound_number(damage *d)
{
    static const char *const bounds[] = {
        "0",          "-1",         "1",          "2",
        "-0.",        "3",          "2147483647", "1e9",
        "1e400",      "nan",        "inf",        "-1e400",
        "4294967296", "2147483648", "-1e-400",    "1e-300",
        "1e300",      "1e3",        "65536",      "25",
        "26",         "1e154",      "-2",         "1e-9",
        "255",        "256",        "0x10",       "9223372036854775808",
        ".5",         "0.5",        "1e15",       "-1.5e9",
        "100000000",  "1,5",        "--1"};
    return put_word(d, token_of(d, FUZZ_NUMBER),
                    bounds[below(d, sizeof bounds / sizeof bounds[0])]);
}

/* The last digit is another: a count that is one off, a number that hardly differs. */
static bool nudge_number(damage *d)
{
    const fuzz_token *token = token_of(d, below(d, 3) ? FUZZ_NUMBER : FUZZ_REFERENCE);
    if (!token)
        return false;
    for (size_t i = token->end; i-- > token->begin;) {
        char *c = &d->text.bytes[i];
        if (*c < '0' || *c > '9')
            continue;
        *c = *c == '9' ? '8' : *c == '0' || below(d, 2) ? (char)(*c + 1) : (char)(*c - 1);
        return true;
    }
    return false;
}

static bool negate_number(damage *d)
{
    const fuzz_token *token = token_of(d, FUZZ_NUMBER);
    if (!token)
        return false;
    const bool is_negative = d->text.bytes[token->begin] == '-';
    return fuzz_replace(&d->text, token->begin, token->begin + is_negative, "-", !is_negative);
}

/* Another of the same kind in its place: references that go elsewhere, rings, wrong types. */
static bool copy_alike(damage *d)
{
    const fuzz_kind kind = (fuzz_kind)below(d, 5);
    const fuzz_token *a = token_of(d, kind), *b = token_of(d, kind);
    return a && copy_over(d, a->begin, a->end, b->begin, b->end);
}

static bool copy_reference(damage *d)
{
    const fuzz_kind kind = d->grammar->reference ? FUZZ_REFERENCE : FUZZ_NUMBER;
    const fuzz_token *a = token_of(d, kind), *b = token_of(d, kind);
    return a && copy_over(d, a->begin, a->end, b->begin, b->end);
}

static bool swap_tokens(damage *d, const fuzz_token *a, const fuzz_token *b)
{
    if (!a || !b)
        return false;
    return a->begin < b->begin ? exchange(d, a->begin, a->end, b->begin, b->end)
                               : exchange(d, b->begin, b->end, a->begin, a->end);
}

static bool swap_alike(damage *d)
{
    const fuzz_kind kind = (fuzz_kind)below(d, 4);
    const fuzz_token *a = token_of(d, kind);
    return swap_tokens(d, a, token_of(d, kind));
}

static bool swap_any(damage *d)
{
    const fuzz_token *a = any_token(d);
    return swap_tokens(d, a, any_token(d));
}

static bool delete_token(damage *d)
{
    const fuzz_token *token = any_token(d);
    return token && fuzz_replace(&d->text, token->begin, token->end, "", 0);
}

/* With what stands between: a list that is longer by one, or by some. */
static bool repeat_tokens(damage *d)
{
    const size_t n = d->tokens->count, i = below(d, n), k = i + 1 + below(d, 4);
    if (k >= n)
        return false;
    const size_t begin = d->tokens->tokens[i].begin, end = d->tokens->tokens[k].begin;
    return copy_over(d, end, end, begin, end);
}

static bool delete_tokens(damage *d)
{
    const size_t n = d->tokens->count, i = below(d, n), k = i + 1 + below(d, 4);
    return k < n && fuzz_replace(&d->text, d->tokens->tokens[i].begin,
                                 d->tokens->tokens[k].begin, "", 0);
}

/* A word of the table, in the place of a word or of anything. */
static bool other_word(damage *d)
{
    const char *words = d->grammar->words;
    if (!words)
        return copy_alike(d);
    size_t count = 1;
    for (const char *c = words; *c; c++)
        count += *c == ' ';
    for (size_t skip = below(d, count); skip > 0; words++)
        skip -= *words == ' ';
    const fuzz_token *token = below(d, 4) ? token_of(d, FUZZ_WORD) : any_token(d);
    return token &&
           fuzz_replace(&d->text, token->begin, token->end, words, strcspn(words, " "));
}

/* ---- lines and entities ---- */

static bool copy_item(damage *d)
{
    const size_t n = d->tokens->item_count, *items = d->tokens->items;
    const size_t i = below(d, n), at = items[below(d, n + 1)];
    return n > 0 && copy_over(d, at, at, items[i], items[i + 1]);
}

static bool delete_items(damage *d)
{
    const size_t n = d->tokens->item_count, i = below(d, n);
    const size_t k = i + 1 + (below(d, 4) ? 0 : below(d, n - i));
    return n > 0 && fuzz_replace(&d->text, d->tokens->items[i], d->tokens->items[k], "", 0);
}

static bool swap_items(damage *d)
{
    const size_t n = d->tokens->item_count, *items = d->tokens->items;
    const size_t a = below(d, n), b = below(d, n);
    if (n == 0 || a == b)
        return false;
    return a < b ? exchange(d, items[a], items[a + 1], items[b], items[b + 1])
                 : exchange(d, items[b], items[b + 1], items[a], items[a + 1]);
}

/* Some lines or entities of another file. */
static bool insert_other(damage *d)
{
    const size_t n = d->tokens->item_count, at = d->tokens->items[below(d, n + 1)];
    if (!d->other || d->other_size == 0)
        return copy_item(d);
    size_t from = below(d, d->other_size), to = from;
    while (from > 0 && d->other[from - 1] != d->grammar->end)
        from--;
    for (size_t lines = 1 + below(d, 8); to < d->other_size && lines > 0; to++)
        lines -= d->other[to] == d->grammar->end;
    return fuzz_replace(&d->text, at, at, d->other + from, to - from);
}

static bool cut(damage *d)
{
    d->text.size = below(d, d->text.size + 1);
    return true;
}

/* ---- bytes ---- */

static bool change_bytes(damage *d)
{
    const size_t at = below(d, d->text.size + 1), left = d->text.size - at;
    char bytes[4];
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (char)below(d, 256);
    if (below(d, 2) && left > 0) {
        d->text.bytes[at] = (char)(d->text.bytes[at] ^ (1 << below(d, 8)));
        return true;
    }
    const size_t count = below(d, sizeof bytes + 1), over = below(d, sizeof bytes + 1);
    return fuzz_replace(&d->text, at, at + (over < left ? over : left), bytes, count);
}

/* Four bytes of what is no text become a boundary number. */
static bool bound_bytes(damage *d)
{
    static const uint32_t bounds[] = {0,           1,           0x7fffffffu, 0x80000000u,
                                      0xffffffffu, 0x7fc00000u, 0x7f800000u, 0x00010000u,
                                      0x3f800000u, 0x00000100u, 0x7f7fffffu, 0x00000001u};
    const size_t from = d->grammar->header_end ? d->tokens->text_end : d->text.size;
    /* What has no header at all, as the triangles of STL, counts from 80 on. */
    const size_t begin = from < d->text.size ? from : 80;
    if (!d->grammar->header_end || d->text.size < begin + 4)
        return bound_number(d);
    const size_t places = (d->text.size - begin) / (below(d, 2) ? 4 : 1);
    const size_t step = (d->text.size - begin) / (places ? places : 1);
    const size_t at = begin + step * below(d, places);
    uint32_t bits = bounds[below(d, sizeof bounds / sizeof bounds[0])];
    if (below(d, 3) == 0)
        bits = bits >> 24 | (bits >> 8 & 0xff00u) | (bits << 8 & 0xff0000u) | bits << 24;
    if (at + sizeof bits > d->text.size)
        return false;
    memcpy(d->text.bytes + at, &bits, sizeof bits);
    return true;
}

/* ---- all ---- */

static bool (*const ways[])(damage *) = {
    bound_number,  bound_number,  nudge_number, nudge_number,   negate_number,  copy_alike,
    copy_alike,    swap_alike,    swap_any,     copy_reference, copy_reference, delete_token,
    repeat_tokens, delete_tokens, other_word,   other_word,     copy_item,      delete_items,
    swap_items,    insert_other,  cut,          change_bytes,   bound_bytes};

static bool damage_once(damage *d)
{
    fuzz_tokens_of(d->grammar, &d->text, d->tokens);
    return ways[below(d, sizeof ways / sizeof ways[0])](d);
}

/* The same with the records of 80 columns unfolded, and put into records again. */
static bool damage_records(damage *d)
{
    const size_t capacity = 2 * d->text.capacity + 256;
    const fuzz_text records = d->text;
    const fuzz_text other = {(char *)(uintptr_t)d->other, d->other_size, d->other_size};
    fuzz_text lines = {malloc(capacity), 0, capacity}, lent = {malloc(capacity), 0, capacity};
    bool done = lines.bytes && lent.bytes && fuzz_unfold(&records, &lines);
    if (done) {
        damage inside = *d;
        inside.text = lines;
        inside.other = d->other && fuzz_unfold(&other, &lent) ? lent.bytes : NULL;
        inside.other_size = lent.size;
        done = damage_once(&inside);
        lines = inside.text;
    }
    if (done) {
        fuzz_text folded = {lent.bytes, 0, capacity};
        done = fuzz_fold(&lines, &folded) && folded.size <= d->text.capacity;
        if (done)
            memcpy(d->text.bytes, folded.bytes, d->text.size = folded.size);
    }
    free(lines.bytes);
    free(lent.bytes);
    return done;
}

size_t fuzz_mutate(const fuzz_grammar *grammar, uint8_t *data, size_t size, size_t most,
                   uint64_t seed, const uint8_t *other, size_t other_size,
                   size_t (*bytes)(uint8_t *data, size_t size, size_t most))
{
    fuzz_random random = fuzz_random_begin(seed);
    damage d = {.grammar = grammar,
                .random = &random,
                .text = {(char *)data, size, most},
                .tokens = malloc(sizeof *d.tokens),
                .other = (const char *)other,
                .other_size = other_size};
    bool done = false;
    const bool only_bytes = bytes && below(&d, 4) == 0;
    for (int attempt = 0; d.tokens && size > 0 && !only_bytes && !done && attempt < 8;
         attempt++)
        done = grammar->has_columns && below(&d, 8) ? damage_records(&d) : damage_once(&d);
    free(d.tokens);
    if (!done && bytes)
        return bytes(data, size, most);
    return d.text.size;
}
