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

/* Is a feature's result, or what it is made from, a table of offsets? */
static bool has_table(const bat_check *check, const bool *upstream)
{
    const bat_document *d = check->run->document;
    for (int i = 0; i < d->feature_count; i++) {
        const batten_model *model = upstream[i] ? check->run->results[i].value : NULL;
        for (int k = 0; model && k < batten_model_count(model); k++)
            if (batten_model_object(model, k)->kind == BATTEN_OBJECT_OFFSET_TABLE)
                return true;
    }
    return false;
}

static double sum_within(const bat_entry *entry)
{
    double sum = 0;
    const batten_feature *shown = &entry->feature->shown;
    for (int k = 0; k < shown->parameter_count; k++)
        if (strcmp(shown->parameters[k].name, "within") == 0 && entry->arguments[k].count)
            sum += entry->arguments[k].items[0].number[0];
    return sum;
}

/* The parameter 'within' of all fairing and lofting upstream, one after the other. */
static double sum_moves(const bat_check *check, const bool *upstream)
{
    const bat_document *d = check->run->document;
    double sum = 0;
    for (int i = 0; i < d->feature_count; i++) {
        const batten_feature_result *result = &check->run->results[i].shown;
        if (upstream[i] && (result->has_moves || result->loft))
            sum += sum_within(&d->features[i]);
    }
    return sum;
}

/* The lofting upstream that makes several panels; -1 for none. */
static int find_panels(const bat_check *check, const bool *upstream)
{
    for (int i = 0; i < check->run->document->feature_count; i++) {
        const batten_feature_result *result = &check->run->results[i].shown;
        if (upstream[i] && result->loft && result->loft->panel_count > 1)
            return i;
    }
    return -1;
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
    for (int i = first; status == BATTEN_OK && i < first + count; i++) {
        check->objects[i].given = given;
        check->objects[i].faired = faired;
        check->objects[i].is_hull = given >= 0 && has_table(check, upstream);
        check->objects[i].moved_by = sum_moves(check, upstream);
        check->objects[i].panels_of = find_panels(check, upstream);
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

/* ---- rows before fairing ---- */

typedef struct {
    int count;
    const double *row; /* [count][3] */
    double bound;
    int axis;
    double *found; /* in the plane; to release */
} row_search;

static bool is_within(int count, const double *points, const double *others, double most)
{
    for (int i = 0; i < count; i++) {
        const double *p = points + 3 * i, *q = others + 3 * i;
        if (bat_hypot(bat_hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]) > most)
            return false;
    }
    return true;
}

static batten_status match_row(void *context, const bat_row *given)
{
    row_search *search = context;
    /* Fairing keeps its bound to a few roundings. */
    const double most = search->bound * (1 + 1e-9);
    if (search->found || given->count != search->count)
        return BATTEN_OK;
    if (!is_within(search->count, given->points, search->row, most))
        return BATTEN_OK;
    search->found = bat_points_in_plane(search->axis, given->count, given->points);
    return search->found ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_check_given_row(const bat_check *check, const bat_checked *checked, int count,
                                  const double *row, int axis, double **points, double *bound)
{
    row_search search = {count, row, checked->moved_by, axis, NULL};
    batten_status status = BATTEN_OK;
    if (checked->faired >= 0 && checked->given >= 0)
        status = bat_check_visit_rows(check, checked->given, true, match_row, &search);
    *bound = search.found ? checked->moved_by : 0;
    if (status == BATTEN_OK && !search.found)
        search.found = bat_points_in_plane(axis, count, row);
    *points = search.found;
    return status == BATTEN_OK && !search.found ? BATTEN_OUT_OF_MEMORY : status;
}
