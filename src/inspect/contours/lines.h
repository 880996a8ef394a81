/* Lines through a triangulation: traced from edge to edge, drawn on the surface, joined. */
#ifndef BAT_CONTOUR_LINES_H
#define BAT_CONTOUR_LINES_H
#include "inspect/contours/net.h"

/* Of all lines. */
enum { BAT_MOST_CHORDS = 1000000 };

typedef struct {
    int level;
    bool closed;
    size_t count, capacity;
    double *points;     /* [count][3] */
    double *parameters; /* [count][2] */
    bool smooth;
    double *arms; /* [count][2][3] of smooth ones: the control points before and after; between
                     two points stands a cubic */
} bat_line;

typedef struct {
    size_t count, capacity;
    bat_line *lines;
    bat_work *work;
    uint64_t done;    /* points so far */
    bool smooth;      /* cubics, not chords */
    double tolerance; /* how far they may lie from the contour */
    double near;      /* points so near to each other are one */
    double error;     /* what was reached */
    bool has_arm;
    double arm[3]; /* the control point before the point that is added next */
} bat_lines;

/* Every line of every level; those of one level that meet at a critical node end there. */
batten_status bat_lines_trace(bat_net *net, bat_lines *lines);
/* Join ends that coincide, in the straightest way, into longer and closed lines. */
batten_status bat_lines_join(bat_lines *lines);
void bat_lines_free(bat_lines *lines);

batten_status bat_line_add(bat_line *line, const double *point, const double *parameters);
void bat_line_free(bat_line *line);

/* The part of a contour that lies in one triangle. */
typedef struct {
    const bat_net *net;
    const bat_triangle *triangle;
    int level;
    double from[2], to[2]; /* where it enters and leaves */
} bat_line_part;

/* Add to the line what lies on the contour between both ends of the part, without them. */
batten_status bat_line_refine(const bat_line_part *part, bat_lines *lines, bat_line *line);
/* How many chords that would give, about: their distance falls with the square of their length.
 */
batten_status bat_line_predict(const bat_line_part *part, const bat_lines *lines,
                               double *chords);
/* Set the control point before (0) or after (1) the last point. */
void bat_line_set_arm(bat_line *line, int side, const double *arm);

#endif
