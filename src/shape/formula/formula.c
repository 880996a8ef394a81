/* What all surfaces that are formulas have in common. */
#include "shape/formula/formula.h"

#include "base/work.h"
#include "numeric/vector.h"
#include "shape/formula/nurbs.h"
#include "spline/spline.h"
#include "spline/surface/normal.h"

#include <string.h>

enum {
    HIGHEST_ORDER = 3,
    CHUNK = 64,       /* points of one piece of work */
    LIKE_DEGREE = 5,  /* roundoff of derivatives is taken to be as of this degree */
    MOST_SPANS = 4000 /* of one direction */
};

/* The formula, which a surface shares with its images under maps. */
typedef struct {
    bat_references references;
    bat_surface_kind kind; /* with the formula's name */
    bat_formula formula;
    void *data;
} shared_formula;

typedef struct {
    batten_surface base;
    shared_formula *shared;
    bool mapped;
    batten_affine map;
    int count[2]; /* of the breaks */
    int smoothness[2];
    double *spans[2];  /* one block */
    bool turned;       /* u runs against that of the formula */
    double *formula_u; /* [count[0]], in the same block: the formula's own breaks */
    double size;
    batten_box box;
} formula_surface;

static const formula_surface *formula_of(const batten_surface *surface)
{
    return (const formula_surface *)(const void *)surface;
}

/* ---- properties ---- */

static void formula_free(batten_surface *surface)
{
    formula_surface *made = (formula_surface *)(void *)surface;
    if (made->shared && bat_references_drop(&made->shared->references)) {
        made->shared->formula.free(made->shared->data);
        bat_release(made->shared);
    }
    bat_release(made->spans[0]);
    bat_release(made);
}

static batten_interval formula_domain(const batten_surface *surface, batten_direction direction)
{
    const formula_surface *made = formula_of(surface);
    const double *spans = made->spans[direction];
    return (batten_interval){spans[0], spans[made->count[direction] - 1]};
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
    const formula_surface *made = formula_of(surface);
    const int count = made->count[direction];
    if (knots)
        memcpy(knots, made->spans[direction], (size_t)count * sizeof *knots);
    return count;
}

static batten_box formula_box(const batten_surface *surface)
{
    return formula_of(surface)->box;
}

/* At LIKE_DEGREE + 1 places of each span of the other direction. */
static bool formula_is_closed(const batten_surface *surface, batten_direction direction,
                              double tolerance)
{
    const formula_surface *made = formula_of(surface);
    const batten_direction along = bat_other(direction);
    const batten_interval ends = formula_domain(surface, direction);
    const bool at_u = direction == BATTEN_U;
    for (int s = 0; s + 1 < made->count[along]; s++)
        for (int i = 0; i <= LIKE_DEGREE; i++) {
            const double a = made->spans[along][s], b = made->spans[along][s + 1];
            const double t = i < LIKE_DEGREE ? a + (b - a) * i / LIKE_DEGREE : b;
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

/* ---- evaluation ---- */

/* Bring a parameter into the domain, and say from which side it is approached. */
static batten_status place(const formula_surface *made, batten_direction direction, double *at,
                           batten_side *side)
{
    const batten_interval domain = formula_domain(&made->base, direction);
    const batten_status status = bat_knots_clip(domain.a, domain.b, at);
    if (status == BATTEN_OK && *at == domain.b)
        *side = BATTEN_FROM_LEFT;
    else if (status == BATTEN_OK && *at == domain.a)
        *side = BATTEN_FROM_RIGHT;
    return status;
}

/* From a place of the surface, when that is turned, to the formula's own: breaks to breaks. */
static void turn_place(const formula_surface *made, double *u, batten_side *side)
{
    const double *spans = made->spans[BATTEN_U];
    const int s = bat_breaks_span(made->count[BATTEN_U], spans, *u, *side);
    const double *own = &made->formula_u[made->count[BATTEN_U] - 2 - s];
    *u = *u == spans[s + 1] ? own[0]
                            : bat_max(own[0], bat_min(own[1] - (*u - spans[s]), own[1]));
    *side = *side == BATTEN_FROM_LEFT ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
}

/* Derivatives by -u, an odd number of times. */
static void turn_derivatives(int dimension, int order, double *out)
{
    for (int k = 1; k <= order; k += 2)
        for (int l = 0; k + l <= order; l++)
            for (int i = 0; i < dimension; i++)
                out[BATTEN_SURFACE_DERIVATIVE(k, l) * dimension + i] *= -1;
}

/* The image of a point, and of its derivatives, under the map. */
static void apply_map(const formula_surface *made, int order, double *out)
{
    batten_affine linear = made->map;
    memset(linear.t, 0, sizeof linear.t);
    const int d = made->base.dimension;
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++, out += d) {
        const batten_vec3 moved =
            batten_affine_apply(i == 0 ? made->map : linear, bat_vec3_of(d, out));
        const double xyz[3] = {moved.x, moved.y, moved.z};
        memcpy(out, xyz, (size_t)d * sizeof *out);
    }
}

static batten_status formula_evaluate(const batten_surface *surface, double u, double v,
                                      batten_side side_u, batten_side side_v, int order,
                                      double *out)
{
    const formula_surface *made = formula_of(surface);
    const shared_formula *shared = made->shared;
    if (order > HIGHEST_ORDER)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "derivatives of order %d are wanted; a %s surface has them up to %d",
                        order, shared->formula.kind, HIGHEST_ORDER);
    batten_status status = place(made, BATTEN_U, &u, &side_u);
    if (status == BATTEN_OK)
        status = place(made, BATTEN_V, &v, &side_v);
    if (status != BATTEN_OK)
        return status;
    if (made->turned)
        turn_place(made, &u, &side_u);
    double values[BATTEN_SURFACE_DERIVATIVES(HIGHEST_ORDER) * 3];
    const size_t size = (size_t)BATTEN_SURFACE_DERIVATIVES(order) * (size_t)surface->dimension;
    status = shared->formula.evaluate(shared->data, u, v, side_u, side_v, order, values);
    if (status != BATTEN_OK)
        return status;
    if (made->turned)
        turn_derivatives(surface->dimension, order, values);
    if (made->mapped)
        apply_map(made, order, values);
    if (!bat_all_finite(values, size))
        return bat_fail(BATTEN_OVERFLOW, "the numbers at (%.17g, %.17g) are too large", u, v);
    memcpy(out, values, size * sizeof *out);
    return BATTEN_OK;
}

