/* The corners of a hole: where ribbons point, and how two contradict each other. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/fill.h"

batten_status bat_fill_see_place(const bat_fill_side *side, int station, bat_fill_place *out)
{
    static const double at[FILL_STATIONS] = {0, 1, 1, 2};
    const batten_side from =
        station == FILL_BEFORE || station == FILL_END ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    batten_status status =
        batten_curve_evaluate_side(side->curve, at[station], from, 4, out->curve[0]);
    if (status == BATTEN_OK && side->slope)
        status = batten_curve_evaluate_side(side->slope, at[station], from, 3, out->slope[0]);
    return status;
}

void bat_fill_across(int which, const bat_fill_place *other, double out[3])
{
    for (int m = 0; m < 3; m++)
        out[m] = which == 0 ? -other->curve[1][m] : other->curve[1][m];
}

batten_status bat_fill_look(const bat_fill_place *place, int station, const double across[3],
                            int curve, bat_fill_seen *out)
{
    const double *T = place->slope[0], *C = place->curve[1];
    double n[3];
    bat_cross(C, T, n);
    const double size = bat_norm(3, n);
    if (!(size > BAT_LEAST_SINE * bat_norm(3, C) * bat_norm(3, T)))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the ribbon of curve %d has no tangent plane at the %s of its side: "
                        "its slope runs along the curve",
                        curve + 1, station == FILL_START ? "start" : "end");
    bat_cross(C, n, out->to_a);
    bat_cross(n, T, out->to_b);
    const double dual = bat_dot(3, T, out->to_a), other = bat_dot(3, C, out->to_b);
    for (int k = 0; k < 3; k++) {
        out->to_a[k] /= dual;
        out->to_b[k] /= other;
        out->normal[k] = n[k] / size;
    }
    out->a = bat_dot(3, across, out->to_a);
    out->b = bat_dot(3, across, out->to_b);
    out->twist = out->a * bat_dot(3, place->slope[1], out->normal) +
                 out->b * bat_dot(3, place->curve[2], out->normal);
    /* A tenth: what turns back by rounding where sides are smooth is not a mistake. */
    out->back = out->a * bat_norm(3, T) < -0.1 * bat_norm(3, across);
    return BATTEN_OK;
}

bool bat_fill_is_flat(const bat_fill_place *start, const bat_fill_place *before)
{
    double normal[3];
    bat_cross(start->curve[1], before->curve[1], normal);
    return bat_norm(3, normal) <
           1e-3 * bat_norm(3, start->curve[1]) * bat_norm(3, before->curve[1]);
}

/* One corner: the side that starts in it, and the one before. */
typedef struct {
    const bat_fill_side *side[2];
    bat_fill_place place[2];
    double across[2][3];
    bat_fill_seen seen[2];
} corner;

static batten_status see_corner(const bat_fill_loop *loop, int i, corner *out)
{
    static const int stations[2] = {FILL_START, FILL_END};
    batten_status status = BATTEN_OK;
    out->side[0] = &loop->sides[i];
    out->side[1] = &loop->sides[(i + loop->count - 1) % loop->count];
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_fill_see_place(out->side[k], stations[k], &out->place[k]);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        bat_fill_across(k, &out->place[1 - k], out->across[k]);
        if (out->side[k]->slope)
            status = bat_fill_look(&out->place[k], stations[k], out->across[k],
                                   out->side[k]->given, &out->seen[k]);
    }
    return status;
}

/* The angle between the planes of both ribbons, or of the one and the other side; 0 for none.
 */
static double planes_differ(const corner *c)
{
    if (c->side[0]->slope && c->side[1]->slope) {
        double sine[3];
        bat_cross(c->seen[0].normal, c->seen[1].normal, sine);
        return bat_atan2(bat_norm(3, sine), bat_dot(3, c->seen[0].normal, c->seen[1].normal));
    }
    for (int k = 0; k < 2; k++)
        if (c->side[k]->slope) {
            const double off = fabs(bat_dot(3, c->across[k], c->seen[k].normal));
            return bat_asin(bat_min(1, off / bat_norm(3, c->across[k])));
        }
    return 0;
}

static void report_corner(int i, const corner *c, batten_surface_fill_report *report)
{
    const double product = bat_norm(3, c->across[0]) * bat_norm(3, c->across[1]);
    report->flat_corners += bat_fill_is_flat(&c->place[0], &c->place[1]);
    const double angle = planes_differ(c);
    if (angle > report->corner_angle) {
        report->corner_angle = angle;
        report->corner = i;
    }
    if (c->side[0]->slope && c->side[1]->slope) {
        /* Relative to the product of the speeds. */
        const double twist = fabs(c->seen[0].twist + c->seen[1].twist) / sqrt(product);
        report->twist = bat_max(report->twist, twist);
        report->twisted += twist > BAT_MEANT_SAME;
    }
}

static batten_status points_out(const bat_fill_loop *loop, int side, int end)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the ribbon of curve %d points out of the hole at the %s of its side",
                    loop->sides[side].given + 1, end == 0 ? "start" : "end");
}

/*
 * A ribbon that points out of the hole has the next sides behind it at both its ends; a corner
 * of more than 180 degrees has the other side behind both its ribbons. So where the two ribbons
 * of a corner do not agree one of them points out; where all agree it is the corner, unless no
 * corner is convex.
 * @param back [count][2]  at the start and at the end of each side; -1 without a slope
 */
static batten_status check_directions(const bat_fill_loop *loop, int back[][2])
{
    const int n = loop->count;
    int convex = 0;
    for (int i = 0; i < n; i++) {
        const int before = (i + n - 1) % n;
        convex += back[i][0] == 0 || back[before][1] == 0;
        if (back[i][0] == 1 && back[before][1] == 0)
            return points_out(loop, i, 0);
        if (back[i][0] == 0 && back[before][1] == 1)
            return points_out(loop, before, 1);
    }
    for (int i = 0; i < n; i++) {
        const int before = (i + n - 1) % n;
        if (back[i][0] != 1 && back[before][1] != 1)
            continue;
        if (convex == 0)
            return back[i][0] == 1 ? points_out(loop, i, 0) : points_out(loop, before, 1);
        /* One ribbon alone is judged by its other end. */
        if (back[before][1] == -1 && back[i][1] == 1)
            return points_out(loop, i, 0);
        if (back[i][0] == -1 && back[before][0] == 1)
            return points_out(loop, before, 1);
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the corner between curves %d and %d is re-entrant (the hole has more "
                        "than 180 degrees there): sides of such a corner cannot have ribbons",
                        loop->sides[before].given + 1, loop->sides[i].given + 1);
    }
    return BATTEN_OK;
}

batten_status bat_fill_corners(const bat_fill_loop *loop, batten_surface_fill_report *report)
{
    int back[BATTEN_FILL_SIDES][2];
    const int n = loop->count;
    for (int i = 0; i < n; i++) {
        corner c;
        const batten_status status = see_corner(loop, i, &c);
        if (status != BATTEN_OK)
            return status;
        back[i][0] = c.side[0]->slope ? c.seen[0].back : -1;
        back[(i + n - 1) % n][1] = c.side[1]->slope ? c.seen[1].back : -1;
        report_corner(i, &c, report);
    }
    return check_directions(loop, back);
}
