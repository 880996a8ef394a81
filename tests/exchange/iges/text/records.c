#include "exchange/iges/text.h"

#include <stdlib.h>

static const char *good(void)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    iges_add(&file, 126, 0, 0, 0, "00000000", IGES_CURVE);
    return iges_end(&file, IGES_GLOBAL);
}

/* A copy of a text of 81-byte records that may be bent. */
static char *copy_of(const char *text)
{
    char *copy = test_array(4 * strlen(text) + 1, 1);
    return strcpy(copy, text);
}

/* Both entities of the good file must come out of it. */
static void check_same(const char *text, const char *note)
{
    batten_model *model = read_noting(text, BATTEN_FORMAT_AUTO, note);
    CHECK_INT(batten_model_count(model), 2);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[5], 6.0);
    CHECK_BITS(batten_curve_points(batten_model_object(model, 1)->curve)[3], 1.0);
    batten_model_unref(model);
}

TEST(F3_records_may_end_as_they_like)
{
    const char *text = good();
    const char *const ends[] = {"\n", "\r\n", "\r", "\n\n", "   and more\n"};
    for (int k = 0; k < COUNT(ends); k++) {
        char *bent = test_array(4 * strlen(text) + 1, 1);
        for (const char *at = text; *at; at += 81) {
            strncat(bent, at, 80);
            strcat(bent, ends[k]);
        }
        check_same(bent, "");
    }
    char *bent = copy_of(text);
    bent[strlen(bent) - 1] = '\0';
    check_same(bent, "");
    strcat(bent, "\n\n\x1a");
    check_same(bent, "");
}

TEST(Q1_wrong_sequence_numbers_are_counted_with_a_note)
{
    char *bent = copy_of(good());
    for (char *at = bent; *at; at += 81)
        if (at[72] == 'P')
            memcpy(at + 73, "      7", 7);
    check_same(bent, "the sequence numbers of the P section are wrong");
    bent = copy_of(good());
    for (char *at = bent; *at; at += 81)
        if (at[72] == 'D')
            memcpy(at + 73, "       ", 7);
    check_same(bent, "the sequence numbers of the D section are wrong");
    bent = copy_of(good());
    for (char *at = bent; *at; at += 81)
        for (int k = 73; k < 79 && at[k] == ' '; k++)
            at[k] = '0';
    check_same(bent, "");
}

TEST(Q1_text_after_the_last_record_and_a_missing_start_are_noted)
{
    char *bent = copy_of(good());
    strcat(bent, "ISO-10303-21;\n");
    check_same(bent, "text follows the last record; not read");
    check_same(good() + 81, "the start section is missing");
}

