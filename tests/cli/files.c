#include "support/process.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char table[] = "station,height,half_breadth\n"
                            "0,0,0\n0,1,1\n0,2,1.5\n"
                            "1,0,0\n1,1,1.2\n1,2,1.7\n"
                            "2,0,0\n2,1,1.1\n2,2,1.6\n"
                            "3,0,0\n3,1,0.6\n3,2,1.2\n";

static const char *write_table(const char *name)
{
    const char *path = test_scratch(name);
    test_write(path, table);
    return path;
}

TEST(F1_what_cannot_be_read_is_refused_with_the_reason)
{
    test_process run = RUN("batten", "info", "/no/such/file");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "No such file");
    run = RUN("batten", "info", "/tmp");
    CHECK_INT(run.exit, 1);
    run = RUN("batten", "info", "/dev/null");
    CHECK_INT(run.exit, 1);
}

TEST(F8_odd_file_names_work_and_are_shown_escaped)
{
    static const char *const names[] = {"with blank.csv", "quo\"te'.csv", "-dash.csv",
                                        "new\nline.csv",  "b\xff.csv",    "hash#.csv"};
    for (int i = 0; i < COUNT(names); i++) {
        const char *path = write_table(names[i]);
        CHECK_INT(RUN("batten", "info", path).exit, 0);
    }
    const test_process missing = RUN("batten", "info", test_scratch("not\there\n.csv"));
    CHECK_INT(missing.exit, 1);
    CHECK_CONTAINS(missing.errors, "\\x0a");
}

TEST(W8_a_full_or_closed_standard_output_is_a_failure)
{
    const test_process run = test_shell(
        "\"$BATTEN\" help > /dev/full; a=$?; \"$BATTEN\" help features >&-; echo $a $?");
    CHECK_CONTAINS(run.out, "1 1");
    CHECK_CONTAINS(run.errors, "standard output");
    char line[1024];
    snprintf(line, sizeof line,
             "for c in 'info %s' 'info %s --json' 'convert %s - --format points'; do "
             "\"$BATTEN\" $c > /dev/full; a=$?; \"$BATTEN\" $c >&-; echo $a $?; done",
             write_table("full.csv"), write_table("full.csv"), write_table("full.csv"));
    CHECK_TEXT(test_shell(line).out, "1 1\n1 1\n1 1\n");
}

TEST(W8_a_closed_pipe_is_a_failure)
{
    const test_process run =
        test_shell("{ sleep 0.2; \"$BATTEN\" help; echo status $? >&2; } | true");
    CHECK_CONTAINS(run.errors, "status 1");
}

static const char *write_design(const char *name, const char *operation)
{
    const char *path = test_scratch(name);
    char text[300];
    snprintf(
        text, sizeof text,
        "batten: 1\nparameters:\n  height: 2\nfeatures:\n  a: {%s: [[0, 0], [1, =height]]}\n",
        operation);
    test_write(path, text);
    return path;
}

TEST(what_is_wrong_in_a_design_is_said_once)
{
    const test_process run = RUN("batten", "build", write_design("once.yaml", "pionts"));
    CHECK_INT(run.exit, 1);
    const char *first = strstr(run.errors, "operation 'pionts'; did you mean 'points'?");
    CHECK(first != NULL);
    CHECK(strstr(first + 12, "pionts") == NULL);
    CHECK_CONTAINS(run.errors, "once.yaml:5:");
}

TEST(set_refuses_a_parameter_that_the_design_has_not)
{
    const char *path = write_design("set.yaml", "points");
    CHECK_INT(RUN("batten", "build", path, "--set", "height=3").exit, 0);
    const test_process run = RUN("batten", "build", path, "--set", "hieght=3");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "no parameter 'hieght'; did you mean 'height'?");
}

