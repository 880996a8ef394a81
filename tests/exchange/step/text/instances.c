#include "exchange/step/parsing.h"

/* Two points and a line between them must come out of every way to write them. */
#define POINTS "#1=CARTESIAN_POINT('a',(1.,2.,3.5));\n#2=CARTESIAN_POINT('b',(-4.E1,5,+6.));\n"

static void check_points(const char *text, const char *note, int left_out)
{
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, text));
    CHECK_INT(t.file.instances.count, 2);
    const double expected[2][3] = {{1, 2, 3.5}, {-40, 5, 6}};
    for (int i = 0; i < 2; i++) {
        const bat_step_record *point =
            bat_step_as(&t.file, step_find(&t, (uint64_t)i + 1), "CARTESIAN_POINT");
        int count = 0;
        size_t at = 0;
        char name[8];
        CHECK(point != NULL);
        CHECK_INT(bat_step_argument_count(&t.file, point), 2);
        CHECK_OK(bat_step_get_string(&t.file, point, 0, sizeof name, name));
        CHECK_TEXT(name, i ? "b" : "a");
        CHECK_OK(bat_step_get_list(&t.file, point, 1, &count, &at));
        CHECK_INT(count, 3);
        for (int k = 0; k < 3; k++) {
            double value = 0;
            CHECK_OK(bat_step_item_real(&t.file, point, &at, &value));
            CHECK_BITS(value, expected[i][k]);
        }
    }
    step_check_note(&t, note);
    CHECK_INT(t.input.left_out, left_out);
    CHECK(!t.input.is_cut);
    step_end(&t);
}

TEST(step_text_has_no_fixed_layout)
{
    check_points(step_whole(POINTS), "", 0);
    check_points(step_whole("#2=CARTESIAN_POINT('b',(-40.,5.0,6.E+0));"
                            "#1 = CARTESIAN_POINT ( 'a' , ( 1. ,2.,3.5 ) ) ;"),
                 "", 0);
    check_points(
        step_whole("/* a ';' in it */#1/**/=/***/CARTESIAN_POINT/* ' */('a'/*,*/,\n"
                   "(1.,/* ) */2.,\t3.5))\n\n;#2=CARTESIAN_POINT('b',(-40.,5.,6.)/**/);"
                   "/* at the end */"),
        "", 0);
    check_points("ISO-10303-21;HEADER;/* here */FILE_SCHEMA(('X'));ENDSEC;/* and; here */DATA;"
                 "#1=CARTESIAN_POINT('a',(1.,2.,3.5));ENDSEC;DATA('x',('y'));"
                 "#2=CARTESIAN_POINT('b',(-40.,5.,6.));ENDSEC;END-ISO-10303-21;",
                 "", 0);
    check_points("ISO-10303-21;HEADER;ENDSEC;ANCHOR;<a>=#1;ENDSEC;REFERENCE;#9=<b#c>;ENDSEC;"
                 "DATA;" POINTS "ENDSEC;SIGNATURE;MIIB'#+/=\nENDSEC;END-ISO-10303-21;",
                 "", 0);
}

TEST(F3_step_lines_may_end_as_they_like)
{
    const char *const ends[] = {"\r\n", "\r", " ", "\n\n"};
    const char *text = step_whole(POINTS);
    for (int k = 0; k < COUNT(ends); k++) {
        char *bent = test_array(2 * strlen(text) + 1, 1), *to = bent;
        for (const char *at = text; *at; at++)
            if (*at == '\n')
                to = strcpy(to, ends[k]) + strlen(ends[k]);
            else
                *to++ = *at;
        check_points(bent, "", 0);
        strcat(bent, "\n \x1a");
        check_points(bent, "", 0);
    }
}

TEST(F4_a_byte_order_mark_is_skipped_and_names_keep_their_bytes)
{
    const char *text = step_whole(POINTS "#7=X('a\xfcg\xc3\xbc');");
    char *marked = test_array(strlen(text) + 4, 1), name[16];
    strcat(strcpy(marked, "\xef\xbb\xbf"), text);
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, marked));
    CHECK_OK(bat_step_get_string(&t.file, bat_step_first(&t.file, step_find(&t, 7)), 0,
                                 sizeof name, name));
    CHECK_TEXT(name, "a\xfcg\xc3\xbc");
    step_check_note(&t, "");
    step_end(&t);
}

