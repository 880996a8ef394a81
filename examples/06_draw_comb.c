/* A curve with its points, control polygon and curvature comb, as an SVG picture. */
#include <batten/batten.h>
#include <batten/picture.h>
#include <stdio.h>
#include <stdlib.h>

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "%s: %s\n", batten_status_text(status), batten_message());
    exit(1);
}

int main(void)
{
    const double points[][3] = {{0, 0, 0},   {1, 1, 0},   {3, 1.4, 0},
                                {5, 0.4, 0}, {6, 0.6, 0}, {7, 1.6, 0}};
    batten_curve *curve = NULL;
    must(batten_curve_interpolate((batten_points){3, 6, &points[0][0]}, NULL, NULL, &curve));

    batten_model *model = NULL;
    must(batten_model_create(1, &model));
    must(batten_model_add(model, &(batten_object){.name = "curve",
                                                  .kind = BATTEN_OBJECT_CURVE,
                                                  .curve = curve,
                                                  .point_count = 6,
                                                  .points = &points[0][0]}));

    batten_draw_options options = batten_draw_defaults();
    options.format = BATTEN_PICTURE_SVG;
    options.title = "Six points, one cubic spline";
    options.comb = options.data_points = options.control_polygon = true;
    char *data = NULL;
    size_t size = 0;
    must(batten_draw(model, &options, &data, &size));
    must(batten_save_file("comb.svg", data, size));
    printf("wrote comb.svg\n");

    batten_release(data);
    batten_model_unref(model);
    batten_curve_unref(curve);
    return 0;
}
