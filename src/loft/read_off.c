/*
 * One point of the faired table: waterlines and edges are met with the plane of a station by Newton's
 * method, from the foot of the point that was given.
 */
#include "loft/faired.h"
#include "numeric/vector.h"

/* What is sought: x, and on a waterline z. */
typedef struct {
    bool free_u, free_v;
    double x, z;
} target;

/* Newton's step to where S_x = x and S_z = z, along the parameters that are free; with one of them
 * the other condition is not asked. False where the planes do not meet the patch at an angle. */
static bool step_to(const target *t, const bat_loft_place *place, double step[2])
{
    const double *s = place->s[0][0], *su = place->s[1][0], *sv = place->s[0][1];
    const double x = t->x - s[0], z = t->z - s[2];
    const double det = su[0] * sv[2] - su[2] * sv[0];
    step[0] = step[1] = 0;
    if (t->free_u && t->free_v) {
        step[0] = (x * sv[2] - z * sv[0]) / det;
        step[1] = (z * su[0] - x * su[2]) / det;
    } else if (t->free_u) {
        step[0] = x / su[0];
    } else if (t->free_v) {
        step[1] = z / sv[2];
    }
    return isfinite(step[0]) && isfinite(step[1]);
}

/* How far a place is off what is sought. */
static double miss(const target *t, const bat_loft_place *place)
{
    const double *s = place->s[0][0];
    return bat_max(t->free_u ? fabs(s[0] - t->x) : 0, t->free_v ? fabs(s[2] - t->z) : 0);
}

/* Rounding is reached in a few steps; what takes more does not converge. */
static bool search(const bat_loft_patch *patch, const target *t, double size,
                   bat_loft_place *place)
{
    enum { STEPS = 20 };
    const double longest = 0.1, reached = 1e-12 * size; /* of the square; of the hull */
    for (int k = 0; k < STEPS; k++) {
        double step[2];
        if (!step_to(t, place, step))
            return false;
        const double u = place->u + bat_min(bat_max(step[0], -longest), longest),
                     v = place->v + bat_min(bat_max(step[1], -longest), longest);
        bat_loft_place_at(patch, bat_min(bat_max(u, 0), 1), bat_min(bat_max(v, 0), 1), place);
    }
    return miss(t, place) <= reached;
}

static double size_of(const bat_loft_patch *patch)
{
    const double *first = patch->points,
                 *last = first + 3 * ((size_t)patch->nu * (size_t)patch->nv - 1);
    return bat_distance(3, first, last);
}

double bat_loft_read_off(const bat_loft_patch *patch, const bat_loft_datum *d,
                         const batten_table_line *waterline, double out[3])
{
    bat_loft_place place, foot;
    const target t = {.free_u = !d->on_u_edge,
                      .free_v = !d->on_v_edge && waterline,
                      .x = d->point[0],
                      .z = waterline ? waterline->z : 0};
    bat_loft_place_at(patch, d->u, d->v, &foot);
    place = foot;
    const bool asked = t.free_v || (t.free_u && d->on_v_edge);
    if (!asked || !search(patch, &t, size_of(patch), &place))
        place = foot;
    memcpy(out, place.s[0][0], 3 * sizeof *out);
    return miss(&t, &place);
}
