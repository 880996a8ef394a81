/* How far edges miss their surfaces in a file: what it says of its own accuracy is often too
 * good. */
#include "exchange/iges/read/loops.h"
#include "inspect/nearest/foot.h"

#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The distance of a point from an elementary surface. */
static double elementary_miss(const bat_elementary *e, const double p[3])
{
    const double way[3] = {p[0] - e->frame.origin.x, p[1] - e->frame.origin.y,
                           p[2] - e->frame.origin.z};
    const double axis[3] = {e->frame.z.x, e->frame.z.y, e->frame.z.z};
    const double z = dot(way, axis), r = sqrt(bat_max(0, dot(way, way) - z * z));
    switch (e->kind) {
    case BAT_PLANE:
        return fabs(z);
    case BAT_CYLINDER:
        return fabs(r - e->a);
    case BAT_CONE:
        return fabs((r - e->a) * bat_cos(e->b) - z * bat_sin(e->b));
    case BAT_SPHERE:
        return fabs(bat_hypot(r, z) - e->a);
    default: /* a torus: IGES has no other */
        return fabs(bat_hypot(r - e->a, z) - e->b);
    }
}

/* The distance of c from the surface near (u, v). Three steps: the parameters of the file are
 * about as near to the foot as the file is exact. */
static double surface_miss(const batten_surface *surface, const double uv[2], const double c[3])
{
    enum { STEPS = 3 };
    bat_foot_area all = {.surface = surface};
    bat_foot_place foot;
    for (int k = 0; k < 2; k++) {
        const batten_interval domain = batten_surface_domain(surface, k ? BATTEN_V : BATTEN_U);
        all.low[k] = domain.a;
        all.high[k] = domain.b;
        foot.at[k] = bat_min(bat_max(uv[k], domain.a), domain.b);
    }
    const batten_status status = bat_foot_on_surface(&all, 1, STEPS, c, &foot);
    return status == BATTEN_OK ? sqrt(2 * foot.value) : 0;
}

enum { SAMPLES = 4, MOST = 64 };

/* At a parameter of the edge and of its plane curve. */
static double miss_at(const bat_iges_ground *ground, const batten_curve *space,
                      const batten_curve *flat, double share)
{
    const batten_interval domain = batten_curve_domain(space);
    const batten_interval plane = flat ? batten_curve_domain(flat) : domain;
    double c[3], uv[2] = {0, 0};
    if (batten_curve_evaluate(space, domain.a + share * (domain.b - domain.a), 0, c) !=
        BATTEN_OK)
        return 0;
    if (ground->is_elementary)
        return elementary_miss(&ground->elementary, c);
    if (batten_curve_evaluate(flat, plane.a + share * (plane.b - plane.a), 0, uv) != BATTEN_OK)
        return 0;
    return surface_miss(ground->surface, uv, c);
}

/* Without a plane curve the foot is looked for, once; then it follows the edge. */
static double search_miss(bat_iges_ground *ground, const batten_curve *space)
{
    enum { STEPS = 8 };
    double worst = 0;
    if (!ground->chart) {
        ground->chart = bat_array(1, sizeof *ground->chart);
        if (!ground->chart ||
            bat_chart_begin(ground->surface, ground->tolerance, ground->chart) != BATTEN_OK)
            return 0;
    }
    if (!ground->chart->surface ||
        bat_chart_miss(ground->chart, space, STEPS, &worst) != BATTEN_OK)
        return 0;
    return worst;
}

double bat_iges_miss(bat_iges_ground *ground, const batten_curve *space,
                     const batten_curve *flat)
{
    const int steps = bat_min_int(MOST, SAMPLES * batten_curve_spans(space, NULL));
    double worst = 0;
    if (!ground->is_elementary && !flat)
        return search_miss(ground, space);
    for (int i = 0; i < steps; i++)
        worst = bat_max(worst, miss_at(ground, space, flat, (i + 0.5) / steps));
    return worst;
}

double bat_iges_tolerance_of_miss(bat_iges_reading *reading, double tolerance, double miss,
                                  double size)
{
    /* Twice as much leaves room for what is between the samples. */
    if (2 * miss <= tolerance || 2 * miss > 1e-3 * size)
        return tolerance;
    reading->loose++;
    reading->largest_miss = bat_max(reading->largest_miss, miss);
    return 2 * miss;
}
