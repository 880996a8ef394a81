/* The way of a ball that rolls on two surfaces: where their offsets meet. */
#include "numeric/rounding.h"
#include "shape/surface_change/fillet.h"

#include "numeric/dense.h"
#include "shape/surface_change/offset.h"

#include <string.h>

enum { NEWTON = 40, SEEDS = 13, STEPS = 40, MOST = 2000, BISECTIONS = 50 };

typedef struct {
    double offset[2][9]; /* O, Ou, Ov of either offset */
    batten_vec3 contact[2], normal[2];
} spine_samples;

static batten_status look_at_offsets(const bat_rolling *r, const double x[4], spine_samples *p)
{
    for (int k = 0; k < 2; k++) {
        double point[3];
        const bat_surface_place at = bat_surface_place_at(x[2 * k], x[2 * k + 1]);
        batten_status status =
            bat_offset_point(r->surfaces[k], r->radii[k], &at, 1, p->offset[k]);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(r->surfaces[k], x[2 * k], x[2 * k + 1], 0, point);
        if (status != BATTEN_OK)
            return status;
        p->contact[k] = bat_vec3_of(3, point);
        p->normal[k] = bat_vec3_scale(
            bat_vec3_subtract(bat_vec3_of(3, p->offset[k]), p->contact[k]), 1 / r->radii[k]);
    }
    return BATTEN_OK;
}

static batten_vec3 middle(const spine_samples *p)
{
    return bat_vec3_scale(
        bat_vec3_add(bat_vec3_of(3, p->offset[0]), bat_vec3_of(3, p->offset[1])), 0.5);
}

/* False where the surfaces are tangent. */
static bool find_tangent(const spine_samples *p, batten_vec3 *tangent)
{
    const batten_vec3 cross = bat_vec3_cross(p->normal[0], p->normal[1]);
    /* Normals of two surfaces, each wrong by up to 1e-10: a direction of four digits. */
    const double sine = bat_vec3_norm(cross);
    *tangent = bat_vec3_scale(cross, sine > 0 ? 1 / sine : 0);
    return sine > 1e-6;
}

/* O1 = O2 and the plane, linear in a step of x; then the step, kept inside the domains. */
static batten_status newton_step(const bat_rolling *r, const spine_samples *p,
                                 batten_vec3 normal, double off, double x[4])
{
    double a[16], b[4] = {0};
    int pivots[4];
    for (int j = 0; j < 4; j++) {
        const double *d = p->offset[j / 2] + 3 * (1 + j % 2);
        for (int c = 0; c < 3; c++)
            a[4 * c + j] = (j < 2 ? 1 : -1) * d[c];
        a[12 + j] = 0.5 * bat_vec3_dot(normal, bat_vec3_of(3, d));
    }
    for (int c = 0; c < 3; c++)
        b[c] = p->offset[1][c] - p->offset[0][c];
    b[3] = -off;
    const batten_status status = bat_dense_factor(4, a, pivots);
    if (status != BATTEN_OK)
        return status;
    bat_dense_solve(4, a, pivots, 1, b);
    for (int j = 0; j < 4; j++) {
        const batten_interval d =
            batten_surface_domain(r->surfaces[j / 2], (batten_direction)(j % 2));
        x[j] = bat_max(d.a, bat_min(d.b, x[j] + b[j]));
    }
    return BATTEN_OK;
}

batten_status bat_ball_in_plane(const bat_rolling *r, const double guess[4],
                                const batten_vec3 *point, const batten_vec3 *normal,
                                bat_ball *out, bool *found)
{
    double x[4];
    memcpy(x, guess, sizeof x);
    *found = false;
    for (int i = 0; i < NEWTON; i++) {
        spine_samples p;
        batten_vec3 tangent;
        batten_status status = look_at_offsets(r, x, &p);
        if (status != BATTEN_OK)
            return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
        const bool across = find_tangent(&p, &tangent);
        const batten_vec3 centre = middle(&p);
        const double off = point ? bat_vec3_dot(*normal, bat_vec3_subtract(centre, *point)) : 0;
        const double apart = bat_distance(3, p.offset[0], p.offset[1]);
        if (apart <= BAT_EXACT * r->size && fabs(off) <= BAT_EXACT * r->size) {
            memcpy(out->x, x, sizeof x);
            out->centre = centre;
            out->contact[0] = p.contact[0];
            out->contact[1] = p.contact[1];
            out->tangent = tangent;
            *found = across;
            return BATTEN_OK;
        }
        if (!point && !across)
            return BATTEN_OK;
        status = newton_step(r, &p, point ? *normal : tangent, off, x);
        if (status != BATTEN_OK)
            return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_OK : status;
    }
    return BATTEN_OK;
}

