/* The crease and the edges of a fold on the flat sheet. */
#include "numeric/vector.h"
#include "shape/plate/flat_step.h"
#include "shape/plate/fold_parts.h"

/* From sample i to the next: direction and point of the flat crease. */
static batten_status flat_step(const bat_fold_task *t, const bat_flat_rule *rule, int i,
                               double *phi, double at[2])
{
    bat_flat_rates rates = {{0}, {0}, {0}};
    const double u = t->at[i].u, h = t->at[i + 1].u - u;
    for (int j = 0; j < BAT_FLAT_NODES; j++) {
        bat_fold_place p;
        double values[2 * 3];
        const double s = t->at[i].s + rule->c[j] * (t->at[i + 1].s - t->at[i].s);
        /* The length at the node is known nearly, which does for the law of angles: it varies
         * slowly. */
        batten_status status = bat_fold_find_place(t, s, u + rule->c[j] * h, &p);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(t->space, u + rule->c[j] * h, 1, values);
        if (status != BATTEN_OK)
            return status;
        rates.along[j] = bat_norm(3, values + 3) * h;
        rates.turn[j] = p.k * bat_cos(p.a) * rates.along[j];
    }
    bat_flat_step(rule, &rates, phi, &at[0], &at[1]);
    return BATTEN_OK;
}

static void flat_ruling(double phi, double b, double sign, double *out)
{
    out[0] = sign * bat_cos(phi + b);
    out[1] = sign * bat_sin(phi + b);
}

batten_status bat_fold_flatten(bat_fold_task *t)
{
    bat_flat_rule rule;
    double phi = 0, at[2] = {0, 0};
    batten_status status = BATTEN_OK;
    bat_flat_rule_make(&rule);
    for (int i = 0; i < t->count && status == BATTEN_OK; i++) {
        t->made.flat[2 * i] = at[0];
        t->made.flat[2 * i + 1] = at[1];
        flat_ruling(phi, t->b[0][i], 1, t->made.left.flat_rulings + 2 * i);
        flat_ruling(phi, t->b[1][i], -1, t->made.right.flat_rulings + 2 * i);
        if (i + 1 < t->count)
            status = flat_step(t, &rule, i, &phi, at);
    }
    t->made.flat_turn = phi;
    return status;
}
