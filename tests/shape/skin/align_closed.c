#include "shape/sections.h"

#include <batten/standard.h>

#include "support/faults.h"

typedef const batten_curve *const *curves;

static double apart_at(const batten_surface *a, const batten_surface *b, double u, double v,
                       double ub, int mirrored)
{
    double p[3], q[3];
    CHECK_OK(batten_surface_evaluate(a, u, v, 0, p));
    CHECK_OK(batten_surface_evaluate(b, ub, v, 0, q));
    if (mirrored >= 0)
        q[mirrored] = -q[mirrored];
    return hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/* An ellipse like a rounded slot about the z-axis, its points from `turn` on: where a closed
 * section begins is left to chance. */
static batten_curve *ring(double z, double turn, bool periodic, bool backwards)
{
    enum { N = 24 };
    double points[3 * (N + 1)];
    for (int i = 0; i <= N; i++) {
        const double a = turn + (backwards ? -1 : 1) * 4 * acos(0) * (i % N) / N;
        points[3 * i] = (2 + 0.2 * z) * cos(a);
        points[3 * i + 1] = sin(a) + 0.1 * cos(2 * a);
        points[3 * i + 2] = z;
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_UNIFORM;
    options.closed = periodic;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, periodic ? N : N + 1, points},
                                      &options, NULL, &curve));
    return curve;
}

/* How much narrower the surface becomes between two sections: twisted ones draw a waist. */
static double waist(const batten_surface *surface, double v)
{
    double widest = 0;
    for (int i = 0; i <= 64; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 64.0, v, 0, p));
        widest = fmax(widest, hypot(p[0], p[1]));
    }
    return widest;
}

TEST(closed_sections_turn_so_that_nothing_twists)
{
    for (int periodic = 0; periodic < 2; periodic++) {
        batten_curve *sections[4];
        for (int k = 0; k < 4; k++)
            sections[k] = ring(k, 1.1 * k, periodic, k == 2);
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.degree = 1;
        batten_surface *twisted = NULL, *turned = NULL;
        batten_surface_skin_report report;
        double v[4];
        CHECK_EACH_ALLOCATION(batten_surface_skin((batten_curve_row){4, (curves)sections},
                                                  &options, NULL, NULL, NULL, &twisted));
        options.align = options.turn = true;
        CHECK_EACH_ALLOCATION(batten_surface_skin((batten_curve_row){4, (curves)sections},
                                                  &options, NULL, v, &report, &turned));
        CHECK(report.turned_count == 3 && report.reversed_count == 1);
        CHECK(report.crossing_count == 0 && report.disorder == -1);
        CHECK_INT(batten_surface_is_periodic(turned, BATTEN_U), periodic);
        /* Straight rulings between nearest points keep the width. */
        CHECK(waist(turned, (v[0] + v[1]) / 2) > 2.05);
        CHECK(waist(twisted, 1.0 / 6) < 1.98);
        batten_surface_unref(turned);
        batten_surface_unref(twisted);
        unref_all(4, sections);
    }
}

TEST(closed_sections_begin_where_they_are_told)
{
    for (int periodic = 0; periodic < 2; periodic++) {
        batten_curve *sections[3];
        double starts[3];
        for (int k = 0; k < 3; k++) {
            sections[k] = ring(k, 0, periodic, false);
            const batten_interval domain = batten_curve_domain(sections[k]);
            starts[k] = domain.a + (domain.b - domain.a) * (0.25 + 0.1 * k);
        }
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.starts = starts;
        batten_surface *surface = NULL;
        batten_surface_skin_report report;
        double v[3];
        CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL, v,
                                     &report, &surface));
        CHECK_INT(report.turned_count, 3);
        for (int k = 0; k < 3; k++) {
            double given[3], found[3];
            CHECK_OK(batten_curve_evaluate(sections[k], starts[k], 0, given));
            CHECK_OK(batten_surface_evaluate(surface, 0, v[k], 0, found));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(found[c], given[c], 1e-12);
        }
        batten_surface_unref(surface);
        surface = NULL;
        starts[1] = 1e3;
        CHECK_STATUS(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options,
                                         NULL, v, &report, &surface),
                     BATTEN_OUT_OF_DOMAIN);
        CHECK_MESSAGE("section 2 cannot begin at 1000");
        options.turn = true;
        CHECK_STATUS(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options,
                                         NULL, v, &report, &surface),
                     BATTEN_BAD_ARGUMENT);
        CHECK(surface == NULL);
        unref_all(3, sections);
    }
}

