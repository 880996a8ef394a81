#include "exchange/reading/scan.h"

#include "exchange/reading.h"

static bat_span span(const char *text)
{
    return (bat_span){text, strlen(text)};
}

TEST(the_end_of_a_line_is_LF_or_CRLF_or_CR)
{
    const char *text = "a\nb\r\nc\rd\r\re\n\nf";
    static const int lines[] = {1, 2, 3, 4, 6, 8};
    bat_scan scan = bat_scan_begin(text, strlen(text));
    bat_span word;
    for (int i = 0; i < COUNT(lines); i++) {
        CHECK(bat_next_word(&scan, &word));
        CHECK_INT((long long)word.length, 1);
        CHECK_INT(word.bytes[0], 'a' + i);
        CHECK_INT(scan.line, lines[i]);
    }
    CHECK(!bat_next_word(&scan, &word));
    CHECK(scan.at == scan.end);
}

TEST(a_return_as_the_last_byte_ends_its_line_and_reads_no_further)
{
    const char text[] = {'a', '\r', '\n'}; /* the scan ends before the feed */
    bat_scan scan = bat_scan_begin(text, 2);
    bat_span word;
    CHECK(bat_next_in_line(&scan, &word));
    CHECK(!bat_next_in_line(&scan, &word));
    CHECK(bat_next_scan_line(&scan));
    CHECK(scan.at == text + 2);
    CHECK_INT(scan.line, 2);
    CHECK(!bat_next_scan_line(&scan));
    CHECK_INT(scan.line, 2);
}

TEST(words_of_a_line_end_with_it_and_blanks_are_of_four_kinds)
{
    const char *text = " ab\tc\vd\fe  \n f";
    static const char *const due[] = {"ab", "c", "d", "e"};
    bat_scan scan = bat_scan_begin(text, strlen(text));
    bat_span word;
    for (int i = 0; i < COUNT(due); i++) {
        CHECK(bat_next_in_line(&scan, &word));
        CHECK(bat_word_is(word, due[i]));
    }
    CHECK(!bat_next_in_line(&scan, &word));
    CHECK_INT(scan.line, 1);
    CHECK(bat_next_scan_line(&scan));
    CHECK(bat_next_in_line(&scan, &word) && bat_word_is(word, "f"));
}

TEST(the_rest_of_a_line_has_no_blanks_around_it_and_stops_before_its_end)
{
    static const struct {
        const char *text, *rest;
    } cases[] = {
        {"a  b c \t\r\nd", "b c"}, {"a\nb", ""}, {"a   \rb", ""}, {"a x", "x"}, {"a", ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_scan scan = bat_scan_begin(cases[i].text, strlen(cases[i].text));
        bat_span word;
        CHECK(bat_next_word(&scan, &word));
        const bat_span rest = bat_rest_of_line(&scan);
        CHECK(bat_word_is(rest, cases[i].rest));
        CHECK(scan.at == scan.end || *scan.at == '\r' || *scan.at == '\n');
        CHECK_INT(scan.line, 1);
    }
}

TEST(words_are_compared_whole_with_or_without_regard_to_case)
{
    CHECK(bat_word_is(span("Abz"), "Abz") && !bat_word_is(span("abz"), "Abz"));
    CHECK(!bat_word_is(span("Ab"), "Abz") && !bat_word_is(span("Abzz"), "Abz"));
    CHECK(bat_word_is_like(span("AbZ0[@"), "aBz0[@") && bat_word_is_like(span(""), ""));
    CHECK(!bat_word_is_like(span("ab"), "abc") && !bat_word_is_like(span("abc"), "ab"));
    CHECK(!bat_word_is_like(span("[@"), "{`")); /* beside A and Z, 32 apart */
    CHECK(!bat_word_is_like(span("a"), ""));
}

TEST(numbers_are_words_as_a_whole)
{
    double value = 9;
    int64_t whole = 9;
    CHECK(bat_word_number(span("-1.5"), &value) && value == -1.5);
    CHECK(!bat_word_number(span("1.5x"), &value) && !bat_word_number(span(""), &value));
    CHECK(bat_word_integer(span("-3"), -3, 3, &whole) && whole == -3);
    CHECK(bat_word_integer(span("3"), -3, 3, &whole) && whole == 3);
    CHECK(!bat_word_integer(span("4"), -3, 3, &whole));
    CHECK(!bat_word_integer(span("-4"), -3, 3, &whole));
    CHECK(!bat_word_integer(span("3 "), -3, 3, &whole) && whole == 3);
}

TEST(a_copy_of_a_word_ends_with_a_zero_byte_and_keeps_to_its_room)
{
    char copy[6] = "xxxxx";
    bat_word_copy(span("abc"), 4, copy);
    CHECK_TEXT(copy, "abc");
    CHECK_INT(copy[4], 'x');
    bat_word_copy(span("abcd"), 4, copy);
    CHECK_TEXT(copy, "abc");
    bat_word_copy(span("abcdefg"), 4, copy);
    CHECK_TEXT(copy, "abc");
    CHECK_INT(copy[4], 'x');
    bat_word_copy(span("ab"), 4, copy);
    CHECK_TEXT(copy, "ab");
    bat_word_copy((bat_span){NULL, 0}, 4, copy);
    CHECK_TEXT(copy, "");
}

TEST(bytes_stand_at_a_place_or_do_not)
{
    bat_input input;
    CHECK_OK(bat_input_begin("solid x", 7, NULL, NULL, NULL, &input));
    CHECK(bat_begins(&input, 0, "solid") && bat_begins(&input, 6, "x"));
    CHECK(bat_begins(&input, 7, "") && !bat_begins(&input, 8, ""));
    CHECK(!bat_begins(&input, 1, "solid") && !bat_begins(&input, 6, "xy"));
}

TEST(white_space_at_the_start_is_passed_over_after_a_byte_order_mark)
{
    static const struct {
        const char *text;
        int at;
    } cases[] = {
        {"x", 0}, {" \t\v\f\r\nx", 6}, {"\xef\xbb\xbfx", 3}, {"\xef\xbb\xbf x", 4}, {" \n", 2},
        {"", 0},  {" \xef\xbb\xbf", 1}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_input input;
        CHECK_OK(
            bat_input_begin(cases[i].text, strlen(cases[i].text), NULL, NULL, NULL, &input));
        CHECK_INT((long long)bat_past_white(&input), cases[i].at);
    }
}

TEST(a_number_below_the_least_double_is_zero_with_a_note_of_its_line)
{
    batten_notes *notes = NULL;
    bat_input input;
    double value = 1;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, notes, &input));
    CHECK(bat_word_real(&input, 7, span("1e-999"), &value));
    CHECK_BITS(value, 0);
    CHECK(bat_word_real(&input, 8, span("0e5"), &value));
    CHECK(bat_word_real(&input, 9, span("-0.00"), &value));
    CHECK(!bat_word_real(&input, 9, span("1e-999x"), &value));
    if (!batten_notes_dropped(notes)) {
        CHECK_INT(batten_notes_count(notes), 1);
        CHECK_INT(batten_notes_at(notes, 0)->line, 7);
        CHECK_TEXT(batten_notes_at(notes, 0)->text,
                   "the number 1e-999 is too small for a double; read as 0");
    }
    batten_notes_free(notes);
}
