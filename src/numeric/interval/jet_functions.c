/* Taylor arithmetic over boxes: elementary functions, by their own series at an interval. */
#include "numeric/interval/jet.h"

typedef bat_interval series[BAT_JET_COEFFICIENTS];

/* f, f', f'' ... over the factorials, where the derivatives repeat after four. */
static void divide_by_factorials(const bat_jet_space *s, const bat_interval cycle[4], series g)
{
    double factorial = 1;
    for (int k = 0; k <= s->order; k++) {
        factorial *= k > 1 ? k : 1;
        g[k] = bat_interval_divide(cycle[k % 4], bat_interval_at(factorial));
    }
}

static void apply_sine(const bat_jet_space *s, int quarter, bat_interval_jet *a)
{
    series g;
    const bat_interval sine = bat_interval_sin(a->c[0]), cosine = bat_interval_cos(a->c[0]);
    const bat_interval all[4] = {sine, cosine, bat_interval_negative(sine),
                                 bat_interval_negative(cosine)};
    const bat_interval cycle[4] = {all[quarter], all[quarter + 1], all[(quarter + 2) % 4],
                                   all[(quarter + 3) % 4]};
    divide_by_factorials(s, cycle, g);
    bat_ijet_compose(s, g, a);
}

static void apply_exponential(const bat_jet_space *s, bat_interval_jet *a)
{
    series g;
    const bat_interval e = a->c[0].lo == 0 && a->c[0].hi == 0
                               ? bat_interval_at(1)
                               : bat_interval_of_rising(bat_exp, a->c[0]);
    const bat_interval cycle[4] = {e, e, e, e};
    divide_by_factorials(s, cycle, g);
    bat_ijet_compose(s, g, a);
}

/* exp(a) and exp(-a), half their sum or difference. */
static void apply_hyperbolic(const bat_jet_space *s, bool is_sine, bat_interval_jet *a)
{
    series g;
    const bat_interval up = bat_interval_of_rising(bat_exp, a->c[0]);
    const bat_interval down = bat_interval_of_rising(bat_exp, bat_interval_negative(a->c[0]));
    const bat_interval x = a->c[0];
    const bat_interval sine = bat_interval_of_rising(bat_sinh, x);
    bat_interval cosine = bat_interval_scale(0.5, bat_interval_add(up, down));
    cosine.lo = bat_max(cosine.lo, 1);
    const bat_interval first = is_sine ? sine : cosine, second = is_sine ? cosine : sine;
    const bat_interval cycle[4] = {first, second, first, second};
    divide_by_factorials(s, cycle, g);
    bat_ijet_compose(s, g, a);
}

/* ln x: (-1)^(k - 1) / (k x^k). */
static void apply_logarithm(bat_jet_space *s, bat_interval_jet *a)
{
    series g;
    const bat_interval x = a->c[0];
    if (!(x.lo > 0)) {
        bat_jet_space_meet(s, x.hi <= 0 ? BAT_UNDEFINED : BAT_PARTLY);
        bat_ijet_forget(s, 0, a);
        if (x.hi > 0)
            a->c[0].hi = bat_interval_of_rising(bat_log, bat_interval_at(x.hi)).hi;
        return;
    }
    g[0] = bat_interval_of_rising(bat_log, x);
    for (int k = 1; k <= s->order; k++)
        g[k] = bat_interval_divide(bat_interval_at(k % 2 ? 1 : -1),
                                   bat_interval_scale(k, bat_interval_power(x, k)));
    bat_ijet_compose(s, g, a);
}

/* The derivative of atan: r = 1 / (1 + x^2), by r (h0 + h1 t + t^2) = 1. */
static void apply_arc_tangent(const bat_jet_space *s, bat_interval_jet *a)
{
    series g, r;
    const bat_interval x = a->c[0];
    const bat_interval h0 = bat_interval_add(bat_interval_at(1), bat_interval_power(x, 2));
    const bat_interval h1 = bat_interval_scale(2, x);
    g[0] = bat_interval_of_rising(bat_atan, x);
    for (int k = 0; k < s->order; k++) {
        bat_interval sum = bat_interval_at(k == 0 ? 1 : 0);
        if (k > 0)
            sum = bat_interval_subtract(sum, bat_interval_multiply(h1, r[k - 1]));
        if (k > 1)
            sum = bat_interval_subtract(sum, r[k - 2]);
        r[k] = bat_interval_divide(sum, h0);
        g[k + 1] = bat_interval_divide(r[k], bat_interval_at(k + 1));
    }
    bat_ijet_compose(s, g, a);
}

