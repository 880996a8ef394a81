/* The views of a sheet: which they are, what they show, where they stand. */
#include "picture/lines/surface_looks.h"

#include "picture/scenes.h"

static const double EM = 10;

static bat_looks_drawing drawing(const batten_draw_options *options)
{
    return (bat_looks_drawing){.options = options,
                               .wires = {.options = options, .box = {{1, 2, 0}, {3, 8, 1}}},
                               .em = EM};
}

/* Each sheet with its views; the angles of the axonometric one beside the azimuth. */
static const struct {
    batten_sheet sheet;
    batten_view view;
    int count;
    struct {
        batten_view kind;
        double beside;
        const char *title;
    } looks[4];
} sheets[] = {
    {BATTEN_SHEET_ONE, BATTEN_VIEW_AUTO, 1, {{BATTEN_VIEW_AXONOMETRIC, 0, ""}}},
    {BATTEN_SHEET_ONE, BATTEN_VIEW_TOP, 1, {{BATTEN_VIEW_TOP, 0, ""}}},
    {BATTEN_SHEET_THREE_VIEWS,
     BATTEN_VIEW_TOP,
     4,
     {{BATTEN_VIEW_SIDE, 0, "side"},
      {BATTEN_VIEW_FRONT, 0, "front"},
      {BATTEN_VIEW_TOP, 0, "top"},
      {BATTEN_VIEW_AXONOMETRIC, 0, "axonometric"}}},
    {BATTEN_SHEET_THREE_VIEWS,
     BATTEN_VIEW_ISOMETRIC,
     4,
     {{BATTEN_VIEW_SIDE, 0, "side"},
      {BATTEN_VIEW_FRONT, 0, "front"},
      {BATTEN_VIEW_TOP, 0, "top"},
      {BATTEN_VIEW_ISOMETRIC, 0, "axonometric"}}},
    {BATTEN_SHEET_STEREO_PARALLEL,
     BATTEN_VIEW_SIDE,
     2,
     {{BATTEN_VIEW_AXONOMETRIC, -0.05, ""}, {BATTEN_VIEW_AXONOMETRIC, 0.05, ""}}},
    {BATTEN_SHEET_STEREO_CROSSED,
     BATTEN_VIEW_SIDE,
     2,
     {{BATTEN_VIEW_AXONOMETRIC, 0.05, ""}, {BATTEN_VIEW_AXONOMETRIC, -0.05, ""}}},
};

TEST(each_sheet_has_its_views_about_the_middle_of_the_box)
{
    for (int i = 0; i < COUNT(sheets); i++) {
        batten_draw_options options = batten_draw_defaults();
        options.sheet = sheets[i].sheet;
        options.view = sheets[i].view;
        options.azimuth = 0.3;
        options.elevation = 0.2;
        options.stereo_angle = 0.1;
        options.distance = 7;
        bat_looks_drawing d = drawing(&options);
        bat_looks_choose(&d);
        CHECK_INT(d.look_count, sheets[i].count);
        for (int k = 0; k < d.look_count; k++) {
            const bat_look *l = &d.looks[k];
            const bat_view view =
                bat_view_make(sheets[i].looks[k].kind, 0.3 + sheets[i].looks[k].beside, 0.2);
            CHECK_INT(l->kind, sheets[i].looks[k].kind);
            CHECK_TEXT(l->title, sheets[i].looks[k].title);
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(l->eye.centre[c], ((double[]){2, 5, 0.5})[c], 0);
                CHECK_NEAR(l->eye.view.right[c], view.right[c], 1e-15);
                CHECK_NEAR(l->eye.view.eye[c], view.eye[c], 1e-15);
            }
            CHECK_NEAR(l->eye.distance, 7, 0);
        }
    }
}

