/* Points, derivatives and normals of surfaces that are formulas, one, many or over a grid. */
#include "shape/formula/evaluate.h"

#include "base/work.h"
#include "numeric/vector.h"
#include "spline/spline.h"
#include "spline/surface/normal.h"

#include <string.h>

enum { CHUNK = 64 }; /* points of one piece of work */

/* Bring a parameter into the domain, and say from which side it is approached. */
static batten_status place_parameter(const bat_formula_surface *made,
                                     batten_direction direction, double *at, batten_side *side)
{
    const batten_interval domain = bat_formula_domain(&made->base, direction);
    const batten_status status = bat_knots_clip(domain.a, domain.b, at);
    if (status == BATTEN_OK && *at == domain.b)
        *side = BATTEN_FROM_LEFT;
    else if (status == BATTEN_OK && *at == domain.a)
        *side = BATTEN_FROM_RIGHT;
    return status;
}

/* From a place of the surface, when that is turned, to the formula's own: breaks to breaks. */
static void turn_place(const bat_formula_surface *made, bat_surface_place *at)
{
    const double u = at->u, *spans = made->spans[BATTEN_U];
    const int s = bat_breaks_span(made->count[BATTEN_U], spans, u, at->sides.u);
    const double *own = &made->formula_u[made->count[BATTEN_U] - 2 - s];
    at->u =
        u == spans[s + 1] ? own[0] : bat_max(own[0], bat_min(own[1] - (u - spans[s]), own[1]));
    at->sides.u = at->sides.u == BATTEN_FROM_LEFT ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
}

/* The place in the formula's own parameters. */
static batten_status find_place(const bat_formula_surface *made, bat_surface_place *at)
{
    batten_status status = place_parameter(made, BATTEN_U, &at->u, &at->sides.u);
    if (status == BATTEN_OK)
        status = place_parameter(made, BATTEN_V, &at->v, &at->sides.v);
    if (status == BATTEN_OK && made->turned)
        turn_place(made, at);
    return status;
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
static void apply_map(const bat_formula_surface *made, int order, double *out)
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

batten_status bat_formula_evaluate(const batten_surface *surface, const bat_surface_place *at,
                                   int order, double *out)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const bat_formula_shared *shared = made->shared;
    if (order > BAT_FORMULA_HIGHEST_ORDER)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "derivatives of order %d are wanted; a %s surface has them up to %d",
                        order, shared->formula.kind, BAT_FORMULA_HIGHEST_ORDER);
    bat_surface_place place = *at;
    batten_status status = find_place(made, &place);
    double values[BATTEN_SURFACE_DERIVATIVES(BAT_FORMULA_HIGHEST_ORDER) * 3];
    const size_t size = (size_t)BATTEN_SURFACE_DERIVATIVES(order) * (size_t)surface->dimension;
    if (status == BATTEN_OK)
        status = shared->formula.evaluate(shared->data, &place, order, values);
    if (status != BATTEN_OK)
        return status;
    if (made->turned)
        turn_derivatives(surface->dimension, order, values);
    if (made->mapped)
        apply_map(made, order, values);
    if (!bat_all_finite(values, size))
        return bat_fail(BATTEN_OVERFLOW, "the numbers at (%.17g, %.17g) are too large", place.u,
                        place.v);
    memcpy(out, values, size * sizeof *out);
    return BATTEN_OK;
}

/* A batch: points one by one, or a grid, of values or of points and normals. */
typedef struct {
    const batten_surface *surface;
    batten_uv_grid at; /* many points: u holds the pairs, v is NULL */
    int order;
    double *out;              /* or: */
    double *points, *normals; /* either may be NULL */
} batch;

static void parameters_at(const batch *work, size_t i, double at[2])
{
    const double *u = work->at.u, *v = work->at.v;
    at[0] = v ? u[i / work->at.count_v] : u[2 * i];
    at[1] = v ? v[i % work->at.count_v] : u[2 * i + 1];
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
        const bat_surface_place place = bat_surface_place_at(at[0], at[1]);
        status = bat_formula_evaluate(work->surface, &place, work->order, work->out + i * size);
    }
    return status;
}

