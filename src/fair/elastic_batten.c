/* The elastic batten: its matrix, the forces at its ducks, and what a duck does when released. */
#include "fair/elastic_batten.h"
#include "numeric/banded.h"

#include <float.h>
#include <string.h>

/* ---- stiffness ---- */

/* Row i of Q: the part of ordinate i in the second differences at the ducks i - 1, i, i + 1. */
static void second_differences(const bat_batten *batten, int i, double q[3])
{
    const int n = batten->count;
    const double left = i > 0 ? 1 / (batten->t[i] - batten->t[i - 1]) : 0;
    const double right = i < n - 1 ? 1 / (batten->t[i + 1] - batten->t[i]) : 0;
    q[0] = i >= 2 ? left : 0;
    q[1] = i >= 1 && i <= n - 2 ? -left - right : 0;
    q[2] = i <= n - 3 ? right : 0;
}

/* Row j of the band of B = R^-1 from row j + 1; row j is kept at j % 3. */
static void inverse_row(const bat_batten *batten, int j, double band[3][3])
{
    const int rows = batten->count - 2;
    const double *below = band[(j + 1) % 3];
    double *row = band[j % 3];
    const double l = j + 1 < rows ? batten->factor[2 * (j + 1)] : 0;
    row[1] = -l * below[0];
    row[2] = j + 2 < rows ? -l * below[1] : 0;
    row[0] = 1 / batten->factor[2 * j + 1] - l * row[1];
}

static double stiffness_of(const bat_batten *batten, int i, double band[3][3])
{
    double q[3], sum = 0;
    second_differences(batten, i, q);
    for (int a = 0; a < 3; a++)
        for (int b = a; b < 3; b++)
            if (q[a] != 0 && q[b] != 0) /* the moment at duck i - 1 + a is unknown i - 2 + a */
                sum += (a == b ? 1 : 2) * q[a] * q[b] * band[(i - 2 + a) % 3][b - a];
    return sum;
}

/*
 * K_ii = q^T B q, where q is row i of Q, at most three numbers, and B = R^-1, of which
 * therefore only the band is wanted. It follows from the factors, last row first: B_jj = 1 /
 * D_j - l_j B_j,j+1 and B_jk = -l_j B_j+1,k for k > j, l_j what row j + 1 takes of row j.
 * Source: [HdH85].
 */
static void stiffness_diagonal(bat_batten *batten)
{
    double band[3][3] = {{0}};
    for (int i = batten->count - 1; i >= 0; i--) {
        if (i >= 2)
            inverse_row(batten, i - 2, band);
        batten->diagonal[i] = stiffness_of(batten, i, band);
    }
}

batten_status bat_batten_begin(int count, const double *t, bat_batten *out)
{
    const int rows = count - 2;
    double *factor = bat_array((size_t)rows, 2 * sizeof *factor);
    double *diagonal = bat_array((size_t)count, sizeof *diagonal);
    batten_status status = factor && diagonal ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < rows; i++) {
        factor[2 * i] = (t[i + 1] - t[i]) / 6;
        factor[2 * i + 1] = (t[i + 2] - t[i]) / 3;
    }
    if (status == BATTEN_OK)
        status = bat_symmetric_factor(rows, 1, factor);
    if (status != BATTEN_OK) {
        bat_release(factor);
        bat_release(diagonal);
        return status;
    }
    *out = (bat_batten){count, t, factor, diagonal};
    stiffness_diagonal(out);
    return BATTEN_OK;
}

void bat_batten_end(bat_batten *batten)
{
    bat_release(batten->factor);
    bat_release(batten->diagonal);
    *batten = (bat_batten){0};
}

/* ---- bending ---- */

/* The change of slope of the chords at duck i. */
static double second_difference(const double *t, int width, const double *z, int i)
{
    return (z[width] - z[0]) / (t[i + 1] - t[i]) - (z[0] - z[-width]) / (t[i] - t[i - 1]);
}

/* The jump of the third derivative at duck i; one-sided at the ends. */
static double jump(const bat_batten *batten, int width, const double *moment, int i)
{
    const double *t = batten->t;
    const double right =
        i < batten->count - 1 ? (moment[width] - moment[0]) / (t[i + 1] - t[i]) : 0;
    const double left = i > 0 ? (moment[0] - moment[-width]) / (t[i] - t[i - 1]) : 0;
    return right - left;
}

