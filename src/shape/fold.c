/* The letters are those of the literature: T, N, B and k, tau along the crease, a the angle of
 * a sheet to the osculating plane, b that of a ruling to T, kg the curvature in the flat sheet.
 */
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "spline/curve.h"
#include <batten/fold.h>
#include <batten/inspect.h>
#include <batten/interpolate.h>
#include <batten/skin.h>

#include <string.h>

enum { FIRST_SAMPLES = 65, MAX_SAMPLES = 16385, NODES = 4, STEPS = 16 };
static const double pi = 3.14159265358979323846;

batten_fold_options batten_fold_defaults(void)
{
    return (batten_fold_options){.size = sizeof(batten_fold_options),
                                 .given = BATTEN_FOLD_ANGLE,
                                 .left = 1,
                                 .right = 1,
                                 .tolerance = 1e-4};
}

/* What is known at one place of the crease. */
typedef struct {
    double s, u; /* length from the start, parameter of the curve */
    batten_vec3 X, T, N, B;
    double k, tau, a, a_rate;
} place;

/* One fold on its way. */
typedef struct {
    const batten_curve *crease; /* as given */
    const batten_fold_options *options;
    batten_curve *space;   /* the crease in space */
    batten_curve *law;     /* the given values over the length of the crease; degree >= 1 */
    batten_curve *torsion; /* with FLAT; NULL for 0 */
    int count;
    place *at;         /* [count] */
    double *b[2];      /* [count] angles of the rulings to T, left and right */
    double *b_rate[2]; /* [count] */
    batten_fold made;
} task;

/* ---- values along the crease ---- */

/* The function through `count` values at equal steps over [0, length]. */
static batten_status function_of(int count, const double *values, double length,
                                 batten_curve **out)
{
    if (count == 1) {
        const double both[2] = {values[0], values[0]}, knots[4] = {0, 0, length, length};
        return batten_curve_create(1, 1, 2, both, NULL, knots, out);
    }
    double *s = bat_array((size_t)count, sizeof *s);
    if (!s)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        s[i] = i == count - 1 ? length : length * i / (count - 1);
    batten_interpolate_options options = batten_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    const batten_status status =
        batten_curve_interpolate(1, count, values, &options, NULL, out);
    bat_release(s);
    return status;
}

/* Value and derivative; a place a few ulps beyond the end counts as the end. */
static batten_status value_at(const batten_curve *function, double s, double out[2])
{
    const batten_interval domain = batten_curve_domain(function);
    return batten_curve_evaluate(function, bat_min(bat_max(s, domain.a), domain.b), 1, out);
}

static batten_status check_angle(double a, double s)
{
    if (!(fabs(a) < pi / 2 && a != 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the angle is %g degrees at the length %g of the crease; it must be "
                        "between 0 and 90, and not 0",
                        a * 180 / pi, s);
    return BATTEN_OK;
}

static batten_status straight(double s)
{
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "the crease is straight at the length %g: no rulings are defined there", s);
}

/* The angle where the flat curvature is given, and its rate by that of both curvatures. */
static batten_status angle_of_curvature(const task *t, const double flat[2], double k_rate,
                                        place *p)
{
    if (!(fabs(flat[0]) < p->k))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "at the length %g the flat crease has the curvature %g, which must be "
                        "below that in space, %g",
                        p->s, flat[0], p->k);
    const double sign = t->options->other_side ? -1 : 1, c = flat[0] / p->k;
    p->a = sign * acos(c);
    p->a_rate = -sign * (flat[1] - c * k_rate) / p->k / sqrt(1 - c * c);
    return BATTEN_OK;
}

/* ---- the crease in space ---- */

