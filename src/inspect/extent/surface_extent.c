/*
 * How far a surface reaches along an axis: branch and bound on its Bezier patches. No point of
 * a patch is higher than its highest control point, and its corners are points of it. Where
 * only a part of the surface counts, a patch across its border cannot lead by a corner; but
 * when it rises all over, its highest point is not inside, and the border is known.
 */
#include "inspect/extent/surface_extent.h"
#include "inspect/extent/extent_patches.h"
#include "numeric/bernstein.h"
#include "spline/surface/surface.h"

#include <string.h>

/* So often patches may be halved for one side of the box. */
enum { MOST_HALVED = 20000 };

/* A patch between parameters. */
typedef struct {
    double upper; /* no point of it is higher */
    batten_interval uv[2];
    bool crease[2][2]; /* whether the surface may be sharp at the ends along u, along v */
    bool whole;        /* all of it counts */
} cell;

/* The search along one axis. */
typedef struct {
    int degree[2];
    bool rational;
    size_t points, width; /* of a patch: control points, numbers of its slot */
    const bat_region *region;
    double tolerance;
    double reached, within;
    int halved;
    size_t count, room; /* of the cells that wait */
    cell *cells;        /* the last one is looked at next */
    double *slots; /* [room][width] of each its heights, [points]; if rational, these times the
                      weights, and the weights */
} climb;

/* ---- one patch ---- */

static double height_of(const climb *c, const double *slot, size_t i)
{
    return c->rational ? slot[i] / slot[c->points + i] : slot[i];
}

static double highest(const climb *c, const double *slot)
{
    double most = -HUGE_VAL;
    for (size_t i = 0; i < c->points; i++)
        most = bat_max(most, height_of(c, slot, i));
    return most;
}

static double highest_corner(const climb *c, const double *slot)
{
    const size_t n = (size_t)c->degree[1] + 1, last = c->points - n;
    return bat_max(bat_max(height_of(c, slot, 0), height_of(c, slot, n - 1)),
                   bat_max(height_of(c, slot, last), height_of(c, slot, c->points - 1)));
}

/* How far from straight the heights are along a direction: what halving there removes. */
static double bend(const climb *c, const double *slot, int direction)
{
    const size_t n = (size_t)c->degree[1] + 1, step = direction == 0 ? n : 1;
    double sum = 0;
    for (size_t i = 0; i < c->points; i++) {
        const size_t along = direction == 0 ? i / n : i % n;
        if (along >= 2)
            sum += fabs(height_of(c, slot, i) - 2 * height_of(c, slot, i - step) +
                        height_of(c, slot, i - 2 * step));
    }
    return sum;
}

/* 1 where the height rises everywhere along a direction, -1 where it falls; 0: not decided. Of
 * a fraction h = a / w the numerator of the slope is w a' - a w' = w (a' - h w'), and h is
 * between the least and the largest height of the control points. */
static int slope(const climb *c, const double *slot, int direction)
{
    const size_t n = (size_t)c->degree[1] + 1, step = direction == 0 ? n : 1;
    double low = HUGE_VAL, high = -HUGE_VAL, least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < c->points; i++) {
        low = bat_min(low, height_of(c, slot, i));
        high = bat_max(high, height_of(c, slot, i));
    }
    for (size_t i = 0; i < c->points; i++) {
        if ((direction == 0 ? i / n : i % n) == 0)
            continue;
        const double rise = slot[i] - slot[i - step];
        const double heavier =
            c->rational ? slot[c->points + i] - slot[c->points + i - step] : 0;
        least = bat_min(least, rise - bat_max(low * heavier, high * heavier));
        most = bat_max(most, rise - bat_min(low * heavier, high * heavier));
    }
    return least > 0 && least < HUGE_VAL ? 1 : most < 0 && most > -HUGE_VAL ? -1 : 0;
}

/* Does it rise to one of its sides, and may go on beyond? */
static bool leads_out(const climb *c, const cell *of, const double *slot)
{
    for (int k = 0; k < 2; k++) {
        const int way = slope(c, slot, k);
        if (way != 0 && !of->crease[k][way > 0])
            return true;
    }
    return false;
}

/* ---- the cells that wait ---- */

static bool may_lead(const climb *c, double upper)
{
    return upper > c->reached + c->tolerance;
}