/* ---- where it begins ---- */

static void grid_place(const batten_surface *surface, int i, double x[2])
{
    const double shares[2] = {(i / SEEDS + 0.5) / SEEDS, (i % SEEDS + 0.5) / SEEDS};
    for (int k = 0; k < 2; k++) {
        const batten_interval d = batten_surface_domain(surface, (batten_direction)k);
        x[k] = (1 - shares[k]) * d.a + shares[k] * d.b;
    }
}

static batten_status sample(const bat_rolling *r, int k, double *points)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < SEEDS * SEEDS && status == BATTEN_OK; i++) {
        double x[2];
        grid_place(r->surfaces[k], i, x);
        const bat_surface_place at = bat_surface_place_at(x[0], x[1]);
        status = bat_offset_point(r->surfaces[k], r->radii[k], &at, 0, points + 3 * i);
    }
    return status;
}

/* From pairs of samples, nearest first for each sample of the first offset, until one leads to
 * a ball. */
static batten_status try_pairs(const bat_rolling *r, const double *points, bat_ball *out)
{
    enum { COUNT = SEEDS * SEEDS };
    bool tried[COUNT] = {false}, found = false;
    double nearest = HUGE_VAL;
    for (int round = 0; round < COUNT; round++) {
        int best[2] = {0, 0};
        double least = HUGE_VAL, x[4];
        for (int i = 0; i < COUNT; i++)
            for (int j = 0; j < COUNT && !tried[i]; j++) {
                const double far = bat_distance(3, points + 3 * i, points + 3 * (COUNT + j));
                if (far >= least)
                    continue;
                least = far;
                best[0] = i;
                best[1] = j;
            }
        nearest = bat_min(nearest, least);
        tried[best[0]] = true;
        grid_place(r->surfaces[0], best[0], x);
        grid_place(r->surfaces[1], best[1], x + 2);
        const batten_status status = bat_ball_in_plane(r, x, NULL, NULL, out, &found);
        if (status != BATTEN_OK || found)
            return status;
    }
    return bat_fail(BATTEN_NOT_FOUND,
                    "no ball of this radius touches both surfaces on these sides: samples of "
                    "the offsets are %g apart at least",
                    nearest);
}

static batten_status find_first(const bat_rolling *r, const double *start, bat_ball *out)
{
    bool found = false;
    if (start) {
        const batten_status status = bat_ball_in_plane(r, start, NULL, NULL, out, &found);
        if (status != BATTEN_OK || found)
            return status;
        return bat_fail(BATTEN_NOT_FOUND, "no ball was found from (%g, %g), (%g, %g)", start[0],
                        start[1], start[2], start[3]);
    }
    double *points = bat_array(2 * SEEDS * SEEDS, 3 * sizeof *points);
    batten_status status = points ? sample(r, 0, points) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = sample(r, 1, points + 3 * SEEDS * SEEDS);
    if (status == BATTEN_OK)
        status = try_pairs(r, points, out);
    bat_release(points);
    return status;
}

/* ---- rolling ---- */

typedef struct {
    const bat_rolling *rolling;
    double way; /* 1 or -1 */
    double step;
} march;

static batten_status advance_ball(const march *m, const bat_ball *from, double h, bat_ball *out,
                                  bool *found)
{
    const batten_vec3 point = bat_vec3_along(from->centre, m->way * h, from->tangent);
    return bat_ball_in_plane(m->rolling, from->x, &point, &from->tangent, out, found);
}

