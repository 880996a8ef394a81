#include "support/process.h"

/* The straight line from (0, 0) to (6, 8): its length is 10, and every derivative is known. */
static const char *write_line(void)
{
    const char *design = test_scratch("line.yaml"), *folder = test_scratch("lines");
    test_write(design, "batten: 1\nfeatures:\n  line: {line: [[0, 0], [6 m, 8 m]]}\n"
                       "outputs:\n  line.g2: line\n");
    CHECK_INT(RUN("batten", "build", design, "-o", folder, "-q").exit, 0);
    return test_scratch("lines/line.g2");
}

TEST(a_line_is_evaluated_at_several_parameters_with_its_derivatives)
{
    const char *line = write_line();
    test_process run = RUN("batten", "eval", line, "--at", "0", "--at", "0.5", "--at", "1",
                           "--order", "2", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"point\": [0, 0, 0], \"derivatives\": [[6, 8, 0], [0, 0, 0]]");
    CHECK_CONTAINS(run.out, "\"point\": [3, 4, 0]");
    CHECK_CONTAINS(run.out, "\"point\": [6, 8, 0]");
    run = RUN("batten", "eval", line, "--at", "0.5");
    CHECK_CONTAINS(run.out, "3 4 0");
}

TEST(a_curve_takes_one_parameter_and_a_surface_two)
{
    const char *line = write_line();
    const test_process run = RUN("batten", "eval", line, "--at", "0,1");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "is not a surface, so 2 parameters do not fit");
}

TEST(places_outside_the_domain_are_a_usage_error_unless_it_may_be_left)
{
    const char *line = write_line();
    test_process run = RUN("batten", "eval", line, "--at", "7");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "the parameter 7 is outside the domain");
    run = RUN("batten", "eval", line, "--at", "7", "--beyond", "linear");
    CHECK_INT(run.exit, 0);
}
