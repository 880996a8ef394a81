/* Surfaces given by expressions of two parameters: quintic interpolation whose error intervals prove. */
#include "base/work.h"
#include "shape/equation/program.h"

#include <batten/grid.h>

#define DEGREE 5
#define NODES (DEGREE + 1)
#define MOST_SITES 200

/* The Lebesgue constant of six Chebyshev nodes, 2.1044, rounded up: how much interpolation there enlarges an error. */
#define LEBESGUE 2.11

typedef struct {
    const batten_equation *const *coordinates;
    batten_interval range[2];
    double tolerance;
    bat_jet_space value, sixth; /* of order 0, of order 6 in one variable */
    double missed[2];           /* the largest remainder by u, by v */
    double off;                 /* the largest distance at nodes, and rounding there */
    bat_work work;
} prover;

/* ---- values ---- */

static batten_status no_value(double u, double v)
{
    return bat_fail(BATTEN_OUT_OF_DOMAIN,
                    "there is no finite value at (%.6g, %.6g); take ranges that leave it out",
                    u, v);
}

/* The point, and half the width of what encloses it. */
static batten_status find_point(prover *p, double u, double v, double *point, double *radius)
{
    bat_interval_jet at[2], made;
    double sum = 0;
    bat_ijet_constant(&p->value, bat_interval_at(u), &at[0]);
    bat_ijet_constant(&p->value, bat_interval_at(v), &at[1]);
    for (int k = 0; k < 3; k++) {
        bat_equation_jet(p->coordinates[k], &p->value, at, &made);
        if (!bat_interval_is_finite(made.c[0]))
            return no_value(u, v);
        point[k] = bat_interval_middle(made.c[0]);
        sum += bat_interval_width(made.c[0]) * bat_interval_width(made.c[0]);
    }
    *radius = sqrt(sum);
    return BATTEN_OK;
}

/* ---- the proof ---- */

/* What Chebyshev interpolation of degree 5 by parameter `axis` leaves in a cell: |f^(6)| / 6! (h / 2)^6 / 2^5. The spline
 * is of degree 5 there, so that this is what it leaves of the difference, too. */
static batten_status find_remainder(prover *p, const bat_interval cell[2], int axis)
{
    bat_interval_jet at[2], made;
    double sum = 0;
    bat_ijet_constant(&p->sixth, cell[1 - axis], &at[1 - axis]);
    bat_ijet_variable(&p->sixth, 0, cell[axis], &at[axis]);
    for (int k = 0; k < 3; k++) {
        bat_equation_jet(p->coordinates[k], &p->sixth, at, &made);
        const double size = bat_interval_size(made.c[DEGREE + 1]);
        if (p->sixth.state == BAT_UNDEFINED)
            return no_value(cell[0].lo, cell[1].lo);
        sum += size * size;
    }
    const double half = 0.5 * bat_interval_width(cell[axis]);
    p->missed[axis] = bat_max(p->missed[axis], sqrt(sum) * bat_pow(half, DEGREE + 1) / 32);
    return BATTEN_OK;
}

static double node_of(bat_interval range, int i)
{
    return bat_interval_middle(range) -
           0.5 * bat_interval_width(range) * bat_cos((2 * i + 1) * BAT_PI / (2 * NODES));
}

/* How far the spline is off at the nodes of a cell. */
static batten_status measure_nodes(prover *p, const batten_surface *surface,
                                   const bat_interval cell[2])
{
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++) {
            const double u = node_of(cell[0], i), v = node_of(cell[1], j);
            double truth[3], made[3], radius = 0, sum = 0;
            batten_status status = find_point(p, u, v, truth, &radius);
            if (status == BATTEN_OK)
                status = batten_surface_evaluate(surface, u, v, 0, made);
            if (status != BATTEN_OK)
                return status;
            for (int k = 0; k < 3; k++)
                sum += (made[k] - truth[k]) * (made[k] - truth[k]);
            p->off = bat_max(p->off, sqrt(sum) + radius);
        }
    return BATTEN_OK;
}

static double error_of(const prover *p)
{
    return LEBESGUE * LEBESGUE * p->off + p->missed[0] + LEBESGUE * p->missed[1];
}

/* ---- cells ---- */

typedef batten_status (*cell_visitor)(prover *p, const batten_surface *surface,
                                      const bat_interval cell[2]);

static batten_status find_remainders(prover *p, const batten_surface *surface,
                                     const bat_interval cell[2])
{
    (void)surface;
    const batten_status status = find_remainder(p, cell, 0);
    return status == BATTEN_OK ? find_remainder(p, cell, 1) : status;
}

/* The next range between distinct knots, from knot `*at` on. */
static bool next_span(const batten_surface *surface, batten_direction direction, int *at,
                      bat_interval *span)
{
    const double *knots = batten_surface_knots(surface, direction);
    const int last = batten_surface_point_count(surface, direction);
    while (*at < last && !(knots[*at] < knots[*at + 1]))
        ++*at;
    if (*at >= last)
        return false;
    *span = (bat_interval){knots[*at], knots[*at + 1]};
    ++*at;
    return true;
}

