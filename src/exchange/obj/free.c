/* Free-form curves and surfaces: from their statements to NURBS. */
#include "exchange/obj/obj.h"

#include <limits.h>
#include <string.h>

enum { MOST_DEGREE = 25 };

/* ---- statements ---- */

static void leave_out(const bat_obj *obj, int line, const char *why)
{
    batten_notes_add(obj->input->notes, obj->input->file, line, "",
                     "the free-form %s is left out: %s",
                     obj->free.open == 1 ? "curve" : "surface", why);
    obj->input->left_out++;
}

void bat_obj_free_close(bat_obj *obj)
{
    if (obj->free.open)
        leave_out(obj, obj->free.line, "its 'end' is missing");
    obj->free.open = 0;
}

static void read_type(bat_obj *obj)
{
    static const char *const names[] = {"bspline", "bezier", "cardinal", "bmatrix"};
    bat_obj_free *f = &obj->free;
    bat_span word;
    f->is_rational = false;
    f->basis = BAT_OBJ_OTHER;
    while (bat_obj_next(obj, &word)) {
        f->is_rational = f->is_rational || bat_word_is(word, "rat");
        for (int k = 0; k < 4; k++)
            if (bat_word_is(word, names[k]))
                f->basis = (bat_obj_basis)(BAT_OBJ_BSPLINE + k);
    }
}

/* Two small whole numbers; what is missing or none stays 0. */
static void read_two(bat_obj *obj, int out[2])
{
    bat_span word;
    out[0] = out[1] = 0;
    for (int k = 0; k < 2 && bat_obj_next(obj, &word); k++) {
        int64_t number = 0;
        if (bat_word_integer(word, 1, 1000, &number))
            out[k] = (int)number;
    }
}

/* Numbers until the end of the statement; one that is none becomes NaN. */
static batten_status read_list(bat_obj *obj, bat_list *list)
{
    bat_span word;
    batten_status status = BATTEN_OK;
    list->count = 0;
    while (status == BATTEN_OK && bat_obj_next(obj, &word)) {
        double number;
        if (!bat_word_real(obj->input, obj->scan.line, word, &number))
            number = (double)NAN;
        status = bat_list_add(obj->input, list, &number);
    }
    return status;
}

/* "u" or "v" before the list of a direction. */
static batten_status read_direction(bat_obj *obj, bat_list lists[2])
{
    bat_span word;
    if (!bat_obj_next(obj, &word) || (!bat_word_is(word, "u") && !bat_word_is(word, "v")))
        return BATTEN_OK;
    return read_list(obj, &lists[bat_word_is(word, "v")]);
}

static batten_status begin_shape(bat_obj *obj, int open)
{
    bat_obj_free *f = &obj->free;
    int bad = 0;
    bat_obj_free_close(obj);
    f->open = open;
    f->line = obj->scan.line;
    f->trims = 0;
    f->knots[0].count = f->knots[1].count = f->corners.count = 0;
    for (int k = 0; k < 2 * open; k++)
        if (!bat_obj_number(obj, &f->range[k / 2][k % 2]))
            f->range[k / 2][k % 2] = (double)NAN;
    batten_status status = bat_obj_corners(obj, &f->corners, &bad);
    if (status == BATTEN_OK && bad) {
        leave_out(obj, f->line, "a control point is no index");
        f->open = 0;
    }
    return status;
}

/* ---- control points ---- */

/* One direction as it will be: pieces of degree p over knots. */
typedef struct {
    int p, given, count; /* control points as given, and of the B-spline */
    int step;            /* from piece to piece; 0 for a B-spline as it stands */
    const double
        *matrix;    /* [p + 1][p + 1] from given points to Bezier points; NULL: as given */
    double *powers; /* the memory of a matrix that is made for it */
    double *knots;  /* [count + p + 1] */
} axis;

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

