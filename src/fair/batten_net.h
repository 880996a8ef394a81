/* A table of offsets as a net of battens: along the lines, and across the hull along the
 * stations. */
#ifndef BAT_STRANDS_H
#define BAT_STRANDS_H
#include "fair/elastic_batten.h"

/* One batten of the net. Of a waterline only the half-breadths are bent, over x; of a named
 * line half-breadths and heights, over x; of a station both, over the chord length. */
typedef struct {
    bool is_line;
    int width, count;
    int *nodes; /* [count], which points of the table */
    double *t;  /* [count] */
    bat_batten batten;
} bat_strand;

/* Where a point of the table is, and which battens it lies on: one line, and two stations at a
 * corner. */
typedef struct {
    int station, index;
    double given[2], now[2]; /* half-breadth and height */
    double x, within;
    int freedom; /* 0 held, 1 the half-breadth moves, 2 both */
    int strand[3], place[3];
    int strand_count;
} bat_node;

typedef struct {
    int node_count, strand_count, longest;
    bat_node *nodes;
    bat_strand *strands;
    int strand_room;
    double weight[2]; /* of the energies of stations, of lines */
} bat_net;

batten_status bat_net_begin(const batten_offset_table *offsets, batten_fair_families families,
                            const batten_fair_options *options, bat_net *out);
void bat_net_end(bat_net *net);

#endif
