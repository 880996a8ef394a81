/* The size of a picture: the height that its shape needs, and that of its letters. */
#include "picture/sheet/size.h"

batten_status bat_size_check(const batten_draw_options *o)
{
    return bat_canvas_check_size(o->width, o->height != 0 ? o->height : o->width);
}

double bat_size_em(const batten_draw_options *o)
{
    /* As in a picture of the usual shape, 3 : 2, of this width. */
    const double height = o->height != 0 ? o->height : 2.0 / 3 * o->width;
    return bat_max(5, 0.0165 * bat_min(o->width, height));
}

int bat_size_height(const batten_draw_options *o, double frame_width, const double range[2],
                    double around)
{
    if (o->height != 0)
        return o->height;
    /* What has no width needs all the height there is. */
    const double share = range[0] > 0 ? range[1] / range[0] : HUGE_VAL;
    const double wanted = around + frame_width * share;
    const double least = bat_max(0.25 * o->width, bat_min(BAT_LEAST_SIZE, o->width));
    return (int)(bat_max(least, bat_min(wanted, o->width)) + 0.5);
}

void bat_size_take_share(batten_draw_options *o, double share)
{
    if (o->height == 0)
        o->height = (int)(share * o->width + 0.5);
}
