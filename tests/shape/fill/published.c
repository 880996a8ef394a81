/* The loops that others have published for their own surfaces. */
#include "shape/fill/loops.h"
#include <batten/geometry.h>

/* Sides of a .lop file: degree, knots, control points of each. */
static void read_loop(const char *path, hole *h)
{
    FILE *file = fopen(test_data(path), "r");
    memset(h, 0, sizeof *h);
    int sides = 0;
    CHECK(file && fscanf(file, "%d", &sides) == 1 && sides >= 3 && sides <= 8);
    for (int i = 0; i < sides; i++) {
        int degree, knot_count, point_count;
        double knots[32], points[32][3];
        CHECK(fscanf(file, "%d %d", &degree, &knot_count) == 2 && knot_count <= 32);
        for (int k = 0; k < knot_count; k++)
            CHECK(fscanf(file, "%lf", &knots[k]) == 1);
        CHECK(fscanf(file, "%d", &point_count) == 1 && point_count <= 32);
        for (int k = 0; k < 3 * point_count; k++)
            CHECK(fscanf(file, "%lf", &points[0][0] + k) == 1);
        CHECK_OK(batten_curve_create((batten_points){3, point_count, points[0]}, degree, NULL,
                                     knots, &h->curves[i]));
        h->ribbons[i].curve = h->curves[i];
        h->count = i + 1;
    }
    fclose(file);
}

/* Slopes that go over from the tangent of the side before to that of the side behind. */
static void add_slopes(hole *h)
{
    for (int i = 0; i < h->count; i++) {
        double before[2][3], behind[2][3], slope[2][3];
        const batten_interval domain = batten_curve_domain(h->curves[i]);
        const double knots[4] = {domain.a, domain.a, domain.b, domain.b};
        const batten_curve *last = h->curves[(i + h->count - 1) % h->count];
        const batten_curve *next = h->curves[(i + 1) % h->count];
        CHECK_OK(batten_curve_evaluate(last, batten_curve_domain(last).b, 1, before[0]));
        CHECK_OK(batten_curve_evaluate(next, batten_curve_domain(next).a, 1, behind[0]));
        for (int c = 0; c < 3; c++) {
            slope[0][c] = -before[1][c];
            slope[1][c] = behind[1][c];
        }
        CHECK_OK(batten_curve_create((batten_points){3, 2, slope[0]}, 1, NULL, knots,
                                     &h->slopes[i]));
        h->ribbons[i].slope = h->slopes[i];
    }
}

/* What is seen at 1000 places of each side, with nothing of the fill's own measuring. */
static hole_misfit outer(const hole *h)
{
    hole_misfit out = {0, 0};
    for (int i = 0; i < h->count; i++)
        for (int k = 0; k <= 1000; k++) {
            const batten_interval domain = batten_curve_domain(h->curves[i]);
            double C[2][3], T[3], p[3], n[3], m[3];
            const double t = k / 1000.0, at = (1 - t) * domain.a + t * domain.b;
            CHECK_OK(batten_curve_evaluate(h->curves[i], at, 1, C[0]));
            CHECK_OK(batten_curve_evaluate(h->slopes[i], at, 0, T));
            for (int c = 0; c < 3; c++)
                m[c] = C[1][(c + 1) % 3] * T[(c + 2) % 3] - C[1][(c + 2) % 3] * T[(c + 1) % 3];
            if (k <= 500)
                hole_see(h->patches[i], 2 * t, 0, p, n);
            else
                hole_see(h->patches[(i + 1) % h->count], 0, 2 * (1 - t), p, n);
            hole_compare(p, n, C[0], m, &out);
        }
    return out;
}

TEST(published_loops_are_filled_within_a_hundredth_of_a_degree)
{
    static const char *files[] = {"patches/pocket3sided.lop", "patches/pocket4sided.lop",
                                  "patches/cagd86.lop"};
    for (int f = 0; f < COUNT(files); f++) {
        hole h;
        read_loop(files[f], &h);
        CHECK_OK(batten_surface_fill(h.count, h.ribbons, NULL, &h.report, h.patches));
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
        CHECK(!h.report.folded);
        hole_free_patches(&h);
        add_slopes(&h);
        CHECK_OK(batten_surface_fill(h.count, h.ribbons, NULL, &h.report, h.patches));
        CHECK_NEAR(outer(&h).gap, 0, 1e-12);
        CHECK_NEAR(outer(&h).angle, 0, 0.0025);
        CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
        CHECK(!h.report.folded);
        hole_free(&h);
    }
}

