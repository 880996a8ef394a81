/* Frames that go along a spine: which way they look, how large they are, how they turn, and
 * what happens at corners. */
#include "shape/motion_spine.h"
#include "numeric/vector.h"
#include <batten/inspect.h>

#include <string.h>

enum {
    STEPS = 64, /* nodes of a span */
    MOST_NODES = 1 << 22
};

/* ---- the pose ---- */

static const bat_spine_motion *motion_of(const bat_motion *motion)
{
    return (const bat_spine_motion *)(const void *)motion;
}

/* The run that holds u: of two that meet there, by the side. */
static const bat_spine_run *run_at(const bat_spine_motion *m, double u, batten_side side)
{
    int k = 0;
    while (k + 1 < m->run_count) {
        const double end = m->u[m->runs[k].last];
        if (u < end || (u == end && side == BATTEN_FROM_LEFT))
            break;
        k++;
    }
    return &m->runs[k];
}

/* The last node of the run at or before u; not the last of the run. */
static int node_before(const bat_spine_motion *m, const bat_spine_run *r, double u)
{
    int low = r->first, high = r->last;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (m->u[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void put_pose(const bat_bare_frame *f, const bat_jet *share, bat_pose *out)
{
    const bat_jet3 *columns[4] = {&f->x, &f->y, &f->z, &f->point};
    for (int k = 0; k <= BAT_POSE_ORDER; k++) {
        for (int c = 0; c < 4; c++) {
            const batten_vec3 at = bat_jet3_in_v(columns[c], k);
            memcpy(out->d[k][c], (double[3]){at.x, at.y, at.z}, sizeof out->d[k][c]);
        }
        out->share[k] = bat_jet_in_v(share, k);
    }
}

batten_status bat_spine_pose(const bat_motion *motion, double v, batten_side side,
                             bat_pose *out)
{
    const bat_spine_motion *m = motion_of(motion);
    const bat_spine_run *r = run_at(m, v, side);
    const int node = node_before(m, r, v);
    bat_bare_frame f;
    double length = 0;
    batten_status status = bat_spine_frame(m, node, v, side, &f);
    if (status == BATTEN_OK)
        status = bat_spine_length(m, m->u[node], v, &length);
    if (status != BATTEN_OK)
        return status;
    length += m->length[node];
    const bat_jet share = bat_share(length, &f.speed, m->total);
    status = bat_spine_turn(m, &share, side, &f);
    if (status == BATTEN_OK)
        status = bat_spine_scale(m, &share, side, &f);
    if (status != BATTEN_OK)
        return status;
    bat_spine_lean(m, r, length, &f);
    put_pose(&f, &share, out);
    return BATTEN_OK;
}

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

/* Nodes and runs: a new run, with a node of its own, begins at every corner. */
typedef struct {
    bat_spine_motion *m;
    const batten_sweep_options *options;
    double *knots;
    int knot_count;
    batten_sweep_report *report;
} building;

/* The angle between the tangents on both sides of a knot. */
static batten_status corner_at(const bat_spine_motion *m, double u, double *angle)
{
    batten_vec3 point, tangent[2];
    batten_status status = bat_spine_tangent(m, u, BATTEN_FROM_LEFT, &point, &tangent[0]);
    if (status == BATTEN_OK)
        status = bat_spine_tangent(m, u, BATTEN_FROM_RIGHT, &point, &tangent[1]);
    if (status == BATTEN_OK)
        *angle = atan2(bat_vec3_norm(bat_vec3_cross(tangent[0], tangent[1])),
                       bat_vec3_dot(tangent[0], tangent[1]));
    return status;
}

static batten_status check_corner(const building *b, double u, double angle)
{
    const double degrees = angle * 180 / BAT_PI;
    if (angle > BAT_PI - 1e-3)
        return bat_fail(BATTEN_SINGULAR_HERE, "the spine turns back at %.17g", u);
    if (b->options->corners != BATTEN_CORNER_REFUSE)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "the spine has a corner of %g degrees at %.17g: ask for a mitre, or split it "
        "there",
        degrees, u);
}

static void begin_run(bat_spine_motion *m, double u)
{
    m->runs[m->run_count++] = (bat_spine_run){.first = m->node_count, .last = m->node_count};
    m->u[m->node_count++] = u;
}

static batten_status lay_nodes(building *b)
{
    bat_spine_motion *m = b->m;
    begin_run(m, b->knots[0]);
    for (int s = 0; s + 1 < b->knot_count; s++) {
        const double low = b->knots[s], high = b->knots[s + 1];
        double angle = 0;
        if (s > 0) {
            const batten_status status = corner_at(m, low, &angle);
            if (status != BATTEN_OK)
                return status;
        }
        /* A smaller bend is rounding: sections there differ by less than that of themselves. */
        if (angle > 1e-9) {
            const batten_status status = check_corner(b, low, angle);
            if (status != BATTEN_OK)
                return status;
            begin_run(m, low);
        }
        for (int i = 1; i <= STEPS; i++)
            m->u[m->node_count++] = i < STEPS ? low + (high - low) * i / STEPS : high;
        m->runs[m->run_count - 1].last = m->node_count - 1;
    }
    return BATTEN_OK;
}

static batten_status measure(bat_spine_motion *m)
{
    for (int i = 1; i < m->node_count; i++) {
        double step = 0;
        const batten_status status = bat_spine_length(m, m->u[i - 1], m->u[i], &step);
        if (status != BATTEN_OK)
            return status;
        m->length[i] = m->length[i - 1] + step;
    }
    m->total = m->length[m->node_count - 1];
    return BATTEN_OK;
}

/* Minimising axes of one run that begin with `x`. */
static batten_status frame_run(bat_spine_motion *m, const bat_spine_run *r, batten_vec3 x)
{
    const int count = r->last - r->first + 1;
    const batten_interval whole = batten_curve_domain(m->spine);
    const double a = m->u[r->first], b = m->u[r->last];
    batten_curve *part = NULL;
    batten_frame *frames = bat_array((size_t)count, sizeof *frames);
    batten_status status = frames ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && a == whole.a && b == whole.b)
        part = batten_curve_ref(m->spine);
    else if (status == BATTEN_OK)
        status = batten_curve_subrange(m->spine, a, b, &part);
    if (status == BATTEN_OK)
        status =
            batten_curve_minimising_frames(part, count, m->u + r->first, 1e-9, frames, NULL);
    const double angle = status == BATTEN_OK ? bat_angle_about(frames[0].z, frames[0].x, x) : 0;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const batten_vec3 y = bat_vec3_cross(frames[i].z, frames[i].x);
        m->x[r->first + i] =
            bat_vec3_along(bat_vec3_scale(frames[i].x, cos(angle)), sin(angle), y);
    }
    batten_curve_unref(part);
    bat_release(frames);
    return status;
}

