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

/* Every function at x = 0.5, y = 0.25, and what it says of one value too many. */
static const struct {
    const char *name, *arguments;
    double value;
    const char *says;
} functions[] = {
    {"sin", "x", 0.479425538604203, "sin takes 1 value, not 2"},
    {"cos", "x", 0.877582561890373, "cos takes 1 value, not 2"},
    {"tan", "x", 0.546302489843790, "tan takes 1 value, not 2"},
    {"asin", "x", 0.523598775598299, "asin takes 1 value, not 2"},
    {"acos", "x", 1.047197551196598, "acos takes 1 value, not 2"},
    {"atan", "x", 0.463647609000806, "atan takes 1 value, not 2"},
    {"sinh", "x", 0.521095305493747, "sinh takes 1 value, not 2"},
    {"cosh", "x", 1.127625965206381, "cosh takes 1 value, not 2"},
    {"tanh", "x", 0.462117157260010, "tanh takes 1 value, not 2"},
    {"exp", "x", 1.648721270700128, "exp takes 1 value, not 2"},
    {"ln", "x", -0.693147180559945, "ln takes 1 value, not 2"},
    {"log10", "x", -0.301029995663981, "log10 takes 1 value, not 2"},
    {"sqrt", "y", 0.5, "sqrt takes 1 value, not 2"},
    {"abs", "-x", 0.5, "abs takes 1 value, not 2"},
    {"min", "x, y", 0.25, "min takes 2 values, not 3"},
    {"max", "x, y", 0.5, "max takes 2 values, not 3"},
};

TEST(every_function_has_its_value_and_its_number_of_arguments)
{
    const double at[] = {0.5, 0.25};
    for (int i = 0; i < COUNT(functions); i++) {
        batten_equation *equation = NULL, *none = NULL;
        char text[40];
        double value = 0;
        snprintf(text, sizeof text, "%s(%s)", functions[i].name, functions[i].arguments);
        CHECK_OK(batten_equation_read(text, &names, &equation));
        CHECK_OK(batten_equation_value(equation, at, &value, NULL));
        CHECK_NEAR(value, functions[i].value, 2e-15);
        snprintf(text, sizeof text, "%s(%s, 1)", functions[i].name, functions[i].arguments);
        CHECK_STATUS(batten_equation_read(text, &names, &none), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(functions[i].says);
        CHECK(!none);
        batten_equation_free(equation);
    }
}

/* All variables and at most eight constants are offered, and of a long name 60 letters quoted. */
TEST(an_unknown_name_is_answered_by_those_that_are_known)
{
    static const batten_equation_constant many[] = {{"a", 1}, {"b", 2}, {"c", 3},
                                                    {"d", 4}, {"e", 5}, {"f", 6},
                                                    {"g", 7}, {"h", 8}, {"i", 9}};
    static const struct {
        int variables, constants;
        const char *text, *says;
    } rows[] = {
        {1, 0, "q", "nothing is named 'q'; the variable is: x"},
        {2, 0, "q", "nothing is named 'q'; the variables and numbers are: x, y"},
        {1, 1, "q", "nothing is named 'q'; the variables and numbers are: x, a"},
        {1, 9, "q", "the variables and numbers are: x, a, b, c, d, e, f, g, h"},
        {1, 0, "log(x)",
         "nothing is named 'log': write ln (natural) or log10; the variable is: x"},
        {1, 0, "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyzabcdefghijk",
         "'abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyzabcdefgh'; "},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *none = NULL;
        const batten_equation_names known = {rows[i].variables, rows[i].constants, variables,
                                             many};
        const batten_status status = batten_equation_read(rows[i].text, &known, &none);
        CHECK(status == BATTEN_BAD_FORMAT || status == BATTEN_OUT_OF_MEMORY);
        if (status == BATTEN_BAD_FORMAT) {
            const char *message = batten_message();
            const size_t length = strlen(message), wanted = strlen(rows[i].says);
            if (message[length - 1] == ' ') /* no memory for the list */
                continue;
            CHECK_MESSAGE(rows[i].says);
            CHECK(i == COUNT(rows) - 1 || strcmp(message + length - wanted, rows[i].says) == 0);
        }
        CHECK(!none);
    }
}

TEST(places_of_mistakes_are_quoted)
{
    static const struct {
        const char *text;
        batten_status status;
        const char *says;
    } rows[] = {
        {"x + *y", BATTEN_BAD_FORMAT, "a number or a name is expected at \"*y\""},
        {"x = .", BATTEN_BAD_FORMAT, "a number or a name is expected at \".\""},
        {"x = y = 0", BATTEN_BAD_FORMAT, "there is more than one '='"},
        {"1, 2", BATTEN_BAD_FORMAT,
         "a ',' is allowed only in min( ) and max( ); the decimal mark is '.'"},
        {"endless*x", BATTEN_NOT_FINITE, "endless is not finite"},
    };
    static const batten_equation_constant endless[] = {{"endless", INFINITY}};
    const batten_equation_names with = {2, 1, variables, endless};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_equation *none = NULL;
        CHECK_STATUS(batten_equation_read(rows[i].text, &with, &none), rows[i].status);
        CHECK_MESSAGE(rows[i].says);
        CHECK(!none);
    }
}
