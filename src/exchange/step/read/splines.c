/* The B-splines of a STEP file: with knots, uniform, quasi-uniform, Bezier; rational ones are
 * complex instances, whose parts have no names. */
#include "base/plural.h"
#include "exchange/step/read/geometry.h"

#include <string.h>

/* ---- knots ---- */

typedef enum { GIVEN, BEZIER, UNIFORM, QUASI_UNIFORM } knot_kind;

/* Where the knots of one direction come from. */
typedef struct {
    const bat_step_instance *instance;
    knot_kind kind;
    const bat_step_record *record; /* GIVEN: with the lists */
    int multiplicities, values;    /* GIVEN: arguments of it */
    int degree, count;             /* p, n */
} knot_source;

/* Those that are implied; count + degree + 1 of them. */
static batten_status implied_knots(const bat_step_file *file, const knot_source *from,
                                   double *knots)
{
    const int p = from->degree, n = from->count;
    if (from->kind == BEZIER && (n - 1) % p != 0)
        return bat_step_fail(file, from->instance, BATTEN_BAD_FORMAT,
                             "%d points do not make a whole number of Bezier pieces of degree "
                             "%d",
                             n, p);
    for (int i = 0; i <= n + p; i++)
        if (from->kind == UNIFORM)
            knots[i] = i - p;
        else if (from->kind == BEZIER)
            knots[i] = bat_min_int(bat_max_int(i - 1, 0) / p, (n - 1) / p);
        else
            knots[i] = bat_min_int(bat_max_int(i - p, 0), n - p);
    return BATTEN_OK;
}

/* Lists of multiplicities and of distinct knots. */
static batten_status given_knots(const bat_step_file *file, const knot_source *from,
                                 double *knots)
{
    const int needed = from->count + from->degree + 1;
    int multiplicities = 0, values = 0, filled = 0;
    size_t at_multiplicity = 0, at_value = 0;
    int64_t sum = 0;
    batten_status status = bat_step_get_list(file, from->record, from->multiplicities,
                                             &multiplicities, &at_multiplicity);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, from->record, from->values, &values, &at_value);
    if (status == BATTEN_OK && multiplicities != values)
        status = bat_step_fail(file, from->instance, BATTEN_BAD_FORMAT,
                               "it has %d knot%s and %d multiplicities", values,
                               bat_plural(values), multiplicities);
    for (int k = 0; status == BATTEN_OK && k < values; k++) {
        int times = 0;
        double knot = 0;
        status = bat_step_item_integer(file, from->record, &at_multiplicity, &times);
        if (status == BATTEN_OK)
            status = bat_step_item_real(file, from->record, &at_value, &knot);
        if (status == BATTEN_OK && times < 1)
            status = bat_step_fail(file, from->instance, BATTEN_BAD_FORMAT,
                                   "multiplicity %d is %d", k + 1, times);
        if (status == BATTEN_OK && filled > 0 && knot < knots[filled - 1])
            status = bat_step_fail(file, from->instance, BATTEN_BAD_KNOTS,
                                   "knot %d is %g, below the one before, which is %g", k + 1,
                                   knot, knots[filled - 1]);
        if (status == BATTEN_OK && filled > 0 && knot == knots[filled - 1])
            batten_notes_add(file->input->notes, file->input->file,
                             bat_step_line(file, from->instance->at), "",
                             "#%llu: knot %g is given twice; its multiplicities are added",
                             (unsigned long long)from->instance->id, knot);
        sum += times;
        for (; status == BATTEN_OK && times > 0 && filled < needed; times--)
            knots[filled++] = knot;
    }
    if (status == BATTEN_OK && sum != needed)
        status = bat_step_fail(file, from->instance, BATTEN_BAD_KNOTS,
                               "multiplicities sum to %lld, need %d", (long long)sum, needed);
    return status;
}

static void release(bat_input *input, int count, double *numbers)
{
    bat_input_release(input, (size_t)count, sizeof *numbers, numbers);
}

