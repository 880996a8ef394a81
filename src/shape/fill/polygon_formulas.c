/*
 * Fills that are formulas over a regular polygon: sides and ribbons, or corners, blended by the
 * distances from the sides. Quad i is the bilinear quarter of the polygon at its corner i.
 */
#include "numeric/jet.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include "shape/formula/formula.h"
#include <string.h>

/* A side over [0, 2] and the derivative D = a T + b C' across it, a and b linear, or linear
 * itself; such that D is the derivative of the sides beside it at its ends. Where that is not
 * in the ribbon's plane, what is missing is added and fades away along the side. */
typedef struct {
    batten_curve *curve, *slope;
    double factor[2][2];      /* a, b at the start, and their derivatives: [which][order] */
    double free[2][3];        /* D at the start and its derivative, without a slope */
    double beside[2][3];      /* what a T + b C' lacks at both ends: out of its plane */
    double normal[2], offset; /* its line in the polygon: distance = normal . x + offset */
} blended_side;

typedef struct {
    batten_fill_form form;
    int count, quad;
    double reach;         /* of the next corner from a side */
    double corners[4][2]; /* of the quad in the polygon: (0, 0), (1, 0), (0, 1), (1, 1) */
    double apex[3];       /* the point at the corner of the polygon */
    blended_side sides[BATTEN_FILL_SIDES];
} blended;

/* ---- ribbons ---- */

