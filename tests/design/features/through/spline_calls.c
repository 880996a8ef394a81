#include "design/agree.h"

#include <batten/bent.h>
#include <batten/interpolate.h>
#include <batten/local.h>

/* Splines through points are the calls behind them, with each option in its place. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, 1, 2], [5.5, 0, 0]]}\n"
    "  p: {points: [[0, 1, 0], [1, 1, 2], [2, 1, 2.5], [3, 1, 4], [5, 1, 4.5], [5.5, 1, 6]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1, 0.5, 2, 0.2, 1, 3, 1.5, 3, 4, 1, 2, 5.5, 0, 0};
static const double abscissae[] = {0, 1, 2, 3, 5, 5.5}, values[] = {0, 2, 2.5, 4, 4.5, 6},
                    of_six[] = {1, 2, 3, 4, 5, 6};

static const agree_made space = {.points = {3, 6, of_s}}, function = {.points = {1, 6, values},
                                                                      .abscissae = abscissae,
                                                                      .axis = 1,
                                                                      .level = 1};

static batten_parametrization of_points(const agree_made *m, batten_parametrization own)
{
    return m->abscissae ? BATTEN_GIVEN : own;
}

/* Ends of functions have their slope as the first number. */
static batten_end end_of(const agree_made *m, batten_end_kind kind)
{
    return m->abscissae ? (batten_end){kind, {0.5}} : (batten_end){kind, {0.5, 1, 2}};
}

/* ---- in tension ---- */

static batten_status tension(agree_made *m, batten_chain_tension_options *o, bool rational)
{
    o->given = m->abscissae;
    return rational ? batten_curve_rational_tension(m->points, o, m->parameters, &m->curve)
                    : batten_chain_tension(m->points, o, m->parameters, &m->chain);
}

static batten_chain_tension_options pulled(const agree_made *m)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = of_points(m, BATTEN_CENTRIPETAL);
    o.tensions = of_six;
    o.start = end_of(m, BATTEN_END_CLAMPED);
    o.end = end_of(m, BATTEN_END_SECOND);
    return o;
}

static batten_status tension_with_options(agree_made *m)
{
    batten_chain_tension_options o = pulled(m);
    return tension(m, &o, false);
}

static batten_status tension_closed(agree_made *m)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = BATTEN_CHORD;
    o.closed = true;
    o.tensions = of_six;
    return tension(m, &o, false);
}

static batten_status tension_by_rule(agree_made *m)
{
    static const double none[6] = {0};
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = of_points(m, BATTEN_CHORD);
    o.rule = BATTEN_TENSION_MONOTONE;
    o.slack = 0.1;
    o.tensions = none;
    return tension(m, &o, false);
}

static batten_status rational_with_options(agree_made *m)
{
    batten_chain_tension_options o = pulled(m);
    return tension(m, &o, true);
}

static batten_status rational_closed(agree_made *m)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    o.parameters = BATTEN_CHORD;
    o.closed = true;
    o.tensions = of_six;
    return tension(m, &o, true);
}

#define ENDS "start: clamped, start-vector: [0.5, 1, 2], end: second, end-vector: [0.5, 1, 2]"
#define SLOPES \
    "start: clamped, start-vector: [0.5, 0], end: second, end-vector: [0.5, 0], as: function"

