/* How far a part of a surface reaches: a rectangle of its parameters, whose border is known. */
#include "inspect/extent/surface_extent.h"
#include "numeric/box.h"
#include "support/test.h"

typedef struct {
    batten_interval uv[2];
    int asked;
} window;

static bat_share share_of(const void *context, const batten_interval uv[2])
{
    window *w = (window *)(uintptr_t)context;
    w->asked++;
    bool all = true, none = false;
    for (int k = 0; k < 2; k++) {
        all = all && uv[k].a >= w->uv[k].a && uv[k].b <= w->uv[k].b;
        none = none || uv[k].b < w->uv[k].a || uv[k].a > w->uv[k].b;
    }
    return none ? BAT_NOTHING : all ? BAT_ALL : BAT_A_PART;
}

/* x = u and y = v, as points over a grid of Greville abscissae; z by the heights. */
static batten_surface *graph_over(batten_axis u, batten_axis v, const double *heights,
                                  const double *weights)
{
    double points[3 * 64];
    batten_surface *surface = NULL;
    for (int i = 0; i < u.point_count; i++)
        for (int j = 0; j < v.point_count; j++) {
            double *p = points + 3 * (i * v.point_count + j);
            p[0] = p[1] = 0;
            for (int k = 1; k <= u.degree; k++)
                p[0] += u.knots[i + k] / u.degree;
            for (int k = 1; k <= v.degree; k++)
                p[1] += v.knots[j + k] / v.degree;
            p[2] = heights[i * v.point_count + j];
        }
    CHECK_OK(batten_surface_create(3, &u, &v, points, weights, &surface));
    return surface;
}

static void join_point(batten_box *box, const double p[3])
{
    box->low =
        (batten_vec3){fmin(box->low.x, p[0]), fmin(box->low.y, p[1]), fmin(box->low.z, p[2])};
    box->high = (batten_vec3){fmax(box->high.x, p[0]), fmax(box->high.y, p[1]),
                              fmax(box->high.z, p[2])};
}

/* Of all that a grid reaches, or its border alone. */
static batten_box grid_box(const batten_surface *surface, const window *w, int n, bool border)
{
    batten_box box = bat_box_of_nothing();
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j += border && i > 0 && i < n ? n : 1) {
            double p[3];
            CHECK_OK(
                batten_surface_evaluate(surface, w->uv[0].a + (w->uv[0].b - w->uv[0].a) * i / n,
                                        w->uv[1].a + (w->uv[1].b - w->uv[1].a) * j / n, 0, p));
            join_point(&box, p);
        }
    return box;
}

static batten_status reach(const batten_surface *surface, const batten_box *border,
                           const bat_region *region, double tolerance, bat_extent *extent)
{
    *extent = (bat_extent){*border, *border};
    return bat_surface_extent(surface, region, tolerance, extent);
}

static bat_extent extent_in(const batten_surface *surface, window *w, double tolerance)
{
    const batten_box border = grid_box(surface, w, 400, true);
    const bat_region region = {share_of, w};
    bat_extent extent;
    w->asked = 0;
    CHECK_OK(reach(surface, &border, &region, tolerance, &extent));
    return extent;
}

/* ---- tops inside and outside ---- */

static const double one_span[] = {0, 0, 0, 1, 1, 1}, tent[] = {0, 0, 0.5, 1, 1},
                    sharp[] = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
static const double hill[9] = {0, 0, 0, 0, 4, 0, 0, 0, 0},
                    pyramid[9] = {0, 0, 0, 0, 1, 0, 0, 0, 0};
/* 1 - |2 u - 1| (u in quadratic form) times 4 v (1 - v), and with u for v */
static const double roof[15] = {0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0},
                    other_roof[15] = {0, 0, 0, 0, 0, 0, 1, 2, 1, 0, 0, 0, 0, 0, 0};

static const struct {
    batten_axis u, v;
    const double *heights;
    batten_interval uv[2];
    double sign, top; /* of sign times z within */
} tops[] = {
    /* 16 u (1 - u) v (1 - v) */
    {{2, 3, one_span, false}, {2, 3, one_span, false}, hill, {{0.25, 0.9}, {0.3, 0.8}}, 1, 1},
    {{2, 3, one_span, false}, {2, 3, one_span, false}, hill, {{0.25, 0.9}, {0.3, 0.8}}, -1, 1},
    {{2, 3, one_span, false}, {2, 3, one_span, false}, hill, {{0.6, 0.9}, {0.3, 0.8}}, 1, 0.96},
    {{2, 3, one_span, false}, {2, 3, one_span, false}, hill, {{0.1, 0.4}, {0.3, 0.8}}, 1, 0.96},
    {{2, 3, one_span, false},
     {2, 3, one_span, false},
     hill,
     {{0.3, 0.8}, {0.1, 0.4}},
     -1,
     0.96},
    {{2, 3, one_span, false}, {2, 3, one_span, false}, hill, {{0.3, 0.8}, {0.6, 0.9}}, 1, 0.96},
    {{1, 3, tent, false}, {1, 3, tent, false}, pyramid, {{0.3, 0.9}, {0.2, 0.6}}, 1, 1},
    {{1, 3, tent, false}, {1, 3, tent, false}, pyramid, {{0.3, 0.9}, {0.2, 0.6}}, -1, 1},
    {{1, 3, tent, false}, {1, 3, tent, false}, pyramid, {{0.1, 0.45}, {0.2, 0.6}}, 1, 0.9},
    {{2, 5, sharp, false}, {2, 3, one_span, false}, roof, {{0.3, 0.9}, {0.2, 0.6}}, 1, 1},
    {{2, 5, sharp, false}, {2, 3, one_span, false}, roof, {{0.3, 0.9}, {0.2, 0.6}}, -1, 1},
    {{2, 3, one_span, false}, {2, 5, sharp, false}, other_roof, {{0.3, 0.9}, {0.2, 0.6}}, 1, 1},
    {{2, 3, one_span, false},
     {2, 5, sharp, false},
     other_roof,
     {{0.3, 0.9}, {0.2, 0.6}},
     -1,
     1},
};

