#include "body/elementary/elementary.h"
#include "numeric/vector.h"
#include "support/surfaces.h"
#include "support/test.h"
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/standard.h>

static batten_frame tilted(void)
{
    return (batten_frame){{3, -2, 5}, {2. / 3, -1. / 3, 2. / 3}, {1. / 3, -2. / 3, -2. / 3}};
}

static batten_vec3 tilted_y(void)
{
    return bat_vec3_cross(tilted().z, tilted().x);
}

static void put(double x, double y, double z, double *point)
{
    const batten_frame f = tilted();
    const batten_vec3 p =
        bat_vec3_along(bat_vec3_along(bat_vec3_along(f.origin, x, f.x), y, tilted_y()), z, f.z);
    memcpy(point, (const double[3]){p.x, p.y, p.z}, 3 * sizeof *point);
}

static batten_vec3 seen(batten_vec3 way)
{
    return (batten_vec3){bat_vec3_dot(way, tilted().x), bat_vec3_dot(way, tilted_y()),
                         bat_vec3_dot(way, tilted().z)};
}

/* The distance of a point of the frame from the elementary surface, with the normal there. */
static double off(const bat_elementary *e, batten_vec3 p, batten_vec3 *normal)
{
    const double r = hypot(p.x, p.y), c = r > 0 ? p.x / r : 0, s = r > 0 ? p.y / r : 0;
    double across, along, to_axis = 0, depth = 0;
    switch (e->kind) {
    case BAT_PLANE:
        *normal = (batten_vec3){0, 0, 1};
        return p.z;
    case BAT_CYLINDER:
        *normal = (batten_vec3){c, s, 0};
        return r - e->a;
    case BAT_CONE:
        depth = e->a + p.z * tan(e->b);
        across = depth < 0 ? -cos(e->b) : cos(e->b);
        *normal = (batten_vec3){c * cos(e->b), s * cos(e->b), (depth < 0 ? 1 : -1) * sin(e->b)};
        return (r - fabs(depth)) * fabs(across);
    case BAT_SPHERE:
        along = hypot(r, p.z);
        *normal = (batten_vec3){p.x / along, p.y / along, p.z / along};
        return along - e->a;
    case BAT_TORUS:
        to_axis = hypot(r - e->a, p.z) - e->b;
        depth = hypot(r + e->a, p.z) - e->b;
        across = fabs(to_axis) < fabs(depth) ? r - e->a : r + e->a;
        along = fabs(to_axis) < fabs(depth) ? e->b : -e->b; /* the lemon's is inward */
        *normal = (batten_vec3){c * across / along, s * across / along, p.z / along};
        return fabs(to_axis) < fabs(depth) ? to_axis : depth;
    default:
        CHECK(false);
        return 0;
    }
}

/* Every point is on the elementary surface, with its normal. */
static void check_surface(const bat_elementary *e, const batten_surface *surface, double size)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    for (int i = 0; i < 24; i++)
        for (int j = 0; j < 24; j++) {
            const double at[2] = {u.a + (u.b - u.a) * (i + 0.5) / 24,
                                  v.a + (v.b - v.a) * (j + 0.5) / 24};
            double p[3];
            batten_vec3 normal, due = {0, 0, 0};
            CHECK_OK(batten_surface_evaluate(surface, at[0], at[1], 0, p));
            CHECK_OK(batten_surface_normal(surface, at[0], at[1], NULL, &normal));
            const batten_vec3 way = bat_vec3_subtract(bat_vec3_of(3, p), tilted().origin);
            CHECK_NEAR(off(e, seen(way), &due), 0, 1e-13 * size);
            CHECK_NEAR(bat_vec3_dot(seen(normal), due), 1, 1e-10);
        }
}

static batten_surface *reach(const bat_elementary *e, int count, const double *points)
{
    batten_surface *surface = NULL;
    double error = -1;
    CHECK_OK(bat_elementary_surface(e, count, points, 1e-6, &surface, &error));
    CHECK_BITS(error, 0);
    batten_deviation deviation;
    if (count > 0) {
        CHECK_OK(batten_surface_deviation(surface, (batten_points){3, count, points}, NULL,
                                          NULL, NULL, &deviation));
        CHECK_NEAR(deviation.max, 0, 1e-12);
    }
    return surface;
}

