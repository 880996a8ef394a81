#include "exchange/shapes/paths.h"

#include <batten/measure.h>

static const double pi = 3.14159265358979323846;

/* A level curve of points [count][3], added to a model. */
static void add_level(batten_model *model, const char *name, int count, const double *points)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, count, points}, &curve));
    const batten_object object = {.name = name, .kind = BATTEN_OBJECT_CURVE, .curve = curve};
    CHECK_OK(batten_model_add(model, &object));
    batten_curve_unref(curve);
}

static const double bar[3][3] = {{10, 20, 1}, {40, 20, 1}, {40, 60, 1}};
static const double nick[2][3] = {{43, 60, 0}, {43, 64, 0}};

static batten_model *two_paths(double unit)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit, &model));
    add_level(model, "bar", 3, bar[0]);
    add_level(model, "nick", 2, nick[0]);
    return model;
}

typedef struct {
    const char *name, *layer;
    double length, start[3], end[3];
} piece;

static void check_piece(const batten_object *object, const piece *wanted)
{
    double point[3], length = 0;
    const batten_interval domain = batten_curve_domain(object->curve);
    CHECK_TEXT(object->name, wanted->name);
    CHECK_TEXT(object->layer, wanted->layer);
    CHECK_OK(batten_curve_length(object->curve, 1e-12, NULL, &length));
    CHECK_NEAR(length, wanted->length, 1e-9);
    CHECK_OK(batten_curve_evaluate(object->curve, domain.a, 0, point));
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(point[k], wanted->start[k], 1e-12);
    CHECK_OK(batten_curve_evaluate(object->curve, domain.b, 0, point));
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(point[k], wanted->end[k], 1e-12);
}

static void check_pieces(const batten_model *model, const batten_write_gcode_options *options,
                         int count, const piece *wanted)
{
    batten_model *path = NULL;
    CHECK_OK(batten_gcode_tool_path(model, options, NULL, &path));
    CHECK_INT(batten_model_count(path), count);
    for (int i = 0; i < count; i++)
        check_piece(batten_model_object(path, i), &wanted[i]);
    batten_model_unref(path);
}

/* Up to 1 + 5, over by 3, down to each path's own height. */
static const piece own_heights[] = {
    {"bar", "plunge", 5, {10, 20, 6}, {10, 20, 1}},
    {"bar", "cut", 70, {10, 20, 1}, {40, 60, 1}},
    {"bar", "travel", 5, {40, 60, 1}, {40, 60, 6}},
};
/* The highest path, at 1, and the clearance of 4 make 5. */
static const piece at_depth[] = {
    {"bar", "plunge", 7, {10, 20, 5}, {10, 20, -2}},
    {"bar", "cut", 70, {10, 20, -2}, {40, 60, -2}},
    {"nick", "travel", 10, {40, 60, -2}, {43, 60, 5}},
    {"nick", "plunge", 7, {43, 60, 5}, {43, 60, -2}},
    {"nick", "cut", 4, {43, 60, -2}, {43, 64, -2}},
    {"nick", "travel", 7, {43, 64, -2}, {43, 64, 5}},
};

TEST(the_tool_goes_down_cuts_and_travels_as_the_program_says)
{
    batten_model *model = two_paths(0.001), *one = NULL;
    batten_write_gcode_options options = batten_write_gcode_defaults();
    CHECK_OK(batten_model_create(0, &one)); /* of no unit: millimetres */
    add_level(one, "bar", 3, bar[0]);
    check_pieces(one, NULL, 3, own_heights);
    options.depth = -2;
    options.clearance = 4;
    check_pieces(model, &options, 6, at_depth);
    batten_model_unref(one);
    batten_model_unref(model);
}

TEST(with_relative_moves_the_tool_comes_from_the_origin_of_the_machine)
{
    batten_model *model = two_paths(0.001), *path = NULL;
    batten_write_gcode_options options = batten_write_gcode_defaults();
    options.depth = -2;
    options.clearance = 4;
    options.relative_moves = true;
    CHECK_OK(batten_gcode_tool_path(model, &options, NULL, &path));
    CHECK_INT(batten_model_count(path), 7);
    check_piece(batten_model_object(path, 0),
                &(piece){"bar", "travel", 5 + sqrt(500), {0}, {10, 20, 5}});
    for (int i = 0; i < 6; i++)
        check_piece(batten_model_object(path, i + 1), &at_depth[i]);
    batten_model_unref(path);
    batten_model_unref(model);
}

TEST(arcs_stay_arcs_and_coordinates_are_those_of_the_program_in_its_unit)
{
    batten_model *model = model_of("stadium", stadium()), *path = NULL;
    double length = 0;
    CHECK_OK(batten_gcode_tool_path(model, NULL, NULL, &path));
    CHECK_INT(batten_model_count(path), 3);
    const batten_object *cut = batten_model_object(path, 1);
    CHECK_OK(batten_curve_length(cut->curve, 1e-9, NULL, &length));
    CHECK_NEAR(length, 160 + 20 * pi, 1e-8);
    CHECK_INT(batten_curve_is_rational(cut->curve), 1);
    batten_model_unref(path);
    batten_model_unref(model);

    const double off[2][3] = {{0, 0, 0}, {1.26, 0, 0}};
    batten_write_gcode_options options = batten_write_gcode_defaults();
    options.decimals = 1;
    for (int k = 0; k < 2; k++) {
        CHECK_OK(batten_model_create(k ? 0.0254 : 1, &model));
        add_level(model, "off", 2, off[0]);
        CHECK_OK(batten_gcode_tool_path(model, &options, NULL, &path));
        CHECK_NEAR(batten_model_unit_metres(path), k ? 0.0254 : 0.001, 0);
        CHECK_OK(batten_curve_length(batten_model_object(path, 1)->curve, 1e-9, NULL, &length));
        CHECK_NEAR(length, k ? 1.3 : 1260, 1e-9);
        batten_model_unref(path);
        batten_model_unref(model);
    }
}

TEST(a_way_of_the_tool_is_refused_as_its_program_is)
{
    batten_model *model = two_paths(0.001), *empty = NULL, *path = NULL;
    batten_write_gcode_options options = batten_write_gcode_defaults();
    options.decimals = 10;
    CHECK_STATUS(batten_gcode_tool_path(model, &options, NULL, &path), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_model_create(0.001, &empty));
    CHECK_STATUS(batten_gcode_tool_path(empty, NULL, NULL, &path), BATTEN_UNSUPPORTED);
    CHECK_INT(path == NULL, 1);
    batten_model_unref(empty);
    batten_model_unref(model);
}
