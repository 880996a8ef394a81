/* The equations of a spiro spline, one by one. */
#include "shape/bent/spiro_equations.h"
#include "shape/bent/spiro.h"

enum { N = BAT_SPIRO_UNKNOWNS };

/* ---- equations ---- */

/* Add factor times what a span has at an end: of the span before the point (side 0) its end. */
static void add_term(const bat_spiro_iterate *it, int span, int side, int order, double factor,
                     bat_spiro_terms *out)
{
    const bat_spiro_span *at = &it->spans[span];
    const int end = !side;
    out->value += factor * at->value[end][order];
    for (int m = 0; m < N; m++)
        out->row[side * N + m] += factor * at->by[end][order][m];
}

/* The two conditions of a side that ends freely; a straight span has them of its unknowns. */
static void add_free(const bat_spiro_search *s, const bat_spiro_iterate *it, int span, int side,
                     int which, bat_spiro_terms *out)
{
    if (s->task->straight[span]) {
        const int m = 2 * side + which;
        out->value = it->c[span * N + m];
        out->row[side * N + m] = 1;
        return;
    }
    const double l = s->task->chords->length[span];
    add_term(it, span, side, 2 + which, which ? l * l * l : l * l, out);
}

static void add_jump(const bat_spiro_iterate *it, int before, int after, int order,
                     double factor, bat_spiro_terms *out)
{
    add_term(it, before, 0, order, factor, out);
    add_term(it, after, 1, order, -factor, out);
}

/* The third and fourth equation of a point at which curvature continues. Where k'' is the same
 * at both sides and balances a part of the jump of k', the way from k'' = 0 to no jump is a
 * hinge that stiffens. */
static void add_smooth(const bat_spiro_iterate *it, int before, int after, double part,
                       double l, int which, bat_spiro_terms *out)
{
    if (which == 1) {
        add_jump(it, before, after, 3, l * l * l, out);
        return;
    }
    add_jump(it, before, after, 2, part * l * l, out);
    const double rest = (1 - part) * l * l * l / 2;
    add_term(it, before, 0, 3, rest, out);
    add_term(it, after, 1, 3, rest, out);
}

bat_spiro_terms bat_spiro_equation(const bat_spiro_search *s, const bat_spiro_iterate *it,
                                   int i, int before, int after, int which)
{
    const bat_chord_polygon *p = s->task->chords;
    const batten_spiro_kind kind = s->task->kinds[i];
    const double l = 1 / (1 / p->length[before] + 1 / p->length[after]);
    bat_spiro_terms e = {0};
    const bool one_way = kind == BATTEN_SPIRO_LEFT || kind == BATTEN_SPIRO_RIGHT;
    if (kind == BATTEN_SPIRO_CORNER)
        add_free(s, it, which < 2 ? before : after, which >= 2, which % 2, &e);
    else if (one_way && which >= 2)
        add_free(s, it, kind == BATTEN_SPIRO_LEFT ? before : after, kind == BATTEN_SPIRO_RIGHT,
                 which - 2, &e);
    else if (which >= 2)
        add_smooth(it, before, after, kind == BATTEN_SPIRO_SMOOTH ? s->part : 0, l, which - 2,
                   &e);
    else {
        add_jump(it, before, after, which, which ? l : 1, &e);
        e.value -= which ? 0 : p->turn[i];
    }
    return e;
}

bat_spiro_terms bat_spiro_end_equation(const bat_spiro_search *s, const bat_spiro_iterate *it,
                                       int end, int which)
{
    const bat_chord_polygon *p = s->task->chords;
    const batten_spiro_end *given = &s->task->ends[end];
    const int span = end ? p->spans - 1 : 0, side = !end;
    bat_spiro_terms e = {0};
    if (which == 0 && given->has_curvature) {
        add_term(it, span, side, 1, p->length[span], &e);
        e.value -= given->curvature * p->length[span];
    } else if (which == 1 && given->has_tangent) {
        add_term(it, span, side, 0, 1, &e);
        e.value -= given->tangent;
    } else {
        add_free(s, it, span, side, which, &e);
    }
    return e;
}
