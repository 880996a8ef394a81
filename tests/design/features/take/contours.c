#include "design/evaluate.h"
#include "design/picture_size.h"

#include <math.h>
#include <string.h>

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[1000];
    snprintf(
        text, sizeof text,
        "batten: 1\nunits: m\ntolerance: 1 mm\nfeatures:\n"
        "  ring: {torus: 3 m, minor: 1 m}\n  ball: {sphere: 2 m}\n"
        "  net: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
        "  sail: {bezier-triangle: net}\n  a: %s\n",
        feature);
    return evaluate_design(text, "a", NULL, out);
}

/* Every curve lies on one circle about the z-axis for each of its heights. */
static void check_ring(const batten_curve *curve, double tolerance)
{
    const batten_interval domain = {batten_curve_knots(curve)[batten_curve_degree(curve)],
                                    batten_curve_knots(curve)[batten_curve_point_count(curve)]};
    for (int i = 0; i <= 200; i++) {
        double p[3];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 200, 0, p));
        CHECK_NEAR(hypot(hypot(p[0], p[1]) - 3, p[2]), 1, tolerance);
        CHECK_NEAR(p[2], 0.5, tolerance);
    }
}

TEST(contours_become_curves_within_the_tolerance)
{
    static const char *const ways[] = {"curves", "polylines"};
    for (int i = 0; i < COUNT(ways); i++) {
        char feature[100];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature, "{contours: ring, levels: [0.5], as: %s}", ways[i]);
        CHECK_OK(evaluate(feature, &design));
        const batten_feature_result *result = batten_design_result(design, "a");
        CHECK_INT(batten_model_count(result->value), 2);
        for (int k = 0; k < 2; k++)
            check_ring(batten_model_object(result->value, k)->curve, 1e-3);
        batten_design_free(design);
    }
}

TEST(N6_contours_within_a_nanometre_are_few_cubics_and_less_is_refused)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{contours: ring, levels: [0.5], within: 1e-9}", &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK_INT(batten_model_count(result->value), 2);
    CHECK(result->error_max <= 1e-9);
    for (int k = 0; k < 2; k++) {
        const batten_curve *curve = batten_model_object(result->value, k)->curve;
        check_ring(curve, 1e-9);
        CHECK(batten_curve_point_count(curve) < 3000);
    }
    batten_design_free(design);
    CHECK_STATUS(evaluate("{contours: ring, levels: [0.5], within: 1e-15}", &design),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("contours cannot be within 1e-15");
}

TEST(reflection_lines_that_end_where_there_is_no_value_are_finished_with_a_note)
{
    static const char text[] =
        "batten: 1\nunits: m\nfeatures:\n"
        "  p: {points: [[0, 0, 0], [1, 0, 0.3], [2, 0, 0], [3, 0, 0.4], [0, 1, 0.4], [1, 1, "
        "1], "
        "[2, 1, 0.2], [3, 1, 0], [0, 2, 0], [1, 2, 0.6], [2, 2, 0.9], [3, 2, 0.1], "
        "[0, 3, 0.2], [1, 3, 0], [2, 3, 0.5], [3, 3, 0]], columns: 4}\n"
        "  s: {interpolate-grid: p}\n"
        "  a: {contours: s, of: reflection, direction: x, through: [0, 0, 3], spacing: 0.2, "
        "eye: z, within: 3e-6}\n";
    batten_design *design = NULL;
    CHECK_OK(evaluate_design(text, "a", NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    long count = 0;
    for (int i = 0; i < batten_model_count(result->value); i++)
        count += batten_curve_point_count(batten_model_object(result->value, i)->curve);
    CHECK(count > 100 && count < 200000);
    CHECK(result->error_max > 3e-6); /* where the field ends, as the note says */
    batten_design_free(design);
}

TEST(contours_of_many_surfaces_share_their_levels)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{contours: [ring, ball], spacing: 0.5 m}", &design));
    /* -1.5 .. 1.5 on the ball, -2 and 2 being its poles; 5 on the ring, those at -1 and 1 once
     */
    const batten_model *model = batten_design_result(design, "a")->value;
    int on_ball = 0;
    for (int i = 0; i < batten_model_count(model); i++)
        on_ball += strncmp(batten_model_object(model, i)->name, "ball", 4) == 0;
    CHECK_INT(on_ball, 7);
    CHECK(batten_model_count(model) >= on_ball + 6);
    batten_design_free(design);
}

TEST(triangles_have_contours)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{contours: sail, levels: [0.2, 0.4]}", &design));
    const batten_model *model = batten_design_result(design, "a")->value;
    CHECK(batten_model_count(model) >= 2);
    CHECK(batten_design_result(design, "a")->error_max <= 1e-3);
    batten_design_free(design);
}

