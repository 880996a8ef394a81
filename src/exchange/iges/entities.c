#include "exchange/iges/entities.h"

#include <stdio.h>
#include <string.h>

/* ---- references ---- */

static const bat_iges_entry *entries_of(const bat_iges_reading *reading)
{
    return reading->file.entries.items;
}

/* The entry that an id of a type names. BAD_FORMAT, with a message, when it is another or none.
 */
static batten_status find(const bat_iges_reading *reading, int id, int type,
                          const bat_iges_entry **out)
{
    const bat_iges_entry *entries = entries_of(reading);
    size_t low = 0, high = reading->file.entries.count;
    if (id <= 0 || id % 2 == 0)
        return bat_fail(BATTEN_BAD_FORMAT, "%d is not the odd number of an entity", id);
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (entries[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == reading->file.entries.count || entries[low].id != id)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which is missing", id);
    if (entries[low].is_broken)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which is damaged", id);
    if (entries[low].type != type)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "it refers to entity D%d as type %d, which is of type %d", id, type,
                        entries[low].type);
    *out = &entries[low];
    return BATTEN_OK;
}

/* ---- transforms ---- */

/* How far the rows of a matrix are from being orthonormal. */
static double skewness(const double m[3][3])
{
    double worst = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            const double dot = m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2];
            worst = bat_max(worst, fabs(dot - (i == j)));
        }
    return worst;
}

/* Gram and Schmidt, from the first row on. */
static void make_orthonormal(double m[3][3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < i; j++) {
            const double dot = m[i][0] * m[j][0] + m[i][1] * m[j][1] + m[i][2] * m[j][2];
            for (int k = 0; k < 3; k++)
                m[i][k] -= dot * m[j][k];
        }
        const double length = sqrt(m[i][0] * m[i][0] + m[i][1] * m[i][1] + m[i][2] * m[i][2]);
        for (int k = 0; k < 3; k++)
            m[i][k] /= length;
    }
}

static batten_status read_matrix(bat_iges_reading *reading, const bat_iges_entry *entry,
                                 batten_affine *map)
{
    batten_status status = bat_iges_tokens(&reading->file, entry);
    for (size_t i = 0; status == BATTEN_OK && i < 12; i++) {
        double *value = i % 4 < 3 ? &map->m[i / 4][i % 4] : &map->t[i / 4];
        status = bat_iges_real(&reading->file, i + 1, value);
    }
    if (status != BATTEN_OK)
        return status;
    const double skew = skewness((const double(*)[3])map->m);
    if (!(skew <= 1e-6))
        return bat_fail(BATTEN_BAD_FORMAT, "the matrix D%d is off a rotation by %g", entry->id,
                        skew);
    if (skew > 1e-9) {
        batten_notes_add(reading->input->notes, reading->input->file, entry->line,
                         "#124 matrix", "the matrix is off a rotation by %g; made a rotation",
                         skew);
        make_orthonormal(map->m);
    }
    return BATTEN_OK;
}

/* The chain of matrices that begins at `id`: the first is applied first. */
static batten_status read_transform(bat_iges_reading *reading, int id, batten_affine *map)
{
    batten_affine whole = batten_affine_identity(), part;
    batten_status status = BATTEN_OK;
    for (int depth = 0; status == BATTEN_OK && id != 0; depth++) {
        const bat_iges_entry *entry = NULL;
        if (depth == reading->input->limits.nesting)
            return bat_fail(BATTEN_BAD_FORMAT,
                            "its matrices refer to one another in a ring, or more than %d deep",
                            depth);
        status = find(reading, id, 124, &entry);
        if (status == BATTEN_OK)
            status = read_matrix(reading, entry, &part);
        if (status == BATTEN_OK) {
            whole = batten_affine_compose(whole, part);
            id = entry->transform;
        }
    }
    if (status == BATTEN_OK)
        *map = whole;
    return status;
}

/* ---- names and colours ---- */

