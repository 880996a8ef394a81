#define _XOPEN_SOURCE 700
#include "base/base.h"
#include <batten/text.h>

#include "support/test.h"
#include <locale.h>

static void check_text(batten_text *text, const char *expected)
{
    char *bytes = NULL;
    size_t length = 0;
    CHECK_OK(batten_text_take(text, &bytes, &length));
    CHECK_TEXT(bytes, expected);
    CHECK_INT(length, strlen(expected));
    batten_release(bytes);
}

static batten_status greet(char **bytes)
{
    batten_text text = BATTEN_TEXT;
    batten_text_add(&text, "%s %d", "frame", 12);
    batten_text_bytes(&text, ": ", 2);
    batten_text_number(&text, 0.1);
    return batten_text_take(&text, bytes, NULL);
}

TEST(a_text_grows_by_its_parts)
{
    char *bytes = NULL;
    CHECK_OK(greet(&bytes));
    CHECK_TEXT(bytes, "frame 12: 0.1");
    batten_release(bytes);
}

static batten_status repeat(int count, char **bytes)
{
    batten_text text = BATTEN_TEXT;
    for (int i = 0; i < count; i++)
        batten_text_add(&text, "%0*d", count, i);
    return batten_text_take(&text, bytes, NULL);
}

TEST(parts_may_be_long)
{
    char *bytes = NULL;
    CHECK_OK(repeat(300, &bytes));
    CHECK_INT(strlen(bytes), 90000);
    CHECK_CONTAINS(bytes + 300 * 299, "000299");
    batten_release(bytes);
}

static batten_status nothing(char **bytes)
{
    batten_text text = BATTEN_TEXT;
    return batten_text_take(&text, bytes, NULL);
}

TEST(a_text_of_nothing_is_an_empty_string)
{
    char *bytes = NULL;
    CHECK_OK(nothing(&bytes));
    CHECK_TEXT(bytes, "");
    batten_release(bytes);
    batten_text text = BATTEN_TEXT;
    batten_text_free(&text);
}

TEST(a_text_without_memory_says_so_at_its_end)
{
    batten_text text = BATTEN_TEXT;
    text.failed = true;
    batten_text_add(&text, "more");
    char *bytes = NULL;
    CHECK_STATUS(batten_text_take(&text, &bytes, NULL), BATTEN_OUT_OF_MEMORY);
    CHECK(bytes == NULL && !text.failed);
    text.failed = true;
    char format[] = "%0500d";
    batten_text_add(&text, "%0500d", 1);
    CHECK(format[0] && text.length == 0);
    batten_text_free(&text);
}

static batten_status json(const char *value, char **bytes)
{
    batten_text text = BATTEN_TEXT;
    batten_text_json(&text, value);
    return batten_text_take(&text, bytes, NULL);
}

TEST(json_strings_are_escaped_and_always_utf8)
{
    static const struct {
        const char *value, *json;
    } cases[] = {
        {"", "\"\""},
        {"a\"b\\c", "\"a\\\"b\\\\c\""},
        {"\n\r\t\b\f\x01\x7f", "\"\\n\\r\\t\\b\\f\\u0001\\u007f\""},
        {"/'<", "\"/'<\""},
        {"d\xc3\xa9riv\xc3\xa9", "\"d\xc3\xa9riv\xc3\xa9\""},
        {"\xe2\x82\xac\xf0\x9f\x9b\xb5", "\"\xe2\x82\xac\xf0\x9f\x9b\xb5\""},
        {"\xe9t\xe9", "\"\xef\xbf\xbdt\xef\xbf\xbd\""}, /* Latin-1 */
        {"\xc3", "\"\xef\xbf\xbd\""},                   /* cut */
        {"\x80", "\"\xef\xbf\xbd\""},                   /* no beginning */
        {"\xc0\xaf", "\"\xef\xbf\xbd\xef\xbf\xbd\""},   /* '/' too long */
        {"\xe0\x80\xaf", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""},
        {"\xf0\x80\x80\xaf", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""},
        {"\xed\xa0\x80", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""}, /* half a pair */
        {"\xf4\x90\x80\x80", "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\""},
        {"\xf5", "\"\xef\xbf\xbd\""},
        {"\xed\x9f\xbf\xe0\xa0\x80\xf4\x8f\xbf\xbf\xf0\x90\x80\x80",
         "\"\xed\x9f\xbf\xe0\xa0\x80\xf4\x8f\xbf\xbf\xf0\x90\x80\x80\""},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char *bytes = NULL;
        CHECK_OK(json(cases[i].value, &bytes));
        CHECK_TEXT(bytes, cases[i].json);
        batten_release(bytes);
    }
}

