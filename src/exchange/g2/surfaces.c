/* Surfaces of .g2 files: splines, and elementary ones with their ranges, as exact NURBS. */
#include "exchange/g2/g2.h"
#include "exchange/shapes/net.h"
#include "numeric/vector.h"

#include <batten/standard.h>

static batten_status transpose(bat_words *words, const batten_axis axes[2], size_t width,
                               double **values)
{
    double *turned = NULL;
    const batten_status status =
        bat_net_transpose(words->input, (size_t)axes[0].point_count,
                          (size_t)axes[1].point_count, width, *values, &turned);
    if (status != BATTEN_OK)
        return status;
    bat_release(*values);
    *values = turned;
    return BATTEN_OK;
}

/* The points of a net, and its weights. */
static batten_status read_net(bat_words *words, int dimension, bool rational,
                              const batten_axis axes[2], double **points, double **weights)
{
    const size_t count_u = (size_t)axes[0].point_count, count_v = (size_t)axes[1].point_count;
    const size_t width = (size_t)dimension + (rational ? 1 : 0);
    batten_status status = bat_words_check(words, "rows of points", count_u, count_v * width);
    if (status == BATTEN_OK)
        status = bat_words_reals(words, "coordinates", count_u * count_v * width, points);
    if (status == BATTEN_OK && rational)
        status = bat_g2_divide_weights(words, dimension, count_u * count_v, *points, weights);
    if (status == BATTEN_OK)
        status = transpose(words, axes, (size_t)dimension, points);
    if (status == BATTEN_OK && rational)
        status = transpose(words, axes, 1, weights);
    return status;
}

static batten_status read_spline(bat_words *words, batten_surface **out)
{
    int dimension = 0, rational = 0;
    double *knots[2] = {NULL, NULL}, *points = NULL, *weights = NULL;
    batten_axis axes[2] = {{0}, {0}};
    batten_status status = bat_words_integer(words, "the dimension", 3, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_words_integer(words, "the sign of a rational surface", 0, 1, &rational);
    for (int d = 0; status == BATTEN_OK && d < 2; d++)
        status = bat_g2_read_axis(words, &axes[d], &knots[d]);
    if (status == BATTEN_OK)
        status = read_net(words, dimension, rational, axes, &points, &weights);
    if (status == BATTEN_OK)
        status = batten_surface_create(dimension, &axes[0], &axes[1], points, weights, out);
    for (int d = 0; d < 2; d++)
        bat_release(knots[d]);
    bat_release(points);
    bat_release(weights);
    return status;
}

/* ---- elementary ones ---- */

/* What a plane, cylinder, cone, sphere or torus says of itself. */
typedef struct {
    int class;
    batten_frame frame;
    double radius, other, angle;
    batten_interval u, v; /* u the angle around, but of a plane */
    bool is_bounded, is_swapped;
} elementary;

static const batten_interval whole = {0, 2 * BAT_PI};

/* Radii before the frame; the half angle of a cone behind it. */
static batten_status read_place(bat_words *words, elementary *e)
{
    int dimension = 0, outer = 0;
    batten_status status = bat_words_integer(words, "the dimension", 3, 3, &dimension);
    if (status == BATTEN_OK && e->class != BAT_G2_PLANE)
        status = bat_words_real(words, "the radius", &e->radius);
    if (status == BATTEN_OK && e->class == BAT_G2_TORUS)
        status = bat_words_real(words, "the small radius", &e->other);
    if (status == BATTEN_OK && e->class == BAT_G2_TORUS && e->radius < 0)
        batten_notes_add(words->input->notes, words->input->file, words->line, "torus",
                         "its radius is %g; it is taken as the formula of the surface has it",
                         e->radius);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the centre", 3, &e->frame.origin);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the axis", 3, &e->frame.z);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the x-axis", 3, &e->frame.x);
    if (status == BATTEN_OK && e->class == BAT_G2_CONE)
        status = bat_words_real(words, "the angle of the cone", &e->angle);
    if (status == BATTEN_OK && e->class == BAT_G2_TORUS)
        status = bat_words_integer(words, "the side of the torus", 0, 1, &outer);
    return status == BATTEN_OK ? bat_g2_make_frame(words, &e->frame) : status;
}

static batten_status read_bounds(bat_words *words, bool alone, elementary *e)
{
    const bool has_mark = e->class != BAT_G2_SPHERE;
    bool backwards = false; /* the same surface */
    int bounded = e->class == BAT_G2_SPHERE || e->class == BAT_G2_TORUS, swapped = 0;
    batten_status status = BATTEN_OK;
    e->u = whole;
    e->v = e->class == BAT_G2_SPHERE ? (batten_interval){-BAT_PI / 2, BAT_PI / 2} : whole;
    e->is_bounded = bounded;
    if (alone && bat_g2_is_at_end(words))
        return BATTEN_OK;
    if (has_mark)
        status = bat_words_integer(words, "the mark of a bounded surface", 0, 1, &bounded);
    e->is_bounded |= bounded;
    if (status == BATTEN_OK && (bounded || e->class != BAT_G2_PLANE))
        status = bat_g2_read_range(words, false, whole, &e->u, &backwards);
    if (status == BATTEN_OK && bounded)
        status = bat_g2_read_range(words, false, whole, &e->v, &backwards);
    if (status == BATTEN_OK && !(alone && bat_g2_is_at_end(words)))
        status = bat_words_integer(words, "the mark of swapped parameters", 0, 1, &swapped);
    e->is_swapped = swapped;
    return status;
}

