#include "design/agree.h"

#include <batten/interpolate.h>

/* Interpolation is the call behind it, with each option in its place. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, 1, 2], [5.5, 0, 0]]}\n"
    "  p: {points: [[0, 1, 0], [1, 1, 2], [2, 1, 2.5], [3, 1, 4], [5, 1, 4.5], [5.5, 1, 6]]}\n"
    "  wave: {points: [[0, 1, 0], [1, 1, 2], [2, 1, 2.5], [3, 1, -4], [5, 1, 4.5], [5.5, 1, 0]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1, 0.5, 2, 0.2, 1, 3, 1.5, 3, 4, 1, 2, 5.5, 0, 0};
static const double abscissae[] = {0, 1, 2, 3, 5, 5.5}, values[] = {0, 2, 2.5, 4, 4.5, 6},
                    of_wave[] = {0, 2, 2.5, -4, 4.5, 0};

static const agree_made
    space = {.points = {3, 6, of_s}},
    function = {.points = {1, 6, values}, .abscissae = abscissae, .axis = 1, .level = 1},
    wave = {.points = {1, 6, of_wave}, .abscissae = abscissae, .axis = 1, .level = 1};

/* Ends of functions have their slope as the first number. */
static batten_end end_of(const agree_made *m, batten_end_kind kind)
{
    return m->abscissae ? (batten_end){kind, {0.5}} : (batten_end){kind, {0.5, 1, 2}};
}

#define ENDS "start: clamped, start-vector: [0.5, 1, 2], end: second, end-vector: [0.5, 1, 2]"
#define SLOPES \
    "start: clamped, start-vector: [0.5, 0], end: second, end-vector: [0.5, 0], as: function"

static batten_status interpolate(agree_made *m, const batten_curve_interpolate_options *given)
{
    batten_curve_interpolate_options o = *given;
    if (m->abscissae) {
        o.parameters = BATTEN_GIVEN;
        o.given = m->abscissae;
        memcpy(m->parameters, abscissae, sizeof abscissae);
    }
    return batten_curve_interpolate(m->points, &o, m->abscissae ? NULL : m->parameters,
                                    &m->curve);
}

static batten_status interpolated(agree_made *m)
{
    const batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    return interpolate(m, &o);
}

static batten_status quintic(agree_made *m)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.degree = 5;
    o.parameters = BATTEN_CHORD;
    o.knots_at_data = false;
    return interpolate(m, &o);
}

static batten_status averaged(agree_made *m)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.knots_at_data = false;
    return interpolate(m, &o);
}

static batten_status with_ends(agree_made *m)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.start = end_of(m, BATTEN_END_CLAMPED);
    o.end = end_of(m, BATTEN_END_SECOND);
    return interpolate(m, &o);
}

static batten_status periodic(agree_made *m)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.closed = true;
    return interpolate(m, &o);
}

/* The last point of a function is the first again. */
static batten_status periodic_function(agree_made *m)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.closed = true;
    o.parameters = BATTEN_GIVEN;
    o.given = abscissae;
    memcpy(m->parameters, abscissae, sizeof abscissae);
    return batten_curve_interpolate((batten_points){1, 5, of_wave}, &o, NULL, &m->curve);
}

TEST(interpolation_is_that_of_its_call)
{
    static const agree_row in_space[] = {
        {"{interpolate: s}", interpolated},
        {"{interpolate: s, degree: 5, parameters: chord}", quintic},
        {"{interpolate: s, knots: averaged}", averaged},
        {"{interpolate: s, " ENDS "}", with_ends},
        {"{interpolate: s, periodic: yes}", periodic},
    };
    static const agree_row of_functions[] = {
        {"{interpolate: p, as: function}", interpolated},
        {"{interpolate: p, " SLOPES "}", with_ends},
        {"{interpolate: p, degree: 5, as: function}", quintic},
    };
    static const agree_row of_waves[] = {
        {"{interpolate: wave, periodic: yes, as: function}", periodic_function},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
    AGREE(lines, &wave, of_waves);
}
