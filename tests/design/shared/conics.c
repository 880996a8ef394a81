#include "design/evaluate.h"

/* The first object of feature `a`, evaluated after some points. */
static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[2000];
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n"
             "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0.7, 2]]}\n"
             "  ring: {points: [[2, 2, 0], [2, 1.4, 1.5], [2, 0, 2.1], [2, -1.4, 1.4]]}\n"
             "  gap: {points: [[0, 0], [3, 0]]}\n"
             "  bent: {points: [[0, 0, 2], [1, 0.5, 1], [2, 0.3, 2], [3, 1, 2]]}\n"
             "  a: %s\n",
             feature);
    return evaluate_design(text, "a", NULL, out);
}

TEST(features_of_conics_pass_their_points_exactly)
{
    static const char *const features[] = {
        "{conic-spline: p}",
        "{conic-spline: ring, closed: yes}",
        "{conic-spline: p, curvatures: -0.3, start-share: 0.4, end-share: 0.6}",
        "{local-conics: p}",
        "{local-conics: ring, closed: yes, weight: 0.7}",
        "{conic-pair: gap, start-angle: 50 deg, end-angle: -20 deg}",
        /* parentheses: one string, not a forgotten comma */
        ("{conic-pair: gap, start-angle: 50 deg, end-angle: -20 deg, start-curvature: -1, "
         "end-curvature: -0.1}"),
    };
    for (int i = 0; i < COUNT(features); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(features[i], &design));
        const batten_object *object =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        CHECK_INT(batten_curve_degree(object->curve), 2);
        for (int k = 0; k < object->point_count; k++) {
            double at[3];
            CHECK_OK(batten_curve_evaluate(object->curve, object->parameters[k], 0, at));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(at[c], object->points[3 * k + c], 1e-14);
        }
        batten_design_free(design);
    }
}

TEST(features_of_conics_refuse_what_they_cannot)
{
    static const struct {
        const char *feature, *message;
        batten_status status;
    } rows[] = {
        {"{conic-spline: bent}", "must lie in a plane", BATTEN_NOT_COMPATIBLE},
        {"{conic-pair: p, start-angle: 0 deg, end-angle: 1 deg}", "2 points, not 5",
         BATTEN_BAD_ARGUMENT},
        {"{conic-pair: gap, start-angle: 9 deg, end-angle: -9 deg, end-curvature: 1}",
         "both or none", BATTEN_BAD_ARGUMENT},
        {"{local-conics: p, weight: -1}", "weight", BATTEN_BAD_ARGUMENT},
        {"{conic-spline: p, start-share: 1}", "share", BATTEN_BAD_ARGUMENT},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
}
