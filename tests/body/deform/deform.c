/* Bodies under deformations: whole, closed, and of the volume that the map leaves them. */
#include "body/by_hand.h"
#include "support/bodies.h"
#include "support/lattices.h"

#include <batten/standard.h>

TEST(a_box_under_a_shear_keeps_its_volume_and_stays_a_solid)
{
    batten_lattice l;
    double points[3 * 27], error = -1;
    batten_deformation *d = NULL;
    batten_body *given = test_box((batten_vec3){-0.5, 0.1, -2}, (batten_vec3){1, 0.9, 2}),
                *made = NULL;
    test_lattice_sheared(0.1, &l, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_body_deform(given, d, 1e-6, NULL, &error, &made));
    CHECK(error >= 0 && error <= 1e-6);
    batten_body_measures m;
    batten_body_faults faults;
    CHECK_OK(batten_body_measure(made, 1e-9, NULL, &m));
    CHECK(m.is_closed);
    CHECK_NEAR(m.volume, 1.5 * 0.8 * 4, 1e-7);
    /* x moves by 0.1 z (z + 2): its mean over z from -2 to 2 is 0.1 * 4 / 3. */
    CHECK_NEAR(m.centroid[0], 0.25 + 0.4 / 3, 1e-7);
    CHECK_NEAR(m.centroid[1], 0.5, 1e-7);
    CHECK_OK(batten_body_check(made, 1e-6, NULL, NULL, &faults));
    CHECK(faults.free_edges == 0 && faults.wrong_edges == 0 && faults.loose == 0 &&
          faults.gaps == 0 && faults.open_shells == 0 && faults.turned_shells == 0);
    CHECK(batten_body_view(made)->is_solid);
    CHECK_INT(batten_body_view(made)->face_count, batten_body_view(given)->face_count);
    batten_body_unref(made);
    batten_body_unref(given);
    batten_deformation_unref(d);
}

TEST(any_smooth_map_of_a_box_stays_closed_within_its_tolerance)
{
    const batten_lattice l = test_lattice(6, 3);
    test_random random = test_random_begin("bodies");
    batten_body *given = test_box((batten_vec3){-0.5, 0.1, -1}, (batten_vec3){1, 0.9, 1});
    for (int trial = 0; trial < 4; trial++) {
        double points[3 * LATTICE_MOST];
        batten_deformation *d = NULL;
        batten_body *made = NULL;
        batten_body_measures m;
        batten_body_faults faults;
        test_lattice_shaken(&random, &l, 0.05, 0, points);
        CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
        CHECK_OK(batten_body_deform(given, d, 1e-4, NULL, NULL, &made));
        CHECK_OK(batten_body_measure(made, 1e-6, NULL, &m));
        CHECK(m.is_closed && m.volume > 1 && m.volume < 6);
        CHECK_OK(
            batten_body_check(made, batten_body_view(made)->tolerance, NULL, NULL, &faults));
        CHECK(faults.free_edges == 0 && faults.loose == 0 && faults.gaps == 0);
        batten_body_unref(made);
        batten_deformation_unref(d);
    }
    batten_body_unref(given);
}

