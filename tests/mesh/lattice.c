/* Cells in (u, v): what a surface asks for, closed forms on surfaces that are known. */
#include "mesh/faces/lattice.h"
#include "support/surfaces.h"
#include "support/test.h"

#include <batten/mesh.h>
#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

static bat_meshing with_chord(double chord, double angle)
{
    return (bat_meshing){.chord = chord,
                         .fine = chord,
                         .angle = angle,
                         .longest = INFINITY,
                         .most = 10000000,
                         .job = NULL};
}

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

/* ---- places ---- */

static batten_surface *cylinder(double radius, double height)
{
    const batten_frame world = batten_frame_world();
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_cylinder(&world, radius, height, &surface));
    return surface;
}

TEST(parameters_are_wrapped_around_closed_directions_and_cut_off_at_ends)
{
    batten_surface *surface = cylinder(1, 2);
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

static bat_lattice begin_lattice(const batten_surface *surface, const bat_meshing *m,
                                 bat_sheet *sheet, const batten_interval *box)
{
    bat_lattice lattice;
    bat_sheet_begin(sheet, surface, 1e-9);
    CHECK_OK(bat_lattice_begin(&lattice, m, sheet, box ? box : sheet->domain));
    return lattice;
}

/* There and back again, rising, each break a break. */
static void check_axis(const bat_lattice_axis *axis)
{
    CHECK(axis->count >= 2 && axis->x[0] == 0 && axis->x[axis->count - 1] <= 1);
    for (int i = 0; i < axis->count; i++) {
        CHECK_BITS(bat_lattice_to_plane(axis, axis->u[i]), axis->x[i]);
        CHECK_BITS(bat_lattice_from_plane(axis, axis->x[i]), axis->u[i]);
        CHECK_INT(bat_lattice_break(axis, axis->x[i]), i);
        if (i == 0)
            continue;
        const double width = axis->x[i] - axis->x[i - 1];
        CHECK(width > 0 && axis->u[i] > axis->u[i - 1] && axis->cells[i - 1] >= 1);
        CHECK_INT(bat_lattice_break(axis, axis->x[i] - width / 3), i);
        for (int k = 1; k < 8; k++) {
            const double u = axis->u[i - 1] + k / 8.0 * (axis->u[i] - axis->u[i - 1]);
            const double x = bat_lattice_to_plane(axis, u);
            CHECK_NEAR(x, axis->x[i - 1] + k / 8.0 * width, 1e-14);
            CHECK_NEAR(bat_lattice_from_plane(axis, x), u, 1e-13 * (1 + fabs(u)));
        }
        /* Lines between cells are at multiples of a power of two. */
        int exponent;
        CHECK_BITS(frexp(width / axis->cells[i - 1], &exponent), 0.5);
    }
    CHECK_INT(bat_lattice_break(axis, axis->x[axis->count - 1] + 0.01), axis->count);
}

/* A chord c under an arc of radius r has the step sqrt(8 c / r) to first order. */
TEST(a_cylinder_has_cells_around_by_the_chord_and_one_along)
{
    const double r = 5, chord = 1e-3;
    batten_surface *surface = cylinder(r, 2);
    bat_sheet sheet;
    const bat_meshing m = with_chord(chord, 10);
    bat_lattice l = begin_lattice(surface, &m, &sheet, NULL);
    const int around = sheet.closed[0] ? 0 : 1;
    int cells = 0;
    for (int k = 0; k < 2; k++)
        check_axis(&l.axis[k]);
    for (int i = 0; i + 1 < l.axis[around].count; i++)
        cells += l.axis[around].cells[i];
    /* The root cells times a power of two are the cells that are needed, rounded up. */
    const double needed = 2 * PI / sqrt(8 * chord / r);
    while (cells < needed)
        cells *= 2;
    CHECK(cells <= 1.26 * needed);
    CHECK_INT(l.axis[1 - around].count, 2);
    CHECK(l.predicted >= 1.8 * needed);
    bat_lattice_end(&l);
    CHECK(!l.axis[0].u && !l.axis[1].x && !l.seeds);
    batten_surface_unref(surface);
}

TEST(a_box_around_a_seam_has_a_line_at_the_seam)
{
    batten_surface *surface = cylinder(1, 1);
    bat_sheet sheet;
    const bat_meshing m = with_chord(0.01, 0.3);
    bat_sheet_begin(&sheet, surface, 1e-9);
    const int around = sheet.closed[0] ? 0 : 1;
    const batten_interval turn = sheet.domain[around];
    const double period = turn.b - turn.a;
    for (int k = -1; k <= 1; k++) {
        batten_interval box[2] = {sheet.domain[0], sheet.domain[1]};
        box[around] =
            (batten_interval){turn.a + (k - 0.25) * period, turn.a + (k + 0.25) * period};
        bat_lattice l;
        CHECK_OK(bat_lattice_begin(&l, &m, &sheet, box));
        CHECK_INT(l.axis[around].count, 3);
        CHECK_NEAR(l.axis[around].u[1], turn.a + k * period, 1e-12);
        CHECK_INT(l.axis[1 - around].count, 2);
        bat_lattice_end(&l);
    }
    batten_surface_unref(surface);
}

/* A roof over [0, 1]^2 with its ridge at this u, this high. */
static batten_surface *roof(double ridge, double height)
{
    const double knots[] = {0, 0, ridge, 1, 1}, across[] = {0, 0, 1, 1};
    const double points[] = {0,     0, 0,      0, 1, 0, ridge, 0, height,
                             ridge, 1, height, 1, 0, 0, 1,     1, 0};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, across, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

TEST(a_ridge_is_a_line_between_cells_and_a_knot_without_one_is_not)
{
    const bat_meshing m = with_chord(0.01, 0.3);
    for (int flat = 0; flat < 2; flat++) {
        batten_surface *surface = roof(0.375, flat ? 0 : 0.25);
        bat_sheet sheet;
        bat_lattice l = begin_lattice(surface, &m, &sheet, NULL);
        CHECK_INT(l.axis[0].count, flat ? 2 : 3);
        CHECK_INT(l.axis[1].count, 2);
        if (!flat)
            CHECK_BITS(l.axis[0].u[1], 0.375);
        check_axis(&l.axis[0]);
        bat_lattice_end(&l);
        batten_surface_unref(surface);
    }
}

/* ---- seeds ---- */

/* A second attempt adds to what the first has left. */
static batten_status find_seeds(bat_lattice *l, bat_meshing *m)
{
    l->seed_count = 0;
    return bat_lattice_seeds(l, m);
}

TEST(a_plane_needs_the_corners_of_its_box_alone)
{
    batten_surface *surface = roof(0.5, 0);
    bat_sheet sheet;
    bat_meshing m = with_chord(0.01, 0.3);
    bat_lattice l = begin_lattice(surface, &m, &sheet, NULL);
    CHECK_OK(find_seeds(&l, &m));
    CHECK_INT(l.seed_count, 4);
    CHECK_NEAR(l.predicted, 2, 1e-12);
    m.longest = 0.1; /* but for edges that are short */
    bat_lattice short_ones = begin_lattice(surface, &m, &sheet, NULL);
    CHECK_OK(find_seeds(&short_ones, &m));
    CHECK(short_ones.seed_count > 150 && short_ones.seed_count < 1200);
    bat_lattice_end(&short_ones);
    bat_lattice_end(&l);
    batten_surface_unref(surface);
}

/* Points of a lattice on a sphere: of triangles within the chord there are at least the area by that of the
 * largest, an equilateral one with the circle whose sagitta is the chord; cells need some times as many. */
TEST(the_seeds_of_a_sphere_grow_as_the_chord_falls)
{
    const batten_frame world = batten_frame_world();
    const double r = 2;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_sphere(&world, r, &surface));
    double before = 0;
    for (int i = 0; i < 3; i++) {
        const double chord = 0.02 / (1 << 2 * i);
        bat_sheet sheet;
        bat_meshing m = with_chord(chord, 10);
        bat_lattice l = begin_lattice(surface, &m, &sheet, NULL);
        CHECK_OK(find_seeds(&l, &m));
        const double radius2 = 2 * r * chord; /* of that circle, squared */
        const double triangles = 4 * PI * r * r / (0.75 * sqrt(3) * radius2);
        CHECK(l.seed_count > triangles / 2 && l.seed_count < 8 * triangles);
        CHECK(l.predicted > triangles && l.predicted < 8 * triangles);
        if (before > 0)
            CHECK(l.seed_count > 2.5 * before && l.seed_count < 6 * before);
        before = l.seed_count;
        for (int k = 1; k < l.seed_count; k++) /* coarse ones first, within the box */
            CHECK(l.seeds[k].level >= l.seeds[k - 1].level);
        for (int k = 0; k < l.seed_count; k++) {
            const double *x = l.axis[0].x, *y = l.axis[1].x;
            CHECK(l.seeds[k].x >= 0 && l.seeds[k].x <= x[l.axis[0].count - 1]);
            CHECK(l.seeds[k].y >= 0 && l.seeds[k].y <= y[l.axis[1].count - 1]);
        }
        bat_lattice_end(&l);
    }
    batten_surface_unref(surface);
}