/* Only where there are knots the degree has been checked. */
static void release_knots(bat_input *input, int count, int degree, double *knots)
{
    if (knots)
        release(input, count + degree + 1, knots);
}

/* Knots in new memory that counts towards the limit. */
static batten_status read_knots(const bat_step_file *file, const knot_source *from,
                                double **out)
{
    double *knots = NULL;
    if (from->degree < 1 || from->degree > 25)
        return bat_step_fail(file, from->instance, BATTEN_BAD_DEGREE,
                             "its degree is %d; 1 to 25 are read", from->degree);
    if (from->count <= from->degree)
        return bat_step_fail(file, from->instance, BATTEN_TOO_FEW_POINTS,
                             "%d point%s %s too few for degree %d", from->count,
                             bat_plural(from->count), bat_one_or_many(from->count, "is", "are"),
                             from->degree);
    batten_status status = bat_input_array(
        file->input, (size_t)from->count + (size_t)from->degree + 1, sizeof *knots, &knots);
    if (status == BATTEN_OK)
        status = from->kind == GIVEN ? given_knots(file, from, knots)
                                     : implied_knots(file, from, knots);
    if (status == BATTEN_OK)
        *out = knots;
    else
        release_knots(file->input, from->count, from->degree, knots);
    return status;
}

/* ---- the parts of an instance ---- */

/* A B-spline: the record with its degrees and points, of which `first` is the argument of the
 * degree, that of its weights, and the kind of its knots. */
typedef struct {
    const bat_step_record *shape, *weights;
    int first;
    knot_kind kind;
    const bat_step_record *knots;
    int first_knots; /* the argument of the first list of multiplicities */
} parts;

/* What B-splines are called: by the kind of their knots, and the parts of a complex instance.
 * `own` arguments stand in the base without its name, `lists` more with knots. */
typedef struct {
    const char *keywords[4], *base, *rational;
    int own, lists;
} spline_words;

static batten_status find_parts(const bat_step_file *file, const bat_step_instance *instance,
                                const spline_words *words, parts *p, bool *is_it)
{
    const bat_step_record *found = NULL;
    int kind = 0;
    for (; kind < 4 && !found; kind++)
        found = bat_step_as(file, instance, words->keywords[kind]);
    *is_it = found != NULL;
    if (!found)
        return BATTEN_OK;
    kind--;
    *p = (parts){.kind = (knot_kind)kind, .knots = found};
    if (instance->record_count == 1) {
        p->shape = found;
        p->first = 1;
        p->first_knots = 1 + words->own;
        return bat_step_check_arguments(file, found,
                                        1 + words->own + (kind == GIVEN ? words->lists : 0));
    }
    p->shape = bat_step_as(file, instance, words->base);
    p->weights = bat_step_as(file, instance, words->rational);
    if (!p->shape)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT, "it has no part %s",
                             words->base);
    if (bat_step_argument_count(file, p->shape) != words->own)
        return bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                             "its part %s has %d arguments, not %d", words->base,
                             bat_step_argument_count(file, p->shape), words->own);
    return BATTEN_OK;
}

/* Room for `count` points of the reading's dimension; there cannot be more than bytes. */
static batten_status point_room(const bat_step_reading *reading, size_t count, double **points)
{
    bat_input *input = reading->file->input;
    const size_t most = input->limits.points < input->size ? input->limits.points : input->size;
    batten_status status = bat_input_limit(input, 0, count, most, "points in an object");
    if (status == BATTEN_OK)
        status =
            bat_input_array(input, count * (size_t)reading->dimension, sizeof **points, points);
    return status;
}

static bool are_equal(size_t count, const double *weights)
{
    for (size_t i = 1; i < count; i++)
        if (weights[i] != weights[0])
            return false;
    return true;
}

/* Equal weights say nothing: the curve or surface is polynomial. A weight that is not positive
 * is left for the constructor to refuse. */
static const double *weights_that_matter(size_t count, const double *weights)
{
    return weights && are_equal(count, weights) && weights[0] > 0 ? NULL : weights;
}

