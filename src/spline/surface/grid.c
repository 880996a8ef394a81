/*
 * Points, derivatives and normals on a grid of parameters. For each u the net is combined along
 * u once, into lines over all control points in v; each v then takes q + 1 numbers from them.
 * The sums are those of one point.
 */
#include "spline/surface/surface.h"

#include "base/work.h"
#include "spline/curve/curve.h"
#include "spline/surface/kernel.h"
#include "spline/surface/normal.h"

#include <string.h>

enum { CHUNK_POINTS = 4096, BLOCK = 32, FRAME = 9 };

/* Neighbouring control points in v that some parameter needs. */
typedef struct {
    int begin, end;
} run;

typedef struct {
    const bat_nurbs *nurbs;
    batten_uv_grid at;
    int order;
    double *basis;   /* [count_v][order + 1][q + 1] */
    int *first;      /* [count_v] first control point that bears */
    double *noise_v; /* [count_v] of the derivative in v; for normals only */
    run *runs;
    int run_count;
    double *out;              /* of evaluate_grid */
    double *points, *normals; /* of normal_grid, either may be NULL */
} grid;

/* ---- before the work ---- */

static batten_status check_parameters(const bat_axis *axis, size_t count, const double *u,
                                      const char *name)
{
    for (size_t i = 0; i < count; i++) {
        double at = u[i];
        const batten_status status = bat_axis_place(axis, BATTEN_FROM_RIGHT, &at);
        if (status != BATTEN_OK)
            return bat_fail(status, "%s[%zu] = %.17g is not in the domain [%.17g, %.17g]", name,
                            i, u[i], axis->breaks[0], axis->breaks[axis->span_count]);
    }
    return BATTEN_OK;
}

/* The span and the basis functions of a parameter that lies in the domain; the span's length.
 */
static double place_parameter(const bat_axis *axis, double u, int order, int *first,
                              double *basis)
{
    bat_axis_place(axis, BATTEN_FROM_RIGHT, &u);
    const int span = bat_axis_span(axis, u, BATTEN_FROM_RIGHT);
    bat_axis_basis(axis, span, u, order, basis);
    *first = bat_axis_first_point(axis, span);
    return axis->breaks[span + 1] - axis->breaks[span];
}

static void find_runs(grid *work, bool *needed)
{
    const bat_axis *axis = &work->nurbs->axes[BATTEN_V];
    for (size_t j = 0; j < work->at.count_v; j++)
        needed[work->first[j]] = true;
    work->run_count = 0;
    for (int j = 0; j + axis->degree < axis->count; j++) {
        if (!needed[j])
            continue;
        const bool joins = work->run_count > 0 && j <= work->runs[work->run_count - 1].end;
        if (!joins)
            work->runs[work->run_count++].begin = j;
        work->runs[work->run_count - 1].end = j + axis->degree + 1;
    }
}

/* Points of cubics in space are made two at a time, where two lie in one span. */
static bool works_in_pairs(const grid *work)
{
    const bat_nurbs *nurbs = work->nurbs;
    return BAT_LANES == 2 && work->order == 0 && nurbs->axes[BATTEN_V].degree == 3 &&
           nurbs->width == 3 && !nurbs->weights;
}

/* The end of the run of parameters, from j on, that lie in the span of v[j]. */
static size_t end_of_span(const grid *work, size_t j)
{
    const int first = work->first[j];
    while (j < work->at.count_v && work->first[j] == first)
        j++;
    return j;
}

/* The basis functions of the two points of a pair, side by side: [4][2] in place of [2][4]. */
static void pair_basis(grid *work)
{
    for (size_t j = 0, end; j < work->at.count_v; j = end) {
        end = end_of_span(work, j);
        for (; j + 1 < end; j += 2) {
            double *basis = work->basis + 4 * j, plain[8];
            memcpy(plain, basis, sizeof plain);
            for (int i = 0; i < 8; i++)
                basis[i] = plain[4 * (i % 2) + i / 2];
        }
    }
}