/* What is wrong in a direction; NULL when nothing is. */
static const char *check_direction(const bat_obj_free *f, int k, axis *d)
{
    const size_t parameters = f->knots[k].count;
    d->p = f->degree[k];
    if (d->p < 1 || d->p > MOST_DEGREE)
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

/* Knots, and for bases of powers the matrix. */
static batten_status prepare_direction(bat_obj *obj, int k, axis *d)
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
static bool convert_row(const axis *d, const double *from, double *to, size_t stride)
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
                meets = meets && (i == 0 || k > 0 || fabs(sum - *at) <= 1e-9 * size);
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

static batten_status cut_surface(const bat_obj *obj, batten_surface *whole,
                                 batten_surface **out)
{
    batten_surface *now = batten_surface_ref(whole);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        batten_surface *cut = NULL;
        batten_interval part, domain = batten_surface_domain(now, direction);
        if (!part_of(obj, k, domain, &part))
            status = bat_fail(BATTEN_BAD_KNOTS, "its parameters %g to %g are outside its knots",
                              obj->free.range[k][0], obj->free.range[k][1]);
        else if (part.a != domain.a || part.b != domain.b) {
            status = batten_surface_subrange(now, direction, part.a, part.b, &cut);
            if (status == BATTEN_OK) {
                batten_surface_unref(now);
                now = cut;
            }
        }
    }
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

static batten_status create(const bat_obj *obj, const axis d[2], const double *points,
                            const double *weights, bat_obj_shape *shape)
{
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    batten_status status;
    if (obj->free.open == 1) {
        status =
            batten_curve_create(3, d[0].p, d[0].count, points, weights, d[0].knots, &curve);
        if (status == BATTEN_OK)
            status = cut_curve(obj, curve, &shape->curve);
    } else {
        const batten_axis u = {d[0].p, d[0].count, d[0].knots, false},
                          v = {d[1].p, d[1].count, d[1].knots, false};
        status = batten_surface_create(3, &u, &v, points, weights, &surface);
        if (status == BATTEN_OK)
            status = cut_surface(obj, surface, &shape->surface);
    }
    batten_curve_unref(curve);
    batten_surface_unref(surface);
    return status;
}

/* Rows of 4 in our order, v fastest: [given of u][given of v]; u is fastest in the file. */
static bool gather(const bat_obj *obj, const axis d[2], bool multiply, double *rows)
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
static batten_status convert(bat_obj *obj, const axis d[2], double **rows, bool *meets)
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

/* The shape out of what was read; a status other than OUT_OF_MEMORY and TOO_LARGE only means
 * that this one is left out. */
static batten_status build(bat_obj *obj, const axis d[2], bat_obj_shape *shape)
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

/* ---- the end of a shape ---- */

static const char *check_shape(const bat_obj *obj, axis d[2])
{
    const bat_obj_free *f = &obj->free;
    const char *wrong = NULL;
    if (f->basis == BAT_OBJ_NO_BASIS)
        return "no 'cstype' stands before it";
    if (f->basis == BAT_OBJ_OTHER)
        return "its 'cstype' is not bspline, bezier, cardinal or bmatrix";
    for (int k = 0; !wrong && k < f->open; k++)
        wrong = check_direction(f, k, &d[k]);
    if (!wrong && (uint64_t)d[0].given * (uint64_t)d[1].given != f->corners.count)
        wrong = "it has not as many control points as its parameters ask for";
    return wrong;
}

static batten_status keep_shape(bat_obj *obj, bat_obj_shape *shape)
{
    const bat_obj_element element = {
        .kind = BAT_OBJ_SHAPE, .first = obj->shapes.count, .line = obj->free.line};
    bat_obj_vertex *vertices = obj->vertices.items;
    const bat_obj_corner *corners = obj->free.corners.items;
    batten_status status = bat_list_add(obj->input, &obj->shapes, shape);
    if (status != BATTEN_OK) {
        batten_curve_unref(shape->curve);
        batten_surface_unref(shape->surface);
        return status;
    }
    for (size_t i = 0; i < obj->free.corners.count; i++)
        vertices[corners[i].vertex].is_used = true;
    if (obj->free.trims) {
        batten_notes_add(obj->input->notes, obj->input->file, obj->free.line, "",
                         "the surface is whole: %d statements that trim it or mark curves and "
                         "points on it are left out",
                         obj->free.trims);
        obj->input->left_out++;
    }
    return bat_obj_add(obj, &element);
}

static batten_status end_shape(bat_obj *obj)
{
    axis d[2] = {{.given = 1, .count = 1}, {.given = 1, .count = 1}};
    bat_obj_shape shape = {NULL, NULL};
    batten_status status = BATTEN_OK;
    if (!obj->free.open)
        return BATTEN_OK;
    const char *wrong = check_shape(obj, d);
    for (int k = 0; !wrong && status == BATTEN_OK && k < obj->free.open; k++)
        status = prepare_direction(obj, k, &d[k]);
    if (!wrong && status == BATTEN_OK)
        status = build(obj, d, &shape);
    for (int k = 0; k < 2; k++) {
        bat_release(d[k].knots);
        bat_release(d[k].powers);
    }
    if (!wrong && status == BATTEN_OK)
        status = keep_shape(obj, &shape);
    else if (status != BATTEN_OUT_OF_MEMORY && status != BATTEN_TOO_LARGE) {
        leave_out(obj, obj->free.line, wrong ? wrong : batten_message());
        status = BATTEN_OK;
    }
    obj->free.open = 0;
    return status;
}

batten_status bat_obj_free_statement(bat_obj *obj, bat_span word, bool *is_such)
{
    static const char *const attached[] = {"trim", "hole", "scrv", "sp"};
    *is_such = true;
    if (bat_word_is(word, "cstype"))
        read_type(obj);
    else if (bat_word_is(word, "deg"))
        read_two(obj, obj->free.degree);
    else if (bat_word_is(word, "step"))
        read_two(obj, obj->free.step);
    else if (bat_word_is(word, "bmat"))
        return read_direction(obj, obj->free.matrix);
    else if (bat_word_is(word, "parm"))
        return read_direction(obj, obj->free.knots);
    else if (bat_word_is(word, "curv") || bat_word_is(word, "surf"))
        return begin_shape(obj, bat_word_is(word, "curv") ? 1 : 2);
    else if (bat_word_is(word, "end"))
        return end_shape(obj);
    else if (bat_word_is(word, "curv2")) {
        bat_obj_free_close(
            obj); /* a curve in parameters: only trims use it, which are left out */
        return BATTEN_OK;
    } else {
        *is_such = bat_word_is(word, "con");
        for (int k = 0; k < 4; k++)
            if (bat_word_is(word, attached[k])) {
                *is_such = true;
                obj->free.trims++;
            }
    }
    return BATTEN_OK;
}
