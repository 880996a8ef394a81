#include "design/agree.h"

#include <batten/approximate.h>
#include <batten/polygon.h>

/* Curves near points are those of the calls behind them, with each option in its place. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, 1, 2], [5.5, 0, 0], [7, 2, 1]]}\n"
    "  p: {points: [[0, 1, 0], [1, 1, 2], [2, 1, 2.5], [3, 1, -1], [5, 1, 1], [5.5, 1, 3], [7, 1, 0]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1,   0.5, 2, 0.2, 1, 3, 1.5,
                              3, 4, 1, 2, 5.5, 0,   0, 7,   2, 1};
static const double abscissae[] = {0, 1, 2, 3, 5, 5.5, 7};
static const double values[] = {0, 2, 2.5, -1, 1, 3, 0};
static const double weights[] = {1, 2, 3, 4, 3, 2, 1};

static const agree_made space = {.points = {3, 7, of_s}},
                        function = {.points = {1, 7, values},
                                    .abscissae = abscissae,
                                    .axis = 1,
                                    .level = 1};

static batten_status take(agree_made *m, batten_status status, double error, double rms)
{
    m->error = error;
    m->rms = rms;
    return status;
}

/* ---- smoothing ---- */

static batten_status smooth(agree_made *m, const batten_curve_smooth_options *given,
                            bool p_spline)
{
    batten_curve_smooth_options o = *given;
    batten_fit_report report = {0};
    if (m->abscissae) {
        o.parameters = BATTEN_GIVEN;
        o.given = m->abscissae;
    }
    const batten_status status = (p_spline ? batten_curve_p_spline : batten_curve_smooth)(
        m->points, &o, m->parameters, &report, &m->curve);
    return take(m, status, report.error, report.rms);
}

static batten_curve_smooth_options smoothing(batten_smooth_by by, double amount, int order)
{
    batten_curve_smooth_options o = batten_curve_smooth_defaults();
    o.parameters = BATTEN_CHORD;
    o.by = by;
    o.amount = amount;
    o.order = order;
    return o;
}

static batten_status smooth_as_it_is(agree_made *m)
{
    const batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_VALIDATION, 0, 2);
    return smooth(m, &o, false);
}

static batten_status smooth_by_rms(agree_made *m)
{
    const batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_RMS, 0.3, 3);
    return smooth(m, &o, false);
}

static batten_status smooth_by_lambda(agree_made *m)
{
    batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_LAMBDA, 0.02, 1);
    o.parameters = BATTEN_UNIFORM;
    return smooth(m, &o, false);
}

static batten_status smooth_closed(agree_made *m)
{
    batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_RMS, 0.2, 2);
    o.closed = true;
    return smooth(m, &o, false);
}

static batten_status p_spline(agree_made *m)
{
    batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_LAMBDA, 0.1, 1);
    o.spans = 5;
    o.degree = 4;
    return smooth(m, &o, true);
}

static batten_status p_spline_of_40(agree_made *m)
{
    batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_RMS, 0.25, 2);
    o.spans = 40;
    o.degree = 3;
    return smooth(m, &o, true);
}

static batten_status p_spline_closed(agree_made *m)
{
    batten_curve_smooth_options o = smoothing(BATTEN_SMOOTH_BY_LAMBDA, 0.5, 2);
    o.closed = true;
    o.spans = 7;
    o.degree = 2;
    o.parameters = BATTEN_CENTRIPETAL;
    return smooth(m, &o, true);
}

