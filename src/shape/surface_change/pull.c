/* Places of a surface moved to where they are wanted, with the least change of its control points. */
#include "numeric/dense.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/surface/change.h"
#include <batten/extend.h>

#include <string.h>

/* The pulls of one surface. Points of a periodic direction that repeat are one unknown. */
typedef struct {
    const bat_nurbs *nurbs;
    int own[2];     /* unknowns in u and v */
    bool *fixed[2]; /* [own] rows and columns that stay */
    double *share; /* [count][own u][own v] what each point does to each place, 0 where fixed */
    double *gram;  /* [count][count] */
    double *factor; /* [count][3] from the moves that are wanted to multipliers */
    int *pivots;    /* [count] */
} system_of_pulls;

static void release_system(system_of_pulls *s)
{
    bat_release(s->fixed[0]);
    bat_release(s->fixed[1]);
    bat_release(s->share);
    bat_release(s->gram);
    bat_release(s->factor);
    bat_release(s->pivots);
}

/* Is this rim a point? */
static bool is_pole(const bat_nurbs *nurbs, batten_direction direction, bool last)
{
    const int d = nurbs->base.dimension, n = nurbs->axes[direction].count,
              m = nurbs->axes[bat_other(direction)].count;
    const double *first = NULL;
    for (int k = 0; k < m; k++) {
        const int row = last ? n - 1 : 0;
        const int at = direction == BATTEN_U ? row * m + k : k * n + row;
        const double *point = nurbs->points + (size_t)at * (size_t)d;
        if (first && bat_distance(d, first, point) > BAT_EXACT * nurbs->largest)
            return false;
        first = first ? first : point;
    }
    return true;
}

/* Two rows beside a seam and a pole stay: the position there and the tangent plane. */
static batten_status fix_rows(system_of_pulls *s, batten_direction direction, int kept)
{
    const batten_surface *surface = &s->nurbs->base;
    const bat_axis *axis = &s->nurbs->axes[direction];
    const int n = s->own[direction];
    const bool seam =
        !axis->periodic &&
        batten_surface_is_closed(surface, direction, BAT_MEANT_SAME * s->nurbs->largest);
    s->fixed[direction] = bat_array((size_t)n, sizeof(bool));
    if (!s->fixed[direction])
        return BATTEN_OUT_OF_MEMORY;
    for (int last = 0; last < 2 && !axis->periodic; last++) {
        const int rows =
            seam || is_pole(s->nurbs, direction, last) ? bat_max_int(2, kept) : kept;
        for (int k = 0; k < rows && k < n; k++)
            s->fixed[direction][last ? n - 1 - k : k] = true;
    }
    return BATTEN_OK;
}

/* The basis functions at a place in one direction. */
typedef struct {
    int first;
    double values[BATTEN_MAX_DEGREE + 1];
} local_basis;

static batten_status find_basis(const bat_axis *axis, double at, local_basis *out)
{
    double u = at;
    const batten_status status = bat_axis_place(axis, BATTEN_FROM_RIGHT, &u);
    if (status != BATTEN_OK)
        return status;
    const int span =
        bat_knots_span(axis->degree, axis->count, axis->knots, u, BATTEN_FROM_RIGHT);
    bat_basis(axis->degree, axis->knots, span, u, 0, out->values);
    out->first = span - axis->degree;
    return BATTEN_OK;
}

static batten_status fill_shares(const system_of_pulls *s, const batten_surface_pull *pull,
                                 double *share)
{
    const bat_axis *u = &s->nurbs->axes[BATTEN_U], *v = &s->nurbs->axes[BATTEN_V];
    const double *w = s->nurbs->weights;
    local_basis a, b;
    double whole = 0, squares = 0;
    batten_status status = find_basis(u, pull->u, &a);
    if (status == BATTEN_OK)
        status = find_basis(v, pull->v, &b);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i <= u->degree; i++)
        for (int j = 0; j <= v->degree; j++) {
            const int row = a.first + i, column = b.first + j;
            const double value =
                a.values[i] * b.values[j] * (w ? w[row * v->count + column] : 1);
            const int k = row % s->own[0], l = column % s->own[1];
            whole += value;
            if (!s->fixed[0][k] && !s->fixed[1][l])
                share[k * s->own[1] + l] += value;
        }
    for (int k = 0; k < s->own[0] * s->own[1]; k++) {
        share[k] /= whole;
        squares += share[k] * share[k];
    }
    if (!(squares > BAT_MEANT_SAME))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "(%g, %g) cannot move: the control points that act there are kept",
                        pull->u, pull->v);
    return BATTEN_OK;
}

