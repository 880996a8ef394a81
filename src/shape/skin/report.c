/* What is true of a skin: that it passes its sections, and what its report says. */
#include "base/sort.h"
#include "numeric/rounding.h"
#include "shape/skin/steps.h"

#include <float.h>
#include <stdlib.h>

/* How far the curve runs at u while its parameter is rounded: its knots are moved into [0, 1]
 * by up to 4 eps (max(|a|, |b|) + (b - a)), those of its partners too, and u is computed there
 * and back. */
static batten_status parameter_rounding(const batten_curve *section, double u, double *moved)
{
    const batten_interval domain = batten_curve_domain(section);
    const double end = bat_max(fabs(domain.a), fabs(domain.b));
    const double step = 12 * DBL_EPSILON * (end + (domain.b - domain.a));
    double low[3], high[3];
    batten_status status = batten_curve_evaluate(section, bat_max(domain.a, u - step), 0, low);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(section, bat_min(domain.b, u + step), 0, high);
    if (status == BATTEN_OK)
        *moved = bat_distance(batten_curve_dimension(section), low, high);
    return status;
}

/* How far the section with common knots is from the section at the same parameter s in [0, 1],
 * beyond the rounding of the parameter; that is looked into where it matters. */
static batten_status miss_at(const bat_skin *t, int k, double s, double allowed, double *miss)
{
    const batten_curve *section = t->placed[k];
    const batten_interval domain = batten_curve_domain(section);
    const double u = bat_min(domain.b, bat_max(domain.a, (1 - s) * domain.a + s * domain.b));
    double given[3], found[3], rounding = 0;
    batten_status status = batten_curve_evaluate(section, u, 0, given);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(t->unified[k], s, 0, found);
    if (status != BATTEN_OK)
        return status;
    *miss = bat_distance(t->dimension, given, found);
    if (*miss > allowed / 2)
        status = parameter_rounding(section, u, &rounding);
    *miss -= rounding;
    return status;
}

/* The largest distance of a section from itself with common knots, beyond the rounding of
 * parameters: at its knots and midway between. Common knots only refine its spans. */
static batten_status knots_distance(const bat_skin *t, int k, double allowed, double *knots,
                                    double *worst)
{
    const batten_curve *section = t->placed[k];
    const batten_interval domain = batten_curve_domain(section);
    const int count = batten_curve_spans(section, knots);
    const double length = domain.b - domain.a;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < 2 && i + j < count; j++) {
            const double at = j ? knots[i] + (knots[i + 1] - knots[i]) / 2 : knots[i];
            const double s = (at - domain.a) / length;
            double miss = 0;
            const batten_status status =
                miss_at(t, k, bat_min(1, bat_max(0, s)), allowed, &miss);
            if (status != BATTEN_OK)
                return status;
            *worst = bat_max(*worst, miss);
        }
    return BATTEN_OK;
}

/* The largest distance between the control points of a section and those of its line on the
 * surface, homogeneous: a bound on that of the curves, but for weights. */
static double row_distance(const bat_skin *t, const batten_surface *surface, int k)
{
    const int q = t->across.degree, d = t->dimension;
    const int count = batten_surface_point_count(surface, BATTEN_V);
    const double *V = batten_surface_knots(surface, BATTEN_V);
    const double *P = batten_surface_points(surface), *w = batten_surface_weights(surface);
    const double *section = batten_curve_points(t->unified[k]);
    const int span = bat_knots_span(q, count, V, t->v[k], BATTEN_FROM_RIGHT);
    double basis[BATTEN_MAX_DEGREE + 1], worst = 0;
    bat_basis(q, V, span, t->v[k], 0, basis);
    for (int i = 0; i < t->points; i++) {
        const size_t first = (size_t)i * (size_t)count + (size_t)(span - q);
        const double *row = P + first * (size_t)d;
        double sum[3] = {0, 0, 0}, weight = w ? 0 : 1;
        for (int j = 0; j <= q; j++) {
            const double factor = w ? basis[j] * w[first + (size_t)j] : basis[j];
            weight += w ? factor : 0;
            for (int c = 0; c < d; c++)
                sum[c] += factor * *row++;
        }
        for (int c = 0; c < d; c++)
            worst = bat_max(worst, fabs(sum[c] / weight - section[i * d + c]));
    }
    return sqrt(d) * worst;
}

static batten_status check_section(const bat_skin *t, const batten_surface *surface, int k,
                                   double *knots)
{
    const int n = batten_curve_point_count(t->placed[k]) * t->dimension;
    double worst = 0, size = 0;
    for (int i = 0; i < n; i++)
        size = bat_max(size, fabs(batten_curve_points(t->placed[k])[i]));
    const double allowed = t->deviation[k] + BAT_EXACT * size;
    const batten_status status = knots_distance(t, k, allowed, knots, &worst);
    if (status != BATTEN_OK)
        return status;
    worst += row_distance(t, surface, k);
    if (!(worst <= allowed))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "section %d is missed by %g, more than %g",
                        k + 1, worst, allowed);
    return BATTEN_OK;
}

