#include <batten/extend.h>
#include <batten/measure.h>
#include <batten/standard.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "support/test.h"

enum { MOST = 60 };

/* Pieces of an outline, in order: each a line or a bulged quadratic, with a gap before it. */
typedef struct {
    int count;
    batten_curve *pieces[MOST]; /* as they are given: shuffled, some turned */
    double corners[MOST][2];    /* where they meet */
    double gap;                 /* the largest */
} outline;

static batten_curve *make_curve(int count, const double *points)
{
    static const double line[] = {0, 0, 1, 1}, bow[] = {0, 0, 0, 1, 1, 1};
    static const double weights[] = {1, 0.8, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, count, points}, count - 1,
                                 count == 3 ? weights : NULL, count == 3 ? bow : line, &curve));
    return curve;
}

/* From corner to corner, each end moved by half of its gap away from the middle. */
static batten_curve *make_piece(const double from[2], const double to[2], bool is_bowed,
                                bool is_turned)
{
    double points[6];
    const double *first = is_turned ? to : from, *last = is_turned ? from : to;
    memcpy(points, first, 2 * sizeof *points);
    if (!is_bowed) {
        memcpy(points + 2, last, 2 * sizeof *points);
        return make_curve(2, points);
    }
    for (int k = 0; k < 2; k++)
        points[2 + k] = 0.6 * (first[k] + last[k]);
    memcpy(points + 4, last, 2 * sizeof *points);
    return make_curve(3, points);
}

/* Corners around a circle at least 0.1 apart, gaps below 0.01. */
static void make_outline(test_random *random, outline *o)
{
    double ends[MOST][2][2];
    int place[MOST];
    o->count = 2 + (int)(test_random_unit(random) * (MOST - 2));
    o->gap = 0;
    for (int i = 0; i < o->count; i++) {
        const double angle = 6.283185307179586 * i / o->count,
                     turn = 6.3 * test_random_unit(random);
        const double radius = 3 + 0.2 * test_random_unit(random),
                     half = 0.005 * test_random_unit(random);
        o->corners[i][0] = radius * cos(angle);
        o->corners[i][1] = radius * sin(angle);
        for (int k = 0; k < 2; k++) {
            ends[i][k][0] = o->corners[i][0] + (k ? 1 : -1) * half * cos(turn);
            ends[i][k][1] = o->corners[i][1] + (k ? 1 : -1) * half * sin(turn);
        }
        o->gap = fmax(o->gap, 2 * half);
        place[i] = i;
    }
    for (int i = o->count - 1; i > 0; i--) {
        const int k = (int)(test_random_unit(random) * (i + 1)), kept = place[i];
        place[i] = place[k];
        place[k] = kept;
    }
    for (int i = 0; i < o->count; i++)
        o->pieces[place[i]] =
            make_piece(ends[i][1], ends[(i + 1) % o->count][0], test_random_unit(random) < 0.5,
                       test_random_unit(random) < 0.5);
}

static double distance_to_corner(const outline *o, const double p[2])
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < o->count; i++)
        nearest = fmin(nearest, hypot(p[0] - o->corners[i][0], p[1] - o->corners[i][1]));
    return nearest;
}

/* One closed curve; every joint where its corner was; order and direction as reported. */
static void check_outline(const outline *o, const batten_curves_join_report *report,
                          const int *order, const batten_curves *made)
{
    double ends[2][2];
    bool seen[MOST] = {false};
    CHECK_INT(made->count, 1);
    CHECK_INT(report->closed, 1);
    CHECK_INT(report->branches, 0);
    CHECK_NEAR(report->gap, o->gap, 1e-12);
    CHECK(distance_to_corner(o, report->at) < 1e-12);
    const batten_interval domain = batten_curve_domain(made->at[0]);
    CHECK_OK(batten_curve_evaluate(made->at[0], domain.a, 0, ends[0]));
    CHECK_OK(batten_curve_evaluate(made->at[0], domain.b, 0, ends[1]));
    CHECK(memcmp(ends[0], ends[1], sizeof ends[0]) == 0);
    CHECK(distance_to_corner(o, ends[0]) < 1e-12);
    for (int i = 0; i < o->count; i++) {
        const int piece = abs(order[i]) - 1;
        CHECK(!seen[piece]);
        seen[piece] = true;
    }
    CHECK(order[0] == 1);
}