static batten_status prepare(grid *work)
{
    const bat_axis *axis = &work->nurbs->axes[BATTEN_V];
    const size_t rows = (size_t)work->order + 1, width = (size_t)axis->degree + 1;
    bool *needed = bat_array((size_t)axis->count, sizeof *needed);
    work->basis = bat_array3(work->at.count_v, rows * width, sizeof *work->basis);
    work->first = bat_array(work->at.count_v, sizeof *work->first);
    work->noise_v = bat_array(work->at.count_v, sizeof *work->noise_v);
    work->runs = bat_array((size_t)axis->count, sizeof *work->runs);
    const bool enough = needed && work->basis && work->first && work->noise_v && work->runs;
    if (enough) {
        for (size_t j = 0; j < work->at.count_v; j++) {
            const double span =
                place_parameter(axis, work->at.v[j], work->order, &work->first[j],
                                work->basis + j * rows * width);
            work->noise_v[j] = bat_derivative_noise(axis->degree, span, work->nurbs->largest);
        }
        find_runs(work, needed);
        if (works_in_pairs(work))
            pair_basis(work);
    }
    bat_release(needed);
    return enough ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void release(grid *work)
{
    bat_release(work->basis);
    bat_release(work->first);
    bat_release(work->noise_v);
    bat_release(work->runs);
}

static batten_status run_grid(grid *work, const batten_job *job, bat_chunk chunk)
{
    const bat_axis *axes = work->nurbs->axes;
    batten_status status = check_parameters(&axes[BATTEN_U], work->at.count_u, work->at.u, "u");
    if (status == BATTEN_OK)
        status = check_parameters(&axes[BATTEN_V], work->at.count_v, work->at.v, "v");
    if (status == BATTEN_OK && work->at.count_u > 0 && work->at.count_v > 0) {
        status = prepare(work);
        if (status == BATTEN_OK)
            status = bat_parallel(job, work->at.count_u, CHUNK_POINTS / work->at.count_v + 1,
                                  chunk, work);
        release(work);
    }
    return status;
}

/* ---- one u ---- */

/* The net combined along u: out [order + 1][count of v][width], where some v needs it. */
static double combine_lines(const grid *work, double u, double *basis, double *out)
{
    const bat_nurbs *nurbs = work->nurbs;
    const bat_axis *axis = &nurbs->axes[BATTEN_U];
    const size_t width = nurbs->width, line = (size_t)nurbs->axes[BATTEN_V].count * width;
    int first;
    const double span = place_parameter(axis, u, work->order, &first, basis);
    const int p = axis->degree;
    for (int k = 0; k <= work->order; k++)
        for (int r = 0; r < work->run_count; r++) {
            const size_t begin = (size_t)work->runs[r].begin * width;
            const size_t length = (size_t)work->runs[r].end * width - begin;
            const double *rows = nurbs->net + (size_t)first * line + begin;
            double *to = out + (size_t)k * line + begin;
            if (p == 3)
                bat_combine_rows(4, length, basis + k * 4, rows, line, to);
            else
                bat_combine_rows(p + 1, length, basis + k * (p + 1), rows, line, to);
        }
    return span;
}

/* ---- points and derivatives ---- */

#if defined(__GNUC__)
/* A row of three numbers, each in both lanes. */
typedef struct {
    bat_pair x, y, z;
} spread_row;

BAT_INLINE spread_row spread(const double *row)
{
    return (spread_row){{row[0], row[0]}, {row[1], row[1]}, {row[2], row[2]}};
}

/* The points of one span, two at a time: each lane is a point, so the rows of the span, which
 * begin at `from`, stay in registers. The sums are those of bat_combine_rows. */
BAT_INLINE void pairs_of_span(size_t pairs, const double *basis, const double *from,
                              double *out)
{
    const spread_row r0 = spread(from), r1 = spread(from + 3), r2 = spread(from + 6),
                     r3 = spread(from + 9);
    for (; pairs > 0; pairs--, basis += 8, out += 6) {
        const bat_pair c0 = bat_load(basis), c1 = bat_load(basis + 2), c2 = bat_load(basis + 4),
                       c3 = bat_load(basis + 6);
        const bat_pair x = c0 * r0.x + c1 * r1.x + c2 * r2.x + c3 * r3.x;
        const bat_pair y = c0 * r0.y + c1 * r1.y + c2 * r2.y + c3 * r3.y;
        const bat_pair z = c0 * r0.z + c1 * r1.z + c2 * r2.z + c3 * r3.z;
        bat_store(out, (bat_pair){x[0], y[0]});
        bat_store(out + 2, (bat_pair){z[0], x[1]});
        bat_store(out + 4, (bat_pair){y[1], z[1]});
    }
}

static void paired_points_of_row(const grid *work, const double *lines, double *out)
{
    for (size_t j = 0, end; j < work->at.count_v; j = end) {
        const double *from = lines + (size_t)work->first[j] * 3, *basis = work->basis;
        end = end_of_span(work, j);
        pairs_of_span((end - j) / 2, basis + 4 * j, from, out + 3 * j);
        if ((end - j) % 2 == 1)
            bat_combine_rows(4, 3, basis + 4 * (end - 1), from, 3, out + 3 * (end - 1));
    }
}
#endif

/* The degree in v, the dimension, and whether there are weights: constants where it pays. */
typedef struct {
    int q, d;
    bool rational;
} form;

BAT_INLINE void points_of_row(const form is, const grid *work, const double *lines, double *out)
{
    const int q = is.q, d = is.d;
    const bool rational = is.rational;
    const size_t width = (size_t)d + rational;
    for (size_t j = 0; j < work->at.count_v; j++, out += d) {
        const double *basis = work->basis + j * ((size_t)q + 1);
        const double *from = lines + (size_t)work->first[j] * width;
        double row[BAT_MAX_WIDTH];
        bat_combine_rows(q + 1, width, basis, from, width, rational ? row : out);
        if (rational)
            bat_project(d, row, out);
    }
}

/* What the derivatives of one point are made from: the lines of the net, one for each
 * derivative in u, from the first row that bears on the point. Degrees, width and order are
 * constants where it pays. */
typedef struct {
    int p, q;
    size_t width;
    int order;
    const double *lines;
    size_t line; /* the length of one */
} point_lines;

/* All derivatives of one point: rows [BATTEN_SURFACE_DERIVATIVES(order)][width]. */
BAT_INLINE void derivatives_of_point(const point_lines on, const double *basis, double *rows)
{
    const int p = on.p, q = on.q, order = on.order;
    const size_t width = on.width;
    for (int k = 0; k <= order; k++)
        for (int l = 0; k + l <= order; l++) {
            double *row = rows + (size_t)BATTEN_SURFACE_DERIVATIVE(k, l) * width;
            if (k <= p && l <= q)
                bat_combine_rows(q + 1, width, basis + l * (q + 1),
                                 on.lines + (size_t)k * on.line, width, row);
            else
                memset(row, 0, width * sizeof *row);
        }
}

static void derivatives_of_row(const grid *work, const double *lines, double *rows, double *out)
{
    const bat_nurbs *nurbs = work->nurbs;
    const int p = nurbs->axes[BATTEN_U].degree, q = nurbs->axes[BATTEN_V].degree;
    const size_t width = nurbs->width, line = (size_t)nurbs->axes[BATTEN_V].count * width;
    const size_t n = (size_t)work->order,
                 size = (n + 1) * (n + 2) / 2 * (size_t)nurbs->base.dimension;
    for (size_t j = 0; j < work->at.count_v; j++, out += size) {
        const double *basis = work->basis + j * (n + 1) * ((size_t)q + 1);
        const double *from = lines + (size_t)work->first[j] * width;
        double *to = nurbs->weights ? rows : out;
        if (q == 3 && width == 3)
            derivatives_of_point((point_lines){p, 3, 3, work->order, from, line}, basis, to);
        else if (q == 3 && width == 4)
            derivatives_of_point((point_lines){p, 3, 4, work->order, from, line}, basis, to);
        else
            derivatives_of_point((point_lines){p, q, width, work->order, from, line}, basis,
                                 to);
        if (nurbs->weights)
            bat_surface_divide(nurbs->base.dimension, work->order, rows, out);
    }
}

static void evaluate_row(const grid *work, const double *lines, double *rows, double *out)
{
    const bat_nurbs *nurbs = work->nurbs;
    const int q = nurbs->axes[BATTEN_V].degree, d = nurbs->base.dimension;
    if (work->order > 0)
        derivatives_of_row(work, lines, rows, out);
#if defined(__GNUC__)
    else if (works_in_pairs(work))
        paired_points_of_row(work, lines, out);
#endif
    else if (q == 3 && nurbs->width == 3 && !nurbs->weights)
        points_of_row((form){3, 3, false}, work, lines, out);
    else if (q == 3 && nurbs->width == 4)
        points_of_row((form){3, 3, true}, work, lines, out);
    else
        points_of_row((form){q, d, nurbs->weights != NULL}, work, lines, out);
}

/* Room for the basis in u, the lines, and one table of derivatives or a block of frames. */
typedef struct {
    double *basis, *lines, *rows;
} row_room;

static batten_status make_room(const grid *work, row_room *out)
{
    const bat_nurbs *nurbs = work->nurbs;
    const size_t n = (size_t)work->order,
                 line = (size_t)nurbs->axes[BATTEN_V].count * nurbs->width;
    const size_t basis = (n + 1) * ((size_t)nurbs->axes[BATTEN_U].degree + 1);
    const size_t table = (n + 1) * (n + 2) / 2 * BAT_MAX_WIDTH, frames = BLOCK * FRAME;
    double *room =
        bat_array(basis + (n + 1) * line + (table > frames ? table : frames), sizeof *room);
    if (!room)
        return BATTEN_OUT_OF_MEMORY;
    *out = (row_room){room, room + basis, room + basis + (n + 1) * line};
    return BATTEN_OK;
}

static batten_status overflow(const grid *work, size_t i)
{
    return bat_fail(BATTEN_OVERFLOW,
                    "a point or derivative at u[%zu] = %.17g is too large for a number", i,
                    work->at.u[i]);
}

static batten_status evaluate_rows(void *context, size_t begin, size_t end)
{
    const grid *work = context;
    const size_t n = (size_t)work->order, d = (size_t)work->nurbs->base.dimension;
    const size_t row = work->at.count_v * ((n + 1) * (n + 2) / 2) * d;
    /* Means of control points, a few roundings aside, do not overflow. */
    const bool bounded = n == 0 && !work->nurbs->weights && work->nurbs->largest < 1e300;
    row_room room;
    batten_status status = make_room(work, &room);
    if (status != BATTEN_OK)
        return status;
    for (size_t i = begin; i < end && status == BATTEN_OK; i++) {
        combine_lines(work, work->at.u[i], room.basis, room.lines);
        evaluate_row(work, room.lines, room.rows, work->out + i * row);
        if (!bounded && !bat_all_finite(work->out + i * row, row))
            status = overflow(work, i);
    }
    bat_release(room.basis);
    return status;
}

batten_status bat_nurbs_evaluate_grid(const batten_surface *surface, batten_uv_grid places,
                                      int order, const batten_job *job, double *out)
{
    grid work = {.nurbs = bat_nurbs_of(surface), .at = places, .order = order, .out = out};
    return run_grid(&work, job, evaluate_rows);
}

batten_status batten_surface_evaluate_grid(const batten_surface *surface, batten_uv_grid places,
                                           int order, const batten_job *job, double *out)
{
    assert(surface && order >= 0);
    return surface->kind->evaluate_grid(surface, places, order, job, out);
}

/* ---- normals ---- */

/* S, Su and Sv of homogeneous ones. */
BAT_INLINE void project_frame(const int d, const double *rows, double out[FRAME])
{
    const double w = rows[d];
    for (int c = 0; c < d; c++)
        out[c] = rows[c] / w;
    for (int k = 1; k < 3; k++)
        for (int c = 0; c < d; c++)
            out[3 * k + c] = (rows[k * (d + 1) + c] - rows[k * (d + 1) + d] * out[c]) / w;
}

/* Rows of d numbers, three numbers apart. */
BAT_INLINE void spread_frame(const int d, const double *rows, double out[FRAME])
{
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < d; c++)
            out[3 * k + c] = rows[k * d + c];
}

