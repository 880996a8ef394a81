/* The curves of the loops of .g2 files: in the parameters of a surface, in space, or both. */
#include "body/trace/lift.h"
#include "exchange/g2/g2.h"
#include "numeric/vector.h"

#include <batten/nearest.h>

/* "1 100 100": which is the master, and the classes of both curves, 0 for none; old files write
 * 1 for splines. */
static batten_status read_forms(bat_words *words, bat_g2_trim *t)
{
    int master = 0, classes[2] = {0, 0};
    batten_status status =
        bat_words_integer(words, "the mark of the master curve", 0, 1, &master);
    t->by_parameters = master == 1;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = bat_words_integer(words, "the class of a trimming curve", 0, 999, &classes[k]);
        if (classes[k] == 1)
            classes[k] = BAT_G2_CURVE;
    }
    if (status == BATTEN_OK && classes[0])
        status = bat_g2_read_curve(words, classes[0], false, &t->parameters);
    if (status == BATTEN_OK && classes[1])
        status = bat_g2_read_curve(words, classes[1], false, &t->space);
    if (status == BATTEN_OK && !t->parameters && !t->space)
        status = bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                                "a trimming curve has neither form");
    if (status == BATTEN_OK && ((t->parameters && batten_curve_dimension(t->parameters) != 2) ||
                                (t->space && batten_curve_dimension(t->space) != 3)))
        status = bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                                "a trimming curve has the wrong dimension");
    return status;
}

/* In a plane parameters are lengths along its axes. */
static batten_status lift_from_plane(const bat_g2_ground *ground, bat_g2_trim *t)
{
    const batten_vec3 x = ground->frame.x, y = bat_vec3_cross(ground->frame.z, x);
    const batten_vec3 u = ground->is_swapped ? y : x, v = ground->is_swapped ? x : y,
                      o = ground->frame.origin;
    const batten_affine place = {{{u.x, v.x, ground->frame.z.x},
                                  {u.y, v.y, ground->frame.z.y},
                                  {u.z, v.z, ground->frame.z.z}},
                                 {o.x, o.y, o.z}};
    batten_curve *flat = NULL;
    batten_status status = batten_curve_to_dimension(t->parameters, 3, &flat);
    if (status == BATTEN_OK)
        status = batten_curve_transform(flat, &place, &t->space);
    batten_curve_unref(flat);
    return status;
}

/* The curve in space of a trim, made when the file has none. Parameters that are not those of
 * the surface go. */
static batten_status complete(bat_words *words, const bat_g2_ground *ground, double tolerance,
                              bat_g2_trim *t)
{
    double error = 0;
    if (!t->space && !ground->is_spline)
        return bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                              "a trimming curve on an elementary surface has no form in space");
    batten_status status = BATTEN_OK;
    if (!t->space) {
        status = bat_lift(ground->surface, t->parameters, tolerance, &t->space, &error);
        if (status == BATTEN_OK && error > 0)
            batten_notes_add(
                words->input->notes, words->input->file, words->line, "bounded surface",
                "a curve in space was made from that in the parameters, within %g", error);
    }
    if (!ground->is_spline) {
        batten_curve_unref(t->parameters);
        t->parameters = NULL;
    }
    return status;
}

/* ---- the two forms of a trim ---- */

/* How far the form in the parameters is from that in space: at places of each span, and at the ends. */
static batten_status forms_miss(bat_input *input, const batten_surface *surface,
                                const bat_g2_trim *t, double *miss)
{
    enum { EACH = 4, MOST = 500 };
    const batten_interval flat = batten_curve_domain(t->parameters),
                          on = batten_curve_domain(t->space);
    const int steps = bat_min_int(MOST, EACH * batten_curve_spans(t->parameters, NULL));
    bat_list points = {.size = 3 * sizeof(double)};
    batten_deviation far;
    batten_status status = BATTEN_OK;
    double end[3];
    for (int i = 0; status == BATTEN_OK && i <= steps; i++) {
        double uv[2], point[3];
        status = batten_curve_evaluate(
            t->parameters, i < steps ? flat.a + i * (flat.b - flat.a) / steps : flat.b, 0, uv);
        if (status == BATTEN_OK)
            status = batten_surface_evaluate(surface, uv[0], uv[1], 0, point);
        if (status == BATTEN_OK)
            status = bat_list_add(input, &points, point);
    }
    const double *P = points.items;
    if (status == BATTEN_OK)
        status = batten_curve_deviation(t->space, (batten_points){3, (int)points.count, P},
                                        NULL, NULL, NULL, &far);
    if (status == BATTEN_OK)
        *miss = far.max;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = batten_curve_evaluate(t->space, k ? on.b : on.a, 0, end);
        if (status == BATTEN_OK)
            *miss = bat_max(*miss, bat_distance(3, end, k ? P + 3 * (size_t)steps : P));
    }
    bat_release(points.items);
    return status;
}

/* Formats keep one form or the other: where they part, the other is made of the master. */
static batten_status settle_forms(bat_words *words, const bat_g2_ground *ground, double size,
                                  bat_g2_trim *t, double *parted)
{
    const double same = 1e-6 * size; /* as most programs keep curves */
    double miss = 0, error = 0;
    batten_curve *lifted = NULL;
    batten_status status = forms_miss(words->input, ground->surface, t, &miss);
    if (bat_input_ends(status))
        return status;
    if (status == BATTEN_OK && !(miss > same))
        return BATTEN_OK;
    if (status == BATTEN_OK && t->by_parameters) {
        status = bat_lift(ground->surface, t->parameters, same, &lifted, &error);
        if (bat_input_ends(status))
            return status;
    }
    if (lifted) {
        batten_curve_unref(t->space);
        t->space = lifted;
    } else { /* parameters that are no master, or not of this surface */
        batten_curve_unref(t->parameters);
        t->parameters = NULL;
    }
    *parted = bat_max(*parted, miss);
    return BATTEN_OK;
}

batten_status bat_g2_read_trim(bat_words *words, const bat_g2_ground *ground, bat_g2_trim *t)
{
    *t = (bat_g2_trim){NULL, NULL, false};
    batten_status status = read_forms(words, t);
    if (status == BATTEN_OK && !t->space && ground->is_plane)
        status = lift_from_plane(ground, t);
    return status;
}

batten_status bat_g2_settle_trim(bat_words *words, const bat_g2_ground *ground, double size,
                                 double tolerance, bat_g2_trim *t, double *parted)
{
    batten_status status = BATTEN_OK;
    if (ground->is_spline && t->space && t->parameters)
        status = settle_forms(words, ground, size, t, parted);
    return status == BATTEN_OK ? complete(words, ground, tolerance, t) : status;
}
