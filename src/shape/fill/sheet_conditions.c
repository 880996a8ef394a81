/* What sides, their ribbons, and points and curves inside ask of a sheet. */
#include "base/list.h"
#include "numeric/vector.h"
#include "shape/fill/sheet.h"
#include <string.h>

#define DEGREES (180 / BAT_PI)

/* What stands steeper over the plane has a cosine below this: 84 degrees. */
static const double least_cosine = 0.1;

static batten_status add_asked(bat_sheet_conditions *list, const bat_sheet_condition *condition)
{
    return BAT_LIST_ADD(list->at, list->count, list->room, *condition);
}

/* A point of the frame in model units, for messages. */
static batten_vec3 in_space(const bat_sheet_outline *outline, const double point[3])
{
    return batten_affine_apply(bat_sheet_from_frame(outline), bat_vec3_of(3, point));
}

/* ---- the sides ---- */

/* One place of a side: the ribbon there, the unit normal of its planes that looks up, and how
 * much of the side it stands for. */
typedef struct {
    bat_fill_view ribbon;
    double curve[2][3]; /* C and C' */
    double normal[3];
    double share;
} side_place;

static batten_status check_rise(const bat_sheet_outline *outline, int i,
                                const side_place *place)
{
    const double *tangent = place->curve[1];
    const double flat = bat_norm(2, tangent), speed = bat_norm(3, tangent);
    if (flat >= least_cosine * speed)
        return BATTEN_OK;
    const batten_vec3 at = in_space(outline, place->curve[0]);
    return bat_fail(
        BATTEN_NOT_COMPATIBLE,
        "curve %d rises at %.3g degrees from the mean plane of the hole at (%g, %g, "
        "%g): a sheet follows up to %.3g",
        outline->sides[i].given + 1, bat_acos(flat / speed) * DEGREES, at.x, at.y, at.z,
        bat_acos(least_cosine) * DEGREES);
}

/* The normal up; ribbons that are upright or point out of the hole are refused. */
static batten_status see_planes(const bat_sheet_outline *outline, int i, side_place *place)
{
    const double sign = outline->reversed[i] ? -1 : 1;
    for (int c = 0; c < 3; c++)
        place->normal[c] = sign * place->ribbon.normal[c];
    if (place->normal[2] >= least_cosine)
        return BATTEN_OK;
    const batten_vec3 at = in_space(outline, place->curve[0]);
    const int number = outline->sides[i].given + 1;
    if (place->normal[2] <= -least_cosine)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the ribbon of curve %d points out of the hole at (%g, %g, %g)", number,
                        at.x, at.y, at.z);
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "the tangent plane of the ribbon of curve %d stands at %.3g degrees on the "
                    "mean plane of the hole at (%g, %g, %g): a sheet follows up to %.3g",
                    number, bat_acos(fabs(place->normal[2])) * DEGREES, at.x, at.y, at.z,
                    bat_acos(least_cosine) * DEGREES);
}

/* Across the side, into the hole, the slope of its planes. */
static batten_status ask_plane(const side_place *place, double h, bat_sheet_conditions *out)
{
    const double *t = place->curve[1], *n = place->normal;
    const double speed = bat_norm(2, t);
    bat_sheet_condition c = {.at = {place->curve[0][0], place->curve[0][1]},
                             .along = {-t[1] / speed, t[0] / speed},
                             .order = 1,
                             .weight = place->share * h * h};
    c.value = -(n[0] * c.along[0] + n[1] * c.along[1]) / n[2];
    return add_asked(out, &c);
}

/* The normal curvature of the ribbon across the side. */
static batten_status ask_curvature(const side_place *place, double h, bat_sheet_conditions *out)
{
    const batten_vec3 across =
        bat_vec3_cross(bat_vec3_of(3, place->normal), bat_vec3_of(3, place->curve[1]));
    const double size = bat_vec3_norm(across);
    const double w[3] = {across.x / size, across.y / size, across.z / size};
    bat_sheet_condition c = {.at = {place->curve[0][0], place->curve[0][1]},
                             .along = {w[0], w[1]},
                             .order = 2,
                             .weight = place->share * h * h * h * h};
    /* z_ww over sqrt(1 + z_x^2 + z_y^2), which is one over the normal's z */
    c.value = bat_fill_curvature(&place->ribbon, w, place->normal) / place->normal[2];
    return add_asked(out, &c);
}

static batten_status ask_at(const bat_sheet_outline *outline, int i, bool curvature, double h,
                            side_place *place, bat_sheet_conditions *out)
{
    const double *point = place->curve[0];
    const bat_sheet_condition position = {
        .at = {point[0], point[1]}, .value = point[2], .weight = place->share};
    batten_status status = check_rise(outline, i, place);
    if (status == BATTEN_OK)
        status = add_asked(out, &position);
    if (status != BATTEN_OK || !place->ribbon.regular)
        return status;
    status = see_planes(outline, i, place);
    if (status == BATTEN_OK)
        status = ask_plane(place, h, out);
    if (status == BATTEN_OK && curvature && place->ribbon.bent)
        status = ask_curvature(place, h, out);
    return status;
}

