/* Seeds: the corners of cells that are small enough. */
#include "mesh/faces/meshing_scene.h"

#include <batten/standard.h>

static const double PI = 3.14159265358979323846;

/* A second attempt adds to what the first has left. */
static batten_status find_seeds(bat_lattice *l, bat_meshing *m)
{
    l->seed_count = 0;
    return bat_lattice_seeds(l, m);
}

TEST(a_plane_needs_the_corners_of_its_box_alone)
{
    batten_surface *surface = meshing_roof(0.5, 0);
    bat_sheet sheet;
    bat_meshing m = meshing_alone(0.01, 0.3);
    bat_lattice l = meshing_lattice(surface, &m, &sheet, NULL);
    CHECK_OK(find_seeds(&l, &m));
    CHECK_INT(l.seed_count, 4);
    CHECK_NEAR(l.predicted, 2, 1e-12);
    m.longest = 0.1; /* but for edges that are short */
    bat_lattice short_ones = meshing_lattice(surface, &m, &sheet, NULL);
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
        bat_meshing m = meshing_alone(chord, 10);
        bat_lattice l = meshing_lattice(surface, &m, &sheet, NULL);
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
