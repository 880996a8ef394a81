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