TEST(splines_in_tension_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{tension: s, amount: [1, 2, 3, 4, 5], parameters: centripetal, " ENDS "}",
         tension_with_options},
        {"{tension: s, amount: [1, 2, 3, 4, 5, 6], closed: yes}", tension_closed},
        {"{rational-tension: s, amount: [1, 2, 3, 4, 5], parameters: centripetal, " ENDS "}",
         rational_with_options},
        {"{rational-tension: s, amount: [1, 2, 3, 4, 5, 6], closed: yes}", rational_closed},
    };
    static const agree_row of_functions[] = {
        {"{tension: p, amount: [1, 2, 3, 4, 5], " SLOPES "}", tension_with_options},
        {"{rational-tension: p, amount: [1, 2, 3, 4, 5], " SLOPES "}", rational_with_options},
        {"{tension: p, rule: monotone, slack: 0.1, as: function}", tension_by_rule},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- weighted ---- */

static batten_status weighted(agree_made *m, bool nus, bool weights, bool closed)
{
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.parameters = of_points(m, closed ? BATTEN_CHORD : BATTEN_UNIFORM);
    o.given = m->abscissae;
    o.closed = closed;
    if (!closed) {
        o.start = end_of(m, BATTEN_END_CLAMPED);
        o.end = end_of(m, BATTEN_END_SECOND);
    }
    o.nus = nus ? of_six : NULL;
    o.rule = nus || weights ? BATTEN_WEIGHTS_GIVEN : BATTEN_WEIGHTS_SLOPE;
    o.weights = weights ? of_six : NULL;
    return batten_curve_weighted(m->points, &o, m->parameters, &m->curve);
}

static batten_status nu_spline(agree_made *m)
{
    return weighted(m, true, false, false);
}

static batten_status nu_closed(agree_made *m)
{
    return weighted(m, true, false, true);
}

static batten_status weighted_spline(agree_made *m)
{
    return weighted(m, false, true, false);
}

static batten_status weighted_closed(agree_made *m)
{
    return weighted(m, false, true, true);
}

static batten_status weighted_by_slopes(agree_made *m)
{
    return weighted(m, false, false, false);
}

TEST(nu_splines_and_weighted_ones_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{nu-spline: s, nu: [1, 2, 3, 4, 5, 6], parameters: uniform, " ENDS "}", nu_spline},
        {"{nu-spline: s, nu: [1, 2, 3, 4, 5, 6], closed: yes}", nu_closed},
        {"{weighted-spline: s, weights: [1, 2, 3, 4, 5], parameters: uniform, " ENDS "}",
         weighted_spline},
        {"{weighted-spline: s, weights: [1, 2, 3, 4, 5, 6], closed: yes}", weighted_closed},
    };
    static const agree_row of_functions[] = {
        {"{nu-spline: p, nu: [1, 2, 3, 4, 5, 6], " SLOPES "}", nu_spline},
        {"{weighted-spline: p, " SLOPES "}", weighted_by_slopes},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- parabolas and beta-splines ---- */

static batten_status parabolas(agree_made *m, batten_quadratic_kind kind,
                               batten_quadratic_slope slope, batten_parametrization parameters)
{
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    o.kind = kind;
    o.slope = slope;
    o.parameters = of_points(m, parameters);
    o.given = m->abscissae;
    for (int k = 0; k < 3; k++)
        o.vector[k] = k + 1;
    return batten_curve_quadratic(m->points, &o, m->parameters, &m->curve);
}

static batten_status parabolas_between(agree_made *m)
{
    return parabolas(m, BATTEN_QUADRATIC_BETWEEN, BATTEN_QUADRATIC_BEST, BATTEN_CHORD);
}

static batten_status parabolas_about(agree_made *m)
{
    return parabolas(m, BATTEN_QUADRATIC_MIDPOINTS, BATTEN_QUADRATIC_BEST, BATTEN_UNIFORM);
}

static batten_status parabolas_from_start(agree_made *m)
{
    return parabolas(m, BATTEN_QUADRATIC_SEQUENTIAL, BATTEN_QUADRATIC_AT_START,
                     BATTEN_CENTRIPETAL);
}

static batten_status parabolas_to_end(agree_made *m)
{
    return parabolas(m, BATTEN_QUADRATIC_SEQUENTIAL, BATTEN_QUADRATIC_AT_END, BATTEN_CHORD);
}

static batten_status beta_near(agree_made *m)
{
    return batten_curve_beta(m->points, BATTEN_BETA_NEAR, 1.5, 2, false, &m->curve);
}

static batten_status beta_through(agree_made *m)
{
    for (int i = 0; i < 6; i++)
        m->parameters[i] = i;
    return batten_curve_beta(m->points, BATTEN_BETA_THROUGH, 1, 0, true, &m->curve);
}

TEST(parabolas_and_beta_splines_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{quadratic-spline: s}", parabolas_between},
        {"{quadratic-spline: s, knots: midpoints}", parabolas_about},
        {"{quadratic-spline: s, knots: sequential, slope: start, vector: [1, 2, 3], parameters: "
         "centripetal}",
         parabolas_from_start},
        {"{quadratic-spline: s, knots: sequential, slope: end, vector: [1, 2, 3]}",
         parabolas_to_end},
        {"{beta-spline: s, beta1: 1.5, beta2: 2}", beta_near},
        {"{beta-spline: s, use: through, closed: yes}", beta_through},
    };
    static const agree_row of_functions[] = {
        {"{quadratic-spline: p, as: function}", parabolas_between},
        {"{quadratic-spline: p, knots: sequential, slope: start, vector: [1, 2, 3], as: function}",
         parabolas_from_start},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- directions, corners, conditions ---- */

static batten_status directed(agree_made *m)
{
    static const batten_direction_at at[] = {{1, {1, 0, 0}}, {4, {0, -1, -1}}};
    batten_curve_directed_options o = batten_curve_directed_defaults();
    o.parameters = BATTEN_UNIFORM;
    o.direction_count = 2;
    o.directions = at;
    o.tension = of_six;
    return batten_curve_directed(m->points, &o, m->parameters, NULL, &m->curve);
}

static batten_status cornered(agree_made *m)
{
    static const int corners[] = {2}, straight[] = {3};
    batten_curve_cornered_options o = batten_curve_cornered_defaults();
    o.parameters = BATTEN_CENTRIPETAL;
    o.corner_count = 1;
    o.corners = corners;
    o.line_count = 1;
    o.lines = straight;
    o.transition = BATTEN_TRANSITION_CURVATURE;
    o.ends = BATTEN_END_PARABOLIC;
    return batten_curve_cornered(m->points, &o, m->parameters, &m->curve);
}

#define CORNERED(name, kind)                                                   \
    static batten_status cornered_##name(agree_made *m)                        \
    {                                                                          \
        batten_curve_cornered_options o = batten_curve_cornered_defaults();    \
        o.parameters = BATTEN_CHORD;                                           \
        o.ends = BATTEN_END_##kind;                                            \
        return batten_curve_cornered(m->points, &o, m->parameters, &m->curve); \
    }
CORNERED(natural, NATURAL)
CORNERED(free, NOT_A_KNOT)
CORNERED(bessel, BESSEL)
CORNERED(circle, CIRCLE)

static batten_status constrained(agree_made *m)
{
    const batten_constraint list[] = {
        {.kind = BATTEN_CONSTRAINT_SLOPE, .normal = {1, 0, 0}},
        {.kind = BATTEN_CONSTRAINT_DIRECTION, .from = 2, .normal = {1, 1, 0}, .bound = 0.25},
    };
    batten_curve_constrained_options o = batten_curve_constrained_defaults();
    o.degree = 5;
    o.pieces = 2;
    o.order = 3;
    o.checks = 2;
    o.parameters = BATTEN_UNIFORM;
    o.constraint_count = 2;
    o.constraints = list;
    return batten_curve_constrained(m->points, &o, m->parameters, NULL, &m->curve);
}

/* Of a function: f' >= 0.1; f' = 2 at point 3; 0.5 x + 2 f >= 1 from point 2 to point 4. */
static batten_status constrained_function(agree_made *m)
{
    const batten_constraint list[] = {
        {.kind = BATTEN_CONSTRAINT_VALUE,
         .normal = {2},
         .bound = 1,
         .rate = -0.5,
         .from = 1,
         .to = 3},
        {.kind = BATTEN_CONSTRAINT_SLOPE, .normal = {1}, .bound = 0.1},
        {.kind = BATTEN_CONSTRAINT_DIRECTION, .from = 2, .normal = {2}},
    };
    batten_curve_constrained_options o = batten_curve_constrained_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = abscissae;
    o.constraint_count = 3;
    o.constraints = list;
    return batten_curve_constrained(m->points, &o, m->parameters, NULL, &m->curve);
}

TEST(curves_with_directions_corners_and_conditions_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{directed-spline: s, at: [2, 5], directions: [[1, 0, 0], [0, -1, -1]], tension: [1, 2, "
         "3, 4, 5, 6], parameters: uniform}",
         directed},
        {"{cornered-spline: s, corners: 3, lines: 4, transition: curvature, parameters: "
         "centripetal, ends: parabolic}",
         cornered},
        {"{cornered-spline: s}", cornered_natural},
        {"{cornered-spline: s, ends: not-a-knot}", cornered_free},
        {"{cornered-spline: s, ends: bessel}", cornered_bessel},
        {"{cornered-spline: s, ends: circle}", cornered_circle},
        {"{constrained: s, forward: [[1, 0, 0]], at: 3, directions: [[1, 1, 0]], speed: 0.25, "
         "degree: 5, pieces: 2, minimise: variation, checks: 2, parameters: uniform}",
         constrained},
    };
    static const agree_row of_functions[] = {
        {"{constrained: p, as: function, lines: [[0, 1, 0.5]], sides: [[0.5, 0, 2]], from: 2, to: "
         "4, forward: [[-0.1, 0, 1]], at: 3, directions: [[2, 0, 4]]}",
         constrained_function},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}
