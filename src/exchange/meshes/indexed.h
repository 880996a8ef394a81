/* A mesh of vertices and polygons, as readers gather it. */
#ifndef BAT_INDEXED_H
#define BAT_INDEXED_H
#include "exchange/reading/input.h"

typedef struct {
    bat_input *input;
    size_t count;              /* vertices */
    double *points;            /* [count][3]; a vertex that could not be read is NaN */
    double *colours, *normals; /* [count][3], or NULL */
    bat_list attributes;       /* of batten_mesh_attribute, with memory of ours */
    bat_list polygon;          /* of int64_t: the corners of the one that is being read */
    bat_list triangles;        /* of int[3] */
    bat_list triangle_colours; /* of double[3]; none, or one for each triangle */
    bat_list places, cut;      /* of the polygon */
    size_t polygons, cut_up;   /* all; those of more than three corners */
    int odd;                   /* polygons that cross themselves or the like */
} bat_indexed;

/* Of no vertex yet: `points`, and what else there is, come by bat_input_array. */
bat_indexed bat_indexed_begin(bat_input *input);
void bat_indexed_end(bat_indexed *mesh);

/* The polygon becomes triangles and is empty again. One with too few corners, or a corner that
 * is no vertex, is left out with a note. */
batten_status bat_indexed_polygon(bat_indexed *mesh, int line);
/* One that could not be read: its corners are forgotten. `index` counts from 0. */
void bat_indexed_leave_out(bat_indexed *mesh, int line, size_t index, const char *why);
/* The colour of the triangles that the last polygon became; then each polygon has one. */
batten_status bat_indexed_colour(bat_indexed *mesh, const double colour[3]);
/* A further number of each vertex; the memory is then the mesh's. */
batten_status bat_indexed_attribute(bat_indexed *mesh, bat_span name, double **values);
/* Add it to the model: as a mesh, or, when there is no polygon, as a row of points. */
batten_status bat_indexed_add(bat_indexed *mesh, const char *name, batten_model *model);

#endif
