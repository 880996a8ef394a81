/*
 * Generalised Fresnel integrals, the moments of cos and sin of a polynomial, by Gauss-Legendre
 * quadrature. A bound on the integrand in the complex plane says how many panels are needed.
 */
#include "numeric/fresnel.h"

/* Gauss-Legendre with 8 and 16 nodes on [-1, 1]: the positive nodes and their weights. */
static const double nodes8[4] = {0.1834346424956498, 0.52553240991632899, 0.79666647741362674,
                                 0.96028985649753623};
static const double weights8[4] = {0.36268378337836198, 0.31370664587788729,
                                   0.22238103445337447, 0.10122853629037626};
static const double nodes16[8] = {0.09501250983763744, 0.28160355077925891, 0.45801677765722739,
                                  0.61787624440264375, 0.75540440835500303, 0.86563120238783174,
                                  0.94457502307323258, 0.98940093499164993};
static const double weights16[8] = {
    0.1894506104550685,  0.18260341504492359,  0.16915651939500254,  0.14959598881657673,
    0.12462897125553387, 0.095158511682492785, 0.062253523938647893, 0.027152459411754095};

enum { DEGREE = BAT_FRESNEL_DEGREE, MOMENTS = BAT_FRESNEL_MOMENTS };

/*
 * On the ellipse about [-1, 1] with the half axes (r +- 1 / r) / 2 the integrand exp(i theta)
 * is at most exp(G), G = sum |a[k]| R^k with R = (r + 1 / r) / 2, a the coefficients of theta
 * there; Gauss with n nodes then errs by about 64 / 15 exp(G) r^(-2 n). So 8 nodes are as good
 * as exact for G <= 9 at r = 16, and 16 nodes for G <= 20 at r = 6.
 */
static const double radius8 = 8.03125, growth8 = 9;
static const double radius16 = 37.0 / 12, growth16 = 20;

/* The coefficients about t = 1/2, the constant one left out. */
static void centre(const double c[DEGREE + 1], double out[DEGREE + 1])
{
    out[0] = 0;
    out[1] = c[1] + c[2] + 0.75 * c[3] + 0.5 * c[4];
    out[2] = c[2] + 1.5 * c[3] + 1.5 * c[4];
    out[3] = c[3] + 2 * c[4];
    out[4] = c[4];
}

/* Bounds of the coefficients about any point of [0, 1], from those about its middle. */
static void bound(const double a[DEGREE + 1], double out[DEGREE + 1])
{
    out[1] = fabs(a[1]) + fabs(a[2]) + 0.75 * fabs(a[3]) + 0.5 * fabs(a[4]);
    out[2] = fabs(a[2]) + 1.5 * fabs(a[3]) + 1.5 * fabs(a[4]);
    out[3] = fabs(a[3]) + 2 * fabs(a[4]);
    out[4] = fabs(a[4]);
}

/* G of a panel of half width h. */
static double growth(const double a[DEGREE + 1], double h, double radius)
{
    const double z = h * radius;
    return z * (fabs(a[1]) + z * (fabs(a[2]) + z * (fabs(a[3]) + z * fabs(a[4]))));
}

/* How many panels of 16 nodes: each of the four terms of G stays below a quarter. */
static int panels(const double a[DEGREE + 1])
{
    if (growth(a, 0.5, radius16) <= growth16)
        return 1;
    double b[DEGREE + 1];
    bound(a, b);
    const double each = growth16 / DEGREE;
    const double z = bat_max(bat_max(b[1] / each, sqrt(b[2] / each)),
                             bat_max(bat_cbrt(b[3] / each), sqrt(sqrt(b[4] / each))));
    return bat_max_int(2, (int)ceil(z * radius16 / 2));
}

typedef struct {
    int count; /* positive nodes */
    const double *nodes, *weights;
} rule;

static void add_node(const double c[DEGREE + 1], double t, double weight, int moments,
                     double *x, double *y)
{
    const double theta = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
    double u, v;
    bat_sincos(theta, &v, &u);
    u *= weight;
    v *= weight;
    for (int j = 0; j < moments; j++, u *= t, v *= t) {
        x[j] += u;
        y[j] += v;
    }
}

void bat_fresnel(const double c[DEGREE + 1], int moments, double *x, double *y)
{
    double a[DEGREE + 1];
    assert(moments >= 1 && moments <= MOMENTS);
    centre(c, a);
    const bool few = growth(a, 0.5, radius8) <= growth8;
    const rule r = few ? (rule){4, nodes8, weights8} : (rule){8, nodes16, weights16};
    const int count = few ? 1 : panels(a);
    const double h = 0.5 / count;
    for (int j = 0; j < moments; j++)
        x[j] = y[j] = 0;
    for (int p = 0; p < count; p++) {
        const double middle = (2 * p + 1) * h;
        for (int i = 0; i < r.count; i++) {
            add_node(c, middle - h * r.nodes[i], h * r.weights[i], moments, x, y);
            add_node(c, middle + h * r.nodes[i], h * r.weights[i], moments, x, y);
        }
    }
}
