#include "design/agree.h"
#include "design/expect.h"

#include <batten/grid.h>
#include <batten/scattered.h>

/* Surfaces through and near grids are the calls behind them, with each option in its place. */

static const char rows_of_points[] =
    "  net: {points: [[0, 0, 0], [1, 0, 1], [2, 0, 0.5], [3, 0, 0], [0, 1, 0.5], [1, 1, 1.5], [2, 1, "
    "1], [3, 1, 0.2], [0, 2, 0], [1, 2, 0.7], [2, 2, 0.1], [3, 2, 0.3], [0, 3, 0.4], [1, 3, 0.2], [2, 3, "
    "0.9], [3, 3, 1], [0, 4, 0], [1, 4, 0.6], [2, 4, 0.1], [3, 4, 0]], columns: 4}\n"
    "  back: {points: [[2, 1, 5], [1, 1, 4], [0, 1, 3], [2, 0, 2], [1, 0, 1], [0, 0, 0]], columns: 3}\n"
    "  off: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1.5, 1, 0]], columns: 2}\n"
    "  fold: {points: [[0, 0], [1, 0], [0.5, 0], [0, 1], [1, 1], [0.5, 1]], columns: 3}\n";
enum { ACROSS = 4, ALONG = 5 };
static const double heights[ALONG][ACROSS] = {{0, 1, 0.5, 0},
                                              {0.5, 1.5, 1, 0.2},
                                              {0, 0.7, 0.1, 0.3},
                                              {0.4, 0.2, 0.9, 1},
                                              {0, 0.6, 0.1, 0}};

/* As the calls take them: u runs along the rows of the design. */
static batten_grid grid_of(double points[3 * ALONG * ACROSS])
{
    for (int i = 0; i < ACROSS; i++)
        for (int j = 0; j < ALONG; j++) {
            double *p = points + 3 * (i * ALONG + j);
            p[0] = i;
            p[1] = j;
            p[2] = heights[j][i];
        }
    return (batten_grid){3, ACROSS, ALONG, points};
}

static batten_status interpolate(const batten_surface_interpolate_options *options,
                                 agree_surface *made)
{
    double points[3 * ALONG * ACROSS];
    batten_surface_interpolate_report report = {0};
    const batten_status status = batten_surface_interpolate(
        grid_of(points), options, NULL, (batten_uv_out){NULL, NULL}, &report, &made->surface);
    made->error = report.error;
    return status;
}

static batten_status through(const batten_design *design, agree_surface *made)
{
    (void)design;
    const batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    return interpolate(&options, made);
}

static batten_status through_with_options(const batten_design *design, agree_surface *made)
{
    (void)design;
    double weights[ALONG * ACROSS];
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    for (int i = 0; i < ALONG * ACROSS; i++)
        weights[i % ACROSS * ALONG + i / ACROSS] = 1 + (i % 7) / 64.0;
    options.degree_u = 2;
    options.degree_v = 4;
    options.parameters = BATTEN_CHORD;
    options.weights = weights;
    return interpolate(&options, made);
}

static batten_status through_at_data(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.knots_at_data = true;
    options.ends = BATTEN_END_NATURAL;
    return interpolate(&options, made);
}

static batten_status through_closed(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.closed_v = true;
    options.parameters = BATTEN_UNIFORM;
    return interpolate(&options, made);
}

static batten_status through_with_gaps(const batten_design *design, agree_surface *made)
{
    (void)design;
    bool gaps[ALONG * ACROSS] = {false};
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    gaps[5 % ACROSS * ALONG + 5 / ACROSS] = gaps[10 % ACROSS * ALONG + 10 / ACROSS] = true;
    options.gaps = gaps;
    return interpolate(&options, made);
}

static batten_status fit(const batten_surface_fit_grid_options *options, bool smooth,
                         agree_surface *made)
{
    double points[3 * ALONG * ACROSS];
    batten_surface_fit_report report = {0};
    const batten_status status = (smooth ? batten_surface_smooth_grid
                                         : batten_surface_fit_grid)(
        grid_of(points), options, NULL, (batten_uv_out){NULL, NULL}, &report, &made->surface);
    made->error = report.error;
    return status;
}

static batten_status near_with_options(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.degree_u = 1;
    options.degree_v = 2;
    options.points_u = 3;
    options.points_v = 4;
    options.parameters = BATTEN_UNIFORM;
    options.hold_rims = false;
    return fit(&options, false, made);
}

static batten_status near_within(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.tolerance = 0.3;
    return fit(&options, false, made);
}

static batten_status near_smooth(const batten_design *design, agree_surface *made)
{
    (void)design;
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    options.amount = 0.01;
    options.penalty = BATTEN_GRID_DIFFERENCES;
    options.order = 1;
    return fit(&options, true, made);
}

