/*
 * Damaged inputs: in the example of each feature of the manual an item of a list is missing, is
 * there twice, is of another kind or has one of another kind behind it, or the list is reversed or
 * turned; or an input with a name of its own is of another kind. Each is used, refused or
 * remarked upon. So is a number that is not finite, huge, 0 or of the other sign.
 * BATTEN_CASES=200 tries that many of each feature.
 */
#include "design/expect.h"
#include "design/outcome.h"

#include <ctype.h>
#include <string.h>

enum { MOST = 8000, MOST_LISTS = 60, MOST_ITEMS = 60 };

/* A list of the text: from its bracket to behind the other, and its items. */
typedef struct {
    const char *start, *end;
    int count;
    struct {
        const char *at;
        int length;
    } items[MOST_ITEMS];
} list;

/* Does the item begin as a name, a list or a map does? */
static bool is_thing(const char *item)
{
    item += strspn(item, " \n");
    return isalpha((unsigned char)*item) || strchr("[{\"", *item);
}

/* The list at a bracket. Coordinates and other numbers are no things: a list of them is left
 * alone. */
static bool read_list(const char *bracket, list *out)
{
    int depth = 0;
    bool has_things = false;
    const char *item = bracket + 1;
    *out = (list){.start = bracket};
    for (const char *c = bracket; *c; c++) {
        depth += (*c == '[' || *c == '{') - (*c == ']' || *c == '}');
        if ((depth == 1 && *c == ',') || depth == 0) {
            if (out->count == MOST_ITEMS)
                return false;
            has_things |= is_thing(item);
            out->items[out->count].at = item;
            out->items[out->count++].length = (int)(c - item);
            item = c + 1;
        }
        if (depth == 0) {
            out->end = c + 1;
            return has_things && out->count > 1;
        }
    }
    return false;
}

/* All lists of names, points and rows. */
static int find_lists(const char *text, list *lists)
{
    int count = 0;
    for (const char *c = text; *c && count < MOST_LISTS; c++)
        if (*c == '[' && read_list(c, &lists[count]))
            count++;
    return count;
}

typedef enum { MISSING, TWICE, OTHER_KIND, EXTRA, REVERSED, TURNED, DAMAGES } damage;

static const char *const odd[] = {
    "{sphere: 37 cm, at: [0.2, 0.1, 9]}",
    "{box: [0.3, 0.2, 0.1], at: [0.1, 0.2, 9]}",
    "{line: [[0.1, 0.2, 9], [0.7, 0.3, 9.5]]}",
};

/* What stands at the start of the example up to the first bytes of its features, and there the odd
 * one: to text. Returns how long that is. */
static int write_start(const char *example, const char *extra, char text[MOST])
{
    const char *features = strstr(example, "features:\n") + strlen("features:\n");
    return snprintf(text, MOST, "batten: 1\n%.*s  odd: %s\n", (int)(features - example),
                    example, extra);
}

/* The example whose bytes from one place on and before another are replaced, to text. */
static void write_replaced(const char *example, const char *from, const char *to,
                           const char *by, const char *extra, char text[MOST])
{
    const char *features = strstr(example, "features:\n") + strlen("features:\n");
    const int length = write_start(example, extra, text);
    snprintf(text + length, (size_t)(MOST - length), "%.*s%s%s", (int)(from - features),
             features, by, to);
}

/* The list damaged at an item. */
static void write_list(const list *l, damage kind, int item, char text[MOST])
{
    int length = snprintf(text, MOST, "[");
    const char *comma = "";
    for (int i = 0; i < l->count; i++) {
        const int k = kind == REVERSED ? l->count - 1 - i
                      : kind == TURNED ? (i + item) % l->count
                                       : i;
        const bool here = i == item;
        if (here && kind == MISSING)
            continue;
        const char *at = here && kind == OTHER_KIND ? "odd" : l->items[k].at;
        const int size = here && kind == OTHER_KIND ? 3 : l->items[k].length;
        for (int n = here && kind == TWICE ? 2 : 1; n > 0; n--, comma = ", ")
            length +=
                snprintf(text + length, (size_t)(MOST - length), "%s%.*s", comma, size, at);
        if (here && kind == EXTRA)
            length += snprintf(text + length, (size_t)(MOST - length), ", odd");
    }
    snprintf(text + length, (size_t)(MOST - length), "]");
}

/* Equal inputs in another order, and one given twice, may rightly come to the same. */
static bool may_be_same(damage kind)
{
    return kind == TWICE || kind == REVERSED || kind == TURNED;
}

/* Does a text come to something else than the plain example, or is the same no wonder? */
static bool is_noticed(const char *feature, const outcome *plain, const char *text,
                       bool may_be_same)
{
    outcome with = outcome_of(text);
    const bool lost = !may_be_same && strcmp(plain->made, with.made) == 0 &&
                      strcmp(plain->said, with.said) == 0;
    const bool wild = strstr(with.made, "nan") || strstr(with.made, "inf");
    if (lost || wild)
        printf("%s: %s\n%s\n", feature, lost ? "in silence" : "not finite", text);
    outcome_release(&with);
    return !lost && !wild;
}

/* The example with an odd one that nothing uses. */
static outcome plain_outcome(const batten_feature *feature)
{
    char text[MOST];
    const int length = write_start(feature->example, odd[0], text);
    snprintf(text + length, (size_t)(MOST - length), "%s",
             strstr(feature->example, "features:\n") + strlen("features:\n"));
    return outcome_of(text);
}

