/* What every model that was read must survive: being checked, measured, meshed and written. */
#include "survive.h"

#include <batten/base.h>
#include <batten/body.h>

static void write_as(const batten_model *model, batten_format format, bool solids)
{
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = format;
    options.solids = solids;
    if (batten_write_memory(model, &options, NULL, &data, &size) == BATTEN_OK)
        batten_release(data);
}

static void mesh(const batten_model *model, const batten_job *job)
{
    batten_mesh_options options = batten_mesh_defaults();
    batten_model *meshed = NULL;
    options.angle = 1;
    options.most = 5000;
    if (batten_model_meshed(model, &options, job, NULL, &meshed) == BATTEN_OK)
        batten_model_unref(meshed);
}

static void check(const batten_model *model, const batten_job *job)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        batten_body_faults faults;
        batten_body_measures measures;
        if (!object->body)
            continue;
        batten_body_check(object->body, batten_body_view(object->body)->tolerance, job, NULL,
                          &faults);
        batten_body_measure(object->body, 1e-3, job, &measures);
    }
}

void fuzz_survive(const uint8_t *data, size_t size, batten_format format)
{
    batten_limits limits = batten_limits_defaults();
    batten_read_options options = batten_read_defaults();
    batten_job job = BATTEN_JOB;
    batten_model *model = NULL;
    limits.points = 2000;
    limits.entities = 2000;
    options.limits = &limits;
    options.format = format;
    job.work_limit = 10000;
    const batten_status status =
        batten_read_memory((const char *)data, size, &options, NULL, NULL, &model);
    if (status != BATTEN_OK && status != BATTEN_PARTLY_READ)
        return;
    write_as(model, BATTEN_FORMAT_STEP, false);
    write_as(model, BATTEN_FORMAT_IGES, false);
    write_as(model, BATTEN_FORMAT_IGES, true);
    mesh(model, &job);
    check(model, &job);
    batten_model_unref(model);
}
