/* One trimmed surface over a hole. */
#include "shape/fill/loops.h"
#include <batten/nearest.h>

/* A cubic height and its derivatives, for holes that are cut out of a smooth surface. */
static double height(double x, double y)
{
    return 0.1 * x * x - 0.15 * x * y + 0.05 * y * y + 0.04 * x * x * x - 0.03 * x * y * y;
}

static void gradient(double x, double y, double out[2])
{
    out[0] = 0.2 * x - 0.15 * y + 0.12 * x * x - 0.03 * y * y;
    out[1] = -0.15 * x + 0.1 * y - 0.06 * x * y;
}

static double second_along(double x, double y, const double w[2])
{
    return (0.2 + 0.24 * x) * w[0] * w[0] + 2 * (-0.15 - 0.06 * y) * w[0] * w[1] +
           (0.1 - 0.06 * x) * w[1] * w[1];
}

static const double ell[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

/* The derivative of order m along w, at a place of a side. */
static void derivative_across(int m, const double at[2], const double w[2], double out[3])
{
    double g[2];
    gradient(at[0], at[1], g);
    out[0] = m == 1 ? w[0] : 0;
    out[1] = m == 1 ? w[1] : 0;
    out[2] = m == 1 ? g[0] * w[0] + g[1] * w[1] : second_along(at[0], at[1], w);
}

/* The cubic over [0, 1] whose values at the thirds are these. */
static batten_curve *through_thirds(const double q[4][3])
{
    static const double ends[2] = {0, 1};
    double p[4][3];
    batten_curve *out = NULL;
    for (int c = 0; c < 3; c++) {
        p[0][c] = q[0][c];
        p[3][c] = q[3][c];
        p[1][c] = (-5 * q[0][c] + 18 * q[1][c] - 9 * q[2][c] + 2 * q[3][c]) / 6;
        p[2][c] = (2 * q[0][c] - 9 * q[1][c] + 18 * q[2][c] - 5 * q[3][c]) / 6;
    }
    CHECK_OK(batten_curve_from_bezier(3, (batten_pieces){3, 1, ends}, p[0], NULL, &out));
    return out;
}

typedef struct {
    batten_curve *curves[6][3];
    batten_ribbon sides[6];
} l_hole;

/* An L cut out of the cubic; side 1 runs against the loop. */
static void make_l(int derivatives, l_hole *h)
{
    for (int i = 0; i < 6; i++) {
        const double *a = ell[i], *b = ell[(i + 1) % 6];
        const double w[2] = {-(b[1] - a[1]), b[0] - a[0]};
        const bool back = i == 1;
        double q[3][4][3];
        for (int k = 0; k < 4; k++) {
            const double s = back ? 1 - k / 3.0 : k / 3.0;
            const double at[2] = {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
            q[0][k][0] = at[0];
            q[0][k][1] = at[1];
            q[0][k][2] = height(at[0], at[1]);
            derivative_across(1, at, w, q[1][k]);
            derivative_across(2, at, w, q[2][k]);
        }
        for (int m = 0; m < 3; m++)
            h->curves[i][m] =
                m <= derivatives ? through_thirds((const double(*)[3])q[m]) : NULL;
        h->sides[i] = (batten_ribbon){h->curves[i][0], h->curves[i][1], h->curves[i][2]};
    }
}

static void free_l(l_hole *h)
{
    for (int i = 0; i < 6; i++)
        for (int m = 0; m < 3; m++)
            batten_curve_unref(h->curves[i][m]);
}

/* The surface at a place of side i, against the side. */
static double gap_at(const batten_fill_sheet *sheet, const l_hole *h, int i, double t,
                     double d[6][3])
{
    double uv[2], point[3];
    const batten_sheet_side *side = &sheet->sides[i];
    CHECK_OK(batten_curve_evaluate(side->parameters, t, 0, uv));
    CHECK_OK(batten_curve_evaluate(h->curves[side->curve][0], t, 0, point));
    CHECK_OK(batten_surface_evaluate(sheet->surface, uv[0], uv[1], 2, d[0]));
    return sqrt(pow(d[0][0] - point[0], 2) + pow(d[0][1] - point[1], 2) +
                pow(d[0][2] - point[2], 2));
}

static void unit_normal(double d[6][3], double n[3])
{
    for (int c = 0; c < 3; c++)
        n[c] = d[1][(c + 1) % 3] * d[2][(c + 2) % 3] - d[1][(c + 2) % 3] * d[2][(c + 1) % 3];
    const double size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int c = 0; c < 3; c++)
        n[c] /= size;
}

TEST(a_hole_in_the_shape_of_an_L_is_one_surface_that_does_not_fold)
{
    l_hole h;
    batten_fill_sheet sheet = {0};
    batten_fill_sheet_report report;
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    options.tolerance = 1e-5;
    make_l(0, &h);
    CHECK_OK(batten_surface_fill_sheet(6, h.sides, &options, &report, &sheet));
    CHECK_INT(sheet.count, 6);
    CHECK_INT(report.count, 6);
    CHECK(sheet.sides[1].reversed && !sheet.sides[0].reversed);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k <= 200; k++) {
            double d[6][3], n[3];
            CHECK(gap_at(&sheet, &h, i, k / 200.0, d) <= report.outer[i].gap * 1.03 + 1e-12);
            unit_normal(d, n);
            CHECK(n[2] > 0.5);
        }
    for (int i = 0; i < 6; i++)
        CHECK(report.outer[i].gap <= 1e-5 && !report.outer[i].has_slope);
    batten_fill_sheet_release(&sheet);
    free_l(&h);
}

