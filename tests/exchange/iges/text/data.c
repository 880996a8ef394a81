/* The parameter section: numbers of records, runs of them, and what an entry finds there. */
#include "exchange/iges/text/data.h"
#include "exchange/iges/text.h"

/* ---- records ---- */

/* Columns 73 on of a record, and its sequence number. */
static const struct {
    const char *end;
    int number;
} sequences[] = {
    {"P      7", 7},  {"P0000007", 7},  {"P1234567", 1234567}, {"P       ", -1},
    {"P7      ", -1}, {"P  1 2  ", -1}, {"P     x7", -1},      {"P     -7", -1},
    {"P  12", 12},    {"P", -1},        {"P      0", 0},       {"P      9123", 9},
    {"P     :7", -1}, {"P     /7", -1}, {"X    305", 305},     {"P 9", 9},
};

TEST(the_number_of_a_record_stands_in_its_last_seven_columns)
{
    for (int i = 0; i < COUNT(sequences); i++) {
        char record[100];
        snprintf(record, sizeof record, "%-72s%s", "5,5", sequences[i].end);
        CHECK_INT(bat_iges_sequence_number((bat_span){record, strlen(record)}),
                  sequences[i].number);
    }
}

TEST(columns_that_a_record_does_not_have_are_blank)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz"
                                  "abcdefghijklmnopqrstuvwxyz";
    static const size_t lengths[] = {0, 1, 63, 64, 65, 72, 78};
    bat_input input;
    bat_list list = {.size = 1};
    size_t count = 0;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    for (int i = 0; i < COUNT(lengths); i++)
        for (size_t columns = DATA_COLUMNS; columns <= GLOBAL_COLUMNS; columns += 8) {
            CHECK_OK(bat_iges_append(&input, &list, (bat_span){letters, lengths[i]}, columns));
            if (list.count < count + columns)
                SKIP("for want of memory");
            const char *made = (const char *)list.items + list.count - columns;
            for (size_t k = 0; k < columns; k++)
                CHECK_INT(made[k], k < lengths[i] ? letters[k] : ' ');
            count = list.count;
        }
    bat_release(list.items);
}

/* ---- runs ---- */

enum { RECORDS = 24 };

/* Records of a P section from this number on; the text and a file around it. */
typedef struct {
    char text[RECORDS * (RECORD + 2) + 1];
    bat_input input;
    bat_iges_file file;
} section;

static void begin_section(section *s, int first, bool padded, const char *end)
{
    s->text[0] = '\0';
    for (int i = 0; i < RECORDS; i++) {
        char number[8];
        snprintf(number, sizeof number, padded ? "%07d" : "%7d", (first + i) % 10000000);
        snprintf(s->text + strlen(s->text), RECORD + 3, "%-64s%8dP%7s%s", "110,1.,2.;", 1,
                 number, end);
    }
    CHECK_OK(bat_input_begin(s->text, strlen(s->text), NULL, NULL, NULL, &s->input));
    s->file = (bat_iges_file){
        .input = &s->input, .delimiters = {',', ';'}, .runs = {.size = sizeof(bat_iges_run)}};
}

/* Add the first records one by one, and as many of the others as go on with them. */
static size_t add_all(section *s, size_t stride, int one_by_one, size_t most)
{
    s->file.runs.count = s->file.data_count = 0;
    s->file.tail = 0;
    s->file.number = 0;
    for (int i = 0; i < one_by_one; i++)
        CHECK_OK(bat_iges_add_data(&s->file, (bat_span){s->text + stride * (size_t)i, RECORD},
                                   40 + i, false));
    return bat_iges_add_to_run(&s->file, stride * (size_t)one_by_one, 39 + one_by_one, most);
}

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

