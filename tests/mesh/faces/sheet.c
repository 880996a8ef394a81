/* Surfaces as meshes see them: closed forms on surfaces that are known. */
#include "mesh/faces/meshing_scene.h"

/* Derivatives to order 2 as functions of (u, v), with the bounds they must give. */
static void check_bounds(const double d[18], const double length[2], const double bend[3],
                         const double turn[2])
{
    bat_lattice_bounds b;
    bat_lattice_bound(d, &b);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(b.bend[k], bend[k], 1e-14 * (1 + bend[k]));
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(b.length[k], length[k], 1e-14 * (1 + length[k]));
        CHECK_NEAR(b.turn[k], turn[k], 1e-14 * (1 + turn[k]));
    }
}

/* x = r cos v cos u ...: |Su| = r cos v, L = r cos^2 v, N = r, and the normal is the place on the unit sphere. */
TEST(a_sphere_is_bent_and_turns_as_its_radius_says)
{
    for (int i = 0; i < 5; i++) {
        const double r = 3, u = 0.7 * i, v = 0.3 * i - 0.5;
        const double cu = cos(u), su = sin(u), cv = cos(v), sv = sin(v);
        const double d[18] = {
            r * cv * cu,  r * cv * su,  r * sv, -r * cv * su, r * cv * cu,  0,
            -r * sv * cu, -r * sv * su, r * cv, -r * cv * cu, -r * cv * su, 0,
            r * sv * su,  -r * sv * cu, 0,      -r * cv * cu, -r * cv * su, -r * sv};
        check_bounds(d, (double[]){r * cv, r}, (double[]){r * cv * cv, 0, r},
                     (double[]){cv, 1});
    }
}

/* z = x y: normal (-y, -x, 1) / w, so that n_u = (x y, -1 - y^2, -x) / w^3, and n_v with x and y swapped. */
TEST(a_saddle_is_twisted_and_not_bent)
{
    for (int i = 0; i < 5; i++) {
        const double x = 0.4 * i - 1, y = 0.3 * i;
        const double w = sqrt(1 + x * x + y * y), w3 = w * w * w;
        const double d[18] = {x, y, x * y, 1, 0, y, 0, 1, x, 0, 0, 0, 0, 0, 1, 0, 0, 0};
        const double n_u[3] = {x * y, -1 - y * y, -x}, n_v[3] = {-1 - x * x, x * y, -y};
        check_bounds(
            d, (double[]){sqrt(1 + y * y), sqrt(1 + x * x)}, (double[]){0, 1 / w, 0},
            (double[]){sqrt(n_u[0] * n_u[0] + n_u[1] * n_u[1] + n_u[2] * n_u[2]) / w3,
                       sqrt(n_v[0] * n_v[0] + n_v[1] * n_v[1] + n_v[2] * n_v[2]) / w3});
    }
}

TEST(where_there_is_no_normal_all_of_the_second_derivatives_count)
{
    const double d[18] = {0, 0, 0, 0, 0, 0, 0, 2, 0, 3, 4, 0, 0, 0, 7, 1, 2, 2};
    check_bounds(d, (double[]){0, 2}, (double[]){5, 7, 3}, (double[]){0, 0});
}

TEST(a_normal_is_a_unit_vector_across_both_derivatives_or_none)
{
    const double d[9] = {9, 9, 9, 2, 0, 0, 3, 4, 0}, along[9] = {0, 0, 0, 1, 2, 3, -2, -4, -6};
    const double tiny[9] = {0, 0, 0, 1e-10, 0, 0, 0, 1, 0},
                 swapped[9] = {0, 0, 0, 0, 1, 0, 1e-10};
    double n[3];
    CHECK(bat_sheet_normal(d, n));
    CHECK(n[0] == 0 && n[1] == 0);
    CHECK_NEAR(n[2], 1, 1e-15);
    CHECK(!bat_sheet_normal(along, n));
    CHECK(!bat_sheet_normal(tiny, n));
    CHECK(!bat_sheet_normal(swapped, n));
}

TEST(parameters_are_wrapped_around_closed_directions_and_cut_off_at_ends)
{
    batten_surface *surface = meshing_cylinder(1, 2);
    bat_sheet sheet;
    bat_sheet_begin(&sheet, surface, 1e-9);
    const int around = sheet.closed[0] ? 0 : 1, along = 1 - around;
    const batten_interval turn = sheet.domain[around], height = sheet.domain[along];
    const double period = turn.b - turn.a;
    CHECK(sheet.closed[around] && !sheet.closed[along]);
    for (int k = -2; k <= 2; k++) {
        double uv[2];
        uv[around] = turn.a + (0.3 + k) * period;
        uv[along] = height.a + (0.3 + k) * (height.b - height.a);
        bat_sheet_wrap(&sheet, uv);
        CHECK_NEAR(uv[around], turn.a + 0.3 * period, 1e-12 * period);
        CHECK_NEAR(uv[along],
                   k < 0   ? height.a
                   : k > 0 ? height.b
                           : height.a + 0.3 * (height.b - height.a),
                   1e-14);
    }
    double ends[2];
    ends[around] = turn.b; /* an end is left as it is */
    ends[along] = height.b;
    bat_sheet_wrap(&sheet, ends);
    CHECK(ends[around] == turn.b && ends[along] == height.b);
    batten_surface_unref(surface);
}
