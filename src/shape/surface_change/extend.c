/* Surfaces made longer at an edge: turned so that it is the end of v, extended, turned back. */
#include "shape/surface_change/extend.h"
#include "numeric/rounding.h"

#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include "spline/surface/surface.h"

#include <float.h>

enum { LINES = 33, PIECES = 8, POINTS = 4, TRIALS = 80 };

typedef struct {
    batten_surface *surface; /* clamped in v, the edge at the end of v */
    batten_extension extension;
    double length, tolerance;
    double end;      /* of v */
    double u[LINES]; /* of the lines that are measured */
    batten_surface_extend_report *report;
} task;

/* ---- turning ---- */

static batten_status swap_directions(batten_surface **surface)
{
    batten_surface *changed = NULL;
    const batten_status status = batten_surface_swap(*surface, &changed);
    return bat_surface_replace(status, surface, &changed);
}

static batten_status reverse(batten_surface **surface)
{
    batten_surface *changed = NULL;
    const batten_status status = batten_surface_reverse(*surface, BATTEN_V, &changed);
    return bat_surface_replace(status, surface, &changed);
}

static bool across_u(batten_edge edge)
{
    return edge == BATTEN_EDGE_U0 || edge == BATTEN_EDGE_U1;
}

static bool at_low(batten_edge edge)
{
    return edge == BATTEN_EDGE_U0 || edge == BATTEN_EDGE_V0;
}

static batten_status turn_edge_to_end(batten_surface **surface, batten_edge edge)
{
    batten_surface *changed = NULL;
    batten_status status = across_u(edge) ? swap_directions(surface) : BATTEN_OK;
    if (status == BATTEN_OK && at_low(edge))
        status = reverse(surface);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(*surface, BATTEN_V, &changed);
    return bat_surface_replace(status, surface, &changed);
}

static batten_status turn_back(batten_surface **surface, batten_edge edge)
{
    batten_status status = at_low(edge) ? reverse(surface) : BATTEN_OK;
    return status == BATTEN_OK && across_u(edge) ? swap_directions(surface) : status;
}

/* ---- measuring ---- */

/* The length of the line at u from the old edge to the end, by Gauss's rule of four points. */
static batten_status line_length(const batten_surface *surface, double u, double from,
                                 double *out)
{
    static const double x[POINTS] = {-0.8611363115940526, -0.3399810435848563,
                                     0.3399810435848563, 0.8611363115940526};
    static const double w[POINTS] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                     0.3478548451374538};
    const double end = batten_surface_domain(surface, BATTEN_V).b;
    const double half = (end - from) / PIECES / 2;
    batten_status status = BATTEN_OK;
    *out = 0;
    for (int i = 0; i < PIECES * POINTS && status == BATTEN_OK; i++) {
        double values[9];
        const double v = from + half * (2 * (i / POINTS) + 1 + x[i % POINTS]);
        status = batten_surface_evaluate(surface, u, bat_min(v, end), 1, values);
        if (status == BATTEN_OK)
            *out += half * w[i % POINTS] * bat_norm(3, values + 6);
    }
    return status;
}

static batten_status lengths(const task *t, const batten_surface *surface, double *least,
                             double *most)
{
    batten_status status = BATTEN_OK;
    *least = HUGE_VAL;
    *most = 0;
    for (int i = 0; i < LINES && status == BATTEN_OK; i++) {
        double length = 0;
        status = line_length(surface, t->u[i], t->end, &length);
        *least = bat_min(*least, length);
        *most = bat_max(*most, length);
    }
    return status;
}

/* The slowest speed across the edge, which must not stand still, and be more than a point. */
static batten_status check_edge(const task *t, double *slowest, double *bend)
{
    const double size = bat_surface_nurbs(t->surface)->largest;
    double first[3] = {0}, far = 0;
    *slowest = HUGE_VAL;
    *bend = 0;
    for (int i = 0; i < LINES; i++) {
        double values[18];
        const batten_status status = batten_surface_evaluate_side(
            t->surface, t->u[i], t->end, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT}, 2,
            values);
        if (status != BATTEN_OK)
            return status;
        for (int c = 0; c < 3 && i == 0; c++)
            first[c] = values[c];
        far = bat_max(far, bat_distance(3, values, first));
        const double speed = bat_norm(3, values + 6);
        const double width = t->end - batten_surface_domain(t->surface, BATTEN_V).a;
        if (!(speed * width > BAT_ROUNDING * size))
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "the surface stands still across the edge at %.9g along it: it has "
                            "no direction to extend",
                            t->u[i]);
        const batten_vec3 slope = bat_vec3_scale(bat_vec3_of(3, values + 6), 1 / speed);
        const batten_vec3 second = bat_vec3_scale(bat_vec3_of(3, values + 15), 1 / speed);
        /* Curvature times speed: what an arc turns in a unit of the parameter. */
        *bend = bat_max(*bend, bat_vec3_norm(bat_vec3_cross(slope, second)));
        *slowest = bat_min(*slowest, speed);
    }
    if (!(far > BAT_ROUNDING * size))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the edge is a point: the surface cannot be extended there");
    return BATTEN_OK;
}

