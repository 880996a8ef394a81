/* The search of `batten help`: every word must be found; a name counts more than another name, then title,
 * parameters and text. */
#include "commands/search.h"
#include "commands/literature.h"
#include "formats.h"

#include <stdlib.h>
#include <string.h>

/* Where a word was found, from the least to the most. */
enum { IN_TEXT, IN_PARAMETERS, IN_TITLE, IN_OTHER_NAME, IN_NAME, FIELD_COUNT };
static const char *const field_names[FIELD_COUNT] = {
    "in its text", "in its parameters", "in its title", "another name", "its name"};

/* As many as fit on a screen with the lines around them. */
#define MOST_SHOWN 16
/* Longer than any word that is looked for; what is longer is cut. */
#define WORD_SIZE 64

/* One thing that can be found. */
typedef struct {
    const char *name, *title;
    char *fields[FIELD_COUNT]; /* words in plain form */
    int score, field;          /* -1 for not found; where the word that is found worst stands */
} item;

typedef struct {
    int count;
    item *at;
} items;

/* ---- words in plain form ---- */

/* The plain letter of a two-byte character that begins with 0xC3: Latin letters with accents. */
static char plain_of_accented(unsigned char second)
{
    static const char letters[] = "aaaaaaaceeeeiiiidnooooo o"
                                  "uuuuyts";
    const size_t i = (size_t)(second & 0x1F);
    return i + 1 < sizeof letters && letters[i] != ' ' ? letters[i] : 0;
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (unsigned char)c >= 0x80;
}

char *search_plain(const char *words)
{
    batten_text out = BATTEN_TEXT;
    bool open = false;
    for (const char *at = words; *at; at++) {
        char c = *at >= 'A' && *at <= 'Z' ? (char)(*at - 'A' + 'a') : *at;
        char accented = (unsigned char)c == 0xC3 ? plain_of_accented((unsigned char)at[1]) : 0;
        if (accented) {
            c = accented;
            at++;
        }
        /* The points of "12.7.14" and "iii.6" belong to the number. */
        const bool inside = c == '.' && open && at[1] >= '0' && at[1] <= '9';
        if (is_letter(c) || inside)
            batten_text_bytes(&out, &c, 1);
        else if (open)
            batten_text_bytes(&out, " ", 1);
        open = is_letter(c) || inside;
    }
    char *plain = NULL;
    size_t length = 0;
    return batten_text_take(&out, &plain, &length) == BATTEN_OK ? plain : NULL;
}

/* The next word of a plain text, without the ending of a plural; false at the end. */
static bool next_word(const char **at, char *word)
{
    *at += strspn(*at, " ");
    size_t length = strcspn(*at, " ");
    const char *start = *at;
    *at += length;
    if (length == 0)
        return false;
    if (length > 3 && start[length - 1] == 's' && start[length - 2] != 's')
        length--;
    if (length >= WORD_SIZE)
        length = WORD_SIZE - 1;
    memcpy(word, start, length);
    word[length] = 0;
    return true;
}

/* 2 when the word stands in the text, 1 when one begins with it, 0 when neither. */
static int find_word(const char *text, const char *word)
{
    char other[WORD_SIZE];
    int found = 0;
    while (text && found < 2 && next_word(&text, other))
        if (strncmp(other, word, strlen(word)) == 0)
            found = other[strlen(word)] ? 1 : 2;
    return found;
}

static bool is_small_word(const char *word)
{
    static const char *const small[] = {"and", "of", "the", "in", "a", "an", "by", "for", "to"};
    for (size_t i = 0; i < sizeof small / sizeof small[0]; i++)
        if (strcmp(small[i], word) == 0)
            return true;
    return false;
}

/* ---- scores ---- */

/* A whole word counts as much more than the beginning of one as a field and a half. */
#define WHOLE_WORD 3
#define BEST_SCORE (2 * IN_NAME + WHOLE_WORD)

/* The best place of one word; -1 for none. */
static int score_word(const item *it, const char *word, int *field)
{
    int best = -1;
    for (int i = 0; i < FIELD_COUNT; i++) {
        const int found = find_word(it->fields[i], word);
        const int score = found ? 2 * i + (found == 2 ? WHOLE_WORD : 0) : -1;
        if (score > best) {
            best = score;
            *field = i;
        }
    }
    return best;
}

/* That of the word that is found worst, for all must be there. */
static void score_words(item *it, const char *words)
{
    char word[WORD_SIZE];
    int count = 0, field = 0;
    it->score = BEST_SCORE + 1;
    while (next_word(&words, word)) {
        if (is_small_word(word))
            continue;
        const int score = score_word(it, word, &field);
        if (score < it->score) {
            it->score = score;
            it->field = field;
        }
        count++;
    }
    if (count == 0)
        it->score = -1;
}

/* ---- what there is to find ---- */

