#include "design/expect.h"

#include <batten/design.h>
#include <string.h>

/* In which order features are evaluated, what a job hears of it, and what a failure ends. */

typedef struct {
    double last;
    int count;
    char names[200];
} heard;

static void hear(void *user, double fraction, const char *what)
{
    heard *h = user;
    CHECK(fraction >= 0 && fraction <= 1);
    CHECK(fraction >= h->last);
    h->last = fraction;
    if (!strstr(h->names, what))
        snprintf(h->names + strlen(h->names), sizeof h->names - strlen(h->names), "%s ", what);
    h->count++;
}

static batten_status parse(const char *text, batten_notes *notes, batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = "d.yaml";
    return batten_design_parse(text, strlen(text), &options, notes, out);
}

TEST(progress_rises_and_names_the_features_in_the_order_of_need)
{
    batten_design *design = NULL;
    heard h = {0, 0, ""};
    batten_job job = BATTEN_JOB;
    job.progress = hear;
    job.user = &h;
    CHECK_OK(parse(
        "batten: 1\nfeatures:\n  last: {move: middle, by: [1, 0]}\n  middle: {interpolate: first}\n"
        "  first: {points: [[0, 0], [1, 1], [2, 0]]}\n  idle: {circle: 1}\n",
        NULL, &design));
    CHECK_OK(batten_design_evaluate(design, "last", &job, NULL));
    CHECK_TEXT(h.names, "first middle last ");
    CHECK(h.last > 0.3);
    CHECK_INT(batten_design_result_count(design), 3);
    /* What is done is not done again, and not listed again. */
    h = (heard){0, 0, ""};
    CHECK_OK(batten_design_evaluate(design, "last", &job, NULL));
    CHECK_TEXT(h.names, "");
    CHECK_INT(batten_design_result_count(design), 3);
    CHECK_OK(batten_design_evaluate(design, NULL, &job, NULL));
    CHECK_TEXT(h.names, "idle ");
    CHECK_INT(batten_design_result_count(design), 4);
    CHECK_TEXT(batten_design_result_at(design, 0)->name, "first");
    CHECK_TEXT(batten_design_result_at(design, 3)->name, "idle");
    batten_design_free(design);
}

