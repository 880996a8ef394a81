/* Arguments as values, and what is said of wrong ones. */
#include "exchange/step/parsing.h"

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
