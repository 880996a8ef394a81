/* What a surface claims of its tangent planes along its edges, measured on the spline that is
 * delivered in its place. */
#include "shape/formula/edge_angles.h"

#include "base/sort.h"
#include "numeric/vector.h"
#include <batten/fill.h>

enum { PLACES = 32, EDGES = 4 };

static batten_status normal_at(const batten_surface *surface, double u, double v,
                               batten_vec3 *normal, bool *regular)
{
    double d[3][3];
    const batten_status status = batten_surface_evaluate(surface, u, v, 1, d[0]);
    if (status != BATTEN_OK)
        return status;
    const batten_interval of_u = batten_surface_domain(surface, BATTEN_U),
                          of_v = batten_surface_domain(surface, BATTEN_V);
    const double along_u = bat_norm(3, d[1]), along_v = bat_norm(3, d[2]);
    const double wide = along_u * (of_u.b - of_u.a), high = along_v * (of_v.b - of_v.a);
    *normal = bat_vec3_cross(bat_vec3_of(3, d[1]), bat_vec3_of(3, d[2]));
    /* At a pole one derivative is rounding; where parameter lines meet flatter than that, next
     * to a corner of which both sides go on smoothly, the normal is noise. */
    *regular = bat_min(wide, high) > 1e-9 * bat_max(wide, high) &&
               bat_vec3_norm(*normal) > 1e-4 * along_u * along_v;
    return BATTEN_OK;
}

batten_status bat_edge_angle(const batten_surface *a, const batten_surface *b, batten_edge edge,
                             batten_interval between, double *largest)
{
    const bool along_u = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
    const bool high = edge == BATTEN_EDGE_V1 || edge == BATTEN_EDGE_U1;
    const batten_interval across = batten_surface_domain(a, along_u ? BATTEN_V : BATTEN_U);
    const double fixed = high ? across.b : across.a;
    *largest = 0;
    for (int k = 0; k < PLACES; k++) {
        const double share = 0.5 - 0.5 * bat_cos((k + 0.5) * BAT_PI / PLACES);
        const double t = (1 - share) * between.a + share * between.b;
        const double u = along_u ? t : fixed, v = along_u ? fixed : t;
        batten_vec3 n, m;
        bool regular[2];
        batten_status status = normal_at(a, u, v, &n, &regular[0]);
        if (status == BATTEN_OK)
            status = normal_at(b, u, v, &m, &regular[1]);
        if (status != BATTEN_OK)
            return status;
        if (regular[0] && regular[1])
            *largest = bat_max(
                *largest, bat_atan2(bat_vec3_norm(bat_vec3_cross(n, m)), bat_vec3_dot(n, m)));
    }
    return BATTEN_OK;
}

/* At places of every span that either surface has. */
static batten_status angle_along(const batten_surface *a, const batten_surface *b,
                                 batten_edge edge, double *largest)
{
    const batten_direction along =
        edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1 ? BATTEN_U : BATTEN_V;
    const int of_a = batten_surface_spans(a, along, NULL),
              of_b = batten_surface_spans(b, along, NULL);
    const size_t count = (size_t)of_a + (size_t)of_b;
    double *breaks = bat_array(count, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(a, along, breaks);
    batten_surface_spans(b, along, breaks + of_a);
    bat_sort_doubles(count, breaks);
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        double turned = 0;
        if (breaks[i] < breaks[i + 1])
            status = bat_edge_angle(a, b, edge, (batten_interval){breaks[i], breaks[i + 1]},
                                    &turned);
        *largest = bat_max(*largest, turned);
    }
    bat_release(breaks);
    return status;
}

batten_status batten_surface_edge_angles(const batten_surface *a, const batten_surface *b,
                                         double *angles)
{
    double found[EDGES] = {0};
    if (batten_surface_dimension(a) != 3 || batten_surface_dimension(b) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface of dimension %d has no normals",
                        batten_surface_dimension(batten_surface_dimension(a) != 3 ? a : b));
    for (int k = 0; k < 2; k++) {
        const batten_interval of_a = batten_surface_domain(a, (batten_direction)k),
                              of_b = batten_surface_domain(b, (batten_direction)k);
        if (of_a.a != of_b.a || of_a.b != of_b.b)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "the surfaces run from %g to %g and from %g to %g in %s", of_a.a,
                            of_a.b, of_b.a, of_b.b, k ? "v" : "u");
    }
    batten_status status = BATTEN_OK;
    for (int edge = 0; edge < EDGES && status == BATTEN_OK; edge++)
        status = angle_along(a, b, (batten_edge)edge, &found[edge]);
    for (int edge = 0; edge < EDGES && status == BATTEN_OK; edge++)
        angles[edge] = found[edge];
    return status;
}
