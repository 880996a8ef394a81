#include "body/trace/traced.h"
#include "support/test.h"
#include <batten/body.h>
#include <batten/standard.h>

static const batten_frame WORLD = {.x = {1, 0, 0}, .z = {0, 0, 1}};

static void check_counts(const batten_body *body, int vertices, int edges, int poles)
{
    const batten_body_parts *p = batten_body_view(body);
    int points = 0;
    for (int i = 0; i < p->edge_count; i++)
        points += !p->edges[i].curve;
    CHECK_INT(p->vertex_count, vertices);
    CHECK_INT(p->edge_count, edges);
    CHECK_INT(points, poles);
    CHECK_INT(p->use_count, 4);
    CHECK_INT(p->face_count, 1);
}

TEST(a_surface_as_a_body_has_its_border_as_edges)
{
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){2, 0, 0},
                                     (batten_vec3){0, 1, 0}, (batten_vec3){2, 1, 1}, &surface));
    CHECK_OK(batten_body_from_surface("plate", surface, 1e-6, &body));
    check_counts(body, 4, 4, 0);
    check_traced(body, 1e-14);
    CHECK(!batten_body_view(body)->shells[0].closed);
    CHECK_TEXT(batten_body_view(body)->faces[0].name, "plate");
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(a_surface_that_closes_has_a_seam_that_is_used_twice)
{
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_cylinder(&WORLD, 2, 5, &surface));
    CHECK_OK(batten_body_from_surface(NULL, surface, 1e-6, &body));
    check_counts(body, 2, 3, 0);
    check_traced(body, 1e-14);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(a_sphere_as_a_body_has_a_seam_and_two_poles)
{
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_sphere(&WORLD, 2, &surface));
    CHECK_OK(batten_body_from_surface("", surface, 1e-6, &body));
    check_counts(body, 2, 3, 2);
    check_traced(body, 1e-14);
    CHECK(batten_body_view(body)->shells[0].closed);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(a_torus_as_a_body_has_two_seams_and_one_vertex)
{
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_torus(&WORLD, 3, 1, &surface));
    CHECK_OK(batten_body_from_surface("", surface, 1e-6, &body));
    check_counts(body, 1, 2, 0);
    check_traced(body, 1e-14);
    CHECK(batten_body_view(body)->shells[0].closed);
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(a_periodic_surface_as_a_body_is_clamped)
{
    const double u[] = {0, 1, 2, 3, 4}, v[] = {0, 0, 1, 1};
    const double points[] = {1,  0, 0, 1,  0, 3, 0, 1,  0, 0, 1,  3,
                             -1, 0, 0, -1, 0, 3, 0, -1, 0, 0, -1, 3};
    const batten_axis along = {3, 4, u, true}, across = {1, 2, v, false};
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_create(3, &along, &across, points, NULL, &surface));
    CHECK_OK(batten_body_from_surface("", surface, 1e-6, &body));
    check_counts(body, 2, 3, 0);
    check_traced(body, 1e-14);
    CHECK(!batten_surface_is_periodic(batten_body_view(body)->faces[0].surface, BATTEN_U));
    batten_body_unref(body);
    batten_surface_unref(surface);
}

TEST(a_flat_surface_is_no_body)
{
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 0, 1, 1, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    CHECK_OK(batten_surface_create(2, &axis, &axis, points, NULL, &surface));
    CHECK_STATUS(batten_body_from_surface("", surface, 1e-6, &body), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("2 dimensions");
    CHECK_STATUS(batten_body_from_surface("", surface, 0, &body), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    batten_surface_unref(surface);
}

/* Knots that are loose at one end alone, in either direction. */
TEST(a_surface_that_is_not_clamped_at_one_end_is_clamped_there)
{
    static const double loose[2][6] = {{0, 0, 0, 1, 2, 3}, {-2, -1, 0, 1, 1, 1}};
    static const double line[] = {0, 0, 1, 1};
    static const double points[] = {0, 0, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1, 2, 0, 0, 2, 0, 1};
    for (int i = 0; i < 4; i++) {
        const batten_axis bent = {2, 3, loose[i % 2], false}, straight = {1, 2, line, false};
        const batten_direction direction = i / 2 ? BATTEN_V : BATTEN_U;
        batten_surface *surface = NULL, *turned = NULL;
        batten_body *body = NULL;
        CHECK_OK(batten_surface_create(3, &bent, &straight, points, NULL, &surface));
        if (direction == BATTEN_V)
            CHECK_OK(batten_surface_swap(surface, &turned));
        const batten_surface *of = turned ? turned : surface;
        CHECK_OK(batten_body_from_surface("", of, 1e-6, &body));
        const batten_surface *made = batten_body_view(body)->faces[0].surface;
        const double *knots = batten_surface_knots(made, direction);
        CHECK(knots[0] == knots[2] && knots[3] == knots[5]);
        for (int k = 0; k <= 4; k++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(of, k / 4.0, 0.25 * k, 0, p));
            CHECK_OK(batten_surface_evaluate(made, k / 4.0, 0.25 * k, 0, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c], p[c], 1e-14);
        }
        check_counts(body, 4, 4, 0);
        batten_body_unref(body);
        batten_surface_unref(turned);
        batten_surface_unref(surface);
    }
}
