#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

/* f = x^3 y^3 - 2 x y^2 + x, and its derivatives (k, l). */
static double f(double x, double y, int k, int l)
{
    const double px[2][2] = {{x * x * x, x}, {3 * x * x, 1}},
                 py[2][2] = {{y * y * y, y * y}, {3 * y * y, 2 * y}};
    return px[k][0] * py[l][0] - 2 * px[k][1] * py[l][1] + (l ? 0 : px[k][1]);
}

TEST(a_hermite_net_of_a_bicubic_is_the_bicubic)
{
    const double u[] = {-1, 0.5, 2}, v[] = {0, 1, 1.5, 3};
    double values[3][4][4];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            for (int r = 0; r < 4; r++)
                values[i][j][r] = f(u[i], v[j], r % 2, r / 2);
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_from_hermite((batten_uv){u, v},
                                         (batten_grid){1, 3, 4, values[0][0]}, &surface));
    CHECK_INT(batten_surface_point_count(surface, BATTEN_U), 6);
    CHECK_INT(batten_surface_point_count(surface, BATTEN_V), 8);
    for (int i = 0; i <= 30; i++)
        for (int j = 0; j <= 30; j++) {
            const double x = -1 + i / 10.0, y = j / 10.0;
            double out[3];
            CHECK_OK(batten_surface_evaluate(surface, x, y, 1, out));
            CHECK_NEAR(out[0], f(x, y, 0, 0), 2e-13);
            CHECK_NEAR(out[1], f(x, y, 1, 0), 4e-12);
            CHECK_NEAR(out[2], f(x, y, 0, 1), 4e-12);
        }
    batten_surface_unref(surface);
}

TEST(powers_give_the_polynomial_and_come_back)
{
    /* 1 + 2 x + 3 y + x^2 y on [1, 3] x [-1, 1], in powers of x - 1 and y + 1. */
    const double u[] = {1, 3}, v[] = {-1, 1};
    const double c[6] = {-1, 4, 0, 2, -1, 1};
    double back[6];
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_from_power(1, (batten_pieces){2, 1, u}, (batten_pieces){1, 1, v}, c,
                                       0, &surface));
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            const double x = 1 + i / 4.0, y = -1 + j / 4.0;
            double z;
            CHECK_OK(batten_surface_evaluate(surface, x, y, 0, &z));
            CHECK_NEAR(z, 1 + 2 * x + 3 * y + x * x * y, 1e-14);
        }
    CHECK_OK(batten_surface_to_power(surface, back));
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(back[i], c[i], 1e-14);
    batten_surface_unref(surface);
}

TEST(random_splines_survive_the_way_through_powers_and_bezier)
{
    test_random random = test_random_begin(__func__);
    static double coefficients[100000];
    for (int c = 0; c < test_cases(40); c++) {
        surface_data data;
        batten_surface *surface, *made, *bezier, *again;
        surface_data_random(&random, 4, &data);
        data.rational = c % 2;
        CHECK_OK(surface_data_create(&data, &surface));
        double breaks[2][64];
        int pieces[2];
        for (int k = 0; k < 2; k++)
            pieces[k] = batten_surface_spans(surface, k, breaks[k]) - 1;
        const int p = batten_surface_degree(surface, 0), q = batten_surface_degree(surface, 1);
        CHECK_OK(batten_surface_to_bezier(surface, &bezier));
        CHECK_OK(batten_surface_from_bezier(
            data.dimension, (batten_pieces){p, pieces[0], breaks[0]},
            (batten_pieces){q, pieces[1], breaks[1]}, batten_surface_points(bezier),
            batten_surface_weights(bezier), &again));
        check_same_shape(surface, again, 1e-12);
        if (data.rational) {
            CHECK_STATUS(batten_surface_to_power(surface, coefficients), BATTEN_UNSUPPORTED);
        } else {
            CHECK_OK(batten_surface_to_power(surface, coefficients));
            CHECK_OK(batten_surface_from_power(
                data.dimension, (batten_pieces){p, pieces[0], breaks[0]},
                (batten_pieces){q, pieces[1], breaks[1]}, coefficients, 1e-9, &made));
            check_same_shape(surface, made, 1e-9);
            batten_surface_unref(made);
        }
        batten_surface_unref(bezier);
        batten_surface_unref(again);
        batten_surface_unref(surface);
    }
}

TEST(forms_that_make_no_sense_are_refused)
{
    const double breaks[] = {0, 1, 2}, falling[] = {0, 1, 1}, wild[] = {0, NAN, 2};
    const double values[64] = {0}, jump[8] = {0, 0, 0, 0, 1, 0, 0, 0};
    batten_surface *made = NULL;
    CHECK_STATUS(batten_surface_from_bezier(4, (batten_pieces){1, 1, breaks},
                                            (batten_pieces){1, 1, breaks}, values, NULL, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_from_bezier(1, (batten_pieces){0, 1, breaks},
                                            (batten_pieces){1, 1, breaks}, values, NULL, &made),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_from_bezier(1, (batten_pieces){1, 1, breaks},
                                            (batten_pieces){26, 1, breaks}, values, NULL,
                                            &made),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_surface_from_bezier(1, (batten_pieces){1, 0, breaks},
                                            (batten_pieces){1, 1, breaks}, values, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_surface_from_bezier(1, (batten_pieces){1, 2, falling},
                                            (batten_pieces){1, 1, breaks}, values, NULL, &made),
                 BATTEN_NOT_INCREASING);
    CHECK_STATUS(batten_surface_from_bezier(1, (batten_pieces){1, 2147483647, breaks},
                                            (batten_pieces){1, 1, breaks}, values, NULL, &made),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_surface_from_hermite((batten_uv){breaks, breaks},
                                             (batten_grid){1, 1, 2, values}, &made),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_surface_from_hermite((batten_uv){breaks, wild},
                                             (batten_grid){1, 2, 3, values}, &made),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_from_power(1, (batten_pieces){1, 2, breaks},
                                           (batten_pieces){1, 1, breaks}, jump, 0.5, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("piece (2, 1) is 1 from its neighbour");
    CHECK_STATUS(batten_surface_from_power(1, (batten_pieces){1, 2, breaks},
                                           (batten_pieces){1, 1, breaks}, jump, -1, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_from_power(1, (batten_pieces){1, 2, falling},
                                           (batten_pieces){1, 1, breaks}, jump, 1, &made),
                 BATTEN_NOT_INCREASING);
    CHECK(made == NULL);
}