/* How far the sheet is at side i from the planes and curvatures of the cubic. */
static void compare_with_cubic(const batten_fill_sheet *sheet, const l_hole *h, int i, double t,
                               double *angle, double *curvature)
{
    double d[6][3], n[3], g[2], w[2], side[2][3];
    gap_at(sheet, h, i, t, d);
    CHECK_OK(batten_curve_evaluate(h->curves[sheet->sides[i].curve][0], t, 1, side[0]));
    unit_normal(d, n);
    gradient(side[0][0], side[0][1], g);
    const double size = sqrt(1 + g[0] * g[0] + g[1] * g[1]);
    const double m[3] = {-g[0] / size, -g[1] / size, 1 / size}, *C = side[1];
    *angle = fmax(*angle, acos(fmin(1, n[0] * m[0] + n[1] * m[1] + n[2] * m[2])));
    double across[3] = {m[1] * C[2] - m[2] * C[1], m[2] * C[0] - m[0] * C[2],
                        m[0] * C[1] - m[1] * C[0]};
    const double length =
        sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
    w[0] = across[0] / length;
    w[1] = across[1] / length;
    /* the sheet's own second derivatives along the same direction of its tangent plane */
    const double det = d[1][0] * d[2][1] - d[1][1] * d[2][0];
    const double u = (w[0] * d[2][1] - w[1] * d[2][0]) / det;
    const double v = (d[1][0] * w[1] - d[1][1] * w[0]) / det;
    double k = 0;
    for (int c = 0; c < 3; c++)
        k += n[c] * (u * u * d[3][c] + 2 * u * v * d[4][c] + v * v * d[5][c]);
    *curvature = fmax(*curvature, fabs(k - second_along(side[0][0], side[0][1], w) / size));
}

TEST(a_sheet_takes_over_planes_and_curvatures_round_a_re_entrant_corner)
{
    l_hole h;
    batten_fill_sheet sheet = {0};
    batten_fill_sheet_report report;
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    double angle = 0, curvature = 0, claimed[2] = {0, 0};
    options.tolerance = 1e-5;
    options.curvature = true;
    make_l(2, &h);
    CHECK_OK(batten_surface_fill_sheet(6, h.sides, &options, &report, &sheet));
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k <= 100; k++)
            compare_with_cubic(&sheet, &h, i, k / 100.0, &angle, &curvature);
        CHECK(report.outer[i].has_slope && report.outer[i].has_curvature);
        claimed[0] = fmax(claimed[0], report.outer[i].angle);
        claimed[1] = fmax(claimed[1], report.outer[i].curvature);
    }
    CHECK(claimed[0] <= options.angle && angle <= 1.05 * claimed[0] + 1e-7);
    CHECK(claimed[1] <= report.most_curvature && curvature <= 1.05 * claimed[1] + 1e-7);
    CHECK(report.rim_curvature > 0.2 && report.rim_curvature < 2);
    batten_fill_sheet_release(&sheet);
    free_l(&h);
}