TEST(a_plane_reaches_over_its_points)
{
    const bat_elementary e = {.kind = BAT_PLANE, .frame = tilted()};
    double points[9], area, error;
    put(-3, 1, 0, points);
    put(7, 2, 0, points + 3);
    put(0, -4, 0, points + 6);
    batten_surface *surface = reach(&e, 3, points);
    check_surface(&e, surface, 10);
    CHECK_OK(test_surface_area(surface, 1e-12, &area, &error));
    CHECK_NEAR(area, 11 * 7, 1e-9); /* 5 % of 10 more on each side */
    /* Its parameters are the coordinates of the frame. */
    double at[3], due[3];
    CHECK_OK(batten_surface_evaluate(surface, 2, -1, 0, at));
    put(2, -1, 0, due);
    CHECK_NEAR(bat_distance(3, at, due), 0, 1e-14 * 10);
    batten_surface_unref(surface);
    surface = reach(&e, 1, points);
    batten_surface_unref(surface);
}

TEST(a_cylinder_goes_all_around_with_its_normals_away_from_the_axis)
{
    const bat_elementary e = {.kind = BAT_CYLINDER, .frame = tilted(), .a = 2};
    double points[6], area, error;
    put(2, 0, -3, points);
    put(0, -2, 7, points + 3);
    batten_surface *surface = reach(&e, 2, points);
    check_surface(&e, surface, 10);
    CHECK(batten_surface_is_closed(surface, BATTEN_U, 1e-14));
    CHECK_OK(test_surface_area(surface, 1e-12, &area, &error));
    CHECK_NEAR(area, 2 * BAT_PI * 2 * 11, 1e-8);
    batten_surface_unref(surface);
}

/* Points at two heights on a cone, on the half that the heights are on. */
static batten_surface *cone_over(double a, double b, double low, double high)
{
    const bat_elementary e = {.kind = BAT_CONE, .frame = tilted(), .a = a, .b = b};
    double points[6];
    put(a + low * tan(b), 0, low, points);
    put(0, a + high * tan(b), high, points + 3);
    batten_surface *surface = reach(&e, 2, points);
    check_surface(&e, surface, 10);
    return surface;
}

/* The share of the way around the pole at which the edge v = low or high of a surface is one
 * point. */
static double rim_radius(const batten_surface *surface, bool high)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    double p[3], q[3];
    CHECK_OK(batten_surface_evaluate(surface, u.a, high ? v.b : v.a, 0, p));
    CHECK_OK(batten_surface_evaluate(surface, (u.a + u.b) / 2, high ? v.b : v.a, 0, q));
    return bat_distance(3, p, q) / 2;
}

TEST(G5_a_cone_reaches_its_apex_only_when_its_points_do)
{
    const double half = atan(0.5);
    static const struct {
        double a, sign, low, high;
        int pole; /* -1 low, 1 high, 0 none */
    } cases[] = {
        {1, 1, 0, 4, 0},  {1, 1, -2, 4, -1}, {1, -1, -3, 2, 1},    {0, 1, 0, 5, -1},
        {0, 1, -5, 0, 1}, {1, 1, -6, -3, 0}, {1, 1, -1.999, 4, 0}, {2, -1, -1, 3, 0},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        batten_surface *surface =
            cone_over(cases[i].a, cases[i].sign * half, cases[i].low, cases[i].high);
        const double low = rim_radius(surface, false), high = rim_radius(surface, true);
        if (cases[i].pole < 0)
            CHECK_BITS(low, 0);
        else
            CHECK(low > 1e-4);
        if (cases[i].pole > 0)
            CHECK_BITS(high, 0);
        else
            CHECK(high > 1e-4);
        batten_surface_unref(surface);
    }
}

/* A cone whose face goes on beyond its loop ends at the apex, wherever the loop is; it reaches
 * beyond the loop too. */
TEST(G5_a_cone_reaches_its_apex_where_its_face_does)
{
    const double half = atan(0.5);
    for (int up = 0; up < 2; up++) {
        const bat_elementary e = {.kind = BAT_CONE,
                                  .frame = tilted(),
                                  .a = 1,
                                  .b = up ? -half : half,
                                  .goes_on = true};
        double points[6];
        put(0.5, 0, up ? 1 : -1, points);
        put(0, 0.5, up ? 1 : -1, points + 3);
        batten_surface *surface = reach(&e, 2, points);
        check_surface(&e, surface, 10);
        CHECK_BITS(rim_radius(surface, up), 0);
        CHECK(rim_radius(surface, !up) > 0.51);
        batten_surface_unref(surface);
    }
}

