/*
 * Convex quadratic programs. The equations are eliminated by Householder reflections; the
 * inequalities are then met one by one by a dual active set method. Source: [GI83].
 */
#include "numeric/programs/quadratic_program.h"
#include "base/plural.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

/*
 * The equations turn the space by reflections so that the first `rank` coordinates y of x are
 * determined by them. What is left of H is L Lt in the others, and z = Lt (y - its minimum)
 * makes the program the shortest z with E z >= f.
 */
typedef struct {
    const bat_quadratic_program *of;
    int n, rank, free;
    double *reflectors; /* [n][n], row k: Householder's vector k, from k on */
    double *squares;    /* [n], their squares */
    double *y;          /* [n] */
    double *h;          /* [n][n] turned; then L in its lower right part */
    double *g;          /* [n] turned */
    double *row;        /* [n] */
    double *e, *f;      /* [least_count][free], [least_count] */
    double *z;          /* [n] */
    double *force;      /* [least_count] */
    int *active;        /* [n], which inequalities are held */
    double *r, *d;      /* [n]: multipliers and the way on */
    /* Those that are held are Q R: rows of Q are orthonormal vectors, the first active_count of
     * them theirs; column j of R is row j of `upper`. */
    double *q, *upper; /* [free][free], [n][n] */
    double *w;         /* [n]: the last that was split, by the rows of Q */
    int active_count;
    bat_quadratic_report report;
} program;

static void program_end(program *p)
{
    double *const arrays[] = {p->reflectors, p->squares, p->y, p->h,     p->g,
                              p->row,        p->e,       p->f, p->z,     p->r,
                              p->force,      p->d,       p->q, p->upper, p->w};
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++)
        bat_release(arrays[i]);
    bat_release(p->active);
}

static batten_status program_begin(const bat_quadratic_program *of, program *p)
{
    const size_t n = (size_t)of->count, m = (size_t)of->least_count, size = sizeof(double);
    p->of = of;
    p->n = of->count;
    p->report.redundant = p->report.refused_equation = p->report.refused_inequality = -1;
    p->reflectors = bat_array3(n, n, size);
    p->h = bat_array3(n, n, size);
    p->q = bat_array3(n, n, size);
    p->upper = bat_array3(n, n, size);
    p->e = bat_array3(m, n, size);
    p->f = bat_array(m, size);
    p->force = bat_array(m, size);
    double **const vectors[] = {&p->squares, &p->y, &p->g, &p->row, &p->z, &p->r, &p->d, &p->w};
    bool all = p->reflectors && p->h && p->q && p->upper && p->e && p->f && p->force;
    for (size_t i = 0; i < sizeof vectors / sizeof vectors[0]; i++) {
        *vectors[i] = bat_array(n, size);
        all = all && *vectors[i];
    }
    p->active = bat_array(n, sizeof *p->active);
    return all && p->active ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- the equations ---- */

static void reflect(const program *p, int k, double *v)
{
    const double *by = p->reflectors + (size_t)k * (size_t)p->n;
    const double factor = 2 * bat_dot(p->n - k, by + k, v + k) / p->squares[k];
    for (int i = k; i < p->n; i++)
        v[i] -= factor * by[i];
}

static void reflect_forward(const program *p, double *v)
{
    for (int k = 0; k < p->rank; k++)
        reflect(p, k, v);
}

static void reflect_back(const program *p, double *v)
{
    for (int k = p->rank - 1; k >= 0; k--)
        reflect(p, k, v);
}

/* One more equation: the turned row has numbers for the known coordinates, and is reflected so
 * that one more remains. */
static batten_status add_equation(program *p, int i)
{
    const int n = p->n, k = p->rank;
    const double *given = p->of->equal_rows + (size_t)i * (size_t)n;
    const double value = p->of->equal_values[i], whole = bat_norm(n, given);
    memcpy(p->row, given, (size_t)n * sizeof *p->row);
    reflect_forward(p, p->row);
    const double known = bat_dot(k, p->row, p->y);
    const double left = k < n ? bat_norm(n - k, p->row + k) : 0;
    if (!(left > 32 * n * DBL_EPSILON * whole)) {
        /* Rounding of the equations before it, which is seen through this one. */
        const double allowed = 1e-9 * (fabs(value) + whole * bat_norm(k, p->y));
        p->report.refused_equation = i;
        p->report.missed = fabs(value - known);
        if (!(p->report.missed <= allowed))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "condition %d contradicts those before it: they make it %g, not %g",
                            i + 1, known, value);
        p->report.refused_equation = -1;
        if (p->report.redundant_count++ == 0)
            p->report.redundant = i;
        return BATTEN_OK;
    }
    const double diagonal = p->row[k] > 0 ? -left : left;
    double *by = p->reflectors + (size_t)k * (size_t)n;
    memcpy(by + k, p->row + k, (size_t)(n - k) * sizeof *by);
    by[k] -= diagonal;
    p->squares[k] = bat_dot(n - k, by + k, by + k);
    p->y[k] = (value - known) / diagonal;
    p->rank++;
    return BATTEN_OK;
}

