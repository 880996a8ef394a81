/* The literature as the help shows it: made from the table of features and the list of places of the sources. */
#include "commands/literature.h"
#include "commands/search.h"

#include <stdio.h>
#include <string.h>

/* Longer than any key of the bibliography. */
#define KEY_SIZE 48
/* Longer than any word that is looked for, with blanks around it; what is longer is cut and not found. */
#define WORD_SIZE 64

/* Places that a search shows: no more lines than the features above them. */
#define MOST_PLACES 8

/* Columns of the help, as its manuals are written. */
#define WIDTH 92

/* The columns of a word in UTF-8. */
static int columns_of(const char *word, size_t length)
{
    int columns = 0;
    for (size_t i = 0; i < length; i++)
        columns += ((unsigned char)word[i] & 0xC0) != 0x80;
    return columns;
}

void literature_wrap(batten_text *text, const char *indent, const char *words)
{
    int column = 0;
    for (const char *at = words; *at; at += strspn(at, " ")) {
        const size_t length = strcspn(at, " ");
        const int columns = columns_of(at, length);
        if (column > 0 && column + 1 + columns > WIDTH) {
            batten_text_add(text, "\n%s", indent);
            column = (int)strlen(indent);
        } else if (column > 0) {
            batten_text_add(text, " ");
            column++;
        }
        batten_text_bytes(text, at, length);
        column += columns;
        at += length;
    }
    batten_text_add(text, "\n");
}

/* ---- the sources of a feature ---- */

/* The key of the source at '[', and how many bytes it has; what stands behind it up to ']' is a place. */
static size_t key_at(const char *at, char *key)
{
    size_t length = strcspn(at + 1, " ]");
    if (length >= KEY_SIZE)
        length = KEY_SIZE - 1;
    memcpy(key, at + 1, length);
    key[length] = 0;
    return length;
}

/* Is this the first time that the source stands in the line? */
static bool is_first(const char *source, const char *at, const char *key)
{
    char other[KEY_SIZE];
    for (const char *before = source; (before = strchr(before, '[')) && before < at; before++) {
        key_at(before, other);
        if (strcmp(key, other) == 0)
            return false;
    }
    return true;
}

/* All places of one source: ", section VI.3, section VI.8". */
static void add_places_of(batten_text *text, const char *source, const char *key)
{
    char other[KEY_SIZE];
    for (const char *at = source; (at = strchr(at, '[')); at++) {
        const size_t length = key_at(at, other), whole = strcspn(at + 1, "]");
        if (strcmp(key, other) == 0 && whole > length)
            batten_text_add(text, ", %.*s", (int)(whole - length - 1), at + length + 2);
    }
}

/* One source with its places, in lines. */
static void add_source(batten_text *text, const char *source, const char *key)
{
    batten_text line = BATTEN_TEXT;
    char *words = NULL;
    const batten_source *spelt = batten_source_find(key);
    batten_text_add(&line, "%s", spelt ? spelt->citation : key);
    add_places_of(&line, source, key);
    batten_text_add(text, "  ");
    if (batten_text_take(&line, &words, NULL) == BATTEN_OK)
        literature_wrap(text, "      ", words);
    batten_release(words);
}

void literature_add_sources(batten_text *text, const batten_feature *feature)
{
    char key[KEY_SIZE];
    const char *source = feature->source ? feature->source : "";
    for (const char *at = source; (at = strchr(at, '[')); at++) {
        key_at(at, key);
        if (is_first(source, at, key))
            add_source(text, source, key);
    }
}

/* ---- the places of the sources ---- */

/* The names of the features that stand on a place, with commas and marks around them; how many. */
static int add_features(batten_text *text, const batten_source_place *place, const char *mark)
{
    int count = 0;
    for (int i = 0; i < batten_feature_count(); i++)
        if (batten_feature_has_place(batten_feature_at(i), place))
            batten_text_add(text, "%s%s%s%s", count++ ? ", " : "", mark,
                            batten_feature_at(i)->name, mark);
    return count;
}

