/* Which sections of a skin are reversed. */
#include "shape/sections.h"

#include <batten/standard.h>

/* A circle at height z that starts `turn` radians off and runs backwards or not. */
static batten_curve *turned_circle(double z, double turn, bool backwards)
{
    batten_curve *flat = NULL, *space = NULL, *moved = NULL;
    batten_affine place = batten_affine_identity();
    const double c = cos(turn), s = sin(turn), m[3][3] = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
    memcpy(place.m, m, sizeof m);
    place.t[2] = z;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &space));
    CHECK_OK(batten_curve_transform(space, &place, &moved));
    batten_curve_unref(space);
    batten_curve_unref(flat);
    if (!backwards)
        return moved;
    batten_curve *reversed = NULL;
    CHECK_OK(batten_curve_reverse(moved, &reversed));
    batten_curve_unref(moved);
    return reversed;
}

/* The second of two circles: how it starts and runs, and where it is told to start. */
static const struct {
    double turn;
    bool backwards;
    bool told;
    double start;
} second_circles[] = {
    {0, false, true, 0.5},
    {3.1415926535897932, false, true, 0},
    {1.2, false, true, 0.25},
    {0, true, true, 0.5},
    {3.1415926535897932, true, true, 0},
    {1.2, true, true, 0.75},
    {3.1415926535897932, false, false, 0},
    {2.5, true, false, 0},
};

TEST(circles_are_reversed_by_how_they_run_and_not_by_where_they_start)
{
    for (int i = 0; i < COUNT(second_circles); i++) {
        batten_curve *sections[2] = {
            turned_circle(0, 0, false),
            turned_circle(1, second_circles[i].turn, second_circles[i].backwards)};
        const batten_interval domain = batten_curve_domain(sections[1]);
        const double s = second_circles[i].start,
                     starts[2] = {0, (1 - s) * domain.a + s * domain.b};
        batten_surface_skin_options options = batten_surface_skin_defaults();
        batten_surface_skin_report report = {0};
        batten_surface *surface = NULL;
        options.align = true;
        options.starts = second_circles[i].told ? starts : NULL;
        CHECK_OK(
            batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                &options, NULL, NULL, &report, &surface));
        CHECK_INT(report.reversed_count, second_circles[i].backwards);
        batten_surface_unref(surface);
        unref_all(2, sections);
    }
}
