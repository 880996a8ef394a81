/* The surfaces of a STEP file. */
#include "exchange/step/read/geometry.h"
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- planes, cylinders, cones, spheres, tori ---- */

/* KEYWORD(name, placement, a, b ...) */
typedef struct {
    const char *keyword;
    bat_elementary_kind kind;
    int arguments;
    const char *what[2]; /* a and b; those that are lengths must be positive, a of a cone 0 */
} form;

static const form forms[] = {
    {"PLANE", BAT_PLANE, 2, {NULL, NULL}},
    {"CYLINDRICAL_SURFACE", BAT_CYLINDER, 3, {"radius", NULL}},
    {"CONICAL_SURFACE", BAT_CONE, 4, {"radius", "half angle"}},
    {"SPHERICAL_SURFACE", BAT_SPHERE, 3, {"radius", NULL}},
    {"TOROIDAL_SURFACE", BAT_TORUS, 4, {"major radius", "minor radius"}},
    {"DEGENERATE_TOROIDAL_SURFACE", BAT_TORUS, 5, {"major radius", "minor radius"}},
};

static batten_status read_measures(const bat_step_reading *reading,
                                   const bat_step_instance *instance,
                                   const bat_step_record *record, const form *f,
                                   bat_elementary *elementary)
{
    double *const measures[2] = {&elementary->a, &elementary->b};
    for (int k = 0; k < 2 && f->what[k]; k++) {
        const bool is_angle = f->kind == BAT_CONE && k == 1;
        const bool may_vanish = f->kind == BAT_CONE && k == 0;
        double value = 0;
        batten_status status = bat_step_get_real(reading->file, record, 2 + k, &value);
        if (status != BATTEN_OK)
            return status;
        if (k == 0 && f->kind == BAT_TORUS && value < 0)
            bat_step_warn(reading->file, instance,
                          "its %s is %g, which the standard does not have; it is taken as the "
                          "formula of the surface has it",
                          f->what[k], value);
        else if (!(value > 0) && !(may_vanish && value == 0))
            return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                                 "its %s is %g; it must be positive", f->what[k], value);
        value *= is_angle ? reading->scale.angle : reading->scale.length;
        if (!isfinite(value) || (is_angle && value >= BAT_PI / 2))
            return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                                 "its %s is too large: %g", f->what[k], value);
        *measures[k] = value;
    }
    return BATTEN_OK;
}

/* The last argument of a DEGENERATE_TOROIDAL_SURFACE is .F. for its inner part. */
static batten_status read_part(const bat_step_reading *reading, const bat_step_record *record,
                               const form *f, bat_elementary *elementary)
{
    bool is_outer = true;
    batten_status status = BATTEN_OK;
    if (f->arguments == 5)
        status = bat_step_get_logical(reading->file, record, 4, &is_outer);
    elementary->is_inner = !is_outer;
    return status;
}

batten_status bat_step_primitive_in(const bat_step_reading *reading,
                                    const bat_step_instance *instance,
                                    bat_elementary *elementary, bool *is_primitive)
{
    const bat_step_instance *placement = NULL;
    const bat_step_record *record = NULL;
    size_t k = 0;
    for (; k < sizeof forms / sizeof forms[0] && !record; k++)
        record = bat_step_as(reading->file, instance, forms[k].keyword);
    *is_primitive = record != NULL;
    if (!record)
        return BATTEN_OK;
    const form *f = &forms[k - 1];
    bat_elementary read = {.kind = f->kind};
    batten_status status = bat_step_check_arguments(reading->file, record, f->arguments);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 1, &placement);
    if (status == BATTEN_OK)
        status = bat_step_frame_in(reading, placement, &read.frame);
    if (status == BATTEN_OK)
        status = read_measures(reading, instance, record, f, &read);
    if (status == BATTEN_OK)
        status = read_part(reading, record, f, &read);
    if (status == BATTEN_OK)
        *elementary = read;
    return status;
}

/* ---- what is swept ---- */

