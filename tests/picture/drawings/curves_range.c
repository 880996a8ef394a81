/* The view, the scale of combs and the range of a drawing, from what it draws. */
#include "picture/drawings/drawing.h"

#include "picture/scenes.h"

/* A drawing of one straight stroke. */
typedef struct {
    double points[2][3];
    bat_stroke stroke;
    batten_object object;
    bat_shape shape;
    batten_draw_options options;
    bat_drawing drawing;
} scene;

static bat_drawing *draw_line(scene *s, const double *from, const double *to)
{
    *s = (scene){.object = {.kind = BATTEN_OBJECT_SURFACE}, .options = batten_draw_defaults()};
    memcpy(s->points[0], from, sizeof s->points[0]);
    memcpy(s->points[1], to, sizeof s->points[1]);
    s->stroke = (bat_stroke){2, s->points[0]};
    s->shape = (bat_shape){.object = &s->object, .lines = {1, 1, &s->stroke}};
    s->drawing = (bat_drawing){.options = &s->options, .shape_count = 1, .shapes = &s->shape};
    return &s->drawing;
}

static const struct {
    double to[3];
    batten_view asked, seen;
} views[] = {
    {{4, 2, 0}, BATTEN_VIEW_AUTO, BATTEN_VIEW_TOP},
    {{4, 0, 2}, BATTEN_VIEW_AUTO, BATTEN_VIEW_SIDE},
    {{0, 4, 2}, BATTEN_VIEW_AUTO, BATTEN_VIEW_FRONT},
    {{4, 2, 1}, BATTEN_VIEW_AUTO, BATTEN_VIEW_AXONOMETRIC},
    /* Flat to a thousand-millionth of the largest range. */
    {{4, 2, 3.9e-9}, BATTEN_VIEW_AUTO, BATTEN_VIEW_TOP},
    {{4, 2, 4.1e-9}, BATTEN_VIEW_AUTO, BATTEN_VIEW_AXONOMETRIC},
    {{4, 4.1e-9, 2}, BATTEN_VIEW_AUTO, BATTEN_VIEW_AXONOMETRIC},
    {{3.9e-9, 4, 2}, BATTEN_VIEW_AUTO, BATTEN_VIEW_FRONT},
    {{4, 2, 0}, BATTEN_VIEW_FRONT, BATTEN_VIEW_FRONT},
    {{4, 2, 0}, BATTEN_VIEW_ISOMETRIC, BATTEN_VIEW_AXONOMETRIC},
};

TEST(the_view_is_that_asked_for_or_the_plane_in_which_all_lies)
{
    for (int i = 0; i < COUNT(views); i++) {
        scene s;
        bat_drawing *d = draw_line(&s, (double[]){0, 0, 0}, views[i].to);
        s.options.view = views[i].asked;
        CHECK_OK(bat_drawing_choose_view(d));
        CHECK_INT(d->kind, views[i].seen);
        const bat_view view =
            bat_view_make(views[i].asked == BATTEN_VIEW_AUTO ? views[i].seen : views[i].asked,
                          s.options.azimuth, s.options.elevation);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(d->view.eye[k], view.eye[k], 0);
    }
}

/* Far from the origin a hundredth of a billionth of the coordinates is rounding. */
TEST(what_is_flat_but_for_rounding_far_away_is_flat)
{
    scene s;
    for (int flat = 0; flat < 2; flat++) {
        bat_drawing *d =
            draw_line(&s, (double[]){0, 0, 1e9}, (double[]){1, 1, 1e9 + (flat ? 9e-6 : 2e-5)});
        CHECK_OK(bat_drawing_choose_view(d));
        CHECK_INT(d->kind, flat ? BATTEN_VIEW_TOP : BATTEN_VIEW_AXONOMETRIC);
    }
}

TEST(the_range_has_a_margin_of_three_hundredths_of_its_larger_side)
{
    scene s;
    bat_drawing *d = draw_line(&s, (double[]){1, -2, 0}, (double[]){5, 6, 0});
    CHECK_OK(bat_drawing_choose_view(d));
    CHECK_NEAR(d->low[0], 1 - 0.24, 1e-14);
    CHECK_NEAR(d->high[0], 5 + 0.24, 1e-14);
    CHECK_NEAR(d->low[1], -2 - 0.24, 1e-14);
    CHECK_NEAR(d->high[1], 6 + 0.24, 1e-14);
    double xy[2];
    d->plot = (bat_plot){.frame = {10, 20, 100, 200}, .scale = 3, .x0 = 1, .y0 = -1};
    bat_drawing_to_sheet(d, (double[]){5, 6, 99}, xy);
    CHECK_NEAR(xy[0], 10 + 3 * 4, 1e-12);
    CHECK_NEAR(xy[1], 220 - 3 * 7, 1e-12);
}

