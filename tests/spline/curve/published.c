/* Curves of other programs' tests: NURBS-Python, verb, tinyspline, pySpline, bezier, openNURBS.
 */
#include <batten/curve.h>
#include <batten/measure.h>
#include <batten/standard.h>

#include "spline/spline.h"
#include "support/json.h"

static batten_curve *curve_of(int dimension, int degree, int count, const double *points,
                              const double *weights, const double *knots)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){dimension, count, points}, degree, weights,
                                 knots, &curve));
    return curve;
}

static void check_point(const batten_curve *curve, double u, int order, const double *expected,
                        double tolerance)
{
    const int d = batten_curve_dimension(curve);
    double out[8 * 3];
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    for (int k = 0; k < d; k++)
        CHECK_NEAR(out[order * d + k], expected[k], tolerance);
}

/* ---- The NURBS Book, pages 68 to 72 ---- */

TEST(basis_functions_of_the_nurbs_book_are_reproduced)
{
    const char *text = json_file("peer_tests/nurbs_basics.json");
    double U[16], numbers[32];
    const int p = (int)json_number(json_key(text, "degree"));
    const int n = json_numbers(json_key(text, "knots"), 16, U) - p - 1;
    const int spans = json_numbers(json_key(text, "span"), 32, numbers) / 2;
    for (int i = 0; i < spans; i++)
        CHECK_INT(bat_knots_span(p, n, U, numbers[2 * i], BATTEN_FROM_RIGHT),
                  (int)numbers[2 * i + 1]);
    const int times = json_numbers(json_key(text, "multiplicity"), 32, numbers) / 2;
    for (int i = 0; i < times; i++)
        CHECK_INT(bat_knots_multiplicity(p, n, U, numbers[2 * i]), (int)numbers[2 * i + 1]);
    const char *basis = json_key(text, "basis_derivatives");
    const double u = json_number(json_key(basis, "u"));
    double out[9];
    CHECK_INT(json_numbers(json_key(basis, "values"), 32, numbers), 9);
    bat_basis(p, U, bat_knots_span(p, n, U, u, BATTEN_FROM_RIGHT), u, 2, out);
    for (int i = 0; i < 9; i++)
        CHECK_NEAR(out[i], numbers[i], 1e-15);
}

TEST(points_of_verbs_curves_are_reproduced)
{
    const char *cases = json_key(json_file("peer_tests/nurbs_basics.json"), "curve_point");
    for (int c = 0; json_item(cases, c); c++) {
        const char *one = json_item(cases, c);
        double U[16], P[32], u[8], expected[16];
        json_numbers(json_key(one, "knots"), 16, U);
        const int n = json_numbers(json_key(one, "points"), 32, P) / 2;
        const int places = json_numbers(json_key(one, "u"), 8, u);
        CHECK_INT(json_numbers(json_key(one, "expected"), 16, expected), 2 * places);
        batten_curve *curve =
            curve_of(2, (int)json_number(json_key(one, "degree")), n, P, NULL, U);
        for (int i = 0; i < places; i++)
            check_point(curve, u[i], 0, expected + 2 * i, 1e-14 * 80);
        batten_curve_unref(curve);
    }
}

/* ---- NURBS-Python, to 3 or 4 decimals; some were cut off where others were rounded ---- */

static batten_curve *geomdl_curve(const char *module, const char *name)
{
    const char *object = json_key(json_key(module, "objects"), name);
    double P[64], w[16], U[32];
    const int d = (int)json_number(json_key(object, "dimension"));
    const int n = json_numbers(json_key(object, "ctrlpts"), 64, P) / d;
    const char *weights = json_try(object, "weights");
    if (weights)
        CHECK_INT(json_numbers(weights, 16, w), n);
    json_numbers(json_key(object, "knotvector"), 32, U);
    return curve_of(d, (int)json_number(json_key(object, "degree")), n, P, weights ? w : NULL,
                    U);
}

