/* The output 'write': a file for other programs. */
#include "design/feature.h"
#include "design/shared/formats.h"

static const batten_parameter parameters[] = {
    {"write", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is written"},
    {"format", BATTEN_VALUE_WORD, false, false, "auto", BAT_FORMAT_WORDS,
     "by the ending of the file by default"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL,
     "the name of the product in STEP and IGES"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the accuracy that the file states; the tolerance of the design by default"},
    {"schema", BATTEN_VALUE_WORD, false, false, "ap214", "ap214 ap203 ap242",
     "STEP: ap203 has no colours, meshes need ap242"},
    {"solids", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "IGES: bodies as solids and shells, which fewer programs read, not as faces one by one"},
    {"parameter-curves", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "STEP: faces with their edges in (u, v)"},
    {"chord", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "formats of meshes: how far triangles may be from the shape; else 'within', or 1/1000 of "
     "its size"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "20 deg", NULL,
     "formats of meshes: between the normals at the ends of an edge"},
    {"text", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "STL and PLY: the form that can be read"},
    {"eighths", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "tables of offsets: feet, inches and eighths"},
};

static void read_options(const bat_run *run, batten_write_options *options,
                         batten_mesh_options *mesh)
{
    if (bat_has(run, "title"))
        options->name = bat_text(run, "title");
    options->tolerance =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    options->schema = (batten_step_schema)bat_word(run, "schema");
    options->solids = bat_yes(run, "solids");
    options->no_parameter_curves = !bat_yes(run, "parameter-curves");
    /* What one asks of all shapes holds for meshes too, but not what designs are made with. */
    const char *bound = bat_has(run, "chord") ? "chord" : "within";
    mesh->chord = bat_has(run, bound) ? bat_number(run, bound) : 0;
    mesh->angle = bat_number(run, "angle");
    options->mesh = mesh;
    options->as_text = bat_yes(run, "text");
    options->eighths = bat_yes(run, "eighths");
}

static batten_status run_write(bat_run *run)
{
    batten_write_options options = batten_write_defaults();
    batten_mesh_options mesh = batten_mesh_defaults();
    batten_model *model = NULL;
    options.format = (batten_format)bat_word(run, "format");
    if (options.format == BATTEN_FORMAT_AUTO &&
        batten_format_from_name(run->name) == BATTEN_FORMAT_AUTO)
        return bat_fail(BATTEN_UNSUPPORTED, "the ending of '%s' names no format; add 'format'",
                        run->name);
    read_options(run, &options, &mesh);
    batten_status status = bat_merge(run, "write", BAT_ALL, &model);
    if (status == BATTEN_OK && batten_write_choose(run->name, model, &options))
        status = batten_write_memory(model, &options, run->notes, &run->data, &run->size);
    batten_model_unref(model);
    return status;
}

static bool is_any(const char *name)
{
    return *name != 0;
}

const bat_feature bat_feature_write = {
    .shown =
        {"write", "A file for other programs",
         "The ending names the format: .step and .stp, .igs and .iges, .g2; .stl, .obj, .ply for\n"
         "meshes, which shapes become within 'chord' and 'angle'; .csv for tables and points; .dxf\n"
         "with arcs as bulges, .svg as seen along z at true scale for cutting, .nc for G-code with\n"
         "the usual settings ('g-code' offers the others). 'batten help formats' lists all formats\n"
         "and what they keep. 'hull.step: hull' is short for 'hull.step: {write: hull}'. This is\n"
         "different for .svg, .pdf and .png: 'plan.svg: plan' is a page with a picture, and\n"
         "'{write: plan}' the drawing at true scale.",
         "features:\n"
         "  ducks: {points: [[0, 0, 0], [1 m, 20 cm, 0], [2 m, 30 cm, 0]]}\n"
         "outputs:\n"
         "  ducks.xyz: {write: ducks}\n",
         "", "batten_write_memory", BAT_PARAMETERS(parameters), true,
         .also = "export, save, STEP, IGES, DXF, STL, OBJ, SVG"},
    .run = run_write,
    .takes_file = is_any};