static batten_status find_place(const task *t, double s, double u, place *p)
{
    batten_curve_local local;
    const batten_interval domain = batten_curve_domain(t->space);
    batten_status status = batten_curve_local_at(
        t->space, u, u == domain.b ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &local);
    if (status != BATTEN_OK)
        return status;
    double law[2];
    status = value_at(t->law, s, law);
    if (status != BATTEN_OK)
        return status;
    *p = (place){.s = s,
                 .u = u,
                 .X = local.point,
                 .T = local.tangent,
                 .N = local.normal,
                 .B = local.binormal,
                 .k = local.curvature,
                 .tau = local.torsion};
    if (!(p->k > 0))
        return straight(s);
    if (t->options->given == BATTEN_FOLD_CURVATURE)
        return angle_of_curvature(t, law, local.curvature_rate, p);
    p->a = law[0];
    p->a_rate = law[1];
    return check_angle(p->a, s);
}

static batten_status find_places(task *t)
{
    const int n = t->count;
    double *s = bat_array((size_t)n, sizeof *s), *u = bat_array((size_t)n, sizeof *u);
    batten_status status = s && u ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++)
        s[i] = i == n - 1 ? t->made.length : t->made.length * i / (n - 1);
    if (status == BATTEN_OK)
        status = batten_curve_at_length(t->space, n, s, 1e-13 * t->made.length, u);
    for (int i = 0; i < n && status == BATTEN_OK; i++)
        status = find_place(t, s[i], u[i], &t->at[i]);
    bat_release(s);
    bat_release(u);
    return status;
}

/* ---- from the flat crease to space: Frenet's equations ---- */

typedef struct {
    double v[12]; /* X, T, N, B */
} moving_frame;

/* The derivative by arc length of the frame at a place where k and tau are known. */
static moving_frame turn(const moving_frame *f, double k, double tau)
{
    moving_frame d;
    for (int c = 0; c < 3; c++) {
        d.v[c] = f->v[3 + c];
        d.v[3 + c] = k * f->v[6 + c];
        d.v[6 + c] = -k * f->v[3 + c] + tau * f->v[9 + c];
        d.v[9 + c] = -tau * f->v[6 + c];
    }
    return d;
}

/* Signed curvature in the flat sheet, angle and torsion at the length s. */
static batten_status flat_curvatures(const task *t, double s, double *k, double *tau)
{
    double u, law[2], torsion[2] = {0, 0};
    batten_curve_local local;
    batten_status status = batten_curve_at_length(t->crease, 1, &s, 1e-13 * t->made.length, &u);
    if (status == BATTEN_OK)
        status = batten_curve_local_at(t->crease, u, BATTEN_FROM_RIGHT, &local);
    if (status == BATTEN_OK)
        status = value_at(t->law, s, law);
    if (status == BATTEN_OK && t->torsion)
        status = value_at(t->torsion, s, torsion);
    if (status == BATTEN_OK)
        status = check_angle(law[0], s);
    if (status == BATTEN_OK && !(fabs(local.curvature) > 0))
        status = straight(s);
    if (status != BATTEN_OK)
        return status;
    *k = fabs(local.curvature) / cos(law[0]);
    *tau = torsion[0];
    return BATTEN_OK;
}

