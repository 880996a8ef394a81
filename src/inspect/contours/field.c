#include "inspect/contours/field.h"

#include "numeric/vector.h"

#include <float.h>

/* A number with its first derivatives in u and v: no field needs more. */
typedef struct {
    double f, u, v;
} dual;

typedef struct {
    dual x, y, z;
} dual3;

/* A surface at a point, scaled so that its larger tangent has a coordinate near 1. */
typedef struct {
    double scale; /* of lengths: scaled = scale * true */
    dual3 s, su, sv, suu, suv, svv;
} local;

/* ---- numbers with derivatives ---- */

static dual constant(double f)
{
    return (dual){f, 0, 0};
}

static dual add(dual a, dual b)
{
    return (dual){a.f + b.f, a.u + b.u, a.v + b.v};
}

static dual subtract(dual a, dual b)
{
    return (dual){a.f - b.f, a.u - b.u, a.v - b.v};
}

static dual scale(double factor, dual a)
{
    return (dual){factor * a.f, factor * a.u, factor * a.v};
}

static dual multiply(dual a, dual b)
{
    return (dual){a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v};
}

/* g(a), with the value and the derivative of g there. */
static dual compose(double g, double slope, dual a)
{
    return (dual){g, slope * a.u, slope * a.v};
}

static dual divide(dual a, dual b)
{
    return multiply(a, compose(1 / b.f, -1 / (b.f * b.f), b));
}

static dual square_root(dual a)
{
    const double root = sqrt(a.f);
    return compose(root, 0.5 / root, a);
}

/* ---- vectors of them ---- */

static dual dot(dual3 a, dual3 b)
{
    return add(add(multiply(a.x, b.x), multiply(a.y, b.y)), multiply(a.z, b.z));
}

static dual minor(dual a, dual b, dual c, dual d)
{
    return subtract(multiply(a, d), multiply(b, c));
}

static dual3 cross(dual3 a, dual3 b)
{
    return (dual3){minor(a.y, a.z, b.y, b.z), minor(a.z, a.x, b.z, b.x),
                   minor(a.x, a.y, b.x, b.y)};
}

static dual3 times(dual factor, dual3 a)
{
    return (dual3){multiply(factor, a.x), multiply(factor, a.y), multiply(factor, a.z)};
}

static dual3 between(dual3 a, dual3 b)
{
    return (dual3){subtract(a.x, b.x), subtract(a.y, b.y), subtract(a.z, b.z)};
}

static dual3 fixed(batten_vec3 a)
{
    return (dual3){constant(a.x), constant(a.y), constant(a.z)};
}

static dual reciprocal_length(dual3 a)
{
    return divide(constant(1), square_root(dot(a, a)));
}

/* ---- the point ---- */

/* One coordinate of a derivative of the surface with the next derivatives, as far as known. */
static dual coordinate(const double *derivatives, int order, double factor, int k, int l, int i)
{
    const bool known = k + l < order;
    const double *d = derivatives + i;
    return scale(factor, (dual){d[3 * BATTEN_SURFACE_DERIVATIVE(k, l)],
                                known ? d[3 * BATTEN_SURFACE_DERIVATIVE(k + 1, l)] : 0,
                                known ? d[3 * BATTEN_SURFACE_DERIVATIVE(k, l + 1)] : 0});
}

static dual3 derivative(const double *derivatives, int order, double factor, int k, int l)
{
    return (dual3){coordinate(derivatives, order, factor, k, l, 0),
                   coordinate(derivatives, order, factor, k, l, 1),
                   coordinate(derivatives, order, factor, k, l, 2)};
}

/* False where the tangents do not span a plane: the cross product of parallel vectors rounds to
 * a few eps of the product of their lengths, and a derivative that vanishes to some thousand
 * eps of the coordinates. */
static bool make_local(const double *derivatives, int order, local *out)
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
    local at = {.scale = ldexp(1, -exponent)};
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

static dual3 normal_of(const local *at)
{
    const dual3 n = cross(at->su, at->sv);
    return times(reciprocal_length(n), n);
}

/* ---- curvature ---- */

/* K and H of the textbook; with their first derivatives. */
static void curvatures(const local *at, dual *gaussian, dual *mean)
{
    const dual3 n = normal_of(at);
    const dual E = dot(at->su, at->su), F = dot(at->su, at->sv), G = dot(at->sv, at->sv);
    const dual L = dot(at->suu, n), M = dot(at->suv, n);
    const dual P = dot(at->svv, n);
    const dual area2 = minor(E, F, F, G);
    *gaussian = divide(minor(L, M, M, P), area2);
    const dual crossed =
        subtract(add(multiply(E, P), multiply(G, L)), scale(2, multiply(F, M)));
    *mean = scale(0.5, divide(crossed, area2));
}

