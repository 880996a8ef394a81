/* What intervals say of equations in a cell. */
#include "systems.h"

TEST(values_and_slopes_over_a_cell_enclose_those_of_each_equation)
{
    test_system s;
    bat_enclosure e;
    const bat_cell cell = {{{1, 2}, {3, 3}, {-1, 0}}};
    begin_test_system(&s, "x*y + z", "x - 2*z^2 + 4*y");
    bat_system_over(&s.system, &cell, &e);
    CHECK(!e.undefined);
    const bat_interval value[] = {{2, 6}, {11, 14}};
    const bat_interval slope[2][3] = {{{3, 3}, {1, 2}, {1, 1}}, {{1, 1}, {4, 4}, {0, 4}}};
    for (int i = 0; i < 2; i++) {
        CHECK_NEAR(e.value[i].lo, value[i].lo, 1e-14);
        CHECK_NEAR(e.value[i].hi, value[i].hi, 1e-14);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(e.slope[i][k].lo, slope[i][k].lo, 1e-14);
            CHECK_NEAR(e.slope[i][k].hi, slope[i][k].hi, 1e-14);
        }
    }
    end_test_system(&s);
}

TEST(a_cell_without_a_value_of_one_equation_is_free_and_one_with_a_pole_has_every_slope)
{
    test_system s;
    bat_enclosure e;
    const bat_cell cell = {{{-2, -1}, {-1, 1}, {-1, 1}}};
    for (int i = 0; i < 2; i++) {
        begin_test_system(&s, i ? "x - y" : "ln(x)", i ? "ln(x)" : "x - y");
        bat_system_over(&s.system, &cell, &e);
        CHECK(e.undefined && bat_cell_is_free(&s.system, &cell, &e));
        end_test_system(&s);
    }
    begin_test_system(&s, "1/y - x", NULL);
    bat_system_over(&s.system, &cell, &e);
    CHECK(!e.undefined && !bat_cell_is_free(&s.system, &cell, &e));
    CHECK(e.slope[0][1].lo == -INFINITY && e.slope[0][1].hi == INFINITY);
    end_test_system(&s);
}

TEST(the_longest_side_is_the_first_of_equal_ones_and_the_diagonal_counts_all)
{
    static const struct {
        bat_cell cell;
        int longest[2];     /* in the plane, in space */
        double diagonal[2]; /* the same */
    } rows[] = {
        {{{{0, 1}, {1, 3}, {-1, 1}}}, {1, 1}, {2.23606797749979, 3}},
        {{{{0, 4}, {1, 4}, {-6, 6}}}, {0, 2}, {5, 13}},
        {{{{0, 2}, {1, 3}, {-1, 0}}}, {0, 0}, {2.8284271247461903, 3}},
    };
    test_system s;
    for (int i = 0; i < COUNT(rows); i++)
        for (int space = 0; space < 2; space++) {
            const int longest = rows[i].longest[space];
            begin_test_system(&s, "x + y", space ? "x + z" : NULL);
            CHECK_INT(bat_cell_longest(&s.system, &rows[i].cell), longest);
            CHECK(bat_cell_extent(&s.system, &rows[i].cell) ==
                  bat_interval_width(rows[i].cell.at[longest]));
            CHECK_NEAR(bat_cell_diagonal(&s.system, &rows[i].cell), rows[i].diagonal[space],
                       1e-14);
            end_test_system(&s);
        }
}

TEST(cells_are_free_by_a_value_or_by_the_mean_value_of_any_equation)
{
    static const struct {
        const char *first, *second;
        bool free;
    } rows[] = {
        {"x + y + 3", NULL, true},
        {"x + y + 2", NULL, false},
        {"x - x + 0.5", NULL, true}, /* its values lie in [-1.5, 2.5], its slopes vanish */
        {"x - x + y - y - 0.5", NULL, true},
        {"x - x", NULL, false},
        {"x*(y+3) - x*y - 3*x + 0.4", NULL, false}, /* the slopes cancel in part */
        {"x", "y + z + 3", true},
        {"x + 3", "y + z", true},
        {"x", "z - z + y - y + 0.5", true},
        {"x - x - 0.5", "z", true},
        {"x", "y - z", false},
    };
    test_system s;
    bat_enclosure e;
    const bat_cell cell = {{{-1, 1}, {-1, 1}, {-1, 1}}};
    for (int i = 0; i < COUNT(rows); i++) {
        begin_test_system(&s, rows[i].first, rows[i].second);
        bat_system_over(&s.system, &cell, &e);
        CHECK_INT(bat_cell_is_free(&s.system, &cell, &e), rows[i].free);
        end_test_system(&s);
    }
}

