#include "exchange/reading/input.h"

#include "exchange/reading.h"

TEST(a_list_grows_and_keeps_its_items)
{
    bat_input input;
    bat_list list = {.size = sizeof(int)};
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    for (int i = 0; i < 1000; i++)
        CHECK_OK(bat_list_add(&input, &list, &i));
    for (int i = 0; i < 1000; i++)
        CHECK_INT(((int *)list.items)[i], i);
    CHECK_INT((long long)list.count, 1000);
    batten_release(list.items);
}

TEST(messages_say_the_file_and_the_line_when_there_are_some)
{
    bat_input input;
    batten_read_options options = batten_read_defaults();
    CHECK_OK(bat_input_begin("", 0, &options, NULL, NULL, &input));
    bat_input_fail(&input, BATTEN_BAD_FORMAT, 0, "%d legs", 3);
    CHECK_TEXT(batten_message(), "3 legs");
    bat_input_fail(&input, BATTEN_BAD_FORMAT, 7, "%d legs", 3);
    CHECK_TEXT(batten_message(), "line 7: 3 legs");
    input.file = "a.igs";
    bat_input_fail(&input, BATTEN_BAD_FORMAT, 0, "%d legs", 3);
    CHECK_TEXT(batten_message(), "a.igs: 3 legs");
    bat_input_fail(&input, BATTEN_BAD_FORMAT, 7, "%d legs", 3);
    CHECK_TEXT(batten_message(), "a.igs:7: 3 legs");
}

TEST(S1_a_file_above_the_limit_is_refused)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_model *model = NULL;
    options.limits = &limits;
    limits.file_bytes = 7;
    CHECK_STATUS(batten_read_memory("1 2\n3 4\n", 8, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("8 bytes in the file; the limit is 7");
    limits.file_bytes = 8;
    limits.line_bytes = 2;
    CHECK_STATUS(batten_read_memory("1 2\n3 4\n", 8, &options, NULL, NULL, &model),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("line 1: 3 bytes in one line; the limit is 2");
}

static bool say_yes(void *user)
{
    (void)user;
    return true;
}

TEST(reading_can_be_cancelled)
{
    enum { LINES = 5000 };
    batten_job job = BATTEN_JOB;
    batten_model *model = NULL;
    char *text = test_array(4 * LINES + 1, 1);
    for (int i = 0; i < LINES; i++)
        memcpy(text + 4 * i, "1 2\n", 4);
    job.is_cancelled = say_yes;
    CHECK_STATUS(batten_read_memory(text, 4 * LINES, NULL, &job, NULL, &model),
                 BATTEN_CANCELLED);
    CHECK(model == NULL);
}

TEST(S3_long_lines_and_many_comments_are_borne)
{
    const size_t size = test_cases(1000) < 1000 ? 1 << 12 : 10 << 20;
    char *text = test_array(size + 8, 1);
    batten_model *model = NULL;
    memset(text, '1', size);
    if (size > 65536) {
        CHECK_STATUS(read_bytes(text, size, BATTEN_FORMAT_POINTS, NULL, &model),
                     BATTEN_TOO_LARGE);
        CHECK_MESSAGE("bytes in one line; the limit is 65536");
    }
    for (size_t i = 0; i < size; i += 2)
        memcpy(text + i, "#\n", 2);
    memcpy(text + size, "1 2 3\n", 6);
    CHECK_OK(read_bytes(text, size + 6, BATTEN_FORMAT_AUTO, NULL, &model));
    batten_model_unref(model);
}

TEST(S3_notes_are_kept_up_to_the_limit_and_then_counted)
{
    enum { POINTS = 3000 };
    char *text = test_array(16 * POINTS + 1, 1), *at = text;
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    for (int i = 0; i < POINTS; i++)
        at += sprintf(at, "%d 1e-999\n", i);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, notes, &model));
    CHECK(batten_notes_count(notes) <= 10);
    CHECK(batten_notes_count(notes) + batten_notes_dropped(notes) >= POINTS);
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* ---- where a failure stands ---- */

TEST(the_reason_of_a_failure_is_its_sentence_and_its_line)
{
    static const char *const files[] = {"", "a.igs", "12", "line 3"};
    bat_input input;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    for (int i = 0; i < COUNT(files); i++)
        for (int line = 0; line < 25; line += 12) {
            int found = -1;
            input.file = files[i];
            bat_input_fail(&input, BATTEN_BAD_FORMAT, line, "7: %s legs", "three");
            const char *reason = bat_input_reason(&input, &found);
            /* Without a file and a line the sentence cannot be told from a place. */
            if (files[i][0] || line) {
                CHECK_TEXT(reason, "7: three legs");
                CHECK_INT(found, line);
            }
        }
}

TEST(the_reason_of_a_failure_that_names_no_place_is_the_message)
{
    static const char *const messages[] = {"no memory", "a.igs", "a.igs is bad", "b.igs:4: x",
                                           "a.igs:4x: y"};
    bat_input input;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    input.file = "a.igs";
    for (int i = 0; i < COUNT(messages); i++) {
        int line = -1;
        bat_fail(BATTEN_BAD_FORMAT, "%s", messages[i]);
        CHECK_TEXT(bat_input_reason(&input, &line), messages[i]);
        CHECK_INT(line, 0);
    }
    input.file = "";
    static const char *const bare[] = {"no memory", "line x: y", "line 4 is bad", "4 is bad"};
    for (int i = 0; i < COUNT(bare); i++) {
        int line = -1;
        bat_fail(BATTEN_BAD_FORMAT, "%s", bare[i]);
        CHECK_TEXT(bat_input_reason(&input, &line), bare[i]);
        CHECK_INT(line, 0);
    }
}

/* ---- text ---- */

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

/* ---- limits and memory ---- */

static bat_input limited(size_t memory)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    bat_input input;
    limits.memory_bytes = memory;
    options.limits = &limits;
    CHECK_OK(bat_input_begin("", 0, &options, NULL, NULL, &input));
    return input;
}