static dual principal(dual gaussian, dual mean, double sign)
{
    const dual square = multiply(mean, mean);
    const dual difference = subtract(square, gaussian);
    /* At an umbilic the root has no derivative; that of the mean curvature serves. */
    if (!(difference.f > 8 * DBL_EPSILON * square.f))
        return mean;
    return add(mean, scale(sign, square_root(difference)));
}

static dual curvature_field(const batten_surface_field *field, const local *at)
{
    dual gaussian, mean;
    curvatures(at, &gaussian, &mean);
    switch (field->kind) {
    case BATTEN_FIELD_GAUSSIAN:
        return scale(at->scale * at->scale, gaussian);
    case BATTEN_FIELD_KAPPA1:
        return scale(at->scale, principal(gaussian, mean, 1));
    case BATTEN_FIELD_KAPPA2:
        return scale(at->scale, principal(gaussian, mean, -1));
    default:
        return scale(at->scale, mean);
    }
}

/* ---- light ---- */

static dual arc_sine(dual a)
{
    const double x = bat_max(-1, bat_min(1, a.f));
    /* At the poles of the Gauss map the derivative is infinite, that of x 0. */
    const double root2 = bat_max(1 - x * x, DBL_EPSILON);
    return compose(asin(x), 1 / sqrt(root2), a);
}

/* The signed distance of the line through S along `ray` from the light line. */
static dual line_distance(const batten_surface_field *field, const local *at, dual3 ray)
{
    const dual3 b = fixed(field->direction), square = cross(b, ray);
    const dual3 from = between(at->s, fixed(bat_vec3_scale(field->point, at->scale)));
    /* A tube of light is of finite length: of lines nearly parallel to it none is mirrored. */
    if (!(dot(square, square).f > 0.01 * dot(ray, ray).f))
        return constant((double)NAN);
    const dual distance = multiply(dot(square, from), reciprocal_length(square));
    return scale(1 / at->scale, distance);
}

static dual light_field(const batten_surface_field *field, const local *at)
{
    const dual3 n = normal_of(at);
    if (field->kind == BATTEN_FIELD_HIGHLIGHT)
        return line_distance(field, at, n);
    if (field->kind == BATTEN_FIELD_REFLECTION) {
        const dual3 e = fixed(field->eye);
        const dual facing = scale(2, dot(e, n));
        return line_distance(field, at, between(times(facing, n), e));
    }
    if (field->kind == BATTEN_FIELD_SILHOUETTE) {
        const dual3 to = between(fixed(bat_vec3_scale(field->point, at->scale)), at->s);
        if (!(dot(to, to).f > 0))
            return constant((double)NAN);
        return multiply(dot(n, to), reciprocal_length(to));
    }
    const dual cosine = dot(n, fixed(field->direction));
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
           kind == BATTEN_FIELD_KAPPA1 || kind == BATTEN_FIELD_KAPPA2;
}

int bat_field_order(const batten_surface_field *field)
{
    return field->kind == BATTEN_FIELD_HEIGHT ? 1 : is_curvature(field->kind) ? 3 : 2;
}

double bat_field_roundoff(const batten_surface_field *field, double size)
{
    switch (field->kind) {
    case BATTEN_FIELD_HEIGHT:
        return 1e-14 * size;
    case BATTEN_FIELD_HIGHLIGHT:
    case BATTEN_FIELD_REFLECTION:
        return 1e-12 * size;
    case BATTEN_FIELD_GAUSSIAN:
        return 1e-12 / size / size;
    case BATTEN_FIELD_MEAN:
    case BATTEN_FIELD_KAPPA1:
    case BATTEN_FIELD_KAPPA2:
        return 1e-12 / size;
    case BATTEN_FIELD_ISOPHOTE:
    case BATTEN_FIELD_DRAFT:
    case BATTEN_FIELD_SILHOUETTE:
        break;
    }
    return 1e-12;
}

double bat_field_value(const batten_surface_field *field, const double *derivatives,
                       double gradient[2])
{
    local at;
    if (field->kind == BATTEN_FIELD_HEIGHT)
        return height(field, derivatives, gradient);
    gradient[0] = gradient[1] = (double)NAN;
    if (!make_local(derivatives, bat_field_order(field), &at))
        return (double)NAN;
    const dual value =
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
    if (status == BATTEN_OK && field->kind == BATTEN_FIELD_REFLECTION)
        status = make_unit("direction to the eye", field->eye, &made.eye);
    const batten_vec3 p = field->point;
    if (status == BATTEN_OK && !isfinite(p.x + p.y + p.z))
        status = bat_fail(BATTEN_NOT_FINITE,
                          "the point (%g, %g, %g) of the field is not finite", p.x, p.y, p.z);
    if (status == BATTEN_OK)
        *out = made;
    return status;
}
