/* Creases from what is given along them: angles, torsions, widths. */
#include "numeric/vector.h"
#include <batten/plate.h>
#include <batten/standard.h>

#include "support/test.h"

static batten_fold_create_options options_of(const double *angle, double width)
{
    batten_fold_create_options options = batten_fold_create_defaults();
    options.count = 1;
    options.values = angle;
    options.left = options.right = width;
    options.tolerance = 1e-7;
    return options;
}

static batten_curve *arc(double radius, double angle)
{
    const batten_frame world = batten_frame_world();
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_arc_in(&world, radius, 0, angle, &curve));
    return curve;
}

TEST(a_flat_circle_with_torsion_becomes_a_helix)
{
    const double a = 0.5, tau = 0.2, k = 0.5 / cos(a), w2 = k * k + tau * tau;
    batten_fold_create_options options = options_of(&a, 0.1);
    batten_curve *circle = arc(2, 1.5);
    batten_fold fold;
    options.given = BATTEN_FOLD_FLAT;
    options.torsion_count = 1;
    options.torsions = &tau;

    CHECK_OK(batten_fold_create(circle, &options, &fold));
    CHECK_NEAR(fold.length, 3, 1e-9);
    const double *first = fold.points;
    for (int i = 1; i < fold.count; i++) {
        const double s = fold.length * i / (fold.count - 1), turned = sqrt(w2) * s;
        const double across = 2 * k / w2 * sin(turned / 2), along = tau / w2 * turned;
        double chord = 0;
        for (int c = 0; c < 3; c++)
            chord += pow(fold.points[3 * i + c] - first[c], 2);
        CHECK_NEAR(sqrt(chord), hypot(across, along), 1e-8);
        CHECK_NEAR(fold.angles[i], a, 1e-15);
    }
    double D[12];
    CHECK_OK(batten_curve_evaluate(fold.crease, batten_curve_domain(fold.crease).a + 1, 3, D));
    double n[3];
    bat_cross(D + 3, D + 6, n);
    CHECK_NEAR(bat_dot(3, n, D + 9) / bat_dot(3, n, n), tau, 1e-4);
    batten_fold_release(&fold);
    batten_curve_unref(circle);
}

TEST(options_of_folds_out_of_bounds_are_named_with_their_numbers)
{
    const double a = 0.4, values[3] = {0.4, 0.3, HUGE_VAL};
    batten_curve *curve = arc(5, 2);
    const batten_fold_create_options good = options_of(&a, 0.1);
    batten_fold_create_options bad[7];
    static const char *const messages[COUNT(bad)] = {
        "no angles are given along the crease",
        "value 3 along the crease is not finite",
        "there are -1 torsions",
        "the sheets are 0 and 0.1 wide; above 0 is needed",
        "the sheets are 0.1 and -1 wide; above 0 is needed",
        "the tolerance is 0, not above 0",
        "the tolerance is inf, not above 0",
    };
    for (int i = 0; i < COUNT(bad); i++)
        bad[i] = good;
    bad[0].count = 0;
    bad[1].values = values;
    bad[1].count = 3;
    bad[2].torsion_count = -1;
    bad[3].left = 0;
    bad[4].right = -1;
    bad[5].tolerance = 0;
    bad[6].tolerance = HUGE_VAL;
    for (int i = 0; i < COUNT(bad); i++) {
        batten_fold fold;
        CHECK_STATUS(batten_fold_create(curve, &bad[i], &fold),
                     i == 1 ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(messages[i]);
    }
    batten_curve_unref(curve);
}

/* The cones of a circle of radius 2 meet at 2 / cos(a) from it along the rulings, which stand at
 * right angles to it. */
TEST(a_sheet_may_be_as_wide_as_its_rulings_are_free_and_no_wider)
{
    const double a = 0.4, apex = 2 / cos(a);
    batten_fold_create_options options = options_of(&a, 0.999 * apex);
    batten_curve *circle = arc(2, 1);
    batten_fold fold;

    options.right = 0.5;
    options.tolerance = 1e-5;
    CHECK_OK(batten_fold_create(circle, &options, &fold));
    CHECK_NEAR(fmin(fold.left.regression, fold.right.regression), apex, 1e-6);
    CHECK(isinf(fold.right.regression) || fold.right.regression > 1e3);
    for (int i = 0; i < fold.count; i++) {
        CHECK_NEAR(fold.left.lengths[i], 0.999 * apex, 1e-8);
        CHECK_NEAR(fold.right.lengths[i], 0.5, 1e-8);
    }
    batten_fold_release(&fold);
    options.left = 2.5;
    CHECK_STATUS(batten_fold_create(circle, &options, &fold), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the left sheet would be 2.5 wide, but its rulings meet 2.17");
    batten_curve_unref(circle);
}
