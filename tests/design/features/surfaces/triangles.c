#include "design/evaluate.h"

#include <string.h>

static const char common[] =
    "batten: 1\nfeatures:\n"
    "  net: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
    "  two: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1], [0, 1, 0], [1, 0, 0]]}\n"
    "  sail: {bezier-triangle: net}\n"
    "  high: {points: [[2, 2, -1], [2, 1, 0], [1, 2, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
    "  jib: {bezier-triangle: high}\n"
    "  l2: {line: [[1, 0], [0, 1, 1]]}\n  l3: {line: [[0, 1, 1], [0, 0]]}\n"
    "  az: {arc: 1, angle: 90 deg}\n"
    "  ax: {arc: 1, angle: 90 deg, axis: x, from: y}\n"
    "  ay: {arc: 1, angle: 90 deg, axis: y, from: z}\n"
    "  ez: {extrude: az, along: [0, 0, -1]}\n"
    "  ex: {extrude: ax, along: [-1, 0, 0]}\n"
    "  ey: {extrude: ay, along: [0, -1, 0]}\n"
    "  l1: {line: [[0, 0], [1, 0]]}\n  s: {extrude: l1, along: z}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    return evaluate_design(text, "a", NULL, out);
}

static const batten_object *last_object(const batten_design *design)
{
    const batten_model *model = batten_design_result(design, "a")->value;
    return batten_model_object(model, batten_model_count(model) - 1);
}

TEST(triangles_flow_through_designs)
{
    static const struct {
        const char *feature;
        int count, degree;
        double low_x; /* of the box */
    } rows[] = {
        {"{bezier-triangle: net}", 1, 2, 0},
        {"{bezier-triangle: net, halve: 2}", 16, 2, 0},
        {"{bezier-triangle: two, degree: 1}", 2, 1, 0},
        {"{bezier-triangle: net, weights: [1, 1, 2, 1, 1, 3]}", 1, 2, 0},
        {"{triangles-of: s}", 2, 2, 0},
        {"{move: sail, by: [3, 0, 0]}", 1, 2, 3},
        {"{rotate: sail, by: 180 deg}", 1, 2, -2},
        {"{scale: sail, by: 2}", 1, 2, 0},
        {"{join-triangles: [sail, jib]}", 2, 3, 0},
        {"{elevate: sail, by: 3}", 1, 5, 0},
        {"{mirror: sail, plane: x}", 1, 2, -2},
        {"{collect: [sail]}", 1, 2, 0},
        {"{select: sail, names: [sail]}", 1, 2, 0},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i].feature, &design));
        const batten_object *object = last_object(design);
        CHECK_INT(object->kind, BATTEN_OBJECT_TRIANGLES);
        CHECK_INT(batten_triangles_count(object->triangles), rows[i].count);
        CHECK_INT(batten_triangles_degree(object->triangles), rows[i].degree);
        CHECK_NEAR(batten_triangles_box(object->triangles).low.x, rows[i].low_x, 1e-12);
        batten_design_free(design);
    }
}

TEST(triangles_become_patches_in_designs)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{patches-of: sail}", &design));
    CHECK_INT(batten_model_count(batten_design_result(design, "a")->value), 3);
    batten_design_free(design);
    design = NULL;
    CHECK_OK(evaluate("{patches-of: sail, form: pole}", &design));
    CHECK_INT(last_object(design)->kind, BATTEN_OBJECT_SURFACE);
    batten_design_free(design);
}

