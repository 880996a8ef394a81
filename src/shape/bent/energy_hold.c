/*
 * Curves that would bend less and less by growing. Among all that pass the points there is no
 * least then, but among those up to a length there is one: a curve under tension.
 */
#include "shape/bent/energy.h"

#include <batten/curve.h>
#include <batten/measure.h>

/* The length may be above that of the start by this part: then the energy is below. */
static const double ROOM = 0.02;
/* Each doubles or halves what is known of the tension, or more. */
enum { TRIALS = 12, TRIAL_PIECES = 4 };

/* The tensions between which the right one lies; 0: not known. */
typedef struct {
    double low, high;
} tension_range;

static double next_tension(const tension_range *r)
{
    if (r->low == 0)
        return r->high / 4;
    return r->high == 0 ? 4 * r->low : sqrt(r->low * r->high);
}

static batten_status length_of(const bat_energy_start *start, double *length)
{
    return start->chain ? batten_chain_length(start->chain, NULL, length)
                        : batten_curve_length(start->curve, 1e-6, NULL, length);
}

/* The least under a tension, in units of the mean chord; its energy without that. */
static batten_status search_under(bat_energy_spline *t, const bat_energy_start *start,
                                  double tension, int pieces, bat_energy_found *out)
{
    const batten_curve_minimum_energy_options *given = t->options;
    batten_curve_minimum_energy_options held = *given;
    held.tension = tension / bat_energy_tension_unit(t);
    held.pieces = given->pieces > 0 ? given->pieces : pieces;
    t->options = &held;
    t->rest = BAT_ENERGY_WORTH;
    const batten_status status = bat_energy_search_start(t, start, HUGE_VAL, out);
    t->options = given;
    t->rest = BAT_ENERGY_REST;
    if (status == BATTEN_OK) {
        out->report.after -= tension * out->report.length;
        out->report.tension = tension;
    }
    return status;
}

/* The tension that lets the curve be as long as the start: less of it lets it grow. */
static batten_status find_tension(bat_energy_spline *t, const bat_energy_start *rival,
                                  const bat_energy_start *start, double length,
                                  bat_energy_found *best)
{
    tension_range range = {0, 0};
    double tension = bat_min(rival->energy / length, 4);
    for (int i = 0; i < TRIALS; i++) {
        bat_energy_found now = {0};
        const batten_status status = search_under(t, start, tension, TRIAL_PIECES, &now);
        if (status != BATTEN_OK && status != BATTEN_INCOMPLETE)
            return status;
        const double reached = now.report.length;
        const bool is_long = status == BATTEN_INCOMPLETE ? now.is_growing : reached >= length;
        *(is_long ? &range.low : &range.high) = tension;
        if (status == BATTEN_OK && now.report.after <= rival->energy &&
            (!best->curve || reached < best->report.length)) {
            bat_energy_found_release(best);
            *best = now;
        } else {
            bat_energy_found_release(&now);
        }
        if (best->curve && best->report.length <= (1 + ROOM) * length)
            return BATTEN_OK;
        tension = next_tension(&range);
    }
    return best->curve ? BATTEN_OK : BATTEN_INCOMPLETE;
}

batten_status bat_energy_hold(bat_energy_spline *t, const bat_energy_start *rival,
                              const bat_energy_start *start, bat_energy_found *best)
{
    double length = 0;
    bat_energy_found found = {0};
    batten_status status = length_of(rival, &length);
    if (status == BATTEN_OK)
        status = find_tension(t, rival, start, length, &found);
    /* Once more, with as many quintics as save energy. */
    if (status == BATTEN_OK && t->options->pieces == 0) {
        bat_energy_found fine = {0};
        status = search_under(t, start, found.report.tension, 0, &fine);
        if (status == BATTEN_OK && fine.report.after <= found.report.after) {
            bat_energy_found_release(&found);
            found = fine;
        } else {
            bat_energy_found_release(&fine);
        }
        status = status == BATTEN_INCOMPLETE ? BATTEN_OK : status;
    }
    found.report.before = rival->energy;
    if (status == BATTEN_OK)
        *best = found;
    else
        bat_energy_found_release(&found);
    return status;
}
