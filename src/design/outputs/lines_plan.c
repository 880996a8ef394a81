/* The output 'lines-plan': the lines drawing of a hull. */
#include "base/plural.h"
#include "design/text/document.h"

static const batten_parameter parameters[] = {
    {"lines-plan", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "half a hull, y to the side"},
    {"stations", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "how far apart; 0: those of the table in 'data', else eleven over the length"},
    {"station-at", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "where the stations are, instead"},
    {"waterlines", BATTEN_VALUE_LENGTH, false, false, "0", NULL, "how far apart; 0: chosen"},
    {"buttocks", BATTEN_VALUE_LENGTH, false, false, "0", NULL, "how far apart; 0: chosen"},
    {"diagonals", BATTEN_VALUE_COUNT, false, false, NULL, NULL,
     "how many; three by default, but none on a hull with knuckles"},
    {"diagonal-at", BATTEN_VALUE_LENGTH, true, false, NULL, NULL,
     "heights at which diagonals leave the centre plane, instead"},
    {"diagonal-angle", BATTEN_VALUE_ANGLE, true, false, NULL, NULL,
     "how far those fall below the level: one for all, or one for each; 45 deg by default"},
    {"design-waterline", BATTEN_VALUE_LENGTH, false, false, NULL, NULL, "its height"},
    {"data", BATTEN_VALUE_MODEL, false, false, NULL, NULL, "given points, drawn as crosses"},
    {"title", BATTEN_VALUE_TEXT, false, false, NULL, NULL,
     "in the legend; that of the design by default"},
    {"width", BATTEN_VALUE_COUNT, false, false, "1684", NULL, "pixels, or points of 1/72 inch"},
    {"height", BATTEN_VALUE_COUNT, false, false, "1191", NULL,
     "pixels, or points of 1/72 inch"},
};

/* The table of offsets among the data whose stations are to be drawn, or NULL. */
static const batten_offset_table *table_of(const bat_run *run,
                                           const batten_draw_lines_plan_options *plan)
{
    if (!plan->data || plan->stations > 0 || bat_has(run, "station-at"))
        return NULL;
    for (int i = 0; i < batten_model_count(plan->data); i++) {
        const batten_object *object = batten_model_object(plan->data, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            return object->offset_table;
    }
    return NULL;
}

/* The stations asked for one by one, or those of the table. */
static batten_status list_stations(const bat_run *run,
                                   const batten_draw_lines_plan_options *plan, int *count,
                                   double **out)
{
    const batten_offset_table *table = table_of(run, plan);
    const bat_argument *given = bat_argument_of(run, "station-at");
    if (given->count > 0 && plan->stations > 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'stations' spaces them, 'station-at' says where they are: give one");
    const int wanted = table ? batten_offset_table_station_count(table) : given->count;
    double *at = wanted ? bat_array((size_t)wanted, sizeof *at) : NULL;
    if (wanted && !at)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < wanted; i++)
        at[i] = table ? batten_offset_table_station(table, i)->x : given->items[i].number[0];
    *count = wanted;
    *out = at;
    return BATTEN_OK;
}

/* What says nothing beside another parameter is refused. */
static batten_status check_diagonals(const bat_run *run)
{
    const int at = bat_argument_of(run, "diagonal-at")->count;
    const int angle = bat_argument_of(run, "diagonal-angle")->count;
    if (at > 0 && bat_has(run, "diagonals"))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'diagonals' chooses them, 'diagonal-at' says where they are: give one");
    if (at == 0 && angle > 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "'diagonal-angle' belongs to the heights of 'diagonal-at', which are "
                        "not given");
    if (angle > 1 && angle != at)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d angles for %d diagonal%s: give one for all, or one for each", angle,
                        at, bat_plural(at));
    return BATTEN_OK;
}

/* Heights and angles of the diagonals that are asked for one by one.
 * @param[out] out  [2][count], or NULL without any */
