#include "design/text/document.h"

#include "support/test.h"

#include <stdlib.h>

static const char text[] = "batten: 1  # a comment\n"
                           "parameters: {x: 1 m}\n"
                           "features:\n"
                           "  all: {collect: [a, b]}\n"
                           "  a: {points: [[0, 0], [=x, 0]]}\n"
                           "  b: {points: [[0, 1], [2, 1]]}\n"
                           "  c: {collect: b}\n";

static batten_status parse(const char *source, batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = "d.yaml";
    return batten_design_parse(source, strlen(source), &options, NULL, out);
}

TEST(only_what_is_needed_is_evaluated_inputs_first)
{
    batten_design *design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_INT(batten_design_result_count(design), 0);
    CHECK(batten_design_result(design, "a") == NULL);
    CHECK_OK(batten_design_evaluate(design, "all", NULL, NULL));
    CHECK_INT(batten_design_result_count(design), 3);
    CHECK_TEXT(batten_design_result_at(design, 2)->name, "all");
    CHECK_TEXT(batten_design_result_at(design, 2)->operation, "collect");
    CHECK_INT(batten_model_count(batten_design_result(design, "all")->value), 2);
    CHECK(batten_design_result(design, "c") == NULL);
    CHECK_STATUS(batten_design_evaluate(design, "d", NULL, NULL), BATTEN_NOT_FOUND);
    batten_design_free(design);
}

TEST(an_edit_keeps_the_results_it_does_not_reach)
{
    batten_design *design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    batten_model *a = batten_model_ref(batten_design_result(design, "a")->value);
    batten_model *b = batten_model_ref(batten_design_result(design, "b")->value);
    batten_model *c = batten_model_ref(batten_design_result(design, "c")->value);
    CHECK_OK(batten_design_set(design, "parameters.x", "3 m", NULL));
    CHECK(batten_design_result(design, "a") == NULL);
    CHECK(batten_design_result(design, "all") == NULL);
    CHECK(batten_design_result(design, "b")->value == b);
    CHECK(batten_design_result(design, "c")->value == c);
    CHECK_INT(batten_design_result_count(design), 2);
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    CHECK_BITS(batten_model_object(batten_design_result(design, "a")->value, 0)->points[3], 3);
    CHECK_BITS(batten_model_object(a, 0)->points[3], 1);
    CHECK_OK(batten_design_set(design, "units", "mm", NULL));
    CHECK_INT(batten_design_result_count(design), 0);
    batten_model_unref(a);
    batten_model_unref(b);
    batten_model_unref(c);
    batten_design_free(design);
}

TEST(a_failed_edit_leaves_the_design_as_it_was)
{
    batten_design *design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    CHECK_STATUS(batten_design_set(design, "parameters.x", "3 deg", NULL), BATTEN_BAD_FORMAT);
    CHECK_STATUS(batten_design_set(design, "features.a.points", "q", NULL), BATTEN_BAD_FORMAT);
    CHECK_STATUS(batten_design_set(design, "features.z.points", "1", NULL), BATTEN_BAD_FORMAT);
    CHECK_STATUS(batten_design_set(design, "units.x", "1", NULL), BATTEN_NOT_FOUND);
    CHECK_TEXT(batten_design_text(design, NULL), text);
    CHECK_INT(batten_design_result_count(design), 4);
    batten_design_free(design);
}