TEST(a_sheet_goes_through_points_and_curves_inside)
{
    static const double points[2][3] = {{0.5, 0.5, 0.3}, {0.4, 1.6, 0.1}};
    static const double inner[4][3] = {
        {1.3, 0.2, 0}, {1.5, 0.3, 0.1}, {1.6, 0.6, 0.1}, {1.7, 0.8, 0.2}};
    l_hole h;
    batten_fill_sheet sheet = {0};
    batten_fill_sheet_report report;
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    batten_curve *curve = through_thirds(inner);
    const batten_curve *curves[1] = {curve};
    options.tolerance = 1e-4;
    options.points = (batten_points){3, 2, points[0]};
    options.curves = (batten_curve_row){1, curves};
    make_l(0, &h);
    CHECK_OK(batten_surface_fill_sheet(6, h.sides, &options, &report, &sheet));
    CHECK(report.inside != 0 && report.inside_gap <= 1e-4);
    double distances[2];
    batten_deviation found;
    CHECK_OK(
        batten_surface_deviation(sheet.surface, options.points, NULL, NULL, distances, &found));
    CHECK(distances[0] <= report.inside_gap + 1e-12 &&
          distances[1] <= report.inside_gap + 1e-12);
    batten_fill_sheet_release(&sheet);
    batten_curve_unref(curve);
    free_l(&h);
}

/* A flat square through this point and another one. */
static batten_status fill_with_point(const double point[3], batten_fill_sheet_report *report)
{
    static const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    hole h;
    batten_fill_sheet sheet = {0};
    batten_fill_sheet_options options = batten_fill_sheet_defaults();
    const double points[2][3] = {{point[0], point[1], point[2]}, {0.5, 0.5, 0.1}};
    options.points = (batten_points){3, 2, points[0]};
    options.tolerance = 1e-4;
    memset(&h, 0, sizeof h);
    for (int i = 0; i < 4; i++) {
        double ends[2][3];
        memcpy(ends[0], corners[i], sizeof ends[0]);
        memcpy(ends[1], corners[(i + 1) % 4], sizeof ends[1]);
        hole_add(&h, 1, ends[0], 0, NULL);
    }
    const batten_status status =
        batten_surface_fill_sheet(4, h.ribbons, &options, report, &sheet);
    batten_fill_sheet_release(&sheet);
    hole_free(&h);
    return status;
}

TEST(what_is_inside_is_refused_beyond_the_sides_and_where_it_contradicts)
{
    static const double beyond[3] = {1.5, 1.5, 0}, above[3] = {0.5, 0.5, 0.2};
    batten_fill_sheet_report report;
    CHECK_STATUS(fill_with_point(beyond, &report), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("inner point 1 lies beyond the sides of the hole at (1.5, 1.5, 0)");
    CHECK_STATUS(fill_with_point(above, &report), BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("misses inner point");
    CHECK_MESSAGE("by 0.05");
    CHECK_NEAR(report.inside_gap, 0.05, 0.005);
}

static batten_status fill_polygon(int count, const double corners[][3], const double slope[3])
{
    hole h;
    batten_fill_sheet sheet = {0};
    memset(&h, 0, sizeof h);
    for (int i = 0; i < count; i++) {
        double points[2][3], slopes[2][3];
        memcpy(points[0], corners[i], sizeof points[0]);
        memcpy(points[1], corners[(i + 1) % count], sizeof points[1]);
        for (int k = 0; slope && k < 2; k++)
            memcpy(slopes[k], slope, sizeof slopes[k]);
        hole_add(&h, 1, points[0], 1, i == 0 && slope ? slopes[0] : NULL);
    }
    const batten_status status =
        batten_surface_fill_sheet(count, h.ribbons, NULL, NULL, &sheet);
    batten_fill_sheet_release(&sheet);
    hole_free(&h);
    return status;
}

TEST(G7_sheets_that_would_fold_or_stand_upright_are_refused_by_name)
{
    static const double dart[4][3] = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0.1}, {0.7, 1, 0}};
    static const double crossed[4][3] = {{0, 0, 0}, {2, 1.5, 0}, {2, 0, 0.3}, {0, 1, 0}};
    static const double wall[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    static const double up[3] = {0, 0.01, 1}, out[3] = {0, -1, 0};
    CHECK_OK(fill_polygon(4, dart, NULL));
    CHECK_STATUS(fill_polygon(4, crossed, NULL), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curves 1 and 3 cross");
    CHECK_STATUS(fill_polygon(4, wall, up), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the tangent plane of the ribbon of curve 1 stands at 89.4 degrees");
    CHECK_STATUS(fill_polygon(4, wall, out), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the ribbon of curve 1 points out of the hole");
    CHECK_STATUS(fill_polygon(1, wall, NULL), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a hole of 1 sides cannot be filled: 2 to 64");
}
