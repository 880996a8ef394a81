/* Arguments that are names, words and files. */
#include "design/text/argument_words.h"
#include "design/text/document.h"
#include "design/text/spelling.h"

#include <stdio.h>
#include <string.h>

static const char *operation_of(const bat_reading *r)
{
    return r->entry->feature->shown.name;
}

void bat_complain_of(const bat_reading *r, const char *what)
{
    const bool principal = strcmp(r->parameter->name, operation_of(r)) == 0;
    if (principal)
        bat_complain(r->document, r->at, "%s %s", operation_of(r), what);
    else
        bat_complain(r->document, r->at, "'%s' of %s %s", r->parameter->name, operation_of(r),
                     what);
}

/* ---- names and words ---- */

void bat_read_model(const bat_reading *r, const char *word, bat_item *item)
{
    bat_document *d = r->document;
    item->count = bat_document_feature(d, word);
    item->text = word;
    if (item->count >= 0)
        return;
    const char *near = NULL;
    int best = 99;
    for (int i = 0; i < d->feature_count; i++)
        if (bat_is_nearer(word, d->features[i].name, &best))
            near = d->features[i].name;
    bat_complain(d, r->at, "no feature is named '%.80s'%s%s%s", word,
                 near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

/* Copy word number `index` of a list with blanks between; false at its end. */
static bool word_at(const char **words, char *word, size_t size)
{
    *words += strspn(*words, " ");
    const size_t length = strcspn(*words, " ");
    if (length == 0 || length >= size)
        return false;
    memcpy(word, *words, length);
    word[length] = 0;
    *words += length;
    return true;
}

void bat_read_word(const bat_reading *r, const char *given, bat_item *item)
{
    char word[40], near[40] = "", what[400];
    const char *rest = r->parameter->words;
    int best = 99;
    item->text = given;
    item->count = -1;
    for (int i = 0; word_at(&rest, word, sizeof word); i++) {
        if (strcmp(word, given) == 0) {
            item->count = i;
            return;
        }
        if (bat_is_nearer(given, word, &best))
            snprintf(near, sizeof near, "%s", word);
    }
    snprintf(what, sizeof what, "cannot be '%.60s'%s%s%s; it is one of: %s", given,
             *near ? "; did you mean '" : "", near, *near ? "'" : "", r->parameter->words);
    bat_complain_of(r, what);
}

void bat_read_yes_no(const bat_reading *r, const char *word, bat_item *item)
{
    static const char *const words[] = {"no", "yes", "false", "true"};
    for (int i = 0; i < 4; i++)
        if (strcmp(word, words[i]) == 0) {
            item->count = i % 2;
            return;
        }
    char what[120];
    snprintf(what, sizeof what, "must be yes or no, not '%.60s'", word);
    bat_complain_of(r, what);
}

void bat_read_file(const bat_reading *r, const char *word, bat_item *item)
{
    item->text = word;
    if (!*word)
        bat_complain_of(r, "needs the name of a file");
    else if (!r->document->allow_outside && bat_path_leaves(word))
        bat_complain(
            r->document, r->at,
            "the path %.200s leads out of the folder of the design; --allow-outside allows it",
            word);
}
