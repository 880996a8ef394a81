#include "design/agree.h"

#include <batten/local.h>
#include <batten/standard.h>

/* Local methods are the calls behind them, with each option in its place. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, 1, 2], [5.5, 0, 0]]}\n"
    "  p: {points: [[0, 1, 0], [1, 1, 2], [2, 1, 2.5], [3, 1, 4], [5, 1, 4.5], [5.5, 1, 6]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1, 0.5, 2, 0.2, 1, 3, 1.5, 3, 4, 1, 2, 5.5, 0, 0};
static const double abscissae[] = {0, 1, 2, 3, 5, 5.5}, values[] = {0, 2, 2.5, 4, 4.5, 6};

static const agree_made space = {.points = {3, 6, of_s}}, function = {.points = {1, 6, values},
                                                                      .abscissae = abscissae,
                                                                      .axis = 1,
                                                                      .level = 1};

/* Tangents that are given. */
static const double of_space[] = {1, 1, 0, 1, 0, 0, 1, 0.5, 1, 1, 0, 0, 1, -1, -1, 1, -1, 0};

/* ---- tangents by rules ---- */

static batten_status by_tangents(agree_made *m, batten_tangent_rule rule,
                                 batten_tangent_length length, batten_corner corners,
                                 bool closed)
{
    double leaving[3 * AGREE_POINTS], arriving[3 * AGREE_POINTS];
    batten_tangents_options o = batten_tangents_defaults();
    o.rule = rule;
    o.length = length;
    o.corners = corners;
    o.closed = closed;
    o.given = rule == BATTEN_TANGENT_GIVEN ? of_space : NULL;
    const batten_status status =
        batten_tangents(m->points, &o, m->parameters, NULL, leaving, arriving);
    return status == BATTEN_OK ? batten_curve_from_tangents(m->points, m->parameters, leaving,
                                                            arriving, closed, &m->curve)
                               : status;
}

#define BY_TANGENTS(name, rule, length, corners, closed)                     \
    static batten_status name(agree_made *m)                                 \
    {                                                                        \
        return by_tangents(m, BATTEN_TANGENT_##rule, BATTEN_LENGTH_##length, \
                           BATTEN_CORNER_##corners, closed);                 \
    }
BY_TANGENTS(akima, RENNER, CHORD, ROUND, false)
BY_TANGENTS(akima_closed, RENNER, CHORD, ROUND, true)
BY_TANGENTS(bessel, BESSEL, RULE, ROUND, false)
BY_TANGENTS(bessel_closed, BESSEL, RULE, ROUND, true)
BY_TANGENTS(circle_chord, CIRCLE, CHORD, ROUND, false)
BY_TANGENTS(circle_middle, CIRCLE, MIDDLE, ROUND, false)
BY_TANGENTS(circle_closed, CIRCLE, MIDDLE, ROUND, true)
BY_TANGENTS(renner, RENNER, MIDDLE, ROUND, false)
BY_TANGENTS(renner_corners, RENNER, MIDDLE, KEEP, true)
BY_TANGENTS(parabolas, PARABOLA, RULE, ROUND, false)
BY_TANGENTS(bisectors, BISECTOR, MIDDLE, ROUND, true)
BY_TANGENTS(given, GIVEN, CHORD, ROUND, false)

TEST(cubics_by_tangents_are_those_of_their_calls)
{
    static const agree_row rows[] = {
        {"{akima: s}", akima},
        {"{akima: s, closed: yes}", akima_closed},
        {"{bessel: s}", bessel},
        {"{bessel: s, closed: yes}", bessel_closed},
        {"{circle-tangents: s}", circle_chord},
        {"{circle-tangents: s, lengths: middle}", circle_middle},
        {"{mcconalogue: s}", circle_middle},
        {"{mcconalogue: s, closed: yes}", circle_closed},
        {"{renner: s}", renner},
        {"{renner: s, corners: keep, closed: yes}", renner_corners},
        {"{hermite: s}", circle_chord},
        {"{hermite: s, estimate: parabola, lengths: rule}", parabolas},
        {"{hermite: s, estimate: bisector, lengths: middle, closed: yes}", bisectors},
        {"{hermite: s, tangents: [[1, 1, 0], [1, 0, 0], [1, 0.5, 1], [1, 0, 0], [1, -1, -1], "
         "[1, -1, 0]]}",
         given},
    };
    AGREE(lines, &space, rows);
}

/* ---- quintics ---- */

static batten_status quintic(agree_made *m, const double *second, double scale)
{
    double tangents[18], found[18], values_of[54];
    batten_tangents_options o = batten_tangents_defaults();
    o.rule = BATTEN_TANGENT_BESSEL;
    o.length = BATTEN_LENGTH_RULE;
    batten_status status = batten_tangents(m->points, &o, m->parameters, NULL, tangents, NULL);
    if (status == BATTEN_OK && !second)
        status = batten_second_derivatives(m->points, m->parameters, tangents, false, found);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++) {
            values_of[9 * i + k] = of_s[3 * i + k];
            values_of[9 * i + 3 + k] = tangents[3 * i + k];
            values_of[9 * i + 6 + k] = second ? scale * second[3 * i + k] : found[3 * i + k];
        }
    return status == BATTEN_OK
               ? batten_curve_from_hermite(3, 6, 3, m->parameters, values_of, &m->curve)
               : status;
}

