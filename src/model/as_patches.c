/* Triangles as tensor patches, for formats and pictures that know no others. */
#include "model/definitions.h"
#include "model/rebuild.h"

#include <batten/model.h>
#include <stdio.h>
#include <string.h>

enum { MOST_PATCHES = 1000000 };

static int patches_of_one(batten_patches patches)
{
    return patches == BATTEN_PATCHES_REGULAR ? 3 : 1;
}

/* Add one triangle's patches; `number` is that of the last one. */
static batten_status add_triangle(batten_model *made, const batten_object *object, int triangle,
                                  batten_patches patches, int *number, char *name, size_t size)
{
    batten_surface *surfaces[3] = {NULL, NULL, NULL};
    batten_status status =
        patches == BATTEN_PATCHES_REGULAR
            ? batten_triangles_to_patches(object->triangles, triangle, surfaces)
            : batten_triangles_to_pole_patch(object->triangles, triangle, &surfaces[0]);
    for (int i = 0; i < patches_of_one(patches) && status == BATTEN_OK; i++) {
        snprintf(name, size, "%s.%d", object->name, ++*number);
        batten_object patch = *object;
        patch.name = name;
        patch.kind = BATTEN_OBJECT_SURFACE;
        patch.triangles = NULL;
        patch.surface = surfaces[i];
        status = batten_model_add(made, &patch);
    }
    for (int i = 0; i < 3; i++)
        batten_surface_unref(surfaces[i]);
    return status;
}

static batten_status add_triangles(batten_model *made, const batten_object *object,
                                   batten_patches patches)
{
    const int count = batten_triangles_count(object->triangles);
    if (count > MOST_PATCHES / patches_of_one(patches))
        return bat_fail(BATTEN_TOO_LARGE, "%d triangles of '%.60s' are more than %d patches",
                        count, object->name, MOST_PATCHES);
    const size_t size = strlen(object->name) + 16;
    char *name = bat_array(size, 1);
    if (!name)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    int number = 0;
    for (int t = 0; t < count && status == BATTEN_OK; t++)
        status = add_triangle(made, object, t, patches, &number, name, size);
    bat_release(name);
    return status;
}

/* Also in what the model places? */
static batten_status find_triangles(const batten_model *model, bool *found)
{
    bat_definitions d = {0};
    const batten_status status = bat_definitions_find(model, &d);
    *found = false;
    for (int i = 0; status == BATTEN_OK && i < d.count && !*found; i++)
        for (int k = 0; k < batten_model_count(d.models[i]) && !*found; k++)
            *found = batten_model_object(d.models[i], k)->kind == BATTEN_OBJECT_TRIANGLES;
    bat_definitions_end(&d);
    return status;
}

static batten_status add_patched(void *context, const batten_model *from, int index,
                                 batten_model *made, const batten_object *object)
{
    (void)from;
    (void)index;
    return object->kind == BATTEN_OBJECT_TRIANGLES
               ? add_triangles(made, object, *(const batten_patches *)context)
               : batten_model_add(made, object);
}

batten_status batten_model_with_patches(const batten_model *model, batten_patches patches,
                                        batten_model **out)
{
    bool has_triangles;
    assert(model && out);
    const batten_status status = find_triangles(model, &has_triangles);
    if (status == BATTEN_OK && has_triangles)
        return bat_model_change(model, batten_model_unit_metres(model), 1, add_patched,
                                &patches, out);
    if (status == BATTEN_OK)
        *out = batten_model_ref(model);
    return status;
}
