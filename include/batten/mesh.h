#ifndef BATTEN_MESH_H
#define BATTEN_MESH_H
/**
 * @file
 * Meshes of triangles, and triangles from surfaces and bodies.
 */
#include <batten/body.h>
#include <batten/triangles.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_mesh batten_mesh;

/** A named number of each vertex, such as a curvature. */
typedef struct batten_mesh_attribute {
    const char *name;
    const double *values; /**< [vertex_count] */
} batten_mesh_attribute;

/** All that a mesh is: what batten_mesh_create takes and batten_mesh_view shows. */
typedef struct batten_mesh_parts {
    int vertex_count;
    const double *points;  /**< [vertex_count][3] */
    const double *colours; /**< [vertex_count][3], sRGB, 0..1; or NULL */
    int triangle_count;
    const int *corners;    /**< [triangle_count][3], counter-clockwise from outside */
    const double *normals; /**< [triangle_count][3 corners][3], unit; or NULL. Of the corner and
                                not of the vertex: faces that meet in an edge differ there */
    const int *faces;      /**< [triangle_count] of the body that it was made of; or NULL */
    const double *triangle_colours; /**< [triangle_count][3], sRGB, 0..1; or NULL */
    int attribute_count;
    const batten_mesh_attribute *attributes;
} batten_mesh_parts;

/**
 * Make a mesh; everything is copied.
 *
 * @param parts  vertices, triangles, and what belongs to them
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT naming the triangle with a corner that is not a vertex;
 * NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: linear in vertices and triangles.
 */
BATTEN_API batten_status batten_mesh_create(const batten_mesh_parts *parts, batten_mesh **out);
/** One more reference to a mesh, from borrowed to yours. */
BATTEN_API batten_mesh *batten_mesh_ref(const batten_mesh *mesh);
/** Give a reference to a mesh back; NULL is welcome. */
BATTEN_API void batten_mesh_unref(batten_mesh *mesh);
/** What the mesh is made of; borrowed, as long as the mesh lives. */
BATTEN_API const batten_mesh_parts *batten_mesh_view(const batten_mesh *mesh);
/**
 * The box of all vertices.
 *
 * @param mesh  any mesh
 */
BATTEN_API batten_box batten_mesh_box(const batten_mesh *mesh);
/**
 * The mesh under an affine map. A map that mirrors turns the triangles, so that the outside
 * stays outside.
 *
 * @param mesh  any mesh
 * @param map  finite and not singular, else BAD_ARGUMENT
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in vertices and triangles.
 */
BATTEN_API batten_status batten_mesh_transform(const batten_mesh *mesh,
                                               const batten_affine *map, batten_mesh **out);
/**
 * Vertices at the same point (bit for bit) become one, as files without sharing need.
 * Triangles keep their order; those that lose their area stay.
 *
 * @param mesh  any mesh
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in vertices and triangles, by a table of 2 to 4 times as many places as
 * vertices.
 */
BATTEN_API batten_status batten_mesh_weld(const batten_mesh *mesh, batten_mesh **out);

/* ---- what is true of a mesh ---- */

typedef struct batten_mesh_facts {
    int edges;           /**< distinct */
    int rim_edges;       /**< of one triangle */
    int wrong_edges;     /**< of two triangles that run along it the same way */
    int crowded_edges;   /**< of more than two triangles */
    int flat_triangles;  /**< two corners are one vertex, or the area is 0 */
    int loose_vertices;  /**< of no triangle */
    int pieces;          /**< connected by edges */
    int euler;           /**< vertices in use - edges + triangles */
    bool is_watertight;  /**< every edge has two triangles, one each way */
    double area, volume; /**< volume: 0 unless watertight */
    double centroid[3];  /**< of the volume, or of the area */
} batten_mesh_facts;

/**
 * Whether a mesh is closed, and what is wrong with it.
 *
 * @param mesh  any mesh
 * @param[out] out  counts of edges by kind, components, areas
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: n log n of the triangles.
 */
