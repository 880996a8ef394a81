/* Bodies under deformations: whole, closed, and of the volume that the map leaves them. */
#include "support/bodies.h"
#include "support/lattices.h"

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
    CHECK_STATUS(batten_body_deform(given, d, 0, NULL, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_body_unref(given);
    batten_deformation_unref(d);
}
