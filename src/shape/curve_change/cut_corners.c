/* Where a curve has corners, and the curve with something else in their place. */
#include "shape/curve_change/cut_corners.h"
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"
#include <batten/continuity.h>
#include <batten/extend.h>

/* ---- where they are ---- */

typedef struct {
    int count;
    double *at;
    bool seam; /* the last of them is */
} corner_places;

static batten_status find_places(const batten_curve *curve, corner_places *out)
{
    const batten_curve_continuity_options options = batten_curve_continuity_defaults();
    const double end = batten_curve_domain(curve).b;
    batten_continuities joins = {0, NULL};
    batten_status status = batten_curve_continuity(curve, &options, &joins);
    if (status != BATTEN_OK)
        return status;
    corner_places found = {0, bat_array((size_t)joins.count, sizeof *found.at), false};
    if (!found.at)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < joins.count; i++) {
        if (!(joins.at[i].angle > options.angle))
            continue;
        found.at[found.count++] = joins.at[i].u;
        found.seam = joins.at[i].u == end;
    }
    bat_release(joins.at);
    if (status == BATTEN_OK)
        *out = found;
    return status;
}

batten_status bat_curve_corner_count(const batten_curve *curve, int *count)
{
    corner_places found = {0, NULL, false};
    const batten_status status = find_places(curve, &found);
    bat_release(found.at);
    if (status == BATTEN_OK)
        *count = found.count;
    return status;
}

/* ---- at work ---- */

typedef struct {
    const bat_cutter *cutter;
    int corners, parts;
    int shift;            /* of the numbers of corners, when the curve begins elsewhere now */
    batten_curve **part;  /* [parts], smooth */
    batten_curve **piece; /* [2 parts], what the new curve is made of */
    int pieces;
    double *from, *to;   /* [parts] what is left of each */
    batten_curve **link; /* [corners]; corner k follows part k */
} corner_cutting;

static int number(const corner_cutting *w, int corner)
{
    return (corner + w->shift) % w->corners + 1;
}

static bool reserve_parts(corner_cutting *w, size_t n)
{
    w->part = bat_array(n, sizeof(batten_curve *));
    w->piece = bat_array(2 * n, sizeof(batten_curve *));
    w->link = bat_array(n, sizeof(batten_curve *));
    w->from = bat_array(n, sizeof *w->from);
    w->to = bat_array(n, sizeof *w->to);
    return w->part && w->piece && w->link && w->from && w->to;
}

static batten_status cut_apart(corner_cutting *w, const batten_curve *curve,
                               const corner_places *found)
{
    const batten_interval domain = batten_curve_domain(curve);
    w->corners = found->count;
    batten_status status =
        reserve_parts(w, (size_t)found->count + 1) ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < found->count + !found->seam; k++) {
        w->from[k] = k ? found->at[k - 1] : domain.a;
        w->to[k] = k < found->count ? found->at[k] : domain.b;
        status = batten_curve_subrange(curve, w->from[k], w->to[k], &w->part[k]);
        w->parts += status == BATTEN_OK;
    }
    return status;
}

/* Says which corner cannot be cut, and where the curve behind it begins. */
static batten_status refuse_corner(batten_status status, int number, const batten_curve *behind)
{
    double p[3] = {0};
    if (status == BATTEN_OUT_OF_MEMORY ||
        batten_curve_evaluate(behind, batten_curve_domain(behind).a, 0, p) != BATTEN_OK)
        return status;
    return bat_fail(status, "corner %d at (%g, %g, %g): %s", number, p[0], p[1], p[2],
                    batten_message());
}

