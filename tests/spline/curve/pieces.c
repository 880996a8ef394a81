#include "spline/curve/curve.h"

#include "support/generate.h"

TEST(pieces_are_found_as_spans_are)
{
    test_random random = test_random_begin(__func__);
    const test_wish any = {0};
    for (int i = 0; i < test_cases(300); i++) {
        batten_curve *curve = test_curve(&random, &any);
        const bat_pieces *pieces = bat_curve_pieces(curve, 1000);
        for (int k = 0; pieces && k < 30; k++) {
            const double u = test_parameter(&random, curve);
            const int span =
                bat_knots_span(curve->degree, curve->count, curve->knots, u, BATTEN_FROM_RIGHT);
            CHECK_INT(bat_pieces_find(pieces, curve->degree, u).knot, span);
            int index = 0;
            bat_pieces_locate(pieces, 1, &u, &index);
            CHECK_INT(index < 0 ? span : pieces->spans[index], span);
        }
        CHECK(!pieces || bat_curve_pieces(curve, 0) == pieces);
        batten_curve_unref(curve);
    }
}

TEST(geometric_spans_are_found)
{
    double knots[62], points[60] = {0};
    for (int i = 0; i < 60; i++)
        knots[i + 1] = ldexp(1, i);
    knots[0] = knots[1];
    knots[61] = knots[60];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 60, points}, 1, NULL, knots, &curve));
    const bat_pieces *pieces = bat_curve_pieces(curve, 1000);
    for (int i = 0; pieces && i < 59; i++) {
        CHECK_INT(bat_pieces_find(pieces, 1, ldexp(1, i)).knot, i + 1);
        CHECK_INT(bat_pieces_find(pieces, 1, ldexp(1.99, i)).knot, i + 1);
    }
    batten_curve_unref(curve);
}

TEST(rows_of_pieces_are_the_bezier_rows_of_the_curve)
{
    test_random random = test_random_begin(__func__);
    const test_wish any = {.tame = true};
    for (int c = 0; c < test_cases(100); c++) {
        batten_curve *curve = test_curve(&random, &any), *bezier = NULL;
        const bat_pieces *pieces = bat_curve_pieces(curve, 1000);
        const int p = curve->degree, d = curve->dimension;
        CHECK_OK(batten_curve_to_bezier(curve, &bezier));
        const double size = test_curve_size(curve);
        for (int i = 0; pieces && i < pieces->count; i++) {
            const bat_piece piece = bat_pieces_get(pieces, p, i);
            CHECK(piece.a < piece.b);
            for (int j = 0; j <= p; j++) {
                const double *row = piece.rows + (size_t)j * piece.stride;
                const int at = i * p + j;
                for (int k = 0; k < d; k++) {
                    const double w = bezier->weights ? row[d] : 1;
                    CHECK_NEAR(row[k] / w, bezier->points[at * d + k], 1e-9 * (1 + size));
                }
            }
        }
        batten_curve_unref(bezier);
        batten_curve_unref(curve);
    }
}

TEST(parameters_outside_the_pieces_are_located_nowhere)
{
    const double knots[5] = {0, 0, 1, 2, 2}, points[3] = {0, 1, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 1, NULL, knots, &curve));
    const bat_pieces *pieces = bat_curve_pieces(curve, 1000);
    const double u[8] = {-1, 0, 0.5, 1, 2, NAN, 1.5, 0.25};
    const int expected[8] = {-1, 0, 0, 1, -1, -1, 1, 0};
    int index[8];
    if (pieces)
        bat_pieces_locate(pieces, 8, u, index);
    for (int i = 0; pieces && i < 8; i++)
        CHECK_INT(index[i], expected[i]);
    batten_curve_unref(curve);
}

TEST(pieces_are_made_when_enough_places_are_asked_for)
{
    /* 80 spans: less than an eighth of that asks for no table. */
    double knots[82], points[80];
    for (int i = 0; i < 82; i++)
        knots[i] = i;
    for (int i = 0; i < 80; i++)
        points[i] = i % 3;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){1, 80, points}, 1, NULL, knots, &curve));
    CHECK(!bat_curve_pieces(curve, 9));
    const bat_pieces *made = bat_curve_pieces(curve, 10);
    CHECK(!made || made->count == 79);
    CHECK(!made || bat_curve_pieces(curve, 1) == made);
    batten_curve_unref(curve);
}
