/* Uniform Beta-splines, as Bezier pieces. */
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "spline/data_check.h"
#include <batten/interpolate.h>

#include <float.h>
#include <string.h>

/* The weights of three neighbours of the control polygon in the joint between two pieces, and
 * what else a piece needs of the betas. Powers of beta1 are divided by the sum of all, so that
 * no beta is too large. */
typedef struct {
    double before, own, after; /* (2 b1^3, 4 b1^2 + 4 b1 + b2, 2) / delta */
    /* The inner Bezier points of a piece, by the control points at its begin and end. */
    double inner[2][2];
} shape;

static shape shape_of(double b1, double b2)
{
    const double delta = 2 * b1 * b1 * b1 + 4 * b1 * b1 + 4 * b1 + b2 + 2;
    const double own = (4 * b1 * b1 + 4 * b1 + b2) / delta;
    const double first = 2 * b1 / delta * (b1 * b1 + 2 * b1 + 1);
    const double second = 2 * b1 / delta * (b1 * b1 + b1);
    shape s = {2 * b1 * b1 * b1 / delta, own, 2 / delta, {{0, 0}, {0, 0}}};
    /* Beyond the point itself: 2 b1 + 2 and 2 b1^2 + 4 b1 + b2 + 2, of delta. */
    s.inner[0][0] = first + b2 / delta;
    s.inner[0][1] = (2 * b1 + 2) / delta;
    s.inner[1][0] = second;
    s.inner[1][1] = (2 * b1 * b1 + 4 * b1 + b2 + 2) / delta;
    return s;
}

/* Control points with more on either side: those that close the curve, one before and two
 * behind, or those that let it begin and end at the first and last without curvature, one each;
 * cage [count + 3][d]. */
static void extend(int d, int count, bool closed, double b1, double *cage)
{
    const double ratio = b1 * b1 * b1;
    double *first = cage + d, *last = cage + count * d;
    for (int k = 0; k < d; k++) {
        cage[k] = closed ? last[k] : first[k] + (first[k] - first[d + k]) / ratio;
        last[d + k] = closed ? first[k] : last[k] + ratio * (last[k] - last[k - d]);
        last[2 * d + k] = closed ? first[d + k] : 0;
    }
}

/* The equations of the joints: of an open curve the ends are given. */
typedef struct {
    int d, count;
    bool closed;
    double *matrix;     /* [count][3], factored when open */
    bat_cyclic *cyclic; /* when closed */
} joints;

static batten_status factor(const shape *s, joints *j)
{
    for (int i = 0; i < j->count; i++) {
        const bool end = !j->closed && (i == 0 || i == j->count - 1);
        j->matrix[3 * i] = end ? 0 : s->before;
        j->matrix[3 * i + 1] = end ? 1 : s->own;
        j->matrix[3 * i + 2] = end ? 0 : s->after;
    }
    return j->closed ? bat_cyclic_factor(j->count, 1, 1, j->matrix, &j->cyclic)
                     : bat_banded_factor(j->count, 1, 1, j->matrix);
}

/* What the joints of the cage lack of the points. */
static void find_rest(const shape *s, const joints *j, const double *points, const double *cage,
                      double *rest)
{
    const int d = j->d, n = j->count;
    for (int i = 0; i < n; i++) {
        const bool end = !j->closed && (i == 0 || i == n - 1);
        const double *own = cage + i * d, *before = cage + (i ? i - 1 : n - 1) * d,
                     *after = cage + (i + 1 < n ? i + 1 : 0) * d;
        for (int k = 0; k < d; k++)
            rest[i * d + k] =
                points[i * d + k] -
                (end ? own[k] : s->before * before[k] + s->own * own[k] + s->after * after[k]);
    }
}

/* The control points whose joints are the points. Where beta1 is far from 1 the matrix is not
 * dominant; the second solution takes away the errors of the first. */
static batten_status find_cage(const shape *s, joints *j, const double *points, double *cage)
{
    const size_t n = (size_t)j->count, d = (size_t)j->d;
    double *rest = bat_array3(n, d, sizeof *rest);
    j->matrix = bat_array3(n, 3, sizeof *j->matrix);
    batten_status status = rest && j->matrix ? factor(s, j) : BATTEN_OUT_OF_MEMORY;
    memset(cage, 0, n * d * sizeof *cage);
    for (int pass = 0; pass < 2 && status == BATTEN_OK; pass++) {
        find_rest(s, j, points, cage, rest);
        if (j->closed)
            status = bat_cyclic_solve(j->cyclic, d, rest);
        else
            bat_banded_solve(j->count, 1, 1, j->matrix, d, rest);
        for (size_t i = 0; i < n * d; i++)
            cage[i] += rest[i];
    }
    bat_cyclic_free(j->cyclic);
    bat_release(j->matrix);
    bat_release(rest);
    return status;
}