TEST(points_of_nurbs_pythons_curves_are_reproduced)
{
    static const char *const pairs[][2] = {
        {"spline_curve", "test_bspline_curve2d_eval"},
        {"nurbs_curve", "test_nurbs_curve2d_eval"},
        {"spline_curve_kv_norm1", "test_bspline_curve2d_eval_kv_norm1"},
        {"spline_curve_kv_norm2", "test_bspline_curve2d_eval_kv_norm2"}};
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_curve");
    for (int c = 0; c < COUNT(pairs); c++) {
        batten_curve *curve = geomdl_curve(module, pairs[c][0]);
        const char *rows = json_key(json_key(json_key(module, "cases"), pairs[c][1]), "rows");
        double row[3];
        for (int i = 0; json_item(rows, i); i++) {
            CHECK_INT(json_numbers(json_item(rows, i), 3, row), 3);
            check_point(curve, row[0], 0, row + 1, 1e-3);
        }
        batten_curve_unref(curve);
    }
}

TEST(derivatives_of_nurbs_pythons_rational_curve_are_reproduced)
{
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_curve");
    const char *rows =
        json_key(json_key(json_key(module, "cases"), "test_nurbs_curve2d_deriv"), "rows");
    batten_curve *curve = geomdl_curve(module, "nurbs_curve");
    for (int i = 0; json_item(rows, i); i++) {
        double row[16] = {0};
        const int order = json_numbers(json_item(rows, i), 16, row) / 2 - 2;
        CHECK_INT(order, (int)row[1]);
        for (int k = 0; k <= order; k++)
            check_point(curve, row[0], k, row + 2 + 2 * k, 0.6e-3);
    }
    batten_curve_unref(curve);
}

/* The same points before and after; what was inserted can be removed again without error. */
TEST(knots_of_nurbs_pythons_curve_are_inserted_and_removed)
{
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_curve");
    const char *cases = json_key(module, "cases");
    const char *inserts = json_key(json_key(cases, "test_bspline_curve2d_insert_knot"), "rows");
    const char *removes = json_key(json_key(cases, "test_bspline_curve2d_remove_knot"), "rows");
    batten_curve *curve = geomdl_curve(module, "spline_curve");
    double row[4], error = 1;
    int removed = 0;
    for (int i = 0; json_item(inserts, i); i++) {
        batten_curve *more = NULL;
        CHECK_INT(json_numbers(json_item(inserts, i), 4, row), 4);
        CHECK_OK(batten_curve_insert_knot(curve, row[0], (int)row[1], &more));
        CHECK_INT(batten_curve_point_count(more), 6 + (int)row[1]);
        check_point(more, row[0], 0, row + 2, 0.6e-3);
        batten_curve_unref(more);
    }
    for (int i = 0; json_item(removes, i); i++) {
        batten_curve *more = NULL, *again = NULL;
        CHECK_INT(json_numbers(json_item(removes, i), 4, row), 2);
        CHECK_OK(batten_curve_insert_knot(curve, row[0], (int)row[1], &more));
        CHECK_OK(batten_curve_remove_knot(more, (batten_knot){row[0], (int)row[1]}, 1e-12,
                                          &removed, &error, &again));
        CHECK_INT(removed, (int)row[1]);
        CHECK_INT(batten_curve_point_count(again), 6);
        for (int k = 0; k < 12; k++)
            CHECK_NEAR(batten_curve_points(again)[k], batten_curve_points(curve)[k], 1e-12);
        batten_curve_unref(more);
        batten_curve_unref(again);
    }
    batten_curve_unref(curve);
}

