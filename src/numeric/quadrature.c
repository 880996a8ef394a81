/*
 * Gauss-Legendre rules of up to 64 nodes, and adaptive integration with a Gauss-Kronrod pair
 * that always halves the worst interval. Source: [DLMF] 3.5, [PDUK83].
 */
#include "numeric/quadrature.h"

#include "base/list.h"
#include "base/sort.h"

#include <float.h>

/* ---- Gauss ---- */

/* P_n(x) and its derivative, |x| < 1, by the recurrence of three terms. */
static double legendre(int n, double x, double *derivative)
{
    double before = 0, value = 1;
    for (int k = 0; k < n; k++) {
        const double next = ((2 * k + 1) * x * value - k * before) / (k + 1);
        before = value;
        value = next;
    }
    *derivative = n * (before - x * value) / (1 - x * x);
    return value;
}

/* The greater half of the nodes, falling, and their weights, rounded from 50 digits: these two
 * rules are asked for over and over. */
static const double ten[5][2] = {{0.9739065285171717, 0.06667134430868814},
                                 {0.8650633666889845, 0.1494513491505806},
                                 {0.6794095682990244, 0.21908636251598204},
                                 {0.4333953941292472, 0.26926671930999635},
                                 {0.14887433898163122, 0.29552422471475287}};
static const double sixteen[8][2] = {
    {0.9894009349916499, 0.027152459411754096}, {0.9445750230732326, 0.062253523938647894},
    {0.8656312023878318, 0.09515851168249279},  {0.755404408355003, 0.12462897125553388},
    {0.6178762444026438, 0.14959598881657674},  {0.45801677765722737, 0.16915651939500254},
    {0.2816035507792589, 0.18260341504492358},  {0.09501250983763744, 0.1894506104550685}};

static void spread(int n, const double (*half)[2], double *nodes, double *weights)
{
    for (int i = 0; i < n / 2; i++) {
        nodes[i] = -half[i][0];
        nodes[n - 1 - i] = half[i][0];
        weights[i] = weights[n - 1 - i] = half[i][1];
    }
}

void bat_gauss(int n, double *nodes, double *weights)
{
    assert(n >= 1 && n <= BAT_MAX_GAUSS);
    if (n == 10 || n == 16) {
        spread(n, n == 10 ? ten : sixteen, nodes, weights);
        return;
    }
    for (int i = 0; i <= (n - 1) / 2; i++) {
        /* The start is within 1/n^2; each of Newton's steps doubles the digits. */
        double x = 2 * i + 1 == n ? 0 : bat_cos(BAT_PI * (i + 0.75) / (n + 0.5));
        double slope, value = legendre(n, x, &slope);
        for (int step = 0; step < 6 && 2 * i + 1 != n; step++) {
            x -= value / slope;
            value = legendre(n, x, &slope);
        }
        nodes[i] = -x;
        nodes[n - 1 - i] = x;
        weights[i] = weights[n - 1 - i] = 2 / ((1 - x * x) * slope * slope);
    }
}

/* ---- adaptive ---- */

/* Kronrod's 15 nodes on [0, 1] from the outermost to 0; each second one is a node of Gauss
 * with 7. */
static const double kronrod_nodes[8] = {
    0.99145537112081264, 0.94910791234275852, 0.86486442335976907, 0.74153118559939444,
    0.58608723546769113, 0.40584515137739717, 0.20778495500789847, 0};
static const double kronrod_weights[8] = {
    0.022935322010529225, 0.063092092629978553, 0.10479001032225018, 0.14065325971552592,
    0.16900472663926790,  0.19035057806478541,  0.20443294007529889, 0.20948214108472783};
static const double gauss_weights[4] = {0.12948496616886969, 0.27970539148927667,
                                        0.38183005050511894, 0.41795918367346939};

typedef struct {
    double a, b, value, error;
} piece;

/* A heap of pieces: none has a larger error than the first. */
typedef struct {
    bat_integrand f;
    void *context;
    bool looks_at_ends;
    piece *pieces;
    size_t count, room;
} heap;

