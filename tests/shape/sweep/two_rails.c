#include "support/test.h"

#include <batten/interpolate.h>
#include <batten/measure.h>
#include <batten/standard.h>
#include <batten/sweep.h>

static batten_curve *through(int count, const double *points)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, count, points}, NULL, NULL, &curve));
    return curve;
}

/* An arch over (0, 0) .. (2, 0), somewhere in the plane. */
static batten_curve *arch(void)
{
    const double a[3] = {1, 5, 0}, b[3] = {2, 6, 0}, c[3] = {3, 5, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_conic(3, a, b, c, 1.5, &curve));
    return curve;
}

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static const double left_points[12] = {0, 0, 0, 2, 0.3, 0, 4, 0, 0.5, 6, -0.2, 0.4},
                    right_points[12] = {0, 2, 0, 2.4, 2.4, 0.2, 4.1, 1.6, 0.1, 6, 1.5, 0.8};

TEST(the_ends_of_the_section_run_on_the_rails)
{
    batten_curve *section = arch(), *left = through(4, left_points),
                 *right = through(4, right_points);
    for (int fixed = 0; fixed < 2; fixed++) {
        batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
        batten_surface_sweep_report report;
        batten_surface *surface = NULL;
        options.tolerance = 1e-5;
        options.fixed_height = fixed;
        CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                          &options, NULL, &report, &surface));
        CHECK(report.error <= 1e-5);
        const batten_interval l = batten_curve_domain(left), r = batten_curve_domain(right);
        for (int j = 0; j <= 40; j++) {
            const double v = j / 40.0;
            double a[3], b[3], p[3], q[3], top[3];
            CHECK_OK(batten_curve_evaluate(left, fmin(l.b, l.a + (l.b - l.a) * v), 0, a));
            CHECK_OK(batten_curve_evaluate(right, fmin(r.b, r.a + (r.b - r.a) * v), 0, b));
            CHECK_OK(batten_surface_evaluate(surface, 0, v, 0, p));
            CHECK_OK(batten_surface_evaluate(surface, 1, v, 0, q));
            CHECK_OK(batten_surface_evaluate(surface, 0.5, v, 0, top));
            CHECK_NEAR(distance(a, p), 0, 1e-5);
            CHECK_NEAR(distance(b, q), 0, 1e-5);
            /* The crown is 0.6 above the middle of a chord of 2. */
            const double middle[3] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
            CHECK_NEAR(distance(middle, top), fixed ? 0.6 : 0.3 * distance(a, b), 3e-5);
        }
        batten_surface_unref(surface);
    }
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

TEST(parallel_straight_rails_make_a_cylinder_to_rounding)
{
    batten_curve *section = arch(), *left = NULL, *right = NULL;
    batten_surface *surface = NULL;
    batten_surface_sweep_report report;
    CHECK_OK(batten_curve_line(3, (double[3]){0, 0, 0}, (double[3]){5, 0, 0}, &left));
    CHECK_OK(batten_curve_line(3, (double[3]){0, 2, 0}, (double[3]){5, 2, 0}, &right));
    CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                      NULL, NULL, &report, &surface));
    CHECK_INT(report.section_count, 2);
    for (int i = 0; i <= 8; i++) {
        double c[3], p[3];
        CHECK_OK(batten_curve_evaluate(section, i / 8.0, 0, c));
        CHECK_OK(batten_surface_evaluate(surface, i / 8.0, 0.5, 0, p));
        const double expected[3] = {2.5, c[0] - 1, c[1] - 5};
        CHECK_NEAR(distance(p, expected), 0, 4e-15);
    }
    batten_surface_unref(surface);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

