#include <batten/scattered.h>

#include "support/test.h"
#include "support/watcher.h"

#include <stdlib.h>
#include <string.h>

/* Who is beside whom agrees with the corners, both ways, and all triangles turn left. */
static void check_neighbours(const batten_plane_triangles *t)
{
    for (int side = 0; side < 3 * t->count; side++) {
        const int from = 3 * (side / 3), other = t->beside[side];
        const int a = t->corners[from + (side + 1 - from) % 3];
        const int b = t->corners[from + (side + 2 - from) % 3];
        int shared = 0, back = 0;
        for (int k = 0; k < 3 && other >= 0; k++) {
            const int corner = t->corners[3 * other + k];
            shared += corner == a || corner == b;
            back += t->beside[3 * other + k] == side / 3;
        }
        CHECK(other < 0 || (shared == 2 && back == 1));
        for (int k = 0; k < 3 * t->count && other < 0; k++) /* nobody else has this edge */
            CHECK(k / 3 == side / 3 || t->corners[3 * (k / 3) + (k + 1) % 3] != b ||
                  t->corners[3 * (k / 3) + (k + 2) % 3] != a);
    }
    for (int i = 0; i < t->count; i++) {
        const double *p = t->vertices + 2 * t->corners[3 * i];
        const double *q = t->vertices + 2 * t->corners[3 * i + 1];
        const double *r = t->vertices + 2 * t->corners[3 * i + 2];
        CHECK((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0);
    }
}

/* A roof |x - y| over a grid whose diagonals run across the ridge at first. */
TEST(swapped_triangles_know_their_neighbours_and_are_swapped_no_more)
{
    enum { N = 6 };
    double xy[2 * N * N], f[N * N];
    batten_plane_triangles t = {0};
    int swaps = 0, again = -1;
    for (int i = 0; i < N * N; i++) {
        xy[2 * i] = i % N;
        xy[2 * i + 1] = i / N + 1e-3 * (i % N) * (i / N);
        f[i] = abs(i % N - i / N);
    }
    CHECK_OK(batten_triangulate((batten_points){2, N * N, xy}, NULL, &t));
    check_neighbours(&t);
    const int count = t.count;
    CHECK_OK(batten_triangles_swap(&t, f, NULL, &swaps));
    CHECK(swaps > 0 && t.count == count);
    check_neighbours(&t);
    CHECK_OK(batten_triangles_swap(&t, f, NULL, &again));
    CHECK_INT(again, 0);
    batten_plane_triangles_release(&t);
}

/* A roof over a grid of 20 x 20, whose edges are looked at for longer than to the second question. */
static batten_status swap_roof(void *context, const batten_job *job)
{
    enum { N = 20 };
    (void)context;
    double xy[2 * N * N], f[N * N];
    for (int i = 0; i < N * N; i++) {
        xy[2 * i] = i % N;
        xy[2 * i + 1] = i / N + 1e-3 * (i % N) * (i / N);
        f[i] = abs(i % N - i / N);
    }
    batten_plane_triangles t = {0}, given = {0};
    batten_status status = batten_triangulate((batten_points){2, N * N, xy}, NULL, &t);
    if (status == BATTEN_OK)
        status = batten_triangulate((batten_points){2, N * N, xy}, NULL, &given);
    if (status == BATTEN_OK)
        status = batten_triangles_swap(&t, f, job, NULL);
    if (status == BATTEN_CANCELLED) {
        const size_t bytes = 3 * (size_t)given.count * sizeof(int);
        CHECK(memcmp(t.corners, given.corners, bytes) == 0);
        CHECK(memcmp(t.beside, given.beside, bytes) == 0);
    }
    batten_plane_triangles_release(&given);
    batten_plane_triangles_release(&t);
    return status;
}

TEST(swaps_that_are_cancelled_leave_the_triangles_as_they_were)
{
    check_cancelling(swap_roof, NULL, 3);
}

/* Over a plane no swap gains anything. */
TEST(triangles_of_a_plane_stay_as_they_are)
{
    const double xy[] = {0, 0, 2, 0, 2, 1.5, 0, 1, 1, 0.5}, f[] = {1, 3, 6, 3, 3};
    batten_plane_triangles t = {0};
    int corners[24], swaps = -1;
    CHECK_OK(batten_triangulate((batten_points){2, 5, xy}, NULL, &t));
    memcpy(corners, t.corners, (size_t)(3 * t.count) * sizeof *corners);
    CHECK_OK(batten_triangles_swap(&t, f, NULL, &swaps));
    CHECK_INT(swaps, 0);
    CHECK(memcmp(corners, t.corners, (size_t)(3 * t.count) * sizeof *corners) == 0);
    batten_plane_triangles_release(&t);
}
