#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/base.h>

#define ALONG "[[1, 0], [1, 0], [1, 0], [1, 0], [1, 0]]"

/* A feature `a` of the common rows. */
static batten_status evaluate(const char *feature, batten_design **out, batten_notes *notes)
{
    static const char rows[] =
        "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2]]}\n"
        "  step: {points: [[0, 1, 0], [1, 1, 0], [2, 1, 0.1], [3, 1, 2], [4, 1, 2]]}\n"
        "  ring: {points: [[2, 2, 0], [2, 1.4, 1.5], [2, 0, 2.1], [2, -1.4, 1.4], [2, -1, "
        "-1]]}\n"
        "  q: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2], [4, 0, 0]]}\n"
        "  rise: {points: [[0, 0], [1, 0], [2, 0], [3, 0.2], [4, 3], [5, 10], [6, 30]]}\n"
        "  line: {points: [[0, 0.1], [0.1, 0.17], [0.2, 0.24], [0.7, 0.59], [1, 0.8]]}\n"
        "  back: {points: [[0, 0], [2, 0], [1, 0], [1, 1], [2, 2]]}\n";
    char text[2000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", rows, feature);
    return evaluate_design(text, "a", notes, out);
}

TEST(features_of_local_methods_leave_curves_through_their_points)
{
    static const char *const features[] = {
        "{circle-tangents: q, lengths: middle}",
        "{circle-tangents: ring, closed: yes}",
        "{interpolate: step, as: function}",
        "{interpolate: step, as: function, ends: clamped, degree: 3}",
        "{interpolate: p, as: function, periodic: yes}",
        "{catmull-rom: q}",
        "{catmull-rom: ring, closed: yes, alpha: 0.3, blend: 3, local: 3}",
        "{catmull-rom: step, as: function, beyond: reflect}",
        "{cardinal: q, tension: 0.5}",
        "{cardinal: step, as: function, tension: [0, 0, 1, 0, 0]}",
        "{kochanek-bartels: ring, closed: yes, alpha: 0.5, bias: 0.5}",
        "{kochanek-bartels: q, tension: 0.2, continuity: [0, -1, 0, 1, 0], beyond: repeat}",
        "{mcconalogue: q}",
        "{bessel: q}",
        "{bessel: step, as: function}",
        "{akima: ring, closed: yes}",
        "{akima: step, as: function}",
        "{akima: step, as: function, modified: yes}",
        "{renner: step, corners: keep}",
        "{hermite: q, estimate: parabola, lengths: rule, degree: quintic}",
        "{hermite: p, tangents: [[0, 1], [1, 0], [1, 0], [1, 0], [0, -1]], lengths: middle}",
        "{hermite: p, tangents: " ALONG ", second: " ALONG ", degree: quintic}",
        "{fritsch-carlson: step}",
        "{fritsch-butland: step}",
        "{steffen: step}",
        "{schumaker: step}",
        "{rational-monotone: step}",
        "{tangents-and-curvatures: ring, closed: yes}",
        "{tangents-and-curvatures: p, tangents: " ALONG ", curvatures: -0.1}",
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design, NULL));
        const batten_object *object =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        CHECK_INT(object->point_count, 5);
        for (int k = 0; k < 5; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, at));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(at[c], object->points[3 * k + c], 1e-13);
        }
        batten_design_free(design);
    }
}