static batten_status check_sections(const bat_skin *t, const batten_surface *surface)
{
    int most = 0;
    for (int k = 0; k < t->count; k++)
        most = bat_max_int(most, batten_curve_spans(t->placed[k], NULL));
    double *knots = bat_array((size_t)most, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < t->count; k++)
        status = check_section(t, surface, k, knots);
    bat_release(knots);
    return status;
}

/* @param knots  spoilt: it becomes the sorted spans */
static double span_ratio(double *knots, int knot_count)
{
    const int spans = knot_count - 1;
    for (int i = 0; i < spans; i++)
        knots[i] = knots[i + 1] - knots[i];
    bat_sort_doubles((size_t)spans, knots);
    return knots[0] / knots[spans / 2];
}

/* A line of equal u: its parameter to the left and to the right, which differ at the seam of closed sections. */
typedef struct {
    double sides[2];
} seam_line;

/* What jumps across a knot line at one place: the angle between the normals of both sides, 0
 * where one of them vanishes, and the share by which |Su| does. */
static batten_status jumps(const batten_surface *surface, const seam_line *line, double v,
                           double *normal, double *speed)
{
    batten_vec3 normals[2];
    double speeds[2];
    for (int side = 0; side < 2; side++) {
        double out[9];
        const batten_status status = batten_surface_evaluate_side(
            surface, line->sides[side], v,
            (batten_sides){side == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT},
            1, out);
        if (status != BATTEN_OK)
            return status;
        normals[side] = bat_vec3_cross(bat_vec3_of(3, out + 3), bat_vec3_of(3, out + 6));
        speeds[side] = bat_norm(3, out + 3);
    }
    const double sine = bat_vec3_norm(bat_vec3_cross(normals[0], normals[1]));
    *normal = bat_max(*normal, bat_atan2(sine, bat_vec3_dot(normals[0], normals[1])));
    if (speeds[0] != speeds[1])
        *speed = bat_max(*speed, fabs(speeds[0] - speeds[1]) / bat_max(speeds[0], speeds[1]));
    return BATTEN_OK;
}

/* The corner of a curve between two parameters, which differ at the seam; the largest is kept. */
static batten_status curve_corner(const batten_curve *curve, const seam_line *line,
                                  double *corner)
{
    const int d = batten_curve_dimension(curve);
    double left[6], right[6];
    batten_status status =
        batten_curve_evaluate_side(curve, line->sides[0], BATTEN_FROM_LEFT, 1, left);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, line->sides[1], BATTEN_FROM_RIGHT, 1, right);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 a = bat_vec3_of(d, left + d), b = bat_vec3_of(d, right + d);
    *corner =
        bat_max(*corner, bat_atan2(bat_vec3_norm(bat_vec3_cross(a, b)), bat_vec3_dot(a, b)));
    return BATTEN_OK;
}

/* The largest corner of the sections with common knots at one of them; points have none. */
static batten_status section_corner(const bat_skin *t, const seam_line *line, double *corner)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < t->count && status == BATTEN_OK; k++)
        if (!t->point[k])
            status = curve_corner(t->unified[k], line, corner);
    return status;
}

/* The largest corner of a curve at its inner knots. */
static batten_status inner_corner(const batten_curve *curve, double *corner)
{
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    batten_status status = BATTEN_OK;
    for (int i = 1; i + 1 < count && status == BATTEN_OK; i++)
        status = curve_corner(curve, &(seam_line){{knots[i], knots[i]}}, corner);
    bat_release(knots);
    return status;
}

batten_status bat_skin_find_corners(bat_skin *t)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < t->count && status == BATTEN_OK; k++) {
        const batten_interval domain = batten_curve_domain(t->placed[k]);
        const seam_line seam = {{domain.b, domain.a}};
        if (t->point[k])
            continue;
        status = inner_corner(t->placed[k], &t->inner_corner);
        if (status == BATTEN_OK && t->closed)
            status = curve_corner(t->placed[k], &seam, &t->seam_corner);
    }
    return status;
}

/* Where jumps are looked for: at 33 places of the whole, and on the way from a pole to the section next to it, whose
 * normal at the pole itself is rounding. */
enum { EVEN_PLACES = 33, POLE_PLACES = 4 };

static int list_places(const bat_skin *t, double places[EVEN_PLACES + 2 * POLE_PLACES])
{
    const int last = t->count - 1;
    const bool poles[2] = {t->point[0], t->point[last] && !t->options->closed};
    const double a = t->v[0], b = t->v[last + t->options->closed];
    int count = 0;
    for (int j = poles[0]; j < EVEN_PLACES - poles[1]; j++)
        places[count++] = a + (b - a) * j / (EVEN_PLACES - 1);
    for (int end = 0; end < 2; end++) {
        const int tip = end ? last : 0, next = end ? last - 1 : 1;
        double share = 1;
        for (int j = 0; j < POLE_PLACES && poles[end]; j++)
            places[count++] = t->v[tip] + (share /= 4) * (t->v[next] - t->v[tip]);
    }
    return count;
}

