#include "exchange/step/text/scan.h"

#include "exchange/reading.h"

static bat_step_scanner scanner_of(const char *text)
{
    return (bat_step_scanner){.data = text,
                              .size = strlen(text),
                              .nesting = 3,
                              .string_bytes = 6,
                              .lower_case = SIZE_MAX,
                              .broken_string = SIZE_MAX,
                              .bare_point = SIZE_MAX};
}

/* What stands behind a list: the scan ends there, and so does going over it again. */
TEST(a_list_ends_where_its_last_bracket_does)
{
    static const char *const lists[] = {"()",
                                        "( )",
                                        "(1)",
                                        "(1,-2,+3.5,4.E5,.5,6.E-7,8.E+9)",
                                        "($,*,#12,.T.,.U_1.)",
                                        "('it''s',\"0AF9\",'')",
                                        "((1,(2)),())",
                                        "(LENGTH_MEASURE(1.),A(B('x')))",
                                        "( 1 /* , ) */ , /**/ 2 )",
                                        "(/***/1\n,\t2\r)",
                                        "(')','(',',')"};
    for (int i = 0; i < COUNT(lists); i++) {
        char text[200];
        size_t at = 0;
        snprintf(text, sizeof text, "%s;1)", lists[i]);
        bat_step_scanner scanner = scanner_of(text);
        CHECK(bat_step_scan_list(&scanner, &at));
        CHECK(scanner.problem == NULL);
        CHECK_INT((long long)at, (long long)strlen(lists[i]));
        CHECK_INT((long long)bat_step_item_end(text, strlen(text), 0), (long long)at);
    }
}

TEST(what_is_wrong_in_a_list_is_named_at_its_place)
{
    static const struct {
        const char *text, *problem;
        size_t at;
    } cases[] = {{"1", "expected '(' after a keyword", 0},
                 {"", "expected a value here", 0},
                 {"(", "expected a value here", 1},
                 {"(1", "expected ',' or ')' here", 2},
                 {"(1 2)", "expected ',' or ')' here", 3},
                 {"(1,)", "expected a value here", 3},
                 {"(,1)", "expected a value here", 1},
                 {"(;)", "expected a value here", 1},
                 {"(A)", "expected '(' after a keyword", 2},
                 {"(A 1)", "expected '(' after a keyword", 3},
                 {"((((1))))", "lists are nested deeper than the limit", 3},
                 {"(#)", "'#' has no number", 1},
                 {"(#18446744073709551616)", "the number after '#' is too large", 1},
                 {"('abc", "a string has no end", 1},
                 {"('abc''", "a string has no end", 1},
                 {"('1234567')", "a string is longer than the limit", 1},
                 {"(.T)", "a word between dots has no second dot", 1},
                 {"(..)", "a word between dots has no second dot", 1},
                 {"(.T", "a word between dots has no second dot", 1},
                 {"(\"0G\")", "a binary value has characters other than 0-9 and A-F", 1},
                 {"(\"0", "a binary value has characters other than 0-9 and A-F", 1},
                 {"(\"1234567\")", "a binary value is longer than the limit", 1},
                 {"(+)", "a sign has no number", 1},
                 {"(-.)", "a sign has no number", 1},
                 {"(1.E)", "a number has no digits in its exponent", 1},
                 {"(1.E+)", "a number has no digits in its exponent", 1},
                 {"(1/*", "a comment has no end", 2},
                 {"(/*/1)", "a comment has no end", 1},
                 {"(1,/* *", "a comment has no end", 3}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_step_scanner scanner = scanner_of(cases[i].text);
        size_t at = 0;
        CHECK(!bat_step_scan_list(&scanner, &at));
        CHECK_TEXT(scanner.problem, cases[i].problem);
        CHECK_INT((long long)scanner.at, (long long)cases[i].at);
        CHECK(scanner.far >= scanner.at && scanner.far <= scanner.size);
    }
}

TEST(strings_and_nesting_are_allowed_up_to_their_limits)
{
    static const char *const lists[] = {"('123456')", "(\"123456\")", "(((1)))", "('12''45')"};
    for (int i = 0; i < COUNT(lists); i++) {
        bat_step_scanner scanner = scanner_of(lists[i]);
        size_t at = 0;
        CHECK(bat_step_scan_list(&scanner, &at));
    }
}

TEST(the_first_of_each_leniency_is_remembered)
{
    bat_step_scanner scanner = scanner_of("(A(1.),b(.5),c(-.5),'x\ny','z\rw',D(2))");
    size_t at = 0;
    CHECK(bat_step_scan_list(&scanner, &at));
    CHECK_INT((long long)scanner.lower_case, 7);
    CHECK_INT((long long)scanner.bare_point, 9);
    CHECK_INT((long long)scanner.broken_string, 20);
    CHECK_INT((long long)scanner.string, 26);
    scanner = scanner_of("(A(1.,0.5,1.5),'x')");
    at = 0;
    CHECK(bat_step_scan_list(&scanner, &at));
    CHECK(scanner.lower_case == SIZE_MAX && scanner.bare_point == SIZE_MAX &&
          scanner.broken_string == SIZE_MAX && scanner.string == 0);
}

