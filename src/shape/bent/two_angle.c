/* The tangents for which curvature is continuous: Newton's method, linear in the spans. */
#include "shape/bent/two_angle.h"
#include "base/plural.h"
#include "numeric/banded.h"
#include "shape/points/chord_polygon.h"

#include <float.h>
#include <string.h>

void bat_two_angle_span(const bat_two_angle *task, const double *angles, int j, double *alpha,
                        double *beta)
{
    const int next = (j + 1) % task->count;
    *alpha = angles[j];
    *beta = angles[next] + task->turn[next];
}

/* ---- messages ---- */

/* A span that bends more than its family allows, or has no solution. */
static batten_status fail_span(const bat_two_angle *task, const double *angles, int j)
{
    double alpha, beta;
    bat_two_angle_span(task, angles, j, &alpha, &beta);
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "span %d would leave and reach its chord at %.4g and %.4g degree%s; %s goes "
        "to %.4g at most: use %s, or put a point between",
        j + 1, alpha * 180 / BAT_PI, beta * 180 / BAT_PI,
        bat_plural_real(beta * 180 / BAT_PI, 4), task->family->name,
        task->family->limit * 180 / BAT_PI, task->family->remedy);
}

/* ---- where Newton begins ---- */

/* Where the tangent at point i may lie, from the chord that leaves it. */
static void room(const bat_two_angle *task, int i, double *low, double *high)
{
    const double limit = 0.95 * task->family->limit, turn = task->turn[i];
    *low = bat_max(-limit, -limit - turn);
    *high = bat_min(limit, limit - turn);
}

/* The tangent at point i of the circle through it and its neighbours. */
static double circle_tangent(const bat_two_angle *task, int i)
{
    const double before = task->length[(i + task->spans - 1) % task->spans];
    return bat_circle_angle(before, task->length[i], task->turn[i]);
}

/* The angle at an end from the one at the other side of its span, as if both were small: then
 * the curvature is -(4 near + 2 far) / l at the start and the negative of that at the end. */
static double end_angle(batten_nonlinear_end kind, double value, double l, double far,
                        double sign)
{
    if (kind == BATTEN_NONLINEAR_TANGENT)
        return value;
    if (kind == BATTEN_NONLINEAR_CIRCULAR)
        return -far;
    return -far / 2 - (kind == BATTEN_NONLINEAR_CURVATURE ? sign * value * l / 4 : 0);
}

batten_status bat_two_angle_start(const bat_two_angle *task, double *angles)
{
    const int n = task->count;
    const bool open = !task->closed;
    for (int i = open; i < n - open; i++) {
        double low, high;
        room(task, i, &low, &high);
        if (!(low < high))
            return bat_fail(
                BATTEN_TOLERANCE_NOT_MET,
                "the polygon turns by %.4g degree%s at point %d; %s goes to %.4g on "
                "each side: use %s, or put a point between",
                task->turn[i] * 180 / BAT_PI, bat_plural_real(task->turn[i] * 180 / BAT_PI, 4),
                i + 1, task->family->name, task->family->limit * 180 / BAT_PI,
                task->family->remedy);
        angles[i] = bat_min(high, bat_max(low, circle_tangent(task, i)));
    }
    if (!open)
        return BATTEN_OK;
    const double first = n > 2 ? angles[1] + task->turn[1] : 0;
    const double last = n > 2 ? angles[n - 2] : 0;
    angles[0] = end_angle(task->start, task->start_value, task->length[0], first, 1);
    angles[n - 1] = end_angle(task->end, task->end_value, task->length[n - 2], last, -1);
    for (int j = 0; j < task->spans; j += bat_max_int(1, task->spans - 1)) {
        double alpha, beta;
        bat_two_angle_span(task, angles, j, &alpha, &beta);
        if (bat_max(fabs(alpha), fabs(beta)) >= task->family->limit)
            return fail_span(task, angles, j);
    }
    return BATTEN_OK;
}

/* ---- one iterate ---- */

typedef struct {
    double *angles;           /* [count] */
    bat_end_curvatures *ends; /* [spans] */
    double *jumps;            /* [count], in one unit of curvature */
    double norm;              /* of the jumps, each times the length about its point */
    double worst, curvature;  /* the largest */
    double excess;            /* the largest jump beyond what rounding makes */
    int failed;               /* the span without a solution, or -1 */
} iterate;

static double end_jump(const bat_end_curvatures *ends, batten_nonlinear_end kind, double value,
                       double k)
{
    if (kind == BATTEN_NONLINEAR_TANGENT)
        return 0;
    if (kind == BATTEN_NONLINEAR_CIRCULAR)
        return ends->k1 - ends->k0;
    return k - (kind == BATTEN_NONLINEAR_CURVATURE ? value : 0);
}

