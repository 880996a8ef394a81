/* Formats by their content, and how much of a file was read. */
#include "exchange/every_format.h"
#include "exchange/reading.h"

static const char step_body[] =
    STEP_BEGIN "#1=CARTESIAN_POINT('',(1.,2.,3.));\n#2=CARTESIAN_POINT('',(1.5,2.,4.));\n"
               "#4=POLYLINE('name',(#1,#2));\n" STEP_CONTEXT STEP_END;

TEST(comments_and_blanks_may_stand_before_a_STEP_file)
{
    static const char *const before[] = {"",
                                         "/**/",
                                         "/* a */\n",
                                         "/***/ \t\r\n",
                                         "/*a*/\r/*b*/\n",
                                         "/* ISO-10303-21; */",
                                         "\n /* * / */",
                                         "/*x*/\t/*y*/ /*z*/"};
    for (int i = 0; i < COUNT(before); i++) {
        char *text = test_array(sizeof step_body + 100, 1);
        batten_model *model = NULL;
        sprintf(text, "%s%s", before[i], step_body);
        CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_TEXT(batten_model_object(model, 0)->name, "name");
        batten_model_unref(model);
    }
}

TEST(a_comment_without_an_end_is_no_STEP_file)
{
    static const char *const texts[] = {"/* ISO-10303-21;", "/*", "/**/", "/*/ISO-10303-21;",
                                        "/**/x ISO-10303-21;"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = NULL;
        CHECK_STATUS(read_text(texts[i], BATTEN_FORMAT_AUTO, NULL, &model), BATTEN_BAD_FORMAT);
        CHECK(model == NULL);
    }
}

TEST(what_was_left_out_is_counted_against_all_there_was)
{
    static const struct {
        const char *text, *words;
    } cases[] = {{"OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n3 0 1 8\n",
                  "t: 2 of 3 entities are left out"},
                 {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                  "t: the end of the file is missing; 1 entity is read, 0 left out"},
                 {"OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n",
                  "t: the end of the file is missing; 1 entity is read, 1 left out"}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = NULL;
        CHECK_STATUS(read_text(cases[i].text, BATTEN_FORMAT_OFF, NULL, &model),
                     BATTEN_PARTLY_READ);
        CHECK_TEXT(batten_message(), cases[i].words);
        batten_model_unref(model);
    }
}
