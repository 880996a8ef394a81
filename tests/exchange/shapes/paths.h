/* Models of paths for the writers of DXF, G-code and SVG. */
#ifndef TESTS_PATHS_H
#define TESTS_PATHS_H
#include "support/test.h"
#include <batten/blend.h>
#include <batten/exchange.h>
#include <batten/standard.h>

/* A stadium, closed: two lines of 80 and two half circles of radius 10, counter-clockwise. */
static inline batten_chain *stadium(void)
{
    static const double pi = 3.14159265358979323846;
    const batten_span spans[4] = {
        {.kind = BATTEN_SPAN_ARC, .length = 80, .start = {10, 0}},
        {.kind = BATTEN_SPAN_ARC, .length = 10 * pi, .start = {90, 0}, .curvature = {0.1}},
        {.kind = BATTEN_SPAN_ARC, .length = 80, .start = {90, 20}, .angle = pi},
        {.kind = BATTEN_SPAN_ARC,
         .length = 10 * pi,
         .start = {10, 20},
         .angle = pi,
         .curvature = {0.1}},
    };
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 4, spans, NULL, true}, 1e-12, &chain));
    return chain;
}

/* Three quarters of a circle of radius 5 to the right, from (0, 0) upwards, then a line. */
static inline batten_chain *hook(void)
{
    static const double pi = 3.14159265358979323846;
    const batten_span spans[2] = {
        {.kind = BATTEN_SPAN_ARC, .length = 7.5 * pi, .angle = pi / 2, .curvature = {-0.2}},
        {.kind = BATTEN_SPAN_ARC, .length = 4, .start = {5, -5}, .angle = -pi},
    };
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 2, spans, NULL, false}, 1e-12, &chain));
    return chain;
}

/* Put a chain into a model, and give its reference back. */
static inline void add_chain(batten_model *model, const char *name, const char *layer,
                             batten_chain *chain)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_chain_to_curve(chain, 1e-6, NULL, &curve));
    const batten_object object = {.name = name,
                                  .layer = layer,
                                  .kind = BATTEN_OBJECT_CURVE,
                                  .curve = curve,
                                  .chain = chain};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
    batten_chain_unref(chain);
}

static inline batten_model *model_of(const char *name, batten_chain *chain)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    add_chain(model, name, "", chain);
    return model;
}

/* A rectangle of 80 by 50 at height z from (0, 0), its corners rounded by 10: one NURBS curve.
 */
static inline batten_curve *filleted(double z, int raise)
{
    const double points[5][3] = {{0, 0, z}, {80, 0, z}, {80, 50, z}, {0, 50, z}, {0, 0, z}};
    const double radius = 10;
    batten_curve *polyline = NULL, *round = NULL, *raised = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 5, points[0]}, &polyline));
    CHECK_OK(batten_curve_fillet(polyline, 1, &radius, 1e-9, NULL, &round));
    CHECK_OK(batten_curve_elevate(round, raise, &raised));
    batten_curve_unref(polyline);
    batten_curve_unref(round);
    return raised;
}

/* Put a curve into a model, and give its reference back. */
static inline batten_model *model_of_curve(batten_curve *curve, const char *name)
{
    batten_model *model = NULL;
    const batten_object object = {
        .name = name ? name : "", .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
    return model;
}

/* The model in a format, as a text that the test owns. */
static inline const char *written(const batten_model *model, batten_format format)
{
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = format;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    char *text = test_array(size + 1, 1);
    memcpy(text, data, size);
    batten_release(data);
    return text;
}

#endif
