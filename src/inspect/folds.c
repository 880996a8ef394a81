/* Where a surface folds: where its normal reverses although nothing has a crease there. */
#include "inspect/fold_cones.h"
#include "numeric/vector.h"
#include <batten/measure.h>

#include <string.h>

/* Places in each span, and at least in each direction: what bends by less than a right angle between two of them
 * is seen as bent, what bends by more is looked at closely. */
enum { IN_SPAN = 3, AT_LEAST = 12, HALVINGS = 16 };

/* Lines of places evaluated by one call, which shares the basis along them. */
enum { LINES = 16 };

/* Below this sine of the angle between both derivatives the normal is noise: a corner where two sides meet
 * smoothly may turn there but for rounding. */
static const double least_sine = 1e-3;
/* Neighbours of a fold are opposed to the last digit, those of an edge are not. */
static const double opposed = -0.9;
/* At a cusp the speed falls to nothing, at an edge it does not. */
static const double slow = 0.01;
/* A side shorter than that part of the largest coordinate is a pole, and its direction is noise: control points
 * that were meant as one differ by some roundings of what made them. */
static const double one_point = 1e-12;

typedef struct {
    double u, v;
    batten_vec3 point, along[2], normal; /* the derivatives in u and v, and their product */
    bool regular, is_pole;
} place;

/* Is the sine of the angle between the derivatives larger? By squares, where these are numbers. */
static bool is_wider(const place *p, double sine)
{
    const double squares = sine * sine * bat_vec3_dot(p->along[0], p->along[0]) *
                           bat_vec3_dot(p->along[1], p->along[1]);
    return isnormal(squares) ? bat_vec3_dot(p->normal, p->normal) > squares
                             : bat_vec3_norm(p->normal) > sine * bat_vec3_norm(p->along[0]) *
                                                              bat_vec3_norm(p->along[1]);
}

static batten_vec3 unit_normal(const place *p)
{
    return bat_vec3_scale(p->normal, 1 / bat_vec3_norm(p->normal));
}

/* The cosine of the angle between the normals of regular places, or what has its sign: their product where that is
 * a number. */
static double agreement(const place *a, const place *b)
{
    const double product = bat_vec3_dot(a->normal, b->normal);
    return isnormal(product) ? product : bat_vec3_dot(unit_normal(a), unit_normal(b));
}

static void see_place(int d, const double *values, double sine, place *p)
{
    p->point = bat_vec3_of(d, values);
    p->along[0] = bat_vec3_of(d, values + d);
    p->along[1] = bat_vec3_of(d, values + 2 * d);
    p->normal = bat_vec3_cross(p->along[0], p->along[1]);
    p->regular = is_wider(p, sine);
}

/* Is there a fold between two places that differ in one parameter? Where they near each other without that their
 * normals do, there is. */
static batten_status look_closely(const batten_surface *surface, int direction, place a,
                                  place b, bool *found)
{
    const batten_vec3 first[2] = {a.along[direction], b.along[direction]};
    const int d = batten_surface_dimension(surface);
    *found = false;
    for (int i = 0; i < HALVINGS; i++) {
        double values[9];
        /* Not in the middle, where knots and symmetric folds lie. */
        place m = {.u = a.u + 0.48 * (b.u - a.u), .v = a.v + 0.48 * (b.v - a.v)};
        const batten_status status = batten_surface_evaluate(surface, m.u, m.v, 1, values);
        if (status != BATTEN_OK)
            return status;
        /* Normals of derivatives that are parallel to 1e-12 are rounding. */
        see_place(d, values, 1e-12, &m);
        if (!m.regular)
            break;
        if (agreement(&a, &m) < 0)
            b = m;
        else if (agreement(&m, &b) < 0)
            a = m;
        else
            return BATTEN_OK;
    }
    const bool turns = bat_vec3_dot(a.along[direction], b.along[direction]) < 0;
    const bool keeps = bat_vec3_dot(a.along[1 - direction], b.along[1 - direction]) > 0;
    const bool runs = bat_vec3_norm(a.along[direction]) > slow * bat_vec3_norm(first[0]) &&
                      bat_vec3_norm(b.along[direction]) > slow * bat_vec3_norm(first[1]);
    *found =
        bat_vec3_dot(unit_normal(&a), unit_normal(&b)) < opposed && !(turns && keeps && runs);
    return BATTEN_OK;
}

