/* What is said of IGES files, to the letter and the line; levels and limits. */
#include "exchange/listed.h"
#include "exchange/iges/text.h"

/* ---- the global section ---- */

static const char *with_global(const char *global)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    return iges_end(&file, global);
}

#define LINES "~0: 110 line: 1 read\n"
#define SAID(standard, system, resolution)  \
    "~0: IGES " standard " by 'x', " system \
    ", x; the unit is 0.001 m, the resolution " resolution "\n"

static const struct {
    const char *global, *listing;
} globals[] = {
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,11,0,;",
     SAID("5.3", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,6,0,;",
     SAID("4.0", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,1,0,;",
     SAID("1.0", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,12,0,;",
     SAID("?", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,0,0,;",
     SAID("?", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,-1.,9.,,,11,0,;",
     SAID("5.3", "?", "0") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,x,9.,,,11,0,;",
     SAID("5.3", "y", "0") LINES},
    {"1H,,1H;,1Hx,1Hx,7,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,11,0,;",
     SAID("5.3", "?", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,2.,2,2HMM,1,0.,1Hd,1E-6,9.,,,11,0,;",
     SAID("5.3", "y",
          "1e-06") "0: the model is drawn at scale 2; its own numbers are kept\n" LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,,2,2HMM,1,0.,1Hd,1E-6,9.,,,11,0,;",
     SAID("5.3", "y", "1e-06") LINES},
    {"1H,,1H;,1Hx,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,1HM,1,0.,1Hd,1E-6,9.,,,11,0,;",
     "0: the unit has the flag 2 and the name 'M'; the flag is used\n" SAID("5.3", "y", "1e-06")
         LINES},
};

TEST(what_the_global_section_says_is_remarked)
{
    for (int i = 0; i < COUNT(globals); i++)
        check_listed(with_global(globals[i].global), BATTEN_FORMAT_AUTO, BATTEN_OK,
                     globals[i].listing);
}

/* Of 80 letters all are shown, of 81 the last is not. */
TEST(the_sender_is_shown_up_to_80_letters)
{
    for (int length = 80; length <= 81; length++) {
        char global[300], listing[300], sender[90];
        memset(sender, 's', sizeof sender);
        snprintf(global, sizeof global,
                 "1H,,1H;,%dH%.*s,1Hx,1Hy,1Hx,32,38,6,308,15,1Hx,1.,2,2HMM,1,0.,1Hd,1E-6,9.,,,"
                 "11,0,;",
                 length, length, sender);
        snprintf(listing, sizeof listing, "by '%.80s', y, x", sender);
        batten_notes *notes = NULL;
        batten_model *model = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(read_text(with_global(global), BATTEN_FORMAT_AUTO, notes, &model));
        CHECK(batten_notes_dropped(notes) || has_note(notes, listing));
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(a_file_is_known_by_the_letter_of_its_first_record_that_is_not_blank)
{
    static const struct {
        const char *before;
        int letter;
        const char *number;
        batten_status status;
    } cases[] = {
        {"", 'S', "      1", BATTEN_BAD_FORMAT},
        {"\n  \n", 'S', "      1", BATTEN_BAD_FORMAT},
        {"", 'G', "      1", BATTEN_BAD_FORMAT},
        {"", 'C', "      1", BATTEN_UNSUPPORTED},
        {"", 'B', "      1", BATTEN_UNSUPPORTED},
        {"\xef\xbb\xbf", 'C', "      1", BATTEN_UNSUPPORTED},
        {"\n\n", 'B', "      1", BATTEN_UNSUPPORTED},
        {"", 'C', "    x 1", BATTEN_BAD_FORMAT},
        {"", 'C', "", BATTEN_BAD_FORMAT},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[200];
        batten_model *model = NULL;
        snprintf(text, sizeof text, "%s%-72s%c%s\n", cases[i].before, "x", cases[i].letter,
                 cases[i].number);
        CHECK_STATUS(read_text(text, BATTEN_FORMAT_IGES, NULL, &model), cases[i].status);
        CHECK(model == NULL);
    }
}

/* ---- levels ---- */

/* An entity on that level: iges_add leaves the level 0. */
static int add_on_level(iges_text *file, int type, int form, int level, const char *parameters)
{
    const int id = iges_add(file, type, form, 0, 0, "00000000", parameters);
    char *first = file->directory + (size_t)(file->entries - 1) * 2 * 81, number[9];
    snprintf(number, sizeof number, "%8d", level);
    memcpy(first + 32, number, 8);
    return id;
}

/* Of two names for one level the first counts; a name may say its level itself. */
TEST(a_level_has_the_first_name_that_it_is_given_or_its_number)
{
    static const struct {
        int level;
        const char *layer;
    } lines[] = {{5, "five"}, {3, "three"}, {7, "7"},  {0, ""},
                 {9, "nine"}, {4, "4"},     {12, "12"}};
    iges_text file = iges_begin();
    batten_model *model = NULL;
    add_on_level(&file, 406, 3, 9, "406,2,9,4Hnine;");
    add_on_level(&file, 406, 3, 5, "406,2,5,4Hfive;");
    add_on_level(&file, 406, 3, 5, "406,2,5,5Hother;");
    add_on_level(&file, 406, 3, 0, "406,2,3,5Hthree;");
    add_on_level(&file, 406, 3, 4, "406,2,4,0H;");
    for (int i = 0; i < COUNT(lines); i++)
        add_on_level(&file, 110, 0, lines[i].level, IGES_LINE);
    CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
    CHECK_INT(batten_model_count(model), COUNT(lines));
    for (int i = 0; i < COUNT(lines); i++)
        CHECK_TEXT(batten_model_object(model, i)->layer, lines[i].layer);
    batten_model_unref(model);
}

/* A negative level refers to a list of levels, of which the first counts. */
TEST(an_entity_on_several_levels_is_on_the_first)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    const int list = add_on_level(&file, 406, 1, 0, "406,2,6,8;");
    const int alone = add_on_level(&file, 406, 1, 0, "406,1,2;");
    add_on_level(&file, 110, 0, -list, IGES_LINE);
    add_on_level(&file, 110, 0, -alone, IGES_LINE);
    add_on_level(&file, 110, 0, -99, IGES_LINE);
    CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
    static const char *const layers[] = {"6", "2", ""};
    for (int i = 0; i < 3; i++)
        CHECK_TEXT(batten_model_object(model, i)->layer, layers[i]);
    batten_model_unref(model);
}
