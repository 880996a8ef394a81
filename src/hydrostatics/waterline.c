/* How far the waterline reaches: patches are halved where it may reach farther than it is known
 * to (branch and bound). */
#include "base/arena.h"
#include "hydrostatics/wet.h"
#include "numeric/bernstein.h"

#include <string.h>

enum { MOST_DEPTH = 100, MOST_HALVINGS = 100000 };

/* A part of a patch: heights above the water and places along the direction that is searched, both
 * times the weights, and the weights. */
typedef struct {
    double *values[3]; /* [degree[0] + 1][degree[1] + 1] */
    int depth;
} piece;

typedef struct {
    const bat_patch *patch;
    const double *direction;
    const bat_water *water;
    double tolerance, best;
    int halvings;
    piece pieces[MOST_DEPTH + 1];
} search;

static int point_count(const search *s)
{
    return (s->patch->degree[0] + 1) * (s->patch->degree[1] + 1);
}

static double place_of(const search *s, const double *p)
{
    return s->direction[0] * p[0] + s->direction[1] * p[1] + s->direction[2] * p[2];
}

/* Of the heights, so that place - multiplier * height changes least over a piece, in least squares:
 * on the waterline that is the place, and where the waterline turns it hardly changes. */
static double find_multiplier(const search *s, const piece *p)
{
    const int columns = s->patch->degree[1] + 1, count = point_count(s);
    const double *w = p->values[2];
    double ab = 0, bb = 0;
    for (int i = 1; i < count; i++)
        for (int k = 0; k < 2; k++) {
            const int last = i - (k == 0 ? columns : 1);
            if (k == 0 ? i < columns : i % columns == 0)
                continue;
            const double a = p->values[1][i] / w[i] - p->values[1][last] / w[last];
            const double b = p->values[0][i] / w[i] - p->values[0][last] / w[last];
            ab += a * b;
            bb += b * b;
        }
    return bb > 0 ? ab / bb : 0;
}

/* Does the waterline, when it passes the piece, perhaps reach beyond the best by more than the
 * tolerance? */
static bool may_gain(const search *s, const piece *p)
{
    const int count = point_count(s);
    const double multiplier = find_multiplier(s, p);
    bool below = false, above = false, beyond = false, beyond_there = false;
    for (int i = 0; i < count; i++) {
        const double height = p->values[0][i], place = p->values[1][i];
        const double wanted = (s->best + s->tolerance) * p->values[2][i];
        below |= height <= 0;
        above |= height >= 0;
        beyond |= place > wanted;
        beyond_there |= place - multiplier * height > wanted;
    }
    return below && above && beyond && beyond_there;
}

/* Points of the waterline on one side of a piece. */
static batten_status look_at_side(search *s, const piece *p, int first, int step, int degree)
{
    double row[3][BATTEN_MAX_DEGREE + 1], roots[BATTEN_MAX_DEGREE];
    int count = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k <= degree; k++)
            row[c][k] = p->values[c][first + k * step];
    const batten_status status = bat_row_roots(degree, row[0], roots, &count);
    for (int i = 0; i < count; i++)
        s->best = bat_max(s->best, bat_bernstein_value(degree, row[1], roots[i]) /
                                       bat_bernstein_value(degree, row[2], roots[i]));
    for (int k = 0; k <= degree; k += degree) /* also where all of the side is in the water */
        if (row[0][k] == 0)
            s->best = bat_max(s->best, row[1][k] / row[2][k]);
    return status;
}

static batten_status look_at_sides(search *s, const piece *p)
{
    const int *degree = s->patch->degree, columns = degree[1] + 1;
    batten_status status = look_at_side(s, p, 0, 1, degree[1]);
    if (status == BATTEN_OK)
        status = look_at_side(s, p, degree[0] * columns, 1, degree[1]);
    if (status == BATTEN_OK)
        status = look_at_side(s, p, 0, columns, degree[0]);
    if (status == BATTEN_OK)
        status = look_at_side(s, p, degree[1], columns, degree[0]);
    return status;
}

/* How much values (times weights) change from neighbour to neighbour in one direction. */
static double change_of(const search *s, const piece *p, int value, int direction)
{
    const int columns = s->patch->degree[1] + 1, count = point_count(s);
    const int step = direction == 0 ? columns : 1;
    double change = 0;
    for (int i = direction == 0 ? columns : 0; i < count; i++)
        if (direction == 0 || i % columns > 0) {
            const double *v = p->values[value], *w = p->values[2];
            change = bat_max(change, fabs(v[i] / w[i] - v[i - step] / w[i - step]));
        }
    return change * s->patch->degree[direction];
}

/* The direction in which heights and places together change more. */
static int direction_to_halve(const search *s, const piece *p)
{
    return change_of(s, p, 0, 0) + change_of(s, p, 1, 0) >=
                   change_of(s, p, 0, 1) + change_of(s, p, 1, 1)
               ? 0
               : 1;
}

