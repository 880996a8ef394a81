/* Surfaces and ribbons seen in one point, and how they differ. */
#include "shape/fill/fill.h"

#include "support/test.h"

/* z = 3 x^2 / 2 + 2 x y - 5 y^2 / 2 over x = u + shear v, y = v, u and v in [0, 1]. */
static batten_surface *quadric(double shear)
{
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const batten_axis axis = {2, 3, knots, false};
    double points[27];
    batten_surface *surface = NULL;
    /* z = A u^2 + B u v + C v^2 has the Bezier points A [i = 2] + B i j / 4 + C [j = 2]. */
    const double A = 1.5, B = 3 * shear + 2, C = 1.5 * shear * shear + 2 * shear - 2.5;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double *p = points + 3 * (3 * i + j);
            p[0] = i / 2.0 + shear * j / 2.0;
            p[1] = j / 2.0;
            p[2] = A * (i == 2) + B * i * j / 4.0 + C * (j == 2);
        }
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

TEST(normal_curvatures_are_those_of_a_quadric_whatever_its_parameters)
{
    static const double shears[] = {0, 0.5, -1.5};
    for (int i = 0; i < COUNT(shears); i++) {
        batten_surface *surface = quadric(shears[i]);
        bat_fill_view s;
        CHECK_OK(bat_fill_see_surface(surface, 0, 0, &s));
        CHECK(s.regular && s.bent && fabs(s.normal[2] - 1) < 1e-15);
        CHECK_NEAR(s.sine, 1 / hypot(1, shears[i]), 1e-14);
        for (int k = 0; k < 8; k++) {
            const double angle = k * 0.4, c = cos(angle), d = sin(angle),
                         direction[] = {c, d, 0};
            CHECK_NEAR(bat_fill_curvature(&s, direction, s.normal),
                       3 * c * c + 4 * c * d - 5 * d * d, 1e-13);
        }
        /* Principal curvatures -1 +- sqrt(16 + 4): the larger one in size is negative. */
        CHECK_NEAR(bat_fill_largest_curvature(&s), 1 + sqrt(20), 1e-13);
        batten_surface_unref(surface);
    }
}

/* A side along x, over [0, 2], z = 1.5 (x - 1)^2 before its middle and 3.5 (x - 1)^2 behind it, with a slope that is askew. */
typedef struct {
    bat_fill_loop loop;
} bench;

static batten_curve *spline(int degree, int count, const double *points, const double *knots)
{
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){3, count, points}, degree, NULL, knots, &curve));
    return curve;
}

static void begin_bench(bench *b)
{
    static const double curve[] = {0, 0, 1.5, 0.5, 0, 0, 1.5, 0, 0, 2, 0, 3.5};
    static const double slope[] = {1, 1, 0, 1, 1, 0, 1.5, 1, 0}, bend[] = {0, 0, 2, 0, 0, 2};
    static const double quadratic[] = {0, 0, 0, 1, 2, 2, 2}, corner[] = {0, 0, 1, 2, 2},
                        whole[] = {0, 0, 2, 2};
    *b = (bench){{.count = 3}};
    b->loop.sides[1] = (bat_fill_side){.curve = spline(2, 4, curve, quadratic),
                                       .slope = spline(1, 3, slope, corner),
                                       .bend = spline(1, 2, bend, whole)};
}

static void end_bench(bench *b)
{
    batten_curve_unref(b->loop.sides[1].curve);
    batten_curve_unref(b->loop.sides[1].slope);
    batten_curve_unref(b->loop.sides[1].bend);
}

TEST(a_ribbon_is_a_surface_along_its_side_seen_from_the_side_that_is_asked_for)
{
    bench b;
    bat_fill_view left, right;
    begin_bench(&b);
    CHECK_OK(bat_fill_see_ribbon(&b.loop.sides[1], 1, BATTEN_FROM_LEFT, &left));
    CHECK_OK(bat_fill_see_ribbon(&b.loop.sides[1], 1, BATTEN_FROM_RIGHT, &right));
    CHECK(left.point[0] == 1 && right.point[0] == 1 && left.u[0] == 1 && right.u[0] == 1);
    CHECK(left.v[1] == 1 && right.v[1] == 1 && left.v[0] == 1);
    CHECK(left.uv[0] == 0 && right.uv[0] == 0.5 && left.vv[2] == 2 && right.vv[2] == 2);
    CHECK(left.regular && left.bent && left.normal[2] == 1);
    CHECK(left.uu[0] == 0 && left.uu[2] == 3 && right.uu[2] == 7);
    CHECK_NEAR(left.sine, sqrt(0.5), 1e-15);
    const bat_fill_side bare = {.curve = b.loop.sides[1].curve, .bend = b.loop.sides[1].bend};
    CHECK_OK(bat_fill_see_ribbon(&bare, 0.5, BATTEN_FROM_LEFT, &left));
    CHECK(!left.regular && !left.bent && left.point[0] > 0 && left.u[0] == 0);
    const bat_fill_side plain = {.curve = bare.curve, .slope = b.loop.sides[1].slope};
    CHECK_OK(bat_fill_see_ribbon(&plain, 0.5, BATTEN_FROM_LEFT, &left));
    CHECK(left.regular && !left.bent && left.vv[2] == 0);
    end_bench(&b);
}

