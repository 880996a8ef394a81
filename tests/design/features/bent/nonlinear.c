#include "design/evaluate.h"

#include <batten/base.h>

/* A feature `a` evaluated after `before`. */
static batten_status evaluate(const char *before, const char *feature, batten_design **out,
                              batten_notes *notes)
{
    char text[2000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", before, feature);
    return evaluate_design(text, "a", notes, out);
}

static const char ducks[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2]]}\n"
    "  ring: {points: [[2, 2, 0], [2, 1.4, 1.5], [2, 0, 2.1], [2, -1.4, 1.4], [2, -1, -1]]}\n"
    "  q: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2]]}\n";

TEST(features_of_nonlinear_splines_leave_chains_through_their_points)
{
    static const char *const operations[] = {
        "euler-spiral",  "elastica", "geometric-spline", "local-cubic",
        "local-tension", "hobby",    "arc-spline",       "mehlum",
    };
    static const char *const rest[] = {
        "p", "ring, closed: yes",
        "p, start: tangent, start-angle: 40 deg, end: curvature, end-curvature: -0.1"};
    for (int i = 0; i < COUNT(operations) * COUNT(rest); i++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "{%s: %s}", operations[i / COUNT(rest)],
                 rest[i % COUNT(rest)]);
        CHECK_OK(evaluate(ducks, feature, &design, NULL));
        const batten_model *model = batten_design_result(design, "a")->value;
        const batten_object *object = batten_model_object(model, 0);
        CHECK(object->chain != NULL);
        CHECK_INT(object->point_count, 5);
        for (int k = 0; k < 5; k++) {
            double at[3], on_curve[3];
            CHECK_OK(batten_chain_evaluate(object->chain, object->parameters[k], 0, at));
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, on_curve));
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(at[c], object->points[3 * k + c], 1e-11);
                CHECK_NEAR(on_curve[c], at[c], 1e-11);
            }
        }
        batten_design_free(design);
    }
}

TEST(spiro_takes_the_kinds_of_its_points_and_conditions_at_its_ends)
{
    const char *track =
        "  t: {points: [[0, 1, 0], [4, 1, 0], [5, 1, 1], [4, 1, 2], [0, 1, 2]]}\n";
    batten_design *design = NULL;
    CHECK_OK(evaluate(track, "{spiro: t, left: [2], right: [4]}", &design, NULL));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK_INT(batten_chain_span_count(object->chain), 4);
    for (int j = 0; j < 4; j++)
        CHECK((batten_chain_span(object->chain, j)->kind == BATTEN_SPAN_ARC) ==
              (j == 0 || j == 3));
    for (int k = 0; k < 5; k++) {
        double at[3];
        CHECK_OK(batten_chain_evaluate(object->chain, object->parameters[k], 0, at));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(at[c], object->points[3 * k + c], 1e-11);
    }
    batten_design_free(design);
    CHECK_OK(evaluate(ducks,
                      "{spiro: p, curvature: [3], start: both, start-angle: 40 deg, "
                      "start-curvature: -0.2, end: natural}",
                      &design, NULL));
    object = batten_model_object(batten_design_result(design, "a")->value, 0);
    const batten_span *first = batten_chain_span(object->chain, 0);
    CHECK_NEAR(first->angle, 40 * 3.14159265358979323846 / 180, 1e-12);
    CHECK_NEAR(first->curvature[0], -0.2, 1e-12);
    const batten_span *last = batten_chain_span(object->chain, 3);
    const double l = last->length, *k = last->curvature;
    CHECK_NEAR(k[0] + l * (k[1] + l * (k[2] / 2 + l * k[3] / 6)), 0, 1e-11);
    batten_design_free(design);
}

TEST(spiro_names_lists_that_do_not_fit_and_rows_out_of_a_plane)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate(ducks, "{spiro: p, corners: [6]}", &design, NULL),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("'corners' names point 6 of 5");
    CHECK_STATUS(evaluate(ducks, "{spiro: p, left: [3], corners: [3]}", &design, NULL),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("another list");
    CHECK_STATUS(evaluate(ducks, "{spiro: q}", &design, NULL), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("must lie in a plane");
}

TEST(a_given_tension_pulls_every_span_to_its_chord)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate(ducks, "{local-tension: p, tension: 1000}", &design, NULL));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    const batten_span *span = batten_chain_span(object->chain, 1);
    CHECK_NEAR(span->tension * span->length, 1000, 1e-9);
    batten_design_free(design);
}

