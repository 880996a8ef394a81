#include "support/test.h"

#include <batten/design.h>

/* Evaluate one feature and hand its first curve over. */
static batten_status make(const char *feature, batten_design **design)
{
    char text[400];
    snprintf(text, sizeof text, "batten: 1\nfeatures:\n  a: %s\n", feature);
    batten_design *made = NULL;
    batten_status status = batten_design_parse(text, strlen(text), NULL, NULL, &made);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(made, "a", NULL, NULL);
    if (status == BATTEN_OK)
        *design = made;
    else
        batten_design_free(made);
    return status;
}

TEST(shapes_stand_in_the_frame_of_their_axis)
{
    static const struct {
        const char *feature;
        double x, y, z; /* the start of the curve */
    } rows[] = {
        {"{circle: 2}", 2, 0, 0},
        {"{circle: 2, at: [1, 2, 3]}", 3, 2, 3},
        {"{circle: 2, axis: x}", 0, 2, 0},
        {"{circle: 2, axis: x, from: z}", 0, 0, 2},
        {"{circle: 2, axis: -z}", 2, 0, 0},
        {"{arc: 2, start: 90 deg, angle: 90 deg}", 0, 2, 0},
        {"{ellipse: 2, b: 1, start: 90 deg, angle: 90 deg, axis: y}", 0, 0, 1},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(make(rows[i].feature, &design));
        const batten_object *object =
            batten_model_object(batten_design_result(design, "a")->value, 0);
        double p[3];
        CHECK_OK(
            batten_curve_evaluate(object->curve, batten_curve_domain(object->curve).a, 0, p));
        CHECK_NEAR(p[0], rows[i].x, 1e-14);
        CHECK_NEAR(p[1], rows[i].y, 1e-14);
        CHECK_NEAR(p[2], rows[i].z, 1e-14);
        batten_design_free(design);
    }
}

TEST(directions_without_a_length_are_refused)
{
    static const char *const rows[] = {"{circle: 2, axis: origin}", "{circle: 2, from: origin}",
                                       "{circle: 2, from: z}", "{circle: 2, axis: x, from: -x}",
                                       "{cylinder: 1, height: 1, axis: [0, 0, 0]}"};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(make(rows[i], &design), BATTEN_BAD_ARGUMENT);
        CHECK(design == NULL);
    }
}
