#include "inspect/shapes.h"
#include <batten/measure.h>
#include <batten/standard.h>

/* A limacon r = b + cos(angle) as a periodic spline through many points: with b < 1 it runs
 * around its inner loop too. */
static batten_curve *limacon(double b)
{
    double points[2 * 64], knots[65];
    batten_curve *curve = NULL;
    for (int i = 0; i < 64; i++) {
        const double angle = 2 * PI * i / 64, r = b + cos(angle);
        points[2 * i] = r * cos(angle);
        points[2 * i + 1] = r * sin(angle);
        knots[i] = i;
    }
    knots[64] = 64;
    CHECK_OK(
        batten_curve_create_periodic((batten_points){2, 64, points}, 3, NULL, knots, &curve));
    return curve;
}

TEST(windings_are_counted_around_every_point)
{
    static const struct {
        double x, y;
        int winding;
    } rows[] = {{0.25, 0, 2}, {1, 0, 1}, {0.7, 0.6, 1}, {-0.4, 0, 0}, {3, 0, 0}, {1, 5, 0}};
    batten_curve *curve = limacon(0.5), *back = NULL;
    double turns;
    CHECK_OK(batten_curve_reverse(curve, &back));
    for (int i = 0; i < COUNT(rows); i++) {
        int winding = 7;
        const double at[2] = {rows[i].x, rows[i].y};
        CHECK_OK(batten_curve_winding(curve, (batten_vec2){at[0], at[1]}, 1e-9, &winding));
        CHECK_INT(winding, rows[i].winding);
        CHECK_OK(batten_curve_winding(back, (batten_vec2){at[0], at[1]}, 1e-9, &winding));
        CHECK_INT(winding, -rows[i].winding);
    }
    CHECK_OK(batten_curve_turning(curve, 1e-9, &turns));
    CHECK_NEAR(turns, 2, 1e-12);
    CHECK_OK(batten_curve_turning(back, 1e-9, &turns));
    CHECK_NEAR(turns, -2, 1e-12);
    batten_curve_unref(back);
    batten_curve_unref(curve);
}

TEST(a_ray_through_corners_and_along_edges_counts_right)
{
    /* A square on its corner and one on its edge: the ray runs through a corner, or along. */
    const double diamond[10] = {1, 0, 0, 1, -1, 0, 0, -1, 1, 0};
    const double square[10] = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0};
    batten_curve *a = NULL, *b = NULL;
    int winding;
    CHECK_OK(batten_curve_polyline((batten_points){2, 5, diamond}, &a));
    CHECK_OK(batten_curve_polyline((batten_points){2, 5, square}, &b));
    const double inside[2] = {0, 0}, outside[2] = {-2, 0}, beside[2] = {-1, 1},
                 on[2] = {0.5, 1};
    CHECK_OK(batten_curve_winding(a, (batten_vec2){inside[0], inside[1]}, 0, &winding));
    CHECK_INT(winding, 1);
    CHECK_OK(batten_curve_winding(a, (batten_vec2){outside[0], outside[1]}, 0, &winding));
    CHECK_INT(winding, 0);
    CHECK_OK(batten_curve_winding(b, (batten_vec2){beside[0], beside[1]}, 0, &winding));
    CHECK_INT(winding, 0);
    winding = 7;
    CHECK_STATUS(batten_curve_winding(b, (batten_vec2){on[0], on[1]}, 0, &winding),
                 BATTEN_SINGULAR_HERE);
    CHECK_INT(winding, 7);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(open_curves_turn_by_the_angle_of_their_ends)
{
    /* A third of a circle, and a cubic whose end directions are known. */
    const double points[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    batten_curve *arc = NULL, *cubic = NULL;
    double turns;
    CHECK_OK(batten_curve_ellipse(2, 2, 0, 2 * PI / 3, &arc));
    CHECK_OK(batten_curve_turning(arc, 1e-9, &turns));
    CHECK_NEAR(turns, 1 / 3.0, 1e-14);
    CHECK_OK(shape_bezier(2, 3, points, &cubic));
    CHECK_OK(batten_curve_turning(cubic, 1e-9, &turns));
    CHECK_NEAR(turns, 0.5, 1e-14);
    batten_curve_unref(cubic);
    batten_curve_unref(arc);
}

TEST(G3_at_a_cusp_there_is_no_turning_number)
{
    const double cusp[8] = {0, 0, 1, 1, 0, 1, 1, 0}, there[6] = {0, 0, 1, 0, 0, 0};
    batten_curve *curve = NULL, *back = NULL, *space = NULL;
    double turns = 7;
    batten_parameters still = {0, NULL};
    CHECK_OK(shape_bezier(2, 3, cusp, &curve));
    CHECK_STATUS(batten_curve_turning(curve, 0, &turns), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("cusp near u = 0.5");
    CHECK_OK(batten_curve_standstills(curve, &still));
    CHECK_INT(still.count, 1);
    CHECK_NEAR(still.at[0], 0.5, 1e-14);
    batten_release(still.at);
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, there}, &back));
    CHECK_STATUS(batten_curve_turning(back, 0, &turns), BATTEN_SINGULAR_HERE);
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_STATUS(batten_curve_turning(space, 0, &turns), BATTEN_NOT_COMPATIBLE);
    CHECK_NEAR(turns, 7, 0);
    batten_curve_unref(space);
    batten_curve_unref(back);
    batten_curve_unref(curve);
}

TEST(flat_points_are_inflections_touching_places_and_ends_of_straight_pieces)
{
    /* y = x^4 touches its tangent at 0, y = x^3 crosses it. */
    const double quartic[10] = {-1, 1, -0.5, -1, 0, 1, 0.5, -1, 1, 1};
    const double cubic[8] = {-1, -1, -1 / 3.0, 1, 1 / 3.0, -1, 1, 1};
    const double straight[12] = {0, 0, 1, 0, 2, 0, 3, 0, 4, 1, 4, 2};
    const double knots[10] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    batten_curve *curve = NULL, *space = NULL;
    batten_parameters at = {0, NULL};
    CHECK_OK(shape_bezier(2, 4, quartic, &curve));
    CHECK_OK(batten_curve_flat_points(curve, &at));
    CHECK_INT(at.count, 1);
    CHECK_NEAR(at.at[0], 0.5, 1e-7);
    batten_release(at.at);
    CHECK_OK(batten_curve_to_dimension(curve, 3, &space));
    CHECK_OK(batten_curve_flat_points(space, &at));
    CHECK_INT(at.count, 1);
    CHECK_NEAR(at.at[0], 0.5, 1e-4);
    batten_release(at.at);
    batten_curve_unref(space);
    batten_curve_unref(curve);
    CHECK_OK(shape_bezier(2, 3, cubic, &curve));
    CHECK_OK(batten_curve_flat_points(curve, &at));
    CHECK_INT(at.count, 1);
    CHECK_NEAR(at.at[0], 0.5, 1e-14);
    batten_release(at.at);
    CHECK_OK(batten_curve_standstills(curve, &at));
    CHECK_INT(at.count, 0);
    batten_release(at.at);
    batten_curve_unref(curve);
    CHECK_OK(batten_curve_create((batten_points){2, 6, straight}, 3, NULL, knots, &curve));
    CHECK_OK(batten_curve_flat_points(curve, &at)); /* straight on [0, 1] */
    CHECK_INT(at.count, 2);
    CHECK(at.at[0] == 0 && at.at[1] == 1);
    batten_release(at.at);
    batten_curve_unref(curve);
}
