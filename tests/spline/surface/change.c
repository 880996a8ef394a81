#include "spline/surface/change.h"

#include "support/surfaces.h"
#include "support/test.h"

/* Coordinates reach 10, weights a ratio of 4, degrees 5: 1e-12 is some hundred roundings. */
enum { DEGREES = 5 };
static const double tolerance = 1e-12;

static void make(test_random *random, surface_data *data, batten_surface **out)
{
    surface_data_random(random, DEGREES, data);
    CHECK_OK(surface_data_create(data, out));
}

TEST(knots_inserted_move_nothing)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *made;
        make(&random, &data, &surface);
        const batten_direction direction = c % 2 ? BATTEN_U : BATTEN_V;
        const batten_interval domain = batten_surface_domain(surface, direction);
        const double at = domain.a + (domain.b - domain.a) * test_random_in(&random, 0.1, 0.9);
        CHECK_OK(batten_surface_insert_knot(surface, direction, at, 1, &made));
        check_same_shape(surface, made, tolerance);
        CHECK(!batten_surface_is_periodic(made, direction));
        CHECK(batten_surface_is_periodic(made, bat_other(direction)) ==
              batten_surface_is_periodic(surface, bat_other(direction)));
        batten_surface_unref(made);
        const double knots[] = {at, at + (domain.b - at) / 2, at + (domain.b - at) / 1.5};
        CHECK_OK(batten_surface_refine(surface, direction, 3, knots, &made));
        check_same_shape(surface, made, tolerance);
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}

TEST(a_higher_degree_moves_nothing)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *made;
        make(&random, &data, &surface);
        const batten_direction direction = c % 2 ? BATTEN_U : BATTEN_V;
        const int degree = batten_surface_degree(surface, direction), by = c % 3;
        CHECK_OK(batten_surface_elevate(surface, direction, by, &made));
        CHECK_INT(batten_surface_degree(made, direction), degree + by);
        check_same_shape(surface, made, 10 * tolerance);
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}

TEST(bezier_patches_and_the_clamped_form_are_the_surface)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *bezier, *clamped;
        make(&random, &data, &surface);
        CHECK_OK(batten_surface_to_bezier(surface, &bezier));
        check_same_shape(surface, bezier, tolerance);
        for (int k = 0; k < 2; k++) {
            const batten_direction way = (batten_direction)k;
            CHECK_INT(batten_surface_point_count(bezier, way),
                      batten_surface_degree(surface, way) *
                              (batten_surface_spans(surface, way, NULL) - 1) +
                          1);
        }
        CHECK_OK(batten_surface_clamp(surface, BATTEN_V, &clamped));
        check_same_shape(surface, clamped, tolerance);
        const double *V = batten_surface_knots(clamped, BATTEN_V);
        CHECK(V[0] == V[batten_surface_degree(clamped, BATTEN_V)]);
        batten_surface_unref(surface);
        batten_surface_unref(bezier);
        batten_surface_unref(clamped);
    }
}

TEST(halves_are_the_surface_and_rejoin)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        surface_data data;
        batten_surface *surface, *low, *high, *both;
        make(&random, &data, &surface);
        const batten_direction direction = c % 2 ? BATTEN_U : BATTEN_V;
        const batten_interval domain = batten_surface_domain(surface, direction);
        const double at = domain.a + (domain.b - domain.a) * test_random_in(&random, 0.1, 0.9);
        CHECK_OK(batten_surface_split(surface, direction, at, &low, &high));
        CHECK(batten_surface_domain(low, direction).b == at &&
              batten_surface_domain(high, direction).a == at);
        CHECK_OK(batten_surface_join(low, high, direction, 1e-11, &both));
        check_same_shape(surface, both, tolerance);
        batten_surface_unref(surface);
        batten_surface_unref(low);
        batten_surface_unref(high);
        batten_surface_unref(both);
    }
}

TEST(a_part_is_the_surface_there)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        batten_surface *surface, *part;
        make(&random, &data, &surface);
        const batten_interval domain = batten_surface_domain(surface, BATTEN_U);
        const double a = domain.a + 0.3 * (domain.b - domain.a),
                     b = domain.a + 0.6 * (domain.b - domain.a);
        CHECK_OK(batten_surface_subrange(surface, BATTEN_U, a, b, &part));
        for (int i = 0; i <= 8; i++) {
            const double u = a + (b - a) * i / 8,
                         v = random_parameter(&random, surface, BATTEN_V);
            double x[3], y[3];
            define_point(surface, u, v, x);
            CHECK_OK(batten_surface_evaluate(part, u, v, 0, y));
            for (int k = 0; k < data.dimension; k++)
                CHECK_NEAR(y[k], x[k], tolerance);
        }
        batten_surface_unref(surface);
        batten_surface_unref(part);
    }
}

