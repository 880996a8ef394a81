#include "exchange/csv/csv.h"
#include "exchange/iges/iges.h"
#include "exchange/recognise.h"

#include <string.h>

/* The formats, their names, and the endings of their files. */
static const struct {
    batten_format format;
    const char *name;
    const char *endings[4];
    batten_status (*read)(bat_input *input, batten_model **out);
} formats[] = {
    {BATTEN_FORMAT_AUTO, "auto", {NULL}, NULL},
    {BATTEN_FORMAT_OFFSETS, "offsets", {".csv", ".tsv", ".txt"}, bat_read_offsets},
    {BATTEN_FORMAT_POINTS, "points", {".xyz"}, bat_read_points},
    {BATTEN_FORMAT_AEROFOIL, "aerofoil", {".dat"}, bat_read_aerofoil},
    {BATTEN_FORMAT_IGES, "iges", {".igs", ".iges"}, bat_read_iges},
    {BATTEN_FORMAT_STEP, "step", {".stp", ".step"}, NULL},
    {BATTEN_FORMAT_DXF, "dxf", {".dxf"}, NULL},
    {BATTEN_FORMAT_SVG, "svg", {".svg"}, NULL},
    {BATTEN_FORMAT_GCODE, "g-code", {".nc", ".ngc", ".gcode", ".tap"}, NULL},
    {BATTEN_FORMAT_G2, "g2", {".g2"}, NULL},
    {BATTEN_FORMAT_OBJ, "obj", {".obj"}, NULL},
    {BATTEN_FORMAT_STL, "stl", {".stl"}, NULL},
    {BATTEN_FORMAT_PLY, "ply", {".ply"}, NULL},
    {BATTEN_FORMAT_GLTF, "gltf", {".glb"}, NULL},
    {BATTEN_FORMAT_3MF, "3mf", {".3mf"}, NULL},
    {BATTEN_FORMAT_PCD, "pcd", {".pcd"}, NULL},
    {BATTEN_FORMAT_FTM, "ftm", {".ftm"}, NULL},
};
#define FORMATS (sizeof formats / sizeof formats[0])

const char *batten_format_name(batten_format format)
{
    return (size_t)format < FORMATS ? formats[format].name : "?";
}

batten_format batten_format_of_name(const char *path)
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

static batten_status read_as(bat_input *input, batten_format format, batten_model **out)
{
    batten_model *model = NULL;
    if ((size_t)format >= FORMATS || !formats[format].read)
        return bat_input_fail(input, BATTEN_UNSUPPORTED, 0, "%s files cannot be read",
                              batten_format_name(format));
    batten_status status = bat_input_as_text(input);
    if (status == BATTEN_OK)
        status = formats[format].read(input, &model);
    if (status != BATTEN_OK)
        return status;
    *out = model;
    if (input->is_cut)
        return bat_input_fail(
            input, BATTEN_PARTLY_READ, 0,
            "the end of the file is missing; %d entities are read, %d left out",
            batten_model_count(model), input->left_out);
    if (input->left_out == 0)
        return BATTEN_OK;
    return bat_input_fail(input, BATTEN_PARTLY_READ, 0, "%d of %d entities are left out",
                          input->left_out, input->left_out + batten_model_count(model));
}

batten_status batten_read_memory(const char *data, size_t size,
                                 const batten_read_options *options, const batten_job *job,
                                 batten_notes *notes, batten_model **out)
{
    bat_input input;
    batten_format format = options ? options->format : BATTEN_FORMAT_AUTO;
    batten_status status = bat_input_begin(data, size, options, job, notes, &input);
    if (status == BATTEN_OK && format == BATTEN_FORMAT_AUTO)
        status = bat_recognise(&input, &format);
    return status == BATTEN_OK ? read_as(&input, format, out) : status;
}

batten_status batten_read_file(const char *path, const batten_read_options *options,
                               const batten_job *job, batten_notes *notes, batten_model **out)
{
    batten_read_options named = options ? *options : batten_read_defaults();
    const batten_limits limits = named.limits ? *named.limits : batten_limits_defaults();
    char *data = NULL;
    size_t size = 0;
    if (!named.file_name || !named.file_name[0])
        named.file_name = path;
    batten_status status = batten_load_file(path, limits.file_bytes, &data, &size);
    if (status == BATTEN_OK)
        status = batten_read_memory(data, size, &named, job, notes, out);
    batten_release(data);
    return status;
}
