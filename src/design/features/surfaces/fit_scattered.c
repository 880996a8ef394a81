/* The feature 'fit-scattered': a surface near points in no order. */
#include "base/plural.h"
#include "design/shared/rows.h"
#include "design/shared/surface_fit.h"

#include <batten/scattered.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"fit-scattered", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "points in any order, or tables of offsets"},
    {"as", BATTEN_VALUE_WORD, false, false, "cloud", "cloud function",
     "a surface in space, or heights z over x and y"},
    {"base", BATTEN_VALUE_MODEL, false, false, NULL, NULL,
     "of a cloud: a surface over which it lies once; its own plane by default"},
    {"corners", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "of a cloud, instead of 'base': four corners in their order around"},
    {"method", BATTEN_VALUE_WORD, false, false, "penalised", "penalised multilevel",
     "least squares and a penalty on bending, or lattices that halve"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "no point farther than this: knots are added until that holds"},
    BAT_SMOOTHNESS,
    {"spans-u", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "between knots at first, along the longer side or x; 0: by the number of points"},
    {"spans-v", BATTEN_VALUE_COUNT, false, false, "0", NULL, "the same across"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "2 to 9"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "2 to 9"},
    {"levels", BATTEN_VALUE_COUNT, false, false, "0", NULL,
     "of 'multilevel', at most; 0: as many as the points support, up to nine"},
    {"robust", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "far points count less"},
    {"corrections", BATTEN_VALUE_COUNT, false, false, "20", NULL,
     "of a cloud: how often at most points get the parameters of their nearest points"},
};

/* [count][3] */
typedef struct {
    int count;
    double *points;
} cloud;

/* ---- the base ---- */

static batten_status base_of_corners(const bat_run *run, batten_surface **base)
{
    const bat_argument *given = bat_argument_of(run, "corners");
    double corners[12];
    if (given->count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'corners' has %d point%s, not 4", given->count,
                        bat_plural(given->count));
    const int order[4] = {0, 1, 3, 2}; /* around, to rows */
    for (int i = 0; i < 4; i++)
        memcpy(corners + 3 * i, given->items[order[i]].number, 3 * sizeof *corners);
    return batten_surface_from_corners(corners, base);
}

