/* The text of an input: its lines, characters and numbers, and what is left of it. */
#include "exchange/reading/input.h"

#include "exchange/reading.h"

TEST(text_is_without_its_byte_order_mark_and_its_final_control_Z)
{
    static const struct {
        const char *bytes;
        size_t size;
        const char *text;
    } cases[] = {{"\xef\xbb\xbf"
                  "ab\x1a\x1a",
                  7, "ab"},
                 {"ab", 2, "ab"},
                 {"\x1a", 1, ""},
                 {"a\x1a"
                  "b",
                  3,
                  "a\x1a"
                  "b"},
                 {"\xef\xbb", 2, "\xef\xbb"}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_input input;
        CHECK_OK(bat_input_begin(cases[i].bytes, cases[i].size, NULL, NULL, NULL, &input));
        CHECK_OK(bat_input_as_text(&input));
        CHECK_INT((long long)input.size, (long long)strlen(cases[i].text));
        CHECK(memcmp(input.data, cases[i].text, input.size) == 0);
    }
}

TEST(text_in_UTF_16_or_with_a_zero_byte_is_refused_at_its_line)
{
    static const struct {
        const char *bytes;
        size_t size;
        batten_status status;
        const char *words;
    } cases[] = {
        {"\xff\xfe", 2, BATTEN_UNSUPPORTED, "the text is in UTF-16; save it as UTF-8"},
        {"\xfe\xff", 2, BATTEN_UNSUPPORTED, "the text is in UTF-16; save it as UTF-8"},
        {"\0", 1, BATTEN_BAD_FORMAT, "line 1: byte 0 is zero; this is not text"},
        {"ab\0", 3, BATTEN_BAD_FORMAT, "line 1: byte 2 is zero; this is not text"},
        {"a\n\0", 3, BATTEN_BAD_FORMAT, "line 2: byte 2 is zero; this is not text"},
        {"a\r\rb\n\n\0x", 8, BATTEN_BAD_FORMAT, "line 5: byte 6 is zero; this is not text"}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_input input;
        CHECK_OK(bat_input_begin(cases[i].bytes, cases[i].size, NULL, NULL, NULL, &input));
        CHECK_STATUS(bat_input_as_text(&input), cases[i].status);
        CHECK_TEXT(batten_message(), cases[i].words);
    }
}

TEST(lines_end_with_LF_CRLF_or_CR_however_long_they_are)
{
    static const int lengths[] = {0, 1, 255, 256, 257, 511, 512, 513, 2000};
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    for (int i = 0; i < COUNT(lengths); i++)
        for (int e = 0; e < COUNT(ends); e++) {
            const size_t length = (size_t)lengths[i];
            char *text = test_array(2 * length + 10, 1);
            bat_input input;
            bat_span line;
            size_t at = 0;
            memset(text, 'x', length);
            strcpy(text + length, ends[e]);
            strcat(text, "tail");
            CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, &input));
            CHECK(bat_next_line(&input, &at, &line));
            CHECK_INT((long long)line.length, lengths[i]);
            CHECK(line.bytes == text);
            CHECK(bat_next_line(&input, &at, &line));
            CHECK_INT((long long)line.length, 4);
            CHECK(memcmp(line.bytes, "tail", 4) == 0);
            CHECK(!bat_next_line(&input, &at, &line));
        }
}

TEST(a_return_at_the_very_end_is_the_end_of_a_line)
{
    bat_input input;
    bat_span line;
    size_t at = 0;
    CHECK_OK(bat_input_begin("a\r\n", 2, NULL, NULL, NULL, &input)); /* the feed is beyond */
    CHECK(bat_next_line(&input, &at, &line));
    CHECK_INT((long long)at, 2);
    CHECK(!bat_next_line(&input, &at, &line));
}

TEST(blanks_are_four_characters_and_white_space_six)
{
    for (int c = -128; c < 128; c++) {
        const bool blank = c == ' ' || c == '\t' || c == '\v' || c == '\f';
        CHECK_INT(bat_is_blank((char)c), blank);
        CHECK_INT(bat_is_white((char)c), blank || c == '\r' || c == '\n');
    }
}

TEST(hexadecimal_digits_are_those_of_C)
{
    for (int c = 1; c < 128; c++) {
        static const char digits[] = "0123456789abcdef";
        const char *found = strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c);
        CHECK_INT(bat_hex_digit((char)c), found ? found - digits : -1);
    }
    CHECK_INT(bat_hex_digit('\0'), -1);
}

TEST(UTF_8_is_that_of_the_standard)
{
    /* RFC 3629, at the bounds of each length. */
    static const struct {
        uint32_t code;
        const char *bytes;
    } cases[] = {{1, "\x01"},
                 {0x7f, "\x7f"},
                 {0x80, "\xc2\x80"},
                 {0x7ff, "\xdf\xbf"},
                 {0x800, "\xe0\xa0\x80"},
                 {0x20ac, "\xe2\x82\xac"},
                 {0xd7ff, "\xed\x9f\xbf"},
                 {0xe000, "\xee\x80\x80"},
                 {0xffff, "\xef\xbf\xbf"},
                 {0x10000, "\xf0\x90\x80\x80"},
                 {0x1f600, "\xf0\x9f\x98\x80"},
                 {0x10ffff, "\xf4\x8f\xbf\xbf"},
                 {0, ""},
                 {0xd800, ""},
                 {0xdfff, ""},
                 {0x110000, ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        char bytes[5] = "";
        CHECK_INT((long long)bat_utf8_write(cases[i].code, bytes),
                  (long long)strlen(cases[i].bytes));
        CHECK_TEXT(bytes, cases[i].bytes);
    }
}

TEST(what_has_vanished_is_zero_and_was_not_written_as_zero)
{
    static const struct {
        const char *text;
        bool is_lost;
    } cases[] = {{"0", false},       {"-0.00", false},      {"+0e7", false}, {"0.", false},
                 {"1e-400", true},   {"0.0009e-999", true}, {"", false},     {"0e1", false},
                 {"-.5E-999", true}, {"9e-999", true}};
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_span span = {cases[i].text, strlen(cases[i].text)};
        CHECK_INT(bat_has_vanished(span, 0), cases[i].is_lost);
        CHECK(!bat_has_vanished(span, 5e-324));
    }
}

TEST(bytes_after_the_end_are_counted_unless_they_are_filling)
{
    static const struct {
        const char *bytes;
        size_t size;
        const char *words; /* NULL: nothing is noted */
    } cases[] = {
        {"END", 3, NULL},
        {"END \n\r\t\x1a\0\0", 9, NULL},
        {"ENDx", 4, "1 byte follows where the file should end, at byte 3; not read"},
        {"END\0 x", 6, "3 bytes follow where the file should end, at byte 3; not read"}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_notes *notes = NULL;
        bat_input input;
        CHECK_OK(batten_notes_create(3, &notes));
        CHECK_OK(bat_input_begin(cases[i].bytes, cases[i].size, NULL, NULL, notes, &input));
        bat_input_behind(&input, 3);
        if (!batten_notes_dropped(notes)) {
            CHECK_INT(batten_notes_count(notes), cases[i].words != NULL);
            if (cases[i].words) {
                CHECK_TEXT(batten_notes_at(notes, 0)->text, cases[i].words);
                CHECK_INT(batten_notes_at(notes, 0)->line, 0);
            }
        }
        batten_notes_free(notes);
    }
}
