/* An interval that is halved from the left until every piece satisfies its caller. */
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

#endif
