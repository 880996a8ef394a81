/* How many inflections of a polyline can be seen: those between bulges of some height. */
#include "base/base.h"
#include <batten/fair.h>

/* How far points first .. last bulge from the chord of their outer neighbours. */
static double bulge(const double *points, int first, int last)
{
    const double *a = points + 2 * (first - 1), *b = points + 2 * (last + 1);
    const double x = b[0] - a[0], y = b[1] - a[1], length = bat_hypot(x, y);
    double height = 0;
    for (int i = first; i <= last; i++) {
        const double dx = points[2 * i] - a[0], dy = points[2 * i + 1] - a[1];
        const double h = length > 0 ? fabs(x * dy - y * dx) / length : bat_hypot(dx, dy);
        height = bat_max(height, h);
    }
    return height;
}

static int turning(const double *p)
{
    const double turn = (p[0] - p[-2]) * (p[3] - p[1]) - (p[1] - p[-1]) * (p[2] - p[0]);
    return (turn > 0) - (turn < 0);
}

int batten_polyline_inflections(int count, const double *points, double height)
{
    int found = 0, before = 0;
    for (int first = 1, last; first < count - 1; first = last + 1) {
        const int sign = turning(points + 2 * first);
        for (last = first; last + 1 < count - 1 && turning(points + 2 * (last + 1)) == sign;)
            last++;
        if (sign == 0 || bulge(points, first, last) <= height)
            continue;
        found += before && sign != before;
        before = sign;
    }
    return found;
}
