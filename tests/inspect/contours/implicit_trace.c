/* Curves f(x, y) = 0 on a grid: nodes on the curve, cells with two branches, chords, the order of lines. */
#include "support/test.h"

#include <batten/contours.h>
#include <math.h>

/* a x + b y + c */
static double plane(const void *context, double x, double y, double *g)
{
    const double *abc = context;
    g[0] = abc[0];
    g[1] = abc[1];
    return abc[0] * x + abc[1] * y + abc[2];
}

/* a x y + b */
static double saddle(const void *context, double x, double y, double *g)
{
    const double *ab = context;
    g[0] = ab[0] * y;
    g[1] = ab[0] * x;
    return ab[0] * x * y + ab[1];
}

/* y - x^2 */
static double parabola(const void *context, double x, double y, double *g)
{
    (void)context;
    g[0] = -2 * x;
    g[1] = 1;
    return y - x * x;
}

/* The unit circle and the line x = 2 by each other. */
static double circle_and_line(const void *context, double x, double y, double *g)
{
    const double round = x * x + y * y - 1;
    (void)context;
    g[0] = 2 * x * (x - 2) + round;
    g[1] = 2 * y * (x - 2);
    return round * (x - 2);
}

static const batten_box square = {{-1, -1, 0}, {1, 1, 0}};

