/* Which way the loops of a face run, head to tail, and which of them is the outer one. */
#include "exchange/iges/read/loops.h"
#include <string.h>

batten_status bat_iges_end_of(const bat_iges_side *side, bool last, double p[3])
{
    const batten_interval domain = batten_curve_domain(side->space);
    return batten_curve_evaluate(side->space, last != side->reversed ? domain.b : domain.a, 0,
                                 p);
}

double bat_iges_distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* ---- which way sides run ---- */

batten_status bat_iges_link_sides(bat_iges_loop *loop, double tolerance)
{
    bat_iges_side *sides = loop->sides.items;
    double a[3], b[3], c[3], d[3];
    batten_status status = BATTEN_OK;
    for (size_t k = 1; status == BATTEN_OK && k < loop->sides.count; k++) {
        status = bat_iges_end_of(&sides[k - 1], false, a);
        if (status == BATTEN_OK)
            status = bat_iges_end_of(&sides[k - 1], true, b);
        if (status == BATTEN_OK)
            status = bat_iges_end_of(&sides[k], false, c);
        if (status == BATTEN_OK)
            status = bat_iges_end_of(&sides[k], true, d);
        if (status != BATTEN_OK)
            return status;
        /* The first may have to turn as well. */
        const double kept = bat_min(bat_iges_distance(b, c), bat_iges_distance(b, d)),
                     turned = bat_min(bat_iges_distance(a, c), bat_iges_distance(a, d));
        if (k == 1 && kept > tolerance && turned < kept) {
            sides[0].reversed = !sides[0].reversed;
            memcpy(b, a, sizeof b);
        }
        if (bat_iges_distance(b, c) > tolerance &&
            bat_iges_distance(b, d) < bat_iges_distance(b, c))
            sides[k].reversed = !sides[k].reversed;
    }
    return status;
}

/* Where a side is in (u, v): by its plane curve, or on a plane by its coordinates. */
static bool plane_point(const bat_iges_ground *ground, const bat_iges_side *side, double share,
                        double uv[2])
{
    const batten_curve *curve = side->flat ? side->flat : side->space;
    const batten_interval domain = batten_curve_domain(curve);
    const double at = side->reversed ? 1 - share : share;
    double p[3];
    if (batten_curve_evaluate(curve, domain.a + at * (domain.b - domain.a), 0, p) != BATTEN_OK)
        return false;
    if (side->flat) {
        memcpy(uv, p, 2 * sizeof *uv);
        return true;
    }
    const batten_frame *f = &ground->elementary.frame;
    const batten_vec3 x = f->x, z = f->z;
    const batten_vec3 y = {z.y * x.z - z.z * x.y, z.z * x.x - z.x * x.z, z.x * x.y - z.y * x.x};
    const batten_vec3 way = {p[0] - f->origin.x, p[1] - f->origin.y, p[2] - f->origin.z};
    uv[0] = way.x * x.x + way.y * x.y + way.z * x.z;
    uv[1] = way.x * y.x + way.y * y.y + way.z * y.z;
    return ground->is_elementary && ground->elementary.kind == BAT_PLANE;
}

/* The area of the polygon of samples; 0 when it cannot be told. */
static double area_of(const bat_iges_ground *ground, const bat_iges_loop *loop)
{
    const bat_iges_side *sides = loop->sides.items;
    double first[2] = {0}, last[2] = {0}, area = 0;
    for (size_t k = 0; k < loop->sides.count; k++) {
        const batten_curve *curve = sides[k].flat ? sides[k].flat : sides[k].space;
        const int steps = bat_min_int(64, 4 * batten_curve_spans(curve, NULL));
        for (int i = 0; i < steps; i++) {
            double uv[2];
            if (!plane_point(ground, &sides[k], (double)i / steps, uv))
                return 0;
            if (k == 0 && i == 0)
                memcpy(first, uv, sizeof first);
            else
                area += (last[0] - first[0]) * (uv[1] - first[1]) -
                        (uv[0] - first[0]) * (last[1] - first[1]);
            memcpy(last, uv, sizeof last);
        }
    }
    return area / 2;
}

static void turn_loop(bat_iges_loop *loop)
{
    bat_iges_side *sides = loop->sides.items;
    const size_t count = loop->sides.count;
    for (size_t k = 0; k < count / 2; k++) {
        const bat_iges_side kept = sides[k];
        sides[k] = sides[count - 1 - k];
        sides[count - 1 - k] = kept;
    }
    for (size_t k = 0; k < count; k++)
        sides[k].reversed = !sides[k].reversed;
    loop->area = -loop->area;
}

void bat_iges_right_loops(bat_iges_face *face, bool border)
{
    bat_iges_loop *loops = face->loops.items;
    size_t outer = 0;
    for (size_t k = 0; k < face->loops.count; k++) {
        loops[k].area = area_of(&face->ground, &loops[k]);
        if (fabs(loops[k].area) > fabs(loops[outer].area))
            outer = k;
    }
    if (border || face->loops.count == 0) {
        outer = face->loops.count;
    } else if (outer > 0) {
        const bat_iges_loop kept = loops[0];
        loops[0] = loops[outer];
        loops[outer] = kept;
        outer = 0;
        face->reading->swapped_loops++;
    }
    for (size_t k = 0; k < face->loops.count; k++)
        if (k == outer ? loops[k].area < 0 : loops[k].area > 0) {
            turn_loop(&loops[k]);
            face->reading->turned_loops++;
        }
}