BATTEN_API batten_status batten_mesh_check(const batten_mesh *mesh, batten_mesh_facts *out);

/* ---- triangles from shapes ---- */

typedef struct batten_mesh_options {
    size_t size;
    double chord;   /**< how far triangles may be from the surface, model units; 0: 1e-3 of the
                         size of the shape */
    double angle;   /**< between the normals at the ends of an edge, radians; 0.35 */
    double longest; /**< edge, model units; 0: any */
    int most;       /**< triangles; 10 million */
} batten_mesh_options;
/** The defaults of meshes: those beside the fields of batten_mesh_options. */
BATTEN_API batten_mesh_options batten_mesh_defaults(void);

typedef struct batten_mesh_report {
    double chord; /**< the largest distance found, at samples inside triangles and edges */
    double angle;
    int failed;   /**< faces left out; each has a note */
    double asked; /**< the chord asked for, or chosen where that was 0 */
    int beyond;   /**< triangles that are farther from the surface than that */
    double error; /**< how far the edges at those are from their faces, at most: triangles at
                       an edge cannot be nearer to both of its faces than it is itself */
} batten_mesh_report;

/**
 * Triangles of a body: each edge is sampled once, so that faces that share it meet without a
 * gap; poles are one vertex; normals are those of the surface, turned outside.
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param notes, report may be NULL
 * @return BATTEN_OK, also when faces were left out (report->failed), and when the chord is not
 * met: report->beyond is above 0 then, and report->off says whether edges off their faces are
 * why; TOO_LARGE beyond `most`; BAD_ARGUMENT for options out of range, and a chord in the
 * roundoff of the size; CANCELLED, INCOMPLETE
 *
 * Triangles are as long as the surface is straight that way. Where an edge is so long that it
 * keeps points away from where its faces need them it is divided, and these faces are made
 * again. The chord is met also where edges are off their faces by up to 0.88 of it.
 *
 * What is beyond `most` is refused before the work, by an estimate from second derivatives at
 * samples; the message has the number and a chord that would do. Triangles along edges are not
 * in it: the work stops when there are `most`. A face whose border crosses itself in (u, v)
 * gets finer samples there, then corners where its edges truly are, else it is left out. The
 * distance reached is that of samples, four in each triangle, from its plane. Cost: O(n log n)
 * for n triangles; 200,000 of a bicubic surface in half a second.
 * Source: [FMM86] for the bound, [Bowyer81] and [Sloan93] for the triangles.
 */
BATTEN_API batten_status batten_mesh_from_body(const batten_body *body,
                                               const batten_mesh_options *options,
                                               const batten_job *job, batten_notes *notes,
                                               batten_mesh_report *report, batten_mesh **out);
/**
 * The same of a whole surface of any kind.
 *
 * @param surface  in space
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_mesh_from_body; BAD_ARGUMENT (dimension)
 *
 * Cost: as batten_mesh_from_body; a surface that is not a NURBS surface is approximated before.
 */
BATTEN_API batten_status batten_mesh_from_surface(const batten_surface *surface,
                                                  const batten_mesh_options *options,
                                                  const batten_job *job,
                                                  batten_mesh_report *report,
                                                  batten_mesh **out);

/**
 * The same of Bezier triangles in space: all are divided alike, and those that share an edge by
 * the same control points share the vertices on it.
 *
 * @param triangles  in space
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_mesh_from_body; BAD_ARGUMENT (dimension). Where normals jump the angle
 * cannot be reached, which the report says
 *
 * Cost: linear in the triangles that are made.
 */
BATTEN_API batten_status batten_mesh_from_triangles(const batten_triangles *triangles,
                                                    const batten_mesh_options *options,
                                                    const batten_job *job,
                                                    batten_mesh_report *report,
                                                    batten_mesh **out);

#ifdef __cplusplus
}
#endif
#endif
