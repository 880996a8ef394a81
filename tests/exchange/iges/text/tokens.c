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

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

static const bat_iges_delimiters usual = {',', ';'};

static void check_value(const bat_iges_parameters *parameters, int at, double value, int whole)
{
    const double *in_place = NULL;
    double real = -1, reals[1] = {-1};
    int integer = -1;
    CHECK_INT((long long)bat_iges_count_of(parameters), 5);
    CHECK_OK(bat_iges_real(parameters, (size_t)at, &real));
    CHECK_BITS(real, value);
    CHECK_OK(bat_iges_reals(parameters, (size_t)at, 1, reals));
    CHECK_BITS(reals[0], value);
    CHECK_OK(bat_iges_reals_in_place(parameters, (size_t)at, 1, &in_place));
    CHECK_BITS(*in_place, value);
    if (whole >= 0 || value == whole) {
        CHECK_OK(bat_iges_integer(parameters, (size_t)at, &integer));
        CHECK_INT(integer, whole);
    } else {
        CHECK_STATUS(bat_iges_integer(parameters, (size_t)at, &integer), BATTEN_BAD_FORMAT);
    }
}

/* The second of two records of a file, behind one with nothing but blanks. */
static void check_in_place(bat_input *input, const char *text, int at, double value, int whole)
{
    enum { STRIDE = 81 };
    char records[2 * STRIDE + 1];
    bat_iges_parameters parameters;
    size_t next = 0;
    bool done = false;
    snprintf(records, sizeof records, "%-81s%-64sX,;.-1 9;       1", "", text);
    bat_iges_parameters_begin(&parameters);
    CHECK_OK(bat_iges_tokenise_in_place(input, usual, &parameters, records, STRIDE, 2, &next,
                                        &done));
    if (!done) { /* a number with a D, or one that is none in place: the record goes to the text */
        CHECK_INT((long long)parameters.in_place, BAT_IGES_BLOCK);
        CHECK_OK(bat_list_append(input, &parameters.text, records + STRIDE, BAT_IGES_BLOCK));
        CHECK_OK(bat_iges_tokenise(input, usual, &parameters, &next, &done));
    }
    CHECK(done);
    CHECK(next >= BAT_IGES_BLOCK + strlen(text) && next <= 2 * BAT_IGES_BLOCK);
    check_value(&parameters, at, value, whole);
    bat_iges_parameters_end(&parameters);
}

