/* Scalar fields on surfaces, with their gradients, as jets of order 1. */
#include "inspect/contours/field.h"
#include "numeric/jet1.h"

#include <float.h>

/* A surface at a point, scaled so that its larger tangent has a coordinate near 1. */
typedef struct {
    double scale; /* of lengths: scaled = scale * true */
    bat_jet1_vector s, su, sv, suu, suv, svv;
} surface_place;

/* ---- the point ---- */

/* One coordinate of a derivative of the surface with the next derivatives, as far as known. */
static bat_jet1 coordinate(const double *derivatives, int order, double factor, int k, int l,
                           int i)
{
    const bool known = k + l < order;
    const double *d = derivatives + i;
    return bat_jet1_scale(factor,
                          (bat_jet1){d[3 * BATTEN_SURFACE_DERIVATIVE(k, l)],
                                     known ? d[3 * BATTEN_SURFACE_DERIVATIVE(k + 1, l)] : 0,
                                     known ? d[3 * BATTEN_SURFACE_DERIVATIVE(k, l + 1)] : 0});
}

static bat_jet1_vector derivative(const double *derivatives, int order, double factor, int k,
                                  int l)
{
    return (bat_jet1_vector){coordinate(derivatives, order, factor, k, l, 0),
                             coordinate(derivatives, order, factor, k, l, 1),
                             coordinate(derivatives, order, factor, k, l, 2)};
}

/* False where the tangents do not span a plane: the cross product of parallel vectors rounds to
 * a few eps of the product of their lengths, and a derivative that vanishes to some thousand
 * eps of the coordinates. */
static bool make_place(const double *derivatives, int order, surface_place *out)
{
    const batten_vec3 su = bat_vec3_of(3, derivatives + 3),
                      sv = bat_vec3_of(3, derivatives + 6);
    const double u = bat_vec3_norm(su), v = bat_vec3_norm(sv);
    const double size = bat_vec3_norm(bat_vec3_of(3, derivatives));
    const double vanishes = 4096 * DBL_EPSILON * bat_max(size, bat_max(u, v));
    if (!(u > vanishes && v > vanishes && isfinite(u) && isfinite(v)))
        return false;
    const batten_vec3 n = bat_vec3_cross(bat_vec3_scale(su, 1 / u), bat_vec3_scale(sv, 1 / v));
    if (!(bat_vec3_norm(n) > 64 * DBL_EPSILON))
        return false;
    int exponent;
    frexp(bat_max(u, v), &exponent);
    surface_place at = {.scale = ldexp(1, -exponent)};
    at.s = derivative(derivatives, order, at.scale, 0, 0);
    at.su = derivative(derivatives, order, at.scale, 1, 0);
    at.sv = derivative(derivatives, order, at.scale, 0, 1);
    if (order >= 3) {
        at.suu = derivative(derivatives, order, at.scale, 2, 0);
        at.suv = derivative(derivatives, order, at.scale, 1, 1);
        at.svv = derivative(derivatives, order, at.scale, 0, 2);
    }
    *out = at;
    return true;
}

static bat_jet1_vector normal_of(const surface_place *at)
{
    const bat_jet1_vector n = bat_jet1_cross(at->su, at->sv);
    return bat_jet1_times(bat_jet1_reciprocal_length(n), n);
}

/* ---- curvature ---- */

/* K and H of the textbook; with their first derivatives. */
static void curvatures(const surface_place *at, bat_jet1 *gaussian, bat_jet1 *mean)
{
    const bat_jet1_vector n = normal_of(at);
    const bat_jet1 E = bat_jet1_dot(at->su, at->su), F = bat_jet1_dot(at->su, at->sv),
                   G = bat_jet1_dot(at->sv, at->sv);
    const bat_jet1 L = bat_jet1_dot(at->suu, n), M = bat_jet1_dot(at->suv, n);
    const bat_jet1 P = bat_jet1_dot(at->svv, n);
    const bat_jet1 area2 = bat_jet1_minor(E, F, F, G);
    *gaussian = bat_jet1_divide(bat_jet1_minor(L, M, M, P), area2);
    const bat_jet1 crossed =
        bat_jet1_subtract(bat_jet1_add(bat_jet1_multiply(E, P), bat_jet1_multiply(G, L)),
                          bat_jet1_scale(2, bat_jet1_multiply(F, M)));
    *mean = bat_jet1_scale(0.5, bat_jet1_divide(crossed, area2));
}

