/* The offsets of stations, of lines that are given point by point. */
#include "picture/drawings/lines_plan.h"
#include "picture/scenes.h"

/* Stations at 2 with a section of two lines, at 10 with nothing but edges, and at 5 with nothing. */
typedef struct {
    bat_lines_sheet sheet;
    bat_cut stations[3], planes[8];
    bat_stroke lines[2], edges[3], chine;
    bat_knuckle knuckle;
} plan;

static double section[4][3] = {{2, 0, -1}, {2, 1, -1}, {2, 2, 1}, {2, 1.5, 2}};
static double deck[2][3] = {{2, 1.5, 2}, {2, 0.25, 2.25}};
/* At the end but for rounding, just beyond that, and lengthwise. */
static double transom[2][3] = {{10, 0, 0}, {10 - 9e-6, 0.5, 1.5}};
static double beyond[2][3] = {{10, 0, -3}, {10 - 11e-6, 5, 5}};
static double sheer[2][3] = {{0, 1, 2}, {10, 0.5, 1.5}};
static double chine[2][3] = {{1, 1, 0}, {6, 2, 1}};

/* Planes of one family. */
static void begin_plan(plan *p, bat_family family, int count, const bat_cut *planes)
{
    *p = (plan){.lines = {{4, section[0]}, {2, deck[0]}},
                .edges = {{2, beyond[0]}, {2, transom[0]}, {2, sheer[0]}},
                .chine = {2, chine[0]}};
    p->stations[0] = (bat_cut){.at = 2, .lines = {2, 0, p->lines}};
    p->stations[1] = (bat_cut){.at = 10};
    p->stations[2] = (bat_cut){.at = 5};
    memcpy(p->planes, planes, (size_t)count * sizeof *planes);
    p->knuckle = (bat_knuckle){.lines = {1, 0, &p->chine}};
    p->sheet.hull = (bat_hull){.low = {0, 0, -1},
                               .high = {10, 2, 2.25},
                               .edges = {3, 0, p->edges},
                               .knuckle_count = 1,
                               .knuckles = &p->knuckle};
    p->sheet.hull.families[BAT_STATIONS] = (bat_cuts){.count = 3, .cuts = p->stations};
    if (count > 0)
        p->sheet.hull.families[family] = (bat_cuts){.count = count, .cuts = p->planes};
}

static void check_offset(const plan *p, int station, bat_family family, int line, double due)
{
    const double value = bat_lines_offset(&p->sheet, station, family, line);
    CHECK(isnan(due) == isnan(value));
    if (!isnan(due))
        CHECK_NEAR(value, due, 1e-14);
}

/* Of a station and the transom: the largest half-breadth on a waterline, the least height on a buttock, and the
 * longest way on a diagonal. */
static const struct {
    bat_family family;
    bat_cut plane;
    double offsets[2];
} offsets[] = {
    {BAT_WATERLINES, {.at = -2}, {NAN, NAN}},
    {BAT_WATERLINES, {.at = -1}, {1, NAN}},
    {BAT_WATERLINES, {.at = 0}, {1.5, 0}},
    {BAT_WATERLINES, {.at = 0.75}, {1.875, 0.25}},
    {BAT_WATERLINES, {.at = 1}, {2, 1.0 / 3}},
    {BAT_WATERLINES, {.at = 1.5}, {1.75, 0.5}},
    {BAT_WATERLINES, {.at = 2.25}, {0.25, NAN}},
    {BAT_WATERLINES, {.at = 2.5}, {NAN, NAN}},
    {BAT_BUTTOCKS, {.at = 0}, {-1, 0}},
    {BAT_BUTTOCKS, {.at = 0.25}, {-1, 0.75}},
    {BAT_BUTTOCKS, {.at = 1.75}, {0.5, NAN}},
    {BAT_BUTTOCKS, {.at = 2}, {1, NAN}},
    {BAT_BUTTOCKS, {.at = 2.5}, {NAN, NAN}},
    /* z = 1.5 - y meets the section at y = 3/2 and the transom at y = 3/8; z = -3 - y meets nothing */
    {BAT_DIAGONALS,
     {.at = 1.5, .angle = BAT_PI / 4},
     {1.5 * 1.4142135623730951, 0.375 * 1.4142135623730951}},
    {BAT_DIAGONALS, {.at = -3, .angle = BAT_PI / 4}, {NAN, NAN}},
    /* z = 1 - y / 2 meets them at y = 8/5 and at y = 2/7; 1 / cos of its angle is sqrt(5) / 2 */
    {BAT_DIAGONALS,
     {.at = 1, .angle = 0.4636476090008061},
     {1.6 * 1.118033988749895, 2.0 / 7 * 1.118033988749895}},
};

TEST(offsets_are_read_where_a_station_meets_a_plane)
{
    for (int i = 0; i < COUNT(offsets); i++) {
        plan p;
        begin_plan(&p, offsets[i].family, 1, &offsets[i].plane);
        check_offset(&p, 0, offsets[i].family, 0, offsets[i].offsets[0]);
        check_offset(&p, 1, offsets[i].family, 0, offsets[i].offsets[1]);
        check_offset(&p, 2, offsets[i].family, 0, NAN);
    }
}

TEST(each_line_of_a_family_has_its_own_offset)
{
    static const bat_cut planes[] = {{.at = 0}, {.at = 1}, {.at = 1.5}};
    static const double due[] = {1.5, 2, 1.75};
    plan p;
    begin_plan(&p, BAT_WATERLINES, COUNT(planes), planes);
    for (int i = 0; i < COUNT(planes); i++)
        check_offset(&p, 0, BAT_WATERLINES, i, due[i]);
}

TEST(a_station_ends_at_its_lowest_and_highest_points)
{
    plan p;
    begin_plan(&p, BAT_WATERLINES, 0, &offsets[0].plane);
    const bat_lines_ends first = bat_lines_ends_of(&p.sheet, 0),
                         last = bat_lines_ends_of(&p.sheet, 1),
                         none = bat_lines_ends_of(&p.sheet, 2);
    CHECK_BITS(first.keel, -1);
    CHECK_BITS(first.sheer, 2.25);
    CHECK_BITS(first.breadth, 0.25);
    CHECK_BITS(last.keel, 0);
    CHECK_BITS(last.sheer, 1.5);
    CHECK_BITS(last.breadth, 0.5);
    CHECK(isnan(none.keel) && isnan(none.sheer) && isnan(none.breadth));
}

/* From x = 1 to 6, also a millionth of the length beyond. */
TEST(a_knuckle_has_its_place_at_the_stations_that_it_reaches)
{
    static const struct {
        double x, y, z;
    } rows[] = {{1, 1, 0},
                {2, 1.2, 0.2},
                {6, 2, 1},
                {6 + 9e-6, 2, 1},
                {1 - 9e-6, 1, 0},
                {6 + 11e-6, NAN, NAN},
                {1 - 11e-6, NAN, NAN}};
    for (int i = 0; i < COUNT(rows); i++) {
        plan p;
        double yz[2] = {7, 7};
        begin_plan(&p, BAT_WATERLINES, 0, &offsets[0].plane);
        p.stations[0].at = rows[i].x;
        bat_lines_knuckle_offsets(&p.sheet, 0, 0, yz);
        CHECK(isnan(rows[i].y) == isnan(yz[0]) && isnan(rows[i].z) == isnan(yz[1]));
        if (!isnan(rows[i].y)) {
            CHECK_NEAR(yz[0], rows[i].y, 1e-5);
            CHECK_NEAR(yz[1], rows[i].z, 1e-5);
        }
    }
}
