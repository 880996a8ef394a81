/* Sections drawn in their plane, placed along a spine. */
#include "shape/sections.h"

#include <batten/standard.h>

/* A straight section from (1, 0) to (3, 2). */
static batten_curve *drawn(void)
{
    const double a[2] = {1, 0}, b[2] = {3, 2};
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(2, a, b, &line));
    return line;
}

/* Along the z-axis from 5 to 14 with the parameter t: z = 5 + t + 8 t^2. */
static batten_curve *uneven_spine(void)
{
    const double points[9] = {0, 0, 5, 0, 0, 5.5, 0, 0, 14}, knots[6] = {0, 0, 0, 1, 1, 1};
    batten_curve *spine = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots, &spine));
    return spine;
}

/* The ends of section k of n on the surface. */
static void ends_of(const batten_surface *surface, double v, double ends[2][3])
{
    CHECK_OK(batten_surface_evaluate(surface, 0, v, 0, ends[0]));
    CHECK_OK(batten_surface_evaluate(surface, 1, v, 0, ends[1]));
}

static const double pi = 3.14159265358979323846;

/* Twists turn from x to y about the spine, scales shrink about it; frames of a straight spine
 * are all the same. */
TEST(sections_on_a_spine_are_turned_and_scaled_about_it)
{
    enum { N = 4 };
    const double twist[N] = {0, pi / 2, pi, -pi / 2}, scale[N] = {1, 2, 0.5, 3};
    const double at[N] = {0.1, 0.2, 0.6, 1};
    batten_curve *section = drawn(), *spine = uneven_spine();
    const batten_curve *sections[N] = {section, section, section, section};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *plain = NULL, *placed = NULL;
    double v[N], first[2][3], ends[2][3];
    options.degree = 1;
    options.spine = spine;
    options.spine_at = at;
    CHECK_OK(
        batten_surface_skin((batten_curve_row){N, sections}, &options, NULL, v, NULL, &plain));
    options.twist = twist;
    options.scale = scale;
    double w[N];
    CHECK_OK(
        batten_surface_skin((batten_curve_row){N, sections}, &options, NULL, w, NULL, &placed));
    ends_of(plain, v[0], first);
    CHECK_NEAR(hypot(first[0][0], first[0][1]), 1, 1e-14);
    CHECK_NEAR(hypot(first[1][0], first[1][1]), sqrt(13), 1e-14);
    for (int k = 0; k < N; k++) {
        ends_of(plain, v[k], ends);
        for (int e = 0; e < 2; e++) {
            CHECK_NEAR(ends[e][0], first[e][0], 1e-14);
            CHECK_NEAR(ends[e][1], first[e][1], 1e-14);
            CHECK_NEAR(ends[e][2], 5 + at[k] + 8 * at[k] * at[k], 1e-13);
        }
        ends_of(placed, w[k], ends);
        const double c = scale[k] * cos(twist[k]), s = scale[k] * sin(twist[k]);
        for (int e = 0; e < 2; e++) {
            CHECK_NEAR(ends[e][0], c * first[e][0] - s * first[e][1], 1e-13);
            CHECK_NEAR(ends[e][1], s * first[e][0] + c * first[e][1], 1e-13);
            CHECK_NEAR(ends[e][2], 5 + at[k] + 8 * at[k] * at[k], 1e-13);
        }
    }
    batten_surface_unref(placed);
    batten_surface_unref(plain);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(sections_without_places_stand_evenly_by_the_length_of_the_spine)
{
    enum { N = 7 };
    batten_curve *section = drawn(), *spine = uneven_spine();
    const batten_curve *sections[N] = {section, section, section, section,
                                       section, section, section};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *surface = NULL;
    double v[N], ends[2][3];
    options.degree = 1;
    options.spine = spine;
    CHECK_OK(batten_surface_skin((batten_curve_row){N, sections}, &options, NULL, v, NULL,
                                 &surface));
    for (int k = 0; k < N; k++) {
        ends_of(surface, v[k], ends);
        CHECK_NEAR(ends[0][2], 5 + 9 * k / (N - 1.0), 1e-5);
        CHECK_NEAR(ends[1][2], ends[0][2], 1e-13);
    }
    ends_of(surface, v[N - 1], ends);
    CHECK_NEAR(ends[0][2], 14, 1e-14);
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(twists_and_scales_that_are_no_numbers_or_turn_inside_out_are_named)
{
    const double good[3] = {1, 1, 1}, infinite[3] = {1, 1, INFINITY}, nothing[3] = {1, 0, 1};
    const struct {
        const double *twist, *scale;
        batten_status status;
        const char *message;
    } rows[] = {
        {infinite, good, BATTEN_NOT_FINITE, "the twist of section 3 is inf"},
        {good, infinite, BATTEN_NOT_FINITE, "the scale of section 3 is inf"},
        {good, nothing, BATTEN_BAD_ARGUMENT, "the scale of section 2 is 0, not above 0"},
    };
    batten_curve *section = drawn(), *spine = uneven_spine();
    const batten_curve *sections[3] = {section, section, section};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        batten_surface *surface = NULL;
        options.spine = spine;
        options.twist = rows[i].twist;
        options.scale = rows[i].scale;
        CHECK_STATUS(batten_surface_skin((batten_curve_row){3, sections}, &options, NULL, NULL,
                                         NULL, &surface),
                     rows[i].status);
        CHECK_MESSAGE(rows[i].message);
    }
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

/* Its lengths are tabulated over a rest of no length, too. */
TEST(a_spine_that_rests_where_it_begins_has_no_direction_there)
{
    const double points[9] = {0, 0, 5, 0, 0, 5, 0, 0, 14}, knots[5] = {0, 0, 0.5, 1, 1};
    batten_curve *section = drawn(), *spine = NULL;
    const batten_curve *sections[3] = {section, section, section};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 1, NULL, knots, &spine));
    options.spine = spine;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){3, sections}, &options, NULL, NULL,
                                     NULL, &surface),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("at 0");
    batten_curve_unref(spine);
    batten_curve_unref(section);
}
