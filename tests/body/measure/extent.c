/* How far edges and faces reach. */
#include "body/measure/extent.h"

#include "body/by_hand.h"
#include "numeric/box.h"
#include "support/test.h"

#include <batten/standard.h>
#include <stdint.h>

/* The part of a ball of radius 5 above z = 4, or below. */
static batten_body *cap(bool below)
{
    hand m = hand_begin();
    batten_surface *ball = NULL;
    batten_body *body = NULL, *traced = NULL;
    CHECK_OK(batten_surface_sphere(&hand_world, 5, &ball));
    hand_arc(&m, 3, 4, 0, 360);
    hand_face(&m, ball, false);
    HAND_LOOP(&m, below ? -1 : 1);
    m.builder.parts.tolerance = 1e-6;
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    batten_body_unref(body);
    return traced;
}

static void check_box(batten_box box, const double low[3], const double high[3], double error)
{
    CHECK_NEAR(box.low.x, low[0], error);
    CHECK_NEAR(box.low.y, low[1], error);
    CHECK_NEAR(box.low.z, low[2], error);
    CHECK_NEAR(box.high.x, high[0], error);
    CHECK_NEAR(box.high.y, high[1], error);
    CHECK_NEAR(box.high.z, high[2], error);
}

TEST(edges_reach_as_far_as_their_curves_and_faces_to_their_own_extremes)
{
    static const double low[2][3] = {{-3, -3, 4}, {-5, -5, -5}};
    static const double high[2][3] = {{3, 3, 5}, {5, 5, 4}};
    for (int below = 0; below < 2; below++) {
        batten_body *body = cap(below);
        const batten_body_parts *parts = batten_body_view(body);
        bat_extent extent = {bat_box_of_nothing(), bat_box_of_nothing()};
        CHECK_OK(bat_edges_extent(parts, &extent)); /* also the seam, up to the pole */
        CHECK(extent.reached.low.z <= 4 && extent.reached.high.z >= 4);
        CHECK_NEAR(bat_extent_slack(&extent), 0, 1e-9);
        for (int f = 0; f < parts->face_count; f++)
            CHECK_OK(bat_face_extent(parts, f, 1e-6, &extent));
        check_box(extent.reached, low[below], high[below], 1e-5);
        check_box(extent.within, low[below], high[below], 1e-5);
        batten_body_unref(body);
    }
}

/* z = 1 - x^2 - y^2 with x and y as parameters, over [-2, 2] and [-1, 3]. */
static batten_surface *paraboloid(void)
{
    static const double knots_u[] = {-2, -2, -2, 2, 2, 2}, knots_v[] = {-1, -1, -1, 3, 3, 3};
    static const double x[] = {-2, 0, 2}, y[] = {-1, 1, 3};   /* Greville abscissae */
    static const double xx[] = {4, -4, 4}, yy[] = {1, -3, 9}; /* blossoms of squares */
    const batten_axis u = {2, 3, knots_u, false}, v = {2, 3, knots_v, false};
    double points[3][3][3];
    batten_surface *surface = NULL;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = x[i];
            points[i][j][1] = y[j];
            points[i][j][2] = 1 - xx[i] - yy[j];
        }
    CHECK_OK(batten_surface_create(3, &u, &v, &points[0][0][0], NULL, &surface));
    return surface;
}

typedef struct {
    int count;
    double corners[4][2];
} loop_corners;