TEST(records_whose_numbers_count_on_are_one_run_over_every_power_of_ten)
{
    static const int firsts[] = {1, 95, 990, 9980, 99990, 999980, 9999970};
    static const char *const ends[] = {"\n", "\r\n"};
    only_once();
    for (int i = 0; i < 4 * COUNT(firsts); i++) {
        section s;
        const int first = firsts[i / 4];
        const size_t stride = RECORD + strlen(ends[i / 2 % 2]);
        begin_section(&s, first, i % 2 == 1, ends[i / 2 % 2]);
        CHECK_INT((long long)add_all(&s, stride, 2, 1000), RECORDS - 2 - (i / 2 % 2 == 0));
        CHECK_INT((long long)add_all(&s, stride, 3, 7), 7);
        const bat_iges_run *run = s.file.runs.items;
        CHECK_INT((long long)s.file.runs.count, 1);
        CHECK_INT((long long)s.file.data_count, 10);
        CHECK(run->at == 0 && run->stride == stride && run->place == 0 && run->count == 10);
        CHECK(run->number == first && run->line == 40 && run->columns == 64);
        CHECK_INT(s.file.number, first + 9);
        CHECK(!run->is_damaged);
        bat_release(s.file.runs.items);
    }
}

/* One character is bent in the sixth record: those before it go on, and it does not. */
TEST(a_run_ends_before_a_record_that_does_not_count_on)
{
    static const struct {
        int column;
        char put;
    } cases[] = {{79, '9'}, {72, 'D'}, {70, '\t'}, {0, '\x01'}, {73, '1'}};
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        section s;
        begin_section(&s, 1, false, "\n");
        s.text[81 * 5 + cases[i].column] = cases[i].put;
        CHECK_INT((long long)add_all(&s, 81, 2, 1000), 3);
        CHECK_INT((long long)s.file.data_count, 5);
        bat_release(s.file.runs.items);
    }
}

/* Asked for records at another place, behind another line, or after another number than the last: none go on. */
TEST(nothing_goes_on_with_a_run_that_does_not_end_there)
{
    only_once();
    for (int i = 0; i < 6; i++) {
        section s;
        begin_section(&s, 1, false, "\n");
        add_all(&s, 81, i == 4 ? 1 : 2, 0);
        bat_iges_run *run = s.file.runs.items;
        const size_t next = 81 * run->count, at = i == 1 ? next + 81 : next;
        const int line = 39 + (int)run->count;
        s.file.number += i == 3;
        run->is_damaged = i == 5;
        CHECK_INT((long long)bat_iges_add_to_run(&s.file, at, i == 2 ? line + 1 : line, 5),
                  i == 0 ? 5 : 0);
        bat_release(s.file.runs.items);
        bat_iges_file none = {.input = &s.input, .runs = {.size = sizeof(bat_iges_run)}};
        CHECK_INT((long long)bat_iges_add_to_run(&none, 0, 1, 5), 0);
    }
}

/* One by one: a damaged record, a jump of numbers, lines or places, and a short one stand for themselves. */
TEST(records_that_do_not_go_on_begin_runs_of_their_own)
{
    static const struct {
        int at[2], numbers[2], lines[2];
        size_t length;
        bool is_damaged;
        size_t runs;
    } cases[] = {
        {{0, 1}, {1, 2}, {5, 6}, RECORD, false, 1}, {{0, 1}, {1, 3}, {5, 6}, RECORD, false, 2},
        {{0, 1}, {2, 1}, {5, 6}, RECORD, false, 2}, {{0, 1}, {1, 2}, {5, 7}, RECORD, false, 2},
        {{0, 1}, {1, 2}, {5, 6}, RECORD, true, 2},  {{0, 2}, {1, 2}, {5, 6}, RECORD, false, 1},
        {{0, 1}, {1, 2}, {5, 6}, 63, false, 2},
    };
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        section s;
        begin_section(&s, 1, false, "\n");
        for (int k = 0; k < 2; k++) {
            char *record = s.text + 81 * cases[i].at[k];
            char number[9];
            snprintf(number, sizeof number, "%7d", cases[i].numbers[k]);
            memcpy(record + 73, number, 7);
            CHECK_OK(bat_iges_add_data(&s.file,
                                       (bat_span){record, k ? cases[i].length : RECORD},
                                       cases[i].lines[k], k && cases[i].is_damaged));
        }
        const bat_iges_run *runs = s.file.runs.items;
        CHECK_INT((long long)s.file.runs.count, (long long)cases[i].runs);
        CHECK_INT((long long)s.file.data_count, 2);
        if (cases[i].runs == 2) {
            CHECK(runs[1].place == 1 && runs[1].count == 1 &&
                  runs[1].line == cases[i].lines[1]);
            CHECK_INT(runs[1].is_damaged, cases[i].is_damaged);
            CHECK_INT(runs[1].columns, cases[i].length < 64 ? 63 : 64);
            CHECK(cases[i].length == RECORD || runs[1].number == -1);
            CHECK(!cases[i].is_damaged || runs[1].number == -1);
        } else {
            CHECK_INT((long long)runs[0].stride, 81 * cases[i].at[1]);
        }
        bat_release(s.file.runs.items);
    }
}

