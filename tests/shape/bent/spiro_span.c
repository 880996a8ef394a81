/* A span of cubic curvature seen from its ends, against Simpson's rule and differences. */
#include "shape/bent/spiro.h"
#include "support/test.h"

enum { N = BAT_SPIRO_UNKNOWNS };

/* theta = c[0] t + c[1] t^2 + c[2] t^3 + c[3] t^4 */
static const double rows[][N] = {
    {0, 0, 0, 0},      {0.8, 0, 0, 0},      {-1.5, 0, 0, 0},
    {0.3, -0.7, 0, 0}, {0.2, 0.5, -0.9, 0}, {1, -2, 0.4, 0.7},
    {-0.6, 0, 0, 1.1}, {0, 0, 2, -1.3},     {2.5, -0.1, 0.2, 0.3},
};
static const double chord = 2.5;

/* The derivative of theta of this order at t. */
static double theta(const double *c, int order, double t)
{
    double sum = 0;
    for (int m = 0; m < N; m++) {
        double factor = c[m], power = 1;
        for (int k = 0; k < order; k++)
            factor *= m + 1 - k;
        for (int k = order; k < m + 1; k++)
            power *= t;
        sum += factor * (m + 1 >= order ? power : 0);
    }
    return sum;
}

typedef double (*integrand)(const double *c, double t);

static double cosine(const double *c, double t)
{
    return cos(theta(c, 0, t));
}

static double sine(const double *c, double t)
{
    return sin(theta(c, 0, t));
}

static double bend_squared(const double *c, double t)
{
    return theta(c, 1, t) * theta(c, 1, t);
}

static double rate_squared(const double *c, double t)
{
    return theta(c, 2, t) * theta(c, 2, t);
}

static double simpson(integrand f, const double *c)
{
    enum { STEPS = 400 };
    double sum = f(c, 0) + f(c, 1);
    for (int i = 1; i < STEPS; i++)
        sum += (i % 2 ? 4 : 2) * f(c, (double)i / STEPS);
    return sum / (3 * STEPS);
}

TEST(a_span_of_spiro_has_the_angles_and_curvatures_of_its_polynomial)
{
    for (int r = 0; r < COUNT(rows); r++) {
        bat_spiro_span at;
        bat_spiro_span_at(rows[r], chord, &at);
        const double u = simpson(cosine, rows[r]), v = simpson(sine, rows[r]);
        const double length = chord / hypot(u, v);
        CHECK_NEAR(at.chord, hypot(u, v), 1e-10);
        for (int e = 0; e < 2; e++) {
            CHECK_NEAR(at.value[e][0], theta(rows[r], 0, e) - atan2(v, u), 1e-9);
            for (int order = 1; order < 4; order++)
                CHECK_NEAR(at.value[e][order], theta(rows[r], order, e) / pow(length, order),
                           1e-9);
        }
    }
}

TEST(derivatives_of_a_span_of_spiro_are_limits_of_differences)
{
    const double h = 1e-5;
    for (int r = 0; r < COUNT(rows); r++)
        for (int m = 0; m < N; m++) {
            bat_spiro_span at, less, more;
            double c[N];
            memcpy(c, rows[r], sizeof c);
            bat_spiro_span_at(c, chord, &at);
            c[m] = rows[r][m] - h;
            bat_spiro_span_at(c, chord, &less);
            c[m] = rows[r][m] + h;
            bat_spiro_span_at(c, chord, &more);
            for (int e = 0; e < 2; e++)
                for (int order = 0; order < 4; order++)
                    CHECK_NEAR(at.by[e][order][m],
                               (more.value[e][order] - less.value[e][order]) / (2 * h), 1e-8);
        }
}

TEST(energies_of_a_span_of_spiro_are_integrals_over_its_length)
{
    for (int r = 0; r < COUNT(rows); r++) {
        bat_spiro_span at;
        double bending, variation;
        bat_spiro_span_at(rows[r], chord, &at);
        bat_spiro_span_energies(rows[r], &at, chord, &bending, &variation);
        const double length = chord / at.chord;
        CHECK_NEAR(bending, simpson(bend_squared, rows[r]) / length, 1e-8);
        CHECK_NEAR(variation, simpson(rate_squared, rows[r]) / (length * length * length),
                   1e-7);
    }
    /* An arc: the square of the curvature times its length, which does not vary. */
    bat_spiro_span arc;
    double bending, variation;
    bat_spiro_span_at(rows[1], chord, &arc);
    bat_spiro_span_energies(rows[1], &arc, chord, &bending, &variation);
    const double radius = chord / 2 / sin(0.4);
    CHECK_NEAR(arc.value[0][0], -0.4, 1e-15);
    CHECK_NEAR(arc.value[1][0], 0.4, 1e-15);
    CHECK_NEAR(arc.value[0][1], 1 / radius, 1e-15);
    CHECK_NEAR(bending, 0.8 / radius, 1e-15);
    CHECK(variation == 0);
}