TEST(info_tells_what_is_in_a_file)
{
    const char *path = write_table("table.csv");
    const test_process run = RUN("batten", "info", path, "--json");
    CHECK_INT(run.exit, 0);
    static const char *const keys[] = {
        "\"unit\"",      "\"objects\"", "\"name\"",    "\"type\"",     "\"kind\"",
        "\"dimension\"", "\"degree\"",  "\"points\"",  "\"rational\"", "\"closed\"",
        "\"domain\"",    "\"box\"",     "\"messages\""};
    for (int i = 0; i < COUNT(keys); i++)
        CHECK_CONTAINS(run.out, keys[i]);
}

TEST(build_makes_the_other_outputs_when_one_fails)
{
    const char *path = test_scratch("some.yaml");
    test_write(path, "batten: 1\nfeatures:\n  a: {points: [[0, 0], [1, 1], [0, 2], [0.5, 1]]}\n"
                     "  bad: {tension: a, as: function}\n  good: {interpolate: a, degree: 2}\n"
                     "outputs:\n  bad.igs: bad\n  worse.igs: bad\n  good.igs: good\n");
    const test_process run = RUN("batten", "build", path);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "some.yaml:4: bad (tension): ");
    CHECK_CONTAINS(run.errors, "some.yaml:7: bad.igs (write): it needs 'bad', which failed");
    CHECK_CONTAINS(run.errors, "some.yaml:8: worse.igs (write): ");
    CHECK_CONTAINS(run.errors, "1 of 3 outputs were made");
    CHECK(strstr(run.errors, "good.igs") == NULL);
    CHECK_CONTAINS(run.out, "wrote good.igs");
    CHECK_CONTAINS(test_content(test_scratch("good.igs")), "S      1");
    CHECK(test_content(test_scratch("bad.igs")) == NULL);
}

TEST(a_file_where_the_folder_of_outputs_is_to_be_is_said_before_the_work)
{
    const char *design = test_scratch("folder.yaml"), *file = test_scratch("folder");
    test_write(file, "kept");
    test_write(design, "batten: 1\nfeatures:\n  a: {line: [[0, 0], [1, 1]]}\n"
                       "outputs:\n  a.igs: a\n  b.igs: a\n");
    const test_process run = RUN("batten", "build", design, "-o", file);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "folder' should be the folder of the outputs, but is a file\n");
    const char *end = strchr(run.errors, '\n');
    CHECK(end && !end[1]);
    CHECK(strstr(run.out, "line") == NULL);
    CHECK_TEXT(test_content(file), "kept");
}

TEST(points_of_a_design_have_commas_in_csv)
{
    const char *design = test_scratch("points.yaml");
    test_write(design, "batten: 1\nunits: mm\nfeatures:\n  a: {points: [[0, 0], [1.5, 2]]}\n"
                       "outputs:\n  a.csv: {write: a}\n");
    CHECK_INT(RUN("batten", "build", design, "-q").exit, 0);
    CHECK_TEXT(test_content(test_scratch("a.csv")), "x_mm,y_mm,z_mm\n0,0,0\n1.5,2,0\n");
}

TEST(one_point_is_not_several)
{
    const char *points = test_scratch("lone.xyz"), *curve = test_scratch("lone.igs");
    test_write(points, "5 5 5\n\n0 0 0\n1 1 0\n2 0 0\n");
    CHECK_CONTAINS(RUN("batten", "fit", points, "-o", curve).errors,
                   "has 1 point and is left out; a curve needs 2");
}

