#ifndef BATTEN_BODY_H
#define BATTEN_BODY_H
/**
 * @file
 * Bodies: trimmed faces that share their edges; sheets, shells and solids.
 *
 * A body is a list of each of these, and they refer to one another by index:
 *
 *     vertices   points in space
 *     edges      a curve in space from one vertex to another
 *     uses       of an edge by a loop, forwards or reversed, with the curve in the parameters
 *                of the face
 *     loops      uses, head to tail, around a face; an edge of two faces has two uses
 *     faces      a surface and the loops that bound what counts of it
 *     shells     faces that belong together
 *
 * A body is immutable and reference counted, as curves and surfaces are.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_body batten_body;

/** An edge runs as its curve does. */
typedef struct batten_body_edge {
    const batten_curve *curve; /**< in space; its whole domain, from the first vertex to the
                                    second; NULL for an edge that is one point, as at a pole */
    int vertices[2];           /**< the same one twice when it is closed */
} batten_body_edge;

/** A loop goes along an edge. */
typedef struct batten_body_use {
    int edge;
    bool reversed;                  /**< the loop runs against the edge */
    const batten_curve *parameters; /**< the curve (u, v) on the surface of the face; it runs as
                                         the edge does, whatever `reversed` says; or NULL */
} batten_body_use;

/** The uses `first` .. `first` + `count` - 1, each beginning where the one before ends. */
typedef struct batten_body_loop {
    int first, count;
} batten_body_loop;

/**
 * A part of a surface. Its loops have it on their left as seen from outside: when it is not
 * reversed, the outer loop runs counter-clockwise in (u, v), and holes clockwise.
 */
typedef struct batten_body_face {
    const char *name; /**< "" for none */
    bool has_colour;
    double colour[3]; /**< sRGB, 0..1 */
    const batten_surface *surface;
    bool reversed;    /**< its outside is against Su x Sv */
    int first, count; /**< of its loops; none: the whole of the surface */
} batten_body_face;

/** The faces `first` .. `first` + `count` - 1. */
typedef struct batten_body_shell {
    int first, count;
    bool closed; /**< said to have no rim */
} batten_body_shell;

/** All that a body is: what batten_body_create takes and batten_body_view shows. */
typedef struct batten_body_parts {
    int vertex_count;
    const double *vertices; /**< [vertex_count][3] */
    int edge_count;
    const batten_body_edge *edges;
    int use_count;
    const batten_body_use *uses;
    int loop_count;
    const batten_body_loop *loops; /**< in their order they take up all uses */
    int face_count;
    const batten_body_face *faces; /**< in their order they take up all loops */
    int shell_count;
    const batten_body_shell *shells; /**< in their order they take up all faces */
    bool is_solid;    /**< the first shell bounds it, the others are voids in it; all have their
                           outside away from the material */
    double tolerance; /**< of the file that it comes from: how far curves may miss their
                           vertices and surfaces; > 0 */
    bool is_traced;   /**< every use has its parameters, with the knots' domain and the speed of
                           its edge, as batten_body_trace makes them */
} batten_body_parts;

/**
 * Copies the arrays and names, and refers to the geometry.
 *
 * Checked are the indices, that uses of a loop meet in their vertices, dimensions, and that
 * numbers are finite; whether curves lie on their surfaces is for batten_body_check.
 *
 * @param parts  all of it is copied
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT naming the part that does not fit; NOT_FINITE; OUT_OF_MEMORY
 *
 * Cost: linear in vertices, edges, uses and faces; memory for one copy of the arrays and the
 * names.
 */
BATTEN_API batten_status batten_body_create(const batten_body_parts *parts, batten_body **out);
/** One more reference to a body, from borrowed to yours. */
BATTEN_API batten_body *batten_body_ref(const batten_body *body);
/** Give a reference to a body back; NULL is welcome. */
BATTEN_API void batten_body_unref(batten_body *body);
/** Valid as long as the body. */
BATTEN_API const batten_body_parts *batten_body_view(const batten_body *body);
/** A box that holds the body, to its tolerance: that of the vertices and of the control points
 * of the edges, and of the part of each surface that is within the parameters of the face's
 * loops, where that swells beyond the edges. Loops of bodies that are not traced are followed
 * for that at samples. Found when it is first asked for, and kept.
 *
 * Cost: of faces whose surface reaches beyond the box of all edges, some hundred evaluations
 * where they are not plane. */
