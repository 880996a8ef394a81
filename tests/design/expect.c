/* Facts about the result of a feature: see expect.h. */
#include "design/expect.h"
#include "design/evaluate.h"

#include <batten/measure.h>
#include <batten/triangles.h>
#include <stdlib.h>

enum { SAMPLES = 7, NUMBERS = 8 };

/* The row under test, and the object that its facts are about. */
typedef struct {
    const char *feature;
    const batten_feature_result *result;
    const batten_object *object;
    const batten_notes *notes;
    double within;
} subject;

typedef struct {
    char word[24];
    const char *rest; /* after the word */
    int count;
    double number[NUMBERS];
} fact;

typedef struct {
    const char *word;
    void (*check)(subject *of, const fact *f);
} known_fact;

static const batten_object *at(const subject *of, double index)
{
    CHECK(index >= 0 && index < batten_model_count(of->result->value));
    return batten_model_object(of->result->value, (int)index);
}

/* All that is wrong in a table is listed before the test fails. */
static int wrong;

static void near_value(const subject *of, const fact *f, double actual, double expected)
{
    if (fabs(actual - expected) <= of->within * (1 + fabs(expected)))
        return;
    wrong++;
    fprintf(stderr, "a: %s\n    %s %s: found %.16g, expected %.16g\n", of->feature, f->word,
            f->rest, actual, expected);
}

static void near_point(const subject *of, const fact *f, const double *actual,
                       const double *expected)
{
    for (int k = 0; k < 3; k++)
        near_value(of, f, actual[k], expected[k]);
}

static void says(const subject *of, const fact *f, const char *text)
{
    if (text && strstr(text, f->rest))
        return;
    wrong++;
    fprintf(stderr, "a: %s\n    %s %s: found %s\n", of->feature, f->word, f->rest,
            text ? text : "nothing");
}

/* ---- places on an object ---- */

static double between(batten_interval domain, double s)
{
    return s == 1 ? domain.b : domain.a + s * (domain.b - domain.a);
}

/* Of a chain what it truly is. */
static void curve_at(const batten_object *object, double s, int order, double *out)
{
    double p[9] = {0};
    const int d = object->chain ? batten_chain_dimension(object->chain)
                                : batten_curve_dimension(object->curve);
    if (object->chain)
        CHECK_OK(batten_chain_evaluate(
            object->chain, between(batten_chain_domain(object->chain), s), order, p));
    else
        CHECK_OK(batten_curve_evaluate(
            object->curve, between(batten_curve_domain(object->curve), s), order, p));
    for (int row = 0; row <= order; row++)
        for (int k = 0; k < 3; k++)
            out[3 * row + k] = k < d ? p[d * row + k] : 0;
}

static void surface_at(const batten_surface *surface, double s, double t, double *out)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    CHECK_OK(batten_surface_evaluate(surface, between(u, s), between(v, t), 0, out));
}

static void triangle_at(const batten_triangles *triangles, double s, double t, double *out)
{
    CHECK_OK(
        batten_triangles_evaluate(triangles, 0, (const double[3]){1 - s - t, s, t}, 0, out));
}

/* A grid of places on the object, at most SAMPLES^2. */
static int sample(const batten_object *object, double (*out)[3])
{
    int count = 0;
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++) {
            const double s = i / (SAMPLES - 1.0), t = j / (SAMPLES - 1.0);
            if (object->surface)
                surface_at(object->surface, s, t, out[count++]);
            else if (object->triangles && s + t <= 1)
                triangle_at(object->triangles, s, t, out[count++]);
            else if (object->curve && j == 0)
                curve_at(object, s, 0, out[count++]);
        }
    CHECK(count > 0);
    return count;
}

/* ---- facts ---- */

static void check_objects(subject *of, const fact *f)
{
    near_value(of, f, batten_model_count(of->result->value), f->number[0]);
}

static void check_object(subject *of, const fact *f)
{
    of->object = at(of, f->number[0]);
}

static void check_named(subject *of, const fact *f)
{
    says(of, f, of->object->name);
}

static void check_layer(subject *of, const fact *f)
{
    says(of, f, of->object->layer);
}

