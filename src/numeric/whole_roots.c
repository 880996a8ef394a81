/*
 * Real roots of a polynomial with whole coefficients as proved intervals: isolated by halving
 * with Descartes' rule of signs, then refined. Source: [CA76] and [Abbott14].
 */
#include "numeric/whole_polynomial.h"

/* Two roots nearer than this are not told apart. */
enum { DEPTH = 200 };

/* ---- one interval ---- */

/* c[0 .. degree] of p(x), or of x^degree p(1 / x), becomes that of p(x + by). */
static void shift_by(bat_wholes *pool, int degree, bat_whole *c, bat_whole by)
{
    const bool is_one = by.sign > 0 && by.count == 1 && by.limb[0] == 1;
    for (int i = 0; i < degree && by.sign != 0; i++)
        for (int j = degree - 1; j >= i; j--)
            c[j] = bat_whole_add(pool, c[j],
                                 is_one ? c[j + 1] : bat_whole_multiply(pool, c[j + 1], by));
}

bat_whole_poly bat_poly_shift(bat_wholes *pool, bat_whole_poly p, bat_whole by)
{
    const bat_whole_poly shifted = bat_poly_copy(pool, p);
    shift_by(pool, shifted.degree, shifted.c, by);
    return bat_poly_trim(shifted);
}

void bat_poly_bernstein(bat_wholes *pool, bat_whole_poly p, double *b)
{
    /* x^d p(1 / x) at x + 1 is the sum of C(d, k) b[k] x^(d - k) */
    const int d = p.degree;
    bat_whole_poly q = bat_poly_make(pool, d);
    int highest = 0, exponent;
    double largest = 0, binomial = 1;
    for (int i = 0; i <= q.degree; i++)
        q.c[i] = p.c[d - i];
    shift_by(pool, q.degree, q.c, bat_whole_of_int(pool, 1));
    for (int i = 0; i <= q.degree; i++)
        highest = bat_max_int(highest, bat_whole_bits(q.c[i]));
    for (int k = 0; k <= q.degree; k++) {
        const double part = bat_whole_frexp(q.c[d - k], &exponent);
        b[k] = ldexp(part, exponent - highest) / binomial;
        largest = bat_max(largest, fabs(b[k]));
        binomial *= (double)(d - k) / (k + 1);
    }
    for (int k = 0; k <= d; k++)
        b[k] = q.degree == d && largest > 0 ? b[k] / largest : 0;
}

/* How often the coefficients change their sign that p has after (c, c + 1) / 2^k was mapped to
 * (0, infinity): the number of its roots there, or an even number more. */
static int variations(bat_wholes *pool, bat_whole_poly p, bool inverse, bat_whole c, int k)
{
    const int d = p.degree;
    bat_wholes scratch = {pool->effort, NULL, NULL, 0};
    bat_whole_poly q = bat_poly_make(&scratch, d);
    int changes = 0, sign = 0;
    for (int i = 0; i <= q.degree; i++)
        q.c[i] = bat_whole_shift(&scratch, p.c[inverse ? d - i : i], k * (d - i));
    if (q.degree >= 0)
        shift_by(&scratch, d, q.c, c);
    for (int i = 0; i < (q.degree + 1) / 2; i++) {
        const bat_whole swapped = q.c[i];
        q.c[i] = q.c[d - i];
        q.c[d - i] = swapped;
    }
    if (q.degree >= 0)
        shift_by(&scratch, d, q.c, bat_whole_of_int(&scratch, 1));
    for (int i = 0; i <= q.degree; i++) {
        changes += q.c[i].sign * sign < 0;
        sign = q.c[i].sign ? q.c[i].sign : sign;
    }
    bat_wholes_release(&scratch);
    return changes;
}

/* x = c / 2^k as t = u / v with v > 0; t is infinite where v is 0 */
static void quotient_of(bat_wholes *pool, bool inverse, bat_whole c, int k, bat_whole *u,
                        bat_whole *v)
{
    const bat_whole power = bat_whole_shift(pool, bat_whole_of_int(pool, 1), k);
    *u = inverse ? power : c;
    *v = inverse ? c : power;
    if (v->sign < 0) {
        *u = bat_whole_negated(*u);
        *v = bat_whole_negated(*v);
    }
}