static batten_status cut_corner(corner_cutting *w, int k)
{
    const int next = (k + 1) % w->parts;
    const bat_corner corner = {number(w, k) - 1, w->part[k], w->part[next]};
    bat_corner_cut cut = {{w->to[k], w->from[next]}, NULL};
    const batten_status status = w->cutter->cut(w->cutter->context, &corner, &cut);
    if (status != BATTEN_OK)
        return refuse_corner(status, number(w, k), corner.behind);
    w->to[k] = cut.u[0];
    w->from[next] = cut.u[1];
    w->link[k] = cut.link;
    return BATTEN_OK;
}

/* What is left of a part, unless the cuts took all of it. */
static batten_status take_part(corner_cutting *w, int k)
{
    const batten_interval domain = batten_curve_domain(w->part[k]);
    const double rounding = BAT_ROUNDING * (domain.b - domain.a);
    if (w->to[k] - w->from[k] < -rounding)
        return bat_fail(
            BATTEN_NOT_FOUND,
            "corners %d and %d want the same part of the curve between them: one up "
            "to u = %.17g, the other from u = %.17g",
            number(w, (k + w->corners - 1) % w->corners), number(w, k), w->from[k], w->to[k]);
    if (w->to[k] - w->from[k] <= rounding)
        return BATTEN_OK;
    const batten_status status =
        batten_curve_subrange(w->part[k], w->from[k], w->to[k], &w->piece[w->pieces]);
    w->pieces += status == BATTEN_OK;
    return status;
}

static batten_status cut_and_join(corner_cutting *w, batten_curve **out)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < w->corners; k++)
        status = cut_corner(w, k);
    for (int k = 0; status == BATTEN_OK && k < w->parts; k++) {
        status = take_part(w, k);
        if (status == BATTEN_OK && k < w->corners && w->link[k])
            w->piece[w->pieces++] = batten_curve_ref(w->link[k]);
    }
    return status == BATTEN_OK
               ? bat_curves_chain(w->pieces, w->piece, w->cutter->tolerance, out)
               : status;
}

static void release_curves(int count, batten_curve **curves)
{
    for (int k = 0; curves && k < count; k++)
        batten_curve_unref(curves[k]);
    bat_release(curves);
}

static void end_walk(corner_cutting *w)
{
    release_curves(w->parts, w->part);
    release_curves(w->pieces, w->piece);
    release_curves(w->corners, w->link);
    bat_release(w->from);
    bat_release(w->to);
}

/* A closed curve begins at a corner, so that no part goes over the seam. */
static batten_status begin_at_corner(const batten_curve *curve, corner_places *found,
                                     int *shift, batten_curve **out)
{
    const double gap = 1e-6 * bat_curve_size(curve);
    *shift = 0;
    if (found->count == 0 || found->seam || !batten_curve_is_closed(curve, gap)) {
        *out = batten_curve_ref(curve);
        return BATTEN_OK;
    }
    batten_curve *turned = NULL;
    corner_places again = {0, NULL, false};
    batten_status status = batten_curve_trim(curve, found->at[0], found->at[0], gap, &turned);
    if (status == BATTEN_OK)
        status = find_places(turned, &again);
    if (status == BATTEN_OK) {
        bat_release(found->at);
        *found = again;
        *shift = 1;
        *out = turned;
    } else {
        batten_curve_unref(turned);
    }
    return status;
}

batten_status bat_curve_cut_corners(const batten_curve *curve, const bat_cutter *cutter,
                                    batten_curve **out)
{
    corner_cutting w = {.cutter = cutter};
    corner_places found = {0, NULL, false};
    batten_curve *begun = NULL;
    batten_status status = find_places(curve, &found);
    if (status == BATTEN_OK)
        status = begin_at_corner(curve, &found, &w.shift, &begun);
    if (status == BATTEN_OK && found.count == 0) {
        *out = batten_curve_ref(curve);
    } else if (status == BATTEN_OK) {
        status = cut_apart(&w, begun, &found);
        if (status == BATTEN_OK)
            status = cut_and_join(&w, out);
        end_walk(&w);
    }
    batten_curve_unref(begun);
    bat_release(found.at);
    return status;
}