/* The citation, the number and the subject of a place as plain words between blanks; yours to batten_release. */
static char *words_of(const batten_source_place *place)
{
    batten_text all = BATTEN_TEXT, padded = BATTEN_TEXT;
    char *text = NULL, *words = NULL;
    const batten_source *source = batten_source_find(place->key);
    batten_text_add(&all, "%s %s %s", source ? source->citation : "", place->place,
                    place->subject);
    if (batten_text_take(&all, &text, NULL) != BATTEN_OK)
        return NULL;
    char *plain = search_plain(text);
    batten_text_add(&padded, " %s ", plain ? plain : "");
    (void)batten_text_take(&padded, &words, NULL);
    batten_release(plain);
    batten_release(text);
    return words;
}

/* Do all the words stand in the place, its source or its subject? */
static bool place_has(const batten_source_place *place, const char *words)
{
    char *text = words_of(place), word[WORD_SIZE];
    bool has = text && *words;
    for (const char *at = words; has && *at; at += strspn(at, " ")) {
        const size_t length = strcspn(at, " ");
        snprintf(word, sizeof word, " %.*s ", (int)length, at);
        has = strstr(text, word) != NULL;
        at += length;
    }
    batten_release(text);
    return has;
}

static void add_place(batten_text *text, const batten_source_place *place)
{
    const batten_source *source = batten_source_find(place->key);
    batten_text_add(text, "  %s (%s): ", place->place, place->subject);
    if (add_features(text, place, "") == 0)
        batten_text_add(text, "%s", place->without ? place->without : "no feature");
    batten_text_add(text, "\n      of %s\n", source ? source->citation : place->key);
}

int literature_add_places(batten_text *text, const char *words)
{
    int found = 0;
    for (int i = 0; i < batten_source_place_count(); i++)
        if (place_has(batten_source_place_at(i), words)) {
            if (found == 0)
                batten_text_add(text, "\n");
            if (found++ < MOST_PLACES)
                add_place(text, batten_source_place_at(i));
        }
    if (found > MOST_PLACES)
        batten_text_add(text, "  and %d more places: 'batten help --as literature' lists all\n",
                        found - MOST_PLACES);
    return found;
}

/* ---- the index ---- */

static void add_place_rows(batten_text *text)
{
    const char *key = "";
    for (int i = 0; i < batten_source_place_count(); i++) {
        const batten_source_place *place = batten_source_place_at(i);
        const batten_source *source = batten_source_find(place->key);
        if (strcmp(key, place->key) != 0)
            batten_text_add(text,
                            "\n## %s\n\n%s.\n\n| place | subject | feature |\n|---|---|---|\n",
                            place->key, source ? source->citation : "");
        key = place->key;
        batten_text_add(text, "| %s | %s | ", place->place, place->subject);
        const int count = add_features(text, place, "`");
        batten_text_add(text, "%s |\n", count == 0 && place->without ? place->without : "");
    }
}

static void add_feature_rows(batten_text *text)
{
    batten_text_add(
        text,
        "\n## Every feature and its sources\n\n| feature | other names | sources |\n|---|---|---|\n");
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        batten_text_add(text, "| `%s` | %s | %s |\n", f->name, f->also ? f->also : "",
                        f->source ? f->source : "");
    }
}

void literature_page(batten_text *text)
{
    batten_text_add(
        text,
        "# The literature and its features\n\n"
        "Made by `batten help --as literature` from the table of features; a test holds it true.\n"
        "`batten help` followed by a name, an author or a place finds the same: `batten help clothoid`,\n"
        "`batten help section III.6`, `batten help paper 10`, `batten help formula 12.7.14`.\n"
        "The keys are those of [bibliography.bib](bibliography.bib).\n");
    add_place_rows(text);
    add_feature_rows(text);
}