/* The first X: the wanted one, or that of batten_curve_frames. */
static batten_status first_axis(const building *b, batten_vec3 *x, batten_vec3 *z)
{
    batten_frame frame;
    const double start = b->knots[0];
    batten_status status =
        batten_curve_frames(b->m->spine, 1, &start, BATTEN_FRAME_FIXED, &frame);
    if (status != BATTEN_OK)
        return status;
    *x = frame.x;
    *z = frame.z;
    const batten_vec3 wanted = b->options->x;
    if (!isfinite(bat_vec3_norm(wanted)))
        return bat_fail(BATTEN_NOT_FINITE, "the first x-axis is (%g, %g, %g)", wanted.x,
                        wanted.y, wanted.z);
    if (bat_vec3_norm(wanted) > 0)
        *x = bat_unit_across(wanted, *z);
    if (bat_vec3_norm(*x) == 0)
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the first x-axis, (%g, %g, %g), lies along the spine", wanted.x,
                        wanted.y, wanted.z);
    return BATTEN_OK;
}

static batten_status frame_runs(building *b)
{
    bat_spine_motion *m = b->m;
    batten_vec3 x, z;
    batten_status status = first_axis(b, &x, &z);
    if (status != BATTEN_OK)
        return status;
    m->fixed[0] = x;
    m->fixed[1] = z;
    if (m->has_up || m->guide || m->kind == BATTEN_FRAME_FIXED ||
        m->kind == BATTEN_FRAME_FRENET)
        return BATTEN_OK;
    for (int k = 0; k < m->run_count && status == BATTEN_OK; k++) {
        batten_vec3 point, t[2];
        if (k > 0) {
            const double u = m->u[m->runs[k].first];
            status = bat_spine_tangent(m, u, BATTEN_FROM_LEFT, &point, &t[0]);
            if (status == BATTEN_OK)
                status = bat_spine_tangent(m, u, BATTEN_FROM_RIGHT, &point, &t[1]);
            if (status == BATTEN_OK)
                x = bat_turn_least(m->x[m->runs[k - 1].last], t[0], t[1]);
        }
        if (status == BATTEN_OK)
            status = frame_run(m, &m->runs[k], x);
    }
    return status;
}