/* The value of the polynomial in x at c / 2^k, times a power of two. */
static bat_whole value_at(bat_wholes *pool, bat_whole_poly p, bool inverse, bat_whole c, int k)
{
    const bat_whole power = bat_whole_shift(pool, bat_whole_of_int(pool, 1), k);
    if (!inverse)
        return bat_poly_value(pool, p, p.degree, c, power);
    return bat_poly_value(pool, p, p.degree, power, c);
}

/* The sign of the polynomial in x just right of c / 2^k. */
static int sign_right_of(bat_wholes *pool, bat_whole_poly p, bool inverse, bat_whole c, int k)
{
    const int here = value_at(pool, p, inverse, c, k).sign;
    if (here != 0 || pool->effort->status != BATTEN_OK)
        return here;
    bat_whole_poly x = bat_poly_make(pool, p.degree);
    for (int i = 0; i <= x.degree; i++)
        x.c[i] = p.c[inverse ? p.degree - i : i];
    return value_at(pool, bat_poly_derivative(pool, bat_poly_trim(x)), false, c, k).sign;
}

static bat_whole doubled(bat_wholes *pool, bat_whole c, int more)
{
    return bat_whole_add(pool, bat_whole_shift(pool, c, 1), bat_whole_of_int(pool, more));
}

/* ---- all roots ---- */

typedef struct {
    bat_wholes *pool;
    bat_whole_poly p;
    bat_whole_root *roots;
    int count;
} search;

static void keep_root(search *s, bool inverse, bool exact, bat_whole c, int k)
{
    if (s->count >= s->p.degree)
        return; /* only an effort that has failed comes here */
    const int sign = exact ? 0 : sign_right_of(s->pool, s->p, inverse, c, k);
    s->roots[s->count++] = (bat_whole_root){inverse, exact, c, k, sign};
}

/* What waits: an interval, or the point c / 2^k alone. */
typedef struct {
    bat_whole c;
    int k;
    bool is_point;
} place;

/* Roots in the open interval (begin, begin + 1) of x, rising. */
static void search_unit(search *s, bool inverse, int begin)
{
    place *stack = bat_wholes_take(s->pool, 2 * DEPTH + 4, sizeof *stack);
    int waiting = 0;
    if (stack)
        stack[waiting++] = (place){bat_whole_of_int(s->pool, begin), 0, false};
    while (waiting > 0 && s->pool->effort->status == BATTEN_OK) {
        const place at = stack[--waiting];
        const bat_whole c = at.c;
        const int k = at.k;
        if (at.is_point) {
            if (value_at(s->pool, s->p, inverse, c, k).sign == 0)
                keep_root(s, inverse, true, c, k);
            continue;
        }
        const int changes = variations(s->pool, s->p, inverse, c, k);
        if (changes == 0)
            continue;
        if (changes == 1) {
            keep_root(s, inverse, false, c, k);
            continue;
        }
        if (k == DEPTH) {
            s->pool->effort->status = BATTEN_INCOMPLETE;
            return;
        }
        const bat_whole middle = doubled(s->pool, c, 1);
        stack[waiting++] = (place){middle, k + 1, false};
        stack[waiting++] = (place){middle, k + 1, true};
        stack[waiting++] = (place){doubled(s->pool, c, 0), k + 1, false};
    }
}

static void check_point(search *s, int t)
{
    const bat_whole c = bat_whole_of_int(s->pool, t);
    if (value_at(s->pool, s->p, false, c, 0).sign == 0)
        keep_root(s, false, true, c, 0);
}

/* As x = 1 / t rises t falls. */
static void reverse(bat_whole_root *roots, int count)
{
    for (int i = 0; i < count / 2; i++) {
        const bat_whole_root swapped = roots[i];
        roots[i] = roots[count - 1 - i];
        roots[count - 1 - i] = swapped;
    }
}

void bat_poly_isolate(bat_wholes *pool, bat_whole_poly p, bat_whole_root *roots, int *count)
{
    search s = {pool, p, roots, 0};
    if (p.degree > 0) {
        search_unit(&s, true, -1);
        reverse(roots, s.count);
        check_point(&s, -1);
        search_unit(&s, false, -1);
        check_point(&s, 0);
        search_unit(&s, false, 0);
        check_point(&s, 1);
        const int before = s.count;
        search_unit(&s, true, 0);
        reverse(roots + before, s.count - before);
    }
    *count = s.count;
}

/* ---- one root ---- */

