#include "exchange/reading.h"
#include "support/bodies.h"

#include <batten/geometry.h>

#define HEAD_CURVE "100 1 0 0\n"

static const char parabola[] = HEAD_CURVE "3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 2 0\n2 0 0\n";
static const char quarter[] = HEAD_CURVE "3 1\n3 3\n0 0 0 1 1 1\n2 0 0 1\n2 2 0 1\n0 4 0 2\n";

static batten_model *read_good(const char *text)
{
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_AUTO, NULL, &model));
    return model;
}

TEST(curves_of_g2_files_are_read)
{
    batten_model *model = read_good(parabola);
    const batten_object *object = batten_model_object(model, 0);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(object->name, "spline curve 1");
    CHECK_BITS(batten_model_unit_metres(model), 0);
    CHECK_INT(batten_curve_degree(object->curve), 2);
    CHECK_BITS(batten_curve_points(object->curve)[4], 2);
    CHECK(!batten_curve_is_rational(object->curve));
    batten_model_unref(model);

    model = read_good(quarter); /* a quarter circle: weights 1, 1, 2 */
    double p[3];
    CHECK_OK(batten_curve_evaluate(batten_model_object(model, 0)->curve, 0.3, 0, p));
    CHECK_NEAR(hypot(p[0], p[1]), 2, 1e-15);
    batten_model_unref(model);
}

TEST(headers_carry_colours)
{
    batten_model *model = read_good("400 1 0 4 255 0 51 255\n2\n1 2 3\n4 5 6\n");
    const batten_object *object = batten_model_object(model, 0);
    CHECK_INT(object->point_count, 2);
    CHECK_BITS(object->points[5], 6);
    CHECK(object->has_colour);
    CHECK_BITS(object->colour[0], 1);
    CHECK_NEAR(object->colour[2], 0.2, 1e-15);
    batten_model_unref(model);
}

TEST(points_may_have_their_parameters_before_them)
{
    batten_model *model = read_good("400 1 0 0\n2\n0.5 1 2 3\n0.75 4 5 6\n");
    const batten_object *object = batten_model_object(model, 0);
    CHECK_BITS(object->points[3], 4);
    CHECK_BITS(object->parameters[1], 0.75);
    batten_model_unref(model);
}

/* Points of the surface satisfy |F(x, y, z)| <= 1e-12 and the normal looks along grad F. */
static void check_surface(const char *text, double (*f)(const double *p, double *gradient))
{
    batten_model *model = read_good(text);
    const batten_surface *surface = batten_model_object(model, 0)->surface;
    CHECK(surface != NULL);
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    for (int i = 0; i <= 8; i++)
        for (int j = 1; j < 8; j++) {
            const double at[] = {u.a + (u.b - u.a) * i / 8, v.a + (v.b - v.a) * j / 8};
            double p[3], gradient[3];
            batten_vec3 n;
            CHECK_OK(batten_surface_evaluate(surface, at[0], at[1], 0, p));
            CHECK_OK(batten_surface_normal(surface, at[0], at[1], NULL, &n));
            CHECK_NEAR(f(p, gradient), 0, 1e-12);
            const double length = hypot(hypot(gradient[0], gradient[1]), gradient[2]);
            CHECK_NEAR((n.x * gradient[0] + n.y * gradient[1] + n.z * gradient[2]) / length, 1,
                       1e-9);
        }
    batten_model_unref(model);
}

static double sphere(const double *p, double *g)
{
    for (int k = 0; k < 3; k++)
        g[k] = p[k] - (k == 0 ? 1.5 : 0);
    return hypot(hypot(g[0], g[1]), g[2]) - 1.5;
}

static double cylinder(const double *p, double *g)
{
    g[0] = p[0];
    g[1] = p[1];
    g[2] = 0;
    CHECK(p[2] >= -1 - 1e-12 && p[2] <= 4 + 1e-12 && p[1] >= -1e-12);
    return hypot(p[0], p[1]) - 2;
}

static double cone(const double *p, double *g)
{
    const double r = hypot(p[0], p[1]);
    g[0] = p[0] / r;
    g[1] = p[1] / r;
    g[2] = -0.5;
    return r - 1 - 0.5 * p[2];
}