TEST(nonlinear_splines_stay_in_a_plane_and_name_what_they_cannot)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate(ducks, "{euler-spiral: q}", &design, NULL), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("must lie in a plane");
    const char *back = "  p: {points: [[0, 0], [2, 0], [1, 0], [1, 3]]}\n";
    CHECK_STATUS(evaluate(back, "{euler-spiral: p}", &design, NULL), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("turns back on itself at point 2");
    const char *sharp = "  p: {points: [[0, 0], [2, 0], [0.5, 0.5], [2, 3]]}\n";
    CHECK_STATUS(evaluate(sharp, "{local-cubic: p}", &design, NULL), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("use an Euler spiral");
}

TEST(sharp_turns_are_noted)
{
    const char *sharp = "  p: {points: [[0, 0], [2, 0], [0.5, 0.5], [2, 3]]}\n";
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(4, &notes));
    batten_design *design = NULL;
    CHECK_OK(evaluate(sharp, "{euler-spiral: p}", &design, notes));
    batten_design_free(design);
    /* Where memory failed other notes may stand before it, or it was dropped and counted. */
    bool noted = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        noted |=
            strstr(batten_notes_at(notes, i)->text, "turns by 162 degrees at point 2") != NULL;
    CHECK(noted);
    batten_notes_free(notes);
}

TEST(parts_of_chains_stay_chains)
{
    static const char *const features[] = {
        "{part: c, from: 0.5, to: 2}",
        "{reverse: c}",
        "{split: c, parameter: 1.2}",
        "{join: [c, d]}",
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        char before[1000];
        snprintf(before, sizeof before,
                 "%s  c: {euler-spiral: p}\n  far: {move: p, by: [4, 0]}\n"
                 "  d: {elastica: far}\n",
                 ducks);
        CHECK_OK(evaluate(before, features[i], &design, NULL));
        const batten_model *model = batten_design_result(design, "a")->value;
        for (int n = 0; n < batten_model_count(model); n++) {
            const batten_object *object = batten_model_object(model, n);
            CHECK(object->chain != NULL);
            const batten_interval domain = batten_curve_domain(object->curve);
            CHECK_NEAR(batten_chain_domain(object->chain).a, domain.a, 1e-12);
            CHECK_NEAR(batten_chain_domain(object->chain).b, domain.b, 1e-12);
            for (int k = 0; k <= 20; k++) {
                const double u = domain.a + (domain.b - domain.a) * k / 20;
                double p[3], q[3];
                CHECK_OK(batten_curve_evaluate(object->curve, u, 0, p));
                CHECK_OK(batten_chain_evaluate(object->chain, u, 0, q));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(p[c], q[c], 1e-6);
            }
        }
        batten_design_free(design);
    }
    /* A chain and a curve that is none join as curves. */
    batten_design *design = NULL;
    char before[1000];
    snprintf(before, sizeof before,
             "%s  c: {euler-spiral: p}\n  l: {line: [[4, 0, 2], [5, 0, 2]]}\n", ducks);
    CHECK_OK(evaluate(before, "{join: [c, l]}", &design, NULL));
    CHECK(batten_model_object(batten_design_result(design, "a")->value, 0)->chain == NULL);
    batten_design_free(design);
}

/* Beams, splines in tension, clothoids and arcs around one patch. */
TEST(surfaces_are_made_from_curves_of_any_kind)
{
    static const char sides[] =
        "  p0: {points: [[0, 0, 0], [1, 0, 0.4], [2, 0, 0.3], [3, 0, 0]]}\n"
        "  p1: {points: [[0, 2, 0], [1, 2, 0.6], [2, 2, 0.5], [3, 2, 0]]}\n"
        "  q0: {points: [[0, 0, 0], [0, 1, 0.3], [0, 2, 0]]}\n"
        "  q1: {points: [[3, 0, 0], [3, 1, 0.2], [3, 2, 0]]}\n"
        "  s: {elastica: p0}\n  n: {tension: p1, amount: 6}\n"
        "  w: {euler-spiral: q0}\n  e: {biarcs: q1}\n";
    static const char *const features[] = {
        "{coons: [s, e, n, w]}", "{skin: [s, n]}", "{ruled: [w, e]}",
        "{gordon: [s, n], guides: [w, e]}", "{fill: [s, e, n, w], continuity: G0}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(sides, features[i], &design, NULL));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK(batten_model_count(model) > 0);
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_SURFACE);
        batten_design_free(design);
    }
}