static bat_jet1 principal(bat_jet1 gaussian, bat_jet1 mean, double sign)
{
    const bat_jet1 square = bat_jet1_multiply(mean, mean);
    const bat_jet1 difference = bat_jet1_subtract(square, gaussian);
    /* At an umbilic the root has no derivative; that of the mean curvature serves. */
    if (!(difference.f > 8 * DBL_EPSILON * square.f))
        return mean;
    return bat_jet1_add(mean, bat_jet1_scale(sign, bat_jet1_square_root(difference)));
}

/* |kappa1| + |kappa2|: where both have one sign their sum, else their difference. */
static bat_jet1 absolute(bat_jet1 gaussian, bat_jet1 mean)
{
    if (gaussian.f >= 0)
        return bat_jet1_scale(mean.f < 0 ? -2 : 2, mean);
    return bat_jet1_subtract(principal(gaussian, mean, 1), principal(gaussian, mean, -1));
}

static bat_jet1 curvature_field(const batten_surface_field *field, const surface_place *at)
{
    bat_jet1 gaussian, mean;
    curvatures(at, &gaussian, &mean);
    switch (field->kind) {
    case BATTEN_FIELD_GAUSSIAN:
        return bat_jet1_scale(at->scale * at->scale, gaussian);
    case BATTEN_FIELD_ABSOLUTE:
        return bat_jet1_scale(at->scale, absolute(gaussian, mean));
    case BATTEN_FIELD_KAPPA1:
        return bat_jet1_scale(at->scale, principal(gaussian, mean, 1));
    case BATTEN_FIELD_KAPPA2:
        return bat_jet1_scale(at->scale, principal(gaussian, mean, -1));
    default:
        return bat_jet1_scale(at->scale, mean);
    }
}

/* ---- light ---- */

static bat_jet1 arc_sine(bat_jet1 a)
{
    const double x = bat_max(-1, bat_min(1, a.f));
    /* At the poles of the Gauss map the derivative is infinite, that of x 0. */
    const double root2 = bat_max(1 - x * x, DBL_EPSILON);
    return bat_jet1_compose(bat_asin(x), 1 / sqrt(root2), a);
}

/* The signed distance of the line through S along `ray` from the light line. */
static bat_jet1 line_distance(const batten_surface_field *field, const surface_place *at,
                              bat_jet1_vector ray)
{
    const bat_jet1_vector b = bat_jet1_fixed(field->direction), square = bat_jet1_cross(b, ray);
    const bat_jet1_vector from =
        bat_jet1_between(at->s, bat_jet1_fixed(bat_vec3_scale(field->point, at->scale)));
    /* A tube of light is of finite length: of lines nearly parallel to it none is mirrored. */
    if (!(bat_jet1_dot(square, square).f > 0.01 * bat_jet1_dot(ray, ray).f))
        return bat_jet1_constant((double)NAN);
    const bat_jet1 distance =
        bat_jet1_multiply(bat_jet1_dot(square, from), bat_jet1_reciprocal_length(square));
    return bat_jet1_scale(1 / at->scale, distance);
}

/* Fields of the ray from the eye that the surface reflects. */
static bool is_mirrored(batten_field_kind kind)
{
    return kind == BATTEN_FIELD_REFLECTION || kind == BATTEN_FIELD_ZEBRA;
}

static bat_jet1 light_field(const batten_surface_field *field, const surface_place *at)
{
    const bat_jet1_vector n = normal_of(at);
    if (field->kind == BATTEN_FIELD_HIGHLIGHT)
        return line_distance(field, at, n);
    if (is_mirrored(field->kind)) {
        const bat_jet1_vector e = bat_jet1_fixed(field->eye);
        const bat_jet1 facing = bat_jet1_scale(2, bat_jet1_dot(e, n));
        const bat_jet1_vector ray = bat_jet1_between(bat_jet1_times(facing, n), e);
        return field->kind == BATTEN_FIELD_ZEBRA
                   ? bat_jet1_dot(ray, bat_jet1_fixed(field->direction))
                   : line_distance(field, at, ray);
    }
    if (field->kind == BATTEN_FIELD_SILHOUETTE) {
        const bat_jet1_vector to =
            bat_jet1_between(bat_jet1_fixed(bat_vec3_scale(field->point, at->scale)), at->s);
        if (!(bat_jet1_dot(to, to).f > 0))
            return bat_jet1_constant((double)NAN);
        return bat_jet1_multiply(bat_jet1_dot(n, to), bat_jet1_reciprocal_length(to));
    }
    const bat_jet1 cosine = bat_jet1_dot(n, bat_jet1_fixed(field->direction));
    return field->kind == BATTEN_FIELD_DRAFT ? arc_sine(cosine) : cosine;
}

