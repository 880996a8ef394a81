/*
 * Polynomials with whole coefficients: arithmetic, the greatest common divisor by
 * subresultants, and Yun's square-free factors. Source: [Knuth97] 4.6.1 and 4.6.2.
 */
#include "numeric/whole_polynomial.h"

/* ---- sums and products ---- */

static const bat_whole_poly none = {-1, NULL};

bat_whole_poly bat_poly_make(bat_wholes *pool, int degree)
{
    bat_whole *c = bat_wholes_take(pool, (size_t)bat_max_int(degree + 1, 1), sizeof *c);
    return c ? (bat_whole_poly){degree, c} : none;
}

bat_whole_poly bat_poly_trim(bat_whole_poly p)
{
    while (p.degree >= 0 && p.c[p.degree].sign == 0)
        p.degree--;
    return p;
}

bat_whole_poly bat_poly_copy(bat_wholes *pool, bat_whole_poly p)
{
    bat_whole_poly copy = bat_poly_make(pool, p.degree);
    for (int i = 0; i <= copy.degree; i++)
        copy.c[i] = bat_whole_copy(pool, p.c[i]);
    return bat_poly_trim(copy);
}

bat_whole_poly bat_poly_constant(bat_wholes *pool, int64_t value)
{
    bat_whole_poly p = bat_poly_make(pool, 0);
    if (p.degree == 0)
        p.c[0] = bat_whole_of_int(pool, value);
    return bat_poly_trim(p);
}

bat_whole_poly bat_poly_derivative(bat_wholes *pool, bat_whole_poly p)
{
    bat_whole_poly d = bat_poly_make(pool, p.degree - 1);
    for (int i = 0; i <= d.degree; i++)
        d.c[i] = bat_whole_times(pool, p.c[i + 1], i + 1);
    return bat_poly_trim(d);
}

bat_whole_poly bat_poly_combine(bat_wholes *pool, int64_t a, bat_whole_poly p, int64_t b,
                                bat_whole_poly q)
{
    bat_whole_poly sum = bat_poly_make(pool, bat_max_int(p.degree, q.degree));
    for (int i = 0; i <= sum.degree; i++) {
        if (i <= p.degree)
            sum.c[i] = bat_whole_times(pool, p.c[i], a);
        if (i <= q.degree)
            sum.c[i] = bat_whole_add(pool, sum.c[i], bat_whole_times(pool, q.c[i], b));
    }
    return bat_poly_trim(sum);
}

bat_whole_poly bat_poly_multiply(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    if (p.degree < 0 || q.degree < 0)
        return none;
    bat_whole_poly product = bat_poly_make(pool, p.degree + q.degree);
    for (int i = 0; i <= p.degree && product.degree >= 0; i++)
        for (int j = 0; j <= q.degree; j++)
            product.c[i + j] =
                bat_whole_add(pool, product.c[i + j], bat_whole_multiply(pool, p.c[i], q.c[j]));
    return bat_poly_trim(product);
}

bat_whole bat_poly_value(bat_wholes *pool, bat_whole_poly p, int degree, bat_whole u,
                         bat_whole v)
{
    bat_whole value = {0, 0, NULL}, power = bat_whole_of_int(pool, 1);
    for (int i = p.degree; i < degree; i++)
        power = bat_whole_multiply(pool, power, v);
    for (int i = p.degree; i >= 0; i--) {
        value = bat_whole_add(pool, bat_whole_multiply(pool, value, u),
                              bat_whole_multiply(pool, p.c[i], power));
        power = bat_whole_multiply(pool, power, v);
    }
    return value;
}

/* ---- quotients ---- */

bat_whole_poly bat_poly_quotient(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    if (p.degree < q.degree || q.degree < 0)
        return none;
    bat_whole_poly rest = bat_poly_copy(pool, p);
    bat_whole_poly quotient = bat_poly_make(pool, p.degree - q.degree);
    for (int i = quotient.degree; i >= 0 && rest.degree >= 0; i--) {
        const bat_whole f = bat_whole_divide(pool, rest.c[i + q.degree], q.c[q.degree], NULL);
        quotient.c[i] = f;
        for (int j = 0; j <= q.degree; j++)
            rest.c[i + j] =
                bat_whole_subtract(pool, rest.c[i + j], bat_whole_multiply(pool, f, q.c[j]));
    }
    return bat_poly_trim(quotient);
}

static bat_whole_poly divided(bat_wholes *pool, bat_whole_poly p, bat_whole by)
{
    for (int i = 0; i <= p.degree; i++)
        p.c[i] = bat_whole_divide(pool, p.c[i], by, NULL);
    return bat_poly_trim(p);
}

bat_whole_poly bat_poly_primitive(bat_wholes *pool, bat_whole_poly p)
{
    bat_whole content = {0, 0, NULL};
    for (int i = 0; i <= p.degree; i++)
        content = bat_whole_gcd(pool, content, p.c[i]);
    if (p.degree >= 0 && p.c[p.degree].sign < 0)
        content = bat_whole_negated(content);
    return content.sign ? divided(pool, bat_poly_copy(pool, p), content) : none;
}

