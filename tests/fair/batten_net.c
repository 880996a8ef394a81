#include "fair/batten_net.h"
#include "fair/hull.h"

static int count_strands(const bat_net *net, bool lines)
{
    int count = 0;
    for (int s = 0; s < net->strand_count; s++)
        count += net->strands[s].is_line == lines;
    return count;
}

TEST(every_point_of_a_full_table_lies_on_a_line_and_a_station)
{
    batten_offset_table *offsets = NULL;
    bat_net net;
    const batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(hull_make(hull_wigley(9, 6, 0), &offsets));
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_BOTH, &options, &net));
    CHECK_INT(count_strands(&net, true), 6);
    CHECK_INT(count_strands(&net, false), 9);
    int held = 0;
    for (int n = 0; n < net.node_count; n++) {
        const bat_node *node = &net.nodes[n];
        CHECK_INT(node->strand_count, 2);
        for (int k = 0; k < 2; k++)
            CHECK_INT(net.strands[node->strand[k]].nodes[node->place[k]], n);
        held += node->freedom == 0;
    }
    CHECK_INT(held, 4); /* the corners of the table only end battens */
    CHECK_NEAR(net.weight[true], pow(9.0 / 8, 3), 1e-12);
    bat_net_end(&net);
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_LINES, &options, &net));
    CHECK_INT(net.strand_count, 6);
    bat_net_end(&net);
    batten_offset_table_unref(offsets);
}

TEST(stations_are_cut_at_their_chine_and_lines_at_the_centre)
{
    /* straight bottom and side that meet at 60 degrees in point 4; the first three stations
     * touch the centre */
    hull *h = test_array(1, sizeof *h);
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 9; j++) {
            const double y = j <= 4 ? j : 4 + 0.5 * (j - 4),
                         z = j <= 4 ? 0.01 * j : 0.04 + 0.85 * (j - 4);
            hull_add(h, i, i < 3 && j == 2 ? 0 : y + 0.1 * i, z, hull_line(h, z));
        }
    batten_offset_table *offsets = NULL;
    bat_net net;
    batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(hull_make(h, &offsets));
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_STATIONS, &options, &net));
    const bat_node *chine = &net.nodes[7 * 9 + 4], *bottom = &net.nodes[7 * 9 + 3];
    CHECK_INT(chine->strand_count, 2);
    CHECK_INT(bottom->strand_count, 1);
    bat_net_end(&net);
    options.corner_angle = 2; /* no corner is that sharp */
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_STATIONS, &options, &net));
    CHECK_INT(net.nodes[7 * 9 + 4].strand_count, 1);
    bat_net_end(&net);
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_LINES, &options, &net));
    CHECK_INT(net.nodes[2].strand_count, 0);
    CHECK_INT(net.nodes[2].freedom, 0);
    for (int s = 0; s < net.strand_count; s++)
        if (net.strands[s].nodes[1] % 9 == 2)
            CHECK_INT(net.strands[s].count, 6); /* from the last centre point on */
    bat_net_end(&net);
    batten_offset_table_unref(offsets);
}

TEST(equal_half_breadths_are_held)
{
    hull *h = test_array(1, sizeof *h);
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 5; j++) /* a parallel middle body from station 3 to 6 */
            hull_add(h, i,
                     i < 3   ? 1 + 0.3 * i + 0.01 * j
                     : i > 6 ? 2.2 - 0.1 * i + 0.01 * j
                             : 2 + 0.01 * j,
                     j, hull_line(h, j));
    batten_offset_table *offsets = NULL;
    bat_net net;
    const batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(hull_make(h, &offsets));
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_LINES, &options, &net));
    for (int i = 1; i < 8; i++)
        CHECK_INT(net.nodes[5 * i + 2].freedom, i == 4 || i == 5 ? 0 : 1);
    bat_net_end(&net);
    batten_offset_table_unref(offsets);
}

/* Five points each, 3 to the side and 4 up, at stations 2 apart; the last line is a named one. */
static hull *straight_hull(void)
{
    hull *h = test_array(1, sizeof *h);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 5; j++)
            hull_add(h, 2 * i, 1 + 3 * j + i * i, 4 * j, hull_line(h, 4 * j));
    h->lines[4].is_waterline = false;
    return h;
}

