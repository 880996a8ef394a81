#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

static void make(test_random *random, surface_data *data, batten_surface **out)
{
    surface_data_random(random, 4, data);
    CHECK_OK(surface_data_create(data, out));
}

static void check_bits(const batten_surface *a, const batten_surface *b)
{
    const size_t n = (size_t)batten_surface_point_count(a, BATTEN_U) *
                     batten_surface_point_count(a, BATTEN_V);
    CHECK(memcmp(batten_surface_points(a), batten_surface_points(b),
                 n * batten_surface_dimension(a) * sizeof(double)) == 0);
    CHECK(batten_surface_is_rational(a) == batten_surface_is_rational(b));
    CHECK(!batten_surface_is_rational(a) ||
          memcmp(batten_surface_weights(a), batten_surface_weights(b), n * sizeof(double)) ==
              0);
    for (int k = 0; k < 2; k++)
        CHECK(memcmp(batten_surface_knots(a, k), batten_surface_knots(b, k),
                     (size_t)batten_surface_knot_count(a, k) * sizeof(double)) == 0);
}

TEST(a_surface_reversed_twice_or_swapped_twice_is_itself)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        batten_surface *surface, *once, *twice;
        make(&random, &data, &surface);
        for (int k = 0; k < 3; k++) {
            if (k < 2) {
                CHECK_OK(batten_surface_reverse(surface, k, &once));
                CHECK_OK(batten_surface_reverse(once, k, &twice));
            } else {
                CHECK_OK(batten_surface_swap(surface, &once));
                CHECK_OK(batten_surface_swap(once, &twice));
            }
            check_bits(surface, twice);
            const batten_interval u = batten_surface_domain(surface, 0),
                                  v = batten_surface_domain(surface, 1);
            const batten_interval s = batten_surface_domain(once, 0),
                                  t = batten_surface_domain(once, 1);
            double a[3], b[3];
            CHECK_OK(batten_surface_evaluate(surface, u.a + 0.25 * (u.b - u.a),
                                             v.a + 0.125 * (v.b - v.a), 0, a));
            const double x = k == 0   ? 0.75
                             : k == 1 ? 0.25
                                      : 0.125,
                         y = k == 0   ? 0.125
                             : k == 1 ? 0.875
                                      : 0.25;
            CHECK_OK(batten_surface_evaluate(once, s.a + x * (s.b - s.a), t.a + y * (t.b - t.a),
                                             0, b));
            for (int i = 0; i < data.dimension; i++)
                CHECK_NEAR(b[i], a[i], 1e-10);
            batten_surface_unref(once);
            batten_surface_unref(twice);
        }
        batten_surface_unref(surface);
    }
}

TEST(a_domain_mapped_linearly_moves_nothing)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(20); c++) {
        surface_data data;
        batten_surface *surface, *made = NULL;
        make(&random, &data, &surface);
        CHECK_OK(batten_surface_set_domain(surface, BATTEN_V, -3, 5, &made));
        CHECK(batten_surface_domain(made, BATTEN_V).a == -3 &&
              batten_surface_domain(made, BATTEN_V).b == 5);
        CHECK(batten_surface_is_periodic(made, BATTEN_V) ==
              batten_surface_is_periodic(surface, BATTEN_V));
        if (!batten_surface_is_periodic(surface, BATTEN_U) &&
            !batten_surface_is_periodic(surface, BATTEN_V))
            check_same_shape(surface, made, 1e-10);
        batten_surface_unref(made);
        made = NULL;
        CHECK_STATUS(batten_surface_set_domain(surface, BATTEN_U, 5, -3, &made),
                     BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_surface_set_domain(surface, BATTEN_U, 0, NAN, &made),
                     BATTEN_NOT_FINITE);
        batten_surface_unref(surface);
    }
}

TEST(weights_of_1_change_nothing)
{
    test_random random = test_random_begin(__func__);
    surface_data data;
    batten_surface *surface, *made;
    surface_data_random(&random, 4, &data);
    data.rational = false;
    CHECK_OK(surface_data_create(&data, &surface));
    CHECK_OK(batten_surface_to_rational(surface, &made));
    CHECK(batten_surface_is_rational(made) && batten_surface_weights(made)[0] == 1);
    check_same_shape(surface, made, 1e-14);
    batten_surface_unref(surface);
    batten_surface_unref(made);
}

TEST(a_point_replaced_moves_the_surface_by_its_share)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(20); c++) {
        surface_data data;
        batten_surface *surface, *made;
        make(&random, &data, &surface);
        const int m = batten_surface_point_count(surface, BATTEN_V);
        const double to[] = {1, 2, 3};
        CHECK_OK(batten_surface_with_point(surface, 1, 1, to, &made));
        for (int k = 0; k < data.dimension; k++)
            CHECK_BITS(batten_surface_points(made)[(m + 1) * data.dimension + k], to[k]);
        for (int k = 0; k < 2; k++)
            if (batten_surface_is_periodic(surface, k))
                CHECK(batten_surface_is_closed(made, k, 1e-12));
        batten_surface_unref(made);
        const double wild[] = {NAN, NAN, NAN};
        CHECK_STATUS(batten_surface_with_point(surface, 0, 0, wild, &made), BATTEN_NOT_FINITE);
        batten_surface_unref(surface);
    }
}

