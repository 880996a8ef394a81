/* What all surfaces that are formulas have in common. */
#include "shape/formula/formula.h"

#include "base/work.h"
#include "numeric/vector.h"
#include "shape/formula/evaluate.h"
#include "shape/formula/nurbs.h"
#include "spline/spline.h"
#include "spline/surface/normal.h"

#include <string.h>

enum {
    MOST_SPANS = 4000 /* of one direction */
};

/* ---- properties ---- */

static void formula_free(batten_surface *surface)
{
    bat_formula_surface *made = (bat_formula_surface *)(void *)surface;
    if (made->shared && bat_references_drop(&made->shared->references)) {
        made->shared->formula.free(made->shared->data);
        bat_release(made->shared);
    }
    bat_release(made->spans[0]);
    bat_release(made);
}

static bool formula_is_periodic(const batten_surface *surface, batten_direction direction)
{
    (void)surface;
    (void)direction;
    return false;
}

static int formula_spans(const batten_surface *surface, batten_direction direction,
                         double *knots)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const int count = made->count[direction];
    if (knots)
        memcpy(knots, made->spans[direction], (size_t)count * sizeof *knots);
    return count;
}

static batten_box formula_box(const batten_surface *surface)
{
    return bat_formula_of(surface)->box;
}

/* At BAT_FORMULA_LIKE_DEGREE + 1 places of each span of the other direction. */
static bool formula_is_closed(const batten_surface *surface, batten_direction direction,
                              double tolerance)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const batten_direction along = bat_other(direction);
    const batten_interval ends = bat_formula_domain(surface, direction);
    const bool at_u = direction == BATTEN_U;
    for (int s = 0; s + 1 < made->count[along]; s++)
        for (int i = 0; i <= BAT_FORMULA_LIKE_DEGREE; i++) {
            const double a = made->spans[along][s], b = made->spans[along][s + 1];
            const double t =
                i < BAT_FORMULA_LIKE_DEGREE ? a + (b - a) * i / BAT_FORMULA_LIKE_DEGREE : b;
            double first[3] = {0}, last[3] = {0};
            if (batten_surface_evaluate(surface, at_u ? ends.a : t, at_u ? t : ends.a, 0,
                                        first) != BATTEN_OK ||
                batten_surface_evaluate(surface, at_u ? ends.b : t, at_u ? t : ends.b, 0,
                                        last) != BATTEN_OK ||
                bat_distance(surface->dimension, first, last) > tolerance)
                return false;
        }
    return true;
}

/* ---- NURBS, maps ---- */

/* No vector becomes longer than this times its length. */
static double stretch_of(const batten_affine *map)
{
    return bat_norm(9, &map->m[0][0]);
}

static batten_status formula_transform(const batten_surface *surface, const batten_affine *map,
                                       batten_surface **out);
static batten_status formula_turn_over(const batten_surface *surface, batten_surface **out);

static batten_status formula_to_nurbs(const batten_surface *surface, double tolerance,
                                      batten_surface **out, double *error)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const bat_formula *formula = &made->shared->formula;
    if (!formula->to_nurbs)
        return bat_surface_approximate(surface, tolerance, BAT_APPROXIMATE_MOST, out, error);
    if (!made->mapped && !made->turned)
        return formula->to_nurbs(made->shared->data, tolerance, out, error);
    batten_surface *own = NULL, *turned = NULL;
    double own_error = 0;
    const double stretch = stretch_of(&made->map);
    batten_status status = formula->to_nurbs(
        made->shared->data, stretch > 0 ? tolerance / stretch : tolerance, &own, &own_error);
    if (status == BATTEN_OK && made->turned)
        status = bat_surface_replace(bat_nurbs_turn_over(own, &turned), &own, &turned);
    if (status == BATTEN_OK)
        status = batten_surface_transform(own, &made->map, out);
    if (status == BATTEN_OK && error)
        *error = own_error * stretch;
    batten_surface_unref(own);
    return status;
}

static const bat_surface_kind formula_kind = {
    .name = "formula",
    .highest_order = BAT_FORMULA_HIGHEST_ORDER,
    .free = formula_free,
    .domain = bat_formula_domain,
    .is_periodic = formula_is_periodic,
    .spans = formula_spans,
    .is_closed = formula_is_closed,
    .box = formula_box,
    .evaluate = bat_formula_evaluate,
    .evaluate_many = bat_formula_evaluate_many,
    .evaluate_grid = bat_formula_evaluate_grid,
    .normal_grid = bat_formula_normal_grid,
    .local = bat_formula_local,
    .isocurve = bat_formula_isocurve,
    .to_nurbs = formula_to_nurbs,
    .transform = formula_transform,
    .turn_over = formula_turn_over,
};

/* ---- making ---- */

static batten_status check_breaks(const bat_formula_axis *axis, const char *name)
{
    if (axis->count < 2 || axis->count > MOST_SPANS)
        return bat_fail(axis->count < 2 ? BATTEN_BAD_ARGUMENT : BATTEN_TOO_LARGE,
                        "%d breaks in %s; there must be 2..%d", axis->count, name, MOST_SPANS);
    assert(axis->smoothness >= 0 && axis->smoothness <= 2);
    return bat_breaks_check(axis->count - 1, axis->spans);
}