TEST(G5_rails_that_touch_at_an_end_make_a_pole)
{
    static const double l[12] = {0, 0, 0, 2, -1, 0, 4, -1.2, 0.2, 6, 0, 0},
                        r[12] = {0, 0, 0, 2, 1.3, 0, 4, 1.4, 0, 6, 0, 0};
    batten_curve *section = arch(), *left = through(4, l), *right = through(4, r);
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    batten_surface *surface = NULL;
    options.tolerance = 1e-4;
    CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                      &options, NULL, NULL, &surface));
    for (int i = 0; i <= 8; i++)
        for (int end = 0; end < 2; end++) {
            double p[3];
            batten_vec3 normal;
            CHECK_OK(batten_surface_evaluate(surface, i / 8.0, end, 0, p));
            CHECK_NEAR(distance(p, end ? l + 9 : l), 0, 1e-12);
            CHECK_OK(
                batten_surface_normal(surface, i / 8.0, end ? 0.999 : 0.001, NULL, &normal));
        }
    batten_surface_unref(surface);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

TEST(rails_are_matched_by_length_and_by_planes)
{
    batten_curve *section = arch(), *left = through(4, left_points),
                 *right = through(4, right_points);
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    options.tolerance = 1e-4;
    batten_surface *surface = NULL;
    batten_surface_sweep_report report;
    options.match = BATTEN_RAILS_BY_PLANES;
    options.across = (batten_vec3){2, 0, 0};
    CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                      &options, NULL, &report, &surface));
    for (int j = 0; j <= 40; j++) {
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(surface, 0, j / 40.0, 0, p));
        CHECK_OK(batten_surface_evaluate(surface, 1, j / 40.0, 0, q));
        CHECK_NEAR(p[0], 6 * j / 40.0, 1e-4);
        CHECK_NEAR(q[0], 6 * j / 40.0, 1e-4);
    }
    batten_surface_unref(surface);
    options.match = BATTEN_RAILS_BY_LENGTH;
    CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                      &options, NULL, &report, &surface));
    CHECK(report.error <= 1e-4);
    double whole;
    CHECK_OK(batten_curve_length(left, 1e-9, NULL, &whole));
    for (int j = 0; j <= 10; j++) {
        double p[9];
        CHECK_OK(batten_surface_evaluate(surface, 0, j / 10.0, 1, p));
        const double length = hypot(hypot(p[6], p[7]), p[8]);
        CHECK_NEAR(length, whole, 1e-2);
    }
    batten_surface_unref(surface);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

