/* The entries of the directory, field by field. */
#include "exchange/iges/text.h"
#include "exchange/iges/text/records.h"

/* The two records of one line, with this text in columns from 0 on of the first or second. */
static const char *bent(int record, int column, const char *text)
{
    iges_text file = iges_begin();
    iges_add(&file, 110, 0, 0, 0, "00000000", IGES_LINE);
    memcpy(file.directory + 81 * record + column, text, strlen(text));
    return iges_end(&file, IGES_GLOBAL);
}

static bat_iges_entry entry_of(const char *text)
{
    bat_input input;
    bat_iges_file file;
    bat_iges_entry entry = {.id = 0};
    CHECK_OK(bat_input_begin(text, strlen(text), NULL, NULL, NULL, &input));
    const batten_status status = bat_iges_begin(&input, &file);
    if (status == BATTEN_OK) {
        CHECK_INT((long long)file.entries.count, 1);
        entry = *(const bat_iges_entry *)file.entries.items;
    }
    bat_iges_end(&file);
    CHECK_OK(status);
    return entry;
}

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

TEST(each_field_of_an_entry_is_read_from_its_columns)
{
    only_once();
    /* Fields of 8 columns; those of the first record, then those of the second. */
    CHECK_INT(entry_of(bent(0, 8, "      42")).data, 42);
    CHECK_INT(entry_of(bent(0, 32, "      -7")).level, -7);
    CHECK_INT(entry_of(bent(0, 48, "     123")).transform, 123);
    CHECK_INT(entry_of(bent(0, 64, "01020300")).hidden, 1);
    CHECK_INT(entry_of(bent(0, 64, "01020300")).subordinate, 2);
    CHECK_INT(entry_of(bent(0, 64, "01020300")).use, 3);
    CHECK_INT(entry_of(bent(0, 64, "12345600")).hidden, 12);
    CHECK_INT(entry_of(bent(0, 64, "12345600")).subordinate, 34);
    CHECK_INT(entry_of(bent(0, 64, "12345600")).use, 56);
    CHECK_INT(entry_of(bent(0, 64, " 1 2 3 0")).hidden, 1);
    CHECK_INT(entry_of(bent(0, 64, " 1 2 3 0")).use, 3);
    CHECK_INT(entry_of(bent(0, 64, "1 :/3x00")).hidden, 10);
    CHECK_INT(entry_of(bent(0, 64, "1 :/3x00")).subordinate, 0);
    CHECK_INT(entry_of(bent(0, 64, "1 :/3x00")).use, 30);
    CHECK_INT(entry_of(bent(1, 16, "       5")).colour, 5);
    CHECK_INT(entry_of(bent(1, 32, "       2")).form, 2);
    CHECK_INT(entry_of(bent(1, 64, "      17")).subscript, 17);
    const bat_iges_entry plain = entry_of(bent(0, 0, ""));
    CHECK(plain.id == 1 && plain.type == 110 && plain.data == 1 && !plain.is_broken);
    CHECK_INT(plain.line, 4);
}

TEST(a_label_is_without_the_blanks_around_it)
{
    static const struct {
        const char *field, *label;
    } cases[] = {{"  KEEL 1", "KEEL 1"},   {"KEEL    ", "KEEL"}, {"        ", ""},
                 {"12345678", "12345678"}, {"       x", "x"},    {"x       ", "x"}};
    only_once();
    for (int i = 0; i < COUNT(cases); i++)
        CHECK_TEXT(entry_of(bent(1, 56, cases[i].field)).label, cases[i].label);
}

TEST(a_field_is_a_whole_number_with_blanks_around_it_or_broken)
{
    static const struct {
        const char *field;
        int value;
        bool is_broken;
    } cases[] = {
        {"      12", 12, false},  {"12      ", 12, false}, {"   +12  ", 12, false},
        {"     -12", -12, false}, {"        ", 0, false},  {"99999999", 99999999, false},
        {"    1 2 ", 0, true},    {"     1.0", 0, true},   {"     --1", 0, true},
        {"       x", 0, true},    {"      1-", 0, true},   {"     -+1", 0, true},
        {"12345/78", 0, true},    {"1234567:", 0, true}};
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_iges_entry strict = entry_of(bent(1, 32, cases[i].field));
        CHECK_INT(strict.is_broken, cases[i].is_broken);
        if (!cases[i].is_broken)
            CHECK_INT(strict.form, cases[i].value);
        /* Others can do without a level: it is 0 then. */
        const bat_iges_entry loose = entry_of(bent(0, 32, cases[i].field));
        CHECK(!loose.is_broken);
        CHECK_INT(loose.level, cases[i].value);
    }
}

