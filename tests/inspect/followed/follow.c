/* One way along a line: its steps on a plane, its errors on a sphere and a tube, and who asks is told. */
#include "inspect/followed/follow.h"
#include "support/test.h"

#include <batten/standard.h>

static bat_follower follower_on(const batten_surface *surface, double size, double tolerance,
                                double most)
{
    bat_follower f = {.field = {.surface = surface, .kind = BATTEN_LINE_GEODESIC},
                      .size = size,
                      .tolerance = tolerance,
                      .most = most};
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        f.field.domain[k] = batten_surface_domain(surface, direction);
        f.field.closed[k] = batten_surface_is_closed(surface, direction, 1e-9);
    }
    return f;
}

/* A geodesic from (u, v) in a direction. */
static bat_station start_at(const bat_follower *f, double u, double v, batten_vec3 direction)
{
    bat_station s = {.place = {u, v}};
    bat_slope slope;
    CHECK(bat_slope_begin(&f->field, s.place, direction));
    CHECK_OK(bat_slope_at(&f->field, s.place, direction, &slope));
    s.point = slope.point;
    s.tangent = slope.tangent;
    return s;
}

static batten_status follow(bat_follower *f, const bat_station *from, bat_way *way)
{
    *way = (bat_way){0};
    const batten_status status = bat_follow(f, from, way);
    if (status != BATTEN_OK) {
        batten_release(way->at);
        way->at = NULL;
    }
    return status;
}

static batten_surface *plane(double width)
{
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){width, 0, 0},
                                     (batten_vec3){0, width, 0}, (batten_vec3){width, width, 0},
                                     &out));
    return out;
}

TEST(between_stations_runs_the_cubic_of_their_tangents)
{
    const bat_station a = {.point = {1, 2, 3}, .tangent = {1, 0, 0}, .length = 5},
                      b = {.point = {3, 1, 7}, .tangent = {0, 1, -1}, .length = 8};
    for (int i = 0; i <= 8; i++) {
        const double t = i / 8.0, h[4] = {(1 + 2 * t) * (1 - t) * (1 - t), t * t * (3 - 2 * t),
                                          3 * t * (1 - t) * (1 - t), -3 * t * t * (1 - t)};
        const batten_vec3 p = bat_station_between(&a, &b, t);
        CHECK_NEAR(p.x, h[0] + 3 * h[1] + h[2], 1e-14);
        CHECK_NEAR(p.y, 2 * h[0] + h[1] + h[3], 1e-14);
        CHECK_NEAR(p.z, 3 * h[0] + 7 * h[1] - h[3], 1e-14);
    }
}

/* Without an error steps grow nine times, from a 64th of the size; the last is cut to what is left. */
TEST(on_a_plane_steps_grow_nine_times_and_end_at_the_length_asked_for)
{
    static const double lengths[] = {0, 1, 10, 91, 500};
    batten_surface *surface = plane(1000);
    bat_follower f = follower_on(surface, 64, 1e-3, 500);
    const bat_station from = start_at(&f, 0.1, 0.2, (batten_vec3){3, 4, 1});
    bat_way way;
    CHECK_OK(follow(&f, &from, &way));
    CHECK_INT(way.count, COUNT(lengths));
    CHECK_INT(way.end, BATTEN_LINE_AT_LENGTH);
    CHECK_NEAR(way.length, 500, 1e-11);
    CHECK_NEAR(way.chord, 0, 1e-12);
    for (int i = 0; i < way.count; i++) {
        const bat_station *s = &way.at[i];
        CHECK_NEAR(s->length, lengths[i], 1e-11);
        CHECK_NEAR(s->point.x, 100 + 0.6 * lengths[i], 1e-11);
        CHECK_NEAR(s->point.y, 200 + 0.8 * lengths[i], 1e-11);
        CHECK_NEAR(s->place[0], 0.1 + 0.0006 * lengths[i], 1e-14);
        CHECK_NEAR(s->place[1], 0.2 + 0.0008 * lengths[i], 1e-14);
        CHECK_NEAR(s->tangent.x, 0.6, 1e-15);
        CHECK_NEAR(s->tangent.y, 0.8, 1e-15);
    }
    batten_release(way.at);
    batten_surface_unref(surface);
}

