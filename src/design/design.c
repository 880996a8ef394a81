/* A design in memory: its text and document, edits that keep results, and the evaluation of its
 * features and outputs. */
#include "base/system.h"
#include "design/text/document.h"
#include "design/text/edit.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* Of an output when it was last made. */
typedef struct {
    bool unmet, partly; /* a bound; of what is there */
} outcome;

/* A text, what it says, and the results so far. An edit makes another of these. */
typedef struct {
    char *text;
    size_t length;
    bat_document document;
    bat_result *results; /* [feature_count] */
    int *evaluated;      /* [feature_count] in the order of evaluation */
    int evaluated_count;
    outcome *outcomes; /* [output_count] */
} state;

struct batten_design {
    char *file_name;
    bool allow_outside;
    batten_limits limits;
    char *provided_file;
    batten_model *provided;
    state now;
};

batten_design_options batten_design_defaults(void)
{
    return (batten_design_options){.size = sizeof(batten_design_options), .file_name = ""};
}

/* ---- states ---- */

static void release_result(bat_result *result)
{
    batten_model_unref(result->value);
    batten_fair_report_release(&result->fairing);
    *result = (bat_result){0};
}

static void release_state(state *s)
{
    for (int i = 0; s->results && i < s->document.feature_count; i++)
        release_result(&s->results[i]);
    bat_release(s->results);
    bat_release(s->evaluated);
    bat_release(s->outcomes);
    bat_document_free(&s->document);
    bat_release(s->text);
    *s = (state){0};
}

/* Parse a text, which becomes the state's own; on failure it is released. */
static batten_status make_state(const batten_design *design, char *text, size_t length,
                                batten_notes *notes, state *out)
{
    const batten_design_options options = {.size = sizeof options,
                                           .file_name = design->file_name,
                                           .allow_outside = design->allow_outside,
                                           .limits = &design->limits,
                                           .provided_file = design->provided_file,
                                           .provided = design->provided};
    state made = {.text = text, .length = length};
    batten_status status = bat_document_parse(text, length, &options, notes, &made.document);
    if (status == BATTEN_OK) {
        const size_t count = (size_t)made.document.feature_count;
        made.results = bat_array(count, sizeof *made.results);
        made.evaluated = bat_array(count, sizeof *made.evaluated);
        made.outcomes = bat_array((size_t)made.document.output_count, sizeof *made.outcomes);
        if (!made.results || !made.evaluated || !made.outcomes)
            status = BATTEN_OUT_OF_MEMORY;
    }
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

/* How many files features name; `path` receives the one at `index`, as it is written. */
static int find_file(const bat_document *d, int index, const char **path)
{
    int count = 0;
    for (int i = 0; i < d->feature_count; i++) {
        const batten_feature *f = &d->features[i].feature->shown;
        for (int k = 0; k < f->parameter_count; k++) {
            const bat_argument *a = &d->features[i].arguments[k];
            for (int m = 0; f->parameters[k].kind == BATTEN_VALUE_FILE && m < a->count; m++)
                if (count++ == index)
                    *path = a->items[m].text;
        }
    }
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
static bool same_item(const state *now, batten_value_kind kind, const bat_item *a,
                      const bat_item *b)
{
    if (bat_item_is_feature(kind, a))
        return same_text(a->text, b->text) && b->count >= 0 && now->results[b->count].done;
    return memcmp(a->number, b->number, sizeof a->number) == 0 && a->count == b->count &&
           same_text(a->text, b->text);
}

static bool same_entry(const state *now, const bat_entry *a, const bat_entry *b)
{
    if (a->feature != b->feature)
        return false;
    const batten_feature *f = &a->feature->shown;
    for (int i = 0; i < f->parameter_count; i++) {
        const bat_argument *x = &a->arguments[i], *y = &b->arguments[i];
        if (x->count != y->count || x->given != y->given)
            return false;
        for (int k = 0; k < x->count; k++)
            if (!same_item(now, f->parameters[i].kind, &x->items[k], &y->items[k]))
                return false;
    }
    return true;
}

/* A result knows where it stands. */
static void settle(const bat_entry *entry, bat_result *result)
{
    result->shown.name = entry->name;
    result->shown.operation = entry->feature->shown.name;
    result->shown.value = result->value;
    result->shown.fairing = result->shown.has_moves ? &result->fairing : NULL;
    if (result->shown.skin)
        result->shown.skin = &result->skin;
}

/* Move the results that an edit does not reach, inputs first. */
static void keep_results(state *before, state *now)
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
        settle(&new->features[at], &now->results[at]);
        now->evaluated[now->evaluated_count++] = at;
    }
}