/* The derivative of asin: r = q^(-1/2) with q = 1 - x^2 - 2 x t - t^2, by k q0 r_k =
 * sum over j of (-j / 2 - k + j) q_j r_(k - j). */
static void inverse_root_series(const bat_jet_space *s, bat_interval x, series r)
{
    const bat_interval one = bat_interval_at(1);
    const bat_interval q[3] = {
        bat_interval_multiply(bat_interval_subtract(one, x), bat_interval_add(one, x)),
        bat_interval_scale(-2, x), bat_interval_at(-1)};
    r[0] = bat_interval_divide(one, bat_interval_real_power(q[0], 0.5));
    for (int k = 1; k < s->order; k++) {
        bat_interval sum = bat_interval_at(0);
        for (int j = 1; j <= 2 && j <= k; j++)
            sum = bat_interval_add(
                sum, bat_interval_scale(0.5 * j - k, bat_interval_multiply(q[j], r[k - j])));
        r[k] = bat_interval_divide(sum, bat_interval_scale(k, q[0]));
    }
}

static void apply_arc_sine(bat_jet_space *s, bat_interval_jet *a)
{
    series g, r;
    const bat_interval x = a->c[0], within = bat_interval_common(x, (bat_interval){-1, 1});
    if (within.lo > within.hi)
        bat_jet_space_meet(s, BAT_UNDEFINED);
    else if (x.lo < -1 || x.hi > 1)
        bat_jet_space_meet(s, BAT_PARTLY);
    if (within.lo > within.hi || !(x.lo > -1 && x.hi < 1)) {
        bat_ijet_forget(s, 0, a);
        if (within.lo <= within.hi)
            a->c[0] = bat_interval_of_rising(bat_asin, within);
        return;
    }
    g[0] = bat_interval_of_rising(bat_asin, x);
    inverse_root_series(s, x, r);
    for (int k = 1; k <= s->order; k++)
        g[k] = bat_interval_divide(r[k - 1], bat_interval_at(k));
    bat_ijet_compose(s, g, a);
}

static void apply_arc_cosine(bat_jet_space *s, bat_interval_jet *a)
{
    bat_interval_jet quarter;
    const bat_interval right = {bat_below(0.5 * BAT_PI), bat_above(0.5 * BAT_PI)};
    bat_ijet_constant(s, right, &quarter);
    apply_arc_sine(s, a);
    bat_ijet_subtract(s, &quarter, a, a);
}

/* A corner at 0: the slope is between -1 and 1 there, and further derivatives are gone. */
static void apply_absolute(const bat_jet_space *s, bat_interval_jet *a)
{
    const bat_interval value = a->c[0];
    const int side = bat_ijet_side(s, a);
    if (side > 0 || (side == 0 && value.lo >= 0))
        return;
    for (int i = 0; i < s->count; i++) {
        const bat_interval negative = bat_interval_negative(a->c[i]);
        a->c[i] = value.hi <= 0 ? negative : bat_interval_hull(a->c[i], negative);
    }
    if (value.hi <= 0)
        return;
    bat_ijet_forget(s, 2, a);
    a->c[0] = (bat_interval){0, bat_interval_size(value)};
}

/* The quotient of the two that belong to each other. */
static void apply_quotient(bat_jet_space *s, bat_ijet_function above, bat_ijet_function below,
                           bat_interval_jet *a)
{
    bat_interval_jet divisor = *a;
    bat_ijet_apply(s, above, a);
    bat_ijet_apply(s, below, &divisor);
    bat_ijet_divide(s, a, &divisor, a);
}

static void apply_decimal_logarithm(bat_jet_space *s, bat_interval_jet *a)
{
    bat_interval_jet ten;
    bat_ijet_constant(s, bat_interval_of_rising(bat_log, bat_interval_at(10)), &ten);
    apply_logarithm(s, a);
    bat_ijet_divide(s, a, &ten, a);
}

static void apply_root(bat_jet_space *s, bat_interval_jet *a)
{
    bat_interval_jet half;
    bat_ijet_constant(s, bat_interval_at(0.5), &half);
    bat_ijet_power(s, a, &half, a);
}

