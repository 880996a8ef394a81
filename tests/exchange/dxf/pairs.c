#include "exchange/dxf/pairs.h"

#include "exchange/reading.h"

static bat_dxf_pairs pairs_of(const char *text, bat_input *input)
{
    bat_dxf_pairs pairs;
    CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, input));
    bat_dxf_pairs_begin(&pairs, input, 0, 0);
    return pairs;
}

/* The first entity of a text. */
static bat_dxf_pairs entity_of(const char *text, bat_input *input)
{
    bool more = false;
    bat_dxf_pairs pairs = pairs_of(text, input);
    CHECK_OK(bat_dxf_next(&pairs, &more));
    CHECK(more);
    return pairs;
}

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

TEST(entities_are_the_groups_from_one_code_0_to_the_next)
{
    only_once();
    static const char text[] =
        "999\nfirst\n  0\nLINE\n10\n 1.5 \n999\nwithin\n20\n2\n0\nPOINT\n 10\n7\n0\nEOF\n\n \n";
    static const struct {
        const char *kind;
        int groups, line;
    } due[] = {{"LINE", 3, 4}, {"POINT", 2, 12}, {"EOF", 1, 16}};
    bat_input input;
    bool more = true;
    bat_dxf_pairs pairs = pairs_of(text, &input);
    for (int i = 0; i < COUNT(due); i++) {
        char name[32];
        CHECK_OK(bat_dxf_next(&pairs, &more));
        CHECK(more);
        CHECK_TEXT(bat_dxf_kind(&pairs, name), due[i].kind);
        CHECK(bat_dxf_is(&pairs, due[i].kind) && !bat_dxf_is(&pairs, "LIN") &&
              !bat_dxf_is(&pairs, "LINES"));
        CHECK_INT((long long)pairs.groups.count, due[i].groups);
        CHECK_INT(bat_dxf_find(&pairs, 0)->line, due[i].line);
    }
    CHECK_OK(bat_dxf_next(&pairs, &more));
    CHECK(!more);
    bat_dxf_pairs_end(&pairs);
}

TEST(a_code_is_a_whole_number_from_minus_5_to_1071)
{
    only_once();
    static const struct {
        const char *code;
        bool good;
    } cases[] = {{"-5", true},  {"1071", true}, {"   10", true}, {"10   ", true},
                 {"10.", true}, {"-6", false},  {"1072", false}, {"1.5", false},
                 {"x", false},  {"", false},    {"0010", true},  {"000010", false}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[60];
        bat_input input;
        bool more;
        snprintf(text, sizeof text, "0\nLINE\n%s\n1\n0\nEOF\n", cases[i].code);
        bat_dxf_pairs pairs = pairs_of(text, &input);
        CHECK_INT(bat_dxf_next(&pairs, &more) == BATTEN_OK, cases[i].good);
        if (!cases[i].good) {
            char words[80];
            snprintf(words, sizeof words, "line 3: '%s' is not the code of a group",
                     cases[i].code);
            CHECK_TEXT(batten_message(), words);
        }
        bat_dxf_pairs_end(&pairs);
    }
}