TEST(bodies_that_cannot_be_deformed_are_refused)
{
    const batten_lattice l = test_lattice(2, 1);
    double points[3 * 8];
    batten_deformation *d = NULL;
    batten_body *given = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 1}), *none = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_STATUS(batten_body_deform(given, d, 1e-3, NULL, NULL, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("out of the box where y is largest");
    static const double tolerances[] = {-1, INFINITY, NAN, 0};
    for (int i = 0; i < COUNT(tolerances); i++)
        CHECK_STATUS(batten_body_deform(given, d, tolerances[i], NULL, NULL, &none),
                     BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    CHECK(none == NULL);
    batten_body_unref(given);
    batten_deformation_unref(d);
}

/* The map that leaves all as it is. */
static batten_deformation *same(void)
{
    const batten_lattice l = test_lattice(2, 1);
    double points[3 * 8];
    batten_deformation *d = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    return d;
}

/* A square of 0.5 on a plane of 20 by 20, which leaves the box of the lattice far behind. */
static batten_body *small_plate(void)
{
    hand m = hand_begin();
    batten_body *body = NULL;
    batten_surface *plane = NULL;
    const batten_vec3 corners[4] = {{-10, -10, 0}, {10, -10, 0}, {-10, 10, 0}, {10, 10, 0}};
    hand_line(&m, 0.5, 0.25, 0, 1, 0.25, 0);
    hand_line(&m, 1, 0.25, 0, 1, 0.75, 0);
    hand_line(&m, 1, 0.75, 0, 0.5, 0.75, 0);
    hand_line(&m, 0.5, 0.75, 0, 0.5, 0.25, 0);
    CHECK_OK(batten_surface_bilinear(corners[0], corners[1], corners[2], corners[3], &plane));
    CHECK_OK(bat_builder_face(&m.builder, &(batten_body_face){.name = "lid",
                                                              .has_colour = true,
                                                              .colour = {0.25, 0.5, 0.75},
                                                              .surface = plane,
                                                              .reversed = true}));
    batten_surface_unref(plane);
    HAND_LOOP(&m, -4, -3, -2, -1);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    return body;
}

TEST(of_a_surface_only_what_its_face_reaches_is_deformed)
{
    batten_deformation *d = same();
    batten_body *given = small_plate(), *made = NULL, *traced = NULL, *again = NULL;
    double error = -1;
    CHECK_OK(batten_body_deform(given, d, 1e-4, NULL, &error, &made));
    CHECK_NEAR(error, 0, 1e-12);
    CHECK_NEAR(hand_area(made), 0.25, 1e-12);
    const batten_body_parts *parts = batten_body_view(made);
    CHECK_INT(parts->face_count, 1);
    const batten_body_face *face = &parts->faces[0];
    const batten_box box = batten_surface_box(face->surface);
    CHECK(box.low.x >= 0.49 && box.high.x <= 1.01 && box.low.y >= 0.24 && box.high.y <= 0.76);
    CHECK_TEXT(face->name, "lid");
    CHECK(face->has_colour && face->reversed);
    CHECK_NEAR(face->colour[2], 0.75, 0);
    CHECK_INT(parts->edge_count, 4);
    CHECK_INT(parts->vertex_count, 4);
    CHECK(!parts->is_solid && !parts->shells[0].closed);
    CHECK_NEAR(parts->tolerance, 1e-6 + 2e-4, 1e-15); /* its own, and twice that of the call */
    /* What is traced already is taken as it is. */
    CHECK_OK(batten_body_trace(given, 1e-6, NULL, NULL, NULL, &traced));
    CHECK_OK(batten_body_deform(traced, d, 1e-4, NULL, NULL, &again));
    CHECK_NEAR(hand_area(again), 0.25, 1e-12);
    batten_body_unref(again);
    batten_body_unref(traced);
    batten_body_unref(made);
    batten_body_unref(given);
    batten_deformation_unref(d);
}

/* Its poles are edges without a curve, its seam one with two uses. */
TEST(a_ball_under_a_shear_keeps_its_volume)
{
    const double pi = 3.14159265358979323846, size = 0.4;
    batten_frame frame = batten_frame_world();
    batten_lattice l;
    double points[3 * 27], error = -1;
    batten_deformation *d = NULL;
    batten_body *given = NULL, *made = NULL;
    batten_surface *ball = NULL;
    batten_body_measures measures;
    hand m = hand_begin();
    frame.origin = (batten_vec3){0.3, 0.5, 0.2};
    CHECK_OK(batten_surface_sphere(&frame, size, &ball));
    hand_face(&m, ball, false);
    CHECK_OK(batten_body_create(&m.builder.parts, &given));
    bat_builder_end(&m.builder);
    test_lattice_sheared(0.1, &l, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_body_deform(given, d, 1e-6, NULL, &error, &made));
    CHECK(error > 0 && error <= 1e-6);
    CHECK_OK(batten_body_measure(made, 1e-8, NULL, &measures));
    CHECK(measures.is_closed);
    CHECK_NEAR(measures.volume, 4 * pi / 3 * size * size * size, 1e-5);
    /* x moves by 0.1 z (z + 2), whose mean is that of z^2 = 0.04 + r^2 / 5 and of 2 z = 0.4 */
    CHECK_NEAR(measures.centroid[0], 0.3 + 0.1 * (0.04 + size * size / 5 + 0.4), 1e-5);
    CHECK_NEAR(measures.centroid[1], 0.5, 1e-5);
    CHECK_NEAR(measures.centroid[2], 0.2, 1e-5);
    batten_body_unref(made);
    batten_body_unref(given);
    batten_deformation_unref(d);
}

TEST(a_body_with_edges_off_its_faces_is_refused_with_their_number)
{
    for (int faces = 1; faces <= 2; faces++) {
        hand m = hand_begin();
        batten_deformation *d = same();
        batten_body *given = NULL, *none = NULL;
        for (int k = 0; k < 5; k++)
            hand_arc(&m, 0.4, 0.1 * k, 0, 360);
        for (int k = 0; k < faces; k++) {
            hand_plate(&m, -0.5, -0.5, 0.5, 0.5, -1 - k);
            hand_loop(&m, 1, (const int[]){k + 1});
        }
        CHECK_OK(batten_body_create(&m.builder.parts, &given));
        bat_builder_end(&m.builder);
        CHECK_STATUS(batten_body_deform(given, d, 1e-4, NULL, NULL, &none),
                     BATTEN_NOT_COMPATIBLE);
        CHECK_MESSAGE(faces == 1 ? "1 face of the body cannot be traced"
                                 : "2 faces of the body cannot be traced");
        CHECK(!none);
        batten_body_unref(given);
        batten_deformation_unref(d);
    }
}
