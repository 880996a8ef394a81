/* Where the objects of a check come from: the features with their points, and rows of these. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <string.h>

/* ---- data ---- */

static bool has_data(const batten_model *model)
{
    for (int i = 0; model && i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE || object->point_count)
            return true;
    }
    return false;
}

/* Does a feature place its result away from the points of its inputs? */
static bool displaces(const bat_entry *entry)
{
    const batten_feature *shown = &entry->feature->shown;
    const char *displacing = entry->feature->displacing;
    for (int k = 0; displacing && k < shown->parameter_count; k++)
        if (strcmp(shown->parameters[k].name, displacing) == 0)
            return entry->arguments[k].count > 0;
    return false;
}

/* The first feature upstream that has points, and the last that made points fair; none when
 * sections were displaced since, for then distances from them mean nothing. */
static void find_data(const bat_check *check, const bool *upstream, int *given, int *faired)
{
    const bat_document *d = check->run->document;
    *given = *faired = -1;
    for (int i = 0; i < d->feature_count; i++)
        if (upstream[i] && displaces(&d->features[i]))
            return;
    for (int k = 0; k < d->feature_count; k++) {
        const int i = d->order[k];
        if (!upstream[i] || !has_data(check->run->results[i].value))
            continue;
        if (check->run->results[i].shown.has_moves)
            *faired = i;
        else if (*given < 0)
            *given = i;
    }
}

/* The data of the objects that come of one feature of the argument: the `count` from `first`
 * on.
 */
static batten_status trace_feature(bat_check *check, bat_graph *graph, int feature, int first,
                                   int count)
{
    const int feature_count = check->run->document->feature_count;
    bool *upstream = bat_array((size_t)feature_count, sizeof *upstream);
    batten_status status =
        upstream ? bat_graph_mark(graph, feature, upstream) : BATTEN_OUT_OF_MEMORY;
    int given = -1, faired = -1;
    if (status == BATTEN_OK)
        find_data(check, upstream, &given, &faired);
    for (int i = 0; status == BATTEN_OK && i < feature_count; i++)
        check->upstream[i] |= upstream[i];
    for (int i = first; i < first + count; i++) {
        check->objects[i].given = given;
        check->objects[i].faired = faired;
    }
    bat_release(upstream);
    return status;
}

/* What each object was made from; the objects stand in the order of the argument. */
batten_status bat_check_trace(bat_check *check, const char *parameter)
{
    const bat_argument *argument = bat_argument_of(check->run, parameter);
    bat_graph graph;
    check->upstream = bat_arena_array(
        &check->arena, (size_t)check->run->document->feature_count, sizeof *check->upstream);
    if (!check->upstream)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_document_graph(check->run->document, &graph);
    if (status != BATTEN_OK)
        return status;
    int first = 0;
    for (int i = 0; i < argument->count && status == BATTEN_OK; i++) {
        const int feature = argument->items[i].count;
        const int count = batten_model_count(check->run->results[feature].value);
        status = trace_feature(check, &graph, feature, first, count);
        first += count;
    }
    assert(status != BATTEN_OK || first == check->object_count);
    bat_graph_release(&graph);
    return status;
}

/* ---- rows of a feature ---- */

static batten_status visit_object(const batten_object *object, bool lines, bat_row_visit visit,
                                  void *context)
{
    bat_rows rows = {0, NULL};
    batten_status status = bat_rows_of(object, lines, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++)
        status = visit(context, &rows.rows[i]);
    bat_rows_release(&rows);
    return status;
}

/* Every row of a feature; the lines of a table too when `with_lines`. */
batten_status bat_check_visit_rows(const bat_check *check, int feature, bool with_lines,
                                   bat_row_visit visit, void *context)
{
    const batten_model *model = check->run->results[feature].value;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        status = visit_object(object, false, visit, context);
        if (status == BATTEN_OK && with_lines && object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            status = visit_object(object, true, visit, context);
    }
    return status;
}
