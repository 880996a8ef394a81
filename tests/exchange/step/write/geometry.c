#include "exchange/step/reading.h"

static const char *text_of_curve(const double *weights)
{
    const double points[] = {0, 0, 0, 1, 2, 0.1, 3, 0, -0.0, 4, 0, 5};
    const double knots[] = {0, 0, 0, 0.5, 1, 1, 1};
    batten_curve *curve = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 2, weights, knots, &curve));
    CHECK_OK(batten_model_create(0.001, &model));
    add_curve(model, "keel", curve);
    const char *text = step_text(model, NULL);
    batten_model_unref(model);
    batten_curve_unref(curve);
    step_check(text);
    return text;
}

TEST(a_curve_is_a_list_of_points_with_distinct_knots)
{
    const char *text = text_of_curve(NULL);
    CHECK_CONTAINS(text, "=CARTESIAN_POINT('',(1.,2.,0.1));\n");
    CHECK_CONTAINS(text, "=CARTESIAN_POINT('',(3.,0.,-0.));\n");
    CHECK_CONTAINS(text, "=B_SPLINE_CURVE_WITH_KNOTS('keel',2,(#");
    CHECK_CONTAINS(text, ",.UNSPECIFIED.,.F.,.F.,(3,1,3),(0.,0.5,1.),.UNSPECIFIED.);");
    CHECK_INT(step_count(text, "RATIONAL_B_SPLINE_CURVE"), 0);
}

TEST(a_rational_curve_is_a_complex_instance_in_the_order_of_the_alphabet)
{
    const double weights[] = {1, 0.5, 2, 1};
    const char *at = text_of_curve(weights);
    const char *const parts[] = {"BOUNDED_CURVE()",
                                 "B_SPLINE_CURVE(2,(#",
                                 "B_SPLINE_CURVE_WITH_KNOTS((3,1,3),",
                                 "CURVE()",
                                 "GEOMETRIC_REPRESENTATION_ITEM()",
                                 "RATIONAL_B_SPLINE_CURVE((",
                                 "1.,0.5,2.,1.))",
                                 "REPRESENTATION_ITEM('keel')"};
    for (int i = 0; i < COUNT(parts); i++) {
        at = strstr(at, parts[i]);
        CHECK(at != NULL);
        at += strlen(parts[i]);
    }
}

TEST(random_models_give_well_formed_files)
{
    test_random random = test_random_begin(__func__);
    for (int i = 0; i < test_cases(30); i++) {
        batten_model *model = random_model(&random, 0.0254);
        int surfaces = 0;
        for (int k = 0; k < batten_model_count(model); k++)
            surfaces += batten_model_object(model, k)->surface != NULL;
        const char *text = step_text(model, NULL);
        step_check(text);
        CHECK_INT(step_count(text, "ADVANCED_FACE"), surfaces);
        CHECK_INT(step_count(text, "B_SPLINE_SURFACE_WITH_KNOTS"), surfaces);
        CHECK_INT(step_count(text, "GEOMETRIC_CURVE_SET"),
                  batten_model_count(model) - surfaces);
        batten_model_unref(model);
    }
}
