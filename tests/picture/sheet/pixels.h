/* What stands on a canvas of pixels while it is drawn on. */
#ifndef TESTS_PICTURE_SHEET_PIXELS_H
#define TESTS_PICTURE_SHEET_PIXELS_H
#include "picture/sheet/canvas.h"
#include "support/test.h"

/* The blue of a pixel, 0 to 255: 255 on the bare sheet. */
static inline int level(const bat_canvas *canvas, double x, double y)
{
    cairo_surface_flush(canvas->surface);
    const unsigned char *data = cairo_image_surface_get_data(canvas->surface);
    return data[(int)y * cairo_image_surface_get_stride(canvas->surface) + 4 * (int)x];
}

static inline bool is_dark(const bat_canvas *canvas, double x, double y)
{
    return level(canvas, x, y) < 128;
}

static inline bat_canvas begin_pixels(void)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 200, 100, 10, "", &canvas));
    return canvas;
}

/* The box around all that is dark; of nothing its width is below 0. */
static inline bat_rectangle dark_box(const bat_canvas *canvas)
{
    int x[2] = {1000, -1}, y[2] = {1000, -1};
    for (int i = 0; i < (int)canvas->width; i++)
        for (int k = 0; k < (int)canvas->height; k++)
            if (is_dark(canvas, i, k)) {
                x[0] = i < x[0] ? i : x[0];
                x[1] = i > x[1] ? i : x[1];
                y[0] = k < y[0] ? k : y[0];
                y[1] = k > y[1] ? k : y[1];
            }
    return (bat_rectangle){x[0], y[0], x[1] + 1 - x[0], y[1] + 1 - y[0]};
}

/* Is anything drawn in this box? */
static inline bool has_marks(const bat_canvas *canvas, double x, double y, double width,
                             double height)
{
    for (int i = 0; i < (int)width; i++)
        for (int k = 0; k < (int)height; k++)
            if (level(canvas, x + i, y + k) < 255)
                return true;
    return false;
}

#endif
