/* Aerofoil sections in one form: chord, trailing edge, thickness, and points placed anew. */
#include "shape/aerofoil/aerofoil.h"
#include "base/elementary.h"
#include "numeric/vector.h"

#include <batten/interpolate.h>
#include <batten/measure.h>
#include <batten/nearest.h>

enum { LEAST_PANELS = 8, MOST_PANELS = 10000, DEFAULT_PANELS = 160 };

batten_curve_aerofoil_options batten_curve_aerofoil_defaults(void)
{
    return (batten_curve_aerofoil_options){.size = sizeof(batten_curve_aerofoil_options),
                                           .trailing_edge = -1,
                                           .blend = 1,
                                           .panels = DEFAULT_PANELS};
}

static batten_status check_options(const batten_curve_aerofoil_options *o)
{
    if (!(o->chord >= 0) || !isfinite(o->chord))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the chord is %g; it must be 0 or more", o->chord);
    if (!(o->trailing_edge <= 0.5))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the trailing edge is %g of the chord; it must be from 0 to 0.5",
                        o->trailing_edge);
    if (!(o->thickness >= 0 && o->thickness <= 1))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the thickness is %g of the chord; it must be from 0 to 1",
                        o->thickness);
    if (!(o->blend > 0 && o->blend <= 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the blend is %g; it must be above 0 and up to 1",
                        o->blend);
    if (o->panels < LEAST_PANELS || o->panels > MOST_PANELS || o->panels % 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the number of panels is %d; it must be even, from %d to %d", o->panels,
                        LEAST_PANELS, MOST_PANELS);
    return BATTEN_OK;
}

typedef struct {
    const batten_curve_aerofoil_options *options;
    batten_curve_aerofoil_report report;
    bat_aerofoil_row row;
    batten_curve *spline, *made;
    bat_aerofoil_sides sides;
    bat_aerofoil_change change;
    double size;                  /* the chord of the result */
    double *places, *at, *points; /* [panels + 1], [panels + 1], [panels + 1][2] */
} section;

/* ---- panels ---- */

/* Parameters of the result: each side from tail to nose by a cosine. */
static void place_parameters(int panels, double *places)
{
    for (int i = 0; i <= panels / 2; i++) {
        const double part = (1 - bat_cos(2 * BAT_PI * i / panels)) / 4;
        places[i] = part;
        places[panels - i] = 1 - part;
    }
    places[panels / 2] = 0.5;
}

/*
 * Arc lengths grow with them as a parabola that has the nose at 1/2, so that the same parameters
 * suit sides of different lengths without a step of speed at the nose.
 */
static batten_status place_panels(section *s)
{
    /* Parts of the chord: lengths to rounding, places to what moves no digit of a file. */
    const double length_tolerance = 1e-12, place_tolerance = 1e-9;
    const int count = s->options->panels + 1;
    double length = 0, nose = 0;
    batten_status status = batten_curve_length(s->spline, length_tolerance, NULL, &length);
    if (status == BATTEN_OK)
        status = batten_curve_length_between(s->spline, s->sides.start, s->sides.nose,
                                             length_tolerance, NULL, &nose);
    const double lean = 4 * (nose / length - 0.5);
    place_parameters(s->options->panels, s->places);
    for (int i = 0; i < count; i++) {
        const double u = s->places[i];
        s->points[i] = length * (u + lean * u * (1 - u));
    }
    if (status == BATTEN_OK)
        status = batten_curve_at_length(s->spline, count, s->points, place_tolerance, s->at);
    s->at[0] = s->sides.start;
    s->at[count / 2] = s->sides.nose;
    s->at[count - 1] = s->sides.end;
    return status;
}

/* The ends as they were asked for, bit for bit, so that a closed section is closed. */
static void set_ends(section *s)
{
    const int last = s->options->panels;
    if (!s->change.is_asked)
        return;
    const double half = s->size * s->change.edge / 2;
    s->points[0] = s->points[2 * last] = s->size;
    s->points[1] = half;
    s->points[2 * last + 1] = half > 0 ? -half : 0;
}

static batten_status make_curve(section *s)
{
    const int count = s->options->panels + 1;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = s->places;
    batten_status status = place_panels(s);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        double *to = s->points + 2 * (size_t)i;
        status = bat_aerofoil_move(&s->change, s->at[i], to);
        to[0] *= s->size;
        to[1] *= s->size;
    }
    set_ends(s);
    if (status == BATTEN_OK)
        status = batten_curve_interpolate((batten_points){2, count, s->points}, &options, NULL,
                                          &s->made);
    return status;
}

/* ---- change ---- */

