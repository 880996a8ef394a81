/* The data of all rows, from one generator, so that they are the same on every machine. Knots
 * are uneven: no contestant can take a uniform short cut. */
#include "bench.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* A linear congruential generator with Knuth's multiplier. */
typedef struct {
    uint64_t state;
} generator;

static double in_unit(generator *g)
{
    g->state = g->state * 6364136223846793005u + 1442695040888963407u;
    return (double)(g->state >> 11) * 0x1p-53;
}

static double around_zero(generator *g)
{
    return 2 * in_unit(g) - 1;
}

static generator begin(uint64_t seed)
{
    generator g = {seed * 2862933555777941757u + 3037000493u};
    in_unit(&g);
    in_unit(&g);
    return g;
}

static double *make_knots(int n, int p, double jitter, generator *g)
{
    double *knots = bench_numbers((size_t)(n + p + 1));
    const int spans = n - p;
    for (int i = 0; i <= p; i++) {
        knots[i] = 0;
        knots[n + i] = 1;
    }
    for (int i = 1; i < spans; i++)
        knots[p + i] = (i + jitter * around_zero(g)) / spans;
    return knots;
}

static double greville(const double *knots, int p, int i)
{
    double sum = 0;
    for (int k = 1; k <= p; k++)
        sum += knots[i + k];
    return sum / p;
}

/* A cubic helix of 1000 points with a little noise. */
static bench_curve make_curve(bool rational)
{
    enum { N = 1000 };
    generator g = begin(1);
    bench_curve curve = {N, 3, make_knots(N, 3, 0.3, &g), bench_numbers(3 * N), NULL};
    for (int i = 0; i < N; i++) {
        const double x = (double)i / (N - 1);
        curve.points[3 * i] = 10 * cos(40 * x) + 0.05 * around_zero(&g);
        curve.points[3 * i + 1] = 10 * sin(40 * x) + 0.05 * around_zero(&g);
        curve.points[3 * i + 2] = 20 * x + 0.05 * around_zero(&g);
    }
    if (rational) {
        curve.weights = bench_numbers(N);
        for (int i = 0; i < N; i++)
            curve.weights[i] = 0.5 + in_unit(&g);
    }
    return curve;
}

/* A bicubic wave z = f(x, y) of 100 x 100 points over [0, 10]^2, with x = 10 u, y = 10 v. */
static bench_surface make_surface(bool rational)
{
    enum { N = 100 };
    generator g = begin(2);
    bench_surface surface = {.count = N, .degree = 3, .points = bench_numbers(3 * N * N)};
    surface.knots[0] = make_knots(N, 3, 0.3, &g);
    surface.knots[1] = make_knots(N, 3, 0.3, &g);
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            double *point = surface.points + 3 * (i * N + j);
            point[0] = 10 * greville(surface.knots[0], 3, i);
            point[1] = 10 * greville(surface.knots[1], 3, j);
            point[2] =
                0.8 * cos(1.3 * point[0]) * cos(1.1 * point[1]) + 0.002 * around_zero(&g);
        }
    if (rational) {
        surface.weights = bench_numbers(N * N);
        for (int j = 0; j < N; j++)
            for (int i = 0; i < N; i++)
                surface.weights[i * N + j] = 0.5 + in_unit(&g);
    }
    return surface;
}

/* Ribs of 30 points, each with knots of its own. */
static bench_curve make_section(int k)
{
    enum { N = 30 };
    const double pi = 3.141592653589793, radius = 3 + 0.5 * sin(0.2 * k);
    generator g = begin(100 + (uint64_t)k);
    bench_curve curve = {N, 3, make_knots(N, 3, 0.4, &g), bench_numbers(3 * N), NULL};
    for (int i = 0; i < N; i++) {
        const double a = pi * greville(curve.knots, 3, i);
        curve.points[3 * i] = radius * cos(a);
        curve.points[3 * i + 1] = radius * sin(a) * (1 + 0.2 * sin(3 * a + 0.1 * k));
        curve.points[3 * i + 2] = 0.5 * k + 0.02 * around_zero(&g);
    }
    return curve;
}

/* De Boor's algorithm: what the sections are, for the check. */
static void curve_point(const bench_curve *curve, double u, double *point)
{
    const int p = curve->degree;
    const double *U = curve->knots;
    double rows[4][3];
    int k = p;
    while (k < curve->count - 1 && U[k + 1] <= u)
        k++;
    for (int i = 0; i <= p; i++)
        for (int c = 0; c < 3; c++)
            rows[i][c] = curve->points[3 * (k - p + i) + c];
    for (int r = 1; r <= p; r++)
        for (int i = p; i >= r; i--) {
            const double low = U[k - p + i], t = (u - low) / (U[k + 1 + i - r] - low);
            for (int c = 0; c < 3; c++)
                rows[i][c] = (1 - t) * rows[i - 1][c] + t * rows[i][c];
        }
    for (int c = 0; c < 3; c++)
        point[c] = rows[p][c];
}

