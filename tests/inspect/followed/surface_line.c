/* Lines of curvature, asymptotic lines and geodesics of shapes on which they are known. */
#include "inspect/shapes.h"

#include <batten/nearest.h>
#include <batten/standard.h>

static const double tolerance = 1e-6;

static batten_surface_line line_from(const batten_surface *surface, batten_line_kind kind,
                                     double u, double v, batten_vec3 direction, double length)
{
    batten_surface_line line = {.length = NAN};
    const batten_line_start start = {kind, u, v, direction, length};
    CHECK_OK(batten_surface_line_from(surface, &start, tolerance, NULL, &line));
    CHECK(line.error <= tolerance);
    CHECK(line.line.count >= 2);
    return line;
}

static batten_vec3 point_of(const batten_surface_line *line, int i)
{
    const double *p = line->line.points + 3 * i;
    return (batten_vec3){p[0], p[1], p[2]};
}

/* The middle of cubic i. */
static batten_vec3 middle_of(const batten_surface_line *line, int i)
{
    const int next = (i + 1) % line->line.count;
    const double *p = line->line.points + 3 * i, *q = line->line.points + 3 * next;
    const double *a = line->arms + 6 * i + 3, *b = line->arms + 6 * next;
    return (batten_vec3){(p[0] + 3 * a[0] + 3 * b[0] + q[0]) / 8,
                         (p[1] + 3 * a[1] + 3 * b[1] + q[1]) / 8,
                         (p[2] + 3 * a[2] + 3 * b[2] + q[2]) / 8};
}

/* Parameters lie where the points are. */
static void check_on_surface(const batten_surface *surface, const batten_surface_line *line)
{
    for (int i = 0; i < line->line.count; i++) {
        double p[3];
        const double *uv = line->line.parameters + 2 * i, *at = line->line.points + 3 * i;
        CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], 0, p));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(p[k], at[k], 1e-12);
    }
}

static batten_surface *cylinder(double radius, double height)
{
    const batten_frame world = batten_frame_world();
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_cylinder(&world, radius, height, &out));
    return out;
}

/* It rises by sin 30 degrees of its length, and turns as it goes; its end is on the rim to rounding. */
TEST(a_geodesic_of_a_cylinder_is_a_helix_that_ends_at_the_rim)
{
    const double r = 2, rise = 0.5, around = sqrt(0.75);
    batten_surface *tube = cylinder(r, 10);
    const batten_interval u = batten_surface_domain(tube, BATTEN_U),
                          v = batten_surface_domain(tube, BATTEN_V);
    const bool is_around = batten_surface_is_closed(tube, BATTEN_U, 1e-9);
    double p[3];
    CHECK(is_around);
    CHECK_OK(batten_surface_evaluate(tube, u.a, v.a, 0, p));
    batten_surface_line line = line_from(tube, BATTEN_LINE_GEODESIC, u.a, v.a,
                                         (batten_vec3){0, 3 * around, 3 * rise}, 0);
    CHECK_NEAR(line.length, 10 / rise, tolerance);
    CHECK(line.ends[0] == BATTEN_LINE_AT_LENGTH && line.ends[1] == BATTEN_LINE_AT_RIM);
    CHECK(!line.line.closed);
    for (int i = 0; i < line.line.count; i++) {
        const batten_vec3 at = point_of(&line, i), half = middle_of(&line, i);
        const double s = (at.z - p[2]) / rise, t = (half.z - p[2]) / rise;
        CHECK_NEAR(at.x, r * cos(s * around / r), tolerance);
        CHECK_NEAR(at.y, r * sin(s * around / r), tolerance);
        if (i + 1 < line.line.count) {
            CHECK_NEAR(half.x, r * cos(t * around / r), tolerance);
            CHECK_NEAR(half.y, r * sin(t * around / r), tolerance);
        }
    }
    CHECK_NEAR(point_of(&line, line.line.count - 1).z, p[2] + 10, 1e-12);
    check_on_surface(tube, &line);
    batten_surface_line_release(&line);
    CHECK(line.line.points == NULL);
    batten_surface_unref(tube);
}

