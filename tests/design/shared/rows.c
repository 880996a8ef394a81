#include "design/shared/rows.h"

#include "support/test.h"

#include <batten/standard.h>
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
