/* Names cover neither lines nor each other: measured on what is drawn. */
#include "picture/scenes.h"
#include "picture/sheet/canvas.h"

#include <stdlib.h>

typedef struct {
    double left, top, right, bottom;
} box;

typedef struct {
    int box_count, segment_count;
    box *boxes;            /* the white grounds of labels */
    double (*segments)[4]; /* of all strokes but the pale ones of grids */
} drawn;

enum { MOST_BOXES = 2000, MOST_SEGMENTS = 200000 };

/* The points of a path: "M x y L x y ...". */
static int read_path(const char *d, int most, double (*points)[2])
{
    int count = 0;
    while (count < most && (*d == 'M' || *d == 'L')) {
        char *end = NULL;
        points[count][0] = strtod(d + 1, &end);
        points[count][1] = strtod(end, &end);
        count++;
        d = end + strspn(end, " ");
    }
    return count;
}

static bool is_pale(const char *path)
{
    int red = 0, green = 0, blue = 0;
    const char *colour = strstr(path, "stroke:rgb(");
    return !colour || sscanf(colour, "stroke:rgb(%d%%,%d%%,%d%%)", &red, &green, &blue) != 3 ||
           (red >= 72 && green >= 75 && blue >= 78);
}

static void read_stroke(drawn *to, int count, double (*points)[2])
{
    for (int i = 0; i + 1 < count && to->segment_count < MOST_SEGMENTS; i++)
        memcpy(to->segments[to->segment_count++], points[i], 4 * sizeof(double));
}

/* Labels are a line high, title blocks are not. The letters keep a third of their size from the ends of their ground. */
static void read_ground(drawn *to, double (*points)[2])
{
    const double inside = 0.7;
    if (to->box_count < MOST_BOXES && fabs(points[2][1] - points[0][1]) < 20)
        to->boxes[to->box_count++] = (box){points[0][0] + inside, points[0][1] + inside,
                                           points[2][0] - inside, points[2][1] - inside};
}

static drawn read_svg(const char *svg)
{
    enum { MOST_POINTS = 20000 };
    drawn out = {0, 0, test_array(MOST_BOXES, sizeof(box)),
                 test_array(MOST_SEGMENTS, 4 * sizeof(double))};
    double(*points)[2] = test_array(MOST_POINTS, sizeof *points);
    for (const char *at = strstr(svg, "<path style="); at;
         at = strstr(at + 1, "<path style=")) {
        const char *d = strstr(at, " d=\"");
        const int count = read_path(d + 4, MOST_POINTS, points);
        if (strncmp(at, "<path style=\"fill:none;", 23) == 0 && !is_pale(at))
            read_stroke(&out, count, points);
        else if (strstr(at, "fill:rgb(100%,100%,100%)") < d && count >= 4 &&
                 strstr(at, "fill:rgb(100%,100%,100%)"))
            read_ground(&out, points);
    }
    return out;
}

/* Does the segment meet the box? Clipped by its four sides. */
static bool meets(const double s[4], box b)
{
    double from = 0, to = 1;
    const double low[2] = {b.left, b.top}, high[2] = {b.right, b.bottom};
    for (int k = 0; k < 2; k++) {
        const double along = s[2 + k] - s[k];
        if (along == 0) {
            if (s[k] < low[k] || s[k] > high[k])
                return false;
            continue;
        }
        const double one = (low[k] - s[k]) / along, other = (high[k] - s[k]) / along;
        from = fmax(from, fmin(one, other));
        to = fmin(to, fmax(one, other));
    }
    return from <= to;
}

static void check_labels(const char *svg, int least)
{
    const drawn d = read_svg(svg);
    CHECK(d.box_count >= least);
    CHECK(d.segment_count > 0 && d.segment_count < MOST_SEGMENTS);
    for (int i = 0; i < d.box_count; i++) {
        const box a = d.boxes[i];
        for (int k = 0; k < i; k++) {
            const box b = d.boxes[k];
            CHECK(a.left >= b.right || b.left >= a.right || a.top >= b.bottom ||
                  b.top >= a.bottom);
        }
        for (int k = 0; k < d.segment_count; k++)
            if (meets(d.segments[k], a)) {
                fprintf(
                    stderr,
                    "a line from %g, %g to %g, %g runs through the label at %g, %g to %g, %g\n",
                    d.segments[k][0], d.segments[k][1], d.segments[k][2], d.segments[k][3],
                    a.left, a.top, a.right, a.bottom);
                CHECK(!"a label covers a line");
            }
    }
}

