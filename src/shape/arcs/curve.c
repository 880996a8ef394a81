/* A curve as few arcs: from corner to corner the longest that stays in the band, and again. */
#include "base/plural.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "shape/arcs/curve_report.h"
#include "shape/arcs/smooth_arcs.h"
#include <batten/curvature.h>

#include <limits.h>

/* ---- one arc or biarc ---- */

/* The node at u of the piece: at its ends on the curve, unless it closes smoothly; else in the
 * middle of the band. */
static batten_status node_at(const bat_arc_fit *t, double u, bat_node *node)
{
    double row[4];
    const batten_status status =
        bat_arcs_direction(t->path, u, u == t->to ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, row);
    if (status != BATTEN_OK)
        return status;
    const bool held = (u == t->from || u == t->to) && !t->path->smooth_seam;
    const double off = held ? 0 : t->band.middle;
    node->direction[0] = row[2];
    node->direction[1] = row[3];
    node->point[0] = row[0] - off * row[3];
    node->point[1] = row[1] + off * row[2];
    return BATTEN_OK;
}

typedef struct {
    bat_arcs_part part;
    bat_node end;
    double share; /* of the band that it takes, BAT_ARCS_REFUSED when there is no arc */
} trial;

static bat_arcs_stretch stretch_between(const bat_arc_fit *t, const bat_node *a,
                                        const bat_node *b)
{
    return (bat_arcs_stretch){
        a, b, bat_arcs_turn(&t->samples), t->options.least_radius, &t->band, &t->samples};
}

/* The part over a range that begins at the node a. */
static batten_status try_part(bat_arc_fit *t, const bat_node *a, batten_interval over,
                              trial *out)
{
    *out = (trial){.part = {.from = over.a, .to = over.b}, .share = BAT_ARCS_REFUSED};
    batten_status status = bat_arcs_take(t->path, over, 4, 16, &t->samples);
    if (status == BATTEN_OK)
        status = node_at(t, over.b, &out->end);
    if (status != BATTEN_OK)
        return status;
    batten_biarc *biarc = &out->part.biarc;
    const bat_arcs_stretch on = stretch_between(t, a, &out->end);
    if (fabs(on.turn) > BAT_PI * (1 + 1e-9))
        return BATTEN_OK;
    bat_beside beside;
    if (!(t->joined == BATTEN_ARCS_BIARCS ? bat_arcs_biarc : bat_arcs_single)(&on, biarc))
        return BATTEN_OK;
    status = bat_arcs_measure(t->path, biarc, &t->samples, &beside);
    out->share = bat_band_share(&t->band, &beside, t->slack);
    return status;
}

/* Where plain arcs are nearly straight, lines. */
static batten_status prefer_line(bat_arc_fit *t, const bat_node *a, const bat_node *b,
                                 bat_arcs_part *part)
{
    batten_biarc line;
    bat_beside beside;
    if (t->joined != BATTEN_ARCS_PLAIN)
        return BATTEN_OK;
    const batten_interval over = {part->from, part->to};
    batten_status status = bat_arcs_take(t->path, over, 4, 16, &t->samples);
    bat_arcs_line(a, b, &line);
    if (status == BATTEN_OK)
        status = bat_arcs_measure(t->path, &line, &t->samples, &beside);
    if (status == BATTEN_OK && bat_band_share(&t->band, &beside, t->slack) <= 1)
        part->biarc = line;
    return status;
}

static batten_status nothing_fits(const bat_arc_fit *t, double u)
{
    batten_curve_local local = {.curvature = 0};
    char radii[BAT_RADII_TEXT];
    const batten_status status =
        batten_curve_local_at(t->path->curve, u, BATTEN_FROM_RIGHT, &local);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    bat_arcs_of_least_radius(t->options.least_radius, radii);
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "at %g, where the radius is %g, no arcs%s stay within a band %g wide", u,
                    1 / fabs(local.curvature), radii, t->band.high - t->band.low);
}