TEST(ids_go_up_to_the_largest_of_64_bits)
{
    bat_step_scanner scanner = scanner_of("#18446744073709551609=");
    uint64_t id = 0;
    size_t at = 0;
    CHECK(bat_step_scan_id(&scanner, &at, &id));
    CHECK(id == 18446744073709551609u && at == 21);
    scanner = scanner_of("#007 ");
    at = 0;
    CHECK(bat_step_scan_id(&scanner, &at, &id));
    CHECK(id == 7 && at == 4);
}

TEST(a_keyword_begins_with_a_letter_and_may_have_digits_and_hyphens)
{
    static const struct {
        const char *text;
        int length;
    } cases[] = {{"ISO-10303-21;", 12},
                 {"A_1(", 3},
                 {"!USER(", 5},
                 {"1A(", 0},
                 {"-A", 0},
                 {"(", 0},
                 {"", 0}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_step_scanner scanner = scanner_of(cases[i].text);
        size_t at = 0;
        CHECK_INT(bat_step_scan_keyword(&scanner, &at), cases[i].length > 0);
        CHECK_INT((long long)at, cases[i].length);
        if (cases[i].length == 0)
            CHECK_TEXT(scanner.problem, "expected a keyword here");
    }
}

TEST(one_byte_is_found_after_blanks_or_missed_where_it_should_be)
{
    bat_step_scanner scanner = scanner_of(" /* = */ = ;");
    size_t at = 0;
    CHECK(bat_step_scan_byte(&scanner, &at, '=', "no ="));
    CHECK_INT((long long)at, 10);
    CHECK(!bat_step_scan_byte(&scanner, &at, '=', "no ="));
    CHECK_TEXT(scanner.problem, "no =");
    CHECK_INT((long long)scanner.at, 11);
}

TEST(blanks_are_six_characters_and_comments)
{
    static const struct {
        const char *text;
        int end;
        bool is_unfinished;
    } cases[] = {{" \t\n\v\f\rx", 6, false},
                 {"/**/x", 4, false},
                 {"/***/x", 5, false},
                 {"/* * / */ /**/ x", 15, false},
                 {"/x", 0, false},
                 {"/", 0, false},
                 {" /*", 3, true},
                 {"/*/", 3, true},
                 {"/* *", 4, true},
                 {"/**", 3, true},
                 {"  ", 2, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        size_t unfinished = SIZE_MAX;
        CHECK_INT(
            (long long)bat_step_blank(cases[i].text, strlen(cases[i].text), 0, &unfinished),
            cases[i].end);
        CHECK_INT(unfinished != SIZE_MAX, cases[i].is_unfinished);
        if (cases[i].is_unfinished)
            CHECK_INT((long long)unfinished, cases[i].text[0] == ' ');
        CHECK_INT((long long)bat_step_blank(cases[i].text, strlen(cases[i].text), 0, NULL),
                  cases[i].end);
    }
}

TEST(a_token_ends_where_its_kind_does)
{
    static const struct {
        const char *text;
        int length;
    } cases[] = {{"'a''b'c", 6}, {"'a", 2},   {"''", 2},   {"'a''", 4}, {"\"0F\"1", 4},
                 {"\"0", 2},     {".T.,", 3}, {".T", 2},   {".5,", 2},  {".", 1},
                 {"$,", 1},      {"*,", 1},   {"(1", 1},   {")1", 1},   {",1", 1},
                 {"1.5E-3)", 6}, {"-2 ", 2},  {"#12,", 3}, {"A_B(", 3}, {"1.E+5/", 5},
                 {"\"0F\"", 4},  {".T.", 3},  {"'a'", 3},  {"\"", 1},   {"", 0}};
    for (int i = 0; i < COUNT(cases); i++)
        CHECK_INT((long long)bat_step_token_end(cases[i].text, strlen(cases[i].text), 0),
                  cases[i].length);
}

TEST(an_item_ends_behind_its_brackets_or_its_token)
{
    static const struct {
        const char *text;
        int length;
    } cases[] = {{"1,2)", 1},       {"(1,2),3", 5}, {"A (1) ,", 5},
                 {"A(B(1),2),", 9}, {"'(',", 3},    {"((),(1)) ", 8},
                 {"(1", 2},         {"A(1", 3},     {".T. ,", 3}};
    for (int i = 0; i < COUNT(cases); i++)
        CHECK_INT((long long)bat_step_item_end(cases[i].text, strlen(cases[i].text), 0),
                  cases[i].length);
}
