/* How accurate a STEP file says that it is. */
#include "base/real.h"
#include "exchange/shapes/prepare.h"
#include "exchange/step/write/writing.h"
#include "numeric/box.h"

#include <math.h>

/* How far curves of the bodies may miss their vertices and surfaces. */
static double loosest(const batten_model *model)
{
    double tolerance = 0;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->body)
            tolerance = bat_max(tolerance, batten_body_view(object->body)->tolerance);
    }
    return tolerance;
}

/* INFINITY for what is not a body or surface, or is one point. */
static double size_of_shape(const batten_object *object)
{
    if (!object->body && !object->surface)
        return INFINITY;
    const batten_box box =
        object->body ? batten_body_box(object->body) : batten_surface_box(object->surface);
    const double size = bat_box_diagonal(box);
    return size > 0 ? size : (double)INFINITY;
}

/* The size of the smallest body or surface, of those that are more than a point; INFINITY when
 * there is none. */
static double smallest(const batten_model *model)
{
    double least = INFINITY;
    for (int i = 0; i < batten_model_count(model); i++)
        least = bat_min(least, size_of_shape(batten_model_object(model, i)));
    return least;
}

double bat_step_accuracy(const bat_definitions *parts, const batten_write_options *options)
{
    double accuracy = BAT_WRITE_TOLERANCE / batten_model_unit_metres(parts->models[0]),
           worst = 0;
    for (int i = 0; i < parts->count; i++) {
        /* Small models need a finer one: a thousandth of the smallest part. */
        accuracy = bat_min(accuracy, 1e-3 * smallest(parts->models[i]));
        worst = bat_max(worst, loosest(parts->models[i]));
    }
    return bat_max(options->tolerance > 0 ? options->tolerance : accuracy, worst);
}
