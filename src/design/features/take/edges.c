/* The feature 'edges': the edges of bodies and surfaces as curves. */
#include "design/feature.h"

#include <stdio.h>

typedef enum { ALL, FREE, SHARED } which_word;

static const batten_parameter parameters[] = {
    {"edges", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "bodies, surfaces"},
    {"which", BATTEN_VALUE_WORD, false, false, "all", "all free shared",
     "free: of one face, the rim of a sheet; shared: of two or more"},
};

/* How many faces go along each edge; a seam counts twice. */
static int *count_uses(const batten_body_parts *parts)
{
    int *uses = bat_array((size_t)parts->edge_count, sizeof *uses);
    for (int i = 0; uses && i < parts->edge_count; i++)
        uses[i] = 0;
    for (int i = 0; uses && i < parts->use_count; i++)
        uses[parts->uses[i].edge]++;
    return uses;
}

static bool is_wanted(int uses, which_word which)
{
    return which == ALL || (which == FREE ? uses == 1 : uses > 1);
}

static batten_status add_edge(bat_run *run, const batten_object *object,
                              const batten_curve *edge, int number)
{
    char name[260];
    batten_object named = *object;
    batten_curve *curve = NULL;
    snprintf(name, sizeof name, "%.200s.%d", object->name, number);
    named.name = name;
    named.body = NULL;
    const batten_status status = batten_curve_to_dimension(edge, 3, &curve);
    return bat_put_curve_like(run, status, curve, &named, false);
}

/* Edges keep their numbers, whichever are wanted; those at poles have no curve. */
static batten_status add_edges(bat_run *run, const batten_object *object,
                               const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    const which_word which = (which_word)bat_word(run, "which");
    int *uses = count_uses(parts);
    batten_status status = uses ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < parts->edge_count && status == BATTEN_OK; i++)
        if (parts->edges[i].curve && is_wanted(uses[i], which))
            status = add_edge(run, object, parts->edges[i].curve, i + 1);
    bat_release(uses);
    return status;
}

static batten_status edges_of(bat_run *run, const batten_object *object)
{
    batten_body *body = NULL;
    if (object->kind == BATTEN_OBJECT_BODY)
        return add_edges(run, object, object->body);
    batten_status status =
        batten_body_from_surface(object->name, object->surface, bat_tolerance(run), &body);
    if (status == BATTEN_OK)
        status = add_edges(run, object, body);
    batten_body_unref(body);
    return status;
}

static batten_status put_edges_of(bat_run *run, const batten_object *shape)
{
    const int before = batten_model_count(run->model);
    const batten_status status = edges_of(run, shape);
    if (status == BATTEN_OK && batten_model_count(run->model) == before)
        bat_note(run, "'%s' has no such edges", shape->name);
    return status;
}

static batten_status run_edges(bat_run *run)
{
    batten_status status =
        bat_for_objects(run, "edges", BAT_BODIES | BAT_SURFACES, put_edges_of);
    if (status == BATTEN_OK && batten_model_count(run->model) == 0)
        status = bat_fail(BATTEN_NOT_FOUND, "there are no such edges");
    return status;
}

const bat_feature bat_feature_edges = {
    .shown =
        {"edges", "The edges of bodies and surfaces as curves",
         "Each edge once, named by its number in the body: 'block.7'. The edges of a surface are\n"
         "its border; borders that are the same curve are one edge, used twice and so shared.",
         "features:\n"
         "  tank: {cylinder: 0.4 m, height: 1 m}\n"
         "  rims: {edges: tank, which: free}\n",
         "[Part42]", "batten_body_view", BAT_PARAMETERS(parameters), false,
         .also = "border, boundary curves, extract edges"},
    .run = run_edges,
    .displacing = "edges"};
