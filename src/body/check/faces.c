/* Whether edges lie on the surfaces of their faces; knots that nearly coincide. */
#include "body/check/parts.h"
#include "numeric/vector.h"
#include <batten/nearest.h>

/* As a share of the domain: nearer knots are rarely meant. */
static const double CLOSE = 1e-6;

static bool find_close(const double *knots, int count, double *gap)
{
    *gap = INFINITY;
    for (int i = 1; i < count; i++)
        *gap = bat_min(*gap, (knots[i] - knots[i - 1]) / (knots[count - 1] - knots[0]));
    return *gap < CLOSE;
}

batten_status bat_check_curve_knots(const batten_curve *curve, bool *close, double *gap)
{
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    *close = find_close(knots, count, gap);
    bat_release(knots);
    return BATTEN_OK;
}

static batten_status find_close_in(const batten_surface *surface, batten_direction d,
                                   bool *close, double *gap)
{
    const int count = batten_surface_spans(surface, d, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, d, knots);
    *close = find_close(knots, count, gap);
    bat_release(knots);
    return BATTEN_OK;
}

batten_status bat_check_surface_knots(const batten_surface *surface, bool *close, double *gap)
{
    *close = false;
    for (int k = 0; k < 2 && !*close; k++) {
        const batten_direction d = k == 0 ? BATTEN_U : BATTEN_V;
        const batten_status status = find_close_in(surface, d, close, gap);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* ---- edges beside their faces ---- */

enum { PLACES = 64 }; /* of one edge, at most */

typedef struct {
    int count;
    double at[PLACES];        /* shares of the domain */
    double points[PLACES][3]; /* on the edge */
    double uv[PLACES][2];     /* on its curve in the parameters, if there is one */
} places;

/* The ends, and three places to a span. */
static batten_status put_places(const batten_curve *curve, const batten_curve *flat,
                                const batten_surface *surface, places *out)
{
    const batten_interval d = batten_curve_domain(curve);
    const batten_interval range[2] = {batten_surface_domain(surface, BATTEN_U),
                                      batten_surface_domain(surface, BATTEN_V)};
    out->count = bat_min_int(PLACES, 4 * (batten_curve_spans(curve, NULL) - 1) + 1);
    for (int i = 0; i < out->count; i++) {
        const double share = (double)i / (out->count - 1);
        const double t = share < 1 ? d.a + (d.b - d.a) * share : d.b;
        batten_status status = batten_curve_evaluate(curve, t, 0, out->points[i]);
        if (status == BATTEN_OK && flat) {
            const batten_interval f = batten_curve_domain(flat);
            const double s = share < 1 ? f.a + (f.b - f.a) * share : f.b;
            status = batten_curve_evaluate(flat, s, 0, out->uv[i]);
            for (int k = 0; k < 2; k++)
                out->uv[i][k] = bat_min(bat_max(out->uv[i][k], range[k].a), range[k].b);
        }
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* The largest distance of an edge from the surface: at the parameters where it runs with them,
 * else from the nearest places. */
static batten_status find_miss(const bat_check *check, const batten_body_use *use,
                               const batten_surface *surface, double *miss)
{
    places p;
    const batten_curve *curve = check->parts->edges[use->edge].curve;
    *miss = 0;
    if (!curve)
        return BATTEN_OK;
    batten_status status = put_places(curve, use->parameters, surface, &p);
    if (status == BATTEN_OK && !check->parts->is_traced) {
        batten_deviation deviation;
        status = batten_surface_deviation(surface, (batten_points){3, p.count, p.points[0]},
                                          use->parameters ? p.uv[0] : NULL, check->work.job,
                                          NULL, &deviation);
        if (status == BATTEN_OK)
            *miss = deviation.max;
        return status;
    }
    for (int i = 0; i < p.count && status == BATTEN_OK; i++) {
        double at[3];
        status = batten_surface_evaluate(surface, p.uv[i][0], p.uv[i][1], 0, at);
        if (status == BATTEN_OK)
            *miss = bat_max(*miss, bat_distance(3, at, p.points[i]));
    }
    return status;
}

static batten_status check_use(bat_check *check, int face, const batten_body_use *use)
{
    char name[BAT_CHECK_NAME];
    double miss = 0, gap = 0;
    bool close = false;
    batten_status status = find_miss(check, use, check->parts->faces[face].surface, &miss);
    if (status != BATTEN_OK)
        return status;
    check->faults->largest_miss = bat_max(check->faults->largest_miss, miss);
    if (miss > check->tolerance) {
        check->faults->loose++;
        batten_notes_add(check->notes, "", 0, bat_check_face_name(check, face, name),
                         "edge %d misses its surface by %g units", use->edge + 1, miss);
    }
    if (use->parameters)
        status = bat_check_curve_knots(use->parameters, &close, &gap);
    if (status == BATTEN_OK && close) {
        check->faults->close_knots++;
        batten_notes_add(check->notes, "", 0, bat_check_face_name(check, face, name),
                         "the curve of edge %d in its parameters has knots very near each "
                         "other: %g of the domain",
                         use->edge + 1, gap);
    }
    return status;
}

batten_status bat_check_misses(bat_check *check, int face)
{
    const batten_body_parts *p = check->parts;
    for (int l = p->faces[face].first; l < p->faces[face].first + p->faces[face].count; l++)
        for (int i = 0; i < p->loops[l].count; i++) {
            const batten_status status =
                check_use(check, face, &p->uses[p->loops[l].first + i]);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}