batten_status bat_step_sweep_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, bat_step_sweep *sweep,
                                bool *is_sweep)
{
    const bat_step_file *file = reading->file;
    const bat_step_record *record = bat_step_as(file, instance, "SURFACE_OF_LINEAR_EXTRUSION");
    const bat_step_instance *along = NULL;
    *sweep = (bat_step_sweep){.turned = !record};
    if (!record)
        record = bat_step_as(file, instance, "SURFACE_OF_REVOLUTION");
    *is_sweep = record != NULL;
    if (!record)
        return BATTEN_OK;
    batten_status status = bat_step_check_arguments(file, record, 3);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 1, &sweep->curve);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 2, &along);
    if (status == BATTEN_OK && sweep->turned)
        return bat_step_frame_in(reading, along, &sweep->frame);
    if (status == BATTEN_OK)
        status = bat_step_vector_in(reading, along, &sweep->frame.z);
    return status;
}

/* A line along a direction is a plane. */
static batten_status plane_of_line(const bat_step_reading *reading,
                                   const bat_step_instance *instance, const bat_conic *line,
                                   batten_vec3 along, bat_elementary *elementary)
{
    const batten_vec3 x = bat_vec3_scale(line->frame.x, 1 / bat_vec3_norm(line->frame.x));
    const batten_vec3 z = bat_vec3_cross(x, bat_vec3_scale(along, 1 / bat_vec3_norm(along)));
    const double sine = bat_vec3_norm(z);
    /* Unit vectors are so only to rounding: below this the normal has no digits. */
    if (sine < 1e-12)
        return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                             "its line runs along its direction");
    *elementary = (bat_elementary){
        .kind = BAT_PLANE, .frame = {line->frame.origin, x, bat_vec3_scale(z, 1 / sine)}};
    return BATTEN_OK;
}

/* A line about an axis: a cylinder, a cone or a plane. The normal of the file is Su x Sv with u
 * around and v along the line: away from the axis where the line runs up. */
static batten_status turned_line(const bat_step_reading *reading,
                                 const bat_step_instance *instance, const bat_conic *line,
                                 const batten_frame *axis, bat_elementary *elementary,
                                 bool *is_reversed)
{
    const double round = BAT_WRITTEN;
    const batten_vec3 d = bat_vec3_scale(line->frame.x, 1 / bat_vec3_norm(line->frame.x));
    const batten_vec3 way = bat_vec3_subtract(line->frame.origin, axis->origin);
    const double height = bat_vec3_dot(way, axis->z), rise = bat_vec3_dot(d, axis->z);
    const batten_vec3 out = bat_vec3_along(way, -height, axis->z),
                      across = bat_vec3_along(d, -rise, axis->z);
    const double radius = bat_vec3_norm(out), run = bat_vec3_norm(across);
    const double size = bat_max(bat_vec3_norm(way), reading->scale.tolerance);
    const bool on_axis = radius <= round * size;
    *elementary = (bat_elementary){.frame = *axis, .a = on_axis ? 0 : radius};
    elementary->frame.origin = bat_vec3_along(axis->origin, height, axis->z);
    *is_reversed = rise < 0;
    if (run <= round) {
        elementary->kind = BAT_CYLINDER;
        if (on_axis)
            return bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                                 "its line is its axis");
        return BATTEN_OK;
    }
    const double outward = on_axis ? run : bat_vec3_dot(across, out) / radius;
    if (fabs(fabs(outward) - run) > round * run)
        return bat_step_fail(reading->file, instance, BATTEN_UNSUPPORTED,
                             "its line and its axis are skew: a hyperboloid is not read");
    if (fabs(rise) > round) {
        elementary->kind = BAT_CONE;
        elementary->b = bat_atan(outward / rise);
        return BATTEN_OK;
    }
    elementary->kind = BAT_PLANE;
    *is_reversed = false;
    if (outward > 0)
        elementary->frame.z = bat_vec3_scale(axis->z, -1);
    return BATTEN_OK;
}