static batten_status make_system(const batten_surface *surface, int count,
                                 const batten_surface_pull *pulls, int kept, system_of_pulls *s)
{
    *s = (system_of_pulls){.nurbs = bat_surface_nurbs(surface)};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++)
        s->own[k] = bat_axis_own_count(&s->nurbs->axes[k]);
    const size_t points = (size_t)s->own[0] * (size_t)s->own[1];
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = fix_rows(s, (batten_direction)k, kept);
    s->share = bat_array3((size_t)count, points, sizeof *s->share);
    s->gram = bat_array3((size_t)count, (size_t)count, sizeof *s->gram);
    s->factor = bat_array3((size_t)count, 3, sizeof *s->factor);
    s->pivots = bat_array((size_t)count, sizeof *s->pivots);
    if (status == BATTEN_OK && !(s->share && s->gram && s->factor && s->pivots))
        status = BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        memcpy(s->factor + 3 * k, &pulls[k].by, 3 * sizeof(double));
        status = fill_shares(s, &pulls[k], s->share + (size_t)k * points);
    }
    for (int k = 0; k < count * count && status == BATTEN_OK; k++)
        for (size_t i = 0; i < points; i++)
            s->gram[k] += s->share[(size_t)(k / count) * points + i] *
                          s->share[(size_t)(k % count) * points + i];
    if (status == BATTEN_OK)
        status = bat_dense_factor(count, s->gram, s->pivots);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return bat_fail(status,
                        "the places are so near each other that one cannot move without "
                        "the other; refine the surface there or pull fewer");
    if (status == BATTEN_OK)
        bat_dense_solve(count, s->gram, s->pivots, 3, s->factor);
    return status;
}

/* Every copy of every point, by what the places need of it. */
static double move_points(const system_of_pulls *s, int count, bat_nurbs *made)
{
    const int rows = s->nurbs->axes[0].count, columns = s->nurbs->axes[1].count;
    const size_t d = (size_t)s->nurbs->base.dimension,
                 points = (size_t)s->own[0] * (size_t)s->own[1];
    double farthest = 0;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const size_t own = (size_t)(i % s->own[0] * s->own[1] + j % s->own[1]);
            double move[3] = {0, 0, 0};
            for (int k = 0; k < count; k++)
                for (int c = 0; c < 3; c++)
                    move[c] += s->share[(size_t)k * points + own] * s->factor[3 * k + c];
            for (size_t c = 0; c < d; c++)
                made->points[(size_t)(i * columns + j) * d + c] += move[c];
            farthest = bat_max(farthest, bat_norm((int)d, move));
        }
    return farthest;
}

static batten_status check_pulls(const batten_surface *surface, int count,
                                 const batten_surface_pull *pulls, int kept)
{
    if (surface->kind != &bat_nurbs_kind)
        return bat_fail(BATTEN_UNSUPPORTED, "only NURBS surfaces have control points to move");
    if (count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there is no place to move");
    if (kept < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d rows cannot be kept", kept);
    for (int k = 0; k < count; k++)
        if (bat_first_not_finite(&pulls[k].u, 5) < 5)
            return bat_fail(BATTEN_NOT_FINITE, "pull %d has a number that is not finite",
                            k + 1);
    return BATTEN_OK;
}

batten_status batten_surface_pulled(const batten_surface *surface, int count,
                                    const batten_surface_pull *pulls, int kept, double *moved,
                                    batten_surface **out)
{
    assert(surface && pulls && out);
    system_of_pulls s = {0};
    bat_nurbs *made = NULL;
    double farthest = 0;
    batten_status status = check_pulls(surface, count, pulls, kept);
    if (status == BATTEN_OK)
        status = make_system(surface, count, pulls, kept, &s);
    if (status == BATTEN_OK)
        status = bat_nurbs_copy(s.nurbs, false, &made);
    if (status == BATTEN_OK) {
        farthest = move_points(&s, count, made);
        status = bat_nurbs_finish(made, out);
    }
    if (status == BATTEN_OK && moved)
        *moved = farthest;
    release_system(&s);
    return status;
}