TEST(the_two_records_of_an_entry_name_one_type)
{
    only_once();
    CHECK(entry_of(bent(1, 0, "     111")).is_broken);
    CHECK(!entry_of(bent(1, 0, "110     ")).is_broken);
    CHECK(entry_of(bent(0, 0, "     1x0")).is_broken);
    CHECK(entry_of(bent(0, 8, "       x")).is_broken);
    CHECK(entry_of(bent(0, 48, "       x")).is_broken);
}

/* Two entries; the numbers of their records are left away, do not rise, or one record is cut off. */
TEST(where_numbers_of_the_directory_are_no_good_places_count)
{
    static const struct {
        const char *ends[4]; /* columns 74 to 80 of each record, or NULL: it is missing */
        int ids[2];
        bool is_broken;
    } cases[] = {{{"      1", "      2", "      3", "      4"}, {1, 3}, false},
                 {{"      5", "      6", "     11", "     12"}, {5, 11}, false},
                 {{"       ", "       ", "       ", "       "}, {1, 3}, false},
                 {{"      3", "      4", "      1", "      2"}, {1, 3}, false},
                 {{"      2", "      3", "      4", "      5"}, {1, 3}, false},
                 {{"      1", "      3", "      5", "      6"}, {1, 3}, false},
                 {{"      1", "      2", "      3", NULL}, {1, 3}, true}};
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        bat_input input;
        bat_iges_file file;
        iges_text text = iges_begin();
        for (int k = 0; k < 2; k++)
            iges_add(&text, 110, 0, 0, 0, "00000000", IGES_LINE);
        for (int k = 0; k < 4; k++)
            if (cases[i].ends[k])
                memcpy(text.directory + 81 * k + 73, cases[i].ends[k], 7);
            else
                text.directory[81 * k] = '\0';
        const char *all = iges_end(&text, IGES_GLOBAL);
        CHECK_OK(bat_input_begin(all, strlen(all), NULL, NULL, NULL, &input));
        CHECK_OK(bat_iges_begin(&input, &file));
        CHECK_INT((long long)file.entries.count, 2);
        const bat_iges_entry *entries = file.entries.items;
        for (int k = 0; k < 2; k++)
            CHECK_INT(entries[k].id, cases[i].ids[k]);
        CHECK(!entries[0].is_broken);
        CHECK_INT(entries[1].is_broken, cases[i].is_broken);
        bat_iges_end(&file);
    }
}

TEST(delimiters_are_printed_characters_that_no_number_has)
{
    only_once();
    for (int c = '!'; c < 127; c++) {
        char global[300];
        bat_input input;
        bat_iges_file file;
        iges_text text = iges_begin();
        const bool bad = strchr("0123456789+-.DEHde", c) != NULL || c == ';';
        snprintf(global, sizeof global, "1H%c%c1H;%c;", c, c, c);
        iges_add(&text, 110, 0, 0, 0, "00000000", IGES_LINE);
        const char *all = iges_end(&text, global);
        CHECK_OK(bat_input_begin(all, strlen(all), NULL, NULL, NULL, &input));
        CHECK_OK(bat_iges_begin(&input, &file));
        const batten_status status = bat_iges_global(&file);
        CHECK_INT(status == BATTEN_OK, !bad);
        if (bad)
            CHECK_MESSAGE(c == ';' ? "delimiters" : "as delimiters");
        else
            CHECK(file.delimiters.delimiter == (char)c && file.delimiters.terminator == ';');
        bat_iges_end(&file);
    }
}

/* Level, colour and subscript are of no account for the shape: what is no integer is 0. */
TEST(a_field_that_others_can_do_without_is_0_when_it_is_no_integer)
{
    only_once();
    static const char *const bad[] = {"    x", " 1 2", "1.5", "--3", "3-"};
    for (int i = 0; i < COUNT(bad); i++) {
        char field[9];
        snprintf(field, sizeof field, "%8s", bad[i]);
        CHECK_INT(entry_of(bent(0, 32, field)).level, 0);
        CHECK_INT(entry_of(bent(1, 16, field)).colour, 0);
        CHECK_INT(entry_of(bent(1, 64, field)).subscript, 0);
        CHECK(!entry_of(bent(1, 64, field)).is_broken);
        CHECK(entry_of(bent(0, 48, field)).is_broken);
    }
}