TEST(Q1_a_damaged_record_costs_its_entity_alone)
{
    const struct {
        char section;
        int nth, column;
        char put;
        const char *words;
    } cases[] = {
        {'P', 1, 5, '\t', "it has a tab"},
        {'P', 2, 5, '\t', "its parameters should be in record 2, of 3"},
        {'P', 2, 72, 'X', "column 73 has no letter"},
        {'P', 3, 5, '\t', "record 3 of the P section, line 10, is damaged"},
        {'D', 1, 3, '\t', "its entry in the directory is damaged"},
        {'D', 1, 3, 'x', "its entry in the directory is damaged"},
        {'D', 2, 7, '7', "its entry in the directory is damaged"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char *bent = copy_of(good());
        int nth = 0;
        for (char *at = bent; *at; at += 81)
            if (at[72] == cases[i].section && ++nth == cases[i].nth) {
                at[cases[i].column] = cases[i].put;
                break;
            }
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(20, &notes));
        CHECK_STATUS(read_text(bent, BATTEN_FORMAT_AUTO, notes, &model), BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), 1);
        if (batten_notes_dropped(notes) == 0 && !has_note(notes, cases[i].words))
            CHECK_TEXT(batten_notes_at(notes, batten_notes_count(notes) - 1)->text,
                       cases[i].words);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(Q1_a_missing_record_is_noticed)
{
    char *bent = copy_of(good());
    int nth = 0;
    for (char *at = bent; *at; at += 81)
        if (at[72] == 'P' &&
            ++nth == 2) { /* the second entity has two records, this is its first */
            memmove(at + 0, at + 81, strlen(at + 81) + 1);
            break;
        }
    batten_model *model = NULL;
    CHECK_STATUS(read_text(bent, BATTEN_FORMAT_AUTO, NULL, &model), BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    batten_model_unref(model);
}

/* Numbers that begin, end and are cut at any column, with other tokens among them. */
TEST(N3_numbers_of_IGES_are_the_same_in_any_column)
{
    static const char text[] =
        "126,3,1,0,,1,0,0.,0.,1.,2.25,3.,3.,1.,1.,1.,1.,123.45678901234567,-0."
        "12345678901234568,"
        "1.5E-7,-.5,7,1234567.,1.25D+02, 9007199254740993. ,-0.,0.30000000000000004,-1.E1,"
        "12345678.875,0.,3.,0.,0.,1.,0,0;a comment";
    const double expected[] = {123.45678901234567,
                               -0.12345678901234568,
                               1.5e-7,
                               -0.5,
                               7,
                               1234567,
                               125,
                               9007199254740992,
                               -0.0,
                               0.1 + 0.2,
                               -10,
                               12345678.875};
    for (int blanks = 0; blanks < 130; blanks++) {
        char shifted[sizeof text + 130];
        snprintf(shifted, sizeof shifted, "%*s%s", blanks, "", text);
        iges_text file = iges_begin();
        iges_add(&file, 126, 0, 0, 0, "00000000", shifted);
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
        const batten_curve *curve = batten_model_object(model, 0)->curve;
        for (int i = 0; i < COUNT(expected); i++)
            CHECK_BITS(batten_curve_points(curve)[i], expected[i]);
        CHECK_BITS(batten_curve_knots(curve)[2], 1.0);
        CHECK_BITS(batten_curve_knots(curve)[3], 2.25);
        batten_model_unref(model);
    }
}

/* 400 lines of one record each, of which the end of one may be bent. */
static void check_many(const char *end, int bad, const char *bent, int expected,
                       const char *words)
{
    enum { MANY = 400 };
    iges_text file = iges_begin();
    for (int i = 0; i < MANY; i++)
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    const char *text = iges_end(&file, IGES_GLOBAL);
    char *made = test_array(2 * strlen(text), 1), *to = made;
    for (int nth = 0; *text; text += 81) {
        memcpy(to, text, 80);
        if (text[72] == 'P' && ++nth == bad)
            memcpy(to + 64, bent, 16);
        to += 80;
        strcpy(to, end);
        to += strlen(end);
    }
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(made, BATTEN_FORMAT_AUTO, notes, &model),
                 expected == MANY ? BATTEN_OK : BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), expected);
    for (int i = 0; i < expected; i++)
        CHECK_BITS(batten_curve_points(batten_model_object(model, i)->curve)[5], 6.0);
    CHECK(!words[0] || batten_notes_dropped(notes) > 0 || has_note(notes, words));
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(Q1_one_bad_record_among_many)
{
    check_many("\n", 0, "", 400, "");
    check_many("\r\n", 0, "", 400, "");
    check_many("\r\n", 300, "       1P    299", 400, "the sequence numbers of the P");
    check_many("\n", 310, "       1P    311", 400, "the sequence numbers of the P");
    check_many("\n", 221, "       1X    221", 399, "column 73 has no letter");
    check_many("\n", 400, "       1P    401", 399, "its parameters should be in record 400");
}

TEST(Q2_other_delimiters_are_read_and_nonsense_is_refused)
{
    static const char rest[] = "1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,6,1HM;";
    const char *const openings[] = {"1H,,1H;,", ",,", "1H,,,", ",1H;,", "  1H, , 1H; ,"};
    char global[200];
    for (int k = 0; k < COUNT(openings); k++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
        snprintf(global, sizeof global, "%s%s", openings[k], rest);
        batten_model_unref(read_noting(iges_end(&file, global), BATTEN_FORMAT_AUTO, ""));
    }
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", "110/1./2./3./4./5./6.# and a comment, or; two");
    batten_model *model =
        read_noting(iges_end(&file, "1H//1H#/1Hx/1Hx/1Hx/1Hx/32/38/6/308/15/1Hx/1./2#"),
                    BATTEN_FORMAT_AUTO, "");
    CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[5], 6.0);
    CHECK_BITS(batten_model_unit_metres(model), 0.001);
    batten_model_unref(model);

    const char *const nonsense[] = {"1H11H;1",  "1HHH1H;H", "1H,,1H,,", "1H++1H;+",
                                    "1Hee1H;e", "x,y",      "1H,",      ""};
    for (int k = 0; k < COUNT(nonsense); k++) {
        iges_text bad = iges_begin();
        iges_add(&bad, 110, 0, 0, 0, "00000000", IGES_LINE);
        check_refused(iges_end(&bad, nonsense[k]), BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                      "global");
    }
    iges_text open = iges_begin();
    check_refused(iges_end(&open, "1H,,1H;,1Hx,1Hx"), BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "global section: the parameters have no end");
}

