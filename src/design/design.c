/* A design in memory: its text and document, edits that keep results, and the evaluation of its
 * features and outputs. */
#include "design/state.h"
#include "design/text/edit.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

batten_design_options batten_design_defaults(void)
{
    return (batten_design_options){.size = sizeof(batten_design_options), .file_name = ""};
}

/* ---- states ---- */

void bat_result_release(bat_result *result)
{
    batten_model_unref(result->value);
    batten_fair_report_release(&result->fairing);
    batten_loft_report_release(&result->loft);
    *result = (bat_result){0};
}

static void release_state(bat_design_state *s)
{
    for (int i = 0; s->results && i < s->document.feature_count; i++)
        bat_result_release(&s->results[i]);
    bat_release(s->results);
    bat_release(s->evaluated);
    bat_release(s->outcomes);
    bat_document_free(&s->document);
    bat_release(s->text);
    *s = (bat_design_state){0};
}

static batten_status make_results(bat_design_state *made)
{
    const size_t count = (size_t)made->document.feature_count;
    made->results = bat_array(count, sizeof *made->results);
    made->evaluated = bat_array(count, sizeof *made->evaluated);
    made->outcomes = bat_array((size_t)made->document.output_count, sizeof *made->outcomes);
    if (!made->results || !made->evaluated || !made->outcomes)
        return BATTEN_OUT_OF_MEMORY;
    return BATTEN_OK;
}

/* Parse a text, which becomes the bat_design_state's own; on failure it is released. */
static batten_status make_state(const batten_design *design, char *text, size_t length,
                                batten_notes *notes, bat_design_state *out)
{
    const batten_design_options options = {.size = sizeof options,
                                           .file_name = design->file_name,
                                           .allow_outside = design->allow_outside,
                                           .limits = &design->limits,
                                           .provided_file = design->provided_file,
                                           .provided = design->provided};
    bat_design_state made = {.text = text, .length = length};
    batten_status status =
        bat_document_parse(text, length, &options, &bat_all_features, notes, &made.document);
    if (status == BATTEN_OK)
        status = make_results(&made);
    if (status == BATTEN_OK)
        *out = made;
    else
        release_state(&made);
    return status;
}

static char *copy_bytes(const char *bytes, size_t length)
{
    char *copy = bat_array(length + 1, 1);
    if (copy && length)
        memcpy(copy, bytes, length);
    return copy;
}

static batten_status keep_provided(batten_design *design, const batten_design_options *given)
{
    design->provided_file = copy_bytes(given->provided_file, strlen(given->provided_file));
    design->provided = batten_model_ref(given->provided);
    return design->provided_file ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status batten_design_parse(const char *text, size_t length,
                                  const batten_design_options *options, batten_notes *notes,
                                  batten_design **out)
{
    batten_design_options given = batten_design_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_design_options, options, &given);
    batten_limits limits = batten_limits_defaults();
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_limits, given.limits, &limits);
    if (status != BATTEN_OK)
        return status;
    const char *file = given.file_name ? given.file_name : "";
    batten_design *design = bat_array(1, sizeof *design);
    if (!design)
        return BATTEN_OUT_OF_MEMORY;
    design->allow_outside = given.allow_outside;
    design->limits = limits;
    design->file_name = copy_bytes(file, strlen(file));
    char *copy = copy_bytes(text, length);
    status = design->file_name && copy ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && given.provided)
        status = keep_provided(design, &given);
    if (status == BATTEN_OK)
        status = make_state(design, copy, length, notes, &design->now);
    else
        bat_release(copy);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

batten_status batten_design_open(const char *path, bool allow_outside, batten_notes *notes,
                                 batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = path;
    options.allow_outside = allow_outside;
    char *text = NULL;
    size_t length = 0;
    batten_status status =
        batten_load_file(path, batten_limits_defaults().file_bytes, &text, &length);
    if (status == BATTEN_OK)
        status = batten_design_parse(text, length, &options, notes, out);
    bat_release(text);
    return status;
}

void batten_design_free(batten_design *design)
{
    if (!design)
        return;
    release_state(&design->now);
    batten_model_unref(design->provided);
    bat_release(design->provided_file);
    bat_release(design->file_name);
    bat_release(design);
}

const char *batten_design_text(const batten_design *design, size_t *length)
{
    if (length)
        *length = design->now.length;
    return design->now.text;
}

int batten_design_parameter_count(const batten_design *design)
{
    return design->now.document.parameter_count;
}