static double torus(const double *p, double *g)
{
    const double r = hypot(p[0], p[1]), out = r - 3, d = hypot(out, p[2]);
    g[0] = p[0] / r * out / d;
    g[1] = p[1] / r * out / d;
    g[2] = p[2] / d;
    return d - 1;
}

static double plane(const double *p, double *g)
{
    g[0] = g[1] = 0;
    g[2] = 1;
    CHECK(p[0] >= 1 && p[0] <= 3 && p[1] >= -1 && p[1] <= 5);
    return p[2] - 7;
}

TEST(elementary_surfaces_become_exact_splines)
{
    check_surface("270 1 0 0\n3\n1.5\n1.5 0 0\n0 0 1\n1.5 0 0\n", sphere);
    check_surface("270 1 0 0\n3\n1.5\n1.5 0 0\n0 0 1\n1 0 0\n0.1 2 -1 1.2\n0\n", sphere);
    check_surface("260 1 0 0\n3\n2\n0 0 0\n0 0 2\n1 0 0\n1\n0 3.141592653589793\n-1 4\n0\n",
                  cylinder);
    check_surface("280 1 0 0\n3\n1\n0 0 0\n0 0 1\n1 0 0\n0.4636476090008061\n1\n0 6\n0 2\n0\n",
                  cone);
    check_surface("290 1 0 0\n3\n3\n1\n0 0 0\n0 0 1\n0 1 0\n1\n", torus);
    check_surface("250 1 0 0\n3\n0 0 7\n0 0 1\n1 0 0\n1\n1 3\n-1 5\n0\n", plane);
}

TEST(swapped_parameters_turn_the_normal)
{
    batten_model *model = read_good("250 1 0 0\n3\n0 0 7\n0 0 1\n1 0 0\n1\n1 3\n-1 5\n1\n");
    batten_vec3 n;
    CHECK_OK(batten_surface_normal(batten_model_object(model, 0)->surface, 0.5, 0.5, NULL, &n));
    CHECK_NEAR(n.z, -1, 1e-15);
    batten_model_unref(model);
}

static const char trimmed[] =
    "210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n"
    "0 0 1\n4 0 1\n0 4 1\n4 4 1\n"
    "1\n3 1e-6\n"
    "1 100 0\n2 0\n2 2\n0 0 1 1\n1 1\n3 1\n"
    "1 1 100\n2 0\n2 2\n0 0 1 1\n3 1\n2 3\n3 0\n2 2\n0 0 1 1\n3 1 1\n2 3 1\n"
    "0 0 120\n3\n2 3 1\n-1 -2 0\n1\n0 1\n0\n";

TEST(bounded_surfaces_become_faces)
{
    /* Made exactly from the parameters a curve in space is not worth a note. */
    batten_model *model = read_noting(trimmed, BATTEN_FORMAT_AUTO, "");
    const batten_object *object = batten_model_object(model, 0);
    CHECK(object->kind == BATTEN_OBJECT_BODY);
    const batten_body_parts *parts = batten_body_view(object->body);
    CHECK_INT(parts->face_count, 1);
    CHECK_INT(parts->edge_count, 3);
    CHECK_INT(parts->vertex_count, 3);
    CHECK_BITS(parts->tolerance, 1e-6);
    CHECK(parts->uses[0].parameters && parts->uses[1].parameters && !parts->uses[2].parameters);
    /* The first has no form in space: it is made from the parameters. */
    double p[3];
    CHECK_OK(batten_curve_evaluate(parts->edges[0].curve, 0.5, 0, p));
    CHECK_NEAR(p[0], 2, 1e-15);
    CHECK_NEAR(p[2], 1, 1e-15);
    batten_model_unref(model);
}

TEST(triangles_of_g2_files_are_a_mesh)
{
    batten_model *model = read_good("310 1 0 0\n3 1\n0 0 0\n1 0 0\n0 1 0\n\n3 0 1 2\n");
    const batten_object *object = batten_model_object(model, 0);
    CHECK(object->kind == BATTEN_OBJECT_MESH);
    CHECK_INT(batten_mesh_view(object->mesh)->corners[2], 2);
    batten_model_unref(model);
}

