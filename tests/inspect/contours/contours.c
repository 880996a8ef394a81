#include "inspect/shapes.h"
#include <batten/contours.h>
#include <batten/standard.h>
#include <string.h>

/* The function f of x, y in [-1, 1]^2, of degree 2 in each: an exact biquadratic patch, from
 * f(-1), f(1) and the value c with which a + 2 c + b over 4 is that in the middle. */
static batten_surface *graph(double (*f)(double x, double y), double lift)
{
    double points[3][3][3], values[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            values[i][j] = f(i - 1.0, j - 1.0);
    for (int i = 0; i < 3; i++) /* to Bernstein form along y, then along x */
        values[i][1] = 2 * values[i][1] - 0.5 * (values[i][0] + values[i][2]);
    for (int j = 0; j < 3; j++)
        values[1][j] = 2 * values[1][j] - 0.5 * (values[0][j] + values[2][j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            points[i][j][0] = i - 1;
            points[i][j][1] = j - 1;
            points[i][j][2] = values[i][j] + lift;
        }
    const double knots[6] = {0, 0, 0, 1, 1, 1};
    const batten_axis axis = {2, 3, knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, &points[0][0][0], NULL, &surface));
    return surface;
}

static double bowl(double x, double y)
{
    return x * x + y * y;
}

static double saddle(double x, double y)
{
    return x * y;
}

static double crooked_saddle(double x, double y)
{
    return (x - 0.137) * (y + 0.219);
}

static const batten_surface_field height = {
    BATTEN_FIELD_HEIGHT, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static double length_of(const batten_polyline *line)
{
    double length = 0;
    for (int i = 0; i + 1 < line->count; i++)
        length += distance(line->points + 3 * i, line->points + 3 * i + 3);
    if (line->closed)
        length += distance(line->points, line->points + 3 * (line->count - 1));
    return length;
}

/* Every point has the level, and lies where its parameters say. */
static void check_points(const batten_surface *surface, const batten_surface_field *field,
                         const double *levels, double tolerance, const batten_contours *c)
{
    for (int i = 0; i < c->count; i++) {
        const batten_polyline *line = &c->lines[i].line;
        for (int k = 0; k < line->count; k++) {
            double value, point[3];
            const double *uv = line->parameters + 2 * k;
            CHECK_OK(batten_surface_field_values(surface, field, 1, uv, &value));
            CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], 0, point));
            if (!isnan(value))
                CHECK_NEAR(value, levels[c->lines[i].level], tolerance);
            CHECK(distance(point, line->points + 3 * k) < 1e-12);
        }
    }
}

TEST(contours_of_a_paraboloid_are_circles)
{
    batten_surface *surface = graph(bowl, 0);
    const double levels[] = {0.01, 0.04, 0.2, 0.5, 0.9, 1, 1.3}, tolerance = 1e-5;
    batten_contours c = {0};
    CHECK_OK(batten_surface_contours(surface, &height, (batten_levels){COUNT(levels), levels},
                                     tolerance, NULL, &c));
    check_points(surface, &height, levels, 1e-11, &c);
    CHECK(c.error <= tolerance);
    int found[COUNT(levels)] = {0};
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        const double radius = sqrt(levels[c.lines[i].level]);
        found[c.lines[i].level]++;
        CHECK(line->closed == (levels[c.lines[i].level] < 1.1));
        for (int k = 0; k + 1 < line->count; k++) {
            const double *p = line->points + 3 * k, *q = p + 3;
            CHECK_NEAR(hypot(p[0], p[1]), radius, 1e-10);
            CHECK_NEAR(hypot(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])), radius, tolerance);
        }
        if (line->closed)
            CHECK_NEAR(length_of(line), 2 * PI * radius, 1e-3 * radius);
    }
    for (int i = 0; i < 5; i++)
        CHECK_INT(found[i], 1);
    CHECK_INT(found[6], 4); /* corners of the square cut the circle in four arcs */
    CHECK_INT(c.critical_count, 1);
    CHECK_INT(c.critical[0].kind, BATTEN_CRITICAL_LEAST);
    CHECK_NEAR(c.critical[0].value, 0, 1e-15);
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

