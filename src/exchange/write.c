#include "exchange/csv/csv.h"
#include "exchange/dxf/dxf.h"
#include "exchange/gcode/gcode.h"
#include "exchange/iges/iges.h"
#include "exchange/step/step.h"
#include "exchange/svg/svg.h"

batten_write_options batten_write_defaults(void)
{
    return (batten_write_options){.size = sizeof(batten_write_options),
                                  .format = BATTEN_FORMAT_AUTO,
                                  .name = "batten",
                                  .tolerance = 0,
                                  .date = NULL,
                                  .mesh = batten_mesh_defaults()};
}

/* Is there something that the format holds? An empty model makes an empty file. */
static batten_status check_shapes(const batten_model *model, batten_format format)
{
    const int count = batten_model_count(model);
    for (int i = 0; i < count; i++) {
        const batten_object_kind kind = batten_model_object(model, i)->kind;
        if (kind == BATTEN_OBJECT_CURVE || kind == BATTEN_OBJECT_SURFACE ||
            kind == BATTEN_OBJECT_TRIANGLES ||
            (kind == BATTEN_OBJECT_POINTS && format == BATTEN_FORMAT_STEP))
            return BATTEN_OK;
    }
    if (count == 0)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_UNSUPPORTED, "%s, and of the %d object%s ('%.60s' first) none is such",
        format == BATTEN_FORMAT_IGES ? "IGES files hold curves and surfaces"
                                     : "STEP files hold points, curves and surfaces",
        count, count == 1 ? "" : "s", batten_model_object(model, 0)->name);
}

/* In files of NURBS, triangles are patches. */
static batten_status write_patches(const batten_model *model,
                                   const batten_write_options *options, batten_notes *notes,
                                   batten_text *text)
{
    batten_model *patches = NULL;
    batten_status status = check_shapes(model, options->format);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(model, BATTEN_PATCHES_REGULAR, &patches);
    if (status == BATTEN_OK)
        status = options->format == BATTEN_FORMAT_IGES
                     ? bat_write_iges(patches, options, notes, text)
                     : bat_write_step(patches, options, notes, text);
    batten_model_unref(patches);
    return status;
}

static batten_status write_as(const batten_model *model, const batten_write_options *options,
                              batten_notes *notes, batten_text *text)
{
    switch (options->format) {
    case BATTEN_FORMAT_OFFSETS:
        return bat_write_offsets(model, notes, text);
    case BATTEN_FORMAT_POINTS:
        return bat_write_points(model, notes, text);
    case BATTEN_FORMAT_AEROFOIL:
        return bat_write_aerofoil(model, notes, text);
    case BATTEN_FORMAT_IGES:
    case BATTEN_FORMAT_STEP:
        return write_patches(model, options, notes, text);
    case BATTEN_FORMAT_DXF:
        return bat_write_dxf(model, notes, text);
    case BATTEN_FORMAT_SVG:
        return bat_write_svg(model, options, notes, text);
    case BATTEN_FORMAT_GCODE:
        return bat_write_gcode(model, NULL, notes, text);
    case BATTEN_FORMAT_G2:
    case BATTEN_FORMAT_OBJ:
    case BATTEN_FORMAT_STL:
    case BATTEN_FORMAT_PLY:
    case BATTEN_FORMAT_GLTF:
    case BATTEN_FORMAT_3MF:
    case BATTEN_FORMAT_PCD:
    case BATTEN_FORMAT_FTM:
        return bat_fail(BATTEN_UNSUPPORTED, "%s files cannot be written",
                        batten_format_name(options->format));
    case BATTEN_FORMAT_AUTO:
        break;
    }
    return bat_fail(BATTEN_BAD_ARGUMENT, "no format is named to write in");
}

batten_status batten_write_memory(const batten_model *model,
                                  const batten_write_options *options, batten_notes *notes,
                                  char **data, size_t *size)
{
    batten_write_options chosen = options ? *options : batten_write_defaults();
    batten_text text = BATTEN_TEXT;
    if (!chosen.name || !chosen.name[0])
        chosen.name = "batten";
    if (!(chosen.tolerance >= 0 && isfinite(chosen.tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", chosen.tolerance);
    batten_status status = write_as(model, &chosen, notes, &text);
    if (status == BATTEN_OK)
        status = batten_text_take(&text, data, size);
    batten_text_free(&text);
    return status;
}

static bool has_offsets(const batten_model *model)
{
    for (int i = 0; i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == BATTEN_OBJECT_OFFSETS)
            return true;
    return false;
}

batten_status batten_write_file(const batten_model *model, const char *path,
                                const batten_write_options *options, batten_notes *notes)
{
    batten_write_options chosen = options ? *options : batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    if (chosen.format == BATTEN_FORMAT_AUTO) {
        chosen.format = batten_format_of_name(path);
        if (chosen.format == BATTEN_FORMAT_OFFSETS && !has_offsets(model))
            chosen.format = BATTEN_FORMAT_POINTS;
    }
    if (chosen.format == BATTEN_FORMAT_AUTO)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the ending of '%s' names no format that is written", path);
    batten_status status = batten_write_memory(model, &chosen, notes, &data, &size);
    if (status == BATTEN_OK)
        status = batten_save_file(path, data, size);
    batten_release(data);
    return status;
}
