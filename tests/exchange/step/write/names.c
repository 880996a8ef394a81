#include "exchange/step/references.h"

/* Ids of products, as they stand in the file; how many. */
static void place_part(batten_model *model, const char *name)
{
    const double points[] = {1, 2, 3};
    const batten_affine identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    batten_model *part = NULL;
    CHECK_OK(batten_model_create(1, &part));
    CHECK_OK(batten_model_add(part, &(batten_object){.name = "p",
                                                     .kind = BATTEN_OBJECT_POINTS,
                                                     .point_count = 1,
                                                     .points = points}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = part,
                                                      .place = identity}));
    batten_model_unref(part);
}

/* Each id once: numbers are given in the order of the parts, and skip those that are names. */
TEST(parts_of_one_name_are_numbered_in_their_order)
{
    static const char *const names[] = {"a", "a", "a.2", "a"};
    static const char *const products[] = {"PRODUCT('a','a',", "PRODUCT('a.2','a.2',",
                                           "PRODUCT('a.3','a',", "PRODUCT('a.4','a',"};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < COUNT(names); i++)
        place_part(model, names[i]);
    const char *text = step_text(model, NULL);
    for (int i = 0; i < COUNT(products); i++) {
        const char *at = strstr(text, products[i]);
        CHECK(at && !strstr(at + 1, products[i]));
    }
    CHECK(strstr(text, "PRODUCT('a.3','a',") < strstr(text, "PRODUCT('a.4','a',"));
    step_check_references(text);
    batten_model_unref(model);
}
