/* The polygon in the plane over which a fill is judged. */
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <string.h>

/* The lengths of the sides, none so long that the others could not close the polygon. */
static batten_status side_lengths(const bat_fill_loop *loop, double *lengths)
{
    double sum = 0;
    for (int i = 0; i < loop->count; i++) {
        double last[3];
        lengths[i] = 0;
        for (int k = 0; k <= 32; k++) {
            double point[3];
            const batten_status status =
                batten_curve_evaluate(loop->sides[i].curve, k / 16.0, 0, point);
            if (status != BATTEN_OK)
                return status;
            if (k > 0)
                lengths[i] += bat_distance(3, last, point);
            memcpy(last, point, sizeof last);
        }
        sum += lengths[i];
    }
    /* Corners as flat as those of a long side, or as sharp as those of a short one, would make
     * quads that are hardly any. */
    const double mean = sum / loop->count;
    for (int i = 0; i < loop->count; i++)
        lengths[i] = bat_max(mean / 2, bat_min(1.5 * mean, lengths[i]));
    return BATTEN_OK;
}

/* The angles at the centre of the circle on which all corners lie. */
static void central_angles(int n, const double *lengths, double *angles)
{
    double longest = 0;
    for (int i = 0; i < n; i++)
        longest = bat_max(longest, lengths[i]);
    /* sin(angle / 2) = length / diameter, and the angles sum to a turn; the side may have the
     * centre outside only in polygons that the bounds on the lengths rule out */
    double low = longest, high = longest * n;
    for (int k = 0; k < 60; k++) {
        const double diameter = (low + high) / 2;
        double sum = 0;
        for (int i = 0; i < n; i++)
            sum += 2 * bat_asin(bat_min(1, lengths[i] / diameter));
        if (sum > 2 * BAT_PI)
            low = diameter;
        else
            high = diameter;
    }
    double sum = 0;
    for (int i = 0; i < n; i++) {
        angles[i] = 2 * bat_asin(bat_min(1, lengths[i] / high));
        sum += angles[i];
    }
    for (int i = 0; i < n; i++)
        angles[i] *= 2 * BAT_PI / sum;
}

static batten_status segment(const double a[2], const double b[2], batten_curve **out)
{
    const double points[6] = {a[0], a[1], 0, b[0], b[1], 0}, knots[4] = {0, 0, 2, 2};
    return batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, out);
}

/* The quad between a corner, the middles of its sides, and the centre, bilinear. */
static batten_status quarter(const double corner[2], const double after[2],
                             const double before[2], const double centre[2],
                             batten_surface **out)
{
    static const double knots[4] = {0, 0, 1, 1};
    const batten_axis axis = {1, 2, knots, false};
    const double net[12] = {corner[0], corner[1], 0, before[0], before[1], 0,
                            after[0],  after[1],  0, centre[0], centre[1], 0};
    return batten_surface_create(3, &axis, &axis, net, NULL, out);
}

/* The polygon as a loop without slopes, and its bilinear quads. */
static batten_status polygon(int n, const double *angles, bat_fill_loop *loop,
                             batten_surface **quads)
{
    double corners[BATTEN_FILL_SIDES][2], middles[BATTEN_FILL_SIDES][2], centre[2] = {0, 0};
    double turned = 0;
    for (int i = 0; i < n; i++) {
        corners[i][0] = bat_cos(turned);
        corners[i][1] = bat_sin(turned);
        turned += angles[i];
        for (int c = 0; c < 2; c++)
            centre[c] += corners[i][c] / n;
    }
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 2; c++)
            middles[i][c] = (corners[i][c] + corners[(i + 1) % n][c]) / 2;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        status = segment(corners[i], corners[(i + 1) % n], &loop->sides[i].curve);
        if (status == BATTEN_OK) {
            loop->count = i + 1;
            status =
                quarter(corners[i], middles[i], middles[(i + n - 1) % n], centre, &quads[i]);
        }
    }
    return status;
}

/* Bilinear quads do not meet smoothly along the spokes the way those of a fill do: so the
 * polygon itself is filled first, judged over them. */
batten_status bat_fill_plane(const bat_fill_loop *loop, batten_surface **plane)
{
    double lengths[BATTEN_FILL_SIDES], angles[BATTEN_FILL_SIDES];
    batten_surface *quads[BATTEN_FILL_SIDES] = {NULL};
    bat_fill_loop flat = {.size = 1};
    bat_fill *fill = bat_array(1, sizeof *fill);
    batten_status status = fill ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = side_lengths(loop, lengths);
    if (status == BATTEN_OK) {
        central_angles(loop->count, lengths, angles);
        status = polygon(loop->count, angles, &flat, quads);
    }
    if (status == BATTEN_OK)
        status = bat_fill_make(&flat, quads, fill);
    for (int i = 0; status == BATTEN_OK && i < loop->count; i++)
        status = bat_fill_patch(fill, i, 1, &plane[i]);
    if (fill)
        bat_fill_end(fill);
    bat_release(fill);
    bat_fill_loop_free(&flat);
    for (int i = 0; i < BATTEN_FILL_SIDES; i++)
        batten_surface_unref(quads[i]);
    return status;
}
