/* Lines on shaded surfaces are where the curves are, and all that is filled in covers its samples. */
#include "picture/shaded/shade.h"

#include "picture/scenes.h"

/* A square in the plane, 0 .. 3, whose inner control points are drawn aside: its isolines bow. */
static batten_surface *bowed_square(void)
{
    static const double points[16][3] = {{0, 0, 0}, {0, 1, 0},     {0, 2, 0},     {0, 3, 0},
                                         {1, 0, 0}, {1.9, 0.3, 0}, {0.6, 2, 0},   {1, 3, 0},
                                         {2, 0, 0}, {1.5, 1.9, 0}, {2.4, 2.6, 0}, {2, 3, 0},
                                         {3, 0, 0}, {3, 1, 0},     {3, 2, 0},     {3, 3, 0}};
    return scene_net(3, 4, 3, 4, points[0]);
}

/* Where the line runs through column x of the pixels, from how dark those around `y` are. */
static double line_in_column(const scene_image *image, int x, double y)
{
    double weight = 0, moment = 0;
    for (int row = (int)y - 4; row <= (int)y + 4; row++) {
        const double dark = 255 - scene_green(scene_pixel(image, x, row));
        const double own =
            fmax(0, dark - (255 - scene_green(scene_pixel(image, x, (int)y - 8))));
        weight += own;
        moment += own * (row + 0.5);
    }
    return moment / weight;
}