TEST(a_top_inside_counts_also_at_a_crease_and_one_outside_does_not)
{
    const double tolerance = 1e-6;
    for (int i = 0; i < COUNT(tops); i++) {
        window w = {{tops[i].uv[0], tops[i].uv[1]}, 0};
        double heights[15];
        for (int k = 0; k < 15; k++)
            heights[k] = k < tops[i].u.point_count * tops[i].v.point_count
                             ? tops[i].sign * tops[i].heights[k]
                             : 0;
        batten_surface *surface = graph_over(tops[i].u, tops[i].v, heights, NULL);
        const bat_extent e = extent_in(surface, &w, tolerance);
        const bool down = tops[i].sign < 0;
        const double reached = down ? -e.reached.low.z : e.reached.high.z,
                     within = down ? -e.within.low.z : e.within.high.z;
        CHECK(reached <= tops[i].top + 1e-15 && reached >= tops[i].top - tolerance);
        CHECK(within >= tops[i].top - 1e-15 && within <= tops[i].top + tolerance);
        CHECK(bat_extent_slack(&e) <= tolerance);
        CHECK_NEAR(e.within.low.x, w.uv[0].a, 1e-15);
        CHECK_NEAR(e.within.high.x, w.uv[0].b, 1e-15);
        CHECK_NEAR(e.within.low.y, w.uv[1].a, 1e-15);
        CHECK_NEAR(e.within.high.y, w.uv[1].b, 1e-15);
        /* What rises to one of its sides is not searched: the border is known. */
        CHECK(test_cases(10) < 10 || w.asked < 600);
        batten_surface_unref(surface);
    }
}

/* Heights between -1 and 1 over a region, with weights from 1/2 to 2: beside a fine grid. */
TEST(regions_of_random_surfaces_reach_as_far_as_their_points)
{
    static const double quartic[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    test_random random = test_random_begin("extents of regions");
    for (int i = 0; i < test_cases(12); i++) {
        const batten_axis u = {2, 3, one_span, false}, v = {4, 5, quartic, false};
        double heights[15], weights[15];
        for (int k = 0; k < 15; k++) {
            heights[k] = test_random_in(&random, -1, 1);
            weights[k] = test_random_in(&random, 0.5, 2);
        }
        batten_surface *surface = i % 2 ? graph_over(u, v, heights, i % 4 > 1 ? weights : NULL)
                                        : graph_over(v, u, heights, i % 4 > 1 ? weights : NULL);
        window w = {{{0.1, 0.7}, {0.35, 0.95}}, 0};
        const bat_extent e = extent_in(surface, &w, 1e-7);
        const batten_box grid = grid_box(surface, &w, 100, false);
        CHECK(bat_extent_slack(&e) <= 1e-7);
        CHECK(grid.low.z >= e.within.low.z - 1e-4 && grid.low.z <= e.within.low.z + 2e-3);
        CHECK(grid.high.z <= e.within.high.z + 1e-4 && grid.high.z >= e.within.high.z - 2e-3);
        CHECK(grid.low.x >= e.within.low.x - 1e-4 && grid.low.x <= e.within.low.x + 2e-3);
        CHECK(grid.high.y <= e.within.high.y + 1e-4 && grid.high.y >= e.within.high.y - 2e-3);
        batten_surface_unref(surface);
    }
}

TEST(slack_is_the_largest_distance_of_sides)
{
    for (int side = 0; side < 6; side++) {
        bat_extent e = {{{1, 2, 3}, {4, 5, 6}}, {{0.875, 1.875, 2.875}, {4.125, 5.125, 6.125}}};
        double *sides[] = {&e.within.low.x,  &e.within.low.y,  &e.within.low.z,
                           &e.within.high.x, &e.within.high.y, &e.within.high.z};
        CHECK_BITS(bat_extent_slack(&e), 0.125);
        *sides[side] += side < 3 ? -0.5 : 0.5;
        CHECK_BITS(bat_extent_slack(&e), 0.625);
    }
}