TEST(a_geodesic_of_a_sphere_is_a_great_circle_that_closes)
{
    const batten_frame world = batten_frame_world();
    batten_surface *ball = NULL;
    CHECK_OK(batten_surface_sphere(&world, 3, &ball));
    const batten_interval u = batten_surface_domain(ball, BATTEN_U),
                          v = batten_surface_domain(ball, BATTEN_V);
    batten_surface_line line = line_from(ball, BATTEN_LINE_GEODESIC, u.a + 0.1 * (u.b - u.a),
                                         (v.a + v.b) / 2, (batten_vec3){-0.3, 0.4, 0.5}, 0);
    CHECK_NEAR(line.length, 6 * PI, 10 * tolerance);
    CHECK(line.line.closed);
    CHECK(line.ends[0] == BATTEN_LINE_CLOSED && line.ends[1] == BATTEN_LINE_CLOSED);
    const batten_vec3 a = point_of(&line, 0), b = point_of(&line, line.line.count / 4);
    const batten_vec3 n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    for (int i = 0; i < line.line.count; i++) {
        const batten_vec3 at = middle_of(&line, i);
        CHECK_NEAR((n.x * at.x + n.y * at.y + n.z * at.z) / vec3_size(n), 0, 4 * tolerance);
        CHECK_NEAR(vec3_size(at), 3, tolerance);
    }
    batten_surface_line_release(&line);
    const batten_surface_line stub =
        line_from(ball, BATTEN_LINE_GEODESIC, u.a, v.a + 0.4 * (v.b - v.a),
                  (batten_vec3){0, 1, 0.2}, 1.25);
    CHECK_NEAR(stub.length, 1.25, 1e-12);
    CHECK_INT(stub.ends[1], BATTEN_LINE_AT_LENGTH);
    line = stub;
    batten_surface_line_release(&line);
    batten_surface_unref(ball);
}

/* The circles around the tube and around the axis. */
TEST(lines_of_curvature_of_a_torus_are_its_circles)
{
    const double R = 3, r = 1;
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(R, r, false, &torus));
    const double u = 0.2, v = 0.3;
    double p[3];
    CHECK_OK(batten_surface_evaluate(torus, u, v, 0, p));
    int around = 0;
    for (int k = 0; k < 2; k++) {
        batten_surface_line line =
            line_from(torus, k ? BATTEN_LINE_CURVATURE2 : BATTEN_LINE_CURVATURE1, u, v,
                      (batten_vec3){0, 0, 0}, 0);
        const bool is_level = fabs(middle_of(&line, 1).z - p[2]) < tolerance;
        around += is_level;
        CHECK(line.line.closed);
        CHECK_NEAR(line.length, 2 * PI * (is_level ? hypot(p[0], p[1]) : r), 10 * tolerance);
        for (int i = 0; i < line.line.count; i++) {
            const batten_vec3 at = middle_of(&line, i);
            if (is_level)
                CHECK_NEAR(at.z, p[2], tolerance);
            else
                CHECK_NEAR(at.x * p[1] - at.y * p[0], 0, 10 * tolerance);
        }
        batten_surface_line_release(&line);
    }
    CHECK_INT(around, 1);
    batten_surface_unref(torus);
}

/* Clairaut: the distance from the axis times the cosine of the angle with the parallel is constant. */
TEST(geodesics_of_a_torus_keep_the_constant_of_clairaut)
{
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    batten_surface_line line =
        line_from(torus, BATTEN_LINE_GEODESIC, 0.1, 0.2, (batten_vec3){0.2, 0.3, 0.4}, 30);
    double first = NAN;
    for (int i = 0; i + 1 < line.line.count; i++) {
        const batten_vec3 p = point_of(&line, i);
        const double *arm = line.arms + 6 * i + 3;
        const batten_vec3 t = {arm[0] - p.x, arm[1] - p.y, arm[2] - p.z};
        const double clairaut = (p.x * t.y - p.y * t.x) / vec3_size(t);
        if (i == 0)
            first = clairaut;
        CHECK_NEAR(clairaut, first, 3 * tolerance);
    }
    batten_surface_line_release(&line);
    batten_surface_unref(torus);
}