TEST(lists_and_vectors_can_be_given_as_options)
{
    const char *points = test_scratch("listed.xyz");
    test_write(points, "0 0\n1 .6\n2 .1\n3 .9\n3.2 2\n2 2.5\n");
    static const char *const pairs[][3] = {{"--start-vector=[1, 0, 0]", "interpolate", NULL},
                                           {"--start-vector=1,0,0", "interpolate", NULL},
                                           {"--start-vector=x", "interpolate", NULL},
                                           {"--curvature=[3, 4]", "spiro", NULL},
                                           {"--curvature=3,4", "spiro", NULL},
                                           {"--curvature=3", "spiro", "--curvature=4"}};
    const char *content[COUNT(pairs)];
    const char *curve = test_scratch("listed.igs");
    for (int i = 0; i < COUNT(pairs); i++) {
        const bool is_spiro = i >= 3;
        const test_process run =
            RUN("batten", "fit", points, "-o", curve, "--method", pairs[i][1], pairs[i][0],
                is_spiro ? (pairs[i][2] ? pairs[i][2] : "--ends=free") : "--start=direction");
        CHECK_INT(run.exit, 0);
        content[i] = test_content(curve);
        if (i % 3)
            CHECK_TEXT(content[i], content[i - 1]);
    }
    CHECK_INT(RUN("batten", "fit", points, "-o", curve, "--start=direction",
                  "--start-vector=[1, 0, 0], degree: [2]")
                  .exit,
              2);
}

TEST(points_alone_have_no_verdict)
{
    const char *points = test_scratch("alone.xyz");
    test_write(points, "0 0\n1 1\n2 0\n3 2\n4 0\n5 1\n");
    const test_process run = RUN("batten", "check", points);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "No verdict: ");
    CHECK_CONTAINS(run.out, "'batten fit'");
    CHECK_CONTAINS(RUN("batten", "check", points, "--json").out, "\"fair\": null");
    CHECK_CONTAINS(RUN("batten", "check", write_table("alone.csv")).out, "No verdict: ");
}

static const char *write_wavy(const char *name)
{
    const char *path = test_scratch(name);
    test_write(path, "0 0\n1 1.9\n2 3.1\n3 4.4\n4 4.3\n5 4.1\n6 3\n7 1.9\n8 0.1\n");
    return path;
}

TEST(fair_takes_points_as_the_curve_through_them)
{
    const char *points = write_wavy("bumpy.xyz"), *faired = test_scratch("faired.xyz");
    const char *design = test_scratch("faired.yaml");
    CHECK_INT(RUN("batten", "fair", points, "-o", faired, "--within", "20 cm").exit, 0);
    const char *alone = test_content(faired);
    CHECK_CONTAINS(alone, "\n");
    test_write(
        design,
        "batten: 1\nfeatures:\n  input: {read: bumpy.xyz}\n  curve: {interpolate: input}\n"
        "  result: {fair: curve, within: 20 cm}\noutputs:\n  faired.xyz: result\n");
    CHECK_INT(RUN("batten", "build", design).exit, 0);
    CHECK_TEXT(test_content(faired), alone);

    const char *curve = test_scratch("pointless.igs");
    CHECK_INT(RUN("batten", "fit", points, "-o", curve).exit, 0);
    const test_process run = RUN("batten", "fair", curve, "-o", faired, "--within", "1 cm");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "is a curve without the points it was made from");
}

TEST(measure_says_why_there_is_no_area)
{
    const char *points = test_scratch("profile.xyz"), *curve = test_scratch("profile.igs");
    test_write(points, "10 0.1\n5 1\n1 0.8\n0 0\n1 -0.8\n5 -1\n10 -0.1\n");
    CHECK_INT(RUN("batten", "fit", points, "-o", curve).exit, 0);
    const test_process open = RUN("batten", "measure", curve);
    CHECK_INT(open.exit, 0);
    CHECK_CONTAINS(open.out, "no area: open by 0.2; 'within' (--within)");
    CHECK_CONTAINS(RUN("batten", "measure", curve, "--json").out, "\"gap\": 0.2");
    CHECK_CONTAINS(RUN("batten", "measure", curve, "--within", "0.3 m").out, "\n  area ");
    CHECK_CONTAINS(RUN("batten", "measure", points).out, ": 7 points\n");
}