/* Halve a piece in one direction, the first half in its own place and the second in the next. */
static void halve(search *s, piece *p, piece *other, int direction)
{
    const int degree = s->patch->degree[direction], columns = s->patch->degree[1] + 1;
    const int step = direction == 0 ? columns : 1;
    const int rows = s->patch->degree[!direction] + 1, next = direction == 0 ? 1 : columns;
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < rows; r++) {
            double row[BATTEN_MAX_DEGREE + 1], low[BATTEN_MAX_DEGREE + 1],
                high[BATTEN_MAX_DEGREE + 1];
            for (int k = 0; k <= degree; k++)
                row[k] = p->values[c][r * next + k * step];
            bat_bernstein_split(degree, row, 0.5, low, high);
            for (int k = 0; k <= degree; k++) {
                p->values[c][r * next + k * step] = low[k];
                other->values[c][r * next + k * step] = high[k];
            }
        }
    other->depth = ++p->depth;
}

static void begin_search(search *s)
{
    const double *n = s->water->n;
    for (int i = point_count(s) - 1; i >= 0; i--) {
        const double *p = s->patch->points + 4 * i;
        s->pieces[0].values[0][i] =
            n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - s->water->d * p[3];
        s->pieces[0].values[1][i] = place_of(s, p);
        s->pieces[0].values[2][i] = p[3];
    }
    s->pieces[0].depth = 0;
}

static batten_status search_patch(search *s)
{
    int waiting = 1;
    batten_status status = BATTEN_OK;
    begin_search(s);
    while (waiting > 0 && status == BATTEN_OK) {
        piece *p = &s->pieces[waiting - 1];
        if (may_gain(s, p))
            status = look_at_sides(s, p);
        if (!may_gain(s, p) || p->depth >= MOST_DEPTH)
            waiting--;
        else if (++s->halvings > MOST_HALVINGS)
            return bat_fail(
                BATTEN_TOLERANCE_NOT_MET,
                "the ends of the waterline are not found within the tolerance after "
                "%d halvings",
                MOST_HALVINGS);
        else
            halve(s, p, &s->pieces[waiting++], direction_to_halve(s, p));
    }
    return status;
}

/* Room for the pieces of the largest patch. */
static batten_status make_room(const batten_hull *hull, bat_arena *arena, search *s)
{
    size_t most = 0;
    for (int i = 0; i < hull->patch_count; i++) {
        s->patch = &hull->patches[i];
        most = most > (size_t)point_count(s) ? most : (size_t)point_count(s);
    }
    for (int i = 0; i <= MOST_DEPTH; i++)
        for (int c = 0; c < 3; c++)
            s->pieces[i].values[c] = bat_arena_array(arena, most, sizeof(double));
    return bat_arena_status(arena);
}

/* The farthest place of the waterline along a direction; -infinity without one. */
static batten_status find_reach(const batten_hull *hull, search *s, double *reach)
{
    batten_status status = BATTEN_OK;
    s->best = -INFINITY;
    s->halvings = 0;
    for (int i = 0; i < hull->patch_count && status == BATTEN_OK; i++) {
        s->patch = &hull->patches[i];
        if (s->patch->lid != BAT_JOINT)
            status = search_patch(s);
    }
    *reach = s->best;
    return status;
}

/* From where to where along `axis`, in the coordinates of the hull. */
static batten_status find_interval(const batten_hull *hull, search *s, const double axis[3],
                                   batten_interval *out)
{
    const double back[3] = {-axis[0], -axis[1], -axis[2]};
    double low, high, middle = 0;
    s->direction = back;
    batten_status status = find_reach(hull, s, &low);
    s->direction = axis;
    if (status == BATTEN_OK)
        status = find_reach(hull, s, &high);
    if (status != BATTEN_OK)
        return status;
    for (int c = 0; c < 3; c++)
        middle += axis[c] * hull->centre[c];
    *out = (batten_interval){0, 0};
    if (isfinite(low) && isfinite(high))
        *out = (batten_interval){middle - hull->size * low, middle + hull->size * high};
    return BATTEN_OK;
}

batten_status batten_hull_waterline(const batten_hull *hull, const batten_flotation *flotation,
                                    double tolerance, batten_interval *along,
                                    batten_interval *across)
{
    if (!(tolerance > 0) || !isfinite(tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the tolerance of a waterline is %g; it must be above 0", tolerance);
    bat_water water;
    bat_arena arena = {0};
    search *s = bat_arena_array(&arena, 1, sizeof *s);
    batten_interval found[2];
    batten_status status = s ? make_room(hull, &arena, s) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_water_of(hull, flotation, &water);
    if (status == BATTEN_OK) {
        s->water = &water;
        s->tolerance = tolerance / hull->size;
        status = find_interval(hull, s, water.along, &found[0]);
    }
    if (status == BATTEN_OK)
        status = find_interval(hull, s, water.across, &found[1]);
    if (status == BATTEN_OK) {
        *along = found[0];
        *across = found[1];
    }
    bat_arena_free(&arena);
    return status;
}
