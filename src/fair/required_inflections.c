/*
 * How many inflections data require when each point may lie anywhere within its bound.
 *
 * Beginning at the first point, take the longest piece through which a convex curve passes,
 * then the longest concave one, and so on: no other division has fewer pieces. A convex
 * function passes points within their bounds exactly when the lower hull of the upper bounds
 * runs above the lower bounds. In the plane the function is taken over the chord of the piece;
 * a piece that folds back over its chord is ended there and continued with the same sign.
 */
#include "fair/fairness.h"

#include <float.h>

typedef enum { FITS, TURNS, FOLDS } verdict;

typedef struct {
    int width, count;
    const double *t, *points, *within;
    double roundoff; /* of a height */
    double *x, *y;   /* [count], a piece over its chord, mirrored when it turns right */
    int *hull;       /* [count] */
} outline;

static double bound(const outline *o, int i)
{
    return (o->within ? o->within[i] : 0) + o->roundoff;
}

/* Points a .. b over the chord (a function: over t), `sign` times their heights; false when
 * they fold. */
static bool lay_out(outline *o, int a, int b, int sign)
{
    const double *p = o->points;
    const double dx = o->width == 1 ? 0 : p[2 * b] - p[2 * a];
    const double dy = o->width == 1 ? 0 : p[2 * b + 1] - p[2 * a + 1];
    const double chord = bat_hypot(dx, dy);
    if (o->width == 2 && chord == 0)
        return false;
    for (int i = a; i <= b; i++) {
        const double rx = o->width == 1 ? 0 : p[2 * i] - p[2 * a];
        const double ry = o->width == 1 ? 0 : p[2 * i + 1] - p[2 * a + 1];
        o->x[i] = o->width == 1 ? o->t[i] : (rx * dx + ry * dy) / chord;
        o->y[i] = sign * (o->width == 1 ? p[i] : (dx * ry - dy * rx) / chord);
        if (i > a && !(o->x[i] > o->x[i - 1]))
            return false;
    }
    return true;
}

/* Does the line from `i` to `k` at the height of their upper bounds pass below the upper bound
 * of `j`? */
static bool is_below(const outline *o, int i, int j, int k)
{
    const double yi = o->y[i] + bound(o, i), yj = o->y[j] + bound(o, j),
                 yk = o->y[k] + bound(o, k);
    return (yj - yi) * (o->x[k] - o->x[i]) >= (yk - yi) * (o->x[j] - o->x[i]);
}

static bool hull_is_above(const outline *o, int size)
{
    for (int h = 0; h + 1 < size; h++) {
        const int i = o->hull[h], k = o->hull[h + 1];
        const double yi = o->y[i] + bound(o, i), yk = o->y[k] + bound(o, k);
        for (int j = i + 1; j < k; j++) {
            const double part = (o->x[j] - o->x[i]) / (o->x[k] - o->x[i]);
            if (o->y[j] - bound(o, j) > yi + part * (yk - yi))
                return false;
        }
    }
    return true;
}

static verdict fits(outline *o, int a, int b, int sign)
{
    if (b <= a + 1)
        return FITS;
    if (!lay_out(o, a, b, sign))
        return FOLDS;
    int size = 0;
    for (int i = a; i <= b; i++) {
        while (size >= 2 && is_below(o, o->hull[size - 2], o->hull[size - 1], i))
            size--;
        o->hull[size++] = i;
    }
    return hull_is_above(o, size) ? FITS : TURNS;
}

/* The last point of the longest piece from a, by doubling and halving; why it is not longer. */
static int longest(outline *o, int a, int sign, verdict *why)
{
    int good = bat_min_int(a + 1, o->count - 1), bad = o->count;
    *why = FITS;
    for (int step = 2; good < bad - 1;) {
        const int middle = good + (bad - good) / 2, try = bat_min_int(middle, a + step);
        const verdict found = fits(o, a, try, sign);
        step *= step < o->count ? 2 : 1;
        if (found == FITS) {
            good = try;
        } else {
            bad = try;
            *why = found;
        }
    }
    return good;
}

/* Changes of sign when the first piece turns to `sign`. */
static int changes(outline *o, int sign)
{
    int found = 0, a = 0;
    for (;;) {
        verdict why;
        const int b = longest(o, a, sign, &why);
        if (b == o->count - 1)
            return found;
        if (why == TURNS) {
            found++;
            sign = -sign;
        }
        /* Three points fold only as a hairpin: they count as what the others say. */
        a = why == FOLDS && b == a + 1 ? b : b - 1;
    }
}

batten_status bat_required_inflections(int width, int count, const double *t,
                                       const double *points, const double *within, int *out)
{
    *out = 0;
    if (width > 2 || count < 4)
        return BATTEN_OK;
    outline o = {.width = width, .count = count, .t = t, .points = points, .within = within};
    o.x = bat_array((size_t)count, 2 * sizeof *o.x);
    o.hull = bat_array((size_t)count, sizeof *o.hull);
    if (o.x && o.hull) {
        double size = 0;
        for (int i = 0; i < count * width; i++)
            size = bat_max(size, fabs(points[i]));
        o.y = o.x + count;
        o.roundoff = 8 * DBL_EPSILON * size;
        *out = bat_min_int(changes(&o, 1), changes(&o, -1));
    }
    const bool all = o.x && o.hull;
    bat_release(o.x);
    bat_release(o.hull);
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status bat_required_within(int width, int count, const double *t, const double *points,
                                  double within, int *required)
{
    if (within == 0)
        return bat_required_inflections(width, count, t, points, NULL, required);
    double *each = bat_array((size_t)count, sizeof *each);
    if (!each)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        each[i] = within;
    const batten_status status =
        bat_required_inflections(width, count, t, points, each, required);
    bat_release(each);
    return status;
}