TEST(G7_rails_that_cross_are_refused_with_the_place)
{
    static const double l[12] = {0, 0, 0, 2, 0.5, 0, 4, 1.5, 0, 6, 2, 0},
                        r[12] = {0, 2, 0, 2, 1.5, 0, 4, 0.5, 0, 6, 0, 0},
                        back[12] = {0, 2, 0, 3, 1.5, 0, 2, 0.5, 0, 6, 0, 0};
    batten_curve *section = arch(), *left = through(4, l), *right = through(4, r),
                 *turning = through(4, back), *point = NULL, *ring = NULL;
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                          &options, NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the rails cross or meet at 0.5");
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, left},
                                          &options, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("the rails coincide");
    options.match = BATTEN_RAILS_BY_PLANES;
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                          &options, NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    options.across = (batten_vec3){1, 0, 0};
    CHECK_STATUS(batten_surface_two_rails(section,
                                          (const batten_curve *const[2]){left, turning},
                                          &options, NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("rail 2 turns back");
    options.across = (batten_vec3){-1, 0, 0};
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                          &options, NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("rail 1 goes from height 0 to -6");
    options = batten_surface_two_rails_defaults();
    CHECK_OK(batten_curve_line(3, l, (double[3]){1e-9, 0, 0}, &point));
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, point},
                                          &options, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("rail 2 reaches 1e-09");
    CHECK_OK(batten_curve_arc(1, 4 * acos(0), &ring));
    CHECK_STATUS(batten_surface_two_rails(ring, (const batten_curve *const[2]){left, right},
                                          &options, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    options.tolerance = NAN;
    CHECK_STATUS(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                          &options, NULL, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK(none == NULL);
    batten_curve_unref(ring);
    batten_curve_unref(point);
    batten_curve_unref(turning);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

TEST(N2_rails_of_huge_or_tiny_size_make_the_scaled_surface)
{
    static const double sizes[] = {1e80, 1e-80, 1e200, 1e-200};
    batten_curve *section = arch(), *left = through(4, left_points),
                 *right = through(4, right_points);
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    batten_surface *plain = NULL;
    options.tolerance = 1e-4;
    CHECK_OK(batten_surface_two_rails(section, (const batten_curve *const[2]){left, right},
                                      &options, NULL, NULL, &plain));
    for (int k = 0; k < COUNT(sizes); k++) {
        const batten_affine map = batten_affine_scaling(sizes[k], sizes[k], sizes[k]);
        batten_curve *images[3] = {NULL, NULL, NULL};
        batten_surface *surface = NULL;
        CHECK_OK(batten_curve_transform(section, &map, &images[0]));
        CHECK_OK(batten_curve_transform(left, &map, &images[1]));
        CHECK_OK(batten_curve_transform(right, &map, &images[2]));
        options.tolerance = 1e-4 * sizes[k];
        CHECK_OK(batten_surface_two_rails(images[0],
                                          (const batten_curve *const[2]){images[1], images[2]},
                                          &options, NULL, NULL, &surface));
        for (int i = 0; i <= 10; i++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(plain, 0.3, i / 10.0, 0, p));
            CHECK_OK(batten_surface_evaluate(surface, 0.3, i / 10.0, 0, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c] / sizes[k], p[c], 1e-12);
        }
        batten_surface_unref(surface);
        for (int c = 0; c < 3; c++)
            batten_curve_unref(images[c]);
    }
    batten_surface_unref(plain);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}

static void change_options(int which, batten_surface_two_rails_options *o)
{
    static const double tolerances[4] = {NAN, INFINITY, 0, -1};
    if (which < 4)
        o->tolerance = tolerances[which];
    if (which == 4)
        o->across = (batten_vec3){0, INFINITY, 1};
    if (which == 5)
        o->match = BATTEN_RAILS_BY_PLANES;
    if (which == 6)
        o->degree = 0;
}

static const struct {
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_NOT_FINITE, "the tolerance is nan"},
    {BATTEN_NOT_FINITE, "the tolerance is inf"},
    {BATTEN_BAD_ARGUMENT, "the tolerance is 0, not above 0"},
    {BATTEN_BAD_ARGUMENT, "the tolerance is -1, not above 0"},
    {BATTEN_NOT_FINITE, "the planes are across (0, inf, 1)"},
    {BATTEN_BAD_ARGUMENT, "the planes have no direction across them"},
    {BATTEN_BAD_DEGREE, "the degree along the path is 0, not 1 to "},
};

TEST(options_of_two_rails_that_cannot_be_are_named)
{
    batten_curve *section = arch(), *left = through(4, left_points),
                 *right = through(4, right_points);
    const batten_curve *const rails[2] = {left, right};
    batten_surface *none = NULL;
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
        change_options(i, &options);
        CHECK_STATUS(batten_surface_two_rails(section, rails, &options, NULL, NULL, &none),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    const double a[3] = {0, 1, 2}, b[3] = {3, 1, 2.5}, ring[4] = {1, 2, 1, 2};
    batten_curve *leaning = NULL, *point = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &leaning));
    CHECK_STATUS(batten_surface_two_rails(leaning, rails, NULL, NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE(
        "the section begins at z = 2 and ends at z = 2.5: its chord is laid from rail to "
        "rail, so it must be drawn in the xy-plane");
    const double knots[4] = {0, 0, 1, 1};
    CHECK_OK(batten_curve_create((batten_points){2, 2, ring}, 1, NULL, knots, &point));
    CHECK_STATUS(batten_surface_two_rails(point, rails, NULL, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("the section begins and ends in the same place, (1, 2)");
    CHECK(!none);
    batten_curve_unref(point);
    batten_curve_unref(leaning);
    batten_curve_unref(right);
    batten_curve_unref(left);
    batten_curve_unref(section);
}
