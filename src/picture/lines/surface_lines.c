/* Line drawings of surfaces on a sheet: one view, three views, or a stereo pair. */
#include "picture/lines/surface_looks.h"
#include "picture/lines/wires.h"
#include "picture/sheet/axes.h"
#include "picture/sheet/flat.h"

#include <stdio.h>
#include <string.h>

/* ---- lines ---- */

static const bat_colour contour_colour = {0.66, 0.30, 0.04};

/* Each fifth contour is stronger, as on maps. */
static bool is_fifth(const bat_looks_drawing *d, const bat_wire *wire)
{
    return wire->kind == BAT_WIRE_CONTOUR &&
           fmod(fabs(round(wire->value / d->wires.level_step)), 5) < 0.5;
}

static bat_pen pen_of(const bat_looks_drawing *d, const bat_wire *wire)
{
    static const double widths[BAT_WIRE_KINDS] = {0.5, 0.9, 1.4, 1.4, 1.8};
    const batten_object *object = batten_model_object(d->wires.model, wire->object);
    bat_pen pen = {{0.13, 0.17, 0.24}, widths[wire->kind], BAT_SOLID};
    /* Colours of faces are often too pale for lines. */
    const double share = object->kind == BATTEN_OBJECT_MESH ? 0.5 : 1;
    if (object->has_colour)
        pen.colour = (bat_colour){share * object->colour[0], share * object->colour[1],
                                  share * object->colour[2]};
    if (wire->kind == BAT_WIRE_CONTOUR) {
        pen.colour = contour_colour;
        pen.width *= is_fifth(d, wire) ? 1.7 : 1;
    }
    return pen;
}

/* The value of a contour at its longest visible run, where there is room. */
static void write_label(bat_canvas *canvas, const bat_wire *wire, const bat_runs *runs)
{
    const bat_run *longest = NULL;
    double most = 6 * canvas->em;
    for (size_t i = 0; i < runs->count; i++) {
        double length = 0;
        for (size_t k = 1; k < runs->runs[i].count; k++)
            length += bat_hypot(runs->runs[i].xy[2 * k] - runs->runs[i].xy[2 * k - 2],
                                runs->runs[i].xy[2 * k + 1] - runs->runs[i].xy[2 * k - 1]);
        if (!runs->runs[i].hidden && length > most) {
            most = length;
            longest = &runs->runs[i];
        }
    }
    if (!longest)
        return;
    char text[BATTEN_NUMBER_SIZE];
    bat_digits_text(wire->value, 6, text);
    double at[BAT_NAME_PLACES][2];
    for (size_t k = 0; k < BAT_NAME_PLACES; k++)
        memcpy(at[k], longest->xy + 2 * ((longest->count - 1) * k / BAT_NAME_PLACES),
               sizeof at[k]);
    bat_canvas_name(canvas, (bat_lettering){contour_colour, 0.75 * canvas->em, false},
                    BAT_NAME_PLACES, at[0], text);
}

typedef enum { HIDDEN, VISIBLE, LABELS_OF_FIFTHS, OTHER_LABELS } layer;

static void draw_runs(bat_canvas *canvas, const bat_looks_drawing *d, const bat_wire *wire,
                      const bat_runs *runs, layer which)
{
    bat_pen pen = pen_of(d, wire);
    if (which >= LABELS_OF_FIFTHS) {
        if (is_fifth(d, wire) == (which == LABELS_OF_FIFTHS))
            write_label(canvas, wire, runs);
        return;
    }
    if (which == HIDDEN)
        pen = (bat_pen){pen.colour, 0.6 * pen.width, BAT_DASHED};
    for (size_t i = 0; i < runs->count; i++)
        if (runs->runs[i].hidden == (which == HIDDEN))
            bat_canvas_line(canvas, pen, runs->runs[i].count, runs->runs[i].xy);
}

static void to_sheet(const bat_look *l, const double *point, double out[3])
{
    double q[3];
    bat_eye_project(&l->eye, point, q);
    out[0] = bat_plot_x(&l->plot, q[0]);
    out[1] = bat_plot_y(&l->plot, q[1]);
    out[2] = l->plot.scale * q[2];
}

/* A line on the sheet, cut where it vanishes. The chords of a silhouette lie inside the outline
 * of its surface, which would hide them: so it is probed a little outside. */
static batten_status cut_wire(const bat_look *l, const bat_facets *facets, const bat_wire *wire,
                              bat_runs *out)
{
    const double outside = 0.4; /* points; chords are within a tenth */
    const size_t count = wire->stroke.count;
    double *points = bat_array3(count, 6, sizeof *points), *probes = points;
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    if (wire->away)
        probes = points + 3 * count;
    for (size_t i = 0; i < count; i++) {
        const double *p = wire->stroke.points + 3 * i;
        to_sheet(l, p, points + 3 * i);
        if (!wire->away)
            continue;
        const double *n = wire->away + 3 * i, step = outside / l->plot.scale;
        to_sheet(l, (double[3]){p[0] + step * n[0], p[1] + step * n[1], p[2] + step * n[2]},
                 probes + 3 * i);
    }
    const batten_status status = bat_runs_cut(facets, count, points, probes, 1, out);
    bat_release(points);
    return status;
}

