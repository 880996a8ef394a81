/* What 'info' tells of objects, and what it finds wrong with them. */
#ifndef CLI_FACTS_H
#define CLI_FACTS_H
#include "command.h"

#include <batten/model.h>

/* What is reported of one object, whatever its kind; `directions` is 1 for curves, 2 for surfaces,
 * else 0. */
typedef struct {
    const char *type, *kind;
    int dimension, directions;
    int degree[2], points[2];
    bool rational, closed[2];
    bool controls; /* the box is that of the control points */
    batten_interval domain[2];
    batten_box box;
    double tolerance;       /* ends within it are the same point: 1e-9 of the object's size */
    const char *counted[4]; /* what the counts are of: "faces", ... */
    int counts[4];
    bool has_faces;
    int coloured_faces; /* with colours of their own; of a mesh 0 or all triangles */
    const char *remark; /* "watertight", ...; NULL for none */
    bool mesh_checked;  /* of a mesh: `mesh` was found */
    batten_mesh_facts mesh;
} facts;

facts facts_of(const batten_object *object);

/* Go over the object, whose facts are given: near knots, poles, edges that are tiny, free or
 * used the same way twice, gaps, loops that touch. Notes name it; remarks say what is unusual
 * but not wrong. */
batten_status lint_object(const batten_object *object, const facts *f, batten_notes *notes);

#endif