TEST(G10_mirrored_sections_make_the_mirrored_surface)
{
    for (int c = 0; c < 2; c++) {
        const batten_affine mirror = batten_affine_scaling(1, -1, 1);
        batten_curve *sections[4], *mirrored[4];
        for (int k = 0; k < 4; k++) {
            sections[k] = ring(k, 0.9 * k, c == 0, k == 1);
            mirrored[k] = NULL;
            CHECK_OK(batten_curve_transform(sections[k], &mirror, &mirrored[k]));
        }
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.align = options.turn = true;
        options.tolerance = 1e-3;
        batten_surface *a = NULL, *b = NULL;
        CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL,
                                     NULL, NULL, &a));
        CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)mirrored}, &options, NULL,
                                     NULL, NULL, &b));
        for (int i = 0; i <= 20; i++)
            for (int j = 0; j <= 20; j++)
                CHECK(apart_at(a, b, i / 20.0, j / 20.0, i / 20.0, 1) < 1e-12);
        batten_surface_unref(b);
        batten_surface_unref(a);
        unref_all(4, mirrored);
        unref_all(4, sections);
    }
}

/* Frames of a whole ship, from one side to the other. */
static batten_curve *both_sides(test_random *random, int count, double x)
{
    double points[3 * 63], s[63];
    const int n = 2 * count - 1;
    for (int i = 0; i < count; i++) {
        const double jitter = i > 0 && i < count - 1 ? test_random_in(random, -0.3, 0.3) : 0;
        const double at = (i + jitter) / (count - 1);
        double *low = points + 3 * (count - 1 - i), *high = points + 3 * (count - 1 + i);
        hull(at, x, high);
        memcpy(low, high, 3 * sizeof *low);
        low[1] = -low[1];
        s[count - 1 + i] = (1 + at) / 2;
        s[count - 1 - i] = (1 - at) / 2;
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, n, points}, &options, NULL, &curve));
    return curve;
}

TEST(symmetric_sections_make_a_symmetric_surface_with_few_knots_too)
{
    test_random random = test_random_begin("sides");
    batten_curve *sections[8];
    for (int k = 0; k < 8; k++)
        sections[k] = both_sides(&random, 12, k / 7.0);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    options.tolerance = 5e-3;
    CHECK_OK(batten_surface_skin((batten_curve_row){8, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK(report.knot_count < report.exact_knot_count / 3 && report.error <= 5e-3);
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 20; j++)
            CHECK(apart_at(surface, surface, i / 40.0, j / 20.0, 1 - i / 40.0, 1) < 25e-12);
    batten_surface_unref(surface);
    unref_all(8, sections);
}

/* A quarter of an ellipse whose parameter runs ever faster: pow(s, power) of the angle. */
static batten_curve *hasty(double z, double power)
{
    enum { N = 40 };
    double points[3 * N], s[N];
    for (int i = 0; i < N; i++) {
        s[i] = (double)i / (N - 1);
        const double a = acos(0) * pow(s[i], power);
        points[3 * i] = cos(a), points[3 * i + 1] = sin(a), points[3 * i + 2] = z;
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, N, points}, &options, NULL, &curve));
    return curve;
}

TEST(sections_matched_by_arc_length_have_straight_lines_across)
{
    const double powers[] = {1, 1.5, 2, 1.2};
    batten_curve *sections[4];
    for (int k = 0; k < 4; k++)
        sections[k] = hasty(k, powers[k]);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.match = BATTEN_MATCH_ARC_LENGTH;
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL,
                                     NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("to match sections by arc length a tolerance is needed");
    options.tolerance = 1e-4;
    batten_surface_skin_report report;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, NULL,
                                 &report, &surface));
    CHECK(report.error <= 1e-4 && report.error > 0 && report.knot_count < 20);
    CHECK(report.crease < 1e-9);
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 20.0, j / 20.0, 0, p));
            CHECK_NEAR(p[0], cos(acos(0) * i / 20), 2e-4);
            CHECK_NEAR(p[1], sin(acos(0) * i / 20), 2e-4);
        }
    batten_surface_unref(surface);
    unref_all(4, sections);
}

TEST(sections_matched_by_marks_have_them_at_one_parameter)
{
    const double powers[] = {1, 1.5, 2, 0.8};
    double marks[8];
    batten_curve *sections[4];
    for (int k = 0; k < 4; k++) {
        sections[k] = hasty(k, powers[k]);
        marks[2 * k] = pow(1.0 / 3, 1 / powers[k]); /* a third and two thirds of the angle */
        marks[2 * k + 1] = pow(2.0 / 3, 1 / powers[k]);
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.match = BATTEN_MATCH_MARKS;
    options.mark_count = 2;
    options.marks = marks;
    options.tolerance = 1e-4;
    batten_surface *surface = NULL;
    batten_surface_skin_report report;
    double v[4];
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, v,
                                 &report, &surface));
    CHECK(report.error <= 1e-4);
    for (int j = 0; j < 2; j++) {
        double mean = 0;
        for (int k = 0; k < 4; k++)
            mean += marks[2 * k + j] / 4;
        for (int k = 0; k < 4; k++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, mean, v[k], 0, p));
            CHECK_NEAR(atan2(p[1], p[0]), acos(0) * (j + 1) / 3, 1.5e-4);
        }
    }
    batten_surface_unref(surface);
    surface = NULL;
    marks[3] = marks[2];
    CHECK_STATUS(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL,
                                     NULL, NULL, &surface),
                 BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("marks do not rise inside section 2");
    options.align = true;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL,
                                     NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    options.mark_count = 0;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL,
                                     NULL, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    unref_all(4, sections);
}

