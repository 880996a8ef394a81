/*
 * STEP, ISO 10303-21: reading it, which begins in read.c, and writing it with the schemas of
 * AP203, AP214 and AP242, which is what follows.
 */
#ifndef BAT_STEP_H
#define BAT_STEP_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_read_step(bat_input *input, batten_model **out);
/* Can two directions and a point say the place? */
bool bat_step_can_place(const batten_affine *place);
batten_status bat_write_step(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text);

/* ---- instances (part21.c) ---- */

/* The data section as it grows: instances with ids from 1 on, wrapped at 120 columns. */
typedef struct {
    batten_text *text;
    size_t line; /* where the last line begins */
    int count;   /* instances so far */
    batten_notes *notes;
    double tolerance;
    bool has_parameter_curves;
    int plane_context; /* of curves in (u, v); 0 before the first */
} bat_step;

/* Begin "#n=KEYWORD("; the id is handed back. Without a keyword it is a complex instance. */
int bat_step_open(bat_step *step, const char *keyword);
/* End what was begun. */
void bat_step_close(bat_step *step);
/* Append a token; a line is broken before it, never inside. */
void bat_step_token(bat_step *step, const char *token);
/* A reference, an integer, a real: followed by `after`, which has less than 16 characters. */
void bat_step_id(bat_step *step, int id, const char *after);
void bat_step_integer(bat_step *step, int value, const char *after);
void bat_step_real(bat_step *step, double value, const char *after);
/* A string in its quotes; what is not ASCII is escaped. */
void bat_step_string(bat_step *step, const char *value, const char *after);
/* References with commas between them. */
void bat_step_ids(bat_step *step, const int *ids, int count, const char *after);
/* The same of `count` consecutive ids. */
void bat_step_range(bat_step *step, int first, int count, const char *after);
/* A whole instance; the arguments are short and ASCII. */
int bat_step_add(bat_step *step, const char *keyword, const char *format, ...)
    BATTEN_PRINTF(3, 4);
/* A whole instance of a name and of references in a list: KEYWORD('name',(#1,#2)). */
int bat_step_list(bat_step *step, const char *keyword, const char *name, const int *ids,
                  int count);

/* ---- shapes (geometry.c): what they are given is clamped ---- */

int bat_step_point(bat_step *step, int dimension, const double *point);
/* `count` points with consecutive ids; the first is handed back. */
int bat_step_points(bat_step *step, int dimension, const double *points, size_t count);

/* Control points that are there already: the ids first, first + step ... */
typedef struct {
    int first, step;
} bat_step_row;
/* Without a row the points of the curve are written first. */
int bat_step_curve(bat_step *step, const char *name, const batten_curve *curve,
                   const bat_step_row *row);
int bat_step_surface(bat_step *step, const char *name, const batten_surface *surface,
                     int first_id);
int bat_step_placement(bat_step *step, const double origin[3], const double z[3],
                       const double x[3]);

/* ---- bodies (write_body.c) ---- */

/* Write a body: the id of its SHELL_BASED_SURFACE_MODEL, MANIFOLD_SOLID_BREP or
 * BREP_WITH_VOIDS, 0 when nothing was left of it; and the ids of its faces [face_count], 0 for
 * those left out. */
batten_status bat_step_body(bat_step *step, const char *name, const batten_body *body,
                            int *faces, int *out);

#endif
