/*
 * The parameter of a curve of least energy. The energy does not depend on it, but quintics come
 * nearest to a curve when it is the arc length: then P' has length 1 and P'' is the curvature
 * vector.
 */
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "shape/bent/energy.h"
#include "spline/spline.h"

enum { GAUSS = 8, DEGREE = 5 };

typedef struct {
    double weights[GAUSS], basis[GAUSS][DEGREE]; /* of the first derivative */
} rule;

static void fill_rule(rule *r)
{
    double nodes[GAUSS];
    bat_gauss(GAUSS, nodes, r->weights);
    for (int q = 0; q < GAUSS; q++)
        bat_bernstein(DEGREE - 1, (1 + nodes[q]) / 2, (1 - nodes[q]) / 2, r->basis[q]);
}

static double span_length(const bat_energy_curve *curve, const rule *r, int j)
{
    const int d = curve->d;
    double points[(DEGREE + 1) * 3], sum = 0;
    bat_energy_bezier(curve, j, points);
    bat_piece_derive(DEGREE, 1, (size_t)d, points);
    for (int q = 0; q < GAUSS; q++) {
        double speed[3];
        bat_combine(DEGREE - 1, r->basis[q], (size_t)d, points, speed);
        sum += r->weights[q] / 2 * bat_norm(d, speed);
    }
    return sum;
}

double bat_energy_length(const bat_energy_curve *curve)
{
    rule r;
    double sum = 0;
    fill_rule(&r);
    for (int j = 0; j < curve->spans; j++)
        sum += span_length(curve, &r, j);
    return sum;
}

bool bat_energy_by_length(bat_energy_curve *curve)
{
    const int d = curve->d;
    rule r;
    fill_rule(&r);
    for (int i = 0; i < curve->count; i++)
        if (!(bat_norm(d, curve->x + (i * 3 + 1) * d) > 1e-6))
            return false;
    for (int j = 0; j < curve->spans; j++)
        curve->step[j] = span_length(curve, &r, j);
    for (int i = 0; i < curve->count; i++) {
        double *first = curve->x + (i * 3 + 1) * d, *second = first + d;
        const double speed = bat_norm(d, first);
        for (int c = 0; c < d; c++)
            first[c] /= speed;
        const double along = bat_dot(d, first, second);
        for (int c = 0; c < d; c++)
            second[c] = (second[c] - along * first[c]) / speed / speed;
    }
    return true;
}
