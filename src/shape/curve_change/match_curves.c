/* Two curves made to join smoothly. */
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/continuity.h>

#include <string.h>

enum { MOST = 4 };

/* The control points next to the join, counted from it, and what the derivatives there are made
 * of: C^(j) = sum of a[j][i] p[i], i <= j. */
typedef struct {
    const batten_curve *curve;
    bool at_end;
    int order;
    double a[MOST][MOST];
    batten_vec3 p[MOST];
} end;

static int index_of(const end *e, int i)
{
    return e->at_end ? e->curve->count - 1 - i : i;
}

/* Column i is what the scalar curve does whose only control value that is not 0 is that of
 * point i. */
static batten_status fill_column(end *e, int i)
{
    const batten_curve *curve = e->curve;
    const batten_interval domain = batten_curve_domain(curve);
    batten_curve *basis = NULL;
    double derivatives[MOST];
    double *values = bat_array((size_t)curve->count, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    values[index_of(e, i)] = 1;
    batten_status status =
        batten_curve_create((batten_points){1, curve->count, values}, curve->degree,
                            curve->weights, curve->knots, &basis);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(basis, e->at_end ? domain.b : domain.a,
                                            e->at_end ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT,
                                            e->order, derivatives);
    for (int j = 0; status == BATTEN_OK && j <= e->order; j++)
        e->a[j][i] = derivatives[j];
    batten_curve_unref(basis);
    bat_release(values);
    return status;
}

static batten_status look_at_end(const batten_curve *curve, bool at_end, int order, end *out)
{
    const int d = curve->dimension;
    batten_status status = BATTEN_OK;
    *out = (end){.curve = curve, .at_end = at_end, .order = order};
    for (int i = 0; i <= order && status == BATTEN_OK; i++) {
        out->p[i] = bat_vec3_of(d, curve->points + (size_t)index_of(out, i) * (size_t)d);
        status = fill_column(out, i);
    }
    return status;
}

static batten_vec3 derivative(const end *e, int j)
{
    batten_vec3 sum = {0, 0, 0};
    for (int i = 0; i <= j; i++)
        sum = bat_vec3_along(sum, e->a[j][i], e->p[i]);
    return sum;
}

/* ---- equal derivatives ---- */

/* The moves x of the points, of the first curve and then of the second as far as they may move,
 * with the least sum of squares that make the rows of derivatives equal: x = Mt (M Mt)^-1 r. */
typedef struct {
    int rows, columns;
    double m[MOST][2 * MOST], square[MOST * MOST];
    int pivots[MOST];
} balance;

static batten_status balance_make(end *const ends[2], const bool moves[2], balance *out)
{
    const int rows = ends[0]->order + 1;
    *out = (balance){.rows = rows};
    for (int k = 0; k < 2; k++)
        for (int i = 0; moves[k] && i < rows; i++, out->columns++)
            for (int j = i; j < rows; j++)
                out->m[j][out->columns] = (k ? -1 : 1) * ends[k]->a[j][i];
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < rows; j++)
            out->square[i * rows + j] = bat_dot(out->columns, out->m[i], out->m[j]);
    return bat_dense_factor(rows, out->square, out->pivots);
}

/* By how much the derivatives at both ends differ. */
static void list_gaps(int rows, end *const ends[2], double *gaps)
{
    for (int j = 0; j < rows; j++) {
        const batten_vec3 gap =
            bat_vec3_subtract(derivative(ends[1], j), derivative(ends[0], j));
        memcpy(gaps + 3 * j, (const double[]){gap.x, gap.y, gap.z}, 3 * sizeof *gaps);
    }
}

static void apply_moves(const balance *b, end *const ends[2], const bool moves[2])
{
    double right[MOST * 3];
    list_gaps(b->rows, ends, right);
    bat_dense_solve(b->rows, b->square, b->pivots, 3, right);
    for (int k = 0, column = 0; k < 2; k++)
        for (int i = 0; moves[k] && i < b->rows; i++, column++)
            for (int j = 0; j < b->rows; j++)
                ends[k]->p[i] = bat_vec3_along(ends[k]->p[i], b->m[j][column],
                                               bat_vec3_of(3, right + 3 * (size_t)j));
}

static batten_status match_derivatives(end *const ends[2], const bool moves[2])
{
    balance b;
    const batten_status status = balance_make(ends, moves, &b);
    /* Squaring lost half of the digits; each turn brings them back. */
    for (int turn = 0; status == BATTEN_OK && turn < 3; turn++)
        apply_moves(&b, ends, moves);
    return status;
}

/* ---- equal tangents and curvatures ---- */

static batten_vec3 unit(batten_vec3 a)
{
    const double length = bat_vec3_norm(a);
    return length > 0 ? bat_vec3_scale(a, 1 / length) : a;
}

static batten_vec3 across(batten_vec3 a, batten_vec3 t)
{
    return bat_vec3_along(a, -bat_vec3_dot(a, t), t);
}

static void turn_leg(end *e, batten_vec3 t)
{
    const batten_vec3 leg = bat_vec3_subtract(e->p[1], e->p[0]);
    const double way = e->a[1][1] > 0 ? 1 : -1, along = way * bat_vec3_dot(leg, t);
    e->p[1] = bat_vec3_along(e->p[0], way * (along > 0 ? along : bat_vec3_norm(leg)), t);
}

static batten_vec3 curvature(const end *e, batten_vec3 t)
{
    const batten_vec3 c1 = derivative(e, 1);
    return bat_vec3_scale(across(derivative(e, 2), t), 1 / bat_vec3_dot(c1, c1));
}