/* What is left of lc(q)^(m + 1) p after division by q, m the difference of the degrees. */
static bat_whole_poly pseudo_rest(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    bat_whole_poly rest = bat_poly_copy(pool, p);
    const bat_whole lead = q.c[q.degree];
    for (int i = p.degree - q.degree; i >= 0 && rest.degree >= 0; i--) {
        const bat_whole f = rest.c[i + q.degree];
        for (int j = 0; j <= p.degree; j++)
            rest.c[j] = bat_whole_multiply(pool, rest.c[j], lead);
        for (int j = 0; j <= q.degree; j++)
            rest.c[i + j] =
                bat_whole_subtract(pool, rest.c[i + j], bat_whole_multiply(pool, f, q.c[j]));
    }
    return bat_poly_trim(rest);
}

/* ---- modulo a prime ---- */

static uint32_t power_modulo(uint32_t a, uint32_t e, uint32_t p)
{
    uint64_t result = 1, base = a;
    for (; e; e >>= 1, base = base * base % p)
        if (e & 1)
            result = result * base % p;
    return (uint32_t)result;
}

/* a loses its multiple of b; the degree of what is left */
static int reduce_modulo(uint32_t *a, int m, const uint32_t *b, int n, uint32_t p)
{
    const uint64_t inverse = power_modulo(b[n], p - 2, p);
    for (int i = m; i >= n; i--) {
        const uint64_t f = a[i] * inverse % p;
        for (int j = 0; j <= n; j++)
            a[i - n + j] = (uint32_t)((a[i - n + j] + (p - f) * b[j]) % p);
    }
    m = bat_min_int(m, n - 1);
    while (m >= 0 && a[m] == 0)
        m--;
    return m;
}

static uint32_t *modulo(bat_wholes *pool, bat_whole_poly p, uint32_t prime)
{
    uint32_t *c = bat_wholes_take(pool, (size_t)p.degree + 1, sizeof *c);
    for (int i = 0; c && i <= p.degree; i++)
        c[i] = bat_whole_modulo(p.c[i], prime);
    return c;
}

/* True proves that p and q have no common root: their images modulo a prime, of the same
 * degrees, have none. */
static bool are_coprime(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    static const uint32_t primes[] = {2147483647u, 2147483629u, 2147483587u};
    for (int k = 0; k < 3; k++) {
        uint32_t *a = modulo(pool, p, primes[k]), *b = modulo(pool, q, primes[k]);
        int m = p.degree, n = q.degree;
        if (!a || !b)
            return false;
        if (a[m] == 0 || b[n] == 0)
            continue;
        while (n > 0) {
            m = reduce_modulo(a, m, b, n, primes[k]);
            uint32_t *const rest = a;
            const int left = m;
            a = b;
            m = n;
            b = rest;
            n = left;
        }
        if (n == 0)
            return true;
    }
    return false;
}

/* ---- common divisors ---- */

static bat_whole power(bat_wholes *pool, bat_whole a, int e)
{
    bat_whole product = bat_whole_of_int(pool, 1);
    for (; e > 0; e--)
        product = bat_whole_multiply(pool, product, a);
    return product;
}

/* p.degree >= q.degree >= 0; everything in one pool, which the caller gives back */
static bat_whole_poly by_subresultants(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    bat_whole g = bat_whole_of_int(pool, 1), h = g;
    while (q.degree > 0) {
        const int m = p.degree - q.degree;
        const bat_whole_poly rest = pseudo_rest(pool, p, q);
        p = q;
        q = divided(pool, rest, bat_whole_multiply(pool, g, power(pool, h, m)));
        if (pool->effort->status != BATTEN_OK)
            return none;
        g = p.c[p.degree];
        if (m > 0)
            h = bat_whole_divide(pool, power(pool, g, m), power(pool, h, m - 1), NULL);
    }
    return q.degree == 0 ? bat_poly_constant(pool, 1) : p;
}

static bat_whole_poly primitive_gcd(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    const bat_whole_poly a = bat_poly_primitive(pool, p.degree < q.degree ? q : p);
    const bat_whole_poly b = bat_poly_primitive(pool, p.degree < q.degree ? p : q);
    return bat_poly_primitive(pool, by_subresultants(pool, a, b));
}

bat_whole_poly bat_poly_gcd(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q)
{
    if (p.degree < 0 || q.degree < 0)
        return bat_poly_primitive(pool, p.degree < 0 ? q : p);
    bat_wholes scratch = {pool->effort, NULL, NULL, 0};
    bat_whole_poly common;
    if (p.degree == 0 || q.degree == 0 || are_coprime(&scratch, p, q))
        common = bat_poly_constant(pool, 1);
    else
        common = bat_poly_copy(pool, primitive_gcd(&scratch, p, q));
    bat_wholes_release(&scratch);
    return common;
}

int bat_poly_squarefree(bat_wholes *pool, bat_whole_poly p, bat_whole_poly *parts)
{
    const bat_whole_poly slope = bat_poly_derivative(pool, p);
    const bat_whole_poly common = bat_poly_gcd(pool, p, slope);
    bat_whole_poly w = bat_poly_quotient(pool, p, common);
    bat_whole_poly y = bat_poly_quotient(pool, slope, common);
    int highest = 0;
    while (w.degree > 0) {
        const bat_whole_poly z = bat_poly_combine(pool, 1, y, -1, bat_poly_derivative(pool, w));
        parts[++highest] = bat_poly_gcd(pool, w, z);
        y = bat_poly_quotient(pool, z, parts[highest]);
        w = bat_poly_quotient(pool, w, parts[highest]);
    }
    return highest;
}
