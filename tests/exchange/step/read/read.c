/* The whole of reading: what of a file is counted, noted or none of it known. */
#include "exchange/step/read/bent_box.h"

TEST(P4_items_of_unknown_kind_are_counted_by_name)
{
    const char *file = box_with("#990=SHAPE_REPRESENTATION('',(#1000,#1001,#1002),#900);\n"
                                "#1001=BANANA('',4);\n#1002=TEXT_LITERAL('',$);\n");
    check_read(file, BATTEN_PARTLY_READ, "its kind is not read", 6, true);
    check_read(file, BATTEN_PARTLY_READ, "0 read, 1 left out", 6, true);
    check_read(file, BATTEN_PARTLY_READ,
               "annotations of a drawing are not shapes and are not read: 1", 6, true);
}

/* Known by how their names begin, in either case. */
TEST(P4_an_unknown_schema_is_noted)
{
    static const struct {
        const char *schema, *note;
    } cases[] = {
        {"A_U_T_OTIVE_DESIGN", "unknown schema 'A_U_T_OTIVE_DESIGN'; the entities that"},
        {"AUTOMOTIVE_DESIG", "unknown schema 'AUTOMOTIVE_DESIG'; the"},
        {"XAP203", "unknown schema 'XAP203'; the entities that are known are read"},
        {"", "unknown schema ''; the entities that are known are read"},
        {"AUTOMOTIVE_DESIGN", ""},
        {"automotive_design { 1 0 }", ""},
        {"CONFIG_CONTROL_DESIGN", ""},
        {"CONFIGURATION_CONTROL_3D_DESIGN_ED2_MIM_LF", ""},
        {"AP203_CONFIG", ""},
        {"AP214", ""},
        {"AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF", ""},
        {"AP209_MULTI", ""},
        {"AP238_ARM", ""},
        {"INTEGRATED_CNC_SCHEMA", ""}};
    const char *file = box_with("");
    const char *name = strstr(file, "AUTOMOTIVE_DESIGN");
    for (int k = 0; k < COUNT(cases); k++) {
        char *made = test_array(strlen(file) + 100, 1);
        sprintf(made, "%.*s%s%s", (int)(name - file), file, cases[k].schema,
                name + strlen("AUTOMOTIVE_DESIGN"));
        check_read(made, BATTEN_OK, cases[k].note, 6, true);
    }
}

TEST(a_file_of_which_nothing_can_be_read_says_how_many_entities_it_has)
{
    check_none(box_with("#1000=BANANA('box',#181);\n"));
    CHECK_TEXT(batten_message(), "t: its 1 entity could not be read");
    check_none(box_with("#1000=BANANA('box',#181);\n#1001=BANANA('other',#181);\n"
                        "#990=SHAPE_REPRESENTATION('',(#1000,#1001),#900);\n"));
    CHECK_TEXT(batten_message(), "t: its 2 entities could not be read");
}
