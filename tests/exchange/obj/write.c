/* How curves are written: as lines where the statement means the same to the bit. */
#include "exchange/shapes.h"

/* A polyline of three points in the plane z = 0. */
static const double corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0};

static const struct {
    double knots[5];
    bool has_weights, is_line;
} polylines[] = {
    {{0, 0, 1, 2, 2}, false, true},     {{0, 0, 1, 2, 2}, true, false},
    {{-0.0, 0, 1, 2, 2}, false, false}, {{0, -0.0, 1, 2, 2}, false, false},
    {{0, 0, 0.5, 1, 1}, false, false},
};

TEST(curves_are_lines_only_where_the_statement_means_their_knots)
{
    static const double weights[] = {1, 2, 1};
    for (int k = 0; k < COUNT(polylines); k++) {
        batten_write_options options = batten_write_defaults();
        batten_curve *curve = NULL;
        batten_model *model = NULL;
        char *data = NULL;
        size_t size = 0;
        options.format = BATTEN_FORMAT_OBJ;
        CHECK_OK(batten_model_create(0.001, &model));
        CHECK_OK(batten_curve_create((batten_points){3, 3, corners}, 1,
                                     polylines[k].has_weights ? weights : NULL,
                                     polylines[k].knots, &curve));
        add_curve(model, "keel", curve);
        CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
        CHECK_INT(strstr(data, "\nl 1 2 3\n") != NULL, polylines[k].is_line);
        CHECK_INT(strstr(data, "\ncurv ") != NULL, !polylines[k].is_line);
        CHECK_INT(strstr(data, "cstype rat bspline\n") != NULL, polylines[k].has_weights);
        batten_release(data);
        batten_model_unref(model);
        batten_curve_unref(curve);
    }
}
