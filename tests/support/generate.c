#include "support/generate.h"

static bool chosen(test_random *random, test_choice choice, double likely)
{
    return choice == TEST_EITHER ? test_random_unit(random) < likely : choice == TEST_ALWAYS;
}

/* 10^x, x in [-9, 9), by multiplication: no pow, whose last bit differs between machines. */
static double any_size(test_random *random)
{
    double size = test_random_in(random, 1, 10);
    for (int exponent = test_random_int(random, -9, 8); exponent != 0;) {
        size = exponent > 0 ? size * 10 : size / 10;
        exponent += exponent > 0 ? -1 : 1;
    }
    return size;
}

int test_degree(test_random *random, const test_wish *wish)
{
    if (wish->degree > 0)
        return wish->degree;
    return test_random_int(random, 0, 9) < 8 ? test_random_int(random, 1, 5)
                                             : test_random_int(random, 1, BATTEN_MAX_DEGREE);
}

int test_point_count(test_random *random, const test_wish *wish, int degree)
{
    const int more = test_random_int(random, 0, 3) ? test_random_int(random, 0, 29) : 0;
    const int count = degree + 1 + more;
    return wish->most_points > degree && wish->most_points < count ? wish->most_points : count;
}

/* A step from one distinct knot to the next, as a share of the domain. */
static double step(test_random *random, const test_wish *wish)
{
    if (!wish->tame && test_random_unit(random) < 0.1) {
        double gap = 1e-9;
        for (int i = test_random_int(random, 0, 7); i > 0; i--)
            gap /= 10;
        return gap;
    }
    return test_random_in(random, 0.2, 1);
}

/* Steps, some of them 0, so that nothing stands too often. */
static void steps_to_knots(test_random *random, const test_wish *wish, int p, int n,
                           bool clamped, double *knots)
{
    int times = 1;
    knots[0] = 0;
    for (int i = 1; i <= n + p; i++) {
        const bool must = i > p && i <= n && times >= p;
        const bool end = clamped && (i <= p || i > n);
        bool equal = end || (!must && test_random_unit(random) < 0.2);
        if (clamped && i == p + 1)
            equal = false;
        if (clamped && i == n && n > p + 1)
            equal = false;
        if (!clamped && times >= p)
            equal = false;
        knots[i] = knots[i - 1] + (equal ? 0 : step(random, wish));
        times = knots[i] == knots[i - 1] ? times + 1 : 1;
        if (times > p && !end) { /* a near-equal step was lost to rounding */
            knots[i] = knots[i - 1] + 0.5;
            times = 1;
        }
    }
}

void test_knots(test_random *random, const test_wish *wish, int degree, int count,
                double *knots)
{
    const int p = degree, n = count;
    double raw[TEST_MOST_POINTS + 26];
    const bool clamped = chosen(random, wish->clamped, 0.8);
    const double scale = wish->tame ? 1 : any_size(random);
    const double shift = wish->tame ? 0 : test_random_int(random, -1, 1) * scale * (n + p);
    do {
        steps_to_knots(random, wish, p, n, clamped, raw);
        for (int i = 0; i <= n + p; i++)
            knots[i] = shift + scale * raw[i];
        for (int i = 0, times = 1; i <= n + p;
             i++, times++) { /* scaling may join near-equal ones */
            if (i > 0 && knots[i] > knots[i - 1])
                times = 1;
            if (times > (knots[i] > knots[p] && knots[i] < knots[n] ? p : p + 1))
                knots[p] = knots[n];
        }
    } while (!(knots[p] < knots[n]));
}

void test_points(test_random *random, const test_wish *wish, size_t count, int dimension,
                 double *points)
{
    const size_t d = (size_t)dimension;
    const double size = wish->tame ? 1 : any_size(random);
    const double shift = !wish->tame && test_random_int(random, 0, 4) == 0 ? 100 * size : 0;
    for (size_t i = 0; i < count; i++) {
        const bool collapsed = i > 0 && !wish->tame && test_random_unit(random) < 0.1;
        for (size_t k = 0; k < d; k++)
            points[i * d + k] = collapsed ? points[(i - 1) * d + k]
                                          : shift + size * test_random_in(random, -1, 1);
    }
}