TEST(isolines_of_a_patch_are_its_curves_within_a_third_of_a_pixel)
{
    batten_surface *square = bowed_square();
    batten_draw_options options = batten_draw_defaults();
    options.shading = BATTEN_SHADING_ISOLINES;
    options.width = options.height = 600;
    options.isolines = 2;
    options.view = BATTEN_VIEW_TOP;
    /* Two letters of 600 x 0.0165 stay free around the square. */
    const double margin = 2 * 0.0165 * 600, scale = (600 - 2 * margin) / 3;
    batten_model *model = scene_of(square);
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_shaded(model, &options, NULL, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    for (int i = 0; i < 400; i++) {
        double p[3];
        const double u = 0.05 + 0.9 * i / 400;
        CHECK_OK(batten_surface_evaluate(batten_model_object(model, 0)->surface, u, 0.5, 0, p));
        const double x = margin + scale * p[0], y = 600 - margin - scale * p[1];
        /* Where a sample is in the middle of a column, away from the other isoline. */
        if (fabs(x - floor(x) - 0.5) < 0.05 && fabs(u - 0.5) > 0.05)
            CHECK_NEAR(line_in_column(&image, (int)x, y), y, 0.34);
    }
    batten_model_unref(model);
}

/* ---- filled in, against samples that are asked one by one ---- */

enum { WIDE = 64, HIGH = 70, SAMPLES_X = WIDE * BAT_SAMPLES, SAMPLES_Y = HIGH * BAT_SAMPLES };

typedef struct {
    float depth[SAMPLES_Y][SAMPLES_X];
    bat_light light[SAMPLES_Y][SAMPLES_X];
} expected_samples;

/* White above and a pale blue below. */
static expected_samples *background(void)
{
    expected_samples *e = test_array(1, sizeof *e);
    for (int y = 0; y < SAMPLES_Y; y++)
        for (int x = 0; x < SAMPLES_X; x++) {
            const double t = (y + 0.5) / SAMPLES_Y;
            e->depth[y][x] = -HUGE_VALF;
            e->light[y][x] = (bat_light){1 - 0.2 * t, 1 - 0.16 * t, 1 - 0.12 * t};
        }
    return e;
}

/* Is (x, y) within a convex polygon [count][2]? */
static bool is_inside(int count, const double *corners, double x, double y)
{
    int left = 0, right = 0;
    for (int k = 0; k < count; k++) {
        const double *a = corners + 2 * k, *b = corners + 2 * ((k + 1) % count);
        const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

static void paint(expected_samples *e, int count, const double *corners, double depth,
                  bat_light light)
{
    for (int y = 0; y < SAMPLES_Y; y++)
        for (int x = 0; x < SAMPLES_X; x++)
            if (depth > e->depth[y][x] && is_inside(count, corners, x + 0.5, y + 0.5)) {
                e->depth[y][x] = (float)depth;
                e->light[y][x] = light;
            }
}

/* `half` to both sides and beyond the ends; along x where both ends are one. */
static void paint_line(expected_samples *e, const double from[2], const double to[2],
                       double half, double depth, bat_light light)
{
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const double c = half * (length > 0 ? (to[0] - from[0]) / length : 1),
                 s = half * (length > 0 ? (to[1] - from[1]) / length : 0);
    const double corners[4][2] = {{from[0] - c - s, from[1] - s + c},
                                  {from[0] - c + s, from[1] - s - c},
                                  {to[0] + c + s, to[1] + s - c},
                                  {to[0] + c - s, to[1] + s + c}};
    paint(e, 4, corners[0], depth, light);
}

static void paint_dot(expected_samples *e, double x, double y, double radius, double depth,
                      bat_light light)
{
    double corners[10][2];
    for (int k = 0; k < 10; k++) {
        corners[k][0] = x + radius * cos(0.62831853071795865 * k);
        corners[k][1] = y + radius * sin(0.62831853071795865 * k);
    }
    paint(e, 10, corners[0], depth, light);
}

static double square_root_of_mean(const expected_samples *e, int x, int y, int channel)
{
    double sum = 0;
    for (int j = 0; j < BAT_SAMPLES; j++)
        for (int i = 0; i < BAT_SAMPLES; i++) {
            const bat_light *l = &e->light[BAT_SAMPLES * y + j][BAT_SAMPLES * x + i];
            sum += channel == 0 ? l->red : channel == 1 ? l->green : l->blue;
        }
    return 255 * sqrt(fmin(1, sum / (BAT_SAMPLES * BAT_SAMPLES)));
}

static batten_status draw_filled(const bat_shaded *p, char **data, size_t *size)
{
    bat_canvas canvas;
    batten_status status = bat_canvas_begin(BATTEN_PICTURE_PNG, WIDE, HIGH, 10, "", &canvas);
    if (status != BATTEN_OK)
        return status;
    status = bat_shaded_fill(p, &canvas);
    if (status == BATTEN_OK)
        return bat_canvas_finish(&canvas, data, size);
    bat_canvas_end(&canvas);
    return status;
}

static void check_picture(const bat_shaded *p, const expected_samples *e)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(draw_filled(p, &data, &size));
    const scene_image image = scene_decode(data, size);
    batten_release(data);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            const uint32_t pixel = scene_pixel(&image, x, y);
            CHECK_NEAR(scene_red(pixel), square_root_of_mean(e, x, y, 0), 1);
            CHECK_NEAR(scene_green(pixel), square_root_of_mean(e, x, y, 1), 1);
            CHECK_NEAR(scene_blue(pixel), square_root_of_mean(e, x, y, 2), 1);
        }
}

static bat_light darker(bat_light light, double share)
{
    return (bat_light){share * light.red, share * light.green, share * light.blue};
}

/* Bands are 32 pixels high, and end at the samples 96 and 192: lines and dots lie across, at and
 * just beside these. Levels of depth say which of them is seen. */
static double lines[][2][3] = {
    {{3.4, 94.2, 1}, {110.3, 94.2, 1}},     /* reaches beyond the first band */
    {{3.4, 101.3, -2}, {110.3, 101.3, -2}}, /* and so does this upwards, behind all others */
    {{5.1, 130.2, 3}, {100.4, 206.3, 3}},   /* oblique */
    {{100.3, 5.6, 0}, {60.2, 40.1, 0}},     /* leftwards */
    {{95.2, 190.3, 0}, {95.2, 190.3, 0}},   /* a point */
    {{20.3, 191.2, 8}, {20.3, 191.2, 8}},   /* a dot across the border */
    {{50.2, 97.3, 2}, {50.2, 97.3, 2}},     /* a dot before the surface */
};

TEST(curves_and_dots_cover_their_samples_across_bands)
{
    static const bat_light red = {0.8, 0.1, 0.2}, green = {0.1, 0.5, 0.3};
    bat_stroke strokes[COUNT(lines)];
    bat_shaded_style styles[COUNT(lines)];
    expected_samples *e = background();
    for (int i = 0; i < COUNT(lines); i++) {
        const bool is_dot = i >= 5;
        const bat_light light = i % 2 ? red : green;
        strokes[i] = (bat_stroke){is_dot ? 1 : 2, lines[i][0]};
        styles[i] = (bat_shaded_style){light, is_dot ? 5.3 : 0};
        if (is_dot)
            paint_dot(e, lines[i][0][0], lines[i][0][1], 5.3, lines[i][0][2] + 5.3, light);
        else
            paint_line(e, lines[i][0], lines[i][1], 2.7, lines[i][0][2] + 9, light);
    }
    batten_draw_options options = batten_draw_defaults();
    options.width = WIDE;
    options.height = HIGH;
    const bat_shaded p = {
        .options = &options, .curves = {COUNT(lines), 0, strokes}, .styles = styles};
    check_picture(&p, e);
}

/* Twice the area of a, b and (x, y), above 0 on one side. */
static double side_of(const double a[2], const double b[2], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/* A triangle whose corners have colours of their own. */
static void paint_dyed(expected_samples *e, const double (*c)[2], double depth,
                       const bat_light dyes[3], const bat_scene *scene, const double normal[3])
{
    const double area = side_of(c[0], c[1], c[2][0], c[2][1]);
    for (int y = 0; y < SAMPLES_Y; y++)
        for (int x = 0; x < SAMPLES_X; x++) {
            if (!(depth > e->depth[y][x]) || !is_inside(3, c[0], x + 0.5, y + 0.5))
                continue;
            bat_light own = {0, 0, 0};
            for (int k = 0; k < 3; k++) {
                const double w =
                    side_of(c[(k + 1) % 3], c[(k + 2) % 3], x + 0.5, y + 0.5) / area;
                own.red += w * dyes[k].red;
                own.green += w * dyes[k].green;
                own.blue += w * dyes[k].blue;
            }
            e->light[y][x] = bat_light_of_sample(scene, own, NAN, normal);
        }
}

TEST(coloured_vertices_dye_a_triangle_between_them)
{
    static const double facet[3][2] = {{15.3, 30.2}, {172.6, 95.1}, {58.1, 190.7}};
    bat_light dyes[3] = {{1, 0, 0.2}, {0, 0.8, 0.1}, {0.1, 0.3, 1}};
    double corners[3][3], flat[3] = {0, 0.6, 0.8};
    for (int k = 0; k < 3; k++)
        memcpy(corners[k], (double[]){facet[k][0], facet[k][1], k}, sizeof corners[k]);
    static const int order[3] = {0, 1, 2};
    const batten_mesh_parts parts = {.vertex_count = 3, .triangle_count = 1, .corners = order};
    const bat_view view = bat_view_make(BATTEN_VIEW_TOP, 0, 0);
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_PLAIN, &view, 0, 5);
    bat_mesh_solid mesh = {
        .mesh = &parts, .points = corners[0], .flat = flat, .dyes = dyes, .scene = &scene};
    batten_draw_options options = batten_draw_defaults();
    options.width = WIDE;
    options.height = HIGH;
    expected_samples *e = background();
    paint_dyed(e, facet, 0, dyes, &scene, flat);
    check_picture(&(bat_shaded){.options = &options, .mesh_count = 1, .meshes = &mesh}, e);
}

/* A surface over three bands with an isoline and an edge, and a triangle of a mesh with its line. */
TEST(surfaces_and_meshes_cover_their_samples_under_their_lines)
{
    static const double outline[4][2] = {
        {10.2, 50.3}, {10.2, 200.6}, {80.7, 200.6}, {80.7, 50.3}};
    static const double facet[3][2] = {{85.3, 80.2}, {112.6, 95.1}, {88.1, 120.7}};
    double points[4][3], normals[4][3], corners[3][3], upward[3][3];
    for (int k = 0; k < 4; k++) {
        /* Along v first. */
        memcpy(points[k], (double[]){k / 2 ? 80.7 : 10.2, k % 2 ? 200.6 : 50.3, 2},
               sizeof points[k]);
        memcpy(normals[k], (double[]){0, 0, 3}, sizeof normals[k]);
    }
    for (int k = 0; k < 3; k++) {
        memcpy(corners[k], (double[]){facet[k][0], facet[k][1], 5}, sizeof corners[k]);
        memcpy(upward[k], (double[]){0.6, 0, 0.8}, sizeof upward[k]);
    }
    double isoline[2][3] = {{20.4, 97.3, 2}, {70.2, 97.3, 2}};
    double edge[2][3] = {{80.7, 50.3, 2}, {80.7, 200.6, 2}};
    double side[2][3] = {{85.3, 80.2, 5}, {112.6, 95.1, 5}};
    bat_stroke strokes[3] = {{2, isoline[0]}, {2, edge[0]}, {2, side[0]}};
    static const bat_light blue = {0.2, 0.3, 0.7}, yellow = {0.7, 0.6, 0.1};
    static const int order[3] = {0, 1, 2};
    const batten_mesh_parts parts = {
        .vertex_count = 3, .triangle_count = 1, .corners = order, .normals = upward[0]};
    const bat_view view = bat_view_make(BATTEN_VIEW_TOP, 0, 0);
    const bat_scene scene = bat_scene_make(BATTEN_SHADING_PLAIN, &view, 0, 5);
    bat_shaded_solid solid = {
        .tiles = {.count_u = 2, .count_v = 2, .points = points[0], .normals = normals[0]},
        .scene = &scene,
        .albedo = blue,
        .isolines = {1, 0, &strokes[0]},
        .edges = {1, 0, &strokes[1]}};
    bat_mesh_solid mesh = {.mesh = &parts,
                           .points = corners[0],
                           .scene = &scene,
                           .albedo = yellow,
                           .lines = {1, 0, &strokes[2]}};
    batten_draw_options options = batten_draw_defaults();
    options.width = WIDE;
    options.height = HIGH;
    const bat_shaded p = {.options = &options,
                          .solid_count = 1,
                          .mesh_count = 1,
                          .solids = &solid,
                          .meshes = &mesh};
    expected_samples *e = background();
    paint(e, 4, outline[0], 2, bat_light_of_sample(&scene, blue, 0, (double[]){0, 0, 1}));
    paint(e, 3, facet[0], 5, bat_light_of_sample(&scene, yellow, NAN, upward[0]));
    paint_line(e, isoline[0], isoline[1], 1.5, 8, darker(blue, 0.09));
    paint_line(e, edge[0], edge[1], 2.1, 8, darker(blue, 0.05));
    paint_line(e, side[0], side[1], 2.1, 11, darker(yellow, 0.05));
    check_picture(&p, e);
}
