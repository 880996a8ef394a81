#include "shape/skin_parts.h"

#include <string.h>

batten_skin_options batten_skin_defaults(void)
{
    return (batten_skin_options){
        .size = sizeof(batten_skin_options), .degree = 3, .parameters = BATTEN_CENTRIPETAL};
}

/* ---- checks ---- */

static batten_status check_end(const batten_skin_options *o, const batten_end *end,
                               const char *name)
{
    if (end->kind == BATTEN_END_NOT_A_KNOT || o->periodic)
        return BATTEN_OK;
    if (end->kind == BATTEN_END_CIRCLE || end->kind == BATTEN_END_CURVATURE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a skin cannot have a circle or a curvature at its %s", name);
    if (o->degree % 2 == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "conditions at the %s need an odd degree, and it is %d", name,
                        o->degree);
    if (bat_first_not_finite(end->vector, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the vector at the %s is not finite", name);
    if (end->kind == BATTEN_END_DIRECTION && bat_norm(3, end->vector) == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the direction at the %s has no length", name);
    return BATTEN_OK;
}

static batten_status check(int count, const batten_skin_options *o)
{
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there are %d sections, and a skin needs 2",
                        count);
    if (count > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %d sections; the limit is %d", count,
                        (int)BAT_MAX_MADE_POINTS);
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree across the sections is %d, not 1 to %d",
                        o->degree, BATTEN_MAX_DEGREE);
    if (!isfinite(o->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", o->tolerance);
    if (o->tolerance < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, below 0", o->tolerance);
    batten_status status = check_end(o, &o->start, "start");
    if (status == BATTEN_OK)
        status = check_end(o, &o->end, "end");
    return status;
}

/* ---- the whole ---- */

static batten_status skin(bat_skin *t, const batten_curve *const *sections,
                          batten_skin_report *report, batten_surface **out)
{
    t->placed = bat_array((size_t)t->count, sizeof *t->placed);
    t->unified = bat_array((size_t)t->count, sizeof *t->unified);
    t->deviation = bat_array((size_t)t->count, sizeof *t->deviation);
    batten_status status =
        t->placed && t->unified && t->deviation ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_skin_place(t, sections);
    if (status == BATTEN_OK && t->options->align)
        status = bat_skin_align(t);
    if (status == BATTEN_OK)
        status = bat_skin_unify(t);
    const uint64_t steps = (uint64_t)t->points * (uint64_t)t->count;
    if (status == BATTEN_OK)
        status = bat_work_step(&t->work, steps, 0.5, "skin");
    if (status == BATTEN_OK)
        status = bat_skin_rows(t);
    if (status == BATTEN_OK)
        status = bat_skin_parameters(t);
    if (status == BATTEN_OK)
        status = bat_skin_across(t);
    if (status == BATTEN_OK)
        status = bat_work_step(&t->work, steps, 0.8, "skin");
    batten_surface *surface = NULL;
    if (status == BATTEN_OK)
        status = bat_skin_surface(t, &surface);
    if (status == BATTEN_OK)
        status = bat_skin_inspect(t, surface, report);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

static void release(bat_skin *t)
{
    for (int k = 0; k < t->count; k++) {
        if (t->placed)
            batten_curve_unref(t->placed[k]);
        if (t->unified)
            batten_curve_unref(t->unified[k]);
    }
    bat_release(t->placed);
    bat_release(t->unified);
    bat_release(t->deviation);
    bat_release(t->v);
    bat_release(t->rows);
    bat_release(t->control);
    bat_operator_free(&t->across);
}

batten_status batten_surface_skin(int count, const batten_curve *const *sections,
                                  const batten_skin_options *options, const batten_job *job,
                                  double *v, batten_skin_report *report, batten_surface **out)
{
    const batten_skin_options defaults = batten_skin_defaults();
    bat_skin t = {.count = count, .options = options ? options : &defaults, .work = {job, 0}};
    batten_status status = check(count, t.options);
    if (status != BATTEN_OK)
        return status;
    status = skin(&t, sections, report, out);
    if (status == BATTEN_OK && v)
        memcpy(v, t.v, (size_t)count * sizeof *v);
    release(&t);
    return status;
}