/* Its refinement fills every span's middle and every inner knot up to degree times. */
TEST(nurbs_pythons_refinement_is_one_of_ours)
{
    const char *module = json_key(json_file("peer_tests/geomdl_cases.json"), "test_curve");
    const char *rows = json_key(
        json_key(json_key(module, "cases"), "test_bspline_curve2d_knot_refine"), "rows");
    batten_curve *curve = geomdl_curve(module, "spline_curve"), *fine = NULL;
    const double *U = batten_curve_knots(curve);
    double wanted[32], added[32], at[2];
    const int count = json_numbers(json_item(rows, 1), 32, wanted) - 1;
    int missing = 0, old = 0;
    for (int i = 1; i <= count; i++)
        if (old < 10 && wanted[i] == U[old])
            old++;
        else
            added[missing++] = wanted[i];
    CHECK_INT(old, 10);
    CHECK_OK(batten_curve_refine(curve, missing, added, &fine));
    CHECK_INT(batten_curve_knot_count(fine), count);
    for (int i = 0; i < count; i++)
        CHECK_BITS(batten_curve_knots(fine)[i], wanted[i + 1]);
    for (int i = 0; i <= 50; i++) {
        CHECK_OK(batten_curve_evaluate(curve, i / 50.0, 0, at));
        check_point(fine, i / 50.0, 0, at, 1e-13);
    }
    batten_curve_unref(curve);
    batten_curve_unref(fine);
}

/* ---- tinyspline ---- */

TEST(points_of_tinysplines_clamped_curves_are_reproduced)
{
    const char *cases = json_key(json_file("peer_tests/tinyspline_eval.json"), "cases");
    for (int c = 0; json_item(cases, c); c++) {
        const char *one = json_item(cases, c), *u = json_key(one, "u");
        double P[32], U[32], expected[4];
        if (!json_is(json_key(one, "type"), "TS_CLAMPED"))
            continue;
        const int p = (int)json_number(json_key(one, "degree"));
        const int n = json_numbers(json_key(one, "points"), 32, P) / 2;
        for (int i = 0; i <= n + p; i++)
            U[i] = i <= p ? 0 : i >= n ? 1 : (double)(i - p) / (n - p);
        batten_curve *curve = curve_of(2, p, n, P, NULL, U);
        CHECK_INT(json_numbers(json_key(one, "expected"), 4, expected), 2);
        check_point(curve,
                    json_is(u, "min")   ? 0
                    : json_is(u, "max") ? 1
                                        : json_number(u),
                    0, expected, 0.6e-6);
        batten_curve_unref(curve);
    }
}

/* tinyspline lets a knot stand degree + 1 times inside and then has two points there. For us
 * these are two curves: the one is refused, and the points are the ends of the two. */
TEST(k4_tinysplines_curve_of_two_parts_is_two_curves)
{
    const char *cases = json_key(json_file("peer_tests/tinyspline_eval.json"), "cases");
    int found = 0;
    for (int c = 0; json_item(cases, c); c++) {
        const char *one = json_item(cases, c);
        if (!json_is(json_key(one, "type"), "TS_BEZIERS"))
            continue;
        const double U[] = {0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1};
        double P[16], expected[4];
        batten_curve *whole = NULL;
        CHECK_INT(json_numbers(json_key(one, "points"), 16, P), 16);
        CHECK_INT(json_numbers(json_key(one, "expected"), 4, expected), 4);
        CHECK_STATUS(batten_curve_create((batten_points){2, 8, P}, 3, NULL, U, &whole),
                     BATTEN_BAD_KNOTS);
        batten_curve *first = curve_of(2, 3, 4, P, NULL, U);
        batten_curve *second = curve_of(2, 3, 4, P + 8, NULL, U + 4);
        check_point(first, 0.5, 0, expected, 0);
        check_point(second, 0.5, 0, expected + 2, 0);
        batten_curve_unref(first);
        batten_curve_unref(second);
        found++;
    }
    CHECK_INT(found, 1);
}

/* ---- pySpline ---- */

