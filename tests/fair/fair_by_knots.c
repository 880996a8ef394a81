#include "fair/fair_curve.h"
#include "support/test.h"

enum { N = 10, MAX_W = 3 };

/* Uneven knots, at will one of them double; control points anywhere. */
static batten_status make_net_curve(int width, bool periodic, int twice, const double *points,
                                    batten_curve **out)
{
    static const double step[N] = {1, 0.5, 1.5, 0.8, 1, 2, 0.7, 1.2, 0.9, 1.1};
    double knots[N + 4], t = 0;
    for (int i = 0; i < (periodic ? N + 1 : N + 4); i++) {
        knots[i] = t;
        if ((periodic || (i >= 3 && i < N)) && i != twice)
            t += step[i % N];
    }
    const batten_points all = {width, N, points};
    return periodic ? batten_curve_create_periodic(all, 3, NULL, knots, out)
                    : batten_curve_create(all, 3, NULL, knots, out);
}

/* The jump of C''' at the knot in the middle of the five of point i, of a periodic curve over the seam; 0 where the point has
 * none, or it is double. */
static double jump_of(const batten_curve *curve, int i)
{
    const int w = curve->dimension;
    const double *knots = curve->knots;
    double left[4 * MAX_W], right[4 * MAX_W];
    const batten_interval domain = batten_curve_domain(curve);
    int at = i + 2;
    if (curve->periodic && at < 3)
        at += N;
    if (!curve->periodic && (i < 2 || i >= N - 2))
        return 0;
    if (knots[at] == knots[at - 1] || knots[at] == knots[at + 1])
        return 0;
    const double u = knots[at], from = u == domain.a ? domain.b : u,
                 on = u == domain.b ? domain.a : u;
    CHECK_OK(batten_curve_evaluate_side(curve, from, BATTEN_FROM_LEFT, 3, left));
    CHECK_OK(batten_curve_evaluate_side(curve, on, BATTEN_FROM_RIGHT, 3, right));
    return bat_distance(w, left + 3 * w, right + 3 * w);
}

static batten_status fair_net(const batten_curve *curve, int max_moves, int held, double *z)
{
    const int w = curve->dimension;
    double within[N], frames[MAX_W * MAX_W * N] = {0};
    int freedom[N];
    batten_curve_fair_options options = batten_curve_fair_defaults(1e3);
    options.max_moves = max_moves;
    for (int i = 0; i < N; i++) {
        within[i] = 1e3;
        freedom[i] = i == held ? 0 : w;
        for (int k = 0; k < w; k++)
            frames[(i * w + k) * w + k] = 1;
    }
    const bat_fair_net net = {.curve = curve,
                              .dimension = w,
                              .degree = curve->degree,
                              .count = N,
                              .options = &options,
                              .ducks = {.width = w,
                                        .centre = curve->points,
                                        .within = within,
                                        .freedom = freedom,
                                        .frames = frames}};
    memcpy(z, curve->points, (size_t)(N * w) * sizeof *z);
    return bat_fair_by_knots(&net, z);
}

static double sum_of_jumps(const batten_curve *curve)
{
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += jump_of(curve, i);
    return sum;
}

/* One move from a spline of which one control point is off: the worst knot is that of the point, and C''' no longer jumps. */
static void check_first_move(int width, bool periodic, int twice, int off)
{
    double points[MAX_W * N], z[MAX_W * N];
    batten_curve *curve = NULL, *made = NULL;
    for (int i = 0; i < N * width; i++)
        points[i] = bat_sin(0.6283185307179586 * (i / width) + i % width);
    for (int k = 0; k < width; k++)
        points[off * width + k] += 3 - 2 * k;
    CHECK_OK(make_net_curve(width, periodic, twice, points, &curve));
    CHECK_OK(fair_net(curve, 1, -1, z));
    int moved = -1;
    for (int i = 0; i < N; i++)
        if (memcmp(z + i * width, points + i * width, (size_t)width * sizeof *z) != 0) {
            CHECK_INT(moved, -1);
            moved = i;
        }
    CHECK(moved >= 0);
    CHECK_OK(make_net_curve(width, periodic, twice, z, &made));
    for (int i = 0; i < N; i++)
        CHECK(jump_of(curve, i) <= jump_of(curve, moved));
    CHECK_NEAR(jump_of(made, moved), 0, 1e-11);
    CHECK(sum_of_jumps(made) < sum_of_jumps(curve));
    batten_curve_unref(curve);
    batten_curve_unref(made);
}

TEST(the_worst_knot_of_a_clamped_curve_is_taken_out)
{
    for (int width = 1; width <= 3; width++)
        for (int off = 2; off < N - 2; off++)
            check_first_move(width, false, -1, off);
}

TEST(the_worst_knot_of_a_periodic_curve_is_taken_out_on_its_seam_too)
{
    for (int width = 1; width <= 3; width++)
        for (int off = 0; off < N; off++)
            check_first_move(width, true, -1, off);
}

TEST(a_double_knot_is_never_taken_out)
{
    for (int twice = 4; twice < N - 1; twice++)
        for (int off = 0; off < N; off++)
            check_first_move(2, false, twice, off);
}

TEST(points_that_are_held_stay_and_those_without_a_knot_as_well)
{
    double points[2 * N], z[2 * N];
    batten_curve *curve = NULL;
    test_random random = test_random_begin("knots");
    for (int i = 0; i < 2 * N; i++)
        points[i] = i + test_random_in(&random, -1, 1);
    CHECK_OK(make_net_curve(2, false, -1, points, &curve));
    CHECK_OK(fair_net(curve, 0, 5, z));
    for (int i = 0; i < N; i++)
        CHECK_INT(memcmp(z + 2 * i, points + 2 * i, 2 * sizeof *z) == 0,
                  i < 2 || i >= N - 2 || i == 5);
    batten_curve_unref(curve);
}

TEST(knots_are_taken_out_of_cubics_alone)
{
    double points[2 * N] = {0}, z[2 * N];
    for (int degree = 2; degree <= 4; degree += 2) {
        double knots[N + 5];
        char words[80];
        batten_curve *curve = NULL;
        for (int i = 0; i < N + degree + 1; i++)
            knots[i] = i <= degree ? 0 : i >= N ? N : i;
        CHECK_OK(
            batten_curve_create((batten_points){2, N, points}, degree, NULL, knots, &curve));
        CHECK_STATUS(fair_net(curve, 0, -1, z), BATTEN_UNSUPPORTED);
        snprintf(words, sizeof words, "out of cubics, and this is of degree %d", degree);
        CHECK_MESSAGE(words);
        batten_curve_unref(curve);
    }
}