/* One step of Runge and Kutta, order 4, from s to s + h. */
static batten_status runge_kutta(const task *t, double s, double h, moving_frame *f)
{
    static const double where[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    moving_frame sum = {{0}}, slope = {{0}};
    for (int i = 0; i < 4; i++) {
        moving_frame at = *f;
        double k = 0, tau = 0;
        for (int c = 0; c < 12 && i > 0; c++)
            at.v[c] += where[i] * h * slope.v[c];
        const batten_status status =
            flat_curvatures(t, bat_min(s + where[i] * h, t->made.length), &k, &tau);
        if (status != BATTEN_OK)
            return status;
        slope = turn(&at, k, tau);
        for (int c = 0; c < 12; c++)
            sum.v[c] += weight[i] * slope.v[c];
    }
    for (int c = 0; c < 12; c++)
        f->v[c] += h / 6 * sum.v[c];
    return BATTEN_OK;
}

/* The frame stays square though steps are rounded. */
static void square(moving_frame *f)
{
    const double size = bat_norm(3, f->v + 3), along = bat_dot(3, f->v + 3, f->v + 6);
    for (int c = 0; c < 3; c++)
        f->v[6 + c] -= along / (size * size) * f->v[3 + c];
    const double other = bat_norm(3, f->v + 6);
    for (int c = 0; c < 3; c++) {
        f->v[3 + c] /= size;
        f->v[6 + c] /= other;
    }
    const batten_vec3 b = bat_vec3_cross(bat_vec3_of(3, f->v + 3), bat_vec3_of(3, f->v + 6));
    f->v[9] = b.x;
    f->v[10] = b.y;
    f->v[11] = b.z;
}

/* How the space curve begins: as the flat one, seen so that it turns to the left. */
static batten_status begin_frame(const task *t, moving_frame *f)
{
    batten_curve_local at;
    const batten_status status = batten_curve_local_at(
        t->crease, batten_curve_domain(t->crease).a, BATTEN_FROM_RIGHT, &at);
    if (status != BATTEN_OK)
        return status;
    const double left = at.curvature < 0 ? -1 : 1;
    *f = (moving_frame){{at.point.x, at.point.y, at.point.z, at.tangent.x, at.tangent.y,
                         at.tangent.z, left * at.normal.x, left * at.normal.y,
                         left * at.normal.z}};
    square(f);
    return BATTEN_OK;
}

/* Point, tangent and curvature vector at `count` equal steps of length: values [count][9]. */
static batten_status integrate_frames(const task *t, int count, double *s, double *values)
{
    const double h = t->made.length / (count - 1);
    moving_frame f;
    batten_status status = begin_frame(t, &f);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        double k = 0, tau = 0;
        s[i] = i * h;
        status = flat_curvatures(t, bat_min(s[i], t->made.length), &k, &tau);
        memcpy(values + 9 * i, f.v, 6 * sizeof *values);
        for (int c = 0; c < 3; c++)
            values[9 * i + 6 + c] = k * f.v[6 + c];
        for (int j = 0; j < STEPS && i + 1 < count && status == BATTEN_OK; j++)
            status = runge_kutta(t, s[i] + j * h / STEPS, h / STEPS, &f);
        square(&f);
    }
    return status;
}

/* The crease that the flat one becomes, as a quintic that goes by arc length. */
static batten_status raise_crease(task *t)
{
    enum { COUNT = 257 };
    double *s = bat_array(COUNT, sizeof *s), *values = bat_array(COUNT, 9 * sizeof *values);
    batten_status status = s && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = integrate_frames(t, COUNT, s, values);
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(3, COUNT, 3, s, values, &t->space);
    bat_release(s);
    bat_release(values);
    return status;
}

/* ---- rulings ---- */

/* cot b = (tau + a') / (k sin a) for the left sheet; a -> -a for the right one. */
static void find_rulings(task *t)
{
    for (int i = 0; i < t->count; i++) {
        const place *p = &t->at[i];
        const double across = p->k * sin(p->a);
        t->b[0][i] = atan2(1, (p->tau + p->a_rate) / across);
        t->b[1][i] = atan2(1, (p->a_rate - p->tau) / across);
    }
}

static batten_status differentiate(const task *t, const double *values, double *rates)
{
    batten_curve *function = NULL;
    batten_status status = function_of(t->count, values, t->made.length, &function);
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        double value[2];
        status = value_at(function, t->at[i].s, value);
        rates[i] = value[1];
    }
    batten_curve_unref(function);
    return status;
}

/* The material lies to the left of the crease with sign 1, to its right with -1. */
static batten_vec3 ruling(const place *p, double b, double sign)
{
    const batten_vec3 g =
        bat_vec3_along(bat_vec3_scale(p->N, cos(p->a)), sign * sin(p->a), p->B);
    return bat_vec3_scale(bat_vec3_along(bat_vec3_scale(p->T, cos(b)), sin(b), g), sign);
}

/* How far the edge of regression is, at right angles to the crease: on the side of the material
 * only. */
