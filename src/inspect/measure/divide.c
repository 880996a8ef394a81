/* Parameters that divide a curve: into parts near their chords, that turn little, or both. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>

#include <string.h>

enum { DEPTH = 50, MOST_PARTS = 1000000 };

batten_status batten_curve_divide(const batten_curve *curve, int count, double tolerance,
                                  double *u)
{
    if (count < 1 || count > MOST_PARTS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve is not cut into %d parts", count);
    const size_t n = (size_t)count + 1;
    double length, *s = bat_array(n, sizeof *s), *at = bat_array(n, sizeof *at);
    batten_status status = s && at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_length(curve, tolerance / 4, NULL, &length);
    for (int k = 0; status == BATTEN_OK && k <= count; k++)
        s[k] = length * k / count;
    if (status == BATTEN_OK)
        status = batten_curve_at_length(curve, count + 1, s, tolerance, at);
    if (status == BATTEN_OK) {
        /* The ends are the ends, whatever the length was measured to. */
        at[0] = batten_curve_domain(curve).a;
        at[count] = batten_curve_domain(curve).b;
        memcpy(u, at, n * sizeof *u);
    }
    bat_release(at);
    bat_release(s);
    return status;
}

/* How far the points [p + 1] of homogeneous rows (w x .., w) lie from their chord. */
static double sag(int p, int d, const double *rows)
{
    const double *last = rows + p * (d + 1);
    double chord[3], away[3], most = 0;
    for (int k = 0; k < d; k++)
        chord[k] = last[k] / last[d] - rows[k] / rows[d];
    const double square = bat_dot(d, chord, chord);
    for (int i = 1; i < p; i++) {
        const double *row = rows + i * (d + 1);
        for (int k = 0; k < d; k++)
            away[k] = row[k] / row[d] - rows[k] / rows[d];
        const double share = square > 0 ? bat_dot(d, away, chord) / square : 0;
        for (int k = 0; k < d; k++)
            away[k] -= bat_min(1, bat_max(0, share)) * chord[k];
        most = bat_max(most, bat_norm(d, away));
    }
    return most;
}

/* The cosine of the widest angle between a leg of the polygon and its chord; legs of no length
 * have no direction. */
static double least_cosine(int p, int d, const double *rows)
{
    const double *last = rows + p * (d + 1);
    double chord[3], leg[3], least = 1;
    for (int k = 0; k < d; k++)
        chord[k] = last[k] / last[d] - rows[k] / rows[d];
    const double length = bat_norm(d, chord);
    for (int i = 1; i <= p; i++) {
        const double *a = rows + (i - 1) * (d + 1), *b = a + d + 1;
        for (int k = 0; k < d; k++)
            leg[k] = b[k] / b[d] - a[k] / a[d];
        const double size = bat_norm(d, leg);
        if (size > 0)
            least = bat_min(least, length > 0 ? bat_dot(d, leg, chord) / (size * length) : -1);
    }
    return least;
}

/* What a part must be. */
typedef struct {
    double height, cosine; /* cosine: -1 for any turn */
} limits;

static bool is_good(const limits *l, int p, int d, const double *rows)
{
    return (l->height == HUGE_VAL || sag(p, d, rows) <= l->height) &&
           (l->cosine == -1 || least_cosine(p, d, rows) >= l->cosine);
}

/* Rows become the right half; `left` the left one. */
static void halve(int p, int width, double *rows, double *left)
{
    memcpy(left, rows, (size_t)width * sizeof *rows);
    for (int r = 1; r <= p; r++) {
        for (int i = 0; i < (p + 1 - r) * width; i++)
            rows[i] = (rows[i] + rows[i + width]) / 2;
        memcpy(left + r * width, rows, (size_t)width * sizeof *rows);
    }
}

static batten_status note_end(batten_parameters *out, int *room, double u)
{
    if (out->count > MOST_PARTS)
        return bat_fail(BATTEN_TOO_LARGE, "the polyline would have more than %d parts",
                        MOST_PARTS);
    if (out->count == *room) {
        double *grown = bat_resize(out->at, 2 * (size_t)*room + 16, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        out->at = grown;
        *room = 2 * *room + 16;
    }
    out->at[out->count++] = u;
    return BATTEN_OK;
}

/* The ends of the parts of one Bezier piece, whose rows begin the stack. */
static batten_status cut_piece(int p, int d, double a, double b, const limits *l, double *stack,
                               int *room, batten_parameters *out)
{
    const int width = d + 1, size = (p + 1) * width;
    double ends[DEPTH + 2];
    int waiting = 1;
    batten_status status = BATTEN_OK;
    ends[0] = b;
    while (status == BATTEN_OK && waiting > 0) {
        double *top = stack + (waiting - 1) * size;
        const double end = ends[waiting - 1];
        if (waiting > DEPTH || is_good(l, p, d, top)) {
            status = note_end(out, room, end);
            a = end;
            waiting--;
            continue;
        }
        halve(p, width, top, top + size);
        ends[waiting++] = a + (end - a) / 2;
    }
    return status;
}

static batten_status divide(const batten_curve *curve, const limits *l, batten_parameters *out)
{
    batten_curve *bezier = NULL;
    batten_parameters made = {0, NULL};
    int room = 0;
    const int p = curve->degree, d = curve->dimension;
    double *stack = bat_array3(DEPTH + 2, (size_t)(p + 1) * (size_t)(d + 1), sizeof *stack);
    batten_status status =
        stack ? batten_curve_to_bezier(curve, &bezier) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = note_end(&made, &room, batten_curve_domain(curve).a);
    for (int k = p; status == BATTEN_OK && k < bezier->count; k += p) {
        for (int i = 0; i <= p; i++) {
            const int at = k - p + i;
            const double w = bezier->weights ? bezier->weights[at] * bezier->weight_scale : 1;
            for (int j = 0; j < d; j++)
                stack[i * (d + 1) + j] = w * bezier->points[at * d + j];
            stack[i * (d + 1) + d] = w;
        }
        status =
            cut_piece(p, d, bezier->knots[k], bezier->knots[k + 1], l, stack, &room, &made);
    }
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_release(made.at);
    batten_curve_unref(bezier);
    bat_release(stack);
    return status;
}

batten_status batten_curve_divide_chord(const batten_curve *curve, double height,
                                        batten_parameters *out)
{
    const limits l = {height, -1};
    if (!(height > 0 && isfinite(height)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the height of chords is %g, not above 0", height);
    return divide(curve, &l, out);
}

batten_status batten_curve_divide_turn(const batten_curve *curve, double height, double angle,
                                       batten_parameters *out)
{
    const limits l = {height, bat_cos(angle / 2)};
    if (!(height > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the height of chords is %g, not above 0", height);
    if (!(angle > 0 && angle <= BAT_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle of chords is %g, outside 0 to pi",
                        angle);
    return divide(curve, &l, out);
}
