/* What Batten's entries hold. */
#ifndef BATTEN_CONTEST_H
#define BATTEN_CONTEST_H
#include "bench.h"

#include <batten/batten.h>

typedef struct {
    const bench_work *work;
    batten_curve *curve;
    batten_chain *chain;
    batten_surface *surface;
    batten_triangles *triangles;
    batten_plane_triangles plane;
    batten_curve **sections;
    double *uv, *out, *normals;
} contest;

/* Ends the process with Batten's message when it is not OK. */
void contest_must(batten_status status);
/* With nothing but the work. */
void *contest_open(const bench_work *work);
void *contest_open_curve(const bench_work *work);
void contest_close(void *object);

#endif
