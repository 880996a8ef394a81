/* The defaults of pictures. */
#include "base/base.h"
#include <batten/picture.h>

batten_draw_options batten_draw_defaults(void)
{
    return (batten_draw_options){
        .size = sizeof(batten_draw_options),
        .format = BATTEN_PICTURE_PNG,
        .width = 1200,
        .height = 0,
        .title = "",
        .view = BATTEN_VIEW_AUTO,
        /* From ahead of the bow, to port, a little above: both bows show, and little of the
         * inside. */
        .azimuth = 28 * BAT_PI / 180,
        .elevation = 12 * BAT_PI / 180,
        .shading = BATTEN_SHADING_PLAIN,
        .isolines = 10,
        .stripes = 24,
        .contour_field = {.kind = BATTEN_FIELD_HEIGHT, .direction = {0, 0, 1}},
        .stereo_angle = 5 * BAT_PI / 180,
    };
}

batten_draw_lines_plan_options batten_draw_lines_plan_defaults(void)
{
    return (batten_draw_lines_plan_options){.size = sizeof(batten_draw_lines_plan_options),
                                            .design_waterline = (double)NAN,
                                            .diagonals = -1};
}
