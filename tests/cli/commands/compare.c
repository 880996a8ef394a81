#include "support/process.h"

static const char *write_points(void)
{
    const char *path = test_scratch("ducks.xyz");
    test_write(path, "0 0\n1 .6\n2 .1\n3 .9\n3.2 2\n2 2.5\n");
    return path;
}

TEST(compare_draws_a_picture_and_prints_a_table)
{
    const char *points = write_points(), *picture = test_scratch("curves.svg");
    const test_process run =
        RUN("batten", "compare", points, "-o", picture, "--methods", "interpolate,biarcs");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "energy");
    CHECK_CONTAINS(run.out, "\nbiarcs ");
    CHECK_CONTAINS(test_content(picture), "<svg");
}

TEST(compare_calls_the_variation_of_arcs_infinite)
{
    const char *points = write_points(), *picture = test_scratch("arcs.svg");
    const test_process run =
        RUN("batten", "compare", points, "-o", picture, "--methods", "interpolate,biarcs");
    CHECK_CONTAINS(strstr(run.out, "\nbiarcs "), " inf ");
    CHECK_CONTAINS(run.out, "\ninf: ");
    const test_process json = RUN("batten", "compare", points, "-o", picture, "--methods",
                                  "interpolate,biarcs", "--json");
    const char *biarcs = strstr(json.out, "\"biarcs\"");
    CHECK(biarcs != NULL);
    CHECK_CONTAINS(biarcs, "\"variation\": null, \"corners\": 0, \"curvature_jumps\": ");
    CHECK(strstr(json.out, "\"variation\": null") > biarcs);
}

TEST(compare_keeps_its_columns_with_long_names)
{
    const char *points = write_points(), *picture = test_scratch("long.svg");
    const test_process run = RUN("batten", "compare", points, "-o", picture, "--methods",
                                 "interpolate:parameters=chord:ends=natural,akima");
    const char *head = strstr(run.out, "feature "), *row = strstr(run.out, "\nakima ");
    CHECK(head && row);
    CHECK_INT(strstr(row + 2, " akima ") - row, strstr(head, "operation") - head);
}

TEST(compare_takes_settings_behind_colons)
{
    const char *points = write_points(), *picture = test_scratch("curves.png");
    const test_process run =
        RUN("batten", "compare", points, "-o", picture, "-m",
            "interpolate:parameters=chord:ends=natural,tension:amount=5", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"name\": \"interpolate parameters=chord ends=natural\"");
    CHECK_CONTAINS(run.out, "\"energy\": ");
}

/* A setting without a value is 'yes', wherever the next has one. */
TEST(compare_takes_settings_without_a_value)
{
    const char *points = write_points(), *picture = test_scratch("closed.svg");
    const test_process run = RUN("batten", "compare", points, "-o", picture, "-m",
                                 "interpolate:periodic:parameters=chord,biarcs:joint=given:"
                                 "place=0.25:closed",
                                 "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"name\": \"interpolate periodic parameters=chord\"");
    CHECK_CONTAINS(run.out, "\"name\": \"biarcs joint=given place=0.25 closed\"");
}

TEST(compare_prints_no_table_behind_a_picture_that_it_prints)
{
    static const char *const options[] = {"--comb", "--quiet"};
    for (int i = 0; i < COUNT(options); i++) {
        const test_process run =
            RUN("batten", "compare", write_points(), "-o", "-", "-m", "akima", options[i]);
        CHECK_INT(run.exit, 0);
        CHECK(strncmp(run.out, "<?xml", 5) == 0);
        CHECK_TEXT(strstr(run.out, "</svg>"), "</svg>\n");
    }
    const test_process quiet = RUN("batten", "compare", write_points(), "-o",
                                   test_scratch("quiet.svg"), "-m", "akima", "-q");
    CHECK_TEXT(quiet.out, "");
}

TEST(compare_takes_lists_in_brackets)
{
    const char *points = write_points(), *picture = test_scratch("lists.svg");
    const test_process run = RUN("batten", "compare", points, "-o", picture, "-m",
                                 "spiro:curvature=[3,4],interpolate", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"name\": \"spiro curvature=[3,4]\"");
    CHECK_CONTAINS(run.out, "\"name\": \"interpolate\"");
}

TEST(compare_leaves_out_what_fails_and_says_why)
{
    const char *points = test_scratch("two.xyz"), *picture = test_scratch("curves.svg");
    test_write(points, "0 0\n1 1\n0 2\n0.5 1\n");
    const test_process run = RUN("batten", "compare", points, "-o", picture, "-m",
                                 "interpolate,tension:as=function");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.errors, "left out: ");
    CHECK_CONTAINS(run.errors, "rising abscissae");
    CHECK(strstr(run.out, "tension") == NULL);
}

TEST(compare_without_a_method_that_works_fails)
{
    const char *points = test_scratch("two.xyz"), *picture = test_scratch("none.svg");
    test_write(points, "0 0\n1 1\n0 2\n");
    const test_process run =
        RUN("batten", "compare", points, "-o", picture, "-m", "tension:as=function");
    CHECK_INT(run.exit, 1);
    CHECK(test_content(picture) == NULL);
}

TEST(U1_compare_names_what_is_wrong)
{
    const char *points = write_points();
    CHECK_INT(RUN("batten", "compare", points).exit, 2);
    CHECK_INT(RUN("batten", "compare", points, "-o", "x.step").exit, 2);
    const test_process run = RUN("batten", "compare", points, "-o", "x.svg", "-m", "biarc");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "did you mean 'biarcs'");
}

TEST(compare_all_takes_every_method_that_needs_points_alone)
{
    const char *points = write_points(), *picture = test_scratch("all.svg");
    const test_process run = RUN("batten", "compare", points, "-o", picture, "-m", "all");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\ninterpolate ");
    CHECK_CONTAINS(run.out, "\ntension ");
}