/* How many places one span needs so that none are wider apart than `step` in the plane. */
static batten_status places_for(const batten_curve *curve, double a, double b, double step,
                                int *out)
{
    enum { CHORDS = 8, LEAST = 6, MOST = 10000 };
    double length = 0, last[3], next[3];
    batten_status status = batten_curve_evaluate(curve, a, 0, last);
    for (int k = 1; status == BATTEN_OK && k <= CHORDS; k++) {
        const double s = (double)k / CHORDS;
        status = batten_curve_evaluate(curve, (1 - s) * a + s * b, 0, next);
        if (status == BATTEN_OK)
            length += bat_distance(batten_curve_dimension(curve), last, next);
        memcpy(last, next, sizeof last);
    }
    *out = bat_max_int(LEAST, (int)bat_min(MOST, ceil(length / step)));
    return status;
}

static batten_status ask_span(const bat_sheet_outline *outline, int i, const double ends[2],
                              bool curvature, double h, bat_sheet_conditions *out)
{
    int count = 0;
    const bat_fill_side *side = &outline->sides[i];
    batten_status status = places_for(outline->plane[i], ends[0], ends[1], h / 3, &count);
    for (int k = 0; status == BATTEN_OK && k <= count; k++) {
        const double s = (double)k / count, t = (1 - s) * ends[0] + s * ends[1];
        const batten_side from = k == 0 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT;
        side_place place = {.share = 1};
        status = bat_fill_see_ribbon(side, t, from, &place.ribbon);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate_side(side->curve, t, from, 1, place.curve[0]);
        if (status == BATTEN_OK) {
            const double step = bat_norm(2, place.curve[1]) * (ends[1] - ends[0]) / count;
            place.share = bat_max(step / h, 1e-3);
            if (outline->reversed[i]) /* C' round the loop */
                for (int c = 0; c < 3; c++)
                    place.curve[1][c] = -place.curve[1][c];
            status = ask_at(outline, i, curvature, h, &place, out);
        }
    }
    return status;
}

static batten_status ask_side(const bat_sheet_outline *outline, int i, bool curvature, double h,
                              bat_sheet_conditions *out)
{
    const batten_curve *curve = outline->sides[i].curve;
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (knots)
        batten_curve_spans(curve, knots);
    for (int k = 0; status == BATTEN_OK && k < count - 1; k++)
        status = ask_span(outline, i, knots + k, curvature, h, out);
    bat_release(knots);
    return status;
}

/* ---- inside ---- */

static batten_status ask_inside(const bat_sheet_outline *outline, const double point[3],
                                const char *what, int number, double share,
                                bat_sheet_conditions *out)
{
    const batten_vec3 p =
        batten_affine_apply(bat_sheet_to_frame(outline), bat_vec3_of(3, point));
    const bat_sheet_condition c = {.at = {p.x, p.y}, .value = p.z, .weight = share};
    const bool in_box = p.x > outline->low[0] && p.x < outline->high[0] &&
                        p.y > outline->low[1] && p.y < outline->high[1];
    if (!in_box || !bat_sheet_is_inside(outline, c.at))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "%s %d lies beyond the sides of the hole at (%g, %g, %g): what a fill "
                        "goes through lies within them",
                        what, number, point[0], point[1], point[2]);
    return add_asked(out, &c);
}

static batten_status ask_inner_curve(const bat_sheet_outline *outline,
                                     const batten_curve *curve, int number, double h,
                                     bat_sheet_conditions *out)
{
    const int spans = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)spans, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (knots)
        batten_curve_spans(curve, knots);
    for (int s = 0; status == BATTEN_OK && s < spans - 1; s++) {
        int count = 0;
        status = places_for(curve, knots[s], knots[s + 1], h * outline->size / 3, &count);
        for (int k = 0; status == BATTEN_OK && k <= count; k++) {
            const double part = (double)k / count;
            double point[3];
            status = batten_curve_evaluate(curve, (1 - part) * knots[s] + part * knots[s + 1],
                                           0, point);
            if (status == BATTEN_OK)
                status = ask_inside(outline, point, "inner curve", number, 1, out);
        }
    }
    bat_release(knots);
    return status;
}

batten_status bat_sheet_ask(const bat_sheet_outline *outline, const bat_sheet_inside *inside,
                            bool curvature, double h, bat_sheet_conditions *out)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < outline->count; i++)
        status = ask_side(outline, i, curvature, h, out);
    for (int i = 0; status == BATTEN_OK && i < inside->points.count; i++)
        status = ask_inside(outline, inside->points.at + 3 * (size_t)i, "inner point", i + 1, 1,
                            out);
    for (int i = 0; status == BATTEN_OK && i < inside->curves.count; i++)
        status = ask_inner_curve(outline, inside->curves.at[i], i + 1, h, out);
    return status;
}