void test_weights(test_random *random, size_t count, double *weights)
{
    for (size_t i = 0; i < count; i++)
        weights[i] = test_random_int(random, 0, 2) ? test_random_in(random, 0.5, 2)
                                                   : test_random_in(random, 0.1, 10);
}

static int wished_dimension(test_random *random, const test_wish *wish)
{
    return wish->dimension ? wish->dimension : test_random_int(random, 1, 3);
}

batten_curve *test_curve(test_random *random, const test_wish *wish)
{
    const int d = wished_dimension(random, wish), p = test_degree(random, wish);
    const int n = test_point_count(random, wish, p);
    double knots[TEST_MOST_POINTS + 26], points[TEST_MOST_POINTS * 3],
        weights[TEST_MOST_POINTS];
    const bool rational = chosen(random, wish->rational, 0.4);
    test_knots(random, wish, p, n, knots);
    test_points(random, wish, (size_t)n, d, points);
    test_weights(random, (size_t)n, weights);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){d, n, points}, p, rational ? weights : NULL,
                                 knots, &curve));
    return curve;
}

batten_curve *test_periodic_curve(test_random *random, const test_wish *wish)
{
    const int d = wished_dimension(random, wish), p = test_degree(random, wish);
    const int m = test_random_int(random, 1, wish->most_points ? wish->most_points : 20);
    double knots[TEST_MOST_POINTS + 1] = {0}, points[TEST_MOST_POINTS * 3],
                                    weights[TEST_MOST_POINTS];
    const bool rational = chosen(random, wish->rational, 0.4);
    /* Multiples of 2^-40 of a power of two: knots beyond the period are exact, else near-equal
     * ones would not stay in proportion and the shape would differ from period to period. */
    const double scale = wish->tame ? 1 : ldexp(1, test_random_int(random, -30, 30));
    for (int i = 1, times = 1; i <= m; i++) {
        /* The last step is never 0, so that the seam does not gather the knots of both ends. */
        const bool equal = times < p && i < m && test_random_unit(random) < 0.2;
        const double steps = fmax(1, floor(0x1p40 * step(random, wish)));
        knots[i] = knots[i - 1] + (equal ? 0 : scale * 0x1p-40 * steps);
        times = equal ? times + 1 : 1;
    }
    test_points(random, wish, (size_t)m, d, points);
    test_weights(random, (size_t)m, weights);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create_periodic((batten_points){d, m, points}, p,
                                          rational ? weights : NULL, knots, &curve));
    return curve;
}

double test_curve_size(const batten_curve *curve)
{
    const int count = batten_curve_point_count(curve) * batten_curve_dimension(curve);
    const double *points = batten_curve_points(curve);
    double size = 0;
    for (int i = 0; i < count; i++)
        size = fmax(size, fabs(points[i]));
    return size;
}

double test_parameter(test_random *random, const batten_curve *curve)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double *knots = batten_curve_knots(curve) + batten_curve_degree(curve);
    const int last = batten_curve_point_count(curve) - batten_curve_degree(curve);
    const double knot = knots[test_random_int(random, 0, last)];
    switch (test_random_int(random, 0, 5)) {
    case 0:
        return knot;
    case 1:
        return fmin(
            fmax(nextafter(knot, test_random_int(random, 0, 1) ? 1e300 : -1e300), domain.a),
            domain.b);
    default:
        return fmin(domain.a + test_random_unit(random) * (domain.b - domain.a), domain.b);
    }
}

double test_curve_distance(const batten_curve *a, double at_a, const batten_curve *b,
                           double at_b, double size)
{
    double p[3] = {0}, q[3] = {0}, distance = 0;
    CHECK_OK(batten_curve_evaluate(a, at_a, 0, p));
    CHECK_OK(batten_curve_evaluate(b, at_b, 0, q));
    for (int k = 0; k < 3; k++)
        distance = fmax(distance, fabs(p[k] - q[k]));
    return size > 0 ? distance / size : distance;
}
