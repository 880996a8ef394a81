/*
 * Sweeps along a spine, pipes and helical surfaces: options, checks, and the choice between the
 * exact surface, the true one and the NURBS near it.
 */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/sweep/true_sweep.h"
#include "spline/curve/curve.h"

#include <batten/skin.h>
#include <batten/standard.h>
#include <string.h>

batten_surface_sweep_options batten_surface_sweep_defaults(void)
{
    return (batten_surface_sweep_options){.size = sizeof(batten_surface_sweep_options),
                                          .tolerance = 1e-6, /* with metres, a micrometre */
                                          .degree = 3};
}

/* ---- sections ---- */

static batten_status take_section(const batten_curve *section, batten_curve **out)
{
    const batten_box box = batten_curve_box(section);
    if (bat_vec3_norm(bat_vec3_subtract(box.high, box.low)) == 0)
        return bat_fail(BATTEN_COINCIDENT, "the section is a point, (%g, %g, %g)", box.low.x,
                        box.low.y, box.low.z);
    return batten_curve_to_dimension(section, 3, out);
}

/* One section, or several as a skin in their own plane over the shares of the way. */
static batten_status take_sections(int count, const batten_curve *const *sections,
                                   const batten_surface_sweep_options *o, bat_sweep *sweep,
                                   batten_surface_skin_report *found)
{
    if (count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d section%s, and a sweep needs 1",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (count == 1)
        return take_section(sections[0], &sweep->section);
    double *even = bat_array((size_t)count, sizeof *even);
    batten_curve **raised = bat_array((size_t)count, sizeof *raised);
    batten_status status = even && raised ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        even[i] = o->at ? o->at[i] : (double)i / (count - 1);
        status = batten_curve_to_dimension(sections[i], 3, &raised[i]);
    }
    if (status == BATTEN_OK && (even[0] != 0 || even[count - 1] != 1))
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the sections stand from %g to %g of the spine, not from 0 to 1",
                          even[0], even[count - 1]);
    if (status == BATTEN_OK) {
        batten_surface_skin_options skin = batten_surface_skin_defaults();
        skin.parameters = BATTEN_GIVEN;
        skin.given = even;
        skin.align = skin.untwist = o->align;
        status =
            batten_surface_skin((batten_curve_row){count, (const batten_curve *const *)raised},
                                &skin, NULL, NULL, found, &sweep->row);
    }
    for (int i = 0; raised && i < count; i++)
        batten_curve_unref(raised[i]);
    bat_release(raised);
    bat_release(even);
    return status;
}

static bool is_flat(const bat_sweep *s)
{
    const batten_box box = s->row ? batten_surface_box(s->row) : batten_curve_box(s->section);
    return box.low.z == 0 && box.high.z == 0;
}

/* ---- do sections run into each other? ---- */

enum { REACH_PLACES = 8 }; /* of each span of a section; 4 times as many of the spine's */

typedef struct {
    int count, rows;
    double *points; /* [count][3] of the section, at present */
    double *at;     /* [count] their parameters */
} outline;

static batten_status make_outline(const bat_sweep *s, outline *o)
{
    const batten_surface *row = s->row;
    const int spans =
        row ? batten_surface_spans(row, BATTEN_U, NULL) : batten_curve_spans(s->section, NULL);
    double *knots = bat_array((size_t)spans, sizeof *knots);
    o->count = (spans - 1) * REACH_PLACES + 1;
    o->points = bat_array3((size_t)o->count, 3, sizeof *o->points);
    o->at = bat_array((size_t)o->count, sizeof *o->at);
    batten_status status = knots && o->points && o->at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && row)
        batten_surface_spans(row, BATTEN_U, knots);
    else if (status == BATTEN_OK)
        batten_curve_spans(s->section, knots);
    for (int i = 0; status == BATTEN_OK && i < o->count; i++) {
        const int k = i / REACH_PLACES;
        const double t = (double)(i % REACH_PLACES) / REACH_PLACES;
        o->at[i] = t == 0 ? knots[k] : (1 - t) * knots[k] + t * knots[k + 1];
        if (!row)
            status = batten_curve_evaluate(s->section, o->at[i], 0, o->points + 3 * i);
    }
    bat_release(knots);
    return status;
}

static batten_status look_at_row(const bat_sweep *s, double share, outline *o)
{
    if (!s->row)
        return BATTEN_OK;
    const double at = bat_max(0, bat_min(1, share));
    return batten_surface_evaluate_grid(
        s->row, (batten_uv_grid){(size_t)o->count, 1, o->at, &at}, 0, NULL, o->points);
}