/* A list of `count` weights, at *at. */
static batten_status read_weights(const bat_step_reading *reading,
                                  const bat_step_instance *instance,
                                  const bat_step_record *from, size_t *at, int count,
                                  const char *what, double *weights)
{
    int given = 0;
    size_t item = 0;
    batten_status status = bat_step_item_list(reading->file, from, at, &given, &item);
    if (status == BATTEN_OK && given != count)
        status = bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                               "it has %d weight%s for %d point%s%s", given, bat_plural(given),
                               count, bat_plural(count), what);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_step_item_real(reading->file, from, &item, &weights[i]);
    return status;
}

/* ---- curves ---- */

static batten_status curve_weights(const bat_step_reading *reading,
                                   const bat_step_instance *instance, const parts *p, int count,
                                   double **weights)
{
    if (!p->weights)
        return BATTEN_OK;
    size_t at = bat_step_argument(reading->file, p->weights, 0);
    batten_status status =
        bat_input_array(reading->file->input, (size_t)count, sizeof **weights, weights);
    return status == BATTEN_OK
               ? read_weights(reading, instance, p->weights, &at, count, "", *weights)
               : status;
}

batten_status bat_step_spline_curve(const bat_step_reading *reading,
                                    const bat_step_instance *instance, batten_curve **out,
                                    bool *is_spline)
{
    static const spline_words words = {
        {"B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE", "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE"},
        "B_SPLINE_CURVE",
        "RATIONAL_B_SPLINE_CURVE",
        5,
        3};
    const bat_step_file *file = reading->file;
    parts p;
    int degree = 0, count = 0;
    size_t at = 0;
    double *points = NULL, *weights = NULL, *knots = NULL;
    batten_status status = find_parts(file, instance, &words, &p, is_spline);
    if (status != BATTEN_OK || !*is_spline)
        return status;
    status = bat_step_get_integer(file, p.shape, p.first, &degree);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, p.shape, p.first + 1, &count, &at);
    const knot_source from = {.instance = instance,
                              .kind = p.kind,
                              .record = p.knots,
                              .multiplicities = p.first_knots,
                              .values = p.first_knots + 1,
                              .degree = degree,
                              .count = count};
    if (status == BATTEN_OK)
        status = read_knots(file, &from, &knots);
    if (status == BATTEN_OK)
        status = point_room(reading, (size_t)count, &points);
    if (status == BATTEN_OK)
        status = bat_step_points_in(reading, p.shape, &at, count, points);
    if (status == BATTEN_OK)
        status = curve_weights(reading, instance, &p, count, &weights);
    if (status == BATTEN_OK)
        status = bat_step_blame(
            file, instance,
            batten_curve_create((batten_points){reading->dimension, count, points}, degree,
                                weights_that_matter((size_t)count, weights), knots, out));
    release(file->input, reading->dimension * count, points);
    release(file->input, count, weights);
    release_knots(file->input, count, degree, knots);
    return status;
}

/* ---- surfaces ---- */

static const spline_words surface_words = {{"B_SPLINE_SURFACE_WITH_KNOTS", "BEZIER_SURFACE",
                                            "UNIFORM_SURFACE", "QUASI_UNIFORM_SURFACE"},
                                           "B_SPLINE_SURFACE",
                                           "RATIONAL_B_SPLINE_SURFACE",
                                           7,
                                           5};

bool bat_step_is_spline_surface(const bat_step_file *file, const bat_step_instance *instance)
{
    for (int k = 0; k < 4; k++)
        if (bat_step_as(file, instance, surface_words.keywords[k]))
            return true;
    return false;
}

/* A net as it is read: count[0] rows of count[1] each. */
typedef struct {
    int degree[2], count[2];
    double *points, *weights, *knots[2];
} net;

