#include "exchange/shapes/path.h"

#include "exchange/shapes/paths.h"

static batten_curve *curve_of(bat_vertex *vertices, int count, bool closed)
{
    const bat_path path = {
        .count = count, .closed = closed, .vertices = vertices, .frame = batten_frame_world()};
    batten_curve *curve = NULL;
    CHECK_OK(bat_path_curve(&path, &curve));
    return curve;
}

TEST(an_arc_of_any_bulge_stays_on_its_circle_and_sweeps_four_times_its_arctangent)
{
    static const double bulges[] = {1, -1, 0.41421356237309503, -0.3, 0.01, 0.7, -0.9};
    for (int n = 0; n < COUNT(bulges); n++) {
        const double b = bulges[n];
        bat_vertex vertices[] = {{3, 1, b}, {-1, 4, 0}};
        batten_curve *curve = curve_of(vertices, 2, false);
        /* The chord is 5; its middle is (1, 2.5); the left of it is (-3, -4) / 5. */
        const double radius = 5 * (1 + b * b) / (4 * fabs(b)), left = 5 * (1 - b * b) / (4 * b);
        const double cx = 1 - left * 0.6, cy = 2.5 - left * 0.8;
        double last[3], sweep = 0, angle = 0;
        const batten_interval domain = batten_curve_domain(curve);
        CHECK_BITS(domain.a, 0);
        CHECK_NEAR(domain.b, 4 * fabs(atan(b)) * radius, 1e-12);
        for (int i = 0; i <= 100; i++) {
            double p[3];
            CHECK_OK(
                batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 100, 0, p));
            CHECK_NEAR(hypot(p[0] - cx, p[1] - cy), radius, 1e-13 * radius + 1e-13);
            CHECK_BITS(p[2], 0);
            const double now = atan2(p[1] - cy, p[0] - cx);
            if (i > 0)
                sweep += remainder(now - angle, 6.283185307179586);
            angle = now;
            memcpy(last, p, sizeof last);
        }
        CHECK_NEAR(sweep, 4 * atan(b), 1e-9);
        CHECK_NEAR(last[0], -1, 1e-14);
        CHECK_NEAR(last[1], 4, 1e-14);
        CHECK_INT(batten_curve_degree(curve), 2);
        batten_curve_unref(curve);
    }
}

TEST(a_quarter_turn_is_one_piece_and_more_is_two)
{
    static const struct {
        double bulge;
        int points;
    } cases[] = {
        {0.41421356237309503, 3}, {0.41421356237309510, 3}, {0.4143, 5}, {1, 5}, {0.2, 3}};
    for (int i = 0; i < COUNT(cases); i++) {
        bat_vertex vertices[] = {{0, 0, cases[i].bulge}, {1, 0, 0}};
        batten_curve *curve = curve_of(vertices, 2, false);
        CHECK_INT(batten_curve_point_count(curve), cases[i].points);
        batten_curve_unref(curve);
    }
}

TEST(lines_alone_are_a_polyline_measured_by_chords)
{
    bat_vertex vertices[] = {{0, 0, 0}, {3, 4, 0}, {3, 16, 0}};
    static const double due[][3] = {{0, 0, 0}, {3, 4, 0}, {3, 16, 0}, {0, 0, 0}};
    for (int closed = 0; closed < 2; closed++) {
        batten_curve *curve = curve_of(vertices, 3, closed);
        CHECK_INT(batten_curve_degree(curve), 1);
        CHECK_INT(batten_curve_dimension(curve), 3);
        CHECK(batten_curve_weights(curve) == NULL);
        CHECK_INT(batten_curve_point_count(curve), 3 + closed);
        for (int i = 0; i < 3 + closed; i++)
            for (int k = 0; k < 3; k++)
                CHECK_BITS(batten_curve_points(curve)[3 * i + k], due[i][k]);
        batten_curve_unref(curve);
    }
}

TEST(a_line_among_arcs_keeps_its_length_and_is_straight)
{
    bat_vertex vertices[] = {{0, 0, 0}, {80, 0, 1}, {80, 20, 0}, {0, 20, 1}};
    batten_curve *curve = curve_of(vertices, 4, true);
    const batten_interval domain = batten_curve_domain(curve);
    CHECK_NEAR(domain.b, 160 + 20 * 3.141592653589793, 1e-12);
    for (int i = 0; i <= 16; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(curve, 80 * i / 16.0, 0, p));
        CHECK_NEAR(p[0], 80 * i / 16.0, 1e-13);
        CHECK_NEAR(p[1], 0, 1e-13);
    }
    double end[3];
    CHECK_OK(batten_curve_evaluate(curve, domain.b, 0, end));
    CHECK_BITS(end[0], 0);
    CHECK_BITS(end[1], 0);
    CHECK(!batten_curve_is_rational(curve) || batten_curve_weights(curve)[1] == 1);
    batten_curve_unref(curve);
}

