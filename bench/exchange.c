/* Batten on files of patches. */
#include "exchange.h"

#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const bench_work *work;
    batten_model *model;
    char path[128];
} contest;

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: batten: %s\n", batten_message());
    exit(1);
}

static batten_model *patches(const bench_work *work)
{
    const bench_surface *s = &work->surface;
    const batten_axis u = {s->degree, s->count, s->knots[0], false},
                      v = {s->degree, s->count, s->knots[1], false};
    const size_t size = 3 * (size_t)s->count * (size_t)s->count;
    batten_model *model = NULL;
    must(batten_model_create(0.001, &model));
    for (size_t k = 0; k < work->count; k++) {
        batten_surface *surface = NULL;
        must(batten_surface_create(3, &u, &v, s->points + k * size, NULL, &surface));
        must(batten_model_add(model, &(batten_object){.name = "patch",
                                                      .kind = BATTEN_OBJECT_SURFACE,
                                                      .surface = surface}));
        batten_surface_unref(surface);
    }
    return model;
}

static void *open_write(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    if (!c)
        exit(1);
    c->work = work;
    c->model = patches(work);
    bench_path(work, "batten", c->path);
    return c;
}

static void run_write(void *object)
{
    const contest *c = object;
    must(batten_write_file(c->model, c->path, NULL, NULL));
}

static void gather_write(void *object, double *result)
{
    const contest *c = object;
    *result = (double)bench_faces(c->path, c->work->iges) / (double)c->work->count;
}

static void *open_read(const bench_work *work)
{
    contest *c = open_write(work);
    if (work->theirs)
        bench_path(work, "occt", c->path);
    else
        run_write(c);
    batten_model_unref(c->model);
    c->model = NULL;
    return c;
}

static void run_read(void *object)
{
    contest *c = object;
    batten_model_unref(c->model);
    c->model = NULL;
    must(batten_read_file(c->path, NULL, NULL, NULL, &c->model));
}

static void gather_read(void *object, double *result)
{
    const contest *c = object;
    const size_t size = 3 * BENCH_PATCH * BENCH_PATCH;
    for (int k = 0; k < (int)c->work->count; k++) {
        const batten_object *found = batten_model_object(c->model, k);
        const batten_surface *surface =
            found->body ? batten_body_view(found->body)->faces[0].surface : found->surface;
        const double *points = batten_surface_points(surface);
        for (size_t i = 0; i < size; i++)
            result[(size_t)k * size + i] = points[i] / 1e2;
    }
}

static void close_contest(void *object)
{
    contest *c = object;
    batten_model_unref(c->model);
    free(c);
}

const bench_entry bench_batten_write = {open_write, run_write, gather_write, close_contest},
                  bench_batten_read = {open_read, run_read, gather_read, close_contest};