TEST(P4_what_is_not_read_is_counted_and_named)
{
    char text[512];
    snprintf(text, sizeof text, "700 1 0 0\n3 0\n1 2 3 4\n\n%s", parabola);
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_text(text, BATTEN_FORMAT_AUTO, notes, &model), BATTEN_PARTLY_READ);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_object(model, 0)->name, "spline curve 2");
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "objects of this class are not read; left out") &&
              has_note(notes, "0 read, 1 left out"));
    batten_notes_free(notes);
    batten_model_unref(model);
    check_refused("700 1 0 0\n3 0\n", BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED,
                  "its 1 object could not be read: objects of this class are not read");
}

TEST(P2_a_bad_object_is_left_out_and_the_next_is_read)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {HEAD_CURVE "3 0\n3 3\n0 0 1 0 1 1\n0 0 0\n1 2 0\n2 0 0\n", "knot"},
        {HEAD_CURVE "3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 x 0\n2 0 0\n", "coordinates is 'x'"},
        {HEAD_CURVE "3 0\n3 3\n0 0 0 1 1 1\n0 0 0\n1 nan 0\n2 0 0\n", "not a number"},
        {HEAD_CURVE "3 0\n3 99\n", "the order is 99"},
        {HEAD_CURVE "3 0\n-3 3\n", "the number of points is -3"},
        {HEAD_CURVE "3 0\n1000 3\n", "cannot stand in the"},
        {HEAD_CURVE "9 0\n3 3\n", "the dimension is 9"},
        {HEAD_CURVE "3 1\n3 3\n0 0 0 1 1 1\n2 0 0 1\n2 2 0 0\n0 4 0 2\n", "weight 2 is 0"},
        {"120 1 0 0\n3\n0 0 0\n1 0 0\n", "the line has no ends"},
        {"130 1 0 0\n3\n2\n0 0 0\n0 0 1\n0 0 2\n0 1\n0\n", "0 or parallel"},
        {"260 1 0 0\n3\n2\n0 0 0\n0 0 2\n1 0 0\n0\n0 3\n0\n", "the surface has no bounds"},
        {"210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n0 0 1\n4 0 1\n0 4 1\n4 4 1\n1\n1 "
         "1e-6\n"
         "1 0 0\n",
         "neither form"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        char text[1024];
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        snprintf(text, sizeof text, "%s\n%s", cases[i].text, parabola);
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_STATUS(read_text(text, BATTEN_FORMAT_G2, notes, &model), BATTEN_PARTLY_READ);
        CHECK_INT(batten_model_count(model), 1);
        if (!batten_notes_dropped(notes))
            CHECK_CONTAINS(batten_notes_at(notes, 0)->text, cases[i].words);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(S2_counts_that_the_file_cannot_hold_are_refused)
{
    check_refused(HEAD_CURVE "3 0\n1000000000 4\n0 0\n", BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED,
                  "the number of points is 1000000000");
    check_refused("400 1 0 0\n9000000\n0 0\n", BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED,
                  "27000000 coordinates cannot stand in the");
    check_refused("200 1 0 0\n3 0\n4000000 2\n", BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED,
                  "cannot stand in the");
}

TEST(F2_a_file_cut_anywhere_is_refused_or_read_in_part)
{
    const size_t size = strlen(trimmed);
    for (size_t length = 10; length < size - 2; length++) {
        batten_model *model = NULL;
        const batten_status status =
            read_bytes(trimmed, length, BATTEN_FORMAT_G2, NULL, &model);
        /* The last mark of a line may be missing: then nothing is. */
        CHECK(status != BATTEN_OK);
        batten_model_unref(model);
    }
}

TEST(words_after_an_object_that_belong_to_none_are_noted)
{
    char text[256];
    snprintf(text, sizeof text, "%s 17 4\n", parabola);
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_STATUS(read_text(text, BATTEN_FORMAT_G2, notes, &model), BATTEN_PARTLY_READ);
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "words after its end that belong to no object: 2"));
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* ---- writing ---- */