TEST(loops_around_a_surface_are_counted)
{
    const double half = atan(0.5);
    static const struct {
        bat_elementary_kind kind;
        bool is_once;
    } cases[] = {{BAT_CONE, true},
                 {BAT_CYLINDER, true},
                 {BAT_EXTRUSION, true},
                 {BAT_SPHERE, false},
                 {BAT_PLANE, false}};
    bat_conic base = {BAT_ELLIPSE, tilted(), 2, 2}, tilt = base;
    batten_curve *circle = NULL, *slanting = NULL, *line = NULL;
    double ends[6];
    /* The section of the cylinder with a plane at 45 degrees, farther up. */
    tilt.frame.origin = bat_vec3_along(base.frame.origin, 5, base.frame.z);
    tilt.frame.x = bat_vec3_scale(bat_vec3_add(base.frame.x, base.frame.z), sqrt(0.5));
    tilt.frame.z = bat_vec3_cross(tilt.frame.x, tilted_y());
    tilt.a = 2 * sqrt(2);
    put(2, 0, -1, ends);
    put(0, 0, 3, ends + 3);
    CHECK_OK(bat_conic_between(&base, 0, 2 * BAT_PI, &circle));
    CHECK_OK(bat_conic_between(&tilt, 1, 1 + 2 * BAT_PI, &slanting));
    CHECK_OK(batten_curve_line(3, ends, ends + 3, &line));
    for (int k = 0; k < COUNT(cases); k++) {
        const bat_elementary e = {.kind = cases[k].kind,
                                  .frame = tilted(),
                                  .a = 2,
                                  .b = half,
                                  .curve = cases[k].kind == BAT_EXTRUSION ? circle : NULL};
        bat_around around;
        CHECK_OK(bat_around_begin(&e, 1e-6, &around));
        CHECK(!bat_around_is_once(&around));
        CHECK_OK(bat_around_add(&around, slanting, true));
        CHECK(bat_around_is_once(&around) == cases[k].is_once);
        CHECK_OK(bat_around_add(&around, circle, false));
        CHECK(!bat_around_is_once(&around));
        CHECK_OK(bat_around_add(&around, circle, false));
        CHECK(bat_around_is_once(&around) == cases[k].is_once);
        CHECK_OK(bat_around_add(&around, line, false)); /* to the axis */
        CHECK(bat_around_is_once(&around) == (cases[k].kind == BAT_EXTRUSION));
    }
    batten_curve_unref(circle);
    batten_curve_unref(slanting);
    batten_curve_unref(line);
}

