#include "loft/faired.h"

#include "support/test.h"

enum { STATIONS = 2, POINTS = 4, LINES = 3, COUNT_OF = 5 };

/* S = (4 u, v^2 + u / 2, v): a station at x has y = z^2 + x / 8. */
static batten_status make_bowl(bat_loft_patch *patch)
{
    static const double inner[] = {0.5};
    double knots[COUNT_OF + BAT_LOFT_SUPPORT];
    bat_loft_knots(1, inner, knots);
    const batten_status status = bat_loft_patch_make(COUNT_OF, knots, COUNT_OF, knots, patch);
    for (int i = 0; status == BATTEN_OK && i < COUNT_OF; i++)
        for (int j = 0; j < COUNT_OF; j++) {
            const double *a = knots + i + 1, *b = knots + j + 1;
            double *p = patch->points + 3 * (i * COUNT_OF + j);
            p[0] = 4 * (a[0] + a[1] + a[2]) / 3;
            p[1] = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / 3 + p[0] / 8;
            p[2] = (b[0] + b[1] + b[2]) / 3;
        }
    return status;
}

static const double xs[STATIONS] = {1, 3}, zs[POINTS] = {0, 0.25, 0.5, 1};

/* On each station the keel, a waterline at 0.25, a point on no line, the sheer; 0.01 too wide. */
static batten_status make_table(batten_offset_table **out)
{
    static const batten_table_line lines[LINES] = {
        {"keel", false, 0}, {"low", true, 0.25}, {"sheer", false, 0}};
    static const int line_of[POINTS] = {0, 1, -1, 2};
    static const char *const names[STATIONS] = {"A", "B"};
    batten_table_point points[STATIONS][POINTS];
    batten_table_station stations[STATIONS];
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < POINTS; j++)
            points[i][j] = (batten_table_point){xs[i], zs[j] * zs[j] + xs[i] / 8 + 0.01, zs[j],
                                                line_of[j]};
        stations[i] = (batten_table_station){names[i], xs[i], POINTS, points[i]};
    }
    return batten_offset_table_create(0.3048, LINES, lines, STATIONS, stations, out);
}

/* Data of all points but for the sheer of the second station, with their feet. */
static int make_data(bat_loft_datum *data)
{
    int count = 0;
    for (int i = 0; i < STATIONS; i++)
        for (int j = 0; j < POINTS; j++)
            if (i == 0 || j < 3)
                data[count++] =
                    (bat_loft_datum){.point = {xs[i], zs[j] * zs[j] + xs[i] / 8 + 0.01, zs[j]},
                                     .on_v_edge = j == 0 || j == 3,
                                     .u = xs[i] / 4,
                                     .v = zs[j],
                                     .station = i,
                                     .index = j};
    return count;
}

TEST(points_of_the_panels_are_read_off_and_all_else_is_as_it_was)
{
    bat_loft_datum data[STATIONS * POINTS];
    bat_loft panel = {.data = data, .datum_count = make_data(data)};
    const bat_hull_panels panels = {.count = 1, .at = &panel};
    batten_offset_table *table = NULL, *faired = NULL;
    double error = 7;
    CHECK_OK(make_bowl(&panel.patch));
    CHECK_OK(make_table(&table));
    CHECK_OK(bat_loft_faired_table(&panels, table, &faired, &error));
    CHECK(error >= 0 && error <= 1e-14);
    CHECK(batten_offset_table_unit_metres(faired) == 0.3048);
    CHECK_INT(batten_offset_table_line_count(faired), LINES);
    CHECK_INT(batten_offset_table_station_count(faired), STATIONS);
    for (int k = 0; k < LINES; k++) {
        const batten_table_line *is = batten_offset_table_line(faired, k),
                                *was = batten_offset_table_line(table, k);
        CHECK_TEXT(is->name, was->name);
        CHECK(is->is_waterline == was->is_waterline && is->z == was->z);
    }
    for (int i = 0; i < STATIONS; i++) {
        const batten_table_station *is = batten_offset_table_station(faired, i),
                                   *was = batten_offset_table_station(table, i);
        CHECK_TEXT(is->name, was->name);
        CHECK(is->x == xs[i]);
        CHECK_INT(is->point_count, POINTS);
        for (int j = 0; j < POINTS; j++) {
            const batten_table_point *p = is->points + j;
            const double given = was->points[j].y;
            CHECK_INT(p->line, was->points[j].line);
            CHECK(p->x == xs[i]);
            CHECK_NEAR(p->y, i == 1 && j == 3 ? given : given - 0.01, 1e-14);
            CHECK_NEAR(p->z, zs[j], j == 1 ? 0 : 1e-14);
        }
    }
    batten_offset_table_unref(faired);
    batten_offset_table_unref(table);
    bat_loft_patch_free(&panel.patch);
}

TEST(a_waterline_that_its_edge_leaves_is_a_line_from_now_on)
{
    bat_loft_datum data[STATIONS * POINTS];
    bat_loft panel = {.data = data, .datum_count = make_data(data)};
    const bat_hull_panels panels = {.count = 1, .at = &panel};
    batten_offset_table *table = NULL, *faired = NULL;
    double error;
    CHECK_OK(make_bowl(&panel.patch));
    CHECK_OK(make_table(&table));
    data[5].on_v_edge =
        true; /* the waterline at 0.25 of the second station: the edge is at 0 */
    data[5].v = 0;
    CHECK_OK(bat_loft_faired_table(&panels, table, &faired, &error));
    const batten_table_point *p = batten_offset_table_station(faired, 1)->points + 1;
    CHECK(!batten_offset_table_line(faired, 1)->is_waterline);
    CHECK(batten_offset_table_line(table, 1)->is_waterline);
    CHECK_NEAR(p->x, 3, 1e-14);
    CHECK_NEAR(p->y, 3 / 8., 1e-14);
    CHECK_NEAR(p->z, 0, 1e-14);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(table);
    bat_loft_patch_free(&panel.patch);
}
