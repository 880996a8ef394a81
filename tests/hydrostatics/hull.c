/* Hulls from surfaces: which side is out, and what closes them. */
#include "hydrostatics/hulls.h"
#include "support/test.h"

#include <batten/standard.h>

static const batten_flotation HALF = {0, 0, 0};

static double volume_of(const batten_hull *hull, batten_flotation at)
{
    batten_hydrostatics v;
    CHECK_OK(batten_hull_hydrostatics(hull, &at, 1e-12, NULL, &v));
    CHECK_NEAR(v.open[0] + v.open[1], 0, 1e-9);
    return v.volume;
}

TEST(a_sphere_is_a_hull_that_is_closed_by_itself)
{
    const batten_frame world = batten_frame_world();
    const double pi = 3.14159265358979323846;
    batten_surface *ball = NULL;
    batten_hull *hull = NULL;
    batten_hull_options options = batten_hull_defaults();
    options.whole = true;
    CHECK_OK(batten_surface_sphere(&world, 2, &ball));
    CHECK_OK(batten_hull_create(1, (const batten_surface *const[]){ball}, &options, &hull));
    batten_hydrostatics v;
    const batten_flotation tilted = {0, 0.3, 0.7};
    CHECK_OK(batten_hull_hydrostatics(hull, &tilted, 1e-10, NULL, &v));
    CHECK_NEAR(v.volume, pi * 16 / 3, 1e-8);
    CHECK_NEAR(v.waterplane, pi * 4, 1e-8);
    CHECK_NEAR(v.wetted, pi * 8, 1e-7);
    CHECK_NEAR(v.along, pi * 4, 1e-7);
    CHECK_NEAR(v.across, pi * 4, 1e-7);
    /* 3/8 of the radius below the plane, along its normal */
    CHECK_NEAR(v.buoyancy.x, -0.75 * sin(0.3), 1e-8);
    CHECK_NEAR(v.buoyancy.y, -0.75 * cos(0.3) * sin(0.7), 1e-8);
    CHECK_NEAR(v.buoyancy.z, -0.75 * cos(0.3) * cos(0.7), 1e-8);
    CHECK_NEAR(v.open[0] + v.open[1], 0, 1e-8);
    batten_hull_free(hull);
    batten_surface_unref(ball);
}

/* Half of a cylinder along x, of radius 1. */
TEST(a_cylinder_on_its_side_is_closed_by_its_ends)
{
    const double r = 0.70710678118654752440, pi = 3.14159265358979323846;
    const double section[5][3] = {{0, -1, 1}, {1, -1, r}, {1, 0, 1}, {1, 1, r}, {0, 1, 1}};
    static const double knots_u[] = {0, 0, 1, 1}, knots_v[] = {0, 0, 0, 1, 1, 2, 2, 2};
    double points[2][5][3], weights[2][5];
    batten_surface *half = NULL;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 5; j++) {
            points[i][j][0] = 6 * i;
            points[i][j][1] = section[j][0];
            points[i][j][2] = section[j][1];
            weights[i][j] = section[j][2];
        }
    const batten_axis u = {1, 2, knots_u, false}, v = {2, 5, knots_v, false};
    CHECK_OK(batten_surface_create(3, &u, &v, &points[0][0][0], &weights[0][0], &half));
    batten_hull *hull = hull_of(half);
    int count;
    const batten_hull_lid *lids = batten_hull_lids(hull, &count);
    CHECK_INT(count, 2);
    CHECK_NEAR(lids[0].area, pi, 1e-9);
    CHECK_NEAR(lids[1].edge.low.x, 6, 0);
    CHECK(lids[0].direction == BATTEN_U && !lids[0].high && lids[1].high);
    CHECK_NEAR(volume_of(hull, HALF), pi * 3, 1e-9);
    CHECK_NEAR(volume_of(hull, (batten_flotation){0, 0, 1}), pi * 3, 1e-9);
    CHECK_NEAR(volume_of(hull, (batten_flotation){2, 0, 0}), pi * 6, 1e-9);
    CHECK_NEAR(volume_of(hull, (batten_flotation){-2, 0, 0}), 0, 0);
    batten_hull_free(hull);
}

/* Whatever way the parameters run. */
TEST(the_outside_is_found)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}};
    for (int way = 0; way < 4; way++) {
        batten_surface *half = half_prism(0, 4, 3, section), *turned = NULL;
        CHECK_OK(way == 3   ? batten_surface_swap(half, &turned)
                 : way == 2 ? batten_surface_reverse(half, BATTEN_V, &turned)
                 : way == 1 ? batten_surface_reverse(half, BATTEN_U, &turned)
                            : (turned = batten_surface_ref(half), BATTEN_OK));
        batten_hull *hull = hull_of(turned);
        CHECK_NEAR(volume_of(hull, (batten_flotation){1, 0.1, 0.2}),
                   8 - 16 * tan(0.1) / cos(0.2), 1e-12);
        batten_hull_free(hull);
        batten_surface_unref(half);
    }
}

