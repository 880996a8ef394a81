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
    static const int corner[1] = {0};
    batten_fair_options none = batten_fair_defaults(0), cornered = batten_fair_defaults(1);
    batten_fair_options flat = batten_fair_defaults(1), nan = batten_fair_defaults(1);
    const batten_fair_options good = batten_fair_defaults(1);
    cornered.corners = corner;
    cornered.corner_count = 1;
    flat.corner_angle = 0;
    nan.corner_angle = NAN;
    batten_fair_options rates = batten_fair_defaults(1);
    rates.method = BATTEN_FAIR_CIRCLE_RATE;
    const struct {
        int families;
        const batten_fair_options *options;
        const char *message;
    } rows[] = {
        {3, &none, "0"},
        {0, &good, "there is no family 0 of lines"},
        {4, &good, "there is no family 4 of lines"},
        {3, &cornered, "1 corner is given, but those of a table are found"},
        {3, &flat, "the angle of a corner is 0, not above 0"},
        {3, &nan, "the angle of a corner is nan, not above 0"},
        {3, &rates, "tables of offsets are made fair by springback alone"},
    };
    batten_offset_table *given = NULL, *faired = NULL;
    CHECK_OK(hull_make(hull_wigley(5, 5, 0), &given));
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(batten_fair_offset_table(given, (batten_fair_families)rows[i].families,
                                              rows[i].options, NULL, NULL, &faired),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(faired == NULL);
    batten_offset_table_unref(given);
}

/* Flat sides y = 1 + x / 5 + z / 2 but for one station's offset, 0.004 too wide. */
static hull *flat_hull(void)
{
    hull *h = test_array(1, sizeof *h);
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 5; j++)
            hull_add(h, i, 2 + i / 5. + j / 2. + (i == 3 && j == 2 ? 0.004 : 0), j,
                     hull_line(h, j));
    return h;
}

static double worst_second_difference(const batten_offset_table *table)
{
    double worst = 0;
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 5; j++) {
            const batten_table_point *p = batten_offset_table_station(table, i)->points + j;
            if (j > 0 && j < 4)
                worst = fmax(worst, fabs(p[-1].y - 2 * p->y + p[1].y));
            if (i > 0 && i < 6)
                worst =
                    fmax(worst, fabs(batten_offset_table_station(table, i - 1)->points[j].y -
                                     2 * p->y +
                                     batten_offset_table_station(table, i + 1)->points[j].y));
        }
    return worst;
}

/* Straight battens have no energy, and the bound leaves room for them. A fifth of the bend may stay, as rounds
 * end when points move by less than a thousandth of their bound. */
TEST(a_table_that_can_be_made_flat_is_nearly_made_so_and_its_moves_are_reported)
{
    batten_offset_table *given = NULL, *faired = NULL;
    batten_fair_report report = {0};
    const batten_fair_options options = batten_fair_defaults(0.01);
    CHECK_OK(hull_make(flat_hull(), &given));
    CHECK_OK(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, NULL, &report, &faired));
    CHECK_NEAR(worst_second_difference(given), 0.008, 1e-12);
    CHECK(worst_second_difference(faired) < 0.0016);
    CHECK(report.after.energy < 0.04 * report.before.energy);
    int moved = 0;
    double most = 0, squares = 0;
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 5; j++) {
            const double by = fabs(batten_offset_table_station(faired, i)->points[j].y -
                                   batten_offset_table_station(given, i)->points[j].y);
            moved += by > 0;
            most = fmax(most, by);
            squares += by * by;
        }
    CHECK_INT(report.moved_count, moved);
    CHECK_INT(report.move_count, moved);
    CHECK_NEAR(report.max_move, most, 1e-15);
    CHECK_NEAR(report.rms_move, sqrt(squares / 35), 1e-12);
    CHECK_INT(report.worst_set, 3);
    CHECK_INT(report.worst_index, 2);
    for (int k = 0; k < report.move_count; k++) {
        const batten_fair_move *m = &report.moves[k];
        const batten_table_point *p =
            batten_offset_table_station(faired, m->set)->points + m->index;
        CHECK_NEAR(m->from[0], m->set, 0);
        CHECK_NEAR(m->to[0], m->set, 0);
        CHECK_NEAR(m->to[1], p->y, 0);
        CHECK_NEAR(m->to[2], p->z, 0);
    }
    batten_fair_report_release(&report);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(given);
}

TEST(unit_names_and_lines_of_a_table_stay)
{
    hull *h = flat_hull();
    batten_offset_table *given = NULL, *faired = NULL;
    const batten_fair_options options = batten_fair_defaults(0.01);
    h->stations[2].name = "two";
    CHECK_OK(batten_offset_table_create(0.3048, h->line_count, h->lines, h->station_count,
                                        h->stations, &given));
    CHECK_OK(
        batten_fair_offset_table(given, BATTEN_FAIR_STATIONS, &options, NULL, NULL, &faired));
    CHECK_NEAR(batten_offset_table_unit_metres(faired), 0.3048, 0);
    CHECK_INT(batten_offset_table_line_count(faired), 5);
    CHECK_TEXT(batten_offset_table_line(faired, 4)->name, "z=4");
    CHECK_NEAR(batten_offset_table_line(faired, 4)->z, 4, 0);
    CHECK_TEXT(batten_offset_table_station(faired, 2)->name, "two");
    CHECK_NEAR(batten_offset_table_station(faired, 2)->x, 2, 0);
    batten_offset_table_unref(faired);
    batten_offset_table_unref(given);
}

static bool stop(void *user)
{
    return ++*(int *)user >= 3;
}

static void note_progress(void *user, double fraction, const char *what)
{
    CHECK(fraction >= 0 && fraction <= 1);
    CHECK_TEXT(what, "fairing the table");
    (void)user;
}

TEST(fairing_a_table_can_be_stopped_and_limited)
{
    batten_offset_table *given = NULL, *faired = NULL;
    const batten_fair_options options = batten_fair_defaults(0.01);
    int asked = 0;
    batten_job job = BATTEN_JOB;
    job.is_cancelled = stop;
    job.progress = note_progress;
    job.user = &asked;
    CHECK_OK(hull_make(flat_hull(), &given));
    CHECK_STATUS(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, &job, NULL, &faired),
        BATTEN_CANCELLED);
    CHECK_INT(asked, 3);
    job = BATTEN_JOB;
    job.work_limit = 30;
    CHECK_STATUS(
        batten_fair_offset_table(given, BATTEN_FAIR_BOTH, &options, &job, NULL, &faired),
        BATTEN_INCOMPLETE);
    CHECK(!faired);
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