/* Before anything is written: are all parameters in the domain? */
static batten_status check_parameters(const batten_surface *surface, batten_direction direction,
                                      size_t count, const double *values, size_t step)
{
    const batten_interval domain = bat_formula_domain(surface, direction);
    for (size_t i = 0; i < count; i++) {
        double at = values[i * step];
        const batten_status status = bat_knots_clip(domain.a, domain.b, &at);
        if (status != BATTEN_OK)
            return bat_fail(status, "%c[%zu] = %.17g is not in the domain [%g, %g]",
                            direction == BATTEN_U ? 'u' : 'v', i, at, domain.a, domain.b);
    }
    return BATTEN_OK;
}

batten_status bat_formula_evaluate_many(const batten_surface *surface, batten_batch uv,
                                        int order, const batten_job *job, double *out)
{
    batch work = {.surface = surface, .at.u = uv.at, .order = order, .out = out};
    batten_status status = check_parameters(surface, BATTEN_U, uv.count, uv.at, 2);
    if (status == BATTEN_OK)
        status = check_parameters(surface, BATTEN_V, uv.count, uv.at + 1, 2);
    return status == BATTEN_OK ? bat_parallel(job, uv.count, CHUNK, evaluate_chunk, &work)
                               : status;
}

static batten_status check_grid(const batten_surface *surface, const batten_uv_grid *at)
{
    batten_status status = check_parameters(surface, BATTEN_U, at->count_u, at->u, 1);
    if (status == BATTEN_OK)
        status = check_parameters(surface, BATTEN_V, at->count_v, at->v, 1);
    if (status == BATTEN_OK && at->count_v > 0 && at->count_u > SIZE_MAX / 32 / at->count_v)
        status =
            bat_fail(BATTEN_TOO_LARGE, "a grid of %zu x %zu points", at->count_u, at->count_v);
    return status;
}

static batten_status work_through_grid(batch *work, const batten_job *job, bat_chunk chunk)
{
    const batten_status status = check_grid(work->surface, &work->at);
    if (status != BATTEN_OK)
        return status;
    return bat_parallel(job, work->at.count_u * work->at.count_v, CHUNK, chunk, work);
}

batten_status bat_formula_evaluate_grid(const batten_surface *surface, batten_uv_grid places,
                                        int order, const batten_job *job, double *out)
{
    batch work = {.surface = surface, .at = places, .order = order, .out = out};
    return work_through_grid(&work, job, evaluate_chunk);
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
            status = batten_surface_normal(work->surface, at[0], at[1], NULL, &n);
        if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
            return status;
        if (work->points)
            memcpy(work->points + 3 * i, point, sizeof point);
        if (work->normals)
            memcpy(work->normals + 3 * i, (const double[3]){n.x, n.y, n.z}, sizeof point);
    }
    return BATTEN_OK;
}

batten_status bat_formula_normal_grid(const batten_surface *surface, batten_uv_grid places,
                                      const batten_job *job, double *points, double *normals)
{
    batch work = {.surface = surface, .at = places, .points = points, .normals = normals};
    return work_through_grid(&work, job, normal_chunk);
}

void bat_formula_local(const batten_surface *surface, const bat_surface_place *place,
                       bat_surface_local *out)
{
    const bat_formula_surface *made = bat_formula_of(surface);
    const double at[2] = {place->u, place->v};
    const batten_side sides[2] = {place->sides.u, place->sides.v};
    out->largest = made->size;
    for (int k = 0; k < 2; k++) {
        const int s = bat_breaks_span(made->count[k], made->spans[k], at[k], sides[k]);
        out->degree[k] = BAT_FORMULA_LIKE_DEGREE;
        out->span[k] = made->spans[k][s + 1] - made->spans[k][s];
    }
}

int bat_formula_smoothness(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->evaluate == bat_formula_evaluate
               ? bat_formula_of(surface)->smoothness[direction]
               : 0;
}