static double jump_at(const bat_two_angle *task, const bat_end_curvatures *ends, int i)
{
    const int n = task->count, last = task->spans - 1;
    if (!task->closed && i == 0)
        return end_jump(&ends[0], task->start, task->start_value, ends[0].k0);
    if (!task->closed && i == n - 1)
        return end_jump(&ends[last], task->end, task->end_value, ends[last].k1);
    return ends[i > 0 ? i - 1 : last].k1 - ends[i].k0;
}

static double length_about(const bat_two_angle *task, int i)
{
    const int last = task->spans - 1;
    const double after = task->length[bat_min_int(i, last)];
    const double before = task->length[i > 0 ? i - 1 : task->closed ? last : 0];
    return 1 / (1 / before + 1 / after);
}

/* Angles are rounded like pi; short spans make a jump of that. */
static double rounding_at(const bat_two_angle *task, int i)
{
    return 4 * BAT_PI * DBL_EPSILON / length_about(task, i);
}

/* Curvatures and jumps at it->angles. */
static batten_status evaluate(const bat_two_angle *task, iterate *it)
{
    it->norm = it->worst = it->excess = it->curvature = 0;
    it->failed = -1;
    for (int j = 0; j < task->spans; j++) {
        double alpha, beta;
        bat_two_angle_span(task, it->angles, j, &alpha, &beta);
        bat_end_curvatures *e = &it->ends[j];
        batten_status status = BATTEN_SINGULAR_SYSTEM;
        if (bat_max(fabs(alpha), fabs(beta)) < task->family->limit)
            status =
                task->family->curvatures(alpha, beta, task->length[j], task->tension[j], e);
        if (status != BATTEN_OK) {
            it->failed = j;
            return status;
        }
        it->curvature = bat_max(it->curvature, bat_max(fabs(e->k0), fabs(e->k1)));
    }
    for (int i = 0; i < task->count; i++) {
        const double jump = jump_at(task, it->ends, i), weighted = jump * length_about(task, i);
        it->jumps[i] = jump;
        it->norm += weighted * weighted;
        it->worst = bat_max(it->worst, fabs(jump));
        it->excess = bat_max(it->excess, fabs(jump) - rounding_at(task, i));
    }
    return isfinite(it->norm)
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "the curvatures are too large for numbers");
}

/* ---- the step ---- */

/* Derivatives of jump i by the tangents at i - 1, i and i + 1. */
static void inner_row(const bat_end_curvatures *before, const bat_end_curvatures *after,
                      double row[3])
{
    row[0] = before->k1_alpha;
    row[1] = before->k1_beta - after->k0_alpha;
    row[2] = -after->k0_beta;
}

/* The same at an end: by the tangents at the start and the end of its span. */
static void end_row(const bat_end_curvatures *e, batten_nonlinear_end kind, bool at_start,
                    double *by_start, double *by_end)
{
    *by_start = at_start ? e->k0_alpha : e->k1_alpha;
    *by_end = at_start ? e->k0_beta : e->k1_beta;
    if (kind == BATTEN_NONLINEAR_TANGENT) {
        *by_start = at_start;
        *by_end = !at_start;
    }
    if (kind == BATTEN_NONLINEAR_CIRCULAR) {
        *by_start = e->k1_alpha - e->k0_alpha;
        *by_end = e->k1_beta - e->k0_beta;
    }
}

/* Newton's step from an iterate; a [count][3] is room for the matrix. */
static batten_status find_step(const bat_two_angle *task, const iterate *it, double *a,
                               double *step)
{
    const int n = task->count, last = task->spans - 1, open = !task->closed;
    memset(a, 0, (size_t)n * 3 * sizeof *a);
    for (int i = open; i < n - open; i++)
        inner_row(&it->ends[i > 0 ? i - 1 : last], &it->ends[i], a + 3 * (size_t)i);
    if (open) {
        end_row(&it->ends[0], task->start, true, a + 1, a + 2);
        end_row(&it->ends[last], task->end, false, a + 3 * (size_t)n - 3,
                a + 3 * (size_t)n - 2);
    }
    for (int i = 0; i < n; i++)
        step[i] = -it->jumps[i];
    if (open) {
        const batten_status status = bat_banded_factor(n, 1, 1, a);
        if (status == BATTEN_OK)
            bat_banded_solve(n, 1, 1, a, 1, step);
        return status;
    }
    bat_cyclic *factor = NULL;
    batten_status status = bat_cyclic_factor(n, 1, 1, a, &factor);
    if (status == BATTEN_OK)
        status = bat_cyclic_solve(factor, 1, step);
    bat_cyclic_free(factor);
    return status;
}

/* The part of the step, at most 1, that goes nine tenths of the way to a limit. */
static double longest(const bat_two_angle *task, const double *angles, const double *step)
{
    double part = 1;
    for (int j = 0; j < task->spans; j++) {
        const int next = (j + 1) % task->count;
        double at[2];
        bat_two_angle_span(task, angles, j, &at[0], &at[1]);
        const double by[2] = {step[j], step[next]};
        for (int e = 0; e < 2; e++) {
            const double left = task->family->limit - (by[e] > 0 ? at[e] : -at[e]);
            if (fabs(by[e]) * part > 0.9 * left)
                part = 0.9 * left / fabs(by[e]);
        }
    }
    return part;
}

