#include "exchange/reading/words.h"

#include "exchange/reading.h"

static bat_words words_of(const char *text, bat_input *input)
{
    bat_words words;
    CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, input));
    bat_words_begin(&words, input);
    return words;
}

TEST(words_know_their_line_and_whether_they_open_it)
{
    static const struct {
        const char *text;
        int line;
        bool opens;
    } due[] = {{"a", 2, true}, {"b", 2, false}, {"c", 4, true}};
    bat_input input;
    bat_words words = words_of("\n a b\n\n\tc\n", &input);
    for (int i = 0; i < COUNT(due); i++) {
        CHECK(bat_words_next(&words));
        CHECK(bat_word_is(words.word, due[i].text));
        CHECK_INT(words.line, due[i].line);
        CHECK_INT(words.begins_line, due[i].opens);
    }
    CHECK(!bat_words_next(&words));
    CHECK(!words.begins_line);
}

TEST(a_number_is_read_or_the_failure_names_the_line_and_the_word)
{
    bat_input input;
    bat_words words = words_of("-2.5e1\n4.\nx1 1e999", &input);
    double value = 7;
    CHECK_OK(bat_words_real(&words, "a radius", &value));
    CHECK_BITS(value, -25);
    CHECK_OK(bat_words_real(&words, "a radius", &value));
    CHECK_BITS(value, 4);
    CHECK_STATUS(bat_words_real(&words, "a radius", &value), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 3: a radius is 'x1', not a number");
    CHECK_STATUS(bat_words_real(&words, "a radius", &value), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(),
               "line 3: a radius is '1e999', which is too large for a number");
    CHECK_STATUS(bat_words_real(&words, "a radius", &value), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 3: the text ends where a radius is expected");
    CHECK_BITS(value, 4);
}

TEST(a_whole_number_is_taken_from_low_to_high_with_both_ends)
{
    bat_input input;
    bat_words words = words_of("2 5 1 6 3.5", &input);
    int value = 0;
    for (int i = 0; i < 2; i++) {
        CHECK_OK(bat_words_integer(&words, "a degree", 2, 5, &value));
        CHECK_INT(value, i ? 5 : 2);
    }
    for (int i = 0; i < 3; i++) {
        static const char *const shown[] = {"1", "6", "3.5"};
        char due[100];
        CHECK_STATUS(bat_words_integer(&words, "a degree", 2, 5, &value), BATTEN_BAD_FORMAT);
        snprintf(due, sizeof due, "line 1: a degree is %s, not a whole number from 2 to 5",
                 shown[i]);
        CHECK_TEXT(batten_message(), due);
    }
    CHECK_STATUS(bat_words_integer(&words, "a degree", 2, 5, &value), BATTEN_BAD_FORMAT);
    CHECK_TEXT(batten_message(), "line 1: the text ends where a degree is expected");
    CHECK_INT(value, 5);
}

TEST(a_promise_is_kept_when_each_word_has_a_byte_and_a_blank_between)
{
    bat_input input;
    bat_words words = words_of("1 2 3 4 5 6", &input);
    CHECK_OK(bat_words_check(&words, "numbers", 6, 1));
    CHECK_OK(bat_words_check(&words, "points", 2, 3));
    CHECK_STATUS(bat_words_check(&words, "numbers", 7, 1), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("7 numbers cannot stand in the 11 bytes that are left");
    CHECK_STATUS(bat_words_check(&words, "points", 3, 3), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("3 points cannot stand in the 11 bytes that are left");
    CHECK(bat_words_next(&words));
    CHECK_OK(bat_words_check(&words, "numbers", 5, 1));
    CHECK_STATUS(bat_words_check(&words, "numbers", 6, 1), BATTEN_BAD_FORMAT);
}

TEST(many_numbers_come_in_memory_of_their_own_or_not_at_all)
{
    bat_input input;
    bat_words words = words_of("1 2 3 x 5", &input);
    double *values = NULL;
    CHECK_OK(bat_words_reals(&words, "a knot", 3, &values));
    for (int i = 0; i < 3; i++)
        CHECK_BITS(values[i], i + 1);
    batten_release(values);
    values = NULL;
    CHECK_STATUS(bat_words_reals(&words, "a knot", 2, &values), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("a knot is 'x', not a number");
    CHECK_STATUS(bat_words_reals(&words, "a knot", 9, &values), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("9 a knot cannot stand");
    CHECK(values == NULL);
}
