/* The feature 'rational-tension'. */
#include "design/expect.h"
#include "support/test.h"

static const char ducks[] = "  ducks: {points: [[0, 0], [1, 0], [2, 0], [2.3, 0.8], [4, 1]]}\n"
                            "  ring: {points: [[1, 0], [0, 1], [-1, 0], [0, -1]]}\n";

TEST(rational_splines_in_tension_as_operations)
{
    static const expect_row rows[] = {
        {"{rational-tension: ducks}", BATTEN_OK, "passes; degree 4; rational 1; silent"},
        {"{rational-tension: ducks, amount: [0, 5, 20, 0]}", BATTEN_OK,
         "passes; degree 4; silent"},
        {"{rational-tension: ducks, amount: 2, as: function, parameters: given}",
         BATTEN_BAD_FORMAT, "parameters"},
        {"{rational-tension: ducks, amount: 2, as: function}", BATTEN_OK,
         "passes; degree 5; at 0 0 0 0; at 1 4 1 0"},
        {"{rational-tension: ring, closed: yes, amount: 3}", BATTEN_OK, "passes; closed 1"},
        {"{rational-tension: ducks, amount: 1e6}", BATTEN_OK,
         "passes; within 1e-5; at 1 4 1 0"},
        {"{rational-tension: ducks, amount: -1}", BATTEN_BAD_ARGUMENT,
         "the tension of span 1 is -1"},
        {"{rational-tension: ducks, amount: 1e7}", BATTEN_BAD_ARGUMENT,
         "0 to 1e+06 is possible"},
        {"{rational-tension: ducks, amount: [1, 2]}", BATTEN_BAD_ARGUMENT, "spans"},
    };
    EXPECT(ducks, rows);
}
