/* Batten on files of patches, and what it finds in those of others. */
#include "bench.h"

#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

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

static double *add_points(const batten_surface *surface, double *to, const double *end)
{
    const size_t size = 3 * BENCH_PATCH * BENCH_PATCH;
    if (!surface || to + size > end) {
        fprintf(stderr, "bench: batten: a patch is no B-spline of its size, or one too many\n");
        exit(1);
    }
    const double *points = batten_surface_points(surface);
    for (size_t i = 0; i < size; i++)
        *to++ = points[i] / 1e2;
    return to;
}

/* Patches lie in the model as surfaces or as faces of bodies, or in definitions that instances place. */
static void gather_model(const bench_work *work, const batten_model *model, double *result)
{
    const double *end = result + work->result_count;
    batten_model *flat = NULL;
    must(batten_model_flat(model, &flat));
    for (int k = 0; k < batten_model_count(flat); k++) {
        const batten_object *found = batten_model_object(flat, k);
        if (found->kind == BATTEN_OBJECT_SURFACE)
            result = add_points(found->surface, result, end);
        else if (found->kind == BATTEN_OBJECT_BODY)
            for (int f = 0; f < batten_body_view(found->body)->face_count; f++)
                result =
                    add_points(batten_body_view(found->body)->faces[f].surface, result, end);
    }
    batten_model_unref(flat);
    if (result != end) {
        fprintf(stderr, "bench: batten: patches are missing in the file\n");
        exit(1);
    }
}

void bench_read_back(const bench_work *work, const char *path, double *result)
{
    batten_model *model = NULL;
    must(batten_read_file(path, NULL, NULL, NULL, &model));
    gather_model(work, model, result);
    batten_model_unref(model);
}

static void gather_write(void *object, double *result)
{
    const contest *c = object;
    bench_read_back(c->work, c->path, result);
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
    gather_model(c->work, c->model, result);
}

static void close_contest(void *object)
{
    contest *c = object;
    batten_model_unref(c->model);
    free(c);
}

const bench_entry bench_batten_exchange[] = {
    {"batten_write_file", WRITE_PATCHES, open_write, run_write, gather_write, close_contest,
     NULL},
    {"batten_read_file", READ_PATCHES, open_read, run_read, gather_read, close_contest, NULL},
    {.way = NULL},
};