/* S, Su, Sv in space, whatever the dimension: out [3][3]. */
BAT_INLINE void frame_of_point(const form is, const double *basis, const double *lines,
                               size_t line, double out[FRAME])
{
    const int d = is.d;
    const bool rational = is.rational;
    double rows[3 * BAT_MAX_WIDTH];
    const point_lines on = {1, is.q, (size_t)d + rational, 1, lines, line};
    derivatives_of_point(on, basis, rational || d < 3 ? rows : out);
    if (rational)
        project_frame(d, rows, out);
    else if (d < 3)
        spread_frame(d, rows, out);
    for (int k = 0; k < 3; k++)
        for (int c = d; c < 3; c++)
            out[3 * k + c] = 0;
}

/* A normal that needs a limit, or (0, 0, 0) where there is none. */
static batten_status rare_normal(const grid *work, size_t i, size_t j, double *normal)
{
    bool is_limit;
    const batten_status status = bat_surface_limit_normal(&work->nurbs->base, work->at.u[i],
                                                          work->at.v[j], normal, &is_limit);
    if (status == BATTEN_SINGULAR_HERE)
        memset(normal, 0, 3 * sizeof *normal);
    return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
}

/* The line of one u. */
typedef struct {
    size_t i;
    const double *lines;     /* the net combined along u */
    double noise_u;          /* of the derivative in u */
    double (*frames)[FRAME]; /* [BLOCK] */
} normal_line;

