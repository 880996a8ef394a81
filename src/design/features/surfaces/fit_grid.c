/* The feature 'fit-grid': a calm surface near a grid of points. */
#include "design/shared/grid.h"
#include "design/shared/surface_fit.h"

#include <batten/scattered.h>

static const batten_parameter parameters[] = {
    {"fit-grid", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"as", BATTEN_VALUE_WORD, false, false, "surface", "surface function",
     "a surface in space, or heights z over x and y: rows along x, each at one y"},
    {"method", BATTEN_VALUE_WORD, false, false, "least-squares", "least-squares smooth",
     "few control points, or a penalty on bending; 'rms' and 'lambda' smooth too"},
    {"points-u", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "control points along the rows; 0: one for every four points, smoothing up to 43"},
    {"points-v", BATTEN_VALUE_COUNT, false, false, "0", NULL, "control points across the rows"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord",
     "how parameters are given to the points; those of a function are x and y"},
    {"hold-rims", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "least squares: the corners are met, and a rim depends on its own points alone"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "least squares: no point farther than this; control points are added until that holds"},
    BAT_SMOOTHNESS,
    {"penalty", BATTEN_VALUE_WORD, false, false, "energy", "energy differences",
     "smoothing: integrals of derivatives, or differences of control points with even knots"},
    {"order", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "smoothing, 1 to 4: which derivative is kept small"},
    {"periodic-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"periodic-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_surface_fit_grid_options options_of(const bat_run *run)
{
    batten_surface_fit_grid_options options = batten_surface_fit_grid_defaults();
    options.degree_u = bat_count(run, "degree-u");
    options.degree_v = bat_count(run, "degree-v");
    options.points_u = bat_count(run, "points-u");
    options.points_v = bat_count(run, "points-v");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.hold_rims = bat_yes(run, "hold-rims");
    options.penalty = (batten_grid_penalty)bat_word(run, "penalty");
    options.order = bat_count(run, "order");
    options.closed_u = bat_yes(run, "periodic-u");
    options.closed_v = bat_yes(run, "periodic-v");
    return options;
}

/* ---- functions ---- */

/* What the grid is as a function, in increasing x and y. */
typedef struct {
    double *x, *y; /* [count_u], [count_v] */
    double *z;     /* [count_u][count_v] */
} heights;

static void heights_end(heights *h)
{
    bat_release(h->x);
    bat_release(h->y);
    bat_release(h->z);
}

/* Coordinate c of the lines of direction k, each of which has one. */
static batten_status find_lines(const bat_grid *grid, int k, double *lines)
{
    const int n = k == 0 ? grid->count_u : grid->count_v,
              m = k == 0 ? grid->count_v : grid->count_u;
    double most = 0;
    for (int i = 0; i < n * m; i++)
        most = bat_max(most, fabs(grid->points[3 * i + k]));
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const int u = k == 0 ? i : j, v = k == 0 ? j : i;
            const double at = grid->points[3 * (u * grid->count_v + v) + k];
            if (j == 0)
                lines[i] = at;
            /* Coordinates written with nine digits or more still make a grid. */
            if (fabs(at - lines[i]) > 1e-9 * most)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "point %d of row %d has %c = %.9g, and the first of its %s "
                                "%.9g: this is not a grid over x and y",
                                u + 1, v + 1, k ? 'y' : 'x', at, k ? "row" : "column",
                                lines[i]);
        }
    for (int i = 1; i < n; i++)
        if ((lines[i] > lines[i - 1]) != (lines[1] > lines[0]) || lines[i] == lines[i - 1])
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "%c goes from %.9g to %.9g at line %d: this is not a grid over x and y",
                k ? 'y' : 'x', lines[i - 1], lines[i], i + 1);
    return BATTEN_OK;
}

static void turn_round(int n, double *lines)
{
    for (int i = 0; i < n / 2; i++) {
        const double kept = lines[i];
        lines[i] = lines[n - 1 - i];
        lines[n - 1 - i] = kept;
    }
}

