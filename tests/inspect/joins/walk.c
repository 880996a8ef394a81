/* Walks along an edge with measures that are known at every place: which places are visited, what is followed and found. */
#include "inspect/joins/walk.h"
#include "support/test.h"

enum { MEASURES = 6, MOST_CALLS = 200 };

/* Measure k is height[k] - steep[k] (t - top[k])^2; it is not known where t < known_from. */
typedef struct {
    double height[MEASURES], steep[MEASURES], top[MEASURES], known_from;
    int fails_at; /* the call that fails, from 1 */
    struct calls {
        int count, span[MOST_CALLS];
        double t[MOST_CALLS];
    } * calls;
} hills;

static batten_status meet_hills(const void *context, int span, double t, bat_meeting *out)
{
    const hills *h = context;
    double m[MEASURES];
    for (int k = 0; k < MEASURES; k++)
        m[k] = t < h->known_from
                   ? NAN
                   : h->height[k] - h->steep[k] * (t - h->top[k]) * (t - h->top[k]);
    h->calls->span[h->calls->count] = span;
    h->calls->t[h->calls->count] = t;
    *out = (bat_meeting){m[0], m[1], m[2], m[3], m[4], m[5], {t, 2 * t, 3 * t}};
    return ++h->calls->count == h->fails_at ? BATTEN_CANCELLED : BATTEN_OK;
}

static const batten_curve_continuity_options bounds = {
    .size = sizeof bounds, .gap = 0.5, .angle = 0.25, .curvature = 0.125, .derivative = 1};
static const double unit[2] = {0, 1};

static batten_status walk_hills(hills *h, struct calls *calls, int spans, const double *breaks,
                                batten_join *join)
{
    calls->count = 0;
    h->calls = calls;
    const bat_edge_walk walk = {meet_hills, h, spans, breaks};
    return bat_follow_edge(&walk, &bounds, join);
}

TEST(nine_places_of_each_span_of_an_edge_and_thirty_two_steps_at_least_are_visited_in_order)
{
    static const double breaks[] = {-1, 0, 0.5, 2, 3, 5, 6, 7};
    static const int steps[] = {32, 16, 10, 8, 8, 8, 8};
    for (int spans = 1; spans <= 7; spans++) {
        hills level = {.known_from = -HUGE_VAL};
        struct calls calls;
        batten_join join;
        CHECK_OK(walk_hills(&level, &calls, spans, breaks, &join));
        const int n = steps[spans - 1];
        CHECK_INT(calls.count, spans * (n + 1));
        for (int i = 0; i < calls.count; i++) {
            const int k = i / (n + 1), j = i % (n + 1);
            CHECK_INT(calls.span[i], k);
            CHECK_NEAR(calls.t[i], breaks[k] + (breaks[k + 1] - breaks[k]) * j / n, 1e-15);
        }
        CHECK_INT(join.geometric, 3);
        CHECK_NEAR(join.gap.at.x, -1, 0);
    }
}

/* A parabola is found at its top at once; the four steps that are left close in on it. */
TEST(each_measure_is_followed_to_its_top_between_the_places)
{
    for (int which = 0; which < MEASURES; which++)
        for (int side = 0; side < 2; side++) {
            const double top = (side ? 9.4 : 20.7) / 32;
            const int judge = which < 4 ? which : which - 2;
            hills h = {.known_from = 0};
            struct calls calls;
            batten_join join;
            h.height[which] = h.height[judge] = 0.1;
            h.steep[which] = 2;
            h.top[which] = top;
            CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
            CHECK_INT(calls.count, 33 + 8);
            const double found[MEASURES] = {
                join.gap.value,  join.angle.value,          join.curvature.value,
                join.rate.value, join.curvature_difference, join.rate_difference};
            for (int k = 0; k < MEASURES; k++)
                CHECK_NEAR(found[k], k == which || k == judge ? 0.1 : 0, 1e-15);
            const batten_join_worst worst[4] = {join.gap, join.angle, join.curvature,
                                                join.rate};
            if (which < 4) {
                CHECK_NEAR(worst[which].at.x, top, 1e-8);
                CHECK_NEAR(worst[which].at.y, 2 * top, 2e-8);
                CHECK_NEAR(worst[which].at.z, 3 * top, 3e-8);
            }
            for (int i = 33; i < 36; i++)
                CHECK_NEAR(calls.t[i], ((side ? 9 : 21) + i - 34) / 32., 1e-15);
            CHECK_NEAR(calls.t[36], top, 1e-12);
            for (int i = 37; i < calls.count; i++)
                CHECK(fabs(calls.t[i] - top) > 0 && fabs(calls.t[i] - top) < 1. / 32);
        }
}

/* Steps of the parabola on a hill of the fourth order are worse; five of them still gain. */
static batten_status meet_ridge(const void *context, int span, double t, bat_meeting *out)
{
    const double x = t - 0.37, *skew = context;
    (void)span;
    *out = (bat_meeting){0, 0.2 * cos(9 * x) - *skew * x * x * x, 0, 0, 0, 0, {t, 0, 0}};
    return BATTEN_OK;
}

TEST(the_top_of_a_skew_hill_is_found_to_nine_digits)
{
    for (int i = 0; i < 5; i++) {
        const double skew = 0.5 * (i - 2), breaks[2] = {0.09, 0.71};
        const bat_edge_walk walk = {meet_ridge, &skew, 1, breaks};
        batten_join join;
        CHECK_OK(bat_follow_edge(&walk, &bounds, &join));
        CHECK_NEAR(join.angle.value, 0.2, 1e-12);
        CHECK_NEAR(join.angle.at.x, 0.37, 2e-6);
        CHECK_INT(join.geometric, 3);
    }
}

