/* What can be said about a result: how far it is from its data, how fair it is. */
#ifndef BAT_DESIGN_CHECK_H
#define BAT_DESIGN_CHECK_H
#include "design/shared/rows.h"
#include "design/shared/solids.h"
#include "design/text/document.h"
#include <batten/continuity.h>
#include <batten/curvature.h>
#include <batten/measure.h>
#include <batten/text.h>

/* How far the points of an earlier feature lie from a surface, or the nearest of those that
 * were made from them. */
typedef struct {
    const char *feature;
    bool is_faired; /* the points are those after fairing, not those given */
    int count;
    double max, rms;
    double worst[3]; /* the point that lies farthest */
    int left_out;    /* points that were cut off, beside these */
} bat_data_distance;

/* A plane section of a surface where the data have a row. */
typedef struct {
    const char *family; /* of a hull "station", "buttock", "waterline", else "x section" ... */
    const char *name;
    double at;
    bool found;
    batten_fairness fairness;
    int visible; /* inflections between bulges that are higher than the tolerance of the design
                  */
    int point_count; /* of the row */
    int required;    /* inflections that the row requires; where it has few points, those that a
                        row beside it requires, if these are more */
    int excess;      /* of those that are visible, beyond these */
} bat_section;

/* One edge of a surface and the centre plane. */
typedef struct {
    const char *name; /* "u low" ... */
    double gap;       /* the largest |y| on it */
    bool is_near;     /* on average within a twentieth of the half-breadth */
} bat_edge;

/* A feature whose points a shape is made from. */
typedef struct {
    int feature;
    bool is_faired; /* they are those after fairing, not those given */
    bool is_last;   /* nothing on the way to the shape made them fair again */
    bool *stays;    /* of each point, in the order of its rows: it was not cut off; NULL: none was */
} bat_data_root;

/* Those given come first. */
typedef struct {
    int count;
    bat_data_root *at;
    int feature;  /* that of the shape */
    bool *passed; /* [feature_count]: those on the ways to it, itself among them */
} bat_data_roots;

typedef struct {
    const batten_object *object;
    bat_data_roots data;
    bool is_hull;    /* its data are a table of offsets */
    int panels_of;   /* the lofting with knuckles that it comes from; -1 for none */
    double moved_by; /* how far fairing may have moved its points */
    bool has_fairness;
    batten_fairness fairness;              /* of a curve, in its plane */
    int knot_count, parametric, geometric; /* of a curve: joins at knots and at the seam, and
                                              the lowest C and G of them */
    int triangle_joins;                    /* inner edges of a set of triangles */
    double triangle_gap, triangle_angle;   /* the largest at these; the angle in radians */
    bat_solid_faults faults;               /* of a body or mesh */
    batten_surface_fold fold;              /* of a surface */
    int distance_count, section_count, edge_count;
    bat_data_distance *distances; /* from the points given, from those after fairing */
    bat_section *sections;
    bat_edge edges[4];
} bat_checked;

/* Were points cut off that it was made from, or might have been? */
static inline bool bat_check_is_cut(const bat_checked *checked)
{
    for (int i = 0; i < checked->data.count; i++)
        if (checked->data.at[i].stays)
            return true;
    return false;
}

/* Where two ends of curves or two edges of surfaces meet, or two faces of a body. */
typedef struct {
    batten_join of;  /* `shape`: objects of the check, of a body the same one twice */
    int face[2];     /* of a body; else -1 */
    bool is_knuckle; /* between panels of one lofting: declared to be sharp */
    bool is_branch;  /* of curves: other ends meet there, too, and no line passes through */
} bat_join;

/* What keeps a result from being fair, over all that was judged. */
typedef struct {
    int corners, curvature_jumps; /* of curves; cusps are corners */
    int unbounded;                /* places of curves where curvature is */
    int inflections;              /* in excess: of curves; visible ones of sections */
    double largest_turn;          /* the sharpest corner, radians */
    int joint_corners, joint_jumps; /* where the ends of two curves meet, and no third */
    double largest_joint;           /* the sharpest corner there, radians */
    int creases, edge_jumps;      /* edges of surfaces with a turn or a curvature step */
    double largest_crease;        /* radians */
    int folds;                    /* surfaces that fold over */
} bat_unfairness;

/* Edges of surfaces that turn by less are smooth, unless a bound is stated: 0.1 degrees. */
#define BAT_EDGE_ANGLE (0.1 * BAT_PI / 180)
/* Those whose curvatures differ by a smaller part of the larger one have no jump. */
#define BAT_EDGE_CURVATURE 0.05

