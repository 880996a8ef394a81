/* Sections with another parameter, so that what belongs together stands at equal ones. */
#include "base/sort.h"
#include "numeric/halving.h"
#include "numeric/rounding.h"
#include "shape/skin/steps.h"
#include <batten/approximate.h>
#include <batten/local.h>
#include <batten/nearest.h>

#include <stdlib.h>
#include <string.h>

/* ---- a curve after a map of its parameter, by cubics with its points and tangents ---- */

enum { MAX_PIECES = 20000, MAX_HALVINGS = 40 };

/* A curve C(f(s)); without a map f(s) = s. */
typedef struct {
    const batten_curve *curve, *map;
    double tolerance, error;
    int count;               /* pieces */
    double *points, *breaks; /* NULL: they are only counted */
} mapped;

/* The point and the derivative with respect to s. */
static batten_status mapped_at(const mapped *m, double s, batten_side side, double *out)
{
    double f[2] = {s, 1};
    const int d = batten_curve_dimension(m->curve);
    batten_status status = BATTEN_OK;
    if (m->map)
        status = batten_curve_evaluate_side(m->map, s, side, 1, f);
    const batten_interval domain = batten_curve_domain(m->curve);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(
            m->curve, bat_min(domain.b, bat_max(domain.a, f[0])), side, 1, out);
    for (int c = 0; c < d; c++)
        out[d + c] *= f[1];
    return status;
}

/* The cubic over [a, b], Bezier [4][d], and how far it is at three places between. */
static batten_status piece(const mapped *m, double a, double b, double *points, double *error)
{
    const int d = batten_curve_dimension(m->curve);
    double start[6], end[6];
    batten_status status = mapped_at(m, a, BATTEN_FROM_RIGHT, start);
    if (status == BATTEN_OK)
        status = mapped_at(m, b, BATTEN_FROM_LEFT, end);
    for (int c = 0; c < d; c++) {
        points[c] = start[c];
        points[d + c] = start[c] + start[d + c] * (b - a) / 3;
        points[2 * d + c] = end[c] - end[d + c] * (b - a) / 3;
        points[3 * d + c] = end[c];
    }
    *error = 0;
    for (int i = 1; status == BATTEN_OK && i <= 3; i++) {
        double basis[4], here[6], found[3];
        bat_bernstein(3, i / 4.0, 1 - i / 4.0, basis);
        bat_combine(3, basis, (size_t)d, points, found);
        status = mapped_at(m, a + (b - a) * (i / 4.0), BATTEN_FROM_RIGHT, here);
        *error = bat_max(*error, BAT_CUBIC_BETWEEN_3 * bat_distance(d, here, found));
    }
    return status;
}

static void take_piece(mapped *m, double b, const double *points, double error)
{
    const size_t d = (size_t)batten_curve_dimension(m->curve);
    if (m->points) {
        memcpy(m->points + 3 * d * (size_t)m->count, points, 4 * d * sizeof *points);
        m->breaks[m->count + 1] = b;
    }
    m->count++;
    m->error = bat_max(m->error, error);
}

/* [a, b], halved where a cubic is too far off. */
static batten_status map_piece(mapped *m, double a, double b)
{
    bat_halving h = bat_halving_of(a, b, MAX_HALVINGS);
    while (h.waiting > 0) {
        double points[12], error;
        const batten_status status = piece(m, h.a, h.b, points, &error);
        if (status != BATTEN_OK)
            return status;
        if (error <= m->tolerance) {
            take_piece(m, h.b, points, error);
            bat_halving_accept(&h);
        } else if (m->count == MAX_PIECES || !bat_halving_split(&h))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "a section with another parameter is %g off near %g, more than %g",
                            error, h.a, m->tolerance);
    }
    return BATTEN_OK;
}

static batten_status follow_all(mapped *m, int break_count, const double *breaks)
{
    m->count = 0;
    m->error = 0;
    if (m->breaks)
        m->breaks[0] = breaks[0];
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i + 1 < break_count; i++)
        status = map_piece(m, breaks[i], breaks[i + 1]);
    return status;
}

