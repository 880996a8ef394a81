/* Where ends of curves or edges of surfaces meet, and how smoothly: g0, g1, g2 and g3. */
#include "design/outputs/joins.h"

#include <stdlib.h>

/* More joins than these are not listed. */
#define MOST_JOINS 10000

/* An end of a curve, or an edge of a surface with the points at both its ends. */
typedef struct {
    int object, side;
    batten_vec3 p[2];
    double key;     /* the same for both directions of an edge, and in order of x */
    batten_box box; /* of an edge */
} end;

static batten_status add_ends(const bat_checked *checked, int object, double tolerance,
                              end *ends, int *count)
{
    const bool is_curve = checked->object->kind == BATTEN_OBJECT_CURVE;
    batten_status status = BATTEN_OK;
    for (int side = 0; side < (is_curve ? 2 : 4) && status == BATTEN_OK; side++) {
        batten_curve *curve = NULL;
        status = is_curve ? BATTEN_OK : bat_edge_curve(checked->object->surface, side, &curve);
        const batten_curve *at = is_curve ? checked->object->curve : curve;
        double p[2][3], middle[3];
        const batten_interval domain =
            status == BATTEN_OK ? batten_curve_domain(at) : (batten_interval){0, 1};
        const int d = status == BATTEN_OK ? batten_curve_dimension(at) : 3;
        for (int k = 0; k < 2 && status == BATTEN_OK; k++)
            status =
                batten_curve_evaluate(at, (is_curve ? side : k) ? domain.b : domain.a, 0, p[k]);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(at, domain.a + (domain.b - domain.a) / 2, 0, middle);
        /* An edge that is collapsed to a pole joins nothing. */
        if (status == BATTEN_OK &&
            (is_curve || bat_join_gap(bat_vec3_of(d, p[0]), bat_vec3_of(d, p[1])) > tolerance ||
             bat_join_gap(bat_vec3_of(d, p[0]), bat_vec3_of(d, middle)) > tolerance))
            ends[(*count)++] = (end){object,
                                     side,
                                     {bat_vec3_of(d, p[0]), bat_vec3_of(d, p[1])},
                                     p[0][0] + p[1][0],
                                     batten_curve_box(at)};
        batten_curve_unref(curve);
    }
    return status;
}

/* Objects in order, and their sides. */
static int by_object(const end *a, const end *b)
{
    return a->object != b->object ? (a->object > b->object) - (a->object < b->object)
                                  : a->side - b->side;
}

static int by_key(const void *a, const void *b)
{
    const end *x = a, *y = b;
    if (x->key != y->key)
        return x->key < y->key ? -1 : 1;
    return by_object(x, y);
}

/* Do both points of one meet both points of the other, in either order? */
static double ends_gap(const end *a, const end *b)
{
    return bat_min(bat_max(bat_join_gap(a->p[0], b->p[0]), bat_join_gap(a->p[1], b->p[1])),
                   bat_max(bat_join_gap(a->p[0], b->p[1]), bat_join_gap(a->p[1], b->p[0])));
}

static double size_of(const batten_object *object)
{
    const batten_box box = object->kind == BATTEN_OBJECT_CURVE
                               ? batten_curve_box(object->curve)
                               : batten_surface_box(object->surface);
    return bat_join_gap(box.low, box.high);
}

/* Room for twice as many whenever their number is a power of 2. */
static batten_status grow_joins(bat_check *check)
{
    if ((check->join_count & (check->join_count - 1)) == 0) {
        bat_join *grown =
            bat_resize(check->joins, 2 * (size_t)check->join_count + 1, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        check->joins = grown;
    }
    return BATTEN_OK;
}

static void leave_joins_out(bat_check *check)
{
    if (!check->joins_left_out)
        bat_note(check->run, "more than %d joins; the others are not listed", MOST_JOINS);
    check->joins_left_out = true;
}

static batten_status keep_join(bat_check *check, const bat_join *join)
{
    if (check->join_count == MOST_JOINS) {
        leave_joins_out(check);
        return BATTEN_OK;
    }
    if (grow_joins(check) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    check->joins[check->join_count++] = *join;
    return BATTEN_OK;
}

/* The join of two ends, when they meet. The first of two edges may run along a part of the
 * second. */
static batten_status add_join(bat_check *check, const end *a, const end *b, double tolerance,
                              bool is_part)
{
    const batten_object *x = check->objects[a->object].object,
                        *y = check->objects[b->object].object;
    const double size = bat_max(size_of(x), size_of(y));
    const bool swap = by_object(a, b) > 0;
    const end *first = swap ? b : a, *second = swap ? a : b;
    bat_join join = {.object = {first->object, second->object},
                     .side = {first->side, second->side},
                     .part = !is_part ? -1 : swap,
                     .g0 = is_part ? 0 : ends_gap(a, b),
                     .parametric = -1,
                     .geometric = -1};
    batten_status status = BATTEN_OK;
    if (x->kind == BATTEN_OBJECT_CURVE)
        status = bat_compare_curves(x->curve, a->side, y->curve, b->side, tolerance, &join);
    else
        status = bat_compare_surfaces(x->surface, a->side, y->surface, b->side, tolerance,
                                      tolerance / (size * size), &join);
    if (status != BATTEN_OK || !(join.g0 <= tolerance))
        return status;
    return keep_join(check, &join);
}

static batten_status stopped(const bat_check *check, int i, int count)
{
    batten_job job = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, check->run->job, &job);
    if (taken != BATTEN_OK)
        return taken;
    if (job.is_cancelled && job.is_cancelled(job.user))
        return bat_fail(BATTEN_CANCELLED, "cancelled at end %d of %d", i + 1, count);
    return BATTEN_OK;
}

/* Along the sorted keys only those that are near each other can meet. */
static batten_status sweep(bat_check *check, int count, const end *ends, double tolerance)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        status = stopped(check, i, count);
        for (int j = i + 1; j < count && ends[j].key - ends[i].key <= 2 * tolerance &&
                            status == BATTEN_OK && !check->joins_left_out;
             j++) {
            const bool in_order = by_object(&ends[i], &ends[j]) < 0;
            const end *a = &ends[in_order ? i : j], *b = &ends[in_order ? j : i];
            const batten_object_kind kind = check->objects[a->object].object->kind;
            if (kind == check->objects[b->object].object->kind && ends_gap(a, b) <= tolerance)
                status = add_join(check, a, b, tolerance, false);
        }
    }
    return status;
}

