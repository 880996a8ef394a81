/* Surfaces that fold over, or have spans too short to be of use, as features make them. */
#include "design/shared/folds.h"
#include <batten/measure.h>

static bool has_surface(const batten_model *model)
{
    for (int k = 0; k < batten_model_count(model); k++)
        if (batten_model_object(model, k)->kind == BATTEN_OBJECT_SURFACE)
            return true;
    return false;
}

/* Does the feature make its surfaces of something that is none? */
static bool constructs(const bat_run *run)
{
    const batten_parameter *principal = &run->feature->parameters[0];
    const bat_argument *argument = &run->arguments[0];
    if (principal->kind != BATTEN_VALUE_MODEL)
        return principal->kind != BATTEN_VALUE_FILE;
    for (int i = 0; i < argument->count; i++)
        if (has_surface(run->results[argument->items[i].count].value))
            return false;
    return true;
}

static void note_fold(const bat_run *run, const char *name, const batten_surface_fold *first,
                      int folded)
{
    bat_note(run,
             "'%s' folds over near (%.6g, %.6g, %.6g): its "
             "normal reverses there; see whether the curves run the same way, keep their "
             "order and do not cross%s",
             name, first->point.x, first->point.y, first->point.z,
             folded > 1 ? "; other surfaces fold too" : "");
}

batten_status bat_note_folds(const bat_run *run)
{
    const int count = constructs(run) ? batten_model_count(run->model) : 0;
    batten_surface_fold first = {.found = false};
    const char *name = "";
    int folded = 0;
    for (int k = 0; k < count; k++) {
        const batten_object *object = batten_model_object(run->model, k);
        batten_surface_fold fold = {.found = false};
        batten_status status = BATTEN_OK;
        if (object->kind == BATTEN_OBJECT_SURFACE)
            status = batten_surface_find_fold(object->surface, &fold);
        if (status != BATTEN_OK)
            return status;
        if (fold.found && folded++ == 0) {
            first = fold;
            name = object->name;
        }
    }
    if (folded > 0)
        note_fold(run, name, &first, folded);
    return BATTEN_OK;
}

/* ---- slivers ---- */

/* Knots that agree in six digits were meant to be one. */
static const double meant_one = 1e-6;
/* A surface of fewer tolerances than that is too small for the tolerance to say what a sliver is. */
static const double large = 1000;

batten_status bat_note_slivers(const bat_run *run, const batten_surface *surface,
                               const char *advice)
{
    batten_least_span least;
    const batten_status status = batten_surface_least_span(surface, BATTEN_U, &least);
    if (status != BATTEN_OK)
        return status;
    const double tolerance = bat_tolerance(run);
    if (least.share < meant_one ||
        (least.length < tolerance && least.total > large * tolerance))
        bat_note(run,
                 "along the sections the shortest span is %.2g of the whole, and the surface "
                 "gets %.2g far across one, the tolerance being %.2g; %s",
                 least.share, least.length, tolerance, advice);
    return BATTEN_OK;
}