static batten_status quintic_alone(agree_made *m)
{
    return quintic(m, NULL, 1);
}

static batten_status quintic_bent(agree_made *m)
{
    return quintic(m, of_space, 2);
}

TEST(quintics_have_the_second_derivatives_that_are_given_or_estimated)
{
    static const agree_row rows[] = {
        {"{hermite: s, degree: quintic, estimate: bessel, lengths: rule}", quintic_alone},
        {"{hermite: s, degree: quintic, estimate: bessel, lengths: rule, second: [[2, 2, 0], [2, "
         "0, 0], [2, 1, 2], [2, 0, 0], [2, -2, -2], [2, -2, 0]]}",
         quintic_bent},
    };
    AGREE(lines, &space, rows);
}

/* ---- with phantom points ---- */

static batten_status kochanek(agree_made *m, const double *three[3], double alpha,
                              batten_phantoms phantoms, bool closed)
{
    double leaving[3 * AGREE_POINTS], arriving[3 * AGREE_POINTS];
    batten_tangents_kochanek_bartels_options o = batten_tangents_kochanek_bartels_defaults();
    o.tension = three[0];
    o.continuity = three[1];
    o.bias = three[2];
    o.alpha = alpha;
    o.given = m->abscissae;
    o.closed = closed;
    o.phantoms = phantoms;
    const batten_status status =
        batten_tangents_kochanek_bartels(m->points, &o, m->parameters, leaving, arriving);
    return status == BATTEN_OK ? batten_curve_from_tangents(m->points, m->parameters, leaving,
                                                            arriving, closed, &m->curve)
                               : status;
}

static const double tensions[] = {0.1, 0.2, -0.3, 0.4, 0.5, 0.6},
                    continuities[] = {0.3, 0.3, 0.3, 0.3, 0.3, 0.3},
                    biases[] = {0.5, 0.4, 0.3, 0.2, 0.1, 0}, none[6] = {0};

static batten_status cardinal(agree_made *m)
{
    return kochanek(m, (const double *[]){tensions, NULL, NULL}, 0, BATTEN_PHANTOM_EXTRAPOLATE,
                    false);
}

static batten_status cardinal_closed(agree_made *m)
{
    return kochanek(m, (const double *[]){none, NULL, NULL}, 1, BATTEN_PHANTOM_EXTRAPOLATE,
                    true);
}

static batten_status shaped(agree_made *m)
{
    return kochanek(m, (const double *[]){tensions, continuities, biases}, 0.5,
                    BATTEN_PHANTOM_REFLECT, false);
}

static batten_status catmull(agree_made *m, int blend, int local, double alpha,
                             batten_phantoms phantoms, bool closed)
{
    batten_curve_catmull_rom_options o = batten_curve_catmull_rom_defaults();
    o.blend = blend;
    o.local = local;
    o.alpha = alpha;
    o.given = m->abscissae;
    o.closed = closed;
    o.phantoms = phantoms;
    return batten_curve_catmull_rom(m->points, &o, m->parameters, NULL, &m->curve);
}

