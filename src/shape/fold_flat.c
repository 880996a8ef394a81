#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/fold_parts.h"

enum { NODES = 4 };

/* Weights of Gauss and Legendre for integrals from 0 to each node c[i]: exact for degree 3. */
static void collocation(double c[NODES], double weights[NODES], double A[NODES][NODES])
{
    double nodes[NODES], plain[NODES];
    bat_gauss(NODES, nodes, plain);
    for (int i = 0; i < NODES; i++) {
        c[i] = 0.5 + 0.5 * nodes[i];
        weights[i] = plain[i] / 2;
    }
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++) {
            A[i][j] = 0;
            for (int q = 0; q < NODES; q++) {
                double basis = 1;
                for (int m = 0; m < NODES; m++)
                    basis *= m == j ? 1 : (c[i] * c[q] - c[m]) / (c[j] - c[m]);
                A[i][j] += c[i] * weights[q] * basis;
            }
        }
}

/* From sample i to the next: direction and point of the flat crease. */
static batten_status flat_step(const bat_fold_task *t, int i, double *phi, double *x, double *y)
{
    double c[NODES], weights[NODES], A[NODES][NODES], kg[NODES], pace[NODES];
    const double u = t->at[i].u, h = t->at[i + 1].u - u;
    collocation(c, weights, A);
    for (int j = 0; j < NODES; j++) {
        bat_fold_place p;
        double values[2 * 3];
        const double s = t->at[i].s + c[j] * (t->at[i + 1].s - t->at[i].s);
        /* The length at the node is known nearly, which does for the law of angles: it varies
         * slowly. */
        batten_status status = bat_fold_find_place(t, s, u + c[j] * h, &p);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(t->space, u + c[j] * h, 1, values);
        if (status != BATTEN_OK)
            return status;
        pace[j] = bat_norm(3, values + 3) * h;
        kg[j] = p.k * cos(p.a);
    }
    for (int j = 0; j < NODES; j++) {
        double turned = *phi;
        for (int m = 0; m < NODES; m++)
            turned += A[j][m] * kg[m] * pace[m];
        *x += weights[j] * pace[j] * cos(turned);
        *y += weights[j] * pace[j] * sin(turned);
    }
    for (int j = 0; j < NODES; j++)
        *phi += weights[j] * kg[j] * pace[j];
    return BATTEN_OK;
}

static void flat_ruling(double phi, double b, double sign, double *out)
{
    out[0] = sign * cos(phi + b);
    out[1] = sign * sin(phi + b);
}

batten_status bat_fold_flatten(bat_fold_task *t)
{
    double phi = 0, x = 0, y = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        t->made.flat[2 * i] = x;
        t->made.flat[2 * i + 1] = y;
        flat_ruling(phi, t->b[0][i], 1, t->made.left.flat_rulings + 2 * i);
        flat_ruling(phi, t->b[1][i], -1, t->made.right.flat_rulings + 2 * i);
        if (i + 1 < t->count)
            status = flat_step(t, i, &phi, &x, &y);
    }
    t->made.flat_turn = phi;
    return status;
}