/* Its rulings and its helices. */
TEST(asymptotic_lines_of_a_helicoid_are_rulings_and_helices)
{
    const double c = 1.25, u = 0.4, v = 0.7;
    batten_surface *helicoid = NULL;
    int rulings = 0;
    CHECK_OK(shape_minimal(c, -1, 2, &helicoid));
    for (int k = 0; k < 2; k++) {
        batten_surface_line line =
            line_from(helicoid, k ? BATTEN_LINE_ASYMPTOTIC2 : BATTEN_LINE_ASYMPTOTIC1, u, v,
                      (batten_vec3){0, 0, 0}, 0);
        const bool is_ruling = fabs(point_of(&line, 0).z - c * u) < tolerance;
        rulings += is_ruling;
        CHECK(line.ends[0] == BATTEN_LINE_AT_RIM && line.ends[1] == BATTEN_LINE_AT_RIM);
        CHECK_NEAR(line.length, is_ruling ? 3 : hypot(c, v), tolerance);
        for (int i = 0; i < line.line.count; i++) {
            const double *uv = line.line.parameters + 2 * i;
            CHECK_NEAR(is_ruling ? uv[0] : uv[1], is_ruling ? u : v, tolerance);
        }
        batten_surface_line_release(&line);
    }
    CHECK_INT(rulings, 1);
    batten_surface_unref(helicoid);
}

/* One of the two confocal quadrics through a point is the same all along: l in x^2/(a^2 + l) + ... = 1 besides 0. */
static void confocal_of(batten_vec3 p, double l[2])
{
    const double a = 9, b = 4, c = 1, x = p.x * p.x, y = p.y * p.y, z = p.z * p.z;
    const double sum = x + y + z - a - b - c;
    const double product = a * b + b * c + c * a - x * (b + c) - y * (a + c) - z * (a + b);
    const double root = sqrt(fmax(sum * sum / 4 - product, 0));
    l[0] = sum / 2 - root;
    l[1] = sum / 2 + root;
}

static batten_surface *ellipsoid(void)
{
    const batten_frame world = batten_frame_world();
    batten_surface *out = NULL;
    CHECK_OK(batten_surface_ellipsoid(&world, 3, 2, 1, &out));
    return out;
}

TEST(lines_of_curvature_of_an_ellipsoid_lie_on_confocal_quadrics)
{
    batten_surface *egg = ellipsoid();
    const batten_interval u = batten_surface_domain(egg, BATTEN_U),
                          v = batten_surface_domain(egg, BATTEN_V);
    int found[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        batten_surface_line line = line_from(
            egg, k ? BATTEN_LINE_CURVATURE2 : BATTEN_LINE_CURVATURE1, u.a + 0.15 * (u.b - u.a),
            v.a + 0.6 * (v.b - v.a), (batten_vec3){0, 0, 0}, 0);
        double first[2], l[2];
        CHECK(line.line.closed);
        confocal_of(point_of(&line, 0), first);
        confocal_of(point_of(&line, 3), l);
        const int same = fabs(l[0] - first[0]) < fabs(l[1] - first[1]) ? 0 : 1;
        found[same]++;
        for (int i = 0; i < line.line.count; i++) {
            confocal_of(point_of(&line, i), l);
            CHECK_NEAR(l[same], first[same], 100 * tolerance);
        }
        batten_surface_line_release(&line);
    }
    CHECK(found[0] == 1 && found[1] == 1);
    batten_surface_unref(egg);
}