static void check_kind(subject *of, const fact *f)
{
    says(of, f, batten_object_kind_name(of->object->kind));
}

static void check_within(subject *of, const fact *f)
{
    of->within = f->number[0];
}

static void check_degree(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    if (o->triangles)
        near_value(of, f, batten_triangles_degree(o->triangles), f->number[0]);
    else
        near_value(of, f,
                   o->curve ? batten_curve_degree(o->curve)
                            : batten_surface_degree(o->surface, BATTEN_U),
                   f->number[0]);
    if (f->count > 1)
        near_value(of, f, batten_surface_degree(o->surface, BATTEN_V), f->number[1]);
}

static void check_count(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    if (o->triangles)
        near_value(of, f, batten_triangles_count(o->triangles), f->number[0]);
    else if (o->kind == BATTEN_OBJECT_POINTS)
        near_value(of, f, o->point_count, f->number[0]);
    else
        near_value(of, f,
                   o->curve ? batten_curve_point_count(o->curve)
                            : batten_surface_point_count(o->surface, BATTEN_U),
                   f->number[0]);
    if (f->count > 1)
        near_value(of, f, batten_surface_point_count(o->surface, BATTEN_V), f->number[1]);
}

static void check_rational(subject *of, const fact *f)
{
    near_value(of, f,
               of->object->curve ? batten_curve_is_rational(of->object->curve)
                                 : batten_surface_is_rational(of->object->surface),
               f->number[0]);
}

static void check_closed(subject *of, const fact *f)
{
    near_value(of, f, batten_curve_is_closed(of->object->curve, 1e-9), f->number[0]);
}

static void check_domain(subject *of, const fact *f)
{
    const batten_interval domain = batten_curve_domain(of->object->curve);
    near_value(of, f, domain.a, f->number[0]);
    near_value(of, f, domain.b, f->number[1]);
}

static void check_at(subject *of, const fact *f)
{
    double p[3] = {0};
    const double *n = f->number;
    if (of->object->surface)
        surface_at(of->object->surface, n[0], n[1], p);
    else if (of->object->triangles)
        triangle_at(of->object->triangles, n[0], n[1], p);
    else
        curve_at(of->object, n[0], 0, p);
    near_point(of, f, p, n + f->count - 3);
}

static void check_heads(subject *of, const fact *f)
{
    double p[6];
    curve_at(of->object, f->number[0], 1, p);
    const double speed = hypot(hypot(p[3], p[4]), p[5]);
    for (int k = 3; k < 6; k++)
        p[k] /= speed;
    near_point(of, f, p + 3, f->number + 1);
}

static void check_bends(subject *of, const fact *f)
{
    double p[9];
    curve_at(of->object, f->number[0], 2, p);
    const double a = p[4] * p[8] - p[5] * p[7], b = p[5] * p[6] - p[3] * p[8],
                 c = p[3] * p[7] - p[4] * p[6], speed = hypot(hypot(p[3], p[4]), p[5]);
    near_value(of, f, hypot(hypot(a, b), c) / (speed * speed * speed), f->number[1]);
}

static void check_spans(subject *of, const fact *f)
{
    near_value(of, f, of->object->chain ? batten_chain_span_count(of->object->chain) : 0,
               f->number[0]);
}

static void check_normal(subject *of, const fact *f)
{
    const batten_surface *surface = of->object->surface;
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(
        surface, between(batten_surface_domain(surface, BATTEN_U), f->number[0]),
        between(batten_surface_domain(surface, BATTEN_V), f->number[1]), NULL, &n));
    near_point(of, f, (const double[3]){n.x, n.y, n.z}, f->number + 2);
}

static void check_joins(subject *of, const fact *f)
{
    double p[3], q[3];
    curve_at(at(of, f->number[0]), f->number[1], 0, p);
    curve_at(at(of, f->number[2]), f->number[3], 0, q);
    near_point(of, f, p, q);
}

static void check_length(subject *of, const fact *f)
{
    double length = 0;
    CHECK_OK(batten_curve_length(of->object->curve, 1e-11, NULL, &length));
    near_value(of, f, length, f->number[0]);
}