/* A surface without formula yet, with room for its breaks. */
static bat_formula_surface *allocate(const int count[2])
{
    bat_formula_surface *made = bat_array(1, sizeof *made);
    double *spans = bat_array(2 * (size_t)count[0] + (size_t)count[1], sizeof *spans);
    if (!made || !spans) {
        bat_release(made);
        bat_release(spans);
        return NULL;
    }
    bat_references_begin(&made->base.references);
    for (int k = 0; k < 2; k++) {
        made->count[k] = count[k];
        made->spans[k] = k ? spans + count[0] : spans;
    }
    made->formula_u = spans + count[0] + count[1];
    return made;
}

static bat_formula_shared *share(const bat_formula *formula, void *data)
{
    bat_formula_shared *shared = bat_array(1, sizeof *shared);
    if (!shared)
        return NULL;
    bat_references_begin(&shared->references);
    shared->kind = formula_kind;
    shared->kind.name = formula->kind;
    shared->formula = *formula;
    shared->data = data;
    return shared;
}

batten_status bat_formula_create(const bat_formula *formula, void *data, int dimension,
                                 const bat_formula_axis *u, const bat_formula_axis *v,
                                 double size, batten_surface **out)
{
    const bat_formula_axis *axes[2] = {u, v};
    batten_status status = check_breaks(u, "u");
    if (status == BATTEN_OK)
        status = check_breaks(v, "v");
    if (status != BATTEN_OK)
        return status;
    bat_formula_surface *made = allocate((const int[2]){u->count, v->count});
    bat_formula_shared *shared = share(formula, data);
    if (!made || !shared) {
        if (made)
            bat_release(made->spans[0]);
        bat_release(made);
        bat_release(shared);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int k = 0; k < 2; k++) {
        memcpy(made->spans[k], axes[k]->spans, (size_t)axes[k]->count * sizeof(double));
        made->smoothness[k] = axes[k]->smoothness;
    }
    memcpy(made->formula_u, u->spans, (size_t)u->count * sizeof(double));
    made->base.kind = &shared->kind;
    made->base.dimension = dimension;
    made->shared = shared;
    made->size = size;
    made->map = batten_affine_identity();
    status = bat_formula_find_box(&made->base, &made->box);
    if (status == BATTEN_OK) {
        *out = &made->base;
        return BATTEN_OK;
    }
    bat_release(shared); /* the data go back to the caller */
    made->shared = NULL;
    formula_free(&made->base);
    return status;
}

/* Another one of the same formula, which waits for its box. */
static bat_formula_surface *copy_of(const bat_formula_surface *from)
{
    bat_formula_surface *made = allocate(from->count);
    if (!made)
        return NULL;
    for (int k = 0; k < 2; k++) {
        memcpy(made->spans[k], from->spans[k], (size_t)from->count[k] * sizeof(double));
        made->smoothness[k] = from->smoothness[k];
    }
    memcpy(made->formula_u, from->formula_u, (size_t)from->count[0] * sizeof(double));
    made->base.kind = from->base.kind;
    made->base.dimension = from->base.dimension;
    made->shared = from->shared;
    bat_references_add(&from->shared->references);
    made->mapped = from->mapped;
    made->map = from->map;
    made->turned = from->turned;
    made->size = from->size;
    made->box = from->box;
    return made;
}

static batten_status formula_transform(const batten_surface *surface, const batten_affine *map,
                                       batten_surface **out)
{
    const bat_formula_surface *from = bat_formula_of(surface);
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE,
                        "the affine map has an element that is not a finite number");
    bat_formula_surface *made = copy_of(from);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    made->mapped = true;
    made->map = batten_affine_compose(from->map, *map);
    made->size = from->size * stretch_of(map) +
                 bat_max(fabs(map->t[0]), bat_max(fabs(map->t[1]), fabs(map->t[2])));
    const batten_status status = bat_formula_find_box(&made->base, &made->box);
    if (status == BATTEN_OK)
        *out = &made->base;
    else
        formula_free(&made->base);
    return status;
}

/* Breaks from the other end, over the same domain, or over [-b, -a] where rounding would
 * join some on it. */
static void turn_breaks(int count, const double *from, double *to)
{
    const double a = from[0], b = from[count - 1];
    bool apart = true;
    for (int i = 0; i < count; i++) {
        to[i] = i == count - 1 ? b : a + (b - from[count - 1 - i]);
        apart = apart && (i == 0 || to[i] > to[i - 1]);
    }
    for (int i = 0; !apart && i < count; i++)
        to[i] = -from[count - 1 - i];
}

static batten_status formula_turn_over(const batten_surface *surface, batten_surface **out)
{
    bat_formula_surface *made = copy_of(bat_formula_of(surface));
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    turn_breaks(made->count[BATTEN_U], bat_formula_of(surface)->spans[BATTEN_U],
                made->spans[BATTEN_U]);
    made->turned = !made->turned;
    *out = &made->base;
    return BATTEN_OK;
}
