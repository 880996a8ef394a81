#include "exchange/csv/separated.h"

#include "exchange/reading.h"

/* Read the one row of a text and check its fields, given with '|' between them. */
static void check_row(const char *text, char separator, const char *expected)
{
    bat_input input;
    bat_separated table;
    bool more = false;
    char joined[200] = "";
    CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, &input));
    bat_separated_begin(&table, &input);
    batten_status status = bat_separated_next(&table, &more);
    for (int k = 0; status == BATTEN_OK && k < table.count; k++) {
        strcat(joined, k ? "|" : "");
        strcat(joined, table.fields[k].text);
    }
    const char found = table.separator;
    bat_separated_end(&table);
    if (status == BATTEN_OUT_OF_MEMORY)
        return;
    CHECK_OK(status);
    CHECK(more);
    CHECK_TEXT(joined, expected);
    CHECK_INT(found, separator);
}

TEST(a_row_is_cut_at_its_separators)
{
    const struct {
        const char *text;
        char separator;
        const char *fields;
    } cases[] = {
        {"1,2,3", ',', "1|2|3"},
        {" 1 , 2 ,\t3 ", ',', "1|2|3"},
        {"1,5;2,7", ';', "1,5|2,7"},
        {"a\tb\t\tc", '\t', "a|b||c"},
        {"\ta\tb", '\t', "|a|b"},
        {"  1.5   -2\v3  ", ' ', "1.5|-2|3"},
        {"one", ' ', "one"},
        {",,", ',', "||"},
        {"1,", ',', "1|"},
        {"\"a,b\",c", ',', "a,b|c"},
        {"\"say \"\"hi\"\"\" , \" x \"", ',', "say \"hi\"| x "},
        {"\"a b\" c", ' ', "a b|c"},
        {"28\",x", ',', "28\"|x"},
        {"# note\n\n\"# note, too\",,\n   \n7;8\n", ';', "7|8"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_row(cases[i].text, cases[i].separator, cases[i].fields);
}

TEST(a_quote_that_is_not_closed_is_refused)
{
    check_refused("x,y\n\"1,2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: the quote in column 1 is not closed");
    check_refused("x,y\n\"1\"2,2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: column 4: text after a closing quote");
}

TEST(N3_numbers_are_read_as_decimals_or_refused)
{
    const struct {
        const char *text;
        double value;
    } good[] = {{".5", 0.5},        {"5.", 5},     {"+1", 1},
                {"-2.5e-1", -0.25}, {"1E3", 1000}, {"0.1", 0.1}};
    const char *const bad[] = {"nan", "inf", "-inf", "0x1p3", "1d5",   "1.D+3",
                               "--1", "1e",  ".",    "1e400", "1_000", "1'000"};
    char text[64];
    for (int i = 0; i < COUNT(good); i++) {
        snprintf(text, sizeof text, "%s 2\n", good[i].text);
        batten_model *model = read_noting(text, BATTEN_FORMAT_POINTS, "");
        CHECK_BITS(batten_model_object(model, 0)->points[0], good[i].value);
        batten_model_unref(model);
    }
    for (int i = 0; i < COUNT(bad); i++) {
        snprintf(text, sizeof text, "3 2\n4 %s\n", bad[i]);
        check_refused(text, BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT, "t:2: column 3: '");
    }
}

TEST(N3_a_number_too_small_is_0_with_a_note)
{
    batten_model *model = read_noting("1e-400 -1e-999\n", BATTEN_FORMAT_POINTS, "too small");
    CHECK_BITS(batten_model_object(model, 0)->points[0], 0.0);
    batten_model_unref(model);
}

TEST(N3_400_digits_are_rounded_correctly)
{
    char text[900] = "0.";
    for (int i = 0; i < 400; i++)
        strcat(text, "3");
    strcat(text, " 1");
    for (int i = 0; i < 300; i++)
        strcat(text, "0");
    strcat(text, "\n");
    batten_model *model = read_noting(text, BATTEN_FORMAT_POINTS, "");
    CHECK_BITS(batten_model_object(model, 0)->points[0], 1.0 / 3);
    CHECK_BITS(batten_model_object(model, 0)->points[1], 1e300);
    batten_model_unref(model);
}

TEST(F6_a_decimal_comma_is_named_with_its_line_and_column)
{
    check_refused("x;y\n1;2\n1,5;2,7\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:3: column 1: '1,5' has a comma; a decimal mark must be a point");
    check_refused("1.5\t2,7\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT, "t:1: column");
    check_refused("1.234,5;2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "'1.234,5' has a comma");
    check_refused("1;2\n1,234.5;2\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: column 1: '1,234.5' has a comma");
    check_refused("1 2\n1 234 5\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: 3 columns where the first row has 2");
}

TEST(F6_ragged_rows_are_refused_with_their_line)
{
    check_refused("x,y\n1,2\n3\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:3: 1 column where the first row has 2");
    check_refused("1 2\n3 4 5\n", BATTEN_FORMAT_POINTS, BATTEN_BAD_FORMAT,
                  "t:2: 3 columns where the first row has 2");
    batten_model_unref(read_noting("x,y,,\n1,2,,\n3,4\n", BATTEN_FORMAT_POINTS, ""));
}

TEST(F3_line_ends_do_not_matter)
{
    const char *const texts[] = {
        "1 2\n3 4\n5 6\n",
        "1 2\r\n3 4\r\n5 6\r\n",
        "1 2\r3 4\r5 6\r",
        "1 2\r\n3 4\n5 6\r",
        "1 2\n3 4\n5 6\n\n \n",
        "1 2\n3 4\n5 6\n\x1a",
        ("\xef\xbb\xbf"
         "1 2\n3 4\n5 6\n"),
    };
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_noting(texts[i], BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->point_count, 3);
        CHECK_BITS(object->points[7], 6.0);
        batten_model_unref(model);
    }
    batten_model_unref(
        read_noting("1 2\n3 4\n5 6", BATTEN_FORMAT_AUTO, "the last line has no end"));
}
