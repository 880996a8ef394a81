#include "fair/one_by_one.h"
#include "support/test.h"

enum { MOST_POINTS = 4, MOST_PROPOSALS = 100 };

/* Points that are unfair by their distances from targets, and are sent `times` as far as these are away. */
typedef struct {
    int width, count;
    double target[3 * MOST_POINTS], weight[MOST_POINTS], times, offset;
    int after; /* point 0 is sent to where it should be only when this one is there; 0: at once */
    int done_after, asked;
    batten_status status;
    int proposed[MOST_PROPOSALS], proposals;
    double centre[3 * MOST_POINTS], within[MOST_POINTS], frames[9 * MOST_POINTS];
    int freedom[MOST_POINTS];
    bat_ducks ducks;
    bat_one_by_one method;
} targets;

static double measure_targets(void *state, const double *z, double *unfairness)
{
    const targets *s = state;
    double sum = s->offset;
    for (int i = 0; i < s->count; i++) {
        const double *target = s->target + i * s->width;
        unfairness[i] = s->weight[i] * bat_distance(s->width, z + i * s->width, target);
        sum += unfairness[i];
    }
    return sum;
}

static void propose_target(void *state, const double *z, int i, double *to)
{
    targets *s = state;
    const int w = s->width;
    if (s->proposals < MOST_PROPOSALS)
        s->proposed[s->proposals] = i;
    s->proposals++;
    for (int k = 0; k < w; k++) {
        const double way = s->times * (s->target[i * w + k] - z[i * w + k]);
        const bool late = i == 0 && s->after > 0 &&
                          bat_distance(w, z + s->after * w, s->target + s->after * w) > 0;
        to[k] += late ? -way : way;
    }
}

static batten_status ask_to_stop(const void *judge, const double *z, bool *done)
{
    targets *s = *(targets *const *)judge;
    (void)z;
    *done = ++s->asked == s->done_after && s->status == BATTEN_OK;
    return s->asked == s->done_after ? s->status : BATTEN_OK;
}

/* Free points at 0, each with its target on the first axis. */
static void begin_targets(int width, int count, const double *target, targets *s)
{
    *s = (targets){.width = width, .count = count, .times = 1};
    for (int i = 0; i < count; i++) {
        s->target[i * width] = target[i];
        s->weight[i] = 1;
        s->within[i] = 100;
        s->freedom[i] = width;
        for (int k = 0; k < width; k++)
            s->frames[(i * width + k) * width + k] = 1;
    }
    s->ducks = (bat_ducks){.width = width,
                           .centre = s->centre,
                           .within = s->within,
                           .freedom = s->freedom,
                           .frames = s->frames};
    s->method = (bat_one_by_one){.state = s,
                                 .measure = measure_targets,
                                 .propose = propose_target,
                                 .count = count,
                                 .ducks = &s->ducks};
}

TEST(the_worst_point_goes_first_and_what_is_fair_is_left_alone)
{
    static const double target[] = {1, 0, -4, 2};
    for (int width = 1; width <= 3; width++) {
        targets s;
        double z[3 * MOST_POINTS] = {0};
        begin_targets(width, 4, target, &s);
        CHECK_OK(bat_move_one_by_one(&s.method, z));
        CHECK_INT(s.proposals, 3);
        CHECK(s.proposed[0] == 2 && s.proposed[1] == 3 && s.proposed[2] == 0);
        for (int i = 0; i < 4 * width; i++)
            CHECK(z[i] == (i % width == 0 ? target[i / width] : 0));
    }
}

/* The distance from a target at 1 is below 1 from 0 to 2, exclusively. */
TEST(a_point_goes_the_whole_way_or_a_half_or_a_quarter_or_an_eighth)
{
    static const struct {
        double times, reached;
    } rows[] = {{0.5, 0.5}, {1, 1},         {1.75, 1.75}, {2, 1},         {3, 1.5}, {4, 1},
                {7, 1.75},  {7.75, 1.9375}, {8, 1},       {15.5, 1.9375}, {16, 0},  {31, 0}};
    static const double target[] = {1};
    for (int i = 0; i < COUNT(rows); i++) {
        targets s;
        double z[1] = {0};
        begin_targets(1, 1, target, &s);
        s.times = rows[i].times;
        s.method.most = 1;
        CHECK_OK(bat_move_one_by_one(&s.method, z));
        CHECK_NEAR(z[0], rows[i].reached, 0);
        CHECK_INT(s.proposals, 1);
    }
}

TEST(a_way_below_a_millionth_of_the_bound_or_a_gain_below_a_milliardth_is_none)
{
    static const struct {
        double times, within, offset;
        bool moves;
    } rows[] = {{2e-6, 1, 0, true},   {0.5e-6, 1, 0, false}, {2e-5, 10, 0, true},
                {5e-6, 10, 0, false}, {1, 100, 0.5e9, true}, {1, 100, 2e9, false}};
    static const double target[] = {1};
    for (int i = 0; i < COUNT(rows); i++) {
        targets s;
        double z[1] = {0};
        begin_targets(1, 1, target, &s);
        s.times = rows[i].times;
        s.within[0] = rows[i].within;
        s.offset = rows[i].offset;
        s.method.most = 1;
        CHECK_OK(bat_move_one_by_one(&s.method, z));
        CHECK_NEAR(z[0], rows[i].moves ? rows[i].times : 0, 0);
    }
}