TEST(a_failing_feature_is_named_and_the_others_are_done)
{
    static const char bad[] =
        "batten: 1\nfeatures:\n  a: {points: [[0, 0], [1, 0], [2, 0]], columns: 2}\n"
        "  b: {collect: a}\n  c: {points: [0, 0]}\n";
    batten_design *design = NULL;
    CHECK_OK(parse(bad, &design));
    CHECK_STATUS(batten_design_evaluate(design, NULL, NULL, NULL), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("d.yaml:3:3: a (points): 3 points do not make whole rows of 2");
    CHECK(batten_design_result(design, "a")->value == NULL);
    CHECK_INT(batten_design_result(design, "a")->status, BATTEN_BAD_ARGUMENT);
    CHECK(batten_design_result(design, "b") == NULL);
    CHECK(batten_design_result(design, "c")->value != NULL);
    CHECK_OK(batten_design_set(design, "features.a.columns", "3", NULL));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    batten_design_free(design);
}

typedef struct {
    int answers;
    double last;
} watcher;

static void hear(void *user, double fraction, const char *what)
{
    watcher *w = user;
    CHECK(what && fraction >= w->last && fraction <= 1);
    w->last = fraction;
    w->answers++;
}

TEST(progress_never_goes_back)
{
    batten_design *design = NULL;
    watcher w = {0, 0};
    batten_job job = BATTEN_JOB;
    job.progress = hear;
    job.user = &w;
    CHECK_OK(parse(text, &design));
    const batten_status status = batten_design_evaluate(design, NULL, &job, NULL);
    CHECK(status == BATTEN_OK ? w.answers >= 4 : status == BATTEN_OUT_OF_MEMORY);
    batten_design_free(design);
}

TEST(a_design_read_from_a_file_is_its_text)
{
    const char *path = test_scratch("own.yaml");
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    fputs(text, file);
    fclose(file);
    batten_design *design = NULL;
    CHECK_OK(batten_design_open(path, false, NULL, &design));
    CHECK_TEXT(batten_design_text(design, NULL), text);
    batten_design_free(design);
}

/* Whatever becomes of a value, the result that it reaches is gone, and no other one. */
static const struct {
    const char *path, *value;
    bool kept; /* the result of 'a' */
} edits[] = {
    {"features.a.points", "[[0, 0], [1, 0], [2, 1]]", false}, /* one more */
    {"features.a.points", "[[0, 0]]", false},                 /* one less */
    {"features.a.points", "[[0, 0], [2, 0]]", false},         /* another number */
    {"features.a.points", "[[0, 0], [1, 0]]", true},          /* the same */
    {"features.a.points", "[ [0.0, 0], [1000 mm, 0] ]", true},
    {"features.a.columns", "2", false}, /* given, though it is the default */
    {"features.b.function", "y = 2*x", true},
    {"parameters.free", "7", true},
    {"tolerance", "1 mm", true},
    {"tolerance", "2 mm", false},
    {"units", "mm", false},
};

TEST(results_stay_exactly_when_no_argument_of_theirs_differs)
{
    static const char given[] = "batten: 1\nunits: m\ntolerance: 0.001\nparameters: {free: 1}\n"
                                "features:\n  a: {points: [[0, 0], [1, 0]]}\n"
                                "  b: {function: y = x, x: [0, 1]}\n"
                                "  c: {interpolate: a, degree: 1}\n  d: {reverse: c}\n";
    for (int i = 0; i < COUNT(edits); i++) {
        batten_design *design = NULL;
        CHECK_OK(parse(given, &design));
        CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
        CHECK_INT(batten_design_result_count(design), 4);
        CHECK_OK(batten_design_set(design, edits[i].path, edits[i].value, NULL));
        CHECK_INT(batten_design_result(design, "a") != NULL, edits[i].kept);
        CHECK_INT(batten_design_result(design, "d") != NULL, edits[i].kept);
        CHECK_INT(batten_design_result(design, "b") != NULL,
                  strcmp(edits[i].path, "features.b.function") != 0 &&
                      (edits[i].kept || strncmp(edits[i].path, "features.a", 10) == 0));
        batten_design_free(design);
    }
}

TEST(features_that_are_evaluated_again_are_listed_once)
{
    batten_design *design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_OK(batten_design_evaluate(design, "b", NULL, NULL));
    CHECK_OK(batten_design_evaluate(design, "all", NULL, NULL));
    CHECK_OK(batten_design_evaluate(design, "all", NULL, NULL));
    CHECK_OK(batten_design_evaluate(design, "b", NULL, NULL));
    CHECK_INT(batten_design_result_count(design), 3);
    CHECK_TEXT(batten_design_result_at(design, 0)->name, "b");
    CHECK_TEXT(batten_design_result_at(design, 1)->name, "a");
    CHECK_TEXT(batten_design_result_at(design, 2)->name, "all");
    CHECK_OK(batten_design_set(design, "parameters.x", "3 m", NULL));
    CHECK_OK(batten_design_evaluate(design, "a", NULL, NULL));
    CHECK_INT(batten_design_result_count(design), 2);
    batten_design_free(design);
}

TEST(the_files_that_features_name_are_counted_and_lie_beside_the_design)
{
    static const char *const names[] = {"one.csv", "sub/two.step", "three.xyz"};
    batten_design *design = NULL;
    batten_design_options options = batten_design_defaults();
    static const char reading[] =
        "batten: 1\nfeatures:\n  a: {read: one.csv}\n  p: {points: [[0, 0]]}\n"
        "  b: {read: sub/two.step}\n  c: {read: three.xyz}\n";
    options.file_name = "folder/d.yaml";
    options.allow_outside = true; /* nothing is looked up */
    CHECK_OK(batten_design_parse(reading, strlen(reading), &options, NULL, &design));
    CHECK_INT(batten_design_file_count(design), 3);
    for (int i = 0; i < 3; i++) {
        char *path = NULL, expected[40];
        snprintf(expected, sizeof expected, "folder/%s", names[i]);
        CHECK_OK(batten_design_file_path(design, i, &path));
        CHECK_TEXT(path, expected);
        batten_release(path);
    }
    CHECK_NEAR(batten_design_unit_metres(design), 1, 0);
    batten_design_free(design);
    design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_INT(batten_design_file_count(design), 0);
    batten_design_free(design);
}
