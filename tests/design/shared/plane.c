#include "design/shared/plane.h"
#include "design/expect.h"

#include <batten/batten.h>
#include <math.h>

/* A wave of four points, and a screw, turned about (1, 2, 3) and moved by `far`. */
static void turn(int count, const double *from, double far, double *to)
{
    const batten_affine map = batten_affine_compose(
        batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3}, 0.7),
        batten_affine_translation(far, -far, far));
    for (int i = 0; i < count; i++) {
        const batten_vec3 at = batten_affine_apply(
            map, (batten_vec3){from[3 * i], from[3 * i + 1], from[3 * i + 2]});
        to[3 * i] = at.x;
        to[3 * i + 1] = at.y;
        to[3 * i + 2] = at.z;
    }
}

static const double wave[] = {0, 0, 0, 1, 2, 0, 2, -2, 0, 3, 0, 0};

TEST(points_in_any_plane_keep_their_distances_in_it)
{
    static const double places[] = {0, 1000};
    for (int k = 0; k < COUNT(places); k++) {
        double turned[12], flat[8];
        batten_affine map;
        turn(4, wave, places[k], turned);
        CHECK(bat_plane_find(4, turned, &map));
        bat_plane_points(&map, 4, turned, flat);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < i; j++)
                CHECK_NEAR(hypot(flat[2 * i] - flat[2 * j], flat[2 * i + 1] - flat[2 * j + 1]),
                           hypot(wave[3 * i] - wave[3 * j], wave[3 * i + 1] - wave[3 * j + 1]),
                           1e-15 * (10 + 10 * places[k]));
        /* In their own room. */
        bat_plane_points(&map, 4, turned, turned);
        for (int i = 0; i < 8; i++)
            CHECK_NEAR(turned[i], flat[i], 0);
    }
}

TEST(points_off_a_plane_in_one_line_or_in_one_place_have_none)
{
    static const double line[] = {0, 0, 0, 1, 2, 3, 2, 4, 6, -1, -2, -3};
    static const double screw[] = {0, 0, 0, 1, 2, 0, 2, -2, 1e-9, 3, 0, 0};
    static const double same[] = {1, 2, 3, 1, 2, 3, 1, 2, 3};
    batten_affine map;
    CHECK(!bat_plane_find(4, line, &map));
    CHECK(!bat_plane_find(4, screw, &map));
    CHECK(!bat_plane_find(3, same, &map));
    CHECK(!bat_plane_find(1, same, &map));
    CHECK(bat_plane_find(3, screw, &map));
}

TEST(a_curve_in_any_plane_is_judged_by_its_inflections)
{
    static const char curves[] = "  p: {points: [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0]]}\n"
                                 "  q: {rotate: p, by: 40 deg, axis: [1, 2, 3]}\n"
                                 "  level: {interpolate: p}\n  tilted: {interpolate: q}\n"
                                 "  wavy: {points: [[0, 0], [5, 0.1], [5.5, 0.5], [5.6, 5]]}\n"
                                 "  turned: {rotate: wavy, by: 40 deg, axis: [1, 2, 3]}\n"
                                 "  row: {interpolate: wavy, parameters: uniform}\n"
                                 "  high: {interpolate: turned, parameters: uniform}\n";
    static const expect_row rows[] = {
        {"k.json: {check: level}", BATTEN_OK, "\"excess_inflections\": 0"},
        {"k.json: {check: tilted}", BATTEN_OK, "\"excess_inflections\": 0"},
        {"k.json: {check: row}", BATTEN_OK, "\"fair\": false|\"excess_inflections\": 2"},
        {"k.json: {check: high}", BATTEN_OK, "\"fair\": false|\"excess_inflections\": 2"},
    };
    EXPECT_OUTPUTS(curves, rows);
}