/* The highest point of the edges of a loop: where a side is nearest to the origin; `box` of them all. */
static batten_box box_of_sides(const loop_corners *l)
{
    batten_box box = bat_box_of_nothing();
    for (int i = 0; i < l->count; i++) {
        const double *a = l->corners[i], *b = l->corners[(i + 1) % l->count];
        const double d[2] = {b[0] - a[0], b[1] - a[1]};
        const double t = -(a[0] * d[0] + a[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        const double at = fmin(1, fmax(0, t)), x = a[0] + at * d[0], y = a[1] + at * d[1];
        bat_box_join(&box, bat_box_at((double[]){a[0], a[1], 1 - a[0] * a[0] - a[1] * a[1]}));
        bat_box_join(&box, bat_box_at((double[]){x, y, 1 - x * x - y * y}));
    }
    return box;
}

/* One face whose loops are polygons in the parameters. */
static bat_extent extent_of(int loop_count, const loop_corners *loops)
{
    batten_body_use uses[8] = {{0}};
    batten_body_loop ranges[2] = {{0}};
    int count = 0;
    bat_extent extent = {bat_box_of_nothing(), bat_box_of_nothing()};
    for (int l = 0; l < loop_count; l++) {
        ranges[l] = (batten_body_loop){.first = count, .count = loops[l].count};
        for (int i = 0; i < loops[l].count; i++, count++) {
            const double *a = loops[l].corners[i];
            const double *b = loops[l].corners[(i + 1) % loops[l].count];
            batten_curve *side = NULL;
            CHECK_OK(batten_curve_polyline(
                (batten_points){2, 2, (double[]){a[0], a[1], b[0], b[1]}}, &side));
            uses[count].parameters = side;
        }
        bat_box_join(&extent.reached, box_of_sides(&loops[l]));
    }
    const batten_body_face face = {.surface = paraboloid(), .first = 0, .count = loop_count};
    const batten_body_parts parts = {.use_count = count,
                                     .uses = uses,
                                     .loop_count = loop_count,
                                     .loops = ranges,
                                     .face_count = 1,
                                     .faces = &face};
    extent.within = extent.reached;
    CHECK_OK(bat_face_extent(&parts, 0, 1e-9, &extent));
    for (int i = 0; i < count; i++)
        batten_curve_unref((batten_curve *)(uintptr_t)uses[i].parameters);
    batten_surface_unref((batten_surface *)(uintptr_t)face.surface);
    return extent;
}

static const struct {
    int count;
    loop_corners loops[2];
    bool has_top; /* the origin is in the face */
} faces[] = {
    {1, {{3, {{-1, -0.5}, {1.5, 0.2}, {-0.3, 2}}}}, true},
    {1, {{3, {{-1, 0.1}, {1.5, 0.15}, {-0.3, 2}}}}, false}, /* above the origin */
    {1, {{3, {{-1, -0.9}, {1.5, -0.05}, {1.9, -0.9}}}}, false},
    {1, {{3, {{0.1, -0.8}, {1.9, 0.3}, {0.2, 2.9}}}}, false}, /* to its right */
    {1, {{3, {{-1.9, -0.8}, {-0.1, 2.9}, {-0.05, -0.9}}}}, false},
    {1, {{4, {{-1.9, 0.2}, {0.2, -0.9}, {1.9, 0.3}, {0.5, 2.8}}}}, true},
    {1, {{4, {{-1.5, -0.8}, {0.05, 0.1}, {1.5, -0.8}, {0.3, 2.5}}}}, false}, /* not convex */
    {2,
     {{4, {{-1.9, -0.9}, {1.9, -0.9}, {1.9, 2.9}, {-1.9, 2.9}}},
      {3, {{-0.5, -0.3}, {0.1, 0.6}, {0.7, -0.2}}}},
     false}, /* a hole on it */
    {2,
     {{4, {{-1.9, -0.9}, {1.9, -0.9}, {1.9, 2.9}, {-1.9, 2.9}}},
      {3, {{-0.5, 0.1}, {0.1, 0.9}, {0.7, 0.1}}}},
     true}, /* beside it */
};

TEST(an_extreme_counts_where_the_loops_enclose_it)
{
    for (int i = 0; i < COUNT(faces); i++) {
        bat_extent wanted = {bat_box_of_nothing(), bat_box_of_nothing()};
        for (int l = 0; l < faces[i].count; l++)
            bat_box_join(&wanted.reached, box_of_sides(&faces[i].loops[l]));
        if (faces[i].has_top)
            wanted.reached.high.z = 1;
        const bat_extent found = extent_of(faces[i].count, faces[i].loops);
        const double low[3] = {wanted.reached.low.x, wanted.reached.low.y,
                               wanted.reached.low.z};
        const double high[3] = {wanted.reached.high.x, wanted.reached.high.y,
                                wanted.reached.high.z};
        check_box(found.reached, low, high, 1e-9);
        check_box(found.within, low, high, 1e-6);
    }
}