static batten_status make_room(climb *c, size_t count)
{
    if (count <= c->room)
        return BATTEN_OK;
    const size_t room = count > 2 * c->room ? count : 2 * c->room;
    cell *cells = bat_resize(c->cells, room, sizeof *cells);
    if (cells)
        c->cells = cells;
    double *slots = cells ? bat_resize(c->slots, room, c->width * sizeof *slots) : NULL;
    if (!slots)
        return BATTEN_OUT_OF_MEMORY;
    c->slots = slots;
    c->room = room;
    return BATTEN_OK;
}

static double *slot_of(const climb *c, size_t i)
{
    return c->slots + i * c->width;
}

/* Take cell `i`, whose slot is filled, when it may lead; it is the last one then. */
static void keep_cell(climb *c, size_t i)
{
    cell *of = &c->cells[i];
    of->upper = highest(c, slot_of(c, i));
    if (!may_lead(c, of->upper)) {
        c->within = bat_max(c->within, of->upper);
        return;
    }
    if (i != c->count) {
        c->cells[c->count] = *of;
        memcpy(slot_of(c, c->count), slot_of(c, i), c->width * sizeof(double));
    }
    c->count++;
}

/* Both halves of a slot along a direction. */
static void halve(const climb *c, int direction, const double *slot, double *low, double *high)
{
    double row[BAT_BERNSTEIN_DEGREE + 1], half[2][BAT_BERNSTEIN_DEGREE + 1];
    const size_t n = (size_t)c->degree[1] + 1, m = (size_t)c->degree[0] + 1;
    const size_t step = direction == 0 ? n : 1, terms = direction == 0 ? m : n;
    for (size_t of = 0; of < c->width / c->points; of++)
        for (size_t line = 0; line < (direction == 0 ? n : m); line++) {
            const size_t first = of * c->points + line * (direction == 0 ? 1 : n);
            for (size_t i = 0; i < terms; i++)
                row[i] = slot[first + i * step];
            bat_bernstein_split((int)terms - 1, row, 0.5, half[0], half[1]);
            for (size_t i = 0; i < terms; i++) {
                low[first + i * step] = half[0][i];
                high[first + i * step] = half[1][i];
            }
        }
}

/* Along the direction that bends more; of a straight patch along its longer side. */
static int direction_to_halve(const climb *c, const cell *of, const double *slot)
{
    const double along_u = bend(c, slot, 0), along_v = bend(c, slot, 1);
    if (along_u == along_v)
        return of->uv[1].b - of->uv[1].a > of->uv[0].b - of->uv[0].a;
    return along_v > along_u;
}

/* The cell on top is halved; its higher half comes next. */
static batten_status halve_last(climb *c)
{
    batten_status status = make_room(c, c->count + 2);
    if (status != BATTEN_OK)
        return status;
    const size_t top = c->count - 1;
    const cell whole = c->cells[top];
    double *slot = slot_of(c, top), *other = slot_of(c, top + 1), *spare = slot_of(c, top + 2);
    const int k = direction_to_halve(c, &whole, slot);
    const batten_interval span = whole.uv[k];
    const double middle = span.a + 0.5 * (span.b - span.a);
    halve(c, k, slot, spare, other);
    memcpy(slot, spare, c->width * sizeof *slot);
    const bool swap = highest(c, slot) > highest(c, other);
    if (swap) {
        memcpy(slot, other, c->width * sizeof *slot);
        memcpy(other, spare, c->width * sizeof *slot);
    }
    for (int half = 0; half < 2; half++) {
        cell *of = &c->cells[top + (size_t)(half != swap)];
        *of = whole;
        if (half == 0)
            of->uv[k].b = middle;
        else
            of->uv[k].a = middle;
        of->crease[k][1 - half] = false;
    }
    c->count--;
    keep_cell(c, top);
    keep_cell(c, top + 1);
    c->halved++;
    return BATTEN_OK;
}

/* ---- the climb ---- */

/* Look at the cell on top: it leads, or waits in halves, or goes. */
static batten_status look_at_cell(climb *c)
{
    const size_t top = c->count - 1;
    cell *of = &c->cells[top];
    const double *slot = slot_of(c, top);
    if (!of->whole) {
        const bat_share share = c->region->share(c->region->context, of->uv);
        of->whole = share == BAT_ALL;
        if (share == BAT_NOTHING || (share == BAT_A_PART && leads_out(c, of, slot))) {
            c->count--;
            return BATTEN_OK;
        }
    }
    if (of->whole)
        c->reached = bat_max(c->reached, highest_corner(c, slot));
    if (may_lead(c, of->upper))
        return halve_last(c);
    c->within = bat_max(c->within, of->upper);
    c->count--;
    return BATTEN_OK;
}

