#include "design/evaluate.h"

/* A triangle and a square side by side. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  p: {points: [[0, 0, 0], [1, 0, 0.4], [2, 0, 0.4], [3, 0, 0]]}\n"
    "  q: {points: [[3, 0, 0], [3, 1, 0.3], [2, 2, 0.3], [1.5, 3, 0]]}\n"
    "  r: {points: [[1.5, 3, 0], [1, 2, 0.3], [0, 1, 0.3], [0, 0, 0]]}\n"
    "  s: {points: [[0, 0, 0], [0, -1, -0.3], [0, -2, -0.3], [0, -3, 0]]}\n"
    "  t: {points: [[0, -3, 0], [1, -3, 0.2], [2, -3, 0.2], [3, -3, 0]]}\n"
    "  u: {points: [[3, 0, 0], [3, -1, -0.3], [3, -2, -0.3], [3, -3, 0]]}\n"
    "  a: {bezier: p}\n  b: {bezier: q}\n  c: {bezier: r}\n  d: {bezier: s}\n"
    "  e: {bezier: t}\n  f: {bezier: u}\n  long: {elevate: a, by: 1}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  x: %s\n", common, feature);
    return evaluate_design(text, "x", notes, out);
}

TEST(gregory_patches_of_three_and_four_curves_become_splines)
{
    static const char *rows[] = {"{gregory: [a, c, b]}",
                                 "{gregory: [d, a, f, e], within: 1 mm}"};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(evaluate(rows[i], notes, &design));
        const batten_model *model = batten_design_result(design, "x")->value;
        CHECK_INT(batten_model_count(model), 1);
        CHECK_TEXT(batten_surface_kind(batten_model_object(model, 0)->surface), "nurbs");
        CHECK(batten_design_result(design, "x")->has_error);
        bool said = batten_notes_dropped(notes) > 0; /* for lack of memory */
        for (int k = 0; k < batten_notes_count(notes); k++)
            said |= strstr(batten_notes_at(notes, k)->text,
                           "keeps the tangent planes of the patch along its edges to") != NULL;
        CHECK(said);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

TEST(G7_gregory_patches_of_other_curves_are_refused)
{
    static const struct {
        const char *feature, *words;
        batten_status status;
    } rows[] = {
        {"{gregory: [a, b]}", "3 or 4 sides, not 2", BATTEN_BAD_ARGUMENT},
        {"{gregory: [a, b, d]}", "is open by", BATTEN_NOT_COMPATIBLE},
        {"{gregory: [long, b, c]}", "single cubics", BATTEN_UNSUPPORTED},
        {"{gregory: [a, b, c], angle: 0 deg}", "is above 0", BATTEN_BAD_ARGUMENT},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, NULL, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
}
