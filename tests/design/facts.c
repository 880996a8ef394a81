/* Facts of places, lengths and areas: see expect.h. */
#include "design/facts.h"

#include <batten/measure.h>
#include <batten/triangles.h>

enum { SAMPLES = 7 };

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
    fact_near_point(of, f, p, n + f->count - 3);
}

static void check_heads(subject *of, const fact *f)
{
    double p[6];
    curve_at(of->object, f->number[0], 1, p);
    const double speed = hypot(hypot(p[3], p[4]), p[5]);
    for (int k = 3; k < 6; k++)
        p[k] /= speed;
    fact_near_point(of, f, p + 3, f->number + 1);
}

static void check_bends(subject *of, const fact *f)
{
    double p[9];
    curve_at(of->object, f->number[0], 2, p);
    const double a = p[4] * p[8] - p[5] * p[7], b = p[5] * p[6] - p[3] * p[8],
                 c = p[3] * p[7] - p[4] * p[6], speed = hypot(hypot(p[3], p[4]), p[5]);
    fact_near(of, f, hypot(hypot(a, b), c) / (speed * speed * speed), f->number[1]);
}

static void check_normal(subject *of, const fact *f)
{
    const batten_surface *surface = of->object->surface;
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(
        surface, between(batten_surface_domain(surface, BATTEN_U), f->number[0]),
        between(batten_surface_domain(surface, BATTEN_V), f->number[1]), NULL, &n));
    fact_near_point(of, f, (const double[3]){n.x, n.y, n.z}, f->number + 2);
}

static void check_joins(subject *of, const fact *f)
{
    double p[3], q[3];
    curve_at(fact_object(of, f->number[0]), f->number[1], 0, p);
    curve_at(fact_object(of, f->number[2]), f->number[3], 0, q);
    fact_near_point(of, f, p, q);
}

static void check_length(subject *of, const fact *f)
{
    double length = 0;
    CHECK_OK(batten_curve_length(of->object->curve, 1e-11, NULL, &length));
    fact_near(of, f, length, f->number[0]);
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
    fact_near(of, f, fmin(count, f->number[0]), f->number[0]);
}

static void check_area(subject *of, const fact *f)
{
    if (of->object->mesh) {
        fact_near(of, f, mesh_area(of->object->mesh), f->number[0]);
        return;
    }
    batten_area_measures measures = {0};
    CHECK_OK(batten_surface_area(of->object->surface, 1e-10, NULL, &measures));
    fact_near(of, f, measures.area, f->number[0]);
}

static void check_box(subject *of, const fact *f)
{
    batten_box box;
    CHECK(batten_model_box(of->result->value, &box));
    fact_near_point(of, f, (const double[3]){box.low.x, box.low.y, box.low.z}, f->number);
    fact_near_point(of, f, (const double[3]){box.high.x, box.high.y, box.high.z},
                    f->number + 3);
}

static void check_passes(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    CHECK(o->curve && o->parameters && o->point_count > 0);
    for (int i = 0; i < o->point_count; i++) {
        double p[3] = {0};
        CHECK_OK(batten_curve_evaluate(o->curve, o->parameters[i], 0, p));
        fact_near_point(of, f, p, o->points + 3 * (size_t)i);
    }
}

/* At their own parameters, not at the nearest places. */
static void check_reached(subject *of, const fact *f)
{
    const batten_object *o = of->object;
    double largest = 0, squares = 0;
    for (int i = 0; i < o->point_count; i++) {
        double at[3];
        CHECK_OK(batten_curve_evaluate(o->curve, o->parameters[i], 0, at));
        const double *p = o->points + 3 * (size_t)i,
                     off = hypot(hypot(at[0] - p[0], at[1] - p[1]), at[2] - p[2]);
        largest = fmax(largest, off);
        squares += off * off / o->point_count;
    }
    fact_near(of, f, of->result->has_error, 1);
    fact_near(of, f, of->result->error_max, largest);
    fact_near(of, f, of->result->error_rms, sqrt(squares));
}

static void check_distance(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *n = f->number;
    for (int i = 0; i < count; i++)
        fact_near(of, f, hypot(hypot(p[i][0] - n[1], p[i][1] - n[2]), p[i][2] - n[3]), n[0]);
}

static void check_along(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *o = f->number + 1, *u = f->number + 4;
    for (int i = 0; i < count; i++) {
        const double x = p[i][0] - o[0], y = p[i][1] - o[1], z = p[i][2] - o[2];
        const double a = y * u[2] - z * u[1], b = z * u[0] - x * u[2], c = x * u[1] - y * u[0];
        fact_near(of, f, hypot(hypot(a, b), c) / hypot(hypot(u[0], u[1]), u[2]), f->number[0]);
    }
}

static void check_on(subject *of, const fact *f)
{
    double p[SAMPLES * SAMPLES][3];
    const int count = sample(of->object, p);
    const double *n = f->number;
    for (int i = 0; i < count; i++)
        fact_near(of, f, n[0] * p[i][0] + n[1] * p[i][1] + n[2] * p[i][2], n[3]);
}

const known_fact geometry_facts[] = {
    {"at", check_at},       {"heads", check_heads},     {"normal", check_normal},
    {"joins", check_joins}, {"length", check_length},   {"area", check_area},
    {"box", check_box},     {"passes", check_passes},   {"distance", check_distance},
    {"along", check_along}, {"on", check_on},           {"finer", check_finer},
    {"bends", check_bends}, {"reached", check_reached},
};
const int geometry_fact_count = COUNT(geometry_facts);
