/* Control points of free-form curves and surfaces in any basis as NURBS. */
#include "exchange/obj/free.h"
#include <limits.h>
#include <string.h>

/* ---- control points ---- */

/* Bezier points of a Catmull-Rom piece. */
static const double cardinal[16] = {0, 1,       0, 0,        -1.0 / 6, 1, 1.0 / 6, 0,
                                    0, 1.0 / 6, 1, -1.0 / 6, 0,        0, 1,       0};

/* From powers, b[i][j] for t^j of point i, to Bezier points. */
static void matrix_of_powers(int p, const double *b, double *matrix)
{
    for (int k = 0; k <= p; k++)
        for (int i = 0; i <= p; i++) {
            double sum = 0, share = 1; /* binomial(k, j) / binomial(p, j) */
            for (int j = 0; j <= k; j++) {
                sum += share * b[i * (p + 1) + j];
                share *= (double)(k - j) / (double)(p - j > 0 ? p - j : 1);
            }
            matrix[k * (p + 1) + i] = sum;
        }
}

const char *bat_obj_check_direction(const bat_obj_free *f, int k, bat_obj_axis *d)
{
    const size_t parameters = f->knots[k].count;
    d->p = f->degree[k];
    if (d->p < 1 || d->p > BAT_OBJ_MOST_DEGREE)
        return "its degree is not in 1..25";
    if (f->basis == BAT_OBJ_BSPLINE) {
        if (parameters > INT_MAX / 2 || (int)parameters < 2 * d->p + 2)
            return "its degree asks for more knots than 'parm' gives";
        d->given = d->count = (int)parameters - d->p - 1;
        return NULL;
    }
    if (f->basis == BAT_OBJ_CARDINAL && d->p != 3)
        return "cardinal splines have degree 3";
    d->step = f->basis == BAT_OBJ_BEZIER ? d->p : f->basis == BAT_OBJ_CARDINAL ? 1 : f->step[k];
    if (d->step < 1)
        return "its step is missing";
    if (f->basis == BAT_OBJ_BMATRIX &&
        f->matrix[k].count != (size_t)(d->p + 1) * (size_t)(d->p + 1))
        return "its basis matrix has not (degree + 1)^2 numbers";
    if (parameters < 2 || parameters > INT_MAX / 1001)
        return "'parm' gives fewer than two parameters";
    d->given = ((int)parameters - 2) * d->step + d->p + 1;
    d->count = ((int)parameters - 1) * d->p + 1;
    return NULL;
}

batten_status bat_obj_prepare_direction(bat_obj *obj, int k, bat_obj_axis *d)
{
    const bat_obj_free *f = &obj->free;
    const double *given = f->knots[k].items;
    const size_t count = (size_t)d->count + (size_t)d->p + 1;
    batten_status status = bat_input_array(obj->input, count, sizeof *d->knots, &d->knots);
    if (status == BATTEN_OK && f->basis == BAT_OBJ_BMATRIX)
        status = bat_input_array(obj->input, f->matrix[k].count, sizeof *d->powers, &d->powers);
    if (status != BATTEN_OK)
        return status;
    if (d->powers)
        matrix_of_powers(d->p, f->matrix[k].items, d->powers);
    d->matrix = f->basis == BAT_OBJ_CARDINAL ? cardinal : d->powers;
    for (size_t i = 0; i < count; i++) {
        const size_t p = (size_t)d->p, last = f->knots[k].count - 1;
        const size_t piece = i == 0 ? 0 : (i - 1) / p;
        d->knots[i] = d->step ? given[piece > last ? last : piece] : given[i];
    }
    return BATTEN_OK;
}

/* The weighted point of a corner, or false. */
static bool control_point(const bat_obj *obj, const bat_obj_corner *corner, double out[4])
{
    const bat_obj_vertex *vertices = obj->vertices.items;
    if ((uint64_t)corner->vertex >= obj->vertices.count)
        return false;
    const bat_obj_vertex *vertex = &vertices[corner->vertex];
    memcpy(out, vertex->point, sizeof vertex->point);
    out[3] = obj->free.is_rational ? vertex->weight : 1;
    return bat_first_not_finite(out, 4) == 4;
}

/* One row of points of a direction, `stride` numbers apart, from the given to the B-spline's:
 * [given] rows of 4, weighted, to [count]. False when pieces do not meet. */
