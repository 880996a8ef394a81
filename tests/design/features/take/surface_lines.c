#include "design/evaluate.h"

#include <batten/measure.h>
#include <math.h>
#include <stdio.h>

/* Notes are made anew each time. */
static batten_status evaluate(const char *feature, batten_notes **notes, batten_design **out)
{
    char text[1000];
    if (notes) {
        batten_notes_free(*notes);
        *notes = NULL;
        const batten_status status = batten_notes_create(20, notes);
        if (status != BATTEN_OK)
            return status;
    }
    snprintf(text, sizeof text,
             "batten: 1\nunits: m\ntolerance: 1 mm\nfeatures:\n"
             "  ring: {torus: 3 m, minor: 1 m}\n  ball: {sphere: 2 m, at: [20, 0, 0]}\n"
             "  can: {cylinder: 2 m, height: 5 m}\n"
             "  saddle: {bilinear: [[0, 0, 0], [2, 0, 0], [2, 2, 4], [0, 2, 0]]}\n  a: %s\n",
             feature);
    return evaluate_design(text, "a", notes ? *notes : NULL, out);
}

/* Without memory notes are dropped, and counted. */
static void check_said(const batten_notes *notes, const char *words)
{
    bool is_said = batten_notes_dropped(notes) > 0;
    for (int i = 0; i < batten_notes_count(notes); i++)
        is_said |= strstr(batten_notes_at(notes, i)->text, words) != NULL;
    CHECK(is_said);
}

static const batten_object *object_of(const batten_design *design, int i)
{
    return batten_model_object(batten_design_result(design, "a")->value, i);
}

/* The largest height and radius about the z-axis of a curve, and the least. */
static void find_ranges(const batten_curve *curve, double heights[2], double radii[2])
{
    const batten_interval domain = batten_curve_domain(curve);
    heights[0] = radii[0] = HUGE_VAL;
    heights[1] = radii[1] = -HUGE_VAL;
    for (int i = 0; i <= 400; i++) {
        double p[3];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 400, 0, p));
        const double radius = hypot(p[0], p[1]);
        heights[0] = fmin(heights[0], p[2]);
        heights[1] = fmax(heights[1], p[2]);
        radii[0] = fmin(radii[0], radius);
        radii[1] = fmax(radii[1], radius);
    }
}

/* On the inner equator of a ring, 2 from the axis, normal curvatures are 1 and -1/2. */
TEST(lines_of_curvature_of_a_ring_are_its_circles_named_by_their_curvature)
{
    batten_design *design = NULL;
    double heights[2], radii[2];
    CHECK_OK(
        evaluate("{surface-lines: ring, through: [[2, 0, 0]], within: 1e-6}", NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK_INT(batten_model_count(result->value), 2);
    CHECK(result->error_max <= 1e-6);
    int around = -1;
    for (int i = 0; i < 2; i++) {
        find_ranges(object_of(design, i)->curve, heights, radii);
        if (radii[1] < 3)
            around = i;
        else
            CHECK_NEAR(heights[1], 1, 1e-4);
        CHECK_NEAR(radii[0], 2, 1e-6);
        CHECK_NEAR(radii[1], radii[1] < 3 ? 2 : 4, 1e-4);
    }
    CHECK(around >= 0);
    CHECK_TEXT(object_of(design, 0)->name, "ring curvature1 1");
    CHECK_TEXT(object_of(design, 1)->name, "ring curvature2 1");
    batten_design_free(design);
}

TEST(a_line_of_curvature_of_one_kind_starts_at_each_point)
{
    static const char *const kinds[] = {"curvature1", "curvature2"};
    double lengths[2];
    for (int k = 0; k < 2; k++) {
        char feature[200], name[40];
        batten_design *design = NULL;
        snprintf(feature, sizeof feature,
                 "{surface-lines: ring, through: [[4, 0, 0], [0, 2, 0]], kind: %s}", kinds[k]);
        CHECK_OK(evaluate(feature, NULL, &design));
        CHECK_INT(batten_model_count(batten_design_result(design, "a")->value), 2);
        snprintf(name, sizeof name, "ring %s 2", kinds[k]);
        CHECK_TEXT(object_of(design, 1)->name, name);
        CHECK_OK(batten_curve_length(object_of(design, 0)->curve, 1e-6, NULL, &lengths[k]));
        batten_design_free(design);
    }
    CHECK_NEAR(fmin(lengths[0], lengths[1]), 2 * acos(-1), 1e-3);
    CHECK_NEAR(fmax(lengths[0], lengths[1]), 8 * acos(-1), 1e-3);
}

/* Helices with the slope they start with, from the middle to either rim. */
TEST(geodesics_of_a_cylinder_are_helices_in_each_direction_asked_for)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    CHECK_OK(evaluate("{surface-lines: can, through: [[2, 0, 2]], kind: geodesic, "
                      "direction: [[0, 3, 4], [0, -3, -4]], within: 1e-6}",
                      &notes, &design));
    static const double ends[2] = {5, 0};
    for (int i = 0; i < 2; i++) {
        const batten_curve *curve = object_of(design, i)->curve;
        const batten_interval domain = batten_curve_domain(curve);
        double p[3];
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 0, p));
        const double turned = (ends[i] - 2) * 0.75 / 2;
        CHECK_NEAR(p[2], ends[i], 1e-6);
        CHECK_NEAR(p[0], 2 * cos(turned), 2e-6);
        CHECK_NEAR(p[1], 2 * sin(turned), 2e-6);
    }
    CHECK_TEXT(object_of(design, 1)->name, "can geodesic 2");
    check_said(notes,
               "'can geodesic 1': 3.75 m long; it begins at its point and ends on the rim");
    batten_notes_free(notes);
    batten_design_free(design);
}

