/* The one table of formats, and how formats are found by name and file ending. */
#include "exchange/formats.h"
#include "exchange/3mf/3mf.h"
#include "exchange/csv/csv.h"
#include "exchange/dxf/dxf.h"
#include "exchange/ftm/ftm.h"
#include "exchange/g2/g2.h"
#include "exchange/gcode/gcode.h"
#include "exchange/gltf/gltf.h"
#include "exchange/iges/iges.h"
#include "exchange/obj/obj.h"
#include "exchange/off/off.h"
#include "exchange/pcd/pcd.h"
#include "exchange/ply/ply.h"
#include "exchange/reading/scan.h"
#include "exchange/step/step.h"
#include "exchange/stl/stl.h"
#include "exchange/svg/svg.h"

#include <string.h>

static batten_status write_gcode(const batten_model *model, const batten_write_options *options,
                                 batten_notes *notes, batten_text *text)
{
    (void)options;
    return bat_write_gcode(model, NULL, notes, text, NULL);
}

static size_t past_comment(const bat_input *input, size_t at)
{
    at += 2;
    while (at < input->size && !bat_begins(input, at, "*/"))
        at++;
    at += 2;
    while (at < input->size && (bat_is_blank(input->data[at]) || input->data[at] == '\n' ||
                                input->data[at] == '\r'))
        at++;
    return at;
}

static batten_status recognise_step(const bat_input *input, bool *is_such)
{
    size_t at = bat_past_white(input);
    /* Some put a comment before it. */
    while (bat_begins(input, at, "/*"))
        at = past_comment(input, at);
    *is_such = at < input->size && bat_begins(input, at, "ISO-10303-21;");
    return BATTEN_OK;
}

