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
