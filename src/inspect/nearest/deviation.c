/*
 * Distance of points from curves.
 *
 * With C = A / w the distance from Q is least where (A - Q w) . N, N = A' w - A w', turns from
 * negative to positive, or at an end. Of each span whose box comes nearer than what was found
 * so far all these places are found; so the result is the global minimum.
 */
#include "base/plural.h"
#include "base/work.h"
#include "inspect/forms.h"
#include "inspect/nearest/nearest.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* The box of the control points of each span, where the spans begin, and boxes of neighbours
 * that share a bit of their index, of those again, up to all: node i holds nodes 2 i and 2 i +
 * 1, and span k is node width + k. */
typedef struct {
    int count, width; /* spans; the power of two that holds them */
    int *spans;       /* [count] knot index */
    double *boxes;    /* [2 width][2][d]; node 0 is not used, those behind the last are empty */
    double *ends;     /* [count + 1][d], points at the distinct knots */
    double *knots;    /* [count + 1] */
} span_boxes;

static void boxes_end(span_boxes *b)
{
    bat_release(b->spans);
    bat_release(b->boxes);
    bat_release(b->ends);
    bat_release(b->knots);
}

static void set_box(const batten_curve *curve, int span, double *low, double *high)
{
    const int d = curve->dimension, p = curve->degree;
    const double *points = curve->points + (size_t)(span - p) * (size_t)d;
    for (int k = 0; k < d; k++) {
        low[k] = high[k] = points[k];
        for (int i = 1; i <= p; i++) {
            low[k] = bat_min(low[k], points[i * d + k]);
            high[k] = bat_max(high[k], points[i * d + k]);
        }
    }
}

/* A box grows to hold another one. */
static void widen(int d, double *box, const double *low, const double *high)
{
    for (int k = 0; k < d; k++) {
        box[k] = bat_min(box[k], low[k]);
        box[d + k] = bat_max(box[d + k], high[k]);
    }
}

/* Boxes of spans become those of all nodes. Those of spans hold the computed end points too. */
static void gather_boxes(span_boxes *b, int d)
{
    const int size = 2 * d;
    for (int i = 0; i < 2 * b->width; i++)
        for (int k = 0; k < d && (i < b->width || i >= b->width + b->count); k++) {
            b->boxes[i * size + k] = HUGE_VAL;
            b->boxes[i * size + d + k] = -HUGE_VAL;
        }
    for (int i = 0; i < b->count; i++)
        for (int e = i; e <= i + 1; e++)
            widen(d, b->boxes + (b->width + i) * size, b->ends + e * d, b->ends + e * d);
    for (int i = 2 * b->width - 1; i > 1; i--) {
        const double *box = b->boxes + i * size;
        widen(d, b->boxes + i / 2 * size, box, box + d);
    }
}

static batten_status boxes_begin(const batten_curve *curve, span_boxes *out)
{
    const size_t d = (size_t)curve->dimension;
    span_boxes b = {.count = batten_curve_spans(curve, NULL) - 1, .width = 1};
    const size_t n = (size_t)b.count;
    while (b.width < b.count)
        b.width *= 2;
    b.spans = bat_array(n, sizeof *b.spans);
    b.boxes = bat_array3(2 * (size_t)b.width, 2 * d, sizeof *b.boxes);
    b.ends = bat_array3(n + 1, d, sizeof *b.ends);
    b.knots = bat_array(n + 1, sizeof *b.knots);
    batten_status status =
        b.spans && b.boxes && b.ends && b.knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, b.knots);
        status = batten_curve_evaluate_many(curve, n + 1, b.knots, 0, NULL, b.ends);
    }
    for (int k = curve->degree, i = 0; status == BATTEN_OK && k < curve->count; k++) {
        if (curve->knots[k] == curve->knots[k + 1])
            continue;
        b.spans[i] = k;
        double *const box = b.boxes + 2 * d * ((size_t)b.width + (size_t)i);
        set_box(curve, k, box, box + d);
        i++;
    }
    if (status == BATTEN_OK) {
        gather_boxes(&b, (int)d);
        *out = b;
    } else
        boxes_end(&b);
    return status;
}

