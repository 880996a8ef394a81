/*
 * The rows of the race: work that every contestant does on the same data, and what a contestant has to offer.
 *
 * A contestant makes its own objects from the data (open), works (run: this alone is timed), and shows what came out in a
 * common form (gather), so that no one pays for another's layout. One that knows several ways enters each, and the fastest
 * counts.
 */
#ifndef BENCH_H
#define BENCH_H
#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    CURVE_POINTS, /* order 0 or 2, all parameters in one call where there is such a call */
    CURVE_SINGLE, /* one call for each parameter */
    SURFACE_GRID, /* order 0; 1: points, both derivatives, unit normals; or points and unit normals */
    SURFACE_POINTS, /* at scattered parameters */
    SURFACE_SINGLE, /* one call for each */
    CURVE_THROUGH,  /* interpolation */
    SURFACE_THROUGH,
    SKIN,              /* the surface through sections with knots of their own */
    FUNCTION_THROUGH,  /* a function of one variable, by its method, and its values between */
    PLANE_THROUGH,     /* a curve through points of the plane, by its method */
    CURVE_LENGTH,      /* arc length of the curve */
    SCATTERED_NEAR,    /* a surface within 1e-3 of values at scattered places */
    TRIANGULATION,     /* the triangles of Delaunay between scattered places */
    TRIANGLES_THROUGH, /* a smooth surface over triangles through scattered values */
    WRITE_PATCHES,     /* a file of patches, one after another in the points of the surface */
    READ_PATCHES,      /* the same file back */
    ELEMENTARY,        /* values of an elementary function, by its number */
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
    int function; /* of ELEMENTARY: its number */
    int order;
    bool normals_only; /* of SURFACE_GRID: points and unit normals, and no derivatives */
    bool rational, random;
    bool iges;        /* of WRITE_ and READ_PATCHES; else STEP */
    bool theirs;      /* of READ_PATCHES: everyone reads the file that Open CASCADE wrote */
    bool of_memory;   /* the peak of a process of its own, in megabytes, and not the time */
    bool is_relative; /* results are compared by their ratios */
    double within;    /* how far results may be apart; 0: 1e-11 */
    double low, high; /* of ELEMENTARY: where its arguments are */
    bool by_ratio;    /* and whether their logarithms are spread */
    size_t count;     /* parameters, or points to pass through; in each direction of a grid */
    const char *unit; /* "ns" for each point, "ms", or "MB" for the peak of memory */
    bench_curve curve;
    bench_surface surface;
    bench_curve *sections; /* [count] */
    double *u, *v, *data;  /* parameters; points or values to pass through */
    size_t result_count;   /* numbers in the common form */
    const double *truth;   /* the result, where the data say it; else NULL */
} bench_work;

/* One way of a contestant to do one kind of work: what it calls. */
typedef struct {
    const char *way; /* NULL ends the list */
    bench_kind kind;
    void *(*open)(const bench_work *work); /* NULL: it does not offer this row */
    void (*run)(void *object);
    void (*gather)(void *object, double *result);
    void (*close)(void *object);
    double (*seconds)(
        void *object); /* CPU time of the last run, by a clock of its own; or NULL */
} bench_entry;

typedef struct {
    const char *name;
    const bench_entry *entries; /* NULL: it is not here */
    const char *package;        /* of Debian, where it comes from; NULL: it is always here */
} bench_peer;

/* The common form of results: CURVE: P, P' / 1e3, P'' / 1e6 by parameter; SURFACE: all points, u slowest, then with
 * derivatives all Su / 1e2 and all Sv / 1e2, then all unit normals; THROUGH: the shape at the parameters of its data;
 * FUNCTION_THROUGH: the values in the middles v; CURVE_LENGTH: the length / 1e3; SKIN: each section at the parameters u
 * [BENCH_PLACES]; SCATTERED_NEAR, TRIANGLES_THROUGH: the first value, when all are met within the tolerance, or 1e-12;
 * TRIANGULATION: the area, and a millionth of the number of triangles; WRITE_ and READ_PATCHES: all control points / 1e2,
 * read back by Batten; ELEMENTARY: the values. */
enum { BENCH_PLACES = 20, BENCH_PATCH = 20 /* points of a patch in each direction */ };

/* What the contestants offer, each list ended by a way that is NULL. */
extern const bench_entry bench_batten[], bench_batten_fits[], bench_batten_exchange[],
    bench_batten_functions[], bench_sisl[], bench_occt[], bench_occt_exchange[], bench_gsl[],
    bench_scipy[], bench_libm[];

/* The rows, and their number. */
extern const bench_work bench_rows[];
extern const size_t bench_row_count;

/* Elementary functions of one or of two arguments, in one order for Batten and for libm. */
typedef union {
    double (*one)(double);
    double (*two)(double, double);
} bench_function;
enum {
    SIN,
    COS,
    TAN,
    ASIN,
    ACOS,
    ATAN,
    EXP,
    EXPM1,
    LOG,
    LOG2,
    LOG10,
    COSH,
    SINH,
    CBRT,
    ATAN2, /* from here on of two */
    HYPOT,
    POW,
    FUNCTION_COUNT
};
void *bench_open_function(const bench_work *work, const bench_function *table);
void bench_run_function(void *object);
void bench_gather_function(void *object, double *result);
void bench_close_function(void *object);

/* Make and release the data of a row (data.c). */
void bench_fill(bench_work *work);
void bench_release(bench_work *work);
double *bench_numbers(size_t count);
/* The file of a row, which who ("batten", "occt") writes. */
void bench_path(const bench_work *work, const char *who, char path[128]);
/* The control points of the patches of a file / 1e2, as Batten reads it. */
void bench_read_back(const bench_work *work, const char *path, double *result);
/* The unit vector of a x b. */
void bench_unit_normal(const double *a, const double *b, double *normal);
/* Point, Su, Sv (those that the row asks for) and unit normal of one place of many, into the common form. */
typedef struct {
    size_t number, count;
} bench_place;
void bench_lay_point(const bench_work *work, bench_place place, const double *jet,
                     const double *normal, double *result);

#ifdef __cplusplus
}
#endif
#endif
