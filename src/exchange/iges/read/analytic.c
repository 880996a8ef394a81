/* 108 and 190 - 198: planes, cylinders, cones, spheres, tori without bounds of their own. */
#include "base/plural.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/surfaces.h"

#include <string.h>

bool bat_iges_is_elementary(int type)
{
    return type == 108 || type == 190 || type == 192 || type == 194 || type == 196 ||
           type == 198;
}

batten_status bat_iges_read_unbounded(bat_iges_item *item)
{
    (void)item;
    return bat_fail(BATTEN_UNSUPPORTED, "a surface without bounds");
}

static batten_vec3 vector(const double v[3])
{
    return (batten_vec3){v[0], v[1], v[2]};
}

/* The unit vector; false when there is none. */
static bool unit(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0 && isfinite(length)))
        return false;
    for (int k = 0; k < 3; k++)
        v[k] /= length;
    return true;
}

/* Some direction across z: from the axis of the world that lies most across it. */
static void across(const double z[3], double x[3])
{
    int least = 0;
    for (int k = 1; k < 3; k++)
        if (fabs(z[k]) < fabs(z[least]))
            least = k;
    for (int k = 0; k < 3; k++)
        x[k] = (k == least) - z[least] * z[k];
    unit(x);
}

/* A frame with z, and x as near as may be; x NULL: some. */
static batten_status make_frame(const double origin[3], double z[3], const double *towards,
                                batten_frame *out)
{
    double x[3];
    if (!unit(z))
        return bat_fail(BATTEN_BAD_FORMAT, "an axis or normal without a direction");
    across(z, x);
    if (towards) {
        const double along = towards[0] * z[0] + towards[1] * z[1] + towards[2] * z[2];
        double given[3];
        for (int k = 0; k < 3; k++)
            given[k] = towards[k] - along * z[k];
        if (unit(given))
            memcpy(x, given, sizeof x);
    }
    *out = (batten_frame){vector(origin), vector(x), vector(z)};
    return BATTEN_OK;
}

batten_status bat_iges_plane_of(const double equation[4], bat_elementary *out)
{
    double z[3], origin[3];
    memcpy(z, equation, sizeof z);
    const double square = z[0] * z[0] + z[1] * z[1] + z[2] * z[2];
    for (int k = 0; k < 3; k++)
        origin[k] = square > 0 ? equation[k] * (equation[3] / square) : 0;
    *out = (bat_elementary){.kind = BAT_PLANE};
    return make_frame(origin, z, NULL, &out->frame);
}

/* Where in the parameters of 190 - 198 things stand; 0 for what there is not. */
typedef struct {
    int type;
    bat_elementary_kind kind;
    size_t axis, a, b, towards;
} layout;

static const layout layouts[] = {{190, BAT_PLANE, 2, 0, 0, 3},
                                 {192, BAT_CYLINDER, 2, 3, 0, 4},
                                 {194, BAT_CONE, 2, 3, 4, 5},
                                 {196, BAT_SPHERE, 3, 2, 0, 4},
                                 {198, BAT_TORUS, 2, 3, 4, 5}};

static batten_status read_direction(bat_iges_item *item, size_t index, bool *is_there,
                                    double direction[3])
{
    int id = 0;
    *is_there = false;
    batten_status status = bat_iges_integer(item->parameters, index, &id);
    if (status != BATTEN_OK || id == 0)
        return status;
    *is_there = true;
    return bat_iges_direction(item->reading, id, direction);
}

static batten_status check_sizes(const layout *at, const bat_elementary *e)
{
    if (at->a && !(e->a > 0) && !(at->kind == BAT_TORUS && e->a < 0))
        return bat_fail(BATTEN_BAD_FORMAT, "a radius of %g", e->a);
    if (at->kind == BAT_TORUS && !(e->b > 0))
        return bat_fail(BATTEN_BAD_FORMAT, "a radius of %g", e->b);
    if (at->kind == BAT_CONE && !(e->b > 0 && e->b < BAT_PI / 2))
        return bat_fail(BATTEN_BAD_FORMAT, "a cone with half the angle %g degree%s",
                        e->b * 180 / BAT_PI, bat_plural_real(e->b * 180 / BAT_PI, 6));
    return BATTEN_OK;
}

/* The half angle of a cone is in degrees. */
static batten_status read_analytic(bat_iges_item *item, const layout *at, bat_elementary *out)
{
    int id = 0;
    double origin[3], axis[3] = {0, 0, 1}, towards[3];
    bool has_axis = false, has_towards = false;
    *out = (bat_elementary){.kind = at->kind};
    batten_status status = bat_iges_integer(item->parameters, 1, &id);
    if (status == BATTEN_OK)
        status = bat_iges_point(item->reading, id, origin);
    if (status == BATTEN_OK)
        status = read_direction(item, at->axis, &has_axis, axis);
    if (status == BATTEN_OK)
        status = read_direction(item, at->towards, &has_towards, towards);
    if (status == BATTEN_OK && at->a)
        status = bat_iges_real(item->parameters, at->a, &out->a);
    if (status == BATTEN_OK && at->b)
        status = bat_iges_real(item->parameters, at->b, &out->b);
    if (status == BATTEN_OK && !has_axis && at->kind != BAT_SPHERE)
        status = bat_fail(BATTEN_BAD_FORMAT, "it has no axis or normal");
    if (at->kind == BAT_CONE)
        out->b *= BAT_PI / 180;
    if (status == BATTEN_OK)
        status = check_sizes(at, out);
    if (status == BATTEN_OK && at->kind == BAT_TORUS && out->a < 0)
        batten_notes_add(
            item->reading->input->notes, item->reading->input->file, item->entry->line, "torus",
            "its major radius is %g, which the standard does not have; it is taken as "
            "the formula of the surface has it",
            out->a);
    return status == BATTEN_OK
               ? make_frame(origin, axis, has_towards ? towards : NULL, &out->frame)
               : status;
}

/* Move the frame; a matrix of IGES keeps sizes. */
static void move_frame(const batten_affine *map, batten_frame *frame)
{
    batten_affine turn = *map;
    memset(turn.t, 0, sizeof turn.t);
    frame->origin = batten_affine_apply(*map, frame->origin);
    frame->x = batten_affine_apply(turn, frame->x);
    frame->z = batten_affine_apply(turn, frame->z);
}

batten_status bat_iges_elementary(bat_iges_reading *reading, const bat_iges_entry *entry,
                                  bat_elementary *out)
{
    bat_iges_item item;
    double equation[4];
    batten_affine map;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK && entry->type == 108) {
        status = bat_iges_reals(item.parameters, 1, 4, equation);
        if (status == BATTEN_OK)
            status = bat_iges_plane_of(equation, out);
    } else if (status == BATTEN_OK) {
        const layout *at = layouts;
        while (at->type != entry->type)
            at++;
        status = read_analytic(&item, at, out);
    }
    bat_iges_close(&item);
    if (status == BATTEN_OK && entry->transform)
        status = bat_iges_transform(reading, entry->transform, &map);
    if (status == BATTEN_OK && entry->transform)
        move_frame(&map, &out->frame);
    if (status == BATTEN_OK)
        status = bat_census_read(reading->input, &reading->census,
                                 bat_iges_row_of(reading, entry->type)->name);
    return status;
}
