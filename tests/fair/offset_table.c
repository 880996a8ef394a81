#include "fair/hull.h"

static void check_bound(const batten_offset_table *from, const batten_offset_table *to,
                        double within)
{
    CHECK_INT(batten_offset_table_station_count(to), batten_offset_table_station_count(from));
    for (int s = 0; s < batten_offset_table_station_count(from); s++) {
        const batten_table_station *a = batten_offset_table_station(from, s),
                                   *b = batten_offset_table_station(to, s);
        CHECK_INT(b->point_count, a->point_count);
        for (int i = 0; i < a->point_count; i++) {
            const batten_table_point *p = &a->points[i], *q = &b->points[i];
            const bool waterline =
                p->line >= 0 && batten_offset_table_line(from, p->line)->is_waterline;
            CHECK(q->x == p->x && q->line == p->line);
            CHECK(!waterline || q->z == p->z);
            CHECK(p->y != 0 || q->y == 0);
            CHECK(hypot(q->y - p->y, q->z - p->z) <= within);
        }
    }
}

TEST(noise_on_a_hull_is_taken_out_within_the_bound)
{
    if (test_cases(3) < 3)
        SKIP("the small tables show what failing allocations do");
    for (int families = 1; families <= 3; families++) {
        batten_offset_table *given = NULL, *faired = NULL;
        batten_fair_report report = {0};
        const batten_fair_options options = batten_fair_defaults(0.01);
        CHECK_OK(hull_make(hull_wigley(21, 10, 0.005), &given));
        CHECK_OK(batten_fair_offset_table(given, (batten_fair_families)families, &options, NULL,
                                          &report, &faired));
        check_bound(given, faired, 0.01);
        CHECK(report.max_move <= 0.01 && report.moved_count > 100);
        CHECK(report.after.energy < report.before.energy);
        CHECK(report.after.jumps < report.before.jumps / 20);
        CHECK(report.after.excess_inflections < report.before.excess_inflections / 4);
        CHECK(report.worst_set >= 0 && report.worst_set < 21);
        batten_fair_report_release(&report);
        batten_offset_table_unref(faired);
        batten_offset_table_unref(given);
    }
}

TEST(a_wrong_number_in_a_table_is_suspected_and_softened)
{
    hull *h = hull_wigley(15, 9, 0);
    h->points[7 * 9 + 4].y += 0.1;
    batten_offset_table *given = NULL, *faired = NULL;
    batten_fair_report report = {0};
    const batten_fair_options options = batten_fair_defaults(0.02);
    CHECK_OK(hull_make(h, &given));
    CHECK_OK(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, &report, &faired));
    check_bound(given, faired, 0.02);
    CHECK(batten_offset_table_station(faired, 7)->points[4].y < h->points[7 * 9 + 4].y - 0.019);
    int found = 0;
    for (int k = 0; k < report.suspect_count; k++)
        if (report.suspects[k].set == 7 && report.suspects[k].index == 4) {
            found++;
            CHECK_NEAR(report.suspects[k].to[1], h->points[7 * 9 + 4].y - 0.1, 0.01);
        }
    CHECK(found > 0);
    batten_fair_report_release(&report);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(given);
}

TEST(named_lines_move_in_breadth_and_height_together_within_the_bound)
{
    /* a chine over four stations' points each, wavy in both directions */
    hull *h = test_array(1, sizeof *h);
    test_random random = test_random_begin("chine");
    h->lines[h->line_count++] = (batten_table_line){"chine", false, 0};
    for (int i = 0; i < 15; i++) {
        const double x = i - 7;
        hull_add(h, x, 0, 0, -1);
        hull_add(h, x, 2 - 0.02 * x * x + 0.01 * test_random_in(&random, -1, 1),
                 0.5 + 0.01 * x * x + 0.01 * test_random_in(&random, -1, 1), 0);
        hull_add(h, x, 2.5 - 0.02 * x * x, 2, hull_line(h, 2));
    }
    batten_offset_table *given = NULL, *faired = NULL;
    batten_fair_report report = {0};
    const batten_fair_options options = batten_fair_defaults(0.015);
    CHECK_OK(hull_make(h, &given));
    CHECK_OK(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, &report, &faired));
    check_bound(given, faired, 0.015);
    int heights = 0;
    for (int s = 0; s < 15; s++)
        heights += batten_offset_table_station(faired, s)->points[1].z !=
                   batten_offset_table_station(given, s)->points[1].z;
    CHECK(heights > 8);
    CHECK(report.after.jumps < report.before.jumps / 3);
    CHECK(report.after.excess_inflections < report.before.excess_inflections);
    batten_fair_report_release(&report);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(given);
}

