/* The file of a canvas when all is drawn: names put, bytes handed over. */
#include "picture/sheet/canvas.h"

#include <string.h>

/* cairo numbers its surfaces through the life of the program and writes that number into an
 * SVG. Nothing refers to it; equal digits make equal bytes. */
static void forget_surface_number(batten_text *svg)
{
    static const char mark[] = "<g id=\"surface";
    char *at = svg->bytes ? strstr(svg->bytes, mark) : NULL;
    if (!at)
        return;
    char *digits = at + sizeof mark - 1, *end = digits;
    while (*end >= '0' && *end <= '9')
        end++;
    const size_t rest = svg->length - (size_t)(end - svg->bytes);
    memmove(digits, end, rest + 1);
    svg->length -= (size_t)(end - digits);
}

static batten_status cairo_failure(const bat_canvas *canvas, cairo_status_t status)
{
    if (canvas->bytes.failed || status == CAIRO_STATUS_NO_MEMORY)
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for a picture of %g x %g",
                        canvas->width, canvas->height);
    return bat_fail(BATTEN_UNSUPPORTED, "the picture of %g x %g could not be drawn: %s",
                    canvas->width, canvas->height, cairo_status_to_string(status));
}

batten_status bat_canvas_finish(bat_canvas *canvas, char **data, size_t *size)
{
    bat_canvas_place_names(canvas);
    batten_status status = canvas->status;
    cairo_status_t drawn = cairo_status(canvas->cairo);
    if (drawn == CAIRO_STATUS_SUCCESS && canvas->format == BATTEN_PICTURE_PNG)
        drawn = cairo_surface_write_to_png_stream(canvas->surface, bat_canvas_append,
                                                  &canvas->bytes);
    cairo_surface_finish(canvas->surface);
    if (drawn == CAIRO_STATUS_SUCCESS)
        drawn = cairo_surface_status(canvas->surface);
    if (status == BATTEN_OK && drawn != CAIRO_STATUS_SUCCESS)
        status = cairo_failure(canvas, drawn);
    if (status == BATTEN_OK && canvas->format == BATTEN_PICTURE_SVG)
        forget_surface_number(&canvas->bytes);
    if (status == BATTEN_OK)
        status = batten_text_take(&canvas->bytes, data, size);
    bat_canvas_end(canvas);
    return status;
}
