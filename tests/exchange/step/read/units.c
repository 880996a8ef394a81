/* How large the shapes of a file are, which says how exact it may be. */
#include "exchange/step/read/units.h"

#include "exchange/step/parsing.h"

/* Two points that are so far apart along one axis, somewhere; the tolerance that this gives. */
static double tolerance_of(int axis, double size, double shift, const char *more)
{
    char data[500] = "";
    step_text_file t = {.notes = NULL};
    bat_step_units units;
    bat_step_scale scale;
    for (int i = 0; i < 2; i++) {
        double p[3] = {shift, shift, shift};
        p[axis] += i * size;
        snprintf(data + strlen(data), 120, "#%d=CARTESIAN_POINT('',(%.17g,%.17g,%.17g));\n",
                 i + 1, p[0], p[1], p[2]);
    }
    strcat(data, more);
    CHECK_OK(step_begin(&t, step_whole(data)));
    bat_step_units_begin(&units);
    bat_step_units_of(&t.file, &units, NULL, &scale);
    step_end(&t);
    return scale.tolerance;
}

TEST(the_tolerance_of_a_file_that_states_none_is_in_proportion_to_its_size)
{
    const double one = tolerance_of(0, 1, 0, "");
    CHECK(one > 0 && one < 1e-4);
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 3; k++) {
            const double shift = 50 * (k - 1);
            CHECK_NEAR(tolerance_of(axis, 8, shift, ""), 8 * one, 1e-12 * one);
            CHECK_NEAR(tolerance_of(axis, 1000, shift, ""), 1000 * one, 1e-9 * one);
        }
}

/* Vertices at both points: a third point far off counts up to a limit, without them it counts. */
TEST(points_far_off_all_vertices_do_not_make_a_file_large)
{
    static const char *const vertices = "#3=VERTEX_POINT('',#1);\n#4=VERTEX_POINT('',#2);\n";
    static const char *const far = "#5=CARTESIAN_POINT('',(1E12,0.,0.));\n"
                                   "#3=VERTEX_POINT('',#1);\n#4=VERTEX_POINT('',#2);\n";
    const double one = tolerance_of(0, 1, 0, "");
    for (int axis = 0; axis < 3; axis++) {
        CHECK_NEAR(tolerance_of(axis, 4, 0, vertices), 4 * one, 1e-12 * one);
        const double limited = tolerance_of(axis, 4, 0, far);
        CHECK(limited >= 4 * one && limited <= 4e6 * one);
        CHECK_NEAR(tolerance_of(axis, 8, 0, far), 2 * limited, 1e-9 * limited);
    }
    CHECK_NEAR(tolerance_of(1, 4, 0, "#5=CARTESIAN_POINT('',(1E12,0.,0.));\n"), 1e12 * one,
               1e3 * one);
}

/* ---- contexts ---- */

#define CONTEXT(id, units, accuracies)                                                      \
    "#" id                                                                                  \
    "=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" accuracies \
    "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" units "))REPRESENTATION_CONTEXT('',''));\n"
/* Points 100 apart; units of all kinds. */
#define UNITS                                                                        \
    "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=CARTESIAN_POINT('',(0.,100.,0.));\n"     \
    "#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"                    \
    "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"                          \
    "#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"                    \
    "#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"                 \
    "#14=(CONVERSION_BASED_UNIT('DEGREE',#15)NAMED_UNIT(#16)PLANE_ANGLE_UNIT());\n"  \
    "#15=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925),#12);\n"    \
    "#16=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);\n"                             \
    "#17=(CONVERSION_BASED_UNIT('INCH',#18)LENGTH_UNIT()NAMED_UNIT(#16));\n"         \
    "#18=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#10);\n"                      \
    "#19=CONVERSION_BASED_UNIT(#16,'FOOT',#20);\n"                                   \
    "#20=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#17);\n"                       \
    "#21=SI_UNIT(*,.CENTI.,.METRE.);\n#22=SI_UNIT(*,.LARGE.,.METRE.);\n"             \
    "#23=(CONVERSION_BASED_UNIT('Foot',#24)LENGTH_UNIT()NAMED_UNIT(#16));\n"         \
    "#24=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.),#10);\n"                        \
    "#25=(CONVERSION_BASED_UNIT('cubit',#26)LENGTH_UNIT()NAMED_UNIT(#16));\n"        \
    "#26=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-2.),#10);\n"                       \
    "#27=(CONVERSION_BASED_UNIT('degree',#24)NAMED_UNIT(#16)PLANE_ANGLE_UNIT());\n"  \
    "#28=(CONVERSION_BASED_UNIT('rod',#29)LENGTH_UNIT()NAMED_UNIT(#16));\n"          \
    "#29=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(5029.2),#10);\n"                    \
    "#40=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-4),#10,'','');\n"          \
    "#41=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),#11,'','');\n"          \
    "#42=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(7.),#10,'','');\n"             \
    "#43=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-17),#10,'','');\n"         \
    "#44=UNCERTAINTY_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(1.E-3),#12,'','');\n"     \
    "#45=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(" \
    "LENGTH_MEASURE(2.E-3),#10)REPRESENTATION_ITEM('')UNCERTAINTY_MEASURE_WITH_UNIT('',''));\n"