/* ---- breaks ---- */

/* Where a share of the way ends. */
static batten_status place_of_share(const bat_spine_motion *m, double share, double *u)
{
    const double length = share * m->total;
    return batten_curve_at_length(m->spine, 1, &length, 1e-13 * m->total, u);
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
    const double near = 1e-9 * (b->knots[b->knot_count - 1] - b->knots[0]);
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

static batten_status check_options(const batten_sweep_options *o)
{
    batten_status status = check_law(o->scale, "scale");
    if (status == BATTEN_OK)
        status = check_law(o->scale_y, "scale in y");
    if (status == BATTEN_OK)
        status = check_law(o->twist, "twist");
    if (status == BATTEN_OK && o->scale_y && !o->scale)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there is a scale in y, and none in x");
    if (status == BATTEN_OK && o->up && o->guide)
        status =
            bat_fail(BATTEN_BAD_ARGUMENT, "the frames shall look both upward and at a guide");
    if (status == BATTEN_OK && o->up && !isfinite(bat_vec3_norm(*o->up)))
        status =
            bat_fail(BATTEN_NOT_FINITE, "upward is (%g, %g, %g)", o->up->x, o->up->y, o->up->z);
    if (status == BATTEN_OK && o->up && bat_vec3_norm(*o->up) == 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the upward direction has no length");
    return status;
}

static batten_status take(bat_spine_motion *m, const batten_curve *spine,
                          const batten_sweep_options *o)
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
    if (spans * (STEPS + 1) > MOST_NODES)
        return bat_fail(BATTEN_TOO_LARGE, "a spine of %zu spans is too long", spans);
    const size_t nodes = spans * (STEPS + 1) + 1;
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
    const double least = bat_max(b->options->tolerance, 1e-12 * b->m->base.size);
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

static batten_status build(building *b)
{
    bat_spine_motion *m = b->m;
    b->knot_count = batten_curve_spans(m->spine, NULL);
    batten_status status = make_room(b);
    if (status != BATTEN_OK)
        return status;
    batten_curve_spans(m->spine, b->knots);
    memcpy(m->base.breaks, b->knots, (size_t)b->knot_count * sizeof *b->knots);
    m->base.break_count = b->knot_count;
    status = lay_nodes(b);
    if (status == BATTEN_OK)
        status = measure(m);
    if (status == BATTEN_OK)
        status = check_length(b);
    if (status == BATTEN_OK)
        status = frame_runs(b);
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

batten_status bat_motion_along(const batten_curve *spine, const batten_sweep_options *options,
                               bool flat, bat_motion **out, batten_sweep_report *report)
{
    batten_status status = check_options(options);
    if (status != BATTEN_OK)
        return status;
    bat_spine_motion *m = bat_array(1, sizeof *m);
    if (!m)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&m->base.references);
    m->base.pose = bat_spine_pose;
    m->base.free = spine_free;
    m->base.flat = flat;
    building b = {.m = m, .options = options, .report = report};
    status = take(m, spine, options);
    if (status == BATTEN_OK)
        status = build(&b);
    bat_release(b.knots);
    if (status == BATTEN_OK)
        *out = &m->base;
    else
        bat_motion_unref(&m->base);
    return status;
}