static batten_status swept(const bat_step_reading *reading, const bat_step_instance *instance,
                           const bat_step_sweep *sweep, bat_elementary *elementary,
                           bat_step_basis *basis)
{
    bat_conic conic;
    bool is_conic = false;
    batten_status status = bat_step_conic_in(reading, sweep->curve, &conic, &is_conic);
    if (status != BATTEN_OK)
        return status;
    if (is_conic && conic.kind == BAT_LINE)
        return sweep->turned
                   ? turned_line(reading, instance, &conic, &sweep->frame, elementary,
                                 &basis->is_reversed)
                   : plane_of_line(reading, instance, &conic, sweep->frame.z, elementary);
    status = bat_step_curve_in(reading, sweep->curve, &basis->curve);
    if (status == BATTEN_OK)
        *elementary = (bat_elementary){.kind = sweep->turned ? BAT_REVOLUTION : BAT_EXTRUSION,
                                       .frame = sweep->frame,
                                       .curve = basis->curve};
    return status;
}

/* ---- offsets ---- */

/* The same kind of surface at a distance; false when it is another. */
static bool moved(bat_elementary *e, double distance)
{
    switch (e->kind) {
    case BAT_PLANE:
        e->frame.origin = bat_vec3_along(e->frame.origin, distance, e->frame.z);
        return true;
    case BAT_CYLINDER:
    case BAT_SPHERE:
        e->a += distance;
        return true;
    case BAT_CONE:
        e->a += distance / bat_cos(e->b);
        return true;
    case BAT_TORUS:
        e->b += distance;
        return true;
    default:
        return false;
    }
}

/* OFFSET_SURFACE(name, basis, distance, self_intersect) */
static batten_status read_offset(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, bat_elementary *elementary,
                                 bat_step_basis *basis)
{
    const bat_step_instance *of = NULL;
    double distance = 0;
    bool is_elementary = false;
    bat_step_basis below = {NULL, NULL, false};
    batten_status status = bat_step_check_arguments(reading->file, record, 4);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(reading->file, record, 1, &of);
    if (status == BATTEN_OK)
        status = bat_step_get_real(reading->file, record, 2, &distance);
    if (status == BATTEN_OK)
        status = bat_step_elementary_in(reading, of, elementary, &below, &is_elementary);
    distance *= reading->scale.length;
    if (status == BATTEN_OK && is_elementary &&
        moved(elementary, below.is_reversed ? -distance : distance)) {
        basis->is_reversed = below.is_reversed;
        if (elementary->a < 0 || elementary->b < 0)
            status = bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                                   "the distance %g is more than the radius of the surface",
                                   distance);
    } else if (status == BATTEN_OK) {
        status = bat_step_surface_in(reading, of, &basis->surface);
        if (status == BATTEN_OK)
            *elementary = (bat_elementary){
                .kind = BAT_OFFSET_SURFACE,
                .a = distance,
                .surface = basis->surface,
                .most = bat_input_most_near(
                    reading->file->input,
                    (double)batten_surface_point_count(basis->surface, BATTEN_U) *
                        batten_surface_point_count(basis->surface, BATTEN_V))};
    }
    bat_step_basis_end(&below);
    return status;
}

/* ---- any surface ---- */

batten_status bat_step_elementary_in(const bat_step_reading *reading,
                                     const bat_step_instance *instance,
                                     bat_elementary *elementary, bat_step_basis *basis,
                                     bool *is_elementary)
{
    bat_step_reading inner;
    bat_step_sweep sweep;
    *basis = (bat_step_basis){NULL, NULL, false};
    *is_elementary = false;
    batten_status status = bat_step_deeper(reading, instance, &inner);
    if (status == BATTEN_OK)
        status = bat_step_primitive_in(&inner, instance, elementary, is_elementary);
    if (status != BATTEN_OK || *is_elementary)
        return status;
    status = bat_step_sweep_in(&inner, instance, &sweep, is_elementary);
    if (status == BATTEN_OK && *is_elementary)
        status = swept(&inner, instance, &sweep, elementary, basis);
    const bat_step_record *record = bat_step_as(reading->file, instance, "OFFSET_SURFACE");
    if (status == BATTEN_OK && record) {
        *is_elementary = true;
        status = read_offset(&inner, instance, record, elementary, basis);
    }
    if (status != BATTEN_OK)
        bat_step_basis_end(basis);
    return status;
}

/* ---- for other files ---- */

void bat_step_basis_end(bat_step_basis *basis)
{
    batten_curve_unref(basis->curve);
    batten_surface_unref(basis->surface);
    *basis = (bat_step_basis){NULL, NULL, false};
}