/* The name of a property 406 form 15, copied; *name stays NULL when `id` is something else. */
static batten_status read_name_property(bat_iges_reading *reading, int id, char **name)
{
    const bat_iges_entry *entry = NULL;
    if (find(reading, id, 406, &entry) != BATTEN_OK || entry->form != 15 ||
        bat_iges_tokens(&reading->file, entry) != BATTEN_OK || reading->file.tokens.count < 3)
        return BATTEN_OK;
    const bat_iges_token token = ((const bat_iges_token *)reading->file.tokens.items)[2];
    if (!token.is_string || token.text.length == 0)
        return BATTEN_OK;
    char *copied = NULL;
    batten_status status = bat_input_array(reading->input, token.text.length + 1, 1, &copied);
    if (status != BATTEN_OK)
        return status;
    memcpy(copied, token.text.bytes, token.text.length);
    *name = copied;
    return BATTEN_OK;
}

/* After `own` parameters stand a count and as many associativities, then a count and
 * properties. */
static batten_status read_name(bat_iges_reading *reading, size_t own, char **name)
{
    int count = 0, *properties = NULL;
    size_t at = own;
    if (bat_iges_integer(&reading->file, at, &count) != BATTEN_OK || count < 0)
        return BATTEN_OK;
    at += 1 + (size_t)count;
    if (at >= reading->file.tokens.count ||
        bat_iges_integer(&reading->file, at, &count) != BATTEN_OK || count < 1 ||
        (size_t)count > reading->file.tokens.count - at - 1)
        return BATTEN_OK;
    batten_status status =
        bat_input_array(reading->input, (size_t)count, sizeof *properties, &properties);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        if (bat_iges_integer(&reading->file, at + 1 + (size_t)k, &properties[k]) != BATTEN_OK)
            properties[k] = 0;
    for (int k = 0; status == BATTEN_OK && k < count && !*name; k++)
        status = read_name_property(reading, properties[k], name);
    bat_release(properties);
    return status;
}

/* 0 is none; 1..8 are named; minus the id of a 314 gives percents. A bad one is none. */
static bool read_colour(bat_iges_reading *reading, int colour, double rgb[3])
{
    static const double named[9][3] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                       {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const bat_iges_entry *entry = NULL;
    double read[3];
    if (colour > 0 && colour <= 8) {
        memcpy(rgb, named[colour], sizeof named[colour]);
        return true;
    }
    if (colour >= 0 || find(reading, -colour, 314, &entry) != BATTEN_OK ||
        bat_iges_tokens(&reading->file, entry) != BATTEN_OK)
        return false;
    for (size_t k = 0; k < 3; k++)
        if (bat_iges_real(&reading->file, k + 1, &read[k]) != BATTEN_OK ||
            !(read[k] >= 0 && read[k] <= 100))
            return false;
    for (int k = 0; k < 3; k++)
        rgb[k] = read[k] / 100;
    return true;
}

/* ---- curves and surfaces ---- */

/* Read `count` reals from parameter *at on into new memory. */
static batten_status read_reals(bat_iges_reading *reading, size_t *at, size_t count,
                                double **out)
{
    double *values = NULL;
    batten_status status = bat_input_array(reading->input, count, sizeof *values, &values);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_iges_real(&reading->file, *at + i, &values[i]);
    if (status != BATTEN_OK) {
        bat_release(values);
        return status;
    }
    *at += count;
    *out = values;
    return BATTEN_OK;
}

static batten_status read_integers(const bat_iges_reading *reading, size_t count, int *values)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_iges_integer(&reading->file, i + 1, &values[i]);
    return status;
}

/* The upper index and the degree of one direction. */
static batten_status check_shape(const bat_iges_reading *reading, int upper, int degree)
{
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "its degree is %d, not in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (upper < degree)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "its degree is %d, and the upper index of its points %d", degree,
                        upper);
    if ((size_t)upper >= reading->input->limits.points)
        return bat_fail(BATTEN_BAD_FORMAT, "%d points; the limit is %zu", upper,
                        reading->input->limits.points);
    return BATTEN_OK;
}

