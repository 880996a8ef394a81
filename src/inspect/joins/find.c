/* Where ends of curves or edges of surfaces meet, and how smoothly, among any number of them. */
#include "base/list.h"
#include "base/work.h"
#include "inspect/continuity.h"
#include "inspect/joins/joins.h"
#include "numeric/box.h"
#include "numeric/vector.h"

#include <stdlib.h>

/* More joins than these are not listed. */
enum { MOST_JOINS = 10000 };

/* An end of a curve, or an edge of a surface with the points at both its ends. */
typedef struct {
    int shape, side;
    batten_vec3 p[2];
    double key;     /* the same for both directions of an edge, and in order of x */
    batten_box box; /* of an edge */
} end;

/* What is searched: curves or surfaces, the other is NULL. */
typedef struct {
    int count;
    const batten_curve *const *curves;
    const batten_surface *const *surfaces;
    batten_curve_continuity_options bounds;
    bat_work work;
    batten_joins *found;
    int room; /* of what is found */
} search;

static double gap_of(batten_vec3 p, batten_vec3 q)
{
    return bat_vec3_norm(bat_vec3_subtract(p, q));
}

static batten_box box_of(const search *s, int shape)
{
    return s->curves ? batten_curve_box(s->curves[shape])
                     : batten_surface_box(s->surfaces[shape]);
}

/* The first, the middle and the last point of a curve. */
static batten_status look_along(const batten_curve *curve, batten_vec3 out[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    const double u[3] = {domain.a, domain.a + (domain.b - domain.a) / 2, domain.b};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 3 && status == BATTEN_OK; k++) {
        double p[3];
        status = batten_curve_evaluate(curve, u[k], 0, p);
        if (status == BATTEN_OK)
            out[k] = bat_vec3_of(batten_curve_dimension(curve), p);
    }
    return status;
}

static batten_status add_ends_of_curve(const search *s, int shape, end *ends, int *count)
{
    batten_vec3 p[3];
    const batten_status status = look_along(s->curves[shape], p);
    for (int side = 0; side < 2 && status == BATTEN_OK; side++) {
        const batten_vec3 at = p[2 * side];
        ends[(*count)++] = (end){shape, side, {at, at}, 2 * at.x, {{0, 0, 0}, {0, 0, 0}}};
    }
    return status;
}

/* An edge that is collapsed to a pole joins nothing. */
static batten_status add_edges(const search *s, int shape, end *ends, int *count)
{
    const double tolerance = s->bounds.gap;
    batten_status status = BATTEN_OK;
    for (int side = 0; side < 4 && status == BATTEN_OK; side++) {
        batten_curve *curve = NULL;
        batten_vec3 p[3];
        status = bat_side_curve(s->surfaces[shape], side, &curve);
        if (status == BATTEN_OK)
            status = look_along(curve, p);
        if (status == BATTEN_OK &&
            (gap_of(p[0], p[2]) > tolerance || gap_of(p[0], p[1]) > tolerance))
            ends[(*count)++] =
                (end){shape, side, {p[0], p[2]}, p[0].x + p[2].x, batten_curve_box(curve)};
        batten_curve_unref(curve);
    }
    return status;
}

/* Shapes in order, and their sides. */
static int by_shape(const end *a, const end *b)
{
    return a->shape != b->shape ? (a->shape > b->shape) - (a->shape < b->shape)
                                : a->side - b->side;
}

static int by_key(const void *a, const void *b)
{
    const end *x = a, *y = b;
    if (x->key != y->key)
        return x->key < y->key ? -1 : 1;
    return by_shape(x, y);
}

/* Do both points of one meet both points of the other, in either order? */
static double ends_gap(const end *a, const end *b)
{
    return bat_min(bat_max(gap_of(a->p[0], b->p[0]), gap_of(a->p[1], b->p[1])),
                   bat_max(gap_of(a->p[0], b->p[1]), gap_of(a->p[1], b->p[0])));
}

/* The join of two ends, when they meet. The first of two edges may run along a part of the
 * second. */
static batten_status add_join(search *s, const end *a, const end *b, bool is_part)
{
    const bool swap = by_shape(a, b) > 0;
    const end *first = swap ? b : a, *second = swap ? a : b;
    batten_join join = {.shape = {first->shape, second->shape},
                        .side = {first->side, second->side},
                        .part = !is_part ? -1 : swap,
                        .edge = -1};
    const batten_status status =
        s->curves ? bat_join_of_curves(s->curves[a->shape], a->side, s->curves[b->shape],
                                       b->side, &s->bounds, &join)
                  : bat_join_of_surfaces(s->surfaces[a->shape], a->side, s->surfaces[b->shape],
                                         b->side, &s->bounds, &join);
    if (status != BATTEN_OK || !(join.gap.value <= s->bounds.gap))
        return status;
    if (s->found->count == MOST_JOINS) {
        s->found->left_out = true;
        return BATTEN_OK;
    }
    return BAT_LIST_ADD(s->found->at, s->found->count, s->room, join);
}

