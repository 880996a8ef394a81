/* What the readers of geometry share: who is to blame, how many arguments, how deep. */
#include "exchange/step/parsing.h"
#include "exchange/step/read/geometry.h"

#define DATA                                                                         \
    "#1=CARTESIAN_POINT('p',(1.,2.,3.));#2=DIRECTION('',(0.,0.,1.));#3=PLANE($,#9);" \
    "#4=PLANE('',#9,1.);#5=PLANE('');#6=PLANE(#9,#9);#7=PLANE();"

/* A sentence is that of the first instance that it names; success and missing memory are nobody's. */
TEST(an_instance_is_blamed_once_for_what_is_wrong_with_it)
{
    static const struct {
        batten_status status;
        const char *message, *due;
    } rows[] = {{BATTEN_OK, "old", "old"},
                {BATTEN_OUT_OF_MEMORY, "old", "old"},
                {BATTEN_BAD_FORMAT, "#2 DIRECTION: it is odd", "#2 DIRECTION: it is odd"},
                {BATTEN_BAD_FORMAT, "it is odd", "#1 CARTESIAN_POINT: it is odd"},
                {BATTEN_SINGULAR_HERE, "flat", "#1 CARTESIAN_POINT: flat"}};
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, step_whole(DATA)));
    for (int i = 0; i < COUNT(rows); i++) {
        bat_fail(BATTEN_BAD_ARGUMENT, "%s", rows[i].message);
        CHECK_INT(bat_step_blame(&t.file, step_find(&t, 1), rows[i].status), rows[i].status);
        CHECK_CONTAINS(batten_message(), rows[i].due);
        CHECK(strncmp(batten_message(), "t:", 2) != 0 ||
              strcmp(batten_message() + strlen(batten_message()) - strlen(rows[i].due),
                     rows[i].due) == 0);
    }
    step_end(&t);
}

TEST(the_name_comes_first_and_all_arguments_are_there)
{
    static const struct {
        int id, count;
        const char *message; /* NULL: good */
    } rows[] = {{1, 2, NULL},
                {3, 2, NULL},
                {2, 2, NULL},
                {1, 1, "argument 2 is a list, not one that belongs there"},
                {1, 3, "argument 3 is missing"},
                {4, 2, "argument 3 is a real, not one that belongs there"},
                {5, 2, "argument 2 is missing"},
                {6, 2, "argument 1 is a reference, not a string"},
                {7, 1, "argument 1 is missing"}};
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, step_whole(DATA)));
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_step_record *record =
            bat_step_first(&t.file, step_find(&t, (uint64_t)rows[i].id));
        CHECK_STATUS(bat_step_check_arguments(&t.file, record, rows[i].count),
                     rows[i].message ? BATTEN_BAD_FORMAT : BATTEN_OK);
        if (rows[i].message)
            CHECK_CONTAINS(batten_message(), rows[i].message);
    }
    step_end(&t);
}

TEST(a_reference_must_be_to_what_is_expected)
{
    step_text_file t = {.notes = NULL};
    const bat_step_record *found = NULL;
    CHECK_OK(step_begin(
        &t, step_whole("#1=VERTEX_POINT('',#2);#2=CARTESIAN_POINT('',(0.,0.,0.));")));
    const bat_step_record *record = bat_step_first(&t.file, step_find(&t, 1));
    CHECK_STATUS(bat_step_get_record(&t.file, record, 1, "DIRECTION", &found),
                 BATTEN_BAD_FORMAT);
    CHECK_CONTAINS(batten_message(),
                   "#2 CARTESIAN_POINT: #1 refers to it as a DIRECTION, which it is not");
    CHECK(found == NULL);
    CHECK_OK(bat_step_get_record(&t.file, record, 1, "CARTESIAN_POINT", &found));
    CHECK(found != NULL && found->id == 2);
    step_end(&t);
}
