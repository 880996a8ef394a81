/* Options of G-code: their defaults, and what they may be. */
#include "exchange/gcode/gcode.h"

batten_write_gcode_options batten_write_gcode_defaults(void)
{
    return (batten_write_gcode_options){
        .size = sizeof(batten_write_gcode_options), .depth = (double)NAN, .decimals = -1};
}

batten_status bat_gcode_check_options(const batten_write_gcode_options *o)
{
    if (!(o->feed >= 0 && o->plunge >= 0 && o->clearance >= 0 && isfinite(o->feed) &&
          isfinite(o->plunge) && isfinite(o->clearance)))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "feed %g, plunge %g and clearance %g must be finite, 0 or more",
                        o->feed, o->plunge, o->clearance);
    if (isinf(o->depth))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the depth is %g; it must be finite", o->depth);
    if (!(o->greatest_radius >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the greatest radius is %g; it must be 0 or more",
                        o->greatest_radius);
    if (o->decimals < -1 || o->decimals > 9)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d decimals; there may be 0 to 9", o->decimals);
    return BATTEN_OK;
}