/* ---- going on ---- */

static batten_status go_by(const task *t, double way, batten_surface **out)
{
    return t->extension == BATTEN_EXTEND_LINE ? bat_surface_straight_on(t->surface, way, out)
                                              : bat_surface_go_on(t->surface, way, out);
}

/* The way of the parameter that makes the shortest line as long as asked; from a first guess by
 * false position, lengths being nearly in proportion. */
static batten_status find_way(const task *t, double guess, batten_surface **out)
{
    double low = 0, high = HUGE_VAL, way = guess, least = 0, most = 0;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < TRIALS && t->end + way > t->end; i++) {
        batten_surface *made = NULL;
        status = go_by(t, way, &made);
        if (status == BATTEN_OK)
            status = lengths(t, made, &least, &most);
        if (status == BATTEN_OK && fabs(least - t->length) <= BAT_ROUNDING * t->length) {
            *out = made;
            return BATTEN_OK;
        }
        batten_surface_unref(made);
        if (status != BATTEN_OK && status != BATTEN_BAD_WEIGHT && status != BATTEN_OVERFLOW)
            return status;
        const bool short_of = status == BATTEN_OK && least < t->length;
        low = short_of ? way : low;
        high = short_of ? high : way;
        if (high - low <= 4 * DBL_EPSILON * (fabs(t->end) + low) && low > 0)
            return go_by(t, high - low <= way ? way : low, out);
        const double next = status == BATTEN_OK ? way * (t->length / least) : low;
        way = next > low && next < high ? next
              : isfinite(high)          ? low + (high - low) / 2
                                        : 2 * way;
    }
    return bat_fail(
        status == BATTEN_OK ? BATTEN_TOLERANCE_NOT_MET : status,
        "the surface cannot be extended by %g: %g of its parameter was tried, which gives %g",
        t->length, way, least);
}

static batten_status extend_end(const task *t, batten_surface **out)
{
    double slowest = 0, bend = 0;
    const batten_status status = check_edge(t, &slowest, &bend);
    if (status != BATTEN_OK)
        return status;
    const double way = t->length / slowest;
    if (t->extension != BATTEN_EXTEND_ARC)
        return find_way(t, way, out);
    if (bend * way > 2 * BAT_PI)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "an arc of the length %g goes around more than once: %g radians",
                        t->length, bend * way);
    return bat_surface_arc_on(t->surface, way, t->tolerance, &t->report->error, out);
}

/* ---- the report ---- */

/* Normal, and normal curvature along the line across, on one side of the old edge. */
static batten_status one_side(const task *t, const batten_surface *made, double u,
                              batten_side side, batten_vec3 *normal, double *curvature)
{
    double values[18];
    const batten_status status = batten_surface_evaluate_side(
        made, u, t->end, (batten_sides){BATTEN_FROM_RIGHT, side}, 2, values);
    if (status != BATTEN_OK)
        return status;
    const double lu = bat_norm(3, values + 3), lv = bat_norm(3, values + 6);
    const batten_vec3 a = bat_vec3_scale(bat_vec3_of(3, values + 3), lu > 0 ? 1 / lu : 0);
    const batten_vec3 b = bat_vec3_scale(bat_vec3_of(3, values + 6), 1 / lv);
    const batten_vec3 cross = bat_vec3_cross(a, b);
    const double sine = bat_vec3_norm(cross);
    *normal = bat_vec3_scale(cross, sine > 0 ? 1 / sine : 0);
    *curvature =
        bat_vec3_dot(bat_vec3_scale(bat_vec3_of(3, values + 15), 1 / lv), *normal) / lv;
    return BATTEN_OK;
}

