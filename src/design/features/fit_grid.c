#include "design/grid.h"
#include "design/surface_fit.h"

static const batten_parameter parameters[] = {
    {"fit-grid", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, each with as many, or a table of offsets without gaps"},
    {"method", BATTEN_VALUE_WORD, false, false, "least-squares", "least-squares smooth",
     "few control points, or a penalty on bending; 'rms' and 'lambda' smooth too"},
    {"points-u", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "control points along the rows; 0: one for every four points, smoothing up to 43"},
    {"points-v", BATTEN_VALUE_COUNT, false, false, "0", NULL, "control points across the rows"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the points"},
    {"hold-rims", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "least squares: the corners are met, and a rim depends on its own points alone"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "least squares: no point farther than this; control points are added until that holds"},
    BAT_SMOOTHNESS,
    {"penalty", BATTEN_VALUE_WORD, false, false, "energy", "energy differences",
     "smoothing: integrals of derivatives, or differences of control points with even knots"},
    {"order", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "smoothing, 1 to 4: which derivative shall be small"},
    {"periodic-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"periodic-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_grid_fit_options options_of(const bat_run *run)
{
    batten_grid_fit_options options = batten_grid_fit_defaults();
    options.degree_u = bat_count(run, "degree-u");
    options.degree_v = bat_count(run, "degree-v");
    options.points_u = bat_count(run, "points-u");
    options.points_v = bat_count(run, "points-v");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.hold_rims = bat_yes(run, "hold-rims");
    options.penalty = (batten_grid_penalty)bat_word(run, "penalty");
    options.order = bat_count(run, "order");
    options.periodic_u = bat_yes(run, "periodic-u");
    options.periodic_v = bat_yes(run, "periodic-v");
    return options;
}

static batten_status make(bat_run *run, const bat_grid *grid, batten_surface **surface)
{
    batten_grid_fit_options options = options_of(run);
    batten_surface_fit_report report;
    batten_status status = bat_smoothness_of(run, &options.by, &options.amount);
    const bool smooth =
        bat_word(run, "method") == 1 || bat_has(run, "rms") || bat_has(run, "lambda");
    if (status == BATTEN_OK && bat_has(run, "within")) {
        options.tolerance = bat_number(run, "within");
        if (smooth || !(options.tolerance > 0))
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              smooth ? "'within' is for least squares; smoothing bounds 'rms'"
                                     : "'within' must be above 0");
    }
    if (status == BATTEN_OK)
        status = (smooth ? batten_surface_smooth_grid : batten_surface_fit_grid)(
            3, grid->count_u, grid->count_v, grid->points, &options, run->job, NULL, NULL,
            &report, surface);
    if (status == BATTEN_OK)
        bat_report_surface_fit(run, &report);
    if (status == BATTEN_OK && bat_max(report.spread_u, report.spread_v) > 0.5)
        bat_note(run,
                 "the parameters of single rows differ from the average by %.2g steps; heights "
                 "over an even grid want 'parameters: uniform'",
                 bat_max(report.spread_u, report.spread_v));
    return status;
}

static batten_status run(bat_run *run)
{
    return bat_grid_surface(run, "fit-grid", make);
}

const bat_feature bat_feature_fit_grid = {
    .shown =
        {"fit-grid", "A calm surface near a grid of points",
         "Least squares with fewer control points than data, so that noise is averaged away;\n"
         "or a smoothing surface, whose stiffness 'rms' (how far it may be off), 'lambda' or\n"
         "else cross validation decides. With held rims two surfaces that share the points "
         "of\n"
         "a rim, and as many control points along it, meet there. The largest distance, and\n"
         "where it is, are reported. In a file of points the rows of a grid are separated by\n"
         "empty lines; in the design 'columns' says how long they are.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0], [3, 0, 0.1], [4, 0, 0],\n"
         "             [0, 1, 0.1], [1, 1, 0.3], [2, 1, 0.1], [3, 1, 0.2], [4, 1, 0.1],\n"
         "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0], [3, 2, 0.1], [4, 2, 0]]\n"
         "    columns: 5\n"
         "  calm: {fit-grid: grid, points-u: 4, points-v: 3}\n",
         "[PT97]", "batten_surface_fit_grid", BAT_PARAMETERS(parameters), false},
    .run = run};
