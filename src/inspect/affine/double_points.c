/*
 * Double points of a plane polynomial curve, by elimination: the resultant of two forms in the
 * sum and the product of the parameters, computed exactly in whole numbers.
 */
#include "inspect/affine/double_points.h"

/*
 * X(t) = X(s) with t != s, divided by t - s, is symmetric in t and s. With S = t + s, Q = t s
 *
 *     (t^k - s^k) / (t - s) = h_{k-1}(S, Q),  h_0 = 1, h_1 = S, h_k = S h_{k-1} - Q h_{k-2},
 *
 * so double points are the common roots of f = sum x_k h_{k-1} and g = sum y_k h_{k-1}. With
 * Z = S + lambda Q the resultant R(Z) of f and g as polynomials in Q has their Z as roots, and
 * where the first subresultant M(Z) Q + N(Z) does not vanish with it there is one of them for
 * each root, with Q = -N / M. The numbers lambda are tried until that holds for all roots.
 *
 * R, M, N are determinants. They are found at whole Z and interpolated.
 */
typedef struct {
    bat_wholes *pool;    /* for what stays */
    bat_wholes *scratch; /* emptied for each Z */
    bat_whole_poly x, y;
    int lambda;
    int p, q;   /* degrees of f and g in Q, for all but a few Z */
    int weight; /* the degree in Z falls by that much for each power of Q */
} system_of;

/* h_0 .. h_{n-1} for S = z - lambda Q, as polynomials in Q. */
static void sum_powers(const system_of *s, int z, bat_whole_poly *h, int n)
{
    bat_whole_poly sum = bat_poly_make(s->scratch, 1), product = bat_poly_make(s->scratch, 1);
    if (sum.degree < 1 || product.degree < 1)
        return;
    sum.c[0] = bat_whole_of_int(s->scratch, z);
    sum.c[1] = bat_whole_of_int(s->scratch, -s->lambda);
    sum = bat_poly_trim(sum);
    product.c[1] = bat_whole_of_int(s->scratch, 1);
    product = bat_poly_trim(product);
    h[0] = bat_poly_constant(s->scratch, 1);
    for (int k = 1; k < n; k++) {
        h[k] = bat_poly_multiply(s->scratch, sum, h[k - 1]);
        if (k > 1)
            h[k] = bat_poly_combine(s->scratch, 1, h[k], -1,
                                    bat_poly_multiply(s->scratch, product, h[k - 2]));
    }
}

/* The coefficients of f or g at Z = z, [degree + 1] with the lowest first. */
static const bat_whole *at_sum(const system_of *s, bat_whole_poly x, const bat_whole_poly *h,
                               int degree)
{
    bat_whole *c = bat_wholes_take(s->scratch, (size_t)degree + 1, sizeof *c);
    for (int k = 1; c && k <= x.degree; k++)
        for (int i = 0; i <= h[k - 1].degree; i++)
            c[i] = bat_whole_add(s->scratch, c[i],
                                 bat_whole_multiply(s->scratch, x.c[k], h[k - 1].c[i]));
    return c;
}

/* ---- determinants ---- */

/* Fractions stay away: [Bareiss68]. a [n][n] is spoilt. */
static bat_whole determinant(bat_wholes *pool, int n, bat_whole *a)
{
    bat_whole before = bat_whole_of_int(pool, 1);
    int sign = 1;
    for (int k = 0; k < n; k++) {
        int pivot = k;
        while (pivot < n && a[pivot * n + k].sign == 0)
            pivot++;
        if (pivot == n)
            return (bat_whole){0, 0, NULL};
        for (int j = k; pivot != k && j < n; j++) {
            const bat_whole swapped = a[k * n + j];
            a[k * n + j] = a[pivot * n + j];
            a[pivot * n + j] = swapped;
        }
        sign = pivot != k ? -sign : sign;
        for (int i = k + 1; i < n; i++)
            for (int j = k + 1; j < n; j++) {
                const bat_whole up = bat_whole_multiply(pool, a[i * n + j], a[k * n + k]);
                const bat_whole down = bat_whole_multiply(pool, a[i * n + k], a[k * n + j]);
                a[i * n + j] =
                    bat_whole_divide(pool, bat_whole_subtract(pool, up, down), before, NULL);
            }
        before = a[k * n + k];
    }
    return sign < 0 ? bat_whole_negated(before) : before;
}