static batten_status make_pieces(mapped *m, int break_count, const double *breaks,
                                 batten_curve **out)
{
    const size_t d = (size_t)batten_curve_dimension(m->curve);
    batten_status status = follow_all(m, break_count, breaks);
    if (status != BATTEN_OK)
        return status;
    m->points = bat_array3(3 * (size_t)m->count + 1, d, sizeof *m->points);
    m->breaks = bat_array((size_t)m->count + 1, sizeof *m->breaks);
    status = m->points && m->breaks ? follow_all(m, break_count, breaks) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier((int)d, (batten_pieces){3, m->count, m->breaks},
                                          m->points, NULL, out);
    bat_release(m->points);
    bat_release(m->breaks);
    return status;
}

int bat_skin_sort_knots(int count, double *breaks)
{
    bat_sort_doubles((size_t)count, breaks);
    const double end = breaks[count - 1], near = BAT_ROUNDING * (end - breaks[0]);
    int kept = 1;
    for (int i = 1; i < count; i++)
        if (breaks[i] - breaks[kept - 1] > near && end - breaks[i] > near)
            breaks[kept++] = breaks[i];
    breaks[kept++] = end;
    return kept;
}

/* The curve after the map, by cubics that break where either has a knot. */
static batten_status compose_maps(const batten_curve *curve, const batten_curve *map,
                                  double tolerance, double *error, batten_curve **out)
{
    mapped m = {.curve = curve, .map = map, .tolerance = tolerance};
    const int own = batten_curve_spans(curve, NULL);
    const int maps = map ? batten_curve_spans(map, NULL) : 0;
    double *knots = bat_array((size_t)own, sizeof *knots);
    double *breaks = bat_array((size_t)(own + maps), sizeof *breaks);
    batten_status status = knots && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, knots);
        count = map ? batten_curve_spans(map, breaks) : 0;
    }
    for (int i = map != NULL; status == BATTEN_OK && i + (map != NULL) < own; i++) {
        batten_parameters at = {0};
        if (map)
            status = batten_curve_crossings(map, 0, knots[i], &at);
        if (status == BATTEN_OK && (!map || at.count > 0))
            breaks[count++] = map ? at.at[0] : knots[i];
        bat_release(at.at);
    }
    if (status == BATTEN_OK) {
        count = bat_skin_sort_knots(count, breaks);
        status = make_pieces(&m, count, breaks, out);
    }
    *error = m.error;
    bat_release(breaks);
    bat_release(knots);
    return status;
}

/* ---- maps ---- */

static batten_status by_arc_length(const batten_curve *curve, double tolerance, double *error,
                                   batten_curve **out)
{
    batten_curve_even_speed_report report;
    batten_curve *even = NULL;
    batten_status status = batten_curve_even_speed(curve, tolerance / 2, &report, &even);
    if (status == BATTEN_OK)
        status = compose_maps(even, NULL, tolerance / 2, error, out);
    if (status == BATTEN_OK)
        *error += report.error;
    batten_curve_unref(even);
    return status;
}

/* The marks of a section in its domain as it begins now, its ends around them: to
 * [mark_count + 2]. */
static batten_status marks_of(const bat_skin *t, int k, double *to)
{
    const int n = t->options->mark_count;
    const batten_interval domain = batten_curve_domain(t->placed[k]);
    to[0] = domain.a;
    to[n + 1] = domain.b;
    for (int j = 0; j < n; j++) {
        double mark = t->options->marks[(size_t)k * (size_t)n + (size_t)j];
        if (t->options->starts && mark < domain.a)
            mark += domain.b - domain.a;
        to[j + 1] = mark;
    }
    for (int j = 0; j <= n; j++)
        if (!(to[j] < to[j + 1]))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "marks do not rise inside section %d: %g and then %g", k + 1, to[j],
                            to[j + 1]);
    return BATTEN_OK;
}

