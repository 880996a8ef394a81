#include "loft/hull.h"

#include "support/test.h"

enum { STATIONS = 5, MOST = 6 };

/* Stations at 0, 1, 3, 4, 5 whose half-breadths are those of a row of `shape`, on the lines
 * z = 0, 0.2 ... 1; `counts`: how many of their points there are. */
typedef struct {
    batten_table_point points[STATIONS][MOST];
    bat_hull_station stations[STATIONS];
    batten_offset_table *table;
    bat_loft loft;
} hull;

static const double xs[STATIONS] = {0, 1, 3, 4, 5};
static const double round_side[MOST] = {0, 0.5, 0.75, 0.9, 0.97, 1},
                    hollow_side[MOST] = {0, 0.05, 0.2, 0.6, 0.9, 1};

static void make_hull(const double *const shape[STATIONS], const int counts[STATIONS],
                      int line_count, hull *h)
{
    batten_table_line lines[MOST];
    batten_table_station given[STATIONS];
    memset(h, 0, sizeof *h);
    for (int j = 0; j < MOST; j++)
        lines[j] = (batten_table_line){"", true, 0.2 * j};
    for (int k = 0; k < STATIONS; k++) {
        for (int j = 0; j < counts[k]; j++)
            h->points[k][j] = (batten_table_point){xs[k], shape[k][j] * (1 - 0.02 * k), 0.2 * j,
                                                   j < line_count ? j : -1};
        given[k] = (batten_table_station){"", xs[k], counts[k], h->points[k]};
        h->stations[k] =
            (bat_hull_station){.x = xs[k], .count = counts[k], .points = h->points[k]};
    }
    CHECK_OK(batten_offset_table_create(1, line_count, lines, STATIONS, given, &h->table));
    h->loft.within = 0.01;
    h->loft.breadth = 1;
}

static void release_cuts(hull *h)
{
    bat_release(h->loft.cuts);
    h->loft.cuts = NULL;
    h->loft.cut_count = 0;
}

static batten_status find_cuts(hull *h)
{
    const bat_hull_table taken = {.table = h->table,
                                  .station_count = STATIONS,
                                  .stations = h->stations,
                                  .most_points = MOST};
    const batten_status status = bat_hull_cuts(&taken, NULL, &h->loft);
    if (status != BATTEN_OK) /* those that there are belong to the lofting */
        release_cuts(h);
    return status;
}

static void release_hull(hull *h)
{
    release_cuts(h);
    batten_offset_table_unref(h->table);
}

/* The cuts of a kind, in their order: where they are, and what they need. */
static int list_cuts(const hull *h, bat_cut_kind kind, double *at, int *needed)
{
    int count = 0;
    for (int k = 0; k < h->loft.cut_count; k++)
        if (h->loft.cuts[k].kind == kind) {
            at[count] = h->loft.cuts[k].at;
            needed[count++] = h->loft.cuts[k].needed;
        }
    return count;
}

TEST(a_hull_is_cut_at_its_stations_and_lines_halfway_and_along_buttocks_and_diagonals)
{
    const double *const shape[STATIONS] = {round_side, round_side, round_side, round_side,
                                           round_side};
    const int counts[STATIONS] = {6, 6, 6, 6, 6};
    static const double halfway[] = {0, 0.5, 1, 2, 3, 3.5, 4, 4.5, 5};
    static hull h;
    double at[40];
    int needed[40];
    make_hull(shape, counts, MOST, &h);
    CHECK_OK(find_cuts(&h));
    CHECK_INT(list_cuts(&h, BAT_CUT_STATION, at, needed), COUNT(halfway));
    for (int k = 0; k < COUNT(halfway); k++) {
        CHECK_NEAR(at[k], halfway[k], 1e-15);
        CHECK_INT(needed[k], 0);
    }
    CHECK_INT(list_cuts(&h, BAT_CUT_WATERLINE, at, needed), 2 * MOST - 1);
    for (int k = 0; k < 2 * MOST - 1; k++)
        CHECK_NEAR(at[k], 0.1 * k, 1e-15);
    CHECK_INT(list_cuts(&h, BAT_CUT_BUTTOCK, at, needed), 12);
    for (int k = 0; k < 12; k++) {
        CHECK_NEAR(at[k], (k + 1) / 13.0, 1e-15);
        CHECK_INT(needed[k], -1);
    }
    /* Diagonals of 30 and 45 degrees, from the keel to where the breadth at the sheer is met. */
    CHECK_INT(list_cuts(&h, BAT_CUT_DIAGONAL, at, needed), 20);
    for (int k = 0; k < 20; k++) {
        const double angle = k < 10 ? 0.5235987755982988 : 0.7853981633974483;
        CHECK_NEAR(at[k], (1 + tan(angle)) * (k % 10 + 1) / 11 * cos(angle), 1e-14);
    }
    CHECK_INT(list_cuts(&h, BAT_CUT_PROFILE, at, needed), 1);
    CHECK_INT(list_cuts(&h, BAT_CUT_SHEER, at, needed), 2);
    for (int k = 0; k < h.loft.cut_count; k++) {
        const double *m = h.loft.cuts[k].m;
        CHECK_NEAR(m[0] * m[0] + m[1] * m[1] + m[2] * m[2], 1, 1e-15);
        CHECK(!h.loft.cuts[k].shaped);
    }
    release_hull(&h);
}

