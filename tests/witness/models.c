/*
 * Files for other programs to read, and what they must find in them.
 *
 *     batten-witness-models FOLDER
 *
 * Shapes are NAME.step and NAME.igs, in several units. NAME.csv has their points: index of the
 * face or edge, u and v in 0..1, and x y z in millimetres. NAME.expect has the numbers of
 * solids and faces, the area and the volume, 0 where they are not known.
 * Meshes are NAME.stl and so on. NAME.meshes has the number of triangles, how many of them
 * are of different parts, the volume, and the box, lowest corner first; in millimetres.
 */
#include "witness/models.h"
#include "support/drilled_box.h"

#include <stdio.h>
#include <stdlib.h>

static const char *folder;

/* Samples along each parameter of a face, and along an edge. */
enum { FACE_SAMPLES = 31, EDGE_SAMPLES = 1000 };

FILE *open_beside(const char *name, const char *ending)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.%s", folder, name, ending);
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

/* @param mirrored  the file has the surface reversed in u */
static void put_face(FILE *table, int index, const batten_surface *surface, bool mirrored,
                     const batten_affine *place, double mm)
{
    for (int i = 0; i <= FACE_SAMPLES; i++)
        for (int j = 0; j <= FACE_SAMPLES; j++) {
            const double u = (double)i / FACE_SAMPLES, v = (double)j / FACE_SAMPLES;
            double p[3];
            CHECK(batten_surface_evaluate(
                surface, at(batten_surface_domain(surface, BATTEN_U), mirrored ? 1 - u : u),
                at(batten_surface_domain(surface, BATTEN_V), v), 0, p));
            const batten_vec3 q = batten_affine_apply(*place, (batten_vec3){p[0], p[1], p[2]});
            fprintf(table, "%d,%.17g,%.17g,%.17g,%.17g,%.17g\n", index, u, v, q.x * mm,
                    q.y * mm, q.z * mm);
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

/* The points of the objects, placed; the index goes on. */
static void put_objects(FILE *table, int *index, const batten_model *model, bool is_iges,
                        const batten_affine *place)
{
    const double mm = batten_model_unit_metres(model) * 1000;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->surface)
            put_face(table, (*index)++, object->surface, false, place, mm);
        if (object->curve)
            put_edge(table, (*index)++, object->curve, mm);
        if (object->definition) {
            const batten_affine inner = batten_affine_compose(object->place, *place);
            put_objects(table, index, object->definition, is_iges, &inner);
        }
        const batten_body_parts *parts = object->body ? batten_body_view(object->body) : NULL;
        for (int f = 0; parts && f < parts->face_count; f++)
            put_face(table, (*index)++, parts->faces[f].surface,
                     is_iges && parts->faces[f].reversed, place, mm);
    }
}

/* IGES has faces against their surfaces on reversed ones. */
static void put_table(const char *name, const batten_model *model, bool is_iges)
{
    const batten_affine identity = batten_affine_identity();
    FILE *table = open_beside(name, "csv");
    int index = 0;
    put_objects(table, &index, model, is_iges, &identity);
    fclose(table);
}

void put_file(const char *name, const char *ending, const batten_model *model,
              const batten_write_options *options)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.%s", folder, name, ending);
    CHECK(batten_write_file(model, path, options, NULL));
}

static void expect(const char *name, int solids, int faces, double area, double volume)
{
    FILE *file = open_beside(name, "expect");
    fprintf(file, "%d %d %.17g %.17g\n", solids, faces, area, volume);
    fclose(file);
}

/* Write the model as both kinds of file, and the table of its points. */
static void put_model(const char *name, const batten_model *model, int faces)
{
    put_table(name, model, false);
    put_file(name, "step", model, NULL);
    put_file(name, "igs", model, NULL);
    expect(name, 0, faces, 0, 0);
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
    put_model(name, model, 6);
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
    CHECK(batten_curve_create((batten_points){3, 5, points}, 3, NULL, knots, &curve));
    add_curve(model, "spline", curve);
    CHECK(batten_curve_create((batten_points){3, 5, points}, 3, weights, knots, &curve));
    add_curve(model, "rational", curve);
    CHECK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, line, &curve));
    add_curve(model, "line", curve);
    put_model(name, model, 0);
    put_file(name, "dxf", model, NULL);
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
    CHECK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &curve));
    add_curve(model, "curve's \\ name", curve);
    put_model("both-mm", model, 1);
    batten_model_unref(model);
}

