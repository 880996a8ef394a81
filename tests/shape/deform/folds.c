/* Folds of deformations: what is proved holds at samples, and what folds does so where it is said. */
#include "shape/deform/lattice.h"
#include "support/faults.h"
#include "support/lattices.h"

static double determinant_at(const batten_deformation *d, const double p[3])
{
    double m[3][3];
    bat_deformation_jacobian(d, p, m);
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(bounds_hold_at_samples_and_folds_are_where_they_are_said_to_be)
{
    static const struct {
        int count, degree;
    } kinds[] = {{2, 1}, {4, 3}, {6, 3}, {5, 2}};
    test_random random = test_random_begin("folds");
    int verdicts[3] = {0};
    for (int trial = 0; trial < 80; trial++) {
        const batten_lattice l = test_lattice(kinds[trial % 4].count, kinds[trial % 4].degree);
        double points[3 * LATTICE_MOST];
        batten_deformation *d = NULL;
        batten_deformation_report r;
        test_lattice_shaken(&random, &l, 0.02 + 0.015 * trial / 4, 0, points);
        CHECK_OK(batten_deformation_create(&l, points, NULL, &r, &d));
        verdicts[r.folding]++;
        if (r.folding == BATTEN_FOLDS) {
            CHECK(r.least <= 1e-12);
            CHECK_NEAR(determinant_at(d, r.at), r.least, 1e-9);
        } else
            CHECK(r.least >= r.bound);
        for (int i = 0; i < 200 && r.folding == BATTEN_FOLDS_NOWHERE; i++) {
            const double p[3] = {test_random_in(&random, -1, 2), test_random_unit(&random),
                                 test_random_in(&random, -2, 2)};
            CHECK(determinant_at(d, p) >= r.bound);
        }
        batten_deformation_unref(d);
    }
    CHECK(verdicts[BATTEN_FOLDS_NOWHERE] > 10 && verdicts[BATTEN_FOLDS] > 10);
    CHECK(verdicts[BATTEN_FOLDS_UNKNOWN] <= 2);
}

/* The derivative of a Bezier line touches 0 in the middle when its second point goes from 1/3 to 1, its third from 2/3 to
 * 0. */
TEST(a_map_that_just_stands_still_is_a_fold_and_one_before_it_is_not)
{
    batten_lattice l = {
        .box = {{0, 0, 0}, {1, 1, 1}}, .counts = {4, 2, 2}, .degrees = {3, 1, 1}};
    static const double shares[] = {0.999, 1, 1.001};
    for (int k = 0; k < COUNT(shares); k++) {
        double points[3 * 16], q[3];
        batten_deformation *d = NULL;
        batten_deformation_report r;
        CHECK_OK(batten_lattice_home(&l, points));
        for (int i = 0; i < 4; i++) {
            points[3 * (4 + i)] += 2.0 / 3 * shares[k];
            points[3 * (8 + i)] -= 2.0 / 3 * shares[k];
        }
        CHECK_OK(batten_deformation_create(&l, points, NULL, &r, &d));
        CHECK_INT(r.folding, k ? BATTEN_FOLDS : BATTEN_FOLDS_NOWHERE);
        const double middle[3] = {0.5, 0.5, 0.5};
        CHECK_NEAR(determinant_at(d, middle), 1 - shares[k], 1e-12);
        CHECK_STATUS(batten_deformation_apply(d, (batten_points){3, 1, middle}, q),
                     k ? BATTEN_SINGULAR_HERE : BATTEN_OK);
        if (k)
            CHECK_MESSAGE("the deformation folds: near (0.5, ");
        batten_deformation_unref(d);
    }
}

TEST(a_search_that_may_not_halve_says_that_it_does_not_know)
{
    /* Volumes with the coefficients 2.5, -2.15 and 1.9: at least 0.1275 / 8.7, of one sign after some halvings. */
    batten_lattice l = {
        .box = {{0, 0, 0}, {1, 1, 1}}, .counts = {4, 2, 2}, .degrees = {3, 1, 1}};
    double points[3 * 16];
    batten_deformation *d = NULL;
    batten_deformation_report r;
    batten_deformation_options options = batten_deformation_defaults();
    CHECK_OK(batten_lattice_home(&l, points));
    for (int i = 0; i < 4; i++) {
        points[3 * (4 + i)] += 0.5;
        points[3 * (8 + i)] -= 0.55;
        points[3 * (12 + i)] -= 0.25;
    }
    CHECK_EACH_ALLOCATION(batten_deformation_create(&l, points, &options, &r, &d));
    CHECK_INT(r.folding, BATTEN_FOLDS_NOWHERE);
    CHECK(r.bound > 0 && r.bound <= 0.1275 / 8.7);
    batten_deformation_unref(d);
    options.most_parts = 1;
    CHECK_OK(batten_deformation_create(&l, points, &options, &r, &d));
    CHECK_INT(r.folding, BATTEN_FOLDS_UNKNOWN);
    CHECK(r.bound <= 0 && r.least > 0);
    batten_deformation_unref(d);
}
