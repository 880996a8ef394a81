/* Where the objects of a check come from: the features with their points, and rows of these. */
#include "design/outputs/fairness.h"
#include "design/shared/rows.h"

#include <batten/continuity.h>
#include <string.h>

/* ---- data ---- */

/* Has it points that it comes near? Control points of a curve are none. */
static bool has_data(const batten_model *model)
{
    for (int i = 0; model && i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE ||
            (object->point_count && !object->points_are_vertices))
            return true;
    }
    return false;
}

/* Does it consist of curves alone that leave their points? */
static bool leaves_points(const batten_model *model)
{
    const int count = model ? batten_model_count(model) : 0;
    for (int i = 0; i < count; i++)
        if (!batten_model_object(model, i)->points_are_vertices)
            return false;
    return count > 0;
}

/* Is a parameter given, or, as "!keep", given as 'no'? */
static bool is_given(const bat_entry *entry, const char *condition)
{
    const batten_feature *shown = &entry->feature->shown;
    const bool negated = condition[0] == '!';
    for (int k = 0; k < shown->parameter_count; k++)
        if (strcmp(shown->parameters[k].name, condition + negated) == 0)
            return entry->arguments[k].count > 0 &&
                   !(negated && entry->arguments[k].items[0].count);
    return false;
}

/* Does a feature place its result away from the points of its inputs? */
static bool displaces(const bat_check *check, int feature)
{
    const bat_entry *entry = &check->run->document->features[feature];
    const char *displacing = entry->feature->displacing;
    return (displacing && is_given(entry, displacing)) ||
           leaves_points(check->run->results[feature].value);
}

/* Do the points of this parameter's features stay beside the result? */
static bool is_beside(const bat_feature *feature, const char *parameter)
{
    const size_t length = strlen(parameter);
    for (const char *at = feature->beside; at && (at = strstr(at, parameter)); at += length)
        if ((at == feature->beside || at[-1] == ' ') && (!at[length] || at[length] == ' '))
            return true;
    return false;
}

/* How a feature is met on the way up from the shape. */
typedef enum { NOT_MET, MET_BEHIND_FAIRING, MET_OPENLY } meeting;

/* What the search knows of each feature, by its index. */
typedef struct {
    meeting met;
    bool is_displacing;
    bool has_points;   /* its result has */
    bool has_upstream; /* so have those that it is made from */
    bool is_faired;    /* it, or what it is made from, was made fair */
    double moved_by;   /* by fairing: the sum of the bounds on the way here */
} ancestry;

void bat_check_visit_parents(const bat_check *check, int feature, bat_parent_visit visit,
                             void *context)
{
    const bat_entry *entry = &check->run->document->features[feature];
    const batten_feature *shown = &entry->feature->shown;
    for (int k = 0; k < shown->parameter_count; k++) {
        const batten_parameter *parameter = &shown->parameters[k];
        for (int i = 0; i < entry->arguments[k].count; i++) {
            const bat_item *item = &entry->arguments[k].items[i];
            if (bat_item_is_feature(parameter->kind, item) && item->count >= 0 &&
                !is_beside(entry->feature, parameter->name))
                visit(context, item->count, feature);
        }
    }
}

typedef struct {
    ancestry *all;
    void (*visit)(ancestry *parent, ancestry *child);
} kinship;

static void visit_kin(void *context, int parent, int child)
{
    const kinship *kin = context;
    kin->visit(&kin->all[parent], &kin->all[child]);
}

/* Calls `visit` for each feature whose points come to lie on the result of this one. */
static void visit_parents(const bat_check *check, int feature, ancestry *all,
                          void (*visit)(ancestry *parent, ancestry *child))
{
    kinship kin = {all, visit};
    bat_check_visit_parents(check, feature, visit_kin, &kin);
}

static void inherit(ancestry *parent, ancestry *child)
{
    child->has_upstream |= parent->has_points || parent->has_upstream;
    child->is_faired |= parent->is_faired;
    child->moved_by = bat_max(child->moved_by, parent->moved_by);
}

static void meet_behind_fairing(ancestry *parent, ancestry *child)
{
    (void)child;
    parent->met = parent->met == MET_OPENLY ? MET_OPENLY : MET_BEHIND_FAIRING;
}

