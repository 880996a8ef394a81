#include "design/evaluate.h"
#include "design/expect.h"
#include "design/features/change/fair_row.h"

static const char design_of_nets[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  flat: {points: [[0, 0, 2], [1, 1, 2], [2, 1.6, 2], [3, 2.4, 2], [4, 2.3, 2], [5, 2.4, 2], [6, "
    "1.9, 2], [7, 1.2, 2], [8, 0, 2]]}\n"
    "  lifted: {points: [[0, 0, 0], [1, 1, 1], [2, 1.6, 1], [3, 2.4, 2], [4, 2.3, 3], [5, 2.4, 2], [6, "
    "1.9, 2]]}\n"
    "  ring: {points: [[1, 0, 2], [0.7, 0.8, 2], [-0.6, 0.7, 2], [-1, 0.1, 2], [-0.7, -0.7, 2], [0.7, "
    "-0.7, 2]]}\n"
    "  a: {b-spline: flat}\n"
    "  s: {b-spline: lifted}\n"
    "  r: {b-spline: ring, ends: closed}\n"
    "  all: {collect: [a, s, r]}\n"
    "  f: {fair: all, within: 0.05, method: %s}\n";

static double farthest(const batten_curve *a, const batten_curve *b)
{
    const batten_interval domain = batten_curve_domain(a);
    double worst = 0, p[3], q[3];
    for (int k = 0; k <= 1000; k++) {
        const double u = fmin(domain.b, domain.a + (domain.b - domain.a) * k / 1000);
        CHECK_OK(batten_curve_evaluate(a, u, 0, p));
        CHECK_OK(batten_curve_evaluate(b, u, 0, q));
        worst = fmax(worst, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
    }
    return worst;
}

TEST(control_points_of_curves_in_planes_in_space_and_closed_move_within_the_bound)
{
    static const char *const methods[] = {"farin-sapidis", "eck-hadenfeld"};
    for (int k = 0; k < COUNT(methods); k++) {
        char text[1200];
        batten_design *design = NULL;
        double reached = 0;
        snprintf(text, sizeof text, design_of_nets, methods[k]);
        CHECK_OK(evaluate_design(text, "f", NULL, &design));
        const batten_feature_result *result = batten_design_result(design, "f");
        for (int i = 0; i < 3; i++) {
            static const char *const given[] = {"a", "s", "r"};
            const batten_curve *
                from =
                   batten_model_object(batten_design_result(design, given[i])->value, 0)->curve,
               *to = batten_model_object(result->value, i)->curve;
            const double moved = farthest(from, to);
            CHECK(moved > 0.02 && moved <= 0.05);
            CHECK_INT(batten_curve_is_periodic(to), i == 2);
            CHECK_INT(batten_curve_point_count(to), batten_curve_point_count(from));
            for (int j = 0; i != 1 && j < batten_curve_point_count(to); j++)
                CHECK(batten_curve_points(to)[3 * j + 2] == 2);
            reached = fmax(reached, moved);
        }
        CHECK(result->move_max >= reached && result->move_max <= 0.05);
        CHECK(result->fairing->after.jumps < result->fairing->before.jumps);
        for (int i = 0; i < result->fairing->move_count; i++)
            CHECK(result->fairing->moves[i].set == 1 || result->fairing->moves[i].to[2] == 2);
        batten_design_free(design);
    }
}

TEST(a_method_refuses_what_has_nothing_that_it_moves)
{
    batten_design *design = NULL;
    char text[1200];
    snprintf(text, sizeof text, "%s  f: {fair: p, within: 0.05, method: eck-hadenfeld}\n",
             design_of_row);
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("'p' is not a curve, and this method moves control points of curves");
    batten_design_free(design);
    snprintf(text, sizeof text,
             "batten: 1\nfeatures:\n  c: {circle: 1}\n"
             "  f: {fair: c, within: 0.05, method: least-change}\n");
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("take 'method: farin-sapidis' or 'eck-hadenfeld'");
    batten_design_free(design);
    snprintf(text, sizeof text,
             "%s  c: {polyline: p}\n"
             "  f: {fair: c, within: 0.05, method: eck-hadenfeld}\n",
             design_of_row);
    CHECK_STATUS(evaluate_design(text, "f", NULL, &design), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("'c': a polyline has corners");
    batten_design_free(design);
}

/* The distance in the reports is that of the curve, the number that of a control point. */
TEST(reports_name_control_points_and_the_way_of_the_curve)
{
    char text[1400];
    batten_design *design = NULL;
    const int end = snprintf(text, sizeof text, design_of_nets, "eck-hadenfeld");
    snprintf(text + end, sizeof text - (size_t)end,
             "outputs:\n  r.txt: {check: f}\n  r.json: {check: f}\n");
    CHECK_OK(evaluate_design(text, "f", NULL, &design));
    CHECK(batten_design_result(design, "f")->fairing->control_points);
    static const char *const words[2][2] = {
        {" control points moved, the curve by at most ", ", control point "},
        {"\"control_points\": true", "\"moved\": {"}};
    for (int k = 0; k < 2; k++) {
        char *data = NULL;
        size_t size;
        CHECK_OK(batten_design_output(design, k, NULL, NULL, &data, &size));
        for (int i = 0; i < 2; i++)
            CHECK_CONTAINS(data, words[k][i]);
        batten_release(data);
    }
    batten_design_free(design);
}
