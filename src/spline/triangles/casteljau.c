/* De Casteljau's algorithm on the net of a triangle: its steps, and derivatives from them. */
#include "spline/triangles/triangles.h"
#include <batten/surface.h>

#include <string.h>

void bat_triangle_step(int degree, size_t width, const double b[3], double *net)
{
    for (int row = 0; row < degree; row++)
        for (int k = 0; k <= row; k++) {
            double *at = net + (size_t)BATTEN_TRIANGLE_POINT(row - k, k) * width;
            const double *second = net + (size_t)BATTEN_TRIANGLE_POINT(row + 1 - k, k) * width;
            for (size_t c = 0; c < width; c++)
                at[c] = b[0] * at[c] + b[1] * second[c] + b[2] * second[width + c];
        }
}

/* The difference p times towards corner 1 and q times towards corner 2 of a net of degree p +
 * q. */
static void difference(int p, int q, size_t width, const double *net, double *out)
{
    double choose_a = 1;
    memset(out, 0, width * sizeof *out);
    for (int a = 0; a <= p; a++) {
        double choose = choose_a;
        for (int b = 0; b <= q; b++) {
            const double factor = (p + q - a - b) % 2 ? -choose : choose;
            const double *row = net + (size_t)BATTEN_TRIANGLE_POINT(a, b) * width;
            for (size_t c = 0; c < width; c++)
                out[c] += factor * row[c];
            choose = choose * (q - b) / (b + 1);
        }
        choose_a = choose_a * (p - a) / (a + 1);
    }
}

void bat_triangle_derivatives(int degree, size_t width, const double b[3], int order,
                              double *net, double *out)
{
    const int n = degree;
    memset(out, 0, (size_t)BATTEN_SURFACE_DERIVATIVES(order) * width * sizeof *out);
    int level = n;
    for (; level > order; level--)
        bat_triangle_step(level, width, b, net);
    for (; level >= 0; level--) {
        double factor = 1;
        for (int i = 0; i < level; i++)
            factor *= n - i;
        for (int q = 0; q <= level; q++) {
            double *row = out + (size_t)BATTEN_SURFACE_DERIVATIVE(level - q, q) * width;
            difference(level - q, q, width, net, row);
            for (size_t c = 0; c < width; c++)
                row[c] *= factor;
        }
        if (level > 0)
            bat_triangle_step(level, width, b, net);
    }
}
