/* Places of surfaces moved with the least change. */
#include <batten/extend.h>
#include <batten/standard.h>

#include "support/surfaces.h"
#include "support/test.h"

#include <string.h>

/* A bicubic surface of 6 by 5 points over uneven knots, with weights when asked for. */
static batten_surface *uneven(test_random *random, bool rational)
{
    static const double knots_u[] = {0, 0, 0, 0, 0.2, 0.7, 1, 1, 1, 1},
                        knots_v[] = {2, 2, 2, 2, 2.5, 4, 4, 4, 4};
    double points[90], weights[30];
    for (int i = 0; i < 30; i++) {
        points[3 * i] = i / 5 + test_random_in(random, -0.2, 0.2);
        points[3 * i + 1] = i % 5 + test_random_in(random, -0.2, 0.2);
        points[3 * i + 2] = test_random_unit(random);
        weights[i] = test_random_in(random, 0.5, 2);
    }
    const batten_axis u = {3, 6, knots_u, false}, v = {3, 5, knots_v, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, rational ? weights : NULL, &surface));
    return surface;
}

static const batten_surface_pull pulls[] = {
    {0.3, 2.7, {0.1, -0.2, 0.5}}, {0.9, 3.9, {0, 0, -1}}, {0.5, 3, {0.3, 0.3, 0.3}}};

TEST(pulled_places_move_exactly_and_kept_rows_do_not)
{
    test_random random = test_random_begin("pulled");
    for (int kind = 0; kind < 6; kind++) {
        const int kept = kind / 2;
        batten_surface *surface = uneven(&random, kind % 2), *made = NULL;
        const int count = kept < 2 ? 3 : 1;
        double moved = 0, farthest = 0;
        CHECK_OK(batten_surface_pulled(surface, count, pulls, kept, &moved, &made));
        for (int k = 0; k < count; k++) {
            double was[3], is[3];
            CHECK_OK(batten_surface_evaluate(surface, pulls[k].u, pulls[k].v, 0, was));
            CHECK_OK(batten_surface_evaluate(made, pulls[k].u, pulls[k].v, 0, is));
            CHECK_NEAR(is[0] - was[0], pulls[k].by.x, 1e-12);
            CHECK_NEAR(is[1] - was[1], pulls[k].by.y, 1e-12);
            CHECK_NEAR(is[2] - was[2], pulls[k].by.z, 1e-12);
        }
        const double *P = batten_surface_points(surface), *Q = batten_surface_points(made);
        for (int i = 0; i < 30; i++) {
            const int row = i / 5, column = i % 5;
            const double far = hypot(hypot(Q[3 * i] - P[3 * i], Q[3 * i + 1] - P[3 * i + 1]),
                                     Q[3 * i + 2] - P[3 * i + 2]);
            farthest = fmax(farthest, far);
            if (row < kept || row >= 6 - kept || column < kept || column >= 5 - kept)
                CHECK(far == 0);
        }
        CHECK_NEAR(moved, farthest, 1e-14);
        batten_surface_unref(made);
        batten_surface_unref(surface);
    }
}

/* The moves of the least change are combinations of what acts at the places, here one: any other change of the same
 * effect differs by what does not act there, and is longer. */
TEST(the_change_is_the_least)
{
    test_random random = test_random_begin("least");
    batten_surface *surface = uneven(&random, false), *made = NULL;
    CHECK_OK(batten_surface_pulled(surface, 1, pulls, 0, NULL, &made));
    const double *P = batten_surface_points(surface), *Q = batten_surface_points(made);
    double change = 0, wanted = 0, squares = 0;
    for (int i = 0; i < 30; i++) {
        /* What point i does to the place: its influence, measured by moving it alone. */
        const double lifted[3] = {P[3 * i], P[3 * i + 1], P[3 * i + 2] + 1};
        batten_surface *other = NULL;
        double before[3], after[3];
        CHECK_OK(batten_surface_with_point(surface, i / 5, i % 5, lifted, &other));
        CHECK_OK(batten_surface_evaluate(surface, pulls[0].u, pulls[0].v, 0, before));
        CHECK_OK(batten_surface_evaluate(other, pulls[0].u, pulls[0].v, 0, after));
        squares += (after[2] - before[2]) * (after[2] - before[2]);
        change += (Q[3 * i + 2] - P[3 * i + 2]) * (Q[3 * i + 2] - P[3 * i + 2]);
        batten_surface_unref(other);
    }
    wanted = pulls[0].by.z * pulls[0].by.z / squares; /* of Cauchy and Schwarz */
    CHECK_NEAR(change, wanted, 1e-12);
    batten_surface_unref(made);
    batten_surface_unref(surface);
}