TEST(edges_along_other_surfaces_need_no_lid)
{
    static const double bottom[][2] = {{0, 0}, {1, 0}}, side[][2] = {{1, 0}, {1, 2}};
    batten_surface *parts[3] = {half_prism(0, 4, 2, bottom), half_prism(0, 1.5, 2, side),
                                half_prism(1.5, 4, 2, side)};
    batten_hull *hull = NULL;
    int count;
    CHECK_OK(batten_hull_create(3, (const batten_surface *const *)parts, NULL, &hull));
    const batten_hull_lid *lids = batten_hull_lids(hull, &count);
    CHECK_INT(count, 6); /* the ends of bottom and sides, and two parts of the deck */
    for (int k = 0; k < count; k++)
        CHECK_INT(lids[k].surface, k / 2);
    CHECK(!lids[2].high && lids[4].high); /* fore and aft ends of the sides */
    CHECK_NEAR(lids[3].area + lids[5].area, 8, 1e-12);
    CHECK_NEAR(volume_of(hull, (batten_flotation){1, 0, 0.3}), 8, 1e-12);
    batten_hull_free(hull);
    for (int k = 0; k < 3; k++)
        batten_surface_unref(parts[k]);
}

TEST(what_is_no_hull_is_refused_with_its_number)
{
    static const double section[][2] = {{0, 0}, {1, 0}};
    batten_surface *half = half_prism(0, 4, 2, section);
    batten_hull *hull = NULL;
    batten_hull_options options = batten_hull_defaults();
    CHECK_STATUS(batten_hull_create(0, NULL, NULL, &hull), BATTEN_BAD_ARGUMENT);
    options.tolerance = -1;
    CHECK_STATUS(batten_hull_create(1, (const batten_surface *const[]){half}, &options, &hull),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance of a hull is -1; it must be 0 or above");
    options.tolerance = INFINITY;
    CHECK_STATUS(batten_hull_create(1, (const batten_surface *const[]){half}, &options, &hull),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_hull_create(-1, NULL, NULL, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a hull of -1 surfaces; at least 1 is needed");
    const batten_axis axis = {1, 2, (const double[]){0, 0, 1, 1}, false};
    batten_surface *flat = NULL;
    batten_surface *point = half_prism(1, 1, 2, (const double[][2]){{0, 0}, {0, 0}});
    CHECK_OK(batten_surface_create(2, &axis, &axis, (const double[]){0, 0, 0, 1, 1, 0, 1, 1},
                                   NULL, &flat));
    CHECK_STATUS(
        batten_hull_create(2, (const batten_surface *const[]){half, flat}, NULL, &hull),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("surface 2 of a hull has 2 dimensions; it must have 3");
    CHECK_STATUS(batten_hull_create(1, (const batten_surface *const[]){point}, NULL, &hull),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the hull reaches 0 at most; it needs a size");
    batten_surface_unref(flat);
    batten_surface_unref(point);
    CHECK(!hull);
    batten_surface_unref(half);
}

/* A demihull of two sides: the inner one faces the centre plane. */
TEST(inner_sides_of_their_own_and_open_hulls_that_are_said_to_be_whole_are_refused)
{
    static const double outer[][2] = {{3, 0}, {4, 2}}, inner[][2] = {{3, 0}, {2, 2}};
    static const double tray[][2] = {{-2, 1}, {-2, 0}, {2, 0}, {2, 1}};
    batten_surface *sides[2] = {half_prism(0, 10, 2, outer), half_prism(0, 10, 2, inner)};
    batten_surface *open = half_prism(0, 10, 4, tray);
    batten_hull *hull = NULL;
    batten_hull_options whole = batten_hull_defaults();
    whole.whole = true;
    CHECK_STATUS(batten_hull_create(2, (const batten_surface *const *)sides, NULL, &hull),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("face to different sides");
    CHECK_STATUS(batten_hull_create(1, (const batten_surface *const[]){open}, &whole, &hull),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("surface 1 of a whole hull is not closed: 40 of its area");
    batten_surface *tube = NULL; /* both its ends lack the same */
    const batten_frame frame = batten_frame_world();
    CHECK_OK(batten_surface_cylinder(&frame, 1, 2, &tube));
    CHECK_STATUS(batten_hull_create(1, (const batten_surface *const[]){tube}, &whole, &hull),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("surface 1 of a whole hull is not closed: its volume is ");
    CHECK_MESSAGE(" along y and 0 along z");
    batten_surface_unref(tube);
    CHECK(!hull);
    batten_surface_unref(sides[0]);
    batten_surface_unref(sides[1]);
    batten_surface_unref(open);
}

static void check_lid(const batten_hull_lid *lid, batten_direction direction, bool high,
                      batten_box edge, double area)
{
    CHECK_INT(lid->surface, 0);
    CHECK_INT(lid->direction, direction);
    CHECK_INT(lid->high, high);
    CHECK_NEAR(lid->area, area, 1e-12);
    CHECK(memcmp(&lid->edge, &edge, sizeof edge) == 0);
}

TEST(the_lids_of_a_box_are_its_ends_and_its_deck)
{
    batten_hull *hull = box_hull();
    int count;
    const batten_hull_lid *lids = batten_hull_lids(hull, &count);
    CHECK_INT(count, 3);
    check_lid(&lids[0], BATTEN_U, false, (batten_box){{0, 0, 0}, {0, 1, 2}}, 4);
    check_lid(&lids[1], BATTEN_U, true, (batten_box){{4, 0, 0}, {4, 1, 2}}, 4);
    check_lid(&lids[2], BATTEN_V, true, (batten_box){{0, 1, 2}, {4, 1, 2}}, 8);
    const batten_box box = batten_hull_box(hull), both = {{0, -1, 0}, {4, 1, 2}};
    CHECK(memcmp(&box, &both, sizeof box) == 0);
    batten_hull_free(hull);
    batten_hull_free(NULL);
}

TEST(lids_of_a_side_alone_are_listed_by_direction_and_then_from_low_to_high)
{
    static const double side[][2] = {{1, 0}, {3, 2}};
    batten_hull *hull = hull_of(half_prism(0, 4, 2, side));
    int count;
    const batten_hull_lid *lids = batten_hull_lids(hull, &count);
    CHECK_INT(count, 4);
    check_lid(&lids[0], BATTEN_U, false, (batten_box){{0, 1, 0}, {0, 3, 2}}, 8);
    check_lid(&lids[1], BATTEN_U, true, (batten_box){{4, 1, 0}, {4, 3, 2}}, 8);
    check_lid(&lids[2], BATTEN_V, false, (batten_box){{0, 1, 0}, {4, 1, 0}}, 8);
    check_lid(&lids[3], BATTEN_V, true, (batten_box){{0, 3, 2}, {4, 3, 2}}, 24);
    CHECK_NEAR(volume_of(hull, (batten_flotation){1, 0, 0}), 12, 1e-12);
    batten_hull_free(hull);
}

/* Of other degrees in both directions, and of several patches each way, in either order. */
TEST(a_box_is_the_same_of_any_degrees_and_patches)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}}, knots[] = {0.2, 0.7};
    const oblique_box box = box_at(0.1, 0.2);
    for (int way = 0; way < 8; way++) {
        const batten_direction direction = way & 1 ? BATTEN_V : BATTEN_U;
        batten_surface *half = half_prism(0, 4, 3, section), *high = NULL, *cut = NULL,
                       *turned = NULL;
        CHECK_OK(batten_surface_elevate(half, direction, 2, &high));
        CHECK_OK(way & 2 ? batten_surface_refine(high, BATTEN_U, 2, knots, &cut)
                         : (cut = batten_surface_ref(high), BATTEN_OK));
        CHECK_OK(way & 4 ? batten_surface_swap(cut, &turned)
                         : (turned = batten_surface_ref(cut), BATTEN_OK));
        batten_hull *hull = hull_of(turned);
        batten_hydrostatics v;
        int count;
        CHECK_OK(batten_hull_hydrostatics(hull, &box.at, 1e-11, NULL, &v));
        CHECK_NEAR(v.volume, 7.2, 1e-10);
        CHECK_NEAR(v.waterplane, box.waterplane, 1e-9);
        CHECK_NEAR(v.along, box.second[0], 1e-8);
        CHECK_NEAR(v.across, box.second[2], 1e-8);
        CHECK_NEAR(v.wetted, 15.2, 1e-9);
        CHECK_NEAR(v.lids, 3.6, 1e-9);
        CHECK_NEAR(v.open[0] + v.open[1], 0, 1e-10);
        const batten_hull_lid *lids = batten_hull_lids(hull, &count);
        CHECK_INT(count, 3);
        CHECK_NEAR(lids[0].area + lids[1].area + lids[2].area, 16, 1e-12);
        batten_hull_free(hull);
        batten_surface_unref(half);
        batten_surface_unref(high);
        batten_surface_unref(cut);
    }
}
