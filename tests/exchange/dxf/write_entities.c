/* Which groups stand in each entity, in the order of the DXF reference. */
#include "exchange/dxf/groups.h"
#include "exchange/shapes/paths.h"

/* All entities, each group as "code value " and each entity on a line of its own. Handles and
 * owners are other tests' business. */
static const char *entities_of(const char *text)
{
    char *out = test_array(strlen(text) + 1, 2), value[VALUE], *to = out;
    int code = -1;
    const char *at = strstr(text, "ENTITIES\n");
    CHECK(at != NULL);
    at += strlen("ENTITIES\n");
    while ((at = next_group(at, &code, value)) && strcmp(value, "ENDSEC") != 0)
        if (code != 5 && code != 330)
            to += sprintf(to, "%s%d %s", code != 0 ? " " : to > out ? "\n" : "", code, value);
    return out;
}

/* The curve, whose reference is given back, is written as these entities. */
static void check_entities(batten_curve *curve, const char *expected)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "c", .layer = "l", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    CHECK_TEXT(entities_of(written(model, BATTEN_FORMAT_DXF)), expected);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

/* Counter-clockwise about (1, 2) at this height, seen from z. */
static batten_curve *arc_at(double height, batten_vec3 x, batten_vec3 z, double start,
                            double sweep)
{
    const batten_frame frame = {.origin = {1, 2, height}, .x = x, .z = z};
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, 2.5, start, sweep, &made));
    return made;
}

static batten_curve *polyline(int count, const double *points)
{
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, count, points}, &made));
    return made;
}

TEST(a_line_has_its_two_ends)
{
    check_entities(polyline(2, (double[]){1, 2, 3, 4.5, 5, 6}),
                   "0 LINE 100 AcDbEntity 8 l 100 AcDbLine 10 1 20 2 30 3 11 4.5 21 5 31 6");
}

/* What lies in a plane is a polyline of it, also when its vertices lie on one line. */
TEST(a_polyline_in_a_plane_has_a_count_a_flag_a_height_and_its_vertices)
{
    check_entities(polyline(3, (double[]){1, 2, 7, 4, 5, 7, 4, 6, 7}),
                   "0 LWPOLYLINE 100 AcDbEntity 8 l 100 AcDbPolyline 90 3 70 0 38 7"
                   " 10 1 20 2 10 4 20 5 10 4 20 6");
    check_entities(polyline(4, (double[]){0, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 0}),
                   "0 LWPOLYLINE 100 AcDbEntity 8 l 100 AcDbPolyline 90 3 70 1 38 0"
                   " 10 0 20 0 10 4 20 0 10 0 20 3");
}

TEST(a_circle_has_no_normal_where_that_is_the_z_of_the_world)
{
    const double turn = 2 * acos(-1);
    const batten_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    check_entities(arc_at(3, x, z, 0, turn),
                   "0 CIRCLE 100 AcDbEntity 8 l 100 AcDbCircle 10 1 20 2 30 3 40 2.5");
    /* Looking along y the axes of the plane are -x and z. */
    check_entities(arc_at(3, x, y, 0, turn),
                   "0 CIRCLE 100 AcDbEntity 8 l 100 AcDbCircle 10 -1 20 3 30 2 40 2.5"
                   " 210 0 220 1 230 0");
}

TEST(an_arc_is_a_circle_with_two_angles_in_degrees)
{
    const double pi = acos(-1);
    const batten_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    check_entities(arc_at(0, x, z, pi / 6, pi / 2),
                   "0 ARC 100 AcDbEntity 8 l 100 AcDbCircle 10 1 20 2 30 0 40 2.5"
                   " 100 AcDbArc 50 30 51 120");
    check_entities(arc_at(3, x, y, 0, pi / 2),
                   "0 ARC 100 AcDbEntity 8 l 100 AcDbCircle 10 -1 20 3 30 2 40 2.5"
                   " 210 0 220 1 230 0 100 AcDbArc 50 180 51 270");
}

/* A whole turn is from 0 to 2 pi; of the two half axes the longer is the vector. */
TEST(an_ellipse_has_a_centre_an_axis_a_ratio_and_two_parameters)
{
    batten_curve *whole = NULL, *part = NULL;
    CHECK_OK(batten_curve_ellipse(4, 2, 0, 2 * acos(-1), &whole));
    CHECK_OK(batten_curve_ellipse(1, 2, 0.5, 1, &part));
    check_entities(whole, "0 ELLIPSE 100 AcDbEntity 8 l 100 AcDbEllipse 10 0 20 0 30 0"
                          " 11 4 21 0 31 0 40 0.5 41 0 42 6.283185307179586");
    batten_model *model = model_of_curve(part, "part");
    double ratio = 0, from = 0, to = 0, axis = 0;
    const char *text = entities_of(written(model, BATTEN_FORMAT_DXF));
    CHECK(sscanf(strstr(text, " 21 "), " 21 %lf 31 0 40 %lf 41 %lf 42 %lf", &axis, &ratio,
                 &from, &to) == 4);
    CHECK_NEAR(axis, 2, 1e-11);
    CHECK_NEAR(ratio, 0.5, 1e-11);
    /* The point at 0.5 is cos 0.5 of the short axis, which stands a quarter before the long. */
    CHECK_NEAR(from, 0.5 + 3 * acos(-1) / 2, 1e-11);
    CHECK_NEAR(to, from + 1, 1e-11);
    batten_model_unref(model);
}