TEST(a_small_loop_around_an_extremum_is_found)
{
    batten_surface *surface = graph(bowl, 5);
    const double level = 5 + 1e-10;
    batten_contours c = {0};
    CHECK_OK(
        batten_surface_contours(surface, &height, (batten_levels){1, &level}, 1e-9, NULL, &c));
    CHECK_INT(c.count, 1);
    CHECK(c.lines[0].line.closed);
    CHECK_NEAR(length_of(&c.lines[0].line), 2 * PI * 1e-5, 1e-7);
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

/* Both lines of a saddle, from rim to rim, straight through the crossing. */
static void check_cross(double (*f)(double, double), double x0, double y0)
{
    batten_surface *surface = graph(f, 0);
    const double levels[] = {-0.25, 0, 0.25};
    batten_contours c = {0};
    CHECK_OK(batten_surface_contours(surface, &height, (batten_levels){COUNT(levels), levels},
                                     1e-6, NULL, &c));
    check_points(surface, &height, levels, 1e-11, &c);
    CHECK_INT(c.critical_count, 1);
    CHECK_INT(c.critical[0].kind, BATTEN_CRITICAL_SADDLE);
    CHECK_NEAR(c.critical[0].point.x, x0, 1e-9);
    CHECK_NEAR(c.critical[0].point.y, y0, 1e-9);
    int crossing = 0;
    bool along_x = false, along_y = false;
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        if (c.lines[i].level != 1)
            continue;
        crossing++;
        CHECK(!line->closed);
        CHECK_NEAR(length_of(line), 2, 1e-9);
        along_x |= fabs(line->points[1] - line->points[3 * line->count - 2]) < 1e-9;
        along_y |= fabs(line->points[0] - line->points[3 * line->count - 3]) < 1e-9;
        for (int k = 0; k < line->count; k++) {
            const double *p = line->points + 3 * k;
            CHECK(fabs(p[0] - x0) < 1e-9 || fabs(p[1] - y0) < 1e-9);
        }
    }
    CHECK_INT(crossing, 2);
    CHECK(along_x && along_y);
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

TEST(a_saddle_gives_two_crossing_lines_without_gaps)
{
    check_cross(saddle, 0, 0);
    check_cross(crooked_saddle, 0.137, -0.219);
}

TEST(levels_never_cross)
{
    batten_surface *surface = graph(crooked_saddle, 0);
    double levels[41];
    for (int i = 0; i < 41; i++)
        levels[i] = (i - 20) * 0.05;
    batten_contours c = {0};
    CHECK_OK(
        batten_surface_contours(surface, &height, (batten_levels){41, levels}, 1e-5, NULL, &c));
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        for (int k = 0; k + 1 < line->count; k++)
            for (int s = 0; s <= 8; s++) { /* on the chord, in the plane of x and y */
                const double *p = line->points + 3 * k, t = s / 8.0;
                const double value =
                    crooked_saddle(p[0] + t * (p[3] - p[0]), p[1] + t * (p[4] - p[1]));
                CHECK(fabs(value - levels[c.lines[i].level]) < 1e-4);
            }
    }
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

TEST(parallels_and_meridians_of_a_sphere_cross_its_seam_and_poles)
{
    batten_surface *sphere = NULL;
    CHECK_OK(shape_torus(0, 2, true, &sphere));
    const double levels[] = {-1.9, -1.2, 0, 0.7, 1.99};
    const batten_vec3 directions[] = {{0, 0, 1}, {1, 0, 0}, {0, 2, 0}, {0.6, 0, 0.8}};
    for (int d = 0; d < COUNT(directions); d++) {
        const batten_surface_field field = {
            BATTEN_FIELD_HEIGHT, directions[d], {0, 0, 0}, {0, 0, 0}};
        batten_contours c = {0};
        CHECK_OK(batten_surface_contours(sphere, &field, (batten_levels){COUNT(levels), levels},
                                         1e-5, NULL, &c));
        check_points(sphere, &field, levels, 1e-10, &c);
        CHECK_INT(c.count, COUNT(levels));
        for (int i = 0; i < c.count; i++) {
            CHECK(c.lines[i].line.closed);
            const double radius = sqrt(4 - levels[i] * levels[i]);
            CHECK_NEAR(length_of(&c.lines[i].line), 2 * PI * radius, 1e-3 * radius);
        }
        batten_contours_release(&c);
    }
    batten_surface_unref(sphere);
}

TEST(the_silhouette_of_a_sphere_is_a_great_circle)
{
    batten_surface *sphere = NULL;
    CHECK_OK(shape_torus(0, 2, true, &sphere));
    const batten_surface_field fields[] = {
        {BATTEN_FIELD_ISOPHOTE, {1, 2, 2}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {4, 0, 0}, {0, 0, 0}}};
    const double radii[] = {2, sqrt(3)}, zero = 0;
    for (int i = 0; i < COUNT(fields); i++) {
        batten_contours c = {0};
        CHECK_OK(batten_surface_contours(sphere, &fields[i], (batten_levels){1, &zero}, 1e-5,
                                         NULL, &c));
        check_points(sphere, &fields[i], &zero, 1e-10, &c);
        CHECK_INT(c.count, 1);
        CHECK(c.lines[0].line.closed);
        CHECK_NEAR(length_of(&c.lines[0].line), 2 * PI * radii[i], 1e-3);
        batten_contours_release(&c);
    }
    batten_surface_unref(sphere);
}

TEST(lines_of_equal_gaussian_curvature_on_a_torus_are_circles)
{
    /* K = cos v / (r (R + r cos v)) */
    const double R = 3, r = 1, angles[] = {2.5, 1.5, 0.5};
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(R, r, false, &torus));
    double levels[3];
    for (int i = 0; i < 3; i++)
        levels[i] = cos(angles[i]) / (r * (R + r * cos(angles[i])));
    const batten_surface_field field = {BATTEN_FIELD_GAUSSIAN, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    batten_contours c = {0};
    CHECK_OK(
        batten_surface_contours(torus, &field, (batten_levels){3, levels}, 1e-4, NULL, &c));
    check_points(torus, &field, levels, 1e-10, &c);
    CHECK_INT(c.count, 6);
    for (int i = 0; i < c.count; i++) {
        CHECK(c.lines[i].line.closed);
        for (int k = 0; k < c.lines[i].line.count; k++) {
            const double *p = c.lines[i].line.points + 3 * k;
            CHECK_NEAR(hypot(p[0], p[1]), R + r * cos(angles[c.lines[i].level]), 1e-8);
        }
    }
    batten_contours_release(&c);
    batten_surface_unref(torus);
}

TEST(fields_have_their_known_values)
{
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    const batten_surface_field fields[] = {
        {BATTEN_FIELD_HEIGHT, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_GAUSSIAN, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_MEAN, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_KAPPA1, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_KAPPA2, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_ISOPHOTE, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}},
        {BATTEN_FIELD_DRAFT, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        /* the normal lines of x = 4, y = z = 0: the x-axis; light 2 above it, along y */
        {BATTEN_FIELD_HIGHLIGHT, {0, 1, 0}, {0, 0, 2}, {0, 0, 0}},
        {BATTEN_FIELD_REFLECTION, {0, 1, 0}, {0, 0, 2}, {1, 0, 0}},
        {BATTEN_FIELD_SILHOUETTE, {0, 0, 0}, {9, 0, 0}, {0, 0, 0}}};
    const double at_outside[] = {4, 0.25, -0.625, -0.25, -1, 0, PI / 2, 2, 2, 1};
    const double uv[2] = {0, 0}; /* the point (4, 0, 0), n outwards */
    for (int i = 0; i < COUNT(fields); i++) {
        double value;
        CHECK_OK(batten_surface_field_values(torus, &fields[i], 1, uv, &value));
        const bool sign_is_free = fields[i].kind == BATTEN_FIELD_HIGHLIGHT ||
                                  fields[i].kind == BATTEN_FIELD_REFLECTION;
        CHECK_NEAR(sign_is_free ? fabs(value) : value, at_outside[i], 1e-7);
    }
    batten_surface_unref(torus);
}

/* The graph of x^2 + y^2 over a triangle with these corners: its blossom is p q. */
static void paraboloid(const double *corners, double *points)
{
    static const int pairs[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};
    for (int i = 0; i < 6; i++) {
        const double *p = corners + 2 * pairs[i][0], *q = corners + 2 * pairs[i][1];
        points[3 * i] = 0.5 * (p[0] + q[0]);
        points[3 * i + 1] = 0.5 * (p[1] + q[1]);
        points[3 * i + 2] = p[0] * q[0] + p[1] * q[1];
    }
}

/* Circles at heights around the z axis: one closed line each, on the level and at the radius
 * that belongs to it, and as long as a circle. */
static void check_circles(const batten_triangles *triangles, batten_levels levels,
                          double (*radius)(double z), double tolerance)
{
    const batten_surface_field height_of = {
        BATTEN_FIELD_HEIGHT, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    batten_contours c = {0};
    CHECK_OK(batten_triangles_contours(triangles, &height_of, levels, tolerance, NULL, &c));
    CHECK_INT(c.count, levels.count);
    CHECK(c.error <= tolerance);
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        const double z = levels.at[c.lines[i].level], r = radius(z);
        CHECK(line->closed);
        CHECK_NEAR(length_of(line), 2 * PI * r, 1e-3 * r);
        for (int k = 0; k < line->count; k++) {
            const double *p = line->points + 3 * k;
            CHECK_NEAR(p[2], z, 1e-9);
            CHECK_NEAR(hypot(p[0], p[1]), r, 1e-9);
        }
    }
    batten_contours_release(&c);
}

static double radius_of_paraboloid(double z)
{
    return sqrt(4 * z);
}

static double radius_of_sphere(double z)
{
    return sqrt(1 - z * z);
}

static double radius_of_cone(double z)
{
    return 1 - z / 2;
}

static double radius_of_ellipsoid(double z)
{
    return 0.8 * sqrt(1 - z * z / 0.49);
}

TEST(contours_of_rational_triangles_around_poles_are_circles)
{
    const double levels[] = {0.0625, 0.125, 0.2495};
    const batten_frame world = batten_frame_world();
    batten_surface *surfaces[4] = {NULL};
    CHECK_OK(batten_surface_paraboloid(&world, 1, 1, 0.25, &surfaces[0]));
    CHECK_OK(batten_surface_sphere(&world, 1, &surfaces[1]));
    CHECK_OK(batten_surface_cone(&world, 1, 0, 2, &surfaces[2]));
    CHECK_OK(batten_surface_ellipsoid(&world, 0.8, 0.8, 0.7, &surfaces[3]));
    double (*const radii[])(double) = {radius_of_paraboloid, radius_of_sphere, radius_of_cone,
                                       radius_of_ellipsoid};
    for (int i = 0; i < COUNT(surfaces); i++) {
        batten_triangles *triangles = NULL;
        CHECK_OK(batten_triangles_from_surface(surfaces[i], &triangles));
        check_circles(triangles, (batten_levels){COUNT(levels), levels}, radii[i], 1e-4);
        check_circles(triangles, (batten_levels){COUNT(levels), levels}, radii[i], 1e-6);
        batten_triangles_unref(triangles);
        batten_surface_unref(surfaces[i]);
    }
}

TEST(edges_of_triangles_with_the_same_ends_are_not_the_same_edge)
{
    /* A tube of two cubics: its edges in front and behind have the same two corners. */
    static const double around[7][2] = {{1, 0},     {1, 1.4},  {-1, 1.4}, {-1, 0},
                                        {-1, -1.4}, {1, -1.4}, {1, 0}};
    static const double knots[11] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    static const double along[4] = {0, 0, 1, 1};
    double points[7][2][3];
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 2; j++) {
            points[i][j][0] = around[i][0];
            points[i][j][1] = around[i][1];
            points[i][j][2] = j;
        }
    batten_surface *tube = NULL;
    batten_triangles *triangles = NULL;
    CHECK_OK(batten_surface_create(3, &(batten_axis){3, 7, knots, false},
                                   &(batten_axis){1, 2, along, false}, &points[0][0][0], NULL,
                                   &tube));
    CHECK_OK(batten_triangles_from_surface(tube, &triangles));
    const batten_surface_field across = {BATTEN_FIELD_HEIGHT, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}};
    const double levels[] = {-0.5, 0.3, 1};
    batten_contours c = {0};
    CHECK_OK(batten_triangles_contours(triangles, &across, (batten_levels){3, levels}, 1e-5,
                                       NULL, &c));
    CHECK_INT(c.count, 6);
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        CHECK_NEAR(length_of(line), 1, 1e-9);
        for (int k = 0; k < line->count; k++)
            CHECK_NEAR(line->points[3 * k + 1], levels[c.lines[i].level], 1e-9);
    }
    batten_contours_release(&c);
    batten_triangles_unref(triangles);
    batten_surface_unref(tube);
}

