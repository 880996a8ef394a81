/* The feature 'sweep': a section swept along a spine. */
#include "base/plural.h"
#include "design/shared/sweeps.h"

static const batten_parameter parameters[] = {
    {"sweep", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the section, or several, drawn in the xy-plane or, as space curves, about it"},
    {"path", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curve along which they go"},
    {"frames", BATTEN_VALUE_WORD, false, false, "rotation-minimising",
     "rotation-minimising fixed frenet closing", "how the sections turn along the spine"},
    {"x-axis", BATTEN_VALUE_POINT, false, false, NULL, NULL,
     "where the x-axis of the section points at the start"},
    {"up", BATTEN_VALUE_POINT, false, false, NULL, NULL,
     "where the y-axis of the section points all along, instead of 'frames'"},
    {"guide", BATTEN_VALUE_MODEL, false, false, NULL, NULL,
     "a curve to which the y-axis points, instead of 'frames'"},
    {"scale", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "at equal steps of the spine's length; one value holds all along"},
    {"scale-y", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of the y-axis, when it differs; 'scale' is then that of x"},
    {"twist", BATTEN_VALUE_ANGLE, true, false, NULL, NULL,
     "about the spine, at equal steps of its length"},
    {"at", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "where several sections are placed: shares of the spine's length, from 0 to 1"},
    {"align", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "reverse or turn sections that would twist the surface; no keeps them"},
    BAT_SWEEP_CORNERS,
    BAT_SWEEP_BOUNDS,
};

/* What the options point to. */
typedef struct {
    batten_curve *scale, *scale_y, *twist;
    batten_vec3 up;
    double *at;
    batten_surface_sweep_options options;
} settings;

static batten_status find_places(const bat_run *run, int sections, double **at)
{
    const bat_argument *given = bat_argument_of(run, "at");
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != sections)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'at' has %d value%s for %d section%s",
                        given->count, bat_plural(given->count), sections, bat_plural(sections));
    *at = bat_array((size_t)sections, sizeof **at);
    for (int i = 0; *at && i < sections; i++)
        (*at)[i] = given->items[i].number[0];
    return *at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status read_settings(const bat_run *run, int sections, settings *s)
{
    batten_surface_sweep_options *o = &s->options;
    *o = batten_surface_sweep_defaults();
    o->tolerance = bat_sweep_within(run);
    o->degree = bat_count(run, "degree");
    o->frames = (batten_frame_kind)bat_word(run, "frames");
    o->corners = (batten_corner_kind)bat_word(run, "corners");
    o->allow_folds = bat_yes(run, "folds");
    o->align = bat_yes(run, "align");
    if (bat_has(run, "x-axis"))
        o->x = bat_point(run, "x-axis");
    if (bat_has(run, "up")) {
        s->up = bat_point(run, "up");
        o->up = &s->up;
    }
    batten_status status =
        bat_has(run, "guide") ? bat_one_curve(run, "guide", &o->guide) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_sweep_law(run, "scale", &s->scale);
    if (status == BATTEN_OK)
        status = bat_sweep_law(run, "scale-y", &s->scale_y);
    if (status == BATTEN_OK)
        status = bat_sweep_law(run, "twist", &s->twist);
    if (status == BATTEN_OK)
        status = find_places(run, sections, &s->at);
    o->scale = s->scale;
    o->scale_y = s->scale_y;
    o->twist = s->twist;
    o->at = s->at;
    return status;
}

static batten_status sweep(bat_run *run, int count, const batten_curve *const *sections)
{
    settings s = {.scale = NULL};
    const batten_curve *spine = NULL;
    batten_surfaces made = {0, NULL};
    batten_surface_sweep_report report;
    batten_status status = bat_one_curve(run, "path", &spine);
    if (status == BATTEN_OK)
        status = read_settings(run, count, &s);
    if (status == BATTEN_OK)
        status = batten_surfaces_sweep((batten_curve_row){count, sections}, spine, &s.options,
                                       run->job, &report, &made);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        bat_remark_space_section(run, sections[i]);
    batten_curve_unref(s.scale);
    batten_curve_unref(s.scale_y);
    batten_curve_unref(s.twist);
    bat_release(s.at);
    return bat_put_sweep(run, status, made.count, made.at, &report);
}

static batten_status run_sweep(bat_run *run)
{
    bat_objects all;
    bat_tipped sections;
    batten_status status = bat_gather(run, "sweep", BAT_CURVES | BAT_POINTS, &all);
    if (status != BATTEN_OK)
        return status;
    status = bat_take_tipped(&all, &sections);
    if (status == BATTEN_OK)
        status = sweep(run, all.count, sections.curves);
    bat_tipped_release(&sections);
    bat_objects_release(&all);
    return status;
}

const bat_feature bat_feature_sweep = {
    .shown =
        {"sweep", "A section swept along a spine",
         "The section is drawn in the xy-plane around the origin, which moves along the spine; x, y\n"
         "and z of a space curve are taken along the axes of the moving frame, z along the spine.\n"
         "Rotation-minimising frames turn as little as possible; 'closing' ones also meet again at\n"
         "the end of a closed spine; with 'up' or 'guide' the y-axis points in a given direction.\n"
         "'scale' and 'twist' are laws over the length of the spine. Several sections are blended;\n"
         "the first and the last may be a point, in which the sweep ends sharply ('skin' with\n"
         "'spine' and 'poles: smooth' ends round). Sections that would twist it are reversed or\n"
         "turned, as 'align' says, and named. At corners sections lean into the 'mitre' plane, or\n"
         "the surface is 'split'. A sweep is not a NURBS surface: sections are added until the true\n"
         "sweep is met 'within' the tolerance. Where the spine bends too sharply for the section the\n"
         "sweep is refused, and the message says where.",
         "units: m\n"
         "features:\n"
         "  way: {points: [[0, 0, 0], [2, 1, 0.5], [4, 0, 1], [6, 1, 1]]}\n"
         "  spine: {interpolate: way}\n"
         "  oval: {ellipse: 0.4 m, b: 0.2 m}\n"
         "  horn: {sweep: oval, path: spine, scale: [1, 0.8, 0.3], twist: [0, 90 deg]}\n",
         "[LN12 section 12.8] [PT97 section 10.4] [BR91] [WJZL08]", "batten_surfaces_sweep",
         BAT_PARAMETERS(parameters), false,
         .also =
             "rail, one rail, spine, guide, path, swept surface, moving frame, rotation-minimising frame",
         .formula =
             "    S(u, v) = γ(v) + s(v) F(v) R(θ(v)) C(u),  F the moving frame, s scale, θ twist",
         .promise = "The true sweep is met within the tolerance."},
    .run = run_sweep,
    .displacing = "sweep"};
