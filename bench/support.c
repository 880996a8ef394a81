/* What the contestants share. */
#include "bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double *bench_numbers(size_t count)
{
    double *numbers = malloc((count ? count : 1) * sizeof *numbers);
    if (!numbers) {
        perror("bench");
        exit(1);
    }
    return numbers;
}

void bench_release(bench_work *work)
{
    free(work->curve.knots);
    free(work->curve.points);
    free(work->curve.weights);
    free(work->surface.knots[0]);
    free(work->surface.knots[1]);
    free(work->surface.points);
    free(work->surface.weights);
    for (size_t i = 0; work->sections && i < work->count; i++) {
        free(work->sections[i].knots);
        free(work->sections[i].points);
    }
    free(work->sections);
    free(work->u);
    free(work->v);
    free(work->data);
}

void bench_path(const bench_work *work, const char *who, char path[128])
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, 128, "%.80s/batten-bench-%s.%s", folder ? folder : "/tmp", who,
             work->iges ? "igs" : "step");
}

void bench_unit_normal(const double *a, const double *b, double *normal)
{
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
    const double z = a[0] * b[1] - a[1] * b[0], length = sqrt(x * x + y * y + z * z);
    normal[0] = x / length;
    normal[1] = y / length;
    normal[2] = z / length;
}

void bench_lay_point(const bench_work *work, bench_place place, const double *jet,
                     const double *normal, double *result)
{
    const size_t i = 3 * place.number, block = 3 * place.count;
    for (size_t k = 0; k < 3; k++) {
        double *to = result + i + k;
        *to = jet[k];
        if (work->order == 0)
            continue;
        if (!work->normals_only) {
            *(to += block) = jet[3 + k] / 1e2;
            *(to += block) = jet[6 + k] / 1e2;
        }
        *(to += block) = normal[k];
    }
}