/* From above: half an edge to all sides, larger by d / (d - 1/2) where the eye is near. */
TEST(a_look_shows_the_box_as_the_eye_sees_it)
{
    static const double distances[] = {0, 1, 10};
    batten_draw_options options = batten_draw_defaults();
    options.view = BATTEN_VIEW_TOP;
    for (int i = 0; i < COUNT(distances); i++) {
        options.distance = distances[i];
        bat_looks_drawing d = drawing(&options);
        bat_looks_choose(&d);
        CHECK_OK(bat_look_measure(&d, &d.looks[0]));
        const double larger = distances[i] > 0 ? distances[i] / (distances[i] - 0.5) : 1;
        for (int k = 0; k < 2; k++) {
            CHECK_NEAR(d.looks[0].high[k], (k ? 3 : 1) * larger, 1e-12);
            CHECK_NEAR(d.looks[0].low[k], (k ? -3 : -1) * larger, 1e-12);
        }
    }
}

/* It reaches 0.5 towards the eye, which must be farther than 0.5 / 0.95. */
TEST(an_eye_within_the_box_is_refused_with_its_distance)
{
    batten_draw_options options = batten_draw_defaults();
    options.view = BATTEN_VIEW_TOP;
    for (int far = 0; far < 2; far++) {
        options.distance = far ? 0.527 : 0.526;
        bat_looks_drawing d = drawing(&options);
        bat_looks_choose(&d);
        CHECK_STATUS(bat_look_measure(&d, &d.looks[0]), far ? BATTEN_OK : BATTEN_BAD_ARGUMENT);
        if (!far)
            CHECK_MESSAGE("the eye is 0.526 before the middle of what is drawn; its box "
                          "reaches 0.5 towards it");
    }
}

TEST(the_lines_themselves_are_shown_with_a_margin_of_a_fiftieth)
{
    double points[] = {2, 5, 0, 2.5, 5, 0, 2.5, 6, 1};
    bat_wire wires[] = {{.stroke = {2, points}}, {.stroke = {1, points + 6}}};
    batten_draw_options options = batten_draw_defaults();
    options.view = BATTEN_VIEW_TOP;
    bat_looks_drawing d = drawing(&options);
    bat_looks_choose(&d);
    CHECK_OK(bat_look_measure(&d, &d.looks[0]));
    bat_looks_measure_lines(&d, &d.looks[0]);
    CHECK_NEAR(d.looks[0].high[0], 1, 0); /* there are none yet */
    d.wires.wires = wires;
    d.wires.count = 2;
    bat_looks_measure_lines(&d, &d.looks[0]);
    CHECK_NEAR(d.looks[0].low[0], -0.02, 1e-15);
    CHECK_NEAR(d.looks[0].high[0], 0.52, 1e-15);
    CHECK_NEAR(d.looks[0].low[1], -0.02, 1e-15);
    CHECK_NEAR(d.looks[0].high[1], 1.02, 1e-15);
}

static bat_looks_drawing placed(const batten_draw_options *options)
{
    bat_looks_drawing d = drawing(options);
    bat_looks_choose(&d);
    for (int i = 0; i < d.look_count; i++)
        CHECK_OK(bat_look_measure(&d, &d.looks[i]));
    bat_looks_place(&d);
    return d;
}

/* The sheet is 400 wide with 2 em free at each side; above, a title takes 3.5 em and none 1.5, the
 * legend of contours takes 3.5 em below and none 1.5. */
TEST(one_view_fills_what_title_and_legend_leave)
{
    for (int i = 0; i < 4; i++) {
        batten_draw_options options = batten_draw_defaults();
        options.view = BATTEN_VIEW_TOP;
        options.width = 400;
        options.height = i < 2 ? 300 : 0;
        options.title = i % 2 ? "Hull" : "";
        options.contours = i % 2;
        const bat_looks_drawing d = placed(&options);
        const double above = i % 2 ? 35 : 15, below = i % 2 ? 35 : 15;
        const bat_rectangle f = d.looks[0].plot.frame;
        CHECK_NEAR(f.x, 20, 1e-12);
        CHECK_NEAR(f.y, above, 1e-12);
        CHECK_NEAR(f.width, 360, 1e-12);
        CHECK_NEAR(f.height, d.height - above - below, 1e-12);
        if (i < 2)
            CHECK_INT(d.height, 300);
        /* The box is 2 wide and 6 high: it fills the height. */
        CHECK_NEAR(d.looks[0].plot.scale, f.height / 6, 1e-9);
        CHECK_NEAR(bat_plot_x(&d.looks[0].plot, 0), 200, 1e-9);
        CHECK_NEAR(bat_plot_y(&d.looks[0].plot, 0), above + f.height / 2, 1e-9);
    }
}

