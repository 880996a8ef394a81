/* Skins from sections: options, the order of the steps, and the report. */
#include "base/plural.h"
#include "shape/skin/steps.h"

#include <string.h>

static const batten_surface_skin_options standard = {
    .size = sizeof(batten_surface_skin_options), .degree = 3, .parameters = BATTEN_CENTRIPETAL};

batten_surface_skin_options batten_surface_skin_defaults(void)
{
    return standard;
}

/* ---- checks ---- */

static batten_status check_end(const batten_surface_skin_options *o, const batten_end *end,
                               const char *name)
{
    if (end->kind == BATTEN_END_NOT_A_KNOT || o->closed)
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

static batten_status check_sections(int count, const batten_surface_skin_options *o)
{
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d section%s, and a skin needs 2",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
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
    if (o->turn && o->starts)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "closed sections begin where they are told or turn, not both");
    batten_status status = check_end(o, &o->start, "start");
    if (status == BATTEN_OK)
        status = check_end(o, &o->end, "end");
    return status;
}

/* ---- the whole ---- */

/* A point as the first or last section gets the knots and weights of its neighbour, so that it
 * adds no knots of its own and leaves periodic sections periodic. */
static batten_status shape_tips(bat_skin *t)
{
    for (int end = 0; end < 2; end++) {
        const int tip = end == 0 ? 0 : t->count - 1, next = end == 0 ? 1 : t->count - 2;
        if (!t->point[tip] || t->point[next])
            continue;
        batten_affine all = batten_affine_identity();
        memset(all.m, 0, sizeof all.m);
        const double *P = batten_curve_points(t->placed[tip]);
        double *to[3] = {&all.t[0], &all.t[1], &all.t[2]};
        for (int c = 0; c < t->dimension; c++)
            *to[c] = P[c];
        batten_curve *shaped = NULL;
        const batten_status status = batten_curve_transform(t->placed[next], &all, &shaped);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(t->placed[tip]);
        t->placed[tip] = shaped;
    }
    return BATTEN_OK;
}

/* The sections that the surface must pass: `placed`. */
static batten_status place_sections(bat_skin *t)
{
    const size_t n = (size_t)t->count;
    t->placed = bat_array(n, sizeof *t->placed);
    t->unified = bat_array(n, sizeof *t->unified);
    t->moved = bat_array(n, sizeof *t->moved);
    t->deviation = bat_array(n, sizeof *t->deviation);
    t->point = bat_array(n, sizeof *t->point);
    batten_status status = t->placed && t->unified && t->moved && t->deviation && t->point
                               ? BATTEN_OK
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_skin_place(t);
    if (status == BATTEN_OK)
        status = bat_skin_kinds(t);
    if (status == BATTEN_OK)
        status = bat_skin_align(t);
    if (status == BATTEN_OK)
        status = bat_skin_match(t);
    if (status == BATTEN_OK)
        status = bat_skin_find_corners(t);
    return status == BATTEN_OK ? shape_tips(t) : status;
}

/* Forget the surface that was tried, and what led to it. */
static void forget(bat_skin *t)
{
    for (int k = 0; t->unified && k < t->count; k++) {
        batten_curve_unref(t->unified[k]);
        t->unified[k] = NULL;
    }
    bat_release(t->v);
    bat_release(t->rows);
    bat_release(t->control);
    t->v = t->rows = t->control = NULL;
    bat_operator_free(&t->across);
    t->across = (bat_operator){0};
}

/* From the placed sections to the surface. */
static batten_status attempt(bat_skin *t, batten_surface **out)
{
    forget(t);
    batten_status status = bat_skin_unify(t);
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
        status = bat_skin_inspect(t, surface);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

/* Creases below this angle, in radians, are not seen. */
static const double least_crease = 1e-4;

/* The next cure that may help; *done is false when there is none. */
static batten_status cure(bat_skin *t, bool *done)
{
    *done = false;
    if (t->found.cure == BATTEN_CURE_NONE && !t->rational) {
        const batten_status status = bat_skin_stretch(t);
        *done = t->found.cure != BATTEN_CURE_NONE;
        return status;
    }
    if (t->found.cure < BATTEN_CURE_RESCALED && t->rational && !t->periodic_u) {
        const batten_status status = bat_skin_rescale(t, done);
        if (status != BATTEN_OK || *done)
            return status;
    }
    if (!t->rational || t->found.cure == BATTEN_CURE_POLYNOMIAL || !(t->options->tolerance > 0))
        return BATTEN_OK;
    *done = true;
    return bat_skin_polynomial(t);
}

static batten_status skin(bat_skin *t, batten_surface **out)
{
    const batten_surface_skin_options *o = t->options;
    const bool cures = t->cures;
    batten_surface *surface = NULL;
    batten_status status = BATTEN_OK;
    if (cures && o->tolerance > 0)
        status = bat_skin_stretch(t); /* it saves knots too */
    bool again = status == BATTEN_OK;
    while (again) {
        batten_surface_unref(surface);
        surface = NULL;
        status = attempt(t, &surface);
        const bool negative = status == BATTEN_NOT_COMPATIBLE && o->tolerance > 0;
        again = cures && (negative || (status == BATTEN_OK && t->found.crease > least_crease));
        if (again) {
            bool done = false;
            const batten_status cured = cure(t, &done);
            again = done && cured == BATTEN_OK;
            status = cured == BATTEN_OK ? status : cured;
        }
    }
    t->found.crease = bat_max(t->found.crease, t->noted_crease);
    if (status == BATTEN_OK && t->reports)
        status = bat_skin_order(t);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

batten_status bat_skin_begin(int count, const batten_curve *const *sections,
                             const batten_surface_skin_options *options, bool mixed,
                             bat_skin *t)
{
    *t = (bat_skin){.count = count,
                    .options = options ? options : &standard,
                    .given = sections,
                    .mixed = mixed,
                    .found = {.reversed = -1, .turned = -1}};
    const batten_surface_skin_options *o = t->options;
    t->cures = o->creases == BATTEN_CREASES_CURE ||
               (o->creases == BATTEN_CREASES_WITHIN && o->tolerance > 0);
    const batten_status status = check_sections(count, o);
    return status == BATTEN_OK ? place_sections(t) : status;
}

void bat_skin_end(bat_skin *t)
{
    forget(t);
    for (int k = 0; t->placed && k < t->count; k++)
        batten_curve_unref(t->placed[k]);
    bat_release(t->placed);
    bat_release(t->unified);
    bat_release(t->moved);
    bat_release(t->deviation);
    bat_release(t->point);
}

batten_status bat_surface_skin(int count, const batten_curve *const *sections,
                               const batten_surface_skin_options *options, bool mixed,
                               const batten_job *job, double *v,
                               batten_surface_skin_report *report, batten_surface **out)
{
    bat_skin t;
    batten_status status = bat_skin_begin(count, sections, options, mixed, &t);
    t.work.job = job;
    t.reports = report != NULL;
    if (status == BATTEN_OK)
        status = skin(&t, out);
    if (status == BATTEN_OK && v)
        memcpy(v, t.v, (size_t)count * sizeof *v);
    if (status == BATTEN_OK && report)
        *report = t.found;
    bat_skin_end(&t);
    return status;
}

batten_status batten_surface_skin(batten_curve_row sections,
                                  const batten_surface_skin_options *options,
                                  const batten_job *job, double *v,
                                  batten_surface_skin_report *report, batten_surface **out)
{
    batten_surface_skin_options chosen = batten_surface_skin_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_skin_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    return bat_surface_skin(sections.count, sections.at, &chosen, false, job, v, report, out);
}