TEST(a_failure_ends_what_needs_it_and_names_file_line_and_column)
{
    static const char text[] =
        "batten: 1\nfeatures:\n  good: {circle: 1}\n  bad: {circle: 0}\n  moved: {move: bad, by: "
        "[1, 0]}\n  after: {reverse: moved}\n  other: {reverse: good}\noutputs:\n  bad.txt: "
        "{measure: moved}\n  good.txt: {measure: other}\n";
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(parse(text, NULL, &design));
    batten_status status = batten_design_evaluate(design, NULL, NULL, notes);
    if (test_memory_failed(status, BATTEN_BAD_ARGUMENT)) {
        batten_notes_free(notes); /* those of the first attempt */
        CHECK_OK(batten_notes_create(20, &notes));
        status = batten_design_evaluate(design, NULL, NULL, notes);
    }
    CHECK_INT(status, BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("d.yaml:4:3: bad (circle): the radius is 0");
    CHECK(batten_design_result(design, "good")->value != NULL);
    CHECK(batten_design_result(design, "other")->value != NULL);
    CHECK(batten_design_result(design, "bad")->value == NULL);
    CHECK_INT(batten_design_result(design, "bad")->status, BATTEN_BAD_ARGUMENT);
    CHECK(!batten_design_result(design, "after") ||
          !batten_design_result(design, "after")->value);
    char *data = NULL;
    size_t size = 0;
    CHECK_STATUS(batten_design_output(design, 0, NULL, notes, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("d.yaml:9:3: bad.txt (measure): it needs 'bad', which failed");
    CHECK(data == NULL);
    CHECK_OK(batten_design_output(design, 1, NULL, notes, &data, &size));
    CHECK(size > 0);
    batten_release(data);
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(objects_that_a_change_does_not_concern_pass_through)
{
    static const char before[] =
        "  ducks: {points: [[0, 0], [1, 2], [3, 0]]}\n"
        "  arcs: {arc-spline: ducks, ends: circular}\n"
        "  bow: {bezier: ducks}\n"
        "  net: {points: [[0, 0], [1, 0], [0, 1], [1, 1]], columns: 2}\n"
        "  sheet: {bezier-surface: net}\n"
        "  thick: {elevate: bow, by: 2}\n"
        "  all: {collect: [bow, sheet, ducks]}\n"
        "  drops: {points: [[0, 0], [1, 0], [0, 1]]}\n"
        "  three: {bezier-triangle: drops}\n"
        "  ball: {sphere: 1}\n"
        "  lift: {move: all, by: [0, 0, 5]}\n";
    static const expect_row rows[] = {
        {"{reverse: all}", BATTEN_OK,
         "objects 3;named bow;at 0 3 0 0;object 1;named sheet;object 2;named ducks;data 0 0 0 0"},
        {"{reverse: arcs}", BATTEN_OK, "spans 2;at 0 3 0 0;at 1 0 0 0"},
        {"{elevate: arcs}", BATTEN_OK, "spans 0"},
        {"{part: arcs, from: 0, to: 1}", BATTEN_OK, "spans 1"},
        {"{move: arcs, by: [0, 0, 5]}", BATTEN_OK, "spans 2;on 0 0 1 5;at 0 0 0 5"},
        {"{move: three, by: [0, 0, 5]}", BATTEN_OK, "on 0 0 1 5;kind triangles"},
        {"{scale: all, by: 2}", BATTEN_OK,
         "objects 3;at 1 6 0 0;object 1;area 4;object 2;data 1 2 4 0"},
        {"{scale: arcs, by: 2}", BATTEN_OK, "spans 2;at 1 6 0 0"},
        {"{reduce: thick, degree: 2, within: 0.001}", BATTEN_OK,
         "degree 2;error 1e-9;at 0.5 1.25 1 0"},
        {"{collect: lift}", BATTEN_OK,
         "objects 3;on 0 0 1 5;object 1;on 0 0 1 5;object 2;data 0 0 0 5"},
        {"{swap: ducks}", BATTEN_BAD_ARGUMENT, "ducks"},
        {"{rotate: bow, by: 90 deg}", BATTEN_OK, "at 1 0 3 0"},
        {"{rotate: bow, by: 180 deg, at: [1, 0, 0]}", BATTEN_OK, "at 0 2 0 0;at 1 -1 0 0"},
        {"{rotate: bow, by: 90 deg, axis: y}", BATTEN_OK, "at 1 0 0 -3"},
    };
    EXPECT(before, rows);
}

TEST(S5_the_objects_that_a_design_makes_are_counted_before_they_are_made)
{
    static const char text[] = "batten: 1\nmost-objects: %d\nfeatures:\n"
                               "  a: {line: [[0, 1], [1, 2]]}\n  b: {mirror: a}\n"
                               "  c: {mirror: b}\n  d: {mirror: c}\n";
    char design_text[300];
    batten_design *design = NULL;
    snprintf(design_text, sizeof design_text, text, 14);
    CHECK_OK(parse(design_text, NULL, &design));
    CHECK_STATUS(batten_design_evaluate(design, NULL, NULL, NULL), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("would have made 15 objects, more than 14; a line 'most-objects: 15'");
    CHECK_OK(batten_design_result(design, "c")->status);
    CHECK_STATUS(batten_design_result(design, "d")->status, BATTEN_TOO_LARGE);
    batten_design_free(design);
    snprintf(design_text, sizeof design_text, text, 15);
    CHECK_OK(parse(design_text, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
    batten_design_free(design);
    CHECK_STATUS(parse("batten: 1\nmost-objects: 0\n", NULL, &design), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("'most-objects' must be 1 or more, not 0");
}