/* ---- edges along a part of others ---- */

static int by_start(const void *a, const void *b)
{
    const end *x = a, *y = b;
    if (x->p[0].x != y->p[0].x)
        return x->p[0].x < y->p[0].x ? -1 : 1;
    return by_object(x, y);
}

/* May this edge run along a part of that one? One no longer than the tolerance, which would be
 * near whatever it touches, does not. */
static bool may_be_part(const end *part, const end *of_this, double tolerance)
{
    const batten_vec3 low = part->box.low, high = part->box.high;
    return (part->object != of_this->object || part->side != of_this->side) &&
           bat_join_gap(low, high) > 8 * tolerance &&
           bat_join_is_in(&of_this->box, part->p[0], tolerance) &&
           bat_join_is_in(&of_this->box, part->p[1], tolerance) &&
           ends_gap(part, of_this) > tolerance;
}

/* The first of the sorted edges that starts at x or behind it. */
static int first_from(int count, const end *edges, double x)
{
    int low = 0, high = count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (edges[middle].p[0].x < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* For each edge those that start within the width of its box; ends of curves are dropped. */
static batten_status sweep_parts(bat_check *check, int count, end *ends, double tolerance)
{
    batten_status status = BATTEN_OK;
    int edges = 0;
    for (int i = 0; i < count; i++)
        if (check->objects[ends[i].object].object->kind == BATTEN_OBJECT_SURFACE)
            ends[edges++] = ends[i];
    qsort(ends, (size_t)edges, sizeof *ends, by_start);
    for (int i = 0; i < edges && status == BATTEN_OK; i++) {
        const batten_box *box = &ends[i].box;
        status = stopped(check, i, edges);
        for (int j = first_from(edges, ends, box->low.x - tolerance);
             j < edges && ends[j].p[0].x <= box->high.x + tolerance && status == BATTEN_OK &&
             !check->joins_left_out;
             j++)
            if (may_be_part(&ends[j], &ends[i], tolerance))
                status = add_join(check, &ends[j], &ends[i], tolerance, true);
    }
    return status;
}

static int by_place(const void *a, const void *b)
{
    const bat_join *x = a, *y = b;
    const int p[4] = {x->object[0], x->object[1], x->side[0], x->side[1]};
    const int q[4] = {y->object[0], y->object[1], y->side[0], y->side[1]};
    for (int k = 0; k < 4; k++)
        if (p[k] != q[k])
            return p[k] < q[k] ? -1 : 1;
    return 0;
}

batten_status bat_joins_find(bat_check *check)
{
    const double tolerance = bat_tolerance(check->run);
    end *ends = bat_array(4 * (size_t)check->object_count + 1, sizeof *ends);
    batten_status status = ends ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int i = 0; i < check->object_count && status == BATTEN_OK; i++) {
        const batten_object_kind kind = check->objects[i].object->kind;
        if (kind == BATTEN_OBJECT_CURVE || kind == BATTEN_OBJECT_SURFACE)
            status = add_ends(&check->objects[i], i, tolerance, ends, &count);
    }
    if (status == BATTEN_OK) {
        qsort(ends, (size_t)count, sizeof *ends, by_key);
        status = sweep(check, count, ends, tolerance);
    }
    if (status == BATTEN_OK)
        status = sweep_parts(check, count, ends, tolerance);
    if (status == BATTEN_OK && check->join_count)
        qsort(check->joins, (size_t)check->join_count, sizeof *check->joins, by_place);
    bat_release(ends);
    return status;
}

const char *bat_side_name(const batten_object *object, int side)
{
    static const char *const curve_sides[] = {"start", "end"};
    static const char *const surface_sides[] = {"u low", "u high", "v low", "v high"};
    return object->kind == BATTEN_OBJECT_CURVE ? curve_sides[side] : surface_sides[side];
}
