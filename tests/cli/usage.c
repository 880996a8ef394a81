#include "support/process.h"
#include "support/prose.h"

#include <string.h>

static void check_usage(test_process run, const char *words)
{
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, words);
    CHECK_TEXT(run.out, "");
}

TEST(U1_a_missing_file_is_a_usage_error)
{
    check_usage(RUN("batten", "info"), "a file is missing");
    check_usage(RUN("batten", "convert", "a.igs"), "another file is missing");
}

TEST(U1_an_unknown_option_is_named_with_the_nearest)
{
    check_usage(RUN("batten", "info", "--jsno", "x"), "did you mean --json");
    check_usage(RUN("batten", "build", "-z", "x"), "-z");
}

TEST(U1_an_option_that_would_be_ignored_is_refused)
{
    check_usage(RUN("batten", "check", "hull.yaml", "--within", "1mm"), "--within");
    check_usage(RUN("batten", "check", "hull.yaml", "--unit", "mm"), "--unit");
}

TEST(U1_a_bound_that_is_no_length_above_0_is_refused_before_any_work)
{
    static const char *const wrong[] = {"-3mm", "0", "1e-400", "nan", "", "1e400", "3parsec"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        /* the file does not exist, which nobody gets to see */
        check_usage(RUN("batten", "check", "none.igs", "--within", wrong[i]), "--within");
        check_usage(RUN("batten", "measure", "none.igs", "--within", wrong[i]), "--within");
        check_usage(RUN("batten", "fair", "none.csv", "-o", "a.csv", "--within", wrong[i]),
                    "--within");
        check_usage(RUN("batten", "fit", "none.csv", "-o", "a.igs", "--method", "fit-within",
                        "--within", wrong[i]),
                    "--within");
    }
}

TEST(U1_numbers_that_an_operation_does_not_take_are_refused_before_any_work)
{
    static const struct {
        const char *command, *option, *values[5];
    } wrong[] = {
        {"check", "--angle", {"0", "-1", "nan", "3mm", ""}},
        {"check", "--curvature", {"-1", "0", "1e400", "x", "1deg"}},
        {"fair", "--corner-angle", {"30", "deg", "", "-1", "inf"}},
        {"fit", "--degree", {"-1", "2.5", "nan", "", "0"}},
        {"draw", "--width", {"0", "-1", "63", "x", ""}},
        {"draw", "--isolines", {"0", "-1", "1.5", "x", ""}},
        {"draw", "--spacing", {"-1", "-1mm", "nan", "", "1deg"}},
        {"draw", "--distance", {"-1", "x", "1e400", "", "2kg"}},
        {"draw", "--azimuth", {"30", "x", "1mm", "", "nan"}},
        {"build", "--threads", {"0", "-1", "1.5", "65", "two"}},
        {"convert", "--threads", {"nan", "", "1e400", "0x", "2mm"}},
        {"compare", "--height", {"0", "-5", "64.5", "", "x"}},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        for (int k = 0; k < 5; k++) /* the file does not exist, which nobody gets to see */
            check_usage(RUN("batten", wrong[i].command, "none.igs", wrong[i].option,
                            wrong[i].values[k]),
                        wrong[i].option);
}

TEST(every_command_that_works_takes_a_number_of_threads)
{
    static const char *const commands[] = {"build", "fit",  "fair",    "check",   "info",
                                           "eval",  "draw", "convert", "compare", "measure"};
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        check_usage(RUN("batten", commands[i], "none.igs", "--threads", "0"), "--threads");
        CHECK_CONTAINS(RUN("batten", "help", commands[i]).out, "--threads N");
    }
}

