/* Expressions: arithmetic with units, functions, names and their limits. */
#include "design/text/edit_distance.h"
#include "design/text/value.h"

#include "support/test.h"

#include <string.h>

static const bat_quantity beam = {3.2, 1, 0}, half = {0.5, 0, 0}, rake = {0.5, 0, 1};

static const bat_quantity *find(void *user, const char *name, size_t length)
{
    (void)user;
    if (length == 4 && memcmp(name, "beam", 4) == 0)
        return &beam;
    if (length == 4 && memcmp(name, "half", 4) == 0)
        return &half;
    return length == 4 && memcmp(name, "rake", 4) == 0 ? &rake : NULL;
}

static const char *nearest(void *user, const char *name)
{
    (void)user;
    return bat_edit_distance(name, "beam", 3) < 3 ? "beam" : NULL;
}

static const bat_names names = {1.0, find, NULL, nearest};

/* Lengths are in metres; the dimensions are powers of length and angle. */
static const struct {
    const char *text;
    double value;
    int length, angle;
} values[] = {
    {"=1 + 2 * 3", 7, 0, 0},
    {"=(1 + 2) * 3", 9, 0, 0},
    {"=2^3^2", 512, 0, 0},
    {"=-2^2", -4, 0, 0},
    {"=2^-1", 0.5, 0, 0},
    {"=8 - 3 - 2", 3, 0, 0},
    {"=8 / 4 / 2", 1, 0, 0},
    {"=2 * -3", -6, 0, 0},
    {"=beam/2 + 0.1 m", 1.7, 1, 0},
    {"=beam * half", 1.6, 1, 0},
    {"=beam * beam", 10.24, 2, 0},
    {"=sqrt(beam * beam)", 3.2, 1, 0},
    {"=sqrt(beam^2)", 3.2, 1, 0},
    {"=sin(30 deg)", 0.5, 0, 0},
    {"=cos(pi * 1 rad)", -1, 0, 0},
    {"=tan(45 deg)", 1, 0, 0},
    {"=min(beam, 2 m, 4 m)", 2, 1, 0},
    {"=max(1, 2, 3)", 3, 0, 0},
    {"=abs(-beam)", 3.2, 1, 0},
    {"=beam / 1.6 m", 2, 0, 0},
    {"= 2*(3+(4-1)) ", 12, 0, 0},
    {"=max(min(1, 2), -3)", 1, 0, 0},
    {"=rake + 0.5 rad", 1, 0, 1},
    {"=5' - 6\"", 1.3716, 1, 0},
    {"=- -3", 3, 0, 0},
    {"=beam-1 m", 2.2, 1, 0},
    {"=beam^9 / beam^8", 3.2, 1, 0},
    {"=beam^-2", 0.09765625, -2, 0},
    {"=beam^-9 * beam^9", 1, 0, 0},
    {"=beam^0", 1, 0, 0},
    {"=rake^2", 0.25, 0, 2},
    {"=rake^3 * beam^2", 1.28, 2, 3},
    {"=1 / beam", 0.3125, -1, 0},
    {"=1 / rake / beam", 0.625, -1, -1},
    {"=beam / rake", 6.4, 1, -1},
    {"=rake - 0.25 rad", 0.25, 0, 1},
    {"=sqrt(rake^2)", 0.5, 0, 1},
    {"=sqrt(beam^4 / rake^2)", 20.48, 2, -1},
    {"=sqrt(0)", 0, 0, 0},
    {"=abs(-rake)", 0.5, 0, 1},
    {"=abs(2)", 2, 0, 0},
    {"=cos(60 deg)", 0.5, 0, 0},
    {"=tan(-45 deg)", -1, 0, 0},
    {"=min(rake, 1 rad)", 0.5, 0, 1},
    {"=max(rake, 1 rad)", 1, 0, 1},
    {"=max(beam, 2 m)", 3.2, 1, 0},
    {"=min(3, 2)", 2, 0, 0},
    {"=min(4, 3, 2, 1, 5)", 1, 0, 0},
    {"=max(4, 3, 9, 1, 5)", 9, 0, 0},
    {"=max(1 + 1, 1 * 3) + 1", 4, 0, 0},
    {"=2 * max(1, half) ^ 2", 2, 0, 0},
    {"=2 ^ 0.5 ^ 2", 1.189207115002721, 0, 0},
    {"=7 - 2 * 3 + 1", 2, 0, 0},
    {"=7 / 2 * 3", 10.5, 0, 0},
    {"=-half * 2", -1, 0, 0},
    {"=3 - -half", 3.5, 0, 0},
    {"=pi", 3.141592653589793, 0, 0},
    {"=\t( half\t)", 0.5, 0, 0},
};

