/* The angles between a Coons patch and what it was to be smooth with. */
#include "numeric/vector.h"
#include "shape/boundary/coons_formula.h"

enum { PLACES = 64 };
/* Two directions at less than this have no plane. */
static const double parallel = 1e-6;

double bat_coons_off_plane(const double *direction, const double *a, const double *b)
{
    const batten_vec3 n = bat_vec3_cross(bat_vec3_of(3, a), bat_vec3_of(3, b));
    const double area = bat_vec3_norm(n), length = bat_norm(3, direction);
    if (!(area > parallel * bat_norm(3, a) * bat_norm(3, b)) || !(length > 0))
        return 0;
    return bat_asin(
        bat_min(1, fabs(bat_vec3_dot(n, bat_vec3_of(3, direction))) / (area * length)));
}

/* Tangent along the edge and derivative into the patch: as the surface has them. */
static batten_status see_surface(const batten_surface *surface, int edge, double t,
                                 double along[3], double inside[3])
{
    const bool runs_in_u = edge == BATTEN_EDGE_V0 || edge == BATTEN_EDGE_V1;
    const bool far = edge == BATTEN_EDGE_U1 || edge == BATTEN_EDGE_V1;
    double d[3][3];
    const batten_status status =
        batten_surface_evaluate(surface, runs_in_u ? t : far, runs_in_u ? far : t, 1, d[0]);
    for (int c = 0; status == BATTEN_OK && c < 3; c++) {
        along[c] = d[runs_in_u ? 1 : 2][c];
        inside[c] = (far ? -1 : 1) * d[runs_in_u ? 2 : 1][c];
    }
    return status;
}

static batten_status see_ribbon(const batten_ribbon *side, double t, double along[3],
                                double inside[3])
{
    double d[2][3];
    const batten_interval c = batten_curve_domain(side->curve);
    const batten_interval s = batten_curve_domain(side->slope);
    batten_status status = batten_curve_evaluate(side->curve, (1 - t) * c.a + t * c.b, 1, d[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(side->slope, (1 - t) * s.a + t * s.b, 0, inside);
    for (int x = 0; status == BATTEN_OK && x < 3; x++)
        along[x] = d[1][x];
    return status;
}

batten_status bat_coons_angles(const batten_ribbon sides[4], const batten_surface *surface,
                               double angle[4])
{
    batten_status status = BATTEN_OK;
    for (int e = 0; e < 4; e++) {
        angle[e] = 0;
        if (!sides[e].slope || batten_curve_dimension(sides[e].curve) != 3)
            continue;
        for (int k = 0; status == BATTEN_OK && k <= PLACES; k++) {
            double a[2][3], b[2][3];
            status = see_surface(surface, e, (double)k / PLACES, a[0], a[1]);
            if (status == BATTEN_OK)
                status = see_ribbon(&sides[e], (double)k / PLACES, b[0], b[1]);
            if (status != BATTEN_OK)
                break;
            const batten_vec3 n = bat_vec3_cross(bat_vec3_of(3, a[0]), bat_vec3_of(3, a[1]));
            const batten_vec3 m = bat_vec3_cross(bat_vec3_of(3, b[0]), bat_vec3_of(3, b[1]));
            if (bat_vec3_norm(n) > parallel * bat_norm(3, a[0]) * bat_norm(3, a[1]) &&
                bat_vec3_norm(m) > parallel * bat_norm(3, b[0]) * bat_norm(3, b[1]))
                angle[e] = bat_max(angle[e], bat_atan2(bat_vec3_norm(bat_vec3_cross(n, m)),
                                                       bat_vec3_dot(n, m)));
        }
    }
    return status;
}
