/* Whether one curve is the image of another under an affine map, and which map. */
#include "inspect/affine/exact_span.h"
#include "numeric/dense.h"
#include "numeric/eigen.h"
#include "numeric/vector.h"
#include <batten/invariants.h>

#include <string.h>

/* Relative: below that entries of the canonical form count as 0, and points as on a line or in
 * a plane. What is proposed so is then measured. */
static const double zero = 1e-10, flat = 1e-12;

/* ---- the map of least squares ---- */

/* Points about their mean, and their directions: rows, those along which they spread most last.
 */
typedef struct {
    double mean[3], axes[9];
} spread;

static void measure_spread(int count, int d, const double *points, spread *s)
{
    double products[9] = {0}, values[3];
    memset(s->mean, 0, sizeof s->mean);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < d; k++)
            s->mean[k] += (points[i * d + k] - s->mean[k]) / (i + 1);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < d; k++)
            for (int l = 0; l < d; l++)
                products[k * d + l] +=
                    (points[i * d + k] - s->mean[k]) * (points[i * d + l] - s->mean[l]);
    bat_eigen_symmetric(d, products, values, s->axes);
}

/* A direction of length one that is square to images[0 .. count - 1]. */
static void square_direction(int d, int count, double (*images)[3], double *out)
{
    double basis[3][3], best = 0;
    int kept = 0;
    for (int i = 0; i < count; i++) {
        double v[3] = {0};
        memcpy(v, images[i], (size_t)d * sizeof *v);
        for (int b = 0; b < 2 * kept; b++) {
            const double along = bat_dot(d, v, basis[b % kept]);
            for (int k = 0; k < d; k++)
                v[k] -= along * basis[b % kept][k];
        }
        const double size = bat_norm(d, v);
        for (int k = 0; k < d && size > 0; k++)
            basis[kept][k] = v[k] / size;
        kept += size > 0;
    }
    for (int axis = 0; axis < d; axis++) {
        double v[3] = {axis == 0, axis == 1, axis == 2};
        for (int b = 0; b < 2 * kept; b++) {
            const double along = bat_dot(d, v, basis[b % kept]);
            for (int k = 0; k < d; k++)
                v[k] -= along * basis[b % kept][k];
        }
        const double size = bat_norm(d, v);
        for (int k = 0; k < d && size > best; k++)
            out[k] = v[k] / size;
        best = bat_max(best, size);
    }
}

/* Images of the axes of P become the matrix, with mean to mean. */
static void assemble(int d, const spread *s, double (*images)[3], const double *mean,
                     batten_affine *map)
{
    *map = batten_affine_identity();
    for (int row = 0; row < d; row++) {
        map->t[row] = mean[row];
        for (int column = 0; column < d; column++) {
            map->m[row][column] = 0;
            for (int k = 0; k < d; k++)
                map->m[row][column] += images[k][row] * s->axes[k * d + column];
        }
        for (int column = 0; column < d; column++)
            map->t[row] -= map->m[row][column] * s->mean[column];
    }
}

static double farthest(int count, int d, const double *p, const double *q,
                       const batten_affine *map)
{
    double most = 0;
    for (int i = 0; i < count; i++) {
        const batten_vec3 image = batten_affine_apply(*map, bat_vec3_of(d, p + i * d));
        const double at[3] = {image.x, image.y, image.z};
        most = bat_max(most, bat_distance(d, at, q + i * d));
    }
    return most;
}

/* The map that brings p nearest to q, points [count][d] that spread in `rank` directions; the
 * others are mapped squarely. *error: the farthest point then. */