static void fill_sections(bench_work *work)
{
    work->sections = malloc(work->count * sizeof *work->sections);
    work->data = bench_numbers(work->count * BENCH_PLACES * 3);
    for (size_t k = 0; k < work->count; k++) {
        work->sections[k] = make_section((int)k);
        for (size_t i = 0; i < BENCH_PLACES; i++)
            curve_point(&work->sections[k], work->u[i],
                        work->data + 3 * (k * BENCH_PLACES + i));
    }
}

static double *make_parameters(size_t count, bool random, uint64_t seed)
{
    double *u = bench_numbers(count);
    generator g = begin(seed);
    for (size_t i = 0; i < count; i++)
        u[i] = random ? in_unit(&g) : ((double)i + 0.5) / (double)count;
    return u;
}

static double *make_cloud(size_t count)
{
    double *points = bench_numbers(3 * count);
    generator g = begin(9);
    for (size_t i = 0; i < count; i++) {
        const double a = 40 * ((double)i + 0.3 * around_zero(&g)) / (double)count;
        points[3 * i] = 10 * cos(a) + 0.2 * sin(9 * a);
        points[3 * i + 1] = 10 * sin(a);
        points[3 * i + 2] = 0.5 * a + 0.1 * cos(7 * a);
    }
    return points;
}

/* A loop of the plane that waves, each point a little off its regular place. */
static double *make_loop(size_t count)
{
    double *points = bench_numbers(2 * count);
    generator g = begin(11);
    for (size_t i = 0; i < count; i++) {
        const double a = 6 * ((double)i + 0.3 * around_zero(&g)) / (double)count;
        points[2 * i] = 10 * cos(a) + 0.2 * sin(9 * a);
        points[2 * i + 1] = 10 * sin(a);
    }
    return points;
}

/* A wave over uneven places, with noise: what a gauge writes down. */
static double *make_values(size_t count, const double *u)
{
    double *values = bench_numbers(count);
    generator g = begin(13);
    for (size_t i = 0; i < count; i++)
        values[i] = sin(40 * u[i]) + 0.1 * around_zero(&g);
    return values;
}

static double *centripetal(size_t count, const double *points)
{
    double *u = bench_numbers(count);
    u[0] = 0;
    for (size_t i = 1; i < count; i++) {
        const double *a = points + 3 * i - 3, *b = a + 3;
        u[i] =
            u[i - 1] + sqrt(sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) +
                                 (b[2] - a[2]) * (b[2] - a[2])));
    }
    for (size_t i = 1; i < count; i++)
        u[i] /= u[count - 1];
    u[count - 1] = 1;
    return u;
}

static double *grid_parameters(size_t count, uint64_t seed)
{
    double *u = bench_numbers(count);
    generator g = begin(seed);
    u[0] = 0;
    for (size_t i = 1; i + 1 < count; i++)
        u[i] = ((double)i + 0.25 * around_zero(&g)) / (double)(count - 1);
    u[count - 1] = 1;
    return u;
}

static double *grid_points(size_t count, const double *u, const double *v)
{
    double *points = bench_numbers(3 * count * count), *point = points;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < count; j++, point += 3) {
            point[0] = 10 * u[i] + 0.1 * sin(5 * v[j]);
            point[1] = 10 * v[j];
            point[2] = sin(8 * u[i]) * cos(7 * v[j]);
        }
    return points;
}

/* Franke's function at places [count][2]. */
static double *franke_values(size_t count, const double *uv)
{
    double *values = bench_numbers(count);
    for (size_t i = 0; i < count; i++) {
        const double x = 9 * uv[2 * i], y = 9 * uv[2 * i + 1];
        values[i] = 0.75 * exp(-((x - 2) * (x - 2) + (y - 2) * (y - 2)) / 4) +
                    0.75 * exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10) +
                    0.5 * exp(-((x - 7) * (x - 7) + (y - 3) * (y - 3)) / 4) -
                    0.2 * exp(-(x - 4) * (x - 4) - (y - 7) * (y - 7));
    }
    return values;
}

/* Knots of a patch, and the points of all: waves side by side, each with noise of its own. */
static void fill_patches(bench_work *work)
{
    enum { N = BENCH_PATCH };
    generator g = begin(71);
    work->surface = (bench_surface){.count = N, .degree = 3};
    for (int k = 0; k < 2; k++)
        work->surface.knots[k] = make_knots(N, 3, 0.2, &g);
    work->surface.points = bench_numbers(3 * N * N * work->count);
    double *point = work->surface.points;
    for (size_t k = 0; k < work->count; k++)
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++, point += 3) {
                point[0] =
                    10 * greville(work->surface.knots[0], 3, i) + 11.0 * (double)(k % 32);
                point[1] =
                    10 * greville(work->surface.knots[1], 3, j) + 11.0 * (double)(k / 32);
                point[2] = 0.5 * cos((1 + 0.001 * (double)k) * point[0]) * cos(1.3 * point[1]) +
                           0.02 * around_zero(&g);
            }
}