static bool convert_row(const bat_obj_axis *d, const double *from, double *to, size_t stride)
{
    const int pieces = (d->count - 1) / d->p;
    bool meets = true;
    for (int i = 0; i < pieces; i++)
        for (int k = 0; k <= d->p; k++)
            for (int c = 0; c < 4; c++) {
                double sum = 0, size = 0;
                for (int j = 0; j <= d->p; j++) {
                    const double x = from[(size_t)(i * d->step + j) * stride + (size_t)c];
                    sum += d->matrix[k * (d->p + 1) + j] * x;
                    size = bat_max(size, fabs(x));
                }
                double *at = &to[(size_t)(i * d->p + k) * stride + (size_t)c];
                meets = meets && (i == 0 || k > 0 || fabs(sum - *at) <= BAT_WRITTEN * size);
                if (i == 0 || k > 0)
                    *at = sum;
            }
    return meets;
}

/* ---- curves and surfaces ---- */

/* The part of the domain that the statement names; a note when it reaches outside. */
static bool part_of(const bat_obj *obj, int k, batten_interval domain, batten_interval *part)
{
    const double *range = obj->free.range[k];
    const double slack = 1e-6 * (domain.b - domain.a);
    *part = (batten_interval){bat_max(range[0], domain.a), bat_min(range[1], domain.b)};
    if (!(range[0] < range[1]) || domain.a - range[0] > slack || range[1] - domain.b > slack)
        return false;
    if (part->a != range[0] || part->b != range[1])
        batten_notes_add(obj->input->notes, obj->input->file, obj->free.line, "",
                         "the parameters %g to %g reach beyond the knots; cut to %g to %g",
                         range[0], range[1], part->a, part->b);
    return part->a < part->b;
}

static batten_status cut_curve(const bat_obj *obj, batten_curve *whole, batten_curve **out)
{
    batten_interval part, domain = batten_curve_domain(whole);
    if (!part_of(obj, 0, domain, &part))
        return bat_fail(BATTEN_BAD_KNOTS, "its parameters %g to %g are outside its knots",
                        obj->free.range[0][0], obj->free.range[0][1]);
    if (part.a != domain.a || part.b != domain.b)
        return batten_curve_subrange(whole, part.a, part.b, out);
    *out = batten_curve_ref(whole);
    return BATTEN_OK;
}

/* Cut *now to the part of one direction. */
static batten_status cut_direction(const bat_obj *obj, int k, batten_surface **now)
{
    const batten_direction direction = k ? BATTEN_V : BATTEN_U;
    batten_surface *cut = NULL;
    batten_interval part, domain = batten_surface_domain(*now, direction);
    if (!part_of(obj, k, domain, &part))
        return bat_fail(BATTEN_BAD_KNOTS, "its parameters %g to %g are outside its knots",
                        obj->free.range[k][0], obj->free.range[k][1]);
    if (part.a == domain.a && part.b == domain.b)
        return BATTEN_OK;
    const batten_status status = batten_surface_subrange(*now, direction, part.a, part.b, &cut);
    if (status == BATTEN_OK) {
        batten_surface_unref(*now);
        *now = cut;
    }
    return status;
}

static batten_status cut_surface(const bat_obj *obj, batten_surface *whole,
                                 batten_surface **out)
{
    batten_surface *now = batten_surface_ref(whole);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = cut_direction(obj, k, &now);
    if (status == BATTEN_OK)
        *out = now;
    else
        batten_surface_unref(now);
    return status;
}

/* Points [count][3] and weights apart, out of weighted rows of 4; a matrix was at work when
 * they are multiplied. */
static void take_apart(size_t count, const double *rows, bool divide, double *points,
                       double *weights)
{
    for (size_t i = 0; i < count; i++) {
        const double w = rows[4 * i + 3];
        for (size_t c = 0; c < 3; c++)
            points[3 * i + c] = divide ? rows[4 * i + c] / w : rows[4 * i + c];
        weights[i] = w;
    }
}

static batten_status create_curve(const bat_obj *obj, const bat_obj_axis *d,
                                  const double *points, const double *weights,
                                  batten_curve **out)
{
    batten_curve *curve = NULL;
    batten_status status = batten_curve_create((batten_points){3, d->count, points}, d->p,
                                               weights, d->knots, &curve);
    if (status == BATTEN_OK)
        status = cut_curve(obj, curve, out);
    batten_curve_unref(curve);
    return status;
}

