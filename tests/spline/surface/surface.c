#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

#include <limits.h>

static const double knots_u[] = {0, 0, 0, 1, 2, 2, 2}, knots_v[] = {0, 0, 1, 1};
static const batten_axis good_u = {2, 4, knots_u, false}, good_v = {1, 2, knots_v, false};
static const double points[24] = {0, 0, 0, 0, 1, 0,  1, 0, 0, 1, 1, 0,
                                  2, 0, 5, 2, 1, -5, 3, 0, 0, 3, 1, 0};

static batten_status make(const batten_axis *u, const double *p, const double *w,
                          batten_surface **out)
{
    return batten_surface_create(3, u, &good_v, p, w, out);
}

TEST(a_surface_answers_with_what_it_was_made_of)
{
    batten_surface *surface = NULL;
    CHECK_OK(make(&good_u, points, NULL, &surface));
    CHECK_TEXT(batten_surface_kind(surface), "nurbs");
    CHECK_INT(batten_surface_dimension(surface), 3);
    CHECK_INT(batten_surface_degree(surface, BATTEN_U), 2);
    CHECK_INT(batten_surface_point_count(surface, BATTEN_U), 4);
    CHECK_INT(batten_surface_knot_count(surface, BATTEN_V), 4);
    CHECK(memcmp(batten_surface_points(surface), points, sizeof points) == 0);
    CHECK(memcmp(batten_surface_knots(surface, BATTEN_U), knots_u, sizeof knots_u) == 0);
    CHECK(batten_surface_weights(surface) == NULL && !batten_surface_is_rational(surface));
    CHECK(!batten_surface_is_periodic(surface, BATTEN_U));
    double breaks[3];
    CHECK_INT(batten_surface_spans(surface, BATTEN_U, NULL), 3);
    CHECK_INT(batten_surface_spans(surface, BATTEN_U, breaks), 3);
    CHECK(breaks[0] == 0 && breaks[1] == 1 && breaks[2] == 2);
    CHECK(batten_surface_domain(surface, BATTEN_U).b == 2);
    const batten_box box = batten_surface_box(surface);
    CHECK(box.low.x == 0 && box.low.y == 0 && box.low.z == -5);
    CHECK(box.high.x == 3 && box.high.y == 1 && box.high.z == 5);
    batten_surface *same = batten_surface_ref(surface), *nurbs = NULL;
    batten_surface_unref(surface);
    double error = 1;
    CHECK_OK(batten_surface_to_nurbs(same, 1e-3, &error, &nurbs));
    CHECK(nurbs == same && error == 0);
    CHECK_OK(batten_surface_to_nurbs(same, 1e-3, NULL, &nurbs));
    batten_surface_unref(nurbs);
    batten_surface_unref(same);
    batten_surface_unref(nurbs);
    batten_surface_unref(NULL);
}

TEST(the_box_leaves_out_points_that_bear_on_nothing)
{
    /* Unclamped with an end knot three times: the first point acts left of the domain only. */
    const double u[] = {0, 0.5, 0.5, 1, 2, 3}, v[] = {0, 0, 1, 1};
    const double p[] = {100, 100, 1, 1, 2, 2};
    const batten_axis axis_u = {1, 3, u + 0, false}, axis_v = {1, 2, v, false};
    batten_surface *surface = NULL;
    const double knots[] = {0, 0.5, 0.5, 1, 2};
    (void)axis_u;
    const batten_axis three = {1, 3, knots, false};
    CHECK_OK(batten_surface_create(1, &three, &axis_v, p, NULL, &surface));
    CHECK_BITS(batten_surface_box(surface).low.x, 1);
    CHECK_BITS(batten_surface_box(surface).high.x, 2);
    batten_surface_unref(surface);
}

