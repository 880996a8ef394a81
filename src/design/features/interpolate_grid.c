#include "design/grid.h"
#include "design/place.h"

static const batten_parameter parameters[] = {
    {"interpolate-grid", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, each with as many, or a table of offsets without gaps"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the points"},
    {"knots", BATTEN_VALUE_WORD, false, false, "averaged", "averaged data",
     "where the knots are"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds on the rim, with knots at the data"},
    {"periodic-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"periodic-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_grid_options options_of(const bat_run *run)
{
    batten_grid_options options = batten_grid_defaults();
    options.degree_u = bat_count(run, "degree-u");
    options.degree_v = bat_count(run, "degree-v");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.knots_at_data = bat_word(run, "knots") == 1;
    options.ends = (batten_end_kind)bat_word(run, "ends");
    options.periodic_u = bat_yes(run, "periodic-u");
    options.periodic_v = bat_yes(run, "periodic-v");
    return options;
}

static batten_status make(bat_run *run, const bat_grid *grid, batten_surface **surface)
{
    const batten_grid_options options = options_of(run);
    batten_grid_report report;
    const batten_status status =
        batten_surface_interpolate(3, grid->count_u, grid->count_v, grid->points, &options,
                                   run->job, NULL, NULL, &report, surface);
    if (status == BATTEN_OK && bat_max(report.spread_u, report.spread_v) > 0.5)
        bat_note(run,
                 "the parameters of single rows differ from the average by %.2g steps; "
                 "'interpolate' and 'skin' will follow such points better",
                 bat_max(report.spread_u, report.spread_v));
    if (status == BATTEN_OK)
        bat_report_error(run, report.residual, report.residual);
    return status;
}

static batten_status run(bat_run *run)
{
    return bat_grid_surface(run, "interpolate-grid", make);
}

const bat_feature bat_feature_interpolate_grid = {
    .shown = {"interpolate-grid", "The surface through a grid of points",
              "Every row must have as many points; u runs along the rows, v across them.",
              "features:\n"
              "  grid:\n"
              "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0], [0, 1, 0.1], [1, 1, 0.3], [2, "
              "1, 0.1],\n"
              "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0]]\n"
              "    columns: 3\n"
              "  roof: {interpolate-grid: grid, degree-u: 2, degree-v: 2}\n",
              "[PT97]", "batten_surface_interpolate", BAT_PARAMETERS(parameters), false},
    .run = run};
