#include <locale.h>
#include <stdlib.h>

#include "exchange/reading.h"
#include "exchange/shapes.h"

TEST(names_of_files_say_their_format)
{
    const struct {
        const char *path;
        batten_format format;
    } cases[] = {
        {"a.igs", BATTEN_FORMAT_IGES},         {"a/b.IGES", BATTEN_FORMAT_IGES},
        {"a.stp", BATTEN_FORMAT_STEP},         {"a.Step", BATTEN_FORMAT_STEP},
        {"a.csv", BATTEN_FORMAT_OFFSET_TABLE}, {"a.xyz", BATTEN_FORMAT_POINTS},
        {"a.dat", BATTEN_FORMAT_AEROFOIL},     {"a", BATTEN_FORMAT_AUTO},
        {".igs", BATTEN_FORMAT_AUTO},          {"", BATTEN_FORMAT_AUTO},
        {"a.igs.bak", BATTEN_FORMAT_AUTO},     {"aigs", BATTEN_FORMAT_AUTO},
    };
    for (int i = 0; i < COUNT(cases); i++)
        CHECK_INT(batten_format_from_name(cases[i].path), cases[i].format);
    CHECK_TEXT(batten_format_name(BATTEN_FORMAT_STEP), "step");
    CHECK_TEXT(batten_format_name(BATTEN_FORMAT_AUTO), "auto");
    CHECK_TEXT(batten_format_name((batten_format)99), "?");
}

TEST(F7_the_content_counts_not_the_ending)
{
    const char *path = test_scratch("points.igs");
    batten_model *model = NULL;
    CHECK_OK(batten_save_file(path, "1 2\n3 4\n", 8));
    CHECK_OK(batten_read_file(path, NULL, NULL, NULL, &model));
    CHECK_INT(batten_model_object(model, 0)->point_count, 2);
    batten_model_unref(model);
}

TEST(F1_a_file_that_is_not_there_is_refused_with_the_reason)
{
    batten_model *model = NULL;
    CHECK_STATUS(batten_read_file(test_scratch("nothing.igs"), NULL, NULL, NULL, &model),
                 BATTEN_FILE_ERROR);
    CHECK_MESSAGE("nothing.igs");
    CHECK_STATUS(batten_read_file("/", NULL, NULL, NULL, &model), BATTEN_FILE_ERROR);
    CHECK(model == NULL);
}

TEST(formats_that_are_only_written_cannot_be_read)
{
    check_refused("G0 X1\n", BATTEN_FORMAT_GCODE, BATTEN_UNSUPPORTED,
                  "t: G-code files cannot be read");
    check_refused("1 2\n", (batten_format)99, BATTEN_UNSUPPORTED, "such files cannot be read");
}

TEST(messages_name_the_file)
{
    const char *path = test_scratch("hull.csv");
    batten_model *model = NULL;
    CHECK_OK(batten_save_file(path, "x,y\n1,a\n", 8));
    CHECK_STATUS(batten_read_file(path, NULL, NULL, NULL, &model), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("hull.csv:2: column 3: 'a' is not a number");
}

static char *written_in(const char *locale, const batten_model *model, size_t *size)
{
    char *data = NULL;
    if (!setlocale(LC_ALL, locale))
        SKIP("the locale %s is not installed", locale);
    const batten_status status = write_bytes(model, BATTEN_FORMAT_IGES, &data, size);
    batten_model *back = NULL;
    const batten_status reading =
        status == BATTEN_OK ? read_bytes(data, *size, BATTEN_FORMAT_AUTO, NULL, &back) : status;
    setlocale(LC_ALL, "C");
    if (reading == BATTEN_OK)
        check_same_model(model, back);
    batten_model_unref(back);
    CHECK(reading == BATTEN_OK || reading == BATTEN_OUT_OF_MEMORY);
    return data;
}

TEST(F5_locales_change_no_byte)
{
    const char *const locales[] = {"de_DE.UTF-8", "tr_TR.UTF-8"};
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    for (int i = 0; i < COUNT(locales); i++) {
        if (!setlocale(LC_ALL, locales[i]))
            SKIP("the locale %s is not installed", locales[i]);
        setlocale(LC_ALL, "C");
        test_random random = test_random_begin(__func__);
        batten_model *model = random_model(&random, 0.001);
        size_t plain_size = 0, size = 0;
        char *plain = written_in("C", model, &plain_size);
        char *other = written_in(locales[i], model, &size);
        CHECK_INT((long long)size, (long long)plain_size);
        CHECK(memcmp(plain, other, size) == 0);
        batten_release(plain);
        batten_release(other);
        batten_model_unref(model);
    }
}
