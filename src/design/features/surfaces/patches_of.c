/* The feature 'patches-of': Bezier triangles as NURBS surfaces. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"patches-of", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "Bezier triangles"},
    {"form", BATTEN_VALUE_WORD, false, false, "three", "three pole",
     "three patches for each triangle, or one with a pole at its first corner"},
};

/* The triangles alone; whatever else the input holds is not a patch. */
static batten_status gather_triangles(bat_run *run, batten_model *triangles)
{
    bat_objects objects;
    batten_status status = bat_gather(run, "patches-of", BAT_TRIANGLES, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = batten_model_add(triangles, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

static batten_status run_patches_of(bat_run *run)
{
    batten_model *triangles = NULL, *patches = NULL;
    batten_status status = batten_model_create(bat_unit_metres(run), &triangles);
    if (status == BATTEN_OK)
        status = gather_triangles(run, triangles);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(
            triangles, bat_word(run, "form") ? BATTEN_PATCHES_POLE : BATTEN_PATCHES_REGULAR,
            &patches);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(patches); i++)
        status = bat_add(run, batten_model_object(patches, i));
    batten_model_unref(triangles);
    batten_model_unref(patches);
    return status;
}

const bat_feature bat_feature_patches_of = {
    .shown =
        {"patches-of", "Bezier triangles as NURBS surfaces",
         "Exact, of the degree of the triangle in both directions. Three patches share the centre\n"
         "of the triangle and have no poles; with 'form: pole' there is one patch, whose side u =\n"
         "0 is the first corner.",
         "features:\n"
         "  net: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
         "  sail: {bezier-triangle: net}\n"
         "  panels: {patches-of: sail}\n",
         "[Hu96]", "batten_model_with_patches", BAT_PARAMETERS(parameters), false,
         .also = "triangle to NURBS, degenerate patch, three patches",
         .formula =
             "    the same points b(b1, b2, b3), in patches of the degree of the triangle in u and v",
         .promise = "It is exactly the same surface."},
    .run = run_patches_of};