TEST(a_path_lies_in_the_plane_of_its_frame)
{
    bat_vertex vertices[] = {{1, 2, 0}, {4, 6, 0}};
    const bat_path path = {.count = 2,
                           .vertices = vertices,
                           .frame = {.origin = {10, 20, 30}, .x = {0, 1, 0}, .z = {1, 0, 0}}};
    batten_curve *curve = NULL;
    CHECK_OK(bat_path_curve(&path, &curve)); /* its y axis is z x x = (0, 0, 1) */
    static const double due[] = {10, 21, 32, 10, 24, 36};
    for (int i = 0; i < 6; i++)
        CHECK_BITS(batten_curve_points(curve)[i], due[i]);
    batten_curve_unref(curve);
}

TEST(a_path_of_one_point_or_of_two_in_one_place_is_refused)
{
    bat_vertex vertices[] = {{0, 0, 0}, {5, 0, 1}, {5, 0, 0}, {5, 7, 0}, {0, 0, 0}};
    const bat_path point = {.count = 1, .vertices = vertices, .frame = batten_frame_world()};
    const bat_path nothing = {
        .count = 0, .closed = true, .vertices = vertices, .frame = batten_frame_world()};
    const bat_path twice = {.count = 4, .vertices = vertices, .frame = batten_frame_world()};
    const bat_path closed = {
        .count = 3, .closed = true, .vertices = vertices + 2, .frame = batten_frame_world()};
    batten_curve *curve = NULL;
    CHECK_STATUS(bat_path_curve(&point, &curve), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("a path of 1 point");
    CHECK_STATUS(bat_path_curve(&nothing, &curve), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("a path of 0 points");
    CHECK_STATUS(bat_path_curve(&twice, &curve), BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 of a path are one");
    vertices[4] = vertices[2];
    CHECK_STATUS(bat_path_curve(&closed, &curve), BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 3 and 1 of a path are one");
    CHECK(curve == NULL);
}

TEST(a_chain_as_a_path_and_back_is_the_same_curve)
{
    batten_chain *chains[] = {stadium(), hook()};
    for (int n = 0; n < 2; n++) {
        batten_model *model = model_of("c", chains[n]);
        const batten_object *object = batten_model_object(model, 0);
        bool is_path = false;
        bat_path path;
        batten_curve *curve = NULL;
        CHECK_OK(bat_path_of(object, &is_path, &path));
        CHECK_OK(bat_path_curve(&path, &curve));
        double length = 0;
        for (int i = 0; i < batten_chain_span_count(object->chain); i++)
            length += batten_chain_span(object->chain, i)->length;
        CHECK_NEAR(batten_curve_domain(curve).b, length, 1e-12 * length);
        for (int i = 0; i < path.count; i++) {
            double nearest = 1e9;
            for (int k = 0; k < batten_curve_point_count(curve); k++) {
                const double *p = batten_curve_points(curve) + 3 * k;
                nearest =
                    fmin(nearest, hypot(p[0] - path.vertices[i].x, p[1] - path.vertices[i].y));
            }
            CHECK_NEAR(nearest, 0, 1e-13);
        }
        batten_curve_unref(curve);
        bat_path_release(&path);
        CHECK(path.count == 0 && !path.closed && path.vertices == NULL);
        batten_model_unref(model);
    }
}

TEST(missing_memory_on_the_way_from_a_chain_to_a_curve_is_reported)
{
    if (test_cases(1000) < 1000)
        SKIP("the allocations are those of other tests");
    batten_model *models[] = {model_of("c", stadium()), model_of_curve(filleted(1, 0), "r"),
                              NULL};
    static const double corners[] = {0, 0, 1, 3, 0, 1, 3, 4, 1};
    batten_curve *polyline = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, corners}, &polyline));
    models[2] = model_of_curve(polyline, "p");
    for (int n = 0; n < 3; n++) {
        bool ends = false;
        for (long at = 1; !ends; at++) {
            bool is_path = false;
            bat_path path = {.count = 0};
            batten_curve *curve = NULL;
            test_fail_allocation(at);
            batten_status status =
                bat_path_of(batten_model_object(models[n], 0), &is_path, &path);
            if (status == BATTEN_OK) {
                CHECK(is_path);
                status = bat_path_curve(&path, &curve);
            }
            ends = test_allocations() < at;
            test_fail_allocation(0);
            CHECK((status == BATTEN_OK) == ends);
            CHECK(ends || status == BATTEN_OUT_OF_MEMORY);
            CHECK((curve != NULL) == ends);
            batten_curve_unref(curve);
            bat_path_release(&path);
        }
        batten_model_unref(models[n]);
    }
}
