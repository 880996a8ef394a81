#include "loft/hull.h"

#include "support/test.h"

#include <math.h>

enum { MOST = 6 };

/* Stations with these names and points, all on one line "wale". */
typedef struct {
    const char *name;
    double x;
    int count;
    double yz[MOST][2];
} given_station;

static batten_offset_table *make_table(int count, const given_station *given)
{
    static const batten_table_line wale = {"wale", false, 0};
    batten_table_point points[4][MOST];
    batten_table_station stations[4];
    batten_offset_table *table = NULL;
    for (int k = 0; k < count; k++) {
        for (int i = 0; i < given[k].count; i++)
            points[k][i] =
                (batten_table_point){given[k].x, given[k].yz[i][0], given[k].yz[i][1], 0};
        stations[k] =
            (batten_table_station){given[k].name, given[k].x, given[k].count, points[k]};
    }
    CHECK_OK(batten_offset_table_create(1, 1, &wale, count, stations, &table));
    return table;
}

/* A round section, one from the sheer down, one above its keel, and a stem. */
static const given_station boat[] = {
    {"transom", 0, 4, {{0, 0}, {3, 0}, {3, 4}, {4, 4}}},
    {"1", 1, 3, {{4, 4}, {3, 0}, {0, 0}}},
    {"", 2, 5, {{0, -1}, {0, -0.5}, {0, 0}, {1, 0}, {1, 2}}},
    {"stem", 3, 2, {{0, 0}, {0, 4}}},
};

TEST(stations_run_from_the_profile_to_the_sheer_without_what_lies_below)
{
    static const int counts[] = {4, 3, 3, 2}, first[] = {0, 2, 2, 0}, last[] = {3, 0, 4, 1};
    static const double v1[] = {0, 3 / 8., 7 / 8., 1};
    batten_offset_table *table = make_table(4, boat);
    bat_hull_table hull = {0};
    CHECK_OK(bat_hull_take_stations(table, &hull));
    for (int k = 0; k < 4; k++) {
        const bat_hull_station *s = hull.stations + k;
        CHECK_OK(bat_hull_measure_girth(table, k, hull.stations + k));
        CHECK_INT(s->count, counts[k]);
        CHECK_INT(s->from[0], first[k]);
        CHECK_INT(s->from[s->count - 1], last[k]);
        CHECK(s->is_stem == (k == 3));
        CHECK(s->v[0] == 0 && s->v[s->count - 1] == 1);
    }
    for (int i = 0; i < 4; i++)
        CHECK_NEAR(hull.stations[0].v[i], v1[i], 1e-15);
    CHECK_INT(hull.trimmed, 2);
    bat_hull_count(&hull);
    CHECK_INT(hull.most_points, 4);
    CHECK(hull.breadth == 4 && hull.least == 0);
    bat_arena_free(&hull.arena);
    batten_offset_table_unref(table);
}

/* Tables of three stations that are refused. */
static const struct {
    given_station stations[3];
    batten_status status;
    const char *message;
} refused[] = {
    {{{"a", 0, 3, {{0, 0}, {1, 1}, {2, 2}}},
      {"b", 1, 1, {{1, 1}}},
      {"c", 2, 2, {{0, 0}, {1, 1}}}},
     BATTEN_TOO_FEW_POINTS,
     "station 'b' (x = 1) has 1 point of the hull"},
    {{{"", 0, 3, {{0, 0}, {1, 1}, {1, 1}}},
      {"b", 1, 2, {{0, 0}, {1, 1}}},
      {"c", 2, 2, {{0, 0}, {1, 1}}}},
     BATTEN_COINCIDENT,
     "station 1 (x = 0): points 2 and 3 coincide"},
    {{{"a", 0, 3, {{0, 0}, {1, 1}, {2, 2}}},
      {"b", 1, 3, {{0, 0}, {1, 1}, {2, 2}}},
      {"c", 2, 2, {{0, 0}, {1, 1}}}},
     BATTEN_TOO_FEW_POINTS,
     "at least 3 stations of 3 points; the table has 2"},
    {{{"0", 0, 3, {{0, 0}, {1, 1}, {2, 2}}},
      {"b", 1, 3, {{0, 0}, {1, 0}, {1, 1}}},
      {"c", 2, 3, {{0, 0}, {1, 0}, {1, 1}}}},
     BATTEN_UNSUPPORTED,
     "2 of 3 stations have a knuckle: station 'b' (x = 1) turns by 90 degrees at point 2, on the "
     "line 'wale'"},
};

TEST(tables_that_cannot_be_lofted_are_refused_by_the_names_of_their_stations)
{
    for (int k = 0; k < COUNT(refused); k++) {
        batten_offset_table *table = make_table(3, refused[k].stations);
        bat_hull_table hull = {0};
        CHECK_STATUS(bat_hull_take_table(table, &hull), refused[k].status);
        CHECK_MESSAGE(refused[k].message);
        bat_arena_free(&hull.arena);
        batten_offset_table_unref(table);
    }
}

TEST(one_sharp_bilge_among_three_stations_is_not_a_chine)
{
    static const given_station stations[] = {
        {"", 0, 3, {{0, 0}, {1, 0}, {1, 1}}},
        {"", 1, 3, {{0, 0}, {1, 1}, {2, 2}}},
        {"", 2, 3, {{0, 0}, {1, 1}, {2, 2}}},
    };
    batten_offset_table *table = make_table(3, stations);
    bat_hull_table hull = {0};
    CHECK_OK(bat_hull_take_table(table, &hull));
    bat_arena_free(&hull.arena);
    batten_offset_table_unref(table);
}

TEST(bounds_run_from_a_billionth_of_the_size_to_the_half_breadth)
{
    batten_offset_table *table = make_table(4, boat);
    bat_hull_table hull = {0};
    CHECK_OK(bat_hull_take_stations(table, &hull));
    bat_hull_count(&hull);
    const double least = 1e-9 * sqrt(9 + 16 + 25);
    CHECK_OK(bat_hull_check_bound(&hull, 4));
    CHECK_OK(bat_hull_check_bound(&hull, 1.001 * least));
    CHECK_STATUS(bat_hull_check_bound(&hull, 4.001), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_hull_check_bound(&hull, 0.999 * least), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_hull_check_bound(&hull, NAN), BATTEN_BAD_ARGUMENT);
    hull.breadth = 0;
    CHECK_STATUS(bat_hull_check_bound(&hull, 1), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("no half-breadth of the table is above 0");
    bat_arena_free(&hull.arena);
    batten_offset_table_unref(table);
}