/* The determinant of q - j rows of f and p - j of g, shifted; its last column is that of Q^last
 * instead of the next one. j = 0, last = 0: the resultant; j = 1: the first subresultant's
 * coefficients of Q^last. */
static bat_whole sylvester(const system_of *s, const bat_whole *f, const bat_whole *g, int j,
                           int last)
{
    const int n = s->p + s->q - 2 * j, of_f = s->q - j;
    bat_whole *a = bat_wholes_take(s->scratch, (size_t)n * (size_t)n, sizeof *a);
    for (int row = 0; a && row < n; row++) {
        const bool is_f = row < of_f;
        const int shift = is_f ? of_f - 1 - row : n - 1 - row, degree = is_f ? s->p : s->q;
        for (int column = 0; column < n; column++) {
            const int power = column < n - 1 ? s->p + s->q - j - 1 - column : last;
            if (power >= shift && power - shift <= degree)
                a[row * n + column] = (is_f ? f : g)[power - shift];
        }
    }
    return a ? determinant(s->scratch, n, a) : (bat_whole){0, 0, NULL};
}

/* ---- as polynomials in Z ---- */

enum { RESULTANT, FACTOR, CONSTANT, FORMS }; /* R, M, N */

static void forms_at(const system_of *s, int z, bat_whole *out)
{
    bat_whole_poly *h = bat_wholes_take(s->scratch, (size_t)s->x.degree, sizeof *h);
    if (!h)
        return;
    sum_powers(s, z, h, s->x.degree);
    const bat_whole *f = at_sum(s, s->x, h, s->p), *g = at_sum(s, s->y, h, s->q);
    if (!f || !g || s->scratch->effort->status != BATTEN_OK)
        return;
    bat_whole made[FORMS] = {sylvester(s, f, g, 0, 0)};
    if (s->q >= 2) {
        made[FACTOR] = sylvester(s, f, g, 1, 1);
        made[CONSTANT] = sylvester(s, f, g, 1, 0);
    } else { /* one of the two is linear itself */
        made[FACTOR] = (s->q == 1 ? g : f)[1];
        made[CONSTANT] = (s->q == 1 ? g : f)[0];
    }
    for (int k = 0; k < FORMS; k++)
        out[k] = bat_whole_copy(s->pool, made[k]);
}

/* Nodes 0, 1, -1, 2, -2 ... */
static int node(int k)
{
    return k % 2 ? (k + 1) / 2 : -k / 2;
}

/* Newton's form through values[k * FORMS] at the nodes; the values are spoilt. Differences of a
 * polynomial with whole coefficients are whole. */
static bat_whole_poly interpolate(bat_wholes *pool, int count, bat_whole *values)
{
    for (int r = 1; r < count; r++)
        for (int k = count - 1; k >= r; k--)
            values[k * FORMS] = bat_whole_divide(
                pool, bat_whole_subtract(pool, values[k * FORMS], values[(k - 1) * FORMS]),
                bat_whole_of_int(pool, node(k) - node(k - r)), NULL);
    bat_whole_poly sum = bat_poly_make(pool, count - 1);
    for (int k = count - 1; k >= 0 && sum.degree >= 0; k--) {
        for (int i = count - 1; i >= 0; i--) /* sum (Z - node) + value */
            sum.c[i] = bat_whole_subtract(pool, i ? sum.c[i - 1] : (bat_whole){0, 0, NULL},
                                          bat_whole_times(pool, sum.c[i], node(k)));
        sum.c[0] = bat_whole_add(pool, sum.c[0], values[k * FORMS]);
    }
    return bat_poly_trim(sum);
}

/* No form has a higher degree in Z. Entries of weights that fall by `weight` with each power of
 * Q make determinants of a weight that is known. */
