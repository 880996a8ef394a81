/* Crossings of a section in chains, and the chains in polylines. */
#ifndef BAT_INSPECT_SECTION_CHAINS_H
#define BAT_INSPECT_SECTION_CHAINS_H
#include <batten/nearest.h>

typedef struct {
    double u, v;
    batten_vec3 point;
    int link[2]; /* neighbours in the chain; -1 for none */
} bat_section_crossing;

typedef struct {
    const batten_surface *surface;
    batten_vec3 normal;
    double offset, roundoff; /* of a height */
    int nu, nv;              /* cells */
    bool closed[2];          /* does the last line along u, v repeat the first? */
    double *u, *v;           /* [nu + 1], [nv + 1] */
    double *heights;         /* [nu + 1][nv + 1]; never 0 */
    int *edge_u, *edge_v;    /* crossing on the edge from node (i, j) along u, v; -1 for none */
    bat_section_crossing *crossings;
    int count;
} bat_section_march;

/* Open chains begin at a crossing of one link; loops anywhere. */
batten_status bat_section_chains(bat_section_march *m, batten_polylines *out);

#endif
