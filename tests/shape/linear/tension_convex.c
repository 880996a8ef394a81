/* The equations of splines in tension, and when all moments are of one sign. */
#include <batten/interpolate.h>

#include "support/test.h"

enum { N = 7 };
typedef struct data {
    double x[N], y[N], h[N], d[N];
    double a[N], b[N]; /* coefficients of the spans */
    double sigma[N];
} data;

/* a = (z coth z - 1) / (sigma^2 h) and b = (1 - z / sinh z) / (sigma^2 h), z = sigma h; in
 * series where these cancel. */
static void coefficients(double sigma, double h, double *a, double *b)
{
    const double z = sigma * h, q = z * z;
    if (z < 1e-2) {
        *a = h * (1.0 / 3 - q / 45 + 2 * q * q / 945);
        *b = h * (1.0 / 6 - 7 * q / 360 + 31 * q * q / 15120);
    } else {
        *a = h * (z / tanh(z) - 1) / q;
        *b = h * (1 - z / sinh(z)) / q;
    }
}

static void random_convex(test_random *random, data *s)
{
    double slope = -1;
    for (int i = 0; i < N; i++) {
        s->x[i] = i ? s->x[i - 1] + s->h[i - 1] : 0;
        s->y[i] = i ? s->y[i - 1] + s->h[i - 1] * s->d[i - 1] : 0;
        s->h[i] = pow(2, test_random_in(random, -1, 1));
        s->d[i] = slope;
        s->sigma[i] =
            test_random_int(random, 0, 3) ? pow(10, test_random_in(random, -3, 1)) : 0;
        slope += pow(10, test_random_in(random, -1, 0.5));
        coefficients(s->sigma[i], s->h[i], &s->a[i], &s->b[i]);
    }
}

/* c_i >= b_{i-1} c_{i-1} / D_{i-1} + b_i c_{i+1} / D_{i+1}, D_i = a_{i-1} + a_i, at all i
 * between natural ends. */
static bool is_promised(const data *s)
{
    double share[N] = {0}; /* c_i / D_i */
    for (int i = 1; i + 1 < N; i++)
        share[i] = (s->d[i] - s->d[i - 1]) / (s->a[i - 1] + s->a[i]);
    for (int i = 1; i + 1 < N; i++)
        if (s->d[i] - s->d[i - 1] < s->b[i - 1] * share[i - 1] + s->b[i] * share[i + 1])
            return false;
    return true;
}

static batten_chain *spline_of(const data *s)
{
    batten_chain_tension_options o = batten_chain_tension_defaults();
    double tensions[N];
    for (int i = 0; i < N; i++)
        tensions[i] = s->sigma[i] * s->x[N - 1] / (N - 1);
    o.parameters = BATTEN_GIVEN;
    o.given = s->x;
    o.tensions = tensions;
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_tension((batten_points){1, N, s->y}, &o, NULL, &chain));
    return chain;
}

/* The system of moments, and the slopes at both ends of each span; returns the least moment. */
static double check_moments(const data *s, const batten_chain *chain)
{
    double M[N], least = 0;
    for (int i = 0; i < N; i++) {
        double at[3];
        CHECK_OK(batten_chain_evaluate(chain, s->x[i], 2, at));
        M[i] = at[2];
        least = fmin(least, M[i]);
    }
    CHECK_NEAR(M[0], 0, 1e-10);
    CHECK_NEAR(M[N - 1], 0, 1e-10);
    for (int i = 0; i + 1 < N; i++) {
        const double a = s->a[i], b = s->b[i];
        double left[2], right[2];
        CHECK_OK(batten_chain_evaluate_side(chain, s->x[i], BATTEN_FROM_RIGHT, 1, left));
        CHECK_OK(batten_chain_evaluate_side(chain, s->x[i + 1], BATTEN_FROM_LEFT, 1, right));
        CHECK_NEAR(left[1], s->d[i] - a * M[i] - b * M[i + 1], 1e-10);
        CHECK_NEAR(right[1], s->d[i] + b * M[i] + a * M[i + 1], 1e-10);
        if (i > 0)
            CHECK_NEAR(s->b[i - 1] * M[i - 1] + (s->a[i - 1] + a) * M[i] + b * M[i + 1],
                       s->d[i] - s->d[i - 1], 1e-10);
    }
    return least;
}

TEST(moments_in_tension_obey_their_system_and_data_that_promise_it_have_one_sign)
{
    test_random random = test_random_begin("promised in tension");
    const int cases = test_cases(20000);
    int promised = 0, swinging = 0;
    for (int c = 0; c < cases; c++) {
        data s;
        random_convex(&random, &s);
        const bool convex = is_promised(&s);
        if (!convex && c % 20) /* some of those, to see that the promise says something */
            continue;
        batten_chain *chain = spline_of(&s);
        const double least = check_moments(&s, chain);
        promised += convex;
        swinging += least < -1e-3;
        if (convex)
            CHECK(least >= -1e-10);
        batten_chain_unref(chain);
    }
    CHECK(cases < 20000 || (promised > 500 && swinging > 50));
}
