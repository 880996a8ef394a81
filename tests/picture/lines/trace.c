#include "picture/lines/trace.h"

#include "picture/scenes.h"

/* A bicubic patch over the square 0 .. 3 whose inner control points are drawn aside. */
static batten_surface *drawn_patch(void)
{
    static const double points[16][3] = {{0, 0, 0}, {0, 1, 0},      {0, 2, 0},      {0, 3, 0},
                                         {1, 0, 0}, {2.6, 0.4, 4},  {0.2, 2.7, 0},  {1, 3, 0},
                                         {2, 0, 0}, {2.7, -0.4, 0}, {1.2, 2.9, -3}, {2, 3, 0},
                                         {3, 0, 0}, {3, 1, 0},      {3, 2, 0},      {3, 3, 0}};
    return scene_net(3, 4, 3, 4, points[0]);
}

static double off_segment(const double *a, const double *b, const double *p)
{
    double along = 0, length2 = 0, off2 = 0;
    for (int k = 0; k < 3; k++) {
        along += (b[k] - a[k]) * (p[k] - a[k]);
        length2 += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double s = length2 > 0 ? fmin(1, fmax(0, along / length2)) : 0;
    for (int k = 0; k < 3; k++)
        off2 += pow(p[k] - a[k] - s * (b[k] - a[k]), 2);
    return sqrt(off2);
}

/* The distance of a point from a polyline. */
static double off_stroke(const bat_stroke *stroke, const double *p)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i + 1 < stroke->count; i++)
        least = fmin(least, off_segment(stroke->points + 3 * i, stroke->points + 3 * i + 3, p));
    return least;
}

TEST(an_isoline_is_as_near_to_its_curve_as_asked)
{
    batten_surface *patch = drawn_patch();
    static const double tolerances[] = {0.1, 0.01, 1e-4};
    for (int t = 0; t < test_cases(COUNT(tolerances)); t++)
        for (int d = 0; d < 2; d++) {
            bat_stroke line = {0, NULL};
            CHECK_OK(bat_stroke_isoline_within(patch, d ? BATTEN_V : BATTEN_U, 0.4,
                                               tolerances[t], &line));
            for (int i = 0; i <= 500; i++) {
                double p[3];
                const double along = i / 500.0;
                CHECK_OK(
                    batten_surface_evaluate(patch, d ? along : 0.4, d ? 0.4 : along, 0, p));
                CHECK(off_stroke(&line, p) <= 1.1 * tolerances[t]);
            }
            bat_stroke_free(&line);
        }
    batten_surface_unref(patch);
}

/* One long span among two hundred short ones: steps of equal number would leave its bow in corners. */
TEST(a_long_span_among_short_ones_is_as_round_as_the_others)
{
    enum { COUNT_OF_POINTS = 204, DEGREE = 3 };
    double points[COUNT_OF_POINTS][2], knots[COUNT_OF_POINTS + DEGREE + 1];
    for (int i = 0; i < COUNT_OF_POINTS; i++) {
        const double angle = i < 4 ? 0.7 * i : 2.1 + 0.002 * (i - 3);
        points[i][0] = cos(angle), points[i][1] = sin(angle);
    }
    for (int i = 0; i < COUNT_OF_POINTS + DEGREE + 1; i++) {
        const int inner = i - DEGREE, last = COUNT_OF_POINTS - DEGREE;
        knots[i] = inner <= 0 ? 0 : inner >= last ? last + 1000 : 1000 + inner;
    }
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, COUNT_OF_POINTS, points[0]}, DEGREE, NULL,
                                 knots, &curve));
    bat_stroke line = {0, NULL};
    CHECK_OK(bat_stroke_curve(curve, &line));
    for (int i = 0; i <= test_cases(300); i++) {
        double p[3] = {0, 0, 0};
        CHECK_OK(batten_curve_evaluate(curve, 1001.0 * i / 300, 0, p));
        CHECK(off_stroke(&line, p) <= 2.0 / 20000);
    }
    bat_stroke_free(&line);
    batten_curve_unref(curve);
}

/* 0 before 1, and 1 from there on. */
static batten_status step(const void *user, double at, bool from_left, double point[3])
{
    (void)user;
    point[0] = at;
    point[1] = at > 1 || (at == 1 && !from_left);
    return BATTEN_OK;
}

TEST(both_limits_of_a_jump_are_kept)
{
    static const double knots[] = {0, 1, 2};
    const bat_traced traced = {.point_at = step, .tolerance = 0.01, .jumps = true};
    bat_stroke line = {0, NULL};
    CHECK_OK(bat_trace(&traced, 3, knots, &line));
    int at_one = 0;
    for (size_t i = 0; i < line.count; i++)
        at_one += line.points[3 * i] == 1;
    CHECK_INT(at_one, 2);
    bat_stroke_free(&line);
}
