/* The feature 'implicit': the whole algebraic curves that the spans of plane curves belong
 * to. */
#include "design/shared/rows.h"

#include <batten/contours.h>
#include <batten/measure.h>
#include <batten/standard.h>
#include <stdio.h>

static const batten_parameter parameters[] = {
    {"implicit", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "plane curves, each span of degree 8 at most"},
    {"beyond", BATTEN_VALUE_NUMBER, false, false, "0.5", NULL,
     "how far around the curve to look, as a share of its size"},
    {"cells", BATTEN_VALUE_COUNT, false, false, "120", NULL, "of the grid in either direction"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how accurate the polylines are; the tolerance of the design by default"},
};

/* Where a point of the plane lies in space. */
typedef struct {
    int axis;  /* across the plane */
    double at; /* the coordinate along it */
} plane;

static void lift(const plane *p, double x, double y, double *out)
{
    const double flat[2] = {x, y};
    for (int k = 0, j = 0; k < 3; k++)
        out[k] = k == p->axis ? p->at : flat[j++];
}

static batten_status put_line(bat_run *run, const batten_object *like, const plane *p,
                              const batten_polyline *line)
{
    batten_curve *curve = NULL;
    if (line->count < 2)
        return BATTEN_OK; /* it only cuts off a corner of the window */
    double *points = bat_array3((size_t)line->count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < line->count; i++)
        lift(p, line->points[3 * i], line->points[3 * i + 1], points + 3 * (size_t)i);
    batten_status status =
        batten_curve_polyline((batten_points){3, line->count, points}, &curve);
    status = bat_put_curve_like(run, status, curve, like, false);
    bat_release(points);
    return status;
}

static batten_status put_singular(bat_run *run, const batten_object *object, const plane *p,
                                  const batten_trace *trace)
{
    char name[220];
    if (trace->singular_count == 0)
        return BATTEN_OK;
    double *points = bat_array3((size_t)trace->singular_count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < trace->singular_count; i++)
        lift(p, trace->singular[i].x, trace->singular[i].y, points + 3 * (size_t)i);
    snprintf(name, sizeof name, "singular points of %.190s", object->name);
    const batten_object made = {.name = name,
                                .layer = object->layer,
                                .kind = BATTEN_OBJECT_POINTS,
                                .point_count = trace->singular_count,
                                .points = points};
    const batten_status status = bat_add(run, &made);
    bat_release(points);
    return status;
}

static batten_status put_trace(bat_run *run, const batten_object *object, const plane *p,
                               const batten_trace *trace)
{
    batten_object like = *object;
    char name[220];
    snprintf(name, sizeof name, "equation of %.200s", object->name);
    like.name = name;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < trace->lines.count && status == BATTEN_OK; i++)
        status = put_line(run, &like, p, &trace->lines.lines[i]);
    return status == BATTEN_OK ? put_singular(run, object, p, trace) : status;
}

static batten_box window_of(const bat_run *run, const batten_curve *flat)
{
    batten_box box = batten_curve_box(flat);
    const double x = box.high.x - box.low.x, y = box.high.y - box.low.y;
    const double more = bat_number(run, "beyond") * bat_max(x, y);
    box.low.x -= more;
    box.low.y -= more;
    box.high.x += more;
    box.high.y += more;
    return box;
}

/* One span of a curve in the plane. */
static batten_status trace_span(bat_run *run, const batten_object *object, const plane *p,
                                const batten_curve *flat, const batten_box *window)
{
    batten_implicit *implicit = NULL;
    batten_implicit_from_curve_report report;
    batten_trace trace = {{0, NULL}, 0, NULL};
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = batten_implicit_from_curve(flat, &report, &implicit);
    if (status == BATTEN_OK)
        status =
            batten_implicit_trace(implicit, *window, bat_count(run, "cells"), within, &trace);
    if (status == BATTEN_OK) {
        bat_report_error(run, report.error, report.error);
        status = put_trace(run, object, p, &trace);
    }
    batten_trace_release(&trace);
    batten_implicit_free(implicit);
    return status;
}

static batten_status trace_spans(bat_run *run, const batten_object *object, const plane *p,
                                 const batten_curve *flat)
{
    batten_parameters at = {0, NULL};
    const batten_box window = window_of(run, flat);
    batten_status status = batten_curve_divide_pieces(flat, BATTEN_PIECES_SPANS, NULL, &at);
    for (int i = 0; status == BATTEN_OK && i + 1 < at.count; i++) {
        batten_curve *part = NULL;
        status = batten_curve_subrange(flat, at.at[i], at.at[i + 1], &part);
        if (status == BATTEN_OK)
            status = trace_span(run, object, p, part, &window);
        batten_curve_unref(part);
    }
    bat_release(at.at);
    return status;
}

static batten_status trace_object(bat_run *run, const batten_object *object)
{
    batten_curve *flat = NULL;
    plane p = {2, 0};
    batten_status status = batten_curve_flatten(object->curve, &p.axis, &flat);
    if (status == BATTEN_OK && p.axis >= 0)
        p.at = batten_curve_points(object->curve)[p.axis];
    if (p.axis < 0)
        p.axis = 2;
    if (status == BATTEN_OK && batten_curve_dimension(flat) != 2)
        status = bat_fail(BATTEN_NOT_COMPATIBLE, "the curve lies in no plane x, y or z = "
                                                 "constant");
    if (status == BATTEN_OK)
        status = trace_spans(run, object, &p, flat);
    batten_curve_unref(flat);
    return status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY
               ? status
               : bat_fail(status, "%s: %s", object->name, batten_message());
}

static batten_status run_implicit(bat_run *run)
{
    return bat_for_objects(run, "implicit", BAT_CURVES, trace_object);
}

const bat_feature bat_feature_implicit = {
    .shown =
        {"implicit", "The whole algebraic curves that the spans of plane curves belong to",
         "Each span satisfies an equation f(x, y) = 0 of its degree, a determinant; it is traced\n"
         "on a grid around the curve, as far 'beyond' it as is asked. The polylines are accurate\n"
         "to 'within'; points at which f and its gradient vanish (crossings, cusps, isolated\n"
         "points) come with them. The error is how far f, scaled to a distance, is from 0 on the\n"
         "span. Branches smaller than a cell can be missed. Degrees above 8, and spans that are\n"
         "traced more than once, are refused.",
         "features:\n"
         "  legs: {points: [[0, 0], [3 m, 2 m], [-1 m, 2 m], [2 m, 0]]}\n"
         "  loop: {bezier: legs}\n"
         "  whole: {implicit: loop}\n",
         "[SAG84] [BG04]", "batten_implicit_from_curve", BAT_PARAMETERS(parameters), false,
         .also = "implicit equation, implicitization, algebraic curve, resultant, Bezout"},
    .run = run_implicit};
