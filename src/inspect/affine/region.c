/* What a closed plane curve encloses: area, centroid and moments, by halving until parts
 * agree. */
#include "inspect/closed.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>

#include <float.h>

batten_status bat_closed_check(const batten_curve *curve, double closed)
{
    const batten_interval domain = batten_curve_domain(curve);
    double a[2], b[2];
    if (curve->dimension != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "a curve of %d dimensions encloses no part of the plane",
                        curve->dimension);
    if (!(closed >= 0 && isfinite(closed)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of closed curves is %g", closed);
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, domain.b, BATTEN_FROM_LEFT, 0, b);
    const double gap = status == BATTEN_OK ? bat_distance(2, a, b) : 0;
    if (gap > closed)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curve is not closed: its ends are %g apart",
                        gap);
    return status;
}

/* With w = x dy - y dx the integrals of 1, x, y, x x, x y, y y over the inside are those of
 * w/2, x w/3, y w/3, x x w/4, x y w/4, y y w/4 along the curve: Green's theorem. */
enum { INTEGRALS = 6, DEPTH = 16, PARTS = 4096 };

typedef struct {
    double value[INTEGRALS], size[INTEGRALS]; /* of the integrands, and of their sizes */
} sums;

typedef struct {
    const batten_curve *curve;
    double origin[2];
    double rounding; /* of coordinates relative to the origin, as a share of the extent */
    int count;
    double nodes[BAT_MAX_GAUSS], weights[BAT_MAX_GAUSS];
} ruler;

static void add_place(const double *origin, const double *place, double weight, sums *s)
{
    const double x = place[0] - origin[0], y = place[1] - origin[1];
    const double factors[INTEGRALS] = {1 / 2.0, x / 3, y / 3, x * x / 4, x * y / 4, y * y / 4};
    const double w = weight * (x * place[3] - y * place[2]);
    const double size = fabs(weight) * (fabs(x * place[3]) + fabs(y * place[2]));
    for (int k = 0; k < INTEGRALS; k++) {
        s->value[k] += factors[k] * w;
        s->size[k] += fabs(factors[k]) * size;
    }
}

static batten_status rule(const ruler *r, double a, double b, sums *out)
{
    double u[BAT_MAX_GAUSS], places[BAT_MAX_GAUSS * 4];
    for (int i = 0; i < r->count; i++)
        u[i] = a + (b - a) * (0.5 + 0.5 * r->nodes[i]);
    const batten_status status =
        batten_curve_evaluate_many(r->curve, (size_t)r->count, u, 1, NULL, places);
    *out = (sums){0};
    for (int i = 0; status == BATTEN_OK && i < r->count; i++)
        add_place(r->origin, places + 4 * i, r->weights[i] * (b - a) / 2, out);
    return status;
}

static void add_sums(sums *a, const sums *b)
{
    for (int k = 0; k < INTEGRALS; k++) {
        a->value[k] += b->value[k];
        a->size[k] += b->size[k];
    }
}

/* What is wanted of a part: a share of the sizes of the integrals of the whole curve. */
typedef struct {
    sums all;                 /* by one rule for each span */
    double precision, domain; /* of all; the width of the domain */
    double rounding;          /* of values, as a share of their sizes */
    double error[INTEGRALS];
} goal;

/* Are both halves what the whole is, or does only rounding differ? */
static bool agree(const goal *g, const sums *whole, const sums *both, double width)
{
    for (int k = 0; k < INTEGRALS; k++) {
        const double wanted = g->precision * g->all.size[k] * (width / g->domain);
        const double miss = fabs(both->value[k] - whole->value[k]);
        if (miss > wanted && miss > g->rounding * both->size[k])
            return false;
    }
    return true;
}

typedef struct {
    double a, b;
    int depth;
    sums sums;
} region_part;

/* One span, halved until both halves agree with the whole. */
static batten_status halve_span(const ruler *r, double a, double b, goal *g, sums *all)
{
    region_part stack[DEPTH + 2] = {{.a = a, .b = b}};
    int waiting = 1;
    batten_status status = rule(r, a, b, &stack[0].sums);
    for (int budget = PARTS; status == BATTEN_OK && waiting > 0; budget--) {
        const region_part whole = stack[--waiting];
        const double middle = whole.a + (whole.b - whole.a) / 2;
        region_part *left = &stack[waiting], *right = left + 1;
        *left = (region_part){.a = whole.a, .b = middle, .depth = whole.depth + 1};
        *right = (region_part){.a = middle, .b = whole.b, .depth = whole.depth + 1};
        status = rule(r, left->a, left->b, &left->sums);
        if (status == BATTEN_OK)
            status = rule(r, right->a, right->b, &right->sums);
        sums both = left->sums;
        add_sums(&both, &right->sums);
        if (status == BATTEN_OK && whole.depth < DEPTH && budget > 0 &&
            !agree(g, &whole.sums, &both, whole.b - whole.a)) {
            waiting += 2;
            continue;
        }
        add_sums(all, &both);
        for (int k = 0; k < INTEGRALS; k++)
            g->error[k] += fabs(both.value[k] - whole.sums.value[k]);
    }
    return status;
}

