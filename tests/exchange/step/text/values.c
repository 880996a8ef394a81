/* Arguments as values, and what is said of wrong ones. */
#include "exchange/step/parsing.h"

#include <limits.h>

static void begin(step_text_file *t, const char *data)
{
    CHECK_OK(step_begin(t, step_whole(data)));
}

TEST(a_word_in_dots_is_the_whole_word_in_either_case)
{
    step_text_file t = {.notes = NULL};
    begin(&t, "#1=X(.PLANE.,.plane.,.PLANES.,.PLAN.,.QLANE.,'PLANE',PLANE(1),$);");
    static const bool is[] = {true, true, false, false, false, false, false, false, false};
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    CHECK_INT(bat_step_argument_count(&t.file, record), 8);
    for (int k = 0; k < COUNT(is); k++)
        CHECK(bat_step_is(&t.file, record, k, "PLANE") == is[k]);
    step_end(&t);
}

TEST(nothing_is_a_dollar_a_star_or_an_argument_that_is_not_there)
{
    step_text_file t = {.notes = NULL};
    begin(&t, "#1=X($,*,0,'',(),.F.,#1);");
    static const bool nothing[] = {true, true, false, false, false, false, false, true, true};
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    for (int k = 0; k < COUNT(nothing); k++)
        CHECK(bat_step_is_nothing(&t.file, record, k) == nothing[k]);
    step_end(&t);
}

TEST(every_kind_of_value_has_its_token)
{
    static const struct {
        const char *text, *token;
        bat_step_kind kind;
    } cases[] = {
        {"$", "$", BAT_STEP_NOTHING},
        {"*", "*", BAT_STEP_DERIVED},
        {"17", "17", BAT_STEP_INTEGER},
        {"-17", "-17", BAT_STEP_INTEGER},
        {"1.", "1.", BAT_STEP_REAL},
        {"1.E5", "1.E5", BAT_STEP_REAL},
        {"1E5", "1E5", BAT_STEP_REAL},
        {".5", ".5", BAT_STEP_REAL},
        {"'a''b'", "a''b", BAT_STEP_STRING},
        {"''", "", BAT_STEP_STRING},
        {"#12", "12", BAT_STEP_REFERENCE},
        {".T.", "T", BAT_STEP_ENUM},
        {"\"0F\"", "0F", BAT_STEP_BINARY},
        {"(1,2)", "(", BAT_STEP_LIST},
        {"LENGTH(2.)", "LENGTH", BAT_STEP_TYPED},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char data[80];
        snprintf(data, sizeof data, "#1=X(0, %s );", cases[i].text);
        step_text_file t = {.notes = NULL};
        begin(&t, data);
        const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
        const bat_step_value value =
            bat_step_value_at(&t.file, bat_step_argument(&t.file, record, 1));
        CHECK_INT(value.kind, cases[i].kind);
        CHECK_INT((long long)value.length, (long long)strlen(cases[i].token));
        CHECK(memcmp(t.input.data + value.at, cases[i].token, value.length) == 0);
        CHECK_INT(bat_step_value_at(&t.file, bat_step_argument(&t.file, record, 2)).kind,
                  BAT_STEP_END);
        step_end(&t);
    }
}

