/* A net of points made fair, as others call it. */
#include "fair/crossed/battens.h"
#include "loft/net/net.h"

/* Above so many points times the square of those along v the programs of least change take
 * minutes. */
static const double most_work = 1e6;

batten_net_fair_options batten_net_fair_defaults(double within)
{
    return (batten_net_fair_options){
        .size = sizeof(batten_net_fair_options), .within = within, .parameters = BATTEN_CHORD};
}

void batten_net_fair_report_release(batten_net_fair_report *report)
{
    batten_fair_report_release(&report->points);
    *report = (batten_net_fair_report){0};
}

/* ---- what is asked ---- */

static batten_status check_bounds(batten_grid points, const batten_net_fair_options *o)
{
    if (!o->within_each) {
        if (!(o->within > 0 && isfinite(o->within)))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the bound is %g; it must be above 0",
                            o->within);
        return BATTEN_OK;
    }
    for (int i = 0; i < points.count_u; i++)
        for (int j = 0; j < points.count_v; j++) {
            const double w = o->within_each[i * points.count_v + j];
            if (!(w >= 0 && isfinite(w)))
                return bat_fail(BATTEN_BAD_ARGUMENT,
                                "the bound of point %d of row %d is %g; it must be 0 or above",
                                i + 1, j + 1, w);
        }
    return BATTEN_OK;
}

static batten_status check_change(batten_grid points, const batten_net_fair_options *o)
{
    const double across = points.count_v;
    if (o->method == BATTEN_NET_FAIR_ENERGY && o->hold > 1)
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "%d rows are to be held at the rim; by energy points are held, and least "
            "change holds tangents and curvatures",
            o->hold);
    if (o->method == BATTEN_NET_FAIR_ENERGY)
        return BATTEN_OK;
    if (o->closed_u || o->closed_v)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the net closes, and least change is for nets with rims: take the "
                        "method of energy");
    if (across * across * across * points.count_u > most_work)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "the net has %d x %d points, and least change takes minutes above 31 x "
                        "31: take the method of energy",
                        points.count_u, points.count_v);
    return BATTEN_OK;
}

static batten_status check_net(batten_grid points, const batten_net_fair_options *o)
{
    if (points.dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the points have %d coordinates, not 3",
                        points.dimension);
    if (points.count_u < BAT_CROSSED_FEWEST || points.count_v < BAT_CROSSED_FEWEST)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "the net has %d x %d points; of fewer than 4 in a row there is nothing "
                        "to fair",
                        points.count_u, points.count_v);
    if ((int)o->method < 0 || o->method > BATTEN_NET_FAIR_LEAST_CHANGE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d of fairing nets",
                        (int)o->method);
    if (o->hold < 0 || o->hold > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d rows are to be held at the rim, not 0 to 3",
                        o->hold);
    if (o->parameters == BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "parameters of nets cannot be given");
    const batten_status status = check_bounds(points, o);
    return status == BATTEN_OK ? check_change(points, o) : status;
}

/* ---- the work ---- */

static double size_of(batten_grid points)
{
    double low[3], high[3];
    const size_t nodes = (size_t)points.count_u * (size_t)points.count_v;
    for (int c = 0; c < 3; c++)
        low[c] = high[c] = points.at[c];
    for (size_t k = 0; k < 3 * nodes; k++) {
        low[k % 3] = bat_min(low[k % 3], points.at[k]);
        high[k % 3] = bat_max(high[k % 3], points.at[k]);
    }
    return bat_distance(3, low, high);
}

/* A point at a rim that does not close. */
static bool is_rim(const bat_fair_net_work *w, int i, int j)
{
    const bool u = !w->options->closed_u && (i == 0 || i == w->given.count_u - 1);
    const bool v = !w->options->closed_v && (j == 0 || j == w->given.count_v - 1);
    return u || v;
}

static void set_bounds(bat_fair_net_work *w)
{
    const batten_net_fair_options *o = w->options;
    for (int i = 0; i < w->given.count_u; i++)
        for (int j = 0; j < w->given.count_v; j++) {
            const int k = i * w->given.count_v + j;
            w->within[k] = o->within_each ? o->within_each[k] : o->within;
            if (o->hold > 0 && is_rim(w, i, j))
                w->within[k] = 0;
            w->largest = bat_max(w->largest, w->within[k]);
        }
}