/* Where the marks are put in all sections: in the mean, over [0, 1]. */
static batten_status mean_marks(const bat_skin *t, double *own, double *mean)
{
    const int n = t->options->mark_count;
    int counted = 0;
    for (int k = 0; k < t->count; k++)
        counted += !t->point[k];
    for (int k = 0; k < t->count; k++) {
        const batten_status status = t->point[k] ? BATTEN_OK : marks_of(t, k, own);
        if (status != BATTEN_OK)
            return status;
        for (int j = 0; j < n + 2 && !t->point[k]; j++)
            mean[j] += (own[j] - own[0]) / (own[n + 1] - own[0]) / counted;
    }
    mean[n + 1] = 1;
    return BATTEN_OK;
}

static batten_status by_marks(const bat_skin *t, int k, double *own, double *slopes,
                              const double *mean, double tolerance, double *error,
                              batten_curve **out)
{
    const int n = t->options->mark_count;
    batten_status status = marks_of(t, k, own);
    bool same = true;
    for (int j = 1; j <= n; j++)
        same =
            same && fabs((own[j] - own[0]) / (own[n + 1] - own[0]) - mean[j]) <= BAT_ROUNDING;
    if (status == BATTEN_OK && same) {
        *out = batten_curve_ref(t->placed[k]);
        return BATTEN_OK;
    }
    batten_curve *map = NULL;
    if (status == BATTEN_OK)
        status = batten_slopes(n + 2, mean, own, BATTEN_SLOPE_STEFFEN, slopes);
    if (status == BATTEN_OK) /* the map must stand still nowhere, not even at its ends */
        for (int j = 0; j < n + 2; j += n + 1) {
            const int i = bat_min_int(j, n);
            slopes[j] = bat_max(slopes[j], (own[i + 1] - own[i]) / (mean[i + 1] - mean[i]) / 4);
        }
    if (status == BATTEN_OK)
        status = batten_curve_from_tangents((batten_points){1, n + 2, own}, mean, slopes, NULL,
                                            false, &map);
    if (status == BATTEN_OK)
        status = compose_maps(t->placed[k], map, tolerance, error, out);
    batten_curve_unref(map);
    return status;
}

static batten_status check_match(const bat_skin *t)
{
    const batten_surface_skin_options *o = t->options;
    if (!(o->tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "to match sections by %s a tolerance is needed",
                        o->match == BATTEN_MATCH_MARKS ? "marks" : "arc length");
    if (o->match != BATTEN_MATCH_MARKS)
        return BATTEN_OK;
    if (o->mark_count < 1 || !o->marks)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are no marks to match sections by");
    if (o->align || o->turn)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "sections with marks are taken as they run: they cannot be %s",
                        o->align ? "aligned" : "turned");
    return BATTEN_OK;
}

batten_status bat_skin_match(bat_skin *t)
{
    if (t->options->match == BATTEN_MATCH_PARAMETERS)
        return BATTEN_OK;
    batten_status status = check_match(t);
    if (status != BATTEN_OK)
        return status;
    const bool marks = t->options->match == BATTEN_MATCH_MARKS;
    const size_t n = marks ? (size_t)t->options->mark_count + 2 : 0;
    double *own = bat_array3(3, n, sizeof *own);
    if (own == NULL)
        return BATTEN_OUT_OF_MEMORY;
    double *slopes = own + n, *mean = own + 2 * n;
    if (marks)
        status = mean_marks(t, own, mean);
    for (int k = 0; status == BATTEN_OK && k < t->count; k++) {
        batten_curve *matched = NULL;
        double error = 0;
        if (t->point[k])
            continue;
        status =
            marks
                ? by_marks(t, k, own, slopes, mean, t->options->tolerance / 4, &error, &matched)
                : by_arc_length(t->placed[k], t->options->tolerance / 4, &error, &matched);
        if (status != BATTEN_OK)
            break;
        batten_curve_unref(t->placed[k]);
        t->placed[k] = matched;
        t->moved[k] += error;
    }
    bat_release(own);
    return status;
}
