#include "picture/sheet/cover.h"

#include "support/test.h"

static const double sheet[4] = {0, 0, 200, 100};

/* The distance of a segment from a box, by its points. */
static double distance(const double a[2], const double b[2], const double box[4])
{
    double least = HUGE_VAL;
    for (int i = 0; i <= 2000; i++) {
        const double t = i / 2000.0, x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
        const double off_x = fmax(0, fmax(box[0] - x, x - box[2]));
        const double off_y = fmax(0, fmax(box[1] - y, y - box[3]));
        least = fmin(least, hypot(off_x, off_y));
    }
    return least;
}

TEST(a_box_is_free_where_no_segment_is_near)
{
    test_random random = test_random_begin("cover");
    for (int i = 0; i < test_cases(300); i++) {
        bat_cover cover;
        CHECK_OK(bat_cover_make(200, 100, 2, &cover));
        double a[2], b[2], box[4];
        for (int k = 0; k < 2; k++) {
            a[k] = test_random_in(&random, -50, 250), b[k] = test_random_in(&random, -50, 250);
            box[k] = test_random_in(&random, 5, 70),
            box[k + 2] = box[k] + test_random_in(&random, 1, 25);
        }
        bat_cover_segment(&cover, a, b, 0.5, sheet);
        const double far = distance(a, b, box);
        if (far < 0.5)
            CHECK(!bat_cover_is_free(&cover, box));
        if (far > 0.5 + 2.6 * 1.5)
            CHECK(bat_cover_is_free(&cover, box));
        bat_cover_free(&cover);
    }
}

TEST(what_is_not_finite_or_far_away_covers_nothing)
{
    bat_cover cover;
    CHECK_OK(bat_cover_make(200, 100, 2, &cover));
    const double far[2] = {1e300, 1e300}, farther[2] = {2e300, 1e300}, lost[2] = {NAN, 0};
    bat_cover_segment(&cover, far, farther, 1, sheet);
    bat_cover_segment(&cover, far, lost, 1, sheet);
    CHECK(bat_cover_is_free(&cover, sheet));
    bat_cover_free(&cover);
}

TEST(a_sheet_has_cells_of_the_size_asked_and_at_most_2000_a_side)
{
    static const struct {
        double width, height, cell, side;
        int columns, rows;
    } rows[] = {{100, 45, 10, 10, 11, 5},
                {99, 50, 10, 10, 10, 6},
                {100000, 10, 1, 50, 2001, 1},
                {10, 100000, 1, 50, 1, 2001}};
    for (int i = 0; i < COUNT(rows); i++) {
        bat_cover cover;
        CHECK_OK(bat_cover_make(rows[i].width, rows[i].height, rows[i].cell, &cover));
        CHECK_NEAR(cover.cell, rows[i].side, 0);
        CHECK_INT(cover.columns, rows[i].columns);
        CHECK_INT(cover.rows, rows[i].rows);
        bat_cover_free(&cover);
    }
}

/* A segment, half its width, the box it is clipped to, and the cells of 10 that it meets: columns and rows. */
static const struct {
    double a[2], b[2], half, box[4];
    int columns[2], rows[2];
} marked[] = {
    {{12, 25}, {38, 25}, 2, {0, 0, 200, 100}, {1, 4}, {2, 2}},
    {{38, 25}, {12, 25}, 2, {0, 0, 200, 100}, {1, 4}, {2, 2}},
    {{12, 25}, {38, 25}, 6, {0, 0, 200, 100}, {0, 4}, {1, 3}},
    {{45, 12}, {45, 67}, 1, {0, 0, 200, 100}, {4, 4}, {1, 6}},
    {{45, 67}, {45, 12}, 1, {0, 0, 200, 100}, {4, 4}, {1, 6}},
    {{35, 35}, {35, 35}, 1, {0, 0, 200, 100}, {3, 3}, {3, 3}},
    /* Clipped at each side. */
    {{-500, 55}, {500, 55}, 1, {21.5, 0, 68, 100}, {2, 6}, {5, 5}},
    {{500, 55}, {-500, 55}, 1, {21.5, 0, 68, 100}, {2, 6}, {5, 5}},
    {{55, -500}, {55, 500}, 1, {0, 21.5, 200, 68}, {5, 5}, {2, 6}},
    {{55, 500}, {55, -500}, 1, {0, 21.5, 200, 68}, {5, 5}, {2, 6}},
    {{5, 55}, {9, 55}, 1, {21.5, 0, 68, 100}, {1, 0}, {1, 0}},
    {{30, 5}, {60, 5}, 1, {21.5, 20, 68, 100}, {1, 0}, {1, 0}},
    /* What lies beyond the sheet is with its last cells. */
    {{195, 95}, {195, 95}, 30, {0, 0, 200, 100}, {16, 20}, {6, 10}},
};

TEST(a_segment_covers_the_cells_that_it_meets_within_its_box)
{
    for (int i = 0; i < COUNT(marked); i++) {
        bat_cover cover;
        CHECK_OK(bat_cover_make(200, 100, 10, &cover));
        bat_cover_segment(&cover, marked[i].a, marked[i].b, marked[i].half, marked[i].box);
        for (int row = 0; row < cover.rows; row++)
            for (int column = 0; column < cover.columns; column++)
                CHECK_INT(cover.cells[row * cover.columns + column],
                          row >= marked[i].rows[0] && row <= marked[i].rows[1] &&
                              column >= marked[i].columns[0] && column <= marked[i].columns[1]);
        bat_cover_free(&cover);
    }
}

/* A quarter of a cell of 10 is kept away from a covered one, from 30 to 40. */
TEST(a_box_is_free_a_quarter_of_a_cell_away_from_what_is_covered)
{
    static const struct {
        double box[4];
        bool free;
    } boxes[] = {
        {{5, 32, 27.4, 38}, true},   {{5, 32, 27.6, 38}, false},  {{42.6, 32, 60, 38}, true},
        {{42.4, 32, 60, 38}, false}, {{32, 5, 38, 27.4}, true},   {{32, 5, 38, 27.6}, false},
        {{32, 42.6, 38, 60}, true},  {{32, 42.4, 38, 60}, false}, {{0, 0, 200, 100}, false},
    };
    bat_cover cover;
    CHECK_OK(bat_cover_make(200, 100, 10, &cover));
    bat_cover_segment(&cover, (double[]){35, 35}, (double[]){35, 35}, 1, sheet);
    for (int i = 0; i < COUNT(boxes); i++)
        CHECK_INT(bat_cover_is_free(&cover, boxes[i].box), boxes[i].free);
    bat_cover_free(&cover);
}
