/* A sheet folded along a curved crease: options, checks, both sheets in space and their edges. */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/fold_parts.h"
#include <batten/interpolate.h>
#include <batten/measure.h>
#include <batten/skin.h>

#include <string.h>

enum { FIRST_SAMPLES = 65, MANY_SAMPLES = 1000, MAX_SAMPLES = 16385 };

batten_fold_create_options batten_fold_create_defaults(void)
{
    return (batten_fold_create_options){.size = sizeof(batten_fold_create_options),
                                        .given = BATTEN_FOLD_ANGLE,
                                        .left = 1,
                                        .right = 1,
                                        .tolerance =
                                            1e-4}; /* with metres, a tenth of a millimetre */
}

/* ---- rulings ---- */

/* cot b = (tau + a') / (k sin a) for the left sheet; a -> -a for the right one. */
static void find_rulings(bat_fold_task *t)
{
    for (int i = 0; i < t->count; i++) {
        const bat_fold_place *p = &t->at[i];
        const double across = p->k * bat_sin(p->a);
        t->b[0][i] = bat_atan2(1, (p->tau + p->a_rate) / across);
        t->b[1][i] = bat_atan2(1, (p->a_rate - p->tau) / across);
    }
}

static batten_status differentiate(const bat_fold_task *t, const double *values, double *rates)
{
    batten_curve *function = NULL;
    batten_status status = bat_fold_function(t->count, values, t->made.length, &function);
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        double value[2];
        status = bat_fold_value_at(function, t->at[i].s, value);
        rates[i] = value[1];
    }
    batten_curve_unref(function);
    return status;
}

/* The material lies to the left of the crease with sign 1, to its right with -1. */
static batten_vec3 ruling(const bat_fold_place *p, double b, double sign)
{
    const batten_vec3 g =
        bat_vec3_along(bat_vec3_scale(p->N, bat_cos(p->a)), sign * bat_sin(p->a), p->B);
    return bat_vec3_scale(bat_vec3_along(bat_vec3_scale(p->T, bat_cos(b)), bat_sin(b), g),
                          sign);
}

/* How far the edge of regression is, at right angles to the crease: on the side of the material
 * only. */