static batten_status find_heights(const bat_grid *grid, heights *h)
{
    const int nu = grid->count_u, nv = grid->count_v;
    h->x = bat_array((size_t)nu, sizeof *h->x);
    h->y = bat_array((size_t)nv, sizeof *h->y);
    h->z = bat_array3((size_t)nu, (size_t)nv, sizeof *h->z);
    if (!h->x || !h->y || !h->z)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = find_lines(grid, 0, h->x);
    if (status == BATTEN_OK)
        status = find_lines(grid, 1, h->y);
    if (status != BATTEN_OK)
        return status;
    const bool back[2] = {h->x[0] > h->x[nu - 1], h->y[0] > h->y[nv - 1]};
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++)
            h->z[i * nv + j] = grid->points[3 * ((back[0] ? nu - 1 - i : i) * nv +
                                                 (back[1] ? nv - 1 - j : j)) +
                                            2];
    if (back[0])
        turn_round(nu, h->x);
    if (back[1])
        turn_round(nv, h->y);
    return BATTEN_OK;
}

/* ---- fits ---- */

static batten_status fit(const bat_run *run, const bat_grid *grid, bool smooth,
                         batten_surface_fit_grid_options *options,
                         batten_surface_fit_report *report, batten_surface **out)
{
    batten_status (*method)(batten_grid, const batten_surface_fit_grid_options *,
                            const batten_job *, batten_uv_out, batten_surface_fit_report *,
                            batten_surface **) =
        smooth ? batten_surface_smooth_grid : batten_surface_fit_grid;
    if (bat_word(run, "as") == 0)
        return method((batten_grid){3, grid->count_u, grid->count_v, grid->points}, options,
                      run->job, (batten_uv_out){NULL, NULL}, report, out);
    if (options->closed_u || options->closed_v)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a function of x and y does not close");
    heights h = {NULL, NULL, NULL};
    batten_surface *function = NULL;
    batten_status status = find_heights(grid, &h);
    options->parameters = BATTEN_GIVEN;
    options->given_u = h.x;
    options->given_v = h.y;
    if (status == BATTEN_OK)
        status = method((batten_grid){1, grid->count_u, grid->count_v, h.z}, options, run->job,
                        (batten_uv_out){NULL, NULL}, report, &function);
    if (status == BATTEN_OK)
        status = batten_surface_from_function(function, out);
    batten_surface_unref(function);
    heights_end(&h);
    return status;
}

static batten_status make_fit_grid(bat_run *run, const bat_grid *grid, batten_surface **surface)
{
    batten_surface_fit_grid_options options = options_of(run);
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
        status = fit(run, grid, smooth, &options, &report, surface);
    if (status == BATTEN_OK)
        bat_report_surface_fit(run, &report);
    if (status == BATTEN_OK && bat_max(report.spread_u, report.spread_v) > 0.5)
        bat_note(
            run,
            "the parameters of single rows differ from the average by %.2g steps; of heights "
            "over an even grid take 'as: function' or 'parameters: uniform'",
            bat_max(report.spread_u, report.spread_v));
    return status;
}

static batten_status run_fit_grid(bat_run *run)
{
    return bat_grid_surface(run, "fit-grid", make_fit_grid);
}

const bat_feature bat_feature_fit_grid = {
    .shown =
        {"fit-grid", "A calm surface near a grid of points",
         "Least squares with fewer control points than data, so that noise is averaged out; or a\n"
         "smoothing surface, whose stiffness is set by 'rms' (how far it may be off) or 'lambda',\n"
         "or else by cross validation. With held rims two surfaces that share the points of a rim,\n"
         "and have as many control points along it, meet there. The largest distance and its\n"
         "location are reported. In a file of points the rows of a grid are separated by empty\n"
         "lines; in the design 'columns' says how long they are.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0], [3, 0, 0.1], [4, 0, 0],\n"
         "             [0, 1, 0.1], [1, 1, 0.3], [2, 1, 0.1], [3, 1, 0.2], [4, 1, 0.1],\n"
         "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0], [3, 2, 0.1], [4, 2, 0]]\n"
         "    columns: 5\n"
         "  calm: {fit-grid: grid, points-u: 4, points-v: 3}\n",
         "[SL section I.2] [PT97 section 9.4.3]", "batten_surface_fit_grid",
         BAT_PARAMETERS(parameters), false,
         .also = "surface approximation, smoothing surface, regression surface",
         .formula =
             "    Σ w_rq |S(ū_r, v̄_q) − p_rq|² (+ λ × roughness) → minimum,  S(u, v) = Σ Σ d_ij N_{i,k}(u) N_{j,l}(v)",
         .promise = "The sum is least for these knots."},
    .run = run_fit_grid};
