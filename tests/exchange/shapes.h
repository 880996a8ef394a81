/* Models of random shapes, and their comparison bit for bit. */
#ifndef TESTS_EXCHANGE_SHAPES_H
#define TESTS_EXCHANGE_SHAPES_H
#include "exchange/reading.h"

enum { SHAPES_DEGREE = 5, SHAPES_POINTS = 9, SHAPES_KNOTS = SHAPES_DEGREE + SHAPES_POINTS + 1 };

/* A size from 1e-9 to 1e9 now and then, else of the order of 1. */
static inline double random_number(test_random *random)
{
    const double sign = test_random_int(random, 0, 1) ? 1 : -1;
    switch (test_random_int(random, 0, 9)) {
    case 0:
        return sign * 0.0;
    case 1:
        return sign * pow(10, test_random_in(random, -9, 9));
    case 2:
        return test_random_int(random, -3, 3);
    default:
        return test_random_in(random, -10, 10);
    }
}

/* Clamped knots with some of them double. */
static inline void random_knots(test_random *random, int degree, int count, double *knots)
{
    double at = test_random_int(random, -2, 2);
    for (int i = 0; i < count + degree + 1; i++) {
        const bool inside = i > degree && i < count;
        const bool again = inside && degree > 1 && knots[i - 1] != knots[i - 2] &&
                           i > degree + 1 && test_random_int(random, 0, 4) == 0;
        if ((inside && !again) || i == count)
            at += test_random_in(random, 0.1, 1);
        knots[i] = at;
    }
}

static inline batten_curve *random_curve(test_random *random)
{
    double knots[SHAPES_KNOTS], points[3 * SHAPES_POINTS], weights[SHAPES_POINTS];
    const int degree = test_random_int(random, 1, SHAPES_DEGREE);
    const int count = test_random_int(random, degree + 1, SHAPES_POINTS);
    random_knots(random, degree, count, knots);
    for (int i = 0; i < 3 * count; i++)
        points[i] = random_number(random);
    for (int i = 0; i < count; i++)
        weights[i] = test_random_in(random, 0.1, 3);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, count, points}, degree,
                                 test_random_int(random, 0, 1) ? weights : NULL, knots,
                                 &curve));
    return curve;
}

static inline batten_surface *random_surface(test_random *random)
{
    double knots[2][SHAPES_KNOTS], points[3 * SHAPES_POINTS * SHAPES_POINTS];
    double weights[SHAPES_POINTS * SHAPES_POINTS];
    batten_axis axes[2];
    for (int k = 0; k < 2; k++) {
        const int degree = test_random_int(random, 1, SHAPES_DEGREE);
        const int count = test_random_int(random, degree + 1, SHAPES_POINTS);
        random_knots(random, degree, count, knots[k]);
        axes[k] = (batten_axis){degree, count, knots[k], false};
    }
    for (int i = 0; i < COUNT(weights); i++) {
        for (int k = 0; k < 3; k++)
            points[3 * i + k] = random_number(random);
        weights[i] = test_random_in(random, 0.1, 3);
    }
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axes[0], &axes[1], points,
                                   test_random_int(random, 0, 1) ? weights : NULL, &surface));
    return surface;
}

static inline void add_curve(batten_model *model, const char *name, const batten_curve *curve)
{
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
}

static inline void add_surface(batten_model *model, const char *name,
                               const batten_surface *surface)
{
    CHECK_OK(batten_model_add(
        model,
        &(batten_object){.name = name, .kind = BATTEN_OBJECT_SURFACE, .surface = surface}));
}

static inline batten_model *random_model(test_random *random, double unit)
{
    static const char *const names[] = {
        "", "keel", "Spant 12 \xc3\xbc", "a,b;c 3Habc'\"\\",
        ("a name of more than sixty-four characters, which runs over "
         "the end of a record and on")};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    const int count = test_random_int(random, 1, 4);
    for (int i = 0; i < count; i++) {
        batten_object object = {.name = names[test_random_int(random, 1, 4)]};
        batten_curve *curve = NULL;
        batten_surface *surface = NULL;
        if (test_random_int(random, 0, 1)) {
            object.kind = BATTEN_OBJECT_CURVE;
            object.curve = curve = random_curve(random);
        } else {
            object.kind = BATTEN_OBJECT_SURFACE;
            object.surface = surface = random_surface(random);
        }
        object.has_colour = test_random_int(random, 0, 1);
        for (int k = 0; k < 3; k++)
            object.colour[k] = test_random_unit(random);
        object.layer = test_random_int(random, 0, 1) ? "" : "17";
        CHECK_OK(batten_model_add(model, &object));
        batten_curve_unref(curve);
        batten_surface_unref(surface);
    }
    return model;
}

static inline bool same_numbers(const double *a, const double *b, size_t count)
{
    return (!a && !b) || (a && b && memcmp(a, b, count * sizeof *a) == 0);
}

static inline void check_same_curve(const batten_curve *a, const batten_curve *b)
{
    const size_t n = (size_t)batten_curve_point_count(a);
    CHECK_INT(batten_curve_degree(b), batten_curve_degree(a));
    CHECK_INT(batten_curve_point_count(b), (long long)n);
    CHECK(same_numbers(batten_curve_points(a), batten_curve_points(b), 3 * n));
    CHECK(same_numbers(batten_curve_weights(a), batten_curve_weights(b), n));
    CHECK(same_numbers(batten_curve_knots(a), batten_curve_knots(b),
                       (size_t)batten_curve_knot_count(a)));
}

static inline void check_same_surface(const batten_surface *a, const batten_surface *b)
{
    size_t n = 1;
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        CHECK_INT(batten_surface_degree(b, direction), batten_surface_degree(a, direction));
        CHECK_INT(batten_surface_point_count(b, direction),
                  batten_surface_point_count(a, direction));
        CHECK(same_numbers(batten_surface_knots(a, direction),
                           batten_surface_knots(b, direction),
                           (size_t)batten_surface_knot_count(a, direction)));
        n *= (size_t)batten_surface_point_count(a, direction);
    }
    CHECK(same_numbers(batten_surface_points(a), batten_surface_points(b), 3 * n));
    CHECK(same_numbers(batten_surface_weights(a), batten_surface_weights(b), n));
}

static inline void check_same_model(const batten_model *a, const batten_model *b)
{
    CHECK_INT(batten_model_count(b), batten_model_count(a));
    CHECK_BITS(batten_model_unit_metres(b), batten_model_unit_metres(a));
    for (int i = 0; i < batten_model_count(a); i++) {
        const batten_object *p = batten_model_object(a, i), *q = batten_model_object(b, i);
        CHECK_TEXT(q->name, p->name);
        CHECK_TEXT(q->layer, p->layer);
        CHECK_INT(q->kind, p->kind);
        CHECK_INT(q->has_colour, p->has_colour);
        for (int k = 0; p->has_colour && k < 3; k++)
            CHECK_NEAR(q->colour[k], p->colour[k], 1e-8);
        if (p->curve)
            check_same_curve(p->curve, q->curve);
        if (p->surface)
            check_same_surface(p->surface, q->surface);
    }
}

#endif