batten_status batten_design_set(batten_design *design, const char *path, const char *value,
                                batten_notes *notes)
{
    char *text = NULL;
    size_t length = 0;
    state after = {0};
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

/* ---- watching ---- */

/* The caller's job, with progress counted over all features. */
typedef struct {
    const batten_job *outer;
    double begin, share;
} watch;

static bool watch_cancelled(void *user)
{
    const watch *w = user;
    return w->outer->is_cancelled(w->outer->user);
}

static void watch_progress(void *user, double fraction, const char *what)
{
    const watch *w = user;
    w->outer->progress(w->outer->user, w->begin + w->share * fraction, what);
}

static batten_job watched_job(watch *w)
{
    batten_job job = *w->outer;
    job.user = w;
    job.is_cancelled = w->outer->is_cancelled ? watch_cancelled : NULL;
    job.progress = w->outer->progress ? watch_progress : NULL;
    return job;
}

/* ---- evaluation ---- */

/* Put the place and the feature before the message of the last failure. */
static batten_status fail_at(const bat_document *d, const bat_entry *entry,
                             batten_status status, batten_notes *notes)
{
    char said[600];
    snprintf(said, sizeof said, "%s", batten_message());
    const bat_node *key = &d->tree.nodes[entry->key];
    const char *operation = entry->feature->shown.name;
    char where[200];
    snprintf(where, sizeof where, "%s (%s)", entry->name, operation);
    batten_notes_add(notes, d->file_name, key->line, where, "%s", said);
    return bat_fail(status, "%s:%d:%d: %s (%s): %s", d->file_name, key->line, key->column,
                    entry->name, operation, said);
}

static bat_run begin_run(const state *s, const bat_entry *entry, const batten_job *job,
                         batten_notes *notes)
{
    return (bat_run){.name = entry->name,
                     .feature = &entry->feature->shown,
                     .family = entry->feature->family,
                     .arguments = entry->arguments,
                     .document = &s->document,
                     .results = s->results,
                     .job = job,
                     .notes = notes,
                     .line = s->document.tree.nodes[entry->key].line};
}

/* What a feature makes alone bears its name: in legends, files and reports. */
static batten_status name_alone(bat_run *run)
{
    batten_object object = *batten_model_object(run->model, 0);
    batten_model *named = NULL;
    if (strcmp(object.name, run->name) == 0)
        return BATTEN_OK;
    object.name = run->name;
    batten_status status = batten_model_create(batten_model_unit_metres(run->model), &named);
    if (status == BATTEN_OK)
        status = batten_model_add(named, &object);
    if (status != BATTEN_OK) {
        batten_model_unref(named);
        return status;
    }
    batten_model_unref(run->model);
    run->model = named;
    return BATTEN_OK;
}

static batten_status run_feature(state *s, int i, const batten_job *job, batten_notes *notes)
{
    const bat_entry *entry = &s->document.features[i];
    bat_result *result = &s->results[i];
    bat_run run = begin_run(s, entry, job, notes);
    release_result(result);
    run.result = result;
    const double begin = batten_system_seconds();
    batten_status status = batten_model_create(s->document.unit_metres, &run.model);
    if (status == BATTEN_OK)
        status = entry->feature->run(&run);
    if (status == BATTEN_OK && batten_model_count(run.model) == 0)
        status = bat_fail(BATTEN_NOT_FOUND, "nothing is left");
    bool has_value = status == BATTEN_OK || status == BATTEN_PARTLY_READ;
    if (has_value && batten_model_count(run.model) == 1) {
        const batten_status named = name_alone(&run);
        status = named == BATTEN_OK ? status : named;
        has_value = named == BATTEN_OK;
    }
    if (has_value) {
        result->value = run.model;
        result->done = true;
    } else {
        batten_model_unref(run.model);
        release_result(result);
        status = fail_at(&s->document, entry, status, notes);
    }
    result->shown.status = status;
    result->shown.seconds = batten_system_seconds() - begin;
    settle(entry, result);
    return status;
}

static bool inputs_are_done(const state *s, const bat_graph *graph, int i)
{
    for (int k = graph->begin[i]; k < graph->begin[i + 1]; k++)
        if (!s->results[graph->needs[k]].done)
            return false;
    return true;
}

static void list_result(state *s, int i)
{
    for (int k = 0; k < s->evaluated_count; k++)
        if (s->evaluated[k] == i)
            return;
    s->evaluated[s->evaluated_count++] = i;
}

/* Evaluate what is wanted and not done; the first failure is returned, what does not need the
 * failed feature is done all the same. */
static batten_status run_wanted(state *s, const bat_graph *graph, const bool *wanted,
                                const batten_job *job, batten_notes *notes)
{
    batten_status first = BATTEN_OK;
    char message[1024] = "";
    const int count = s->document.feature_count;
    for (int k = 0; k < count; k++) {
        const int i = s->document.order[k];
        if (!wanted[i] || s->results[i].done || !inputs_are_done(s, graph, i))
            continue;
        watch w = {job, (double)k / count, 1.0 / count};
        const batten_job inner = job ? watched_job(&w) : BATTEN_JOB;
        if (job && job->progress)
            job->progress(job->user, w.begin, s->document.features[i].name);
        const batten_status status = run_feature(s, i, job ? &inner : NULL, notes);
        list_result(s, i);
        const bool ends = status == BATTEN_CANCELLED || status == BATTEN_OUT_OF_MEMORY;
        if (status != BATTEN_OK &&
            (ends || first == BATTEN_OK || first == BATTEN_PARTLY_READ)) {
            first = status;
            snprintf(message, sizeof message, "%s", batten_message());
        }
        if (ends)
            break;
    }
    return first == BATTEN_OK ? first : bat_fail(first, "%s", message);
}

/* A feature that is wanted and failed since the last edit, as it would again; or -1. */
static int find_failed(const state *s, const bool *wanted)
{
    for (int k = 0; k < s->document.feature_count; k++) {
        const int i = s->document.order[k];
        const bat_result *r = &s->results[i];
        const bool was_ended =
            r->shown.status == BATTEN_CANCELLED || r->shown.status == BATTEN_OUT_OF_MEMORY;
        if (wanted[i] && r->shown.name && !r->done && !was_ended)
            return i;
    }
    return -1;
}

/* @param roots [count] features; NULL: all
 * @param failed  receives a feature that failed before, or -1; NULL: all are tried again */
static batten_status evaluate(state *s, const int *roots, int count, int *failed,
                              const batten_job *job, batten_notes *notes)
{
    bat_graph graph;
    const int features = s->document.feature_count;
    batten_status status = bat_document_graph(&s->document, &graph);
    if (status != BATTEN_OK)
        return status;
    bool *wanted = bat_array((size_t)features, sizeof *wanted);
    if (!wanted)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < (roots ? count : features) && status == BATTEN_OK; i++)
        status = bat_graph_mark(&graph, roots ? roots[i] : i, wanted);
    if (status == BATTEN_OK && failed)
        *failed = find_failed(s, wanted);
    if (status == BATTEN_OK && (!failed || *failed < 0))
        status = run_wanted(s, &graph, wanted, job, notes);
    bat_release(wanted);
    bat_graph_release(&graph);
    return status;
}

