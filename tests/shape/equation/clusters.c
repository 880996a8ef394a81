/* Cells that touch are gathered, and a cluster has its singular point. */
#include "shape/equation/clusters.h"

#include "systems.h"

/* Three clusters: a chain (0, 3, 5), two that touch in a corner (1, 4), and one alone (2). */
static const bat_cell cells_of[] = {
    {{{0, 1}, {0, 1}}},      {{{10, 11}, {0, 1}}}, {{{0, 1}, {1.5, 3}}},
    {{{2, 3}, {0.5, 1.25}}}, {{{11, 12}, {1, 2}}}, {{{1, 2}, {-1, 0.5}}},
};

TEST(cells_that_touch_make_one_cluster_in_the_order_of_their_first_cells)
{
    static const int of[] = {0, 1, 2, 0, 1, 0};
    static const bat_cell boxes[] = {
        {{{0, 3}, {-1, 1.25}}}, {{{10, 12}, {0, 2}}}, {{{0, 1}, {1.5, 3}}}};
    static const double extents[] = {3.75, 2.8284271247461903, 1.8027756377319946};
    for (int turned = 0; turned < 2; turned++) {
        test_system s;
        bat_clusters found;
        bat_cell cells[COUNT(cells_of)];
        begin_test_system(&s, "x + y", NULL);
        for (int i = 0; i < COUNT(cells); i++)
            for (int k = 0; k < 2; k++)
                cells[i].at[k] = cells_of[i].at[turned ? 1 - k : k];
        const bat_cells all = {.system = &s.system, .undecided = {cells, COUNT(cells), 0}};
        CHECK_OK(bat_clusters_gather(&all, &found));
        CHECK_INT(found.count, 3);
        for (int i = 0; i < COUNT(cells); i++)
            CHECK_INT(found.of[i], of[i]);
        for (int i = 0; i < found.count; i++) {
            for (int k = 0; k < 2; k++) {
                CHECK(found.items[i].box.at[k].lo == boxes[i].at[turned ? 1 - k : k].lo);
                CHECK(found.items[i].box.at[k].hi == boxes[i].at[turned ? 1 - k : k].hi);
            }
            CHECK_NEAR(found.items[i].extent, extents[i], 1e-15);
        }
        bat_clusters_release(&found);
        CHECK(!found.items && !found.of && found.count == 0);
        end_test_system(&s);
    }
}

TEST(cells_apart_along_the_third_axis_alone_are_two_clusters)
{
    test_system s;
    bat_clusters found;
    bat_cell cells[] = {
        {{{0, 9}, {0, 1}, {0, 1}}}, {{{0, 9}, {0, 1}, {1.125, 2}}}, {{{0, 9}, {0, 1}, {2, 3}}}};
    begin_test_system(&s, "x + y", "z");
    const bat_cells all = {.system = &s.system, .undecided = {cells, 3, 3}};
    CHECK_OK(bat_clusters_gather(&all, &found));
    CHECK_INT(found.count, 2);
    CHECK(found.of[0] == 0 && found.of[1] == 1 && found.of[2] == 1);
    CHECK(found.items[1].box.at[2].lo == 1.125 && found.items[1].box.at[2].hi == 3);
    bat_clusters_release(&found);
    const bat_cells none = {.system = &s.system};
    CHECK_OK(bat_clusters_gather(&none, &found));
    CHECK(found.count == 0 && !found.items && !found.of);
    end_test_system(&s);
}

/* The gradient of the third one vanishes outside of the cluster; that of the fourth has no such place. */
static const struct {
    const char *first, *second;
    bat_cell box;
    double point[3];
} points[] = {
    {"(x - 0.3)*(y - 0.2)", NULL, {{{0.2, 0.375}, {0.125, 0.25}}}, {0.3, 0.2}},
    {"x^3 + 2*y^2 - 3*x*y + x/4",
     NULL,
     {{{0.5, 0.75}, {0.25, 0.5}}},
     {0.6143567769390845, 0.4607675827043134}},
    {"(x - 9)*(y - 9)", NULL, {{{0, 1}, {2, 4}}}, {0.5, 3}},
    {"x + y", NULL, {{{0, 1}, {2, 4}}}, {0.5, 3}},
    {"x*y", NULL, {{{-1, 2}, {-3, 4}}}, {0, 0}},
    {"x*y", "z - x", {{{0, 1}, {2, 4}, {-1, -1}}}, {0.5, 3, -1}},
};

TEST(the_point_of_a_cluster_is_where_the_gradient_vanishes_or_its_middle)
{
    for (int i = 0; i < COUNT(points); i++) {
        test_system s;
        double out[3] = {0, 0, 0};
        begin_test_system(&s, points[i].first, points[i].second);
        const bat_cluster cluster = {points[i].box,
                                     bat_cell_diagonal(&s.system, &points[i].box)};
        bat_cluster_point(&s.system, &cluster, out);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(out[k], points[i].point[k], 1e-12);
        end_test_system(&s);
    }
}