static batten_status find_change(section *s)
{
    const batten_curve_aerofoil_options *o = s->options;
    bat_aerofoil_change *c = &s->change;
    batten_status status = bat_aerofoil_measure(&s->sides, &s->report.given);
    c->sides = &s->sides;
    c->is_asked = o->trailing_edge >= 0 || o->thickness > 0;
    c->given_edge = s->report.given.trailing_edge;
    c->edge = o->trailing_edge >= 0 ? o->trailing_edge : c->given_edge;
    c->factor = 1;
    c->blend = o->blend;
    s->size = o->chord > 0 ? o->chord : s->report.given.chord;
    if (status == BATTEN_OK && o->thickness > 0)
        status = bat_aerofoil_set_thickness(c, o->thickness);
    return status;
}

/* ---- report ---- */

/* The given points, moved as asked, against the curve. */
static batten_status measure_distance(section *s)
{
    const int count = s->row.count;
    batten_deviation deviation = {0};
    double(*moved)[2] = bat_array((size_t)count, sizeof *moved);
    batten_status status = moved ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        status = bat_aerofoil_move(&s->change, s->row.at[i], moved[i]);
        s->report.moved =
            bat_max(s->report.moved, s->size * bat_distance(2, moved[i], s->row.points[i]));
        moved[i][0] *= s->size;
        moved[i][1] *= s->size;
    }
    if (status == BATTEN_OK)
        status = batten_curve_deviation(s->made, (batten_points){2, count, moved[0]}, NULL,
                                        NULL, NULL, &deviation);
    bat_release(moved);
    if (status == BATTEN_OK) {
        s->report.distance = deviation.max;
        s->report.rms = deviation.rms;
        s->report.worst = s->row.index[deviation.worst];
    }
    return status;
}

/* The delivered curve at a chord of 1. */
static batten_status measure_made(section *s)
{
    batten_curve *unit = NULL;
    bat_aerofoil_sides sides = {.end = 1};
    batten_aerofoil_shape *made = &s->report.made;
    const batten_affine map = batten_affine_scaling(1 / s->size, 1 / s->size, 1);
    double nose = 0, ends[2][2];
    batten_status status = bat_aerofoil_nose(s->made, &sides.nose, &made->chord);
    if (status == BATTEN_OK)
        status = batten_curve_transform(s->made, &map, &unit);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        status = batten_curve_evaluate(unit, k, 0, ends[k]);
        sides.reach[k] = ends[k][0];
    }
    sides.curve = unit;
    if (status == BATTEN_OK)
        status = bat_aerofoil_measure(&sides, made);
    if (status == BATTEN_OK)
        made->trailing_edge = ends[0][1] - ends[1][1];
    /* A tail that is thicker than the nose at a fiftieth of the chord, beside its edge. */
    for (int side = 0; side < 2 && status == BATTEN_OK; side++) {
        double head = 0, tail = 0;
        status = bat_aerofoil_height(&sides, side, 0.02, &head);
        if (status == BATTEN_OK)
            status = bat_aerofoil_height(&sides, side, 0.98, &tail);
        nose += (side ? -1 : 1) * (tail - head);
    }
    s->report.round_tail = nose > made->trailing_edge;
    batten_curve_unref(unit);
    return status;
}

static batten_status find_crossings(section *s)
{
    batten_parameters crossings = {0};
    double at[2];
    batten_status status = batten_curve_self_crossings(s->made, &crossings);
    s->report.crossings = status == BATTEN_OK ? crossings.count / 2 : 0;
    if (s->report.crossings > 0) {
        status = batten_curve_evaluate(s->made, crossings.at[0], 0, at);
        s->report.crossing = at[0] / s->size;
    }
    batten_release(crossings.at);
    return status;
}

static batten_status make_section(section *s, batten_points points)
{
    const size_t count = (size_t)s->options->panels + 1;
    s->places = bat_array(count, sizeof *s->places);
    s->at = bat_array(count, sizeof *s->at);
    s->points = bat_array3(count, 2, sizeof *s->points);
    batten_status status = s->places && s->at && s->points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_aerofoil_take(points, &s->row, &s->report);
    if (status == BATTEN_OK)
        status = bat_aerofoil_normalise(&s->row, &s->spline, &s->sides, &s->report);
    if (status == BATTEN_OK)
        status = find_change(s);
    if (status == BATTEN_OK)
        status = make_curve(s);
    if (status == BATTEN_OK)
        status = measure_distance(s);
    if (status == BATTEN_OK)
        status = measure_made(s);
    return status == BATTEN_OK ? find_crossings(s) : status;
}

batten_status batten_curve_aerofoil(batten_points points,
                                    const batten_curve_aerofoil_options *options,
                                    batten_curve_aerofoil_report *report, batten_curve **out)
{
    batten_curve_aerofoil_options chosen = batten_curve_aerofoil_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_aerofoil_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_options(&chosen);
    if (status != BATTEN_OK)
        return status;
    section s = {.options = &chosen};
    status = make_section(&s, points);
    if (status == BATTEN_OK) {
        *out = s.made;
        if (report)
            *report = s.report;
    } else {
        batten_curve_unref(s.made);
    }
    bat_aerofoil_row_release(&s.row);
    batten_curve_unref(s.spline);
    bat_release(s.places);
    bat_release(s.at);
    bat_release(s.points);
    return status;
}
