#include "support/surfaces.h"

enum { MAX_COUNT = 512 }; /* of points in one direction: far beyond what tests make */

static void fill_knots(test_random *random, batten_axis *axis, double *knots)
{
    const int p = axis->degree, n = axis->point_count;
    const int count = axis->periodic ? n + 1 : n + p + 1;
    const double scale = pow(10, test_random_in(random, -3, 3));
    double at = test_random_in(random, -5, 5) * scale;
    const bool clamped = !axis->periodic && test_random_int(random, 0, 2);
    for (int i = 0, times = 0; i < count; i++) {
        const bool must_rise = i == 0 || i == p + 1 || i == n;
        const bool at_end = clamped && (i <= p || i > n);
        const bool may_repeat = times < p && test_random_int(random, 0, 4) == 0;
        if (!must_rise && (at_end || may_repeat)) {
            times++;
        } else {
            at += i > 0 ? scale * test_random_in(random, 0.05, 1) : 0;
            times = 1;
        }
        knots[i] = at;
    }
}

void surface_data_random(test_random *random, int most, surface_data *data)
{
    int total = 1;
    data->dimension = test_random_int(random, 1, 3);
    data->rational = test_random_int(random, 0, 1);
    for (int k = 0; k < 2; k++) {
        batten_axis *axis = &data->axes[k];
        axis->degree = test_random_int(random, 1, most);
        axis->periodic = test_random_int(random, 0, 3) == 0;
        axis->point_count =
            test_random_int(random, axis->periodic ? 2 : axis->degree + 1, axis->degree + 6);
        fill_knots(random, axis, data->knots[k]);
        axis->knots = data->knots[k];
        total *= axis->point_count;
    }
    for (int i = 0; i < total * data->dimension; i++)
        data->points[i] = test_random_in(random, -10, 10);
    for (int i = 0; i < total; i++)
        data->weights[i] = test_random_in(random, 0.5, 2);
}

batten_status surface_data_create(const surface_data *data, batten_surface **out)
{
    return batten_surface_create(data->dimension, &data->axes[0], &data->axes[1], data->points,
                                 data->rational ? data->weights : NULL, out);
}

void random_knots(test_random *random, int degree, int count, double *knots)
{
    for (int i = 0; i <= degree; i++) {
        knots[i] = 0;
        knots[count + i] = 1;
    }
    for (int i = 1; i < count - degree; i++)
        knots[degree + i] = (i + 0.6 * (test_random_unit(random) - 0.5)) / (count - degree);
}

double random_parameter(test_random *random, const batten_surface *surface,
                        batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    if (test_random_int(random, 0, 3))
        return fmin(domain.a + (domain.b - domain.a) * test_random_unit(random), domain.b);
    double knots[MAX_COUNT];
    const int count = batten_surface_spans(surface, direction, knots);
    /* At the seam a periodic surface goes on from its begin; the definition does not know that.
     */
    const bool periodic = batten_surface_is_periodic(surface, direction);
    return knots[test_random_int(random, 0, count - 1 - periodic)];
}

void define_basis(int degree, int count, const double *knots, double u, int k, long double *out)
{
    const int p = degree, last = count + p;
    CHECK(last < MAX_COUNT);
    long double N[MAX_COUNT] = {0};
    int span = p;
    while (span < count - 1 && (knots[span + 1] <= u || knots[span] == knots[span + 1]))
        span++;
    while (knots[span] == knots[span + 1])
        span--;
    for (int i = 0; i < last; i++)
        N[i] = i == span;
    for (int e = 1; e <= p; e++)
        for (int i = 0; i < last - e; i++) {
            const long double low = (long double)knots[i + e] - knots[i];
            const long double high = (long double)knots[i + e + 1] - knots[i + 1];
            const long double a = low > 0 ? N[i] / low : 0, b = high > 0 ? N[i + 1] / high : 0;
            N[i] = e > p - k ? e * (a - b)
                             : ((long double)u - knots[i]) * a +
                                   (knots[i + e + 1] - (long double)u) * b;
        }
    for (int i = 0; i < count; i++)
        out[i] = k > p ? 0 : N[i];
}

void define_surface(const batten_surface *surface, double u, double v, int k, int l,
                    long double *out)
{
    const int n = batten_surface_point_count(surface, BATTEN_U);
    const int m = batten_surface_point_count(surface, BATTEN_V);
    const int d = batten_surface_dimension(surface);
    const double *P = batten_surface_points(surface), *w = batten_surface_weights(surface);
    long double Nu[MAX_COUNT], Nv[MAX_COUNT];
    define_basis(batten_surface_degree(surface, BATTEN_U), n,
                 batten_surface_knots(surface, BATTEN_U), u, k, Nu);
    define_basis(batten_surface_degree(surface, BATTEN_V), m,
                 batten_surface_knots(surface, BATTEN_V), v, l, Nv);
    for (int c = 0; c < 4; c++)
        out[c] = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const long double factor = Nu[i] * Nv[j] * (w ? w[i * m + j] : 1);
            for (int c = 0; c < d; c++)
                out[c] += factor * P[(i * m + j) * d + c];
            out[3] += factor;
        }
}

void define_point(const batten_surface *surface, double u, double v, double *out)
{
    long double h[4];
    define_surface(surface, u, v, 0, 0, h);
    for (int c = 0; c < batten_surface_dimension(surface); c++)
        out[c] = (double)(h[c] / h[3]);
}

double largest_coordinate(const batten_surface *surface)
{
    const double *P = batten_surface_points(surface);
    const int count = batten_surface_point_count(surface, BATTEN_U) *
                      batten_surface_point_count(surface, BATTEN_V) *
                      batten_surface_dimension(surface);
    double largest = 0;
    for (int i = 0; i < count; i++)
        largest = fmax(largest, fabs(P[i]));
    return largest;
}

void check_same_shape(const batten_surface *a, const batten_surface *b, double tolerance)
{
    enum { STEPS = 7 };
    batten_interval from[2], to[2];
    for (int k = 0; k < 2; k++) {
        from[k] = batten_surface_domain(a, (batten_direction)k);
        to[k] = batten_surface_domain(b, (batten_direction)k);
    }
    for (int i = 0; i <= STEPS; i++)
        for (int j = 0; j <= STEPS; j++) {
            const double s = (double)i / STEPS, t = (double)j / STEPS;
            double x[3], y[3];
            define_point(a, from[0].a + (from[0].b - from[0].a) * s,
                         from[1].a + (from[1].b - from[1].a) * t, x);
            define_point(b, to[0].a + (to[0].b - to[0].a) * s,
                         to[1].a + (to[1].b - to[1].a) * t, y);
            for (int c = 0; c < batten_surface_dimension(a); c++)
                CHECK_NEAR(y[c], x[c], tolerance);
        }
}

batten_status test_surface_area(const batten_surface *surface, double precision, double *area,
                                double *error)
{
    batten_area_measures found = {*area, error ? *error : 0};
    const batten_status status = batten_surface_area(surface, precision, NULL, &found);
    *area = found.area;
    if (error)
        *error = found.error;
    return status;
}