static batten_vec3 at(const elementary *e, double x, double y, double z)
{
    const batten_vec3 side = bat_vec3_cross(e->frame.z, e->frame.x);
    return bat_vec3_along(
        bat_vec3_along(bat_vec3_along(e->frame.origin, x, e->frame.x), y, side), z, e->frame.z);
}

/* The half plane at the angle u0, as a frame whose x goes away from the axis and y along it. */
static batten_frame meridian(const elementary *e)
{
    const batten_vec3 side = bat_vec3_cross(e->frame.z, e->frame.x);
    const batten_vec3 x =
        bat_vec3_along(bat_vec3_scale(e->frame.x, bat_cos(e->u.a)), bat_sin(e->u.a), side);
    return (batten_frame){
        .origin = e->frame.origin, .x = x, .z = bat_vec3_cross(x, e->frame.z)};
}

/* The curve that is turned about the axis: a line of cylinders and cones, else an arc. */
static batten_status make_profile(const elementary *e, batten_curve **out)
{
    batten_frame frame = meridian(e);
    if (e->class == BAT_G2_SPHERE || e->class == BAT_G2_TORUS) {
        const double small = e->class == BAT_G2_TORUS ? e->other : e->radius;
        if (e->class == BAT_G2_TORUS)
            frame.origin = bat_vec3_along(frame.origin, e->radius, frame.x);
        return batten_curve_arc_in(&frame, small, e->v.a, e->v.b - e->v.a, out);
    }
    const batten_interval r = {e->radius + e->v.a * bat_tan(e->angle),
                               e->radius + e->v.b * bat_tan(e->angle)};
    const batten_vec3 p =
        bat_vec3_along(bat_vec3_along(frame.origin, r.a, frame.x), e->v.a, e->frame.z);
    const batten_vec3 q =
        bat_vec3_along(bat_vec3_along(frame.origin, r.b, frame.x), e->v.b, e->frame.z);
    return batten_curve_line(3, (double[]){p.x, p.y, p.z}, (double[]){q.x, q.y, q.z}, out);
}

static batten_status make_elementary(const elementary *e, batten_surface **out)
{
    batten_curve *profile = NULL;
    if (e->class == BAT_G2_PLANE)
        return batten_surface_bilinear(at(e, e->u.a, e->v.a, 0), at(e, e->u.b, e->v.a, 0),
                                       at(e, e->u.a, e->v.b, 0), at(e, e->u.b, e->v.b, 0), out);
    batten_status status = make_profile(e, &profile);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(profile, e->frame.origin, e->frame.z,
                                         bat_min(e->u.b - e->u.a, 2 * BAT_PI), out);
    batten_curve_unref(profile);
    return status;
}

/* Planes, cylinders and cones alone may be without bounds. */
static bat_elementary without_bounds(const elementary *e)
{
    const bat_elementary_kind kind = e->class == BAT_G2_PLANE  ? BAT_PLANE
                                     : e->class == BAT_G2_CONE ? BAT_CONE
                                                               : BAT_CYLINDER;
    return (bat_elementary){.kind = kind, .frame = e->frame, .a = e->radius, .b = e->angle};
}

static batten_status read_elementary(bat_words *words, int class, bool alone,
                                     bat_g2_ground *out)
{
    elementary e = {.class = class};
    batten_surface *made = NULL;
    batten_status status = read_place(words, &e);
    if (status == BATTEN_OK)
        status = read_bounds(words, alone, &e);
    if (status == BATTEN_OK && alone && !e.is_bounded)
        status = bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                                "the surface has no bounds");
    if (status != BATTEN_OK)
        return status;
    out->is_plane = class == BAT_G2_PLANE;
    out->frame = e.frame;
    out->is_swapped = e.is_swapped;
    out->unbounded = without_bounds(&e);
    if (!e.is_bounded)
        return BATTEN_OK;
    status = make_elementary(&e, &made);
    if (status == BATTEN_OK && e.is_swapped)
        status = batten_surface_swap(made, &out->surface);
    else if (status == BATTEN_OK)
        out->surface = batten_surface_ref(made);
    batten_surface_unref(made);
    return status;
}

/* A spline curve turned all around. */
static batten_status read_revolution(bat_words *words, batten_surface **out)
{
    int dimension = 0;
    batten_vec3 origin = {0, 0, 0}, axis = {0, 0, 0};
    batten_curve *profile = NULL;
    batten_status status = bat_words_integer(words, "the dimension", 3, 3, &dimension);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "a point of the axis", 3, &origin);
    if (status == BATTEN_OK)
        status = bat_g2_read_vector(words, "the axis", 3, &axis);
    if (status == BATTEN_OK)
        status = bat_g2_read_curve(words, BAT_G2_CURVE, true, &profile);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(profile, origin, axis, 2 * BAT_PI, out);
    batten_curve_unref(profile);
    return status;
}

batten_status bat_g2_read_surface(bat_words *words, int class, bool alone, bat_g2_ground *out)
{
    *out = (bat_g2_ground){.is_spline = class == BAT_G2_SURFACE};
    switch (class) {
    case BAT_G2_SURFACE:
        return read_spline(words, &out->surface);
    case BAT_G2_PLANE:
    case BAT_G2_CYLINDER:
    case BAT_G2_SPHERE:
    case BAT_G2_CONE:
    case BAT_G2_TORUS:
        return read_elementary(words, class, alone, out);
    case BAT_G2_REVOLUTION:
        return read_revolution(words, &out->surface);
    default:
        return bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                              "surfaces of class %d are not read", class);
    }
}