TEST(poles_and_seams_stay_closed)
{
    const batten_frame frame = batten_frame_world();
    batten_surface *ball = NULL, *made = NULL;
    CHECK_OK(batten_surface_sphere(&frame, 1, &ball));
    const batten_interval u = batten_surface_domain(ball, BATTEN_U),
                          v = batten_surface_domain(ball, BATTEN_V);
    const batten_surface_pull out = {0.45 * u.b + 0.55 * u.a, (v.a + v.b) / 2, {-0.1, 0, 0.1}};
    CHECK_OK(batten_surface_pulled(ball, 1, &out, 0, NULL, &made));
    CHECK(batten_surface_is_closed(made, BATTEN_U, 1e-14));
    for (int i = 0; i <= 10; i++)
        for (int end = 0; end < 2; end++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(made, u.a + (u.b - u.a) * i / 10, end ? v.b : v.a,
                                             0, p));
            CHECK_NEAR(fabs(p[2]), 1, 1e-14);
            CHECK_NEAR(hypot(p[0], p[1]), 0, 1e-14);
        }
    const batten_surface_pull pole = {(u.a + u.b) / 2, v.a, {0, 0, 1}};
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_pulled(ball, 1, &pole, 0, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("cannot move: the control points that act there are kept");
    batten_surface_unref(made);
    batten_surface_unref(ball);
}

TEST(pulls_that_cannot_be_are_refused)
{
    test_random random = test_random_begin("refused");
    batten_surface *surface = uneven(&random, false), *none = NULL;
    const batten_surface_pull twice[] = {pulls[0], pulls[0]}, outside = {2, 2.5, {0, 0, 1}},
                              endless = {0.5, 2.5, {0, NAN, 0}};
    CHECK_STATUS(batten_surface_pulled(surface, 2, twice, 0, NULL, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("so near each other");
    CHECK_STATUS(batten_surface_pulled(surface, 1, &outside, 0, NULL, &none),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_surface_pulled(surface, 1, &endless, 0, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_pulled(surface, 0, twice, 0, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_surface_pulled(surface, 1, pulls, -1, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_surface_unref(surface);
}

TEST(the_pull_that_is_not_finite_is_named_among_several)
{
    test_random random = test_random_begin("names");
    batten_surface *surface = uneven(&random, false), *none = NULL;
    for (int which = 0; which < 3; which++)
        for (int number = 0; number < 5; number++) {
            batten_surface_pull bad[3] = {pulls[0], pulls[1], pulls[2]};
            double *numbers[5] = {&bad[which].u, &bad[which].v, &bad[which].by.x,
                                  &bad[which].by.y, &bad[which].by.z};
            char message[60];
            *numbers[number] = number % 2 ? INFINITY : NAN;
            snprintf(message, sizeof message, "pull %d has a number that is not finite",
                     which + 1);
            CHECK_STATUS(batten_surface_pulled(surface, 3, bad, 0, NULL, &none),
                         BATTEN_NOT_FINITE);
            CHECK_MESSAGE(message);
        }
    CHECK_STATUS(batten_surface_pulled(surface, 0, pulls, 0, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there is no place to move");
    CHECK_STATUS(batten_surface_pulled(surface, 1, pulls, -2, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("-2 rows cannot be kept");
    CHECK(!none);
    batten_surface_unref(surface);
}

/* The first control points act here, with weights. */
TEST(places_in_the_first_and_last_spans_of_rational_surfaces_move_exactly)
{
    static const double places[4][2] = {{0.1, 2.2}, {0.05, 3.5}, {0.95, 2.1}, {0, 2}};
    test_random random = test_random_begin("corners");
    batten_surface *surface = uneven(&random, true);
    for (int k = 0; k < COUNT(places); k++) {
        const batten_surface_pull pull = {places[k][0], places[k][1], {0.5, -0.25, 1}};
        batten_surface *made = NULL;
        double was[3], is[3];
        CHECK_OK(batten_surface_pulled(surface, 1, &pull, 0, NULL, &made));
        CHECK_OK(batten_surface_evaluate(surface, pull.u, pull.v, 0, was));
        CHECK_OK(batten_surface_evaluate(made, pull.u, pull.v, 0, is));
        CHECK_NEAR(is[0] - was[0], 0.5, 1e-12);
        CHECK_NEAR(is[1] - was[1], -0.25, 1e-12);
        CHECK_NEAR(is[2] - was[2], 1, 1e-12);
        batten_surface_unref(made);
    }
    batten_surface_unref(surface);
}