TEST(points_on_both_halves_of_a_cone_are_refused)
{
    const bat_elementary e = {.kind = BAT_CONE, .frame = tilted(), .a = 1, .b = atan(0.5)};
    double points[6], error;
    batten_surface *surface = NULL;
    put(-1, 0, -4, points);
    put(3, 0, 4, points + 3);
    CHECK_STATUS(bat_elementary_surface(&e, 2, points, 1e-6, &surface, &error),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("from -1 to 3");
}

TEST(spheres_and_tori_are_whole)
{
    const bat_elementary ball = {.kind = BAT_SPHERE, .frame = tilted(), .a = 3};
    const bat_elementary ring = {.kind = BAT_TORUS, .frame = tilted(), .a = 5, .b = 2};
    double area, error;
    batten_surface *surface = reach(&ball, 0, NULL);
    check_surface(&ball, surface, 6);
    CHECK_OK(test_surface_area(surface, 1e-10, &area, &error));
    CHECK_NEAR(area, 4 * BAT_PI * 9, 1e-7);
    batten_surface_unref(surface);
    surface = reach(&ring, 0, NULL);
    check_surface(&ring, surface, 14);
    CHECK_OK(test_surface_area(surface, 1e-10, &area, &error));
    CHECK_NEAR(area, 4 * BAT_PI * BAT_PI * 10, 1e-6);
    batten_surface_unref(surface);
}

/* (a + b cos v) from the axis and b sin v along it, with a < 0: the same points, the other way up. */
TEST(a_torus_of_negative_major_radius_is_the_same_with_its_normal_turned)
{
    const bat_elementary ring = {
        .kind = BAT_TORUS, .frame = batten_frame_world(), .a = 5, .b = 2};
    bat_elementary other = ring;
    other.a = -5;
    batten_surface *surfaces[2] = {reach(&ring, 0, NULL), reach(&other, 0, NULL)};
    double area, error, p[2][3];
    CHECK_OK(test_surface_area(surfaces[1], 1e-10, &area, &error));
    CHECK_NEAR(area, 4 * BAT_PI * BAT_PI * 10, 1e-6);
    for (int k = 0; k < 2; k++) {
        bool is_limit;
        batten_vec3 n;
        CHECK_OK(batten_surface_evaluate(surfaces[k], 0, k ? 2 * BAT_PI - 1 : 1, 0, p[k]));
        CHECK_OK(batten_surface_normal(surfaces[k], 0, k ? 2 * BAT_PI - 1 : 1, &is_limit, &n));
        /* outward from the circle of radius 5, or inward */
        CHECK_NEAR(((p[k][0] - 5) * n.x + p[k][2] * n.z) / 2, k ? -1 : 1, 1e-12);
        batten_surface_unref(surfaces[k]);
    }
}

TEST(a_tube_over_the_axis_of_negative_major_radius_is_its_lemon)
{
    const double a = 1, b = 2, half = acos(a / b);
    const bat_elementary e = {
        .kind = BAT_TORUS, .frame = batten_frame_world(), .a = -a, .b = b};
    batten_surface *surface = reach(&e, 0, NULL);
    double area, error, p[3];
    bool is_limit;
    batten_vec3 n;
    CHECK_OK(test_surface_area(surface, 1e-10, &area, &error));
    CHECK_NEAR(area, 2 * BAT_PI * b * 2 * (b * sin(half) - a * half), 1e-7);
    CHECK_OK(batten_surface_evaluate(surface, 0, 0, 0, p));
    CHECK_OK(batten_surface_normal(surface, 0, 0, &is_limit, &n));
    CHECK_NEAR(p[0], b - a, 1e-12);
    CHECK_NEAR(n.x, 1, 1e-12); /* a + b cos v is positive there */
    batten_surface_unref(surface);
}

/* An apple outside, a lemon inside; areas by Pappus: 2 pi b (half angle * 2 a + 2 b sin). */
TEST(G5_a_tube_over_the_axis_is_cut_there)
{
    const double a = 1, b = 2, turn = acos(-a / b);
    const bat_elementary e = {.kind = BAT_TORUS, .frame = tilted(), .a = a, .b = b};
    double points[6], area, error;
    put(a + b, 0, 0, points);
    put(0, a, b, points + 3);
    batten_surface *surface = reach(&e, 2, points);
    check_surface(&e, surface, 6);
    CHECK_OK(test_surface_area(surface, 1e-10, &area, &error));
    CHECK_NEAR(area, 2 * BAT_PI * b * 2 * (a * turn + b * sin(turn)), 1e-7);
    CHECK_BITS(rim_radius(surface, false), 0);
    CHECK_BITS(rim_radius(surface, true), 0);
    batten_surface_unref(surface);
    const double inner = acos(a / b);
    put(b - a, 0, 0, points);
    put(0, -(b * cos(0.5) - a), b * sin(0.5), points + 3);
    surface = reach(&e, 2, points);
    check_surface(&e, surface, 6);
    CHECK_OK(test_surface_area(surface, 1e-10, &area, &error));
    CHECK_NEAR(area, 2 * BAT_PI * b * 2 * (b * sin(inner) - a * inner), 1e-7);
    batten_surface_unref(surface);
    const bat_elementary horn = {.kind = BAT_TORUS, .frame = tilted(), .a = 2, .b = 2};
    surface = reach(&horn, 0, NULL);
    check_surface(&horn, surface, 6);
    batten_surface_unref(surface);
}

TEST(an_extrusion_runs_along_its_curve_and_then_along_its_direction)
{
    static const double line[2][3] = {{1, 0, 0}, {4, 0, 3}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, line[0], line[1], &curve));
    const bat_elementary e = {.kind = BAT_EXTRUSION, .frame = {.z = {0, 2, 0}}, .curve = curve};
    static const double points[] = {1, -6, 0, 4, 4, 3};
    batten_surface *surface = reach(&e, 2, points);
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    CHECK_NEAR(v.a, -3.25, 1e-14);
    CHECK_NEAR(v.b, 2.25, 1e-14);
    double p[3];
    CHECK_OK(batten_surface_evaluate(surface, 0.5, 1, 0, p));
    CHECK_NEAR(p[0], 2.5, 1e-14);
    CHECK_NEAR(p[1], 2, 1e-14);
    CHECK_NEAR(p[2], 1.5, 1e-14);
    batten_surface_unref(surface);
    /* A curve that rises along the direction. */
    const bat_elementary slanting = {
        .kind = BAT_EXTRUSION, .frame = {.z = {0, 0, 1}}, .curve = curve};
    static const double more[] = {1, 0, -5, 4, 0, 9};
    surface = reach(&slanting, 2, more);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
}

