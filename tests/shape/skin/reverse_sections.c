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

/* A square about the z-axis at height z that starts at its corner number `first`. */
static batten_curve *turned_square(double z, int first)
{
    static const double corners[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    double points[5][3];
    batten_curve *curve = NULL;
    for (int i = 0; i < 5; i++) {
        const double *corner = corners[(i + first) % 4];
        memcpy(points[i], (const double[3]){corner[0], corner[1], z}, sizeof points[i]);
    }
    CHECK_OK(batten_curve_polyline((batten_points){3, 5, &points[0][0]}, &curve));
    return curve;
}

/* How far the starts of the two sections are apart, seen along the axis. */
static double starts_apart(const batten_surface *surface)
{
    double a[3], b[3];
    CHECK_OK(batten_surface_evaluate(surface, 0, 0, 0, a));
    CHECK_OK(batten_surface_evaluate(surface, 0, 1, 0, b));
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static const struct {
    bool square, backwards, turned; /* and whether the second section is turned then */
    double turn;                    /* radians, or corners */
    double apart;                   /* of the starts afterwards */
} untwisted[] = {
    {false, false, false, 0.7, 0.685795614910904}, /* below 45 degrees: 2 sin(0.35) */
    {false, false, true, 0.9, 0},
    {false, false, true, 3, 0},
    {false, true, true, 2, 0},
    {true, false, false, 0, 0},
    {true, false, true, 1, 0},
    {true, false, true, 2, 0},
    {true, false, true, 3, 0},
};

TEST(closed_sections_that_start_more_than_45_degrees_off_are_turned_to_their_neighbour)
{
    for (int i = 0; i < COUNT(untwisted); i++) {
        const double turn = untwisted[i].turn;
        batten_curve *sections[2] = {
            untwisted[i].square ? turned_square(0, 0) : turned_circle(0, 0, false),
            untwisted[i].square ? turned_square(1, (int)turn)
                                : turned_circle(1, turn, untwisted[i].backwards)};
        batten_surface_skin_options options = batten_surface_skin_defaults();
        batten_surface_skin_report report = {0};
        batten_surface *surface = NULL;
        options.align = options.untwist = true;
        CHECK_OK(
            batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                &options, NULL, NULL, &report, &surface));
        CHECK_INT(report.turned_count, untwisted[i].turned);
        CHECK_INT(report.turned, untwisted[i].turned ? 1 : -1);
        CHECK_INT(report.reversed_count, untwisted[i].backwards);
        CHECK_INT(report.reversed, untwisted[i].backwards ? 1 : -1);
        /* Circles are nearest at equal parameters, not at equal angles. */
        CHECK_NEAR(starts_apart(surface), untwisted[i].apart,
                   untwisted[i].square ? 1e-14 : 0.02);
        batten_surface_unref(surface);
        unref_all(2, sections);
    }
}

TEST(starts_outside_of_their_section_or_of_open_ones_are_refused_with_their_number)
{
    const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, starts[2] = {0, 9}, inside[2] = {0, 0};
    batten_curve *circles[2] = {turned_circle(0, 0, false), turned_circle(1, 0, false)};
    batten_curve *line = NULL;
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    const batten_curve *lines[2] = {line, line};
    options.starts = starts;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)circles},
                            &options, NULL, NULL, NULL, &surface),
        BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("section 2 cannot begin at 9, outside its domain [0, ");
    options.starts = inside;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, lines}, &options, NULL, NULL, NULL, &surface),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("section 1 is open and cannot begin at another place");
    options.turn = true;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){2, lines}, &options, NULL, NULL, NULL, &surface),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("closed sections begin where they are told or turn, not both");
    batten_curve_unref(line);
    unref_all(2, circles);
}

/* A square that is run round twice: it fits as well from either of its rounds on. */
static batten_curve *double_square(double z)
{
    static const double corners[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    double points[9][3];
    batten_curve *curve = NULL;
    for (int i = 0; i < 9; i++)
        memcpy(points[i], (double[]){corners[i % 4][0], corners[i % 4][1], z},
               sizeof points[i]);
    CHECK_OK(batten_curve_polyline((batten_points){3, 9, points[0]}, &curve));
    return curve;
}

TEST(of_starts_that_fit_equally_well_the_present_one_stays)
{
    batten_curve *sections[2] = {double_square(0), double_square(1)};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report = {0};
    batten_surface *surface = NULL;
    options.align = options.untwist = true;
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &report, &surface));
    CHECK_INT(report.turned_count, 0);
    CHECK_INT(report.reversed_count, 0);
    batten_surface_unref(surface);
    unref_all(2, sections);
}