TEST(points_stay_within_their_bounds)
{
    static const double target[] = {3, -2};
    targets s;
    double z[4] = {5, 7, 5, 7};
    begin_targets(2, 2, target, &s);
    for (int i = 0; i < 4; i++) {
        s.centre[i] = z[i];
        s.target[i] += z[i];
    }
    s.within[0] = 0.5;
    s.within[1] = 0.25;
    CHECK_OK(bat_move_one_by_one(&s.method, z));
    CHECK_NEAR(z[0], 5.5, 1e-14);
    CHECK_NEAR(z[2], 4.75, 1e-14);
    CHECK(z[0] <= 5.5 && z[2] >= 4.75 && z[1] == 7 && z[3] == 7);
}

/* The second of three points, whose frame is turned; the others are fair. */
TEST(points_move_along_the_rows_of_their_frames_that_are_free)
{
    static const double frame[9] = {0, 0.6, 0.8, 1, 0, 0, 0, -0.8, 0.6};
    static const double reached[4][3] = {{0}, {0, 3, 4}, {2, 3, 4}, {2, 7, 1}};
    static const double none[3] = {0};
    for (int freedom = 0; freedom <= 3; freedom++) {
        targets s;
        double z[9] = {0};
        begin_targets(3, 3, none, &s);
        memcpy(s.target + 3, (const double[3]){2, 7, 1}, 3 * sizeof *z);
        memcpy(s.frames + 9, frame, sizeof frame);
        s.freedom[1] = freedom;
        CHECK_OK(bat_move_one_by_one(&s.method, z));
        CHECK_INT(s.proposals > 0, freedom > 0);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(z[3 + k], reached[freedom][k], 1e-14);
            CHECK(z[k] == 0 && z[6 + k] == 0);
        }
    }
}

TEST(a_point_that_rests_is_tried_again_after_another_has_moved)
{
    static const double target[] = {3, 1, 2};
    static const int order[] = {0, 2, 0, 1, 0};
    targets s;
    double z[3] = {0};
    begin_targets(1, 3, target, &s);
    s.after = 1;
    s.method.most = 3; /* those that rest do not count */
    CHECK_OK(bat_move_one_by_one(&s.method, z));
    CHECK_INT(s.proposals, COUNT(order));
    for (int i = 0; i < COUNT(order); i++)
        CHECK_INT(s.proposed[i], order[i]);
    for (int i = 0; i < 3; i++)
        CHECK(z[i] == target[i]);
}

/* A tenth of the way each time: two points, the worse first, go in turn. */
TEST(the_moves_are_as_many_as_are_allowed_and_else_20_for_each_point)
{
    static const double target[] = {1, 1};
    static const struct {
        int most, first, second;
    } rows[] = {{1, 1, 0}, {2, 1, 1}, {5, 3, 2}, {0, 20, 20}};
    for (int i = 0; i < COUNT(rows); i++) {
        targets s;
        double z[2] = {0};
        begin_targets(1, 2, target, &s);
        s.times = 0.1;
        s.method.most = rows[i].most;
        CHECK_OK(bat_move_one_by_one(&s.method, z));
        CHECK_INT(s.proposals, rows[i].first + rows[i].second);
        CHECK_NEAR(z[0], 1 - pow(0.9, rows[i].first), 1e-14);
        CHECK_NEAR(z[1], 1 - pow(0.9, rows[i].second), 1e-14);
    }
}

/* It is asked before the first move, too. */
TEST(the_moves_end_when_the_method_says_so)
{
    static const double target[] = {4, 3, 2, 1};
    for (int done_after = 1; done_after <= 3; done_after++)
        for (int fails = 0; fails < 2; fails++) {
            targets s, *self = &s;
            double z[4] = {0};
            begin_targets(1, 4, target, &s);
            s.method.is_done = ask_to_stop;
            s.method.judge = &self;
            s.done_after = done_after;
            s.status = fails ? BATTEN_UNSUPPORTED : BATTEN_OK;
            CHECK_STATUS(bat_move_one_by_one(&s.method, z), s.status);
            CHECK_INT(s.asked, done_after);
            for (int i = 0; i < 4; i++)
                CHECK(z[i] == (i < done_after - 1 ? target[i] : 0));
        }
}

static bool is_cancelled(void *user)
{
    (void)user;
    return true;
}

TEST(moves_that_are_cancelled_end)
{
    static const double target[] = {1, 2};
    targets s;
    double z[2] = {0};
    batten_job job = BATTEN_JOB;
    begin_targets(1, 2, target, &s);
    job.is_cancelled = is_cancelled;
    s.method.job = &job;
    CHECK_STATUS(bat_move_one_by_one(&s.method, z), BATTEN_CANCELLED);
    CHECK_INT(s.proposals, 1);
}