static batten_status list_diagonals(const bat_run *run, int *count, double **out)
{
    const bat_argument *at = bat_argument_of(run, "diagonal-at");
    const bat_argument *angle = bat_argument_of(run, "diagonal-angle");
    const batten_status status = check_diagonals(run);
    if (status != BATTEN_OK || at->count == 0)
        return status;
    double *diagonals = bat_array3((size_t)at->count, 2, sizeof *diagonals);
    if (!diagonals)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < at->count; i++) {
        diagonals[i] = at->items[i].number[0];
        diagonals[at->count + i] = angle->count == 0
                                       ? 0.25 * BAT_PI
                                       : angle->items[angle->count > 1 ? i : 0].number[0];
    }
    *count = at->count;
    *out = diagonals;
    return BATTEN_OK;
}

static batten_draw_lines_plan_options plan_of(const bat_run *run)
{
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.stations = bat_number(run, "stations");
    plan.waterlines = bat_number(run, "waterlines");
    plan.buttocks = bat_number(run, "buttocks");
    if (bat_has(run, "diagonals"))
        plan.diagonals = bat_count(run, "diagonals");
    if (bat_has(run, "design-waterline"))
        plan.design_waterline = bat_number(run, "design-waterline");
    if (bat_has(run, "data"))
        plan.data = bat_model(run, "data");
    return plan;
}

static batten_status draw_lines_plan(bat_run *run, const batten_model *model,
                                     const batten_draw_options *options)
{
    batten_draw_lines_plan_options plan = plan_of(run);
    double *stations = NULL, *diagonals = NULL;
    batten_status status = list_stations(run, &plan, &plan.station_count, &stations);
    if (status == BATTEN_OK)
        status = list_diagonals(run, &plan.diagonal_count, &diagonals);
    plan.station_at = stations;
    plan.diagonal_at = diagonals;
    plan.diagonal_angle = diagonals ? diagonals + plan.diagonal_count : NULL;
    if (status == BATTEN_OK)
        status =
            batten_draw_lines_plan(model, &plan, options, run->notes, &run->data, &run->size);
    bat_release(diagonals);
    bat_release(stations);
    return status;
}

/* As pictures, and DXF. */
static bool find_format(const char *name, batten_picture_format *format)
{
    if (batten_picture_format_from_name(name, format))
        return true;
    *format = BATTEN_PICTURE_DXF;
    return batten_format_from_name(name) == BATTEN_FORMAT_DXF;
}

static batten_status run_lines_plan(bat_run *run)
{
    batten_draw_options options = batten_draw_defaults();
    batten_model *model = NULL;
    if (!find_format(run->name, &options.format))
        return bat_fail(BATTEN_UNSUPPORTED, "'%s' must end in .pdf, .svg, .png or .dxf",
                        run->name);
    options.width = bat_count(run, "width");
    options.height = bat_count(run, "height");
    if (bat_has(run, "title"))
        options.title = bat_text(run, "title");
    else if (run->document->title)
        options.title = run->document->title;
    batten_status status = bat_merge(run, "lines-plan", BAT_SURFACES, &model);
    if (status == BATTEN_OK)
        status = draw_lines_plan(run, model, &options);
    batten_model_unref(model);
    return status;
}

const bat_feature bat_feature_lines_plan = {
    .shown =
        {"lines-plan", "The lines drawing of a hull",
         "Body plan, profile and half-breadth plan of half a hull, and its table of offsets: x\n"
         "along the ship, y to the side, z up. The largest usual scale that the sheet allows is\n"
         "taken. Diagonals are straight in the body plan and stand in their true shape below the\n"
         "centre line of the half-breadth plan. The table has heights and half-breadths of edges at\n"
         "which the stations turn by 10 degrees or more: knuckles, chines. A file .dxf has the lines at\n"
         "full size, the profile at its place, on a layer for each family; for frames that are cut\n"
         "to a bound take 'sections'.",
         "features:\n"
         "  offsets: {read: offsets.csv}\n"
         "  stations: {interpolate: offsets, each: station}\n"
         "  hull: {skin: stations}\n"
         "outputs:\n"
         "  lines.svg: {lines-plan: hull, waterlines: 0.25 m, buttocks: 0.2 m, data: offsets}\n",
         "", "batten_draw_lines_plan", BAT_PARAMETERS(parameters), true,
         .also =
             "lines drawing, body plan, half-breadth plan, sheer plan, waterlines, buttocks, hull drawing, diagonals, chines, offsets"},
    .run = run_lines_plan};