/* ---- the quadratic form on what is free ---- */

static void turn_column(program *p, size_t j)
{
    const size_t n = (size_t)p->n;
    for (size_t i = 0; i < n; i++)
        p->row[i] = p->h[i * n + j];
    reflect_forward(p, p->row);
    for (size_t i = 0; i < n; i++)
        p->h[i * n + j] = p->row[i];
}

static void turn_form(program *p)
{
    const size_t n = (size_t)p->n;
    memcpy(p->h, p->of->hessian, n * n * sizeof *p->h);
    for (size_t i = 0; i < n; i++)
        reflect_forward(p, p->h + i * n);
    for (size_t j = 0; j < n; j++)
        turn_column(p, j);
    if (p->of->linear)
        memcpy(p->g, p->of->linear, n * sizeof *p->g);
    reflect_forward(p, p->g);
    for (int i = p->rank; i < p->n; i++)
        p->g[i] -= bat_dot(p->rank, p->h + (size_t)i * n, p->y);
}

/* Cholesky: L in place, rows and columns from `rank` on. */
static batten_status factor(program *p)
{
    const size_t n = (size_t)p->n;
    const int first = p->rank;
    double largest = 0;
    for (int i = first; i < p->n; i++)
        largest = bat_max(largest, p->h[(size_t)i * n + (size_t)i]);
    for (int j = first; j < p->n; j++) {
        double *row = p->h + (size_t)j * n;
        const double pivot = row[j] - bat_dot(j - first, row + first, row + first);
        if (!(pivot > 8 * p->n * DBL_EPSILON * largest))
            return bat_fail(BATTEN_SINGULAR_SYSTEM,
                            "the conditions leave %d of %d unknowns free, and what is to be "
                            "least does not change with one of them",
                            p->n - first, p->n);
        row[j] = sqrt(pivot);
        for (int i = j + 1; i < p->n; i++) {
            double *below = p->h + (size_t)i * n;
            below[j] = (below[j] - bat_dot(j - first, below + first, row + first)) / row[j];
        }
    }
    return BATTEN_OK;
}

/* v = L^-1 v, in the free coordinates. */
static void solve_lower(const program *p, double *v)
{
    const int first = p->rank;
    for (int i = first; i < p->n; i++) {
        const double *row = p->h + (size_t)i * (size_t)p->n;
        v[i] = (v[i] - bat_dot(i - first, row + first, v + first)) / row[i];
    }
}

static void solve_upper(const program *p, double *v)
{
    for (int i = p->n - 1; i >= p->rank; i--) {
        v[i] /= p->h[(size_t)i * (size_t)p->n + (size_t)i];
        for (int j = p->rank; j < i; j++)
            v[j] -= p->h[(size_t)i * (size_t)p->n + (size_t)j] * v[i];
    }
}

/* ---- inequalities: the shortest z ---- */

/* The equations determine the inequality, and are seen through their rounding. */
static void settle_by_equations(program *p, int i, double whole)
{
    const double size = fabs(p->of->least_values[i]) + whole * bat_norm(p->rank, p->y);
    memset(p->row + p->rank, 0, (size_t)p->free * sizeof *p->row);
    if (fabs(p->f[i]) <= 1e-9 * size)
        p->f[i] = 0;
}

