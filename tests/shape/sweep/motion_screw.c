#include "shape/sweep/motion.h"

#include "support/test.h"

#include <batten/standard.h>
#include <batten/sweep.h>

static const double pi = 3.14159265358979323846;

/* cos and sin of v derived k times. */
static double cosine(int k, double v)
{
    return cos(v + k * pi / 2);
}

static double sine(int k, double v)
{
    return sin(v + k * pi / 2);
}

/* About the upright line through (1, 2) a point (x, y, z) comes to
 * (1, 2) + R (x - 1, y - 2), z + 3 v / pi. */
TEST(a_screw_turns_about_its_axis_and_rises_with_all_derivatives)
{
    static const double places[] = {0, 0.4, 2.5};
    bat_motion *motion = NULL;
    CHECK_OK(bat_motion_screw((batten_vec3){1, 2, 7}, (batten_vec3){0, 0, 5}, 6, 2.5, &motion));
    CHECK_INT(motion->break_count, 2);
    CHECK(motion->breaks[0] == 0 && motion->breaks[1] == 2.5);
    CHECK_NEAR(motion->size, sqrt(54) + 15, 1e-14);
    for (int i = 0; i < COUNT(places); i++) {
        const double v = places[i];
        bat_pose pose;
        CHECK_OK(motion->pose(motion, v, BATTEN_FROM_RIGHT, &pose));
        CHECK_NEAR(pose.share[0], v / 2.5, 1e-16);
        CHECK_NEAR(pose.share[1], 0.4, 1e-16);
        CHECK(pose.share[2] == 0 && pose.share[3] == 0);
        for (int k = 0; k <= BAT_POSE_ORDER; k++) {
            const double c = cosine(k, v), s = sine(k, v), still = k == 0;
            const double expected[4][3] = {{c, s, 0},
                                           {-s, c, 0},
                                           {0, 0, still},
                                           {still - c + 2 * s, 2 * still - s - 2 * c,
                                            k == 0   ? 3 * v / pi
                                            : k == 1 ? 3 / pi
                                                     : 0}};
            for (int axis = 0; axis < 4; axis++)
                for (int j = 0; j < 3; j++)
                    CHECK_NEAR(pose.d[k][axis][j], expected[axis][j], 2e-15 * 8);
        }
    }
    bat_motion_free(motion);
}

TEST(screws_that_are_none_are_refused_with_their_numbers)
{
    const struct {
        batten_screw screw;
        batten_status status;
        const char *message;
    } rows[] = {
        {{{0, NAN, 0}, {0, 0, 1}, 2, 3},
         BATTEN_NOT_FINITE,
         "the screw is about (0, nan, 0) along (0, 0, 1), pitch 2, angle 3"},
        {{{0, 4, 0}, {0, INFINITY, 1}, 2, 3},
         BATTEN_NOT_FINITE,
         "the screw is about (0, 4, 0) along (0, inf, 1), pitch 2, angle 3"},
        {{{0, 4, 0}, {0, 0, 1}, INFINITY, 3}, BATTEN_NOT_FINITE, "pitch inf, angle 3"},
        {{{0, 4, 0}, {0, 0, 1}, 2, NAN}, BATTEN_NOT_FINITE, "pitch 2, angle nan"},
        {{{0, 4, 0}, {0, 0, 0}, 2, 3}, BATTEN_BAD_ARGUMENT, "the axis has no length"},
        {{{0, 4, 0}, {0, 0, 1}, 2, 0}, BATTEN_BAD_ARGUMENT, "the angle is 0, not above 0"},
        {{{0, 4, 0}, {0, 0, 1}, 2, -1}, BATTEN_BAD_ARGUMENT, "the angle is -1, not above 0"},
        {{{0, 4, 0}, {0, 0, 1}, 2, 12566.370614359172},
         BATTEN_TOO_LARGE,
         "the angle is 2000 turns; the limit is 1000"},
    };
    batten_curve *line = NULL;
    batten_surface *none = NULL;
    CHECK_OK(batten_curve_line(3, (double[3]){1, 0, 0}, (double[3]){2, 0, 0}, &line));
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_surface_helical(line, rows[i].screw, 1e-6, NULL, NULL, &none),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    bat_motion *motion = NULL; /* a thousand turns are allowed */
    CHECK_OK(bat_motion_screw((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, 1, 2000 * pi,
                              &motion));
    bat_motion_free(motion);
    CHECK(!none);
    batten_curve_unref(line);
}
