/* The places of an INSERT: one, or all those of its array. */
#include "exchange/dxf/insert.h"
#include "exchange/dxf/entities.h"
#include "numeric/vector.h"

static batten_status read_scale(const bat_dxf_pairs *pairs, batten_vec3 *scale)
{
    batten_status status = bat_dxf_get_real(pairs, 41, 1, &scale->x);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 42, 1, &scale->y);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 43, 1, &scale->z);
    if (status == BATTEN_OK && scale->x * scale->y * scale->z == 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "it is scaled by 0");
    return status;
}

static batten_affine axes_of(const batten_frame *frame)
{
    const batten_vec3 y = bat_vec3_cross(frame->z, frame->x);
    return (batten_affine){{{frame->x.x, y.x, frame->z.x},
                            {frame->x.y, y.y, frame->z.y},
                            {frame->x.z, y.z, frame->z.z}},
                           {0, 0, 0}};
}

/* What is at the base of the block is scaled, turned about z and moved. */
static batten_affine move_from(batten_vec3 base, batten_vec3 scale, double angle,
                               batten_vec3 at)
{
    const batten_vec3 origin = {0, 0, 0}, z = {0, 0, 1};
    batten_affine map = batten_affine_translation(-base.x, -base.y, -base.z);
    map = batten_affine_compose(map, batten_affine_scaling(scale.x, scale.y, scale.z));
    map = batten_affine_compose(map, batten_affine_rotation(origin, z, angle));
    return batten_affine_compose(map, batten_affine_translation(at.x, at.y, at.z));
}

/* All in the axes of its plane. */
static batten_status read_first(const bat_dxf_pairs *pairs, batten_vec3 base,
                                const batten_frame *frame, double angle, batten_affine *first)
{
    batten_vec3 at, scale;
    batten_status status = bat_dxf_get_point(pairs, 10, (batten_vec3){0, 0, 0}, &at);
    if (status == BATTEN_OK)
        status = read_scale(pairs, &scale);
    if (status == BATTEN_OK)
        *first = batten_affine_compose(move_from(base, scale, angle, at), axes_of(frame));
    return status;
}

/* How many, and how far apart; not more than one where these would lie in one place. */
static batten_status read_count(const bat_dxf_pairs *pairs, int code, const char *what,
                                int *count, double *apart)
{
    batten_status status = bat_dxf_get_integer(pairs, code, 1, count);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, code - 26, 0, apart);
    if (status == BATTEN_OK && *count > 1 && *apart == 0) {
        batten_notes_add(pairs->input->notes, pairs->input->file, bat_dxf_find(pairs, 0)->line,
                         "INSERT", "its %d %s lie 0 apart, in one place; one is read", *count,
                         what);
        *count = 1;
    }
    *count = bat_max_int(1, *count);
    return status;
}

/* The ways are turned with the block, and not scaled. */
static void turn_steps(const batten_frame *frame, double angle, const double apart[2],
                       bat_dxf_places *places)
{
    const batten_vec3 x = frame->x, y = bat_vec3_cross(frame->z, frame->x);
    const batten_vec3 along =
        bat_vec3_along(bat_vec3_scale(x, bat_cos(angle)), bat_sin(angle), y);
    const batten_vec3 up =
        bat_vec3_along(bat_vec3_scale(y, bat_cos(angle)), -bat_sin(angle), x);
    places->along = bat_vec3_scale(along, apart[0]);
    places->up = bat_vec3_scale(up, apart[1]);
}

batten_status bat_dxf_read_places(const bat_dxf_pairs *pairs, const bat_dxf_block *block,
                                  bat_dxf_places *places)
{
    batten_frame frame;
    double degrees = 0, apart[2];
    batten_status status = bat_dxf_plane(pairs, &frame);
    if (status == BATTEN_OK)
        status = bat_dxf_get_real(pairs, 50, 0, &degrees);
    const double angle = degrees * BAT_PI / 180;
    if (status == BATTEN_OK)
        status = read_first(pairs, block->base, &frame, angle, &places->first);
    if (status == BATTEN_OK)
        status = read_count(pairs, 70, "columns", &places->columns, &apart[0]);
    if (status == BATTEN_OK)
        status = read_count(pairs, 71, "rows", &places->rows, &apart[1]);
    if (status != BATTEN_OK)
        return status;
    turn_steps(&frame, angle, apart, places);
    return BATTEN_OK;
}

batten_affine bat_dxf_place_at(const bat_dxf_places *places, int column, int row)
{
    const batten_vec3 way =
        bat_vec3_along(bat_vec3_scale(places->along, column), row, places->up);
    return column || row ? batten_affine_compose(places->first,
                                                 batten_affine_translation(way.x, way.y, way.z))
                         : places->first;
}
