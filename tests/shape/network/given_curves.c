/* The curves of a network as they are given. */
#include "shape/network/gordon.h"
#include <batten/standard.h>

#include "support/test.h"

static batten_curve *make_line(int dimension, const double *ends)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(dimension, ends, ends + dimension, &curve));
    return curve;
}

TEST(curves_are_called_by_kind_number_and_name_and_poles_by_the_other_kind)
{
    static const char *const names[3] = {"keel", "rib", "deck"};
    bat_network net = {.family = {{.what = "profile", .given = 4},
                                  {.what = "guide", .given = 3, .names = names}}};
    const bat_network_curve pole = {.index = -1}, third = {.index = 2};
    char label[BAT_NETWORK_LABEL];
    CHECK_TEXT(bat_network_label(&net, 0, &third, label), "profile 3");
    CHECK_TEXT(bat_network_label(&net, 1, &third, label), "guide 'deck' (3 of 3)");
    CHECK_TEXT(bat_network_label(&net, 0, &pole, label), "the pole of the guides");
    CHECK_TEXT(bat_network_label(&net, 1, &pole, label), "the pole of the profiles");
}

static const struct {
    double a[6], b[6], scale;
    batten_status status;
    const char *message;
} scales[] = {
    {{0, 0, 0, 3, 0, 0}, {0, -5, 0, 0, 0, 0}, 1.0 / 4, BATTEN_OK, ""},
    {{0, 0, 0.75, 0, 0, 0.5}, {0, 0, 0, 0.1, 0, 0}, 2, BATTEN_OK, ""},
    {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 1, 1, 1}, 1, BATTEN_OK, ""},
    {{7, 7, 7, 7, 7, 7},
     {7, 7, 7, 7, 7, 7},
     0,
     BATTEN_COINCIDENT,
     "all curves of the network are one point"},
};

TEST(the_scale_is_the_power_of_two_that_brings_the_largest_coordinate_to_1_or_more)
{
    for (int i = 0; i < COUNT(scales); i++) {
        batten_curve *a = make_line(3, scales[i].a), *b = make_line(3, scales[i].b);
        const batten_curve *const both[2] = {a, b};
        double scale = 0;
        CHECK_STATUS(bat_network_scale(2, both, &scale), scales[i].status);
        CHECK_NEAR(scale, scales[i].scale, 0);
        if (scales[i].status != BATTEN_OK)
            CHECK_MESSAGE(scales[i].message);
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
    batten_curve *line = make_line(2, (double[4]){0, 0, 1, 1}),
                 *function = make_line(1, (double[2]){0, 1});
    const batten_curve *const both[2] = {line, function};
    double scale = 0;
    CHECK_STATUS(bat_network_scale(2, both, &scale), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("curve 2 of the network is a function");
    batten_curve_unref(line);
    batten_curve_unref(function);
}

TEST(the_size_of_a_network_is_the_diagonal_of_the_box_of_all)
{
    batten_curve *a = make_line(3, (double[6]){0, 0, 0, 2, 0, 0}),
                 *b = make_line(3, (double[6]){1, 3, 0, 1, 0, -6});
    const batten_curve *const both[2] = {a, b};
    CHECK_NEAR(batten_network_size(2, both), 7, 1e-15);
    batten_curve_unref(a);
    batten_curve_unref(b);
}

TEST(a_taken_curve_is_scaled_polynomial_in_space_over_0_to_1)
{
    static const double plane[4] = {2, 4, 6, -8};
    batten_curve *line = make_line(2, plane), *circle = NULL, *taken = NULL;
    double moved = 1, p[6];
    CHECK_OK(bat_network_take_curve(line, 0.5, 1e-6, &taken, &moved));
    CHECK_NEAR(moved, 0, 0);
    CHECK_INT(batten_curve_dimension(taken), 3);
    for (int k = 0; k <= 4; k++) {
        CHECK_OK(batten_curve_evaluate(taken, k / 4.0, 1, p));
        CHECK_NEAR(p[0], 1 + k / 2.0, 1e-15);
        CHECK_NEAR(p[1], 2 - 1.5 * k, 1e-15);
        CHECK_NEAR(p[2], 0, 0);
        CHECK_NEAR(p[3], 2, 1e-14);
    }
    batten_curve_unref(taken);
    taken = NULL;
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(bat_network_take_curve(circle, 0.5, 1e-3, &taken, &moved));
    CHECK(!batten_curve_is_rational(taken) && moved > 0 && moved <= 1e-3 / 16);
    double worst = 0;
    for (int k = 0; k <= 100; k++) {
        CHECK_OK(batten_curve_evaluate(taken, k / 100.0, 0, p));
        worst = fmax(worst, fabs(hypot(p[0], p[1]) - 1));
    }
    CHECK(worst <= moved * 1.001);
    batten_curve_unref(taken);
    batten_curve_unref(circle);
    batten_curve_unref(line);
}

/* Two profiles and a guide; what failed is given back, so that a test may try again. */
static batten_status take_lines(bat_network *net, batten_curve *const *lines)
{
    const batten_status status = bat_network_take(net, (const batten_curve *const *)lines,
                                                  (const batten_curve *const *)lines + 2);
    if (status != BATTEN_OK)
        bat_network_free(net);
    for (int which = 0; which < 2 && status != BATTEN_OK; which++)
        net->family[which].count = 0;
    return status;
}

/* Profiles of a length of 0.25 and a little more, and one guide. */
TEST(a_curve_within_the_distance_of_one_place_is_a_point_and_no_point_is_closed)
{
    static const double ends[3][6] = {
        {0, 0, 0, 0.25, 0, 0}, {0, 0, 0, 0.2500001, 0, 0}, {0, 0, 0, 0, 1, 0}};
    static const struct {
        double same, tolerance;
        bool point;
    } rows[] = {{0.25, 1, true}, {1, 1, true}, {0.25, 0.96, false}, {0.24, 1, false}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve *lines[3];
        for (int k = 0; k < 3; k++)
            lines[k] = make_line(3, ends[k]);
        bat_network net = {.family = {{.what = "profile", .given = 2}, {.given = 1}},
                           .scale = 1,
                           .tolerance = rows[i].tolerance,
                           .same = rows[i].same,
                           .gap = 0.5};
        CHECK_OK(take_lines(&net, lines));
        CHECK_INT(net.family[0].count, 2);
        CHECK_INT(net.family[1].count, 1);
        for (int k = 0; k < 2; k++) {
            const bat_network_curve *c = bat_network_at(&net, 0, k);
            CHECK_INT(c->index, k);
            CHECK(c->point == (k == 0 && rows[i].point));
            CHECK(c->closed == !c->point); /* both ends are within the gap */
        }
        CHECK(!net.family[1].curves[0].point && !net.family[1].curves[0].closed);
        bat_network_free(&net);
        for (int k = 0; k < 3; k++)
            batten_curve_unref(lines[k]);
    }
}
