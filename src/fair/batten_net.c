/* A table of offsets as battens that share their ducks: along its lines, and along its stations. */
#include "fair/batten_net.h"
#include "base/list.h"

#include <float.h>
#include <string.h>

/* ---- nodes ---- */

static int count_points(const batten_offset_table *offsets)
{
    int count = 0;
    for (int s = 0; s < batten_offset_table_station_count(offsets); s++)
        count += batten_offset_table_station(offsets, s)->point_count;
    return count;
}

static void fill_nodes(bat_net *net, const batten_offset_table *offsets,
                       const batten_fair_options *options)
{
    bat_node *node = net->nodes;
    for (int s = 0; s < batten_offset_table_station_count(offsets); s++) {
        const batten_table_station *station = batten_offset_table_station(offsets, s);
        for (int i = 0; i < station->point_count; i++, node++) {
            const batten_table_point *p = &station->points[i];
            const bool waterline =
                p->line >= 0 && batten_offset_table_line(offsets, p->line)->is_waterline;
            *node = (bat_node){.station = s,
                               .index = i,
                               .given = {p->y, p->z},
                               .now = {p->y, p->z},
                               .x = p->x,
                               .freedom = waterline ? 1 : 2};
            node->within = options->within_each ? options->within_each[node - net->nodes]
                                                : options->within;
            if (p->y == 0)
                node->freedom = 0;
        }
    }
}

/* ---- strands ---- */

/* Chord length of a station, x of a line. False when it does not increase. */
static bool set_parameters(const bat_net *net, bat_strand *strand)
{
    for (int i = 1; i < strand->count; i++) {
        const bat_node *a = &net->nodes[strand->nodes[i - 1]],
                       *b = &net->nodes[strand->nodes[i]];
        const double step = strand->is_line ? b->x - a->x : bat_distance(2, a->given, b->given);
        if (i == 1)
            strand->t[0] = strand->is_line ? a->x : 0;
        strand->t[i] = strand->is_line ? b->x : strand->t[i - 1] + step;
        if (!(strand->t[i] > strand->t[i - 1]))
            return false;
    }
    return true;
}

static void drop_strand(bat_strand *strand)
{
    bat_release(strand->nodes);
    bat_release(strand->t);
    bat_batten_end(&strand->batten);
}

static batten_status make_strand(const bat_net *net, bool is_line, int width, int count,
                                 const int *nodes, bat_strand *out)
{
    bat_strand made = {.is_line = is_line, .width = width, .count = count};
    made.nodes = bat_array((size_t)count, sizeof *made.nodes);
    made.t = bat_array((size_t)count, sizeof *made.t);
    batten_status status = made.nodes && made.t ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(made.nodes, nodes, (size_t)count * sizeof *nodes);
        made.count = set_parameters(net, &made) ? count : 0;
    }
    if (status == BATTEN_OK && made.count > 0)
        status = bat_batten_begin(count, made.t, &made.batten);
    if (status == BATTEN_OK && made.count > 0)
        *out = made;
    else
        drop_strand(&made);
    return status;
}

/* A run of points becomes a batten; of fewer than four there is nothing to fair. */
static batten_status add_strand(bat_net *net, bool is_line, int width, int count,
                                const int *nodes)
{
    if (count < 4)
        return BATTEN_OK;
    batten_status status = BAT_LIST_GROW(net->strands, net->strand_count, net->strand_room, 1);
    if (status != BATTEN_OK)
        return status;
    bat_strand *strand = &net->strands[net->strand_count];
    strand->count = 0;
    status = make_strand(net, is_line, width, count, nodes, strand);
    if (status != BATTEN_OK || strand->count == 0)
        return status;
    for (int i = 0; i < count; i++) {
        bat_node *node = &net->nodes[nodes[i]];
        node->strand[node->strand_count] = net->strand_count;
        node->place[node->strand_count++] = i;
    }
    net->longest = bat_max_int(net->longest, count);
    net->strand_count++;
    return BATTEN_OK;
}

/* Two points at one place, or a station that stands still: no batten goes through both. */
static bool is_apart(const bat_net *net, bool is_line, int a, int b)
{
    const bat_node *first = &net->nodes[a], *second = &net->nodes[b];
    return is_line ? second->x > first->x : bat_distance(2, first->given, second->given) > 0;
}

/* Cut a run at points of the centre line and at corners, which end one batten and begin the
 * next. */
static batten_status add_runs(bat_net *net, bool is_line, int width, int count,
                              const int *nodes, const bool *is_corner)
{
    batten_status status = BATTEN_OK;
    int first = 0;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const bool last = i + 1 == count || !is_apart(net, is_line, nodes[i], nodes[i + 1]);
        const bool cut = net->nodes[nodes[i]].given[0] == 0 || (is_corner && is_corner[i]);
        if (!last && !cut)
            continue;
        status = add_strand(net, is_line, width, i - first + 1, nodes + first);
        first = last ? i + 1 : i;
    }
    return status;
}

/* ---- lines ---- */

/* The one point of a station that is on the line; -1 for none or several. */
static int point_on_line(const batten_table_station *station, int line)
{
    int found = -1;
    for (int i = 0; i < station->point_count; i++)
        if (station->points[i].line == line) {
            if (found >= 0)
                return -1;
            found = i;
        }
    return found;
}

