/*
 * OBJ: polygons, lines, points and free-form curves and surfaces over one list of vertices. It
 * has no units. Colours of materials stand in a file beside it, which is not read.
 * Source: [Wavefront].
 */
#ifndef BAT_OBJ_H
#define BAT_OBJ_H
#include "exchange/reading/input.h"
#include "exchange/reading/scan.h"
#include <batten/exchange.h>
#include <batten/text.h>

/* By its first statements that are no comments. */
batten_status bat_obj_recognise(const bat_input *input, bool *is_such);
batten_status bat_read_obj(bat_input *input, batten_model **out);
batten_status bat_write_obj(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

/* ---- what is shared by the parts of the reader ---- */

typedef struct {
    double point[3]; /* NaN when it could not be read */
    double weight, colour[3];
    bool has_colour, is_used;
} bat_obj_vertex;

/* Indices from 0 on; what is not given is INT64_MIN. */
typedef struct {
    int64_t vertex, normal;
} bat_obj_corner;

typedef enum { BAT_OBJ_FACE, BAT_OBJ_LINE, BAT_OBJ_POINT, BAT_OBJ_SHAPE } bat_obj_kind;

typedef struct {
    bat_obj_kind kind;
    size_t first, count; /* corners; of a SHAPE, its index in `shapes` */
    int line;
} bat_obj_element;

/* What stands between two statements "o" or "g". */
typedef struct {
    bat_span object, group;
    size_t first; /* element */
} bat_obj_part;

/* A free-form curve or surface; one of the two. */
typedef struct {
    batten_curve *curve;
    batten_surface *surface;
} bat_obj_shape;

typedef enum {
    BAT_OBJ_NO_BASIS,
    BAT_OBJ_BSPLINE,
    BAT_OBJ_BEZIER,
    BAT_OBJ_CARDINAL,
    BAT_OBJ_BMATRIX,
    BAT_OBJ_OTHER
} bat_obj_basis;

/* The curve or surface between its first statement and "end". */
typedef struct {
    bat_obj_basis basis;
    bool is_rational;
    int degree[2], step[2];
    bat_list matrix[2]; /* of double, row by row of (degree + 1)^2 */
    int open;           /* 0: none, 1: a curve, 2: a surface */
    int line;
    double range[2][2];
    bat_list corners; /* of bat_obj_corner */
    bat_list knots[2];
    int trims; /* statements that bound it or attach something */
} bat_obj_free;

typedef struct {
    bat_input *input;
    bat_scan scan;
    bool continues; /* the line goes on after the next end of a line */
    bat_list vertices, normals, corners, elements, parts, shapes;
    int bad_vertices; /* left out */
    size_t textures;  /* vertices of texture */
    bat_span object, group;
    bool is_new_part;
    bat_obj_free free;
    int materials; /* statements that name one */
} bat_obj;

/* The next word of a statement, over lines that end with a backslash, up to a comment. */
bool bat_obj_next(bat_obj *obj, bat_span *word);
bool bat_obj_number(bat_obj *obj, double *value);
/* The rest of the statement as corners. *bad counts words that are none. */
batten_status bat_obj_corners(bat_obj *obj, bat_list *corners, int *bad);
/* Fails for more than `limit`, and for more than a mesh can number. */
batten_status bat_obj_limit(bat_input *input, int line, size_t count, size_t limit,
                            const char *what);
/* Make an element of the current part. */
batten_status bat_obj_add(bat_obj *obj, const bat_obj_element *element);

/* Statements of free-form shapes; *is_such when the word is one. */
batten_status bat_obj_free_statement(bat_obj *obj, bat_span word, bool *is_such);
void bat_obj_shape_end(const bat_obj_shape *shape);
/* A shape without its "end" is left out. */
void bat_obj_free_close(bat_obj *obj);

/* The objects of all parts. */
batten_status bat_obj_finish(bat_obj *obj, batten_model *model);

#endif
