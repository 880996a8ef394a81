/*
 * Blending functions as clamped splines. That F, G and H of Coons' splines are the only such
 * ones: C2 cubics on three fixed spans have six coefficients, and there are six conditions.
 */
#include "base/plural.h"
#include "shape/boundary/coons_formula.h"

#include "spline/curve/curve.h"

enum { MOST = 8 };

/* Knots and coefficients of F0, G0, H0 on the left half of their symmetry: F1(t) = F0(1 - t),
 * G1(t) = -G0(1 - t), H1(t) = H0(1 - t). */
typedef struct {
    int degree, count, order;
    double knots[MOST + MOST];
    double left[3][MOST];
} family;

static const family families[] = {
    {1, 2, 1, {0, 0, 1, 1}, {{1, 0}}},
    {3, 4, 2, {0, 0, 0, 0, 1, 1, 1, 1}, {{1, 1, 0, 0}, {0, 1 / 3.0, 0, 0}}},
    {5,
     6,
     3,
     {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1},
     {{1, 1, 1, 0, 0, 0}, {0, 1 / 5.0, 2 / 5.0, 0, 0, 0}, {0, 0, 1 / 20.0, 0, 0, 0}}},
    {3,
     6,
     3,
     {0, 0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1, 1},
     {{1, 1, 1, 0, 0, 0}, {0, 1 / 9.0, 1 / 3.0, 0, 0, 0}, {0, 0, 1 / 27.0, 0, 0, 0}}}};

static const char *const names[] = {"F0", "F1", "G0", "G1", "H0", "H1"};

static batten_status make_function(const family *of, int which, batten_curve **out)
{
    const int order = which / 2, n = of->count;
    const double sign = order == 1 ? -1 : 1;
    double values[MOST];
    for (int i = 0; i < n; i++)
        values[i] = which % 2 ? sign * of->left[order][n - 1 - i] : of->left[order][i];
    return batten_curve_create((batten_points){1, n, values}, of->degree, NULL, of->knots, out);
}

batten_status batten_blending_functions(batten_blending blending, int order, batten_curve **out)
{
    assert(out);
    if (order < 1 || order > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order is %d, not 1 to 3", order);
    if (blending < BATTEN_BLENDING_LINEAR || blending > BATTEN_BLENDING_COONS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no family %d of blending functions",
                        (int)blending);
    const family *of = &families[blending];
    if (order > of->order)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "%s blending functions have no %c: order %d at most",
                        blending == BATTEN_BLENDING_LINEAR ? "linear" : "cubic",
                        "FGH"[order - 1], of -> order);
    batten_curve *made[6] = {NULL};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 2 * order; i++)
        status = make_function(of, i, &made[i]);
    for (int i = 0; i < 2 * order; i++) {
        if (status == BATTEN_OK)
            out[i] = made[i];
        else
            batten_curve_unref(made[i]);
    }
    return status;
}

/* All conditions on one function, at both ends. */
static batten_status check_function(int which, const batten_curve *function, int derivatives)
{
    static const char *const what[] = {"the value", "the slope", "the second derivative"};
    for (int end = 0; end < 2; end++) {
        double values[3];
        const batten_status status = batten_curve_evaluate(function, end, derivatives, values);
        if (status != BATTEN_OK)
            return status;
        for (int k = 0; k <= derivatives; k++) {
            /* Values of 0 and 1 given with ten digits; the polynomials themselves round at 1e-15. */
            const double wanted = k == which / 2 && end == which % 2;
            if (!(fabs(values[k] - wanted) <= 1e-10))
                return bat_fail(BATTEN_NOT_COMPATIBLE, "%s: %s at %d is %g, not %g",
                                names[which], what[k], end, values[k], wanted);
        }
    }
    return BATTEN_OK;
}

batten_status batten_blending_check(int order, const batten_curve *const *functions,
                                    int derivatives)
{
    assert(functions);
    if (order < 1 || order > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order is %d, not 1 to 3", order);
    if (derivatives < 0 || derivatives > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d derivatives cannot be looked at, only 0 to 2",
                        derivatives);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 2 * order; i++) {
        const batten_curve *function = functions[i];
        const batten_interval domain = batten_curve_domain(function);
        if (function->dimension != 1)
            status = bat_fail(BATTEN_NOT_COMPATIBLE, "%s has %d dimension%s, not 1", names[i],
                              function->dimension, bat_plural(function->dimension));
        else if (domain.a != 0 || domain.b != 1)
            status = bat_fail(BATTEN_NOT_COMPATIBLE, "%s is given over [%g, %g], not [0, 1]",
                              names[i], domain.a, domain.b);
        else
            status = check_function(i, function, derivatives);
    }
    return status;
}
