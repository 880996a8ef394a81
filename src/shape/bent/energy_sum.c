/* The energy of a curve of quintic spans and its derivatives, summed over all spans. */
#include "shape/bent/energy_sum.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"

#include <string.h>

void bat_energy_fill_basis(bat_energy_basis *b)
{
    /* From the values 0..5 of the powers. */
    static const double quintics[BAT_ENERGY_CORNERS][6] = {
        {1, 0, 0, -10, 15, -6}, {0, 1, 0, -6, 8, -3}, {0, 0, 0.5, -1.5, 1.5, -0.5},
        {0, 0, 0, 10, -15, 6},  {0, 0, 0, -4, 7, -3}, {0, 0, 0, 0.5, -1, 0.5}};
    double nodes[BAT_ENERGY_GAUSS];
    bat_gauss(BAT_ENERGY_GAUSS, nodes, b->weights);
    for (int q = 0; q < BAT_ENERGY_GAUSS; q++) {
        const double t = (1 + nodes[q]) / 2;
        b->weights[q] /= 2;
        for (int i = 0; i < BAT_ENERGY_CORNERS; i++)
            for (int k = 1; k <= 3; k++) {
                double value = 0;
                for (int n = 5; n >= k; n--)
                    value = value * t +
                            quintics[i][n] * n * (k > 1 ? n - 1 : 1) * (k > 2 ? n - 2 : 1);
                b->derivatives[q][k - 1][i] = value;
            }
    }
}

/* ---- one span ---- */

/* Its two nodes' numbers [6][d], the second and third row of each by the step of the span. */
static void corners_of(const bat_energy_curve *curve, int j, double *out)
{
    const int d = curve->d, next = (j + 1) % curve->count;
    const double h = curve->step[j], scale[3] = {1, h, h * h};
    for (int i = 0; i < BAT_ENERGY_CORNERS; i++)
        for (int c = 0; c < d; c++)
            out[i * d + c] = curve->x[((i < 3 ? j : next) * 3 + i % 3) * d + c] * scale[i % 3];
}