static batten_status end_factors(const bat_fill_loop *loop, int i, double t,
                                 const double wanted[3], double out[2], double beside[3])
{
    double C[2][3], T[3];
    batten_status status = batten_curve_evaluate(loop->sides[i].curve, t, 1, C[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(loop->sides[i].slope, t, 0, T);
    if (status != BATTEN_OK)
        return status;
    const double TT = bat_dot(3, T, T), TC = bat_dot(3, T, C[1]), CC = bat_dot(3, C[1], C[1]);
    const double WT = bat_dot(3, wanted, T), WC = bat_dot(3, wanted, C[1]);
    const double D = TT * CC - TC * TC;
    /* The square of a sine of 1e-9, see BAT_LEAST_SINE. */
    if (!(D > 1e-18 * TT * CC))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the ribbon of curve %d has no tangent plane at an end of its side",
                        loop->sides[i].given + 1);
    out[0] = (WT * CC - WC * TC) / D;
    out[1] = (WC * TT - WT * TC) / D;
    for (int c = 0; c < 3; c++)
        beside[c] = wanted[c] - out[0] * T[c] - out[1] * C[1][c];
    return BATTEN_OK;
}

static batten_status take_side(const bat_fill_loop *loop, int i, blended_side *out)
{
    const int n = loop->count;
    double before[2][3], next[2][3], ends[2][2];
    batten_status status =
        batten_curve_evaluate(loop->sides[(i + n - 1) % n].curve, 2, 1, before[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(loop->sides[(i + 1) % n].curve, 0, 1, next[0]);
    if (status != BATTEN_OK)
        return status;
    for (int c = 0; c < 3; c++) {
        before[1][c] = -before[1][c];
        out->free[0][c] = before[1][c];
        out->free[1][c] = (next[1][c] - before[1][c]) / 2;
    }
    if (loop->sides[i].slope) {
        status = end_factors(loop, i, 0, before[1], ends[0], out->beside[0]);
        if (status == BATTEN_OK)
            status = end_factors(loop, i, 2, next[1], ends[1], out->beside[1]);
        for (int k = 0; k < 2; k++) {
            out->factor[k][0] = ends[0][k];
            out->factor[k][1] = (ends[1][k] - ends[0][k]) / 2;
        }
    }
    if (status != BATTEN_OK)
        return status;
    out->curve = batten_curve_ref(loop->sides[i].curve);
    out->slope = loop->sides[i].slope ? batten_curve_ref(loop->sides[i].slope) : NULL;
    return BATTEN_OK;
}

/* (1 - s)^6 (1 + 6 s), s = t / 2, and three derivatives by t: 1 at 0 and flat there, so that
 * the twist stays; 0 at 2 and at most a tenth in the second half. */
static void fade(double t, double out[4])
{
    const double s = t / 2, r = 1 - s, r3 = r * r * r;
    out[0] = r3 * r3 * (1 + 6 * s);
    out[1] = -42 * s * r3 * r * r / 2;
    out[2] = -42 * r3 * r * (1 - 6 * s) / 4;
    out[3] = 42 * r3 * (10 - 30 * s) / 8;
}

static void add_beside(const blended_side *side, double t, double D[4][3])
{
    double start[4], end[4];
    fade(t, start);
    fade(2 - t, end);
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++)
            D[k][c] += start[k] * side->beside[0][c] +
                       (k % 2 == 0 ? end[k] : -end[k]) * side->beside[1][c];
}

/* C and D, and three derivatives of each, at t. */
static batten_status side_at(const blended_side *side, double t, double C[5][3], double D[4][3])
{
    double T[4][3];
    t = bat_max(0, bat_min(2, t));
    batten_status status = batten_curve_evaluate(side->curve, t, 4, C[0]);
    if (status == BATTEN_OK && side->slope)
        status = batten_curve_evaluate(side->slope, t, 3, T[0]);
    if (status != BATTEN_OK)
        return status;
    const double a1 = side->factor[0][1], b1 = side->factor[1][1];
    const double a = side->factor[0][0] + a1 * t, b = side->factor[1][0] + b1 * t;
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++) {
            if (side->slope)
                D[k][c] = a * T[k][c] + (k > 0 ? k * a1 * T[k - 1][c] : 0) + b * C[k + 1][c] +
                          k * b1 * C[k][c];
            else
                D[k][c] = k == 0   ? side->free[0][c] + t * side->free[1][c]
                          : k == 1 ? side->free[1][c]
                                   : 0;
        }
    if (side->slope)
        add_beside(side, t, D);
    return BATTEN_OK;
}

static void compose_jets(double values[][3], bat_jet t, bat_jet out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = bat_jet_compose(
            (const double[4]){values[0][c], values[1][c], values[2][c], values[3][c]}, t);
}

/* ---- the blends ---- */

/* What a point of the polygon is seen as from one side. */
typedef struct {
    bat_jet t; /* along the side, over [0, 2] */
    bat_jet C[3], D[3];
    double start[2][3], end_turn[2][3]; /* C', D at the start; D' at both ends */
} sight;

static void find_distances(const blended *b, bat_jet x, bat_jet y, bat_jet *distances)
{
    for (int i = 0; i < b->count; i++) {
        const blended_side *side = &b->sides[i];
        const bat_jet along = bat_jet_scale(side->normal[0], x);
        distances[i] = bat_jet_add(along, bat_jet_scale(side->normal[1], y));
        distances[i].d[0] += side->offset;
    }
}

static batten_status see_side(const blended *b, const bat_jet *distances, int i, sight *seen)
{
    const int n = b->count;
    const bat_jet before = distances[(i + n - 1) % n];
    const bat_jet sum = bat_jet_add(before, distances[(i + 1) % n]);
    double C[5][3], D[4][3];
    seen->t = bat_jet_scale(2, bat_jet_divide(before, sum));
    batten_status status = side_at(&b->sides[i], seen->t.d[0], C, D);
    if (status != BATTEN_OK)
        return status;
    compose_jets(C, seen->t, seen->C);
    compose_jets(D, seen->t, seen->D);
    for (int e = 1; e >= 0; e--) {
        status = side_at(&b->sides[i], 2 * e, C, D);
        if (status != BATTEN_OK)
            return status;
        memcpy(seen->end_turn[e], D[1], sizeof D[1]);
    }
    memcpy(seen->start[0], C[1], sizeof C[1]);
    memcpy(seen->start[1], D[0], sizeof D[0]);
    return BATTEN_OK;
}

/* The product of the squared distances from all sides but one or two. */
static bat_jet weight_without(int n, const bat_jet *distances, int first, int second)
{
    bat_jet product = bat_jet_constant(1);
    for (int j = 0; j < n; j++)
        if (j != first && j != second) {
            product = bat_jet_multiply(product, distances[j]);
            product = bat_jet_multiply(product, distances[j]);
        }
    return product;
}

static void add_product(bat_jet weight, const bat_jet point[3], bat_jet sum[3])
{
    for (int c = 0; c < 3; c++)
        sum[c] = bat_jet_add(sum[c], bat_jet_multiply(weight, point[c]));
}

/* Kato: a side continues straight along its ribbon. */
static void side_point(const blended *b, bat_jet distance, const sight *seen, bat_jet out[3])
{
    const bat_jet h = bat_jet_scale(2 / b->reach, distance);
    for (int c = 0; c < 3; c++)
        out[c] = bat_jet_add(seen->C[c], bat_jet_multiply(h, seen->D[c]));
}

/* Charrot and Gregory: the corner between the side before, `back`, and the side that leaves it,
 * `along`; x runs along this and y back along that, both over [0, 2] as the sides do. */
static void corner_point(const double apex[3], const sight *back, const sight *along,
                         bat_jet out[3])
{
    const bat_jet x = along->t, y = bat_jet_subtract(bat_jet_constant(2), back->t);
    const bat_jet xy = bat_jet_multiply(x, y), sum = bat_jet_add(x, y);
    /* Nearer to the corner than rounding both shares are one half. */
    bat_jet share = bat_jet_constant(0.5);
    if (sum.d[0] > 1e-14)
        share = bat_jet_divide(x, sum);
    for (int c = 0; c < 3; c++) {
        /* d/dy F_x and d/dx F_y */
        const double a = -back->end_turn[1][c], d = along->end_turn[0][c];
        bat_jet p = bat_jet_add(along->C[c], bat_jet_multiply(y, along->D[c]));
        p = bat_jet_add(p, bat_jet_add(back->C[c], bat_jet_multiply(x, back->D[c])));
        p = bat_jet_subtract(p, bat_jet_scale(along->start[0][c], x));
        p = bat_jet_subtract(p, bat_jet_scale(along->start[1][c], y));
        p.d[0] -= apex[c];
        bat_jet twist = bat_jet_scale(a - d, share);
        twist.d[0] += d;
        out[c] = bat_jet_subtract(p, bat_jet_multiply(xy, twist));
    }
}

/* The weighted mean of all sides, or of all corners. (Inlined, its jets would make the frame
 * of its caller large.) */
__attribute__((noinline)) static batten_status blend(const blended *b, const bat_jet *distances,
                                                     bat_jet mean[3])
{
    const bool kato = b->form == BATTEN_FILL_KATO;
    bat_jet weights = {{0}}, sum[3] = {{{0}}, {{0}}, {{0}}}, point[3];
    sight seen[2];
    batten_status status = see_side(b, distances, b->count - 1, &seen[1]);
    for (int i = 0; status == BATTEN_OK && i < b->count; i++) {
        const int before = (i + b->count - 1) % b->count;
        const bat_jet weight = weight_without(b->count, distances, i, kato ? i : before);
        seen[0] = seen[1];
        status = see_side(b, distances, i, &seen[1]);
        if (status != BATTEN_OK)
            return status;
        if (kato) {
            side_point(b, distances[i], &seen[1], point);
        } else {
            double C[5][3], D[4][3];
            status = side_at(&b->sides[i], 0, C, D);
            if (status != BATTEN_OK)
                return status;
            corner_point(C[0], &seen[0], &seen[1], point);
        }
        add_product(weight, point, sum);
        weights = bat_jet_add(weights, weight);
    }
    for (int c = 0; status == BATTEN_OK && c < 3; c++)
        mean[c] = bat_jet_divide(sum[c], weights);
    return status;
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const blended *b = data;
    /* In the corner of the polygon weights and distances vanish: there the point is known, and
     * derivatives are those next to it. */
    const double near = 1e-7;
    const bool apex = at->u < near && at->v < near;
    const bat_jet u = bat_jet_u(apex ? near : at->u), v = bat_jet_v(apex ? near : at->v);
    const bat_jet uv = bat_jet_multiply(u, v);
    bat_jet place[2], mean[3], distances[BATTEN_FILL_SIDES];
    for (int c = 0; c < 2; c++) {
        const double p = b->corners[0][c], q = b->corners[1][c], r = b->corners[2][c];
        place[c] = bat_jet_add(bat_jet_scale(q - p, u), bat_jet_scale(r - p, v));
        place[c] = bat_jet_add(place[c], bat_jet_scale(b->corners[3][c] - q - r + p, uv));
        place[c].d[0] += p;
    }
    find_distances(b, place[0], place[1], distances);
    const batten_status status = blend(b, distances, mean);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < BATTEN_SURFACE_DERIVATIVES(order); k++)
        for (int c = 0; c < 3; c++)
            out[3 * k + c] = mean[c].d[k];
    if (apex)
        memcpy(out, b->apex, sizeof b->apex);
    return BATTEN_OK;
}