/* A record without a number has none to count on from; the next has its own. */
TEST(the_number_behind_a_record_without_one_is_read_and_not_counted)
{
    static const struct {
        const char *first, *second;
        int number;
    } cases[] = {{"       ", "      1", 1},  {"      -", "      .", -1},
                 {"      x", "      y", -1}, {"      0", "      1", 1},
                 {"      7", "      8", 8},  {"9999999", "      0", 0}};
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        section s;
        begin_section(&s, 1, false, "\n");
        memcpy(s.text + 73, cases[i].first, 7);
        memcpy(s.text + 81 + 73, cases[i].second, 7);
        for (int k = 0; k < 2; k++)
            CHECK_OK(bat_iges_add_data(&s.file, (bat_span){s.text + 81 * (size_t)k, RECORD},
                                       5 + k, false));
        CHECK_INT(s.file.number, cases[i].number);
        bat_release(s.file.runs.items);
    }
}

TEST(numbers_that_do_not_rise_give_way_to_places_with_a_note_of_the_line)
{
    static const struct {
        int numbers[4], line; /* -1: damaged; the line of the note, 0 for none */
        int kept[4];
    } cases[] = {
        {{1, 5, 7, 20}, 0, {1, 5, 7, 20}},   {{1, 5, 5, 20}, 102, {1, 2, 3, 4}},
        {{1, 5, 4, 20}, 102, {1, 2, 3, 4}},  {{0, 5, 6, 20}, 100, {1, 2, 3, 4}},
        {{1, -1, 7, 20}, 0, {1, 1, 7, 20}},  {{-1, 3, 7, 20}, 0, {0, 3, 7, 20}},
        {{4, -1, 4, 20}, 102, {1, 2, 3, 4}}, {{1, 2, 3, 3}, 103, {1, 2, 3, 4}},
    };
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        batten_notes *notes = NULL;
        bat_input input;
        bat_iges_run runs[4];
        CHECK_OK(batten_notes_create(3, &notes));
        CHECK_OK(bat_input_begin("", 0, NULL, NULL, notes, &input));
        for (int k = 0; k < 4; k++)
            runs[k] = (bat_iges_run){.place = (size_t)k,
                                     .count = 1,
                                     .number = cases[i].numbers[k],
                                     .line = 100 + k,
                                     .is_damaged = cases[i].numbers[k] < 0};
        bat_iges_file file = {.input = &input, .runs = {.items = runs, .count = 4}};
        bat_iges_number_data(&file);
        for (int k = 0; k < 4; k++)
            CHECK_INT(runs[k].number, cases[i].kept[k]);
        CHECK_INT(batten_notes_count(notes), cases[i].line > 0);
        if (cases[i].line > 0) {
            CHECK_INT(batten_notes_at(notes, 0)->line, cases[i].line);
            CHECK_TEXT(
                batten_notes_at(notes, 0)->text,
                "the sequence numbers of the P section are wrong; the records are counted");
        }
        batten_notes_free(notes);
    }
}

/* ---- the parameters of an entry ---- */

