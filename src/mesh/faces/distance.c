/* The distance of a point from a segment and from a triangle. */
#include "mesh/faces/meshing.h"

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void subtract(const double *a, const double *b, double *out)
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

/* A power of two near the largest of the vectors' parts, by which they are divided: so that no
 * square overflows or vanishes. */
static double scale_all(int count, double (*vectors)[3])
{
    double largest = 0;
    for (int i = 0; i < 3 * count; i++)
        largest = bat_max(largest, fabs(vectors[i / 3][i % 3]));
    /* Products of six numbers of these sizes neither overflow nor vanish. */
    if (largest > 1e-50 && largest < 1e50)
        return 1;
    const double scale = largest > 0 ? ldexp(1, ilogb(largest)) : 1;
    for (int i = 0; i < 3 * count; i++)
        vectors[i / 3][i % 3] /= scale;
    return scale;
}

static double to_segment(const double *to, const double *along)
{
    const double square = dot(along, along);
    const double t = square > 0 ? bat_min(bat_max(dot(to, along) / square, 0), 1) : 0;
    double foot[3];
    for (int k = 0; k < 3; k++)
        foot[k] = to[k] - t * along[k];
    return sqrt(dot(foot, foot));
}

double bat_distance_to_segment(const double *p, const double *a, const double *b)
{
    double v[2][3];
    subtract(p, a, v[0]);
    subtract(b, a, v[1]);
    const double scale = scale_all(2, v);
    return scale * to_segment(v[0], v[1]);
}

double bat_distance_to_triangle(const double *p, const double *a, const double *b,
                                const double *c)
{
    double v[5][3], n[3];
    subtract(b, a, v[0]);
    subtract(c, a, v[1]);
    subtract(c, b, v[2]);
    subtract(p, a, v[3]);
    subtract(p, b, v[4]);
    const double scale = scale_all(5, v);
    const double *ab = v[0], *ac = v[1], *bc = v[2], *ap = v[3], *bp = v[4];
    for (int k = 0; k < 3; k++)
        n[k] = ab[(k + 1) % 3] * ac[(k + 2) % 3] - ab[(k + 2) % 3] * ac[(k + 1) % 3];
    const double longest = sqrt(bat_max(dot(ab, ab), bat_max(dot(ac, ac), dot(bc, bc))));
    const double twice_area = sqrt(dot(n, n));
    const double to_edge =
        bat_min(to_segment(ap, ab), bat_min(to_segment(ap, ac), to_segment(bp, bc)));
    if (!(twice_area > 0))
        return scale * to_edge;
    const double height = fabs(dot(ap, n)) / twice_area;
    const double s = dot(ac, ac) * dot(ap, ab) - dot(ab, ac) * dot(ap, ac);
    const double t = dot(ab, ab) * dot(ap, ac) - dot(ab, ac) * dot(ap, ab);
    if (s >= 0 && t >= 0 && s + t <= twice_area * twice_area)
        return scale * height;
    const double beside = sqrt(bat_max(to_edge * to_edge - height * height, 0));
    return scale * (beside <= twice_area / longest / 2 ? height : to_edge);
}
