/* Laws along a spine: twist, scale, and how sections lean at corners. */
#include "shape/sweep/motion_spine.h"
#include "spline/curve/curve.h"
#include <batten/nearest.h>

#include <float.h>

bat_jet bat_share(double length, const bat_jet *speed, double whole)
{
    const double d[4] = {length / whole, bat_jet_in_v(speed, 0) / whole,
                         bat_jet_in_v(speed, 1) / whole, bat_jet_in_v(speed, 2) / whole};
    return bat_jet_of_v(d);
}

/* A law at a share of the path, and its derivatives. */
static batten_status law_at(const batten_curve *law, const bat_jet *share, batten_side side,
                            bat_jet *out)
{
    const batten_interval domain = batten_curve_domain(law);
    const double range = domain.b - domain.a;
    const double s = bat_max(0, bat_min(1, share->d[0]));
    double g[4];
    const batten_status status =
        batten_curve_evaluate_side(law, (1 - s) * domain.a + s * domain.b, side, 3, g);
    if (status != BATTEN_OK)
        return status;
    for (int k = 1; k < 4; k++)
        for (int i = k; i < 4; i++)
            g[i] *= range;
    *out = bat_jet_compose(g, *share);
    return BATTEN_OK;
}

/* The least value of a law at its knots, from both sides, and where it turns back. */
static batten_status least_value(const batten_curve *law, const batten_parameters *turns,
                                 double *at, double *least)
{
    const int spans = batten_curve_spans(law, NULL);
    double *knots = bat_array((size_t)spans, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(law, knots);
    *least = HUGE_VAL;
    for (int i = 0; i < 2 * (spans + turns->count) && status == BATTEN_OK; i++) {
        const double u = i / 2 < spans ? knots[i / 2] : turns->at[i / 2 - spans];
        double value = 0;
        status = batten_curve_evaluate_side(
            law, u, i % 2 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 0, &value);
        if (status == BATTEN_OK && value < *least) {
            *least = value;
            *at = u;
        }
    }
    bat_release(knots);
    return status;
}

batten_status bat_spine_check_scale(const batten_curve *law, const char *name)
{
    const batten_interval domain = batten_curve_domain(law);
    batten_parameters turns = {0, NULL};
    double at = 0, least = 0, largest = 0;
    batten_status status = batten_curve_turns(law, (batten_vec3){1, 0, 0}, &turns);
    if (status == BATTEN_OK)
        status = least_value(law, &turns, &at, &least);
    batten_release(turns.at);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < law->count; i++)
        largest = bat_max(largest, fabs(law->points[i]));
    if (fabs(least) <= 32 * DBL_EPSILON * largest)
        least = 0; /* but for rounding */
    return least > 0 ? BATTEN_OK
                     : bat_fail(BATTEN_BAD_ARGUMENT,
                                "the %s is %g at %g of the spine: it must stay above 0", name,
                                least, (at - domain.a) / (domain.b - domain.a));
}

batten_status bat_spine_turn(const bat_spine_motion *m, const bat_jet *share, batten_side side,
                             bat_bare_frame *f)
{
    bat_jet angle = bat_jet_scale(m->turn, *share);
    if (m->laws[2]) {
        bat_jet twist;
        const batten_status status = law_at(m->laws[2], share, side, &twist);
        if (status != BATTEN_OK)
            return status;
        angle = bat_jet_add(angle, twist);
    } else if (m->turn == 0) {
        return BATTEN_OK;
    }
    const double c = bat_cos(angle.d[0]), s = bat_sin(angle.d[0]);
    const bat_jet cosine = bat_jet_compose((double[4]){c, -s, -c, s}, angle);
    const bat_jet sine = bat_jet_compose((double[4]){s, c, -s, -c}, angle);
    const bat_jet3 x = f->x;
    f->x = bat_jet3_add(bat_jet3_multiply(cosine, x), bat_jet3_multiply(sine, f->y));
    f->y = bat_jet3_subtract(bat_jet3_multiply(cosine, f->y), bat_jet3_multiply(sine, x));
    return BATTEN_OK;
}

batten_status bat_spine_scale(const bat_spine_motion *m, const bat_jet *share, batten_side side,
                              bat_bare_frame *f)
{
    bat_jet scale[2];
    if (!m->laws[0])
        return BATTEN_OK;
    batten_status status = law_at(m->laws[0], share, side, &scale[0]);
    scale[1] = scale[0];
    if (status == BATTEN_OK && m->laws[1])
        status = law_at(m->laws[1], share, side, &scale[1]);
    if (status != BATTEN_OK)
        return status;
    f->x = bat_jet3_multiply(scale[0], f->x);
    f->y = bat_jet3_multiply(scale[1], f->y);
    if (!m->laws[1])
        f->z = bat_jet3_multiply(scale[0], f->z);
    return BATTEN_OK;
}

void bat_spine_lean(const bat_spine_motion *m, const bat_spine_run *r, double length,
                    bat_bare_frame *f)
{
    const double(*k)[2] = r->shear;
    if (k[0][0] == 0 && k[0][1] == 0 && k[1][0] == 0 && k[1][1] == 0)
        return;
    const double start = m->length[r->first];
    const bat_jet share = bat_share(length - start, &f->speed, m->length[r->last] - start);
    bat_jet3 *axes[2] = {&f->x, &f->y};
    for (int i = 0; i < 2; i++) {
        const bat_jet by =
            bat_jet_add(bat_jet_constant(k[0][i]), bat_jet_scale(k[1][i] - k[0][i], share));
        *axes[i] = bat_jet3_add(*axes[i], bat_jet3_multiply(by, f->tangent));
    }
}