TEST(two_views_stand_side_by_side)
{
    batten_draw_options options = batten_draw_defaults();
    options.sheet = BATTEN_SHEET_STEREO_PARALLEL;
    options.width = 400;
    options.height = 300;
    const bat_looks_drawing d = placed(&options);
    for (int k = 0; k < 2; k++) {
        const bat_rectangle f = d.looks[k].plot.frame;
        CHECK_NEAR(f.x, 20 + 190 * k, 1e-12);
        CHECK_NEAR(f.width, 170, 1e-12);
        CHECK_NEAR(f.y, 15, 1e-12);
        CHECK_NEAR(f.height, 270, 1e-12);
    }
}

/* Box 2 x 6 x 1: the side is 2 x 1 or so by 1 high, and so on. Whatever the axes, a point stands at one
 * place along in side and top view, and at one height in side and front view. */
TEST(three_views_stand_in_line_at_one_scale)
{
    for (int height = 0; height <= 300; height += 300) {
        batten_draw_options options = batten_draw_defaults();
        options.sheet = BATTEN_SHEET_THREE_VIEWS;
        options.width = 400;
        options.height = height;
        const bat_looks_drawing d = placed(&options);
        const bat_look *side = &d.looks[0], *front = &d.looks[1], *top = &d.looks[2];
        const double corners[2][3] = {{1, 2, 0}, {3, 8, 1}};
        for (int i = 0; i < 2; i++) {
            double q[3][3];
            for (int k = 0; k < 3; k++)
                bat_eye_project(&d.looks[k].eye, corners[i], q[k]);
            CHECK_NEAR(bat_plot_x(&side->plot, q[0][0]), bat_plot_x(&top->plot, q[2][0]), 1e-9);
            CHECK_NEAR(bat_plot_y(&side->plot, q[0][1]), bat_plot_y(&front->plot, q[1][1]),
                       1e-9);
        }
        CHECK_NEAR(side->plot.scale, top->plot.scale, 0);
        CHECK_NEAR(side->plot.scale, front->plot.scale, 0);
        /* Side 2 x 1, front 6 x 1, top 2 x 6, gaps of 3 em: both fit. */
        const double wide = (360 - 30) / 8.0, tall = (d.height - 25 - 15 - 30) / 7.0;
        CHECK_NEAR(side->plot.scale, fmin(wide, tall), 1e-9);
        if (height == 0) /* as high as the width lets them be */
            CHECK_NEAR(tall, wide, 0.5);
        const bat_rectangle a = side->plot.frame, b = front->plot.frame, c = top->plot.frame,
                            e = d.looks[3].plot.frame;
        CHECK_NEAR(a.x, 20, 1e-12);
        CHECK_NEAR(a.y, 25, 1e-12);
        CHECK_NEAR(b.x - a.x - a.width, 30, 1e-9);
        CHECK_NEAR(c.y - a.y - a.height, 30, 1e-9);
        CHECK_NEAR(b.x + b.width, 380, 1e-9);
        CHECK_NEAR(c.y + c.height, d.height - 15, 1e-9);
        CHECK(e.x == b.x && e.y == c.y && e.width == b.width && e.height == c.height);
        CHECK(b.y == a.y && b.height == a.height && c.x == a.x && c.width == a.width);
    }
}