static batten_status normals_of_block(const grid *work, const normal_line *on, size_t begin,
                                      size_t end)
{
    batten_status status = BATTEN_OK;
    for (size_t j = begin; j < end && status == BATTEN_OK; j++) {
        const double *frame = on->frames[j - begin];
        double *normal = work->normals + (on->i * work->at.count_v + j) * 3;
        if (!bat_regular_normal(frame + 3, frame + 6, on->noise_u, work->noise_v[j], normal))
            status = rare_normal(work, on->i, j, normal);
    }
    return status;
}

/* First the frames of a block, then their normals: two loops that the processor can overlap
 * within themselves. */
BAT_INLINE batten_status normals_of_row(const form is, const grid *work, const normal_line *on)
{
    const size_t width = (size_t)is.d + is.rational;
    const size_t line = (size_t)work->nurbs->axes[BATTEN_V].count * width;
    batten_status status = BATTEN_OK;
    for (size_t begin = 0; begin < work->at.count_v && status == BATTEN_OK; begin += BLOCK) {
        const size_t end = begin + BLOCK < work->at.count_v ? begin + BLOCK : work->at.count_v;
        for (size_t j = begin; j < end; j++)
            frame_of_point(is, work->basis + j * 2 * ((size_t)is.q + 1),
                           on->lines + (size_t)work->first[j] * width, line,
                           on->frames[j - begin]);
        for (size_t j = begin; work->points && j < end; j++)
            memcpy(work->points + (on->i * work->at.count_v + j) * 3, on->frames[j - begin],
                   3 * sizeof(double));
        if (work->normals)
            status = normals_of_block(work, on, begin, end);
    }
    return status;
}