/* A search for the longest part: the farthest end that was good, the nearest that was not. */
typedef struct {
    double from, good, bad;
    double good_share; /* of the band */
} reached;

static bool is_long_enough(const bat_arc_fit *t, const reached *r)
{
    const double good = r->good, bad = r->bad;
    return good == t->to || (isfinite(bad) && good > r->from &&
                             (bad - good <= 1e-3 * (good - r->from) || r->good_share > 0.998));
}

/* Where to end next, after an end at u took a share of the band: errors grow by the third
 * power. */
static double next_end(const bat_arc_fit *t, const reached *r, double u, double share)
{
    const double from = r->from, good = r->good, bad = r->bad;
    const double factor =
        share < BAT_ARCS_REFUSED ? bat_cbrt(0.9997 / bat_max(share, 1e-6)) : 0.5;
    const double wanted = from + (u - from) * factor;
    if (isinf(bad))
        return bat_min(t->to, bat_max(wanted, from + 1.1 * (good - from)));
    const double margin = 1e-4 * (bad - good);
    return wanted > good + margin && wanted < bad - margin ? wanted : good + (bad - good) / 2;
}

/* The longest part from a: between a step that is good and one that is not. *reach: how far it
 * would have gone with all of the band. */
static batten_status longest(bat_arc_fit *t, const bat_node *a, double from, trial *best,
                             double *reach)
{
    reached r = {from, from, HUGE_VAL, 0};
    double u = bat_min(t->to, from + t->guess);
    for (int i = 0; i < 200; i++) {
        trial tried;
        const batten_status status = try_part(t, a, (batten_interval){from, u}, &tried);
        if (status != BATTEN_OK)
            return status;
        if (tried.share <= 1) {
            r.good = u;
            r.good_share = tried.share;
            *best = tried;
        } else {
            r.bad = u;
        }
        if (is_long_enough(t, &r))
            break;
        u = next_end(t, &r, u, tried.share);
        if (!(u > from) || (isfinite(r.bad) && r.bad - from <= 1e-9 * (t->to - t->from)))
            return nothing_fits(t, from);
    }
    if (!(r.good > from))
        return nothing_fits(t, from);
    *reach = r.good_share > 0 ? (r.good - from) * bat_cbrt(1 / r.good_share) : HUGE_VAL;
    t->guess = r.good - from;
    return BATTEN_OK;
}

static batten_status greedy(void *context, double tolerance, int *count, double *last)
{
    bat_arc_fit *t = context;
    double u = t->from, reach = 0;
    bat_node a;
    t->band = bat_band_of(t->side, tolerance);
    t->list.count = t->first;
    t->guess = t->to - t->from;
    batten_status status = node_at(t, u, &a);
    while (status == BATTEN_OK && u < t->to) {
        trial best;
        const double from = u;
        status = longest(t, &a, u, &best, &reach);
        if (status == BATTEN_OK)
            status = prefer_line(t, &a, &best.end, &best.part);
        if (status == BATTEN_OK)
            status = bat_arcs_list_add(&t->list, &best.part);
        if (status == BATTEN_OK)
            status = bat_arcs_step(t, best.part.to);
        if (status != BATTEN_OK)
            return status;
        u = best.part.to;
        a = best.end;
        *last = bat_min(1, (u - from) / reach);
    }
    *count = t->list.count - t->first;
    return status;
}

/* ---- arcs that are tangent to one another ---- */

/* Plain arcs tell how long arcs are; they stand in the list for a while. */
static batten_status make_guide(bat_arc_fit *t, double tolerance)
{
    int count = 0;
    double last = 1;
    t->joined = BATTEN_ARCS_PLAIN;
    batten_status status = greedy(t, tolerance, &count, &last);
    t->joined = BATTEN_ARCS_BIARCS;
    t->guide.count = 0;
    for (int i = t->first; i < t->list.count && status == BATTEN_OK; i++)
        status = bat_arcs_list_add(&t->guide, &t->list.parts[i]);
    t->list.count = t->first;
    return status;
}

