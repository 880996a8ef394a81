#include "design/agree.h"

#include <batten/arcs.h>

/* Arcs are those of the calls behind them, with each option in its place. */

static const char lines[] =
    "  s: {points: [[0, 0, 1], [1, 1, 0.5], [2, 0.2, 1], [3, 1.5, 3], [4, 1, 2], [5.5, 0, 0], [7, 2, 1]]}\n"
    "  q: {points: [[0, 1, 0], [1, 1, 1], [2, 1, 1.6], [3, 1, 1.9], [5, 1, 1.5], [6, 1, 0.8], [7, 1, -1]]}\n"
    "  r: {points: [[5, 1, 0], [4, 1, 3], [0, 1, 5], [-4, 1, 3], [-5, 1, 0], [-4, 1, -3], [0, 1, -5], [4, 1, -3]]}\n";
static const double of_s[] = {0, 0, 1, 1, 1,   0.5, 2, 0.2, 1, 3, 1.5,
                              3, 4, 1, 2, 5.5, 0,   0, 7,   2, 1};
static const double of_q[] = {0, 0, 1, 1, 2, 1.6, 3, 1.9, 5, 1.5, 6, 0.8, 7, -1};

static const agree_made space = {.points = {3, 7, of_s}},
                        gentle = {.points = {2, 7, of_q}, .axis = 1, .level = 1};

static batten_status arcs(agree_made *m, const batten_arcs_options *o)
{
    batten_arcs_report report;
    const batten_status status =
        batten_arcs_from_points(m->points, o, m->parameters, &report, &m->chain);
    m->error = m->rms = report.error;
    return status;
}

static batten_status plain_arcs(agree_made *m)
{
    batten_arcs_options o = batten_arcs_defaults();
    o.tolerance = 0.3;
    o.joined = BATTEN_ARCS_PLAIN;
    o.spread = false;
    return arcs(m, &o);
}

static batten_status arcs_on_one_side(agree_made *m)
{
    batten_arcs_options o = batten_arcs_defaults();
    o.tolerance = 0.3;
    o.joined = BATTEN_ARCS_PLAIN;
    o.side = BATTEN_ARCS_LEFT;
    o.least_radius = 0.1;
    o.most = 20;
    return arcs(m, &o);
}

static batten_status closed_arcs(agree_made *m)
{
    batten_arcs_options o = batten_arcs_defaults();
    static const double ring[] = {5, 0, 4, 3, 0, 5, -4, 3, -5, 0, -4, -3, 0, -5, 4, -3};
    o.tolerance = 0.3;
    o.side = BATTEN_ARCS_INSIDE;
    o.closed = true;
    m->points = (batten_points){2, 8, ring};
    return arcs(m, &o);
}

static batten_status biarcs(agree_made *m, batten_biarc_joint joint, double place, bool closed)
{
    batten_chain_biarcs_options o = batten_chain_biarcs_defaults();
    o.joint = joint;
    o.place = place;
    o.closed = closed;
    return m->points.dimension == 3
               ? batten_curve_biarcs(m->points, &o, m->parameters, &m->curve)
               : batten_chain_biarcs(m->points, &o, m->parameters, NULL, &m->chain);
}

static batten_status biarcs_as_they_are(agree_made *m)
{
    return biarcs(m, BATTEN_JOINT_AUTOMATIC, 0.5, false);
}

static batten_status biarcs_at_a_place(agree_made *m)
{
    return biarcs(m, BATTEN_JOINT_GIVEN, 0.3, false);
}

static batten_status closed_biarcs(agree_made *m)
{
    return biarcs(m, BATTEN_JOINT_EQUAL_LEGS, 0.5, true);
}

static batten_status sequential(agree_made *m)
{
    return batten_chain_sequential_arcs(m->points, (double)NAN, NULL, m->parameters, NULL,
                                        &m->chain);
}

static batten_status sequential_from(agree_made *m)
{
    return batten_chain_sequential_arcs(m->points, 0.5, NULL, m->parameters, NULL, &m->chain);
}

TEST(arcs_are_those_of_their_calls)
{
    static const agree_row in_plane[] = {
        {"{arcs: q, within: 0.3, joined: plain, spread: no}", plain_arcs},
        {"{arcs: q, within: 0.3, joined: plain, one-sided: left, least-radius: 0.1, most: 20}",
         arcs_on_one_side},
        {"{arcs: r, within: 0.3, closed: yes, one-sided: inside}", closed_arcs},
        {"{biarcs: q}", biarcs_as_they_are},
        {"{biarcs: q, joint: given, place: 0.3}", biarcs_at_a_place},
        {"{biarcs: q, joint: equal-legs, closed: yes}", closed_biarcs},
        {"{sequential-arcs: q}", sequential},
        {"{sequential-arcs: q, start-angle: 0.5 rad}", sequential_from},
    };
    static const agree_row in_space[] = {
        {"{biarcs: s, in: space}", biarcs_as_they_are},
        {"{biarcs: s, in: space, closed: yes, joint: equal-legs}", closed_biarcs},
    };
    AGREE(lines, &gentle, in_plane);
    AGREE(lines, &space, in_space);
}
