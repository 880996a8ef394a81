/* A canvas of cairo for SVG, PDF and PNG, and its bytes when it is done. */
#include "picture/sheet/canvas.h"
#include "base/list.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <stdint.h>
#include <string.h>

/* Longer texts are cut, with dots at the end. */
enum { LONGEST_TEXT = 256 };

cairo_status_t bat_canvas_append(void *closure, const unsigned char *data, unsigned length)
{
    batten_text *bytes = closure;
    batten_text_bytes(bytes, (const char *)data, length);
    return bytes->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

batten_status bat_canvas_check_size(int width, int height)
{
    const int smaller = bat_min_int(width, height), larger = bat_max_int(width, height);
    if (smaller < BAT_LEAST_SIZE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a picture of %d x %d is too small; each side needs at least %d", width,
                        height, BAT_LEAST_SIZE);
    if (larger > BAT_LARGEST_SIZE)
        return bat_fail(BATTEN_TOO_LARGE,
                        "a picture of %d x %d is too large; a side may have %d", width, height,
                        BAT_LARGEST_SIZE);
    return BATTEN_OK;
}

static void clean(const char *text, char out[static LONGEST_TEXT]);

static cairo_surface_t *make_surface(bat_canvas *canvas, const char *title)
{
    const double width = canvas->width, height = canvas->height;
    if (canvas->format == BATTEN_PICTURE_PNG)
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)width, (int)height);
    if (canvas->format == BATTEN_PICTURE_SVG)
        return cairo_svg_surface_create_for_stream(bat_canvas_append, &canvas->bytes, width,
                                                   height);

    cairo_surface_t *surface =
        cairo_pdf_surface_create_for_stream(bat_canvas_append, &canvas->bytes, width, height);
    char letters[LONGEST_TEXT];
    clean(title, letters);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, letters);
    /* A fixed date: the same input gives the same bytes. */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    return surface;
}

/* Letters as the font draws them, so that a text is equally wide in all three formats. */
static void set_fonts(cairo_t *cairo)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cairo, options);
    cairo_font_options_destroy(options);
}

batten_status bat_canvas_begin(batten_picture_format format, int width, int height, double em,
                               const char *title, bat_canvas *out)
{
    batten_status status = bat_canvas_check_size(width, height);
    if (status == BATTEN_OK && format == BATTEN_PICTURE_DXF)
        status = bat_fail(BATTEN_UNSUPPORTED, "only a lines plan is written as DXF");
    if (status != BATTEN_OK)
        return status;
    bat_cover cover;
    status = bat_cover_make(width, height, 0.125 * em, &cover);
    if (status != BATTEN_OK)
        return status;
    *out = (bat_canvas){.format = format,
                        .width = width,
                        .height = height,
                        .em = em,
                        .clip = {0, 0, width, height},
                        .cover = cover};
    out->bytes = BATTEN_TEXT;
    out->surface = make_surface(out, title);
    out->cairo = cairo_create(out->surface);
    set_fonts(out->cairo);
    cairo_set_line_join(out->cairo, CAIRO_LINE_JOIN_ROUND);
    bat_canvas_box(out, (bat_colour){1, 1, 1}, (bat_rectangle){0, 0, width, height});
    return BATTEN_OK;
}

void bat_canvas_end(bat_canvas *canvas)
{
    /* What cairo still writes is not kept: no memory is sought for it. */
    canvas->bytes.failed = true;
    cairo_destroy(canvas->cairo);
    cairo_surface_destroy(canvas->surface);
    batten_text_free(&canvas->bytes);
    bat_release(canvas->taken);
    bat_release(canvas->names);
    bat_cover_free(&canvas->cover);
}

/* ---- lines and areas ---- */

static void set_colour(bat_canvas *canvas, bat_colour colour, double opacity)
{
    cairo_set_source_rgba(canvas->cairo, colour.red, colour.green, colour.blue, opacity);
}

