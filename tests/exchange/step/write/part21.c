#include "exchange/step/step.h"

#include "support/test.h"

static void check_string(const char *value, const char *expected)
{
    batten_text text = BATTEN_TEXT;
    bat_step step = {.text = &text};
    bat_step_string(&step, value, "");
    if (!text.failed)
        CHECK_TEXT(text.bytes, expected);
    batten_text_free(&text);
}

TEST(strings_are_escaped)
{
    check_string("", "''");
    check_string("keel", "'keel'");
    check_string("it's \\", "'it''s \\\\'");
    check_string("\xc3\xbc", "'\\X2\\00FC\\X0\\'");
    check_string("\xe2\x82\xac"
                 "1",
                 "'\\X2\\20AC\\X0\\1'");
    check_string("\xf0\x9f\x9a\xa2", "'\\X4\\0001F6A2\\X0\\'");
    check_string("a\nb\x7f", "'a\\X\\0Ab\\X\\7F'");
    /* Bytes that are no UTF-8 stand for themselves: alone, too long a form, cut, a surrogate,
     * too high. */
    check_string("\xfc!", "'\\X\\FC!'");
    check_string("\xc0\xaf", "'\\X\\C0\\X\\AF'");
    check_string("\xe2\x82", "'\\X\\E2\\X\\82'");
    check_string("\xed\xa0\x80", "'\\X\\ED\\X\\A0\\X\\80'");
    check_string("\xf5\x80\x80\x80", "'\\X\\F5\\X\\80\\X\\80\\X\\80'");
    check_string("\xe0\x80\x80", "'\\X\\E0\\X\\80\\X\\80'");
}

/* The first and the last of each length, and next to the surrogates. */
TEST(characters_at_the_limits_of_each_form_are_whole)
{
    check_string(" ~", "' ~'");
    check_string("\xc2\x80", "'\\X2\\0080\\X0\\'");
    check_string("\xdf\xbf", "'\\X2\\07FF\\X0\\'");
    check_string("\xe0\xa0\x80", "'\\X2\\0800\\X0\\'");
    check_string("\xed\x9f\xbf", "'\\X2\\D7FF\\X0\\'");
    check_string("\xed\xbf\xbf", "'\\X\\ED\\X\\BF\\X\\BF'");
    check_string("\xee\x80\x80", "'\\X2\\E000\\X0\\'");
    check_string("\xef\xbf\xbf", "'\\X2\\FFFF\\X0\\'");
    check_string("\xf0\x90\x80\x80", "'\\X4\\00010000\\X0\\'");
    check_string("\xf0\x8f\xbf\xbf", "'\\X\\F0\\X\\8F\\X\\BF\\X\\BF'");
    check_string("\xf4\x8f\xbf\xbf", "'\\X4\\0010FFFF\\X0\\'");
    check_string("\xf4\x90\x80\x80", "'\\X\\F4\\X\\90\\X\\80\\X\\80'");
    check_string("\xc2\xc2\x80", "'\\X\\C2\\X2\\0080\\X0\\'");
    check_string("\xe2\x82\x7f", "'\\X\\E2\\X\\82\\X\\7F'");
}

/* With the end of the instance a line has at most 120 columns: a token stays on it up to 118. */
TEST(a_line_is_filled_to_its_last_column)
{
    for (int length = 110; length <= 118; length++) {
        batten_text text = BATTEN_TEXT;
        bat_step step = {.text = &text};
        char token[120];
        memset(token, 'x', sizeof token);
        token[length] = 0;
        bat_step_open(&step, "A"); /* 5 columns */
        bat_step_token(&step, token);
        bat_step_close(&step);
        if (!text.failed)
            CHECK((strchr(text.bytes, '\n') - text.bytes == 5) == (5 + length > 118));
        batten_text_free(&text);
    }
}

TEST(lines_are_broken_between_tokens)
{
    batten_text text = BATTEN_TEXT;
    bat_step step = {.text = &text};
    CHECK_INT(bat_step_open(&step, "LIST"), 1);
    for (int i = 0; i < 100; i++)
        bat_step_integer(&step, 1000 + i, ",");
    bat_step_real(&step, 0.1, ",");
    bat_step_id(&step, 7, "");
    bat_step_close(&step);
    CHECK_INT(bat_step_add(&step, "NEXT", "%d", 3), 2);
    if (!text.failed) {
        int column = 0;
        for (const char *at = text.bytes; *at; at++) {
            column = *at == '\n' ? 0 : column + 1;
            CHECK(column <= 120);
        }
        CHECK_CONTAINS(text.bytes, ",0.1,#7);\n#2=NEXT(3);\n");
        CHECK_CONTAINS(text.bytes, "#1=LIST(1000,1001,");
    }
    batten_text_free(&text);
}