TEST(expressions_follow_the_rules_of_arithmetic)
{
    for (int i = 0; i < COUNT(values); i++) {
        bat_quantity q = {0, 9, 9};
        CHECK_OK(bat_quantity_read(values[i].text, &names, NULL, &q));
        CHECK_NEAR(q.value, values[i].value, 8 * DBL_EPSILON * fabs(values[i].value));
        CHECK_INT(q.length, values[i].length);
        CHECK_INT(q.angle, values[i].angle);
    }
}

static const struct {
    const char *text, *says;
} wrong[] = {
    {"=beam + 1", "a length and a number"},
    {"=1 - 30 deg", "a number and an angle"},
    {"=sin(1)", "sin needs an angle"},
    {"=sin(beam)", "not a length"},
    {"=sqrt(beam)", "sqrt of a length"},
    {"=sqrt(-1)", "not a number"},
    {"=2^beam", "exponent"},
    {"=beam^0.5", "whole numbers"},
    {"=min(beam, 1)", "min needs two of a kind"},
    {"=min(1)", "two values or more"},
    {"=abs(1, 2)", "one value"},
    {"=1/0", "divided by 0"},
    {"=baem", "did you mean 'beam'"},
    {"=(1 + 2", "not closed"},
    {"=1 + 2)", "has no '('"},
    {"=1 +", "ends where a value"},
    {"=", "ends where a value"},
    {"=1, 2", "decimal mark"},
    {"=(1, 2)", "decimal mark"},
    {"=sin 3", "'(' is expected"},
    {"=2 beam", "unknown unit"},
    {"=beam beam", "operator is expected"},
    {"=*3", "number is expected"},
    {"=beam + 1", "'+' needs two of a kind, not a length and a number"},
    {"=1 - 30 deg", "'-' needs two of a kind, not a number and an angle"},
    {"=max(rake, beam)", "max needs two of a kind, not an angle and a length"},
    {"=max(1, 2, beam)", "max needs two of a kind, not a number and a length"},
    {"=min(1)", "min takes two values or more, not 1"},
    {"=max(1)", "max takes two values or more, not 1"},
    {"=abs(1, 2)", "abs takes one value, not 2"},
    {"=sin(1 rad, 2 rad, 3 rad)", "sin takes one value, not 3"},
    {"=cos(2)", "cos needs an angle (30 deg, 0.5 rad), not a number"},
    {"=tan(beam)", "tan needs an angle (30 deg, 0.5 rad), not a length"},
    {"=sin(rake * beam)", "sin needs an angle"},
    {"=sin(rake * rake)", "sin needs an angle"},
    {"=sqrt(rake)", "sqrt of an angle has no unit"},
    {"=sqrt(-4)", "sqrt of -4 is not a number"},
    {"=2^rake", "an exponent must be a number without a unit"},
    {"=beam^10", "whole numbers up to 9, not to 10"},
    {"=beam^-10", "whole numbers up to 9, not to -10"},
    {"=rake^1.5", "whole numbers up to 9, not to 1.5"},
    {"=7/0", "7 is divided by 0"},
    {"=xyzzy", "no parameter is named 'xyzzy'"},
    {"=half, 2", "a ',' is allowed only in min( ) and max( ); the decimal mark is '.'"},
    {"=max((1, 2), 3)", "decimal mark"},
    {"=1 + 2 ; 3", "an operator is expected at \"; 3\""},
    {"=max(1, 2", "a '(' is not closed; put an expression with commas in quotes"},
    {"=)", "number is expected"},
    {"=max", "'(' is expected after max"},
};