static void find_regression(const task *t, int side, batten_fold_sheet *sheet)
{
    const double sign = side ? -1 : 1;
    sheet->regression = HUGE_VAL;
    for (int i = 0; i < t->count; i++) {
        const double b = t->b[side][i], kg = t->at[i].k * cos(t->at[i].a);
        const double v = sign * sin(b) / (t->b_rate[side][i] + kg);
        if (v > 0 && v * sin(b) < sheet->regression) {
            sheet->regression = v * sin(b);
            sheet->regression_at = t->at[i].s;
        }
    }
}

static batten_status check_width(double width, const batten_fold_sheet *sheet, const char *name)
{
    if (width < sheet->regression)
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the %s sheet would be %g wide, but its rulings meet %g from the crease at "
                    "the length %g",
                    name, width, sheet->regression, sheet->regression_at);
}

/* ---- sheets ---- */

static batten_status make_sheet(task *t, int side, double width, batten_fold_sheet *sheet)
{
    const size_t n = (size_t)t->count;
    const double sign = side ? -1 : 1;
    sheet->rulings = bat_array(n * 3, sizeof(double));
    sheet->flat_rulings = bat_array(n * 2, sizeof(double));
    sheet->lengths = bat_array(n, sizeof(double));
    if (!sheet->rulings || !sheet->flat_rulings || !sheet->lengths)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = differentiate(t, t->b[side], t->b_rate[side]);
    if (status != BATTEN_OK)
        return status;
    find_regression(t, side, sheet);
    for (int i = 0; i < t->count; i++) {
        const batten_vec3 r = ruling(&t->at[i], t->b[side][i], sign);
        memcpy(sheet->rulings + 3 * i, (const double[3]){r.x, r.y, r.z}, 3 * sizeof(double));
        sheet->lengths[i] = width / sin(t->b[side][i]);
    }
    return check_width(width, sheet, side ? "right" : "left");
}

/* The curve through the samples, the crease or an edge. */
static batten_status curve_of(const task *t, const double *rulings, const double *lengths,
                              batten_curve **out)
{
    const int n = t->count;
    double *points = bat_array((size_t)n * 3, sizeof *points);
    double *s = bat_array((size_t)n, sizeof *s);
    batten_status status = points && s ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++) {
        for (int c = 0; c < 3; c++)
            points[3 * i + c] =
                t->made.points[3 * i + c] + (rulings ? lengths[i] * rulings[3 * i + c] : 0);
        s[i] = t->at[i].s;
    }
    batten_interpolate_options options = batten_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    if (status == BATTEN_OK)
        status = batten_curve_interpolate(3, n, points, &options, NULL, out);
    bat_release(points);
    bat_release(s);
    return status;
}

static batten_status make_surface(const task *t, batten_fold_sheet *sheet)
{
    batten_curve *crease = NULL, *edge = NULL;
    batten_status status = curve_of(t, NULL, NULL, &crease);
    if (status == BATTEN_OK)
        status = curve_of(t, sheet->rulings, sheet->lengths, &edge);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(crease, edge, &sheet->surface);
    batten_curve_unref(crease);
    batten_curve_unref(edge);
    return status;
}

/* ---- the flat sheet ---- */

/* Weights of Gauss and Legendre for integrals from 0 to each node c[i]: exact for degree 3. */
static void collocation(double c[NODES], double weights[NODES], double A[NODES][NODES])
{
    double nodes[NODES], plain[NODES];
    bat_gauss(NODES, nodes, plain);
    for (int i = 0; i < NODES; i++) {
        c[i] = 0.5 + 0.5 * nodes[i];
        weights[i] = plain[i] / 2;
    }
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++) {
            A[i][j] = 0;
            for (int q = 0; q < NODES; q++) {
                double basis = 1;
                for (int m = 0; m < NODES; m++)
                    basis *= m == j ? 1 : (c[i] * c[q] - c[m]) / (c[j] - c[m]);
                A[i][j] += c[i] * weights[q] * basis;
            }
        }
}