/* Values of f at centre - step and centre + step. */
static batten_status pair(bat_integrand f, void *context, double centre, double step,
                          double values[2])
{
    batten_status status = f(context, centre - step, &values[0]);
    if (status == BATTEN_OK)
        status = f(context, centre + step, &values[1]);
    if (status == BATTEN_OK && !(isfinite(values[0]) && isfinite(values[1])))
        status = bat_fail(BATTEN_NOT_FINITE, "the integrand is not finite near %g", centre);
    return status;
}

/* How much more the integrand is beside the ends of a piece than at any node of the rule, over
 * twice: what a node there would add. */
static batten_status hidden_peak(const heap *h, const piece *p, double seen, double *out)
{
    /* Inside the piece, and yet far nearer to its end than any node. */
    const double beside = ldexp(p->b - p->a, -40);
    double at[2];
    batten_status status = h->f(h->context, p->a + beside, &at[0]);
    if (status == BATTEN_OK)
        status = h->f(h->context, p->b - beside, &at[1]);
    if (status != BATTEN_OK)
        return status;
    const double highest = bat_max(fabs(at[0]), fabs(at[1]));
    *out = kronrod_weights[0] * bat_max(0, highest - 2 * seen);
    return BATTEN_OK;
}

static batten_status measure_piece(const heap *h, piece *p)
{
    const double centre = 0.5 * (p->a + p->b), half = 0.5 * (p->b - p->a);
    double gauss = 0, kronrod = 0, size = 0, seen = 0, hidden = 0, values[8][2];
    batten_status status = BATTEN_OK;
    for (int i = 0; i < 8; i++) {
        status = pair(h->f, h->context, centre, half * kronrod_nodes[i], values[i]);
        if (status != BATTEN_OK)
            return status;
        /* The middle counts once. */
        const double sum = i < 7 ? values[i][0] + values[i][1] : values[i][0];
        kronrod += kronrod_weights[i] * sum;
        size += kronrod_weights[i] * fabs(sum);
        seen = bat_max(seen, bat_max(fabs(values[i][0]), fabs(values[i][1])));
        if (i % 2 == 1)
            gauss += gauss_weights[i / 2] * sum;
    }
    double spread = 0;
    for (int i = 0; i < 8; i++)
        spread += kronrod_weights[i] * (fabs(values[i][0] - kronrod / 2) +
                                        (i < 7 ? fabs(values[i][1] - kronrod / 2) : 0));
    /* The rule of [PDUK83]: the difference is Gauss's error, that of Kronrod is far smaller
     * once both converge. */
    const double difference = fabs(kronrod - gauss);
    const double ratio = spread > 0 ? 200 * difference / spread : 0;
    if (h->looks_at_ends)
        status = hidden_peak(h, p, seen, &hidden);
    p->value = half * kronrod;
    p->error = half * bat_max(bat_max(spread * bat_min(1, ratio * sqrt(ratio)), hidden),
                              4 * DBL_EPSILON * size);
    return status;
}

static batten_status push(heap *h, piece p)
{
    const batten_status status = BAT_LIST_GROW(h->pieces, h->count, h->room, 1);
    if (status != BATTEN_OK)
        return status;
    size_t i = h->count++;
    for (; i > 0 && h->pieces[(i - 1) / 2].error < p.error; i = (i - 1) / 2)
        h->pieces[i] = h->pieces[(i - 1) / 2];
    h->pieces[i] = p;
    return BATTEN_OK;
}

static piece pop(heap *h)
{
    const piece first = h->pieces[0], last = h->pieces[--h->count];
    size_t i = 0;
    for (size_t child = 1; child < h->count; child = 2 * i + 1) {
        if (child + 1 < h->count && h->pieces[child].error < h->pieces[child + 1].error)
            child++;
        if (h->pieces[child].error <= last.error)
            break;
        h->pieces[i] = h->pieces[child];
        i = child;
    }
    h->pieces[i] = last;
    return first;
}

static batten_status push_measured(heap *h, double a, double b)
{
    piece p = {.a = a, .b = b};
    const batten_status status = measure_piece(h, &p);
    return status == BATTEN_OK ? push(h, p) : status;
}

static double total_error(const heap *h)
{
    double sum = 0;
    for (size_t i = 0; i < h->count; i++)
        sum += h->pieces[i].error;
    return sum;
}

static double total(const heap *h)
{
    double sum = 0;
    for (size_t i = 0; i < h->count; i++)
        sum += h->pieces[i].value;
    return sum;
}