/* Stations 1 and 2 are round, the next has too few points to tell, the last two are hollow below:
 * that one needs what the larger of its neighbours does, and so do those halfway. */
TEST(a_station_of_few_points_needs_what_its_neighbours_do)
{
    const double *const shape[STATIONS] = {round_side, round_side, round_side, hollow_side,
                                           hollow_side};
    static const int counts[STATIONS] = {6, 6, 4, 6, 6},
                     expected[] = {0, 0, 0, 1, 1, 1, 1, 1, 1};
    static hull h;
    double at[40];
    int needed[40];
    make_hull(shape, counts, 0, &h);
    CHECK_OK(find_cuts(&h));
    CHECK_INT(list_cuts(&h, BAT_CUT_STATION, at, needed), COUNT(expected));
    for (int k = 0; k < COUNT(expected); k++)
        CHECK_INT(needed[k], expected[k]);
    /* Without lines nine heights are taken, and those between. */
    CHECK_INT(list_cuts(&h, BAT_CUT_WATERLINE, at, needed), 17);
    for (int k = 0; k < 17; k++)
        CHECK_NEAR(at[k], 0.05 * (k + 2), 1e-15);
    release_hull(&h);
}

/* From the side the profile has one inflection and the sheer none; from above the sheer has one. */
TEST(edges_need_the_inflections_that_their_points_have_from_the_side_and_from_above)
{
    const double *const shape[STATIONS] = {round_side, round_side, round_side, round_side,
                                           round_side};
    static const int counts[STATIONS] = {6, 6, 6, 6, 6};
    static const double keel[STATIONS] = {0.16, 0.15, 0.06, 0.01, 0.0},
                        breadth[STATIONS] = {0.2, 0.25, 0.7, 0.95, 1};
    static hull h;
    double at[40];
    int needed[40];
    make_hull(shape, counts, MOST, &h);
    for (int k = 0; k < STATIONS; k++) {
        h.points[k][0].z = keel[k];
        h.points[k][MOST - 1].y = breadth[k];
    }
    h.loft.within = 0.001;
    CHECK_OK(find_cuts(&h));
    CHECK_INT(list_cuts(&h, BAT_CUT_PROFILE, at, needed), 1);
    CHECK_INT(needed[0], 1);
    CHECK_INT(list_cuts(&h, BAT_CUT_SHEER, at, needed), 2);
    CHECK_INT(needed[0], 0);
    CHECK_INT(needed[1], 1);
    release_hull(&h);
}

TEST(a_stem_is_no_cut)
{
    const double *const shape[STATIONS] = {round_side, round_side, round_side, round_side,
                                           round_side};
    const int counts[STATIONS] = {6, 6, 6, 6, 6};
    static const double halfway[] = {0, 0.5, 1, 2, 3, 3.5, 4};
    static hull h;
    double at[40];
    int needed[40];
    make_hull(shape, counts, MOST, &h);
    h.stations[STATIONS - 1].is_stem = true;
    CHECK_OK(find_cuts(&h));
    CHECK_INT(list_cuts(&h, BAT_CUT_STATION, at, needed), COUNT(halfway));
    for (int k = 0; k < COUNT(halfway); k++)
        CHECK_NEAR(at[k], halfway[k], 1e-15);
    release_hull(&h);
}
