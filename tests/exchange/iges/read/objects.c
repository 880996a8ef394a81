/* What each entity becomes in the model, and what is left out. */
#include "exchange/iges/read/reading.h"
#include "exchange/iges/text.h"

TEST(what_is_hidden_says_so_and_definitions_are_not_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "01000000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 2);
    CHECK(batten_model_object(model, 0)->is_hidden);
    CHECK(!batten_model_object(model, 1)->is_hidden);
    batten_model_unref(model);
    iges_text other = iges_begin();
    iges_add(&other, 110, 0, 0, 0, "00000200", IGES_LINE);
    iges_check_left_out(&other, "its use is 2, a definition, and not geometry; left out");
}

TEST(points_that_are_called_positional_are_read)
{
    iges_text file = iges_begin();
    iges_add(&file, 116, 0, 0, 0, "00020400", "116,1.,2.,3.,0;");
    iges_add(&file, 402, 1, 0, 0, "00000000", "402,1,1;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_POINTS);
    CHECK_TEXT(batten_model_object(model, 0)->group, "group D3");
    batten_model_unref(model);
}

TEST(references_say_what_is_a_part_and_flags_that_disagree_are_noted)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00010000", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000500", IGES_LINE);
    iges_add(&file, 110, 0, 0, 0, "00000000", "110,0.,0.,0.,1.,0.,0.;");
    iges_add(&file, 102, 0, 0, 0, "00000000", "102,1,5;");
    batten_model *model =
        read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO,
                    "entities declared as parts of others to which nothing refers: 1");
    CHECK_INT(batten_model_count(model), 2);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[0], 1.0);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 1)->curve)[0], 0.0);
    batten_model_unref(model);
}

TEST(P4_entities_of_other_types_are_counted_by_name)
{
    iges_text file = iges_begin();
    iges_add(&file, 150, 0, 0, 0, "00000000", "150,1.,2.,3.;");
    iges_check_left_out(&file, "0 read, 1 left out");
    char name[BAT_IGES_TYPE_NAME];
    const bat_iges_reading reading = {.types = bat_iges_all_types()};
    bat_iges_name_of_type(&reading, 150, name);
    CHECK_TEXT(name, "150 block");
    bat_iges_name_of_type(&reading, 5001, name);
    CHECK_TEXT(name, "5001, an unknown type");
    iges_text named = iges_begin();
    iges_add(&named, 158, 0, 0, 0, "00000000", "158,1.;");
    iges_check_left_out(&named, "entities of this type are not read; this is the first");
    check_refused(iges_one(777, "777,1;"), BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED,
                  "its 1 entity could not be read");
    iges_text empty = iges_begin();
    batten_model *model = read_noting(iges_end(&empty, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}

/* One note for each reason, of which 32 are kept; later ones are counted without a note. */
TEST(each_type_that_is_not_read_is_noted_once)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    for (int i = 0; i < 34; i++)
        for (int k = 0; k < 2; k++) {
            char text[20];
            snprintf(text, sizeof text, "%d,1;", 600 + i);
            iges_add(&file, 600 + i, 0, 0, 0, "00000000", text);
        }
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_OK(batten_notes_create(200, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_MESSAGE("68 of 69 entities are left out");
    int count = 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        count += strstr(batten_notes_at(notes, i)->text, "this is the first of them") != NULL;
    if (batten_notes_dropped(notes) == 0 && test_cases(10) >= 10)
        CHECK_INT(count, 32);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(what_an_entity_is_for_is_said_by_name)
{
    static const struct {
        const char *status, *words;
    } cases[] = {
        {"00000100",
         "its use is 1, annotation, and not geometry; left out, the first such entity"},
        {"00000200", "its use is 2, a definition, and not geometry; left out, the first"},
        {"00000300", "its use is 3, other, and not geometry; left out, the first such entity"},
        {"00000400", "its use is 4, logic and position, and not geometry; left out, the first"},
        {"00000600", "its use is 6, construction, and not geometry; left out, the first"},
        {"00000700",
         "its use is 7, unknown, and not geometry; left out, the first such entity"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, cases[i].status, IGES_LINE);
        iges_check_left_out(&file, cases[i].words);
    }
}