TEST(step_leniencies_are_noted_once)
{
    check_points(step_whole("#1=cartesian_point('a',(1.,2.,3.5));\n"
                            "#2=Cartesian_Point('b',(-40.,5.,6.));"),
                 "keywords are in lower case", 0);
    check_points(step_whole("#1=CARTESIAN_POINT('\na\r\n',(1.,2.,3.5));\n"
                            "#2=CARTESIAN_POINT('b',(-40.,5.,6.));"),
                 "a string continues over the end of a line", 0);
    check_points(step_whole("#1=CARTESIAN_POINT('a',(1.,2.,3.5));\n"
                            "#2=CARTESIAN_POINT('b',(-40.,+.5E1,6.));"),
                 "no digit before its point", 0);
}

TEST(P6_missing_parts_of_a_step_file_are_noted)
{
    check_points(STEP_HEAD POINTS "ENDSEC;\n", "END-ISO-10303-21; is missing", 0);
    check_points(STEP_HEAD POINTS "END-ISO-10303-21;\n", "has no ENDSEC", 0);
    check_points("ISO-10303-21;DATA;" POINTS STEP_TAIL, "", 0);
    check_points("DATA;" POINTS STEP_TAIL, "", 0);
    check_points(POINTS STEP_TAIL, "outside a DATA section", 0);
    step_text_file t = {.notes = NULL};
    CHECK_STATUS(step_begin(&t, "ISO-10303-21;HEADER;ENDSEC;END-ISO-10303-21;"),
                 BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("there is no DATA section");
    CHECK_STATUS(step_begin(&t, " \n"), BATTEN_BAD_FORMAT);
    CHECK_STATUS(step_begin(&t, ""), BATTEN_BAD_FORMAT);
    step_end(&t);
}

TEST(P6_the_header_says_who_wrote_it)
{
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, step_whole("")));
    CHECK_TEXT(t.file.name, "part");
    CHECK_TEXT(t.file.system, "CAD 7");
    CHECK_TEXT(t.file.schema, "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }");
    CHECK(t.file.has_end);
    step_check_note(&t, "");
    CHECK_OK(step_begin(&t, "ISO-10303-21;HEADER;FILE_NAME($);FILE_SCHEMA(());FILE_NAME('x',;"
                            "ENDSEC;DATA;" STEP_TAIL));
    CHECK_TEXT(t.file.schema, "");
    step_check_note(&t, "expected a value here");
    step_end(&t);
}

/* One bad instance between the two; what is said of it. */
TEST(P2_a_broken_instance_is_left_out_alone)
{
    const struct {
        const char *bad, *note;
    } cases[] = {
        {"#5=X(1,,2);", "expected a value here; left out"},
        {"#5=X(1,);", "expected a value here"},
        {"#5=X(1", "expected ',' or ')' here"},
        {"#5=X 1);", "expected '(' after a keyword"},
        {"#5=X(Y);", "expected '(' after a keyword"},
        {"#5=X(1))", "expected ';' after an instance"},
        {"#5=X(1)", "expected ';' after an instance"},
        {"#5 X(1);", "expected '='"},
        {"#5=;", "expected a keyword here"},
        {"#5=();", "the instance is empty"},
        {"#5=(X(1)Y);", "expected '(' after a keyword"},
        {"#5=X(#);", "'#' has no number"},
        {"#5=X(#99999999999999999999);", "the number after '#' is too large"},
        {"#99999999999999999999=X();", "the number after '#' is too large"},
        {"#-5=X();", "'#' has no number"},
        {"#5=X(.T);", "a word between dots has no second dot"},
        {"#5=X(\"0G\");", "a binary value has characters other"},
        {"#5=X('it's');", "expected ',' or ')' here"},
        {"#5=X('it);", "expected ',' or ')' here"},
        {"what is this;", "neither an instance nor the end of a section"},
        {"FILE_NAME('');", "neither an instance nor the end of a section"},
        {"&", "neither an instance nor the end of a section"},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        char data[300];
        snprintf(data, sizeof data, "#1=CARTESIAN_POINT('a',(1.,2.,3.5));\n%s\n%s",
                 cases[k].bad, "#2=CARTESIAN_POINT('b',(-40.,5.,6.));\n");
        check_points(step_whole(data), cases[k].note, 1);
    }
}

