#include "numeric/select.h"

#include "support/test.h"

TEST(the_kth_smallest_is_that_of_the_sorted_row)
{
    test_random random = test_random_begin("select");
    for (int n = 1; n <= 40; n++)
        for (int k = 0; k < n; k++) {
            double values[40];
            int below = 0, equal = 0;
            for (int i = 0; i < n; i++)
                values[i] = test_random_int(&random, 0, n / 2); /* many equal ones */
            const double found = bat_select((size_t)n, values, (size_t)k);
            for (int i = 0; i < n; i++) {
                below += values[i] < found;
                equal += values[i] == found;
            }
            CHECK(below <= k && k < below + equal);
        }
}
