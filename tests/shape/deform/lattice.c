/* Lattices: at rest, affine, with sides that are left, and those that cannot be. */
#include "support/faults.h"
#include "support/lattices.h"

#include <string.h>

static const struct {
    int count, degree;
} kinds[] = {{2, 1}, {5, 1}, {3, 2}, {6, 2}, {4, 3}, {8, 3}, {7, 6}};

static void shift_by(const double m[3][3], const double *p, double *out)
{
    for (int i = 0; i < 3; i++)
        out[i] = 0.25 * (i + 1) + m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2];
}

TEST(a_lattice_at_home_moves_nothing)
{
    double points[3 * LATTICE_MOST];
    test_random random = test_random_begin("home");
    for (int k = 0; k < COUNT(kinds); k++) {
        const batten_lattice l = test_lattice(kinds[k].count, kinds[k].degree);
        batten_deformation *d = NULL;
        batten_deformation_report report;
        CHECK_OK(batten_lattice_home(&l, points));
        CHECK_OK(batten_deformation_create(&l, points, NULL, &report, &d));
        CHECK(report.folding == BATTEN_FOLDS_NOWHERE && report.bound == 1 && report.moved == 0);
        for (int i = 0; i < 20; i++) {
            const double p[3] = {test_random_in(&random, -1, 2), test_random_unit(&random),
                                 test_random_in(&random, -2, 2)};
            double q[3];
            CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, p}, q));
            CHECK(memcmp(p, q, sizeof p) == 0);
        }
        batten_deformation_unref(d);
    }
}

TEST(an_affine_lattice_is_the_affine_map_and_its_determinant_is_the_bound)
{
    static const double m[3][3] = {{1.5, 0.2, -0.1}, {0.1, 0.8, 0.3}, {-0.2, 0.1, 1.2}};
    const double determinant = 1.5 * (0.8 * 1.2 - 0.3 * 0.1) - 0.2 * (0.1 * 1.2 + 0.3 * 0.2) -
                               0.1 * (0.1 * 0.1 + 0.8 * 0.2);
    double points[3 * LATTICE_MOST], home[3 * LATTICE_MOST];
    test_random random = test_random_begin("affine");
    for (int k = 0; k < COUNT(kinds); k++) {
        const batten_lattice l = test_lattice(kinds[k].count, kinds[k].degree);
        batten_deformation *d = NULL;
        batten_deformation_report report;
        CHECK_OK(batten_lattice_home(&l, home));
        for (int i = 0; i < test_lattice_size(&l); i++)
            shift_by(m, home + 3 * i, points + 3 * i);
        CHECK_OK(batten_deformation_create(&l, points, NULL, &report, &d));
        CHECK_INT(report.folding, BATTEN_FOLDS_NOWHERE);
        CHECK_NEAR(report.bound, determinant, 1e-9);
        CHECK(report.bound <= determinant);
        for (int i = 0; i < 20; i++) {
            const double p[3] = {test_random_in(&random, -1, 2), test_random_unit(&random),
                                 test_random_in(&random, -2, 2)};
            double q[3], truth[3];
            shift_by(m, p, truth);
            CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, p}, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c], truth[c], 1e-14);
        }
        batten_deformation_unref(d);
    }
}

TEST(one_moved_point_of_a_bezier_lattice_acts_by_its_bernstein_polynomials)
{
    const batten_lattice l = test_lattice(4, 3);
    double points[3 * 64], q[3];
    batten_deformation *d = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    points[3 * (16 * 1 + 4 * 2 + 3) + 1] += 0.2;
    CHECK_EACH_ALLOCATION(batten_deformation_create(&l, points, NULL, NULL, &d));
    const double p[3] = {-1 + 3 * 0.3, 0.6, -2 + 4 * 0.9};
    const double share = 3 * 0.3 * 0.7 * 0.7 * (3 * 0.6 * 0.6 * 0.4) * (0.9 * 0.9 * 0.9);
    CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, p}, q));
    CHECK_NEAR(q[0], p[0], 0);
    CHECK_NEAR(q[1], p[1] + 0.2 * share, 1e-15);
    CHECK_NEAR(q[2], p[2], 0);
    batten_deformation_unref(d);
}

/* Across a side with j + 1 layers that stay, differences over h of what is moved fall as h^(j + 1). */
TEST(what_is_outside_stays_and_joins_with_the_continuity_that_was_asked_for)
{
    const batten_lattice l = test_lattice(8, 3);
    double points[3 * LATTICE_MOST];
    test_random random = test_random_begin("join");
    for (int join = BATTEN_BOX_JOIN_POSITION; join < BATTEN_BOX_JOIN_COUNT; join++) {
        batten_deformation_options options = batten_deformation_defaults();
        batten_deformation *d = NULL;
        options.join = (batten_box_join)join;
        test_lattice_shaken(&random, &l, 0.05, join, points);
        CHECK_OK(batten_deformation_create(&l, points, &options, NULL, &d));
        double moved[2];
        for (int k = 0; k < 2; k++) {
            const double h = k ? 1e-3 : 2e-3, p[6] = {2 - h, 0.4, 0.7, 2 + h, 0.4, 0.7};
            double q[6];
            CHECK_OK(batten_deformation_apply(d, (batten_points){3, 2, p}, q));
            CHECK(memcmp(p + 3, q + 3, 3 * sizeof *p) == 0);
            moved[k] = hypot(hypot(q[0] - p[0], q[1] - p[1]), q[2] - p[2]);
        }
        CHECK(moved[0] > 0);
        CHECK_NEAR(log2(moved[0] / moved[1]), join, 0.02);
        batten_deformation_unref(d);
    }
}

