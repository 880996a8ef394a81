#include "exchange/step/references.h"
#include "support/bodies.h"

#include <batten/standard.h>

/* A rectangle 3 x 4: its diagonal is 5, times the scale. */
static void add_rectangle(batten_model *model, double scale)
{
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 0}, (batten_vec3){3 * scale, 0, 0},
                                     (batten_vec3){0, 4 * scale, 0},
                                     (batten_vec3){3 * scale, 4 * scale, 0}, &surface));
    add_surface(model, "side", surface);
    batten_surface_unref(surface);
}

static void add_box(batten_model *model, double size, double tolerance)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){size, size, size}),
                *made = NULL;
    batten_body_parts parts = *batten_body_view(box);
    parts.tolerance = tolerance;
    CHECK_OK(batten_body_create(&parts, &made));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "box", .kind = BATTEN_OBJECT_BODY, .body = made}));
    batten_body_unref(made);
    batten_body_unref(box);
}

/* What the file says. */
static double accuracy_of(const batten_model *model)
{
    const char *at =
        strstr(step_text(model, NULL), "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(");
    CHECK(at != NULL);
    return strtod(strstr(at, "MEASURE(") + 8, NULL);
}

TEST(a_small_surface_or_body_asks_for_a_thousandth_of_its_size)
{
    static const double scales[] = {1, 1e-3, 1e-4, 2e-5};
    for (int i = 0; i < COUNT(scales); i++) {
        batten_model *model = NULL, *body = NULL;
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_model_create(1, &body));
        add_rectangle(model, 1);
        add_rectangle(model, scales[i]);
        add_rectangle(model, 2);
        CHECK_NEAR(accuracy_of(model), fmin(1e-6, 5e-3 * scales[i]), 1e-18);
        add_box(body, scales[i], 1e-9 * scales[i]);
        CHECK_NEAR(accuracy_of(body), fmin(1e-6, sqrt(3) * 1e-3 * scales[i]), 1e-18);
        batten_model_unref(body);
        batten_model_unref(model);
    }
}

/* Curves of bodies may miss their vertices by more than a micrometre; the loosest body counts. */
TEST(a_loose_body_is_no_more_accurate_than_it_is)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    add_box(model, 1, 1e-9);
    CHECK_NEAR(accuracy_of(model), 1e-6, 1e-18);
    add_box(model, 1, 0.25e-3);
    add_box(model, 1, 1e-5);
    CHECK_NEAR(accuracy_of(model), 0.25e-3, 1e-18);
    batten_model_unref(model);
}

/* Curves, and what is one point, say nothing of it. */
TEST(curves_and_points_leave_the_accuracy_at_a_micrometre)
{
    const double ends[] = {0, 0, 0, 1e-5, 0, 0};
    batten_curve *line = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_curve_line(3, ends, ends + 3, &line));
    add_curve(model, "short", line);
    add_rectangle(model, 0);
    CHECK_NEAR(accuracy_of(model), 1e-3, 1e-15);
    batten_curve_unref(line);
    batten_model_unref(model);
}
