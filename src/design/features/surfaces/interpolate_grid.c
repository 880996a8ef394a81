/* The feature 'interpolate-grid': the surface through a grid of points. */
#include "base/plural.h"
#include "design/shared/grid.h"
#include "design/shared/place.h"
#include "design/shared/through.h"

#include <batten/grid.h>

#include <string.h>

static const batten_parameter parameters[] = {
    {"interpolate-grid", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to the points"},
    {"knots", BATTEN_VALUE_WORD, false, false, "averaged", "averaged data",
     "where the knots are"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds on the rim, with knots at the data"},
    {"weights", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of the points in their order, above 0, or one for all: a rational surface"},
    {"gaps", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "missing points, counted from 1: the numbers given there are ignored"},
    {"du", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "derivatives along the rows: at the start of each row, then at the end of each"},
    {"dv", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "derivatives across the rows: at each point of the first row, then of the last"},
    {"twists", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "mixed derivatives at the four corners, in their order around the rim"},
    {"periodic-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"periodic-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_surface_interpolate_options options_of(const bat_run *run)
{
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.degree_u = bat_count(run, "degree-u");
    options.degree_v = bat_count(run, "degree-v");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.knots_at_data = bat_word(run, "knots") == 1;
    options.ends = (batten_end_kind)bat_word(run, "ends");
    options.closed_u = bat_yes(run, "periodic-u");
    options.closed_v = bat_yes(run, "periodic-v");
    return options;
}

/* What is listed row after row, turned as the points are: u runs along the rows. */
static size_t turned(const bat_grid *grid, int index)
{
    return (size_t)(index % grid->count_u) * (size_t)grid->count_v +
           (size_t)(index / grid->count_u);
}

static batten_status find_weights(const bat_run *run, const bat_grid *grid, double **out)
{
    const int count = grid->count_u * grid->count_v;
    double *listed = NULL;
    if (bat_argument_of(run, "weights")->count == 0)
        return BATTEN_OK;
    batten_status status = bat_numbers_each(run, "weights", count, "points", &listed);
    if (status == BATTEN_OK && !(*out = bat_array((size_t)count, sizeof **out)))
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        (*out)[turned(grid, i)] = listed[i];
    bat_release(listed);
    return status;
}

static batten_status find_gaps(const bat_run *run, const bat_grid *grid, bool **out)
{
    const bat_argument *given = bat_argument_of(run, "gaps");
    const int count = grid->count_u * grid->count_v;
    if (given->count == 0)
        return BATTEN_OK;
    *out = bat_array((size_t)count, sizeof **out);
    if (!*out)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < given->count; i++) {
        const int index = given->items[i].count;
        if (index < 1 || index > count)
            return bat_fail(BATTEN_BAD_ARGUMENT, "gap %d: the points are counted 1 to %d",
                            index, count);
        (*out)[turned(grid, index - 1)] = true;
    }
    return BATTEN_OK;
}

/* ---- derivatives on the rim ---- */

typedef struct {
    double *du, *dv, *twists;
} rim;

static batten_status list_vectors(const bat_run *run, const char *parameter, int count,
                                  double **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d vector%s, not %d", parameter,
                        given->count, bat_plural(given->count), count);
    *out = bat_array3((size_t)count, 3, sizeof **out);
    for (int i = 0; *out && i < count; i++)
        memcpy(*out + 3 * i, given->items[i].number, 3 * sizeof **out);
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status find_rim(const bat_run *run, const bat_grid *grid, rim *out)
{
    double *around = NULL; /* the twists in the order of the corners */
    batten_status status = list_vectors(run, "du", 2 * grid->count_v, &out->du);
    if (status == BATTEN_OK)
        status = list_vectors(run, "dv", 2 * grid->count_u, &out->dv);
    if (status == BATTEN_OK)
        status = list_vectors(run, "twists", 4, &around);
    if (status == BATTEN_OK && around && !(out->du && out->dv))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "'twists' need both 'du' and 'dv'");
    if (status == BATTEN_OK && around) {
        /* Wanted as (0, 0), (0, 1), (1, 0), (1, 1). */
        static const int corners[4] = {0, 3, 1, 2};
        out->twists = bat_array(12, sizeof *out->twists);
        for (int c = 0; out->twists && c < 4; c++)
            memcpy(out->twists + 3 * c, around + 3 * corners[c], 3 * sizeof *around);
        status = out->twists ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(around);
    return status;
}

static void release_rim(rim *r)
{
    bat_release(r->du);
    bat_release(r->dv);
    bat_release(r->twists);
}

static void report_interpolate_grid(bat_run *run,
                                    const batten_surface_interpolate_report *report)
{
    if (bat_max(report->spread_u, report->spread_v) > 0.5)
        bat_note(run,
                 "the parameters of single rows differ from the average by %.2g steps; "
                 "heights over an even grid want 'parameters: uniform'; 'interpolate' and "
                 "'skin' will follow other points better",
                 bat_max(report->spread_u, report->spread_v));
    if (report->filled > 0)
        bat_remark(run, "%d gap%s %s filled with the points of least energy", report->filled,
                   bat_plural(report->filled), bat_one_or_many(report->filled, "is", "are"));
    bat_report_error(run, report->error, report->error);
}

static batten_status make_interpolate_grid(bat_run *run, const bat_grid *grid,
                                           batten_surface **surface)
{
    batten_surface_interpolate_options options = options_of(run);
    batten_surface_interpolate_report report;
    double *weights = NULL;
    bool *gaps = NULL;
    rim given = {0};
    batten_status status = find_weights(run, grid, &weights);
    if (status == BATTEN_OK)
        status = find_rim(run, grid, &given);
    options.du = given.du;
    options.dv = given.dv;
    options.twists = given.twists;
    if (status == BATTEN_OK)
        status = find_gaps(run, grid, &gaps);
    options.weights = weights;
    options.gaps = gaps;
    if (status == BATTEN_OK)
        status = batten_surface_interpolate(
            (batten_grid){3, grid->count_u, grid->count_v, grid->points}, &options, run->job,
            (batten_uv_out){NULL, NULL}, &report, surface);
    if (status == BATTEN_OK)
        report_interpolate_grid(run, &report);
    release_rim(&given);
    bat_release(gaps);
    bat_release(weights);
    return status;
}

static batten_status run_interpolate_grid(bat_run *run)
{
    return bat_grid_surface(run, "interpolate-grid", make_interpolate_grid);
}

const bat_feature bat_feature_interpolate_grid = {
    .shown =
        {"interpolate-grid", "The surface through a grid of points",
         "Every row must have as many points; u runs along the rows, v across them. 'gaps'\n"
         "lists where points are missing; least energy fills them, and the surface passes\n"
         "through all others. 'du' and 'dv' say how the surface leaves its rim, per unit of the\n"
         "parameters, which run from 0 to 1; 'twists' go with both and are estimated by\n"
         "default. In a file of points the rows are separated by empty lines; in the design\n"
         "'columns' says how long they are.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0], [0, 1, 0.1], [1, 1, 0.3], [2, 1, 0.1],\n"
         "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0]]\n"
         "    columns: 3\n"
         "  roof: {interpolate-grid: grid, degree-u: 2, degree-v: 2}\n",
         "[SL section V.1] [SL section I.5] [SL section VII.4] [Utah74 paper 13] [LN12 formula 12.7.1-30] [LN12 section 12.7] [PT97 section 9.2.5]",
         "batten_surface_interpolate", BAT_PARAMETERS(parameters), false,
         .also =
             "bicubic spline, inversion of a B-spline surface, tensor product, Ferguson surface, parametric bicubic",
         .formula = "    S(u, v) = Σ Σ d_ij N_{i,k}(u) N_{j,l}(v),  S(ū_r, v̄_q) = p_rq",
         .promise = "The points are met; rows are solved first, then columns."},
    .run = run_interpolate_grid};
