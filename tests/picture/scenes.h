/* What the tests of pictures share: simple models, decoded pictures, the words of a PDF. */
#ifndef TESTS_PICTURE_SCENES_H
#define TESTS_PICTURE_SCENES_H
#include "support/test.h"
#include <batten/picture.h>

/* ---- models; each is the caller's ---- */

batten_model *scene_empty(void);
/* A model in metres of this one surface, which is taken over. */
batten_model *scene_of(batten_surface *surface);
void scene_add_surface(batten_model *model, const char *name, batten_surface *surface);
void scene_add_curve(batten_model *model, const char *name, batten_curve *curve);

/* Degree p and q, clamped and evenly spaced knots, points [count_u][count_v][3]. */
batten_surface *scene_net(int p, int count_u, int q, int count_v, const double *points);
/* A profile of pieces of degree 2, rows of (radius, height, weight), turned about z. */
batten_surface *scene_turned(int count, const double *profile);
batten_surface *scene_sphere(double radius);
batten_surface *scene_torus(double major, double minor);
/* Along x, from -length / 2 to length / 2. */
batten_surface *scene_cylinder(double radius, double length);
/* The half hull y = side * B/2 (1 - X^2) (1 - Z^2), X = 2x/L, Z = z/T in [-1, 0]. */
batten_surface *scene_wigley(double length, double beam, double draught, double side);
/* Open uniform knots. */
batten_curve *scene_curve(int dimension, int degree, int count, const double *points);
batten_curve *scene_circle(double radius);

/* Usual options for the lines of a hull of this length; with failing allocations only few
 * lines, for each run draws all of them. */
batten_draw_lines_plan_options scene_plan(double length);

/* ---- pictures ---- */

typedef struct {
    int width, height;
    const uint32_t *pixels; /* 0xRRGGBB */
} scene_image;

/* Decode a PNG; the memory is the test's. */
scene_image scene_decode(const char *data, size_t size);
uint32_t scene_pixel(const scene_image *image, int x, int y);
int scene_red(uint32_t pixel);
int scene_green(uint32_t pixel);
int scene_blue(uint32_t pixel);

/* ---- text ---- */

typedef struct {
    double left, top, right, bottom;
    char text[64];
} scene_word;

typedef struct {
    int count;
    scene_word *words;
} scene_words;

/* The words of a PDF with their places, as pdftotext finds them; SKIP without it. */
scene_words scene_read_pdf(const char *data, size_t size);
const scene_word *scene_find(const scene_words *words, const char *text);
/* Every word lies on the sheet, and none on another. */
void scene_check_words(const scene_words *words, double width, double height);

#endif
