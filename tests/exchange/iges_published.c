/* Surfaces of IGES files against what Open CASCADE found on them: points, normals, curvatures.
 */
#include <batten/exchange.h>
#include <batten/inspect.h>

#include "support/json.h"
#include "support/test.h"

/* Normals and the sign of mean curvature depend on how a face is turned; Gaussian curvature
 * does not. */
static void check_sample(const batten_surface *surface, const char *sample, double size)
{
    double p[3], n[3];
    batten_surface_local at;
    json_numbers(json_key(sample, "p"), 3, p);
    const double u = json_number(json_key(sample, "u")), v = json_number(json_key(sample, "v"));
    batten_status status = batten_surface_local_at(surface, u, v, &at);
    if (test_memory_failed(status, BATTEN_OK))
        status = batten_surface_local_at(surface, u, v, &at);
    if (status == BATTEN_SINGULAR_HERE)
        return;
    CHECK_STATUS(status, BATTEN_OK);
    CHECK_NEAR(at.point.x, p[0], 1e-9 * size);
    CHECK_NEAR(at.point.y, p[1], 1e-9 * size);
    CHECK_NEAR(at.point.z, p[2], 1e-9 * size);
    if (json_numbers(json_key(sample, "n"), 3, n) < 3)
        return;
    CHECK_NEAR(fabs(at.normal.x * n[0] + at.normal.y * n[1] + at.normal.z * n[2]), 1, 1e-9);
    const double mean = json_number(json_key(sample, "mean")),
                 gauss = json_number(json_key(sample, "gauss"));
    CHECK_NEAR(fabs(at.mean), fabs(mean), 1e-6 * (fabs(mean) + 1 / size));
    CHECK_NEAR(at.gaussian, gauss, 1e-6 * (mean * mean + fabs(gauss) + 1 / size / size));
}

TEST(surfaces_of_iges_files_are_those_that_open_cascade_sees)
{
    static const struct {
        const char *name;
        batten_status status;
    } files[] = {{"hull_surfaces/cargo_hull_surface.igs", BATTEN_OK},
                 {"hull_surfaces/ropax_maxsurf.igs", BATTEN_OK},
                 {"iges/gd_wing128.igs", BATTEN_OK}};
    const char *all = json_file("peer_tests/occt_surface_evaluation.json");
    for (int f = 0; f < COUNT(files); f++) {
        batten_model *model = NULL;
        CHECK_STATUS(batten_read_file(test_data(files[f].name), NULL, NULL, NULL, &model),
                     files[f].status);
        batten_model *read = model;
        CHECK_OK(batten_model_to_unit(read, 0.001, &model)); /* millimetres */
        batten_model_unref(read);
        const char *faces = json_key(all, files[f].name);
        int face = 0;
        for (int i = 0; i < batten_model_count(model); i++) {
            const batten_object *object = batten_model_object(model, i);
            if (object->kind != BATTEN_OBJECT_SURFACE)
                continue;
            const char *published = json_item(faces, face++);
            CHECK(published != NULL);
            double box[6];
            const batten_box b = batten_surface_box(object->surface);
            const double size =
                hypot(hypot(b.high.x - b.low.x, b.high.y - b.low.y), b.high.z - b.low.z);
            CHECK(json_numbers(json_key(published, "poles"), 6, box) == 2);
            CHECK_INT(batten_surface_point_count(object->surface, BATTEN_U), (int)box[0]);
            CHECK_INT(batten_surface_point_count(object->surface, BATTEN_V), (int)box[1]);
            const char *samples = json_key(published, "samples");
            for (int k = 0; json_item(samples, k); k++)
                check_sample(object->surface, json_item(samples, k), size);
        }
        CHECK(face > 0 && !json_item(faces, face));
        batten_model_unref(model);
    }
}
