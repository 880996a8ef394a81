/* A table of offsets faired as a net of battens, line by line and station by station. */
#include "base/plural.h"
#include "base/work.h"
#include "fair/batten_net.h"
#include "fair/fair_points.h"

#include <string.h>

/*
 * The energy of the net is the weighted sum of those of its battens. One batten after another
 * takes the least energy that its ducks can reach within their bounds while all others stay:
 * the battens that cross it pull at its ducks as springs. So the energy never rises; and since
 * it is convex and the bounds are those of single points, the only place to rest is the least
 * energy of the whole net. The rounds end before it, at moves of a thousandth of the bounds.
 */

/* Room for the ducks of the longest batten. */
typedef struct {
    double *centre, *frames, *anchor, *z, *moments,
        *forces;           /* [longest][2], frames [longest][2][2] */
    double *within, *pull; /* [longest] */
    int *freedom;
} workspace;

static batten_status workspace_begin(int longest, workspace *out)
{
    const size_t n = (size_t)longest;
    *out = (workspace){0};
    out->centre = bat_array3(n, 2, sizeof(double));
    out->frames = bat_array3(n, 4, sizeof(double));
    out->anchor = bat_array3(n, 2, sizeof(double));
    out->z = bat_array3(n, 2, sizeof(double));
    out->moments = bat_array3(n, 2, sizeof(double));
    out->forces = bat_array3(n, 2, sizeof(double));
    out->within = bat_array(n, sizeof(double));
    out->pull = bat_array(n, sizeof(double));
    out->freedom = bat_array(n, sizeof(int));
    const bool all = out->centre && out->frames && out->anchor && out->z && out->moments &&
                     out->forces && out->within && out->pull && out->freedom;
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void workspace_end(workspace *w)
{
    bat_release(w->centre);
    bat_release(w->frames);
    bat_release(w->anchor);
    bat_release(w->z);
    bat_release(w->moments);
    bat_release(w->forces);
    bat_release(w->within);
    bat_release(w->pull);
    bat_release(w->freedom);
}

/* The ducks of a strand where the table was given; z where they are now. */
static bat_ducks gather(const bat_net *net, const bat_strand *strand, workspace *w, double *z)
{
    const int width = strand->width;
    for (int i = 0; i < strand->count; i++) {
        const bat_node *node = &net->nodes[strand->nodes[i]];
        for (int k = 0; k < width; k++) {
            w->centre[i * width + k] = node->given[k];
            z[i * width + k] = node->now[k];
            for (int j = 0; j < width; j++)
                w->frames[(i * width + k) * width + j] = k == j;
        }
        w->within[i] = node->within;
        w->freedom[i] = bat_min_int(node->freedom, width);
    }
    return (bat_ducks){.width = width,
                       .centre = w->centre,
                       .within = w->within,
                       .freedom = w->freedom,
                       .frames = w->frames};
}

/* ---- one batten among the others ---- */

/* What the batten `other` does to its duck `place`: its force there, [2], and its stiffness. */
static double pull_of(const bat_net *net, int other, int place, workspace *w, double force[2])
{
    const bat_strand *strand = &net->strands[other];
    gather(net, strand, w, w->z);
    bat_batten_bend(&strand->batten, strand->width, w->z, w->moments, w->forces);
    const double weight = net->weight[strand->is_line];
    for (int k = 0; k < strand->width; k++)
        force[k] += weight * w->forces[place * strand->width + k];
    return weight * strand->batten.diagonal[place];
}

/* Springs that stand for the battens across strand s: force and stiffness of each at its duck.
 */
static void set_springs(const bat_net *net, int s, workspace *w)
{
    const bat_strand *strand = &net->strands[s];
    const double weight = net->weight[strand->is_line];
    for (int i = 0; i < strand->count; i++) {
        const bat_node *node = &net->nodes[strand->nodes[i]];
        double force[2] = {0}, pull = 0;
        for (int k = 0; node->freedom > 0 && k < node->strand_count; k++)
            if (node->strand[k] != s)
                pull += pull_of(net, node->strand[k], node->place[k], w, force);
        w->pull[i] = pull / weight;
        for (int k = 0; k < strand->width; k++)
            w->anchor[i * strand->width + k] = node->now[k] - (pull > 0 ? force[k] / pull : 0);
    }
}

static batten_status release_strand(bat_net *net, int s, const batten_job *job, workspace *w,
                                    double *change)
{
    const bat_strand *strand = &net->strands[s];
    double residual;
    set_springs(net, s, w);
    bat_ducks ducks = gather(net, strand, w, w->z);
    ducks.pull = w->pull;
    ducks.anchor = w->anchor;
    batten_status status = bat_batten_least(&strand->batten, &ducks, job, w->z, &residual);
    for (int i = 0; status == BATTEN_OK && i < strand->count; i++) {
        bat_node *node = &net->nodes[strand->nodes[i]];
        if (w->freedom[i] == 0)
            continue;
        const double moved = bat_distance(strand->width, node->now, w->z + i * strand->width);
        *change = bat_max(*change, moved / node->within);
        memcpy(node->now, w->z + i * strand->width, (size_t)strand->width * sizeof *w->z);
        bat_clip(2, node->given, node->within, node->now);
    }
    return status;
}

enum { ROUNDS = 200 };

static batten_status release_all(bat_net *net, const batten_job *job, workspace *w)
{
    bat_work work = {job, 0};
    double change = HUGE_VAL;
    batten_status status = BATTEN_OK;
    for (int round = 0; status == BATTEN_OK && round < ROUNDS && change > 1e-3; round++) {
        change = 0;
        for (int s = 0; status == BATTEN_OK && s < net->strand_count; s++) {
            status = release_strand(net, s, NULL, w, &change);
            if (status == BATTEN_OK)
                status = bat_work_step(&work, (uint64_t)net->strands[s].count,
                                       round / (double)ROUNDS, "fairing the table");
        }
    }
    if (status == BATTEN_OK && change > 0.1)
        status =
            bat_fail(BATTEN_TOLERANCE_NOT_MET,
                     "after %d rounds points still move by %g of their bound", ROUNDS, change);
    return status;
}

/* ---- report and result ---- */

/* Suspects of a batten are counted along it: say, for now in `set`, which nodes of the table
 * they are, and for each node which suspect it is, counted from 1. */
static void note_suspects(const bat_net *net, const bat_strand *strand, int first,
                          batten_fair_report *report, int *suspect_of)
{
    for (int k = first; k < report->suspect_count; k++) {
        batten_fair_move *move = &report->suspects[k];
        const int n = strand->nodes[move->index];
        const bat_node *node = &net->nodes[n];
        const double to[2] = {move->to[0], strand->width > 1 ? move->to[1] : node->given[1]};
        *move = (batten_fair_move){.set = n,
                                   .from = {node->x, node->given[0], node->given[1]},
                                   .to = {node->x, to[0], to[1]}};
        /* What fairing nearly mends by itself is no blunder. */
        if (bat_hypot(to[0] - node->given[0], to[1] - node->given[1]) > 2 * node->within)
            suspect_of[n] = k + 1;
    }
}

/* A wrong number pulls at the station and at the line that it stands in alike, a tight bilge at
 * its station alone: drop a suspect that another batten would move by less than half as much.
 */
static void question_offset(const bat_net *net, const bat_strand *strand, workspace *w,
                            const batten_fair_report *report, int *suspect_of)
{
    const int width = strand->width;
    gather(net, strand, w, w->z);
    bat_batten_bend(&strand->batten, width, w->centre, w->moments, w->forces);
    /* A batten says nothing about its ends, where corners are too. */
    for (int i = 1; i + 1 < strand->count; i++) {
        const int n = strand->nodes[i];
        if (suspect_of[n] == 0)
            continue;
        const batten_fair_move *move = &report->suspects[suspect_of[n] - 1];
        double here = 0, there = 0;
        for (int k = 0; k < width; k++) {
            const double suggested = move->to[k + 1] - move->from[k + 1];
            here -= w->forces[i * width + k] / strand->batten.diagonal[i] * suggested;
            there += suggested * suggested;
        }
        if (here < 0.5 * there)
            suspect_of[n] = 0;
    }
}

static void keep_agreed(const bat_net *net, const int *suspect_of, batten_fair_report *report)
{
    int kept = 0;
    for (int k = 0; k < report->suspect_count; k++) {
        batten_fair_move move = report->suspects[k];
        const int n = move.set;
        if (suspect_of[n] != k + 1)
            continue;
        move.set = net->nodes[n].station;
        move.index = net->nodes[n].index;
        report->suspects[kept++] = move;
    }
    report->suspect_count = kept;
}

static batten_status tally_strands(const bat_net *net, workspace *w, bat_fair_tally *tally)
{
    int *suspect_of = bat_array((size_t)net->node_count, sizeof *suspect_of);
    batten_status status = suspect_of ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int s = 0; status == BATTEN_OK && s < net->strand_count; s++) {
        const bat_strand *strand = &net->strands[s];
        const bat_ducks ducks = gather(net, strand, w, w->z);
        const int first = tally->report.suspect_count;
        status = bat_tally_piece(tally, &strand->batten, &ducks, strand->is_line, 0, 0, w->z);
        note_suspects(net, strand, first, &tally->report, suspect_of);
    }
    for (int s = 0; status == BATTEN_OK && s < net->strand_count; s++)
        question_offset(net, &net->strands[s], w, &tally->report, suspect_of);
    if (status == BATTEN_OK)
        keep_agreed(net, suspect_of, &tally->report);
    bat_release(suspect_of);
    return status;
}