static void bend_end(end *e, batten_vec3 t, batten_vec3 wanted)
{
    const batten_vec3 c1 = derivative(e, 1), now = curvature(e, t);
    const double factor = bat_vec3_dot(c1, c1) / e->a[2][2];
    e->p[2] = bat_vec3_along(e->p[2], factor, bat_vec3_subtract(wanted, now));
}

static batten_status match_shapes(end *const ends[2], const bool moves[2], int order)
{
    const bool both = moves[0] && moves[1];
    const batten_vec3 t0 = order ? unit(derivative(ends[0], 1)) : (batten_vec3){0, 0, 0};
    const batten_vec3 t1 = order ? unit(derivative(ends[1], 1)) : t0;
    const batten_vec3 joint =
        both ? bat_vec3_scale(bat_vec3_add(ends[0]->p[0], ends[1]->p[0]), 0.5)
             : ends[moves[0] ? 1 : 0]->p[0];
    const batten_vec3 t = both ? unit(bat_vec3_add(t0, t1)) : moves[0] ? t1 : t0;
    if (order && !(bat_vec3_norm(t) > 0 && bat_vec3_norm(t0) > 0 && bat_vec3_norm(t1) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the curves have no common tangent at the join");
    for (int k = 0; k < 2; k++)
        if (moves[k]) {
            ends[k]->p[0] = joint;
            if (order)
                turn_leg(ends[k], t);
        }
    if (order < 2)
        return BATTEN_OK;
    const batten_vec3 k0 = curvature(ends[0], t), k1 = curvature(ends[1], t);
    const batten_vec3 wanted = both       ? bat_vec3_scale(bat_vec3_add(k0, k1), 0.5)
                               : moves[0] ? k1
                                          : k0;
    for (int k = 0; k < 2; k++)
        if (moves[k])
            bend_end(ends[k], t, wanted);
    return BATTEN_OK;
}

/* ---- both ---- */

/* The curve with the points of its end; *moved grows to the longest way. */
static batten_status rebuild(const end *e, double *moved, batten_curve **out)
{
    const int d = e->curve->dimension;
    batten_curve *made = NULL;
    const batten_status status = bat_curve_copy(e->curve, &made);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i <= e->order; i++) {
        double *to = made->points + (size_t)index_of(e, i) * (size_t)d;
        const double p[3] = {e->p[i].x, e->p[i].y, e->p[i].z};
        *moved = bat_max(*moved, bat_distance(d, p, to));
        memcpy(to, p, (size_t)d * sizeof *to);
    }
    return bat_curve_finish(made, out);
}

static batten_status verify_match(const batten_curve *first, const batten_curve *second,
                                  batten_match_kind kind, int order)
{
    batten_continuity found;
    const batten_status status = batten_curves_continuity(first, BATTEN_CURVE_END, second,
                                                          BATTEN_CURVE_START, NULL, &found);
    if (status != BATTEN_OK)
        return status;
    const int reached = kind == BATTEN_MATCH_PARAMETRIC ? found.parametric : found.geometric;
    if (reached < order)
        return bat_fail(
            BATTEN_TOLERANCE_NOT_MET, "the curves join with %c%d, not %c%d: gap %g, angle %g",
            kind == BATTEN_MATCH_PARAMETRIC ? 'C' : 'G', reached,
            kind == BATTEN_MATCH_PARAMETRIC ? 'C' : 'G', order, found.gap, found.angle);
    return BATTEN_OK;
}

static batten_status check_match(const batten_curve *first, const batten_curve *second,
                                 batten_match_kind kind, int order)
{
    const int most = kind == BATTEN_MATCH_PARAMETRIC ? 3 : 2;
    const int least = bat_min_int(first->degree, second->degree);
    if (order < 0 || order > most)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order is %d, not 0 to %d", order, most);
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                        first->dimension, second->dimension);
    if (least < order)
        return bat_fail(BATTEN_BAD_DEGREE, "a join of order %d needs degree %d; there is %d",
                        order, order, least);
    return BATTEN_OK;
}

/* With clamped curves. */
static batten_status match(const batten_curve *first, const batten_curve *second,
                           batten_match how, double *moved, batten_curve **made)
{
    const int order = how.order;
    const bool moves[2] = {how.mover != BATTEN_MATCH_MOVES_SECOND,
                           how.mover != BATTEN_MATCH_MOVES_FIRST};
    end left, right;
    end *const ends[2] = {&left, &right};
    batten_status status = look_at_end(first, true, order, &left);
    if (status == BATTEN_OK)
        status = look_at_end(second, false, order, &right);
    if (status == BATTEN_OK)
        status = how.kind == BATTEN_MATCH_PARAMETRIC ? match_derivatives(ends, moves)
                                                     : match_shapes(ends, moves, order);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = rebuild(ends[k], moved, &made[k]);
    return status == BATTEN_OK ? verify_match(made[0], made[1], how.kind, order) : status;
}

batten_status batten_curves_match(const batten_curve *first, const batten_curve *second,
                                  batten_match how, double *moved, batten_curve **first_out,
                                  batten_curve **second_out)
{
    batten_curve *clamped[2] = {NULL, NULL}, *made[2] = {NULL, NULL};
    double longest = 0;
    batten_status status = check_match(first, second, how.kind, how.order);
    if (status == BATTEN_OK)
        status = batten_curve_clamp(first, &clamped[0]);
    if (status == BATTEN_OK)
        status = batten_curve_clamp(second, &clamped[1]);
    if (status == BATTEN_OK)
        status = match(clamped[0], clamped[1], how, &longest, made);
    if (status == BATTEN_OK) {
        *first_out = batten_curve_ref(made[0]);
        *second_out = batten_curve_ref(made[1]);
        if (moved)
            *moved = longest;
    }
    for (int k = 0; k < 2; k++) {
        batten_curve_unref(made[k]);
        batten_curve_unref(clamped[k]);
    }
    return status;
}
