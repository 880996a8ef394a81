#include "design/outputs/checked.h"

/* Sections of a cylinder over the cubic y = 1 + 3 t (1 - t) (1 - 2 t), z = 3 t, which has one inflection, from x = 0
 * to 6, where a table has its rows. */
static batten_surface *wave(void)
{
    static const double y[] = {1, 2, 0, 1}, along[] = {0, 0, 1, 1},
                        up[] = {0, 0, 0, 0, 1, 1, 1, 1};
    double points[2 * 4 * 3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++) {
            double *p = points + 3 * (4 * i + k);
            p[0] = 6 * i, p[1] = y[k], p[2] = k;
        }
    CHECK_OK(batten_surface_create(3, &(batten_axis){1, 2, along, false},
                                   &(batten_axis){3, 4, up, false}, points, NULL, &surface));
    return surface;
}

/* Evenly spaced in height, on the cubic or straight; `lines` of those that have one, or -1. */
typedef struct {
    const char *name;
    double x;
    int count;
    bool waves;
    int lines[6];
} station;

enum { STATIONS = 9, NONE = -1 };

static const station stations[STATIONS] = {
    {"wavy", 0, 6, true, {NONE, 1, 0, NONE, NONE, NONE}},
    {"few before", 1, 3, false, {NONE, NONE, NONE}},
    {"straight", 2, 6, false, {NONE, NONE, 0, 1, NONE, NONE}},
    {"two", 2.5, 2, false, {NONE, NONE}},
    {"few", 3, 3, false, {NONE, NONE, NONE}},
    {"straight too", 4, 6, false, {NONE, NONE, 0, NONE, 1, NONE}},
    {"few after", 5, 3, false, {NONE, NONE, NONE}},
    {"five", 6, 5, true, {NONE, NONE, NONE, NONE, NONE}},
    {"away", 9, 6, true, {NONE, NONE, NONE, NONE, NONE, NONE}}};

static void make_offsets(batten_offset_table **out)
{
    static const batten_table_line lines[] = {{"WL", true, 1.2}, {"curve in space", false, 0}};
    batten_table_point points[STATIONS][6];
    batten_table_station made[STATIONS];
    for (int i = 0; i < STATIONS; i++) {
        const station *s = &stations[i];
        for (int k = 0; k < s->count; k++) {
            const double t = (double)k / (s->count - 1);
            const double z = s->count == 6 ? 0.6 * k : 3 * t;
            points[i][k] = (batten_table_point){
                s->x, 1 + (s->waves ? 3 * t * (1 - t) * (1 - 2 * t) : t / 8), z, s->lines[k]};
        }
        made[i] = (batten_table_station){s->name, s->x, s->count, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, COUNT(lines), lines, STATIONS, made, out));
}

/* A station of fewer than five points requires what the nearest of five or more on either side requires. */
static const bat_section sections[] = {
    {"station", "wavy", 0, true, {.fair = false}, 1, 6, 1, 0},
    {"station", "few before", 1, true, {.fair = false}, 1, 3, 1, 0},
    {"station", "straight", 2, true, {.fair = false}, 1, 6, 0, 1},
    {"station", "few", 3, true, {.fair = false}, 1, 3, 0, 1},
    {"station", "straight too", 4, true, {.fair = false}, 1, 6, 0, 1},
    {"station", "few after", 5, true, {.fair = false}, 1, 3, 1, 0},
    {"station", "five", 6, true, {.fair = false}, 1, 5, 1, 0},
    {"station", "away", 9, false, {.fair = false}, 0, 0, 0, 0},
    {"waterline", "WL", 1.2, true, {.fair = false}, 0, 3, 0, 0}};

static void check_section(const bat_section *found, const bat_section *wanted)
{
    CHECK_TEXT(found->family, wanted->family);
    CHECK_TEXT(found->name, wanted->name);
    CHECK_NEAR(found->at, wanted->at, 1e-15);
    CHECK(found->found == wanted->found);
    CHECK_INT(found->visible, wanted->visible);
    CHECK_INT(found->point_count, wanted->point_count);
    CHECK_INT(found->required, wanted->required);
    CHECK_INT(found->excess, wanted->excess);
}

