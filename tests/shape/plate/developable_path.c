/* The path of least warp between edges where it is known. */
#include "shape/plate/developable_parts.h"

#include "shape/plate/plates.h"

/* Coaxial arcs of 1.5 radians from these angles on: rulings join equal angles, cones what is left over. */
static const struct {
    double from[2];
    bat_pair first, last;
} rows[] = {
    {{0, 0}, {0, 0}, {1, 1}},
    {{0, 0.3}, {0.2, 0}, {1, 0.8}},
    {{0.3, 0}, {0, 0.2}, {0.8, 1}},
    {{0, 0.75}, {0.5, 0}, {1, 0.5}},
};

static void begin_plate(int row, batten_curve *curves[2], bat_plate *plate)
{
    *plate = (bat_plate){.size = 3};
    curves[0] = arc(1, rows[row].from[0], rows[row].from[0] + 1.5, 0);
    curves[1] = reparametrised(arc(2, rows[row].from[1], rows[row].from[1] + 1.5, 1));
    for (int e = 0; e < 2; e++)
        CHECK_OK(bat_plate_edge_make(curves[e], e ? "second" : "first", &plate->edge[e]));
}

/* A failure leaves no pairs behind. */
static batten_status find_path(bat_plate *plate)
{
    const batten_status status = bat_plate_find_path(plate);
    if (status != BATTEN_OK) {
        bat_release(plate->pairs);
        plate->pairs = NULL;
    }
    return status;
}

TEST(the_path_joins_equal_angles_of_coaxial_arcs_between_its_cones)
{
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve *curves[2];
        bat_plate plate;
        begin_plate(i, curves, &plate);
        CHECK_OK(find_path(&plate));
        CHECK(plate.count >= 2 && !plate.rough);
        const bat_pair first = plate.pairs[0], last = plate.pairs[plate.count - 1];
        CHECK_NEAR(first.x, rows[i].first.x, 1e-6);
        CHECK_NEAR(first.y, rows[i].first.y, 1e-6);
        CHECK_NEAR(last.x, rows[i].last.x, 1e-6);
        CHECK_NEAR(last.y, rows[i].last.y, 1e-6);
        for (int k = 0; k < plate.count; k++) {
            const bat_pair p = plate.pairs[k];
            CHECK_NEAR(p.y - p.x, rows[i].first.y - rows[i].first.x, 0.5 / BAT_EDGE_STEPS);
            CHECK(k == 0 || p.x + p.y > plate.pairs[k - 1].x + plate.pairs[k - 1].y);
        }
        bat_release(plate.pairs);
        drop(curves[0], curves[1]);
    }
}

TEST(pairs_are_smoothed_towards_the_means_of_their_neighbours_and_the_ends_stay)
{
    bat_pair pairs[] = {{0, 0}, {0.5, 0.1}, {0.6, 0.8}, {1, 1}};
    bat_plate plate = {.count = 4, .pairs = pairs};
    bat_plate_smooth(&plate, 400);
    for (int i = 0; i < 4; i++) {
        CHECK_NEAR(pairs[i].x, i / 3.0, 1e-9);
        CHECK_NEAR(pairs[i].y, i / 3.0, 1e-9);
    }
}
