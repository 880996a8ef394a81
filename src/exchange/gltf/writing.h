/* A glTF file while it is written. */
#ifndef BAT_GLTF_WRITING_H
#define BAT_GLTF_WRITING_H
#include "exchange/gltf/gltf.h"
#include "model/definitions.h"

/* A node is an object of a definition at one of its places. */
typedef struct {
    const batten_object *object;
    int number;       /* of the object among those of all definitions */
    int first, count; /* its children */
} bat_gltf_node;

/* The accessors of a mesh; -1 for none. */
typedef struct {
    int positions, normals, colours;
    int indices; /* of all triangles */
} bat_gltf_vertices;

typedef struct {
    batten_notes *notes;
    double unit;
    bat_definitions definitions;
    bat_gltf_node *nodes;
    int node_count, node_capacity, root_count;
    int *mesh_of;            /* [objects] index of the mesh + 1; 0: none */
    int *same, *look;        /* [objects] the first with the same mesh, and with its look too */
    bat_gltf_vertices *data; /* [objects] of that first one */
    int mesh_count, material_count, accessor_count;
    batten_text bytes, meshes, materials, accessors, views;
    double error; /* of rounding, metres */
} bat_gltf_writing;

void bat_gltf_put_numbers(batten_text *text, int count, const double *numbers);
batten_status bat_gltf_put_meshes(bat_gltf_writing *w);

#endif