static double triangle_area(const double *a, const double *b, const double *c)
{
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                 v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return hypot(hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2]),
                 u[0] * v[1] - u[1] * v[0]) /
           2;
}

static double mesh_area(const batten_mesh *mesh)
{
    const batten_mesh_parts *parts = batten_mesh_view(mesh);
    double area = 0;
    for (int i = 0; i < parts->triangle_count; i++) {
        const int *t = parts->corners + 3 * (size_t)i;
        area +=
            triangle_area(parts->points + 3 * (size_t)t[0], parts->points + 3 * (size_t)t[1],
                          parts->points + 3 * (size_t)t[2]);
    }
    return area;
}

static void check_finer(subject *of, const fact *f)
{
    const int count = batten_mesh_view(of->object->mesh)->triangle_count;
    near_value(of, f, fmin(count, f->number[0]), f->number[0]);
}

static void check_area(subject *of, const fact *f)
{
    if (of->object->mesh) {
        near_value(of, f, mesh_area(of->object->mesh), f->number[0]);
        return;
    }
    batten_area_measures measures = {0};
    CHECK_OK(batten_surface_area(of->object->surface, 1e-10, NULL, &measures));
    near_value(of, f, measures.area, f->number[0]);
}

static void check_box(subject *of, const fact *f)
{
    batten_box box;
    CHECK(batten_model_box(of->result->value, &box));
    near_point(of, f, (const double[3]){box.low.x, box.low.y, box.low.z}, f->number);
    near_point(of, f, (const double[3]){box.high.x, box.high.y, box.high.z}, f->number + 3);
}

static void check_control(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    const double *points =
        o->curve ? batten_curve_points(o->curve) : batten_surface_points(o->surface);
    near_point(of, f, points + 3 * (int)f->number[0], f->number + 1);
}

static void check_data(subject *of, const fact *f)
{
    const int i = (int)f->number[0];
    CHECK(i < of->object->point_count);
    near_point(of, f, of->object->points + 3 * (size_t)i, f->number + 1);
}

static void check_passes(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    CHECK(o->curve && o->parameters && o->point_count > 0);
    for (int i = 0; i < o->point_count; i++) {
        double p[3] = {0};
        CHECK_OK(batten_curve_evaluate(o->curve, o->parameters[i], 0, p));
        near_point(of, f, p, o->points + 3 * (size_t)i);
    }
}

static void check_distance(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *n = f->number;
    for (int i = 0; i < count; i++)
        near_value(of, f, hypot(hypot(p[i][0] - n[1], p[i][1] - n[2]), p[i][2] - n[3]), n[0]);
}

static void check_along(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *o = f->number + 1, *u = f->number + 4;
    for (int i = 0; i < count; i++) {
        const double x = p[i][0] - o[0], y = p[i][1] - o[1], z = p[i][2] - o[2];
        const double a = y * u[2] - z * u[1], b = z * u[0] - x * u[2], c = x * u[1] - y * u[0];
        near_value(of, f, hypot(hypot(a, b), c) / hypot(hypot(u[0], u[1]), u[2]), f->number[0]);
    }
}

static void check_on(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *n = f->number;
    for (int i = 0; i < count; i++)
        near_value(of, f, n[0] * p[i][0] + n[1] * p[i][1] + n[2] * p[i][2], n[3]);
}

static void check_error(subject *of, const fact *f)
{
    CHECK(of->result->has_error);
    near_value(of, f, fmax(of->result->error_max, f->number[0]), f->number[0]);
    CHECK(of->result->error_rms <= of->result->error_max);
}

static void check_exact(subject *of, const fact *f)
{
    near_value(of, f, of->result->has_error, 0);
}

static void check_moves(subject *of, const fact *f)
{
    near_value(of, f, of->result->has_moves, 1);
    near_value(of, f, of->result->moved_count, f->number[0]);
    near_value(of, f, fmax(of->result->move_max, f->number[1]), f->number[1]);
}

static void check_notes(subject *of, const fact *f)
{
    char all[3000] = "";
    for (int i = 0; i < batten_notes_count(of->notes); i++) {
        const size_t length = strlen(all);
        snprintf(all + length, sizeof all - length, "%s\n",
                 batten_notes_at(of->notes, i)->text);
    }
    says(of, f, all);
}

