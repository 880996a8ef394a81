/* Levels as layers, with their names. */
#include "exchange/iges/text.h"

TEST(levels_have_the_names_that_other_programs_give_them)
{
    batten_model *model = NULL;
    CHECK_OK(batten_read_file(test_data("iges/rhino_sphere.igs"), NULL, NULL, NULL, &model));
    CHECK_TEXT(batten_model_object(model, 0)->layer, "Default");
    batten_model_unref(model);
}

TEST(Q4_wrong_levels_are_none_and_said_once)
{
    static const struct {
        int level;
        const char *why;
    } cases[] = {
        {-99, "it refers to entity D99, which is missing"},
        {-1, "it refers to entity D1 as type 406, which is of type 110"},
        {-3, "it refers to entity D3 as a list of levels, form 1, which is of form 15"},
        {-5, "D5: parameter 2 is not a number but a string"}};
    for (int i = 0; i < COUNT(cases); i++) {
        char words[200], level[9];
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,1Hx;");
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,1Hx;");
        snprintf(level, sizeof level, "%8d", cases[i].level);
        memcpy(file.directory + 32, level, 8);
        snprintf(words, sizeof words, "its level is %d: %s; taken as none", cases[i].level,
                 cases[i].why);
        iges_check_wrong(&file, "#1 ", 4, words);
    }
}