/* ---- making ---- */

static void free_blended(void *data)
{
    blended *b = data;
    for (int i = 0; b && i < b->count; i++) {
        batten_curve_unref(b->sides[i].curve);
        batten_curve_unref(b->sides[i].slope);
    }
    bat_release(b);
}

static const bat_formula formulas[] = {
    [BATTEN_FILL_KATO] = {"kato", evaluate, NULL, free_blended},
    [BATTEN_FILL_CHARROT_GREGORY] = {"charrot-gregory", evaluate, NULL, free_blended}};

/* The polygon with its corners on the unit circle, and the quad of corner i. */
static void set_polygon(blended *b)
{
    const int n = b->count;
    double corners[BATTEN_FILL_SIDES][2];
    for (int i = 0; i < n; i++) {
        corners[i][0] = bat_cos(2 * BAT_PI * i / n);
        corners[i][1] = bat_sin(2 * BAT_PI * i / n);
    }
    for (int i = 0; i < n; i++) {
        const double middle = 2 * BAT_PI * (i + 0.5) / n;
        b->sides[i].normal[0] = -bat_cos(middle);
        b->sides[i].normal[1] = -bat_sin(middle);
        b->sides[i].offset = bat_cos(BAT_PI / n);
    }
    b->reach = 2 * bat_sin(BAT_PI / n) * bat_sin(2 * BAT_PI / n);
    const double *at = corners[b->quad], *next = corners[(b->quad + 1) % n];
    const double *before = corners[(b->quad + n - 1) % n];
    for (int c = 0; c < 2; c++) {
        b->corners[0][c] = at[c];
        b->corners[1][c] = (at[c] + next[c]) / 2;
        b->corners[2][c] = (at[c] + before[c]) / 2;
        b->corners[3][c] = 0;
    }
}

batten_status bat_fill_formula(const bat_fill_loop *loop, int quad, batten_fill_form form,
                               batten_surface **out)
{
    static const double ends[2] = {0, 1};
    const bat_formula_axis axis = {2, ends, 1};
    blended *b = bat_array(1, sizeof *b);
    batten_status status = b ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (b) {
        b->form = form;
        b->count = loop->count;
        b->quad = quad;
        set_polygon(b);
        status = batten_curve_evaluate(loop->sides[quad].curve, 0, 0, b->apex);
    }
    for (int i = 0; status == BATTEN_OK && i < loop->count; i++)
        status = take_side(loop, i, &b->sides[i]);
    if (status == BATTEN_OK)
        status = bat_formula_create(&formulas[form], b, 3, &axis, &axis, 1, out);
    if (status != BATTEN_OK)
        free_blended(b);
    return status;
}