static batten_status tally_net(const bat_net *net, workspace *w, bat_fair_tally *tally)
{
    batten_status status = tally_strands(net, w, tally);
    for (int n = 0; status == BATTEN_OK && n < net->node_count; n++) {
        const bat_node *node = &net->nodes[n];
        const double from[3] = {node->x, node->given[0], node->given[1]};
        const double to[3] = {node->x, node->now[0], node->now[1]};
        status = bat_tally_point(tally, 3, node->station, node->index, from, to);
    }
    return status;
}

static batten_status rebuild(const batten_offset_table *offsets, const bat_net *net,
                             batten_offset_table **out)
{
    const int lines = batten_offset_table_line_count(offsets);
    const int count = batten_offset_table_station_count(offsets);
    batten_table_line *line = bat_array((size_t)lines, sizeof *line);
    batten_table_station *stations = bat_array((size_t)count, sizeof *stations);
    batten_table_point *points = bat_array((size_t)net->node_count, sizeof *points);
    batten_status status = line && stations && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int l = 0; status == BATTEN_OK && l < lines; l++)
        line[l] = *batten_offset_table_line(offsets, l);
    for (int s = 0, n = 0; status == BATTEN_OK && s < count; s++) {
        stations[s] = *batten_offset_table_station(offsets, s);
        for (int i = 0; i < stations[s].point_count; i++) {
            points[n + i] = stations[s].points[i];
            points[n + i].y = net->nodes[n + i].now[0];
            points[n + i].z = net->nodes[n + i].now[1];
        }
        stations[s].points = points + n;
        n += stations[s].point_count;
    }
    if (status == BATTEN_OK)
        status = batten_offset_table_create(batten_offset_table_unit_metres(offsets), lines,
                                            line, count, stations, out);
    bat_release(points);
    bat_release(stations);
    bat_release(line);
    return status;
}

