/* The directions of a view, from its name or from azimuth and elevation. */
#include "picture/sheet/view.h"

bat_view bat_view_make(batten_view view, double azimuth, double elevation)
{
    switch (view) {
    case BATTEN_VIEW_TOP:
        return (bat_view){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case BATTEN_VIEW_FRONT:
        return (bat_view){{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    case BATTEN_VIEW_SIDE:
        return (bat_view){{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    case BATTEN_VIEW_ISOMETRIC:
        azimuth = BAT_PI / 4;
        elevation = bat_atan(sqrt(0.5));
        break;
    case BATTEN_VIEW_AUTO:
    case BATTEN_VIEW_AXONOMETRIC:
        break;
    }
    const double ca = bat_cos(azimuth), sa = bat_sin(azimuth), ce = bat_cos(elevation),
                 se = bat_sin(elevation);
    return (bat_view){{-sa, ca, 0}, {-se * ca, -se * sa, ce}, {ce * ca, ce * sa, se}};
}
