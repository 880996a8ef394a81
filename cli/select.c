/* One object of a file, by its name or its path. */
#include "select.h"
#include "command.h"

#include <string.h>

/* There is no object of that name: say which are called nearly so. */
static batten_status no_object(const char *name, const batten_model *model)
{
    enum { TOLD = 5 };
    const char *near[TOLD];
    int count = 0;
    const int all = batten_model_count(model);
    const char **names = batten_array((size_t)all + 1, sizeof *names);
    batten_text list = BATTEN_TEXT;
    for (int i = 0; names && i < all; i++)
        names[i] = batten_model_object(model, i)->name;
    if (names)
        count = nearest_names(name, all, names, TOLD, near);
    for (int i = 0; i < count; i++)
        batten_text_add(&list, "%s'%.60s'", i ? ", " : "", near[i]);
    batten_release(names);
    const batten_status status = batten_fail(
        BATTEN_NOT_FOUND, "there is no object '%.60s' in the file; %s%s%s", name,
        count < all  ? "the nearest names are "
        : count > 1  ? "there are "
        : count == 1 ? "there is "
                     : "it has none",
        list.bytes ? list.bytes : "", count < all ? " ('batten info' lists all)" : "");
    batten_text_free(&list);
    return status;
}

/* A model of the object of that name alone; NULL when there is none. */
static batten_status only_object(const char *name, const batten_model *model,
                                 batten_model **chosen)
{
    const int index = batten_model_find(model, name);
    *chosen = NULL;
    if (index < 0)
        return BATTEN_OK;
    batten_status status = batten_model_create(batten_model_unit_metres(model), chosen);
    if (status == BATTEN_OK)
        status = batten_model_set_name(*chosen, name);
    if (status == BATTEN_OK)
        status = batten_model_add(*chosen, batten_model_object(model, index));
    return status;
}

/* An instance on the path to the one that is looked for. */
typedef struct {
    const batten_model *model;
    const char *rest; /* of the path, in this model */
    int next;         /* object to look at */
} step;

enum { DEEPEST = 33, MOST_STEPS = 1000000 };

/* Names may hold slashes themselves: all paths are tried. @return how many steps lead to the
 * instance of that path, each the one before `next`; 0 when there is none */
static int find_steps(const char *path, const batten_model *model, step steps[DEEPEST])
{
    int depth = 0, taken = 0;
    steps[0] = (step){model, path, 0};
    while (depth >= 0 && taken++ < MOST_STEPS) {
        step *at = &steps[depth];
        if (at->next == batten_model_count(at->model)) {
            depth--;
            continue;
        }
        const batten_object *object = batten_model_object(at->model, at->next++);
        const size_t length = strlen(object->name);
        if (object->kind != BATTEN_OBJECT_INSTANCE ||
            strncmp(at->rest, object->name, length) != 0)
            continue;
        if (!at->rest[length])
            return depth + 1;
        if (at->rest[length] == '/' && depth + 1 < DEEPEST)
            steps[++depth] = (step){object->definition, at->rest + length + 1, 0};
    }
    return 0;
}

/* The instance alone in a model called as the one that it stands in; `definition` in place of
 * what it places, unless that is NULL. */
static batten_status only_instance(const step *at, batten_model *definition, batten_model **out)
{
    batten_object object = *batten_model_object(at->model, at->next - 1);
    batten_model *made = NULL;
    if (definition)
        object.definition = definition;
    batten_status status = batten_model_create(batten_model_unit_metres(at->model), &made);
    if (status == BATTEN_OK)
        status = batten_model_set_name(made, batten_model_name(at->model));
    if (status == BATTEN_OK)
        status = batten_model_add(made, &object);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_model_unref(made);
    return status;
}

/* The instance of that path in the instances that it lies in, and nothing beside it; NULL when
 * there is none. */
static batten_status only_path(const char *path, const batten_model *model,
                               batten_model **chosen)
{
    step steps[DEEPEST];
    batten_model *inner = NULL;
    batten_status status = BATTEN_OK;
    *chosen = NULL;
    for (int k = find_steps(path, model, steps); status == BATTEN_OK && k > 0; k--) {
        batten_model *outer = NULL;
        status = only_instance(&steps[k - 1], inner, &outer);
        batten_model_unref(inner);
        inner = outer;
    }
    if (status == BATTEN_OK)
        *chosen = inner;
    return status;
}

batten_status select_object(const char *name, batten_model **model)
{
    batten_model *chosen = NULL, *flat = NULL;
    batten_status status = only_object(name, *model, &chosen);
    if (status == BATTEN_OK && !chosen)
        status = batten_model_flat(*model, &flat);
    if (status == BATTEN_OK && flat)
        status = only_object(name, flat, &chosen);
    if (status == BATTEN_OK && !chosen)
        status = only_path(name, *model, &chosen);
    if (status == BATTEN_OK && !chosen)
        status = no_object(name, flat);
    batten_model_unref(flat);
    if (status != BATTEN_OK) {
        batten_model_unref(chosen);
        return status;
    }
    batten_model_unref(*model);
    *model = chosen;
    return BATTEN_OK;
}
