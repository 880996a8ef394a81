/* An interval that is halved from the left until every piece satisfies its caller; what samples say
 * about a piece. */
#ifndef BAT_HALVING_H
#define BAT_HALVING_H
#include <stdbool.h>

enum { BAT_HALVING_MOST = 63 };

/*
 * The piece at hand is [a, b]; the right halves that wait behind it lie on a stack, the nearest
 * on top.
 *
 *     bat_halving h = bat_halving_of(a, b, 40);
 *     while (h.waiting > 0)
 *         if (piece [h.a, h.b] is good) bat_halving_accept(&h);
 *         else if (!bat_halving_split(&h)) fail;
 */
typedef struct {
    double a, b;
    int waiting; /* pieces up to the end, the one at hand among them */
    int most;    /* how often a piece may be halved, at most BAT_HALVING_MOST */
    struct {
        double b;
        int depth;
    } stack[BAT_HALVING_MOST + 1];
} bat_halving;

static inline bat_halving bat_halving_of(double a, double b, int most)
{
    return (bat_halving){.a = a, .b = b, .waiting = 1, .most = most, .stack = {{b, 0}}};
}

/* Where the piece at hand would be cut. */
static inline double bat_halving_middle(const bat_halving *h)
{
    return h->a + (h->b - h->a) / 2;
}

/* The left half becomes the piece at hand; false when it was halved `most` times, or no number
 * lies between its ends. */
static inline bool bat_halving_split(bat_halving *h)
{
    const double middle = bat_halving_middle(h);
    const int top = h->waiting - 1, depth = h->stack[top].depth;
    if (depth == h->most || !(middle > h->a && middle < h->b))
        return false;
    h->stack[top].depth = depth + 1;
    h->stack[top + 1].b = h->b = middle;
    h->stack[top + 1].depth = depth + 1;
    h->waiting++;
    return true;
}

/* On to the next piece, which starts where this one ends. */
static inline void bat_halving_accept(bat_halving *h)
{
    h->a = h->b;
    h->waiting--;
    if (h->waiting > 0)
        h->b = h->stack[h->waiting - 1].b;
}

/*
 * How far Hermite interpolation is off between equally spaced samples of its error.
 *
 * The interpolant of a function and its first m - 1 derivatives at both ends is off by
 * w(t) L(t), with w = (t (1 - t))^m for t from 0 to 1 and L the divided difference of order 2m.
 * Where L is linear, as for polynomials of degree 2m + 1 and for every smooth function once the
 * piece is short, |w L| is nowhere larger than its largest sample times the factor here: a
 * linear L is a point of the plane, samples of at most 1 bound a polygon of such points, and
 * the factor is the largest |w L| over its corners. Distances of points obey it, too, because
 * it holds along every direction.
 */

/* m = 2, samples at 1/4, 1/2 and 3/4: reached by L = 1 + 28/9 (t - 1/2) at t = 0.629. */
#define BAT_CUBIC_BETWEEN_3 1.221

/* m = 3, samples at 1/8 .. 7/8: reached by a nearly odd L at t = 0.686. */
#define BAT_QUINTIC_BETWEEN_7 1.1374

#endif
