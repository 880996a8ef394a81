/* Thickness and camber of an aerofoil, measured across its chord, and their change. */
#include "base/elementary.h"
#include "shape/aerofoil/aerofoil.h"

/* x of a side where its end is brought to x = 1. */
static batten_status find_x(const bat_aerofoil_sides *s, int side, double u, double at[2])
{
    const batten_status status = batten_curve_evaluate(s->curve, u, 0, at);
    at[0] /= s->reach[side];
    return status;
}

/* By halving, as far as numbers go: sides rise from the nose to the tail. */
batten_status bat_aerofoil_height(const bat_aerofoil_sides *s, int side, double x, double *y)
{
    double low = s->nose, high = side ? s->end : s->start, at[2] = {0, 0};
    batten_status status = BATTEN_OK;
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle == low || middle == high)
            break;
        status = find_x(s, side, middle, at);
        if (status != BATTEN_OK)
            return status;
        if (at[0] < x)
            low = middle;
        else
            high = middle;
    }
    status = find_x(s, side, high, at);
    *y = at[1];
    return status;
}

/* Half of what the upper side is above the lower one, and the middle between them. */
static batten_status find_halves(const bat_aerofoil_sides *s, double x, double *half,
                                 double *middle)
{
    double upper = 0, lower = 0;
    batten_status status = bat_aerofoil_height(s, 0, x, &upper);
    if (status == BATTEN_OK)
        status = bat_aerofoil_height(s, 1, x, &lower);
    *half = (upper - lower) / 2;
    *middle = (upper + lower) / 2;
    return status;
}

/* ---- change ---- */

/* How much of a change of the trailing edge counts at x. */
static double fade(double blend, double x)
{
    return x <= 0 ? 0 : x >= 1 ? 1 : x * bat_exp((1 - x) * (1 - 1 / blend));
}

static double change_half(const bat_aerofoil_change *c, double x, double half)
{
    const double part = fade(c->blend, x) / 2;
    return c->factor * (half - c->given_edge * part) + c->edge * part;
}

batten_status bat_aerofoil_move(const bat_aerofoil_change *c, double u, double to[2])
{
    const bat_aerofoil_sides *s = c->sides;
    if (!c->is_asked)
        return batten_curve_evaluate(s->curve, u, 0, to);
    const int side = u > s->nose;
    double other = 0;
    batten_status status = find_x(s, side, u, to);
    if (status == BATTEN_OK)
        status = bat_aerofoil_height(s, 1 - side, to[0], &other);
    if (status != BATTEN_OK)
        return status;
    const double half = (side ? other - to[1] : to[1] - other) / 2;
    const double middle = (to[1] + other) / 2;
    to[1] = middle + (side ? -1 : 1) * change_half(c, to[0], half);
    return BATTEN_OK;
}

/* ---- measures ---- */

/* A quantity at x, of which the largest is sought. */
typedef struct {
    const bat_aerofoil_sides *sides;
    const bat_aerofoil_change *change; /* of a thickness; NULL: as it is */
    bool is_camber;
} quantity;

static batten_status find_quantity(const quantity *q, double x, double *value)
{
    double half = 0, middle = 0;
    const batten_status status = find_halves(q->sides, x, &half, &middle);
    *value =
        q->is_camber ? fabs(middle) : 2 * (q->change ? change_half(q->change, x, half) : half);
    return status;
}

/* The largest between two places, by golden sections. */
static batten_status refine_largest(const quantity *q, double low, double high, double *at,
                                    double *value)
{
    enum { STEPS = 45 }; /* 0.618^45 < 1e-9, the square root of what can be told */
    const double golden = 0.618033988749894848;
    batten_status status = BATTEN_OK;
    double places[2] = {high - golden * (high - low), low + golden * (high - low)}, values[2];
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = find_quantity(q, places[k], &values[k]);
    for (int i = 0; i < STEPS && status == BATTEN_OK; i++) {
        const int lost = values[0] > values[1];
        *(lost ? &high : &low) = places[lost];
        places[lost] = places[1 - lost];
        values[lost] = values[1 - lost];
        const int next = 1 - lost;
        places[next] = next ? low + golden * (high - low) : high - golden * (high - low);
        status = find_quantity(q, places[next], &values[next]);
    }
    const int best = status == BATTEN_OK && values[1] > values[0];
    if (status == BATTEN_OK && values[best] > *value) {
        *value = values[best];
        *at = places[best];
    }
    return status;
}

static batten_status find_largest(const quantity *q, double *at, double *value)
{
    enum { PLACES = 256 }; /* bumps narrower than a 256th of the chord may be missed */
    batten_status status = BATTEN_OK;
    *at = 0;
    *value = -1;
    for (int i = 1; i <= PLACES && status == BATTEN_OK; i++) {
        const double x = (double)i / PLACES;
        double here = 0;
        status = find_quantity(q, x, &here);
        if (status == BATTEN_OK && here > *value) {
            *value = here;
            *at = x;
        }
    }
    const double from = bat_max(0, *at - 1.0 / PLACES), to = bat_min(1, *at + 1.0 / PLACES);
    return status == BATTEN_OK ? refine_largest(q, from, to, at, value) : status;
}

batten_status bat_aerofoil_measure(const bat_aerofoil_sides *s, batten_aerofoil_shape *out)
{
    double half = 0, middle = 0;
    const quantity thickness = {s, NULL, false}, camber = {s, NULL, true};
    batten_status status = find_largest(&thickness, &out->thickness_at, &out->thickness);
    if (status == BATTEN_OK)
        status = find_largest(&camber, &out->camber_at, &out->camber);
    if (status == BATTEN_OK)
        status = find_halves(s, out->camber_at, &half, &middle);
    if (status == BATTEN_OK && middle < 0)
        out->camber = -out->camber;
    if (status == BATTEN_OK)
        status = find_halves(s, 1, &half, &middle);
    out->trailing_edge = 2 * half;
    return status;
}

/* Where the thickness is largest the factor follows; a few rounds, for that place moves little. */
batten_status bat_aerofoil_set_thickness(bat_aerofoil_change *c, double thickness)
{
    enum { ROUNDS = 20 };
    const double still = 1e-13; /* of the factor: some hundred roundings */
    const quantity changed = {c->sides, c, false};
    for (int i = 0; i < ROUNDS; i++) {
        double at = 0, value = 0, half = 0, middle = 0;
        batten_status status = find_largest(&changed, &at, &value);
        if (status == BATTEN_OK)
            status = find_halves(c->sides, at, &half, &middle);
        if (status != BATTEN_OK)
            return status;
        const double part = fade(c->blend, at);
        const double own = 2 * half - c->given_edge * part, before = c->factor;
        c->factor = (thickness - c->edge * part) / own;
        if (!(own > 0) || !(c->factor > 0))
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "a thickness of %g is not above the %g that a trailing edge of %g "
                "has at %g of the chord; make the thickness larger, or the trailing "
                "edge smaller",
                thickness, c->edge * part, c->edge, at);
        if (fabs(c->factor - before) <= still * before)
            break;
    }
    return BATTEN_OK;
}
