/* Parameters told apart: numbers as they are written, left away or with a D, strings, other things. */
#include "exchange/iges/text/parameters.h"

#include "exchange/iges/text.h"

/* The same parameter between others, in the middle and at the end, after any number of blanks that
 * move it over the blocks in which text is looked at. */
static const struct {
    const char *written;
    double value;
    int whole; /* -1: it is none */
} numbers[] = {
    {"", 0, 0},
    {"   ", 0, 0},
    {"7", 7, 7},
    {"-7", -7, -7},
    {"+7", 7, 7},
    {" 7 ", 7, 7},
    {"1.5", 1.5, -1},
    {"-.5", -0.5, -1},
    {"3.", 3, -1},
    {"1.D2", 100, -1},
    {"1.d-1", 0.1, -1},
    {"1E2", 100, -1},
    {"0.1E1", 1, -1},
    {"123456789", 123456789, 123456789},
    {"0.123456789012345678", 0.123456789012345678, -1},
    {"1234567890.25", 1234567890.25, -1},
};

static void check_number(const char *text, int at, double value, int whole)
{
    batten_read_options options = batten_read_defaults();
    bat_input input;
    bat_iges_parameters parameters;
    const double *in_place = NULL;
    double real = -1, reals[1] = {-1};
    int integer = -1;
    const size_t size = strlen(text);
    size_t next = 0;
    bool done = false;
    CHECK_OK(bat_input_begin(text, size, &options, NULL, NULL, &input));
    bat_iges_parameters_begin(&parameters);
    for (size_t i = 0; i < size + BAT_IGES_BEHIND; i++) /* what is behind is looked at, too */
        CHECK_OK(bat_list_add(&input, &parameters.text, i < size ? &text[i] : " "));
    parameters.text.count = size;
    CHECK_OK(
        bat_iges_tokenise(&input, (bat_iges_delimiters){',', ';'}, &parameters, &next, &done));
    CHECK(done && next == size);
    CHECK_INT((long long)bat_iges_count_of(&parameters), 5);
    CHECK_OK(bat_iges_real(&parameters, (size_t)at, &real));
    CHECK_BITS(real, value);
    CHECK_OK(bat_iges_reals(&parameters, (size_t)at, 1, reals));
    CHECK_BITS(reals[0], value);
    CHECK_OK(bat_iges_reals_in_place(&parameters, (size_t)at, 1, &in_place));
    CHECK_BITS(*in_place, value);
    if (whole >= 0 || value == whole) {
        CHECK_OK(bat_iges_integer(&parameters, (size_t)at, &integer));
        CHECK_INT(integer, whole);
    } else {
        CHECK_STATUS(bat_iges_integer(&parameters, (size_t)at, &integer), BATTEN_BAD_FORMAT);
    }
    bat_iges_parameters_end(&parameters);
}

TEST(a_number_is_the_same_wherever_it_stands_and_however_it_is_asked_for)
{
    for (int i = 0; i < COUNT(numbers); i++)
        for (int blanks = 0; blanks < 70; blanks += 1 + blanks / 8) {
            char text[200];
            snprintf(text, sizeof text, "110,%*s1.,%s,2.,3.;", blanks, "", numbers[i].written);
            check_number(text, 2, numbers[i].value, numbers[i].whole);
            snprintf(text, sizeof text, "110,1.,2.,%*s3.,%s;", blanks, "", numbers[i].written);
            check_number(text, 4, numbers[i].value, numbers[i].whole);
        }
}

/* Asked for as a whole number: what is none, or none of a count. */
TEST(what_is_no_count_is_named_with_its_number)
{
    static const struct {
        const char *written, *words; /* NULL: good */
        int value;
    } cases[] = {
        {"2147483647", NULL, 2147483647},
        {"-2147483647", NULL, -2147483647},
        {"2147483648", "parameter 1 is 2.14748e+09, too large for a count or pointer", 0},
        {"-2147483648", "parameter 1 is -2.14748e+09, too large for a count or pointer", 0},
        {"1.5", "parameter 1, '1.5', is not a whole number", 0},
        {"1E2", "parameter 1, '1E2', is not a whole number", 0},
        {"4Hfour", "parameter 1 is not a number but a string", 0},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[80];
        bat_input input;
        bat_iges_parameters parameters;
        size_t next = 0;
        bool done = false;
        int value = 77;
        snprintf(text, sizeof text, "110,%s;", cases[i].written);
        CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, &input));
        bat_iges_parameters_begin(&parameters);
        for (size_t k = 0; k < strlen(text) + BAT_IGES_BEHIND; k++)
            CHECK_OK(bat_list_add(&input, &parameters.text, k < strlen(text) ? &text[k] : " "));
        parameters.text.count = strlen(text);
        CHECK_OK(bat_iges_tokenise(&input, (bat_iges_delimiters){',', ';'}, &parameters, &next,
                                   &done));
        CHECK_STATUS(bat_iges_integer(&parameters, 1, &value),
                     cases[i].words ? BATTEN_BAD_FORMAT : BATTEN_OK);
        CHECK_INT(value, cases[i].words ? 77 : cases[i].value);
        if (cases[i].words)
            CHECK_TEXT(batten_message(), cases[i].words);
        CHECK_OK(bat_iges_integer(&parameters, 2, &value)); /* what is not there is 0 */
        CHECK_INT(value, 0);
        bat_iges_parameters_end(&parameters);
    }
}
