/* The global section: a name whose count is wrong does not cost the model. */
#include "exchange/iges/text.h"
#include "exchange/reading.h"

/* The section with the second name, the file's, as the case has it; the unit is the metre. */
static const char *global_with(const char *name)
{
    static char text[400];
    snprintf(text, sizeof text,
             "1H,,1H;,4Hpart,%s,3HCAD,3H1.0,32,38,6,308,15,1Hx,1.,6,1HM,1,0.,13H260101.000000,"
             "1E-6,9.,,,11,0,;",
             name);
    return text;
}

static const struct {
    const char *name, *note;
} names[] = {
    {"8Hhull.igs", ""},
    {"5Hhull.igs", "a string announces 5 characters and has 8 ('hull.igs')"},
    {"10Hhull.igs", "a string announces 10 characters and has 8 ('hull.igs')"},
    {"9999Hhull.igs", "a string announces 9999 characters and has 8 ('hull.igs')"},
    {"99999999999999999999Hhull.igs", ""} /* not a string at all */,
    {"0Hhull.igs", "a string announces 0 characters and has 8 ('hull.igs')"},
    {"5Ha,b;c.igs", "a string announces 5 characters and has 9 ('a,b;c.igs')"},
    {"5H", "a string announces 5 characters and has 0 ('')"},
    {"20Hhull.igs   ", "a string announces 20 characters and has 8 ('hull.igs')"},
};

TEST(a_wrong_count_of_a_name_in_the_global_section_costs_nothing)
{
    for (int k = 0; k < COUNT(names); k++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        batten_model *model = read_noting(iges_end(&file, global_with(names[k].name)),
                                          BATTEN_FORMAT_AUTO, names[k].note);
        CHECK_INT(batten_model_count(model), 1);
        CHECK_BITS(batten_model_unit_metres(model), 1);
        const batten_box box = batten_curve_box(batten_model_object(model, 0)->curve);
        CHECK_BITS(box.high.z, 6);
        batten_model_unref(model);
    }
}

TEST(the_last_string_of_the_global_section_may_have_a_wrong_count)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    batten_model *model =
        read_noting(iges_end(&file, "1H,,1H;,,,,,32,38,6,308,15,,1.,6,1HM,1,0.,,1E-6,9.,,,11,0,"
                                    "19H260101.000000;"),
                    BATTEN_FORMAT_AUTO, "announces 19 characters and has 13");
    CHECK_BITS(batten_model_unit_metres(model), 1);
    batten_model_unref(model);
}

static const struct {
    const char *global, *message;
} refused[] = {
    {"", "there is no global section"},
    {"x,y", "the global section does not begin with its delimiters"},
    {"1H,", "the global section does not begin with its delimiters"},
    {"1H,,1H;", "the global section does not begin with its delimiters"},
    {"1H,,1H;;", "the global section does not begin with its delimiters"},
    {"1H11H;1", "the global section does not begin with its delimiters"},
    {"1H111H;1", "the global section names '1' and ';' as delimiters"},
    {"1HHH1H;H", "the global section names 'H' and ';' as delimiters"},
    {"1H,,1H,,", "the global section names ',' and ',' as delimiters"},
    {"1H,,1H9,", "the global section names ',' and '9' as delimiters"},
    {"1H++1H;+", "the global section names '+' and ';' as delimiters"},
    {"1Hee1H;e", "the global section names 'e' and ';' as delimiters"},
    {"1H,,1H;,4Hname,1.", "global section: the parameters have no end"},
    {"1H,,1H;,2Hname,x", "global section: the parameters have no end"},
};

TEST(a_global_section_that_is_none_is_refused_with_what_is_wrong)
{
    for (int k = 0; k < COUNT(refused); k++) {
        iges_text file = iges_begin();
        batten_model *model = NULL;
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        CHECK_STATUS(
            read_text(iges_end(&file, refused[k].global), BATTEN_FORMAT_AUTO, NULL, &model),
            BATTEN_BAD_FORMAT);
        CHECK(strncmp(batten_message(), "t: ", 3) == 0); /* the file, and no line */
        CHECK_TEXT(batten_message() + 3, refused[k].message);
    }
}

TEST(a_mended_name_is_noted_word_for_word_without_a_line)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_OK(batten_notes_create(4, &notes));
    CHECK_STATUS(read_text(iges_end(&file, global_with("5Hhull.igs  ")), BATTEN_FORMAT_AUTO,
                           notes, &model),
                 BATTEN_OK);
    if (batten_notes_dropped(notes) == 0) {
        CHECK(batten_notes_count(notes) >= 1);
        CHECK_TEXT(
            batten_notes_at(notes, 0)->text,
            "global section: a string announces 5 characters and has 8 ('hull.igs'); it is "
            "read as it stands");
        CHECK_INT(batten_notes_at(notes, 0)->line, 0);
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}
