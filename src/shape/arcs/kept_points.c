/* What a curve already has of lines and arcs stays as it is. */
#include "numeric/vector.h"
#include "shape/arcs/exact_arcs.h"
#include "shape/arcs/path.h"

/* Where the direction jumps by more, arcs are to round the curve off: the usual corner. */
static const double kink = 1e-6;

static bool goes_on(const batten_span *a, const batten_span *b)
{
    return fabs(remainder(b->angle - a->angle - a->curvature[0] * a->length, 2 * BAT_PI)) <=
           kink;
}

static bool wide_enough(const batten_span *arc, double least_radius)
{
    return fabs(arc->curvature[0]) * least_radius <= 1 + 1e-12;
}

typedef struct {
    const bat_arcs_path *path;
    double from, to, tolerance, least_radius;
    int first; /* of the run in the list */
    bat_arcs_list *list;
} point_run;

/* One more, or a longer last one, up to `to`; false when it cannot stay. */
static batten_status extend_or_add_span(point_run *r, const batten_span *arc, double to,
                                        bool *kept)
{
    bat_arcs_list *list = r->list;
    bat_arcs_part part = {.from = r->from, .to = to, .biarc = {.count = 1, .place = 0.5}};
    part.biarc.arcs[0] = *arc;
    if (list->count > r->first) {
        bat_arcs_part *last = &list->parts[list->count - 1];
        *kept = goes_on(&last->biarc.arcs[0], arc);
        if (*kept && bat_exact_merge(&last->biarc.arcs[0], arc, r->tolerance)) {
            last->to = to;
            return BATTEN_OK;
        }
        part.from = last->to;
    }
    *kept = *kept && wide_enough(arc, r->least_radius);
    return *kept ? bat_arcs_list_add(list, &part) : BATTEN_OK;
}

static batten_status add_piece(point_run *r, int knot, bool *kept)
{
    double rows[BAT_MAX_ROWS];
    bat_exact found;
    const bat_piece piece = bat_curve_piece(r->path->curve, knot, rows);
    *kept = piece.a >= r->from && piece.b <= r->to &&
            bat_exact_piece(r->path->curve, &piece, r->tolerance, &found);
    batten_status status = BATTEN_OK;
    for (int i = 0; *kept && i < found.count && status == BATTEN_OK; i++)
        status = extend_or_add_span(
            r, &found.arcs[i],
            i + 1 < found.count ? piece.a + (piece.b - piece.a) / 2 : piece.b, kept);
    return status;
}

batten_status bat_arcs_keep(const bat_arcs_path *path, batten_interval run, double least_radius,
                            bat_arcs_list *list, bool *kept)
{
    const double from = run.a, to = run.b;
    const batten_curve *curve = path->curve;
    const double *U = curve->knots;
    point_run r = {path, from, to, bat_exact_tolerance(curve), least_radius, list->count, list};
    batten_status status = BATTEN_OK;
    bool keep = true;
    for (int k = curve->degree; k < curve->count && keep && status == BATTEN_OK; k++)
        if (U[k] < U[k + 1] && U[k + 1] > from && U[k] < to)
            status = add_piece(&r, k, &keep);
    if (keep && status == BATTEN_OK && path->smooth_seam)
        keep = goes_on(&list->parts[list->count - 1].biarc.arcs[0],
                       &list->parts[r.first].biarc.arcs[0]);
    if (!keep || status != BATTEN_OK)
        list->count = r.first;
    *kept = keep;
    return status;
}