static double box_distance(int d, const double *box, const double *q)
{
    double away[3] = {0};
    for (int k = 0; k < d; k++)
        away[k] = bat_max(0, bat_max(box[k] - q[k], q[k] - box[d + k]));
    return bat_norm(d, away);
}

/* ---- one point ---- */

typedef struct {
    const batten_curve *curve;
    const span_boxes *boxes;
    bat_forms forms;
    bat_walk walk;
    double *rows; /* [p + 1][width] */
} finder;

static batten_status finder_begin(const batten_curve *curve, const span_boxes *b, finder *out)
{
    *out = (finder){.curve = curve, .boxes = b, .walk = {.only_rising = true}};
    out->rows = bat_array3((size_t)curve->degree + 1, bat_curve_width(curve), sizeof(double));
    return out->rows ? bat_forms_begin(48, 4 * curve->degree, &out->forms)
                     : BATTEN_OUT_OF_MEMORY;
}

static void finder_end(finder *f)
{
    bat_walk_end(&f->walk);
    bat_forms_end(&f->forms);
    bat_release(f->rows);
}

static batten_status try_parameter(const batten_curve *curve, const double *q, double u,
                                   bat_nearest *best)
{
    double point[3];
    batten_status status = batten_curve_evaluate(curve, u, 0, point);
    const double distance = status == BATTEN_OK ? bat_distance(curve->dimension, point, q) : 0;
    if (status == BATTEN_OK && distance < best->distance)
        *best = (bat_nearest){distance, {u, 0}};
    return status;
}

/* (A - Q w) . N on one span; its coordinates are already relative to Q. */
static bat_form approach(bat_forms *forms, const bat_span_forms *span, int dimension)
{
    bat_form sum = {0};
    for (int k = 0; k < dimension; k++) {
        bat_form n = bat_form_derivative(forms, span->x[k]);
        if (span->w.degree > 0)
            n = bat_form_sum(
                forms, bat_form_product(forms, n, span->w), -1,
                bat_form_product(forms, span->x[k], bat_form_derivative(forms, span->w)));
        const bat_form term = bat_form_product(forms, span->x[k], n);
        sum = k == 0 ? term : bat_form_sum(forms, sum, 1, term);
    }
    return sum;
}

static batten_status search_span(finder *f, int span, const double *q, bat_nearest *best)
{
    bat_span_forms forms;
    int k = span;
    bat_span_forms_next(f->curve, &k, f->rows, q, &f->forms, &forms);
    f->walk.count = f->walk.sign = 0;
    batten_status status = bat_walk_piece(
        &f->walk, approach(&f->forms, &forms, f->curve->dimension), forms.a, forms.b);
    for (int i = 0; status == BATTEN_OK && i < f->walk.count; i++)
        status = try_parameter(f->curve, q, f->walk.at[i], best);
    return status;
}

/* The nearest of the ends of all spans, the first of equals: nearer boxes first. */
static void search_ends(const span_boxes *b, int d, const double *q, bat_nearest *best)
{
    int stack[64] = {1}, waiting = 1, found = -1;
    while (waiting > 0) {
        const int node = stack[--waiting];
        if (box_distance(d, b->boxes + 2 * node * d, q) > best->distance)
            continue;
        if (node < b->width) {
            const int left = 2 * node;
            const double *box = b->boxes + 2 * left * d;
            const bool first = box_distance(d, box, q) <= box_distance(d, box + 2 * d, q);
            stack[waiting++] = first ? left + 1 : left;
            stack[waiting++] = first ? left : left + 1;
            continue;
        }
        for (int i = node - b->width; i <= node - b->width + 1; i++) {
            const double distance = bat_distance(d, b->ends + i * d, q);
            if (distance > best->distance || (distance == best->distance && i >= found))
                continue;
            *best = (bat_nearest){distance, {b->knots[i], 0}};
            found = i;
        }
    }
}

