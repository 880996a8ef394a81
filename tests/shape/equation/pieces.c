/* Quintic pieces joined to one curve. */
#include "shape/equation/pieces.h"

#include "support/test.h"

#include <batten/curve.h>

/* q(t) = t^5 - 2 t^4 + 3 t^2 - t + 5 and r(t) = 2 t^3 - 7, with two derivatives. */
static void polynomials_at(double t, double out[2][3])
{
    out[0][0] = ((((t - 2) * t + 0) * t + 3) * t - 1) * t + 5;
    out[0][1] = (((5 * t - 8) * t + 0) * t + 6) * t - 1;
    out[0][2] = ((20 * t - 24) * t + 0) * t + 6;
    out[1][0] = 2 * t * t * t - 7;
    out[1][1] = 6 * t * t;
    out[1][2] = 12 * t;
}

static bat_quintic_piece piece_of(double a, double b)
{
    bat_quintic_piece piece = {.a = a, .b = b};
    double l[2][3], r[2][3];
    const double h = b - a;
    polynomials_at(a, l);
    polynomials_at(b, r);
    for (int k = 0; k < 2; k++) {
        piece.leg[0][k] = l[k][0];
        piece.leg[1][k] = l[k][0] + h / 5 * l[k][1];
        piece.leg[2][k] = l[k][0] + 2 * h / 5 * l[k][1] + h * h / 20 * l[k][2];
        piece.leg[3][k] = r[k][0] - 2 * h / 5 * r[k][1] + h * h / 20 * r[k][2];
        piece.leg[4][k] = r[k][0] - h / 5 * r[k][1];
        piece.leg[5][k] = r[k][0];
    }
    return piece;
}

TEST(pieces_of_one_polynomial_join_to_it_with_three_knots_at_each_joint)
{
    static const double ends[][4] = {{0, 0.5, 1.5, 2}, {-1, 1, 1.25, 2}, {0, 1, 2, 3}};
    for (int i = 0; i < COUNT(ends); i++)
        for (int count = 1; count <= 3; count++) {
            bat_quintic_piece pieces[3];
            batten_curve *curve = NULL;
            for (int k = 0; k < count; k++)
                pieces[k] = piece_of(ends[i][k], ends[i][k + 1]);
            for (int k = 1; k < count; k++)
                CHECK(bat_quintics_agree(2, &pieces[k - 1], &pieces[k]));
            CHECK_OK(bat_quintics_joined(2, count, pieces, &curve));
            CHECK_INT(batten_curve_degree(curve), 5);
            CHECK_INT(batten_curve_point_count(curve), 6 + 3 * (count - 1));
            CHECK(batten_curve_domain(curve).a == ends[i][0]);
            CHECK(batten_curve_domain(curve).b == ends[i][count]);
            for (int k = 0; k <= 20; k++) {
                const double t = ends[i][0] + (ends[i][count] - ends[i][0]) * k / 20;
                double p[6], q[2][3];
                polynomials_at(t, q);
                CHECK_OK(batten_curve_evaluate(curve, t, 2, p));
                for (int c = 0; c < 6; c++)
                    CHECK_NEAR(p[c], q[c % 2][c / 2], c < 2 ? 1e-12 : 1e-10);
            }
            batten_curve_unref(curve);
        }
}

/* One Bezier point of one coordinate moved by a thousandth: of the left piece 3 and 4 count, of the right one 1
 * and 2. */
TEST(pieces_disagree_where_a_first_or_second_derivative_jumps_in_any_coordinate)
{
    static const struct {
        int piece, leg;
        bool agree;
    } rows[] = {{0, 2, true},  {0, 3, false}, {0, 4, false},
                {1, 1, false}, {1, 2, false}, {1, 3, true}};
    for (int i = 0; i < COUNT(rows); i++)
        for (int k = 0; k < 2; k++) {
            bat_quintic_piece pieces[] = {piece_of(0, 0.5), piece_of(0.5, 2)};
            batten_curve *curve = NULL;
            pieces[rows[i].piece].leg[rows[i].leg][k] += 1e-3;
            CHECK_INT(bat_quintics_agree(2, &pieces[0], &pieces[1]), rows[i].agree);
            CHECK(k == 0 || bat_quintics_agree(1, &pieces[0], &pieces[1]));
            CHECK_OK(bat_quintics_joined(2, 2, pieces, &curve));
            CHECK_INT(batten_curve_point_count(curve), rows[i].agree ? 9 : 11);
            batten_curve_unref(curve);
        }
}

TEST(rounding_of_bezier_points_is_no_jump)
{
    bat_quintic_piece l = piece_of(0, 0.5), r = piece_of(0.5, 2);
    for (int k = 0; k < 2; k++) {
        l.leg[4][k] *= 1 + 2 * DBL_EPSILON;
        r.leg[1][k] *= 1 - 2 * DBL_EPSILON;
        r.leg[2][k] *= 1 + 2 * DBL_EPSILON;
    }
    CHECK(bat_quintics_agree(2, &l, &r));
    r.leg[1][1] *= 1 + 1e-9;
    CHECK(!bat_quintics_agree(2, &l, &r));
    r = piece_of(0.5, 2);
    r.leg[2][0] *= 1 + 1e-9;
    CHECK(!bat_quintics_agree(2, &l, &r));
}

TEST(a_joint_with_a_chord_has_five_knots_and_all_points_of_both_sides)
{
    bat_quintic_piece pieces[] = {piece_of(0, 1), piece_of(1, 2), piece_of(2, 3)};
    batten_curve *curve = NULL;
    pieces[1].is_chord = true;
    CHECK(!bat_quintics_agree(2, &pieces[0], &pieces[1]));
    CHECK(!bat_quintics_agree(2, &pieces[1], &pieces[2]));
    CHECK_OK(bat_quintics_joined(2, 3, pieces, &curve));
    CHECK_INT(batten_curve_point_count(curve), 16);
    const double *points = batten_curve_points(curve), *knots = batten_curve_knots(curve);
    for (int i = 0; i < 16; i++)
        for (int k = 0; k < 2; k++)
            CHECK(points[2 * i + k] == pieces[i < 15 ? i / 5 : 2].leg[i < 15 ? i % 5 : 5][k]);
    for (int i = 0; i < 22; i++)
        CHECK(knots[i] == (i < 6 ? 0 : i < 11 ? 1 : i < 16 ? 2 : 3));
    batten_curve_unref(curve);
}

TEST(a_list_of_results_keeps_what_was_added_in_order_and_is_empty_when_released)
{
    batten_equation_curves all = {0};
    const double line[] = {0, 0, 1, 1}, knots[] = {0, 0, 1, 1};
    batten_curve *curves[2] = {NULL, NULL};
    for (int i = 0; i < 2; i++) {
        CHECK_OK(batten_curve_create((batten_points){2, 2, line}, 1, NULL, knots, &curves[i]));
        CHECK_OK(bat_equation_add_curve(&all, curves[i]));
        CHECK_OK(bat_equation_add_point(
            &all, (batten_equation_point){BATTEN_EQUATION_NODE, {i, 2, 3}, 4, 5}));
    }
    CHECK_INT(all.count, 2);
    CHECK_INT(all.point_count, 2);
    for (int i = 0; i < 2; i++)
        CHECK(all.curves[i] == curves[i] && all.points[i].point.x == i);
    batten_equation_curves_release(&all);
    CHECK(all.count == 0 && all.point_count == 0 && !all.curves && !all.points);
}