static int arcs_of(const bat_arc_fit *t)
{
    int arcs = 0;
    for (int i = t->first; i < t->list.count; i++)
        arcs += t->list.parts[i].biarc.count;
    return arcs;
}

/* No arcs at all when the search finds none. */
static batten_status fewest(void *context, double tolerance, int *count, double *last)
{
    bat_arc_fit *t = context;
    batten_status status = make_guide(t, tolerance);
    const bat_arcs_smooth smooth = {.path = t->path,
                                    .from = t->from,
                                    .to = t->to,
                                    .band = t->band,
                                    .slack = t->slack,
                                    .least_radius = t->options.least_radius,
                                    .guide = &t->guide,
                                    .enough = t->enough,
                                    .samples = &t->samples,
                                    .work = &t->work};
    if (status == BATTEN_OK)
        status = bat_arcs_smooth_run(&smooth, &t->list);
    *count = arcs_of(t) > 0 ? arcs_of(t) : INT_MAX;
    *last = 1;
    return status;
}

/* The fewest, unless biarcs with the directions of the curve are no more. */
static batten_status run_smooth(bat_arc_fit *t)
{
    const double tolerance = t->options.tolerance;
    int count = 0, arcs = INT_MAX;
    double last = 1;
    t->joined = BATTEN_ARCS_BIARCS;
    t->enough = 0;
    batten_status status = greedy(t, tolerance, &count, &last);
    const int biarcs = status == BATTEN_OK ? arcs_of(t) : INT_MAX;
    if (status == BATTEN_OK ? biarcs > 2 : status == BATTEN_TOLERANCE_NOT_MET)
        status = fewest(t, tolerance, &arcs, &last);
    if (status != BATTEN_OK)
        return status;
    if (arcs == INT_MAX && biarcs == INT_MAX)
        return nothing_fits(t, t->from);
    t->enough = arcs;
    return bat_arcs_spread(arcs < biarcs ? fewest : greedy, t, tolerance, t->options.spread);
}

/* A whole circle as its halves; else one arc through its middle. */
static batten_status try_whole(bat_arc_fit *t, bool *done)
{
    const bat_arcs_path *p = t->path;
    bat_node a, b;
    bat_beside beside;
    bat_arcs_part part = {.from = t->from, .to = t->to};
    t->band = bat_band_of(t->side, t->options.tolerance);
    const batten_interval over = {t->from, t->to};
    batten_status status = bat_arcs_take(p, over, 4, 24, &t->samples);
    if (status == BATTEN_OK)
        status = node_at(t, t->from, &a);
    if (status == BATTEN_OK)
        status = node_at(t, t->to, &b);
    if (status != BATTEN_OK || p->smooth_seam)
        return status;
    const bat_arcs_stretch on = stretch_between(t, &a, &b);
    if (!bat_arcs_single(&on, &part.biarc))
        return BATTEN_OK;
    status = bat_arcs_measure(p, &part.biarc, &t->samples, &beside);
    if (status != BATTEN_OK || bat_band_share(&t->band, &beside, t->slack) > 1)
        return status;
    status = prefer_line(t, &a, &b, &part);
    *done = status == BATTEN_OK;
    return status == BATTEN_OK ? bat_arcs_list_add(&t->list, &part) : status;
}

static batten_status run_piece(bat_arc_fit *t)
{
    bool done = false;
    t->first = t->list.count;
    batten_status status = bat_arcs_keep(t->path, (batten_interval){t->from, t->to},
                                         t->options.least_radius, &t->list, &done);
    if (status == BATTEN_OK && !done)
        status = try_whole(t, &done);
    if (status != BATTEN_OK || done)
        return status;
    if (t->options.joined == BATTEN_ARCS_SMOOTH)
        return run_smooth(t);
    return bat_arcs_spread(greedy, t, t->options.tolerance, t->options.spread);
}

