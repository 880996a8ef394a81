/* Meshes in shaded pictures. */
#ifndef BAT_MESH_SOLID_H
#define BAT_MESH_SOLID_H
#include "picture/lines/stroke.h"
#include "picture/shaded/light.h"
#include "picture/shaded/raster.h"

/* One mesh, ready to be filled in. */
typedef struct {
    const batten_mesh_parts *mesh;
    double *points;  /* [vertex_count][3]; in samples, depth towards the eye, when filled */
    double *flat;    /* [triangle_count][3], when the mesh has no normals; or NULL */
    bat_light *dyes; /* [vertex_count]; of coloured vertices; or NULL */
    bat_strokes lines;
    const bat_scene *scene;
    bat_light albedo;
} bat_mesh_solid;

/* Lines: where it is edged; all edges of the triangles, when they are few and `all_edges`. */
batten_status bat_mesh_solid_make(const batten_mesh *mesh, bool all_edges,
                                  const bat_scene *scene, bat_light albedo,
                                  bat_mesh_solid *out);
void bat_mesh_solid_free(bat_mesh_solid *solid);
void bat_mesh_solid_fill(bat_raster *band, const bat_mesh_solid *solid);

#endif