/* Of y over z. */
static double largest_curvature(void)
{
    double most = 0;
    for (int i = 0; i <= 10000; i++) {
        const double t = i / 10000.0;
        const double slope = 1 - 6 * t + 6 * t * t, rate = -2 + 4 * t;
        most = fmax(most, fabs(rate) / pow(1 + slope * slope, 1.5));
    }
    return most;
}

TEST(sections_of_a_hull_are_judged_by_their_row_or_where_it_is_short_by_the_nearest_long_ones)
{
    checked_design d;
    batten_offset_table *table = NULL;
    checked_open("  table: {points: [[0, 0, 0]]}\n  hull: {skin: table}\n", "hull", &d);
    make_offsets(&table);
    checked_put(&d, "table",
                &(batten_object){.kind = BATTEN_OBJECT_OFFSET_TABLE, .offset_table = table});
    batten_offset_table_unref(table);
    checked_put_surface(&d, "hull", wave());
    const bat_checked *found = checked_run(&d, HUGE_VAL);
    CHECK(found->is_hull);
    CHECK_INT(found->section_count, COUNT(sections));
    for (int i = 0; i < COUNT(sections); i++)
        check_section(&found->sections[i], &sections[i]);
    CHECK_INT(d.check.judged_count, 8);
    CHECK_INT(d.check.unfairness.inflections, 3);
    CHECK_NEAR(found->sections[0].fairness.max_curvature, largest_curvature(), 2e-3);
    checked_close(&d);
}

static const bat_section of_rows[] = {
    {"x section", "", 2, true, {.fair = false}, 1, 4, 0, 1},
    {"z section", "", 1.2, true, {.fair = false}, 0, 3, 0, 0},
    {"y section", "", 1.125, true, {.fair = false}, 0, 3, 0, 0}};

TEST(sections_of_other_surfaces_are_named_by_the_coordinate_that_stays)
{
    static const double across[] = {2, 1, 0, 2, 1.5, 1, 2, 2, 2, 2, 2.5, 3},
                        level[] = {0, 1, 1.2, 1, 1, 1.2, 6, 2, 1.2},
                        lengthwise[] = {0, 1.125, 0.3, 3, 1.125, 1.2, 6, 1.125, 0},
                        in_space[] = {0, 0, 0, 1, 1, 1, 2, 2, 3};
    const struct {
        int count;
        const double *points;
    } rows[] = {{4, across}, {2, across}, {3, level}, {3, lengthwise}, {3, in_space}};
    checked_design d;
    checked_open("  rows: {points: [[0, 0, 0]]}\n  shape: {skin: rows}\n", "shape", &d);
    for (int i = 0; i < COUNT(rows); i++)
        checked_put(&d, "rows",
                    &(batten_object){.kind = BATTEN_OBJECT_POINTS,
                                     .point_count = rows[i].count,
                                     .points = rows[i].points});
    checked_put_surface(&d, "shape", wave());
    const bat_checked *found = checked_run(&d, HUGE_VAL);
    CHECK(!found->is_hull);
    CHECK_INT(found->section_count, COUNT(of_rows));
    for (int i = 0; i < COUNT(of_rows); i++)
        check_section(&found->sections[i], &of_rows[i]);
    CHECK_INT(found->edge_count, 0);
    checked_close(&d);
}

TEST(a_surface_without_points_has_no_sections)
{
    checked_design d;
    checked_open("  shape: {points: [[0, 0, 0]]}\n", "shape", &d);
    checked_put_surface(&d, "shape", wave());
    CHECK_INT(checked_run(&d, HUGE_VAL)->section_count, 0);
    CHECK_INT(d.check.judged_count, 0);
    checked_close(&d);
}