static int highest_degree(const system_of *s)
{
    const int m = s->x.degree - 1, n = s->y.degree - 1, p = s->p, q = s->q, w = s->weight;
    const int whole = q * m + p * n - w * p * q;
    if (q < 2)
        return bat_max_int(whole, bat_max_int(m, n));
    const int columns = (p + q - 2) * (p + q - 1) / 2;
    const int part = (q - 1) * m + (p - 1) * n +
                     w * ((q - 2) * (q - 1) / 2 + (p - 2) * (p - 1) / 2 - columns + 1);
    return bat_max_int(whole, part);
}

static int highest_bits(bat_whole_poly p)
{
    int bits = 0;
    for (int i = 0; i <= p.degree; i++)
        bits = bat_max_int(bits, bat_whole_bits(p.c[i]));
    return bits;
}

/* Will the effort be enough for the determinants? In stage k entries have k times the bits of
 * the first ones; three products of them, in three determinants at each Z, are most of the
 * work.
 */
static bool is_within_effort(const system_of *s)
{
    enum { CALLS = 72 };
    const int n = s->p + s->q, bits = bat_max_int(highest_bits(s->x), highest_bits(s->y));
    double steps = 0;
    for (int k = 1; k < n; k++) {
        const double limbs = 1 + k * bits / 32.0;
        steps += 3 * (double)(n - k) * (n - k) * (CALLS + 3 * limbs * limbs);
    }
    return steps * (highest_degree(s) + 1) <= (double)s->pool->effort->steps;
}

static void eliminate(const system_of *s, bat_whole_poly *forms)
{
    const int count = highest_degree(s) + 1;
    bat_whole *values = bat_wholes_take(s->pool, (size_t)count * FORMS, sizeof *values);
    for (int k = 0; values && k < count; k++) {
        forms_at(s, node(k), values + k * FORMS);
        bat_wholes_empty(s->scratch);
    }
    for (int k = 0; k < FORMS; k++)
        forms[k] =
            values ? interpolate(s->pool, count, values + k) : (bat_whole_poly){-1, NULL};
}

/* ---- what the roots say ---- */

/* S = a / m, Q = b / m, and what decides about a root, each with the sign of its name. */
typedef struct {
    bat_whole_poly a, b, m, discriminant, square; /* S^2 - 4 Q, times `square` = m^2 */
    bat_whole_poly inside[4];                     /* Q, S, 2 - S, (1 - t)(1 - s): all above 0 */
} conditions;

static conditions conditions_of(const system_of *s, const bat_whole_poly *forms)
{
    bat_wholes *const pool = s->pool;
    bat_whole_poly z = bat_poly_make(pool, 1);
    if (z.degree == 1)
        z.c[1] = bat_whole_of_int(pool, 1);
    conditions c = {.m = forms[FACTOR]};
    c.b = bat_poly_combine(pool, -1, forms[CONSTANT], 0, forms[CONSTANT]);
    c.a = bat_poly_combine(pool, 1, bat_poly_multiply(pool, bat_poly_trim(z), c.m), s->lambda,
                           forms[CONSTANT]);
    c.square = bat_poly_multiply(pool, c.m, c.m);
    c.discriminant = bat_poly_combine(pool, 1, bat_poly_multiply(pool, c.a, c.a), -4,
                                      bat_poly_multiply(pool, c.b, c.m));
    const bat_whole_poly parts[4] = {
        c.b, c.a, bat_poly_combine(pool, 2, c.m, -1, c.a),
        bat_poly_combine(pool, 1, bat_poly_combine(pool, 1, c.m, -1, c.a), 1, c.b)};
    for (int k = 0; k < 4; k++)
        c.inside[k] = bat_poly_multiply(pool, parts[k], c.m);
    return c;
}

static double ratio_at(bat_wholes *pool, bat_whole_poly a, bat_whole_poly b, bat_whole u,
                       bat_whole v)
{
    const int degree = bat_max_int(a.degree, b.degree);
    const bat_whole below = bat_poly_value(pool, b, degree, u, v);
    return below.sign ? bat_whole_ratio(bat_poly_value(pool, a, degree, u, v), below) : 0;
}

/* Enough that rounding to doubles is what is left. */
enum { BITS = 90 };