static batten_status normal_row(const grid *work, const normal_line *on)
{
    const bat_nurbs *nurbs = work->nurbs;
    const int q = nurbs->axes[BATTEN_V].degree, d = nurbs->base.dimension;
    batten_status status;
    if (q == 3 && d == 3 && !nurbs->weights)
        status = normals_of_row((form){3, 3, false}, work, on);
    else if (q == 3 && d == 3)
        status = normals_of_row((form){3, 3, true}, work, on);
    else
        status = normals_of_row((form){q, d, nurbs->weights != NULL}, work, on);
    const size_t row = 3 * work->at.count_v;
    if (status == BATTEN_OK && work->points && !bat_all_finite(work->points + on->i * row, row))
        status = overflow(work, on->i);
    return status;
}

static batten_status normal_rows(void *context, size_t begin, size_t end)
{
    const grid *work = context;
    const bat_nurbs *nurbs = work->nurbs;
    row_room room;
    batten_status status = make_room(work, &room);
    if (status != BATTEN_OK)
        return status;
    for (size_t i = begin; i < end && status == BATTEN_OK; i++) {
        const double span = combine_lines(work, work->at.u[i], room.basis, room.lines);
        const normal_line on = {
            i, room.lines,
            bat_derivative_noise(nurbs->axes[BATTEN_U].degree, span, nurbs->largest),
            (double(*)[FRAME])(void *)room.rows};
        status = normal_row(work, &on);
    }
    bat_release(room.basis);
    return status;
}

batten_status bat_nurbs_normal_grid(const batten_surface *surface, batten_uv_grid places,
                                    const batten_job *job, double *points, double *normals)
{
    grid work = {.nurbs = bat_nurbs_of(surface),
                 .at = places,
                 .order = 1,
                 .points = points,
                 .normals = normals};
    return run_grid(&work, job, normal_rows);
}

batten_status batten_surface_normal_grid(const batten_surface *surface, batten_uv_grid places,
                                         const batten_job *job, double *points, double *normals)
{
    assert(surface);
    if (surface->dimension < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface of dimension %d has no normal",
                        surface->dimension);
    return surface->kind->normal_grid(surface, places, job, points, normals);
}
