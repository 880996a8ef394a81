/* Laws along a spine: twist, scale, and how sections lean at corners. */
#include "shape/motion_spine.h"

bat_jet bat_share(double length, const bat_jet *speed, double whole)
{
    const double d[4] = {length / whole, bat_jet_in_v(speed, 0) / whole,
                         bat_jet_in_v(speed, 1) / whole, bat_jet_in_v(speed, 2) / whole};
    return bat_jet_of_v(d);
}

/* A law at a share of the way, and how it goes on. */
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
    const double c = cos(angle.d[0]), s = sin(angle.d[0]);
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
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        if (!(scale[k].d[0] > 0))
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              "the scale is %g at %g of the spine: it must stay above 0",
                              scale[k].d[0], share->d[0]);
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