TEST(a_revolution_goes_around_along_u)
{
    static const double line[2][3] = {{2, 0, 0}, {1, 0, 3}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_line(3, line[0], line[1], &curve));
    const bat_elementary e = {
        .kind = BAT_REVOLUTION, .frame = {.z = {0, 0, 1}}, .curve = curve};
    batten_surface *surface = reach(&e, 0, NULL);
    double p[3];
    CHECK_OK(batten_surface_evaluate(surface, BAT_PI / 2, 0.5, 0, p));
    CHECK_NEAR(p[0], 0, 1e-14);
    CHECK_NEAR(p[1], 1.5, 1e-14);
    CHECK_NEAR(p[2], 1.5, 1e-14);
    batten_surface_unref(surface);
    batten_curve_unref(curve);
}

/* The whole circle of a ball about an axis in its plane, begun anywhere; and a circle whose
 * centre is not on the axis: then the points say which part is meant. */
TEST(a_profile_over_the_axis_is_cut_there)
{
    static const double starts[] = {0, 0.7, 1.5707963267948966, 3};
    for (int i = 0; i < COUNT(starts); i++) {
        bat_conic circle = {BAT_ELLIPSE, tilted(), 3, 3};
        circle.frame.z = bat_vec3_scale(tilted_y(), -1);
        batten_curve *curve = NULL;
        CHECK_OK(bat_conic_between(&circle, starts[i], starts[i] + 2 * BAT_PI, &curve));
        const bat_elementary e = {.kind = BAT_REVOLUTION, .frame = tilted(), .curve = curve};
        double points[3], area, error;
        put(0, 3 * cos(0.4), 3 * sin(0.4), points);
        batten_surface *surface = reach(&e, 1, points);
        CHECK_OK(test_surface_area(surface, 1e-9, &area, &error));
        CHECK_NEAR(area, 4 * BAT_PI * 9, 1e-7);
        CHECK_BITS(rim_radius(surface, false), 0);
        CHECK_BITS(rim_radius(surface, true), 0);
        batten_surface_unref(surface);
        batten_curve_unref(curve);
    }
}

TEST(the_points_say_which_side_of_the_axis_a_profile_is)
{
    bat_conic circle = {BAT_ELLIPSE, tilted(), 2, 2};
    circle.frame.z = bat_vec3_scale(tilted_y(), -1);
    circle.frame.origin = bat_vec3_along(circle.frame.origin, 1, circle.frame.x);
    for (int lemon = 0; lemon < 2; lemon++) {
        batten_curve *curve = NULL;
        CHECK_OK(bat_conic_between(&circle, 0, 2 * BAT_PI, &curve));
        const bat_elementary e = {.kind = BAT_REVOLUTION, .frame = tilted(), .curve = curve};
        const double turn = acos(lemon ? 0.5 : -0.5);
        double points[3], area, error;
        put(0, lemon ? 1 : 3, 0, points);
        batten_surface *surface = reach(&e, 1, points);
        CHECK_OK(test_surface_area(surface, 1e-9, &area, &error));
        CHECK_NEAR(area, 8 * BAT_PI * ((lemon ? -1 : 1) * turn + 2 * sin(turn)), 1e-6);
        batten_surface_unref(surface);
        batten_curve_unref(curve);
    }
}