static const struct {
    const char *units, *accuracies;
    double metres, radians, tolerance;
    const char *note; /* the only one; "" for none */
} contexts[] = {
    {"#10,#12,#13", "#40", 0.001, 1, 1e-4, ""},
    {"#13,#12,#11", "#41", 1, 1, 1e-6, ""},
    {"#10,#12", "#41", 0.001, 1, 1e-3, ""}, /* a millionth of a metre */
    {"#11,#12", "#40", 1, 1, 1e-7, ""},
    {"#10,#12", "#44,#40", 0.001, 1, 1e-4, ""},
    {"#10,#12", "#45", 0.001, 1, 2e-3, ""},
    {"#10,#14", "#40", 0.001, 0.0174532925, 1e-4, ""},
    {"#17,#12", "#40", 0.0254, 1, 1e-4 / 25.4, ""}, /* rounded to the unit that is meant */
    {"#19,#12", "#40", 0.3048, 1, 1e-4 / 304.8, ""},
    {"#21,#12", "#40", 0.01, 1, 1e-5, ""},
    {"#28,#12", "#40", 5.0292, 1, 1e-4 / 5029.2, ""},
    {"#10,#11,#12,#14", "#40", 0.001, 1, 1e-4, ""}, /* the first of each counts */
    {"#10,#12", "#42", 0.001, 1, 1e-4,
     "the file states an accuracy of 7 at a size of 100; 0.0001 is used"},
    {"#10,#12", "#43", 0.001, 1, 1e-10,
     "the file states an accuracy of 1e-17 at a size of 100; 1e-10 is used"},
    {"#10,#12", "", 0.001, 1, 1e-4, "the file states no accuracy; 0.0001 is used"},
    {"#10,#12", "#44", 0.001, 1, 1e-4, "the file states no accuracy; 0.0001 is used"},
    {"#12", "#40", 0.001, 1, 1e-4, "the file gives no unit of length; millimetres are assumed"},
    {"#22,#12", "#40", 0.001, 1, 1e-4,
     "the file gives no unit of length; millimetres are assumed"},
    {"#10", "#40", 0.001, 1, 1e-4, "the file gives no unit of angle; radians are assumed"},
    {"#23,#12", "#40", 0.3048, 1, 1e-4 / 304.8,
     "the unit 'Foot' has the factor 0; by its name 0.3048 m is taken"},
    {"#10,#27", "#40", 0.001, 0.01745329251994329577, 1e-4,
     "the unit 'degree' has the factor 0; by its name 0.0174533 radian is taken"},
    {"#25,#10,#12", "#40", 0.001, 1, 1e-4, "the unit 'cubit' has the factor -2; it is ignored"},
};

TEST(units_and_accuracy_of_a_context_are_those_that_it_states)
{
    for (int i = 0; i < COUNT(contexts); i++) {
        char data[4000];
        step_text_file t = {.notes = NULL};
        bat_step_units units;
        bat_step_scale scale;
        snprintf(data, sizeof data, UNITS CONTEXT("100", "%s", "%s"), contexts[i].accuracies,
                 contexts[i].units);
        CHECK_OK(step_begin(&t, step_whole(data)));
        bat_step_units_begin(&units);
        for (int k = 0; k < 2;
             k++) { /* asked for again it is the same, and nothing is said twice */
            bat_step_units_of(&t.file, &units, step_find(&t, 100), &scale);
            CHECK_NEAR(units.unit_metres, contexts[i].metres, 1e-15 * contexts[i].metres);
            CHECK_BITS(scale.length, 1);
            CHECK_NEAR(scale.angle, contexts[i].radians, 1e-16);
            CHECK_NEAR(scale.tolerance, contexts[i].tolerance, 1e-12 * contexts[i].tolerance);
        }
        if (batten_notes_dropped(t.notes) == 0) {
            CHECK_INT(batten_notes_count(t.notes), contexts[i].note[0] != 0);
            for (int k = 0; k < batten_notes_count(t.notes); k++)
                CHECK_CONTAINS(batten_notes_at(t.notes, k)->text, contexts[i].note);
        }
        step_end(&t);
    }
}

/* Three contexts that say nothing, two in metres, one in inches: what is assumed is said once for all. */
TEST(what_is_assumed_of_several_contexts_is_said_once)
{
    static const struct {
        int id;
        double length, tolerance;
    } asked[] = {{100, 1, 1e-4},       {200, 1, 1e-4},   {100, 1, 1e-4}, {300, 1000, 0.1},
                 {400, 25.4, 25.4e-4}, {500, 1000, 0.1}, {200, 1, 1e-4}};
    static const char *const notes[] = {
        "the file gives no unit of length; millimetres are assumed",
        "the file gives no unit of angle; radians are assumed",
        "the file states no accuracy; 0.0001 is used",
        "parts in a unit of 1 m are scaled into that of the model, 0.001 m"};
    step_text_file t = {.notes = NULL};
    bat_step_units units;
    CHECK_OK(step_begin(&t, step_whole(UNITS CONTEXT("100", "", "") CONTEXT("200", "#13", "")
                                           CONTEXT("300", "#11", "") CONTEXT("400", "#17", "")
                                               CONTEXT("500", "#11,#12", ""))));
    bat_step_units_begin(&units);
    for (int i = 0; i < COUNT(asked); i++) {
        bat_step_scale scale;
        bat_step_units_of(&t.file, &units, step_find(&t, (uint64_t)asked[i].id), &scale);
        CHECK_BITS(units.unit_metres, 0.001);
        CHECK_NEAR(scale.length, asked[i].length, 1e-12);
        CHECK_NEAR(scale.tolerance, asked[i].tolerance, 1e-12);
    }
    if (batten_notes_dropped(t.notes) == 0) {
        CHECK_INT(batten_notes_count(t.notes), COUNT(notes));
        for (int i = 0; i < COUNT(notes); i++)
            CHECK_TEXT(batten_notes_at(t.notes, i)->text, notes[i]);
    }
    step_end(&t);
}
