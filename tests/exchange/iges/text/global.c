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