static void check_round_trip(const batten_model *model)
{
    char *first = NULL, *second = NULL;
    size_t size = 0, again = 0;
    batten_model *back = NULL;
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_G2, &first, &size));
    CHECK_OK(read_bytes(first, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_OK(write_bytes(back, BATTEN_FORMAT_G2, &second, &again));
    CHECK(size == again && memcmp(first, second, size) == 0);
    CHECK_INT(batten_model_count(back), batten_model_count(model));
    batten_model_unref(back);
    batten_release(first);
    batten_release(second);
}

TEST(what_is_read_is_written_and_the_second_writing_is_the_same)
{
    const char *const texts[] = {parabola, quarter, trimmed,
                                 "400 1 0 4 255 0 51 255\n2\n1 2 3\n4 5 6\n",
                                 "270 1 0 0\n3\n1.5\n1.5 0 0\n0 0 1\n1.5 0 0\n"};
    for (int i = 0; i < COUNT(texts); i++) {
        batten_model *model = read_good(texts[i]);
        check_round_trip(model);
        batten_model_unref(model);
    }
}

TEST(points_and_knots_come_back_bit_for_bit)
{
    test_random random = test_random_begin(__func__);
    double points[24], knots[] = {-0.1, -0.1, -0.1, 1.0 / 3, 0.7, 0.9, 1e9, 1e9, 1e9};
    for (int i = 0; i < 18; i++)
        points[i] = test_random_in(&random, -1, 1) * pow(10, test_random_in(&random, -9, 9));
    batten_curve *curve = NULL;
    batten_model *model = NULL, *back = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_curve_create((batten_points){3, 6, points}, 2, NULL, knots, &curve));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_OK(write_bytes(model, BATTEN_FORMAT_G2, &data, &size));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_G2, NULL, &back));
    const batten_curve *read = batten_model_object(back, 0)->curve;
    for (int i = 0; i < 18; i++)
        CHECK_BITS(batten_curve_points(read)[i], points[i]);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(batten_curve_knots(read)[i], knots[i]);
    batten_release(data);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

/* The file has products w x. Most x come back bit for bit; the others are counted in a note. */
TEST(rational_points_come_back_to_the_last_place)
{
    test_random random = test_random_begin(__func__);
    const double knots[] = {0, 0, 1, 1};
    int same = 0, all = 0;
    for (int i = 0; i < test_cases(50); i++) {
        double points[6], weights[2];
        for (int k = 0; k < 6; k++)
            points[k] = test_random_in(&random, -3, 3);
        for (int k = 0; k < 2; k++)
            weights[k] = test_random_in(&random, 0.1, 5);
        batten_curve *curve = NULL;
        batten_model *model = NULL, *back = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, weights, knots, &curve));
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_model_add(
            model, &(batten_object){.name = "c", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
        CHECK_OK(write_bytes(model, BATTEN_FORMAT_G2, &data, &size));
        CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_G2, NULL, &back));
        const batten_curve *read = batten_model_object(back, 0)->curve;
        for (int k = 0; k < 6; k++, all++) {
            const double x = batten_curve_points(read)[k];
            CHECK_NEAR(x, points[k], 2.3e-16 * fabs(points[k]));
            same += x == points[k];
        }
        for (int k = 0; k < 2; k++)
            CHECK_BITS(batten_curve_weights(read)[k], weights[k]);
        check_round_trip(back);
        batten_release(data);
        batten_model_unref(back);
        batten_model_unref(model);
        batten_curve_unref(curve);
    }
    CHECK(same > all / 2);
}

TEST(bodies_are_written_face_by_face_and_that_is_said)
{
    batten_body *body = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    batten_model *model = NULL, *back = NULL;
    batten_notes *notes = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_G2;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "box", .kind = BATTEN_OBJECT_BODY, .body = body}));
    CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
    if (!batten_notes_dropped(notes))
        CHECK(has_note(notes, "6 faces are written one by one"));
    CHECK_OK(read_bytes(data, size, BATTEN_FORMAT_AUTO, NULL, &back));
    CHECK_INT(batten_model_count(back), 6);
    CHECK_INT(batten_body_view(batten_model_object(back, 5)->body)->edge_count, 4);
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(back);
    batten_model_unref(model);
    batten_body_unref(body);
}

/* ---- files of others ---- */