/* The line that closes what is open by rounding. */
static batten_status add_gap(const ruler *r, const batten_interval domain, sums *all)
{
    double a[2], b[2];
    batten_status status = batten_curve_evaluate(r->curve, domain.a, 0, a);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(r->curve, domain.b, BATTEN_FROM_LEFT, 0, b);
    for (int i = 0; status == BATTEN_OK && i < r->count; i++) {
        const double t = 0.5 + 0.5 * r->nodes[i];
        const double place[4] = {b[0] + t * (a[0] - b[0]), b[1] + t * (a[1] - b[1]),
                                 a[0] - b[0], a[1] - b[1]};
        add_place(r->origin, place, r->weights[i] / 2, all);
    }
    return status;
}

/* Moments about the centroid and their principal directions, from those about the origin. */
static void finish_region(const double *origin, const double *m, batten_region *out)
{
    const double area = m[0], x = m[1] / area, y = m[2] / area;
    out->area = area;
    out->centroid[0] = origin[0] + x;
    out->centroid[1] = origin[1] + y;
    out->xx = m[3] - area * x * x;
    out->xy = m[4] - area * x * y;
    out->yy = m[5] - area * y * y;
    const double sign = area < 0 ? -1 : 1, middle = (out->xx + out->yy) / 2;
    const double half = bat_hypot((out->xx - out->yy) / 2, out->xy);
    out->principal[0] = middle + sign * half;
    out->principal[1] = middle - sign * half;
    out->angle =
        half == 0 ? 0 : 0.5 * bat_atan2(2 * sign * out->xy, sign * (out->xx - out->yy));
}

static batten_status integrate(const batten_curve *curve, double precision, sums *all, ruler *r,
                               double *error)
{
    const int p = curve->degree, breaks = batten_curve_spans(curve, NULL);
    const batten_box box = batten_curve_box(curve);
    const double extent = bat_max(box.high.x - box.low.x, box.high.y - box.low.y);
    *r = (ruler){.curve = curve,
                 .origin = {box.low.x + (box.high.x - box.low.x) / 2,
                            box.low.y + (box.high.y - box.low.y) / 2},
                 .rounding = 64 * DBL_EPSILON *
                             bat_max(1, bat_largest(2 * curve->count, curve->points) /
                                            bat_max(extent, DBL_MIN)),
                 .count = curve->weights ? 16 : 2 * p}; /* exact to degree 4 p - 1 */
    bat_gauss(r->count, r->nodes, r->weights);
    double *knots = bat_array((size_t)breaks, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    batten_status status = BATTEN_OK;
    goal g = {.precision = precision,
              .domain = knots[breaks - 1] - knots[0],
              .rounding = r->rounding};
    for (int i = 0; status == BATTEN_OK && i + 1 < breaks; i++) {
        sums one;
        status = rule(r, knots[i], knots[i + 1], &one);
        add_sums(&g.all, &one);
    }
    for (int i = 0; status == BATTEN_OK && curve->weights && i + 1 < breaks; i++)
        status = halve_span(r, knots[i], knots[i + 1], &g, all);
    if (status == BATTEN_OK && !curve->weights)
        *all = g.all;
    *error = p * r->rounding / 4;
    for (int k = 0; k < INTEGRALS; k++)
        if (all->size[k] > 0)
            *error = bat_max(*error, g.error[k] / all->size[k]);
    if (status == BATTEN_OK)
        status = add_gap(r, batten_curve_domain(curve), all);
    bat_release(knots);
    return status;
}

batten_status batten_curve_region(const batten_curve *curve, double closed, double precision,
                                  batten_region *out)
{
    batten_region made = {0};
    ruler r;
    sums all = {0};
    if (!(precision > 0 && isfinite(precision)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the precision is %g, not above 0", precision);
    batten_status status = bat_closed_check(curve, closed);
    if (status == BATTEN_OK)
        status = integrate(curve, precision, &all, &r, &made.error);
    if (status != BATTEN_OK)
        return status;
    if (made.error > bat_max(precision, curve->degree * r.rounding))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "the integrals are known to %g, %g is asked for", made.error,
                        precision);
    if (!(fabs(all.value[0]) > made.error * all.size[0]))
        return bat_fail(BATTEN_COINCIDENT, "the curve encloses no area");
    finish_region(r.origin, all.value, &made);
    *out = made;
    return BATTEN_OK;
}
