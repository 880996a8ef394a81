/* The feature 'coons-network': a net of Coons patches as one surface. */
#include "base/plural.h"
#include "design/shared/grid.h"
#include "design/shared/place.h"

#include <batten/coons.h>

static const batten_parameter parameters[] = {
    {"coons-network", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length; or, with 'across', the curves along u, in order"},
    {"across", BATTEN_VALUE_MODEL, true, false, NULL, NULL, "the curves along v, in order"},
    {"at-u", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "where the curves across are, on a scale of your own; evenly by default"},
    {"at-v", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "where the curves along u are; evenly by default"},
    {"blend", BATTEN_VALUE_WORD, false, false, "coons", "linear cubic quintic coons",
     "the blending functions; patches join with tangents ('cubic') or curvatures"},
    {"twists", BATTEN_VALUE_WORD, false, false, "adini",
     "zero bilinear bessel adini spline energy selesnick", "where the twists come from"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "centripetal",
     "centripetal chord uniform foley foley-chord", "how parameters are given to points"},
    {"ends", BATTEN_VALUE_WORD, false, false, "not-a-knot", BAT_END_WORDS,
     "what holds at the ends of the splines through points"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far curves may miss each other; the design's tolerance by default"},
};

static batten_status from_points(bat_run *run,
                                 const batten_surface_coons_network_options *options,
                                 batten_surface **out)
{
    bat_grid grid = {0};
    batten_status status = bat_grid_of(run, "coons-network", &grid);
    if (status == BATTEN_OK)
        status =
            batten_surface_coons_grid((batten_grid){3, grid.count_u, grid.count_v, grid.points},
                                      options, (batten_uv_out){NULL, NULL}, out);
    bat_grid_release(&grid);
    return status;
}

/* Curves along one direction, and where those of the other stand. */
typedef struct {
    int count;
    batten_curve **curves;
    double *at;
} family;

static void family_release(family *f)
{
    for (int i = 0; f->curves && i < f->count; i++)
        batten_curve_unref(f->curves[i]);
    bat_release(f->curves);
    bat_release(f->at);
}

static batten_status places_of(const bat_run *run, const char *parameter, int count,
                               double **out)
{
    const bat_argument *given = bat_argument_of(run, parameter);
    if (given->count > 0 && given->count != count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' has %d value%s for %d curve%s", parameter,
                        given->count, bat_plural(given->count), count, bat_plural(count));
    *out = bat_array((size_t)count, sizeof **out);
    for (int i = 0; *out && i < count; i++)
        (*out)[i] = given->count > 0 ? given->items[i].number[0]
                                     : (count > 1 ? (double)i / (count - 1) : 0);
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* The curves of an argument in space. */
static batten_status curves_of(const bat_run *run, const char *parameter, family *f)
{
    bat_objects objects;
    batten_status status = bat_gather(run, parameter, BAT_CURVES, &objects);
    if (status != BATTEN_OK)
        return status;
    f->curves = bat_array((size_t)objects.count, sizeof(batten_curve *));
    f->count = objects.count;
    if (!f->curves)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < objects.count; i++)
        status = batten_curve_to_dimension(objects.at[i]->curve, 3, &f->curves[i]);
    bat_objects_release(&objects);
    return status;
}

/* Over the whole of the scale on which the curves of the other family stand. */
static batten_status stretch(family *f, const family *others)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < f->count; i++) {
        batten_curve *stretched = NULL;
        status = batten_curve_set_domain(f->curves[i], others->at[0],
                                         others->at[others->count - 1], &stretched);
        if (status != BATTEN_OK)
            continue;
        batten_curve_unref(f->curves[i]);
        f->curves[i] = stretched;
    }
    return status;
}

static batten_status from_curves(bat_run *run,
                                 const batten_surface_coons_network_options *options,
                                 batten_surface **out)
{
    family along = {0}, across = {0};
    double gap = 0;
    batten_status status = curves_of(run, "coons-network", &along);
    if (status == BATTEN_OK)
        status = curves_of(run, "across", &across);
    if (status == BATTEN_OK)
        status = places_of(run, "at-v", along.count, &along.at);
    if (status == BATTEN_OK)
        status = places_of(run, "at-u", across.count, &across.at);
    if (status == BATTEN_OK && (along.count < 2 || across.count < 2))
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "a network of %d and %d curves is too small",
                          along.count, across.count);
    if (status == BATTEN_OK)
        status = stretch(&along, &across);
    if (status == BATTEN_OK)
        status = stretch(&across, &along);
    if (status == BATTEN_OK)
        status = batten_surface_coons_network(
            &(batten_curve_net){across.count, along.count, across.at, along.at,
                                (const batten_curve *const *)along.curves,
                                (const batten_curve *const *)across.curves},
            options, &gap, out);
    if (status == BATTEN_OK && gap > 0)
        bat_report_error(run, gap, gap);
    family_release(&across);
    family_release(&along);
    return status;
}

static batten_status run_coons_network(bat_run *run)
{
    batten_surface_coons_network_options options = batten_surface_coons_network_defaults();
    batten_surface *surface = NULL;
    options.blending = (batten_blending)bat_word(run, "blend");
    options.twists = (batten_twists)bat_word(run, "twists");
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    options.ends = (batten_end_kind)bat_word(run, "ends");
    options.tolerance = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    const batten_status status = bat_has(run, "across") ? from_curves(run, &options, &surface)
                                                        : from_points(run, &options, &surface);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_coons_network = {
    .shown =
        {"coons-network", "A net of Coons patches as one surface",
         "The patches of a grid of curves, each from the four curves around it, with slopes that\n"
         "neighbours share: one B-spline through all curves. From points the curves are the\n"
         "splines through rows and columns. Given curves must cross at the values 'at-u' and\n"
         "'at-v' of their parameters, mapped onto that scale; for curves that cross anywhere use\n"
         "'gordon'. The twists decide how full the patches are; 'zero' leaves flat spots.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0], [0, 1, 0.1], [1, 1, 0.3], [2, 1, 0.1],\n"
         "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0]]\n"
         "    columns: 3\n"
         "  roof: {coons-network: grid, twists: energy}\n",
         "[SL section V.2] [Utah74 paper 1] [Coons74]", "batten_surface_coons_grid",
         BAT_PARAMETERS(parameters), false, .also = "composite Coons, net of patches, twists",
         .formula =
             "    S = Σ F_i(u) d_i(v) + Σ c_j(u) F_j(v) − Σ Σ F_i(u) r_ij F_j(v) + Σ Σ G_i(u) T_ij G_j(v)  on each face",
         .promise =
             "All curves are met; with cubic blends tangents, with quintic or coons curvatures are continuous where those of the curves are."},
    .run = run_coons_network,
    .beside = "across"};
