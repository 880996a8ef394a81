/*
 * The plane cubic with given points, directions and curvatures at both ends. Its two quadratic
 * equations are reduced to a quartic and the roots polished by Newton. Source: [dBHS87].
 */
#include "shape/local/curvature_ends.h"

#include "numeric/polynomial.h"
#include "numeric/vector.h"

#include <float.h>

/* c y = a - p x^2, c x = b - q y^2 for x, y > 0: the pair in units of the chord, divided by its
 * largest coefficient. */
typedef struct {
    double a, b, c, p, q;
} pair;

typedef struct {
    int count;
    bat_legs at[BAT_DBHS_SOLUTIONS];
} solutions;

static double cross(const double *u, const double *v)
{
    return u[0] * v[1] - u[1] * v[0];
}

/* Does (x, y) solve both equations but for the rounding of their terms, near a double solution
 * for that of its square root? */
static bool solves(const pair *e, double x, double y)
{
    const double tolerance = 64 * DBL_EPSILON;
    const double f = e->c * y - e->a + e->p * x * x, g = e->c * x - e->b + e->q * y * y;
    return fabs(f) <= tolerance * (fabs(e->c * y) + fabs(e->a) + fabs(e->p) * x * x) &&
           fabs(g) <= tolerance * (fabs(e->c * x) + fabs(e->b) + fabs(e->q) * y * y);
}

static double off(const solutions *s, int i)
{
    return bat_hypot(s->at[i].start - 1.0 / 3, s->at[i].end - 1.0 / 3);
}

/* A new one, kept in the order of their distance from a third. */
static void insert_solution(solutions *s, double x, double y)
{
    for (int i = 0; i < s->count; i++)
        if (fabs(s->at[i].start - x) <= 1e-7 * x && fabs(s->at[i].end - y) <= 1e-7 * y)
            return;
    if (s->count == BAT_DBHS_SOLUTIONS)
        return;
    int i = s->count++;
    s->at[i] = (bat_legs){x, y};
    for (; i > 0 && off(s, i) < off(s, i - 1); i--) {
        const bat_legs other = s->at[i - 1];
        s->at[i - 1] = s->at[i];
        s->at[i] = other;
    }
}

/* Newton from a start that is good but for the rounding of the quartic. A double solution is
 * approached by halves, and a start good to half the digits needs at most 26 of them. */
static void refine(const pair *e, double x, double y, solutions *s)
{
    for (int step = 0; step < 32; step++) {
        const double f = e->c * y - e->a + e->p * x * x, g = e->c * x - e->b + e->q * y * y;
        const double fx = 2 * e->p * x, gy = 2 * e->q * y, det = fx * gy - e->c * e->c;
        const double dx = (f * gy - g * e->c) / det, dy = (g * fx - f * e->c) / det;
        if (!isfinite(dx) || !isfinite(dy))
            break;
        x -= dx;
        y -= dy;
        if (fabs(dx) <= DBL_EPSILON * fabs(x) && fabs(dy) <= DBL_EPSILON * fabs(y))
            break;
    }
    if (x > 0 && y > 0 && solves(e, x, y))
        insert_solution(s, x, y);
}

/* Tangents are parallel: each leg by itself, and a third where it is free. */
static void solve_apart(const pair *e, solutions *s)
{
    const double x = e->p != 0 ? e->a / e->p : e->a == 0 ? 1.0 / 9 : 0;
    const double y = e->q != 0 ? e->b / e->q : e->b == 0 ? 1.0 / 9 : 0;
    if (x > 0 && y > 0)
        insert_solution(s, sqrt(x), sqrt(y));
}

/* y eliminated: c^3 x - c^2 b + q (a - p x^2)^2 = 0. Near-parallel tangents make its roots
 * nearly double and y = (a - p x^2) / c uncertain; then y comes from the other equation. */
static void solve_quartic(const pair *e, solutions *s)
{
    const double a = e->a, b = e->b, c = e->c, p = e->p, q = e->q;
    const double quartic[5] = {q * a * a - c * c * b, c * c * c, -2 * q * a * p, 0, q * p * p};
    double roots[4];
    const int degree = quartic[4] != 0 ? 4 : 1;
    const int count = bat_polynomial_roots(degree, quartic, 0, INFINITY, roots);
    for (int i = 0; i < count; i++) {
        const double x = roots[i], square = q != 0 ? (b - c * x) / q : -1;
        refine(e, x, (a - p * x * x) / c, s);
        if (square > 0)
            refine(e, x, sqrt(square), s);
    }
}

/* What is below the rounding of unit vectors is 0. */
static double rounded(double value)
{
    return fabs(value) <= 4 * DBL_EPSILON ? 0 : value;
}

int bat_dbhs(const double *t0, const double *t1, const double *chord, double k0, double k1,
             bat_legs *legs)
{
    const double l = bat_norm(2, chord), d[2] = {chord[0] / l, chord[1] / l};
    pair e = {rounded(cross(t0, d)), rounded(cross(d, t1)), rounded(cross(t0, t1)),
              rounded(1.5 * k0 * l), rounded(1.5 * k1 * l)};
    const double largest = bat_max(bat_max(bat_max(fabs(e.a), fabs(e.b)), fabs(e.c)),
                                   bat_max(fabs(e.p), fabs(e.q)));
    solutions found = {0};
    if (largest > 0)
        e = (pair){e.a / largest, e.b / largest, e.c / largest, e.p / largest, e.q / largest};
    if (e.c == 0)
        solve_apart(&e, &found);
    else
        solve_quartic(&e, &found);
    for (int i = 0; i < found.count; i++)
        legs[i] = (bat_legs){found.at[i].start * l, found.at[i].end * l};
    return found.count;
}