static int pyspline_expects(const char *expected, const char *curve, const char *what,
                            double at, double *out)
{
    char key[96];
    if (at >= 0)
        snprintf(key, sizeof key, "%s %s evaluated at %s", curve, what,
                 at == 0.5    ? "0.5"
                 : at == 0.75 ? "0.75"
                 : at == 0    ? "0.0"
                              : "1.0");
    else
        snprintf(key, sizeof key, "%s %s", curve, what);
    return json_numbers(json_key(expected, key), 3, out);
}

static void check_pyspline(const char *expected, const char *name, const batten_curve *curve)
{
    static const char *const orders[] = {"curve", "curve derivative",
                                         "curve second derivative"};
    const double at[] = {0, 0.5, 0.75, 1};
    for (int i = 0; i < COUNT(at); i++)
        for (int k = 0; k < 3; k++) {
            double values[3];
            pyspline_expects(expected, name, orders[k], at[i], values);
            check_point(curve, at[i], k, values, 1e-12);
        }
}

/* What pySpline calls the length is that of the polygon through the points at the Greville
 * abscissae: right for a polygon alone, else too short. */
static void check_length(const batten_curve *curve, double wanted)
{
    double length = 0, sum = 0, before[3], after[3];
    CHECK_OK(batten_curve_length(curve, 1e-10, NULL, &length));
    CHECK_OK(batten_curve_evaluate(curve, batten_curve_greville(curve, 0), 0, before));
    for (int i = 1; i < batten_curve_point_count(curve); i++) {
        CHECK_OK(batten_curve_evaluate(curve, batten_curve_greville(curve, i), 0, after));
        sum += hypot(after[0] - before[0], after[1] - before[1]);
        memcpy(before, after, sizeof before);
    }
    CHECK_NEAR(sum, wanted, 1e-12);
    if (batten_curve_degree(curve) == 1)
        CHECK_NEAR(length, wanted, 1e-12);
    else
        CHECK(length > wanted + 0.1);
}

TEST(curves_of_pyspline_with_given_knots_are_reproduced)
{
    const char *text = json_file("peer_tests/pyspline_curves.json");
    const char *expected = json_key(text, "expected");
    for (int k = 2; k <= 4; k++) { /* its order */
        char name[20], full[48];
        double U[16], P[16], wanted[3];
        snprintf(name, sizeof name, "2D k=%d", k);
        const char *input = json_key(json_key(text, "inputs"), name);
        json_numbers(json_key(input, "knots"), 16, U);
        const int n = json_numbers(json_key(input, "points"), 16, P) / 2;
        batten_curve *curve = curve_of(2, k - 1, n, P, NULL, U), *more = NULL;
        snprintf(full, sizeof full, "%s initial", name);
        check_pyspline(expected, full, curve);
        CHECK_OK(batten_curve_insert_knot(curve, 0.25, k - 1, &more));
        snprintf(full, sizeof full, "%s inserted knots", name);
        check_pyspline(expected, full, more);
        pyspline_expects(expected, name, "curve length", -1, wanted);
        check_length(curve, wanted[0]);
        batten_curve_unref(curve);
        batten_curve_unref(more);
    }
}

/* ---- bezier ---- */