TEST(smoothing_says_what_cross_validation_chose)
{
    const char *noisy = test_scratch("noisy.xyz"), *curve = test_scratch("noisy.igs");
    char text[1000] = "";
    size_t used = 0;
    for (int i = 0; i < 40; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%d %d\n", i,
                                 (i * 7919) % 11 % 3);
    test_write(noisy, text);
    static const char chose[] = "cross validation chose lambda ";
    CHECK_CONTAINS(RUN("batten", "fit", noisy, "-o", curve, "--method", "smooth").errors,
                   chose);
    CHECK_TEXT(RUN("batten", "fit", noisy, "-o", curve, "--method", "smooth", "-q").errors, "");
    CHECK(!strstr(
        RUN("batten", "fit", noisy, "-o", curve, "--method", "smooth", "--rms", "1").errors,
        chose));
}

TEST(smoothing_that_goes_through_the_points_is_a_warning)
{
    const char *points = test_scratch("few.xyz"), *curve = test_scratch("few.igs");
    char text[1000] = "";
    size_t used = 0;
    for (int i = 0; i < 21; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%d %.6f\n", i,
                                 3 * sin(i / 3.0) + 0.02 * (i * 7919 % 11 % 3));
    test_write(points, text);
    const test_process run = RUN("batten", "fit", points, "-o", curve, "--method=smooth", "-q");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.errors, "goes through the points as if they had no errors");
    CHECK(!strstr(run.errors, "cross validation chose"));
}

TEST(a_failure_is_said_once_and_without_a_place_in_no_file)
{
    const char *points = write_wavy("once.xyz"), *curve = test_scratch("once.igs");
    test_process run = RUN("batten", "fit", points, "-o", curve, "--start-vector=up");
    CHECK_INT(run.exit, 2);
    CHECK(strncmp(run.errors, "batten fit: 'start-vector' of", 29) == 0);
    const char *end = strchr(run.errors, '\n');
    CHECK(end && !end[1]);
    run = RUN("batten", "fit", points, "-o", curve, "--method", "circle");
    CHECK_INT(run.exit, 2);
    end = strchr(run.errors, '\n');
    CHECK(end && !end[1]);
}

TEST(convert_takes_its_output_either_way)
{
    const char *points = write_wavy("either.xyz"), *output = test_scratch("either.csv");
    test_process run = RUN("batten", "convert", points, "-o", output);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "wrote ");
    CHECK_CONTAINS(run.out, output);
    run = RUN("batten", "convert", points, output, "-q");
    CHECK_INT(run.exit, 0);
    CHECK_TEXT(run.out, "");
    CHECK_INT(RUN("batten", "convert", points, output, "-o", output).exit, 2);
}

TEST(what_was_fitted_can_be_evaluated)
{
    const char *points = test_scratch("points.xyz"), *curve = test_scratch("curve.igs");
    test_write(points, "0 0 0\n1 2 0\n3 3 0\n4 1 0\n6 0 0\n");
    test_process run = RUN("batten", "fit", points, "-o", curve);
    CHECK_INT(run.exit, 0);
    run = RUN("batten", "eval", curve, "--at", "0", "--order", "1", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"point\": [0, 0, 0]");
    CHECK_CONTAINS(run.out, "\"derivatives\": [[");
    run = RUN("batten", "eval", curve, "--at", "-1");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "the parameter -1 is outside the domain");
    run = RUN("batten", "eval", curve, "--at", "-1", "--order", "2", "--beyond", "linear",
              "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, ", [0, 0, 0]]}");
    CHECK_INT(RUN("batten", "eval", curve, "--at", "-1", "--beyond", "continue").exit, 0);
    run = RUN("batten", "info", curve);
    CHECK_CONTAINS(run.out, "curve, degree 3");
}

