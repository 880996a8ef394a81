/* The formats of files as the command line names them, and their part of the manual. */
#include "formats.h"

#include <string.h>

/* What comes through, by format. */
static const char *const kept[] = {
    [BATTEN_FORMAT_OFFSET_TABLE] =
        "tables of offsets, with the names of stations and lines, no unit",
    [BATTEN_FORMAT_POINTS] =
        "points in rows; of curves those they were made from, of tables those of "
        "the stations",
    [BATTEN_FORMAT_AEROFOIL] = "one row of points x, y, and a name",
    [BATTEN_FORMAT_IGES] = "curves, surfaces, bodies (written face by face); names, colours, "
                           "levels, groups, what is hidden, unit",
    [BATTEN_FORMAT_STEP] =
        "curves, surfaces, faces, shells, solids, assemblies; names, colours, "
        "layers, groups, what is hidden, unit; meshes in AP242",
    [BATTEN_FORMAT_DXF] = "lines, polylines, arcs, ellipses, splines; layers, colours, what is "
                          "hidden, unit; "
                          "blocks are read where they are inserted",
    [BATTEN_FORMAT_SVG] =
        "curves as seen along z, at true scale; text and pictures are not read",
    [BATTEN_FORMAT_GCODE] = "chains of lines and arcs as paths of a tool",
    [BATTEN_FORMAT_G2] = "curves, surfaces and trimmed faces; colours, no names, no unit",
    [BATTEN_FORMAT_OBJ] = "meshes with normals, free-form curves and surfaces; names, no unit",
    [BATTEN_FORMAT_STL] = "triangles alone, no unit; binary numbers have 7 digits",
    [BATTEN_FORMAT_PLY] =
        "a mesh with normals, values, colours of vertices and faces, or points; no unit",
    [BATTEN_FORMAT_GLTF] = "meshes with normals and colours, also of faces, assemblies; metres",
    [BATTEN_FORMAT_3MF] = "meshes with colours, also of faces, assemblies; unit",
    [BATTEN_FORMAT_PCD] = "points, their coordinates",
    [BATTEN_FORMAT_FTM] = "the control net of a hull",
    [BATTEN_FORMAT_OFF] = "a mesh, with colours of vertices; no unit",
};

/* As many as there is room for, each with a blank after it. */
static void join_endings(const batten_format_facts *f, char endings[80])
{
    size_t used = 0;
    for (int k = 0; k < 4 && f->endings[k]; k++) {
        const size_t length = strlen(f->endings[k]);
        if (used + length + 2 > 80)
            break;
        memcpy(endings + used, f->endings[k], length);
        endings[used + length] = ' ';
        used += length + 1;
        endings[used] = 0;
    }
}

static void add_row(batten_text *text, const batten_format_facts *f)
{
    char endings[80] = "";
    join_endings(f, endings);
    const size_t index = (size_t)f->format;
    batten_text_add(text, "  %-9s %-24s %-4s %-5s  %s\n", f->name, endings,
                    f->is_read ? "yes" : "-", f->is_written ? "yes" : "-",
                    index < sizeof kept / sizeof kept[0] && kept[index] ? kept[index] : "");
}

void formats_manual(batten_text *text)
{
    batten_format_facts facts;
    batten_text_add(text, "Formats of files:\n\n  %-9s %-24s %-4s %-5s  %s\n", "name",
                    "endings", "read", "write", "what is kept");
    for (int k = BATTEN_FORMAT_AUTO + 1; batten_format_about((batten_format)k, &facts); k++)
        if (facts.is_read || facts.is_written)
            add_row(text, &facts);
    batten_text_add(
        text,
        "\n"
        "When reading, the content decides, or --from-format (in a design 'format' of 'read')\n"
        "where it does not tell. When writing, the ending decides, or --format.\n\n"
        "Shapes become triangles in STL, PLY, glTF and 3MF, and bodies in OBJ, which keeps\n"
        "free-form curves and surfaces, within --chord and --angle. What a format cannot hold is\n"
        "left out and reported. A file that is damaged in part is read in part: what was left out\n"
        "is reported, and the exit status is 3. A format without a unit takes the numbers as they\n"
        "are: --from-unit says what they mean.\n\n"
        "Pictures are .svg, .pdf and .png of the commands and outputs that draw.\n");
}

bool formats_option(const char *of, const arguments *given, const char *name,
                    batten_format *format)
{
    const char *word = arguments_get(given, name);
    batten_format_facts facts;
    *format = BATTEN_FORMAT_AUTO;
    if (!word)
        return true;
    const char *names[64];
    int count = 0;
    for (int k = 0; batten_format_about((batten_format)k, &facts) && count < 64; k++) {
        names[count++] = facts.name;
        if (strcmp(facts.name, word) == 0) {
            *format = facts.format;
            return true;
        }
    }
    const char *near = nearest_name(word, count, names);
    complain("batten %s: --%s: there is no format '%s'%s%s%s; see 'batten help formats'", of,
             name, word, near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
    return false;
}
