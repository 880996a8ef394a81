/* Lines, circles and ellipses of the format: where they begin, pass and end. */
#include "exchange/reading.h"

/* The closed forms, halfway of pi / 2. */
#define R 0.70710678118654752
#define QUARTER "0 1.5707963267948966\n"

static const struct {
    const char *text;
    int dimension;
    double at[3][3]; /* at the start, halfway and at the end */
} curves[] = {
    {"120 1 0 0\n3\n1 2 3\n2 0 -4\n1\n0.5 2\n0\n", 3, {{2, 2, 1}, {3.5, 2, -2}, {5, 2, -5}}},
    {"120 1 0 0\n3\n1 2 3\n2 0 -4\n1\n0.5 2\n1\n", 3, {{5, 2, -5}, {3.5, 2, -2}, {2, 2, 1}}},
    /* older files end before the mark of the direction */
    {"120 1 0 0\n2\n1 2\n2 4\n1\n0 1\n", 2, {{1, 2}, {2, 4}, {3, 6}}},
    /* a range that runs backwards turns the curve; turned twice it is as it was */
    {"120 1 0 0\n2\n1 2\n2 4\n1\n1 0\n0\n", 2, {{3, 6}, {2, 4}, {1, 2}}},
    {"120 1 0 0\n2\n1 2\n2 4\n1\n1 0\n1\n", 2, {{1, 2}, {2, 4}, {3, 6}}},
    {"130 1 0 0\n3\n2\n1 2 3\n0 0 5\n7 0 0\n" QUARTER "0\n",
     3,
     {{3, 2, 3}, {1 + 2 * R, 2 + 2 * R, 3}, {1, 4, 3}}},
    {"130 1 0 0\n3\n2\n1 2 3\n0 0 5\n7 0 0\n" QUARTER "1\n",
     3,
     {{1, 4, 3}, {1 + 2 * R, 2 + 2 * R, 3}, {3, 2, 3}}},
    /* the x-axis is made square to the normal */
    {"130 1 0 0\n3\n2\n1 2 3\n0 1 0\n1 4 0\n" QUARTER "0\n",
     3,
     {{3, 2, 3}, {1 + 2 * R, 2, 3 - 2 * R}, {1, 2, 1}}},
    {"130 1 0 0\n2\n2\n1 2\n0 1\n" QUARTER "0\n", 2, {{1, 4}, {1 - 2 * R, 2 + 2 * R}, {-1, 2}}},
    /* without a range all around, and no more than once */
    {"130 1 0 0\n2\n2\n1 2\n0 1\n", 2, {{1, 4}, {1, 0}, {1, 4}}},
    {"130 1 0 0\n2\n2\n1 2\n0 1\n0 9\n0\n", 2, {{1, 4}, {1, 0}, {1, 4}}},
    {"140 1 0 0\n3\n4\n2\n1 2 3\n0 0 1\n1 0 0\n" QUARTER "0\n",
     3,
     {{5, 2, 3}, {1 + 4 * R, 2 + 2 * R, 3}, {1, 4, 3}}},
    {"140 1 0 0\n2\n4\n2\n1 2\n1 0\n1.5707963267948966 0\n0\n",
     2,
     {{1, 4}, {1 + 4 * R, 2 + 2 * R}, {5, 2}}},
};

TEST(lines_circles_and_ellipses_begin_pass_and_end_where_their_formula_has_them)
{
    for (int i = 0; i < COUNT(curves); i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(curves[i].text, BATTEN_FORMAT_G2, NULL, &model));
        CHECK_INT(batten_model_count(model), 1);
        const batten_curve *curve = batten_model_object(model, 0)->curve;
        const batten_interval on = batten_curve_domain(curve);
        CHECK_INT(batten_curve_dimension(curve), curves[i].dimension);
        for (int s = 0; s < 3; s++) {
            double p[3];
            CHECK_OK(batten_curve_evaluate(curve, on.a + s * (on.b - on.a) / 2, 0, p));
            for (int k = 0; k < curves[i].dimension; k++)
                CHECK_NEAR(p[k], curves[i].at[s][k], 1e-14);
        }
        batten_model_unref(model);
    }
}

TEST(a_range_that_runs_backwards_is_told)
{
    batten_model_unref(read_noting("120 1 0 0\n2\n1 2\n2 4\n1\n3 1\n0\n", BATTEN_FORMAT_G2,
                                   "a range runs backwards, from 3 to 1"));
    batten_model_unref(
        read_noting("120 1 0 0\n2\n1 2\n2 4\n1\n1 3\n0\n", BATTEN_FORMAT_G2, ""));
}

TEST(what_is_wrong_in_a_curve_is_named)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"120 1 0 0\n2\n1 2\n2 4\n1\n2 2\n0\n", "the range 2..2 is empty"},
        {"120 1 0 0\n2\n1 2\n2 4\n2\n0 1\n0\n", "the mark of a bounded line is 2"},
        {"120 1 0 0\n2\n1 2\n2 4\n1\n0 1\n2\n", "the mark of a turned curve is 2"},
        {"120 1 0 0\n1\n1\n2\n1\n0 1\n0\n", "the dimension is 1"},
        {"120 1 0 0\n2\n1 2\n2 4\n0\n", "the line has no ends"},
        {"130 1 0 0\n4\n2\n", "the dimension is 4"},
        {"130 1 0 0\n3\n2\n1 2 3\n0 0 0\n1 0 0\n", "0 or parallel"},
        {"130 1 0 0\n3\n2\n1 2 3\n0 0 1\n0 0 0\n", "0 or parallel"},
        {"160 1 0 0\n3\n", "not read"},
        {"100 1 0 0\n0 0\n", "the dimension is 0"},
        {"100 1 0 0\n3 2\n", "the sign of a rational curve is 2"},
        {"100 1 0 0\n3 0\n0 2\n", "the number of points is 0"},
        {"100 1 0 0\n3 0\n2 1\n", "the order is 1"},
        {"100 1 0 0\n1 1\n2 2\n0 0 1 1\n1 1\n1 -2\n", "weight 2 is -2"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED, cases[i].words);
}

TEST(a_spline_has_the_order_and_the_weights_of_the_file)
{
    batten_model *model = NULL;
    CHECK_OK(read_text("100 1 0 0\n1 1\n3 2\n0 0 1 3 3\n1 1\n4 2\n8 4\n", BATTEN_FORMAT_G2,
                       NULL, &model));
    const batten_curve *curve = batten_model_object(model, 0)->curve;
    static const double points[] = {1, 2, 2}, weights[] = {1, 2, 4}, knots[] = {0, 0, 1, 3, 3};
    CHECK_INT(batten_curve_degree(curve), 1);
    for (int i = 0; i < 3; i++)
        CHECK(batten_curve_points(curve)[i] == points[i] &&
              batten_curve_weights(curve)[i] == weights[i]);
    for (int i = 0; i < 5; i++)
        CHECK_BITS(batten_curve_knots(curve)[i], knots[i]);
    batten_model_unref(model);
}