static void check_number(const char *text, int at, double value, int whole)
{
    batten_read_options options = batten_read_defaults();
    bat_input input;
    bat_iges_parameters parameters;
    const size_t size = strlen(text);
    size_t next = 0;
    bool done = false;
    CHECK_OK(bat_input_begin(text, size, &options, NULL, NULL, &input));
    bat_iges_parameters_begin(&parameters);
    CHECK_OK(bat_list_append(&input, &parameters.text, text, size));
    CHECK_OK(bat_iges_tokenise(&input, usual, &parameters, &next, &done));
    CHECK(done && next == size);
    check_value(&parameters, at, value, whole);
    bat_iges_parameters_end(&parameters);
    if (size <= BAT_IGES_BLOCK)
        check_in_place(&input, text, at, value, whole);
}
TEST(a_number_is_the_same_wherever_it_stands_and_however_it_is_asked_for)
{
    only_once();
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
        CHECK_OK(bat_list_append(&input, &parameters.text, text, strlen(text)));
        CHECK_OK(bat_iges_tokenise(&input, usual, &parameters, &next, &done));
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

/* Records of 64 columns, as they are read in place: what is read of them, and what is left to the text. */
static const struct {
    const char *records[3];
    int tokens;      /* read in place */
    size_t in_place; /* columns of the records that were read whole */
    size_t next;
    bool done;
} rows[] = {
    {{"1,2,3;", "4,", "5,"}, 3, 64, 64, true},
    {{"1,2,3", "4,", "5,"}, 2, 0, 4, false},
    {{"1,2,3, ", "4,", "  5 ,"}, 4, 128, 130, false},
    {{"1,2,3,", "3Habc,", "5,"}, 3, 64, 64, false},
    {{"1,2.5E3,", "-1.5 , 7;", "5,"}, 2, 64, 64, false},
    {{"1,2.5E3,", "   -1.5,x,", "5,"}, 3, 64, 64 + 8, false},
    {{"1,,", "   ,", ";"}, 4, 192, 192, true},
    {{"1.,", "2.,", "3.,"}, 3, 192, 192, false},
};

TEST(records_are_read_in_place_up_to_the_first_token_that_is_no_whole_number_in_one)
{
    only_once();
    for (int i = 0; i < COUNT(rows); i++) {
        char records[3 * 81 + 1];
        bat_input input;
        bat_iges_parameters parameters;
        size_t next = 0;
        bool done = false;
        for (int k = 0; k < 3; k++)
            snprintf(records + 81 * k, 82, "%-64s%17s", rows[i].records[k], "1P      1\n");
        CHECK_OK(bat_input_begin(records, 3 * 81, NULL, NULL, NULL, &input));
        bat_iges_parameters_begin(&parameters);
        CHECK_OK(bat_iges_tokenise_in_place(&input, usual, &parameters, records, 81, 3, &next,
                                            &done));
        CHECK_INT((long long)bat_iges_count_of(&parameters), rows[i].tokens);
        CHECK_INT((long long)parameters.in_place, (long long)rows[i].in_place);
        CHECK_INT((long long)next, (long long)rows[i].next);
        CHECK_INT(done, rows[i].done);
        bat_iges_parameters_end(&parameters);
    }
}

TEST(the_text_of_a_parameter_is_where_it_stood)
{
    only_once();
    static const char *const texts[] = {"110", "1.5", "", "-2E1", "7Hx,y;z w", "abc"};
    static const char record[] = "110,1.5 ,,-2E1,";
    char records[82];
    bat_input input;
    bat_iges_parameters parameters;
    size_t next = 0;
    bool done = false;
    snprintf(records, sizeof records, "%-81s", "110,1.5,,-2E1,");
    CHECK_OK(bat_input_begin(record, sizeof record - 1, NULL, NULL, NULL, &input));
    bat_iges_parameters_begin(&parameters);
    CHECK_OK(
        bat_iges_tokenise_in_place(&input, usual, &parameters, records, 81, 1, &next, &done));
    CHECK(!done && next == 64);
    CHECK_OK(bat_list_append(&input, &parameters.text, "7Hx,y;z w, abc ;", 16));
    CHECK_OK(bat_iges_tokenise(&input, usual, &parameters, &next, &done));
    CHECK(done && next == 64 + 16);
    CHECK_INT((long long)bat_iges_count_of(&parameters), COUNT(texts));
    CHECK_INT((long long)parameters.odd, 2);
    for (int i = 0; i < COUNT(texts) + 1; i++) {
        bool is_string = i != 4;
        const char *due = i == 4 ? "x,y;z w" : i < COUNT(texts) ? texts[i] : "";
        const bat_span text = bat_iges_text(&parameters, (size_t)i, &is_string);
        CHECK_INT((long long)text.length, (long long)strlen(due));
        CHECK(memcmp(text.bytes, due, text.length) == 0);
        CHECK_INT(is_string, i == 4);
    }
    bat_iges_parameters_end(&parameters);
}

/* The number of the last token that is 0 for being too small: in place, and in the text. */
TEST(a_number_too_small_for_a_double_is_remembered_by_its_place)
{
    only_once();
    static const struct {
        const char *text;
        size_t vanished;
    } cases[] = {{"110,1.,0.,0E9;", 0}, {"110,1E-999,2.;", 1}, {"110,1E-999,2.,-3D-999;", 3}};
    for (int i = 0; i < 2 * COUNT(cases); i++) {
        const char *text = cases[i / 2].text;
        char record[82];
        bat_input input;
        bat_iges_parameters parameters;
        size_t next = 0;
        bool done = false;
        snprintf(record, sizeof record, "%-81s", text);
        CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, &input));
        bat_iges_parameters_begin(&parameters);
        if (i % 2)
            CHECK_OK(bat_iges_tokenise_in_place(&input, usual, &parameters, record, 81, 1,
                                                &next, &done));
        if (!done) {
            CHECK_OK(bat_list_append(&input, &parameters.text, record, 64));
            CHECK_OK(bat_iges_tokenise(&input, usual, &parameters, &next, &done));
        }
        CHECK_INT((long long)parameters.vanished, (long long)cases[i / 2].vanished);
        bat_iges_parameters_end(&parameters);
    }
}
