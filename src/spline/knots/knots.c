/*
 * Knot vectors: validation, span search, multiplicity, periodic wrapping, reversal, mapping to
 * another domain, and B-spline basis functions with derivatives by the triangular recurrence.
 */
#include "spline/spline.h"

#include <string.h>

static batten_status check_order(int count, const double *knots, const char *what)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(knots[i]))
            return bat_fail(BATTEN_NOT_FINITE, "%s %d is %g", what, i + 1, knots[i]);
        if (i > 0 && knots[i] < knots[i - 1])
            return bat_fail(BATTEN_BAD_KNOTS, "%s %d is %.17g, below %s %d, which is %.17g",
                            what, i + 1, knots[i], what, i, knots[i - 1]);
    }
    if (!isfinite(knots[count - 1] - knots[0]))
        return bat_fail(BATTEN_BAD_KNOTS, "%s 1 is %g and %s %d is %g: too far apart", what,
                        knots[0], what, count, knots[count - 1]);
    return BATTEN_OK;
}

batten_status bat_knots_check(int degree, int count, const double *knots, const char *what)
{
    const int p = degree, knot_count = count + p + 1;
    const batten_status status = check_order(knot_count, knots, what);
    if (status != BATTEN_OK)
        return status;
    const double a = knots[p], b = knots[count];
    if (a >= b)
        return bat_fail(BATTEN_BAD_KNOTS, "the domain is empty: %s %d and %s %d are both %.17g",
                        what, p + 1, what, count + 1, a);
    for (int i = 0, times = 1; i < knot_count; i++, times++) {
        if (i > 0 && knots[i] > knots[i - 1])
            times = 1;
        const int most = knots[i] > a && knots[i] < b ? p : p + 1;
        if (times > most)
            return bat_fail(BATTEN_BAD_KNOTS,
                            "%s %d, %.17g, stands more than %d times, too often for degree %d",
                            what, i + 1, knots[i], most, p);
    }
    return BATTEN_OK;
}