/* All spans that may come nearer than the nearest end, along the curve. */
static batten_status search_all(finder *f, const double *q, bat_nearest *best)
{
    const span_boxes *b = f->boxes;
    const int d = f->curve->dimension;
    int stack[64] = {1}, waiting = 1;
    batten_status status = BATTEN_OK;
    search_ends(b, d, q, best);
    while (status == BATTEN_OK && waiting > 0) {
        const int node = stack[--waiting];
        if (box_distance(d, b->boxes + 2 * node * d, q) >= best->distance)
            continue;
        if (node >= b->width) {
            status = search_span(f, b->spans[node - b->width], q, best);
        } else {
            stack[waiting++] = 2 * node + 1;
            stack[waiting++] = 2 * node;
        }
    }
    return status;
}

/* ---- many points ---- */

typedef struct {
    const batten_curve *curve;
    const double *points, *start;
    span_boxes boxes;
    bat_nearest *nearest;
} query;

/* A guess is only a first bound, which saves most spans their search. */
static batten_status search_chunk(void *context, size_t begin, size_t end)
{
    const query *q = context;
    const batten_interval domain = batten_curve_domain(q->curve);
    finder f;
    batten_status status = finder_begin(q->curve, &q->boxes, &f);
    for (size_t i = begin; status == BATTEN_OK && i < end; i++) {
        const double *point = q->points + i * (size_t)q->curve->dimension;
        q->nearest[i].distance = HUGE_VAL;
        if (q->start)
            status = try_parameter(q->curve, point,
                                   bat_min(domain.b, bat_max(domain.a, q->start[i])),
                                   &q->nearest[i]);
        if (status == BATTEN_OK)
            status = search_all(&f, point, &q->nearest[i]);
    }
    finder_end(&f);
    return status;
}

batten_status bat_deviation_check(int dimension, int count, const double *points,
                                  const double *start, int start_width)
{
    const size_t values = (size_t)bat_max_int(count, 0) * (size_t)dimension;
    const size_t guesses = start ? (size_t)bat_max_int(count, 0) * (size_t)start_width : 0;
    if (count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d point%s, at least 1 is needed",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    const size_t bad = bat_first_not_finite(points, values);
    if (bad < values)
        return bat_fail(BATTEN_NOT_FINITE, "point %zu is not finite",
                        bad / (size_t)dimension + 1);
    if (start && bat_first_not_finite(start, guesses) < guesses)
        return bat_fail(BATTEN_NOT_FINITE, "the guess for point %zu is not finite",
                        bat_first_not_finite(start, guesses) / (size_t)start_width + 1);
    return BATTEN_OK;
}

batten_status bat_deviation_finish(int count, const bat_nearest *nearest, double *distances,
                                   batten_deviation *out)
{
    double *squares = bat_array((size_t)count, sizeof *squares);
    if (!squares)
        return BATTEN_OUT_OF_MEMORY;
    batten_deviation found = {.max = -1};
    for (int i = 0; i < count; i++) {
        squares[i] = nearest[i].distance * nearest[i].distance;
        if (distances)
            distances[i] = nearest[i].distance;
        if (nearest[i].distance > found.max)
            found = (batten_deviation){
                nearest[i].distance, 0, i, {nearest[i].at[0], nearest[i].at[1]}};
    }
    found.rms = sqrt(bat_sum(squares, (size_t)count, 1) / count);
    *out = found;
    bat_release(squares);
    return BATTEN_OK;
}

batten_status batten_curve_deviation(const batten_curve *curve, batten_points points,
                                     const double *start, const batten_job *job,
                                     double *distances, batten_deviation *out)
{
    if (points.dimension != batten_curve_dimension(curve))
        return bat_wrong_dimension(points, batten_curve_dimension(curve));
    query q = {.curve = curve, .points = points.at, .start = start};
    batten_status status =
        bat_deviation_check(curve->dimension, points.count, points.at, start, 1);
    if (status == BATTEN_OK)
        status = boxes_begin(curve, &q.boxes);
    if (status == BATTEN_OK &&
        !(q.nearest = bat_array((size_t)points.count, sizeof *q.nearest)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_parallel(job, (size_t)points.count, 64, search_chunk, &q);
    if (status == BATTEN_OK)
        status = bat_deviation_finish(points.count, q.nearest, distances, out);
    bat_release(q.nearest);
    boxes_end(&q.boxes);
    return status;
}
