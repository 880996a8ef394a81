/* Fills that are one trimmed surface. */
#include "design/evaluate.h"

static const char common[] = "batten: 1\nunits: m\nfeatures:\n"
                             "  a: {line: [[0, 0, 0], [2, 0, 0.1]]}\n"
                             "  b: {line: [[2, 0, 0.1], [2, 1, 0]]}\n"
                             "  c: {line: [[2, 1, 0], [1, 1, 0.1]]}\n"
                             "  d: {line: [[1, 1, 0.1], [1, 2, 0]]}\n"
                             "  e: {line: [[1, 2, 0], [0, 2, 0]]}\n"
                             "  f: {line: [[0, 2, 0], [0, 0, 0]]}\n"
                             "  peaks: {points: [[0.5, 0.5, 0.2], [0.6, 1.5, 0.1]]}\n"
                             "  ridge: {line: [[1.2, 0.5, 0.15], [1.8, 0.5, 0.1]]}\n"
                             "  away: {points: [[1.5, 1.5, 0]]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  x: %s\n", common, feature);
    return evaluate_design(text, "x", notes, out);
}

static bool is_said(const batten_notes *notes, const char *words)
{
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (strstr(batten_notes_at(notes, i)->text, words))
            return true;
    return batten_notes_dropped(notes) > 0;
}

TEST(a_hole_in_the_shape_of_an_L_is_one_face_with_its_sides_as_edges)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate("{fill: [a, b, c, d, e, f]}", notes, &design));
    const batten_model *model = batten_design_result(design, "x")->value;
    CHECK_INT(batten_model_count(model), 1);
    const batten_object *object = batten_model_object(model, 0);
    CHECK(object->kind == BATTEN_OBJECT_BODY);
    CHECK_INT(batten_body_view(object->body)->edge_count, 6);
    CHECK(is_said(notes, "one trimmed surface, not several around a middle: the fill folds"));
    CHECK(is_said(notes, "trimmed by 6 sides"));
    CHECK(batten_design_result(design, "x")->error_max <= 1e-4);
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(a_fill_goes_through_points_and_curves_and_says_how_near)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate("{fill: [a, b, c, d, e, f], through: [peaks, ridge]}", notes, &design));
    CHECK(is_said(notes, "what is inside is missed by up to"));
    CHECK(batten_design_result(design, "x")->error_max <= 1e-4);
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(G7_what_a_fill_cannot_go_through_is_refused)
{
    static const struct {
        const char *feature, *words;
        batten_status status;
    } rows[] = {
        {"{fill: [a, b, c, d, e, f], through: away}", "inner point 1 lies beyond the sides",
         BATTEN_NOT_COMPATIBLE},
        {"{fill: [a, b, c, d, e, f], through: peaks, form: split}",
         "'through' needs the form 'sheet'", BATTEN_BAD_ARGUMENT},
        {"{fill: [a, b, c, d, e, f], form: split}", "the fill folds over near",
         BATTEN_TOLERANCE_NOT_MET},
        {"{fill: [a, b, c], form: sheet}", "is open by", BATTEN_NOT_COMPATIBLE},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, NULL, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
}