static void check_silent(subject *of, const fact *f)
{
    near_value(of, f, batten_notes_count(of->notes), 0);
}

static const known_fact facts[] = {
    {"objects", check_objects},   {"object", check_object}, {"named", check_named},
    {"layer", check_layer},       {"kind", check_kind},     {"within", check_within},
    {"degree", check_degree},     {"count", check_count},   {"rational", check_rational},
    {"closed", check_closed},     {"domain", check_domain}, {"at", check_at},
    {"heads", check_heads},       {"normal", check_normal}, {"joins", check_joins},
    {"length", check_length},     {"area", check_area},     {"box", check_box},
    {"control", check_control},   {"data", check_data},     {"passes", check_passes},
    {"distance", check_distance}, {"along", check_along},   {"on", check_on},
    {"error", check_error},       {"exact", check_exact},   {"notes", check_notes},
    {"silent", check_silent},     {"finer", check_finer},   {"moves", check_moves},
    {"bends", check_bends},       {"spans", check_spans},
};

static void check_fact(subject *of, char *text)
{
    fact f = {.number = {0}};
    int length = 0;
    CHECK(sscanf(text, " %23s%n", f.word, &length) == 1);
    f.rest = text + length + (text[length] == ' ');
    char *end = text + length;
    for (const char *from = end; f.count < NUMBERS; f.count++, from = end) {
        f.number[f.count] = strtod(from, &end);
        if (end == from)
            break;
    }
    for (int i = 0; i < COUNT(facts); i++)
        if (strcmp(facts[i].word, f.word) == 0) {
            facts[i].check(of, &f);
            return;
        }
    test_text(f.word, "a fact of expect.h", text, __FILE__, __LINE__);
}

static void check_result(const expect_row *row, const batten_design *design,
                         const batten_notes *notes)
{
    subject of = {row->feature, batten_design_result(design, "a"), NULL, notes, 1e-9};
    CHECK(of.result && of.result->value);
    if (batten_model_count(of.result->value) > 0)
        of.object = at(&of, 0);
    char *text = test_array(strlen(row->facts) + 1, 1);
    strcpy(text, row->facts);
    for (char *part = strtok(text, ";"); part; part = strtok(NULL, ";"))
        check_fact(&of, part);
}

static void check_row(const char *before, const expect_row *row)
{
    char text[6000];
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    snprintf(text, sizeof text, "batten: 1\nunits: m\ntolerance: 0.001\nfeatures:\n%s  a: %s\n",
             before, row->feature);
    CHECK_OK(batten_notes_create(30, &notes));
    batten_status status = evaluate_design(text, "a", notes, &design);
    if (test_memory_failed(status, row->status))
        status = evaluate_design(text, "a", notes, &design);
    if (status == BATTEN_OK && row->status == BATTEN_OK)
        check_result(row, design, notes);
    else if (status != row->status || !strstr(batten_message(), row->facts)) {
        wrong++;
        fprintf(stderr, "a: %s\n    %s, %s\n    expected %s, %s\n", row->feature,
                batten_status_name(status), batten_message(), batten_status_name(row->status),
                row->facts);
    }
    batten_design_free(design);
    batten_notes_free(notes);
}

void expect_rows(const char *before, const expect_row *rows, int count)
{
    wrong = 0;
    for (int i = 0; i < count; i++)
        check_row(before, &rows[i]);
    CHECK_INT(wrong, 0);
}

void expect_each(const char *before, const char *const *names, int name_count,
                 const expect_row *rows, int row_count)
{
    for (int i = 0; i < name_count; i++)
        for (int k = 0; k < row_count; k++) {
            char feature[300];
            const char *at = strchr(rows[k].feature, '@');
            CHECK(at != NULL);
            snprintf(feature, sizeof feature, "%.*s%s%s", (int)(at - rows[k].feature),
                     rows[k].feature, names[i], at + 1);
            expect_rows(before, &(expect_row){feature, rows[k].status, rows[k].facts}, 1);
        }
}
