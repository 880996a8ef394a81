#include "design/shared/rows.h"

#include "design/expect.h"
#include "design/text/document.h"
#include "support/test.h"

#include <batten/batten.h>
#include <batten/standard.h>
#include <math.h>
#include <string.h>

TEST(a_flat_row_goes_into_its_plane_and_back)
{
    for (int axis = 0; axis < 3; axis++) {
        double points[15], back[15];
        for (int i = 0; i < 15; i++)
            back[i] = points[i] = i % 3 == axis ? 7.5 : i * i - 3.0;
        CHECK_INT(bat_flat_axis(5, points), axis);
        double *plane = bat_points_in_plane(axis, 5, points);
        if (!plane)
            return;
        for (int i = 0; i < 15; i++)
            back[i] = i % 3 == axis ? 7.5 : 0;
        bat_points_from_plane(axis, 5, plane, back);
        CHECK(memcmp(points, back, sizeof points) == 0);
        bat_release(plane);
    }
    CHECK_INT(bat_flat_axis(2, (const double[]){0, 0, 0, 1, 1, 1}), -1);
}

static batten_status make_table(batten_offset_table **out)
{
    const batten_table_line lines[] = {{"z=0", true, 0}, {"z=1", true, 1}};
    const batten_table_point first[] = {{0, 1, 0, 0}, {0, 2, 1, 1}}, second[] = {{5, 3, 1, 1}};
    const batten_table_station stations[] = {{"0", 0, 2, first}, {"1", 5, 1, second}};
    return batten_offset_table_create(1, 2, lines, 2, stations, out);
}

TEST(a_table_has_rows_across_and_along)
{
    batten_offset_table *table = NULL;
    bat_rows rows = {0, NULL};
    CHECK_OK(make_table(&table));
    const batten_object object = {
        .name = "t", .kind = BATTEN_OBJECT_OFFSET_TABLE, .offset_table = table};
    CHECK_OK(bat_rows_of(&object, false, &rows));
    CHECK_INT(rows.count, 2);
    CHECK_INT(rows.rows[0].count, 2);
    CHECK_BITS(rows.rows[0].points[4], 2);
    bat_rows_release(&rows);
    CHECK_OK(bat_rows_of(&object, true, &rows));
    CHECK_TEXT(rows.rows[1].name, "z=1");
    CHECK_INT(rows.rows[0].count, 1);
    CHECK_INT(rows.rows[1].count, 2);
    CHECK_BITS(rows.rows[1].points[3], 5);
    bat_rows_release(&rows);
    batten_offset_table_unref(table);
}

TEST(a_curve_in_its_plane_keeps_two_coordinates)
{
    const double points[] = {1, 2, 3, 4, 5, 6};
    for (int axis = -1; axis < 3; axis++) {
        batten_curve *line = NULL, *plane = NULL;
        CHECK_OK(batten_curve_line(3, points, points + 3, &line));
        CHECK_OK(bat_curve_in_plane(line, axis, &plane));
        const int dimension = axis < 0 ? 3 : 2;
        CHECK_INT(batten_curve_dimension(plane), dimension);
        for (int i = 0, k = 0; i < 6; i++)
            if (i % 3 != axis)
                CHECK_BITS(batten_curve_points(plane)[k++], points[i]);
        batten_curve_unref(plane);
        batten_curve_unref(line);
    }
}

/* ---- how far points are from each other ---- */

/* Distances 5, 0, 13, 1 from each to the next. */
static const double spread_row[5][3] = {
    {1, 1, 0}, {4, 5, 0}, {4, 5, 0}, {4, 0, 12}, {4, 0, 13}};

TEST(neighbours_are_as_far_apart_as_their_squares_say_at_any_scale)
{
    static const int scales[] = {0, 1019, -1000, -1074};
    for (int s = 0; s < COUNT(scales); s++)
        for (size_t step = 1; step <= 2; step++) {
            double points[5 * 6] = {0};
            for (size_t i = 0; i < 5; i++)
                for (size_t k = 0; k < 3; k++)
                    points[3 * step * i + k] = ldexp(spread_row[i][k], scales[s]);
            const bat_spread spread = bat_spread_of(5, points, step);
            CHECK_BITS(spread.least, ldexp(1, scales[s]));
            CHECK_BITS(spread.most, ldexp(13, scales[s]));
            CHECK_BITS(spread.largest, ldexp(13, scales[s]));
            CHECK_INT(spread.at, 3);
        }
    CHECK_BITS(bat_spread_of(3, &spread_row[0][0], 1).least, 5);
    CHECK_INT(bat_spread_of(4, &spread_row[0][0], 1).at, 0);
    CHECK_BITS(bat_spread_of(1, &spread_row[0][0], 1).most, 0);
    CHECK(bat_spread_of(2, (const double[]){0, 0, 0, 0, 0, 0}, 1).most == 0);
}