TEST(wrong_expressions_say_what_was_expected)
{
    for (int i = 0; i < COUNT(wrong); i++) {
        bat_quantity q = {7, 0, 0};
        CHECK_STATUS(bat_quantity_read(wrong[i].text, &names, NULL, &q), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(wrong[i].says);
        CHECK_BITS(q.value, 7);
    }
}

TEST(names_are_shown_up_to_60_letters_and_another_is_offered_when_one_is_near)
{
    char text[90] = "=", shown[120];
    bat_quantity q;
    memset(text + 1, 'q', 70);
    CHECK_STATUS(bat_quantity_read(text, &names, NULL, &q), BATTEN_BAD_FORMAT);
    snprintf(shown, sizeof shown, "named '%.60s'", text + 1);
    CHECK_MESSAGE(shown);
    CHECK(!strstr(batten_message(), "did you mean"));
    CHECK_STATUS(bat_quantity_read("=beem", &names, NULL, &q), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("no parameter is named 'beem'; did you mean 'beam'?");
    static const bat_names none = {1.0, NULL, NULL, NULL};
    CHECK_STATUS(bat_quantity_read("=beam", &none, NULL, &q), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("no parameter is named 'beam'");
}

TEST(N3_what_an_expression_makes_too_large_is_refused)
{
    static const char *const texts[] = {"=1e308*1e308", "=2^1024", "=(-1)^0.5",
                                        "=1e308 + 1e308", "=abs(10^309)"};
    for (int i = 0; i < COUNT(texts); i++) {
        bat_quantity q = {7, 0, 0};
        CHECK_STATUS(bat_quantity_read(texts[i], &names, NULL, &q), BATTEN_OVERFLOW);
        CHECK_BITS(q.value, 7);
    }
    bat_quantity q = {1, 0, 0};
    bool vanished = false;
    CHECK_OK(bat_quantity_read("=0 * 1e-400", &names, &vanished, &q));
    CHECK(vanished && q.value == 0);
}

TEST(S4_deep_expressions_are_refused_at_the_limit)
{
    static const char *const repeats[] = {"(", "-", "sin(", "1^", "max(1,"};
    for (int i = 0; i < COUNT(repeats); i++) {
        const size_t step = strlen(repeats[i]), count = 100000;
        char *text = test_array(step * count + 2, 1);
        text[0] = '=';
        for (size_t k = 0; k < count; k++)
            memcpy(text + 1 + k * step, repeats[i], step);
        bat_quantity q;
        CHECK_STATUS(bat_quantity_read(text, &names, NULL, &q), BATTEN_TOO_LARGE);
    }
}

/* The text `count` times, a value, and what closes it as often. */
static batten_status read_nested(const char *open, const char *close, int count, double *value)
{
    char text[700] = "=";
    bat_quantity q = {0, 0, 0};
    for (int i = 0; i < count; i++)
        strcat(text, open);
    strcat(text, "half");
    for (int i = 0; i < count; i++)
        strcat(text, close);
    const batten_status status = bat_quantity_read(text, &names, NULL, &q);
    *value = q.value;
    return status;
}

/* 64 signs may wait for their values, and 64 values for their signs; a function waits with its parenthesis. */
TEST(S4_expressions_nest_as_deep_as_the_limit_and_no_deeper)
{
    static const struct {
        const char *open, *close;
        int most;
        double value;
    } rows[] = {
        {"(", ")", 64, 0.5}, {"-", "", 64, 0.5}, {"abs(", ")", 32, 0.5}, {"1^", "", 63, 1}};
    for (int i = 0; i < COUNT(rows); i++) {
        double value;
        CHECK_OK(read_nested(rows[i].open, rows[i].close, rows[i].most, &value));
        CHECK_BITS(value, rows[i].value);
        CHECK_STATUS(read_nested(rows[i].open, rows[i].close, rows[i].most + 1, &value),
                     BATTEN_TOO_LARGE);
        CHECK_MESSAGE("the expression nests deeper than the limit, 64");
    }
}

TEST(words_of_expressions_cannot_name_parameters)
{
    static const char *const words[] = {"sin", "cos", "tan", "sqrt", "abs", "min", "max", "pi"};
    static const char *const others[] = {"si", "sine", "p", "pie", "Sin", "PI", "qi", ""};
    for (int i = 0; i < COUNT(words); i++) {
        CHECK(bat_expression_has_word(words[i], strlen(words[i])));
        CHECK(!bat_expression_has_word(others[i], strlen(others[i])));
    }
}

/* All names of a text, with a blank behind each. */
static void list_names(const char *text, char out[100])
{
    const char *name;
    size_t position = 0, length;
    *out = 0;
    while (bat_expression_next_name(text, &position, &name, &length)) {
        strncat(out, name, length);
        strcat(out, " ");
    }
}

TEST(names_of_an_expression_are_found_without_its_units)
{
    static const struct {
        const char *text, *names;
    } rows[] = {
        {"=beam/2 + 0.1 m - sin(rake) * 3in + a1*pi", "beam rake a1 "},
        {"=a", "a "},
        {"=a*b", "a b "},
        {"=2 m*x", "x "},
        {"=2. m - m", "m "},
        {"=1e5*e5", "e5 "},
        {"=3\tm/m_2", "m_2 "},
        {"=5 ft 6 in + ft", "ft "},
        {"=max(a, 2, b)", "a b "},
        {"=1 + 2", ""},
        {"", ""},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char found[100];
        list_names(rows[i].text, found);
        CHECK_TEXT(found, rows[i].names);
    }
}