/* ---- bodies ---- */

static batten_model *block(void)
{
    batten_body *body = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(0.001, &model));
    CHECK(drilled_box(&body));
    CHECK(batten_model_add(model, &(batten_object){.name = "block",
                                                   .has_colour = true,
                                                   .colour = {0.2, 0.3, 0.9},
                                                   .layer = "solids",
                                                   .kind = BATTEN_OBJECT_BODY,
                                                   .body = body}));
    batten_body_unref(body);
    return model;
}

static const double pi = 3.14159265358979323846;

static double block_area(void)
{
    return 2 * (6 * 4 + 6 * 2 + 4 * 2) + 2 * pi * 2 - 2 * pi;
}

static double block_volume(void)
{
    return 6 * 4 * 2 - 2 * pi;
}

static void put_block(void)
{
    static const struct {
        const char *name;
        batten_step_schema schema;
        bool no_parameter_curves;
    } forms[] = {{"block-214", BATTEN_STEP_AP214, false},
                 {"block-203", BATTEN_STEP_AP203, false},
                 {"block-242", BATTEN_STEP_AP242, false},
                 {"block-without-curves", BATTEN_STEP_AP214, true}};
    batten_model *model = block();
    for (size_t k = 0; k < sizeof forms / sizeof forms[0]; k++) {
        batten_write_options options = batten_write_defaults();
        options.schema = forms[k].schema;
        options.no_parameter_curves = forms[k].no_parameter_curves;
        put_table(forms[k].name, model, false);
        put_file(forms[k].name, "step", model, &options);
        expect(forms[k].name, 1, 8, block_area(), block_volume());
    }
    put_table("block-faces", model, true);
    put_file("block-faces", "igs", model, NULL);
    expect("block-faces", 0, 8, block_area(), 0);
    batten_write_options whole = batten_write_defaults();
    whole.solids = true;
    put_table("block-whole", model, false);
    put_file("block-whole", "igs", model, &whole);
    expect("block-whole", 1, 8, block_area(), block_volume());
    batten_model_unref(model);
}

static void put_sheets(void)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(0.001, &model));
    CHECK(batten_surface_sphere(&frame, 15, &surface));
    CHECK(batten_body_from_surface("ball", surface, 1e-6, &body));
    CHECK(batten_model_add(
        model, &(batten_object){.name = "ball", .kind = BATTEN_OBJECT_BODY, .body = body}));
    put_table("sphere", model, false);
    put_file("sphere", "step", model, NULL);
    put_file("sphere", "igs", model, NULL);
    expect("sphere", 0, 1, 4 * pi * 15 * 15, 4 * pi * 15 * 15 * 15 / 3);
    batten_model_unref(model);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

static void place(batten_model *model, const char *name, const batten_model *definition,
                  batten_affine map)
{
    CHECK(batten_model_add(model, &(batten_object){.name = name,
                                                   .kind = BATTEN_OBJECT_INSTANCE,
                                                   .definition = definition,
                                                   .place = map}));
}

/* Two pairs of the block, and the block alone. */
static void put_assembly(void)
{
    batten_model *part = block(), *pair = NULL, *all = NULL;
    CHECK(batten_model_create(0.001, &pair));
    CHECK(batten_model_create(0.001, &all));
    place(pair, "left", part, batten_affine_identity());
    place(pair, "right", part,
          batten_affine_rotation((batten_vec3){10, 1, 2}, (batten_vec3){1, 2, 3}, 0.7));
    place(all, "first", pair, batten_affine_translation(100, 0, 0));
    place(all, "second", pair,
          batten_affine_rotation((batten_vec3){0, 50, 0}, (batten_vec3){0, 0, 1}, -2));
    place(all, "third", part, batten_affine_translation(0, 0, 70));
    put_table("assembly", all, false);
    put_file("assembly", "step", all, NULL);
    expect("assembly", 5, 40, 5 * block_area(), 5 * block_volume());
    put_table("copies", all, true);
    put_file("copies", "igs", all, NULL);
    expect("copies", 0, 40, 5 * block_area(), 0);
    put_meshes("placed", all, 5, 5 * block_volume());
    put_meshes("part", part, 1, block_volume());
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(part);
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
    put_block();
    put_sheets();
    put_assembly();
    put_marks();
    return 0;
}