TEST(memory_counts_up_to_the_limit_and_no_more_when_given_back)
{
    bat_input input = limited(100);
    char *first = NULL, *second = NULL;
    CHECK_OK(bat_input_array(&input, 10, 6, &first));
    for (int i = 0; i < 60; i++)
        CHECK_INT(first[i], 0);
    CHECK_STATUS(bat_input_array(&input, 41, 1, &second), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("reading needs more memory than the limit of 100 bytes");
    CHECK(second == NULL);
    CHECK_STATUS(bat_input_array(&input, SIZE_MAX / 2, 4, &second), BATTEN_TOO_LARGE);
    CHECK_OK(bat_input_array(&input, 40, 1, &second));
    bat_input_release(&input, 40, 1, second);
    bat_input_release(&input, 7, 7, NULL);
    second = NULL;
    CHECK_STATUS(bat_input_array(&input, 41, 1, &second), BATTEN_TOO_LARGE);
    bat_input_release(&input, 10, 6, first);
    CHECK_OK(bat_input_array(&input, 25, 4, &second));
    bat_input_release(&input, 25, 4, second);
}

TEST(the_memory_of_a_list_counts_by_its_capacity)
{
    bat_input input = limited(32 * sizeof(int) - 1);
    bat_list list = {.size = sizeof(int)};
    for (int i = 0; i < 16; i++)
        CHECK_OK(bat_list_add(&input, &list, &i));
    CHECK_STATUS(bat_list_add(&input, &list, &(int){16}), BATTEN_TOO_LARGE);
    CHECK_INT((long long)list.count, 16);
    input.limits.memory_bytes++;
    CHECK_OK(bat_list_append(&input, &list, (const int[]){16, 17, 18}, 3));
    for (int i = 0; i < 19; i++)
        CHECK_INT(((const int *)list.items)[i], i);
    CHECK_INT((long long)list.count, 19);
    CHECK_OK(bat_list_append(&input, &list, NULL, 0));
    CHECK_OK(bat_list_reserve(&input, &list, 13)); /* up to 32 */
    CHECK_STATUS(bat_list_reserve(&input, &list, 14), BATTEN_TOO_LARGE);
    CHECK_STATUS(bat_list_reserve(&input, &list, SIZE_MAX / 2), BATTEN_TOO_LARGE);
    CHECK_INT((long long)list.count, 19);
    batten_release(list.items);
}

TEST(without_a_limit_on_memory_it_grows_with_the_file)
{
    bat_input input;
    CHECK_OK(bat_input_begin("12345", 5, NULL, NULL, NULL, &input));
    CHECK_INT((long long)input.limits.memory_bytes, (16 << 20) + 200);
    CHECK_TEXT(input.file, "");
    batten_read_options options = batten_read_defaults();
    options.file_name = NULL;
    CHECK_OK(bat_input_begin("12345", 5, &options, NULL, NULL, &input));
    CHECK_TEXT(input.file, "");
}

TEST(the_defaults_of_the_limits_are_those_of_the_manual)
{
    const batten_limits limits = batten_limits_defaults();
    CHECK_INT((long long)limits.size, sizeof limits);
    CHECK_INT((long long)limits.file_bytes, 1 << 30);
    CHECK_INT((long long)limits.memory_bytes, 0);
    CHECK_INT((long long)limits.entities, 10000000);
    CHECK_INT((long long)limits.nesting, 64);
    CHECK_INT((long long)limits.string_bytes, 1 << 20);
    CHECK_INT((long long)limits.line_bytes, 1 << 16);
    CHECK_INT((long long)limits.points, 10000000);
    CHECK_INT((long long)limits.notes, 1000);
}

TEST(what_comes_near_a_shape_may_have_a_hundred_times_its_points_and_some)
{
    bat_input input = limited(0);
    CHECK_INT(bat_input_most_near(&input, 0), 10000);
    CHECK_INT(bat_input_most_near(&input, 7), 10700);
    CHECK_INT(bat_input_most_near(&input, 1e9), 4000000);
    input.limits.points = 500;
    CHECK_INT(bat_input_most_near(&input, 7), 500);
    input.limits.points = 0;
    CHECK_INT(bat_input_most_near(&input, 7), 1);
}

TEST(the_whole_file_ends_with_missing_memory_limits_and_being_cancelled)
{
    for (int status = BATTEN_OK; status <= BATTEN_PARTLY_READ; status++)
        CHECK_INT(bat_input_ends((batten_status)status), status == BATTEN_OUT_OF_MEMORY ||
                                                             status == BATTEN_TOO_LARGE ||
                                                             status == BATTEN_CANCELLED);
}

static double last_fraction;

static void note_fraction(void *user, double fraction, const char *stage)
{
    (void)user;
    CHECK_TEXT(stage, "reading");
    last_fraction = fraction;
}

TEST(progress_is_the_share_of_the_file_that_is_read)
{
    batten_job job = BATTEN_JOB;
    bat_input input;
    job.progress = note_fraction;
    CHECK_OK(bat_input_begin("12345678", 8, NULL, &job, NULL, &input));
    last_fraction = -1;
    for (int i = 0; i < 3000; i++)
        CHECK_OK(bat_input_step(&input, 6));
    CHECK_BITS(last_fraction, 0.75);
    CHECK_OK(bat_input_begin("", 0, NULL, &job, NULL, &input));
    for (int i = 0; i < 3000; i++)
        CHECK_OK(bat_input_step(&input, 0));
    CHECK_BITS(last_fraction, 1);
}