TEST(smoothing_curves_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{smooth: s}", smooth_as_it_is},
        {"{smooth: s, rms: 0.3, order: 3}", smooth_by_rms},
        {"{smooth: s, lambda: 0.02, order: 1, parameters: uniform}", smooth_by_lambda},
        {"{smooth: s, rms: 0.2, closed: yes}", smooth_closed},
        {"{p-spline: s, lambda: 0.1, spans: 5, degree: 4, order: 1}", p_spline},
        {"{p-spline: s, rms: 0.25}", p_spline_of_40},
        {"{p-spline: s, lambda: 0.5, spans: 7, degree: 2, closed: yes, parameters: centripetal}",
         p_spline_closed},
    };
    static const agree_row of_functions[] = {
        {"{smooth: p, rms: 0.3, order: 3, as: function}", smooth_by_rms},
        {"{p-spline: p, lambda: 0.1, spans: 5, degree: 4, order: 1, as: function}", p_spline},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- operators ---- */

static batten_status operate(agree_made *m, int degree, batten_parametrization parameters,
                             bool closed, bool bernstein, bool quasi)
{
    batten_curve_schoenberg_options o = batten_curve_schoenberg_defaults();
    batten_curve_schoenberg_report report = {0};
    o.degree = degree;
    o.parameters = m->abscissae ? BATTEN_GIVEN : parameters;
    o.given = m->abscissae;
    o.closed = closed;
    o.bernstein = bernstein;
    const batten_status status =
        (quasi ? batten_curve_quasi_interpolate
               : batten_curve_schoenberg)(m->points, &o, m->parameters, &report, &m->curve);
    return take(m, status, report.error, report.rms);
}

static batten_status schoenberg(agree_made *m)
{
    return operate(m, 3, BATTEN_CHORD, false, false, false);
}

static batten_status schoenberg_closed(agree_made *m)
{
    return operate(m, 2, BATTEN_CENTRIPETAL, true, false, false);
}

static batten_status bernstein(agree_made *m)
{
    return operate(m, 6, BATTEN_CHORD, false, true, false);
}

static batten_status quasi(agree_made *m)
{
    return operate(m, 3, BATTEN_CHORD, false, false, true);
}

static batten_status quasi_closed(agree_made *m)
{
    return operate(m, 2, BATTEN_UNIFORM, true, false, true);
}

static batten_status minimax(agree_made *m)
{
    batten_curve_minimax_report report = {0};
    memcpy(m->parameters, m->abscissae, sizeof abscissae);
    const batten_status status = batten_curve_minimax(m->points.count, m->abscissae,
                                                      m->points.at, 2, &report, &m->curve);
    return take(m, status, report.error, report.rms);
}

TEST(operators_and_minimax_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{schoenberg: s}", schoenberg},
        {"{schoenberg: s, degree: 2, closed: yes, parameters: centripetal}", schoenberg_closed},
        {"{schoenberg: s, degree: 6, knots: none}", bernstein},
        {"{quasi-interpolant: s}", quasi},
        {"{quasi-interpolant: s, degree: 2, closed: yes, parameters: uniform}", quasi_closed},
    };
    static const agree_row of_functions[] = {
        {"{schoenberg: p, as: function}", schoenberg},
        {"{schoenberg: p, degree: 6, knots: none, as: function}", bernstein},
        {"{quasi-interpolant: p, as: function}", quasi},
        {"{minimax: p, degree: 2}", minimax},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- least squares, and within a bound ---- */

static batten_status least_squares(agree_made *m,
                                   const batten_curve_least_squares_options *given)
{
    batten_curve_least_squares_options o = *given;
    batten_fit_report report = {0};
    if (m->abscissae) {
        o.parameters = BATTEN_GIVEN;
        o.given = m->abscissae;
        o.corrections = 0;
    }
    const batten_status status =
        batten_curve_least_squares(m->points, &o, m->parameters, &report, &m->curve);
    return take(m, status, report.error, report.rms);
}

static batten_curve_least_squares_options fitting(void)
{
    batten_curve_least_squares_options o = batten_curve_least_squares_defaults();
    o.parameters = BATTEN_CHORD;
    o.hold_start = o.hold_end = true;
    o.corrections = 10;
    return o;
}

static batten_status fit_as_it_is(agree_made *m)
{
    const batten_curve_least_squares_options o = fitting();
    return least_squares(m, &o);
}

static batten_status fit_with_options(agree_made *m)
{
    batten_curve_least_squares_options o = fitting();
    o.degree = 2;
    o.point_count = 5;
    o.parameters = BATTEN_UNIFORM;
    o.knots = BATTEN_KNOTS_BY_CURVATURE;
    o.corrections = 2;
    o.hold_start = o.hold_end = false;
    o.weights = weights;
    return least_squares(m, &o);
}

static batten_status fit_closed(agree_made *m)
{
    batten_curve_least_squares_options o = fitting();
    o.closed = true;
    o.hold_start = o.hold_end = false;
    o.point_count = 6;
    return least_squares(m, &o);
}

static batten_status fit_robust(agree_made *m)
{
    batten_curve_least_squares_options o = fitting();
    o.point_count = 4;
    o.robust = BATTEN_ABSOLUTE;
    return least_squares(m, &o);
}

static batten_status fit_within(agree_made *m, const batten_curve_within_options *given)
{
    batten_curve_within_options o = *given;
    batten_curve_within_report report = {0};
    if (m->abscissae) {
        o.parameters = BATTEN_GIVEN;
        o.given = m->abscissae;
    }
    const batten_status status =
        batten_curve_within(m->points, &o, m->parameters, &report, &m->curve);
    return take(m, status, report.error, report.rms);
}

static batten_status within_as_it_is(agree_made *m)
{
    batten_curve_within_options o = batten_curve_within_defaults();
    o.tolerance = 0.2;
    o.parameters = BATTEN_CHORD;
    return fit_within(m, &o);
}

static batten_status within_with_corners(agree_made *m)
{
    static const int corners[] = {2, 3};
    batten_curve_within_options o = batten_curve_within_defaults();
    o.tolerance = 0.1;
    o.method = BATTEN_WITHIN_REMOVE;
    o.degree = 2;
    o.parameters = BATTEN_UNIFORM;
    o.corner_count = 2;
    o.corners = corners;
    return fit_within(m, &o);
}

static batten_status within_by_angle(agree_made *m)
{
    batten_curve_within_options o = batten_curve_within_defaults();
    o.tolerance = 0.1;
    o.parameters = BATTEN_CHORD;
    o.method = BATTEN_WITHIN_BEZIER;
    o.corner = 1; /* radians */
    return fit_within(m, &o);
}

static batten_status within_closed(agree_made *m)
{
    batten_curve_within_options o = batten_curve_within_defaults();
    o.tolerance = 0.1;
    o.parameters = BATTEN_CHORD;
    o.method = BATTEN_WITHIN_INSERT;
    o.closed = true;
    return fit_within(m, &o);
}

TEST(fitted_curves_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{least-squares: s}", fit_as_it_is},
        {"{least-squares: s, degree: 2, points: 5, parameters: uniform, knots: curvature, "
         "corrections: 2, hold-ends: no, weights: [1, 2, 3, 4, 3, 2, 1]}",
         fit_with_options},
        {"{least-squares: s, closed: yes, points: 6}", fit_closed},
        {"{least-squares: s, points: 4, robust: absolute}", fit_robust},
        {"{fit-within: s, within: 0.2}", within_as_it_is},
        {"{fit-within: s, within: 0.1, by: remove, degree: 2, parameters: uniform, corners: [3, "
         "4]}",
         within_with_corners},
        {"{fit-within: s, within: 0.1, by: bezier, corner: 1 rad}", within_by_angle},
        {"{fit-within: s, within: 0.1, by: insert, closed: yes}", within_closed},
    };
    static const agree_row of_functions[] = {
        {"{least-squares: p, as: function}", fit_as_it_is},
        {"{least-squares: p, points: 4, robust: absolute, as: function}", fit_robust},
        {"{fit-within: p, within: 0.2, as: function}", within_as_it_is},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}