TEST(an_affine_map_of_the_surface_is_the_map_of_its_points)
{
    test_random random = test_random_begin(__func__);
    const batten_affine map = {{{1, 2, 0.5}, {0, 1, -1}, {0.25, 0, 2}}, {3, -4, 5}};
    for (int c = 0; c < test_cases(30); c++) {
        surface_data data;
        batten_surface *surface, *made;
        make(&random, &data, &surface);
        CHECK_OK(batten_surface_transform(surface, &map, &made));
        for (int i = 0; i < 8; i++) {
            const double u = random_parameter(&random, surface, 0),
                         v = random_parameter(&random, surface, 1);
            double a[3] = {0}, b[3] = {0};
            CHECK_OK(batten_surface_evaluate(surface, u, v, 0, a));
            CHECK_OK(batten_surface_evaluate(made, u, v, 0, b));
            const batten_vec3 x = batten_affine_apply(map, (batten_vec3){a[0], a[1], a[2]});
            const double expected[] = {x.x, x.y, x.z};
            for (int k = 0; k < data.dimension; k++)
                CHECK_NEAR(b[k], expected[k], 1e-13 * 10);
        }
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}

TEST(N1_a_map_that_is_not_finite_or_overflows_is_refused)
{
    static const double knots[] = {0, 0, 1, 1}, points[] = {10, 1, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL, *made = NULL;
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &surface));
    batten_affine map = batten_affine_identity();
    map.t[1] = NAN;
    CHECK_STATUS(batten_surface_transform(surface, &map, &made), BATTEN_NOT_FINITE);
    map = batten_affine_scaling(1e308, 1, 1);
    CHECK_STATUS(batten_surface_transform(surface, &map, &made), BATTEN_OVERFLOW);
    map.m[2][2] = INFINITY;
    CHECK_STATUS(batten_surface_transform(surface, &map, &made), BATTEN_NOT_FINITE);
    CHECK(made == NULL);
    batten_surface_unref(surface);
}

/* A mirror's image of a normal is the normal of the image. */
TEST(a_mirrored_surface_keeps_its_outside_outside)
{
    test_random random = test_random_begin(__func__);
    const batten_vec3 origin = {1, 2, 3}, normal = {1, -2, 0.5};
    const batten_affine mirror = batten_affine_mirror(origin, normal);
    batten_affine linear = mirror;
    memset(linear.t, 0, sizeof linear.t);
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        batten_surface *surface = NULL, *image = NULL;
        make(&random, &data, &surface);
        CHECK_OK(batten_surface_transform_sides(surface, &mirror, &image));
        const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                              v = batten_surface_domain(surface, BATTEN_V);
        CHECK_BITS(batten_surface_domain(image, BATTEN_U).a, u.a);
        CHECK_BITS(batten_surface_domain(image, BATTEN_U).b, u.b);
        CHECK(batten_surface_is_periodic(image, BATTEN_U) ==
              batten_surface_is_periodic(surface, BATTEN_U));
        const double y = v.a + 0.3 * (v.b - v.a);
        double p[3] = {0}, q[3] = {0};
        batten_vec3 n, m;
        const bool turns = data.dimension == 3;
        CHECK_OK(batten_surface_evaluate(surface, u.a + 0.375 * (u.b - u.a), y, 0, p));
        CHECK_OK(batten_surface_evaluate(image, u.a + (turns ? 0.625 : 0.375) * (u.b - u.a), y,
                                         0, q));
        const batten_vec3 there = batten_affine_apply(mirror, (batten_vec3){p[0], p[1], p[2]});
        const double wanted[3] = {there.x, there.y, there.z};
        for (int k = 0; k < data.dimension; k++)
            CHECK_NEAR(q[k], wanted[k], 1e-9);
        if (turns &&
            batten_surface_normal(surface, u.a + 0.375 * (u.b - u.a), y, NULL, &n) ==
                BATTEN_OK &&
            batten_surface_normal(image, u.a + 0.625 * (u.b - u.a), y, NULL, &m) == BATTEN_OK) {
            n = batten_affine_apply(linear, n);
            CHECK_NEAR(m.x, n.x, 1e-6);
            CHECK_NEAR(m.y, n.y, 1e-6);
            CHECK_NEAR(m.z, n.z, 1e-6);
        }
        batten_surface_unref(image);
        batten_surface_unref(surface);
    }
}

TEST(knots_that_only_0_tells_apart_are_kept_apart_in_mirrors)
{
    const double knots[] = {0, 0, 1e-200, 1, 1},
                 points[3 * 6] = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1, 0, 2, 1, 1, 2};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, (const double[]){0, 0, 1, 1}, false};
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 1, 0});
    batten_surface *surface = NULL, *image = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    CHECK_OK(batten_surface_transform_sides(surface, &mirror, &image));
    CHECK_BITS(batten_surface_domain(image, BATTEN_U).a, -1);
    CHECK_BITS(batten_surface_knots(image, BATTEN_U)[2], -1e-200);
    batten_surface_unref(image);
    batten_surface_unref(surface);
}