TEST(published_g2_files_have_the_objects_that_they_should)
{
    static const struct {
        const char *name;
        int curves, surfaces, bodies, points, meshes;
        batten_status status;
    } files[] = {
        {"BoundedSurface", 0, 0, 1, 0, 0, BATTEN_OK},
        {"bilinear", 0, 1, 0, 0, 0, BATTEN_OK},
        {"bump", 0, 0, 0, 0, 1, BATTEN_OK},
        {"cone_sf", 0, 1, 0, 0, 0, BATTEN_OK},
        {"cv1", 1, 0, 0, 0, 0, BATTEN_OK},
        {"cv2", 1, 0, 0, 0, 0, BATTEN_OK},
        {"cv3", 1, 0, 0, 0, 0, BATTEN_OK},
        {"degenerate_sf", 0, 1, 0, 0, 0, BATTEN_OK},
        {"degenerate_triangle", 0, 1, 0, 0, 0, BATTEN_OK},
        {"ellipse", 1, 0, 0, 0, 0, BATTEN_OK},
        {"line_cloud", 3, 0, 0, 0, 0, BATTEN_OK},
        {"midship_deck", 0, 0, 0, 0, 0, BATTEN_UNSUPPORTED}, /* a volume */
        {"midship_hull", 0, 0, 0, 0, 0, BATTEN_UNSUPPORTED},
        {"midship_section_curves", 2, 0, 0, 0, 0, BATTEN_OK},
        {"octant", 0, 1, 0, 0, 0, BATTEN_OK},
        {"point_sequence", 0, 0, 0, 1, 0, BATTEN_OK},
        {"rational_spline_cv_1", 1, 0, 0, 0, 0, BATTEN_OK},
        {"rational_spline_cv_2", 1, 0, 0, 0, 0, BATTEN_OK},
        {"sf_with_holes", 0, 0, 1, 0, 0, BATTEN_OK},
        {"sphere", 0, 1, 0, 0, 0, BATTEN_OK},
        {"spline_curve_1", 1, 0, 0, 0, 0, BATTEN_OK},
        {"spline_curve_2", 1, 0, 0, 0, 0, BATTEN_OK},
        {"spline_curve_3", 1, 0, 0, 0, 0, BATTEN_OK},
        {"spline_curve_4", 1, 0, 0, 0, 0, BATTEN_OK},
        {"spline_sfs1", 0, 8, 0, 0, 0, BATTEN_OK},
        {"spline_surface_1", 0, 1, 0, 0, 0, BATTEN_OK},
        {"squarecubic", 0, 1, 0, 0, 0, BATTEN_OK},
        {"surf_rev", 0, 1, 0, 0, 0, BATTEN_OK},
        {"surface", 0, 1, 0, 0, 0, BATTEN_OK},
        {"test_bezier", 0, 1, 0, 0, 0, BATTEN_OK},
        {"test_bounded_sf_1", 0, 0, 1, 0, 0, BATTEN_OK},
        {"test_smoothcurve", 1, 0, 0, 1, 0, BATTEN_OK},
        {"test_smoothcurve_pts", 0, 0, 0, 1, 0, BATTEN_OK},
        {"testcurve", 1, 0, 0, 0, 0, BATTEN_OK},
        {"testcurve3", 1, 0, 0, 0, 0, BATTEN_OK},
        {"trimmed_parts", 0, 0, 11, 0, 0, BATTEN_OK},
        {"trimmed_sfs", 0, 0, 8, 0, 0, BATTEN_OK},
    };
    for (int i = 0; i < COUNT(files); i++) {
        char path[64];
        int counts[8] = {0};
        batten_model *model = NULL;
        snprintf(path, sizeof path, "g2/%s.g2", files[i].name);
        CHECK_STATUS(batten_read_file(test_data(path), NULL, NULL, NULL, &model),
                     files[i].status);
        for (int k = 0; model && k < batten_model_count(model); k++)
            counts[batten_model_object(model, k)->kind]++;
        CHECK_INT(counts[BATTEN_OBJECT_CURVE], files[i].curves);
        CHECK_INT(counts[BATTEN_OBJECT_SURFACE], files[i].surfaces);
        CHECK_INT(counts[BATTEN_OBJECT_BODY], files[i].bodies);
        CHECK_INT(counts[BATTEN_OBJECT_POINTS], files[i].points);
        CHECK_INT(counts[BATTEN_OBJECT_MESH], files[i].meshes);
        batten_model_unref(model);
    }
}