static batten_status visit_cells(prover *p, const batten_surface *surface, cell_visitor visit)
{
    bat_interval cell[2];
    batten_status status = BATTEN_OK;
    int i = batten_surface_degree(surface, BATTEN_U);
    while (status == BATTEN_OK && next_span(surface, BATTEN_U, &i, &cell[0])) {
        int j = batten_surface_degree(surface, BATTEN_V);
        while (status == BATTEN_OK && next_span(surface, BATTEN_V, &j, &cell[1])) {
            status = visit(p, surface, cell);
            if (status == BATTEN_OK)
                status = bat_work_step(&p->work, 1, 0, "surface of equations");
        }
    }
    return status;
}

/* Bounds over all cells; nodes are measured only where the remainders allow the tolerance. */
static batten_status prove_surface(prover *p, const batten_surface *surface)
{
    p->missed[0] = p->missed[1] = p->off = 0;
    const batten_status status = visit_cells(p, surface, find_remainders);
    if (status != BATTEN_OK || !(error_of(p) <= p->tolerance))
        return status;
    return visit_cells(p, surface, measure_nodes);
}

/* ---- the surface ---- */

static double site_of(const batten_interval *range, int i, int count)
{
    return i + 1 == count ? range->b : range->a + (range->b - range->a) * i / (count - 1);
}

/* Through count[0] x count[1] points at even steps of the parameters. */
static batten_status make_surface(prover *p, const int count[2], batten_surface **out)
{
    const size_t all = (size_t)count[0] * (size_t)count[1];
    double *points = bat_array3(all, 3, sizeof *points);
    double *sites = bat_array((size_t)count[0] + (size_t)count[1], sizeof *sites);
    batten_status status = points && sites ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count[0] && status == BATTEN_OK; i++)
        sites[i] = site_of(&p->range[0], i, count[0]);
    for (int j = 0; j < count[1] && status == BATTEN_OK; j++)
        sites[count[0] + j] = site_of(&p->range[1], j, count[1]);
    for (size_t i = 0; i < all && status == BATTEN_OK; i++) {
        double radius;
        status =
            find_point(p, sites[i / (size_t)count[1]],
                       sites[(size_t)count[0] + i % (size_t)count[1]], points + 3 * i, &radius);
    }
    if (status == BATTEN_OK) {
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        options.degree_u = options.degree_v = DEGREE;
        options.parameters = BATTEN_GIVEN;
        options.given_u = sites;
        options.given_v = sites + count[0];
        status =
            batten_surface_interpolate((batten_grid){3, count[0], count[1], points}, &options,
                                       p->work.job, (batten_uv_out){NULL, NULL}, NULL, out);
    }
    bat_release(points);
    bat_release(sites);
    return status;
}

/* Twice as many points where the remainder is larger; both ways where it is not what is missing. */
static void refine_counts(const prover *p, int count[2])
{
    const bool enough = p->missed[0] + LEBESGUE * p->missed[1] <= 0.5 * p->tolerance;
    const bool u = enough || !(p->missed[0] < 0.5 * p->missed[1]);
    const bool v = enough || !(p->missed[1] < 0.5 * p->missed[0]);
    count[0] = u ? 2 * count[0] - 1 : count[0];
    count[1] = v ? 2 * count[1] - 1 : count[1];
}

static batten_status check_parametric(const batten_equation *const *coordinates,
                                      const batten_interval range[2], double tolerance)
{
    for (int k = 0; k < 3; k++)
        if (coordinates[k]->variable_count != 2)
            return bat_fail(BATTEN_BAD_ARGUMENT, "coordinate %d has %d variables, expected 2",
                            k + 1, coordinates[k]->variable_count);
    for (int k = 0; k < 2; k++) {
        if (!isfinite(range[k].a) || !isfinite(range[k].b))
            return bat_fail(BATTEN_NOT_FINITE, "the range of %c is not finite", "uv"[k]);
        if (!(range[k].a < range[k].b))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the range of %c from %g to %g is empty",
                            "uv"[k], range[k].a, range[k].b);
    }
    if (!(tolerance > 0) || !isfinite(tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance must be above 0, not %g",
                        tolerance);
    return BATTEN_OK;
}

static batten_status approximate_surface(prover *p, double *error, batten_surface **out)
{
    int count[2] = {NODES, NODES};
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK) {
        batten_surface *made = NULL;
        status = make_surface(p, count, &made);
        if (status == BATTEN_OK)
            status = prove_surface(p, made);
        if (status == BATTEN_OK && error_of(p) <= p->tolerance) {
            *error = error_of(p);
            *out = made;
            return BATTEN_OK;
        }
        batten_surface_unref(made);
        refine_counts(p, count);
        if (status == BATTEN_OK && (count[0] > MOST_SITES || count[1] > MOST_SITES))
            status =
                bat_fail(BATTEN_TOLERANCE_NOT_MET,
                         "%d x %d points prove no error below %g; has the surface a corner, a "
                         "root or a pole in its range?",
                         count[0] / 2 + 1, count[1] / 2 + 1, p->tolerance);
    }
    return status;
}

batten_status batten_surface_parametric(const batten_equation *const *coordinates,
                                        const batten_interval range[2], double tolerance,
                                        const batten_job *job, double *error,
                                        batten_surface **out)
{
    batten_status status = check_parametric(coordinates, range, tolerance);
    if (status != BATTEN_OK)
        return status;
    prover p = {.coordinates = coordinates,
                .range = {range[0], range[1]},
                .tolerance = tolerance,
                .work = {.job = job}};
    bat_jet_space_begin(&p.value, 2, 0);
    bat_jet_space_begin(&p.sixth, 1, DEGREE + 1);
    return approximate_surface(&p, error, out);
}
