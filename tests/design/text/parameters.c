/* Parameters of a design: their names, their order, and what is said when they cannot be. */
#include "design/text/document.h"

#include "support/test.h"

/* A design of these parameters, and points of `a` and `b` when it has features. */
static batten_status parse(const char *parameters, const char *features, batten_notes *notes,
                           batten_design **out)
{
    char text[1000];
    batten_design_options options = batten_design_defaults();
    options.file_name = "hull.yaml";
    snprintf(text, sizeof text, "batten: 1\nunits: mm\nparameters:%s%s%s", parameters,
             *features ? "features:\n  p: " : "", features);
    return batten_design_parse(text, strlen(text), &options, notes, out);
}

static const struct {
    const char *parameters, *message;
} refused[] = {
    {"\n  a: =b\n  b: =a\n", "parameters need each other in a ring: a -> b -> a"},
    {"\n  a: =bee\n  beam: 3\n  bees: 1\n",
     "hull.yaml:4:6: no parameter is named 'bee'; did you mean 'bees'?"},
    {"\n  3a: 1\n", "'3a' cannot name a parameter"},
    {"\n  pi: 1\n", "'pi' cannot name a parameter"},
    {"\n  sin: 1\n", "'sin' cannot name a parameter"},
    {"\n  cos: 1\n", "'cos' cannot name a parameter"},
    {"\n  tan: 1\n", "'tan' cannot name a parameter"},
    {"\n  sqrt: 1\n", "'sqrt' cannot name a parameter"},
    {"\n  abs: 1\n", "'abs' cannot name a parameter"},
    {"\n  min: 1\n", "'min' cannot name a parameter"},
    {"\n  max: 1\n", "'max' cannot name a parameter"},
    {"\n  a: [1]\n", "the parameter a must be a number"},
    {"\n  a: 1e400\n", "hull.yaml:4:6: the number \"1e400\" is too large"},
    {"\n  a: =b\n  b: =c\n  c: =a\n", "a ring: a -> b -> c -> a"},
    {"\n  x: 3\n  c: =c + x\n", "hull.yaml:5:6: parameters need each other in a ring: c -> c"},
    {"\n  a: =beem\n  beam: 3\n",
     "hull.yaml:4:6: no parameter is named 'beem'; did you mean 'beam'?"},
    {"\n  beam: =bean\n", "hull.yaml:4:9: no parameter is named 'bean'"},
    {"\n  a-b: 1\n",
     "'a-b' cannot name a parameter; use letters, digits and '_', and no function"},
    {"\n  a b: 1\n", "'a b' cannot name a parameter"},
    {"\n  '': 1\n", "hull.yaml:4:3: "},
    {"\n  \xC3\xA4: 1\n", "cannot name a parameter"},
    {"\n  a: {b: 1}\n",
     "hull.yaml:4:6: the parameter a must be a number, with or without a unit"},
    {"\n  a: =1 +\n", "hull.yaml:4:6: the expression ends where a value is expected"},
    {"\n  a: b\n  b: 1\n", "hull.yaml:4:6: "},
};

TEST(parameters_that_cannot_be_are_refused_with_their_place)
{
    for (int i = 0; i < COUNT(refused); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(parse(refused[i].parameters, "", NULL, &design), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(refused[i].message);
        CHECK(design == NULL);
    }
}

/* In millimetres. */
static const struct {
    const char *parameters, *point;
    double x, y;
} read[] = {
    {"\n  half: =beam / 2\n  beam: =length/4\n  length: 12 m\n", "=half, =beam", 1500, 3000},
    {" {}\n", "1, 2", 1, 2},
    {"\n", "1, 2", 1, 2},
    {" {_a: 1, A9_: 2}\n", "=_a, =A9_", 1, 2},
    {" {a: -3 cm, b: =-a}\n", "=a, =b", -30, 30},
    /* A unit after a number is no parameter of its name, and one name may begin another. */
    {"\n  m: 4\n  a: =2 m\n", "=a, =m", 2000, 4},
    {"\n  m: =a\n  a: 3 m\n", "=m, =2 m", 3000, 2000},
    {"\n  be: =beam\n  bea: 5\n  beam: 7\n", "=be, =bea", 7, 5},
    {"\n  d: =c * 2\n  c: =b * 2\n  b: =a * 2\n  a: 1\n", "=d, =b + c", 8, 6},
    {"\n  a: 1\n  b: =a + a + c\n  c: =a\n  unused: 3 deg\n", "=b, =c", 3, 1},
};

TEST(parameters_may_stand_in_any_order)
{
    for (int i = 0; i < COUNT(read); i++) {
        char point[100];
        batten_design *design = NULL;
        snprintf(point, sizeof point, "{points: [[%s]]}\n", read[i].point);
        CHECK_OK(parse(read[i].parameters, point, NULL, &design));
        CHECK_OK(batten_design_evaluate(design, NULL, NULL, NULL));
        const batten_object *points =
            batten_model_object(batten_design_result(design, "p")->value, 0);
        CHECK_NEAR(points->points[0], read[i].x, 1e-12);
        CHECK_NEAR(points->points[1], read[i].y, 1e-12);
        batten_design_free(design);
    }
}

TEST(a_wrong_parameter_is_reported_once_and_not_again_by_those_that_need_it)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(parse("\n  a: =1/0\n  b: =a\n  c: =b + x\n", "", notes, &design),
                 BATTEN_BAD_FORMAT);
    /* Where memory failed notes may be lost, or written again. */
    CHECK(batten_notes_count(notes) >= 1 || batten_notes_dropped(notes));
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const char *text = batten_notes_at(notes, i)->text;
        CHECK(strstr(text, "1 is divided by 0") || strstr(text, "no parameter is named 'x'"));
    }
    batten_notes_free(notes);
}

TEST(a_ring_of_parameters_offers_no_name_for_itself)
{
    static const char text[] = "batten: 1\nparameters:\n  a: =b\n  b: =a\n"
                               "features:\n  l: {line: [[0, 0], [=a, 1]]}\n";
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(batten_design_parse(text, strlen(text), NULL, notes, &design),
                 BATTEN_BAD_FORMAT);
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK(strstr(batten_notes_at(notes, i)->text, "did you mean 'a'") == NULL);
    batten_notes_free(notes);
}

TEST(N3_a_parameter_that_vanishes_is_noted_with_its_line)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(parse("\n  b: 1\n  a: 1e-400\n", "", notes, &design));
    if (!batten_notes_dropped(notes)) {
        const batten_note *note = batten_notes_at(notes, 0);
        CHECK_CONTAINS(note->text, "1e-400 is too small for a number and became 0");
        CHECK_INT(note->line, 5);
        CHECK_TEXT(note->entity, "a");
        CHECK_TEXT(note->file, "hull.yaml");
    }
    batten_design_free(design);
    batten_notes_free(notes);
}