/* Each curve fulfils its implicit equation, a sum of c x^i y^j: a truth of algebra. */
TEST(bezier_curves_fulfil_their_implicit_equations)
{
    const char *curves = json_file("peer_tests/bezier_curves.json");
    const char *nested = json_try(curves, "curves");
    int checked = 0;
    curves = nested ? nested : curves;
    for (int c = 1; c <= 80; c++) {
        char key[12];
        double xy[32], P[32], terms[64];
        snprintf(key, sizeof key, "%d", c);
        const char *one = json_try(curves, key);
        const char *equation = one ? json_try(one, "implicitized") : NULL;
        if (!equation)
            continue;
        const int n = json_numbers(json_key(one, "control_points"), 32, xy) / 2;
        const int count = json_numbers(equation, 64, terms) / 3;
        const double breaks[] = {0, 1};
        batten_curve *curve = NULL;
        for (int i = 0; i < n; i++)
            P[2 * i] = xy[i], P[2 * i + 1] = xy[n + i];
        CHECK_OK(
            batten_curve_from_bezier(2, (batten_pieces){n - 1, 1, breaks}, P, NULL, &curve));
        for (int i = 0; i <= 32; i++) {
            double at[2], sum = 0, size = 0;
            CHECK_OK(batten_curve_evaluate(curve, i / 32.0, 0, at));
            for (int t = 0; t < count; t++) {
                const double term =
                    terms[3 * t] * pow(at[0], terms[3 * t + 1]) * pow(at[1], terms[3 * t + 2]);
                sum += term;
                size += fabs(term);
            }
            CHECK_NEAR(sum, 0, 1e-13 * size + 1e-15);
        }
        batten_curve_unref(curve);
        checked++;
    }
    CHECK(checked > 30);
}

/* Curve 25 crosses itself at (22/27, 17/18) where the parameters are (-1 +- sqrt 33) / 6: the
 * negative one lies outside, so the segment does not. */
TEST(beziers_curve_25_crosses_itself_where_its_file_says)
{
    const char *curves = json_file("peer_tests/bezier_curves.json");
    const char *nested = json_try(curves, "curves");
    double xy[8], P[8], U[] = {0, 0, 0, 0, 1, 1, 1, 1};
    json_numbers(json_key(json_key(nested ? nested : curves, "25"), "control_points"), 8, xy);
    for (int i = 0; i < 4; i++)
        P[2 * i] = xy[i], P[2 * i + 1] = xy[4 + i];
    batten_curve *curve = curve_of(2, 3, 4, P, NULL, U);
    const double crossing[] = {22.0 / 27, 17.0 / 18};
    check_point(curve, (-1 + sqrt(33)) / 6, 0, crossing, 1e-14);
    batten_curve_unref(curve);
}

/* ---- openNURBS ---- */

/* The JSON has no control points, so only lines and circles, which their samples determine, can
 * be made without reading the files; both run by length. */
TEST(lines_and_circles_of_opennurbs_have_its_points)
{
    const char *objects =
        json_key(json_file("peer_tests/rhino3dm_evaluation.json"), "my_curves.3dm");
    int lines = 0, circles = 0;
    for (int o = 0; json_item(objects, o); o++) {
        const char *one = json_item(objects, o), *samples = json_key(one, "samples");
        double t[5], p[5][3];
        for (int i = 0; i < 5; i++) {
            t[i] = json_number(json_key(json_item(samples, i), "t"));
            json_numbers(json_key(json_item(samples, i), "p"), 3, p[i]);
        }
        batten_curve *curve = NULL;
        double u[5];
        if (json_is(json_key(one, "type"), "LineCurve")) {
            CHECK_OK(batten_curve_line(3, p[0], p[4], &curve));
            CHECK_OK(batten_curve_at_length(curve, 5, t, 1e-12, u));
            for (int i = 0; i < 5; i++)
                check_point(curve, u[i], 0, p[i], 1e-12);
            lines++;
        } else if (json_is(json_key(one, "type"), "ArcCurve")) {
            const double radius = (p[0][0] - p[2][0]) / 2;
            CHECK_NEAR(t[4], 4 * acos(0) * radius, 1e-12);
            CHECK_OK(batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &curve));
            CHECK_OK(batten_curve_at_length(curve, 5, t, 1e-12, u));
            for (int i = 0; i < 5; i++) {
                const double at[] = {p[i][0] - (p[0][0] + p[2][0]) / 2, p[i][1] - p[0][1]};
                check_point(curve, u[i], 0, at, 1e-10);
            }
            circles++;
        }
        batten_curve_unref(curve);
    }
    CHECK(lines == 1 && circles == 2);
}