static batten_status compare(const batten_surface *surface, int direction, const place *a,
                             const place *b, batten_surface_fold *fold)
{
    if (fold->found || !a->regular || !b->regular || agreement(a, b) >= 0)
        return BATTEN_OK;
    if (a->is_pole && b->is_pole)
        return BATTEN_OK; /* all of it is one point */
    const batten_status status = look_closely(surface, direction, *a, *b, &fold->found);
    if (status == BATTEN_OK && fold->found)
        *fold = (batten_surface_fold){true, b->u, b->v, b->point};
    return status;
}

/* The largest absolute coordinate of the box of a surface. */
static double largest_coordinate(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    const double ends[] = {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
    double largest = 0;
    for (int i = 0; i < 6; i++)
        largest = bat_max(largest, fabs(ends[i]));
    return largest;
}

/* One direction: its spans, and the places where a range of them is looked at, with room for all; a derivative that is no
 * longer than `still` stands still there. */
typedef struct {
    int spans, each, count;
    double *knots, *at, *still;
} places;

static batten_status begin_places(const batten_surface *surface, batten_direction direction,
                                  places *p)
{
    p->spans = batten_surface_spans(surface, direction, NULL) - 1;
    p->each = p->spans * IN_SPAN >= AT_LEAST ? IN_SPAN : (AT_LEAST + p->spans - 1) / p->spans;
    p->knots = bat_array((size_t)p->spans + 1, sizeof *p->knots);
    const size_t most = (size_t)p->spans * (size_t)p->each + 2;
    p->at = bat_array(most, sizeof *p->at);
    p->still = bat_array(most, sizeof *p->still);
    if (!p->knots || !p->at || !p->still)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, direction, p->knots);
    return BATTEN_OK;
}

static void add_place(double at, double still, places *p)
{
    p->at[p->count] = at;
    p->still[p->count++] = still;
}

/* Places off the knots, and both ends: a fold at a rim or a corner is seen however narrow it is. They are those of the spans
 * first .. end - 1 and of one more at each side. What moves less than `least` across its span stands still. */
static void list_places(places *p, int first, int end, double least)
{
    first = bat_max_int(0, first - 1);
    end = bat_min_int(p->spans, end + 1);
    p->count = 0;
    for (int k = first; k < end; k++) {
        const double width = p->knots[k + 1] - p->knots[k], still = least / width;
        if (k == 0)
            add_place(p->knots[0], still, p);
        for (int j = 0; j < p->each; j++)
            add_place(p->knots[k] + (j + 0.5) / p->each * width, still, p);
        if (k == p->spans - 1)
            add_place(p->knots[p->spans], still, p);
    }
}

/* Lines of places, each compared with the one before; both lines stand in turn in `pair`. */
typedef struct {
    const batten_surface *surface;
    const places *u, *v;
    place *pair; /* [2][v->count] */
} scanner;

/* Where a derivative stands still nothing can be said, but that it stands still along a side: a pole, at which the lines that
 * end there leave in the directions of the mixed derivative. */