/* Curves that end in the middle of each other, more than colours can tell apart. */
static batten_model *crossing_curves(int count)
{
    batten_model *model = scene_empty();
    for (int i = 0; i < count; i++) {
        char name[24];
        snprintf(name, sizeof name, "curve %d", i + 1);
        const double turn = 2.4 * i, c = cos(turn), s = sin(turn);
        const double points[] = {4 * c, 3 * s, c - 2 * s, s + 2 * c, 0.3 * i, 0.1 * i * c};
        scene_add_curve(model, name, scene_curve(2, 2, 3, points));
    }
    return model;
}

TEST(names_of_curves_cover_no_curve_and_no_name)
{
    batten_model *model = crossing_curves(24);
    batten_draw_options options = batten_draw_defaults();
    options.format = BATTEN_PICTURE_SVG;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw(model, &options, &data, &size));
    check_labels(data, 24);
    batten_release(data);
    batten_model_unref(model);
}

TEST(values_of_contours_cover_no_contour)
{
    batten_model *model = scene_of(scene_torus(3, 1));
    batten_draw_options options = batten_draw_defaults();
    options.format = BATTEN_PICTURE_SVG;
    options.contours = true;
    options.contour_spacing = 0.2;
    options.isolines = 1;
    options.view = BATTEN_VIEW_TOP;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_surface_lines(model, &options, NULL, &data, &size));
    check_labels(data, 3);
    batten_release(data);
    batten_model_unref(model);
}

TEST(labels_of_a_lines_plan_cover_no_line)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    batten_draw_options options = batten_draw_defaults();
    options.format = BATTEN_PICTURE_SVG;
    options.width = 1684;
    const batten_draw_lines_plan_options plan = scene_plan(10);
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_lines_plan(model, &plan, &options, NULL, &data, &size));
    check_labels(data, 10);
    batten_release(data);
    batten_model_unref(model);
}

/* ---- on a canvas ---- */

static const bat_lettering letters = {{0, 0, 0}, 10, true};

TEST(a_name_stands_beside_its_place_and_gives_way)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 300, 200, 10, "", &canvas));
    const double at[2] = {150, 100};
    const bat_pen pen = {{0, 0, 0}, 1, BAT_SOLID};
    for (int i = 0; i < 3; i++)
        bat_canvas_name(&canvas, letters, 1, at, "name");
    bat_canvas_segment(&canvas, pen, 155, 0, 155, 200);
    bat_canvas_place_names(&canvas);
    if (canvas.status == BATTEN_OK) {
        int count = 0;
        for (size_t i = 0; i < canvas.taken_count; i++) {
            const bat_rectangle a = canvas.taken[i];
            CHECK(a.x > 155.5 || a.x + a.width < 154.5);
            CHECK(hypot(a.x + 0.5 * a.width - 150, a.y + 0.5 * a.height - 100) < 60);
            count += a.height == 10; /* each ground and its letters */
        }
        CHECK_INT(count, 6);
    }
    bat_canvas_end(&canvas);
}

TEST(without_room_there_is_no_name)
{
    bat_canvas canvas;
    CHECK_OK(bat_canvas_begin(BATTEN_PICTURE_PNG, 300, 200, 10, "", &canvas));
    const bat_pen pen = {{0, 0, 0}, 1, BAT_SOLID};
    for (int x = 0; x < 300; x += 6)
        bat_canvas_segment(&canvas, pen, x, 0, x, 200);
    bat_canvas_name(&canvas, letters, 1, (const double[2]){150, 100}, "name");
    bat_canvas_place_names(&canvas);
    CHECK_INT(canvas.taken_count, 0);
    bat_canvas_end(&canvas);
}
