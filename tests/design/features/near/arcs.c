#include "design/evaluate.h"

/* A feature `a` evaluated after `before`. */
static batten_status evaluate(const char *before, const char *feature, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n%s  a: %s\n", before, feature);
    return evaluate_design(text, "a", NULL, out);
}

static const char ducks[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.3, 2], [3, 1, 2], [4, 0, 2]]}\n"
    "  q: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2]]}\n";

TEST(features_of_arcs_leave_chains_of_arcs_through_their_points)
{
    static const char *const features[] = {
        "{arcs: p, within: 0.1}",
        "{arcs: p, within: 0.1, joined: plain, one-sided: left}",
        "{sequential-arcs: p}",
        "{sequential-arcs: p, start-angle: 30 deg}",
        "{biarcs: p}",
        "{biarcs: p, joint: given, place: 0.3}",
        "{biarcs: p, closed: yes}"};
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(ducks, features[i], &design));
        const batten_model *model = batten_design_result(design, "a")->value;
        CHECK_INT(batten_model_count(model), 1);
        const batten_object *object = batten_model_object(model, 0);
        CHECK(object->chain && batten_chain_is_arcs(object->chain));
        CHECK_INT(object->point_count, 5);
        for (int k = 0; k < 5; k++) {
            double at[3], on_curve[3];
            CHECK_OK(batten_chain_evaluate(object->chain, object->parameters[k], 0, at));
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, on_curve));
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(at[c], object->points[3 * k + c], i < 2 ? 0.1 : 1e-12);
                /* The curve goes through its arcs at another pace. */
                CHECK_NEAR(on_curve[c], at[c], i < 2 ? 0.02 : 1e-12);
            }
        }
        batten_design_free(design);
    }
}

TEST(biarcs_in_space_go_where_those_in_the_plane_cannot)
{
    batten_design *design = NULL;
    CHECK_STATUS(evaluate(ducks, "{biarcs: q}", &design), BATTEN_NOT_COMPATIBLE);
    CHECK_OK(evaluate(ducks, "{biarcs: q, in: space}", &design));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK(!object->chain);
    CHECK(batten_curve_is_rational(object->curve));
    batten_design_free(design);
}

TEST(arcs_of_a_polyline_with_round_corners_are_its_own)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("  p: {polyline: [[4, 0], [8, 0], [8, 8], [0, 8], [0, 0], [4, 0]]}\n"
                      "  f: {fillet: p, radius: 1}\n",
                      "{arcs: f, within: 0.3}", &design));
    const batten_object *object =
        batten_model_object(batten_design_result(design, "a")->value, 0);
    CHECK(object->chain && batten_chain_is_arcs(object->chain));
    CHECK_INT(batten_chain_span_count(object->chain), 8);
    CHECK_NEAR(batten_chain_domain(object->chain).b, 32 - 8 + 2 * acos(-1), 1e-12);
    batten_design_free(design);
}

TEST(arcs_of_curves_stay_in_their_plane)
{
    static const char curves[] =
        "  p: {points: [[3, 0, 0], [3, 1, 0.5], [3, 2, 0.3], [3, 3, 1]]}\n"
        "  c: {interpolate: p}\n  d: {circle: 2, at: [0, 0, 1], axis: y}\n"
        "  e: {circle: 2, at: [0, 0, 1], axis: [1, 1, 0]}\n";
    batten_design *design = NULL;
    CHECK_OK(evaluate(curves, "{arcs: [c, d], within: 0.01, joined: plain}", &design));
    const batten_model *model = batten_design_result(design, "a")->value;
    CHECK_INT(batten_model_count(model), 2);
    for (int i = 0; i < 2; i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK(object->chain && batten_chain_is_arcs(object->chain));
        const double end = batten_chain_domain(object->chain).b;
        for (int k = 0; k <= 20; k++) {
            double at[3], on_curve[3];
            CHECK_OK(batten_chain_evaluate(object->chain, end * k / 20, 0, at));
            CHECK_OK(batten_curve_evaluate(object->curve, end * k / 20, 0, on_curve));
            if (i == 0)
                CHECK_NEAR(at[0], 3, 1e-14);
            else
                CHECK_NEAR(hypot(at[0], at[2] - 1), 2, 1e-12);
            CHECK_NEAR(hypot(at[0] - on_curve[0], at[2] - on_curve[2]), 0, 0.1);
        }
    }
    batten_design_free(design);
    CHECK_STATUS(evaluate(curves, "{arcs: e, within: 0.01}", &design), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("must lie in a plane");
    CHECK_STATUS(evaluate(curves, "{arcs: [c, p], within: 0.01}", &design),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(evaluate(curves, "{arcs: c, within: 0.01, least-radius: 5 m}", &design),
                 BATTEN_TOLERANCE_NOT_MET);
}
