/* Loops whose edges miss each other within the tolerance are closed: halfway, or on a line. */
#include "body/by_hand.h"
#include "support/test.h"

#include <batten/standard.h>

/* The second edge begins this far beside the end of the first. */
static batten_body *gaping(const double (*corners)[2], double dx, double dy)
{
    hand m = hand_begin();
    int vertices[3], edge;
    batten_body *body = NULL, *traced = NULL;
    for (int i = 0; i < 3; i++)
        CHECK_OK(bat_builder_vertex(&m.builder, (double[]){corners[i][0], corners[i][1], 0},
                                    &vertices[i]));
    for (int i = 0; i < 3; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % 3];
        const double from[3] = {a[0] + (i == 1 ? dx : 0), a[1] + (i == 1 ? dy : 0), 0};
        const double to[3] = {b[0], b[1], 0};
        batten_curve *line = NULL;
        CHECK_OK(batten_curve_line(3, from, to, &line));
        CHECK_OK(bat_builder_edge(&m.builder, line, vertices[i], vertices[(i + 1) % 3], &edge));
        batten_curve_unref(line);
    }
    hand_plate(&m, 0, 0, 1, 1, 0); /* whose parameters are x and y */
    HAND_LOOP(&m, 1, 2, 3);
    m.builder.parts.tolerance = 1e-5;
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_body_trace(body, 1e-5, NULL, NULL, NULL, &traced));
    batten_body_unref(body);
    return traced;
}

static void check_joint(const batten_body *body, double x, double y)
{
    const batten_body_parts *p = batten_body_view(body);
    CHECK_INT(p->use_count, 3);
    for (int k = 0; k < 2; k++) {
        const batten_curve *curve = p->uses[k].parameters;
        const batten_interval on = batten_curve_domain(curve);
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, k == 0 ? on.b : on.a, 0, at));
        CHECK_NEAR(at[0], x, 1e-12);
        CHECK_NEAR(at[1], y, 1e-12);
    }
}

TEST(edges_meet_halfway_or_on_the_line_that_one_of_them_is)
{
    static const double oblique[3][2] = {{0.1, 0.2}, {0.9, 0.3}, {0.3, 0.8}};
    static const double level[3][2] = {{0.1, 0.25}, {0.875, 0.25}, {0.3, 0.8}};
    static const double upright[3][2] = {{0.1, 0.2}, {0.875, 0.25}, {0.875, 0.8}};
    batten_body *body = gaping(oblique, 4e-6, -2e-6);
    check_joint(body, 0.9 + 2e-6, 0.3 - 1e-6);
    batten_body_unref(body);
    body = gaping(level, 4e-6, -2e-6); /* the first runs at y = 0.25 */
    check_joint(body, 0.875 + 2e-6, 0.25);
    batten_body_unref(body);
    body = gaping(upright, 0, -2e-6); /* the second runs at x = 0.875 */
    check_joint(body, 0.875, 0.25 - 1e-6);
    batten_body_unref(body);
}