TEST(contours_that_cannot_be_are_refused)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate("{contours: ring, levels: [5]}", &design), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("no level from 5 to 5 is met by the field, which runs from -");
    CHECK_STATUS(evaluate("{contours: ball, of: gaussian}", &design), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("0.25 everywhere");
    CHECK_STATUS(evaluate("{contours: ball, of: gaussian, levels: [0.25]}", &design),
                 BATTEN_NOT_FOUND);
    CHECK_MESSAGE("the field is 0.25 everywhere: no lines lie at its levels");
    CHECK_STATUS(evaluate("{contours: ring, levels: [1, 0]}", &design), BATTEN_NOT_INCREASING);
    CHECK_STATUS(evaluate("{contours: ring, of: isophote, direction: [0, 0, 0]}", &design),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(evaluate("{contours: ring, spacing: 0.0001 m}", &design), BATTEN_TOO_LARGE);
    CHECK(!design);
}

TEST(pictures_of_contours_have_isolines_only_when_asked_for)
{
    static const char sheet[] =
        "  sheet: {bilinear: [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1]]}\n";
    const size_t plain = picture_size(sheet, "picture: sheet, contours: height");
    CHECK(plain == picture_size(sheet, "picture: sheet, contours: height, isolines: 1"));
    CHECK(plain < picture_size(sheet, "picture: sheet, contours: height, isolines: 10"));
}

TEST(highlight_lines_that_end_within_the_surface_say_why)
{
    static const char text[] =
        "batten: 1\nunits: m\ntolerance: 1 mm\nfeatures:\n  egg: {ellipsoid: [1, 2, 3]}\n"
        "  a: {contours: egg, of: highlight, through: [0, 0, 5], direction: x, levels: [0]}\n";
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    bool is_said = false;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(evaluate_design(text, "a", notes, &design));
    for (int i = 0; i < batten_notes_count(notes); i++)
        is_said |= strstr(batten_notes_at(notes, i)->text, "within 5.7 degrees") != NULL;
    CHECK(is_said || batten_notes_dropped(notes));
    batten_design_free(design);
    batten_notes_free(notes);
}

/* From a distance d the outline of a ball of radius r is the circle at the height r^2 / d. */
TEST(the_silhouette_of_a_ball_from_a_point_is_the_circle_that_its_tangents_touch)
{
    batten_design *design = NULL;
    CHECK_OK(
        evaluate("{contours: ball, of: silhouette, through: [0, 0, 4], levels: [0]}", &design));
    const batten_model *model = batten_design_result(design, "a")->value;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_curve *curve = batten_model_object(model, i)->curve;
        const batten_interval domain = batten_curve_domain(curve);
        for (int k = 0; k <= 16; k++) {
            double p[3];
            CHECK_OK(
                batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * k / 16, 0, p));
            CHECK_NEAR(p[2], 1, 2e-3);
            CHECK_NEAR(hypot(p[0], p[1]), sqrt(3), 2e-3);
        }
    }
    CHECK(batten_model_count(model) >= 1);
    batten_design_free(design);
    design = NULL;
    CHECK_STATUS(evaluate("{contours: ball, of: absolute}", &design), BATTEN_NOT_FOUND);
    CHECK_MESSAGE("1 everywhere");
    CHECK_STATUS(evaluate("{contours: ball, of: zebra, eye: [0, 0, 0]}", &design),
                 BATTEN_BAD_ARGUMENT);
    CHECK(!design);
}