TEST(shapes_that_leave_the_box_as_they_may_not_are_refused)
{
    const batten_lattice l = test_lattice(5, 3);
    double points[3 * 125], q[3];
    const double outside[3] = {2.5, 0.5, 0};
    batten_deformation_options options = batten_deformation_defaults();
    batten_deformation *d = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    points[3 * (25 * 3 + 5 * 2 + 2)] += 0.1; /* in the second layer from the side x = 2 */
    CHECK_OK(batten_deformation_create(&l, points, &options, NULL, &d));
    CHECK_STATUS(batten_deformation_apply(d, (batten_points){3, 1, outside}, q),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("point 1 reaches 0.5 out of the box where x is largest");
    batten_deformation_unref(d);
    options.join = BATTEN_BOX_JOIN_TANGENT;
    d = NULL;
    CHECK_OK(batten_deformation_create(&l, points, &options, NULL, &d));
    CHECK_STATUS(batten_deformation_apply(d, (batten_points){3, 1, outside}, q),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("layer 4 of the lattice there is moved: 2 layers must stay");
    const double other[3] = {-1.5, 0.5, 0}; /* through the other side all layers stay */
    CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, other}, q));
    CHECK(memcmp(q, other, sizeof q) == 0);
    batten_deformation_unref(d);
}

static const struct {
    batten_lattice lattice;
    batten_status status;
    const char *says;
} wrong[] = {
    {{{{0, 0, 0}, {1, 1, 0}}, {2, 2, 2}, {1, 1, 1}}, BATTEN_BAD_ARGUMENT, "some extent"},
    {{{{0, 0, 0}, {1, -1, 1}}, {2, 2, 2}, {1, 1, 1}}, BATTEN_BAD_ARGUMENT, "from 0 to -1 in y"},
    {{{{0, 0, 0}, {1, 1, INFINITY}}, {2, 2, 2}, {1, 1, 1}}, BATTEN_NOT_FINITE, "inf in z"},
    {{{{0, 0, 0}, {1, 1, 1}}, {1, 2, 2}, {1, 1, 1}}, BATTEN_BAD_ARGUMENT, "1 point in x"},
    {{{{0, 0, 0}, {1, 1, 1}}, {4, 4, 4}, {3, 4, 3}}, BATTEN_BAD_DEGREE, "degree 4 for 4"},
    {{{{0, 0, 0}, {1, 1, 1}}, {4, 4, 12}, {3, 3, 9}}, BATTEN_BAD_DEGREE, "1 to 8 is possible"},
    {{{{0, 0, 0}, {1, 1, 1}}, {400, 400, 400}, {3, 3, 3}}, BATTEN_TOO_LARGE, "lattice points"},
};

TEST(lattices_that_cannot_be_are_refused_with_what_is_wrong)
{
    double points[3 * 8] = {0}, q[3];
    batten_deformation *none = NULL;
    for (int i = 0; i < COUNT(wrong); i++) {
        CHECK_STATUS(batten_lattice_home(&wrong[i].lattice, points), wrong[i].status);
        CHECK_MESSAGE(wrong[i].says);
        CHECK_STATUS(batten_deformation_create(&wrong[i].lattice, points, NULL, NULL, &none),
                     wrong[i].status);
    }
    const batten_lattice l = test_lattice(2, 1);
    batten_deformation_options options = batten_deformation_defaults();
    CHECK_OK(batten_lattice_home(&l, points));
    options.join = BATTEN_BOX_JOIN_COUNT;
    CHECK_STATUS(batten_deformation_create(&l, points, &options, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    options = batten_deformation_defaults();
    options.most_parts = 0;
    CHECK_STATUS(batten_deformation_create(&l, points, &options, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    batten_deformation *d = NULL;
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    const double flat[2] = {0, 0}, lost[3] = {0, NAN, 0};
    CHECK_STATUS(batten_deformation_apply(d, (batten_points){2, 1, flat}, q),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_deformation_apply(d, (batten_points){3, 1, lost}, q),
                 BATTEN_NOT_FINITE);
    points[7] = NAN;
    CHECK_STATUS(batten_deformation_create(&l, points, NULL, NULL, &none), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("lattice point 3");
    CHECK(none == NULL);
    batten_deformation_unref(d);
}