static void meet_alike(ancestry *parent, ancestry *child)
{
    parent->met = parent->met == MET_OPENLY ? MET_OPENLY : child->met;
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

/* The parameter 'within' of a feature that makes fair or lofts. */
static double sum_within(const bat_entry *entry)
{
    double sum = 0;
    const batten_feature *shown = &entry->feature->shown;
    for (int k = 0; k < shown->parameter_count; k++)
        if (strcmp(shown->parameters[k].name, "within") == 0 && entry->arguments[k].count)
            sum += entry->arguments[k].items[0].number[0];
    return sum;
}

/* Down the order of the document: what each feature has of those that it is made from. */
static void look_down(const bat_check *check, ancestry *all)
{
    const bat_document *d = check->run->document;
    for (int k = 0; k < d->feature_count; k++) {
        const int i = d->order[k];
        const batten_feature_result *result = &check->run->results[i].shown;
        ancestry *own = &all[i];
        if (!d->features[i].feature || !d->features[i].arguments)
            continue;
        visit_parents(check, i, all, inherit);
        own->is_displacing = displaces(check, i);
        own->has_points = has_data(check->run->results[i].value);
        own->has_upstream &= !own->is_displacing;
        own->is_faired |= result->has_moves;
        if (result->has_moves || result->loft)
            own->moved_by += sum_within(&d->features[i]);
    }
}

/* Up from the shape, as far as points lie on it: a feature that displaces ends the way. */
static void look_up(const bat_check *check, int feature, ancestry *all)
{
    const bat_document *d = check->run->document;
    all[feature].met = MET_OPENLY;
    for (int k = d->feature_count - 1; k >= 0; k--) {
        const int i = d->order[k];
        if (all[i].met && !all[i].is_displacing)
            visit_parents(check, i, all,
                          check->run->results[i].shown.has_moves ? meet_behind_fairing
                                                                 : meet_alike);
    }
}

/* The points given are those of the first features that have any; those after fairing are of the
 * last. Points that were displaced after fairing are faired ones. */
static bool find_root(const bat_check *check, int feature, const ancestry *own,
                      bat_data_root *root)
{
    const bool is_last = check->run->results[feature].shown.has_moves && own->met == MET_OPENLY;
    const bool is_first = !own->has_upstream;
    *root = (bat_data_root){feature, own->is_faired, own->met == MET_OPENLY, NULL};
    return own->met && own->has_points && (is_first || is_last);
}

/* First the points given, then those after fairing, each in the order of the document. */
static batten_status collect_roots(bat_check *check, const ancestry *all, bat_data_roots *out)
{
    const bat_document *d = check->run->document;
    bat_data_root root;
    int count = 0;
    for (int i = 0; i < d->feature_count; i++)
        count += find_root(check, i, &all[i], &root);
    out->at = bat_arena_array(&check->arena, (size_t)count, sizeof *out->at);
    if (!out->at)
        return BATTEN_OUT_OF_MEMORY;
    for (int faired = 0; faired < 2; faired++)
        for (int k = 0; k < d->feature_count; k++)
            if (find_root(check, d->order[k], &all[d->order[k]], &root) &&
                root.is_faired == (bool)faired)
                out->at[out->count++] = root;
    return BATTEN_OK;
}

/* The features whose results the points come to lie on. */
static batten_status keep_passed(bat_check *check, int feature, const ancestry *all,
                                 bat_data_roots *roots)
{
    const int count = check->run->document->feature_count;
    roots->feature = feature;
    roots->passed = bat_arena_array(&check->arena, (size_t)count, sizeof *roots->passed);
    for (int i = 0; i < count && roots->passed; i++)
        roots->passed[i] = all[i].met && !all[i].is_displacing;
    return roots->passed ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* How far the points of a feature's result may have been moved, and which they are. */
static batten_status find_data(bat_check *check, int feature, bat_data_roots *roots,
                               double *moved_by)
{
    ancestry *all = bat_array((size_t)check->run->document->feature_count, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    look_down(check, all);
    look_up(check, feature, all);
    *moved_by = all[feature].moved_by;
    batten_status status = collect_roots(check, all, roots);
    if (status == BATTEN_OK)
        status = keep_passed(check, feature, all, roots);
    bat_release(all);
    return status;
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

/* The data of the objects that come of one feature of the argument: the `count` from `first` on. */
static batten_status trace_feature(bat_check *check, bat_graph *graph, int feature, int first,
                                   int count)
{
    const int feature_count = check->run->document->feature_count;
    bool *upstream = bat_array((size_t)feature_count, sizeof *upstream);
    batten_status status =
        upstream ? bat_graph_mark(graph, feature, upstream) : BATTEN_OUT_OF_MEMORY;
    bat_data_roots roots = {0};
    double moved_by = 0;
    if (status == BATTEN_OK)
        status = find_data(check, feature, &roots, &moved_by);
    for (int i = 0; status == BATTEN_OK && i < feature_count; i++)
        check->upstream[i] |= upstream[i];
    for (int i = first; status == BATTEN_OK && i < first + count; i++) {
        check->objects[i].data = roots;
        check->objects[i].is_hull = has_table(check, upstream);
        check->objects[i].moved_by = moved_by;
        check->objects[i].panels_of = find_panels(check, upstream);
    }
    bat_release(upstream);
    return status;
}

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

/* Every row of the points given. */
static batten_status visit_given_rows(const bat_check *check, const bat_checked *checked,
                                      bat_row_visit visit, void *context)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < checked->data.count && status == BATTEN_OK; i++)
        if (!checked->data.at[i].is_faired)
            status =
                bat_check_visit_rows(check, checked->data.at[i].feature, true, visit, context);
    return status;
}

bool bat_check_is_faired(const bat_checked *checked)
{
    const bat_data_roots *roots = &checked->data;
    return roots->count > 0 && roots->at[roots->count - 1].is_faired;
}

batten_status bat_check_given_row(const bat_check *check, const bat_checked *checked, int count,
                                  const double *row, int axis, double **points, double *bound)
{
    row_search search = {count, row, checked->moved_by, axis, NULL};
    batten_status status = BATTEN_OK;
    if (bat_check_is_faired(checked))
        status = visit_given_rows(check, checked, match_row, &search);
    *bound = search.found ? checked->moved_by : 0;
    if (status == BATTEN_OK && !search.found)
        search.found = bat_points_in_plane(axis, count, row);
    *points = search.found;
    return status == BATTEN_OK && !search.found ? BATTEN_OUT_OF_MEMORY : status;
}
