/*
 * Newton's method for the energy of a chain of quintics, held back by Levenberg's and
 * Marquardt's diagonal where the energy is not convex. The matrix has a band whose width does
 * not depend on the number of nodes.
 */
#include "numeric/banded.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"

#include <float.h>
#include <string.h>

enum { GAUSS = 8, CORNERS = 6, MOST = CORNERS * 3 };

/* The three derivatives of Hermite's six quintics on [0, 1] at the nodes of Gauss. */
typedef struct {
    double weights[GAUSS], derivatives[GAUSS][3][CORNERS];
} basis;

static void fill_basis(basis *b)
{
    /* From the values 0..5 of the powers. */
    static const double quintics[CORNERS][6] = {
        {1, 0, 0, -10, 15, -6}, {0, 1, 0, -6, 8, -3}, {0, 0, 0.5, -1.5, 1.5, -0.5},
        {0, 0, 0, 10, -15, 6},  {0, 0, 0, -4, 7, -3}, {0, 0, 0, 0.5, -1, 0.5}};
    double nodes[GAUSS];
    bat_gauss(GAUSS, nodes, b->weights);
    for (int q = 0; q < GAUSS; q++) {
        const double t = (1 + nodes[q]) / 2;
        b->weights[q] /= 2;
        for (int i = 0; i < CORNERS; i++)
            for (int k = 1; k <= 3; k++) {
                double value = 0;
                for (int n = 5; n >= k; n--)
                    value = value * t +
                            quintics[i][n] * n * (k > 1 ? n - 1 : 1) * (k > 2 ? n - 2 : 1);
                b->derivatives[q][k - 1][i] = value;
            }
    }
}

/* Gradient and matrix of one span by the numbers of its two nodes. */
typedef struct {
    double gradient[MOST], hessian[MOST * MOST];
} local_change;

/* What is minimised, and what Newton needs of it. */
typedef struct {
    const bat_energy_task *task;
    bat_energy_curve *curve;
    basis basis;
    double first;                /* what is minimised, at the start */
    double energy, length, size; /* at x; `size`: of the terms of the energy */
    double *gradient;            /* [unknown_count] */
    double *length_gradient;     /* the same of the length, when scale invariant */
    double *matrix, *factor;     /* [unknown_count][band + 1] */
    double *right;               /* [unknown_count][3] */
    double *step;                /* [unknown_count] */
    double *kept;                /* x before the step */
    local_change *span;          /* [1] */
} energy_search;

static void search_end(energy_search *s)
{
    double *const arrays[] = {
        s->gradient, s->length_gradient, s->matrix, s->factor, s->right, s->step, s->kept};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        bat_release(arrays[i]);
    bat_release(s->span);
}