static batten_status fit_map(int count, int d, int rank, const double *p, const double *q,
                             batten_affine *map, double *error)
{
    spread of_p, of_q;
    double images[3][3] = {{0}};
    double *a = bat_array3((size_t)count, (size_t)bat_max_int(rank, 1), sizeof *a);
    double *b = bat_array3((size_t)count, (size_t)d, sizeof *b);
    batten_status status = a && b ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        measure_spread(count, d, p, &of_p);
        measure_spread(count, d, q, &of_q);
    }
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        double v[3];
        for (int k = 0; k < d; k++) {
            v[k] = p[i * d + k] - of_p.mean[k];
            b[i * d + k] = q[i * d + k] - of_q.mean[k];
        }
        for (int k = 0; k < rank; k++)
            a[i * rank + k] = bat_dot(d, v, of_p.axes + (d - 1 - k) * d);
    }
    if (status == BATTEN_OK && rank > 0)
        status = bat_dense_least_squares(count, rank, a, (size_t)d, b);
    double size = 0;
    for (int k = 0; k < rank && status == BATTEN_OK; k++) {
        memcpy(images[k], b + k * d, (size_t)d * sizeof *b);
        size = bat_max(size, bat_norm(d, images[k]));
    }
    if (status == BATTEN_OK) {
        double of_axes[3][3]; /* the axes rise, `images` begin with the last */
        for (int k = rank; k < d; k++) {
            square_direction(d, k, images, images[k]);
            for (int l = 0; l < d && size > 0; l++)
                images[k][l] *= size;
        }
        for (int k = 0; k < d; k++)
            memcpy(of_axes[d - 1 - k], images[k], sizeof images[k]);
        assemble(d, &of_p, of_axes, of_q.mean, map);
        *error = farthest(count, d, p, q, map);
    }
    bat_release(a);
    bat_release(b);
    return status;
}

/* ---- candidates ---- */

typedef struct {
    int d, rank;
    double tolerance;
    batten_affine_match best;
} search;

/* Two curves of the same degree and knots: are their points images? */
static batten_status try_points(search *s, int count, const double *p, const double *q,
                                double c, double f, bool is_whole)
{
    batten_affine_match match = {.c = c, .f = f, .is_whole = is_whole};
    const batten_status status = fit_map(count, s->d, s->rank, p, q, &match.map, &match.error);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return BATTEN_OK; /* no map, no match */
    if (status == BATTEN_OK && match.error < s->best.error)
        s->best = match;
    return status;
}

/* End to end; `backwards`: the end of one to the start of the other. */
static batten_status try_ends(search *s, const batten_curve *from, const batten_curve *to,
                              bool backwards)
{
    const batten_interval x = batten_curve_domain(from), y = batten_curve_domain(to);
    batten_curve *turned = NULL, *both[2] = {NULL, NULL};
    batten_status status = BATTEN_OK;
    if (backwards)
        status = batten_curve_reverse(from, &turned);
    else
        turned = batten_curve_ref(from);
    if (status == BATTEN_OK)
        status = batten_curves_unify(2, (const batten_curve *const[]){turned, to}, both);
    if (status == BATTEN_OK) {
        const double c = (x.b - x.a) / (y.b - y.a) * (backwards ? -1 : 1);
        const double f = (backwards ? x.b : x.a) - c * y.a;
        status = try_points(s, batten_curve_point_count(both[0]), batten_curve_points(both[0]),
                            batten_curve_points(both[1]), c, f, false);
    }
    batten_curve_unref(both[0]);
    batten_curve_unref(both[1]);
    batten_curve_unref(turned);
    return status;
}

/* The Bezier points of the same polynomial from t = a to t = b: blossoms. */
static void part_of(int n, int d, const double *points, double a, double b, double *out)
{
    double row[BATTEN_MAX_DEGREE + 1];
    for (int k = 0; k < d; k++)
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++)
                row[j] = points[j * d + k];
            for (int r = 0; r < n; r++) {
                const double t = r < i ? b : a;
                for (int j = 0; j < n - r; j++)
                    row[j] = (1 - t) * row[j] + t * row[j + 1];
            }
            out[i * d + k] = row[0];
        }
}

/* t = c s + f of single polynomials with parameters t, s from 0 to 1. */
typedef struct {
    int n;
    const double *p, *q;
    batten_interval x, y; /* their domains */
} pair;

static batten_status try_whole(search *s, const pair *two, double c, double f)
{
    double part[3 * (BATTEN_MAX_DEGREE + 1)];
    const double a = two->x.b - two->x.a, b = two->y.b - two->y.a;
    part_of(two->n, s->d, two->p, f, f + c, part);
    if (bat_first_not_finite(part, (size_t)(s->d * (two->n + 1))) <
        (size_t)(s->d * (two->n + 1)))
        return BATTEN_OK;
    /* u = x.a + a t, v = y.a + b s */
    const double scale = a / b * c;
    return try_points(s, two->n + 1, part, two->q, scale, two->x.a + a * f - scale * two->y.a,
                      true);
}

