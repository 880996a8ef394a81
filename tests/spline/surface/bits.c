/* The promise "same input, same bits" for surfaces, for every compiler: one recorded number. */
#include <batten/surface.h>

#include "support/checksum.h"
#include "support/surfaces.h"

/* From gcc 12, and clang 14 agreed. A change of this number is a change of bits for every user:
 * say why. */
static const uint64_t RECORDED = 0x67c99ae0b6a676aau;

static uint64_t sum_of_surface(uint64_t sum, test_random *random, const batten_surface *surface,
                               const batten_job *job)
{
    enum { COUNT_U = 9, COUNT_V = 7, VALUES = BATTEN_SURFACE_DERIVATIVES(2) * 3 };
    double u[COUNT_U], v[COUNT_V], uv[COUNT_U][2], grid[COUNT_U * COUNT_V * VALUES];
    const size_t d = (size_t)batten_surface_dimension(surface);
    for (int i = 0; i < COUNT_U; i++)
        u[i] = uv[i][0] = random_parameter(random, surface, BATTEN_U);
    for (int j = 0; j < COUNT_V; j++)
        v[j] = uv[j][1] = random_parameter(random, surface, BATTEN_V);
    uv[7][1] = uv[8][1] = v[0];
    CHECK_OK(batten_surface_evaluate_grid(surface, (batten_uv_grid){COUNT_U, COUNT_V, u, v}, 2,
                                          job, grid));
    sum = test_checksum(sum, grid, COUNT_U * COUNT_V * BATTEN_SURFACE_DERIVATIVES(2) * d);
    CHECK_OK(batten_surface_evaluate_many(surface, COUNT_U, &uv[0][0], 1, job, grid));
    return test_checksum(sum, grid, COUNT_U * BATTEN_SURFACE_DERIVATIVES(1) * d);
}

TEST(surfaces_have_the_recorded_bits_with_every_compiler_and_any_number_of_threads)
{
    static const int threads[] = {1, 2, 4};
    surface_data *data = test_array(1, sizeof *data);
    for (int t = 0; t < COUNT(threads); t++) {
        test_random random = {0x853c49e6748fea9bu};
        batten_job job = BATTEN_JOB;
        job.thread_count = threads[t];
        uint64_t sum = 0;
        for (int i = 0; i < 60; i++) {
            batten_surface *surface = NULL;
            surface_data_random(&random, 1 + i % 6, data);
            CHECK_OK(surface_data_create(data, &surface));
            sum = sum_of_surface(sum, &random, surface, &job);
            batten_surface_unref(surface);
        }
        if (sum != RECORDED)
            printf("the number is 0x%llx\n", (unsigned long long)sum);
        CHECK(sum == RECORDED);
    }
}