void bat_ijet_apply(bat_jet_space *s, bat_ijet_function function, bat_interval_jet *a)
{
    switch (function) {
    case BAT_IJET_SIN:
    case BAT_IJET_COS:
        apply_sine(s, function == BAT_IJET_COS, a);
        return;
    case BAT_IJET_TAN:
        apply_quotient(s, BAT_IJET_SIN, BAT_IJET_COS, a);
        return;
    case BAT_IJET_ASIN:
        apply_arc_sine(s, a);
        return;
    case BAT_IJET_ACOS:
        apply_arc_cosine(s, a);
        return;
    case BAT_IJET_ATAN:
        apply_arc_tangent(s, a);
        return;
    case BAT_IJET_SINH:
    case BAT_IJET_COSH:
        apply_hyperbolic(s, function == BAT_IJET_SINH, a);
        return;
    case BAT_IJET_TANH:
        apply_quotient(s, BAT_IJET_SINH, BAT_IJET_COSH, a);
        return;
    case BAT_IJET_EXP:
        apply_exponential(s, a);
        return;
    case BAT_IJET_LN:
        apply_logarithm(s, a);
        return;
    case BAT_IJET_LOG10:
        apply_decimal_logarithm(s, a);
        return;
    case BAT_IJET_SQRT:
        apply_root(s, a);
        return;
    default:
        apply_absolute(s, a);
    }
}

/* ---- powers ---- */

static bool is_constant(const bat_jet_space *s, const bat_interval_jet *a)
{
    for (int i = 1; i < s->count; i++)
        if (a->c[i].lo != 0 || a->c[i].hi != 0)
            return false;
    return a->c[0].lo == a->c[0].hi;
}

/* x^n: binomial (n over k) x^(n - k). */
static void raise_to_whole(bat_jet_space *s, int n, bat_interval_jet *a)
{
    series g;
    double binomial = 1;
    for (int k = 0; k <= s->order; k++) {
        g[k] = k > n ? bat_interval_at(0)
                     : bat_interval_scale(binomial, bat_interval_power(a->c[0], n - k));
        binomial = binomial * (n - k) / (k + 1);
    }
    bat_ijet_compose(s, g, a);
}

/* x^p for x >= 0. The value is known also where the derivatives are not, at 0. */
static void raise_to_real(bat_jet_space *s, double p, bat_interval_jet *a)
{
    series g;
    bat_interval x = a->c[0], binomial = bat_interval_at(1);
    if (x.hi < 0 || (x.hi == 0 && p < 0))
        bat_jet_space_meet(s, BAT_UNDEFINED);
    else if (x.lo < 0 || (x.lo == 0 && p < 0))
        bat_jet_space_meet(s, BAT_PARTLY);
    if (!(x.lo > 0)) {
        bat_ijet_forget(s, 0, a);
        if (x.hi >= 0 && p > 0)
            a->c[0] = bat_interval_real_power((bat_interval){0, x.hi}, p);
        return;
    }
    for (int k = 0; k <= s->order; k++) {
        g[k] = bat_interval_multiply(binomial, bat_interval_real_power(x, p - k));
        binomial =
            bat_interval_divide(bat_interval_scale(p - k, binomial), bat_interval_at(k + 1));
    }
    bat_ijet_compose(s, g, a);
}

void bat_ijet_power(bat_jet_space *s, const bat_interval_jet *a, const bat_interval_jet *b,
                    bat_interval_jet *out)
{
    /* Whole exponents beyond this are powers of positive numbers. */
    const double most_whole = 1000;
    bat_interval_jet base = *a, one;
    const double p = b->c[0].lo;
    if (!is_constant(s, b)) {
        bat_ijet_apply(s, BAT_IJET_LN, &base);
        bat_ijet_multiply(s, b, &base, &base);
        bat_ijet_apply(s, BAT_IJET_EXP, &base);
    } else if (p == floor(p) && fabs(p) <= most_whole) {
        raise_to_whole(s, (int)fabs(p), &base);
        bat_ijet_constant(s, bat_interval_at(1), &one);
        if (p < 0)
            bat_ijet_divide(s, &one, &base, &base);
    } else {
        raise_to_real(s, p, &base);
    }
    *out = base;
}
