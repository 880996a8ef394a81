/* One span of curvature cubic in arc length, seen from its ends. */
#include "numeric/fresnel.h"
#include "shape/bent/spiro.h"

enum { N = BAT_SPIRO_UNKNOWNS };

/* Of the derivatives of theta by t of orders 1 to 3: what each unknown counts at t = 0 and 1.
 */
static const double powers[2][4][N] = {
    {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 6, 0}},
    {{1, 1, 1, 1}, {1, 2, 3, 4}, {0, 2, 6, 12}, {0, 0, 6, 24}}};

/* The integrals over t of t^j cos(theta) and t^j sin(theta), theta measured from the chord: y
 * [0] is 0. The angle at the start. */
static double moments(const double *c, double x[N + 1], double y[N + 1])
{
    const double theta[BAT_FRESNEL_DEGREE + 1] = {0, c[0], c[1], c[2], c[3]};
    double u[N + 1], v[N + 1];
    bat_fresnel(theta, N + 1, u, v);
    const double r = bat_hypot(u[0], v[0]), cosine = u[0] / r, sine = -v[0] / r;
    for (int j = 0; j <= N; j++) {
        x[j] = cosine * u[j] - sine * v[j];
        y[j] = sine * u[j] + cosine * v[j];
    }
    return -bat_atan2(v[0], u[0]);
}

void bat_spiro_span_at(const double *c, double chord, bat_spiro_span *out)
{
    double x[N + 1], y[N + 1], scale = 1;
    const double start = moments(c, x, y);
    out->chord = x[0];
    for (int order = 0; order < 4; order++, scale *= x[0] / chord)
        for (int e = 0; e < 2; e++) {
            double sum = 0;
            for (int m = 0; m < N; m++)
                sum += powers[e][order][m] * c[m];
            out->value[e][order] = order == 0 ? start + sum : sum * scale;
            for (int m = 0; m < N; m++) {
                /* How the angle at the start and the chord follow the unknown. */
                const double turn = -x[m + 1] / x[0], shrink = -y[m + 1] / x[0];
                out->by[e][order][m] =
                    order == 0 ? powers[e][0][m] + turn
                               : scale * (powers[e][order][m] + order * sum * shrink);
            }
        }
}

/* The integral over [0, 1] of the square of the polynomial a[0] + ... + a[count - 1] t^.. */
static double square_integral(int count, const double *a)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++)
            sum += a[i] * a[j] / (i + j + 1);
    return sum;
}

void bat_spiro_span_energies(const double *c, const bat_spiro_span *span, double chord,
                             double *bending, double *variation)
{
    const double k[4] = {c[0], 2 * c[1], 3 * c[2], 4 * c[3]},
                 rate[3] = {k[1], 2 * k[2], 3 * k[3]};
    const double scale = span->chord / chord;
    *bending = scale * square_integral(4, k);
    *variation = scale * scale * scale * square_integral(3, rate);
}