TEST(the_method_of_fit_brings_its_own_options)
{
    const char *points = test_scratch("grid.xyz"), *surface = test_scratch("grid.igs");
    test_write(points, "0 0 0\n1 0 1\n2 0 0\n\n0 1 0\n1 1 2\n2 1 0\n\n0 2 0\n1 2 1\n2 2 0\n");
    CHECK_INT(RUN("batten", "fit", points, "-o", surface, "--method", "interpolate-grid",
                  "--degree-v", "1")
                  .exit,
              0);
    CHECK_CONTAINS(RUN("batten", "info", surface).out, "degree 2 x 1");
    CHECK_INT(RUN("batten", "fit", points, "-o", surface, "--degree-v", "1").exit, 2);
}

TEST(a_parameter_named_method_stands_behind_the_method)
{
    const char *points = test_scratch("rows.xyz"), *surface = test_scratch("rows.igs");
    char text[2000] = "";
    for (int i = 0; i < 36; i++)
        sprintf(text + strlen(text), "%d %d %d\n%s", i % 6, i / 6, i * i % 5,
                i % 6 == 5 ? "\n" : "");
    test_write(points, text);
    CHECK_INT(RUN("batten", "fit", points, "-o", surface, "--method", "fit-grid").exit, 0);
    CHECK_INT(RUN("batten", "fit", points, "-o", surface, "--method", "fit-grid:method=smooth",
                  "--degree-v", "3")
                  .exit,
              0);
    const test_process run =
        RUN("batten", "fit", points, "-o", surface, "--method=fit-grid:method=smoth");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "did you mean 'smooth'");
    CHECK_CONTAINS(
        RUN("batten", "fit", points, "-o", surface, "--method", "fit-gird:a=b").errors,
        "there is no method 'fit-gird'; did you mean 'fit-grid'");
}

TEST(messages_name_the_file)
{
    const char *points = test_scratch("named.xyz");
    test_write(points, "0 0\n1 1\n2 0\n");
    const char *curve = test_scratch("named.igs");
    CHECK_CONTAINS(RUN("batten", "fit", points, "-o", curve).out, "named.xyz");
    const test_process run = RUN("batten", "fit", curve, "-o", test_scratch("again.igs"));
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "named.igs' has none");
    CHECK_INT(test_shell("cd $(mktemp -d) && printf '0 0\\n1 1\\n2 0\\n' > result && "
                         "\"$BATTEN\" fit result -o c.igs && rm result c.igs")
                  .exit,
              0);
}

TEST(a_name_that_is_not_in_the_file_brings_the_nearest)
{
    const char *points = test_scratch("near.xyz"), *design = test_scratch("near.yaml");
    test_write(points, "0 0\n1 1\n2 0\n");
    test_write(design, "batten: 1\nfeatures:\n  keel: {line: [[0, 0], [1, 0]]}\n"
                       "  sheer: {line: [[0, 1], [1, 1]]}\n  chine: {line: [[0, 2], [1, 2]]}\n"
                       "outputs:\n  near.igs: [sheer, keel, chine]\n");
    CHECK_INT(RUN("batten", "build", design, "-q").exit, 0);
    char object[4096];
    snprintf(object, sizeof object, "%s#kele", test_scratch("near.igs"));
    const test_process run = RUN("batten", "eval", object, "--at", "0");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "there is no object 'kele' in the file; there are 'keel', ");
    CHECK_CONTAINS(RUN("batten", "info", test_scratch("near.igs")).out,
                   "box of the control points 0 1 0  to  1 1 0");
}

TEST(a_file_that_would_hold_nothing_is_not_written)
{
    const char *path = write_table("table.csv"), *target = test_scratch("nothing.igs");
    const test_process run = RUN("batten", "convert", path, target);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "IGES files hold points, curves");
    CHECK(test_content(target) == NULL);
}

