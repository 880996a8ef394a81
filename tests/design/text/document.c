#include "design/text/document.h"

#include "support/test.h"

#include <stdlib.h>

/* The notes of the last parse, one line each: "line:column: text". */
static char said[8192];

static batten_status parse(const char *text, batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = "hull.yaml";
    batten_notes *notes = NULL;
    batten_status status = batten_notes_create(100, &notes);
    if (status == BATTEN_OK)
        status = batten_design_parse(text, strlen(text), &options, notes, out);
    size_t used = 0;
    *said = 0;
    for (int i = 0; notes && i < batten_notes_count(notes); i++) {
        const batten_note *n = batten_notes_at(notes, i);
        used += (size_t)snprintf(said + used, sizeof said - used, "%s:%d: %s: %s\n", n->file,
                                 n->line, n->entity, n->text);
    }
    if (notes && batten_notes_dropped(notes))
        *said = 0; /* no memory for one of them: borne silently */
    batten_notes_free(notes);
    return status;
}

TEST(a_design_has_a_unit_and_a_text)
{
    static const char text[] = "batten: 1\nunits: ft\n";
    batten_design *design = NULL;
    CHECK_OK(parse(text, &design));
    CHECK_BITS(batten_design_unit_metres(design), 0.3048);
    size_t length;
    CHECK_TEXT(batten_design_text(design, &length), text);
    CHECK_INT((int)length, (int)strlen(text));
    CHECK_INT(batten_design_output_count(design), 0);
    batten_design_free(design);
}

static const struct {
    const char *text, *message;
} errors[] = {
    {"units: m\n", "hull.yaml:1:1: the line 'batten: 1'"},
    {"batten: 2\n", "hull.yaml:1:9: the format has version 2"},
    {"batten: 0\n", "no version 0"},
    {"batten: one\n", "hull.yaml:1:9: the version of the format: a whole number"},
    {"batten: 1\nunits: furlong\n", "hull.yaml:2:8: unknown unit of length 'furlong'"},
    {"batten: 1\nunits: [m]\n", "'units' needs a value"},
    {"batten: 1\ntolerance: 3 deg\n", "tolerance must be a length, not an angle"},
    {"batten: 1\ntolerance: 0 mm\n", "must be above 0"},
    {"batten: 1\ntolerance: -1 mm\n", "must be above 0"},
    {"batten: 1\ntolerance: x\n", "hull.yaml:2:12: "},
    {"batten: 1\nfeature:\n  a: {points: [0, 0]}\n",
     "hull.yaml:2:1: a design has no section 'feature'; did you mean 'features'?"},
    {"- a\n", "hull.yaml:1:1: a design begins with"},
    {"batten: 1\nfeatures: 3\n", "'features' needs lines"},
    {"batten: 1\nfeatures:\n  a: 3\n", "hull.yaml:3:6: the feature 'a' needs the form"},
    {"batten: 1\nfeatures:\n  a: {pionts: [0, 0]}\n",
     "hull.yaml:3:7: there is no operation 'pionts'; did you mean 'points'?"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0], clumns: 3}\n",
     "hull.yaml:3:23: points has no parameter 'clumns'; did you mean 'columns'? It has columns"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0], columns: 1e3}\n",
     "hull.yaml:3:32: 'columns' of points is wrong: a whole number"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0], columns: -1}\n",
     "a whole number is expected, not \"-1\""},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0], columns: 2147483648}\n", "above the largest"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0], columns: =1/2}\n",
     "must be a whole number, 0 or more, not '=1/2'"},
    {"batten: 1\nfeatures:\n  a: {points: [0, nan]}\n",
     "hull.yaml:3:19: points needs a length: a number is expected at \"nan\""},
    {"batten: 1\nfeatures:\n  a: {points: [0, 3 deg]}\n",
     "points needs a length; '3 deg' is an angle"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 1, 2, 3]}\n", "not 4 values"},
    {"batten: 1\nfeatures:\n  a: {points: {x: 1}}\n", "not a map"},
    {"batten: 1\nfeatures:\n  a: {points: []}\n", "at least one value"},
    {"batten: 1\nfeatures:\n  a: {points: [[0, [1]]]}\n", "list where a length"},
    {"batten: 1\nfeatures:\n  a: {points: left}\n", "one of origin x y z"},
    {"batten: 1\nfeatures:\n  a: {columns: 3, points: [0, 0]}\n",
     "the first key names the operation"},
    {"batten: 1\nfeatures:\n  a: {collect: stations}\n  station: {points: [0, 0]}\n",
     "hull.yaml:3:16: no feature is named 'stations'; did you mean 'station'?"},
    {"batten: 1\nfeatures:\n  a: {collect: b}\n  b: {collect: a}\n",
     "features need each other in a ring: a -> b -> a"},
    {"batten: 1\nfeatures:\n  a: {collect: a}\n", "a -> a"},
    {"batten: 1\nfeatures:\n  a: {select: b}\n  b: {points: [0, 0]}\n",
     "select of 'a' needs 'names'"},
    {"batten: 1\nfeatures:\n  a: {write: b}\n",
     "hull.yaml:3:7: 'write' belongs under 'outputs'"},
    {"batten: 1\nfeatures:\n  '': {points: [0, 0]}\n", "a name is missing"},
    {"batten: 1\nfeatures:\n  a: {points: [0, 0]}\n  a: {points: [1, 1]}\n",
     "hull.yaml:4:3: 'a' appears here a second time"},
    {"batten: 1\nparameters:\n  a: 3 m\nfeatures:\n  b: {points: [[=max(a, 1), 0]]}\n",
     "points"},
    {"batten: 1\noutputs:\n  ../a.step: b\n", "leads out of the folder"},
    {"batten: 1\noutputs:\n  a.step: b\n", "hull.yaml:3:11: no feature is named 'b'"},
    {"batten: 1\noutputs:\n  a.step: {points: [0, 0]}\n", "'points' belongs under 'features'"},
};

