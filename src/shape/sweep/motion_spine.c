/* Frames that go along a spine: which way they look, how large they are, how they turn, and
 * what happens at corners. */
#include "shape/sweep/motion_spine.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include <batten/curvature.h>
#include <batten/measure.h>

#include <string.h>

enum { MOST_NODES = 1 << 22 };

static void spine_free(bat_motion *motion)
{
    bat_spine_motion *m = (bat_spine_motion *)(void *)motion;
    batten_curve_unref(m->spine);
    batten_curve_unref(m->guide);
    for (int i = 0; i < 3; i++)
        batten_curve_unref(m->laws[i]);
    bat_release(m->u);
    bat_release(m->length);
    bat_release(m->x);
    bat_release(m->runs);
    bat_release(m);
}

/* ---- building ---- */

typedef struct {
    bat_spine_motion *m;
    const batten_surface_sweep_options *options;
    double *knots;
    int knot_count;
    batten_surface_sweep_report *report;
} building;

/* ---- breaks ---- */

/* Where a share of the way ends. */
static batten_status place_of_share(const bat_spine_motion *m, double share, double *u)
{
    const double length = share * m->total;
    return batten_curve_at_length(m->spine, 1, &length, BAT_EXACT * m->total, u);
}

static int count_law_knots(const bat_spine_motion *m)
{
    int count = 0;
    for (int i = 0; i < 3; i++)
        if (m->laws[i])
            count += batten_curve_spans(m->laws[i], NULL) - 2;
    return count;
}

/* Put u among the breaks, unless one is there. */
static void add_break(bat_motion *motion, double u, double near)
{
    int i = 0;
    while (i < motion->break_count && motion->breaks[i] < u)
        i++;
    if ((i > 0 && u - motion->breaks[i - 1] <= near) ||
        (i < motion->break_count && motion->breaks[i] - u <= near))
        return;
    memmove(motion->breaks + i + 1, motion->breaks + i,
            (size_t)(motion->break_count - i) * sizeof *motion->breaks);
    motion->breaks[i] = u;
    motion->break_count++;
}

