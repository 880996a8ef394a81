/* Cubics along implicit curves: proof of their distance, division, joining. */
#include "shape/equation/fit.h"

#include "base/list.h"
#include "numeric/rounding.h"

#define CUBIC 3

/* ---- one cubic ---- */

void bat_segment_tangent(bat_system *system, const double *point, int graph, double sense,
                         double *out)
{
    bat_curve_tangent(system, point, out);
    if (out[graph] * sense < 0)
        for (int k = 0; k < system->dimension; k++)
            out[k] = -out[k];
}

static double distance(int dimension, const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < dimension; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

/* The length of the arc of a circle with this chord and these tangents at its ends. */
static double length_of(int dimension, const bat_segment *s)
{
    double dot = 0;
    for (int k = 0; k < dimension; k++)
        dot += s->leave[k] * s->arrive[k];
    const double half = 0.5 * bat_acos(bat_max(-1, bat_min(1, dot)));
    const double chord = distance(dimension, s->from, s->to);
    return s->is_line || half < BAT_MEANT_SAME ? chord : chord * half / bat_sin(half);
}

static void find_legs(int dimension, const bat_segment *s, double legs[CUBIC + 1][BAT_SPACE])
{
    const double third = length_of(dimension, s) / 3;
    for (int k = 0; k < dimension; k++) {
        const double step = (s->to[k] - s->from[k]) / 3;
        legs[0][k] = s->from[k];
        legs[3][k] = s->to[k];
        legs[1][k] = s->from[k] + (s->is_line ? step : third * s->leave[k]);
        legs[2][k] = s->to[k] - (s->is_line ? step : third * s->arrive[k]);
    }
}

/* ---- the proof ---- */

/* The coordinates of the cubic as jets of its parameter. */
static void find_path(const bat_system *s, double legs[CUBIC + 1][BAT_SPACE], bat_interval t,
                      bat_interval_jet *out)
{
    bat_interval_jet parameter, power;
    bat_ijet_variable(&s->along, 0, t, &parameter);
    for (int k = 0; k < s->dimension; k++) {
        const double b0 = legs[0][k], b1 = legs[1][k], b2 = legs[2][k], b3 = legs[3][k];
        const double c[CUBIC + 1] = {b0, 3 * (b1 - b0), 3 * (b2 - 2 * b1 + b0),
                                     b3 - 3 * b2 + 3 * b1 - b0};
        bat_ijet_constant(&s->along, bat_interval_at(c[CUBIC]), &out[k]);
        for (int i = CUBIC - 1; i >= 0; i--) {
            bat_ijet_multiply(&s->along, &out[k], &parameter, &out[k]);
            bat_ijet_constant(&s->along, bat_interval_at(c[i]), &power);
            bat_ijet_add(&s->along, &out[k], &power, &out[k]);
        }
    }
}

/* How large equation i becomes along a cubic: by the fourth derivative, t^2 (1 - t)^2 <= 1/16; and by values and
 * slopes at the ends, which are there by rounding alone, times 1 and 4/27. */
static double residual_of(bat_system *s, int i, double legs[CUBIC + 1][BAT_SPACE])
{
    enum { PARTS = 2 };
    bat_interval_jet path[BAT_SPACE], f;
    double fourth = 0, ends = 0;
    for (int part = 0; part < PARTS; part++) {
        const bat_interval t = {(double)part / PARTS, (double)(part + 1) / PARTS};
        find_path(s, legs, t, path);
        bat_equation_jet(s->equation[i], &s->along, path, &f);
        if (s->along.state != BAT_DEFINED)
            return INFINITY;
        fourth = bat_max(fourth, bat_interval_size(f.c[4]));
    }
    for (int end = 0; end < 2; end++) {
        find_path(s, legs, bat_interval_at(end), path);
        bat_equation_jet(s->equation[i], &s->along, path, &f);
        ends += bat_interval_size(f.c[0]) + 4.0 / 27 * bat_interval_size(f.c[1]);
    }
    return fourth / 16 + ends;
}

/* The cells and the control points in one. */
static bat_cell hull_of(const bat_system *s, const bat_segment *segment,
                        double legs[CUBIC + 1][BAT_SPACE])
{
    bat_cell hull = segment->cell;
    for (int i = 0; i <= CUBIC; i++)
        for (int k = 0; k < s->dimension; k++)
            hull.at[k] = bat_interval_hull(hull.at[k], bat_interval_at(legs[i][k]));
    return hull;
}

static bool is_monotone(double legs[CUBIC + 1][BAT_SPACE], int k)
{
    const double sense = legs[CUBIC][k] > legs[0][k] ? 1 : -1;
    for (int i = 0; i < CUBIC; i++)
        if (!((legs[i + 1][k] - legs[i][k]) * sense > 0))
            return false;
    return true;
}

/* Where both the curve and the cubic are graphs over an axis, in the hull, the mean value theorem says
 * M d = F for their distance d across it, with M among the derivatives in the hull. */
static double prove_cubic(bat_system *s, const bat_segment *segment)
{
    double legs[CUBIC + 1][BAT_SPACE] = {{0}}, residual[BAT_EQUATIONS], size = 0;
    bat_enclosure e;
    find_legs(s->dimension, segment, legs);
    const bat_cell hull = hull_of(s, segment, legs);
    bat_system_over(s, &hull, &e);
    double best = INFINITY;
    for (int i = 0; i < s->equations; i++)
        residual[i] = residual_of(s, i, legs);
    for (int k = 0; k < s->dimension; k++) {
        bat_regularity r;
        size = bat_max(size, bat_interval_size(hull.at[k]));
        if (!is_monotone(legs, k) || !bat_is_graph(s, &e, k, &r))
            continue;
        double largest = 0;
        for (int i = 0; i < s->equations; i++) {
            double sum = 0;
            for (int j = 0; j < s->equations; j++)
                sum += fabs(r.inverse[i][j]) * residual[j];
            largest = bat_max(largest, sum);
        }
        best = bat_min(best, sqrt(s->equations) * largest / (1 - r.departure));
    }
    /* de Casteljau: three levels, each of which rounds three times. */
    return best + 9 * DBL_EPSILON * size;
}

/* ---- division ---- */

static batten_status cannot_divide(const bat_segment *s, double tolerance)
{
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "near (%.6g, %.6g, %.6g) rounding does not allow a distance of %g to be proved",
        s->from[0], s->from[1], s->from[2], tolerance);
}

