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
