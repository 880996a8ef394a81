/* The matrices, points and directions that entities refer to. */
#include "exchange/iges/read/references.h"

#include <string.h>

/* ---- matrices ---- */

/* How far the rows of a matrix are from being orthonormal. */
static double skewness(const double m[3][3])
{
    double worst = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            const double dot = m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2];
            worst = bat_max(worst, fabs(dot - (i == j)));
        }
    return worst;
}

/* Gram and Schmidt, from the first row on. */
static void make_orthonormal(double m[3][3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < i; j++) {
            const double dot = m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2];
            for (int k = 0; k < 3; k++)
                m[i][k] -= dot * m[j][k];
        }
        const double length = sqrt(m[i][0] * m[i][0] + m[i][1] * m[i][1] + m[i][2] * m[i][2]);
        for (int k = 0; k < 3; k++)
            m[i][k] /= length;
    }
}

static batten_status read_matrix(bat_iges_item *item, batten_affine *map)
{
    const bat_iges_entry *entry = item->entry;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < 12; i++) {
        double *value = i % 4 < 3 ? &map->m[i / 4][i % 4] : &map->t[i / 4];
        status = bat_iges_real(item->parameters, i + 1, value);
    }
    if (status != BATTEN_OK)
        return status;
    const double skew = skewness((const double(*)[3])map->m);
    /* Matrices of single precision, of 7 digits, are rotations; worse ones are something else. */
    if (!(skew <= 1e-6))
        return bat_fail(BATTEN_BAD_FORMAT, "the matrix D%d differs from a rotation by %g",
                        entry->id, skew);
    if (skew > BAT_WRITTEN) {
        bat_iges_shape *shape = bat_iges_shape_of(item->reading, entry);
        if (shape->state == BAT_IGES_NEW)
            bat_iges_note(item->reading, entry,
                          "the matrix differs from a rotation by %g; made a rotation", skew);
        shape->state = BAT_IGES_READ;
        make_orthonormal(map->m);
    }
    return BATTEN_OK;
}

batten_status bat_iges_transform(bat_iges_reading *reading, int id, batten_affine *map)
{
    batten_affine whole = batten_affine_identity(), part;
    batten_status status = BATTEN_OK;
    for (int depth = 0; status == BATTEN_OK && id != 0; depth++) {
        const bat_iges_entry *entry = NULL;
        bat_iges_item item;
        if (depth == reading->input->limits.nesting)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "its matrices refer to one another in a ring, or more than %d deep",
                            depth);
        status = bat_iges_find_type(reading, id, 124, &entry);
        if (status != BATTEN_OK)
            return status;
        status = bat_iges_open(reading, entry, &item);
        if (status == BATTEN_OK)
            status = read_matrix(&item, &part);
        bat_iges_close(&item);
        if (status == BATTEN_OK) {
            whole = batten_affine_compose(whole, part);
            id = entry->transform;
        }
    }
    if (status == BATTEN_OK)
        *map = whole;
    return status;
}

/* ---- points and directions ---- */

static batten_status read_triple(bat_iges_reading *reading, int id, int type, bool moves,
                                 double triple[3])
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    batten_affine map;
    batten_status status = bat_iges_find_type(reading, id, type, &entry);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item.parameters, 1, 3, triple);
    bat_iges_close(&item);
    if (status != BATTEN_OK || !entry->transform)
        return status;
    status = bat_iges_transform(reading, entry->transform, &map);
    if (status != BATTEN_OK)
        return status;
    if (!moves)
        memset(map.t, 0, sizeof map.t);
    const batten_vec3 moved =
        batten_affine_apply(map, (batten_vec3){triple[0], triple[1], triple[2]});
    memcpy(triple, (double[]){moved.x, moved.y, moved.z}, 3 * sizeof *triple);
    return BATTEN_OK;
}

batten_status bat_iges_point(bat_iges_reading *reading, int id, double point[3])
{
    return read_triple(reading, id, 116, true, point);
}

batten_status bat_iges_direction(bat_iges_reading *reading, int id, double direction[3])
{
    return read_triple(reading, id, 123, false, direction);
}