TEST(N3_numbers_of_step_are_those_of_its_standard)
{
    const char *const bad[] = {"nan", "inf",   "0x1p3", "1d5", "1.D+3",
                               "--1", "1.5.2", "1e",    "+"};
    for (int k = 0; k < COUNT(bad); k++) {
        char data[300];
        snprintf(data, sizeof data, "%s#5=X(%s);", POINTS, bad[k]);
        check_points(step_whole(data), "; left out", 1);
    }
    step_text_file t = {.notes = NULL};
    double value = 1;
    int whole = 0;
    CHECK_OK(step_begin(&t, step_whole("#1=X(1E400,1.E-400,-0.,4.9E-324,LENGTH(+7),1.5);")));
    const bat_step_record *x = bat_step_first(&t.file, step_find(&t, 1));
    CHECK_STATUS(bat_step_get_real(&t.file, x, 0, &value), BATTEN_OVERFLOW);
    CHECK_MESSAGE("#1 X: argument 1 is too large for a double");
    CHECK_OK(bat_step_get_real(&t.file, x, 1, &value));
    CHECK_BITS(value, 0.0);
    step_check_note(&t, "the number 1.E-400 is too small for a double; read as 0");
    CHECK_OK(bat_step_get_real(&t.file, x, 2, &value)); /* N5 */
    CHECK_BITS(value, -0.0);
    CHECK_OK(bat_step_get_real(&t.file, x, 3, &value));
    CHECK_BITS(value, 4.9406564584124654e-324);
    CHECK_OK(bat_step_get_real(&t.file, x, 4, &value));
    CHECK_BITS(value, 7.0);
    CHECK_OK(bat_step_get_integer(&t.file, x, 4, &whole));
    CHECK_INT(whole, 7);
    CHECK_STATUS(bat_step_get_integer(&t.file, x, 5, &whole), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("argument 6 is a real, not an integer");
    step_end(&t);
}

TEST(N4_integers_beyond_their_range_are_refused)
{
    step_text_file t = {.notes = NULL};
    int whole = 3;
    CHECK_OK(step_begin(&t, step_whole("#1=X(2147483648,-99999999999999999999,(7));")));
    const bat_step_record *x = bat_step_first(&t.file, step_find(&t, 1));
    CHECK_STATUS(bat_step_get_integer(&t.file, x, 0, &whole), BATTEN_OVERFLOW);
    CHECK_MESSAGE("argument 1 is outside -2147483648 .. 2147483647");
    CHECK_STATUS(bat_step_get_integer(&t.file, x, 1, &whole), BATTEN_OVERFLOW);
    CHECK_STATUS(bat_step_get_integer(&t.file, x, 2, &whole), BATTEN_BAD_FORMAT);
    CHECK_INT(whole, 3);
    step_end(&t);
}

TEST(P1_references_are_typed_and_may_point_anywhere)
{
    step_text_file t = {.notes = NULL};
    const bat_step_instance *found = NULL;
    CHECK_OK(step_begin(&t, step_whole("#900=X(#3,#4,#900,$,(#3,7));\n#3=Y();#3=Z();")));
    step_check_note(&t, "the number is given again; line 9 is used, this is left out");
    CHECK_INT(t.input.left_out, 1);
    const bat_step_record *x = bat_step_first(&t.file, step_find(&t, 900));
    CHECK_OK(bat_step_get_reference(&t.file, x, 0, &found));
    CHECK(bat_step_as(&t.file, found, "Y") != NULL);
    CHECK(bat_step_as(&t.file, found, "Z") == NULL);
    CHECK_STATUS(bat_step_get_reference(&t.file, x, 1, &found), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("#900 X: argument 2 refers to #4, which is missing");
    CHECK_OK(bat_step_get_reference(&t.file, x, 2, &found));
    CHECK_INT(found->id, 900);
    CHECK_STATUS(bat_step_get_reference(&t.file, x, 3, &found), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("argument 4 is $, not a reference");
    CHECK_STATUS(bat_step_get_reference(&t.file, x, 7, &found), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("argument 6 is missing, not a reference");
    int count = 0;
    size_t at = 0;
    CHECK_OK(bat_step_get_list(&t.file, x, 4, &count, &at));
    CHECK_INT(count, 2);
    CHECK_OK(bat_step_item_reference(&t.file, x, &at, &found));
    CHECK_STATUS(bat_step_item_reference(&t.file, x, &at, &found), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("an item of argument 5 is an integer, not a reference");
    step_end(&t);
}

/* Ids with no, small and large gaps, rising and falling: all are found, no other is. */
TEST(P1_ids_are_found_whatever_their_order)
{
    const int steps[] = {1, 3, 1000};
    for (int k = 0; k < 2 * COUNT(steps); k++) {
        char *data = test_array(20000, 1), *to = data;
        const int step = steps[k / 2];
        for (int i = 0; i < 500; i++)
            to += sprintf(to, "#%d=P(%d);\n", 7 + step * (k % 2 ? 499 - i : i), i);
        step_text_file t = {.notes = NULL};
        CHECK_OK(step_begin(&t, step_whole(data)));
        CHECK_INT(t.file.instances.count, 500);
        for (int id = 0; id < 510 * step; id++)
            CHECK((bat_step_find(&t.file, (uint64_t)id) != NULL) ==
                  (id >= 7 && id <= 7 + 499 * step && (id - 7) % step == 0));
        CHECK(bat_step_find(&t.file, UINT64_MAX) == NULL);
        step_end(&t);
    }
}

TEST(P4_the_records_of_a_complex_instance_are_found_in_any_order)
{
    step_text_file t = {.notes = NULL};
    double value = 0;
    char keyword[BAT_STEP_KEYWORD_SIZE];
    CHECK_OK(step_begin(&t, step_whole("#1=(RATIONAL_B_SPLINE_CURVE((1.))B_SPLINE_CURVE(2)\n"
                                       " /* */ A ( ) REPRESENTATION_ITEM('') );\n"
                                       "#2=( LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));")));
    const bat_step_instance *curve = step_find(&t, 1);
    CHECK_INT(curve->record_count, 4);
    CHECK_TEXT(bat_step_keyword(&t.file, curve, keyword), "RATIONAL_B_SPLINE_CURVE");
    CHECK_OK(
        bat_step_get_real(&t.file, bat_step_as(&t.file, curve, "B_SPLINE_CURVE"), 0, &value));
    CHECK_BITS(value, 2.0);
    CHECK_INT(bat_step_argument_count(&t.file, bat_step_as(&t.file, curve, "A")), 0);
    CHECK(bat_step_as(&t.file, curve, "RATIONAL_B_SPLINE_SURFACE") == NULL);
    const bat_step_record *unit = bat_step_as(&t.file, step_find(&t, 2), "SI_UNIT");
    CHECK(bat_step_is(&t.file, unit, 1, "METRE"));
    CHECK(!bat_step_is(&t.file, unit, 0, "METRE") && !bat_step_is(&t.file, unit, 2, "METRE"));
    CHECK(bat_step_is_nothing(&t.file, unit, 0) && bat_step_is_nothing(&t.file, unit, 2));
    CHECK_INT(bat_step_line(&t.file, step_find(&t, 2)->at), 10);
    step_check_note(&t, "");
    step_end(&t);
}

TEST(step_logicals_are_words)
{
    step_text_file t = {.notes = NULL};
    bool is_true = false;
    CHECK_OK(step_begin(&t, step_whole("#1=X(.T.,.F.,.U.,.TRUE.,1);")));
    const bat_step_record *x = bat_step_first(&t.file, step_find(&t, 1));
    for (int k = 0; k < 3; k++) {
        CHECK_OK(bat_step_get_logical(&t.file, x, k, &is_true));
        CHECK(is_true == (k == 0));
    }
    CHECK_STATUS(bat_step_get_logical(&t.file, x, 3, &is_true), BATTEN_BAD_FORMAT);
    CHECK_STATUS(bat_step_get_logical(&t.file, x, 4, &is_true), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("argument 5 is an integer, not .T. or .F.");
    step_end(&t);
}

TEST(P5_strings_are_decoded)
{
    const struct {
        const char *step, *text;
    } cases[] = {
        {"'it''s'", "it's"},
        {"''''", "'"},
        {"'a\\\\b'", "a\\b"},
        {"'\\X2\\00E400DF\\X0\\!'", "\xc3\xa4\xc3\x9f!"},
        {"'\\X2\\D83DDE00\\X0\\'", "\xf0\x9f\x98\x80"},
        {"'\\X2\\D83D\\X0\\'", "\xef\xbf\xbd"},
        {"'\\X4\\0001F600\\X0\\x'", "\xf0\x9f\x98\x80x"},
        {"'\\X\\FCber'", "\xc3\xbc"
                         "ber"},
        {"'\\S\\|ber\\PA\\'", "\xc3\xbc"
                              "ber"},
        {"'\\X2\\00'", "00"},
        {"'\\X2'", "\\X2"},
        {"'\\'", "\\"},
        {"'\\Q'", "\\Q"},
        {"'\\X\\00'", "\xef\xbf\xbd"},
        {"$", ""},
        {"'0123456789abcdefghi'", "0123456789abcde"},
        {"'0123456789abcd\xc3\xa4'", "0123456789abcd"},
    };
    for (int k = 0; k < COUNT(cases); k++) {
        step_text_file t = {.notes = NULL};
        char data[80], text[16];
        snprintf(data, sizeof data, "#1=X(%s,1);", cases[k].step);
        CHECK_OK(step_begin(&t, step_whole(data)));
        const bat_step_record *x = bat_step_first(&t.file, step_find(&t, 1));
        CHECK_OK(bat_step_get_string(&t.file, x, 0, sizeof text, text));
        CHECK_TEXT(text, cases[k].text);
        CHECK_STATUS(bat_step_get_string(&t.file, x, 1, sizeof text, text), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE("argument 2 is an integer, not a string");
        step_end(&t);
    }
}

TEST(P5_what_has_no_end_is_said_with_the_line_where_it_begins)
{
    const struct {
        const char *data, *note;
        int line;
    } cases[] = {
        {"#7=X(1);\n#8=X('abc);\n#9=Y(1);\n", "a string has no end", 9},
        {"#7=X(1);\n/* and so on\n#9=Y(1);\n", "a comment has no end; nothing after", 9},
        {"#7=X(1);\n#8=X(\"0A);\n#9=Y(1);\n", "a binary value", 9}};
    for (int k = 0; k < COUNT(cases); k++) {
        step_text_file t = {.notes = NULL};
        CHECK_OK(step_begin(&t, step_whole(cases[k].data)));
        CHECK(bat_step_find(&t.file, 7) && !bat_step_find(&t.file, 8));
        step_check_note(&t, cases[k].note);
        if (batten_notes_count(t.notes) > 0)
            CHECK_INT(batten_notes_at(t.notes, 0)->line, cases[k].line);
        CHECK(t.input.is_cut == (k == 1) && (t.input.left_out > 0) == (k != 1));
        step_end(&t);
    }
}

/* A file cut anywhere is refused, cut, or at the least noted. */
TEST(F2_a_cut_step_file_is_never_a_quiet_whole)
{
    const char *text = step_whole(POINTS "#3=(A('x;')B());/* c */\n");
    const size_t whole = strlen(text);
    for (size_t size = 0; size + 1 < whole; size++) {
        step_text_file t = {.notes = NULL};
        char *cut = test_array(size + 1, 1);
        memcpy(cut, text, size);
        batten_status status = step_begin_bytes(&t, cut, size);
        if (status == BATTEN_OUT_OF_MEMORY)
            status = step_begin_bytes(&t, cut, size);
        CHECK(status == BATTEN_OK || status == BATTEN_BAD_FORMAT ||
              status == BATTEN_OUT_OF_MEMORY);
        if (status == BATTEN_OK && size < whole - strlen(STEP_TAIL))
            CHECK(t.input.is_cut);
        if (status == BATTEN_OK && batten_notes_dropped(t.notes) == 0)
            CHECK(batten_notes_count(t.notes) > 0);
        step_end(&t);
    }
}

TEST(S4_deep_lists_and_long_strings_cost_their_instance)
{
    const size_t deep = 100000, length = ((size_t)1 << 20) + 1;
    char *data = test_array(2 * deep + length + 200, 1), *to = data;
    to += sprintf(to, "%s#5=X(", POINTS);
    memset(to, '(', deep);
    to += deep;
    memset(to, ')', deep);
    to += deep;
    to += sprintf(to, ");\n#6=X('");
    memset(to, 'x', length);
    strcpy(to + length, "');\n");
    check_points(step_whole(data), "lists are nested deeper than the limit", 2);
    check_points(step_whole(data), "a string is longer than the limit", 2);
}

/* What the work of reading n, 2 n, 4 n pieces is, counted in bytes gone over. */
TEST(S3_reading_a_step_file_is_linear_also_when_all_of_it_is_wrong)
{
    const char *const pieces[] = {"#1=X('a', #2);\n",
                                  "#1=X('\n",
                                  "#1=X(''\n",
                                  "/* ' */",
                                  "#1=X(/*",
                                  "#1=X('';\n#",
                                  "((((",
                                  "#",
                                  ";",
                                  "'",
                                  "\n",
                                  "#1=X();",
                                  "'\n#1=X(",
                                  "#1 \n"};
    for (int k = 0; k < COUNT(pieces); k++) {
        uint64_t steps[2];
        for (int n = 0; n < 2; n++) {
            const size_t length = strlen(pieces[k]), count = ((size_t)1 << (15 + n)) / length;
            char *text = test_array(count * length + strlen(STEP_HEAD) + 1, 1);
            char *to = strcpy(text, STEP_HEAD) + strlen(STEP_HEAD);
            for (size_t i = 0; i < count; i++, to += length)
                memcpy(to, pieces[k], length);
            step_text_file t = {.notes = NULL};
            batten_status status = step_begin(&t, text);
            if (status == BATTEN_OUT_OF_MEMORY)
                CHECK_OK(step_begin(&t, text));
            steps[n] = t.file.scanned;
            step_end(&t);
        }
        CHECK(steps[0] > 0 && (double)steps[1] < 2.2 * (double)steps[0]);
    }
}

/* All that is said of a text, as "line: entity: text". */
static const struct {
    const char *data, *said;
} damages[] = {
    {"#1=X(0);\n#5=\n(\n);\n", "11: #5: the instance is empty; left out\n"},
    {"#1=X(0);\n#5=X(1,,\n2);\n", "9: #5: expected a value here; left out\n"},
    {"#1=X(0);\n\n#5=X(1\n2);\n", "11: #5: expected ',' or ')' here; left out\n"},
    {"#1=X(0);\n#5=X(1)\n\n#2=X();\n", "11: #5: expected ';' after an instance; left out\n"},
    {"#1=X(0);\n\nWHAT\n",
     "10: this is neither an instance nor the end of a section; left out\n"},
    {"#1=X(0);\n#5\n=X(1;\n", "10: #5: expected ',' or ')' here; left out\n"},
    {"#1=X(0);\n#5=X /* no end", "9: #5: a comment has no end; nothing after it is read\n"},
    {"#1=X(0);\n#5=( X() /* no end", "9: #5: a comment has no end; nothing after it is read\n"},
    {"#1=X(0);\n/* no end", "9: a comment has no end; nothing after it is read\n"},
    {"#1=X(0);\n#2=x(0);\n#3=y(0);\n",
     "9: keywords are in lower case; read as in upper case\n"},
    {"#1=X(0);\n#2=X('a\nb');\n#3=X('a\nb');\n",
     "9: a string continues over the end of a line; the break is dropped\n"},
    {"#1=X(0);\n#2=X(1,\n.5);\n#3=X(.5);\n",
     "10: a number has no digit before its point; read as with a 0\n"},
};

TEST(what_is_wrong_is_said_with_the_line_where_it_stands)
{
    for (int i = 0; i < COUNT(damages); i++) {
        step_text_file t = {.notes = NULL};
        char list[400] = "";
        CHECK_OK(step_begin(&t, step_whole(damages[i].data)));
        for (int k = 0; k < batten_notes_count(t.notes); k++) {
            const batten_note *n = batten_notes_at(t.notes, k);
            snprintf(list + strlen(list), 200, "%d: %s%s%s\n", n->line, n->entity,
                     n->entity[0] ? ": " : "", n->text);
        }
        if (batten_notes_dropped(t.notes) == 0)
            CHECK_TEXT(list, damages[i].said);
        CHECK(bat_step_find(&t.file, 1) != NULL);
        step_end(&t);
    }
}