/* A batch: points one by one, or a grid, of values or of points and normals. */
typedef struct {
    const batten_surface *surface;
    const double *u, *v; /* many points: u holds the pairs, v is NULL */
    size_t count_v;
    int order;
    double *out;              /* or: */
    double *points, *normals; /* either may be NULL */
} batch;

static void parameters_at(const batch *work, size_t i, double at[2])
{
    at[0] = work->v ? work->u[i / work->count_v] : work->u[2 * i];
    at[1] = work->v ? work->v[i % work->count_v] : work->u[2 * i + 1];
}

static batten_status evaluate_chunk(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    const size_t size =
        (size_t)BATTEN_SURFACE_DERIVATIVES(work->order) * (size_t)work->surface->dimension;
    batten_status status = BATTEN_OK;
    for (size_t i = begin; i < end && status == BATTEN_OK; i++) {
        double at[2];
        parameters_at(work, i, at);
        status = formula_evaluate(work->surface, at[0], at[1], BATTEN_FROM_RIGHT,
                                  BATTEN_FROM_RIGHT, work->order, work->out + i * size);
    }
    return status;
}

/* Before anything is written: are all parameters in the domain? */
static batten_status check_parameters(const batten_surface *surface, batten_direction direction,
                                      size_t count, const double *values, size_t step)
{
    const batten_interval domain = formula_domain(surface, direction);
    for (size_t i = 0; i < count; i++) {
        double at = values[i * step];
        const batten_status status = bat_knots_clip(domain.a, domain.b, &at);
        if (status != BATTEN_OK)
            return bat_fail(status, "%c[%zu] = %.17g is not in the domain [%g, %g]",
                            direction == BATTEN_U ? 'u' : 'v', i, at, domain.a, domain.b);
    }
    return BATTEN_OK;
}

static batten_status formula_evaluate_many(const batten_surface *surface, size_t count,
                                           const double *uv, int order, const batten_job *job,
                                           double *out)
{
    batch work = {.surface = surface, .u = uv, .order = order, .out = out};
    batten_status status = check_parameters(surface, BATTEN_U, count, uv, 2);
    if (status == BATTEN_OK)
        status = check_parameters(surface, BATTEN_V, count, uv + 1, 2);
    return status == BATTEN_OK ? bat_parallel(job, count, CHUNK, evaluate_chunk, &work)
                               : status;
}

