/* Lines on shaded surfaces are where the curves are. */
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