/* The integral of the square of the second derivative, which is linear from duck to duck. */
static double energy(const bat_batten *batten, int width, const double *moments)
{
    double sum = 0;
    for (int i = 0; i + 1 < batten->count; i++)
        for (int k = 0; k < width; k++) {
            const double a = moments[i * width + k], b = moments[(i + 1) * width + k];
            sum += (batten->t[i + 1] - batten->t[i]) * (a * a + a * b + b * b) / 3;
        }
    return sum;
}

double bat_batten_bend(const bat_batten *batten, int width, const double *z, double *moments,
                       double *forces)
{
    const int n = batten->count;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < width; k++)
            moments[i * width + k] =
                i == 0 || i == n - 1
                    ? 0
                    : second_difference(batten->t, width, z + i * width + k, i);
    bat_symmetric_solve(n - 2, 1, batten->factor, (size_t)width, moments + width);
    for (int i = 0; forces && i < n; i++)
        for (int k = 0; k < width; k++)
            forces[i * width + k] = jump(batten, width, moments + i * width + k, i);
    return energy(batten, width, moments);
}

/* s'(t_i+) = d_i - h_i (2 M_i + M_i+1) / 6, and mirrored at the last duck. */
static double slope_at(const bat_batten *batten, int width, const double *z,
                       const double *moments, int i)
{
    const bool last = i == batten->count - 1;
    const int from = last ? -width : 0, to = from + width;
    const double h = last ? batten->t[i] - batten->t[i - 1] : batten->t[i + 1] - batten->t[i];
    const double d = (z[to] - z[from]) / h, near = moments[0], far = moments[last ? from : to];
    return last ? d + h * (far + 2 * near) / 6 : d - h * (2 * near + far) / 6;
}

batten_status bat_batten_curve(const bat_batten *batten, int width, const double *z,
                               batten_curve **out)
{
    const int n = batten->count;
    double *moments = bat_array3((size_t)n, (size_t)width, sizeof *moments);
    double *values = bat_array3((size_t)n, 2 * (size_t)width, sizeof *values);
    batten_status status = moments && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        bat_batten_bend(batten, width, z, moments, NULL);
        for (int i = 0; i < n; i++)
            for (int k = 0; k < width; k++) {
                const int at = i * width + k;
                values[2 * i * width + k] = z[at];
                values[(2 * i + 1) * width + k] =
                    slope_at(batten, width, z + at, moments + at, i);
            }
        status = batten_curve_from_hermite(width, n, 2, batten->t, values, out);
    }
    bat_release(values);
    bat_release(moments);
    return status;
}

/* ---- ducks ---- */

void bat_clip(int width, const double *centre, double within, double *z)
{
    /* A distance rounds at most seven times: differences, squares, their sum, the root. */
    const double safe = within * (1 - 8 * DBL_EPSILON), far = bat_distance(width, centre, z);
    if (far <= safe)
        return;
    for (int k = 0; k < width; k++)
        z[k] = centre[k] + (z[k] - centre[k]) * (safe / far);
    /* The sum above may have rounded outwards by half a place. */
    for (int tries = 0; tries < 4 && bat_distance(width, centre, z) > safe; tries++)
        for (int k = 0; k < width; k++)
            z[k] = nextafter(z[k], centre[k]);
    if (bat_distance(width, centre, z) > safe)
        memcpy(z, centre, (size_t)width * sizeof *z);
}

/* Energy along the free rows is K_ii + pull times the squared distance from its least place,
 * the same in each direction: so the nearest place of the ball is the best one. */
void bat_duck_release(const bat_batten *batten, const bat_ducks *ducks, int i, const double *z,
                      const double *force, double relaxation, double *to)
{
    const int width = ducks->width;
    const double *centre = ducks->centre + (size_t)i * (size_t)width;
    const double pull = ducks->pull ? ducks->pull[i] : 0;
    memcpy(to, z, (size_t)width * sizeof *to);
    for (int row = 0; row < ducks->freedom[i]; row++) {
        const double *axis =
            ducks->frames + ((size_t)i * (size_t)width + (size_t)row) * (size_t)width;
        double along = 0;
        for (int k = 0; k < width; k++)
            along += axis[k] *
                     (force[k] + (pull > 0 ? pull * (z[k] - ducks->anchor[i * width + k]) : 0));
        for (int k = 0; k < width; k++)
            to[k] -= relaxation * along / (batten->diagonal[i] + pull) * axis[k];
    }
    if (ducks->freedom[i] > 0)
        bat_clip(width, centre, ducks->within[i], to);
}