static batten_status search_begin(const bat_energy_task *task, bat_energy_curve *curve,
                                  energy_search *s)
{
    const size_t n = (size_t)curve->unknown_count, w = (size_t)curve->band + 1;
    s->task = task;
    s->curve = curve;
    fill_basis(&s->basis);
    s->gradient = bat_array(n, sizeof *s->gradient);
    s->length_gradient = bat_array(n, sizeof *s->length_gradient);
    s->matrix = bat_array3(n, w, sizeof *s->matrix);
    s->factor = bat_array3(n, w, sizeof *s->factor);
    s->right = bat_array3(n, 3, sizeof *s->right);
    s->step = bat_array(n, sizeof *s->step);
    s->span = bat_array(1, sizeof *s->span);
    s->kept = bat_array3((size_t)curve->count, 3 * (size_t)curve->d, sizeof *s->kept);
    return s->gradient && s->length_gradient && s->matrix && s->factor && s->right && s->step &&
                   s->kept && s->span
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* ---- one span ---- */

/* Its two nodes' numbers [6][d], the second and third row of each by the step of the span. */
static void corners_of(const bat_energy_curve *curve, int j, double *out)
{
    const int d = curve->d, next = (j + 1) % curve->count;
    const double h = curve->step[j], scale[3] = {1, h, h * h};
    for (int i = 0; i < CORNERS; i++)
        for (int c = 0; c < d; c++)
            out[i * d + c] = curve->x[((i < 3 ? j : next) * 3 + i % 3) * d + c] * scale[i % 3];
}

void bat_energy_bezier(const bat_energy_curve *curve, int j, double *points)
{
    const int d = curve->d;
    double v[MOST];
    corners_of(curve, j, v);
    for (int c = 0; c < d; c++) {
        const double p = v[c], dp = v[d + c] / 5, a = v[2 * d + c] / 20;
        const double q = v[3 * d + c], dq = v[4 * d + c] / 5, b = v[5 * d + c] / 20;
        points[c] = p;
        points[d + c] = p + dp;
        points[2 * d + c] = p + 2 * dp + a;
        points[3 * d + c] = q - 2 * dq + b;
        points[4 * d + c] = q - dq;
        points[5 * d + c] = q;
    }
}

/* The three derivatives at a node of Gauss by the parameter of length h. */
static void derivatives_at(const energy_search *s, int q, const double *corners, double h,
                           double *P)
{
    const int d = s->curve->d;
    double scale = 1;
    for (int k = 0; k < 3; k++) {
        scale /= h;
        for (int c = 0; c < d; c++) {
            double sum = 0;
            for (int i = 0; i < CORNERS; i++)
                sum += s->basis.derivatives[q][k][i] * corners[i * d + c];
            P[k * d + c] = sum * scale;
        }
    }
}

/* How the derivatives follow the numbers of the nodes: row k of the basis, scaled. */
static void scaled_basis(const energy_search *s, int q, double h, double out[3][CORNERS])
{
    const double scale[3] = {1, h, h * h};
    double by = 1;
    for (int k = 0; k < 3; k++) {
        by /= h;
        for (int i = 0; i < CORNERS; i++)
            out[k][i] = s->basis.derivatives[q][k][i] * by * scale[i % 3];
    }
}

/* One pair of coordinates, c >= e: Bt H B of the three derivatives. */
static void add_block(int d, int c, int e, double weight, double B[3][CORNERS],
                      const double *hessian, local_change *sum)
{
    const int n = 3 * d, m = CORNERS * d;
    double half[3][CORNERS];
    for (int k = 0; k < 3; k++) {
        const double *h = hessian + (k * d + c) * n + e;
        for (int j = 0; j < CORNERS; j++)
            half[k][j] = weight * (h[0] * B[0][j] + h[d] * B[1][j] + h[2 * d] * B[2][j]);
    }
    for (int i = 0; i < CORNERS; i++) {
        double *row = sum->hessian + (i * d + c) * m + e;
        for (int j = 0; j < CORNERS; j++)
            row[j * d] += B[0][i] * half[0][j] + B[1][i] * half[1][j] + B[2][i] * half[2][j];
    }
}

/* The hessian only where the coordinate of the row is not below that of the column. */
static void add_density(int d, double weight, double B[3][CORNERS],
                        const bat_energy_density *density, local_change *sum)
{
    for (int c = 0; c < d; c++) {
        const double *g = density->gradient + c;
        for (int e = 0; e <= c; e++)
            add_block(d, c, e, weight, B, density->hessian, sum);
        for (int i = 0; i < CORNERS; i++)
            sum->gradient[i * d + c] +=
                weight * (B[0][i] * g[0] + B[1][i] * g[d] + B[2][i] * g[2 * d]);
    }
}

/* The rest of the hessian, which is symmetric. */
static void mirror(int d, local_change *sum)
{
    const int m = CORNERS * d;
    for (int row = 0; row < m; row++)
        for (int col = 0; col < m; col++)
            if (row % d < col % d)
                sum->hessian[row * m + col] = sum->hessian[col * m + row];
}

/* ---- the axes of the nodes ---- */

/* Square axes, by columns: the first along the tangent. */
static void square_axes(int d, const double *tangent, double *frame)
{
    double axes[3][3] = {{0}};
    const double norm = bat_norm(d, tangent);
    int least = 0;
    for (int c = 0; c < d; c++) {
        axes[0][c] = tangent[c] / norm;
        if (fabs(axes[0][c]) < fabs(axes[0][least]))
            least = c;
    }
    for (int c = 0; c < d; c++)
        axes[1][c] = (c == least) - axes[0][least] * axes[0][c];
    const double length = bat_norm(d, axes[1]);
    for (int c = 0; c < d; c++)
        axes[1][c] /= length;
    for (int c = 0; c < 3 && d == 3; c++)
        axes[2][c] = axes[0][(c + 1) % 3] * axes[1][(c + 2) % 3] -
                     axes[0][(c + 2) % 3] * axes[1][(c + 1) % 3];
    for (int k = 0; k < d; k++)
        for (int c = 0; c < d; c++)
            frame[c * d + k] = axes[k][c];
}

static void find_axes(bat_energy_curve *curve)
{
    const int d = curve->d;
    for (int i = 0; i < curve->count; i++)
        square_axes(d, curve->x + (i * 3 + 1) * d, curve->frame + i * d * d);
}

static const double *frame_of(const bat_energy_curve *curve, int node)
{
    return curve->frame + node * curve->d * curve->d;
}

/* Turn d numbers, `stride` apart, into the axes. */
static void into_frame(int d, const double *frame, int stride, double *v)
{
    double turned[3] = {0};
    for (int k = 0; k < d; k++)
        for (int c = 0; c < d; c++)
            turned[k] += frame[c * d + k] * v[c * stride];
    for (int k = 0; k < d; k++)
        v[k * stride] = turned[k];
}

static void turn_local(const bat_energy_curve *curve, int j, local_change *l)
{
    const int d = curve->d, m = CORNERS * d;
    for (int i = 0; i < CORNERS; i++) {
        const double *frame = frame_of(curve, i < 3 ? j : (j + 1) % curve->count);
        into_frame(d, frame, 1, l->gradient + i * d);
        for (int r = 0; r < m; r++)
            into_frame(d, frame, 1, l->hessian + r * m + i * d);
        for (int r = 0; r < m; r++)
            into_frame(d, frame, m, l->hessian + i * d * m + r);
    }
}

/* ---- the sum over all spans ---- */

static void scatter(energy_search *s, int j, const local_change *l, double *gradient,
                    double *matrix)
{
    const bat_energy_curve *curve = s->curve;
    const int d = curve->d, m = CORNERS * d, w = curve->band + 1;
    int unknown[MOST];
    for (int i = 0; i < m; i++) {
        const int node = i < 3 * d ? j : (j + 1) % curve->count;
        unknown[i] = curve->unknown[node * 3 * d + i % (3 * d)];
    }
    for (int a = 0; a < m; a++) {
        if (unknown[a] < 0)
            continue;
        gradient[unknown[a]] += l->gradient[a];
        for (int b = 0; b < m && matrix; b++)
            if (unknown[b] >= 0 && unknown[b] <= unknown[a])
                matrix[(size_t)unknown[a] * (size_t)w +
                       (size_t)(unknown[b] - unknown[a] + curve->band)] +=
                    l->hessian[a * m + b];
    }
}

/* Energy and length at x. */
static void measure_energy(energy_search *s, double *energy, double *length, double *size)
{
    const bat_energy_weights weights = {s->task->kind, 1, 0};
    const int d = s->curve->d;
    *energy = *length = *size = 0;
    for (int j = 0; j < s->curve->spans; j++) {
        double corners[MOST], P[9];
        const double h = s->curve->step[j];
        corners_of(s->curve, j, corners);
        for (int q = 0; q < GAUSS; q++) {
            bat_energy_density at;
            derivatives_at(s, q, corners, h, P);
            bat_energy_density_at(&weights, d, P, false, &at);
            *energy += s->basis.weights[q] * h * at.energy;
            *size += s->basis.weights[q] * h * at.size;
            *length += s->basis.weights[q] * h * at.length;
        }
    }
}

/* Gradient and matrix of a weighted sum; `matrix` may be NULL. */
static void assemble(energy_search *s, const bat_energy_weights *weights, double *gradient,
                     double *matrix)
{
    const int d = s->curve->d;
    const size_t n = (size_t)s->curve->unknown_count;
    memset(gradient, 0, n * sizeof *gradient);
    if (matrix)
        memset(matrix, 0, n * (size_t)(s->curve->band + 1) * sizeof *matrix);
    for (int j = 0; j < s->curve->spans; j++) {
        double corners[MOST], P[9], B[3][CORNERS];
        const double h = s->curve->step[j];
        memset(s->span, 0, sizeof *s->span);
        corners_of(s->curve, j, corners);
        for (int q = 0; q < GAUSS; q++) {
            bat_energy_density at;
            derivatives_at(s, q, corners, h, P);
            bat_energy_density_at(weights, d, P, true, &at);
            scaled_basis(s, q, h, B);
            add_density(d, s->basis.weights[q] * h, B, &at, s->span);
        }
        mirror(d, s->span);
        turn_local(s->curve, j, s->span);
        scatter(s, j, s->span, gradient, matrix);
    }
}

/* What is minimised: E + tension L, or E L^p. */
static double power(const energy_search *s)
{
    return s->task->kind == BATTEN_ENERGY_BENDING ? 1 : 3;
}

static double factor_of_length(const energy_search *s, double length)
{
    return power(s) == 1 ? length : length * length * length;
}

static double objective(const energy_search *s, double energy, double length)
{
    return s->task->scale_invariant ? energy * factor_of_length(s, length)
                                    : energy + s->task->tension * length;
}

static void differentiate(energy_search *s)
{
    bat_energy_weights weights = {s->task->kind, 1, s->task->tension};
    find_axes(s->curve);
    if (s->task->scale_invariant) {
        const bat_energy_weights length = {s->task->kind, 0, 1};
        const double f = factor_of_length(s, s->length);
        assemble(s, &length, s->length_gradient, NULL);
        weights = (bat_energy_weights){s->task->kind, f, power(s) * s->energy * f / s->length};
    }
    assemble(s, &weights, s->gradient, s->matrix);
}

/* ---- steps ---- */

static batten_status factor(energy_search *s, double damping)
{
    const size_t n = (size_t)s->curve->unknown_count, w = (size_t)s->curve->band + 1;
    memcpy(s->factor, s->matrix, n * w * sizeof *s->factor);
    double largest = 0;
    for (size_t i = 0; i < n; i++)
        largest = bat_max(largest, fabs(s->matrix[i * w + w - 1]));
    /* Unknowns whose own row is next to nothing are held too. */
    for (size_t i = 0; i < n; i++)
        s->factor[i * w + w - 1] +=
            damping * bat_max(fabs(s->matrix[i * w + w - 1]), 1e-12 * largest);
    return bat_symmetric_factor((int)n, (int)w - 1, s->factor);
}

/*
 * The product E L^p adds to the matrix what length and energy do together: with a = E' and b =
 * L' it is M11 = 0, M12 = p L^(p-1), M22 = -p (p + 1) E L^(p-2) in terms of the gradient g =
 * L^p a + p E L^(p-1) b and b. Woodbury puts it into the solution. False when the result does
 * not point downhill.
 */
static bool correct(energy_search *s)
{
    const int n = s->curve->unknown_count;
    const double p = power(s), L = s->length, m12 = p / L;
    const double m22 = -p * (p + 1) * s->energy * factor_of_length(s, L) / L / L;
    double gg = 0, gb = 0, bb = 0;
    for (int i = 0; i < n; i++) {
        gg += s->gradient[i] * s->right[2 * i];
        gb += s->gradient[i] * s->right[2 * i + 1];
        bb += s->length_gradient[i] * s->right[2 * i + 1];
    }
    /* The inverse of M plus the products, for the right side of the products with g. */
    const double a11 = -m22 / (m12 * m12) + gg, a12 = 1 / m12 + gb, a22 = bb;
    const double det = a11 * a22 - a12 * a12;
    const double u = (gg * a22 - gb * a12) / det, v = (a11 * gb - a12 * gg) / det;
    double downhill = 0;
    for (int i = 0; i < n; i++) {
        s->step[i] = -(s->right[2 * i] * (1 - u) - v * s->right[2 * i + 1]);
        downhill -= s->step[i] * s->gradient[i];
    }
    return isfinite(det) && downhill > 0 && downhill < 1e3 * gg;
}

static void solve(energy_search *s)
{
    const int n = s->curve->unknown_count, band = s->curve->band;
    if (s->task->scale_invariant) {
        for (int i = 0; i < n; i++) {
            s->right[2 * i] = s->gradient[i];
            s->right[2 * i + 1] = s->length_gradient[i];
        }
        bat_symmetric_solve(n, band, s->factor, 2, s->right);
        if (correct(s))
            return;
    }
    for (int i = 0; i < n; i++)
        s->step[i] = -s->gradient[i];
    bat_symmetric_solve(n, band, s->factor, 1, s->step);
}

static void minimize_energy(energy_search *s)
{
    const bat_energy_curve *curve = s->curve;
    const int d = curve->d;
    for (int row = 0; row < curve->count * 3; row++) {
        const double *frame = frame_of(curve, row / 3);
        double change[3] = {0};
        for (int k = 0; k < d; k++) {
            const int u = curve->unknown[row * d + k];
            const double by = u >= 0 ? s->step[u] : 0;
            for (int c = 0; c < d; c++)
                change[c] += frame[c * d + k] * by;
        }
        for (int c = 0; c < d; c++)
            curve->x[row * d + c] += change[c];
    }
}

/* The energy at x + step if it is less: then x moves there. */
static bool try_step(energy_search *s)
{
    const size_t count = (size_t)s->curve->count * 3 * (size_t)s->curve->d;
    double energy, length, size;
    memcpy(s->kept, s->curve->x, count * sizeof *s->kept);
    minimize_energy(s);
    measure_energy(s, &energy, &length, &size);
    if (objective(s, energy, length) < objective(s, s->energy, s->length)) {
        s->energy = energy;
        s->length = length;
        s->size = size;
        return true;
    }
    memcpy(s->curve->x, s->kept, count * sizeof *s->kept);
    return false;
}

/* How much the energy falls in the step, by its first derivative. */
static double promise(const energy_search *s)
{
    return -bat_dot(s->curve->unknown_count, s->gradient, s->step) / 2;
}

/* Rounding alone bends a line by 1e-15 or so for each unit of length, which is the mean chord.
 */
#define STRAIGHT 1e-28

/* What rounding leaves of the energy: the densities are sums that cancel. */
static double rounding(const energy_search *s)
{
    return 64 * DBL_EPSILON * objective(s, s->size, s->length);
}

/* One step down from x. LEAST when it promises no more than 1e-12 of the first energy. */
static batten_status descend(energy_search *s, double *damping, double *remaining,
                             bat_energy_end *end)
{
    differentiate(s);
    for (int tries = 0; tries < 60; tries++) {
        const batten_status status = factor(s, *damping);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        if (status == BATTEN_OK) {
            solve(s);
            *remaining = promise(s);
            const double small = 1e-12 * s->first + rounding(s) + STRAIGHT * s->curve->spans;
            const bool done = *remaining <= small && *damping < 1e-2;
            *end = done ? BAT_ENERGY_LEAST : BAT_ENERGY_UNDERWAY;
            if (try_step(s)) {
                *damping = *damping < 1e-9 ? 0 : *damping / 10;
                return BATTEN_OK;
            }
            if (done || *remaining <= rounding(s)) {
                *end = BAT_ENERGY_LEAST;
                return BATTEN_OK;
            }
        }
        *damping = bat_max(1e-8, 10 * *damping);
    }
    *end = BAT_ENERGY_STUCK;
    return BATTEN_OK;
}

static batten_status minimise(energy_search *s, batten_curve_minimum_energy_report *report,
                              bat_energy_end *end)
{
    measure_energy(s, &s->energy, &s->length, &s->size);
    double damping = 1e-4;
    *end = s->curve->unknown_count == 0 ? BAT_ENERGY_LEAST : BAT_ENERGY_UNDERWAY;
    report->before = s->first = objective(s, s->energy, s->length);
    for (report->steps = 0; report->steps < s->task->max_steps && *end == BAT_ENERGY_UNDERWAY;
         report->steps++) {
        const batten_status status = descend(s, &damping, &report->remaining, end);
        if (status != BATTEN_OK)
            return status;
        if (s->length > s->task->longest)
            return bat_fail(BATTEN_INCOMPLETE,
                            "the curve grows without end: it is %.3g times as long as a mean "
                            "chord; give directions at the ends or a tension",
                            s->length);
    }
    report->after = objective(s, s->energy, s->length);
    report->length = s->length;
    return BATTEN_OK;
}

batten_status bat_energy_minimise(const bat_energy_task *task, bat_energy_curve *curve,
                                  batten_curve_minimum_energy_report *report,
                                  bat_energy_end *end)
{
    energy_search s = {.task = NULL};
    batten_status status = search_begin(task, curve, &s);
    if (status == BATTEN_OK)
        status = minimise(&s, report, end);
    search_end(&s);
    return status;
}