TEST(N1_numbers_that_are_not_finite_are_refused_with_their_place)
{
    batten_surface *surface = NULL;
    double p[24], weights[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    memcpy(p, points, sizeof p);
    p[10] = NAN;
    CHECK_STATUS(make(&good_u, p, NULL, &surface), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of control point (2, 2)");
    weights[5] = INFINITY;
    CHECK_STATUS(make(&good_u, points, weights, &surface), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("weight (3, 2)");
    double knots[7];
    memcpy(knots, knots_u, sizeof knots);
    knots[3] = NAN;
    const batten_axis axis = {2, 4, knots, false}, periodic = {2, 4, knots, true};
    CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("knot in u 4");
    CHECK_STATUS(make(&periodic, points, NULL, &surface), BATTEN_NOT_FINITE);
    CHECK(surface == NULL);
}

TEST(K1_an_empty_domain_is_refused)
{
    const double equal[] = {1, 1, 1, 1, 1, 1, 1};
    const batten_axis axis = {2, 4, equal, false}, periodic = {2, 4, equal, true};
    batten_surface *surface = NULL;
    CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_BAD_KNOTS);
    CHECK_STATUS(make(&periodic, points, NULL, &surface), BATTEN_BAD_KNOTS);
}

TEST(K2_too_few_points_for_the_degree_are_refused)
{
    const batten_axis axis = {4, 4, knots_u, false}, none = {2, 0, knots_u, true};
    batten_surface *surface = NULL;
    CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("5 are needed");
    CHECK_STATUS(make(&none, points, NULL, &surface), BATTEN_TOO_FEW_POINTS);
}

TEST(K3_decreasing_knots_are_refused)
{
    double decreasing[] = {0, 0, 0, 1, 0.5, 2, 2};
    const double before[] = {0, 0, 0, 1, 0.5, 2, 2};
    const batten_axis axis = {2, 4, decreasing, false}, periodic = {2, 4, decreasing, true};
    batten_surface *surface = NULL;
    CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_BAD_KNOTS);
    CHECK_STATUS(make(&periodic, points, NULL, &surface), BATTEN_BAD_KNOTS);
    CHECK_STATUS(batten_surface_create(3, &good_v, &axis, points, NULL, &surface),
                 BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot in v");
    CHECK(memcmp(decreasing, before, sizeof before) == 0);
}

TEST(K4_a_knot_inside_more_often_than_the_degree_is_refused)
{
    const double inner[] = {0, 0, 1, 1, 1, 2, 2}, end[] = {0, 0, 0, 0, 2, 2, 2};
    const batten_axis axis = {2, 4, inner, false}, at_end = {2, 4, end, false};
    batten_surface *surface = NULL;
    CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_BAD_KNOTS);
    CHECK_STATUS(make(&at_end, points, NULL, &surface), BATTEN_BAD_KNOTS);
}

TEST(K5_unclamped_and_shifted_domains_are_the_clamped_ones_moved)
{
    const double shifts[] = {-5, 1e6, -0x1p30};
    const double base[] = {0, 1, 2, 3, 4, 5, 6};
    for (int s = 0; s < COUNT(shifts); s++) {
        double moved[7], a[9], b[9];
        for (int i = 0; i < 7; i++)
            moved[i] = base[i] + shifts[s];
        const batten_axis from = {2, 4, base, false}, to = {2, 4, moved, false};
        batten_surface *first = NULL, *second = NULL;
        CHECK_OK(make(&from, points, NULL, &first));
        CHECK_OK(make(&to, points, NULL, &second));
        for (int i = 0; i <= 16; i++) {
            CHECK_OK(batten_surface_evaluate(first, 2 + i / 8.0, 0.25, 1, a));
            CHECK_OK(batten_surface_evaluate(second, 2 + i / 8.0 + shifts[s], 0.25, 1, b));
            for (int k = 0; k < 9; k++)
                CHECK_BITS(b[k], a[k]);
        }
        batten_surface_unref(first);
        batten_surface_unref(second);
    }
}

TEST(K8_weights_that_are_not_positive_are_refused)
{
    batten_surface *surface = NULL;
    double weights[8] = {1, 1, 1, 0, 1, 1, 1, 1};
    CHECK_STATUS(make(&good_u, points, weights, &surface), BATTEN_BAD_WEIGHT);
    CHECK_MESSAGE("weight (2, 2) is 0");
    weights[3] = -1;
    CHECK_STATUS(make(&good_u, points, weights, &surface), BATTEN_BAD_WEIGHT);
}

TEST(K9_degrees_1_to_25_work_and_others_are_refused)
{
    double knots[60] = {0}, p[26 * 2 * 3];
    for (int i = 0; i < COUNT(p); i++)
        p[i] = 1;
    const int refused[] = {0, -1, 26};
    batten_surface *surface = NULL;
    for (int i = 0; i < COUNT(refused); i++) {
        const batten_axis axis = {refused[i], 30, knots, false};
        CHECK_STATUS(make(&axis, points, NULL, &surface), BATTEN_BAD_DEGREE);
    }
    for (int degree = 1; degree <= 25; degree++) {
        for (int i = 0; i < 60; i++)
            knots[i] = i > degree;
        const batten_axis axis = {degree, degree + 1, knots, false};
        CHECK_OK(make(&axis, p, NULL, &surface));
        double out[3];
        CHECK_OK(batten_surface_evaluate(surface, 0.3, 0.3, 0, out));
        CHECK_NEAR(out[0], 1, 8 * degree * DBL_EPSILON);
        batten_surface_unref(surface);
    }
    const batten_axis none = {1, 2, knots_v, false};
    CHECK_STATUS(batten_surface_create(4, &none, &none, p, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_create(0, &none, &none, p, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
}

TEST(S1_counts_beyond_the_limit_are_refused_before_anything_is_read)
{
    const batten_axis huge = {2, INT_MAX, knots_u, false}, large = {2, 9000000, knots_u, false};
    const batten_axis negative = {2, -1, knots_u, false};
    batten_surface *surface = NULL;
    CHECK_STATUS(make(&huge, points, NULL, &surface), BATTEN_TOO_LARGE);
    CHECK_STATUS(make(&large, points, NULL, &surface), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("18000000");
    CHECK_STATUS(make(&negative, points, NULL, &surface), BATTEN_TOO_FEW_POINTS);
}

/* A period in v that is wrong in some way: its knots, how many points it has, what is said. */
static const struct {
    int count;
    double knots[4];
    batten_status status;
    const char *words;
} periods[] = {
    {0, {0, 1}, BATTEN_TOO_FEW_POINTS, "0 control points in v for degree 2; 1 are needed"},
    {1, {0, 1}, BATTEN_OK, ""},
    {3, {0, 1, 2, NAN}, BATTEN_NOT_FINITE, "knot 4 in v is nan"},
    {3, {0, 1, INFINITY, 3}, BATTEN_NOT_FINITE, "knot 3 in v is inf"},
    {3,
     {1.5, 1.5, 1.5, 1.5},
     BATTEN_BAD_KNOTS,
     "the period in v is empty: knot 1 is 1.5 and knot 4 is 1.5"},
    {3, {0, 1, 0.5, 2}, BATTEN_BAD_KNOTS, "knot"},
    {3, {0, 1, 1.5, 2}, BATTEN_OK, ""},
};

TEST(periods_that_cannot_be_are_refused_with_their_place)
{
    static const double points_of_period[4 * 3 * 3];
    for (int i = 0; i < COUNT(periods); i++) {
        const batten_axis v = {2, periods[i].count, periods[i].knots, true};
        batten_surface *surface = NULL;
        CHECK_STATUS(batten_surface_create(3, &good_u, &v, points_of_period, NULL, &surface),
                     periods[i].status);
        if (periods[i].status != BATTEN_OK)
            CHECK_MESSAGE(periods[i].words);
        CHECK((surface != NULL) == (periods[i].status == BATTEN_OK));
        batten_surface_unref(surface);
    }
}

TEST(K2_too_few_points_are_counted_in_their_direction)
{
    const batten_axis short_u = {2, 2, knots_u, false}, short_v = {3, 1, knots_v, false};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_create(3, &short_u, &good_v, points, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("2 control points in u for degree 2; 3 are needed");
    CHECK_STATUS(batten_surface_create(3, &good_u, &short_v, points, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("1 control point in v for degree 3; 4 are needed");
}

TEST(a_periodic_surface_repeats_itself)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        surface_data_random(&random, 4, &data);
        if (!data.axes[0].periodic)
            continue;
        batten_surface *surface = NULL;
        CHECK_OK(surface_data_create(&data, &surface));
        const batten_interval domain = batten_surface_domain(surface, BATTEN_U);
        CHECK_BITS(domain.a, data.knots[0][0]);
        CHECK_BITS(domain.b, data.knots[0][data.axes[0].point_count]);
        CHECK(batten_surface_is_closed(surface, BATTEN_U, 1e-12));
        const double u = domain.a + 0.3 * (domain.b - domain.a),
                     v = random_parameter(&random, surface, BATTEN_V);
        double a[3], b[3];
        CHECK_OK(batten_surface_evaluate(surface, u, v, 0, a));
        CHECK_OK(batten_surface_evaluate(surface, u - 2 * (domain.b - domain.a), v, 0, b));
        for (int k = 0; k < data.dimension; k++)
            CHECK_NEAR(b[k], a[k], 1e-9);
        batten_surface_unref(surface);
    }
}

TEST(a_surface_is_closed_when_its_ends_meet)
{
    const double ring[] = {0, 0, 0, 0, 0, 1, 5, 0, 0, 5, 0, 1,
                           0, 5, 0, 0, 5, 1, 0, 0, 0, 0, 0, 1.25};
    batten_surface *surface = NULL;
    CHECK_OK(make(&good_u, ring, NULL, &surface));
    CHECK(batten_surface_is_closed(surface, BATTEN_U, 0.25));
    CHECK(!batten_surface_is_closed(surface, BATTEN_U, 0.2));
    CHECK(!batten_surface_is_closed(surface, BATTEN_V, 0.5));
    batten_surface_unref(surface);
}