/* A plane (x, y) = `corner` + u `along_u` + v `along_v`. */
static batten_surface *plane(const double corner[2], const double along_u[2],
                             const double along_v[2])
{
    static const double knots[] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    double points[12] = {0};
    batten_surface *surface = NULL;
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 2; c++)
            points[3 * i + c] = corner[c] + i / 2 * along_u[c] + i % 2 * along_v[c];
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

/* Quad 1 has u along the first half of side 1 and is twice as fast across; the next one has v back along its
 * second half: in the middle they lack the bend of 2 and the curvature of their half of the side, 3 or 7, by the square of the speed. */
TEST(what_a_plane_patch_lacks_is_the_curvature_of_its_half_of_the_side)
{
    bench b;
    begin_bench(&b);
    batten_surface *patches[] = {
        plane((const double[]){0, 0}, (const double[]){1, 0}, (const double[]){0.25, 2}),
        plane((const double[]){2, 0}, (const double[]){0.125, 3}, (const double[]){-1, 0})};
    for (int half = 0; half < 2; half++) {
        double lack[3];
        CHECK_OK(bat_fill_lack(&b.loop, 1, half, patches[half], 1, lack));
        CHECK_NEAR(lack[2], half ? 9 * (7 + 2) : 4 * (3 + 2), 1e-12);
        CHECK(lack[0] == 0 && lack[1] == 0);
    }
    for (int i = 0; i < 2; i++) { /* without a bend or a slope nothing is asked for */
        double lack[3] = {1, 1, 1};
        bat_fill_loop less = b.loop;
        *(i ? &less.sides[1].slope : &less.sides[1].bend) = NULL;
        CHECK_OK(bat_fill_lack(&less, 1, 0, patches[0], 1, lack));
        CHECK(lack[0] == 0 && lack[1] == 0 && lack[2] == 0);
    }
    batten_surface_unref(patches[0]);
    batten_surface_unref(patches[1]);
    end_bench(&b);
}

/* A plane beside one that is raised, turned or bent: the largest differences with their places. */
TEST(differences_of_point_normal_and_curvature_are_kept_with_their_places)
{
    batten_fill_edge edge = {0};
    const double along[] = {1, 0, 0};
    bat_fill_view s = {.u = {1, 0, 0},
                       .v = {0, 1, 0},
                       .normal = {0, 0, 1},
                       .regular = true,
                       .bent = true},
                  r = s;
    r.point[2] = 0.25;
    bat_fill_compare(&s, &r, along, &edge);
    CHECK(edge.gap == 0.25 && edge.angle == 0 && edge.curvature == 0);
    CHECK(edge.has_slope && edge.has_curvature);
    s.point[0] = r.point[0] = 5;
    r.point[2] = 0.125;
    r.normal[1] = -sin(0.5);
    r.normal[2] = cos(0.5);
    r.vv[2] = 2; /* its part along the other normal does not count */
    bat_fill_compare(&s, &r, along, &edge);
    CHECK(edge.gap == 0.25 && edge.gap_at[0] == 0 && edge.angle_at[0] == 5);
    CHECK_NEAR(edge.angle, 0.5, 1e-15);
    CHECK_NEAR(edge.curvature, 2, 1e-15);
    CHECK(edge.curvature_at[0] == 5);
    batten_fill_edge bare = {0};
    r.bent = false;
    bat_fill_compare(&s, &r, along, &bare);
    CHECK(bare.has_slope && !bare.has_curvature && bare.curvature == 0 && bare.gap == 0.125);
    r.regular = false;
    batten_fill_edge barest = {0};
    bat_fill_compare(&s, &r, along, &barest);
    CHECK(!barest.has_slope && barest.angle == 0 && barest.gap == 0.125);
}
