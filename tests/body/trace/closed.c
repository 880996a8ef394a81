/* Faces of closed surfaces, wherever their loops lie. */
#include "body/by_hand.h"
#include "body/trace/lift.h"
#include "support/test.h"
#include <batten/standard.h>
#include <stdlib.h>

/* An ellipse in (u, v), on the surface and turned about the z-axis: an edge of the model. The
 * centre may be anywhere; where the surface closes, it is the same there. */
static int ellipse_on(hand *m, const batten_surface *surface, double u, double v, double ru,
                      double rv, double turn)
{
    enum { COUNT = 96 };
    const batten_interval along = batten_surface_domain(surface, BATTEN_U),
                          across = batten_surface_domain(surface, BATTEN_V);
    double values[(COUNT + 1) * 6], t[COUNT + 1];
    for (int i = 0; i <= COUNT; i++) {
        const double angle = 2 * acos(-1) * (i % COUNT) / COUNT;
        double at[2] = {u + ru * cos(angle), v + rv * sin(angle)}, s[9];
        const double d[2] = {-ru * sin(angle), rv * cos(angle)};
        at[0] -= floor((at[0] - along.a) / (along.b - along.a)) * (along.b - along.a);
        at[1] -= floor((at[1] - across.a) / (across.b - across.a)) * (across.b - across.a);
        CHECK_OK(batten_surface_evaluate(surface, at[0], at[1], 1, s));
        t[i] = i == COUNT ? 2 * acos(-1) : 2 * acos(-1) * i / COUNT;
        for (int k = 0; k < 3; k++) {
            values[6 * i + k] = s[k];
            values[6 * i + 3 + k] = s[3 + k] * d[0] + s[6 + k] * d[1];
        }
    }
    batten_curve *curve = NULL, *turned = NULL;
    CHECK_OK(batten_curve_from_hermite(3, COUNT + 1, 2, t, values, &curve));
    const batten_affine map =
        batten_affine_rotation((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, turn);
    CHECK_OK(batten_curve_transform(curve, &map, &turned));
    batten_curve_unref(curve);
    return hand_edge(m, turned);
}

static double total_area(const batten_surface *surface)
{
    batten_body *body = NULL;
    CHECK_OK(batten_body_from_surface("", surface, 1e-6, &body));
    const double area = hand_area(body);
    batten_body_unref(body);
    return area;
}

static double loop_area(batten_surface *surface, const double *e, double turn, int way)
{
    hand m = hand_begin();
    batten_body_trace_report report;
    ellipse_on(&m, surface, e[0], e[1], e[2], e[3], turn);
    hand_face(&m, batten_surface_ref(surface), false);
    HAND_LOOP(&m, way);
    batten_body *body = hand_trace(&m, 1e-3, &report);
    CHECK_INT(report.failed, 0);
    const double area = hand_area(body);
    batten_body_unref(body);
    return area;
}

TEST(the_area_in_a_loop_does_not_depend_on_where_the_seams_are)
{
    test_random random = test_random_begin("loops on closed surfaces");
    batten_surface *surfaces[2] = {hand_torus(), NULL};
    CHECK_OK(batten_surface_sphere(&hand_world, 2, &surfaces[1]));
    for (int s = 0; s < 2; s++) {
        const double all = total_area(surfaces[s]);
        for (int i = 0; i < test_cases(12); i++) {
            const double rv = test_random_in(&random, 0.05, 0.4);
            const double e[4] = {0.5,
                                 s ? test_random_in(&random, rv + 0.01, 0.99 - rv)
                                   : test_random_in(&random, 0, 1),
                                 test_random_in(&random, 0.05, 0.45), rv};
            const double area = loop_area(surfaces[s], e, 0, 1);
            const double turn = test_random_in(&random, -10, 10);
            CHECK_NEAR(loop_area(surfaces[s], e, turn, 1), area, 0.02);
            CHECK_NEAR(loop_area(surfaces[s], e, turn, -1), all - area, 0.02);
        }
    }
    batten_surface_unref(surfaces[0]);
    batten_surface_unref(surfaces[1]);
}

/* A disc and a cylinder share their circle; the cylinder ends where its surface does, at a rim
 * that no loop says. It is no closed body then, although every edge it was given has two uses.
 */
TEST(a_body_whose_face_ends_with_its_surface_is_not_closed)
{
    hand m = hand_begin();
    batten_surface *plane = NULL;
    batten_body *body = NULL;
    batten_body_trace_report report;
    batten_body_measures measures;
    hand_arc(&m, 3, 1, 0, 360);
    CHECK_OK(batten_surface_bilinear((batten_vec3){-4, -4, 1}, (batten_vec3){4, -4, 1},
                                     (batten_vec3){-4, 4, 1}, (batten_vec3){4, 4, 1}, &plane));
    hand_face(&m, plane, true);
    HAND_LOOP(&m, -1);
    hand_face(&m, hand_cylinder(3, 6), false);
    HAND_LOOP(&m, 1);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    batten_body *traced = NULL;
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, &report, &traced));
    CHECK_INT(report.rims, 1);
    CHECK_INT(report.failed, 0);
    for (int k = 0; k < 2; k++) {
        CHECK_OK(batten_body_measure(k ? traced : body, 1e-9, NULL, &measures));
        CHECK(!measures.is_closed);
        CHECK_BITS(measures.volume, 0);
        CHECK_NEAR(measures.area, 9 * acos(-1) + 6 * acos(-1) * 5, 1e-6);
    }
    batten_body_unref(traced);
    batten_body_unref(body);
}
