/* One span of conics: a C by one conic or two, an S, a line, a biarc. */
#include "shape/arcs/conic_spans.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"

#include <batten/arcs.h>
#include <string.h>

static double cross(const double *u, const double *v)
{
    return u[0] * v[1] - u[1] * v[0];
}

static void along(const double *a, double l, const double *unit, double *out)
{
    out[0] = a[0] + l * unit[0];
    out[1] = a[1] + l * unit[1];
}

static void between(const double *a, const double *b, double share, double *out)
{
    out[0] = a[0] + share * (b[0] - a[0]);
    out[1] = a[1] + share * (b[1] - a[1]);
}

/* ---- one conic ---- */

/* The curvature that a weight of 1 would give at the start, or the end. */
static double curvature_of_parabola(const bat_conic_piece *p, bool at_end)
{
    const double u[2] = {p->b[0] - p->a[0], p->b[1] - p->a[1]};
    const double v[2] = {p->c[0] - p->b[0], p->c[1] - p->b[1]};
    const double leg = bat_norm(2, at_end ? v : u);
    return cross(u, v) / leg / leg / leg / 2;
}

double bat_conic_curvature(const bat_conic_piece *p, bool at_end)
{
    const double k = curvature_of_parabola(p, at_end) / p->w / p->w;
    return isfinite(k) ? k : 0; /* a line has legs but no area; its curvature is 0 */
}

/* The weight with which a conic has a curvature; 0 when none has. */
static double weight_for(const bat_conic_piece *p, bool at_end, double k)
{
    const double w = sqrt(curvature_of_parabola(p, at_end) / k);
    return w >= 1 / bat_conic_most_weight && w <= bat_conic_most_weight ? w : 0;
}

/* That of a circle where the legs are equal; below 1 always. */
static double usual_weight(const bat_conic_piece *p)
{
    return bat_distance(2, p->a, p->c) /
           (bat_distance(2, p->a, p->b) + bat_distance(2, p->b, p->c));
}

static void add_conic(bat_conic_fit *t, const bat_conic_piece *p)
{
    t->pieces[t->piece_count++] = *p;
}

static void fall_back(bat_conic_fit *t, int i)
{
    if (t->report.fallen_back++ == 0)
        t->report.first_fallen_back = i;
}

/* ---- a C ---- */

bool bat_conic_find_legs(const bat_conic_span *s, double *start, double *end)
{
    const double turn = fabs(s->alpha) + fabs(s->beta);
    *start = s->l * bat_sin(fabs(s->beta)) / bat_sin(turn);
    *end = s->l * bat_sin(fabs(s->alpha)) / bat_sin(turn);
    return s->alpha * s->beta < 0 && turn < BAT_PI &&
           bat_max(*start, *end) <= bat_conic_longest_leg * s->l &&
           bat_min(*start, *end) * bat_conic_longest_leg >= bat_max(*start, *end);
}

static void add_single(bat_conic_fit *t, const bat_conic_span *s, double leg)
{
    bat_conic_piece p = {.w = 1};
    memcpy(p.a, s->start, sizeof p.a);
    along(s->start, leg, s->t0, p.b);
    memcpy(p.c, s->end, sizeof p.c);
    p.w = t->options->kind == BATTEN_CONICS_SINGLE && t->options->weight > 0
              ? t->options->weight
              : usual_weight(&p);
    add_conic(t, &p);
}

/* Both conics of a pair with their joint at `nu` from A to B; weights of 1. */
static void make_pair(const bat_conic_span *s, double a, double b, double nu,
                      bat_conic_piece out[2])
{
    out[0] = out[1] = (bat_conic_piece){.w = 1};
    memcpy(out[0].a, s->start, sizeof out[0].a);
    along(s->start, a, s->t0, out[0].b);
    along(s->end, -b, s->t1, out[1].b);
    between(out[0].b, out[1].b, nu, out[0].c);
    memcpy(out[1].a, out[0].c, sizeof out[1].a);
    memcpy(out[1].c, s->end, sizeof out[1].c);
}

/* The pair with both curvatures; false when there is none. A single conic with these tangents
 * has the curvature k0 with one weight, k1 with another. When they are the same, the conic
 * meets its own subdivision in the middle at w / (1 + w) of both legs. */
static bool find_pair(const bat_conic_fit *t, const bat_conic_span *s, double leg0, double leg1,
                      bat_conic_piece out[2])
{
    bat_conic_piece whole = {.w = 1};
    memcpy(whole.a, s->start, sizeof whole.a);
    along(s->start, leg0, s->t0, whole.b);
    memcpy(whole.c, s->end, sizeof whole.c);
    const double w0 = weight_for(&whole, false, s->k0), w1 = weight_for(&whole, true, s->k1);
    if (w0 == 0 || w1 == 0)
        return false;
    const batten_curve_conics_options *o = t->options;
    const double lambda = o->start_share > 0 ? o->start_share : w0 / (1 + w0);
    const double mu = o->end_share > 0 ? o->end_share : w1 / (1 + w1);
    const double a = lambda * leg0, b = mu * leg1;
    /* Powers of lengths by the chord, so that none is too large. */
    const double x = bat_cbrt(fabs(s->k0) * s->l) * a, y = bat_cbrt(fabs(s->k1) * s->l) * b;
    make_pair(s, a, b, x / (x + y), out);
    out[0].w = weight_for(&out[0], false, s->k0);
    out[1].w = weight_for(&out[1], true, s->k1);
    return out[0].w > 0 && out[1].w > 0;
}

