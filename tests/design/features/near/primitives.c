#include "design/evaluate.h"

#include <batten/base.h>

static const char rows_of_points[] =
    "  straight: {points: [[0, 0, 1], [1, 2, 3], [2, 4, 5], [4, 8, 9]]}\n"
    "  square: {points: [[0, 0], [1, 0], [1, 1], [0, 1]]}\n"
    "  one: {points: [[1, 2], [1, 2], [1, 2], [1, 2], [1, 2]]}\n"
    "  pair: {points: [[0, 0], [1, 1]]}\n"
    "  flat: {points: [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]]}\n"
    "  round: {points: [[2, 5, 0], [2, 3, 2], [2, 1, 0], [2, 3, -2]]}\n"
    "  arc: {points: [[5, 0, 7], [3, 4, 7], [0, 5, 7], [-3, 4, 7]]}\n"
    "  oval: {points: [[3, 1], [1.4, 1.3], [0, 2], [-1.4, 1.3], [-3, -1], [1, -2]]}\n"
    "  clock: {points: [[2, 0, 3], [1.2, 0.8, 3], [0, 1, 3], [-1.2, 0.8, 3], [-2, 0, 3]]}\n"
    "  bow: {points: [[3, 8], [2, 3], [1, 0], [0, -1], [-1, 0], [-2, 3]]}\n"
    "  skew: {points: [[0, 0, 0], [1, 0, 1], [2, 1, 0], [3, 1, 1], [4, 2, 5]]}\n"
    "  branches: {points: [[1, 1], [2, 0.5], [4, 0.25], [0.5, 2], [-1, -1], [-2, -0.5], [-0.5, "
    "-2]]}\n";

static batten_status evaluate(const char *feature, batten_design **out, batten_notes *notes)
{
    char text[3000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", rows_of_points, feature);
    return evaluate_design(text, "a", notes, out);
}

TEST(a_line_fitted_to_a_straight_row_runs_from_its_first_point_to_its_last)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{fit-line: straight}", &design, NULL));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK_INT(batten_curve_degree(object->curve), 1);
    CHECK_INT(object->point_count, 4);
    for (int i = 0; i < 4; i++) {
        double at[3];
        CHECK_NEAR(object->parameters[i], i == 3 ? 1 : i / 4.0, 1e-15);
        CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[i], 0, at));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(at[k], object->points[3 * i + k], 1e-14);
    }
    batten_design_free(design);
}

/* How far the curve of a feature is from the circle about c, or from the ellipse of x and y. */
static void check_on(const char *feature, int turns, const double c[3], const double inverse[3])
{
    batten_design *design = NULL;
    CHECK_OK(evaluate(feature, &design, NULL));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK(batten_curve_is_rational(object->curve));
    CHECK(object->parameters == NULL);
    CHECK_INT(batten_curve_is_closed(object->curve, 1e-12), turns);
    const batten_interval domain = batten_curve_domain(object->curve);
    CHECK(domain.a == 0 && domain.b == 1);
    for (int i = 0; i <= 50; i++) {
        double at[3], sum = 0;
        CHECK_OK(batten_curve_evaluate(object->curve, i / 50.0, 0, at));
        for (int k = 0; k < 3; k++)
            sum += (at[k] - c[k]) * (at[k] - c[k]) * inverse[k] * inverse[k];
        CHECK_NEAR(sum, 1, 1e-11);
    }
    batten_design_free(design);
}

TEST(circles_and_ellipses_are_exact_and_lie_where_their_points_do)
{
    const double at_round[3] = {2, 3, 0}, at_arc[3] = {0, 0, 7}, at_clock[3] = {0, 0, 3};
    check_on("{fit-circle: round}", 1, at_round, (double[3]){1e6, 0.5, 0.5});
    check_on("{fit-circle: arc, by: kasa}", 1, at_arc, (double[3]){0.2, 0.2, 1e6});
    check_on("{fit-circle: arc, whole: no}", 0, at_arc, (double[3]){0.2, 0.2, 1e6});
    check_on("{fit-ellipse: clock}", 1, at_clock, (double[3]){0.5, 1, 1e6});
    check_on("{fit-ellipse: clock, whole: no}", 0, at_clock, (double[3]){0.5, 1, 1e6});
}

TEST(an_arc_begins_beside_the_first_point_and_ends_beside_the_last_whichever_way_they_run)
{
    static const char *const features[] = {"{fit-ellipse: clock, whole: no}",
                                           "{fit-circle: arc, whole: no}"};
    static const double ends[2][2][2] = {{{2, 0}, {-2, 0}}, {{5, 0}, {-3, 4}}};
    for (int f = 0; f < 2; f++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[f], &design, NULL));
        const batten_object *object =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        for (int e = 0; e < 2; e++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(object->curve, e, 0, at));
            CHECK_NEAR(at[0], ends[f][e][0], 1e-11);
            CHECK_NEAR(at[1], ends[f][e][1], 1e-11);
        }
        batten_design_free(design);
    }
}

TEST(a_fitted_clothoid_is_a_chain_and_its_error_is_told)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{fit-clothoid: clock}", &design, NULL));
    const batten_feature_result *result = batten_design_result(design, "a");
    const batten_object *object = batten_model_object(result->value, 0);
    CHECK(object->chain != NULL);
    CHECK_INT(batten_chain_span_count(object->chain), 1);
    double largest = 0;
    for (int i = 0; i < 5; i++) {
        double at[3];
        CHECK_OK(batten_chain_evaluate(object->chain, object->parameters[i], 0, at));
        CHECK_NEAR(at[2], 3, 0);
        largest = fmax(largest,
                       hypot(at[0] - object->points[3 * i], at[1] - object->points[3 * i + 1]));
    }
    CHECK(result->has_error);
    CHECK_NEAR(result->error_max, largest, 1e-9);
    batten_design_free(design);
}

TEST(fits_of_primitives_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{fit-line: square}", "spread alike"},
        {"{fit-line: one}", "coincide"},
        {"{fit-circle: pair}", "no row has 3 points"},
        {"{fit-circle: flat}", "lie on a line"},
        {"{fit-circle: one}", "coincide"},
        {"{fit-ellipse: square}", "no row has 5 points"},
        {"{fit-ellipse: flat}", "lie on a line"},
        {"{fit-ellipse: skew}", "must lie in a plane"},
        {"{fit-ellipse: bow}", "a parabola or a hyperbola"},
        {"{fit-ellipse: branches}", "a parabola or a hyperbola"},
        {"{fit-clothoid: pair}", "no row has 4 points"},
        {"{fit-clothoid: one}", "coincide"},
        {"{fit-clothoid: skew}", "must lie in a plane"},
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

TEST(radius_and_half_axes_are_noted)
{
    static const char *const features[] = {"{fit-circle: arc}", "{fit-ellipse: clock}"};
    static const char *const says[] = {"radius 5 about [", "semi-axes 2 and 1"};
    for (int i = 0; i < 2; i++) {
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