/* What turns by more is a corner, steps by a larger part of the curvature a jump. */
typedef struct {
    double angle, curvature;
} bat_fair_bounds;

typedef struct {
    const bat_run *run;
    bat_arena arena;
    bool *upstream; /* [feature_count] of any object */
    double within;  /* the bound, or infinity */
    bat_fair_bounds curve_bounds, edge_bounds;
    int object_count;
    bat_checked *objects;
    int join_count;
    bat_join *joins;   /* in the order of objects, edges and sides */
    int bounded_count; /* distances of points given that were measured */
    bool
        ok; /* no point given is farther than the bound, which was measured when there is one */
    int judged_count; /* curves, sections, and edges of surfaces that meet, that were judged */
    bat_unfairness unfairness;
} bat_check;

/* Look at everything in the argument `parameter` of the run. Release it, also after a failure.
 */
batten_status bat_check_all(const bat_run *run, const char *parameter, double within,
                            const bat_fair_bounds *curves, const bat_fair_bounds *edges,
                            bat_check *out);
void bat_check_release(bat_check *check);

bool bat_check_is_fair(const bat_check *check);

/* ---- provenance.c ---- */

/* Find for each object of the argument, in its order, the features that its data are from; marks `upstream`. */
batten_status bat_check_trace(bat_check *check, const char *parameter);
/* Were its points made fair? */
bool bat_check_is_faired(const bat_checked *checked);
typedef void (*bat_parent_visit)(void *context, int parent, int child);
/* Calls `visit` for each feature whose points come to lie on the result of this one. */
void bat_check_visit_parents(const bat_check *check, int feature, bat_parent_visit visit,
                             void *context);
typedef batten_status (*bat_row_visit)(void *context, const bat_row *row);
/* Every row of a feature; the lines of a table too when `with_lines`. */
batten_status bat_check_visit_rows(const bat_check *check, int feature, bool with_lines,
                                   bat_row_visit visit, void *context);
/* A row [count][3] as it was given before fairing, in a plane across `axis`, to release, and how far its
 * points may have been moved; the row itself and 0 where it was not made fair. */
batten_status bat_check_given_row(const bat_check *check, const bat_checked *checked, int count,
                                  const double *row, int axis, double **points, double *bound);

/* ---- cuts.c ---- */

/* Find of each object the points that were cut off on every way to it. */
batten_status bat_check_cuts(bat_check *check);

/* ---- distances.c ---- */

typedef struct {
    int count;
    double *points; /* [count][3] */
} bat_cloud;

/* The points of a feature; release its points. */
batten_status bat_cloud_of(const bat_check *check, int feature, bat_cloud *out);
/* Of each point the distance from a curve or surface where it is less than `nearest` says. `room` [count] */
batten_status bat_cloud_approach(const bat_check *check, const bat_cloud *cloud,
                                 const batten_object *object, double *room, double *nearest);

/* Measure the points that a shape is made from against the shapes made from the same. */
batten_status bat_check_add_distances(bat_check *check, bat_checked *checked);

/* ---- sections.c ---- */

batten_status bat_check_add_sections(bat_check *check, bat_checked *checked);

/* ---- joins.c ---- */

/* Find the joins of the objects, within the tolerance of the design. */
batten_status bat_joins_find(bat_check *check);
/* "start", "end" of a curve; "u low", "u high", "v low", "v high" of a surface. */
const char *bat_side_name(const batten_object *object, int side);

/* ---- report_joins.c ---- */

/* Each join of curves and surfaces, how many joins have G0, G1 ..., and the worst of all. */
void bat_joins_text(const bat_check *check, batten_text *out);
/* The values of the keys "joins" and "worst_joins". */
void bat_joins_json(const bat_check *check, batten_text *out);
void bat_worst_joins_json(const bat_check *check, batten_text *out);

/* ---- report.c, report_json.c ---- */

/* The kind of an object, in one word. */
static inline const char *bat_kind_name(const batten_object *object)
{
    static const char *const names[] = {"points",    "curve", "surface", "offsets",
                                        "triangles", "body",  "mesh",    "instance"};
    return names[object->kind];
}

/* The unit of all lengths of a check. */
static inline const char *bat_check_unit(const bat_check *check)
{
    const char *unit = batten_unit_name(bat_unit_metres(check->run));
    return unit ? unit : "units";
}

/* As a text for people, with rounded numbers, or as JSON with all digits. */
void bat_report_text(const bat_check *check, batten_text *out);
void bat_report_json(const bat_check *check, batten_text *out);

#endif