TEST(points_are_uneven_when_one_distance_is_more_than_a_million_times_another)
{
    CHECK(!bat_spread_is_uneven(&(bat_spread){.least = 2, .most = 2e6}));
    CHECK(bat_spread_is_uneven(&(bat_spread){.least = 2, .most = 2.000001e6}));
}

/* With 2e-14 of the largest coordinate lost, and neighbours a millionth as far apart as others. */
static const struct {
    double points[9];
    const char *notes[2];
} reaches[] = {
    {{0, 0, 0, 1, 0, 0, 1, 0, 2}, {NULL, NULL}},
    {{0, 0, 0, 0, 0, 3, 0, 1e-6, 3},
     {"'row': points 2 and 3 are 1e-06 apart, others up to 3; curves through such points may turn "
      "sharply between them: 'thin-points' merges what is meant to be one",
      NULL}},
    {{0, 0, 0, 0, -1e10, 0, 1, 0, 0},
     {"'row': coordinates of up to 1e+10 lose 0.00014 to rounding, more than the tolerance 0.0001; "
      "move the points towards the origin, or ask for less",
      NULL}},
    {{0, 0, 0, 0, -1e9, 0, 1, -1e9, 0},
     {"'row': points 2 and 3 are 1 apart, others up to 1e+09; curves through such points may turn "
      "sharply between them: 'thin-points' merges what is meant to be one",
      NULL}},
    {{1e10, 0, 0, 0, 0, 0, 0, 0, 1},
     {"'row': points 2 and 3 are 1 apart, others up to 1e+10; curves through such points may turn "
      "sharply between them: 'thin-points' merges what is meant to be one",
      "'row': coordinates of up to 1e+10 lose 0.00014 to rounding, more than the tolerance 0.0001; "
      "move the points towards the origin, or ask for less"}},
};

TEST(points_that_rounding_or_their_spacing_endangers_are_noted_with_their_figures)
{
    const bat_document document = {.file_name = "", .tolerance = 1e-4};
    for (int i = 0; i < COUNT(reaches); i++) {
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(4, &notes));
        const bat_run run = {.name = "a", .document = &document, .notes = notes};
        bat_note_spacing(&run, "row", 3, reaches[i].points);
        const int count = (reaches[i].notes[0] != NULL) + (reaches[i].notes[1] != NULL);
        CHECK_INT(batten_notes_count(notes) + batten_notes_dropped(notes), count);
        for (int k = 0; k < count && batten_notes_dropped(notes) == 0; k++)
            CHECK_TEXT(batten_notes_at(notes, k)->text, reaches[i].notes[k]);
        batten_notes_free(notes);
    }
}

TEST(the_largest_coordinate_is_from_1e_90_to_1e90_or_0)
{
    static const struct {
        double coordinate;
        bool fits;
    } cases[] = {{0, true},    {1e-90, true}, {-1e-90, true},   {0.99e-90, false},
                 {1e90, true}, {-1e90, true}, {1.01e90, false}, {-2e90, false}};
    for (int i = 0; i < COUNT(cases); i++)
        for (int k = 0; k < 6; k++) {
            double points[6] = {0};
            points[k] = cases[i].coordinate;
            CHECK_STATUS(bat_points_check_size(2, points),
                         cases[i].fits ? BATTEN_OK : BATTEN_BAD_ARGUMENT);
        }
    CHECK_STATUS(bat_points_check_size(1, (const double[]){0, -3e95, 0}), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE(
        "the largest coordinate is 3e+95; from 1e-90 to 1e+90 can be worked with: choose "
        "another unit");
}

/* Heights above the corners of a square from one feature, above its middle from another. */
TEST(points_of_all_features_and_of_all_stations_are_gathered)
{
    static const char points[] =
        "  corners: {points: [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]}\n"
        "  middle: {points: [[1, 1, 1]]}\n  far: {points: [[1, 0.5, 1e95]]}\n"
        "  s: {line: [[0, 0], [1, 0]]}\n";
    static const expect_row rows[] = {
        {"{scattered-surface: [corners, middle]}", BATTEN_OK, "box 0 0 0 2 2 1"},
        {"{scattered-surface: [middle, corners]}", BATTEN_OK, "box 0 0 0 2 2 1"},
        {"{scattered-surface: [middle, corners, far]}", BATTEN_BAD_ARGUMENT,
         "the largest coordinate is 1e+95"},
        {"{scattered-surface: [corners, s]}", BATTEN_BAD_ARGUMENT,
         "'scattered-surface' takes points or tables of offsets, and 's' is a curve"},
    };
    EXPECT(points, rows);
}

/* ---- planes wherever they lie ---- */

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