/* The last place that is found; the way to it. */
static batten_status advance_to_end(const march *m, const bat_ball *from, double high,
                                    bat_ball *out, double *reached)
{
    double low = 0;
    for (int i = 0; i < BISECTIONS; i++) {
        bat_ball ball;
        bool found = false;
        const double h = low + (high - low) / 2;
        const batten_status status = advance_ball(m, from, h, &ball, &found);
        if (status != BATTEN_OK)
            return status;
        if (found) {
            low = h;
            *out = ball;
        } else {
            high = h;
        }
    }
    *reached = low;
    return BATTEN_OK;
}

static batten_fillet_end why(const bat_rolling *r, const bat_ball *ball)
{
    for (int j = 0; j < 4; j++) {
        const batten_interval d =
            batten_surface_domain(r->surfaces[j / 2], (batten_direction)(j % 2));
        if (bat_min(ball->x[j] - d.a, d.b - ball->x[j]) <= BAT_MEANT_SAME * (d.b - d.a))
            return j < 2 ? BATTEN_FILLET_BORDER_1 : BATTEN_FILLET_BORDER_2;
    }
    return BATTEN_FILLET_LOST;
}

/* From balls[0] on, as far as it goes. */
static batten_status roll(const march *m, bat_spine *s, batten_fillet_end *end)
{
    double h = m->step;
    while (s->count < MOST) {
        const bat_ball *from = &s->balls[s->count - 1];
        bat_ball next = *from;
        bool found = false;
        batten_status status = advance_ball(m, from, h, &next, &found);
        if (status != BATTEN_OK)
            return status;
        /* Steps turn by less than 11 degrees, and are halved twenty times at most. */
        if (found && bat_vec3_dot(next.tangent, from->tangent) < 0.98 && h > 1e-6 * m->step) {
            h /= 2;
            continue;
        }
        if (!found) {
            double reached = 0;
            status = advance_to_end(m, from, h, &next, &reached);
            /* A last step far shorter than the others takes the place of the one before. */
            if (reached > 0)
                s->balls[s->count - (s->count > 1 && reached < 0.1 * h)] = next;
            s->count += reached > 0 && !(s->count > 1 && reached < 0.1 * h);
            *end = why(m->rolling, &s->balls[s->count - 1]);
            return status;
        }
        const bool back =
            s->count > 3 &&
            bat_vec3_norm(bat_vec3_subtract(next.centre, s->balls[0].centre)) < 0.7 * h;
        s->balls[s->count++] = back ? s->balls[0] : next;
        if (back) {
            *end = BATTEN_FILLET_CLOSED;
            return BATTEN_OK;
        }
        h = bat_min(m->step, 1.5 * h);
    }
    return bat_fail(BATTEN_TOO_LARGE, "the ball needs more than %d steps", (int)MOST);
}

static batten_status roll_both(const bat_rolling *r, bat_spine *back, bat_spine *out,
                               batten_fillet_end ends[2])
{
    march m = {r, 1, r->size / STEPS};
    batten_status status = roll(&m, out, &ends[1]);
    ends[0] = ends[1];
    if (status != BATTEN_OK || ends[1] == BATTEN_FILLET_CLOSED)
        return status;
    m.way = -1;
    back->balls[0] = out->balls[0];
    back->count = 1;
    status = roll(&m, back, &ends[0]);
    if (status != BATTEN_OK)
        return status;
    memmove(out->balls + back->count - 1, out->balls, (size_t)out->count * sizeof *out->balls);
    for (int i = 0; i + 1 < back->count; i++)
        out->balls[i] = back->balls[back->count - 1 - i];
    out->count += back->count - 1;
    return BATTEN_OK;
}

batten_status bat_spine_find(const bat_rolling *r, const double *start, bat_spine *out,
                             batten_fillet_end ends[2])
{
    bat_spine back = {0, bat_array(MOST, sizeof(bat_ball))};
    bat_spine made = {1, bat_array(2 * MOST, sizeof(bat_ball))};
    batten_status status = back.balls && made.balls ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_first(r, start, &made.balls[0]);
    if (status == BATTEN_OK)
        status = roll_both(r, &back, &made, ends);
    if (status == BATTEN_OK && made.count < 2)
        status = bat_fail(BATTEN_NOT_FOUND, "the ball fits in one place only");
    bat_release(back.balls);
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_release(made.balls);
    return status;
}
