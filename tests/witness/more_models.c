/* Meshes for other programs, and STEP files with all that hangs on shapes. */
#include "witness/models.h"

static double least(double a, double b)
{
    return a < b ? a : b;
}

/* What STL has of the model: all parts where they stand. */
static void expect_meshes(const char *name, const batten_model *model, int copies,
                          const batten_write_options *options, double volume)
{
    batten_model *flat = NULL;
    batten_write_options stl = *options;
    int triangles = 0;
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {1e300, 1e300, 1e300}; /* of minus p */
    stl.format = BATTEN_FORMAT_STL;
    CHECK(batten_write_prepare(model, &stl, NULL, &flat));
    for (int i = 0; i < batten_model_count(flat); i++) {
        const batten_mesh_parts *p = batten_mesh_view(batten_model_object(flat, i)->mesh);
        triangles += p->triangle_count;
        for (int k = 0; k < 3 * p->vertex_count; k++) {
            low[k % 3] = least(low[k % 3], p->points[k]);
            high[k % 3] = least(high[k % 3], -p->points[k]);
        }
    }
    FILE *file = open_beside(name, "meshes");
    fprintf(file, "%d %d %.17g %.9g %.9g %.9g %.9g %.9g %.9g\n", triangles, triangles / copies,
            volume, low[0], low[1], low[2], -high[0], -high[1], -high[2]);
    fclose(file);
    batten_model_unref(flat);
}

void put_meshes(const char *name, const batten_model *model, int copies, double volume)
{
    static const char *const endings[] = {"stl", "ply", "obj", "glb", "3mf"};
    batten_write_options options = batten_write_defaults();
    batten_mesh_options triangles = batten_mesh_defaults();
    char text[64];
    triangles.chord = 1e-4;
    options.mesh = &triangles;
    for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++)
        put_file(name, endings[k], model, &options);
    expect_meshes(name, model, copies, &options, volume);
    options.as_text = true;
    snprintf(text, sizeof text, "%s-text", name);
    for (int k = 0; k < 2; k++)
        put_file(text, endings[k], model, &options);
    expect_meshes(text, model, copies, &options, volume);
}

void put_marks(void)
{
    static const double points[] = {0, 0, 0, 1, 2, 3}, corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const batten_mesh_parts triangle = {.vertex_count = 3,
                                        .points = corners,
                                        .triangle_count = 1,
                                        .corners = (const int[]){0, 1, 2}};
    batten_write_options options = batten_write_defaults();
    batten_curve *curve = NULL;
    batten_mesh *mesh = NULL;
    batten_model *model = NULL;
    CHECK(batten_model_create(1, &model));
    CHECK(batten_curve_create((batten_points){3, 2, points}, 1, NULL,
                              (const double[]){0, 0, 1, 1}, &curve));
    CHECK(batten_mesh_create(&triangle, &mesh));
    CHECK(batten_model_add(model, &(batten_object){.name = "it's \xc3\xbc \\ \xf0\x9f\x9a\xa2",
                                                   .has_colour = true,
                                                   .colour = {1, 0.5, 0},
                                                   .layer = "marks",
                                                   .group = "all/points",
                                                   .kind = BATTEN_OBJECT_POINTS,
                                                   .point_count = 2,
                                                   .points = points}));
    CHECK(batten_model_add(model, &(batten_object){.name = "hidden",
                                                   .is_hidden = true,
                                                   .layer = "marks",
                                                   .group = "all/curves",
                                                   .kind = BATTEN_OBJECT_CURVE,
                                                   .curve = curve}));
    put_file("marks-214", "step", model, NULL);
    put_file("marks", "igs", model, NULL);
    CHECK(batten_model_add(model, &(batten_object){.name = "triangle",
                                                   .has_colour = true,
                                                   .colour = {0, 0.5, 0},
                                                   .kind = BATTEN_OBJECT_MESH,
                                                   .mesh = mesh}));
    options.schema = BATTEN_STEP_AP242;
    put_file("marks-242", "step", model, &options);
    batten_mesh_unref(mesh);
    batten_curve_unref(curve);
    batten_model_unref(model);
}