BATTEN_API batten_box batten_body_box(const batten_body *body);
/**
 * The body under an affine map.
 *
 * A map that mirrors turns the loops and sides of faces, so that outside stays outside.
 *
 * @param body  any body
 * @param map  finite and not singular, else BAD_ARGUMENT
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of all curves and surfaces.
 */
BATTEN_API batten_status batten_body_transform(const batten_body *body,
                                               const batten_affine *map, batten_body **out);
/**
 * One face that is the whole of a NURBS surface, with its border as edges: opposite borders
 * that are the same curve are one edge (a seam), borders that are one point have no curve (a
 * pole). It is traced.
 * @param name  copied
 * @param surface  in space, of any kind; one that is not a NURBS surface is approximated within
 *              the tolerance
 * @param tolerance model units, > 0, for what is the same
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points; of another kind that of batten_surface_to_nurbs.
 */
BATTEN_API batten_status batten_body_from_surface(const char *name,
                                                  const batten_surface *surface,
                                                  double tolerance, batten_body **out);

/* ---- parameter curves ---- */

typedef struct batten_body_trace_report {
    int kept;     /**< parameter curves that were good */
    int rebuilt;  /**< missing, or too far off */
    int seams;    /**< edges put in where a face goes all around a closed surface */
    int poles;    /**< edges without a curve put in */
    double error; /**< the largest distance of an edge from its face, over all uses */
    int loose;    /**< faces whose edges are farther off than the tolerance: `error` says how
                    far */
    int failed;   /**< faces whose edges do not lie on them, or whose loops cannot be closed in
                     (u, v): they are not in the result */
    int rims; /**< borders of surfaces put in as edges, for one loop only goes around a face:
                     free edges that the given body did not have */
} batten_body_trace_report;
/**
 * The same body with everything that work in (u, v) needs: every use has a parameter curve B
 * with the domain of its edge's curve C, |S(B(t)) - C(t)| <= tolerance for all t (checked at
 * samples), continuous along each loop also across the seam of a closed surface; where a loop
 * goes around a closed surface, seams are put in as edges; at poles, edges without a curve.
 * Loops then are closed in (u, v), and the first loop of each face is the outer one. Faces
 * without loops get the border of their surface. Shared edges stay shared: an edge that is
 * divided by a seam is divided in all its uses.
 *
 * Parameter curves lie in the domain of their surface, control points included, and follow one
 * another to the bit. So that they can, a face may get another surface than it had, of the same
 * points and parameters: a plane is made larger; a surface that closes is cut and joined again
 * where its loops cross the cut as seldom as possible. A face that crosses the cut wherever it
 * is (a strip that winds around and around) becomes several faces.
 *
 * Files say that they are better than they are. A face whose edges are farther off than the
 * tolerance is traced with ten times that, and so on up to 5e-3 of the size of the body and
 * 1e-2 of that of the face, and has a note; the tolerance of the result is `miss` then.
 *
 * Given parameter curves are kept, mapped to the domain of the edge, when they are good there
 * at four places of each span and 16 at least. Others are exact where the edge lies in a plane,
 * straight where that is good enough, else cubics through feet of the edge on the surface, with
 * a tenth of the tolerance for their own error. Loops that run the wrong way are turned, or the
 * side of the face is where its neighbours say so, with a note.
 *
 * @param tolerance model units, > 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes     each face that fails, and why; may be NULL
 * @param report    may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BAD_ARGUMENT (tolerance), OUT_OF_MEMORY, CANCELLED or INCOMPLETE; a face that cannot
 * be traced is not a failure
 *
 * Cost: for each edge that is kept or straight one evaluation of it and of the surface for each
 * sample; for each piece that is followed about eight of the surface.
 */
BATTEN_API batten_status batten_body_trace(const batten_body *body, double tolerance,
                                           const batten_job *job, batten_notes *notes,
                                           batten_body_trace_report *report, batten_body **out);

