/* Lines, circles, arcs, ellipses and polylines in space are written as such. */
#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

#include <batten/standard.h>

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Where the curve is at the share s of its domain. */
static void point_at(const batten_curve *curve, double s, double p[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    p[2] = 0;
    CHECK_OK(batten_curve_evaluate(curve, domain.a + s * (domain.b - domain.a), 0, p));
}

/* The curve, whose reference is given back, is written as one entity of that kind, and comes
 * back with its ends and its middle; the second writing is the same. */
static void check_written_as(const char *kind, batten_curve *curve, double size)
{
    batten_model *model = NULL;
    batten_write_options options = batten_write_defaults();
    char head[40];
    options.format = BATTEN_FORMAT_DXF;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "c", .layer = "l", .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    snprintf(head, sizeof head, "ENTITIES\n  0\n%s\n", kind);
    CHECK(strstr(written(model, BATTEN_FORMAT_DXF), head) != NULL);
    batten_model *back = there_and_back(model, &options, NULL);
    CHECK_INT(batten_model_count(back), 1);
    for (int i = 0; i <= 2; i++) {
        double p[3], q[3];
        point_at(curve, i / 2.0, p);
        point_at(batten_model_object(back, 0)->curve, i / 2.0, q);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(q[k], p[k], 1e-12 * size);
    }
    batten_model_unref(back);
    batten_model_unref(model);
    batten_curve_unref(curve);
}

static batten_curve *arc(batten_vec3 origin, batten_vec3 x, batten_vec3 z, double radius,
                         double start, double sweep)
{
    const batten_frame frame = {.origin = origin, .x = x, .z = z};
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_arc_in(&frame, radius, start, sweep, &made));
    return made;
}

static batten_curve *ellipse(double a, double b, double start, double sweep)
{
    batten_curve *made = NULL;
    CHECK_OK(batten_curve_ellipse(a, b, start, sweep, &made));
    return made;
}

TEST(dxf_keeps_lines_in_any_direction)
{
    batten_curve *level = NULL, *leaning = NULL;
    CHECK_OK(batten_curve_line(2, (double[]){0, 0.1}, (double[]){3, 1.0 / 3}, &level));
    CHECK_OK(batten_curve_line(3, (double[]){0, 0.1, 7}, (double[]){3, 1, 1.0 / 3}, &leaning));
    check_written_as("LINE", level, 0);
    check_written_as("LINE", leaning, 0);
}

TEST(dxf_keeps_circles_and_arcs)
{
    const batten_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
    const batten_vec3 near = {10.1, 5.3, 7}, far = {1000000.1, 5300000.3, 0};
    const batten_vec3 leaning = {0, 0.6, 0.8};
    check_written_as("CIRCLE", arc(near, x, z, 2.5, 0, 2 * pi), 10);
    check_written_as("CIRCLE", arc(far, x, z, 2.5, 0, 2 * pi), 5.3e6);
    check_written_as("ARC", arc(near, x, z, 1.0 / 3, 0.3, 4), 10);
    check_written_as("ARC", arc(near, x, z, 1000, 0.8, 0.1), 1000);
    check_written_as("ARC", arc(near, z, y, 4, -1, 1.5), 10);
    check_written_as("ARC", arc(near, x, leaning, 4, -1, 1.5), 10);
}

TEST(arcs_that_go_clockwise_are_polylines_in_dxf)
{
    /* Else their plane had to look down. */
    batten_curve *made = arc((batten_vec3){10, 5, 7}, (batten_vec3){1, 0, 0},
                             (batten_vec3){0, 0, -1}, 4, 0, pi / 2);
    batten_model *model = model_of_curve(made, "arc");
    const char *text = written(model, BATTEN_FORMAT_DXF);
    CHECK(strstr(text, "LWPOLYLINE") && !strstr(text, "AcDbArc"));
    batten_model_unref(model);
}

/* One that goes clockwise and begins elsewhere is the same circle; numbers come out short. */
TEST(full_circles_of_dxf_are_circles_wherever_they_begin)
{
    batten_model *model =
        model_of_curve(arc((batten_vec3){10.1, 5.3, 0}, (batten_vec3){0, 1, 0},
                           (batten_vec3){0, 0, -1}, 2.5, 1, 2 * pi),
                       "hole");
    CHECK(strstr(written(model, BATTEN_FORMAT_DXF),
                 "AcDbCircle\n 10\n10.1\n 20\n5.3\n 30\n0\n 40\n2.5\n  0\n") != NULL);
    batten_model_unref(model);
}

TEST(dxf_keeps_ellipses_and_their_arcs)
{
    check_written_as("ELLIPSE", ellipse(3, 1.25, 0, 2 * pi), 3);
    check_written_as("ELLIPSE", ellipse(3, 1.25, 0.5, 4), 3);
    check_written_as("ELLIPSE", ellipse(1.25, 3, 2, 1), 3);
    batten_curve *forward = ellipse(3, 1.25, 0.5, 4), *back = NULL;
    CHECK_OK(batten_curve_reverse(forward, &back));
    check_written_as("ELLIPSE", back, 3);
    batten_curve_unref(forward);
}

TEST(dxf_keeps_polylines_in_space)
{
    const double points[] = {0, 0, 0, 1, 0, 1, 1, 1, 2.5, 0, 0, 0};
    batten_curve *open = NULL, *closed = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, points}, &open));
    CHECK_OK(batten_curve_polyline((batten_points){3, 4, points}, &closed));
    check_written_as("POLYLINE", open, 0);
    check_written_as("POLYLINE", closed, 0);
}

/* Its axes are known only to some 1e-11 of their length. */
TEST(ellipses_that_are_nearly_circles_stay_splines_in_dxf)
{
    check_written_as("SPLINE", ellipse(3, 3 - 1e-3, 1, 2 * pi), 3);
    check_written_as("SPLINE", ellipse(3, 3 - 1e-9, 1, 2 * pi), 3);
}

/* Nearly an ellipse is none. */
TEST(dxf_keeps_what_is_beside_an_ellipse_as_it_is)
{
    batten_curve *round = ellipse(3, 1.25, 0, 2 * pi), *moved = NULL;
    double p[2] = {batten_curve_points(round)[4] + 1e-9, batten_curve_points(round)[5]};
    CHECK_OK(batten_curve_with_point(round, 2, p, &moved));
    check_written_as("SPLINE", moved, 3);
    batten_curve_unref(round);
}