TEST(contours_go_on_from_triangle_to_triangle)
{
    /* four triangles around a point beside the lowest one */
    static const double corners[4][6] = {{0.1, 0.2, -1, -1, 1, -1},
                                         {0.1, 0.2, 1, -1, 1, 1},
                                         {0.1, 0.2, 1, 1, -1, 1},
                                         {0.1, 0.2, -1, 1, -1, -1}};
    const double levels[] = {0.003, 0.05, 0.4, 0.95};
    double points[4 * 18];
    for (int i = 0; i < 4; i++)
        paraboloid(corners[i], points + 18 * i);
    batten_triangles *triangles = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 2, 4, points, NULL, NULL},
                                     &triangles));
    batten_contours c = {0};
    CHECK_OK(batten_triangles_contours(triangles, &height, (batten_levels){4, levels}, 1e-5,
                                       NULL, &c));
    CHECK_INT(c.count, 4);
    for (int i = 0; i < c.count; i++) {
        const batten_polyline *line = &c.lines[i].line;
        CHECK(line->closed);
        CHECK_NEAR(length_of(line), 2 * PI * sqrt(levels[i]), 1e-3);
        for (int k = 0; k < line->count; k++)
            CHECK_NEAR(hypot(line->points[3 * k], line->points[3 * k + 1]), sqrt(levels[i]),
                       1e-9);
    }
    CHECK_INT(c.critical_count, 1);
    CHECK_INT(c.critical[0].kind, BATTEN_CRITICAL_LEAST);
    batten_contours_release(&c);
    batten_triangles_unref(triangles);
}