static void look_at_root(bat_wholes *pool, const conditions *c, bat_whole_poly part,
                         int multiplicity, bat_whole_root root, bat_double_point *out)
{
    bat_whole u, v;
    *out = (bat_double_point){.multiplicity = multiplicity};
    out->sign = bat_poly_sign_at(pool, c->discriminant, part, &root);
    out->inside = out->sign > 0;
    for (int k = 0; k < 4 && out->inside; k++)
        out->inside = bat_poly_sign_at(pool, c->inside[k], part, &root) > 0;
    bat_poly_refine(pool, part, BITS, &root);
    bat_whole_root_middle(pool, &root, &u, &v);
    out->sum = ratio_at(pool, c->a, c->m, u, v);
    out->discriminant = out->sign ? ratio_at(pool, c->discriminant, c->square, u, v) : 0;
}

static bat_double_points look_at_roots(const system_of *s, const bat_whole_poly *forms)
{
    const bat_whole_poly resultant = bat_poly_primitive(s->pool, forms[RESULTANT]);
    const int most = resultant.degree;
    bat_double_points found = {.known = BAT_DOUBLE_POINTS_UNKNOWN, .finite = most};
    bat_whole_poly *parts = bat_wholes_take(s->pool, (size_t)most + 1, sizeof *parts);
    bat_whole_root *roots = bat_wholes_take(s->pool, (size_t)most + 1, sizeof *roots);
    found.at = bat_wholes_take(s->pool, (size_t)most + 1, sizeof *found.at);
    if (!parts || !roots || !found.at)
        return found;
    const conditions c = conditions_of(s, forms);
    const int highest = bat_poly_squarefree(s->pool, resultant, parts);
    for (int k = 1; k <= highest; k++) {
        int count = 0;
        bat_poly_isolate(s->pool, parts[k], roots, &count);
        for (int i = 0; i < count; i++) {
            look_at_root(s->scratch, &c, parts[k], k, roots[i], &found.at[found.count++]);
            bat_wholes_empty(s->scratch);
        }
    }
    if (s->pool->effort->status == BATTEN_OK)
        found.known = BAT_DOUBLE_POINTS_ALL;
    return found;
}

/* Degrees in Q. Without lambda the first coefficient is linear in Z where the degree of h is
 * odd: when both are, they could vanish together, which looks like a root. */
static bool set_up(system_of *s, int lambda)
{
    const int m = s->x.degree - 1, n = s->y.degree - 1;
    s->lambda = lambda;
    s->weight = lambda ? 1 : 2;
    s->p = m / s->weight;
    s->q = n / s->weight;
    if (lambda == 0 && m % 2 && n % 2)
        return false;
    return s->q > 0 || s->p == 1;
}

bat_double_points bat_double_points_find(bat_wholes *pool, bat_whole_poly x, bat_whole_poly y)
{
    static const int lambdas[] = {0, 1, -1, 2, -3, 5};
    bat_wholes scratch = {pool->effort, NULL, NULL, 0};
    system_of s = {.pool = pool, .scratch = &scratch, .x = x, .y = y};
    bat_double_points found = {.known = BAT_DOUBLE_POINTS_UNKNOWN};
    if (y.degree < 2) { /* the graph of a function passes no point twice */
        found.known = BAT_DOUBLE_POINTS_ALL;
        return found;
    }
    for (size_t k = 0; k < sizeof lambdas / sizeof *lambdas; k++) {
        bat_whole_poly forms[FORMS];
        if (!set_up(&s, lambdas[k]))
            continue;
        if (!is_within_effort(&s))
            break;
        eliminate(&s, forms);
        if (pool->effort->status != BATTEN_OK)
            break;
        if (forms[RESULTANT].degree < 0) {
            found.known = BAT_DOUBLE_POINTS_REPEATED;
            break;
        }
        if (forms[FACTOR].degree >= 0 &&
            bat_poly_gcd(pool, forms[RESULTANT], forms[FACTOR]).degree == 0) {
            found = look_at_roots(&s, forms);
            break;
        }
    }
    bat_wholes_release(&scratch);
    return found;
}