/* The least of Sv . t / |spine'| along the section at v: 1 minus curvature times reach. */
static batten_status clearance_at(const bat_sweep *s, double v, batten_side side, outline *o,
                                  double *clearance)
{
    bat_pose pose;
    batten_status status = s->motion->pose(s->motion, v, side, &pose);
    if (status == BATTEN_OK)
        status = look_at_row(s, pose.share[0], o);
    if (status != BATTEN_OK)
        return status;
    const double *along = pose.d[1][BAT_POSE_ORIGIN];
    const double speed = bat_norm(3, along);
    double turn[3];
    for (int axis = 0; axis < 3; axis++) {
        turn[axis] = 0;
        for (int c = 0; c < 3; c++)
            turn[axis] += pose.d[1][axis][c] / speed * (along[c] / speed);
    }
    *clearance = HUGE_VAL;
    for (int i = 0; i < o->count; i++)
        *clearance = bat_min(*clearance, 1 + bat_dot(3, turn, o->points + 3 * i));
    return BATTEN_OK;
}

/* Where the clearance is not above 0: the first stretch of it. */
typedef struct {
    bool found, over;
    double from, to;
} fold;

static void note_fold(fold *f, double v, double clearance)
{
    const bool folds = clearance <= BAT_ROUNDING; /* what rounding leaves of 0 */
    if (folds && !f->found)
        *f = (fold){true, false, v, v};
    else if (folds && !f->over)
        f->to = v;
    else if (f->found)
        f->over = true;
}

static batten_status scan(const bat_sweep *s, outline *o, fold *folded,
                          batten_surface_sweep_report *report)
{
    const bat_motion *m = s->motion;
    const int places = 4 * REACH_PLACES;
    for (int k = 0; k + 1 < m->break_count; k++)
        for (int i = 0; i <= places; i++) {
            const double t = (double)i / places;
            const double v =
                i < places ? (1 - t) * m->breaks[k] + t * m->breaks[k + 1] : m->breaks[k + 1];
            double clearance;
            const batten_status status = clearance_at(
                s, v, i < places ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, o, &clearance);
            if (status != BATTEN_OK)
                return status;
            note_fold(folded, v, clearance);
            if (clearance < report->clearance) {
                report->clearance = clearance;
                report->clearance_at = v;
            }
        }
    return BATTEN_OK;
}

static batten_status check_folds(const bat_sweep *s,
                                 const batten_surface_sweep_options *options,
                                 batten_surface_sweep_report *report)
{
    outline o = {0};
    fold folded = {.found = false};
    report->clearance = 1;
    report->clearance_at = s->motion->breaks[0];
    if (options->frames == BATTEN_FRAME_FIXED && !options->up && !options->guide)
        return BATTEN_OK;
    batten_status status = make_outline(s, &o);
    if (status == BATTEN_OK)
        status = scan(s, &o, &folded, report);
    bat_release(o.points);
    bat_release(o.at);
    if (status == BATTEN_OK && folded.found && !options->allow_folds)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the sections run into each other from %.6g to %.6g of the spine: "
                        "curvature times their reach is up to %g there, and must stay below 1",
                        folded.from, folded.to, 1 - report->clearance);
    return status;
}

/* ---- the sweep ---- */

static batten_status prepare_sweep(int count, const batten_curve *const *sections,
                                   const batten_curve *spine,
                                   const batten_surface_sweep_options *options,
                                   batten_surface_sweep_report *report, bat_sweep *sweep)
{
    batten_surface_skin_report found = {.reversed = -1, .turned = -1};
    batten_status status = take_sections(count, sections, options, sweep, &found);
    report->reversed_count = found.reversed_count;
    report->reversed = found.reversed;
    report->turned_count = found.turned_count;
    report->turned = found.turned;
    if (status == BATTEN_OK)
        status = bat_motion_along(spine, options, is_flat(sweep), &sweep->motion, report);
    if (status != BATTEN_OK)
        return status;
    sweep->part = (batten_interval){sweep->motion->breaks[0],
                                    sweep->motion->breaks[sweep->motion->break_count - 1]};
    return check_folds(sweep, options, report);
}

/* Where the poses jump: the ends of the parts, [break_count] at most. */
static int find_parts(const bat_motion *m, bool split, double *ends)
{
    int count = 0;
    for (int i = 1; i < m->break_count; i++)
        if (i + 1 == m->break_count || (split && m->smoothness[i] < 0))
            ends[count++] = m->breaks[i];
    return count;
}

static batten_status fit_parts(bat_sweep *sweep, const batten_surface_sweep_options *o,
                               int count, const double *ends, bat_work *work,
                               batten_surface_sweep_report *report, batten_surface **surfaces)
{
    batten_status status = BATTEN_OK;
    double start = sweep->motion->breaks[0];
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        sweep->part = (batten_interval){start, ends[k]};
        status = bat_sweep_fit(sweep, o->degree, o->tolerance, work, report, &surfaces[k]);
        start = ends[k];
    }
    for (int k = 0; status != BATTEN_OK && k < count; k++)
        batten_surface_unref(surfaces[k]);
    return status;
}

