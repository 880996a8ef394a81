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
