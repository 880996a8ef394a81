#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"write", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is written"},
    {"format", BATTEN_VALUE_WORD, false, false, "auto",
     "auto offsets points aerofoil iges step dxf svg g-code",
     "by the ending of the file by default"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "the name of the product"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the accuracy that the file states; the tolerance of the design by default"},
};

static batten_status run(bat_run *run)
{
    batten_write_options options = batten_write_defaults();
    batten_model *model = NULL;
    options.format = (batten_format)bat_word(run, "format");
    if (options.format == BATTEN_FORMAT_AUTO)
        options.format = batten_format_of_name(run->name);
    if (options.format == BATTEN_FORMAT_AUTO)
        return bat_fail(BATTEN_UNSUPPORTED, "the ending of '%s' names no format; add 'format'",
                        run->name);
    if (bat_has(run, "title"))
        options.name = bat_text(run, "title");
    options.tolerance = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = bat_merge(run, "write", &model);
    if (status == BATTEN_OK)
        status = batten_write_memory(model, &options, run->notes, &run->data, &run->size);
    batten_model_unref(model);
    return status;
}

const bat_feature bat_feature_write = {
    .shown =
        {"write", "A file for other programs",
         "The ending names the format: .step and .stp, .igs and .iges, .csv for tables "
         "and points,\n"
         ".dxf with arcs as bulges, .svg at true scale for cutting, .nc for G-code with the "
         "usual settings\n"
         "('g-code' has the others).\n"
         "'hull.step: hull' is short for 'hull.step: {write: hull}'. Not so of .svg, .pdf and "
         ".png: there\n"
         "'plan.svg: plan' is a page with a picture, and '{write: plan}' the drawing at true "
         "scale.",
         "features:\n"
         "  ducks: {points: [[0, 0, 0], [1 m, 20 cm, 0], [2 m, 30 cm, 0]]}\n"
         "outputs:\n"
         "  ducks.xyz: {write: ducks}\n",
         "", "batten_write_memory", BAT_PARAMETERS(parameters), true},
    .run = run};