TEST(U1_values_that_the_operation_itself_refuses_are_usage_errors)
{
    const char *points = test_scratch("refused.xyz"), *out = test_scratch("refused.igs"),
               *design = test_scratch("refused.yaml");
    test_write(points, "0 0\n1 1\n2 0\n3 1\n4 0\n5 1\n6 2\n7 1\n");
    test_write(design,
               "batten: 1\nparameters: {a: 1}\nfeatures:\n  l: {line: [[0, 0], [1, =a]]}\n");
    static const char *const fits[][3] = {{"--method=tension", "--amount=-1", "-1"},
                                          {"--method=smooth", "--lambda=-1", "-1"},
                                          {"--method=smooth", "--order=9", "9"},
                                          {"--method=interpolate", "--degree=100", "100"},
                                          {"--method=aerofoil", "--panels=7", "7"},
                                          {"--method=write", "--unit=m", "write"},
                                          {"--method=interpolate", "--unit=ell", "ell"}};
    for (size_t i = 0; i < sizeof fits / sizeof fits[0]; i++)
        check_usage(RUN("batten", "fit", points, "-o", out, fits[i][0], fits[i][1]),
                    fits[i][2]);
    /* The input is at fault, whatever the options. */
    CHECK_INT(RUN("batten", "fit", points, "-o", out, "--method=aerofoil", "--panels=40").exit,
              1);
    check_usage(RUN("batten", "compare", points, "-o", "x.svg", "--unit", "ell"), "ell");
    check_usage(RUN("batten", "build", design, "--set", "a"), "NAME=VALUE");
    check_usage(RUN("batten", "build", design, "--set", "b=1"), "'b'");
    check_usage(RUN("batten", "build", design, "--only", "k"), "'k'");
}

TEST(U1_an_option_is_not_the_value_of_another)
{
    check_usage(RUN("batten", "check", "none.igs", "--within", "--json"), "needs a value");
    check_usage(RUN("batten", "check", "none.igs", "--within", "-q"), "needs a value");
    check_usage(RUN("batten", "check", "none.igs", "--within", "--unit=mm"), "needs a value");
}

TEST(U1_a_parameter_that_is_no_number_is_refused)
{
    check_usage(RUN("batten", "eval", "x.igs", "--at", "1e400"), "1e400");
    check_usage(RUN("batten", "eval", "x.igs", "--at", "1,2,3"), "1,2,3");
}

TEST(U1_an_unknown_command_is_named_with_the_nearest)
{
    check_usage(RUN("batten", "biuld"), "did you mean 'build'");
}

TEST(U1_a_repeated_option_is_refused)
{
    check_usage(RUN("batten", "build", "-o", "a", "--output", "b", "x.yaml"),
                "--output is given twice");
}

TEST(U1_an_option_without_its_value_is_refused)
{
    check_usage(RUN("batten", "eval", "x.igs", "--at"), "--at needs a value");
    check_usage(RUN("batten", "info", "--json=yes", "x"), "--json takes no value");
}

TEST(U1_a_word_where_a_number_stands_is_refused)
{
    check_usage(RUN("batten", "eval", "x.igs", "--at", "0", "--order", "many"),
                "wants a number");
    check_usage(RUN("batten", "eval", "x.igs", "--at", "0", "--order", "-1"), "whole number");
    check_usage(RUN("batten", "eval", "x.igs", "--at", "0", "--beyond", "far"), "not 'far'");
}

TEST(U1_too_many_files_are_refused)
{
    check_usage(RUN("batten", "info", "a", "b"), "'b' is one word too many");
}

TEST(U1_a_hundred_thousand_words_are_a_usage_error)
{
    const test_process run = test_shell("\"$BATTEN\" info $(seq 100000)");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "one word too many");
}

TEST(U1_required_options_are_named)
{
    check_usage(RUN("batten", "fit", "x.xyz"), "-o OUT is missing");
    check_usage(RUN("batten", "fair", "x.csv", "-o", "y.csv"), "--within TOL is missing");
    check_usage(RUN("batten", "draw", "x.csv"), "-o PICTURE is missing");
    check_usage(RUN("batten", "draw", "x.csv", "-o", "x.gif"), "ends neither in");
}