/* z = x y: straight lines along x and y. */
TEST(asymptotic_lines_of_a_saddle_are_its_rulings)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{surface-lines: saddle, through: [[0.5, 1.5, 0.75]], kind: asymptotic, "
                      "within: 1e-6}",
                      NULL, &design));
    CHECK_INT(batten_model_count(batten_design_result(design, "a")->value), 2);
    int along_x = 0;
    for (int i = 0; i < 2; i++) {
        const batten_curve *curve = object_of(design, i)->curve;
        const batten_interval domain = batten_curve_domain(curve);
        double a[3], b[3];
        CHECK_OK(batten_curve_evaluate(curve, domain.a, 0, a));
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 0, b));
        const int axis = fabs(b[0] - a[0]) > 1 ? 0 : 1;
        along_x += axis == 0;
        CHECK_NEAR(fabs(b[axis] - a[axis]), 2, 1e-6);
        CHECK_NEAR(a[1 - axis], axis == 0 ? 1.5 : 0.5, 1e-6);
        CHECK_NEAR(b[1 - axis], a[1 - axis], 1e-6);
    }
    CHECK_INT(along_x, 1);
    batten_design_free(design);
}

TEST(a_length_ends_lines_on_both_sides_and_points_go_to_the_nearest_surface)
{
    batten_notes *notes = NULL;
    batten_design *design = NULL;
    double length = 0;
    CHECK_OK(evaluate("{surface-lines: [ball, ring, can], through: [[4.25, 0, 0]], "
                      "kind: curvature1, length: 50 cm, within: 1e-6}",
                      &notes, &design));
    CHECK_INT(batten_model_count(batten_design_result(design, "a")->value), 1);
    CHECK_OK(batten_curve_length(object_of(design, 0)->curve, 1e-9, NULL, &length));
    CHECK_NEAR(length, 1, 1e-6);
    check_said(notes, "point 1 is 0.25 m off 'ring'");
    check_said(notes, "'can' has no line: no point is nearest to it");
    check_said(notes, "1 m long; it begins where it is as long as "
                      "asked for and ends where it is as long as");
    batten_notes_free(notes);
    batten_design_free(design);
}

TEST(lines_without_a_direction_are_refused_by_name)
{
    static const struct {
        const char *feature;
        batten_status status;
        const char *said;
    } rows[] = {
        {"{surface-lines: ring, through: [[4, 0, 0]], kind: geodesic}", BATTEN_BAD_ARGUMENT,
         "geodesics want a 'direction'"},
        {"{surface-lines: ring, through: [[4, 0, 0]], direction: [0, 0, 1]}",
         BATTEN_BAD_ARGUMENT, "'direction' is for geodesics"},
        {"{surface-lines: ball, through: [[18, 0.1, 0]]}", BATTEN_SINGULAR_HERE, "line 1: "},
        {"{surface-lines: ring, through: [[2, 0, 0], [4, 0, 0]], kind: asymptotic}",
         BATTEN_SINGULAR_HERE, "line 2: "},
        {"{surface-lines: ring, through: [[4, 0, 0]], within: -1}", BATTEN_BAD_ARGUMENT, ""},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, NULL, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].said);
        CHECK(!design);
    }
}