/* Along the ellipse through the longest and the shortest axis: at x = a sqrt((a^2 - b^2) / (a^2 - c^2)). */
TEST(a_line_of_curvature_that_runs_into_an_umbilic_ends_there)
{
    batten_surface *egg = ellipsoid();
    const batten_interval u = batten_surface_domain(egg, BATTEN_U),
                          v = batten_surface_domain(egg, BATTEN_V);
    batten_surface_line line = {.length = 0};
    for (int k = 0; k < 2 && fabs(line.length) < 2.1; k++) {
        const batten_line_start start = {k ? BATTEN_LINE_CURVATURE2 : BATTEN_LINE_CURVATURE1,
                                         u.a,
                                         (v.a + v.b) / 2,
                                         {0, 0, 0},
                                         0};
        batten_surface_line_release(&line);
        CHECK_OK(batten_surface_line_from(egg, &start, tolerance, NULL, &line));
        if (line.line.closed)
            batten_surface_line_release(&line);
    }
    CHECK(line.ends[0] == BATTEN_LINE_AT_UMBILIC && line.ends[1] == BATTEN_LINE_AT_UMBILIC);
    for (int k = 0; k < 2; k++) {
        const batten_vec3 end = point_of(&line, k ? line.line.count - 1 : 0);
        CHECK_NEAR(end.x, 3 * sqrt(5 / 8.), 1e-4);
        CHECK_NEAR(end.y, 0, tolerance);
    }
    batten_surface_line_release(&line);
    batten_surface_unref(egg);
}

/* The inner half of the torus bends both ways; its circle on top is parabolic. */
TEST(an_asymptotic_line_ends_at_a_parabolic_line)
{
    batten_surface *torus = NULL;
    CHECK_OK(shape_torus(3, 1, false, &torus));
    batten_surface_line line =
        line_from(torus, BATTEN_LINE_ASYMPTOTIC1, 0.1, 0.5, (batten_vec3){0, 0, 0}, 0);
    CHECK_INT(line.ends[0], BATTEN_LINE_AT_PARABOLIC);
    CHECK_INT(line.ends[1], BATTEN_LINE_AT_PARABOLIC);
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(fabs(point_of(&line, k ? line.line.count - 1 : 0).z), 1, 1e-6);
    batten_surface_line_release(&line);
    batten_surface_unref(torus);
}

TEST(starts_without_a_direction_and_wrong_wishes_are_refused)
{
    const batten_frame world = batten_frame_world();
    batten_surface *ball = NULL;
    batten_surface_line line = {.length = 7};
    CHECK_OK(batten_surface_sphere(&world, 1, &ball));
    const batten_interval v = batten_surface_domain(ball, BATTEN_V);
    const double u = batten_surface_domain(ball, BATTEN_U).a, middle = (v.a + v.b) / 2;
    const struct {
        batten_line_start start;
        double tolerance;
        batten_status status;
        const char *words;
    } rows[] = {
        {{BATTEN_LINE_CURVATURE1, u, middle, {0, 0, 0}, 0},
         1e-3,
         BATTEN_SINGULAR_HERE,
         "both principal curvatures are equal"},
        {{BATTEN_LINE_ASYMPTOTIC2, u, middle, {0, 0, 0}, 0},
         1e-3,
         BATTEN_SINGULAR_HERE,
         "no asymptotic line"},
        {{BATTEN_LINE_GEODESIC, u, middle, {1, 0, 0}, 0}, 1e-3, BATTEN_SINGULAR_HERE, "square"},
        {{BATTEN_LINE_GEODESIC, u, middle, {0, 0, 0}, 0},
         1e-3,
         BATTEN_SINGULAR_HERE,
         "direction"},
        {{BATTEN_LINE_GEODESIC, u, v.a, {0, 1, 0}, 0},
         1e-3,
         BATTEN_SINGULAR_HERE,
         "no tangent plane"},
        {{BATTEN_LINE_GEODESIC, u, middle, {0, 1, 0}, 0}, 0, BATTEN_BAD_ARGUMENT, "tolerance"},
        {{BATTEN_LINE_GEODESIC, u, middle, {0, 1, 0}, -1}, 1, BATTEN_BAD_ARGUMENT, "length"},
        {{BATTEN_LINE_GEODESIC, u, NAN, {0, 1, 0}, 0}, 1, BATTEN_NOT_FINITE, "start"},
        {{BATTEN_LINE_GEODESIC, u, v.b + 1, {0, 1, 0}, 0}, 1, BATTEN_OUT_OF_DOMAIN, ""},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_STATUS(
            batten_surface_line_from(ball, &rows[i].start, rows[i].tolerance, NULL, &line),
            rows[i].status);
        CHECK_CONTAINS(batten_message(), rows[i].words);
        CHECK_NEAR(line.length, 7, 0);
    }
    batten_surface_unref(ball);
}