/* The largest jumps over one line. A crease is what the sections have no corner for: `crease` by the sections as they
 * are now, which a cure may help, `noted` by those that were given. */
typedef struct {
    double normal, speed, crease, noted;
} line_jumps;

static batten_status find_line_jumps(const bat_skin *t, const batten_surface *surface,
                                     const seam_line *line, line_jumps *found)
{
    const bool is_seam = line->sides[0] != line->sides[1];
    const double given = is_seam ? t->seam_corner : t->inner_corner;
    double corner = 0, places[EVEN_PLACES + 2 * POLE_PLACES];
    const int count = list_places(t, places);
    batten_status status = section_corner(t, line, &corner);
    *found = (line_jumps){0};
    for (int j = 0; status == BATTEN_OK && j < count; j++)
        status = jumps(surface, line, places[j], &found->normal, &found->speed);
    if (corner < bat_skin_corner)
        found->crease = bat_max(0, found->normal - corner);
    /* Sections within a tolerance may have corners of their own where those given have none. */
    found->noted = given < bat_skin_corner ? bat_max(0, found->normal - given) : found->crease;
    return status;
}

/* Only knots that stand p times or more can have a jump, and the seam of closed sections. */
static batten_status find_jumps(bat_skin *t, const batten_surface *surface, const double *knots,
                                int knot_count)
{
    const batten_curve *first = t->unified[0];
    const int p = batten_curve_degree(first), n = batten_curve_point_count(first);
    batten_status status = BATTEN_OK;
    line_jumps here;
    for (int i = 1; status == BATTEN_OK && i + 1 < knot_count && t->dimension == 3; i++) {
        const seam_line line = {{knots[i], knots[i]}};
        if (bat_knots_multiplicity(p, n, batten_curve_knots(first), knots[i]) < p)
            continue;
        status = find_line_jumps(t, surface, &line, &here);
        t->found.normal_jump = bat_max(t->found.normal_jump, here.normal);
        t->found.speed_jump = bat_max(t->found.speed_jump, here.speed);
        t->found.crease = bat_max(t->found.crease, here.crease);
        t->noted_crease = bat_max(t->noted_crease, here.noted);
    }
    if (status == BATTEN_OK && t->closed && !t->periodic_u && t->dimension == 3) {
        const seam_line seam = {{knots[knot_count - 1], knots[0]}};
        status = find_line_jumps(t, surface, &seam, &here);
        t->noted_crease = bat_max(t->noted_crease, here.noted);
    }
    return status;
}

/* Distinct inner knots of all sections, those within rounding taken as one. */
static batten_status count_exact(const bat_skin *t, int *count)
{
    size_t total = 0, used = 0;
    for (int k = 0; k < t->count; k++)
        total += (size_t)batten_curve_spans(t->given[k], NULL);
    double *knots = bat_array(total, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < t->count; k++) {
        const int own = batten_curve_spans(t->given[k], knots + used);
        const batten_interval domain = batten_curve_domain(t->given[k]);
        for (int i = 1; i + 1 < own; i++) /* the ends are not counted */
            knots[used + (size_t)i - 1] =
                (knots[used + (size_t)i] - domain.a) / (domain.b - domain.a);
        used += (size_t)(own - 2);
    }
    bat_sort_doubles(used, knots);
    *count = used > 0;
    for (size_t i = 1; i < used; i++)
        *count += knots[i] - knots[i - 1] > 16 * DBL_EPSILON;
    bat_release(knots);
    return BATTEN_OK;
}

static void find_deviation(bat_skin *t)
{
    t->found.error = 0;
    t->found.worst_section = 0;
    for (int k = 0; k < t->count; k++)
        if (t->deviation[k] + t->moved[k] > t->found.error) {
            t->found.error = t->deviation[k] + t->moved[k];
            t->found.worst_section = k;
        }
}

batten_status bat_skin_inspect(bat_skin *t, const batten_surface *surface)
{
    const int knot_count = batten_surface_spans(surface, BATTEN_U, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, BATTEN_U, knots);
    t->found.knot_count = knot_count - 2;
    t->found.normal_jump = t->found.speed_jump = t->found.crease = t->noted_crease = 0;
    find_deviation(t);
    batten_status status = check_sections(t, surface);
    if (status == BATTEN_OK && (t->cures || t->reports))
        status = find_jumps(t, surface, knots, knot_count);
    if (status == BATTEN_OK && t->reports)
        status = count_exact(t, &t->found.exact_knot_count);
    t->found.span_ratio = span_ratio(knots, knot_count);
    bat_release(knots);
    return status;
}
