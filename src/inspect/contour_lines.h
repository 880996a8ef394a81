/* Lines through a triangulation: traced from edge to edge, drawn on the surface, joined. */
#ifndef BAT_CONTOUR_LINES_H
#define BAT_CONTOUR_LINES_H
#include "inspect/contour_net.h"

typedef struct {
    int level;
    bool closed;
    size_t count, capacity;
    double *points;     /* [count][3] */
    double *parameters; /* [count][2] */
} bat_line;

typedef struct {
    size_t count, capacity;
    bat_line *lines;
    double tolerance; /* how far chords may lie from the contour */
    double near;      /* points so near to each other are one */
    double error;     /* what was reached */
} bat_lines;

/* Every line of every level; those of one level that meet at a critical node end there. */
batten_status bat_lines_trace(bat_net *net, bat_lines *lines);
/* Join ends that coincide, in the straightest way, into longer and closed lines. */
batten_status bat_lines_join(bat_lines *lines);
void bat_lines_free(bat_lines *lines);

batten_status bat_line_add(bat_line *line, const double *point, const double *parameters);
void bat_line_free(bat_line *line);

/* Add to the line what lies on the contour between two points of one triangle, without them.
 */
batten_status bat_line_refine(const bat_net *net, const bat_triangle *triangle, int level,
                              const double from[2], const double to[2], bat_lines *lines,
                              bat_line *line);

#endif
