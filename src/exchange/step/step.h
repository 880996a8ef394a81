/* Writing STEP, ISO 10303-21, with the schema AUTOMOTIVE_DESIGN (AP214). */
#ifndef BAT_STEP_H
#define BAT_STEP_H
#include "base/base.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_write_step(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text);

/* ---- instances (part21.c) ---- */

/* The data section as it grows: instances with ids from 1 on, wrapped at 120 columns. */
typedef struct {
    batten_text text;
    size_t line; /* where the last line begins */
    int count;   /* instances so far */
    batten_notes *notes;
    double tolerance;
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
/* A whole instance; the arguments are short and ASCII. */
int bat_step_add(bat_step *step, const char *keyword, const char *format, ...)
    BATTEN_PRINTF(3, 4);

/* ---- shapes (geometry.c): what they are given is clamped and in space ---- */

int bat_step_point(bat_step *step, const double *point);
/* `count` points with consecutive ids; the first is handed back. */
int bat_step_points(bat_step *step, const double *points, size_t count);

/* A row of control points, which may be one of a net. */
typedef struct {
    int degree, count;
    const double *knots;   /* [count + degree + 1] */
    const double *points;  /* of the first; [3] each */
    const double *weights; /* of the first; or NULL */
    size_t stride;         /* from one point to the next */
    int first_id;          /* of the instances of its points, with the same stride */
} bat_step_row;
int bat_step_curve(bat_step *step, const char *name, const bat_step_row *row);
int bat_step_surface(bat_step *step, const char *name, const batten_surface *surface,
                     int first_id);

/* ---- faces (face.c) ---- */

/* The whole of a surface as an ADVANCED_FACE; 0 when its whole border is one point. */
int bat_step_face(bat_step *step, const char *name, const batten_surface *surface);

#endif