/* Along the sorted keys only those that are near each other can meet. */
static batten_status find_whole(search *s, int count, const end *ends)
{
    const double tolerance = s->bounds.gap;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        status = bat_work_step(&s->work, 1, 0.5 * i / count, "finding joins");
        for (int j = i + 1; j < count && ends[j].key - ends[i].key <= 2 * tolerance &&
                            status == BATTEN_OK && !s->found->left_out;
             j++) {
            const bool in_order = by_shape(&ends[i], &ends[j]) < 0;
            const end *a = &ends[in_order ? i : j], *b = &ends[in_order ? j : i];
            if (ends_gap(a, b) <= tolerance)
                status = add_join(s, a, b, false);
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
    return by_shape(x, y);
}

/* May this edge run along a part of that one? One no longer than the tolerance, which would be
 * near whatever it touches, does not. */
static bool may_be_part(const end *part, const end *of_this, double tolerance)
{
    const batten_vec3 low = part->box.low, high = part->box.high;
    return (part->shape != of_this->shape || part->side != of_this->side) &&
           gap_of(low, high) > 8 * tolerance &&
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

/* For each edge those that start within the width of its box. */
static batten_status find_parts(search *s, int count, end *ends)
{
    const double tolerance = s->bounds.gap;
    batten_status status = BATTEN_OK;
    qsort(ends, (size_t)count, sizeof *ends, by_start);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        const batten_box *box = &ends[i].box;
        status = bat_work_step(&s->work, 1, 0.5 + 0.5 * i / count, "finding joins");
        for (int j = first_from(count, ends, box->low.x - tolerance);
             j < count && ends[j].p[0].x <= box->high.x + tolerance && status == BATTEN_OK &&
             !s->found->left_out;
             j++)
            if (may_be_part(&ends[j], &ends[i], tolerance))
                status = add_join(s, &ends[j], &ends[i], true);
    }
    return status;
}

static int by_place(const void *a, const void *b)
{
    const batten_join *x = a, *y = b;
    const int p[5] = {x->shape[0], x->shape[1], x->side[0], x->side[1], x->part};
    const int q[5] = {y->shape[0], y->shape[1], y->side[0], y->side[1], y->part};
    for (int k = 0; k < 5; k++)
        if (p[k] != q[k])
            return p[k] < q[k] ? -1 : 1;
    return 0;
}

static batten_status find_all(search *s, end *ends)
{
    int count = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < s->count && status == BATTEN_OK; i++)
        status =
            s->curves ? add_ends_of_curve(s, i, ends, &count) : add_edges(s, i, ends, &count);
    if (status != BATTEN_OK)
        return status;
    qsort(ends, (size_t)count, sizeof *ends, by_key);
    status = find_whole(s, count, ends);
    if (status == BATTEN_OK && s->surfaces)
        status = find_parts(s, count, ends);
    return status;
}

/* The gap that is not given, over the size of all. */
static const double usual_gap = 1e-6;

static batten_status take_bounds(search *s, const batten_curve_continuity_options *options)
{
    const batten_status status = bat_continuity_bounds(options, &s->bounds);
    if (status != BATTEN_OK || s->bounds.gap > 0)
        return status;
    batten_box all = bat_box_of_nothing();
    for (int i = 0; i < s->count; i++)
        bat_box_join(&all, box_of(s, i));
    s->bounds.gap = s->count ? usual_gap * bat_box_diagonal(all) : 0;
    return BATTEN_OK;
}

static batten_status search_joins(search *s, const batten_curve_continuity_options *options,
                                  batten_joins *out)
{
    batten_joins found = {0, NULL, false};
    batten_status status = take_bounds(s, options);
    if (status != BATTEN_OK)
        return status;
    end *ends = bat_array(4 * (size_t)s->count + 1, sizeof *ends);
    s->found = &found;
    status = ends ? find_all(s, ends) : BATTEN_OUT_OF_MEMORY;
    bat_release(ends);
    if (status != BATTEN_OK) {
        bat_release(found.at);
        return status;
    }
    if (found.count)
        qsort(found.at, (size_t)found.count, sizeof *found.at, by_place);
    *out = found;
    return BATTEN_OK;
}

batten_status batten_curves_joins(int count, const batten_curve *const *curves,
                                  const batten_curve_continuity_options *options,
                                  const batten_job *job, batten_joins *out)
{
    assert(count >= 0 && (curves || count == 0) && out);
    search s = {.count = count, .curves = curves, .work = {.job = job}};
    return search_joins(&s, options, out);
}

batten_status batten_surfaces_joins(int count, const batten_surface *const *surfaces,
                                    const batten_curve_continuity_options *options,
                                    const batten_job *job, batten_joins *out)
{
    assert(count >= 0 && (surfaces || count == 0) && out);
    search s = {.count = count, .surfaces = surfaces, .work = {.job = job}};
    return search_joins(&s, options, out);
}

void batten_joins_release(batten_joins *joins)
{
    bat_release(joins->at);
    *joins = (batten_joins){0, NULL, false};
}