static void add_field(item *it, int field, const char *words)
{
    batten_text both = BATTEN_TEXT;
    if (!words)
        return;
    char *plain = search_plain(words);
    batten_text_add(&both, "%s%s%s", it->fields[field] ? it->fields[field] : "",
                    it->fields[field] ? " " : "", plain ? plain : "");
    batten_release(plain);
    batten_release(it->fields[field]);
    it->fields[field] = NULL;
    size_t length = 0;
    (void)batten_text_take(&both, &it->fields[field], &length);
}

static item feature_item(int index)
{
    const batten_feature *f = batten_feature_at(index);
    item it = {.name = f->name, .title = f->summary};
    batten_text sources = BATTEN_TEXT;
    char *spelt = NULL;
    size_t length = 0;
    add_field(&it, IN_NAME, f->name);
    add_field(&it, IN_OTHER_NAME, f->also);
    add_field(&it, IN_TITLE, f->summary);
    for (int i = 0; i < f->parameter_count; i++) {
        add_field(&it, IN_PARAMETERS, f->parameters[i].name);
        add_field(&it, IN_PARAMETERS, f->parameters[i].words);
        add_field(&it, IN_PARAMETERS, f->parameters[i].summary);
    }
    add_field(&it, IN_TEXT, batten_feature_group(index));
    add_field(&it, IN_TEXT, f->manual);
    add_field(&it, IN_TEXT, f->promise);
    literature_add_sources(&sources, f);
    if (batten_text_take(&sources, &spelt, &length) == BATTEN_OK)
        add_field(&it, IN_TEXT, spelt);
    batten_release(spelt);
    return it;
}

static item command_item(const command *c)
{
    item it = {.name = c->name, .title = c->summary};
    add_field(&it, IN_NAME, c->name);
    add_field(&it, IN_TITLE, c->summary);
    for (int i = 0; i < c->option_count; i++) {
        add_field(&it, IN_PARAMETERS, c->options[i].name);
        add_field(&it, IN_PARAMETERS, c->options[i].help);
    }
    add_field(&it, IN_TEXT, c->manual);
    return it;
}

static item formats_item(void)
{
    item it = {.name = "formats", .title = "the formats of files that are read and written"};
    batten_text text = BATTEN_TEXT;
    char *words = NULL;
    size_t length = 0;
    formats_manual(&text);
    add_field(&it, IN_NAME, "formats");
    if (batten_text_take(&text, &words, &length) == BATTEN_OK)
        add_field(&it, IN_TITLE, words);
    batten_release(words);
    return it;
}

static item design_item(void)
{
    item it = {.name = "design",
               .title = "what stands in a design file: units, tolerance, parameters, outputs"};
    add_field(&it, IN_NAME, "design");
    add_field(&it, IN_TITLE, it.title);
    add_field(&it, IN_OTHER_NAME, "yaml, expression, unit");
    return it;
}

static items all_items(const command_table *table)
{
    const int features = batten_feature_count();
    items all = {0, batten_array((size_t)(features + table->count + 2), sizeof(item))};
    if (!all.at)
        return all;
    for (int i = 0; i < features; i++)
        all.at[all.count++] = feature_item(i);
    for (int i = 0; i < table->count; i++)
        if (!batten_feature_find(table->at[i]->name))
            all.at[all.count++] = command_item(table->at[i]);
    all.at[all.count++] = formats_item();
    all.at[all.count++] = design_item();
    return all;
}

static void release_items(items *all)
{
    for (int i = 0; i < all->count; i++)
        for (int field = 0; field < FIELD_COUNT; field++)
            batten_release(all->at[i].fields[field]);
    batten_release(all->at);
}

/* ---- what is shown ---- */

static void add_hit(batten_text *text, const item *it)
{
    batten_text_add(text, "  %-24s %s (%s)\n", it->name, it->title, field_names[it->field]);
}

/* Best first; of equals in the order of the manual. */
static int add_hits(batten_text *text, const items *all)
{
    int shown = 0, found = 0;
    for (int score = BEST_SCORE; score >= 0; score--)
        for (int i = 0; i < all->count; i++)
            if (all->at[i].score == score && found++ < MOST_SHOWN) {
                add_hit(text, &all->at[i]);
                shown++;
            }
    if (found > shown)
        batten_text_add(text, "\nand %d more that are less near.\n", found - shown);
    return found;
}

bool search_add(batten_text *text, const char *words, const command_table *table)
{
    batten_text hits = BATTEN_TEXT;
    items all = all_items(table);
    char *plain = search_plain(words), *list = NULL;
    size_t length = 0;
    for (int i = 0; plain && i < all.count; i++)
        score_words(&all.at[i], plain);
    int found = plain ? add_hits(&hits, &all) : 0;
    found += plain ? literature_add_places(&hits, plain) : 0;
    if (batten_text_take(&hits, &list, &length) == BATTEN_OK && found > 0)
        batten_text_add(text,
                        "'%s' is found in:\n\n%s\n'batten help NAME' describes one of them.\n",
                        words, list);
    batten_release(list);
    batten_release(plain);
    release_items(&all);
    return found > 0;
}