/* From sample i to the next: direction and point of the flat crease. */
static batten_status flat_step(const task *t, int i, double *phi, double *x, double *y)
{
    double c[NODES], weights[NODES], A[NODES][NODES], kg[NODES], pace[NODES];
    const double u = t->at[i].u, h = t->at[i + 1].u - u;
    collocation(c, weights, A);
    for (int j = 0; j < NODES; j++) {
        place p;
        double values[2 * 3];
        const double s = t->at[i].s + c[j] * (t->at[i + 1].s - t->at[i].s);
        /* The length at the node is known nearly, which does for the law of angles: it varies
         * slowly. */
        batten_status status = find_place(t, s, u + c[j] * h, &p);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(t->space, u + c[j] * h, 1, values);
        if (status != BATTEN_OK)
            return status;
        pace[j] = bat_norm(3, values + 3) * h;
        kg[j] = p.k * cos(p.a);
    }
    for (int j = 0; j < NODES; j++) {
        double turned = *phi;
        for (int m = 0; m < NODES; m++)
            turned += A[j][m] * kg[m] * pace[m];
        *x += weights[j] * pace[j] * cos(turned);
        *y += weights[j] * pace[j] * sin(turned);
    }
    for (int j = 0; j < NODES; j++)
        *phi += weights[j] * kg[j] * pace[j];
    return BATTEN_OK;
}

static void flat_ruling(double phi, double b, double sign, double *out)
{
    out[0] = sign * cos(phi + b);
    out[1] = sign * sin(phi + b);
}

static batten_status flatten(task *t)
{
    double phi = 0, x = 0, y = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        t->made.flat[2 * i] = x;
        t->made.flat[2 * i + 1] = y;
        flat_ruling(phi, t->b[0][i], 1, t->made.left.flat_rulings + 2 * i);
        flat_ruling(phi, t->b[1][i], -1, t->made.right.flat_rulings + 2 * i);
        if (i + 1 < t->count)
            status = flat_step(t, i, &phi, &x, &y);
    }
    t->made.flat_turn = phi;
    return status;
}

/* ---- what was reached ---- */

/* The surfaces against exact rulings midway between samples; and |det(T, r, r')|. */
static batten_status measure_sheet(task *t, int side, double width,
                                   const batten_fold_sheet *sheet)
{
    const batten_interval domain = batten_surface_domain(sheet->surface, BATTEN_U);
    const double sign = side ? -1 : 1;
    for (int i = 0; i + 1 < t->count; i += bat_max_int(1, t->count / 64)) {
        const double s = (t->at[i].s + t->at[i + 1].s) / 2;
        double u, edge[3];
        place p;
        batten_status status =
            batten_curve_at_length(t->space, 1, &s, 1e-13 * t->made.length, &u);
        if (status == BATTEN_OK)
            status = find_place(t, s, u, &p);
        const double at = domain.a + (domain.b - domain.a) * (s / t->made.length);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(sheet->surface, at, 1, 0, edge);
        if (status != BATTEN_OK)
            return status;
        const double across = p.k * sin(p.a);
        const double b = atan2(1, (side ? p.a_rate - p.tau : p.tau + p.a_rate) / across);
        const batten_vec3 r = ruling(&p, b, sign);
        const batten_vec3 true_edge = bat_vec3_along(p.X, width / sin(b), r);
        t->made.error = bat_max(
            t->made.error, bat_vec3_norm(bat_vec3_subtract(true_edge, bat_vec3_of(3, edge))));
        const double *r0 = sheet->rulings + 3 * i, *r1 = r0 + 3;
        const double h = t->at[i + 1].s - t->at[i].s;
        const batten_vec3 change =
            bat_vec3_scale(bat_vec3_subtract(bat_vec3_of(3, r1), bat_vec3_of(3, r0)), 1 / h);
        const double det = bat_vec3_dot(p.T, bat_vec3_cross(r, change));
        t->made.twist = bat_max(t->made.twist,
                                fabs(det) / bat_max(bat_vec3_norm(change), 1 / t->made.length));
    }
    return BATTEN_OK;
}

