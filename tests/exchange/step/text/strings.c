/* Strings with escapes at their very end, and in buffers of every size. */
#include "exchange/step/parsing.h"

/* The string as it comes out of a buffer of that size. */
static void check_decoded(const char *step, size_t size, const char *expected)
{
    step_text_file t = {.notes = NULL};
    char data[200], text[100];
    snprintf(data, sizeof data, "#1=X('%s');", step);
    CHECK_OK(step_begin(&t, step_whole(data)));
    CHECK_OK(
        bat_step_get_string(&t.file, bat_step_first(&t.file, step_find(&t, 1)), 0, size, text));
    CHECK_TEXT(text, expected);
    step_end(&t);
}

TEST(escapes_may_end_a_string_and_what_is_cut_short_is_none)
{
    static const struct {
        const char *step, *text;
    } cases[] = {
        {"\\S\\|", "\xc3\xbc"},
        {"\\S\\", "\\S\\"},
        {"\\X\\FC", "\xc3\xbc"},
        {"\\X\\F", "\\X\\F"},
        {"\\X\\fc", "\xc3\xbc"},
        {"\\PA\\", ""},
        {"\\PAB", "\\PAB"},
        {"\\P", "\\P"},
        {"\\X2\\00E4\\X0\\", "\xc3\xa4"},
        {"\\X2\\00E4", "\xc3\xa4"},
        {"\\X2\\00E4\\X0", "\xc3\xa4\\X0"},
        {"\\X4\\000000E4\\X0\\", "\xc3\xa4"},
        {"\\X4\\00110000\\X0\\", "\xef\xbf\xbd"},
        {"\\X4\\0010FFFF\\X0\\", "\xf4\x8f\xbf\xbf"},
        {"\\X2\\007F\\X0\\", "\x7f"},
        {"\\X2\\0080\\X0\\", "\xc2\x80"},
        {"\\X2\\07FF\\X0\\", "\xdf\xbf"},
        {"\\X2\\0800\\X0\\", "\xe0\xa0\x80"},
        {"\\X2\\FFFF\\X0\\", "\xef\xbf\xbf"},
        {"\\X4\\00010000\\X0\\", "\xf0\x90\x80\x80"},
        {"\\X2\\D800DC00\\X0\\", "\xf0\x90\x80\x80"},
        {"\\X2\\DBFFDFFF\\X0\\", "\xf4\x8f\xbf\xbf"},
        {"\\X2\\D80000E4\\X0\\", "\xef\xbf\xbd\xc3\xa4"},
        {"\\X2\\DC00\\X0\\", "\xef\xbf\xbd"},
        {"\\X2\\D7FF\\X0\\", "\xed\x9f\xbf"},
        {"\\X2\\E000\\X0\\", "\xee\x80\x80"},
        {"a''", "a'"},
        {"\\\\", "\\"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_decoded(cases[i].step, 40, cases[i].text);
}

/* Characters are whole or not there. */
TEST(a_string_is_cut_to_its_buffer_between_characters)
{
    static const struct {
        const char *step;
        size_t size;
        const char *text;
    } cases[] = {
        {"abc", 4, "abc"},
        {"abc", 3, "ab"},
        {"abc", 1, ""},
        {"a\xc3\xa4"
         "b",
         5,
         "a\xc3\xa4"
         "b"},
        {"a\xc3\xa4"
         "b",
         4, "a\xc3\xa4"},
        {"a\xc3\xa4"
         "b",
         3, "a"},
        {"\xe2\x82\xac", 4, "\xe2\x82\xac"},
        {"\xe2\x82\xac", 3, ""},
        {"\xf0\x9f\x98\x80", 5, "\xf0\x9f\x98\x80"},
        {"\xf0\x9f\x98\x80", 4, ""},
        {"\\X2\\00E4\\X0\\b", 3, "\xc3\xa4"},
        {"\\X2\\00E4\\X0\\b", 2, ""},
        {"''b", 2, "'"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_decoded(cases[i].step, cases[i].size, cases[i].text);
}