/* Points of the model, as crosses. */
static void draw_points(bat_canvas *canvas, const bat_looks_drawing *d, const bat_look *l)
{
    for (int i = 0; i < batten_model_count(d->wires.model); i++) {
        const batten_object *object = batten_model_object(d->wires.model, i);
        if (object->kind != BATTEN_OBJECT_POINTS)
            continue;
        for (int k = 0; k < object->point_count; k++) {
            double q[3];
            bat_eye_project(&l->eye, object->points + 3 * (size_t)k, q);
            bat_canvas_cross(canvas, (bat_pen){bat_ink, 1, BAT_SOLID},
                             bat_plot_x(&l->plot, q[0]), bat_plot_y(&l->plot, q[1]),
                             BAT_CROSS * canvas->em);
        }
    }
}

static void draw_layer(bat_canvas *canvas, const bat_looks_drawing *d, const bat_runs *runs,
                       layer which)
{
    for (int kind = 0; kind < BAT_WIRE_KINDS; kind++)
        for (size_t i = 0; i < d->wires.count; i++) {
            const bat_wire *wire = &d->wires.wires[i];
            if ((int)wire->kind == kind &&
                (which < LABELS_OF_FIFTHS || kind == BAT_WIRE_CONTOUR))
                draw_runs(canvas, d, wire, &runs[i], which);
        }
}

static batten_status draw_wires(bat_canvas *canvas, const bat_looks_drawing *d,
                                const bat_look *l, const bat_facets *facets)
{
    bat_runs *runs = bat_array(d->wires.count, sizeof *runs);
    batten_status status = runs ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < d->wires.count && status == BATTEN_OK; i++)
        status = cut_wire(l, facets, &d->wires.wires[i], &runs[i]);
    if (status == BATTEN_OK) {
        if (d->options->hidden == BATTEN_HIDDEN_DASHED)
            draw_layer(canvas, d, runs, HIDDEN);
        draw_layer(canvas, d, runs, VISIBLE);
        draw_layer(canvas, d, runs, LABELS_OF_FIFTHS);
        draw_layer(canvas, d, runs, OTHER_LABELS);
    }
    for (size_t i = 0; runs && i < d->wires.count; i++)
        bat_runs_free(&runs[i]);
    bat_release(runs);
    return status;
}

static batten_status draw_look(bat_canvas *canvas, bat_looks_drawing *d, bat_look *l)
{
    bat_facets facets = {0};
    const bat_plot *p = &l->plot;
    batten_status status = bat_wires_add_silhouettes(&d->wires, &l->eye);
    if (status == BATTEN_OK && d->options->hidden != BATTEN_HIDDEN_SHOWN)
        status = bat_wires_facets(&d->wires, &l->eye, p->scale, bat_plot_x(p, 0),
                                  bat_plot_y(p, 0), &facets);
    if (status == BATTEN_OK)
        status = draw_wires(canvas, d, l, &facets);
    bat_facets_free(&facets);
    draw_points(canvas, d, l);
    return status;
}

/* ---- what stands around ---- */

static const char *unit_of(const bat_looks_drawing *d)
{
    const char *unit = batten_unit_name(batten_model_unit_metres(d->wires.model));
    return unit ? unit : "units";
}

/* What the contours show and how far they are apart. */
static void write_contours(bat_canvas *canvas, const bat_looks_drawing *d)
{
    static const struct {
        const char *name;
        int power; /* of the unit */
        bool angle;
    } fields[] = {[BATTEN_FIELD_HEIGHT] = {"height", 1, false},
                  [BATTEN_FIELD_GAUSSIAN] = {"Gaussian curvature", -2, false},
                  [BATTEN_FIELD_MEAN] = {"mean curvature", -1, false},
                  [BATTEN_FIELD_KAPPA1] = {"larger principal curvature", -1, false},
                  [BATTEN_FIELD_KAPPA2] = {"smaller principal curvature", -1, false},
                  [BATTEN_FIELD_ISOPHOTE] = {"light n \u00b7 l", 0, false},
                  [BATTEN_FIELD_DRAFT] = {"draft angle", 0, true},
                  [BATTEN_FIELD_HIGHLIGHT] = {"highlight lines", 1, false},
                  [BATTEN_FIELD_REFLECTION] = {"reflection lines", 1, false},
                  [BATTEN_FIELD_SILHOUETTE] = {"outline", 0, false},
                  [BATTEN_FIELD_ABSOLUTE] = {"absolute curvature", -1, false},
                  [BATTEN_FIELD_ZEBRA] = {"zebra stripes", 0, false}};
    static const char *const before[] = {"1/", "1/", "", ""};
    if (!(d->wires.level_step > 0))
        return;
    char number[BATTEN_NUMBER_SIZE], text[160];
    const int power = fields[d->options->contour_field.kind].power;
    bat_digits_text(d->wires.level_step, 4, number);
    snprintf(text, sizeof text, "contours of %s, %s%s%s%s%s apart",
             fields[d->options->contour_field.kind].name, number,
             power == 0 ? fields[d->options->contour_field.kind].angle ? " rad" : "" : " ",
             before[power + 2], power == 0 ? "" : unit_of(d), power == -2 ? "\u00b2" : "");
    bat_canvas_text(canvas, contour_colour, 0.85 * d->em, BAT_MIDDLE, 0.5 * canvas->width,
                    canvas->height - 1.5 * d->em, text);
}

