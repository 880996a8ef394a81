/* The evaluation of a design: its features in the order of their needs, its outputs, and what became
 * of each. */
#include "base/system.h"
#include "design/shared/folds.h"
#include "design/state.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

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

static bat_run begin_run(const bat_design_state *s, const bat_entry *entry,
                         const batten_job *job, batten_notes *notes)
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

static batten_status make_objects(bat_run *run, const bat_entry *entry)
{
    batten_status status = batten_model_create(run->document->unit_metres, &run->model);
    if (status == BATTEN_OK)
        status = entry->feature->run(run);
    if (status == BATTEN_OK && batten_model_count(run->model) == 0)
        status = bat_fail(BATTEN_NOT_FOUND, "nothing is left");
    if (status == BATTEN_OK)
        status = bat_note_folds(run);
    return status;
}

/* @param[in,out] objects  made so far */
static batten_status run_feature(bat_design_state *s, int i, const batten_job *job,
                                 batten_notes *notes, long long *objects)
{
    const bat_entry *entry = &s->document.features[i];
    bat_result *result = &s->results[i];
    bat_run run = begin_run(s, entry, job, notes);
    bat_result_release(result);
    run.result = result;
    run.objects = *objects;
    const double begin = batten_system_seconds();
    batten_status status = make_objects(&run, entry);
    bool has_value = status == BATTEN_OK || status == BATTEN_PARTLY_READ;
    if (has_value && batten_model_count(run.model) == 1) {
        const batten_status named = name_alone(&run);
        status = named == BATTEN_OK ? status : named;
        has_value = named == BATTEN_OK;
    }
    if (has_value) {
        result->value = run.model;
        result->done = true;
        *objects += batten_model_count(run.model);
    } else {
        batten_model_unref(run.model);
        bat_result_release(result);
        status = fail_at(&s->document, entry, status, notes);
    }
    result->shown.status = status;
    result->shown.seconds = batten_system_seconds() - begin;
    bat_result_settle(entry, result);
    return status;
}

static bool inputs_are_done(const bat_design_state *s, const bat_graph *graph, int i)
{
    for (int k = graph->begin[i]; k < graph->begin[i + 1]; k++)
        if (!s->results[graph->needs[k]].done)
            return false;
    return true;
}

static long long count_objects(const bat_design_state *s)
{
    long long count = 0;
    for (int i = 0; i < s->document.feature_count; i++)
        count += s->results[i].value ? batten_model_count(s->results[i].value) : 0;
    return count;
}

static void list_result(bat_design_state *s, int i)
{
    for (int k = 0; k < s->evaluated_count; k++)
        if (s->evaluated[k] == i)
            return;
    s->evaluated[s->evaluated_count++] = i;
}

/* Evaluate what is wanted and not done; the first failure is returned, what does not need the
 * failed feature is done all the same. */
static batten_status run_wanted(bat_design_state *s, const bat_graph *graph, const bool *wanted,
                                const batten_job *job, batten_notes *notes)
{
    batten_job chosen = BATTEN_JOB;
    batten_status first = BAT_TAKE_OPTIONS(batten_job, job, &chosen);
    if (first != BATTEN_OK)
        return first;
    char message[1024] = "";
    const int count = s->document.feature_count;
    long long objects = count_objects(s);
    for (int k = 0; k < count; k++) {
        const int i = s->document.order[k];
        if (!wanted[i] || s->results[i].done || !inputs_are_done(s, graph, i))
            continue;
        watch w = {&chosen, (double)k / count, 1.0 / count};
        const batten_job inner = watched_job(&w);
        if (chosen.progress)
            chosen.progress(chosen.user, w.begin, s->document.features[i].name);
        const batten_status status = run_feature(s, i, job ? &inner : NULL, notes, &objects);
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
static int find_failed(const bat_design_state *s, const bool *wanted)
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
static batten_status evaluate(bat_design_state *s, const int *roots, int count, int *failed,
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

static batten_status evaluate_inputs(bat_design_state *s, const bat_entry *entry,
                                     const batten_job *job, batten_notes *notes)
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

batten_status batten_design_check_path(const batten_design *design, const char *folder,
                                       const char *path)
{
    assert(design && folder && path);
    return bat_path_check_inside(&design->now.document, folder, path);
}

batten_status batten_design_output(batten_design *design, int index, const batten_job *job,
                                   batten_notes *notes, char **data, size_t *size)
{
    assert(index >= 0 && index < design->now.document.output_count);
    bat_design_state *s = &design->now;
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
    s->outcomes[index] = (bat_outcome){run.unmet, run.partly};
    *data = run.data;
    *size = run.size;
    return BATTEN_OK;
}