/* Cells where the derivatives are known: the inverse of their middle, and how far the product of both
 * may be from the identity. */
static const struct {
    const char *first, *second;
    bat_cell cell;
    int axis;
    bool is_graph;
    double inverse[2][2], strength, departure;
} graphs[] = {
    {"x^2 + y^2 - 1", NULL, {{{1, 3}, {-1, 1}}}, 1, true, {{0.25}}, 4, 0.5},
    {"x^2 + y^2 - 1", NULL, {{{1, 3}, {-1, 1}}}, 0, false, {{0}}, 0, 0},
    {"x^2/2 + y",
     NULL,
     {{{0.125, 2}, {-1, 1}}},
     1,
     true,
     {{1 / 1.0625}},
     1.0625,
     0.9375 / 1.0625},
    {"x^2/2 + y", NULL, {{{-0.125, 2}, {-1, 1}}}, 1, false, {{0}}, 0, 0},
    {"x^2/2 + y", NULL, {{{-2, 2}, {-1, 1}}}, 0, true, {{1}}, 1, 0},
    {"2*x + y + z",
     "x - y + 3*z",
     {{{0, 1}, {0, 1}, {0, 1}}},
     2,
     true,
     {{1.0 / 3, 1.0 / 3}, {1.0 / 3, -2.0 / 3}},
     3,
     0},
    {"2*x + y + z",
     "x - y + 3*z",
     {{{0, 1}, {0, 1}, {0, 1}}},
     0,
     true,
     {{0.75, -0.25}, {0.25, 0.25}},
     4,
     0},
    {"2*x + y + z",
     "x - y + 3*z",
     {{{0, 1}, {0, 1}, {0, 1}}},
     1,
     true,
     {{0.6, -0.2}, {-0.2, 0.4}},
     5,
     0},
    {"x^2/2 + z", "y + z", {{{0.5, 1.5}, {0, 1}, {0, 1}}}, 2, true, {{1, 0}, {0, 1}}, 1, 0.5},
    {"x + z", "y^2/2", {{{0, 1}, {0.5, 1.5}, {0, 1}}}, 2, true, {{1, 0}, {0, 1}}, 1, 0.5},
    {"x^2/2", "y + z", {{{0.25, 1.75}, {0, 1}, {0, 1}}}, 2, false, {{0}}, 0, 0},
    {"x^2/2 + y^2/2 + z",
     "y",
     {{{0.75, 1.25}, {-0.25, 0.25}, {0, 1}}},
     2,
     true,
     {{1, 0}, {0, 1}},
     1,
     0.5},
    {"x^2/2 + y^2/2 + z", "y", {{{0.6, 1.4}, {-0.4, 0.4}, {0, 1}}}, 2, false, {{0}}, 0, 0},
    {"x + y", "2*x + 2*y + z", {{{0, 1}, {0, 1}, {0, 1}}}, 2, false, {{0}}, 0, 0},
};

TEST(a_curve_is_a_graph_where_the_derivatives_across_the_axis_are_nearly_constant)
{
    for (int i = 0; i < COUNT(graphs); i++) {
        test_system s;
        bat_enclosure e;
        bat_regularity r = {.departure = -1};
        const int n = graphs[i].second ? 2 : 1;
        begin_test_system(&s, graphs[i].first, graphs[i].second);
        bat_system_over(&s.system, &graphs[i].cell, &e);
        CHECK_INT(bat_is_graph(&s.system, &e, graphs[i].axis, &r), graphs[i].is_graph);
        for (int k = 0; k < n * n && graphs[i].is_graph; k++)
            CHECK_NEAR(r.inverse[k / n][k % n], graphs[i].inverse[k / n][k % n], 1e-14);
        if (graphs[i].is_graph) {
            CHECK_NEAR(r.strength, graphs[i].strength, 1e-13);
            CHECK_NEAR(r.departure, graphs[i].departure, 1e-13);
        }
        end_test_system(&s);
    }
}