/* The surface through the net as given, which finds the parameters; a closed net has one more. */
static batten_status begin_work(batten_grid points, const batten_net_fair_options *o,
                                const batten_job *job, bat_fair_net_work *w,
                                batten_surface **surface)
{
    const size_t nu = (size_t)points.count_u, nv = (size_t)points.count_v;
    *w = (bat_fair_net_work){.given = points, .options = o, .job = job};
    w->u = bat_array(nu + 1, sizeof *w->u);
    w->v = bat_array(nv + 1, sizeof *w->v);
    w->within = bat_array3(nu, nv, sizeof *w->within);
    w->centre = bat_array3(nu, nv, 3 * sizeof *w->centre);
    if (!w->u || !w->v || !w->within || !w->centre)
        return BATTEN_OUT_OF_MEMORY;
    const batten_surface_interpolate_options fit = bat_fair_net_fit(o);
    const batten_status status = batten_surface_interpolate(
        points, &fit, NULL, (batten_uv_out){w->u, w->v}, NULL, surface);
    if (status != BATTEN_OK)
        return status;
    w->u[nu] = batten_surface_domain(*surface, BATTEN_U).b;
    w->v[nv] = batten_surface_domain(*surface, BATTEN_V).b;
    w->size = size_of(points);
    memcpy(w->centre, points.at, 3 * nu * nv * sizeof *w->centre);
    set_bounds(w);
    return BATTEN_OK;
}

static void end_work(bat_fair_net_work *w)
{
    bat_release(w->u);
    bat_release(w->v);
    bat_release(w->within);
    bat_release(w->centre);
    bat_release(w->cuts);
}

/* ---- moving ---- */

/* Suspects, and where they are mended, the centres of their bounds. */
static batten_status find_blunders(const bat_fair_net_work *w, const bat_crossed *battens,
                                   bat_fair_tally *tally)
{
    const size_t numbers = 3 * (size_t)w->given.count_u * (size_t)w->given.count_v;
    double *mended = bat_array(numbers, sizeof *mended);
    if (!mended)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(mended, w->given.at, numbers * sizeof *mended);
    const batten_status status = bat_crossed_blunders(battens, mended, tally);
    for (size_t k = 0; k < numbers && status == BATTEN_OK && w->options->mend_blunders; k++)
        if (w->within[k / 3] > 0)
            w->centre[k] = mended[k];
    bat_release(mended);
    return status;
}

static void clip_all(const bat_fair_net_work *w, double *z)
{
    const size_t nodes = (size_t)w->given.count_u * (size_t)w->given.count_v;
    for (size_t k = 0; k < nodes; k++)
        if (w->within[k] > 0)
            bat_clip(3, w->centre + 3 * k, w->within[k], z + 3 * k);
        else
            memcpy(z + 3 * k, w->centre + 3 * k, 3 * sizeof *z);
}

/* What the sections need is what the surface of least energy has. */
static batten_status find_needs(bat_fair_net_work *w, const double *z)
{
    bat_loft_reached reached = {0};
    batten_surface *surface = NULL;
    batten_status status = bat_fair_net_cuts(w);
    if (status == BATTEN_OK)
        status = bat_fair_net_surface(w, z, &surface);
    if (status == BATTEN_OK)
        status = bat_fair_net_judge(w, surface, &reached);
    for (int k = 0; k < w->cut_count; k++)
        w->cuts[k].is_asked = false; /* no other surface is asked */
    batten_surface_unref(surface);
    return status;
}

/* By energy, and from there on by least change where that is asked. */
static batten_status move_within(bat_fair_net_work *w, bat_crossed *battens, double *z,
                                 double *residual)
{
    const size_t numbers = 3 * (size_t)w->given.count_u * (size_t)w->given.count_v;
    memcpy(z, w->centre, numbers * sizeof *z);
    batten_status status = bat_crossed_least(battens, w->job, z, residual);
    clip_all(w, z);
    if (status == BATTEN_OK)
        status = find_needs(w, z);
    if (status == BATTEN_OK && w->options->method == BATTEN_NET_FAIR_LEAST_CHANGE) {
        memcpy(z, w->centre, numbers * sizeof *z);
        status = bat_fair_net_change(w, z);
        clip_all(w, z);
    }
    return status;
}