/* ---- any field ---- */

static double height(const batten_surface_field *field, const double *derivatives,
                     double gradient[2])
{
    const batten_vec3 d = field->direction;
    gradient[0] = bat_vec3_dot(d, bat_vec3_of(3, derivatives + 3));
    gradient[1] = bat_vec3_dot(d, bat_vec3_of(3, derivatives + 6));
    return bat_vec3_dot(d, bat_vec3_of(3, derivatives));
}

static bool is_curvature(batten_field_kind kind)
{
    return kind == BATTEN_FIELD_GAUSSIAN || kind == BATTEN_FIELD_MEAN ||
           kind == BATTEN_FIELD_KAPPA1 || kind == BATTEN_FIELD_KAPPA2 ||
           kind == BATTEN_FIELD_ABSOLUTE;
}

int bat_field_order(const batten_surface_field *field)
{
    return field->kind == BATTEN_FIELD_HEIGHT ? 1 : is_curvature(field->kind) ? 3 : 2;
}

/* Heights round like coordinates; what is made from normals or curvatures loses two
 * more digits. */
static const double HEIGHT_ROUNDOFF = 1e-14, ROUNDOFF = 1e-12;

double bat_field_roundoff(const batten_surface_field *field, double size)
{
    switch (field->kind) {
    case BATTEN_FIELD_HEIGHT:
        return HEIGHT_ROUNDOFF * size;
    case BATTEN_FIELD_HIGHLIGHT:
    case BATTEN_FIELD_REFLECTION:
        return ROUNDOFF * size;
    case BATTEN_FIELD_GAUSSIAN:
        return ROUNDOFF / size / size;
    case BATTEN_FIELD_MEAN:
    case BATTEN_FIELD_KAPPA1:
    case BATTEN_FIELD_KAPPA2:
    case BATTEN_FIELD_ABSOLUTE:
        return ROUNDOFF / size;
    case BATTEN_FIELD_ISOPHOTE:
    case BATTEN_FIELD_DRAFT:
    case BATTEN_FIELD_SILHOUETTE:
    case BATTEN_FIELD_ZEBRA:
        break;
    }
    return ROUNDOFF;
}

double bat_field_value(const batten_surface_field *field, const double *derivatives,
                       double gradient[2])
{
    surface_place at;
    if (field->kind == BATTEN_FIELD_HEIGHT)
        return height(field, derivatives, gradient);
    gradient[0] = gradient[1] = (double)NAN;
    if (!make_place(derivatives, bat_field_order(field), &at))
        return (double)NAN;
    const bat_jet1 value =
        is_curvature(field->kind) ? curvature_field(field, &at) : light_field(field, &at);
    gradient[0] = value.u;
    gradient[1] = value.v;
    return value.f;
}

/* ---- checks ---- */

static batten_status make_unit(const char *name, batten_vec3 given, batten_vec3 *out)
{
    const double length = bat_vec3_norm(given);
    if (!isfinite(length))
        return bat_fail(BATTEN_NOT_FINITE, "the %s (%g, %g, %g) of the field is not finite",
                        name, given.x, given.y, given.z);
    if (!(length > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s of the field is 0: it points nowhere",
                        name);
    /* By division: the reciprocal of a tiny length would overflow. */
    *out = (batten_vec3){given.x / length, given.y / length, given.z / length};
    return BATTEN_OK;
}

batten_status bat_field_prepare(const batten_surface_field *field, batten_surface_field *out)
{
    batten_surface_field made = *field;
    batten_status status = BATTEN_OK;
    if (!is_curvature(field->kind) && field->kind != BATTEN_FIELD_SILHOUETTE)
        status = make_unit("direction", field->direction, &made.direction);
    if (status == BATTEN_OK && is_mirrored(field->kind))
        status = make_unit("direction to the eye", field->eye, &made.eye);
    const batten_vec3 p = field->point;
    if (status == BATTEN_OK && !isfinite(p.x + p.y + p.z))
        status = bat_fail(BATTEN_NOT_FINITE,
                          "the point (%g, %g, %g) of the field is not finite", p.x, p.y, p.z);
    if (status == BATTEN_OK)
        *out = made;
    return status;
}