/* The list of rows of points; all as long as the first. */
static batten_status read_rows(const bat_step_reading *reading,
                               const bat_step_instance *instance, const parts *p, net *n)
{
    const bat_step_file *file = reading->file;
    size_t row = 0, at = 0;
    int count = 0;
    batten_status status = bat_step_get_list(file, p->shape, p->first + 2, &n->count[0], &row);
    if (status == BATTEN_OK && n->count[0] < 1)
        status = bat_step_fail(file, instance, BATTEN_TOO_FEW_POINTS, "it has no points");
    for (int i = 0; status == BATTEN_OK && i < n->count[0]; i++) {
        status = bat_step_item_list(file, p->shape, &row, &count, &at);
        if (status == BATTEN_OK && i == 0) {
            n->count[1] = count;
            status = point_room(reading, (size_t)n->count[0] * (size_t)count, &n->points);
        }
        if (status == BATTEN_OK && count != n->count[1])
            status = bat_step_fail(file, instance, BATTEN_BAD_FORMAT,
                                   "row %d has %d point%s, row 1 has %d", i + 1, count,
                                   bat_plural(count), n->count[1]);
        if (status == BATTEN_OK)
            status = bat_step_points_in(reading, p->shape, &at, count,
                                        n->points + (size_t)reading->dimension * (size_t)i *
                                                        (size_t)count);
    }
    return status;
}

static batten_status surface_weights(const bat_step_reading *reading,
                                     const bat_step_instance *instance, const parts *p, net *n)
{
    int rows = 0;
    size_t row = 0;
    if (!p->weights)
        return BATTEN_OK;
    batten_status status = bat_step_get_list(reading->file, p->weights, 0, &rows, &row);
    if (status == BATTEN_OK && rows != n->count[0])
        status = bat_step_fail(reading->file, instance, BATTEN_BAD_FORMAT,
                               "it has %d row%s of weights for %d row%s of points", rows,
                               bat_plural(rows), n->count[0], bat_plural(n->count[0]));
    if (status == BATTEN_OK)
        status =
            bat_input_array(reading->file->input, (size_t)n->count[0] * (size_t)n->count[1],
                            sizeof *n->weights, &n->weights);
    for (int i = 0; status == BATTEN_OK && i < rows; i++)
        status = read_weights(reading, instance, p->weights, &row, n->count[1], " in a row",
                              n->weights + (size_t)i * (size_t)n->count[1]);
    return status;
}

static batten_status read_net(const bat_step_reading *reading,
                              const bat_step_instance *instance, const parts *p, net *n)
{
    batten_status status = read_rows(reading, instance, p, n);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = bat_step_get_integer(reading->file, p->shape, p->first + k, &n->degree[k]);
        const knot_source from = {.instance = instance,
                                  .kind = p->kind,
                                  .record = p->knots,
                                  .multiplicities = p->first_knots + k,
                                  .values = p->first_knots + 2 + k,
                                  .degree = n->degree[k],
                                  .count = n->count[k]};
        if (status == BATTEN_OK)
            status = read_knots(reading->file, &from, &n->knots[k]);
    }
    return status == BATTEN_OK ? surface_weights(reading, instance, p, n) : status;
}

batten_status bat_step_spline_surface(const bat_step_reading *reading,
                                      const bat_step_instance *instance, batten_surface **out,
                                      bool *is_spline)
{
    parts p;
    net n = {.points = NULL};
    batten_status status = find_parts(reading->file, instance, &surface_words, &p, is_spline);
    if (status != BATTEN_OK || !*is_spline)
        return status;
    status = read_net(reading, instance, &p, &n);
    bat_input *input = reading->file->input;
    const size_t count = (size_t)n.count[0] * (size_t)n.count[1];
    if (status == BATTEN_OK) {
        const batten_axis u = {n.degree[0], n.count[0], n.knots[0], false},
                          v = {n.degree[1], n.count[1], n.knots[1], false};
        const double *weights = weights_that_matter(count, n.weights);
        status = bat_step_blame(reading->file, instance,
                                batten_surface_create(3, &u, &v, n.points, weights, out));
    }
    bat_input_release(input, 3 * count, sizeof *n.points, n.points);
    bat_input_release(input, count, sizeof *n.weights, n.weights);
    for (int k = 0; k < 2; k++)
        release_knots(input, n.count[k], n.degree[k], n.knots[k]);
    return status;
}
