#include "design/place.h"

static const batten_parameter parameters[] = {
    {"skin", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the sections, in order"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the sections"},
    {"within", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "how far a section may move for the sake of few knots; 0 keeps all knots"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the sections"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds at both ends"},
    {"start", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS,
     "what holds at the first section"},
    {"start-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"end", BATTEN_VALUE_WORD, false, false, NULL, BAT_END_WORDS,
     "what holds at the last section"},
    {"end-vector", BATTEN_VALUE_POINT, false, false, "origin", NULL,
     "the derivative or direction there"},
    {"periodic", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first section follows the last"},
    {"align", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "reverse sections that run against the first"},
    {"spine", BATTEN_VALUE_MODEL, false, false, NULL, NULL,
     "a curve along which the sections, drawn in the xy-plane, are placed"},
    {"twist", BATTEN_VALUE_ANGLE, true, false, NULL, NULL, "of each section about the spine"},
    {"scale", BATTEN_VALUE_NUMBER, true, false, NULL, NULL, "of each section"},
    {"frames", BATTEN_VALUE_WORD, false, false, "rotation-minimising",
     "rotation-minimising fixed frenet closing", "how the sections turn along the spine"},
};

/* One number for each section, or NULL where none is given. */
static batten_status list_numbers(const bat_run *run, const char *parameter, int count,
                                  double **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    *out = NULL;
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d values for %d sections", parameter,
                        given->count, count);
    *out = bat_array((size_t)count, sizeof **out);
    for (int i = 0; *out && i < count; i++)
        (*out)[i] = given->items[i].number[0];
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status skin(bat_run *run, int count, const batten_curve **sections)
{
    batten_skin_options options = batten_skin_defaults();
    batten_surface *surface = NULL;
    double *twist = NULL, *scale = NULL;
    options.degree = bat_count(run, "degree");
    options.tolerance = bat_number(run, "within");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.start = bat_end(run, "start", "start-vector");
    options.end = bat_end(run, "end", "end-vector");
    options.periodic = bat_yes(run, "periodic");
    options.align = bat_yes(run, "align");
    options.frames = (batten_frame_kind)bat_word(run, "frames");
    batten_status status =
        bat_has(run, "spine") ? bat_one_curve(run, "spine", &options.spine) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = list_numbers(run, "twist", count, &twist);
    if (status == BATTEN_OK)
        status = list_numbers(run, "scale", count, &scale);
    options.twist = twist;
    options.scale = scale;
    if (status == BATTEN_OK)
        status = batten_surface_skin(count, sections, &options, run->job, NULL,
                                     &run->result->skin, &surface);
    bat_release(scale);
    bat_release(twist);
    return bat_put_surface(run, status, surface);
}

static batten_status run(bat_run *run)
{
    bat_objects curves;
    batten_status status = bat_gather(run, "skin", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    const batten_curve **sections = bat_array((size_t)curves.count, sizeof *sections);
    for (int i = 0; sections && i < curves.count; i++)
        sections[i] = curves.at[i]->curve;
    status = sections ? skin(run, curves.count, sections) : BATTEN_OUT_OF_MEMORY;
    bat_release(sections);
    bat_objects_release(&curves);
    if (status != BATTEN_OK)
        return status;
    run->result->shown.skin = &run->result->skin;
    bat_report_error(run, run->result->skin.deviation, run->result->skin.deviation);
    return BATTEN_OK;
}

const bat_feature bat_feature_skin = {
    .shown = {"skin", "The surface through sections",
              "u runs along the sections, v across them. Sections have knots of their own; to "
              "keep all\n"
              "of them makes a heavy surface, so with 'within' few common knots are found such "
              "that no\n"
              "section moves farther. With 'spine' the sections are drawn in the xy-plane and "
              "placed\n"
              "along it.",
              "features:\n"
              "  aft: {arc: 1 m, angle: 180 deg, axis: x, from: y}\n"
              "  mid: {arc: 1.4 m, angle: 180 deg, axis: x, from: y, at: [2 m, 0, 0]}\n"
              "  fore: {arc: 0.8 m, angle: 180 deg, axis: x, from: y, at: [4 m, 0, 0]}\n"
              "  hull: {skin: [aft, mid, fore], ends: natural}\n",
              "[PT97]", "batten_surface_skin", BAT_PARAMETERS(parameters), false},
    .run = run};