static batten_status find_base(const bat_run *run, batten_surface **base)
{
    const bool corners = bat_argument_of(run, "corners")->count > 0;
    if (corners && bat_has(run, "base"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "give either 'base' or 'corners', not both");
    if (corners)
        return base_of_corners(run, base);
    if (!bat_has(run, "base"))
        return BATTEN_OK;
    bat_objects surfaces;
    batten_status status = bat_gather(run, "base", BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    if (surfaces.count == 1)
        *base = batten_surface_ref(surfaces.at[0]->surface);
    else
        status = bat_fail(BATTEN_BAD_ARGUMENT, "'base' has %d surface%s; one is needed",
                          surfaces.count, bat_plural(surfaces.count));
    bat_objects_release(&surfaces);
    return status;
}

/* ---- fits ---- */

static batten_status fit_function(const bat_run *run, const cloud *data,
                                  const batten_surface_scattered_options *options,
                                  batten_surface_fit_report *report, batten_surface **out)
{
    const size_t n = (size_t)data->count;
    double *uv = bat_array3(n, 2, sizeof *uv), *z = bat_array(n, sizeof *z);
    batten_surface *heights = NULL;
    batten_status status = uv && z ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        uv[2 * i] = data->points[3 * i];
        uv[2 * i + 1] = data->points[3 * i + 1];
        z[i] = data->points[3 * i + 2];
    }
    if (status == BATTEN_OK)
        status = batten_surface_scattered(uv, (batten_points){1, data->count, z}, options,
                                          run->job, report, &heights);
    if (status == BATTEN_OK)
        status = batten_surface_from_function(heights, out);
    batten_surface_unref(heights);
    bat_release(z);
    bat_release(uv);
    return status;
}

static batten_status fit(const bat_run *run, const cloud *data,
                         const batten_surface_scattered_options *options,
                         batten_surface_fit_report *report, batten_surface **out)
{
    batten_surface *base = NULL;
    if (bat_word(run, "as") == 1) {
        if (bat_has(run, "base") || bat_argument_of(run, "corners")->count > 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "a function of x and y has no base");
        return fit_function(run, data, options, report, out);
    }
    batten_status status = find_base(run, &base);
    if (status == BATTEN_OK)
        status = batten_surface_cloud(&(batten_cloud){{3, data->count, data->points}, base},
                                      options, run->job, NULL, report, out);
    batten_surface_unref(base);
    return status;
}

static batten_status options_of(const bat_run *run, batten_surface_scattered_options *options)
{
    *options = batten_surface_scattered_defaults();
    options->method = (batten_scattered_method)bat_word(run, "method");
    options->spans_u = bat_count(run, "spans-u");
    options->spans_v = bat_count(run, "spans-v");
    options->degree_u = bat_count(run, "degree-u");
    options->degree_v = bat_count(run, "degree-v");
    options->levels = bat_count(run, "levels");
    options->huber = bat_yes(run, "robust");
    options->corrections = bat_count(run, "corrections");
    if (bat_has(run, "within")) {
        options->tolerance = bat_number(run, "within");
        if (!(options->tolerance > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT, "'within' is %g; it must be above 0",
                            options->tolerance);
        if (bat_has(run, "rms") || bat_has(run, "lambda") || options->huber)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "'within' bounds every distance: it goes with none of 'rms', "
                            "'lambda', 'robust'");
    }
    return bat_smoothness_of(run, &options->by, &options->amount);
}

static batten_status run_fit_scattered(bat_run *run)
{
    batten_surface_scattered_options options;
    batten_surface_fit_report report;
    batten_surface *surface = NULL;
    cloud data = {0, NULL};
    batten_status status = options_of(run, &options);
    if (status == BATTEN_OK)
        status = bat_gather_points(run, "fit-scattered", &data.count, &data.points);
    if (status == BATTEN_OK)
        status = fit(run, &data, &options, &report, &surface);
    if (status == BATTEN_OK)
        bat_report_surface_fit(run, &report);
    if (status == BATTEN_OK && bat_has(run, "rms") && report.rms > 1.01 * options.amount)
        bat_note(run,
                 "rms is %.3g, not the %.3g asked for: %d x %d control points do not come "
                 "nearer; give more 'spans-u' and 'spans-v'",
                 report.rms, options.amount, report.points_u, report.points_v);
    bat_release(data.points);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_fit_scattered = {
    .shown =
        {"fit-scattered", "A surface near points in no order",
         "Heights over a plane ('as: function'), or a cloud in space, whose points are first\n"
         "projected onto a base surface and then take the parameters of their nearest points.\n"
         "'within' bounds every distance, or fails and says where; 'rms' and 'lambda' set how calm\n"
         "the surface is, otherwise cross validation does. 'multilevel' is for very many points.\n"
         "The largest distance and its location are reported, and how many cells between knots\n"
         "hold no point.",
         "features:\n"
         "  soundings: {points: [[0, 0, 1], [4, 0, 2], [0, 3, 1], [4, 3, 0], [2, 1, 2], [1, 2, 1], [3, 2, 1]]}\n"
         "  bed: {fit-scattered: soundings, as: function, rms: 0.1}\n",
         "[Dierckx93], [LWS97]", "batten_surface_scattered", BAT_PARAMETERS(parameters), false,
         .also =
             "point cloud, reverse engineering, multilevel B-splines, Hayes Halliday, terrain",
         .formula =
             "    Σ w_j |S(u_j, v_j) − Q_j|² + λ ∫∫ (S_uu² + 2 S_uv² + S_vv²) du dv → minimum",
         .promise =
             "The sum is least for these knots; with within every distance is bounded or it is refused."},
    .run = run_fit_scattered,
    .beside = "base"};
