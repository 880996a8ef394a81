#include "inspect/shapes.h"
#include "support/surfaces.h"

#include <batten/coons.h>
#include <batten/measure.h>
#include <string.h>

TEST(areas_of_spheres_and_tori_are_those_of_the_formula)
{
    static const double sizes[] = {1, 1e-80, 1e80};
    for (int i = 0; i < COUNT(sizes); i++) {
        const double r = 2 * sizes[i], R = 3 * sizes[i];
        double area = 0, error = 0;
        batten_surface *sphere = NULL, *torus = NULL;
        CHECK_OK(shape_torus(0, r, true, &sphere));
        CHECK_OK(test_surface_area(sphere, 1e-12, &area, &error));
        CHECK_NEAR(area / (4 * PI * r * r), 1, 1e-13);
        CHECK(error <= 1.1e-12 * area && error > 0);
        CHECK_OK(shape_torus(R, r, false, &torus));
        CHECK_OK(test_surface_area(torus, 1e-12, &area, &error));
        CHECK_NEAR(area / (4 * PI * PI * R * r), 1, 1e-13);
        CHECK_OK(test_surface_area(torus, 1e-3, &area, &error));
        CHECK(fabs(area - 4 * PI * PI * R * r) <= error);
        batten_surface_unref(sphere);
        batten_surface_unref(torus);
    }
}

static const double unit[2] = {0, 1};

static batten_surface *bezier(int dimension, int degree, const double *points)
{
    batten_surface *made = NULL;
    CHECK_OK(batten_surface_from_bezier(dimension, (batten_pieces){degree, 1, unit},
                                        (batten_pieces){degree, 1, unit}, points, NULL, &made));
    return made;
}

/* The area by points in the middle of n x n cells: off by some 1 / n^2. */
static double middle_sum(const batten_surface *surface, int n)
{
    double sum = 0, s[9];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            CHECK_OK(batten_surface_evaluate(surface, (i + 0.5) / n, (j + 0.5) / n, 1, s));
            sum += hypot(hypot(s[4] * s[8] - s[5] * s[7], s[5] * s[6] - s[3] * s[8]),
                         s[3] * s[7] - s[4] * s[6]);
        }
    return sum / n / n;
}

/* The first patch of Newell's teapot, of its rim. */
TEST(the_area_of_a_patch_of_the_teapot_is_that_of_a_fine_sum)
{
    static const double rim[16][3] = {{1.4, 0, 2.4},
                                      {1.4, -0.784, 2.4},
                                      {0.784, -1.4, 2.4},
                                      {0, -1.4, 2.4},
                                      {1.3375, 0, 2.53125},
                                      {1.3375, -0.749, 2.53125},
                                      {0.749, -1.3375, 2.53125},
                                      {0, -1.3375, 2.53125},
                                      {1.4375, 0, 2.53125},
                                      {1.4375, -0.805, 2.53125},
                                      {0.805, -1.4375, 2.53125},
                                      {0, -1.4375, 2.53125},
                                      {1.5, 0, 2.4},
                                      {1.5, -0.84, 2.4},
                                      {0.84, -1.5, 2.4},
                                      {0, -1.5, 2.4}};
    double area = 0, error = 0;
    batten_surface *patch = bezier(3, 3, &rim[0][0]);
    CHECK_OK(test_surface_area(patch, 1e-10, &area, &error));
    const double coarse = middle_sum(patch, 100), fine = middle_sum(patch, 200);
    CHECK_NEAR(area, fine + (fine - coarse) / 3, 1e-7);
    CHECK(error <= 1e-10 * area);
    batten_surface_unref(patch);
}

TEST(surfaces_of_formulas_have_areas)
{
    /* the hyperbolic paraboloid z = u v between straight lines, as a Coons patch */
    static const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    static const double saddle[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    batten_ribbon sides[4];
    batten_surface *coons = NULL, *exact = bezier(3, 1, saddle);
    double of_coons = 0, of_exact = 0;
    memset(sides, 0, sizeof sides);
    batten_curve *curves[4];
    const int ends[4][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};
    for (int i = 0; i < 4; i++) {
        double points[6];
        memcpy(points, corners[ends[i][0]], sizeof corners[0]);
        memcpy(points + 3, corners[ends[i][1]], sizeof corners[0]);
        CHECK_OK(shape_bezier(3, 1, points, &curves[i]));
        sides[i].curve = curves[i];
    }
    CHECK_OK(batten_surface_coons(sides, NULL, NULL, &coons));
    CHECK_OK(test_surface_area(coons, 1e-11, &of_coons, NULL));
    CHECK_OK(test_surface_area(exact, 1e-11, &of_exact, NULL));
    /* the integral of sqrt(1 + u u + v v) over the unit square */
    CHECK_NEAR(of_exact, 1.2807892, 1e-6);
    CHECK_NEAR(of_coons, of_exact, 1e-10);
    batten_surface_unref(coons);
    batten_surface_unref(exact);
    for (int i = 0; i < 4; i++)
        batten_curve_unref(curves[i]);
}

TEST(areas_in_the_plane_count_folds_twice)
{
    /* (x, y) = (2 u - 2 u u, v): folded at u = 1/2, where the integrand has a kink */
    const double points[18] = {0, 0, 0, 0.5, 0, 1, 1, 0, 1, 0.5, 1, 1, 0, 0, 0, 0.5, 0, 1};
    batten_surface *folded = bezier(2, 2, points);
    double area = 0, error = 0;
    CHECK_OK(test_surface_area(folded, 1e-9, &area, &error));
    CHECK_NEAR(area, 1, 1e-12); /* halving meets the fold */
    batten_surface_unref(folded);
}

TEST(a_fold_that_halving_does_not_meet_is_reported)
{
    /* x = u (1 - u) + v / 3: its folds lie across all cells */
    double points[9][2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double u = 0.5 * i, v = 0.5 * j, fold = i == 1 ? 0.5 : 0;
            points[3 * i + j][0] = fold + u * v / 3 + v * 0.1;
            points[3 * i + j][1] = v + 0.3 * u;
        }
    batten_surface *folded = bezier(2, 2, &points[0][0]);
    double area = 0, rough = 0, error = 0;
    CHECK_STATUS(test_surface_area(folded, 1e-13, &area, &error), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("after 8192 halvings");
    CHECK(error > 0 && error < 1e-4 * area);
    CHECK_OK(test_surface_area(folded, 1e-3, &rough, &error));
    CHECK(fabs(rough - area) <= error);
    batten_surface_unref(folded);
}

TEST(areas_that_cannot_be_are_refused)
{
    double area = -1, error = -1;
    const double flat[4] = {0, 1, 0, 1}, one[12] = {0}, far[12] = {0, 0, 0, 0, 1e200, 0, 1e200};
    batten_surface *function = bezier(1, 1, flat), *point = bezier(3, 1, one),
                   *large = bezier(3, 1, far);
    CHECK_STATUS(test_surface_area(function, 1e-6, &area, &error), BATTEN_UNSUPPORTED);
    CHECK_STATUS(test_surface_area(point, 0, &area, &error), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(test_surface_area(large, 1e-6, &area, &error), BATTEN_OVERFLOW);
    CHECK(area == -1 && error == -1);
    CHECK_OK(test_surface_area(point, 1e-6, &area, &error));
    CHECK(area == 0 && error == 0);
    batten_surface_unref(function);
    batten_surface_unref(point);
    batten_surface_unref(large);
}