TEST(the_offset_of_a_sphere_is_a_sphere)
{
    const bat_elementary ball = {.kind = BAT_SPHERE, .frame = tilted(), .a = 3};
    const bat_elementary larger = {.kind = BAT_SPHERE, .frame = tilted(), .a = 3.5};
    batten_surface *surface = reach(&ball, 0, NULL), *offset = NULL;
    bat_elementary e = {
        .kind = BAT_OFFSET_SURFACE, .a = 0.5, .surface = surface, .most = 100000};
    double error = -1;
    CHECK_OK(bat_elementary_surface(&e, 0, NULL, 1e-6, &offset, &error));
    CHECK_BITS(error, 0);
    check_surface(&larger, offset, 6);
    batten_surface_unref(offset);
    e.a = 0;
    CHECK_OK(bat_elementary_surface(&e, 0, NULL, 1e-6, &offset, &error));
    CHECK(offset == surface);
    batten_surface_unref(offset);
    batten_surface_unref(surface);
}

/* A trough z = x^2 for x in [-2, 2], whose radius at the bottom is 1/2: its offset by 1 turns
 * over there, but not above x in [1, 1.5]. */
TEST(an_offset_is_made_of_what_is_below_its_points)
{
    static const double knots[2][6] = {{-2, -2, -2, 2, 2, 2}, {0, 0, 1, 1}};
    static const double net[] = {-2, 0, 4, -2, 1, 4, 0, 0, -4, 0, 1, -4, 2, 0, 4, 2, 1, 4};
    const batten_axis u = {2, 3, knots[0], false}, v = {1, 2, knots[1], false};
    batten_surface *surface = NULL, *offset = NULL;
    double points[12], error = -1;
    for (int i = 0; i < 4; i++) {
        const double x = i & 1 ? 1.5 : 1, s = hypot(1, 2 * x);
        points[3 * i] = x - 2 * x / s;
        points[3 * i + 1] = i & 2 ? 1 : 0;
        points[3 * i + 2] = x * x + 1 / s;
    }
    CHECK_OK(batten_surface_create(3, &u, &v, net, NULL, &surface));
    const bat_elementary e = {
        .kind = BAT_OFFSET_SURFACE, .a = 1, .surface = surface, .most = 100000};
    CHECK_STATUS(bat_elementary_surface(&e, 0, NULL, 1e-6, &offset, &error),
                 BATTEN_SINGULAR_HERE);
    CHECK_OK(bat_elementary_surface(&e, 4, points, 1e-6, &offset, &error));
    CHECK(error > 0 && error <= 1e-6);
    batten_deviation deviation;
    CHECK_OK(batten_surface_deviation(offset, (batten_points){3, 4, points}, NULL, NULL, NULL,
                                      &deviation));
    CHECK(deviation.max <= 2e-6);
    batten_surface_unref(offset);
    batten_surface_unref(surface);
}

TEST(N1_what_cannot_be_bounded_or_made_is_refused)
{
    bat_elementary e = {.kind = BAT_CYLINDER, .frame = tilted(), .a = 2};
    batten_surface *surface = NULL;
    double points[3] = {0, 0, NAN}, error;
    CHECK_STATUS(bat_elementary_surface(&e, 0, NULL, 1e-6, &surface, &error),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("cylinder");
    CHECK_STATUS(bat_elementary_surface(&e, 1, points, 1e-6, &surface, &error),
                 BATTEN_NOT_FINITE);
    points[2] = 1;
    e.a = -2;
    CHECK_STATUS(bat_elementary_surface(&e, 1, points, 1e-6, &surface, &error),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("-2");
    e.a = NAN;
    CHECK_STATUS(bat_elementary_surface(&e, 1, points, 1e-6, &surface, &error),
                 BATTEN_NOT_FINITE);
    e = (bat_elementary){.kind = BAT_CONE, .frame = tilted(), .a = 1, .b = 2};
    CHECK_STATUS(bat_elementary_surface(&e, 1, points, 1e-6, &surface, &error),
                 BATTEN_BAD_ARGUMENT);
    e = (bat_elementary){.kind = BAT_SPHERE, .frame = {.x = {1, 0, 0}}, .a = 1};
    CHECK_STATUS(bat_elementary_surface(&e, 0, NULL, 1e-6, &surface, &error),
                 BATTEN_BAD_ARGUMENT);
}