TEST(on_a_plane_a_line_ends_at_the_rim_to_rounding)
{
    batten_surface *surface = plane(1000);
    bat_follower f = follower_on(surface, 64, 1e-3, 1e4);
    const bat_station from = start_at(&f, 0.1, 0.2, (batten_vec3){3, 4, 0});
    bat_way way;
    CHECK_OK(follow(&f, &from, &way));
    CHECK_INT(way.end, BATTEN_LINE_AT_RIM);
    CHECK_NEAR(way.length, 1000, 1e-9);
    CHECK_NEAR(way.at[way.count - 1].point.y, 1000, 1e-9);
    CHECK_NEAR(way.at[way.count - 1].point.x, 700, 1e-9);
    batten_release(way.at);
    /* From the rim outwards there is nothing to go. */
    const bat_station rim = start_at(&f, 0.5, 1, (batten_vec3){0, 1, 0});
    CHECK_OK(follow(&f, &rim, &way));
    CHECK_INT(way.end, BATTEN_LINE_AT_RIM);
    CHECK_NEAR(way.length, 0, 1e-9);
    CHECK(way.count >= 1 && way.count <= 2);
    batten_release(way.at);
    batten_surface_unref(surface);
}

/* How far stations of a great circle are from it and from where their length puts them. */
static double error_on_ball(const batten_surface *ball, double tolerance, int *count)
{
    bat_follower f = follower_on(ball, 2 * sqrt(3), tolerance, 3);
    const batten_interval u = f.field.domain[0], v = f.field.domain[1];
    const bat_station from = start_at(&f, u.a + 0.1 * (u.b - u.a), v.a + 0.45 * (v.b - v.a),
                                      (batten_vec3){-0.3, 0.4, 0.5});
    bat_way way;
    double error = 0;
    CHECK_OK(follow(&f, &from, &way));
    CHECK_NEAR(way.length, 3, 1e-12);
    CHECK(way.chord <= tolerance / 4);
    for (int i = 0; i < way.count; i++) {
        const bat_station *s = &way.at[i];
        const double c = cos(s->length), n = sin(s->length);
        const batten_vec3 p = from.point, t = from.tangent;
        error = fmax(
            error, hypot(hypot(s->point.x - c * p.x - n * t.x, s->point.y - c * p.y - n * t.y),
                         s->point.z - c * p.z - n * t.z));
    }
    *count = way.count;
    batten_release(way.at);
    return error;
}

TEST(steps_on_a_sphere_err_far_less_than_the_tolerance_and_are_not_wasted)
{
    const batten_frame world = batten_frame_world();
    /* As many as these were made when the error was measured: fewer err more, more are wasted. */
    static const int counts[] = {40, 64, 104, 162, 235, 365};
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&world, 1, &ball));
    for (int i = 0; i < COUNT(counts); i++) {
        const double tolerance = pow(10, -4 - i);
        int count = 0;
        const double error = error_on_ball(ball, tolerance, &count);
        CHECK(error <= 4e-3 * tolerance);
        CHECK(count >= 0.98 * counts[i] && count <= 1.02 * counts[i]);
    }
    batten_surface_unref(ball);
}

typedef struct {
    int calls, most;
    double last;
} asked;

static void note_progress(void *user, double fraction, const char *what)
{
    asked *a = user;
    CHECK_TEXT(what, "following a line");
    CHECK(fraction >= a->last && fraction <= 1);
    a->last = fraction;
}

static bool is_cancelled(void *user)
{
    asked *a = user;
    return ++a->calls > a->most;
}

TEST(a_line_that_is_followed_can_be_watched_and_cancelled)
{
    batten_surface *surface = plane(1000);
    bat_follower f = follower_on(surface, 64, 1e-3, 500);
    const bat_station from = start_at(&f, 0.1, 0.2, (batten_vec3){3, 4, 1});
    asked a = {0, 1 << 30, 0};
    batten_job job = BATTEN_JOB;
    bat_way way;
    job.progress = note_progress;
    job.is_cancelled = is_cancelled;
    job.user = &a;
    f.work.job = &job;
    CHECK_OK(follow(&f, &from, &way));
    CHECK_NEAR(a.last, 1, 1e-12);
    batten_release(way.at);
    f.work = (bat_work){.job = &job};
    a = (asked){0, 0, 0};
    CHECK_STATUS(follow(&f, &from, &way), BATTEN_CANCELLED);
    batten_surface_unref(surface);
}

/* A helix on a tube that takes some fourteen steps around. */
TEST(a_line_of_more_than_a_hundred_thousand_points_is_refused)
{
    const batten_frame world = batten_frame_world();
    batten_surface *tube = NULL;
    CHECK_OK(batten_surface_cylinder(&world, 1, 1e5, &tube));
    bat_follower f = follower_on(tube, 1e5, 1e-7, 1e6);
    const bat_station from =
        start_at(&f, f.field.domain[0].a, f.field.domain[1].a, (batten_vec3){0, 1, 0.05});
    bat_way way;
    f.size = 4;
    CHECK_STATUS(follow(&f, &from, &way), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("the line has more than 100000 points after a length of ");
    batten_surface_unref(tube);
}