/* ---- Newton ---- */

static void swap(iterate *a, iterate *b)
{
    const iterate kept = *a;
    *a = *b;
    *b = kept;
}

static bool settled(const iterate *it)
{
    return it->excess <= 1e-12 * it->curvature;
}

/* Shorten the step until it is better; false when no part of it is. */
static batten_status advance(const bat_two_angle *task, const double *step, iterate *now,
                             iterate *next, bool *better)
{
    enum { HALVINGS = 20 };
    double part = longest(task, now->angles, step);
    *better = false;
    for (int k = 0; k < HALVINGS; k++, part /= 2) {
        for (int i = 0; i < task->count; i++)
            next->angles[i] = now->angles[i] + part * step[i];
        const batten_status status = evaluate(task, next);
        if (status != BATTEN_OK && status != BATTEN_SINGULAR_SYSTEM)
            return status;
        if (status == BATTEN_OK &&
            (settled(next) || next->norm <= (1 - 1e-4 * part) * now->norm)) {
            /* So small a part is a crawl towards a limit that the family does not cross. */
            *better = settled(next) || part > 1e-6;
            swap(now, next);
            return BATTEN_OK;
        }
    }
    return BATTEN_OK;
}

/* No step helps, or too many do: say where, and what would. */
static batten_status fail_here(const bat_two_angle *task, const iterate *it,
                               const iterate *tried, int steps)
{
    int widest = 0, worst = 0;
    double most = 0;
    for (int j = 0; j < task->spans; j++) {
        double alpha, beta;
        bat_two_angle_span(task, it->angles, j, &alpha, &beta);
        if (bat_max(fabs(alpha), fabs(beta)) > most) {
            most = bat_max(fabs(alpha), fabs(beta));
            widest = j;
        }
    }
    for (int i = 0; i < task->count; i++)
        if (fabs(it->jumps[i]) > fabs(it->jumps[worst]))
            worst = i;
    if (most > 0.9 * task->family->limit)
        return fail_span(task, it->angles, widest);
    if (steps > 0)
        return bat_fail(
            BATTEN_INCOMPLETE,
            "after %d step%s curvature still jumps by %g of the largest at point %d", steps,
            bat_plural(steps), it->worst / it->curvature, worst + 1);
    if (tried->failed >= 0)
        return fail_span(task, tried->angles, tried->failed);
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "curvature jumps by %g of the largest at point %d, between spans that %s "
                    "cannot join: use %s, or put a point between",
                    it->worst / it->curvature, worst + 1, task->family->name,
                    task->family->remedy);
}

static batten_status iterate_to_end(const bat_two_angle *task, int max_steps, double *matrix,
                                    double *step, iterate *now, iterate *next, int *steps)
{
    batten_status status = evaluate(task, now);
    if (status != BATTEN_OK)
        return status == BATTEN_SINGULAR_SYSTEM ? fail_span(task, now->angles, now->failed)
                                                : status;
    bool better = true;
    for (*steps = 0; status == BATTEN_OK && better && !settled(now); ++*steps) {
        if (*steps == max_steps)
            return fail_here(task, now, next, max_steps);
        status = find_step(task, now, matrix, step);
        if (status == BATTEN_SINGULAR_SYSTEM)
            return bat_fail(status, "the tangents are not determined (%s)", batten_message());
        if (status == BATTEN_OK)
            status = advance(task, step, now, next, &better);
    }
    if (status == BATTEN_OK && !better)
        status = fail_here(task, now, next, 0);
    return status;
}

static bool iterate_make(const bat_two_angle *task, iterate *it)
{
    it->angles = bat_array((size_t)task->count, sizeof *it->angles);
    it->jumps = bat_array((size_t)task->count, sizeof *it->jumps);
    it->ends = bat_array((size_t)task->spans, sizeof *it->ends);
    return it->angles && it->jumps && it->ends;
}

static void iterate_free(iterate *it)
{
    bat_release(it->angles);
    bat_release(it->jumps);
    bat_release(it->ends);
}

batten_status bat_two_angle_solve(const bat_two_angle *task, int max_steps, double *angles,
                                  batten_chain_nonlinear_report *report)
{
    const size_t n = (size_t)task->count;
    iterate now = {0}, next = {0};
    double *matrix = bat_array(3 * n, sizeof *matrix), *step = bat_array(n, sizeof *step);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (iterate_make(task, &now) && iterate_make(task, &next) && matrix && step) {
        memcpy(now.angles, angles, n * sizeof *angles);
        status = iterate_to_end(task, max_steps, matrix, step, &now, &next, &report->steps);
    }
    if (status == BATTEN_OK) {
        memcpy(angles, now.angles, n * sizeof *angles);
        report->error = now.worst;
        report->curvature = now.curvature;
    }
    iterate_free(&now);
    iterate_free(&next);
    bat_release(matrix);
    bat_release(step);
    return status;
}
