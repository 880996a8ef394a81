/* Where control points prove that a surface cannot fold, it does not; elsewhere it is looked at. */
#include "inspect/fold_cones.h"
#include "support/test.h"

#include <batten/measure.h>
#include <limits.h>

enum { SIDE = 12 };

/* Over a grid of SIDE x SIDE control points one apart, wavy; `back`: one point in the middle of its neighbour's other side. */
static batten_surface *wavy(int p, int q, double height, double back)
{
    double points[SIDE][SIDE][3], knots[2][SIDE + 6];
    const int degree[2] = {p, q};
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            points[i][j][0] = i;
            points[i][j][1] = j;
            points[i][j][2] = height * ((i + 2 * j) % 3);
        }
    points[8][3][0] -= back;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < SIDE + degree[k] + 1; i++)
            knots[k][i] = i <= degree[k] ? 0 : i >= SIDE ? SIDE - degree[k] : i - degree[k];
    const batten_axis u = {p, SIDE, knots[0], false}, v = {q, SIDE, knots[1], false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points[0][0], NULL, &surface));
    return surface;
}

/* The smallest range around all that are open. */
static bat_span_range open_range(const batten_surface *surface)
{
    bat_span_ranges open;
    bat_span_range range = {{INT_MAX, INT_MAX}, {0, 0}};
    CHECK_OK(bat_folds_possible(surface, &open));
    for (int i = 0; i < open.count; i++)
        for (int k = 0; k < 2; k++) {
            range.first[k] = bat_min_int(range.first[k], open.at[i].first[k]);
            range.end[k] = bat_max_int(range.end[k], open.at[i].end[k]);
        }
    bat_release(open.at);
    return range;
}

static void check_range(const batten_surface *surface, const bat_span_range *wanted)
{
    const bat_span_range range = open_range(surface);
    if (wanted->first[0] == wanted->end[0]) {
        CHECK(range.first[0] >= range.end[0]);
        return;
    }
    for (int k = 0; k < 2; k++) {
        CHECK_INT(range.first[k], wanted->first[k]);
        CHECK_INT(range.end[k], wanted->end[k]);
    }
}

TEST(a_net_whose_lines_keep_their_directions_folds_nowhere)
{
    static const bat_span_range none = {{0, 0}, {0, 0}};
    static const struct {
        int p, q;
        double height;
    } rows[] = {{1, 1, 0}, {3, 2, 0}, {2, 3, 0.4}, {5, 1, 0.4}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface *surface = wavy(rows[i].p, rows[i].q, rows[i].height, 0);
        check_range(surface, &none);
        batten_surface_unref(surface);
    }
}

TEST(one_point_moved_back_leaves_open_the_spans_where_it_meets_its_neighbour)
{
    /* Points 7 and 8 have exchanged their order: of a span s the points s .. s + p count. */
    static const struct {
        int p, q;
        bat_span_range open;
    } rows[] = {{1, 1, {{7, 2}, {8, 4}}}, {3, 2, {{5, 1}, {8, 4}}}, {2, 3, {{6, 0}, {8, 4}}}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface *surface = wavy(rows[i].p, rows[i].q, 0, 1.5);
        check_range(surface, &rows[i].open);
        batten_surface_unref(surface);
    }
}

/* A part of a dome up to its pole, where points repeat. */
static batten_surface *dome(const double *weights)
{
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    static const double points[3][3][3] = {{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                                           {{0.5, -0.2, 0.8}, {0.6, 0, 0.8}, {0.5, 0.2, 0.8}},
                                           {{0.9, -0.4, 0}, {1, 0, 0}, {0.9, 0.4, 0}}};
    const batten_axis axis = {2, 3, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points[0][0], weights, &surface));
    return surface;
}

TEST(a_pole_does_not_open_its_spans_and_weights_do_not_that_are_products)
{
    static const bat_span_range none = {{0, 0}, {0, 0}}, all = {{0, 0}, {1, 1}};
    static const double products[9] = {1, 0.3, 1, 7, 2.1, 7, 0.5, 0.15, 0.5},
                        others[9] = {1, 1, 1, 1, 2, 1, 1, 1, 1};
    const struct {
        const double *weights;
        const bat_span_range *open;
    } rows[] = {{NULL, &none}, {products, &none}, {others, &all}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface *surface = dome(rows[i].weights);
        check_range(surface, rows[i].open);
        batten_surface_unref(surface);
    }
}

TEST(places_far_from_each_other_are_open_each_by_itself)
{
    enum { LINES = 40 };
    double points[LINES][LINES][2], knots[LINES + 2];
    for (int i = 0; i < LINES; i++)
        for (int j = 0; j < LINES; j++) {
            points[i][j][0] = i;
            points[i][j][1] = j;
        }
    points[2][3][0] += 1.5;
    points[30][36][0] += 1.5;
    for (int i = 0; i < LINES + 2; i++)
        knots[i] = bat_max_int(0, bat_min_int(LINES - 1, i - 1));
    const batten_axis axis = {1, LINES, knots, false};
    batten_surface *surface = NULL;
    bat_span_ranges open;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points[0][0], NULL, &surface));
    CHECK_OK(bat_folds_possible(surface, &open));
    int spans = 0;
    for (int i = 0; i < open.count; i++)
        spans += (open.at[i].end[0] - open.at[i].first[0]) *
                 (open.at[i].end[1] - open.at[i].first[1]);
    /* Of each point the four spans around it at most. */
    CHECK(open.count >= 2);
    CHECK(spans <= 8);
    batten_surface_fold fold;
    CHECK_OK(batten_surface_find_fold(surface, &fold));
    CHECK(fold.found);
    CHECK(fold.point.x < 5 && fold.point.y < 5);
    bat_release(open.at);
    batten_surface_unref(surface);
}

/* Is there a place of a fine grid where the normal looks down? */
static bool looks_down(const batten_surface *surface)
{
    enum { PLACES = 60 };
    for (int i = 0; i <= PLACES; i++)
        for (int j = 0; j <= PLACES; j++) {
            double d[9];
            const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                                  v = batten_surface_domain(surface, BATTEN_V);
            CHECK_OK(batten_surface_evaluate(surface, u.a + (u.b - u.a) * i / PLACES,
                                             v.a + (v.b - v.a) * j / PLACES, 1, d));
            if (d[2] * d[5] - d[3] * d[4] < 0)
                return true;
        }
    return false;
}

TEST(of_random_nets_none_that_is_proved_ever_turns_over)
{
    static const double knots[] = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    const batten_axis axis = {3, 5, knots, false};
    int proved = 0, turned = 0;
    test_random random = test_random_begin("fold cones");
    for (int trial = 0; trial < 240; trial++) {
        double points[5][5][2], weights[5][5], row[5];
        const double noise = 0.2 + 0.01 * (trial % 120);
        for (int j = 0; j < 5; j++)
            row[j] = test_random_in(&random, 0.2, 5);
        for (int i = 0; i < 5; i++)
            for (int j = 0; j < 5; j++) {
                points[i][j][0] = i + noise * test_random_in(&random, -0.5, 0.5);
                points[i][j][1] = j + noise * test_random_in(&random, -0.5, 0.5);
                weights[i][j] = row[i] * row[4 - j];
            }
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_create(2, &axis, &axis, points[0][0],
                                       trial < 120 ? NULL : weights[0], &surface));
        const bat_span_range range = open_range(surface);
        const bool none = range.first[0] >= range.end[0], down = looks_down(surface);
        CHECK(!(none && down));
        proved += none;
        turned += down;
        batten_surface_unref(surface);
    }
    CHECK(proved > 20);
    CHECK(turned > 0);
}