static batten_status see_pole(const scanner *s, int i, int j, place *p)
{
    const bool still[2] = {bat_vec3_norm(p->along[0]) <= s->u->still[i],
                           bat_vec3_norm(p->along[1]) <= s->v->still[j]};
    const int d = batten_surface_dimension(s->surface);
    const int across = still[0] ? 1 : 0;
    const batten_interval domain =
        batten_surface_domain(s->surface, across ? BATTEN_V : BATTEN_U);
    const double at = across ? p->v : p->u;
    p->is_pole = still[0] != still[1] && (at <= domain.a || at >= domain.b);
    if (!p->is_pole) {
        p->regular = p->regular && !still[0] && !still[1];
        return BATTEN_OK;
    }
    double values[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    const batten_status status = batten_surface_evaluate(s->surface, p->u, p->v, 2, values);
    if (status != BATTEN_OK)
        return status;
    p->along[1 - across] =
        bat_vec3_scale(bat_vec3_of(d, values + 4 * d), at <= domain.a ? 1 : -1);
    p->normal = bat_vec3_cross(p->along[0], p->along[1]);
    p->regular = is_wider(p, least_sine);
    return BATTEN_OK;
}

static batten_status scan_line(const scanner *s, int line, const double *values,
                               batten_surface_fold *fold)
{
    const int n = s->v->count, d = batten_surface_dimension(s->surface);
    place *now = s->pair + (size_t)(line % 2) * (size_t)n,
          *before = s->pair + (size_t)(1 - line % 2) * (size_t)n;
    batten_status status = BATTEN_OK;
    for (int j = 0; j < n && status == BATTEN_OK; j++) {
        now[j].u = s->u->at[line];
        now[j].v = s->v->at[j];
        see_place(d, values + 3 * (size_t)d * (size_t)j, least_sine, &now[j]);
        status = see_pole(s, line, j, &now[j]);
        if (j > 0 && status == BATTEN_OK)
            status = compare(s->surface, 1, &now[j - 1], &now[j], fold);
        if (line > 0 && status == BATTEN_OK)
            status = compare(s->surface, 0, &before[j], &now[j], fold);
    }
    return status;
}

static batten_status scan(const batten_surface *surface, const places *u, const places *v,
                          batten_surface_fold *fold)
{
    const size_t n = (size_t)v->count, line = n * 3 * (size_t)batten_surface_dimension(surface);
    double *values = bat_array3(LINES, line, sizeof *values);
    const scanner s = {surface, u, v, bat_array3(2, n, sizeof *s.pair)};
    batten_status status = values && s.pair ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < u->count && status == BATTEN_OK && !fold->found; i += LINES) {
        const int lines = bat_min_int(LINES, u->count - i);
        const batten_uv_grid grid = {(size_t)lines, n, u->at + i, v->at};
        status = batten_surface_evaluate_grid(surface, grid, 1, NULL, values);
        for (int k = 0; k < lines && status == BATTEN_OK && !fold->found; k++)
            status = scan_line(&s, i + k, values + (size_t)k * line, fold);
    }
    bat_release(s.pair);
    bat_release(values);
    return status;
}

/* The first fold in the order of u, then v, whatever the order of the ranges. */
static batten_status scan_ranges(const batten_surface *surface, const bat_span_ranges *ranges,
                                 batten_surface_fold *first)
{
    places along[2] = {{.count = 0}, {.count = 0}};
    const double least = one_point * largest_coordinate(surface);
    batten_status status = begin_places(surface, BATTEN_U, &along[0]);
    if (status == BATTEN_OK)
        status = begin_places(surface, BATTEN_V, &along[1]);
    for (int i = 0; i < ranges->count && status == BATTEN_OK; i++) {
        batten_surface_fold fold = {.found = false};
        for (int k = 0; k < 2; k++)
            list_places(&along[k], ranges->at[i].first[k], ranges->at[i].end[k], least);
        status = scan(surface, &along[0], &along[1], &fold);
        if (fold.found &&
            (!first->found || fold.u < first->u || (fold.u == first->u && fold.v < first->v)))
            *first = fold;
    }
    for (int k = 0; k < 2; k++) {
        bat_release(along[k].knots);
        bat_release(along[k].at);
        bat_release(along[k].still);
    }
    return status;
}

batten_status batten_surface_find_fold(const batten_surface *surface, batten_surface_fold *out)
{
    const int d = batten_surface_dimension(surface);
    batten_surface_fold fold = {.found = false};
    bat_span_ranges ranges = {NULL, 0, 0};
    if (d != 2 && d != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "folds are looked for in 2 or 3 dimensions, and there are %d", d);
    batten_status status = bat_folds_possible(surface, &ranges);
    if (status == BATTEN_OK && ranges.count > 0)
        status = scan_ranges(surface, &ranges, &fold);
    if (status == BATTEN_OK)
        *out = fold;
    bat_release(ranges.at);
    return status;
}