static void find_regression(const bat_fold_task *t, int side, batten_fold_sheet *sheet)
{
    const double sign = side ? -1 : 1;
    sheet->regression = HUGE_VAL;
    for (int i = 0; i < t->count; i++) {
        const double b = t->b[side][i], kg = t->at[i].k * bat_cos(t->at[i].a);
        const double v = sign * bat_sin(b) / (t->b_rate[side][i] + kg);
        if (v > 0 && v * bat_sin(b) < sheet->regression) {
            sheet->regression = v * bat_sin(b);
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

static batten_status make_sheet(bat_fold_task *t, int side, double width,
                                batten_fold_sheet *sheet)
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
        sheet->lengths[i] = width / bat_sin(t->b[side][i]);
    }
    return check_width(width, sheet, side ? "right" : "left");
}

/* The curve through the samples of the crease, [count][d], or of an edge: `sheet` not NULL. */
static batten_status curve_of(const bat_fold_task *t, int d, const batten_fold_sheet *sheet,
                              batten_curve **out)
{
    const int n = t->count;
    const double *crease = d == 3 ? t->made.points : t->made.flat;
    const double *rulings = !sheet ? NULL : d == 3 ? sheet->rulings : sheet->flat_rulings;
    double *points = bat_array3((size_t)n, (size_t)d, sizeof *points);
    double *s = bat_array((size_t)n, sizeof *s);
    batten_status status = points && s ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n && status == BATTEN_OK; i++) {
        for (int c = 0; c < d; c++)
            points[d * i + c] =
                crease[d * i + c] + (sheet ? sheet->lengths[i] * rulings[d * i + c] : 0);
        s[i] = t->at[i].s;
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    if (status == BATTEN_OK)
        status = batten_curve_interpolate((batten_points){d, n, points}, &options, NULL, out);
    bat_release(points);
    bat_release(s);
    return status;
}

static batten_status make_surface(const bat_fold_task *t, batten_fold_sheet *sheet)
{
    batten_curve *crease = NULL, *edge = NULL;
    batten_status status = curve_of(t, 3, NULL, &crease);
    if (status == BATTEN_OK)
        status = curve_of(t, 3, sheet, &edge);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(crease, edge, &sheet->surface);
    batten_curve_unref(crease);
    batten_curve_unref(edge);
    return status;
}

/* ---- what was reached ---- */

/* The surfaces against exact rulings midway between samples; and |det(T, r, r')|. */
static batten_status measure_sheet(bat_fold_task *t, int side, double width,
                                   const batten_fold_sheet *sheet)
{
    const batten_interval domain = batten_surface_domain(sheet->surface, BATTEN_U);
    const double sign = side ? -1 : 1;
    for (int i = 0; i + 1 < t->count; i += bat_max_int(1, t->count / 64)) {
        const double s = (t->at[i].s + t->at[i + 1].s) / 2;
        double u, edge[3];
        bat_fold_place p;
        batten_status status =
            batten_curve_at_length(t->space, 1, &s, BAT_EXACT * t->made.length, &u);
        if (status == BATTEN_OK)
            status = bat_fold_find_place(t, s, u, &p);
        const double at = domain.a + (domain.b - domain.a) * (s / t->made.length);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(sheet->surface, at, 1, 0, edge);
        if (status != BATTEN_OK)
            return status;
        const double across = p.k * bat_sin(p.a);
        const double b = bat_atan2(1, (side ? p.a_rate - p.tau : p.tau + p.a_rate) / across);
        const batten_vec3 r = ruling(&p, b, sign);
        const batten_vec3 true_edge = bat_vec3_along(p.X, width / bat_sin(b), r);
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

static batten_status edge_length(const bat_fold_task *t, int d, const batten_fold_sheet *sheet,
                                 double *length)
{
    batten_curve *edge = NULL;
    batten_status status = curve_of(t, d, sheet, &edge);
    if (status == BATTEN_OK)
        status = batten_curve_length(edge, BAT_ROUNDING * t->made.length, NULL, length);
    batten_curve_unref(edge);
    return status;
}

/* The edge of the sheet must be as long in space as in the plane. */
static batten_status measure_stretch(bat_fold_task *t, const batten_fold_sheet *sheet)
{
    double space = 0, flat = 0;
    batten_status status = edge_length(t, 3, sheet, &space);
    if (status == BATTEN_OK)
        status = edge_length(t, 2, sheet, &flat);
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

static void clear_samples(bat_fold_task *t)
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

static batten_status reserve_samples(bat_fold_task *t)
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

/* The surface, and what it keeps of the lengths and rulings that it should have. */
static batten_status finish_sheet(bat_fold_task *t, int side, double width,
                                  batten_fold_sheet *sheet)
{
    batten_status status = make_surface(t, sheet);
    if (status == BATTEN_OK)
        status = measure_sheet(t, side, width, sheet);
    if (status == BATTEN_OK)
        status = measure_stretch(t, sheet);
    return status;
}

/* The fold with so many samples. */
static batten_status fold_with(bat_fold_task *t, int count)
{
    const batten_fold_create_options *o = t->options;
    clear_samples(t);
    t->count = count;
    batten_status status = reserve_samples(t);
    if (status == BATTEN_OK)
        status = bat_fold_find_places(t);
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
        status = bat_fold_flatten(t);
    if (status == BATTEN_OK)
        status = finish_sheet(t, 0, o->left, &t->made.left);
    if (status == BATTEN_OK)
        status = finish_sheet(t, 1, o->right, &t->made.right);
    return status;
}

static batten_status check_options(const batten_fold_create_options *o)
{
    if (o->count < 1 || !o->values)
        return bat_fail(BATTEN_BAD_ARGUMENT, "no angles are given along the crease");
    if (bat_first_not_finite(o->values, (size_t)o->count) < (size_t)o->count)
        return bat_fail(BATTEN_NOT_FINITE, "value %zu along the crease is not finite",
                        bat_first_not_finite(o->values, (size_t)o->count) + 1);
    if (o->torsion_count < 0 || (o->torsion_count > 0 && !o->torsions))
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are %d torsions", o->torsion_count);
    if (!(o->left > 0 && o->right > 0 && isfinite(o->left) && isfinite(o->right)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the sheets are %g and %g wide; above 0 is needed",
                        o->left, o->right);
    if (!(o->tolerance > 0 && isfinite(o->tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    return BATTEN_OK;
}

/* The larger of what the surfaces miss and what an edge would have to be stretched. */
static double deviation(const bat_fold_task *t)
{
    return bat_max(t->made.error, t->made.stretch * t->made.length);
}

/* Where the crease bends to the other side from one sample to the next, its curvature was 0
 * between them; with few samples it may only have turned. */
static batten_status check_bending(const bat_fold_task *t)
{
    for (int i = 0; i + 1 < t->count; i++)
        if (bat_vec3_dot(t->at[i].N, t->at[i + 1].N) < 0)
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "the crease bends to the other side near the length %g: no rulings "
                            "are defined there",
                            (t->at[i].s + t->at[i + 1].s) / 2);
    return BATTEN_OK;
}

static batten_status fold_all(bat_fold_task *t)
{
    int count = FIRST_SAMPLES;
    batten_status status = fold_with(t, count);
    while (status == BATTEN_OK && deviation(t) > t->options->tolerance && count < MAX_SAMPLES) {
        if (count > MANY_SAMPLES)
            status = check_bending(t);
        count = 2 * count - 1;
        if (status == BATTEN_OK)
            status = fold_with(t, count);
    }
    if (status == BATTEN_OK && deviation(t) > t->options->tolerance)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the sheets are within %g with %d sample%s, not within %g",
                          deviation(t), count, bat_plural(count), t->options->tolerance);
    return status;
}

batten_status batten_fold_create(const batten_curve *crease,
                                 const batten_fold_create_options *options, batten_fold *out)
{
    assert(crease && options && out);
    batten_fold_create_options chosen = batten_fold_create_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_fold_create_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    const bool is_flat = options->given == BATTEN_FOLD_FLAT;
    batten_curve *lifted = NULL;
    status = check_options(options);
    /* Flat creases are seen in their plane, where curvature has a sign; others in space. */
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(crease, is_flat ? 2 : 3, &lifted);
    bat_fold_task t = {.crease = lifted, .options = options};
    if (status == BATTEN_OK)
        status = bat_fold_prepare(&t);
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