TEST(shuffled_closed_outlines_with_gaps_become_one_closed_curve)
{
    test_random random = test_random_begin("loose outlines");
    for (int trial = test_cases(200); trial > 0; trial--) {
        outline o;
        int order[MOST], pieces[MOST];
        batten_curves_join_report report;
        batten_curves made = {0, NULL};
        make_outline(&random, &o);
        const batten_curve_row row = {o.count, (const batten_curve *const *)o.pieces};
        CHECK_OK(batten_curves_join(&row, 0.0101, order, pieces, &report, &made));
        CHECK_INT(pieces[0], o.count);
        check_outline(&o, &report, order, &made);
        double length = 0, sum = 0;
        for (int i = 0; i < o.count; i++) {
            double one = 0;
            CHECK_OK(batten_curve_length(o.pieces[i], 1e-9, NULL, &one));
            sum += one;
        }
        CHECK_OK(batten_curve_length(made.at[0], 1e-9, NULL, &length));
        CHECK_NEAR(length, sum, 0.01 * o.count);
        batten_curves_release(&made);
        for (int i = 0; i < o.count; i++)
            batten_curve_unref(o.pieces[i]);
    }
}

static const double square[4][4] = {{0, 0, 2, 0}, {2, 2, 2, 0}, {2, 2, 0, 2}, {0, 0, 0, 2}};

TEST(the_order_of_the_curves_decides_nothing_but_where_the_result_begins)
{
    static const int orders[][4] = {{0, 1, 2, 3}, {3, 1, 0, 2}, {2, 3, 1, 0}};
    for (int i = 0; i < COUNT(orders); i++) {
        batten_curve *pieces[4];
        batten_curves made = {0, NULL};
        double at[2], area;
        for (int k = 0; k < 4; k++)
            pieces[k] = make_curve(2, square[orders[i][k]]);
        const batten_curve_row row = {4, (const batten_curve *const *)pieces};
        CHECK_OK(batten_curves_join(&row, 0, NULL, NULL, NULL, &made));
        CHECK_INT(made.count, 1);
        CHECK_INT(batten_curve_point_count(made.at[0]), 5);
        CHECK_OK(batten_curve_evaluate(made.at[0], batten_curve_domain(made.at[0]).a, 0, at));
        CHECK_BITS(at[0], square[orders[i][0]][0]);
        CHECK_BITS(at[1], square[orders[i][0]][1]);
        const double *p = batten_curve_points(made.at[0]);
        area = 0;
        for (int k = 0; k < 4; k++)
            area += p[2 * k] * p[2 * k + 3] - p[2 * k + 2] * p[2 * k + 1];
        CHECK_NEAR(fabs(area), 8, 0);
        batten_curves_release(&made);
        for (int k = 0; k < 4; k++)
            batten_curve_unref(pieces[k]);
    }
}

TEST(the_smallest_gaps_are_closed_and_larger_ones_stay)
{
    /* A spur nearer to the corner than the side that comes first, and one that is too far. */
    static const double lines[][4] = {
        {0, 0, 1, 0}, {1.002, 0, 2, 0}, {1.0005, 0, 1, 5}, {9, 9, 9, 8}};
    batten_curve *pieces[4];
    batten_curves_join_report report;
    batten_curves made = {0, NULL};
    int order[4], counts[4];
    for (int k = 0; k < 4; k++)
        pieces[k] = make_curve(2, lines[k]);
    const batten_curve_row row = {4, (const batten_curve *const *)pieces};
    CHECK_OK(batten_curves_join(&row, 0.01, order, counts, &report, &made));
    CHECK_INT(made.count, 3);
    CHECK_INT(counts[0], 2);
    CHECK_INT(order[0], 1);
    CHECK_INT(order[1], 3);
    CHECK_INT(report.closed, 0);
    CHECK_INT(report.gaps, 1);
    CHECK_INT(report.branches, 3);
    CHECK_NEAR(report.gap, 0.0005, 1e-15);
    CHECK_NEAR(report.at[0], 1.00025, 1e-15);
    batten_curves_release(&made);
    for (int k = 0; k < 4; k++)
        batten_curve_unref(pieces[k]);
}