static batten_status check_table(const batten_offset_table *offsets,
                                 batten_fair_families families,
                                 const batten_fair_options *options)
{
    int count = 0;
    for (int s = 0; s < batten_offset_table_station_count(offsets); s++)
        count += batten_offset_table_station(offsets, s)->point_count;
    if ((int)families < 1 || families > BATTEN_FAIR_BOTH)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no family %d of lines", (int)families);
    if (options->corner_count > 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d corner%s %s given, but those of a table are found",
                        options->corner_count, bat_plural(options->corner_count),
                        bat_one_or_many(options->corner_count, "is", "are"));
    if (options->method != BATTEN_FAIR_SPRINGBACK)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "tables of offsets are made fair by springback alone");
    if (!(options->corner_angle > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle of a corner is %g, not above 0",
                        options->corner_angle);
    return bat_fair_check_options(count, options);
}

batten_status batten_fair_offset_table(const batten_offset_table *offsets,
                                       batten_fair_families families,
                                       const batten_fair_options *options,
                                       const batten_job *job, batten_fair_report *report,
                                       batten_offset_table **out)
{
    assert(options);
    batten_fair_options chosen = batten_fair_defaults(0);
    batten_status status = BAT_TAKE_OPTIONS(batten_fair_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    status = check_table(offsets, families, options);
    if (status != BATTEN_OK)
        return status;
    bat_net net = {0};
    workspace w = {0};
    bat_fair_tally tally = {0};
    batten_offset_table *made = NULL;
    status = bat_net_begin(offsets, families, options, &net);
    if (status == BATTEN_OK)
        status = workspace_begin(net.longest, &w);
    if (status == BATTEN_OK)
        status = release_all(&net, job, &w);
    if (status == BATTEN_OK && report)
        status = tally_net(&net, &w, &tally);
    if (status == BATTEN_OK)
        status = rebuild(offsets, &net, &made);
    if (status == BATTEN_OK) {
        *out = made;
        if (report)
            bat_tally_finish(&tally, report);
    }
    bat_tally_end(&tally);
    workspace_end(&w);
    bat_net_end(&net);
    return status;
}