/* Four records; '-' leaves one out, '?' is a damaged one. The entry begins with record `data`. */
static const struct {
    const char *records[4];
    int data;
    const char *message; /* or NULL, when its last parameter is 7 */
} entries[] = {
    {{"1.,", "2.,", "3.,7.;", "9.;"}, 1, NULL},
    {{"9.;", "1.,", "3.,", "  7.;"}, 2, NULL},
    {{"9.;", "9.;", "9.;", "7.;"}, 4, NULL},
    {{"9.;", "9.;", "9.;", "7.;"}, 5, "its parameters should be in record 5, of 4"},
    {{"9.;", "9.;", "9.;", "7.;"}, 0, "its parameters should be in record 0, of 4"},
    {{"9.;", "9.;", "-", "7.;"}, 3, "its parameters should be in record 3, of 3"},
    {{"1.,", "2.,", "-", "7.;"}, 1, "record 3 of the P section is missing"},
    {{"-", "1.,", "-", "7.;"}, 2, "record 3 of the P section is missing"},
    {{"1.,", "?", "3.,", "7.;"}, 1, "record 2 of the P section, line 12, is damaged"},
    {{"1.,", "2.;", "?", "7.;"}, 1, ""},
    {{"1.,", "2.,", "?", "7.;"}, 4, NULL},
    {{"1.,", "2.,", "3.,", "4.,"}, 2, "the parameters have no end"},
    {{"9.;", "1.,", "3.E0,", "7.;"}, 2, NULL},
    {{"110,4Ha;", "c,7.;", "9.;", "9.;"}, 1, "a string of 4 characters is followed by 'c'"},
    {{"110,3Ha;b, 7.;", "9.;", "9.;", "9.;"}, 1, NULL},
    {{"1.,3Hab;,2.,", "3.,", "4.,7.;", "9.;"}, 1, NULL},
    {{"1.,2.,3Hab;,", "3.,", "4.,", "7. "}, 1, "the parameters have no end"},
    {{"1.,", "2.,", "3Habcd,", "7.;"}, 3, "a string of 3 characters is followed by 'd'"},
};

static size_t fill_records(bat_iges_file *file, char *text, const char *const *records)
{
    size_t count = 0;
    for (int k = 0; k < 4; k++) {
        if (records[k][0] == '-')
            continue;
        char *record = text + 81 * count;
        snprintf(record, 82, "%-64s%8dP%6c%c\n", records[k], 1, ' ', '1' + k);
        CHECK_OK(
            bat_iges_add_data(file, (bat_span){record, RECORD}, 11 + k, records[k][0] == '?'));
        count++;
    }
    return count;
}

TEST(an_entry_has_the_records_from_its_first_to_its_terminator)
{
    only_once();
    for (int i = 0; i < COUNT(entries); i++) {
        static char text[81 * 4 + 1];
        bat_input input;
        memset(text, ' ', sizeof text);
        CHECK_OK(bat_input_begin(text, sizeof text, NULL, NULL, NULL, &input));
        bat_iges_file file = {
            .input = &input, .delimiters = {',', ';'}, .runs = {.size = sizeof(bat_iges_run)}};
        fill_records(&file, text, entries[i].records);
        bat_iges_number_data(&file);
        bat_iges_parameters parameters;
        bat_iges_parameters_begin(&parameters);
        const bat_iges_entry entry = {.data = entries[i].data};
        const batten_status status = bat_iges_read_parameters(&file, &entry, &parameters);
        const bool is_good = !entries[i].message || !entries[i].message[0];
        CHECK_STATUS(status, is_good ? BATTEN_OK : BATTEN_BAD_FORMAT);
        if (!is_good)
            CHECK_TEXT(batten_message(), entries[i].message);
        double last = 0;
        CHECK_OK(bat_iges_real(&parameters, bat_iges_count_of(&parameters) - 1, &last));
        if (!entries[i].message)
            CHECK_BITS(last, 7);
        bat_iges_parameters_end(&parameters);
        bat_release(file.runs.items);
    }
}

TEST(an_entry_for_which_there_is_no_memory_says_so)
{
    only_once();
    static char text[81 * 4 + 1];
    static const char *const records[4] = {"1.,", "2.,", "3.,7.;", "9.;"};
    bat_input input;
    bat_iges_parameters parameters;
    CHECK_OK(bat_input_begin(text, sizeof text, NULL, NULL, NULL, &input));
    bat_iges_file file = {
        .input = &input, .delimiters = {',', ';'}, .runs = {.size = sizeof(bat_iges_run)}};
    fill_records(&file, text, records);
    bat_iges_number_data(&file);
    bat_iges_parameters_begin(&parameters);
    test_fail_allocation(1);
    const batten_status status =
        bat_iges_read_parameters(&file, &(bat_iges_entry){.data = 1}, &parameters);
    test_fail_allocation(0);
    CHECK_INT(status, BATTEN_OUT_OF_MEMORY);
    bat_iges_parameters_end(&parameters);
    bat_release(file.runs.items);
}
