/* Where the offset of a surface turns over: principal curvatures sampled, and the extreme ones
 * refined by a search with halved steps. */
#include "shape/surface_change/offset.h"

#include "numeric/vector.h"
#include <batten/curvature.h>

enum { LEAST_SAMPLES = 4, MOST_SAMPLES = 400, HALVINGS = 30, MOST_MOVES = 400 };

/* The samples of one direction: a little inside of each span, so that curvatures that jump at
 * knots are seen from both sides. */
typedef struct {
    int count;
    double *at, *step; /* [count]; the steps are the distances of neighbours */
} samples;

typedef struct {
    const batten_surface *surface;
    double distance;
    samples lines[2];
    double area;            /* the largest |Su x Sv| among samples */
    batten_status *failure; /* OUT_OF_MEMORY where curvatures could not be had for that */
} search;

static batten_status lay_samples(const batten_surface *surface, batten_direction direction,
                                 samples *out)
{
    const int spans = batten_surface_spans(surface, direction, NULL) - 1;
    const int wanted =
        bat_max_int(LEAST_SAMPLES, batten_surface_degree(surface, direction) + 1);
    const int each = bat_max_int(1, bat_min_int(wanted, MOST_SAMPLES / bat_max_int(1, spans)));
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    out->at = bat_array3((size_t)spans, (size_t)each + 1, sizeof *out->at);
    out->step = bat_array3((size_t)spans, (size_t)each + 1, sizeof *out->step);
    const bool ready = breaks && out->at && out->step;
    if (ready)
        batten_surface_spans(surface, direction, breaks);
    for (int s = 0; ready && s < spans; s++) {
        const double a = breaks[s], width = breaks[s + 1] - a;
        /* Just inside the span, so that one-sided curvatures are those of its own piece. */
        for (int i = 0; i <= each; i++) {
            const double t = bat_max(1e-9, bat_min(1 - 1e-9, (double)i / each));
            out->at[out->count] = bat_min(a + t * width, breaks[s + 1]);
            out->step[out->count++] = width / each;
        }
    }
    bat_release(breaks);
    return ready ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static double area_at(const search *s, double u, double v)
{
    double values[9];
    if (batten_surface_evaluate(s->surface, u, v, 1, values) != BATTEN_OK)
        return 0;
    const double lu = bat_norm(3, values + 3), lv = bat_norm(3, values + 6);
    if (!(lu > 0 && lv > 0))
        return 0;
    const batten_vec3 a = bat_vec3_scale(bat_vec3_of(3, values + 3), 1 / lu);
    const batten_vec3 b = bat_vec3_scale(bat_vec3_of(3, values + 6), 1 / lv);
    return lu * lv * bat_vec3_norm(bat_vec3_cross(a, b));
}

/* False where the tangents span no plane, or next to such a place, where curvatures are
 * roundoff. */
static bool curvatures_at(const search *s, double u, double v, double kappa[2])
{
    batten_surface_local local;
    if (!(area_at(s, u, v) > 1e-4 * s->area))
        return false;
    const batten_status status = batten_surface_local_at(s->surface, u, v, &local);
    if (status == BATTEN_OUT_OF_MEMORY)
        *s->failure = status;
    if (status != BATTEN_OK)
        return false;
    kappa[0] = local.kappa1;
    kappa[1] = local.kappa2;
    return isfinite(kappa[0]) && isfinite(kappa[1]);
}

/* Which is searched for its least value: -kappa1, kappa2, the factor. */
static double value_of(const search *s, int which, const double kappa[2])
{
    if (which < 2)
        return which == 0 ? -kappa[0] : kappa[1];
    return bat_min(1 - s->distance * kappa[0], 1 - s->distance * kappa[1]);
}

/* From a sample downhill, by steps that are halved when no neighbour is lower. */
static double descend_to_extreme(const search *s, int which, double value, double at[2],
                                 double step[2])
{
    static const double moves[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int moved = 0;
    for (int h = 0; h < HALVINGS && moved < MOST_MOVES;) {
        bool lower = false;
        for (int m = 0; m < 4; m++) {
            double to[2], kappa[2];
            for (int k = 0; k < 2; k++) {
                const batten_interval domain =
                    batten_surface_domain(s->surface, (batten_direction)k);
                to[k] = bat_max(domain.a, bat_min(domain.b, at[k] + moves[m][k] * step[k]));
            }
            if (!curvatures_at(s, to[0], to[1], kappa) || !(value_of(s, which, kappa) < value))
                continue;
            value = value_of(s, which, kappa);
            at[0] = to[0];
            at[1] = to[1];
            lower = true;
            moved++;
        }
        if (lower)
            continue;
        step[0] /= 2;
        step[1] /= 2;
        h++;
    }
    return value;
}

static void include(batten_interval *interval, double at)
{
    interval->a = bat_min(interval->a, at);
    interval->b = bat_max(interval->b, at);
}

/* All samples; the places of the least values, and the box where the factor is not above 0. */
static bool sample(const search *s, double least[3], int place[3][2],
                   batten_surface_offset_report *report)
{
    bool any = false;
    for (int i = 0; i < s->lines[0].count; i++)
        for (int j = 0; j < s->lines[1].count; j++) {
            const double u = s->lines[0].at[i], v = s->lines[1].at[j];
            double kappa[2];
            if (!curvatures_at(s, u, v, kappa))
                continue;
            any = true;
            for (int w = 0; w < 3; w++)
                if (value_of(s, w, kappa) < least[w]) {
                    least[w] = value_of(s, w, kappa);
                    place[w][0] = i;
                    place[w][1] = j;
                }
            if (value_of(s, 2, kappa) <= 0) {
                include(&report->turned[0], u);
                include(&report->turned[1], v);
            }
        }
    return any;
}

static void refine_extremes(const search *s, double least[3], int place[3][2],
                            batten_surface_offset_report *report)
{
    for (int w = 0; w < 3; w++) {
        double at[2], step[2];
        for (int k = 0; k < 2; k++) {
            at[k] = s->lines[k].at[place[w][k]];
            step[k] = s->lines[k].step[place[w][k]] / 2;
        }
        least[w] = descend_to_extreme(s, w, least[w], at, step);
        if (w < 2)
            continue;
        report->at[0] = at[0];
        report->at[1] = at[1];
        if (least[w] <= 0) {
            include(&report->turned[0], at[0]);
            include(&report->turned[1], at[1]);
        }
    }
    report->most = -least[0];
    report->least = least[1];
    report->factor = least[2];
}

batten_status bat_offset_curvatures(const batten_surface *surface, double distance,
                                    batten_surface_offset_report *report)
{
    batten_status failure = BATTEN_OK;
    search s = {.surface = surface, .distance = distance, .failure = &failure};
    double least[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    int place[3][2] = {{0}};
    for (int k = 0; k < 2; k++)
        report->turned[k] = (batten_interval){HUGE_VAL, -HUGE_VAL};
    batten_status status = lay_samples(surface, BATTEN_U, &s.lines[0]);
    if (status == BATTEN_OK)
        status = lay_samples(surface, BATTEN_V, &s.lines[1]);
    if (status == BATTEN_OK) {
        for (int i = 0; i < s.lines[0].count; i++)
            for (int j = 0; j < s.lines[1].count; j++)
                s.area = bat_max(s.area, area_at(&s, s.lines[0].at[i], s.lines[1].at[j]));
        if (sample(&s, least, place, report))
            refine_extremes(&s, least, place, report);
        else
            status = bat_fail(BATTEN_SINGULAR_HERE,
                              "the surface has no normal at any of %d places: it is a curve or "
                              "a point, or its numbers are too large or too small",
                              s.lines[0].count * s.lines[1].count);
    }
    if (failure != BATTEN_OK)
        status = failure;
    for (int k = 0; k < 2; k++) {
        bat_release(s.lines[k].at);
        bat_release(s.lines[k].step);
    }
    return status;
}
