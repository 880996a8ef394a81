#include <batten/scattered.h>

#include "support/test.h"

static double plane(double x, double y)
{
    return 3 * x - 2 * y + 0.5;
}

/* The linear function over the triangulation of random points of the unit square. */
static batten_triangles *square(int count)
{
    test_random random = test_random_begin("places over triangles");
    double *points = test_array((size_t)count * 2, sizeof *points),
           *f = test_array((size_t)count, sizeof *f);
    const double corners[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    batten_plane_triangles plan;
    batten_triangles *out = NULL;
    memcpy(points, corners, sizeof corners);
    for (int i = 8; i < 2 * count; i++)
        points[i] = test_random_unit(&random);
    CHECK_OK(batten_triangulate((batten_points){2, count, points}, NULL, &plan));
    CHECK_INT(plan.vertex_count, count);
    for (int v = 0; v < count; v++)
        f[v] = plane(plan.vertices[2 * v], plan.vertices[2 * v + 1]);
    const batten_triangulation domain = {plan.vertex_count, plan.vertices, plan.corners};
    CHECK_OK(batten_triangles_linear(&domain, plan.count, f, &out));
    batten_plane_triangles_release(&plan);
    return out;
}

TEST(values_and_slopes_over_triangles_are_those_of_the_plane)
{
    batten_triangles *triangles = square(60);
    test_random random = test_random_begin("places");
    double at[2 * 500], found[3 * 500];
    size_t outside = 9;
    for (int i = 0; i < COUNT(at); i++)
        at[i] = test_random_unit(&random);
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){500, at}, 1,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, &outside},
                                   NULL, found));
    CHECK_INT((int)outside, 0);
    for (int i = 0; i < 500; i++) {
        CHECK_NEAR(found[3 * i], plane(at[2 * i], at[2 * i + 1]), 1e-12);
        CHECK_NEAR(found[3 * i + 1], 3, 1e-10);
        CHECK_NEAR(found[3 * i + 2], -2, 1e-10);
    }
    batten_triangles_unref(triangles);
}

TEST(places_outside_are_refused_or_taken_to_the_rim)
{
    batten_triangles *triangles = square(30);
    const double at[6] = {0.5, 0.5, 2, 0.25, -1, -1}, odd[2] = {NAN, 0};
    double found[3];
    size_t outside = 0;
    CHECK_STATUS(batten_triangles_over(triangles, (batten_batch){3, at}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, found),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_triangles_over(triangles, (batten_batch){1, odd}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, NULL},
                                       NULL, found),
                 BATTEN_NOT_FINITE);
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){3, at}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, &outside},
                                   NULL, found));
    CHECK_INT((int)outside, 2);
    CHECK_NEAR(found[1], plane(1, 0.25), 1e-12);
    CHECK_NEAR(found[2], plane(0, 0), 1e-12);
    batten_triangles_unref(triangles);
}

TEST(triangles_without_a_domain_are_no_function)
{
    const double points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, at[2] = {0.2, 0.2};
    double found[3];
    batten_triangles *triangles = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 1, points, NULL, NULL},
                                     &triangles));
    CHECK_STATUS(batten_triangles_over(triangles, (batten_batch){1, at}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, found),
                 BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(triangles);
}

TEST(places_behind_a_corner_of_the_rim_that_turns_inwards_are_found)
{
    /* a bar with two teeth: from one tooth to the other the walk leaves the triangles */
    const double vertices[] = {0, 0, 3, 0, 3, 3, 2, 1, 1, 1, 0, 3};
    const int corners[] = {0, 4, 5, 0, 1, 4, 1, 3, 4, 1, 2, 3};
    const batten_triangulation domain = {6, vertices, corners};
    double f[6];
    for (int v = 0; v < 6; v++)
        f[v] = plane(vertices[2 * v], vertices[2 * v + 1]);
    batten_triangles *out = NULL;
    CHECK_OK(batten_triangles_linear(&domain, 4, f, &out));
    const double at[] = {0.1, 2.5, 2.9, 2.5, 0.1, 2.5, 1.5, 2.0, 2.9, 2.6, 1.5, -1};
    double found[6];
    size_t outside = 0;
    CHECK_OK(batten_triangles_over(out, (batten_batch){6, at}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, &outside},
                                   NULL, found));
    CHECK_INT((int)outside, 2);
    for (int i = 0; i < 5; i++)
        if (i != 3)
            CHECK_NEAR(found[i], plane(at[2 * i], at[2 * i + 1]), 1e-13);
    CHECK_NEAR(found[5], plane(1.5, 0), 1e-13);
    batten_triangles_unref(out);
}

static bool stops_at_once(void *user)
{
    (void)user;
    return true;
}

static bool never_stops(void *user)
{
    ++*(int *)user;
    return false;
}

TEST(a_job_over_triangles_is_asked_and_stops)
{
    enum { PLACES = 2500 };
    batten_triangles *triangles = square(20);
    double *at = test_array((size_t)PLACES * 2, sizeof *at),
           *found = test_array(PLACES, sizeof *found);
    for (int i = 0; i < 2 * PLACES; i++)
        at[i] = 0.25;
    found[0] = -7;
    int asked = 0;
    const batten_job stopped = {.size = sizeof stopped, .is_cancelled = stops_at_once},
                     watched = {.size = sizeof watched,
                                .is_cancelled = never_stops,
                                .user = &asked},
                     blind = BATTEN_JOB;
    const batten_outside_points refused = {BATTEN_OUTSIDE_REFUSED, NULL};
    CHECK_STATUS(batten_triangles_over(triangles, (batten_batch){PLACES, at}, 0, refused,
                                       &stopped, found),
                 BATTEN_CANCELLED);
    CHECK_MESSAGE("after 0 of 2500 places");
    CHECK_NEAR(found[0], -7, 0);
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){PLACES, at}, 0, refused, &watched,
                                   found));
    CHECK_NEAR(found[PLACES - 1], plane(0.25, 0.25), 1e-13);
    CHECK(asked >= 3);
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){PLACES, at}, 0, refused, &blind,
                                   found));
    const double odd[2] = {0, INFINITY};
    CHECK_STATUS(
        batten_triangles_over(triangles, (batten_batch){1, odd}, 0, refused, NULL, found),
        BATTEN_NOT_FINITE);
    batten_triangles_unref(triangles);
}

TEST(a_slope_too_large_for_a_number_is_refused)
{
    const double vertices[6] = {0, 0, 1e-3, 0, 0, 1e-3}, values[3] = {0, 1e306, 0};
    const int corners[3] = {0, 1, 2};
    const batten_triangulation domain = {3, vertices, corners};
    batten_triangles *triangles = NULL;
    double found[3];
    const double at[2] = {2e-4, 2e-4};
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, 1, values, NULL, &domain},
                                     &triangles));
    CHECK_OK(batten_triangles_over(triangles, (batten_batch){1, at}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   found));
    CHECK_STATUS(batten_triangles_over(triangles, (batten_batch){1, at}, 1,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, found),
                 BATTEN_OVERFLOW);
    batten_triangles_unref(triangles);
}