void bat_energy_bezier(const bat_energy_curve *curve, int j, double *points)
{
    const int d = curve->d;
    double v[BAT_ENERGY_MOST];
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
static void derivatives_at(const bat_energy_search *s, int q, const double *corners, double h,
                           double *P)
{
    const int d = s->curve->d;
    double scale = 1;
    for (int k = 0; k < 3; k++) {
        scale /= h;
        for (int c = 0; c < d; c++) {
            double sum = 0;
            for (int i = 0; i < BAT_ENERGY_CORNERS; i++)
                sum += s->basis.derivatives[q][k][i] * corners[i * d + c];
            P[k * d + c] = sum * scale;
        }
    }
}

/* How the derivatives follow the numbers of the nodes: row k of the basis, scaled. */
static void scaled_basis(const bat_energy_search *s, int q, double h,
                         double out[3][BAT_ENERGY_CORNERS])
{
    const double scale[3] = {1, h, h * h};
    double by = 1;
    for (int k = 0; k < 3; k++) {
        by /= h;
        for (int i = 0; i < BAT_ENERGY_CORNERS; i++)
            out[k][i] = s->basis.derivatives[q][k][i] * by * scale[i % 3];
    }
}

/* One pair of coordinates, c >= e: Bt H B of the three derivatives. */
static void add_block(int d, int c, int e, double weight, double B[3][BAT_ENERGY_CORNERS],
                      const double *hessian, bat_energy_change *sum)
{
    const int n = 3 * d, m = BAT_ENERGY_CORNERS * d;
    double half[3][BAT_ENERGY_CORNERS];
    for (int k = 0; k < 3; k++) {
        const double *h = hessian + (k * d + c) * n + e;
        for (int j = 0; j < BAT_ENERGY_CORNERS; j++)
            half[k][j] = weight * (h[0] * B[0][j] + h[d] * B[1][j] + h[2 * d] * B[2][j]);
    }
    for (int i = 0; i < BAT_ENERGY_CORNERS; i++) {
        double *row = sum->hessian + (i * d + c) * m + e;
        for (int j = 0; j < BAT_ENERGY_CORNERS; j++)
            row[j * d] += B[0][i] * half[0][j] + B[1][i] * half[1][j] + B[2][i] * half[2][j];
    }
}

/* The hessian only where the coordinate of the row is not below that of the column. */
static void add_density(int d, double weight, double B[3][BAT_ENERGY_CORNERS],
                        const bat_energy_density *density, bat_energy_change *sum)
{
    for (int c = 0; c < d; c++) {
        const double *g = density->gradient + c;
        for (int e = 0; e <= c; e++)
            add_block(d, c, e, weight, B, density->hessian, sum);
        for (int i = 0; i < BAT_ENERGY_CORNERS; i++)
            sum->gradient[i * d + c] +=
                weight * (B[0][i] * g[0] + B[1][i] * g[d] + B[2][i] * g[2 * d]);
    }
}

/* The rest of the hessian, which is symmetric. */
static void mirror(int d, bat_energy_change *sum)
{
    const int m = BAT_ENERGY_CORNERS * d;
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

const double *bat_energy_frame_of(const bat_energy_curve *curve, int node)
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

static void turn_local(const bat_energy_curve *curve, int j, bat_energy_change *l)
{
    const int d = curve->d, m = BAT_ENERGY_CORNERS * d;
    for (int i = 0; i < BAT_ENERGY_CORNERS; i++) {
        const double *frame = bat_energy_frame_of(curve, i < 3 ? j : (j + 1) % curve->count);
        into_frame(d, frame, 1, l->gradient + i * d);
        for (int r = 0; r < m; r++)
            into_frame(d, frame, 1, l->hessian + r * m + i * d);
        for (int r = 0; r < m; r++)
            into_frame(d, frame, m, l->hessian + i * d * m + r);
    }
}

/* ---- the sum over all spans ---- */

static void scatter(bat_energy_search *s, int j, const bat_energy_change *l, double *gradient,
                    double *matrix)
{
    const bat_energy_curve *curve = s->curve;
    const int d = curve->d, m = BAT_ENERGY_CORNERS * d, w = curve->band + 1;
    int unknown[BAT_ENERGY_MOST];
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

void bat_energy_sum(bat_energy_search *s, double *energy, double *length, double *size)
{
    const bat_energy_weights weights = {s->task->kind, 1, 0};
    const int d = s->curve->d;
    *energy = *length = *size = 0;
    for (int j = 0; j < s->curve->spans; j++) {
        double corners[BAT_ENERGY_MOST], P[9];
        const double h = s->curve->step[j];
        corners_of(s->curve, j, corners);
        for (int q = 0; q < BAT_ENERGY_GAUSS; q++) {
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
static void assemble(bat_energy_search *s, const bat_energy_weights *weights, double *gradient,
                     double *matrix)
{
    const int d = s->curve->d;
    const size_t n = (size_t)s->curve->unknown_count;
    memset(gradient, 0, n * sizeof *gradient);
    if (matrix)
        memset(matrix, 0, n * (size_t)(s->curve->band + 1) * sizeof *matrix);
    for (int j = 0; j < s->curve->spans; j++) {
        double corners[BAT_ENERGY_MOST], P[9], B[3][BAT_ENERGY_CORNERS];
        const double h = s->curve->step[j];
        memset(s->span, 0, sizeof *s->span);
        corners_of(s->curve, j, corners);
        for (int q = 0; q < BAT_ENERGY_GAUSS; q++) {
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

double bat_energy_power(const bat_energy_search *s)
{
    return s->task->kind == BATTEN_ENERGY_BENDING ? 1 : 3;
}

double bat_energy_length_factor(const bat_energy_search *s, double length)
{
    return bat_energy_power(s) == 1 ? length : length * length * length;
}

double bat_energy_objective(const bat_energy_search *s, double energy, double length)
{
    return s->task->scale_invariant ? energy * bat_energy_length_factor(s, length)
                                    : energy + s->task->tension * length;
}

void bat_energy_differentiate(bat_energy_search *s)
{
    bat_energy_weights weights = {s->task->kind, 1, s->task->tension};
    find_axes(s->curve);
    if (s->task->scale_invariant) {
        const bat_energy_weights length = {s->task->kind, 0, 1};
        const double f = bat_energy_length_factor(s, s->length);
        assemble(s, &length, s->length_gradient, NULL);
        weights = (bat_energy_weights){s->task->kind, f,
                                       bat_energy_power(s) * s->energy * f / s->length};
    }
    assemble(s, &weights, s->gradient, s->matrix);
}
