/* Names, labels and colours of entities. */
#include "exchange/iges/read/attributes.h"

#include "exchange/iges/faces.h"

#define HEAD "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0."

/* ---- names ---- */

TEST(a_name_is_found_among_the_properties)
{
    const char *const tails[] = {"0.,1.,0.,0.,0.,0,1,3;", "0.,1.,0.,0.,0.,2,7,9,2,5,3;"};
    for (int i = 0; i < COUNT(tails); i++) {
        char parameters[200];
        iges_text file = iges_begin();
        snprintf(parameters, sizeof parameters, HEAD ",%s", tails[i]);
        iges_add(&file, 126, 0, 0, -7, "00000000", parameters);
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,11Hkeel, 5;6 H;");
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,3;");
        iges_add(&file, 314, 0, 0, 0, "00000200", "314,25.,50.,100.;");
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        const batten_object *object = batten_model_object(model, 0);
        CHECK_TEXT(object->name, "keel, 5;6 H");
        CHECK(object->colour[0] == 0.25 && object->colour[1] == 0.5 && object->colour[2] == 1);
        batten_model_unref(model);
    }
}

TEST(wrong_pointers_to_names_and_colours_are_ignored)
{
    static const struct {
        const char *tail, *note;
    } cases[] = {{"0,1,1;", ""},
                 {"0,1,2;", "a property of it: 2 is not the odd number of an entity"},
                 {"0,1,99;", "a property of it: it refers to entity D99, which is missing"},
                 {"0,7,1;", ""},
                 {"-5;", ""},
                 {"0,1,1Hx;", ""},
                 {"9;", ""},
                 {"0,1,3;", ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        char parameters[200];
        iges_text file = iges_begin();
        snprintf(parameters, sizeof parameters, HEAD ",0.,1.,0.,0.,0.,%s", cases[i].tail);
        iges_add(&file, 126, 0, 0, 0, "00000000", parameters);
        iges_add(&file, 406, 1, 0, 0, "00010300", "406,1,5;");
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_TEXT(batten_model_object(model, 0)->name, "curve D1");
        CHECK(!batten_model_object(model, 0)->has_colour);
        batten_model_unref(model);
    }
}

/* ---- colours ---- */

/* One note says which entity is the first, where it stands and what is wrong, and of how many.
 */
TEST(Q4_wrong_colours_are_none_and_said_once)
{
    static const struct {
        int colour;
        const char *why;
    } cases[] = {{9, "colours have the numbers 0 to 8"},
                 {-99, "it refers to entity D99, which is missing"},
                 {-4, "4 is not the odd number of an entity"},
                 {-3, "it refers to entity D3 as type 314, which is of type 124"},
                 {-5, "D5: part 2 is 120 percent"},
                 {-7, "D7: parameter 2 is not a number but a string"}};
    for (int i = 0; i < COUNT(cases); i++)
        for (int count = 1; count < 4; count += 2) {
            char words[200];
            iges_text file = iges_begin();
            iges_add(&file, 110, 0, 0, cases[i].colour, "00000000", IGES_LINE);
            iges_add(&file, 124, 0, 0, 0, "00000000",
                     "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,0.;");
            iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,120.,0.;");
            iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,1Hx,0.;");
            for (int k = 1; k < count; k++)
                iges_add(&file, 110, 0, 0, cases[i].colour, "00000000", IGES_LINE);
            snprintf(words, sizeof words, "its colour is %d: %s; taken as none%s",
                     cases[i].colour, cases[i].why,
                     count > 1 ? "; so of 3 entities in all" : "");
            iges_check_wrong(&file, "#1 ", 4, words);
        }
}

TEST(each_colour_has_its_number)
{
    static const double colours[9][3] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                         {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    iges_text file = iges_begin();
    for (int i = 0; i < 9; i++)
        iges_add(&file, 110, 0, 0, i, "00000000", IGES_LINE);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    for (int i = 0; i < 9; i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK_INT(object->has_colour, i > 0);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(object->colour[k], colours[i][k]);
    }
    batten_model_unref(model);
}

/* Percents at both ends of what they may be, and beyond. */
TEST(a_colour_of_percents_is_from_0_to_100)
{
    static const struct {
        const char *percents, *note;
    } cases[] = {{"314,0.,100.,50.;", ""},
                 {"314,-0.5,0.,0.;", "part 1 is -0.5 percent"},
                 {"314,0.,0.,100.5;", "part 3 is 100.5 percent"},
                 {"314,1E400,0.,0.;", "D3: parameter 1, '1E400', is too large"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, -3, "00000000", IGES_LINE);
        iges_add(&file, 314, 0, 0, 0, "00000200", cases[i].percents);
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->has_colour, i == 0);
        CHECK_BITS(object->colour[1], i == 0 ? 1.0 : 0.0);
        CHECK_BITS(object->colour[2], i == 0 ? 0.5 : 0.0);
        batten_model_unref(model);
    }
}

/* Label and subscript of the entity added last: columns 57 to 64 and 65 to 72. */
static void set_label(const iges_text *file, const char *label)
{
    memcpy(file->directory + (size_t)(file->entries - 1) * 2 * 81 + 81 + 56, label, 16);
}

TEST(an_entity_without_a_name_is_called_by_its_label_or_its_kind_and_number)
{
    static const struct {
        int type;
        const char *parameters, *label, *name;
    } cases[] = {{110, IGES_LINE, "                ", "curve D1"},
                 {128, IGES_SURFACE, "                ", "surface D1"},
                 {116, "116,1.,2.,3.;", "                ", "points D1"},
                 {110, IGES_LINE, "    keel       0", "keel"},
                 {110, IGES_LINE, "keel          12", "keel 12"},
                 {110, IGES_LINE, "LongName       1", "LongName 1"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, cases[i].type, 0, 0, 0, "00000000", cases[i].parameters);
        set_label(&file, cases[i].label);
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        CHECK_TEXT(batten_model_object(model, 0)->name, cases[i].name);
        batten_model_unref(model);
    }
    iges_text file = iges_begin();
    iges_add(&file, 408, 0, 0, 0, "00000000", "408,3,0.,0.,0.,1.;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,0;");
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    CHECK_TEXT(batten_model_object(model, 0)->name, "instance D1");
    batten_model_unref(model);
}

/* Of several properties the first that names it counts; one that is not a string is noted. */
TEST(a_name_that_cannot_be_read_is_noted_and_the_next_taken)
{
    static const struct {
        const char *tail, *name, *note;
    } cases[] = {
        {",0,1,3;", "curve D1", "its name, D3, cannot be read: parameter 2 is not a string"},
        {",0,2,3,5;", "keel", "its name, D3, cannot be read"},
        {",0,2,5,7;", "keel", ""},
        {",0,3,9,5,7;", "keel", ""},
        {",2,1,1,3,7,5,11;", "stem", ""},
        {",0,2,5;", "curve D1", ""},
        {",-1,1,5;", "curve D1", ""},
        {",0,1,11;", "curve D1",
         "its name, D11, cannot be read: its parameters are those of type 110"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[100] = "110,1.,2.,3.,4.,5.,6.";
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", strcat(text, cases[i].tail));
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,7;");      /* 3 */
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,4Hkeel;"); /* 5 */
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,4Hstem;"); /* 7 */
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,;");       /* 9 */
        iges_add(&file, 406, 15, 0, 0, "00010300", "110,1,4Hwale;"); /* 11 */
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_TEXT(batten_model_object(model, 0)->name, cases[i].name);
        batten_model_unref(model);
    }
}

/* The parameters of one entity of each type without what may follow, and those that it refers to;
 * the name is the property D21. */
static const struct {
    int type, form;
    const char *parameters;
} owners[] = {
    {100, 0, "100,0.,0.,0.,1.,0.,0.,1."},
    {102, 0, "102,2,5,7"},
    {104, 1, "104,1.,0.,1.,0.,0.,-1.,0.,1.,0.,0.,1."},
    {106, 1, "106,1,2,0.,1.,2.,3.,4."},
    {106, 12, "106,2,2,1.,2.,3.,4.,5.,6."},
    {106, 3, "106,3,1,1.,2.,3.,4.,5.,6."},
    {108, 1, "108,0.,0.,1.,0.,13,0.,0.,0.,1."},
    {110, 0, "110,1.,2.,3.,4.,5.,6."},
    {112, 0,
     "112,3,0,3,1,0.,1.,0.,1.,0.,0.,0.,0.,0.,0.,0.,0.,0.,0.,1.,1.,0.,0.,0.,0.,0.,0.,"
     "0.,0.,0.,0."},
    {116, 0, "116,1.,2.,3.,0"},
    {118, 1, "118,5,9,0,0"},
    {120, 0, "120,9,5,0.,1."},
    {122, 0, "122,5,1.,1.,1."},
    {126, 0, "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,1.,0.,0.,0.,1.,1.,1.,0.,1.,0.,0.,1."},
    {128, 0,
     "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,2.,0.,0.,0.,"
     "3.,0.,2.,3.,1.,0.,1.,0.,1."},
    {140, 0, "140,0.,0.,1.,.5,11"},
    {143, 0, "143,0,11,1,15"},
    {144, 0, "144,11,1,0,17"},
    {144, 0, "144,11,0,0,0"},
    {408, 0, "408,19,0.,0.,0.,1."},
};

TEST(a_name_stands_after_all_parameters_of_each_type)
{
    for (int i = 0; i < COUNT(owners); i++) {
        char text[400];
        iges_text file = iges_begin();
        iges_add(&file, 124, 0, 0, 0, "00000000", "124,1.,,,,,1.,,,,,1.,;");    /* 1 */
        iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,0.,0.;");             /* 3 */
        iges_add(&file, 110, 0, 0, 0, "00010000", "110,1.,1.,0.,3.,1.,0.;");    /* 5 */
        iges_add(&file, 110, 0, 0, 0, "00010000", "110,3.,1.,0.,3.,3.,0.;");    /* 7 */
        iges_add(&file, 110, 0, 0, 0, "00010000", "110,0.,0.,0.,0.,0.,1.;");    /* 9 */
        iges_add(&file, 128, 0, 0, 0, "00010000", IGES_SQUARE);                 /* 11 */
        iges_add(&file, 100, 0, 0, 0, "00010000", "100,0.,2.,2.,3.,2.,3.,2.;"); /* 13 */
        iges_add(&file, 141, 0, 0, 0, "00010000", "141,0,0,11,1,13,1,0;");      /* 15 */
        iges_add(&file, 142, 0, 0, 0, "00010000", "142,0,11,0,13,2;");          /* 17 */
        iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,0;");              /* 19 */
        iges_add(&file, 406, 15, 0, 0, "00010300", "406,1,4Hkeel;");            /* 21 */
        snprintf(text, sizeof text, "%s,0,1,21;", owners[i].parameters);
        iges_add(&file, owners[i].type, owners[i].form, 0, 0, "00000000", text); /* 23 */
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
        const int last = batten_model_count(model) - 1;
        CHECK_TEXT(batten_model_object(model, last)->name, "keel");
        batten_model_unref(model);
    }
}

/* Of a model and of a definition; blanks behind a name are no part of it. */
TEST(a_definition_is_called_without_the_blanks_behind_its_name)
{
    static const struct {
        const char *definition, *name;
    } cases[] = {{"308,0,5Hkit  ,0;", "kit"},
                 {"308,0,4H kit,0;", " kit"},
                 {"308,0,3H   ,0;", ""},
                 {"308,0,,0;", ""}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 408, 0, 0, 0, "00000000", "408,3,0.,0.,0.,1.;");
        iges_add(&file, 308, 0, 0, 0, "00000200", cases[i].definition);
        batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
        CHECK_TEXT(batten_model_name(batten_model_object(model, 0)->definition), cases[i].name);
        batten_model_unref(model);
    }
}
