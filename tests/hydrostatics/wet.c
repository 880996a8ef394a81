/* Every sum over the wet part of one flat patch, in closed form. */
#include "hydrostatics/wet.h"
#include "support/test.h"

/* A parallelogram: its corner, both sides, and the sums below z = 0; that of |N| apart. */
static const struct {
    double corner[3], sides[2][3], sign;
    double sums[BAT_WETTED], area;
    double flux, normal[3]; /* of all of it */
} plates[] = {
    /* a wall at y = 1, from z = -1 to 1, that faces +y: nothing but its opening across */
    {{0, 1, -1}, {{2, 0, 0}, {0, 0, 2}}, -1, {[BAT_OPENING + 1] = 2}, 2, 4, {0, 4, 0}},
    /* a bottom at z = -1, from (0, 0) to (2, 3) */
    {{0, 0, -1},
     {{2, 0, 0}, {0, 3, 0}},
     -1,
     {6, 6, 9, -3, 6, 6, 9, 8, 9, 18},
     6,
     6,
     {0, 0, -6}},
    /* a bilge through the water, from (0, -1) up to (2, 1) in y and z */
    {{0, 0, -1},
     {{2, 0, 0}, {0, 2, 2}},
     -1,
     {1, 1, 1.0 / 3, -1.0 / 3, 2, 2, 1, 8.0 / 3, 1, 2.0 / 3, 0, 2},
     2 * 1.4142135623730950488,
     4,
     {0, 4, -4}},
    /* a deck above the water */
    {{0, 0, 1}, {{2, 0, 0}, {0, 3, 0}}, 1, {0}, 0, 6, {0, 0, 6}},
};

/* With u for v in odd turns, and the second side the other way from turn 2 on: the sign goes along. */
static bat_patch plate_of(int plate, int turn, int lid, double points[16])
{
    const double(*sides)[3] = plates[plate].sides;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const int along[2] = {turn & 1 ? j : i, (turn & 1 ? i : j) ^ (turn >> 1)};
            double *p = points + 4 * (2 * i + j);
            p[3] = 2;
            for (int c = 0; c < 3; c++)
                p[c] = 2 * (plates[plate].corner[c] + along[0] * sides[0][c] +
                            along[1] * sides[1][c]);
        }
    const bool flipped = (turn & 1) != turn >> 1;
    return (bat_patch){lid, {1, 1}, flipped ? -plates[plate].sign : plates[plate].sign, points};
}

static const bat_water level = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 0};

TEST(the_sums_of_a_plate_are_those_of_its_wet_part_whatever_its_parameters)
{
    static const int lids[] = {BAT_SKIN, 0, BAT_JOINT};
    for (int plate = 0; plate < COUNT(plates); plate++)
        for (int i = 0; i < 4 * COUNT(lids); i++) {
            const int lid = lids[i / 4];
            double points[16];
            bat_patch patch = plate_of(plate, i % 4, lid, points);
            const batten_hull hull = {.patch_count = 1, .patches = &patch, .size = 1};
            bat_wet wet;
            CHECK_OK(bat_hull_wet(&hull, &level, 1e-12, NULL, &wet));
            for (int k = 0; k < BAT_WETTED; k++)
                CHECK_NEAR(wet.sums[k], plates[plate].sums[k], 1e-12);
            CHECK_NEAR(wet.sums[BAT_WETTED], lid == BAT_SKIN ? plates[plate].area : 0, 1e-12);
            CHECK_NEAR(wet.sums[BAT_WET_LIDS], lid >= 0 ? plates[plate].area : 0, 1e-12);
            CHECK(!wet.limited);
            for (int k = 0; k < BAT_SUMS; k++)
                CHECK(wet.errors[k] >= 0 && wet.errors[k] <= 1e-11);
        }
}

/* The flux of P through a plate is its distance from the origin times its area. */
TEST(the_flux_and_the_area_of_a_plate_are_those_of_all_of_it)
{
    for (int plate = 0; plate < COUNT(plates); plate++)
        for (int turn = 0; turn < 4; turn++) {
            const double *due = plates[plate].normal;
            double points[16], flux[4] = {5, 4, 1, 7}, normal[4] = {1, 2, 3, 7}, area = 0;
            const bat_patch patch = plate_of(plate, turn, BAT_SKIN, points);
            bat_patch_flux(&patch, flux, normal); /* added to what is there */
            CHECK_NEAR(flux[0] + flux[1] + flux[2], 10 + plates[plate].flux, 1e-14);
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(normal[c], c + 1 + due[c], 1e-14);
            CHECK(flux[3] == 7 && normal[3] == 7); /* three each, and no more */
            CHECK_OK(bat_patch_area(&patch, &area));
            CHECK_NEAR(area, hypot(due[1], due[2]), 1e-13);
        }
}
