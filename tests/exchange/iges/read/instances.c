/* Subfigures, their instances, and groups. */
#include "exchange/iges/read/instances.h"

#include "exchange/iges/text.h"

TEST(an_instance_scales_then_moves_and_its_matrix_comes_last)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", IGES_LINE);
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,3Hkit,1,1;");
    iges_add(&file, 408, 0, 7, 0, "00000000", "408,3,10.,0.,0.,2.;");
    iges_add(&file, 124, 0, 0, 0, "00000000", "124,0.,-1.,0.,5.,1.,0.,0.,0.,0.,0.,1.,0.;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 1);
    const batten_object *object = batten_model_object(model, 0);
    CHECK_INT(object->kind, BATTEN_OBJECT_INSTANCE);
    CHECK_INT(batten_model_count(object->definition), 1);
    batten_model *flat = NULL;
    CHECK_OK(batten_model_flat(model, &flat));
    /* (1, 2, 3) becomes (12, 4, 6), then (-4 + 5, 12, 6). */
    const double *p = batten_curve_points(batten_model_object(flat, 0)->curve);
    CHECK_BITS(p[0], 1.0);
    CHECK_BITS(p[1], 12.0);
    CHECK_BITS(p[2], 6.0);
    batten_model_unref(flat);
    batten_model_unref(model);
}

TEST(instances_within_definitions_share_their_definition)
{
    iges_text file = iges_begin();
    iges_add(&file, 116, 0, 0, 0, "00010000", "116,1.,2.,3.;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,1,1;");
    iges_add(&file, 408, 0, 0, 0, "00010000", "408,3,10.,0.,0.;");
    iges_add(&file, 408, 0, 0, 0, "00010000", "408,3,20.,0.,0.,1.;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,1,1Hb,2,5,7;");
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,9,0.,1.,0.,1.;");
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,9,0.,2.,0.,1.;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 2);
    CHECK(batten_model_object(model, 0)->definition ==
          batten_model_object(model, 1)->definition);
    batten_model *flat = NULL;
    CHECK_OK(batten_model_flat(model, &flat));
    CHECK_INT(batten_model_count(flat), 4);
    CHECK_BITS(batten_model_object(flat, 3)->points[0], 21.0);
    CHECK_BITS(batten_model_object(flat, 3)->points[1], 4.0);
    batten_model_unref(flat);
    batten_model_unref(model);
}

TEST(P1_a_subfigure_of_itself_and_wrong_references_are_left_out)
{
    static const struct {
        const char *text, *words;
    } cases[] = {{"408,3,0.,0.,0.,1.;", "as type 308, which is of type 110"},
                 {"408,99,0.,0.,0.,1.;", "D99, which is missing"},
                 {"408,1,0.,0.,0.,1.;", "as type 308, which is of type 408"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 408, 0, 0, 0, "00000000", cases[i].text);
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_check_partly(&file, cases[i].words);
    }
    iges_text ring = iges_begin();
    batten_model *model = NULL;
    iges_add(&ring, 408, 0, 0, 0, "00000000", "408,3,0.,0.,0.,1.;");
    iges_add(&ring, 308, 0, 0, 0, "00000200", "308,0,1Ha,1,5;");
    iges_add(&ring, 408, 0, 0, 0, "00010000", "408,3,0.,0.,0.,1.;");
    CHECK_STATUS(read_text(iges_end(&ring, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(batten_model_object(model, 0)->definition), 0);
    batten_model_unref(model);
}

/* It is placed by an instance, and not a member of another; the instance finds it still. */
TEST(P1_a_subfigure_that_is_a_member_of_another_is_left_out)
{
    iges_text file = iges_begin();
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,3,0.,0.,0.,1.;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,1,1Hb,1,5;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,1,9;");
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,5,0.,0.,0.,1.;");
    iges_add(&file, 110, 0, 0, 0, "00010000", IGES_LINE);
    batten_model *model = NULL;
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model),
                 BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 2);
    CHECK_INT(batten_model_count(batten_model_object(model, 0)->definition), 0);
    CHECK_INT(batten_model_count(batten_model_object(model, 1)->definition), 1);
    batten_model_unref(model);
}

TEST(groups_within_groups_name_their_members)
{
    static const int forms[] = {1, 7, 14, 15};
    for (int i = 0; i < COUNT(forms); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_add(&file, 402, forms[i], 0, 0, "00000000", "402,1,1,0,1,9;");
        iges_add(&file, 402, forms[i], 0, 0, "00000000", "402,2,3,7;");
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,4Hkeel;");
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        CHECK_INT(batten_model_count(model), 2);
        CHECK_TEXT(batten_model_object(model, 0)->group, "group D5/keel");
        CHECK_TEXT(batten_model_object(model, 1)->group, "group D5");
        batten_model_unref(model);
    }
}

TEST(Q4_groups_in_a_ring_or_of_nothing_are_noted)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 402, 7, 0, 0, "00000000", "402,2,1,5;");
    iges_add(&file, 402, 7, 0, 0, "00000000", "402,1,3;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                                      "its groups contain one another in a ring");
    CHECK_TEXT(batten_model_object(model, 0)->group, "");
    batten_model_unref(model);
    iges_text bad = iges_begin();
    iges_add(&bad, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&bad, 402, 7, 0, 0, "00000000", "402,1000000,1;");
    batten_model_unref(
        read_noting(iges_end(&bad, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "it groups nothing"));
    iges_text missing = iges_begin();
    iges_add(&missing, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&missing, 402, 7, 0, 0, "00000000", "402,2,1,99;");
    batten_model_unref(read_noting(iges_end(&missing, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                                   "its member 2 is left out: it refers to entity D99"));
}

TEST(levels_are_layers)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 406, 1, 0, 0, "00010300", "406,2,12,13;");
    char *text = test_array(1 << 16, 1);
    strcpy(text, iges_end(&file, IGES_GLOBAL));
    const char *const levels[] = {"       3", "      -7", "      -9"};
    int n = 0;
    for (char *at = text; *at && n < 6; at += 81)
        if (at[72] == 'D' && n++ % 2 == 0)
            memcpy(at + 32, levels[n / 2], 8);
    batten_model *model = read_noting(
        text, BATTEN_FORMAT_AUTO, "it is on all levels that D7 lists; only the first is kept");
    batten_model_unref(model);
    model = read_noting(text, BATTEN_FORMAT_AUTO, "its level is -9: it refers to entity D9");
    CHECK_TEXT(batten_model_object(model, 0)->layer, "3");
    CHECK_TEXT(batten_model_object(model, 1)->layer, "12");
    CHECK_TEXT(batten_model_object(model, 2)->layer, "");
    batten_model_unref(model);
}
