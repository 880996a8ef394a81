/*
 * The format .g2 of GoTools: text, one object after another, each with a header "class major
 * minor n" and n numbers, then its numbers.
 */
#ifndef BAT_G2_H
#define BAT_G2_H
#include "body/builder.h"
#include "body/elementary/elementary.h"
#include "exchange/reading/census.h"
#include "exchange/reading/words.h"
#include <batten/text.h>

batten_status bat_g2_recognise(const bat_input *input, bool *is_g2);
batten_status bat_read_g2(bat_input *input, batten_model **out);
batten_status bat_write_g2(const batten_model *model, const batten_write_options *options,
                           batten_notes *notes, batten_text *text);

/* The tolerance for the loops of one face (loose.c): that of the body, or more where the edges
 * of this face are farther off it, or off their vertices. */
batten_status bat_g2_loop_tolerance(const batten_body_parts *parts,
                                    const batten_body_face *face, const batten_surface *surface,
                                    double *tolerance);

/* The classes that are known. */
enum {
    BAT_G2_CURVE = 100,
    BAT_G2_LINE = 120,
    BAT_G2_CIRCLE = 130,
    BAT_G2_ELLIPSE = 140,
    BAT_G2_BOUNDED_CURVE = 150,
    BAT_G2_SURFACE = 200,
    BAT_G2_BOUNDED_SURFACE = 210,
    BAT_G2_PLANE = 250,
    BAT_G2_CYLINDER = 260,
    BAT_G2_SPHERE = 270,
    BAT_G2_CONE = 280,
    BAT_G2_TORUS = 290,
    BAT_G2_REVOLUTION = 291,
    BAT_G2_MESH = 310,
    BAT_G2_POINTS = 400,
    BAT_G2_LINES = 410
};

/* What a class is called; NULL for one that is not known. */
const char *bat_g2_class_name(int class);
/* Is the last word the class at the start of a header? */
bool bat_g2_is_header(bat_words words);
/* Counts are int: no more than this, and no more than the limit on points. */
static inline int bat_g2_most_points(const bat_input *input)
{
    const size_t most = 1000000000;
    return (int)(input->limits.points < most ? input->limits.points : most);
}

/* Does another object begin with the next word, or the text end? */
bool bat_g2_is_at_end(const bat_words *words);

/* ---- parts of objects (curves.c) ---- */

/* One direction of a spline: how many points, the degree, the knots, which are the caller's. */
batten_status bat_g2_read_axis(bat_words *words, batten_axis *axis, double **knots);
/* Weighted points (w x, w y, w z, w) become points, in their place, and weights. */
batten_status bat_g2_divide_weights(bat_words *words, int dimension, size_t count,
                                    double *points, double **weights);
/* @param count coordinates; the third is 0 in the plane */
batten_status bat_g2_read_vector(bat_words *words, const char *what, int count,
                                 batten_vec3 *out);
/* z and x as they were read become square and of length one. */
batten_status bat_g2_make_frame(const bat_words *words, batten_frame *frame);
/* Two numbers of a range, a < b, whichever comes first; the standard one when the object is alone and none follow. */
batten_status bat_g2_read_range(bat_words *words, bool alone, batten_interval standard,
                                batten_interval *range, bool *is_backwards);

/* ---- objects ---- */

/* The body of an object of a class. UNSUPPORTED for classes that are no curves (surfaces).
 * @param alone  it stands under its own header: then old files leave out the ranges of
 * elementary ones */
batten_status bat_g2_read_curve(bat_words *words, int class, bool alone, batten_curve **out);
/* What a surface of a file is. */
typedef struct {
    batten_surface *surface;  /* NULL where the file gives it no bounds */
    bat_elementary unbounded; /* what it is then, */
    bool is_swapped;          /* with u and v exchanged */
    bool is_spline;           /* parameter curves on it are in the parameters of the surface */
    bool is_plane;            /* and here in lengths along x and y of `frame`, */
    batten_frame frame;
} bat_g2_ground;

/* @param alone  it stands under its own header: then it must have bounds */
batten_status bat_g2_read_surface(bat_words *words, int class, bool alone, bat_g2_ground *out);
/* One curve of a loop: in the parameters, in space, or both. */
typedef struct {
    batten_curve *parameters, *space;
    bool by_parameters; /* these are its master */
} bat_g2_trim;

/* On a plane it is in space afterwards; what was read is the caller's also where it fails. */
batten_status bat_g2_read_trim(bat_words *words, const bat_g2_ground *ground,
                               bat_g2_trim *trim);
/* In space afterwards, and in the parameters where these are the surface's; where both forms were there and part by more
 * than 1e-6 of the size, the other is made of the master, and *parted grows to their distance. */
batten_status bat_g2_settle_trim(bat_words *words, const bat_g2_ground *ground, double size,
                                 double tolerance, bat_g2_trim *trim, double *parted);
/* A bounded surface: one face. */
batten_status bat_g2_read_face(bat_words *words, const batten_body_face *look,
                               batten_body **out);

#endif
