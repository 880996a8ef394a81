/* Rows of Bezier patches: points, derivatives, and heights above a plane. */
#include "hydrostatics/patch.h"
#include "numeric/bernstein.h"

#include <string.h>

/* The Bernstein polynomials of a degree at t, and their derivatives. */
static void bernstein(int degree, double t, double *values, double *slopes)
{
    values[0] = 1;
    memset(slopes, 0, (size_t)(degree + 1) * sizeof *slopes);
    for (int k = 1; k <= degree; k++) {
        if (k == degree)
            for (int i = 0; i <= k; i++)
                slopes[i] = k * ((i > 0 ? values[i - 1] : 0) - (i < k ? values[i] : 0));
        values[k] = t * values[k - 1];
        for (int i = k - 1; i > 0; i--)
            values[i] = t * values[i - 1] + (1 - t) * values[i];
        values[0] *= 1 - t;
    }
}

void bat_patch_row(const bat_patch *patch, batten_direction constant, double t, bat_row *row)
{
    const int across = patch->degree[constant], along = patch->degree[!constant];
    const int columns = patch->degree[1] + 1;
    double values[BATTEN_MAX_DEGREE + 1], slopes[BATTEN_MAX_DEGREE + 1];
    bernstein(across, t, values, slopes);
    row->degree = along;
    memset(row->at, 0, (size_t)(along + 1) * sizeof *row->at);
    memset(row->change, 0, (size_t)(along + 1) * sizeof *row->change);
    for (int i = 0; i <= across; i++)
        for (int j = 0; j <= along; j++) {
            const int place = constant == BATTEN_U ? i * columns + j : j * columns + i;
            for (int c = 0; c < 4; c++) {
                row->at[j][c] += values[i] * patch->points[4 * place + c];
                row->change[j][c] += slopes[i] * patch->points[4 * place + c];
            }
        }
}

void bat_row_at(const bat_row *row, double t, bat_row_point *out)
{
    double values[BATTEN_MAX_DEGREE + 1], slopes[BATTEN_MAX_DEGREE + 1];
    double at[4] = {0}, by[2][4] = {{0}};
    bernstein(row->degree, t, values, slopes);
    for (int j = 0; j <= row->degree; j++)
        for (int c = 0; c < 4; c++) {
            at[c] += values[j] * row->at[j][c];
            by[0][c] += values[j] * row->change[j][c];
            by[1][c] += slopes[j] * row->at[j][c];
        }
    for (int c = 0; c < 3; c++) {
        out->at[c] = at[c] / at[3];
        for (int k = 0; k < 2; k++)
            out->derivative[k][c] = (by[k][c] - by[k][3] * out->at[c]) / at[3];
    }
}

void bat_row_heights(const bat_row *row, const double n[3], double d,
                     double heights[BATTEN_MAX_DEGREE + 1])
{
    for (int j = 0; j <= row->degree; j++) {
        const double *p = row->at[j];
        heights[j] = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - d * p[3];
    }
}

batten_status bat_row_roots(int degree, const double *heights, double roots[BATTEN_MAX_DEGREE],
                            int *count)
{
    bat_root found[BATTEN_MAX_DEGREE];
    int many = 0;
    *count = 0;
    const batten_status status = bat_bernstein_roots(degree, heights, 0, found, &many);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    for (int i = 0; i < many && status == BATTEN_OK; i++)
        roots[(*count)++] = found[i].t;
    return BATTEN_OK;
}
