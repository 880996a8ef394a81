#include "design/agree.h"

#include <batten/arcs.h>
#include <batten/bent.h>
#include <batten/local.h>

/* Conics, and cubics of given curvature, are the calls behind them. */

static const char lines[] =
    "  q: {points: [[0, 2, 0], [1, 2, 1], [2, 2, 1.6], [3, 2, 1.9], [5, 2, 1.5], [6, 2, 0.8]]}\n"
    "  pair: {points: [[0, 2, 0], [4, 2, 1]]}\n";
static const double of_q[] = {0, 0, 1, 1, 2, 1.6, 3, 1.9, 5, 1.5, 6, 0.8};
static const double of_pair[] = {0, 0, 4, 1};

static const agree_made plane = {.points = {2, 6, of_q}, .axis = 1, .level = 2},
                        two = {.points = {2, 2, of_pair}, .axis = 1, .level = 2};

/* Tangents that are given. */
static const double of_plane[] = {1, 1, 1, 0.9, 1, 0.5, 1, 0.2, 1, -0.4, 1, -1};

static batten_status conics(agree_made *m, const batten_curve_conics_options *o)
{
    return batten_curve_conics(m->points, o, m->parameters, NULL, &m->curve);
}

static batten_status conic_spline(agree_made *m)
{
    static const double curvatures[] = {-0.5, -0.4, -0.3, -0.2, -0.2, -0.3};
    batten_curve_conics_options o = batten_curve_conics_defaults();
    o.tangents = of_plane;
    o.curvatures = curvatures;
    o.start_share = 0.4;
    o.end_share = 0.3;
    return conics(m, &o);
}

static batten_status conics_closed(agree_made *m)
{
    batten_curve_conics_options o = batten_curve_conics_defaults();
    o.closed = true;
    return conics(m, &o);
}

static batten_status local_conics(agree_made *m)
{
    batten_curve_conics_options o = batten_curve_conics_defaults();
    o.kind = BATTEN_CONICS_SINGLE;
    o.tangents = of_plane;
    o.weight = 2;
    return conics(m, &o);
}

static batten_status local_conics_closed(agree_made *m)
{
    batten_curve_conics_options o = batten_curve_conics_defaults();
    o.kind = BATTEN_CONICS_SINGLE;
    o.closed = true;
    return conics(m, &o);
}

static batten_status from_curvatures(agree_made *m, const double *tangents,
                                     const double *curvatures, bool closed)
{
    double own[12], bends[6];
    batten_tangents_options o = batten_tangents_defaults();
    o.closed = closed;
    batten_status status = batten_tangents(m->points, &o, m->parameters, NULL, own, NULL);
    if (status == BATTEN_OK)
        status = batten_circle_curvatures(m->points, closed, bends);
    return status == BATTEN_OK
               ? batten_curve_from_curvatures(
                     &(batten_curved_points){m->points, tangents ? tangents : own,
                                             curvatures ? curvatures : bends, closed},
                     m->parameters, NULL, NULL, &m->curve)
               : status;
}

static batten_status with_tangents(agree_made *m)
{
    return from_curvatures(m, of_plane, NULL, false);
}

static batten_status with_curvatures(agree_made *m)
{
    static const double curvatures[] = {-0.1, -0.1, -0.1, -0.1, -0.1, -0.1};
    return from_curvatures(m, NULL, curvatures, false);
}

static batten_status with_neither(agree_made *m)
{
    return from_curvatures(m, NULL, NULL, true);
}

static batten_status in_tension(agree_made *m)
{
    static const double pulled[] = {2, 2, 2, 2, 2, 2};
    batten_chain_nonlinear_options o = batten_chain_nonlinear_defaults();
    o.family = BATTEN_FAMILY_LOCAL_TENSION;
    o.start = BATTEN_NONLINEAR_TANGENT;
    o.start_value = 1;
    o.end = BATTEN_NONLINEAR_CURVATURE;
    o.end_value = -0.1;
    o.tensions = pulled;
    return batten_chain_nonlinear(m->points, &o, NULL, m->parameters, NULL, &m->chain);
}

static batten_status without_tension(agree_made *m)
{
    batten_chain_nonlinear_options o = batten_chain_nonlinear_defaults();
    o.family = BATTEN_FAMILY_LOCAL_TENSION;
    o.closed = true;
    return batten_chain_nonlinear(m->points, &o, NULL, m->parameters, NULL, &m->chain);
}

static batten_status pair_of_conics(agree_made *m, const double *curvatures)
{
    const double tangents[] = {cos(1), sin(1), cos(-0.5), sin(-0.5)};
    batten_curve_conics_options o = batten_curve_conics_defaults();
    o.kind = curvatures ? BATTEN_CONICS_PAIRS : BATTEN_CONICS_PARABOLAS;
    o.tangents = tangents;
    o.curvatures = curvatures;
    o.start_share = curvatures ? 0.4 : 0;
    o.end_share = curvatures ? 0.3 : 0;
    return conics(m, &o);
}

static batten_status two_conics(agree_made *m)
{
    static const double curvatures[] = {-0.5, -0.25};
    return pair_of_conics(m, curvatures);
}

static batten_status two_parabolas(agree_made *m)
{
    return pair_of_conics(m, NULL);
}

#define TANGENTS \
    "tangents: [[1, 0, 1], [1, 0, 0.9], [1, 0, 0.5], [1, 0, 0.2], [1, 0, -0.4], [1, 0, -1]]"

TEST(conics_and_cubics_of_given_curvature_are_those_of_their_calls)
{
    static const agree_row rows[] = {
        {"{conic-spline: q, " TANGENTS ", curvatures: [-0.5, -0.4, -0.3, -0.2, -0.2, -0.3], "
         "start-share: 0.4, end-share: 0.3}",
         conic_spline},
        {"{conic-spline: q, closed: yes}", conics_closed},
        {"{local-conics: q, " TANGENTS ", weight: 2}", local_conics},
        {"{local-conics: q, closed: yes}", local_conics_closed},
        {"{tangents-and-curvatures: q, " TANGENTS "}", with_tangents},
        {"{tangents-and-curvatures: q, curvatures: -0.1}", with_curvatures},
        {"{tangents-and-curvatures: q, closed: yes}", with_neither},
        {"{local-tension: q, tension: 2, start: tangent, start-angle: 1 rad, end: curvature, "
         "end-curvature: -0.1}",
         in_tension},
        {"{local-tension: q, closed: yes}", without_tension},
    };
    static const agree_row of_two[] = {
        {"{conic-pair: pair, start-angle: 1 rad, end-angle: -0.5 rad, start-curvature: -0.5, "
         "end-curvature: -0.25, start-share: 0.4, end-share: 0.3}",
         two_conics},
        {"{conic-pair: pair, start-angle: 1 rad, end-angle: -0.5 rad}", two_parabolas},
    };
    AGREE(lines, &plane, rows);
    AGREE(lines, &two, of_two);
}
