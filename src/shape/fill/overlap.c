/*
 * Does a fill turn back over itself? Where the hole can be seen as a whole along its mean
 * normal, every normal of the fill looks to that side. This also finds what a smooth surface
 * does that curls over without a crease, as in a re-entrant corner, and surfaces that lie on
 * others of the same fill.
 */
#include "numeric/vector.h"
#include "shape/fill/fill.h"

enum { RIM_PLACES = 32, MOST_PLACES = BATTEN_FILL_SIDES * RIM_PLACES, PLACES = 24 };

/* Ribbons whose planes stand steeper on the mean plane than 72 degrees may bulge out. */
static const double least_cosine = 0.3;

/* The rim in places that are evenly spread over each side, round the loop. */
typedef struct {
    int count;
    double points[MOST_PLACES][3];
    double flat[MOST_PLACES][2]; /* seen along the mean normal */
    double normal[3];
} rim_view;

static batten_status sample_rim(const bat_fill_loop *loop, rim_view *rim)
{
    for (int i = 0; i < loop->count; i++)
        for (int k = 0; k < RIM_PLACES; k++) {
            const batten_status status = batten_curve_evaluate(
                loop->sides[i].curve, 2.0 * k / RIM_PLACES, 0, rim->points[rim->count]);
            if (status != BATTEN_OK)
                return status;
            rim->count++;
        }
    return BATTEN_OK;
}

/* The direction of the vector of the area, and the rim seen along it; false for a rim that goes
 * around none. */
static bool flatten(rim_view *rim)
{
    batten_vec3 area = {0, 0, 0};
    for (int i = 0; i < rim->count; i++)
        area = bat_vec3_add(area,
                            bat_vec3_cross(bat_vec3_of(3, rim->points[i]),
                                           bat_vec3_of(3, rim->points[(i + 1) % rim->count])));
    const double size = bat_vec3_norm(area);
    if (!(size > 1e-3))
        return false;
    const batten_vec3 n = bat_vec3_scale(area, 1 / size);
    const batten_vec3 helper =
        fabs(n.x) < 0.6 ? (batten_vec3){1, 0, 0} : (batten_vec3){0, 1, 0};
    const batten_vec3 e = bat_vec3_cross(helper, n), f = bat_vec3_cross(n, e);
    rim->normal[0] = n.x;
    rim->normal[1] = n.y;
    rim->normal[2] = n.z;
    for (int i = 0; i < rim->count; i++) {
        rim->flat[i][0] = bat_vec3_dot(bat_vec3_of(3, rim->points[i]), e);
        rim->flat[i][1] = bat_vec3_dot(bat_vec3_of(3, rim->points[i]), f);
    }
    return true;
}

/* Positive where c is to the left of the line from a to b. */
static double side_of(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool crosses_itself(const rim_view *rim)
{
    const int n = rim->count;
    for (int i = 0; i < n; i++)
        for (int k = i + 2; k < n && (i > 0 || k < n - 1); k++) {
            const double *a = rim->flat[i], *b = rim->flat[i + 1];
            const double *c = rim->flat[k], *d = rim->flat[(k + 1) % n];
            if ((side_of(a, b, c) > 0) != (side_of(a, b, d) > 0) &&
                (side_of(c, d, a) > 0) != (side_of(c, d, b) > 0))
                return true;
        }
    return false;
}

/* Does no ribbon stand too steep for the fill to be seen from one side? */
static batten_status ribbons_lie_flat(const bat_fill_loop *loop, const rim_view *rim,
                                      bool *flat)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < loop->count; i++)
        for (int k = 0; status == BATTEN_OK && loop->sides[i].slope && k <= RIM_PLACES; k++) {
            bat_fill_view r;
            status = bat_fill_see_ribbon(&loop->sides[i], 2.0 * k / RIM_PLACES,
                                         k == 0 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &r);
            if (status == BATTEN_OK && r.regular &&
                !(bat_dot(3, r.normal, rim->normal) > least_cosine))
                *flat = false;
        }
    return status;
}

/* The first place where a normal turns away; those beside corners without a normal do not
 * count. */
static batten_status find_turned(const batten_surface *patch, const double normal[3],
                                 bool *found, double at[3])
{
    for (int i = 0; i <= PLACES; i++)
        for (int k = 0; k <= PLACES; k++) {
            bat_fill_view s;
            const batten_status status =
                bat_fill_see_surface(patch, (double)i / PLACES, (double)k / PLACES, &s);
            if (status != BATTEN_OK)
                return status;
            /* a thousandth: parallel lines have a normal of rounding */
            if (s.sine > 1e-3 && bat_dot(3, s.normal, normal) < 0) {
                *found = true;
                for (int c = 0; c < 3; c++)
                    at[c] = s.point[c];
                return BATTEN_OK;
            }
        }
    return BATTEN_OK;
}

batten_status bat_fill_find_overlap(const bat_fill_loop *loop, batten_surface *const *patches,
                                    bool *found, double at[3])
{
    rim_view *rim = bat_array(1, sizeof *rim);
    bool flat = rim != NULL;
    batten_status status = rim ? sample_rim(loop, rim) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        flat = flatten(rim) && !crosses_itself(rim);
    if (status == BATTEN_OK && flat)
        status = ribbons_lie_flat(loop, rim, &flat);
    *found = false;
    for (int i = 0; status == BATTEN_OK && flat && !*found && i < loop->count; i++)
        status = find_turned(patches[i], rim->normal, found, at);
    bat_release(rim);
    return status;
}