TEST(U1_nothing_is_written_after_a_usage_error)
{
    const char *target = test_scratch("never.step");
    check_usage(RUN("batten", "fit", "x.xyz", "-o", target, "--nonsense", "1"), "--nonsense");
    CHECK(test_content(target) == NULL);
}

TEST(help_says_what_there_is)
{
    const test_process run = RUN("batten", "help");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "build");
    CHECK_CONTAINS(run.out, "Exit status");
    CHECK_INT(RUN("batten", "--help").exit, 0);
    CHECK_CONTAINS(RUN("batten", "help", "skin").out, "batten_surface_skin");
    CHECK_CONTAINS(RUN("batten", "build", "--help").out, "--allow-outside");
    CHECK_CONTAINS(RUN("batten", "--version").out, batten_version());
}

/* Behind the line of its usage, which is as long as it is. */
TEST(no_help_text_has_an_orphan_line)
{
    static const char *const topics[] = {
        "build", "fit",     "fair", "check",  "info",  "measure", "eval",     "convert",
        "draw",  "compare", "help", "design", "files", "formats", "features", "hydrostatics"};
    for (size_t i = 0; i < sizeof topics / sizeof topics[0]; i++) {
        const test_process run = RUN("batten", "help", topics[i]);
        const char *text = strncmp(run.out, "usage:", 6) == 0 ? strchr(run.out, '\n') : run.out;
        const char *orphan = test_orphan_line(text);
        CHECK_TEXT(orphan ? orphan : "", "");
    }
    CHECK(test_orphan_line("one of many words in a line\nand two\nmore of them\n") != NULL);
    CHECK(test_orphan_line("one of many words in a line\nand two\n\nmore of them\n") == NULL);
}

TEST(help_shows_the_tables_that_are_read)
{
    CHECK_CONTAINS(RUN("batten", "help", "files").out, "station\\height,");
    CHECK_CONTAINS(RUN("batten", "help", "files").out, "2-8-6");
}

TEST(help_finds_names_without_their_hyphens)
{
    CHECK_CONTAINS(RUN("batten", "help", "gcode").out, "g-code: ");
    CHECK_INT(RUN("batten", "help", "gcxode").exit, 2);
}

TEST(help_about_nothing_known_names_the_nearest)
{
    check_usage(RUN("batten", "help", "skjn"), "did you mean 'skin'");
    CHECK_CONTAINS(RUN("batten", "help", "skinn").out, "Or did you mean 'skin'?");
}

TEST(without_a_word_the_help_is_shown_and_the_status_is_that_of_wrong_usage)
{
    CHECK_INT(RUN("batten").exit, 2);
}

/* Waiting for input, it ends when it is told to, with the status that shells expect. */
TEST(a_signal_ends_the_command)
{
    const test_process told =
        test_shell("sleep 1 | timeout --preserve-status -s TERM 0.2 $BATTEN info -");
    CHECK_INT(told.exit, 128 + 15);
}

TEST(U1_an_angle_without_its_unit_is_said_without_a_place_in_no_text)
{
    const char *points = test_scratch("angle.xyz"), *picture = test_scratch("angle.svg");
    test_write(points, "0 0 0\n1 2 0\n3 3 1\n");
    test_process run =
        RUN("batten", "draw", points, "-o", picture, "--azimuth", "30", "--elevation", "20");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors,
                   "--azimuth wants an angle with its unit, as 30deg or 0.5rad, not '30'");
    CHECK_CONTAINS(run.errors, "--elevation wants an angle with its unit");
    CHECK(strstr(run.errors, "column") == NULL);
    CHECK_INT(RUN("batten", "draw", points, "-o", picture, "--azimuth", "30deg").exit, 0);
    run = RUN("batten", "help", "draw");
    CHECK_CONTAINS(run.out, "--azimuth ANGLE ");
    CHECK_CONTAINS(run.out, "\nAn ANGLE has a unit, 30deg or 0.5rad");
}
