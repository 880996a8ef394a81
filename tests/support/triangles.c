#include "support/triangles.h"

batten_status random_triangles(test_random *random, int dimension, int degree, int count,
                               bool rational, const batten_triangulation *domain,
                               batten_triangles **out)
{
    const size_t total = (size_t)count * BATTEN_TRIANGLE_POINTS((size_t)degree);
    double *points = test_array(total * (size_t)dimension, sizeof *points);
    double *weights = test_array(total, sizeof *weights);
    for (size_t i = 0; i < total * (size_t)dimension; i++)
        points[i] = test_random_in(random, -1, 1);
    for (size_t i = 0; i < total; i++)
        weights[i] = test_random_in(random, 0.5, 2);
    return batten_triangles_create(&(batten_triangles_parts){dimension, degree, count, points,
                                                             rational ? weights : NULL, domain},
                                   out);
}

void random_place(test_random *random, double at[3])
{
    const int kind = test_random_int(random, 0, 9), e = test_random_int(random, 0, 2);
    double u = test_random_unit(random), v = test_random_unit(random);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    if (kind == 0)
        u = v = 0;
    if (kind == 1)
        v = 0;
    at[e] = 1 - u - v;
    at[(e + 1) % 3] = u;
    at[(e + 2) % 3] = v;
}

void define_triangle_point(const batten_triangles *triangles, int triangle, const double at[3],
                           double *out)
{
    const int n = batten_triangles_degree(triangles), d = batten_triangles_dimension(triangles);
    const size_t first = (size_t)triangle * BATTEN_TRIANGLE_POINTS((size_t)n);
    const double *points = batten_triangles_points(triangles) + first * (size_t)d;
    const double *weights = batten_triangles_weights(triangles);
    long double sum[4] = {0};
    for (int j = 0; j <= n; j++)
        for (int k = 0; j + k <= n; k++) {
            const int i = n - j - k, index = BATTEN_TRIANGLE_POINT(j, k);
            long double basis = 1;
            for (int f = 1; f <= n; f++) /* n! / (i! j! k!), one factor at a time */
                basis *= (long double)f / (f <= i ? f : f <= i + j ? f - i : f - i - j);
            for (int f = 0; f < n; f++)
                basis *= f < i ? at[0] : f < i + j ? at[1] : at[2];
            const long double w = weights ? weights[first + (size_t)index] : 1;
            for (int c = 0; c < d; c++)
                sum[c] += basis * w * points[index * d + c];
            sum[3] += basis * w;
        }
    for (int c = 0; c < d; c++)
        out[c] = (double)(weights ? sum[c] / sum[3] : sum[c]);
}

double example_cubic(double x, double y)
{
    return x * x * y + 2 * x * y - 3 * y * y + x + 5;
}

/* The blossom of the example. */
static double blossom(const double *a, const double *b, const double *c)
{
    const double xxy = (a[0] * b[0] * c[1] + a[0] * b[1] * c[0] + a[1] * b[0] * c[0]) / 3;
    const double xy =
        (a[0] * b[1] + a[1] * b[0] + a[0] * c[1] + a[1] * c[0] + b[0] * c[1] + b[1] * c[0]) / 6;
    const double yy = (a[1] * b[1] + a[1] * c[1] + b[1] * c[1]) / 3;
    return xxy + 2 * xy - 3 * yy + (a[0] + b[0] + c[0]) / 3 + 5;
}

batten_status example_triangles(int count, const batten_triangulation *domain,
                                batten_triangles **out)
{
    double *points = test_array((size_t)count * 10, sizeof *points), *to = points;
    for (int t = 0; t < count; t++)
        for (int row = 0; row <= 3; row++)
            for (int k = 0; k <= row; k++) {
                const double *arguments[3];
                for (int f = 0; f < 3; f++) {
                    const int corner = f < 3 - row ? 0 : f < 3 - k ? 1 : 2;
                    arguments[f] = domain->vertices + 2 * domain->corners[3 * t + corner];
                }
                *to++ = blossom(arguments[0], arguments[1], arguments[2]);
            }
    return batten_triangles_create(&(batten_triangles_parts){1, 3, count, points, NULL, domain},
                                   out);
}
