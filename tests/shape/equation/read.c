#include <batten/standard.h>

#include "support/test.h"

static const char *const variables[] = {"x", "y"};
static const batten_equation_constant constants[] = {{"a", 3}, {"x", 99}, {"r2d2", 0.5}};
static const batten_equation_names names = {2, COUNT(constants), variables, constants};

TEST(expressions_have_the_values_of_mathematics)
{
    static const struct {
        const char *text;
        double value; /* at x = 2, y = 5 */
    } rows[] = {
        {"1 + 2*3", 7},
        {"(1 + 2)*3", 9},
        {"2^3^2", 512},
        {"-x^2", -4},
        {"2^-1", 0.5},
        {"x - y - 1", -4},
        {"y/x/5", 0.5},
        {"x^2 + y^2 = 29", 0},
        {"y = x + 3", 0},
        {"a*x", 6},
        {"r2d2", 0.5},
        {"min(x, y) + max(x, 7)", 9},
        {"abs(x - y)", 3},
        {"sqrt(x*8)", 4},
        {"+x", 2},
        {"1.5e1 - .5", 14.5},
        {"8^(1/3)", 2},
        {"exp(ln(y))", 5},
        {"log10(100*x/2)", 2},
        {"sin(pi/6)", 0.5},
        {"4*atan(1) - pi", 0},
        {"x = y = 0", NAN},
        {"tan(pi/4)", 1},
        {"cosh(0) + tanh(0)", 1},
    };
    const double at[] = {2, 5};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *equation = NULL;
        double value = 0, error = 0;
        if (isnan(rows[i].value)) {
            CHECK_STATUS(batten_equation_read(rows[i].text, &names, &equation),
                         BATTEN_BAD_FORMAT);
            continue;
        }
        CHECK_OK(batten_equation_read(rows[i].text, &names, &equation));
        CHECK_OK(batten_equation_value(equation, at, &value, &error));
        CHECK_NEAR(value, rows[i].value, 1e-14);
        CHECK(fabs(value - rows[i].value) <= error + DBL_EPSILON);
        batten_equation_free(equation);
    }
}

TEST(what_is_wrong_with_an_expression_is_said)
{
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"", "ends where a value is expected"},
        {"x +", "ends where a value is expected"},
        {"2 x", "an operator (+ - * / ^) is expected at \"x\""},
        {"foo*x", "nothing is named 'foo'"},
        {"log(x)", "write ln (natural) or log10"},
        {"sin x", "'(' is expected after sin"},
        {"(x", "a '(' is not closed"},
        {"x)", "a ')' has no '('"},
        {"min(x)", "min takes 2 values, not 1"},
        {"sin(x, y)", "sin takes 1 value, not 2"},
        {"1,5", "the decimal mark is '.'"},
        {"(x = 1)", "a '(' is not closed before '='"},
        {"x $ y", "an operator"},
        {"((((((((((((((((((((((((((x))))))))))))))))))))))))))",
         "nests deeper than the limit"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *equation = NULL;
        const batten_status status = batten_equation_read(rows[i].text, &names, &equation);
        CHECK(status != BATTEN_OK && !equation);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].says);
    }
}

TEST(expressions_have_one_to_three_variables)
{
    static const int counts[] = {-1, 0, 4};
    for (int i = 0; i < COUNT(counts); i++) {
        const batten_equation_names wrong = {counts[i], 0, names.variables, NULL};
        batten_equation *equation = NULL;
        CHECK_STATUS(batten_equation_read("1", &wrong, &equation), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("variables; an expression has 1 to 3");
        CHECK(!equation);
    }
}

TEST(values_that_are_not_there_are_out_of_domain)
{
    static const char *const texts[] = {"1/(x - 2)", "ln(x - 2)", "sqrt(1 - x)", "asin(y)"};
    const double at[] = {2, 5};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_equation *equation = NULL;
        double value = 7;
        CHECK_OK(batten_equation_read(texts[i], &names, &equation));
        CHECK_STATUS(batten_equation_value(equation, at, &value, NULL), BATTEN_OUT_OF_DOMAIN);
        CHECK(value == 7);
        batten_equation_free(equation);
    }
}
