/*
 * Eigenvalues and eigenvectors of a small symmetric matrix by Jacobi's rotations. Source:
 * [GVL13] 8.5.
 */
#include "numeric/eigen.h"

#include <float.h>

/* Turn rows and columns p and q so that a[p][q] vanishes. */
static void rotate_pair(int n, double *a, double *vectors, int p, int q)
{
    const double difference = (a[q * n + q] - a[p * n + p]) / 2, off = a[p * n + q];
    const double size = bat_hypot(difference, off);
    const double t = difference >= 0 ? off / (difference + size) : off / (difference - size);
    const double c = 1 / bat_hypot(1, t), s = t * c;
    for (int k = 0; k < n; k++) {
        const double x = a[k * n + p], y = a[k * n + q];
        a[k * n + p] = c * x - s * y;
        a[k * n + q] = s * x + c * y;
    }
    for (int k = 0; k < n; k++) {
        const double x = a[p * n + k], y = a[q * n + k];
        a[p * n + k] = c * x - s * y;
        a[q * n + k] = s * x + c * y;
        const double u = vectors[p * n + k], v = vectors[q * n + k];
        vectors[p * n + k] = c * u - s * v;
        vectors[q * n + k] = s * u + c * v;
    }
    a[p * n + q] = a[q * n + p] = 0;
}

static void swap(double *a, double *b)
{
    const double kept = *a;
    *a = *b;
    *b = kept;
}

static void sort(int n, double *values, double *vectors)
{
    for (int i = 1; i < n; i++)
        for (int k = i; k > 0 && values[k] < values[k - 1]; k--) {
            swap(values + k, values + k - 1);
            for (int j = 0; j < n; j++)
                swap(vectors + k * n + j, vectors + (k - 1) * n + j);
        }
}

void bat_eigen_symmetric(int n, double *a, double *values, double *vectors)
{
    for (int i = 0; i < n * n; i++)
        vectors[i] = i % (n + 1) == 0;
    /* Jacobi's method converges quadratically; ten rounds are ample. */
    for (int round = 0; round < 30; round++) {
        bool done = true;
        for (int p = 0; p < n; p++)
            for (int q = p + 1; q < n; q++) {
                const double off = fabs(a[p * n + q]);
                if (off <= DBL_EPSILON / 4 * sqrt(fabs(a[p * n + p]) * fabs(a[q * n + q])) ||
                    off < DBL_MIN)
                    continue;
                done = false;
                rotate_pair(n, a, vectors, p, q);
            }
        if (done)
            break;
    }
    for (int i = 0; i < n; i++)
        values[i] = a[i * n + i];
    sort(n, values, vectors);
}
