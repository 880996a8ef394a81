/* Parameters that are not the numbers which they should be, and what is said of them. */
#include "exchange/iges/text.h"
#include "exchange/reading.h"

static const struct {
    const char *value, *words;
} odd[] = {
    {"1E999", "parameter 1, '1E999', is too large for a number"},
    {"-1D999", "parameter 1, '-1D999', is too large for a number"},
    {"1000000000000000000000000000000000000000000000000000000000000000000000000000000E400",
     "parameter 1, '1000000000000000000000000000000000000000', is too large for a number"},
    {"12X", "parameter 1, '12X', is not a number"},
    {"1.5.2", "parameter 1, '1.5.2', is not a number"},
    {"3Habc", "parameter 1 is not a number but a string"},
};

/* A line with that as its first coordinate, and a good one. */
static batten_model *read_lines(const char *value, const char *words)
{
    char text[1400];
    iges_text file = iges_begin();
    snprintf(text, sizeof text, "110,%s,2.,3.,4.,5.,6.;", value);
    iges_add(&file, 110, 0, 0, 0, "00000000", text);
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    return read_so(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, BATTEN_PARTLY_READ, words);
}

TEST(a_parameter_that_is_no_number_is_named_with_what_it_is)
{
    for (int k = 0; k < COUNT(odd); k++) {
        batten_model *model = read_lines(odd[k].value, odd[k].words);
        CHECK_INT(batten_model_count(model), 1);
        batten_model_unref(model);
    }
}

/* A double has at most 767 significant digits: texts of up to 1100 characters are looked at as numbers. */
TEST(a_text_longer_than_any_number_is_called_so)
{
    enum { LONGEST = 1100 };
    for (int length = LONGEST; length <= LONGEST + 1; length++) {
        char text[LONGEST + 2];
        memset(text, 'x', sizeof text);
        text[length] = '\0';
        batten_model *model =
            read_lines(text, length > LONGEST ? "is not a number but a long text"
                                              : "xxxx', is not a number");
        batten_model_unref(model);
    }
}