batten_status batten_surfaces_sweep(batten_curve_row sections, const batten_curve *spine,
                                    const batten_surface_sweep_options *options,
                                    const batten_job *job, batten_surface_sweep_report *report,
                                    batten_surfaces *out)
{
    assert(sections.at && spine && out);
    batten_surface_sweep_options chosen = batten_surface_sweep_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_sweep_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_sweep_options *o = &chosen;
    batten_surface_sweep_report found = {.error = 0};
    bat_sweep sweep = {0};
    bat_work work = {job, 0};
    double *ends = NULL;
    batten_surface **made = NULL;
    int parts = 0;
    status = prepare_sweep(sections.count, sections.at, spine, o, &found, &sweep);
    if (status == BATTEN_OK) {
        ends = bat_array((size_t)sweep.motion->break_count, sizeof *ends);
        made = bat_array((size_t)sweep.motion->break_count, sizeof *made);
        status = ends && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        parts = find_parts(sweep.motion, o->corners == BATTEN_CORNER_SPLIT, ends);
        status = fit_parts(&sweep, o, parts, ends, &work, &found, made);
    }
    bat_release(ends);
    bat_sweep_release(&sweep);
    if (status != BATTEN_OK) {
        bat_release(made);
        return status;
    }
    *out = (batten_surfaces){parts, made};
    if (report)
        *report = found;
    return BATTEN_OK;
}

batten_status batten_surface_sweep(batten_curve_row sections, const batten_curve *spine,
                                   const batten_surface_sweep_options *options,
                                   const batten_job *job, batten_surface_sweep_report *report,
                                   batten_surface **out)
{
    assert(out);
    batten_surfaces made = {0, NULL};
    batten_surface_sweep_report found;
    batten_status status = batten_surfaces_sweep(sections, spine, options, job, &found, &made);
    if (status != BATTEN_OK)
        return status;
    if (made.count == 1)
        *out = batten_surface_ref(made.at[0]);
    else
        status = bat_fail(BATTEN_NOT_COMPATIBLE, "corners split the sweep into %d surfaces",
                          made.count);
    batten_surfaces_release(&made);
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}

batten_status batten_surface_sweep_procedural(batten_curve_row sections,
                                              const batten_curve *spine,
                                              const batten_surface_sweep_options *options,
                                              batten_surface **out)
{
    assert(sections.at && spine && out);
    batten_surface_sweep_options chosen = batten_surface_sweep_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_sweep_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_sweep_options *o = &chosen;
    batten_surface_sweep_report report = {.error = 0};
    bat_sweep sweep = {0};
    status = prepare_sweep(sections.count, sections.at, spine, o, &report, &sweep);
    for (int i = 1; status == BATTEN_OK && i + 1 < sweep.motion->break_count; i++)
        if (sweep.motion->smoothness[i] < 0)
            status = bat_fail(BATTEN_NOT_COMPATIBLE,
                              "the sections do not meet at the corner of the spine at %.17g",
                              sweep.motion->breaks[i]);
    if (status == BATTEN_OK)
        status = bat_sweep_surface(&sweep, out);
    bat_sweep_release(&sweep);
    return status;
}

/* ---- pipes ---- */

batten_status batten_surfaces_pipe(double radius, const batten_curve *spine,
                                   const batten_surface_sweep_options *options,
                                   const batten_job *job, batten_surface_sweep_report *report,
                                   batten_surfaces *out)
{
    batten_curve *circle = NULL;
    batten_status status = batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &circle);
    if (status == BATTEN_OK)
        status =
            batten_surfaces_sweep((batten_curve_row){1, (const batten_curve *const *)&circle},
                                  spine, options, job, report, out);
    batten_curve_unref(circle);
    return status;
}

/* ---- about an axis ---- */

batten_status batten_surface_helical(const batten_curve *curve, batten_screw screw,
                                     double tolerance, const batten_job *job,
                                     batten_surface_sweep_report *report, batten_surface **out)
{
    assert(curve && out);
    batten_surface_sweep_report found = {.error = 0, .clearance = 1};
    bat_sweep sweep = {0};
    bat_work work = {job, 0};
    batten_status status =
        bat_motion_screw(screw.origin, screw.axis, screw.pitch, screw.angle, &sweep.motion);
    if (status == BATTEN_OK)
        status = take_section(curve, &sweep.section);
    if (status == BATTEN_OK) {
        sweep.part = (batten_interval){0, screw.angle};
        status = bat_sweep_fit(&sweep, 3, tolerance, &work, &found, out);
    }
    bat_sweep_release(&sweep);
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}