/* Bezier points [pieces * 3 + 1][d] of the cage with its further points. */
static void draw(int d, int pieces, const shape *s, const double *cage, double *points)
{
    for (int i = 0; i <= pieces; i++) {
        const double *V = cage + (i + 1) * d;
        for (int k = 0; k < d; k++) {
            double *joint = points + 3 * i * d;
            joint[k] = s->before * V[k - d] + s->own * V[k] + s->after * V[d + k];
            for (int j = 0; i < pieces && j < 2; j++)
                joint[(j + 1) * d + k] = s->inner[j][0] * V[k] + s->inner[j][1] * V[d + k];
        }
    }
}

/* Joints are made to be their points, when they are so but for rounding. */
static batten_status set_joints(batten_points points, int pieces, const double *cage,
                                double *bezier)
{
    const int d = points.dimension, count = points.count;
    const double size = bat_largest(d * (count + 2), cage);
    for (int i = 0; i <= pieces; i++) {
        const double *point = points.at + i % count * d;
        const double off = bat_distance(d, bezier + 3 * i * d, point);
        if (!(off <= 16 * DBL_EPSILON * size))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the curve misses point %d by %g",
                            i % count + 1, off);
        memcpy(bezier + 3 * i * d, point, (size_t)d * sizeof *point);
    }
    return BATTEN_OK;
}

typedef struct {
    double *cage, *bezier, *breaks;
} arrays;

/* Breaks 0, 1 .. pieces; of a ring the knots of a period, on which all but the first stand
 * three times, so that the Bezier points are its control points. */
static batten_status make_curve(int d, int pieces, bool closed, const arrays *a,
                                batten_curve **out)
{
    const int times = closed ? 3 : 1;
    for (int i = 0; i <= times * pieces; i++)
        a->breaks[i] = (i + times - 1) / times;
    return closed ? batten_curve_create_periodic((batten_points){d, 3 * pieces, a->bezier}, 3,
                                                 NULL, a->breaks, out)
                  : batten_curve_from_bezier(d, (batten_pieces){3, pieces, a->breaks},
                                             a->bezier, NULL, out);
}

/* What is asked for. */
typedef struct {
    batten_points points;
    batten_beta_use use;
    double beta1, beta2;
    bool closed;
} beta_request;

static batten_status make_beta_curve(const beta_request *r, arrays *a, batten_curve **out)
{
    const int d = r->points.dimension, count = r->points.count;
    const double *points = r->points.at;
    const bool closed = r->closed;
    const int pieces = closed ? count : count - 1;
    const shape s = shape_of(r->beta1, r->beta2);
    double *cage = a->cage + d;
    memcpy(cage, points, (size_t)count * (size_t)d * sizeof *points);
    batten_status status = BATTEN_OK;
    if (r->use == BATTEN_BETA_THROUGH)
        status =
            find_cage(&s, &(joints){.d = d, .count = count, .closed = closed}, points, cage);
    if (status != BATTEN_OK)
        return status;
    extend(d, count, closed, r->beta1, a->cage);
    const size_t numbers = (size_t)(count + 2) * (size_t)d;
    if (bat_first_not_finite(a->cage, numbers) < numbers)
        return bat_fail(BATTEN_OVERFLOW, "a control point is too large for a number");
    draw(d, pieces, &s, a->cage, a->bezier);
    if (r->use == BATTEN_BETA_THROUGH)
        status = set_joints(r->points, pieces, a->cage, a->bezier);
    if (!closed) {
        memcpy(a->bezier, points, (size_t)d * sizeof *points);
        memcpy(a->bezier + 3 * pieces * d, points + pieces * d, (size_t)d * sizeof *points);
    }
    return status == BATTEN_OK ? make_curve(d, pieces, closed, a, out) : status;
}

batten_status batten_curve_beta(batten_points points, batten_beta_use use, double beta1,
                                double beta2, bool closed, batten_curve **out)
{
    assert(points.at && out);
    batten_status status =
        bat_points_check(points.dimension, points.count, points.at, closed ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    if (!(beta1 > 0 && beta1 * beta1 * beta1 > 0 && isfinite(4 * beta1 * beta1 * beta1)))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "beta1 is %g; it must be above 0 and its cube must not overflow or underflow",
            beta1);
    if (!(beta2 >= 0 && isfinite(beta2)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "beta2 is %g, not 0 or more", beta2);
    const size_t n = (size_t)points.count, d = (size_t)points.dimension;
    arrays a = {bat_array3(n + 3, d, sizeof(double)), bat_array3(3 * n + 1, d, sizeof(double)),
                bat_array(3 * n + 1, sizeof(double))};
    status = BATTEN_OUT_OF_MEMORY;
    if (a.cage && a.bezier && a.breaks)
        status = make_beta_curve(&(beta_request){points, use, beta1, beta2, closed}, &a, out);
    bat_release(a.cage);
    bat_release(a.bezier);
    bat_release(a.breaks);
    return status;
}