TEST(what_cannot_be_measured_is_refused)
{
    scene s;
    bat_drawing *d = draw_line(&s, (double[]){-1.5e308, 0, 0}, (double[]){1.5e308, 1, 0});
    CHECK_STATUS(bat_drawing_choose_view(d), BATTEN_OVERFLOW);
    CHECK_MESSAGE("coordinates from -1.5e+308 to 1.5e+308 are too large to draw");
    s.shape.lines.count = 0;
    CHECK_STATUS(bat_drawing_choose_view(d), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("of 1 object none has anything that could be drawn");
}

/* The comb of a curvature of 0.5 on a line 8 long: 0.1 * 8 / 0.5, and its tips count for the range. */
TEST(the_longest_tooth_is_a_tenth_of_the_larger_side)
{
    static const struct {
        double sharpest, asked, scale;
    } rows[] = {{0.5, 0, 1.6}, {0.5, 14, 14}, {1e-11, 0, 0}, {2e-10, 0, 4e9}, {0, 0, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        scene s;
        bat_drawing *d = draw_line(&s, (double[]){0, 0, 0}, (double[]){8, 4, 0});
        batten_tooth tooth = {.foot = {8, 0, 0}, .tip = {8, rows[i].sharpest, 0}};
        s.shape.sharpest = rows[i].sharpest;
        s.shape.tooth_count = 1;
        s.shape.teeth = &tooth;
        s.options.comb_scale = rows[i].asked;
        CHECK_OK(bat_drawing_choose_view(d));
        CHECK_NEAR(d->comb_scale, rows[i].scale, 1e-12 * rows[i].scale);
        const double top = fmax(4, rows[i].sharpest * rows[i].scale);
        CHECK_NEAR(d->high[1], top + 0.03 * fmax(8, top), 1e-9);
    }
}

TEST(vertices_are_the_polygon_of_a_curve_and_other_points_its_data)
{
    batten_curve *flat = scene_curve(2, 1, 2, (double[]){1, 2, 3, 4});
    batten_curve *value = scene_curve(1, 1, 2, (double[]){1, 2});
    double points[3][3] = {{7, 8, 9}, {4, 5, 6}, {1, 2, 3}};
    scene s;
    bat_drawing *d = draw_line(&s, points[0], points[1]);
    for (int i = 0; i < 32; i++) {
        const bool is_curve = i & 1, vertices = i & 2, polygon = i & 4, data = i & 8,
                   of_one = i & 16;
        const batten_object object = {.kind =
                                          is_curve ? BATTEN_OBJECT_CURVE : BATTEN_OBJECT_POINTS,
                                      .curve = of_one ? value : flat,
                                      .points_are_vertices = vertices,
                                      .point_count = 3,
                                      .points = points[0]};
        const bool shaping = is_curve && vertices;
        s.options.control_polygon = polygon;
        s.options.data_points = data;
        CHECK_INT(bat_drawing_shows_polygon(d, &object),
                  is_curve && !of_one && (polygon || (shaping && data)));
        CHECK_INT(bat_drawing_shows_points(d, &object), !shaping && (!is_curve || data));
        if (!is_curve)
            continue;
        double point[3];
        CHECK_INT(bat_drawing_control_count(&object), shaping ? 3 : 2);
        bat_drawing_control_point(&object, 1, point);
        CHECK_NEAR(point[0], shaping ? 4 : of_one ? 2 : 3, 0);
        CHECK_NEAR(point[1], shaping ? 5 : of_one ? 0 : 4, 0);
        CHECK_NEAR(point[2], shaping ? 6 : 0, 0);
    }
    batten_curve_unref(value);
    batten_curve_unref(flat);
}

TEST(a_tooth_ends_at_its_scale)
{
    double tip[3];
    const batten_tooth tooth = {.foot = {1, 2, 3}, .tip = {2, 4, 7}};
    bat_drawing_comb_tip(&tooth, 0.5, tip);
    CHECK_NEAR(tip[0], 1.5, 0);
    CHECK_NEAR(tip[1], 3, 0);
    CHECK_NEAR(tip[2], 5, 0);
}
