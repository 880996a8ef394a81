/* Lattices of deformations for tests. */
#ifndef TESTS_SUPPORT_LATTICES_H
#define TESTS_SUPPORT_LATTICES_H
#include "support/test.h"

#include <batten/offset.h>

enum { LATTICE_MOST = 8 * 8 * 8 };

/* The box [-1, 2] x [0, 1] x [-2, 2] with the same count and degree in x, y and z. */
static inline batten_lattice test_lattice(int count, int degree)
{
    return (batten_lattice){.box = {{-1, 0, -2}, {2, 1, 2}},
                            .counts = {count, count, count},
                            .degrees = {degree, degree, degree}};
}

static inline int test_lattice_size(const batten_lattice *l)
{
    return l->counts[0] * l->counts[1] * l->counts[2];
}

/* The lattice with every point moved by up to `by` of its box's least side, but for `kept` layers at all sides. */
static inline void test_lattice_shaken(test_random *random, const batten_lattice *l, double by,
                                       int kept, double *points)
{
    const int *n = l->counts;
    CHECK_OK(batten_lattice_home(l, points));
    for (int at = 0; at < test_lattice_size(l); at++) {
        const int index[3] = {at / (n[1] * n[2]), at / n[2] % n[1], at % n[2]};
        bool stays = false;
        for (int k = 0; k < 3; k++)
            stays = stays || index[k] < kept || index[k] >= n[k] - kept;
        for (int c = 0; c < 3 && !stays; c++)
            points[3 * at + c] += test_random_in(random, -by, by);
    }
}

/* x + a z (z + 2), y, z over the same box: shears that keep volumes. Of degree 2 in z. */
static inline void test_lattice_sheared(double a, batten_lattice *l, double *points)
{
    *l = test_lattice(3, 2);
    CHECK_OK(batten_lattice_home(l, points));
    /* In [-2, 2] the blossom of z (z + 2) at (-2, -2), (-2, 2), (2, 2) is 0, -4, 8. */
    static const double bezier[3] = {0, -4, 8};
    for (int at = 0; at < test_lattice_size(l); at++)
        points[3 * at] += a * bezier[at % 3];
}

#endif