TEST(a_misspelt_parameter_is_refused_with_the_nearest)
{
    const char *design = test_scratch("set.yaml");
    test_write(
        design,
        "batten: 1\nparameters:\n  beam: 3 m\nfeatures:\n  a: {line: [[0, 0], [=beam, 0]]}\n");
    CHECK_INT(RUN("batten", "build", design, "--set", "beam=4 m").exit, 0);
    static const char *const wrong[] = {"baem=4 m", "parameters.baem=4 m"};
    for (int i = 0; i < COUNT(wrong); i++) {
        const test_process run = RUN("batten", "build", design, "--set", wrong[i]);
        CHECK_INT(run.exit, 2);
        CHECK_CONTAINS(run.errors, "no parameter 'baem'; did you mean 'beam'?");
    }
}

TEST(a_bound_that_is_not_met_is_exit_status_1)
{
    const char *design = test_scratch("bound.yaml");
    const char *const limits[] = {"2 mm", "0.5 mm"};
    for (int i = 0; i < COUNT(limits); i++) {
        char text[512];
        snprintf(text, sizeof text,
                 "batten: 1\nfeatures:\n  grid: {points: [[0, 0, 0], [1, 0, 1 mm], [2, 0, 0], "
                 "[0, 1, 0], [1, 1, 1 mm], [2, 1, 0]], columns: 3}\n"
                 "  flat: {fit-grid: grid, points-u: 2, points-v: 2, degree-u: 1, degree-v: "
                 "1}\noutputs:\n  bound.txt: {check: flat, within: %s}\n",
                 limits[i]);
        test_write(design, text);
        CHECK_INT(RUN("batten", "check", design).exit, i);
        CHECK_INT(RUN("batten", "build", design).exit, i);
    }
}

TEST(standard_input_is_a_file_named_dash)
{
    const test_process run =
        test_run(table, (const char *const[]){"batten", "info", "-", NULL});
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "4 stations");
}

TEST(one_object_of_a_file_is_named_behind_a_hash)
{
    const char *points = test_scratch("two.xyz"), *curves = test_scratch("two.igs");
    test_write(points, "0 0 0\n1 2 0\n3 3 0\n4 1 0\n\n0 0 1\n1 2 1\n3 3 1\n4 1 1\n");
    CHECK_INT(RUN("batten", "fit", points, "-o", curves).exit, 0);
    char named[512];
    snprintf(named, sizeof named, "%s#nothing", curves);
    const test_process missing = RUN("batten", "info", named);
    CHECK_INT(missing.exit, 1);
    CHECK_CONTAINS(missing.errors, "no object 'nothing'");
}

TEST(fairing_a_table_keeps_the_bound)
{
    const char *path = write_table("table.csv"), *faired = test_scratch("faired.csv");
    const test_process run =
        RUN("batten", "fair", path, "-o", faired, "--within", "0.01", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"moved\"");
    CHECK_CONTAINS(run.out, "\"excess_inflections\"");
    CHECK(test_content(faired) != NULL);
}

TEST(W9_an_interrupt_leaves_the_target_untouched)
{
    const char *design = test_scratch("long.yaml"), *target = test_scratch("long.png");
    write_table("table.csv");
    test_write(design, "batten: 1\nunits: m\nfeatures:\n  t: {read: table.csv}\n  s: "
                       "{interpolate: t, each: station}\n"
                       "  h: {skin: s}\noutputs:\n  long.png: {picture: h, shading: zebra, "
                       "width: 8000, height: 8000}\n");
    test_write(target, "old");
    char line[1024];
    snprintf(line, sizeof line,
             "timeout -s INT 0.3 \"$BATTEN\" build '%s' -q; echo status $?; ls -A \"$(dirname "
             "'%s')\" | grep -c batten-tmp",
             design, design);
    const test_process run = test_shell(line);
    CHECK_CONTAINS(run.out, "\n0\n");
    if (strncmp(run.out, "status 0", 8) == 0)
        SKIP("the machine finished the picture before the interrupt");
    CHECK_TEXT(test_content(target), "old");
}