/* Are there as many parameters as a count asks for? */
static batten_status check_count(const bat_iges_reading *reading, size_t needed)
{
    const size_t have = reading->file.tokens.count;
    if (needed <= have)
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_FORMAT, "%zu parameters, need %zu", have, needed);
}

/* Weights that are all the same say nothing when the entity calls itself polynomial. */
static void judge_weights(bat_iges_reading *reading, const bat_iges_entry *entry,
                          bool polynomial, size_t count, double **weights)
{
    bool equal = true;
    for (size_t i = 1; i < count; i++)
        equal &= (*weights)[i] == (*weights)[0];
    if (polynomial && equal && (*weights)[0] > 0) {
        bat_release(*weights);
        *weights = NULL;
    } else if (polynomial) {
        batten_notes_add(reading->input->notes, reading->input->file, entry->line,
                         bat_iges_type_name(entry->type),
                         "it calls itself polynomial, but its weights differ; they are kept");
    }
}

/*
 * The interval of parameters an entity names, given its domain. Ends within a rounding of the
 * domain's are those; an interval that is empty or leaves the domain counts as not given.
 */
static batten_interval read_interval(const bat_iges_reading *reading,
                                     const bat_iges_entry *entry, size_t at,
                                     batten_interval domain)
{
    batten_interval range = domain;
    const double slack = 1e-9 * (domain.b - domain.a);
    if (at + 1 >= reading->file.tokens.count ||
        bat_iges_real(&reading->file, at, &range.a) != BATTEN_OK ||
        bat_iges_real(&reading->file, at + 1, &range.b) != BATTEN_OK)
        return domain;
    if (fabs(range.a - domain.a) <= slack)
        range.a = domain.a;
    if (fabs(range.b - domain.b) <= slack)
        range.b = domain.b;
    if (range.a >= domain.a && range.a < range.b && range.b <= domain.b)
        return range;
    batten_notes_add(reading->input->notes, reading->input->file, entry->line,
                     bat_iges_type_name(entry->type),
                     "its interval %g..%g is not in its domain %g..%g, which is taken", range.a,
                     range.b, domain.a, domain.b);
    return domain;
}

static batten_status restrict_curve(batten_interval range, batten_curve **curve)
{
    const batten_interval domain = batten_curve_domain(*curve);
    batten_curve *part = NULL;
    if (range.a == domain.a && range.b == domain.b)
        return BATTEN_OK;
    batten_status status = batten_curve_subrange(*curve, range.a, range.b, &part);
    if (status == BATTEN_OK) {
        batten_curve_unref(*curve);
        *curve = part;
    }
    return status;
}

/* K, M, four properties, knots, weights, points, the interval, and a normal. */
static batten_status read_curve(bat_iges_reading *reading, const bat_iges_entry *entry,
                                batten_curve **out, size_t *own)
{
    int head[6];
    double *knots = NULL, *weights = NULL, *points = NULL;
    size_t at = 7;
    batten_curve *curve = NULL;
    batten_status status = read_integers(reading, 6, head);
    if (status == BATTEN_OK)
        status = check_shape(reading, head[0], head[1]);
    if (status != BATTEN_OK)
        return status;
    const int degree = head[1];
    const size_t count = (size_t)head[0] + 1, knot_count = count + (size_t)degree + 1;
    status = check_count(reading, at + knot_count + 4 * count);
    if (status == BATTEN_OK)
        status = read_reals(reading, &at, knot_count, &knots);
    if (status == BATTEN_OK)
        status = read_reals(reading, &at, count, &weights);
    if (status == BATTEN_OK)
        status = read_reals(reading, &at, 3 * count, &points);
    if (status == BATTEN_OK) {
        judge_weights(reading, entry, head[4] != 0, count, &weights);
        status = batten_curve_create(3, degree, (int)count, points, weights, knots, &curve);
    }
    if (status == BATTEN_OK)
        status = restrict_curve(read_interval(reading, entry, at, batten_curve_domain(curve)),
                                &curve);
    if (status == BATTEN_OK) {
        *out = batten_curve_ref(curve);
        *own = at + 5;
    }
    batten_curve_unref(curve);
    bat_release(points);
    bat_release(weights);
    bat_release(knots);
    return status;
}

