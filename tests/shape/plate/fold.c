#include <batten/curvature.h>
#include <batten/measure.h>
#include <batten/plate.h>
#include <batten/standard.h>

#include "support/faults.h"
#include "support/test.h"

#include <stdlib.h>

static const double pi = 3.14159265358979323846;

static batten_fold_create_options options_of(const double *angle, double width)
{
    batten_fold_create_options options = batten_fold_create_defaults();
    options.count = 1;
    options.values = angle;
    options.left = options.right = width;
    options.tolerance = 1e-7;
    return options;
}

/* A helix of radius 5 that climbs 0.2 a radian, as a quintic by its exact derivatives. */
static batten_curve *helix(double climb, double to)
{
    enum { COUNT = 200 };
    static double t[COUNT], values[COUNT][3][3];
    batten_curve *curve = NULL;
    for (int i = 0; i < COUNT; i++) {
        t[i] = to * i / (COUNT - 1);
        const double c = 5 * cos(t[i]), s = 5 * sin(t[i]);
        const double rows[3][3] = {{c, s, climb * t[i]}, {-s, c, climb}, {-c, -s, 0}};
        memcpy(values[i], rows, sizeof rows);
    }
    CHECK_OK(batten_curve_from_hermite(3, COUNT, 3, t, &values[0][0][0], &curve));
    return curve;
}

/* A crease with torsion that changes and an inflection-free curvature. */
static batten_curve *twisted(void)
{
    const double points[6][3] = {{0, 0, 0},       {1, 0, 0.1},   {2, 0.6, 0.3},
                                 {2.4, 1.6, 0.6}, {2, 2.6, 0.7}, {1, 3.2, 0.6}};
    const double knots[12] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 6, &points[0][0]}, 5, NULL, knots, &curve));
    return curve;
}

TEST(a_circle_folds_into_two_cones_with_the_apex_at_r_by_cos_a)
{
    const batten_frame world = batten_frame_world();
    batten_curve *circle = NULL;
    batten_fold fold;
    CHECK_OK(batten_curve_arc_in(&world, 2, 0, 3, &circle));
    const double a = pi / 6;
    batten_fold_create_options options = options_of(&a, 0.5);
    CHECK_EACH_ALLOCATION(batten_fold_create(circle, &options, &fold));
    CHECK_NEAR(fold.left.regression, 2 / cos(a), 1e-7);
    CHECK(isinf(fold.right.regression));
    CHECK_NEAR(fold.flat_turn, 3 * cos(a), 1e-10);
    CHECK_NEAR(fold.length, 6, 1e-11);
    CHECK(fold.twist < 1e-4 && fold.stretch < 1e-9 && fold.error <= 1e-7);
    /* The flat crease is a circle of radius R / cos a about (0, R / cos a). */
    for (int i = 0; i < fold.count; i++)
        CHECK_NEAR(hypot(fold.flat[2 * i], fold.flat[2 * i + 1] - 2 / cos(a)), 2 / cos(a),
                   1e-9);
    /* Rulings of a plane crease with constant angle are at right angles to it. */
    for (int i = 0; i < fold.count; i++)
        CHECK_NEAR(fold.left.lengths[i], 0.5, 1e-10);
    batten_fold_release(&fold);
    const batten_fold none = {0};
    CHECK(fold.count == 0 && fold.length == 0 && fold.crease == none.crease && !fold.points);
    batten_fold_release(&fold); /* once more is allowed */
    batten_curve_unref(circle);
}

TEST(a_helix_with_constant_angle_has_rulings_of_constant_angle)
{
    batten_curve *curve = helix(0.2, 3);
    const double a = 0.4, k = 5 / 25.04, tau = 0.2 / 25.04;
    batten_fold_create_options options = options_of(&a, 0.8);
    batten_fold fold;
    CHECK_OK(batten_fold_create(curve, &options, &fold));
    const double b = atan2(1, tau / (k * sin(a)));
    for (int i = 0; i < fold.count; i++) {
        CHECK_NEAR(fold.left.lengths[i], 0.8 / sin(b), 1e-8);
        CHECK_NEAR(fold.right.lengths[i], 0.8 / sin(b), 1e-8);
    }
    CHECK_NEAR(fold.flat_turn, cos(a) * k * fold.length, 1e-9);
    CHECK(fold.twist < 1e-3 && fold.stretch < 1e-8);
    batten_fold_release(&fold);
    batten_curve_unref(curve);
}