TEST(nets_that_are_none_are_refused_with_their_numbers)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{bezier-triangle: [net, two], degree: 3}", "12 points do not make whole nets"},
        {"{bezier-triangle: [net, two]}", "12 points do not make a triangular net"},
        {"{bezier-triangle: net, degree: 0}", "the degree is 0"},
        {"{bezier-triangle: net, weights: [1, 2]}", "2 weights for 6 points"},
        {"{bezier-triangle: net, weights: [1, 2, -3, 1, 1, 1]}",
         "weight 3 of triangle 1 is -3"},
        {"{bezier-triangle: s}", "points are needed"},
        {"{bezier-triangle: net, halve: 12}", "more than"},
        {"{join-triangles: sail}", "0 edges are shared"},
        {"{triangle-patch: [l1, l2]}", "between 3 curves, not 2"},
        {"{triangle-patch: [l1, l2, sail]}", "takes curves, and 'sail' is triangles"},
        {"{triangle-patch: [l1, l2, az]}", "is open by"},
        {"{triangle-patch: [l1, l2, l3], along: l1}", "surfaces or triangles are needed"},
        {"{triangles-of: sail}", "surfaces are needed"},
        {"{patches-of: s}", "triangles are needed"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        const batten_status status = evaluate(rows[i].feature, &design);
        if (status == BATTEN_OUT_OF_MEMORY)
            return;
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(outputs_show_write_and_check_triangles)
{
    static const char outputs[] = "outputs:\n"
                                  "  a.svg: {picture: sail}\n"
                                  "  a.png: {picture: sail, width: 90, height: 64}\n"
                                  "  a.step: {write: sail}\n"
                                  "  a.igs: {write: sail}\n"
                                  "  a.txt: {check: fine}\n"
                                  "  a.json: {check: fine}\n";
    char text[3000];
    batten_design *design = NULL;
    snprintf(text, sizeof text, "%s  fine: {bezier-triangle: net, halve: 1}\n%s", common,
             outputs);
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    for (int i = 0; i < batten_design_output_count(design); i++) {
        char *data = NULL;
        size_t size = 0;
        const char *name = batten_design_output_name(design, i);
        CHECK_OK(batten_design_output(design, i, NULL, NULL, &data, &size));
        CHECK(size > 100);
        if (strcmp(name, "a.txt") == 0)
            CHECK_CONTAINS(data, "4 triangles of degree 2; at 3 inner edges gaps of at most");
        if (strcmp(name, "a.json") == 0)
            CHECK_CONTAINS(data, "\"inner_edges\": 3");
        batten_release(data);
    }
    batten_design_free(design);
}

/* The patch in the corner of three cylinders is nearly the ball, and leaves it nowhere where it
 * meets them. */
TEST(a_triangle_patch_goes_on_from_the_surfaces_beside_it)
{
    static const char *const methods[] = {"side-vertex", "parallels", "corners"};
    for (int m = 0; m < 3; m++) {
        char feature[200];
        batten_design *design = NULL;
        snprintf(
            feature, sizeof feature,
            "{triangle-patch: [ay, ax, az], along: [ex, ey, ez], method: %s, angle: 0.2 deg}",
            methods[m]);
        CHECK_OK(evaluate(feature, &design));
        const batten_surface *surface = last_object(design)->surface;
        for (int i = 1; i <= 10; i++) /* the B-spline near it has a pole at u = 0 */
            for (int j = 0; j <= 10; j++) {
                double p[3];
                batten_vec3 n = {0, 0, 0};
                CHECK_OK(batten_surface_evaluate(surface, i / 10.0, j / 10.0, 0, p));
                const double radius = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                CHECK_NEAR(radius, 1, m == 0 ? 0.07 : m == 1 ? 0.05 : 0.02);
                CHECK_OK(batten_surface_normal(surface, i / 10.0, j / 10.0, NULL, &n));
                const double facing = fabs(n.x * p[0] + n.y * p[1] + n.z * p[2]) / radius;
                CHECK_NEAR(facing, 1, i == 10 || j == 0 || j == 10 ? 1e-5 : 0.02);
            }
        batten_design_free(design);
    }
}

TEST(a_triangle_patch_goes_on_from_bezier_triangles)
{
    static const char text[] =
        "batten: 1\nfeatures:\n"
        "  net: {points: [[0, 0, 0], [1, 0, 1], [0, 1, 1], [2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n"
        "  sail: {bezier-triangle: net}\n"
        "  edge: {points: [[2, 0, 0], [1, 1, 1], [0, 2, 0]]}\n  a: {bezier: edge}\n"
        "  right: {points: [[0, 2, 0], [1, 2.3, -0.3], [2, 2, -1.5]]}\n  b: {bezier: right}\n"
        "  high: {points: [[2, 2, -1.5], [2.3, 1, -0.3], [2, 0, 0]]}\n  c: {bezier: high}\n"
        "  p: {triangle-patch: [a, b, c], along: sail, method: corners, angle: 1 deg}\n";
    batten_design *design = NULL;
    CHECK_OK(batten_design_parse(text, strlen(text), NULL, NULL, &design));
    CHECK_OK(batten_design_evaluate(design, "p", NULL, NULL));
    const batten_triangles *sail =
        batten_model_object(batten_design_result(design, "sail")->value, 0)->triangles;
    const batten_surface *patch =
        batten_model_object(batten_design_result(design, "p")->value, 0)->surface;
    for (int k = 1; k < 10; k++) {
        const double at[3] = {0, 1 - k / 10.0, k / 10.0};
        double p[3], q[3];
        batten_vec3 m = {0, 0, 0}, n = {0, 0, 0};
        CHECK_OK(batten_triangles_evaluate(sail, 0, at, 0, p));
        CHECK_OK(batten_surface_evaluate(patch, 1, at[2], 0, q));
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(q[c], p[c], 1e-3);
        CHECK_OK(batten_triangles_normal(sail, 0, at, NULL, &m));
        CHECK_OK(batten_surface_normal(patch, 1, at[2], NULL, &n));
        CHECK_NEAR(fabs(m.x * n.x + m.y * n.y + m.z * n.z), 1, 1e-4);
    }
    batten_design_free(design);
}