static void set_pen(bat_canvas *canvas, bat_pen pen)
{
    /* Lengths of strokes and gaps, in widths of the line and never shorter than a point. */
    static const struct {
        int count;
        double lengths[4];
    } dashes[] = {[BAT_SOLID] = {0, {0}},
                  [BAT_DASHED] = {2, {6, 4}},
                  [BAT_CHAIN] = {4, {12, 3, 2, 3}},
                  [BAT_DOTTED] = {2, {1.5, 3}}};

    double lengths[4];
    const double unit = bat_max(pen.width, 1);
    for (int i = 0; i < 4; i++)
        lengths[i] = dashes[pen.dash].lengths[i] * unit;
    set_colour(canvas, pen.colour, 1);
    cairo_set_line_width(canvas->cairo, pen.width);
    cairo_set_dash(canvas->cairo, lengths, dashes[pen.dash].count, 0);
    cairo_set_line_cap(canvas->cairo,
                       pen.dash == BAT_SOLID ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
}

static void trace(bat_canvas *canvas, size_t count, const double *xy)
{
    for (size_t i = 0; i < count; i++)
        cairo_line_to(canvas->cairo, xy[2 * i], xy[2 * i + 1]);
}

/* Names keep away from here, but for the ground. */
static void cover_segment(bat_canvas *canvas, const double *from, const double *to, double half)
{
    const bat_rectangle c = canvas->clip;
    if (!canvas->draws_ground)
        bat_cover_segment(&canvas->cover, from, to, half,
                          (double[4]){c.x, c.y, c.x + c.width, c.y + c.height});
}

void bat_canvas_clip(bat_canvas *canvas, bat_rectangle to)
{
    canvas->clip = to;
    cairo_save(canvas->cairo);
    cairo_rectangle(canvas->cairo, to.x, to.y, to.width, to.height);
    cairo_clip(canvas->cairo);
}

void bat_canvas_unclip(bat_canvas *canvas)
{
    cairo_restore(canvas->cairo);
    canvas->clip = (bat_rectangle){0, 0, canvas->width, canvas->height};
}

void bat_canvas_line(bat_canvas *canvas, bat_pen pen, size_t count, const double *xy)
{
    set_pen(canvas, pen);
    trace(canvas, count, xy);
    cairo_stroke(canvas->cairo);
    if (canvas->dxf)
        bat_dxf_sheet_line(canvas->dxf, count, xy);
    for (size_t i = 0; i + 1 < count; i++)
        cover_segment(canvas, xy + 2 * i, xy + 2 * i + 2, 0.5 * pen.width);
}

void bat_canvas_segment(bat_canvas *canvas, bat_pen pen, double x0, double y0, double x1,
                        double y1)
{
    bat_canvas_line(canvas, pen, 2, (double[]){x0, y0, x1, y1});
}

void bat_canvas_fill(bat_canvas *canvas, bat_colour colour, double opacity, size_t count,
                     const double *xy)
{
    set_colour(canvas, colour, opacity);
    trace(canvas, count, xy);
    cairo_close_path(canvas->cairo);
    cairo_fill(canvas->cairo);
}

void bat_canvas_box(bat_canvas *canvas, bat_colour colour, bat_rectangle box)
{
    set_colour(canvas, colour, 1);
    cairo_rectangle(canvas->cairo, box.x, box.y, box.width, box.height);
    cairo_fill(canvas->cairo);
}

void bat_canvas_frame(bat_canvas *canvas, bat_pen pen, bat_rectangle box)
{
    set_pen(canvas, pen);
    cairo_rectangle(canvas->cairo, box.x, box.y, box.width, box.height);
    cairo_stroke(canvas->cairo);
    const double right = box.x + box.width, bottom = box.y + box.height;
    const double corners[5][2] = {
        {box.x, box.y}, {right, box.y}, {right, bottom}, {box.x, bottom}, {box.x, box.y}};
    if (canvas->dxf)
        bat_dxf_sheet_line(canvas->dxf, 5, corners[0]);
    for (int i = 0; i < 4; i++)
        cover_segment(canvas, corners[i], corners[i + 1], 0.5 * pen.width);
}

void bat_canvas_disc(bat_canvas *canvas, bat_colour colour, double x, double y, double radius)
{
    set_colour(canvas, colour, 1);
    cairo_new_path(canvas->cairo);
    cairo_arc(canvas->cairo, x, y, radius, 0, 2 * BAT_PI);
    cairo_fill(canvas->cairo);
    cover_segment(canvas, (double[2]){x, y}, (double[2]){x, y}, radius);
}

void bat_canvas_cross(bat_canvas *canvas, bat_pen pen, double x, double y, double radius)
{
    bat_canvas_segment(canvas, pen, x - radius, y - radius, x + radius, y + radius);
    bat_canvas_segment(canvas, pen, x - radius, y + radius, x + radius, y - radius);
}

/* ---- text ---- */

/* The bytes of the UTF-8 letter that begins here, 0 when they are none. */
static int letter_length(const unsigned char *text)
{
    static const struct {
        unsigned char mask, lead;
        unsigned long least;
    } forms[] = {
        {0x80, 0x00, 0x20}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};

    for (int length = 1; length <= 4; length++) {
        if ((text[0] & forms[length - 1].mask) != forms[length - 1].lead)
            continue;
        unsigned long code = text[0] & (unsigned char)~forms[length - 1].mask;
        for (int i = 1; i < length; i++) {
            if ((text[i] & 0xc0) != 0x80)
                return 0;
            code = code << 6 | (text[i] & 0x3f);
        }
        const bool surrogate = code >= 0xd800 && code < 0xe000;
        return code >= forms[length - 1].least && code < 0x110000 && !surrogate ? length : 0;
    }
    return 0;
}

/* Names may be any bytes; cairo refuses what is not UTF-8, so other bytes become a question
 * mark. */
static void clean(const char *text, char out[static LONGEST_TEXT])
{
    size_t length = 0;
    while (*text && length + 8 < LONGEST_TEXT) {
        const int letter = letter_length((const unsigned char *)text);
        for (int i = 0; i < letter; i++)
            out[length++] = *text++;
        if (letter == 0) {
            out[length++] = '?';
            text++;
        }
    }
    strcpy(out + length, *text ? "..." : "");
}

static void set_font(bat_canvas *canvas, double size, cairo_font_weight_t weight)
{
    cairo_select_font_face(canvas->cairo, "sans", CAIRO_FONT_SLANT_NORMAL, weight);
    cairo_set_font_size(canvas->cairo, size);
}

static double advance(bat_canvas *canvas, const char *text)
{
    char letters[LONGEST_TEXT];
    clean(text, letters);
    cairo_text_extents_t extents;
    cairo_text_extents(canvas->cairo, letters, &extents);
    return extents.x_advance;
}

double bat_canvas_text_width(bat_canvas *canvas, double size, const char *text)
{
    set_font(canvas, size, CAIRO_FONT_WEIGHT_NORMAL);
    return advance(canvas, text);
}

static void show_text(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                      double x, double y, const char *text)
{
    char letters[LONGEST_TEXT];
    clean(text, letters);
    const double wide = advance(canvas, text), left = x - 0.5 * (double)anchor * wide;
    /* Figures and capitals of a sans face are about 0.72 em high. */
    set_colour(canvas, colour, 1);
    cairo_move_to(canvas->cairo, left, y + 0.36 * size);
    cairo_show_text(canvas->cairo, letters);
    cairo_new_path(canvas->cairo);
    if (canvas->dxf)
        bat_dxf_sheet_text(canvas->dxf, &(bat_dxf_letters){size, x, y, (int)anchor, letters});
}

void bat_canvas_take(bat_canvas *canvas, bat_rectangle place)
{
    if (BAT_LIST_ADD(canvas->taken, canvas->taken_count, canvas->taken_capacity, place) !=
        BATTEN_OK)
        canvas->status = BATTEN_OUT_OF_MEMORY;
}

/* Names keep away from this text. */
static void take_text(bat_canvas *canvas, double size, bat_anchor anchor, double x, double y,
                      const char *text)
{
    const double wide = advance(canvas, text);
    if (*text)
        bat_canvas_take(canvas, (bat_rectangle){x - 0.5 * (double)anchor * wide, y - 0.5 * size,
                                                wide, size});
}

void bat_canvas_text(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                     double x, double y, const char *text)
{
    set_font(canvas, size, CAIRO_FONT_WEIGHT_NORMAL);
    show_text(canvas, colour, size, anchor, x, y, text);
    take_text(canvas, size, anchor, x, y, text);
}

void bat_canvas_bold(bat_canvas *canvas, bat_colour colour, double size, bat_anchor anchor,
                     double x, double y, const char *text)
{
    set_font(canvas, size, CAIRO_FONT_WEIGHT_BOLD);
    show_text(canvas, colour, size, anchor, x, y, text);
    take_text(canvas, size, anchor, x, y, text);
}

void bat_canvas_text_up(bat_canvas *canvas, bat_colour colour, double size, double x, double y,
                        const char *text)
{
    cairo_save(canvas->cairo);
    cairo_translate(canvas->cairo, x, y);
    cairo_rotate(canvas->cairo, -0.5 * BAT_PI);
    set_font(canvas, size, CAIRO_FONT_WEIGHT_NORMAL);
    show_text(canvas, colour, size, BAT_MIDDLE, 0, 0, text);
    cairo_restore(canvas->cairo);
}