static batten_status check_grid(const batch *work, size_t count_u, size_t count_v)
{
    batten_status status = check_parameters(work->surface, BATTEN_U, count_u, work->u, 1);
    if (status == BATTEN_OK)
        status = check_parameters(work->surface, BATTEN_V, count_v, work->v, 1);
    if (status == BATTEN_OK && count_v > 0 && count_u > SIZE_MAX / 32 / count_v)
        status = bat_fail(BATTEN_TOO_LARGE, "a grid of %zu x %zu points", count_u, count_v);
    return status;
}

static batten_status formula_evaluate_grid(const batten_surface *surface, size_t count_u,
                                           const double *u, size_t count_v, const double *v,
                                           int order, const batten_job *job, double *out)
{
    batch work = {
        .surface = surface, .u = u, .v = v, .count_v = count_v, .order = order, .out = out};
    const batten_status status = check_grid(&work, count_u, count_v);
    return status == BATTEN_OK
               ? bat_parallel(job, count_u * count_v, CHUNK, evaluate_chunk, &work)
               : status;
}

static batten_status normal_chunk(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    for (size_t i = begin; i < end; i++) {
        double at[2], point[3] = {0};
        batten_vec3 n = {0, 0, 0};
        parameters_at(work, i, at);
        batten_status status = batten_surface_evaluate(work->surface, at[0], at[1], 0, point);
        if (status == BATTEN_OK && work->normals)
            status = batten_surface_normal(work->surface, at[0], at[1], &n, NULL);
        if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
            return status;
        if (work->points)
            memcpy(work->points + 3 * i, point, sizeof point);
        if (work->normals)
            memcpy(work->normals + 3 * i, (const double[3]){n.x, n.y, n.z}, sizeof point);
    }
    return BATTEN_OK;
}

static batten_status formula_normal_grid(const batten_surface *surface, size_t count_u,
                                         const double *u, size_t count_v, const double *v,
                                         const batten_job *job, double *points, double *normals)
{
    batch work = {.surface = surface,
                  .u = u,
                  .v = v,
                  .count_v = count_v,
                  .points = points,
                  .normals = normals};
    const batten_status status = check_grid(&work, count_u, count_v);
    return status == BATTEN_OK
               ? bat_parallel(job, count_u * count_v, CHUNK, normal_chunk, &work)
               : status;
}

static void formula_local(const batten_surface *surface, double u, double v, batten_side side_u,
                          batten_side side_v, bat_surface_local *out)
{
    const formula_surface *made = formula_of(surface);
    const double at[2] = {u, v};
    const batten_side sides[2] = {side_u, side_v};
    out->largest = made->size;
    for (int k = 0; k < 2; k++) {
        const int s = bat_breaks_span(made->count[k], made->spans[k], at[k], sides[k]);
        out->degree[k] = LIKE_DEGREE;
        out->span[k] = made->spans[k][s + 1] - made->spans[k][s];
    }
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
    const formula_surface *made = formula_of(surface);
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
    .highest_order = HIGHEST_ORDER,
    .free = formula_free,
    .domain = formula_domain,
    .is_periodic = formula_is_periodic,
    .spans = formula_spans,
    .is_closed = formula_is_closed,
    .box = formula_box,
    .evaluate = formula_evaluate,
    .evaluate_many = formula_evaluate_many,
    .evaluate_grid = formula_evaluate_grid,
    .normal_grid = formula_normal_grid,
    .local = formula_local,
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
static formula_surface *allocate(const int count[2])
{
    formula_surface *made = bat_array(1, sizeof *made);
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

static shared_formula *share(const bat_formula *formula, void *data)
{
    shared_formula *shared = bat_array(1, sizeof *shared);
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
    formula_surface *made = allocate((const int[2]){u->count, v->count});
    shared_formula *shared = share(formula, data);
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
static formula_surface *copy_of(const formula_surface *from)
{
    formula_surface *made = allocate(from->count);
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
    const formula_surface *from = formula_of(surface);
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the affine map has an element that is no number");
    formula_surface *made = copy_of(from);
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

/* Breaks from the other end, over the same domain, or over [-b, -a] where not all are told
 * apart on it. */
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
    formula_surface *made = copy_of(formula_of(surface));
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    turn_breaks(made->count[BATTEN_U], formula_of(surface)->spans[BATTEN_U],
                made->spans[BATTEN_U]);
    made->turned = !made->turned;
    *out = &made->base;
    return BATTEN_OK;
}

int bat_formula_smoothness(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->evaluate == formula_evaluate
               ? formula_of(surface)->smoothness[direction]
               : 0;
}
