/* The bound of points on surfaces, in r = 2^-53, against sums in higher precision: knots that
 * nearly coincide or grow geometrically, control points that fall together, unequal weights. */
#include "support/surfaces.h"

#if defined(__SIZEOF_FLOAT128__) && !defined(__clang__)
__extension__ typedef __float128 wide;
#else
typedef long double wide;
#endif

enum { MOST = 12 };
typedef enum { UNIFORM, NEAR_EQUAL, GEOMETRIC, FAMILIES } family;

static double step_of(test_random *random, family kind, int i)
{
    if (kind == UNIFORM)
        return 1;
    if (kind == GEOMETRIC)
        return ldexp(1e-9, i * 3);
    return test_random_int(random, 0, 1) ? 1e-12 : test_random_in(random, 0.5, 1);
}

static void fill_knots(test_random *random, family kind, int p, int n, double *knots)
{
    for (int i = 0; i <= n + p; i++) {
        const bool end = i <= p || i > n;
        knots[i] = (i ? knots[i - 1] : 0) + (end ? 0 : step_of(random, kind, i));
    }
}

static batten_surface *surface_of(test_random *random, family kind, bool rational)
{
    double knots[2][2 * MOST], points[MOST * MOST * 3], weights[MOST * MOST];
    batten_axis axes[2];
    for (int k = 0; k < 2; k++) {
        const int p = test_random_int(random, 1, 5), n = test_random_int(random, p + 1, MOST);
        fill_knots(random, kind, p, n, knots[k]);
        axes[k] = (batten_axis){.degree = p, .point_count = n, .knots = knots[k]};
    }
    const int n = axes[0].point_count * axes[1].point_count;
    for (int i = 0; i < n; i++) {
        const bool collapsed = i > 0 && test_random_int(random, 0, 9) == 0;
        for (int c = 0; c < 3; c++)
            points[3 * i + c] =
                collapsed ? points[3 * i - 3 + c] : test_random_in(random, -1, 1);
        weights[i] = test_random_in(random, 0.1, 10);
    }
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points, rational ? weights : NULL,
                                   &surface));
    return surface;
}

/* All basis functions that bear on u, by the triangle of Cox and de Boor; the first of them is
 * returned. */
static int basis(const batten_surface *surface, batten_direction direction, double u, wide *N)
{
    const double *U = batten_surface_knots(surface, direction);
    const int p = batten_surface_degree(surface, direction),
              n = batten_surface_point_count(surface, direction);
    int k = p;
    while (k + 1 < n && U[k + 1] <= u)
        k++;
    N[0] = 1;
    for (int e = 1; e <= p; e++) {
        wide kept = 0;
        for (int j = 0; j < e; j++) {
            const wide share = N[j] / ((wide)U[k + 1 + j] - U[k + 1 + j - e]);
            N[j] = kept + (U[k + 1 + j] - (wide)u) * share;
            kept = ((wide)u - U[k + 1 + j - e]) * share;
        }
        N[e] = kept;
    }
    return k - p;
}

static void reference(const batten_surface *surface, double u, double v, wide out[3])
{
    wide Nu[6], Nv[6], sum[4] = {0};
    const int i0 = basis(surface, BATTEN_U, u, Nu), j0 = basis(surface, BATTEN_V, v, Nv);
    const double *P = batten_surface_points(surface), *W = batten_surface_weights(surface);
    const int m = batten_surface_point_count(surface, BATTEN_V);
    for (int i = 0; i <= batten_surface_degree(surface, BATTEN_U); i++)
        for (int j = 0; j <= batten_surface_degree(surface, BATTEN_V); j++) {
            const int at = (i0 + i) * m + j0 + j;
            const wide w = Nu[i] * Nv[j] * (W ? W[at] : 1);
            for (int c = 0; c < 3; c++)
                sum[c] += w * P[3 * at + c];
            sum[3] += w;
        }
    for (int c = 0; c < 3; c++)
        out[c] = sum[c] / sum[3];
}

/* A parameter anywhere in a span, or within 1e-12 of its length of either end. */
static double parameter(test_random *random, const batten_surface *surface,
                        batten_direction direction)
{
    const double *U = batten_surface_knots(surface, direction);
    const int p = batten_surface_degree(surface, direction),
              n = batten_surface_point_count(surface, direction);
    const int k = test_random_int(random, p, n - 1), where = test_random_int(random, 0, 2);
    const double t = where == 0 ? test_random_unit(random) : where == 1 ? 1e-12 : 1 - 1e-12;
    return U[k] + t * (U[k + 1] - U[k]);
}

static double worst_error(bool rational)
{
    test_random random = test_random_begin("surface accuracy");
    double worst = 0;
    for (int i = 0; i < test_cases(1500); i++) {
        batten_surface *surface = surface_of(&random, (family)(i % FAMILIES), rational);
        const int degrees =
            batten_surface_degree(surface, BATTEN_U) + batten_surface_degree(surface, BATTEN_V);
        for (int k = 0; k < 10; k++) {
            const double u = parameter(&random, surface, BATTEN_U),
                         v = parameter(&random, surface, BATTEN_V);
            double out[3];
            wide point[3];
            CHECK_OK(batten_surface_evaluate(surface, u, v, 0, out));
            reference(surface, u, v, point);
            for (int c = 0; c < 3; c++)
                worst = fmax(worst, fabs((double)(out[c] - point[c])) / (degrees * 0x1p-53));
        }
        batten_surface_unref(surface);
    }
    return worst;
}

/* Coordinates are at most 1; each degree of either direction costs a few roundings: seen 1.9
 * and 2.4. */
TEST(points_of_polynomial_surfaces_keep_their_bound)
{
    CHECK_NEAR(worst_error(false), 0, 4);
}

TEST(points_of_rational_surfaces_are_as_accurate_near_both_ends_of_a_span)
{
    CHECK_NEAR(worst_error(true), 0, 4);
}
