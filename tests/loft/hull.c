#include "loft/hull.h"

#include "support/test.h"

enum { STATIONS = 4, POINTS = 4 };

/* y = (1 - (x / 3)^2) z on waterlines z = 0, 1 / 3, 2 / 3 and 1; the sheer rises by `rise` at the
 * bow, the stem rakes by `rake` there. */
static batten_offset_table *make_table(double rise, double rake, double siding)
{
    batten_table_point points[STATIONS][POINTS];
    batten_table_station stations[STATIONS];
    batten_offset_table *table = NULL;
    for (int i = 0; i < STATIONS; i++) {
        for (int j = 0; j < POINTS; j++) {
            const double z = j / 3. + (i == 3 && j == 3 ? rise : 0);
            points[i][j] = (batten_table_point){i + (i == 3 ? rake * z : 0),
                                                siding + (1 - i * i / 9.) * j / 3., z, -1};
        }
        stations[i] = (batten_table_station){"", i, POINTS, points[i]};
    }
    CHECK_OK(batten_offset_table_create(1, 0, NULL, STATIONS, stations, &table));
    return table;
}

static bool is_held(const bat_loft *loft, int i, int j, int c)
{
    return loft->held[3 * (i * loft->patch.nv + j) + c];
}

TEST(what_a_table_knows_exactly_is_held)
{
    batten_offset_table *table = make_table(0, 0, 0);
    bat_loft loft = {0};
    CHECK_OK(bat_hull_make(table, 0.01, &loft));
    CHECK_INT(loft.patch.nu, STATIONS + 2);
    CHECK_INT(loft.patch.nv, 7 + 4);
    const int fore = loft.patch.nu - 1, top = loft.patch.nv - 1;
    for (int i = 0; i <= fore; i++)
        for (int j = 0; j <= top; j++) {
            CHECK(is_held(&loft, i, j, 0));
            CHECK(is_held(&loft, i, j, 1) == (j == 0 || i == fore));
            CHECK(is_held(&loft, i, j, 2) == (j == 0 || j == top));
        }
    /* x runs evenly: its coefficients are the means of three knots. */
    static const double x[] = {0, 1 / 3., 1, 2, 8 / 3., 3};
    for (int i = 0; i <= fore; i++)
        CHECK_NEAR(loft.patch.points[3 * i * loft.patch.nv], x[i], 1e-15);
    CHECK(loft.patch.points[3 * top + 2] == 1);
    CHECK(loft.one_side && loft.breadth == 1 && loft.within == 0.01);
    CHECK_NEAR(loft.height, 2e-6, 1e-20);
    bat_hull_release(&loft);
    batten_offset_table_unref(table);
}

TEST(a_sheer_that_rises_a_raked_stem_and_a_wide_keel_are_held_as_far_as_they_are_known)
{
    batten_offset_table *table = make_table(0.1, 0.5, 0.02);
    bat_loft loft = {0};
    CHECK_OK(bat_hull_make(table, 0.01, &loft));
    const int fore = loft.patch.nu - 1, top = loft.patch.nv - 1;
    for (int i = 0; i <= fore; i++)
        for (int j = 0; j <= top; j++) {
            CHECK(is_held(&loft, i, j, 0) == (i == 0));
            CHECK(is_held(&loft, i, j, 1) == (j == 0));
            CHECK(is_held(&loft, i, j, 2) == (j == 0));
        }
    CHECK(loft.patch.points[1] == 0.02);
    bat_hull_release(&loft);
    batten_offset_table_unref(table);
}

TEST(points_become_data_with_their_places_in_the_table)
{
    batten_offset_table *table = make_table(0.1, 0.5, 0.02);
    bat_loft loft = {0};
    CHECK_OK(bat_hull_make(table, 0.01, &loft));
    CHECK_INT(loft.datum_count, STATIONS * POINTS);
    for (int k = 0; k < loft.datum_count; k++) {
        const bat_loft_datum *d = loft.data + k;
        const int i = k / POINTS, j = k % POINTS;
        const batten_table_point *p = batten_offset_table_station(table, i)->points + j;
        CHECK(d->station == i && d->index == j);
        CHECK(d->point[0] == p->x && d->point[1] == p->y && d->point[2] == p->z);
        CHECK(d->on_u_edge == (i == 0 || i == 3) && d->on_v_edge == (j == 0 || j == 3));
        CHECK(d->in_station && d->within == 0.01);
        CHECK(i > 0 || d->u == 0);
        CHECK(i < 3 || d->u == 1);
    }
    bat_hull_release(&loft);
    batten_offset_table_unref(table);
}
