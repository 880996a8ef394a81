#include "shape/skin.h"
#include "numeric/vector.h"
#include "spline/curve.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

batten_skin_options batten_skin_defaults(void)
{
    return (batten_skin_options){
        .size = sizeof(batten_skin_options), .degree = 3, .parameters = BATTEN_CENTRIPETAL};
}

/* One skin on its way. */
typedef struct {
    int count; /* sections */
    const batten_skin_options *options;
    bat_work work;
    batten_curve **placed;  /* [count] where they stand, in one dimension, run the same way */
    batten_curve **unified; /* [count] with common knots */
    double *deviation;      /* [count] */
    int dimension, points;  /* of a section; one period of a periodic one */
    size_t width;           /* dimension, one more when rational */
    bool rational, periodic_u;
    double *v;    /* [count + 1] */
    double *rows; /* [count][points][width] homogeneous */
    bat_operator across;
    double *control; /* [across.count][points][width] */
} task;

/* ---- checks ---- */

static batten_status check_end(const batten_skin_options *o, const batten_end *end,
                               const char *name)
{
    if (end->kind == BATTEN_END_NOT_A_KNOT || o->periodic)
        return BATTEN_OK;
    if (end->kind == BATTEN_END_CIRCLE || end->kind == BATTEN_END_CURVATURE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a skin cannot have a circle or a curvature at its %s", name);
    if (o->degree % 2 == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "conditions at the %s need an odd degree, and it is %d", name,
                        o->degree);
    if (bat_first_not_finite(end->vector, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the vector at the %s is not finite", name);
    if (end->kind == BATTEN_END_DIRECTION && bat_norm(3, end->vector) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the direction at the %s has no length", name);
    return BATTEN_OK;
}

static batten_status check(int count, const batten_skin_options *o)
{
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there are %d sections, and a skin needs 2",
                        count);
    if (count > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %d sections; the limit is %d", count,
                        (int)BAT_MAX_MADE_POINTS);
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree across the sections is %d, not 1 to %d",
                        o->degree, BATTEN_MAX_DEGREE);
    if (!isfinite(o->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", o->tolerance);
    if (o->tolerance < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, below 0", o->tolerance);
    batten_status status = check_end(o, &o->start, "start");
    if (status == BATTEN_OK)
        status = check_end(o, &o->end, "end");
    return status;
}

/* ---- placing and aligning the sections ---- */

static batten_status place(const task *t, const batten_curve *section, const batten_affine *map,
                           batten_curve **out)
{
    batten_curve *raised = NULL;
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(section) == t->dimension)
        raised = batten_curve_ref(section);
    else
        status = batten_curve_to_dimension(section, t->dimension, &raised);
    if (status == BATTEN_OK && map)
        status = batten_curve_transform(raised, map, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(raised);
    batten_curve_unref(raised);
    return status;
}

static batten_status place_all(task *t, const batten_curve *const *sections)
{
    for (int k = 0; k < t->count; k++)
        t->dimension = bat_max_int(t->dimension, batten_curve_dimension(sections[k]));
    batten_affine *maps = NULL;
    batten_status status = BATTEN_OK;
    if (t->options->spine) {
        t->dimension = 3;
        maps = bat_array((size_t)t->count, sizeof *maps);
        status = maps ? bat_skin_places(t->count, t->options, maps) : BATTEN_OUT_OF_MEMORY;
    }
    for (int k = 0; status == BATTEN_OK && k < t->count; k++)
        status = place(t, sections[k], maps ? &maps[k] : NULL, &t->placed[k]);
    bat_release(maps);
    return status;
}

/* Points that tell in which direction a section runs. */
enum { SAMPLES = 17 };

static batten_status sample(const batten_curve *curve, double points[SAMPLES][3])
{
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i < SAMPLES; i++) {
        const double s = (double)i / (SAMPLES - 1);
        const batten_status status =
            batten_curve_evaluate(curve, (1 - s) * domain.a + s * domain.b, 0, points[i]);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

static bool runs_against(int d, double a[SAMPLES][3], double b[SAMPLES][3])
{
    double along = 0, against = 0;
    for (int i = 0; i < SAMPLES; i++) {
        along += bat_distance(d, a[i], b[i]);
        against += bat_distance(d, a[i], b[SAMPLES - 1 - i]);
    }
    return against < along;
}

/* Reverse each section that runs against the one before it, and say so. */
static batten_status align(task *t)
{
    double before[SAMPLES][3], here[SAMPLES][3];
    int reversed_count = 0;
    batten_status status = sample(t->placed[0], before);
    for (int k = 1; status == BATTEN_OK && k < t->count; k++) {
        status = sample(t->placed[k], here);
        if (status == BATTEN_OK && runs_against(t->dimension, before, here)) {
            batten_curve *reversed = NULL;
            status = batten_curve_reverse(t->placed[k], &reversed);
            if (status == BATTEN_OK) {
                batten_curve_unref(t->placed[k]);
                t->placed[k] = reversed;
                status = sample(reversed, here);
                bat_fail(BATTEN_OK, "section %d was reversed, and %d before it", k,
                         reversed_count++);
            }
        }
        memcpy(before, here, sizeof before);
    }
    return status;
}

/* ---- common knots ---- */

static bool all_periodic(const task *t)
{
    bool periodic = true;
    for (int k = 0; k < t->count; k++)
        periodic = periodic && batten_curve_is_periodic(t->placed[k]);
    return periodic;
}

/* A jump of the speed would ask for knots that the shape does not need. */
static batten_status even_speeds(task *t)
{
    for (int k = 0; k < t->count; k++) {
        batten_curve *even = NULL;
        const batten_status status = bat_skin_even_speed(t->placed[k], &even);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(t->placed[k]);
        t->placed[k] = even;
    }
    return BATTEN_OK;
}

static batten_status unify(task *t)
{
    const batten_curve *const *placed = (const batten_curve *const *)t->placed;
    t->periodic_u = all_periodic(t);
    const bool exact = t->periodic_u || t->options->tolerance == 0;
    batten_status status = exact ? BATTEN_OK : even_speeds(t);
    if (status == BATTEN_OK && !exact)
        status = bat_skin_common_knots(t->count, placed, t->options->tolerance, &t->work,
                                       t->unified, t->deviation);
    else if (status == BATTEN_OK)
        status = batten_curves_unify(t->count, placed, t->unified);
    if (status != BATTEN_OK)
        return status;
    const batten_curve *first = t->unified[0];
    t->rational = batten_curve_is_rational(first);
    t->width = (size_t)t->dimension + t->rational;
    t->points =
        batten_curve_point_count(first) - (t->periodic_u ? batten_curve_degree(first) : 0);
    const double size = (double)t->points * (t->count + 2);
    if (size > BAT_MAX_MADE_POINTS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%d sections with %d common control points make a surface of %.3g; the limit is %d",
            t->count, t->points, size, (int)BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}

/* ---- across the sections ---- */

static batten_status fill_rows(task *t)
{
    t->rows = bat_array3((size_t)t->count, (size_t)t->points * t->width, sizeof *t->rows);
    if (!t->rows)
        return BATTEN_OUT_OF_MEMORY;
    const size_t d = (size_t)t->dimension;
    double *row = t->rows;
    for (int k = 0; k < t->count; k++) {
        const double *P = batten_curve_points(t->unified[k]);
        const double *w = batten_curve_weights(t->unified[k]);
        for (int i = 0; i < t->points; i++, row += t->width) {
            for (size_t c = 0; c < d; c++)
                row[c] = (w ? w[i] : 1) * P[(size_t)i * d + c];
            if (w)
                row[d] = w[i];
        }
    }
    return BATTEN_OK;
}

static batten_status find_parameters(task *t)
{
    const size_t d = (size_t)t->dimension, row = (size_t)t->points * d;
    double *points = bat_array3((size_t)t->count, row, sizeof *points);
    t->v = bat_array((size_t)t->count + 1, sizeof *t->v);
    batten_status status = points && t->v ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int k = 0; k < t->count; k++)
            memcpy(points + (size_t)k * row, batten_curve_points(t->unified[k]),
                   row * sizeof *points);
        const bat_family family = {.name = "sections",
                                   .dimension = t->dimension,
                                   .count = t->count,
                                   .lines = t->points,
                                   .point_step = row,
                                   .line_step = d,
                                   .periodic = t->options->periodic,
                                   .points = points,
                                   .given = t->options->given};
        double spread = 0;
        status = bat_family_parametrize(&family, t->options->parameters, t->v, &spread);
    }
    bat_release(points);
    return status;
}

static batten_end_kind linear_kind(batten_end_kind kind)
{
    return kind == BATTEN_END_DIRECTION ? BATTEN_END_CLAMPED : kind;
}

/* What the end asks of each control point: the same derivative of the surface along the whole
 * section, or the same direction with the length of the chord. Weights do not change there. */
static void fill_end(const task *t, const batten_end *end, int here, int next, double *values)
{
    const size_t d = (size_t)t->dimension;
    const double step = fabs(t->v[next] - t->v[here]), length = bat_norm((int)d, end->vector);
    const double *P = batten_curve_points(t->unified[here]),
                 *Q = batten_curve_points(t->unified[next]);
    const double *w = batten_curve_weights(t->unified[here]);
    for (size_t i = 0; i < (size_t)t->points; i++) {
        double factor = w ? w[i] : 1;
        if (end->kind == BATTEN_END_DIRECTION)
            factor *= bat_distance((int)d, P + i * d, Q + i * d) / step / length;
        for (size_t c = 0; c < d; c++)
            values[i * t->width + c] = factor * end->vector[c];
    }
}

static batten_status interpolate_across(task *t)
{
    const batten_skin_options *o = t->options;
    const bat_request request = {.degree = o->degree,
                                 .count = t->count,
                                 .parameters = t->v,
                                 .knots_at_data = o->degree % 2 == 1,
                                 .periodic = o->periodic,
                                 .start = linear_kind(o->start.kind),
                                 .end = linear_kind(o->end.kind)};
    batten_status status = bat_operator_make(&request, &t->across);
    if (status != BATTEN_OK)
        return status;
    const size_t row = (size_t)t->points * t->width;
    double *ends = bat_array3(2, row, sizeof *ends);
    t->control = bat_array3((size_t)t->across.count, row, sizeof *t->control);
    if (!ends || !t->control)
        status = BATTEN_OUT_OF_MEMORY;
    else {
        fill_end(t, &o->start, 0, 1, ends);
        fill_end(t, &o->end, t->count - 1, t->count - 2, ends + row);
        status =
            bat_operator_apply(&t->across, row, t->rows, ends, ends + row, NULL, t->control);
    }
    bat_release(ends);
    return status;
}

/* ---- the surface ---- */

/* From homogeneous rows across to Cartesian points and weights along. */
static batten_status divide(const task *t, double *points, double *weights)
{
    const size_t d = (size_t)t->dimension, across = (size_t)t->across.count;
    for (size_t j = 0; j < across; j++)
        for (size_t i = 0; i < (size_t)t->points; i++) {
            const double *row = t->control + (j * (size_t)t->points + i) * t->width;
            const double weight = t->rational ? row[d] : 1;
            if (!(weight > 0))
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "between the sections the weight of control point (%zu, %zu) "
                                "becomes %g: their "
                                "weights differ too much",
                                i, j, weight);
            for (size_t c = 0; c < d; c++)
                points[(i * across + j) * d + c] = row[c] / weight;
            if (t->rational)
                weights[i * across + j] = weight;
        }
    return BATTEN_OK;
}

/* The first and the last section are the rims to the last bit, so a point stays a pole. */
static void keep_rims(const task *t, double *points, double *weights)
{
    const size_t d = (size_t)t->dimension, across = (size_t)t->across.count;
    for (size_t end = 0; end < 2 && !t->options->periodic; end++) {
        const batten_curve *section = t->unified[end == 0 ? 0 : t->count - 1];
        const size_t j = end == 0 ? 0 : across - 1;
        for (size_t i = 0; i < (size_t)t->points; i++) {
            memcpy(points + (i * across + j) * d, batten_curve_points(section) + i * d,
                   d * sizeof *points);
            if (t->rational)
                weights[i * across + j] = batten_curve_weights(section)[i];
        }
    }
}

static batten_status make_surface(const task *t, batten_surface **surface)
{
    const size_t total = (size_t)t->points * (size_t)t->across.count;
    double *points = bat_array3(total, (size_t)t->dimension, sizeof *points);
    double *weights = bat_array(total, sizeof *weights);
    batten_status status =
        points && weights ? divide(t, points, weights) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const int p = batten_curve_degree(t->unified[0]);
        const double *U = batten_curve_knots(t->unified[0]) + (t->periodic_u ? p : 0);
        const batten_axis u = {p, t->points, U, t->periodic_u};
        const batten_axis v = {t->across.degree, t->across.count, t->across.knots,
                               t->across.periodic};
        keep_rims(t, points, weights);
        status = batten_surface_create(t->dimension, &u, &v, points,
                                       t->rational ? weights : NULL, surface);
    }
    bat_release(weights);
    bat_release(points);
    return status;
}

/* ---- what is true of it ---- */

/* How far the curve runs at u while its parameter is rounded: its knots are moved into [0, 1]
 * by up to 4 eps (max(|a|, |b|) + (b - a)), those of its partners too, and u is computed there
 * and back. */
static batten_status parameter_rounding(const batten_curve *section, double u, double *moved)
{
    const batten_interval domain = batten_curve_domain(section);
    const double end = bat_max(fabs(domain.a), fabs(domain.b));
    const double step = 12 * DBL_EPSILON * (end + (domain.b - domain.a));
    double low[3], high[3];
    batten_status status = batten_curve_evaluate(section, bat_max(domain.a, u - step), 0, low);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(section, bat_min(domain.b, u + step), 0, high);
    if (status == BATTEN_OK)
        *moved = bat_distance(batten_curve_dimension(section), low, high);
    return status;
}

/* The largest distance of a section from its line on the surface, beyond the rounding of its
 * parameters, at the knots and midway between them. */
static batten_status section_distance(const task *t, const batten_surface *surface, int k,
                                      const double *knots, int knot_count, double *worst)
{
    const batten_curve *section = t->placed[k];
    const batten_interval domain = batten_curve_domain(section);
    for (int i = 0; i < 2 * knot_count - 1; i++) {
        const double s = i % 2 == 0 ? knots[i / 2] : (knots[i / 2] + knots[i / 2 + 1]) / 2;
        const double u =
            bat_min(domain.b, bat_max(domain.a, (1 - s) * domain.a + s * domain.b));
        double given[3], found[3], rounding = 0;
        batten_status status = batten_curve_evaluate(section, u, 0, given);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(surface, s, t->v[k], 0, found);
        if (status == BATTEN_OK)
            status = parameter_rounding(section, u, &rounding);
        if (status != BATTEN_OK)
            return status;
        *worst = bat_max(*worst, bat_distance(t->dimension, given, found) - rounding);
    }
    return BATTEN_OK;
}

static batten_status check_sections(const task *t, const batten_surface *surface,
                                    const double *knots, int knot_count)
{
    for (int k = 0; k < t->count; k++) {
        const int n = batten_curve_point_count(t->placed[k]) * t->dimension;
        double worst = 0, size = 0;
        for (int i = 0; i < n; i++)
            size = bat_max(size, fabs(batten_curve_points(t->placed[k])[i]));
        const batten_status status = section_distance(t, surface, k, knots, knot_count, &worst);
        if (status != BATTEN_OK)
            return status;
        const double allowed = t->deviation[k] + 1e-13 * size;
        if (!(worst <= allowed))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "section %d is missed by %g, more than %g", k, worst, allowed);
    }
    return BATTEN_OK;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* @param knots  spoilt: it becomes the sorted spans */
static double span_ratio(double *knots, int knot_count)
{
    const int spans = knot_count - 1;
    for (int i = 0; i < spans; i++)
        knots[i] = knots[i + 1] - knots[i];
    qsort(knots, (size_t)spans, sizeof *knots, by_value);
    return knots[0] / knots[spans / 2];
}

/* The angle between the normals on both sides of the knot line u at v; 0 where one of them
 * vanishes. */
static batten_status normal_jump(const batten_surface *surface, double u, double v,
                                 double *worst)
{
    batten_vec3 normal[2];
    for (int side = 0; side < 2; side++) {
        double out[9];
        const batten_status status = batten_surface_evaluate_side(
            surface, u, v, side == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT,
            1, out);
        if (status != BATTEN_OK)
            return status;
        normal[side] = bat_vec3_cross(bat_vec3_of(3, out + 3), bat_vec3_of(3, out + 6));
    }
    const double sine = bat_vec3_norm(bat_vec3_cross(normal[0], normal[1]));
    *worst = bat_max(*worst, atan2(sine, bat_vec3_dot(normal[0], normal[1])));
    return BATTEN_OK;
}

/* Only knots that stand p times or more can have a jump of the normal; it is looked for at 33
 * places of each. */
static batten_status find_normal_jump(const task *t, const batten_surface *surface,
                                      const double *knots, int knot_count, double *worst)
{
    const batten_curve *first = t->unified[0];
    const int p = batten_curve_degree(first), n = batten_curve_point_count(first);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    batten_status status = BATTEN_OK;
    for (int i = 1; i + 1 < knot_count && t->dimension == 3; i++) {
        if (bat_knots_multiplicity(p, n, batten_curve_knots(first), knots[i]) < p)
            continue;
        for (int j = 0; status == BATTEN_OK && j <= 32; j++)
            status = normal_jump(surface, knots[i], v.a + (v.b - v.a) * (j / 32.0), worst);
    }
    return status;
}

/* Distinct inner knots of all sections, those within rounding taken as one. */
static batten_status count_exact(const task *t, int *count)
{
    size_t total = 0, used = 0;
    for (int k = 0; k < t->count; k++)
        total += (size_t)batten_curve_spans(t->placed[k], NULL);
    double *knots = bat_array(total, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < t->count; k++) {
        const int own = batten_curve_spans(t->placed[k], knots + used);
        const batten_interval domain = batten_curve_domain(t->placed[k]);
        for (int i = 1; i + 1 < own; i++) /* the ends are not counted */
            knots[used + (size_t)i - 1] =
                (knots[used + (size_t)i] - domain.a) / (domain.b - domain.a);
        used += (size_t)(own - 2);
    }
    qsort(knots, used, sizeof *knots, by_value);
    *count = used > 0;
    for (size_t i = 1; i < used; i++)
        *count += knots[i] - knots[i - 1] > 16 * DBL_EPSILON;
    bat_release(knots);
    return BATTEN_OK;
}

static batten_status inspect(const task *t, const batten_surface *surface,
                             batten_skin_report *report)
{
    const int knot_count = batten_surface_spans(surface, BATTEN_U, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, BATTEN_U, knots);
    batten_skin_report found = {.knot_count = knot_count - 2};
    for (int k = 0; k < t->count; k++)
        if (t->deviation[k] > found.deviation) {
            found.deviation = t->deviation[k];
            found.worst_section = k;
        }
    batten_status status = check_sections(t, surface, knots, knot_count);
    if (status == BATTEN_OK && report)
        status = find_normal_jump(t, surface, knots, knot_count, &found.normal_jump);
    if (status == BATTEN_OK && report)
        status = count_exact(t, &found.exact_knot_count);
    if (status == BATTEN_OK && report) {
        found.span_ratio = span_ratio(knots, knot_count);
        *report = found;
    }
    bat_release(knots);
    return status;
}

/* ---- the whole ---- */

static batten_status skin(task *t, const batten_curve *const *sections,
                          batten_skin_report *report, batten_surface **out)
{
    t->placed = bat_array((size_t)t->count, sizeof *t->placed);
    t->unified = bat_array((size_t)t->count, sizeof *t->unified);
    t->deviation = bat_array((size_t)t->count, sizeof *t->deviation);
    batten_status status =
        t->placed && t->unified && t->deviation ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = place_all(t, sections);
    if (status == BATTEN_OK && t->options->align)
        status = align(t);
    if (status == BATTEN_OK)
        status = unify(t);
    const uint64_t steps = (uint64_t)t->points * (uint64_t)t->count;
    if (status == BATTEN_OK)
        status = bat_work_step(&t->work, steps, 0.5, "skin");
    if (status == BATTEN_OK)
        status = fill_rows(t);
    if (status == BATTEN_OK)
        status = find_parameters(t);
    if (status == BATTEN_OK)
        status = interpolate_across(t);
    if (status == BATTEN_OK)
        status = bat_work_step(&t->work, steps, 0.8, "skin");
    batten_surface *surface = NULL;
    if (status == BATTEN_OK)
        status = make_surface(t, &surface);
    if (status == BATTEN_OK)
        status = inspect(t, surface, report);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

static void release(task *t)
{
    for (int k = 0; k < t->count; k++) {
        if (t->placed)
            batten_curve_unref(t->placed[k]);
        if (t->unified)
            batten_curve_unref(t->unified[k]);
    }
    bat_release(t->placed);
    bat_release(t->unified);
    bat_release(t->deviation);
    bat_release(t->v);
    bat_release(t->rows);
    bat_release(t->control);
    bat_operator_free(&t->across);
}

batten_status batten_surface_skin(int count, const batten_curve *const *sections,
                                  const batten_skin_options *options, const batten_job *job,
                                  double *v, batten_skin_report *report, batten_surface **out)
{
    const batten_skin_options defaults = batten_skin_defaults();
    task t = {.count = count, .options = options ? options : &defaults, .work = {job, 0}};
    batten_status status = check(count, t.options);
    if (status != BATTEN_OK)
        return status;
    status = skin(&t, sections, report, out);
    if (status == BATTEN_OK && v)
        memcpy(v, t.v, (size_t)count * sizeof *v);
    release(&t);
    return status;
}

batten_status batten_surface_ruled(const batten_curve *first, const batten_curve *second,
                                   batten_surface **out)
{
    const batten_curve *both[] = {first, second};
    batten_skin_options options = batten_skin_defaults();
    options.degree = 1;
    options.parameters = BATTEN_UNIFORM;
    return batten_surface_skin(2, both, &options, NULL, NULL, NULL, out);
}

batten_status batten_surface_extruded(const batten_curve *curve, batten_vec3 along,
                                      batten_surface **out)
{
    if (!isfinite(along.x) || !isfinite(along.y) || !isfinite(along.z))
        return bat_fail(BATTEN_NOT_FINITE, "the curve shall be extruded along (%g, %g, %g)",
                        along.x, along.y, along.z);
    if (bat_vec3_norm(along) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the vector to extrude along has no length");
    const batten_affine map = batten_affine_translation(along.x, along.y, along.z);
    batten_curve *low = NULL, *high = NULL;
    batten_status status = batten_curve_to_dimension(curve, 3, &low);
    if (status == BATTEN_OK)
        status = batten_curve_transform(low, &map, &high);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(low, high, out);
    batten_curve_unref(high);
    batten_curve_unref(low);
    return status;
}
