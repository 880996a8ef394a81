#include "fair/fair_curve.h"
#include "support/test.h"

enum { N = 9, W = 2 };

/* Boole's rule: exact to the fifth degree. */
static const double boole[5] = {7, 32, 12, 32, 7};

/* The integral of |C^(order)|^2 of a curve whose derivative is of the second degree at most. */
static double integral_of(const batten_curve *curve, int order)
{
    const double *knots = batten_curve_knots(curve);
    double sum = 0, at[W * 4];
    for (int span = curve->degree; span < curve->count; span++) {
        const double a = knots[span], h = knots[span + 1] - a;
        for (int k = 0; h > 0 && k < 5; k++) {
            const double u = k < 4 ? a + h * k / 4 : knots[span + 1];
            CHECK_OK(batten_curve_evaluate_side(
                curve, u, k < 4 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, order, at));
            const double *d = at + W * order;
            sum += h / 90 * boole[k] * (d[0] * d[0] + d[1] * d[1]);
        }
    }
    return sum;
}

/* Uneven knots of about a unit, of a clamped curve one of them double; control points anywhere. */
static batten_status make_net_curve(int degree, bool periodic, double unit,
                                    const double *points, batten_curve **out)
{
    static const double step[N] = {1, 0.5, 1.5, 0.8, 1, 2, 0, 1.2, 0.9};
    double knots[N + BATTEN_MAX_DEGREE + 1], t = 0;
    const int count = periodic ? N + 1 : N + degree + 1;
    for (int i = 0; i < count; i++) {
        knots[i] = t;
        if (periodic || (i >= degree && i < N))
            t += unit * (periodic && step[i % N] == 0 ? 0.3 : step[i % N]);
    }
    const batten_points all = {W, N, points};
    return periodic ? batten_curve_create_periodic(all, degree, NULL, knots, out)
                    : batten_curve_create(all, degree, NULL, knots, out);
}

/* How far the integral is from its least in each coordinate of a control point: half its slope over half its second
 * difference, and by how much it falls. */
static double best_place(int degree, bool periodic, double unit, const double *points, int i,
                         double to[W])
{
    double gain = 0;
    const int order = degree < 3 ? degree : 3;
    for (int k = 0; k < W; k++) {
        double moved[W * N], value[3];
        memcpy(moved, points, sizeof moved);
        for (int side = -1; side <= 1; side++) {
            batten_curve *curve = NULL;
            moved[W * i + k] = points[W * i + k] + side;
            CHECK_OK(make_net_curve(degree, periodic, unit, moved, &curve));
            value[side + 1] = integral_of(curve, order);
            batten_curve_unref(curve);
        }
        const double slope = (value[2] - value[0]) / 4,
                     diagonal = (value[2] - 2 * value[1] + value[0]) / 2;
        to[k] = points[W * i + k] - slope / diagonal;
        gain += slope * slope / diagonal;
    }
    return gain;
}

static batten_status fair_net(const batten_curve *curve, int max_moves, const int *freedom,
                              double *z)
{
    double within[N], frames[W * W * N] = {0};
    batten_curve_fair_options options = batten_curve_fair_defaults(1e3);
    options.max_moves = max_moves;
    for (int i = 0; i < N; i++) {
        within[i] = 1e3;
        frames[W * W * i] = frames[W * W * i + 3] = 1;
    }
    const bat_fair_net net = {.curve = curve,
                              .dimension = W,
                              .degree = curve->degree,
                              .count = N,
                              .options = &options,
                              .ducks = {.width = W,
                                        .centre = curve->points,
                                        .within = within,
                                        .freedom = freedom,
                                        .frames = frames}};
    memcpy(z, curve->points, W * N * sizeof *z);
    return bat_fair_by_coefficients(&net, z);
}

static const struct {
    int degree;
    bool periodic;
    double unit;
} kinds[] = {{2, false, 1}, {3, false, 1}, {4, false, 1}, {5, false, 1}, {2, true, 1},
             {3, true, 1},  {5, true, 1},  {3, false, 8}, {4, true, 8}};

static void draw_points(test_random *random, double *points)
{
    for (int i = 0; i < W * N; i++)
        points[i] = i % W == 0 ? i / 2. : 0;
    for (int i = 0; i < W * N; i++)
        points[i] += test_random_in(random, -0.5, 0.5);
}

/* The best point that is free to its best place. */
static void move_best(int kind, const int *freedom, double *points)
{
    double to[W], best[W] = {0}, most = 0;
    int found = 0;
    for (int i = 0; i < N; i++) {
        const double gain = best_place(kinds[kind].degree, kinds[kind].periodic,
                                       kinds[kind].unit, points, i, to);
        if (freedom[i] == 0 || gain <= most)
            continue;
        most = gain;
        found = i;
        memcpy(best, to, sizeof best);
    }
    memcpy(points + W * found, best, sizeof best);
}

TEST(the_point_by_which_the_integral_falls_most_goes_to_where_it_is_least)
{
    test_random random = test_random_begin("coefficients");
    for (int t = 0; t < COUNT(kinds); t++) {
        static const int freedom[N] = {W, W, W, W, 0, W, W, W, W};
        double points[W * N], z[W * N];
        batten_curve *curve = NULL;
        draw_points(&random, points);
        CHECK_OK(
            make_net_curve(kinds[t].degree, kinds[t].periodic, kinds[t].unit, points, &curve));
        for (int moves = 1; moves <= 3; moves++) {
            move_best(t, freedom, points);
            CHECK_OK(fair_net(curve, moves, freedom, z));
            for (int i = 0; i < W * N; i++)
                CHECK_NEAR(z[i], points[i], 1e-9);
        }
        batten_curve_unref(curve);
    }
}