static batten_status add_line(bat_net *net, const batten_offset_table *offsets, int line,
                              int *nodes)
{
    const int width = batten_offset_table_line(offsets, line)->is_waterline ? 1 : 2;
    const int stations = batten_offset_table_station_count(offsets);
    batten_status status = BATTEN_OK;
    int count = 0;
    for (int s = 0, begin = 0; status == BATTEN_OK && s <= stations; s++) {
        const batten_table_station *station =
            s < stations ? batten_offset_table_station(offsets, s) : NULL;
        const int point = station ? point_on_line(station, line) : -1;
        if (point >= 0) {
            nodes[count++] = begin + point;
        } else {
            status = add_runs(net, true, width, count, nodes, NULL);
            count = 0;
        }
        begin += station ? station->point_count : 0;
    }
    return status;
}

/* ---- stations ---- */

/* How far a polygon turns at its point i; 0 at its ends. */
static double turn_at(const batten_table_station *station, int i)
{
    if (i < 1 || i >= station->point_count - 1)
        return 0;
    const batten_table_point *p = station->points + i;
    const double ay = p[0].y - p[-1].y, az = p[0].z - p[-1].z;
    const double by = p[1].y - p[0].y, bz = p[1].z - p[0].z;
    return fabs(bat_atan2(ay * bz - az * by, ay * by + az * bz));
}

static batten_status add_station(bat_net *net, const batten_table_station *station, int begin,
                                 double corner_angle, int *nodes)
{
    bool *is_corner = bat_array((size_t)station->point_count, sizeof *is_corner);
    if (!is_corner)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < station->point_count; i++) {
        const double neighbours = bat_max(turn_at(station, i - 1), turn_at(station, i + 1));
        is_corner[i] = turn_at(station, i) - neighbours > corner_angle;
        nodes[i] = begin + i;
    }
    batten_status status = add_runs(net, false, 2, station->point_count, nodes, is_corner);
    bat_release(is_corner);
    return status;
}

/* ---- what is held ---- */

/* Inside a run of equal half-breadths, the flat of the side or a parallel middle body. */
static bool is_flat(const bat_net *net, const bat_strand *strand, int i)
{
    if (i < 1 || i >= strand->count - 1)
        return false;
    const double here = net->nodes[strand->nodes[i]].given[0];
    return here == net->nodes[strand->nodes[i - 1]].given[0] &&
           here == net->nodes[strand->nodes[i + 1]].given[0];
}

/* Points on no batten stay, and those that are only ends of battens when ends are held; flats
 * stay flat. */
static void hold_nodes(bat_net *net, bool hold_ends)
{
    double size = 0;
    for (int n = 0; n < net->node_count; n++)
        size = bat_max(size, bat_norm(2, net->nodes[n].given));
    for (int n = 0; n < net->node_count; n++) {
        bat_node *node = &net->nodes[n];
        bool only_ends = true, flat = false;
        for (int k = 0; k < node->strand_count; k++) {
            const bat_strand *strand = &net->strands[node->strand[k]];
            const int i = node->place[k];
            only_ends = only_ends && (i == 0 || i == strand->count - 1);
            flat = flat || is_flat(net, strand, i);
        }
        const bool no_room = node->within <= 16 * DBL_EPSILON * size;
        if (node->strand_count == 0 || flat || no_room || (hold_ends && only_ends))
            node->freedom = 0;
        if (node->freedom == 0)
            node->within = 0;
    }
}

/*
 * The stiffness of a batten falls with the cube of the spacing of its ducks. The energies of
 * both families are multiplied by the cube of their mean spacing, so that a released point
 * listens to both.
 */
static void set_weights(bat_net *net)
{
    double length[2] = {0};
    int spans[2] = {0};
    for (int s = 0; s < net->strand_count; s++) {
        const bat_strand *strand = &net->strands[s];
        length[strand->is_line] += strand->t[strand->count - 1] - strand->t[0];
        spans[strand->is_line] += strand->count - 1;
    }
    for (int k = 0; k < 2; k++)
        net->weight[k] = spans[k] > 0 ? bat_pow(length[k] / spans[k], 3) : 1;
}

/* ---- the net ---- */

static batten_status add_all(bat_net *net, const batten_offset_table *offsets,
                             batten_fair_families families, double corner_angle, int *nodes)
{
    batten_status status = BATTEN_OK;
    if (families & BATTEN_FAIR_LINES)
        for (int l = 0; status == BATTEN_OK && l < batten_offset_table_line_count(offsets); l++)
            status = add_line(net, offsets, l, nodes);
    if (families & BATTEN_FAIR_STATIONS)
        for (int s = 0, begin = 0;
             status == BATTEN_OK && s < batten_offset_table_station_count(offsets); s++) {
            const batten_table_station *station = batten_offset_table_station(offsets, s);
            status = add_station(net, station, begin, corner_angle, nodes);
            begin += station->point_count;
        }
    return status;
}

batten_status bat_net_begin(const batten_offset_table *offsets, batten_fair_families families,
                            const batten_fair_options *options, bat_net *out)
{
    bat_net net = {.node_count = count_points(offsets)};
    const int stations = batten_offset_table_station_count(offsets);
    net.nodes = bat_array((size_t)net.node_count, sizeof *net.nodes);
    int *nodes = bat_array((size_t)bat_max_int(net.node_count, stations), sizeof *nodes);
    batten_status status = net.nodes && nodes ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        fill_nodes(&net, offsets, options);
        status = add_all(&net, offsets, families, options->corner_angle, nodes);
    }
    bat_release(nodes);
    if (status != BATTEN_OK) {
        bat_net_end(&net);
        return status;
    }
    hold_nodes(&net, options->hold_ends);
    set_weights(&net);
    *out = net;
    return BATTEN_OK;
}

void bat_net_end(bat_net *net)
{
    for (int s = 0; s < net->strand_count; s++)
        drop_strand(&net->strands[s]);
    bat_release(net->strands);
    bat_release(net->nodes);
    *net = (bat_net){0};
}