TEST(what_is_shorter_than_the_tolerance_is_not_closed_upon_itself)
{
    static const double lines[][4] = {{0, 0, 0.3, 0}, {0.3, 0, 0.6, 0}, {5, 0, 5.1, 0}};
    static const double bow[] = {7, 0, 8, 3, 7.05, 0};
    batten_curve *pieces[4];
    batten_curves_join_report report;
    batten_curves made = {0, NULL};
    for (int k = 0; k < 3; k++)
        pieces[k] = make_curve(2, lines[k]);
    pieces[3] = make_curve(3, bow);
    const batten_curve_row row = {4, (const batten_curve *const *)pieces};
    CHECK_OK(batten_curves_join(&row, 1, NULL, NULL, &report, &made));
    CHECK_INT(made.count, 3);
    CHECK_INT(report.closed, 1);
    const double *p = batten_curve_points(made.at[2]);
    CHECK_NEAR(p[0], 7.025, 1e-15);
    CHECK_NEAR(p[4], 7.025, 1e-15);
    CHECK_NEAR(p[2], 8, 0);
    batten_curves_release(&made);
    for (int k = 0; k < 4; k++)
        batten_curve_unref(pieces[k]);
}

static double join_many(int count)
{
    batten_curve **pieces = test_array((size_t)count, sizeof(batten_curve *));
    batten_curves made = {0, NULL};
    for (int i = 0; i < count; i++) {
        const int k = (int)((long long)i * 7919 % count);
        const double points[4] = {k, k % 2, k + 1, (k + 1) % 2};
        pieces[i] = make_curve(2, points);
    }
    const batten_curve_row row = {count, (const batten_curve *const *)pieces};
    const clock_t start = clock();
    CHECK_OK(batten_curves_join(&row, 1e-3, NULL, NULL, NULL, &made));
    const double time = (double)(clock() - start) / CLOCKS_PER_SEC;
    CHECK_INT(made.count, 1);
    CHECK_INT(batten_curve_point_count(made.at[0]), count + 1);
    batten_curves_release(&made);
    for (int i = 0; i < count; i++)
        batten_curve_unref(pieces[i]);
    return time;
}

TEST(ten_times_the_curves_cost_far_less_than_a_hundred_times)
{
    const double few = join_many(1000), many = join_many(10000);
    CHECK(many < 40 * few + 0.05);
}

TEST(bad_tolerances_and_mixed_dimensions_are_refused)
{
    static const double space[] = {0, 0, 0, 1, 0, 0}, knots[] = {0, 0, 1, 1};
    batten_curve *pieces[2] = {make_curve(2, square[0]), NULL};
    batten_curves made = {0, NULL};
    CHECK_OK(batten_curve_create((batten_points){3, 2, space}, 1, NULL, knots, &pieces[1]));
    const batten_curve_row row = {2, (const batten_curve *const *)pieces};
    CHECK_STATUS(batten_curves_join(&row, -1, NULL, NULL, NULL, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is -1");
    CHECK_STATUS(batten_curves_join(&row, 1, NULL, NULL, NULL, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("curves 1 and 2 have 2 and 3 dimensions");
    CHECK_STATUS(batten_curves_join(&(batten_curve_row){0, NULL}, 1, NULL, NULL, NULL, &made),
                 BATTEN_TOO_FEW_POINTS);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(pieces[k]);
}