/* Both sheets of a fold with torsion and a changing angle: unfolding keeps every length. */
TEST(the_sheets_of_a_twisted_crease_are_developable_and_unfold_without_stretch)
{
    batten_curve *curve = twisted();
    const double angles[3] = {0.3, 0.5, 0.35};
    batten_fold_create_options options = options_of(angles, 0.15);
    batten_fold fold;
    options.count = 3;
    CHECK_OK(batten_fold_create(curve, &options, &fold));
    CHECK(fold.twist < 1e-3);
    CHECK(fold.stretch < 1e-7);
    CHECK(fold.error <= 1e-7);
    /* Distances across the sheet: between the edge at one sample and the crease at the next, in
     * space and flat, to the second order of the step. */
    for (int i = 0; i + 1 < fold.count; i++)
        for (int side = 0; side < 2; side++) {
            const batten_fold_sheet *s = side ? &fold.right : &fold.left;
            double space = 0, flat = 0;
            for (int c = 0; c < 3; c++)
                space += pow(fold.points[3 * i + c] + s->lengths[i] * s->rulings[3 * i + c] -
                                 fold.points[3 * i + 3 + c],
                             2);
            for (int c = 0; c < 2; c++)
                flat += pow(fold.flat[2 * i + c] + s->lengths[i] * s->flat_rulings[2 * i + c] -
                                fold.flat[2 * i + 2 + c],
                            2);
            CHECK_NEAR(sqrt(space), sqrt(flat), 1e-4);
        }
    batten_fold_release(&fold);
    batten_curve_unref(curve);
}

TEST(the_osculating_plane_halves_the_angle_between_the_sheets)
{
    batten_curve *curve = twisted();
    const double a = -0.4;
    batten_fold_create_options options = options_of(&a, 0.1);
    batten_fold fold;
    CHECK_OK(batten_fold_create(curve, &options, &fold));
    const double at = 0.5;
    double u;
    batten_curve_local local;
    const double s = at * fold.length;
    CHECK_OK(batten_curve_at_length(curve, 1, &s, 1e-12, &u));
    CHECK_OK(batten_curve_local_at(curve, u, BATTEN_FROM_RIGHT, &local));
    const int i = (fold.count - 1) / 2;
    for (int side = 0; side < 2; side++) {
        const double *r = (side ? fold.right.rulings : fold.left.rulings) + 3 * i;
        const double across =
            r[0] * local.normal.x + r[1] * local.normal.y + r[2] * local.normal.z;
        const double up =
            r[0] * local.binormal.x + r[1] * local.binormal.y + r[2] * local.binormal.z;
        /* left: cos a N + sin a B; right: -(cos a N - sin a B) */
        CHECK_NEAR(atan2(up, side ? -across : across), a, 1e-9);
    }
    batten_fold_release(&fold);
    batten_curve_unref(curve);
}

TEST(a_flat_circle_with_an_angle_and_no_torsion_becomes_a_smaller_circle)
{
    batten_curve *flat = NULL;
    batten_fold fold;
    CHECK_OK(batten_curve_arc(2, 2.5, &flat));
    const double a = 0.5;
    batten_fold_create_options options = options_of(&a, 0.3);
    options.given = BATTEN_FOLD_FLAT;
    CHECK_OK(batten_fold_create(flat, &options, &fold));
    CHECK_NEAR(fold.length, 5, 1e-9);
    CHECK_NEAR(fold.flat_turn, 2.5, 1e-8);
    batten_curve_local local;
    for (int i = 0; i <= 10; i++) {
        CHECK_OK(batten_curve_local_at(fold.crease, 0.5 * i, BATTEN_FROM_LEFT, &local));
        CHECK_NEAR(local.curvature, 1 / (2 * cos(a)), 1e-8);
        CHECK_NEAR(local.torsion, 0, 1e-6);
    }
    batten_fold_release(&fold);
    batten_curve_unref(flat);
}

