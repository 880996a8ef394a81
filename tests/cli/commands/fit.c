#include "support/process.h"

static const char *write_points(void)
{
    const char *path = test_scratch("ducks.xyz");
    test_write(path, "0 0\n1 2\n3 1\n4 0\n5 3\n");
    return path;
}

TEST(fit_takes_the_parameters_of_its_method_as_options_or_behind_its_name)
{
    static const char *const words[] = {"fair", "fair:within=0.1:method=kjellander", "minimax"};
    static const char *const options[] = {"--within=0.1", "--quiet", "--degree=2"};
    static const char *const said[] = {
        "result         fair          3 points moved, at most 0.1", "",
        "result         minimax       error at most 1.19"};
    for (int i = 0; i < COUNT(words); i++) {
        const char *made = test_scratch("made.step");
        const test_process run =
            RUN("batten", "fit", write_points(), "-o", made, "--method", words[i], options[i]);
        CHECK_INT(run.exit, 0);
        CHECK_CONTAINS(run.out, said[i]);
        CHECK(test_content(made) != NULL);
    }
}

/* What is at fault is what cannot be left out. */
TEST(fit_exits_with_2_for_a_value_that_is_refused_and_with_1_for_points_that_are)
{
    const char *points = write_points(), *one = test_scratch("one.xyz");
    const char *made = test_scratch("never.step");
    test_write(one, "0 0\n");
    test_process run = RUN("batten", "fit", points, "-o", made, "--degree", "99");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "the degree is 99, not 1 to 25");
    run = RUN("batten", "fit", points, "-o", made, "--method", "interpolate:degree=99");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "the degree is 99, not 1 to 25");
    run = RUN("batten", "fit", one, "-o", made, "--degree", "99");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "has 1 point and is left out; a curve needs 2");
    run = RUN("batten", "fit", points);
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "batten fit: -o OUT is missing; see 'batten help fit'");
    CHECK(test_content(made) == NULL);
}
