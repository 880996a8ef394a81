/*
 * Faces and shells of a STEP file as bodies. Edges and vertices that faces share in the file
 * are shared in the body.
 */
#ifndef BAT_STEP_TOPOLOGY_H
#define BAT_STEP_TOPOLOGY_H
#include "exchange/step/read/shapes.h"

/* Gives a face of the file its colour. */
typedef void bat_step_style(const void *context, const bat_step_instance *item,
                            batten_body_face *face);

/* What became of an instance. The stamp says of what sort the index is, for an instance may be
 * referred to as if it were of several. */
typedef enum {
    BAT_STEP_POINT_VERTEX = 1,
    BAT_STEP_VERTEX,
    BAT_STEP_EDGE,
    BAT_STEP_SURFACE,
    BAT_STEP_FACE /* for good: no second body gets it */
} bat_step_sort;
typedef struct {
    uint32_t stamp; /* see bat_step_stamp */
    int index;      /* in the builder or a list below; -1 when it could not be made */
} bat_step_made;

typedef struct {
    bat_step_file *file;
    bat_census *census;
    bat_step_style *style;
    const void *context;
    bat_step_made *made; /* for each instance */
    size_t work;         /* how many items and control points may still be taken */

    /* The body at work: */
    uint32_t body; /* its number, from 1 on */
    bat_builder builder;
    bat_step_scale scale;
    bat_list edges;    /* bat_step_edge for each edge of the builder */
    bat_list surfaces; /* batten_surface * of the file itself */
    bat_list roots;    /* of vertices that are taken as one: int, for the first of them */
    bat_list pairs;    /* edges of polygons by their vertices: a hash of int, -1 where free */
    size_t pair_count;
    bat_list counts; /* uses of each edge in a shell */
    bat_list faces;  /* uint32_t: the instances of those that were read */
    bool has_spline; /* a face lies on a surface that is a B-spline in the file */
    int left_out;    /* faces */

    /* The face at work: */
    bat_list uses;   /* bat_step_use */
    bat_list loops;  /* int: how many uses each has */
    bat_list points; /* double[3]: of its edges */
    int vertex_loop; /* the vertex that is a loop by itself, or -1 */
} bat_step_topology;

/* Where an edge comes from. */
typedef struct {
    uint32_t instance; /* its EDGE_CURVE */
    uint32_t geometry; /* what that refers to */
    bool is_whole;     /* a curve of the file as it is, or reversed */
    bool is_turned;
} bat_step_edge;

typedef struct {
    int edge;
    bool reversed;
} bat_step_use;

batten_status bat_step_topology_open(bat_step_file *file, bat_census *census,
                                     bat_step_style *style, const void *context,
                                     bat_step_topology *topology);
void bat_step_topology_close(bat_step_topology *topology);

/* A body: begin, shells and faces, end. A face that cannot be read is noted and left out; each
 * face of the file is read once. */
void bat_step_body_begin(bat_step_topology *topology, const bat_step_scale *scale);
batten_status bat_step_body_shell(bat_step_topology *topology,
                                  const bat_step_instance *instance, bool reversed);
/* A face outside shells, in a shell of its own. */
batten_status bat_step_body_face(bat_step_topology *topology,
                                 const bat_step_instance *instance);
/* A CURVE_BOUNDED_SURFACE. */
batten_status bat_step_body_bounded(bat_step_topology *topology,
                                    const bat_step_instance *instance);
/* NULL in *out when no face was read. */
batten_status bat_step_body_end(bat_step_topology *topology, bool is_solid, batten_body **out);

/* The face of a body that is the whole of its surface, edge by edge the rows of its net: NULL
 * when there is more than one, or it is cut. */
const batten_body_face *bat_step_whole_patch(const batten_body *body);

/* ---- edges.c ---- */

uint32_t bat_step_index(const bat_step_file *file, const bat_step_instance *instance);
bat_step_made *bat_step_made_of(const bat_step_topology *topology,
                                const bat_step_instance *instance);
/* The stamp of what is made of that sort for the body at work. */
uint32_t bat_step_stamp(const bat_step_topology *topology, bat_step_sort sort);
/* Take `count` items more; refused when lists are followed over and over. */
batten_status bat_step_spend(bat_step_topology *topology, const bat_step_instance *instance,
                             size_t count);
/* A note about an instance that stays in. */
void bat_step_warn(const bat_step_file *file, const bat_step_instance *instance,
                   const char *format, ...) BATTEN_PRINTF(3, 4);
/* The edge of an EDGE_CURVE; that along any other curve; that between two CARTESIAN_POINTs. */
batten_status bat_step_read_edge(bat_step_topology *topology, const bat_step_instance *instance,
                                 int *index);
batten_status bat_step_read_vertex(bat_step_topology *topology,
                                   const bat_step_instance *instance, int *index);
batten_status bat_step_add_edge(bat_step_topology *topology, const bat_step_instance *instance,
                                batten_curve *curve, int *index);
batten_status bat_step_straight_edge(bat_step_topology *topology, const bat_step_instance *from,
                                     const bat_step_instance *to, bat_step_use *use);
/* The vertex that stands for this one and those it was found to coincide with. */
int bat_step_root(const bat_step_topology *topology, int vertex);
batten_status bat_step_unite(bat_step_topology *topology, int a, int b);
/* Where a use begins (k = 0) and ends (k = 1). */
int bat_step_end_of(const bat_step_topology *topology, const bat_step_use *use, int k);

/* ---- loops.c, loop_parameters.c ---- */

/* Collect the loops of a face in `uses` and `loops`. One that is a vertex says that nothing
 * else bounds it there. */
batten_status bat_step_read_bounds(bat_step_topology *topology, const bat_step_instance *face,
                                   const bat_step_record *record, bool flipped);
/* The loops that were collected, into the builder; with their curves in the parameters of the
 * surface, if it is given. */
batten_status bat_step_put_loops(bat_step_topology *topology, const bat_step_instance *surface);

/* ---- edges.c: their order ---- */

batten_status bat_step_sort_edges(bat_step_topology *topology);

/* ---- surfaces.c ---- */

/* The surface of the face at work, over its edges; *is_file when it is one of the file itself,
 * parameters and all; *is_against when its normal is against that of the file. */
batten_status bat_step_face_surface(bat_step_topology *topology,
                                    const bat_step_instance *instance, batten_surface **out,
                                    bool *is_file, bool *is_against);
/* The plane of the first loop, which has its corners on straight edges. */
batten_status bat_step_polygon_plane(bat_step_topology *topology, const bat_step_instance *face,
                                     batten_surface **out);

const double *bat_step_vertex_point(const bat_step_topology *t, int vertex);
/* Vertices at the same CARTESIAN_POINT are one. */
batten_status bat_step_vertex_at(bat_step_topology *t, const bat_step_instance *point,
                                 int *index);

#endif