/* ---- measures ---- */

typedef struct batten_body_measures {
    double area;
    double volume;      /**< within the shells; of a body that is not closed, 0 */
    double centroid[3]; /**< of the volume, or of the area when it is not closed */
    double edge_length; /**< every edge once */
    bool is_closed;     /**< every edge has two uses, one each way, and no face ends where its
                             surface does for want of a loop */
    double area_error, volume_error; /**< from two rules of integration, and the tracing */
    batten_box box;   /**< the tight one: it holds the body, to the body's tolerance */
    double box_error; /**< so far its sides may be from the body; large where faces could not be
                           traced: then it is batten_body_box */
    int unmeasured;   /**< faces that could not be traced and are not in the area */
} batten_body_measures;
/**
 * By Green's theorem: Gauss along the loops in (u, v), and across to them.
 *
 * Loops are cut at the knot lines of their surface. Everything is measured with two rules, and
 * what they differ in is halved until the precision is reached; by their shorter rule, so
 * `area_error` and `volume_error` are much above what the result is off. To them is added the
 * room between the edges and the curves of the faces, and what loops leave open that cross: the
 * whole of the face, where that is more than a thousandth of it. The volume is the mean of the
 * integrals of x Nx, y Ny and z Nz, which agree when the faces close; their spread is part of
 * its error. It is negative where the faces have their outside inside. Faces that cannot be
 * traced within the tolerance of the body are traced more coarsely, up to 1e-3 of its size. The
 * box is that of the edges, where a coordinate turns back, and of the places inside of faces
 * that are farther out, found within the precision times the size of the body.
 *
 * @param precision relative, > 0; one below the rounding of the numbers is met as far as they
 * can
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @return BATTEN_OK; BAD_ARGUMENT (precision); TOLERANCE_NOT_MET when the precision is not
 * reached after about 4 million evaluations for a face, loops of a face cross, or faces could
 * not be traced, which then are not measured: the measures are set then; OVERFLOW
 * Cost: about 250 evaluations for each span of the loops and each knot line across.
 */
BATTEN_API batten_status batten_body_measure(const batten_body *body, double precision,
                                             const batten_job *job, batten_body_measures *out);

/* ---- what is wrong with it ---- */

typedef struct batten_body_faults {
    int free_edges;    /**< one use: the rim of a sheet */
    int shared_edges;  /**< two uses, one each way */
    int wrong_edges;   /**< two uses the same way: faces turned against each other */
    int crowded_edges; /**< more than two uses */
    int tiny_edges;    /**< shorter than the tolerance */
    int gaps; /**< ends of curves that miss their vertices by more than the tolerance */
    double largest_gap; /**< model units */
    int loose;          /**< edges that miss the surface of a face by more than the tolerance */
    double largest_miss;
    int crossing_loops; /**< loops that touch or cross themselves or another of the face */
    int poles, seams;
    int close_knots;   /**< curves and surfaces with knots nearer than 1e-6 of the domain */
    int open_shells;   /**< said to be closed, but with free edges */
    int turned_shells; /**< of a solid: its outer shell, when the volume within is below 0, and
                            voids of which it is above; each shell that closes */
} batten_body_faults;
/**
 * Look at every edge, face and shell; nothing is changed.
 *
 * Edges of traced bodies are compared with their curves on the faces, others with the nearest
 * places of the surface, at up to 64 places of each. Loops are looked at in (u, v), of bodies
 * that are not traced after tracing them so: faces that cannot be have a note. Crossings are
 * found by halving, and places where loops meet in a vertex; loops that touch between vertices
 * without crossing may be left out.
 * @param tolerance model units, > 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes each fault with the face or edge and the number; may be NULL
 * @return BATTEN_OK, however bad the body is; BAD_ARGUMENT (tolerance), CANCELLED, INCOMPLETE,
 * OUT_OF_MEMORY. Cost: n log n for n edges; of bodies that are not traced the search for nearest places.
 */
BATTEN_API batten_status batten_body_check(const batten_body *body, double tolerance,
                                           const batten_job *job, batten_notes *notes,
                                           batten_body_faults *out);

#ifdef __cplusplus
}
#endif
#endif