/* Halve the worst piece until the errors add up to no more than allowed. */
static batten_status refine(heap *h, double tolerance, int limit)
{
    const int halving = h->looks_at_ends ? 36 : 32;
    double error = total_error(h);
    for (int left = limit - halving / 2; error > tolerance && left >= halving;
         left -= halving) {
        const piece worst = pop(h);
        const double middle = 0.5 * (worst.a + worst.b);
        batten_status status = push_measured(h, worst.a, middle);
        if (status == BATTEN_OK)
            status = push_measured(h, middle, worst.b);
        if (status != BATTEN_OK)
            return status;
        /* Differences of sums drift; once they matter, add anew. */
        error = h->count % 16 == 0 || error < 4 * tolerance ? total_error(h) : error;
        if (middle <= worst.a || middle >= worst.b)
            break;
    }
    return BATTEN_OK;
}

/* What the pieces add up to; TOLERANCE_NOT_MET when that is not known as well as asked. */
static batten_status conclude(const heap *h, double tolerance, int limit, double *value,
                              double *error)
{
    *value = total(h);
    *error = total_error(h);
    if (*error <= tolerance)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "the integral is known to %g, not to %g, after %d evaluations", *error,
                    tolerance, limit);
}

batten_status bat_integrate(bat_integrand f, void *context, double a, double b,
                            double tolerance, int limit, double *value, double *error)
{
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of an integral is %g, not above 0",
                        tolerance);
    const bool is_backward = b < a;
    heap h = {.f = f, .context = context};
    batten_status status = push_measured(&h, is_backward ? b : a, is_backward ? a : b);
    if (status == BATTEN_OK)
        status = refine(&h, tolerance, limit);
    if (status == BATTEN_OK) {
        status = conclude(&h, tolerance, limit, value, error);
        *value = is_backward ? -*value : *value;
    }
    bat_release(h.pieces);
    return status;
}

/* What all intervals add up to when each may be off by `share`; with their pieces unless `fine` is NULL. */
static batten_status integrate_intervals(heap *h, const bat_peaked_integral *integral,
                                         double share, double *sum, double *off,
                                         bat_integral_breaks *fine)
{
    batten_status status = BATTEN_OK;
    *sum = *off = 0;
    for (int i = 0; i + 1 < integral->count && status == BATTEN_OK; i++) {
        h->count = 0;
        status = push_measured(h, integral->breaks[i], integral->breaks[i + 1]);
        if (status == BATTEN_OK)
            status = refine(h, share, integral->limit);
        *sum += total(h);
        *off += total_error(h);
        for (size_t k = 0; fine && k < h->count && status == BATTEN_OK; k++)
            status = BAT_LIST_ADD(fine->at, fine->count, fine->room, h->pieces[k].a);
    }
    return status;
}

/* Each interval to its share of the error. The integral is known after the first round only,
 * and a peak that comes to light then makes it larger, or a false one smaller. */
batten_status bat_integrate_peaked(const bat_peaked_integral *integral, double *value,
                                   double *error, bat_integral_breaks *fine)
{
    enum { ROUNDS = 3 };
    heap h = {.f = integral->f, .context = integral->context, .looks_at_ends = true};
    bat_integral_breaks found = {0};
    batten_status status = BATTEN_OK;
    double allowed = 0, sum = 0, off = HUGE_VAL;
    for (int round = 0; round <= ROUNDS && status == BATTEN_OK && off > allowed; round++) {
        found.count = 0;
        status = integrate_intervals(&h, integral,
                                     round > 0 ? allowed / (integral->count - 1) : HUGE_VAL,
                                     &sum, &off, fine ? &found : NULL);
        allowed = integral->relative * fabs(sum);
    }
    if (status == BATTEN_OK && fine)
        status = BAT_LIST_ADD(found.at, found.count, found.room,
                              integral->breaks[integral->count - 1]);
    bat_release(h.pieces);
    if (status != BATTEN_OK) {
        bat_release(found.at);
        return status;
    }
    bat_sort_doubles((size_t)found.count, found.at);
    *value = sum;
    *error = off;
    if (fine)
        *fine = found;
    if (off <= allowed)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the integral is known to %g, not to %g", off,
                    allowed);
}