static batten_status restrict_surface(batten_direction direction, batten_interval range,
                                      batten_surface **surface)
{
    const batten_interval domain = batten_surface_domain(*surface, direction);
    batten_surface *part = NULL;
    if (range.a == domain.a && range.b == domain.b)
        return BATTEN_OK;
    batten_status status =
        batten_surface_subrange(*surface, direction, range.a, range.b, &part);
    if (status == BATTEN_OK) {
        batten_surface_unref(*surface);
        *surface = part;
    }
    return status;
}

/* Numbers that run with u fastest, `width` at a time, put into our order, v fastest. */
static batten_status transpose(bat_input *input, size_t count_u, size_t count_v, size_t width,
                               double **values)
{
    double *turned = NULL;
    if (!*values)
        return BATTEN_OK;
    batten_status status =
        bat_input_array(input, count_u * count_v * width, sizeof *turned, &turned);
    if (status != BATTEN_OK)
        return status;
    for (size_t j = 0; j < count_v; j++)
        for (size_t i = 0; i < count_u; i++)
            memcpy(&turned[(i * count_v + j) * width], &(*values)[(j * count_u + i) * width],
                   width * sizeof *turned);
    bat_release(*values);
    *values = turned;
    return BATTEN_OK;
}

/* What a 128 holds. */
typedef struct {
    int head[9]; /* K1, K2, M1, M2, properties 1..5 */
    double *knots_u, *knots_v, *weights, *points;
} net;

static batten_status read_net(bat_iges_reading *reading, const bat_iges_entry *entry,
                              size_t *at, net *n)
{
    batten_status status = read_integers(reading, 9, n->head);
    if (status == BATTEN_OK)
        status = check_shape(reading, n->head[0], n->head[2]);
    if (status == BATTEN_OK)
        status = check_shape(reading, n->head[1], n->head[3]);
    if (status != BATTEN_OK)
        return status;
    const size_t count_u = (size_t)n->head[0] + 1, count_v = (size_t)n->head[1] + 1;
    const size_t knots_u = count_u + (size_t)n->head[2] + 1;
    const size_t knots_v = count_v + (size_t)n->head[3] + 1;
    status = check_count(reading, *at + knots_u + knots_v + 4 * count_u * count_v);
    if (status == BATTEN_OK && count_u * count_v > reading->input->limits.points)
        status = bat_fail(BATTEN_BAD_FORMAT, "%zu points; the limit is %zu", count_u * count_v,
                          reading->input->limits.points);
    if (status == BATTEN_OK)
        status = read_reals(reading, at, knots_u, &n->knots_u);
    if (status == BATTEN_OK)
        status = read_reals(reading, at, knots_v, &n->knots_v);
    if (status == BATTEN_OK)
        status = read_reals(reading, at, count_u * count_v, &n->weights);
    if (status == BATTEN_OK)
        status = read_reals(reading, at, 3 * count_u * count_v, &n->points);
    if (status != BATTEN_OK)
        return status;
    judge_weights(reading, entry, n->head[6] != 0, count_u * count_v, &n->weights);
    status = transpose(reading->input, count_u, count_v, 1, &n->weights);
    return status == BATTEN_OK ? transpose(reading->input, count_u, count_v, 3, &n->points)
                               : status;
}

static batten_status read_surface(bat_iges_reading *reading, const bat_iges_entry *entry,
                                  batten_surface **out, size_t *own)
{
    net n = {.points = NULL};
    size_t at = 10;
    batten_surface *surface = NULL;
    batten_status status = read_net(reading, entry, &at, &n);
    if (status == BATTEN_OK) {
        const batten_axis u = {n.head[2], n.head[0] + 1, n.knots_u, false};
        const batten_axis v = {n.head[3], n.head[1] + 1, n.knots_v, false};
        status = batten_surface_create(3, &u, &v, n.points, n.weights, &surface);
    }
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const batten_interval domain = batten_surface_domain(surface, direction);
        status = restrict_surface(
            direction, read_interval(reading, entry, at + 2 * (size_t)k, domain), &surface);
    }
    if (status == BATTEN_OK) {
        *out = batten_surface_ref(surface);
        *own = at + 4;
    }
    batten_surface_unref(surface);
    bat_release(n.points);
    bat_release(n.weights);
    bat_release(n.knots_v);
    bat_release(n.knots_u);
    return status;
}