static batten_status edge_length(int d, int n, const double *base, const double *rulings,
                                 const double *lengths, const place *at, double *length)
{
    double *points = bat_array3((size_t)n, (size_t)d, sizeof *points);
    double *s = bat_array((size_t)n, sizeof *s);
    batten_curve *edge = NULL;
    batten_status status = points && s ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++) {
        for (int c = 0; c < d; c++)
            points[d * i + c] = base[d * i + c] + lengths[i] * rulings[d * i + c];
        s[i] = at[i].s;
    }
    batten_interpolate_options options = batten_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    if (status == BATTEN_OK)
        status = batten_curve_interpolate(d, n, points, &options, NULL, &edge);
    if (status == BATTEN_OK)
        status = batten_curve_length(edge, 1e-12 * at[n - 1].s, length, NULL);
    batten_curve_unref(edge);
    bat_release(points);
    bat_release(s);
    return status;
}

static batten_status measure_stretch(task *t, const batten_fold_sheet *sheet)
{
    double space = 0, flat = 0;
    batten_status status =
        edge_length(3, t->count, t->made.points, sheet->rulings, sheet->lengths, t->at, &space);
    if (status == BATTEN_OK)
        status = edge_length(2, t->count, t->made.flat, sheet->flat_rulings, sheet->lengths,
                             t->at, &flat);
    if (status == BATTEN_OK)
        t->made.stretch = bat_max(t->made.stretch, fabs(space - flat) / bat_max(space, flat));
    return status;
}

/* ---- the whole ---- */

static void sheet_release(batten_fold_sheet *sheet)
{
    batten_surface_unref(sheet->surface);
    bat_release(sheet->rulings);
    bat_release(sheet->flat_rulings);
    bat_release(sheet->lengths);
}

void batten_fold_release(batten_fold *fold)
{
    batten_curve_unref(fold->crease);
    bat_release(fold->points);
    bat_release(fold->flat);
    bat_release(fold->angles);
    sheet_release(&fold->left);
    sheet_release(&fold->right);
    *fold = (batten_fold){0};
}

static void clear_samples(task *t)
{
    const double length = t->made.length;
    for (int side = 0; side < 2; side++) {
        bat_release(t->b[side]);
        bat_release(t->b_rate[side]);
        t->b[side] = t->b_rate[side] = NULL;
    }
    bat_release(t->at);
    t->at = NULL;
    batten_fold_release(&t->made);
    t->made.length = length;
}

