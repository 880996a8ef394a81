/* Curves as the surface of a network runs along them. */
#include "shape/network/gordon.h"

#include "support/test.h"

/* A cubic with a corner at s = 0.5. */
static const double bent[7][3] = {{0, 0, 0},     {1, 2, 0}, {2, 0, 1}, {3, 1, 0},
                                  {3.5, 0, 0.5}, {5, 1, 0}, {6, 0, 2}};
static const double halves[3] = {0, 0.5, 1};

static batten_curve *bezier(int dimension, int degree, int pieces, const double *breaks,
                            const double *points)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(dimension, (batten_pieces){degree, pieces, breaks},
                                      points, NULL, &curve));
    return curve;
}

static void check_spans(const batten_curve *curve, int count, const double *breaks)
{
    double found[16];
    CHECK_INT(batten_curve_degree(curve), 3);
    CHECK_INT(batten_curve_spans(curve, NULL), count);
    batten_curve_spans(curve, found);
    for (int i = 0; i < count; i++)
        CHECK_NEAR(found[i], breaks[i], 1e-15);
}

TEST(a_cubic_without_a_map_is_redrawn_exactly_with_breaks_at_knots_and_nodes)
{
    static const double nodes[3] = {0, 0.3, 1}, breaks[4] = {0, 0.3, 0.5, 1};
    batten_curve *curve = bezier(3, 3, 2, halves, bent[0]), *made = NULL;
    const bat_network_curve source = {.curve = curve};
    CHECK_OK(bat_network_redraw(&source, 3, nodes, 1e-9, &made));
    check_spans(made, 4, breaks);
    for (int k = 0; k <= 40; k++) {
        double p[6], q[6];
        CHECK_OK(batten_curve_evaluate(curve, k / 40.0, 1, p));
        CHECK_OK(batten_curve_evaluate(made, k / 40.0, 1, q));
        for (int c = 0; c < 6; c++)
            CHECK_NEAR(q[c], p[c], 2e-14);
    }
    batten_curve_unref(made);
    batten_curve_unref(curve);
}

/* s = (u + u^2) / 2 is 0.5 at the golden ratio. */
static const double golden = 0.6180339887498949;
static const double rising[3] = {0, 0.25, 1};

TEST(a_curve_is_redrawn_along_its_map_within_the_tolerance_and_keeps_its_corner)
{
    static const double nodes[3] = {0, 0.4, 1};
    double at[3] = {0, 0.28, 1}, tolerance = 1e-4;
    batten_curve *curve = bezier(3, 3, 2, halves, bent[0]),
                 *map = bezier(1, 2, 1, (double[2]){0, 1}, rising);
    const bat_network_curve source = {.curve = curve, .map = map, .at = at};
    for (int round = 0; round < 3; round++, tolerance /= 100) {
        batten_curve *made = NULL;
        CHECK_OK(bat_network_redraw(&source, 3, nodes, tolerance, &made));
        double worst = 0, p[6], q[6];
        for (int k = 0; k <= 400; k++) {
            const double u = k / 400.0;
            CHECK_OK(batten_curve_evaluate(curve, (u + u * u) / 2, 0, p));
            CHECK_OK(batten_curve_evaluate(made, u, 0, q));
            for (int c = 0; c < 3; c++)
                worst = fmax(worst, fabs(p[c] - q[c]));
        }
        CHECK(worst <= tolerance);
        /* The node and the corner are breaks, and both tangents of the corner are kept. */
        double spans[400];
        const int count = batten_curve_spans(made, spans);
        bool found[2] = {false, false};
        for (int i = 0; i < count; i++) {
            found[0] = found[0] || spans[i] == 0.4;
            found[1] = found[1] || fabs(spans[i] - golden) < 1e-15;
        }
        CHECK(found[0] && found[1]);
        for (int side = 0; side < 2; side++) {
            const batten_side from = side ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
            CHECK_OK(batten_curve_evaluate_side(curve, 0.5, from, 1, p));
            CHECK_OK(batten_curve_evaluate_side(made, golden, from, 1, q));
            for (int c = 3; c < 6; c++)
                CHECK_NEAR(q[c], p[c] * (0.5 + golden), 1e-12);
        }
        batten_curve_unref(made);
    }
    batten_curve_unref(map);
    batten_curve_unref(curve);
}

TEST(a_knot_at_a_node_has_the_parameter_of_the_node)
{
    static const double nodes[3] = {0, 0.7, 1};
    double at[3] = {0, 0.5, 1};
    const double thirds[4] = {0, 1.4 / 3, 2.1 / 3, 1}, ends[2] = {0, 1};
    batten_curve *curve = bezier(3, 3, 2, halves, bent[0]),
                 *map = bezier(1, 3, 1, ends, thirds), *made = NULL;
    const bat_network_curve source = {.curve = curve, .map = map, .at = at};
    CHECK_OK(bat_network_redraw(&source, 3, nodes, 10, &made));
    check_spans(made, 4 - 1, (double[3]){0, 0.7, 1});
    batten_curve_unref(made);
    batten_curve_unref(map);
    batten_curve_unref(curve);
}

/* s = 8 u at first: what is 4e-12 apart there is 5e-13 apart along the surface. */
TEST(stretches_too_short_to_be_drawn_are_left_out_and_all_of_the_domain_is_kept)
{
    static const double steep[4] = {0, 8 / 3.0, 1, 1}, ends[2] = {0, 1};
    static const double rows[2][2] = {{0, 4e-12}, {4e-12, 8e-12}};
    for (int i = 0; i < 2; i++) {
        const double breaks[4] = {0, rows[i][1], 0.75, 1}, nodes[3] = {0, rows[i][0] / 8, 1};
        double at[3] = {0, rows[i][0], 1}, points[10][3] = {{0}};
        for (int k = 1; k < 10; k++)
            points[k][0] = k < 3 ? 1e-12 * k : k;
        batten_curve *curve = bezier(3, 3, 3, breaks, points[0]),
                     *map = bezier(1, 3, 1, ends, steep), *made = NULL;
        const bat_network_curve source = {.curve = curve, .map = map, .at = at};
        CHECK_OK(bat_network_redraw(&source, 3, nodes, 100, &made));
        CHECK(batten_curve_domain(made).a == 0 && batten_curve_domain(made).b == 1);
        batten_curve_unref(made);
        batten_curve_unref(map);
        batten_curve_unref(curve);
    }
}

TEST(N6_a_tolerance_that_no_cubic_reaches_is_refused_with_its_number)
{
    static const double nodes[2] = {0, 1}, ends[2] = {0, 1};
    double at[2] = {0, 1};
    batten_curve *curve = bezier(3, 3, 1, ends, bent[0]), *map = bezier(1, 2, 1, ends, rising),
                 *made = NULL;
    const bat_network_curve source = {.curve = curve, .map = map, .at = at};
    CHECK_STATUS(bat_network_redraw(&source, 2, nodes, 0, &made), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("needs more than 100000 cubic pieces to be reparametrised within 0");
    CHECK(!made);
    batten_curve_unref(map);
    batten_curve_unref(curve);
}