/* How far the cubics of a smooth contour leave the line f = level at z = level. */
static double off_cubics(const batten_contour *c, double (*f)(double x, double y), double level)
{
    double worst = 0;
    const int n = c->line.count;
    for (int i = 0; i + 1 < n + c->line.closed; i++) {
        const double *b[4] = {c->line.points + 3 * i, c->arms + 6 * i + 3,
                              c->arms + 6 * ((i + 1) % n), c->line.points + 3 * ((i + 1) % n)};
        for (int k = 0; k <= 20; k++) {
            const double s = k / 20.0, r = 1 - s, h = 1e-6;
            const double w[4] = {r * r * r, 3 * r * r * s, 3 * r * s * s, s * s * s};
            double p[3] = {0, 0, 0};
            for (int j = 0; j < 12; j++)
                p[j % 3] += w[j / 3] * b[j / 3][j % 3];
            const double fx = (f(p[0] + h, p[1]) - f(p[0] - h, p[1])) / (2 * h);
            const double fy = (f(p[0], p[1] + h) - f(p[0], p[1] - h)) / (2 * h);
            worst = fmax(worst, hypot((f(p[0], p[1]) - level) / hypot(fx, fy), p[2] - level));
        }
    }
    return worst;
}

TEST(smooth_contours_keep_small_tolerances_with_few_cubics)
{
    double (*const graphs[])(double, double) = {bowl, crooked_saddle};
    static const double tolerances[] = {1e-4, 1e-7, 1e-10}, level = 0.3;
    for (int i = 0; i < 6; i++) {
        batten_surface *surface = graph(graphs[i / 3], 0);
        batten_contours c = {0};
        CHECK_OK(batten_surface_smooth_contours(surface, &height, (batten_levels){1, &level},
                                                tolerances[i % 3], NULL, &c));
        CHECK(c.count > 0 && c.error <= tolerances[i % 3]);
        for (int k = 0; k < c.count; k++) {
            CHECK(off_cubics(&c.lines[k], graphs[i / 3], level) <= tolerances[i % 3]);
            CHECK(c.lines[k].line.count < 1000);
        }
        batten_contours_release(&c);
        batten_surface_unref(surface);
    }
}