TEST(numbers_points_and_integers_have_a_standard_where_they_are_missing)
{
    only_once();
    bat_input input;
    bat_dxf_pairs pairs = entity_of(
        "0\nX\n10\n1.5\n20\n2\n11\n3\n31\n-4\n70\n-7\n71\n2.5\n40\nx\n41\n1e999\n", &input);
    double real = 9;
    int whole = 9;
    batten_vec3 p;
    CHECK_OK(bat_dxf_get_real(&pairs, 10, 5, &real));
    CHECK_BITS(real, 1.5);
    CHECK_OK(bat_dxf_get_real(&pairs, 12, 5, &real));
    CHECK_BITS(real, 5);
    CHECK_OK(bat_dxf_get_point(&pairs, 10, (batten_vec3){7, 8, 9}, &p));
    CHECK(p.x == 1.5 && p.y == 2 && p.z == 9);
    CHECK_OK(bat_dxf_get_point(&pairs, 11, (batten_vec3){7, 8, 9}, &p));
    CHECK(p.x == 3 && p.y == 8 && p.z == -4);
    CHECK_OK(bat_dxf_get_point(&pairs, 12, (batten_vec3){7, 8, 9}, &p));
    CHECK(p.x == 7 && p.y == 8 && p.z == 9);
    CHECK_OK(bat_dxf_get_integer(&pairs, 70, 5, &whole));
    CHECK_INT(whole, -7);
    CHECK_OK(bat_dxf_get_integer(&pairs, 72, 5, &whole));
    CHECK_INT(whole, 5);
    CHECK_STATUS(bat_dxf_get_integer(&pairs, 71, 5, &whole), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 14: group 71 is '2.5', not a whole number");
    CHECK_STATUS(bat_dxf_get_real(&pairs, 40, 5, &real), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 16: group 40 is 'x', not a number");
    CHECK_STATUS(bat_dxf_get_real(&pairs, 41, 5, &real), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(),
               "line 18: group 41 is '1e999', which is too large for a number");
    CHECK_STATUS(bat_dxf_get_point(&pairs, 40, p, &p), BATTEN_BAD_FORMAT);
    CHECK_STATUS(bat_dxf_get_point(&pairs, 30, p, &p), BATTEN_BAD_FORMAT); /* its y */
    CHECK_STATUS(bat_dxf_get_point(&pairs, 20, p, &p), BATTEN_BAD_FORMAT); /* its z */
    bat_dxf_pairs_end(&pairs);
}

TEST(numbers_of_one_code_come_in_their_order_when_their_count_is_right)
{
    only_once();
    bat_input input;
    bat_dxf_pairs pairs = entity_of("0\nX\n40\n1\n41\n5\n40\n2\n40\n3\n41\ny\n", &input);
    double *values = NULL;
    CHECK_INT((long long)bat_dxf_count(&pairs, 40), 3);
    CHECK_INT((long long)bat_dxf_count(&pairs, 42), 0);
    CHECK_OK(bat_dxf_get_reals(&pairs, 40, 3, &values));
    CHECK(values[0] == 1 && values[1] == 2 && values[2] == 3);
    batten_release(values);
    values = NULL;
    CHECK_STATUS(bat_dxf_get_reals(&pairs, 40, 4, &values), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "group 40 appears 3 times, expected 4");
    CHECK_STATUS(bat_dxf_get_reals(&pairs, 41, 2, &values), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 12: group 41 is 'y', not a number");
    CHECK(values == NULL);
    bat_dxf_pairs_end(&pairs);
}

TEST(texts_have_characters_by_their_codes_and_are_cut_between_characters)
{
    only_once();
    static const struct {
        const char *value, *text;
        size_t size;
    } cases[] = {{"keel", "keel", 32},
                 {"\\U+00fC", "\xc3\xbc", 32},
                 {"a\\U+20AC\\U+0041b",
                  "a\xe2\x82\xac"
                  "Ab",
                  32},
                 {"\\U+12", "\\U+12", 32},
                 {"\\U+00g1x", "\\U+00g1x", 32},
                 {"\\u+00fc", "\\u+00fc", 32},
                 {"\\U+D800", "\\U+D800", 32},
                 {"abcdef", "abc", 4},
                 {"ab\\U+20AC", "ab", 5},
                 {"a\\U+20AC", "a\xe2\x82\xac", 5},
                 {"", "", 4}};
    for (int i = 0; i < COUNT(cases); i++) {
        char text[80], buffer[33];
        bat_input input;
        snprintf(text, sizeof text, "0\nX\n2\n%s\n", cases[i].value);
        bat_dxf_pairs pairs = entity_of(text, &input);
        bat_dxf_get_text(&pairs, 2, cases[i].size, buffer);
        CHECK_TEXT(buffer, cases[i].text);
        bat_dxf_get_text(&pairs, 3, sizeof buffer, buffer);
        CHECK_TEXT(buffer, "");
        bat_dxf_pairs_end(&pairs);
    }
}