static const struct {
    const char *first, *second;
    bat_cell cell;
    int axis;
    double at;
    bat_crossing_count count;
    double point[3];
} crossings[] = {
    {"x^2 + y^2 - 1", NULL, {{{0.5, 2}, {0, 1}}}, 1, 0.6, BAT_ONE_CROSSING, {0.8, 0.6}},
    {"x^2 + y^2 - 1", NULL, {{{0, 1}, {-2, -0.5}}}, 0, 0.6, BAT_ONE_CROSSING, {0.6, -0.8}},
    {"x^2 + y^2 - 1", NULL, {{{0, 1}, {0, 1}}}, 0, 1.25, BAT_NO_CROSSING, {0}},
    {"x^2 + y^2 - 1", NULL, {{{0.1, 0.7}, {0, 1}}}, 1, 0.6, BAT_NO_CROSSING, {0}},
    {"x^2 + y^2 - 1", NULL, {{{-2, 2}, {0, 1}}}, 1, 0.6, BAT_CROSSINGS_UNKNOWN, {0}},
    {"exp(x) - y", NULL, {{{-3, 3}, {0, 9}}}, 1, 1, BAT_ONE_CROSSING, {0, 1}},
    {"2*x + y + z - 4",
     "x - y + 3*z - 3",
     {{{0, 3}, {0, 3}, {0, 3}}},
     2,
     1,
     BAT_ONE_CROSSING,
     {1, 1, 1}},
    {"x^2 + y^2 - 1",
     "z - x*y",
     {{{0.7, 0.9}, {0.5, 0.7}, {0, 1}}},
     1,
     0.6,
     BAT_ONE_CROSSING,
     {0.8, 0.6, 0.48}},
    {"x^2 + y^2 - 1",
     "z - x*y",
     {{{0.5, 0.7}, {0.5, 1}, {0, 1}}},
     0,
     0.6,
     BAT_ONE_CROSSING,
     {0.6, 0.8, 0.48}},
    {"x^2 + y^2 - 1",
     "z - x*y",
     {{{0.7, 0.9}, {0.5, 0.7}, {0.5, 1}}},
     1,
     0.6,
     BAT_NO_CROSSING,
     {0}},
    {"x^2 + y^2 - 1",
     "z - x",
     {{{-2, 2}, {-2, 2}, {-2, 2}}},
     1,
     0.6,
     BAT_CROSSINGS_UNKNOWN,
     {0}},
};

TEST(crossings_of_a_plane_are_one_none_or_not_known_and_one_is_where_mathematics_has_it)
{
    for (int i = 0; i < COUNT(crossings); i++) {
        test_system s;
        double point[3] = {0, 0, 0}, radius = -1, off = 0;
        begin_test_system(&s, crossings[i].first, crossings[i].second);
        CHECK_INT(bat_find_crossing(&s.system, &crossings[i].cell, crossings[i].axis,
                                    crossings[i].at, point, &radius),
                  crossings[i].count);
        for (int k = 0; k < s.system.dimension; k++)
            off = hypot(off, point[k] - crossings[i].point[k]);
        if (crossings[i].count == BAT_ONE_CROSSING)
            CHECK(off <= radius + DBL_EPSILON && radius < 1e-14);
        end_test_system(&s);
    }
}

TEST(the_radius_of_a_crossing_that_is_not_known_is_half_the_diagonal_across)
{
    test_system s;
    double point[3], radius;
    begin_test_system(&s, "x^2 - y^2 - z^2/4", "y^2 - x^2 + z^2/4");
    const bat_cell cell = {{{-3, 3}, {-4, 4}, {1, 5}}};
    CHECK_INT(bat_find_crossing(&s.system, &cell, 2, 2, point, &radius), BAT_CROSSINGS_UNKNOWN);
    CHECK_NEAR(radius, 5, 1e-14);
    CHECK(point[0] == 0 && point[1] == 0 && point[2] == 2);
    end_test_system(&s);
}

