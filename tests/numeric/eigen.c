#include "numeric/eigen.h"

#include "support/test.h"

TEST(eigenvectors_put_a_symmetric_matrix_together_again)
{
    test_random random = test_random_begin("eigen");
    for (int c = 0; c < test_cases(200); c++) {
        const int n = 1 + c % 6;
        double a[36], given[36], values[6], vectors[36];
        for (int i = 0; i < n; i++)
            for (int j = 0; j <= i; j++)
                a[i * n + j] = a[j * n + i] =
                    c % 3 == 0 && i != j ? 0 : test_random_in(&random, -1, 1);
        memcpy(given, a, sizeof a);
        bat_eigen_symmetric(n, a, values, vectors);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                double sum = 0, dot = 0;
                for (int k = 0; k < n; k++) {
                    sum += values[k] * vectors[k * n + i] * vectors[k * n + j];
                    dot += vectors[i * n + k] * vectors[j * n + k];
                }
                CHECK_NEAR(sum, given[i * n + j], 1e-14 * n);
                CHECK_NEAR(dot, i == j, 1e-14);
            }
        for (int i = 1; i < n; i++)
            CHECK(values[i] >= values[i - 1]);
    }
}