/* c and f from the canonical forms: |c| is the ratio of the radii, its sign is tried. */
static batten_status try_forms(search *s, const pair *two, const batten_canonical *of_p,
                               const batten_canonical *of_q)
{
    batten_status status = BATTEN_OK;
    if (memcmp(of_p->pivots, of_q->pivots, sizeof of_p->pivots) != 0 || !of_p->has_shift ||
        (of_p->radius > 0) != (of_q->radius > 0))
        return BATTEN_OK;
    const double size = of_q->radius > 0 ? of_p->radius / of_q->radius : 1;
    for (int sign = 1; sign >= -1 && status == BATTEN_OK; sign -= 2)
        status = try_whole(s, two, sign * size, of_p->shift - sign * size * of_q->shift);
    return status;
}

static batten_status try_invariants(search *s, const pair *two)
{
    batten_canonical *forms = bat_array(2, sizeof *forms);
    batten_status status = forms ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_canonical_form(s->d, two->n, two->p, zero, &forms[0]);
    if (status == BATTEN_OK)
        status = batten_canonical_form(s->d, two->n, two->q, zero, &forms[1]);
    if (status == BATTEN_OK)
        status = try_forms(s, two, &forms[0], &forms[1]);
    bat_release(forms);
    return status;
}

static batten_status compare(search *s, const batten_curve *from, const batten_curve *to)
{
    const int n = batten_curve_degree(from);
    const bool are_single =
        batten_curve_spans(from, NULL) == 2 && batten_curve_spans(to, NULL) == 2;
    const pair two = {n, batten_curve_points(from), batten_curve_points(to),
                      batten_curve_domain(from), batten_curve_domain(to)};
    const int rank =
        bat_flatness_of_points(s->d, batten_curve_point_count(to), two.q, flat).dimension;
    s->rank =
        bat_flatness_of_points(s->d, batten_curve_point_count(from), two.p, flat).dimension;
    if (s->rank != rank) /* a map that can be undone keeps it */
        return BATTEN_OK;
    batten_status status = try_ends(s, from, to, false);
    if (status == BATTEN_OK && s->best.error > s->tolerance)
        status = try_ends(s, from, to, true);
    if (status == BATTEN_OK && s->best.error > s->tolerance && are_single)
        status = try_invariants(s, &two);
    return status;
}

/* Bezier pieces of a degree, in a dimension. */
static batten_status prepare(const batten_curve *curve, int degree, int dimension,
                             batten_curve **out)
{
    batten_curve *space = NULL, *high = NULL;
    batten_status status = batten_curve_to_dimension(curve, dimension, &space);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(space, degree - batten_curve_degree(curve), &high);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(high, out);
    batten_curve_unref(space);
    batten_curve_unref(high);
    return status;
}

static batten_status check_arguments(const batten_curve *from, const batten_curve *to,
                                     double tolerance)
{
    const int d = bat_min_int(batten_curve_dimension(from), batten_curve_dimension(to));
    if (d < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "curves are compared in 2 or 3 dimensions, not in %d", d);
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance %g is not 0 or more", tolerance);
    if (batten_curve_is_rational(from) || batten_curve_is_rational(to))
        return bat_fail(BATTEN_UNSUPPORTED,
                        "polynomial curves are compared, not rational ones");
    return BATTEN_OK;
}

batten_status batten_curve_affine_match(const batten_curve *from, const batten_curve *to,
                                        double tolerance, batten_affine_match *out)
{
    const int n = bat_max_int(batten_curve_degree(from), batten_curve_degree(to));
    search s = {.d = bat_max_int(batten_curve_dimension(from), batten_curve_dimension(to)),
                .tolerance = tolerance,
                .best = {.map = batten_affine_identity(), .c = 1, .error = HUGE_VAL}};
    batten_curve *p = NULL, *q = NULL;
    batten_status status = check_arguments(from, to, tolerance);
    if (status == BATTEN_OK)
        status = prepare(from, n, s.d, &p);
    if (status == BATTEN_OK)
        status = prepare(to, n, s.d, &q);
    if (status == BATTEN_OK)
        status = compare(&s, p, q);
    batten_curve_unref(p);
    batten_curve_unref(q);
    if (status != BATTEN_OK)
        return status;
    s.best.found = s.best.error <= tolerance;
    *out = s.best;
    return BATTEN_OK;
}
