/* The rulings of a developable surface, and the strip of the plane that they become. */
#include "numeric/quadrature.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/flat_step.h"
#include "shape/plate/unroll_parts.h"

#include <string.h>

/* Along a ruling the change of area is smooth, and between its ends of one kind. */
enum { ALONG = 4 };

/* Shorter rulings, for the size of the strip, are points. */
static const double no_length = BAT_ROUNDING;

static batten_status no_ruling(double u, const char *why)
{
    return bat_fail(BATTEN_SINGULAR_HERE, "the surface cannot be laid flat at %g: %s", u, why);
}

/* The direction of the ruling; where both edges meet at an end, the limit. */
static batten_status find_direction(const bat_strip *strip, double u, bat_strip_ruling *g)
{
    const batten_vec3 d = bat_vec3_subtract(g->P[1], g->P[0]);
    g->length = bat_vec3_norm(d);
    if (g->length > no_length * strip->size) {
        g->r = bat_vec3_scale(d, 1 / g->length);
        return BATTEN_OK;
    }
    const double sign = u == strip->domain.a ? 1 : -1;
    const batten_vec3 rate = bat_vec3_subtract(g->D[1], g->D[0]);
    const double norm = bat_vec3_norm(rate);
    if ((u != strip->domain.a && u != strip->domain.b) || norm == 0)
        return no_ruling(u, "its edges meet there");
    g->r = bat_vec3_scale(rate, sign / norm);
    return BATTEN_OK;
}

/* SINGULAR_HERE where it has no length, except at the ends of the domain, or no tangent plane. */
static batten_status ruling_at(const bat_strip *strip, double u, batten_side side,
                               bat_strip_ruling *out)
{
    for (int e = 0; e < 2; e++) {
        double values[2 * 3];
        batten_status status = batten_curve_evaluate_side(strip->edge[e], u, side, 1, values);
        if (status != BATTEN_OK)
            return status;
        out->P[e] = bat_vec3_of(3, values);
        out->D[e] = bat_vec3_of(3, values + 3);
    }
    batten_status status = find_direction(strip, u, out);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 middle = bat_vec3_add(out->D[0], out->D[1]);
    const batten_vec3 n = bat_vec3_cross(middle, out->r);
    const double norm = bat_vec3_norm(n);
    if (!(norm >
          BAT_ROUNDING * bat_vec3_norm(out->D[0]) + BAT_ROUNDING * bat_vec3_norm(out->D[1])))
        return no_ruling(u, "it has no tangent plane midway along its ruling");
    out->n = bat_vec3_scale(n, 1 / norm);
    out->m = bat_vec3_cross(out->n, out->r);
    return BATTEN_OK;
}

/* ---- what the sheet suffers ---- */

/* The share of length that is lost across the ruling at the share t along it: there a velocity
 * a keeps a . r and a . m and loses a . n. *area: of the surface, by u and length. */
static double strain_at(const bat_strip_ruling *g, double t, double *area)
{
    const batten_vec3 a =
        bat_vec3_add(bat_vec3_scale(g->D[0], 1 - t), bat_vec3_scale(g->D[1], t));
    const double across = bat_vec3_dot(a, g->m), off = bat_vec3_dot(a, g->n);
    *area = bat_norm(2, (const double[2]){across, off});
    /* At the vertex of a cone nothing moves but rounding. */
    const double moved = bat_vec3_norm(g->D[0]) + bat_vec3_norm(g->D[1]);
    if (*area <= no_length * moved)
        return 0;
    /* 1 - cos of the angle, without cancellation. */
    const double sine = off / *area, cosine = fabs(across) / *area;
    return sine * sine / (1 + cosine);
}

static void note_strain(bat_flat_strip *flat, double strain, double u, double t)
{
    if (strain <= flat->strain)
        return;
    flat->strain = strain;
    flat->strain_at[0] = u;
    flat->strain_at[1] = t;
}

/* The part of one Gauss node, of weight w, in lengths, areas and strains. */
static void measure_ruling(bat_flat_strip *flat, const bat_strip_ruling *g, double u, double w)
{
    double nodes[ALONG], weights[ALONG], area;
    bat_gauss(ALONG, nodes, weights);
    for (int e = 0; e < 2; e++) {
        flat->length[e][0] += w * bat_vec3_norm(g->D[e]);
        flat->length[e][1] += w * bat_norm(2, (const double[2]){bat_vec3_dot(g->D[e], g->r),
                                                                bat_vec3_dot(g->D[e], g->m)});
        note_strain(flat, strain_at(g, e, &area), u, e);
    }
    for (int k = 0; k < ALONG; k++) {
        const double t = 0.5 + 0.5 * nodes[k];
        const double strain = strain_at(g, t, &area);
        const double part = w * weights[k] / 2 * g->length * area;
        flat->area[0] += part;
        flat->area[1] += part * (1 - strain);
        flat->strain_sum += part * strain * strain;
        note_strain(flat, strain, u, t);
    }
}

/* Diagonals from ruling i to the next, whose ends in space are given. */
static void measure_diagonals(bat_flat_strip *flat, int i, const batten_vec3 from[2],
                              const batten_vec3 to[2])
{
    const double *p = flat->points + 4 * i;
    for (int e = 0; e < 2; e++) {
        const double space = bat_vec3_norm(bat_vec3_subtract(to[1 - e], from[e]));
        const double plane = bat_distance(2, p + 4 + 2 * (1 - e), p + 2 * e);
        if (space > 0 && fabs(plane - space) > flat->diagonal[0] * space) {
            flat->diagonal[0] = fabs(plane - space) / space;
            flat->diagonal[1] = flat->u[i];
        }
    }
}

/* ---- the plane ---- */