TEST(Q3_strings_may_run_over_records_but_not_over_the_section)
{
    const struct {
        const char *property, *name, *note;
    } cases[] = {
        {"406,1,70H0123456789012345678901234567890123456789012345678901234567890123456789;",
         "0123456789012345678901234567890123456789012345678901234567890123456789", ""},
        {"406,1,0H;", "curve D1", ""},
        {"406,1,1000000000Hx;", "curve D1",
         "its name, D3, cannot be read: a string of 1000000000 characters; the limit is"},
        {"406,1,99999999999999999999Hx;", "curve D1", "its name, D3, cannot be read"},
        {"406,1,-3Habc;", "curve D1",
         "its name, D3, cannot be read: parameter 2 is not a "
         "string"},
        {"406,1,3Habcd;", "curve D1", "a string of 3 characters is followed by 'd'"},
        {"406,1, 3Ha;c , 7;", "a;c", ""},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, "00000000", "110,1.,2.,3.,4.,5.,6.,0,1,3;");
        iges_add(&file, 406, 15, 0, 0, "00010300", cases[i].property);
        batten_model *model =
            read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, cases[i].note);
        CHECK_TEXT(batten_model_object(model, 0)->name, cases[i].name);
        batten_model_unref(model);
    }
}

TEST(N3_numbers_of_IGES_may_have_a_D)
{
    const struct {
        const char *text;
        double value;
    } numbers[] = {{"1D5", 1e5},
                   {"1.D+3", 1000},
                   {"1.5d-2", 0.015},
                   {".5", 0.5},
                   {"5.", 5},
                   {"+1", 1},
                   {"7", 7},
                   {" 2. ", 2},
                   {"", 0},
                   {"-0.", -0.0},
                   {"4.9E-324", 4.9406564584124654e-324}};
    for (int i = 0; i < COUNT(numbers); i++) {
        char text[80];
        snprintf(text, sizeof text, "110,%s,2.,3.,4.,5.,6.;", numbers[i].text);
        batten_model *model = read_noting(iges_one(110, text), BATTEN_FORMAT_AUTO, "");
        CHECK_BITS(batten_curve_points(batten_model_object(model, 0)->curve)[0],
                   numbers[i].value);
        batten_model_unref(model);
    }
    const char *const small[] = {"1E-400", "-1.D-400", "0.1e-330"};
    for (int i = 0; i < COUNT(small); i++) {
        char text[80], words[80];
        snprintf(text, sizeof text, "110,%s,2.,3.,4.,5.,6.;", small[i]);
        snprintf(words, sizeof words, "parameter 1, %s, is too small for a double", small[i]);
        batten_model *model = read_noting(iges_one(110, text), BATTEN_FORMAT_AUTO, words);
        CHECK(batten_curve_points(batten_model_object(model, 0)->curve)[0] == 0);
        batten_model_unref(model);
    }
    const char *const bad[] = {"nan", "inf", "0x1p3", "1e400", "--1", "1 2", "1.2.3", "1H5"};
    for (int i = 0; i < COUNT(bad); i++) {
        char text[80];
        iges_text file = iges_begin();
        snprintf(text, sizeof text, "110,%s,2.,3.,4.,5.,6.;", bad[i]);
        iges_add(&file, 110, 0, 0, 0, "00000000", text);
        iges_check_left_out(&file, "parameter 1");
    }
}

TEST(Q4_wrong_pointers_to_parameters_leave_the_entity_out)
{
    const char *const fields[] = {"      99", "       0", "      -1", "99999999"};
    for (int i = 0; i < COUNT(fields); i++) {
        char *bent = copy_of(good());
        for (char *at = bent; *at; at += 81)
            if (at[72] == 'D') {
                memcpy(at + 8, fields[i], 8);
                break;
            }
        batten_model *model = NULL;
        CHECK_STATUS(read_text(bent, BATTEN_FORMAT_AUTO, NULL, &model), BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), 1);
        batten_model_unref(model);
    }
}

TEST(S4_entries_that_all_share_one_long_text_are_refused)
{
    enum { ENTRIES = 200, POINTS = 2500 };
    if (test_cases(1000) < 1000)
        SKIP("long; its allocations are those of other tests");
    char *parameters = test_array(1 << 16, 1), *text = test_array(1 << 19, 1), *at = parameters;
    at += sprintf(at, "126,%d,1,0,0,1,0,0.,", POINTS);
    for (int i = 0; i <= POINTS; i++)
        at += sprintf(at, "%d.,", i);
    at += sprintf(at, "%d.,", POINTS);
    for (int i = 0; i <= 4 * POINTS + 3; i++)
        at += sprintf(at, "1.,");
    sprintf(at, "0.;");
    iges_text file = {text, test_array(1 << 17, 1), test_array(1 << 18, 1), 0, 0};
    iges_add(&file, 126, 0, 0, 0, "00000000", parameters);
    char directory[163];
    snprintf(directory, sizeof directory, "%.162s", file.directory);
    for (int i = 1; i < ENTRIES; i++)
        strcat(file.directory, directory);
    check_refused(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, BATTEN_TOO_LARGE,
                  "the entries share their parameters");
}
