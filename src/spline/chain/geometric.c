/*
 * Curves whose curvature is linear in the abscissa x along their chord, a + b x: the beam bent
 * by a moment that is linear along the chord, however large its slope.
 *
 * The sine of the angle from the chord is then the integral u = sine + a x + b x^2 / 2, and the
 * rise that of u / sqrt(1 - u^2).
 */
#include "spline/chain/chain.h"

/* Gauss with 16 nodes: those above 0, and their weights. */
enum { HALF = 8, MAX_PANELS = 1000 };
static const double nodes[HALF] = {0.095012509837637440185, 0.28160355077925891323,
                                   0.45801677765722738634,  0.61787624440264374845,
                                   0.75540440835500303390,  0.86563120238783174388,
                                   0.94457502307323257608,  0.98940093499164993260};
static const double weights[HALF] = {0.18945061045506849629,  0.18260341504492358887,
                                     0.16915651939500253819,  0.14959598881657673208,
                                     0.12462897125553387205,  0.095158511682492784810,
                                     0.062253523938647892863, 0.027152459411754094852};

typedef struct {
    double sine, a, b;
    double roots[4][2]; /* where u is 1 or -1: real and imaginary part */
    int count;
} sine_curve;

/* The roots of u = value. */
static void add_roots(sine_curve *c, double value)
{
    const double rest = c->sine - value;
    const double square = c->a * c->a - 2 * c->b * rest;
    if (square < 0) {
        const double re = -c->a / c->b, im = sqrt(-square) / c->b;
        c->roots[c->count][0] = re;
        c->roots[c->count++][1] = im;
        return;
    }
    /* Neither root cancels; one that is infinite is no root. */
    const double q = -(c->a + copysign(sqrt(square), c->a));
    const double pair[2] = {q / c->b, 2 * rest / q};
    for (int i = 0; i < 2; i++)
        if (isfinite(pair[i])) {
            c->roots[c->count][0] = pair[i];
            c->roots[c->count++][1] = 0;
        }
}

/* How far from `x` the nearest place is at which u is 1 or -1. */
static double clearance(const sine_curve *c, double x)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < c->count; i++)
        nearest = bat_min(nearest, bat_hypot(x - c->roots[i][0], c->roots[i][1]));
    return nearest;
}

static void add_node(const sine_curve *c, double x, double weight, bat_geometric *sum)
{
    const double k = c->a + c->b * x, u = c->sine + x * (c->a + c->b * x / 2);
    const double square = (1 - u) * (1 + u), w = sqrt(square);
    const double part = weight / w, cube = part / square;
    sum->rise += part * u;
    sum->length += part;
    sum->energy += part * k * k;
    sum->moments[0] += cube;
    sum->moments[1] += cube * x;
    sum->moments[2] += cube * x * x;
}

void bat_geometric_at(double sine, double a, double b, bat_geometric *out)
{
    sine_curve c = {.sine = sine, .a = a, .b = b};
    bat_geometric sum = {0};
    add_roots(&c, 1);
    add_roots(&c, -1);
    double x = 0, h = 1;
    for (int panel = 0; panel < MAX_PANELS && x < 1; panel++) {
        /* Within the ellipse about the panel whose half axes add up to 3 halves of it Gauss
         * errs by 3^-32; its longer half axis is 5/3 of half the panel. */
        h = bat_min(2 * h, 1 - x);
        while (h > 0 && clearance(&c, x + h / 2) < 5 * h / 6 && x + h / 2 > x)
            h /= 2;
        for (int i = 0; i < HALF; i++) {
            add_node(&c, x + h / 2 * (1 - nodes[i]), h / 2 * weights[i], &sum);
            add_node(&c, x + h / 2 * (1 + nodes[i]), h / 2 * weights[i], &sum);
        }
        x = h < 1 - x ? x + h : 1;
    }
    *out = sum;
}

void bat_span_geometric(int d, const batten_span *span, double t, int order, double *out)
{
    assert(d == 2);
    (void)d;
    const double a = span->curvature[0], b = span->curvature[1];
    const double sine = bat_sin(span->angle - span->chord);
    bat_geometric at;
    /* In units of t. */
    bat_geometric_at(sine, a * t, b * t * t, &at);
    const double k = a + b * t, u = sine + t * (a + b * t / 2);
    const double w2 = (1 - u) * (1 + u), w = sqrt(w2);
    /* The rise and its derivatives by the abscissa. */
    const double rise[4] = {t * at.rise, u / w, k / (w * w2),
                            (b + 3 * u * k * k / w2) / (w * w2)};
    const double x[4] = {t, 1, 0, 0};
    const double cosine = bat_cos(span->chord), slant = bat_sin(span->chord);
    for (int i = 0; i <= order; i++) {
        const double origin[2] = {i == 0 ? span->start[0] : 0, i == 0 ? span->start[1] : 0};
        out[2 * i] = origin[0] + (cosine * x[i] - slant * rise[i]);
        out[2 * i + 1] = origin[1] + (slant * x[i] + cosine * rise[i]);
    }
}

batten_status bat_span_geometric_check(const batten_span *span, int index)
{
    const double l = span->length, a = span->curvature[0] * l, b = span->curvature[1] * l * l;
    const double sine = bat_sin(span->angle - span->chord);
    const double top = b != 0 && -a / b > 0 && -a / b < 1 ? -a / b : 0;
    const double u[3] = {sine, sine + a + b / 2, sine + top * (a + b * top / 2)};
    if (!(bat_cos(span->angle - span->chord) > 0))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "span %d begins at %g radians to its chord, not less than a right angle", index + 1,
            span->angle - span->chord);
    for (int i = 0; i < 3; i++)
        if (!(fabs(u[i]) < 1))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "span %d would turn a right angle away from its chord: the sine of "
                            "its angle reaches %g",
                            index + 1, u[i]);
    return BATTEN_OK;
}