const char *batten_design_parameter_name(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.document.parameter_count);
    return design->now.document.parameters[index].name;
}

static void count_files(const bat_entry *entry, int index, int *count, const char **path)
{
    const batten_feature *f = &entry->feature->shown;
    for (int k = 0; k < f->parameter_count; k++) {
        const bat_argument *a = &entry->arguments[k];
        for (int m = 0; f->parameters[k].kind == BATTEN_VALUE_FILE && m < a->count; m++)
            if ((*count)++ == index)
                *path = a->items[m].text;
    }
}

/* How many files features name; `path` receives the one at `index`, as it is written. */
static int find_file(const bat_document *d, int index, const char **path)
{
    int count = 0;
    for (int i = 0; i < d->feature_count; i++)
        count_files(&d->features[i], index, &count, path);
    return count;
}

int batten_design_file_count(const batten_design *design)
{
    return find_file(&design->now.document, -1, NULL);
}

batten_status batten_design_file_path(const batten_design *design, int index, char **path)
{
    const char *written = NULL;
    const int count = find_file(&design->now.document, index, &written);
    assert(index >= 0 && index < count);
    (void)count;
    return bat_path_beside(&design->now.document, written, path);
}

double batten_design_unit_metres(const batten_design *design)
{
    return design->now.document.unit_metres;
}

/* ---- what stays true after an edit ---- */

static bool same_text(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

/* For a model: the same feature, and its value was kept. */
static bool same_item(const bat_design_state *now, batten_value_kind kind, const bat_item *a,
                      const bat_item *b)
{
    if (bat_item_is_feature(kind, a))
        return same_text(a->text, b->text) && b->count >= 0 && now->results[b->count].done;
    return memcmp(a->number, b->number, sizeof a->number) == 0 && a->count == b->count &&
           same_text(a->text, b->text);
}

static bool same_argument(const bat_design_state *now, batten_value_kind kind,
                          const bat_argument *x, const bat_argument *y)
{
    if (x->count != y->count || x->given != y->given)
        return false;
    for (int k = 0; k < x->count; k++)
        if (!same_item(now, kind, &x->items[k], &y->items[k]))
            return false;
    return true;
}

static bool same_entry(const bat_design_state *now, const bat_entry *a, const bat_entry *b)
{
    if (a->feature != b->feature)
        return false;
    const batten_feature *f = &a->feature->shown;
    for (int i = 0; i < f->parameter_count; i++)
        if (!same_argument(now, f->parameters[i].kind, &a->arguments[i], &b->arguments[i]))
            return false;
    return true;
}

/* A result knows where it stands. */
void bat_result_settle(const bat_entry *entry, bat_result *result)
{
    result->shown.name = entry->name;
    result->shown.operation = entry->feature->shown.name;
    result->shown.value = result->value;
    result->shown.fairing = result->shown.has_moves ? &result->fairing : NULL;
    if (result->shown.skin)
        result->shown.skin = &result->skin;
    if (result->shown.loft)
        result->shown.loft = &result->loft;
}

/* Move the results that an edit does not reach, inputs first. */
static void keep_results(bat_design_state *before, bat_design_state *now)
{
    const bat_document *old = &before->document, *new = &now->document;
    if (old->unit_metres != new->unit_metres || old->tolerance != new->tolerance)
        return;
    for (int i = 0; i < new->feature_count; i++) {
        const int at = new->order[i];
        const int was = bat_document_feature(old, new->features[at].name);
        if (was < 0 || !before->results[was].done ||
            !same_entry(now, &old->features[was], &new->features[at]))
            continue;
        now->results[at] = before->results[was];
        before->results[was] = (bat_result){0};
        bat_result_settle(&new->features[at], &now->results[at]);
        now->evaluated[now->evaluated_count++] = at;
    }
}

batten_status batten_design_set(batten_design *design, const char *path, const char *value,
                                batten_notes *notes)
{
    char *text = NULL;
    size_t length = 0;
    bat_design_state after = {0};
    batten_status status =
        bat_edit(design->now.text, design->now.length, &design->now.document.tree,
                 design->limits.nesting, path, value, &text, &length);
    if (status == BATTEN_OK)
        status = make_state(design, text, length, notes, &after);
    if (status != BATTEN_OK)
        return status;
    keep_results(&design->now, &after);
    release_state(&design->now);
    design->now = after;
    return BATTEN_OK;
}