static batten_status catmull_rom(agree_made *m)
{
    return catmull(m, 2, 1, 0.5, BATTEN_PHANTOM_EXTRAPOLATE, false);
}

static batten_status catmull_rom_with_options(agree_made *m)
{
    return catmull(m, 3, 1, 1, BATTEN_PHANTOM_REPEAT, false);
}

static batten_status catmull_rom_closed(agree_made *m)
{
    return catmull(m, 1, 2, 0, BATTEN_PHANTOM_EXTRAPOLATE, true);
}

TEST(cardinal_and_catmull_rom_splines_are_those_of_their_calls)
{
    static const agree_row in_space[] = {
        {"{cardinal: s, tension: [0.1, 0.2, -0.3, 0.4, 0.5, 0.6]}", cardinal},
        {"{cardinal: s, alpha: 1, closed: yes}", cardinal_closed},
        {"{kochanek-bartels: s, tension: [0.1, 0.2, -0.3, 0.4, 0.5, 0.6], continuity: 0.3, bias: "
         "[0.5, 0.4, 0.3, 0.2, 0.1, 0], alpha: 0.5, beyond: reflect}",
         shaped},
        {"{catmull-rom: s}", catmull_rom},
        {"{catmull-rom: s, blend: 3, alpha: 1, beyond: repeat}", catmull_rom_with_options},
        {"{catmull-rom: s, blend: 1, local: 2, alpha: 0, closed: yes}", catmull_rom_closed},
    };
    static const agree_row of_functions[] = {
        {"{cardinal: p, tension: [0.1, 0.2, -0.3, 0.4, 0.5, 0.6], as: function}", cardinal},
        {"{catmull-rom: p, as: function}", catmull_rom},
    };
    AGREE(lines, &space, in_space);
    AGREE(lines, &function, of_functions);
}

/* ---- functions ---- */

static batten_status by_slopes(agree_made *m, batten_slope_rule rule)
{
    double slopes[6];
    memcpy(m->parameters, abscissae, sizeof abscissae);
    const batten_status status = batten_slopes(6, abscissae, values, rule, slopes);
    return status == BATTEN_OK ? batten_curve_from_tangents(m->points, abscissae, slopes, NULL,
                                                            false, &m->curve)
                               : status;
}

#define BY_SLOPES(name, rule)                     \
    static batten_status name(agree_made *m)      \
    {                                             \
        return by_slopes(m, BATTEN_SLOPE_##rule); \
    }
BY_SLOPES(slopes_of_akima, AKIMA)
BY_SLOPES(slopes_of_makima, MAKIMA)
BY_SLOPES(slopes_of_bessel, BESSEL)
BY_SLOPES(slopes_of_carlson, FRITSCH_CARLSON)
BY_SLOPES(slopes_of_butland, FRITSCH_BUTLAND)
BY_SLOPES(slopes_of_steffen, STEFFEN)

static batten_status rational(agree_made *m)
{
    memcpy(m->parameters, abscissae, sizeof abscissae);
    return batten_curve_rational_monotone(6, abscissae, values, NULL, &m->curve);
}

static batten_status schumaker(agree_made *m)
{
    memcpy(m->parameters, abscissae, sizeof abscissae);
    return batten_curve_schumaker(6, abscissae, values, NULL, &m->curve);
}

TEST(local_functions_are_those_of_their_calls)
{
    static const agree_row rows[] = {
        {"{akima: p, as: function}", slopes_of_akima},
        {"{akima: p, as: function, modified: yes}", slopes_of_makima},
        {"{bessel: p, as: function}", slopes_of_bessel},
        {"{fritsch-carlson: p}", slopes_of_carlson},
        {"{fritsch-butland: p}", slopes_of_butland},
        {"{steffen: p}", slopes_of_steffen},
        {"{rational-monotone: p}", rational},
        {"{schumaker: p}", schumaker},
    };
    AGREE(lines, &function, rows);
}
