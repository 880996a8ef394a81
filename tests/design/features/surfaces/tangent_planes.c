#include "design/evaluate.h"

#include <stdlib.h>

#define PI 3.14159265358979323846

/* A square hole in z = 0. Along e1 (y = 0) lies a strip whose slope across is 2 x (1 - x), along
 * e2 (x = 1) a plane: in (1, 0, 0) they ask for twists that differ by 2. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  e1: {line: [[0, 0, 0], [1, 0, 0]]}\n  e2: {line: [[1, 0, 0], [1, 1, 0]]}\n"
    "  e3: {line: [[1, 1, 0], [0, 1, 0]]}\n  e4: {line: [[0, 1, 0], [0, 0, 0]]}\n"
    "  d: {line: [[1, 1, 0], [0, 0, 0]]}\n"
    "  f1: {conic: [[0, -1, 0], [0.5, -1, 1], [1, -1, 0]], weight: 1}\n"
    "  f2: {line: [[2, 0, 0], [2, 1, 0]]}\n"
    "  n1: {ruled: [e1, f1]}\n  n2: {ruled: [e2, f2]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  x: %s\n", common, feature);
    return evaluate_design(text, "x", notes, out);
}

/* Between the normal of a surface and the neighbour's at a place on e1 or e2; 0 elsewhere and
 * at poles. */
static double angle_at(const batten_surface *surface, double u, double v, bool *compared)
{
    double d[3][3];
    CHECK_OK(batten_surface_evaluate(surface, u, v, 1, d[0]));
    const double n[3] = {d[1][1] * d[2][2] - d[1][2] * d[2][1],
                         d[1][2] * d[2][0] - d[1][0] * d[2][2],
                         d[1][0] * d[2][1] - d[1][1] * d[2][0]};
    const double x = d[0][0], y = d[0][1];
    const bool on_strip = fabs(y) < 1e-9, on_plane = fabs(x - 1) < 1e-9;
    const double size = hypot(hypot(n[0], n[1]), n[2]);
    *compared = (on_strip || on_plane) && !(on_strip && on_plane) && size > 1e-12;
    if (!*compared)
        return 0;
    const double slope = on_strip ? 2 * x * (1 - x) : 0, m = hypot(slope, 1);
    const double across[3] = {n[1] - n[2] * slope, -n[0], n[0] * slope};
    return asin(hypot(hypot(across[0], across[1]), across[2]) / (size * m)) * 180 / PI;
}

/* The largest on the surfaces that are delivered, in degrees: 1000 places of each edge, which
 * crowd towards its ends. */
static double measured(const batten_model *model)
{
    double worst = 0;
    int count = 0;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_surface *surface = batten_model_object(model, i)->surface;
        CHECK_TEXT(batten_surface_kind(surface), "nurbs");
        const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                              v = batten_surface_domain(surface, BATTEN_V);
        for (int edge = 0; edge < 4; edge++)
            for (int k = 1; k < 1000; k++) {
                const double s = 0.5 - 0.5 * cos(k * PI / 1000), high = edge % 2;
                const double a = edge < 2 ? s : high, b = edge < 2 ? high : s;
                bool compared;
                const double angle =
                    angle_at(surface, u.a + a * (u.b - u.a), v.a + b * (v.b - v.a), &compared);
                worst = fmax(worst, angle);
                count += compared;
            }
    }
    CHECK(count > 1750);
    return worst;
}

TEST(tangent_planes_of_what_is_delivered_are_within_the_angle)
{
    static const struct {
        const char *feature;
        double most;
    } rows[] = {
        {"{coons: [e1, e2, e3, e4], along: [n1, n2]}", 0.01},
        {"{coons: [e1, e2, e3, e4], along: [n1, n2], angle: 0.002 deg}", 0.002},
        {"{triangle-patch: [e1, e2, d], along: [n1, n2]}", 0.1},
        {"{triangle-patch: [e1, e2, d], along: [n1, n2], method: corners, angle: 0.05 deg}",
         0.05},
        {"{triangle-patch: [e1, e2, d], along: [n1, n2], method: parallels, angle: 0.2 deg}",
         0.2},
        {"{fill: [e1, e2, e3, e4], along: [n1, n2], form: kato, angle: 0.2 deg}", 0.2},
        {"{fill: [e1, e2, e3, e4], along: [n1, n2], form: charrot-gregory, angle: 0.05 deg}",
         0.05},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(20, &notes));
        CHECK_OK(evaluate(rows[i].feature, notes, &design));
        const double worst = measured(batten_design_result(design, "x")->value);
        if (!(worst <= rows[i].most))
            printf("%s: %g degrees\n", rows[i].feature, worst);
        CHECK(worst <= rows[i].most);
        /* and what is said of them is what was measured, but for the places */
        double said = -1;
        for (int k = 0; k < batten_notes_count(notes); k++) {
            const char *text = batten_notes_at(notes, k)->text;
            CHECK(!strstr(text, "all slopes hold"));
            const char *at = strstr(text, "are kept to ");
            if (!at)
                at = strstr(text, "differ by up to ");
            if (at)
                said = fmax(said, strtod(at + strcspn(at, "0123456789"), NULL));
        }
        CHECK(batten_notes_dropped(notes) > 0 || said >= 0.9 * worst);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

TEST(an_angle_that_no_spline_keeps_is_refused_with_the_angle_reached)
{
    batten_design *design = NULL;
    CHECK_STATUS(
        evaluate("{coons: [e1, e2, e3, e4], along: [n1, n2], angle: 1e-13 deg}", NULL, &design),
        BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("control points leave the normals of the coons surface by");
    batten_design_free(design);
}

/* Only the neighbour that has none of the curves as its edge is named. */
TEST(a_neighbour_of_a_triangle_patch_without_a_common_edge_is_noted)
{
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    int far = 0, others = 0;
    CHECK_OK(batten_notes_create(50, &notes));
    CHECK_OK(evaluate("{triangle-patch: [e1, e2, d], along: [n1, n2, far]}\n  far: {bilinear: "
                      "[[0, 0, 9], [1, 0, 9], [1, 1, 9], [0, 1, 9]]}",
                      notes, &design));
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const char *text = batten_notes_at(notes, i)->text;
        if (strstr(text, "has none of the curves as its edge, within ")) {
            far += strncmp(text, "'far'", 5) == 0;
            others += strncmp(text, "'far'", 5) != 0;
        }
    }
    CHECK_INT(others, 0);
    CHECK(far >= 1 || batten_notes_dropped(notes) > 0);
    batten_notes_free(notes);
    batten_design_free(design);
}

/* The strip rises by 45 degrees, the curves beside it leave level; what is repaired gives way. */
TEST(an_angle_that_is_asked_for_of_a_repaired_patch_is_noted_when_it_is_missed)
{
    static const char *const policies[] = {"gregory", "mean"};
    for (int i = 0; i < COUNT(policies); i++) {
        char feature[300];
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        bool said = false;
        CHECK_OK(batten_notes_create(100, &notes));
        snprintf(feature, sizeof feature,
                 "{coons: [e1, e2, e3, e4], along: strip, repair: yes, policy: %s, angle: 1 "
                 "deg}\n  strip: {extrude: e1, along: [0, -1, -1]}",
                 policies[i]);
        CHECK_OK(evaluate(feature, notes, &design));
        for (int k = 0; k < batten_notes_count(notes); k++)
            said |= strstr(batten_notes_at(notes, k)->text,
                           "up to 45 degrees off the tangent planes along") != NULL;
        CHECK(said || batten_notes_dropped(notes) > 0);
        batten_notes_free(notes);
        batten_design_free(design);
    }
}
