/* The sheet of an SVG drawing: its size, unit and view box. */
#include "exchange/svg/sheet.h"
#include "exchange/reading/scan.h"
#include "exchange/svg/shapes.h"
#include "exchange/svg/xml.h"
#include <stdio.h>
#include <string.h>

/* ---- the sheet ---- */

bool bat_svg_says(bat_span text, const char *word)
{
    return text.length == strlen(word) && memcmp(text.bytes, word, text.length) == 0;
}

/* A length in millimetres; 0 for none. */
static double length_of(const bat_xml *xml, const char *name)
{
    bat_span text;
    size_t at = 0;
    double value = 0, length = 0;
    char shown[BAT_SHOWN_SIZE];
    if (!bat_xml_attribute(xml, name, &text))
        return 0;
    if (bat_svg_real(xml->input, xml->line, text, &at, &value))
        length = value * bat_svg_unit((bat_span){text.bytes + at, text.length - at});
    const bool is_share = at < text.length && text.bytes[at] == '%';
    if (!(length > 0) && !is_share && !bat_svg_says(text, "auto"))
        batten_notes_add(xml->input->notes, xml->input->file, xml->line, "svg",
                         "its %s is '%.40s', which is not a length for a sheet", name,
                         bat_shown(text.bytes, text.length, shown));
    return length;
}

/* How the numbers of the drawing fit on a sheet of another shape. */
typedef struct {
    double x, y; /* the share of the room that is left to the left, and above */
    bool stretched, covers;
} fit;

/* The next word, past blanks. */
static bat_span word_of(bat_span text, size_t *at)
{
    while (*at < text.length && bat_is_white(text.bytes[*at]))
        ++*at;
    const size_t begin = *at;
    while (*at < text.length && !bat_is_white(text.bytes[*at]))
        ++*at;
    return (bat_span){text.bytes + begin, *at - begin};
}

/* "none", or "xMidYMax", and "meet" or "slice"; in the middle and whole when nothing is said.
 */
static fit fit_of(const bat_xml *xml)
{
    static const char *const places[] = {"Min", "Mid", "Max"};
    const fit usual = {0.5, 0.5, false, false};
    fit of = usual;
    bat_span text;
    size_t at = 0;
    char shown[BAT_SHOWN_SIZE], name[16];
    if (!bat_xml_attribute(xml, "preserveAspectRatio", &text))
        return usual;
    bat_span word = word_of(text, &at);
    of.stretched = bat_svg_says(word, "none");
    bool is_known = of.stretched;
    for (int k = 0; k < 9 && !is_known; k++) {
        snprintf(name, sizeof name, "x%sY%s", places[k % 3], places[k / 3]);
        is_known = bat_svg_says(word, name);
        of.x = (k % 3) / 2.0;
        const int row = k / 3;
        of.y = row / 2.0;
    }
    word = word_of(text, &at);
    of.covers = bat_svg_says(word, "slice");
    is_known = is_known && (of.covers || word.length == 0 || bat_svg_says(word, "meet"));
    if (is_known && word_of(text, &at).length == 0)
        return of;
    batten_notes_add(xml->input->notes, xml->input->file, xml->line, "svg",
                     "preserveAspectRatio '%.40s' is not understood: the drawing stands in the "
                     "middle, as large as fits",
                     bat_shown(text.bytes, text.length, shown));
    return usual;
}

static void note_box(const bat_xml *xml, bat_span text)
{
    char shown[BAT_SHOWN_SIZE];
    batten_notes_add(xml->input->notes, xml->input->file, xml->line, "svg",
                     "the viewBox '%.40s' is not of four numbers, the last two above 0; the "
                     "width and height stand for it",
                     bat_shown(text.bytes, text.length, shown));
}

static bool read_box(const bat_xml *xml, double box[4])
{
    bat_span text = {"", 0};
    size_t at = 0;
    int count = 0;
    if (bat_xml_attribute(xml, "viewBox", &text))
        while (count < 4 && bat_svg_number(text, &at, &box[count]))
            count++;
    const bool is_good = count == 4 && box[2] > 0 && box[3] > 0;
    if (text.length > 0 && !is_good)
        note_box(xml, text);
    return is_good;
}

/* The box of a drawing that has none, by its width and height. */
static void make_box(double width, double height, double box[4])
{
    box[0] = box[1] = 0;
    box[2] = width > 0 ? width / BAT_SVG_PIXEL : 1;
    box[3] = height > 0 ? height / BAT_SVG_PIXEL : 0;
}

bat_svg_map bat_svg_sheet_of(const bat_xml *xml)
{
    double width = length_of(xml, "width"), height = length_of(xml, "height");
    double box[4] = {0, 0, 0, 0};
    if (!read_box(xml, box))
        make_box(width, height, box);
    if (!(width > 0))
        width = height > 0 ? height * box[2] / box[3] : box[2] * BAT_SVG_PIXEL;
    double along = width / box[2], up = height > 0 ? height / box[3] : along;
    const fit of = fit_of(xml);
    if (!of.stretched)
        along = up = of.covers ? bat_max(along, up) : bat_min(along, up);
    if (!(height > 0))
        height = up * box[3];
    const double left = of.x * (width - along * box[2]);
    const double above = of.y * (height - up * box[3]);
    return (bat_svg_map){
        .a = along, .d = -up, .e = left - along * box[0], .f = height - above + up * box[1]};
}
