/* The diagonals of a lines plan: planes along the hull that lean, as given or chosen. */
#include "base/plural.h"
#include "picture/drawings/hull.h"
#include "picture/sheet/numbers.h"

/* So many when none are asked for. */
enum { USUAL_DIAGONALS = 3 };

/* ---- given ---- */

static batten_status check_diagonal(const batten_draw_lines_plan_options *plan, int i)
{
    const double at = plan->diagonal_at[i], angle = plan->diagonal_angle[i];
    if (!isfinite(at) || !isfinite(angle))
        return bat_fail(BATTEN_NOT_FINITE, "diagonal %d begins at height %g and falls by %g",
                        i + 1, at, angle);
    if (!(angle > 0 && angle < 0.5 * BAT_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "diagonal %d falls by %g degrees; a diagonal falls by more than 0 and "
                        "less than 90",
                        i + 1, angle * 180 / BAT_PI);
    return BATTEN_OK;
}

static batten_status take_given(const batten_draw_lines_plan_options *plan, bat_cuts *cuts)
{
    batten_status status = bat_cuts_make(cuts, plan->diagonal_count);
    for (int i = 0; i < plan->diagonal_count && status == BATTEN_OK; i++) {
        status = check_diagonal(plan, i);
        cuts->cuts[i].at = plan->diagonal_at[i];
        cuts->cuts[i].angle = plan->diagonal_angle[i];
    }
    return status;
}

/* ---- chosen ---- */

/* The station nearest to the middle of the length that has lines; NULL without any. */
static const bat_cut *middle_station(const bat_hull *hull)
{
    const bat_cuts *stations = &hull->families[BAT_STATIONS];
    const double middle = 0.5 * (hull->low[0] + hull->high[0]);
    const bat_cut *nearest = NULL;
    for (int i = 0; i < stations->count; i++) {
        const bat_cut *cut = &stations->cuts[i];
        if (cut->lines.count > 0 &&
            (!nearest || fabs(cut->at - middle) < fabs(nearest->at - middle)))
            nearest = cut;
    }
    return nearest;
}

static double highest_point(const bat_cut *section)
{
    double highest = -HUGE_VAL;
    for (size_t k = 0; k < section->lines.count; k++)
        for (size_t n = 0; n < section->lines.strokes[k].count; n++)
            highest = bat_max(highest, section->lines.strokes[k].points[3 * n + 2]);
    return highest;
}

/* Where a section is met: y, z, and how it runs there. */
typedef struct {
    double y, z, dy, dz;
} meeting;

/* The farthest place where the ray from (0, top) that falls by `fall` meets a section. */
static bool meet_section(const bat_cut *section, double top, double fall, meeting *out)
{
    const double c = bat_cos(fall), s = bat_sin(fall);
    double farthest = 0;
    for (size_t k = 0; k < section->lines.count; k++)
        for (size_t n = 0; n + 1 < section->lines.strokes[k].count; n++) {
            const double *p = section->lines.strokes[k].points + 3 * n, *q = p + 3;
            /* How far the ends are to the side of the ray, and along it. */
            const double from = p[1] * s + (p[2] - top) * c, to = q[1] * s + (q[2] - top) * c;
            if ((from < 0) == (to < 0))
                continue;
            const double t = from / (from - to);
            const meeting m = {p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]), q[1] - p[1],
                               q[2] - p[2]};
            const double far = m.y * c + (top - m.z) * s;
            if (far > farthest) {
                farthest = far;
                *out = m;
            }
        }
    return farthest > 0;
}

/* The diagonal that crosses a section squarely here, as far as it leans between 20 and 70 degrees and begins
 * below the sheer; by whole five degrees and a round height. */
static bat_cut cross_squarely(const meeting *m, double top, double depth)
{
    const double degree = BAT_PI / 180, five = 5 * degree;
    /* Across the section and outwards: (|dz|, +-dy). */
    double fall = bat_atan2(m->dz < 0 ? -m->dy : m->dy, fabs(m->dz));
    fall = bat_max(20 * degree, bat_min(fall, 70 * degree));
    if (m->z + m->y * bat_sin(fall) / bat_cos(fall) > top)
        fall = bat_atan2(top - m->z, m->y);
    /* Whole but for rounding is whole. */
    fall = bat_max(five, five * floor(fall / five + 1e-9));
    const double step = bat_round_step(depth, 50);
    const double at = m->z + m->y * bat_sin(fall) / bat_cos(fall);
    return (bat_cut){.at = step * floor(at / step + 0.5), .angle = fall};
}

static batten_status choose_diagonals(int count, bat_hull *hull)
{
    bat_cuts *cuts = &hull->families[BAT_DIAGONALS];
    const bat_cut *section = middle_station(hull);
    const batten_status status = bat_cuts_make(cuts, count);
    cuts->count = 0;
    if (status != BATTEN_OK || !section)
        return status;
    const double top = highest_point(section);
    for (int i = 0; i < count; i++) { /* from the lowest up */
        meeting m;
        if (meet_section(section, top, 0.5 * BAT_PI * (count - i) / (count + 1), &m))
            cuts->cuts[cuts->count++] = cross_squarely(&m, top, hull->high[2] - hull->low[2]);
    }
    return BATTEN_OK;
}

batten_status bat_hull_place_diagonals(const batten_draw_lines_plan_options *plan,
                                       bat_hull *hull)
{
    const int usual = hull->knuckle_count > 0 ? 0 : USUAL_DIAGONALS;
    const int count = plan->diagonal_at      ? plan->diagonal_count
                      : plan->diagonals >= 0 ? plan->diagonals
                                             : usual;
    if (count < 0 || count > BAT_CUT_LIMIT)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d diagonal%s %s asked for; a lines plan draws up to %d", count,
                        bat_plural(count), bat_one_or_many(count, "is", "are"), BAT_CUT_LIMIT);
    if (plan->diagonal_at)
        return take_given(plan, &hull->families[BAT_DIAGONALS]);
    return choose_diagonals(count, hull);
}
