/* Literals: numbers, their units and counts. */
#include "design/text/value.h"

#include "support/test.h"

static const bat_names names = {1.0, NULL, NULL, NULL};

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