TEST(battens_run_over_lengths_or_chords_and_weigh_by_the_cube_of_their_spacing)
{
    batten_offset_table *offsets = NULL;
    bat_net net;
    const batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(hull_make(straight_hull(), &offsets));
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_BOTH, &options, &net));
    CHECK_INT(net.strand_count, 11);
    CHECK_INT(net.longest, 6);
    for (int s = 0; s < net.strand_count; s++) {
        const bat_strand *strand = &net.strands[s];
        CHECK_INT(strand->is_line, s < 5);
        CHECK_INT(strand->count, s < 5 ? 6 : 5);
        CHECK_INT(strand->width, s < 4 ? 1 : 2);
        for (int k = 0; k < strand->count; k++)
            CHECK_NEAR(strand->t[k], s < 5 ? 2 * k : 5 * k, 1e-14);
    }
    CHECK_NEAR(net.weight[false], 125, 1e-11);
    CHECK_NEAR(net.weight[true], 8, 1e-12);
    bat_net_end(&net);
    CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_STATIONS, &options, &net));
    CHECK_NEAR(net.weight[false], 125, 1e-11);
    CHECK_NEAR(net.weight[true], 1, 0); /* of no lines */
    bat_net_end(&net);
    batten_offset_table_unref(offsets);
}

TEST(points_keep_their_place_and_move_as_their_line_lets_them)
{
    double within[30];
    batten_offset_table *offsets = NULL;
    bat_net net;
    hull *h = straight_hull();
    batten_fair_options options = batten_fair_defaults(0.01);
    h->points[0].y = 0; /* on the centre line */
    for (int n = 0; n < 30; n++)
        within[n] = n == 7 ? 0 : 0.01 * (n + 1);
    options.within_each = within;
    CHECK_OK(hull_make(h, &offsets));
    for (int hold = 0; hold < 2; hold++) {
        options.hold_ends = hold;
        CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_BOTH, &options, &net));
        CHECK_INT(net.node_count, 30);
        for (int n = 0; n < 30; n++) {
            const bat_node *node = &net.nodes[n];
            const int i = n / 5, j = n % 5;
            const bool is_end = (i == 0 || i == 5) && (j == 0 || j == 4);
            const bool held = n == 0 || n == 7 || (hold && is_end);
            CHECK_INT(node->station, i);
            CHECK_INT(node->index, j);
            CHECK_NEAR(node->x, 2 * i, 0);
            CHECK_NEAR(node->given[0], h->points[n].y, 0);
            CHECK_NEAR(node->given[1], 4 * j, 0);
            CHECK_NEAR(node->now[0], h->points[n].y, 0);
            CHECK_NEAR(node->now[1], 4 * j, 0);
            CHECK_INT(node->freedom, held ? 0 : j == 4 ? 2 : 1);
            CHECK_NEAR(node->within, held ? 0 : within[n], 0);
        }
        bat_net_end(&net);
    }
    batten_offset_table_unref(offsets);
}

/* A waterline that is missing at one station: what is left of it on either side is a batten from 4 points on. */
TEST(a_line_that_stops_at_a_station_becomes_two_battens)
{
    for (int gap = 0; gap < 9; gap++) {
        hull *h = test_array(1, sizeof *h);
        batten_offset_table *offsets = NULL;
        bat_net net;
        const batten_fair_options options = batten_fair_defaults(0.01);
        for (int i = 0; i < 9; i++) {
            hull_add(h, i, 1 + 0.1 * i * i, 0, hull_line(h, 0));
            if (i != gap)
                hull_add(h, i, 2 + 0.1 * i * i, 1, hull_line(h, 1));
        }
        CHECK_OK(hull_make(h, &offsets));
        CHECK_OK(bat_net_begin(offsets, BATTEN_FAIR_LINES, &options, &net));
        const int before = gap >= 4 ? gap : 0, after = 8 - gap >= 4 ? 8 - gap : 0;
        CHECK_INT(net.strand_count, 1 + (before > 0) + (after > 0));
        if (before > 0)
            CHECK_INT(net.strands[1].count, before);
        if (after > 0) {
            const bat_strand *last = &net.strands[net.strand_count - 1];
            CHECK_INT(last->count, after);
            CHECK_INT(last->nodes[0], 2 * (gap + 1)); /* the second point of station gap + 1 */
            CHECK_NEAR(last->t[0], gap + 1, 0);
        }
        bat_net_end(&net);
        batten_offset_table_unref(offsets);
    }
}
