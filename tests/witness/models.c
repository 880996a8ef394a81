/*
 * Files for other programs to read, and where the points of their shapes must be.
 *
 *     batten-witness-models FOLDER
 *
 * For each shape there is a STEP and an IGES file in several units, and beside it a table:
 * index of the face or edge, u and v in 0..1, and x y z in millimetres.
 */
#include <batten/batten.h>
#include <stdio.h>
#include <stdlib.h>

#define CHECK(call)                                               \
    do {                                                          \
        if ((call) != BATTEN_OK) {                                \
            fprintf(stderr, "%s: %s\n", #call, batten_message()); \
            exit(1);                                              \
        }                                                         \
    } while (0)

static const char *folder;

/* Samples along each parameter of a face, and along an edge. */
enum { FACE_SAMPLES = 12, EDGE_SAMPLES = 100 };

static FILE *open_table(const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    FILE *file = fopen(path, "w");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static double at(batten_interval domain, double t)
{
    return t == 1 ? domain.b : domain.a + t * (domain.b - domain.a);
}

static void put_face(FILE *table, int index, const batten_surface *surface, double mm)
{
    for (int i = 0; i <= FACE_SAMPLES; i++)
        for (int j = 0; j <= FACE_SAMPLES; j++) {
            const double u = (double)i / FACE_SAMPLES, v = (double)j / FACE_SAMPLES;
            double p[3];
            CHECK(batten_surface_evaluate(
                surface, at(batten_surface_domain(surface, BATTEN_U), u),
                at(batten_surface_domain(surface, BATTEN_V), v), 0, p));
            fprintf(table, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", index, u, v, p[0] * mm,
                    p[1] * mm, p[2] * mm);
        }
}

static void put_edge(FILE *table, int index, const batten_curve *curve, double mm)
{
    for (int i = 0; i <= EDGE_SAMPLES; i++) {
        const double u = (double)i / EDGE_SAMPLES;
        double p[3];
        CHECK(batten_curve_evaluate(curve, at(batten_curve_domain(curve), u), 0, p));
        fprintf(table, "%d,%.17g,,%.17g,%.17g,%.17g\n", index, u, p[0] * mm, p[1] * mm,
                p[2] * mm);
    }
}

/* Write the model as both kinds of file, and the table of its points. */
static void put_model(const char *name, const batten_model *model)
{
    static const char *const endings[] = {"step", "igs"};
    const double mm = batten_model_unit_metres(model) * 1000;
    FILE *table = open_table(name);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->surface)
            put_face(table, i, object->surface, mm);
        else
            put_edge(table, i, object->curve, mm);
    }
    fclose(table);
    for (int k = 0; k < 2; k++) {
        char path[512];
        snprintf(path, sizeof path, "%s/%s.%s", folder, name, endings[k]);
        CHECK(batten_write_file(model, path, NULL, NULL));
    }
}

static void add_surface(batten_model *model, const char *name, batten_surface *surface)
{
    CHECK(batten_model_add(model, &(batten_object){.name = name,
                                                   .has_colour = true,
                                                   .colour = {0.8, 0.2, 0.1},
                                                   .kind = BATTEN_OBJECT_SURFACE,
                                                   .surface = surface}));
    batten_surface_unref(surface);
}

static void add_curve(batten_model *model, const char *name, batten_curve *curve)
{
    CHECK(batten_model_add(model, &(batten_object){.name = name,
                                                   .has_colour = true,
                                                   .colour = {0, 0.5, 1},
                                                   .kind = BATTEN_OBJECT_CURVE,
                                                   .curve = curve}));
    batten_curve_unref(curve);
}

/* A cubic by quadratic patch with a knot inside, and weights when `rational`. */
static batten_surface *patch(bool rational)
{
    static const double u[] = {0, 0, 0, 0, 0.4, 1, 1, 1, 1}, v[] = {-1, -1, -1, 0.5, 2, 2, 2};
    const batten_axis axis_u = {3, 5, u, false}, axis_v = {2, 4, v, false};
    double points[60], weights[20];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 4; j++) {
            double *p = &points[3 * (4 * i + j)];
            p[0] = 7.0 * i;
            p[1] = 5.0 * j + 0.3 * i;
            p[2] = (i - 2.0) * (i - 2.0) - 0.7 * j * j + 0.2 * i * j;
            weights[4 * i + j] = 1 + 0.3 * ((i + j) % 3);
        }
    batten_surface *surface = NULL;
    CHECK(batten_surface_create(3, &axis_u, &axis_v, points, rational ? weights : NULL,
                                &surface));
    return surface;
}

static void put_surfaces(const char *name, double unit)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surface = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(unit, &model));
    add_surface(model, "patch", patch(false));
    add_surface(model, "rational patch", patch(true));
    CHECK(batten_surface_cylinder(&frame, 20, 30, &surface));
    add_surface(model, "cylinder: closed", surface);
    CHECK(batten_surface_cone(&frame, 10, 4, 12, &surface));
    add_surface(model, "cone", surface);
    CHECK(batten_surface_sphere(&frame, 15, &surface));
    add_surface(model, "sphere: poles", surface);
    CHECK(batten_surface_torus(&frame, 25, 6, &surface));
    add_surface(model, "torus: closed twice", surface);
    put_model(name, model);
    batten_model_unref(model);
}

static void put_curves(const char *name, double unit)
{
    static const double knots[] = {0, 0, 0, 0, 1, 2, 2, 2, 2}, line[] = {0, 0, 1, 1};
    static const double points[] = {0, 0, 0, 1, 5, 2, 4, 6, 1, 8, -2, 0, 9, 1, 7};
    static const double weights[] = {1, 2, 0.5, 1, 1};
    batten_curve *curve = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(unit, &model));
    CHECK(batten_curve_create(3, 3, 5, points, NULL, knots, &curve));
    add_curve(model, "spline", curve);
    CHECK(batten_curve_create(3, 3, 5, points, weights, knots, &curve));
    add_curve(model, "rational", curve);
    CHECK(batten_curve_create(3, 1, 2, points, NULL, line, &curve));
    add_curve(model, "line", curve);
    put_model(name, model);
    batten_model_unref(model);
}

static void put_both(void)
{
    static const double points[] = {0, 0, 9, 5, 0, 9, 9, 2, 9, 12, 7, 9};
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(0.001, &model));
    add_surface(model, "patch \xc3\xbc", patch(true));
    CHECK(batten_curve_create(3, 3, 4, points, NULL, knots, &curve));
    add_curve(model, "curve's \\ name", curve);
    put_model("both-mm", model);
    batten_model_unref(model);
}

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
        return 2;
    }
    folder = arguments[1];
    put_surfaces("surfaces-mm", 0.001);
    put_surfaces("surfaces-m", 1);
    put_surfaces("surfaces-in", 0.0254);
    put_surfaces("surfaces-ft", 0.3048);
    put_curves("curves-mm", 0.001);
    put_curves("curves-m", 1);
    put_both();
    return 0;
}