TEST(errors_name_file_line_column_and_the_nearest_name)
{
    for (int i = 0; i < COUNT(errors); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(parse(errors[i].text, &design), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(errors[i].message);
        CHECK(design == NULL);
    }
}

TEST(every_error_of_a_text_is_noted)
{
    static const char text[] = "batten: 1\nunits: q\nfeatures:\n  a: {pionts: [0, 0]}\n"
                               "  b: {points: [0, 1 kg], culumns: 2}\n";
    batten_design *design = NULL;
    CHECK_STATUS(parse(text, &design), BATTEN_BAD_FORMAT);
    if (!*said)
        return;
    CHECK_CONTAINS(said, "hull.yaml:2: column 8: unknown unit of length 'q'");
    CHECK_CONTAINS(said, "hull.yaml:4: column 7: there is no operation 'pionts'");
    CHECK_CONTAINS(said, "hull.yaml:5: column 19: points needs a length: unknown unit 'kg'");
    CHECK_CONTAINS(said, "hull.yaml:5: column 26: points has no parameter 'culumns'");
}

TEST(F1_files_that_are_none_are_refused)
{
    static const char *const paths[] = {"/nonexistent/hull.yaml", "/tmp", "/dev/null"};
    for (int i = 0; i < COUNT(paths); i++) {
        batten_design *design = NULL;
        CHECK(batten_design_open(paths[i], false, NULL, &design) != BATTEN_OK);
        CHECK(design == NULL && *batten_message());
    }
}

TEST(F2_a_design_cut_anywhere_is_refused_or_whole)
{
    static const char text[] = "batten: 1\nunits: m\nparameters: {b: 3 m}\nfeatures:\n"
                               "  a: {points: [[0, 0], [=b/2, 1]]}\n  c: {collect: [a]}\n";
    const size_t step = test_cases(100) < 100 ? 17 : 1;
    for (size_t length = 0; length < sizeof text; length += step) {
        batten_design *design = NULL;
        const batten_status status = batten_design_parse(text, length, NULL, NULL, &design);
        CHECK((status == BATTEN_OK) == (design != NULL));
        batten_design_free(design);
    }
}

TEST(N3_a_vanishing_number_is_noted)
{
    batten_design *design = NULL;
    CHECK_OK(parse("batten: 1\nfeatures: {p: {points: [1e-400, 1]}}\n", &design));
    batten_design_free(design);
    if (*said)
        CHECK_CONTAINS(said, "became 0");
}

TEST(F2_mutated_designs_are_refused_or_kept_byte_for_byte)
{
    test_random random = test_random_begin("mutated designs");
    static const char letters[] = "{}[]:,#'\"=-()*&!|>%@ \n\t0m.\xC3\xFF";
    for (int i = 0; i < test_cases(1000); i++) {
        char text[1200];
        const batten_feature *f = batten_feature_at(i % batten_feature_count());
        snprintf(text, sizeof text, "batten: 1\n%s", f->example);
        for (int k = test_random_int(&random, 1, 4); k > 0; k--)
            text[test_random_int(&random, 0, (int)strlen(text) - 1)] =
                letters[test_random_int(&random, 0, (int)sizeof letters - 2)];
        batten_design *design = NULL;
        const batten_status status =
            batten_design_parse(text, strlen(text), NULL, NULL, &design);
        CHECK((status == BATTEN_OK) == (design != NULL));
        CHECK(status == BATTEN_OK || *batten_message());
        if (design)
            CHECK_TEXT(batten_design_text(design, NULL), text);
        batten_design_free(design);
    }
}

TEST(words_of_older_designs_are_read_with_a_remark)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n  ring: {circle: 0.1}\n  way: {line: [[0, 0, 0], [0, 0, 1]]}\n"
        "  pipe: {sweep: ring, spine: way}\n";
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, notes, &design));
    /* Where memory failed the remark may be lost, or be said again. */
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= 1);
    if (!batten_notes_dropped(notes)) {
        CHECK(batten_notes_at(notes, 0)->is_remark);
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text,
                       "'spine' of sweep is called 'path' now");
    }
    CHECK_OK(batten_design_evaluate(design, "pipe", NULL, NULL));
    batten_design_free(design);
    batten_notes_free(notes);
}
