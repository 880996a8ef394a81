/* Keywords in either case, whole and by their ends. */
#include "exchange/step/parsing.h"

static bat_step_record record_of(const char *keyword)
{
    return (bat_step_record){.keyword = keyword, .keyword_length = (uint32_t)strlen(keyword)};
}

TEST(a_keyword_is_the_same_in_either_case_and_in_every_letter)
{
    static const struct {
        const char *keyword;
        bool is, ends;
    } cases[] = {{"PLANE", true, true},    {"plane", true, true},     {"PlAnE", true, true},
                 {"QLANE", false, false},  {"PLANF", false, false},   {"PLAN", false, false},
                 {"PLANES", false, false}, {"A_PLANE", false, true},  {"a_plane", false, true},
                 {"LANE", false, false},   {"A_PLANF", false, false}, {"P[ANE", false, false},
                 {"P`ANE", false, false},  {"", false, false}};
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_step_record record = record_of(cases[i].keyword);
        CHECK(bat_step_is_keyword(&record, "PLANE") == cases[i].is);
        CHECK(bat_step_keyword_ends(&record, "PLANE") == cases[i].ends);
    }
    CHECK(bat_step_same_word("azAZ09_-", "AZAZ09_-", 8));
    CHECK(!bat_step_same_word("{", "[", 1) && !bat_step_same_word("@", "`", 1));
}

TEST(a_keyword_is_shown_in_upper_case_and_cut_to_79_letters)
{
    char keyword[101], shown[BAT_STEP_KEYWORD_SIZE];
    memset(keyword, 'a', 100);
    for (int length = 78; length <= 81; length++) {
        const bat_step_record record = {.keyword = keyword, .keyword_length = (uint32_t)length};
        CHECK(bat_step_upper_keyword(&record, shown) == shown);
        CHECK_INT((long long)strlen(shown), length < 79 ? length : 79);
        CHECK_INT((long long)strspn(shown, "A"), (long long)strlen(shown));
    }
}

/* Of a complex instance the last with B_SPLINE in it names it. */
TEST(an_instance_is_called_by_its_last_spline_or_its_first_record)
{
    static const struct {
        const char *data, *keyword;
    } cases[] = {
        {"#1=circle('');", "CIRCLE"},
        {"#1=(A()B()C());", "A"},
        {"#1=(C()B()A());", "C"},
        {"#1=(A()B_SPLINE_CURVE()C());", "B_SPLINE_CURVE"},
        {"#1=(A()b_spline_curve()C());", "B_SPLINE_CURVE"},
        {"#1=(B_SPLINE_CURVE()RATIONAL_B_SPLINE_CURVE()B_SPLINE_CURVE_WITH_KNOTS()Z());",
         "RATIONAL_B_SPLINE_CURVE"},
        {"#1=(B_SPLINE_CURVE_WITH_KNOTS()B_SPLINE_CURVE()A());", "B_SPLINE_CURVE_WITH_KNOTS"},
        {"#1=(B_SPLINE_CURVE()B_SPLINE_CURVE_WITH_KNOTS()A());", "B_SPLINE_CURVE_WITH_KNOTS"},
        {"#1=(A()X_B_SPLIN());", "A"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        step_text_file t = {.notes = NULL};
        char shown[BAT_STEP_KEYWORD_SIZE];
        CHECK_OK(step_begin(&t, step_whole(cases[i].data)));
        CHECK_TEXT(bat_step_keyword(&t.file, step_find(&t, 1), shown), cases[i].keyword);
        step_end(&t);
    }
}

TEST(a_record_of_a_complex_instance_is_found_by_its_keyword_in_either_case)
{
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, step_whole("#1=(A(1)bb(2)CCC(3));")));
    static const char *const keywords[] = {"A", "BB", "CCC"};
    for (int i = 0; i < 3; i++) {
        int value = 0;
        const bat_step_record *record = bat_step_as(&t.file, step_find(&t, 1), keywords[i]);
        CHECK(record != NULL);
        CHECK_OK(bat_step_get_integer(&t.file, record, 0, &value));
        CHECK_INT(value, i + 1);
    }
    CHECK(bat_step_as(&t.file, step_find(&t, 1), "B") == NULL);
    CHECK(bat_step_as(&t.file, step_find(&t, 1), "CCCC") == NULL);
    step_end(&t);
}
