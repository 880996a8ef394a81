/* Loops that lack the part along the border of their surface: some programs write one curve for
 * all the others. */
#include "exchange/iges/read/loops.h"

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

static batten_status end_of(const bat_iges_side *side, bool last, double p[3])
{
    const batten_interval domain = batten_curve_domain(side->space);
    return batten_curve_evaluate(side->space, last != side->reversed ? domain.b : domain.a, 0,
                                 p);
}

/* The place of p on a border, as the parameter along it; *is_on is not set when it is farther
 * off than `near`. */
static batten_status place_on(bat_chart *chart, int side, const double p[3], double near,
                              bool *is_on, double *at)
{
    const batten_direction across = side % 2 ? BATTEN_U : BATTEN_V;
    const batten_interval domain = chart->domain[across];
    double uv[2], s[3], off = 0;
    *is_on = false;
    batten_status status = bat_chart_find(chart, p, NULL, uv, &off);
    if (status != BATTEN_OK)
        return status;
    bat_chart_wrap(chart, uv, uv);
    uv[across] = side == 1 || side == 2 ? domain.b : domain.a;
    status = bat_chart_evaluate(chart, uv, 0, s);
    *at = uv[1 - across];
    *is_on = status == BATTEN_OK && distance(s, p) <= near;
    return status;
}

/* The part of a border from `a` to `b`, which may run backwards. */
static batten_status part_of_border(const bat_chart *chart, int side, double a, double b,
                                    bat_iges_side *out)
{
    const batten_direction across = side % 2 ? BATTEN_U : BATTEN_V;
    const batten_interval domain = chart->domain[across];
    batten_curve *border = NULL;
    batten_status status = batten_surface_isocurve(
        chart->surface, across, side == 1 || side == 2 ? domain.b : domain.a, &border);
    out->reversed = a > b;
    if (status == BATTEN_OK)
        status = batten_curve_subrange(border, bat_min(a, b), bat_max(a, b), &out->space);
    batten_curve_unref(border);
    return status;
}

/* Along the only border on which both ends are. Where the surface closes, its borders are no
 * place to tell which way to go. */
static batten_status find_missing(const bat_iges_face *face, const double p[3],
                                  const double q[3], double near, bat_iges_side *out)
{
    bat_chart chart;
    batten_status status =
        bat_chart_begin(face->ground.surface, face->ground.tolerance, &chart);
    int found = 0;
    for (int side = 0; status == BATTEN_OK && side < 4 && !chart.closed[0] && !chart.closed[1];
         side++) {
        double a = 0, b = 0;
        bool has_p = false, has_q = false;
        if (chart.pole[side])
            continue;
        status = place_on(&chart, side, p, near, &has_p, &a);
        if (status == BATTEN_OK)
            status = place_on(&chart, side, q, near, &has_q, &b);
        if (status != BATTEN_OK || !has_p || !has_q || a == b)
            continue;
        if (found++ == 0)
            status = part_of_border(&chart, side, a, b, out);
    }
    bat_chart_end(&chart);
    if (status != BATTEN_OK || found > 1) {
        batten_curve_unref(out->space);
        out->space = NULL;
    }
    return status;
}

batten_status bat_iges_close_loop(bat_iges_face *face, bat_iges_loop *loop)
{
    const bat_iges_side *sides = loop->sides.items;
    const double near = bat_iges_open_gap(face);
    double p[3], q[3];
    bat_iges_side missing = {NULL, NULL, false};
    if (face->ground.is_elementary)
        return BATTEN_OK;
    batten_status status = end_of(&sides[loop->sides.count - 1], true, p);
    if (status == BATTEN_OK)
        status = end_of(&sides[0], false, q);
    if (status != BATTEN_OK || distance(p, q) <= near)
        return status;
    status = find_missing(face, p, q, near, &missing);
    if (status != BATTEN_OK || !missing.space)
        return status;
    status = bat_list_add(face->reading->input, &loop->sides, &missing);
    if (status != BATTEN_OK)
        batten_curve_unref(missing.space);
    else
        bat_iges_note(face->reading, face->entry,
                      "a loop ends %g from where it begins; closed along the border of its "
                      "surface",
                      distance(p, q));
    return status;
}