static batten_status measure_extension(const task *t, const batten_surface *made)
{
    batten_surface_extend_report *r = t->report;
    r->to = batten_surface_domain(made, BATTEN_V).b;
    const bat_axis *axis = &bat_surface_nurbs(made)->axes[BATTEN_V];
    r->multiplicity = bat_knots_multiplicity(axis->degree, axis->count, axis->knots, t->end);
    batten_status status = lengths(t, made, &r->least, &r->most);
    for (int i = 0; i < LINES && status == BATTEN_OK; i++) {
        batten_vec3 n[2];
        double kappa[2], near[9], far[9];
        for (int k = 0; k < 2 && status == BATTEN_OK; k++)
            status = one_side(t, made, t->u[i], k ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &n[k],
                              &kappa[k]);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(made, t->u[i], t->end, 1, near);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(made, t->u[i], r->to, 1, far);
        if (status != BATTEN_OK)
            return status;
        const double jump = bat_vec3_norm(bat_vec3_subtract(n[0], n[1]));
        r->angle = bat_max(r->angle, 2 * bat_asin(bat_min(1, jump / 2)));
        r->curvature = bat_max(r->curvature, fabs(kappa[0] - kappa[1]));
        const double ln = bat_norm(3, near + 6), lf = bat_norm(3, far + 6);
        const batten_vec3 a = bat_vec3_scale(bat_vec3_of(3, near + 6), 1 / ln);
        const batten_vec3 b = bat_vec3_scale(bat_vec3_of(3, far + 6), lf > 0 ? 1 / lf : 0);
        r->turn = bat_max(r->turn,
                          bat_atan2(bat_vec3_norm(bat_vec3_cross(a, b)), bat_vec3_dot(a, b)));
    }
    return status;
}

/* ---- the call ---- */

static batten_status check_request(const batten_surface *surface, batten_edge edge,
                                   batten_extension extension, double length, double tolerance)
{
    if (!isfinite(length) || !isfinite(tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "an extension by %g within %g", length, tolerance);
    if ((int)edge < 0 || edge > BATTEN_EDGE_U0 || (int)extension < 0 ||
        extension > BATTEN_EXTEND_NATURAL)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no edge %d or extension %d", (int)edge,
                        (int)extension);
    if (length <= 0 || (extension == BATTEN_EXTEND_ARC && tolerance <= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "an extension by %g within %g: both must be above 0", length,
                        tolerance);
    if (extension == BATTEN_EXTEND_SPIRAL)
        return bat_fail(BATTEN_UNSUPPORTED, "surfaces cannot be extended along spirals");
    if (surface->kind != &bat_nurbs_kind || surface->dimension != 3)
        return bat_fail(BATTEN_UNSUPPORTED, "only NURBS surfaces in space can be extended");
    if (batten_surface_is_periodic(surface, across_u(edge) ? BATTEN_U : BATTEN_V))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a periodic surface has no edge there");
    return BATTEN_OK;
}

static batten_status extend_surface(task *t, batten_edge edge, batten_surface **out)
{
    batten_surface *made = NULL;
    batten_status status = turn_edge_to_end(&t->surface, edge);
    if (status != BATTEN_OK)
        return status;
    const batten_interval along = batten_surface_domain(t->surface, BATTEN_U);
    t->end = batten_surface_domain(t->surface, BATTEN_V).b;
    for (int i = 0; i < LINES; i++)
        t->u[i] = i + 1 < LINES ? along.a + (along.b - along.a) * i / (LINES - 1) : along.b;
    status = extend_end(t, &made);
    if (status == BATTEN_OK)
        status = measure_extension(t, made);
    if (status == BATTEN_OK)
        status = turn_back(&made, edge);
    if (at_low(edge))
        t->report->to = -t->report->to;
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_unref(made);
    return status;
}

batten_status batten_surface_extend(const batten_surface *surface, batten_edge edge,
                                    batten_lengthening how, double length,
                                    batten_surface_extend_report *report, batten_surface **out)
{
    assert(surface && out);
    batten_surface_extend_report found = {.to = 0};
    batten_status status = check_request(surface, edge, how.kind, length, how.tolerance);
    if (status != BATTEN_OK)
        return status;
    task t = {.surface = batten_surface_ref(surface),
              .extension = how.kind,
              .length = length,
              .tolerance = how.tolerance,
              .report = &found};
    status = extend_surface(&t, edge, out);
    batten_surface_unref(t.surface);
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}