static batten_status move_points(bat_fair_net_work *w, bat_fair_tally *tally, double *z,
                                 batten_net_fair_report *report)
{
    const bool closed[2] = {w->options->closed_u, w->options->closed_v};
    const size_t numbers = 3 * (size_t)w->given.count_u * (size_t)w->given.count_v;
    batten_fair_report *points = &tally->report;
    bat_crossed battens = {0};
    double *forces = bat_array(numbers, sizeof *forces);
    batten_status status = forces ? bat_crossed_begin(w->given, w->within,
                                                      (batten_uv){w->u, w->v}, closed, &battens)
                                  : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_blunders(w, &battens, tally);
    battens.given = w->centre;
    if (status == BATTEN_OK)
        status = move_within(w, &battens, z, &report->residual);
    if (status == BATTEN_OK)
        status = bat_crossed_bend(&battens, w->given.at, forces, &points->before.energy);
    if (status == BATTEN_OK)
        status = bat_crossed_bend(&battens, z, forces, &points->after.energy);
    bat_crossed_end(&battens);
    bat_release(forces);
    return status;
}

/* ---- the report ---- */

static batten_status judge(const bat_fair_net_work *w, const batten_surface *surface,
                           batten_fairness *fairness, int *in_excess)
{
    bat_loft_reached reached = {0};
    const batten_status status = bat_fair_net_judge(w, surface, &reached);
    if (status != BATTEN_OK)
        return status;
    fairness->inflections = 0;
    for (int k = 0; k < w->cut_count; k++)
        fairness->inflections += w->cuts[k].found;
    fairness->excess_inflections = reached.excess;
    fairness->fair = reached.excess == 0;
    *in_excess = reached.cuts_in_excess;
    return BATTEN_OK;
}

static batten_status tally_points(const bat_fair_net_work *w, const double *z,
                                  bat_fair_tally *tally)
{
    batten_status status = BATTEN_OK;
    for (int j = 0; j < w->given.count_v; j++)
        for (int i = 0; i < w->given.count_u && status == BATTEN_OK; i++) {
            const size_t at = 3 * ((size_t)i * (size_t)w->given.count_v + (size_t)j);
            status = bat_tally_point(tally, 3, j, i, w->given.at + at, z + at);
        }
    return status;
}

/* ---- the whole ---- */

/* What is made of a net. */
typedef struct {
    double *z; /* [count_u][count_v][3] */
    batten_surface *surface;
    bat_fair_tally tally;
    batten_net_fair_report report;
} faired_net;

static batten_status fair_net(bat_fair_net_work *w, const batten_surface *given,
                              faired_net *made)
{
    const size_t numbers = 3 * (size_t)w->given.count_u * (size_t)w->given.count_v;
    batten_net_fair_report *report = &made->report;
    batten_fair_report *points = &made->tally.report;
    made->z = bat_array(numbers, sizeof *made->z);
    batten_status status = made->z ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    points->net = true;
    if (status == BATTEN_OK)
        status = move_points(w, &made->tally, made->z, report);
    if (status == BATTEN_OK)
        status = bat_fair_net_surface(w, made->z, &made->surface);
    if (status == BATTEN_OK)
        status = tally_points(w, made->z, &made->tally);
    if (status == BATTEN_OK)
        status = judge(w, given, &points->before, &report->sections_before);
    if (status == BATTEN_OK)
        status = judge(w, made->surface, &points->after, &report->sections_after);
    report->section_count = w->cut_count;
    report->height = BAT_FAIR_NET_SEEN * w->size;
    return status;
}

static void give_results(faired_net *made, size_t numbers, batten_net_fair_report *report,
                         double *faired, batten_surface **out)
{
    memcpy(faired, made->z, numbers * sizeof *faired);
    if (report) {
        *report = made->report;
        bat_tally_finish(&made->tally, &report->points);
    }
    if (out) {
        *out = made->surface;
        made->surface = NULL;
    }
}

batten_status batten_fair_net(batten_grid points, const batten_net_fair_options *options,
                              const batten_job *job, batten_net_fair_report *report,
                              double *faired, batten_surface **out)
{
    assert(options && faired);
    batten_net_fair_options chosen = batten_net_fair_defaults(0);
    faired_net made = {0};
    bat_fair_net_work work = {0};
    batten_surface *given = NULL;
    batten_status status = BAT_TAKE_OPTIONS(batten_net_fair_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_net(points, &chosen);
    if (status == BATTEN_OK)
        status = begin_work(points, &chosen, job, &work, &given);
    if (status == BATTEN_OK)
        status = fair_net(&work, given, &made);
    if (status == BATTEN_OK)
        give_results(&made, 3 * (size_t)points.count_u * (size_t)points.count_v, report, faired,
                     out);
    bat_tally_end(&made.tally);
    bat_release(made.z);
    batten_surface_unref(made.surface);
    batten_surface_unref(given);
    end_work(&work);
    return status;
}
