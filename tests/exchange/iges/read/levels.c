#include "exchange/reading.h"

TEST(levels_have_the_names_that_other_programs_give_them)
{
    batten_model *model = NULL;
    CHECK_OK(batten_read_file(test_data("iges/rhino_sphere.igs"), NULL, NULL, NULL, &model));
    CHECK_TEXT(batten_model_object(model, 0)->layer, "Default");
    batten_model_unref(model);
}