static batten_status climb_all(climb *c)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && c->count > 0 && c->halved < MOST_HALVED)
        status = look_at_cell(c);
    for (size_t i = 0; i < c->count; i++)
        c->within = bat_max(c->within, c->cells[i].upper);
    c->within = bat_max(c->within, c->reached);
    c->count = 0;
    return status;
}

/* The heights of patch (i, j) along an axis, `sign` times the coordinate, into a slot. */
static void fill_heights(const climb *c, const bat_extent_patches *p, int i, int j, int axis,
                         double sign, double *slot)
{
    const int d = batten_surface_dimension(p->bezier);
    const size_t row = (size_t)batten_surface_point_count(p->bezier, BATTEN_V);
    const double *points = batten_surface_points(p->bezier);
    const double *weights = batten_surface_weights(p->bezier);
    const size_t n = (size_t)c->degree[1] + 1;
    for (size_t at = 0; at < c->points; at++) {
        const size_t of = ((size_t)i * (size_t)c->degree[0] + at / n) * row +
                          (size_t)j * (size_t)c->degree[1] + at % n;
        const double height = axis < d ? sign * points[of * (size_t)d + (size_t)axis] : 0;
        slot[at] = c->rational ? height * weights[of] : height;
        if (c->rational)
            slot[c->points + at] = weights[of];
    }
}

/* Twice over all patches: corners lead first where all counts, so that few patches wait. */
static batten_status add_patches(climb *c, const bat_extent_patches *p, int axis, double sign)
{
    for (int pass = c->region ? 1 : 0; pass < 2; pass++)
        for (int i = 0; i < p->spans[0]; i++)
            for (int j = 0; j < p->spans[1]; j++) {
                if (make_room(c, c->count + 1) != BATTEN_OK)
                    return BATTEN_OUT_OF_MEMORY;
                double *slot = slot_of(c, c->count);
                fill_heights(c, p, i, j, axis, sign, slot);
                c->cells[c->count] = (cell){
                    .uv = {{p->breaks[0][i], p->breaks[0][i + 1]},
                           {p->breaks[1][j], p->breaks[1][j + 1]}},
                    .crease = {{p->creases[0][i], p->creases[0][i + 1]},
                               {p->creases[1][j], p->creases[1][j + 1]}},
                    .whole = !c->region,
                };
                if (pass == 0)
                    c->reached = bat_max(c->reached, highest_corner(c, slot));
                else
                    keep_cell(c, c->count);
            }
    return BATTEN_OK;
}

/* ---- the sides of the box ---- */

static double *side_of(batten_box *box, int axis, bool high)
{
    batten_vec3 *corner = high ? &box->high : &box->low;
    return axis == 0 ? &corner->x : axis == 1 ? &corner->y : &corner->z;
}

static batten_status find_side(climb *c, const bat_extent_patches *p, int axis, bool high,
                               bat_extent *extent)
{
    const double sign = high ? 1 : -1;
    double *reached = side_of(&extent->reached, axis, high);
    double *within = side_of(&extent->within, axis, high);
    c->reached = sign * *reached;
    c->within = sign * *within;
    c->halved = 0;
    batten_status status = add_patches(c, p, axis, sign);
    if (status == BATTEN_OK)
        status = climb_all(c);
    *reached = sign * c->reached;
    *within = sign * c->within;
    return status;
}

batten_status bat_surface_extent(const batten_surface *surface, const bat_region *region,
                                 double tolerance, bat_extent *extent)
{
    bat_extent_patches p;
    climb c = {.region = region,
               .tolerance = tolerance,
               .rational = batten_surface_is_rational(surface),
               .degree = {batten_surface_degree(surface, BATTEN_U),
                          batten_surface_degree(surface, BATTEN_V)}};
    c.points = ((size_t)c.degree[0] + 1) * ((size_t)c.degree[1] + 1);
    c.width = c.rational ? 2 * c.points : c.points;
    batten_status status = bat_extent_patches_begin(surface, &p);
    for (int side = 0; status == BATTEN_OK && side < 6; side++)
        status = find_side(&c, &p, side / 2, side % 2, extent);
    bat_extent_patches_end(&p);
    bat_release(c.cells);
    bat_release(c.slots);
    return status;
}

double bat_extent_slack(const bat_extent *extent)
{
    bat_extent e = *extent;
    double slack = 0;
    for (int side = 0; side < 6; side++)
        slack = bat_max(slack, fabs(*side_of(&e.within, side / 2, side % 2) -
                                    *side_of(&e.reached, side / 2, side % 2)));
    return slack;
}