/* Cells, axes, and the ends of what is left: hulls of the curve there, by 3 hundredths at most too large. */
static const struct {
    const char *first, *second;
    bat_cell cell;
    int axis;
    bool is_left;
    bat_interval left[3];
} tightened[] = {
    {"x^2 + y^2 - 1",
     NULL,
     {{{0.5, 1.5}, {0, 0.25}}},
     1,
     true,
     {{0.9682458365518543, 1}, {0, 0.25}}},
    {"x^2 + y^2 - 1",
     NULL,
     {{{0, 0.25}, {-1.5, -0.5}}},
     0,
     true,
     {{0, 0.25}, {-1, -0.9682458365518543}}},
    {"x^2 + y^2 - 1", NULL, {{{1.01, 1.5}, {-0.1, 0.1}}}, 1, false, {{0, 0}}},
    {"x^2 + y^2 - 1", NULL, {{{-1.5, 1.5}, {0, 0.1}}}, 1, true, {{-1.5, 1.5}, {0, 0.1}}},
    {"x - z/2",
     "y + 1 - z",
     {{{-9, 9}, {-9, 9}, {0, 1}}},
     2,
     true,
     {{0, 0.5}, {-1, 0}, {0, 1}}},
    {"x - z/2", "y + 1 - z", {{{0, 1}, {-9, 9}, {-9, 9}}}, 0, true, {{0, 1}, {-1, 1}, {0, 2}}},
    {"x - z/2", "y + 1 - z", {{{2, 9}, {-9, 9}, {0, 1}}}, 2, false, {{0, 0}}},
    {"x - z/2", "y + 1 - z", {{{-9, 9}, {2, 9}, {0, 1}}}, 2, false, {{0, 0}}},
    {"x + y", "x + y + z", {{{2, 9}, {-9, 9}, {0, 1}}}, 2, true, {{2, 9}, {-9, 9}, {0, 1}}},
};

TEST(what_is_left_of_a_cell_is_about_the_extent_of_the_curve)
{
    for (int i = 0; i < COUNT(tightened); i++) {
        test_system s;
        bat_cell cell = tightened[i].cell;
        begin_test_system(&s, tightened[i].first, tightened[i].second);
        CHECK_INT(bat_cell_tighten(&s.system, tightened[i].axis, &cell), tightened[i].is_left);
        for (int k = 0; k < s.system.dimension && tightened[i].is_left; k++) {
            const bat_interval was = tightened[i].left[k];
            const double spare = 0.03;
            CHECK(cell.at[k].lo <= was.lo + DBL_EPSILON && cell.at[k].lo >= was.lo - spare);
            CHECK(cell.at[k].hi >= was.hi - DBL_EPSILON && cell.at[k].hi <= was.hi + spare);
        }
        end_test_system(&s);
    }
}

TEST(the_tangent_is_the_cross_product_of_the_gradients_with_length_1)
{
    static const struct {
        const char *first, *second;
        double at[3], tangent[3];
    } rows[] = {
        {"x^2 + y^2 - 1", NULL, {0.6, 0.8}, {-0.8, 0.6}},
        {"1 - x^2 - y^2", NULL, {0.6, 0.8}, {0.8, -0.6}},
        {"x*y", NULL, {0, 0}, {0, 0}},
        {"x + 2*y + 2*z", "2*x + y - 2*z", {1, 2, 3}, {-2.0 / 3, 2.0 / 3, -1.0 / 3}},
        {"2*x + y - 2*z", "x + 2*y + 2*z", {1, 2, 3}, {2.0 / 3, -2.0 / 3, 1.0 / 3}},
        {"x^2 + y^2 - 1", "z - y^2/2", {0.8, 0.6}, {0.6, -0.8, -0.48}},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        test_system s;
        double out[3] = {7, 7, 7};
        const double *t = rows[i].tangent;
        const double length = t[0] || t[1] ? sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]) : 1;
        begin_test_system(&s, rows[i].first, rows[i].second);
        bat_curve_tangent(&s.system, rows[i].at, out);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(out[k], t[k] / length, 1e-15);
        end_test_system(&s);
    }
}