static batten_status create_surface(const bat_obj *obj, const bat_obj_axis d[2],
                                    const double *points, const double *weights,
                                    batten_surface **out)
{
    const batten_axis u = {d[0].p, d[0].count, d[0].knots, false},
                      v = {d[1].p, d[1].count, d[1].knots, false};
    batten_surface *surface = NULL;
    batten_status status = batten_surface_create(3, &u, &v, points, weights, &surface);
    if (status == BATTEN_OK)
        status = cut_surface(obj, surface, out);
    batten_surface_unref(surface);
    return status;
}

static batten_status create(const bat_obj *obj, const bat_obj_axis d[2], const double *points,
                            const double *weights, bat_obj_shape *shape)
{
    return obj->free.open == 1 ? create_curve(obj, d, points, weights, &shape->curve)
                               : create_surface(obj, d, points, weights, &shape->surface);
}

/* Rows of 4 in our order, v fastest: [given of u][given of v]; u is fastest in the file. */
static bool gather(const bat_obj *obj, const bat_obj_axis d[2], bool multiply, double *rows)
{
    const bat_obj_corner *corners = obj->free.corners.items;
    const size_t nu = (size_t)d[0].given, nv = (size_t)d[1].given;
    for (size_t j = 0; j < nv; j++)
        for (size_t i = 0; i < nu; i++) {
            double *row = rows + 4 * (i * nv + j);
            if (!control_point(obj, &corners[j * nu + i], row))
                return false;
            for (int c = 0; multiply && c < 3; c++)
                row[c] *= row[3];
        }
    return true;
}

/* Convert both directions; *rows is then [count of u][count of v]. */
static batten_status convert(bat_obj *obj, const bat_obj_axis d[2], double **rows, bool *meets)
{
    const size_t gv = (size_t)d[1].given;
    const size_t nu = (size_t)d[0].count, nv = (size_t)d[1].count;
    double *middle = NULL, *done = NULL;
    batten_status status = bat_input_array(obj->input, nu * gv, 4 * sizeof *middle, &middle);
    if (status == BATTEN_OK)
        status = bat_input_array(obj->input, nu * nv, 4 * sizeof *done, &done);
    *meets = true;
    for (size_t j = 0; status == BATTEN_OK && j < gv; j++)
        *meets = convert_row(&d[0], *rows + 4 * j, middle + 4 * j, 4 * gv) && *meets;
    for (size_t i = 0; status == BATTEN_OK && i < nu; i++) {
        if (d[1].matrix)
            *meets = convert_row(&d[1], middle + 4 * i * gv, done + 4 * i * nv, 4) && *meets;
        else
            memcpy(done + 4 * i * nv, middle + 4 * i * gv, 4 * nv * sizeof *done);
    }
    bat_release(middle);
    if (status == BATTEN_OK) {
        bat_release(*rows);
        *rows = done;
    } else
        bat_release(done);
    return status;
}

batten_status bat_obj_build(bat_obj *obj, const bat_obj_axis d[2], bat_obj_shape *shape)
{
    const bool is_rational = obj->free.is_rational, has_matrix = d[0].matrix != NULL;
    double *rows = NULL, *points = NULL, *weights = NULL;
    bool meets = true;
    const size_t given = (size_t)d[0].given * (size_t)d[1].given;
    const size_t count = (size_t)d[0].count * (size_t)d[1].count;
    batten_status status = bat_input_array(obj->input, given, 4 * sizeof *rows, &rows);
    if (status == BATTEN_OK && !gather(obj, d, has_matrix && is_rational, rows))
        status = bat_fail(BATTEN_BAD_FORMAT, "a control point is a vertex that there is not");
    if (status == BATTEN_OK && has_matrix)
        status = convert(obj, d, &rows, &meets);
    if (status == BATTEN_OK && !meets)
        status = bat_fail(BATTEN_BAD_FORMAT, "its pieces do not meet");
    if (status == BATTEN_OK)
        status = bat_input_array(obj->input, count, 3 * sizeof *points, &points);
    if (status == BATTEN_OK)
        status = bat_input_array(obj->input, count, sizeof *weights, &weights);
    if (status == BATTEN_OK) {
        take_apart(count, rows, has_matrix && is_rational, points, weights);
        status = create(obj, d, points, is_rational ? weights : NULL, shape);
    }
    bat_release(rows);
    bat_release(points);
    bat_release(weights);
    return status;
}