TEST(G7_open_and_closed_sections_do_not_go_together)
{
    batten_curve *sections[3] = {ring(0, 0, true, false), ring(1, 0, false, false),
                                 hasty(2, 1)};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){3, (curves)sections}, NULL, NULL, NULL,
                                     NULL, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("section 1 is closed, and section 3 is open");
    CHECK_EACH_ALLOCATION(batten_surface_ruled(sections[1], sections[2], &surface));
    batten_surface_unref(surface);
    unref_all(3, sections);
}

static batten_curve *line_at(double x, double from, double to)
{
    const double a[] = {x, 0, from}, b[] = {x, 1, to};
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    return line;
}

TEST(G7_sections_that_cross_or_stand_in_disorder_are_named)
{
    const double places[] = {0, 1, 3, 2, 4};
    batten_curve *sections[5];
    for (int k = 0; k < 5; k++)
        sections[k] = line_at(places[k], 0, 1);
    batten_surface *surface = NULL;
    batten_surface_skin_report report;
    CHECK_OK(batten_surface_skin((batten_curve_row){5, (curves)sections}, NULL, NULL, NULL,
                                 &report, &surface));
    CHECK(report.disorder == 2 && report.disorder_count == 1 && report.crossing == -1);
    CHECK_MESSAGE("sections 3 and 4 are rather in the other order");
    batten_surface_unref(surface);
    batten_curve_unref(sections[1]);
    sections[1] = line_at(0, -0.5, 1.5); /* it crosses the first */
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (curves)sections}, NULL, NULL, NULL,
                                 &report, &surface));
    CHECK(report.crossing == 0 && report.crossing_count == 1 && report.disorder == -1);
    CHECK_MESSAGE("sections 1 and 2 cross");
    batten_surface_unref(surface);
    unref_all(5, sections);
}

TEST(N2_sections_of_huge_and_tiny_size_are_turned_and_matched)
{
    const double sizes[] = {1e80, 1e-80};
    for (int c = 0; c < COUNT(sizes); c++) {
        const batten_affine scale = batten_affine_scaling(sizes[c], sizes[c], sizes[c]);
        batten_curve *given[3], *sections[3];
        for (int k = 0; k < 3; k++) {
            given[k] = ring(k, 1.1 * k, true, k == 1);
            sections[k] = NULL;
            CHECK_OK(batten_curve_transform(given[k], &scale, &sections[k]));
        }
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.turn = options.align = true;
        batten_surface_skin_report report;
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL,
                                     NULL, &report, &surface));
        CHECK(report.turned_count == 2 && report.reversed_count == 1);
        batten_surface_unref(surface);
        surface = NULL;
        options.match = BATTEN_MATCH_ARC_LENGTH;
        options.tolerance = 1e-3 * sizes[c];
        CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, &options, NULL,
                                     NULL, &report, &surface));
        CHECK(report.error <= options.tolerance);
        batten_surface_unref(surface);
        unref_all(3, sections);
        unref_all(3, given);
    }
}

/* A quarter of the way in domains of their own: nothing has to move, and no knot comes in. */
TEST(sections_whose_marks_are_at_one_share_already_stay_as_they_are)
{
    static const double knots[2][6] = {{2, 2, 2, 6, 6, 6}, {-1, -1, -1, 0, 0, 0}};
    static const double marks[2] = {3, -0.75};
    batten_curve *sections[2] = {NULL, NULL};
    for (int k = 0; k < 2; k++) {
        const double points[9] = {0, 0, k, 1, 2, k, 3, 0.5 * k, k};
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, NULL, knots[k],
                                     &sections[k]));
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    options.tolerance = 1e-3;
    options.match = BATTEN_MATCH_MARKS;
    options.mark_count = 1;
    options.marks = marks;
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                 &options, NULL, NULL, &report, &surface));
    CHECK(report.error < 1e-15 && report.knot_count == 0);
    double middle[3];
    CHECK_OK(batten_surface_evaluate(surface, 0.5, 1, 0, middle));
    CHECK_NEAR(middle[0], 1.25, 1e-14);
    CHECK_NEAR(middle[1], 1.125, 1e-14);
    batten_surface_unref(surface);
    unref_all(2, sections);
}
