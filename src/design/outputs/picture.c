/* The output 'picture': a drawing of curves, a shaded picture of surfaces, bodies, meshes. */
#include "design/shared/field.h"

typedef enum { SHADING_AUTO, SHADING_FIRST } shading_word;
typedef enum { CONTOURS_NONE, CONTOURS_FIRST } contours_word;

static const batten_parameter parameters[] = {
    {"picture", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "what is shown"},
    {"shading", BATTEN_VALUE_WORD, false, false, "auto",
     "auto plain isolines zebra gaussian mean isophotes",
     "of surfaces, in .png; auto is isolines"},
    {"view", BATTEN_VALUE_WORD, false, false, "auto",
     "auto top front side axonometric isometric", "the direction from which it is seen"},
    {"azimuth", BATTEN_VALUE_ANGLE, false, false, NULL, NULL,
     "of the eye, for the axonometric view"},
    {"elevation", BATTEN_VALUE_ANGLE, false, false, NULL, NULL,
     "of the eye, for the axonometric view"},
    {"comb", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "show the curvature of curves"},
    {"comb-scale", BATTEN_VALUE_NUMBER, false, false, "0", NULL,
     "length of its teeth; 0: chosen"},
    {"polygon", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "show the control polygons of curves"},
    {"points", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "show the points curves were made from"},
    {"isolines", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "in each direction of surfaces; 10, and with 'contours' none but the edges"},
    {"stripes", BATTEN_VALUE_NUMBER, false, false, "24", NULL, "of the zebra and of isophotes"},
    {"hidden", BATTEN_VALUE_WORD, false, false, "shown", "shown dashed dropped",
     "lines behind surfaces; for line drawings of surfaces, also as .png"},
    {"silhouettes", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "lines where surfaces turn away from the eye"},
    {"contours", BATTEN_VALUE_WORD, false, false, "none", "none " BAT_FIELD_WORDS,
     "lines of equal height, curvature, light"},
    BAT_FIELD_PARAMETERS,
    {"sheet", BATTEN_VALUE_WORD, false, false, "one", "one three-views stereo stereo-crossed",
     "one view; side, front, top and axonometric; for two eyes"},
    {"distance", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "of the eye, for perspective; 0: parallel"},
    {"stereo-angle", BATTEN_VALUE_ANGLE, false, false, "5 deg", NULL, "between both eyes"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL, "above the picture"},
    {"width", BATTEN_VALUE_COUNT, false, false, "1200", NULL, "pixels, or points of 1/72 inch"},
    {"height", BATTEN_VALUE_COUNT, false, false, "0", NULL, "0: follows the shape"},
};

/* What line drawings of surfaces have beyond others. */
static void read_line_options(const bat_run *run, batten_draw_options *options)
{
    const int field = bat_word(run, "contours");
    options->hidden = (batten_hidden)bat_word(run, "hidden");
    options->silhouettes = bat_yes(run, "silhouettes");
    options->contours = field != CONTOURS_NONE;
    const double a = options->azimuth, e = options->elevation;
    const batten_vec3 eye = {bat_cos(e) * bat_cos(a), bat_cos(e) * bat_sin(a), bat_sin(e)};
    if (options->contours)
        options->contour_field =
            bat_field_of(run, (batten_field_kind)(field - CONTOURS_FIRST), eye);
    options->contour_spacing = bat_number(run, "spacing");
    options->sheet = (batten_sheet)bat_word(run, "sheet");
    options->distance = bat_number(run, "distance");
    options->stereo_angle = bat_number(run, "stereo-angle");
}

static batten_draw_options options_of(const bat_run *run)
{
    batten_draw_options options = batten_draw_defaults();
    const int shading = bat_word(run, "shading");
    options.width = bat_count(run, "width");
    options.height = bat_count(run, "height");
    options.view = (batten_view)bat_word(run, "view");
    if (bat_has(run, "azimuth"))
        options.azimuth = bat_number(run, "azimuth");
    if (bat_has(run, "elevation"))
        options.elevation = bat_number(run, "elevation");
    options.comb = bat_yes(run, "comb");
    options.comb_scale = bat_number(run, "comb-scale");
    options.control_polygon = bat_yes(run, "polygon");
    options.data_points = bat_yes(run, "points");
    if (bat_has(run, "isolines"))
        options.isolines = bat_count(run, "isolines");
    else if (bat_word(run, "contours") != CONTOURS_NONE)
        options.isolines = 1;
    options.stripes = bat_number(run, "stripes");
    options.shading = shading == SHADING_AUTO ? BATTEN_SHADING_ISOLINES
                                              : (batten_shading)(shading - SHADING_FIRST);
    if (bat_has(run, "title"))
        options.title = bat_text(run, "title");
    read_line_options(run, &options);
    return options;
}

