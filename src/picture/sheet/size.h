/* The size of a picture: the height that its shape needs, and that of its letters. */
#ifndef BAT_PICTURE_SIZE_H
#define BAT_PICTURE_SIZE_H
#include "picture/sheet/canvas.h"

/* BAD_ARGUMENT or TOO_LARGE; a height of 0 follows the shape and is always good. */
batten_status bat_size_check(const batten_draw_options *options);
/* The size of ordinary text. */
double bat_size_em(const batten_draw_options *options);
/* The height of a picture of something `range` [2] large in a frame of this width, with `around` above
 * and below the frame: so that the shape fills the frame, but at least a quarter of the width and
 * at most the width. A height that was asked for stays. */
int bat_size_height(const batten_draw_options *options, double frame_width,
                    const double range[2], double around);
/* Where the shape does not tell it: this share of the width. */
void bat_size_take_share(batten_draw_options *options, double share);

#endif