static batten_status near_function(const batten_design *design, agree_surface *made)
{
    (void)design;
    static const double x[] = {0, 1, 2, 3}, y[] = {0, 1, 2, 3, 4};
    double z[ALONG * ACROSS];
    batten_surface *function = NULL;
    batten_surface_fit_report report = {0};
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    for (int i = 0; i < ALONG * ACROSS; i++)
        z[i] = heights[i % ALONG][i / ALONG];
    options.points_u = options.points_v = 4;
    options.parameters = BATTEN_GIVEN;
    options.given_u = x;
    options.given_v = y;
    batten_status status =
        batten_surface_fit_grid((batten_grid){1, ACROSS, ALONG, z}, &options, NULL,
                                (batten_uv_out){NULL, NULL}, &report, &function);
    if (status == BATTEN_OK)
        status = batten_surface_from_function(function, &made->surface);
    batten_surface_unref(function);
    made->error = report.error;
    return status;
}

TEST(surfaces_of_grids_are_those_of_their_calls)
{
    static const agree_surface_row rows[] = {
        {"{interpolate-grid: net}", through},
        {"{interpolate-grid: net, degree-u: 2, degree-v: 4, parameters: chord, weights: [1.0, 1.015625, 1.03125, 1.046875, 1.0625, 1.078125, 1.09375, 1.0, 1.015625, 1.03125, 1.046875, 1.0625, 1.078125, 1.09375, 1.0, 1.015625, 1.03125, 1.046875, 1.0625, 1.078125]}",
         through_with_options},
        {"{interpolate-grid: net, knots: data, ends: natural}", through_at_data},
        {"{interpolate-grid: net, parameters: uniform, periodic-v: yes}", through_closed},
        {"{interpolate-grid: net, gaps: [6, 11]}", through_with_gaps},
        {"{fit-grid: net, degree-u: 1, degree-v: 2, points-u: 3, points-v: 4, parameters: uniform, "
         "hold-rims: no}",
         near_with_options},
        {"{fit-grid: net, within: 0.3}", near_within},
        {"{fit-grid: net, lambda: 0.01, penalty: differences, order: 1}", near_smooth},
        {"{fit-grid: net, as: function, points-u: 4, points-v: 4}", near_function},
    };
    AGREE_SURFACES(rows_of_points, rows);
}

TEST(grids_over_x_and_y_may_run_backwards_and_others_are_refused_by_point_and_row)
{
    static const expect_row rows[] = {
        /* z = x + 3 y, whatever the order of the rows and columns. */
        {"{fit-grid: back, as: function, degree-u: 2, degree-v: 1}", BATTEN_OK,
         "at 0 0 0 0 0;at 1 0 2 0 2;at 0 1 0 1 3;at 0.5 1 1 1 4;within 1e-9;on -1 -3 1 0"},
        {"{fit-grid: off, as: function}", BATTEN_NOT_COMPATIBLE,
         "point 2 of row 2 has x = 1.5, and the first of its column 1: this is not a grid over x and "
         "y"},
        {"{fit-grid: fold, as: function}", BATTEN_NOT_COMPATIBLE,
         "x goes from 1 to 0.5 at line 3: this is not a grid over x and y"},
        {"{interpolate-grid: net, gaps: [21]}", BATTEN_BAD_ARGUMENT,
         "gap 21: the points are counted 1 to 20"},
        {"{interpolate-grid: net, gaps: [0]}", BATTEN_BAD_ARGUMENT,
         "gap 0: the points are counted 1 to 20"},
        {"{interpolate-grid: net, gaps: [6, 11]}", BATTEN_OK, "notes 2 gaps are filled"},
        {"{interpolate-grid: net, gaps: [20]}", BATTEN_OK, "notes 1 gap is filled"},
        {"{interpolate-grid: net, du: [[1, 0, 0]]}", BATTEN_BAD_ARGUMENT,
         "'du' has 1 vector, not 10"},
        {"{interpolate-grid: net, dv: [[1, 0, 0], [1, 0, 0]]}", BATTEN_BAD_ARGUMENT,
         "'dv' has 2 vectors, not 8"},
        {"{interpolate-grid: net, twists: [[1, 0, 0]]}", BATTEN_BAD_ARGUMENT,
         "'twists' has 1 vector, not 4"},
        {"{interpolate-grid: net, twists: [[1, 0, 0], [1, 0, 0], [1, 0, 0], [1, 0, 0]]}",
         BATTEN_BAD_ARGUMENT, "'twists' need both 'du' and 'dv'"},
        {"{fit-grid: net, lambda: 1, rms: 1}", BATTEN_BAD_ARGUMENT,
         "give either 'rms' or 'lambda', not both"},
    };
    EXPECT(rows_of_points, rows);
}