static void put_ends(const bat_strip_ruling *g, double phi, const double at[2], double *points)
{
    points[0] = at[0];
    points[1] = at[1];
    points[2] = at[0] + g->length * bat_cos(phi);
    points[3] = at[1] + g->length * bat_sin(phi);
}

static void put_rates(const bat_strip_ruling *g, double phi, double *first, double *second)
{
    const double c = bat_cos(phi), s = bat_sin(phi);
    for (int e = 0; e < 2; e++) {
        double *rate = e ? second : first;
        const double along = bat_vec3_dot(g->D[e], g->r), left = bat_vec3_dot(g->D[e], g->m);
        rate[0] = along * c - left * s;
        rate[1] = along * s + left * c;
    }
}

/* From one ruling to the next. */
typedef struct {
    double u, h;   /* where it begins, and how long it is */
    batten_vec3 n; /* the normal there */
} strip_step;

/* A strip that bends by this angle is by 5e-17 longer than in the plane: nothing of it is lost there. */
static const double no_bend = 1e-8;

/* The rates over one step, and what it adds to lengths and strains. *bend: the most by which the normal leaves that at
 * the start. */
static batten_status find_rates(const bat_strip *strip, const bat_flat_rule *rule,
                                const strip_step *step, bat_flat_strip *flat,
                                bat_flat_rates *rates, double *bend)
{
    *bend = 0;
    const double u = step->u, h = step->h;
    for (int j = 0; j < BAT_FLAT_NODES; j++) {
        bat_strip_ruling g;
        const double at = u + rule->c[j] * h;
        batten_status status = ruling_at(strip, at, BATTEN_FROM_RIGHT, &g);
        if (status != BATTEN_OK)
            return status;
        if (!(g.length > 0))
            return no_ruling(at, "its edges meet there");
        if (bat_vec3_dot(g.n, step->n) < 0)
            return no_ruling(at, "its normal turns over, as at an edge of regression");
        *bend = bat_max(*bend, bat_vec3_norm(bat_vec3_subtract(g.n, step->n)));
        const batten_vec3 rate = bat_vec3_subtract(g.D[1], g.D[0]);
        rates->turn[j] = h * bat_vec3_dot(rate, g.m) / g.length;
        rates->along[j] = h * bat_vec3_dot(g.D[0], g.r);
        rates->across[j] = h * bat_vec3_dot(g.D[0], g.m);
        measure_ruling(flat, &g, at, rule->weights[j] * h);
    }
    return BATTEN_OK;
}

/* A step in a plane is moved there as it is. */
static void move_rigidly(const bat_strip_ruling *from, const bat_strip_ruling *to, double *phi,
                         double at[2])
{
    const batten_vec3 by = bat_vec3_subtract(to->P[0], from->P[0]);
    const double along = bat_vec3_dot(by, from->r), left = bat_vec3_dot(by, from->m);
    const double c = bat_cos(*phi), s = bat_sin(*phi);
    at[0] += along * c - left * s;
    at[1] += along * s + left * c;
    *phi += bat_atan2(bat_vec3_dot(to->r, from->m), bat_vec3_dot(to->r, from->r));
}

static batten_status lay_flat(const bat_strip *strip, bat_flat_strip *flat)
{
    bat_flat_rule rule;
    bat_strip_ruling g, next;
    double phi = BAT_PI / 2, at[2] = {0, 0}, bend = 0;
    bat_flat_rule_make(&rule);
    batten_status status = ruling_at(strip, flat->u[0], BATTEN_FROM_RIGHT, &g);
    if (status != BATTEN_OK)
        return status;
    put_ends(&g, phi, at, flat->points);
    for (int i = 0; i + 1 < flat->count; i++) {
        const double u = flat->u[i], h = flat->u[i + 1] - u;
        double *rates = flat->rates + (size_t)8 * (size_t)i;
        bat_flat_rates over;
        status = ruling_at(strip, u, BATTEN_FROM_RIGHT, &g);
        if (status == BATTEN_OK)
            status = ruling_at(strip, flat->u[i + 1], BATTEN_FROM_LEFT, &next);
        if (status == BATTEN_OK)
            status = find_rates(strip, &rule, &(strip_step){u, h, g.n}, flat, &over, &bend);
        if (status != BATTEN_OK)
            return status;
        put_rates(&g, phi, rates, rates + 4);
        if (bend <= no_bend && bat_vec3_norm(bat_vec3_subtract(next.n, g.n)) <= no_bend)
            move_rigidly(&g, &next, &phi, at);
        else
            bat_flat_step(&rule, &over, &phi, &at[0], &at[1]);
        put_rates(&next, phi, rates + 2, rates + 6);
        put_ends(&next, phi, at, flat->points + 4 * (i + 1));
        measure_diagonals(flat, i, g.P, next.P);
    }
    flat->turn = phi - BAT_PI / 2;
    return BATTEN_OK;
}

batten_status bat_strip_flatten(const bat_strip *strip, int knot_count, const double *knots,
                                int steps, bat_flat_strip *out)
{
    const int count = (knot_count - 1) * steps + 1;
    out->count = count;
    out->u = bat_array((size_t)count, sizeof(double));
    out->points = bat_array((size_t)count * 4, sizeof(double));
    out->rates = bat_array((size_t)count * 8, sizeof(double));
    if (!out->u || !out->points || !out->rates)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k + 1 < knot_count; k++)
        for (int j = 0; j < steps; j++)
            out->u[k * steps + j] = knots[k] + (knots[k + 1] - knots[k]) * j / steps;
    out->u[count - 1] = knots[knot_count - 1];
    return lay_flat(strip, out);
}

void bat_flat_strip_release(bat_flat_strip *flat)
{
    bat_release(flat->u);
    bat_release(flat->points);
    bat_release(flat->rates);
    *flat = (bat_flat_strip){0};
}