void bat_whole_root_middle(bat_wholes *pool, const bat_whole_root *root, bat_whole *u,
                           bat_whole *v)
{
    const bat_whole c = root->exact ? root->c : doubled(pool, root->c, 1);
    quotient_of(pool, root->inverse, c, root->exact ? root->k : root->k + 1, u, v);
}

double bat_whole_root_value(bat_wholes *pool, const bat_whole_root *root)
{
    bat_whole u, v;
    bat_whole_root_middle(pool, root, &u, &v);
    return v.sign ? bat_whole_ratio(u, v) : 0;
}

/* Take the part of the interval between (c 2^m + j) and (c 2^m + j + 1), if the root lies there
 * or exactly at its begin. */
static bool take_part(bat_wholes *pool, bat_whole_poly p, int m, int64_t j,
                      bat_whole_root *root)
{
    const bat_whole one = bat_whole_of_int(pool, 1);
    const bat_whole low =
        bat_whole_add(pool, bat_whole_shift(pool, root->c, m), bat_whole_of_int(pool, j));
    const int at_low =
        j == 0 ? root->sign : value_at(pool, p, root->inverse, low, root->k + m).sign;
    const bool is_last = j == ((int64_t)1 << m) - 1;
    const int at_high =
        is_last
            ? -root->sign
            : value_at(pool, p, root->inverse, bat_whole_add(pool, low, one), root->k + m).sign;
    if (at_low != 0 && at_low * at_high >= 0)
        return false;
    if (at_low != 0 && at_low != root->sign)
        return false;
    *root = (bat_whole_root){root->inverse, at_low == 0, low, root->k + m, root->sign};
    return true;
}

static void bisect(bat_wholes *pool, bat_whole_poly p, bat_whole_root *root)
{
    if (!take_part(pool, p, 1, 1, root)) {
        root->c = doubled(pool, root->c, 0);
        root->k++;
    }
}

/* Where the chord through the ends of the interval crosses 0: which of 2^m parts. */
static int64_t guess(bat_wholes *pool, bat_whole_poly p, int m, const bat_whole_root *root)
{
    const bat_whole end = bat_whole_add(pool, root->c, bat_whole_of_int(pool, 1));
    const bat_whole a = value_at(pool, p, root->inverse, root->c, root->k);
    const bat_whole b = value_at(pool, p, root->inverse, end, root->k);
    const double low = 0, high = ldexp(1, m) - 1;
    const bat_whole rise = bat_whole_subtract(pool, b, a);
    if (rise.sign == 0)
        return 0;
    const double part = -bat_whole_ratio(a, rise) * ldexp(1, m);
    return (int64_t)bat_max(low, bat_min(high, floor(part)));
}

void bat_poly_refine(bat_wholes *pool, bat_whole_poly p, int bits, bat_whole_root *root)
{
    for (int m = 4; !root->exact && root->k < bits && pool->effort->status == BATTEN_OK;) {
        const int64_t j = m > 1 ? guess(pool, p, m, root) : 0;
        const int64_t last = ((int64_t)1 << m) - 1;
        if (m > 1 && (take_part(pool, p, m, j, root) ||
                      (j < last && take_part(pool, p, m, j + 1, root)) ||
                      (j > 0 && take_part(pool, p, m, j - 1, root)))) {
            m = bat_min_int(2 * m, 32);
        } else {
            bisect(pool, p, root);
            m = bat_max_int(m / 2, 1) + (m == 1);
        }
    }
}

int bat_poly_sign_at(bat_wholes *pool, bat_whole_poly q, bat_whole_poly p, bat_whole_root *root)
{
    bat_whole u, v;
    if (q.degree < 0)
        return 0;
    for (int k = 0; !root->exact && q.degree > 0; k++) {
        if (pool->effort->status != BATTEN_OK)
            return 0;
        if (variations(pool, q, root->inverse, root->c, root->k) == 0)
            break;
        if (k == 2) { /* q may vanish there: then the common divisor does */
            const bat_whole_poly common = bat_poly_gcd(pool, p, q);
            if (common.degree > 0 &&
                variations(pool, common, root->inverse, root->c, root->k) % 2 != 0)
                return 0;
        }
        if (root->k >= 2 * DEPTH) {
            pool->effort->status = BATTEN_INCOMPLETE;
            return 0;
        }
        bisect(pool, p, root);
    }
    bat_whole_root_middle(pool, root, &u, &v);
    return bat_poly_value(pool, q, q.degree, u, v).sign;
}
