#include "design/text/value.h"
#include "design/text/edit_distance.h"

#include "support/test.h"

#include <batten/design.h>

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

TEST(numbers_with_units_become_design_units)
{
    const double degree = 3.14159265358979323846 / 180;
    const struct {
        const char *text;
        double value;
        int length, angle;
    } rows[] = {
        {"3", 3, 0, 0},
        {"-2.5", -2.5, 0, 0},
        {"+1", 1, 0, 0},
        {".5", 0.5, 0, 0},
        {"5.", 5, 0, 0},
        {"3.2 m", 3.2, 1, 0},
        {"0.1 mm", 1e-4, 1, 0},
        {"3mm", 0.003, 1, 0},
        {"2 in", 0.0508, 1, 0},
        {"5 ft", 1.524, 1, 0},
        {"5 ft 6 in", 1.6764, 1, 0},
        {"5' 6\"", 1.6764, 1, 0},
        {"5'-6\"", 1.6764, 1, 0},
        {"5' 6 1/2\"", 1.6891, 1, 0},
        {"6 1/2 in", 0.1651, 1, 0},
        {"-5' 6\"", -1.6764, 1, 0},
        {"90 deg", 90 * degree, 0, 1},
        {"0.5 rad", 0.5, 0, 1},
        {"1e-3 km", 1, 1, 0},
        {" 7 ", 7, 0, 0},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_quantity q = {0, 9, 9};
        CHECK_OK(bat_quantity_read(rows[i].text, &names, NULL, &q));
        CHECK_NEAR(q.value, rows[i].value, 4 * DBL_EPSILON * fabs(rows[i].value));
        CHECK_INT(q.length, rows[i].length);
        CHECK_INT(q.angle, rows[i].angle);
    }
}

TEST(a_tenth_of_a_millimetre_is_rounded_once)
{
    bat_quantity q;
    CHECK_OK(bat_quantity_read("0.3 mm", &names, NULL, &q));
    CHECK_BITS(q.value, 0.3 / 1000);
}

TEST(N3_numbers_of_other_notations_are_refused)
{
    static const char *const texts[] = {
        "nan", "inf",      "0x1p3", "1d5",   "1.D+3", "--1", "1,5",       "",  "- 1 m", "1 2",
        "m",   "1 1/0 in", "3 xy",  "3 m 2", "five",  "1e",  "5 ft 6 kg", "+", "."};
    for (int i = 0; i < COUNT(texts); i++) {
        bat_quantity q = {7, 0, 0};
        const batten_status status = bat_quantity_read(texts[i], &names, NULL, &q);
        if (status != BATTEN_BAD_FORMAT)
            printf("\"%s\" is taken\n", texts[i]);
        CHECK_INT(status, BATTEN_BAD_FORMAT);
        CHECK_BITS(q.value, 7);
    }
    bat_quantity q;
    CHECK_STATUS(bat_quantity_read("1e400", &names, NULL, &q), BATTEN_OVERFLOW);
    CHECK_STATUS(bat_quantity_read("1e308 km", &names, NULL, &q), BATTEN_OVERFLOW);
    CHECK_STATUS(bat_quantity_read("=1e308*1e308", &names, NULL, &q), BATTEN_OVERFLOW);
}

TEST(N3_what_is_too_small_becomes_0_and_says_so)
{
    bat_quantity q = {1, 0, 0};
    bool vanished = false;
    CHECK_OK(bat_quantity_read("1e-400", &names, &vanished, &q));
    CHECK(vanished && q.value == 0);
    CHECK_OK(bat_quantity_read("0e-400", &names, &vanished, &q));
    CHECK(!vanished);
}

TEST(N4_counts_are_digits_that_fit)
{
    int count = 5;
    CHECK_OK(bat_count_read("2147483647", &count));
    CHECK_INT(count, 2147483647);
    CHECK_STATUS(bat_count_read("2147483648", &count), BATTEN_OVERFLOW);
    CHECK_STATUS(bat_count_read("99999999999999999999", &count), BATTEN_OVERFLOW);
    static const char *const texts[] = {"-1", "1e3", "3.0", "", "three", "+3", "3 m"};
    for (int i = 0; i < COUNT(texts); i++)
        CHECK_STATUS(bat_count_read(texts[i], &count), BATTEN_BAD_FORMAT);
    CHECK_INT(count, 2147483647);
}

TEST(expressions_follow_the_rules_of_arithmetic)
{
    const struct {
        const char *text;
        double value;
        int length, angle;
    } rows[] = {
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
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_quantity q = {0, 9, 9};
        CHECK_OK(bat_quantity_read(rows[i].text, &names, NULL, &q));
        CHECK_NEAR(q.value, rows[i].value, 8 * DBL_EPSILON * fabs(rows[i].value));
        CHECK_INT(q.length, rows[i].length);
        CHECK_INT(q.angle, rows[i].angle);
    }
}

TEST(wrong_expressions_say_what_was_expected)
{
    static const struct {
        const char *text, *says;
    } rows[] = {
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
    };
    for (int i = 0; i < COUNT(rows); i++) {
        bat_quantity q = {7, 0, 0};
        CHECK_STATUS(bat_quantity_read(rows[i].text, &names, NULL, &q), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(rows[i].says);
        CHECK_BITS(q.value, 7);
    }
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

TEST(names_of_an_expression_are_found_without_its_units)
{
    static const char text[] = "=beam/2 + 0.1 m - sin(rake) * 3in + a1*pi";
    static const char *const expected[] = {"beam", "rake", "a1"};
    size_t position = 0, length;
    const char *name;
    for (int i = 0; i < COUNT(expected); i++) {
        CHECK(bat_expression_next_name(text, &position, &name, &length));
        CHECK(length == strlen(expected[i]) && memcmp(name, expected[i], length) == 0);
    }
    CHECK(!bat_expression_next_name(text, &position, &name, &length));
}

TEST(a_ring_of_parameters_offers_no_name_for_itself)
{
    static const char text[] = "batten: 1\nparameters:\n  a: =b\n  b: =a\n"
                               "features:\n  l: {line: [[0, 0], [=a, 1]]}\n";
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(batten_design_parse(text, strlen(text), NULL, notes, &design),
                 BATTEN_BAD_FORMAT);
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK(strstr(batten_notes_at(notes, i)->text, "did you mean 'a'") == NULL);
    batten_notes_free(notes);
}