TEST(changes_that_make_no_sense_are_refused)
{
    static const double u[] = {0, 0, 0, 1, 2, 2, 2}, v[] = {0, 0, 1, 1},
                        points[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const batten_axis axes[2] = {{2, 4, u, false}, {1, 2, v, false}};
    batten_surface *surface = NULL, *made = NULL, *other = NULL;
    CHECK_OK(batten_surface_create(1, &axes[0], &axes[1], points, NULL, &surface));
    const double unsorted[] = {1.5, 0.5}, outside[] = {3}, often[] = {1, 1}, wild[] = {NAN};
    CHECK_STATUS(batten_surface_refine(surface, BATTEN_U, 2, unsorted, &made),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_surface_refine(surface, BATTEN_U, 1, outside, &made),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_refine(surface, BATTEN_U, 2, often, &made), BATTEN_BAD_KNOTS);
    CHECK_STATUS(batten_surface_refine(surface, BATTEN_U, 1, wild, &made), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_refine(surface, BATTEN_U, 100000000, wild, &made),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_surface_insert_knot(surface, BATTEN_U, 1, 2, &made), BATTEN_BAD_KNOTS);
    CHECK_STATUS(batten_surface_insert_knot(surface, BATTEN_U, 1, 0, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_insert_knot(surface, BATTEN_U, 1, 4, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_insert_knot(surface, BATTEN_U, 9, 1, &made),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_elevate(surface, BATTEN_U, 24, &made), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_elevate(surface, BATTEN_U, -1, &made), BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_split(surface, BATTEN_U, 0, &made, &other),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_split(surface, BATTEN_U, 2, &made, &other),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_split(surface, BATTEN_U, NAN, &made, &other),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_subrange(surface, BATTEN_U, 1, 1, &made), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_subrange(surface, BATTEN_U, 1, 3, &made), BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_subrange(surface, BATTEN_U, -1, 1, &made),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK(made == NULL && other == NULL);
    batten_surface_unref(surface);
}

TEST(S5_bezier_patches_beyond_the_limit_are_refused_before_work)
{
    enum { MANY = 300 };
    double knots[MANY + 20], *points = test_array(MANY * MANY, sizeof *points);
    random_knots(&(test_random){1}, 15, MANY, knots);
    const batten_axis axis = {15, MANY, knots, false};
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(batten_surface_to_bezier(surface, &made), BATTEN_TOO_LARGE);
    batten_surface_unref(surface);
}

TEST(N2_a_change_that_overflows_is_a_status)
{
    static const double knots[] = {0, 0, 1, 1};
    const double points[] = {1.7e308, 0, 1.7e308, 0}, weights[] = {1.99, 1, 1.99, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, weights, &surface));
    CHECK_STATUS(batten_surface_elevate(surface, BATTEN_U, 1, &made), BATTEN_OVERFLOW);
    CHECK(made == NULL);
    batten_surface_unref(surface);
}

TEST(a_surface_is_cut_inside_its_domain_alone)
{
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 2};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *patch = NULL, *low = NULL, *high = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &patch));
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const double outside[4] = {0, 1, -0.5, 1.5};
        for (int i = 0; i < 4; i++) {
            CHECK_STATUS(batten_surface_split(patch, direction, outside[i], &low, &high),
                         BATTEN_OUT_OF_DOMAIN);
            CHECK_MESSAGE("a surface with the domain [0, 1] cannot be cut at");
        }
        CHECK_STATUS(batten_surface_split(patch, direction, NAN, &low, &high),
                     BATTEN_NOT_FINITE);
        CHECK(!low && !high);
        CHECK_OK(batten_surface_split(patch, direction, 0.25, &low, &high));
        CHECK_NEAR(batten_surface_domain(low, direction).b, 0.25, 0);
        CHECK_NEAR(batten_surface_domain(high, direction).a, 0.25, 0);
        batten_surface_unref(low);
        batten_surface_unref(high);
        low = high = NULL;
    }
    batten_surface_unref(patch);
}