/* A line from its start to its end, over 0..1. */
static batten_status read_line(bat_iges_reading *reading, batten_curve **out, size_t *own)
{
    static const double knots[] = {0, 0, 1, 1};
    double points[6];
    batten_status status = check_count(reading, 7);
    for (size_t i = 0; status == BATTEN_OK && i < 6; i++)
        status = bat_iges_real(&reading->file, i + 1, &points[i]);
    if (status == BATTEN_OK)
        status = batten_curve_create(3, 1, 2, points, NULL, knots, out);
    *own = 7;
    return status;
}

/* ---- objects ---- */

const char *bat_iges_type_name(int type)
{
    static const struct {
        int type;
        const char *name;
    } names[] = {
        {100, "100 arc"},
        {102, "102 composite curve"},
        {104, "104 conic"},
        {106, "106 copious data"},
        {108, "108 plane"},
        {110, "110 line"},
        {112, "112 spline curve"},
        {114, "114 spline surface"},
        {116, "116 point"},
        {118, "118 ruled surface"},
        {120, "120 surface of revolution"},
        {122, "122 tabulated cylinder"},
        {124, "124 matrix"},
        {126, "126 B-spline curve"},
        {128, "128 B-spline surface"},
        {130, "130 offset curve"},
        {140, "140 offset surface"},
        {141, "141 boundary"},
        {142, "142 curve on a surface"},
        {143, "143 bounded surface"},
        {144, "144 trimmed surface"},
        {186, "186 solid"},
        {308, "308 subfigure"},
        {408, "408 instance of a subfigure"},
    };
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        if (names[k].type == type)
            return names[k].name;
    return "entity";
}

/* Is it no geometry: nothing, a matrix, a colour, a group, a property? */
static bool is_auxiliary(int type)
{
    return type == 0 || type == 124 || type == 314 || type == 402 || type == 406;
}

static bool is_read(int type)
{
    return type == 110 || type == 126 || type == 128;
}

/* Is it the data's fault, so that the rest of the file may still be read? */
static bool is_fault_of_data(batten_status status)
{
    return status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY &&
           status != BATTEN_CANCELLED && status != BATTEN_INCOMPLETE &&
           status != BATTEN_TOO_LARGE;
}

static batten_status count_left_out(bat_iges_reading *reading, int type, int form)
{
    bat_iges_count *counts = reading->left_out.items;
    const bat_iges_count first = {type, form, 1};
    reading->input->left_out++;
    /* A bound on the kinds keeps the search short whatever the file says; the last one is
     * shared. */
    for (size_t k = 0; k < reading->left_out.count; k++)
        if ((counts[k].type == type && counts[k].form == form) || k == 255) {
            counts[k].count++;
            return BATTEN_OK;
        }
    return bat_list_add(reading->input, &reading->left_out, &first);
}

static void note_left_out(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    char what[48];
    snprintf(what, sizeof what, "#%d %s", entry->id, bat_iges_type_name(entry->type));
    batten_notes_add(reading->input->notes, reading->input->file, entry->line, what,
                     "%.300s; left out", batten_message());
    reading->input->left_out++;
}

/* The name of an entry that has no property for it: its label, or its type and number. */
static void default_name(const bat_iges_entry *entry, char *name, size_t size)
{
    if (entry->label[0] && entry->subscript)
        snprintf(name, size, "%s %d", entry->label, entry->subscript);
    else if (entry->label[0])
        snprintf(name, size, "%s", entry->label);
    else
        snprintf(name, size, "%s D%d", entry->type == 128 ? "surface" : "curve", entry->id);
}