static void write_around(bat_canvas *canvas, const bat_looks_drawing *d)
{
    bat_canvas_bold(canvas, bat_ink, 1.25 * d->em, BAT_MIDDLE, 0.5 * canvas->width, 1.7 * d->em,
                    d->options->title);
    write_contours(canvas, d);
    for (int i = 0; i < d->look_count; i++) {
        const bat_look *l = &d->looks[i];
        const bat_rectangle f = l->plot.frame;
        bat_canvas_text(canvas, bat_grey, 0.85 * d->em, BAT_MIDDLE, f.x + 0.5 * f.width,
                        f.y - 0.6 * d->em, l->title);
        if (l->kind == BATTEN_VIEW_AXONOMETRIC || l->kind == BATTEN_VIEW_ISOMETRIC)
            bat_axes_draw(canvas, &l->plot, &l->eye.view, l->kind, unit_of(d));
    }
}

static batten_status make_sheet(bat_looks_drawing *d, char **data, size_t *size)
{
    const batten_draw_options *o = d->options;
    bat_canvas canvas;
    batten_status status =
        bat_canvas_begin(o->format, o->width, d->height, d->em, o->title, &canvas);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < d->look_count && status == BATTEN_OK; i++)
        status = draw_look(&canvas, d, &d->looks[i]);
    if (status == BATTEN_OK) {
        write_around(&canvas, d);
        return bat_canvas_finish(&canvas, data, size);
    }
    bat_canvas_end(&canvas);
    return status;
}

/* ---- the whole ---- */

static batten_status check_options(const batten_draw_options *o)
{
    if (o->isolines < 1 || o->isolines > 1000)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d isolines are asked for; from 1 to 1000 are drawn", o->isolines);
    if (!isfinite(o->azimuth) || !isfinite(o->elevation) || !isfinite(o->stereo_angle))
        return bat_fail(BATTEN_NOT_FINITE,
                        "azimuth %g, elevation %g and stereo angle %g must be finite",
                        o->azimuth, o->elevation, o->stereo_angle);
    if (!(o->contour_spacing >= 0) || !isfinite(o->contour_spacing))
        return bat_fail(BATTEN_BAD_ARGUMENT, "contours cannot be %g apart", o->contour_spacing);
    if (!(o->distance >= 0) || !isfinite(o->distance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the eye cannot be %g away", o->distance);
    return bat_size_check(o);
}

static batten_status prepare(bat_looks_drawing *d)
{
    batten_status status = bat_wires_measure(&d->wires);
    if (status != BATTEN_OK)
        return status;
    bat_looks_choose(d);
    for (int i = 0; i < d->look_count && status == BATTEN_OK; i++)
        status = bat_look_measure(d, &d->looks[i]);
    if (status != BATTEN_OK)
        return status;
    /* The box is larger than what is in it, at most by the half: so the final scale is. */
    bat_looks_place(d);
    double scale = 0;
    for (int i = 0; i < d->look_count; i++)
        scale = bat_max(scale, 1.5 * d->looks[i].plot.scale);
    if (!(scale > 0) || !isfinite(scale) || !isfinite(0.25 / scale))
        return bat_fail(BATTEN_OVERFLOW, "a model of size %g cannot be drawn at scale %g",
                        d->wires.size, scale);
    status = bat_wires_gather(&d->wires, scale);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < d->look_count; i++) {
        status = bat_wires_add_silhouettes(&d->wires, &d->looks[i].eye);
        if (status != BATTEN_OK)
            return status;
        bat_looks_measure_lines(d, &d->looks[i]);
    }
    bat_looks_place(d);
    return BATTEN_OK;
}

batten_status batten_draw_surface_lines(const batten_model *model,
                                        const batten_draw_options *options,
                                        const batten_job *job, char **data, size_t *size)
{
    batten_draw_options chosen = batten_draw_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_draw_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    bat_looks_drawing d = {.options = options,
                           .wires = {.options = options, .job = job},
                           .em = bat_size_em(options)};
    batten_model *flat = NULL, *patches = NULL; /* triangles as surfaces with a pole */
    status = check_options(options);
    if (status == BATTEN_OK)
        status = bat_picture_model(model, options, job, &flat);
    if (status == BATTEN_OK)
        status = batten_model_with_patches(flat, BATTEN_PATCHES_POLE, &patches);
    d.wires.model = patches;
    if (status == BATTEN_OK)
        status = prepare(&d);
    if (status == BATTEN_OK)
        status = make_sheet(&d, data, size);
    bat_wires_free(&d.wires);
    batten_model_unref(patches);
    batten_model_unref(flat);
    return status;
}
