/* Expressions evaluated with their derivatives. */
#include "shape/equation/program.h"

#include "support/test.h"

static const char *const variables[] = {"x", "y"};
static const batten_equation_names names = {2, 0, variables, NULL};

/* Values and derivatives by x and by y at (0.5, 2). */
static const struct {
    const char *text;
    double value[3];
} rows[] = {
    {"x + 3*y", {6.5, 1, 3}},
    {"x - 3*y", {-5.5, 1, -3}},
    {"x*x*y", {0.5, 2, 0.25}},
    {"y/x", {4, -8, 2}},
    {"y^3", {8, 0, 12}},
    {"4^x", {2, 2.772588722239781, 0}},
    {"-x*y", {-1, -2, -0.5}},
    {"min(x*y, y)", {1, 2, 0.5}},
    {"max(x*y, y)", {2, 0, 1}},
    {"max(y, x)", {2, 0, 1}},
    {"max(-x, -y)", {-0.5, -1, 0}},
    {"sqrt(x*y*4)", {2, 2, 0.5}},
    {"7", {7, 0, 0}},
};

TEST(expressions_have_the_derivatives_of_each_operation)
{
    const bat_interval box[] = {{0.5, 0.5}, {2, 2}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *equation = NULL;
        bat_jet_space space;
        bat_interval_jet jet;
        double value = 0, error = -1;
        CHECK_OK(batten_equation_read(rows[i].text, &names, &equation));
        bat_jet_space_begin(&space, 2, 1);
        bat_equation_over(equation, &space, box, &jet);
        CHECK_INT(space.state, BAT_DEFINED);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(jet.c[k].lo, rows[i].value[k], 1e-13);
            CHECK_NEAR(jet.c[k].hi, rows[i].value[k], 1e-13);
        }
        CHECK_OK(batten_equation_value(equation, (const double[]){0.5, 2}, &value, &error));
        CHECK_NEAR(value, rows[i].value[0], 1e-14);
        CHECK(error >= 0 && error < 1e-14);
        batten_equation_free(equation);
    }
}

/* 2 min(x, 1) over [0, 3] is [0, 2]; of max(y, 0) over [-2, -1] nothing but 0 is left. */
TEST(expressions_over_a_box_enclose_its_values)
{
    static const struct {
        const char *text;
        double lo, hi;
    } ranges[] = {
        {"2*min(x, 1)", 0, 2}, {"max(y, 0)", 0, 0}, {"max(x, y + 3)", 1, 3},
        {"x*y", -6, 0},        {"y^2 - x", -2, 4},
    };
    const bat_interval box[] = {{0, 3}, {-2, -1}};
    for (int i = 0; i < COUNT(ranges); i++) {
        batten_equation *equation = NULL;
        bat_jet_space space;
        bat_interval_jet jet;
        CHECK_OK(batten_equation_read(ranges[i].text, &names, &equation));
        bat_jet_space_begin(&space, 2, 1);
        bat_equation_over(equation, &space, box, &jet);
        CHECK_NEAR(jet.c[0].lo, ranges[i].lo, 1e-13);
        CHECK_NEAR(jet.c[0].hi, ranges[i].hi, 1e-13);
        batten_equation_free(equation);
    }
}

/* Half the width of what encloses a result: 1e17 + 1 lies between two numbers. */
TEST(the_error_of_a_value_is_half_the_width_of_its_enclosure)
{
    batten_equation *equation = NULL;
    double value = 0, error = 0;
    CHECK_OK(batten_equation_read("x + y", &names, &equation));
    CHECK_OK(batten_equation_value(equation, (const double[]){1e17, 1}, &value, &error));
    CHECK_NEAR(value, 1e17, 16);
    CHECK(error >= 1 && error <= 48);
    CHECK_OK(batten_equation_value(equation, (const double[]){3, 4}, &value, NULL));
    CHECK(value == 7);
    const double far[] = {1e308, 1e308};
    CHECK_STATUS(batten_equation_value(equation, far, &value, &error), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("the expression has no finite value there");
    CHECK(value == 7);
    batten_equation_free(equation);
    batten_equation_free(NULL);
}