static batten_status add_law_breaks(building *b)
{
    bat_spine_motion *m = b->m;
    const double near = BAT_MEANT_SAME * (b->knots[b->knot_count - 1] - b->knots[0]);
    for (int i = 0; i < 3; i++) {
        if (!m->laws[i])
            continue;
        const int count = batten_curve_spans(m->laws[i], NULL);
        double *knots = bat_array((size_t)count, sizeof *knots);
        if (!knots)
            return BATTEN_OUT_OF_MEMORY;
        batten_curve_spans(m->laws[i], knots);
        batten_status status = BATTEN_OK;
        for (int k = 1; k + 1 < count && status == BATTEN_OK; k++) {
            double at;
            status =
                place_of_share(m, (knots[k] - knots[0]) / (knots[count - 1] - knots[0]), &at);
            if (status == BATTEN_OK)
                add_break(&m->base, at, near);
        }
        bat_release(knots);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status check_law(const batten_curve *law, const char *name)
{
    if (law && batten_curve_dimension(law) != 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the law of the %s has dimension %d, not 1", name,
                        batten_curve_dimension(law));
    return BATTEN_OK;
}

static batten_status check_options(const batten_surface_sweep_options *o)
{
    batten_status status = check_law(o->scale, "scale");
    if (status == BATTEN_OK)
        status = check_law(o->scale_y, "scale in y");
    if (status == BATTEN_OK)
        status = check_law(o->twist, "twist");
    if (status == BATTEN_OK && o->scale_y && !o->scale)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there is a scale in y, and none in x");
    if (status == BATTEN_OK && o->scale)
        status = bat_spine_check_scale(o->scale, "scale");
    if (status == BATTEN_OK && o->scale_y)
        status = bat_spine_check_scale(o->scale_y, "scale in y");
    if (status == BATTEN_OK && o->up && o->guide)
        status =
            bat_fail(BATTEN_BAD_ARGUMENT, "the frames cannot look both upward and at a guide");
    if (status == BATTEN_OK && o->up && !isfinite(bat_vec3_norm(*o->up)))
        status =
            bat_fail(BATTEN_NOT_FINITE, "upward is (%g, %g, %g)", o->up->x, o->up->y, o->up->z);
    if (status == BATTEN_OK && o->up && bat_vec3_norm(*o->up) == 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the upward direction has no length");
    return status;
}

static batten_status take_spine(bat_spine_motion *m, const batten_curve *spine,
                                const batten_surface_sweep_options *o)
{
    m->kind = o->frames;
    m->has_up = o->up != NULL;
    if (o->up)
        m->up = *o->up;
    const batten_curve *laws[3] = {o->scale, o->scale_y, o->twist};
    for (int i = 0; i < 3; i++)
        m->laws[i] = laws[i] ? batten_curve_ref(laws[i]) : NULL;
    batten_status status = batten_curve_to_dimension(spine, 3, &m->spine);
    if (status == BATTEN_OK && o->guide)
        status = batten_curve_to_dimension(o->guide, 3, &m->guide);
    if (status == BATTEN_OK)
        m->base.size =
            bat_largest(3 * batten_curve_point_count(m->spine), batten_curve_points(m->spine));
    return status;
}

static batten_status make_room(building *b)
{
    bat_spine_motion *m = b->m;
    const size_t spans = (size_t)b->knot_count - 1;
    if (spans * (BAT_SPINE_STEPS + 1) > MOST_NODES)
        return bat_fail(BATTEN_TOO_LARGE, "a spine of %zu spans is too long", spans);
    const size_t nodes = spans * (BAT_SPINE_STEPS + 1) + 1;
    const size_t breaks = (size_t)b->knot_count + (size_t)count_law_knots(m);
    b->knots = bat_array(spans + 1, sizeof *b->knots);
    m->u = bat_array(nodes, sizeof *m->u);
    m->length = bat_array(nodes, sizeof *m->length);
    m->x = bat_array(nodes, sizeof *m->x);
    m->runs = bat_array(spans, sizeof *m->runs);
    m->base.breaks = bat_array(breaks, sizeof *m->base.breaks);
    m->base.smoothness = bat_array(breaks, sizeof *m->base.smoothness);
    return b->knots && m->u && m->length && m->x && m->runs && m->base.breaks &&
                   m->base.smoothness
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

static batten_status check_length(const building *b)
{
    const double least = bat_max(b->options->tolerance, BAT_ROUNDING * b->m->base.size);
    if (!(b->m->total > least))
        return bat_fail(BATTEN_COINCIDENT,
                        "the spine is %g long, no more than the tolerance of %g", b->m->total,
                        least);
    b->report->length = b->m->total;
    return BATTEN_OK;
}

/* Frenet frames, and those that look upward, turn over where what they look at passes the
 * tangent. */
static batten_status check_turns(const bat_spine_motion *m)
{
    if (!m->has_up && !m->guide && m->kind != BATTEN_FRAME_FRENET)
        return BATTEN_OK;
    for (int k = 0; k < m->run_count; k++) {
        batten_vec3 before = {0, 0, 0};
        for (int i = m->runs[k].first; i <= m->runs[k].last; i++) {
            const bool last = i == m->runs[k].last;
            bat_bare_frame f;
            const batten_status status = bat_spine_frame(
                m, last ? i - 1 : i, m->u[i], last ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &f);
            if (status != BATTEN_OK)
                return status;
            const batten_vec3 x = bat_jet3_in_v(&f.x, 0);
            if (bat_vec3_dot(before, x) < 0)
                return bat_fail(BATTEN_SINGULAR_HERE,
                                "the frames turn over between %.17g and %.17g of the spine",
                                m->u[i - 1], m->u[i]);
            before = x;
        }
    }
    return BATTEN_OK;
}

static batten_status build_motion(building *b)
{
    bat_spine_motion *m = b->m;
    b->knot_count = batten_curve_spans(m->spine, NULL);
    batten_status status = make_room(b);
    if (status != BATTEN_OK)
        return status;
    batten_curve_spans(m->spine, b->knots);
    memcpy(m->base.breaks, b->knots, (size_t)b->knot_count * sizeof *b->knots);
    m->base.break_count = b->knot_count;
    status = bat_spine_lay_nodes(m, b->knot_count, b->knots, b->options->corners);
    if (status == BATTEN_OK)
        status = bat_spine_measure(m);
    if (status == BATTEN_OK)
        status = check_length(b);
    if (status == BATTEN_OK)
        status = bat_spine_frame_runs(m, b->options->x);
    if (status == BATTEN_OK)
        status = check_turns(m);
    if (status == BATTEN_OK)
        status = bat_spine_close(m);
    if (status == BATTEN_OK)
        b->report->turn = -m->turn;
    if (status == BATTEN_OK && b->options->corners == BATTEN_CORNER_MITRE)
        status = bat_spine_mitre(m);
    if (status == BATTEN_OK)
        status = add_law_breaks(b);
    if (status == BATTEN_OK)
        status = bat_motion_find_smoothness(&m->base);
    return status;
}

batten_status bat_motion_along(const batten_curve *spine,
                               const batten_surface_sweep_options *options, bool flat,
                               bat_motion **out, batten_surface_sweep_report *report)
{
    batten_status status = check_options(options);
    if (status != BATTEN_OK)
        return status;
    bat_spine_motion *m = bat_array(1, sizeof *m);
    if (!m)
        return BATTEN_OUT_OF_MEMORY;
    m->base.pose = bat_spine_pose;
    m->base.free = spine_free;
    m->base.flat = flat;
    building b = {.m = m, .options = options, .report = report};
    status = take_spine(m, spine, options);
    if (status == BATTEN_OK)
        status = build_motion(&b);
    bat_release(b.knots);
    if (status == BATTEN_OK)
        *out = &m->base;
    else
        bat_motion_free(&m->base);
    return status;
}