/* The rings of a generalized Bezier patch of degree 5 with 5 sides: 25 points around, then 15.
 * The slope along a side is the way from the outer ring to the next. */
TEST(the_ribbons_of_a_generalized_bezier_patch_are_met_exactly)
{
    FILE *file = fopen(test_data("patches/cagd86.gbp"), "r");
    int sides = 0, degree = 0;
    double centre[3], outside[25][3], inside[15][3];
    CHECK(file && fscanf(file, "%d %d", &sides, &degree) == 2 && sides == 5 && degree == 5);
    for (int k = 0; k < 3; k++)
        CHECK(fscanf(file, "%lf", &centre[k]) == 1);
    for (int k = 0; k < 75; k++)
        CHECK(fscanf(file, "%lf", &outside[0][0] + k) == 1);
    for (int k = 0; k < 45; k++)
        CHECK(fscanf(file, "%lf", &inside[0][0] + k) == 1);
    fclose(file);
    hole h = {0};
    for (int i = 0; i < 5; i++) {
        double side[6][3], slope[6][3];
        for (int j = 0; j < 6; j++)
            for (int c = 0; c < 3; c++) {
                side[j][c] = outside[(5 * i + j) % 25][c];
                const double second = j == 0   ? outside[(5 * i + 24) % 25][c]
                                      : j == 5 ? outside[(5 * i + 6) % 25][c]
                                               : inside[(3 * i + j - 1) % 15][c];
                slope[j][c] = second - side[j][c];
            }
        hole_add(&h, 5, side[0], 5, slope[0]);
    }
    CHECK_OK(batten_surface_fill(5, h.ribbons, NULL, &h.report, h.patches));
    CHECK_INT(h.report.twisted, 0);
    CHECK_NEAR(outer(&h).angle, 0, 1e-7);
    CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
    CHECK(!h.report.folded);
    hole_free(&h);
}

TEST(rational_sides_are_met_within_the_tolerance)
{
    /* an octant of a sphere: three quarter circles, with the planes of the sphere */
    hole h = {0};
    batten_surface_fill_options options = batten_surface_fill_defaults();
    options.tolerance = 1e-6;
    static const int axes[3][2] = {{0, 1}, {1, 2}, {2, 0}};
    h.count = 3;
    for (int i = 0; i < 3; i++) {
        const double ends[2] = {0, 1}, weights[3] = {1, sqrt(0.5), 1}, knots[4] = {0, 0, 1, 1};
        double points[3][3] = {{0}}, slope[2][3] = {{0}};
        points[0][axes[i][0]] = points[1][axes[i][0]] = 1;
        points[1][axes[i][1]] = points[2][axes[i][1]] = 1;
        slope[0][axes[(i + 1) % 3][1]] = slope[1][axes[(i + 1) % 3][1]] = 1;
        CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){2, 1, ends}, points[0], weights,
                                          &h.curves[i]));
        CHECK_OK(
            batten_curve_create((batten_points){3, 2, slope[0]}, 1, NULL, knots, &h.slopes[i]));
        h.ribbons[i] = (batten_ribbon){h.curves[i], h.slopes[i], NULL};
    }
    CHECK_OK(batten_surface_fill(3, h.ribbons, &options, &h.report, h.patches));
    CHECK(h.report.approximation > 0 && h.report.approximation <= 1e-6);
    CHECK_NEAR(outer(&h).gap, 0, 1e-6);
    CHECK_NEAR(outer(&h).angle, 0, 0.01);
    CHECK_NEAR(hole_inner(&h).angle, 0, 1e-7);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= 20; k++) {
            double p[3], n[3];
            hole_see(h.patches[i], k / 20.0, k / 20.0, p, n);
            CHECK_NEAR(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), 1, 0.02);
        }
    hole_free(&h);
}
