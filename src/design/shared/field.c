/* Contours of a surface: which field, at which levels, from the words of a feature or a picture. */
#include "design/shared/field.h"

batten_surface_field bat_field_of(const bat_run *run, batten_field_kind kind, batten_vec3 eye)
{
    batten_surface_field field = {
        .kind = kind, .direction = {0, 0, 1}, .point = bat_point(run, "through"), .eye = eye};
    if (bat_has(run, "direction"))
        field.direction = bat_point(run, "direction");
    return field;
}
