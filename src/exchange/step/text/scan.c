/* The grammar of ISO 10303-21, byte by byte. */
#include "exchange/step/text/scan.h"

#include <string.h>

#define B BAT_STEP_BLANK
#define D BAT_STEP_DIGIT
#define L BAT_STEP_LETTER
#define S (BAT_STEP_LETTER | BAT_STEP_LOWER)
const unsigned char bat_step_class[256] = {
    ['\t'] = B, ['\n'] = B, ['\v'] = B, ['\f'] = B, ['\r'] = B, [' '] = B, ['0'] = D, ['1'] = D,
    ['2'] = D,  ['3'] = D,  ['4'] = D,  ['5'] = D,  ['6'] = D,  ['7'] = D, ['8'] = D, ['9'] = D,
    ['A'] = L,  ['B'] = L,  ['C'] = L,  ['D'] = L,  ['E'] = L,  ['F'] = L, ['G'] = L, ['H'] = L,
    ['I'] = L,  ['J'] = L,  ['K'] = L,  ['L'] = L,  ['M'] = L,  ['N'] = L, ['O'] = L, ['P'] = L,
    ['Q'] = L,  ['R'] = L,  ['S'] = L,  ['T'] = L,  ['U'] = L,  ['V'] = L, ['W'] = L, ['X'] = L,
    ['Y'] = L,  ['Z'] = L,  ['_'] = L,  ['!'] = L,  ['a'] = S,  ['b'] = S, ['c'] = S, ['d'] = S,
    ['e'] = S,  ['f'] = S,  ['g'] = S,  ['h'] = S,  ['i'] = S,  ['j'] = S, ['k'] = S, ['l'] = S,
    ['m'] = S,  ['n'] = S,  ['o'] = S,  ['p'] = S,  ['q'] = S,  ['r'] = S, ['s'] = S, ['t'] = S,
    ['u'] = S,  ['v'] = S,  ['w'] = S,  ['x'] = S,  ['y'] = S,  ['z'] = S,
};
#undef B
#undef D
#undef L
#undef S

size_t bat_step_blank(const char *data, size_t size, size_t at, size_t *unfinished)
{
    for (;;) {
        while (at < size && bat_step_in(data[at], BAT_STEP_BLANK))
            at++;
        if (at + 1 >= size || data[at] != '/' || data[at + 1] != '*')
            return at;
        const size_t begin = at;
        for (at += 2;; at++) {
            const char *star = at < size ? memchr(data + at, '*', size - at) : NULL;
            if (!star || star + 1 >= data + size) {
                if (unfinished)
                    *unfinished = begin;
                return size;
            }
            at = (size_t)(star - data);
            if (data[at + 1] == '/')
                break;
        }
        at += 2;
    }
}

/* ---- for the first time ---- */

static bool wrong(bat_step_scanner *scanner, size_t at, const char *problem)
{
    scanner->problem = problem;
    scanner->at = at;
    if (scanner->far < at)
        scanner->far = at;
    return false;
}

bool bat_step_scan_blank(bat_step_scanner *scanner, size_t *at)
{
    const char c = *at < scanner->size ? scanner->data[*at] : ' ';
    if (c != '/' && !bat_step_in(c, BAT_STEP_BLANK))
        return true; /* nearly always */
    size_t unfinished = SIZE_MAX;
    *at = bat_step_blank(scanner->data, scanner->size, *at, &unfinished);
    if (unfinished == SIZE_MAX)
        return true;
    scanner->far = scanner->size;
    return wrong(scanner, unfinished, "a comment has no end");
}

bool bat_step_scan_byte(bat_step_scanner *scanner, size_t *at, char byte, const char *problem)
{
    if (!bat_step_scan_blank(scanner, at))
        return false;
    if (*at >= scanner->size || scanner->data[*at] != byte)
        return wrong(scanner, *at, problem);
    ++*at;
    return true;
}

bool bat_step_scan_keyword(bat_step_scanner *scanner, size_t *at)
{
    const char *data = scanner->data;
    size_t end = *at;
    int classes = 0;
    while (end < scanner->size &&
           (bat_step_in(data[end], BAT_STEP_LETTER | BAT_STEP_DIGIT) || data[end] == '-'))
        classes |= bat_step_class[(unsigned char)data[end++]];
    if (end == *at || !bat_step_in(data[*at], BAT_STEP_LETTER))
        return wrong(scanner, *at, "expected a keyword here");
    if ((classes & BAT_STEP_LOWER) && scanner->lower_case == SIZE_MAX)
        scanner->lower_case = *at;
    *at = end;
    return true;
}