TEST(a_kind_of_line_that_there_is_not_is_refused_by_its_number_before_anything_else)
{
    static const int kinds[] = {-1, 5, 9, 1000000};
    batten_surface *tube = cylinder(1, 2);
    batten_surface_line line = {.length = 7};
    for (int i = 0; i < COUNT(kinds); i++) {
        char words[40];
        snprintf(words, sizeof words, "kind %d of lines; they are 0 to 4", kinds[i]);
        const batten_line_start start = {(batten_line_kind)kinds[i], NAN, 0.3, {1, 0, 0.3}, -1};
        CHECK_STATUS(batten_surface_line_from(tube, &start, 0, NULL, &line),
                     BATTEN_BAD_ARGUMENT);
        CHECK_CONTAINS(batten_message(), words);
        CHECK_NEAR(line.length, 7, 0);
    }
    batten_surface_unref(tube);
}

/* At each tolerance the line as it is at 1e-6, or that its tolerance is not met: never another. Away from the origin
 * coordinates carry less. */
static void check_ever_finer(const batten_surface *surface, const batten_line_start *start)
{
    batten_surface_line coarse = {.length = NAN};
    int refused = 0;
    CHECK_OK(batten_surface_line_from(surface, start, tolerance, NULL, &coarse));
    for (double t = 1e-7; t > 1e-17; t /= 10) {
        batten_surface_line line = {.length = 7};
        batten_status status = batten_surface_line_from(surface, start, t, NULL, &line);
        if (test_memory_failed(status, BATTEN_OK))
            status = batten_surface_line_from(surface, start, t, NULL, &line);
        if (status == BATTEN_OK) {
            CHECK_NEAR(line.length, coarse.length, 10 * tolerance);
            CHECK(line.error <= t);
            CHECK_INT(line.ends[0], coarse.ends[0]);
            CHECK_INT(line.ends[1], coarse.ends[1]);
            batten_surface_line_release(&line);
        } else {
            CHECK_STATUS(status, BATTEN_TOLERANCE_NOT_MET);
            CHECK_NEAR(line.length, 7, 0);
            refused += status == BATTEN_TOLERANCE_NOT_MET;
        }
    }
    CHECK(refused >= 2);
    batten_surface_line_release(&coarse);
}

TEST(a_tolerance_below_rounding_is_not_met_and_never_ends_a_line)
{
    const batten_frame world = batten_frame_world();
    batten_frame far = world;
    batten_surface *shapes[4] = {cylinder(1, 2)};
    far.origin = (batten_vec3){0, 5000, 0};
    CHECK_OK(shape_torus(3, 1, false, &shapes[1]));
    CHECK_OK(batten_surface_sphere(&world, 3, &shapes[2]));
    CHECK_OK(batten_surface_cylinder(&far, 1, 2, &shapes[3]));
    const batten_line_start starts[] = {
        {BATTEN_LINE_GEODESIC, 0.3, 0.3, {1, 0, 0.3}, 0},
        {BATTEN_LINE_CURVATURE1, 0.2, 0.3, {0, 0, 0}, 0},
        {BATTEN_LINE_GEODESIC, 0.1, 0.3, {-0.3, 0.4, 0.5}, 4},
        {BATTEN_LINE_GEODESIC, 0.3, 0.3, {1, 0, 0.3}, 3},
    };
    for (int i = 0; i < COUNT(starts); i++) {
        check_ever_finer(shapes[i], &starts[i]);
        batten_surface_unref(shapes[i]);
    }
}