/* Lines through nodes, where the field is 0 exactly, from either side of it and along both axes. */
TEST(a_line_through_nodes_has_a_point_at_each_of_them)
{
    static const double lines[4][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (int i = 0; i < 4; i++)
        for (int cells = 2; cells <= 8; cells *= 2) {
            batten_trace trace = {{0, NULL}, 0, NULL};
            CHECK_OK(batten_trace_field(plane, lines[i], square, cells, 1e-6, &trace));
            CHECK_INT(trace.lines.count, 1);
            CHECK_INT(trace.singular_count, 0);
            const batten_polyline *l = &trace.lines.lines[0];
            const int along = i < 2 ? 1 : 0;
            CHECK_INT(l->count, cells + 1);
            CHECK(!l->closed);
            for (int k = 0; k < l->count; k++) {
                CHECK_NEAR(l->points[3 * k + along], -1 + 2. * k / cells, 1e-15);
                CHECK_NEAR(l->points[3 * k + 1 - along], 0, 1e-15);
                CHECK_NEAR(l->points[3 * k + 2], 0, 0);
            }
            batten_trace_release(&trace);
        }
}

/* An oblique line crosses edges of both kinds in their inside. */
TEST(an_oblique_line_is_met_on_every_edge_it_crosses)
{
    static const double line[3] = {1, 2, 0.3}; /* from (-1, 0.35) to (1, -0.65) */
    batten_trace trace = {{0, NULL}, 0, NULL};
    CHECK_OK(batten_trace_field(plane, line, square, 4, 1e-6, &trace));
    CHECK_INT(trace.lines.count, 1);
    const batten_polyline *l = &trace.lines.lines[0];
    CHECK_INT(l->count, 7); /* five lines of x, and y = 0 and -0.5 */
    for (int k = 0; k < l->count; k++)
        CHECK_NEAR(l->points[3 * k] + 2 * l->points[3 * k + 1], -0.3, 1e-15);
    CHECK_NEAR(fabs(l->points[0] - l->points[18]), 2, 1e-15);
    batten_trace_release(&trace);
}

/* Three cells across: both branches of a hyperbola pass the one in the middle. */
TEST(two_branches_in_one_cell_are_told_apart_by_its_middle)
{
    static const double saddles[4][2] = {{1, -0.01}, {1, 0.01}, {-1, -0.01}, {-1, 0.01}};
    for (int i = 0; i < 4; i++) {
        const double product = -saddles[i][1] / saddles[i][0];
        batten_trace trace = {{0, NULL}, 0, NULL};
        CHECK_OK(batten_trace_field(saddle, saddles[i], square, 3, 1e-3, &trace));
        CHECK_INT(trace.lines.count, 2);
        double sides = 0;
        for (int n = 0; n < trace.lines.count; n++) {
            const batten_polyline *l = &trace.lines.lines[n];
            CHECK(!l->closed && l->count > 5);
            for (int k = 0; k < l->count; k++) {
                CHECK_NEAR(l->points[3 * k] * l->points[3 * k + 1], product, 1e-6);
                CHECK(l->points[3 * k] * l->points[0] > 0);
            }
            sides += l->points[0] > 0 ? 1 : -1;
        }
        CHECK_NEAR(sides, 0, 0);
        batten_trace_release(&trace);
    }
}

/* A chord over h of x is h^2 / 4 sqrt(1 + 4 x^2) off; halves are taken above half of the tolerance. */
TEST(chords_are_halved_until_they_are_within_the_tolerance_and_no_further)
{
    const batten_box window = {{-1, -0.5, 0}, {1, 1.5, 0}};
    static const double tolerances[] = {1e-2, 1e-3, 1e-4};
    for (int i = 0; i < COUNT(tolerances); i++) {
        const double tolerance = tolerances[i];
        batten_trace trace = {{0, NULL}, 0, NULL};
        CHECK_OK(batten_trace_field(parabola, NULL, window, 4, tolerance, &trace));
        CHECK_INT(trace.lines.count, 1);
        const batten_polyline *l = &trace.lines.lines[0];
        const double way = l->points[0] < 0 ? 1 : -1;
        CHECK_NEAR(way * l->points[0], -1, 1e-15);
        CHECK_NEAR(way * l->points[3 * (l->count - 1)], 1, 1e-15);
        for (int k = 0; k < l->count; k++) {
            const double *p = l->points + 3 * k;
            CHECK_NEAR(p[1], p[0] * p[0], 1e-6 * tolerance + 1e-15);
            if (k == 0)
                continue;
            const double h = way * (p[0] - p[-3]), x = (p[0] + p[-3]) / 2;
            CHECK(h > 0);
            CHECK(h * h / 4 / sqrt(1 + 4 * x * x) <= 0.51 * tolerance);
        }
        CHECK(l->count <= 7 + 2 * 2 / sqrt(2 * tolerance));
        batten_trace_release(&trace);
    }
}

TEST(lines_from_the_rim_come_before_those_that_close)
{
    const batten_box window = {{-1.5, -1.3, 0}, {2.6, 1.4, 0}};
    batten_trace trace = {{0, NULL}, 0, NULL};
    CHECK_OK(batten_trace_field(circle_and_line, NULL, window, 20, 1e-4, &trace));
    CHECK_INT(trace.lines.count, 2);
    CHECK_INT(trace.singular_count, 0);
    const batten_polyline *line = &trace.lines.lines[0], *round = &trace.lines.lines[1];
    CHECK(!line->closed && round->closed);
    CHECK_NEAR(fabs(line->points[1] - line->points[3 * (line->count - 1) + 1]), 2.7, 1e-12);
    for (int k = 0; k < line->count; k++)
        CHECK_NEAR(line->points[3 * k], 2, 1e-9);
    for (int k = 0; k < round->count; k++)
        CHECK_NEAR(hypot(round->points[3 * k], round->points[3 * k + 1]), 1, 1e-9);
    for (int c = 0; c < 3; c++)
        CHECK_NEAR(round->points[c], round->points[3 * (round->count - 1) + c], 0);
    batten_trace_release(&trace);
}

TEST(a_field_that_is_0_nowhere_has_no_lines)
{
    static const double above[3] = {0.1, 0.1, 5}, below[3] = {0.1, 0.1, -5};
    batten_trace trace = {{0, NULL}, 0, NULL};
    CHECK_OK(batten_trace_field(plane, above, square, 2, 1, &trace));
    CHECK_INT(trace.lines.count + trace.singular_count, 0);
    CHECK_OK(batten_trace_field(plane, below, square, 2, 1, &trace));
    CHECK_INT(trace.lines.count + trace.singular_count, 0);
}

static const struct {
    batten_box window;
    int cells;
    double tolerance;
    const char *message;
} refused[] = {
    {{{1, 0, 0}, {1, 2, 0}}, 9, 1, "the window from (1, 0) to (1, 2) has no inside"},
    {{{0, 3, 0}, {1, 2, 0}}, 9, 1, "the window from (0, 3) to (1, 2) has no inside"},
    {{{0, 0, 0}, {INFINITY, 2, 0}}, 9, 1, "the window from (0, 0) to (inf, 2) has no inside"},
    {{{0, -INFINITY, 0}, {1, 2, 0}}, 9, 1, "the window from (0, -inf) to (1, 2) has no inside"},
    {{{0, 0, 0}, {1, 2, 0}}, 1, 1, "a grid of 1 cells is outside 2 to 2000"},
    {{{0, 0, 0}, {1, 2, 0}}, 2001, 1, "a grid of 2001 cells is outside 2 to 2000"},
    {{{0, 0, 0}, {1, 2, 0}}, 9, 0, "the tolerance is 0, not above 0"},
    {{{0, 0, 0}, {1, 2, 0}}, 9, INFINITY, "the tolerance is inf, not above 0"},
    {{{0, 0, 0}, {1, 2, 0}}, 9, NAN, "the tolerance is nan, not above 0"},
};

TEST(windows_grids_and_tolerances_out_of_bounds_are_refused_with_their_numbers)
{
    static const double line[3] = {1, 0, 0};
    batten_trace trace = {{7, NULL}, 0, NULL};
    for (int i = 0; i < COUNT(refused); i++) {
        CHECK_STATUS(batten_trace_field(plane, line, refused[i].window, refused[i].cells,
                                        refused[i].tolerance, &trace),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK_INT(trace.lines.count, 7);
}

/* x, but for one number that is not finite in the last node. */
static double broken(const void *context, double x, double y, double *g)
{
    const int which = *(const int *)context;
    const bool here = x == 1 && y == 1;
    g[0] = here && which == 1 ? NAN : 1;
    g[1] = here && which == 2 ? INFINITY : 0;
    return here && which == 0 ? NAN : x;
}

TEST(a_field_or_a_gradient_that_is_not_finite_is_refused_with_its_place)
{
    for (int which = 0; which < 3; which++) {
        batten_trace trace = {{7, NULL}, 0, NULL};
        CHECK_STATUS(batten_trace_field(broken, &which, square, 4, 1e-3, &trace),
                     BATTEN_NOT_FINITE);
        CHECK_MESSAGE(which ? "the field at (1, 1) is 1" : "the field at (1, 1) is nan");
        CHECK_INT(trace.lines.count, 7);
    }
}

/* x y over [-1, 1]^2, but no number at one place, in its value or in a gradient. */
typedef struct {
    double x, y;
    int what; /* 0: the value, 1 and 2: the gradient */
} hole;

static double saddle_with_a_hole(const void *context, double x, double y, double *g)
{
    const hole *h = context;
    const bool is_there = x == h->x && y == h->y;
    g[0] = is_there && h->what == 1 ? NAN : y;
    g[1] = is_there && h->what == 2 ? HUGE_VAL : x;
    return is_there && h->what == 0 ? NAN : x * y + 1e-3;
}

/* At a node, in the middle of a crossed edge, and in the middle of a cell with four crossed edges. */
TEST(a_field_that_is_no_number_where_it_is_asked_is_refused)
{
    static const double places[3][2] = {{1, -1}, {0, -1}, {0, 0}};
    const batten_box window = {{-3, -3, 0}, {3, 3, 0}};
    for (int i = 0; i < 3; i++)
        for (int what = 0; what < 3; what++) {
            const hole h = {places[i][0], places[i][1], what};
            char says[60];
            batten_trace trace = {{7, NULL}, 0, NULL};
            snprintf(says, sizeof says, "the field at (%g, %g) is ", h.x, h.y);
            CHECK_STATUS(batten_trace_field(saddle_with_a_hole, &h, window, 3, 1e-3, &trace),
                         BATTEN_NOT_FINITE);
            CHECK_MESSAGE(says);
            CHECK_INT(trace.lines.count, 7);
        }
}
