/*
 * The race: rows of work that every contestant does on the same data, checked to agree, then
 * timed.
 *
 * A contestant makes its own objects from the data (open), works (run: this alone is timed),
 * and shows what came out in a common form (gather), so that no one pays for another's layout.
 */
#ifndef BENCH_H
#define BENCH_H
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    CURVE_POINTS,   /* order 0 or 2, all parameters in one call where there is such a call */
    CURVE_SINGLE,   /* one call for each parameter */
    SURFACE_GRID,   /* order 0, or 1 for points and unit normals */
    SURFACE_POINTS, /* the same at scattered parameters */
    SURFACE_SINGLE, /* one call for each */
    CURVE_THROUGH,  /* interpolation */
    SURFACE_THROUGH,
    SKIN,              /* the surface through sections with knots of their own */
    FUNCTION_THROUGH,  /* a function of one variable, by its method */
    PLANE_THROUGH,     /* a curve through points of the plane, by its method */
    CURVE_LENGTH,      /* arc length of the curve */
    SCATTERED_NEAR,    /* a surface within 1e-3 of values at scattered places */
    TRIANGULATION,     /* the triangles of Delaunay between scattered places */
    TRIANGLES_THROUGH, /* a smooth surface over triangles through scattered values */
    WRITE_PATCHES,     /* a file of patches, one after another in the points of the surface */
    READ_PATCHES,      /* the same file back */
    KIND_COUNT
} bench_kind;

/* How FUNCTION_THROUGH and PLANE_THROUGH go through their points. */
typedef enum {
    NATURAL_CUBIC,
    AKIMA,
    STEFFEN,
    TENSION,
    NU_SPLINE,
    LOCAL_CUBIC,
    EULER_SPIRAL,
    ELASTICA
} bench_method;

typedef struct {
    int count, degree;
    double *knots, *points, *weights; /* [count][3]; weights NULL or [count] */
} bench_curve;

typedef struct {
    int count, degree;                   /* the same in both directions */
    double *knots[2], *points, *weights; /* [count_u][count_v][3] */
} bench_surface;

/* A row, and its data. */
typedef struct {
    const char *name;
    bench_kind kind;
    bench_method method;
    int order;
    bool rational, random;
    bool iges;        /* of WRITE_ and READ_PATCHES; else STEP */
    bool theirs;      /* of READ_PATCHES: everyone reads the file that Open CASCADE wrote */
    size_t count;     /* parameters, or points to pass through; in each direction of a grid */
    const char *unit; /* "ns" for each point, "ms", or "MB" for the peak of memory */
    bench_curve curve;
    bench_surface surface;
    bench_curve *sections; /* [count] */
    double *u, *v, *data;  /* parameters; points or values to pass through */
    size_t result_count;   /* numbers in the common form */
} bench_work;

/* What a contestant offers for one kind of work; NULL functions: nothing. */
typedef struct {
    void *(*open)(const bench_work *work);
    void (*run)(void *object);
    void (*gather)(void *object, double *result);
    void (*close)(void *object);
} bench_entry;

/* The common form of results: CURVE: P, P' / 1e3, P'' / 1e6 by parameter; SURFACE: all points,
 * then all unit normals, u slowest; THROUGH: the shape at the parameters of its data,
 * FUNCTION_THROUGH midway between them; CURVE_LENGTH: the length / 1e3;
 * SKIN: each section at the parameters u [BENCH_PLACES]; SCATTERED_NEAR, TRIANGLES_THROUGH: the
 * first value, when all are met within the tolerance, or 1e-12; TRIANGULATION: the same, when
 * the triangles fill the unit square but for a hundredth; WRITE_PATCHES: the share of the faces
 * that the file has; READ_PATCHES: all control points / 1e2. */
enum { BENCH_PLACES = 20, BENCH_PATCH = 20 /* points of a patch in each direction */ };

extern const bench_entry bench_batten[KIND_COUNT], bench_sisl[KIND_COUNT],
    bench_occt[KIND_COUNT], bench_gsl[KIND_COUNT];

/* Make and release the data of a row (data.c). */
void bench_fill(bench_work *work);
void bench_release(bench_work *work);
double *bench_numbers(size_t count);
/* The file of a row, which who ("batten", "occt") writes. */
void bench_path(const bench_work *work, const char *who, char path[128]);
/* How many faces a file has, as text. */
size_t bench_faces(const char *path, bool iges);
/* The unit vector of a x b. */
void bench_unit_normal(const double *a, const double *b, double *normal);

#ifdef __cplusplus
}
#endif
#endif