void bat_segment_tighten(bat_system *system, bat_segment *segment)
{
    const int k = segment->graph;
    const bat_interval along = {bat_min(segment->from[k], segment->to[k]),
                                bat_max(segment->from[k], segment->to[k])};
    bat_cell cell = segment->cell;
    cell.at[k] = along;
    if (bat_cell_tighten(system, k, &cell))
        segment->cell = cell;
    else
        segment->cell.at[k] = along;
}

/* The cell, wider by a tenth and by rounding across the graph: a crossing on its side is inside of this. That is the
 * right one when it is the only one. */
static bat_cell widen_across(const bat_system *s, const bat_segment *segment)
{
    bat_cell wide = segment->cell;
    for (int k = 0; k < s->dimension; k++) {
        const double more =
            0.1 * bat_interval_width(wide.at[k]) +
            BAT_EXACT * (bat_interval_size(wide.at[k]) + bat_cell_extent(s, &wide));
        if (k != segment->graph)
            wide.at[k] = (bat_interval){wide.at[k].lo - more, wide.at[k].hi + more};
    }
    return wide;
}

/* Cut a segment in two at a point of the curve near its middle. */
static bool cut_segment(bat_system *s, const bat_segment *whole, bat_segment *first,
                        bat_segment *second)
{
    static const double shares[] = {0.5, 0.41, 0.63, 0.3, 0.72};
    const int k = whole->graph;
    const double sense = whole->to[k] > whole->from[k] ? 1 : -1;
    const bat_cell wide = widen_across(s, whole);
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) {
        double point[BAT_SPACE] = {0, 0, 0}, radius;
        const double at = whole->from[k] + shares[i] * (whole->to[k] - whole->from[k]);
        if (!((at - whole->from[k]) * sense > 0 && (whole->to[k] - at) * sense > 0))
            return false;
        if (bat_find_crossing(s, &whole->cell, k, at, point, &radius) != BAT_ONE_CROSSING &&
            bat_find_crossing(s, &wide, k, at, point, &radius) != BAT_ONE_CROSSING)
            continue;
        *first = *second = *whole;
        for (int j = 0; j < s->dimension; j++)
            first->to[j] = second->from[j] = point[j];
        bat_segment_tangent(s, point, k, sense, first->arrive);
        bat_segment_tangent(s, point, k, sense, second->leave);
        bat_segment_tighten(s, first);
        bat_segment_tighten(s, second);
        return true;
    }
    return false;
}

/* Where derivatives fail, a part of the curve that lies in a cell no larger than the tolerance is a line. */
static bool accept_line(const bat_system *s, double tolerance, bat_segment *segment)
{
    if (!(bat_cell_diagonal(s, &segment->cell) <= tolerance))
        return false;
    segment->is_link = segment->is_line = segment->has_corner = true;
    return true;
}

/* Append `whole`, in parts each of which is proved alone. */
static batten_status divide_segment(bat_system *s, double tolerance, const bat_segment *whole,
                                    bat_segments *out)
{
    /* Beyond this many halvings, nothing is left of a segment. */
    enum { MOST = 60 };
    bat_segments waiting = {NULL, 0, 0};
    batten_status status = BAT_LIST_GROW(waiting.items, 0, waiting.room, MOST);
    if (status == BATTEN_OK)
        waiting.items[waiting.count++] = *whole;
    while (status == BATTEN_OK && waiting.count > 0) {
        bat_segment segment = waiting.items[--waiting.count];
        bat_segment *top = waiting.items + waiting.count;
        if (segment.is_link || prove_cubic(s, &segment) <= tolerance ||
            accept_line(s, tolerance, &segment))
            status = BAT_LIST_ADD(out->items, out->count, out->room, segment);
        else if (waiting.count + 2 <= MOST && cut_segment(s, &segment, top + 1, top))
            waiting.count += 2;
        else
            status = cannot_divide(&segment, tolerance);
    }
    bat_release(waiting.items);
    return status;
}