static batten_status add_object(bat_iges_reading *reading, const bat_iges_entry *entry,
                                const char *name, batten_curve *curve, batten_surface *surface)
{
    char plain[32], layer[16] = "";
    default_name(entry, plain, sizeof plain);
    if (entry->level > 0)
        snprintf(layer, sizeof layer, "%d", entry->level);
    batten_object object = {.name = name ? name : plain,
                            .layer = layer,
                            .kind = surface ? BATTEN_OBJECT_SURFACE : BATTEN_OBJECT_CURVE,
                            .curve = curve,
                            .surface = surface};
    object.has_colour = read_colour(reading, entry->colour, object.colour);
    return batten_model_add(reading->model, &object);
}

/* Move a shape by the matrices of its entry. */
static batten_status apply_transform(bat_iges_reading *reading, const bat_iges_entry *entry,
                                     batten_curve **curve, batten_surface **surface)
{
    batten_affine map;
    batten_curve *moved_curve = NULL;
    batten_surface *moved_surface = NULL;
    if (entry->transform == 0)
        return BATTEN_OK;
    batten_status status = read_transform(reading, entry->transform, &map);
    if (status == BATTEN_OK && *curve)
        status = batten_curve_transform(*curve, &map, &moved_curve);
    if (status == BATTEN_OK && *surface)
        status = batten_surface_transform(*surface, &map, &moved_surface);
    if (status != BATTEN_OK)
        return status;
    batten_curve_unref(*curve);
    batten_surface_unref(*surface);
    *curve = moved_curve;
    *surface = moved_surface;
    return BATTEN_OK;
}

static batten_status read_shape(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    char *name = NULL;
    size_t own = 0;
    int type = 0;
    batten_status status = bat_iges_tokens(&reading->file, entry);
    if (status == BATTEN_OK)
        status = bat_iges_integer(&reading->file, 0, &type);
    if (status == BATTEN_OK && type != entry->type)
        status = bat_fail(BATTEN_BAD_FORMAT, "its parameters are those of type %d", type);
    if (status == BATTEN_OK)
        status = type == 110   ? read_line(reading, &curve, &own)
                 : type == 126 ? read_curve(reading, entry, &curve, &own)
                               : read_surface(reading, entry, &surface, &own);
    if (status == BATTEN_OK)
        status = read_name(reading, own, &name);
    if (status == BATTEN_OK)
        status = apply_transform(reading, entry, &curve, &surface);
    if (status == BATTEN_OK)
        status = add_object(reading, entry, name, curve, surface);
    bat_release(name);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
    return status;
}

/* Forms of 110 above 0 are rays and whole lines; those of 126 and 128 say what the shape
 * happens to be. */
static bool has_known_form(const bat_iges_entry *entry)
{
    const int highest = entry->type == 110 ? 0 : entry->type == 126 ? 5 : 9;
    return entry->form >= 0 && entry->form <= highest;
}

batten_status bat_iges_read_entry(bat_iges_reading *reading, size_t place)
{
    const bat_iges_entry *entry = &entries_of(reading)[place];
    batten_status status = BATTEN_OK;
    if (entry->is_broken) {
        bat_fail(BATTEN_BAD_FORMAT, "its entry in the directory is damaged");
        note_left_out(reading, entry);
        return BATTEN_OK;
    }
    if (is_auxiliary(entry->type))
        return BATTEN_OK;
    /* Parts of other entities, and curves in the parameter space of a surface, are no objects.
     */
    if (entry->subordinate == 1 || entry->subordinate == 3 || entry->use == 5) {
        reading->dependent_count++;
        return BATTEN_OK;
    }
    if (!is_read(entry->type) || !has_known_form(entry))
        return count_left_out(reading, entry->type, entry->form);
    if (entry->hidden != 0 || entry->use != 0)
        return count_left_out(reading, entry->type, entry->form);
    status = read_shape(reading, entry);
    if (!is_fault_of_data(status))
        return status;
    note_left_out(reading, entry);
    return BATTEN_OK;
}
