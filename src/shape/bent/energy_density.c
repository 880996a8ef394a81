/*
 * The densities of energies as sums of monomials in the products of the derivatives P', P'' and
 * P''', and their first and second derivatives.
 *
 * With v2 = P'.P', b = P''.P'', c = P'.P'', e = P'''.P''', g = P''.P''', h = P'.P''' bending is
 * (b - c^2 / v2) / v^3. The curvature vector changes across the tangent by the part W of P''' -
 * 3 (c / v2) P'' that is square to P', divided by v^3: variation is W.W / v^5.
 */
#include "numeric/vector.h"
#include "shape/bent/energy.h"

#include <string.h>

enum { PRODUCTS = 6 };

/* Which derivatives are multiplied: v2, b, c, e, g, h. */
static const int pairs[PRODUCTS][2] = {{0, 0}, {1, 1}, {0, 1}, {2, 2}, {1, 2}, {0, 2}};

typedef struct {
    double factor;
    int speed;               /* the power of v */
    int power[PRODUCTS - 1]; /* of b, c, e, g, h */
} monomial;

static const monomial bending[] = {{1, -3, {1}}, {-1, -5, {0, 2}}};
static const monomial variation[] = {{1, -5, {0, 0, 1}},       {-6, -7, {0, 1, 0, 1}},
                                     {9, -9, {1, 2}},          {-1, -7, {0, 0, 0, 0, 2}},
                                     {6, -9, {0, 2, 0, 0, 1}}, {-9, -11, {0, 4}}};

/* The value and the derivatives by the products. */
typedef struct {
    double value, size, gradient[PRODUCTS], hessian[PRODUCTS][PRODUCTS];
} polynomial;

static double power_of(double x, int n)
{
    double product = 1;
    for (int i = 0; i < n; i++)
        product *= x;
    return product;
}

/* One factor of a monomial and its first two derivatives. */
static void factor_at(double x, int n, double out[3])
{
    out[0] = power_of(x, n);
    out[1] = n >= 1 ? n * power_of(x, n - 1) : 0;
    out[2] = n >= 2 ? n * (n - 1) * power_of(x, n - 2) : 0;
}

/* The same of v^n as a function of v2, n < 0 or 1. */
static void speed_at(double v2, int n, double out[3])
{
    const double v = sqrt(v2);
    out[0] = n < 0 ? 1 / power_of(v, -n) : power_of(v, n);
    out[1] = n / 2.0 * out[0] / v2;
    out[2] = (n / 2.0 - 1) * out[1] / v2;
}

/* The factors of a monomial that are not 1: which products they are powers of, and their values
 * and derivatives. */
typedef struct {
    int count, of[PRODUCTS];
    double at[PRODUCTS][3];
} factors;

static void find_factors(const monomial *m, const double *products, factors *out)
{
    out->count = 1;
    out->of[0] = 0;
    speed_at(products[0], m->speed, out->at[0]);
    for (int i = 1; i < PRODUCTS; i++) {
        if (m->power[i - 1] == 0)
            continue;
        factor_at(products[i], m->power[i - 1], out->at[out->count]);
        out->of[out->count++] = i;
    }
}

/* The product of all factors, of which a and b stand as their derivatives. */
static double derivative_of(const factors *f, int a, int b)
{
    double product = 1;
    for (int k = 0; k < f->count; k++)
        product *= f->at[k][(k == a) + (k == b)];
    return product;
}

static void add_monomial(const monomial *m, const double *products, double weight, bool all,
                         polynomial *sum)
{
    factors f;
    find_factors(m, products, &f);
    const double value = m->factor * derivative_of(&f, -1, -1);
    sum->value += value;
    sum->size += fabs(value);
    for (int a = 0; a < f.count && all; a++) {
        sum->gradient[f.of[a]] += weight * m->factor * derivative_of(&f, a, -1);
        for (int b = 0; b <= a; b++)
            sum->hessian[f.of[a]][f.of[b]] += weight * m->factor * derivative_of(&f, a, b);
    }
}

/* ---- from products to derivatives ---- */

/* The change of product i with the 3 d numbers. */
static void change_of(int d, const double *P, int i, double *out)
{
    const int a = pairs[i][0], b = pairs[i][1];
    memset(out, 0, sizeof(double) * (size_t)(3 * d));
    for (int c = 0; c < d; c++) {
        out[a * d + c] += P[b * d + c];
        out[b * d + c] += P[a * d + c];
    }
}

static void chain_rule(int d, const double *P, const polynomial *p, bat_energy_density *out)
{
    const int n = 3 * d;
    double changes[PRODUCTS][9], full[PRODUCTS][PRODUCTS];
    memset(out->gradient, 0, sizeof out->gradient);
    memset(out->hessian, 0, sizeof out->hessian);
    for (int i = 0; i < PRODUCTS; i++) {
        change_of(d, P, i, changes[i]);
        for (int j = 0; j <= i; j++)
            full[i][j] = full[j][i] = p->hessian[i][j];
    }
    for (int i = 0; i < PRODUCTS; i++) {
        double mixed[9] = {0};
        for (int j = 0; j < PRODUCTS; j++)
            for (int k = 0; k < n; k++)
                mixed[k] += full[i][j] * changes[j][k];
        for (int k = 0; k < n; k++) {
            out->gradient[k] += p->gradient[i] * changes[i][k];
            for (int l = 0; l <= k; l++)
                out->hessian[k * n + l] += changes[i][k] * mixed[l];
        }
    }
    for (int k = 0; k < n; k++)
        for (int l = 0; l < k; l++)
            out->hessian[l * n + k] = out->hessian[k * n + l];
    for (int i = 0; i < PRODUCTS; i++) {
        const int a = pairs[i][0] * d, b = pairs[i][1] * d;
        for (int c = 0; c < d; c++) {
            out->hessian[(a + c) * n + b + c] += p->gradient[i];
            out->hessian[(b + c) * n + a + c] += p->gradient[i];
        }
    }
}

void bat_energy_density_at(const bat_energy_weights *weights, int d, const double *P, bool all,
                           bat_energy_density *out)
{
    static const monomial length = {1, 1, {0}};
    const bool is_bending = weights->kind == BATTEN_ENERGY_BENDING;
    const monomial *terms = is_bending ? bending : variation;
    const int count = is_bending ? 2 : 6;
    polynomial p = {0};
    double products[PRODUCTS];
    for (int i = 0; i < PRODUCTS; i++)
        products[i] = bat_dot(d, P + pairs[i][0] * d, P + pairs[i][1] * d);
    for (int i = 0; i < count; i++)
        add_monomial(&terms[i], products, weights->energy, all, &p);
    out->energy = p.value;
    out->size = p.size;
    out->length = sqrt(products[0]);
    if (!all)
        return;
    if (weights->length != 0)
        add_monomial(&length, products, weights->length, all, &p);
    chain_rule(d, P, &p, out);
}