TEST(smooth_contours_run_straight_through_a_saddle)
{
    batten_surface *surface = graph(crooked_saddle, 0);
    batten_contours c = {0};
    const double zero = 0;
    CHECK_OK(batten_surface_smooth_contours(surface, &height, (batten_levels){1, &zero}, 1e-9,
                                            NULL, &c));
    CHECK_INT(c.count, 2);
    for (int k = 0; k < c.count; k++)
        for (int i = 0; i < 3 * c.lines[k].line.count; i += 3) {
            const double *p = c.lines[k].line.points + i, *arm = c.lines[k].arms + 2 * i;
            CHECK_NEAR((p[0] - 0.137) * (p[1] + 0.219), 0, 1e-9);
            CHECK_NEAR((arm[0] - 0.137) * (arm[1] + 0.219), 0, 1e-9);
            CHECK_NEAR((arm[3] - 0.137) * (arm[4] + 0.219), 0, 1e-9);
            CHECK_NEAR(arm[2], 0, 1e-9);
            CHECK_NEAR(arm[5], 0, 1e-9);
        }
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

static bool stop(void *user)
{
    return ++*(int *)user > 3;
}

static double wave(double x, double y)
{
    return 0.3 * x * x * y + 0.2 * y * y - 0.4 * x * y * y;
}

TEST(contours_that_end_where_a_field_has_no_value_are_finished)
{
    /* lines of light that run along reflected rays: the field ends inside the surface */
    const batten_surface_field field = {
        BATTEN_FIELD_REFLECTION, {1, 0, 0}, {0, 0, 3}, {0, 0, 1}};
    batten_surface *surface = graph(wave, 0);
    double levels[61];
    for (int i = 0; i <= 60; i++)
        levels[i] = -6 + 0.2 * i;
    for (int i = 0; i < 4; i++) {
        batten_contours c = {0};
        long count = 0;
        CHECK_OK((i % 2 ? batten_surface_smooth_contours : batten_surface_contours)(
            surface, &field, (batten_levels){COUNT(levels), levels}, i < 2 ? 1e-5 : 1e-6, NULL,
            &c));
        for (int k = 0; k < c.count; k++)
            count += c.lines[k].line.count;
        CHECK(count > 100 && count < (i % 2 ? 20000 : 300000));
        batten_contours_release(&c);
    }
    batten_surface_unref(surface);
}

TEST(N6_contours_refuse_tolerances_that_would_take_for_ever)
{
    batten_surface *torus = NULL;
    batten_contours c = {0};
    const batten_frame world = batten_frame_world();
    double levels[100];
    int asked = 0;
    for (int i = 0; i < COUNT(levels); i++)
        levels[i] = 0.009 * i;
    CHECK_OK(batten_surface_torus(&world, 3, 1, &torus));
    CHECK_STATUS(batten_surface_contours(torus, &height, (batten_levels){1, levels + 30}, 1e-15,
                                         NULL, &c),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("contours cannot be within 1e-15");
    CHECK_STATUS(batten_surface_smooth_contours(torus, &height, (batten_levels){1, levels + 30},
                                                1e-11, NULL, &c),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_STATUS(
        batten_surface_contours(torus, &height, (batten_levels){100, levels}, 1e-9, NULL, &c),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("points; the limit is 1000000");
    batten_job job = BATTEN_JOB;
    job.is_cancelled = stop;
    job.user = &asked;
    CHECK_STATUS(batten_surface_contours(torus, &height, (batten_levels){1, levels + 30}, 1e-8,
                                         &job, &c),
                 BATTEN_CANCELLED);
    CHECK(c.lines == NULL);
    batten_surface_unref(torus);
}

TEST(bad_fields_and_levels_are_refused)
{
    batten_surface *surface = graph(bowl, 0);
    const batten_surface_field nowhere = {
        BATTEN_FIELD_ISOPHOTE, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const double good[] = {0.5}, falling[] = {0.5, 0.5}, infinite[] = {(double)INFINITY};
    batten_contours c = {0};
    CHECK_STATUS(
        batten_surface_contours(surface, &nowhere, (batten_levels){1, good}, 1e-3, NULL, &c),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("points nowhere");
    CHECK_STATUS(
        batten_surface_contours(surface, &height, (batten_levels){2, falling}, 1e-3, NULL, &c),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("level 2 is 0.5, not above the one before, 0.5");
    CHECK_STATUS(
        batten_surface_contours(surface, &height, (batten_levels){1, infinite}, 1e-3, NULL, &c),
        BATTEN_NOT_FINITE);
    CHECK_MESSAGE("level 1 is inf");
    CHECK_STATUS(
        batten_surface_contours(surface, &height, (batten_levels){1, good}, 0, NULL, &c),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("tolerance of contours is 0");
    CHECK(c.lines == NULL);
    batten_surface_unref(surface);
}

TEST(surfaces_in_the_plane_have_no_fields)
{
    const double knots[4] = {0, 0, 1, 1}, points[8] = {0, 0, 0, 1, 1, 0, 1, 1},
                 uv[2] = {0.5, 0.5};
    const double level[] = {0.5};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *flat = NULL;
    batten_contours c = {0};
    double value = 7;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &flat));
    CHECK_STATUS(
        batten_surface_contours(flat, &height, (batten_levels){1, level}, 1e-3, NULL, &c),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("a surface in 2 dimensions has no fields: it must be in space");
    CHECK_STATUS(batten_surface_field_values(flat, &height, 1, uv, &value),
                 BATTEN_NOT_COMPATIBLE);
    CHECK(value == 7 && c.lines == NULL);
    batten_surface_unref(flat);
}

/* The share of the work that is done, at each stage: nets, points where the field stands still, crossings, lines. */
typedef struct {
    int nets, crossings, lines, others;
} stages;

static void note_stage(void *user, double fraction, const char *what)
{
    stages *s = user;
    CHECK_TEXT(what, "contours");
    s->nets += fraction == 0;
    s->crossings += fraction == 0.3;
    s->lines += fraction == 0.5;
    s->others += !(fraction >= 0 && fraction <= 1);
}

TEST(contours_say_how_far_they_are_at_each_stage)
{
    batten_surface *surface = graph(bowl, 0);
    static const double level = 0.3;
    stages seen = {0, 0, 0, 0};
    batten_job job = BATTEN_JOB;
    batten_contours c = {0};
    job.progress = note_stage;
    job.user = &seen;
    CHECK_OK(
        batten_surface_contours(surface, &height, (batten_levels){1, &level}, 1e-7, &job, &c));
    CHECK(seen.nets > 0 && seen.crossings > 0 && seen.lines > 0);
    CHECK_INT(seen.others, 0);
    batten_contours_release(&c);
    batten_surface_unref(surface);
}

TEST(smooth_contours_of_triangles_are_those_of_their_surface)
{
    static const double corners[2][6] = {{-1, -1, 1, -1, 1, 1}, {-1, -1, 1, 1, -1, 1}};
    static const double level = 0.3;
    double points[2 * 18];
    batten_triangles *triangles = NULL;
    batten_contours c = {0};
    for (int i = 0; i < 2; i++)
        paraboloid(corners[i], points + 18 * i);
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 2, 2, points, NULL, NULL},
                                     &triangles));
    CHECK_OK(batten_triangles_smooth_contours(triangles, &height, (batten_levels){1, &level},
                                              1e-7, NULL, &c));
    CHECK_INT(c.count, 1);
    CHECK(c.lines[0].line.closed && c.lines[0].arms && c.error <= 1e-7);
    CHECK(off_cubics(&c.lines[0], bowl, level) < 2e-7);
    batten_contours_release(&c);
    batten_triangles_unref(triangles);
}

TEST(triangles_in_the_plane_have_no_fields)
{
    static const double points[6] = {0, 0, 1, 0, 0, 1}, level = 0.3;
    batten_triangles *triangles = NULL;
    batten_contours c = {0};
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){2, 1, 1, points, NULL, NULL},
                                     &triangles));
    CHECK_STATUS(batten_triangles_contours(triangles, &height, (batten_levels){1, &level}, 1e-5,
                                           NULL, &c),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("triangles in 2 dimensions have no fields: they must be in space");
    batten_triangles_unref(triangles);
}
