/* A depth buffer for triangles, three samples by three for each pixel, one band of rows after
 * another. */
#ifndef BAT_RASTER_H
#define BAT_RASTER_H
#include "base/base.h"

#include <stdint.h>

/* Samples in each direction of a pixel, and values that run over a triangle. */
enum { BAT_SAMPLES = 3, BAT_VALUES = 6 };

typedef struct {
    int width, first_row,
        rows;      /* in samples; the band holds first_row .. first_row + rows - 1 */
    float *depth;  /* [rows][width], larger is nearer */
    float *colour; /* [rows][width][3], linear light */
} bat_raster;

/* A corner of a triangle, in samples: sample (i, j) lies at (i + 0.5, j + 0.5), y down. */
typedef struct {
    double x, y, depth;
    double value[BAT_VALUES];
} bat_corner;

/* What a shader knows of one sample. */
typedef struct {
    double value[BAT_VALUES];
} bat_fragment;

typedef void bat_shader(const void *user, const bat_fragment *fragment, float colour[3]);

batten_status bat_raster_make(int width, int rows, bat_raster *out);
void bat_raster_free(bat_raster *raster);
/* Begin a band that starts at `first_row`; `top` and `bottom` are the backgrounds (linear
 * light) of the whole picture's first and last row, which is `height` samples high. */
void bat_raster_begin(bat_raster *raster, int first_row, int height, const float top[3],
                      const float bottom[3]);
void bat_raster_triangle(bat_raster *raster, const bat_corner *a, const bat_corner *b,
                         const bat_corner *c, bat_shader *shader, const void *user);
/* Average the samples of the band into pixels 0xRRGGBB; `stride` is the distance of rows in
 * pixels. */
void bat_raster_resolve(const bat_raster *raster, uint32_t *pixels, size_t stride);

#endif
