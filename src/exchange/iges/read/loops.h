/* The loops of a trimmed face as a file says them, before they become edges of a body. */
#ifndef BAT_IGES_LOOPS_H
#define BAT_IGES_LOOPS_H
#include "body/builder.h"
#include "body/elementary/elementary.h"
#include "body/trace/chart.h"
#include "exchange/iges/read/curves.h"

/* A part of a loop: the curve in space, and the one in (u, v), which runs the same way, or
 * NULL. */
typedef struct {
    batten_curve *space, *flat;
    bool reversed; /* the loop runs against them */
} bat_iges_side;

typedef struct {
    bat_list sides; /* of bat_iges_side, head to tail */
    double area;    /* in (u, v), positive when it runs counter-clockwise; 0 when unknown */
} bat_iges_loop;

/* What a face lies on. */
typedef struct {
    const batten_surface *surface; /* counted by its owner; NULL for an elementary one */
    bool is_elementary;
    bat_elementary elementary;
    bool has_parameters; /* curves in (u, v) mean what we mean by u and v */
    double tolerance;
    bat_chart *chart; /* made where it is needed */
} bat_iges_ground;

typedef struct {
    bat_iges_reading *reading;
    const bat_iges_entry *entry; /* of the face */
    bat_iges_ground ground;
    bat_list loops; /* of bat_iges_loop */
    double size;    /* of the box of all curves in space */
} bat_iges_face;

void bat_iges_face_begin(bat_iges_reading *reading, const bat_iges_entry *entry,
                         bat_iges_face *face);
void bat_iges_face_end(bat_iges_face *face);

/* What the surface of an id is. */
batten_status bat_iges_set_ground(bat_iges_face *face, int id);
/* A curve of the file as a plane one that runs as `space` does, or NULL, as it does itself. */
batten_status bat_iges_flatten(const bat_iges_ground *ground, const batten_curve *curve,
                               const batten_curve *space, batten_curve **out);
/* Add points of a curve to a list of double[3]. */
batten_status bat_iges_sample(bat_iges_reading *reading, const batten_curve *curve,
                              bat_list *points);
/* How far an edge misses its surface, at samples. */
double bat_iges_miss(bat_iges_ground *ground, const batten_curve *space,
                     const batten_curve *flat);
/* The tolerance that a body of that size needs, which is counted when it is larger than that of
 * the file; beyond a thousandth of the size it is not raised. */
double bat_iges_tolerance_of_miss(bat_iges_reading *reading, double tolerance, double miss,
                                  double size);
/* A new loop, which the next sides belong to. */
batten_status bat_iges_add_loop(bat_iges_face *face);
/* Add curves in space, and curves in (u, v), which may be none or fewer; where there are none
 * in space they are made from the others. `said` is -1 when the curves in space are run
 * through backwards, 0 when their order says how. */
batten_status bat_iges_add_sides(bat_iges_face *face, const bat_iges_curves *space,
                                 const bat_iges_curves *flat, int said);

/* What is farther apart does not meet. */
double bat_iges_open_gap(const bat_iges_face *face);
/* A loop that is open, with both ends on one border of a surface that closes nowhere, gets the
 * part of the border between them, with a note; others stay as they are. */
batten_status bat_iges_close_loop(bat_iges_face *face, bat_iges_loop *loop);

/* Put all of it into the builder as one face: loops head to tail, turned the right way around
 * and the outer one first as far as that can be told, vertices and seams shared. With
 * `border` the outer loop is the border of the surface. */
batten_status bat_iges_make_face(bat_iges_face *face, bool border, bat_builder *builder);

batten_status bat_iges_end_of(const bat_iges_side *side, bool last, double p[3]);
double bat_iges_distance(const double a[3], const double b[3]);
/* Sides in a row of which each begins where the one before ends; some files have them run as
 * they like. Sides that meet stay as they are: of those that close, alone or two together, the
 * other ends may be nearer by a rounding error. */
batten_status bat_iges_link_sides(bat_iges_loop *loop, double tolerance);
/* The loop with the largest area is the outer one and runs counter-clockwise, the others
 * clockwise; where areas are not known all stay as they are. */
void bat_iges_right_loops(bat_iges_face *face, bool border);

#endif