/* Inside and outside, as the curve turns. */
static batten_status side_of(const bat_arcs_path *p, const batten_arcs_options *options,
                             bat_samples *samples, batten_arcs_side *side)
{
    *side = options->side;
    if (*side != BATTEN_ARCS_INSIDE && *side != BATTEN_ARCS_OUTSIDE)
        return BATTEN_OK;
    if (!p->closed)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve that is not closed has no inside");
    const batten_status status = bat_arcs_take(p, p->domain, 8, 64, samples);
    double area = 0;
    for (int i = 0; status == BATTEN_OK && i + 1 < samples->count; i++) {
        const double *o = samples->rows[0], *a = samples->rows[i], *b = samples->rows[i + 1];
        area += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    const bool inside_is_left = area > 0;
    *side = inside_is_left == (options->side == BATTEN_ARCS_INSIDE) ? BATTEN_ARCS_LEFT
                                                                    : BATTEN_ARCS_RIGHT;
    return status;
}

static batten_status run_all(bat_arc_fit *t, batten_arcs_report *report, batten_chain **out)
{
    const bat_arcs_path *p = t->path;
    t->joined = t->options.joined;
    batten_status status = side_of(p, &t->options, &t->samples, &t->side);
    for (int i = 0; i + 1 < p->corner_count && status == BATTEN_OK; i++) {
        t->from = p->corners[i];
        t->to = p->corners[i + 1];
        status = run_piece(t);
    }
    if (status == BATTEN_OK)
        status = bat_arcs_report_errors(t, report);
    if (status == BATTEN_OK)
        status = bat_arcs_chain(
            &t->list, &(bat_arcs_chain_task){&t->options, p->closed, p->scale}, report, out);
    return status;
}

batten_status batten_arcs_from_curve(const batten_curve *curve,
                                     const batten_arcs_options *options,
                                     batten_arcs_report *report, batten_chain **out)
{
    assert(curve && options && out);
    batten_arcs_options chosen = batten_arcs_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_arcs_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    status = bat_arcs_check(options);
    if (status != BATTEN_OK)
        return status;
    if (batten_curve_dimension(curve) != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the curve has %d dimension%s; arcs are for curves in the plane",
                        batten_curve_dimension(curve),
                        bat_plural(batten_curve_dimension(curve)));
    status = bat_curve_check_size(curve);
    if (status != BATTEN_OK)
        return status;
    bat_arcs_path p;
    batten_arcs_report found = {0};
    status = bat_arcs_path_make(curve, options->corner, &p);
    bat_arc_fit t = {.path = &p, .options = *options, .work = {.job = options->job}};
    t.slack = 32 * DBL_EPSILON * p.scale;
    if (status == BATTEN_OK)
        status = run_all(&t, &found, out);
    if (status == BATTEN_OK && report)
        *report = found;
    bat_arcs_list_end(&t.list);
    bat_arcs_list_end(&t.guide);
    bat_samples_end(&t.samples);
    bat_arcs_path_end(&p);
    return status;
}

batten_status batten_arcs_from_chain(const batten_chain *chain,
                                     const batten_arcs_options *options,
                                     batten_arcs_report *report, batten_chain **out)
{
    assert(chain && options && out);
    batten_arcs_options chosen = batten_arcs_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_arcs_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    status = bat_arcs_check(options);
    batten_curve *curve = NULL;
    double error = 0;
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(chain, options->tolerance / 100, &error, &curve);
    batten_arcs_options rest = *options;
    batten_arcs_report found;
    rest.tolerance -= error;
    if (status == BATTEN_OK)
        status = batten_arcs_from_curve(curve, &rest, &found, out);
    if (status == BATTEN_OK && report) {
        *report = found;
        report->error += error;
        report->sampled += error;
        report->left += error;
        report->right += error;
    }
    batten_curve_unref(curve);
    return status;
}
