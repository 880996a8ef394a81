/* The equations of a penalised fit solved by conjugate gradients. */
#include "base/plural.h"
#include "shape/cloud/scattered.h"

#include <string.h>

enum { MOST_STEPS = 5000 };

/* out = (data + lambda energy) x. */
static void multiply_matrix(const bat_scatter *s, double lambda, const double *x, double *out)
{
    const bat_net_system *y = &s->system;
    const int q = s->axis[1].degree, nu = s->axis[0].count, nv = s->axis[1].count;
    memset(out, 0, y->unknowns * sizeof *out);
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const size_t here = (size_t)i * (size_t)nv + (size_t)j, at = here * y->stencil;
            double sum = bat_net_entry(y, at + (size_t)q, lambda) * x[here];
            for (int a = 0; a <= s->axis[0].degree && i + a < nu; a++)
                for (int b = a > 0 ? bat_max_int(-q, -j) : 1; b <= q && j + b < nv; b++) {
                    const size_t k = at + (size_t)(a * (2 * q + 1) + b + q);
                    const double value = bat_net_entry(y, k, lambda);
                    const size_t there = (size_t)(i + a) * (size_t)nv + (size_t)(j + b);
                    sum += value * x[there];
                    out[there] += value * x[here];
                }
            out[here] += sum;
        }
}

typedef struct {
    double *rest, *way, *image, *diagonal; /* [unknowns] */
} gradients;

static double scaled_square(size_t n, const double *rest, const double *diagonal)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += rest[i] * rest[i] / diagonal[i];
    return sum;
}

static batten_status descend_conjugate(bat_scatter *s, double lambda, const gradients *g,
                                       const double *b, double *x)
{
    bat_net_system *y = &s->system;
    const size_t n = y->unknowns;
    multiply_matrix(s, lambda, x, g->image);
    for (size_t i = 0; i < n; i++)
        g->rest[i] = b[i] - g->image[i];
    /* Nine digits of the right side, squared. */
    double square = scaled_square(n, g->rest, g->diagonal), before = 0;
    const double enough = 1e-18 * scaled_square(n, b, g->diagonal);
    for (int step = 0; square > enough; step++, y->iterations++) {
        /* The square root of `enough` stands for 1e-9. */
        if (step == MOST_STEPS)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "conjugate gradients leave %g of the right side after %d step%s",
                            sqrt(square / enough) * 1e-9, step, bat_plural(step));
        for (size_t i = 0; i < n; i++)
            g->way[i] =
                g->rest[i] / g->diagonal[i] + (step > 0 ? square / before * g->way[i] : 0);
        multiply_matrix(s, lambda, g->way, g->image);
        double along = 0;
        for (size_t i = 0; i < n; i++)
            along += g->way[i] * g->image[i];
        const double by = square / along;
        for (size_t i = 0; i < n; i++) {
            x[i] += by * g->way[i];
            g->rest[i] -= by * g->image[i];
        }
        before = square;
        square = scaled_square(n, g->rest, g->diagonal);
        const batten_status status = bat_work_step(&s->work, n, 0.5, "scattered data");
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

static batten_status find_diagonal(const bat_scatter *s, double lambda, double *diagonal)
{
    const bat_net_system *y = &s->system;
    for (size_t i = 0; i < y->unknowns; i++) {
        diagonal[i] = bat_net_entry(y, i * y->stencil + (size_t)s->axis[1].degree, lambda);
        if (!(diagonal[i] > 0))
            return bat_fail(BATTEN_SINGULAR_SYSTEM, "control point %zu has no datum", i + 1);
    }
    return BATTEN_OK;
}

batten_status bat_scatter_solve_gradients(bat_scatter *s, double lambda)
{
    bat_net_system *y = &s->system;
    const size_t n = y->unknowns;
    double *memory = bat_array3(n, 4, sizeof *memory);
    if (!memory)
        return BATTEN_OUT_OF_MEMORY;
    const gradients g = {memory, memory + n, memory + 2 * n, memory + 3 * n};
    batten_status status = find_diagonal(s, lambda, g.diagonal);
    for (int k = 0; k < y->rights && status == BATTEN_OK; k++)
        status = descend_conjugate(s, lambda, &g, y->right + (size_t)k * n,
                                   y->solved + (size_t)k * n);
    bat_release(memory);
    return status;
}