TEST(symmetric_tables_stay_symmetric)
{
    hull *h = hull_wigley(11, 6, 0);
    h->points[3 * 6 + 2].y += 0.01;
    h->points[7 * 6 + 2].y += 0.01;
    batten_offset_table *given = NULL, *faired = NULL;
    const batten_fair_options options = batten_fair_defaults(0.02);
    CHECK_OK(hull_make(h, &given));
    CHECK_OK(batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, NULL, &faired));
    for (int i = 0; i < 11; i++)
        for (int j = 0; j < 6; j++)
            CHECK_NEAR(batten_offset_table_station(faired, i)->points[j].y,
                       batten_offset_table_station(faired, 10 - i)->points[j].y, 1e-4);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(given);
}

TEST(N6_tables_refuse_bounds_and_options_that_mean_nothing)
{
    batten_offset_table *given = NULL, *faired = NULL;
    batten_fair_options options = batten_fair_defaults(0), bad = batten_fair_defaults(1);
    const int corner[1] = {0};
    CHECK_OK(hull_make(hull_wigley(5, 5, 0), &given));
    CHECK_STATUS(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, NULL, &faired),
        BATTEN_BAD_ARGUMENT);
    options = bad;
    CHECK_STATUS(
        batten_fair_offset_table(given, (batten_fair_families)4, &options, NULL, NULL, &faired),
        BATTEN_BAD_ARGUMENT);
    bad.corners = corner;
    bad.corner_count = 1;
    CHECK_STATUS(batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &bad, NULL, NULL, &faired),
                 BATTEN_BAD_ARGUMENT);
    options.corner_angle = 0;
    CHECK_STATUS(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, NULL, &faired),
        BATTEN_BAD_ARGUMENT);
    CHECK(faired == NULL);
    batten_offset_table_unref(given);
}

/* x, z, half-breadth; comments after #; a blank half-breadth is no point. */
static hull *read_hull(const char *path)
{
    hull *h = test_array(1, sizeof *h);
    FILE *file = fopen(path, "r");
    char line[200];
    while (file && fgets(line, sizeof line, file)) {
        double x, z, y;
        if (sscanf(line, "%lf,%lf,%lf", &x, &z, &y) == 3)
            hull_add(h, x, y, z, hull_line(h, z));
    }
    if (file)
        fclose(file);
    return h;
}

TEST(real_tables_become_fairer_within_five_millimetres)
{
    if (test_cases(3) < 3)
        SKIP("the small tables show what failing allocations do");
    static const char *const names[] = {"hull_offsets/s60_offsets.csv",
                                        "hull_offsets/gunnerus_offsets.csv",
                                        "hull_offsets/px121_offsets.csv"};
    for (int k = 0; k < COUNT(names); k++) {
        hull *h = read_hull(test_data(names[k]));
        for (int families = 1; families <= 3; families++) {
            batten_offset_table *given = NULL, *faired = NULL;
            batten_fair_report report = {0};
            const batten_fair_options options = batten_fair_defaults(0.005);
            CHECK_OK(hull_make(h, &given));
            CHECK_OK(batten_fair_offset_table(given, (batten_fair_families)families, &options,
                                              NULL, &report, &faired));
            check_bound(given, faired, 0.005);
            CHECK(report.max_move <= 0.005);
            CHECK(report.after.energy < report.before.energy);
            CHECK(report.after.excess_inflections <= report.before.excess_inflections);
            batten_fair_report_release(&report);
            batten_offset_table_unref(faired);
            batten_offset_table_unref(given);
        }
    }
}
