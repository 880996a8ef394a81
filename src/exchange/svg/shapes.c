/* Reads rectangles, circles, ellipses, lines, polygons and paths. */
#include "exchange/svg/shapes.h"
#include "base/plural.h"
#include "exchange/reading/scan.h"

#include <string.h>

static const struct {
    const char *unit;
    double millimetres;
} units[] = {{"mm", 1},        {"cm", 10},        {"in", 25.4}, {"pt", 25.4 / 72},
             {"pc", 25.4 / 6}, {"px", 25.4 / 96}, {"q", 0.25},  {"", 25.4 / 96}};

double bat_svg_unit(bat_span text)
{
    while (text.length > 0 && bat_is_white(text.bytes[text.length - 1]))
        text.length--;
    for (size_t k = 0; k < sizeof units / sizeof units[0]; k++)
        if (bat_word_is(text, units[k].unit))
            return units[k].millimetres;
    return 0;
}

/* Lengths of attributes in the numbers of the drawing; 0 when they are missing. */
static batten_status numbers_of(const bat_xml *xml, int count, const char *const *names,
                                double *values)
{
    for (int k = 0; k < count; k++) {
        bat_span text;
        size_t at = 0;
        values[k] = 0;
        if (!bat_xml_attribute(xml, names[k], &text))
            continue;
        const double unit = bat_svg_real(xml->input, xml->line, text, &at, &values[k])
                                ? bat_svg_unit((bat_span){text.bytes + at, text.length - at})
                                : 0;
        char shown[BAT_SHOWN_SIZE];
        if (unit == 0)
            return bat_fail(BATTEN_BAD_FORMAT, "its %s is '%.40s', which is not a length",
                            names[k], bat_shown(text.bytes, text.length, shown));
        if (unit != BAT_SVG_PIXEL)
            values[k] *= unit / BAT_SVG_PIXEL;
    }
    return BATTEN_OK;
}

static batten_status read_ellipse(const bat_xml *xml, const char *const names[4],
                                  bat_svg_row *row)
{
    double v[4] = {0};
    batten_status status = numbers_of(xml, 4, names, v);
    const double x = v[0], y = v[1], rx = v[2], ry = v[3];
    if (status == BATTEN_OK && !(rx > 0 && ry > 0))
        status = bat_fail(BATTEN_BAD_FORMAT, "its half axes are %g and %g", rx, ry);
    if (status == BATTEN_OK)
        status = bat_svg_move(row, x + rx, y);
    if (status == BATTEN_OK)
        status = bat_svg_arc(row, rx, ry, 0, false, true, x - rx, y);
    if (status == BATTEN_OK)
        status = bat_svg_arc(row, rx, ry, 0, false, true, x + rx, y);
    return status;
}

static batten_status read_rectangle(const bat_xml *xml, bat_svg_row *row)
{
    static const char *const names[6] = {"x", "y", "width", "height", "rx", "ry"};
    double v[6] = {0};
    batten_status status = numbers_of(xml, 6, names, v);
    const double x = v[0], y = v[1], w = v[2], h = v[3];
    if (status == BATTEN_OK && !(w > 0 && h > 0))
        status = bat_fail(BATTEN_BAD_FORMAT, "it is %g wide and %g high", w, h);
    /* One radius is also that of the other axis. */
    const double rx = bat_min(v[4] > 0 ? v[4] : v[5], w / 2);
    const double ry = bat_min(v[5] > 0 ? v[5] : v[4], h / 2);
    /* Clockwise from the upper left: each side, then the corner, which may be round. */
    const double sides[4][2] = {
        {x + w - rx, y}, {x + w, y + h - ry}, {x + rx, y + h}, {x, y + ry}};
    const double corners[4][2] = {
        {x + w, y + ry}, {x + w - rx, y + h}, {x, y + h - ry}, {x + rx, y}};
    if (status == BATTEN_OK)
        status = bat_svg_move(row, x + rx, y);
    for (int k = 0; status == BATTEN_OK && k < 4; k++) {
        status = bat_svg_line(row, sides[k][0], sides[k][1]);
        if (status == BATTEN_OK)
            status = bat_svg_arc(row, rx, ry, 0, false, true, corners[k][0], corners[k][1]);
    }
    return status;
}

static batten_status read_polyline(bat_span text, bool closed, bat_svg_row *row,
                                   bat_svg_take *take, void *context)
{
    size_t at = 0, good = 0; /* behind the last point */
    double p[2], start[2] = {0, 0};
    int count = 0;
    batten_status status = BATTEN_OK;
    row->points.count = 0;
    while (status == BATTEN_OK && bat_svg_real(row->input, row->line, text, &at, &p[0]) &&
           bat_svg_real(row->input, row->line, text, &at, &p[1])) {
        good = at;
        if (count++ == 0) {
            memcpy(start, p, sizeof p);
            status = bat_svg_move(row, p[0], p[1]);
        } else {
            status = bat_svg_line(row, p[0], p[1]);
        }
    }
    if (status == BATTEN_OK && count < 2)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d point%s", count, bat_plural(count));
    if (status == BATTEN_OK && closed)
        status = bat_svg_line(row, start[0], start[1]);
    if (status == BATTEN_OK)
        status = take(context, row);
    if (status == BATTEN_OK && bat_svg_past_separators(text, good) < text.length)
        status = bat_fail(BATTEN_BAD_FORMAT, "its points are broken after the first %d", count);
    return status;
}

static batten_status read_line(const bat_xml *xml, bat_svg_row *row)
{
    static const char *const names[4] = {"x1", "y1", "x2", "y2"};
    double v[4] = {0};
    batten_status status = numbers_of(xml, 4, names, v);
    if (status == BATTEN_OK)
        status = bat_svg_move(row, v[0], v[1]);
    if (status == BATTEN_OK)
        status = bat_svg_line(row, v[2], v[3]);
    return status;
}

bool bat_svg_is_shape(const bat_xml *xml)
{
    static const char *const shapes[] = {"path",    "line",     "rect",   "circle",
                                         "ellipse", "polyline", "polygon"};
    for (size_t k = 0; k < sizeof shapes / sizeof shapes[0]; k++)
        if (bat_xml_is(xml, shapes[k]))
            return true;
    return false;
}

static batten_status read_closed_form(const bat_xml *xml, bat_svg_row *row)
{
    static const char *const circle[4] = {"cx", "cy", "r", "r"};
    static const char *const ellipse[4] = {"cx", "cy", "rx", "ry"};
    if (bat_xml_is(xml, "line"))
        return read_line(xml, row);
    if (bat_xml_is(xml, "rect"))
        return read_rectangle(xml, row);
    return read_ellipse(xml, bat_xml_is(xml, "circle") ? circle : ellipse, row);
}

static bat_span text_of(const bat_xml *xml, const char *name)
{
    bat_span text = {"", 0};
    (void)bat_xml_attribute(xml, name, &text);
    return text;
}

batten_status bat_svg_shape(const bat_xml *xml, bat_svg_row *row, bat_svg_take *take,
                            void *context)
{
    const bool is_polygon = bat_xml_is(xml, "polygon");
    row->line = xml->line;
    if (bat_xml_is(xml, "path"))
        return bat_svg_path(text_of(xml, "d"), row, take, context);
    if (bat_xml_is(xml, "polyline") || is_polygon)
        return read_polyline(text_of(xml, "points"), is_polygon, row, take, context);
    const batten_status status = read_closed_form(xml, row);
    return status == BATTEN_OK ? take(context, row) : status;
}