TEST(bytes_are_shown_so_that_they_fit_a_message)
{
    char shown[BAT_SHOWN_SIZE], whole[1000];
    CHECK_TEXT(bat_shown("frame 12", 8, shown), "frame 12");
    CHECK_TEXT(bat_shown("a\n\\\x7f\xe9\0", 6, shown), "a\\x0a\\x5c\\x7f\\xe9\\x00");
    memset(whole, 'x', sizeof whole);
    CHECK_INT(strlen(bat_shown(whole, sizeof whole, shown)), BAT_SHOWN_SIZE - 4);
    CHECK_CONTAINS(shown, "xxx...");
    memset(whole, '\n', sizeof whole);
    CHECK(strlen(bat_shown(whole, sizeof whole, shown)) < BAT_SHOWN_SIZE);
}

static void check_german(char *said, size_t size)
{
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        SKIP("the locale de_DE.UTF-8 is not installed");
    bat_fail(BATTEN_BAD_KNOTS, "knot 3 is %g", 1.5);
    snprintf(said, size, "%s", batten_message());
}

TEST(F5_messages_and_texts_have_points_in_german)
{
    char said[100];
    check_german(said, sizeof said);
    batten_text text = BATTEN_TEXT;
    batten_text_add(&text, "%.2f", 2.25);
    setlocale(LC_ALL, "C");
    CHECK_TEXT(said, "knot 3 is 1.5");
    if (!text.failed)
        check_text(&text, "2.25");
    batten_text_free(&text);
}

TEST(bytes_may_come_before_what_is_there)
{
    batten_text text = BATTEN_TEXT;
    bat_text_insert(&text, "b", 1);
    bat_text_insert(&text, "", 0);
    bat_text_insert(&text, "a", 1);
    bat_text_reserve(&text, 1000);
    batten_text_bytes(&text, "", 0);
    batten_text_add(&text, "%d", 3);
    if (!text.failed)
        CHECK_TEXT(text.bytes, "ab3");
    CHECK(text.failed || text.capacity >= 1000);
    batten_text_free(&text);
}

TEST(F8_letters_are_shown_and_other_bytes_escaped)
{
    static const struct {
        const char *bytes, *shown;
    } cases[] = {{"a b", "a b"},
                 {"H\xc3\xbclle \xe8\x88\xb9", "H\xc3\xbclle \xe8\x88\xb9"},
                 {"H\xfclle", "H\\xfclle"},
                 {"\xc3", "\\xc3"},
                 {"\xc2\x85\x1b[0m\n", "\\xc2\\x85\\x1b[0m\\x0a"},
                 {"\xed\xa0\x80\\", "\\xed\\xa0\\x80\\x5c"}};
    char buffer[BAT_SHOWN_SIZE];
    for (int i = 0; i < COUNT(cases); i++)
        CHECK_TEXT(bat_shown(cases[i].bytes, strlen(cases[i].bytes), buffer), cases[i].shown);
    CHECK_TEXT(bat_shown("\xc3\xbc", 1, buffer), "\\xc3");
}

TEST(a_text_is_printed_into_a_buffer_as_snprintf_does)
{
    char buffer[8];
    CHECK_INT(batten_text_print(buffer, sizeof buffer, "%g|%s", 2.5, "ab"), 6);
    CHECK_TEXT(buffer, "2.5|ab");
    CHECK_INT(batten_text_print(buffer, 4, "%.3f", 1.25), 5);
    CHECK_TEXT(buffer, "1.2");
}