TEST(the_curvature_of_the_flat_crease_determines_the_angle)
{
    batten_curve *curve = helix(0.2, 2);
    const double k = 5 / 25.04, flat = k * cos(0.7);
    batten_fold_create_options options = options_of(&flat, 0.5);
    batten_fold fold;
    options.given = BATTEN_FOLD_CURVATURE;
    CHECK_OK(batten_fold_create(curve, &options, &fold));
    for (int i = 0; i < fold.count; i++)
        CHECK_NEAR(fold.angles[i], 0.7, 1e-7);
    batten_fold_release(&fold);
    options.other_side = true;
    CHECK_OK(batten_fold_create(curve, &options, &fold));
    CHECK_NEAR(fold.angles[3], -0.7, 1e-7);
    batten_fold_release(&fold);
    batten_curve_unref(curve);
}

TEST(folds_that_cannot_be_are_refused_with_the_place)
{
    batten_curve *curve = helix(0.2, 2), *line = NULL;
    const double ends[6] = {0, 0, 0, 1, 0, 0};
    batten_fold fold;
    double value = 0.3;
    batten_fold_create_options options = options_of(&value, 0.5);

    options.given = BATTEN_FOLD_CURVATURE;
    CHECK_STATUS(batten_fold_create(curve, &options, &fold), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("below that in space");
    options.given = BATTEN_FOLD_ANGLE;

    options.left = 7; /* the cone's apex is at about 5.2 */
    CHECK_STATUS(batten_fold_create(curve, &options, &fold), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("left sheet");
    options.left = 0.5;

    CHECK_OK(batten_curve_line(3, ends, ends + 3, &line));
    CHECK_STATUS(batten_fold_create(line, &options, &fold), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("straight");

    const double wrong[] = {0, pi / 2, 2, NAN};
    for (int i = 0; i < COUNT(wrong); i++) {
        value = wrong[i];
        CHECK_STATUS(batten_fold_create(curve, &options, &fold),
                     i == 3 ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT);
        if (i == 1)
            CHECK_MESSAGE("the angle is 90 degrees at the length 0 of the crease");
    }
    value = 0.3;
    options.right = -1;
    CHECK_STATUS(batten_fold_create(curve, &options, &fold), BATTEN_BAD_ARGUMENT);
    batten_curve_unref(line);
    batten_curve_unref(curve);
}

/* ---- what differences of the samples say ---- */

/* The derivative by the sample number, of sixth order, d numbers a sample. */
static void difference(const double *values, int d, int i, double *out)
{
    static const double weights[3] = {45 / 60.0, -9 / 60.0, 1 / 60.0};
    for (int c = 0; c < d; c++) {
        out[c] = 0;
        for (int k = 1; k <= 3; k++)
            out[c] += weights[k - 1] * (values[(i + k) * d + c] - values[(i - k) * d + c]);
    }
}

static void cross(const double *a, const double *b, double *out)
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static double dot(int d, const double *a, const double *b)
{
    double sum = 0;
    for (int c = 0; c < d; c++)
        sum += a[c] * b[c];
    return sum;
}

/* Along ruling r the regression is where X' + v r' is parallel to r; at right angles to the
 * crease. */
static double regression_at(const double *T, const double *r, const double *turn)
{
    double a[3], b[3];
    cross(T, r, a);
    cross(turn, r, b);
    const double v = -dot(3, a, b) / dot(3, b, b), along = dot(3, T, r) / sqrt(dot(3, T, T));
    return v > 0 ? v * sqrt(1 - along * along) : HUGE_VAL;
}

/* det(T, r, r') = 0 and the same metric in space and flat, along arc length; returns the least
 * distance of the regression. */
static double check_sheet(const batten_fold *fold, const batten_fold_sheet *sheet)
{
    const double step = fold->length / (fold->count - 1);
    double least = HUGE_VAL;
    for (int i = 3; i + 3 < fold->count; i++) {
        double T[3], turn[3], T_flat[2], turn_flat[2], normal[3];
        const double *r = sheet->rulings + 3 * i, *flat = sheet->flat_rulings + 2 * i;
        difference(fold->points, 3, i, T);
        difference(sheet->rulings, 3, i, turn);
        difference(fold->flat, 2, i, T_flat);
        difference(sheet->flat_rulings, 2, i, turn_flat);
        cross(T, r, normal);
        CHECK_NEAR(dot(3, normal, turn) / (step * step), 0, 3e-7);
        CHECK_NEAR(dot(3, T, T) / dot(2, T_flat, T_flat), 1, 5e-8);
        CHECK_NEAR(dot(3, T, r) / step, dot(2, T_flat, flat) / step, 5e-8);
        CHECK_NEAR(dot(3, T, turn) / (step * step), dot(2, T_flat, turn_flat) / (step * step),
                   3e-7);
        CHECK_NEAR(dot(3, turn, turn) / (step * step),
                   dot(2, turn_flat, turn_flat) / (step * step), 3e-7);
        least = fmin(least, regression_at(T, r, turn));
    }
    return least;
}

TEST(sheets_are_developable_isometric_and_end_at_the_regression_of_their_rulings)
{
    const double angles[2][3] = {{0.4, 0.4, 0.4}, {0.3, 0.5, 0.35}};
    for (int k = 0; k < 2; k++) {
        batten_curve *curve = k ? twisted() : helix(0.2, 3);
        batten_fold_create_options options = options_of(angles[k], 0.15);
        batten_fold fold;
        options.count = 3;
        CHECK_OK(batten_fold_create(curve, &options, &fold));
        for (int side = 0; side < 2; side++) {
            const batten_fold_sheet *sheet = side ? &fold.right : &fold.left;
            const double least = check_sheet(&fold, sheet);
            if (isinf(least))
                CHECK(sheet->regression > 1e3);
            else if (sheet->regression_at > 0.02 * fold.length &&
                     sheet->regression_at < 0.98 * fold.length)
                CHECK_NEAR(sheet->regression / least, 1, 1e-4);
            else
                CHECK(sheet->regression <= least * (1 + 1e-6));
            CHECK(fold.stretch < 5e-8);
        }
        batten_fold_release(&fold);
        batten_curve_unref(curve);
    }
}

/* Across a plane crease the rulings of the flat sheet go straight on. */
TEST(the_rulings_of_a_plane_crease_go_straight_on_in_the_flat_sheet)
{
    const batten_frame world = batten_frame_world();
    const double angles[3] = {0.3, 0.5, 0.35};
    batten_fold_create_options options = options_of(angles, 0.15);
    batten_curve *circle = NULL;
    batten_fold fold;
    options.count = 3;
    CHECK_OK(batten_curve_arc_in(&world, 2, 0, 3, &circle));
    CHECK_OK(batten_fold_create(circle, &options, &fold));
    for (int i = 0; i < 2 * fold.count; i++)
        CHECK_NEAR(fold.left.flat_rulings[i] + fold.right.flat_rulings[i], 0, 1e-9);
    batten_fold_release(&fold);
    batten_curve_unref(circle);
}

TEST(a_crease_that_bends_both_ways_is_refused_where_it_does)
{
    const double points[4][3] = {{0, 0, 0}, {1, 1, 0}, {2, -1, 0}, {3.1, 0.2, 0}};
    const double breaks[2] = {0, 1}, a = 0.4;
    batten_curve *curve = NULL;
    batten_fold fold;
    batten_fold_create_options options = options_of(&a, 0.1);
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){3, 1, breaks}, &points[0][0], NULL,
                                      &curve));
    CHECK_STATUS(batten_fold_create(curve, &options, &fold), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("to the other side near the length 1.");
    batten_curve_unref(curve);
}

TEST(folds_without_angles_widths_or_torsions_that_are_numbers_are_refused_and_nothing_is_made)
{
    const double points[2][3] = {{0, 0, 0}, {1, 0.2, 0}}, a = 0.4, nan[2] = {0.4, NAN};
    const double breaks[2] = {0, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){1, 1, breaks}, &points[0][0], NULL,
                                      &curve));
    const batten_fold_create_options good = options_of(&a, 0.1);
    batten_fold_create_options bad[8];
    for (int i = 0; i < COUNT(bad); i++)
        bad[i] = good;
    bad[0].values = NULL;
    bad[1].count = 0;
    bad[2].values = nan;
    bad[2].count = 2;
    bad[3].torsion_count = -1;
    bad[4].torsion_count = 1;
    bad[5].left = 0;
    bad[6].right = -1;
    bad[7].right = HUGE_VAL;
    for (int i = 0; i < COUNT(bad); i++) {
        batten_fold fold, before;
        memset(&fold, 0x5a, sizeof fold);
        memcpy(&before, &fold, sizeof fold);
        CHECK_STATUS(batten_fold_create(curve, &bad[i], &fold),
                     i == 2 ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT);
        CHECK(memcmp(&fold, &before, sizeof fold) == 0);
    }
    batten_curve_unref(curve);
}