/* Row i of E and f: row.x = row'.y with y = minimum + L^-t z. */
static void prepare_inequality(program *p, int i)
{
    const int n = p->n;
    memcpy(p->row, p->of->least_rows + (size_t)i * (size_t)n, (size_t)n * sizeof *p->row);
    reflect_forward(p, p->row);
    p->f[i] = p->of->least_values[i] - bat_dot(n, p->row, p->y);
    const double whole = bat_norm(n, p->row);
    if (p->free > 0 && bat_norm(p->free, p->row + p->rank) <= 32 * n * DBL_EPSILON * whole) {
        settle_by_equations(p, i, whole);
    }
    solve_lower(p, p->row);
    memcpy(p->e + (size_t)i * (size_t)p->free, p->row + p->rank,
           (size_t)p->free * sizeof *p->e);
}

static const double *row_of(const program *p, int i)
{
    return p->e + (size_t)i * (size_t)p->free;
}

/* The inequality that fails most, in steps of z; -1 when all hold to rounding. */
static int most_violated(const program *p)
{
    int worst = -1;
    double most = 0;
    const double size = bat_norm(p->free, p->z);
    for (int i = 0; i < p->of->least_count; i++) {
        const double *e = row_of(p, i), norm = bat_norm(p->free, e);
        const double fails = p->f[i] - bat_dot(p->free, e, p->z);
        if (fails > 1e-12 * (norm * size + fabs(p->f[i])) && fails > most * norm) {
            worst = i;
            most = norm > 0 ? fails / norm : HUGE_VAL;
        }
    }
    return worst;
}

/* r: w by the triangle of the active constraints. */
static void solve_active(program *p)
{
    const size_t n = (size_t)p->n;
    for (int j = p->active_count - 1; j >= 0; j--) {
        p->r[j] = p->w[j];
        for (int l = j + 1; l < p->active_count; l++)
            p->r[j] -= p->upper[(size_t)l * n + (size_t)j] * p->r[l];
        p->r[j] /= p->upper[(size_t)j * n + (size_t)j];
    }
}

/* What inequality `i` pulls in beyond those that are held: e = sum of r times theirs + d. */
static void split(program *p, int i)
{
    const int m = p->free, k = p->active_count;
    for (int a = 0; a < m; a++)
        p->w[a] = bat_dot(m, p->q + (size_t)a * (size_t)m, row_of(p, i));
    solve_active(p);
    memset(p->d, 0, (size_t)m * sizeof *p->d);
    for (int a = k; a < m; a++)
        for (int c = 0; c < m; c++)
            p->d[c] += p->w[a] * p->q[(size_t)a * (size_t)m + (size_t)c];
}

/* Turn rows a and a + 1 of Q, and the pair (*x, *y) with them, so that *y vanishes. */
static void turn_pair(program *p, int a, double *x, double *y, double *cosine, double *sine)
{
    const double size = bat_hypot(*x, *y);
    const double c = size > 0 ? *x / size : 1, s = size > 0 ? *y / size : 0;
    double *upper = p->q + (size_t)a * (size_t)p->free, *lower = upper + p->free;
    for (int k = 0; k < p->free; k++) {
        const double u = upper[k], l = lower[k];
        upper[k] = c * u + s * l;
        lower[k] = c * l - s * u;
    }
    *x = size;
    *y = 0;
    *cosine = c;
    *sine = s;
}

/* The inequality that was split last is held from now on. */
static void hold(program *p, int i)
{
    const int k = p->active_count;
    double c, s;
    for (int a = p->free - 2; a >= k; a--)
        turn_pair(p, a, &p->w[a], &p->w[a + 1], &c, &s);
    memcpy(p->upper + (size_t)k * (size_t)p->n, p->w, (size_t)p->n * sizeof *p->w);
    p->active[p->active_count++] = i;
}

static void drop(program *p, int place)
{
    const size_t n = (size_t)p->n;
    p->force[p->active[place]] = 0;
    p->active_count--;
    for (int j = place; j < p->active_count; j++) {
        p->active[j] = p->active[j + 1];
        memcpy(p->upper + (size_t)j * n, p->upper + (size_t)(j + 1) * n, n * sizeof *p->upper);
    }
    for (int j = place; j < p->active_count; j++) {
        double *column = p->upper + (size_t)j * n, c, s;
        turn_pair(p, j, &column[j], &column[j + 1], &c, &s);
        for (int l = j + 1; l < p->active_count; l++) {
            double *x = p->upper + (size_t)l * n + j;
            const double u = x[0], v = x[1];
            x[0] = c * u + s * v;
            x[1] = c * v - s * u;
        }
    }
}