static bool try_list(test_random *random, const batten_feature *feature, const list *lists,
                     int count, const outcome *plain)
{
    const list *l = &lists[test_random_int(random, 0, count - 1)];
    const damage kind = (damage)test_random_int(random, 0, DAMAGES - 1);
    const int item = test_random_int(random, 1, l->count - 1);
    char damaged[MOST], text[MOST];
    write_list(l, kind, item, damaged);
    write_replaced(feature->example, l->start, l->end, damaged,
                   odd[test_random_int(random, 0, COUNT(odd) - 1)], text);
    return is_noticed(feature->name, plain, text, may_be_same(kind));
}

TEST(G0_damaged_lists_of_each_feature_are_used_refused_or_remarked_upon)
{
    static list lists[MOST_LISTS];
    test_random random = test_random_begin("damaged");
    const int cases = test_cases(1), most = test_cases(1000);
    int bad = 0;
    outcome_write_inputs();
    for (int i = 0; i < batten_feature_count() && i < most; i++) {
        const batten_feature *feature = batten_feature_at(i);
        const char *features = strstr(feature->example, "features:\n");
        const int count = features ? find_lists(features, lists) : 0;
        if (count == 0)
            continue;
        outcome plain = plain_outcome(feature);
        for (int n = 0; n < cases; n++)
            bad += !try_list(&random, feature, lists, count, &plain);
        outcome_release(&plain);
    }
    CHECK_INT(bad, 0);
}

/* ---- inputs by name ---- */

enum { MOST_NAMES = 60 };

typedef struct {
    const char *at;
    int length;
} span;

/* Values that are the name of another feature of the example: `profile: p`. */
static int find_names(const char *features, span *names)
{
    int count = 0;
    for (const char *c = features + 2; *c && count < MOST_NAMES; c++) {
        const int length = (int)strspn(c, "abcdefghijklmnopqrstuvwxyz0123456789-_");
        if (c[-1] != ' ' || c[-2] != ':' || length == 0 || length > 40 ||
            !strchr(",}\n", c[length]))
            continue;
        char line[50];
        snprintf(line, sizeof line, "\n  %.*s:", length, c);
        if (strstr(features, line))
            names[count++] = (span){c, length};
    }
    return count;
}

TEST(G0_inputs_of_another_kind_are_used_refused_or_remarked_upon)
{
    test_random random = test_random_begin("other kinds");
    const int cases = test_cases(1), most = test_cases(1000);
    span names[MOST_NAMES];
    char text[MOST];
    int bad = 0;
    outcome_write_inputs();
    for (int i = 0; i < batten_feature_count() && i < most; i++) {
        const batten_feature *feature = batten_feature_at(i);
        const char *features = strstr(feature->example, "features:\n");
        const int count = features ? find_names(features, names) : 0;
        if (count == 0)
            continue;
        outcome plain = plain_outcome(feature);
        for (int n = 0; n < cases; n++) {
            const span *name = &names[test_random_int(&random, 0, count - 1)];
            write_replaced(feature->example, name->at, name->at + name->length, "odd",
                           odd[test_random_int(&random, 0, COUNT(odd) - 1)], text);
            bad += !is_noticed(feature->name, &plain, text, false);
        }
        outcome_release(&plain);
    }
    CHECK_INT(bad, 0);
}

/* ---- numbers ---- */

enum { MOST_NUMBERS = 400 };

/* Numbers that stand as values: behind a bracket, a comma or a colon. */
static int find_numbers(const char *text, span *numbers)
{
    int count = 0;
    for (const char *c = text + 2; *c && count < MOST_NUMBERS; c++) {
        const bool is_value = c[-1] == '[' || (c[-1] == ' ' && strchr(",:", c[-2]));
        if (!is_value || !(isdigit((unsigned char)*c) || *c == '-'))
            continue;
        const int length = (int)strspn(c, "-0123456789.e");
        if (length > 1 || *c != '-')
            numbers[count++] = (span){c, length};
        c += length;
    }
    return count;
}

static const char *const replacements[] = {".nan",  "nan",    ".inf", "-inf", "1e400",
                                           "1e300", "-1e300", "0",    "-0.7"};
enum { NOT_FINITE = 5 }; /* so many of the first are */

static bool try_number(test_random *random, const batten_feature *feature, int count,
                       const span *numbers, const outcome *plain)
{
    const span *n = &numbers[test_random_int(random, 0, count - 1)];
    const int which = test_random_int(random, 0, COUNT(replacements) - 1);
    char text[MOST];
    snprintf(text, sizeof text, "batten: 1\n%.*s%s%s", (int)(n->at - feature->example),
             feature->example, replacements[which], n->at + n->length);
    return is_noticed(feature->name, plain, text, which >= NOT_FINITE);
}

TEST(numbers_that_are_not_finite_are_noticed_and_no_number_makes_what_is_not_finite)
{
    test_random random = test_random_begin("damaged numbers");
    const int cases = test_cases(1), most = test_cases(1000);
    static span numbers[MOST_NUMBERS];
    int bad = 0;
    outcome_write_inputs();
    for (int i = 0; i < batten_feature_count() && i < most; i++) {
        const batten_feature *feature = batten_feature_at(i);
        const char *features = strstr(feature->example, "features:\n");
        const int count = features ? find_numbers(features, numbers) : 0;
        char plain[MOST];
        if (count == 0)
            continue;
        snprintf(plain, sizeof plain, "batten: 1\n%s", feature->example);
        outcome without = outcome_of(plain);
        for (int n = 0; n < cases; n++)
            bad += !try_number(&random, feature, count, numbers, &without);
        outcome_release(&without);
    }
    CHECK_INT(bad, 0);
}