static batten_status reserve_samples(task *t)
{
    const size_t n = (size_t)t->count;
    t->at = bat_array(n, sizeof *t->at);
    for (int side = 0; side < 2; side++) {
        t->b[side] = bat_array(n, sizeof(double));
        t->b_rate[side] = bat_array(n, sizeof(double));
    }
    t->made.count = t->count;
    t->made.points = bat_array(n * 3, sizeof(double));
    t->made.flat = bat_array(n * 2, sizeof(double));
    t->made.angles = bat_array(n, sizeof(double));
    const bool all = t->at && t->b[0] && t->b[1] && t->b_rate[0] && t->b_rate[1] &&
                     t->made.points && t->made.flat && t->made.angles;
    return all ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* The fold with so many samples. */
static batten_status fold_with(task *t, int count)
{
    const batten_fold_options *o = t->options;
    clear_samples(t);
    t->count = count;
    batten_status status = reserve_samples(t);
    if (status == BATTEN_OK)
        status = find_places(t);
    if (status != BATTEN_OK)
        return status;
    find_rulings(t);
    for (int i = 0; i < count; i++) {
        const batten_vec3 X = t->at[i].X;
        memcpy(t->made.points + 3 * i, (const double[3]){X.x, X.y, X.z}, 3 * sizeof(double));
        t->made.angles[i] = t->at[i].a;
    }
    status = make_sheet(t, 0, o->left, &t->made.left);
    if (status == BATTEN_OK)
        status = make_sheet(t, 1, o->right, &t->made.right);
    if (status == BATTEN_OK)
        status = make_surface(t, &t->made.left);
    if (status == BATTEN_OK)
        status = make_surface(t, &t->made.right);
    if (status == BATTEN_OK)
        status = measure_sheet(t, 0, o->left, &t->made.left);
    if (status == BATTEN_OK)
        status = measure_sheet(t, 1, o->right, &t->made.right);
    return status;
}

static batten_status check_options(const batten_fold_options *o)
{
    if (o->count < 1 || !o->values)
        return bat_fail(BATTEN_BAD_ARGUMENT, "no angles are given along the crease");
    if (bat_first_not_finite(o->values, (size_t)o->count) < (size_t)o->count)
        return bat_fail(BATTEN_NOT_FINITE, "value %zu along the crease is not finite",
                        bat_first_not_finite(o->values, (size_t)o->count));
    if (o->torsion_count < 0 || (o->torsion_count > 0 && !o->torsions))
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are %d torsions", o->torsion_count);
    if (!(o->left > 0 && o->right > 0 && isfinite(o->left) && isfinite(o->right)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the sheets are %g and %g wide; above 0 is needed",
                        o->left, o->right);
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    return BATTEN_OK;
}

/* The crease in space, its length, and the laws along it. */
static batten_status prepare(task *t)
{
    const batten_fold_options *o = t->options;
    const bool is_flat = o->given == BATTEN_FOLD_FLAT;
    double size = 0;
    batten_status status = batten_curve_length(t->crease, 1e-6, &size, NULL);
    if (status == BATTEN_OK && !(size > 0))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the crease has no length");
    if (status == BATTEN_OK)
        status = batten_curve_length(t->crease, 1e-13 * size, &t->made.length, NULL);
    if (status == BATTEN_OK)
        status = function_of(o->count, o->values, t->made.length, &t->law);
    if (status == BATTEN_OK && o->torsion_count > 0)
        status = function_of(o->torsion_count, o->torsions, t->made.length, &t->torsion);
    if (status == BATTEN_OK && is_flat)
        return raise_crease(t);
    if (status == BATTEN_OK)
        t->space = batten_curve_ref(t->crease);
    return status;
}

static batten_status fold_all(task *t)
{
    int count = FIRST_SAMPLES;
    batten_status status = fold_with(t, count);
    while (status == BATTEN_OK && t->made.error > t->options->tolerance &&
           count < MAX_SAMPLES) {
        count = 2 * count - 1;
        status = fold_with(t, count);
    }
    if (status == BATTEN_OK && t->made.error > t->options->tolerance)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the sheets are within %g with %d samples, not within %g",
                          t->made.error, count, t->options->tolerance);
    if (status == BATTEN_OK)
        status = flatten(t);
    if (status == BATTEN_OK)
        status = measure_stretch(t, &t->made.left);
    if (status == BATTEN_OK)
        status = measure_stretch(t, &t->made.right);
    return status;
}

batten_status batten_fold_create(const batten_curve *crease, const batten_fold_options *options,
                                 batten_fold *out)
{
    assert(crease && options && out);
    const bool is_flat = options->given == BATTEN_FOLD_FLAT;
    batten_curve *lifted = NULL;
    batten_status status = check_options(options);
    /* Flat creases are seen in their plane, where curvature has a sign; others in space. */
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(crease, is_flat ? 2 : 3, &lifted);
    task t = {.crease = lifted, .options = options};
    if (status == BATTEN_OK)
        status = prepare(&t);
    if (status == BATTEN_OK)
        status = fold_all(&t);
    if (status == BATTEN_OK) {
        t.made.crease = batten_curve_ref(t.space);
        *out = t.made;
        t.made = (batten_fold){0};
    }
    clear_samples(&t);
    batten_curve_unref(t.space);
    batten_curve_unref(t.law);
    batten_curve_unref(t.torsion);
    batten_curve_unref(lifted);
    return status;
}