batten_status batten_design_evaluate(batten_design *design, const char *feature,
                                     const batten_job *job, batten_notes *notes)
{
    if (!feature)
        return evaluate(&design->now, NULL, 0, NULL, job, notes);
    const int i = bat_document_feature(&design->now.document, feature);
    if (i < 0)
        return bat_fail(BATTEN_NOT_FOUND, "no feature of the design is named '%s'", feature);
    return evaluate(&design->now, &i, 1, NULL, job, notes);
}

/* ---- results ---- */

int batten_design_result_count(const batten_design *design)
{
    return design->now.evaluated_count;
}

const batten_feature_result *batten_design_result_at(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.evaluated_count);
    return &design->now.results[design->now.evaluated[index]].shown;
}

const batten_feature_result *batten_design_result(const batten_design *design,
                                                  const char *feature)
{
    const int i = bat_document_feature(&design->now.document, feature);
    if (i < 0 || !design->now.results[i].shown.name)
        return NULL;
    return &design->now.results[i].shown;
}

/* ---- outputs ---- */

int batten_design_output_count(const batten_design *design)
{
    return design->now.document.output_count;
}

const char *batten_design_output_name(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.document.output_count);
    return design->now.document.outputs[index].name;
}

const char *batten_design_output_operation(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.document.output_count);
    return design->now.document.outputs[index].feature->shown.name;
}