bool bat_step_scan_id(bat_step_scanner *scanner, size_t *at, uint64_t *id)
{
    const char *data = scanner->data;
    size_t end = *at + 1;
    uint64_t value = 0;
    for (; end < scanner->size && bat_step_in(data[end], BAT_STEP_DIGIT); end++) {
        if (value > (UINT64_MAX - 9) / 10)
            return wrong(scanner, *at, "the number after '#' is too large");
        value = 10 * value + (uint64_t)(data[end] - '0');
    }
    if (end == *at + 1)
        return wrong(scanner, *at, "'#' has no number");
    *id = value;
    *at = end;
    return true;
}

static bool scan_string(bat_step_scanner *scanner, size_t *at)
{
    const char *data = scanner->data;
    size_t end = *at + 1;
    bool is_broken = false;
    for (; end < scanner->size; end++) {
        if (data[end] == '\'') {
            if (end + 1 >= scanner->size || data[end + 1] != '\'')
                break;
            end++;
        }
        is_broken |= data[end] == '\n' || data[end] == '\r';
    }
    if (is_broken)
        scanner->string = *at;
    scanner->far = end;
    if (end >= scanner->size)
        return wrong(scanner, *at, "a string has no end");
    if (end - *at - 1 > scanner->string_bytes)
        return wrong(scanner, *at, "a string is longer than the limit");
    if (is_broken && scanner->broken_string == SIZE_MAX)
        scanner->broken_string = *at;
    *at = end + 1;
    return true;
}

static bool scan_enum(bat_step_scanner *scanner, size_t *at)
{
    const char *data = scanner->data;
    size_t end = *at + 1;
    while (end < scanner->size && bat_step_in(data[end], BAT_STEP_LETTER | BAT_STEP_DIGIT))
        end++;
    if (end == *at + 1 || end >= scanner->size || data[end] != '.')
        return wrong(scanner, *at, "a word between dots has no second dot");
    *at = end + 1;
    return true;
}

static bool scan_binary(bat_step_scanner *scanner, size_t *at)
{
    const char *data = scanner->data;
    size_t end = *at + 1;
    while (end < scanner->size &&
           (bat_step_in(data[end], BAT_STEP_DIGIT) || (data[end] >= 'A' && data[end] <= 'F') ||
            (data[end] >= 'a' && data[end] <= 'f')))
        end++;
    scanner->far = end;
    if (end >= scanner->size || data[end] != '"')
        return wrong(scanner, *at, "a binary value has characters other than 0-9 and A-F");
    if (end - *at - 1 > scanner->string_bytes)
        return wrong(scanner, *at, "a binary value is longer than the limit");
    *at = end + 1;
    return true;
}

static size_t digits_end(const char *data, size_t size, size_t at)
{
    while (at < size && bat_step_in(data[at], BAT_STEP_DIGIT))
        at++;
    return at;
}

static bool scan_number(bat_step_scanner *scanner, size_t *at)
{
    const char *data = scanner->data;
    const size_t size = scanner->size;
    size_t begin = *at + (data[*at] == '+' || data[*at] == '-');
    size_t end = digits_end(data, size, begin);
    size_t digits = end - begin;
    if (end < size && data[end] == '.') {
        if (digits == 0 && scanner->bare_point == SIZE_MAX)
            scanner->bare_point = *at;
        begin = end + 1;
        end = digits_end(data, size, begin);
        digits += end - begin;
    }
    if (digits == 0)
        return wrong(scanner, *at, "a sign has no number");
    if (end < size && (data[end] == 'E' || data[end] == 'e')) {
        begin = end + 1;
        if (begin < size && (data[begin] == '+' || data[begin] == '-'))
            begin++;
        end = digits_end(data, size, begin);
        if (end == begin)
            return wrong(scanner, *at, "a number has no digits in its exponent");
    }
    *at = end;
    return true;
}