static bool has_surfaces(const batten_model *model)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object_kind kind = batten_model_object(model, i)->kind;
        if (kind == BATTEN_OBJECT_SURFACE || kind == BATTEN_OBJECT_TRIANGLES ||
            kind == BATTEN_OBJECT_BODY || kind == BATTEN_OBJECT_MESH)
            return true;
    }
    return false;
}

static bool wants_lines(const batten_draw_options *o)
{
    return o->hidden != BATTEN_HIDDEN_SHOWN || o->silhouettes || o->contours ||
           o->sheet != BATTEN_SHEET_ONE || o->distance > 0;
}

static batten_status draw_picture(bat_run *run, const batten_model *model,
                                  const batten_draw_options *options)
{
    const bool wanted = bat_word(run, "shading") != SHADING_AUTO;
    const bool is_png = options->format == BATTEN_PICTURE_PNG;
    if (wanted && !is_png)
        return bat_fail(BATTEN_UNSUPPORTED, "shaded pictures are written as .png, not as '%s'",
                        run->name);
    if (wanted && !has_surfaces(model))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'shading' needs a surface, body or mesh");
    if (wants_lines(options) && wanted)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'shading' goes with none of 'hidden', 'silhouettes', 'contours', 'sheet' "
            "and 'distance': these are line drawings");
    if (wants_lines(options)) {
        if (!has_surfaces(model))
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "'hidden', 'silhouettes', 'contours', 'sheet' and 'distance' need a "
                "surface");
        return batten_draw_surface_lines(model, options, run->job, &run->data, &run->size);
    }
    if (is_png && has_surfaces(model))
        return batten_draw_shaded(model, options, run->job, &run->data, &run->size);
    return batten_draw(model, options, &run->data, &run->size);
}

static batten_status run_picture(bat_run *run)
{
    batten_draw_options options = options_of(run);
    batten_model *model = NULL;
    if (!batten_picture_format_from_name(run->name, &options.format))
        return bat_fail(BATTEN_UNSUPPORTED, "'%s' must end in .png, .svg or .pdf", run->name);
    options.notes = run->notes;
    batten_status status = bat_merge(run, "picture", BAT_ALL, &model);
    if (status == BATTEN_OK)
        status = draw_picture(run, model, &options);
    batten_model_unref(model);
    return status;
}

static bool is_picture(const char *name)
{
    batten_picture_format format;
    return batten_picture_format_from_name(name, &format);
}

const bat_feature bat_feature_picture = {
    .shown =
        {"picture", "A drawing of curves, a shaded picture of surfaces, bodies, meshes",
         "Curves as .svg, .pdf or .png, with their curvature combs, polygons and points; surfaces,\n"
         "bodies and meshes shaded as .png, with dots for points, else as isoparametric lines and\n"
         "edges; small meshes with all edges of their triangles unless 'shading' is plain. With\n"
         "'hidden', 'silhouettes', 'contours', 'sheet' or 'distance' they are drawn as lines in\n"
         "every format.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 20 cm], [2 m, 30 cm], [3 m, 20 cm]]}\n"
         "  sheer: {interpolate: ducks}\n"
         "  tank: {cylinder: 0.4 m, height: 1 m}\n"
         "outputs:\n"
         "  sheer.svg: {picture: sheer, comb: yes, points: yes}\n"
         "  tank.png: {picture: tank, shading: zebra, width: 120, height: 80}\n"
         "  tank.svg: {picture: tank, hidden: dropped, silhouettes: yes}\n",
         "[Utah74 paper 5]", "batten_draw", BAT_PARAMETERS(parameters), true,
         .also =
             "render, zebra, curvature comb, porcupine, shaded, plot, draw, isophotes, hidden lines, view"},
    .run = run_picture,
    .takes_file = is_picture};
