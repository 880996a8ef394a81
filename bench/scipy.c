/*
 * SciPy on the workloads: peer_scipy.py is run in a process that obeys lines as the contestants obey letters, and reads its
 * own CPU clock. The data go there in files of doubles, results come back through the pipe.
 */
#define _XOPEN_SOURCE 700
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct {
    const bench_work *work;
    pid_t process;
    FILE *ask, *answer;
    double seconds;
} contest;

static void must(bool good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "bench: scipy: %s\n", what);
    exit(1);
}

/* Where the numbers of one array are: in the working folder of the script. */
static void file_of(const char *name, char path[128])
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, 128, "%.80s/batten-bench-%s.f64", folder ? folder : "/tmp", name);
}

static void save(const char *name, const double *numbers, size_t count)
{
    char path[128];
    file_of(name, path);
    FILE *file = fopen(path, "wb");
    must(file != NULL, "no file for its data");
    must(!numbers || fwrite(numbers, sizeof *numbers, count, file) == count,
         "no room for its data");
    must(fclose(file) == 0, "no room for its data");
}

static size_t data_count(const bench_work *w)
{
    switch (w->kind) {
    case CURVE_THROUGH:
        return 3 * w->count;
    case SURFACE_THROUGH:
        return 3 * w->count * w->count;
    default:
        return w->count;
    }
}

static void save_work(const bench_work *w)
{
    const size_t n = (size_t)w->curve.count, m = (size_t)w->surface.count;
    const bool is_scattered =
        w->kind == SCATTERED_NEAR || w->kind == TRIANGULATION || w->kind == TRIANGLES_THROUGH;
    save("u", w->u, is_scattered ? 2 * w->count : w->count);
    save("v", w->v, w->count);
    save("data", w->data, data_count(w));
    save("knots", w->curve.knots, n + (size_t)w->curve.degree + 1);
    save("points", n ? w->curve.points : w->surface.points, n ? 3 * n : 3 * m * m);
    save("weights", n ? w->curve.weights : w->surface.weights, n ? n : m * m);
    save("knots-u", w->surface.knots[0], m + (size_t)w->surface.degree + 1);
    save("knots-v", w->surface.knots[1], m + (size_t)w->surface.degree + 1);
}

static void remove_files(void)
{
    static const char *const names[] = {"u",      "v",       "data",    "knots",
                                        "points", "weights", "knots-u", "knots-v"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[128];
        file_of(names[i], path);
        remove(path);
    }
}

/* The arguments of the script are the way and what of the row it needs to know. */
static void start_script(contest *c, const char *way)
{
    int there[2], back[2];
    char order[8], normals[8];
    snprintf(order, sizeof order, "%d", c->work->order);
    snprintf(normals, sizeof normals, "%d", c->work->normals_only);
    must(pipe(there) == 0 && pipe(back) == 0, "no pipe");
    c->process = fork();
    if (c->process == 0) {
        dup2(there[0], STDIN_FILENO);
        dup2(back[1], STDOUT_FILENO);
        close(there[1]);
        close(back[0]);
        setenv("OPENBLAS_NUM_THREADS", "1", 1);
        setenv("OMP_NUM_THREADS", "1", 1);
        setenv("MALLOC_MMAP_THRESHOLD_", "33554432", 1);
        setenv("MALLOC_TRIM_THRESHOLD_", "1073741824", 1);
        execl(BENCH_PYTHON, BENCH_PYTHON, BENCH_SCIPY, way, order, normals, (char *)NULL);
        _exit(127);
    }
    close(there[0]);
    close(back[1]);
    c->ask = fdopen(there[1], "w");
    c->answer = fdopen(back[0], "r");
    must(c->process > 0 && c->ask && c->answer, "no process");
}

static double told(contest *c, const char *line)
{
    char reply[64];
    fputs(line, c->ask);
    must(fflush(c->ask) == 0 && fgets(reply, sizeof reply, c->answer), "its script ended");
    return strtod(reply, NULL);
}

static void *start(const bench_work *work, const char *way)
{
    contest *c = calloc(1, sizeof *c);
    must(c != NULL, "no memory");
    c->work = work;
    save_work(work);
    start_script(c, way);
    told(c, "ready\n");
    remove_files();
    return c;
}

static void run_script(void *object)
{
    contest *c = object;
    c->seconds = told(c, "run\n");
}

static double script_seconds(void *object)
{
    return ((const contest *)object)->seconds;
}

static void gather_script(void *object, double *result)
{
    contest *c = object;
    told(c, "show\n");
    must(fread(result, sizeof *result, c->work->result_count, c->answer) ==
             c->work->result_count,
         "its result is too short");
}

static void close_script(void *object)
{
    contest *c = object;
    fclose(c->ask);
    fclose(c->answer);
    waitpid(c->process, NULL, 0);
    free(c);
}

#define WAY(number, name, kind, condition)             \
    static void *open_##number(const bench_work *work) \
    {                                                  \
        return (condition) ? start(work, name) : NULL; \
    }
#define ENTRY(number, name, kind)                                                          \
    {                                                                                      \
        name, kind, open_##number, run_script, gather_script, close_script, script_seconds \
    }
#define WAYS(DO)                                                              \
    DO(1, "BSpline", CURVE_POINTS, !work->rational)                           \
    DO(2, "PPoly", CURVE_POINTS, work->order == 0 || !work->rational)         \
    DO(3, "splev", CURVE_POINTS, !work->rational)                             \
    DO(4, "bisplev", SURFACE_GRID, !work->rational)                           \
    DO(5, "design_matrix", SURFACE_GRID, work->order == 0 || !work->rational) \
    DO(6, "BivariateSpline.ev", SURFACE_POINTS, !work->rational)              \
    DO(7, "make_interp_spline", CURVE_THROUGH, true)                          \
    DO(8, "make_interp_spline, twice", SURFACE_THROUGH, true)                 \
    DO(9, "RectBivariateSpline", SURFACE_THROUGH, true)                       \
    DO(10, "CubicSpline", FUNCTION_THROUGH, work->method == NATURAL_CUBIC)    \
    DO(11, "Akima1DInterpolator", FUNCTION_THROUGH, work->method == AKIMA)    \
    DO(12, "SmoothBivariateSpline", SCATTERED_NEAR, work->count <= 100000)    \
    DO(13, "Delaunay", TRIANGULATION, true)                                   \
    DO(14, "CloughTocher2DInterpolator", TRIANGLES_THROUGH, true)

WAYS(WAY)

#define ENTRIES(number, name, kind, condition) ENTRY(number, name, kind),

const bench_entry bench_scipy[] = {WAYS(ENTRIES){.way = NULL}};