/* A value that is no list; a typed one up to its '('. */
static bool scan_simple(bat_step_scanner *scanner, size_t *at, bool *is_typed)
{
    const char *data = scanner->data;
    const char c = data[*at];
    uint64_t id;
    if (bat_step_in(c, BAT_STEP_DIGIT) || c == '-' || c == '+')
        return scan_number(scanner, at);
    switch (c) {
    case '#':
        return bat_step_scan_id(scanner, at, &id);
    case '\'':
        return scan_string(scanner, at);
    case '"':
        return scan_binary(scanner, at);
    case '$':
    case '*':
        ++*at;
        return true;
    case '.':
        return *at + 1 < scanner->size && bat_step_in(data[*at + 1], BAT_STEP_DIGIT)
                   ? scan_number(scanner, at)
                   : scan_enum(scanner, at);
    default:
        if (!bat_step_in(c, BAT_STEP_LETTER))
            return wrong(scanner, *at, "expected a value here");
        *is_typed = true;
        return bat_step_scan_keyword(scanner, at);
    }
}

/* Behind a value: any ')' and then the ',' before the next value. *depth is 0 at the end. */
static bool scan_after(bat_step_scanner *scanner, size_t *at, int *depth)
{
    while (*depth > 0) {
        if (!bat_step_scan_blank(scanner, at))
            return false;
        const char c = *at < scanner->size ? scanner->data[*at] : '\0';
        if (c != ',' && c != ')')
            return wrong(scanner, *at, "expected ',' or ')' here");
        ++*at;
        if (c == ',')
            break;
        --*depth;
    }
    return true;
}

bool bat_step_scan_list(bat_step_scanner *scanner, size_t *at)
{
    int depth = 0;
    bool is_typed = true; /* the '(' must come */
    do {
        if (!bat_step_scan_blank(scanner, at))
            return false;
        if (*at >= scanner->size)
            return wrong(scanner, *at, "expected a value here");
        const bool is_open = scanner->data[*at] == '(';
        if (is_typed && !is_open)
            return wrong(scanner, *at, "expected '(' after a keyword");
        is_typed = false;
        if (is_open) {
            if (++depth > scanner->nesting)
                return wrong(scanner, *at, "lists are nested deeper than the limit");
            ++*at;
            if (!bat_step_scan_blank(scanner, at))
                return false;
            if (*at >= scanner->size || scanner->data[*at] != ')')
                continue; /* with the first item */
        } else {
            if (!scan_simple(scanner, at, &is_typed))
                return false;
            if (is_typed)
                continue;
        }
        if (!scan_after(scanner, at, &depth))
            return false;
    } while (depth > 0);
    return true;
}

/* ---- again ---- */

static size_t string_end(const char *data, size_t size, size_t at)
{
    for (at++; at < size; at++)
        if (data[at] == '\'') {
            if (at + 1 >= size || data[at + 1] != '\'')
                return at + 1;
            at++;
        }
    return size;
}

size_t bat_step_token_end(const char *data, size_t size, size_t at)
{
    const char c = at < size ? data[at] : ')';
    if (c == '\'')
        return string_end(data, size, at);
    const bool is_enum =
        c == '.' && at + 1 < size && !bat_step_in(data[at + 1], BAT_STEP_DIGIT);
    if (c == '"' || is_enum) {
        const char *end = at + 1 < size ? memchr(data + at + 1, c, size - at - 1) : NULL;
        return end ? (size_t)(end - data) + 1 : size;
    }
    if (c == '$' || c == '*' || c == '(' || c == ')' || c == ',')
        return at + (at < size);
    for (at++; at < size; at++)
        if (!bat_step_in(data[at], BAT_STEP_LETTER | BAT_STEP_DIGIT) && data[at] != '.' &&
            data[at] != '-' && data[at] != '+')
            break;
    return at;
}

size_t bat_step_item_end(const char *data, size_t size, size_t at)
{
    int depth = 0;
    do {
        const char c = at < size ? data[at] : ')';
        const bool is_keyword = bat_step_in(c, BAT_STEP_LETTER);
        at = bat_step_token_end(data, size, at);
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth > 0 || is_keyword)
            at = bat_step_blank(data, size, at, NULL);
        if (is_keyword && depth == 0 && at < size && data[at] == '(') {
            depth = 1;
            at = bat_step_blank(data, size, at + 1, NULL);
        }
    } while (depth > 0 && at < size);
    return at;
}