/* In the order of batten_format. */
static const bat_format_row formats[] = {
    {.format = BATTEN_FORMAT_AUTO, .name = "auto", .title = "auto"},

    {.format = BATTEN_FORMAT_OFFSET_TABLE,
     .name = "offsets",
     .title = "offsets",
     .endings = {".csv", ".tsv", ".txt"},
     .read = bat_read_offsets,
     .write = bat_write_offsets},

    {.format = BATTEN_FORMAT_POINTS,
     .name = "points",
     .title = "points",
     .endings = {".xyz"},
     .read = bat_read_points,
     .write = bat_write_points},

    {.format = BATTEN_FORMAT_AEROFOIL,
     .name = "aerofoil",
     .title = "aerofoil",
     .endings = {".dat"},
     .read = bat_read_aerofoil,
     .write = bat_write_aerofoil},

    {.format = BATTEN_FORMAT_IGES,
     .name = "iges",
     .title = "IGES",
     .endings = {".igs", ".iges"},
     .recognise = bat_iges_recognise,
     .read = bat_read_iges,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE) | BAT_HOLDS(SURFACE) | BAT_HOLDS(BODY) |
              BAT_HOLDS(INSTANCE),
     .can_place = bat_iges_can_place,
     .paints = true,
     .says = BAT_SAYS_ALL,
     .write = bat_write_iges},

    {.format = BATTEN_FORMAT_STEP,
     .name = "step",
     .title = "STEP",
     .endings = {".stp", ".step"},
     .recognise = recognise_step,
     .read = bat_read_step,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE) | BAT_HOLDS(SURFACE) | BAT_HOLDS(BODY) |
              BAT_HOLDS(MESH) | BAT_HOLDS(INSTANCE),
     .can_place = bat_step_can_place,
     .paints = true,
     .says = BAT_SAYS_ALL,
     .lesser = BAT_HOLDS(INSTANCE),
     .lacks = BAT_SAYS_ALL & ~BAT_SAYS_NAMES,
     .write = bat_write_step},

    {.format = BATTEN_FORMAT_DXF,
     .name = "dxf",
     .title = "DXF",
     .endings = {".dxf"},
     .recognise = bat_dxf_recognise,
     .read = bat_read_dxf,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE),
     .says = BAT_SAYS_LAYERS | BAT_SAYS_COLOURS | BAT_SAYS_HIDDEN,
     .names_layers = true,
     .write = bat_write_dxf},

    {.format = BATTEN_FORMAT_SVG,
     .name = "svg",
     .title = "SVG",
     .endings = {".svg"},
     .recognise = bat_svg_recognise,
     .read = bat_read_svg,
     .holds = BAT_HOLDS(CURVE),
     .says = BAT_SAYS_NAMES | BAT_SAYS_LAYERS | BAT_SAYS_COLOURS | BAT_SAYS_HIDDEN,
     .write = bat_write_svg},

    {.format = BATTEN_FORMAT_GCODE,
     .name = "g-code",
     .title = "G-code",
     .endings = {".nc", ".ngc", ".gcode", ".tap"},
     .write = write_gcode},

    {.format = BATTEN_FORMAT_G2,
     .name = "g2",
     .title = "G2",
     .endings = {".g2"},
     .recognise = bat_g2_recognise,
     .read = bat_read_g2,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE) | BAT_HOLDS(SURFACE) | BAT_HOLDS(BODY),
     .says = BAT_SAYS_COLOURS,
     .write = bat_write_g2},

    {.format = BATTEN_FORMAT_OBJ,
     .name = "obj",
     .title = "OBJ",
     .endings = {".obj"},
     .recognise = bat_obj_recognise,
     .read = bat_read_obj,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE) | BAT_HOLDS(SURFACE) | BAT_HOLDS(MESH),
     .keeps = BAT_KEEPS_COLOURS,
     .says = BAT_SAYS_NAMES | BAT_SAYS_COLOURS | BAT_SAYS_GROUPS,
     .lesser = BAT_HOLDS(POINTS) | BAT_HOLDS(CURVE) | BAT_HOLDS(SURFACE),
     .lacks = BAT_SAYS_COLOURS,
     .write = bat_write_obj},

    {.format = BATTEN_FORMAT_STL,
     .name = "stl",
     .title = "STL",
     .endings = {".stl"},
     .recognise = bat_stl_recognise,
     .is_binary = true,
     .read = bat_read_stl,
     .holds = BAT_HOLDS(MESH),
     .write = bat_write_stl},

    {.format = BATTEN_FORMAT_PLY,
     .name = "ply",
     .title = "PLY",
     .endings = {".ply"},
     .recognise = bat_ply_recognise,
     .is_binary = true,
     .read = bat_read_ply,
     .holds = BAT_HOLDS(POINTS) | BAT_HOLDS(MESH),
     .keeps = BAT_KEEPS_COLOURS | BAT_KEEPS_TRIANGLE_COLOURS | BAT_KEEPS_VALUES,
     .says = BAT_SAYS_COLOURS,
     .write = bat_write_ply},

    {.format = BATTEN_FORMAT_GLTF,
     .name = "gltf",
     .title = "glTF",
     .endings = {".glb"},
     .holds = BAT_HOLDS(MESH) | BAT_HOLDS(INSTANCE),
     .keeps = BAT_KEEPS_COLOURS | BAT_KEEPS_TRIANGLE_COLOURS,
     .says = BAT_SAYS_NAMES | BAT_SAYS_COLOURS,
     .write = bat_write_gltf},

    {.format = BATTEN_FORMAT_3MF,
     .name = "3mf",
     .title = "3MF",
     .endings = {".3mf"},
     .holds = BAT_HOLDS(MESH) | BAT_HOLDS(INSTANCE),
     .keeps = BAT_KEEPS_TRIANGLE_COLOURS,
     .says = BAT_SAYS_NAMES | BAT_SAYS_COLOURS,
     .write = bat_write_3mf},

    {.format = BATTEN_FORMAT_PCD,
     .name = "pcd",
     .title = "PCD",
     .endings = {".pcd"},
     .recognise = bat_pcd_recognise,
     .is_binary = true,
     .read = bat_read_pcd},

    {.format = BATTEN_FORMAT_FTM,
     .name = "ftm",
     .title = "FTM",
     .endings = {".ftm"},
     .recognise = bat_ftm_recognise,
     .read = bat_read_ftm},

    {.format = BATTEN_FORMAT_OFF,
     .name = "off",
     .title = "OFF",
     .endings = {".off"},
     .recognise = bat_off_recognise,
     .read = bat_read_off},
};
#define FORMATS (sizeof formats / sizeof formats[0])

const bat_format_row *bat_format_at(size_t index)
{
    return index < FORMATS ? &formats[index] : NULL;
}

const bat_format_row *bat_format_of(batten_format format)
{
    return bat_format_at((size_t)format);
}

const char *batten_format_name(batten_format format)
{
    const bat_format_row *row = bat_format_of(format);
    return row ? row->name : "?";
}

bool batten_format_about(batten_format format, batten_format_facts *out)
{
    const bat_format_row *row = bat_format_of(format);
    if (!row)
        return false;
    *out = (batten_format_facts){.format = format,
                                 .name = row->name,
                                 .title = row->title,
                                 .is_read = row->read != NULL,
                                 .is_written = row->write != NULL};
    memcpy(out->endings, row->endings, sizeof out->endings);
    return true;
}

batten_format batten_format_from_name(const char *path)
{
    const size_t length = strlen(path);
    for (size_t k = 0; k < FORMATS; k++)
        for (int i = 0; i < 4 && formats[k].endings[i]; i++) {
            const size_t end = strlen(formats[k].endings[i]);
            if (length > end && bat_same_word(path + length - end, formats[k].endings[i]))
                return formats[k].format;
        }
    return BATTEN_FORMAT_AUTO;
}
