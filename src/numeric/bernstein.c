/*
 * Polynomials in Bernstein form: evaluation and subdivision by de Casteljau's algorithm, and
 * roots by subdivision with Descartes' rule of signs. Source: [LR81].
 */
#include "numeric/bernstein.h"

#include <float.h>
#include <string.h>

double bat_bernstein_value(int degree, const double *c, double t)
{
    assert(degree >= 0 && degree <= BAT_BERNSTEIN_DEGREE);
    double row[BAT_BERNSTEIN_DEGREE + 1];
    memcpy(row, c, (size_t)(degree + 1) * sizeof *row);
    for (int level = degree; level > 0; level--)
        for (int i = 0; i < level; i++)
            row[i] = (1 - t) * row[i] + t * row[i + 1];
    return row[0];
}

void bat_bernstein_split(int degree, const double *c, double t, double *left, double *right)
{
    assert(degree >= 0 && degree <= BAT_BERNSTEIN_DEGREE);
    double row[BAT_BERNSTEIN_DEGREE + 1];
    memcpy(row, c, (size_t)(degree + 1) * sizeof *row);
    /* The first numbers of the levels are the left part; the last ones stay behind as the
     * right. */
    for (int level = degree; level >= 0; level--) {
        if (left)
            left[degree - level] = row[0];
        for (int i = 0; i < level; i++)
            row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
    if (right)
        memcpy(right, row, (size_t)(degree + 1) * sizeof *row);
}

static int sign(double value, double zero)
{
    return (value > zero) - (value < -zero);
}

/* ---- roots ---- */

enum { DEEPEST = 52 }; /* halvings until the ends of an interval are neighbours */

/* One part of [0, 1] that may have roots. */
typedef struct {
    double a, b;
    int depth;
} part;

/* A place where the polynomial is 0. */
typedef struct {
    double a, b; /* a == b for a simple root */
    double t;
} place;

typedef struct {
    int degree;
    double zero;
    double *coefficients; /* [DEEPEST + 2][degree + 1], one row for each part on the stack */
    place *places;        /* [degree] */
    int count;
} search;

/* Changes of sign along the coefficients; those that count as 0 are passed over. */
static int variations(int degree, const double *c, double zero, int *zero_count)
{
    int changes = 0, last = 0;
    *zero_count = 0;
    for (int i = 0; i <= degree; i++) {
        const int now = sign(c[i], zero);
        *zero_count += now == 0;
        changes += now * last < 0;
        last = now != 0 ? now : last;
    }
    return changes;
}

/* The root between the ends, where the signs differ: secants, and halves when they crawl.
 * Source: Illinois. */
static double single_root(int degree, const double *c, double width)
{
    double low = 0, high = 1, low_value = c[0], high_value = c[degree];
    for (int i = 0; i < 200 && width * (high - low) > DBL_EPSILON / 4; i++) {
        double t = low + (high - low) * (low_value / (low_value - high_value));
        if (i % 4 == 3 || !(t > low && t < high))
            t = 0.5 * (low + high);
        if (t <= low || t >= high)
            break;
        const double value = bat_bernstein_value(degree, c, t);
        if (value == 0)
            return t;
        if ((value > 0) == (low_value > 0)) {
            low = t;
            low_value = value;
            high_value *= 0.5;
        } else {
            high = t;
            high_value = value;
            low_value *= 0.5;
        }
    }
    return 0.5 * (low + high);
}

/* What touches the place before belongs to it. */
static bool belongs_to(place *last, place found)
{
    if (!(found.a < found.b && last->b == found.a && last->a < last->b))
        return false;
    last->b = found.b;
    last->t = 0.5 * (last->a + last->b);
    return true;
}

static batten_status keep_root(search *s, place found)
{
    if (s->count > 0 && belongs_to(&s->places[s->count - 1], found))
        return BATTEN_OK;
    if (s->count == s->degree)
        return bat_fail(
            BATTEN_INCOMPLETE,
            "a polynomial of degree %d vanishes, within %g, in more places than it may",
            s->degree, s->zero);
    s->places[s->count++] = found;
    return BATTEN_OK;
}

/* Look at one part: drop it, keep its root, or say that it is to be halved. */
static batten_status judge(search *s, part p, const double *c, bool *is_open)
{
    const int n = s->degree;
    int zeros;
    const int changes = variations(n, c, s->zero, &zeros);
    *is_open = false;
    if (changes == 0 && zeros == 0)
        return BATTEN_OK;
    if (zeros == n + 1 || p.depth == DEEPEST)
        return keep_root(s, (place){p.a, p.b, 0.5 * (p.a + p.b)});
    if (changes == 1 && zeros == 0) {
        const double t = p.a + (p.b - p.a) * single_root(n, c, p.b - p.a);
        return keep_root(s, (place){t, t, t});
    }
    *is_open = true;
    return BATTEN_OK;
}

/* From left to right, halving; the stack holds the right halves that wait. */
static batten_status find_places(search *s)
{
    const size_t row = (size_t)(s->degree + 1);
    part stack[DEEPEST + 2] = {{0, 1, 0}};
    batten_status status = BATTEN_OK;
    for (int top = 0; status == BATTEN_OK && top >= 0;) {
        double *c = s->coefficients + (size_t)top * row;
        const part p = stack[top];
        bool is_open;
        status = judge(s, p, c, &is_open);
        if (!is_open) {
            top--;
            continue;
        }
        const double middle = 0.5 * (p.a + p.b);
        bat_bernstein_split(s->degree, c, 0.5, c + row, c);
        stack[top] = (part){middle, p.b, p.depth + 1};
        stack[++top] = (part){p.a, middle, p.depth + 1};
    }
    return status;
}

/* The coefficients on [a, b]. */
static void restrict_to(int degree, const double *c, double a, double b, double *out)
{
    bat_bernstein_split(degree, c, b, out, NULL);
    bat_bernstein_split(degree, out, a / b, NULL, out);
}

/* The order of the root at an end: the first difference there that is not 0. `step` is 1 from
 * the left end. */
static int order_at_end(int degree, const double *c, int step, double zero)
{
    double row[BAT_BERNSTEIN_DEGREE + 1];
    for (int i = 0; i <= degree; i++)
        row[i] = step > 0 ? c[i] : c[degree - i];
    int order = 0;
    for (double limit = zero; order < degree && fabs(row[0]) <= limit; limit *= 2) {
        for (int i = 0; i < degree - order; i++)
            row[i] = row[i + 1] - row[i];
        order++;
    }
    return order;
}

/* Where the derivative of order m - 1 changes sign a root of order m is known far better than
 * from the values. */
static double sharpened(int degree, const double *c, double a, double b, int m, double middle)
{
    double row[BAT_BERNSTEIN_DEGREE + 1];
    memcpy(row, c, (size_t)(degree + 1) * sizeof *row);
    for (int k = 1; k < m; k++)
        for (int i = 0; i <= degree - k; i++)
            row[i] = row[i + 1] - row[i];
    const int n = degree - (m - 1);
    if (!(row[0] * row[n] < 0))
        return middle;
    return a + (b - a) * single_root(n, row, b - a);
}

/* How many roots a place stands for, and where best to put them. `room` ends halfway to the
 * neighbours. */
static bat_root weigh(const search *s, const double *c, place p, double room_a, double room_b,
                      double *scratch)
{
    if (p.a == p.b)
        return (bat_root){p.t, 1};
    if (p.a == 0)
        return (bat_root){0, order_at_end(s->degree, c, 1, s->zero)};
    if (p.b == 1)
        return (bat_root){1, order_at_end(s->degree, c, -1, s->zero)};
    const double width = p.b - p.a;
    const double a = bat_max(room_a, p.a - width), b = bat_min(room_b, p.b + width);
    restrict_to(s->degree, c, a, b, scratch);
    int zeros;
    const int changes = variations(s->degree, scratch, s->zero, &zeros);
    if (changes == 1)
        return (bat_root){p.t, 1};
    const int m = changes > 1 ? changes : 2;
    return (bat_root){sharpened(s->degree, scratch, a, b, bat_min_int(m, s->degree), p.t), m};
}

static void weigh_all(const search *s, const double *c, bat_root *roots)
{
    for (int i = 0; i < s->count; i++) {
        const place p = s->places[i];
        const double room_a = i > 0 ? 0.5 * (s->places[i - 1].b + p.a) : 0;
        const double room_b = i + 1 < s->count ? 0.5 * (p.b + s->places[i + 1].a) : 1;
        roots[i] = weigh(s, c, p, room_a, room_b, s->coefficients);
    }
}

batten_status bat_bernstein_roots(int degree, const double *c, double zero, bat_root *roots,
                                  int *count)
{
    assert(degree >= 0 && degree <= BAT_BERNSTEIN_DEGREE);
    double largest = 0;
    for (int i = 0; i <= degree; i++)
        largest = bat_max(largest, fabs(c[i]));
    if (largest <= zero) {
        *count = -1;
        return BATTEN_OK;
    }
    /* Each halving rounds at most `degree` times on the way to a coefficient, and their errors
     * shrink with it. */
    search s = {.degree = degree,
                .zero = bat_max(zero, 2 * (degree + 1) * DBL_EPSILON * largest)};
    int zeros;
    const int changes = variations(degree, c, s.zero, &zeros);
    if (zeros == 0 && changes < 2) { /* by far the most, and they need no memory */
        *count = changes;
        if (changes == 1)
            roots[0] = (bat_root){single_root(degree, c, 1), 1};
        return BATTEN_OK;
    }
    s.coefficients = bat_array3(DEEPEST + 2, (size_t)(degree + 1), sizeof *s.coefficients);
    s.places = bat_array((size_t)degree, sizeof *s.places);
    batten_status status = s.coefficients && s.places ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(s.coefficients, c, (size_t)(degree + 1) * sizeof *c);
        status = find_places(&s);
    }
    if (status == BATTEN_OK) {
        weigh_all(&s, c, roots);
        *count = s.count;
    }
    bat_release(s.coefficients);
    bat_release(s.places);
    return status;
}