TEST(what_is_below_a_thousandth_of_its_bound_is_not_followed)
{
    const double bound[MEASURES] = {0.5, 0.25, 0.125, 0.125, 0.125, 0.125};
    for (int which = 0; which < MEASURES; which++)
        for (int more = 0; more < 2; more++) {
            const int judge = which < 4 ? which : which - 2;
            hills h = {.known_from = 0};
            struct calls calls;
            batten_join join;
            h.height[judge] = (more ? 1.01e-3 : 0.99e-3) * bound[which];
            h.top[judge] = 0.5;
            CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
            CHECK_INT(calls.count, 33); /* level: greatest at the start, which has one side */
            h.steep[judge] = h.height[judge];
            h.steep[which] = h.height[judge];
            h.top[which] = 0.5;
            CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
            CHECK_INT(calls.count, 33 + (more ? which >= 4 ? 16 : 8 : 0));
        }
}

TEST(a_walk_ends_at_the_first_gap_beyond_the_bound)
{
    hills h = {.height = {0.6, 0.2, 0.1}, .steep = {100, 1, 1}, .top = {0.25, 0.5, 0.5}};
    struct calls calls;
    batten_join join;
    CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
    CHECK_INT(join.geometric, -1);
    CHECK_INT(calls.count, 8); /* 7 / 32 is near enough */
    CHECK_NEAR(join.gap.value, 0.6 - 100. / 1024, 1e-15);
    h.height[0] = 0.5 + 1e-4;
    h.top[0] = 8.5 / 32;
    CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
    CHECK_INT(calls.count, 33 + 8); /* found between the places: nothing else is followed */
    CHECK_INT(join.geometric, -1);
    CHECK_NEAR(join.gap.value, 0.5 + 1e-4, 1e-15);
}

TEST(the_order_of_a_join_is_that_of_the_first_measure_beyond_its_bound)
{
    for (int k = 0; k <= 4; k++)
        for (int unknown = 0; unknown < (k > 0 ? 2 : 1); unknown++) {
            hills h = {.height = {0.5, 0.25, 0.125, 0.125, 7, 7}};
            struct calls calls;
            batten_join join;
            if (k < 4)
                h.height[k] = unknown ? NAN : h.height[k] * (1 + 1e-12);
            CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
            CHECK_INT(join.geometric, k < 4 ? k - 1 : 3);
            CHECK_NEAR(join.rate_difference, 7, 0);
        }
}

TEST(places_where_a_measure_is_not_known_do_not_count)
{
    hills h = {.height = {0.1, 0.1, 0.1, 0.1, 2, 3}, .steep = {0.1, 0.1}, .known_from = 0.4};
    struct calls calls;
    batten_join join;
    CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
    CHECK_NEAR(join.gap.value, 0.1 - 0.1 * 169 / 1024, 1e-15);
    CHECK_NEAR(join.gap.at.x, 13 / 32., 0);
    CHECK_NEAR(join.rate.at.x, 13 / 32., 0);
    h.known_from = 2;
    CHECK_OK(walk_hills(&h, &calls, 1, unit, &join));
    CHECK(isnan(join.gap.value) && isnan(join.rate_difference));
    CHECK_INT(join.geometric, -1);
}

TEST(a_failure_at_any_place_ends_the_walk_with_it)
{
    for (int at = 1; at <= 41; at++) {
        hills h = {.height = {0, 0.2}, .steep = {0, 1}, .top = {0, 0.3}, .fails_at = at};
        struct calls calls;
        batten_join join;
        CHECK_STATUS(walk_hills(&h, &calls, 1, unit, &join), BATTEN_CANCELLED);
        CHECK_INT(calls.count, at);
    }
}

TEST(two_surfaces_at_one_place_are_compared_by_their_ways_out)
{
    const bat_straight straight = bat_straight_within(0.5, 2);
    const bat_across one = {{-1, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 1}},
                     other = {{cos(2), sin(2), 0}, {0, 0, 1}, {0, 0, 5}, {0, 0, -3}},
                     flat = {{1, 0, 0}, {0, 0, 1}, {0, 0, 0.0625}, {0, 0, 0.03125}},
                     flatter = {{-0.6, 0, 0.8}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    bat_meeting m;
    CHECK_NEAR(straight.curvature, 0.125, 0);
    CHECK_NEAR(straight.rate, 0.0625, 0);
    bat_meeting_compare(&one, &other, &straight, &m);
    CHECK_NEAR(m.angle, 2, 1e-15);
    CHECK_NEAR(m.curvature_difference, 3, 0);
    CHECK_NEAR(m.curvature, 0.6, 1e-16);
    CHECK_NEAR(m.rate_difference, 2, 0);
    CHECK_NEAR(m.rate, 2 / 3., 1e-16);
    bat_meeting_compare(&other, &one, &straight, &m);
    CHECK_NEAR(m.curvature, 0.6, 1e-16);
    CHECK_NEAR(m.rate, 2 / 3., 1e-16);
    bat_meeting_compare(&flat, &flatter, &straight, &m);
    CHECK_NEAR(m.angle, acos(0.6), 1e-15);
    CHECK_NEAR(m.curvature_difference, 0.0625, 0);
    CHECK_NEAR(m.curvature, 0.5, 0);
    CHECK_NEAR(m.rate_difference, 0.03125, 0);
    CHECK_NEAR(m.rate, 0.5, 0);
}