/* The same in messages: what stands there, where, and what is wanted. */
TEST(a_value_of_the_wrong_kind_is_named_with_its_argument)
{
    static const struct {
        const char *value, *words;
    } cases[] = {
        {"$", "#1 X: argument 2 is $, not a reference"},
        {"*", "#1 X: argument 2 is *, not a reference"},
        {"17", "#1 X: argument 2 is an integer, not a reference"},
        {"1.5", "#1 X: argument 2 is a real, not a reference"},
        {"'a'", "#1 X: argument 2 is a string, not a reference"},
        {".T.", "#1 X: argument 2 is a word in dots, not a reference"},
        {"\"0F\"", "#1 X: argument 2 is a binary value, not a reference"},
        {"(#1)", "#1 X: argument 2 is a list, not a reference"},
        {"L(#1)", "#1 X: argument 2 is a typed value, not a reference"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char data[80];
        const bat_step_instance *found = NULL;
        snprintf(data, sizeof data, "#1=x(0,%s,7);", cases[i].value);
        step_text_file t = {.notes = NULL};
        begin(&t, data);
        const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
        CHECK_STATUS(bat_step_get_reference(&t.file, record, 1, &found), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE(cases[i].words);
        CHECK_STATUS(bat_step_get_reference(&t.file, record, 3, &found), BATTEN_BAD_FORMAT);
        CHECK_MESSAGE("#1 X: argument 4 is missing, not a reference");
        step_end(&t);
    }
}

TEST(a_wrong_item_of_a_list_is_named_with_the_argument_of_the_list)
{
    step_text_file t = {.notes = NULL};
    begin(&t, "#1=X(0,((1,2),3,'a'),7);");
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    int count = 0, inner = 0;
    size_t at = 0, first = 0;
    double value = 0;
    CHECK_OK(bat_step_get_list(&t.file, record, 1, &count, &at));
    CHECK_INT(count, 3);
    CHECK_OK(bat_step_item_list(&t.file, record, &at, &inner, &first));
    CHECK_INT(inner, 2);
    CHECK_OK(bat_step_item_real(&t.file, record, &first, &value));
    CHECK_OK(bat_step_item_real(&t.file, record, &first, &value));
    CHECK_BITS(value, 2);
    CHECK_OK(bat_step_item_real(&t.file, record, &at, &value));
    CHECK_BITS(value, 3);
    CHECK_STATUS(bat_step_item_real(&t.file, record, &at, &value), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("#1 X: an item of argument 2 is a string, not a number");
    step_end(&t);
}

/* An entity that is left out is reported by its number, its keyword and its line; a message that
 * begins with them says them once. */
TEST(what_is_left_out_is_noted_with_its_line_and_its_reason_once)
{
    step_text_file t = {.notes = NULL};
    begin(&t, "#1=CIRCLE(0);\n#2=X(1);\n");
    const bat_step_instance *circle = step_find(&t, 1);
    bat_step_fail(&t.file, circle, BATTEN_BAD_FORMAT, "it is %s", "not round");
    CHECK_MESSAGE("#1 CIRCLE: it is not round");
    CHECK_OK(bat_step_leave_out(&t.file, NULL, circle, BATTEN_BAD_FORMAT));
    bat_step_fail(&t.file, step_find(&t, 2), BATTEN_BAD_FORMAT, "it is missing");
    CHECK_OK(bat_step_leave_out(&t.file, NULL, circle, BATTEN_BAD_FORMAT));
    CHECK_INT(t.input.left_out, 2);
    if (batten_notes_dropped(t.notes) == 0) {
        static const char *const texts[] = {"it is not round; left out",
                                            "#2 X: it is missing; left out"};
        CHECK_INT(batten_notes_count(t.notes), 2);
        for (int i = 0; i < 2; i++) {
            const batten_note *note = batten_notes_at(t.notes, i);
            CHECK_TEXT(note->text, texts[i]);
            CHECK_TEXT(note->entity, "#1 CIRCLE");
            CHECK_INT(note->line, bat_step_line(&t.file, circle->at));
        }
    }
    CHECK_STATUS(bat_step_leave_out(&t.file, NULL, circle, BATTEN_CANCELLED), BATTEN_CANCELLED);
    CHECK_STATUS(bat_step_leave_out(&t.file, NULL, circle, BATTEN_INCOMPLETE),
                 BATTEN_INCOMPLETE);
    CHECK_INT(t.input.left_out, 2);
    step_end(&t);
}

/* Argument 2 of #1, read as a number, an integer and a word of logic. */
static const struct {
    const char *text;
    double real;
    int integer, logical; /* -1: it is none */
    const char *words[3]; /* what is said where it is none; NULL where it is one */
} kinds[] = {
    {"17", 17, 17, -1, {NULL, NULL, "is an integer, not .T. or .F."}},
    {"-17", -17, -17, -1, {NULL, NULL, "is an integer, not .T. or .F."}},
    {"+17", 17, 17, -1, {NULL, NULL, "is an integer, not .T. or .F."}},
    {"L(17)", 17, 17, -1, {NULL, NULL, "is a typed value, not .T. or .F."}},
    {"L ( M /* 1 */ (17))", 17, 17, -1, {NULL, NULL, "is a typed value, not .T. or .F."}},
    {"1.5", 1.5, 0, -1, {NULL, "is a real, not an integer", "is a real, not"}},
    {"-.5", -0.5, 0, -1, {NULL, "is a real, not an integer", "is a real, not"}},
    {".5", 0.5, 0, -1, {NULL, "is a real, not an integer", "is a real, not"}},
    {"1E2", 100, 0, -1, {NULL, "is a real, not an integer", "is a real, not"}},
    {"L(.25)", 0.25, 0, -1, {NULL, "is a real, not an integer", "is a typed value, not"}},
    {".T.", 0, 0, 1, {"is a word in dots, not a number", "is a word in dots, not an integer"}},
    {".f.", 0, 0, 0, {"is a word in dots, not a number", "is a word in dots, not an integer"}},
    {".U.", 0, 0, 0, {"is a word in dots, not a number", "is a word in dots, not an integer"}},
    {".TT.",
     0,
     0,
     -1,
     {"is a word in dots, not a", "is a word in dots, not an", ", not .T. or"}},
    {".X.",
     0,
     0,
     -1,
     {"is a word in dots, not a", "is a word in dots, not an", ", not .T. or"}},
    {"'1'", 0, 0, -1, {"is a string, not a number", "is a string, not an", "is a string, not"}},
    {"'T'", 0, 0, -1, {"is a string, not a number", "is a string, not an", "is a string, not"}},
    {"#1", 0, 0, -1, {"is a reference, not a number", "is a reference", "is a reference"}},
    {"\"1\"", 0, 0, -1, {"is a binary value, not a number", "is a binary", "is a binary"}},
    {"(1)", 0, 0, -1, {"is a list, not a number", "is a list, not", "is a list, not"}},
    {"$", 0, 0, -1, {"is $, not a number", "is $, not an integer", "is $, not .T. or .F."}},
    {"*", 0, 0, -1, {"is *, not a number", "is *, not an integer", "is *, not .T. or .F."}},
    {"2147483647", 2147483647, 2147483647, -1, {NULL, NULL, "is an integer, not"}},
    {"-2147483648", -2147483648.0, INT_MIN, -1, {NULL, NULL, "is an integer, not"}},
    {"2147483648",
     2147483648.0,
     0,
     -1,
     {NULL, "is outside -2147483648 .. 2147483647", "is an integer, not"}},
    {"1.E400", 0, 0, -1, {"is too large for a double", "is a real, not", "is a real, not"}},
};

static void check_as(batten_status status, const char *words)
{
    CHECK_STATUS(status, !words                     ? BATTEN_OK
                         : strstr(words, "outside") ? BATTEN_OVERFLOW
                         : strstr(words, "large")   ? BATTEN_OVERFLOW
                                                    : BATTEN_BAD_FORMAT);
    if (words) {
        CHECK_MESSAGE("argument 2 is");
        CHECK_MESSAGE(words);
    }
}

TEST(each_value_is_read_as_what_it_is_and_refused_as_anything_else)
{
    for (int i = 0; i < COUNT(kinds); i++) {
        char data[80];
        double real = 0;
        int integer = 0;
        bool logical = false;
        snprintf(data, sizeof data, "#1=X(0, %s ,7);", kinds[i].text);
        step_text_file t = {.notes = NULL};
        begin(&t, data);
        const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
        CHECK_INT(bat_step_argument_count(&t.file, record), 3);
        check_as(bat_step_get_real(&t.file, record, 1, &real), kinds[i].words[0]);
        CHECK_BITS(real, kinds[i].real);
        check_as(bat_step_get_integer(&t.file, record, 1, &integer), kinds[i].words[1]);
        CHECK_INT(integer, kinds[i].integer);
        check_as(bat_step_get_logical(&t.file, record, 1, &logical), kinds[i].words[2]);
        CHECK_INT(logical, kinds[i].logical > 0);
        CHECK_OK(bat_step_get_integer(&t.file, record, 2, &integer));
        CHECK_INT(integer, 7);
        step_end(&t);
    }
}

/* Items of a list one after another, over blanks, comments and what is wrapped in keywords. */
TEST(reading_an_item_goes_on_to_the_next)
{
    step_text_file t = {.notes = NULL};
    begin(&t, "#1=X(( 1. , L(2.) /* , */ ,.5\n,\t3 ,(4.,5.),#1 , 6.),0);");
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    static const double due[] = {1, 2, 0.5, 3};
    const bat_step_instance *self = NULL;
    int count = 0, inner = 0;
    size_t at = 0, first = 0;
    double value = 0;
    CHECK_OK(bat_step_get_list(&t.file, record, 0, &count, &at));
    CHECK_INT(count, 7);
    for (int k = 0; k < 4; k++) {
        CHECK_OK(bat_step_item_real(&t.file, record, &at, &value));
        CHECK_BITS(value, due[k]);
    }
    CHECK_OK(bat_step_item_list(&t.file, record, &at, &inner, &first));
    CHECK_INT(inner, 2);
    CHECK_OK(bat_step_item_real(&t.file, record, &first, &value));
    CHECK_OK(bat_step_item_real(&t.file, record, &first, &value));
    CHECK_BITS(value, 5);
    CHECK_OK(bat_step_item_reference(&t.file, record, &at, &self));
    CHECK(self == step_find(&t, 1));
    CHECK_OK(bat_step_item_real(&t.file, record, &at, &value));
    CHECK_BITS(value, 6);
    CHECK_STATUS(bat_step_get_list(&t.file, record, 1, &count, &at), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("#1 X: argument 2 is an integer, not a list");
    step_end(&t);
}

TEST(a_number_that_vanishes_is_0_with_a_note_of_its_line)
{
    step_text_file t = {.notes = NULL};
    double value = 1;
    begin(&t, "#1=X(1,\n1.E-400,\n0.0E5);");
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    CHECK_OK(bat_step_get_real(&t.file, record, 2, &value));
    CHECK_OK(bat_step_get_real(&t.file, record, 1, &value));
    CHECK_BITS(value, 0.0);
    if (batten_notes_dropped(t.notes) == 0) {
        CHECK_INT(batten_notes_count(t.notes), 1);
        CHECK_INT(batten_notes_at(t.notes, 0)->line, 9);
        CHECK_TEXT(batten_notes_at(t.notes, 0)->entity, "#1");
        CHECK_CONTAINS(batten_notes_at(t.notes, 0)->text, "1.E-400");
    }
    step_end(&t);
}

/* What is read again and again is refused after 256 times the file and 8 KiB, counted in bytes that
 * were walked over, and 16 for each reference. */
TEST(a_file_that_is_read_256_times_over_is_refused)
{
    static const struct {
        const char *data;
        int argument;
        size_t walked; /* over what stands before */
    } cases[] = {
        {"#1=X(#1);", 0, 0}, {"#1=X('0123456789', #1);", 1, 12}, {"#1=X((1,2,3),4,#1);", 2, 8}};
    if (test_cases(1000) < 1000)
        SKIP("long, and allocates nothing");
    for (int i = 0; i < COUNT(cases); i++) {
        step_text_file t = {.notes = NULL};
        const bat_step_instance *found = NULL;
        begin(&t, cases[i].data);
        const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
        const size_t each = 16 + cases[i].walked, most = 256 * (t.input.size + 8193);
        for (size_t again = t.input.again + each; again < most; again += each)
            CHECK_OK(bat_step_get_reference(&t.file, record, cases[i].argument, &found));
        CHECK_STATUS(bat_step_get_reference(&t.file, record, cases[i].argument, &found),
                     BATTEN_TOO_LARGE);
        CHECK_MESSAGE("is one reference too many: what is referred to has been read more than "
                      "256 times over");
        CHECK_STATUS(bat_step_leave_out(&t.file, NULL, step_find(&t, 1), BATTEN_BAD_FORMAT),
                     BATTEN_BAD_FORMAT);
        CHECK_INT(t.input.left_out, 0);
        step_end(&t);
    }
}

TEST(a_reference_to_nothing_is_named)
{
    step_text_file t = {.notes = NULL};
    const bat_step_instance *found = NULL;
    begin(&t, "#1=X(0,(#1,#99,#1));");
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    int count = 0;
    size_t at = 0;
    CHECK_OK(bat_step_get_list(&t.file, record, 1, &count, &at));
    CHECK_OK(bat_step_item_reference(&t.file, record, &at, &found));
    CHECK_STATUS(bat_step_item_reference(&t.file, record, &at, &found), BATTEN_BAD_FORMAT);
    CHECK_MESSAGE("#1 X: an item of argument 2 refers to #99, which is missing");
    step_end(&t);
}
