#include "numeric/fresnel.h"

#include "numeric/quadrature.h"
#include "support/test.h"

typedef struct {
    const double *c;
    int moment;
    bool sine;
} wave;

static batten_status wave_at(void *context, double t, double *value)
{
    const wave *w = context;
    const double theta = w->c[0] + t * (w->c[1] + t * (w->c[2] + t * (w->c[3] + t * w->c[4])));
    *value = pow(t, w->moment) * (w->sine ? sin(theta) : cos(theta));
    return BATTEN_OK;
}

/* Every moment against adaptive quadrature. */
static void check_moments(const double c[5], double tolerance)
{
    double x[3], y[3];
    bat_fresnel(c, 3, x, y);
    for (int j = 0; j < 3; j++)
        for (int sine = 0; sine < 2; sine++) {
            wave w = {c, j, sine};
            double value = 0, error = 0;
            /* A wave of many turns: halved until each part turns by a radian or two. */
            const int parts = 256;
            for (int k = 0; k < parts; k++) {
                double part = 0;
                CHECK_OK(bat_integrate(wave_at, &w, (double)k / parts, (double)(k + 1) / parts,
                                       1e-15, 100000, &part, &error));
                value += part;
            }
            CHECK_NEAR(sine ? y[j] : x[j], value, tolerance);
        }
}

TEST(moments_of_turning_directions_agree_with_adaptive_quadrature)
{
    test_random random = test_random_begin("fresnel");
    const double sizes[] = {1e-3, 0.3, 1, 3, 10, 40};
    for (int n = 0; n < test_cases(60); n++) {
        double c[5];
        for (int k = 0; k < 5; k++)
            c[k] = test_random_in(&random, -1, 1) * sizes[n % COUNT(sizes)];
        check_moments(c, 1e-13);
    }
}

TEST(the_integrals_of_fresnel_have_their_published_values)
{
    /* C(x) and S(x) with pi t^2 / 2 [DLMF, tables]: x = 1, 2, 5. */
    const double at[] = {1, 2, 5};
    const double C[] = {0.7798934003768228, 0.4882534060753408, 0.5636311887040122};
    const double S[] = {0.4382591473903548, 0.3434156783636982, 0.4991913819171169};
    for (int k = 0; k < COUNT(at); k++) {
        double x = 0, y = 0;
        const double c[5] = {0, 0, 2 * atan(1) * at[k] * at[k], 0, 0};
        bat_fresnel(c, 1, &x, &y);
        CHECK_NEAR(at[k] * x, C[k], 2e-15 * at[k]);
        CHECK_NEAR(at[k] * y, S[k], 2e-15 * at[k]);
    }
}

TEST(small_angles_keep_their_relative_precision)
{
    const double c[5] = {1e-9, 2e-9, -3e-9, 4e-9, -5e-9};
    double x[3], y[3];
    bat_fresnel(c, 3, x, y);
    for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int k = 0; k < 5; k++)
            sum += c[k] / (k + j + 1);
        CHECK_NEAR(y[j] / sum, 1, 1e-14);
        CHECK_NEAR(x[j] * (j + 1), 1, 4 * DBL_EPSILON);
    }
}

TEST(phases_of_each_power_about_the_middle_are_resolved)
{
    /* a3 s^3 + a4 s^4 with s = t - 1/2, of any proportion, from one node rule to the next. */
    const double shares[][2] = {{1, 0}, {0, 1}, {4, 1}, {-4, 1}, {1, -4}, {2, 1}};
    for (int i = 0; i < COUNT(shares); i++)
        for (double size = 8; size < 6000; size *= 3) {
            const double a3 = shares[i][0] * size / 4, a4 = shares[i][1] * size / 4;
            const double c[5] = {-a3 / 8 + a4 / 16, 0.75 * a3 - a4 / 2, -1.5 * a3 + 1.5 * a4,
                                 a3 - 2 * a4, a4};
            check_moments(c, 1e-12);
        }
}

TEST(phases_of_each_power_alone_are_resolved)
{
    for (int k = 1; k <= 4; k++)
        for (double size = 8; size < 600; size *= 2.5) {
            double c[5] = {0.3};
            c[k] = k % 2 ? size : -size;
            check_moments(c, 1e-12);
        }
}
