/* Edges chained to polylines. */
#include "picture/lines/stroke.h"

#include "picture/scenes.h"

/* Vertex i stands at (i, 10 i, -i). */
static bat_strokes chain(int vertices, size_t count, const int (*ends)[2])
{
    bat_strokes lines = {0};
    double *points = test_array(3 * (size_t)vertices, sizeof *points);
    for (int i = 0; i < vertices; i++) {
        points[3 * i] = i;
        points[3 * i + 1] = 10 * i;
        points[3 * i + 2] = -i;
    }
    batten_status status;
    do { /* with a failing allocation once more, from the start */
        bat_strokes_free(&lines);
        status = bat_chain_edges(vertices, points, count, ends, &lines);
    } while (test_memory_failed(status, BATTEN_OK));
    CHECK(status == BATTEN_OK);
    return lines;
}

static void check_line(const bat_stroke *line, int count, const int *vertices)
{
    CHECK_INT(line->count, count);
    for (int i = 0; i < count; i++) {
        CHECK_NEAR(line->points[3 * i], vertices[i], 0);
        CHECK_NEAR(line->points[3 * i + 1], 10 * vertices[i], 0);
        CHECK_NEAR(line->points[3 * i + 2], -vertices[i], 0);
    }
}

TEST(edges_in_any_order_and_direction_become_one_line_from_end_to_end)
{
    static const int ends[][2] = {{3, 1}, {0, 4}, {4, 3}};
    bat_strokes lines = chain(5, 3, ends);
    CHECK_INT(lines.count, 1);
    check_line(&lines.strokes[0], 4, (int[]){0, 4, 3, 1});
    bat_strokes_free(&lines);
}

TEST(lines_end_where_other_than_two_edges_meet)
{
    /* A fork at 2, with a loop from 5 back to it. */
    static const int ends[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {2, 5}, {5, 6}, {6, 2}};
    bat_strokes lines = chain(7, 7, ends);
    CHECK_INT(lines.count, 3);
    check_line(&lines.strokes[0], 3, (int[]){0, 1, 2});
    check_line(&lines.strokes[1], 3, (int[]){2, 3, 4});
    check_line(&lines.strokes[2], 4, (int[]){2, 5, 6, 2});
    bat_strokes_free(&lines);
}

TEST(rings_come_last_and_close)
{
    static const int ends[][2] = {{1, 2}, {2, 0}, {0, 1}, {3, 5}};
    bat_strokes lines = chain(6, 4, ends);
    CHECK_INT(lines.count, 2);
    check_line(&lines.strokes[0], 2, (int[]){3, 5});
    check_line(&lines.strokes[1], 4, (int[]){1, 2, 0, 1});
    bat_strokes_free(&lines);
}

TEST(without_edges_there_is_no_line)
{
    bat_strokes lines = chain(3, 0, NULL);
    CHECK_INT(lines.count, 0);
    bat_strokes_free(&lines);
}
