/* Cells in (u, v): what a surface asks for, closed forms on surfaces that are known. */
#include "mesh/faces/meshing_scene.h"

static const double PI = 3.14159265358979323846;

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
    batten_surface *surface = meshing_cylinder(r, 2);
    bat_sheet sheet;
    const bat_meshing m = meshing_alone(chord, 10);
    bat_lattice l = meshing_lattice(surface, &m, &sheet, NULL);
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
    batten_surface *surface = meshing_cylinder(1, 1);
    bat_sheet sheet;
    const bat_meshing m = meshing_alone(0.01, 0.3);
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

TEST(a_ridge_is_a_line_between_cells_and_a_knot_without_one_is_not)
{
    const bat_meshing m = meshing_alone(0.01, 0.3);
    for (int flat = 0; flat < 2; flat++) {
        batten_surface *surface = meshing_roof(0.375, flat ? 0 : 0.25);
        bat_sheet sheet;
        bat_lattice l = meshing_lattice(surface, &m, &sheet, NULL);
        CHECK_INT(l.axis[0].count, flat ? 2 : 3);
        CHECK_INT(l.axis[1].count, 2);
        if (!flat)
            CHECK_BITS(l.axis[0].u[1], 0.375);
        check_axis(&l.axis[0]);
        bat_lattice_end(&l);
        batten_surface_unref(surface);
    }
}