bool batten_design_output_holds(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.document.output_count);
    return !design->now.outcomes[index].unmet;
}

bool batten_design_output_is_whole(const batten_design *design, int index)
{
    assert(index >= 0 && index < design->now.document.output_count);
    return !design->now.outcomes[index].partly;
}

typedef struct {
    int *at;
    int count;
} list;

static void add_root(void *user, int feature)
{
    list *roots = user;
    if (roots->at)
        roots->at[roots->count] = feature;
    roots->count++;
}

static batten_status evaluate_inputs(state *s, const bat_entry *entry, const batten_job *job,
                                     batten_notes *notes)
{
    list roots = {NULL, 0};
    bat_entry_inputs(entry, add_root, &roots);
    roots.at = bat_array((size_t)roots.count, sizeof *roots.at);
    if (!roots.at)
        return BATTEN_OUT_OF_MEMORY;
    roots.count = 0;
    bat_entry_inputs(entry, add_root, &roots);
    int failed = -1;
    batten_status status = evaluate(s, roots.at, roots.count, &failed, job, notes);
    bat_release(roots.at);
    if (status == BATTEN_OK && failed >= 0)
        status =
            fail_at(&s->document, entry,
                    bat_fail(s->results[failed].shown.status, "it needs '%s', which failed",
                             s->document.features[failed].name),
                    notes);
    return status;
}

batten_status batten_design_output(batten_design *design, int index, const batten_job *job,
                                   batten_notes *notes, char **data, size_t *size)
{
    assert(index >= 0 && index < design->now.document.output_count);
    state *s = &design->now;
    const bat_entry *entry = &s->document.outputs[index];
    const batten_status inputs = evaluate_inputs(s, entry, job, notes);
    if (inputs != BATTEN_OK && inputs != BATTEN_PARTLY_READ)
        return inputs;
    bat_run run = begin_run(s, entry, job, notes);
    const batten_status status = entry->feature->run(&run);
    if (status != BATTEN_OK) {
        bat_release(run.data);
        return fail_at(&s->document, entry, status, notes);
    }
    s->outcomes[index] = (outcome){run.unmet, run.partly};
    *data = run.data;
    *size = run.size;
    return BATTEN_OK;
}