TEST(local_methods_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{bessel: step, as: function, closed: yes}", "a function cannot be closed"},
        {"{akima: step, as: function, closed: yes}", "a function cannot be closed"},
        {"{interpolate: step, as: function, periodic: yes}",
         "a periodic function ends with the value it begins with; these are 2 and 0"},
        {"{interpolate: ring, as: function}", "rising abscissae"},
        {"{catmull-rom: step, as: function, closed: yes}", "a function cannot be closed"},
        {"{catmull-rom: q, blend: 0}", "the blending degree is 0"},
        {"{catmull-rom: q, alpha: 2}", "alpha is 2"},
        {"{cardinal: q, tension: [1, 2]}", "'tension' has 2 numbers for 5 points"},
        {"{cardinal: step, as: function, closed: yes}", "a function cannot be closed"},
        {"{kochanek-bartels: q, bias: [1, 2, 3]}", "'bias' has 3 numbers for 5 points"},
        {"{akima: q, modified: yes}", "'modified' is for functions"},
        {"{fritsch-carlson: ring}", "rising abscissae"},
        {"{schumaker: q}", "must lie in a plane"},
        {"{tangents-and-curvatures: q}", "must lie in a plane"},
        {"{tangents-and-curvatures: p, curvatures: [1, 2]}", "2 numbers for 5 points"},
        {"{hermite: p, tangents: [[1, 0], [0, 1]]}", "2 vectors for 5 points"},
        {"{hermite: p, tangents: [[1, 0], [1, 0], [0, 0], [1, 0], [1, 0]]}",
         "tangent at point 3 has no length"},
        {"{hermite: ring, closed: yes, degree: quintic}", "a closed curve is cubic here"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, &design, NULL);
        if (test_memory_failed(status, BATTEN_BAD_ARGUMENT))
            status = evaluate(rows[i].feature, &design, NULL);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

/* Points in line are convex up to rounding, and so are their splines: nothing is to be said. */
TEST(splines_of_points_in_line_are_not_blamed_for_rounding)
{
    static const char *const features[] = {"{interpolate: line, as: function}",
                                           "{interpolate: line, as: function, ends: natural}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(4, &notes));
        CHECK_OK(evaluate(features[i], &design, notes));
        /* Where memory failed there is another note. */
        for (int k = 0; k < batten_notes_count(notes); k++)
            CHECK(strstr(batten_notes_at(notes, k)->text, "bends back") == NULL);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

TEST(g3_what_local_methods_cannot_keep_is_noted)
{
    static const char *const features[] = {
        "{circle-tangents: back}",
        "{tangents-and-curvatures: p, tangents: " ALONG ", curvatures: [9, -9, 9, -9, 9]}",
        "{catmull-rom: q, blend: 3, local: 0}", "{interpolate: rise, as: function}",
        "{interpolate: rise, as: function, ends: natural}"};
    static const char *const says[] = {
        "the first is point 2", "keeps the tangents alone", "passes near the points",
        "points are convex, but the curve bends back at point", "because point 2 stands out"};
    for (int i = 0; i < COUNT(says); i++) {
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(4, &notes));
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design, notes));
        batten_design_free(design);
        bool said = batten_notes_dropped(notes) > 0; /* where memory failed */
        for (int k = 0; k < batten_notes_count(notes); k++)
            said = said || strstr(batten_notes_at(notes, k)->text, says[i]);
        CHECK(said);
        batten_notes_free(notes);
    }
}

TEST(as_many_vectors_as_points_are_needed)
{
    static const char ducks[] =
        "  ducks: {points: [[0, 0], [1, 1], [2, -1], [3, 1], [4, 0]]}\n";
    static const expect_row rows[] = {
        {"{hermite: ducks, tangents: [[1, 0]]}", BATTEN_BAD_ARGUMENT,
         "'tangents' has 1 vector for 5 points"},
        {"{hermite: ducks, tangents: [[1, 0], [1, 0]]}", BATTEN_BAD_ARGUMENT,
         "'tangents' has 2 vectors for 5 points"},
        {"{tangents-and-curvatures: ducks, tangents: [[1, 0]]}", BATTEN_BAD_ARGUMENT,
         "'tangents' has 1 vector for 5 points"},
        {"{hermite: ducks, tangents: [[1, 0], [1, 0], [0, 2], [1, 0], [1, 0]]}", BATTEN_OK,
         "passes;heads 0 1 0 0;heads 1 1 0 0"},
    };
    EXPECT(ducks, rows);
}