/* The largest k in [low, high) with U[k] <= u (or < u when strict); low when there is none. */
static int last_at_most(const double *knots, int low, int high, double u, bool strict)
{
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (strict ? knots[middle] < u : knots[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

int bat_knots_span(int degree, int count, const double *knots, double u, batten_side side)
{
    const int p = degree, n = count;
    /* The last span is closed on the right, the first on the left. */
    const bool from_left = (side == BATTEN_FROM_LEFT && u > knots[p]) || u >= knots[n];
    return last_at_most(knots, p, n, u, from_left);
}

int bat_knots_multiplicity(int degree, int count, const double *knots, double u)
{
    const int last = last_at_most(knots, 0, count + degree + 1, u, false);
    int times = 0;
    while (last - times >= 0 && knots[last - times] == u)
        times++;
    return times;
}

int bat_knots_smoothness(int degree, int count, const double *knots, int most)
{
    int least = most;
    for (int i = degree + 1, times = 0; i < count; i++)
        if (knots[i] > knots[degree] && knots[i] < knots[count]) {
            times = knots[i] > knots[i - 1] ? 1 : times + 1;
            least = bat_min_int(least, degree - times);
        }
    return bat_max_int(0, least);
}

batten_status bat_knots_clip(double a, double b, double *u)
{
    if (*u >= a && *u <= b)
        return BATTEN_OK;
    if (!isfinite(*u))
        return bat_fail(BATTEN_NOT_FINITE, "the parameter is %g", *u);
    const double larger = bat_max(fabs(a), fabs(b));
    const double allowed = 4 * (nextafter(larger, HUGE_VAL) - larger);
    if (*u < a - allowed || *u > b + allowed)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "the parameter %.17g is outside the domain [%.17g, %.17g]", *u, a, b);
    *u = *u < a ? a : b;
    return BATTEN_OK;
}

batten_status bat_knots_check_insertion(int degree, int count, const double *knots,
                                        bool periodic, int added, const double *new_knots)
{
    const double a = knots[degree], b = knots[count];
    int above = 0; /* the first knot above u */
    for (int i = 0, times = 1; i < added; i++, times++) {
        const double u = new_knots[i];
        if (!(u >= a && u <= b))
            return bat_fail(isfinite(u) ? BATTEN_OUT_OF_DOMAIN : BATTEN_NOT_FINITE,
                            "knot %d to insert is %.17g, not in the domain [%.17g, %.17g]",
                            i + 1, u, a, b);
        if (i > 0 && u < new_knots[i - 1])
            return bat_fail(BATTEN_NOT_INCREASING,
                            "knot %d to insert is %.17g, below knot %d, which is %.17g", i + 1,
                            u, i - 1 + 1, new_knots[i - 1]);
        if (i > 0 && u > new_knots[i - 1])
            times = 1;
        int have = 0;
        while (above <= count + degree && knots[above] <= u)
            above++;
        while (have < above && knots[above - 1 - have] == u)
            have++;
        const int most = degree + (!periodic && (u == a || u == b));
        if (have + times > most)
            return bat_fail(BATTEN_BAD_KNOTS, "knot %.17g would stand %d times; %d are allowed",
                            u, have + times, most);
    }
    return BATTEN_OK;
}

void bat_knots_wrap(int degree, int m, const double *period, double *knots)
{
    const int p = degree;
    const double length = period[m] - period[0];
    memmove(knots + p, period, ((size_t)m + 1) * sizeof *period);
    /* Rounding must neither part equal knots nor join others. */
    for (int j = p + m + 1; j <= m + 2 * p; j++)
        knots[j] = knots[j - m] == knots[j - m - 1]
                       ? knots[j - 1]
                       : bat_max(nextafter(knots[j - 1], HUGE_VAL), knots[j - m] + length);
    for (int j = p - 1; j >= 0; j--)
        knots[j] = knots[j + m] == knots[j + m + 1]
                       ? knots[j + 1]
                       : bat_min(nextafter(knots[j + 1], -HUGE_VAL), knots[j + m] - length);
}

void bat_knots_reverse(int degree, int count, const double *knots, double *out)
{
    /* Negated, which is exact, so that to reverse twice gives the same bits. */
    for (int i = 0, last = count + degree; i <= last; i++)
        out[i] = -knots[last - i];
}

/* Where u stands between from and to, carried to between a and b; exact at both ends. */
static double carry(double u, double from, double to, double a, double b)
{
    if (u == from || u == to)
        return u == from ? a : b;
    const double mapped = a + (u - from) / (to - from) * (b - a);
    return u < to ? bat_min(mapped, b) : bat_max(mapped, b);
}

batten_status bat_knots_map(int degree, int count, const double *knots, double a, double b,
                            double *out)
{
    const double from = knots[degree], to = knots[count];
    if (!isfinite(a) || !isfinite(b))
        return bat_fail(BATTEN_NOT_FINITE, "the domain [%g, %g] is not finite", a, b);
    if (a >= b)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the domain [%.17g, %.17g] is empty", a, b);
    const bool same = a == from && b == to;
    for (int i = 0; i <= count + degree; i++) {
        out[i] = same ? knots[i] : carry(knots[i], from, to, a, b);
        if (i > 0 && knots[i] > knots[i - 1] && out[i] <= out[i - 1])
            return bat_fail(
                BATTEN_BAD_KNOTS,
                "knots %d and %d, %.17g and %.17g, cannot be told apart in [%.17g, %.17g]",
                i - 1 + 1, i + 1, knots[i - 1], knots[i], a, b);
    }
    return bat_knots_check(degree, count, out, "new knot");
}

/* N[0..q], degree q, on span k: the triangular recurrence without a division by an empty span.
 */
static void basis_values(int q, const double *knots, int k, double u, double *out)
{
    out[0] = 1;
    for (int r = 1; r <= q; r++) {
        double kept = 0;
        for (int j = 0; j < r; j++) {
            const double left = knots[k + 1 + j - r], right = knots[k + 1 + j];
            /* Two divisions: the reciprocal of a denormal step would be infinite. */
            const double value = out[j];
            out[j] = kept + (right - u) / (right - left) * value;
            kept = (u - left) / (right - left) * value;
        }
        out[r] = kept;
    }
}

/* From values that go with degree q - 1 on span k to derivatives that go with degree q. */
static void basis_differentiate(int q, const double *knots, int k, double *out)
{
    double before = 0;
    for (int j = 0; j <= q; j++) {
        const double here =
            j < q ? q * (out[j] / (knots[k + 1 + j] - knots[k + 1 + j - q])) : 0;
        out[j] = before - here;
        before = here;
    }
}

double bat_greville(int degree, const double *knots, int i)
{
    const double *own = knots + i + 1;
    /* From the first of them on, so that equal knots give themselves. */
    double sum = 0;
    for (int j = 1; j < degree; j++)
        sum += (own[j] - own[0]) / degree;
    return bat_min(own[0] + sum, own[degree - 1]);
}

void bat_basis(int degree, const double *knots, int span, double u, int order, double *out)
{
    const int p = degree;
    for (int m = 0; m <= order; m++) {
        double *row = out + (size_t)m * ((size_t)p + 1);
        if (m > p) {
            for (int j = 0; j <= p; j++)
                row[j] = 0;
            continue;
        }
        basis_values(p - m, knots, span, u, row);
        for (int q = p - m + 1; q <= p; q++)
            basis_differentiate(q, knots, span, row);
    }
}