void bat_conic_add_c(bat_conic_fit *t, int i, const bat_conic_span *s, double leg0, double leg1)
{
    const batten_curve_conics_options *o = t->options;
    bat_conic_piece pair[2];
    if (o->kind == BATTEN_CONICS_SINGLE) {
        add_single(t, s, leg0);
        return;
    }
    if (o->kind == BATTEN_CONICS_PARABOLAS) {
        make_pair(s, leg0 * (o->start_share > 0 ? o->start_share : 0.5),
                  leg1 * (o->end_share > 0 ? o->end_share : 0.5), 0.5, pair);
    } else if (!find_pair(t, s, leg0, leg1, pair)) {
        fall_back(t, i);
        add_single(t, s, leg0);
        return;
    }
    add_conic(t, &pair[0]);
    add_conic(t, &pair[1]);
}

/* ---- an S ---- */

void bat_conic_add_s(bat_conic_fit *t, int i, const bat_conic_span *s)
{
    const double share = s->alpha / (s->alpha + s->beta), gamma = -share * s->beta;
    const double chord[2] = {(s->end[0] - s->start[0]) / s->l,
                             (s->end[1] - s->start[1]) / s->l};
    const double c = bat_cos(gamma), d = bat_sin(gamma);
    const double T[2] = {c * chord[0] - d * chord[1], c * chord[1] + d * chord[0]};
    double joint[2], leg = 0, other = 0;
    between(s->start, s->end, share, joint);
    const bat_conic_span first = {s->start, joint, s->t0, T, share * s->l,
                                  s->alpha, gamma, 0,     0};
    const bat_conic_span second = {joint, s->end,  T, s->t1, (1 - share) * s->l,
                                   gamma, s->beta, 0, 0};
    bool kept = true;
    t->report.inflections++;
    bat_conic_find_legs(&first, &leg, &other);
    add_single(t, &first, leg);
    bat_conic_find_legs(&second, &leg, &other);
    add_single(t, &second, leg);
    if (t->options->kind != BATTEN_CONICS_PAIRS)
        return;
    for (int k = 0; k < 2; k++) {
        bat_conic_piece *p = &t->pieces[t->piece_count - 2 + k];
        const double w = weight_for(p, k == 1, k == 0 ? s->k0 : s->k1);
        p->w = w > 0 ? w : p->w;
        kept = kept && w > 0;
    }
    if (!kept)
        fall_back(t, i);
}

/* ---- lines and arcs ---- */

void bat_conic_add_line(bat_conic_fit *t, const bat_conic_span *s)
{
    bat_conic_piece p = {.w = 1};
    memcpy(p.a, s->start, sizeof p.a);
    between(s->start, s->end, 0.5, p.b);
    memcpy(p.c, s->end, sizeof p.c);
    add_conic(t, &p);
}

/* An arc in parts of no more than a third of a turn. */
static void add_arc(bat_conic_fit *t, const batten_span *arc, const double end[2])
{
    const double turn = arc->curvature[0] * arc->length;
    const int parts = bat_max_int(1, (int)ceil(fabs(turn) / (2 * BAT_PI / 3)));
    const double step = arc->length / parts, half = turn / parts / 2;
    const double leg = half == 0 ? step / 2 : step / 2 * (bat_tan(half) / half);
    for (int i = 0; i < parts; i++) {
        const double angle = arc->angle + 2 * half * i;
        bat_conic_piece p = {.w = bat_cos(half)};
        bat_arc_at(arc, i * step, p.a);
        along(p.a, leg, (const double[]){bat_cos(angle), bat_sin(angle)}, p.b);
        bat_arc_at(arc, (i + 1) * step, p.c);
        if (i + 1 == parts)
            memcpy(p.c, end, sizeof p.c);
        add_conic(t, &p);
    }
}

batten_status bat_conic_add_biarc(bat_conic_fit *t, int i, const bat_conic_span *s)
{
    batten_biarc biarc;
    const batten_status status =
        batten_biarc_between((batten_ray){s->start, s->t0}, (batten_ray){s->end, s->t1},
                             BATTEN_JOINT_AUTOMATIC, 0.5, &biarc);
    if (status != BATTEN_OK)
        return status;
    if (t->report.arcs++ == 0)
        t->report.first_arcs = i;
    for (int k = 0; k < biarc.count; k++)
        add_arc(t, &biarc.arcs[k], k + 1 == biarc.count ? s->end : biarc.joint);
    return BATTEN_OK;
}