#define VERTEX_OF(x, y, z)                                                                 \
    "\n0 VERTEX 100 AcDbEntity 8 l 100 AcDbVertex 100 AcDb3dPolylineVertex 10 " x " 20 " y \
    " 30 " z " 70 32"

/* 8: in space; 1: closed, by an end that is the start. Points that are repeated count once. */
TEST(a_polyline_in_space_has_its_vertices_each_once_and_an_end)
{
    static const double open[] = {0, 0, 0, 1, 0, 1, 1, 0, 1, 1, 2, 5};
    static const double closed[] = {0, 0, 0, 1, 0, 1, 1, 2, 5, 0, 2, 3, 0, 0, 0};
    static const double knots[] = {0, 0, 1, 2, 3, 3};
    batten_curve *repeated = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, open}, 1, NULL, knots, &repeated));
    check_entities(
        repeated,
        "0 POLYLINE 100 AcDbEntity 8 l 100 AcDb3dPolyline 66 1 10 0 20 0 30 0 70 8" VERTEX_OF(
            "0", "0", "0") VERTEX_OF("1", "0", "1")
            VERTEX_OF("1", "2", "5") "\n0 SEQEND 100 AcDbEntity 8 l");
    check_entities(
        polyline(5, closed),
        "0 POLYLINE 100 AcDbEntity 8 l 100 AcDb3dPolyline 66 1 10 0 20 0 30 0 70 9" VERTEX_OF(
            "0", "0", "0") VERTEX_OF("1", "0", "1") VERTEX_OF("1", "2", "5")
            VERTEX_OF("0", "2", "3") "\n0 SEQEND 100 AcDbEntity 8 l");
}

/* 1: closed; 4: with weights. */
TEST(a_spline_has_flags_counts_knots_weights_and_points)
{
    static const double points[] = {0, 0, 0, 1, 3, 0, 2, 0, 1, 0, 0, 0};
    static const double weights[] = {1, 2, 4, 1}, knots[] = {0, 0, 0, 0, 2, 2, 2, 2};
    batten_curve *open = NULL, *closed = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, weights,
                                 (double[]){0, 0, 0, 1, 1, 1}, &open));
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &closed));
    check_entities(open, "0 SPLINE 100 AcDbEntity 8 l 100 AcDbSpline 70 4 71 2 72 6 73 3 74 0"
                         " 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 2 41 4"
                         " 10 0 20 0 30 0 10 1 20 3 30 0 10 2 20 0 30 1");
    check_entities(closed, "0 SPLINE 100 AcDbEntity 8 l 100 AcDbSpline 70 1 71 3 72 8 73 4 74 0"
                           " 40 0 40 0 40 0 40 0 40 2 40 2 40 2 40 2"
                           " 10 0 20 0 30 0 10 1 20 3 30 0 10 2 20 0 30 1 10 0 20 0 30 0");
}

/* On a layer that is shown a hidden entity says so; its colour where the layer has another. */
TEST(an_entity_says_its_colour_and_that_it_is_hidden_where_its_layer_does_not)
{
    static const double points[] = {1, 2, 3};
    const struct {
        bool is_hidden, has_colour;
        double colour[3];
    } of[] = {{false, false, {0}},
              {false, false, {0}},
              {true, true, {1, 0, 0}},
              {false, true, {0.2, 0.4, 0.6}}};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(of); i++) {
        batten_object object = {.name = "p",
                                .layer = "l",
                                .kind = BATTEN_OBJECT_POINTS,
                                .point_count = 1,
                                .points = points,
                                .is_hidden = of[i].is_hidden,
                                .has_colour = of[i].has_colour};
        memcpy(object.colour, of[i].colour, sizeof object.colour);
        CHECK_OK(batten_model_add(model, &object));
    }
    CHECK_TEXT(entities_of(written(model, BATTEN_FORMAT_DXF)),
               "0 POINT 100 AcDbEntity 8 l 100 AcDbPoint 10 1 20 2 30 3\n"
               "0 POINT 100 AcDbEntity 8 l 100 AcDbPoint 10 1 20 2 30 3\n"
               "0 POINT 100 AcDbEntity 8 l 60 1 62 1 100 AcDbPoint 10 1 20 2 30 3\n"
               "0 POINT 100 AcDbEntity 8 l 62 155 420 3368601 100 AcDbPoint 10 1 20 2 30 3");
    batten_model_unref(model);
}