/* ---- joining ---- */

static bat_segment join_two(const bat_system *s, const bat_segment *a, const bat_segment *b)
{
    bat_segment joined = *a;
    for (int k = 0; k < s->dimension; k++) {
        joined.to[k] = b->to[k];
        joined.arrive[k] = b->arrive[k];
        joined.cell.at[k] = bat_interval_hull(a->cell.at[k], b->cell.at[k]);
    }
    return joined;
}

/* Join neighbours from the start on, while the cubic of all of them is proved. */
static void join_segments(bat_system *s, double tolerance, bat_segments *branch, double *error)
{
    int kept = 0;
    for (int i = 0; i < branch->count;) {
        bat_segment joined = branch->items[i++];
        double proved = joined.has_corner ? bat_cell_diagonal(s, &joined.cell)
                        : joined.is_link  ? 0
                                          : prove_cubic(s, &joined);
        while (!joined.is_link && i < branch->count && !branch->items[i].is_link) {
            const bat_segment longer = join_two(s, &joined, &branch->items[i]);
            const double next = prove_cubic(s, &longer);
            if (!(next <= tolerance))
                break;
            joined = longer;
            proved = next;
            i++;
        }
        *error = bat_max(*error, proved);
        branch->items[kept++] = joined;
    }
    branch->count = kept;
}

batten_status bat_segments_fit(bat_system *system, double tolerance, bat_segments *branch,
                               double *error)
{
    bat_segments divided = {NULL, 0, 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; i < branch->count && status == BATTEN_OK; i++)
        status = divide_segment(system, tolerance, &branch->items[i], &divided);
    if (status != BATTEN_OK) {
        bat_release(divided.items);
        return status;
    }
    join_segments(system, tolerance, &divided, error);
    bat_release(branch->items);
    *branch = divided;
    return BATTEN_OK;
}

double bat_segments_extent(const bat_system *system, const bat_segments *branch)
{
    double sum = 0;
    for (int i = 0; i < branch->count; i++)
        sum += distance(system->dimension, branch->items[i].from, branch->items[i].to);
    const bool closed = distance(system->dimension, branch->items[0].from,
                                 branch->items[branch->count - 1].to) == 0;
    return closed ? (double)INFINITY : sum;
}

/* ---- the curve ---- */

static bool have_one_tangent(int dimension, const bat_segment *l, const bat_segment *r)
{
    if (l->is_line || r->is_line)
        return false;
    for (int k = 0; k < dimension; k++)
        if (fabs(l->arrive[k] - r->leave[k]) > BAT_ROUNDING)
            return false;
    return true;
}

typedef struct {
    int dimension, point_count, knot_count;
    double *points, *knots;
} builder;

static void add_point(builder *b, const double *point)
{
    for (int k = 0; k < b->dimension; k++)
        b->points[b->point_count * b->dimension + k] = point[k];
    b->point_count++;
}

static void add_knots(builder *b, double at, int count)
{
    while (count-- > 0)
        b->knots[b->knot_count++] = at;
}

/* The parameter is about the length. */
static void join_cubics(builder *b, const bat_segments *branch)
{
    double at = 0, legs[CUBIC + 1][BAT_SPACE];
    add_knots(b, 0, CUBIC + 1);
    for (int i = 0; i < branch->count; i++) {
        const bat_segment *s = &branch->items[i];
        const bool begins = i == 0, ends = i + 1 == branch->count;
        const bool smooth_before = !begins && have_one_tangent(b->dimension, s - 1, s);
        const bool smooth_after = !ends && have_one_tangent(b->dimension, s, s + 1);
        find_legs(b->dimension, s, legs);
        if (begins)
            add_point(b, legs[0]);
        else
            add_knots(b, at, smooth_before ? CUBIC - 1 : CUBIC);
        add_point(b, legs[1]);
        add_point(b, legs[2]);
        if (!smooth_after)
            add_point(b, legs[3]);
        at += length_of(b->dimension, s);
    }
    add_knots(b, at, CUBIC + 1);
}

batten_status bat_segments_curve(int dimension, const bat_segments *branch, batten_curve **out)
{
    const size_t most = CUBIC * (size_t)branch->count + 1;
    builder b = {.dimension = dimension};
    b.points = bat_array(most * (size_t)dimension, sizeof *b.points);
    b.knots = bat_array(most + CUBIC + 1, sizeof *b.knots);
    batten_status status = b.points && b.knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        join_cubics(&b, branch);
        status = batten_curve_create((batten_points){dimension, b.point_count, b.points}, CUBIC,
                                     NULL, b.knots, out);
    }
    bat_release(b.points);
    bat_release(b.knots);
    return status;
}
