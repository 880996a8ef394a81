/* A PLY file while it is read. */
#ifndef BAT_PLY_READING_H
#define BAT_PLY_READING_H
#include "exchange/meshes/indexed.h"
#include "exchange/ply/ply.h"

/* What a property of a vertex says. */
typedef enum {
    BAT_PLY_POINT,
    BAT_PLY_NORMAL = 3,
    BAT_PLY_COLOUR = 6,
    BAT_PLY_FURTHER = 9,
    BAT_PLY_IGNORED
} bat_ply_role;

typedef struct {
    bat_input *input;
    bat_ply_header header;
    bat_ply_items items;
    bat_indexed mesh;
    bat_list values;        /* of double: those of one item */
    bat_list columns;       /* of bat_ply_column: those of a vertex */
    bat_list waiting;       /* of place: faces that stand before the vertices */
    size_t face_colours[3]; /* the properties of a face that are its colour; SIZE_MAX: none */
    size_t reached; /* how far the file was gone through; faces that wait are gone back to */
    bool has_vertices, is_lost;
} bat_ply_reading;

/* Where the numbers of a property go: rows[i * width + offset], scaled. */
typedef struct {
    double *rows;
    double scale;
    size_t width, offset;
} bat_ply_column;

const bat_ply_property *bat_ply_properties_of(const bat_ply_reading *r,
                                              const bat_ply_element *element);
batten_status bat_ply_step(bat_ply_reading *r);
int bat_ply_role_of(const bat_ply_property *property);
/* One number for each property of the element. */
batten_status bat_ply_make_room(bat_ply_reading *r, const bat_ply_element *element);

double bat_ply_scale_of(bat_ply_type type);
batten_status bat_ply_read_vertices(bat_ply_reading *r, const bat_ply_element *element);

#endif
