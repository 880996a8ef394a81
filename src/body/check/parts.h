/* What the parts of batten_body_check share. */
#ifndef BAT_CHECK_PARTS_H
#define BAT_CHECK_PARTS_H
#include "base/work.h"
#include "body/trace/all.h"
#include <batten/body.h>

/* How often faces use an edge along it and against it. */
typedef struct {
    int count[2];
} bat_edge_ways;

typedef struct {
    const batten_body_parts *parts;
    double tolerance;
    bat_work work;
    batten_notes *notes;
    batten_body_faults *faults;
    const batten_body_parts *named; /* where faces have their names and numbers ... */
    const int *numbers;             /* ... [face_count], those that they have there, or NULL */
} bat_check;

/* "face 12 "bottom"": where a note of it stands. */
enum { BAT_CHECK_NAME = 96 };
const char *bat_check_face_name(const bat_check *check, int face, char name[BAT_CHECK_NAME]);

/* Whether edges lie on the surface of face `face` (check_faces.c). */
batten_status bat_check_misses(bat_check *check, int face);
/* Are two distinct knots nearer than 1e-6 of the domain? *gap: their distance as a share of it.
 */
batten_status bat_check_curve_knots(const batten_curve *curve, bool *close, double *gap);
batten_status bat_check_surface_knots(const batten_surface *surface, bool *close, double *gap);
/* Whether the loops of face `face`, all with parameters, touch or cross (loops.c). */
batten_status bat_check_loops(bat_check *check, int face);
/* Whether the shells of a solid are turned inside out (check_shells.c). ways: [edge_count] */
batten_status bat_check_shells(bat_check *check, const batten_body *body,
                               const bat_traced_all *traced, const bat_edge_ways *ways);

#endif
