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