/* Arguments of an elementary function; a second one is spread over -10 ... 10. */
static void fill_arguments(bench_work *work)
{
    work->u = make_parameters(work->count, true, 81);
    work->v = make_parameters(work->count, true, 82);
    for (size_t i = 0; i < work->count; i++) {
        const double t = work->u[i];
        work->u[i] = work->by_ratio ? work->low * pow(work->high / work->low, t)
                                    : work->low + (work->high - work->low) * t;
        work->v[i] = 20 * work->v[i] - 10;
    }
}

static double *middles(size_t count, const double *u)
{
    double *v = bench_numbers(count);
    for (size_t i = 0; i + 1 < count; i++)
        v[i] = (u[i] + u[i + 1]) / 2;
    return v;
}

static void fill_files(bench_work *work)
{
    fill_patches(work);
    work->result_count = 3 * BENCH_PATCH * BENCH_PATCH * work->count;
    work->data = bench_numbers(work->result_count);
    for (size_t i = 0; i < work->result_count; i++)
        work->data[i] = work->surface.points[i] / 1e2;
    work->truth = work->data;
}

static size_t surface_numbers(const bench_work *work)
{
    return work->order == 0 ? 3 : work->normals_only ? 6 : 12;
}

/* Curves and surfaces at parameters; false for another kind of work. */
static bool fill_evaluation(bench_work *work)
{
    const size_t n = work->count;
    switch (work->kind) {
    case CURVE_POINTS:
    case CURVE_SINGLE:
        work->curve = make_curve(work->rational);
        work->u = make_parameters(n, work->random, 21);
        work->result_count = n * 3 * (size_t)(work->order + 1);
        break;
    case SURFACE_GRID:
        work->surface = make_surface(work->rational);
        work->u = make_parameters(n, false, 0);
        work->v = make_parameters(n, false, 0);
        work->result_count = n * n * surface_numbers(work);
        break;
    case SURFACE_POINTS:
    case SURFACE_SINGLE:
        work->surface = make_surface(work->rational);
        work->u = make_parameters(n, true, 31);
        work->v = make_parameters(n, true, 32);
        work->result_count = n * surface_numbers(work);
        break;
    default:
        return false;
    }
    return true;
}

/* Rows of points that curves go through; false for another kind of work. */
static bool fill_rows(bench_work *work)
{
    const size_t n = work->count;
    switch (work->kind) {
    case CURVE_THROUGH:
        work->data = make_cloud(n);
        work->truth = work->data;
        work->u = centripetal(n, work->data);
        work->result_count = 3 * n;
        break;
    case FUNCTION_THROUGH:
        work->u = grid_parameters(n, 51);
        work->v = middles(n, work->u);
        work->data = make_values(n, work->u);
        /* Not the end spans: GSL ends Steffen's otherwise than he does, and SciPy Akima's. */
        work->result_count = n - 5;
        break;
    case PLANE_THROUGH:
        work->data = make_loop(n);
        work->truth = work->data;
        work->result_count = 2 * n;
        break;
    default:
        return false;
    }
    return true;
}

static void fill_others(bench_work *work)
{
    const size_t n = work->count;
    switch (work->kind) {
    case TRIANGULATION:
        work->u = make_parameters(2 * n, true, 61);
        work->result_count = 2;
        break;
    case SCATTERED_NEAR:
    case TRIANGLES_THROUGH:
        work->u = make_parameters(2 * n, true, 61);
        work->data = franke_values(n, work->u);
        work->truth = work->data;
        work->result_count = 1;
        break;
    case CURVE_LENGTH:
        work->curve = make_curve(false);
        work->result_count = 1;
        break;
    case WRITE_PATCHES:
    case READ_PATCHES:
        fill_files(work);
        break;
    case ELEMENTARY:
        fill_arguments(work);
        work->result_count = n;
        break;
    case SKIN:
        work->u = make_parameters(BENCH_PLACES, false, 0);
        fill_sections(work);
        work->truth = work->data;
        work->result_count = n * BENCH_PLACES * 3;
        break;
    default:
        work->u = grid_parameters(n, 41);
        work->v = grid_parameters(n, 42);
        work->data = grid_points(n, work->u, work->v);
        work->truth = work->data;
        work->result_count = 3 * n * n;
        break;
    }
}

void bench_fill(bench_work *work)
{
    if (!fill_evaluation(work) && !fill_rows(work))
        fill_others(work);
    /* Coordinates reach 20: this is some hundred roundings of the spans' widths. */
    if (work->within == 0)
        work->within = 1e-11;
}