/* How far the forces of those held allow to go, and which is the first to vanish. */
static double first_to_vanish(const program *p, int *place)
{
    double least = HUGE_VAL;
    for (int j = 0; j < p->active_count; j++) {
        const double force = p->force[p->active[j]];
        if (p->r[j] > 0 && force < least * p->r[j]) {
            least = force / p->r[j];
            *place = j;
        }
    }
    return least;
}

static batten_status take_up(program *p, int i)
{
    const double *e = row_of(p, i), norm = bat_norm(p->free, e);
    for (;;) {
        int place = 0;
        split(p, i);
        const double reach = first_to_vanish(p, &place);
        const double beyond = bat_dot(p->free, p->d, p->d);
        const bool new =
            p->active_count < p->free &&sqrt(beyond) > 64 * p->n *DBL_EPSILON *norm;
        const double fails = p->f[i] - bat_dot(p->free, e, p->z);
        const double whole = new ? bat_max(fails, 0) / beyond : HUGE_VAL;
        const double step = bat_min(reach, whole);
        p->report.refused_inequality = step < HUGE_VAL ? -1 : i;
        p->report.missed = fails;
        if (!(step < HUGE_VAL))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "inequality %d cannot hold together with the others: it is missed "
                            "by %g",
                            i + 1, fails);
        for (int a = 0; a < p->free && new; a++)
            p->z[a] += step * p->d[a];
        for (int j = 0; j < p->active_count; j++)
            p->force[p->active[j]] -= step * p->r[j];
        p->force[i] += step;
        p->report.steps++;
        if (whole <= reach) {
            hold(p, i);
            return BATTEN_OK;
        }
        drop(p, place);
    }
}

static batten_status shortest(program *p)
{
    /* Each step makes the least larger; rounding might make it run in a ring. */
    const int limit = 100 + 20 * (p->n + p->of->least_count);
    for (int i = most_violated(p); i >= 0; i = most_violated(p)) {
        if (p->report.steps > limit)
            return bat_fail(BATTEN_INCOMPLETE,
                            "%d step%s did not find out which of %d inequalities press", limit,
                            bat_plural(limit), p->of->least_count);
        const batten_status status = take_up(p, i);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status solve(program *p)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < p->of->equal_count && status == BATTEN_OK; i++)
        status = add_equation(p, i);
    if (status != BATTEN_OK)
        return status;
    p->free = p->n - p->rank;
    turn_form(p);
    status = factor(p);
    if (status != BATTEN_OK)
        return status;
    solve_lower(p, p->g);
    solve_upper(p, p->g);
    memcpy(p->y + p->rank, p->g + p->rank, (size_t)p->free * sizeof *p->y);
    for (int i = 0; i < p->of->least_count; i++)
        prepare_inequality(p, i);
    for (int a = 0; a < p->free; a++)
        p->q[(size_t)a * (size_t)p->free + (size_t)a] = 1;
    status = shortest(p);
    /* From z to y. */
    memcpy(p->g + p->rank, p->z, (size_t)p->free * sizeof *p->g);
    solve_upper(p, p->g);
    for (int i = p->rank; i < p->n; i++)
        p->y[i] += p->g[i];
    reflect_back(p, p->y);
    return status;
}

batten_status bat_quadratic_program_solve(const bat_quadratic_program *of, double *x,
                                          double *forces, bat_quadratic_report *report)
{
    assert(of->count >= 1 && of->equal_count >= 0 && of->least_count >= 0);
    program p = {.of = NULL};
    batten_status status = program_begin(of, &p);
    if (status == BATTEN_OK)
        status = solve(&p);
    if (status == BATTEN_OK && bat_first_not_finite(p.y, (size_t)p.n) < (size_t)p.n)
        status = bat_fail(BATTEN_OVERFLOW, "a solution beyond the numbers");
    if (status == BATTEN_OK) {
        memcpy(x, p.y, (size_t)p.n * sizeof *x);
        if (forces && of->least_count > 0)
            memcpy(forces, p.force, (size_t)of->least_count * sizeof *forces);
        p.report.active_count = p.active_count;
    }
    if (report && (status == BATTEN_OK || status == BATTEN_NOT_COMPATIBLE))
        *report = p.report;
    program_end(&p);
    return status;
}
